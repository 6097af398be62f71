"""Base class of blur operators, their conversion to SciPy, and sums over mirrored edges."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Values

if TYPE_CHECKING:
    from scipy.sparse.linalg import LinearOperator


class LinearBlur(ABC):
    """A blur as a linear operator on linear light: ``forward``, and its exact transpose, ``adjoint``.

    Attributes
    ----------
    shape : (int, int)
        Height and width of the images.
    channels : int
        Number of channels; an image of a single one may lack their axis.
    dtype : dtype
        Type of the computation and of the results, float32 or float64.
    """

    shape: tuple[int, int]
    channels: int
    dtype: np.dtype[np.floating]

    @abstractmethod
    def forward(self, image: Values) -> Values:
        """Return the blurred image of linear light.

        Parameters
        ----------
        image : ndarray of float, shape (height, width) or (height, width, channels)
            Light.

        Returns
        -------
        ndarray
            Of the shape of `image` and the dtype of the operator.

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
            Of the shape of `image` and the dtype of the operator.

        Raises
        ------
        TypeError, ValueError
            As :meth:`forward`.
        """

    def as_linear_operator(self) -> LinearOperator:
        """Return the operator for the solvers of SciPy and of packages that take its operators.

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
        dims = self.shape if self.channels == 1 else (*self.shape, self.channels)
        return linear_operator(self.forward, self.adjoint, dims, dims, self.dtype)

    def require(self, image: ArrayLike, name: str = "image", *, missing: bool = False) -> Values:
        """Return `image` as an array; TypeError or ValueError with its `name` unless it is finite and of this shape.

        With `missing` it may hold NaN.
        """
        array = validation.array(name, image)
        if array.dtype.kind != "f":
            raise TypeError(f"{name} must hold floats in proportion to light, got {array.dtype}")
        wanted = (*self.shape, self.channels) if array.ndim == 3 or self.channels > 1 else self.shape
        if array.shape != wanted:
            raise ValueError(f"{name} must have the shape {wanted}, got {array.shape}")
        fine = np.isfinite(array) | np.isnan(array) if missing else np.isfinite(array)
        if not fine.all():
            limit = "finite, or NaN where it is unknown" if missing else "finite"
            raise ValueError(f"{name} must be {limit}, got {array[~fine].flat[0]}")
        return array

    def planes(self, image: Values) -> Values:
        """Return the channels of an `image`, of the type of the sums; ValueError if that overflows."""
        given = self.require(image)
        with np.errstate(over="ignore"):
            made = np.require(given, self.dtype, "A")
        if made.dtype != given.dtype and not np.all(np.isfinite(made)):
            most = float(np.abs(given).max())
            raise ValueError(f"image must be at most {np.finfo(self.dtype).max:.3g}, as sums are, got {most:g}")
        return np.moveaxis(made.reshape(*self.shape, self.channels), 2, 0)

    def by_channel(self, image: Values, make: Callable[[int, Values], Values]) -> Values:
        """Return the image made by `make`, of channel and plane, from an `image`; ValueError if misshapen."""
        validation.function("make", make)
        out = np.empty((*self.shape, self.channels), dtype=self.dtype)
        for channel, plane in enumerate(self.planes(image)):
            made = np.asarray(make(channel, plane))
            if made.shape != self.shape:
                raise ValueError(f"make must return planes of the shape {self.shape}, got {made.shape}")
            out[..., channel] = made
        return out.reshape(np.shape(image))


def linear_operator(
    forward: Callable[[Values], Values],
    adjoint: Callable[[Values], Values],
    made: tuple[int, ...],
    dims: tuple[int, ...],
    dtype: np.dtype[np.floating],
) -> LinearOperator:
    """Return functions of images, of the shape `dims`, and of results, of the shape `made`, for SciPy's solvers."""
    from scipy.sparse.linalg import LinearOperator

    def of_vectors(way: Callable[[Values], Values], shape: tuple[int, ...]) -> Callable[[Values], Values]:
        def act(vector: Values) -> Values:
            return way(np.asarray(vector, dtype=np.result_type(vector, np.float32)).reshape(shape)).reshape(-1)

        return act

    operator = LinearOperator(
        (math.prod(made), math.prod(dims)), of_vectors(forward, dims), of_vectors(adjoint, made), dtype=dtype
    )
    operator.dims = dims
    return operator


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
