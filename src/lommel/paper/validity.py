"""Beyond the paper: validity of the closed forms over C_d and v."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from lommel.methods import ClosedForm, RadialMethod, TunedClosedForm
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.paper.drawing import V_AXIS, new_figure
from lommel.paper.setting import REFERENCE, Arrays, FigureData
from lommel.special.erf import AbramowitzErf

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_FORMS: dict[str, RadialMethod] = {
    "printed": ClosedForm(tangent=100.0, erf=AbramowitzErf(30), variant="printed"),
    "corrected": ClosedForm(tangent=100.0, erf=AbramowitzErf(30)),
    "corrected, exact erf": ClosedForm(tangent=100.0),
    "tuned to 1e-4": TunedClosedForm(1e-4),
}


def compute(count: int = 61, radii: int = 301) -> FigureData:
    """Compute the error of the forms, over the peak of each PSF, for C_d from 0 to 60 and v from 0 to 300."""
    defocus, v = np.linspace(0.0, 60.0, count), np.linspace(0.0, 300.0, radii)
    pupil = Pupil(Wavefront(defocus))
    exact = REFERENCE.profile(pupil, v).values
    peak = exact.max(axis=1, keepdims=True)
    arrays: Arrays = {"defocus": defocus, "v": v}
    columns: Arrays = {"C_d": defocus}
    largest = {}
    for name, method in _FORMS.items():
        error = np.abs(method.profile(pupil, v).values - exact) / peak
        arrays[name] = error
        columns[f"largest error, {name}"] = error.max(axis=1)
        largest[name] = float(error.max())
    facts = {"tangent": 100.0, "terms": 30, "largest": largest}
    return FigureData("Where the closed forms hold", arrays, columns, facts)


def draw(data: FigureData) -> Figure:
    """Draw the error of each form over C_d and v, with the edge of the geometric shadow."""
    from matplotlib.colors import LogNorm

    figure = new_figure(2.9 * len(_FORMS) + 1.2, 4.2)
    grid: Any = figure.subplots(1, len(_FORMS), sharex=True, sharey=True)
    defocus, v = data.arrays["defocus"], data.arrays["v"]
    drawn: Any = None
    for axes, name in zip(grid, _FORMS, strict=True):
        error = np.maximum(data.arrays[name], 1e-9)
        drawn = axes.pcolormesh(defocus, v, error.T, norm=LogNorm(1e-9, 1.0), cmap="viridis", shading="nearest")
        axes.plot(defocus, 4.0 * defocus, "w--", linewidth=1.0)
        axes.set_title(f"{name}\nlargest {data.facts['largest'][name]:.2g}", fontsize=10)
        axes.set_xlabel("C_d (rad)")
        axes.set_ylim(0.0, float(v[-1]))
    grid[0].set_ylabel(V_AXIS)
    grid[0].text(33.0, 112.0, "v = 4 C_d", color="white", fontsize=8)
    figure.colorbar(drawn, ax=grid, label="|I − I exact| / peak of each PSF")
    return figure
