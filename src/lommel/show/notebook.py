"""Notebook display of objects: a table of numbers and, if matplotlib is installed, a small picture.

A display must be fast and must not raise: large stacks and windows are shown in part, and errors as messages.
"""

from __future__ import annotations

import base64
import io
import math
from collections.abc import Callable, Sequence
from html import escape
from importlib.util import find_spec

import numpy as np

from lommel.base import display
from lommel.base.arrays import Array, Numbers
from lommel.base.validation import brief
from lommel.measures.aperture_means import rms
from lommel.measures.energy import energy_per_pixel
from lommel.measures.psf_like import ColourPSFLike, PSFGridLike, PSFLike
from lommel.optics.base_pupil import BasePupil
from lommel.optics.layers.emitter import Emitter
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.lens import Lens
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.show import drawing
from lommel.show.pupils import pupil_maps
from lommel.special import zernike

_TILES = 4  # largest number of images of a stack that are shown
_WINDOW = 1024  # largest side, in pixels, of the part of a PSF about the axis that is drawn
_MAX_VALUES = 2**21  # largest number of values of a stack for which the table covers all its PSFs
_TERMS = 8  # largest number of Zernike terms in the table
_SIDE = 160  # side of a picture, pixels
_RASTER = 80  # largest number of samples along a side of a phase map
_ROOT = "the square root of the values"
_SUMS = 100 * _RASTER**2  # approximate largest number of terms times samples of phase maps

Row = tuple[str, str | Callable[[], str] | None]


@display.html.register(PSFLike)
def psf(psf: PSFLike) -> str:
    """Return a picture of a PSF, or of up to four PSFs of a stack, and a table of its properties."""
    stack, count = psf.pupil.shape, math.prod(psf.pupil.shape)
    windows = [_window(psf, index) for index in drawing.evenly_spaced_members(stack, _TILES).values()]
    is_complete = psf.values.size <= _MAX_VALUES
    values = psf.values if is_complete else np.stack(windows)
    note = "" if is_complete else " of some PSFs"
    labels = drawing.of_pupils(psf.pupil) if 1 < count <= 64 else []
    undersampled = "pixels are wider than λN: the sum of the values is not the light"

    def light() -> str:
        return _span(energy_per_pixel(psf).sum(axis=(-2, -1)), ".4g")

    rows: list[Row] = [
        ("stack", f"{labels[0]} to {labels[-1]}" if labels else None),
        ("pixels", _pixels(psf)),
        ("values", f"{psf.values.dtype}, {drawing.MEANING[psf.normalize]}"),
        (f"largest value{note}", lambda: f"{float(values.max()):.4g}"),
        ("light in the window", light if is_complete else None),
        ("method", type(psf.method).__name__),
        ("error bound", "none" if psf.error_bound is None else f"{psf.error_bound:.2g} of the peak"),
        ("pupil", _light(psf.pupil)),
        ("note", None if psf.sum_is_light else undersampled),
    ]

    def picture() -> str:
        most = 160 if len(windows) == 1 else 110
        parts = [_smaller(part, most) for part in windows]
        pitch = _pitch(psf, windows[0], parts[0])
        return _joined_pictures([_brightness(part) for part in parts], drawing.COLOURS, _ROOT, pitch, psf.unit)

    caption = "square root" + (", each / its largest value" if len(windows) > 1 else "")
    return _html(_count("PSF", stack), rows, picture, caption)


def device(title: str, rows: Sequence[Row], image: Callable[[], PSFLike]) -> str:
    """Return a table of `rows`, and a picture of the PSF that `image` computes."""

    def picture() -> str:
        psf = image()
        return _joined_pictures(
            [_brightness(psf.values)], drawing.COLOURS, _ROOT, _pitch(psf, psf.values, psf.values), psf.unit
        )

    return _html(title, rows, picture, "its PSF, square root")


def grid(thing: PSFGridLike) -> str:
    """Return a picture of a grid of PSFs, each divided by its largest value, and a table of its properties."""
    rows, columns = thing.values.shape[:2]
    psf: PSFLike = thing.psf.psfs[len(thing.psf.psfs) // 2] if isinstance(thing.psf, ColourPSFLike) else thing.psf
    first_depth = () if thing.depths is None else (0,)

    def picture() -> str:
        at_rows, at_columns = (
            drawing.evenly_spaced(list(range(rows)), 5),
            drawing.evenly_spaced(list(range(columns)), 7),
        )
        windows = [[_window(psf, (i, j, *first_depth)) for j in at_columns] for i in at_rows]
        parts = [[_brightness(_smaller(part, 48)) for part in line] for line in windows]
        values = np.concatenate([np.concatenate(line, axis=1) for line in parts])
        pitch = _pitch(psf, windows[0][0], parts[0][0])
        description = "square roots of the values, each PSF divided by its largest value"
        return _image(values, drawing.COLOURS, description, 280) + _bar(
            pitch, parts[0][0].shape[1], 280 / max(values.shape), psf.unit
        )

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
    return _html(f"PSFGrid, {rows} × {columns}", table, picture, "square root, each / its largest value")


@display.html.register(Wavefront)
def wavefront(thing: Wavefront) -> str:
    """Return a picture of the phase over the full disc, and a table of the rms and the largest terms."""
    rows: list[Row] = [*_rms(Pupil(thing)), *_terms(thing)]
    return _html(_count("Wavefront", thing.shape), rows, lambda: _phase(Pupil(thing)), _PHASE)


@display.html.register(BasePupil)
def pupil(thing: Pupil | ObjectivePupil) -> str:
    """Return a picture of the phase across a pupil, and a table of its parameters."""
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
    return _html(_count(type(thing).__name__, thing.shape), rows, lambda: _phase(thing), _PHASE)


@display.html.register(Lens)
def lens(thing: Lens) -> str:
    """Return a picture of the phase across the pupil for an object in focus, and a table of the lens's parameters."""
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
    return _html(_count("Lens", thing.aberrations.shape), rows, lambda: _phase(thing.pupil()), f"{_PHASE}, in focus")


def retrieval(images: Array, model: Array, rows: Sequence[Row]) -> str:
    """Return a picture of the first image and its model, arrays (n, height, width), and a table of results."""

    def picture() -> str:
        low, high = np.nanmin(images[0]), np.nanmax(images[0])
        pair = [np.sqrt(np.clip((part - low) / ((high - low) or 1.0), 0.0, 1.0)) for part in (images[0], model[0])]
        return _joined_pictures(
            [_smaller(part) for part in pair], drawing.COLOURS, "the first image as measured, and its model"
        )

    return _html("Retrieval", rows, picture, "measured, and the model")


_PHASE = "phase, blue to red"


def _phase(pupil: BasePupil) -> str:
    members = list(drawing.evenly_spaced_members(pupil.shape, _TILES).values())
    # The time is proportional to terms times samples: use fewer samples for many terms.
    terms = len(pupil.wavefront.terms) if isinstance(pupil, Pupil) else 1
    side = min(_RASTER, max(16, math.isqrt(_SUMS // (terms * len(members)))))
    phases = [pupil_maps(pupil[index] if pupil.shape else pupil, side).phase[0] for index in members]
    top = max(float(np.nanmax(np.abs(part), initial=0.0)) for part in phases) or 1.0
    return _joined_pictures([0.5 + 0.5 * part / top for part in phases], "RdBu_r", "the phase across the pupil")


def _html(title: str, rows: Sequence[Row], picture: Callable[[], str], caption: str) -> str:
    """Return HTML of a table and a picture with a caption; an error in either is shown as its message."""
    cells = "".join(
        f'<tr><th style="text-align:left">{escape(name)}</th><td style="text-align:left">{_cell(content)}</td></tr>'
        for name, content in rows
        if content is not None
    )
    picture_html = ""
    if find_spec("matplotlib") is not None:
        picture_html = f"<br>{_cell(picture, markup=True)}<br><small>{escape(caption)}</small>"
    return (
        '<div style="display:flex;gap:1em;align-items:flex-start;background:transparent;color:currentColor">'
        f'<div style="text-align:center"><b>{escape(title)}</b>{picture_html}</div>'
        f'<table style="background:transparent;color:currentColor">{cells}</table></div>'
    )


def _cell(content: str | Callable[[], str], *, markup: bool = False) -> str:
    try:
        text = content if isinstance(content, str) else content()
    except Exception as error:  # any error: show its message, and the other cells
        return f"<i>{escape(brief(' '.join(str(error).split()) or type(error).__name__))}</i>"
    return text if markup else escape(brief(text, 160))


def _window(psf: PSFLike, index: tuple[int, ...]) -> Array:
    """Return the values of one PSF of a stack, for a large window only the part about the axis."""
    values = psf.values[index]
    center = psf.grid[index].axis if psf.grid.stack else psf.grid.axis
    parts = []
    for side, middle in zip(values.shape, center, strict=True):
        start = min(max(round(middle) - _WINDOW // 2, 0), max(side - _WINDOW, 0))
        parts.append(slice(start, start + _WINDOW))
    return np.asarray(values[tuple(parts)], dtype=np.float64)


def _brightness(values: Array) -> Array:
    """Return the square root of (values / largest value)."""
    return np.asarray(np.sqrt(np.clip(values / (float(values.max()) or 1.0), 0.0, 1.0)))


def emitter(thing: Emitter) -> str:
    """Return a description of an emitter, with the degree sign."""
    return drawing.of_emitter(thing).replace(" deg", "°")


def _sample_scale(psf: PSFLike) -> float:
    """Return the factor that converts lengths on a microscope's camera to the sample; 1 for lenses."""
    return 1.0 / psf.pupil.magnification if isinstance(psf.pupil, ObjectivePupil) else 1.0


def _pitch(psf: PSFLike, values: Array, smaller: Array) -> float:
    """Return the pitch of the columns of `smaller`, which holds averages of `values`; metres or lambda*N."""
    return float(psf.grid.pitch[1] * _sample_scale(psf)) * int(values.shape[1] // smaller.shape[1])


def _bar(pitch: float, columns: int, column_width: float, unit: str) -> str:
    """Return a scale bar below a picture, at most half as wide; a column is `column_width` screen pixels wide."""
    length = drawing.round_length(0.5 * columns * pitch)
    style = f"width:{length / pitch * column_width:.1f}px;border-top:3px solid currentColor;margin:4px auto 0"
    return f'<div style="{style}"></div><small>{escape(_length(length, unit))}</small>'


def _joined_pictures(parts: Sequence[Array], cmap: str, description: str, pitch: float = 0.0, unit: str = "m") -> str:
    """Return pictures side by side (four pictures in two rows), separated by transparent pixels.

    A scale bar is added if `pitch`, the pitch of their columns, is not 0.
    """

    def with_scale_bar(values: Array, side: int) -> str:
        bar = _bar(pitch, parts[0].shape[1], side / max(values.shape), unit) if pitch else ""
        return _image(values, cmap, description, side) + bar

    if len(parts) == 1:
        return with_scale_bar(parts[0], _SIDE)
    gap = max(1, max(parts[0].shape) // 40)
    edge = ((0, gap), (0, gap))
    lines = [parts[:2], parts[2:]] if len(parts) == _TILES else [parts]
    rows = [np.concatenate([np.pad(part, edge, constant_values=np.inf) for part in line], axis=1) for line in lines]
    return with_scale_bar(np.concatenate(rows), 110 * len(lines[0]))


def _smaller(values: Array, max_side: int = _SIDE) -> Array:
    """Return means over the smallest squares of pixels for which no side of the result exceeds `max_side`."""
    tile_side = -(-max(values.shape) // max_side)
    height, width = (max(side // tile_side, 1) for side in values.shape)
    parts = values[: height * tile_side, : width * tile_side]
    tile_height, tile_width = (min(tile_side, side) for side in parts.shape)
    return np.asarray(parts.reshape(height, tile_height, width, tile_width).mean(axis=(1, 3)))


def _image(values: Array, cmap: str, description: str, side: int) -> str:
    """Return an HTML picture of values from 0 to 1 with a longer side of `side` pixels.

    NaN is grey, infinity transparent, and `description` is the text for screen readers.
    """
    import matplotlib as mpl
    from matplotlib.image import imsave

    # Translucent grey is visible on light and on dark pages.
    colours = mpl.colormaps[cmap].with_extremes(bad=(0.5, 0.5, 0.5, 0.275), over=(0.0, 0.0, 0.0, 0.0))
    data = io.BytesIO()
    imsave(data, colours(values), format="png")
    height, width = (max(round(side * size / max(values.shape)), 1) for size in values.shape)
    encoded = base64.b64encode(data.getvalue()).decode()
    style = f"width:{width}px;height:{height}px;image-rendering:pixelated"
    return f'<img alt="{description}" style="{style}" src="data:image/png;base64,{encoded}">'


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
    size = " × ".join(dict.fromkeys(_length(side * _sample_scale(psf), psf.unit) for side in psf.grid.pitch))
    size += " in the sample" if isinstance(psf.pupil, ObjectivePupil) else ""
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
