"""Three sections through a stack of planes: xy, xz and yz, of a microscope, in lengths of its sample."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.measures.answer import Answer
from lommel.optics.objective_pupil import ObjectivePupil
from lommel.show.drawing import HOW, MEANING, STRETCHES, norm_of, pyplot

_LONGEST = 3.0  # how much longer one axis may be than another, at the same scale
_SIDE = 3.4  # inches of the longest axis


class Voxels(NamedTuple):
    """Where the values of a stack are, micrometres: x and y in the sample, z of the stage, which rises."""

    x: Array
    y: Array
    z: Array
    values: NDArray[Any]


def is_z_stack(psf: Answer) -> bool:
    """Return whether a PSF is one stack of a microscope through planes along z, all around one axis."""
    pupil = psf.pupil
    if not isinstance(pupil, ObjectivePupil) or len(pupil.shape) != 1 or pupil.z.size < 2 or psf.grid.stack:
        return False
    steps = np.diff(pupil.z)
    return bool((steps > 0.0).all() or (steps < 0.0).all())


def voxels(psf: Answer) -> Voxels:
    """Return the values of a stack with their places, from the lowest plane to the highest."""
    pupil: Any = psf.pupil
    order = slice(None, None, 1 if pupil.z[-1] > pupil.z[0] else -1)
    size = 1e6 / pupil.magnification
    return Voxels(psf.grid.x * size, psf.grid.y * size, 1e6 * pupil.z[order], np.maximum(psf.values[order], 0.0))


def sections(psf: Answer, *, stretch: str = "sqrt") -> NDArray[Any]:
    """Draw the planes through the brightest voxel of a z stack: xy, and beside and below it yz and xz.

    Parameters
    ----------
    psf : PSF
        A stack of a microscope along one axis whose z rises or falls.
    stretch : {"sqrt", "linear", "log"}

    Returns
    -------
    ndarray of three matplotlib Axes
        xy, xz, yz, all on one scale of brightness and, unless one side is three times as long as another, of lengths.

    Raises
    ------
    ImportError
        If matplotlib is not installed.
    """
    x, y, z, values = voxels(psf)
    plane, row, column = (int(k) for k in np.unravel_index(int(values.argmax()), values.shape))
    lengths = [float(np.ptp(edges)) for edges in map(_edges, (x, y, z))]
    longest = max(lengths)
    wide, high, deep = (max(length, longest / _LONGEST) for length in lengths)
    inch = _SIDE / longest
    figure = pyplot().figure(figsize=(inch * (wide + deep) + 1.9, inch * (high + deep) + 1.3), layout="compressed")
    figure.get_layout_engine().set(w_pad=0.1, h_pad=0.1)
    grid = figure.subplots(2, 2, width_ratios=(wide, deep), height_ratios=(high, deep))
    xy, yz, xz, legend = grid.flat
    norm = norm_of(stretch, float(values.max()) or 1.0)
    aspect = "equal" if longest <= _LONGEST * min(lengths) else "auto"
    for axes, across, up, level, title in (
        (xy, x, y, values[plane], f"xy at z = {z[plane]:.4g} µm"),
        (xz, x, z, values[:, row], f"xz at y = {y[row] + 0.0:.3g} µm"),
        (yz, z, y, values[:, :, column].T, f"yz at x = {x[column] + 0.0:.3g} µm"),
    ):
        mesh = axes.pcolormesh(_edges(across), _edges(up), level, norm=norm, cmap="magma", rasterized=True)
        axes.set_title(title, fontsize=9)
        axes.set_aspect(aspect)
        axes.set_facecolor("black")
    for axes in (xy, yz):
        axes.invert_yaxis()  # rows, from the top
    xy.set_ylabel("y in the sample (µm)")
    xz.set_ylabel("z of the stage (µm)")
    xz.set_xlabel("x in the sample (µm)")
    yz.set_xlabel("z of the stage (µm)")
    legend.set_axis_off()
    yz.set_yticklabels([])
    told = "\n".join(_told(psf, z, aspect, stretch))
    legend.text(0.0, 1.0, told, transform=legend.transAxes, va="top", fontsize=8, linespacing=1.5)
    figure.colorbar(mesh, ax=grid, label=MEANING[psf.normalize])
    return np.array([xy, xz, yz])


def _told(psf: Answer, z: Array, aspect: str, stretch: str) -> list[str]:
    """Return what there is to say of the voxels and of the scales, line by line."""
    steps = np.diff(z)
    even = np.ptp(steps) <= 1e-6 * steps.mean()
    size = 1e6 * psf.grid.side / psf.pupil.magnification  # type: ignore[attr-defined]
    return [
        f"{z.size} planes, {steps.mean():.4g} µm apart" if even else f"{z.size} planes, not evenly spaced",
        f"{psf.shape[-2]} × {psf.shape[-1]} pixels of {size:.4g} µm in the sample,",
        HOW[psf.sampling],
        f"brightness: {STRETCHES[stretch]}",
        *([] if aspect == "equal" else ["z is not to the scale of x and y"]),
    ]


def _edges(at: Array) -> Array:
    """Return where pixels around these places begin and end, as far out as they reach in."""
    if at.size == 1:
        return np.array([at[0] - 0.5, at[0] + 0.5])
    middles = 0.5 * (at[1:] + at[:-1])
    return np.concatenate([[2.0 * at[0] - middles[0]], middles, [2.0 * at[-1] - middles[-1]]])
