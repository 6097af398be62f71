"""What channels record: an answer for each of them, and their values in one array."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Generic, Self, TypeVar

import numpy as np
from numpy.typing import DTypeLike, NDArray

from lommel.base import validation
from lommel.measures.answer import Answer
from lommel.optics.base_pupil import BasePupil
from lommel.optics.colour.spectrum import Channels
from lommel.optics.grid import Grid

One = TypeVar("One", bound=Answer)


@dataclass(frozen=True, eq=False, repr=False)
class AnswerChannels(Generic[One]):
    """The data of a :class:`lommel.ColourPSF`, whose attributes these are."""

    channels: Channels
    psfs: tuple[One, ...]
    values: NDArray[Any] = field(init=False)

    def __post_init__(self) -> None:
        validation.instance("channels", self.channels, Channels)
        psfs: tuple[One, ...] = tuple(self.psfs) if isinstance(self.psfs, Iterable) else ()
        if len(psfs) != len(self.channels) or not all(isinstance(psf, Answer) for psf in psfs):
            raise TypeError(
                f"psfs must be a PSF for each of the {len(self.channels)} channels, got {validation.shown(self.psfs)}"
            )
        alike = {(p.values.shape, p.values.dtype.str, p.pixel, p.normalize, p.unit) for p in psfs}
        if len(alike) > 1:
            raise ValueError(f"psfs must be alike but for their light, got {validation.shown(sorted(alike))}")
        # One array, of which those of the channels are parts.
        base = psfs[0].values.base
        if base is None or base.shape != (len(psfs), *psfs[0].values.shape) or not _parts(base, psfs):
            base = np.stack([p.values for p in psfs])
            psfs = tuple(replace(p, values=base[k]) for k, p in enumerate(psfs))
        vars(self).update(psfs=psfs, values=np.moveaxis(base, 0, -3))

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the channels."""
        return self.channels.names

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the values."""
        return self.values.shape

    @property
    def pupil(self) -> BasePupil:
        """That of the first channel."""
        return self.psfs[0].pupil

    @property
    def grid(self) -> Grid:
        """The pixels."""
        return self.psfs[0].grid

    @property
    def pixel(self) -> float | tuple[float, float]:
        """Pixel pitch, in :attr:`unit`."""
        return self.psfs[0].pixel

    @property
    def unit(self) -> str:
        """Unit of lengths."""
        return self.psfs[0].unit

    @property
    def normalize(self) -> str:
        """What values are relative to, channel by channel."""
        return self.psfs[0].normalize

    @property
    def error_bound(self) -> float | None:
        """Bound on the largest error over the peak of a channel, that of the worst; None where one has none."""
        bounds = [psf.error_bound for psf in self.psfs]
        return None if None in bounds else max(bound for bound in bounds if bound is not None)

    def __len__(self) -> int:
        """Return the number of channels."""
        return len(self.psfs)

    def __iter__(self) -> Iterator[One]:
        """Yield the PSF of each channel."""
        return iter(self.psfs)

    def __getitem__(self, channel: str | int) -> One:
        """Return the PSF, or the stack of PSFs, of a channel by its name or its number."""
        if isinstance(channel, str):
            if channel not in self.names:
                raise KeyError(f"there is no channel {channel!r}; there are {', '.join(self.names)}")
            return self.psfs[self.names.index(channel)]
        if isinstance(channel, bool) or not isinstance(channel, int | np.integer):
            raise TypeError(
                f"a channel is named by a text or a number, got {validation.shown(channel)}; part(index) is a part "
                "of a stack"
            )
        return self.psfs[channel]

    def part(self, index: Any) -> Self:
        """Return part of a stack in all channels, as NumPy indexes arrays of the shape of its pupils.

        Parameters
        ----------
        index : int, slice, tuple or array
            As of such an array.

        Returns
        -------
        ColourPSF

        Raises
        ------
        TypeError, IndexError
            If there is no stack, or nothing at the index.
        """
        return type(self)(self.channels, tuple(psf[index] for psf in self.psfs))

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> NDArray[Any]:
        """Return `values`."""
        return np.array(self.values, dtype=dtype, copy=copy)

    def __repr__(self) -> str:
        bound = "none" if self.error_bound is None else f"{self.error_bound:.2g}"
        return (
            f"<{type(self).__name__} {'x'.join(map(str, self.shape))} {self.values.dtype}, channels "
            f"{', '.join(self.names)}, pixel {self.pixel:g} {self.unit}, normalize {self.normalize!r}, "
            f"error bound {bound}>"
        )


def _parts(whole: NDArray[Any], psfs: Sequence[Answer]) -> bool:
    """Return whether the values of each PSF are its part of an array of all."""
    return all(
        psf.values.base is whole and psf.values.ctypes.data == part.ctypes.data
        for psf, part in zip(psfs, whole, strict=True)
    )


def colours(answer: AnswerChannels[Any], white: Sequence[float] | None = None) -> NDArray[np.float64]:
    """Return red, green and blue over their largest value in each image, in proportion to light.

    Parameters
    ----------
    answer : ColourPSF
        Of three channels, or of one, which is grey.
    white : sequence of float, optional
        What each channel is multiplied by first.

    Returns
    -------
    ndarray, shape (..., height, width, 3)

    Raises
    ------
    ValueError
        If there are other numbers of channels, or no light.
    """
    if len(answer) not in (1, 3):
        raise ValueError(f"a picture takes three channels, or one, got {len(answer)}: {', '.join(answer.names)}")
    light = np.maximum(np.moveaxis(answer.values, -3, -1).astype(np.float64), 0.0)
    light = light * (np.ones(len(answer)) if white is None else np.asarray(white))
    top = light.max(axis=(-3, -2, -1), keepdims=True)
    if not top.min() > 0.0:
        raise ValueError("a picture needs a positive value; every value of this PSF is 0")
    return np.asarray(np.broadcast_to(light / top, (*light.shape[:-1], 3)))
