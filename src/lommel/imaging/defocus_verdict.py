"""Tests of frames that differ in focus against their lenses: registration, noise, and the scale of the blur.

Each frame has one blur radius at a point, but the point has only one distance. The difference between the radii of
two frames is therefore redundant: focus distances, f-number, focal length and pixel pitch predict it. The scale is
(true difference) / (predicted difference), one unknown for the whole image. Lenses with other apertures change the
prediction; the scale minimises the misfit of their residual filters (:mod:`lommel.imaging.focal_tables`, without
polynomials). A tile is a square of the frames; a cell is a square of blocks, independent of the other cells.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache, partial
from typing import NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array, Values
from lommel.base.units import format_length
from lommel.fit.findings import Finding, Findings, FitReport
from lommel.imaging.focal_engine import FocalEngine
from lommel.imaging.focal_tables import residual_filters

_LEAST_MISFIT, _GOOD_MISFIT, _MISFIT = 0.7, 1.4, 2.0  # smallest and largest good misfit, largest doubtful misfit
_LIKELY, _SURE = 1.5, 2.5  # limits of abs(scale - 1) / standard error: doubtful above _LIKELY, wrong above _SURE
_DEVIATION = 0.1  # largest standard error of a reported scale, unless the scale is wrong
_LEAST_DEVIATION = 0.02  # systematic standard error of a scale, measured in rendered scenes with much texture
# Systematic error of the difference between two mean misfits: a constant, and a multiple of abs(misfit - 1).
_SYSTEMATIC, _SYSTEMATIC_MISFIT = 0.0005, 0.1
_SYSTEMATIC_SLOPE = 1.0  # systematic error of d misfit / d log(scale), as a multiple of abs(misfit - 1)
_EDGE_RATIO = 1.15  # misfit of a cell / lower quartile of all cells, above which the cell is ignored
_STEP, _MOST, _COARSE = 0.04, 16, 2  # search over log(scale): step, steps on either side of 0, steps per coarse step
_NEAR, _NEAR_MISFIT = 0.02, 0.5  # excess over the least misfit up to which minima are refined: terms as above
_WALL = 2.5  # misfit / least misfit above which larger scales are not tried
_SIDE, _TILES = 256, 4  # side of a tile in pixels, number of tiles
_MARGIN = 16  # pixels: least distance of a used block from unknown pixels, in addition to the blur radius
_CELL = 8  # number of blocks along a side of a cell
_LEAST_CELLS = 8  # least number of cells from which a scale is estimated
_NEWTON = 5  # number of Newton steps to the minimum of an energy


@dataclass(frozen=True, eq=False, kw_only=True)
class DefocusVerdict(FitReport):
    """Test of frames that differ in focus against their stated lenses and noise.

    The findings have the codes "no_depth", "misfit", "too_quiet", "lens_scale" and "untested". The last one lists
    errors that these frames, or any frames, cannot reveal.

    Attributes
    ----------
    findings : Findings
        Properties that disagree, are in doubt, or are not tested.
    summary : str
        Properties that agree.
    misfit : float
        Median, over pixels with a known depth, of (difference of the frames) / (difference expected of noise): 1 if
        registration and noise are as stated; NaN if no depth is known.
    scale : float
        (Difference between the blurs of the frames) / (difference that the lenses predict), 1.1 for example if all
        apertures are 10 % larger than stated; NaN if not tested.
    scale_error : float
        Standard error of the scale, 0.02 or more; inf if the scale is not tested.
    others : tuple of float
        Other scales that fit as well. If one of several such scales agrees with the lenses, `scale` is NaN, and
        `others` holds all of them.
    changes : (float, float)
        Median changes of depth, metres, if all f-numbers increase by 1 %, and if all foci increase by 0.01 dioptre;
        NaN if no depth is known.
    """

    misfit: float
    scale: float
    scale_error: float
    others: tuple[float, ...] = ()
    changes: tuple[float, float] = (math.nan, math.nan)

    @classmethod
    def of(
        cls,
        misfit: float,
        scale: float = math.nan,
        scale_error: float = math.inf,
        others: tuple[float, ...] = (),
        changes: tuple[float, float] = (math.nan, math.nan),
        *,
        stated: float = 0.0,
    ) -> Self:
        """Return the verdict for a misfit and a scale.

        Parameters
        ----------
        misfit, scale, scale_error, others, changes
            See the attributes.
        stated : float
            Standard error of the scale that follows from the stated errors of the lenses.

        Returns
        -------
        DefocusVerdict
        """
        findings, agree = [], []
        numbers = {"misfit": misfit, "least": _LEAST_MISFIT, "limit": _GOOD_MISFIT}
        if math.isnan(misfit):
            findings.append(
                Finding("no_depth", "error", "no depth is known: there is no texture, or every depth is out of range")
            )
        elif misfit > _MISFIT:
            findings.append(
                Finding(
                    "misfit",
                    "error",
                    (
                        f"the images differ by more than noise (misfit {misfit:.3g}): something moved, they are not "
                        "registered, noise is understated, or the lens or its foci are wrong"
                    ),
                    numbers,
                )
            )
        elif misfit > _GOOD_MISFIT:
            findings.append(
                Finding(
                    "misfit",
                    "doubt",
                    (f"registration and noise are in doubt (misfit {misfit:.3g}; 1 if only noise is left)"),
                    numbers,
                )
            )
        elif misfit < _LEAST_MISFIT:
            findings.append(
                Finding(
                    "too_quiet",
                    "error",
                    (
                        f"the images differ by less than noise (misfit {misfit:.3g}): they were denoised, or noise "
                        "is overstated"
                    ),
                    numbers,
                )
            )
        else:
            agree.append(f"registration and noise agree (misfit {misfit:.3g}; 1 if only noise is left)")
        untested = [
            "which image is focused nearer (exchanged, all agrees as well)",
            "a shift of all foci or of one focus",
            "motion blur or other additional blur of one image",
            "chromatic differences of focus",
            "aberrations that the lenses do not state, such as spherical aberration",
            "additional light in one image, such as glare, or vignetting",
        ]
        deviation = min(abs(each - 1.0) / math.hypot(scale_error, stated) for each in (scale, *others))
        ratio = f"{scale:.2f} +- {scale_error:.2f}"
        numbers_of_scale = {"scale": scale, "error": scale_error}
        if math.isnan(scale) or (bool(others) and deviation <= _SURE):
            if not math.isnan(scale):
                scale, scale_error, others = math.nan, math.inf, (scale, *others)
            scales = ", ".join(f"{each:.2f}" for each in others)
            hint = f" ({scales} times the stated blur difference fit equally well)" if others else ""
            untested.insert(0, "the size of blur" + hint)
        elif deviation > _SURE:
            findings.append(
                Finding(
                    "lens_scale",
                    "error",
                    (
                        f"blurs differ by {ratio} times the stated difference: f-number, focal length, pixel pitch "
                        "or a focus distance is wrong"
                    ),
                    numbers_of_scale,
                )
            )
        elif deviation > _LIKELY:
            findings.append(
                Finding(
                    "lens_scale",
                    "doubt",
                    (f"the size of blur is in doubt: blurs differ by {ratio} times the stated difference"),
                    numbers_of_scale,
                )
            )
        else:
            agree.append(f"blurs differ as the lenses state ({ratio} of it)")
        details: dict[str, object] = {"what": untested}
        text = "not tested: " + ", ".join(untested)
        if all(map(math.isfinite, changes)):
            details |= {"by_f_number": changes[0], "by_foci": changes[1]}
            by_f_number, by_foci = (format_length(abs(change), digits=2) for change in changes)
            text += f"; 1 % of the f-number changes depth by {by_f_number}, 0.01 dioptre of all foci by {by_foci}"
        findings.append(Finding("untested", "note", text, details))
        summary = "; ".join(agree) or "nothing that was tested agrees"
        return cls(
            findings=Findings(findings),
            summary=summary,
            misfit=misfit,
            scale=scale,
            scale_error=scale_error,
            others=others,
            changes=changes,
        )

    @property
    def agrees(self) -> bool:
        """Whether every tested property agrees, without doubt."""
        return self.reliable


def judge_frames(
    engine: FocalEngine,
    images: Values,
    valid: NDArray[np.bool_],
    errors: Values,
    misfit: Values,
    vergence: Array,
    stated: float = 0.0,
) -> DefocusVerdict:
    """Return the verdict on images (channels, frames, height, width), in electrons at the exposure of frame 0.

    Maps of shape (height, width): `valid`, the known pixels; `errors`, standard errors of depth in any unit, inf if
    depth is unknown; `misfit`; `vergence`, the estimated 1 / distance in 1 / m. `stated` is the standard error of
    the scale that follows from the stated errors of the lenses.
    """
    known = np.isfinite(errors)
    if not known.any():
        return DefocusVerdict.of(math.nan)
    median = float(np.median(misfit[known]))
    at = vergence[known].astype(np.float64)
    # Depth is 1 / v at the vergence v: d(1 / v) = -dv / v^2.
    by_f_number, *by_foci = np.median(-engine.by_lenses(at) / at**2, axis=1).tolist()
    changes = 0.01 * by_f_number, 0.01 * sum(by_foci)
    verdict = partial(DefocusVerdict.of, median, changes=changes, stated=stated)
    # Inverse variances of depth.
    weight = np.where(known, 1.0 / np.maximum(errors, 1e-6) ** 2, 0.0)
    minima = _scale_minima(engine, images, valid, weight)
    if not minima:
        return verdict()
    best, *others = minima
    if best.error >= max(_DEVIATION, abs(best.scale - 1.0) / _SURE):
        return verdict()
    return verdict(best.scale, best.error, tuple(each.scale for each in others))


class _Minimum(NamedTuple):
    """A local minimum of the misfit as a function of the scale."""

    scale: float
    error: float  # standard error of the scale
    misfit: float
    step: int  # log(scale) / _STEP, rounded
    below: float  # misfit at this step minus the minimum


def _scale_minima(engine: FocalEngine, images: Values, valid: NDArray[np.bool_], weight: Array) -> list[_Minimum]:
    """Return the scales that fit equally well in the brightest channel, beginning with the best one."""
    brightest = int(np.argmax(images[:, 0].mean(axis=(1, 2))))
    tiles = list(_tiles(images[brightest], valid, weight, engine))
    if not tiles or len(_cells(np.stack([tile.variance for tile in tiles])[None])[1]) < _LEAST_CELLS:
        return []

    @cache
    def filters(k: int) -> _Filters:
        return _Filters(engine, brightest, math.exp(_STEP * k))

    @cache
    def misfits(k: int) -> Array:
        return np.stack([filters(k)(tile) for tile in tiles])

    # The misfit may have several minima: other scales can fit with other signs of defocus, or with other depths.
    coarse = list[float]()
    for k in range(-_MOST, _MOST + 1, _COARSE):
        # Once the misfit is this large, it increases with the scale: larger scales need not be tried.
        beyond = bool(coarse) and coarse[-1] > _WALL * min(coarse)
        coarse.append(math.inf if beyond else _median(filters(k)(tiles[0])))
    limit = min(coarse) + _NEAR + _NEAR_MISFIT * abs(min(coarse) - 1.0)
    minima = list[_Minimum]()
    for place in range(1, len(coarse) - 1):
        here = coarse[place]
        if here <= min(coarse[place - 1], coarse[place + 1], limit):
            one = _refine_minimum(misfits, _COARSE * place - _MOST)
            if one is not None and all(abs(one.scale - each.scale) > _STEP for each in minima):
                minima.append(one)
    minima.sort(key=lambda one: one.misfit)
    return [one for one in minima if one is minima[0] or _fits_equally(one, minima[0], misfits)]


def _fits_equally(one: _Minimum, best: _Minimum, misfits: Callable[[int], Array]) -> bool:
    """Return whether the misfits of two scales are equal within noise and model error."""
    cells, shares = _cells(np.stack([misfits(one.step), misfits(best.step)]))
    if len(shares) < _LEAST_CELLS:
        return True
    weights = _weights(cells, shares)
    # Difference between the minima, not between the misfits at the nearest steps.
    more = cells[0] - cells[1] - one.below + best.below
    mean = float(more @ weights)
    error = float(np.sqrt((weights**2) @ (more - mean) ** 2))
    return mean <= max(_SURE * error, _SYSTEMATIC + _SYSTEMATIC_MISFIT * abs(best.misfit - 1.0))


def _refine_minimum(misfits: Callable[[int], Array], k: int) -> _Minimum | None:
    """Return the local minimum of the misfit near step `k`; None if there is no minimum."""
    seen = set[int]()
    around = np.arange(-2, 3)
    powers = np.vander(around, 4, increasing=True)
    while abs(k) < _MOST and k not in seen:
        seen.add(k)
        cells, shares = _cells(np.stack([misfits(k - 2), misfits(k), misfits(k + 2)]))
        if len(shares) < _LEAST_CELLS:
            break
        before, here, after = cells @ _weights(cells, shares)
        if not here <= min(before, after):
            k += 2 if after < before else -2
            continue
        # A cubic fit for each cell. The mean cubic has the minimum; the scatter of the slopes determines its error.
        cells, shares = _cells(np.stack([misfits(k + step) for step in around.tolist()]))
        weights = _weights(cells, shares)
        cubics = np.linalg.lstsq(powers, cells, rcond=None)[0]
        start, slope, bend, skew = (cubics @ weights).tolist()
        # At the minimum slope + 2 bend x + 3 skew x^2 = 0. The root with positive curvature, in a form without
        # cancellation, is x = -slope / (bend + sqrt(root)), root = bend^2 - 3 slope skew; the curvature is
        # 2 sqrt(root).
        root = bend**2 - 3.0 * slope * skew
        if not (bend > 0.0 and root > 0.0):
            break
        place = -slope / (bend + math.sqrt(root))
        if not abs(place) <= 2.0:
            break
        curvature = 2.0 * math.sqrt(root)
        least = float(np.array([place**n for n in range(4)]) @ cubics @ weights)
        # Error of the position of the minimum = error of the slope / curvature.
        slopes = weights * (cubics[1] + place * (2.0 * cubics[2] + 3.0 * place * cubics[3]))
        systematic = _STEP * _SYSTEMATIC_SLOPE * abs(least - 1.0)
        scale = math.exp(_STEP * (k + place))
        scatter = math.hypot(float(np.sqrt((slopes**2).sum())), systematic)
        # d(scale) = scale d(log scale).
        error = scale * math.hypot(_STEP * scatter / curvature, _LEAST_DEVIATION)
        return _Minimum(scale, error, least, k, start - least)
    return None


def _weights(cells: Array, shares: Array) -> Array:
    """Return the weights of cells: 0 for cells with a depth edge, where the misfit is large at every depth."""
    least = np.maximum(cells.min(axis=0), 1.0)
    weights = np.where(least <= _EDGE_RATIO * np.quantile(least, 0.25), shares / least**2, 0.0)
    return np.asarray(weights / weights.sum())


def _median(misfits: Array) -> float:
    """Return the median of the finite misfits; infinity if at most 2 % are finite."""
    known = np.isfinite(misfits)
    return float(np.median(misfits[known])) if known.mean() > 0.02 else math.inf


def _cells(misfits: Array) -> tuple[Array, Array]:
    """Return the mean misfit of each cell at each scale, (scales, cells), and the fraction of its blocks in use."""
    whole = np.isfinite(misfits).all(axis=0)
    scales, tiles, blocks = misfits.shape[:3]
    parts = tiles, blocks // _CELL, _CELL, blocks // _CELL, _CELL
    counts = whole.reshape(parts).sum(axis=(2, 4)).ravel()
    sums = np.where(whole, misfits, 0.0).reshape(scales, *parts).sum(axis=(3, 5)).reshape(scales, -1)
    enough = counts >= 0.25 * _CELL**2
    return sums[:, enough] / counts[enough], counts[enough] / _CELL**2


class _Tile(NamedTuple):
    """Cosine transforms of a square of the frames, and the noise variance of each block; NaN for unused blocks."""

    spectra: Array  # (frames, side, side), for binned pixels
    variance: Array  # (blocks, blocks)


def _tiles(images: Values, valid: NDArray[np.bool_], weight: Array, engine: FocalEngine) -> Iterator[_Tile]:
    """Yield the tiles with the smallest standard errors of depth."""
    from scipy.fft import dctn
    from scipy.ndimage import maximum_filter

    block, binning = engine.task.block, engine.binning
    side = min(_SIDE, *(each // (_CELL * block) * (_CELL * block) for each in valid.shape))
    blocks, reach = side // block, 2 * (math.ceil(engine.blur) + _MARGIN) + 1
    corners = [range(0, each - side + 1, side) if side else () for each in valid.shape]
    squares = [(slice(top, top + side), slice(left, left + side)) for top in corners[0] for left in corners[1]]
    squares.sort(key=lambda inside: -float(weight[inside].sum()))
    for inside in squares[:_TILES]:
        affected = maximum_filter(np.pad(~valid[inside], 1, constant_values=True), reach, mode="nearest")
        usable = ~affected[1:-1, 1:-1] & (weight[inside] > 0.0)
        used = usable.reshape(blocks, block, blocks, block).mean(axis=(1, 3)) > 0.5
        if used.any():
            shape = len(images), side // binning, binning, side // binning, binning
            planes = images[(slice(None), *inside)].reshape(shape).sum(axis=(2, 4), dtype=np.float64)
            light = planes.mean(axis=0).reshape(blocks, block // binning, blocks, -1).mean(axis=(1, 3))
            variance = np.maximum(engine.averaged(light), 0.0) + (engine.light.read * binning) ** 2
            yield _Tile(dctn(planes, axes=(1, 2), norm="ortho"), np.where(used, variance, np.nan))


class _Filters:
    """Residual filters for apertures whose diameters are multiplied by `scale`."""

    def __init__(self, engine: FocalEngine, channel: int, scale: float) -> None:
        self._engine = engine
        lenses = [lens.stopped(lens.f_number / scale) for lens in engine.task.lenses]
        model = engine.task.model(engine.light, channel, engine.binning, lenses)
        self._white = model.white
        self._filters = residual_filters(model)[..., model.band.places()]

    def __call__(self, tile: _Tile) -> Array:
        """Return the misfit of each block; NaN for unused blocks, and where the minimum is at an end of the range."""
        from scipy.fft import idctn

        blocks, side, count = len(tile.variance), tile.spectra.shape[1], self._filters.shape[-1]
        # A tile has more frequencies than the filters: linear interpolation.
        at = np.clip(np.arange(side) * (count / side) - 0.5, 0.0, count - 1.0)
        between = np.maximum(0.0, 1.0 - np.abs(at[:, None] - np.arange(count)))
        energies, noise = np.empty((len(self._filters), blocks, blocks)), np.empty(len(self._filters))
        for c, pairs in enumerate(self._filters):
            filters = between @ pairs @ between.T
            residuals = idctn((filters * tile.spectra).sum(axis=1), axes=(1, 2), norm="ortho")
            energy = (residuals**2).sum(axis=0).reshape(blocks, side // blocks, blocks, -1).mean(axis=(1, 3))
            noise[c] = (filters**2).mean(axis=(2, 3)).sum(axis=0) @ self._white
            # Expected energy of noise: the mean square of the filters times the variance of each frame.
            energies[c] = self._engine.averaged(energy) / tile.variance - noise[c]
        # If the lowest energy is at an end of the range, the minimum may lie outside the range.
        best = np.argmin(np.nan_to_num(energies, nan=math.inf), axis=0)
        inner = np.clip(best, 2, len(energies) - 3)
        near = np.stack([np.take_along_axis(energies, inner[None] + k, axis=0)[0] for k in range(-2, 3)])
        return np.where(best == inner, 1.0 + (_minimise_quartic(near) + self._engine.of_least) / noise[inner], np.nan)


def _minimise_quartic(near: Array) -> Array:
    """Return the minimum of the quartic through five energies, within one candidate of the third."""
    # Filters are nearly quadratic in the vergence over five candidates; energies, their squares, are quartic.
    a = np.tensordot(np.linalg.inv(np.vander(np.arange(-2.0, 3.0), increasing=True)), near, axes=1)
    place = np.zeros(near.shape[1:])
    for _ in range(_NEWTON):
        slope = a[1] + place * (2.0 * a[2] + place * (3.0 * a[3] + place * 4.0 * a[4]))
        bend = 2.0 * a[2] + place * (6.0 * a[3] + place * 12.0 * a[4])
        # The clip keeps Newton steps within the interpolation.
        place = np.clip(place - slope / np.maximum(bend, 1e-30), -1.0, 1.0)
    return np.asarray(a[0] + place * (a[1] + place * (a[2] + place * (a[3] + place * a[4]))))
