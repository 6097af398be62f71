"""Result of a deconvolution: values, settings and quality of each channel, and projections."""

from __future__ import annotations

from dataclasses import dataclass, field
from os import PathLike
from threading import Lock
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import DTypeLike

from lommel.base import validation
from lommel.base.arrays import Array, Json, Values
from lommel.deconvolve.likelihood import PoissonLikelihood
from lommel.deconvolve.linear import PlaneOperator
from lommel.fit.findings import Findings, FitReport, in_words
from lommel.recorded import stack_files
from lommel.recorded.frames import Frames
from lommel.recorded.noise import Noise
from lommel.show import estimates as pictures
from lommel.traced.namespaces import Placement

if TYPE_CHECKING:
    from matplotlib.figure import Figure

INTERRUPTED = "interrupted"
"""Value of `stopped` after Ctrl-C: the result of the last complete step is kept."""

MISFIT = "misfit"
"""Value of `stopped` where the residual exceeds the noise and no longer decreases."""


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class RestoredChannel:
    """Settings and quality of the restoration of one channel.

    Attributes
    ----------
    discrepancy, before : float
        Poisson deviance per voxel after the restoration, and before it, where the recording itself is the estimate of
        the specimen; about 1 if PSF and noise model are right.
    steps : int
        Number of steps of the central chunk.
    stopped : str
        "noise", "steps" or "misfit" as in :class:`lommel.imaging.Restoration`; "interrupted" after Ctrl-C.
    noise : Noise
    direction : str
        "up" if the planes run from the cover glass into the sample, else "down".
    depths : ndarray of float, shape (planes,)
        Depth below the cover glass that is in focus in each plane, in the order of the recording, metres; NaN with a
        given PSF.
    psf_depths : ndarray of float
        Depths of the PSFs that were used.
    projections : Projections
        Maximum projections of recording and result, and projected residuals, along z and along y, as drawn by
        :meth:`RestoredStack.plot`. NaN in chunks that an earlier call restored. Of a time series, all have those of
        its first time point.
    background : float or ndarray of shape (height, width)
        Background per voxel, in the unit of the recording, without the camera offset. Restored values exclude it.
    strength : float or None
        Weight of the total variation.
    findings : Findings
        Results of the checks of this channel.
    """

    discrepancy: float
    before: float
    steps: int
    stopped: str
    noise: Noise
    direction: str
    depths: Array = field(repr=False)
    psf_depths: Array = field(repr=False)
    projections: Projections = field(repr=False)
    background: float | Array
    strength: float | None
    findings: Findings


@dataclass(frozen=True, eq=False, repr=False)
class RestoredStack(FitReport):
    """Result of :func:`lommel.microscopy.deconvolve`; converts to an array of its values.

    Attributes
    ----------
    values : ndarray of float32, or array of Zarr
        Restored light in the unit of the recording, without the camera offset. Planes are in the order of the
        recording; the shape is (planes, height, width), or (channels, planes, height, width) for several channels and
        with `out`. A time series has the shape (times, channels, planes, height, width), in a temporary file.
    channels : tuple of RestoredChannel
        Of a time series, those of each time point in turn.
    recording : Frames
        The recording along C, Z, Y and X, of a time series along T before them, with the voxel sizes and wavelengths
        that were used in its metadata.
    notes : tuple of str
        Sentences on the values that were taken from the file, estimated or assumed.
    findings : Findings
        Results of the checks of all channels. Errors: "misfit", "too_quiet", and "not_settled" and "interrupted",
        where the steps ended above the noise. Doubts: "psf_doubtful", where held-out photons agree better with
        another PSF; "misfit" where no other PSF fits better; "hot_pixels"; "missing_chunks" of a Zarr folder, which
        count as dark; "contradiction" and "pixel_pitch", where the file states another step, emission or pixel than
        the one in use. All other findings are notes. Findings set ``converged``, ``reliable`` and ``status``.
    summary : str
        Discrepancy and number of steps of each channel, of a time series the range of its time points.
    """

    values: Any = field(repr=False)
    channels: tuple[RestoredChannel, ...]
    recording: Frames = field(repr=False)
    notes: tuple[str, ...]

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> Values:
        """Return the values."""
        return np.array(self._on_host, dtype=dtype, copy=copy)

    @property
    def _on_host(self) -> Values:
        place = Placement.of(self.values)
        return self.values[...] if place is None else place.to_numpy(self.values)

    def to_dict(self) -> Json:
        """Return the result as data that can be written as JSON, without `values`.

        Returns
        -------
        dict
            The entries of ``FitReport.to_dict()``, the shape, and the voxel sizes (metres). Each channel has its
            name, wavelength, smallest and largest depth, number of PSFs, and mean background.
        """
        result = super().to_dict()
        stated = self.recording.metadata
        names, waves = stated["names"], stated["emission"]
        for k, (entry, channel) in enumerate(zip(result["channels"], self.channels, strict=True)):
            time, number = divmod(k, len(names))
            entry |= {"name": names[number], "wavelength": waves[number], "psfs": len(channel.psf_depths)}
            entry |= {"time": time} if self.values.ndim > 4 else {}
            low, high = float(channel.depths.min()), float(channel.depths.max())
            entry["depths"] = None if np.isnan(low) else [low, high]
            entry["background"] = float(np.mean(channel.background))
        sizes = {"pixel_in_sample": stated["pixel"], "step": stated["step"]}
        return {"shape": list(self.values.shape[-3:])} | sizes | result

    def plot(self) -> Figure:
        """Return a matplotlib figure of maximum projections before and after, and of the normalized residual.

        Projections along z (xy) are above projections along y (xz), with a scale bar. The residual in units of the
        noise is summed along each projected line and divided by the square root of its number of voxels. If PSF and
        noise model are right, the residual has no pattern, and its modulus rarely exceeds 3.

        Returns
        -------
        matplotlib Figure

        Raises
        ------
        ImportError
            If matplotlib is not installed.
        """
        show_names = len(self.recording.metadata["names"]) > 1
        labelled = [
            (f"{name}: " if show_names else "", channel.projections)
            for name, channel in zip(self.recording.metadata["names"], self.channels, strict=False)
        ]
        caption = "; ".join(
            f"{name}discrepancy {channel.before:#.3g} before, {channel.discrepancy:#.3g} after {channel.steps} steps"
            for (name, _), channel in zip(labelled, self.channels, strict=False)
        )
        sides = self.recording.metadata["step"], self.recording.metadata["pixel"]
        return pictures.projections(labelled, sides, caption)

    def save(self, *paths: str | PathLike[str]) -> None:
        """Write the stack with its voxel sizes, channels and wavelengths.

        Parameters
        ----------
        *paths : path
            Files to write: OME-TIFF if the name ends in .tif or .tiff, OME-Zarr (0.4) if it ends in .zarr. Each file
            is written under a temporary name and then renamed.

        Raises
        ------
        ValueError
            If a name has another suffix, or is the name of the recording.
        OSError, ImportError
            If a file cannot be written, or tifffile or zarr is not installed.
        """
        places = [validation.path("paths", path) for path in paths]
        for place in places:
            stack_files.kind_of(place, self.recording.path)
        values = np.asarray(self._on_host, np.float32)
        values = values[np.newaxis] if values.ndim == 3 else values
        remarks = " ".join([*in_words(self.findings), *self.notes])
        for place in places:
            stack_files.save_stack(place, values, self.recording, remarks)


class Projections(NamedTuple):
    """Projections along z, shape (height, width), and along y, shape (planes, width), of float32.

    Attributes
    ----------
    recorded, restored : (ndarray, ndarray)
        Maxima, in the unit of the recording, without the camera offset.
    residual : (ndarray, ndarray)
        Recording minus model in units of the noise, summed along each projected line and divided by the square root
        of its number of voxels; the variance is 1 if PSF and noise model are right.
    """

    recorded: tuple[Values, Values]
    restored: tuple[Values, Values]
    residual: tuple[Values, Values]


def blank(shape: tuple[int, int, int]) -> Projections:
    """Return projections filled with NaN."""
    planes, height, width = shape
    recorded, restored, residual = (
        (np.full((height, width), np.nan, np.float32), np.full((planes, width), np.nan, np.float32)) for _ in range(3)
    )
    return Projections(recorded, restored, residual)


class Projected(NamedTuple):
    """Sums of residuals, numbers of voxels, and maxima of counts of a chunk, along z and along y."""

    along_z: Values
    along_y: Values


def projected(
    inner: tuple[slice, slice], blur: PlaneOperator, counted: PoissonLikelihood, light: Values
) -> Projected:
    """Project the rows and columns `inner` of a chunk whose restored light is given."""
    y_offset, x_offset = (pixels.start for pixels in inner)
    height, width = (pixels.stop - pixels.start for pixels in inner)
    along_z = np.zeros((3, height, width), np.float32)
    along_y = np.zeros((3, blur.shape[0], width), np.float32)
    lock = Lock()

    def compare(plane: int, y: slice, x: slice, model: Values) -> None:
        counts, residuals, scale = counted.whitened(plane, y, x, model)
        top, left = y.start - y_offset, x.start - x_offset
        inside = np.s_[max(-top, 0) : max(height - top, 0), max(-left, 0) : max(width - left, 0)]
        counts, residuals, weights = counts[inside], residuals[inside], scale[inside] > 0.0
        rows_at = slice(max(top, 0), max(top, 0) + len(residuals))
        target = rows_at, slice(max(left, 0), max(left, 0) + residuals.shape[1])
        with lock:
            sums, voxels, maxima = (part[target] for part in along_z)
            sums += residuals
            voxels += weights
            np.maximum(maxima, counts, out=maxima)
            part = along_y[:, plane, target[1]]
            part[0] += residuals.sum(axis=0)
            part[1] += weights.sum(axis=0)
            np.maximum(part[2], counts.max(axis=0, initial=0.0), out=part[2])

    blur.forward(light, compare)
    return Projected(along_z, along_y)


class ProjectionBuilder:
    """Builder of the projections of a stack, chunk by chunk."""

    def __init__(self, shape: tuple[int, int, int]) -> None:
        self._projections = blank(shape)
        self._voxels = np.zeros((shape[0], shape[2]), np.float32)  # numbers of voxels summed along y

    def add(self, rows: slice, columns: slice, chunk: Projected, restored: Values) -> None:
        """Add a chunk, `restored` at `rows` and `columns`."""
        (sums, voxels, maxima), along_y = chunk
        recorded, after, residual = self._projections
        recorded[0][rows, columns] = np.where(voxels > 0.0, maxima, np.float32(np.nan))
        after[0][rows, columns] = restored.max(axis=0)
        residual[0][rows, columns] = _divide_by_root(sums, voxels)
        # Chunks above and below contribute to the same voxels of the projection along y.
        before = self._voxels[:, columns]
        total = along_y[0] + np.nan_to_num(residual[1][:, columns]) * np.sqrt(before)
        self._voxels[:, columns] = before + along_y[1]
        residual[1][:, columns] = _divide_by_root(total, self._voxels[:, columns])
        highest = np.where(along_y[1] > 0.0, along_y[2], np.float32(np.nan))
        for projection, maximum in ((recorded, highest), (after, restored.max(axis=1))):
            projection[1][:, columns] = np.fmax(projection[1][:, columns], maximum)

    def result(self, *, reverse: bool) -> Projections:
        """Return the projections, with the planes in reverse order if `reverse`."""
        if not reverse:
            return self._projections
        return Projections(*((along_z, along_y[::-1]) for along_z, along_y in self._projections))


def _divide_by_root(sums: Values, voxels: Values) -> Values:
    """Return sums divided by the square root of the number of voxels, NaN where that number is 0."""
    return np.where(voxels > 0.0, sums / np.sqrt(np.maximum(voxels, 1.0)), np.float32(np.nan))
