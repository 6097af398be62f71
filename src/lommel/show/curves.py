"""Curves of the modulation transfer function and of encircled energy."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.measures import transfer
from lommel.measures.energy import encircled_energy as within
from lommel.measures.psf_like import PSFLike, checked, is_psf
from lommel.optics.base_pupil import BasePupil
from lommel.optics.pupil import Pupil
from lommel.optics.pupil import checked as checked_pupil
from lommel.show.drawing import complete_curves, frequencies, lengths, new_axes
from lommel.show.labels import few_of, of_pupils

if TYPE_CHECKING:
    from matplotlib.axes import Axes


_POINTS = 129
_MOST = 8  # pupils of a stack
_TOL = 1e-6


def mtf(thing: Pupil | PSFLike, ax: Axes | None = None, *, pixel: float | None = None) -> Axes:
    """Draw the MTF along x and along y, with that of the unaberrated aperture and of the pixel.

    Parameters
    ----------
    thing : Pupil or PSF
        Of a stack at most eight are drawn, evenly spaced. The curves of a PSF include its blur and pixels:
        :meth:`lommel.PSF.mtf`.
    ax : matplotlib Axes, optional
        By default those of a new figure, which has a title.
    pixel : float, optional
        Pixel pitch, metres or units of lambda*N; by default that of a pixel-integrated PSF. The curves then include
        the pixel; a dotted one is of the pixel alone, and a line marks the Nyquist frequency.

    Returns
    -------
    matplotlib Axes

    Raises
    ------
    TypeError, ValueError
        If `thing` is neither, or a pixel is given for a PSF, which has its own.
    ImportError
        If matplotlib is not installed.
    """
    validation.axes("ax", ax)
    if is_psf(thing):
        if pixel is not None:
            raise ValueError(f"pixel must be None for a PSF, which has its own, got {validation.shown(pixel)}")
        pupil, grid = thing.pupil, thing.grid
        sides = grid.active
    else:
        pupil = checked_pupil(thing)
        side = 0.0 if pixel is None else validation.pixel(pixel, metric=pupil.unit == "m")
        sides = side, side
    places = few_of(pupil.shape, _MOST)
    words = of_pupils(pupil)
    axes = new_axes(ax)
    factor, unit = frequencies(pupil.unit)
    most = pupil.cutoff * (thing.method.stretch(pupil) if is_psf(thing) else 1.0)
    f, zero = np.linspace(0.0, most, _POINTS), np.zeros(_POINTS)
    for k, (place, index) in enumerate(places.items()):
        one = thing[index] if pupil.shape else thing
        name = f"{words[place]}, " if pupil.shape else ""
        if _alike(one, sides):
            axes.plot(factor * f, _curve(one, f, zero, sides), color=f"C{k}", label=name.rstrip(", ") or "MTF")
            continue
        axes.plot(factor * f, _curve(one, f, zero, sides), color=f"C{k}", label=f"{name}along x")
        axes.plot(factor * f, _curve(one, zero, f, sides), "--", color=f"C{k}", label=f"{name}along y")
    if isinstance(pupil, Pupil):
        first: Any = thing[(0,) * len(pupil.shape)] if pupil.shape else thing
        if is_psf(first):
            ideal: Any = replace(first, pupil=first.pupil.unaberrated(), derivatives={})  # type: ignore[attr-defined]
        else:
            ideal = first.unaberrated()
        axes.plot(factor * f, _curve(ideal, f, zero, sides), color="0.5", linewidth=1.0, label="without aberration")
    if sides[1]:
        axes.plot(factor * f, _of_pixel(f, sides[1]), ":", color="0.5", label="pixel alone")
        nyquist = 0.5 / (thing.grid.pitch[1] if is_psf(thing) else sides[1])
        if nyquist <= most:
            axes.axvline(factor * nyquist, color="0.5", linewidth=0.8, linestyle="-.", label="Nyquist of pixels")
    title = _title(pupil, thing.pixel if is_psf(thing) and sides[1] else pixel) if ax is None else None
    complete_curves(axes, title, (0.0, factor * most), xlabel=f"spatial frequency ({unit})", ylabel="MTF")
    return axes


def _of_pixel(f: Array, side: float) -> Array:
    return np.asarray(np.abs(np.sinc(f * side)))


def _alike(thing: Any, sides: tuple[float, float]) -> bool:
    """Return whether the curves along x and y are one."""
    if not is_psf(thing):
        return bool(thing.radial)
    turned = any(one.streak != (0.0, 0.0) or one.covariance[0, 0] != one.covariance[1, 1] for one in thing.blur)
    return thing.pupil.radial and sides[0] == sides[1] and not turned


def _curve(thing: Any, fx: Array, fy: Array, sides: tuple[float, float]) -> Array:
    """Return the MTF of a single pupil with pixels of such sides, or of a single PSF."""
    if not is_psf(thing):
        return np.asarray(transfer.mtf(thing, fx, fy, tol=_TOL)) * _of_pixel(fx, sides[1]) * _of_pixel(fy, sides[0])
    return np.asarray(np.abs(transfer.image_otf(thing, fx, fy, tol=_TOL)))


def _title(pupil: BasePupil, pixel: float | tuple[float, float] | None) -> str:
    what = "modulation transfer function"
    if pixel is None:
        return what
    factor, unit = lengths(pupil.unit)
    sides = (pixel,) if isinstance(pixel, float) else pixel
    return f"{what} with pixels of {' x '.join(f'{factor * side:.4g}' for side in sides)} {unit}"


_RADII = 129
_SHARES = (0.5, 0.8)


def encircled_energy(psf: PSFLike, ax: Axes | None = None, *, radius: float | None = None) -> Axes:
    """Draw the encircled energy about the axis, with that of the unaberrated aperture.

    Parameters
    ----------
    psf : PSF
        Of a stack at most eight are drawn, evenly spaced.
    ax : matplotlib Axes, optional
        By default those of a new figure, which has a title, for a single PSF with the radii of 50 and 80 %.
    radius : float, optional
        Largest radius, metres or units of lambda*N; by default that of the circle that fits into the window.

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
    The curve is :func:`lommel.measures.energy.encircled_energy`, with blur and pixels. For a single PSF of a lens the
    dashed curve is that of the same aperture in focus and without aberration.
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
        if isinstance(pupil, Pupil):
            ideal = within(replace(psf, pupil=pupil.unaberrated(), derivatives={}), at)
            axes.plot(factor * at, ideal, "--", color="0.5", label="without aberration")
        found = {share: float(np.interp(share, curve, at)) for share in _SHARES if curve[-1] > share}
        told = [f"{share:.0%} within {half * factor:.3g} {unit}" for share, half in found.items()]
        title = ", ".join([title, *told])
        for share, half in found.items():
            axes.plot([0.0, half * factor, half * factor], [share, share, 0.0], ":", color="0.5", linewidth=0.8)
    own, limits = title if ax is None else None, (0.0, far * factor)
    ylabel = "fraction of all light"
    complete_curves(axes, own, limits, "lower right", xlabel=f"radius ({unit})", ylabel=ylabel)
    return axes


def _fitting(psf: PSFLike) -> float:
    """Return the radius of the largest circle about the axis in all windows; of others half their longer side."""
    ends = [part for at in (psf.grid.x, psf.grid.y) for part in (-at[..., 0], at[..., -1])]
    inside = float(np.min(ends)) + 0.5 * min(psf.grid.pitch)
    sides = (count * pitch for count, pitch in zip(psf.grid.shape, psf.grid.pitch, strict=True))
    return inside if inside > 0.0 else 0.5 * max(sides)
