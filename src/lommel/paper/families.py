"""Fig. 3 to 7: the closed form beside the FFT, and its error over N, the defocus and the tangent-line centre."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from lommel.paper.drawing import (
    COLORS,
    LABELS,
    V_AXIS,
    error_norm,
    intensity_norm,
    new_figure,
    panels,
    picture,
    picture_rows,
)
from lommel.paper.setting import VARIANTS, Arrays, Facts, FigureData, Setting, measures, middle_row

if TYPE_CHECKING:
    from matplotlib.colors import Normalize
    from matplotlib.figure import Figure

_NAMES = {"terms": "N", "defocus": "C_d", "tangent": "TLC"}

TERMS = (10, 20, 30, 40)
DEFOCUS = (5.0, 10.0, 20.0, 30.0)
TANGENTS = (100.0, 150.0, 200.0, 250.0)
TANGENT_DEFOCUS, TANGENT_WINDOW = 22.0, 185.0
"""C_d and window of Fig. 7, which the paper leaves out: where its errors come closest, see `numbers`."""


def compare_with_fft(setting: Setting = Setting()) -> FigureData:  # noqa: B008 (frozen)
    """Compute one PSF by the FFT, by both variants of the closed form, and exactly; 1 is the exact peak."""
    images = setting.images()
    facts = setting.facts() | measures(images)
    facts["fft"]["method"] = repr(setting.fft())
    columns = {"v": setting.v} | {name: middle_row(image) for name, image in images.items()}
    arrays = {name: image.astype(np.float32) for name, image in images.items()} | {"v": setting.v}
    return FigureData("PSF comparison between FFT and CFIS", arrays, columns, facts)


def draw_comparison(data: FigureData) -> Figure:
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


def compute(parameter: str, values: Sequence[float], setting: Setting = Setting()) -> FigureData:  # noqa: B008
    """Compute the closed form in both variants, the FFT and the exact PSF while one parameter varies."""
    arrays: Arrays = {"v": setting.v, parameter: np.asarray(values)}
    columns = {"v": setting.v}
    found: list[Facts] = []
    for value in values:
        images = Setting(**setting.facts() | {parameter: value}).images()
        for name, image in images.items():
            arrays[f"{name}_{value:g}"] = image.astype(np.float32)
            columns[f"{name}, {_NAMES[parameter]} = {value:g}"] = middle_row(image)
        found.append({parameter: value} | measures(images))
    facts = setting.facts() | {"varies": parameter, "panels": found}
    return FigureData(f"CFIS for varying {_NAMES[parameter]}", arrays, columns, facts)


def by_terms(setting: Setting = Setting()) -> FigureData:  # noqa: B008
    """Return the data of Fig. 4 and 5."""
    return compute("terms", TERMS, setting)


def by_defocus(setting: Setting = Setting()) -> FigureData:  # noqa: B008
    """Return the data of Fig. 6."""
    return compute("defocus", DEFOCUS, setting)


def by_tangent(setting: Setting = Setting()) -> FigureData:  # noqa: B008
    """Return the data of Fig. 7."""
    return compute("tangent", TANGENTS, replace(setting, defocus=TANGENT_DEFOCUS, window=TANGENT_WINDOW))


def draw_intensity(data: FigureData) -> Figure:
    """Draw the images of both variants, with one scale."""

    def image(variant: str, value: float) -> Any:
        return data.arrays[f"{variant}_{value:g}"]

    return _draw(data, image, lambda _: "", intensity_norm, "intensity / exact peak", "CFIS")


def draw_error(data: FigureData) -> Figure:
    """Draw the errors of both variants, with one scale."""

    def image(variant: str, value: float) -> Any:
        return data.arrays[f"{variant}_{value:g}"] - data.arrays[f"exact_{value:g}"]

    def measured(found: dict[str, float]) -> str:
        return f": MSE {found['mse']:.3g}\nlargest {found['peak_error']:.2f}"

    return _draw(data, image, measured, error_norm, "error / exact peak", "CFIS less the exact PSF")


def _draw(
    data: FigureData,
    image: Callable[[str, float], Any],
    measured: Callable[[dict[str, float]], str],
    norm: Callable[[float], Normalize],
    label: str,
    heading: str,
) -> Figure:
    """Draw an image of each variant and value, and name the parameters that do not vary."""
    varies, cases = data.facts["varies"], data.facts["panels"]
    rows = [[image(variant, panel[varies]) for panel in cases] for variant in VARIANTS]
    titles = [[f"{_NAMES[varies]} = {one[varies]:g}{measured(one[v])}" for one in cases] for v in VARIANTS]
    scale = norm(max(float(np.abs(values).max()) for row in rows for values in row))
    fixed = ", ".join(f"{name} = {data.facts[key]:g}" for key, name in _NAMES.items() if key != varies)
    heading = f"{heading}, {fixed}; {V_AXIS}"
    return picture_rows(rows, titles, VARIANTS, data.facts["window"], scale, label, heading)
