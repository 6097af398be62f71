"""The form of live frames: their size, channels, noise, and which of their pixels are known."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.core.engine import FocalScale
from lommel.optics.lens import Lens
from lommel.recorded.noise import Noise

Frame = NDArray[Any]

MAGNIFICATIONS = ("registered", "lens")
"""How frames of different focus are magnified: alike, or as by a lens at their sensor distances."""


def relative_exposures(given: Sequence[float], count: int) -> tuple[float, ...]:
    """Return stated exposures over the first; TypeError or ValueError unless they are `count` numbers above 0."""
    values = validation.real_array("exposures", given, least=1e-6, most=1e6)
    if values.shape != (count,):
        raise ValueError(f"exposures must be {count} numbers > 0, one for each lens, got {validation.shown(given)}")
    return tuple((values / values[0]).tolist())


class Registration:
    """Frames at the scale of the first, about their middle.

    Parameters
    ----------
    magnification : {"registered", "lens"}
        How they differ.
    lenses : sequence of Lens
    size : (int, int)
        Height and width, pixels.
    threads : int

    Attributes
    ----------
    scales : tuple of float
        Pitch that each frame has since, in pixels.
    """

    def __init__(self, magnification: str, lenses: Sequence[Lens], size: tuple[int, int], threads: int) -> None:
        self.scales = (1.0,) * len(lenses)
        if validation.choice("magnification", magnification, MAGNIFICATIONS) == "lens":
            self.scales = tuple(lens.sensor_distance / lenses[0].sensor_distance for lens in lenses)
        self._scales = [FocalScale(*size, scale, threads) if scale != 1.0 else None for scale in self.scales]
        self._made = [None if one is None else np.empty(size, dtype=np.float32) for one in self._scales]

    def __bool__(self) -> bool:
        """Whether any frame is resampled."""
        return any(self._scales)

    def __call__(self, frames: list[Frame], full: float, known: NDArray[np.uint8] | None) -> list[Frame]:
        """Return frames, in arrays that the next call overwrites; NaN is what depends on unknown pixels."""
        made = list(frames)
        for k, (scale, out) in enumerate(zip(self._scales, self._made, strict=True)):
            if scale is not None and out is not None:
                scale(frames[k], full, known, out)
                made[k] = out
        return made


class FrameForm:
    """What frames of one camera have in common; TypeError or ValueError that names the argument at fault.

    Parameters
    ----------
    shape : (int, int) or (int, int, int)
        Height, width, and channels if any.
    noise : Noise
        With numbers, not maps.
    saturation : float or None
        Value from which on pixels are full, as is the largest of unsigned integers.
    known : array_like of bool, or None
        Pixels of the sensor that are not broken.
    """

    def __init__(
        self, shape: tuple[int, ...], noise: Noise, saturation: float | None, known: ArrayLike | None
    ) -> None:
        if not isinstance(shape, Sequence) or len(shape) not in (2, 3):
            raise TypeError(f"shape must be height and width, and channels if any, got {validation.shown(shape)}")
        height, width = (
            validation.integer(f"shape[{k}]", shape[k], least=64, most=validation.MAX_SIDE) for k in range(2)
        )
        self.size = height, width
        self.channels = validation.integer("shape[2]", shape[2], least=1, most=16) if len(shape) == 3 else 1
        if validation.instance("noise", noise, Noise).excess != 1.0:
            raise ValueError(
                f"noise must have no excess for live frames, got excess={noise.excess:g}: give noise.poisson, whose "
                "electrons are those of the light over it"
            )
        for name in ("white", "read", "offset"):
            if not isinstance(getattr(noise, name), float | None):
                raise ValueError(
                    f"noise.{name} must be a number for live frames, not a map of the sensor: take its median, and "
                    "name pixels that differ much in known="
                )
        self.white, self.read, self.offset = float(noise.white or 1.0), float(noise.read), float(noise.offset)
        self._saturation = math.inf if saturation is None else validation.real("saturation", saturation)
        self._known = None if known is None else self._mask(known)

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of frames."""
        return self.size if self.channels == 1 else (*self.size, self.channels)

    @property
    def masked(self) -> bool:
        """Whether some pixels of the sensor are broken."""
        return self._known is not None

    def checked(self, name: str, frame: Frame) -> Frame:
        """Return a frame as the core takes it."""
        if not isinstance(frame, np.ndarray):
            raise TypeError(f"{name} must be an ndarray, got {validation.shown(frame)}")
        validation.refuse_masked(name, frame)
        if frame.shape != self.shape:
            raise ValueError(f"{name} must have the shape {self.shape}, got {frame.shape}")
        if frame.dtype in (np.uint8, np.uint16, np.float32):
            return frame if frame.strides[1] == frame.itemsize * self.channels else np.ascontiguousarray(frame)
        if frame.dtype.kind == "f":
            return np.asarray(frame, dtype=np.float32)
        raise TypeError(f"{name} must be of uint8, uint16 or floats, got {frame.dtype}")

    def full(self, dtype: np.dtype[Any]) -> float:
        """Return the value from which on pixels are full."""
        return min(self._saturation, float(np.iinfo(dtype).max) if dtype.kind == "u" else math.inf)

    def known(self, frames: Sequence[Frame], full: float, given: ArrayLike | None) -> NDArray[np.uint8] | None:
        """Return what is known of the sensor and, in all channels and by their own mask, of frames; None for all."""
        masks = [] if self._known is None else [self._known]
        if given is not None:
            masks.append(self._mask(given))
        if self.channels > 1:
            for frame in frames:
                with np.errstate(invalid="ignore"):
                    masks.append(np.asarray((frame < full).all(axis=2), dtype=np.bool_).view(np.uint8))
        if len(masks) <= 1:
            return masks[0] if masks else None
        return np.asarray(np.logical_and.reduce(masks)).view(np.uint8)

    def _mask(self, given: ArrayLike) -> NDArray[np.uint8]:
        mask = validation.array("known", given)
        if mask.shape != self.size or mask.dtype != np.bool_:
            raise ValueError(f"known must be of bool and of shape {self.size}, got {mask.dtype} of {mask.shape}")
        return np.ascontiguousarray(mask).view(np.uint8)

    def image(self, out: NDArray[np.float32] | None) -> NDArray[np.float32]:
        """Return where an image is written to; ValueError unless `out` is as a frame, of float32."""
        if out is None:
            return np.empty(self.shape, dtype=np.float32)
        if out.shape != self.shape or out.dtype != np.float32 or not out.flags.c_contiguous:
            raise ValueError(f"out must be a contiguous array of float32 of shape {self.shape}")
        return out
