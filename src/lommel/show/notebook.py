"""Notebook display of objects: a table of numbers and, if matplotlib is installed, their plot.

A display must be fast and must not raise: large stacks are shown in part, and errors as messages.
"""

from __future__ import annotations

import base64
import math
from collections.abc import Callable, Sequence
from html import escape
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any

import numpy as np

from lommel.base import atomic, display
from lommel.base.arrays import Array, Numbers
from lommel.base.validation import brief
from lommel.measures.aperture_means import rms
from lommel.measures.energy import energy_per_pixel
from lommel.measures.psf_like import ColourPSFLike, PSFLike
from lommel.optics.base_pupil import BasePupil
from lommel.optics.layers.emitter import Emitter
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.lens import Lens
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.show import drawing
from lommel.show.plot import field, is_z_stack
from lommel.special import zernike

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.image import AxesImage

_TILES = 4  # largest number of members of a stack that are drawn
_MAX_VALUES = 2**21  # largest number of values of a stack for which all its PSFs are drawn and in the table
_TERMS = 8  # largest number of Zernike terms in the table
_DPI, _MAX_WIDTH = 64, 420  # pixels of the page per inch of a figure, and largest width of a picture

Row = tuple[str, str | Callable[[], str] | None]


@display.html.register(PSFLike)
def psf(psf: PSFLike) -> str:
    """Return the plot of a PSF, or of up to four PSFs of a stack, and a table of its properties."""
    stack, count = psf.pupil.shape, math.prod(psf.pupil.shape)
    is_complete = psf.values.size <= _MAX_VALUES
    labels = drawing.of_pupils(psf.pupil) if 1 < count <= 64 else []
    undersampled = "pixels are wider than λN: the sum of the values is not the light"

    def light() -> str:
        return _span(energy_per_pixel(psf).sum(axis=(-2, -1)), ".4g")

    rows: list[Row] = [
        ("stack", f"{labels[0]} to {labels[-1]}" if labels else None),
        ("pixels", _pixels(psf)),
        ("values", f"{psf.values.dtype}, {drawing.MEANING[psf.normalize]}"),
        ("largest value", (lambda: f"{float(psf.values.max()):.4g}") if is_complete else None),
        ("light in the window", light if is_complete else None),
        ("method", type(psf.method).__name__),
        ("error bound", "none" if psf.error_bound is None else f"{psf.error_bound:.2g} of the peak"),
        ("pupil", _light(psf.pupil)),
        ("note", None if psf.sum_is_light else undersampled),
    ]
    part = psf if is_complete and is_z_stack(psf) else _part(psf, stack)
    return device(_count("PSF", stack), rows, lambda: part)


def device(title: str, rows: Sequence[Row], image: Callable[[], Any]) -> str:
    """Return a table of `rows`, and the plot of the PSF or pupil that `image` returns."""
    return _html(title, rows, lambda: display.plot(image()))


def grid(thing: Any) -> str:
    """Return the plot of a PSFGrid, of several distances the first, and a table of its properties."""
    psf: PSFLike = thing.psf.psfs[len(thing.psf.psfs) // 2] if isinstance(thing.psf, ColourPSFLike) else thing.psf
    height, width = (_length(side, thing.unit) for side in thing.sensor)
    channels = ", ".join(thing.psf.channels.names) if isinstance(thing.psf, ColourPSFLike) else None
    table: list[Row] = [
        ("sensor", f"{height} × {width}"),
        ("distances", None if thing.depths is None else _places(thing.depths)),
        ("channels", channels),
        ("pixels of each", _pixels(psf)),
        ("values", f"{thing.values.dtype}, {drawing.MEANING[thing.psf.normalize]}"),
        ("method", type(psf.method).__name__),
        ("pupil", _light(thing.psf.pupil)),
    ]
    title = "PSFGrid, " + " × ".join(map(str, thing.values.shape[:2]))
    return _html(title, table, lambda: field(thing if thing.depths is None else thing.at_depth(0)))


@display.html.register(Wavefront)
def wavefront(thing: Wavefront) -> str:
    """Return the plot of the phase over the full disc, and a table of the rms and the largest terms."""
    rows: list[Row] = [*_rms(Pupil(thing)), *_terms(thing)]
    return device(_count("Wavefront", thing.shape), rows, lambda: _part(Pupil(thing), thing.shape))


@display.html.register(BasePupil)
def pupil(thing: Pupil | ObjectivePupil) -> str:
    """Return the plot of the phase across a pupil, and a table of its parameters."""
    rows: list[Row] = [("light", _light(thing))]
    if isinstance(thing, ObjectivePupil):
        rows += [("depth", _places(thing.depth)), ("stage", _places(thing.z)), ("emitter", emitter(thing.emitter))]
    else:
        rows += [("aperture", _aperture(thing)), ("Airy radius", _length(thing.airy_radius, thing.unit))]
        full = thing.circular and not thing.obscuration
        rows += [
            *_rms(thing),
            *_terms(thing.wavefront, "waves rms" if full else "waves rms over the full disc"),
        ]
    return device(_count(type(thing).__name__, thing.shape), rows, lambda: _part(thing, thing.shape))


@display.html.register(Lens)
def lens(thing: Lens) -> str:
    """Return the plot of the phase across the pupil for an object in focus, and a table of the lens's parameters."""
    rows: list[Row] = [
        ("focal length", _length(thing.focal_length, "m")),
        ("f-number", f"{thing.f_number:.4g}, working {thing.working_f_number:.4g}"),
        ("focused at", _length(thing.focus_distance, "m")),
        ("sensor", f"{_length(thing.sensor_distance, 'm')} behind the lens"),
        ("wavelength", _length(thing.wavelength, "m")),
        ("aperture", lambda: _aperture(thing._in_focus)),
        ("model", thing.model),
        *_terms(thing.aberrations),
    ]
    stack = thing.aberrations.shape
    return device(_count("Lens", stack), rows, lambda: _part(thing.pupil(), stack))


def retrieval(images: Array, model: Array, rows: Sequence[Row]) -> str:
    """Return a picture of the first image and its model, arrays (n, height, width), and a table of results."""

    def draw() -> drawing.Drawn:
        low = float(np.nanmin(images[0]))
        norm = drawing.norm_of("sqrt", np.nanmax(images[0]) - low)

        def draw_one(index: tuple[int, ...], axes: Axes) -> AxesImage:
            axes.set(facecolor="0.5", xticks=[], yticks=[])  # NaN is grey
            return axes.imshow((images, model)[index[0]][0] - low, cmap=drawing.COLOURS, norm=norm)

        label = drawing.bar_label("value above the lowest", "sqrt")
        return drawing.tiles((2,), draw_one, ["measured", "model"], "the first image and its model", label)

    return _html("Retrieval", rows, draw)


def _part(thing: Any, stack: tuple[int, ...]) -> Any:
    """Return a single PSF or pupil as it is, and of a stack up to four evenly spaced members along its last axis."""
    if not stack:
        return thing
    return thing[(*(side // 2 for side in stack[:-1]), slice(None, None, -(-stack[-1] // _TILES)))]


def _html(title: str, rows: Sequence[Row], draw: Callable[[], drawing.Drawn]) -> str:
    """Return HTML of a table and a plot; an error in either is shown as its message."""
    cells = "".join(
        f'<tr><th style="text-align:left">{escape(name)}</th><td style="text-align:left">{_cell(content)}</td></tr>'
        for name, content in rows
        if content is not None
    )
    picture = "" if find_spec("matplotlib") is None else _cell(lambda: _image(draw), markup=True)
    return (
        '<div style="display:flex;gap:1em;align-items:flex-start;background:transparent;color:currentColor">'
        f'<div style="text-align:center"><b>{escape(title)}</b><br>{picture}</div>'
        f'<table style="background:transparent;color:currentColor">{cells}</table></div>'
    )


def _image(draw: Callable[[], drawing.Drawn]) -> str:
    """Return what `draw` draws in a new figure as an HTML picture, which is sharp on screens of high resolution."""
    pyplot = drawing.pyplot()
    with pyplot.ioff():  # the notebook shows the picture, not also the figure
        figure = drawing.figure_of(np.asarray(draw(), dtype=object).flat[0])
    data = atomic.contents(figure.savefig, format="png", dpi=1.5 * _DPI)
    pyplot.close(figure)
    width = min(round(_DPI * figure.get_figwidth()), _MAX_WIDTH)
    return f'<img alt="plot" style="width:{width}px" src="data:image/png;base64,{base64.b64encode(data).decode()}">'


def _cell(content: str | Callable[[], str], *, markup: bool = False) -> str:
    try:
        text = content if isinstance(content, str) else content()
    except Exception as error:  # any error: show its message, and the other cells
        return f"<i>{escape(brief(' '.join(str(error).split()) or type(error).__name__))}</i>"
    return text if markup else escape(brief(text, 160))


def emitter(thing: Emitter) -> str:
    """Return a description of an emitter, with the degree sign."""
    return drawing.of_emitter(thing).replace(" deg", "°")


def _terms(wavefront: Wavefront, unit: str = "waves rms") -> list[Row]:
    """Return rows of the eight largest Zernike terms, waves rms, for a stack as the range of its values."""
    edge = wavefront.edge_terms()
    sizes = {t: float(np.abs(c).max()) for t, c in edge.items() if np.any(c)}
    sorted_terms = sorted(sizes, key=lambda t: sizes[t] / zernike.rms_factor(*t), reverse=True)
    rows: list[Row] = []
    for n, m in sorted_terms[:_TERMS]:
        size = _span(edge[n, m] / (2.0 * math.pi * zernike.rms_factor(n, m)), ".3g")
        rows.append((zernike.name(n, m), f"{size} {unit}"))
    if len(sorted_terms) > _TERMS:
        rows.append(("and", f"{len(sorted_terms) - _TERMS} smaller terms"))
    return rows


def _rms(thing: Pupil) -> list[Row]:
    """Return a row of the rms for uniform full discs, or for small stacks of discs or annuli with few terms."""
    wave = thing.wavefront
    if thing.circular and not thing.obscuration and thing.illumination.uniform:
        factors = np.array([zernike.rms_factor(*term) for term in wave.terms])
        return [("rms", f"{_span(np.linalg.norm(wave.edge / factors, axis=-1) / (2.0 * math.pi), '.3g')} waves")]
    if thing.circular and math.prod(thing.shape) * len(wave.terms) ** 2 <= 256:
        name = "rms over the clear aperture" if thing.obscuration else "rms"
        return [(name, lambda: f"{_span(rms(thing, unit='waves'), '.3g')} waves")]
    return []


def _pixels(psf: PSFLike) -> str:
    height, width = psf.shape[-2:]
    magnification = psf.pupil.magnification if isinstance(psf.pupil, ObjectivePupil) else 1.0
    size = " × ".join(dict.fromkeys(_length(side / magnification, psf.unit) for side in psf.grid.pitch))
    size += " in the sample" if psf.pupil.layered else ""
    blurs = "".join(f", {type(blur).__name__}" for blur in psf.blur)
    return f"{height} × {width} of {size}, {drawing.SAMPLING[psf.sampling]}{blurs}"


def _aperture(pupil: Pupil) -> str:
    parts = [name for name in ("spider", "vignetting", "mask", "stop") if getattr(pupil, name) is not None]
    parts = ["apodized", *parts] if not pupil.illumination.uniform else parts
    eps = f"obscured to {pupil.obscuration:.4g}" if pupil.obscuration else "clear disc"
    return ", ".join([eps, *parts])


def _light(pupil: BasePupil) -> str:
    if pupil.wavelength is None:
        return "lengths in λN"
    aperture = f"NA {pupil.layers.NA:.4g}" if isinstance(pupil, ObjectivePupil) else f"f/{pupil.f_number:.4g}"
    return f"{_length(pupil.wavelength, 'm')}, {aperture}"


def _length(value: float, unit: str) -> str:
    return drawing.length_in_words(float(value)) if unit == "m" else f"{value:.4g} λN"


def _places(positions: Array) -> str:
    low, high = float(positions.min()), float(positions.max())
    return _length(low, "m") if low == high else f"{_length(low, 'm')} to {_length(high, 'm')}"


def _span(values: Numbers, form: str) -> str:
    low, high = float(np.min(values)), float(np.max(values))
    return format(low, form) if low == high else f"{low:{form}} to {high:{form}}"


def _count(name: str, shape: tuple[int, ...]) -> str:
    return f"{name}, a stack of {' × '.join(map(str, shape))}" if shape else name
