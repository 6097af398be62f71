"""Where molecules are, from their images: maximum likelihood with a table of the PSF."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Index, Values
from lommel.core import engine
from lommel.detection.molecules import DEFECT, box_pixels
from lommel.localize.table import Table
from lommel.recorded.counts import Counts
from lommel.recorded.noise import Noise

STATES = ("converged", "border", "steps", "undetermined")
BACKGROUNDS = ("flat", "tilted")
_SPACING, _TURN = 1.15, 0.85  # of templates: in v, and radians of the fastest phase along z
_AT_ONCE = 20000  # molecules fitted together
_MOST_TEMPLATES = 20000  # largest number of templates


@dataclass(frozen=True, eq=False)
class MoleculeErrors:
    """Standard errors by the Cramer-Rao bound, in the units of the estimates; inf where undetermined."""

    row: Array
    column: Array
    z: Array
    photons: Array
    background: Array

    def __repr__(self) -> str:
        return f"<MoleculeErrors of {len(self.row)} molecules>"


_NAMES = tuple(each.name for each in fields(MoleculeErrors))


@dataclass(frozen=True, eq=False)
class Molecules:
    """Estimates of n molecules, by :func:`lommel.localize.fit`.

    Attributes
    ----------
    row, column : ndarray, shape (n,)
        Pixels, 0 being the middle of the first pixel of the box or, with `corners`, of the camera.
    z : ndarray, shape (n,)
        Metres: position of the stage at which the molecule would look so or, by a table along the depth, depth.
    photons : ndarray, shape (n,) or (n, channels)
        Electrons in an infinite window.
    background : ndarray, shape (n,) or (n, channels)
        Electrons per pixel, at least 0.01.
    errors : MoleculeErrors
        Standard errors of all of these by the Cramer-Rao bound at the estimate.
    log_likelihood : ndarray, shape (n,)
        Logarithm of the likelihood, less that of a mean equal to the counts in every pixel.
    discrepancy : ndarray, shape (n,)
        Pearson's chi2 less its expectation, over its standard deviation: about 0 +- 1 where the PSF and the noise are
        right; large with a second molecule in the box, a wrong PSF or a wrong gain.
    state : ndarray of int, shape (n,)
        Index into ``states``.
    steps : ndarray of int, shape (n,)
        Steps of all starts together.
    states : tuple of str
        "converged"; "border", the estimate being at a limit of the table; "steps", not converged in 50; and
        "undetermined", with too few pixels, no light or no information.
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
        """Which molecules have an estimate within the table."""
        return np.asarray(self.state == 0)

    def __len__(self) -> int:
        return len(self.row)

    def __getitem__(self, which: Index) -> Molecules:
        """Return some of the molecules, indexed as an array of them by a slice, a mask or an array of indices."""
        if np.ndim(np.empty(len(self))[which]) != 1:
            raise TypeError(f"which must be a slice, a mask or indices, got {validation.shown(which)}")
        some: Molecules = _of_each(lambda values: values[which], self)
        return some

    def replaced(self, which: NDArray[np.intp], others: Molecules) -> Molecules:
        """Return the same with other estimates of some molecules.

        Parameters
        ----------
        which : ndarray of int
            Indices of these molecules.
        others : Molecules
            Their estimates.

        Returns
        -------
        Molecules
        """
        # Indices beyond the own molecules point to the replacements.
        order = np.arange(len(self))
        order[which] = len(self) + np.arange(len(others))
        found: Molecules = _of_each(lambda *parts: np.concatenate(parts)[order], self, others)
        return found

    def __repr__(self) -> str:
        counts = zip(STATES, np.bincount(self.state, minlength=4), strict=True)
        count = ", ".join(f"{n} {name}" for name, n in counts if n)
        return f"<Molecules: {len(self)}{': ' if count else ''}{count}>"


def _of_each(change: Callable[..., Any], *several: Any) -> Any:
    """Return molecules or errors each array of which is `change` of those of several."""
    found = {}
    for name in (each.name for each in fields(several[0])):
        parts = [getattr(one, name) for one in several]
        found[name] = _of_each(change, *parts) if name == "errors" else change(*parts)
    return type(several[0])(**found)


def fit(
    table: Table | Sequence[Table],
    images: ArrayLike | Sequence[ArrayLike],
    *,
    noise: Noise | Sequence[Noise] | None = None,
    corners: ArrayLike | None = None,
    transforms: ArrayLike | None = None,
    saturation: float | None = None,
    starts: int = 4,
    background: str = "flat",
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Molecules:
    """Estimate row, column, z, photons and background of molecules by maximum likelihood.

    Parameters
    ----------
    table : Table or sequence of Table
        Images of a molecule. A sequence is of the channels that show each molecule at once, such as two planes
        (biplane) or colours.
    images : array_like, shape (n, height, width)
        One box for each molecule, as large as the table's, in electrons or, with `noise`, in the camera's unit; NaN
        for pixels that are not to count. Several channels: a sequence of such arrays, or shape (channels, n, height,
        width).
    noise : Noise or sequence of Noise, optional
        White, offset and read noise of the camera, or of the camera of each channel; by default images are in
        electrons, without read noise. Maps are of the whole camera, of which `corners` chooses boxes; pixels of a
        read noise of 1000 electrons or more do not count.
    corners : array_like, shape (n, 2) or (channels, n, 2), optional
        Row and column of the first pixel of each box on the camera, whole numbers. Needed for maps, and for channels
        with transforms other than shifts of whole pixels; rows and columns of the estimates are then the camera's.
    transforms : array_like, shape (channels - 1, 2, 3), optional
        From (row, column, 1) of a molecule on the camera of the first channel to its row and column on that of each
        other; by default the same place. From beads that all channels show.
    saturation : float, optional
        Values from here on, in the unit of `images`, are saturated and do not count. By default the largest value of
        integers, and where many pixels are full, that of 8 to 16 bits.
    starts : int, default 4
        Number of starts, in different ranges of z, that are tried where the first estimate is in doubt: at a limit of
        the table, or with a discrepancy above 2.5. 1 to 20.
    background : {"flat", "tilted"}, default "flat"
        Background of a box: the same in all pixels, or with slopes along rows and columns, two unknowns more, which
        takes away the shift of positions in an uneven background; standard errors are 2 to 4 % larger.
    threads : int, optional
        Maximum number of threads; by default the number of processors.
    progress : callable, optional
        Called with the number of molecules done and their total, from time to time.

    Returns
    -------
    Molecules

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range or of another shape.

    Notes
    -----
    The mean of a pixel is ``mu = photons h + background``, h being the table's image, and its counts are taken as
    Poisson's with the mean ``mu + read**2``, shifted (Huang et al. 2013, doi:10.1038/nmeth.2488). Fisher scoring with
    damping (Smith et al. 2010, doi:10.1038/nmeth.1449) ends where no estimate would move by 0.01 of its standard
    error. It starts at the most similar of a bank of images all over z and 1.5 pixels to all sides: boxes
    should be around molecules, not around the brightest part of their images. Pixels of a negative ``counts +
    read**2``, as with a wrong offset, are not those of the model and make the `discrepancy` large. Systematic errors
    due to the table are below 1e-3 of the standard error for 10^4 photons and ``tol=1e-4``; those of a wrong PSF
    are not known here: beads tell.

    Examples
    --------
    >>> import lommel as lm
    >>> import numpy as np
    >>> objective = lm.Objective(NA=1.4, magnification=63, immersion=1.518, sample=1.33)
    >>> astigmatism = lm.Wavefront.zernike({6: 0.15}, order="noll", unit="waves")
    >>> pupil = objective.pupil(depth=1e-6, wavelength=600e-9, aberrations=astigmatism)
    >>> table = lm.localize.Table(pupil, shape=15, pixel=6.5e-6, z=(-0.6e-6, 0.6e-6))
    >>> image = 2000 * table(7.3, 6.8, 0.2e-6) + 10
    >>> found = lm.localize.fit(table, np.random.default_rng(1).poisson(image)[None])
    >>> abs(found.z[0] - 0.2e-6) < 4 * found.errors.z[0]
    np.True_
    """
    validation.integer("starts", starts, least=1, most=20)
    count = 0 if threads is None else validation.integer("threads", threads, least=1, most=1024)
    validation.function("progress", progress, required=False)
    tables = [table] if isinstance(table, Table) else list(table) if isinstance(table, Sequence) else []
    if not tables or not all(isinstance(each, Table) for each in tables):
        raise TypeError(f"table must be a Table or a sequence of these, got {validation.shown(table)}")
    several = not isinstance(table, Table)
    cameras = _cameras(tables, noise, placed=corners is not None)
    boxes = _boxes(tables, images if several else [images], saturation)
    total = len(boxes[0])
    places = _corners(corners, len(boxes), total, several)
    matrices, shifts = _transforms(transforms, len(boxes))
    # What is added to matrix times (row, column) in the first box, for the box of each channel.
    moved = np.einsum("cij,nj->cni", matrices.reshape(-1, 2, 2), places[0]) + shifts[:, None] - places
    offsets = np.ascontiguousarray(moved.swapaxes(0, 1))
    tilted = validation.choice("background", background, BACKGROUNDS) == "tilted"
    per = 4 if tilted else 2
    unknown = 3 + per * len(boxes)
    values, errors, likely = np.empty((total, unknown)), np.empty((total, unknown)), np.empty((total, 2))
    state = np.empty((total, 2), np.int32)
    fitter = _fitter(tuple(tables), matrices.tobytes())
    for first in range(0, total, _AT_ONCE):
        part = slice(first, first + _AT_ONCE)
        each = zip(boxes, cameras, places, strict=True)
        pairs = [in_electrons(box[part], camera, at[part]) for box, camera, at in each]
        light, read = map(list, zip(*pairs, strict=True))
        made = fitter.fit(light, read, offsets[part], starts, tilted, count)
        values[part], errors[part], likely[part], state[part] = made
        if progress is not None:
            progress(min(part.stop, total), total)
    values[:, :2] += places[0]
    for c, camera in enumerate(cameras):  # light of counts whose noise has no excess
        for columns in (values, errors):
            columns[:, 3 + per * c : 3 + per * (c + 1)] *= camera.excess
    return Molecules(
        **_named(values, several, per),
        errors=MoleculeErrors(**_named(errors, several, per)),
        log_likelihood=-0.5 * likely[:, 0],
        discrepancy=likely[:, 1].copy(),
        state=state[:, 0].copy(),
        steps=state[:, 1].copy(),
    )


def _named(of: Array, several: bool, per: int) -> dict[str, Any]:
    """Return estimates or their errors (n, unknowns) by name; the light of each of `several` channels."""
    # Unknowns: row, column, z, then for each channel photons, background and, if tilted, two slopes.
    light = [of[:, k::per] if several else of[:, k] for k in (3, 4)]
    return dict(zip(_NAMES, (np.ascontiguousarray(part) for part in (*of[:, :3].T, *light)), strict=True))


def _fitter(tables: tuple[Table, ...], matrices: bytes) -> engine.MoleculeFitter:
    """Return the fitter of these tables with its templates, kept with the first table."""
    if len({(each.z, each.along) for each in tables}) > 1:
        raise ValueError("table must have channels of one range of z along the same direction")
    first = tables[0]
    key = (tuple(map(id, tables)), matrices)
    kept = vars(first).get("_fitter")
    if kept is None or kept[0] != key:
        spacing = _SPACING * first.pupil.scale / (math.pi * first.pixel)  # pixels
        # Molecules are near the middle of their box: templates need not fill the whole reach.
        most = min(first.reach, max(1.5, spacing))
        sides = np.arange(-math.floor(most / spacing), math.floor(most / spacing) + 1) * spacing
        layers = max(2, math.ceil((first.z[1] - first.z[0]) * first.rate / _TURN) + 1)
        if layers * len(sides) ** 2 > _MOST_TEMPLATES:
            raise ValueError(f"table must span less than {layers} templates along z; make several")
        heights = (np.arange(layers) + 0.5) * ((first.z[1] - first.z[0]) / layers) + first.z[0]
        z, row, column = np.meshgrid(heights, first.shape[0] // 2 + sides, first.shape[1] // 2 + sides, indexing="ij")
        places = np.stack([row, column, z], axis=-1).reshape(layers, -1, 3)
        each = np.frombuffer(matrices).reshape(len(tables), 4)
        made = engine.MoleculeFitter([one.core for one in tables], each, first.limits, 2.5 / first.rate, places)
        kept = vars(first)["_fitter"] = (key, made, tables)
    return kept[1]


def _boxes(tables: list[Table], images: Any, saturation: float | None) -> list[Values]:
    """Return the boxes of each channel, NaN where a pixel is not used."""
    if not hasattr(images, "__len__") or (isinstance(images, np.ndarray) and not images.ndim):
        raise TypeError(f"images must be boxes of each of {len(tables)} channels, got {validation.shown(images)}")
    if len(images) != len(tables):
        raise ValueError(f"images must be of {len(tables)} channels, got {len(images)}")
    boxes = []
    for one, given in zip(tables, images, strict=True):
        shape = "(n, height, width), of one box images[None]"
        box = Counts.of("images", given, sides=(3,), shape=shape, saturation=saturation, empty=True).marked()
        if box.shape[1:] != one.shape:
            raise ValueError(f"images must be boxes of {one.shape} pixels as the table's, got {box.shape[1:]}")
        boxes.append(box)
    if len({len(box) for box in boxes}) != 1:
        raise ValueError(f"images must be of as many molecules in each channel, got {[len(box) for box in boxes]}")
    return boxes


def _cameras(tables: list[Table], noise: Noise | Sequence[Noise | None] | None, *, placed: bool) -> list[Noise]:
    channels = len(tables)
    given = [noise] * channels if noise is None or isinstance(noise, Noise) else noise
    for each in given if isinstance(given, Sequence) else [given]:
        validation.optional("noise", each, Noise)
    if len(given) != channels:
        raise ValueError(f"noise must be one, or one for each of {channels} channels, got {len(given)}")
    cameras = [Noise(read=0.0) if each is None else each for each in given]
    for camera, table in zip(cameras, tables, strict=True):
        shapes = {getattr(part, "shape", ()) for part in (camera.white, camera.read, camera.offset)} - {()}
        if not placed and shapes - {table.shape}:
            raise ValueError(f"corners must tell where boxes are on a camera with maps of shape {max(shapes)}")
    return cameras


def _corners(corners: Any, channels: int, count: int, several: bool) -> Array:
    found = validation.real_array("corners", np.zeros((count, 2)) if corners is None else corners)
    if found.ndim == 2:
        found = np.broadcast_to(found, (channels, *found.shape))
    if found.shape != (channels, count, 2):
        shape = f"({channels}, {count}, 2)" if several else f"({count}, 2)"
        raise ValueError(f"corners must have the shape {shape}, a row and a column each, got {np.shape(corners)}")
    if (found != np.round(found)).any():
        raise ValueError(f"corners must be whole numbers, got {found[found != np.round(found)].flat[0]:g}")
    return found


def _transforms(transforms: ArrayLike | None, channels: int) -> tuple[Array, Array]:
    """Return the matrix of each channel, (channels, 4), and its shift, (channels, 2)."""
    # The first channel is the reference: identity.
    whole = np.tile(np.eye(2, 3), (channels, 1, 1))
    if transforms is not None:
        found = validation.real_array("transforms", transforms)
        if found.shape != (channels - 1, 2, 3):
            raise ValueError(f"transforms must have the shape {(channels - 1, 2, 3)}, got {found.shape}")
        if (np.abs(np.linalg.det(found[:, :, :2])) < 1e-6).any():
            raise ValueError("transforms must not map the camera to a line: the determinant of one is 0")
        whole[1:] = found
    return np.ascontiguousarray(whole[:, :, :2]).reshape(channels, 4), whole[:, :, 2]


def in_electrons(box: Values, camera: Noise, corners: Array) -> tuple[Any, Any]:
    """Return boxes in electrons and the variance of reading, of each or of all, as float32."""
    parts: dict[str, Any] = {"white": camera.white, "read": camera.read, "offset": camera.offset}
    pixels = box_pixels(corners.astype(np.int64), box.shape[1:])
    for name, part in parts.items():
        if isinstance(part, np.ndarray):
            ends = zip(pixels, part.shape, strict=True)
            if len(box) and any(at.min() < 0 or at.max() >= side for at, side in ends):
                raise ValueError(f"corners must be of boxes within the camera, {part.shape} pixels by {name}")
            parts[name] = part[pixels]
    white = 1.0 if parts["white"] is None else parts["white"]
    light = (box.astype(np.float64) - parts["offset"]) * white
    # Defects say nothing: NaN, as left-out pixels.
    if not isinstance(parts["read"], float):
        light = np.where(parts["read"] < DEFECT, light, np.nan)
    variance = np.asarray(parts["read"] / camera.excess, dtype=np.float64) ** 2
    variance = variance if variance.ndim == 3 else np.broadcast_to(variance, (1, *box.shape[1:]))
    # Electrons over the excess are Poisson's (Noise.poisson); so is the read noise.
    light = np.ascontiguousarray(light / camera.excess, dtype=np.float32)
    return light, np.ascontiguousarray(variance, dtype=np.float32)
