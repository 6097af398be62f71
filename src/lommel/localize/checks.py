"""Checks of the localisations of a movie: noise, background, wavefront, depth, crowded molecules, recurring spots.

A table has the PSF as a function of z and position. `along` is the meaning of z: position of the stage ("z"),
"depth", or "none" if z is not estimated. The discrepancy of a molecule is (chi2 of its fit - expectation) / standard
deviation. The rival of a table has astigmatism of the opposite sign.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from copy import copy
from dataclasses import replace
from functools import partial
from itertools import chain
from typing import Any, NamedTuple, Self

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base.arrays import Array, Json
from lommel.base.units import format_length, percent, with_error
from lommel.detection.molecules import DEFECT, Spots, box_pixels
from lommel.estimation.star_images import label
from lommel.fit.findings import Finding, Findings, Severity, untested_finding
from lommel.fit.goodness_of_fit import excess_test
from lommel.fit.score_tests import Candidate, ScoreTest, other_explanation, score_tests, seen
from lommel.localize.fitting import Molecules, in_electrons
from lommel.localize.localizations import DOUBTFUL, Localizations, MovieInfo
from lommel.localize.table import Table, Waves
from lommel.optics.layers.objective import SURFACE, FocalSurface
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import psf
from lommel.recorded.counts import Counts, flat_top, flat_tops, scale_findings
from lommel.recorded.noise import Noise
from lommel.special import zernike

TILTED = 5.0
"""Significance, in standard deviations, above which backgrounds count as tilted."""
_MOLECULES = 1000  # number of molecules for the tests of noise, background and the rival
_TOGETHER = 100  # molecules whose images and changes are in memory together
_MIN_FRAMES, _RECURRING = 20, 0.3  # shortest movie for the test of recurring spots; fraction of frames with the spot
_WIDEST, _PER_UNIT = 50, 100  # histogram of discrepancies: largest value, and number of bins per unit
# Smallest plausible (pixel in the sample) / (Nyquist pixel): a smaller pixel was divided by the magnification twice.
_MIN_NYQUIST_RATIO = 0.1
_MAX_DARK = 0.75  # largest fraction of counts below the offset; without light it is one half
_DISCREPANT, _MISFIT = 0.3, 1.0  # median discrepancy above which fits are in doubt, and in error; no PSF is perfect
# Fractions of doubtful molecules: the largest due to chance, and the fraction above which results are in doubt.
_BY_CHANCE, _CROWDED = 0.01, 0.05
# Crowded movies: probability of a second molecule in a box by chance, above which isolated molecules, at least
# _MIN_ISOLATED of them, judge the PSF; and the distance below which two images are taken for one, metres.
_DENSE, _MIN_ISOLATED, _PAIR = 0.2, 50, 170e-9
# Fraction of doubtful molecules of a dense movie above which crowding is an error; spots of the median frame, over
# the mean number of maxima, above which maxima are not molecules that blink; variance ratio of residuals by pixels
# of the camera above which structure stays in place; part of the discrepancy above which a change is its cause.
_MOST, _STEADY, _FIXED, _CAUSE = 0.25, 0.25, 1.3, 0.5
# Focal surface: smallest number of molecules, largest number that is kept, parts of a side whose medians of z are
# fitted, and probability by chance (that of 25 for a chi-squared of 5 degrees of freedom).
_MIN_SURFACE, _MAX_SURFACE, _PARTS, _RARE = 60, 100_000, 8, 1.4e-4
_MAX_AT_ENDS = 0.1  # largest fraction of spots at an end of the range of z
_MIN_COMPARED = 10  # smallest number of molecules from which the standard deviation of the gain is estimated
# Changes of the images that are tested: Zernike terms of the expected size _TERM (radians rms), and errors of the
# expected sizes _CONSTANTS. _TEST_MOLECULES is the number of molecules for these tests.
_TERMS = (*((n, m) for n in (2, 3, 4) for m in range(-n, n + 1, 2) if (n, m) != (2, 0)), (6, 0))
_TERM, _TEST_MOLECULES = 0.1, 300
_BLUR, _VARIANCE = "blur", 0.1  # expected variance of blur that the table lacks, pixels^2
_CONSTANTS = {"depth": 0.2e-6, "sample": 0.02, "immersion": 2e-3, "NA": 0.02, "wavelength": 0.02}
_UNITS = {"depth": " m", "wavelength": " of it"}
_STEP = 0.05  # step of differences, as a fraction of these sizes
_MAX_STATED = 0.5  # largest error of a constant in a message, as a fraction of these sizes
_BIASES, _MICRON = ("row", "column", "z", "photons"), 1e-6
_PHASE_STEP = 1.0  # phase difference between neighbouring planes of the changes, radians
_SUBPIXELS = 3  # samples along each side of a pixel
_MIN_GAIN_RATIO = 1.5  # (gain of changes) / (gain of the rival) above which the rival is not reported
_BIASED = 0.5  # rms bias, in standard errors, above which estimates are in doubt
# Effects that images of single molecules do not reveal.
_NOT_TESTABLE = (
    "focal surface (z counts from it: five beads on the glass tell its shape)",
    "pairs nearer than 170 nm (taken for one molecule)",
    "light that is uneven across the pupil, or clipped on one side (moves molecules sideways in proportion to z)",
    "molecules that do not rotate freely",
    "drift of the focus",
)
_MIN_GAIN = 10.0  # smallest gain of log-likelihood of the rival that is reported


class FirstFrames(NamedTuple):
    """Number of spots of the median of the first block of frames, and findings on its counts."""

    steady: int
    findings: tuple[Finding, ...]

    @classmethod
    def of(cls, counts: Counts, noise: Noise, search: Callable[..., Spots]) -> Self:
        """Check the counts of the first block; `search` finds spots."""
        steady, found = 0, list[Finding]()
        if len(counts) >= _MIN_FRAMES:
            # Spots of the median of frames stay in place: no molecules that blink, but structure of the background.
            spots = search(np.median(counts.marked(), axis=0)[None])
            steady = len(spots) + spots.borders + spots.overlapping
        # Without light, read noise puts half of the counts below the offset.
        dark_fraction = float(np.mean(counts.values < noise.offset))
        if dark_fraction > _MAX_DARK:
            text = f"{percent(dark_fraction)} of the counts of the first frames are below the offset: check `offset`"
            found.append(Finding("below_offset", "doubt", text, {"share": dark_fraction}))
        if remark := flat_tops([counts], noise, "movie"):
            is_clipped = flat_top(counts.values, counts.known, noise)[1] > 0
            found.append(Finding("flat_top", "doubt" if is_clipped else "note", remark))
        found += (Finding(one.code, one.severity, one.text) for one in scale_findings([counts[:1]], noise))
        if counts.assumed:
            found.append(Finding("saturation_assumed", "note", counts.assumed))
        return cls(steady, tuple(found))


class Checks:
    """Checks of successive blocks of frames; `refit` is a function that fits boxes with a given table."""

    def __init__(
        self, recording: MovieInfo, table: Table, refit: partial[Molecules], background: str,
        surface: FocalSurface | None, of_recording: Sequence[Finding],
    ) -> None:  # fmt: skip
        self._stated = {} if surface is None else surface.terms
        self._recording, self._table, self._refit, self._background = recording, table, refit, background
        self._noise: Noise = refit.keywords["noise"]
        self._once = {finding.code: finding for finding in of_recording}
        self._counts = np.zeros((recording.rows, recording.columns), np.int64)
        self._sums = dict.fromkeys(
            ("spots", "borders", "overlapping", "saturated", "left_out", "ends", "doubtful"), 0
        )
        # Histograms of the discrepancies of all molecules, and of isolated ones.
        self._discrepancies = np.zeros((2, 2 * _WIDEST * _PER_UNIT + 1), np.int64)
        self._maxima, self._frames, self._steady, self._places = 0, 0, 0, list[Array]()
        # Number, sum and sum of squares of normalised residuals at each pixel of the camera.
        self._fixed = np.zeros((3, *self._counts.shape))
        self._residuals: list[tuple[Array, ...]] = []
        self._excess: list[Finding] = []
        self._rival = None if recording.along == "none" else rival_of(table)
        self._gains, self._compared = list[float](), 0
        self._changes = TableTest(table)
        pupil, pixel = table.pupil, recording.pixel
        if (finest := pupil.wavelength / (4.0 * pupil.layers.NA)) * _MIN_NYQUIST_RATIO > pixel:
            text = (
                f"a pixel is {format_length(pixel, digits=3)} in the sample, far below the Nyquist pixel, "
                f"{format_length(finest, digits=3)}: `pixel` is the pitch on the camera, not in the sample"
            )
            self._add_once("pixel_pitch", "doubt", text, pixel=pixel, nyquist=finest)
        terms = {} if pupil.aberrations is None else pupil.aberrations.amplitudes()
        if recording.along != "none" and not any(n % 2 == 0 and (n, m) != (2, 0) for n, m in terms):
            text = (
                "the wavefront has no even term besides defocus, such as astigmatism: images above and below focus "
                "are nearly alike, and z may have the wrong sign; use `flat` to estimate only x and y"
            )
            self._add_once("sign_open", "doubt", text)

    def _add_once(self, code: str, severity: Severity, text: str, **numbers: Any) -> None:
        self._once.setdefault(code, Finding(code, severity, text, numbers))

    def first(self, found: FirstFrames) -> None:
        """Take up the findings of the first block."""
        self._steady = found.steady
        for finding in found.findings:
            if finding.code != "below_offset" or "missing_chunks" not in self._once:  # missing chunks count as dark
                self._once.setdefault(finding.code, finding)

    def tilt(self, spots: Spots, molecules: Molecules, *, fitted: bool) -> float:
        """Test the wavefront of the table and, unless slopes of the background were `fitted`, slopes and noise.

        Return the significance of the slope in standard deviations, or 0 if slopes were fitted.
        """
        if self._fixed[0].sum() < _MOLECULES * math.prod(self._recording.box):
            self._add_residuals(spots, molecules)
        if fitted and self._changes.done:
            return 0.0
        score = scored(spots, molecules, self._table, self._noise, self._changes.images)
        if score is None:
            return 0.0
        sizes = self._changes.add(score)
        if fitted:
            return 0.0
        score = score.without_changes(sizes)
        if sum(len(residual) for residual, _, _ in self._residuals) < _MOLECULES:
            self._residuals.append((score.residual, score.mean, score.read))
            residual, mean, read = (np.concatenate(arrays) for arrays in zip(*self._residuals, strict=True))
            self._excess = excess_test(residual, mean, read).findings(self._noise.excess)
        sigmas, slope, error = score.tilt((self._recording.rows, self._recording.columns))
        if sigmas > TILTED:
            # Fits use electrons divided by the excess noise factor.
            slope, error = slope * self._noise.excess, error * self._noise.excess
            flat = self._background == "flat"
            text = (
                f"the background is tilted, by {slope:.2g} +- {error:.1g} electrons from pixel to pixel "
                f"({sigmas:.0f} standard deviations)"
            )
            text += ': positions are shifted; `background` "tilted" or "auto" fits it' if flat else ": it was fitted"
            numbers = {"slope": slope, "error": error, "sigmas": sigmas}
            self._add_once("tilted_background", "doubt" if flat else "note", text, **numbers)
        return sigmas

    def _add_residuals(self, spots: Spots, molecules: Molecules) -> None:
        if (score := scored(spots, molecules, self._table, self._noise, everything=True)) is not None:
            residual = score.residual / np.sqrt(score.mean + score.read)
            pixels = tuple(np.broadcast_arrays(*box_pixels(score.corners, self._recording.box)))
            for total, values in zip(self._fixed, (residual**0, residual, residual**2), strict=True):
                np.add.at(total, pixels, np.nan_to_num(values))

    @property
    def fixed(self) -> float:
        """Variance of the mean residuals of pixels of the camera, over that of noise: 1 without fixed structure."""
        count, total, squares = self._fixed[:, self._fixed[0] > 1.0]
        between, free = float((total**2 / count).sum()), float((count - 1.0).sum())
        return between / count.size * free / (float(squares.sum()) - between) if free else 1.0

    def compare(self, spots: Spots, background: str) -> None:
        """Compare fits of the first molecules with fits by the rival; `background` is "flat" or "tilted"."""
        part = slice(_MOLECULES - self._compared)
        if self._rival is None or self._compared >= _MOLECULES or not len(spots):
            return
        self._compared += len(spots)
        refit = partial(self._refit, images=spots.images[part], corners=spots.corners[part], background=background)
        fits, rival = refit(self._table), refit(self._rival)
        # Images of crowded molecules, which have large discrepancies, are no test of the PSF.
        usable = fits.converged & rival.converged & (np.minimum(fits.discrepancy, rival.discrepancy) < DOUBTFUL)
        self._gains += (rival.log_likelihood - fits.log_likelihood)[usable].tolist()

    def count(self, part: Localizations, isolated: NDArray[np.bool_], frames: int) -> None:
        """Add the localisations of a block of `frames`; `isolated` is the attribute of their spots."""
        pixels = (np.floor(part.table[name] / self._recording.pixel).astype(np.int64) for name in "yx")
        # Positions at the edge may round to a pixel outside.
        places = (np.clip(pixel, 0, side - 1) for pixel, side in zip(pixels, self._counts.shape, strict=True))
        np.add.at(self._counts, tuple(places), 1)
        self._maxima += part.spots + part.borders + part.overlapping
        self._frames += frames
        if sum(map(len, self._places)) < _MAX_SURFACE:
            good = part.table[part.kept & ~part.doubtful]
            self._places.append(np.stack([good[name] for name in ("y", "x", "z", "z_error")], axis=1))
        discrepancies = part.table["discrepancy"][part.kept]
        for name in self._sums:
            self._sums[name] += int((discrepancies >= DOUBTFUL).sum()) if name == "doubtful" else getattr(part, name)
        bins = np.round(np.clip(discrepancies, -_WIDEST, _WIDEST) * _PER_UNIT).astype(np.int64) + _WIDEST * _PER_UNIT
        for total, chosen in zip(self._discrepancies, (bins, bins[isolated[part.kept]]), strict=True):
            total += np.bincount(chosen, minlength=total.size)

    @property
    def molecules(self) -> int:
        """Number of molecules whose fits converged."""
        return int(self._discrepancies[0].sum())

    @property
    def median(self) -> float:
        """Median of the discrepancies, without large ones; of isolated molecules if a movie is dense."""
        sums = np.cumsum(self._discrepancies, axis=1)
        sums = sums[int(self._is_dense and sums[1, -1] >= _MIN_ISOLATED)]
        # The median of the discrepancies below the median of all plus DOUBTFUL.
        middle = int(np.searchsorted(sums, 0.5 * sums[-1])) + int(DOUBTFUL * _PER_UNIT)
        middle = int(np.searchsorted(sums, 0.5 * sums[min(middle, sums.size - 1)]))
        return middle / _PER_UNIT - _WIDEST if self.molecules else 0.0

    @property
    def _by_chance(self) -> tuple[float, float]:
        """Probabilities of a second molecule in the box, and nearer than _PAIR."""
        density = self._maxima / (max(self._frames, 1) * self._counts.size)
        areas = math.prod(self._recording.box), math.pi * (_PAIR / self._recording.pixel) ** 2
        return -math.expm1(-density * areas[0]), -math.expm1(-density * areas[1])

    @property
    def _is_dense(self) -> bool:
        has_neighbors = self._discrepancies[1].sum() < (1.0 - _DENSE) * self.molecules
        blinks = self._steady * self._frames < _STEADY * self._maxima
        return has_neighbors and blinks and self._by_chance[0] > _DENSE

    @property
    def _is_structured(self) -> bool:
        return not self._is_dense and self.fixed > _FIXED  # neighbours that blink in one place are structure, too

    @property
    def summary(self) -> str:
        """Number of molecules and median discrepancy."""
        n, frames = self.molecules, self._recording.frames
        median = f", median discrepancy {self.median:.2g}" if n else ""
        return f"{n} molecule{'s' * (n != 1)} in {frames} frame{'s' * (frames != 1)}{median}"

    @property
    def findings(self) -> Findings:
        """Findings of the blocks checked so far."""
        changes, of_fits = self._changes.findings, [*self._fit_findings()]
        if self._is_explained and any(one.code == "misfit" and one.severity == "error" for one in of_fits):
            changes = [replace(one, severity="error") for one in changes]
        excess = [] if self._is_dense else self._excess
        groups = excess, self._rival_findings(), changes, of_fits, self._surface(), self._once.values()
        first = {"crowded"} if self._is_dense else {"misfit", "crowded"} if self._is_structured else set()
        found = sorted(chain(*groups, self._spot_findings()), key=lambda one: one.code not in first)
        return Findings(sorted(found, key=lambda one: one.code != "flat_top"))  # clipping explains the others

    @property
    def _is_explained(self) -> bool:
        """Whether changes of the images explain the median discrepancy."""
        # Chi2 of one molecule has the standard deviation sqrt(2 pixels), the unit of the discrepancy.
        return 2.0 * self._changes.gain > _CAUSE * self.median * math.sqrt(2.0 * math.prod(self._recording.box))

    def _rival_findings(self) -> Iterator[Finding]:
        """Yield the finding that the rival is likelier, if its gain of log-likelihood is significant.

        For molecules of 500 photons on the cover glass, the right sign of an astigmatism increases the log-likelihood
        by only 0.1 per molecule: about a thousand molecules are needed to determine the sign.
        """
        # The standard deviation of a sum of n independent gains is sqrt(n) times the deviation of one gain.
        count, gain = len(self._gains), math.fsum(self._gains)
        error = float(np.std(self._gains or 0.0)) * math.sqrt(count)
        is_explained = self._changes.gain * count > _MIN_GAIN_RATIO * gain  # by changes of the table
        if count < _MIN_COMPARED or gain <= max(_MIN_GAIN, 4.0 * error) or is_explained:
            return
        text = (
            f"{count} molecules of the first frames are likelier with astigmatism of the opposite sign "
            f"(log-likelihood {gain:.3g} +- {error:.2g} larger), and z is then reversed: check the sign of the "
            "astigmatism and the direction of the movie's rows"
        )
        numbers: Json = {"molecules": count, "log_likelihood": gain, "error": error}
        yield Finding("opposite_astigmatism", "error", text, numbers)

    def _fit_findings(self) -> Iterator[Finding]:
        sums, n = self._sums, self.molecules
        if not sums["spots"] and (left := sums["borders"] + sums["overlapping"]):
            side = " x ".join(map(str, self._recording.box))
            text = f"none of {left} spots can be fitted: boxes of {side} pixels reach beyond the border at "
            text += f"{sums['borders']} of them, and {sums['overlapping']} are"
            yield Finding("not_settled", "error", f"{text} beside brighter ones")
        elif not sums["spots"]:
            text = "no spot is six standard deviations above the noise: check `offset`, `white` and `read`"
            yield Finding("no_light", "error", text)
        elif not n:
            yield Finding("not_settled", "error", f"none of {sums['spots']} fits converged within the table")
        if not n:
            return
        # The standard error of the median of n normal deviates is sqrt(pi / (2 n)).
        median, error = self.median, math.sqrt(0.5 * math.pi / n)
        numbers = {"median": median, "error": error}
        text = f"the median discrepancy, {median:.2g}, is not 0 within its standard error, {error:.1g}"
        if median > max(_DISCREPANT, 4.0 * error):
            if self._is_structured:
                text += ": the background is not flat within boxes, or the camera needs maps of gain and offset"
            elif not (self._is_explained or self._is_dense):
                text += ": the PSF (sign of the astigmatism, depth, indices, wavelength), gain or offset may be wrong"
            yield Finding("misfit", "error" if median > _MISFIT else "doubt", text, numbers)
        elif median < -max(_DISCREPANT, 4.0 * error):
            yield Finding("too_quiet", "doubt", f"{text}: check gain (`white`) and `offset`", numbers)
        # Report doubtful molecules if their number exceeds the number due to chance by four standard deviations.
        doubtful, (box, pair) = sums["doubtful"], self._by_chance
        many = doubtful > 1.0 + _BY_CHANCE * n + 4.0 * math.sqrt(_BY_CHANCE * n)
        if self._is_dense or (median < _MISFIT and many):
            cause = "a background that is not flat" if self._is_structured else "a second molecule in the box"
            text = f"{doubtful} of {n} molecules have images that noise does not explain, as because of {cause}"
            if self._is_dense:
                text += f", as {percent(box)} of boxes have by chance; {percent(pair)} have one nearer than 170 nm"
            is_error, is_doubt = self._is_dense and doubtful > _MOST * n, doubtful > _CROWDED * n
            text += f": leave out molecules with a discrepancy of {DOUBTFUL:g} or more"
            chances = {"doubtful": doubtful, "molecules": n, "box_by_chance": box, "pair_by_chance": pair}
            yield Finding("crowded", "error" if is_error else "doubt" if is_doubt else "note", text, chances)
        if self._recording.along != "none":
            untested = sorted(self._changes.untested.items(), key=lambda item: -item[1][2])
            sizes: Json = {name: {"error": size, estimate: bias} for name, (size, estimate, bias) in untested}
            not_testable = _NOT_TESTABLE[bool(self._stated) :]
            sizes |= {name: {} for name in not_testable}
            items = [f"{name} ({_format_error(name, by)} moves {of} {q:.2g} se)" for name, (by, of, q) in untested]
            items[1:1] = not_testable
            yield untested_finding(items, sizes, "not excluded")

    def _surface(self) -> Iterator[Finding]:
        """Yield the finding that z follows a surface of the second degree over the field, from medians of parts."""
        places = np.concatenate([*self._places, np.empty((0, 4))])
        if self._recording.along == "none" or len(places) < _MIN_SURFACE:
            return
        scaled = places[:, :2] / (0.5 * self._recording.pixel * np.array(self._counts.shape)) - 1.0
        cell = np.clip(0.5 * _PARTS * (scaled + 1.0), 0, _PARTS - 1).astype(int) @ (_PARTS, 1)
        points = np.column_stack([scaled, places[:, 2]])
        parts = [np.median(points[cell == k], axis=0) for k in np.unique(cell)]
        y, x, z = np.transpose(parts)
        if (free := len(z) - 6) < 6:
            return
        columns = np.stack([np.ones_like(x), x, y, x * x, x * y, y * y], axis=1)  # 1, and the terms SURFACE
        c = np.linalg.lstsq(columns, z)[0]
        covariance = np.linalg.inv(columns.T @ columns)[1:, 1:] * np.square(z - columns @ c).sum() / free
        chance = float(scipy.special.fdtrc(5, free, c[1:] @ np.linalg.solve(covariance, c[1:]) / 5.0))
        size, bias = float(np.ptp(columns @ c)), float(np.std(columns @ c) / np.median(places[:, 3]))
        if chance < _RARE and bias > _BIASED:
            terms = {name: z + self._stated.get(name, 0.0) for name, z in zip(SURFACE, c[1:].tolist(), strict=True)}
            entries = ", ".join(f'{name} = "{1e9 * z:.3g} nm"' for name, z in terms.items())
            text = (
                f"z follows a tilted or curved surface, {format_length(size, digits=2)} over the field: unless it is "
                f"the specimen, z is off by {bias:.2g} standard errors rms; if beads on the glass agree, state "
                f"[focal_surface] frame = {[*self._counts.shape]}, terms = {{ {entries} }}"
            )
            yield Finding("not_flat", "doubt", text, {"size": size, "bias": bias, "chance": chance, "surface": terms})

    def _spot_findings(self) -> Iterator[Finding]:
        sums = self._sums
        reasons = {"saturated": "saturated", "left_out": "NaN, infinite or masked"}
        if counts := [f"{sums[name]} {reason}" for name, reason in reasons.items() if sums[name]]:
            text = f"pixels of boxes that were left out: {', '.join(counts)}"
            yield Finding("left_out", "note", text, {name: sums[name] for name in reasons})
        if places := self._recurring():
            row, column, count = places[0]
            subject = "a spot is" if len(places) == 1 else f"{len(places)} spots are"
            text = (
                f"{subject} in the same place in many frames, the first in {count} of {self._recording.frames} at "
                f"row {row}, column {column}: a bead, or a hot pixel; to leave it out, use `mask`, or a map `read` "
                f"with {DEFECT:g} electrons there"
            )
            yield Finding("recurring", "note", text, {"places": places})
        if self._recording.along != "none" and sums["ends"] > _MAX_AT_ENDS * sums["spots"]:
            ends, spots = sums["ends"], sums["spots"]
            text = f"{ends} of {spots} spots are at an end of the range of z: use a wider range"
            yield Finding("z_range", "note", text, {"ends": ends, "spots": spots})

    def _recurring(self) -> list[tuple[int, int, int]]:
        """Return row, column and number of spots (within a pixel) of recurring spots, the most frequent first."""
        counts, min_count = self._counts, _RECURRING * self._recording.frames
        if self._recording.frames < _MIN_FRAMES or counts.sum() < min_count:
            return []
        # Spots of one emitter may be located on neighbouring pixels.
        sums = scipy.ndimage.convolve(counts, np.ones((3, 3), np.int64), mode="constant")
        row, column = np.nonzero(
            (sums >= min_count) & (counts == scipy.ndimage.maximum_filter(counts, 5)) & (counts > 0)
        )
        order = np.argsort(-sums[row, column], kind="stable")
        return [(int(row[k]), int(column[k]), int(sums[row[k], column[k]])) for k in order]


def _format_error(name: str, size: float) -> str:
    """Return the size of an error of a constant as text."""
    if name == "depth":
        return format_length(size, digits=2)
    return f"{100.0 * size:.2g} % of it" if name == "wavelength" else f"{size:.2g} of it"


def _label(test: ScoreTest) -> str:
    """Return a change of the images and its size as text."""
    size = " +- ".join(with_error(test.size[0], test.errors[0]))
    if test.name != _BLUR:
        is_term = test.name not in _CONSTANTS
        return f"{test.name} {'=' if is_term else 'off by'} {size}{' rad' if is_term else _UNITS.get(test.name, '')}"
    angle = 0.5 * math.degrees(math.atan2(test.size[2], -test.size[1])) % 180.0
    is_long = math.hypot(*test.size[1:]) > 5.0 * test.errors[1:].max()
    direction = f", most along {angle:.0f} degrees from columns to rows" if is_long else ""
    return f"blur of {math.sqrt(test.size[0]):.2g} pixels rms (variance {size} pixels^2{direction})"


def _change_constant(pupil: ObjectivePupil, along: str, name: str, change: float) -> ObjectivePupil:
    """Return a pupil with the constant `name` increased by `change` (wavelength: relative).

    "depth" is the depth of the molecules if z is along the stage, and the depth in focus if z is the depth.
    """
    if name == "wavelength":
        return pupil.in_light(pupil.wavelength * (1.0 + change))
    if name == "depth":
        if along == "depth":
            return replace(pupil, focus=pupil.focus + change)
        return replace(pupil, depth=pupil.depth + change)
    return replace(pupil, layers=replace(pupil.layers, **{name: getattr(pupil.layers, name) + change}))


class ChangeImages:
    """Derivatives of the images of a table by Zernike terms (radians rms), constants and blur, in the table's range.

    Blur has three columns: with variances vy, vx and covariance c of a kernel that blurs the images (pixels^2), they
    are (vy + vx) / 2, (vy - vx) / 2 and c.

    Attributes
    ----------
    columns : dict of str to list of int
        Columns of each term by its label, of each constant by its name, and of blur.
    scales : ndarray
        Expected size of each column.
    """

    def __init__(self, table: Table) -> None:
        self._table, waves = table, Waves(table.pupil, table.along)
        low, high = table.z
        planes = max(4, math.ceil((high - low) * waves.rate / _PHASE_STEP) + 1)
        self._per_plane = (planes - 1) / (high - low)
        height, width = (_SUBPIXELS * (2 * (side // 2 + math.ceil(table.reach) + 1) + 1) for side in table.shape)
        self._middle = height // 2, width // 2
        image = partial(psf, shape=(height, width), pixel=table.pixel / _SUBPIXELS, tol=1e-3, integrate=True)
        pupil = waves.at(np.linspace(low, high, planes))
        images, derivatives = image(pupil).values, image(pupil, derivatives=_TERMS).derivatives
        changes = [derivatives[term] * zernike.rms_factor(*term) for term in _TERMS]
        layers, names, scales = pupil.layers, [label(term) for term in _TERMS], [_TERM] * len(_TERMS)
        for name, size in _CONSTANTS.items():
            step = _STEP * size
            if name == "immersion" and layers.immersion == 1.0:
                continue
            if name in ("immersion", "NA") and layers.NA + 2.0 * step >= layers.immersion:
                continue  # NA must be less than the index of the immersion
            # A forward difference, because the depth of molecules on the cover glass cannot be reduced.
            changes.append((image(_change_constant(pupil, table.along, name, step)).values - images) / step)
            names.append(name)
            scales.append(size)
        # A narrow kernel changes an image by half the sum of its covariances times second derivatives.
        y, x = np.gradient(_SUBPIXELS**2 * images, axis=(1, 2))
        rows, columns, oblique = np.gradient(y, axis=1), np.gradient(x, axis=2), np.gradient(x, axis=1)
        changes += [0.5 * (rows + columns), 0.5 * (rows - columns), oblique]
        self.columns = {name: [k] for k, name in enumerate(names)} | {_BLUR: [len(names) + k for k in range(3)]}
        self.scales = np.array([*scales, *[_VARIANCE] * 3])
        sides = 0, _SUBPIXELS, _SUBPIXELS
        averaged = (_SUBPIXELS**2 * scipy.ndimage.uniform_filter(change, sides) for change in changes)
        self._splines = [scipy.ndimage.spline_filter(change) for change in averaged]

    def combined(self, sizes: Array) -> ChangeImages:
        """Return a single change, the sum of all changes multiplied by `sizes`."""
        total = copy(self)
        total._splines = [np.tensordot(sizes, self._splines, 1)]
        return total

    def __call__(self, row: Array, column: Array, z: Array) -> Array:
        """Return the changes of the images of molecules, (n, changes, height, width); for arguments see `Table`."""
        height, width = self._table.shape
        points = np.empty((3, len(row), height, width))
        points[0] = ((z - self._table.z[0]) * self._per_plane)[:, None, None]
        points[1] = self._middle[0] + _SUBPIXELS * (np.arange(height) - row[:, None])[:, :, None]
        points[2] = self._middle[1] + _SUBPIXELS * (np.arange(width) - column[:, None])[:, None, :]
        return np.stack(
            [scipy.ndimage.map_coordinates(spline, points, prefilter=False) for spline in self._splines], axis=1
        )


class Score(NamedTuple):
    """Score and information of n molecules, with all parameters of the fits eliminated; positions and residuals.

    Columns are two ramps of the background, along rows and columns, then the changes of the images. `bias` (n, 4,
    changes) is the bias of row, column, z and photons due to a unit of each change, in standard errors.
    """

    slope: Array
    information: Array
    bias: Array
    row: Array
    column: Array
    residual: Array
    mean: Array
    read: Array
    corners: NDArray[np.int64]

    def without_changes(self, sizes: Array) -> Score:
        """Return the score with the contribution of changes of these `sizes` subtracted."""
        # To first order the contribution is the information between columns and changes, times the sizes.
        return self._replace(slope=self.slope - self.information[:, :, 2:] @ sizes)

    def tilt(self, shape: tuple[int, int]) -> tuple[float, float, float]:
        """Return the significance of background slopes (standard deviations), the largest slope, and its error.

        There are two tests: a single slope for all molecules, and one slope for each of 4 x 4 parts of the frame. The
        more significant result is returned.
        """
        cell = np.clip((4 * self.row / shape[0]).astype(int), 0, 3) * 4
        cell += np.clip((4 * self.column / shape[1]).astype(int), 0, 3)
        tests = []
        for parts in (np.zeros_like(cell), cell):
            group = (parts == np.unique(parts)[:, None]).astype(float)
            slopes = group @ self.slope[:, :2]
            information = np.tensordot(group, self.information[:, :2, :2], 1)
            sizes = np.linalg.solve(information, slopes[..., None])[..., 0]
            errors = np.sqrt(np.diagonal(np.linalg.inv(information), axis1=1, axis2=2))
            largest = np.unravel_index(np.abs(sizes / errors).argmax(), sizes.shape)
            # The sum of squares of 2 n normal deviates has a chi-squared distribution with 2 n degrees of freedom.
            chance = float(scipy.special.gammaincc(len(group), 0.5 * (slopes * sizes).sum()))
            tests.append((chance, abs(float(sizes[largest])), float(errors[largest])))
        chance, size, error = min(tests)
        # The two-sided deviation of a normal variable, in standard deviations, with this probability.
        return float(-scipy.special.ndtri(max(0.5 * chance, 1e-300))), size, error


def _eliminate(information: Array, slope: Array, count: int) -> tuple[Array, Array, Array]:
    """Eliminate the first `count` columns of each molecule; return information, slope and regression coefficients.

    The information is the Schur complement. The coefficients (n, count, columns) result from the regression of the
    remaining columns on the eliminated columns.
    """
    regression = np.asarray(np.linalg.solve(information[:, :count, :count], information[:, :count, count:]), float)
    reduced = information[:, count:, count:] - information[:, count:, :count] @ regression
    return reduced, slope[:, count:] - np.einsum("nki,nk->ni", regression, slope[:, :count]), regression


def tested(spots: Spots, molecules: Molecules, table: Table, *, everything: bool) -> NDArray[np.intp]:
    """Return the indices of the molecules that :func:`scored` tests."""
    positions = np.column_stack([molecules.row, molecules.column]) - spots.corners
    usable = molecules.converged & (np.abs(positions - np.array(table.shape) // 2) < table.reach).all(axis=1)
    # Molecules with neighbours are left out, because a neighbour resembles a slope of the background.
    if not everything and usable.any():
        if (usable & spots.isolated).sum() >= _MIN_ISOLATED:
            usable &= spots.isolated
        usable &= molecules.discrepancy < np.median(molecules.discrepancy[usable]) + DOUBTFUL
    return np.flatnonzero(usable)[:_MOLECULES]


def with_images(spots: Spots, molecules: Molecules, table: Table) -> NDArray[np.intp]:
    """Return the indices of the spots whose images the checks of a block need."""
    first = np.arange(min(len(spots), _MOLECULES))
    return np.unique(np.concatenate([first, *(tested(spots, molecules, table, everything=e) for e in (False, True))]))


def scored(
    spots: Spots, molecules: Molecules, table: Table, camera: Noise, changes: ChangeImages | None = None,
    *, everything: bool = False,
) -> Score | None:  # fmt: skip
    """Return the score of background slopes and of `changes` in the boxes of fits; None if no fit converged.

    Crowded molecules are left out. With `everything` they are not, and residuals are without slopes.
    """
    chosen = tested(spots, molecules, table, everything=everything)
    parts = (chosen[k : k + _TOGETHER] for k in range(0, chosen.size, _TOGETHER))
    scores = [_score(spots, molecules, table, camera, changes, part, everything=everything) for part in parts]
    return Score(*map(np.concatenate, zip(*scores, strict=True))) if scores else None


def _score(
    spots: Spots, molecules: Molecules, table: Table, camera: Noise, changes: ChangeImages | None,
    chosen: NDArray[np.intp], *, everything: bool,
) -> Score:  # fmt: skip
    """Return the score of the molecules `chosen`, see :func:`scored`."""
    height, width = table.shape
    positions = np.column_stack([molecules.row, molecules.column]) - spots.corners
    counts, read = in_electrons(spots.images[chosen], camera, spots.corners[chosen])
    places = positions[chosen, 0], positions[chosen, 1], molecules.z[chosen]
    values, derivatives = table(*places, derivatives=True)
    photons, level = (
        values[chosen, None, None] / camera.excess for values in (molecules.photons, molecules.background)
    )
    ramps = np.mgrid[:height, :width] - 0.5 * np.array([height - 1, width - 1])[:, None, None]
    z = "depth" if "depth" in derivatives else "z"
    fitted = [derivatives["row"], derivatives["column"], derivatives[z] * _MICRON, values, np.ones_like(values)]
    columns = np.stack([*fitted, *(np.broadcast_to(ramp, values.shape) for ramp in ramps)], axis=1, dtype=float)
    columns[:, :3] *= photons[:, None]
    if changes is not None:
        columns = np.concatenate([columns, photons[:, None] * changes(*places)], axis=1)
    mean = np.maximum(photons * values + level, 0.01)
    weight = np.where(np.isfinite(counts), 1.0 / (mean + read), 0.0)
    # The score: sum over pixels of (count - mean) / variance * (derivative of the mean).
    score = np.einsum("nkyx,nyx->nk", columns, np.nan_to_num(counts - mean) * weight)
    vectors = columns.reshape(len(chosen), columns.shape[1], -1)
    information = (vectors * weight.reshape(len(chosen), 1, -1)) @ vectors.swapaxes(1, 2)
    reduced, slope, regression = _eliminate(information, score, 5)
    errors = [getattr(molecules.errors, name)[chosen] for name in _BIASES]
    errors[2], errors[3] = errors[2] / _MICRON, errors[3] / camera.excess
    bias = regression[:, :4, 2:] / np.stack(errors, axis=1)[:, :, None]
    # Correct residuals for the five fitted parameters.
    pixels = np.isfinite(counts).sum(axis=(1, 2))
    residual = (counts - mean) * np.sqrt(pixels / np.maximum(pixels - 5, 1))[:, None, None]
    if everything:
        sizes = np.linalg.solve(reduced[:, :2, :2], slope[:, :2, None])
        residual -= (sizes[..., None] * ramps).sum(axis=1)
    read, at = np.broadcast_to(read, mean.shape), (molecules.row[chosen], molecules.column[chosen])
    return Score(slope, reduced, bias, *at, residual, mean, read, spots.corners[chosen])


class TableTest:
    """Score tests of changes of a table's images with the first molecules, allowing for tilted backgrounds."""

    def __init__(self, table: Table) -> None:
        self._table = table
        self._square: Array = np.zeros(())
        self._pull: Array = np.zeros(())
        self._bias = np.zeros((0, len(_BIASES), 0))
        self._sizes: Array = np.zeros(0)
        self._sum: ChangeImages | None = None

    @property
    def done(self) -> bool:
        """Whether at least _TEST_MOLECULES molecules were tested."""
        return len(self._bias) >= _TEST_MOLECULES

    @property
    def _images(self) -> ChangeImages:
        cache = vars(self._table)
        if "_changes" not in cache:
            cache["_changes"] = ChangeImages(self._table)
        images: ChangeImages = cache["_changes"]
        return images

    @property
    def images(self) -> ChangeImages | None:
        """Images of the changes; if `done`, the sum of significant changes instead, or None if there are none."""
        return self._sum if self.done else self._images

    def add(self, score: Score) -> Array:
        """Add the molecules of a block; return the sizes of the changes in the columns of its score."""
        if self.done:
            return np.ones(score.bias.shape[-1])
        reduced, slope, _ = _eliminate(score.information, score.slope, 2)  # the two slopes of backgrounds
        self._square, self._pull = self._square + reduced.sum(axis=0), self._pull + slope.sum(axis=0)
        self._bias = np.concatenate([self._bias, score.bias]) if len(self._bias) else score.bias
        self._sizes = self._significant_sizes()
        # Later blocks use the sum of significant changes.
        if len(self._bias) >= _TEST_MOLECULES and self._sizes.any():
            self._sum = self._images.combined(self._sizes)
        return self._sizes

    def tests(self, eliminated: Sequence[int] = ()) -> tuple[ScoreTest, ...]:
        """Return a test of each change, after elimination of the changes with the indices `eliminated`."""
        if not len(self._bias):
            return ()
        columns, scales = self._images.columns, self._images.scales.tolist()
        candidates = [Candidate(name, (*k,), scales[k[0]]) for name, k in columns.items() if k[0] not in eliminated]
        tests = score_tests(self._square, self._pull, eliminated, candidates)
        return tuple(test for test in tests if test.name != _BLUR or test.size[0] > 0.0)

    def _significant_sizes(self) -> Array:
        """Return the sizes of significant changes, which are selected one by one; 0 for all other changes."""
        sizes, chosen = np.zeros(len(self._pull)), list[int]()
        while significant := seen(self.tests(chosen)):
            chosen += self._images.columns[significant[0].name]
        if chosen:
            # The expected sizes are a prior, because chosen changes may be nearly linearly dependent.
            square = self._square[np.ix_(chosen, chosen)] + np.diag(self._images.scales[chosen] ** -2.0)
            sizes[chosen] = np.linalg.solve(square, self._pull[chosen])
        return sizes

    @property
    def gain(self) -> float:
        """Mean gain of log-likelihood per molecule due to the significant changes, to second order in their sizes."""
        return 0.5 * float((self._sizes * self._pull).sum()) / max(len(self._bias), 1)

    @property
    def findings(self) -> list[Finding]:
        """The finding on significant changes, empty if there are none."""
        significant = seen(self.tests())
        if not significant:
            return []
        strongest, sizes = self._images.columns[significant[0].name], self._sizes
        biases = np.sqrt(np.square(self._bias[:, :, strongest] @ sizes[strongest]).mean(axis=0))
        total_biases = np.sqrt(np.square(self._bias @ sizes).mean(axis=0))
        labels = [_label(test) for test in significant]
        cause = other_explanation(significant, [f"{labels[0]} beside what the table states", *labels[1:]])
        name, is_blur = _BIASES[int(biases.argmax())], significant[0].name == _BLUR
        step = "no entry of a file states blur: stop vibration and motion" if is_blur else "fit the pupil to beads"
        text = f"{cause.text}: this moves {name} by {biases.max():.2g} standard errors rms; {step}"
        numbers = {**cause.numbers, "bias": dict(zip(_BIASES, biases.tolist(), strict=True))}
        severity: Severity = "doubt" if max(biases.max(), total_biases.max()) >= _BIASED else "note"
        return [Finding(cause.code, severity, text, numbers)]

    @property
    def untested(self) -> dict[str, tuple[float, str, float]]:
        """Errors of constants that the molecules do not exclude: (error, biased estimate, bias) by constant.

        The bias is in standard errors of the estimate.
        """
        errors, result = {test.name: float(test.errors[0]) for test in self.tests()}, {}
        for name, size in _CONSTANTS.items():
            if not len(self._bias) or name not in self._images.columns:
                continue
            error = min(2.0 * errors.get(name, np.inf), _MAX_STATED * size)
            biases = error * np.sqrt(np.square(self._bias[:, :, self._images.columns[name][0]]).mean(axis=0))
            if biases.max() > _BIASED:
                result[name] = error, _BIASES[int(biases.argmax())], float(biases.max())
        return result


def rival_of(table: Table) -> Table | None:
    """Return the table for the opposite sign of astigmatism, cached in `table`; None without astigmatism."""
    wave, cache = table.pupil.aberrations, vars(table)
    if wave is None or not any(abs(m) == 2 for _, m in wave.amplitudes()):
        return None
    if "_rival" not in cache:
        # Terms with |m| = 2 are astigmatism of all orders.
        edges = {(n, m): -edge if abs(m) == 2 else edge for (n, m), edge in zip(wave.terms, wave.edge.T, strict=True)}
        pupil = replace(table.pupil, aberrations=Wavefront.from_edge(edges, wave.error))
        settings: dict[str, Any] = {name: getattr(table, name) for name in ("z", "along", "reach", "tol")}
        cache["_rival"] = Table(pupil, table.shape, table.pixel, **settings)
    rival: Table = cache["_rival"]
    return rival
