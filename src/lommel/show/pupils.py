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

UNITS = ("waves", "radians", "nm")
_SIDE = 256  # pixels along a side of an image
_BLOCKED = "0.55"  # grey of blocked regions


class PupilMaps(NamedTuple):
    """Phase (radians, NaN in blocked regions) and amplitude of n pupils, shape (n, side, side).

    Pixels cover the square from -1 to 1 pupil radii.
    """

    phase: Array
    amplitude: Array


@display.plot.register(Wavefront)
def wavefront(thing: Wavefront, ax: Axes | None = None, *, unit: str = "waves") -> drawing.Drawn:
    """Draw the phase of a wavefront over the full disc, minus its mean; members of a stack share one colour scale.

    Parameters
    ----------
    thing : Wavefront
        One wavefront, or a stack of at most 64.
    ax : matplotlib Axes, optional
        Axes for a single wavefront. By default the axes of a new figure with a title and a colour bar.
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
    """Draw the phase across a pupil minus its mean, or the amplitude; members of a stack share one colour scale.

    Parameters
    ----------
    thing : Pupil or ObjectivePupil
        One pupil, or a stack of at most 64. The phase of an objective is the sum of its aberrations and of the phase
        of its layers, for the depth of the emitter and the focus of the stage. A dashed circle marks the critical
        angle of the sample, beyond which light decays with depth.
    ax : matplotlib Axes, optional
        Axes for a single pupil. By default the axes of a new figure with a title and a colour bar.
    what : {"phase", "amplitude"}
        Quantity to draw. The amplitude of a lens is 1 in clear parts of an aperture without apodization. The
        amplitude of an objective is the rms, over both polarisations, of the amplitude that the layers transmit,
        divided by the maximum. Blocked regions are grey.
    unit : {"waves", "radians", "nm"}
        Unit of the phase. "nm" is nanometres of optical path and needs a pupil with a wavelength.

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
    amplitude = _drawable_maps(imaged(thing), ax).amplitude
    if thing.layered:
        amplitude, note = amplitude / amplitude.max(), "of both polarisations, relative to the largest"
    else:
        note = f"(1 = clear); transmits {100.0 * thing.transmission:.3g} % of the light of a clear disc"
    values, largest = np.where(amplitude > 0.0, amplitude, np.nan), max(1.0, float(amplitude.max()))
    labels = f"amplitude {note}", "amplitude"
    return _draw(thing, values, ax, labels, drawing.of_pupils(thing), cmap="viridis", vmin=0.0, vmax=largest)


def pupil_maps(pupil: BasePupil, side: int = _SIDE) -> PupilMaps:
    """Return phase and amplitude of each pupil of the flattened stack, in images of `side` by `side` pixels."""
    centres = (np.arange(side) + 0.5) * (2.0 / side) - 1.0
    x, y = np.meshgrid(centres, centres)
    rho, theta = np.hypot(x, y), np.arctan2(y, x)
    count = math.prod(pupil.shape)
    phase = np.full((count, side, side), np.nan)
    amplitude = np.zeros(phase.shape)
    if isinstance(pupil, Pupil):
        common = pupil.illumination.at(rho**2) * (pupil.opening.margin(x, y) >= 0.0)
        if pupil.mask is not None:
            common = common * np.abs(pupil.mask.at(x, y))
        clear = common > 0.0
        amplitude[:] = common
        # Segments and masks have phases in addition to the wavefront.
        aperture_phase = pupil.opening.phase(x[clear], y[clear])
        if pupil.mask is not None:
            aperture_phase = aperture_phase + np.angle(pupil.mask.at(x[clear], y[clear]))
        phase[:, clear] = pupil.wavefront.phase(rho[clear], theta[clear]).reshape(count, -1) + aperture_phase
    elif isinstance(pupil, ObjectivePupil):
        clear = rho <= 1.0
        phase[:, clear], amplitude[:, clear] = _objective_maps(pupil, rho[clear], theta[clear])
    if clear.any():
        phase -= phase[:, clear].mean(axis=1)[:, None, None]
    return PupilMaps(phase, amplitude)


def _objective_maps(pupil: ObjectivePupil, rho: Array, theta: Array) -> tuple[Array, Array]:
    """Return phase and amplitude at points of an objective's pupil, shape (n, points) for the flattened stack."""
    layers = pupil.layers
    # The complex phase psi is linear in depth and focus; its imaginary part describes the decay of evanescent light.
    fixed, per_depth, per_focus = layers.rates(layers.cosine(rho))
    psi = (
        fixed + np.multiply.outer(pupil.depth.ravel(), per_depth) + np.multiply.outer(pupil.focus.ravel(), per_focus)
    )
    transmitted = layers.amplitudes(layers.cosine(rho), (layers.NA * rho) ** 2)
    amplitude = np.sqrt(0.5 * (np.abs(transmitted.s) ** 2 + np.abs(transmitted.p) ** 2))
    amplitude = amplitude * np.exp(-layers.apodization((layers.NA * rho) ** 2))
    phase = psi.real
    if pupil.aberrations is not None:
        phase = phase + pupil.aberrations.phase(rho, theta).reshape(-1, rho.size)
    return phase, amplitude * np.exp(-psi.imag)


def _drawable_maps(pupil: BasePupil, ax: Axes | None) -> PupilMaps:
    """Return the maps of the pupils to be drawn; ValueError for more than 64 pupils, or for a stack with `ax`."""
    validation.axes("ax", ax)
    drawing.only_single(ax, pupil.shape)
    count = math.prod(pupil.shape)
    drawing.at_most(pupil.shape)
    # Apertures that are not circular may have narrow vanes and gaps, which need larger images.
    side = _SIDE if pupil.circular else 2 * _SIDE
    return pupil_maps(pupil, side if count < 9 else side // 2)


def _phase(pupil: BasePupil, ax: Axes | None, unit: str, titles: list[str]) -> drawing.Drawn:
    """Draw the phase of a pupil, or of a stack of pupils with `titles`."""
    if unit == "nm" and pupil.wavelength is None:
        raise ValueError('unit="nm" needs a pupil with a wavelength, got one without; use "waves" or "radians"')
    radians_per_unit = 1.0 if unit == "radians" else 2.0 * math.pi
    if unit == "nm":
        radians_per_unit /= 1e9 * (pupil.wavelength or math.nan)
    values = _drawable_maps(pupil, ax).phase / radians_per_unit
    title = "phase minus its mean"
    if not pupil.shape and isinstance(pupil, Pupil) and not pupil.phase_mask:
        peak_to_valley = float(np.nanmax(values) - np.nanmin(values))
        rms_phase = float(rms(pupil)) / radians_per_unit
        title = f"rms {rms_phase:.3g} {unit}, peak to valley {peak_to_valley:.3g} {unit}"
    labels, norm = (title, f"phase minus its mean ({unit})"), drawing.even_norm(float(np.nanmax(np.abs(values))))
    return _draw(pupil, values, ax, labels, titles, cmap="RdBu_r", norm=norm)


def _draw(
    pupil: BasePupil, values: Array, ax: Axes | None, labels: tuple[str, str], titles: list[str], **imshow: Any
) -> drawing.Drawn:
    """Draw values across pupils, shape (n, side, side).

    `labels` are the title of the figure and the label of the colour bar; `titles` belong to the pupils in a stack.
    Other options are passed to `Axes.imshow`.
    """

    def draw_one(index: tuple[int, ...], axes: Axes) -> None:
        axes.imshow(values.reshape(*pupil.shape, *values.shape[1:])[index], extent=(-1, 1, 1, -1), **imshow)
        ticks = [-1, 0, 1]
        axes.set(facecolor=_BLOCKED, xticks=ticks, yticks=ticks, xlabel="x (pupil radii)", ylabel="y (pupil radii)")
        if isinstance(pupil, ObjectivePupil) and pupil.layers.sample < pupil.layers.NA:
            drawing.circle(axes, pupil.layers.sample / pupil.layers.NA, color="0.3", linewidth=0.8)

    if pupil.shape:
        return drawing.tiles(pupil.shape, draw_one, titles, *labels)
    axes = drawing.new_axes(ax)
    draw_one((), axes)
    if ax is None:
        drawing.caption(axes, *labels)
    return axes
