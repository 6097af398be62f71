"""Images of stars, pinholes or corners over a field, as functions of wavefront, position, flux and blur."""

from __future__ import annotations

import math
from collections.abc import Sequence
from copy import copy
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.blur.blurs import Blur
from lommel.blur.mixtures import BlurProfile
from lommel.core.engine import star_likelihood
from lommel.estimation.sampled_pupil import SMALL, PupilChanges, SampledPupil, changes_of
from lommel.estimation.star_images import (
    StarImages,
    Unknowns,
    centroids,
    loosest_tolerance,
    pixel_coordinates,
    pixel_data,
)
from lommel.estimation.star_readout import ROOM, StarReadout, lines_of
from lommel.estimation.target_readout import Target, TargetReadout, start_of_crossing
from lommel.fit.scoring import Progress, RowModel, Scores, covariance, flux_background, reduced_chi2
from lommel.methods.derivative_names import SHIFTS, Name, Term
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import Plan

_BLOCK_VALUES = 3e6  # number of samples of PSFs and of derivatives that are computed together
_OTHERS_SHARE = 0.55  # measured part of a fit's remaining time that the derivatives "others" take
_ZERO_LIMIT = 0.02  # squared width of blur, pixels^2, below which a step may set it to 0
_MIN_BRIGHT = 50.0  # chi2 of bright pixels requires this many more of them than twice the number of parameters
_FIRST_ANGLE = 4  # number of parameters of each image (row, column, flux, background) before the angles
_DONUT = 1.5 * math.pi  # C_d, radians, from which the outline of a star shows its astigmatism, and not a trail
_MAX_ANGLE_STEP = 0.05  # largest step of an angle, radians


Readout: TypeAlias = StarReadout | TargetReadout


class Quality(NamedTuple):
    """Chi2 per degree of freedom of r stars, shape (r,), and its standard deviation for a correct model."""

    chi2: Array
    spread: Array


class FieldStars:
    """Images of n stars in e exposures, electrons (n, e, height, width), and their likelihood.

    Parameters of a star are the k coefficients of its wavefront (`waves`, radians rms), the b squared widths of the
    blur of each exposure (pixels^2), and o nuisance parameters of each image: two tilts (row and column), flux,
    background, for corners two angles, and with `has_slopes` two slopes of the background. Arrays `nuisance` have the
    shape (r, o, e) for r stars; o is `parameters_per_image`. `blur` is a profile of unknown widths, or known blurs.
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
        blur: BlurProfile | tuple[Blur, ...],
        target: Target | None = None,
    ) -> None:
        self.count, self.exposures, height, width = electrons.shape
        self.shape = (height, width)
        self.pixel_count = height * width
        self.defocus = defocus
        self.threads, self.tol = plan.threads, plan.tol
        self.target = target
        self.angle_count = 0 if target is None else target.angle_count
        self.parameters_per_image = _FIRST_ANGLE + self.angle_count
        self.has_corners = self.angle_count > 0
        self.has_slopes, self.report = False, Progress(None)
        #: Lines by which each exposure is blurred besides, see `lines_of`.
        self.trails: Array = np.zeros((self.exposures, 2))
        #: Terms and constants by which `images` differentiates if `derivatives` is "others".
        self.extra_terms: tuple[Name, ...] = ()
        first_pupil = pupil if pupil.shape == () else pupil[0]
        self.integrate = bool(plan.grid(first_pupil).integrate)
        self.pupil, self.pixel = first_pupil, pixel / float(first_pupil.scale)  # pixel pitch in lambda*N
        self.blur = blur if isinstance(blur, BlurProfile) else BlurProfile.known(blur, pixel, first_pupil.wavelength)
        self.width_count = self.blur.unknown
        #: The images of the first star; its terms and directions apply to all stars.
        self.first_star = StarImages(electrons[0], variance[0], valid[0], first_pupil, defocus, unknowns, plan, pixel)
        self.size = len(unknowns.terms) + (self.width_count + self.parameters_per_image) * self.exposures
        self.pixel_data = pixel_data(electrons, variance, valid)
        self.search_tol = loosest_tolerance(self.pixel_data, plan.tol)
        #: Coefficients of the initial wavefront; the remainder, outside the estimated terms, is fixed.
        self.start, fixed = self.first_star.split(pupil.wavefront.edge_terms(), (self.count,))
        self.fixed_of_images: Array = np.repeat(fixed[:, None], self.exposures, axis=1)
        self.fixed_of_images[:, :, 0] += defocus[None]
        self.has_defocus = bool(defocus.any())
        self._terms: tuple[Term, ...] = (*unknowns.edge, *(SHIFTS[place] for place in ("row", "column")))
        self._reader: Readout | None = None
        self._sampled_pupils: dict[tuple[object, ...], SampledPupil] = {}
        #: The stars, parameters and images that were computed last, one set for all copies of these stars: searches
        #: and tests begin where the last search ended. One tuple in a list, which threads replace as a whole.
        self.latest: list[tuple[Any, bytes, list[Any]]] = [(None, b"", [])]
        self.degrees_of_freedom = int((self.pixel_data[3].sum(axis=(1, 2)) - self.size).mean())

    @property
    def is_donut(self) -> bool:
        """Whether all exposures are out of focus by waves, such that stars have an outline."""
        return float(np.abs(self.defocus).min()) > _DONUT

    def with_blur_profile(self, profile: BlurProfile) -> FieldStars:
        """Return a model of the same stars with another profile of the blur, of unknown widths."""
        added_count = (profile.unknown - self.width_count) * self.exposures
        changes = {"blur": profile, "width_count": profile.unknown, "size": self.size + added_count}
        degrees_of_freedom = self.degrees_of_freedom - added_count
        return self.copy_with(_reader=None, degrees_of_freedom=degrees_of_freedom, **changes)

    def with_background_slopes(self, *, sloping: bool = True) -> FieldStars:
        """Return a model with two more parameters per image: slopes of the background, electrons per pixel.

        Without them if `sloping` is False.
        """
        added_per_image = 2 * (sloping - self.has_slopes)
        added_count = added_per_image * self.exposures
        changes = {
            "parameters_per_image": self.parameters_per_image + added_per_image,
            "size": self.size + added_count,
        }
        degrees_of_freedom = self.degrees_of_freedom - added_count
        return self.copy_with(has_slopes=sloping, degrees_of_freedom=degrees_of_freedom, **changes)

    def with_optics(self, unknowns: Unknowns, pupil: Pupil, defocus: Array) -> FieldStars:
        """Return a model of the same stars with other unknowns, another aperture, and other known defoci."""
        first, (counted, variance, _, valid) = self.first_star, self.pixel_data[:, 0].reshape(4, -1, *self.shape)
        edge = self.fixed_of_images[:, 0] + self.start @ first.directions
        edge[:, 0] -= self.defocus[0]
        new = StarImages(counted, variance, valid > 0.0, pupil, defocus, unknowns, first.plan, first.pixel)
        start, fixed = new.split(dict(zip(first.terms, edge.T, strict=True)), (self.count,))
        fixed_of_images = np.repeat(fixed[:, None], self.exposures, axis=1)
        fixed_of_images[:, :, 0] += defocus
        added_count = len(unknowns.terms) - len(first.unknowns.terms)
        return self.copy_with(
            first_star=new, pupil=pupil, pixel=first.pixel / float(pupil.scale), defocus=defocus, start=start,
            fixed_of_images=fixed_of_images, size=self.size + added_count, _reader=None, _sampled_pupils={},
            degrees_of_freedom=self.degrees_of_freedom - added_count, _terms=(*unknowns.edge, *self._terms[-2:]),
        )  # fmt: skip

    def with_trails(self, trails: Array) -> FieldStars | None:
        """Return a model whose exposures are blurred by lines besides (`trails` as in `lines_of`).

        None if the images cannot tell a line: blur is not estimated, or a single star in one focus has astigmatism
        (of which defocus shows the outline).
        """
        astigmatic = any(abs(m) == 2 for _, m in self.first_star.unknowns.edge)
        is_told = self.is_donut or self.count > 1 or not (self.first_star.one_focus and astigmatic)
        longest = float(lines_of(trails)[0].max())
        if self.target is not None or not self.width_count or not is_told or longest > 0.5 * min(self.shape):
            return None
        return self.copy_with(trails=trails)

    def copy_with(self, **changes: Any) -> FieldStars:
        """Return a copy in which the attributes in `changes`, such as `extra_terms` or `pupil`, are replaced."""
        replaced = copy(self)
        vars(replaced).update(changes)
        return replaced

    def images(
        self, stars: NDArray[np.intp], waves: Array, squared_widths: Array, nuisance: Array, *, fast: bool,
        derivatives: str = "all",
    ) -> list[Array]:  # fmt: skip
        """Return the PSFs of r stars at their positions, and derivatives of the PSFs.

        `waves` is (r, k), `squared_widths` (r, e, b), `nuisance` (r, o, e); each result is (r * e, height, width).
        `derivatives` selects the derivatives. "all": by Zernike terms (amplitude at the pupil edge), tilts, squared
        widths and angles. "image": the same number of arrays, but only derivatives by tilts and angles are computed;
        the other arrays are 0. "none": no derivatives. "others": by `extra_terms`, by the changes of a pupil that
        `changes_of` lists, and, for stars, by the blurs `OTHER_BLURS`; all stars must then have the same squared
        widths.
        """
        reader = self._readout(squared_widths, always=derivatives == "others")
        names = self.extra_terms if derivatives == "others" else self._terms
        samples = self.exposures * math.prod(reader.shape if reader else self.shape) * (len(names) + 2)
        block = max(1, int(_BLOCK_VALUES / samples))
        edge = self.fixed_of_images[stars] + (waves @ self.first_star.directions)[:, None]
        for j, column in enumerate(self.first_star.tilts):
            edge[:, :, column] += nuisance[:, j]
        rows, parts = [slice(start, start + block) for start in range(0, len(stars), block)], []
        report = self.report if derivatives == "others" else Progress(None)
        report.begin(_OTHERS_SHARE, len(rows))
        for number, r in enumerate(rows):
            parts.append(self._block(reader, edge[r], squared_widths[r], nuisance[r], fast, derivatives))
            report(number)
        return [np.concatenate(arrays) for arrays in zip(*parts, strict=True)] if len(parts) > 1 else parts[0]

    def _readout(self, squared_widths: Array, *, always: bool) -> Readout | None:
        """Return the readout, which computes pixels from samples, for these widths of blur; None if not needed."""
        reader, profile = self._reader, self.blur
        if self.target is not None:
            if reader is None:
                self._reader = TargetReadout(self.shape, self.pixel, self.target, profile, integrate=self.integrate)
            return self._reader
        if not (always or self.width_count or self.integrate or profile.fixed.any()):
            return None
        # Samples extend as far as a blur of typical width (geometric mean of the known variances) requires: wider
        # Gaussians of seeing then lose only light far from the window.
        known_square = float(np.exp(profile.weights @ np.log(profile.fixed + 1e-12)))
        width = math.sqrt(float(squared_widths.sum(axis=-1).max(initial=0.0)) + known_square)
        variances = profile.variances(squared_widths).reshape(-1, len(profile.weights)).min(axis=0)
        if isinstance(reader, StarReadout) and reader.suffices_for(width, variances):
            return reader
        min_variances, max_width = variances, width
        if self.width_count:
            # Round the width up to a multiple of ROOM, so that lattices of sampled pupils can be reused.
            max_width = ROOM * (math.ceil(width / ROOM) + 1)
            min_variances = variances * max(1.0 - ROOM / max(width, ROOM), 0.0) ** 2
        self._reader = StarReadout(
            self.shape, self.pixel, max_width, profile, integrate=self.integrate, smallest_variances=min_variances
        )
        return self._reader

    def _block(
        self, reader: Readout | None, edge: Array, squared_widths: Array, nuisance: Array, fast: bool, selection: str
    ) -> list[Array]:
        """Return the result of `images` for a block of r stars, from Zernike terms `edge` (r, e, terms)."""
        edge = edge.reshape(-1, edge.shape[-1])
        pupil = self.pupil.carrying(Wavefront.trusted(self.first_star.terms, edge), None)
        tol = self.search_tol if fast else self.tol
        samples_shape, pitch = (self.shape, self.pixel) if reader is None else (reader.shape, reader.step)
        pixel = pitch * float(self.pupil.scale)
        plan = Plan(samples_shape, pixel, tol=tol, integrate=False, threads=self.threads or None)
        prepared = plan.prepared(pupil)
        names = {"all": self._terms, "image": self._terms[-2:], "none": (), "others": self.extra_terms}[selection]
        others = selection == "others"
        # Sampled pupils do not support masks, and have derivatives by phases only.
        quick = pupil.circular or pupil.strips is not None
        use_proven_method = pupil.mask is not None or (quick and (others or max(samples_shape) <= SMALL))
        if use_proven_method:
            _, pixels, derivatives = prepared.images(pupil, names)
            samples = [pixels.values, *(derivative.values for derivative in derivatives)]
        else:
            terms = self._sampled_terms
            columns = [terms.index(name) for name in names if name in terms]
            samples = list(self._sampled(plan.grid(self.pupil)).images(edge, columns, values=fast))
            if not fast:  # only the PSFs must be accurate: errors of derivatives hardly affect steps and results
                samples.insert(0, prepared.images(pupil)[1].values)
            if constants := tuple(name for name in names if name not in terms):
                for name, slope in zip(constants, prepared.images(pupil, constants)[2], strict=True):
                    samples.insert(1 + names.index(name), slope.values)
        if others and changes_of(self.pupil):
            samples += PupilChanges(self.pupil, plan.grid(self.pupil), self.first_star.terms, edge).images()
        if reader is None:
            images = [np.asarray(image).reshape(-1, *self.shape) for image in samples]
        else:
            stacked = [np.asarray(sample, np.float32).reshape(-1, *reader.shape) for sample in samples]
            if isinstance(reader, TargetReadout):
                angles = nuisance[:, _FIRST_ANGLE : _FIRST_ANGLE + self.angle_count].swapaxes(1, 2)
                angles = angles.reshape(len(stacked[0]), -1)
                widths = squared_widths.reshape(len(stacked[0]), -1)
                images = reader.read(stacked, widths, angles, derivatives=selection == "all", threads=self.threads)
                images = images[: len(stacked)] if others else images
            else:
                stacked = reader.trailed(stacked, self.trails) if self.trails.any() else stacked
                images = reader.read(stacked, squared_widths, derivatives=selection == "all")
                if others:
                    images += reader.other_blurs(stacked[0], squared_widths[0]).values()
        if selection == "image":
            zeros = np.zeros_like(images[0])
            zero_terms = [zeros] * (len(self._terms) - 2)
            images = [images[0], *zero_terms, *images[1:3], *[zeros] * self.width_count, *images[3:]]
        return images

    def _sampled(self, grid: Grid) -> SampledPupil:
        """Return the sampled pupil that computes images on the grid; reuse it in later calls."""
        key = self.pupil, grid.shape, grid.pixel, self.extra_terms
        if key not in self._sampled_pupils:
            self._sampled_pupils[key] = SampledPupil(self.pupil, grid, self._sampled_terms)
        return self._sampled_pupils[key]

    @property
    def _sampled_terms(self) -> tuple[Term, ...]:
        """The Zernike terms by which sampled pupils have derivatives: no constants such as the f-number."""
        return (*self.first_star.terms, *(name for name in self.extra_terms if not isinstance(name, str)))

    def likelihood(
        self, stars: NDArray[np.intp], images: Sequence[Array], nuisance: Array, extra: Sequence[Array] = ()
    ) -> tuple[Array, Array, Array]:
        """Return statistics of r stars, information matrices with gradients, and Pearson's sums.

        1. Deviance, and expectation and variance of Pearson's sum (3, r). 2. Information matrix of p parameters, with
        the gradient of the log-likelihood lnL as last column (r, p, p + 1). 3. Pearson's sum (r,).

        `images` are PSFs and their derivatives. The p parameters are waves, squared widths, q further parameters
        common to all exposures, and `nuisance`. The q arrays `extra` (r * e, height, width) are derivatives of
        electrons by the further parameters.
        """
        r, e, q = len(stars), self.exposures, len(extra)
        slope_derivatives = pixel_coordinates(r * e, self.shape) if self.has_slopes else ()
        sums, products = self._products(stars, [*images, *slope_derivatives, *extra], nuisance)
        chain = self._chain(nuisance, q, products.shape[-1])
        matrices = (chain @ products @ chain.swapaxes(-1, -2)).sum(axis=1)
        return sums, matrices[:, :-1], matrices[:, -1, -1]

    def columns(self, images: Sequence[Array], nuisance: Array) -> Array:
        """Return the derivatives of the electrons of one star by its p parameters, (p, e, height, width).

        Arguments and the order of the parameters are those of :meth:`likelihood`.
        """
        psf, *derivatives = images
        slope_derivatives = pixel_coordinates(self.exposures, self.shape) if self.has_slopes else ()
        stack = np.stack([*derivatives, *slope_derivatives, psf, np.ones_like(psf)]).astype(np.float64)
        chain = self._chain(nuisance, 0, len(stack) + 1)[0, :, :-1, :-1]
        return np.asarray(np.einsum("epd,deyx->peyx", chain, stack))

    def _chain(self, nuisance: Array, q: int, d: int) -> Array:
        """Return the chain rule (r, e, p + 1, d) from `d` images to p parameters, of which q are further ones.

        The last axis is: derivatives of PSFs by Zernike terms, tilts, blur and angles; derivatives of electrons by
        slopes of the background, and by further parameters; the PSF, 1 (for the background) and the residual.
        """
        (r, _, e), k, b = nuisance.shape, len(self.first_star.directions), self.width_count
        term_count = len(self.first_star.unknowns.edge)
        chain = np.zeros((r, e, self.size + q + 1, d))
        flux = nuisance[:, 2]
        chain[:, :, :k, :term_count] = self.first_star.unknowns.directions * flux[:, :, None, None]
        chain[:, :, k + e * b + np.arange(q), d - 3 - q + np.arange(q)] = 1.0
        for i in range(e):
            rows = k + e * b + q + np.arange(self.parameters_per_image) * e + i
            for j in range(b):
                chain[:, i, k + i * b + j, term_count + 2 + j] = flux[:, i]
            chain[:, i, rows[0], term_count] = chain[:, i, rows[1], term_count + 1] = flux[:, i]
            chain[:, i, rows[2], d - 3] = chain[:, i, rows[3], d - 2] = 1.0
            for j in range(_FIRST_ANGLE, self.parameters_per_image):
                factor = flux[:, i] if j < _FIRST_ANGLE + self.angle_count else 1.0
                chain[:, i, rows[j], term_count + 2 + b + j - _FIRST_ANGLE] = factor
        chain[:, :, -1, -1] = 1.0
        return chain

    def _products(self, stars: NDArray[np.intp], images: Sequence[Array], nuisance: Array) -> tuple[Array, Array]:
        """Return deviance, and expectation and variance of Pearson's sum (3, r), and inner products (r, e, d, d).

        The products are sums over pixels, for each pair of d images: `images`, the constant 1 and the residual, all
        divided by the standard deviation of each pixel.
        """
        data, brightness = self.without_slopes(stars, nuisance)
        brightness = np.ascontiguousarray(np.moveaxis(brightness, 1, 0).reshape(1, 2, -1))
        sums, products = star_likelihood(images, brightness, data.reshape(4, -1, self.pixel_count), self.threads)
        stack_shape = len(stars), self.exposures
        return sums.reshape(3, *stack_shape).sum(axis=-1), products.reshape(*stack_shape, *products.shape[-2:])

    def without_slopes(self, stars: NDArray[np.intp], nuisance: Array) -> tuple[Array, Array]:
        """Return pixel data without slopes of the background, and flux and flat background (r, 2, e).

        The data (4, r, e, pixels) are those of :func:`lommel.estimation.star_images.pixel_data`. Electrons plus the
        read variance have a Poisson distribution. A known part of the background may therefore be subtracted from the
        electrons and added to the variances.
        """
        data, brightness = self.pixel_data[:, stars], nuisance[:, 2:4].copy()
        if self.has_slopes:
            drop = self._largest_drop(nuisance)
            sloping = self._sloping_part(nuisance) + drop[:, :, None]
            data[0] -= sloping
            data[1:3] += sloping
            brightness[:, 1] -= drop
        return data, brightness

    def _largest_drop(self, nuisance: Array) -> Array:
        """Return the largest decrease of sloping backgrounds from the middle to a corner of the window (r, e)."""
        return np.asarray(np.tensordot(np.abs(nuisance[:, -2:]), [side // 2 for side in self.shape], (1, 0)))

    def _sloping_part(self, nuisance: Array) -> Array:
        """Return the sloping part of backgrounds, (r, e, pixels), from the last two parameters in `nuisance`."""
        y, x = pixel_coordinates(1, self.shape)
        return np.asarray(nuisance[:, -2, :, None] * y.ravel() + nuisance[:, -1, :, None] * x.ravel())

    def expected(self, psf: Array, nuisance: Array) -> Array:
        """Return the expected electrons of each pixel (r, e, pixels), for PSFs and `nuisance` (r, o, e)."""
        electrons = nuisance[:, 2, :, None] * psf.reshape(len(nuisance), self.exposures, -1) + nuisance[:, 3, :, None]
        return electrons + self._sloping_part(nuisance) if self.has_slopes else electrons

    def quality(self, stars: NDArray[np.intp], values: Array, nuisance: Array, parameter_count: float) -> Quality:
        """Return chi2 of stars from their PSFs `values`; `parameter_count` is the number of parameters per star."""
        (_, expectation, variance), products = self._products(stars, [values], nuisance)
        pearson_sum = products[..., -1, -1].sum(axis=-1)
        return self.quality_from_sums(stars, pearson_sum, expectation, variance, parameter_count)

    def quality_from_sums(
        self, stars: NDArray[np.intp], pearson_sum: Array, expectation: Array, variance: Array, parameter_count: float
    ) -> Quality:
        """Return chi2 of stars from Pearson's sum, its expectation and variance, and the parameters per star."""
        fraction = np.maximum(1.0 - parameter_count / self.pixel_data[3][stars].sum(axis=(1, 2)), 0.1)
        return Quality(*reduced_chi2(pearson_sum, expectation, variance, fraction))

    def bright_pixel_chi2(
        self, stars: NDArray[np.intp], values: Array, nuisance: Array, parameter_count: float
    ) -> tuple[float, float]:
        """Return chi2 of the pixels in which stars exceed the noise, and its standard deviation.

        Both are NaN for few such pixels, and for corners; `parameter_count` is the number of all parameters. A wrong
        wavefront increases this chi2 more than the chi2 of whole windows, which are mostly background.
        """
        psf = values.reshape(len(stars), self.exposures, -1)
        (counted, _, read, valid), brightness = self.without_slopes(stars, nuisance)
        star_light = brightness[:, 0, :, None] * psf
        model = star_light + brightness[:, 1, :, None]
        variance = np.maximum(np.maximum(model, 0.0) + read, 1e-3)
        is_bright = (valid > 0.0) & (star_light * star_light > variance)
        degrees_of_freedom = float(is_bright.sum()) - parameter_count
        if self.has_corners or degrees_of_freedom < parameter_count + _MIN_BRIGHT:
            return math.nan, math.nan
        variance, residual = variance[is_bright], (counted - model)[is_bright]
        fraction = degrees_of_freedom / len(residual)
        deviation = math.sqrt(float((2.0 + 1.0 / variance).sum()) * fraction) / degrees_of_freedom
        return float((residual * residual / variance).sum()) / degrees_of_freedom, deviation

    def flux_background(self, stars: NDArray[np.intp], values: Array, previous: Array) -> Array:
        """Return flux and background (r, 2, e) of stars by least squares, from their PSFs `values`.

        Slopes of the background, if any, are those in the parameters `previous`.
        """
        psf = values.reshape(len(stars), self.exposures, -1).astype(np.float64)
        (counted, _, read, valid), _ = self.without_slopes(stars, previous)
        flux, level = flux_background(psf, counted, read, valid)
        return np.stack([flux, level + self._largest_drop(previous) if self.has_slopes else level], axis=1)

    def centroids(self) -> Array:
        """Return the tilts (n, 2, e) that shift images to the centroids of stars, or to the crossings of corners."""
        if self.has_corners:
            return np.asarray(self._crossings[:, :2] * self.first_star.tilt_of_pixel)
        tilts = centroids(self.pixel_data, self.shape) * self.first_star.tilt_of_pixel
        return tilts.reshape(self.count, self.exposures, 2).swapaxes(1, 2)

    def shifts(self, stars: NDArray[np.intp], values: Array) -> Array:
        """Return shifts (r, 2, e) in whole pixels that maximize the correlation of PSFs with the images of stars."""
        counted, _, _, valid = self.pixel_data[:, stars].reshape(4, -1, *self.shape)
        level = np.median(counted, axis=(1, 2), keepdims=True)
        size = (2 * self.shape[0], 2 * self.shape[1])
        spectrum = np.fft.rfft2(np.where(valid > 0.0, counted - level, 0.0), size)
        correlation = np.fft.irfft2(spectrum * np.conj(np.fft.rfft2(values, size)), size)
        row, column = np.unravel_index(correlation.reshape(len(correlation), -1).argmax(axis=1), size)
        shifts = [(index + side // 2) % side - side // 2 for index, side in zip((row, column), size, strict=True)]
        offsets = np.stack(shifts, axis=1)
        return np.asarray(offsets.reshape(len(stars), self.exposures, 2).swapaxes(1, 2), np.float64)

    def limit_nuisance(self, nuisance: Array, previous: Array) -> None:
        """Limit tilts to the window, and flux and angles to steps from the values in `previous`, in place."""
        for j, largest_tilt in enumerate(self.first_star.largest_tilts):
            np.clip(nuisance[:, j], -largest_tilt, largest_tilt, out=nuisance[:, j])
        np.maximum(nuisance[:, 2], 0.1 * previous[:, 2], out=nuisance[:, 2])
        if self.has_corners:
            np.clip(
                nuisance[:, _FIRST_ANGLE:],
                previous[:, _FIRST_ANGLE:] - _MAX_ANGLE_STEP,
                previous[:, _FIRST_ANGLE:] + _MAX_ANGLE_STEP,
                out=nuisance[:, _FIRST_ANGLE:],
            )

    def start_values(self, rows: NDArray[np.intp], tilts: Array) -> Array:
        """Return initial values of the parameters of each image (r, o, e), from tilts (r, 2, e)."""
        other_values = np.ones((len(rows), self.parameters_per_image - 2, self.exposures))
        other_values[:, 2:] = self._crossings[rows][:, 2:] if self.has_corners else 0.0
        return np.concatenate([tilts, other_values], axis=1)

    @cached_property
    def _crossings(self) -> Array:
        """Initial row, column and two angles of each crossing (the corner's two lines), (n, 4, e)."""
        images = self.pixel_data[0].reshape(-1, *self.shape)
        crossings = np.array([start_of_crossing(image) for image in images])
        return crossings.reshape(self.count, self.exposures, -1).swapaxes(1, 2)


def limit_widths(squared_widths: Array, previous: Array, widest: float, *, zero_limit: float) -> None:
    """Limit squared widths (r, e, b) to steps from `previous`, in place.

    The sum over b may become 0 if its previous value is below `zero_limit`.
    """
    total = previous.sum(axis=-1, keepdims=True)
    np.clip(squared_widths, 0.0, np.minimum(4.0 * total + 0.1, widest), out=squared_widths)
    minimum = np.where(total < zero_limit, 0.0, 0.25 * total)
    new_total = squared_widths.sum(axis=-1, keepdims=True)
    is_too_small = new_total < minimum
    enlarged = np.where(new_total > 0.0, squared_widths * minimum / np.maximum(new_total, 1e-300), previous * 0.25)
    np.copyto(squared_widths, enlarged, where=is_too_small)


class _StarModel(RowModel):
    """Images of some stars of a field, as functions of rows of parameters."""

    alternatives = False  # see `RowModel`: rows are not different starts for the same images
    derivative_selection = "all"  # see `FieldStars.images`
    zero_limit = 0.0  # squared width of blur, pixels^2, below which a step may set it to 0

    def __init__(self, stars: FieldStars, chosen: NDArray[np.intp], common_count: int, widest: float) -> None:
        self.stars, self.chosen, self.widest = stars, chosen, widest
        #: Number of parameters in a row before the nuisance parameters: of the wavefronts, then squared widths.
        self.common_count = common_count
        self._width_columns = slice(common_count - stars.exposures * stars.width_count, common_count)

    def parts(self, x: Array) -> tuple[Array, Array, Array]:
        """Return waves (r, k), squared widths (r, e, b) and a view of nuisance parameters (r, o, e)."""
        nuisance = x[:, self.common_count :].reshape(-1, self.stars.parameters_per_image, self.stars.exposures)
        squared_widths = self.squared_widths(x)
        shape = (len(nuisance), *squared_widths.shape[1:])
        return self.wavefronts(x), np.broadcast_to(squared_widths, shape), nuisance

    def wavefronts(self, x: Array) -> Array:
        """Return the coefficients (r, k) of the wavefront of each star."""
        return x[:, : self._width_columns.start]

    def squared_widths(self, x: Array) -> Array:
        """Return a view of the squared widths of the blur (s, e, b) of each row."""
        return x[:, self._width_columns].reshape(len(x), self.stars.exposures, self.stars.width_count)

    def images(self, x: Array, *, fast: bool = False) -> tuple[Any, Any]:
        """Return the PSFs of all stars, and their derivatives."""
        parts, selection = self.parts(x), self.derivative_selection
        key = b"".join(np.asarray(part).tobytes() for part in (self.chosen, *parts)) + f"{selection} {fast}".encode()
        stars, latest_key, images = self.stars.latest[0]
        if stars is not self.stars or latest_key != key:
            images = self.stars.images(self.chosen, *parts, fast=fast, derivatives=selection)
            self.stars.latest[0] = self.stars, key, images
        values, *derivatives = images
        return values, derivatives

    def with_flux_background(self, x: Array, values: Any) -> Array:
        """Return the parameters with flux and background replaced by their least-squares values."""
        updated = x.copy()
        nuisance = self.parts(updated)[2]
        nuisance[:, 2:4] = self.stars.flux_background(self.chosen, values, nuisance)
        return updated

    def within(self, x: Array, before: Array) -> Array:
        """Limit parameters `x` to their valid range and to steps from `before`, in place."""
        limit_widths(self.squared_widths(x), self.squared_widths(before), self.widest, zero_limit=self.zero_limit)
        self.stars.limit_nuisance(self.parts(x)[2], self.parts(before)[2])
        return x

    def rms(self, steps: Array) -> Array:
        """Return the rms phase of the step of each star, radians."""
        edge = self.wavefronts(steps) @ self.stars.first_star.directions
        return np.asarray(np.sqrt((edge * edge) @ self.stars.first_star.mean_squares))


class SingleStars(_StarModel):
    """Stars with individual wavefronts: each row of a search contains the parameters of one star."""

    def __init__(self, stars: FieldStars, rows: NDArray[np.intp], widest: float) -> None:
        super().__init__(stars, rows, len(stars.first_star.directions) + stars.exposures * stars.width_count, widest)
        self.size, self.degrees_of_freedom = stars.size, stars.degrees_of_freedom

    def scores(self, x: Array, *, fast: bool = False, rows: NDArray[np.intp] | None = None) -> Scores:
        """Return the scores of all stars, or of the stars with the indices `rows`."""
        part = self if rows is None else SingleStars(self.stars, self.chosen[rows], self.widest)
        return part.scores_of(x, *part.images(x, fast=fast))

    def scores_of(self, x: Array, values: Any, derivatives: Any) -> Scores:
        """Return the scores of all stars, from their PSFs and derivatives."""
        sums, matrices, pearson_sum = self.stars.likelihood(self.chosen, [values, *derivatives], self.parts(x)[2])
        deviance, expectation, variance = sums
        quality = self.stars.quality_from_sums(self.chosen, pearson_sum, expectation, variance, float(self.size))
        return Scores(deviance, matrices[:, :, -1], matrices[:, :, :-1], *quality)

    def row(self, waves: Array, squared_widths: Array, nuisance: Array) -> Array:
        """Return the parameters (r, p) from waves (r, k), common squared widths (e, b) and nuisance (r, o, e)."""
        arrays = waves, np.broadcast_to(squared_widths, (len(waves), *squared_widths.shape)), nuisance
        return np.concatenate([array.reshape(len(waves), -1) for array in arrays], axis=1)


@dataclass(frozen=True, eq=False)
class Blocks:
    """Information matrix of a field in blocks.

    `common` (s, s) is the block of the parameters common to all stars: k m coefficients of polynomials and e b
    squared widths. `nuisance` (n, t, t) is the block of the t nuisance parameters of each star, and `mixed` (n, c, t)
    the block of its c waves and squared widths with its nuisance parameters. `basis` (n, m) are the values of the m
    polynomials at each star, `wave_count` is k, and `squared_widths` (e b,) are the values at which the matrix holds.
    """

    common: Array
    nuisance: Array
    mixed: Array
    basis: Array
    wave_count: int
    squared_widths: Array

    @classmethod
    def of_stars(cls, star_matrices: Array, basis: Array, wave_count: int, c: int, squared_widths: Array) -> Blocks:
        """Return blocks from the information (n, p, p) of single stars; c is the number of waves and squared widths.

        The last p - c parameters are the nuisance parameters.
        """
        nuisance, mixed = star_matrices[:, c:, c:], star_matrices[:, :c, c:]
        blocks = cls(np.empty((0, 0)), nuisance, mixed, basis, wave_count, squared_widths)
        return replace(blocks, common=blocks.summed_matrix(star_matrices[:, :c, :c]))

    def summed_matrix(self, star_matrices: Array) -> Array:
        """Convert matrices (n, c, c) from waves and widths to common parameters, and sum over stars: (s, s)."""
        k, m = self.wave_count, self.basis.shape[1]
        width_count = star_matrices.shape[1] - k
        matrix = np.empty((k * m + width_count, k * m + width_count))
        pairs = (self.basis[:, :, None] * self.basis[:, None, :]).reshape(len(star_matrices), -1)
        wave_part = (pairs.T @ star_matrices[:, :k, :k].reshape(len(star_matrices), -1)).reshape(m, m, k, k)
        matrix[: k * m, : k * m] = wave_part.transpose(2, 0, 3, 1).reshape(k * m, k * m)
        mixed_part = np.einsum("nm,nke->kme", self.basis, star_matrices[:, :k, k:]).reshape(k * m, width_count)
        matrix[: k * m, k * m :], matrix[k * m :, : k * m] = mixed_part, mixed_part.T
        matrix[k * m :, k * m :] = star_matrices[:, k:, k:].sum(axis=0)
        return matrix

    def summed_gradient(self, star_gradients: Array) -> Array:
        """Convert gradients (n, c) from waves and widths to common parameters, and sum over stars: (s,)."""
        k = self.wave_count
        return np.concatenate([(star_gradients[:, :k].T @ self.basis).ravel(), star_gradients[:, k:].sum(axis=0)])

    def star_steps(self, common_step: Array) -> Array:
        """Return the steps of waves and squared widths of each star (n, c) for a step of common parameters (s,)."""
        k, m = self.wave_count, self.basis.shape[1]
        wave_steps = self.basis @ common_step[: k * m].reshape(k, m).T
        width_steps = np.broadcast_to(common_step[k * m :], (len(wave_steps), len(common_step) - k * m))
        return np.concatenate([wave_steps, width_steps], axis=1)

    def eliminate_nuisance(self, damping: float) -> tuple[Array, Array]:
        """Return the damped matrix (s, s) without nuisance parameters, and the inverses of their damped blocks."""
        damped_nuisance, damped_common = self.nuisance.copy(), self.common.copy()
        for matrix in (damped_nuisance, damped_common):
            diagonal = np.einsum("...ii->...i", matrix)
            diagonal += np.where(diagonal > 0.0, damping * diagonal, 1.0)
        inverse = np.linalg.inv(damped_nuisance)
        eliminated = self.summed_matrix(self.mixed @ inverse @ self.mixed.swapaxes(-1, -2))
        return damped_common - eliminated, np.asarray(inverse)

    def reduced_gradient(self, gradient: Array, nuisance_steps: Array) -> Array:
        """Return `gradient` (s,) less the part due to `nuisance_steps` (n, t), for fixed common parameters."""
        return np.asarray(gradient - self.summed_gradient((self.mixed @ nuisance_steps[:, :, None])[:, :, 0]))


class WholeField(_StarModel):
    """Stars of a field whose wavefronts are polynomials of their positions; the search has one row of parameters.

    `basis` (n, m) are the values of the polynomials at each star. If `held`, polynomials and blur are fixed.
    """

    zero_limit = _ZERO_LIMIT

    def __init__(self, stars: FieldStars, chosen: NDArray[np.intp], basis: Array, *, held: bool = False) -> None:
        self.basis, self.held, self.wave_count = basis, held, len(stars.first_star.directions)
        common_count = self.wave_count * basis.shape[1] + stars.exposures * stars.width_count
        super().__init__(stars, chosen, common_count, math.inf)
        self.derivative_selection = "image" if held else "all"
        self.size = self.common_count + len(chosen) * stars.parameters_per_image * stars.exposures
        fitted_count = self.size - (self.common_count if held else 0)
        self.pixel_count = int(stars.pixel_data[3][chosen].sum())
        self.degrees_of_freedom = max(self.pixel_count - fitted_count, 1)
        self._fitted_per_star = fitted_count / len(chosen)

    def polynomials(self, x: Array) -> Array:
        """Return a view of the coefficients of the polynomials (k, m)."""
        return x[0, : self._width_columns.start].reshape(self.wave_count, self.basis.shape[1])

    def wavefronts(self, x: Array) -> Array:
        """Return the coefficients (r, k) of the wavefront of each star."""
        return np.asarray(self.basis @ self.polynomials(x).T)

    def row(self, polynomials: Array, squared_widths: Array, nuisance: Array) -> Array:
        """Return the parameters (1, p) from polynomials (k, m), squared widths (e, b) and nuisance (r, o, e)."""
        return np.concatenate([polynomials.ravel(), squared_widths.ravel(), nuisance.ravel()])[None]

    def star_quality(self, x: Array, *, fast: bool = False) -> Quality:
        """Return chi2 of each star."""
        values = self.stars.images(self.chosen, *self.parts(x), fast=fast, derivatives="none")[0]
        return self.stars.quality(self.chosen, values, self.parts(x)[2], self._fitted_per_star)

    def scores_of(self, x: Array, values: Any, derivatives: Any) -> Scores:
        """Return the scores of the whole field, from PSFs of all stars and their derivatives."""
        (deviance, expectation, variance), matrices, pearson_sum = self.stars.likelihood(
            self.chosen, [values, *derivatives], self.parts(x)[2]
        )
        c = self.wave_count + self.stars.exposures * self.stars.width_count
        information, gradients = matrices[:, :, :-1], matrices[:, :, -1]
        squared_widths = self.squared_widths(x).flatten()
        blocks = Blocks.of_stars(information, self.basis, self.wave_count, c, squared_widths)
        gradient = np.concatenate([blocks.summed_gradient(gradients[:, :c]), gradients[:, c:].ravel()])
        information_rows = np.empty(1, dtype=object)
        information_rows[0] = blocks
        fraction = self.degrees_of_freedom / self.pixel_count
        quality = reduced_chi2(pearson_sum.sum(), expectation.sum(), variance.sum(), fraction)
        arrays = (np.array([value]) for value in quality)
        return Scores(np.array([deviance.sum()]), gradient[None], information_rows, *arrays)

    def columns(self, x: Array) -> Array:
        """Return the derivatives of electrons by the parameters `x` (1, p), shape (p, n, h, w)."""
        values, derivatives = self.images(x)
        return self.stars.columns([values, *derivatives], self.parts(x)[2])

    def steps(self, scores: Scores, damping: Array) -> tuple[Array, Array]:
        """Return a damped step (1, p), and its product with the gradient of lnL."""
        blocks: Blocks = scores.information[0]
        gradient = scores.slope[0]
        nuisance_gradients = gradient[self.common_count :].reshape(len(self.chosen), -1)
        matrix, inverse = blocks.eliminate_nuisance(float(damping[0]))
        nuisance_steps = (inverse @ nuisance_gradients[:, :, None])[:, :, 0]
        if self.held:
            common_step = np.zeros(self.common_count)
        else:
            reduced = blocks.reduced_gradient(gradient[: self.common_count], nuisance_steps)
            scale = 1.0 / np.sqrt(np.diag(matrix))
            matrix, reduced = matrix * np.outer(scale, scale), scale * reduced
            common_step = scale * np.linalg.solve(matrix, reduced)
            width_indices = np.arange(self.common_count - len(blocks.squared_widths), self.common_count)
            is_negative = common_step[width_indices] < -blocks.squared_widths
            if is_negative.any():  # a squared width would become negative: it is set to 0
                fixed = np.zeros(self.common_count, dtype=bool)
                fixed[width_indices[is_negative]] = True
                scaled_ends = (-blocks.squared_widths / scale[width_indices])[is_negative]
                reduced = reduced[~fixed] - matrix[np.ix_(~fixed, fixed)] @ scaled_ends
                common_step[fixed] = -blocks.squared_widths[is_negative]
                common_step[~fixed] = scale[~fixed] * np.linalg.solve(matrix[np.ix_(~fixed, ~fixed)], reduced)
        coupling = (blocks.mixed.swapaxes(-1, -2) @ blocks.star_steps(common_step)[:, :, None])[:, :, 0]
        step = np.concatenate([common_step, (nuisance_steps - (inverse @ coupling[:, :, None])[:, :, 0]).ravel()])
        return step[None], np.array([step @ gradient])

    def rms(self, steps: Array) -> Array:
        """Return the largest rms phase among the steps of all stars, radians."""
        return np.asarray(super().rms(steps).max(initial=0.0, keepdims=True))

    def covariance(self, scores: Scores) -> Array:
        """Return the covariance (s, s) of the common parameters, with nuisance parameters eliminated."""
        return covariance(scores.information[0].eliminate_nuisance(0.0)[0])

    def nuisance_errors(self, scores: Scores) -> Array:
        """Return the standard errors (n, o, e) of the nuisance parameters of the stars of this model."""
        blocks = scores.information[0]
        matrix, inverse = blocks.eliminate_nuisance(0.0)
        star_parameters = np.stack([blocks.star_steps(row) for row in np.eye(len(matrix))], axis=-1)
        # Errors with exact common parameters, and errors of common parameters times their effect.
        effect = inverse @ blocks.mixed.swapaxes(1, 2) @ star_parameters
        variance = np.einsum("nii->ni", inverse) + np.einsum("nts,su,ntu->nt", effect, covariance(matrix), effect)
        return np.asarray(np.sqrt(variance)).reshape(len(variance), -1, self.stars.exposures)
