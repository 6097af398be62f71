"""Star images as functions of wavefront, pupil, position, flux and background, with their likelihood.

A row of `x`, shape (s, p), contains the p parameters of one search; s searches are evaluated together. The columns
are: `waves`, the coefficients of the wavefront; parameters of the pupil; tilts, flux and background of each image.
Tilts and other Zernike terms in arrays named `edge` are amplitudes at the pupil edge, radians.

The checks of a fit are called at the end of `phase_retrieval`, `field_search`, `field_fit` and `beads`. Tests of
residuals are in `fit/goodness_of_fit.py`. Score tests are in `fit/score_tests.py`, and the tested effects in
`star_checks`, `field_checks` and `bead_checks`. The codes of findings are in `fit/findings.py`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from copy import copy
from dataclasses import replace
from functools import cached_property, lru_cache
from typing import Any, NamedTuple, cast

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.blur.mixtures import BlurProfile
from lommel.core.answers import Pixels
from lommel.core.engine import star_likelihood
from lommel.estimation.sampled_pupil import OBSCURATION, PupilChanges
from lommel.estimation.star_readout import StarReadout
from lommel.fit.findings import Finding
from lommel.fit.scoring import RowModel, Scores, covariance, flux_background, reduced_chi2
from lommel.methods.derivative_names import POWERS, SHIFTS, Name, Term, parts, term_of
from lommel.methods.derivative_names import checked as checked_names
from lommel.methods.derivatives import Slope, translated
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil, checked
from lommel.optics.wavefront.wavefront import Wavefront, symmetric_terms
from lommel.psf import Plan, cached_plan
from lommel.special import zernike

OF_PUPIL = ("f_number", "wavelength", OBSCURATION)
MAX_LINEAR_ERROR = 0.22
"""Largest standard error of a wavefront, radians rms, for which images are nearly linear in its terms."""
_SYMMETRY_DEGREE = 256  # degree of the quadrature rule at whose nodes the symmetry of an aperture is tested
_MAX_NOISE_FRACTION = 0.3  # largest error of images in a search, divided by the read noise
_MAX_SEARCH_TOL = 1e-4  # largest error of images in a search, divided by the peak, unless `tol` is larger
_MIN_VARIANCE = 0.05  # smallest variance of the read noise, electrons squared
_ORDERS = 2  # number of radial orders beyond the estimated terms that are tested
_RIPPLE_ORDERS = 4  # number of radial orders of ripples (m != 0)
_ZONE_ORDER = 20  # largest radial order of zones (m = 0), unless that of the ripples is larger
_NO_BLUR, NO_WIDTHS = BlurProfile(np.ones(1), np.empty((1, 0)), np.zeros(1)), np.empty((1, 1, 0))
_FIRST_NOLL = 4  # Noll's index of defocus, after piston and tilts


class Phase(NamedTuple):
    """A change of the phases of single images: `weights` (n,) times the Zernike `term` (1 at the edge).

    The weights are multiplied by the change of the coefficient from its `stated` value.
    """

    term: Term
    weights: Array
    stated: float


class Unknowns:
    """The estimated parameters, from the arguments `terms` and `also` of :func:`lommel.retrieve`.

    Attributes
    ----------
    terms : tuple
        Names of the terms of the wavefront.
    edge : tuple of (n, m)
        Zernike terms of which `terms` are linear combinations.
    directions : ndarray, shape (terms, edge)
        Row for each term: its Zernike coefficients, radians at the pupil edge, if the coefficient of the term is 1.
    pupil : tuple of str
        Nuisance parameters of the pupil, common to all images.
    places : tuple of str
        "row" and "column" if estimated, separately for each image.
    phases : dict of str to Phase
        Estimated changes of the phases of single images.
    stated : tuple of (n, m)
        The terms in `edge` without those that are estimated because the images favour them.
    """

    def __init__(self, terms: int | Sequence[Term | str], also: str | Sequence[str]) -> None:
        nuisance = (also,) if isinstance(also, str) else also
        if not isinstance(nuisance, Sequence):
            raise TypeError(f"also must be a sequence of names, got {validation.shown(also)}")
        for name in nuisance:
            validation.choice("also", name, ("center", *SHIFTS, *OF_PUPIL))
        self.pupil = tuple(name for name in OF_PUPIL if name in nuisance)
        self.places = tuple(place for place in SHIFTS if place in nuisance or "center" in nuisance)
        self.terms = checked_terms(terms, _FIRST_NOLL, tuple(POWERS))
        shares = [_zernike_terms(name) for name in self.terms]
        self.edge = tuple(dict.fromkeys(term for share in shares for term in share))
        directions = np.array([share.get(term, 0.0) for share in shares for term in self.edge])
        self.directions = directions.reshape(len(shares), len(self.edge))
        self.phases: dict[str, Phase] = {}
        self.stated = self.edge
        if sum(map(len, shares)) > len(self.edge) and np.linalg.matrix_rank(self.directions) < len(shares):
            raise ValueError(
                f"terms must be linearly independent, got {validation.shown(terms)}: remove repeated terms"
            )
        for place in self.places:
            if SHIFTS[place] in self.edge:
                raise ValueError(
                    f"terms must be without {SHIFTS[place]} if the {place} of each image is estimated: remove it, or "
                    f"leave {place!r} and 'center' out of `also`"
                )

    def freeing(self, name: str | Term, phase: Phase | None = None) -> Unknowns:
        """Return the unknowns and one more: a Zernike term, a parameter of the pupil, or a change of phases."""
        freed = copy(self)
        if phase is not None:
            freed.phases = self.phases | {str(name): phase}
        elif isinstance(name, str):
            freed.pupil = tuple(p for p in OF_PUPIL if p in (*self.pupil, name))
        else:
            in_noll = any(isinstance(term, str) for term in self.terms)
            freed.terms = (*self.terms, f"noll {zernike.index_of(*name, 'noll')}" if in_noll else name)
            freed.edge = (*self.edge, name)
            freed.directions = np.pad(self.directions, ((0, 1), (0, 1)))
            freed.directions[-1, -1] = zernike.rms_factor(*name)
        return freed


def checked_terms(terms: object, first: int, texts: Sequence[str] = ()) -> tuple[Name, ...]:
    """Return the terms of the argument `terms`: their number from Noll's index `first` on, or a sequence of names.

    Names may be pairs (n, m), indices such as "noll 5", and `texts`.
    """
    if isinstance(terms, int | np.integer) and not isinstance(terms, bool):
        count = validation.integer("terms", terms, least=1, most=500)
        return tuple(zernike.term(first + k, "noll") for k in range(count))
    names = terms if isinstance(terms, Sequence) and not isinstance(terms, str) else ()
    if any(isinstance(name, int) for name in names):
        raise ValueError(
            f"terms must be the number of terms from Noll's index {first} on, or a sequence of pairs (n, m) and "
            f"names that state the order of their index, such as 'noll 5', got {validation.shown(terms)}"
        )
    return checked_names(cast("Sequence[Name]", terms), "terms", texts)


@lru_cache(maxsize=1024)
def _zernike_terms(name: Name) -> dict[Term, float]:
    """Return Zernike coefficients, radians at the edge, of a term: 1 rad rms of it, or 1 rad if it is in `POWERS`."""
    coefficients = cast("dict[Term, float]", translated(parts(name, Pupil(), 1.0, energy=False).phases, powers=False))
    return coefficients if name in POWERS else {(n, m): zernike.rms_factor(n, m) for n, m in coefficients}


def next_terms(estimated: Sequence[Term], others: Sequence[Term]) -> tuple[Term, ...]:
    """Return Zernike terms up to two radial orders above the estimated terms `estimated`, without these and `others`.

    Rotationally symmetric terms are included up to four orders above, because they resemble spherical aberration.
    """
    if not estimated:
        return ()
    last_order = max(n for n, _ in estimated) + _ORDERS
    orders = range(2, last_order + _ORDERS + 1)
    all_terms = ((n, m) for n in orders for m in range(-n, n + 1, 2) if n <= last_order or m == 0)
    return tuple(term for term in all_terms if term not in estimated and term not in others)


def ripple_terms(estimated: Sequence[Term]) -> tuple[Term, ...]:
    """Return terms of higher radial orders than those of `next_terms`: polishing ripples, and zones of a mirror."""
    if not estimated:
        return ()
    last_order = max(n for n, _ in estimated) + _ORDERS
    finest = last_order + _RIPPLE_ORDERS
    ripples = ((n, m) for n in range(last_order + 1, finest + 1) for m in range(-n, n + 1, 2) if m)
    zones = ((n, 0) for n in range(2, max(finest, _ZONE_ORDER) + 1, 2) if n > last_order + _ORDERS)
    return (*ripples, *zones)


@lru_cache(maxsize=1024)
def label(name: Name) -> str:
    """Return the label of a term in a table: Noll's index and the usual name of the aberration."""
    if isinstance(name, str):
        term = term_of(name)
        return name if term is None else f"{name} {zernike.name(*term)}"
    return f"noll {zernike.index_of(*name, 'noll')} {zernike.name(*name)}"


@lru_cache(maxsize=2)
def _sharp_reader(shape: tuple[int, int], pixel: float, integrate: bool) -> StarReadout:
    """Return the readout of images without blur, whose tables serve many fits."""
    return StarReadout(shape, pixel, 1.0, _NO_BLUR, integrate=integrate)


def pixel_data(electrons: Array, variance: Array, valid: NDArray[np.bool_]) -> Array:
    """Return electrons, read variances, read variances of at least `_MIN_VARIANCE`, and validity (4, ..., pixels)."""
    counted = np.where(valid, electrons, 0.0)
    data = np.stack([counted, variance, np.maximum(variance, _MIN_VARIANCE), valid])
    return data.reshape(*data.shape[:-2], -1)


def single(pupil: Pupil, reason: str) -> Pupil:
    """Return the pupil if it is not a stack; otherwise raise a TypeError or ValueError, with the reason `reason`."""
    if checked(pupil).shape != ():
        raise ValueError(f"pupil must be a single one, {reason}, got a stack of shape {pupil.shape}")
    return pupil


def known_defocus(defoci: tuple[float, ...], count: int, noun: str) -> Array:
    """Return the known C_d, radians, of each of `count` images or exposures, 0 by default; `noun` is their name."""
    if len(defoci) not in (0, 1, count):
        raise ValueError(f"defocus must be a number, or one for each of {count} {noun}, got {len(defoci)} numbers")
    return np.broadcast_to(defoci or (0.0,), count)


def pixel_coordinates(images: int, shape: tuple[int, int]) -> list[Array]:
    """Return the row and column of each pixel relative to the middle pixel: two arrays (images, height, width)."""
    grids = np.meshgrid(*(np.arange(side) - side // 2.0 for side in shape), indexing="ij")
    return [np.broadcast_to(grid, (images, *shape)) for grid in grids]


def centroids(data: Array, shape: tuple[int, int]) -> Array:
    """Return the centroids (n, 2) of the light above noise and background, rows and columns from the middle."""
    counted, _, read, valid = data.reshape(4, -1, *shape)
    is_valid, rim = valid > 0.0, np.ones(shape, dtype=bool)
    rim[1:-1, 1:-1] = False
    # The background is that of the outermost pixels, or of all pixels if no outermost pixel is valid.
    is_background = is_valid & (rim | ~(is_valid & rim).any(axis=(1, 2), keepdims=True))
    levels = [
        np.median(image[mask]) if mask.any() else np.nan for image, mask in zip(counted, is_background, strict=True)
    ]
    level = np.reshape(levels, (-1, 1, 1))
    noise = np.sqrt(np.maximum(level, 0.0) + read.mean(axis=(1, 2), keepdims=True))
    light = np.where(is_valid & (counted > level + 3.0 * noise), counted - level, 0.0)
    total = np.maximum(light.sum(axis=(1, 2)), 1e-12)  # without light, the centroid is the middle
    rows, columns = (np.arange(side) - side // 2 for side in shape)
    return np.stack([light.sum(axis=2) @ rows / total, light.sum(axis=1) @ columns / total], axis=1)


def loosest_tolerance(data: Array, tol: float) -> float:
    """Return the tolerance of images in a search: their error may be a fraction of the read noise."""
    brightest = max(float(data[0].max()), 1.0)
    # The brightest pixel is about the peak: limit the error, tol * peak, to a fraction of the read noise.
    return min(max(tol, _MAX_NOISE_FRACTION * math.sqrt(data[2].min()) / brightest), max(tol, _MAX_SEARCH_TOL))


def _point_symmetric(pupil: Pupil) -> bool:
    """Return whether the aperture has two-fold symmetry, and no phases of segments or masks."""
    if pupil.circular:
        return True
    if pupil.segmented or pupil.phase_mask:
        return False
    x, y, _ = pupil.opening.rule(_SYMMETRY_DEGREE)
    symmetric = bool((pupil.opening.margin(-x, -y) > -1e-9).all())
    mask = None if pupil.mask is None else pupil.mask.values
    return symmetric and (mask is None or np.allclose(mask, mask[::-1, ::-1], atol=1e-6))


class StarImages(RowModel):
    """Star images as functions of a row of parameters: terms, pupil parameters, tilts, flux, background.

    `electrons` (n, height, width) are the recorded images, `variance` is the variance of the read noise, and
    `defocus` (n,) is the known C_d, radians.
    """

    alternatives = True  # see `RowModel`: rows are different starts for the same images

    def __init__(
        self,
        electrons: Array,
        variance: Array,
        valid: NDArray[np.bool_],
        pupil: Pupil,
        defocus: Array,
        unknowns: Unknowns,
        plan: Plan,
        pixel: float,
    ) -> None:
        count, *window = electrons.shape
        self.count, self.shape = count, (window[0], window[1])
        self.pixel_data = pixel_data(electrons, variance, valid)
        self.counted, _, self.read, self.valid = self.pixel_data
        self.pupil, self.unknowns, self.plan, self.pixel = pupil, unknowns, plan, pixel
        tilts = [SHIFTS[place] for place in unknowns.places]
        self.derivatives: tuple[Name, ...] = (*unknowns.edge, *tilts, *unknowns.pupil)
        #: Parameters common to all images.
        self.names: tuple[Name, ...] = (*unknowns.terms, *unknowns.pupil, *unknowns.phases)
        self.search_tol = loosest_tolerance(self.pixel_data, plan.tol)
        options: dict[str, Any] = {"integrate": plan.integrate, "threads": plan.threads or None}
        self._search_plan = cached_plan(self.shape, pixel, tol=self.search_tol, **options)
        self.tilt_of_pixel = math.pi * pixel / pupil.scale  # radians at the edge, for a shift of one pixel
        start = pupil.wavefront.edge_terms()
        all_terms = {*start, *unknowns.edge, *SHIFTS.values()}
        radial = symmetric_terms(max(n // 2 for n, m in all_terms if m == 0))
        self.terms = (*radial, *sorted(term for term in all_terms if term[1]))
        edge = np.array([start.get(term, 0.0) for term in self.terms], dtype=np.float64)
        self.directions = np.zeros((len(unknowns.terms), len(self.terms)))
        self.directions[:, [self.terms.index(term) for term in unknowns.edge]] = unknowns.directions
        #: Moore-Penrose inverse of directions.
        self.inverse = np.linalg.pinv(self.directions)
        # The search starts at the projection of the initial wavefront onto the terms; the remainder is fixed.
        self.start = edge @ self.inverse
        self.fixed = edge - self.start @ self.directions
        self.fixed_of_images = np.tile(self.fixed, (count, 1))
        self.fixed_of_images[:, 0] += defocus
        self.largest_tilts = [0.5 * side * self.tilt_of_pixel for side in self.shape][: len(unknowns.places)]
        self.tilts = [self.terms.index(term) for term in tilts]
        # The n values of each parameter of single images are in adjacent columns.
        k, self.common_count = len(unknowns.terms), len(self.names)
        self.size = self.common_count + (len(unknowns.places) + 2) * count
        self.wave_columns, self.pupil_columns = slice(0, k), slice(k, k + len(unknowns.pupil))
        self.phase_columns = slice(self.pupil_columns.stop, self.common_count)
        self.image_columns = slice(self.common_count, self.size)
        self._chain = np.zeros((count, self.size + 1, len(self.derivatives) + 3))
        term_count = len(unknowns.edge)
        self._phases = term_count + len(self.tilts)
        self._chain[:, self.wave_columns, :term_count] = unknowns.directions
        self._chain[:, self.pupil_columns, self._phases : -3] = np.eye(len(unknowns.pupil))
        for column, phase in enumerate(unknowns.phases.values(), self.phase_columns.start):
            self._chain[:, column, unknowns.edge.index(phase.term)] = phase.weights
        self._chain[:, -1, -1] = 1.0
        for j, row in enumerate([*range(term_count, self._phases), -3, -2]):
            self._chain[np.arange(count), self.common_count + j * count + np.arange(count), row] = 1.0
        self.degrees_of_freedom = int(valid.sum()) - self.size
        self.even = np.array([n % 2 == 0 for n, _ in self.terms])
        # The mean square of a term with amplitude 1 at the edge is 1 / (n + 1) if m = 0, otherwise half of this.
        self.mean_squares = np.array([1.0 / ((n + 1) * (1 if m == 0 else 2)) for n, m in self.terms])

    @property
    def known_defoci(self) -> Array:
        """The known C_d of each image, radians, shape (n,)."""
        return np.asarray(self.fixed_of_images[:, 0] - self.fixed[0])

    @property
    def stated(self) -> dict[Name, float]:
        """The values of the parameters common to all images that the pupil and the known defoci state."""
        of_pupil: dict[Name, float] = {name: getattr(self.pupil, name) for name in self.unknowns.pupil}
        of_pupil |= {name: phase.stated for name, phase in self.unknowns.phases.items()}
        return dict(zip(self.unknowns.terms, self.start.tolist(), strict=True)) | of_pupil

    def with_unknowns(self, unknowns: Unknowns, x: Array) -> tuple[StarImages, Array]:
        """Return the model with more unknowns, and its parameters (1, p) for the images of this one at `x`."""
        counted, variance, _, valid = self.pixel_data.reshape(4, self.count, *self.shape)
        model = StarImages(
            counted, variance, valid > 0.0, self.pupil, self.known_defoci, unknowns, self.plan, self.pixel
        )
        values = model.stated | dict(zip(self.names, x[0], strict=False))
        row = np.zeros((1, model.size))
        row[0, : model.common_count] = [values[name] for name in model.names]
        row[:, model.image_columns] = x[:, self.image_columns]
        return model, row

    def mean_tilts(self, edge: Array) -> Array:
        """Return the shift of the centroid due to a wavefront `edge` (..., terms), as tilts (places, ...)."""
        # Each term R_n^1 shifts the centroid as much as a tilt with the same amplitude at the edge.
        orders = np.array([m for _, m in self.terms])
        return np.array([edge[..., orders == SHIFTS[place][1]].sum(axis=-1) for place in self.unknowns.places])

    def split(self, edge: Mapping[Term, Any], shape: tuple[int, ...]) -> tuple[Array, Array]:
        """Return coefficients of wavefronts, and their fixed remainders; terms in `edge` broadcast to `shape`."""
        full_edge = np.stack([np.broadcast_to(edge.get(term, 0.0), shape) for term in self.terms], axis=-1)
        coefficients = full_edge @ self.inverse
        return coefficients, np.asarray(full_edge - coefficients @ self.directions)

    @property
    def one_focus(self) -> bool:
        """Whether all images have the same defocus, such that signs of even terms are ambiguous."""
        return bool(np.ptp(self.fixed_of_images * self.even, axis=0).max() == 0.0)

    @cached_property
    def sign_ambiguous(self) -> bool:
        """Whether images do not change if the even part of the phase is negated."""
        return self.one_focus and self._can_negate(self.fixed_of_images)

    @cached_property
    def foci_exchangeable(self) -> bool:
        """Whether images only change if the even part of the phase is negated without the known defoci."""
        return not self.sign_ambiguous and self._can_negate(self.fixed)

    def _can_negate(self, fixed: Array) -> bool:
        """Return whether the estimated terms can negate the even part of `fixed` (..., terms) and of themselves."""
        if not _point_symmetric(self.pupil) or not (self.even * self.directions).any():
            return False
        even_parts = self.even * np.vstack([self.directions, fixed])
        # The even part can only be negated if it is a linear combination of the estimated terms.
        remainder = even_parts - even_parts @ self.inverse @ self.directions
        return bool(np.abs(remainder).max() < 1e-9)

    def negated(self, waves: Array, fixed: Array) -> Array:
        """Return coefficients (..., terms) of the wavefront with its even part, that of `fixed` included, negated."""
        return waves - 2.0 * (self.even * (fixed + waves @ self.directions)) @ self.inverse

    def even_part_negated(self, x: Array) -> Array:
        """Return the parameters of the wavefront whose even part is negated."""
        waves = self.negated(x[:, self.wave_columns], self.fixed_of_images[0])
        return np.concatenate([waves, x[:, self.wave_columns.stop :]], axis=1)

    def nearest(self, x: Array) -> Array:
        """Return `x`, with the even part of a row negated if it is then nearer to the initial wavefront."""
        if not self.sign_ambiguous:
            return x
        negated = self.even_part_negated(x)
        start = np.pad(self.start, (0, self.size - len(self.start)))
        distance, negated_distance = (self.rms(parameters - start) for parameters in (x, negated))
        first_even = next(j for j, row in enumerate(self.directions) if row[self.even].any())
        not_farther = negated_distance < distance * (1.0 + 1e-6)
        # At equal distances, choose the wavefront whose first even term is larger.
        swap = (negated_distance < distance * (1.0 - 1e-6)) | (
            not_farther & (negated[:, first_even] > x[:, first_even])
        )
        return np.where(swap[:, None], negated, x)

    def wavefront(self, x: Array) -> Wavefront:
        """Return the wavefront of parameters `x`, shape (p,), without tilts and known defoci."""
        edge = self.fixed + x[self.wave_columns] @ self.directions
        ratio = self.wavelength_ratio(self.pupil_parameters(x[None]))
        return Wavefront.trusted(self.terms, ratio * edge, self.pupil.wavefront.error)

    def pupils(self, x: Array) -> Pupil:
        """Return the pupils of all images for parameters `x`, shape (s, p) or (p,)."""
        edge = self.fixed_of_images + (x[..., self.wave_columns] @ self.directions)[..., None, :]
        image_parameters = x[..., self.image_columns].reshape(*x.shape[:-1], -1, self.count)
        for j, column in enumerate(self.tilts):
            edge[..., column] += image_parameters[..., j, :]
        for column, phase in enumerate(self.unknowns.phases.values(), self.phase_columns.start):
            edge[..., self.terms.index(phase.term)] += (x[..., column, None] - phase.stated) * phase.weights
        parameters: dict[str, Any] = self.pupil_parameters(x) if self.unknowns.pupil else {}
        if "wavelength" in parameters:
            # Parameters are path differences, in radians at the initial wavelength: convert to the estimated one.
            edge *= self.wavelength_ratio(parameters)
        pupils = self.pupil.carrying(Wavefront.trusted(self.terms, edge), None)
        return replace(pupils, **parameters) if parameters else pupils

    def pupil_parameters(self, x: Array) -> dict[str, float]:
        """Return the estimated pupil parameters, from the first row of `x`."""
        return dict(zip(self.unknowns.pupil, x.reshape(-1, self.size)[0, self.pupil_columns].tolist(), strict=True))

    def wavelength_ratio(self, parameters: dict[str, float]) -> float:
        """Return the initial wavelength divided by the estimated one."""
        wavelength = self.pupil.wavelength
        return 1.0 if wavelength is None else wavelength / parameters.get("wavelength", wavelength)

    def per_image(self, x: Array) -> Array:
        """Return a view of the parameters of single images, shape (s, parameters, n): tilts, flux, background."""
        return x[:, self.image_columns].reshape(len(x), -1, self.count)

    def images(
        self, x: Array, *, fast: bool = False, names: tuple[Name, ...] | None = None
    ) -> tuple[Pixels, list[Slope]]:
        """Return the PSFs of images, shape (s * n, height, width), and derivatives of the PSFs by `names`.

        By default, derivatives are by all parameters except flux and background. If `fast`, the tolerance is
        `search_tol`.
        """
        pupil, plan = self.pupils(x[0] if len(x) == 1 else x), self._search_plan if fast else self.plan
        names = self.derivatives if names is None else names
        proven = tuple(name for name in names if name != OBSCURATION)
        _, pixels, derivatives = plan.prepared(pupil).images(pupil, proven)
        if OBSCURATION in names:
            # Errors of a derivative hardly affect steps and results, and a proven one takes ten times as long.
            slopes = np.zeros_like(pixels.values)
            if pupil.obscuration:
                reader, changes = self.changes(pupil)
                (slopes,) = reader.read([changes.by_obscuration()], NO_WIDTHS, derivatives=False)
            derivatives.insert(names.index(OBSCURATION), Slope(slopes, np.full(len(slopes), np.inf)))
        return pixels.values, derivatives

    def sharp(self, pupil: Pupil) -> tuple[StarReadout, Grid]:
        """Return the readout of images without blur, and the grid of its samples."""
        scale = float(pupil.scale)
        reader = _sharp_reader(self.shape, self.pixel / scale, self.plan.grid(pupil).integrate)
        return reader, Grid(reader.shape, reader.step * scale, integrate=False)

    def changes(self, pupil: Pupil) -> tuple[StarReadout, PupilChanges]:
        """Return the derivatives by changes of a stack of pupils, and the readout of their samples."""
        edge, (reader, grid) = pupil.wavefront.edge_terms(), self.sharp(pupil)
        phases = np.stack([np.broadcast_to(edge[term], pupil.shape).ravel() for term in self.terms], axis=-1)
        return reader, PupilChanges(pupil[(0,) * len(pupil.shape)], grid, self.terms, phases)

    def mean(self, x: Array, psf: Array) -> Array:
        """Return the expected electrons of each pixel for PSFs of shape (s, n, pixels)."""
        image_parameters = self.per_image(x)
        return image_parameters[:, -2, :, None] * psf + image_parameters[:, -1, :, None]

    def variance(self, mean: Array) -> Array:
        """Return the variance of pixels, at least a quarter of the read variance (`mean` may be negative)."""
        return np.asarray(np.maximum(mean + self.read, 0.25 * self.read))

    def scores_of(self, x: Array, values: Pixels, derivatives: Sequence[Slope]) -> Scores:
        """Return the scores from PSFs and their derivatives; flux and background are those in `x`."""
        sums, matrices = self.products(x, values, derivatives)
        deviance, expectation, variance = sums
        # Each fitted parameter reduces the expectation of Pearson's sum by the contribution of an average pixel.
        fraction = self.degrees_of_freedom / (self.degrees_of_freedom + self.size)
        quality = reduced_chi2(matrices[:, -1, -1], expectation, variance, fraction)
        return Scores(deviance, matrices[:, :-1, -1], matrices[:, :-1, :-1], *quality)

    def products(
        self, x: Array, values: Pixels, derivatives: Sequence[Slope], extra: Sequence[Array] = ()
    ) -> tuple[Array, Array]:
        """Return deviance, and expectation and variance of Pearson's sum (3, s), and inner products.

        The inner products (s, p + q + 1, p + q + 1) are sums over pixels, for each pair of images: the derivatives by
        the p parameters, the q images `extra` (s * n, height, width), which are further derivatives of electrons, and
        the residual. Each image is divided by the standard deviation of each pixel.
        """
        flux_and_background, q = np.ascontiguousarray(self.per_image(x)[:, -2:]), len(extra)
        images = [values, *[slope.values for slope in derivatives], *extra]
        sums, products = star_likelihood(images, flux_and_background, self.pixel_data, self.plan.threads)
        chain = self._chain_at(x)
        if not q:
            return sums.sum(axis=-1), (chain @ products @ chain.swapaxes(-1, -2)).sum(axis=1)
        # The chain rule does not change the images `extra`.
        first = chain.shape[-1] - 3
        own, others = np.r_[:first, first + q : first + q + 3], slice(first, first + q)
        chained = chain @ products[:, :, own]
        square = (chained[..., own] @ chain.swapaxes(-1, -2)).sum(axis=1)
        cross, rest = chained[..., others].sum(axis=1), products[:, :, others, others].sum(axis=1)
        order = np.r_[: self.size, self.size + 1 : self.size + 1 + q, self.size]
        matrix = np.block([[square, cross], [cross.swapaxes(-1, -2), rest]])
        return sums.sum(axis=-1), matrix[:, order[:, None], order]

    def _chain_at(self, x: Array) -> Array:
        """Return the chain rule (s, n, p + 1, d) from derivatives of PSFs, flux and background, and the residual."""
        factors = np.ones((len(x), self.count, 1, self._chain.shape[-1]))
        factors[..., :-3] = self.per_image(x)[:, -2, :, None, None]
        if self.unknowns.pupil:
            factors[..., : self._phases] *= self.wavelength_ratio(self.pupil_parameters(x))
        return np.asarray(self._chain * factors)

    def columns(self, x: Array) -> Array:
        """Return the derivatives of electrons by the parameters `x` (1, p), shape (p, n, height, width)."""
        values, slopes = self.images(x)
        images = np.stack([*(slope.values for slope in slopes), values, np.ones_like(values)]).astype(np.float64)
        return np.asarray(np.einsum("npd,dnyx->pnyx", self._chain_at(x)[0, :, :-1, :-1], images))

    def with_flux_background(self, x: Array, values: Pixels) -> Array:
        """Return the parameters with flux and background from linear least squares for the PSFs `values`."""
        updated = x.copy()
        image_parameters = self.per_image(updated)
        psf = values.reshape(len(x), self.count, -1).astype(np.float64)
        image_parameters[:, -2], image_parameters[:, -1] = flux_background(psf, self.counted, self.read, self.valid)
        return updated

    def within(self, x: Array, before: Array) -> Array:
        """In place, limit tilts to the window, flux to a tenth or more of that in `before`, and pupil parameters."""
        image_parameters, previous = self.per_image(x), self.per_image(before)
        # At flux 0 the images would not determine the other parameters.
        np.maximum(image_parameters[:, -2], 0.1 * previous[:, -2], out=image_parameters[:, -2])
        for j, largest_tilt in enumerate(self.largest_tilts):
            tilt = image_parameters[:, j]
            np.minimum(np.maximum(tilt, -largest_tilt, out=tilt), largest_tilt, out=tilt)
        for column, name in enumerate(self.unknowns.pupil, self.pupil_columns.start):
            if name == "obscuration":
                np.clip(x[:, column], 0.0, 0.98, out=x[:, column])
            else:
                np.clip(x[:, column], 0.8 * before[:, column], 1.25 * before[:, column], out=x[:, column])
        return x

    def rms(self, steps: Array) -> Array:
        """Return the rms phase of steps of the parameters, without tilts, radians, shape (s,)."""
        edge = steps[:, self.wave_columns] @ self.directions
        return np.asarray(np.sqrt((edge * edge) @ self.mean_squares))


def too_dim_findings(rms: float, limit: float = MAX_LINEAR_ERROR) -> list[Finding]:
    """Return the finding that images are not linear within the standard error `rms` of a wavefront, radians."""
    text = (
        f"too little light for so many unknowns: the standard error of a wavefront is {rms:.2g} rad rms; above "
        f"{limit:.2g}, images are not linear, and other wavefronts may fit as well"
    )
    return [Finding("too_dim", "doubt", text, {"rms": rms, "limit": limit})] if rms > limit else []


def uncertainty(model: StarImages, covariance_matrix: Array) -> tuple[float, Array]:
    """Return the largest standard error of an image's phase, radians rms, and the principal axes (k, p).

    Each of the k axes of the covariance is a change of the p parameters by one standard deviation; parameters of
    infinite variance do not change.
    """
    is_finite = np.isfinite(np.diag(covariance_matrix))
    scale = np.sqrt(np.diag(covariance_matrix)[is_finite])
    correlation = covariance_matrix[np.ix_(is_finite, is_finite)] / np.outer(scale, scale)
    # svd replaces eigh, which uses all threads of BLAS above 25 parameters; for this matrix both are equivalent.
    vectors, values, _ = np.linalg.svd(correlation)
    # The sign of an eigenvector is arbitrary: choose the one for which the largest component is positive.
    vectors *= np.sign(vectors[np.abs(vectors).argmax(axis=0), np.arange(len(values))])
    axes = np.zeros((len(values), model.size))
    axes[:, is_finite] = (vectors * np.sqrt(np.maximum(values, 0.0))).T * scale
    # The mean square of a tilt over the pupil is a quarter of its squared amplitude at the edge.
    tilts = 0.25 * (model.per_image(axes)[:, : len(model.tilts)] ** 2).sum(axis=(0, 1))
    return float(np.sqrt((model.rms(axes) ** 2).sum() + tilts.max())), axes


def error_factors(model: StarImages, x: Array, covariance_matrix: Array, axes: Array) -> Array:
    """Return factors (common parameters,) by which standard errors change near the estimate `x`, (1, p)."""
    # exp(rms of ln(factor)) over two opposite points, each one standard deviation away along every principal axis.
    factors = np.ones(model.common_count)
    is_finite = np.isfinite(np.diag(covariance_matrix)[: model.common_count])
    if is_finite.any():
        points = [model.within(x + step, x) for step in (axes.sum(axis=0), -axes.sum(axis=0))]
        # A stack of pupils has one f-number, wavelength and obscuration.
        stacks = points if model.unknowns.pupil else [np.concatenate(points)]
        matrices = [matrix for stack in stacks for matrix in model.scores(stack, fast=True).information]
        variances = np.array([np.diag(covariance(matrix))[: model.common_count][is_finite] for matrix in matrices])
        # The factor 0.5 converts variances to standard errors.
        ratios = 0.5 * np.log(variances / np.diag(covariance_matrix)[: model.common_count][is_finite])
        factors[is_finite] = np.exp(np.sqrt((ratios**2).mean(axis=0)))
    return factors
