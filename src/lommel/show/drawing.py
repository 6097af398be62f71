"""Labels, units, brightness scales, figures and axes that all plots share."""

from __future__ import annotations

import math
import re
import textwrap
from collections.abc import Callable
from types import ModuleType
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array, Values
from lommel.base.optional import library
from lommel.base.units import format_length
from lommel.optics.base_pupil import BasePupil
from lommel.optics.layers.emitter import Dipole, Emitter, Scalar
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.special import zernike

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.colors import Normalize
    from matplotlib.figure import Figure


def of_pupils(pupil: BasePupil) -> list[str]:
    """Return a label for each pupil of the flattened stack: the object distance, depth and z, or a coefficient."""
    if isinstance(pupil, ObjectivePupil):
        places = {"depth": pupil.depth, "z": pupil.z}
        varying_labels = [_lengths(f"{name} ", values.ravel()) for name, values in places.items() if np.ptp(values)]
        if varying_labels:
            return [", ".join(parts) for parts in zip(*varying_labels, strict=True)]
    if isinstance(pupil, Pupil):
        distances = () if pupil.geometry is None else pupil.geometry.object_distance
        if len(set(distances)) > 1:
            return _lengths("object at ", np.array(distances))
        return of_wavefronts(pupil.wavefront)
    return _indices(pupil.shape)


def of_wavefronts(wavefront: Wavefront) -> list[str]:
    """Return a label for each wavefront of the flattened stack: a coefficient if only one varies, else an index."""
    flattened = wavefront.flattened()
    powers = flattened.coefficients
    nonradial_edge = flattened.edge[:, flattened.symmetric :]
    radial, nonradial = (np.flatnonzero(np.ptp(part, axis=0)) for part in (powers, nonradial_edge))
    if radial.size == 1 and not nonradial.size and radial[0] < 2:
        name, values = (("W020", 2.0 * flattened.defocus), ("W040", flattened.spherical))[radial[0]]
    elif nonradial.size == 1 and not radial.size:
        return _term_labels(flattened, flattened.symmetric + int(nonradial[0]))
    else:
        varying = np.flatnonzero(np.ptp(flattened.edge, axis=0))
        if varying.size != 1:
            return _indices(wavefront.shape)
        return _term_labels(flattened, int(varying[0]))
    numbers = [f"{value / (2.0 * math.pi) + 0.0:.3g}" for value in values]
    return [true_minus(f"{name} {text} {'wave' if text in ('1', '-1') else 'waves'}") for text in numbers]


def _term_labels(wavefront: Wavefront, column: int) -> list[str]:
    n, m = wavefront.terms[column]
    waves = wavefront.edge[:, column] / (2.0 * math.pi * zernike.rms_factor(n, m)) + 0.0
    return [f"{zernike.name(n, m)} {true_minus(f'{value:.3g}')} waves rms" for value in waves]


def _lengths(prefix: str, values: Array) -> list[str]:
    """Return lengths as texts in one unit, which suits the largest finite length; each begins with `prefix`."""
    finite = np.abs(values[np.isfinite(values)])
    like = float(finite.max()) if finite.size else None
    return [f"{prefix}{length_in_words(length + 0.0, like=like)}" for length in values.tolist()]


def length_in_words(metres: float, like: float | None = None) -> str:
    """Return a length as a text for figures, in a suitable unit, or in a unit that suits the length `like`."""
    return true_minus(format_length(metres, like=like).replace(" um", " µm").replace("infinity", "∞"))


def of_emitter(emitter: Emitter) -> str:
    """Return a description of an emitter or of an excitation beam."""
    if isinstance(emitter, Dipole):
        if emitter.wobble == 1.0:
            return "freely rotating dipole"
        polar, azimuth = math.degrees(emitter.polar), math.degrees(emitter.azimuth)
        wobble = f", wobble {emitter.wobble:.4g}" if emitter.wobble else ""
        return f"dipole, {polar:.4g} deg from the axis, azimuth {azimuth:.4g} deg{wobble}"
    if isinstance(emitter, Scalar):
        return "scalar (Gibson-Lanni)"
    return f"beam focused into the sample, {emitter.polarization} polarization"


def true_minus(text: str) -> str:
    """Return a text with hyphens replaced by minus signs, as in the tick labels of axes."""
    return text.replace("-", "−")


def name_in_words(name: str) -> str:
    """Return the name of a lens for figures, with um replaced by µm."""
    return re.sub(r"(?<=\d )um\b", "µm", name)


def _indices(shape: tuple[int, ...]) -> list[str]:
    return [", ".join(map(str, index)) for index in np.ndindex(shape)]


def evenly_spaced_members(shape: tuple[int, ...], most: int) -> dict[int, tuple[int, ...]]:
    """Return at most `most` evenly spaced members of a stack: flattened index -> index into the stack."""
    count = math.prod(shape)
    members = range(count) if count <= most else [round(k * (count - 1) / (most - 1)) for k in range(most)]
    return {member: tuple(int(i) for i in np.unravel_index(member, shape)) for member in members}


MEANING = {
    "energy": "fraction of all light per pixel",
    "emitted": "light per pixel / light collected from an emitter far from the glass",
    "strehl": "1 = unaberrated peak",
    "peak": "1 = largest value",
}
"""Meaning of a value, by :attr:`lommel.PSF.normalize`."""

SAMPLING = {"pixel": "averaged over each pixel", "center": "sampled at pixel centres"}
"""Relation of values to their pixels, by :attr:`lommel.PSF.sampling`."""

USER = ("plots need", "plot")
"""Beginning of the message for a missing library, and the name of the extra that installs it."""

STRETCHES = {
    "sqrt": "the square root of the value",
    "linear": "the value",
    "log": "the logarithm of the value,\ndown to 1e-5 of the largest",
}
"""Brightness scales: the quantity to which brightness is proportional, by the name of the scale."""

_BAR_NOTES = {"sqrt": "\n(colours: square root)", "linear": "", "log": "\n(colours: logarithm)"}


def bar_label(meaning: str, stretch: str) -> str:
    """Return the label of a colour bar, with a note if the scale is not linear."""
    return meaning + _BAR_NOTES[stretch]


COLOURS = "inferno"
"""Colour map of light, also used by the live page."""

MAX_PICTURES = 64
"""Largest number of pictures in one figure."""

Drawn: TypeAlias = "Axes | NDArray[np.object_]"
"""Axes of one picture, or an array with the axes of each picture of a stack."""

_FLOOR = 1e-5  # lower end of logarithmic scales, relative to the peak


def norm_of(stretch: str, values: Values) -> Normalize:
    """Return the brightness scale from 0 ("log": 1e-5 of the upper end) to the largest value, or to 1 if it is 0."""
    library("matplotlib", *USER)
    from matplotlib import colors

    peak = float(np.max(values)) or 1.0
    if stretch == "log":
        return colors.LogNorm(_FLOOR * peak, peak, clip=True)
    return colors.PowerNorm(0.5, 0.0, peak) if stretch == "sqrt" else colors.Normalize(0.0, peak)


def even_norm(largest: float) -> Normalize:
    """Return the linear scale from -largest to largest for signed values; from -1 to 1 if `largest` is 0."""
    library("matplotlib", *USER)
    from matplotlib.colors import Normalize

    return Normalize(-(largest or 1.0), largest or 1.0)


def stretched(light: Values, stretch: str) -> NDArray[np.float64]:
    """Return the brightness, 0 to 1, of values from 0 to 1 on a brightness scale."""
    if stretch == "log":
        return np.asarray(1.0 - np.log10(np.maximum(light, _FLOOR)) / np.log10(_FLOOR))
    return np.asarray(np.sqrt(light) if stretch == "sqrt" else light, dtype=np.float64)


def pyplot() -> ModuleType:
    """Return ``matplotlib.pyplot``; ImportError if it is not installed."""
    return library("matplotlib.pyplot", *USER)


def new_figure(size: tuple[float, float] | None = None, layout: str = "constrained") -> Figure:
    """Return a new figure of this width and height, inches, with margins around labels and between axes."""
    figure: Figure = pyplot().figure(figsize=size, layout=layout)
    figure.get_layout_engine().set(w_pad=0.08, h_pad=0.08)  # type: ignore[union-attr, call-arg]
    return figure


def new_axes(ax: Axes | None, size: tuple[float, float] | None = None) -> Axes:
    """Return `ax`, or if it is None the axes of a new figure of this width and height, inches."""
    return new_figure(size).subplots() if ax is None else ax


_PICTURE_SIDE = 3.9  # longer side of a picture, inches
_EXTRA_WIDTH, _EXTRA_HEIGHT = 2.5, 0.9  # space for the colour bar with labels, and for title and x labels, inches


def picture_axes(ax: Axes | None, height: float, width: float) -> Axes:
    """Return `ax`, or the axes of a new figure for a picture of the aspect ratio height : width with a colour bar."""
    inch = _PICTURE_SIDE / max(height, width)
    size = max(inch * width, 0.5) + _EXTRA_WIDTH, max(inch * height + _EXTRA_HEIGHT, 2.6)
    return new_figure(size, "compressed").subplots() if ax is None else ax


def lengths(unit: str) -> tuple[float, str]:
    """Return (1) the factor from lengths in the `unit` of a pupil to drawn lengths, and (2) their unit."""
    return (1e6, "µm") if unit == "m" else (1.0, "λN")


def frequencies(unit: str) -> tuple[float, str]:
    """Return (1) the factor from cycles per `unit` to drawn frequencies, and (2) their unit."""
    return (1e-3, "cycles/mm") if unit == "m" else (1.0, "cycles/λN")


def only_single(ax: Axes | None, shape: tuple[int, ...]) -> None:
    """Raise ValueError if `ax` is passed for a stack, which needs several axes."""
    if ax is not None and shape != ():
        raise ValueError(f"ax must be None for a stack, which needs several axes, got a stack of shape {shape}")


def at_most(shape: tuple[int, ...]) -> None:
    """Raise ValueError for a stack that is too large for one figure."""
    if int(np.prod(shape)) > MAX_PICTURES:
        raise ValueError(
            f"at most {MAX_PICTURES} pictures can be drawn, got a stack of shape {shape}; index it, as in stack[:8]"
        )


def round_length(limit: float) -> float:
    """Return the largest number of the form 1, 2 or 5 times a power of ten that is at most `limit`."""
    decade = 10.0 ** np.floor(np.log10(limit))
    return float(max(k * decade for k in (1.0, 2.0, 5.0) if k * decade <= limit * (1.0 + 1e-12)))


def figure_of(artist: Figure | Axes) -> Figure:
    """Return the figure that contains axes or a subfigure."""
    figure = artist.get_figure(root=True)
    assert figure is not None
    return figure


def fit_to_width(text: str, artist: Figure | Axes, size: float = 9.0) -> str:
    """Return a title broken between words into lines that fit the figure's width, for a font size in points."""
    figure = figure_of(artist)
    letters = int(72.0 * figure.get_figwidth() / (0.56 * size))
    return "\n".join(textwrap.fill(line, letters) for line in text.split("\n"))


def entitle(figure: Figure, text: str) -> None:
    """Set the title of a figure, broken into lines that fit its width."""
    figure.suptitle(fit_to_width(text, figure), fontsize=9)


def circle(axes: Axes, radius: float, **style: Any) -> None:
    """Draw a dashed circle about the origin; `style` holds options of `Axes.plot`."""
    angle = np.linspace(0.0, 2.0 * np.pi, 181)
    axes.plot(radius * np.cos(angle), radius * np.sin(angle), "--", **style)


def only_outer(axes: Axes, k: int, count: int, columns: int) -> None:
    """Remove the labels of picture `k` of `count`, except y labels in the first column and x labels at the bottom."""
    if k % columns:
        axes.set(ylabel="", yticklabels=[])
    if k + columns < count:
        axes.set(xlabel="", xticklabels=[])


def caption(axes: Axes, title: str, label: str) -> None:
    """Set the title of a picture and add a colour bar with a label."""
    axes.set_title(fit_to_width(title, axes), fontsize=9)
    axes.figure.colorbar(axes.images[-1], ax=axes).set_label(label, fontsize=9)


def complete_curves(
    axes: Axes,
    title: str | None,
    xlim: tuple[float, float],
    loc: Literal["best", "lower right"] = "best",
    **labels: str,
) -> None:
    """Add labels, limits, a grid, a legend and a title (unless None) to curves of values from 0 to 1."""
    axes.set(xlim=xlim, ylim=(0.0, 1.05), **labels)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8, loc=loc)
    if title is not None:
        axes.set_title(fit_to_width(title, axes), fontsize=9)


def tiles(
    shape: tuple[int, ...],
    draw: Callable[[tuple[int, ...], Axes], object],
    titles: list[str],
    title: str,
    label: str | None = None,
) -> NDArray[np.object_]:
    """Draw the members of a stack in a new figure, with a `label` with one colour bar.

    ``draw(index, axes)`` draws one member.
    """
    at_most(shape)
    count = int(np.prod(shape))
    rows = shape[0] if len(shape) == 2 else -(-count // 8)
    columns = -(-count // rows)
    figure = new_figure((max(min(2.0 * columns, 14.0) + 1.2, 4.4), 2.0 * rows + 0.8))
    all_axes = np.empty(shape, dtype=object)
    for k, index in enumerate(np.ndindex(shape)):
        axes = all_axes[index] = figure.add_subplot(rows, columns, k + 1)
        draw(index, axes)
        axes.set_title(titles[k], fontsize=8)
        axes.tick_params(labelsize=7)
        only_outer(axes, k, count, columns)
    entitle(figure, title)
    if label is not None:
        bar = figure.colorbar(axes.images[0], ax=all_axes.ravel().tolist())
        bar.set_label(label, fontsize=8)
        bar.ax.tick_params(labelsize=7)
    return all_axes
