"""Collimation from one defocused star: coma, astigmatism and spherical aberration, with directions in the picture."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import scipy

from lommel.base.arrays import Array
from lommel.estimation import EFFORT
from lommel.estimation.options import RetrieveOptions
from lommel.estimation.phase_retrieval import Retrieval, fit_stars
from lommel.optics.lens import Lens
from lommel.recorded.camera_noise import image_noise, measured_noise
from lommel.recorded.counts import Counts
from lommel.recorded.noise import Noise

_LEVEL = 0.08  # brightness of the outline of a star, relative to its brightest part
_MIN_HEIGHT = 8.0  # least brightness of the outline, standard deviations of the smoothed background
_MIN_RADIUS = 6.0  # pixels: least radius of a star
_MIN_WAVES = 1.5  # least defocus, waves between centre and edge
_BINNED_RADIUS = 14.0  # pixels: least radius of a star after binning; errors of 20 simulated stars hardly grow
_ROOM = 1.5  # half a side of the window, radii of the star
_READ = 1.6  # electrons rms: read noise, which one picture does not separate from the offset
_SIGNIFICANT = 3.0  # standard errors from which an aberration has a direction
# Doubts whose size the standard errors contain.
_CONTAINED = {"missed_light", "other_explanation", "rare_chi2", "sign_open"}
_WAVE = 2.0 * math.pi  # radians


class Star(NamedTuple):
    """Outline of a defocused star: row and column of its centre, and its radius, pixels."""

    row: float
    column: float
    radius: float


class Vector(NamedTuple):
    """Size of an aberration (waves rms), angle from columns to rows (radians), and their standard errors."""

    size: float
    error: float
    angle: float | None  # None if the size is not significant
    angle_error: float

    @classmethod
    def of(cls, value: complex, error: float, folds: int = 1) -> Vector:
        """Return the vector with the components along cosine and sine of `folds` times the angle."""
        size = abs(value)
        angle = cmath.phase(value) / folds if size >= _SIGNIFICANT * error else None
        return cls(size, error, angle, error / max(size, error, 1e-12) / folds)


class Collimation(NamedTuple):
    """Aberrations from a defocused star.

    Attributes
    ----------
    coma : Vector
        The tail of the star in focus points along its angle; the defocused star is narrow and bright opposite to it.
    components : complex
        Components of coma along columns and rows, waves rms (Noll 8 and 7).
    astigmatism : Vector
        The defocused star is longer along its angle.
    spherical : (float, float)
        Noll 11, waves rms, and its standard error.
    waves : float
        Defocus, waves between centre and edge, positive inside focus.
    star : Star
    fit : Retrieval
    """

    coma: Vector
    components: complex
    astigmatism: Vector
    spherical: tuple[float, float]
    waves: float
    star: Star
    fit: Retrieval

    @property
    def reliable(self) -> bool:
        """Whether the fit converged, and standard errors contain its doubts."""
        doubts = {finding.code for finding in self.fit.findings if finding.severity == "doubt"}
        return self.fit.converged and doubts <= _CONTAINED


def find_star(image: Array) -> Star:
    """Return the outline of the brightest star of a picture, NaN at saturated pixels; ValueError without one."""
    border = np.concatenate([image[0], image[-1], image[:, 0], image[:, -1]])
    light = np.where(np.isfinite(image), image, np.nanmax(image)) - np.nanmedian(border)
    smooth = scipy.ndimage.gaussian_filter(light, 1.5)
    noise = 1.5 * float(np.median(np.abs(smooth - np.median(smooth))))
    labels, count = scipy.ndimage.label(smooth > max(_LEVEL * float(smooth.max()), _MIN_HEIGHT * noise))
    if not count:
        raise ValueError("the picture must show a star, got none above the noise")
    brightest = 1 + int(np.argmax(scipy.ndimage.sum_labels(smooth, labels, np.arange(1, count + 1))))
    disc = scipy.ndimage.binary_fill_holes(labels == brightest)
    if any(edge.any() for edge in (disc[0], disc[-1], disc[:, 0], disc[:, -1])):
        raise ValueError("the star must be inside the picture, got one at an edge: move it, or defocus less")
    row, column = (float(place) for place in scipy.ndimage.center_of_mass(disc))
    radius = math.sqrt(disc.sum() / math.pi)
    if radius < _MIN_RADIUS:
        raise ValueError(
            f"the star must have a radius of {_MIN_RADIUS:g} pixels or more, got {radius:.1f}: defocus more"
        )
    return Star(row, column, radius)


def measure_collimation(image: Array, lens: Lens, pixel: float, *, outside: bool = False) -> Collimation:
    """Return the aberrations of a telescope from a picture of a defocused star, NaN at saturated pixels.

    `pixel` is in metres. The noise is measured in the picture. One picture does not determine on which side of focus
    it was taken: inside focus, or `outside`. Only the sign of the even terms depends on it: coma, and the direction
    along which the star is longer, are the same.
    """
    star = find_star(image)
    waves = star.radius * pixel / (4.0 * lens.f_number * lens.wavelength)
    if waves < _MIN_WAVES:
        raise ValueError(f"the star must be {_MIN_WAVES:g} waves or more out of focus, got {waves:.2g}: defocus more")
    reach = math.ceil(_ROOM * star.radius + 4.0)
    rows, columns = (slice(max(round(p) - reach, 0), round(p) + reach + 1) for p in (star.row, star.column))
    counts, step = _binned(image[rows, columns], star.radius)
    side = -1.0 if outside else 1.0
    options = RetrieveOptions(terms=8, defocus=(side * math.pi * waves,), blur=True)  # Noll 4 to 11
    effort = EFFORT._replace(starts=1, tol=1e-4)
    fit = fit_stars(counts, lens.pupil(), pixel=step * pixel, noise=None, options=options, effort=effort)
    value, error = ({n: part[n] / _WAVE for n in fit.coefficients} for part in (fit.coefficients, fit.errors))
    coma = complex(value[3, 1], value[3, -1])
    # Inside focus, rays go outwards where the phase increases outwards: the star is longer there.
    longer = side * complex(value[2, 2], value[2, -2])
    return Collimation(
        coma=Vector.of(coma, max(error[3, 1], error[3, -1])),
        components=coma,
        astigmatism=Vector.of(longer, max(error[2, 2], error[2, -2]), 2),
        spherical=(value[4, 0], error[4, 0]),
        waves=side * waves + math.sqrt(12.0) * value[2, 0],
        star=star,
        fit=fit,
    )


def _binned(window: Array, radius: float) -> tuple[Counts, int]:
    """Return a window in electrons, in square bins while the star has many pixels, and the side of a bin."""
    try:
        noise, _ = measured_noise(window[None], _READ)
    except ValueError:  # no photon noise is seen
        offset = float(np.nanmin(window))
        light, variance, _ = image_noise(window - offset)
        noise = Noise(white=light / variance, read=_READ, offset=offset)
    assert noise.white is not None
    step = max(1, int(radius / _BINNED_RADIUS))
    rows, columns = (side // step for side in window.shape)
    parts = ((window - noise.offset) * noise.white)[: rows * step, : columns * step]
    binned = parts.reshape(rows, step, columns, step).sum(axis=(1, 3))
    return Counts.of(binned, noise=Noise(read=step * _READ)), step


def mean_coma(components: Sequence[complex], errors: Sequence[float]) -> Vector:
    """Return the mean coma of several pictures; its error is at least that of their scatter."""
    values, count = np.array(components), len(components)
    mean, error = complex(values.mean()), math.hypot(*errors) / count
    if count > 1:
        error = max(error, math.sqrt(float((np.abs(values - mean) ** 2).sum()) / (2.0 * count * (count - 1))))
    return Vector.of(mean, error)
