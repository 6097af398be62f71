"""Checks of OPD maps and of residuals of fits to them: jumps of waves, outliers, missing terms, noise of terms."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.base.units import percent
from lommel.fit.findings import Finding
from lommel.special import zernike

# A pixel is an outlier if it differs from the median of itself and its eight neighbours at distance 2, so that groups
# of up to 3 x 3 are seen, by this multiple of the typical difference from their mean, by the second multiple of the
# spread of these neighbours, and by the third number in waves (files of few digits).
_OUTLIER, _SPREAD, _LEAST_OUTLIER = 5.5, 4.0, 1e-4
# Jumps between neighbours count from this fraction of a wave on, if they are along this many pixels, relative to the
# square root of all.
_STEP, _STEP_LENGTH = 0.5, 0.15
# Jumps of raw maps are integers of waves within this multiple of the noise of differences, in waves between these
# limits; this fraction of all jumps are, and their mean differs from an integer by at most the last number.
_JUMP_NOISE, _JUMP_LIMITS, _JUMP_SHARE, _JUMP_BIAS = 4.0, (0.02, 0.25), 0.65, 0.05
_WIDEST_GAP = 0.1  # of vanes across which jumps are sought, relative to the side of the map
_WINDOW = 5  # differences, on a side, of whose median a jump is measured from

_CELLS = 48  # cells, on a side, whose mean residuals determine the power of the residual in modes
_MORE_DEGREES = 12  # degrees above those of the fit from which the noise of modes is extrapolated
_NEXT = 4  # degrees next to those of the fit that must have the power of white noise
# Largest fall of the logarithm over the tested degrees: Gaussian, exponential, power.
_MOST_FALL = (12.0, 6.0, 3.0)
_MAX_EXTRAPOLATION = math.log(1e4)  # of the variance of modes of low degrees
# Missing terms: these leave at most that fraction of the squared residual, and terms of still higher degree add less
# than the second number to what they explain.
_LEFT, _SETTLED = 0.5, 1.1
_NEGLIGIBLE = 1e-4  # of the squared residual
_LEAST_STREHL = 0.01  # relative change of a Strehl ratio that is a doubt
_STRUCTURE = 6.0  # standard errors by which neighbours agree more than white noise; 4.6 at most in 3430 drawn maps


def jumps(maps: Array, used: NDArray[np.bool_], wave: float) -> Iterator[Finding]:
    """Yield the finding on jumps of integers of waves between neighbours, also across vanes, of maps (axis 0)."""
    found = max(_jumps_of(np.where(one, raw, np.nan) / wave) for raw, one in zip(maps, used, strict=True))
    if found[0]:
        count, row, column = found
        text = f"the map jumps by an integer of waves between {count} pairs of neighbours, such as at pixel "
        text += f"({row}, {column}), so that terms and rms are those of the jumps: unwrap the phase"
        yield Finding("other_explanation", "error", text, {"pairs": count, "row": row, "column": column})


def _jumps_of(waves: Array) -> tuple[int, int, int]:
    """Return the number of pairs of neighbours between which a map (waves) jumps, and the first place; 0 if none."""
    jumps, places, noise, widths = [], [], [], []
    for axis in (0, 1):
        turned = np.moveaxis(waves, axis, 1)
        rates = np.diff(turned, axis=1)
        rows, columns = np.nonzero(np.isfinite(turned))
        differences, gaps = np.diff(turned[rows, columns]), np.diff(columns)
        near = (np.diff(rows) == 0) & (gaps <= max(1.0, _WIDEST_GAP * turned.shape[1]))
        steep = np.flatnonzero(near & (np.abs(differences) > _STEP))
        half = _WINDOW // 2
        windows = sliding_window_view(np.pad(rates, half, constant_values=np.nan), (_WINDOW, _WINDOW))
        around = windows[rows[steep], np.minimum(columns[steep], rates.shape[1] - 1)].reshape(-1, _WINDOW**2)
        known = np.isfinite(around).sum(axis=1) > half
        slopes = np.nanmedian(around[known], axis=1)
        jumps.append(differences[steep[known]] - slopes * gaps[steep[known]])
        widths.append(gaps[steep[known]])
        places.append(np.column_stack([rows, columns])[steep[known]][:, :: 1 - 2 * (axis == 0)])
        noise.append(np.abs(np.diff(rates, axis=1)).ravel())
    sizes, where = np.concatenate(jumps), np.concatenate(places)
    # The noise of a second difference is sqrt(3) times that of a difference.
    changes = np.concatenate(noise)
    changes = changes[np.isfinite(changes)]
    spread = float(np.percentile(changes, 68.0)) / math.sqrt(3.0) if changes.size else 0.0
    integers = np.rint(sizes)
    curved = np.concatenate(widths) ** 2  # errors of extrapolation across vanes
    rest = (sizes - integers) * np.sign(integers)
    is_jump = (integers != 0.0) & (np.abs(rest) <= np.clip(_JUMP_NOISE * spread * curved, *_JUMP_LIMITS))
    count, all_steps = int(is_jump.sum()), int((np.abs(sizes) > _STEP).sum())
    least = _STEP_LENGTH * math.sqrt(np.isfinite(waves).sum())
    if count <= least or count < _JUMP_SHARE * all_steps:
        return 0, 0, 0
    # Noise of wrapped values makes jumps smaller, since they are at most one wave.
    if abs(float(rest[is_jump].mean())) > _JUMP_BIAS + spread * float(curved[is_jump].mean()):
        return 0, 0, 0
    row, column = where[is_jump][0].tolist()
    return count, row, column


def outliers(residual: Array, wave: float) -> Iterator[Finding]:
    """Yield the finding on outliers of residuals (axis 0; NaN: unused), in units of which a wave is so many."""
    far = np.array([_outliers_of(one, _LEAST_OUTLIER * wave) for one in residual])
    if far.any():
        square = float(np.nansum(residual[~far] ** 2))
        moved = math.sqrt(float((residual[far] ** 2).sum()) / max(square, 1e-300))
        text = f"{int(far.sum())} pixels are far from their neighbours"
        text += f", and move coefficients by about {moved:.2g} standard errors: mask them"
        numbers = {"pixels": int(far.sum()), "standard_errors": moved}
        yield Finding("outliers", "doubt" if moved > 1.0 else "note", text, numbers)


def _outliers_of(residual: Array, least: float) -> NDArray[np.bool_]:
    """Return the pixels of a map that differ from their surroundings by at least `least`."""
    height, width = residual.shape
    padded = np.pad(residual, 2, constant_values=np.nan)
    steps = [(row, column) for row in (0, 2, 4) for column in (0, 2, 4) if (row, column) != (2, 2)]
    neighbors = [padded[row : row + height, column : column + width] for row, column in steps]
    differences = np.abs(residual - sum(neighbors) / len(neighbors))
    if not np.isfinite(differences).any():
        return np.zeros(residual.shape, dtype=np.bool_)
    limit = max(_OUTLIER * float(np.nanpercentile(differences, 68.0)), least)
    # The median of nine values, one of them the pixel, is as far as five others on one side.
    above, below = (
        np.count_nonzero([sign * (residual - one) > limit for one in neighbors], axis=0) for sign in (1.0, -1.0)
    )
    far = np.asarray(np.maximum(above, below) > len(neighbors) // 2)
    # Where a map is curved, and at the edges of steps, the neighbours differ as well.
    around = np.array([one[far] for one in neighbors])
    median = np.nanmedian([residual[far], *around], axis=0)
    spread = np.nanmedian(np.abs(around - median), axis=0)
    far[far] = np.abs(residual[far] - median) > _SPREAD * spread
    return far


class Missing(NamedTuple):
    """Terms of higher degree than those of a fit, of which its residual consists."""

    degree: int
    rms: float
    moved: float
    """Largest change of a fitted coefficient."""


def modes(
    residuals: Array, places: NDArray[np.int64], x: Array, y: Array, highest: int, most: int
) -> Iterator[tuple[Array, Missing | None]]:
    """Yield the covariance of coefficients of degree up to `highest` of each map, and its missing terms.

    Residuals have the shape (maps, samples); `places` are rows and columns, `x`, `y` in radii of the pupil. Missing
    terms are sought up to the degree `most`. Noise of coefficients is that of modes, orthonormal over the samples, of
    the next higher degrees: noise of neighbours may be correlated.
    """
    terms = _terms(highest)
    kept, samples = len(terms), x.size
    side = -(-int(places.max() + 1) // _CELLS)
    while True:
        _, cell, counts = np.unique(
            (places[0] // side) * (places[1].max() + 1) + places[1] // side, return_inverse=True, return_counts=True
        )
        if len(counts) >= 2 * kept or side == 1:
            break
        side -= 1
    last = max(highest, min(max(most, highest + _MORE_DEGREES), math.isqrt(len(counts)) - 2))
    terms, weight = _terms(last), np.sqrt(counts)
    degrees = np.array([n for n, _ in terms])
    x, y = (np.bincount(cell, values) / counts for values in (x, y))
    basis = zernike.normalized(terms, np.hypot(x, y), np.arctan2(y, x))
    orthonormal, triangle = np.linalg.qr((weight * basis).T)
    independent = np.abs(np.diag(triangle)) > 1e-6 * math.sqrt(samples)
    tested = np.array([n for n in range(highest + 1, last + 1) if independent[degrees == n].any()], dtype=np.int64)
    members = [np.flatnonzero((degrees == n) & independent) for n in tested]
    count = np.array([len(one) for one in members], dtype=np.float64)
    inverse = np.linalg.inv(triangle[:kept, :kept])
    for residual in residuals:
        if samples == kept:  # without a residual, errors are unknown
            yield np.full((kept, kept), math.inf), None
            continue
        total = float((residual**2).sum())
        sizes = orthonormal.T @ (np.bincount(cell, residual) / weight)
        power = np.array([(sizes[one] ** 2).sum() for one in members])
        white = total / (samples - kept)
        left = np.maximum(total - np.cumsum(power), 0.0) / np.maximum(samples - kept - np.cumsum(count), 1.0)
        missing, start = None, 0
        if left.size:
            first = int(np.argmax(left <= max(_SETTLED * left[-1], _NEGLIGIBLE * white)))
            if left[first] <= _LEFT * white and tested[first] <= min(most, last - 2):
                through, start = len(_terms(int(tested[first]))), first + 1
                change = np.linalg.solve(triangle[:through, :through], sizes[:through])
                rms = math.sqrt(power[:start].sum() / samples)
                missing = Missing(int(tested[first]), rms, float(np.abs(change[1:kept]).max(initial=0.0)))
                white = float(left[first])
        noise = _extrapolated(tested[start:], count[start:], power[start:], white, highest)
        yield (inverse * noise[degrees[:kept]]) @ inverse.T, missing


def _terms(highest: int) -> list[tuple[int, int]]:
    """Return the terms (n, m) up to a degree."""
    return [(n, m) for n in range(highest + 1) for m in range(-n, n + 1, 2)]


def _extrapolated(degrees: NDArray[np.int64], count: Array, power: Array, white: float, highest: int) -> Array:
    """Return the variance of modes of the degrees 0 to `highest` from the power of `count` modes of higher ones.

    It is the variance of white noise if the next degrees agree with it. Otherwise ``a (f + (1 - f) s(n))``, where s
    falls as a Gaussian, exponential or power of the degree: its logarithm is averaged by the likelihood.
    """
    following = float(count[:_NEXT].sum())
    excess = power[:_NEXT].sum() - following * white
    if not excess > 3.0 * white * math.sqrt(2.0 * following):
        return np.full(highest + 1, white)
    grid = np.concatenate([np.arange(highest + 1), degrees])
    logarithms, misfits = [], []
    for shape, most in zip(((grid + 1.0) ** 2, grid + 1.0, np.log(grid + 1.0)), _MOST_FALL, strict=True):
        fall = np.geomspace(0.1, most, 24)[:, None, None] / max(float(np.ptp(shape[highest + 1 :])), 1e-9)
        floor = np.concatenate([[0.0], np.geomspace(1e-3, 1.0, 10)])[:, None]
        falls = np.maximum(fall * (shape - shape[highest + 1]), -_MAX_EXTRAPOLATION)
        trial = floor + (1.0 - floor) * np.exp(-falls)
        scale = (power / trial[..., highest + 1 :]).sum(axis=-1, keepdims=True) / count.sum()
        logarithm = np.log(scale * trial).reshape(-1, len(grid))
        logarithms.append(logarithm)
        misfits.append((count * logarithm[:, highest + 1 :]).sum(axis=-1))
    misfit = np.concatenate(misfits)
    weights = np.exp(-0.5 * (misfit - misfit.min()))
    return np.asarray(np.exp(weights @ np.concatenate(logarithms)[:, : highest + 1] / weights.sum()))


def misfits(
    missing: Sequence[Missing | None], residual: Array, floor: float, unit: str, wave: float
) -> Iterator[Finding]:
    """Yield the finding on what terms lack of residuals (axis 0; NaN: unused) with rounding errors below `floor`."""
    rms = np.sqrt(np.nanmean(residual**2, axis=(1, 2)))
    found = [(one, float(left)) for one, left in zip(missing, rms, strict=True) if one is not None and left > floor]
    finding = None
    if found:
        finding = _missing_finding(*max(found, key=lambda pair: pair[0].rms), unit, wave)
        if finding.severity == "doubt":
            yield finding
            return
    losses = [_structure((2.0 * math.pi / wave) * one) for one in residual]
    worst = int(np.argmax(losses))
    if losses[worst] > _LEAST_STREHL:
        strehl, left = losses[worst], float(rms[worst])
        text = f"neighbours share structure in the residual ({left:.3g} {unit} rms), which this wavefront lacks, and "
        text += "which, unless it is noise, lowers a Strehl ratio, and an MTF on average, by about "
        text += f"{percent(strehl, 1)}: raise degree, or pass the residual to Pupil as mask="
        finding = Finding("misfit", "doubt", text, {"rms": left, "strehl": strehl})
    if finding is not None:
        yield finding


def _structure(phase: Array) -> float:
    """Return by how much the structure of a residual (radians, NaN: unused) lowers a Strehl ratio; 0 if it is white.

    The Strehl ratio of the residual, divided by that of its white noise: the mean cosine of differences between
    neighbours, extrapolated to neighbours at distance 0.
    """
    strehl = abs(np.nanmean(np.exp(1j * phase))) ** 2
    white, error = 0.0, 0.0
    for turned in (phase, phase.T):  # ripple has no structure along itself
        near, far = (np.cos(turned[step:] - turned[:-step]) for step in (1, 2))
        count = int(np.isfinite(near).sum())
        if count and np.isfinite(far).any():
            mean = (4.0 * float(np.nanmean(near)) - float(np.nanmean(far))) / 3.0
            white, error = max((white, error), (mean, float(np.nanstd(near)) / math.sqrt(count)))
    return float(1.0 - strehl / min(white, 1.0)) if white - strehl > _STRUCTURE * error else 0.0


def _missing_finding(missing: Missing, rms: float, unit: str, wave: float) -> Finding:
    """Return the finding on terms of higher degree; a doubt if they change a Strehl ratio."""
    strehl = -math.expm1(-((2.0 * math.pi * missing.rms / wave) ** 2))
    text = f"terms of higher degree are missing: {missing.rms:.3g} of the {rms:.3g} {unit} rms that are left are in "
    text += f"degrees up to {missing.degree}, which lower a Strehl ratio by about {percent(strehl, 1)} and change "
    text += f"fitted terms by up to {missing.moved:.2g} {unit}: pass degree={missing.degree}"
    numbers = {"degree": missing.degree, "rms": missing.rms, "strehl": strehl, "moved": missing.moved}
    return Finding("misfit", "doubt" if strehl > _LEAST_STREHL else "note", text, numbers)
