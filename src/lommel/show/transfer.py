"""Modulation transfer functions as curves."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.measures import transfer
from lommel.measures.answer import Answer
from lommel.measures.image_transfer import image_otf
from lommel.methods.polychromatic import Polychromatic
from lommel.optics.base_pupil import BasePupil
from lommel.optics.pupil import Pupil, checked
from lommel.show.drawing import frequencies, new_axes
from lommel.show.labels import few_of, of_pupils

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_POINTS = 129
_MOST = 8  # pupils of a stack
_TOL = 1e-6


class _Known(NamedTuple):
    """What there is a curve of: a single pupil, its MTF at frequencies along columns and rows, up to which."""

    pupil: BasePupil
    mtf: Callable[[Array, Array], Array]
    most: float


def mtf(thing: Pupil | Answer, ax: Axes | None = None, *, pixel: float | None = None) -> Any:
    """Draw the modulation transfer function along x and along y, beside that without aberration, and the pixel's.

    Parameters
    ----------
    thing : Pupil or PSF
        Of a stack eight are drawn at most, evenly chosen. Of a round lens the curves are those of all light,
        :func:`lommel.mtf`, up to the cutoff; of any other PSF those of the window, no further than the Nyquist
        frequency: :func:`lommel.measures.image_transfer.image_otf`.
    ax : matplotlib Axes, optional
        By default those of a new figure, which has a title.
    pixel : float, optional
        Pitch of pixels that average, metres or units of lambda*N; by default those of a PSF that averages. All
        curves are then of a lens and its pixels, a dotted one is of the pixels alone, and a line is at their Nyquist
        frequency.

    Returns
    -------
    matplotlib Axes

    Raises
    ------
    TypeError, ValueError
        If it is neither, if a pupil is not round, or a pixel is given for a PSF, which has its own.
    ImportError
        If matplotlib is not installed.
    """
    validation.axes("ax", ax)
    if isinstance(thing, Answer):
        if pixel is not None:
            raise ValueError(f"pixel must be None for a PSF, which has its own, got {validation.shown(pixel)}")
        pupil, pitch = thing.pupil, thing.grid.side if thing.grid.integrate and _of_all_light(thing) else None
    else:
        pupil = checked(thing)
        if not pupil.circular:
            raise ValueError(
                "pupil must be a disc or an annulus, since a curve of others takes minutes; draw that of an image, "
                "psf.plot_mtf(), or ask for few frequencies, lommel.mtf"
            )
        pitch = None if pixel is None else validation.pixel(pixel, metric=pupil.unit == "m")
    places = few_of(pupil.shape, _MOST)
    known = [_known(thing[index] if index else thing, pitch) for index in places.values()]
    words = of_pupils(pupil)
    axes = new_axes(ax)
    factor, unit = frequencies(pupil.unit)
    f, zero = np.linspace(0.0, known[0].most, _POINTS), np.zeros(_POINTS)
    for k, (place, one) in enumerate(zip(places, known, strict=True)):
        name = f"{words[place]}, " if pupil.shape else ""
        if one.pupil.radial:
            axes.plot(factor * f, one.mtf(f, zero), color=f"C{k}", label=name.rstrip(", ") or "MTF")
            continue
        axes.plot(factor * f, one.mtf(f, zero), color=f"C{k}", label=f"{name}along x")
        axes.plot(factor * f, one.mtf(zero, f), "--", color=f"C{k}", label=f"{name}along y")
    of_lens = isinstance(pupil, Pupil) and pupil.circular
    if of_lens:
        ideal = transfer.mtf(known[0].pupil.unaberrated(), f, pixel=pitch, tol=_TOL)  # type: ignore[attr-defined]
        axes.plot(factor * f, ideal, color="0.5", linewidth=1.0, label="without aberration")
    if pitch is not None:
        axes.plot(factor * f, np.abs(np.sinc(f * pitch)), ":", color="0.5", label="pixel alone")
        if 0.5 / pitch <= known[0].most:
            axes.axvline(0.5 * factor / pitch, color="0.5", linewidth=0.8, linestyle="-.", label="Nyquist of pixels")
    axes.set_xlabel(f"spatial frequency ({unit})")
    axes.set_ylabel("MTF (1)")
    axes.set_xlim(0.0, factor * known[0].most)
    axes.set_ylim(0.0, 1.05)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8)
    if ax is None:
        axes.set_title(_title(pupil, pitch, isinstance(thing, Answer) and not _of_all_light(thing)), fontsize=9)
    return axes


def _of_all_light(psf: Answer) -> bool:
    """Whether the wavefront tells: of a round lens and square pixels, but for what has rays alone."""
    plain = psf.grid.square and not psf.blur
    return plain and isinstance(psf.pupil, Pupil) and psf.pupil.circular and psf.method.sampling == "center"


def _known(thing: Any, pixel: float | None) -> _Known:
    """Return the MTF of a single pupil or PSF."""
    if isinstance(thing, Answer) and not _of_all_light(thing):
        return _Known(
            thing.pupil,
            lambda fx, fy: np.abs(image_otf(thing, fx, fy)),
            min(0.5 / max(thing.grid.pitch), thing.pupil.cutoff),
        )
    pupil: Any = thing.pupil if isinstance(thing, Answer) else thing
    spectrum = None
    if isinstance(thing, Answer) and isinstance(thing.method, Polychromatic):
        spectrum = thing.method

    def of_wavefront(fx: Array, fy: Array) -> Array:
        return np.asarray(transfer.mtf(pupil, fx, fy, pixel=pixel, spectrum=spectrum, tol=_TOL))

    return _Known(pupil, of_wavefront, pupil.cutoff)


def _title(pupil: BasePupil, pixel: float | None, of_window: bool) -> str:
    what = "modulation transfer function"
    if pixel is not None:
        what += f" with pixels of {pixel * 1e6:.4g} µm" if pupil.unit == "m" else f" with pixels of {pixel:.4g} λN"
    return f"{what}, of the light in the window" if of_window else what
