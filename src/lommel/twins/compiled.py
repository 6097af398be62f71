"""Intensities of the rule of chords by the compiled core, where a framework computes at once and on a processor.

Each step of PyTorch is a pass over the memory, and its products of small matrices alone take as long as the core.
So where nothing but values or a first gradient is asked for, the core sums over the same chords and nodes. It is for
float32 alone: what the core loses there is less than what is counted for the framework (docs/certificate.md), so that
bounds stay what they are.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.core.engine import DiskStack, Window, chordal_sums, chordal_sums_gradient
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil
from lommel.twins.namespaces import Namespace

_DEGREE = 30  # what rounding to parts of a turn adds rises with the number of terms


class Sums(NamedTuple):
    """Which sums they are.

    Attributes
    ----------
    terms : tuple of (n, m)
    stretch : float
        That coefficients and pitch are multiplied by.
    obscuration : float
    exponent : tuple of float
        Of the amplitude.
    shape : (int, int)
        Rows and columns.
    axis : (float, float)
        Row and column of the axis.
    step : float
        Pitch in v.
    chords, nodes : int
    """

    terms: tuple[tuple[int, int], ...]
    stretch: float
    obscuration: float
    exponent: tuple[float, ...]
    shape: tuple[int, int]
    axis: tuple[float, float]
    step: float
    chords: int
    nodes: int

    def _asked(self, c: Array) -> tuple[DiskStack, Window, tuple[int, int]]:
        edge = np.multiply(c, self.stretch, dtype=np.float64, order="C")
        terms, exponent = np.array(self.terms, dtype=np.int32), np.array(self.exponent)
        window = Window(self.shape, self.axis, self.stretch * self.step)
        return DiskStack(terms, edge, self.obscuration, exponent), window, (self.chords, self.nodes)

    def intensity(self, c: Array, threads: int) -> NDArray[np.float32]:
        """Return I of pupils `c`, shape ``(n, columns * rows)``, columns one after another."""
        return chordal_sums(*self._asked(c), threads).reshape(len(c), -1)

    def gradient(self, c: Array, weights: Array, threads: int) -> Array:
        """Return the derivatives by `c` of the sum of weights times what :meth:`intensity` returns."""
        by_row = weights.reshape(len(c), *self.shape[::-1]).transpose(0, 2, 1)
        by_row = np.ascontiguousarray(by_row, dtype=np.float64)
        return self.stretch * chordal_sums_gradient(*self._asked(c), by_row, threads)


def of(pupil: Pupil, grid: Grid, stretch: float, terms: tuple[Any, ...], counts: tuple[int, int]) -> Sums | None:
    """Return the sums of samples of square pixels by so many chords and nodes; None where the core has none such."""
    if grid.integrate or not isinstance(grid.pixel, float) or not all(0 < n <= _DEGREE for n, _ in terms):
        return None
    light = tuple(pupil.illumination.exponent.tolist())
    return Sums(terms, stretch, pupil.obscuration, light, grid.shape, grid.axis, grid.step(pupil), *counts)


def intensity(ns: Namespace, sums: Sums | None, c: Any, followed: Callable[[Any], Any]) -> Any:
    """Return what `followed` makes of coefficients `c`, by the sums where it need not be followed step by step."""
    values = ns.values_now(c) if sums and len(c) else None
    if sums is None or values is None:
        return followed(c)
    if ns.name == "numpy":
        return sums.intensity(values, 0)
    return _of_torch().apply(c, sums, followed)


@cache
def _of_torch() -> Any:
    import torch

    ns = Namespace.of("torch")

    class Compiled(torch.autograd.Function):  # type: ignore[misc]
        """The sums with their gradient; that has its own from the steps of PyTorch."""

        @staticmethod
        def forward(ctx: Any, c: Any, sums: Sums, followed: Callable[[Any], Any]) -> Any:
            ctx.save_for_backward(c)
            ctx.sums, ctx.followed = sums, followed
            return torch.from_numpy(sums.intensity(c.detach().numpy(), torch.get_num_threads()))

        @staticmethod
        def backward(ctx: Any, weights: Any) -> tuple[Any, None, None]:
            (c,) = ctx.saved_tensors
            given = None if torch.is_grad_enabled() else ns.values_now(weights)
            if given is not None:
                found = ctx.sums.gradient(c.detach().numpy(), given, torch.get_num_threads())
                return torch.from_numpy(found).to(c.dtype), None, None
            with torch.enable_grad():
                made = ctx.followed(c)
            return *torch.autograd.grad(made, c, weights, create_graph=torch.is_grad_enabled()), None, None

    return Compiled
