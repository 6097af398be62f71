"""Encoding and noise of video frames, and stopping by signals, for the commands that read video."""

from __future__ import annotations

import math
import os
import signal
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType
from typing import TYPE_CHECKING, NamedTuple, Self, TypeVar

import numpy as np
import scipy

from lommel.base.arrays import Values
from lommel.base.encoding import from_light, to_light
from lommel.cli.instruments import FrameNoise, noise_of
from lommel.recorded.noise import Noise
from lommel.report import Facts

if TYPE_CHECKING:
    from lommel.lensfiles.instrument import Camera

Frame = TypeVar("Frame")

_DEFAULT_WHITE, _DEFAULT_READ = 5000.0, 3.0  # full well and read noise, electrons, assumed for 8-bit sRGB
_MIN_BITS_FRACTION = 0.95  # fraction of the entropy of noise: compressed pixels with fewer bits get a warning
_TOP_MARGIN = 1e-5  # difference of white and saturation, as a fraction of white: less than half a 16-bit sRGB step
_FIT_ABOVE = 0.02  # fraction of white: darker levels are left out of the fit of noise to stored values
_ROW_SMOOTHING = 6.0  # standard deviation, rows, of the Gaussian that smooths the brightness of rows
_DARK_ROW = 0.1  # fraction of the mean brightness of rows: darker rows are not equalized
_HANGUP: signal.Signals | None = getattr(signal, "SIGHUP", None)  # None on Windows


class Coding(NamedTuple):
    """Encoding and noise of stored values."""

    encoding: str  # "srgb" or "linear"
    levels: int  # number of integer levels, 0 for floats
    white: float  # electrons at white, in the noise model that includes rounding
    noise: Noise  # noise of the values that the method `light` returns
    saturation: float | None  # saturation level of the values that the method `light` returns, or None
    guess: str  # sentence for the report if the noise is a guess, otherwise ""
    words: str  # description of the encoding for the report
    facts: Facts

    def light(self, values: Values) -> Values:
        """Return values for the live filters: sRGB is decoded, linear values stay unchanged."""
        return to_light("the video", values, "srgb", np.float32) if self.encoding == "srgb" else values

    def noise_bits(self, electrons: float) -> float:
        """Return the entropy of a stored pixel's noise, bits, at a number of electrons, for normal noise."""
        sigma = math.hypot(math.sqrt(electrons), self.noise.read)
        ends = np.clip(np.array([electrons - sigma, electrons + sigma]) / self.white, 0.0, 1.0)
        low, high = from_light(ends, self.encoding, np.float64)
        steps = 0.5 * (self.levels - 1) * float(high - low)  # standard deviation in steps between levels
        return max(0.0, math.log2(max(steps, 0.1) * math.sqrt(2.0 * math.pi * math.e)))

    def check_compression(self, bits: float | None, electrons: float) -> tuple[Facts, str]:
        """Return (1) the bits per pixel of a compressed video and of its noise, (2) a warning if noise is lost."""
        if bits is None or math.isnan(electrons):
            return {"bits": None, "noise_bits": None}, ""
        noise_bits, warning = self.noise_bits(electrons), ""
        if bits < _MIN_BITS_FRACTION * noise_bits:
            warning = (
                f"Compression leaves {bits:.2g} bits a pixel, but the noise alone has {noise_bits:.2g}: fine texture "
                "is lost, and depth may be wrong by many standard errors. Record with less compression or none."
            )
        return {"bits": bits, "noise_bits": noise_bits}, warning


def equalize_rows(first: Values, second: Values, coding: Coding) -> list[Values]:
    """Return two frames, the rows of the second scaled to a uniform ratio of brightness; saturated pixels are NaN.

    A rolling shutter records a flickering lamp as bands of rows, which a smooth ratio of exposures cannot represent.
    """
    frames = [frame.astype(np.float32) - np.float32(coding.noise.offset) for frame in (first, second)]
    limit = math.inf if coding.saturation is None else coding.saturation - float(coding.noise.offset)
    valid = np.logical_and(*(frame < limit for frame in frames))
    if not valid.all():
        frames = [np.where(valid, frame, np.float32(np.nan)) for frame in frames]
    sums = [np.nansum(frame, axis=1, dtype=np.float64) for frame in frames]
    rows = [scipy.ndimage.gaussian_filter1d(row_sums, _ROW_SMOOTHING) for row_sums in sums]
    equalized = np.minimum(*rows) > _DARK_ROW * max(rows[0].mean(), rows[1].mean())
    if equalized.any():
        ratio = np.ones(len(rows[0]))
        np.divide(rows[1], rows[0], out=ratio, where=equalized)
        ratio[equalized] *= rows[0][equalized].sum() / rows[1][equalized].sum()
        frames[1] *= (1.0 / np.clip(ratio, 0.5, 2.0)).astype(np.float32)[:, None]
    for frame in frames:
        frame += np.float32(coding.noise.offset)
    return frames


def coding_of(
    levels: int,
    dtype: np.dtype[np.generic],
    default_encoding: str,
    video_noise: FrameNoise,
    camera: Camera | None,
    encoding: str | None,
) -> Coding:
    """Return the coding of stored values from the options --white, --read, --offset, --saturation and --encoding.

    The noise of 8-bit sRGB values is always reported as a guess; without option and camera it has default values.
    """
    encoding_used = encoding or default_encoding
    is_guess = encoding_used == "srgb" and levels == 256
    options, assumed = vars(video_noise).copy(), []
    for name, value in (("white", _DEFAULT_WHITE), ("read", _DEFAULT_READ)) if is_guess else ():
        of_camera = camera and (camera.full_well if name == "white" else camera.read)
        if options[name] is None and of_camera is None:
            options[name] = value
            assumed.append(f"--{name}")
    sensor = noise_of(options, camera, photographs=True)
    white, read, offset = np.array([sensor.white, sensor.read, sensor.offset], np.float64).tolist()
    value_of_white = 1.0 if encoding_used == "srgb" or dtype.kind == "f" else float(np.iinfo(str(dtype)).max)
    stored_white, stored_read = stored_noise(white, read, levels, encoding_used)
    bits = "float" if dtype.kind == "f" else f"{levels.bit_length() - 1}-bit"
    label, other_label = ("sRGB", "linear") if encoding_used == "srgb" else ("linear", "sRGB")
    text = f"{bits} values, {label}"
    if encoding is None:
        text = f"{bits} values, assumed {label}; if they are {other_label}, give --encoding {other_label.lower()}"
    guess = ""
    if is_guess:
        source = f"by default; give {' and '.join(assumed)}" if assumed else "as stated"
        guess = (
            f"The noise of 8-bit sRGB values is a guess, because cameras denoise and compress them: {white:g} "
            f"electrons at white, read noise {read:g} electrons ({source}), and rounding."
        )
    facts = {"read": text, "white": white, "read_noise": read, "noise_is_a_guess": is_guess, "assumed": assumed}
    saturation = None if video_noise.saturation is None else video_noise.saturation * value_of_white
    if levels:
        saturation = min(math.inf if saturation is None else saturation, (1.0 - _TOP_MARGIN) * value_of_white)
    noise = Noise(white=stored_white / value_of_white, read=stored_read, offset=offset * value_of_white)
    return Coding(encoding_used, levels, stored_white, noise, saturation, guess, text, facts)


def stored_noise(white: float, read: float, levels: int, encoding: str) -> tuple[float, float]:
    """Return (1) electrons at white and (2) read noise, electrons, both with rounding to `levels` (0: no rounding).

    Rounding adds a twelfth of the squared step to the variance. The squared step of sRGB grows with the light, so
    that the total variance is nearly linear in the light: both values follow from a least-squares line.
    """
    if not levels:
        return white, read
    if encoding == "linear":
        return white, math.hypot(read, white / (levels - 1) / math.sqrt(12.0))
    light = to_light("levels", np.linspace(0.0, 1.0, levels), "srgb", np.float64)
    variance = light / white + (read / white) ** 2 + np.gradient(light) ** 2 / 12.0
    fitted = light > _FIT_ABOVE
    terms = np.stack([light, np.ones_like(light)], axis=1)[fitted] / variance[fitted, None]
    slope, constant = np.linalg.lstsq(terms, np.ones(len(terms)), rcond=None)[0].tolist()
    return 1.0 / slope, math.sqrt(max(constant, 0.0)) / slope


class Stop:
    """A request by a signal to end a loop over frames, once the frame in progress is written.

    The signals are SIGINT (Ctrl-C), SIGTERM and SIGHUP (the terminal was closed), unless SIGHUP is ignored (nohup).
    """

    def __init__(self) -> None:
        self.requested = False
        self._waiting = True  # no frame is being written, and no file is open before the first one

    @contextmanager
    def signals(self) -> Iterator[Self]:
        """Handle the signals within a ``with`` block; a second Ctrl-C interrupts without waiting for the frame."""

        def handle(number: int, _frame: FrameType | None) -> None:
            if number == _HANGUP:
                _leave_terminal()
            repeated, self.requested = self.requested, True
            # Systems repeat the other signals: a shell and the kernel both send SIGHUP.
            if self._waiting or (repeated and number == signal.SIGINT):
                self._waiting = False
                raise KeyboardInterrupt

        numbers = [signal.SIGINT, signal.SIGTERM]
        if _HANGUP is not None and signal.getsignal(_HANGUP) != signal.SIG_IGN:
            numbers.append(_HANGUP)
        handlers = {number: signal.signal(number, handle) for number in numbers}
        try:
            yield self
        finally:
            for number, handler in handlers.items():
                signal.signal(number, handler)

    def next(self, frames: Iterator[Frame]) -> Frame | None:
        """Return the next frame, or None at the end of the video or at a signal."""
        try:
            self._waiting = True
            return None if self.requested else next(frames, None)
        except KeyboardInterrupt:
            return None
        finally:
            self._waiting = False


def _leave_terminal() -> None:
    """Redirect output to the null device where the terminal is gone: writing the summary would fail."""
    for stream in (1, 2):
        try:
            os.write(stream, b"")
        except OSError:
            os.dup2(os.open(os.devnull, os.O_WRONLY), stream)
