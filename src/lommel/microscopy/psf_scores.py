"""Score tests of PSFs with one changed parameter, at a specimen that was restored with the stated PSF.

The image ``m = H(t) x + b`` of a specimen x and a background b has the slope ``d = (dH/dt) x`` along a parameter t.
What another specimen, other light beyond it or another background would explain of d is eliminated: the rest e is d
minus its projection on the images of such changes, in units of the noise, by a few steps of conjugate gradients. With
the residual r, lnL changes by ``g c - I c^2 / 2`` for a change c of t, where ``g = e r`` and ``I = e e`` (C. R. Rao,
doi:10.1017/S0305004100023987). It has its maximum at ``g / I``, with the standard error ``1 / sqrt(I)``.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from lommel.base.arrays import Values
from lommel.deconvolve.iterations import State
from lommel.deconvolve.likelihood import PoissonLikelihood
from lommel.deconvolve.linear import PlaneOperator

_STEPS = 5  # of conjugate gradients: with twice as many, estimates of right indices changed by less than their errors


class Score(NamedTuple):
    """Slope g of lnL along a parameter of the PSF, and the information I on it."""

    slope: float
    information: float

    @property
    def change(self) -> float:
        """Change of the parameter with the largest lnL."""
        return self.slope / self.information

    @property
    def error(self) -> float:
        """Standard error of `change`."""
        return 1.0 / math.sqrt(self.information)

    @property
    def deviance(self) -> float:
        """Decrease of the deviance by `change`: its square in standard errors."""
        return self.slope * self.change

    def gain(self, change: float) -> tuple[float, float]:
        """Return the increase of lnL by a change of the parameter, and its standard error."""
        return self.slope * change - 0.5 * self.information * change**2, abs(change) / self.error


class PSFScores:
    """Score tests of PSFs by counts, at a specimen restored with one blur."""

    def __init__(self, blur: PlaneOperator, counted: PoissonLikelihood, state: State, background: float) -> None:
        assert state.light is not None
        self._blur, self._state, self._pixels = blur, state, int(np.prod(blur.shape))
        counted.set_background(np.full((1, 1), background))
        self._image = self._imaged(blur, state)
        height, width = (slice(0, side) for side in blur.shape[1:])
        parts = [counted.whitened(k, height, width, image)[1:] for k, image in enumerate(self._image)]
        self._residual, self._scale = (np.stack(values) for values in zip(*parts, strict=True))
        # As in Richardson-Lucy steps, changes are in proportion to the light, and to 1 / (A^T w).
        blur.weigh(1.0)
        rows, columns = (slice(0, side) for side in blur.whole[1:])
        per_seen = np.stack([blur.per_seen(k, rows, columns) for k in range(blur.whole[0])])
        outside = np.zeros(0, np.float32) if state.outside is None else state.outside * blur.per_outside
        level = np.full(1, background / self._pixels, np.float32)
        self._weights = np.concatenate([(state.light * per_seen).ravel(), outside, level])

    @property
    def chi2(self) -> float:
        """Mean square of the residual of the voxels that are not ignored."""
        return float(np.vdot(self._residual, self._residual)) / int((self._scale > 0.0).sum())

    def of(self, blur: PlaneOperator, change: float) -> Score | None:
        """Return the score along the parameter whose `change` gives `blur`, or None if it does not change images."""
        rest = (self._imaged(blur, self._state) - self._image) * (self._scale / np.float32(change))
        least = 1e-6 * float(np.vdot(self._scale * self._image, self._scale * self._image))
        if float(np.vdot(rest, rest)) * change**2 <= least:
            return None
        direction, last = np.zeros_like(self._weights), math.inf
        for _ in range(_STEPS):
            gradient = self._transposed(rest)
            weighted = self._weights * gradient
            square = float(np.vdot(gradient, weighted))
            direction = weighted + np.float32(square / last) * direction
            image, last = self._changed(direction), square
            rest -= np.float32(square / max(float(np.vdot(image, image)), 1e-30)) * image
        return Score(float(np.vdot(rest, self._residual)), float(np.vdot(rest, rest)))

    def _imaged(self, blur: PlaneOperator, state: State) -> Values:
        """Return the image of a specimen and of the light beyond it."""
        assert state.light is not None
        image = np.empty(blur.shape, np.float32)

        def store(plane: int, rows: slice, columns: slice, values: Values) -> None:
            image[plane, rows, columns] = values

        if state.outside is not None:
            blur.outside = state.outside
        blur.forward(state.light, store)
        return image

    def _changed(self, unknowns: Values) -> Values:
        """Return the change of the image, in units of the noise, by a change of specimen, light beyond and level."""
        light, outside = np.split(unknowns[:-1], [math.prod(self._blur.whole)])
        state = State(light.reshape(self._blur.whole), outside if len(outside) else None)
        return np.asarray((self._imaged(self._blur, state) + unknowns[-1]) * self._scale)

    def _transposed(self, image: Values) -> Values:
        """Apply the transpose of :meth:`_changed`."""
        scaled, result = image * self._scale, np.empty_like(self._weights)
        light = result[: math.prod(self._blur.whole)].reshape(self._blur.whole)

        def store(plane: int, rows: slice, columns: slice, values: Values) -> None:
            light[plane, rows, columns] = values

        self._blur.adjoint(scaled, store)
        if self._state.outside is not None:
            result[light.size : -1] = self._blur.outside_back
        result[-1] = scaled.sum(dtype=np.float64)
        return result
