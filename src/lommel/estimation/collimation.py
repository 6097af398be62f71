"""Collimation from one defocused star: coma, astigmatism and spherical aberration, with directions in the picture."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.blur.blurs import Motion
from lommel.estimation import EFFORT
from lommel.estimation.options import RetrieveOptions
from lommel.estimation.phase_retrieval import Retrieval, fit_stars
from lommel.fit.findings import Finding, Findings, Severity
from lommel.fit.model_error import MAX_PHASE_ERROR, shared_error
from lommel.optics.lens import Lens
from lommel.recorded.camera_noise import hot_voxels, image_noise, measured_noise
from lommel.recorded.counts import Counts, flat_top
from lommel.recorded.noise import Noise

_LEVEL = 0.05  # brightness of the outline of a star, relative to its brightest part
# Least brightness of a star, and of its outline, standard deviations of the smoothed background.
_MIN_HEIGHT, _MIN_OUTLINE = 8.0, 4.0
_MIN_RADIUS = 6.0  # pixels: least radius of a star
_MIN_WAVES, _MAX_WAVES = 1.5, 60.0  # least and largest defocus, waves between centre and edge
_BINNED_RADIUS = 14.0  # pixels: least radius of a star after binning; errors of 20 simulated stars hardly grow
_ROOM = 1.4  # half a side of the window, radii of the star
_READ = 1.6  # electrons rms: read noise, which one picture does not separate from the offset
_SHARPEST = 1.0  # brightest pixel of a donut, relative to its brightest neighbour
_MOST_SPREAD = 1.19  # largest moment of inertia of an outline, relative to a disc of its area: two in touch have 1.24
_MOST_SATURATED = 0.05  # largest part of the outline that may be saturated without a doubt
_TOLD = 5.0  # brightness, standard deviations of the noise, from which photon noise must be seen
_SIGNIFICANT = 3.0  # standard errors from which an aberration has a direction
# Part of the light that the model may miss because of turbulence: of 60 phase screens 3 %, of 10 8 %.
_MOST_TURBULENT = 0.05
_QUIETEST = 0.7  # least chi2 of residuals from which the noise is estimated once more
# Least difference of an f-number that was estimated from that stated, standard errors and relative, which is a doubt.
_OTHER_SCALE = 5.0, 0.05
# Doubts whose size the standard errors contain: they are notes.
_CONTAINED = {"missed_light", "other_explanation", "rare_chi2", "sign_open"}
_WAVE = 2.0 * math.pi  # radians
_RING = np.array([[1, 1, 1], [1, 0, 1], [1, 1, 1]])


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
    drift : (float, float) or None
        Length of the trail of the star, pixels, and its angle from columns to rows, radians; None if none is seen.
    steady : float
        Part of the standard errors that pictures of this telescope share, waves rms: effects that the model lacks.
    fit : Retrieval
        The fit, with findings on the picture; doubts that the standard errors contain are notes.
    """

    coma: Vector
    components: complex
    astigmatism: Vector
    spherical: tuple[float, float]
    waves: float
    star: Star
    drift: tuple[float, float] | None
    steady: float
    fit: Retrieval


def find_star(image: Array) -> Star:
    """Return the outline of the brightest star of a picture, NaN at saturated pixels; ValueError without one."""
    border = np.concatenate([image[0], image[-1], image[:, 0], image[:, -1]])
    light = np.where(np.isfinite(image), image, np.nanmax(image)) - np.nanmedian(border)
    light = np.minimum(light, scipy.ndimage.maximum_filter(light, footprint=_RING))  # without single hot pixels
    smooth = scipy.ndimage.gaussian_filter(light, 1.5)
    noise = 1.5 * float(np.median(np.abs(smooth - np.median(smooth))))
    level, least = _LEVEL * float(smooth.max()), _MIN_OUTLINE * noise
    labels, count = scipy.ndimage.label(smooth > max(level, least))
    if not count or smooth.max() < _MIN_HEIGHT * noise:
        raise ValueError("the picture must show a star, got none above the noise")
    brightest = 1 + int(np.argmax(scipy.ndimage.sum_labels(smooth, labels, np.arange(1, count + 1))))
    disc = labels == brightest
    if any(edge.any() for edge in (disc[0], disc[-1], disc[:, 0], disc[:, -1])):
        raise ValueError("the star must be inside the picture, got one at an edge: move it, or defocus less")
    places = _convex(np.argwhere(disc))  # the dim side of a ring may be open
    radius = math.sqrt(len(places) / math.pi)
    if radius < _MIN_RADIUS:
        raise ValueError(
            f"the star must have a radius of {_MIN_RADIUS:g} pixels or more, got {radius:.1f}: defocus more"
        )
    # Of a dim star, only the bright side may be above the noise.
    if level > least and 2.0 * places.var(axis=0).sum() > _MOST_SPREAD * radius**2:
        raise ValueError(
            "the star must be alone and round, got a long outline: another star touches it, or it drifts"
        )
    row, column = places.mean(axis=0).tolist()
    return Star(row, column, radius)


def _convex(places: NDArray[np.intp]) -> NDArray[np.intp]:
    """Return rows and columns (n, 2) of all pixels between pixels of a blob."""
    low, high = places.min(axis=0), places.max(axis=0) + 1
    if (high - low).min() < 3:
        return places
    grid = np.argwhere(np.ones(high - low, bool)) + low
    hull = places[scipy.spatial.ConvexHull(places).vertices]
    inside: NDArray[np.bool_] = scipy.spatial.Delaunay(hull).find_simplex(grid) >= 0
    return np.asarray(grid[inside])


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
    if waves > _MAX_WAVES:
        raise ValueError(
            f"the star must be {_MAX_WAVES:g} waves or less out of focus, got {waves:.2g} by the stated pixel, "
            f"f/{lens.f_number:.3g} and wavelength: correct the aperture, focal length or pixel, or defocus less"
        )
    reach = math.ceil(_ROOM * star.radius + 4.0)
    rows, columns = (slice(max(round(p) - reach, 0), round(p) + reach + 1) for p in (star.row, star.column))
    counts, step, findings = _binned(image[rows, columns], star.radius)
    side = -1.0 if outside else 1.0
    options = RetrieveOptions(terms=8, defocus=(side * math.pi * waves,), blur=True)  # Noll 4 to 11
    effort = EFFORT._replace(starts=1, tol=1e-4)
    fit = fit_stars(counts, lens.pupil(), pixel=step * pixel, noise=None, options=options, effort=effort)
    if "too_quiet" in fit.findings.codes and fit.chi2 > _QUIETEST:
        # One dim picture determines its noise by little: residuals do better.
        counts = Counts.of(counts.values / fit.chi2, noise=Noise(read=step * _READ))
        fit = fit_stars(counts, lens.pupil(), pixel=step * pixel, noise=None, options=options, effort=effort)
    value, error = ({n: part[n] / _WAVE for n in fit.coefficients} for part in (fit.coefficients, fit.errors))
    # Larger errors are those of phases in which images are not linear.
    contained = _CONTAINED if math.hypot(*error.values()) < MAX_PHASE_ERROR / _WAVE else _CONTAINED - {"missed_light"}
    defocus = side * waves + math.sqrt(12.0) * value[2, 0]
    steady = 0.0  # waves rms: effects of the telescope that the model lacks
    for found in fit.findings:
        if found.code == "missed_light" and (missed := found.numbers.get("missed", 0.0)) > _MOST_TURBULENT:
            steady = shared_error(missed, abs(defocus))
            text = (
                f"the model misses {100.0 * missed:.2g} % of the light, more than averaged turbulence; vanes, "
                f"obscuration or mirrors other than stated may move each aberration by {steady:.2g} waves, which "
                "errors include: expose longer, or state them"
            )
            findings.append(Finding("missed_light", "doubt", text, {**found.numbers, "waves": steady}))
            continue
        if found.code == "estimated" and "f_number" in found.numbers:
            findings += _other_scale(**found.numbers["f_number"])
        is_contained = found.code in contained and found.severity == "doubt"
        if found.code != "left_out":  # of bins
            findings.append(replace(found, severity="note") if is_contained else found)
    if not fit.converged:
        left = np.nan_to_num(fit.images - fit.model)
        light = fit.model - fit.background[:, None, None]
        variance = fit.model + (step * _READ) ** 2
        excess = float((left**2).sum()) - float(variance[np.isfinite(fit.images)].sum())
        missed = math.sqrt(max(excess, 0.0) / float((light**2).sum()))
        text = (
            f"the model misses {100.0 * missed:.2g} % of the light: turbulence that is not averaged, another star, "
            "or vanes and an obscuration that are not as stated"
        )
        findings.append(Finding("missed_light", "note", text, {"missed": missed}))
    fit = replace(fit, findings=Findings(findings))
    error = {n: math.hypot(part, steady) for n, part in error.items()}
    trail = next((blur for blur in fit.blurs[0] if isinstance(blur, Motion)), None)
    coma = complex(value[3, 1], value[3, -1])
    # Inside focus, rays go outwards where the phase increases outwards: the star is longer there.
    longer = side * complex(value[2, 2], value[2, -2])
    return Collimation(
        coma=Vector.of(coma, max(error[3, 1], error[3, -1])),
        components=coma,
        astigmatism=Vector.of(longer, max(error[2, 2], error[2, -2]), 2),
        spherical=(value[4, 0], error[4, 0]),
        waves=defocus,
        star=star,
        drift=None if trail is None else (trail.length / pixel, trail.angle),
        steady=steady,
        fit=fit,
    )


def _other_scale(value: float, error: float, stated: float) -> list[Finding]:
    """Return the doubt on an f-number other than that of aperture and focal length, if it differs."""
    if abs(value - stated) < max(_OTHER_SCALE[0] * error, _OTHER_SCALE[1] * stated):
        return []
    text = (
        f"the star fits f/{value:.3g} +- {error:.1g}, but f/{stated:.3g} is stated: pixel, focal length, aperture or "
        f"wavelength is off by a factor of {stated / value:.3g}; if it is the wavelength, sizes change by as much"
    )
    return [Finding("contradiction", "doubt", text, {"value": value, "error": error, "stated": stated})]


def _binned(window: Array, radius: float) -> tuple[Counts, int, list[Finding]]:
    """Return a window in electrons, in square bins if the star has many pixels; the side of a bin; findings."""
    findings, window = list[Finding](), window.copy()
    # Of the noise by medians, which hot pixels leave.
    offset, bright = np.nanquantile(window, (0.05, 0.9)).tolist()
    differences = np.diff(window, 2, axis=1)
    sigma = max(
        float(np.nanmedian(np.abs(differences))) / (0.6745 * math.sqrt(6.0)), 1e-9 * (bright - offset), 1e-300
    )
    white = (bright - offset) / sigma**2 or 1.0
    hot = hot_voxels(window[None], Noise(white=white, read=white * sigma, offset=offset), _SHARPEST)
    if len(hot):
        window[hot[:, 1], hot[:, 2]] = np.nan
        text = f"{len(hot)} hot pixel{'s' * (len(hot) > 1)} left out"
        findings.append(Finding("hot_pixels", "note", text, {"pixels": len(hot)}))
    known = np.isfinite(window)
    try:
        noise, _ = measured_noise(window[None], _READ)
    except ValueError:  # no photon noise is seen
        offset = float(np.nanmin(window))
        light, variance, _ = image_noise(window - offset)
        noise = Noise(white=light / variance, read=_READ, offset=offset)
        if np.nanquantile(window, 0.9) - np.nanquantile(window, 0.1) > _TOLD * math.sqrt(variance):
            text = (
                "noise does not grow with the light, as it does in counts: values are stretched (sRGB, a gamma), "
                "filtered or of many exposures"
            )
            findings.append(Finding("contradiction", "doubt", text))
    assert noise.white is not None
    top, _ = flat_top(window, known, noise)
    window = np.where(window >= top, np.nan, window)  # no pixel if top is NaN
    if saturated := int(np.isnan(window).sum()) - len(hot):
        share = saturated / (math.pi * radius**2)
        text = f"{saturated} saturated pixels ({100.0 * share:.2g} % of the star) left out"
        text += ": expose shorter" * (share > _MOST_SATURATED)
        severity: Severity = "doubt" if share > _MOST_SATURATED else "note"
        findings.append(Finding("left_out", severity, text, {"pixels": saturated, "share": share}))
    step = max(1, int(radius / _BINNED_RADIUS))
    rows, columns = (side // step for side in window.shape)
    parts = ((window - noise.offset) * noise.white)[: rows * step, : columns * step]
    binned = parts.reshape(rows, step, columns, step).sum(axis=(1, 3))
    return Counts.of(binned, noise=Noise(read=step * _READ)), step, findings


def mean_coma(components: Sequence[complex], errors: Sequence[float], steady: Sequence[float] = ()) -> Vector:
    """Return the mean coma of several pictures; its error is at least that of their scatter.

    The mean does not reduce the part `steady` of the errors, which the pictures share.
    """
    values, count = np.array(components), len(components)
    mean, shared = complex(values.mean()), math.hypot(*steady) / math.sqrt(max(len(steady), 1))
    error = math.sqrt(max(math.hypot(*errors) ** 2 - count * shared**2, 0.0)) / count
    if count > 1:
        error = max(error, math.sqrt(float((np.abs(values - mean) ** 2).sum()) / (2.0 * count * (count - 1))))
    return Vector.of(mean, math.hypot(error, shared))
