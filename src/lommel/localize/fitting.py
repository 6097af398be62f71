"""Maximum likelihood estimates of the positions of molecules, from their images and a table of the PSF."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, fields
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Index, Values
from lommel.core import engine
from lommel.detection.molecules import DEFECT, box_pixels
from lommel.localize.table import Table
from lommel.recorded.counts import counts_of
from lommel.recorded.noise import Noise

STATES = ("converged", "border", "steps", "undetermined")
BACKGROUNDS = ("flat", "tilted")
_SPACING = 1.15  # lateral distance of templates, in v = 2 pi NA r / lambda
_PHASE_STEP = 0.85  # distance of templates along z, radians of the phase that changes fastest
_BLOCK = 20000  # molecules fitted in one call
_MAX_TEMPLATES = 20000


@dataclass(frozen=True, eq=False)
class MoleculeErrors:
    """Standard errors of the attributes of :class:`Molecules` by the Cramer-Rao bound; inf where undetermined."""

    row: Array
    column: Array
    z: Array
    photons: Array
    background: Array

    def __repr__(self) -> str:
        return f"<MoleculeErrors of {len(self.row)} molecules>"


_NAMES = tuple(field.name for field in fields(MoleculeErrors))


@dataclass(frozen=True, eq=False)
class Molecules:
    """Estimates of n molecules, by :func:`lommel.localize.fit`.

    Attributes
    ----------
    row, column : ndarray, shape (n,)
        Position in pixels; 0 is the middle of the first pixel of the box or, with `corners`, of the camera.
    z : ndarray, shape (n,)
        Position of the stage, or depth of the molecule (see `Table.along`), metres.
    photons : ndarray, shape (n,)
        Electrons of the molecule in an infinite window.
    background : ndarray, shape (n,)
        Electrons per pixel, at least 0.01.
    errors : MoleculeErrors
        Standard errors of the above estimates by the Cramer-Rao bound.
    log_likelihood : ndarray, shape (n,)
        Log-likelihood minus the log-likelihood of a model whose mean equals the counts in every pixel.
    discrepancy : ndarray, shape (n,)
        (Pearson's chi2 - its expectation) / (its standard deviation): 0 +- 1 if PSF and noise are correct; large for
        a second molecule in the box, a wrong PSF or a wrong gain.
    state : ndarray of int, shape (n,)
        Index into ``states``.
    steps : ndarray of int, shape (n,)
        Number of steps, sum of all starts.
    states : tuple of str
        "converged"; "border": the estimate is at a limit of the table; "steps": not converged after 50 steps;
        "undetermined": too few pixels, no light or no information.
    """

    row: Array
    column: Array
    z: Array
    photons: Array
    background: Array
    errors: MoleculeErrors
    log_likelihood: Array
    discrepancy: Array
    state: NDArray[np.int32]
    steps: NDArray[np.int32]
    states: ClassVar[tuple[str, ...]] = STATES

    @property
    def converged(self) -> NDArray[np.bool_]:
        """True for molecules whose fit has converged within the table."""
        return np.asarray(self.state == 0)

    def __len__(self) -> int:
        return len(self.row)

    def __getitem__(self, which: Index) -> Molecules:
        """Return a selection of molecules by a slice, a mask or an array of indices."""
        if np.ndim(np.empty(len(self))[which]) != 1:
            raise TypeError(f"which must be a slice, a mask or indices, got {validation.shown(which)}")
        selected: Molecules = _map_arrays(lambda values: values[which], self)
        return selected

    def replaced(self, which: NDArray[np.intp], others: Molecules) -> Molecules:
        """Return a copy with the estimates of some molecules replaced.

        Parameters
        ----------
        which : ndarray of int
            Indices of the molecules to replace.
        others : Molecules
            New estimates, one for each index.

        Returns
        -------
        Molecules
        """
        # In the concatenated arrays, the replacements follow all molecules.
        order = np.arange(len(self))
        order[which] = len(self) + np.arange(len(others))
        result: Molecules = _map_arrays(lambda *parts: np.concatenate(parts)[order], self, others)
        return result

    def __repr__(self) -> str:
        counts = zip(STATES, np.bincount(self.state, minlength=4), strict=True)
        count = ", ".join(f"{n} {name}" for name, n in counts if n)
        return f"<Molecules: {len(self)}{': ' if count else ''}{count}>"


def _map_arrays(function: Callable[..., Any], *items: Any) -> Any:
    """Apply a function to each attribute of one or several Molecules (or MoleculeErrors); return a new object."""
    results = {}
    for name in (field.name for field in fields(items[0])):
        arrays = [getattr(item, name) for item in items]
        results[name] = _map_arrays(function, *arrays) if name == "errors" else function(*arrays)
    return type(items[0])(**results)


def fit(
    table: Table,
    images: ArrayLike,
    *,
    noise: Noise | None = None,
    corners: ArrayLike | None = None,
    saturation: float | None = None,
    starts: int = 4,
    background: str = "flat",
    threads: int | None = None,
) -> Molecules:
    """Estimate row, column, z, photons and background of molecules by maximum likelihood.

    Parameters
    ----------
    table : Table
        Table of the images of a molecule.
    images : array_like, shape (n, height, width)
        A box around each molecule, of the shape of the table, in electrons or, with `noise`, in the unit of the
        camera; NaN for pixels to be ignored.
    noise : Noise, optional
        Gain, offset and read noise of the camera; by default images are in electrons, without read noise. Maps cover
        the whole camera; `corners` are then the positions of boxes in the maps. Pixels with a read noise of 1000
        electrons or more are ignored.
    corners : array_like, shape (n, 2), optional
        Row and column (integers) of the first pixel of each box on the camera. Required for maps. Rows and columns of
        the estimates then count from the first pixel of the camera.
    saturation : float, optional
        Pixels of this value or more, in the unit of `images`, are saturated, and ignored. By default the largest
        value of the integer type or, if many pixels have the largest value of 8 to 16 bits, that value.
    starts : int, default 4
        Number of starts in different ranges of z, 1 to 20. They are used for molecules whose first estimate is at a
        limit of the table or has a discrepancy above 2.5.
    background : {"flat", "tilted"}, default "flat"
        Background of a box: uniform, or with slopes along rows and along columns. The two additional parameters
        remove the bias of positions in an uneven background; standard errors are 2 to 4 % larger.
    threads : int, optional
        Maximum number of threads; by default the number of processors.

    Returns
    -------
    Molecules

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range or of the wrong shape.

    Notes
    -----
    The mean of a pixel is ``mu = photons h + background``, where h is the image in the table. ``counts + read**2`` is
    assumed to have a Poisson distribution of mean ``mu + read**2`` (Huang et al. 2013, doi:10.1038/nmeth.2488).
    Damped Fisher scoring (Smith et al. 2010, doi:10.1038/nmeth.1449) ends when no estimate would change by 0.01
    standard errors. The search starts at the most similar of a set of template images, which cover the range of z and
    positions up to 1.5 pixels from the middle of the box. Boxes should therefore be centred on molecules, not on the
    brightest part of the images.
    Pixels with negative ``counts + read**2``, for example due to a wrong offset, contradict the model and increase
    the `discrepancy`. Systematic errors due to the table are below 1e-3 standard errors for 10^4 photons and
    ``tol=1e-4``. Errors due to a wrong PSF are not included; test the PSF with beads.

    Examples
    --------
    >>> import lommel as lm
    >>> import numpy as np
    >>> objective = lm.Objective(NA=1.4, magnification=63, immersion=1.518, sample=1.33)
    >>> astigmatism = lm.Wavefront.zernike({6: 0.15}, order="noll", unit="waves")
    >>> pupil = objective.pupil(depth=1e-6, wavelength=600e-9, aberrations=astigmatism)
    >>> table = lm.localize.Table(pupil, shape=15, pixel=6.5e-6, z=(-0.6e-6, 0.6e-6))
    >>> image = 2000 * table(7.3, 6.8, 0.2e-6) + 10
    >>> molecules = lm.localize.fit(table, np.random.default_rng(1).poisson(image)[None])
    >>> abs(molecules.z[0] - 0.2e-6) < 4 * molecules.errors.z[0]
    np.True_
    """
    validation.integer("starts", starts, least=1, most=20)
    thread_count = 0 if threads is None else validation.integer("threads", threads, least=1, most=1024)
    validation.instance("table", table, Table)
    validation.optional("noise", noise, Noise)
    camera = noise or Noise(read=0.0)
    maps = {getattr(part, "shape", ()) for part in (camera.white, camera.read, camera.offset)} - {()}
    if corners is None and maps - {table.shape}:
        raise ValueError(f"corners must be given for a camera with maps of shape {max(maps)}, got None")
    expected = "(n, height, width), of one box images[None]"
    boxes = counts_of("images", images, sides=(3,), shape=expected, saturation=saturation, empty=True).marked()
    total, sides = len(boxes), boxes.shape[1:]
    if sides != table.shape:
        raise ValueError(f"images must be boxes of {table.shape} pixels, the shape of the table, got {sides}")
    box_corners = _corners(corners, total)
    tilted = validation.choice("background", background, BACKGROUNDS) == "tilted"
    parameters = 7 if tilted else 5
    values, errors, quality = np.empty((total, parameters)), np.empty((total, parameters)), np.empty((total, 2))
    state = np.empty((total, 2), np.int32)
    fitter = _fitter(table)
    for first in range(0, total, _BLOCK):
        block = slice(first, first + _BLOCK)
        electrons, read = in_electrons(boxes[block], camera, box_corners[block])
        results = fitter.fit(electrons, read, starts, tilted, thread_count)
        values[block], errors[block], quality[block], state[block] = results
    values[:, :2] += box_corners
    # The fit uses electrons divided by the excess noise factor.
    values[:, 3:] *= camera.excess
    errors[:, 3:] *= camera.excess
    return Molecules(
        **_columns_by_name(values),
        errors=MoleculeErrors(**_columns_by_name(errors)),
        log_likelihood=-0.5 * quality[:, 0],
        discrepancy=quality[:, 1].copy(),
        state=state[:, 0].copy(),
        steps=state[:, 1].copy(),
    )


def _columns_by_name(estimates: Array) -> dict[str, Array]:
    """Return columns of estimates, or of errors, (n, parameters) by name, without slopes of the background."""
    return {name: np.ascontiguousarray(column) for name, column in zip(_NAMES, estimates.T, strict=False)}


def _fitter(table: Table) -> engine.MoleculeFitter:
    """Return the compiled fitter of a table with its templates, cached in the table."""
    cache: dict[str, engine.MoleculeFitter] = vars(table)
    if "_fitter" not in cache:
        (low, high), (height, width) = table.z, table.shape
        spacing = _SPACING * table.pupil.scale / (math.pi * table.pixel)  # pixels
        # Molecules are near the middle of the box, so templates need not cover the lateral range of the table.
        max_offset = min(table.reach, max(1.5, spacing))
        sides = np.arange(-math.floor(max_offset / spacing), math.floor(max_offset / spacing) + 1) * spacing
        layers = max(2, math.ceil((high - low) * table.rate / _PHASE_STEP) + 1)
        if layers * len(sides) ** 2 > _MAX_TEMPLATES:
            raise ValueError(f"table must span less than {layers} templates along z; use several tables")
        heights = (np.arange(layers) + 0.5) * ((high - low) / layers) + low
        z, row, column = np.meshgrid(heights, height // 2 + sides, width // 2 + sides, indexing="ij")
        templates = np.stack([row, column, z], axis=-1).reshape(layers, -1, 3)
        cache["_fitter"] = engine.MoleculeFitter(table.core, table.limits, 2.5 / table.rate, templates)
    return cache["_fitter"]


def _corners(corners: Any, count: int) -> NDArray[np.int64]:
    """Return the corners of all boxes, shape (count, 2); all are 0 if `corners` is None."""
    values = validation.real_array("corners", np.zeros((count, 2)) if corners is None else corners)
    if values.shape != (count, 2):
        raise ValueError(f"corners (row, column) must have the shape {(count, 2)}, got {values.shape}")
    if (values != np.round(values)).any():
        raise ValueError(f"corners must be whole numbers, got {values[values != np.round(values)].flat[0]:g}")
    return values.astype(np.int64)


def in_electrons(box: Values, camera: Noise, corners: NDArray[np.int64]) -> tuple[Any, Any]:
    """Return boxes in electrons, divided by the excess noise factor, and their read variance, as float32.

    The variance has the shape of the boxes, or (1, height, width) if it is the same for all boxes.
    """
    parts: dict[str, Any] = {"white": camera.white, "read": camera.read, "offset": camera.offset}
    pixels = box_pixels(corners, box.shape[1:])
    for name, part in parts.items():
        if isinstance(part, np.ndarray):
            index_limits = zip(pixels, part.shape, strict=True)
            if len(box) and any(index.min() < 0 or index.max() >= side for index, side in index_limits):
                raise ValueError(
                    f"corners must be of boxes within the camera: the map `{name}` has {part.shape} pixels"
                )
            parts[name] = part[pixels]
    white = 1.0 if parts["white"] is None else parts["white"]
    electrons = (box.astype(np.float64) - parts["offset"]) * white
    # Defective pixels are ignored (NaN).
    if not isinstance(parts["read"], float):
        electrons = np.where(parts["read"] < DEFECT, electrons, np.nan)
    variance = np.asarray(parts["read"] / camera.excess, dtype=np.float64) ** 2
    variance = variance if variance.ndim == 3 else np.broadcast_to(variance, (1, *box.shape[1:]))
    # Electrons divided by the excess noise factor have a Poisson distribution (Noise.poisson).
    electrons = np.ascontiguousarray(electrons / camera.excess, dtype=np.float32)
    return electrons, np.ascontiguousarray(variance, dtype=np.float32)
