"""Estimate aberrations and constants of a microscope from z stacks of beads, with standard errors and checks."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, Protocol, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike

from lommel import show
from lommel.base import validation
from lommel.base.arrays import Array, fields_of, plain
from lommel.base.options import listed
from lommel.base.quantities import EVEN
from lommel.base.units import format_length, percent, with_error
from lommel.core.answers import Declined
from lommel.estimation import Effort, bead_checks
from lommel.estimation.bead_images import (
    AMPLITUDES,
    CONSTANTS,
    GRADIENT,
    UNITS,
    BeadImages,
    Part,
    Place,
    Setup,
    Stack,
    expected,
)
from lommel.estimation.bead_pairs import touching
from lommel.estimation.bead_search import (
    GROSS_CHI2,
    MAX_CHI2_RATIO,
    MIN_FLUX_SIGMAS,
    BeadModel,
    Evaluation,
    Prior,
    Search,
    State,
    brightest,
    climb,
    place_bead,
    start_of,
)
from lommel.estimation.favoured_effects import Round
from lommel.estimation.options import BeadOptions
from lommel.estimation.star_images import MAX_LINEAR_ERROR, checked_terms, label, too_dim_findings
from lommel.fit import goodness_of_fit
from lommel.fit.findings import Finding, Findings, FitReport, Severity
from lommel.fit.model_error import MAX_MISSED, larger, noise_findings, part_missed, with_errors_of_model
from lommel.fit.score_tests import ScoreTest, causes_of_misfit
from lommel.fit.scoring import Progress
from lommel.measures.spot import profile_width
from lommel.methods.derivative_names import SHIFTS, Term, term_of
from lommel.optics.layers.emitter import Beam, Dipole, Emitter, Scalar, emitter_of
from lommel.optics.layers.objective import Objective, aberration, layers_of, media_strehl
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.layers.stratified import DEPTH_MOST, Layers, length
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.recorded.counts import Counts, counts_of, recording_findings
from lommel.recorded.headers import microscope_facts, microscope_findings, told_early
from lommel.recorded.noise import Noise
from lommel.special import zernike

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_PLANES = 5  # minimum number of planes in a stack, and number of planes in a plot
_MAX_IMAGE_ERROR = 2e-3  # largest error of the images in the search, relative to the peak
_DIFFER = "aberrations differ between the beads"
_CAUSES = "pixel, noise, z or the objective are wrong, terms are missing, or beads overlap"
_NOT_OF_POINTS = "diameter", "blur", "step", "jump"  # constants that do not affect the image of a point at exact z
_FWHM_SIDE = 33  # side of the images of a point whose widths are measured, quarters of the Nyquist sampling
_FOCUS_STEPS = 4  # steps from the brightest sample to the maximum of a point through focus
_FIRST_NOLL = 5  # Noll's index of the first term after defocus
# Starts differ in focus: the search ends at the first that leads to a good fit.
EFFORT = Effort(starts=5)


@dataclass(frozen=True, eq=False)
class FittedBead:
    """Estimates for one bead.

    Attributes
    ----------
    row, column : float
        Position of the bead in the window, pixels, like `center` of :func:`lommel.psf`.
    z : float
        Position of the stage, metres, at which the bead would be in the brightest focus without aberrations.
    depth : float
        Depth of the bead's centre below the cover glass, metres.
    errors : dict of str to float
        Standard errors of "row", "column", "z", the means of "flux" and "background" over planes and, if estimated,
        of "depth" (NaN if its prior tells it better than the data do), "drift_row", "drift_column" (pixels from the
        middle to the end of the stack), "gradient_row", "gradient_column".
    drift : (float, float)
        Displacement in rows and in columns from the middle to the end of the stack, pixels.
    gradient : (float, float)
        Change of the background from edge to edge of the window along rows and along columns, electrons; 0 unless it
        is significant.
    flux, background : ndarray, shape (planes,)
        Electrons of the bead, and background in electrons per pixel, in each plane.
    flux_errors, background_errors : ndarray, shape (planes,)
        Standard errors of `flux` and `background`; NaN for a bead that was not used.
    moved : dict of int to (float, float)
        Index and displacement (rows, columns; pixels) of each plane that is displaced relative to the other planes:
        its score test exceeds five standard deviations, and four times the median over the planes.
    chi2 : float
        Pearson's chi2 per degree of freedom.
    used : bool
        Whether the bead was part of the joint fit; a bead that is inconsistent with the others is left out.
    images, model, residual : ndarray, shape (planes, height, width)
        Images, NaN at pixels left out; the fitted model, in the unit of the images; the residual, in standard
        deviations of the noise.
    """

    row: float
    column: float
    z: float
    depth: float
    errors: dict[str, float]
    drift: tuple[float, float]
    gradient: tuple[float, float]
    flux: Array = field(repr=False)
    background: Array = field(repr=False)
    flux_errors: Array = field(repr=False)
    background_errors: Array = field(repr=False)
    moved: dict[int, tuple[float, float]]
    chi2: float
    used: bool
    images: Array = field(repr=False)
    model: Array = field(repr=False)
    residual: Array = field(repr=False)

    def to_dict(self) -> dict[str, Any]:
        """Return all attributes except images as plain data.

        Returns
        -------
        dict
        """
        light_names = ("flux", "background", "flux_errors", "background_errors")
        data: dict[str, Any] = plain(fields_of(self) | {name: getattr(self, name) for name in light_names})
        return data


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class BeadFit(FitReport):
    """Aberrations and constants of a microscope: the result of :func:`lommel.fit_beads`.

    Attributes
    ----------
    aberrations : Wavefront
        Estimated and fixed terms, as `aberrations` of :meth:`lommel.Objective.pupil`.
    objective : Objective
        The objective, with the estimated constants.
    wavelength, pixel, diameter : float
        Wavelength, estimated pixel pitch of the camera and estimated diameter of the beads, metres.
    emitter : Dipole, Beam or Scalar
    coefficients : dict
        Parameters common to all beads: Zernike terms (n, m) in radians rms, and constants by name; "jump" is the
        displacement (metres) of planes that the finding "estimated" names.
    errors : dict
        Standard errors of `coefficients`, with the same keys; NaN for constants that their priors tell better than
        the data do, which are no measurements (the finding "untested" lists them).
    covariance : ndarray, shape (k, k)
        Covariance of `coefficients`, in the same order.
    beads : tuple of FittedBead
    z_covariance : ndarray, shape (beads, beads)
        Covariance C of the positions z of beads, metres squared; NaN for beads that were not used. The standard error
        of a difference in height of two beads is ``sqrt(C[i, i] + C[j, j] - 2 C[i, j])``: errors of the constants and
        of the wavefront, which are common to all beads, cancel.
    row_covariance, column_covariance : ndarray, shape (beads, beads)
        The same of rows and of columns, pixels squared.
    tests : tuple of lommel.fit.ScoreTest
        Score tests of effects that the model may lack, the most likely first: Zernike terms of the next two radial
        orders, all constants, drift, gradients of the background, a nonlinear gain, a second bead.
    chi2 : float
        Pearson's chi2 per degree of freedom.
    held_out : float
        Chi2 of one bead with the aberrations and constants of a fit of the other beads; only its position, flux and
        background are fitted. It is near 1 if the estimates hold for other beads; NaN for fewer than three beads.
    findings : lommel.fit.Findings
        Findings of the checks. Errors: "misfit", "excess_noise", "gain", "no_light", "not_settled", "reversed_z".
        Doubts: "other_explanation" (the data favour an effect in `tests`), "too_dim", "held_out", "moved",
        "model_error", "too_quiet",
        "missed_light" (a misfit that no effect explains: errors are those of the jackknife over planes). Notes:
        "untested", "estimated" (effects that the data favour, and that are estimated besides what was asked for),
        single displaced planes, beads and pixels left out.
    summary : str
        Chi2, and the number of steps.
    converged, reliable, status, message
        The verdict that follows from `findings`; see :class:`lommel.fit.FitReport`.
    model_error : float
        Largest difference between images of the search and images with a proven error bound, at the estimate,
        relative to the peak; inf if the aberrations are too strong for images with a proven error bound.
    steps : int
        Number of steps of the search.
    """

    aberrations: Wavefront = field(repr=False)
    objective: Objective = field(repr=False)
    wavelength: float
    pixel: float
    diameter: float
    emitter: Dipole | Beam | Scalar = field(repr=False)
    coefficients: dict[Any, float]
    errors: dict[Any, float]
    covariance: Array
    beads: tuple[FittedBead, ...]
    z_covariance: Array
    row_covariance: Array
    column_covariance: Array
    tests: tuple[ScoreTest, ...]
    chi2: float
    held_out: float
    model_error: float
    steps: int
    _state: State = field(repr=False)
    _images: BeadImages = field(repr=False)
    _measures: dict[float, tuple[Array, Array, tuple[float, float]]] = field(default_factory=dict, init=False)

    def pupil(self, *, depth: ArrayLike, z: ArrayLike = 0.0) -> ObjectivePupil:
        """Return the fitted pupil for :func:`lommel.psf`, with an emitter at a depth and the stage at z (metres).

        Parameters
        ----------
        depth, z : array_like
            Depth of the emitter, and position of the stage from the brightest focus; see
            :meth:`lommel.Objective.pupil`.

        Returns
        -------
        ObjectivePupil

        Raises
        ------
        ValueError
            If a position is out of range.
        """
        return self._state.setup.pupil(self.aberrations, depth, z)

    def psf_errors(self, *, depth: float, z: ArrayLike = 0.0, shape: int | tuple[int, int] = 31) -> Array:
        """Return the standard error of the PSF at any depth, from the covariance of the fit.

        Parameters
        ----------
        depth : float
            Depth of the emitter below the cover glass, metres.
        z : array_like, shape (planes,)
            Positions of the stage from the brightest focus, metres.
        shape : int or (int, int), default 31
            Rows and columns of the window, in pixels of the estimated pitch.

        Returns
        -------
        ndarray, shape (planes, height, width)
            Standard errors of the values of ``lommel.psf(fit.pupil(depth=depth, z=z), shape, fit.pixel)``, which are
            fractions of the total light.

        Raises
        ------
        TypeError, ValueError
            If an argument is out of range.

        Notes
        -----
        The result is the square root of ``diag(J C J^T)``, where C is the covariance and J the Jacobian of the PSF.
        Derivatives with respect to Zernike terms are analytic. Derivatives with respect to constants are central
        differences at fixed z. The origin of z is the brightest focus, which depends on the constants.
        """
        height, width = validation.image_shape(shape)
        bead_depth = length("depth", depth, DEPTH_MOST)
        positions = np.atleast_1d(validation.real_array("z", z, unit="metres"))
        if positions.ndim != 1 or not positions.size:
            raise ValueError(f"z must be a number or have the shape (planes,), got {positions.shape}")
        setup = replace(self._state.setup, diameter=0.0, blur=0.0, step=1.0)
        self.pupil(depth=bead_depth, z=positions)  # checks the range
        rows = self._jacobian(setup, _focused(setup, bead_depth), _point_stack(positions, (height, width)))
        # First-order error propagation: the diagonal of J C J^T.
        variance = np.einsum("ipyx,ij,jpyx->pyx", rows, self.covariance, rows)
        return np.asarray(np.sqrt(np.maximum(variance, 0.0)))

    def fwhm(self, *, depth: float) -> tuple[Array, Array]:
        """Return the full widths at half maximum of the PSF at a depth, and their standard errors.

        Parameters
        ----------
        depth : float
            Depth of the emitter below the cover glass, metres.

        Returns
        -------
        widths : ndarray, shape (3,)
            Widths along x and y (metres in the sample) and along z (metres of stage travel), on lines through the
            brightest point; without bead and pixel.
        errors : ndarray, shape (3,)
            Standard errors of the widths, from the covariance of the fit.

        Raises
        ------
        TypeError, ValueError
            If `depth` is out of range, or if the light does not fall to half of its maximum on both sides.
        """
        widths, errors, _ = self._focal_measures(depth)
        if not np.isfinite(widths).all():
            raise ValueError(
                "the light does not fall to half of its maximum on both sides: aberrations are too strong"
            )
        return widths, errors

    def strehl(self, *, depth: float) -> tuple[float, float]:
        """Return the Strehl ratio of the whole fitted wavefront at a depth, and its standard error.

        Parameters
        ----------
        depth : float
            Depth of the emitter below the cover glass, metres.

        Returns
        -------
        ratio : float
            Largest value of the PSF through focus, divided by that of the same pupil with a flat phase: terms, depth,
            and cover glass, immersion and sample unlike the design of the objective all reduce it.
        error : float
            Standard error, from the covariance of the fit.

        Raises
        ------
        TypeError, ValueError
            If `depth` is out of range.
        """
        return self._focal_measures(depth)[2]

    def rms(self, *, depth: float) -> tuple[float, float]:
        """Return the rms of the whole fitted wavefront at a depth in the best focus, and its standard error.

        Parameters
        ----------
        depth : float
            Depth of the emitter below the cover glass, metres.

        Returns
        -------
        rms : float
            Of what :meth:`strehl` counts, radians, less tilts and what a travel of the stage removes.
        error : float
            Standard error, from the covariance of the fit.

        Raises
        ------
        TypeError, ValueError
            If `depth` is out of range.
        """
        depth, setup = length("depth", depth, DEPTH_MOST), self._state.setup
        edge = self._images.edge(self._state.waves)
        terms = {(n, m): value / zernike.rms_factor(n, m) for (n, m), value in edge.items()}
        layers = layers_of(setup.objective, setup.wavelength)
        whole = aberration(layers, depth, terms)
        unit = whole / max(float(np.linalg.norm(whole)), 1e-12)
        slopes = [
            float(unit @ (aberration(layers, depth, terms | {term: terms[term] + 1.0}) - whole))
            for term in self._images.estimated_terms
        ]
        slopes += self._media_slopes(lambda layers: float(unit @ aberration(layers, depth, terms)))
        rms, slope = float(unit @ whole), np.array(slopes)
        bias = rms - math.sqrt(max(rms**2 - self.wavefront_variance, 0.0))
        return rms, math.hypot(math.sqrt(max(float(slope @ self.covariance @ slope), 0.0)), bias)

    @property
    def wavefront_variance(self) -> float:
        """What noise alone adds to the square of :meth:`rms`, and takes from :meth:`strehl`, radians squared.

        It is the variance of the terms for given constants, and part of the errors of both.
        """
        count, covariance = len(self._images.estimated_terms), self.covariance
        explained = covariance[:count, count:] @ _inverse(covariance[count:, count:]) @ covariance[count:, :count]
        return max(float(np.trace(covariance[:count, :count] - explained)), 0.0)

    def _media_slopes(self, of: Callable[[Layers], float]) -> list[float]:
        """Return the derivatives of a function of the layers by the constants, 0 for those that are not theirs."""
        setup, slopes = self._state.setup, list[float]()
        for name in [*self.coefficients][len(self._images.estimated_terms) :]:
            pair = setup.adjacent_values(name)
            ends = [setup.with_constant(name, value) for value in pair]
            lower, upper = (of(layers_of(one.objective, one.wavelength)) for one in ends)
            slopes.append((upper - lower) / (pair[1] - pair[0]))
        return slopes

    def _focal_measures(self, depth: float) -> tuple[Array, Array, tuple[float, float]]:
        """Return widths (NaN: none), their errors, and the Strehl ratio with its error, of one focal stack."""
        depth = length("depth", depth, DEPTH_MOST)
        if depth in self._measures:
            return self._measures[depth]
        images, count = self._images, len(self._images.estimated_terms)
        setup, place, stack, values = self._focus(depth, images, self._state.waves)
        rows = self._jacobian(setup, place, stack, unaffected=("pixel", *_NOT_OF_POINTS))
        top = _middle(values)
        # Central differences over a fifth of a standard error: widths are no linear function, and the brightest
        # point moves with the parameters.
        sigmas = 0.1 * np.sqrt(np.diag(self.covariance))
        gains = np.array(
            [_widths(values + s * change, top) - _widths(values - s * change, top)
             for s, change in zip(sigmas, rows, strict=True)]
        ).reshape(-1, 3)  # fmt: skip
        slopes = gains / (2.0 * sigmas[:, None])
        errors = np.sqrt(np.einsum("ik,ij,jk->k", slopes, self.covariance, slopes))
        units = np.array([float(stack.z[1] - stack.z[0]), *2 * (setup.pixel / self.objective.magnification,)])
        # Errors of constants change both maxima: that of a cover glass, which terms compensate, cancels in the upper.
        flat = BeadImages((), {}, images.threads), np.zeros(0)
        _, flat_place, flat_stack, flat_values = self._focus(depth, *flat)
        peak, point = float(flat_values.max()), _point_stack(flat_stack.z[[len(flat_stack.z) // 2]], (1, 1))
        slope, ratio = rows[(slice(None), *top)] / peak, float(values.max()) / peak
        of_media = media_strehl(layers_of(setup.objective, setup.wavelength), depth)
        if len(self.coefficients) > count:
            of_flat = self._jacobian(setup, flat_place, point, ("pixel", *_NOT_OF_POINTS), *flat)
            slope[count:] -= ratio / peak * of_flat[:, 0, 0, 0]
            slope[count:] += ratio / of_media * np.array(self._media_slopes(lambda one: media_strehl(one, depth)))
        slope *= of_media
        error = math.sqrt(max(float(slope @ self.covariance @ slope), 0.0))
        strehl = ratio * of_media, math.hypot(error, self.wavefront_variance)
        self._measures[depth] = (_widths(values, top) * units)[::-1], (errors * units)[::-1], strehl
        return self._measures[depth]

    def _focus(self, depth: float, images: BeadImages, waves: Array) -> tuple[Setup, Place, Stack, Array]:
        """Return setup, place, stack and values of a point through focus, whose maximum is in the middle."""
        objective = self.objective
        pixel = 0.25 * objective.nyquist(wavelength=self.wavelength).pixel
        setup = replace(self._state.setup, pixel=pixel, diameter=0.0, blur=0.0, step=1.0, integrate=False)
        # Aberrations move the focus: eight axial widths, in steps of a tenth.
        step = 0.1 * float(objective.focus(depth, wavelength=self.wavelength).axial_fwhm)
        z, place, around = step * np.arange(-40.0, 41.0), _focused(setup, depth), step * np.arange(-1.0, 2.0)
        values = images.values(setup, waves, place, _point_stack(z, (_FWHM_SIDE, _FWHM_SIDE)))
        plane, row, column = np.unravel_index(int(values.argmax()), values.shape)
        half = _FWHM_SIDE // 2
        place, top = place._replace(row=half - float(row), column=half - float(column)), float(z[plane])
        # The point is moved until its maximum is at a sample: with coma and astigmatism, widths change near it.
        for _ in range(_FOCUS_STEPS):
            change = _to_maximum(images.values(setup, waves, place, _point_stack(top + around, (3, 3))), (1, 1, 1))
            place = place._replace(row=place.row - change[1], column=place.column - change[2])
            top += step * change[0]
        stack = _point_stack(z + top, (_FWHM_SIDE, _FWHM_SIDE))
        return setup, place, stack, images.values(setup, waves, place, stack)

    def _jacobian(
        self, setup: Setup, place: Place, stack: Stack, unaffected: Sequence[str] = _NOT_OF_POINTS,
        images: BeadImages | None = None, waves: Array | None = None,
    ) -> Array:  # fmt: skip
        """Return derivatives of the PSF by all coefficients, 0 for constants `unaffected`, (k, planes, ...)."""
        images, waves = images or self._images, self._state.waves if waves is None else waves
        jacobian = [*images.derivatives(setup, waves, place, stack)[: len(images.estimated_terms)]]
        for name in [*self.coefficients][len(self._images.estimated_terms) :]:
            if name in unaffected:
                jacobian.append(np.zeros((len(stack.z), *stack.shape)))
            else:
                values = setup.adjacent_values(name)
                setups = (setup.with_constant(name, value) for value in values)
                lower, upper = (
                    images.values(one, waves, place._replace(focus=brightest(one, place.depth)), stack)
                    for one in setups
                )
                jacobian.append((upper - lower) / (values[1] - values[0]))
        return np.asarray(jacobian, dtype=np.float64)

    def plot(self, *, bead: int = 0, unit: str = "waves") -> Figure:
        """Return a matplotlib figure of planes of a bead, model, residual, and coefficients with standard errors.

        Parameters
        ----------
        bead : int, default 0
            Index of the bead.
        unit : {"waves", "radians"}
            Unit of the coefficients (rms).

        Returns
        -------
        matplotlib Figure

        Raises
        ------
        ValueError
            If `bead` or `unit` is out of range.
        ImportError
            If matplotlib is not installed.
        """
        fitted_bead = self.beads[validation.integer("bead", bead, least=0, most=len(self.beads) - 1)]
        factor = 1.0 / (2.0 * math.pi) if validation.choice("unit", unit, ("waves", "radians")) == "waves" else 1.0
        planes = np.unique(np.linspace(0, len(fitted_bead.images) - 1, _PLANES).round().astype(int))
        names = [name for name in self.coefficients if not isinstance(name, str)]
        values, errors = ([factor * numbers[name] for name in names] for numbers in (self.coefficients, self.errors))
        bars = [label(name) for name in names], values, errors, unit
        titles = [f"plane {k}" for k in planes]
        stacks = fitted_bead.images, fitted_bead.model, fitted_bead.residual
        images, model, residual = (stack[planes] for stack in stacks)
        return show.estimates.fit(images, model, residual, bars, f"{self.status}, chi2 = {self.chi2:.3g}", titles)

    def __repr__(self) -> str:
        lines = []
        for name, value in self.coefficients.items():
            is_constant = isinstance(name, str)
            factor, unit = UNITS[CONSTANTS[name].unit if is_constant else "rad"]
            error = factor * self.errors[name]
            text = f"{factor * value:.4g}{unit} (by its prior)"
            if math.isfinite(error):
                text = f"{' +- '.join(with_error(factor * value, error))}{unit}"
            lines.append(f"{name if is_constant else label(name)}: {text}")
        return self._shown(lines)


def _point_stack(z: Array, shape: tuple[int, int]) -> Stack:
    """Return a stack without data, of images with the stage at z from the brightest focus."""
    return Stack(np.ones((4, z.size, math.prod(shape))), shape, z)


def _middle(values: Array) -> tuple[int, int, int]:
    """Return the index of the middle of a stack."""
    planes, height, width = values.shape
    return planes // 2, height // 2, width // 2


def _to_maximum(values: Array, top: tuple[int, int, int]) -> Array:
    """Return the displacement (3,), in steps, from the sample `top` to the maximum, by a quadratic function."""
    cube = values[tuple(slice(index - 1, index + 2) for index in top)]
    slope, hessian = np.zeros(3), np.zeros((3, 3))
    for a in range(3):
        low, middle, high = np.moveaxis(cube, a, 0)
        slope[a], hessian[a, a] = 0.5 * (high - low)[1, 1], (high - 2.0 * middle + low)[1, 1]
        for b in range(a):
            (at_low, _, at_high), rest = np.moveaxis(0.5 * (high - low), b, 0), 1
            hessian[a, b] = hessian[b, a] = 0.5 * (at_high - at_low)[rest]
    # Without a maximum near the sample, the step is along the slope.
    values_of, vectors = np.linalg.eigh(hessian)
    least = -1e-3 * max(float(np.abs(values_of).max()), 1e-300)
    return np.asarray(np.clip(-vectors @ ((vectors.T @ slope) / np.minimum(values_of, least)), -1.0, 1.0))


def _widths(values: Array, top: tuple[int, int, int]) -> Array:
    """Return the widths at half maximum along planes, rows and columns through the maximum near `top`; NaN: none."""
    found, change = np.full(3, math.nan), _to_maximum(values, top)
    for axis in range(3):
        profile = values
        for other in (2, 1, 0):
            if other != axis:
                t, near = float(change[other]), top[other] + np.arange(-1, 2)
                weights = np.array([0.5 * t * (t - 1.0), 1.0 - t * t, 0.5 * t * (t + 1.0)])
                profile = np.tensordot(weights, np.take(profile, near, axis=other), (0, other))
        with suppress(ValueError):
            found[axis] = profile_width(profile)
    return found


def _focused(setup: Setup, depth: float) -> Place:
    """Return the place of an emitter in brightest focus, in the middle of the window."""
    return Place(0.0, 0.0, brightest(setup, depth), depth)


@runtime_checkable
class Microscope(Protocol):
    """The attributes of :class:`lommel.Microscope` that a fit uses."""

    @property
    def objective(self) -> Objective:
        """Objective with its nominal constants."""

    @property
    def wavelength(self) -> float:
        """Emission wavelength in vacuum, metres."""

    @property
    def pixel(self) -> float:
        """Pixel pitch of the camera, metres."""

    @property
    def emitter(self) -> Emitter:
        """Emission of the dye."""

    @property
    def aberrations(self) -> Wavefront | None:
        """Initial wavefront."""

    @property
    def integrate(self) -> bool | None:
        """False for point-sampled images."""


@listed(BeadOptions)
def fit_beads(
    stacks: ArrayLike | Counts | Sequence[ArrayLike],
    microscope: Microscope,
    *,
    z: ArrayLike,
    noise: Noise | None = None,
    options: BeadOptions | None = None,
    **given: Any,
) -> BeadFit:
    """Estimate the aberrations and constants of a microscope from stacks of fluorescent beads.

    The wavefront and the constants are common to all beads. They are estimated jointly with the position of each
    bead, and with flux and background in each plane. Other values of fixed constants, and neglected effects, are
    tested: `findings` reports the effects that the data favour.

    Parameters
    ----------
    stacks : array_like or Counts, shape (planes, height, width), or a sequence of stacks
        Recorded z stacks, each a window around one bead; linear in the light, with the gain and offset of `noise`.
        NaN, infinite and masked values are left out, and so are saturated pixels of integer images.
        :class:`lommel.Counts` state a mask and a saturation.
    microscope : Microscope
        Objective with its nominal constants, emission wavelength, pixel pitch of the camera, and emission of the dye.
        Its `aberrations` are the initial wavefront of the search; terms that are not estimated are fixed. Images are
        pixel-integrated unless its `integrate` is False.
    z : array_like, shape (planes,)
        Stage position in each plane, metres, positive as objective and sample approach; increasing or decreasing.
    noise : Noise, optional
        Gain, offset and read noise of arrays; :class:`lommel.Counts` have their own.
    options : BeadOptions, optional
        Options in one object; keywords change single ones.
    {options}

    Returns
    -------
    BeadFit

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, a stack has fewer than 5 planes or is constant, or stacks cannot determine a
        parameter (Noll's term 4; immersion and cover glass together without a prior).

    Notes
    -----
    Fisher scoring maximizes the likelihood of Poisson counts with read noise (Snyder et al. 1993,
    doi:10.1364/JOSAA.10.001014) with priors. A bead is modelled by discs at two or more heights. Images of the search
    use quadrature rules of fixed size; `model_error` compares them with images of proven error bound at the estimate.

    Score tests (Rao) estimate the size of each neglected effect by one step of Fisher scoring, with all estimated
    parameters eliminated; the effects are ranked by Bayes factor. If an effect is significant, a new fit estimates
    it. In at most two rounds, this fit becomes the result (finding "estimated"), if it is good, and if constants are
    plausible: within six times their expected errors. Effects that are favoured but not significant (Bayes factors
    above 1) are allowed for in `coefficients`, `errors` and `aberrations` with the weight of their posterior odds.
    The finding "untested" lists fixed constants that the beads do not determine, if an error of the constant would
    change a term by more than a standard error, and constants determined more by the prior than by the beads.
    Two other doubts are "pattern" (stripes, or offsets of rows or columns, that noise alone causes in fewer than one
    of 1000 fits) and "too_dim" (a standard error of the wavefront above 0.22 radians rms).

    Bright beads show errors of any model. If no effect explains a misfit of a fit that misses less than 30 % of the
    light, `errors` are increased to those of the delete-one jackknife over planes: the scatter of fits without one
    plane of each stack, in one step of Fisher scoring each. The misfit is then the doubt "missed_light". Errors that
    are the same in all planes are not included.

    Examples
    --------
    >>> import lommel as lm
    >>> import numpy as np
    >>> oil = lm.Objective(NA=1.3, magnification=63, immersion=1.518, sample=1.33)
    >>> z = np.linspace(-0.8e-6, 0.8e-6, 9)
    >>> wave = lm.Wavefront.zernike({5: 0.4, 7: -0.3}, order="noll")
    >>> truth = oil.pupil(depth=50e-9, z=z, wavelength=600e-9, aberrations=wave)
    >>> camera = lm.Noise(read=1.6)
    >>> bead = camera.record(2e4 * lm.microscopy.bead(truth, 100e-9, 17, 6.5e-6).values + 10, seed=1)
    >>> microscope = lm.Microscope(oil, wavelength=600e-9, pixel=6.5e-6)
    >>> fit = lm.fit_beads(bead, microscope, z=z, noise=camera, diameter=100e-9, terms=5, priors={})
    >>> fit.converged, abs(fit.coefficients[2, -2] - 0.4) < 0.02
    (True, True)
    """
    return fit_stacks(stacks, microscope, z=z, noise=noise, options=BeadOptions.of("fit_beads", options, given))


def fit_stacks(
    stacks: Any, microscope: Microscope, *, z: ArrayLike, noise: Noise | None, options: BeadOptions,
    effort: Effort = EFFORT,
) -> BeadFit:  # fmt: skip
    """Return aberrations and constants of a microscope from stacks of beads, see :func:`lommel.fit_beads`."""
    validation.instance("microscope", microscope, Microscope)
    objective, aberrations = microscope.objective, microscope.aberrations
    terms = _terms(options.terms)
    shape = "(planes, height, width) or (beads, planes, height, width)"
    counts = counts_of("stacks", stacks, noise, sides=(3, 4), shape=shape)
    noise = counts.known_noise()
    counts.require_known("stacks").require_light("stacks", "a bead")
    recorded = [counts[k] for k in range(len(counts.values))] if counts.values.ndim == 4 else [counts]
    depth_values = _depths(options.depth, 0.5 * options.diameter, len(recorded))
    stage_positions, planes = np.atleast_1d(validation.real_array("z", z, unit="metres")), len(recorded[0].values)
    if planes < _PLANES:
        raise ValueError(
            f"stacks must have at least {_PLANES} planes above and below focus, got {planes}: fewer planes do not "
            "separate aberrations from the position of the bead; pass all planes as one stack"
        )
    if stage_positions.shape != (planes,):
        raise ValueError(f"z must have a position for each of {planes} planes, got shape {stage_positions.shape}")
    spacing = np.diff(stage_positions)
    if not (np.all(spacing > 0.0) or np.all(spacing < 0.0)):
        raise ValueError("z must increase from plane to plane, or decrease: order planes by the stage")
    if np.abs(spacing).max() > 1e-4:
        raise ValueError(f"z must be in metres, got planes {np.abs(spacing).max():g} m apart")
    pitch = validation.real("pixel", microscope.pixel, above=0.0, unit="metres")
    step = float(spacing.mean()) if np.ptp(spacing) < EVEN * abs(spacing.mean()) else None
    facts = microscope_facts(objective, microscope.wavelength)
    findings, remarks = microscope_findings(counts.metadata, pitch, step, **facts)
    told_early(findings)
    for remark in remarks:
        validation.tell(remark)
    wavelength, emitter = validation.wavelength(microscope.wavelength), emitter_of(microscope.emitter)
    integrate = microscope.integrate is not False
    setup = Setup(objective, wavelength, emitter, pitch, options.diameter, integrate=integrate)
    setup, priors, depth_error, notes = _priors(options.priors, setup, depth_values)
    notes = findings + notes
    amplitudes = (name for name in list(AMPLITUDES)[: options.apodization] if name not in priors)
    priors |= {name: Prior(setup.value(name), math.inf) for name in amplitudes}
    start = {term: float(c) for term, c in (aberrations or Wavefront()).edge_terms().items()}
    if start.get((2, 0)):
        notes.append(Finding("stated", "note", "defocus (Noll 4) of aberrations is fixed: z of the beads adds to it"))
    images = BeadImages(terms, start, effort.threads or 0)
    waves = np.array([start.get(term, 0.0) for term in terms]) / images.factors
    bead_stacks = tuple(Stack.of(counts_of_bead, noise, stage_positions) for counts_of_bead in recorded)
    depths = tuple(Prior(d, depth_error) for d in depth_values)
    model = BeadModel(images, bead_stacks, priors, depths, options.drift)
    if model.degrees_of_freedom < 1:
        raise ValueError(f"stacks must have more pixels than there are unknowns, {model.size}")
    pairs = _pairs(model, setup, waves)
    single = np.array([k for k in range(len(recorded)) if k not in pairs])
    count = len(single)
    chosen = single[np.unique(np.linspace(0.0, count - 1.0, min(count, options.joint)).round().astype(int))].tolist()
    search = Search(model.with_beads(chosen), setup, waves, effort.starts, effort.steps, Progress(options.progress))
    return _build_bead_fit(search, model, chosen, recorded, noise, notes, pairs)


def _pairs(model: BeadModel, setup: Setup, waves: Array) -> dict[int, str]:
    """Return the indices of the stacks that show two beads that touch, and their distances in words.

    ValueError if all stacks do: a fit would be long, and a misfit.
    """
    found = dict[int, str]()
    for k, (stack, depth) in enumerate(zip(model.stacks, model.depths, strict=True)):
        place = start_of(stack, setup, depth.value, 0.0)._replace(row=0.0, column=0.0)
        try:
            pair = touching(stack, model.images.values(setup, waves, place, stack), setup)
        except (Declined, ValueError):
            continue
        if pair is not None:
            found[k] = (
                f"{format_length(pair.distance, digits=2)} apart, light {percent(pair.share)} of the brighter one"
            )
    if len(found) == len(model.stacks):
        raise ValueError(
            f"stacks must show single beads, and all {len(found)} show two that touch (the first: {found[0]}): "
            "choose isolated beads, or dilute them"
        )
    return found


def _terms(terms: int | Sequence[tuple[int, int] | str]) -> tuple[Term, ...]:
    term_list = tuple(filter(None, map(term_of, checked_terms(terms, _FIRST_NOLL))))
    if len({*term_list}) < len(term_list):
        raise ValueError(f"terms must not contain a term twice, got {validation.shown(terms)}")
    if position_terms := [term for term in ((2, 0), *SHIFTS.values()) if term in term_list]:
        raise ValueError(
            f"terms must be without {label(position_terms[0])}, which is equivalent to a shift of the bead: z, row "
            "and column are estimated instead"
        )
    return term_list


def _depths(depth: Any, radius: float, count: int) -> list[float]:
    stated_depths = validation.real_array("depth", radius if depth is None else depth, unit="metres")
    if stated_depths.shape not in ((), (count,)):
        raise ValueError(f"depth must be a number, or one for each of {count} beads, got shape {stated_depths.shape}")
    depths = [length("depth", float(value), DEPTH_MOST) for value in np.broadcast_to(stated_depths, (count,))]
    if (smallest := min(depths)) < radius * (1.0 - 1e-9):
        raise ValueError(
            f"depth must be the depth of a bead's centre, at least the radius {radius:g} m, got {smallest:g}"
        )
    return depths


def _priors(
    mapping: Any, setup: Setup, depths: Sequence[float]
) -> tuple[Setup, dict[str, Prior], float, list[Finding]]:
    """Return the setup with the values of the priors, the priors, the standard error of depths, and findings."""
    available, notes = bead_checks.available_constants(setup), list[Finding]()
    na_undetermined = min(depths) > setup.wavelength and setup.objective.sample < setup.objective.NA
    if mapping is None:
        mapping = {name: CONSTANTS[name].prior * setup.scale(name) for name in available if CONSTANTS[name].prior}
        if na_undetermined:
            mapping.pop("NA")
    if not isinstance(mapping, Mapping):
        raise TypeError(f"priors must map names to standard errors, got {validation.shown(mapping)}")
    priors, depth_error = {}, 0.0
    for name, prior in mapping.items():
        validation.choice("priors", name, CONSTANTS)
        if name not in available:
            raise ValueError(f"priors must be without {name!r}: no such constant exists, or the medium is air")
        pair = prior if isinstance(prior, tuple | list) else (None, prior)
        if len(pair) != 2:
            raise ValueError(f"priors[{name!r}] must be a standard error or (value, standard error), got {prior!r}")
        value, error = pair[0], validation.real(f"the error of priors[{name!r}]", pair[1], above=0.0, infinite=True)
        if name != "depth":
            value = setup.value(name) if value is None else validation.real(f"priors[{name!r}]", value)
            priors[name], setup = Prior(value, error), setup.with_constant(name, value)
        elif value is None:
            depth_error = error
        else:
            raise ValueError("priors['depth'] must be a standard error alone: the values are the argument depth")
    if all(name in priors and math.isinf(priors[name].error) for name in ("immersion", "coverslip")):
        raise ValueError(
            "priors must have a finite error for immersion or coverslip, because images depend only on a combination "
            "of both: give a standard error such as 5e-6 metres for the cover glass"
        )
    if "NA" in priors and na_undetermined:
        if math.isinf(priors["NA"].error):
            raise ValueError(
                "priors must have a finite error for NA if all beads are deeper than a wavelength: their light does "
                "not reach an NA above the index of the sample; add a bead on the glass, or leave NA out"
            )
        notes = [Finding("stated", "note", "the prior determines NA: no bead is within a wavelength of the glass")]
    return setup, priors, depth_error, notes


def _build_bead_fit(
    search: Search, whole: BeadModel, chosen: list[int], recorded: list[Counts], noise: Noise, notes: list[Finding],
    pairs: Mapping[int, str],
) -> BeadFit:  # fmt: skip
    """Return the result of a search for the beads `chosen` of the `whole` model, with the findings of its checks."""
    has_light = not search.is_dark()
    if not has_light:  # no steps: there is nothing to fit
        search = replace(search, starts=1, max_steps=0)
    fit, is_consistent = search.fit_all()
    reason = "no bead fits with the constants as stated" if search.few else "`joint`"
    chosen = [chosen[k] for k in search.few] or chosen
    if len(chosen) < (count := len(whole.stacks) - len(pairs)):
        text = f"{reason}: terms and constants are those of {len(chosen)} of {count} beads, which tell them"
        notes.append(Finding("fewer_beads", "note", f"{text}; the others are placed with them"))
    has_light = has_light and max(part.flux_sigmas for part in fit.parts) >= MIN_FLUX_SIGMAS
    model = whole.with_beads([k for k, used in zip(chosen, is_consistent, strict=True) if used])
    rounds = [Round((model, fit), ((), None, []))]
    if has_light:
        rounds = bead_checks.rounds(model, fit, search.setup, search.report)
    (model, fit), (tests, marginal, untested), estimated_names, *_ = rounds[-1]
    missing_findings, gain = bead_checks.missing_findings(rounds[-1], search.setup, search.model)
    notes = [*bead_checks.estimates_of(rounds[0], rounds[-1], search.setup), *notes]
    state = fit.state
    full_covariance, common_count = _inverse(fit.scores.information[0]), len(model.names)
    covariance = full_covariance[:common_count, :common_count]
    chi2, deviation = fit.quality
    held_out, held_out_findings = bead_checks.held_out(model, fit, search.report) if has_light else (math.nan, [])
    all_beads = replace(
        model,
        stacks=tuple(replace(stack, displaced=model.stacks[0].displaced) for stack in whole.stacks),
        depths=tuple(Prior(prior.value, model.depths[0].error) for prior in whole.depths),
    )
    used = dict(zip(chosen, is_consistent, strict=True)) | dict.fromkeys(pairs, False)
    whole_fit, whole_covariance, is_used = _with_other_beads(all_beads, fit, full_covariance, used)
    kept = np.flatnonzero(is_used)
    jacobian = _height_jacobian(all_beads.with_beads(kept.tolist()), whole_fit.state)
    z_covariance, row_covariance, column_covariance = np.full((3, *(len(is_used),) * 2), math.nan)
    z_covariance[np.ix_(kept, kept)] = jacobian @ whole_covariance @ jacobian.T
    for matrix, name in ((row_covariance, "row"), (column_covariance, "column")):
        index = model.bead_parameters.index(name)
        own = [model.columns(k, common_count)[index] for k in range(len(kept))]
        matrix[np.ix_(kept, kept)] = whole_covariance[np.ix_(own, own)]
    image_error = bead_checks.model_error(model, state)
    differ = has_light and bead_checks.beads_differ(tests)
    if not has_light:
        findings = [Finding("no_light", "error", "the light of all planes is within the noise")]
    else:
        causes = _DIFFER if differ else causes_of_misfit(_CAUSES, chi2, deviation, tests)
        findings = goodness_of_fit.chi2_findings(chi2, deviation, causes, freed=bool(estimated_names))
        expected_images = np.stack([expected(*pair) for pair in zip(state.light, fit.values, strict=True)])
        level = [stack.planes for stack in model.level_stacks(state)]
        residual = np.stack(
            [np.where(one[2], one[0] - mean, np.nan) for one, mean in zip(level, expected_images, strict=True)]
        )
        variance = np.stack([one[1] for one in level]) + expected_images
        background = np.stack([light[1] for light in state.light])[..., None, None]
        if {"misfit", "too_quiet"} & {*Findings(findings).codes}:
            read = variance - expected_images
            findings[:0] = noise_findings(residual, expected_images, read, background, noise.excess)
        windows = residual.reshape(-1, *residual.shape[-2:])
        findings += goodness_of_fit.stripe_findings(windows, variance.reshape(windows.shape), noise.excess)
        reversed_findings: list[Finding] = []
        # The check for reversed planes requires another search: it is run only if a test or chi2 indicates an error.
        if estimated_names or (not differ and (missing_findings or not Findings(findings).converged)):
            few_model, few_fit = bead_checks.brightest_beads(model, fit)
            if few_model is not model:  # beads may differ: their own fit, as that of the reversed planes is
                few_fit = climb(few_model, few_fit.state, bead_checks.STEPS, search.report)
            # Of a fit that is grossly wrong, the terms are no start.
            waves = np.pad(search.waves, (0, len(state.waves) - len(search.waves)))
            waves = few_fit.state.waves if chi2 < GROSS_CHI2 else waves
            start = State(search.setup, waves, few_fit.state.places)
            reversed_findings = bead_checks.reversed_findings(
                few_model, start, few_fit.log_posterior + gain, few_fit.quality[0], search.report
            )
        findings += [*(reversed_findings or missing_findings), *untested]
        if marginal is not None and not missing_findings:  # effects that are favoured but not significant
            covariance = marginal.covariance
            # The shift is linear in the parameters: where it is large, it means nothing.
            if np.linalg.norm(marginal.shift[: len(state.waves)]) <= MAX_LINEAR_ERROR:
                state = _add_shift(state, model, marginal.shift)
        parts = residual, variance, expected_images - background
        is_error = {finding.code for finding in findings if finding.severity == "error"}
        # A misfit that no effect explains: errors are the scatter of fits without one plane.
        if is_error == {"misfit"} and causes and fit.settled and part_missed(*parts) < MAX_MISSED:
            findings = with_errors_of_model(findings, *parts, causes)
            covariance = larger(covariance, bead_checks.plane_jackknife(model, fit)[:common_count, :common_count])
        del residual, windows, variance, expected_images, parts, level  # as large as all beads
    beads = _beads(all_beads, whole_fit, whole_covariance, np.diag(z_covariance), is_used, recorded, noise)
    if has_light and "reversed_z" not in Findings(findings).codes:
        planes = sum(len(s.z) for s in all_beads.stacks)
        findings += bead_checks.moved_findings([bead.moved for bead in beads if bead.used], planes)
    if has_light and not fit.settled:
        text = "the steps have not settled: estimate fewer `terms`, or state constants that were measured"
        findings.append(Finding("not_settled", "error", text))
    findings += held_out_findings
    if "contradiction" not in Findings(findings).codes:
        findings += bead_checks.prior_findings(search.model, state, estimated_names)
    contradicted = Findings(findings).get("contradiction")
    # Errors of a misfit, by the jackknife, are not due to little light.
    of_light = full_covariance if "missed_light" in Findings(findings).codes else covariance
    moved = bead_checks.moved_by_model_error(model, fit) if image_error >= _MAX_IMAGE_ERROR else ("", 0.0)
    findings += _error_findings(of_light[: len(state.waves), : len(state.waves)], image_error, moved)
    if pairs:
        text = "; ".join(f"bead {k}, {text}" for k, text in pairs.items())
        findings.append(Finding("left_out", "note", f"two beads that touch: {text}"))
    if left_out := [str(k) for k, kept_in in enumerate(is_used) if not kept_in and k not in pairs]:
        text = f"left out, inconsistent with the other beads: bead {', '.join(left_out)}"
        findings.append(Finding("left_out", "note", text))
    findings += [*notes, *recording_findings(recorded, noise, "bead")]
    summary = f"chi2 {chi2:.4g} per degree of freedom, {search.steps} steps"
    if math.isfinite(held_out):
        summary += f", held-out bead {held_out:.4g}"
    setup, edge = state.setup, model.images.edge(state.waves)
    values = [*map(float, state.waves), *map(setup.value, model.priors)]
    held = {name for one in untested for name, changes in one.numbers.items() if not changes}  # by their priors
    errors = dict(zip(model.names, np.sqrt(np.diag(covariance)).tolist(), strict=True))
    if "depth" in held:
        beads = tuple(replace(b, errors=b.errors | dict.fromkeys({"depth"} & {*b.errors}, math.nan)) for b in beads)
    errors |= dict.fromkeys(held & {*errors}, math.nan)
    coefficients = dict(zip(model.names, values, strict=True))
    named = [*estimated_names, *(contradicted.numbers if contradicted else ())]
    if Findings(findings).converged and not differ:  # otherwise constants stand for what differs
        findings += bead_checks.stated_findings(search.setup, coefficients, errors, named)
    result = BeadFit(
        findings=Findings(findings),
        summary=summary,
        aberrations=Wavefront.zernike(edge, normalization="edge"),
        **{name: getattr(setup, name) for name in ("objective", "wavelength", "pixel", "diameter", "emitter")},
        coefficients=coefficients,
        errors=errors,
        covariance=covariance,
        beads=beads,
        z_covariance=z_covariance,
        row_covariance=row_covariance,
        column_covariance=column_covariance,
        tests=tests,
        chi2=chi2,
        held_out=held_out,
        model_error=image_error,
        steps=search.steps,
        _state=state,
        _images=model.images,
    )
    if contradicted is None or not result.converged:
        return result
    depth = next((bead.depth for bead in beads if bead.used), beads[0].depth)
    return replace(result, findings=bead_checks.with_strehl(result.findings, result.strehl(depth=depth)))


def _with_other_beads(
    model: BeadModel, fit: Evaluation, covariance: Array, used: Mapping[int, bool]
) -> tuple[Evaluation, Array, list[bool]]:
    """Return fit and covariance with the beads that the joint fit was without, and whether each bead is used.

    `used` has the beads of the joint fit. Common parameters stay as they are: the place p of another bead changes
    with them by the implicit function theorem, dp / dc = -I_pp^-1 I_pc.
    """
    k, q, count = len(model.names), len(model.bead_parameters), len(model.stacks)
    is_used, found = [used.get(j, False) for j in range(count)], dict[int, Evaluation]()
    limit = MAX_CHI2_RATIO * fit.quality[0]
    for j in range(count):
        if j not in used:
            single = model.with_beads([j])
            try:
                placed = place_bead(single, fit.state)
            except (Declined, ValueError):
                continue
            plausible = float(goodness_of_fit.largest_plausible_chi2(placed.quality[1]))
            is_used[j] = placed.quality[0] < max(limit, plausible)
            if is_used[j]:
                parts, information, _ = single.normal_equations(
                    replace(placed.state, waves=fit.state.waves), placed.values
                )
                found[j] = replace(placed, parts=parts, scores=placed.scores._replace(information=information[None]))
    if not found:
        return fit, covariance, is_used
    kept, joint = np.flatnonzero(is_used).tolist(), iter(range(len(fit.values)))
    places, light, values, parts = list[Place](), list[Array](), list[Array](), list[Part]()
    # Parameters of all beads: linear functions of those of the joint fit, and noise of their own.
    chain, own = np.zeros((k + q * len(kept), len(covariance))), np.zeros((k + q * len(kept),) * 2)
    chain[:k, :k] = np.eye(k)
    for index, j in enumerate(kept):
        rows = slice(k + q * index, k + q * (index + 1))
        if j in found:
            one, at, information = found[j], 0, found[j].scores.information[0]
            own[rows, rows] = inverse = _inverse(information[k:, k:])
            chain[rows, :k] = -inverse @ information[k:, :k]
        else:
            one, at = fit, next(joint)
            chain[rows, k + q * at : k + q * (at + 1)] = np.eye(q)
        places.append(one.state.places[at])
        light.append(one.state.light[at])
        values.append(one.values[at])
        parts.append(one.parts[at])
    state = replace(fit.state, places=tuple(places), light=tuple(light))
    return replace(fit, state=state, values=values, parts=parts), chain @ covariance @ chain.T + own, is_used


def _height_jacobian(model: BeadModel, state: State) -> Array:
    """Return derivatives of z of all beads by all parameters, shape (beads, parameters)."""
    jacobian, setup, names = np.zeros((len(state.places), model.size)), state.setup, model.names
    for j, place in enumerate(state.places):
        for name in model.priors:
            pair = setup.adjacent_values(name)
            z = [_height(setup.with_constant(name, value), place) for value in pair]
            jacobian[j, names.index(name)] = (z[1] - z[0]) / (pair[1] - pair[0])
        columns = dict(zip(model.bead_parameters, model.columns(j, len(names)), strict=True))
        jacobian[j, columns["focus"]] = -1.0 / setup.step
        if "depth" in columns:
            h = CONSTANTS["depth"].step
            lower = place._replace(depth=place.depth + h)
            jacobian[j, columns["depth"]] = (_height(setup, lower) - _height(setup, place)) / h
    return jacobian


def _height(setup: Setup, place: Place) -> float:
    """Return the stage position (metres) at which a bead would be in the brightest focus without aberrations."""
    return (brightest(setup, place.depth) - place.focus) / setup.step


def _add_shift(state: State, model: BeadModel, shift: Array) -> State:
    """Return a state with `shift` added to the common parameters, except to constants that would be impossible."""
    count, setup = len(state.waves), state.setup
    for name, step in zip(model.priors, shift[count:].tolist(), strict=True):
        if bead_checks.is_possible(setup, name, value := setup.value(name) + step):
            setup = setup.with_constant(name, value)
    return replace(state, waves=state.waves + shift[:count], setup=setup)


def _error_findings(covariance: Array, image_error: float, moved: tuple[str, float]) -> list[Finding]:
    """Return findings on large standard errors of the terms, and on a large error of the images in the search.

    That error is a doubt if it has `moved` an estimate (name, standard errors) by a standard error.
    """
    findings = too_dim_findings(math.sqrt(float(np.trace(covariance))))
    if image_error >= _MAX_IMAGE_ERROR:
        text = (
            f"images of the search differ from images with a proven error bound by {image_error:.2g} of the peak, "
            f"which moves {moved[0]} by {moved[1]:.2g} standard errors, and others by less"
        )
        if not math.isfinite(image_error):
            text = "aberrations are too strong to compute images with a proven error bound"
        severity: Severity = "doubt" if moved[1] > 1.0 else "note"
        findings.append(Finding("model_error", severity, text, {"error": image_error, "moved": moved[1]}))
    return findings


def _inverse(information: Array) -> Array:
    """Return the covariance, the pseudo-inverse of an information matrix."""
    # With a diagonal of 1, the cutoff for small singular values does not depend on units.
    scale = np.sqrt(np.maximum(np.diag(information), 1e-300))
    return np.asarray(np.linalg.pinv(information / np.outer(scale, scale), rcond=1e-12) / np.outer(scale, scale))


def _beads(
    model: BeadModel, fit: Evaluation, covariance: Array, z_variances: Array, is_used: list[bool],
    recorded: list[Counts], noise: Noise,
) -> tuple[FittedBead, ...]:  # fmt: skip
    """Return the estimates of all beads; beads left out of the joint fit are fitted with fixed common parameters."""
    beads, k, setup = [], len(model.names), fit.state.setup
    names = ["z" if name == "focus" else name for name in model.bead_parameters]
    for j, stack in enumerate(model.stacks):
        single_model, bead_fit, index = replace(model.with_beads([j]), priors={}), fit, sum(is_used[:j])
        errors, light_variances = dict[str, float](), np.full((len(stack.z), 2), math.nan)
        if not is_used[j]:
            place = start_of(stack, setup, model.depths[j].value, 0.0)
            bead_fit, index = single_model.evaluate(State(setup, fit.state.waves, (place,))), 0
        state, image, part = bead_fit.state, bead_fit.values[index], bead_fit.parts[index]
        place, light = state.places[index], state.light[index]
        level_stack, mean_gradient = stack.without_gradient(place)
        if is_used[j]:
            columns = [*range(k), *model.columns(index, k)]
            bead_covariance, coupling = covariance[np.ix_(columns, columns)], part.light_coupling
            errors = dict(zip(names, np.sqrt(np.diag(bead_covariance)[k:]).tolist(), strict=True))
            errors["z"] = math.sqrt(z_variances[j])
            # Covariance of flux and background: due to noise, and due to errors of the parameters.
            parameter_part = coupling.swapaxes(1, 2) @ bead_covariance @ coupling
            light_variances = np.diagonal(part.light_covariance + parameter_part, axis1=1, axis2=2)
            # Errors of parameters are common to all planes: their effect on the mean does not average out.
            mean_coupling = coupling.mean(axis=0)
            mean_variance = np.diag(part.light_covariance.mean(axis=0)) / len(stack.z)
            mean_variance += np.diag(mean_coupling.T @ bead_covariance @ mean_coupling)
            errors |= {name: noise.excess * errors[name] for name in GRADIENT if name in errors}
            errors |= dict(zip(("flux", "background"), (noise.excess * np.sqrt(mean_variance)).tolist(), strict=True))
        mean, row = expected(light, image), part.gradient.shape[1] - len(model.bead_parameters)
        counted, read, valid = level_stack.planes
        variance = np.maximum(mean + read, 0.25 * read)
        beads.append(
            FittedBead(
                row=stack.shape[0] // 2 + place.row,
                column=stack.shape[1] // 2 + place.column,
                z=_height(setup, place),
                depth=place.depth,
                errors=errors,
                drift=place.drift,
                gradient=(noise.excess * place.gradient_row, noise.excess * place.gradient_column),
                flux=noise.excess * light[0],
                background=noise.excess * (light[1] + mean_gradient),
                flux_errors=noise.excess * np.sqrt(light_variances[:, 0]),
                background_errors=noise.excess * np.sqrt(light_variances[:, 1]),
                moved=bead_checks.moved_planes(*part.shifts([row, row + 1])),
                chi2=single_model.chi2_of([part])[0],
                used=is_used[j],
                images=np.where(recorded[j].known, recorded[j].values, np.nan),
                model=noise.poisson.image(mean + (stack.planes[0] - counted)),
                residual=np.where(valid, (counted - mean) / np.sqrt(variance), np.nan),
            )
        )
    return tuple(beads)
