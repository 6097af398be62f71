"""Scenes at one distance: their blur, its comparison with other blurs, and the estimate of an unknown one."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any, NamedTuple, Self

import numpy as np
import scipy

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.deconvolve.algorithms import silent
from lommel.deconvolve.likelihood import PhotographLikelihood
from lommel.deconvolve.linear import LinearBlur
from lommel.estimation.focal_model import Spectrum, pupil_curve
from lommel.imaging.blended import Blend, TiledBlur, UniformBlur, radial_curve, tiles_of
from lommel.imaging.blur import require_depth
from lommel.imaging.blur_spectrum import FREQUENCIES
from lommel.imaging.blur_verdict import (
    BlurEstimate,
    Blurs,
    BlurVerdict,
    aberrated_curves,
    changed,
    compare_blurs,
    defocused,
    estimate_blur,
)
from lommel.imaging.measured_blur import MeasuredBlur
from lommel.imaging.motion import Motion, likeliest_motion
from lommel.imaging.one_pass import fill_unknown
from lommel.measures.transfer import disc_transfer
from lommel.optics.lens import Lens, require_round
from lommel.optics.pupil import Pupil
from lommel.recorded.noise import Noise

_VARIANCE_RMS = 2.0  # pixels: rms width of the Gaussian that smooths the light of which the noise is computed
_BLOCK = 128  # stride and overlap (pixels) of the blocks of which distances are estimated
_VARIES = 4.0  # mean squared deviation of the blurs of blocks / their variance, from which depth varies
# Blurs that compete with motion: factors of the likeliest diameter, and others, pixels.
_NEAR, _RIVALS = np.array([0.96, 1.0, 1.04]), np.array([0.1, 2.0, 3.0, 4.0, 5.5, 7.5, 10.0])
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

    def preferred(self, verdict: BlurVerdict) -> LinearBlur:
        """Return the blur that a verdict prefers."""
        if verdict.motion is not None:
            return verdict.motion.blur(self.shape, len(self.spectra))
        return self._replace(pupil=verdict.applied(self.pupil, self.defocus)).blur

    def verdict(self, observed: PhotographLikelihood, light: Values) -> BlurVerdict:
        """Compare the blur with others, given the restored light, by the middle channel of the photograph."""
        middle = self.spectra[len(self.spectra) // 2]

        def of_factors(factors: Array) -> Array:
            stack = changed(self.pupil, (factors - 1.0) * self.defocus, 0.0)
            return pupil_curve(stack, middle, self.pixel)(FREQUENCIES)

        spherical = partial(aberrated_curves, self.pupil, middle, self.pixel)
        return compare_blurs(of_factors, spherical, *_compared(observed, light))


class MeasuredScene(NamedTuple):
    """A scene that is blurred by a measured PSF."""

    blur: MeasuredBlur

    def preferred(self, verdict: BlurVerdict) -> LinearBlur:
        """Return the blur by the PSF scaled as a verdict prefers."""
        return self.blur.scaled(verdict.factor)

    def verdict(self, observed: PhotographLikelihood, light: Values) -> BlurVerdict:
        """Compare the PSF with scaled ones, given the restored light, by the middle channel of the photograph."""
        curve = radial_curve(self.blur, self.blur.channels // 2)

        def of_factors(factors: Array) -> Array:
            return np.array([np.interp(factor * FREQUENCIES, FREQUENCIES, curve, right=0.0) for factor in factors])

        # A measured PSF may itself have a direction.
        verdict = compare_blurs(of_factors, None, *_compared(observed, light))
        return verdict._replace(motion=None, profiles=0.0)


class SceneEstimate(NamedTuple):
    """Estimated blur, and the distances (metres) at which the lens has it, the likeliest first, with standard errors.

    Without a lens the blur is a disc, and there are no distances. Where depth varies,
    `blocks` has the centre of each block (pixels), its blur (None if it is not known), distances and errors. A
    photograph that was moved has its `motion`.
    """

    blur: BlurEstimate
    distances: tuple[float, ...] = ()
    errors: tuple[float, ...] = ()
    blocks: tuple[Mapping[str, Any], ...] = ()

    motion: Motion | None = None

    @property
    def known(self) -> bool:
        """True if the photograph determines its blur, or those of some blocks."""
        return self.motion is None and (bool(self.blocks) or self.blur.known)


def estimate_scene(
    photo: Array, lens: tuple[Lens, float] | None, spectra: Sequence[Spectrum], noise: Noise, limit: float
) -> tuple[UniformBlur | TiledBlur, SceneEstimate]:
    """Return the blur that the light of a photograph shows, and the distance behind it, or without a lens a disc.

    Where depth varies, blur and distance are those of overlapping blocks. `lens` has its pixel pitch beside it. Light
    of `limit` and above is saturated.
    """
    # A stand-in for the unknown blur leaves images as they are.
    blur = UniformBlur(photo.shape[:2], lambda f: np.ones((len(spectra), *f.shape)), 0.0)
    observed, first = PhotographLikelihood(blur, photo, noise, limit), None
    search = None if lens is None else _Search.of(*lens, spectra)
    while True:
        plane, variance = _middle(observed, first)
        blur, estimate = (search.whole if search else _estimated_disc)(blur, plane, variance)
        if observed.full is None or first is not None:
            motion = likeliest_motion(_others(search, estimate.blur), plane, variance)
            if motion.likely:
                return blur, estimate._replace(motion=motion)
            if motion.possible:
                return blur, estimate._replace(blur=estimate.blur._replace(known=False))
            return (search and search.blocks(blur, estimate, plane, variance)) or (blur, estimate)
        # Saturated pixels, which make the photograph sharper, are raised by a first restoration.
        observed = PhotographLikelihood(blur, photo, noise, limit)
        first = blur.forward(Blend().solve(observed, silent).light)


def _others(search: _Search | None, found: BlurEstimate) -> Array:
    """Return the transfer functions of blurs around the likeliest one, and of others, that compete with motion."""
    if search is None:
        return disc_transfer(np.append(found.diameter * _NEAR, _RIVALS)[:, None], FREQUENCIES)
    return search.curves(np.append(found.value * _NEAR, _RIVALS / search.unit))


def _estimated_disc(blur: UniformBlur, plane: Array, variance: Array) -> tuple[UniformBlur, SceneEstimate]:
    """Return the likeliest disc by the light and noise variance of a channel; other blurs resemble soft scenes."""
    found = estimate_blur(lambda d: disc_transfer(d[:, None], FREQUENCIES), True, 1.0, plane, variance)
    undone = UniformBlur(
        blur.shape, lambda f: np.stack([disc_transfer(found.value, f)] * blur.channels), 0.5 * found.value
    )
    return undone, SceneEstimate(found)


class _Search(NamedTuple):
    """Search for the distance at which a lens has the blur of a photograph.

    `focused` is the pupil without defocus and `unit` the diameter of the blur in pixels for C_d = 1 rad.
    """

    lens: Lens
    focused: Pupil
    unit: float
    pitch: float
    spectra: Sequence[Spectrum]
    curves: Blurs

    @classmethod
    def of(cls, lens: Lens, pixel: float, spectra: Sequence[Spectrum]) -> Self:
        """Return the search by the blur of the middle channel."""
        unit, pitch = _pixels_per_radian(lens, pixel)
        focused = changed(lens.pupil(math.inf), -float(lens.defocus(math.inf)), 0.0)
        return cls(lens, focused, unit, pitch, spectra, defocused(focused, spectra[len(spectra) // 2], pitch))

    def whole(self, blur: UniformBlur, plane: Array, variance: Array) -> tuple[UniformBlur, SceneEstimate]:
        """Return the blur of one distance, and the distance, by the light and noise variance of a channel."""
        found = self._found(plane, variance)
        return self._blur(blur.shape, found), SceneEstimate(found, *self._distances(found))

    def blocks(
        self, blur: UniformBlur, whole: SceneEstimate, plane: Array, variance: Array
    ) -> tuple[TiledBlur, SceneEstimate] | None:
        """Return the blurs and distances of overlapping blocks, or None if they have the same distance."""
        tiles = tiles_of(blur.shape, _BLOCK, _BLOCK)
        if len(tiles) < 2:
            return None
        found = [self._found(*(values[tile.rows, tile.columns] for values in (plane, variance))) for tile in tiles]
        size, error = np.array([(math.log(each.diameter), each.error) for each in found if each.known]).T.reshape(
            2, -1
        )
        if len(size) < 2 or np.mean(((size - np.average(size, weights=error**-2)) / error) ** 2) < _VARIES:
            return None
        parts, blocks = [], []
        for tile, each in zip(tiles, found, strict=True):
            # A block whose blur is not known is not deblurred.
            of_tile = UniformBlur(tile.share.shape, lambda f: np.ones((blur.channels, *f.shape)), 0.0)
            parts.append((tile, self._blur(tile.share.shape, each) if each.known else of_tile))
            distances, errors = self._distances(each) if each.known else ((), ())
            row, column = ((part.start + part.stop) // 2 for part in (tile.rows, tile.columns))
            block = {"row": row, "column": column, "blur_pixels": each.diameter if each.known else None}
            blocks.append(block | {"distances": distances, "distance_errors": errors})
        return TiledBlur(blur.shape, parts), whole._replace(distances=(), errors=(), blocks=tuple(blocks))

    def _found(self, plane: Array, variance: Array) -> BlurEstimate:
        return estimate_blur(self.curves, self.lens.aberrations.flat, self.unit, plane, variance)

    def _blur(self, shape: tuple[int, int], found: BlurEstimate) -> UniformBlur:
        return UniformBlur.of(shape, changed(self.focused, found.value, 0.0), self.pitch, self.spectra)

    def _distances(self, found: BlurEstimate) -> tuple[tuple[float, ...], tuple[float, ...]]:
        """Return the distances at which the lens has a blur, the likeliest first, and their standard errors."""
        # C_d is linear in 1 / distance.
        infinite = float(self.lens.defocus(math.inf))
        slope = float(self.lens.defocus(1.0)) - infinite
        distances, errors = [], []
        for defocus in (found.value,) if found.sign_known else (found.value, -found.value):
            vergence = (defocus - infinite) / slope
            if vergence > 0.0:
                distances.append(1.0 / vergence)
                errors.append(abs(defocus * found.error / slope) / vergence**2)
        return tuple(distances), tuple(errors)


def _pixels_per_radian(lens: Lens, pixel: float) -> tuple[float, float]:
    """Return the diameter of the geometric blur, in pixels, for a defocus C_d of 1 rad, and the pixel pitch."""
    require_round("lens", lens)
    pitch = validation.pixel(pixel, metric=True)
    unit = lens.wavelength * lens.working_f_number
    validation.pixel_on(pitch, unit, metric=True)
    return 8.0 / math.pi * unit / pitch, pitch


def _compared(observed: PhotographLikelihood, light: Values) -> tuple[Array, Array, Array]:
    """Return light and noise variance of the middle channel of a photograph, and its restored `light`."""
    restored = light.reshape(*observed.blur.shape, -1)[..., observed.blur.channels // 2]
    return *_middle(observed, observed.blurred(light)), np.asarray(restored, dtype=np.float64)


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
