"""Blur by the windows of a field, with the borders of an image: one of the operators that a channel is the sum of."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.imaging.borders import gathered
from lommel.imaging.field.blocks import Blocks, Shares
from lommel.imaging.field.nodes import Nodes


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
