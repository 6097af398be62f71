"""Encoding and noise of the values that a video stores."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from lommel.base.arrays import Values
from lommel.base.encoding import Encoding, to_light
from lommel.cli.instruments import FrameNoise, noise_of
from lommel.cli.photo_commands import read_as
from lommel.imaging.pair_noise import rounding_variances
from lommel.recorded.noise import Noise
from lommel.report import Facts

if TYPE_CHECKING:
    from lommel.lensfiles.instrument import Camera

DEFAULT_WHITE, DEFAULT_READ = 5000.0, 3.0  # full well and read noise, electrons, assumed for 8-bit sRGB
_TOP_MARGIN = 1e-5  # difference of white and saturation, as a fraction of white: less than half a 16-bit sRGB step
_FIT_ABOVE = 0.02  # fraction of white: darker levels are left out of the fit of noise to stored values


class Coding(NamedTuple):
    """Encoding and noise of stored values."""

    encoding: Encoding
    levels: int  # number of integer levels, 0 for floats
    white: float  # electrons at white, in the noise model that includes rounding
    noise: Noise  # noise of the values that the method `light` returns
    saturation: float | None  # saturation level of the values that the method `light` returns, or None
    guess: str  # sentence for the report if the noise is a guess, otherwise ""
    facts: Facts

    def light(self, values: Values) -> Values:
        """Return values for the live filters: linear values stay unchanged, others are decoded."""
        return values if self.encoding == "linear" else to_light("the video", values, self.encoding, np.float32)


def coding_of(
    levels: int,
    dtype: np.dtype[np.generic],
    default_encoding: Encoding,
    video_noise: FrameNoise,
    camera: Camera | None,
    encoding: Encoding | None,
    *,
    stated: bool = False,
) -> Coding:
    """Return the coding of stored values from the options --white, --read, --offset, --saturation and --encoding.

    `stated` is whether the file states the default encoding. The noise of 8-bit values that are not linear is always
    reported as a guess; without option and camera it has default values.
    """
    encoding_used = encoding or default_encoding
    is_guess = encoding_used != "linear" and levels == 256
    options, assumed = vars(video_noise).copy(), []
    for name, value in (("white", DEFAULT_WHITE), ("read", DEFAULT_READ)) if is_guess else ():
        of_camera = camera and (camera.full_well if name == "white" else camera.read)
        if options[name] is None and of_camera is None:
            options[name] = value
            assumed.append(f"--{name}")
    sensor = noise_of(options, camera, photographs=True)
    white, read, offset = np.array([sensor.white, sensor.read, sensor.offset], np.float64).tolist()
    value_of_white = 1.0 if encoding_used != "linear" or dtype.kind == "f" else float(np.iinfo(str(dtype)).max)
    stored_white, stored_read = stored_noise(white, read, levels, encoding_used)
    text = read_as(dtype, levels.bit_length() - 1, encoding_used, stated or encoding is not None)
    guess = ""
    if is_guess:
        kind = "sRGB" if encoding_used == "srgb" else "encoded"
        source = f"by default; give {' and '.join(assumed)}" if assumed else "as stated"
        guess = (
            f"The noise of 8-bit {kind} values is a guess, because cameras denoise and compress them: {white:g} "
            f"electrons at white, read noise {read:g} electrons ({source}), and rounding."
        )
    facts = {"read": text, "white": white, "read_noise": read, "noise_is_a_guess": is_guess, "assumed": assumed}
    saturation = None if video_noise.saturation is None else video_noise.saturation * value_of_white
    if levels:
        saturation = min(math.inf if saturation is None else saturation, (1.0 - _TOP_MARGIN) * value_of_white)
    noise = Noise(white=stored_white / value_of_white, read=stored_read, offset=offset * value_of_white)
    return Coding(encoding_used, levels, stored_white, noise, saturation, guess, facts)


def stored_noise(white: float, read: float, levels: int, encoding: Encoding) -> tuple[float, float]:
    """Return (1) electrons at white and (2) read noise, electrons, both with rounding to `levels` (0: no rounding).

    Rounding adds a twelfth of the squared step to the variance. The squared step of sRGB grows with the light, so
    that the total variance is nearly linear in the light: both values follow from a least-squares line.
    """
    if not levels:
        return white, read
    if encoding == "linear":
        return white, math.hypot(read, white / (levels - 1) / math.sqrt(12.0))
    light, rounding = rounding_variances(levels, encoding)
    variance = light / white + (read / white) ** 2 + rounding
    fitted = light > _FIT_ABOVE
    terms = np.stack([light, np.ones_like(light)], axis=1)[fitted] / variance[fitted, None]
    slope, constant = np.linalg.lstsq(terms, np.ones(len(terms)), rcond=None)[0].tolist()
    return 1.0 / slope, math.sqrt(max(constant, 0.0)) / slope
