"""Plots of fitted field maps: terms over the sensor, their standard errors, stars and residuals."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.base.optional import library
from lommel.show.drawing import COLOURS, USER, pyplot

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_ACROSS = 5
_STARS = 5
_SIGMAS = 4.0


def field(
    maps: Sequence[tuple[str, Array, Array]],
    axes: tuple[Array, Array, str],
    stars: tuple[Array, Array, Array, NDArray[np.bool_]],
    images: tuple[Array, Array],
    unit: str,
    title: str,
) -> Figure:
    """Draw terms (name, values and standard errors over the sensor), the stars on it, and some images with models."""
    x, y, length = axes
    across, down, chi2, used = stars
    factor, name = (1e3, "mm") if length == "m" else (1.0, "lambda*N")
    rows = math.ceil((len(maps) + 1) / _ACROSS)
    figure: Figure = pyplot().figure(figsize=(2.6 * _ACROSS + 1.0, 2.7 * rows + 4.6), layout="constrained")
    # So that numbers beside bars are not cut.
    figure.get_layout_engine().set(w_pad=0.15)  # type: ignore[union-attr, call-arg]
    upper, lower = figure.subfigures(2, 1, height_ratios=(2.7 * rows, 4.2))  # type: ignore[misc]
    panels: Any = upper.subplots(rows, _ACROSS, squeeze=False)
    extent = [factor * x[0], factor * x[-1], factor * y[-1], factor * y[0]]
    for panel, (term, values, errors) in zip(panels.flat, maps, strict=False):
        most = max(float(np.abs(values).max()), 1e-12)
        drawn = panel.imshow(values, cmap="RdBu_r", vmin=-most, vmax=most, extent=extent, aspect="equal")
        bar = upper.colorbar(drawn, ax=panel, shrink=0.75)
        bar.ax.tick_params(labelsize=7)
        panel.set_title("\n".join([*_wrapped(term, 22), f"± {np.median(errors):.2g}"]), fontsize=8)
        panel.set(xticks=[], yticks=[])
    panel = panels.flat[len(maps)]
    shown = panel.scatter(
        factor * across[used], factor * down[used], c=chi2[used], s=14, cmap=COLOURS, vmin=0.8, vmax=1.4
    )
    if not used.all():
        panel.plot(factor * across[~used], factor * down[~used], "x", color="C3", markersize=6)
    panel.set(xlim=extent[:2], ylim=extent[2:], aspect="equal")
    panel.set_xlabel(f"x ({name})", fontsize=8)
    panel.set_ylabel(f"y ({name})", fontsize=8)
    panel.tick_params(labelsize=7)
    panel.set_title("stars, chi2" + ("" if used.all() else "\ncrosses: rejected"), fontsize=8)
    upper.colorbar(shown, ax=panel, shrink=0.75).ax.tick_params(labelsize=7)
    for rest in panels.flat[len(maps) + 1 :]:
        rest.remove()
    upper.suptitle(f"Zernike terms over the sensor ({unit} rms), ± median standard error", fontsize=10)
    _stars(lower, images, (across, down, used))
    figure.suptitle("\n".join(_wrapped(title, 130)), fontsize=9)
    return figure


def _stars(part: Any, images: tuple[Array, Array], stars: tuple[Array, Array, NDArray[np.bool_]]) -> None:
    """Draw images, models and residuals of a star in the middle and of those nearest to the corners."""
    seen, model = images
    across, down, used = stars
    at = np.flatnonzero(used)
    wide, high = max(float(np.ptp(across)), 1e-300), max(float(np.ptp(down)), 1e-300)
    spots = [(across.min(), down.min()), (across.max(), down.min()), (np.median(across), np.median(down)),
             (across.min(), down.max()), (across.max(), down.max())]  # fmt: skip
    names = ("top left", "top right", "middle", "bottom left", "bottom right")
    panels = part.subplots(3, _STARS, squeeze=False)
    norm = library("matplotlib.colors", *USER).PowerNorm
    for column, ((u, v), name) in enumerate(zip(spots, names, strict=True)):
        k = at[np.argmin(((across[at] - u) / wide) ** 2 + ((down[at] - v) / high) ** 2)]
        image, fit = seen[k, 0], model[k, 0]
        low, top = np.nanmin(image), np.nanmax(image)
        scale = norm(0.5, low, top)
        panels[0, column].imshow(image, cmap=COLOURS, norm=scale, interpolation="nearest")
        panels[1, column].imshow(fit, cmap=COLOURS, norm=scale, interpolation="nearest")
        noise = np.sqrt(np.maximum(fit, 1.0))
        left = panels[2, column].imshow(
            (image - fit) / noise, cmap="RdBu_r", vmin=-_SIGMAS, vmax=_SIGMAS, interpolation="nearest"
        )
        panels[0, column].set_title(name, fontsize=8)
    for row, text in zip(panels, ("measured", "model", "residual"), strict=True):
        row[0].set_ylabel(text, fontsize=8)
    for panel in panels.flat:
        panel.set(xticks=[], yticks=[], facecolor="0.5")
    part.colorbar(left, ax=panels.ravel().tolist(), label="residual over photon noise", shrink=0.6)


def _wrapped(text: str, width: int) -> list[str]:
    import textwrap

    return textwrap.wrap(text, width)
