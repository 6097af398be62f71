r"""Averages over the pixels of a sensor for any pupil: finer samples, filtered.

A pixel averages the intensity over its square, which multiplies the transfer function by ``sinc(a wx / 2)`` and
``sinc(a wy / 2)``, a the pitch in v. The transfer function vanishes beyond ``|w| = 2``, so any taps c_k on samples
h apart whose response ``C(w) = sum_k c_k cos(k h w)`` agrees with the sinc up to there do the same, along rows and
then along columns. An error eps of the response costs at most ``(2 eps + eps^2) int |OTF| dw``, an integral that is
at most the intensity at the peak without aberration, where the transfer function is nowhere negative.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import DTypeLike, NDArray

from lommel.core.answers import Images, Intensities, ToleranceError, Wanted, not_met
from lommel.methods.method import normalized_error, stored, storing
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil

_SIDE = 2048  # samples along a side at once
_VALUES = 2**23  # samples at once
_WIDEST = 0.8  # v between samples: half of what the band of I allows
_MOST = 512  # samples across a pixel


Sample = Callable[[Pupil, Grid, float], Images]
"""From pupils, pixels and a tolerance to the intensity at their centres in double precision."""


def averaged(
    sample: Sample, pupil: Pupil, grid: Grid, tol: float, *, normalize: bool, dtype: DTypeLike = np.float64
) -> Intensities:
    """Return the intensity averaged over each pixel, with bounds on its error below `tol` once stored as `dtype`.

    The error is over the largest average that a pixel has anywhere, or, with `normalize`, that of values divided by
    the largest average in the window.

    Raises
    ------
    ToleranceError
        If the bound stays above `tol`.
    """
    step, ceiling = grid.step(pupil), pupil.amplitude**2
    lowest = least_average(step)
    # Values divided by their own largest one are off by twice as much.
    aim = (0.4 if normalize else 1.0) * (tol - (1.0 + tol) * storing(dtype))
    # As if the largest average were a few times the least it can be, and the peak not faint.
    finer, response = 0.5 * aim * min(4.0 * lowest, 1.0), 2e-3 * aim * lowest
    for _ in range(5):
        taps = filtered_by(step, response)
        try:
            total, given, peaks = _filtered(sample, pupil, grid, finer / taps.gain**2, taps)
        except ToleranceError as fault:
            raise ToleranceError(
                f"tol={tol:g} cannot be met by averages over pixels of {step / math.pi:.3g} lambda*N, for which "
                f"samples must be exact to {finer:.2g} of the peak: {fault}"
            ) from None
        tops = total.max(axis=(1, 2))
        rounding = (2 * taps.weights.size + 8) * 2.0**-53 * taps.gain**2 * peaks
        own = (2.0 + taps.error) * taps.error * ceiling + rounding
        found = tops if normalize else np.maximum(tops, lowest * peaks)
        if not found.min() > 0:
            break
        relative = (given + own) / found
        bounds = stored(normalized_error(relative) if normalize else relative, dtype)
        if bounds.max() <= tol:
            return Intensities(total, bounds, found)
        finer *= min(1.0, 0.5 * aim / float((given / found).max()))
        response *= min(1.0, 0.2 * aim / float((own / found).max()))
    raise not_met(tol, 1.0 if not found.min() > 0 else float(bounds.max()), "the largest value in the window")


def averaged_images(sample: Sample, pupil: Pupil, grid: Grid, tol: float, wanted: Wanted) -> Images:
    """Return finished images of :func:`averaged` pixels, as :meth:`lommel.methods.method.Method.images` does."""
    made = averaged(sample, pupil, grid, tol, normalize=wanted.scale is None, dtype=wanted.dtype)
    tops = made.values.max(axis=(1, 2))
    scales = 1.0 / tops if wanted.scale is None else np.full(len(tops), wanted.scale)
    values = np.empty(made.values.shape, wanted.dtype) if wanted.out is None else wanted.out
    np.multiply(made.values, scales[:, None, None], out=values, casting="same_kind")
    return Images(values, scales, made.error, None, made.peak)


def least_average(step: float) -> float:
    """Return what the best placed pixel of pitch `step` in v averages at least, over the peak of I.

    ``f = 2 I - M``, M the peak, is of exponential type 2 along a line through it and within M, so
    ``f'^2 + 4 f^2 <= 4 M^2`` (Duffin and Schaeffer, Bull. Amer. Math. Soc. 44, 236, 1938): at a distance s below pi/2
    from the peak ``I >= M cos(s)^2``. The pixel around the peak holds a disc of half its pitch.
    """
    r = min(0.5 * step, 0.5 * math.pi)
    return 0.5 * math.pi * (r * r + r * math.sin(2.0 * r) - math.sin(r) ** 2) / step**2


class Taps(NamedTuple):
    """A filter that averages over pixels, along one axis.

    Attributes
    ----------
    stride : int
        Samples a pixel.
    weights : ndarray, shape (2 k + 1,)
        Of the samples from k before to k after the middle of the pixel.
    error : float
        Bound on ``|C(w) - sinc(a w / 2)|`` for ``|w| <= 2``.
    gain : float
        Sum of the magnitudes of the weights: what errors of samples are multiplied by at most.
    """

    stride: int
    weights: NDArray[np.float64]
    error: float
    gain: float


def samples_across(step: float) -> int:
    """Return how many samples a pixel of pitch `step` in v takes along an axis."""
    count = max(1, math.ceil(step / _WIDEST))
    if count > _MOST:
        raise ValueError(
            f"pixel must be at most {_MOST * _WIDEST / math.pi:.0f} lambda*N to average a pupil that is not radially "
            f"symmetric over it, got {step / math.pi:.4g} lambda*N; take smaller pixels, and average blocks of them"
        )
    return count


@lru_cache(maxsize=64)
def filtered_by(step: float, error: float) -> Taps:
    """Return the shortest filter for pixels of pitch `step` in v whose response errs by at most `error`.

    Weights by least squares at Chebyshev points of the band. The error of the response is even and entire, of type
    k h; all but 1e-17 of it is a polynomial in w of degree ``M = 2.36 k h + 48`` (its Chebyshev series falls below
    ``e^-48`` there). As a trigonometric polynomial of the angle it falls from its largest value no faster than
    ``cos(M s)`` (as in :func:`least_average`), and one of 2 M Chebyshev points is within ``pi / (4 M)`` of that: it
    is at most sqrt(2) times as large as at these points.
    """
    stride = samples_across(step)
    h = step / stride
    half = stride // 2 + 2
    while True:
        degree = math.ceil(2.36 * half * h) + 48
        w = 2.0 * np.cos((np.arange(degree) + 0.5) * (0.5 * math.pi / degree))
        basis = 2.0 * np.cos(np.outer(w, h * np.arange(half + 1)))
        basis[:, 0] = 1.0
        wanted = np.sinc(0.5 * step / math.pi * w)
        c, *_ = np.linalg.lstsq(basis, wanted, rcond=1e-13)
        gain = float(abs(c[0]) + 2.0 * np.abs(c[1:]).sum())
        rounding = 2.0**-52 * (half + 4) * gain
        reached = math.sqrt(2.0) * (float(np.abs(basis @ c - wanted).max()) + rounding) + 1e-17
        # Few samples beyond the edge of a large pixel need large weights, which would magnify errors.
        if (reached <= error and gain <= 1.5) or half > stride + 60:
            return Taps(stride, np.concatenate([c[:0:-1], c]), reached, gain)
        half += 1


def _filtered(
    sample: Sample, pupil: Pupil, grid: Grid, tol: float, taps: Taps
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Return averages, the errors that those of the samples make of them, and peaks, of the flattened stack."""
    count = math.prod(pupil.shape)
    total, error, peaks = np.empty((count, *grid.shape)), np.zeros(count), np.zeros(count)
    values = math.prod(min(_SIDE, n * taps.stride + taps.weights.size) for n in grid.shape)
    for part, one in _blocks(pupil, max(1, _VALUES // values)):

        def samples(fine: Grid, part: slice = part, one: Pupil = one) -> NDArray[np.float64]:
            made = sample(one, fine, tol)
            assert made.error is not None
            assert made.peak is not None
            error[part] = np.maximum(error[part], taps.gain**2 * made.error * made.peak)
            peaks[part] = np.maximum(peaks[part], made.peak * (1.0 - made.error))
            return made.values

        total[part] = filtered(samples, grid, taps)
    return total, error, peaks


def filtered(samples: Callable[[Grid], NDArray[np.float64]], grid: Grid, taps: Taps) -> NDArray[np.float64]:
    """Return averages over the pixels of `grid`, shape (n, height, width), tile by tile of finer samples."""
    side = max(1, (_SIDE - taps.weights.size) // taps.stride + 1)
    rows = []
    for y in range(0, grid.height, side):
        row = []
        for x in range(0, grid.width, side):
            fine = _fine(grid, slice(y, min(y + side, grid.height)), slice(x, min(x + side, grid.width)), taps)
            average = _apply(taps, _apply(taps, samples(fine), axis=1), axis=2)
            # No average of an intensity is negative, and none less exact for it.
            row.append(np.maximum(average, 0.0))
        rows.append(np.concatenate(row, axis=2))
    return np.concatenate(rows, axis=1)


def _fine(grid: Grid, rows: slice, columns: slice, taps: Taps) -> Grid:
    """Return the samples that the averages over part of the pixels take."""
    margin = taps.weights.size // 2
    shape = tuple((part.stop - part.start - 1) * taps.stride + taps.weights.size for part in (rows, columns))
    center = tuple(
        (at - part.start) * taps.stride + margin for at, part in zip(grid.center, (rows, columns), strict=True)
    )
    return Grid(shape, grid.pixel / taps.stride, center=center)


def _apply(taps: Taps, samples: NDArray[np.float64], axis: int) -> NDArray[np.float64]:
    """Filter along an axis, one value a pixel; bound by memory, one pass a tap."""
    lines = np.moveaxis(samples, axis, 0)
    pixels = (len(lines) - taps.weights.size) // taps.stride + 1
    total = np.zeros((pixels, *lines.shape[1:]))
    for k, weight in enumerate(taps.weights):
        total += weight * lines[k : k + (pixels - 1) * taps.stride + 1 : taps.stride]
    return np.moveaxis(total, 0, axis)


def _blocks(pupil: Pupil, size: int) -> Iterator[tuple[slice, Pupil]]:
    """Return parts of a stack, at most `size` pupils each, and where they are in the flattened stack."""
    count = math.prod(pupil.shape)
    if count <= size:
        yield slice(0, count), pupil
        return
    for first in range(0, count, size):
        part = slice(first, min(first + size, count))
        yield part, pupil[np.unravel_index(np.arange(part.start, part.stop), pupil.shape)]
