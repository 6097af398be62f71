"""Blur by the windows of a field, with the borders of an image: one of the operators that a channel is the sum of."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.imaging.borders import gathered
from lommel.imaging.field.nodes import Nodes

_KEPT = 2**29  # bytes of spectra that are kept, 512 MiB
_LONGEST = 512  # side of a transform, where windows do not make it longer
_OVERHEAD = 20_000  # of a block, in samples of a transform


@dataclass(frozen=True)
class Block:
    """Part of the points that spread light, and the nodes whose windows they mix.

    Attributes
    ----------
    rows, columns : slice
        Of the points.
    down, across : slice
        Of the nodes.
    """

    rows: slice
    columns: slice
    down: slice
    across: slice


class Blocks:
    """``out[q] = sum_kl sum_p D[p_y, k] A[p_x, l] sum_i c_i[p] x[p] W[k, l, i, q - p]``, and its transpose.

    A block of points takes one transform for each node that it mixes, and one back: the transforms are linear. Those
    along rows are made before the weights down the image are applied, which they do not depend on.

    Parameters
    ----------
    windows : ndarray, shape (nodes down, nodes across, defocus, side, side)
        W; the side is odd.
    down, across : ndarray, shapes (height, nodes down) and (width, nodes across)
        D and A; near 0 but for a few neighbours.
    threads : int
        At most so many. The result does not depend on it.
    """

    def __init__(
        self, windows: NDArray[Any], down: NDArray[np.float64], across: NDArray[np.float64], threads: int
    ) -> None:
        self.windows, self.threads = windows, threads
        self.down, self.across = (weights.astype(windows.dtype) for weights in (down, across))
        self.beyond = windows.shape[-1] - 1  # rows and columns that a block spreads beyond its own
        self.sides = _sides(self.down.shape, self.across.shape, self.beyond + 1)
        self._rows, self._columns = (
            _parts(weights, side - self.beyond)
            for weights, side in zip((self.down, self.across), self.sides, strict=True)
        )
        self._spectra: NDArray[Any] | None = None

    def spread(self, light: NDArray[Any], shares: Shares | None = None) -> NDArray[Any]:
        """Return what points make of their light, shape ``(height + side - 1, width + side - 1)``.

        Parameters
        ----------
        light : ndarray, shape (height, width)
        shares : callable, optional
            Gives the places along the third axis of the windows that a block of points takes part in, and how much
            each point does at each of them, c; by default all at the first.

        Returns
        -------
        ndarray
            The middle of the first window is at ``(side // 2, side // 2)``.
        """
        out = np.zeros([side + self.beyond for side in light.shape], dtype=light.dtype)

        def made(block: Block) -> NDArray[Any]:
            points = light[block.rows, block.columns]
            total: Any = 0.0
            for place, share in _shares(shares, block):
                total = total + self._mixed(block, points if share is None else share * points, place)
            return self._back(total, [side + self.beyond for side in points.shape])

        for block, part in self._each(made):
            rows, columns = (slice(s.start, s.stop + self.beyond) for s in (block.rows, block.columns))
            out[rows, columns] += part
        return out

    def collect(self, room: NDArray[Any], shares: Shares | None = None) -> NDArray[Any]:
        """Return the transpose of :meth:`spread` applied to what it returns, shape (height, width)."""
        out = np.empty([side - self.beyond for side in room.shape], dtype=room.dtype)

        def made(block: Block) -> NDArray[Any]:
            rows, columns = (slice(s.start, s.stop + self.beyond) for s in (block.rows, block.columns))
            spectrum = self._transformed(room[rows, columns])
            total: Any = 0.0
            for place, share in _shares(shares, block):
                part = self._taken(block, spectrum, place)
                total = total + (part if share is None else share * part)
            return np.broadcast_to(total, [s.stop - s.start for s in (block.rows, block.columns)])

        for block, part in self._each(made):
            out[block.rows, block.columns] = part
        return out

    def _each(self, made: Callable[[Block], NDArray[Any]]) -> Iterator[tuple[Block, NDArray[Any]]]:
        """Yield blocks and what is made of them, a row of blocks at a time."""
        with ThreadPoolExecutor(self.threads) as pool:
            for rows, down in self._rows:
                blocks = [Block(rows, columns, down, across) for columns, across in self._columns]
                yield from zip(blocks, pool.map(made, blocks), strict=True)

    def _mixed(self, block: Block, points: NDArray[Any], place: int) -> NDArray[Any]:
        """Return the transform of what some points spread by the windows at one place along their third axis."""
        from scipy.fft import fft, rfft

        down, across = self.down[block.rows, block.down], self.across[block.columns, block.across]
        lines = rfft(across.T[:, None, :] * points, n=self.sides[1], axis=-1)
        planes = down.T[:, None, :, None] * lines
        spectra = fft(planes, n=self.sides[0], axis=-2, overwrite_x=True)
        spectra *= self._of(block, place)
        return np.asarray(spectra.sum(axis=(0, 1)))

    def _back(self, spectrum: NDArray[Any], shape: Sequence[int]) -> NDArray[Any]:
        from scipy.fft import ifft, irfft

        lines = ifft(spectrum, axis=0, overwrite_x=True)[: shape[0]]
        return np.asarray(irfft(lines, n=self.sides[1], axis=1)[:, : shape[1]])

    def _taken(self, block: Block, spectrum: NDArray[Any], place: int) -> NDArray[Any]:
        """Return the transpose of :meth:`_mixed` and :meth:`_back`."""
        from scipy.fft import ifft, irfft

        down, across = self.down[block.rows, block.down], self.across[block.columns, block.across]
        spectra = np.conj(self._of(block, place))
        spectra *= spectrum
        planes = ifft(spectra, axis=-2, overwrite_x=True)[..., : len(down), :]
        planes = planes * down.T[:, None, :, None]
        lines = irfft(planes.sum(axis=0), n=self.sides[1], axis=-1)[..., : len(across)]
        return np.asarray((lines * across.T[:, None, :]).sum(axis=0))

    def _of(self, block: Block, place: int) -> NDArray[Any]:
        """Return the transforms of the windows that a block mixes."""
        if self._spectra is None:
            count, size = math.prod(self.windows.shape[:3]), self.sides[0] * (self.sides[1] // 2 + 1)
            if count * size * 2 * self.windows.itemsize > _KEPT:
                return self._transformed(self.windows[block.down, block.across, place])
            self._spectra = self._transformed(self.windows)
        return self._spectra[block.down, block.across, place]

    def _transformed(self, images: NDArray[Any]) -> NDArray[Any]:
        """Return the transforms of images, smaller than these, without those of rows beyond them."""
        from scipy.fft import fft, rfft

        lines = rfft(images, n=self.sides[1], axis=-1)
        return np.asarray(fft(lines, n=self.sides[0], axis=-2, overwrite_x=True))


Shares = Callable[[slice, slice], list[tuple[int, NDArray[Any]]]]


def _shares(shares: Shares | None, block: Block) -> Sequence[tuple[int, NDArray[Any] | None]]:
    return [(0, None)] if shares is None else list(shares(block.rows, block.columns))


def _sides(down: tuple[int, ...], across: tuple[int, ...], window: int) -> tuple[int, int]:
    """Return sides of the transforms, rows and columns, that make the work least."""
    rows, columns = (_candidates(points, window) for points, _ in (down, across))
    best = (math.inf, (0, 0))
    for fy, by, ny in ((f, b, math.ceil(down[0] / b)) for f, b in rows):
        for fx, bx, nx in ((f, b, math.ceil(across[0] / b)) for f, b in columns):
            each = 2.0 + math.prod(
                min(count, 4.0 + block * (count - 1) / points)
                for block, (points, count) in ((by, down), (bx, across))
            )
            best = min(best, (ny * nx * (fy * fx * each * math.log2(fy * fx) + _OVERHEAD * 10.0), (fy, fx)))
    return best[1]


def _candidates(points: int, window: int) -> list[tuple[int, int]]:
    """Return sides of transforms that are fast, and how many points each leaves to a block."""
    from scipy.fft import next_fast_len

    most = next_fast_len(min(points + window - 1, max(_LONGEST, 4 * window)), real=True)
    sides, side = [], window
    while side <= most:
        side = next_fast_len(side, real=True)
        sides.append((side, side - window + 1))
        side += 1
    return [pair for pair in sides if pair[1] >= min(points, 8)] or sides[-1:]


def _parts(weights: NDArray[Any], length: int) -> list[tuple[slice, slice]]:
    """Return parts of the points, and of the nodes that have weight there."""
    parts = []
    count = math.ceil(len(weights) / length)
    edges = [round(k * len(weights) / count) for k in range(count + 1)]
    for first, last in pairwise(edges):
        used = np.flatnonzero(weights[first:last].any(axis=0))
        parts.append((slice(first, last), slice(int(used[0]), int(used[-1]) + 1)))
    return parts


class Part:
    """What points spread by windows that are mixed of some, and the transpose.

    Beyond the edges, a copy of a point spreads the window of the point that it copies.

    Parameters
    ----------
    windows : ndarray, shape (nodes down, nodes across, defocus, side, side)
    weights : (ndarray, ndarray), shapes (height, nodes down) and (width, nodes across)
        How much of each window rows and columns of the image take.
    border : {"reflect", "extend", "zero"}
    threads : int
    focus : Nodes, optional
        Of the windows over defocus.
    defocus : ndarray, shape (height, width), optional
    share : ndarray, shape (height, width), optional
        Of its light that each point spreads, if not all.
    """

    def __init__(
        self,
        windows: NDArray[Any],
        weights: tuple[Array, Array],
        *,
        border: str,
        threads: int,
        focus: Nodes | None = None,
        defocus: Array | None = None,
        share: NDArray[Any] | None = None,
    ) -> None:
        reach = windows.shape[-1] // 2
        margin = 0 if border == "zero" else reach
        mode: Any = "symmetric" if border == "reflect" else "edge"
        # Which row or column each of those is a copy of that spread light, the ones beyond the edges too.
        self.rows, self.columns = (
            np.pad(np.arange(len(part), dtype=np.int64), margin, mode=mode) for part in weights
        )
        self.before = margin + reach  # the first pixel of the image, in what blocks make
        down, across = weights
        self.blocks = Blocks(windows, down[self.rows], across[self.columns], threads)
        self.focus, self.defocus, self.share = focus, defocus, share

    def spread(self, plane: NDArray[Any]) -> NDArray[Any]:
        """Return what light makes, both of the shape of the image."""
        source = plane if self.share is None else self.share * plane
        made = self.blocks.spread(source[self.rows[:, None], self.columns], self._shares())
        height, width = plane.shape
        return made[self.before :, self.before :][:height, :width]

    def collect(self, plane: NDArray[Any]) -> NDArray[Any]:
        """Return the transpose of :meth:`spread` applied to an image."""
        taken = self.blocks.collect(np.pad(plane, self.before), self._shares())
        # What points beyond the edges took goes to those that they are copies of.
        found = gathered(gathered(taken, self.rows, plane.shape[0]).T, self.columns, plane.shape[1]).T
        return found if self.share is None else self.share * found

    def _shares(self) -> Shares | None:
        """Return what the points of a block take of the windows over defocus, as :class:`Blocks` asks for it."""
        if self.focus is None or self.defocus is None:
            return None
        focus, defocus, dtype = self.focus, self.defocus, self.blocks.windows.dtype

        def shares(down: slice, across: slice) -> list[tuple[int, NDArray[Any]]]:
            places = defocus[self.rows[down][:, None], self.columns[across]]
            return [(place, share.astype(dtype)) for place, share in focus.shares(places)]

        return shares
