"""Fig. 3: the closed form beside the FFT, as images and along a slice."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from lommel.paper.drawing import COLORS, LABELS, V_AXIS, intensity_norm, new_figure, panels, picture
from lommel.paper.setting import FigureData, Setting, measures, middle_row

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def compute(setting: Setting = Setting()) -> FigureData:  # noqa: B008 (frozen)
    """Compute one PSF by the FFT, by both variants of the closed form, and exactly; 1 is the exact peak."""
    images = setting.images()
    facts = setting.facts() | measures(images)
    facts["fft"]["method"] = repr(setting.fft())
    columns = {"v": setting.v} | {name: middle_row(image) for name, image in images.items()}
    arrays = {name: image.astype(np.float32) for name, image in images.items()} | {"v": setting.v}
    return FigureData("PSF comparison between FFT and CFIS", arrays, columns, facts)


def draw(data: FigureData) -> Figure:
    """Draw the four images with one scale, and below them their slices and errors."""
    figure = new_figure(11.0, 7.0)
    facts = data.facts
    figure.suptitle(
        f"C_d = {facts['defocus']:g}, TLC = {facts['tangent']:g}, N = {facts['terms']}; 1 is the exact peak",
        fontsize=10,
    )
    halves: Any = figure.subfigures(2, 1, height_ratios=(1.0, 1.15))
    pictures: Any = halves[0].subplots(1, 4, sharey=True)
    norm = intensity_norm(max(float(data.arrays[name].max()) for name in LABELS))
    drawn = None
    for axes, (name, label) in zip(pictures, LABELS.items(), strict=True):
        title = label if name == "exact" else f"{label}\nMSE {facts[name]['mse']:.3g}"
        drawn = picture(axes, data.arrays[name], facts["window"], norm, title)
        axes.set_xlabel("v along x", fontsize=8)
    pictures[0].set_ylabel("v along y", fontsize=8)
    halves[0].colorbar(drawn, ax=pictures, shrink=0.8, label="intensity / peak")
    slices, errors = panels(halves[1], 2, xlabel=V_AXIS, xlim=(0.0, float(data.columns["v"][-1])))
    c = data.columns
    for name, label in LABELS.items():
        slices.plot(c["v"], c[name], color=COLORS[name], linewidth=2.5 if name == "exact" else 1.2, label=label)
        if name != "exact":
            errors.plot(c["v"], c[name] - c["exact"], color=COLORS[name], linewidth=1.2, label=label)
    slices.set_ylabel("intensity / peak")
    slices.legend(fontsize=7)
    errors.set_ylabel("error / peak, along the slice")
    return figure
