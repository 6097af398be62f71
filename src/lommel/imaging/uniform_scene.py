"""Scenes at one distance: their blur, its comparison with other blurs, and the estimate of an unknown one."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple, Self

import numpy as np
import scipy

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.deconvolve.algorithms import silent
from lommel.deconvolve.likelihood import PhotographLikelihood
from lommel.estimation.focal_model import Spectrum
from lommel.imaging.blended import Blend, UniformBlur
from lommel.imaging.blur import require_depth
from lommel.imaging.blur_spectrum import FREQUENCIES
from lommel.imaging.blur_verdict import (
    BlurEstimate,
    BlurVerdict,
    changed,
    compare_blurs,
    defocused,
    disc_or_gaussian,
    estimate_blur,
)
from lommel.imaging.one_pass import fill_unknown
from lommel.optics.lens import Lens, require_round
from lommel.optics.pupil import Pupil
from lommel.recorded.noise import Noise

_VARIANCE_RMS = 2.0  # pixels: rms width of the Gaussian that smooths the light of which the noise is computed
_SOFT_GAUSSIAN = 0.1  # relative error of the width of a Gaussian by the softness of scenes
_LEAST_SLOPE = 1.0  # of textures behind a Gaussian: the power spectrum of scenes that are not soft falls as f^-2
_ONE_BLUR = 0.1  # largest variation of the diameter of the blur, pixels, of a scene at one distance


class UniformScene(NamedTuple):
    """A scene at one distance: its pupil, defocus C_d (rad), pixel pitch (metres), spectra and shape."""

    pupil: Pupil
    defocus: float
    pixel: float
    spectra: Sequence[Spectrum]
    shape: tuple[int, int]

    @classmethod
    def of(cls, depth: Array, lens: Lens, pixel: float, spectra: Sequence[Spectrum]) -> Self | float:
        """Return a scene at one distance, or the variation (pixels) of the blur, if it is above `_ONE_BLUR`."""
        unit, pitch = _pixels_per_radian(lens, pixel)
        vergence = 1.0 / require_depth(depth)
        ends = np.array([vergence.min(), vergence.max()])
        with np.errstate(divide="ignore"):
            distances = 1.0 / np.append(ends, ends.mean())
        defocus = lens.defocus(distances)
        variation = unit * float(np.ptp(defocus))
        if variation > _ONE_BLUR:
            return variation
        shape = depth.shape[0], depth.shape[1]
        return cls(lens.pupil(float(distances[2])), float(defocus[2]), pitch, spectra, shape)

    @property
    def blur(self) -> UniformBlur:
        """Blur of the scene."""
        return UniformBlur.of(self.shape, self.pupil, self.pixel, self.spectra)

    def preferred(self, verdict: BlurVerdict) -> Self:
        """Return the scene with the blur that a verdict prefers."""
        return self._replace(pupil=verdict.applied(self.pupil, self.defocus))

    def verdict(self, observed: PhotographLikelihood, light: Values) -> BlurVerdict:
        """Compare the blur with others, given the restored light, by the middle channel of the photograph."""
        plane, variance = _middle(observed, observed.blur.forward(light))
        middle = self.spectra[len(self.spectra) // 2]
        return compare_blurs(self.pupil, self.defocus, middle, self.pixel, plane, variance)


class SceneEstimate(NamedTuple):
    """Estimated blur, and the distances (metres) at which the lens has it, the likeliest first, with standard errors.

    Without a lens `shape` is that of the blur, "disc" or "Gaussian", and there are no distances.
    """

    blur: BlurEstimate
    distances: tuple[float, ...] = ()
    errors: tuple[float, ...] = ()
    shape: str = ""


def estimate_scene(
    photo: Array, lens: tuple[Lens, float] | None, spectra: Sequence[Spectrum], noise: Noise, limit: float
) -> tuple[UniformBlur, SceneEstimate]:
    """Return the blur that the light of a photograph shows, and the distance, or without a lens the shape, behind it.

    `lens` has its pixel pitch beside it. Light of `limit` and above is saturated.
    """
    # A stand-in for the unknown blur leaves images as they are.
    blur = UniformBlur(photo.shape[:2], lambda f: np.ones((len(spectra), *f.shape)), 0.0)
    observed, first = PhotographLikelihood(blur, photo, noise, limit), None
    while True:
        plane, variance = _middle(observed, first)
        if lens is None:
            blur, estimate = _estimated_shape(blur, plane, variance)
        else:
            blur, estimate = _estimated_distance(blur, *lens, spectra, plane, variance)
        if observed.full is None or first is not None:
            return blur, estimate
        # Saturated pixels, which make the photograph sharper, are raised by a first restoration.
        observed = PhotographLikelihood(blur, photo, noise, limit)
        first = blur.forward(Blend().solve(observed, silent).light)


def _estimated_shape(blur: UniformBlur, plane: Array, variance: Array) -> tuple[UniformBlur, SceneEstimate]:
    """Return the likeliest disc, or Gaussian less a standard error, by the light and noise variance of a channel."""
    found = estimate_blur(lambda d: disc_or_gaussian(d[:, None], FREQUENCIES), False, 1.0, plane, variance)
    shape, size = "disc", found.value
    if size < 0.0:
        # A soft scene widens a Gaussian, which has no zeros to show its width, and a width too large does harm.
        known = found.known and found.slope >= _LEAST_SLOPE
        found = found._replace(error=math.hypot(found.error, _SOFT_GAUSSIAN), known=known)
        shape, size = "Gaussian", size * max(1.0 - found.error, 0.5)
    undone = UniformBlur(blur.shape, lambda f: np.stack([disc_or_gaussian(size, f)] * blur.channels), 0.5 * abs(size))
    return undone, SceneEstimate(found, shape=shape)


def _estimated_distance(
    blur: UniformBlur, lens: Lens, pixel: float, spectra: Sequence[Spectrum], plane: Array, variance: Array
) -> tuple[UniformBlur, SceneEstimate]:
    """Return the blur of a lens and its distance, given the light and noise variance of the middle channel."""
    unit, pitch = _pixels_per_radian(lens, pixel)
    infinite = float(lens.defocus(math.inf))
    pupil = changed(lens.pupil(math.inf), -infinite, 0.0)
    curves = defocused(pupil, spectra[len(spectra) // 2], pitch)
    found = estimate_blur(curves, lens.aberrations.flat, unit, plane, variance)
    # C_d is linear in 1 / distance.
    slope = float(lens.defocus(1.0)) - infinite
    distances, errors = [], []
    for defocus in (found.value,) if found.sign_known else (found.value, -found.value):
        vergence = (defocus - infinite) / slope
        if vergence > 0.0:
            distances.append(1.0 / vergence)
            errors.append(abs(defocus * found.error / slope) / vergence**2)
    likeliest = UniformBlur.of(blur.shape, changed(pupil, found.value, 0.0), pitch, spectra)
    return likeliest, SceneEstimate(found, tuple(distances), tuple(errors))


def _pixels_per_radian(lens: Lens, pixel: float) -> tuple[float, float]:
    """Return the diameter of the geometric blur, in pixels, for a defocus C_d of 1 rad, and the pixel pitch."""
    require_round("lens", lens)
    pitch = validation.pixel(pixel, metric=True)
    unit = lens.wavelength * lens.working_f_number
    validation.pixel_on(pitch, unit, metric=True)
    return 8.0 / math.pi * unit / pitch, pitch


def _middle(observed: PhotographLikelihood, model: Values | None) -> tuple[Array, Array]:
    """Return light and noise variance of the middle channel of a photograph.

    Unknown pixels, and the light that the sensor did not hold, would make the photograph sharper than it is: the
    `model`, the blurred image of a restored scene, replaces them.
    """
    shape, middle = observed.blur.shape, observed.blur.channels // 2
    added = np.broadcast_to(observed.added, observed.counts.shape)

    def plane(values: Values) -> Array:
        return np.asarray(values.reshape(*shape, -1)[..., middle], dtype=np.float64)

    light, known = plane(observed.counts - added), plane(observed.weight) > 0.0
    light = fill_unknown(light, known) if model is None else np.where(known, light, plane(model))
    if observed.full is not None and model is not None:
        light = np.where(plane(observed.full) > 0.0, np.maximum(light, plane(model)), light)
    gain = np.where(known, plane(observed.weight), 1.0) * observed.white
    mean = scipy.ndimage.gaussian_filter(light, _VARIANCE_RMS) if model is None else plane(model)
    return light, np.maximum(mean + plane(added), 0.0) / gain
