"""What commands on video share: how values are light, and with what noise; Ctrl-C."""

from __future__ import annotations

import math
import signal
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType
from typing import TYPE_CHECKING, NamedTuple, TypeVar

import click
import numpy as np
from scipy.ndimage import gaussian_filter1d

from lommel.base.arrays import Values
from lommel.base.encoding import from_light, to_light
from lommel.cli.instruments import noise_of
from lommel.cli.options import option
from lommel.cli.photo_commands import PhotoNoise
from lommel.recorded.noise import Noise
from lommel.report import Facts

if TYPE_CHECKING:
    from lommel.lensfiles.instrument import Camera

Kept = TypeVar("Kept")

_WHITE, _READ = 5000.0, 3.0  # electrons, of 8-bit video of which nothing is stated
_LOSSY = 0.95  # of the bits that noise takes: compression that leaves less is told
_LAST = 1e-5  # of white, less than half a step of 16 bits of sRGB there
_DARK = 0.02  # of white: below it the noise of stored values is not fitted
_BAND = 6.0  # rows, rms, in which the brightness of frames is compared
_FAINT = 0.1  # of the mean: rows that are darker are not

ENCODING = option(type=click.Choice(["srgb", "linear"]),
    help="Encoding of the values; by default grey of more than 8 bits and floats are linear, all else is "
    "sRGB.")  # fmt: skip


class VideoNoise(PhotoNoise, heading="Noise"):
    """The noise of frames, and where they saturate."""

    # fmt: off
    saturation: float | None = option(type=float,
        help="Level at which pixels saturate: a fraction of white in linear light (after decoding sRGB), such as "
        "0.95; the largest integer always counts as saturated.")
    # fmt: on


class Coding(NamedTuple):
    """How stored values are light, and with what noise."""

    encoding: str
    levels: int  # that values are stored in, 0 for floats
    white: float  # electrons at white, with rounding as a part of the noise
    noise: Noise  # of what `light` returns
    saturation: float | None  # of the same
    guess: str  # sentence on a noise that is a guess, or ""
    words: str
    facts: Facts

    def light(self, values: Values) -> Values:
        """Return what live filters take: integers that are linear as they are, all else as linear light."""
        return to_light("the video", values, "srgb", np.float32) if self.encoding == "srgb" else values

    def noise_bits(self, electrons: float) -> float:
        """Return the bits that the noise of a pixel of so many electrons takes: the entropy of a normal variable."""
        spread = math.hypot(math.sqrt(electrons), self.noise.read)
        ends = np.clip(np.array([electrons - spread, electrons + spread]) / self.white, 0.0, 1.0)
        low, high = from_light(ends, self.encoding, np.float64)
        levels = 0.5 * (self.levels - 1) * float(high - low)
        return max(0.0, math.log2(max(levels, 0.1) * math.sqrt(2.0 * math.pi * math.e)))

    def compressed(self, bits: float | None, light: float) -> tuple[Facts, str]:
        """Return bits a pixel of compressed video, with those of noise, and a sentence if they are too few for it."""
        if bits is None or math.isnan(light):
            return {"bits": None, "noise_bits": None}, ""
        noise, sentence = self.noise_bits(light), ""
        if bits < _LOSSY * noise:
            sentence = (
                f"Compression leaves {bits:.2g} bits a pixel, and noise alone takes {noise:.2g}: fine texture is "
                "lost with it, and depth may be wrong by many standard errors. Record without compression, or with "
                "less."
            )
        return {"bits": bits, "noise_bits": noise}, sentence


def equalize_rows(first: Values, second: Values, coding: Coding) -> list[Values]:
    """Return two frames whose ratio of brightness is the same in all rows; full pixels are NaN.

    Lamps that flicker make bands where a shutter rolls over the rows, and no smooth ratio of exposures follows them.
    """
    light = [each.astype(np.float32) - np.float32(coding.noise.offset) for each in (first, second)]
    full = math.inf if coding.saturation is None else coding.saturation - float(coding.noise.offset)
    known = np.logical_and(*(each < full for each in light))
    if not known.all():
        light = [np.where(known, each, np.float32(np.nan)) for each in light]
    rows = [gaussian_filter1d(np.nansum(each, axis=1, dtype=np.float64), _BAND) for each in light]
    bright = np.minimum(*rows) > _FAINT * max(rows[0].mean(), rows[1].mean())
    if bright.any():
        ratio = np.ones(len(rows[0]))
        np.divide(rows[1], rows[0], out=ratio, where=bright)
        ratio[bright] *= rows[0][bright].sum() / rows[1][bright].sum()
        light[1] *= (1.0 / np.clip(ratio, 0.5, 2.0)).astype(np.float32)[:, None]
    for each in light:
        each += np.float32(coding.noise.offset)
    return light


def coding_of(
    levels: int,
    dtype: np.dtype[np.generic],
    usual: str,
    noisy: VideoNoise,
    camera: Camera | None,
    encoding: str | None,
) -> Coding:
    """Return the coding of values by the options --white, --read, --offset and --saturation.

    The noise of 8-bit sRGB is a guess where nothing is stated, and said to be one in any case.
    """
    used = encoding or usual
    guessed = used == "srgb" and levels == 256
    given, assumed = vars(noisy).copy(), []
    for name, value in (("white", _WHITE), ("read", _READ)) if guessed else ():
        stated = camera and (camera.full_well if name == "white" else camera.read)
        if given[name] is None and stated is None:
            given[name] = value
            assumed.append(f"--{name}")
    sensor = noise_of(given, camera, photographs=True)
    white, read, offset = np.array([sensor.white, sensor.read, sensor.offset], np.float64).tolist()
    top = 1.0 if used == "srgb" or dtype.kind == "f" else float(np.iinfo(str(dtype)).max)
    gain, noise = stored_noise(white, read, levels, used)
    bits = "float" if dtype.kind == "f" else f"{levels.bit_length() - 1}-bit"
    name, other = ("sRGB", "linear") if used == "srgb" else ("linear", "sRGB")
    words = f"{bits} values, {name}"
    if encoding is None:
        words = f"{bits} values, assumed {name}; if they are {other}, give --encoding {other.lower()}"
    guess = ""
    if guessed:
        who = f"taken for want of {' and '.join(assumed)}" if assumed else "as stated"
        guess = (
            f"The noise of 8-bit sRGB values is a guess, for cameras denoise and compress them: {white:g} electrons "
            f"at white, read noise {read:g} electrons ({who}), and rounding."
        )
    facts = {"read": words, "white": white, "read_noise": read, "noise_is_a_guess": guessed, "assumed": assumed}
    full = None if noisy.saturation is None else noisy.saturation * top
    if levels:
        full = min(math.inf if full is None else full, (1.0 - _LAST) * top)
    return Coding(
        used, levels, gain, Noise(white=gain / top, read=noise, offset=offset * top), full, guess, words, facts
    )


def stored_noise(white: float, read: float, levels: int, encoding: str) -> tuple[float, float]:
    """Return electrons at white and read noise of linear light that was stored in so many levels, 0 for floats.

    Rounding adds a twelfth of the squared step. The steps of sRGB grow with the light, nearly as the variance of
    photons does: both together are a gain and a read noise, by least squares in units of the variance.
    """
    if not levels:
        return white, read
    if encoding == "linear":
        return white, math.hypot(read, white / (levels - 1) / math.sqrt(12.0))
    light = to_light("levels", np.linspace(0.0, 1.0, levels), "srgb", np.float64)
    variance = light / white + (read / white) ** 2 + np.gradient(light) ** 2 / 12.0
    fitted = light > _DARK
    terms = np.stack([light, np.ones_like(light)], axis=1)[fitted] / variance[fitted, None]
    slope, level = np.linalg.lstsq(terms, np.ones(len(terms)), rcond=None)[0].tolist()
    return 1.0 / slope, math.sqrt(max(level, 0.0)) / slope


class Stop:
    """Ctrl-C and SIGTERM, which end a loop after the frame that is being written."""

    def __init__(self) -> None:
        self.asked = self._waits = False

    @contextmanager
    def signals(self) -> Iterator[None]:
        """Take the signals; a second one interrupts at once."""

        def handle(_signal: int, _frame: FrameType | None) -> None:
            again, self.asked = self.asked, True
            if again or self._waits:  # nothing is being written
                raise KeyboardInterrupt

        before = {one: signal.signal(one, handle) for one in (signal.SIGINT, signal.SIGTERM)}
        try:
            yield
        finally:
            for one, old in before.items():
                signal.signal(one, old)

    def next(self, frames: Iterator[Kept]) -> Kept | None:
        """Return the next frame; None at the end, or when the signal comes."""
        try:
            self._waits = True
            return None if self.asked else next(frames, None)
        except KeyboardInterrupt:
            return None
        finally:
            self._waits = False
