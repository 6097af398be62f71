"""Options that blur, deblurring and data sets share, and the spectra of channels."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated

import numpy as np
from numpy.typing import DTypeLike

from lommel.base import validation
from lommel.base.options import HIDDEN, In, Options
from lommel.core.answers import DType
from lommel.optics.colour.spectrum import RED_GREEN_BLUE, Channels

FILL = 'where the map is read, give missing="nearest" (the nearest known depth) or missing="infinity"'

Spectrum = float | Sequence[tuple[float, float]]


def floating(name: str, value: object) -> DType:
    """Return float32 or float64; TypeError or ValueError for another type."""
    return validation.kind(name, value, np.float32, np.float64)


@dataclass(frozen=True, kw_only=True)
class WindowOptions(Options):
    """Options of all functions that blur by windows of PSFs.

    Parameters
    ----------
    energy : float, default 0.98
        Fraction of the light of a PSF inside its window, 0.5 to 0.9999. The light outside the window is spread over
        the window.
    """

    energy: Annotated[float, In(least=0.5, most=0.9999), HIDDEN] = 0.98


@dataclass(frozen=True, kw_only=True)
class TableOptions(WindowOptions):
    """Options of blur by tables of windows.

    Parameters
    ----------
    tol : float, default 1e-4
        Tolerance of the interpolation between tabulated PSFs, relative to their peak, 1e-7 to 1e-1; checked half-way
        between table entries; the error found there is stated with the result. Light beyond windows comes on top.
    """

    tol: Annotated[float, In(least=1e-7, most=0.1)] = 1e-4


@dataclass(frozen=True, kw_only=True)
class SizeOptions(WindowOptions):
    """Options of blur operators of any kind.

    Parameters
    ----------
    largest : int, optional
        Maximum half width of a PSF window, pixels, 1 to 2048; by default half of the shorter side of the image.
    dtype : float32 or float64, default float32
        Type of the blurred image and of the sums over source points.
    """

    largest: Annotated[int | None, In(least=1, most=2048)] = None
    dtype: Annotated[DTypeLike, floating] = "float32"


@dataclass(frozen=True, kw_only=True)
class OperatorOptions(SizeOptions, TableOptions):
    """Options of operators of blur by tables.

    Parameters
    ----------
    threads : int, optional
        Maximum number of threads; by default the number of processors. It does not change the result.
    """

    threads: Annotated[int | None, In(least=1, most=1024)] = None


def channel_spectra(shape: tuple[int, ...], wavelength: float) -> Sequence[Spectrum]:
    """Return the spectrum of each channel of an image of `shape`; `wavelength` is that of a grey image."""
    count = 1 if len(shape) == 2 else shape[2]
    if count == 1:
        return (wavelength,)
    if count == 3:
        return RED_GREEN_BLUE
    hint = "drop the alpha channel" if count in (2, 4) else "pass the channels one by one"
    raise ValueError(f"images must have one channel or three, got {count}; {hint}")


def spectra(name: str, channels: object) -> tuple[tuple[tuple[float, float], ...], ...]:
    """Return the pairs (wavelength in metres, weight) of each channel, with weights that sum to 1."""
    if isinstance(channels, Channels):
        return channels.spectra
    if not isinstance(channels, Sequence | np.ndarray) or getattr(channels, "ndim", 1) == 0:
        raise TypeError(f"{name} must be a sequence with one entry per channel, got {validation.shown(channels)}")
    return tuple(_spectrum(channel) for channel in channels)


def _spectrum(channel: object) -> tuple[tuple[float, float], ...]:
    if not isinstance(channel, Sequence):
        return ((validation.wavelength(channel), 1.0),)
    if not all(isinstance(pair, Sequence) and not isinstance(pair, str) and len(pair) == 2 for pair in channel):
        raise TypeError(
            "each channel must be a wavelength, or a sequence of pairs (wavelength, weight), "
            f"got {validation.shown(channel)}"
        )
    pairs = [(validation.wavelength(w), validation.real("weight", s, least=0.0)) for w, s in channel]
    total = math.fsum(s for _, s in pairs)
    if not total > 0.0:
        raise ValueError(f"each channel must have a wavelength of weight above 0, got {validation.shown(channel)}")
    return tuple((w, s / total) for w, s in pairs)
