"""Images of beads filled with emitters."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.methods.layers.disc_means import ETA, Values, disc_means, gauss_error
from lommel.methods.layers.orders import Orders, ProvenMethod, highest, light
from lommel.methods.layers.samples import Samples, disc_filter, light_samples
from lommel.optics.grid import Grid
from lommel.optics.layers.objective_pupil import ObjectivePupil

_NODES_MOST = 200
_DIAMETER_MOST = 1e-5


@dataclass(frozen=True)
class Bead(ProvenMethod):
    r"""A bead uniformly filled with emitters, centred on the emitter of the pupil.

    The ball is integrated over discs: ``3/4 int (1 - u^2) D(u) du`` over -1 to 1, D being the mean PSF over a disc of
    radius ``R sqrt(1 - u^2)`` at the depth ``d + R u``. Gauss's rule for the weight ``1 - u^2`` has a number of
    heights that is proven to suffice.

    Parameters
    ----------
    diameter : float
        Metres, in the sample.
    tol : float, default 1e-6
        Tolerance relative to the peak of each plane.

    Raises
    ------
    TypeError, ValueError
        If one of them is out of range.

    Notes
    -----
    The light is band-limited along the height as well as laterally: fields vary by at most ``k n_s (1 - c)``, and
    decay beyond the critical angle like ``exp(-k n_s kappa h)``, so the sum over heights converges geometrically.
    Refraction by the bead itself is neglected.
    """

    diameter: float
    tol: float = 1e-6

    def __post_init__(self) -> None:
        size = validation.real("diameter", self.diameter, above=0.0, most=_DIAMETER_MOST, unit="metres")
        object.__setattr__(self, "diameter", size)
        super().__post_init__()

    def unsupported(self, pupil: ObjectivePupil) -> str | None:
        """Return the reason where the bead would be in the glass."""
        radius = 0.5 * self.diameter
        near = float(pupil.depth.min())
        if near < radius * (1.0 - 1e-9):
            return f"needs a depth of at least the radius of the bead, {radius:g} metres, got {near:g}"
        return super().unsupported(pupil)

    def _orders(self, pupil: ObjectivePupil, v: Array, asked: float) -> Orders:
        """Return the light at rising v."""
        radius, layers, highest_order = 0.5 * self.diameter, pupil.layers, highest(pupil)
        size = layers.wavenumber * layers.NA * radius
        heights, stack, share, off = self._planes(pupil, asked)
        depths = stack.depth
        half = heights.size // 2
        discs = [disc_means(v, size * float(np.sqrt(1.0 - u * u)), asked, highest_order) for u in heights[half:]]
        discs = discs[: -half - 1 : -1] + discs  # the same below the middle
        places, rows = np.unique(np.concatenate([d.places for d in discs]), return_inverse=True)
        found = light(stack, places, asked, self.tol)
        values_at, errors = found.values.reshape(*depths.shape, -1, places.size), found.error.reshape(depths.shape)
        values: Values = np.zeros(1)
        error, first = np.full(depths.shape[1], off), 0
        for k, means in enumerate(discs):
            here = rows[first : first + means.places.size]
            first += means.places.size
            values = values + share[k, :, None, None] * means.of(values_at[k][..., here])
            error += share[k] * (errors[k] * means.gain + means.error)
        return Orders(values, error)

    def _pixels(self, pupil: ObjectivePupil, grid: Grid, asked: float, threads: int) -> Samples:
        """Return the light at the centres of pixels."""
        size = 0.5 * self.diameter * pupil.layers.wavenumber * pupil.layers.NA
        heights, stack, share, off = self._planes(pupil, asked)
        count = math.prod(pupil.shape)
        values, error = np.zeros((count, *grid.shape)), np.full(count, off)
        # The discs below the middle are those above.
        for k, other in enumerate(range(len(heights) - 1, len(heights) // 2 - 1, -1)):
            means = disc_filter(grid.step(pupil), size * math.sqrt(1.0 - heights[k] ** 2), asked)
            for j in {k, other}:
                plane = replace(pupil, depth=stack.depth[j].reshape(pupil.shape))
                one = means.of(light_samples(plane, means.samples(grid), asked / means.gain, threads), threads)
                values += one.times(share[j]).values
                error += share[j] * one.error
        return Samples(values, error)

    def _planes(self, pupil: ObjectivePupil, asked: float) -> tuple[Array, ObjectivePupil, Array, float]:
        """Return heights, planes at these without aberrations, (heights, n), their shares of light, and an error."""
        heights, weights, off = _rule(self._growth(pupil), asked)
        depths = np.maximum(pupil.depth.ravel() + 0.5 * self.diameter * heights[:, None], 0.0)
        focus, z = (np.broadcast_to(part.ravel(), depths.shape) for part in (pupil.focus, pupil.z))
        stack = replace(pupil, depth=depths, focus=focus, z=z, aberrations=None)
        share = weights[:, None] * stack.power.reshape(depths.shape)
        return heights, stack, share / share.sum(axis=0), off

    def _growth(self, pupil: ObjectivePupil) -> Array:
        """Return the logarithm of how much intensities grow on ellipses of complex heights."""
        layers, radius = pupil.layers, 0.5 * self.diameter
        eta, ratio = ETA, layers.NA / layers.sample
        within = float(1.0 - np.sqrt(max(1.0 - ratio**2, 0.0)))
        fading = float(np.sqrt(max(ratio**2 - 1.0, 0.0)))
        # abs(Im) of the disc is R sinh(eta) abs(cos), that of the height R sinh(eta) abs(sin).
        across = radius * layers.wavenumber * float(np.hypot(2.0 * layers.NA, layers.sample * within))
        return across * np.sinh(eta) + 2.0 * radius * layers.wavenumber * layers.sample * fading * np.cosh(eta)


def _rule(growth: Array, error: float) -> tuple[Array, Array, float]:
    """Return heights, weights that sum to 1, and what sums over them err by: `error`, or more at the most nodes."""
    from scipy.special import roots_jacobi

    nodes = 2
    # Twice: what intensities are divided by is such a sum too.
    while (off := 2.0 * gauss_error(growth, nodes)) > error and nodes < _NODES_MOST:
        nodes += 1
    u, w = roots_jacobi(nodes, 1.0, 1.0)
    return u, w / w.sum(), off
