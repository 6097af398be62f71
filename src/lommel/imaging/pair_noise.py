"""Noise of images that differ in focus, estimated from these images."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from scipy.ndimage import correlate1d

from lommel.base.arrays import Array, Values
from lommel.base.encoding import Encoding, to_light
from lommel.recorded.camera_noise import image_noise
from lommel.recorded.noise import Noise

_MIN_COMPRESSED = 6.0  # standard errors by which third differences differ at edges of JPEG blocks
_MAX_VANISHED, _COSINES_SIDE = -0.25, 1024  # log of the size of the finest cosines of JPEG; in a square of pixels
_MAX_DARK = 0.9  # largest fraction of the noise that is put down to read noise
MOSTLY_ROUNDING = 0.5
"""Fraction of the variance that is of rounding, above which the electrons at 1 of the noise are a lower bound."""
_LEAST_ALIASED = 0.25  # fraction of blocks, those with the least aliases, that determine the noise
_MIN_KNOWN = 0.1  # fraction of blocks with a depth below which all determine the noise: these few are of least misfit


def starting_noise(images: Values) -> tuple[Array, float]:
    """Return the electrons at 1 of each channel of images (channels, frames, height, width), and the read noise.

    The noise is that of the finest details in the frame with the least of them: the other frames are sharper, and
    their details are those of the scene. NaN pixels are unknown.
    """
    try:
        triples = np.array([[image_noise(plane) for plane in channel] for channel in images])
    except ValueError:
        text = "it cannot be estimated from images of one value, or with few known pixels"
        raise ValueError(f"noise must be stated: {text}") from None
    light, variance, dark = np.maximum(np.moveaxis(triples, 2, 0), 1e-24)
    share = min(float(dark.mean()), _MAX_DARK)
    white = (light / variance).max(axis=1) / (1.0 - share)
    return white, math.sqrt(share / (1.0 - share) * float((light.T * white).mean()))


def is_compressed(image: Values) -> bool:
    """Return whether an image (height, width) has the blocks of 8 x 8 pixels of JPEG, in part or all of it.

    Quantised blocks have less noise inside than across their edges: third differences are larger at one of 8 phases
    than at the opposite one, along both axes. Lines at 4, 6 or 12 pixels look alike at opposite phases. If the edges
    do not start at the corner of the image, it may show a screen of 8 pixels: in blocks of an image that was cropped
    all phases inside are alike, and the edges exceed each of them along either axis. Fine quantisation, of high
    quality, shows in cosines of the highest frequencies: it makes them vanish in blocks that start at the corner.
    """
    if min(image.shape) < 9 * 8:  # too few blocks
        return False
    if _finest_cosines(image) < _MAX_VANISHED:
        return True
    axes = []
    for values in (image, image.T):
        differences = np.abs(np.diff(values, 3, axis=1)[:, : (values.shape[1] - 3) // 8 * 8])
        sizes = np.maximum(
            np.median(differences, axis=0), 0.1 * differences.mean(axis=0)
        )  # medians of plain areas are 0
        logs = np.log(np.maximum(sizes, 1e-12)).reshape(-1, 8)
        edge = int((logs - np.roll(logs, 4, axis=1)).mean(axis=0).argmax())
        excess = logs[:, [edge]] - logs[:, (edge + np.arange(2, 7)) % 8]
        scores = excess.mean(axis=0) / np.maximum(excess.std(axis=0) / math.sqrt(len(logs)), 1e-12)
        axes.append((edge, float(scores[2]), max(float(scores.min()), 0.0)))
    edges, opposite, least = zip(*axes, strict=True)
    if edges == (6, 6):  # differences of pixels 6 to 9 are across the middle of an edge
        return math.hypot(*opposite) > _MIN_COMPRESSED
    return math.hypot(*least) > _MIN_COMPRESSED and min(least) > 0.5 * _MIN_COMPRESSED


def _finest_cosines(image: Values) -> float:
    """Return log((cosines of the highest frequencies in blocks of 8 x 8) / (in blocks at the best other phase))."""
    middle = tuple(slice(max(0, side - _COSINES_SIDE) // 16 * 8, None) for side in image.shape)
    part = image[middle][:_COSINES_SIDE, :_COSINES_SIDE]
    height, width = (side // 8 - 1 for side in part.shape)
    logs = np.zeros((8, 8))
    for down in (6, 7):
        along = [np.cos(math.pi / 16.0 * (2 * np.arange(8) + 1) * k) for k in (down, 6, 7)]
        rows = correlate1d(part, along[0], axis=0, origin=-4)  # of the pixels i to i + 7 at i
        for right in along[1:]:
            sizes = np.abs(correlate1d(rows, right, axis=1, origin=-4)[: 8 * height, : 8 * width])
            medians = np.median(sizes.reshape(height, 8, width, 8), axis=(0, 2))
            logs += 0.25 * np.log(np.maximum(medians, 1e-12))
    return float(logs[0, 0] - np.min(logs.ravel()[1:]))


def residual_variance(misfit: Values, aliases: Values) -> float:
    """Return the variance of the residuals of images relative to that of the noise, without that of `aliases`.

    These are details finer than binned pixels, and add as much to the misfit of each block, within a factor of about
    2: it is taken from the quarter of blocks with the least of them. `aliases` are NaN where depth is unknown.
    """
    examined, known = np.isfinite(misfit), np.isfinite(misfit + aliases)
    if not examined.any():
        return 1.0
    # Where frames differ by many times the noise assumed, as sharpened ones do, hardly any block has a depth.
    if known.sum() < _MIN_KNOWN * examined.sum():
        return float(np.median(misfit[examined]))
    least = known & (aliases <= np.quantile(aliases[known], _LEAST_ALIASED))
    return float(np.median((misfit / (1.0 + aliases))[least]))


def rounding_variances(levels: int, encoding: Encoding) -> tuple[Array, Array]:
    """Return the light of each of `levels` integers, 1 for the largest, and the variance of rounding to them."""
    steps = np.linspace(0.0, 1.0, levels)[:, None].repeat(3, axis=1)
    light = to_light("levels", steps, encoding, np.float64)[:, 1]  # of green, where channels differ
    return light, np.gradient(light) ** 2 / 12.0


class EstimatedNoise(NamedTuple):
    """Noise estimated from images, the fraction of rounding in its variance, and mean light, 1 for white, or NaN."""

    noise: Noise
    rounding: float = 0.0
    light: float = math.nan


def without_rounding(noise: Noise, light: Values, levels: int, encoding: Encoding) -> EstimatedNoise:
    """Return a noise without that of rounding to integers.

    Rounding that is most of the noise is not taken out: electrons at 1 are a lower bound. `light` is that of the
    pixels, 1 for white; floats have 0 `levels`.
    """
    mean_light = float(light.mean())
    if not levels:
        return EstimatedNoise(noise, 0.0, mean_light)
    white, read = float(np.mean(noise.white or 1.0)), float(np.mean(noise.read))
    variance = np.interp(light, *rounding_variances(levels, encoding)).mean()
    total = light.mean() / white + (read / white) ** 2
    share = min(float(variance / total), 1.0)
    if share <= MOSTLY_ROUNDING:
        noise = Noise(white=white / (1.0 - share), read=read / math.sqrt(1.0 - share))
    return EstimatedNoise(noise, share, mean_light)
