"""Plots of the phase and the amplitude across a pupil."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from lommel.base import display, validation
from lommel.base.arrays import Array
from lommel.measures.aperture_means import rms
from lommel.optics.base_pupil import BasePupil, imaged
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.show import drawing

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.image import AxesImage

UNITS = ("waves", "radians", "nm")
_SIDE = 256
_BLOCKED = "0.55"  # colour of where no light passes


class Across(NamedTuple):
    """Phase (radians, NaN where no light passes) and amplitude on a raster from -1 to 1, shape (n, side, side)."""

    phase: Array
    amplitude: Array


@display.plot.register(Wavefront)
def wavefront(thing: Wavefront, ax: Axes | None = None, *, unit: str = "waves") -> drawing.Drawn:
    """Draw the phase of a wavefront over the full disc, without its mean; a stack side by side on one scale.

    Parameters
    ----------
    thing : Wavefront
        A stack of at most 64 is drawn.
    ax : matplotlib Axes, optional
        For a single one. By default those of a new figure, which has a title and a colour bar.
    unit : {"waves", "radians"}
        Unit of the phase.

    Returns
    -------
    matplotlib Axes, or for a stack an ndarray of Axes of its shape

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.
    ImportError
        If matplotlib is not installed.
    """
    validation.instance("wavefront", thing, Wavefront)
    validation.choice("unit", unit, UNITS[:2])
    return _phase(Pupil(thing), ax, unit, drawing.of_wavefronts(thing))


@display.plot.register(BasePupil)
def pupil(thing: BasePupil, ax: Axes | None = None, *, what: str = "phase", unit: str = "waves") -> drawing.Drawn:
    """Draw the phase across a pupil, without its mean, or its amplitude; a stack side by side on one scale.

    Parameters
    ----------
    thing : Pupil or ObjectivePupil
        A stack of at most 64 is drawn. For an objective the phase is that of its layers in this plane, with its
        aberrations; the dashed circle is the critical angle of the sample, beyond which light decays with depth.
    ax : matplotlib Axes, optional
        For a single one. By default those of a new figure, which has a title and a colour bar.
    what : {"phase", "amplitude"}
        The amplitude is 1 where the aperture is clear, unless it is apodized; for an objective it is the rms over
        both polarisations of the amplitude transmitted by the layers, relative to its maximum. Blocked regions are
        grey.
    unit : {"waves", "radians", "nm"}
        Unit of the phase; nm of optical path for a pupil with a wavelength.

    Returns
    -------
    matplotlib Axes, or for a stack an ndarray of Axes of its shape

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.
    ImportError
        If matplotlib is not installed.
    """
    validation.choice("what", what, ("phase", "amplitude"))
    validation.choice("unit", unit, UNITS)
    if what == "phase":
        return _phase(imaged(thing), ax, unit, drawing.of_pupils(thing))
    found = _few(imaged(thing), ax).amplitude
    if thing.layered:
        found, passing = found / found.max(), "of both polarisations, over the largest"
    else:
        passing = f"(1 = clear); {100.0 * thing.transmission:.3g} % of a clear disc's light pass"
    values, most = np.where(found > 0.0, found, np.nan), max(1.0, float(found.max()))
    words = f"amplitude {passing}", "amplitude"
    return _draw(thing, values, ax, words, drawing.of_pupils(thing), cmap="viridis", vmin=0.0, vmax=most)


def across(pupil: BasePupil, side: int = _SIDE) -> Across:
    """Return phase and amplitude on a raster, for the flattened stack."""
    at = (np.arange(side) + 0.5) * (2.0 / side) - 1.0
    x, y = np.meshgrid(at, at)
    rho, theta = np.hypot(x, y), np.arctan2(y, x)
    count = math.prod(pupil.shape)
    phase = np.full((count, side, side), np.nan)
    amplitude = np.zeros(phase.shape)
    if isinstance(pupil, Pupil):
        strength = pupil.illumination.at(rho**2) * (pupil.opening.margin(x, y) >= 0.0)
        if pupil.mask is not None:
            strength = strength * np.abs(pupil.mask.at(x, y))
        clear = strength > 0.0
        amplitude[:] = strength
        added = pupil.opening.phase(x[clear], y[clear])
        if pupil.mask is not None:
            added = added + np.angle(pupil.mask.at(x[clear], y[clear]))
        phase[:, clear] = pupil.wavefront.phase(rho[clear], theta[clear]).reshape(count, -1) + added
    elif isinstance(pupil, ObjectivePupil):
        clear = rho <= 1.0
        phase[:, clear], amplitude[:, clear] = _through_layers(pupil, rho[clear], theta[clear])
    if clear.any():
        phase -= phase[:, clear].mean(axis=1)[:, None, None]
    return Across(phase, amplitude)


def _through_layers(pupil: ObjectivePupil, rho: Array, theta: Array) -> tuple[Array, Array]:
    """Return the phase of each plane at points of an objective's pupil, and the amplitude, shape (n, points)."""
    layers = pupil.layers
    fixed, by_depth, by_focus = layers.rates(layers.cosine(rho))
    psi = fixed + np.multiply.outer(pupil.depth.ravel(), by_depth) + np.multiply.outer(pupil.focus.ravel(), by_focus)
    made = layers.amplitudes(layers.cosine(rho), (layers.NA * rho) ** 2)
    passed = np.sqrt(0.5 * (np.abs(made.s) ** 2 + np.abs(made.p) ** 2))
    passed = passed * np.exp(-layers.apodization((layers.NA * rho) ** 2))
    phase = psi.real
    if pupil.aberrations is not None:
        phase = phase + pupil.aberrations.phase(rho, theta).reshape(-1, rho.size)
    return phase, passed * np.exp(-psi.imag)


def _few(pupil: BasePupil, ax: Axes | None) -> Across:
    """Return :func:`across` of a stack that can be drawn; ValueError for too many, or for axes and a stack."""
    validation.axes("ax", ax)
    drawing.only_single(ax, pupil.shape)
    count = math.prod(pupil.shape)
    drawing.at_most(pupil.shape)
    # Vanes and gaps are narrow.
    side = _SIDE if pupil.circular else 2 * _SIDE
    return across(pupil, side if count < 9 else side // 2)


def _phase(pupil: BasePupil, ax: Axes | None, unit: str, titles: list[str]) -> drawing.Drawn:
    """Draw the phase of a pupil, or of a stack of them."""
    if unit == "nm" and pupil.wavelength is None:
        raise ValueError('unit="nm" needs a pupil with a wavelength, got one without; take "waves" or "radians"')
    per = 1.0 if unit == "radians" else 2.0 * math.pi
    if unit == "nm":
        per /= 1e9 * (pupil.wavelength or math.nan)
    values = _few(pupil, ax).phase / per
    title = "phase, less its mean"
    if not pupil.shape and isinstance(pupil, Pupil) and not pupil.phase_mask:
        spread = float(np.nanmax(values) - np.nanmin(values))
        title = f"rms {float(rms(pupil)) / per:.3g} {unit}, peak to valley {spread:.3g} {unit}"
    words, norm = (title, f"phase, less its mean ({unit})"), drawing.even_norm(float(np.nanmax(np.abs(values))))
    return _draw(pupil, values, ax, words, titles, cmap="RdBu_r", norm=norm)


def _draw(
    pupil: BasePupil, values: Array, ax: Axes | None, words: tuple[str, str], titles: list[str], **how: Any
) -> drawing.Drawn:
    """Draw what is known across a pupil, with a title and what the bar says."""

    def one(index: tuple[int, ...], axes: Axes) -> AxesImage:
        image = axes.imshow(values.reshape(*pupil.shape, *values.shape[1:])[index], extent=(-1, 1, 1, -1), **how)
        ticks = [-1, 0, 1]
        axes.set(facecolor=_BLOCKED, xticks=ticks, yticks=ticks, xlabel="x (pupil radii)", ylabel="y (pupil radii)")
        if isinstance(pupil, ObjectivePupil) and pupil.layers.sample < pupil.layers.NA:
            drawing.circle(axes, pupil.layers.sample / pupil.layers.NA, color="0.3", linewidth=0.8)
        return image

    if pupil.shape:
        return drawing.tiles(pupil.shape, one, titles, *words)
    axes = drawing.new_axes(ax)
    one((), axes)
    if ax is None:
        drawing.caption(axes, *words)
    return axes
