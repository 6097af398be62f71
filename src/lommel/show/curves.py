"""Plots of the MTF and of encircled energy, and of sections, MTF and Strehl ratio through focus."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from lommel.base import display, validation
from lommel.base.arrays import Array
from lommel.base.units import percent
from lommel.core.answers import Wanted
from lommel.measures import transfer
from lommel.measures.aperture_means import strehl
from lommel.measures.energy import encircled_energy as within
from lommel.measures.psf_like import PSFLike, checked, is_psf
from lommel.methods.choice import candidates, first_within_tolerance, of_profiles
from lommel.methods.method import Method
from lommel.optics.base_pupil import BasePupil
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil
from lommel.optics.pupil import checked as checked_pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.show import drawing
from lommel.special import zernike

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_PLANES = 161  # number of sensor positions
_MARGIN = 8.0  # smallest additional defocus drawn beyond the outermost foci, radians


def moved(pupil: Pupil, *, reach: float | None = None, count: int | None = None) -> tuple[Array, Pupil]:
    """Return shifts of the sensor away from the lens, and a stack of pupils for these shifts.

    Shifts are in metres or, for a pupil in units of lambda*N, instead the added defocus C_d, radians, up to `reach`
    in both directions; by default the range includes the focus of each zone of the aperture and the initial sensor
    position, with a margin. The pupil keeps its f-number N: a shift by z adds ``C_d = -pi z / (8 lambda N^2)``.
    """
    if checked_pupil(pupil).shape != ():
        raise ValueError(f"pupil must be a single one, got a stack of shape {pupil.shape}; index it")
    step = 1.0 if pupil.wavelength is None else -8.0 * pupil.scale**2 / (math.pi * pupil.wavelength)
    low, high = sorted(step * focus for focus in _foci(pupil)) if reach is None else (-reach, reach)
    shifts = np.linspace(low, high, count or _PLANES)
    return shifts, replace(pupil, wavefront=pupil.wavefront + Wavefront(shifts / step), geometry=None)


def section(pupil: Pupil, x: Array) -> Array:
    """Return the intensity along x, on a line through the axis, for each pupil of a stack, shape (n, len(x)).

    `x`, metres or units of lambda*N, has equally spaced positions, odd in number, with 0 at the centre. Intensity is
    relative to the peak of the aperture without aberrations; its error is below 1e-6 of the largest value of a pupil.
    """
    if pupil.radial:
        method: Method = of_profiles()
        v, inverse = np.unique(pupil.v(np.abs(x)), return_inverse=True)
        values = of_profiles().profile(pupil, v).values[:, inverse.ravel()]
    else:
        grid = Grid((1, x.size), float(x[-1] - x[0]) / (x.size - 1), center=(0.0, float(x.size // 2)))
        method, images = first_within_tolerance(
            candidates(pupil, grid), lambda method: method.images(pupil, grid, Wanted())
        )
        values = images.values[:, 0]
    return np.asarray(values / method.unaberrated_peak(pupil), dtype=np.float64)


def _foci(pupil: Pupil) -> tuple[float, float]:
    """Return the range of added defocus C_d, radians, that contains 0 and the foci of all zones, with a margin."""
    t = np.linspace(pupil.obscuration**2, 1.0, 129)
    # Defocus adds the phase C_d (2 t - 1), t = rho^2. A zone is in focus if its slope 2 C_d cancels the slope of the
    # pupil's phase.
    slope = 2.0 * zernike.legendre_slope(pupil.radial_terms()[0], 2.0 * t - 1.0)
    low, high = min(-0.5 * float(slope.max()), 0.0), max(-0.5 * float(slope.min()), 0.0)
    margin = _MARGIN + 0.25 * (high - low)
    return low - margin, high + margin


_X_POINTS = 241  # number of positions along x in a section through focus
_TOL = 1e-6  # tolerance of the drawn MTFs
_CUTOFF_FRACTIONS = (0.1, 0.25, 0.5)  # default frequencies, as fractions of the cutoff


def through_focus(pupil: Pupil, ax: Axes | None = None) -> Axes:
    """Draw a section along the axis through focus: x against the shift of the sensor away from the lens.

    Parameters
    ----------
    pupil : Pupil
        Single pupil. In units of lambda*N the horizontal axis is the added defocus coefficient C_d (radians at the
        pupil edge), which decreases as the sensor moves away from the lens.
    ax : matplotlib Axes, optional
        By default a new figure with a title and a colour bar.

    Returns
    -------
    matplotlib Axes

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.
    ImportError
        If matplotlib is not installed.
    """
    validation.axes("ax", ax)
    shifts, stack = moved(pupil)
    half_x = 1.1 * float(stack.geometric_radius().max()) + pupil.airy_radius
    x = np.linspace(-half_x, half_x, _X_POINTS)
    values = np.maximum(section(stack, x), 0.0)
    factor, unit = drawing.lengths(pupil.unit)
    shift, label = _shift(pupil, shifts)
    step = x[1] - x[0], shift[1] - shift[0]
    axes = drawing.new_axes(ax, (7.2, 4.2))
    top = (half_x + 0.5 * step[0]) * factor
    axes.imshow(
        values.T,
        extent=(shift[0] - 0.5 * step[1], shift[-1] + 0.5 * step[1], -top, top),
        origin="lower",
        aspect="auto",
        cmap=drawing.COLOURS,
        norm=drawing.norm_of("sqrt", values),
        interpolation="bilinear",
    )
    axes.axvline(0.0, color="C0", linewidth=0.8, linestyle="--")
    axes.set(xlabel=label, ylabel=f"x ({unit})")
    if ax is None:
        drawing.caption(
            axes, _through_focus_title(pupil), drawing.bar_label("irradiance (1 = unaberrated peak)", "sqrt")
        )
    return axes


def focus_curves(pupil: Pupil, ax: Axes | None = None) -> Axes:
    """Draw the Strehl ratio and the MTF at a tenth, a quarter and half of the cutoff against the sensor's shift.

    Parameters
    ----------
    pupil : Pupil
        Single pupil. For a pupil with a mask only the Strehl ratio is drawn. If the MTF is not radially symmetric,
        dashed curves show the MTF along y.
    ax : matplotlib Axes, optional
        By default a new figure with a title.

    Returns
    -------
    matplotlib Axes

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.
    ImportError
        If matplotlib is not installed.
    """
    validation.axes("ax", ax)
    shifts, stack = moved(pupil)
    f = np.array(_CUTOFF_FRACTIONS) * pupil.cutoff
    axes = drawing.new_axes(ax, (6.4, 4.2))
    shift, label = _shift(pupil, shifts)
    axes.plot(shift, strehl(stack), color=axes.xaxis.label.get_color(), label="Strehl ratio")  # white in dark styles
    if pupil.mask is None:
        factor, unit = drawing.frequencies(pupil.unit)
        directions = {"-": (f, np.zeros(f.size))} | ({} if pupil.radial else {"--": (np.zeros(f.size), f)})
        for style, (fx, fy) in directions.items():
            curves = np.asarray(transfer.mtf(stack, fx, fy, tol=_TOL))
            for k, value in enumerate(f):
                name = f"MTF at {value * factor:.3g} {unit}" + (", along y" if style == "--" else "")
                axes.plot(shift, curves[:, k], style, color=f"C{k}", label=name)
    axes.axvline(0.0, color="0.5", linewidth=0.8, linestyle="--")
    title = _through_focus_title(pupil) if ax is None else None
    drawing.complete_curves(axes, title, (shift[0], shift[-1]), xlabel=label, ylabel="Strehl ratio, MTF")
    return axes


def _shift(pupil: Pupil, shifts: Array) -> tuple[Array, str]:
    """Return the sensor shifts, or the added defocus, in the unit of the horizontal axis, and the axis label."""
    if pupil.wavelength is None:
        return shifts, "added defocus C_d (rad)"
    unit, factor = ("mm", 1e3) if float(np.abs(shifts).max()) >= 1e-3 else ("µm", 1e6)
    return shifts * factor, f"sensor moved away from the lens ({unit})"


def _through_focus_title(pupil: Pupil) -> str:
    """Return a title: f-number, wavelength, and the meaning of the dashed line."""
    text = "through focus"
    if pupil.wavelength is not None:
        text = f"f/{pupil.f_number:.3g}, {drawing.length_in_words(pupil.wavelength)}"
    return f"{text}; dashed: the sensor"


_POINTS = 129  # number of frequencies of a curve
_MAX_MEMBERS = 8  # largest number of members of a stack that are drawn


@display.register("mtf")
def mtf(thing: Pupil | PSFLike, ax: Axes | None = None, *, pixel: float | None = None) -> Axes:
    """Draw the MTF along x and along y, and for comparison the MTF of the unaberrated aperture and of the pixel.

    Parameters
    ----------
    thing : Pupil or PSF
        Pupil or PSF. At most eight evenly spaced members of a stack are drawn. The MTF of a PSF includes blur and
        pixels (:meth:`lommel.PSF.mtf`).
    ax : matplotlib Axes, optional
        By default a new figure with a title.
    pixel : float, optional
        Pixel pitch for a pupil, metres or units of lambda*N; must be None for a PSF, whose pixels are used. With
        pixels, all curves include the pixel, a dotted curve is the MTF of the pixel alone, and a line marks the
        Nyquist frequency.

    Returns
    -------
    matplotlib Axes

    Raises
    ------
    TypeError, ValueError
        If `thing` is neither a pupil nor a PSF, or if a pixel is passed with a PSF.
    ImportError
        If matplotlib is not installed.
    """
    validation.axes("ax", ax)
    if is_psf(thing):
        if pixel is not None:
            raise ValueError(f"pixel must be None for a PSF, whose pixels are used, got {validation.shown(pixel)}")
        pupil, grid = thing.pupil, thing.grid
        sides = grid.active
    else:
        pupil = checked_pupil(thing)
        side = 0.0 if pixel is None else validation.pixel(pixel, metric=pupil.unit == "m")
        sides = side, side
    members = drawing.evenly_spaced_members(pupil.shape, _MAX_MEMBERS)
    titles = drawing.of_pupils(pupil)
    axes = drawing.new_axes(ax)
    factor, unit = drawing.frequencies(pupil.unit)
    limit = pupil.cutoff * (thing.method.stretch(pupil) if is_psf(thing) else 1.0)
    f, zero = np.linspace(0.0, limit, _POINTS), np.zeros(_POINTS)
    for k, (place, index) in enumerate(members.items()):
        member = thing[index] if pupil.shape else thing
        name = f"{titles[place]}, " if pupil.shape else ""
        if _equal_along_axes(member, sides):
            axes.plot(factor * f, _curve(member, f, zero, sides), color=f"C{k}", label=name.rstrip(", ") or "MTF")
            continue
        axes.plot(factor * f, _curve(member, f, zero, sides), color=f"C{k}", label=f"{name}along x")
        axes.plot(factor * f, _curve(member, zero, f, sides), "--", color=f"C{k}", label=f"{name}along y")
    if isinstance(pupil, Pupil):
        single: Any = thing[(0,) * len(pupil.shape)] if pupil.shape else thing
        if is_psf(single):
            ideal: Any = replace(single, pupil=single.pupil.unaberrated(), derivatives={})  # type: ignore[attr-defined]
        else:
            ideal = single.unaberrated()
        axes.plot(factor * f, _curve(ideal, f, zero, sides), color="0.5", linewidth=1.0, label="without aberration")
    if sides[1]:
        axes.plot(factor * f, _pixel_mtf(f, sides[1]), ":", color="0.5", label="pixel alone")
        nyquist = 0.5 / (thing.grid.pitch[1] if is_psf(thing) else sides[1])
        if nyquist <= limit:
            axes.axvline(factor * nyquist, color="0.5", linewidth=0.8, linestyle="-.", label="Nyquist of pixels")
    title = _title(pupil, thing.pixel if is_psf(thing) and sides[1] else pixel) if ax is None else None
    drawing.complete_curves(axes, title, (0.0, factor * limit), xlabel=f"spatial frequency ({unit})", ylabel="MTF")
    return axes


def _pixel_mtf(f: Array, side: float) -> Array:
    """Return the MTF of a pixel of this side at frequencies f along the side."""
    return np.asarray(np.abs(np.sinc(f * side)))


def _equal_along_axes(thing: Any, sides: tuple[float, float]) -> bool:
    """Return True if the MTFs along x and y are equal."""
    if not is_psf(thing):
        return bool(thing.radial)
    directional = any(b.streak != (0.0, 0.0) or b.covariance[0, 0] != b.covariance[1, 1] for b in thing.blur)
    return thing.pupil.radial and sides[0] == sides[1] and not directional


def _curve(thing: Any, fx: Array, fy: Array, sides: tuple[float, float]) -> Array:
    """Return the MTF of a single pupil times the MTF of pixels with `sides` (y, x), or the MTF of a single PSF."""
    if not is_psf(thing):
        return np.asarray(transfer.mtf(thing, fx, fy, tol=_TOL)) * _pixel_mtf(fx, sides[1]) * _pixel_mtf(fy, sides[0])
    return np.asarray(np.abs(transfer.image_otf(thing, fx, fy, tol=_TOL)))


def _title(pupil: BasePupil, pixel: float | tuple[float, float] | None) -> str:
    title = "modulation transfer function"
    if pixel is None:
        return title
    factor, unit = drawing.lengths(pupil.unit)
    sides = (pixel,) if isinstance(pixel, float) else pixel
    return f"{title} with pixels of {' x '.join(f'{factor * side:.4g}' for side in sides)} {unit}"


_RADII = 129  # number of radii of a curve
_FRACTIONS = (0.5, 0.8)  # fractions of the light whose radii are marked


@display.register("encircled energy")
def encircled_energy(psf: PSFLike, ax: Axes | None = None) -> Axes:
    """Draw the encircled energy about the axis, up to the largest circle in the window.

    Parameters
    ----------
    psf : PSF
        Single PSF or stack. At most eight evenly spaced members of a stack are drawn.
    ax : matplotlib Axes, optional
        By default a new figure, whose title states the radii that contain 50 % and 80 % of the light of a single PSF.

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
    The curve is :func:`lommel.measures.energy.encircled_energy`, with blur and pixels. For a single PSF of a lens, a
    dashed curve is the encircled energy of the same aperture in focus and without aberrations.
    """
    pupil = checked(psf, "psf").pupil
    validation.axes("ax", ax)
    max_radius = _window_radius(psf)
    radii = np.linspace(0.0, max_radius, _RADII)
    factor, unit = drawing.lengths(psf.unit)
    title = "encircled energy"
    axes = drawing.new_axes(ax)
    if pupil.shape:
        titles = drawing.of_pupils(pupil)
        for place, index in drawing.evenly_spaced_members(pupil.shape, _MAX_MEMBERS).items():
            axes.plot(factor * radii, within(psf[index], radii), label=titles[place])
    else:
        curve = np.asarray(within(psf, radii))
        axes.plot(factor * radii, curve, label="PSF")
        if isinstance(pupil, Pupil):
            ideal = within(replace(psf, pupil=pupil.unaberrated(), derivatives={}), radii)
            axes.plot(factor * radii, ideal, "--", color="0.5", label="without aberration")
        marks = {part: factor * float(np.interp(part, curve, radii)) for part in _FRACTIONS if curve[-1] > part}
        notes = [f"{percent(part)} within {mark:.3g} {unit}" for part, mark in marks.items()]
        title = ", ".join([title, *notes])
        for part, mark in marks.items():
            axes.plot([0.0, mark, mark], [part, part, 0.0], ":", color="0.5", linewidth=0.8)
    figure_title, limits = title if ax is None else None, (0.0, max_radius * factor)
    ylabel = "fraction of all light"
    drawing.complete_curves(axes, figure_title, limits, "lower right", xlabel=f"radius ({unit})", ylabel=ylabel)
    return axes


def _window_radius(psf: PSFLike) -> float:
    """Return the radius of the largest circle about the axis in the window; half a side if the axis is outside."""
    limits = [part for positions in (psf.grid.x, psf.grid.y) for part in (-positions[..., 0], positions[..., -1])]
    radius = float(np.min(limits)) + 0.5 * min(psf.grid.pitch)
    sides = (count * pitch for count, pitch in zip(psf.grid.shape, psf.grid.pitch, strict=True))
    return radius if radius > 0.0 else 0.5 * max(sides)
