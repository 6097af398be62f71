"""Noise of images that differ in focus, estimated from these images."""

from __future__ import annotations

import math

import numpy as np

from lommel.base.arrays import Array, Values
from lommel.recorded.camera_noise import image_noise

_MIN_COMPRESSED = 6.0  # standard errors by which third differences differ at edges of JPEG blocks
_MAX_DARK = 0.9  # largest fraction of the noise that is put down to read noise


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
    all phases inside are alike, and the edges exceed each of them along either axis.
    """
    if min(image.shape) < 9 * 8:  # too few blocks
        return False
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


def residual_variance(misfit: Values) -> float:
    """Return the variance of the residuals of images relative to that of the noise."""
    values = misfit[np.isfinite(misfit)]
    return float(np.median(values)) if values.size else 1.0
