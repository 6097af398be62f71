"""Maximum likelihood estimates of the positions of molecules, from their images and a table of the PSF."""

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
    photons : ndarray, shape (n,) or (n, channels)
        Electrons of the molecule in an infinite window.
    background : ndarray, shape (n,) or (n, channels)
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
) -> Molecules:
    """Estimate row, column, z, photons and background of molecules by maximum likelihood.

    Parameters
    ----------
    table : Table or sequence of Table
        Table of the images of a molecule, or one table for each channel of a camera that records every molecule in
        several channels, such as two planes (biplane) or colours.
    images : array_like, shape (n, height, width)
        A box around each molecule, of the shape of the table, in electrons or, with `noise`, in the unit of the
        camera; NaN for pixels to be ignored. For several channels, a sequence of such arrays, or an array of shape
        (channels, n, height, width).
    noise : Noise or sequence of Noise, optional
        Gain, offset and read noise of the camera, or of the camera of each channel; by default images are in
        electrons, without read noise. Maps cover the whole camera; `corners` are then the positions of boxes in the
        maps. Pixels with a read noise of 1000 electrons or more are ignored.
    corners : array_like, shape (n, 2) or (channels, n, 2), optional
        Row and column (integers) of the first pixel of each box on the camera. Required for maps, and for transforms
        of channels other than shifts by whole pixels. Rows and columns of the estimates then count from the first
        pixel of the camera.
    transforms : array_like, shape (channels - 1, 2, 3), optional
        Matrices that map (row, column, 1) of a molecule on the camera of the first channel to row and column on the
        camera of each other channel, for example from beads recorded in all channels; by default the identity.
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
    tables = [table] if isinstance(table, Table) else list(table) if isinstance(table, Sequence) else []
    if not tables or not all(isinstance(item, Table) for item in tables):
        raise TypeError(f"table must be a Table or a sequence of Tables, got {validation.shown(table)}")
    has_channels = not isinstance(table, Table)
    cameras = _cameras(tables, noise, placed=corners is not None)
    boxes = _boxes(tables, images if has_channels else [images], saturation)
    total = len(boxes[0])
    box_corners = _corners(corners, len(boxes), total, has_channels)
    matrices, shifts = _transforms(transforms, len(boxes))
    # offset = (position in the box of a channel) - matrix * (position in the box of the first channel)
    differences = np.einsum("cij,nj->cni", matrices.reshape(-1, 2, 2), box_corners[0])
    differences = differences + shifts[:, None] - box_corners
    offsets = np.ascontiguousarray(differences.swapaxes(0, 1))
    tilted = validation.choice("background", background, BACKGROUNDS) == "tilted"
    per_channel = 4 if tilted else 2
    parameters = 3 + per_channel * len(boxes)
    values, errors, quality = np.empty((total, parameters)), np.empty((total, parameters)), np.empty((total, 2))
    state = np.empty((total, 2), np.int32)
    fitter = _fitter(tuple(tables), matrices.tobytes())
    for first in range(0, total, _BLOCK):
        block = slice(first, first + _BLOCK)
        channels = zip(boxes, cameras, box_corners, strict=True)
        pairs = [in_electrons(box[block], camera, corner[block]) for box, camera, corner in channels]
        electrons, read = map(list, zip(*pairs, strict=True))
        results = fitter.fit(electrons, read, offsets[block], starts, tilted, thread_count)
        values[block], errors[block], quality[block], state[block] = results
    values[:, :2] += box_corners[0]
    # The fit uses electrons divided by the excess noise factor.
    for c, camera in enumerate(cameras):
        for columns in (values, errors):
            columns[:, 3 + per_channel * c : 3 + per_channel * (c + 1)] *= camera.excess
    return Molecules(
        **_columns_by_name(values, has_channels, per_channel),
        errors=MoleculeErrors(**_columns_by_name(errors, has_channels, per_channel)),
        log_likelihood=-0.5 * quality[:, 0],
        discrepancy=quality[:, 1].copy(),
        state=state[:, 0].copy(),
        steps=state[:, 1].copy(),
    )


def _columns_by_name(estimates: Array, has_channels: bool, per_channel: int) -> dict[str, Any]:
    """Return columns of estimates, or of errors, (n, parameters) by name, without slopes of the background.

    Photons and background have the shape (n, channels) if `has_channels`.
    """
    # Parameters: row, column, z, then for each channel photons, background and, if tilted, two slopes.
    levels = [estimates[:, k::per_channel] if has_channels else estimates[:, k] for k in (3, 4)]
    return dict(zip(_NAMES, (np.ascontiguousarray(part) for part in (*estimates[:, :3].T, *levels)), strict=True))


def _fitter(tables: tuple[Table, ...], matrices: bytes) -> engine.MoleculeFitter:
    """Return the compiled fitter of these tables with its templates, cached in the first table."""
    if len({(table.z, table.along) for table in tables}) > 1:
        raise ValueError("table: the tables of all channels must have the same range of z and the same `along`")
    first = tables[0]
    key = (tuple(map(id, tables)), matrices)
    cached = vars(first).get("_fitter")
    if cached is None or cached[0] != key:
        spacing = _SPACING * first.pupil.scale / (math.pi * first.pixel)  # pixels
        # Molecules are near the middle of the box, so templates need not cover the lateral range of the table.
        max_offset = min(first.reach, max(1.5, spacing))
        sides = np.arange(-math.floor(max_offset / spacing), math.floor(max_offset / spacing) + 1) * spacing
        layers = max(2, math.ceil((first.z[1] - first.z[0]) * first.rate / _PHASE_STEP) + 1)
        if layers * len(sides) ** 2 > _MAX_TEMPLATES:
            raise ValueError(f"table must span less than {layers} templates along z; use several tables")
        heights = (np.arange(layers) + 0.5) * ((first.z[1] - first.z[0]) / layers) + first.z[0]
        z, row, column = np.meshgrid(heights, first.shape[0] // 2 + sides, first.shape[1] // 2 + sides, indexing="ij")
        templates = np.stack([row, column, z], axis=-1).reshape(layers, -1, 3)
        channels = np.frombuffer(matrices).reshape(len(tables), 4)
        cores = [table.core for table in tables]
        fitter = engine.MoleculeFitter(cores, channels, first.limits, 2.5 / first.rate, templates)
        # The cache also holds the tables, so that Python does not reuse the ids in the key.
        cached = vars(first)["_fitter"] = (key, fitter, tables)
    return cached[1]


def _boxes(tables: list[Table], images: Any, saturation: float | None) -> list[Values]:
    """Return the boxes of each channel, with NaN in pixels to be ignored."""
    try:
        count = len(images)
    except TypeError:
        got = validation.shown(images)
        raise TypeError(f"images must be boxes for each of {len(tables)} channels, got {got}") from None
    if count != len(tables):
        raise ValueError(f"images must have {len(tables)} channels, one for each table, got {count}")
    boxes = []
    for table, channel_images in zip(tables, images, strict=True):
        shape = "(n, height, width), of one box images[None]"
        counts = counts_of("images", channel_images, sides=(3,), shape=shape, saturation=saturation, empty=True)
        channel_boxes = counts.marked()
        if channel_boxes.shape[1:] != table.shape:
            raise ValueError(
                f"images must be boxes of {table.shape} pixels, the shape of the table, got {channel_boxes.shape[1:]}"
            )
        boxes.append(channel_boxes)
    if len({len(box) for box in boxes}) != 1:
        raise ValueError(f"images must have equally many boxes in all channels, got {[len(box) for box in boxes]}")
    return boxes


def _cameras(tables: list[Table], noise: Noise | Sequence[Noise | None] | None, *, placed: bool) -> list[Noise]:
    """Return the camera of each channel; `placed` is True if the positions of boxes on the camera are known."""
    channels = len(tables)
    noises = [noise] * channels if noise is None or isinstance(noise, Noise) else noise
    for channel_noise in noises if isinstance(noises, Sequence) else [noises]:
        validation.optional("noise", channel_noise, Noise)
    if len(noises) != channels:
        raise ValueError(f"noise must be a Noise, or one for each of {channels} channels, got {len(noises)}")
    cameras = [Noise(read=0.0) if channel_noise is None else channel_noise for channel_noise in noises]
    for camera, table in zip(cameras, tables, strict=True):
        shapes = {getattr(part, "shape", ()) for part in (camera.white, camera.read, camera.offset)} - {()}
        if not placed and shapes - {table.shape}:
            raise ValueError(f"corners must be given for a camera with maps of shape {max(shapes)}, got None")
    return cameras


def _corners(corners: Any, channels: int, count: int, has_channels: bool) -> Array:
    """Return the corners of all boxes, shape (channels, count, 2); all are 0 if `corners` is None."""
    values = validation.real_array("corners", np.zeros((count, 2)) if corners is None else corners)
    if values.ndim == 2:
        values = np.broadcast_to(values, (channels, *values.shape))
    if values.shape != (channels, count, 2):
        shape = f"({channels}, {count}, 2)" if has_channels else f"({count}, 2)"
        raise ValueError(f"corners (row, column) must have the shape {shape}, got {np.shape(corners)}")
    if (values != np.round(values)).any():
        raise ValueError(f"corners must be whole numbers, got {values[values != np.round(values)].flat[0]:g}")
    return values


def _transforms(transforms: ArrayLike | None, channels: int) -> tuple[Array, Array]:
    """Return the matrix of each channel, (channels, 4), and its shift, (channels, 2)."""
    # The first channel is the reference: identity.
    matrices = np.tile(np.eye(2, 3), (channels, 1, 1))
    if transforms is not None:
        other_matrices = validation.real_array("transforms", transforms)
        if other_matrices.shape != (channels - 1, 2, 3):
            raise ValueError(f"transforms must have the shape {(channels - 1, 2, 3)}, got {other_matrices.shape}")
        if (np.abs(np.linalg.det(other_matrices[:, :, :2])) < 1e-6).any():
            raise ValueError("transforms must not map the camera to a line: the determinant of a matrix is 0")
        matrices[1:] = other_matrices
    return np.ascontiguousarray(matrices[:, :, :2]).reshape(channels, 4), matrices[:, :, 2]


def in_electrons(box: Values, camera: Noise, corners: Array) -> tuple[Any, Any]:
    """Return boxes in electrons, divided by the excess noise factor, and their read variance, as float32.

    The variance has the shape of the boxes, or (1, height, width) if it is the same for all boxes.
    """
    parts: dict[str, Any] = {"white": camera.white, "read": camera.read, "offset": camera.offset}
    pixels = box_pixels(corners.astype(np.int64), box.shape[1:])
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
