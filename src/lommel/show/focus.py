"""Light about the focus: a section through it, and curves of how sharp it is."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.base.units import format_length
from lommel.measures import transfer
from lommel.measures.aperture_means import strehl
from lommel.measures.through_focus import Moved, moved, section
from lommel.optics.lens import Lens
from lommel.optics.pupil import Pupil
from lommel.show.drawing import STRETCHES, frequencies, lengths, new_axes, norm_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_ACROSS = 241  # points along x
_SHARES = (0.1, 0.25, 0.5)  # of the cutoff
_TOL = 1e-6


def through_focus(
    thing: Lens | Pupil,
    ax: Axes | None = None,
    *,
    object_distance: float | None = None,
    reach: float | None = None,
    half_width: float | None = None,
    planes: int = 161,
    stretch: str = "sqrt",
) -> Any:
    """Draw the light behind a lens: x across, and to the right how far the sensor is moved away from the lens.

    Parameters
    ----------
    thing : Lens or Pupil
        A single one. Of a pupil in units of lambda*N the horizontal axis is the defocus C_d that is added, radians,
        which falls as the sensor moves away.
    ax : matplotlib Axes, optional
        By default those of a new figure, which has a title and a bar.
    object_distance : float, optional
        Metres, of a lens; by default what is in focus.
    reach : float, optional
        Farthest place of the sensor on both sides: metres, or radians; see
        :func:`lommel.measures.through_focus.moved`.
    half_width : float, optional
        Of what is shown of x, metres or units of lambda*N; by default all that rays reach. Far from the focus that is
        much, and a sharp focus falls between the 241 points; name it, and `reach`.
    planes : int, default 161
        Places of the sensor.
    stretch : {"sqrt", "linear", "log"}
        Of the levels; "log" goes down to 1e-5 of the largest.

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
    validation.choice("stretch", stretch, STRETCHES)
    through = moved(thing, object_distance, reach=reach, count=planes)
    here = through.pupils[len(through.pupils) // 2]
    if half_width is None:
        blur = max(float(pupil.geometric_radius().max()) for pupil in (through.pupils[0], through.pupils[-1]))
        half_width = 1.1 * blur + here.airy_radius
    half = validation.real("half_width", half_width, above=0.0)
    x = np.linspace(-half, half, _ACROSS)
    values = np.maximum(section(through, x), 0.0)
    factor, unit = lengths(here.unit)
    shift, label = _shift(through)
    step = x[1] - x[0], shift[1] - shift[0]
    axes = new_axes(ax, figsize=(7.2, 4.2))
    top = (half + 0.5 * step[0]) * factor
    image = axes.imshow(
        values.T,
        extent=(shift[0] - 0.5 * step[1], shift[-1] + 0.5 * step[1], -top, top),
        origin="lower",
        aspect="auto",
        cmap="magma",
        norm=norm_of(stretch, float(values.max()) or 1.0),
        interpolation="bilinear",
    )
    axes.axvline(0.0, color="C0", linewidth=0.8, linestyle="--")
    axes.set_xlabel(label)
    axes.set_ylabel(f"x ({unit})")
    if ax is None:
        axes.set_title(f"{_told(thing, here, object_distance)}; dashed: the sensor", fontsize=9)
        axes.figure.colorbar(image, ax=axes, label="irradiance (1 = unaberrated peak)")
    return axes


def focus_curves(
    thing: Lens | Pupil,
    ax: Axes | None = None,
    *,
    object_distance: float | None = None,
    reach: float | None = None,
    frequency: float | Sequence[float] | None = None,
    planes: int = 61,
) -> Any:
    """Draw the Strehl ratio and the MTF at some frequencies while the sensor moves.

    Parameters
    ----------
    thing : Lens or Pupil
        A single one; of an aperture that is not round the Strehl ratio alone is drawn.
    ax : matplotlib Axes, optional
        By default those of a new figure, which has a title.
    object_distance, reach
        As of :func:`lommel.show.focus.through_focus`.
    frequency : float or sequence of float, optional
        Cycles per metre, or per lambda*N; by default a tenth, a quarter and half of the cutoff. Dashed curves are
        along y, where these differ from those along x.
    planes : int, default 61

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
    through = moved(thing, object_distance, reach=reach, count=planes)
    here = through.pupils[len(through.pupils) // 2]
    given = np.array(_SHARES) * here.cutoff if frequency is None else frequency
    f = np.atleast_1d(validation.real_array("frequency", given, least=0.0))
    axes = new_axes(ax, figsize=(6.4, 4.2))
    shift, label = _shift(through)
    ratios = np.concatenate([np.atleast_1d(strehl(pupil)) for pupil in through.pupils])
    axes.plot(shift, ratios, color=axes.xaxis.label.get_color(), label="Strehl ratio")  # white in dark styles
    if here.circular:
        factor, unit = frequencies(here.unit)
        along = {"-": (f, np.zeros(f.size))} | ({} if here.radial else {"--": (np.zeros(f.size), f)})
        for style, (fx, fy) in along.items():
            curves = np.concatenate([np.atleast_2d(transfer.mtf(p, fx, fy, tol=_TOL)) for p in through.pupils])
            for k, each in enumerate(f):
                word = f"MTF at {each * factor:.3g} {unit}" + (", along y" if style == "--" else "")
                axes.plot(shift, curves[:, k], style, color=f"C{k}", label=word)
    axes.axvline(0.0, color="0.5", linewidth=0.8, linestyle="--")
    axes.set_xlabel(label)
    axes.set_ylabel("Strehl ratio, MTF (1)")
    axes.set_xlim(shift[0], shift[-1])
    axes.set_ylim(0.0, 1.05)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8)
    if ax is None:
        axes.set_title(f"{_told(thing, here, object_distance)}; dashed: the sensor", fontsize=9)
    return axes


def _shift(through: Moved) -> tuple[Array, str]:
    """Return the places of the sensor as axes have them, and the label."""
    if not through.metric:
        return through.at, "added defocus C_d (rad)"
    millimetres = float(np.abs(through.at).max()) >= 1e-3
    unit, factor = ("mm", 1e3) if millimetres else ("µm", 1e6)
    return through.at * factor, f"sensor moved away from the lens ({unit})"


def _told(thing: Lens | Pupil, pupil: Pupil, object_distance: float | None) -> str:
    """Return what there is to say of the light: f-number, wavelength, object."""
    if pupil.wavelength is None:
        return "through focus"
    light = f"f/{pupil.f_number:.3g}, {format_length(pupil.wavelength)}".replace(" um", " µm")
    if not isinstance(thing, Lens):
        return light
    distance = thing.focus_distance if object_distance is None else object_distance
    return f"{light}, object at {'∞' if math.isinf(distance) else format_length(float(distance))}"
