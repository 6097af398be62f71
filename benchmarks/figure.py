"""Cost against the side of the window and against all else, log-log."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

_COLORS = {
    "lommel": "#c1121f",
    "FFT, alone": "#8d99ae",
    "FFT, whole method": "#2b2d42",
    "quadrature": "#2a9d8f",
    "closed form, Fresnel": "#e9a23b",
    "closed form, Abramowitz 30": "#b5651d",
    "ray tracing": "#7b2cbf",
}


def draw(sizes: dict[str, Any], path: Path) -> None:
    """Draw the table of sizes, as it stands in the JSON file."""
    from matplotlib.figure import Figure

    curves: dict[str, list[tuple[int, float]]] = {}
    for row in sizes["rows"]:
        curves.setdefault(row["way"], []).append((int(row["n"]), row["cost"]["median"]))
    figure = Figure(figsize=(8.0, 5.2), layout="constrained")
    axes = figure.add_subplot()
    for name, color in _COLORS.items():
        if name not in curves:
            continue
        n, cost = np.array(curves[name]).T
        axes.loglog(n, cost, "o-", color=color, label=name, linewidth=2.4 if name == "lommel" else 1.5, markersize=4)
    if "lommel" in curves and "FFT, alone" in curves:
        # Anchored where neither calls nor memory dominate.
        n, cost = np.array(curves["lommel"]).T
        at = np.searchsorted(n, 1024, side="right") - 1
        axes.loglog(n, cost[at] * (n / n[at]) ** 2, ":", color="#c1121f", linewidth=1, label="n²")
        n, cost = np.array(curves["FFT, alone"]).T
        slope = n**2 * np.log2(2 * n)
        at = np.searchsorted(n, 1024, side="right") - 1
        axes.loglog(n, cost[at] * slope / slope[at], ":", color="#8d99ae", linewidth=1, label="n² log n")
    axes.set_xlabel("side n of the window, pixels")
    axes.set_ylabel("cost of one PSF, in FFTs of 1024²")
    axes.set_title("One thread, C_d = 10")
    axes.grid(which="both", linewidth=0.3)
    sides = sorted({n for curve in curves.values() for n, _ in curve})
    axes.set_xticks(sides, [str(n) for n in sides])
    axes.minorticks_off()
    axes.legend(fontsize=8)
    figure.savefig(path, dpi=130, metadata={"Software": None})


def draw_costs(costs: dict[str, Any], path: Path) -> None:
    """Draw the table of costs of a pixel, as it stands in the JSON file: a panel for each that they are against."""
    from matplotlib.figure import Figure

    panels: dict[str, dict[str, list[tuple[float, float]]]] = {}
    for row in costs["rows"]:
        curves = panels.setdefault(row["against"], {})
        curves.setdefault(row["pupil"], []).append((float(row["at"]), row["cost"]["median"]))
    figure = Figure(figsize=(9.0, 8.6), layout="constrained")
    for k, (against, curves) in enumerate(panels.items()):
        axes = figure.add_subplot(3, 2, k + 1)
        for (name, curve), color in zip(curves.items(), ("#c1121f", "#2b2d42"), strict=False):
            x, y = np.array(curve).T
            axes.loglog(x, y, "o-", color=color, label=name, markersize=4)
        if against.startswith("tolerance"):
            axes.invert_xaxis()
        axes.set_xlabel(against)
        axes.set_ylabel("cost of a pixel, in np.abs")
        axes.grid(which="both", linewidth=0.3)
        axes.legend(fontsize=8)
    figure.savefig(path, dpi=120, metadata={"Software": None})
