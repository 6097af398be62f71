"""The mean of the beads in a stack as the PSF of a microscope."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from os import PathLike
from typing import Any, NamedTuple

import numpy as np
import scipy
from numpy.typing import ArrayLike

from lommel import detection
from lommel.base import display, validation
from lommel.base.arrays import Array
from lommel.base.units import format_length, percent
from lommel.fit.findings import Finding, Findings
from lommel.measures.measured_psf import MeasuredPSF, frequencies, places_of, sampled, voxel_text
from lommel.microscopy.depth_model import usual_window
from lommel.optics.layers.objective import Objective
from lommel.psf import psf
from lommel.recorded.camera_noise import measured_noise
from lommel.recorded.frames import Frames, frames_of
from lommel.recorded.headers import size_findings, told_early

MOST_ON_RIM = 0.2
"""Largest fraction of the light of a measured PSF on the outermost pixels of its planes."""
_NARROWEST, _ENOUGH = 17, 10  # pixels: smallest window of a bead; number of beads that need no smaller window
_NARROWER, _MARGIN = 1.3, 4  # ratio of successive windows; pixels by which a bead may be off the middle of its window
_FIELD = 1.5  # a stack of at most this many windows across shows a single bead
_LEAST_HALF = 2  # planes on either side of the focus of a bead
_NEAR_END = 0.6  # a bead with fewer planes on one side than this fraction of the median is left out
_ALIGNMENTS, _SHIFTS = 4, 3  # means of the beads, and steps of the shifts to each
_MAX_SHIFT = 1.0  # voxels: largest step of a shift
_UNLIKE = 2.0  # ratio of a bead's residual to the median one above which it is left out
_PEAK_SIGMAS = 8.0  # least height of a peak, standard deviations of the outer pixels
_LEAST_BALL = 0.2  # least transfer of a bead, within the pass band, at which its diameter is removed
_RING = 2.0  # width of the rings of frequencies whose power is averaged, frequencies of the wider side
_ROUNDING = 1e-10  # power of frequencies, over the largest, that is not of the light
_MEDIAN_POWER = 0.455  # median of the square of a standard normal number
_TOL = 1e-3  # tolerance of the PSF of the objective, to which beads are registered


class _Optics(NamedTuple):
    """An objective and the wavelength (m) of beads."""

    objective: Objective
    wavelength: float

    def stack(self, shape: tuple[int, ...], pixel: float, step: float) -> Array:
        """Return the light of a point on the cover glass, focused in the middle voxel, in each voxel."""
        z = (np.arange(shape[0]) - shape[0] // 2) * step
        pupil = self.objective.pupil(depth=0.0, z=z, wavelength=self.wavelength)
        camera = pixel * self.objective.magnification
        return np.asarray(psf(pupil, (shape[1], shape[2]), camera, tol=_TOL).values, np.float64)


@display.register("measured PSF")
def measured_psf(
    array: str | PathLike[str] | ArrayLike | Frames,
    pixel: float | None = None,
    step: float | None = None,
    *,
    microscope: Any = None,
    diameter: float | None = None,
    background: float | None = None,
    channel: int | None = None,
) -> MeasuredPSF:
    """Return a measured PSF, of one `channel` of a file: see :meth:`lommel.PSF.measured`."""
    if not isinstance(array, str | PathLike | Frames) and np.ndim(array) == 2:  # an image of a point, not a stack
        array, step = np.asarray(array)[None], pixel
    with frames_of("array", array) as frames:
        # One axis of images, of a file that calls it time or nothing, is that of the planes.
        recording = frames.as_channels(axes="ZYX" if frames.ndim == 3 and "C" not in frames.axes else None)
        metadata = recording.metadata
        one = recording.only_channel("array") if channel is None else recording.one_of("C", channel)
        stack = np.asarray(one[...], np.float64)
    sizes = {}
    for name, stated in (("pixel", pixel), ("step", step)):
        if stated is None and (stated := metadata[name]) is None:
            raise ValueError(
                f"{name} of the PSF must be stated (--psf-{name}), metres in the sample: {recording.name} states none"
            )
        sizes[name] = validation.real(name, stated, above=0.0, most=1e-4, unit="metres")
    remarks = [
        replace(finding, text=finding.text.replace("the images", "the images of the PSF", 1))
        for finding in (() if channel else size_findings(metadata, " of the PSF", **sizes))  # once for all channels
    ]
    told_early(remarks)
    sides = stack.shape if len(stack) > 1 else stack.shape[1:]
    if min(sides) < 2 * _LEAST_HALF + 1 or not np.isfinite(stack).all():
        raise ValueError(f"array must be finite and have 5 voxels or more in each direction, got {sides}")
    if diameter is not None:
        validation.real("diameter", diameter, least=0.0, most=1e-5, unit="metres")
    if background is not None:
        validation.real("background", background)
    optics = None
    if microscope is not None:
        if len(stack) == 1:
            raise ValueError("microscope is for a stack, got the image of a point")
        objective = getattr(microscope, "objective", None)
        if not isinstance(objective, Objective):
            raise TypeError(f"microscope must be a Microscope, got {validation.shown(microscope)}")
        optics = _Optics(objective, float(metadata["emission"][channel or 0] or microscope.wavelength))
    return _Beads(stack, sizes["pixel"], sizes["step"], optics, background).mean(diameter, remarks)


class _Beads:
    """Beads of a stack, cut out around the brightest voxel of each, without background."""

    def __init__(
        self, stack: Array, pixel: float, step: float, optics: _Optics | None, background: float | None
    ) -> None:
        self._pixel, self._step, self._optics = pixel, step, optics
        self._refused: dict[str, int] = {}
        windows, side = self._windows(stack)
        places = [_brightest(window) for window in windows]
        # Number of planes on the nearer side of the focus of each bead.
        halves = np.array([min(plane, len(stack) - 1 - plane) for plane, _, _ in places])
        least = _LEAST_HALF if len(stack) > 1 else 0
        usable = halves >= max(_NEAR_END * float(np.median(halves)), least)
        if not usable.any():
            raise ValueError(
                f"array must show a bead in focus, with two planes or more on either side; the brightest voxel is in "
                f"plane {places[0][0]} of {len(stack)}, counted from 0"
            )
        self._count("in focus near the first or last plane", int((~usable).sum()))
        self._half = int(halves[usable].min())
        self._ideal: Array | None = None
        if optics is not None:
            self._ideal = optics.stack((2 * self._half + 1, side, side), pixel, step)
        crops = []
        for window, (plane, row, column), is_usable in zip(windows, places, usable, strict=True):
            if is_usable:
                crop = _centred(window[plane - self._half : plane + self._half + 1], row, column, side)
                crops.append(crop - (self._background(crop) if background is None else background))
                self._require_peak(crops[-1])
        self._crops = np.array(crops)

    def _windows(self, stack: Array) -> tuple[list[Array], int]:
        """Return windows around beads, or the whole stack if it shows one, and the odd side of a PSF in pixels."""
        least = min(stack.shape[1:])
        whole = [stack], least - (least % 2 == 0)
        if len(stack) == 1:
            return whole
        widest = least
        if self._optics is not None:
            camera, shape = self._pixel * self._optics.objective.magnification, (len(stack) // 2 + 1, least, least)
            widest = usual_window(self._optics.objective, self._optics.wavelength, camera, self._step, shape)[1]
        try:
            noise, _ = measured_noise(stack)
        except ValueError:  # without photon noise: the PSF of a program
            return whole
        best: tuple[list[Array], int] = ([], 0)
        side = min(widest, int(least / _FIELD)) | 1
        while side >= _NARROWEST and len(best[0]) < _ENOUGH:
            spots = detection.find_spots(stack, noise=noise, window=side + _MARGIN)
            if len(spots) > len(best[0]):
                best = list(np.asarray(spots.windows, np.float64)), side
                self._refused = dict(Counter(spot.reason for spot in spots.refused))
            side = int(side / _NARROWER) | 1
        return best if len(best[0]) > 1 or self._refused else whole

    def _count(self, reason: str, number: int) -> None:
        if number:
            self._refused[reason] = number

    def _background(self, crop: Array) -> float:
        """Return the light per voxel without which all planes have the light of one point.

        The objective states the fractions of a point's light in the middle of each plane and around it. Without an
        objective it is the median of the outer pixels of the three planes around the focus.
        """
        if self._ideal is None:
            return float(np.median(_outer(crop[self._half - 1 : self._half + 2])))
        sums, light, voxels = (
            np.concatenate([inner := _inner(part).sum(axis=(1, 2)), part.sum(axis=(1, 2)) - inner])
            for part in (crop, self._ideal, np.ones(crop.shape))
        )
        weight = 1.0 / np.sqrt(np.maximum(sums, 1e-3 * np.abs(sums).max()))
        design = np.stack([light, voxels], axis=1) * weight[:, None]
        return float(np.linalg.lstsq(design, sums * weight, rcond=None)[0][1])

    def _require_peak(self, crop: Array) -> None:
        peak, noise = float(crop[self._half].max()), float(np.std(_outer(crop[self._half - 1 : self._half + 2])))
        if not peak > _PEAK_SIGMAS * noise:
            raise ValueError(
                f"array must show a peak {_PEAK_SIGMAS:g} standard deviations above the pixels around it, got "
                f"{peak / max(noise, 1e-300):.3g}"
            )

    def mean(self, diameter: float | None, remarks: Sequence[Finding]) -> MeasuredPSF:
        """Return the mean of the registered beads, without what is outside of the pass band; `remarks` are kept."""
        crops, lights = self._crops, _inner(self._crops).sum(axis=(1, 2, 3))
        shape, ideal = crops.shape[1:], None if self._ideal is None else self._ideal / _inner(self._ideal).sum()
        mean = crops[lights.argmax()] / lights.max() if ideal is None else ideal
        shifts, used = np.zeros((len(crops), 3)), np.ones(len(crops), bool)
        for _ in range(_ALIGNMENTS if len(crops) > 1 else 1):
            aligned = crops.copy()
            for k, crop in enumerate(crops if len(crops) > 1 else ()):
                shifts[k] = _registered(crop / lights[k], mean, shifts[k])
                aligned[k] = sampled(crop, places_of(shape, shifts[k]))
            mean = aligned[used].sum(axis=0) / lights[used].sum()
            # The residual of photon noise grows with the root of the light.
            residuals = np.sqrt(((aligned - lights[:, None, None, None] * mean) ** 2).sum(axis=(1, 2, 3)) / lights)
            used = residuals <= _UNLIKE * np.median(residuals)
        self._count("unlike the others", int((~used).sum()))
        gain, noise = _pass_band(mean)
        gain, removed = _without_ball(gain, (self._step, self._pixel, self._pixel), diameter)
        # The point is where the PSF of the objective fits best, or at the peak; in an image, which may be out of
        # focus, at the centroid.
        if ideal is None:
            shift = _summit(mean) if len(mean) > 1 else _centroid(mean)
        else:
            shift = _registered(mean, ideal, np.zeros(3))
        values = _without_negatives(sampled(mean, places_of(shape, shift), gain))
        values /= values.sum()
        rim, count = 1.0 - float(values[:, 1:-1, 1:-1].sum()), int(used.sum())
        if rim > MOST_ON_RIM:
            raise ValueError(
                f"array must have at most {percent(MOST_ON_RIM)} of the light of the PSF on the outermost pixels of "
                f"its planes, got {percent(rim)}: take a wider window, or fewer planes"
            )
        numbers = {
            "beads": count, "window": shape[1], "planes": shape[0], "pixel": self._pixel, "step": self._step,
            "noise": noise, "peak": float(values.max()), "rim": rim, "diameter": diameter,
        }  # fmt: skip
        size = f"{shape[0]} x {shape[1]} x {shape[2]} voxels of {voxel_text(self._pixel, self._step)}"
        if len(mean) == 1:
            size = f"{shape[1]} x {shape[2]} pixels"
        source = "a single image" if len(crops) == 1 else f"the mean of {count} beads"
        text = (
            f"the PSF is {source}: {size}, noise of {percent(noise)} of its light, {percent(rim)} of it on "
            f"the rim, {100.0 * float(values.max()):.2g} % in the brightest "
            + (f"voxel; {removed}" if len(mean) > 1 else "pixel")
        )
        findings = [*remarks, Finding("measured_psf", "note", text, numbers)]
        if self._refused:
            reasons = ", ".join(f"{number} {reason}" for reason, number in self._refused.items())
            findings.append(Finding("left_out", "note", f"beads were left out: {reasons}", self._refused))
        magnification = None if self._optics is None else self._optics.objective.magnification
        return MeasuredPSF(values, self._pixel, self._step, count, Findings(findings), magnification)


def _brightest(window: Array) -> tuple[int, int, int]:
    """Return the brightest voxel of a smoothed window."""
    smooth = scipy.ndimage.gaussian_filter(window, 1.0)
    plane, row, column = np.unravel_index(int(smooth.argmax()), smooth.shape)
    return int(plane), int(row), int(column)


def _inner(planes: Array) -> Array:
    """Return the middle half, along rows and columns, of planes."""
    quarter = planes.shape[-1] // 4
    return planes[..., quarter : planes.shape[-1] - quarter, quarter : planes.shape[-1] - quarter]


def _outer(planes: Array) -> Array:
    """Return the two outermost pixels of planes."""
    inside = np.zeros(planes.shape, bool)
    inside[:, 2:-2, 2:-2] = True
    return planes[~inside]


def _centred(window: Array, row: int, column: int, side: int) -> Array:
    """Return the part of a window around a pixel, as near to its middle as the window allows."""
    parts = [
        slice(first := min(max(place - side // 2, 0), size - side), first + side)
        for place, size in zip((row, column), window.shape[1:], strict=True)
    ]
    return window[:, parts[0], parts[1]]


def _registered(image: Array, reference: Array, shift: Array) -> Array:
    """Return the shift, in voxels, of an image from the reference, by least squares with a free level of light."""
    columns = np.stack([reference, *np.gradient(reference), np.ones(reference.shape)]).reshape(5, -1)
    normal = columns @ columns.T
    for _ in range(_SHIFTS):
        # image(x + shift) = light (reference(x) + slopes . gradient) + level.
        light, *slopes, _ = np.linalg.solve(normal, columns @ sampled(image, places_of(image.shape, shift)).ravel())
        shift = shift - np.clip(np.array(slopes) / max(light, 1e-3), -_MAX_SHIFT, _MAX_SHIFT)
    return np.asarray(shift)


def _summit(mean: Array) -> Array:
    """Return the distance of the peak of a smoothed mean from the middle voxel, by parabolas."""
    smooth = scipy.ndimage.gaussian_filter(mean, 1.0)
    peak = np.array(np.unravel_index(int(smooth.argmax()), smooth.shape))
    peak = np.clip(peak, 1, np.array(mean.shape) - 2)
    places = peak - np.array(mean.shape) // 2 + np.zeros(3)
    for axis, one in enumerate(np.eye(3, dtype=int)):
        low, middle, high = (smooth[tuple(peak + k * one)] for k in (-1, 0, 1))
        places[axis] += 0.5 * (low - high) / min(low - 2.0 * middle + high, -1e-300)
    return np.asarray(places)


def _centroid(image: Array) -> Array:
    """Return the distance of the centroid of an image of one plane from the middle pixel."""
    light = np.maximum(image[0], 0.0)
    sums = [light.sum(axis=1 - axis) @ (np.arange(side) - side // 2) for axis, side in enumerate(light.shape)]
    return np.asarray(np.array([0.0, *sums]) / max(float(light.sum()), 1e-300))


def _pass_band(mean: Array) -> tuple[Array, float]:
    """Return the Wiener filter of a mean of beads, and the noise that it leaves as a fraction of the light.

    The power of light is that of a ring, of equal frequencies along z and across, less that of the noise: most
    frequencies of a stack are outside of the pass band of the objective, and have noise alone.
    """
    power = scipy.fft.dctn(mean, norm="ortho") ** 2
    floor = max(float(np.median(power)) / _MEDIAN_POWER, _ROUNDING * float(power.max()))
    planes, height, width = mean.shape
    rings = (
        np.hypot(np.arange(height)[:, None] / height, np.arange(width) / width) * max(height, width) / _RING
    ).astype(int)
    ring = (np.arange(planes)[:, None, None] * (rings.max() + 1) + rings).ravel()
    means = np.bincount(ring, power.ravel()) / np.maximum(np.bincount(ring), 1)
    gain = np.maximum(1.0 - floor / np.maximum(means, 1e-300), 0.0)[ring].reshape(mean.shape)
    # Half of the sum of the absolute values of normal noise.
    error = math.sqrt(floor * float(gain.mean()) / (2.0 * math.pi)) * mean.size
    return gain, error / float(mean.sum())


def _without_negatives(values: Array) -> Array:
    """Return the nearest values of the same sum without negative ones: noise that is cut off at 0 would be light.

    The projection on a simplex (Held, Wolfe and Crowder 1974, doi:10.1007/BF01580223).
    """
    sorted_values, total = np.sort(values, axis=None)[::-1], float(values.sum())
    if not total > 0.0:
        return np.maximum(values, 0.0)
    levels = (np.cumsum(sorted_values) - total) / np.arange(1, values.size + 1)
    return np.asarray(np.maximum(values - levels[np.flatnonzero(sorted_values > levels)[-1]], 0.0))


def _without_ball(gain: Array, voxel: tuple[float, ...], diameter: float | None) -> tuple[Array, str]:
    """Return the gain that also removes the diameter of the beads, and a sentence on it."""
    if diameter is None:
        return gain, "the diameter of the beads was not stated, and was not removed"
    fz, fy, fx = frequencies(gain.shape, voxel)
    u = np.pi * diameter * np.sqrt(fz[:, None, None] ** 2 + fy[:, None] ** 2 + fx**2)
    # The transform of a ball, 3 (sin u - u cos u) / u^3.
    ball = np.where(u < 1e-2, 1.0 - u**2 / 10.0, 3.0 * (np.sin(u) - u * np.cos(u)) / np.maximum(u, 1e-2) ** 3)
    if ball[gain > 0.5].min(initial=1.0) < _LEAST_BALL:
        return gain, f"a diameter of {format_length(diameter)} is too large to be removed, so the PSF is wider"
    return gain / np.maximum(ball, _LEAST_BALL), f"the diameter of {format_length(diameter)} was removed"
