"""The Debye-Wolf integral of a microscope by plain quadrature, the reference for stacks through plane layers.

And the base class of the methods for microscope objectives, with refinement to a tolerance relative to the peak.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from lommel.base.arrays import Array
from lommel.core.answers import Images, Intensities, Wanted, not_met
from lommel.methods.averaging import averaged_images
from lommel.methods.method import Method, RadialMethod, to_images
from lommel.optics.grid import Grid
from lommel.optics.layers import debye
from lommel.optics.layers.emitter import Harmonic
from lommel.optics.layers.objective_pupil import ObjectivePupil

LEAST = 1e-15  # what fields are asked for at the finest

BRIGHT_RING = 1.8412  # the maximum of J1 in v: light that is dark on the axis is bright here


def likely_peak(pupil: ObjectivePupil) -> float:
    """Return about what light is at its peak in the darkest plane, spread over where paraxial rays arrive."""
    layers = pupil.layers
    off = pupil.focus - (layers.immersion / layers.sample) * pupil.depth
    away = abs(off.item()) if off.size == 1 else float(np.abs(off).max())
    # The paraxial defocus in radians at the edge: focus less the place of the image of the emitter.
    blur = layers.wavenumber * away * layers.NA**2 / layers.immersion
    return min(0.25, 2.0 / (1.0 + blur**2))


def refine_until(
    compute: Callable[[float], tuple[Array, Array]], tol: float, *, start: float, floor: float, named: float
) -> Intensities:
    """Return intensities of accuracies from `start` down to `floor`, the first whose error over the peak is `tol`.

    `compute` returns values, (n, ...), and bounds on their errors, (n,). ToleranceError names the tolerance `named`.
    """
    accuracy = start
    while True:
        values, error = compute(accuracy)
        lowest = values.reshape(len(values), -1).max(axis=1) - error
        relative = np.divide(error, lowest, out=np.full(lowest.shape, np.inf), where=lowest > 0.0)
        if (worst := float(relative.max(initial=0.0))) <= tol:
            return Intensities(values, relative, lowest)
        if accuracy <= floor:
            raise not_met(named, worst, "the peak")
        accuracy = max(floor, accuracy * max(1e-4, min(0.5, 0.5 * tol / worst)))


class LayeredMethod(Method[ObjectivePupil]):
    """A method for the pupils of objectives; dataclasses of it have a `tol`."""

    pupils = "objective"
    apodized = nonradial = True


class AberratedMethod(LayeredMethod):
    """One for those with aberrations, by samples: averages over pixels are made of these."""

    tol: float

    def unsupported(self, pupil: ObjectivePupil) -> str | None:
        """Return why `pupil` is not supported, or None if it is."""
        return None if pupil.aberrated else "supports aberrations only; without these use Stratified or DebyeWolf"

    def intensity(self, pupil: ObjectivePupil, grid: Grid, threads: int = 0) -> Intensities:
        """Return I on the pixels of `grid`."""
        return self.images(pupil, grid, Wanted(threads=threads)).intensities

    def images(self, pupil: ObjectivePupil, grid: Grid, wanted: Wanted) -> Images:
        """Return the images of the flattened stack; see :meth:`lommel.Method.images`."""
        if wanted.powers or wanted.terms:
            raise ValueError("derivatives by phases are not available of the pupils of an Objective")
        return averaged_images(self._samples, pupil, grid, self.tol, wanted)

    def _samples(self, pupil: ObjectivePupil, grid: Grid, tol: float, wanted: Wanted) -> Images:
        raise NotImplementedError


@dataclass(frozen=True)
class DebyeWolf(LayeredMethod, RadialMethod[ObjectivePupil]):
    r"""Debye-Wolf integral of an objective by Gauss-Legendre quadrature over angles, at every radius.

    Supports the pupils of :meth:`lommel.Objective.pupil` only. Each distinct radius is integrated separately, without
    interpolation; the number of angles is proven to suffice.

    Parameters
    ----------
    tol : float, default 1e-6
        Tolerance relative to the peak of each plane.

    Raises
    ------
    TypeError, ValueError
        If `tol` is out of range.

    References
    ----------
    P. Torok et al., J. Opt. Soc. Am. A 12, 325 (1995), doi:10.1364/JOSAA.12.000325.
    """

    tol: float = 1e-6

    def unsupported(self, pupil: ObjectivePupil) -> str | None:
        """Return why `pupil` is not supported, or None if it is."""
        return "supports no aberrations on top of those of layers; use DebyeRings" if pupil.aberrated else None

    def profile(self, pupil: ObjectivePupil, v: Array) -> Intensities:
        """Return I at rising v; its bound is checked against the peak that was found."""
        # Light that is dark on the axis is bright here: errors relate to the peak, wherever that is.
        made = self._proven(pupil, np.append(v, BRIGHT_RING), lambda values: values[0], self.tol)
        return made._replace(values=made.values[:, :-1])

    def intensity(self, pupil: ObjectivePupil, grid: Grid, threads: int = 0) -> Intensities:
        """Return I at the distinct radii of `grid`, or on its pixels where these share none."""
        if grid.integrate and pupil.radial:
            return self.on_pixels(pupil, grid, threads)
        if grid.integrate:
            return self.images(pupil, grid, Wanted(threads=threads)).intensities
        if grid.symmetric and pupil.radial:
            return self.profile(pupil, grid.v(pupil))
        return self._centres(pupil, grid, self.tol)

    def images(self, pupil: ObjectivePupil, grid: Grid, wanted: Wanted) -> Images:
        """Return the images of the flattened stack; see :meth:`lommel.Method.images`."""
        if pupil.radial or not grid.integrate or wanted.terms or wanted.powers:
            return super().images(pupil, grid, wanted)
        return averaged_images(self._samples, pupil, grid, self.tol, wanted)

    def _samples(self, pupil: ObjectivePupil, grid: Grid, tol: float, wanted: Wanted) -> Images:
        return to_images(self._centres(pupil, grid, max(tol, LEAST)), grid, wanted)

    def _centres(self, pupil: ObjectivePupil, grid: Grid, tol: float) -> Intensities:
        """Return I at the centres of pixels, around one axis or one for each plane."""
        if not grid.stack:
            return self._sampled(pupil, grid, tol)
        alone = [self._sampled(pupil[k], grid[k], tol) for k in np.ndindex(pupil.shape)]
        values, error, peak = (np.concatenate(part) for part in zip(*alone, strict=True))
        return Intensities(values, error, peak)

    def _sampled(self, pupil: ObjectivePupil, grid: Grid, tol: float) -> Intensities:
        # Pixels at one distance share their integrals.
        x, y = np.broadcast_arrays(grid.x, grid.y[:, None])
        radius, place = np.unique(np.hypot(x, y), return_inverse=True)
        azimuth = np.arctan2(y, x)

        def turned(orders: Array) -> Array:
            total = np.zeros((orders.shape[1], *grid.shape))
            for h, values in zip(pupil.light.harmonics, orders, strict=True):
                around = h.cosine * np.cos(h.order * azimuth) + h.sine * np.sin(h.order * azimuth)
                total += values[:, place.reshape(grid.shape)] * around
            return np.maximum(total, 0.0)

        return self._proven(pupil, pupil.v(radius), turned, tol)

    def _proven(self, pupil: ObjectivePupil, v: Array, made_of: Callable[[Array], Array], tol: float) -> Intensities:
        """Return intensities made of harmonics that are exact enough for the peak that is found."""

        def at(fields: float) -> tuple[Array, Array]:
            values, error = harmonics(pupil, v, fields)
            return made_of(values), error

        return refine_until(at, tol, start=0.02 * tol, floor=LEAST, named=self.tol)


def harmonics(pupil: ObjectivePupil, v: Array, tol: float) -> tuple[Array, Array]:
    """Return orders of the azimuth of I at rising v, ``(orders, n, radii)``, by fields that are exact to `tol`.

    And bounds on the error of any intensity of these, ``(n,)``.
    """
    light, depth, focus = pupil.light, pupil.depth.ravel(), pupil.focus.ravel()
    rule = debye.rule(pupil.layers, light.model, depth, focus, float(v.max(initial=0.0)), tol)
    parts = np.stack(debye.fields(rule, light.model, depth, focus, v))
    # h = sum H_jl F_j conj(F_l): certificate, section 15.
    forms = [np.einsum("jl,jnr,lnr->nr", h.form, parts, parts.conj()).real for h in light.harmonics]
    brightest = np.abs(parts).max(axis=2)
    error = sum((_form_error(h, brightest, rule.error) for h in light.harmonics), np.zeros(depth.size))
    return np.stack(forms) / pupil.power[:, None], error / pupil.power * (1.0 + 1e-12) + 2.0**-50


def _form_error(harmonic: Harmonic, brightest: Array, error: float) -> Array:
    """Bound the error of a harmonic whose parts, at most so bright, are each off by `error`."""
    # g of section 15: e (abs(F_j) + abs(F_l) + e) for each entry of H.
    sizes = np.abs(harmonic.form) * np.hypot(harmonic.cosine, harmonic.sine)
    one, other = brightest[:, None], brightest[None]
    return np.asarray(np.einsum("jl,jln->n", sizes, error * (one + other + error)))
