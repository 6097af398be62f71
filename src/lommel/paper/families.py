"""Fig. 4 to 7: the closed form and its error as N, the defocus or the tangent-line centre varies."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from lommel.paper.drawing import error_norm, intensity_norm, picture_rows
from lommel.paper.setting import VARIANTS, FigureData, Setting, measures, middle_row

if TYPE_CHECKING:
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
    varies = data.facts["varies"]
    rows = [[data.arrays[f"{variant}_{value:g}"] for value in data.arrays[varies]] for variant in VARIANTS]
    titles = [[f"{_NAMES[varies]} = {value:g}" for value in data.arrays[varies]] for _ in VARIANTS]
    norm = intensity_norm(max(float(image.max()) for row in rows for image in row))
    heading = f"CFIS, {_fixed(data)}"
    return picture_rows(rows, titles, VARIANTS, data.facts["window"], norm, "intensity / exact peak", heading)


def draw_error(data: FigureData) -> Figure:
    """Draw the errors of both variants, with one scale."""
    varies = data.facts["varies"]
    values = data.arrays[varies]
    rows = [
        [data.arrays[f"{variant}_{value:g}"] - data.arrays[f"exact_{value:g}"] for value in values]
        for variant in VARIANTS
    ]
    titles = [
        [
            f"{_NAMES[varies]} = {panel[varies]:g}: MSE {panel[variant]['mse']:.3g}\n"
            f"largest {panel[variant]['peak_error']:.2f}"
            for panel in data.facts["panels"]
        ]
        for variant in VARIANTS
    ]
    norm = error_norm(max(float(np.abs(error).max()) for row in rows for error in row))
    heading = f"CFIS less the exact PSF, {_fixed(data)}"
    return picture_rows(rows, titles, VARIANTS, data.facts["window"], norm, "error / exact peak", heading)


def _fixed(data: FigureData) -> str:
    """Name the parameters that do not vary."""
    rest = {key: data.facts[key] for key in _NAMES if key != data.facts["varies"]}
    return ", ".join(f"{_NAMES[key]} = {value:g}" for key, value in rest.items()) + "; v = πr/(λN)"
