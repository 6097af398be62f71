"""The light within circles, as a curve."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.measures.answer import Answer, checked
from lommel.measures.energy import encircled_energy as within
from lommel.optics.pupil import Pupil
from lommel.show.drawing import lengths, new_axes
from lommel.show.labels import few_of, of_pupils

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_RADII = 129
_MOST = 8  # curves
_SHARES = (0.5, 0.8)


def encircled_energy(psf: Answer, ax: Axes | None = None, *, radius: float | None = None) -> Any:
    """Draw the fraction of all light within circles about the axis, beside that of the aperture without aberration.

    Parameters
    ----------
    psf : PSF
        Of a stack eight are drawn at most, evenly chosen.
    ax : matplotlib Axes, optional
        By default those of a new figure, which has a title: of a single PSF with the radii where the curve reaches
        50 and 80 %.
    radius : float, optional
        Of the largest circle, metres or units of lambda*N; by default that which fits into the window.

    Returns
    -------
    matplotlib Axes

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.
    ImportError
        If matplotlib is not installed.

    Notes
    -----
    The curve is :func:`lommel.measures.energy.encircled_energy`, of the image with its blur and its pixels. Dashed is
    the same aperture in focus and without aberration, of a single PSF of a lens.
    """
    pupil = checked(psf, "psf").pupil
    validation.axes("ax", ax)
    far = _fitting(psf) if radius is None else validation.real("radius", radius, above=0.0)
    at = np.linspace(0.0, far, _RADII)
    factor, unit = lengths(psf.unit)
    title = "encircled energy"
    axes = new_axes(ax)
    if pupil.shape:
        titles = of_pupils(pupil)
        for place, index in few_of(pupil.shape, _MOST).items():
            axes.plot(factor * at, within(psf[index], at), label=titles[place])
    else:
        curve = np.asarray(within(psf, at))
        axes.plot(factor * at, curve, label="PSF")
        ideal = _ideal(psf, at)
        if ideal is not None:
            axes.plot(factor * at, ideal, "--", color="0.5", label="without aberration")
        found = {share: float(np.interp(share, curve, at)) for share in _SHARES if curve[-1] > share}
        told = [f"{share:.0%} within {half * factor:.3g} {unit}" for share, half in found.items()]
        title = ", ".join([title, *told])
        for share, half in found.items():
            axes.plot([0.0, half * factor, half * factor], [share, share, 0.0], ":", color="0.5", linewidth=0.8)
    axes.set_xlabel(f"radius ({unit})")
    axes.set_ylabel("fraction of all light (1)")
    axes.set_xlim(0.0, far * factor)
    axes.set_ylim(0.0, 1.05)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8, loc="lower right")
    if ax is None:
        axes.set_title(title, fontsize=9)
    return axes


def _fitting(psf: Answer) -> float:
    """Return the radius of the largest circle about the axis in all windows; of others half their longer side."""
    ends = [part for at in (psf.grid.x, psf.grid.y) for part in (-at[..., 0], at[..., -1])]
    inside = float(np.min(ends)) + 0.5 * min(psf.grid.pitch)
    sides = (count * pitch for count, pitch in zip(psf.grid.shape, psf.grid.pitch, strict=True))
    return inside if inside > 0.0 else 0.5 * max(sides)


def _ideal(psf: Answer, radius: Array) -> Array | None:
    """Return the light of the aperture without aberration, with the same blur and pixels, of lenses."""
    if not isinstance(psf.pupil, Pupil):
        return None
    return np.asarray(within(replace(psf, pupil=psf.pupil.unaberrated(), derivatives={}), radius))
