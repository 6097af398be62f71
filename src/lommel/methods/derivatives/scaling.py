r"""Derivatives of images with respect to their scale, ``v . grad I``, point-sampled or pixel-integrated.

In a pixel around ``v_c`` the position is ``v_c + u``. The average of ``v . grad I`` is ``v_c`` times the average of
``grad I``, given by derivatives by tilts, plus the average of ``u . grad I``, the change of the average as the pixel
itself grows. Along x the latter multiplies the transfer function by ``cos(a w / 2) - sinc(a w / 2)``, the derivative
of the sinc by ln a, and along y by the sinc; there are two such terms.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence

import numpy as np

from lommel.base.arrays import Array
from lommel.core.answers import Images, Wanted
from lommel.methods.choice import first_proven
from lommel.methods.derivative_names import SHIFTS
from lommel.methods.method import Method
from lommel.methods.pixels.averaging import Taps, blocks, filtered_by, finer, least_average, sloping, weighed
from lommel.optics.base_pupil import BasePupil
from lommel.optics.grid import Grid

TILTS = SHIFTS["column"], SHIFTS["row"]
"""Zernike terms that the growth is made of."""

_FINER = 0.1  # of the tolerance, which samples are asked for: their errors are multiplied by some 4


Ask = Callable[[Method, BasePupil, Grid, Wanted], Images]
"""From a method, pupils, pixels and how they are wanted to samples with bounds."""


def _images(method: Method, pupil: BasePupil, grid: Grid, wanted: Wanted) -> Images:
    return method.images(pupil, grid, wanted)


def scaling_derivative(
    engine: Method,
    pupil: BasePupil,
    grid: Grid,
    tilts: Sequence[tuple[Array, Array]],
    threads: int = 0,
    ask: Ask = _images,
) -> tuple[Array, Array]:
    """Return ``v . grad I``, or its averages, from the derivatives of I by the :data:`TILTS`."""
    count, step = math.prod(pupil.shape), grid.step(pupil)
    total, error = np.zeros((count, *grid.shape)), np.zeros(count)
    across, down = (step / grid.side * part for part in grid.positions(pupil.shape))
    for v, (slope, off) in zip((across[:, None, :], down[:, :, None]), tilts, strict=True):
        total -= v * slope
        far = np.abs(v).max(axis=(1, 2))
        error += far * (off + 8.0 * 2.0**-53 * np.abs(slope).max(axis=(1, 2)))
    if grid.integrate:
        values, off = _strain(engine, pupil, grid, threads, ask)
        total += values
        error += off
    return total, error


def _strain(engine: Method, pupil: BasePupil, grid: Grid, threads: int, ask: Ask) -> tuple[Array, Array]:
    """Return averages of ``u . grad I``, u the place in the pixel, and bounds on their errors, absolute."""
    step = grid.step(pupil)
    response = max(1e-3 * engine.tol * least_average(step), 1e-13)
    plain, growing = _alike(filtered_by(step, response), filtered_by(step, response, growing=True))
    # Neither response is larger than 2.
    missed = 2.0 * (2.0 * plain.error + growing.error * (1.0 + plain.error)) * pupil.amplitude**2
    # A phase or an amplitude off by e changes U and its gradient by e int A at most, and u is half a diagonal.
    of_phase, of_light = pupil.left_out
    left = of_phase + 2.0 * of_light
    missed += math.sqrt(8.0) * step * left * (2.0 + left) * pupil.amplitude**2
    count = math.prod(pupil.shape)
    total, error = np.empty((count, *grid.shape)), np.empty(count)
    for part, values, off in _sampled(engine, pupil, grid, plain, threads, ask):
        total[part] = weighed(values, plain, growing, threads)
        total[part] += weighed(values, growing, plain, threads)
        error[part] = 2.0 * plain.gain * growing.gain * off + missed
    return total, error


def tilted(
    engine: Method, pupil: BasePupil, grid: Grid, threads: int = 0, ask: Ask = _images
) -> list[tuple[Array, Array]]:
    """Return the derivatives of I by the :data:`TILTS`, ``-grad I``, from samples of I alone."""
    step = grid.step(pupil)
    response = max(1e-3 * engine.tol * (least_average(step) if grid.integrate else 1.0), 1e-13)
    slope = sloping(step, response, averages=grid.integrate)
    plain = filtered_by(step, response) if grid.integrate else Taps(slope.stride, np.ones(1), 0.0, 1.0)
    slope, plain = _alike(slope, plain)
    # The response to slopes is at most 2, that of averages 1.
    missed = (slope.error * (1.0 + plain.error) + 2.0 * plain.error) * pupil.amplitude**2
    count = math.prod(pupil.shape)
    (across, down), error = np.empty((2, count, *grid.shape)), np.empty(count)
    for part, values, off in _sampled(engine, pupil, grid, plain, threads, ask):
        across[part], down[part] = weighed(values, plain, slope, threads), weighed(values, slope, plain, threads)
        error[part] = plain.gain * slope.gain * off + missed
    return [(-across, error), (-down, error)]


def _sampled(
    engine: Method, pupil: BasePupil, grid: Grid, taps: Taps, threads: int, ask: Ask
) -> Iterator[tuple[slice, Array, Array]]:
    """Yield samples of I for such filters, some pupils at once, and bounds on their errors with those of sums."""
    fine, rounded = engine.tightened(_FINER * engine.tol), (4 * taps.weights.size + 16) * 2.0**-53
    for part, one, pixels in blocks(pupil, grid, taps):
        # Double precision may hold what is asked for, and no less.
        def samples(way: Method, one: BasePupil = one, pixels: Grid = pixels) -> Images:
            return ask(way, one, finer(pixels, taps), Wanted(threads=threads))

        _, made = first_proven((fine, engine), samples)
        yield part, made.values, made.brightest * (made.bound + rounded)


def _alike(one: Taps, other: Taps) -> tuple[Taps, Taps]:
    """Return two filters with as many weights, zeros at the ends of the shorter."""
    size = max(one.weights.size, other.weights.size)
    return tuple(t._replace(weights=np.pad(t.weights, (size - t.weights.size) // 2)) for t in (one, other))  # type: ignore[return-value]
