"""Plot of a fit: images, model, residual and the fitted terms."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from lommel.base.arrays import Array
from lommel.base.optional import library

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_MOST = 8  # images in one figure
_SIGMAS = 4.0


def fit(
    images: Array, model: Array, residual: Array, found: tuple[list[str], list[float], list[float]], title: str
) -> Figure:
    """Draw images (n, height, width), their model, the residual over the noise, and the fitted terms."""
    names, values, deviations = found
    count = min(len(images), _MOST)
    bars = max(3.0, 0.42 * len(names))
    figure: Figure = library("matplotlib.pyplot", "plots need", "plot").figure(
        figsize=(max(1.9 * count + bars + 2.2, 7.0), 6.2), layout="constrained"
    )
    parts: Any = figure.subfigures(1, 2, width_ratios=(1.9 * count + 1.2, bars + 1.0))
    pictures, graph = parts
    axes = pictures.subplots(3, count, squeeze=False)
    for k in range(count):
        low, high = np.nanmin(images[k]), np.nanmax(images[k])
        norm = library("matplotlib.colors", "plots need", "plot").PowerNorm(0.5, low, high)
        axes[0, k].imshow(images[k], cmap="magma", norm=norm, interpolation="nearest")
        axes[1, k].imshow(model[k], cmap="magma", norm=norm, interpolation="nearest")
        left = axes[2, k].imshow(residual[k], cmap="RdBu_r", vmin=-_SIGMAS, vmax=_SIGMAS, interpolation="nearest")
        axes[0, k].set_title(f"image {k}", fontsize=9)
    for row, text in zip(axes, ("measured", "model", "residual"), strict=True):
        row[0].set_ylabel(text, fontsize=9)
    for each in axes.flat:
        each.set(xticks=[], yticks=[], facecolor="0.5")  # what was left out
    pictures.colorbar(left, ax=axes[2].tolist(), label="residual (deviations)", shrink=0.9)
    drawn = graph.subplots()
    at = np.arange(len(names))
    finite = [d if np.isfinite(d) else 0.0 for d in deviations]
    drawn.bar(at, values, color="C0", alpha=0.6)
    drawn.errorbar(at, values, yerr=finite, fmt="none", ecolor=drawn.xaxis.label.get_color(), capsize=3)
    drawn.axhline(0.0, color="0.5", linewidth=0.8)
    drawn.set_xticks(at, names, rotation=90, fontsize=8)
    drawn.set_ylabel("coefficient and its deviation (radians)")
    drawn.set_title(title, fontsize=9)
    return figure
