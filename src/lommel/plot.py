"""Pictures of PSFs; matplotlib is imported when the first is asked for."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from lommel import validation

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from lommel.psf import PSF

_FLOOR = 1e-5  # of the peak: the bottom of logarithmic scales


def plot(psf: PSF, ax: Axes | None = None, *, stretch: str = "sqrt") -> Axes:
    """Draw a single PSF.

    Parameters
    ----------
    psf : PSF
    ax : matplotlib Axes, optional
        By default those of a new figure.
    stretch : {"sqrt", "linear", "log"}
        Of the grey levels; "log" goes down to 1e-5 of the peak.
    """
    from matplotlib.colors import LogNorm, Normalize, PowerNorm

    _single(psf)
    validation.choice("stretch", stretch, ("sqrt", "linear", "log"))
    axes = _axes(ax)
    peak = float(psf.values.max()) or 1.0
    norms: dict[str, Normalize] = {
        "sqrt": PowerNorm(0.5, 0.0, peak),
        "linear": Normalize(0.0, peak),
        "log": LogNorm(_FLOOR * peak, peak, clip=True),
    }
    factor, unit = _scale(psf)
    height, width = psf.shape
    half = 0.5 * psf.pixel * factor
    x, y = psf.grid.x * factor, psf.grid.y * factor
    extent = (x[0] - half, x[-1] + half, y[-1] + half, y[0] - half)
    interpolation = "nearest" if max(height, width) < 256 else "antialiased"
    axes.imshow(psf.values, extent=extent, cmap="magma", norm=norms[stretch], interpolation=interpolation)
    axes.set_xlabel(f"x ({unit})")
    axes.set_ylabel(f"y ({unit})")
    return axes


def compare(answers: Mapping[str, PSF], reference: str) -> Figure:
    """Draw several PSFs of one lens side by side, above the slices through their centres.

    Parameters
    ----------
    answers : mapping of str to PSF
        Each with the same grid; drawn in their order.
    reference : str
        The one that the errors are taken from.
    """
    from matplotlib.figure import Figure as NewFigure

    if reference not in answers:
        raise ValueError(f"reference must be one of {', '.join(answers)}, got {reference!r}")
    columns = max(len(answers), 3)
    figure = NewFigure(figsize=(2.2 * columns, 7.2), layout="constrained")
    parts: Any = figure.subfigures(2, 1, height_ratios=(1.0, 1.6))
    pictures, graphs = parts
    for k, (name, psf) in enumerate(answers.items()):
        axes = pictures.add_subplot(1, columns, k + 1)
        plot(psf, axes)
        axes.set_title(name, fontsize=10)
        axes.tick_params(labelsize=7)
        axes.xaxis.label.set_fontsize(8)
        if k:
            axes.set_ylabel("")
            axes.set_yticklabels([])
        else:
            axes.yaxis.label.set_fontsize(8)
    truth = answers[reference]
    factor, unit = _scale(truth)
    slices, errors = graphs.subplots(1, 2)
    radius, expected = truth.profile()
    peak = float(truth.values.max())
    for k, (name, psf) in enumerate(answers.items()):
        values = psf.profile()[1] / peak
        width = 3.2 if name == reference else 1.3
        slices.plot(radius * factor, values, label=name, color=f"C{k}", linewidth=width, zorder=1 if k == 0 else 2)
        if name != reference:
            difference = np.abs(values - expected / peak)
            errors.semilogy(radius * factor, np.maximum(difference, 1e-17), color=f"C{k}", linewidth=1.3)
    slices.set_ylabel("intensity / peak of the reference")
    slices.legend(fontsize=8)
    errors.set_ylabel(f"error against {reference} / peak")
    errors.set_ylim(1e-17, 3.0)
    errors.grid(alpha=0.3)
    for axes in (slices, errors):
        axes.set_xlabel(f"distance from the centre ({unit})")
        axes.set_xlim(0.0, max(float(radius[-1]), 0.5 * truth.pixel) * factor)
    return figure


def _axes(ax: Axes | None) -> Axes:
    if ax is not None:
        return ax
    import matplotlib.pyplot as plt

    return plt.subplots(layout="constrained")[1]


def _scale(psf: PSF) -> tuple[float, str]:
    return (1e6, "µm") if psf.unit == "m" else (1.0, "λN")


def _single(psf: PSF) -> None:
    if psf.values.ndim != 2:
        raise ValueError(f"a single PSF can be drawn, got a stack of shape {psf.shape}")
