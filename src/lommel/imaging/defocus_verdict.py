"""What frames that differ in focus tell of their lenses: registration, noise, and the scale of their blur.

At each point frames give the radii of as many blurs, from which the lens makes one distance. What is left over is the
difference of the radii, which focus distances, f-number, focal length and pixel pitch state: its scale is an unknown
that all points share. It is where the misfit is least of the filters of :mod:`lommel.imaging.focal_tables`, without
polynomials, for apertures of other sizes.
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

_LEAST_MISFIT, _GOOD_MISFIT, _MISFIT = 0.7, 1.4, 2.0  # limits of too little, good, and doubtful misfit
_LIKELY, _SURE = 1.5, 2.5  # standard errors from 1 of a doubtful and of a wrong scale
_DEVIATION = 0.1  # largest standard error of a scale that is reported
_LEAST_DEVIATION = 0.02  # of scales in rendered scenes, however much texture there is
# How far the mean misfit may be off for apertures that differ: by itself, and by what the frames do not fit anyway.
_OFF, _OFF_MISFIT = 0.0005, 0.1
_OFF_SLOPE = 1.0  # its slope by the logarithm of the scale, by the latter
_UNLIKE = 1.15  # largest misfit of cells over that of the best ones
_STEP, _MOST, _COARSE = 0.04, 16, 2  # step of the logarithm of tried scales, steps on either side, coarse stride
_NEAR, _NEAR_MISFIT = 0.02, 0.5  # largest misfit above the least, of scales that are refined
_WALL = 2.5  # misfit over the least beyond which larger scales are not tried
_SIDE, _TILES = 256, 4  # side of tiles, pixels, and their number
_MARGIN = 16  # pixels besides the blur
_CELL = 8  # blocks a side of cells, which are taken as independent
_LEAST_CELLS = 8
_NEWTON = 5  # Newton steps to the least of an energy


@dataclass(frozen=True, eq=False, kw_only=True)
class DefocusVerdict(FitReport):
    """Whether frames that differ in focus agree with their lenses and noise, as far as frames can tell.

    Its findings have the codes "no_depth", "misfit", "too_quiet", "lens_scale", and "untested" for what no frames, or
    not these, can tell.

    Attributes
    ----------
    findings : Findings
        What does not agree, is in doubt, or is not tested.
    summary : str
        What agrees.
    misfit : float
        Median, over what is known, of the frames' difference over that of noise: 1 where registration and noise are
        as stated; NaN where nothing is known.
    scale : float
        Difference of the blurs over that of the lenses, as by apertures so much larger; NaN where it is not tested.
    scale_error : float
        Standard error of the scale, 0.02 or more; inf where it is not tested.
    others : tuple of float
        Other scales that fit as well; all of them where the scale is not tested, as that of the lenses is among them.
    changes : (float, float)
        Median changes of depth, metres, by f-numbers that are 1 % larger and by 0.01 dioptre of all foci; NaN where
        nothing is known.
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
        """Return the verdict on a misfit and a scale.

        Parameters
        ----------
        misfit, scale, scale_error, others, changes
            As the attributes.
        stated : float
            Standard error of the scale by those that are stated of the lenses.

        Returns
        -------
        DefocusVerdict
        """
        findings, agree = [], []
        numbers = {"misfit": misfit, "least": _LEAST_MISFIT, "limit": _GOOD_MISFIT}
        if math.isnan(misfit):
            findings.append(
                Finding("no_depth", "error", "no depth is known: there is no texture, or all is out of range")
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
        what = [
            "which image is focused nearer (exchanged, all agrees as well)",
            "a shift of all foci or of one",
            "other blur of one image, as of motion",
            "colours that focus elsewhere",
            "aberrations that the lenses do not state, such as spherical",
            "light that one image has more of, as of glare or vignetting",
        ]
        off = min(abs(each - 1.0) / math.hypot(scale_error, stated) for each in (scale, *others))
        of = f"{scale:.2f} +- {scale_error:.2f}"
        size = {"scale": scale, "error": scale_error}
        untested = math.isnan(scale) or (bool(others) and off <= _SURE)
        if untested:
            if not math.isnan(scale):
                scale, scale_error, others = math.nan, math.inf, (scale, *others)
            alike = ", ".join(f"{each:.2f}" for each in others)
            what.insert(0, "the size of blur" + (f" ({alike} of what the lenses state fit alike)" if others else ""))
        elif off > _SURE:
            findings.append(
                Finding(
                    "lens_scale",
                    "error",
                    (
                        f"blurs differ by {of} of what the lenses state: f-number, focal length, pixel pitch or a "
                        "focus distance is wrong"
                    ),
                    size,
                )
            )
        elif off > _LIKELY:
            findings.append(
                Finding(
                    "lens_scale",
                    "doubt",
                    (f"the size of blur is in doubt: blurs differ by {of} of what the lenses state"),
                    size,
                )
            )
        else:
            agree.append(f"blurs differ as the lenses state ({of} of it)")
        costs: dict[str, object] = {"what": what}
        text = "not tested: " + ", ".join(what)
        if all(map(math.isfinite, changes)):
            costs |= {"by_f_number": changes[0], "by_foci": changes[1]}
            each = [format_length(abs(change), digits=2) for change in changes]
            text += f"; 1 % of the f-number changes depth by {each[0]}, 0.01 dioptre of all foci by {each[1]}"
        findings.append(Finding("untested", "note", text, costs))
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
        """Whether nothing that was tested disagrees or is in doubt."""
        return self.reliable


def judged(
    engine: FocalEngine,
    images: Values,
    valid: NDArray[np.bool_],
    errors: Values,
    misfit: Values,
    vergence: Array,
    stated: float = 0.0,
) -> DefocusVerdict:
    """Return the verdict on images (channels, frames, height, width), in electrons at the exposure of the first.

    `valid` are the pixels that are known, `errors` the standard errors of depth, in any unit and infinite where it
    is not known, `misfit` their misfits and `vergence` what was found, 1 / m, all of shape (height, width); `stated`
    is the standard error of the scale by those of the lenses.
    """
    known = np.isfinite(errors)
    if not known.any():
        return DefocusVerdict.of(math.nan)
    left = float(np.median(misfit[known]))
    at = vergence[known].astype(np.float64)
    # d(1 / v) = -dv / v^2.
    by_f_number, *by_foci = np.median(-engine.by_lenses(at) / at**2, axis=1).tolist()
    of = partial(DefocusVerdict.of, left, changes=(0.01 * by_f_number, 0.01 * sum(by_foci)), stated=stated)
    # Inverse variances of depth.
    weight = np.where(known, 1.0 / np.maximum(errors, 1e-6) ** 2, 0.0)
    found = _scales(engine, images, valid, weight)
    if not found:
        return of()
    best, *others = found
    if best.error >= max(_DEVIATION, abs(best.scale - 1.0) / _SURE):
        return of()
    return of(best.scale, best.error, tuple(each.scale for each in others))


class _Fit(NamedTuple):
    """A scale at a local least misfit."""

    scale: float
    error: float
    misfit: float
    step: int  # nearest step of the logarithm
    below: float  # by how much the misfit is less than at that step


def _scales(engine: FocalEngine, images: Values, valid: NDArray[np.bool_], weight: Array) -> list[_Fit]:
    """Return the scales of the blur difference, in the brightest channel, that fit alike, the best first."""
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

    # Several scales may fit: of one depth the two signs of the nearer defocus, of all depths those of other depths.
    coarse = list[float]()
    for k in range(-_MOST, _MOST + 1, _COARSE):
        # Blurs that differ by more than images show fit the worse the more they do: there nothing is to be found.
        beyond = bool(coarse) and coarse[-1] > _WALL * min(coarse)
        coarse.append(math.inf if beyond else _median(filters(k)(tiles[0])))
    near = min(coarse) + _NEAR + _NEAR_MISFIT * abs(min(coarse) - 1.0)
    found = list[_Fit]()
    for place in range(1, len(coarse) - 1):
        here = coarse[place]
        if here <= min(coarse[place - 1], coarse[place + 1], near):
            one = _settled(misfits, _COARSE * place - _MOST)
            if one is not None and all(abs(one.scale - each.scale) > _STEP for each in found):
                found.append(one)
    found.sort(key=lambda one: one.misfit)
    return [one for one in found if one is found[0] or _is_as_good(one, found[0], misfits)]


def _is_as_good(one: _Fit, best: _Fit, misfits: Callable[[int], Array]) -> bool:
    """Return whether a scale's misfit equals that of the best, within noise and model error."""
    cells, shares = _cells(np.stack([misfits(one.step), misfits(best.step)]))
    if len(shares) < _LEAST_CELLS:
        return True
    weights = _weights(cells, shares)
    # Both misfits at their least, not at the nearest step.
    more = cells[0] - cells[1] - one.below + best.below
    mean = float(more @ weights)
    error = float(np.sqrt((weights**2) @ (more - mean) ** 2))
    return mean <= max(_SURE * error, _OFF + _OFF_MISFIT * abs(best.misfit - 1.0))


def _settled(misfits: Callable[[int], Array], k: int) -> _Fit | None:
    """Return the scale of the least misfit near a step; None if there is none."""
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
        # A cubic through the mean of the cells, and of each: where the slope is 0, and how far cells differ in it.
        cells, shares = _cells(np.stack([misfits(k + step) for step in around.tolist()]))
        weights = _weights(cells, shares)
        cubics = np.linalg.lstsq(powers, cells, rcond=None)[0]
        start, slope, bend, skew = (cubics @ weights).tolist()
        # The cubic is least where slope + 2 bend x + 3 skew x^2 = 0: of the two roots the one with positive
        # curvature,
        # x = -slope / (bend + sqrt(bend^2 - 3 slope skew)), in which nothing cancels; the curvature is 2 sqrt(...).
        root = bend**2 - 3.0 * slope * skew
        if not (bend > 0.0 and root > 0.0):
            break
        place = -slope / (bend + math.sqrt(root))
        if not abs(place) <= 2.0:
            break
        curvature = 2.0 * math.sqrt(root)
        least = float(np.array([place**n for n in range(4)]) @ cubics @ weights)
        # The error of a minimum is that of the slope there over the curvature; cells show how the slope scatters.
        slopes = weights * (cubics[1] + place * (2.0 * cubics[2] + 3.0 * place * cubics[3]))
        beyond = _STEP * _OFF_SLOPE * abs(least - 1.0)
        scale = math.exp(_STEP * (k + place))
        scatter = math.hypot(float(np.sqrt((slopes**2).sum())), beyond)
        # d(scale) = scale d(log scale).
        error = scale * math.hypot(_STEP * scatter / curvature, _LEAST_DEVIATION)
        return _Fit(scale, error, least, k, start - least)
    return None


def _weights(cells: Array, shares: Array) -> Array:
    """Return the weights of cells, 0 for cells with a depth edge, which no one depth fits."""
    least = np.maximum(cells.min(axis=0), 1.0)
    weights = np.where(least <= _UNLIKE * np.quantile(least, 0.25), shares / least**2, 0.0)
    return np.asarray(weights / weights.sum())


def _median(misfits: Array) -> float:
    """Return the median of known misfits; infinity if under 2 % are known."""
    known = np.isfinite(misfits)
    return float(np.median(misfits[known])) if known.mean() > 0.02 else math.inf


def _cells(misfits: Array) -> tuple[Array, Array]:
    """Return the mean misfit of cells by scale, (scales, cells), and the known share of each cell."""
    whole = np.isfinite(misfits).all(axis=0)
    scales, tiles, blocks = misfits.shape[:3]
    parts = tiles, blocks // _CELL, _CELL, blocks // _CELL, _CELL
    counts = whole.reshape(parts).sum(axis=(2, 4)).ravel()
    sums = np.where(whole, misfits, 0.0).reshape(scales, *parts).sum(axis=(3, 5)).reshape(scales, -1)
    some = counts >= 0.25 * _CELL**2
    return sums[:, some] / counts[some], counts[some] / _CELL**2


class _Tile(NamedTuple):
    """A square of the frames: transforms by cosines, and the variance of blocks, NaN where these are not wanted."""

    spectra: Array  # (frames, side, side), of squares of pixels
    variance: Array  # (blocks, blocks)


def _tiles(images: Values, valid: NDArray[np.bool_], weight: Array, engine: FocalEngine) -> Iterator[_Tile]:
    """Yield the squares with the smallest errors of depth."""
    from scipy.fft import dctn
    from scipy.ndimage import maximum_filter

    block, binning = engine.task.block, engine.binning
    side = min(_SIDE, *(each // (_CELL * block) * (_CELL * block) for each in valid.shape))
    blocks, reach = side // block, 2 * (math.ceil(engine.blur) + _MARGIN) + 1
    corners = [range(0, each - side + 1, side) if side else () for each in valid.shape]
    squares = [(slice(top, top + side), slice(left, left + side)) for top in corners[0] for left in corners[1]]
    squares.sort(key=lambda inside: -float(weight[inside].sum()))
    for inside in squares[:_TILES]:
        lost = maximum_filter(np.pad(~valid[inside], 1, constant_values=True), reach, mode="nearest")[1:-1, 1:-1]
        wanted = ~lost & (weight[inside] > 0.0)
        known = wanted.reshape(blocks, block, blocks, block).mean(axis=(1, 3)) > 0.5
        if known.any():
            shape = len(images), side // binning, binning, side // binning, binning
            planes = images[(slice(None), *inside)].reshape(shape).sum(axis=(2, 4), dtype=np.float64)
            light = planes.mean(axis=0).reshape(blocks, block // binning, blocks, -1).mean(axis=(1, 3))
            variance = np.maximum(engine.averaged(light), 0.0) + (engine.light.read * binning) ** 2
            yield _Tile(dctn(planes, axes=(1, 2), norm="ortho"), np.where(known, variance, np.nan))


class _Filters:
    """Filters of residuals, for apertures of another size."""

    def __init__(self, engine: FocalEngine, channel: int, scale: float) -> None:
        self._engine = engine
        lenses = [lens.stopped(lens.f_number / scale) for lens in engine.task.lenses]
        model = engine.task.model(engine.light, channel, engine.binning, lenses)
        self._white = model.white
        self._filters = residual_filters(model)[..., model.band.places()]

    def __call__(self, tile: _Tile) -> Array:
        """Return the misfit of blocks, NaN where not wanted and where it is least at an end of the range."""
        from scipy.fft import idctn

        blocks, side, count = len(tile.variance), tile.spectra.shape[1], self._filters.shape[-1]
        # Filters are given at fewer frequencies than a tile has: linear between them.
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
        # Beyond the ends of the range there may be a lower energy: no misfit is known there.
        best = np.argmin(np.nan_to_num(energies, nan=math.inf), axis=0)
        inner = np.clip(best, 2, len(energies) - 3)
        near = np.stack([np.take_along_axis(energies, inner[None] + k, axis=0)[0] for k in range(-2, 3)])
        return np.where(best == inner, 1.0 + (_least(near) + self._engine.of_least) / noise[inner], np.nan)


def _least(near: Array) -> Array:
    """Return the least, within one candidate of the third, of the quartic through five energies."""
    # From one candidate to the next filters are nearly parabolas in the vergence, and energies squares of filters.
    a = np.tensordot(np.linalg.inv(np.vander(np.arange(-2.0, 3.0), increasing=True)), near, axes=1)
    place = np.zeros(near.shape[1:])
    for _ in range(_NEWTON):
        slope = a[1] + place * (2.0 * a[2] + place * (3.0 * a[3] + place * 4.0 * a[4]))
        bend = 2.0 * a[2] + place * (6.0 * a[3] + place * 12.0 * a[4])
        # The clip keeps Newton steps within the interpolation.
        place = np.clip(place - slope / np.maximum(bend, 1e-30), -1.0, 1.0)
    return np.asarray(a[0] + place * (a[1] + place * (a[2] + place * (a[3] + place * a[4]))))
