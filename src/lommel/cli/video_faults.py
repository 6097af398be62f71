"""Faults of video for which blocks have no depth, or larger errors: compression, motion and bands of brightness."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base.arrays import Array, Values
from lommel.base.encoding import to_light
from lommel.imaging.focal_engine import BLOCK
from lommel.io.videos import MACROBLOCK

if TYPE_CHECKING:
    from lommel.cli.video_coding import Coding

MAX_LOSS = 32.0
"""Largest variance that compression adds, relative to noise, of blocks with depth."""

MISFIT_OF_LOSS = 0.25
"""Largest increase of the misfit of right depth / (variance that compression adds, relative to noise), as measured.

Faint details, which quantization removes, lose less than the variance of rounding.
"""

FINEST_JPEG = 1.5 / 255.0**2
"""Variance that Motion JPEG of quality 1 adds to values from 0 to 1."""

_BLOCK_WINDOW = np.array([1.0, 4.0, 6.0, 4.0, 1.0]) / 16.0  # weights of neighbouring blocks, as those of depth
_LOSS_REACH = 7  # blocks: side of the square whose largest loss counts, since depth is found from a neighbourhood
_CODES = 256  # number of codes at which the step of the encoding is computed
_ROW_SMOOTHING = 4.0  # standard deviation, rows, of the Gaussian that smooths the brightness of rows
_ROW_PASSES = 3  # number of times that the remainder of smoothing is smoothed and added: 1 - (1 - G)^3 for a filter G
_DARK_ROW = 0.1  # fraction of the mean brightness: darker rows have no ratio
_MAX_BANDS = 0.008  # largest rms of the change of brightness from row to row that smoothing leaves
_BAND_ROWS = 8.0  # standard deviation, rows, of the Gaussian over which this is the mean
_MEDIAN_NOISE = 1.25  # standard deviation of a median / that of the mean
_FLAT = 1.5  # mean texture of blocks, relative to noise, below which they are called flat


def _electrons(frame: Values, coding: Coding) -> Values:
    """Return the electrons of a frame of light, at least 1; 1 where it is not known."""
    values = np.nan_to_num(frame.astype(np.float32)) - np.float32(coding.noise.offset)
    return np.asarray(np.maximum(values * np.float32(coding.noise.white or 1.0), 1.0))


def _block_means(values: Values) -> Values:
    """Return the means of blocks of 4 x 4 pixels."""
    height, width = (side // BLOCK for side in values.shape)
    rows = values[: height * BLOCK, : width * BLOCK].reshape(height, BLOCK, width * BLOCK).mean(axis=1)
    return np.asarray(rows.reshape(height, width, BLOCK).mean(axis=2))  # in two steps: a third of the time


def _over_window(blocks: Values, axes: tuple[int, ...] = (0, 1)) -> Values:
    """Return the mean over the window of blocks that determines the depth of a block."""
    for axis in axes:
        blocks = scipy.ndimage.convolve1d(blocks, _BLOCK_WINDOW, axis=axis, mode="nearest")
    return blocks


def smooth_rows(values: Values) -> Values:
    """Return values of rows without changes over few rows: 99.5 % of a period of 40 rows is left, 83 % of 20."""
    smooth = np.zeros_like(values)
    for _ in range(_ROW_PASSES):
        smooth += scipy.ndimage.gaussian_filter1d(values - smooth, _ROW_SMOOTHING)
    return smooth


def _loss_of_codes(coding: Coding) -> tuple[Array, Array]:
    """Return stored values, 0 to 1, and (variance of light for a variance of 1 of the value) / (that of noise)."""
    codes = np.linspace(0.0, 1.0, _CODES)
    light = to_light("codes", codes[:, None].repeat(3, axis=1), coding.encoding, np.float64)[:, 1]
    dark = coding.noise.offset * float(coding.noise.white or 1.0)  # electrons
    noise = np.maximum(light * coding.white - dark, 1.0) + coding.noise.read**2
    return codes, (np.gradient(light, codes) * coding.white) ** 2 / noise


def loss_note(loss: float | Values, coding: Coding) -> str:
    """Return a sentence if compression adds more than noise to a medium value, otherwise an empty one."""
    median = float(np.median(loss))
    relative = median * float(_loss_of_codes(coding)[1][_CODES // 2]) if median else 0.0
    if relative < 1.0:
        return ""
    effect = "smooths its blocks, or its quantization cannot be read: depth is not known."
    if math.isfinite(relative):
        effect = (
            f"adds {relative:.2g} times the variance of noise to medium values, and removes fainter texture; above "
            f"{MAX_LOSS:g} times depth is not known."
        )
    finer = ", or as Motion JPEG of quality 1 (-q:v 1 -qmin 1 of ffmpeg)" if median > FINEST_JPEG else ""
    return f"Compression {effect} Record without loss (FFV1, PNG){finer}."


def relative_loss(frames: Sequence[Values], loss: float | Values, coding: Coding) -> Values:
    """Return the largest variance that compression adds to blocks of stored frames, relative to that of noise."""
    if not np.any(loss):
        return np.zeros(())
    largest = float(np.iinfo(frames[0].dtype).max) if frames[0].dtype.kind == "u" else 1.0
    means = np.array([_block_means(frame.astype(np.float32)) for frame in frames]) / largest
    side = MACROBLOCK // BLOCK
    blocks = np.kron(loss, np.ones((side, side)))[: means.shape[1], : means.shape[2]] if np.ndim(loss) else loss
    relative = (blocks * np.interp(means, *_loss_of_codes(coding))).max(axis=0)
    return np.asarray(scipy.ndimage.maximum_filter(relative, _LOSS_REACH))


def changes(earlier: Values, later: Values, coding: Coding) -> tuple[Values, NDArray[np.bool_]]:
    """Compare two frames of light of one focus, apart from the brightness of rows.

    Returns (1) the mean squared difference of blocks, relative to noise: 1 where nothing moved; (2) whether rows of
    blocks, shape (height // 4, 1), have bands of brightness that are too narrow to be undone.
    """
    first, second = (_electrons(frame, coding) for frame in (earlier, later))
    means, read = first.mean(axis=1), coding.noise.read**2
    lit = means > _DARK_ROW * means.mean()
    half = np.median(second[:, ::2] / first[:, ::2], axis=1)  # of half the columns: a fifth of the time
    ratio = np.where(lit, np.maximum(half, _DARK_ROW), 1.0).astype(np.float32)
    squares = (second / ratio[:, None] - first) ** 2 / (first + read + (second + read) / ratio[:, None] ** 2)
    bands = (np.log(ratio) - smooth_rows(np.log(ratio))) ** 2
    chance = 4.0 * _MEDIAN_NOISE**2 * (means + read) / (first.shape[1] * means**2)  # variance of the logarithm
    uneven = scipy.ndimage.gaussian_filter1d(bands, _BAND_ROWS) > _MAX_BANDS**2 + 4.0 * chance
    return _over_window(_block_means(squares)), _block_means(uneven[:, None].repeat(BLOCK, axis=1)) > 0.0


def is_flat(frames: Sequence[Values], coding: Coding) -> NDArray[np.bool_]:
    """Return whether blocks of frames of light have hardly more structure along rows than noise."""
    light = [_block_means(_electrons(frame, coding)) for frame in frames]
    structure = [
        (one - _over_window(one, (1,))) ** 2 / (one + coding.noise.read**2) * (BLOCK**2 / len(light)) for one in light
    ]
    return np.asarray(_over_window(np.sum(structure, axis=0)) < _FLAT)
