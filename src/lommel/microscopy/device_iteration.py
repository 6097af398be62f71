"""Richardson-Lucy steps on the device of an array: operators and iteration by the array API (CuPy, PyTorch)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from lommel.base.arrays import Array, Values
from lommel.deconvolve.iterations import MAX_GROWTH, STRIDE, Background, Iteration, StepSettings
from lommel.deconvolve.likelihood import MAX_RATIO, TINY, PoissonLikelihood
from lommel.deconvolve.linear import PlaneOperator
from lommel.microscopy.stack_blur import PlaneBlur, TiledBlur, WideBlur
from lommel.traced.namespaces import Placement


class DeviceIteration(Iteration):
    """Richardson-Lucy steps of a stack with all arrays on a device, each operation on all planes together.

    Rules, background and light beyond the margin are those of :class:`Iteration`, on the host.
    """

    def __init__(
        self,
        place: Placement,
        blur: PlaneOperator,
        counted: PoissonLikelihood,
        course: Sequence[StepSettings] | None = None,
        *,
        background: Background,
    ) -> None:
        super().__init__(blur, counted, course, background=background)
        self._place = place
        self._xp: Any = place.namespace.xp
        self._operator = _wide(place, blur) if isinstance(blur, WideBlur) else _tiled(place, blur)
        rows, columns = (slice(0, side) for side in blur.whole[1:])
        seen = [blur.per_seen(plane, rows, columns) for plane in range(blur.whole[0])]
        parts = [counted.part(plane, slice(None), slice(None)) for plane in range(blur.shape[0])]
        weights = [weight for _, weight in parts]
        self._per_seen, self._counts = place.put(np.stack(seen)), place.put(np.stack([counts for counts, _ in parts]))
        self._weight = place.put(np.stack(weights) if weights[0].ndim else weights[0])
        self._added = counted.added_at(slice(None), slice(None))
        self._light, self._last_change = place.put(self._light), place.put(self._last_change)

    def _compare(self) -> Array:
        xp, counted = self._xp, self._counted
        background = np.asarray(counted.background, counted.dtype)
        light = xp.clip(self._operator(self.guess, transposed=False), min=TINY)
        model = light + self._place.put(self._added + background)
        ratio = xp.clip(self._counts / model, max=MAX_RATIO)
        self._misfit = ratio - 1.0
        terms = (xp.log(xp.clip(ratio, min=TINY)) * ratio - self._misfit) * self._weight * model
        self._misfit = self._misfit * self._weight
        of_specimen = np.zeros(3)
        if counted.judges_specimen and np.any(background):
            squares = (light / model) ** 2 * xp.astype(self._weight > 0.0, xp.float32)
            of_specimen += [self._sums(values).sum() for values in (terms * squares, squares, squares * squares)]
        return counted.judged(self._sums(terms), of_specimen)

    def _sums(self, values: Any) -> Array:
        """Return the sum of each plane, in double precision on the host, as some devices have none."""
        sums = self._place.to_numpy(self._xp.sum(values, axis=2)).sum(axis=1, dtype=np.float64)
        return np.asarray(sums)

    def _product(self, a: Any, b: Any) -> float:
        return float(self._sums(a * b).sum())

    def _means(self, points: int) -> Array:
        planes = self._place.to_numpy(self._xp.sum(self._misfit, axis=0))
        return self._counted.means(planes[np.newaxis], points)

    def _adjoint(self, consume: Callable[..., Any]) -> list[Any]:
        return [consume(self._operator(self._misfit, transposed=True))]

    def _extrapolate_light(self, factor: float) -> None:
        if factor == 0.0 or self._before is None:
            self._before = self._light if self._before is not None else None
            return
        ratio = self._xp.clip(self._light / (self._before * factor + (1.0 - factor) * self._light), max=MAX_GROWTH)
        self._before = self._xp.clip(ratio * self._light, min=self._counted.smallest)

    def _step(self) -> float:
        guess: Any = self.guess
        smallest = self._counted.smallest

        def step(back: Any, *_: Any) -> Any:
            return self._xp.clip((back * self._per_seen + 1.0) * guess, min=smallest)

        (stepped,) = self._back_projected(step)
        change = (stepped - guess)[::STRIDE, ::STRIDE, ::STRIDE]
        overlap = self._product(change, self._last_change)
        self._last_change, self._before, self._light = change, self._light, stepped
        return overlap

    def inside(self, planes: int, pixels: int) -> Values:
        """Return the light without its margin, in memory of the host, where it then is; see :class:`Iteration`."""
        self._light, self._before = self._place.to_numpy(self.guess), None
        return super().inside(planes, pixels)


_Operator = Callable[..., Any]
"""A blur of an array on a device, or its transpose if `transposed`."""


def _tiled(place: Placement, blur: Any) -> _Operator:
    """Return the operator of a `TiledBlur` or `PlaneBlur`."""
    margin = blur._margin[1]
    xp: Any = place.namespace.xp
    filtered = _by_matrices(place, blur) if isinstance(blur, PlaneBlur) else _by_transfers(place, blur)

    def apply(values: Any, *, transposed: bool) -> Any:
        shape, source = (blur.whole, blur.shape) if transposed else (blur.shape, blur.whole)
        extent, shift = (blur._lower, -margin) if transposed else (blur._upper, margin)
        result = place.put(np.zeros(shape, np.float32))
        for job in blur._tile_jobs(shape, source, extent, shift):
            tiles = place.put(np.zeros((source[0], *blur._tile), np.float32))
            tiles[:, *job.source_in_tile] = values[:, *job.source]
            spectra = filtered(xp.fft.rfftn(tiles, axes=(1, 2)), transposed)
            light = xp.fft.irfftn(spectra, s=blur._tile, axes=(1, 2))
            result[:, *job.output] = light[:, *job.output_in_tile]
        return result

    return apply


def _by_transfers(place: Placement, blur: TiledBlur) -> Callable[[Any, bool], Any]:
    """Return the filter of the spectra of planes by transforms along z, as `engine.filter_planes`."""
    depth, planes = blur._depth, blur.whole[0]
    xp: Any = place.namespace.xp
    first, end = blur._before, blur._before + planes  # of the specimen among its planes and those beyond
    recorded = slice(first + blur._margin[0], first + blur._margin[0] + blur.shape[0])
    kernels = [
        (place.put(blur.spectrum(k)), place.put(weights[:, np.newaxis, np.newaxis]))
        for k, weights in enumerate(blur._weights)
    ]

    def filtered(spectra: Any, transposed: bool) -> Any:
        total: Any = 0.0
        for transfer, weights in kernels:
            if not transposed:
                weighted = spectra * weights
                ends = [weighted[:1, ...]] * first, [weighted[-1:, ...]] * blur._after
                along_z = xp.fft.fft(xp.concat([*ends[0], weighted, *ends[1]], axis=0), n=depth, axis=0)
                total = total + xp.fft.ifft(along_z * transfer, axis=0)[recorded, ...]
                continue
            before = place.put(np.zeros((recorded.start, *spectra.shape[1:]), np.complex64))
            along_z = xp.fft.fft(xp.concat([before, spectra], axis=0), n=depth, axis=0)
            beyond = xp.fft.ifft(along_z * xp.conj(transfer), axis=0)
            light = beyond[first:end, ...]
            light[0, ...] += xp.sum(beyond[:first, ...], axis=0)
            light[-1, ...] += xp.sum(beyond[end : end + blur._after, ...], axis=0)
            total = total + light * weights
        return total

    return filtered


def _by_matrices(place: Placement, blur: PlaneBlur) -> Callable[[Any, bool], Any]:
    """Return the filter of the spectra of planes by a matrix at each lateral frequency."""
    matrices = place.put(blur._matrices)
    xp: Any = place.namespace.xp
    order = np.concatenate([frequencies.ravel() for _, frequencies in blur._tasks])
    position = np.zeros(len(blur._weight_above), np.int64)
    position[order] = np.arange(len(order))
    positions = place.put(position)
    tasks = [
        (
            place.put(frequencies.reshape(-1)),
            frequencies.shape,
            [
                (place.put(tabulated), place.put(np.tile(weights[frequencies], 2)[:, np.newaxis]))
                for tabulated, weights in ((below, blur._weight_below), (below + 1, blur._weight_above))
            ],
        )
        for below, frequencies in blur._tasks
    ]

    def filtered(spectra: Any, transposed: bool) -> Any:
        flat, results = xp.reshape(spectra, (spectra.shape[0], -1)), []
        for frequencies, shape, tables in tasks:
            values = xp.reshape(xp.take(flat, frequencies, axis=1), (-1, *shape))
            # The matrices are real: real and imaginary parts are multiplied side by side.
            pairs = xp.permute_dims(xp.concat([xp.real(values), xp.imag(values)], axis=2), (1, 0, 2))
            result: Any = 0.0
            for tabulated, weights in tables:
                some: Any = xp.take(matrices, tabulated, axis=0)
                some = xp.matrix_transpose(some) if transposed else some
                result = result + place.namespace.matmul(some, pairs * weights)
            real, imaginary = (xp.astype(result[..., k * shape[1] :][..., : shape[1]], xp.complex64) for k in (0, 1))
            together = xp.permute_dims(real + 1j * imaginary, (1, 0, 2))
            results.append(xp.reshape(together, (together.shape[0], -1)))
        return xp.reshape(xp.take(xp.concat(results, axis=1), positions, axis=1), (-1, *spectra.shape[1:]))

    return filtered


def _wide(place: Placement, blur: WideBlur) -> _Operator:
    """Return the operator of a `WideBlur`, which sets `blur.outside_back`."""
    windows, tails = _tiled(place, blur._windows), _tiled(place, blur._tails)
    matmul = place.namespace.matmul
    xp: Any = place.namespace.xp
    pixels_outside = place.put(blur._pixels_outside)
    recording, specimen = (
        [place.put(axis.weights) for axis in axes] for axes in (blur._recording_weights, blur._specimen_weights)
    )

    def apply(values: Any, *, transposed: bool) -> Any:
        source, target = (recording, specimen) if transposed else (specimen, recording)
        coarse: Any = matmul(matmul(xp.matrix_transpose(source[0]), values), source[1])
        if not transposed:
            coarse = coarse + place.put(np.asarray(blur.outside)[:, np.newaxis, np.newaxis]) * pixels_outside
        light: Any = tails(coarse, transposed=transposed)
        if transposed:
            blur.outside_back = place.to_numpy(xp.sum(light * pixels_outside, axis=(1, 2)))
        interpolated = matmul(matmul(target[0], light), xp.matrix_transpose(target[1]))
        return windows(values, transposed=transposed) + interpolated

    return apply
