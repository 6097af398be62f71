"""Fig. 4 to 7: the closed form and its error as N, the defocus or the tangent-line centre varies."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from lommel.paper.drawing import V_AXIS, error_norm, intensity_norm, picture_rows
from lommel.paper.setting import VARIANTS, FigureData, Setting, measures, middle_row

if TYPE_CHECKING:
    from matplotlib.colors import Normalize
    from matplotlib.figure import Figure

_NAMES = {"terms": "N", "defocus": "C_d", "tangent": "TLC"}

TERMS = (10, 20, 30, 40)
DEFOCUS = (5.0, 10.0, 20.0, 30.0)
TANGENTS = (100.0, 150.0, 200.0, 250.0)
TANGENT_DEFOCUS, TANGENT_WINDOW = 22.0, 185.0
"""C_d and window of Fig. 7, which the paper leaves out: where its errors come closest, see `numbers`."""


def compute(parameter: str, values: Sequence[float], setting: Setting = Setting()) -> FigureData:  # noqa: B008
    """Compute the closed form, both variants, and its error against the exact PSF.

    Parameters
    ----------
    parameter : {"terms", "defocus", "tangent"}
        What varies.
    values : sequence of float
    setting : Setting
        Everything else.

    Returns
    -------
    FigureData
        For each value k the images ``printed_k``, ``corrected_k``, ``exact_k`` and ``fft_k``, in units of the exact
        peak, and their slices.
    """
    arrays: dict[str, Any] = {"v": setting.v, parameter: np.asarray(values)}
    columns = {"v": setting.v}
    panels: list[dict[str, Any]] = []
    for value in values:
        images = Setting(**setting.facts() | {parameter: value}).images()
        for name, image in images.items():
            arrays[f"{name}_{value:g}"] = image.astype(np.float32)
            columns[f"{name}, {_NAMES[parameter]} = {value:g}"] = middle_row(image)
        panels.append({parameter: value} | measures(images))
    facts = setting.facts() | {"varies": parameter, "panels": panels}
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
    varies, panels = data.facts["varies"], data.facts["panels"]
    rows = [[image(variant, panel[varies]) for panel in panels] for variant in VARIANTS]
    titles = [[f"{_NAMES[varies]} = {one[varies]:g}{measured(one[v])}" for one in panels] for v in VARIANTS]
    scale = norm(max(float(np.abs(values).max()) for row in rows for values in row))
    fixed = ", ".join(f"{name} = {data.facts[key]:g}" for key, name in _NAMES.items() if key != varies)
    heading = f"{heading}, {fixed}; {V_AXIS}"
    return picture_rows(rows, titles, VARIANTS, data.facts["window"], scale, label, heading)
