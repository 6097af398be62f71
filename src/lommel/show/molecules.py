"""Pictures of localised molecules: Gaussians of their standard deviations, coloured by z."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from lommel.base.arrays import Array
from lommel.base.optional import library
from lommel.show.drawing import USER, new_axes

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_COLOURS = "turbo"
_MOST, _USUAL = 4096, 800  # pixels of a side
_LEAST = 5e-9
_WIDTHS = 2.0 ** (0.5 * np.arange(-1, 13))  # pixels, of the Gaussians that are drawn together, and at least
_AXES = {"z": "stage position z (um)", "depth": "depth (um)"}


def picture(
    rows: NDArray[np.void], size: tuple[float, float], pixel: float | None, along: str, ax: Axes | None
) -> Axes:
    """Draw molecules in a field of a height and width (metres in the sample), by pixels of about this pitch."""
    axes = new_axes(ax, figsize=(6.4, 5.6))
    side = max(_LEAST, max(size) / _USUAL) if pixel is None else max(pixel, max(size) / _MOST)
    flat = along == "none"
    heights = np.zeros(rows.size) if flat else 1e6 * rows["z"]
    low, high = np.percentile(heights, [1.0, 99.0]) if rows.size else (0.0, 1.0)
    map_ = library("matplotlib.cm", *USER).ScalarMappable(cmap=_COLOURS)
    map_.set_clim(low, max(high, low + 1e-3))
    extent = (0.0, 1e6 * size[1], 1e6 * size[0], 0.0)
    colours = np.ones((rows.size, 3)) if flat or not rows.size else map_.to_rgba(heights)[:, :3]
    axes.imshow(rendered(rows, size, side, colours), extent=extent, interpolation="antialiased")
    figure: Any = axes.get_figure(root=True)
    if not flat:
        figure.colorbar(map_, ax=axes, label=_AXES[along], extend="both", shrink=0.85)
    axes.set(xlabel="x (um)", ylabel="y (um)", title=f"{rows.size} localisations, pixels of {1e9 * side:.3g} nm")
    return axes


def rendered(rows: NDArray[np.void], size: tuple[float, float], side: float, colours: Array) -> Array:
    """Return red, green and blue, 0 to 1, of molecules in these colours, on black."""
    height, width = (max(1, math.ceil(one / side - 1e-9)) for one in size)
    light = np.zeros((4, height, width))
    down, across = (np.floor(rows[name] / side).astype(int) for name in ("y", "x"))
    inside = (down >= 0) & (down < height) & (across >= 0) & (across < width)
    spread = np.sqrt(0.5 * (rows["x_error"] ** 2 + rows["y_error"] ** 2)) / side
    nearest = np.abs(np.log(_WIDTHS) - np.log(np.maximum(spread, 1e-6))[:, None]).argmin(axis=1)
    for k in np.unique(nearest[inside]):
        mine = inside & (nearest == k)
        place = down[mine] * width + across[mine]
        for channel, weights in enumerate((None, *colours[mine].T)):
            sums = np.bincount(place, weights, height * width).astype(float).reshape(height, width)
            light[channel] += ndimage.gaussian_filter(sums, _WIDTHS[k], mode="constant")
    amount = light[0]
    lit = amount[amount > 1e-3 * amount.max(initial=0.0)]
    top = float(np.percentile(lit, 99.0)) if lit.size else 1.0
    brightness = np.clip(amount / top, 0.0, 1.0) ** 0.5
    colour = np.divide(light[1:], amount, out=np.zeros_like(light[1:]), where=amount > 0.0)
    return np.ascontiguousarray(np.moveaxis(np.clip(colour * brightness, 0.0, 1.0), 0, -1))
