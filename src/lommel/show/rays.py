"""Spot diagrams: ray intersections with the sensor, over the PSF."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.measures.aperture_means import slopes, spot_radius
from lommel.measures.psf_like import PSFLike, checked
from lommel.optics.pupil import Pupil
from lommel.optics.pupil import checked as checked_pupil
from lommel.show.drawing import circle, lengths
from lommel.show.plot import plot

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def ray_positions(pupil: Pupil, rings: int = 12) -> Array:
    """Return the positions at which rays from rings of points of the clear aperture meet the sensor.

    Parameters
    ----------
    pupil : Pupil
        A single one.
    rings : int, default 12
        Number of rings of points about the axis, 1 to 100, at equal distances and with six more points on each:
        ``3 rings (rings + 1) + 1`` for a full disc. The last is the rim, of the marginal rays; an obscuration adds
        one along its edge.

    Returns
    -------
    ndarray, shape (rays, 2)
        x (columns) and y (rows) from the axis, in metres if the pupil has a wavelength, else in units of lambda*N.
        Exact but for rounding; their rms about their centroid approaches :func:`lommel.spot_radius` of a uniform
        amplitude as `rings` grows.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, or the pupil is a stack.
    """
    if checked_pupil(pupil).shape != ():
        raise ValueError(f"pupil must be a single one, got a stack of shape {pupil.shape}")
    count = validation.integer("rings", rings, least=1, most=100)
    points = [1, *(6 * k for k in range(1, count + 1))]
    # A hair inside the rim, whose own points may be rounded to outside.
    radius = np.arange(count + 1) / count * (1.0 - 1e-12)
    if pupil.obscuration > 0.0:
        points.append(6 * math.ceil(count * pupil.obscuration))
        radius = np.append(radius, pupil.obscuration * (1.0 + 1e-12))
    rho = np.repeat(radius, points)
    theta = np.concatenate([2.0 * math.pi * np.arange(n) / n for n in points])
    x, y = rho * np.cos(theta), rho * np.sin(theta)
    rho = np.maximum(rho, 1e-9)  # in the middle slopes over rho have a limit only
    clear = pupil.opening.margin(x, y) >= 0.0
    if pupil.mask is not None:
        clear &= np.abs(pupil.mask.at(x, y)) > 0.0
    return np.asarray(slopes(pupil, rho[clear], theta[clear])[0].T * (pupil.scale / math.pi))


def spots(psf: PSFLike, ax: Axes | None = None, *, rings: int = 12, stretch: str = "sqrt") -> Axes:
    """Draw a spot diagram over a PSF, with the Airy circle of the aperture about the axis.

    Parameters
    ----------
    psf : PSF
        A single one, of a lens.
    ax : matplotlib Axes, optional
        By default those of a new figure, which has a colour bar and a title with the rms radius of the rays,
        :func:`lommel.spot_radius`.
    rings : int, default 12
        Number of rings of rays; see :func:`lommel.show.rays.ray_positions`.
    stretch : {"sqrt", "linear", "log"}
        Scale of the PSF.

    Returns
    -------
    matplotlib Axes

    Raises
    ------
    TypeError, ValueError
        If `psf` is a stack or of an objective, or an argument is out of range.
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
    x, y = ray_positions(pupil, rings).T * factor
    axes: Axes = plot(psf, ax, stretch=stretch)
    limits = axes.get_xlim(), axes.get_ylim()
    axes.scatter(x, y, s=4.0, color="deepskyblue", linewidths=0.0, label=f"{x.size} rays")
    airy = pupil.airy_radius * factor
    circle(axes, airy, color="lime", linewidth=1.0, label="Airy circle")
    axes.set(xlim=limits[0], ylim=limits[1])
    axes.legend(fontsize=7, loc="upper right")
    if ax is None:
        low, high = sorted(limits[1])
        outside = int(np.sum((np.abs(x - np.mean(limits[0])) > 0.5 * np.ptp(limits[0])) | (y < low) | (y > high)))
        beyond = f", {outside} of them beyond the window" if outside else ""
        radius = float(spot_radius(pupil)) * factor
        axes.set_title(f"rays: rms radius {radius:.3g} {unit}{beyond}; Airy radius {airy:.3g} {unit}", fontsize=9)
    return axes
