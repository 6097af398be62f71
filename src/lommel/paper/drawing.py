"""Plotting functions of the figures: images on a common scale, and slices."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.colors import Normalize
    from matplotlib.figure import Figure

V_AXIS = "v = πr/(λN)"
COLORS = {"exact": "black", "fft": "tab:green", "printed": "tab:red", "corrected": "tab:blue"}
LABELS = {
    "exact": "exact (NijboerZernike)",
    "fft": "FFT, as large as the image",
    "printed": "CFIS, Eq. (12) as printed",
    "corrected": "CFIS, with √(2/π) restored",
}


def new_figure(width: float, height: float) -> Figure:
    """Return a figure of that many inches."""
    from matplotlib.figure import Figure as NewFigure

    return NewFigure(figsize=(width, height), layout="constrained")


def panels(figure: Any, count: int, **properties: Any) -> Any:
    """Return that many axes beside each other, with a grid and the properties that all have."""
    made = figure.subplots(1, count)
    for axes in made:
        axes.set(**properties)
        axes.grid(alpha=0.3)
    return made


def intensity_norm(top: float) -> Normalize:
    """Return a square-root scale, on which faint rings are seen beside the peak."""
    from matplotlib.colors import PowerNorm

    return PowerNorm(0.5, 0.0, top)


def error_norm(top: float) -> Normalize:
    """Return a signed scale, linear up to a hundredth of the peak and logarithmic beyond."""
    from matplotlib.colors import SymLogNorm

    return SymLogNorm(0.01, vmin=-top, vmax=top, base=10)


def picture(axes: Axes, values: NDArray[np.float64], window: float, norm: Normalize, title: str) -> Any:
    """Draw an image over v, from -window to window."""
    side = values.shape[0]
    step = window / (side // 2)
    low, high = -(side // 2 + 0.5) * step, (side - side // 2 - 0.5) * step
    signed = norm.vmin is not None and norm.vmin < 0
    drawn = axes.imshow(
        values,
        extent=(low, high, high, low),
        norm=norm,
        cmap="RdBu_r" if signed else "magma",
        interpolation="nearest" if side < 256 else "antialiased",
    )
    axes.set_title(title, fontsize=9)
    axes.tick_params(labelsize=7)
    axes.locator_params(nbins=5)
    return drawn


def picture_rows(
    rows: Sequence[Sequence[NDArray[np.float64]]],
    titles: Sequence[Sequence[str]],
    names: Sequence[str],
    window: float,
    norm: Normalize,
    label: str,
    heading: str,
) -> Figure:
    """Draw rows of images with one scale and one colour bar."""
    columns = len(rows[0])
    figure = new_figure(2.35 * columns + 1.3, 2.5 * len(rows) + 0.6)
    figure.suptitle(heading, fontsize=10)
    grid: Any = figure.subplots(len(rows), columns, squeeze=False, sharex=True, sharey=True)
    drawn: Any = None
    for axes_row, images, texts, name in zip(grid, rows, titles, names, strict=True):
        for axes, image, text in zip(axes_row, images, texts, strict=True):
            drawn = picture(axes, image, window, norm, text)
        axes_row[0].set_ylabel(f"{name}\nv along y", fontsize=8)
    for axes in grid[-1]:
        axes.set_xlabel(f"{V_AXIS} along x" if columns < 3 else "v along x", fontsize=8)
    bar = figure.colorbar(drawn, ax=grid, shrink=0.8, label=label)
    if norm.vmin is not None and norm.vmin < 0 and norm.vmax is not None:
        shown = [m for m in (0.01, 0.03, 0.1, 0.3, 1.0, 3.0) if m <= norm.vmax]
        ticks = [*(-m for m in reversed(shown)), 0.0, *shown]
        bar.set_ticks(ticks, labels=[f"{m:g}".replace("-", "−") for m in ticks])
    bar.ax.tick_params(labelsize=7)
    return figure
