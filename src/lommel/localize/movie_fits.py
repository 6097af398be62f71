"""Localisation of the molecules of a movie: frames in blocks, spots, fits, positions in the sample."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import fields, replace
from functools import partial
from itertools import chain
from os import PathLike
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy import ndimage, special

from lommel.base import validation
from lommel.base.arrays import Array, Json, Values
from lommel.base.units import format_length
from lommel.fit.findings import Finding, Findings, Severity
from lommel.fit.goodness_of_fit import excess_test
from lommel.localize.detection import DEFECT, Spots, box_pixels, find, frame_counts
from lommel.localize.fitting import BACKGROUNDS, STATES, MoleculeErrors, Molecules, fit, in_electrons
from lommel.localize.localizations import DOUBTFUL, Localizations, Recording, columns, joined
from lommel.localize.table import Table
from lommel.optics.layers.objective import brightest
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.recorded.counts import Counts, flat_tops
from lommel.recorded.frames import BLOCK, Movie, open_movie
from lommel.recorded.noise import Noise


class Checks:
    """What blocks of frames tell, one after the other."""

    def __init__(self, recording: Recording, table: Table, again: partial[Molecules], background: str) -> None:
        self._recording, self._table, self._again, self._background = recording, table, again, background
        self._noise: Noise = again.keywords["noise"]
        self._once: dict[str, Finding] = {}
        self._counts = np.zeros((recording.rows, recording.columns), np.int64)
        self._sums = dict.fromkeys(("spots", "saturated", "left_out", "ends", "doubtful"), 0)
        self._discrepancies = np.zeros(2 * _WIDEST * _PER_UNIT + 1, np.int64)
        self._residuals: list[tuple[Array, ...]] = []
        self._excess: list[Finding] = []
        self._rivals = {} if recording.along == "none" else rivals(table, again.keywords["threads"])
        self._gains: dict[str, list[float]] = {name: [] for name in self._rivals}
        self._tried = 0
        pupil, pixel = table.pupil, recording.pixel
        if (finest := pupil.wavelength / (4.0 * pupil.layers.NA)) * _FINE > pixel:
            text = (
                f"a pixel is {format_length(pixel, digits=3)} in the sample, far below Nyquist's "
                f"{format_length(finest, digits=3)}: `pixel` is that of the camera, before magnification"
            )
            self._add_once("pixel_pitch", "doubt", text, pixel=pixel, nyquist=finest)
        terms = {} if pupil.aberrations is None else pupil.aberrations.amplitudes()
        if recording.along != "none" and not any(n % 2 == 0 and (n, m) != (2, 0) for n, m in terms):
            text = (
                "the wavefront has no even term besides defocus, such as astigmatism: images above and below focus "
                "are nearly alike, and z may have the wrong sign; `flat` gives x and y alone"
            )
            self._add_once("sign_open", "doubt", text)

    def _add_once(self, code: str, severity: Severity, text: str, **numbers: Any) -> None:
        self._once.setdefault(code, Finding(code, severity, text, numbers))

    def first(self, counts: Counts) -> None:
        """Look at the counts of the first block."""
        dark = float(np.mean(counts.values < self._noise.offset))
        if dark > _DARK:
            text = f"{100 * dark:.0f} % of the counts of the first frames are below the offset: check `offset`"
            self._add_once("below_offset", "doubt", text, share=dark)
        if words := flat_tops([counts], self._noise, "movie"):
            self._add_once("flat_top", "note", words)
        if counts.assumed:
            self._add_once("saturation_assumed", "note", counts.assumed)

    def tilt(self, spots: Spots, found: Molecules) -> float:
        """Test whether the background of flat fits is tilted, and their noise; return the standard deviations."""
        score = scored(spots, found, self._table, self._noise)
        if score is None:
            return 0.0
        if sum(len(one) for one, _, _ in self._residuals) < _MOLECULES:
            self._residuals.append((score.residual, score.mean, score.read))
            residual, mean, read = (np.concatenate(each) for each in zip(*self._residuals, strict=True))
            self._excess = excess_test(residual, mean, read).findings(self._noise.excess)
        sigmas, slope, error = score.tilt((self._recording.rows, self._recording.columns))
        if sigmas > TILTED:
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

    def compare(self, spots: Spots, background: str) -> None:
        """Compare the fits of the first molecules, on a flat or tilted background, with those of other tables."""
        kept = slice(_MOLECULES - self._tried)
        if not self._rivals or self._tried >= _MOLECULES or not len(spots):
            return
        self._tried += len(spots)
        again = partial(self._again, images=spots.images[kept], corners=spots.corners[kept], background=background)
        one = again(self._table)
        for name, table in self._rivals.items():
            other = again(table)
            # Crowded molecules tell nothing of the PSF.
            both = one.converged & other.converged & (np.minimum(one.discrepancy, other.discrepancy) < DOUBTFUL)
            self._gains[name] += (other.log_likelihood - one.log_likelihood)[both].tolist()

    def count(self, part: Localizations) -> None:
        """Add the localisations of a block."""
        at = (np.floor(part.table[name] / self._recording.pixel).astype(np.int64) for name in "yx")
        places = (np.clip(one, 0, side - 1) for one, side in zip(at, self._counts.shape, strict=True))
        np.add.at(self._counts, tuple(places), 1)
        kept = part.table["discrepancy"][part.kept]
        for name in self._sums:
            self._sums[name] += int((kept >= DOUBTFUL).sum()) if name == "doubtful" else getattr(part, name)
        at = np.round(np.clip(kept, -_WIDEST, _WIDEST) * _PER_UNIT).astype(np.int64) + _WIDEST * _PER_UNIT
        self._discrepancies += np.bincount(at, minlength=self._discrepancies.size)

    @property
    def molecules(self) -> int:
        """Number of those that converged."""
        return int(self._discrepancies.sum())

    @property
    def median(self) -> float:
        """Median of the discrepancies, but for those that are far above it, as of molecules beside others."""
        sums = np.cumsum(self._discrepancies)
        middle = int(np.searchsorted(sums, 0.5 * self.molecules)) + int(DOUBTFUL * _PER_UNIT)
        middle = int(np.searchsorted(sums, 0.5 * sums[min(middle, sums.size - 1)]))
        return middle / _PER_UNIT - _WIDEST if self.molecules else 0.0

    @property
    def summary(self) -> str:
        """Number of molecules and median discrepancy."""
        n, frames = self.molecules, self._recording.frames
        median = f", median discrepancy {self.median:.2g}" if n else ""
        return f"{n} molecule{'s' * (n != 1)} in {frames} frame{'s' * (frames != 1)}{median}"

    @property
    def findings(self) -> Findings:
        """What was found so far."""
        each = self._excess, self._of_rivals(), self._of_fits(), self._once.values(), self._of_spots()
        return Findings(chain(*each))

    def _of_rivals(self) -> Iterator[Finding]:
        """Yield the table with which molecules are far likelier.

        A thousand tell the sign of an astigmatism on the cover glass with 500 photons each: there one molecule alone
        is likelier with the right sign by 0.1.
        """
        likelier: dict[str, tuple[float, int, float]] = {}
        for name, each in self._gains.items():
            gain, error = math.fsum(each), float(np.std(each or 0.0)) * math.sqrt(len(each))
            if len(each) >= _LEAST_TRIED and gain > max(_LIKELIER, 4.0 * error):
                likelier[name] = gain, len(each), error
        if not likelier:
            return
        name, (gain, count, error) = max(likelier.items(), key=lambda one: one[1])
        numbers: Json = {"molecules": count, "log_likelihood": gain, "error": error}
        subject = f"{count} molecules of the first frames are likelier"
        text = f"(log-likelihood {gain:.3g} +- {error:.2g} larger)"
        if name == "sign":
            text = (
                f"{subject} with astigmatism of the opposite sign {text}, and z is then reversed: check the sign of "
                "the astigmatism and the direction of the movie's rows"
            )
            yield Finding("opposite_astigmatism", "error", text, numbers)
        else:
            shift = float(name)
            way = "deeper" if shift > 0.0 else "nearer to the cover glass"
            text = (
                f"{subject} {format_length(abs(shift))} {way} {text}: check the depth, the indices and the spherical "
                "aberration"
            )
            yield Finding("other_explanation", "doubt", text, numbers | {"parameter": "depth", "shift": shift})

    def _of_fits(self) -> Iterator[Finding]:
        sums, n = self._sums, self.molecules
        if not sums["spots"]:
            text = "no spot is above `threshold`: check `offset`, `white` and `read`, or lower it"
            yield Finding("no_light", "error", text)
        elif not n:
            yield Finding("not_settled", "error", f"none of {sums['spots']} fits converged within the table")
        if not n:
            return
        median, error = self.median, math.sqrt(0.5 * math.pi / n)
        numbers = {"median": median, "error": error}
        text = f"the median discrepancy, {median:.2g}, is not 0 within its error, {error:.1g}: the "
        if median > max(_DISCREPANT, 4.0 * error):
            text += "PSF (sign of the astigmatism, depth, indices, wavelength), the gain or the offset may be wrong"
            yield Finding("misfit", "error" if median > _MISFIT else "doubt", text, numbers)
        elif median < -max(_DISCREPANT, 4.0 * error):
            text += "gain or the offset may be wrong: check `white` and `offset`"
            yield Finding("too_quiet", "doubt", text, numbers)
        if median < _MISFIT and sums["doubtful"] > 1.0 + _BY_CHANCE * n + 4.0 * math.sqrt(_BY_CHANCE * n):
            share = sums["doubtful"] / n
            text = (
                f"{sums['doubtful']} of {n} molecules have images that noise does not explain, as with another "
                f"molecule within their box: leave out those of a discrepancy of {DOUBTFUL:g} or more"
            )
            numbers = {"doubtful": sums["doubtful"], "molecules": n}
            yield Finding("crowded", "doubt" if share > _CROWDED else "note", text, numbers)
        if self._recording.along != "none":
            text = (
                "not tested: light that is uneven across the pupil, or clipped on one side of it, which moves "
                "molecules sideways in proportion to z: beads at several foci show it"
            )
            yield Finding("untested", "note", text)

    def _of_spots(self) -> Iterator[Finding]:
        sums = self._sums
        words = {"saturated": "saturated", "left_out": "NaN, infinite or masked"}
        if counts := [f"{sums[name]} {word}" for name, word in words.items() if sums[name]]:
            text = f"pixels of boxes that do not count: {', '.join(counts)}"
            yield Finding("left_out", "note", text, {name: sums[name] for name in words})
        if places := self._recurring():
            row, column, count = places[0]
            many = "a spot is" if len(places) == 1 else f"{len(places)} spots are"
            text = (
                f"{many} in the same place in many frames, the first in {count} of {self._recording.frames} at row "
                f"{row}, column {column}: a bead, or a hot pixel, which `mask`, or a map by `read` with {DEFECT:g} "
                "electrons there, leaves out"
            )
            yield Finding("recurring", "note", text, {"places": places})
        if self._recording.along != "none" and sums["ends"] > _MANY * sums["spots"]:
            ends, spots = sums["ends"], sums["spots"]
            text = f"{ends} of {spots} spots are at an end of the range of z: a wider one may hold them"
            yield Finding("z_range", "note", text, {"ends": ends, "spots": spots})

    def _recurring(self) -> list[tuple[int, int, int]]:
        """Return row, column and number of spots within a pixel where they are in many frames, most first."""
        counts, often = self._counts, _OFTEN * self._recording.frames
        if self._recording.frames < _LEAST_FRAMES or counts.sum() < often:
            return []
        near = ndimage.convolve(counts, np.ones((3, 3), np.int64), mode="constant")
        row, column = np.nonzero((near >= often) & (counts == ndimage.maximum_filter(counts, 5)) & (counts > 0))
        order = np.argsort(-near[row, column], kind="stable")
        return [(int(row[k]), int(column[k]), int(near[row[k], column[k]])) for k in order]


class Score(NamedTuple):
    """Slopes and information of two ramps beside all unknowns, residuals, and where molecules are."""

    slope: Array
    information: Array
    row: Array
    column: Array
    residual: Array
    mean: Array
    read: Array

    def tilt(self, shape: tuple[int, int]) -> tuple[float, float, float]:
        """Return how far slopes that flat fits leave out are beyond 0, and the largest and its standard error.

        All molecules together, and each of 4 x 4 parts of the frame; that which is less by chance.
        """
        place = np.clip((4 * self.row / shape[0]).astype(int), 0, 3) * 4
        place += np.clip((4 * self.column / shape[1]).astype(int), 0, 3)
        tests = []
        for parts in (np.zeros_like(place), place):
            chosen = (parts == np.unique(parts)[:, None]).astype(float)
            slopes, information = chosen @ self.slope, np.tensordot(chosen, self.information, 1)
            sizes = np.linalg.solve(information, slopes[..., None])[..., 0]
            errors = np.sqrt(np.diagonal(np.linalg.inv(information), axis1=1, axis2=2))
            most = np.unravel_index(np.abs(sizes / errors).argmax(), sizes.shape)
            chance = float(special.gammaincc(len(chosen), 0.5 * (slopes * sizes).sum()))
            tests.append((chance, abs(float(sizes[most])), float(errors[most])))
        chance, size, error = min(tests)
        return float(-special.ndtri(max(0.5 * chance, 1e-300))), size, error


def scored(spots: Spots, found: Molecules, table: Table, camera: Noise) -> Score | None:
    """Return score tests of slopes of the background in the boxes of flat fits, all unknowns being eliminated."""
    height, width = table.shape
    at = np.column_stack([found.row, found.column]) - spots.corners
    middle = np.array([height // 2, width // 2])
    good = found.converged & (np.abs(at - middle) < table.reach).all(axis=1)
    if not good.any():
        return None
    # Neighbours look like slopes.
    kept = np.flatnonzero(good & (found.discrepancy < np.median(found.discrepancy[good]) + DOUBTFUL))[:_MOLECULES]
    light, read = in_electrons(spots.images[kept], camera, spots.corners[kept].astype(float))
    values, slopes = table(at[kept, 0], at[kept, 1], found.z[kept], derivatives=True)
    photons, level = (each[kept, None, None] / camera.excess for each in (found.photons, found.background))
    ramps = np.mgrid[:height, :width] - 0.5 * np.array([height - 1, width - 1])[:, None, None]
    z = "depth" if "depth" in slopes else "z"
    own = [slopes["row"], slopes["column"], slopes[z] * 1e-6, values, np.ones_like(values)]
    columns = np.stack([*own, *(np.broadcast_to(one, values.shape) for one in ramps)], axis=1, dtype=float)
    columns[:, :3] *= photons[:, None]
    mean = np.maximum(photons * values + level, 0.01)
    weight = np.where(np.isfinite(light), 1.0 / (mean + read), 0.0)
    score = np.einsum("nkyx,nyx->nk", columns, np.nan_to_num(light - mean) * weight)
    information = np.einsum("nkyx,nlyx->nkl", columns * weight[:, None], columns)
    taken = np.linalg.solve(information[:, :5, :5], information[:, :5, 5:])
    left = information[:, 5:, 5:] - information[:, 5:, :5] @ taken
    slope = score[:, 5:] - np.einsum("nki,nk->ni", taken, score[:, :5])
    # Fits make residuals smaller; those of images that noise does not explain tell nothing of noise.
    pixels = np.isfinite(light).sum(axis=(1, 2))
    residual = (light - mean) * np.sqrt(pixels / np.maximum(pixels - 5, 1))[:, None, None]
    return Score(slope, left, found.row[kept], found.column[kept], residual, mean, np.broadcast_to(read, mean.shape))


def rivals(table: Table, threads: int | None = None) -> dict[str, Table]:
    """Return tables that a wrong statement would hide, kept with the table: by what is other in them."""
    kept: dict[str, Table] = vars(table).setdefault("_rivals", {})
    if not kept:
        made: dict[str, Any] = {name: getattr(table, name) for name in ("along", "reach", "tol")}
        for name, pupil, shift in _others(table.pupil, table):
            low, high = (max(0.0, end + shift) if shift else end for end in table.z)
            kept[name] = Table(pupil, table.shape, table.pixel, z=(low, high), threads=threads, **made)
    return kept


def _others(pupil: ObjectivePupil, table: Table) -> Iterator[tuple[str, ObjectivePupil, float]]:
    """Yield pupils with the opposite astigmatism and other depths in focus, and by how much the range of z moves."""
    wave = pupil.aberrations
    if wave is not None and any(abs(m) == 2 for _, m in wave.amplitudes()):
        edge = {(n, m): -one if abs(m) == 2 else one for (n, m), one in zip(wave.terms, wave.edge.T, strict=True)}
        yield "sign", replace(pupil, aberrations=Wavefront.from_edge(edge, wave.error)), 0.0
    moving = table.along == "depth"
    depth = sum(table.z) / 2.0 if moving else float(pupil.depth)
    for way in (-1.0, 1.0):
        shift = max(way * _DEEPER, -depth)
        if abs(shift) >= 0.5 * _DEEPER:
            focus = pupil.focus + brightest(pupil.layers, depth + shift).brightest
            focus = focus - brightest(pupil.layers, depth).brightest
            deeper = replace(pupil, focus=focus, depth=pupil.depth + (0.0 if moving else shift))
            yield f"{shift:+.1e}", deeper, shift if moving else 0.0


TILTED = 5.0
"""Standard deviations, from which on backgrounds are tilted."""
_MOLECULES = 1000  # that are looked at for noise, sign and background
_LEAST_FRAMES, _OFTEN = 20, 0.3  # of a movie, and the share of its frames in which a molecule is not again and again
_WIDEST, _PER_UNIT = 50, 100  # of the histogram of discrepancies
_FINE = 0.1  # of Nyquist's pixel
_DARK = 0.75  # of the counts: half are below where there is no light
_DISCREPANT, _MISFIT = 0.3, 1.0  # smaller ones are of imperfections that every PSF has
_BY_CHANCE, _CROWDED = 0.01, 0.05  # shares of molecules
_MANY = 0.1  # of the spots
_LEAST_TRIED = 10  # molecules, of which the spread is known
_DEEPER = 0.4e-6  # by which depths in focus are moved
_LIKELIER = 10.0  # log-likelihood, by which one of two wavefronts must be the likelier to be spoken of


_HEIGHTS, _TURNS = 65, 100


def localize_movie(
    movie: Movie | str | PathLike[str] | ArrayLike,
    table: Table,
    *,
    noise: Noise | None = None,
    threshold: float = 6.0,
    width: float | None = None,
    saturation: float | None = None,
    starts: int = 4,
    flat: bool = False,
    background: str = "auto",
    mask: ArrayLike | None = None,
    block: int | None = None,
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Localizations:
    """Find the molecules of a movie and estimate where they are.

    By :func:`lommel.localize.find` and :func:`lommel.localize.fit`, frames in blocks. Drift of the sample is not
    corrected, and molecules that shine in several frames are a row in each.

    Parameters
    ----------
    movie : Movie, path or array_like of shape (frames, rows, columns)
        Frames as the camera recorded them, in the unit of `noise`.
    table : Table
        Images of a molecule, with the pixels of the camera; its shape is that of the boxes.
    noise : Noise, optional
        Gain, offset and read noise of the camera, each a number or a map of the frame; by default frames are in
        electrons without read noise.
    threshold : float, default 6.0
        Least height of a spot in standard deviations of the background noise, at least 3.
    width : float, optional
        Standard deviation in pixels by which frames are smoothed to find spots; by default the median over z of that
        of the images in the table.
    saturation : float, optional
        As of :func:`lommel.localize.find`; pixels that are full do not count in fits.
    starts : int, default 4
        Number of starts of a fit where the first estimate is in doubt.
    flat : bool, default False
        For images that do not tell z, as without astigmatism: x and y alone are estimated for. A fit that ends at an
        end of the range of z has converged, and z is NaN.
    background : {"auto", "flat", "tilted"}, default "auto"
        Background of each box, as of :func:`lommel.localize.fit`. By default it is tilted from the block of frames on
        in which the slopes that flat ones leave, of up to a thousand molecules of a block, all together or in parts
        of the frame, are beyond five standard deviations.
    mask : array_like of bool, shape (rows, columns), optional
        True where a pixel is left out, as where the camera is hot.
    block : int, optional
        Frames in memory at once; by default as many as have four million pixels.
    threads : int, optional
        Maximum number of threads; by default the number of processors.
    progress : callable, optional
        Called with the number of frames done and their total after each block.

    Returns
    -------
    Localizations

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, or frames are smaller than the boxes; MovieError if a file is no movie.
    OSError
        If a file cannot be read.

    Examples
    --------
    >>> camera = lm.Noise(white=0.46, read=1.6, offset=100)  # doctest: +SKIP
    >>> found = localize_movie("movie.tif", table, noise=camera)  # doctest: +SKIP
    >>> found.save("molecules.csv")  # doctest: +SKIP
    """
    blocks = localize_blocks(
        movie, table, noise=noise, threshold=threshold, width=width, saturation=saturation, starts=starts, flat=flat,
        background=background, mask=mask, block=block, threads=threads, progress=progress,
    )  # fmt: skip
    return joined(list(blocks))


def localize_blocks(
    movie: Movie | str | PathLike[str] | ArrayLike,
    table: Table,
    *,
    noise: Noise | None = None,
    threshold: float = 6.0,
    width: float | None = None,
    saturation: float | None = None,
    starts: int = 4,
    flat: bool = False,
    background: str = "auto",
    mask: ArrayLike | None = None,
    block: int | None = None,
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Iterator[Localizations]:
    """Yield the localisations of a movie block by block, for movies whose molecules are more than memory holds.

    Parameters
    ----------
    movie, table, noise, threshold, width, saturation, starts, flat, background, mask, block, threads, progress
        As of :func:`lommel.localize.localize_movie`.

    Yields
    ------
    Localizations
        Of each block of frames, at least one, also without molecules; :func:`lommel.localize.writer` writes them.

    Raises
    ------
    TypeError, ValueError, OSError
        As of :func:`lommel.localize.localize_movie`.
    """
    validation.instance("table", table, Table)
    validation.function("progress", progress, required=False)
    validation.optional("noise", noise, Noise)
    camera = noise or Noise(read=0.0)
    kind = validation.choice("background", background, ("auto", *BACKGROUNDS))
    widths = gaussian_widths(table)
    if width is None:
        width = float(np.clip(np.median(np.sqrt(widths[1] * widths[2])), 0.5, min(table.shape) / 4.0))
    search = partial(find, box=table.shape, noise=camera, threshold=threshold, width=width, threads=threads)
    with _opened(movie, block) as (shape, blocks, name):
        pixel = table.pixel / table.pupil.magnification
        along = "none" if validation.truth("flat", flat) else table.along
        recording = Recording(*shape, pixel, table.shape, along, name)
        again = partial(fit, noise=camera, saturation=math.inf, starts=starts, threads=threads)
        checks, done = Checks(recording, table, again, kind), 0
        for frames in blocks:
            counts = frame_counts(frames, table.shape, saturation=saturation, mask=mask)
            if not done:
                checks.first(counts)
            if counts.assumed:
                saturation = counts.saturation  # of the frames that follow, too
            spots = search(counts, first=done)
            values = counts.marked()
            begun = "flat" if kind == "auto" else kind
            found = _recentred(values, spots, done, table, partial(again, table, background=begun))
            if begun == "flat" and checks.tilt(spots, found) > TILTED and kind == "auto":
                kind = "tilted"
                found = _recentred(values, spots, done, table, partial(again, table, background=kind))
            checks.compare(spots, "tilted" if kind == "tilted" else "flat")
            part = _localizations(spots, found, recording, widths, table)
            checks.count(part)
            yield replace(part, findings=checks.findings, summary=checks.summary)
            done += len(frames)
            if progress is not None:
                progress(done, shape[0])


_ROUNDS = 3  # of boxes moved


def _recentred(frames: Values, spots: Spots, first: int, table: Table, again: Callable[..., Molecules]) -> Molecules:
    """Return fits of boxes in frames; of molecules off the middle, as with coma, of boxes around their estimates."""

    def boxes(of: NDArray[np.int64], at: NDArray[np.int64]) -> Values:
        return np.asarray(frames[of[:, None, None], *box_pixels(at, table.shape)])

    which, corners = spots.frame - first, spots.corners
    found = again(boxes(which, corners), corners=corners)
    most, middle = np.array(frames.shape[1:]) - table.shape, np.array(table.shape) // 2
    moved = np.arange(len(which))
    for _ in range(_ROUNDS):
        places = np.round(np.stack([found.row[moved], found.column[moved]], axis=1)).astype(np.int64) - middle
        places = np.clip(places, 0, most)
        other_place = (places != corners[moved]).any(axis=1)
        moved, places = moved[other_place], places[other_place]
        if not moved.size:
            break
        other = again(boxes(which[moved], places), corners=places)
        better = other.converged | ~found.converged[moved]
        moved, places = moved[better], places[better]
        found, corners[moved] = found.replaced(moved, other[better]), places
    return found


@contextmanager
def _opened(
    movie: Movie | str | PathLike[str] | ArrayLike, block: int | None
) -> Iterator[tuple[tuple[int, int, int], Iterator[Values], str]]:
    """Yield the shape of a movie, its blocks, and its name."""
    if isinstance(movie, str | PathLike):
        with open_movie(movie) as opened:
            yield opened.shape, opened.blocks(block), opened.path.name
    elif isinstance(movie, Movie):
        yield movie.shape, movie.blocks(block), Path(movie.path).name
    else:
        values, hidden = validation.parted("movie", movie)
        frames = values if hidden is None else np.ma.masked_array(values, mask=hidden)
        if frames.ndim != 3 or not frames.size:
            raise ValueError(f"movie must have the shape (frames, rows, columns), got {frames.shape}")
        count, rows, across = frames.shape
        each = max(1, BLOCK // (rows * across)) if block is None else block
        validation.integer("block", each, least=1, most=validation.MAX_VALUES)
        yield (count, rows, across), (frames[k : k + each] for k in range(0, count, each)), ""


def _localizations(
    spots: Spots, found: Molecules, recording: Recording, widths: tuple[Array, Array, Array], table: Table
) -> Localizations:
    rows, pixel = np.zeros(len(spots), columns()), recording.pixel
    rows["frame"], rows["score"] = spots.frame, spots.score
    for name in ("discrepancy", "log_likelihood", "state"):
        rows[name] = getattr(found, name)
    sides = {"row": "y", "column": "x"}
    for name in (each.name for each in fields(MoleculeErrors)):
        to, scale, shift = (sides[name], pixel, 0.5) if name in sides else (name, 1.0, 0.0)
        rows[to] = (getattr(found, name) + shift) * scale
        rows[f"{to}_error"] = getattr(found.errors, name) * scale
    heights, along_y, along_x = widths
    rows["sigma_y"], rows["sigma_x"] = (pixel * np.interp(found.z, heights, one) for one in (along_y, along_x))
    if recording.along == "none":
        rows["state"][(found.state == STATES.index("border")) & np.isin(found.z, table.z)] = 0
        rows["z"] = rows["z_error"] = np.nan
    ends = int(np.isin(rows["z"][rows["state"] == STATES.index("border")], table.z).sum())
    left = spots.borders, spots.overlapping, spots.saturated, spots.left_out, ends
    return Localizations(rows, recording, len(spots), *left)


def gaussian_widths(table: Table) -> tuple[Array, Array, Array]:
    """Return heights z, and deviations along rows and columns of Gaussians fitted to the images there, pixels.

    Adaptive moments (G. M. Bernstein, M. Jarvis, doi:10.1086/338085): weighed by the Gaussian itself, the second
    moments of a Gaussian are half its own.
    """
    heights = np.linspace(*table.z, _HEIGHTS)
    row, column = (side // 2 for side in table.shape)
    images = np.asarray(table(row, column, heights), np.float64)
    sides = np.arange(table.shape[0]) - row, np.arange(table.shape[1]) - column
    variances = np.full((2, _HEIGHTS), 2.0)
    for _ in range(_TURNS):
        tall, wide = (np.exp(-0.5 * at**2 / one[:, None]) for at, one in zip(sides, variances, strict=True))
        pairs = (tall, wide), (tall * sides[0] ** 2, wide), (tall, wide * sides[1] ** 2)
        sums, *moments = (np.einsum("zyx,zy,zx->z", images, *pair) for pair in pairs)
        variances = np.clip(2.0 * np.stack(moments) / sums, 0.1, max(table.shape) ** 2)
    return heights, *np.sqrt(variances)
