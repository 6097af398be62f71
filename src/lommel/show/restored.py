"""Pictures of restored stacks: projections before and after, and the residual."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from lommel.base.arrays import Values
from lommel.show.drawing import COLOURS, entitle, pyplot, round_length

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_UNKNOWN = "0.55"  # the colour of what is not known
_SIDE = 3.3  # inches of the longest side
_SIGMAS = 5.0  # of the residual
_LEAST = 0.18  # of the height of xy, that of xz is drawn at least


def projections(
    channels: Sequence[tuple[str, Sequence[tuple[Values, Values]]]], voxel: tuple[float, float], title: str
) -> Figure:
    """Draw projections of channels: recorded, restored, residual, each along z and, below that, along y.

    `voxel` is the step along z and the pixel, metres. Brightness is the square root of the values, from 0 to the
    largest of each; the residual is in standard deviations.
    """
    height, width = channels[0][1][0][0].shape
    planes = len(channels[0][1][0][1])
    step, pixel = voxel
    wide, high, deep = width * pixel, height * pixel, planes * step
    inch = _SIDE / max(wide, high)
    below = max(deep, _LEAST * high)
    size = 3 * (inch * wide + 0.25) + 1.1, len(channels) * (inch * (high + below) + 0.75) + 0.5
    figure: Figure = pyplot().figure(figsize=size, layout="compressed")
    axes: Any = figure.subplots(2 * len(channels), 3, height_ratios=[high, below] * len(channels), squeeze=False)
    for rows, (name, pictures) in zip(axes.reshape(len(channels), 2, 3), channels, strict=True):
        for column, (words, pair) in enumerate(zip(("recorded", "restored", "residual"), pictures, strict=True)):
            for panel, values, extent in zip(
                rows[:, column], pair, ((0.0, wide, high, 0.0), (0.0, wide, deep, 0.0)), strict=True
            ):
                how: dict[str, Any] = {"cmap": "RdBu_r", "vmin": -_SIGMAS, "vmax": _SIGMAS}
                if words != "residual":
                    how = {"cmap": COLOURS, "vmin": 0.0, "vmax": math.sqrt(float(np.nanmax(pair[0], initial=1e-30)))}
                    values = np.sqrt(np.maximum(values, 0.0))
                drawn = panel.imshow(values, extent=extent, interpolation="nearest", **how)
                panel.set(xticks=[], yticks=[], facecolor=_UNKNOWN)
                panel.set_aspect("equal" if below == deep or extent[2] == high else "auto")
            rows[0, column].set_title(f"{name}{words}", fontsize=9)
        rows[0, 0].set_ylabel("xy", fontsize=9)
        rows[1, 0].set_ylabel("xz", fontsize=9)
        figure.colorbar(drawn, ax=rows[:, 2].tolist(), label="residual over noise", shrink=0.9, extend="both")
        _scale_bar(rows[1, 0], wide)
    entitle(figure, title)
    return figure


def _scale_bar(axes: Any, width: float) -> None:
    """Draw a bar below axes whose width is in metres, with its length beside it."""
    length = round_length(0.3 * width)
    color = axes.yaxis.label.get_color()  # which is white in dark styles
    place = axes.get_xaxis_transform()
    axes.plot([0.0, length], [-0.09, -0.09], color=color, linewidth=2.5, transform=place, clip_on=False)
    words = f" {1e6 * length:g} µm; z is that of the stage"
    axes.text(length, -0.09, words, transform=place, fontsize=8, va="center")
