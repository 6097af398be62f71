"""Where rays meet the sensor, over the light that is there."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from lommel.base import validation
from lommel.measures import rays as measured
from lommel.measures.answer import Answer, checked
from lommel.measures.aperture_means import spot_radius
from lommel.optics.pupil import Pupil
from lommel.show.drawing import lengths
from lommel.show.plot import plot

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def spots(psf: Answer, ax: Axes | None = None, *, rings: int = 12, stretch: str = "sqrt") -> Any:
    """Draw where rays meet the sensor over a PSF, and the Airy circle of the aperture about the axis.

    Parameters
    ----------
    psf : PSF
        A single one, of a lens.
    ax : matplotlib Axes, optional
        By default those of a new figure, which has a bar and a title with the rms radius of the rays,
        :func:`lommel.spot_radius`.
    rings : int, default 12
        Of rays; see :func:`lommel.measures.rays.spots`.
    stretch : {"sqrt", "linear", "log"}
        Of the PSF.

    Returns
    -------
    matplotlib Axes

    Raises
    ------
    TypeError, ValueError
        If it is a stack or of an objective, or an argument is out of range.
    ImportError
        If matplotlib is not installed.
    """
    pupil = checked(psf, "psf").pupil
    if not isinstance(pupil, Pupil):
        raise ValueError("psf must be that of a lens for a spot diagram, got that of an Objective")
    if pupil.shape != ():
        raise ValueError(f"psf must be a single one for a spot diagram, got a stack of shape {pupil.shape}; index it")
    validation.axes("ax", ax)
    factor, unit = lengths(psf.unit)
    x, y = measured.spots(pupil, rings).T * factor
    axes = plot(psf, ax, stretch=stretch)
    limits = axes.get_xlim(), axes.get_ylim()
    axes.scatter(x, y, s=4.0, color="deepskyblue", linewidths=0.0, label=f"{x.size} rays")
    angle = np.linspace(0.0, 2.0 * np.pi, 181)
    airy = pupil.airy_radius * factor
    axes.plot(airy * np.cos(angle), airy * np.sin(angle), "--", color="lime", linewidth=1.0, label="Airy circle")
    axes.set_xlim(*limits[0])
    axes.set_ylim(*limits[1])
    axes.legend(fontsize=7, loc="upper right")
    if ax is None:
        low, high = sorted(limits[1])
        outside = int(np.sum((np.abs(x - np.mean(limits[0])) > 0.5 * np.ptp(limits[0])) | (y < low) | (y > high)))
        beyond = f", {outside} of them beyond the window" if outside else ""
        radius = float(spot_radius(pupil)) * factor
        axes.set_title(f"rays: rms radius {radius:.3g} {unit}{beyond}; Airy radius {airy:.3g} {unit}", fontsize=9)
    return axes
