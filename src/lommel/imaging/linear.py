"""Base class of blur operators, their conversion to SciPy, and sums over mirrored edges."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Values

if TYPE_CHECKING:
    from scipy.sparse.linalg import LinearOperator


class LinearBlur(ABC):
    """A blur as a linear operator on linear light: ``forward``, and its exact transpose, ``adjoint``.

    Attributes
    ----------
    dtype : dtype
        Of the sums and of the results, float32 or float64.
    """

    dtype: np.dtype[np.floating]

    @property
    @abstractmethod
    def shape(self) -> tuple[int, int]:
        """Height and width of the images."""

    @property
    @abstractmethod
    def channels(self) -> int:
        """Number of channels; an image of a single one may lack their axis."""

    @abstractmethod
    def forward(self, image: Values) -> Values:
        """Return the image that the lens makes of linear light.

        Parameters
        ----------
        image : ndarray of float, shape (height, width) or (height, width, channels)
            Light.

        Returns
        -------
        ndarray
            Of the shape of `image`, and of the type of the sums.

        Raises
        ------
        TypeError, ValueError
            If `image` has another shape, or holds anything but finite floats.
        """

    @abstractmethod
    def adjoint(self, image: Values) -> Values:
        """Return the transpose of :meth:`forward` applied to an image: ``<forward(a), b> = <a, adjoint(b)>``.

        Parameters
        ----------
        image : ndarray of float
            Of the shape that :meth:`forward` takes.

        Returns
        -------
        ndarray
            Of the shape of `image`, and of the type of the sums.

        Raises
        ------
        TypeError, ValueError
            As :meth:`forward`.
        """

    def as_linear_operator(self) -> LinearOperator:
        """Return the operator for SciPy's solvers, and those of packages that take its operators.

        Images are vectors there: ``image.ravel()`` of those of shape `dims`, which is an attribute: (height, width),
        or (height, width, channels) of several channels. A matrix has an image in each column.

        Returns
        -------
        scipy.sparse.linalg.LinearOperator
            Square, of the type of the sums.

        Examples
        --------
        >>> lens = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
        >>> blur = lm.imaging.DepthBlur(np.full((20, 30), 2.5), lens, 8e-6, dtype=np.float64)
        >>> operator = blur.as_linear_operator()
        >>> operator.shape, operator.dims
        ((600, 600), (20, 30))
        >>> light = np.random.default_rng(0).random((20, 30))
        >>> bool(np.all(operator @ light.ravel() == blur.forward(light).ravel()))
        True
        """
        from scipy.sparse.linalg import LinearOperator

        dims = self.shape if self.channels == 1 else (*self.shape, self.channels)
        size = int(np.prod(dims))

        def applied(way: Callable[[Values], Values]) -> Callable[[Values], Values]:
            return lambda vector: way(np.asarray(vector, dtype=self.dtype).reshape(dims)).reshape(-1)

        operator = LinearOperator(
            (size, size), matvec=applied(self.forward), rmatvec=applied(self.adjoint), dtype=self.dtype
        )
        operator.dims = dims
        return operator

    def require(self, image: Values) -> None:
        """Raise TypeError or ValueError unless `image` holds finite floats and has the shape of the operator."""
        array = validation.array("image", image)
        wanted = (*self.shape, self.channels) if array.ndim == 3 or self.channels > 1 else self.shape
        if array.shape != wanted:
            raise ValueError(f"image must have the shape {wanted}, got {array.shape}")
        if array.dtype.kind != "f":
            raise TypeError(f"image must hold floats in proportion to light, got {array.dtype}")
        if not np.all(np.isfinite(array)):
            raise ValueError(f"image must be finite, got {array[~np.isfinite(array)].flat[0]}")

    def planes(self, image: Values) -> Values:
        """Return the channels of an `image`, of the type of the sums; ValueError if that overflows."""
        self.require(image)
        made = self.apart(image)
        if made.dtype != np.asarray(image).dtype and not np.all(np.isfinite(made)):
            most = float(np.abs(image).max())
            raise ValueError(f"image must be at most {np.finfo(self.dtype).max:.3g}, as sums are, got {most:g}")
        return made

    def apart(self, image: Values) -> Values:
        """Return the channels of an `image` as :meth:`planes`, without its checks; TypeError if it is no array."""
        given = validation.array("image", image)
        if given.dtype.kind != "f":
            raise TypeError(f"image must hold floats in proportion to light, got {validation.shown(image)}")
        if given.size != self.shape[0] * self.shape[1] * self.channels or given.shape[:2] != self.shape:
            raise ValueError(f"image must have the shape {(*self.shape, self.channels)}, got {given.shape}")
        with np.errstate(over="ignore"):
            array = np.require(given, self.dtype, "A")
        return np.moveaxis(array.reshape(*self.shape, self.channels), 2, 0)

    def by_channel(self, image: Values, make: Callable[[int, Values], Values]) -> Values:
        """Return the image made by `make`, of channel and plane, from an `image`; ValueError if misshapen."""
        if not callable(make):
            raise TypeError(f"make must be callable, got {validation.shown(make)}")
        out = np.empty((*self.shape, self.channels), dtype=self.dtype)
        for channel, plane in enumerate(self.planes(image)):
            made = np.asarray(make(channel, plane))
            if made.shape != self.shape:
                raise ValueError(f"make must return planes of the shape {self.shape}, got {made.shape}")
            out[..., channel] = made
        return out.reshape(np.shape(image))


def folded(room: Values, beyond: int, count: int) -> Values:
    """Return `count` rows of an image between two mirrors, with the light that these spread `beyond` them."""
    image = room[beyond : beyond + count]
    for first in range(beyond % count - count, len(room), count):  # So many lie between two mirrors.
        if first != beyond:
            part = room[max(0, first) : first + count]
            onto = image[::-1] if (first - beyond) // count % 2 else image
            onto[max(0, -first) :][: len(part)] += part
    return image


def gathered(taken: Values, places: NDArray[np.int64], count: int) -> Values:
    """Return sums, shape (count, any), of the rows that have the same place."""
    if len(places) == count:
        return taken
    total = np.zeros((count, taken.shape[1]), dtype=taken.dtype)
    for place, row in zip(places, np.ascontiguousarray(taken), strict=True):
        total[place] += row
    return total
