"""Blur operators: base classes, conversion to SciPy operators, borders of images, and tiles."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Protocol, TypeVar

import numpy as np
import scipy
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Values

Window = tuple[slice, slice]

if TYPE_CHECKING:
    from scipy.sparse.linalg import LinearOperator


class LinearBlur(ABC):
    """A blur as a linear operator on linear light: ``forward``, and its exact transpose, ``adjoint``.

    Attributes
    ----------
    shape : (int, int)
        Height and width of the images.
    channels : int
        Number of channels; single-channel images may omit the channel axis.
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
            Image in linear light.

        Returns
        -------
        ndarray
            Blurred image, with the shape of `image` and the dtype of the operator.

        Raises
        ------
        TypeError, ValueError
            If `image` has another shape or type, or values that are not finite.
        """

    @abstractmethod
    def adjoint(self, image: Values) -> Values:
        """Return the transpose of :meth:`forward` applied to an image: ``<forward(a), b> = <a, adjoint(b)>``.

        Parameters
        ----------
        image : ndarray of float
            Image of a shape that :meth:`forward` accepts.

        Returns
        -------
        ndarray
            Transpose applied to `image`, with its shape and the dtype of the operator.

        Raises
        ------
        TypeError, ValueError
            See :meth:`forward`.
        """

    def as_linear_operator(self) -> LinearOperator:
        """Return the blur as a SciPy LinearOperator, for the solvers of SciPy and compatible packages.

        Its vectors are ``image.ravel()``; its attribute `dims` is the shape of the image, (height, width), or
        (height, width, channels) for several channels. A matrix has an image in each column.

        Returns
        -------
        scipy.sparse.linalg.LinearOperator
            Square operator of the dtype of the blur.

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

        def of_vectors(function: Callable[[Values], Values]) -> Callable[[Values], Values]:
            def act(vector: Values) -> Values:
                return function(np.asarray(vector, dtype=np.result_type(vector, np.float32)).reshape(dims)).reshape(
                    -1
                )

            return act

        side = math.prod(dims)
        operator = scipy.sparse.linalg.LinearOperator(
            (side, side), of_vectors(self.forward), of_vectors(self.adjoint), dtype=self.dtype
        )
        operator.dims = dims
        return operator

    def require(self, image: ArrayLike, name: str = "image", *, missing: bool = False) -> Values:
        """Return `image` as an array; TypeError or ValueError unless it has the right shape and finite floats.

        Messages contain `name`. With `missing`, values may be NaN.
        """
        array = validation.array(name, image, "counts")
        if array.dtype.kind != "f":
            raise TypeError(f"{name} must hold floats in proportion to light, got {array.dtype}")
        expected = (*self.shape, self.channels) if array.ndim == 3 or self.channels > 1 else self.shape
        if array.shape != expected:
            raise ValueError(f"{name} must have the shape {expected}, got {array.shape}")
        valid = np.isfinite(array) | np.isnan(array) if missing else np.isfinite(array)
        if not valid.all():
            limit = "finite, or NaN where it is unknown" if missing else "finite"
            raise ValueError(f"{name} must be {limit}, got {array[~valid].flat[0]}")
        return array

    def planes(self, image: Values) -> Values:
        """Return the channels of an `image` in the dtype of the operator; ValueError if that overflows."""
        array = self.require(image)
        with np.errstate(over="ignore"):
            converted = np.require(array, self.dtype, "A")
        if converted.dtype != array.dtype and not np.all(np.isfinite(converted)):
            largest = float(np.abs(array).max())
            raise ValueError(
                f"image must be at most {np.finfo(self.dtype).max:.3g}, the largest {self.dtype}, got {largest:g}"
            )
        return np.moveaxis(converted.reshape(*self.shape, self.channels), 2, 0)

    def by_channel(self, image: Values, make: Callable[[int, Values], Values]) -> Values:
        """Return the image of the planes ``make(channel, plane)``; ValueError if one has another shape."""
        validation.function("make", make)
        image_planes = np.empty((*self.shape, self.channels), dtype=self.dtype)
        for channel, plane in enumerate(self.planes(image)):
            result = np.asarray(make(channel, plane))
            if result.shape != self.shape:
                raise ValueError(f"make must return planes of the shape {self.shape}, got {result.shape}")
            image_planes[..., channel] = result
        return image_planes.reshape(np.shape(image))


Plane = tuple[slice, slice]
"""Rows and columns of a part of a plane."""
Result = TypeVar("Result")
Result_co = TypeVar("Result_co", covariant=True)


class PartConsumer(Protocol[Result_co]):
    """Function of a part of a plane and its values, called from several threads; it may overwrite the values."""

    def __call__(self, plane: int, rows: slice, columns: slice, values: Values, /) -> Result_co:
        """Return a result for a part."""


class PlaneOperator(ABC):
    """A blur of planes, whose results are passed in parts, so that they need not all be in memory.

    Attributes
    ----------
    shape, whole : (int, int, int)
        Planes, height and width of the recording (`shape`), and of the scene with its margin (`whole`).
    outside : ndarray or None
        Light in each plane beyond the margin, if modelled. `outside_back` is the transpose of the blur of this light,
        and `per_outside` the reciprocal of its recorded fraction.
    """

    shape: tuple[int, int, int]
    whole: tuple[int, int, int]
    outside: Values | None = None
    outside_back: Values
    per_outside: Values

    @abstractmethod
    def forward(self, specimen: Values, consume: PartConsumer[Result]) -> list[Result]:
        """Blur a scene, call `consume` once with each part of the image, and return its results."""

    @abstractmethod
    def adjoint(self, recording: Values, consume: PartConsumer[Result]) -> list[Result]:
        """Apply the transpose of :meth:`forward` to an image, call `consume` once with each part of the result."""

    @abstractmethod
    def per_seen(self, plane: int, rows: slice, columns: slice, /) -> Values:
        """Return 1 / (A^T w), with the blur A and the weights w of pixels; 0 for points that are not recorded."""

    def weigh(self, weight: float) -> None:  # noqa: B027 (nothing to do where pixels have weights of their own)
        """Set the largest weight of a pixel, by which :meth:`per_seen` is divided."""

    def release(self) -> None:  # noqa: B027 (nothing to free by default)
        """Free the memory of transforms."""


UNSEEN = 1e-6
"""Recorded fraction of the light of a point below which the point counts as not recorded."""


class ImagePlanes(PlaneOperator):
    """A linear blur of a weighted image, whose channels are the planes.

    Parameters
    ----------
    blur : LinearBlur
    weight : ndarray
        Weight of each pixel, with the shape of an image.
    """

    def __init__(self, blur: LinearBlur, weight: Values) -> None:
        self._blur, self._image = blur, weight.shape
        self.shape = self.whole = (blur.channels, *blur.shape)
        # Richardson-Lucy divides by this: points that are hardly recorded would diverge.
        recorded = np.maximum(blur.adjoint(weight), 0.0)
        reciprocal = np.where(recorded > UNSEEN, 1.0 / np.maximum(recorded, UNSEEN), 0.0)
        self._per = np.moveaxis(reciprocal.astype(blur.dtype, copy=False).reshape(*blur.shape, -1), 2, 0)

    def forward(self, specimen: Values, consume: PartConsumer[Result]) -> list[Result]:
        """Call `consume` with the blurred planes; see :meth:`PlaneOperator.forward`."""
        return self._apply(self._blur.forward, specimen, consume)

    def adjoint(self, recording: Values, consume: PartConsumer[Result]) -> list[Result]:
        """Call `consume` with the planes of the transpose; see :meth:`PlaneOperator.adjoint`."""
        return self._apply(self._blur.adjoint, recording, consume)

    def _apply(
        self, operator: Callable[[Values], Values], values: Values, consume: PartConsumer[Result]
    ) -> list[Result]:
        rows, columns = (slice(0, side) for side in self.shape[1:])
        planes = self.planes(operator(self.image(values)))
        return [consume(k, rows, columns, np.ascontiguousarray(plane)) for k, plane in enumerate(planes)]

    def image(self, planes: Values) -> Values:
        """Return planes as an image; a single plane shares its memory."""
        return np.ascontiguousarray(np.moveaxis(planes, 0, 2), self._blur.dtype).reshape(self._image)

    def planes(self, image: Values) -> Values:
        """Return the planes of an image, as a view."""
        return np.moveaxis(image.reshape(*self.shape[1:], -1), 2, 0)

    def per_seen(self, plane: int, rows: slice, columns: slice, /) -> Values:
        """Return the reciprocal of the transposed blur of the weights; 0 where that is below UNSEEN."""
        return self._per[plane, rows, columns]


def overlap(start: int, stop: int, side: int) -> tuple[slice, slice]:
    """Return the pixels (0 to `side`) inside a window from `start` to `stop`, and their indices in the window."""
    inside = slice(max(start, 0), max(min(stop, side), 0))
    return inside, slice(inside.start - start, inside.stop - start)


def folded(padded: Values, margins: Sequence[int], shape: Sequence[int]) -> Values:
    """Return the image of this `shape` within `padded`; what is outside is mirrored at the edges and added."""
    rows = _folded_rows(padded, margins[0], shape[0])
    return _folded_rows(rows.T, margins[1], shape[1]).T


def _folded_rows(padded: Values, margin: int, count: int) -> Values:
    image = padded[margin : margin + count]
    for start in range(margin % count - count, len(padded), count):  # periods of mirror images
        if start != margin:
            part = padded[max(0, start) : start + count]
            # Every other image is reversed.
            target = image[::-1] if (start - margin) // count % 2 else image
            target[max(0, -start) :][: len(part)] += part
    return image


def copies(count: int, margin: int) -> NDArray[np.int64]:
    """Return the index of the original row (or column) for each row of the image with its mirrored border."""
    return np.pad(np.arange(count, dtype=np.int64), margin, mode="symmetric")


def tiles_of(
    shape: Sequence[int], side: int | Sequence[int], overlap: int
) -> Iterator[tuple[Window, Window, Window]]:
    """Yield the slices of each tile, of the tile with its overlap, and of the tile inside that window."""
    down, across = (side, side) if isinstance(side, int) else side
    for top in range(0, shape[0], down):
        for left in range(0, shape[1], across):
            inside, around, within = [], [], []
            for start, size, tile_side in ((top, shape[0], down), (left, shape[1], across)):
                stop = min(size, start + tile_side)
                first, last = max(0, start - overlap), min(size, stop + overlap)
                inside.append(slice(start, stop))
                around.append(slice(first, last))
                within.append(slice(start - first, stop - first))
            yield (inside[0], inside[1]), (around[0], around[1]), (within[0], within[1])
