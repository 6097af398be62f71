"""Images as a camera counted them: their values, and which of their pixels are known, saturated or left out."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Protocol, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Index, Values
from lommel.fit.findings import Finding
from lommel.recorded.noise import Noise

_BITS = (8, 10, 12, 14, 16)  # of cameras' converters, whose largest values are saturation
_LEAST = 3  # pixels of the same largest value
_COUNTS = 3.0  # standard deviation of the noise, in counts, above which equal values are rare
_OFTEN = 2.0  # ratio to the number of pixels that noise puts just below


def full_value(planes: Sequence[Values], stated: float | None, *, name: str = "pixels") -> tuple[float, str]:
    """Return the value from which on pixels are saturated (infinity for none), and what was assumed, or "".

    It is the one that was stated; else the largest of the integer type; or of a camera of 8, 10, 12, 14 or 16 bits,
    where it is the largest value of all `planes` and more pixels have it than noise explains.
    """
    if stated is not None:
        return validation.real("saturation", stated, infinite=True), ""
    kind = planes[0].dtype
    most = float(np.iinfo(kind).max) if kind.kind in "iu" else math.inf
    with np.errstate(invalid="ignore"):
        top = max((float(np.fmax.reduce(plane, axis=None)) for plane in planes if plane.size), default=math.nan)
        if top + 1.0 not in [2.0**bits for bits in _BITS] or top >= most:
            return most, ""
        # Noise of the largest value: at most sqrt(top) counts for an electron a count or more.
        spread = max(math.sqrt(top), _COUNTS)  # at most that of a camera that counts each electron, or several
        least = min(float(np.fmin.reduce(plane, axis=None)) for plane in planes if plane.size)
        count = sum(int((plane == top).sum()) for plane in planes)
        near = sum(int(((plane < top) & (plane >= top - spread)).sum()) for plane in planes)
    # A uniform image has a single value, not a saturated one.
    if count < _LEAST or count <= _OFTEN * near or top - least <= spread:
        return most, ""
    return top, (
        f"{count} {name} have exactly the largest value, {top:.10g}, that of {math.log2(top + 1.0):.0f} bits: they "
        "were taken as saturated; saturation= states another"
    )


def flat_top(values: Values, valid: NDArray[np.bool_], noise: Noise) -> tuple[float, int]:
    """Return the largest valid value and how many pixels have it, if noise does not explain so many; else (nan, 0).

    Without saturation, pixels are at least as frequent in the range of the noise below the largest value as at it.
    """
    seen = values[valid]
    if seen.size == 0:
        return np.nan, 0
    top = float(seen.max())
    count = int((seen == top).sum())
    if count < _LEAST:
        return np.nan, 0
    noise = noise.poisson
    gain = 1.0 if noise.white is None else noise.white
    white, read, offset = (float(np.median(part)) for part in (gain, noise.read, noise.offset))
    spread = float(np.sqrt(max((top - offset) * white, 0.0) + read**2)) / white
    # Where noise is hardly more than a count, many pixels have the same one.
    if spread < _COUNTS and bool((seen == np.rint(seen)).all()):
        return np.nan, 0
    near = int(((seen < top) & (seen >= top - spread)).sum())
    return (top, count) if count > _OFTEN * near else (np.nan, 0)


_LARGEST = 1e15  # largest value: far above every camera's, and products of a few still fit in float32


@dataclass(frozen=True, eq=False)
class Counts:
    """Recorded images and what is known of each pixel.

    Attributes
    ----------
    values : ndarray, shape (..., height, width)
        In the unit of the camera and of the type that was stored.
    hidden : ndarray of bool, of the same shape
        Pixels that are not to be used: NaN, infinite, or masked.
    full : ndarray of bool, of the same shape
        Others that are saturated.
    saturation : float
        Value from which on pixels are full; infinity for none.
    assumed : str
        What was assumed of saturation, or "".
    """

    values: Values
    hidden: NDArray[np.bool_]
    full: NDArray[np.bool_]
    saturation: float
    assumed: str

    @classmethod
    def of(
        cls,
        name: str,
        images: object,
        *,
        sides: tuple[int, ...],
        shape: str,
        mask: ArrayLike | None = None,
        saturation: float | None = None,
        empty: bool = False,
    ) -> Self:
        """Return the counts of an argument: arrays, containers with a mask, or several in a list.

        Parameters
        ----------
        name : str
            Of the argument, in messages.
        images : array_like or container
            Integers or floats; masks of NumPy's and astropy's containers are honoured.
        sides : tuple of int
            Numbers of axes that it may have, `shape` in words.
        mask : array_like of bool, optional
            True for pixels that are not to be used, of the shape of `images`, of one stack or of one image of them.
        saturation : float, optional
            Value from which on pixels are full; by default see :func:`lommel.recorded.counts.full_value`.
        empty : bool, default False
            Whether there may be no image at all.

        Raises
        ------
        TypeError, ValueError
            If an argument is of another type or shape.
        """
        shapes = {np.shape(part) for part in images} if isinstance(images, list | tuple) else set()
        if len(shapes) > 1:
            raise ValueError(f"{name} must have one shape {shape}, got {', '.join(map(str, sorted(shapes)))}")
        values, hidden = validation.parted(name, images)
        if values.ndim not in sides or 0 in values.shape[-2:] or (values.size == 0 and not empty):
            raise ValueError(f"{name} must have the shape {shape}, got {values.shape}")
        left = np.zeros(values.shape, dtype=bool) if values.dtype.kind != "f" else ~np.isfinite(values)
        _require_within(name, values)
        if hidden is not None:
            left |= hidden
        if mask is not None:
            out = validation.array("mask", mask)
            if out.dtype != bool or out.ndim < 2 or out.shape != values.shape[-out.ndim :]:
                raise ValueError(
                    f"mask must be True or False for each pixel of {name} {values.shape}, got {out.dtype} of "
                    f"{out.shape}"
                )
            left |= out
        limit, assumed = full_value([np.where(left, 0, values) if left.any() else values], saturation)
        full = (values >= limit) & ~left
        return cls(values, left, full, limit, assumed)

    @property
    def known(self) -> NDArray[np.bool_]:
        """Pixels that are neither hidden nor full."""
        return ~(self.hidden | self.full)

    def filled(self) -> Array:
        """Return the values as float64, 0 where a pixel is not known."""
        return np.where(self.known, self.values, 0.0).astype(np.float64, copy=False)

    def require_known(self, name: str, least: float = 0.0) -> Self:
        """Return it; ValueError if an image has no pixel that is known, or less than this share of them."""
        shares = self.known.mean(axis=(-2, -1))
        few = np.argwhere((shares == 0.0) | (shares < least))
        if len(few):
            at = few[0].tolist()
            count = int(self.known[*at].sum())
            raise ValueError(
                f"{name}{at or ''} must have pixels that are neither masked, saturated nor NaN, got {count or 'none'}"
            )
        return self

    def marked(self) -> Values:
        """Return the values as stored if all are known, else as floats, NaN where they are not."""
        if not (self.hidden.any() or self.full.any()):
            return self.values
        # float32 holds every integer of 16 bits.
        kind = np.float32 if self.values.dtype.itemsize <= 2 or self.values.dtype == np.float32 else np.float64
        return np.where(self.known, self.values, kind(np.nan)).astype(kind, copy=False)

    def require_light(self, name: str, what: str) -> None:
        """Raise ValueError if the known pixels of an image are all equal."""
        values, known = (part.reshape(-1, *self.values.shape[-2:]) for part in (self.values, self.known))
        for place, image, good in zip(np.ndindex(*self.values.shape[:-2]), values, known, strict=True):
            if np.ptp(image[good]) == 0:
                where = f"{name}{list(place) or ''}"
                raise ValueError(f"{where} must show {what}, got the value {image[good][0]:g} everywhere")

    def __getitem__(self, at: Index) -> Counts:
        """Return some of the images, by the axes before the last two."""
        return Counts(self.values[at], self.hidden[at], self.full[at], self.saturation, self.assumed)


def recording_findings(images: Sequence[Counts], noise: Noise, name: str) -> list[Finding]:
    """Return findings on the pixels that are left out, and on those that may be saturated."""
    every = sum(each.values.size for each in images)
    count = every - sum(int(each.known.sum()) for each in images)
    found = []
    if count:
        text = f"{count} of {every} pixels left out (masked, saturated or NaN)"
        found.append(Finding("left_out", "note", text, {"pixels": count, "of": every}))
    assumed = dict.fromkeys(each.assumed for each in images if each.assumed)
    found += [Finding("saturation_assumed", "note", words) for words in assumed]
    if told := flat_tops(images, noise, name):
        found.append(Finding("flat_top", "note", told))
    return found


def flat_tops(images: Sequence[Counts], noise: Noise, name: str) -> str:
    """Return a remark on the first image with a flat top, which may be saturation; or ""."""
    for k, each in enumerate(images):
        top, equal = flat_top(each.values, each.known, noise)
        if equal:
            where = f" of {name} {k}" if len(images) > 1 else ""
            return (
                f"{equal} pixels{where} have exactly the largest value, {top:.10g}: if they are saturated, state it "
                f"(saturation={top:.10g}, --saturation {top:.10g})"
            )
    return ""


PlanePart = int | tuple[int, *tuple[slice, ...]]
"""A plane of a stack, or rows and columns of one."""


class Stack(Protocol):
    """Planes of one size, each read on its own: an array, or a recording that stays in its file."""

    @property
    def shape(self) -> tuple[int, ...]:
        """Planes, rows and columns."""

    @property
    def dtype(self) -> np.dtype[Any]:
        """The type of the values as they are stored."""

    def __len__(self) -> int: ...

    def __getitem__(self, at: PlanePart, /) -> Values: ...


def plane_of(stack: Stack, number: int) -> Values:
    """Return a plane of a stack, infinities as NaN; ValueError where values are too large to be squared."""
    values = validation.array("stack", stack[number])
    if values.dtype.kind != "f":
        return values
    unknown = np.isinf(values)
    values = np.where(unknown, values.dtype.type(np.nan), values) if unknown.any() else values
    _require_within("stack", values)
    return values


def _require_within(name: str, values: Values) -> None:
    """Raise ValueError if a finite value is too large to be squared in single precision."""
    if values.dtype.kind != "f":
        return
    far = np.abs(values, where=np.isfinite(values), out=np.zeros_like(values))
    if not far.max(initial=0.0) < _LARGEST:
        got = values.flat[int(far.argmax())]
        raise ValueError(f"{name} must be within {_LARGEST:g}, or NaN where a value is unknown, got {got:g}")
