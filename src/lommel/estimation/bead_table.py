"""Table of beads for a facility: widths by the fitted PSF and by Gaussians, heights, focal surface, chromatic shifts.

A row is a mapping from the names of quantities to numbers in SI units (None: unknown); the standard error of
"fwhm_x" is "fwhm_x_error". "fwhm_x_common" is the part of it that all beads of a fit share.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from contextlib import suppress
from typing import Any, NamedTuple, TypeAlias

import numpy as np
import scipy

from lommel.base.arrays import Array
from lommel.estimation.beads import BeadFit, FittedBead
from lommel.estimation.star_images import label
from lommel.fit.findings import Findings
from lommel.fit.goodness_of_fit import largest_plausible_chi2
from lommel.recorded.noise import Noise

Row: TypeAlias = dict[str, Any]

_AXES = "zyx"  # of a stack
_STEP = 1e-4  # relative step of differences of the Jacobian of a Gaussian
_LEAST = 6  # smallest number of points of a profile to which a Gaussian is fitted
_RIVAL_SIGMAS, _MOST_RIVALS = 2.5, 12  # voxels that may be the brightest: largest distance, and number
_PAIR = 1e-6  # metres: largest distance of the images of a bead in two channels
MEASURES: Mapping[str, tuple[str, str, float]] = {
    "fwhm_x": ("FWHM x, PSF", "nm", 1e9), "fwhm_y": ("FWHM y, PSF", "nm", 1e9), "fwhm_z": ("FWHM z, PSF", "nm", 1e9),
    "gauss_x": ("FWHM x, Gaussian", "nm", 1e9), "gauss_y": ("FWHM y, Gaussian", "nm", 1e9),
    "gauss_z": ("FWHM z, Gaussian", "nm", 1e9), "asymmetry": ("lateral asymmetry", "", 1.0),
    "strehl": ("Strehl ratio", "", 1.0), "rms": ("wavefront rms", "waves", 0.5 / math.pi),
    "height": ("relative height", "nm", 1e9), "focus": ("focus", "nm", 1e9), "z": ("z", "nm", 1e9),
}  # fmt: skip
"""Quantities of a bead with standard errors: words, unit, and the factor from SI units."""


def gaussian_fit(profile: Array, variance: Array) -> tuple[Array, Array]:
    """Return the least-squares Gaussian of a profile and its covariance: background, height, centre, deviation.

    Weights are equal, as in programs that measure PSFs, so that errors follow from the variance of the noise by the
    implicit function theorem, also where the profile is no Gaussian (a sandwich, with the whole Hessian).

    Parameters
    ----------
    profile, variance : ndarray, shape (n,)
        Values at steps of 1, NaN where unknown, and variances of their noise.

    Raises
    ------
    ValueError
        If there are too few points, or the profile has no such width.
    """
    x, known = np.arange(len(profile), dtype=float), np.isfinite(profile)
    x, y, variance = x[known], profile[known], variance[known]
    if len(y) < _LEAST or not np.ptp(y) > 0.0:
        raise ValueError("a profile has too few values for a Gaussian")
    low, top = float(np.median(y)), float(y.max())
    low = min(low, top - 0.1 * float(np.ptp(y)))
    wide = max(1.0, float((y > 0.5 * (low + top)).sum())) / 2.355

    def jacobian(p: Array) -> Array:
        u = (x - p[2]) / p[3]
        bell = np.exp(-0.5 * u * u)
        return np.stack([np.ones_like(u), bell, p[1] * bell * u / p[3], p[1] * bell * u * u / p[3]], axis=1)

    def residual(p: Array) -> Array:
        return np.asarray(p[0] + p[1] * np.exp(-0.5 * ((x - p[2]) / p[3]) ** 2) - y)

    start = np.array([low, top - low, x[y.argmax()], wide])
    found = scipy.optimize.least_squares(
        residual, start, jacobian, method="lm", x_scale=np.maximum(np.abs(start), 1.0)
    )
    p = found.x * [1.0, 1.0, 1.0, np.sign(found.x[3])]
    if not found.success or p[1] <= 0.0 or not x[0] < p[2] < x[-1] or 2.355 * p[3] > np.ptp(x):
        raise ValueError("a profile is wider than the stack, or has no maximum in it")
    slope, rest = jacobian(p), residual(p)
    hessian, steps = slope.T @ slope, _STEP * np.array([p[1], p[1], p[3], p[3]])
    for k, step in enumerate(np.diag(steps)):
        hessian[k] += rest @ (jacobian(p + step) - jacobian(p - step)) / (2.0 * steps[k])
    influence = np.linalg.solve(hessian, slope.T)
    return p, np.asarray((influence * variance) @ influence.T)


class Widths(NamedTuple):
    """Gaussians along z, y and x: full widths at half maximum and centres, with standard errors, (3,)."""

    fwhm: Array
    fwhm_errors: Array
    centers: Array
    center_errors: Array


def gaussian_widths(bead: FittedBead, noise: Noise) -> Widths:
    """Return the Gaussians of a bead along z, y and x, in planes and pixels, NaN where there is none.

    Lines run through the brightest voxel of the fitted model, which noise moves less than that of the images.
    Where other voxels may be the brightest, errors include the differences between lines of the model.
    """
    place = np.unravel_index(int(np.argmax(bead.model)), bead.model.shape)
    light = noise.electrons(bead.model)
    variance = noise.variance(np.maximum(light, 0.0))
    electrons = np.where(np.isfinite(bead.images), bead.images, bead.model)
    values = np.where(np.isfinite(bead.images), noise.electrons(electrons), np.nan)
    found = _lines(values, variance, place)
    of_model = _lines(light, variance, place)[::2]
    for rival, share in _rivals(light, variance, bead.flux_errors / bead.flux, place):
        change = _lines(light, variance, rival)[::2] - of_model
        found[1::2] = np.hypot(found[1::2], math.sqrt(share) * np.nan_to_num(change))
    return Widths(*found)


def _lines(values: Array, variance: Array, place: Sequence[Any]) -> Array:
    """Return widths, their errors, centres and their errors of Gaussians along three lines, (4, 3)."""
    scale, found = math.sqrt(8.0 * math.log(2.0)), np.full((4, 3), math.nan)
    for axis in range(3):
        line = tuple(slice(None) if k == axis else index for k, index in enumerate(place))
        try:
            p, covariance = gaussian_fit(values[line], variance[line])
        except ValueError:
            continue
        found[:, axis] = scale * p[3], scale * math.sqrt(covariance[3, 3]), p[2], math.sqrt(covariance[2, 2])
    return found


def _rivals(
    light: Array, variance: Array, flux_errors: Array, place: Sequence[Any]
) -> list[tuple[tuple[int, ...], float]]:
    """Return voxels other than the brightest of the model that may be the brightest, and their probabilities.

    Noise moves the image along each axis by the inverse root of its Fisher information, and changes the flux of each
    plane by `flux_errors`, relative.
    """
    slopes = np.array(np.gradient(light))
    moves = np.sum(slopes**2 / variance, axis=(1, 2, 3)) ** -0.5
    here = tuple(int(index) for index in place)
    changes = (slopes - slopes[:, here[0], here[1], here[2]][:, None, None, None]) * moves[:, None, None, None]
    planes = np.nan_to_num(flux_errors)[:, None, None] * light
    apart = np.where(np.arange(len(light)) == here[0], 0.0, 1.0)[:, None, None]
    errors = np.sqrt((changes**2).sum(axis=0) + apart * (planes**2 + planes[here] ** 2))
    ratios = (light[here] - light) / np.maximum(errors, 1e-12 * light[here])
    near = np.argwhere(ratios < _RIVAL_SIGMAS)
    shares = scipy.special.ndtr(-ratios[tuple(near.T)])
    odds = {tuple(voxel): share / (1.0 - share) for voxel, share in zip(near.tolist(), shares.tolist(), strict=True)}
    odds[here] = 1.0
    total = sum(odds.values())
    likely = sorted(
        ((voxel, weight / total) for voxel, weight in odds.items() if voxel != here), key=lambda one: -one[1]
    )
    return likely[:_MOST_RIVALS]


def heights(covariance: Array, z: Array, groups: Sequence[object]) -> tuple[Array, Array]:
    """Return heights of beads relative to the mean of their group, and their standard errors, (beads,).

    Errors of the microscope, common to all beads, cancel. `covariance` is that of `z`; NaN for beads without one.
    """
    used, found = np.isfinite(np.diag(covariance)), np.full((2, len(z)), math.nan)
    for group in dict.fromkeys(groups):
        k = [j for j, one in enumerate(groups) if one == group and used[j]]
        if len(k) > 1:
            centred = np.eye(len(k)) - 1.0 / len(k)
            found[0, k] = centred @ z[k]
            found[1, k] = np.sqrt(np.maximum(np.diag(centred @ covariance[np.ix_(k, k)] @ centred), 0.0))
    return found[0], found[1]


def place_of(bead: FittedBead, fit: BeadFit, pixel: float, corner: tuple[int, int]) -> Row:
    """Return the place of the fitted PSF of a bead in the image and on the stage; None where it is not known.

    Places are "x_psf", "y_psf" and "z", metres. For `pixel` and `corner` see :func:`row_of`.
    """
    row = Row()
    for name, value, unit, error, covariance in (
        ("x_psf", corner[1] + bead.column, pixel, bead.errors.get("column"), fit.column_covariance),
        ("y_psf", corner[0] + bead.row, pixel, bead.errors.get("row"), fit.row_covariance),
        ("z", bead.z, 1.0, bead.errors.get("z"), fit.z_covariance),
    ):
        known = error is not None and math.isfinite(error) and (name == "z" or fit.converged)
        common = unit * common_error(covariance) if known else None
        row |= {name: unit * value if known or name == "z" else None}
        row |= {f"{name}_error": unit * error if known and error is not None else None, f"{name}_common": common}
    return row


def common_error(covariance: Array) -> float:
    """Return the standard error that all beads share: the root of the mean covariance of two of them."""
    used = np.isfinite(np.diag(covariance))
    known, count = covariance[np.ix_(used, used)], int(used.sum())
    return math.sqrt(max(float(known.sum() - np.trace(known)), 0.0) / max(count * (count - 1), 1))


def middle_of(rows: Sequence[Row]) -> tuple[float, float]:
    """Return the mean of x and of y of beads, metres; 0 if none is known."""
    known = [(row["x"], row["y"]) for row in rows if None not in (row.get("x"), row.get("y"))]
    x, y = np.mean(known, axis=0).tolist() if known else (0.0, 0.0)
    return x, y


def focal_surface(rows: Sequence[Row], middle: tuple[float, float]) -> dict[str, Any] | None:
    """Return tilt (radians) and curvature (1 / m) of the surface z = a + b x + c y + d (x^2 + y^2) / 2, with errors.

    z are the heights of rows, each image has its own a, and x and y count from `middle`, metres in the sample. Errors
    are larger by the root of chi2 where heights scatter more than their errors: beads that lie at several heights.
    None for too few beads.
    """
    known = [row for row in counted(rows) if None not in map(row.get, ("height", "x", "y"))]
    files = Counter(row["file"] for row in known)
    x, y = (np.array([row[key] for row in known]) - origin for key, origin in zip("xy", middle, strict=True))
    reach = max(float(np.hypot(x, y).max(initial=0.0)), 1e-9)
    columns = [np.array([row["file"] == file for row in known], dtype=float) for file in files]
    design = np.stack([*columns, x / reach, y / reach, 0.5 * (x**2 + y**2) / reach**2], axis=1)
    freedom = len(known) - design.shape[1]
    if freedom < 1 or np.linalg.matrix_rank(design) < design.shape[1]:
        return None
    # Heights are differences from the mean of n beads, whose errors are smaller by sqrt(1 - 1 / n).
    shares = np.array([1.0 - 1.0 / files[row["file"]] for row in known])
    errors = np.array([row["height_error"] for row in known]) / np.sqrt(shares)
    whitened, data = design / errors[:, None], np.array([row["height"] for row in known]) / errors
    found, normal = np.linalg.lstsq(whitened, data, rcond=None)[0], np.linalg.inv(whitened.T @ whitened)
    chi2 = float(((data - whitened @ found) ** 2).sum()) / freedom
    units = np.array([1.0 / reach, 1.0 / reach, 1.0 / reach**2])
    values, deviations = found[-3:] * units, np.sqrt(np.diag(normal) * max(1.0, chi2))[-3:] * units
    limit = float(largest_plausible_chi2(math.sqrt(2.0 / freedom)))
    facts: dict[str, Any] = {"chi2": chi2, "limit": limit, "beads": len(known)}
    for name, value, error in zip(
        ("tilt_x", "tilt_y", "curvature"), values.tolist(), deviations.tolist(), strict=True
    ):
        facts |= {name: value, f"{name}_error": error}
    return facts


def row_of(fit: BeadFit, noise: Noise, step: float, pixel: float, corner: tuple[int, int] = (0, 0)) -> Row:
    """Return the row of a bead from the fit of it alone: widths, Strehl ratio, wavefront, Gaussians.

    Widths by the PSF, terms and Strehl ratio are None where the fit did not converge. `step` of the stage and `pixel`
    in the sample are as stated, metres, and `corner` is the first pixel of the window. "focus" is a stage position.
    """
    bead, row = fit.beads[0], dict[str, Any]()
    keys = "fwhm_x", "fwhm_y", "fwhm_z", "strehl", "rms"
    pairs: dict[str, tuple[float, float]] = {}
    if fit.converged and bead.used:
        try:
            widths, errors = fit.fwhm(depth=bead.depth)
        except ValueError:  # strong aberrations have no single focus
            pass
        else:
            pairs = dict(zip(keys, zip(widths.tolist(), errors.tolist(), strict=True), strict=False))
            pairs["strehl"] = fit.strehl(depth=bead.depth)
        names = [name for name in fit.coefficients if not isinstance(name, str)]
        pairs["rms"] = rms, _ = fit.rms(depth=bead.depth)
        # Noise increases each rms: more beads do not reduce that.
        noise_part = fit.wavefront_variance
        row |= {"strehl_common": noise_part, "rms_common": rms - math.sqrt(max(rms**2 - noise_part, 0.0))}
        pairs |= {label(n): (fit.coefficients[n], fit.errors[n]) for n in names}
    gaussians = gaussian_widths(bead, noise)
    units = np.array([abs(step), pixel, pixel])
    for k, axis in enumerate(_AXES):
        pairs[f"gauss_{axis}"] = units[k] * gaussians.fwhm[k], units[k] * gaussians.fwhm_errors[k]
    (_, y, x), (_, y_error, x_error) = gaussians[:2]
    ratio = min(x, y) / max(x, y)
    pairs["asymmetry"] = ratio, ratio * math.hypot(x_error / x, y_error / y)
    middle = gaussians.centers - [len(bead.images) // 2, -corner[0], -corner[1]]
    for k, name in enumerate(("focus", "y", "x")):
        pairs[name] = (step if k == 0 else pixel) * middle[k], units[k] * gaussians.center_errors[k]
    for name in (*keys, *pairs):
        value, error = pairs.get(name, (math.nan, math.nan))
        known = math.isfinite(value) and math.isfinite(error)
        row |= {name: float(value) if known else None, f"{name}_error": float(error) if known else None}
    reasons = "; ".join(str(finding) for finding in fit.findings if finding.severity != "note")
    verdict = fit.status if bead.used else "left out"
    return row | {"chi2": bead.chi2, "verdict": verdict, "reason": reasons or None, "codes": codes_of(fit.findings)}


def codes_of(findings: Findings) -> str | None:
    """Return what errors and doubts are, in a few words: their codes; None without one."""
    codes = dict.fromkeys(one.code.replace("_", " ") for one in findings if one.severity != "note")
    return ", ".join(codes) or None


def with_shared(row: Row, fit: BeadFit, depth: float) -> Row:
    """Return a row with the part of its errors that beads share whose constants are those of a joint fit.

    It is the standard error of that fit at `depth`, of widths, Strehl ratio and wavefront.
    """
    shared = Row()
    with suppress(ValueError):  # strong aberrations have no single focus
        errors = dict(zip(("fwhm_x", "fwhm_y", "fwhm_z"), fit.fwhm(depth=depth)[1].tolist(), strict=True))
        errors |= {"strehl": fit.strehl(depth=depth)[1], "rms": fit.rms(depth=depth)[1]}
        shared = {
            f"{name}_common": math.hypot(error, row.get(f"{name}_common") or 0.0)
            for name, error in errors.items() if row[name] is not None and math.isfinite(error)
        }  # fmt: skip
    return row | shared


def counted(rows: Sequence[Row]) -> list[Row]:
    """Return the beads that count in means: not left out nor refused, and with a fitted PSF, if any of their fit has.

    Gaussian widths and those of the PSF are then of the same beads. Beads of one fit have a date and a wavelength.
    """
    kept = [row for row in rows if row.get("verdict") not in ("left out", "refused")]
    fitted = {(row.get("date"), row.get("wavelength")) for row in kept if row.get("fwhm_x") is not None}
    return [
        row for row in kept if row.get("fwhm_x") is not None or (row.get("date"), row.get("wavelength")) not in fitted
    ]


def summary(rows: Sequence[Row], names: Sequence[str]) -> list[Row]:
    """Return for each quantity the mean over beads, its error, their spread, and the rms of their standard errors.

    Few beads may be nearer to each other than their errors allow, and the part that they share does not average out.
    """
    found = []
    for name in names:
        values = [row[name] for row in rows if row.get(name) is not None]
        errors, shared = (
            [row.get(f"{name}_{part}") or 0.0 for row in rows if row.get(name) is not None]
            for part in ("error", "common")
        )
        if values:
            spread = float(np.std(values, ddof=1)) if len(values) > 1 else None
            error, common = (float(np.sqrt(np.mean(np.square(part)))) for part in (errors, shared))
            own = max(spread or 0.0, math.sqrt(max(error**2 - common**2, 0.0))) / math.sqrt(len(values))
            facts = {"mean": float(np.mean(values)), "mean_error": math.hypot(own, common)}
            found.append({"name": name, "beads": len(values), **facts, "spread": spread, "error": error})
    return found


def chromatic_shifts(rows: Sequence[Row]) -> list[Row]:
    """Return the shifts of beads between two channels: rows of different wavelengths.

    Beads of one date at one place of the field are the same bead. Shifts are those of the longer wavelength relative
    to the shortest, metres: of the places of the fitted PSFs, "shift_x_psf", and of the centres of Gaussians,
    "shift_x". The latter have no standard errors: with aberrations they move with the place of a bead in its pixel
    and plane by more than noise does.
    """
    rows = [row for row in counted(rows) if None not in (row.get("x"), row.get("y"))]
    waves, found = sorted({row["wavelength"] for row in rows}), list[Row]()
    for row in rows:
        if row["wavelength"] != waves[0]:
            continue
        for wave in waves[1:]:
            others = [
                (math.hypot(*(other[k] - row[k] for k in ("x", "y"))), j)
                for j, other in enumerate(rows)
                if other["wavelength"] == wave and other["date"] == row["date"]
            ]
            distance, j = min(others, default=(math.inf, 0))
            if distance > _PAIR:
                continue
            pair: Row = {"bead": row["bead"], "date": row["date"], "wavelengths": (waves[0], wave)}
            pair |= {k: row[k] for k in ("x", "y")}
            ends = row, rows[j]
            for axis, key in (("x", "x"), ("y", "y"), ("z", "focus"), ("x_psf",) * 2, ("y_psf",) * 2, ("z_psf", "z")):
                parts = ("error", "common") if axis.endswith("psf") else ()
                if None in (one.get(name) for one in ends for name in (key, *(f"{key}_{part}" for part in parts))):
                    continue
                pair[f"shift_{axis}"] = rows[j][key] - row[key]
                for part in parts:
                    pair[f"shift_{axis}_{part}"] = math.hypot(*(one[f"{key}_{part}"] for one in ends))
            found.append(pair)
    return found
