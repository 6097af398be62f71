"""Labels, units, brightness scales and axes of all plots."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Values
from lommel.base.optional import library

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.colors import Normalize
    from matplotlib.figure import Figure
    from matplotlib.image import AxesImage

MEANING = {
    "energy": "fraction of all light per pixel",
    "emitted": "light per pixel over all that is collected far from the glass",
    "strehl": "1 = unaberrated peak",
    "peak": "1 = largest value",
}
"""What a value is, by the normalisation."""

HOW = {"pixel": "averaged over each pixel", "center": "sampled at pixel centres"}
"""How values see their pixels, by :attr:`lommel.PSF.sampling`."""

USER = ("plots need", "plot")
"""What needs a library, and the extra that brings it."""

STRETCHES = {
    "sqrt": "the square root of the value",
    "linear": "the value",
    "log": "the logarithm of the value,\ndown to 1e-5 of the largest",
}
"""The scales of brightness: what is linear on each."""

COLOURS = "inferno"
"""The colour map of light, as of the live page."""

MOST = 64
"""Pictures in one figure."""

_FLOOR = 1e-5  # of the peak: the bottom of logarithmic scales


def norm_of(stretch: str, values: Values) -> Normalize:
    """Return the scale of brightness of values up to the largest of these, or up to 1."""
    library("matplotlib", *USER)
    from matplotlib import colors

    peak = float(np.max(values)) or 1.0
    if stretch == "log":
        return colors.LogNorm(_FLOOR * peak, peak, clip=True)
    return colors.PowerNorm(0.5, 0.0, peak) if stretch == "sqrt" else colors.Normalize(0.0, peak)


def even_norm(largest: float) -> Normalize:
    """Return the scale of what is positive or negative, the same both ways; of nothing but 0 from -1 to 1."""
    library("matplotlib", *USER)
    from matplotlib.colors import Normalize

    return Normalize(-(largest or 1.0), largest or 1.0)


def stretched(light: Values, stretch: str) -> NDArray[np.float64]:
    """Return levels from 0 to 1 of light from 0 to 1."""
    if stretch == "log":
        return np.asarray(1.0 - np.log10(np.maximum(light, _FLOOR)) / np.log10(_FLOOR))
    return np.asarray(np.sqrt(light) if stretch == "sqrt" else light, dtype=np.float64)


def pyplot() -> Any:
    """Return ``matplotlib.pyplot``; ImportError if it is not installed."""
    return library("matplotlib.pyplot", *USER)


def new_axes(ax: Axes | None, **options: object) -> Axes:
    """Return the axes that were given, or those of a new figure with these options."""
    if ax is None:
        ax = pyplot().subplots(layout="constrained", **options)[1]
    return ax


def lengths(unit: str) -> tuple[float, str]:
    """Return what lengths in the `unit` of a pupil are multiplied by on axes, and the unit there."""
    return (1e6, "µm") if unit == "m" else (1.0, "λN")


def frequencies(unit: str) -> tuple[float, str]:
    """Return the same of spatial frequencies, cycles per `unit`."""
    return (1e-3, "cycles/mm") if unit == "m" else (1.0, "cycles/λN")


def only_single(ax: Axes | None, shape: tuple[int, ...]) -> None:
    """Refuse one pair of axes for a stack, which takes many; ValueError."""
    if ax is not None and shape != ():
        raise ValueError(f"ax must be None for a stack, which takes many, got a stack of shape {shape}")


def at_most(shape: tuple[int, ...]) -> None:
    """Refuse a stack that is too large for one figure; ValueError."""
    if int(np.prod(shape)) > MOST:
        raise ValueError(f"at most {MOST} can be drawn, got a stack of shape {shape}; index it, as stack[:8]")


def round_length(most: float) -> float:
    """Return the largest of 1, 2 and 5 times a power of ten that is no more than `most`."""
    decade = 10.0 ** np.floor(np.log10(most))
    return float(max(k * decade for k in (1.0, 2.0, 5.0) if k * decade <= most * (1.0 + 1e-12)))


def columns_of(count: int) -> int:
    """Return the columns that so many pictures side by side take: one row of up to eight, else few empty places."""
    if count <= 8:
        return count
    return min(range(3, 9), key=lambda columns: (-count % columns, abs(columns - math.sqrt(1.5 * count))))


def figure_of(drawn: Figure | Axes) -> Figure:
    """Return the whole figure of axes, or of a part of it."""
    figure = drawn.get_figure(root=True)
    assert figure is not None
    return figure


def fitted(text: str, drawn: Figure | Axes, size: float = 9.0) -> str:
    """Return a title broken between words into lines no wider than its figure, for letters of so many points."""
    figure = figure_of(drawn)
    letters = int(72.0 * figure.get_figwidth() / (0.56 * size))
    return "\n".join(part for line in text.split("\n") for part in _wrapped(line, letters))


def _wrapped(line: str, most: int) -> list[str]:
    """Return a text in as few lines as its letters take, none of which is much shorter than the others."""
    lines = textwrap.wrap(line, most) or [""]
    for width in range(-(-len(line) // len(lines)), most if len(lines) > 1 else 0):
        if len(even := textwrap.wrap(line, width)) == len(lines):
            return even
    return lines


def entitle(figure: Figure, text: str) -> None:
    """Give a figure a title above all of its axes, within its width."""
    figure.suptitle(fitted(text, figure), fontsize=9)


def circle(axes: Axes, radius: float, **how: Any) -> None:
    """Draw a dashed circle about the origin."""
    angle = np.linspace(0.0, 2.0 * np.pi, 181)
    axes.plot(radius * np.cos(angle), radius * np.sin(angle), "--", **how)


def only_outer(axes: Axes, k: int, count: int, columns: int) -> None:
    """Leave labels to the first of each row, and to the last of each column, of pictures side by side."""
    if k % columns:
        axes.set(ylabel="", yticklabels=[])
    if k + columns < count:
        axes.set(xlabel="", xticklabels=[])


def caption(axes: Axes, title: str, label: str) -> None:
    """Give a picture in a figure of its own a title, and a colour bar with a label."""
    axes.set_title(fitted(title, axes), fontsize=9)
    axes.figure.colorbar(axes.images[-1], ax=axes, label=label)


def complete_curves(
    axes: Axes,
    title: str | None,
    xlim: tuple[float, float],
    loc: Literal["best", "lower right"] = "best",
    **labels: str,
) -> None:
    """Give curves of fractions labels, limits, a grid, a legend, and a title where the figure is their own."""
    axes.set(xlim=xlim, ylim=(0.0, 1.05), **labels)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8, loc=loc)
    if title is not None:
        axes.set_title(fitted(title, axes), fontsize=9)


def tiles(
    shape: tuple[int, ...],
    draw: Callable[[tuple[int, ...], Axes], AxesImage],
    titles: list[str],
    title: str,
    label: str,
) -> NDArray[np.object_]:
    """Draw a stack side by side in a new figure with one colour bar; `draw` takes an index and axes."""
    at_most(shape)
    count = int(np.prod(shape))
    columns = shape[1] if len(shape) == 2 else columns_of(count)
    rows = -(-count // columns)
    figure = pyplot().figure(
        figsize=(max(min(2.0 * columns, 14.0) + 1.2, 4.4), 2.0 * rows + 0.8), layout="constrained"
    )
    drawn = np.empty(shape, dtype=object)
    shown: AxesImage | None = None
    for k, index in enumerate(np.ndindex(shape)):
        axes = drawn[index] = figure.add_subplot(rows, columns, k + 1)
        shown = draw(index, axes)
        axes.set_title(titles[k], fontsize=8)
        axes.tick_params(labelsize=7)
        only_outer(axes, k, count, columns)
    entitle(figure, title)
    figure.colorbar(shown, ax=drawn.ravel().tolist(), label=label)
    return drawn
