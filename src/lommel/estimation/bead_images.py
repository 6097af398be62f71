"""Stacks of fluorescent beads as a model of wavefront, microscope and places, and their likelihood.

Photons and background of each plane are eliminated: for any model they are those of maximum likelihood, and the
information about all else is the Schur complement. Beads share the wavefront and the constants of the microscope and
have places of their own.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache, partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy import special

from lommel.base.arrays import Array
from lommel.core.answers import Declined
from lommel.core.engine import star_likelihood
from lommel.estimation.star_images import star_counts
from lommel.fit.scoring import weighted_light
from lommel.methods.derivative_names import SHIFTS, Term
from lommel.methods.layers import chordal_debye as light_by_rule
from lommel.methods.layers.chordal_debye import HALF, Planes, Rule
from lommel.methods.layers.chordal_debye import SampleLattice as Samples
from lommel.optics.aperture.apodization import Apodization, illumination
from lommel.optics.layers.emitter import Emitter
from lommel.optics.layers.objective import Objective
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.recorded.counts import Counts
from lommel.recorded.noise import Noise
from lommel.special import zernike

GRADIENT = ("gradient_row", "gradient_column")  # of the background, electrons from edge to edge
NONLINEAR = "nonlinear"  # share of electrons missing from counts at 10^4
_MOST_NODES = 160  # largest number of chords
_TURNS = 4  # iterations for the light of a plane
_FAINTEST = 1e-3  # of the largest light: least light of a plane in the search


class Constant(NamedTuple):
    """A number of the microscope that may be an unknown: step of differences, unit, most of a step of a search.

    `size` is that of a mistake that is looked for, `usual` the standard error by default; 0 of one that is fixed.
    Step and reach are `relative` where stated; size and usual error of pixel and diameter are, too.
    """

    step: float
    unit: str
    reach: float
    size: float
    usual: float = 0.0
    relative: bool = False


# Differences over these steps err by their square: below 1e-3 of a derivative. The cover glass is of No. 1.5H: were
# it fixed, terms of spherical aberration would be stated as if it were exact.
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
    **{f"apodization_{n}": Constant(1e-2, "", 0.3, 0.1) for n in (2, 4, 6, 8)},
}
UNITS = {"m": (1e6, " um"), "pixels^2": (1.0, " pixels^2"), "rad": (1.0, " rad"), "": (1.0, "")}
"""Factors and words of units in texts."""
AMPLITUDES: Mapping[str, int] = {name: int(name[-1]) for name in CONSTANTS if name.startswith("apodization")}
"""Degrees of the radial terms of the logarithm of the amplitude, whose coefficients (nepers rms) are constants."""


@dataclass(frozen=True)
class Setup:
    """The microscope of the model: all that is not a place, a wavefront or light.

    `blur` is the variance of a Gaussian, in pixels squared; `step` a factor of the positions of the stage.
    """

    objective: Objective
    wavelength: float
    emitter: Emitter
    pixel: float
    diameter: float
    blur: float = 0.0
    step: float = 1.0
    integrate: bool = True

    def value(self, name: str) -> float:
        """Return the value of a constant."""
        if name == "coverslip":
            assert self.objective.coverslip is not None
            return self.objective.coverslip.thickness
        if name in AMPLITUDES:
            return illumination(self.objective.apodization).to_zernike().get(AMPLITUDES[name], 0.0)
        return float(getattr(self if name in _OWN else self.objective, name))

    def scale(self, name: str) -> float:
        """Return the unit of size and usual error of a constant: its value where these are relative, else 1."""
        return self.value(name) if name in ("pixel", "diameter") else 1.0

    def beside(self, name: str) -> tuple[float, float]:
        """Return values of a constant on either side, for differences, within its possible range."""
        given, at, one = CONSTANTS[name], self.value(name), self.objective
        h = given.step * (at if given.relative else 1.0)
        least = {"diameter": 0.25 * at, "immersion": max(1.0, at - 0.5 * (at - one.NA)), "sample": 1.0}
        most = {"NA": at + 0.5 * (min(one.immersion, one.design.immersion) - at)}  # below the indices
        return max(at - h, least.get(name, -math.inf)), min(at + h, most.get(name, math.inf))

    def having(self, name: str, value: float) -> Setup:
        """Return the microscope with another value of a constant; ValueError if no such microscope exists."""
        given: dict[str, Any] = {name: value} if name in _OWN else {"objective": changed(self.objective, name, value)}
        return replace(self, **given)

    def pupil(
        self, aberrations: Wavefront | None, depth: ArrayLike, z: ArrayLike = 0.0, origin: str = "brightest"
    ) -> ObjectivePupil:
        """Return the pupil of an emitter at a depth with the stage at z, as of :meth:`lommel.Objective.pupil`."""
        return self.objective.pupil(
            depth=depth, z=z, wavelength=self.wavelength, origin=origin, emitter=self.emitter, aberrations=aberrations
        )

    @property
    def across(self) -> float:
        """Pixel pitch in v."""
        one = self.objective
        return 2.0 * math.pi * one.NA * self.pixel / (self.wavelength * one.magnification)

    @property
    def radius(self) -> float:
        """Radius of the bead in v."""
        return math.pi * self.objective.NA * self.diameter / self.wavelength


_OWN = ("pixel", "diameter", "blur", "step")


def changed(objective: Objective, name: str, value: float) -> Objective:
    """Return an objective with another sample, immersion, NA, cover glass or apodization, of the same design."""
    given: dict[str, Any] = {name: value}
    if name == "coverslip":
        assert objective.coverslip is not None
        given = {name: replace(objective.coverslip, thickness=value)}
    elif name in AMPLITUDES:
        terms = illumination(objective.apodization).to_zernike()
        given = {"apodization": Apodization.zernike(terms | {AMPLITUDES[name]: value})}
    return replace(objective, **given)


class Place(NamedTuple):
    """Where a bead is: pixels from the middle of its window, stage position from paraxial focus on the glass, depth.

    The drift is how far it moves, in pixels, from the middle of the stack to either end.
    """

    row: float
    column: float
    focus: float
    depth: float
    drift_row: float = 0.0
    drift_column: float = 0.0

    @property
    def drift(self) -> tuple[float, float]:
        """Drift along rows and along columns."""
        return self.drift_row, self.drift_column


@dataclass(frozen=True, eq=False)
class Stack:
    """The recorded stack of a bead: electrons as :func:`star_likelihood` takes them, and positions of the stage."""

    star: Array  # (4, planes, pixels)
    shape: tuple[int, int]
    z: Array  # (planes,), metres

    @property
    def times(self) -> Array:
        """Time from -1 to 1 over the stack, for drift."""
        return np.linspace(-1.0, 1.0, len(self.z))

    @property
    def planes(self) -> tuple[Array, Array, NDArray[np.bool_]]:
        """Electrons, variances of reading, and known pixels, (planes, height, width) each."""
        counted, _, read, valid = self.star.reshape(4, -1, *self.shape)
        return counted, read, valid > 0.0

    @staticmethod
    def of(counts: Counts, noise: Noise, z: Array) -> Stack:
        """Return the stack of recorded images, (planes, height, width)."""
        shape, alike = counts.values.shape, noise.poisson
        star = star_counts(alike.electrons(counts.filled()), alike.variance(np.zeros(shape)), counts.known)
        return Stack(star, (shape[1], shape[2]), z)


@lru_cache(maxsize=16)
def heights(radius: float) -> tuple[Array, Array]:
    """Return heights of discs of a ball, over its radius in v, and their shares of its volume."""
    if radius == 0.0:
        return np.zeros(1), np.ones(1)
    # The area of a disc at height u is 1 - u^2: Gauss and Jacobi's rule for that weight.
    u, w = special.roots_jacobi(max(2, math.ceil(1.0 + 1.35 * radius)), 1.0, 1.0)
    return u, w / w.sum()


class BeadImages:
    """Images of a bead in the planes of a stack, by rules of stated size, and their derivatives.

    Parameters are a `Setup`, coefficients of Zernike `terms` (radians rms), and a `Place`.
    """

    def __init__(self, terms: Sequence[Term], fixed: Mapping[Term, float], threads: int) -> None:
        self.solved = tuple(terms)
        others = [term for term in fixed if term not in self.solved and term not in SHIFTS.values()]
        self.terms: tuple[Term, ...] = (*self.solved, *others, *SHIFTS.values())
        self.factors = np.array([zernike.rms_factor(n, m) for n, m in self.solved])
        self.fixed = {term: fixed[term] for term in others}  # radians at the edge
        self._others = np.array([*self.fixed.values()])
        self.threads = threads

    def with_terms(self, more: Sequence[Term]) -> BeadImages:
        """Return the images with further terms, after those that are estimated."""
        return BeadImages((*self.solved, *more), self.fixed, self.threads) if more else self

    def without_terms(self, waves: Array) -> BeadImages:
        """Return the images with all terms fixed at these coefficients."""
        return BeadImages((), self.edge(waves), self.threads)

    def edge(self, waves: Array) -> dict[Term, float]:
        """Return all terms, radians at the edge."""
        return dict(zip(self.solved, (waves * self.factors).tolist(), strict=True)) | self.fixed

    def values(self, setup: Setup, waves: Array, place: Place, stack: Stack, *, ball: bool = True) -> Array:
        """Return the share of all light in each pixel, (planes, height, width).

        Without `ball`, of the middle of the bead, with a blur of its width: for differences.
        """
        return np.asarray(self._images_and_slopes(setup, waves, place, stack, ball=ball, by=None)[0])

    def slopes(self, setup: Setup, waves: Array, place: Place, stack: Stack, amplitudes: Sequence[str] = ()) -> Array:
        """Return derivatives by the waves, focus (1 / metres), row, column and `amplitudes`, (k, planes, ...)."""
        return self._images_and_slopes(setup, waves, place, stack, ball=False, by=amplitudes)[1:]

    def _images_and_slopes(
        self, setup: Setup, waves: Array, place: Place, stack: Stack, *, ball: bool, by: Sequence[str] | None
    ) -> Array:
        """Return images and, unless `by` is None, their slopes, also by these amplitudes."""
        objective, across, count = setup.objective, setup.across, len(stack.z)
        layers = objective._layers(setup.wavelength)
        middle = (stack.shape[0] // 2 + place.row, stack.shape[1] // 2 + place.column)
        samples = Samples(stack.shape, middle, across, _half(setup))
        edge = np.concatenate([waves * self.factors, self._others, np.zeros(2)])[None]
        if any(place.drift):
            edge = np.repeat(edge, count, axis=0)
            edge[:, -2:] = across * np.outer(stack.times, place.drift)
        rule = self.rule(samples, edge)
        u, shares = heights(setup.radius) if ball else (np.zeros(1), np.ones(1))
        # No part of a bead lies within the glass.
        depths = np.maximum(place.depth + 0.5 * setup.diameter * u, 0.0)
        focus, amplitudes = np.tile(place.focus + setup.step * stack.z, len(u)), by or ()
        planes = Planes(np.repeat(depths, count), focus, np.tile(edge, (len(u), 1)) if len(edge) > 1 else edge)
        light = partial(light_by_rule.light, layers, setup.emitter, planes, samples, rule, self.terms)
        if by is None:
            found = light(threads=self.threads)
        else:
            terms, degrees = (*self.solved, *SHIFTS.values()), tuple(AMPLITUDES[name] for name in amplitudes)
            found = light(by=terms, by_focus=True, by_amplitude=degrees, threads=self.threads)
        power = light_by_rule.collected(layers, setup.emitter, depths)
        scale = across**2 / (4.0 * math.pi * float(shares @ power))
        total: Array | float = 0.0
        for k, (up, share) in enumerate(zip(u, shares.tolist(), strict=True)):
            # The projected ball has the variance of a fifth of its radius squared.
            disc, variance = (setup.radius * math.sqrt(1.0 - up**2), 0.0) if ball else (0.0, setup.radius**2 / 5.0)
            part = found[:, k * count : (k + 1) * count]
            blurred = variance + setup.blur * samples.step**2
            pixels = light_by_rule.pixel_filter(samples, disc, blurred, integrate=setup.integrate)
            total = total + share * pixels.of(part if by is None else part.astype(np.float32))
        made = np.asarray(scale * total)
        if by is not None:
            # By the focus first; then by amplitudes and by terms at the edge.
            first, last = 2 + len(amplitudes), 2 + len(amplitudes) + len(self.solved)
            made[first:last] *= self.factors[:, None, None, None]
            # Shifts in pixels are tilts of `across` radians at the edge each.
            made[-2:] *= across
            for k, name in enumerate(amplitudes, 2):
                # Images are over the collected light, which amplitudes change as well.
                made[k] -= _light_slope(setup, name, depths) * made[0]
            made = made[[0, *range(first, last), 1, last, last + 1, *range(2, first)]]
        return made

    def rule(self, samples: Samples, edge: Array) -> Rule:
        """Return the quadrature rule for these phases; Declined if they are too strong, as with too long a step."""
        window = samples.window
        ends = [max(at, side - 1.0 - at) for at, side in zip(window.center, window.shape, strict=True)]
        plain = edge[0, :-2]
        squares = [1.0 / zernike.rms_factor(n, m) ** 2 for n, m in self.terms[:-2]]
        # The rms phase of the terms, and the largest tilt by drift.
        phase = math.sqrt(float((plain * plain) @ squares)) + float(np.abs(edge[:, -2:]).max(initial=0.0))
        made = light_by_rule.search_rule(max(ends) * window.step, phase)
        if made.chords > _MOST_NODES:
            raise Declined("aberrations are too strong")
        return made

    def differences(self, setup: Setup, waves: Array, place: Place, stack: Stack, name: str) -> Array:
        """Return the derivative by a constant or the depth, by central differences over the steps of `CONSTANTS`."""
        given = CONSTANTS[name]
        if name == "depth":
            # A bead on the glass has no lower depth: the difference is one-sided there.
            h = min(given.step, max(place.depth - 0.5 * setup.diameter, 0.0))
            up, down = place._replace(depth=place.depth + given.step), place._replace(depth=place.depth - h)
            pair = [self.values(setup, waves, at, stack) for at in (up, down)]
            return np.asarray((pair[0] - pair[1]) / (given.step + h))
        low, high = setup.beside(name)
        whole = name in ("diameter", "sample")  # which change the light along the height of the bead
        pair = [self.values(setup.having(name, value), waves, place, stack, ball=whole) for value in (high, low)]
        return np.asarray((pair[0] - pair[1]) / (high - low))


def _light_slope(setup: Setup, name: str, depth: Array) -> float:
    """Return the logarithmic derivative of the collected light by a term of the amplitude."""
    h, n, found = CONSTANTS[name].step, AMPLITUDES[name], []
    for value in (setup.value(name) + h, setup.value(name) - h):
        layers = setup.having(name, value).objective._layers(setup.wavelength)
        # Derivatives of images are those of the terms alone, without the factor that makes the largest amplitude 1.
        factor = (layers.exponent[0] if layers.exponent else 0.0) + value * math.sqrt(n + 1.0) * (-1.0) ** (n // 2)
        found.append(math.log(float(light_by_rule.collected(layers, setup.emitter, depth)[0])) + 2.0 * factor)
    return (found[0] - found[1]) / (2.0 * h)


def _half(setup: Setup) -> int:
    """Return the number of samples beyond a pixel that its filter uses: more for large beads and blurs."""
    stride = max(1, math.ceil(setup.across / 1.535))
    wide = 2.0 * math.sqrt(max(setup.blur, 0.0)) * setup.across + setup.radius
    return HALF + (stride - 1) * 2 + math.ceil(wide * stride / setup.across)


def flux_background(values: Array, star: Array, before: Array | None = None) -> Array:
    """Return photons and background of each plane, (2, planes), of maximum likelihood for PSFs (planes, ...)."""
    psf = values.reshape(len(values), -1).astype(np.float64)
    counted, _, read, valid = star
    # The first weights are those of the counts; 1 electron keeps dark pixels from an infinite weight.
    weight = valid / (np.maximum(counted, 0.0) + read + 1.0)
    found = before
    for _ in range(_TURNS):
        if found is not None:
            mean = found[0][:, None] * psf + found[1][:, None]
            weight = valid / np.maximum(mean + read, 0.25 * read)
        flux, level, middle = weighted_light(psf, counted, weight)
        # A plane without light would leave its places undetermined.
        flux = np.maximum(flux, _FAINTEST * np.abs(flux).max() + 1e-9)
        # The level is that at the mean of the PSF, where flux and level are uncorrelated.
        found = np.stack([flux, level - flux * middle])
    return np.asarray(found)


def expected(light: Array, values: Array) -> Array:
    """Return the mean electrons of planes with this light, (2, planes)."""
    return np.asarray(light[0][:, None, None] * values + light[1][:, None, None])


class Part(NamedTuple):
    """Contribution of one bead's planes to the shared parameters, then to its own, with the light eliminated."""

    slope: Array  # (planes, parameters)
    information: Array  # (planes, parameters, parameters)
    chi2: float  # Pearson's sum of squares
    expected: float
    spread: float
    visible: float  # of the light of all planes, standard deviations
    scatter: Array  # (planes, 2, 2), covariance of the light where all parameters are held
    carried: Array  # (planes, parameters, 2), what the light falls by as parameters rise

    def shifts(self, columns: list[int]) -> tuple[Array, Array]:
        """Return steps of parameters in each plane (planes, q), all others held, and their size in sigmas."""
        square, slope = self.information[:, columns][:, :, columns], self.slope[:, columns]
        square = _regular(square) + 1e-300 * np.eye(len(columns))
        step = np.asarray(np.linalg.solve(square, slope[..., None])[..., 0])
        return step, np.sqrt(np.maximum(np.einsum("pk,pk->p", step, slope), 0.0))


def _regular(square: Array) -> Array:
    """Return matrices (planes, q, q) with a small diagonal added, so that they have an inverse."""
    return np.asarray(square + 1e-12 * np.trace(square, axis1=1, axis2=2)[:, None, None] * np.eye(square.shape[1]))


def part_of(values: Array, slopes: Array, chain: Array, stack: Stack, light: Array, threads: int) -> Part:
    """Return likelihood, information and slope of a stack.

    Derivatives by parameters are `chain` (planes, parameters, slopes) times the images `slopes`.
    """
    numbers, products = star_likelihood([values.astype(slopes.dtype), *slopes], light[None], stack.star, threads)
    _, expected, spread = numbers.sum(axis=(-1, -2))
    each, k = products[0], len(slopes)
    flux = light[0][:, None, None]
    inner, cross = _regular(each[:, k : k + 2, k : k + 2]), flux * each[:, :k, k : k + 2]
    carried = np.linalg.solve(inner, cross.swapaxes(1, 2)).swapaxes(1, 2)  # (planes, k, 2)
    # Schur's complement: information on the parameters when the light of each plane is fitted.
    square = flux * flux * each[:, :k, :k] - carried @ cross.swapaxes(1, 2)
    slope = flux[..., 0] * each[:, :k, -1] - np.einsum("pkl,pl->pk", carried, each[:, k : k + 2, -1])
    # Information on the photons with the background eliminated.
    alone = inner[:, 0, 0] - inner[:, 0, 1] ** 2 / inner[:, 1, 1]
    return Part(
        np.einsum("pak,pk->pa", chain, slope),
        chain @ square @ chain.swapaxes(1, 2),
        float(each[:, -1, -1].sum()),
        float(expected),
        float(spread),
        math.sqrt(float((light[0] ** 2 * np.maximum(alone, 0.0)).sum())),
        np.asarray(np.linalg.inv(inner)),
        chain @ carried,
    )
