"""Masks: transmission sampled over the square around the aperture."""

from __future__ import annotations

import base64
import hashlib
import sys
import zlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array, Json
from lommel.base.cached import EqualByContent

MAX_SIDE = 8192


@dataclass(frozen=True, eq=False)
class Mask(EqualByContent):
    """Amplitude transmission sampled over the square around the aperture: apodizers, segmented mirrors.

    Images are sums over the samples, each weighted by the part of its cell inside the aperture. They repeat at
    ``pi * side`` in v, and a window that a repetition would reach is refused.

    Parameters
    ----------
    values : array_like, shape (side, side)
        Amplitudes from 0 to 1 at the centres ``(2 i + 1 - side) / side`` of the cells of the square [-1, 1] x
        [-1, 1]; rows rise with y, columns with x. side is 2 to 8192.

    Raises
    ------
    TypeError, ValueError
        If the array is not square, holds anything but numbers from 0 to 1, or holds zeros only.

    Examples
    --------
    >>> Mask.sample(lambda x, y: x > 0, side=4).values[0]
    array([0., 0., 1., 1.])
    """

    values: Array
    _digest: bytes = field(init=False, repr=False)

    def __post_init__(self) -> None:
        given = validation.array("values", self.values)
        if given.dtype == np.bool_:
            given = given.astype(np.float64)
        if given.ndim != 2 or given.shape[0] != given.shape[1] or not 2 <= given.shape[0] <= MAX_SIDE:
            raise ValueError(f"values must be a square array with a side of 2 to {MAX_SIDE}, got shape {given.shape}")
        self._keep(np.ascontiguousarray(validation.real_array("values", given, least=0.0)) + 0.0)

    def _keep(self, values: Array) -> None:
        """Keep values of the right shape, >= 0 and finite, without a copy."""
        if values.max() > 1.0:
            raise ValueError(f"values must be from 0 to 1, got {values.max():g}")
        if values.max() == 0.0:
            raise ValueError("values must not be 0 throughout: no light would pass")
        values.flags.writeable = False
        digest = hashlib.sha256(repr(values.shape).encode())
        digest.update(values.data)
        vars(self).update(values=values, _digest=digest.digest())

    @classmethod
    def sample(cls, function: Callable[[Array, Array], ArrayLike], side: int) -> Mask:
        """Return the mask of ``function(x, y)`` at the centres of `side` x `side` cells, `side` from 2 to 8192.

        `function` takes arrays of shapes (1, side) and (side, 1) and returns amplitudes or booleans. TypeError or
        ValueError if it does not, or `side` is out of range.
        """
        n = validation.integer("side", side, least=2, most=MAX_SIDE)
        validation.function("function", function)
        at = cell_centers(n)
        return cls(np.broadcast_to(validation.array("function", function(at[None, :], at[:, None])), (n, n)))

    @property
    def side(self) -> int:
        """Samples along each side."""
        return len(self.values)

    def at(self, x: Array, y: Array) -> Array:
        """Return the amplitude of the cell that each point (`x`, `y`) lies in, 0 outside of the square.

        TypeError or ValueError if these are not real and finite.
        """
        x, y = (np.clip(validation.real_array(name, part), -2.0, 2.0) for name, part in (("x", x), ("y", y)))
        row, column = (np.floor(0.5 * (part + 1.0) * self.side) for part in (y, x))
        # The far edge belongs to the last cell.
        row, column = np.where(y == 1.0, self.side - 1, row), np.where(x == 1.0, self.side - 1, column)
        inside = (row >= 0) & (row < self.side) & (column >= 0) & (column < self.side)
        places = (np.where(inside, part, 0).astype(np.int64) for part in (row, column))
        return np.asarray(np.where(inside, self.values[tuple(places)], 0.0))

    def _content(self) -> bytes:
        """Return a digest of the values."""
        return self._digest

    def __repr__(self) -> str:
        return f"Mask(<{self.side} x {self.side} amplitudes, mean {self.values.mean():.4g}>)"

    def to_dict(self) -> Json:
        """Return the values in plain types: little-endian float64, deflated, as base64."""
        data = zlib.compress(self.values.astype("<f8").tobytes(), 6)
        return {"side": self.side, "values": base64.b64encode(data).decode("ascii")}

    @classmethod
    def from_dict(cls, description: Mapping[str, Any]) -> Mask:
        """Rebuild a mask from a `description` by :meth:`to_dict`; KeyError, TypeError or ValueError if it is none."""
        side = validation.integer("side", description["side"], least=2, most=MAX_SIDE)
        packed = base64.b64decode(description["values"], validate=True)
        # Unpacked in place: with a copy beside it a small file would take a gigabyte.
        values, unpack, at = np.empty((side, side)), zlib.decompressobj(), 0
        place = values.data.cast("B")
        while part := unpack.decompress(packed, 2**20):
            if at + len(part) > len(place):
                raise ValueError(f"values must be {side} x {side}, got more")
            place[at : at + len(part)] = part
            at, packed = at + len(part), unpack.unconsumed_tail
        if at != len(place):
            raise ValueError(f"values must be {side} x {side}, got {at} bytes")
        if sys.byteorder == "big":
            values = values.byteswap()
        if not values.min() >= 0.0:
            raise ValueError(f"values must be >= 0, got {values.min():g}")
        made = object.__new__(cls)
        values += 0.0  # no -0
        made._keep(values)
        return made


def cell_centers(side: int) -> Array:
    """Return the centres of `side` equal cells of [-1, 1]."""
    return (2.0 * np.arange(side) + 1.0 - side) / side
