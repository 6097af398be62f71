"""Masks: complex transmission sampled over the square around the aperture."""

from __future__ import annotations

import base64
import hashlib
import sys
import zlib
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array, Json, Values
from lommel.base.cached import EqualByContent

# 8192^2 complex cells take 1 GiB.
MAX_SIDE = 8192
_MAX_POINTS = 64  # largest number of sample points along each side of a cell
_MAX_EVALUATED = 2**24  # largest number of points evaluated at a time
_PHASE_ADVICE = "for a map of phases in radians give np.exp(1j * phase)"


@dataclass(frozen=True, eq=False)
class Mask(EqualByContent):
    """Transmission sampled over the square around the aperture: apodizers, phase plates, phase screens, modulators.

    The amplitude of a cell is its value times the fraction of the cell inside the aperture. By default the values are
    samples of a function, and images are sums over the samples. These images repeat every `side` lambda*N along x and
    y, and one period around the axis contains all light: windows, circles and halos of seeing beyond this
    period raise ValueError. With `squares` the pupil function is constant on each cell, with the phase of the
    wavefront at its centre: the field is the sum over the samples times ``sinc(v_x / side) sinc(v_y / side)``.
    The images with and without `squares` have an error bound.

    Parameters
    ----------
    values : array_like, shape (side, side)
        Transmission of the amplitude at the centres ``(2 i + 1 - side) / side`` of the cells of the square [-1, 1] x
        [-1, 1]: real, 0 to 1, or complex, of modulus at most 1; a phase map is ``exp(1j * phase)``. Rows rise with y,
        columns with x. side is 2 to 8192.
    squares : bool, default False
        True: values of square cells, as of a spatial light modulator. False: samples of a function.

    Raises
    ------
    TypeError, ValueError
        If the array is not square, has values other than numbers of modulus at most 1, or has zeros only. An array
        with negative values must have a complex data type.

    Examples
    --------
    >>> Mask.sample(lambda x, y: x > 0, side=4).values[0]
    array([0., 0., 1., 1.])
    """

    values: Values
    squares: bool = False
    _digest: bytes = field(init=False, repr=False)

    def __post_init__(self) -> None:
        array = validation.array("values", self.values)
        if array.dtype == np.bool_:
            array = array.astype(np.float64)
        if array.ndim != 2 or array.shape[0] != array.shape[1] or not 2 <= array.shape[0] <= MAX_SIDE:
            raise ValueError(f"values must be a square array with a side of 2 to {MAX_SIDE}, got shape {array.shape}")
        validation.truth("squares", self.squares)
        if array.dtype.kind == "c":
            if not np.isfinite(array).all():
                raise ValueError("values must be finite, got NaN or infinity; put 0 where no light passes")
            self._store(np.ascontiguousarray(array, dtype=np.complex128))
        else:
            array = validation.real_array("values", array)
            if array.min() < 0.0:
                raise ValueError(f"values must be amplitudes from 0 to 1, got {array.min():.6g}; {_PHASE_ADVICE}")
            # + 0.0 turns -0 into 0, so that equal masks have equal digests.
            self._store(np.ascontiguousarray(array) + 0.0)

    def _store(self, values: Values) -> None:
        """Store values of the right shape, finite and not negative, without a copy."""
        largest = float(np.abs(values).max())
        if largest > 1.0 + (1e-12 if values.dtype.kind == "c" else 0.0):  # moduli of rounded cosine and sine exceed 1
            raise ValueError(f"values must have a modulus from 0 to 1, got {largest:.15g}; {_PHASE_ADVICE}")
        if largest == 0.0:
            raise ValueError("values must not be 0 throughout: no light would pass")
        values.flags.writeable = False
        # Masks are keys of caches: digests are compared instead of gigabytes of values.
        digest = hashlib.sha256(repr((values.shape, values.dtype.kind, self.squares)).encode())
        digest.update(values.data)
        vars(self).update(values=values, _digest=digest.digest())

    @classmethod
    def sample(
        cls, function: Callable[[Array, Array], ArrayLike], side: int, *, squares: bool = False, oversample: int = 1
    ) -> Mask:
        """Return the mask of ``function(x, y)`` over `side` x `side` cells.

        Parameters
        ----------
        function : callable
            Function of x, shape (1, n), and y, shape (n, 1), that returns transmissions or booleans.
        side : int
            Number of cells along each side of the square, 2 to 8192.
        squares : bool, default False
            As for :class:`Mask`.
        oversample : int, default 1
            Number of points along each side of a cell, 1 to 64, over which the function is averaged; by default the
            centre only. Cells that an edge crosses are then partly clear, which brings the PSF closer to the exact
            PSF of the shape. The total light, for ``normalize="energy"``, does not improve: the light of a cell is
            the square of its mean amplitude, also if the rim of the aperture crosses the cell.

        Raises
        ------
        TypeError, ValueError
            If an argument is out of range, or if the function returns other values.
        """
        n = validation.integer("side", side, least=2, most=MAX_SIDE)
        points = validation.integer("oversample", oversample, least=1, most=_MAX_POINTS)
        validation.function("function", function)
        centers = cell_centers(n * points)
        # One band of rows at a time: all points together would need gigabytes.
        band = max(1, _MAX_EVALUATED // (n * points * points))
        rows = []
        for start in range(0, n, band):
            part = centers[start * points : (start + band) * points]
            returned = validation.array("function", function(centers[None, :], part[:, None]))
            try:
                band_values = np.broadcast_to(returned, (len(part), n * points))
            except ValueError:
                raise ValueError(
                    f"function must return a number, or values of the shape ({len(part)}, {n * points}) that x and y "
                    f"broadcast to, got shape {returned.shape}"
                ) from None
            if points > 1:
                band_values = band_values.reshape(-1, points, n, points).mean(axis=(1, 3))
            rows.append(band_values)
        return cls(np.concatenate(rows), squares)

    @property
    def side(self) -> int:
        """Number of samples along each side."""
        return len(self.values)

    def at(self, x: Array, y: Array) -> Values:
        """Return the transmission of the cell that contains each point (`x`, `y`), 0 outside of the square.

        TypeError or ValueError if coordinates are not real and finite.
        """
        # Clipped: coordinates far outside would overflow the conversion to integers.
        x, y = (np.clip(validation.real_array(name, part), -2.0, 2.0) for name, part in (("x", x), ("y", y)))
        row, column = (np.floor(0.5 * (part + 1.0) * self.side) for part in (y, x))
        # The far edge belongs to the last cell.
        row, column = np.where(y == 1.0, self.side - 1, row), np.where(x == 1.0, self.side - 1, column)
        inside = (row >= 0) & (row < self.side) & (column >= 0) & (column < self.side)
        index = (np.where(inside, part, 0).astype(np.int64) for part in (row, column))
        return np.asarray(np.where(inside, self.values[tuple(index)], 0.0))

    def _content(self) -> bytes:
        """Return a digest of the values."""
        return self._digest

    def __repr__(self) -> str:
        kind = "squares" if self.squares else "samples"
        return f"Mask(<{self.side} x {self.side} {kind}, mean {self.values.mean():.4g}>)"

    def to_dict(self) -> Json:
        """Return plain types: values as little-endian float64 (complex: pairs), deflated, in base64."""
        flag = {"complex": True} if self.values.dtype.kind == "c" else {}
        data = zlib.compress(self.values.astype("<c16" if flag else "<f8").tobytes(), 6)
        description = {"side": self.side, "values": base64.b64encode(data).decode("ascii"), **flag}
        return {**description, "squares": True} if self.squares else description

    @classmethod
    def from_dict(cls, description: Json) -> Mask:
        """Rebuild a mask from a `description` by :meth:`to_dict`; KeyError, TypeError or ValueError if invalid."""
        side = validation.integer("side", description["side"], least=2, most=MAX_SIDE)
        packed = base64.b64decode(description["values"], validate=True)
        # Decompressed in place: a second copy might need another gigabyte.
        kind = np.complex128 if validation.truth("complex", description.get("complex", False)) else np.float64
        values, unpack, end = np.empty((side, side), kind), zlib.decompressobj(), 0
        buffer = values.data.cast("B")
        while part := unpack.decompress(packed, 2**20):
            if end + len(part) > len(buffer):
                raise ValueError(f"values must be {side} x {side}, got more")
            buffer[end : end + len(part)] = part
            end, packed = end + len(part), unpack.unconsumed_tail
        if end != len(buffer):
            raise ValueError(f"values must be {side} x {side}, got {end} bytes")
        if sys.byteorder == "big":
            values = values.byteswap()
        if not np.isfinite(values).all() or (kind is np.float64 and not values.min() >= 0.0):
            raise ValueError("values must be finite, and >= 0 unless they are complex")
        mask = object.__new__(cls)
        vars(mask)["squares"] = validation.truth("squares", description.get("squares", False))
        values += 0.0  # no -0
        mask._store(values)
        return mask


def cell_centers(side: int) -> Array:
    """Return the centres of `side` equal cells of [-1, 1]."""
    return (2.0 * np.arange(side) + 1.0 - side) / side
