"""Options of depth-of-field rendering and deblurring, with their defaults and checks."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Self, TypedDict, cast

import numpy as np
from numpy.typing import DTypeLike

from lommel.base import options, validation
from lommel.optics.colour.spectrum import RED_GREEN_BLUE, Channels

BORDERS = ("reflect", "extend", "zero")
MISSING = ("raise", "nearest", "infinity")
FILL = 'fill them by missing="nearest" (the nearest known depth) or missing="infinity" (infinitely far)'

Spectrum = float | Sequence[tuple[float, float]]


class FieldKeywords(TypedDict, total=False):
    """Options of every blur operator."""

    border: str
    energy: float
    largest: int | None
    dtype: DTypeLike
    threads: int | None


class BlurKeywords(FieldKeywords, total=False):
    """Options of the depth-dependent blur operator."""

    tol: float


class Keywords(BlurKeywords, total=False):
    """Options of depth-of-field rendering."""

    occlusion: bool
    wavelengths: Channels | Sequence[Spectrum] | None
    missing: str


@dataclass(frozen=True)
class Settings:
    """Options of depth-of-field rendering and deblurring, validated.

    Parameters
    ----------
    occlusion : bool, default True
        Near objects occlude far objects. Without occlusion, rendering is faster, but light of the background spreads
        over the edges of near objects.
    wavelengths : Channels or sequence, optional
        :class:`lommel.Channels`, or for each channel a wavelength (metres) or a sequence of (wavelength, weight). The
        default is the wavelength of the lens for a grey image, and 600, 540 and 460 nm for an RGB image.
    missing : {"raise", "nearest", "infinity"}, default "raise"
        Treatment of pixels whose depth is NaN: raise an error, use the depth of the nearest pixel with a known depth,
        or use infinity.
    border : {"reflect", "extend", "zero"}, default "reflect"
        Continuation of the image beyond its edges: mirrored ("reflect"), with the last pixels repeated ("extend"), or
        dark ("zero"). Depth is mirrored or extended in the same way. Light that the blur spreads beyond the image is
        lost.
    energy : float, default 0.98
        Fraction of the light of a PSF inside its window, 0.5 to 0.9999, or 1. Below 1 the light outside the window is
        spread over the window. With 1 the PSF is not truncated (a window plus a smooth remainder over the whole
        image), and rendering takes 1.7 times as long. Tiles and dask chunks require a value below 1.
    tol : float, default 1e-4
        Tolerance of the interpolation between tabulated PSFs, relative to their peak, 1e-7 to 1e-1; checked half-way
        between table entries. With ``energy=1``, `tol` is also the approximate tolerance of the sum of errors over
        the pixels outside the windows (errors of the finest diffraction rings not included). The attribute `error` of
        the blur is the actual error; with ``energy=1`` a warning is issued if this error exceeds 2 tol.
    largest : int, optional
        Maximum half width of a PSF window, pixels, 1 to 2048; by default half of the shorter side of the image.
    dtype : float32 or float64, default float32
        Type of the blurred image and of the sums over source points.
    threads : int, optional
        Maximum number of threads; by default the number of processors. It does not change the result.

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or out of range.
    """

    occlusion: bool = True
    wavelengths: Channels | Sequence[Spectrum] | None = None
    missing: str = "raise"
    border: str = "reflect"
    energy: float = 0.98
    tol: float = 1e-4
    largest: int | None = None
    dtype: DTypeLike = "float32"
    threads: int | None = None

    def __post_init__(self) -> None:
        if not isinstance(self.occlusion, bool | np.bool_):
            raise TypeError(f"occlusion must be True or False, got {validation.shown(self.occlusion)}")
        energy = validation.real("energy", self.energy, least=0.5)
        if 0.9999 + 1e-12 <= energy != 1.0:
            raise ValueError(f"energy must be <= 0.9999, or 1 for the whole PSF, got {validation.shown(self.energy)}")
        checked: dict[str, object] = {
            "wavelengths": None if self.wavelengths is None else spectra("wavelengths", self.wavelengths),
            "missing": validation.choice("missing", self.missing, MISSING),
            "border": validation.choice("border", self.border, BORDERS),
            "energy": energy,
            "tol": validation.real("tol", self.tol, least=1e-7, below=0.1 + 1e-12),
            "dtype": validation.kind("dtype", self.dtype, np.float32, np.float64),
        }
        for name, limit in (("largest", 2048), ("threads", 1024)):
            if (value := getattr(self, name)) is not None:
                checked[name] = validation.integer(name, value, least=1, most=limit)
        vars(self).update(checked)  # assignments to a frozen dataclass are not allowed

    @classmethod
    def of(cls, function: Callable[..., object], arguments: Mapping[str, Any], keywords: type) -> Self:
        """Return validated options from `arguments`; TypeError for a name not in the TypedDict `keywords`."""
        options.require_known(function, arguments, keywords)
        return cls(**arguments)

    @property
    def of_blur(self) -> BlurKeywords:
        """The options of the depth-dependent blur operator."""
        return cast("BlurKeywords", {name: getattr(self, name) for name in BlurKeywords.__annotations__})

    def channels(self, shape: tuple[int, ...], wavelength: float | None) -> Sequence[Spectrum]:
        """Return the spectrum of each channel of an image of `shape`; `wavelength` is the default of a grey image."""
        count = 1 if len(shape) == 2 else shape[2]
        if self.wavelengths is not None:
            if len(self.wavelengths) != count:
                raise ValueError(
                    f"wavelengths must have one entry for each of the {count} channels, got {len(self.wavelengths)}"
                )
            return cast("Sequence[Spectrum]", self.wavelengths)
        if count == 1:
            assert wavelength is not None
            return (wavelength,)
        if count == 3:
            return RED_GREEN_BLUE
        hint = "; drop the alpha channel" if count in (2, 4) else ""
        raise ValueError(f"wavelengths must have one entry for each of the {count} channels, got None{hint}")


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
