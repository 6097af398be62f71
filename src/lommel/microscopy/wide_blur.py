"""Blur of a stack by light that reaches farther than the window of a PSF, on a coarse grid, and from outside."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from lommel.base.arrays import Array, Values
from lommel.base.threads import product, side_by_side
from lommel.microscopy.stack_blur import Made, Part, Take, TiledBlur


class WideBlur:
    """The blur by PSFs in their windows, `near`, and by what of these lies beyond, `far`, of every `pitch` th pixel.

    Light is shared linearly between the nodes of the coarse grid, and values between these are interpolated, so that
    the transpose is exact. Beyond the margin the specimen is as bright everywhere in each plane as `outside` says: an
    unknown like all others. A flat specimen so has a flat recording.
    """

    def __init__(
        self,
        near: TiledBlur,
        far: Iterable[Array],
        pitch: int,
        *,
        weights: Array | None = None,
        threads: int = 0,
    ) -> None:
        self._near, self._threads = near, threads
        self.shape, self.whole = near.shape, near.whole
        kernels: Sequence[Array] = list(far)
        margin = (near.whole[0] - near.shape[0]) // 2, (near.whole[1] - near.shape[1]) // 2
        reach = kernels[0].shape[1] // 2
        if reach * pitch < margin[1]:
            raise ValueError(f"far must reach over the margin of {margin[1]} pixels, got {reach} nodes of {pitch}")
        nodes = [(side - 1) // pitch + 2 for side in near.shape[1:]]
        self._far = TiledBlur(
            kernels, (near.shape[0], nodes[0], nodes[1]), (margin[0], reach), weights=weights, threads=threads
        )
        self._recorded = [_Hats(side, 0, pitch, 0, count) for side, count in zip(near.shape[1:], nodes, strict=True)]
        self._given = [
            _Hats(side, margin[1], pitch, reach, count + 2 * reach)
            for side, count in zip(near.whole[1:], nodes, strict=True)
        ]
        down, across = (each.shares.sum(axis=0) for each in self._given)
        self._beyond = np.maximum(float(pitch) ** 2 - np.outer(down, across), 0.0).astype(np.float32)
        self.outside = np.ones(near.whole[0], np.float32)
        ones = np.outer(*(each.shares.sum(axis=0) for each in self._recorded)).astype(np.float32)
        self._seen = self._returned(np.broadcast_to(ones, (near.shape[0], *ones.shape)))
        self.outside_seen = np.einsum("pyx,yx->p", self._seen, self._beyond)
        self.outside_back = np.zeros(near.whole[0], np.float32)
        self.weigh(1.0)

    def forward(self, specimen: Part, take: Take[Made]) -> list[Made]:
        """Hand the recording of a specimen to `take`, as :meth:`TiledBlur.forward` does."""
        coarse = self._binned(specimen, self.whole, self._given)
        coarse += self.outside[:, np.newaxis, np.newaxis] * self._beyond
        light = np.empty((self.shape[0], *(each.nodes for each in self._recorded)), np.float32)

        def put(plane: int, rows: slice, columns: slice, values: Values) -> None:
            light[plane, rows, columns] = values

        self._far.forward(lambda plane, *at: coarse[(plane, *at)], put)
        return self._near.forward(specimen, self._added(light, self._recorded, take))

    def adjoint(self, recording: Part, take: Take[Made]) -> list[Made]:
        """Hand the transpose of :meth:`forward` to `take`; that of the light outside is `outside_back`."""
        light = self._returned(self._binned(recording, self.shape, self._recorded))
        self.outside_back = np.einsum("pyx,yx->p", light, self._beyond)
        return self._near.adjoint(recording, self._added(light, self._given, take))

    def release(self) -> None:
        """Give back what transforms took; they take it again."""
        self._near.release()
        self._far.release()

    def seen(self, plane: int, rows: slice, columns: slice) -> Values:
        """Return the share of the light of points of the specimen that falls on the recording, as `Part` does."""
        found = _between(self._seen[plane], self._given, rows, columns)
        found += self._near.seen(plane, rows, columns)
        return found

    def weigh(self, weight: float) -> None:
        """State by what to divide besides, in :meth:`per_seen`."""
        self._weight = weight

    def per_seen(self, plane: int, rows: slice, columns: slice) -> Values:
        """Return 1 over :meth:`seen` and the weight, 0 where next to nothing is seen."""
        return per(self.seen(plane, rows, columns) * np.float32(self._weight))

    @property
    def per_outside(self) -> Values:
        """1 over the light of the outside that falls on the recording, and the weight."""
        return per(self.outside_seen * np.float32(self._weight))

    def _returned(self, light: Values) -> Values:
        """Return the transpose of the coarse blur."""
        back = np.empty((self.whole[0], *(each.nodes for each in self._given)), np.float32)

        def put(plane: int, rows: slice, columns: slice, values: Values) -> None:
            back[plane, rows, columns] = values

        self._far.adjoint(lambda plane, *at: light[(plane, *at)], put)
        return back

    def _binned(self, values: Part, shape: tuple[int, ...], hats: list[_Hats]) -> Values:
        """Return planes shared between the nodes of the coarse grid."""
        rows, columns = slice(0, shape[1]), slice(0, shape[2])
        down, across = hats
        made = np.empty((shape[0], down.nodes, across.nodes), np.float32)

        def share(plane: int) -> None:
            given = values(plane, rows, columns)
            tall = np.zeros((down.nodes, shape[2]), np.float32)
            for part, nodes in down.parts(rows):
                tall[nodes] += product(down.shares[part, nodes].T, given[part])
            made[plane] = 0.0
            for part, nodes in across.parts(columns):
                made[plane, :, nodes] += product(tall[:, part], across.shares[part, nodes])

        side_by_side(share, range(shape[0]), self._threads)
        return made

    def _added(self, light: Values, hats: list[_Hats], take: Take[Made]) -> Take[Made]:
        """Return `take`, with interpolated light added to what it gets."""

        def added(plane: int, rows: slice, columns: slice, values: Values) -> Made:
            values += _between(light[plane], hats, rows, columns)
            return take(plane, rows, columns, values)

        return added


class _Hats:
    """The share of each pixel in each node of a coarse grid: node `lower` is at pixel `before`."""

    def __init__(self, side: int, before: int, pitch: int, lower: int, nodes: int) -> None:
        place = (np.arange(side) - before) / pitch + lower
        self._first = np.floor(place).astype(int)
        self.nodes, self.shares = nodes, np.zeros((side, nodes), np.float32)
        self.shares[np.arange(side), self._first] = 1.0 - (place - self._first)
        inside = self._first + 1 < nodes
        self.shares[np.arange(side)[inside], self._first[inside] + 1] = (place - self._first)[inside]

    def parts(self, pixels: slice) -> Iterator[tuple[slice, slice]]:
        """Yield parts of the pixels, and the few nodes in which these have a share."""
        for start in range(pixels.start, pixels.stop, _TOGETHER):
            stop = min(start + _TOGETHER, pixels.stop)
            yield slice(start, stop), slice(self._first[start], min(self._first[stop - 1] + 2, self.nodes))


def _between(light: Values, hats: list[_Hats], rows: slice, columns: slice) -> Values:
    """Return a part of a plane, interpolated between nodes."""
    down, across = hats
    tall = np.empty((rows.stop - rows.start, light.shape[1]), np.float32)
    for part, nodes in down.parts(rows):
        tall[part.start - rows.start : part.stop - rows.start] = product(down.shares[part, nodes], light[nodes])
    made = np.empty((len(tall), columns.stop - columns.start), np.float32)
    for part, nodes in across.parts(columns):
        here = slice(part.start - columns.start, part.stop - columns.start)
        made[:, here] = product(tall[:, nodes], across.shares[part, nodes].T)
    return made


def per(seen: Values) -> Values:
    """Return 1 over what is seen, 0 where that is next to nothing."""
    with np.errstate(divide="ignore"):
        return np.where(seen > _UNSEEN, np.float32(1.0) / seen, np.float32(0.0))


_UNSEEN = 1e-6
_TOGETHER = 64  # pixels that are interpolated in one go, between few of all nodes


def pitch_of(side: int) -> int:
    """Return the pitch of the coarse grid beside a window of so many pixels."""
    return 5 if side > 33 else 3


def taper(side: int, pitch: int, at: Array | None = None) -> Array:
    """Return the share of the light that is near, over a window, or at distances from its middle along both axes."""
    along = np.arange(side) - side // 2 if at is None else at
    half = side // 2 + 0.5
    wide = min(2.0 * pitch, 0.7 * half)
    radius = np.hypot(along[:, np.newaxis], along)
    inside = np.clip((half - radius) / wide, 0.0, 1.0)
    return np.asarray(0.5 - 0.5 * np.cos(math.pi * inside))
