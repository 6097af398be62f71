"""Recorded images in counts of the camera, with masks of the usable, saturated and hidden pixels."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, Protocol, Self, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Index, Json, Values
from lommel.base.quantities import BARE, refuse_electrons
from lommel.fit.findings import Finding
from lommel.recorded.headers import metadata_of, with_header
from lommel.recorded.noise import Noise

_MIN_LEVELS = 8  # least number of different values whose common divisor is told
_FULL_SCALES = {2.0**bits - 1.0: bits for bits in (8, 10, 12, 14, 16)}  # largest value of converters: bits
_LEAST = 3  # smallest number of pixels with the largest value that counts as saturation
_COUNTS = 3.0  # standard deviation of the noise, counts, from which equal values are rare
_MAX_RATIO = (
    2.0  # ratio of pixels with the largest value to pixels just below it, above which the value counts as saturated
)


def full_value(planes: Sequence[Values], stated: float | None, *, name: str = "pixels") -> tuple[float, str]:
    """Return the smallest saturated value (infinity for none), and a note if this value was assumed, else "".

    The value is `stated`, if given. Otherwise it is the full scale of a camera of 8, 10, 12, 14 or 16 bits if that is
    the largest value of all `planes` and more pixels have it than noise explains; else the largest of the dtype.
    """
    if stated is not None:
        limit = validation.real("saturation", stated, least=-LARGEST, infinite=True)
        return (limit if limit < LARGEST else math.inf), ""
    type_limit = _type_limit(planes[0].dtype)
    with np.errstate(invalid="ignore"):
        top = max((float(np.fmax.reduce(plane, axis=None)) for plane in planes if plane.size), default=math.nan)
        if top not in _FULL_SCALES or top >= type_limit:
            return type_limit, ""
        # Upper bound on the noise at the largest value: sqrt(top) counts for one electron or more per count.
        noise_width = max(math.sqrt(top), _COUNTS)
        bottom = min(float(np.fmin.reduce(plane, axis=None)) for plane in planes if plane.size)
        count = sum(int((plane == top).sum()) for plane in planes)
        near_count = sum(int(((plane < top) & (plane >= top - noise_width)).sum()) for plane in planes)
    # An image whose values are all equal within the noise is uniform, not saturated.
    if count < _LEAST or count <= _MAX_RATIO * near_count or top - bottom <= noise_width:
        return type_limit, ""
    return top, (
        f"{count} {name} have exactly the largest value, {top:.10g}, that of {_FULL_SCALES[top]} bits: "
        "they were taken as saturated; saturation= sets another limit"
    )


def _type_limit(dtype: np.dtype[Any]) -> float:
    """Return the largest value of integers of a type; infinity for floats."""
    return float(np.iinfo(dtype).max) if dtype.kind in "iu" else math.inf


def flat_top(values: Values, valid: NDArray[np.bool_], noise: Noise) -> tuple[float, int]:
    """Return the largest valid value and its number of pixels, if noise does not explain that number; else (nan, 0).

    Without saturation, the pixels within one standard deviation below the largest value are at least as many as the
    pixels with this value.
    """
    valid_values = values[valid]
    if valid_values.size == 0:
        return np.nan, 0
    top = float(valid_values.max())
    count = int((valid_values == top).sum())
    if count < _LEAST:
        return np.nan, 0
    noise = noise.poisson
    gain = 1.0 if noise.white is None else noise.white
    white, read, offset = (float(np.median(part)) for part in (gain, noise.read, noise.offset))
    sigma = float(np.sqrt(max((top - offset) * white, 0.0) + read**2)) / white
    # Integers with a noise of a few counts are often equal without saturation.
    if sigma < _COUNTS and bool((valid_values == np.rint(valid_values)).all()):
        return np.nan, 0
    near_count = int(((valid_values < top) & (valid_values >= top - sigma)).sum())
    return (top, count) if count > _MAX_RATIO * near_count else (np.nan, 0)


LARGEST = 1e15  # largest accepted value, counts: far above any camera's, and its square fits in float32


class OnDemand:
    """Base class of stacks whose images are read on demand."""


@dataclass(frozen=True, eq=False, repr=False)
class Counts:
    """Recorded images in counts of a camera, with its noise, and with masks of hidden and saturated pixels.

    :meth:`Counts.of` returns them. Functions that take images with ``noise=`` also take counts, without it.

    Attributes
    ----------
    values : array, shape (..., height, width)
        Values in counts of the camera, of the type that was stored; a stack that is read on demand stays one.
    mask : ndarray of bool or None
        Pixels hidden by a mask; None without a mask.
    stated : float or None
        Smallest value of saturated pixels, if it was stated.
    noise : Noise or None
        Noise of the camera, completed by the header of the images; None if it is unknown.
    metadata : dict
        What the images state of their recording, as in :class:`lommel.recorded.Frames`.
    hidden : ndarray of bool, shape (..., height, width)
        Pixels that are ignored: NaN, infinite, or masked.
    full : ndarray of bool, shape (..., height, width)
        Saturated pixels that are not hidden.
    saturation : float
        Smallest value of saturated pixels; infinity for none.
    assumed : str
        Note on an assumed saturation, or "".
    """

    values: Any
    mask: NDArray[np.bool_] | None
    stated: float | None
    noise: Noise | None
    metadata: Json = field(default_factory=dict)

    @classmethod
    def of(
        cls, array: ArrayLike, *, noise: Noise, mask: ArrayLike | None = None, saturation: float | None = None
    ) -> Counts:
        """Return an array as counts, with the noise of its camera.

        Parameters
        ----------
        array : array_like, shape (..., height, width)
            Integers or floats; NaN, infinite and masked values (NumPy, astropy) are hidden. Frames, and arrays in
            chunks (dask, Zarr, h5py), are read when their images are needed.
        noise : Noise
            Gain, offset and read noise, each a number or a map (height, width). A gain and an excess that it does not
            state are those of the images, as of a FITS file or a CCDData. Values that differ are told.
        mask : array_like of bool, optional
            True for pixels to ignore; its shape is the shape of `array`, or of its last two or more axes.
        saturation : float, optional
            Pixels of this value or more are saturated. By default the largest value of the integer type or, if many
            pixels have the largest value of 8 to 16 bits, this value.

        Returns
        -------
        Counts

        Raises
        ------
        TypeError, ValueError
            If an argument is of another type or shape.

        Examples
        --------
        The last row is dead, and the camera saturates at 4000:

        >>> import lommel as lm
        >>> star = np.array([[101, 130, 99], [140, 4007, 104], [0, 0, 0]], dtype=np.uint16)
        >>> noise = lm.Noise(white=0.46, read=1.6, offset=100)
        >>> dead = [[False] * 3, [False] * 3, [True] * 3]
        >>> counts = lm.Counts.of(star, noise=noise, mask=dead, saturation=4000)
        >>> counts.marked()[1].tolist(), int(counts.hidden.sum())
        ([140.0, nan, 104.0], 3)
        """
        if isinstance(array, Counts):
            raise TypeError("array must be an array without noise, got Counts")
        validation.instance("noise", noise, Noise)
        counts = _counts("array", array, mask, saturation, noise, is_read=not is_on_demand(array))
        if len(counts.shape) < 2 or 0 in counts.shape:
            raise ValueError(f"array must have the shape (..., height, width), got {counts.shape}")
        noise.require_shape(counts.shape)
        return counts

    @property
    def shape(self) -> tuple[int, ...]:  # noqa: D102
        return tuple(self.values.shape)

    def __len__(self) -> int:
        return self.shape[0]

    def __repr__(self) -> str:
        return f"<Counts: {' x '.join(map(str, self.shape))}, {self.values.dtype}>"

    def __getitem__(self, index: Index) -> Counts:
        """Return some of the images, by indices along the axes before the last two; they are read now, if not yet."""
        mask = None if self.mask is None else self.mask[index]
        if isinstance(self.values, np.ndarray):
            part = replace(self, values=self.values[index], mask=mask)
        else:
            part = _counts("array", self.values[index], mask, None, self.noise)
            part = replace(part, stated=self.stated, metadata=self.metadata)
        vars(part)["_source"] = self._whole
        return part

    def read(self) -> Counts:
        """Return the counts with all images in memory."""
        return self if isinstance(self.values, np.ndarray) else self[...]

    @cached_property
    def hidden(self) -> NDArray[np.bool_]:  # noqa: D102
        if not isinstance(self.values, np.ndarray):
            return self.read().hidden
        unmasked = np.zeros(self.shape, dtype=bool) if self.values.dtype.kind != "f" else ~np.isfinite(self.values)
        return unmasked if self.mask is None else unmasked | self.mask

    @cached_property
    def full(self) -> NDArray[np.bool_]:  # noqa: D102
        return np.asarray((self.read().values >= self.saturation) & ~self.hidden)

    @property
    def _whole(self) -> Counts:
        """All images, of which these may be some: the assumed saturation is that of all."""
        # Not cached: images that refer to themselves stay in memory until garbage is collected.
        return cast(Counts, vars(self).get("_source", self))

    @cached_property
    def _limit(self) -> tuple[float, str]:
        """Smallest saturated value, and a note if it was assumed."""
        return full_value(_Unhidden(self), self.stated) if self._whole is self else self._whole._limit

    @property
    def saturation(self) -> float:  # noqa: D102
        return self._limit[0]

    @property
    def assumed(self) -> str:  # noqa: D102
        return self._limit[1]

    def known_noise(self) -> Noise:
        """Return the noise; TypeError if it is unknown, or not a Noise."""
        if not isinstance(self.noise, Noise):
            raise TypeError(f"noise must be a Noise, got {validation.shown(self.noise)}")
        return self.noise

    @property
    def known(self) -> NDArray[np.bool_]:
        """Usable pixels: neither hidden nor saturated."""
        return ~(self.hidden | self.full)

    def filled(self) -> Array:
        """Return the values as float64, 0 at pixels that are hidden or saturated."""
        return np.where(self.known, self.values, 0.0).astype(np.float64, copy=False)

    def require_known(self, name: str, least: float = 0.0) -> Self:
        """Return self; ValueError if the fraction of known pixels of an image is 0 or below `least`."""
        fractions = self.known.mean(axis=(-2, -1))
        too_few = np.argwhere((fractions == 0.0) | (fractions < least))
        if len(too_few):
            k = too_few[0].tolist()
            known = self.known[*k]
            needed = f"at least {math.ceil(least * known.size)} of {known.size} " if least else ""
            raise ValueError(
                f"{name}{k or ''} must have {needed}pixels that are neither masked, saturated nor NaN, "
                f"got {int(known.sum()) or 'none'}"
            )
        return self

    def marked(self) -> Values:
        """Return the values as stored if all pixels are known, else as floats with NaN at the other pixels."""
        if not (self.hidden.any() or self.full.any()):
            return np.asarray(self.values)
        # float32 represents all 16-bit integers exactly.
        kind = np.float32 if self.values.dtype.itemsize <= 2 or self.values.dtype == np.float32 else np.float64
        return np.where(self.known, self.values, kind(np.nan)).astype(kind, copy=False)

    def require_light(self, name: str, content: str) -> None:
        """Raise ValueError if the known pixels of an image are all equal; `content` names what is expected."""
        values, known = (part.reshape(-1, *self.values.shape[-2:]) for part in (self.values, self.known))
        for index, image, is_known in zip(np.ndindex(*self.values.shape[:-2]), values, known, strict=True):
            if np.ptp(image[is_known]) == 0:
                label = f"{name}{list(index) or ''}"
                raise ValueError(f"{label} must show {content}, got the value {image[is_known][0]:g} everywhere")


class _Unhidden(Sequence[Values]):
    """Images of counts with 0 at hidden pixels: an array as one, else one after the other as they are read."""

    def __init__(self, counts: Counts) -> None:
        self._counts = counts
        self._places: list[Any] = (
            [...] if isinstance(counts.values, np.ndarray) else list(np.ndindex(counts.shape[:-2]))
        )

    def __len__(self) -> int:
        return len(self._places)

    def __getitem__(self, number: Any) -> Any:
        place, counts = self._places[number], self._counts  # an IndexError ends the sequence
        image = counts if isinstance(counts.values, np.ndarray) else counts[place]
        return np.where(image.hidden, 0, image.values) if image.hidden.any() else image.values


def counts_of(
    name: str,
    images: object,
    noise: Noise | None = None,
    *,
    sides: tuple[int, ...],
    shape: str,
    mask: ArrayLike | None = None,
    saturation: float | None = None,
    empty: bool = False,
) -> Counts:
    """Return the counts of an argument, read: counts, an array, a container with a mask, or a list of arrays.

    Parameters
    ----------
    name : str
        Name of the argument in messages.
    images : array_like, container or Counts
        Integers or floats; the masks of NumPy's and astropy's containers apply. Counts have their own noise, mask
        and saturation.
    noise : Noise, optional
        Noise of an array; that of the result is None without it.
    sides : tuple of int
        Allowed numbers of axes.
    shape : str
        Allowed shapes in words, for messages.
    mask : array_like of bool, optional
        True for pixels to ignore; its shape is the shape of `images`, or of their last two or more axes.
    saturation : float, optional
        Smallest value of saturated pixels; by default see :func:`lommel.recorded.counts.full_value`.
    empty : bool, default False
        Whether an array without images is allowed.

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or shape, or if counts are given with a noise, mask or saturation.
    """
    if isinstance(images, Counts):
        for key, value in (("noise", noise), ("mask", mask), ("saturation", saturation)):
            if value is not None:
                raise TypeError(f"{key} must be omitted if {name} are Counts, which have their own")
        counts = images.read()
    else:
        shapes = {np.shape(part) for part in images} if isinstance(images, list | tuple) else set()
        if len(shapes) > 1:
            raise ValueError(f"{name} must have one shape {shape}, got {', '.join(map(str, sorted(shapes)))}")
        counts = _counts(name, images, mask, saturation, noise)
    values = counts.values
    if values.ndim not in sides or 0 in values.shape[-2:] or (values.size == 0 and not empty):
        raise ValueError(f"{name} must have the shape {shape}, got {values.shape}")
    return counts


def is_on_demand(array: object) -> bool:
    """Return True for images that are read when they are needed: frames, and arrays in chunks."""
    has_chunks = not isinstance(array, np.ndarray) and getattr(array, "chunks", None) is not None
    return isinstance(array, OnDemand) or has_chunks


def _counts(
    name: str, images: Any, mask: Any, saturation: float | None, noise: Noise | None, *, is_read: bool = True
) -> Counts:
    """Return counts of an array, which is kept as it is unless `is_read`; the mask of a container applies."""
    values, hidden = validation.parted(name, images, "counts") if is_read else (images, None)
    if isinstance(noise, Noise) and np.any(np.asarray(1.0 if noise.white is None else noise.white) != 1.0):
        refuse_electrons(name, images)
    metadata: Json = {}
    if type(images) not in BARE:
        metadata = metadata_of(name, images)
        if isinstance(noise, Noise) or (noise is None and isinstance(metadata.get("read"), float)):
            noise, saturation = with_header(noise, saturation, metadata)
    if is_read:
        _require_within(name, values)
    if mask is not None:
        mask_values = validation.array("mask", mask)
        if (
            mask_values.dtype != bool
            or mask_values.ndim < 2
            or mask_values.shape != values.shape[-mask_values.ndim :]
        ):
            raise ValueError(
                f"mask must be True or False for each pixel of {name} {values.shape}, got {mask_values.dtype} of "
                f"shape {mask_values.shape}"
            )
        hidden = np.broadcast_to(mask_values, values.shape) if hidden is None else hidden | mask_values
    return Counts(values, hidden, None if saturation is None else full_value([], saturation)[0], noise, metadata)


def recording_findings(images: Sequence[Counts], noise: Noise, name: str) -> list[Finding]:
    """Return findings on pixels that are ignored, and on pixels that may be saturated."""
    total = sum(image.values.size for image in images)
    count = total - sum(int(image.known.sum()) for image in images)
    findings = []
    if count:
        text = f"{count} of {total} pixels left out (masked, saturated or NaN)"
        findings.append(Finding("left_out", "note", text, {"pixels": count, "of": total}))
    assumed = dict.fromkeys(image.assumed for image in images if image.assumed)
    findings += [Finding("saturation_assumed", "note", text) for text in assumed]
    findings += scale_findings(images, noise)
    if remark := flat_tops(images, noise, name):
        findings.append(Finding("flat_top", "note", remark))
    return findings


def scale_findings(images: Sequence[Counts], noise: Noise) -> list[Finding]:
    """Return the finding on counts that are multiples of an integer, or fractions of a full scale, as a list."""
    known = np.unique(np.concatenate([image.values[image.known] for image in images]))
    if known.size < _MIN_LEVELS:
        return []
    top = float(known[-1])
    if (known == np.rint(known)).all():
        divisor = int(np.gcd.reduce(known.astype(np.int64)))
        text = (
            f"all values are multiples of {divisor}, as of {16 - divisor.bit_length() + 1} bits stored in 16: gain, "
            f"offset and saturation must be those of the stored values, the gain 1/{divisor} of that of the camera"
        )
        return [Finding("multiples", "note", text, {"divisor": divisor})] if divisor > 1 else []
    if top > 1.0 or float(np.max(noise.white or 1.0)) * top > 1.0:
        return []
    text = (
        f"the largest value is {top:.3g}, of less than one electron: counts are expected; if the values were divided "
        "by their full scale, state the electrons at 1 (white=)"
    )
    return [Finding("no_counts", "note", text, {"largest": top})]


def flat_tops(images: Sequence[Counts], noise: Noise, name: str) -> str:
    """Return a remark on images with the full scale of a camera, or on the first with a :func:`flat_top`, or ""."""
    # Without saturation, the largest value scatters by the noise: it is a full scale in less than 1 % of recordings.
    unstated = all(image.saturation == _type_limit(image.values.dtype) for image in images)
    known = [image.values[image.known] for image in images]
    top = max((float(values.max()) for values in known if values.size), default=math.nan)
    if unstated and top in _FULL_SCALES and all(bool((values == np.rint(values)).all()) for values in known):
        count, bits = sum(int((values == top).sum()) for values in known), _FULL_SCALES[top]
        return (
            f"{count} pixel{'s have' if count > 1 else ' has'} the value {top:.0f} = 2^{bits} - 1, the largest of "
            f"{bits} bits, and may be saturated: if so, state it (saturation={top:.0f})"
        )
    for k, image in enumerate(images):
        top, count = flat_top(image.values, image.known, noise)
        if count:
            place = f" of {name} {k}" if len(images) > 1 else ""
            return (
                f"{count} pixels{place} have exactly the largest value, {top:.10g}: if they are saturated, state it "
                f"(saturation={top:.10g})"
            )
    return ""


PlanePart = int | tuple[int, *tuple[slice, ...]]
"""Index of a plane of a stack, or of a plane and slices of its rows and columns."""


class Stack(Protocol):
    """Planes of equal size, read one by one: an array, or a recording in a file."""

    @property
    def shape(self) -> tuple[int, ...]:
        """Numbers of planes, rows and columns."""

    @property
    def dtype(self) -> np.dtype[Any]:
        """Type of the stored values."""

    def __len__(self) -> int: ...

    def __getitem__(self, index: PlanePart, /) -> Values: ...


def plane_of(stack: Stack, number: int) -> Values:
    """Return a plane of a stack, infinities as NaN; ValueError if a value is too large to be squared in float32."""
    values = validation.array("stack", stack[number], "counts")
    if values.dtype.kind != "f":
        return values
    unknown = np.isinf(values)
    values = np.where(unknown, values.dtype.type(np.nan), values) if unknown.any() else values
    _require_within("stack", values)
    return values


def _require_within(name: str, values: Values) -> None:
    """Raise ValueError if a finite value is too large to be squared in float32."""
    if values.dtype.kind != "f":
        return
    sizes = np.abs(values, where=np.isfinite(values), out=np.zeros_like(values))
    if not sizes.max(initial=0.0) < LARGEST:
        got = values.flat[int(sizes.argmax())]
        raise ValueError(f"{name} must be within {LARGEST:g}, or NaN where a value is unknown, got {got:g}")
