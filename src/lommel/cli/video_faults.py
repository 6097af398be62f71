"""Faults of video for which blocks have no depth, or larger errors: compression, motion and bands of brightness."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base.arrays import Array, Values
from lommel.base.encoding import to_light
from lommel.imaging.focal_engine import BLOCK
from lommel.io.videos import MACROBLOCK

if TYPE_CHECKING:
    from lommel.cli.video_commands import Coding

MAX_LOSS = 16.0
"""Largest variance that compression adds, relative to noise, of blocks with depth."""

_BLOCK_WINDOW = np.array([1.0, 4.0, 6.0, 4.0, 1.0]) / 16.0  # weights of neighbouring blocks, as those of depth
_LOSS_REACH = 5  # blocks: side of the square whose largest loss counts, since depth is found from a neighbourhood
_CODES = 256  # number of codes at which the step of the encoding is computed
_ROW_SMOOTHING = 4.0  # standard deviation, rows, of the Gaussian that smooths the brightness of rows
_ROW_PASSES = 3  # number of times that the remainder of smoothing is smoothed and added: 1 - (1 - G)^3 for a filter G
_DARK_ROW = 0.1  # fraction of the mean brightness: darker rows have no ratio
_MAX_BANDS = 0.008  # largest rms of the change of brightness from row to row that smoothing leaves
_BAND_ROWS = 8.0  # standard deviation, rows, of the Gaussian over which this is the mean
_MEDIAN_NOISE = 1.25  # standard deviation of a median / that of the mean
_FLAT = 1.5  # mean texture of blocks, relative to noise, below which they are called flat


def block_means(values: Values) -> Values:
    """Return the means of blocks of 4 x 4 pixels."""
    height, width = (side // BLOCK for side in values.shape)
    parts = values[: height * BLOCK, : width * BLOCK].reshape(height, BLOCK, width, BLOCK)
    return np.asarray(parts.mean(axis=(1, 3)))


def _over_window(blocks: Values) -> Values:
    """Return the mean over the window of blocks that determines the depth of a block."""
    for axis in (0, 1):
        blocks = scipy.ndimage.convolve1d(blocks, _BLOCK_WINDOW, axis=axis, mode="nearest")
    return blocks


def smooth_rows(values: Array) -> Array:
    """Return values of rows without changes over few rows: 99.5 % of a period of 40 rows is left, 83 % of 20."""
    smooth = np.zeros_like(values)
    for _ in range(_ROW_PASSES):
        smooth += scipy.ndimage.gaussian_filter1d(values - smooth, _ROW_SMOOTHING)
    return smooth


def relative_loss(stored: Values, loss: float | Values, coding: Coding) -> Values:
    """Return the variance that compression adds to blocks of a stored frame, relative to that of noise."""
    codes = np.linspace(0.0, 1.0, _CODES)
    light = to_light("codes", codes[:, None].repeat(3, axis=1), coding.encoding, np.float64)[:, 1]
    electrons = np.maximum(light - coding.noise.offset * coding.noise.white / coding.white, 0.0) * coding.white
    step = np.gradient(light, codes) * coding.white  # electrons
    largest = float(np.iinfo(stored.dtype).max) if stored.dtype.kind == "u" else 1.0
    means = block_means(stored.astype(np.float32)) / largest
    blocks = np.broadcast_to(np.float64(loss), means.shape) if np.ndim(loss) == 0 else np.asarray(loss)
    if np.ndim(loss):
        side = MACROBLOCK // BLOCK
        blocks = np.kron(blocks, np.ones((side, side)))[: means.shape[0], : means.shape[1]]
    relative = blocks * np.interp(means, codes, step**2 / (electrons + coding.noise.read**2 + 1.0))
    return np.asarray(scipy.ndimage.maximum_filter(relative, _LOSS_REACH))


def changes(earlier: Values, later: Values, coding: Coding) -> tuple[Values, NDArray[np.bool_]]:
    """Compare two frames of one focus, apart from the brightness of rows.

    Returns (1) the mean squared difference of blocks, relative to noise: 1 where nothing moved; (2) whether rows of
    blocks, shape (height // 4, 1), have bands of brightness that are too narrow to be undone.
    """
    noise = coding.noise
    white, floor = float(noise.white or 1.0), noise.read**2 + 1.0
    first, second = (np.maximum((frame.astype(np.float32) - noise.offset) * white, 0.0) for frame in (earlier, later))
    means = first.mean(axis=1)
    ratio = np.where(means > _DARK_ROW * means.mean(), np.median((second + 1.0) / (first + 1.0), axis=1), 1.0)
    second = second / np.maximum(ratio, 0.1)[:, None]
    squares = (second - first) ** 2 / (first + second / np.maximum(ratio, 0.1)[:, None] + 2.0 * floor)
    rows = np.log(np.maximum(ratio, 0.1))
    bands = np.sqrt(scipy.ndimage.gaussian_filter1d((rows - smooth_rows(rows)) ** 2, _BAND_ROWS))
    chance = _MEDIAN_NOISE * np.sqrt(2.0 * (means + floor) / first.shape[1]) / np.maximum(means, 1.0)
    uneven = bands > np.hypot(_MAX_BANDS, 2.0 * chance)
    blocks = len(rows) // BLOCK
    return _over_window(block_means(squares)), uneven[: blocks * BLOCK].reshape(blocks, BLOCK).any(axis=1)[:, None]


def is_flat(frames: list[Values], coding: Coding) -> NDArray[np.bool_]:
    """Return whether blocks of frames have hardly more structure along rows than noise."""
    noise, texture = coding.noise, np.float64(0.0)
    for frame in frames:
        light = (block_means(np.nan_to_num(frame)) - noise.offset) * float(noise.white or 1.0)
        smooth = scipy.ndimage.convolve1d(light, _BLOCK_WINDOW, axis=1, mode="nearest")
        variance = (np.maximum(light, 0.0) + noise.read**2 + 1.0) / BLOCK**2
        texture = texture + _over_window((light - smooth) ** 2 / variance) / len(frames)
    return np.asarray(texture < _FLAT)
