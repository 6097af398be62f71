"""Plots of what is estimated: depth maps, the precision of depth, and wavefronts fitted to images."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from lommel.base.arrays import Array, Values
from lommel.base.optional import library
from lommel.show.drawing import COLOURS, USER, fitted, new_axes, pyplot
from lommel.show.labels import length_in_words

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_UNKNOWN = "0.55"  # the colour of what is not known


def maps(depth: Array, errors: Array, light: Values | None) -> Figure:
    """Draw depth and its standard error (metres, NaN grey), and the light of the sharp image, side by side."""
    height, width = depth.shape
    count = 2 if light is None else 3
    side = 4.4
    figure: Figure = pyplot().figure(
        figsize=(count * side, side * min(max(height / width, 0.4), 2.0) + 0.9), layout="constrained"
    )
    axes: Any = figure.subplots(1, count)
    known = np.isfinite(errors)
    low, high = np.percentile(depth[known], [0.5, 99.5]) if known.any() else (0.0, 1.0)
    shown = axes[0].imshow(depth, cmap="viridis_r", vmin=low, vmax=high, interpolation="nearest")
    figure.colorbar(shown, ax=axes[0], label="depth (m)", extend="both", shrink=0.85)
    axes[0].set_title(f"depth, known at {100.0 * known.mean():.3g} %", fontsize=10)
    norm: Any = None
    millimetres = np.where(known, 1e3 * errors, np.nan)
    if known.any():
        ends = np.percentile(millimetres[known], [0.5, 99.5])
        norm = library("matplotlib.colors", *USER).LogNorm(*(ends * [0.99, 1.01]))
    shown = axes[1].imshow(millimetres, cmap=COLOURS, norm=norm, interpolation="nearest")
    figure.colorbar(shown, ax=axes[1], label="standard error of depth (mm)", extend="both", shrink=0.85)
    axes[1].set_title("standard error", fontsize=10)
    if light is not None:
        top = float(np.percentile(light, 99.5))
        within = np.clip(light / top if top > 0.0 else light, 0.0, 1.0) ** (1.0 / 2.2)
        axes[2].imshow(within, cmap="gray" if light.ndim == 2 else None, interpolation="nearest")
        axes[2].set_title("all-in-focus image", fontsize=10)
    for each in axes:
        each.set(xticks=[], yticks=[], facecolor=_UNKNOWN)
    return figure


def precision(distance: Array, curves: Mapping[str, Array], title: str, foci: Sequence[float] = ()) -> Axes:
    """Draw standard errors of depth over the distance (metres, logarithmic); infinite ones are gaps.

    Dotted lines mark the focus distances `foci` that are within the range.
    """
    axes = new_axes(None, figsize=(7.0, 4.4))
    finite = np.concatenate([curve[np.isfinite(curve)] for curve in curves.values()])
    for name, curve in curves.items():
        axes.semilogy(distance, np.where(np.isfinite(curve), 1e3 * curve, np.nan), label=name)
    if finite.size:
        # Poles would leave no room for what matters.
        least = 1e3 * float(finite.min())
        axes.set_ylim(0.7 * least, min(1.5e3 * float(finite.max()), 300.0 * least))
    axes.set(xlabel="distance (m)", ylabel="standard error of depth (mm)")
    axes.set_title(fitted(title, axes, 10), fontsize=10)
    axes.grid(which="both", alpha=0.3)
    for focus in foci:
        if distance[0] <= focus <= distance[-1]:
            axes.axvline(focus, color="0.4", linewidth=1.0, linestyle=":")
            words = f" focus {length_in_words(focus)}"
            place = axes.get_xaxis_transform()
            axes.text(focus, 0.98, words, transform=place, fontsize=8, rotation=90, va="top", ha="right")
    if len(curves) > 1:
        axes.legend(fontsize=9)
    plain = library("matplotlib.ticker", *USER).FuncFormatter(lambda value, _: f"{value:g}")
    axes.yaxis.set_major_formatter(plain)
    if finite.size and math.log10(axes.get_ylim()[1] / axes.get_ylim()[0]) < 1.5:
        axes.yaxis.set_minor_formatter(plain)
    return axes


_MOST = 8  # images in one figure
_SIGMAS = 4.0


def fit(
    images: Array,
    model: Array,
    residual: Array,
    found: tuple[list[str], list[float], list[float], str],
    title: str,
    titles: Sequence[str],
) -> Figure:
    """Draw images (n, height, width), their model, the residual over the noise, and the fitted terms in a unit."""
    names, values, errors, unit = found
    count = min(len(images), _MOST)
    bars = max(3.0, 0.42 * len(names))
    figure: Figure = pyplot().figure(figsize=(max(1.9 * count + bars + 2.2, 7.0), 6.2), layout="constrained")
    parts: Any = figure.subfigures(1, 2, width_ratios=(1.9 * count + 1.2, bars + 1.0))
    pictures, graph = parts
    axes = pictures.subplots(3, count, squeeze=False)
    for k in range(count):
        low, high = np.nanmin(images[k]), np.nanmax(images[k])
        norm = library("matplotlib.colors", *USER).PowerNorm(0.5, low, high)
        axes[0, k].imshow(images[k], cmap=COLOURS, norm=norm, interpolation="nearest")
        axes[1, k].imshow(model[k], cmap=COLOURS, norm=norm, interpolation="nearest")
        left = axes[2, k].imshow(residual[k], cmap="RdBu_r", vmin=-_SIGMAS, vmax=_SIGMAS, interpolation="nearest")
        axes[0, k].set_title(titles[k] if len(titles[k]) < 22 else f"…{titles[k][-20:]}", fontsize=8)
    for row, text in zip(axes, ("measured", "model", "residual"), strict=True):
        row[0].set_ylabel(text, fontsize=9)
    for each in axes.flat:
        each.set(xticks=[], yticks=[], facecolor="0.5")  # what was left out
    pictures.colorbar(left, ax=axes[2].tolist(), label="residual / noise", shrink=0.9)
    drawn = graph.subplots()
    at = np.arange(len(names))
    finite = [d if np.isfinite(d) else 0.0 for d in errors]
    drawn.bar(at, values, color="C0", alpha=0.6)
    drawn.errorbar(at, values, yerr=finite, fmt="none", ecolor=drawn.xaxis.label.get_color(), capsize=3)
    drawn.axhline(0.0, color="0.5", linewidth=0.8)
    drawn.set_xticks(at, names, rotation=90, fontsize=8)
    drawn.set_ylabel(f"coefficient and standard error ({'µm' if unit == 'um' else unit})")
    drawn.set_title(title, fontsize=9)
    return figure


_REASONS = {
    "saturated": ("s", "C3"),
    "edge": ("^", "C1"),
    "masked": ("D", "C5"),
    "neighbor": ("o", "C4"),
    "defect": ("x", "C2"),
}


_LEFT_OUT = "#f7cdbb"  # of pixels that are NaN or masked


def spots(
    image: Array,
    places: Values,
    box: tuple[int, int],
    refused: Sequence[tuple[int, int, str]],
    title: str,
    ax: Axes | None,
) -> Axes:
    """Draw an image with the windows around spots, and those refused by reason."""
    axes = new_axes(ax, figsize=(7.0, 7.0 * min(max(image.shape[0] / image.shape[1], 0.4), 1.4) + 0.8))
    low, high = np.nanpercentile(image, [1.0, 99.8])
    norm = library("matplotlib.colors", *USER).PowerNorm(0.5, low, max(high, low + 1e-9), clip=True)
    axes.imshow(image, cmap="gray_r", norm=norm, interpolation="nearest")
    axes.set_facecolor(_LEFT_OUT)
    rectangle = library("matplotlib.patches", *USER).Rectangle
    for k, (row, column) in enumerate(places.tolist()):
        corner = column - box[1] // 2 - 0.5, row - box[0] // 2 - 0.5
        label = "window" if k == 0 else None
        axes.add_patch(rectangle(corner, box[1], box[0], fill=False, edgecolor="C0", linewidth=1.0, label=label))
    for reason, (marker, colour) in _REASONS.items():
        at = np.array([(column, row) for row, column, why in refused if why == reason])
        if at.size:
            axes.plot(*at.T, marker, markersize=6, color=colour, fillstyle="none", label=f"refused: {reason}")
    if len(places) or refused:
        axes.legend(fontsize=8, loc="upper left", bbox_to_anchor=(0.0, -0.13), ncols=3, frameon=False)
    axes.set(xlabel="column", ylabel="row", xlim=(-0.5, image.shape[1] - 0.5), ylim=(image.shape[0] - 0.5, -0.5))
    axes.set_title(fitted(title, axes, 10), fontsize=10)
    return axes
