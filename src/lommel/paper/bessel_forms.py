"""Fig. 2: approximations of J0 in the closed form, and their errors."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from lommel.paper.drawing import new_figure, panels
from lommel.paper.setting import FigureData
from lommel.special.bessel import j0_asymptotic, j0_series, tangent_line

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_FORMS = {
    "series": ("Eq. (6), three terms", "tab:orange", "--"),
    "asymptotic": ("Eq. (7)", "tab:green", "--"),
    "piecewise": ("Eq. (8)", "tab:purple", "-"),
    "printed": ("Eq. (12) as printed, TLC = 100", "tab:red", "-"),
    "corrected": ("Eq. (12) with √(2/π), TLC = 100", "tab:blue", "-"),
}


def compute(samples: int = 2001, far: float = 200.0, tangent: float = 100.0) -> FigureData:
    """Evaluate J0 and its approximations at arguments a from 0.05 to `far`, evenly spaced in log a.

    "printed" and "corrected" are what Eq. (12) has in the place of J0: the three terms of (6) up to a = 1, beyond it
    (7) with (9) for the square root, without and with the factor sqrt(2/pi).
    """
    from scipy.special import j0

    a = np.geomspace(0.05, far, samples)
    slope, level = tangent_line(tangent)
    series, asymptotic = j0_series(a, 3), j0_asymptotic(a)
    outer = (slope * a + level + 1.0 / a) * np.cos(a - 0.25 * math.pi)
    near = a <= 1.0
    columns = {
        "a": a,
        "J0": np.asarray(j0(a)),
        "series": series,
        "asymptotic": asymptotic,
        "piecewise": np.where(near, series, asymptotic),
        "printed": np.where(near, series, outer),
        "corrected": np.where(near, series, math.sqrt(2.0 / math.pi) * outer),
    }
    columns |= {f"error of {name}": columns[name] - columns["J0"] for name in _FORMS}
    facts = {
        "tangent": tangent,
        "transition": 1.0,
        "largest_errors": {name: float(np.abs(columns[f"error of {name}"]).max()) for name in _FORMS},
    }
    return FigureData("Comparison of various forms of J0(a)", dict(columns), columns, facts)


def draw(data: FigureData) -> Figure:
    """Draw the forms up to a = 15, and their errors over the whole range."""
    figure = new_figure(10.5, 4.2)
    left, right = panels(figure, 2, xlabel="a = 2πkR")
    c = data.columns
    left.plot(c["a"], c["J0"], color="black", linewidth=3.0, alpha=0.35, label="J0(a)")
    for name, (label, color, line) in _FORMS.items():
        left.plot(c["a"], c[name], line, color=color, linewidth=1.2, label=label)
        right.loglog(c["a"], np.maximum(np.abs(c[f"error of {name}"]), 1e-17), line, color=color, linewidth=1.0)
    left.set(xlim=(0.0, 15.0), ylim=(-0.75, 1.25), ylabel="J0(a) and its approximations")
    left.legend(fontsize=7)
    right.set(xlim=(float(c["a"][0]), float(c["a"][-1])), ylim=(1e-7, 3.0), ylabel="absolute error")
    for axes in (left, right):
        axes.axvline(1.0, color="grey", linewidth=0.8, linestyle=":")
    left.set_title("forms of J0; dotted: the transition a = 1", fontsize=10)
    right.set_title("their errors", fontsize=10)
    return figure
