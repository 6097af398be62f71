"""Pictures of depth maps of blocks, frame by frame: colours with a bar that states their range."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from lommel.base.optional import library
from lommel.base.units import format_length

Colours = NDArray[np.uint8]

_UNKNOWN, _BACK, _INK = 128, 24, 235  # grey levels
_BAR, _TEXT = 24, 12  # pixels: height of the bar, and of its letters
_LEAST = 100  # pixels of a gradient beside which the bar has room for the word on grey


class DepthColours:
    """Colours of depths, yellow for the nearest to violet for the farthest, in equal steps of 1 / distance.

    Parameters
    ----------
    between : (float, float)
        Nearest and farthest distance, metres; the farthest may be infinite.
    shape : (int, int)
        Height and width of the frames, pixels.
    block : int
        Pixels a side of the blocks.
    beside : bool
        Whether an image will stand to the right.
    """

    def __init__(self, between: tuple[float, float], shape: tuple[int, int], block: int, beside: bool) -> None:
        user = ("the colours of depth need", "plot")
        colours = library("matplotlib", *user).colormaps["viridis_r"](np.linspace(0.0, 1.0, 255))
        grey = [[_UNKNOWN] * 3]
        self._table: Colours = np.concatenate([grey, np.rint(255.0 * colours[:, :3])]).astype(np.uint8)
        self._near, self._far = (1.0 / each for each in between)
        self._shape, self._block = shape, block
        height, width = shape[0], shape[1] * (1 + beside)
        self._picture = np.full((height + _BAR, width, 3), _BACK, np.uint8)
        self._picture[:height] = _UNKNOWN
        self._picture[height:] = self._bar(between, width)

    def _bar(self, between: tuple[float, float], width: int) -> Colours:
        """Return the gradient between its ends in words, and the grey of what is not known where there is room."""
        image, drawing = (
            library(f"PIL.{name}", "the bar of colours needs", "images") for name in ("Image", "ImageDraw")
        )
        made = image.new("RGB", (width, _BAR), (_BACK,) * 3)
        draw = drawing.Draw(made)
        draw.fontmode = "L"
        font = library("PIL.ImageFont", "the bar of colours needs", "images").load_default(_TEXT)
        ends = [format_length(each) if math.isfinite(each) else "infinity" for each in between]
        words = [*ends, "not known"]
        left, right, unknown = (math.ceil(draw.textlength(each, font=font)) for each in words)
        start = left + 10
        stop = width - right - 10
        wide = stop - start - unknown - _BAR - 12 >= _LEAST
        if wide:
            stop -= unknown + _BAR + 12
            draw.rectangle((stop + right + 18, 6, stop + right + 18 + _BAR - 8, _BAR - 7), fill=(_UNKNOWN,) * 3)
            draw.text((width - unknown - 4, _BAR // 2), words[2], fill=(_INK,) * 3, font=font, anchor="lm")
        draw.text((4, _BAR // 2), words[0], fill=(_INK,) * 3, font=font, anchor="lm")
        draw.text((stop + 6, _BAR // 2), words[1], fill=(_INK,) * 3, font=font, anchor="lm")
        bar = np.array(made)
        if stop - start > 8:
            places = 1 + np.rint(np.linspace(0.0, 254.0, stop - start)).astype(int)
            bar[6:-6, start:stop] = self._table[places]
        return bar

    def __call__(self, depth: NDArray[np.float32], image: Colours | None = None) -> Colours:
        """Return the picture of a depth map, NaN where not known, with a grey image beside it if there is one.

        The next call overwrites it.
        """
        with np.errstate(invalid="ignore"):
            share = (self._near - 1.0 / depth) / (self._near - self._far)
            level = np.where(np.isfinite(depth), 1.0 + 254.0 * np.clip(share, 0.0, 1.0), 0.0).astype(np.uint8)
        blocks = self._table[level]
        spread = np.repeat(np.repeat(blocks, self._block, axis=0), self._block, axis=1)
        height, width = spread.shape[:2]
        self._picture[:height, :width] = spread
        rows, columns = self._shape
        self._picture[:rows, columns:] = _UNKNOWN if image is None else image[..., None]
        return self._picture
