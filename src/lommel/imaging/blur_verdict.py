"""Verdict on a stated blur: its likelihood beside that of other defocus, f-number and spherical aberration."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import NamedTuple

import numpy as np
import scipy

from lommel.base.arrays import Array
from lommel.estimation.focal_model import Spectrum, pupil_curve
from lommel.imaging.blur_spectrum import FREQUENCIES, BlurSpectrum
from lommel.measures.transfer import otf
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront

_SCALES = 1.0, 0.6, 0.7, 0.8, 0.9, 0.95, 1.05, 1.1, 1.2, 1.35  # factors of the defocus; the first is as stated
_SPHERICAL = -1.0, -0.5, 0.5, 1.0  # waves of spherical aberration that are compared if another defocus is likelier
_MIN_GAIN, _DECISIVE = 6.0, 20.0  # gains in log-likelihood from which another blur is preferred, and is tested
_LOBES, _NODES = (
    12.0,
    72,
)  # the OTF with spherical aberration is computed at _NODES frequencies up to _LOBES / diameter
_TOL = 1e-4  # of these values


class BlurVerdict(NamedTuple):
    """The most likely of the blurs that were compared with the stated one.

    `factor` multiplies the defocus, `waves` are those of spherical aberration, `gain` is that in log-likelihood, and
    `sharpness` the power that the blur transmits, divided by that of the stated blur.
    """

    factor: float
    waves: float
    gain: float
    sharpness: float

    @property
    def doubtful(self) -> bool:
        """True if the photograph is sharper than stated: its restoration may be farther from the scene than it is."""
        return self.gain > _MIN_GAIN and self.sharpness > 1.0

    @property
    def decisive(self) -> bool:
        """True if the preferred blur may test the result by the stated one."""
        return self.doubtful and self.gain > _DECISIVE

    @property
    def softer(self) -> bool:
        """True if the photograph, or its scene, is softer than stated."""
        return self.gain > _MIN_GAIN and self.sharpness < 1.0

    def applied(self, pupil: Pupil, defocus: float) -> Pupil:
        """Return the preferred pupil, given the stated one and its defocus C_d (rad)."""
        return _changed(pupil, (self.factor - 1.0) * defocus, self.waves)


def compare_blurs(
    pupil: Pupil, defocus: float, spectrum: Spectrum, pixel: float, plane: Array, variance: Array
) -> BlurVerdict:
    """Compare the blur of a pupil, whose defocus is C_d (rad), with others, for one channel of a photograph.

    `variance` is the stated noise variance of each pixel of the `plane`.
    """
    factors = np.array(_SCALES)
    curves = pupil_curve(_changed(pupil, (factors - 1.0) * defocus, 0.0), spectrum, pixel)(FREQUENCIES)
    waves = np.zeros_like(factors)
    rings = BlurSpectrum.windowed(plane[None], variance[None])
    noise = rings.texture(curves[0], 0).noise
    likelihood = rings.likelihood(curves, 0, noise)
    if likelihood.max() - likelihood[0] > _MIN_GAIN:
        # Spherical aberration takes more time: it is compared where the stated blur is not the best one.
        factors, waves = np.append(factors, np.ones(len(_SPHERICAL))), np.append(waves, _SPHERICAL)
        curves = np.concatenate([curves, _spherical(pupil, spectrum, pixel)])
        likelihood = rings.likelihood(curves, 0, noise)
    best = int(np.argmax(likelihood))
    power = np.square(curves[:, : len(FREQUENCIES) // 3]).sum(axis=1)
    gain = float(likelihood[best] - likelihood[0])
    return BlurVerdict(float(factors[best]), float(waves[best]), gain, float(power[best] / power[0]))


def _changed(pupil: Pupil, defocus: float | Array, waves: float | Array) -> Pupil:
    """Return a pupil, or a stack, with more defocus (rad) and spherical aberration (waves)."""
    change = Wavefront(defocus=defocus, spherical=2.0 * math.pi * np.asarray(waves)) if np.any(waves) else None
    return replace(pupil, wavefront=pupil.wavefront + (change or Wavefront(defocus=defocus)))


def _spherical(pupil: Pupil, spectrum: Spectrum, pixel: float) -> Array:
    """Return the OTFs with spherical aberration at FREQUENCIES; frequencies beyond some lobes do not matter."""
    aberrated = _changed(pupil, 0.0, np.array(_SPHERICAL))
    diameter = 2.0 * float(aberrated.geometric_radius().max()) / pixel
    f = np.linspace(0.0, min(FREQUENCIES[-1], _LOBES / max(diameter, 1e-9)), _NODES)
    wavelength = float(np.average([w for w, _ in spectrum], weights=[s for _, s in spectrum]))
    values = otf(aberrated.in_light(wavelength), f / pixel, tol=_TOL).real
    curve = scipy.interpolate.CubicSpline(f, values, axis=1)(np.minimum(FREQUENCIES, f[-1]))
    return np.where(f[-1] >= FREQUENCIES, curve, 0.0)
