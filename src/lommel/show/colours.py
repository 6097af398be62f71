"""Plots of PSFs in colour."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.measures.psf_like import ColourPSFLike, PSFLike, colours
from lommel.show.drawing import pyplot, stretched

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_MOST = 64  # PSFs of a stack in one figure


def plot(psf: ColourPSFLike, ax: Axes | None = None, *, stretch: str = "sqrt") -> Any:
    """Draw PSFs of three channels in colour, each over its largest value, or those of other channels side by side.

    Parameters
    ----------
    psf : ColourPSF
        Of a stack at most 64 are drawn, in rows of eight.
    ax : matplotlib Axes, optional
        Of a single PSF in three channels. By default those of a new figure.
    stretch : {"sqrt", "linear", "log"}
        Of the levels; "log" goes down to 1e-5 of the largest value.

    Returns
    -------
    matplotlib Axes, or ndarray of them
        One for each of the stack; where there are not three channels, one for each channel.

    Raises
    ------
    ValueError
        If there is no such `stretch`, for a stack of more than 64, or for `ax` where several are drawn.
    ImportError
        If matplotlib is not installed.
    """
    validation.choice("stretch", stretch, ("sqrt", "linear", "log"))
    stack = psf.shape[:-3]
    if len(psf.psfs) == 3:
        pictures = stretched(colours(psf), stretch).reshape(-1, *psf.shape[-2:], 3)
        titles = [", ".join(map(str, index)) for index in np.ndindex(stack)]
    elif not stack:
        top = float(psf.values.max()) or 1.0
        pictures, titles = stretched(np.maximum(psf.values, 0.0) / top, stretch), list(psf.channels.names)
    else:
        raise ValueError(f"a stack takes three channels, got {len(psf.psfs)}; plot a channel, as psf[0].plot()")
    if len(pictures) > _MOST or (ax is not None and len(pictures) > 1):
        most = 1 if ax is not None else _MOST
        raise ValueError(f"at most {most} can be drawn here, got {len(pictures)}; take part(index) of a stack")
    first = psf.psfs[0] if not stack else psf.psfs[0][(0,) * len(stack)]
    columns = min(len(pictures), 8)
    rows = -(-len(pictures) // columns)
    drawn = np.array([ax], dtype=object)
    if ax is None:
        size = (2.4 * columns + 1.0, 2.3 * rows + 0.7)
        drawn = pyplot().subplots(rows, columns, squeeze=False, layout="constrained", figsize=size)[1].ravel()
    for k, (picture, title) in enumerate(zip(pictures, titles, strict=True)):
        _draw(drawn[k], picture, first)
        if k % columns:
            drawn[k].set_ylabel("")
            drawn[k].set_yticklabels([])
        if k + columns < len(pictures):
            drawn[k].set_xlabel("")
            drawn[k].set_xticklabels([])
        if title:
            drawn[k].set_title(title, fontsize=9)
    for spare in drawn[len(pictures) :]:
        spare.set_axis_off()
    found = drawn[: len(pictures)]
    return found[0] if not titles[0] else found.reshape(stack or -1)


def _draw(axes: Any, picture: NDArray[np.float64], psf: PSFLike) -> None:
    factor, unit = (1e6, "µm") if psf.unit == "m" else (1.0, "λN")
    high, half = (0.5 * side * factor for side in psf.grid.pitch)
    x, y = psf.grid.x * factor, psf.grid.y * factor
    extent = (x[0] - half, x[-1] + half, y[-1] + high, y[0] - high)
    grey = {"cmap": "gray", "vmin": 0.0, "vmax": 1.0} if picture.ndim == 2 else {}
    axes.imshow(picture, extent=extent, interpolation="nearest", **grey)
    axes.set_xlabel(f"x ({unit})")
    axes.set_ylabel(f"y ({unit})")
