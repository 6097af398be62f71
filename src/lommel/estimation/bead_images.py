"""Images of fluorescent beads in z stacks, as functions of wavefront, microscope and position, and their likelihood.

All beads have the same wavefront and constants of the microscope; each bead has its own position (`Place`). Flux and
background of each plane are eliminated: they have their maximum-likelihood values, and the information on the other
parameters is the Schur complement. v = 2 pi NA r / lambda is the dimensionless radius in the object plane.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache, partial
from typing import Any, NamedTuple

import numpy as np
import scipy
from numpy.typing import ArrayLike, NDArray

from lommel.base.arrays import Array
from lommel.core.answers import Declined
from lommel.core.engine import star_likelihood
from lommel.estimation.star_images import pixel_data
from lommel.fit.scoring import weighted_light
from lommel.methods.derivative_names import SHIFTS, Term
from lommel.methods.layers import chordal_debye as light_by_rule
from lommel.methods.layers.chordal_debye import MIN_MARGIN, Planes, Rule
from lommel.methods.layers.chordal_debye import SampleLattice as Samples
from lommel.optics.aperture.apodization import Apodization, illumination
from lommel.optics.layers.emitter import Dipole, Emitter
from lommel.optics.layers.objective import Objective, layers_of
from lommel.optics.layers.objective_pupil import ObjectivePupil, power_at
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.recorded.counts import Counts
from lommel.recorded.noise import Noise
from lommel.special import zernike

GRADIENT = ("gradient_row", "gradient_column")  # gradients of the background, electrons from edge to edge
DYE: Mapping[str, Dipole] = {
    f"dye_{axis}": Dipole(0.5 * math.pi, azimuth, wobble=0.98)
    for axis, azimuth in (("x", 0.0), ("y", 0.5 * math.pi), ("oblique", 0.25 * math.pi))
}
"""Nearly isotropic dyes that prefer an axis of the camera, for derivatives by the preferred fraction."""
DIPOLE = ("wobble", "azimuth")  # constants of a dye that keeps the polarization of its excitation
NONLINEAR = "nonlinear"  # nonlinearity of the camera: fraction of electrons that is lost at 10^4 electrons
_MAX_CHORDS = 160  # maximum number of chords of the pupil along which the quadrature rule integrates
_ITERATIONS = 4  # iterations for flux and background of a plane
_MOST_SAMPLES = 250_000  # largest number of samples, of images and derivatives, that are in memory at a time
_MIN_FLUX = 1e-3  # smallest flux of a plane in the search, relative to the largest flux of all planes


class Constant(NamedTuple):
    """A constant of the microscope that may be estimated.

    `step` is the step of finite differences, `max_step` the largest change in a step of the search, `size` the
    expected error in score tests, `prior` the default standard error of the prior (0: fixed by default). `step` and
    `max_step` are relative to the value if `relative`; `size` and `prior` of pixel and diameter always are.
    """

    step: float
    unit: str
    max_step: float
    size: float
    prior: float = 0.0
    relative: bool = False


# The relative error of finite differences is quadratic in the step, and below 1e-3. The default error of the cover
# glass is the tolerance of No. 1.5H; with a fixed thickness, errors of spherical aberration would be too small.
CONSTANTS: Mapping[str, Constant] = {
    "sample": Constant(1e-3, "", 0.05, 0.02, 3e-3),
    "immersion": Constant(1e-4, "", 5e-3, 2e-3),
    "coverslip": Constant(1e-6, "m", 3e-5, 5e-6, 5e-6),
    "NA": Constant(1e-3, "", 0.05, 0.02, 0.02),
    "pixel": Constant(2e-3, "m", 0.05, 0.01, 0.01, relative=True),
    "diameter": Constant(4e-9, "m", 1e-7, 0.3, 0.1),
    "blur": Constant(0.01, "pixels^2", 0.2, 0.1),
    "step": Constant(1e-2, "", 0.1, 0.02),
    "depth": Constant(4e-9, "m", 3e-7, 50e-9, 20e-9),
    "jump": Constant(4e-9, "m", 3e-7, 100e-9),
    "wavelength": Constant(2e-9, "m", 2e-8, 10e-9),
    "wobble": Constant(0.01, "", 0.1, 0.3),
    "azimuth": Constant(0.02, "rad", 0.3, math.pi),
    **{f"apodization_{n}": Constant(1e-2, "", 0.3, 0.1) for n in (2, 4, 6, 8)},
}
UNITS = {"m": (1e6, " um"), "pixels^2": (1.0, " pixels^2"), "rad": (1.0, " rad"), "": (1.0, "")}
"""For each unit of `Constant`: the factor to convert to the unit of messages, and the name of that unit."""
AMPLITUDES: Mapping[str, int] = {name: int(name[-1]) for name in CONSTANTS if name.startswith("apodization")}
"""Degree of the radial term for each constant of the apodization: a coefficient (nepers rms) of the log amplitude."""


@dataclass(frozen=True)
class Setup:
    """Constants of the microscope and of the beads.

    `blur` is the variance of a Gaussian, in pixels squared; `step` is a factor of the positions of the stage, and
    `jump` the displacement (metres) of the planes that a stack marks as displaced.
    """

    objective: Objective
    wavelength: float
    emitter: Emitter
    pixel: float
    diameter: float
    blur: float = 0.0
    step: float = 1.0
    jump: float = 0.0
    integrate: bool = True

    def value(self, name: str) -> float:
        """Return the value of a constant."""
        if name == "coverslip":
            assert self.objective.coverslip is not None
            return self.objective.coverslip.thickness
        if name in AMPLITUDES:
            return illumination(self.objective.apodization).to_zernike().get(AMPLITUDES[name], 0.0)
        owner = self.emitter if name in DIPOLE else self if name in _SETUP_CONSTANTS else self.objective
        return float(getattr(owner, name))

    def scale(self, name: str) -> float:
        """Return the unit of a constant's `size` and `prior`: its value for pixel and diameter, otherwise 1."""
        return self.value(name) if name in ("pixel", "diameter") else 1.0

    def adjacent_values(self, name: str) -> tuple[float, float]:
        """Return a smaller and a larger possible value of a constant, for finite differences."""
        constant, value, objective = CONSTANTS[name], self.value(name), self.objective
        h = constant.step * (value if constant.relative else 1.0)
        immersion = max(1.0, value - 0.5 * (value - objective.NA))
        smallest = {"diameter": 0.25 * value, "immersion": immersion, "sample": 1.0, "wobble": 0.0}
        # The largest NA is below the index of the immersion.
        largest = {"NA": value + 0.5 * (min(objective.immersion, objective.design.immersion) - value), "wobble": 1.0}
        return max(value - h, smallest.get(name, -math.inf)), min(value + h, largest.get(name, math.inf))

    def with_constant(self, name: str, value: float) -> Setup:
        """Return the microscope with another value of a constant; ValueError if that value is impossible."""
        changes: dict[str, Any] = {name: value}
        if name in DIPOLE:
            assert isinstance(self.emitter, Dipole)
            changes = {"emitter": replace(self.emitter, **changes)}
        elif name not in _SETUP_CONSTANTS:
            changes = {"objective": changed_objective(self.objective, name, value)}
        return replace(self, **changes)

    def pupil(
        self, aberrations: Wavefront | None, depth: ArrayLike, z: ArrayLike = 0.0, origin: str = "brightest"
    ) -> ObjectivePupil:
        """Return the pupil of an emitter at a depth with the stage at z; see :meth:`lommel.Objective.pupil`."""
        return self.objective.pupil(
            depth=depth, z=z, wavelength=self.wavelength, origin=origin, emitter=self.emitter, aberrations=aberrations
        )

    @cached_property
    def pixel_v(self) -> float:
        """Pixel pitch in units of v."""
        objective = self.objective
        return 2.0 * math.pi * objective.NA * self.pixel / (self.wavelength * objective.magnification)

    @cached_property
    def radius(self) -> float:
        """Radius of the bead in units of v."""
        return math.pi * self.objective.NA * self.diameter / self.wavelength


_SETUP_CONSTANTS = ("pixel", "diameter", "blur", "step", "jump", "wavelength")


def changed_objective(objective: Objective, name: str, value: float) -> Objective:
    """Return an objective of the same design, with another value of a constant: sample, NA, ... (see `CONSTANTS`)."""
    changes: dict[str, Any] = {name: value}
    if name == "coverslip":
        assert objective.coverslip is not None
        changes = {name: replace(objective.coverslip, thickness=value)}
    elif name in AMPLITUDES:
        terms = illumination(objective.apodization).to_zernike()
        changes = {"apodization": Apodization.zernike(terms | {AMPLITUDES[name]: value})}
    return replace(objective, **changes)


class Place(NamedTuple):
    """Position of a bead: row and column in pixels from the middle of the window, focus and depth in metres.

    `focus` is the distance of the stage at z = 0 from the paraxial focus on the cover glass. The drift is the
    displacement in pixels from the middle to the end of the stack. The gradient of the background is in electrons
    from edge to edge of the window.
    """

    row: float
    column: float
    focus: float
    depth: float
    drift_row: float = 0.0
    drift_column: float = 0.0
    gradient_row: float = 0.0
    gradient_column: float = 0.0

    @property
    def drift(self) -> tuple[float, float]:
        """Drift along rows and along columns."""
        return self.drift_row, self.drift_column


@dataclass(frozen=True, eq=False)
class Stack:
    """The recorded stack of a bead: `pixel_data` and stage positions of the planes, and 1 for displaced planes."""

    pixel_data: Array  # (4, planes, pixels)
    shape: tuple[int, int]
    z: Array  # (planes,), metres
    displaced: Array | float = 0.0  # (planes,)

    @property
    def times(self) -> Array:
        """Times of the planes, -1 to 1 over the stack: drift displaces a plane by the product of time and drift."""
        return np.linspace(-1.0, 1.0, len(self.z))

    @property
    def planes(self) -> tuple[Array, Array, NDArray[np.bool_]]:
        """Electrons, variances of the read noise, and masks of valid pixels; three arrays (planes, height, width)."""
        counted, _, read, valid = self.pixel_data.reshape(4, -1, *self.shape)
        return counted, read, valid > 0.0

    def without_gradient(self, place: Place) -> tuple[Stack, float]:
        """Return the stack without the gradient of the background, and the mean that is subtracted with it."""
        gradients = place.gradient_row, place.gradient_column
        if not any(gradients):
            return self, 0.0
        # Electrons plus the read variance have a Poisson distribution. A known part of the background, if not
        # negative, may therefore be subtracted from the electrons and added to the variances.
        mean = 0.5 * (abs(gradients[0]) + abs(gradients[1]))
        rows, columns = (np.linspace(-0.5, 0.5, side) for side in self.shape)
        part = (mean + gradients[0] * rows[:, None] + gradients[1] * columns).ravel()
        data = self.pixel_data.copy()
        data[0] -= part
        data[1:3] += part
        return replace(self, pixel_data=data), mean

    def background_fit(self) -> tuple[float, float, dict[str, float]]:
        """Return chi2 of sloping backgrounds alone, its standard deviation, and the mean gradients of the planes."""
        counted, read, valid = (part.reshape(len(self.z), -1) for part in self.planes)
        grid = np.meshgrid(*(np.linspace(-0.5, 0.5, side) for side in self.shape), indexing="ij")
        design = np.stack([np.ones(counted.shape[1]), *(part.ravel() for part in grid)], axis=1)
        fits = [np.linalg.lstsq(design[k], light[k], rcond=None)[0] for light, k in zip(counted, valid, strict=True)]
        mean = np.maximum(np.array(fits) @ design.T, 0.0)
        variance = np.maximum(mean + read, 1e-9)
        freedom = int(valid.sum()) - 3 * len(self.z)
        chi2 = float((valid * (counted - mean) ** 2 / variance).sum()) / freedom
        # The fourth moment of a Poisson deviate exceeds that of a normal one by the mean.
        deviation = math.sqrt(float((valid * (2.0 + mean / variance**2)).sum())) / freedom
        return chi2, deviation, dict(zip(GRADIENT, np.mean(fits, axis=0)[1:].tolist(), strict=True))

    @staticmethod
    def of(counts: Counts, noise: Noise, z: Array) -> Stack:
        """Return the stack of recorded images (planes, height, width)."""
        shape, poisson = counts.values.shape, noise.poisson
        data = pixel_data(poisson.electrons(counts.filled()), poisson.variance(np.zeros(shape)), counts.known)
        return Stack(data, (shape[1], shape[2]), z)


@lru_cache(maxsize=16)
def heights(radius: float) -> tuple[Array, Array]:
    """Return heights, in radii, of discs that approximate a ball, and the volume fractions of the discs."""
    if radius == 0.0:
        return np.zeros(1), np.ones(1)
    # The area of the cross-section at height u is proportional to 1 - u^2, the weight of this Gauss-Jacobi rule.
    u, w = scipy.special.roots_jacobi(max(2, math.ceil(1.0 + 1.35 * radius)), 1.0, 1.0)
    return u, w / w.sum()


class BeadImages:
    """Images of a bead in the planes of a stack, by quadrature rules of fixed size, and their derivatives.

    Parameters of an image are a `Setup`, coefficients `waves` of the Zernike terms (radians rms), and a `Place`.
    """

    def __init__(self, terms: Sequence[Term], fixed: Mapping[Term, float], threads: int) -> None:
        self.estimated_terms = tuple(terms)
        fixed_names = [term for term in fixed if term not in self.estimated_terms and term not in SHIFTS.values()]
        self.terms: tuple[Term, ...] = (*self.estimated_terms, *fixed_names, *SHIFTS.values())
        self.factors = np.array([zernike.rms_factor(n, m) for n, m in self.estimated_terms])
        self.fixed_terms = {term: fixed[term] for term in fixed_names}  # radians at the edge
        self._fixed_coefficients = np.array([*self.fixed_terms.values()])
        self.threads = threads

    def with_terms(self, added: Sequence[Term]) -> BeadImages:
        """Return a model with the terms `added` appended to the estimated terms."""
        return BeadImages((*self.estimated_terms, *added), self.fixed_terms, self.threads) if added else self

    def without_terms(self, waves: Array) -> BeadImages:
        """Return a model in which all terms are fixed, the formerly estimated terms at the coefficients `waves`."""
        return BeadImages((), self.edge(waves), self.threads)

    def edge(self, waves: Array) -> dict[Term, float]:
        """Return the coefficients of all terms, radians at the pupil edge."""
        return dict(zip(self.estimated_terms, (waves * self.factors).tolist(), strict=True)) | self.fixed_terms

    def values(self, setup: Setup, waves: Array, place: Place, stack: Stack, *, ball: bool = True) -> Array:
        """Return the fraction of the total light in each pixel, (planes, height, width).

        If not `ball`, the bead is approximated by a point with a blur of the bead's width (for finite differences).
        """
        return np.asarray(self._images_and_derivatives(setup, waves, place, stack, ball=ball, by=None)[0])

    def derivatives(
        self, setup: Setup, waves: Array, place: Place, stack: Stack, amplitudes: Sequence[str] = ()
    ) -> Array:
        """Return derivatives by the waves, focus (per metre), row, column and `amplitudes`, (k, planes, ...)."""
        return self._images_and_derivatives(setup, waves, place, stack, ball=False, by=amplitudes)[1:]

    def _images_and_derivatives(
        self, setup: Setup, waves: Array, place: Place, stack: Stack, *, ball: bool, by: Sequence[str] | None
    ) -> Array:
        """Return images and, unless `by` is None, their derivatives as well; `by` are names in `AMPLITUDES`."""
        objective, pixel_v, count = setup.objective, setup.pixel_v, len(stack.z)
        layers = layers_of(objective, setup.wavelength)
        center = np.array([stack.shape[0] // 2 + place.row, stack.shape[1] // 2 + place.column])
        half_width, whole = _filter_half_width(setup), np.round(center)
        edge = np.concatenate([waves * self.factors, self._fixed_coefficients, np.zeros(2)])[None]
        if any(place.drift):
            edge = np.repeat(edge, count, axis=0)
            edge[:, -2:] = pixel_v * np.outer(stack.times, place.drift)
        rule = self.rule(Samples(stack.shape, (center[0], center[1]), pixel_v, half_width), edge)
        # The fraction of a pixel is a tilt: all beads share the large tables of a lattice.
        samples = Samples(stack.shape, (whole[0], whole[1]), pixel_v, half_width)
        edge[:, -2:] += pixel_v * (center - whole)
        u, fractions = heights(setup.radius) if ball else (np.zeros(1), np.ones(1))
        # No disc may lie inside the cover glass: a bead nearer than its radius is flattened, and images are smooth.
        depths = place.depth + min(0.5 * setup.diameter, place.depth) * u
        focus = place.focus + setup.step * stack.z + setup.jump * stack.displaced
        amplitudes = by or ()
        degrees = tuple(AMPLITUDES[name] for name in amplitudes)
        if by is None:
            light_of, order = partial(light_by_rule.light, threads=self.threads), [0]
        else:
            light_of = partial(
                light_by_rule.light, by=(*self.estimated_terms, *SHIFTS.values()), by_focus=True,
                by_amplitude=degrees, threads=self.threads,
            )  # fmt: skip
            # Order of the derivatives of light(): focus, amplitudes, terms at the pupil edge, tilts.
            first, last = 2 + len(degrees), 2 + len(degrees) + len(self.estimated_terms)
            order = [0, *range(first, last), 1, last, last + 1, *range(2, first)]
        power = power_at(layers, setup.emitter, depths)
        scale = pixel_v**2 / (4.0 * math.pi * float(fractions @ power))
        filters = []
        for height in u.tolist():
            # The variance of a projected ball along an axis is radius^2 / 5.
            disc_radius, ball_variance = 0.0, setup.radius**2 / 5.0
            if ball:
                disc_radius, ball_variance = setup.radius * math.sqrt(1.0 - height**2), 0.0
            blur_variance = ball_variance + setup.blur * samples.step**2
            filters.append(light_by_rule.pixel_filter(samples, disc_radius, blur_variance, integrate=setup.integrate))
        images = np.empty((len(order), count, *stack.shape), np.float64 if by is None else np.float32)
        # Samples are far larger than images: groups of planes limit their memory.
        size = max(1, _MOST_SAMPLES // (len(order) * len(u) * math.prod(samples.window.shape)))
        for group in np.array_split(np.arange(count), math.ceil(count / size)):
            edges = np.tile(edge[group], (len(u), 1)) if len(edge) > 1 else edge
            planes = Planes(np.repeat(depths, len(group)), np.tile(focus[group], len(u)), edges)
            sampled = light_of(layers, setup.emitter, planes, samples, rule, self.terms)
            discs = sampled.reshape(len(order), len(u), len(group), *sampled.shape[-2:])
            images[:, group] = sum(
                scale * fraction * pixels.of(discs[order, k].astype(images.dtype))
                for k, (pixels, fraction) in enumerate(zip(filters, fractions.tolist(), strict=True))
            )
        if by is not None:
            images[1 : 1 + len(self.estimated_terms)] *= self.factors[:, None, None, None]
            # A shift by one pixel is a tilt of `pixel_v` radians at the pupil edge.
            shifts = 2 + len(self.estimated_terms)
            images[shifts : shifts + 2] *= pixel_v
            for k, name in enumerate(amplitudes, shifts + 2):
                # Images are normalized to the collected light, which depends on the amplitudes.
                images[k] -= _light_derivative(setup, name, depths) * images[0]
        return images

    def rule(self, samples: Samples, edge: Array) -> Rule:
        """Return the quadrature rule for phases `edge` (radians at the edge); Declined if phases are too strong."""
        window = samples.window
        pairs = zip(window.center, window.shape, strict=True)
        distances = [max(center, side - 1.0 - center) for center, side in pairs]
        coefficients = edge[0, :-2]
        mean_squares = [1.0 / zernike.rms_factor(n, m) ** 2 for n, m in self.terms[:-2]]
        # The rms phase of the terms, plus the largest tilt due to drift at the pupil edge.
        phase = math.sqrt(float((coefficients**2) @ mean_squares)) + float(np.abs(edge[:, -2:]).max(initial=0.0))
        rule = light_by_rule.search_rule(max(distances) * window.step, phase)
        if rule.chords > _MAX_CHORDS:
            raise Declined("aberrations are too strong for the search: reduce them, or use a smaller window")
        return rule

    def differences(self, setup: Setup, waves: Array, place: Place, stack: Stack, name: str) -> Array:
        """Return the derivative by a constant, the depth or a preferred axis of the dye, by finite differences."""
        if name in DYE:
            changed_setup = replace(setup, emitter=DYE[name])
            pair = [self.values(one, waves, place, stack, ball=False) for one in (changed_setup, setup)]
            return np.asarray((pair[0] - pair[1]) / (1.0 - DYE[name].wobble))
        step = CONSTANTS[name].step
        if name == "depth":
            low, high = max(place.depth - step, 0.0), place.depth + step
            places = place._replace(depth=high), place._replace(depth=low)
            pair = [self.values(setup, waves, bead_place, stack) for bead_place in places]
            return np.asarray((pair[0] - pair[1]) / (high - low))
        low, high = setup.adjacent_values(name)
        ball = name in ("diameter", "sample")  # the effect of these constants depends on the height within the bead
        setups = setup.with_constant(name, high), setup.with_constant(name, low)
        pair = [self.values(changed_setup, waves, place, stack, ball=ball) for changed_setup in setups]
        return np.asarray((pair[0] - pair[1]) / (high - low))


def _light_derivative(setup: Setup, name: str, depth: Array) -> float:
    """Return the derivative of the logarithm of the collected light with respect to an amplitude coefficient."""
    h, n, logarithms = CONSTANTS[name].step, AMPLITUDES[name], []
    for value in (setup.value(name) + h, setup.value(name) - h):
        layers = layers_of(setup.with_constant(name, value).objective, setup.wavelength)
        # Derivatives of images neglect that the largest amplitude is normalized to 1: compensate for this here.
        factor = (layers.exponent[0] if layers.exponent else 0.0) + value * math.sqrt(n + 1.0) * (-1.0) ** (n // 2)
        logarithms.append(math.log(float(power_at(layers, setup.emitter, depth)[0])) + 2.0 * factor)
    return (logarithms[0] - logarithms[1]) / (2.0 * h)


def _filter_half_width(setup: Setup) -> int:
    """Return the number of samples on either side of a pixel that the pixel filter uses."""
    stride = max(1, math.ceil(setup.pixel_v / 1.535))
    half_width = 2.0 * math.sqrt(max(setup.blur, 0.0)) * setup.pixel_v + setup.radius
    return MIN_MARGIN + (stride - 1) * 2 + math.ceil(half_width * stride / setup.pixel_v)


def flux_background(values: Array, data: Array, previous: Array | None = None) -> Array:
    """Return the maximum-likelihood flux and background of each plane, (2, planes), for PSFs (planes, ...).

    `data` are the pixel data of a :class:`Stack`; iterations start at `previous`, or at a fit with other weights.
    """
    psf = values.reshape(len(values), -1).astype(np.float64)
    counted, _, read, valid = data
    # Initial weights use the counts as variances; the added 1 keeps the weights of dark pixels finite.
    weight = valid / (np.maximum(counted, 0.0) + read + 1.0)
    light = previous
    for _ in range(_ITERATIONS):
        if light is not None:
            mean = light[0][:, None] * psf + light[1][:, None]
            weight = valid / np.maximum(mean + read, 0.25 * read)
        flux, level, mean_psf = weighted_light(psf, counted, weight)
        # At flux 0 a plane would not depend on the position of the bead.
        flux = np.maximum(flux, _MIN_FLUX * np.abs(flux).max() + 1e-9)
        # `level` is the expected value at a pixel where the PSF has its weighted mean `mean_psf`.
        light = np.stack([flux, level - flux * mean_psf])
    return np.asarray(light)


def expected(light: Array, values: Array) -> Array:
    """Return the expected electrons of planes, from flux and background `light` (2, planes), and PSFs `values`."""
    return np.asarray(light[0][:, None, None] * values + light[1][:, None, None])


class Part(NamedTuple):
    """Contribution of one bead to likelihood and information, with flux and background eliminated.

    Parameters are, in this order, the parameters common to all beads, and the parameters of this bead.
    """

    gradient: Array  # (planes, parameters), derivatives of the log-likelihood
    information: Array  # (planes, parameters, parameters)
    chi2: float  # Pearson's sum of squares
    chi2_expectation: float  # expectation of `chi2`
    chi2_variance: float  # variance of `chi2`
    flux_sigmas: float  # total flux of all planes, in standard deviations
    light_covariance: Array  # (planes, 2, 2), covariance of flux and background for fixed parameters
    light_coupling: Array  # (planes, parameters, 2), minus the derivative of flux and background by the parameters
    total: Array  # (parameters, parameters), information of all planes

    def shifts(self, columns: list[int]) -> tuple[Array, Array]:
        """Return each plane's steps (planes, q) of the q parameters `columns`, and their significance (sigmas)."""
        information, gradient = self.information[:, columns][:, :, columns], self.gradient[:, columns]
        information = _regularized(information) + 1e-300 * np.eye(len(columns))
        step = np.asarray(np.linalg.solve(information, gradient[..., None])[..., 0])
        return step, np.sqrt(np.maximum(np.einsum("pk,pk->p", step, gradient), 0.0))


def _regularized(square: Array) -> Array:
    """Return matrices (planes, q, q) with a small number added to the diagonal, such that they are invertible."""
    return np.asarray(square + 1e-12 * np.trace(square, axis1=1, axis2=2)[:, None, None] * np.eye(square.shape[1]))


def part_of(
    values: Array, derivatives: Sequence[Array], chain: Array, stack: Stack, light: Array, threads: int
) -> Part:
    """Return the contribution of a stack to likelihood and information, from its PSFs `values`.

    The derivatives of PSFs by the parameters are `chain` (planes, parameters, k) times the k images in `derivatives`.
    """
    images = [values.astype(derivatives[0].dtype), *derivatives]
    sums, products = star_likelihood(images, light[None], stack.pixel_data, threads)
    _, chi2_expectation, chi2_variance = sums.sum(axis=(-1, -2))
    gram, k = products[0], len(derivatives)  # Gram matrices of the planes
    flux = light[0][:, None, None]
    light_information, mixed = _regularized(gram[:, k : k + 2, k : k + 2]), flux * gram[:, :k, k : k + 2]
    light_coupling = np.linalg.solve(light_information, mixed.swapaxes(1, 2)).swapaxes(1, 2)  # (planes, k, 2)
    # Schur complement: information on the parameters with flux and background of each plane eliminated.
    information = flux * flux * gram[:, :k, :k] - light_coupling @ mixed.swapaxes(1, 2)
    gradient = flux[..., 0] * gram[:, :k, -1]
    gradient -= np.einsum("pkl,pl->pk", light_coupling, gram[:, k : k + 2, -1])
    # Information on the flux, with the background eliminated.
    flux_information = light_information[:, 0, 0] - light_information[:, 0, 1] ** 2 / light_information[:, 1, 1]
    information = chain @ information @ chain.swapaxes(1, 2)
    return Part(
        np.einsum("pak,pk->pa", chain, gradient),
        information,
        float(gram[:, -1, -1].sum()),
        float(chi2_expectation),
        float(chi2_variance),
        math.sqrt(float((light[0] ** 2 * np.maximum(flux_information, 0.0)).sum())),
        np.asarray(np.linalg.inv(light_information)),
        chain @ light_coupling,
        information.sum(axis=0),
    )
