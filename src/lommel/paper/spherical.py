"""Eq. (17): a quartic phase as a few quadratics."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from lommel.paper.drawing import new_figure, panels
from lommel.paper.setting import Arrays, FigureData
from lommel.special.piecewise import SPLITS, PiecewiseQuadratic, fit_quadratics

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SPHERICAL = 10.0
PIECES = 5
_COLORS = {"linear": "tab:red", "sqrt": "tab:orange", "log": "tab:green", "optimal": "tab:blue"}


def as_printed(spherical: float, pieces: int = PIECES, split: str = "linear") -> PiecewiseQuadratic:
    """Return the fit of Eq. (17) as it is printed: without a constant, its least squares found and not swept."""
    return fit_quadratics((0.0, spherical), pieces, split=split, fit="least-squares", piston=False)


def as_corrected(spherical: float, pieces: int = PIECES, split: str = "optimal") -> PiecewiseQuadratic:
    """Return the fit with the constant gamma_i that Eq. (17) leaves out."""
    return fit_quadratics((0.0, spherical), pieces, split=split, fit="least-squares", piston=True)


FITS = {"printed": as_printed, "corrected": as_corrected}


def compute(samples: int = 1000, most: int = 12, spherical: float = SPHERICAL) -> FigureData:
    """Fit exp(i C_s rho^4) with five quadratics, and with 1 to `most`, in every split, with and without constants."""
    rho = (np.arange(samples) + 0.5) / samples
    phase = spherical * rho**4
    fits = {kind: make(spherical) for kind, make in FITS.items()}
    columns: Arrays = {"rho": rho, "phase": phase}
    for name, fit in fits.items():
        columns[f"{name} fit"] = fit.phase(rho)
        columns[f"{name} error"] = np.abs(np.exp(1j * fit.phase(rho)) - np.exp(1j * phase))
    counts = np.arange(1, most + 1)
    mse = {
        (split, kind): np.array([make(spherical, int(n), split).mse((0.0, spherical)) for n in counts])
        for split in SPLITS
        for kind, make in FITS.items()
    }
    arrays = dict(columns) | {"pieces": counts}
    arrays |= {f"mse_{split}_{kind}": values for (split, kind), values in mse.items()}
    for name, fit in fits.items():
        arrays |= {f"{name}_{part}": getattr(fit, part) for part in ("edges", "alpha", "beta", "gamma")}
    facts = {
        "defocus": 0.0,
        "spherical": spherical,
        "pieces": PIECES,
        "printed": {"split": "linear", "constant": False, "mse": fits["printed"].mse((0.0, spherical))},
        "corrected": {"split": "optimal", "constant": True, "mse": fits["corrected"].mse((0.0, spherical))},
    }
    return FigureData("Piecewise quadratic phase", arrays, columns, facts)


def draw(data: FigureData) -> Figure:
    """Draw the phase and its pieces, the error of both fits, and the mean squared error against their number."""
    figure = new_figure(13.0, 4.2)
    left, middle, right = panels(figure, 3, xlabel="ρ = R / R_max")
    a, facts = data.arrays, data.facts
    left.plot(a["rho"], a["phase"], color="black", linewidth=4.0, alpha=0.3, label=f"{facts['spherical']:g} ρ⁴")
    edges = a["printed_edges"]
    for i in range(facts["pieces"]):
        inside = (a["rho"] >= edges[i]) & (a["rho"] < edges[i + 1])
        # Whole turns change nothing; each piece is drawn where the phase is.
        turns = np.round(np.mean(a["printed fit"][inside] - a["phase"][inside]) / (2.0 * np.pi))
        left.plot(a["rho"][inside], a["printed fit"][inside] - 2.0 * np.pi * turns, linewidth=1.6,
                  label=f"{a['printed_alpha'][i]:.2f} ρ² {a['printed_beta'][i]:+.2f} ρ")  # fmt: skip
    left.set_ylabel("phase (rad), less whole turns")
    left.legend(fontsize=7, title="as printed, linear split", title_fontsize=7)
    for name, color in (("printed", "tab:red"), ("corrected", "tab:blue")):
        split = "linear split, no constant" if name == "printed" else "optimal split, constants γ"
        middle.semilogy(a["rho"], np.maximum(a[f"{name} error"], 1e-6), color=color, linewidth=1.2,
                        label=f"{name}: {split}\nMSE {facts[name]['mse']:.3g}")  # fmt: skip
    middle.set(ylabel="|exp(i fit) − exp(i phase)|", ylim=(1e-5, 1.0))
    middle.legend(fontsize=7)
    for split in SPLITS:
        for kind, line in (("printed", "--"), ("corrected", "-")):
            right.semilogy(a["pieces"], a[f"mse_{split}_{kind}"], line, marker=".", color=_COLORS[split],
                           label=f"{split}{', no constant' if kind == 'printed' else ''}")  # fmt: skip
    right.axhline(1.37e-4, color="grey", linewidth=0.9, linestyle=":")
    right.annotate("paper: 0.000137 with 5", (8.0, 1.6e-4), fontsize=7, color="grey")
    right.set(xlabel="pieces", ylabel="MSE of the pupil function")
    right.legend(fontsize=7, ncols=2)
    figure.suptitle(f"exp(i C_s ρ⁴) by quadratics on segments (Eq. 17), C_s = {facts['spherical']:g}", fontsize=10)
    return figure
