"""Images of stars, pinholes or corners over a field, as functions of wavefront, position, flux and blur."""

from __future__ import annotations

import math
from collections.abc import Sequence
from copy import copy
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, NamedTuple, TypeAlias, cast

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.blur.blurs import Blur
from lommel.blur.mixtures import Shape
from lommel.core.engine import star_likelihood
from lommel.estimation.sampled_pupil import SMALL, SampledPupil, UnevenLight, changes_of
from lommel.estimation.star_images import StarImages, Unknowns, centroids, loosest_tolerance, slants, star_counts
from lommel.estimation.star_readout import ROOM, StarReadout
from lommel.estimation.target_readout import Target, TargetReadout, start_of_crossing
from lommel.fit.scoring import RowModel, Scores, covariance, flux_background, reduced_chi2
from lommel.methods.derivative_names import SHIFTS, Name, Term
from lommel.methods.question import output_type
from lommel.methods.question import prepare as prepare_question
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import Plan

_BLOCK_VALUES = 3e7  # number of values of samples and their derivatives that are computed together
_SHARP = 0.02  # squared width of blur, pixels^2, below which a step may set it to 0
_BRIGHT = 50.0  # chi2 of bright pixels is computed if their number minus twice that of parameters is at least this
_OWN = 4  # number of parameters of each image (row, column, flux, background) before the angles
_MAX_ANGLE_STEP = 0.05  # largest step of an angle, radians


Readout: TypeAlias = StarReadout | TargetReadout


class Quality(NamedTuple):
    """Chi2 per degree of freedom of r stars, shape (r,), and its standard deviation for a correct model."""

    chi2: Array
    spread: Array


class FieldStars:
    """Images of n stars in e exposures, electrons (n, e, height, width), and their likelihood.

    Parameters of a star are the k coefficients of its wavefront (radians rms), the b squared widths of the blur of
    each exposure (pixels^2), and the `own` parameters of each image: two tilts (row and column), flux, background,
    and for corners two angles; with `sloped`, also two slopes of the background. In arrays named `own`, their values
    have the shape (r, own, e) for r stars. `blur` is a shape of unknown widths, or known blurs.
    """

    def __init__(
        self,
        electrons: Array,
        variance: Array,
        valid: NDArray[np.bool_],
        pupil: Pupil,
        defocus: Array,
        unknowns: Unknowns,
        pixel: float,
        plan: Plan,
        *,
        blur: Shape | tuple[Blur, ...],
        target: Target | None = None,
    ) -> None:
        self.count, self.exposures, *shape = electrons.shape
        self.shape = (shape[0], shape[1])
        self.pixels = shape[0] * shape[1]
        self.known = defocus
        self.threads, self.tol = plan.threads, plan.tol
        self.target = target
        self.angles = 0 if target is None else target.angles
        self.own = _OWN + self.angles
        self.cornered = self.angles > 0
        self.sloped = False
        #: Terms and constants that are not estimated, but for which `images` may return derivatives.
        self.further: tuple[Name, ...] = ()
        first = pupil if pupil.shape == () else pupil[0]
        self.integrate = bool(plan.grid(first).integrate)
        self.lens, self.pixel = first, pixel / float(first.scale)  # in lambda*N
        self.blur = blur if isinstance(blur, Shape) else Shape.known(blur, pixel, first.wavelength)
        self.widths = self.blur.unknown
        #: The images of the first star; its terms and directions apply to all stars.
        self.one = StarImages(electrons[0], variance[0], valid[0], first, defocus, unknowns, plan, pixel)
        self.size = len(unknowns.terms) + (self.widths + self.own) * self.exposures
        self.star = star_counts(electrons, variance, valid)
        self.loosest = loosest_tolerance(self.star, plan.tol)
        #: Coefficients of the initial wavefront; the remainder, outside the estimated terms, is fixed.
        self.start, fixed = self.one.split(pupil.wavefront.edge_terms(), (self.count,))
        self.base: Array = np.repeat(fixed[:, None], self.exposures, axis=1)
        self.base[:, :, 0] += defocus[None]
        self.defocused = bool(defocus.any())
        self._slopes: tuple[Term, ...] = (*unknowns.edge, *(SHIFTS[place] for place in ("row", "column")))
        self._reader: Readout | None = None
        self._sampled_pupils: dict[tuple[object, ...], SampledPupil] = {}
        self.tested = int((self.star[3].sum(axis=(1, 2)) - self.size).mean())

    def shaped(self, shape: Shape) -> FieldStars:
        """Return a model of the same stars with another shape of the blur, of unknown widths."""
        more = (shape.unknown - self.widths) * self.exposures
        size = {"widths": shape.unknown, "size": self.size + more, "tested": self.tested - more}
        return self.having(blur=shape, _reader=None, **size)

    def on_slopes(self) -> FieldStars:
        """Return a model with two more parameters per image: slopes of the background, electrons per pixel."""
        more = 2 * self.exposures
        return self.having(sloped=True, own=self.own + 2, size=self.size + more, tested=self.tested - more)

    def having(self, **changes: Any) -> FieldStars:
        """Return a copy in which the attributes in `changes`, such as `further` or `lens`, are replaced."""
        found = copy(self)
        vars(found).update(changes)
        return found

    def images(
        self, stars: NDArray[np.intp], waves: Array, squares: Array, own: Array, *, fast: bool, slopes: str = "all"
    ) -> list[Array]:
        """Return the PSFs of r stars at their positions, and derivatives of the PSFs.

        `waves` is (r, k), `squares` (r, e, b), `own` (r, own, e); each array in the list is (r * e, height, width).
        `slopes` selects the derivatives. "all": by Zernike terms (amplitude at the pupil edge), tilts, squared
        widths, and angles. "own": as "all", but 0 unless by tilts or angles. "none": no derivatives. "others": by the
        `further` terms, by `changes_of` a circular pupil, and, for stars, by `OTHER_BLURS`; `squares` must then be
        the same for all stars.
        """
        reader = self._readout(squares, always=slopes == "others")
        each = self.exposures * math.prod(reader.shape if reader else self.shape) * (len(self._slopes) + 2)
        block = max(1, int(_BLOCK_VALUES / each))
        edge = self.base[stars] + (waves @ self.one.directions)[:, None]
        for j, column in enumerate(self.one.tilts):
            edge[:, :, column] += own[:, j]
        parts = [
            self._block(reader, edge[s].reshape(-1, edge.shape[-1]), squares[s], own[s], fast=fast, slopes=slopes)
            for s in (slice(first, first + block) for first in range(0, len(stars), block))
        ]
        return [np.concatenate(several) for several in zip(*parts, strict=True)] if len(parts) > 1 else parts[0]

    def _readout(self, squares: Array, *, always: bool) -> Readout | None:
        """Return the readout, which computes pixels from samples for blur of widths `squares`; None if not needed."""
        reader, shape = self._reader, self.blur
        if self.target is not None:
            if reader is None:
                self._reader = TargetReadout(self.shape, self.pixel, self.target, shape, integrate=self.integrate)
            return self._reader
        if not (always or self.widths or self.integrate or shape.fixed.any()):
            return None
        # With the support for the typical width, the widest Gaussians of seeing lose only light far from the window.
        known = float(np.exp(shape.weights @ np.log(shape.fixed + 1e-12)))
        width = math.sqrt(float(squares.sum(axis=-1).max(initial=0.0)) + known)
        variances = shape.variances(squares).reshape(-1, len(shape.weights)).min(axis=0)
        if isinstance(reader, StarReadout) and reader.serves(width, variances):
            return reader
        least, widest = variances, width
        if self.widths:
            # Round the width up to a multiple of ROOM, so that lattices of sampled pupils can be reused.
            widest = ROOM * (math.ceil(width / ROOM) + 1)
            least = variances * max(1.0 - ROOM / max(width, ROOM), 0.0) ** 2
        self._reader = StarReadout(self.shape, self.pixel, widest, shape, integrate=self.integrate, narrowest=least)
        return self._reader

    def _block(
        self, reader: Readout | None, edge: Array, squares: Array, own: Array, *, fast: bool, slopes: str
    ) -> list[Array]:
        """Return the result of `images` for a block of stars, from Zernike terms `edge` (r * e, terms)."""
        pupil = self.lens.carrying(Wavefront.trusted(self.one.terms, edge), None)
        tol = self.loosest if fast else self.tol
        shape, pitch = (self.shape, self.pixel) if reader is None else (reader.shape, reader.step)
        pixel = pitch * float(self.lens.scale)
        plan = Plan(shape, pixel, tol=tol, integrate=False, threads=self.threads or None)
        facts = pupil.aperture, pupil.radial, pupil.shape, pupil.wavelength, pupil.f_number
        dtype = output_type(None, tol)
        prepared = prepare_question(pupil, facts, plan.grid(pupil), None, tol, "energy", dtype, self.threads)
        by = {"all": self._slopes, "own": self._slopes[-2:], "none": (), "others": self.further}[slopes]
        # Sampled pupils do not support masks, and have derivatives by phases only.
        proven = pupil.mask is not None or (pupil.circular and (slopes == "others" or max(shape) <= SMALL))
        if proven:
            _, pixels, rates = prepared.images(pupil, by)
            samples = [pixels.values, *(slope.values for slope in rates)]
            if slopes == "others" and changes_of(self.lens):
                samples += UnevenLight(self.lens, plan.grid(self.lens), self.one.terms, edge).images()
        else:
            columns = [(*self.one.terms, *self.further).index(name) for name in by]
            samples = list(self._sampled(plan.grid(self.lens)).images(edge, columns, values=fast))
            if not fast:  # only the PSFs must be accurate: errors of derivatives hardly affect steps and results
                samples.insert(0, prepared.images(pupil)[1].values)
        if reader is None:
            found = [np.asarray(image).reshape(-1, *self.shape) for image in samples]
        else:
            flat = [np.asarray(sample, np.float32).reshape(-1, *reader.shape) for sample in samples]
            if isinstance(reader, TargetReadout):
                turned = own[:, _OWN : _OWN + self.angles].swapaxes(1, 2).reshape(len(flat[0]), -1)
                widths = squares.reshape(len(flat[0]), -1)
                found = reader.read(flat, widths, turned, slopes=slopes == "all", threads=self.threads)
                found = found[: len(flat)] if slopes == "others" else found
            else:
                found = reader.read(flat, squares, slopes=slopes == "all")
                if slopes == "others":
                    found += reader.other_blurs(flat[0], squares[0]).values()
        if slopes == "own":
            nothing = np.zeros_like(found[0])
            held = [nothing] * (len(self._slopes) - 2)
            found = [found[0], *held, *found[1:3], *[nothing] * self.widths, *found[3:]]
        return found

    def _sampled(self, grid: Grid) -> SampledPupil:
        """Return the sampled pupil that computes images on the grid; reuse it in later calls."""
        key = self.lens, grid.shape, grid.pixel, self.further
        if key not in self._sampled_pupils:
            self._sampled_pupils[key] = SampledPupil(
                self.lens, grid, cast("list[Term]", [*self.one.terms, *self.further])
            )
        return self._sampled_pupils[key]

    def likelihood(
        self, stars: NDArray[np.intp], images: Sequence[Array], own: Array, others: Sequence[Array] = ()
    ) -> tuple[Array, Array, Array]:
        """Return three arrays for r stars of p parameters, from PSFs and their derivatives `images`.

        (3, r): deviance, expectation and variance of Pearson's sum. (r, p, p + 1): information matrix, and last
        column: derivatives of the log-likelihood lnL. (r,): Pearson's sum. The p parameters of a star are the
        parameters shared by all stars, q further parameters common to all exposures, and `own`. The q arrays `others`
        (r * e, height, width) are derivatives of electrons by the further parameters.
        """
        r, e, k, b, q = len(stars), self.exposures, len(self.one.directions), self.widths, len(others)
        slopes = slants(r * e, self.shape) if self.sloped else ()
        numbers, products = self._products(stars, [*images, *slopes, *others], own)
        d = products.shape[-1]
        edge = len(self.one.unknowns.edge)
        # Chain rule. Columns: derivatives of PSFs by Zernike terms, tilts, blur and angles; derivatives of electrons
        # by slopes and `others`; then the PSF, 1 (for the background) and the residual.
        chain = np.zeros((r, e, self.size + q + 1, d))
        flux = own[:, 2]
        chain[:, :, :k, :edge] = self.one.unknowns.directions * flux[:, :, None, None]
        chain[:, :, k + e * b + np.arange(q), d - 3 - q + np.arange(q)] = 1.0
        for i in range(e):
            at = k + e * b + q + np.arange(self.own) * e + i
            for j in range(b):
                chain[:, i, k + i * b + j, edge + 2 + j] = flux[:, i]
            chain[:, i, at[0], edge] = chain[:, i, at[1], edge + 1] = flux[:, i]
            chain[:, i, at[2], d - 3] = chain[:, i, at[3], d - 2] = 1.0
            for j in range(_OWN, self.own):
                chain[:, i, at[j], edge + 2 + b + j - _OWN] = flux[:, i] if j < _OWN + self.angles else 1.0
        chain[:, :, -1, -1] = 1.0
        found = (chain @ products @ chain.swapaxes(-1, -2)).sum(axis=1)
        return numbers, found[:, :-1], found[:, -1, -1]

    def _products(self, stars: NDArray[np.intp], images: Sequence[Array], own: Array) -> tuple[Array, Array]:
        """Return deviance, expectation and variance of Pearson's sum (3, r), and inner products (r, e, d, d).

        The factors are `images`, the constant 1 and the residual, divided by the standard deviation of each pixel.
        """
        star, light = self.observed(stars, own)
        light = np.ascontiguousarray(np.moveaxis(light, 1, 0).reshape(1, 2, -1))
        numbers, products = star_likelihood(images, light, star.reshape(4, -1, self.pixels), self.threads)
        each = len(stars), self.exposures
        return numbers.reshape(3, *each).sum(axis=-1), products.reshape(*each, *products.shape[-2:])

    def observed(self, stars: NDArray[np.intp], own: Array) -> tuple[Array, Array]:
        """Return counts and variances (4, r, e, pixels) without slopes of the background, and flux and background.

        Counts plus the read variance have a Poisson distribution. A known part of the background may therefore be
        subtracted from the counts and added to the variance.
        """
        star, light = self.star[:, stars], own[:, 2:4].copy()
        if self.sloped:
            lowest = self._lowest(own)
            added = self._slope(own) + lowest[:, :, None]
            star[0] -= added
            star[1:3] += added
            light[:, 1] -= lowest
        return star, light

    def _lowest(self, own: Array) -> Array:
        """Return the largest decrease of sloping backgrounds from the middle to a corner of the window (r, e)."""
        return np.asarray(np.tensordot(np.abs(own[:, -2:]), [side // 2 for side in self.shape], (1, 0)))

    def _slope(self, own: Array) -> Array:
        """Return the sloping part of backgrounds, (r, e, pixels), from the last two parameters in `own`."""
        y, x = slants(1, self.shape)
        return np.asarray(own[:, -2, :, None] * y.ravel() + own[:, -1, :, None] * x.ravel())

    def expected(self, psf: Array, own: Array) -> Array:
        """Return the electrons of each pixel (r, e, pixels), for PSFs and the parameters `own` (r, own, e)."""
        found = own[:, 2, :, None] * psf.reshape(len(own), self.exposures, -1) + own[:, 3, :, None]
        return found + self._slope(own) if self.sloped else found

    def quality(self, stars: NDArray[np.intp], values: Array, own: Array, unknown: float) -> Quality:
        """Return chi2 of single stars from their PSFs `values`; `unknown` is the number of parameters per star."""
        (_, total, spread), products = self._products(stars, [values], own)
        return self.relative(stars, products[..., -1, -1].sum(axis=-1), total, spread, unknown)

    def relative(
        self, stars: NDArray[np.intp], square: Array, total: Array, spread: Array, unknown: float
    ) -> Quality:
        """Return chi2 of stars from Pearson's sum, its expectation and variance, and the parameters per star."""
        freedom = np.maximum(1.0 - unknown / self.star[3][stars].sum(axis=(1, 2)), 0.1)
        return Quality(*reduced_chi2(square, total, spread, freedom))

    def bright(self, stars: NDArray[np.intp], values: Array, own: Array, unknown: float) -> tuple[float, float]:
        """Return chi2 of the pixels in which stars exceed the noise, and its standard deviation; NaN for few pixels.

        A wrong wavefront increases this chi2 more than the chi2 of whole windows, which are mostly background.
        """
        psf = values.reshape(len(stars), self.exposures, -1)
        (counted, _, read, valid), light = self.observed(stars, own)
        star = light[:, 0, :, None] * psf
        model = star + light[:, 1, :, None]
        variance = np.maximum(np.maximum(model, 0.0) + read, 1e-3)
        bright = (valid > 0.0) & (star * star > variance)
        tested = float(bright.sum()) - unknown
        if self.cornered or tested < unknown + _BRIGHT:
            return math.nan, math.nan
        variance, off = variance[bright], (counted - model)[bright]
        freedom = tested / len(off)
        spread = math.sqrt(float((2.0 + 1.0 / variance).sum()) * freedom) / tested
        return float((off * off / variance).sum()) / tested, spread

    def light(self, stars: NDArray[np.intp], values: Array, before: Array) -> Array:
        """Return flux and background (r, 2, e) of stars by least squares, from their PSFs `values`.

        Slopes of the background, if any, are those of the previous parameters `before`.
        """
        psf = values.reshape(len(stars), self.exposures, -1).astype(np.float64)
        (counted, _, read, valid), _ = self.observed(stars, before)
        flux, level = flux_background(psf, counted, read, valid)
        return np.stack([flux, level + self._lowest(before) if self.sloped else level], axis=1)

    def centroids(self) -> Array:
        """Return tilts (n, 2, e) for the centroid of each star image, or for the crossing point of each corner."""
        if self.cornered:
            return np.asarray(self._crossings[:, :2] * self.one.tilt_of_pixel)
        tilts = centroids(self.star, self.shape) * self.one.tilt_of_pixel
        return tilts.reshape(self.count, self.exposures, 2).swapaxes(1, 2)

    def shifts(self, stars: NDArray[np.intp], values: Array) -> Array:
        """Return shifts (r, 2, e) in whole pixels that maximize the correlation of PSFs with the images of stars."""
        counted, _, _, valid = self.star[:, stars].reshape(4, -1, *self.shape)
        level = np.median(counted, axis=(1, 2), keepdims=True)
        size = (2 * self.shape[0], 2 * self.shape[1])
        ours = np.fft.rfft2(np.where(valid > 0.0, counted - level, 0.0), size)
        matched = np.fft.irfft2(ours * np.conj(np.fft.rfft2(values, size)), size)
        row, column = np.unravel_index(matched.reshape(len(matched), -1).argmax(axis=1), size)
        signed = [(at + n // 2) % n - n // 2 for at, n in zip((row, column), size, strict=True)]
        found = np.stack(signed, axis=1)
        return np.asarray(found.reshape(len(stars), self.exposures, 2).swapaxes(1, 2), np.float64)

    def limited(self, own: Array, before: Array) -> None:
        """Limit tilts to the window, and flux and angles to steps from the values in `before`, in place."""
        for j, largest in enumerate(self.one.largest_tilts):
            np.clip(own[:, j], -largest, largest, out=own[:, j])
        np.maximum(own[:, 2], 0.1 * before[:, 2], out=own[:, 2])
        if self.cornered:
            np.clip(
                own[:, _OWN:],
                before[:, _OWN:] - _MAX_ANGLE_STEP,
                before[:, _OWN:] + _MAX_ANGLE_STEP,
                out=own[:, _OWN:],
            )

    def start_values(self, rows: NDArray[np.intp], tilts: Array) -> Array:
        """Return initial values of the parameters of each image (r, own, e), from tilts (r, 2, e)."""
        rest = np.ones((len(rows), self.own - 2, self.exposures))
        rest[:, 2:] = self._crossings[rows][:, 2:] if self.cornered else 0.0
        return np.concatenate([tilts, rest], axis=1)

    @cached_property
    def _crossings(self) -> Array:
        """Initial row, column and two angles of each crossing (the corner's two lines), (n, 4, e)."""
        images = self.star[0].reshape(-1, *self.shape)
        found = np.array([start_of_crossing(image) for image in images])
        return found.reshape(self.count, self.exposures, -1).swapaxes(1, 2)


def limit_widths(squares: Array, before: Array, widest: float, *, sharp: float) -> None:
    """Limit squared widths (r, e, b) to steps from `before`, in place; a sum over b may become 0 if below `sharp`."""
    total = before.sum(axis=-1, keepdims=True)
    np.clip(squares, 0.0, np.minimum(4.0 * total + 0.1, widest), out=squares)
    least = np.where(total < sharp, 0.0, 0.25 * total)
    now = squares.sum(axis=-1, keepdims=True)
    short = now < least
    grown = np.where(now > 0.0, squares * least / np.maximum(now, 1e-300), before * 0.25)
    np.copyto(squares, grown, where=short)


class _StarModel(RowModel):
    """Images of some stars of a field, as functions of rows of parameters."""

    alternatives = False
    slopes = "all"
    sharp = 0.0  # squared width of blur, pixels^2, below which a step may set it to 0

    def __init__(self, stars: FieldStars, chosen: NDArray[np.intp], shared: int, widest: float) -> None:
        self.of, self.chosen, self.widest = stars, chosen, widest
        #: Number of parameters that do not belong to single images; squared widths of the blur are the last of them.
        self.shared = shared
        self._widths = slice(shared - stars.exposures * stars.widths, shared)

    def parts(self, x: Array) -> tuple[Array, Array, Array]:
        """Return waves (r, k), squares (r, e, b) and a view of the parameters of images (r, own, e) of each star."""
        own, squares = x[:, self.shared :].reshape(-1, self.of.own, self.of.exposures), self.squares(x)
        return self.wavefronts(x), np.broadcast_to(squares, (len(own), *squares.shape[1:])), own

    def wavefronts(self, x: Array) -> Array:
        """Return the coefficients (r, k) of each star."""
        return x[:, : self._widths.start]

    def squares(self, x: Array) -> Array:
        """Return a view of the squared widths of the blur (s, e, b) of each row."""
        return x[:, self._widths].reshape(len(x), self.of.exposures, self.of.widths)

    def images(self, x: Array, *, fast: bool = False) -> tuple[Any, Any]:
        """Return the PSFs of all stars, and their derivatives."""
        found = self.of.images(self.chosen, *self.parts(x), fast=fast, slopes=self.slopes)
        return found[0], found[1:]

    def with_flux_background(self, x: Array, values: Any) -> Array:
        """Return the parameters with flux and background replaced by their least-squares values."""
        found = x.copy()
        own = self.parts(found)[2]
        own[:, 2:4] = self.of.light(self.chosen, values, own)
        return found

    def within(self, x: Array, before: Array) -> Array:
        """Limit parameters in place."""
        limit_widths(self.squares(x), self.squares(before), self.widest, sharp=self.sharp)
        self.of.limited(self.parts(x)[2], self.parts(before)[2])
        return x

    def rms(self, steps: Array) -> Array:
        """Return the rms phase of the step of each star, radians."""
        edge = self.wavefronts(steps) @ self.of.one.directions
        return np.asarray(np.sqrt((edge * edge) @ self.of.one.mean_squares))


class SingleStars(_StarModel):
    """Stars with individual wavefronts: each row of a search contains the parameters of one star."""

    def __init__(self, stars: FieldStars, rows: NDArray[np.intp], widest: float) -> None:
        super().__init__(stars, rows, len(stars.one.directions) + stars.exposures * stars.widths, widest)
        self.size, self.tested = stars.size, stars.tested

    def scores(self, x: Array, *, fast: bool = False, rows: NDArray[np.intp] | None = None) -> Scores:
        """Return the scores of all stars, or of those in `rows`."""
        part = self if rows is None else SingleStars(self.of, self.chosen[rows], self.widest)
        return part.scores_of(x, *part.images(x, fast=fast))

    def scores_of(self, x: Array, values: Any, slopes: Any) -> Scores:
        """Return the scores of all stars, from their PSFs and derivatives."""
        numbers, found, square = self.of.likelihood(self.chosen, [values, *slopes], self.parts(x)[2])
        deviance, total, spread = numbers
        quality = self.of.relative(self.chosen, square, total, spread, float(self.size))
        return Scores(deviance, found[:, :, -1], found[:, :, :-1], *quality)

    def row(self, waves: Array, squares: Array, own: Array) -> Array:
        """Return the parameters (r, p) from waves (r, k), squares (e, b) common to all stars, and own (r, own, e)."""
        every = waves, np.broadcast_to(squares, (len(waves), *squares.shape)), own
        return np.concatenate([part.reshape(len(waves), -1) for part in every], axis=1)


@dataclass(frozen=True, eq=False)
class Blocks:
    """Information matrix of a field in blocks.

    `shared` (s, s) is the block of shared parameters, `own` (n, o, o) that of the own parameters of each star, and
    `mixed` (n, c, o) that of the c waves and squares of a star with its own parameters. `basis` (n, m) are the
    polynomials at each star, `waves` is the number k, and `squares` (e * b,) are the present squared widths.
    """

    shared: Array
    own: Array
    mixed: Array
    basis: Array
    waves: int
    squares: Array

    @classmethod
    def of_stars(cls, local: Array, basis: Array, waves: int, shared: int, squares: Array) -> Blocks:
        """Return blocks from the information (n, p, p) of single stars, with the shared parameters first."""
        blocks = cls(np.empty((0, 0)), local[:, shared:, shared:], local[:, :shared, shared:], basis, waves, squares)
        return replace(blocks, shared=blocks.outward(local[:, :shared, :shared]))

    def outward(self, local: Array) -> Array:
        """Convert matrices (n, c, c) of waves and squares to shared parameters, and sum over stars: (s, s)."""
        k, m = self.waves, self.basis.shape[1]
        e = local.shape[1] - k
        found = np.empty((k * m + e, k * m + e))
        pairs = (self.basis[:, :, None] * self.basis[:, None, :]).reshape(len(local), -1)
        square = (pairs.T @ local[:, :k, :k].reshape(len(local), -1)).reshape(m, m, k, k)
        found[: k * m, : k * m] = square.transpose(2, 0, 3, 1).reshape(k * m, k * m)
        cross = np.einsum("nm,nke->kme", self.basis, local[:, :k, k:]).reshape(k * m, e)
        found[: k * m, k * m :], found[k * m :, : k * m] = cross, cross.T
        found[k * m :, k * m :] = local[:, k:, k:].sum(axis=0)
        return found

    def gathered(self, local: Array) -> Array:
        """Convert derivatives (n, c) by waves and squares to shared parameters, and sum over stars: (s,)."""
        k = self.waves
        return np.concatenate([(local[:, :k].T @ self.basis).ravel(), local[:, k:].sum(axis=0)])

    def spread(self, shared: Array) -> Array:
        """Convert shared parameters (s,) to waves and squares of each star (n, c)."""
        k, m = self.waves, self.basis.shape[1]
        waves = self.basis @ shared[: k * m].reshape(k, m).T
        rest = np.broadcast_to(shared[k * m :], (len(waves), len(shared) - k * m))
        return np.concatenate([waves, rest], axis=1)

    def damped(self, damping: float) -> tuple[Array, Array]:
        """Return the damped shared matrix with own parameters eliminated, and inverses of damped own blocks."""
        own, shared = self.own.copy(), self.shared.copy()
        for matrix in (own, shared):
            diagonal = np.einsum("...ii->...i", matrix)
            diagonal += np.where(diagonal > 0.0, damping * diagonal, 1.0)
        inverse = np.linalg.inv(own)
        return shared - self.outward(self.mixed @ inverse @ self.mixed.swapaxes(-1, -2)), np.asarray(inverse)

    def eliminated(self, slope: Array, first: Array) -> Array:
        """Return the derivative (s,) with own parameters eliminated; `first` is the step of own parameters alone."""
        return np.asarray(slope - self.gathered((self.mixed @ first[:, :, None])[:, :, 0]))


class WholeField(_StarModel):
    """Stars of a field whose wavefronts are polynomials of their positions; all parameters are one row of a search.

    `basis` (n, m) are the values of the polynomials at each star. If `held`, polynomials and blur are fixed.
    """

    sharp = _SHARP

    def __init__(self, stars: FieldStars, chosen: NDArray[np.intp], basis: Array, *, held: bool = False) -> None:
        self.basis, self.held, self.waves = basis, held, len(stars.one.directions)
        super().__init__(stars, chosen, self.waves * basis.shape[1] + stars.exposures * stars.widths, math.inf)
        self.slopes = "own" if held else "all"
        self.size = self.shared + len(chosen) * stars.own * stars.exposures
        unknown = self.size - (self.shared if held else 0)
        self.pixels = int(stars.star[3][chosen].sum())
        self.tested = max(self.pixels - unknown, 1)
        self._each = unknown / len(chosen)

    def polynomials(self, x: Array) -> Array:
        """Return a view of the coefficients (k, m)."""
        return x[0, : self._widths.start].reshape(self.waves, self.basis.shape[1])

    def wavefronts(self, x: Array) -> Array:
        """Return the coefficients (r, k) of each star."""
        return np.asarray(self.basis @ self.polynomials(x).T)

    def row(self, polynomials: Array, squares: Array, own: Array) -> Array:
        """Return the parameters (1, p) from polynomials (k, m), squares (e, b) and own (r, own, e)."""
        return np.concatenate([polynomials.ravel(), squares.ravel(), own.ravel()])[None]

    def each(self, x: Array, *, fast: bool = False) -> Quality:
        """Return the quality of each star."""
        values = self.of.images(self.chosen, *self.parts(x), fast=fast, slopes="none")[0]
        return self.of.quality(self.chosen, values, self.parts(x)[2], self._each)

    def scores_of(self, x: Array, values: Any, slopes: Any) -> Scores:
        """Return the scores of the whole field, from PSFs of all stars and their derivatives."""
        (deviance, total, spread), found, square = self.of.likelihood(
            self.chosen, [values, *slopes], self.parts(x)[2]
        )
        c = self.waves + self.of.exposures * self.of.widths
        info, slope = found[:, :, :-1], found[:, :, -1]
        squares = self.squares(x).flatten()
        blocks = Blocks.of_stars(info, self.basis, self.waves, c, squares)
        whole = np.concatenate([blocks.gathered(slope[:, :c]), slope[:, c:].ravel()])
        boxed = np.empty(1, dtype=object)
        boxed[0] = blocks
        quality = reduced_chi2(square.sum(), total.sum(), spread.sum(), self.tested / self.pixels)
        return Scores(np.array([deviance.sum()]), whole[None], boxed, *(np.array([each]) for each in quality))

    def steps(self, scores: Scores, damping: Array) -> tuple[Array, Array]:
        """Return a damped step (1, p), with own parameters eliminated, and its product with the derivative of lnL."""
        blocks: Blocks = scores.information[0]
        slope = scores.slope[0]
        own = slope[self.shared :].reshape(len(self.chosen), -1)
        matrix, inverse = blocks.damped(float(damping[0]))
        first = (inverse @ own[:, :, None])[:, :, 0]
        if self.held:
            shared = np.zeros(self.shared)
        else:
            right = blocks.eliminated(slope[: self.shared], first)
            scale = 1.0 / np.sqrt(np.diag(matrix))
            matrix, right = matrix * np.outer(scale, scale), scale * right
            shared = scale * np.linalg.solve(matrix, right)
            at = np.arange(self.shared - len(blocks.squares), self.shared)
            sharp = shared[at] < -blocks.squares
            if sharp.any():  # a squared width would become negative: it is set to 0
                bound = np.zeros(self.shared, dtype=bool)
                bound[at[sharp]] = True
                ended = (-blocks.squares / scale[at])[sharp]
                right = right[~bound] - matrix[np.ix_(~bound, bound)] @ ended
                shared[bound] = -blocks.squares[sharp]
                shared[~bound] = scale[~bound] * np.linalg.solve(matrix[np.ix_(~bound, ~bound)], right)
        back = (blocks.mixed.swapaxes(-1, -2) @ blocks.spread(shared)[:, :, None])[:, :, 0]
        step = np.concatenate([shared, (first - (inverse @ back[:, :, None])[:, :, 0]).ravel()])
        return step[None], np.array([step @ slope])

    def rms(self, steps: Array) -> Array:
        """Return the largest rms phase among the steps of all stars, radians."""
        return np.asarray(super().rms(steps).max(initial=0.0, keepdims=True))

    def covariance(self, scores: Scores) -> Array:
        """Return the covariance (s, s) of shared parameters, with the parameters of star images as nuisance ones."""
        return covariance(scores.information[0].damped(0.0)[0])
