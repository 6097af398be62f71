"""The Debye-Wolf integral of a microscope by plain quadrature, the reference for stacks through plane layers.

Also the base classes of methods for microscope objectives, and refinement to a tolerance relative to the peak.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from lommel.base.arrays import Array
from lommel.core.answers import Intensities, Samples, Wanted, not_met
from lommel.methods.averaging import averaged_images
from lommel.methods.method import Method, RadialMethod, to_images
from lommel.optics.grid import Grid
from lommel.optics.layers import debye
from lommel.optics.layers.emitter import Harmonic
from lommel.optics.layers.objective_pupil import ObjectivePupil

LEAST = 1e-15  # smallest error of fields that may be requested, close to rounding errors

BRIGHT_RING = 1.8412  # v of the maximum of J1: images that are dark on the axis are bright near this radius


def likely_peak(pupil: ObjectivePupil) -> float:
    """Return an estimate of the peak of I in the most defocused plane, from paraxial defocus alone."""
    layers = pupil.layers
    defocus = pupil.focus - (layers.immersion / layers.sample) * pupil.depth
    largest = abs(defocus.item()) if defocus.size == 1 else float(np.abs(defocus).max())
    # Defocus (radians at the pupil edge) for the distance from the stage focus to the emitter's paraxial image.
    blur = layers.wavenumber * largest * layers.NA**2 / layers.immersion
    return min(0.25, 2.0 / (1.0 + blur**2))


def refine_until(
    compute: Callable[[float], tuple[Array, Array]], target: float, *, start: float, floor: float, tol: float
) -> Intensities:
    """Return intensities, refined until the error bound is at most `target` of the peak of every plane.

    `compute(accuracy)` returns values (n, ...) and bounds on their errors (n,). The accuracy falls from `start` to
    `floor`. If no accuracy suffices, ToleranceError is raised with `tol`, the tolerance that the user requested.
    """
    accuracy = start
    while True:
        values, error = compute(accuracy)
        least_peak = values.reshape(len(values), -1).max(axis=1) - error  # lower bound on the exact peak
        relative = np.divide(error, least_peak, out=np.full(least_peak.shape, np.inf), where=least_peak > 0.0)
        if (worst_error := float(relative.max(initial=0.0))) <= target:
            return Intensities(values, relative, least_peak)
        if accuracy <= floor:
            raise not_met(tol, worst_error, "the peak")
        accuracy = max(floor, accuracy * max(1e-4, min(0.5, 0.5 * target / worst_error)))


class LayeredMethod(Method[ObjectivePupil]):
    """Base class of methods for the pupils of objectives; its subclasses are dataclasses with a field `tol`."""

    pupils = "objective"
    apodized = nonradial = True


class AberratedMethod(LayeredMethod):
    """Base class of methods for objectives with aberrations, whose pixel averages are computed from samples."""

    tol: float

    def unsupported(self, pupil: ObjectivePupil) -> str | None:
        """Return the reason why `pupil` is not supported, or None."""
        return None if pupil.aberrated else "supports pupils with aberrations only; use Stratified or DebyeWolf"

    def intensity(self, pupil: ObjectivePupil, grid: Grid, threads: int) -> Intensities:
        """Return I on the pixels of `grid`."""
        return self.images(pupil, grid, Wanted(threads=threads)).intensities

    def images(self, pupil: ObjectivePupil, grid: Grid, wanted: Wanted) -> Samples:
        """Return the images of the flattened stack; see :meth:`lommel.methods.Method.images`."""
        if wanted.powers or wanted.terms:
            raise ValueError("derivatives by phases are not available for the pupils of an Objective")
        return averaged_images(self._samples, pupil, grid, self.tol, wanted)

    def _samples(self, pupil: ObjectivePupil, grid: Grid, tol: float, wanted: Wanted) -> Samples:
        """Return point samples at the centres of the pixels of `grid`, to `tol` of the peak."""
        raise NotImplementedError


@dataclass(frozen=True)
class DebyeWolf(LayeredMethod, RadialMethod[ObjectivePupil]):
    r"""Debye-Wolf integral of an objective by Gauss-Legendre quadrature over angles, at every radius.

    Supports the pupils of :meth:`lommel.Objective.pupil` only. Each distinct radius is integrated separately, without
    interpolation. The number of angles follows from a proven error bound.

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
        """Return the reason why `pupil` is not supported, or None."""
        return "supports no aberrations except those of the layers; use DebyeRings" if pupil.aberrated else None

    def profile(self, pupil: ObjectivePupil, v: Array) -> Intensities:
        """Return I at ascending v, with errors relative to the computed peak."""
        # An additional radius at which images that are dark on the axis are bright, for the estimate of the peak.
        profile = self._refine(pupil, np.append(v, BRIGHT_RING), lambda orders: orders[0], self.tol)
        return profile._replace(values=profile.values[:, :-1])

    def intensity(self, pupil: ObjectivePupil, grid: Grid, threads: int) -> Intensities:
        """Return I at the distinct radii of `grid` if I is radially symmetric and centred, else at its pixels."""
        if grid.integrate and pupil.radial:
            return self.on_pixels(pupil, grid, threads)
        if grid.integrate:
            return self.images(pupil, grid, Wanted(threads=threads)).intensities
        if grid.symmetric and pupil.radial:
            return self.profile(pupil, grid.v(pupil))
        return self._centres(pupil, grid, self.tol)

    def images(self, pupil: ObjectivePupil, grid: Grid, wanted: Wanted) -> Samples:
        """Return the images of the flattened stack; see :meth:`lommel.methods.Method.images`."""
        if pupil.radial or not grid.integrate or wanted.terms or wanted.powers:
            return super().images(pupil, grid, wanted)
        return averaged_images(self._samples, pupil, grid, self.tol, wanted)

    def _samples(self, pupil: ObjectivePupil, grid: Grid, tol: float, wanted: Wanted) -> Samples:
        """Return point samples at the centres of the pixels of `grid`, to `tol` of the peak."""
        return to_images(self._centres(pupil, grid, max(tol, LEAST)), grid, wanted)

    def _centres(self, pupil: ObjectivePupil, grid: Grid, tol: float) -> Intensities:
        """Return I at pixel centres; if each plane of the grid has its own axis, planes are computed one by one."""
        if not grid.stack:
            return self._sample_centres(pupil, grid, tol)
        planes = [self._sample_centres(pupil[k], grid[k], tol) for k in np.ndindex(pupil.shape)]
        values, error, peak = (np.concatenate(part) for part in zip(*planes, strict=True))
        return Intensities(values, error, peak)

    def _sample_centres(self, pupil: ObjectivePupil, grid: Grid, tol: float) -> Intensities:
        """Return I at the centres of pixels around a common axis."""
        # Pixels at equal distance from the axis share their integrals.
        x, y = np.broadcast_arrays(grid.x, grid.y[:, None])
        radius, index = np.unique(np.hypot(x, y), return_inverse=True)
        azimuth = np.arctan2(y, x)

        def with_azimuth(orders: Array) -> Array:
            total = np.zeros((orders.shape[1], *grid.shape))
            for h, values in zip(pupil.light.harmonics, orders, strict=True):
                factor = h.cosine * np.cos(h.order * azimuth) + h.sine * np.sin(h.order * azimuth)
                total += values[:, index.reshape(grid.shape)] * factor
            return np.maximum(total, 0.0)

        return self._refine(pupil, pupil.v(radius), with_azimuth, tol)

    def _refine(
        self, pupil: ObjectivePupil, v: Array, intensities: Callable[[Array], Array], tol: float
    ) -> Intensities:
        """Return `intensities` of the azimuthal orders at v, with an error of at most `tol` of the peak."""

        def compute(field_tol: float) -> tuple[Array, Array]:
            orders, error = harmonics(pupil, v, field_tol)
            return intensities(orders), error

        return refine_until(compute, tol, start=0.02 * tol, floor=LEAST, tol=self.tol)


def harmonics(pupil: ObjectivePupil, v: Array, tol: float) -> tuple[Array, Array]:
    """Return the azimuthal orders of I at ascending v, ``(orders, n, radii)``, from fields with errors below `tol`.

    The second array, ``(n,)``, has bounds on the error of the intensity at any azimuth.
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
    """Bound the error of a harmonic, (n,), from field components with moduli `brightest` and this `error`.

    `brightest` has the shape (components, n).
    """
    # g of section 15: e (abs(F_j) + abs(F_l) + e) for each entry of H.
    sizes = np.abs(harmonic.form) * np.hypot(harmonic.cosine, harmonic.sine)
    a, b = brightest[:, None], brightest[None]
    return np.asarray(np.einsum("jl,jln->n", sizes, error * (a + b + error)))
