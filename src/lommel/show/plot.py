"""Plots of PSFs, z stacks, PSF grids, spot diagrams and differences between PSFs."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import display, validation
from lommel.base.arrays import Array, Values
from lommel.base.optional import library
from lommel.measures.aperture_means import slopes, spot_radius
from lommel.measures.errors import mse, peak_error
from lommel.measures.psf_like import ColourPSFLike, PSFGridLike, PSFLike, checked, colours, is_psf
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.pupil import Pupil
from lommel.optics.pupil import checked as checked_pupil
from lommel.show import drawing
from lommel.show.curves import focus_curves, mtf, through_focus

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.colors import Normalize
    from matplotlib.figure import Figure

__all__ = ["difference", "focus_curves", "mtf", "through_focus"]

_MAX_RATIO = 3.0  # largest ratio of the sides of a z stack that are drawn on one length scale
_SIDE = 3.4  # length of the longest drawn side, inches


class Voxels(NamedTuple):
    """Values of a z stack and their positions, micrometres: x and y in the sample, increasing z of the stage."""

    x: Array
    y: Array
    z: Array
    values: Values


def is_z_stack(psf: PSFLike) -> bool:
    """Return True for a microscope's PSF with increasing or decreasing z and the same optical axis in all planes."""
    pupil = psf.pupil
    if not isinstance(pupil, ObjectivePupil) or len(pupil.shape) != 1 or pupil.z.size < 2 or psf.grid.stack:
        return False
    steps = np.diff(pupil.z)
    return bool((steps > 0.0).all() or (steps < 0.0).all())


def voxels(psf: PSFLike) -> Voxels:
    """Return the values of a z stack and their positions, in the order of increasing z."""
    pupil: Any = psf.pupil
    order = slice(None, None, 1 if pupil.z[-1] > pupil.z[0] else -1)
    size = 1e6 / pupil.magnification
    return Voxels(psf.grid.x * size, psf.grid.y * size, 1e6 * pupil.z[order], np.maximum(psf.values[order], 0.0))


def sections(psf: PSFLike, *, stretch: str = "sqrt") -> NDArray[np.object_]:
    """Draw the sections xy, yz (right of xy) and xz (below xy) through the brightest voxel of a z stack.

    Surroundings that are dark in all sections are cropped.

    Parameters
    ----------
    psf : PSF
        PSF of a microscope, a stack along one axis with increasing or decreasing z.
    stretch : {"sqrt", "linear", "log"}
        Brightness scale of the values.

    Returns
    -------
    ndarray of three matplotlib Axes
        xy, xz and yz. All sections share one brightness scale, and one length scale unless their sides differ by more
        than a factor of three.

    Raises
    ------
    ImportError
        If matplotlib is not installed.
    """
    x, y, z, values = voxels(psf)
    plane, row, column = (int(k) for k in np.unravel_index(int(values.argmax()), values.shape))
    levels = values[plane], values[:, row], values[:, :, column].T  # of xy, xz and yz
    limits = _limits((x, y, z), levels, stretch)
    lengths = [last - first for first, last in limits]
    is_cropped = any(length < np.ptp(_edges(positions)) for length, positions in zip(lengths, (x, y, z), strict=True))
    longest = max(lengths)
    width, height, depth = (max(length, longest / _MAX_RATIO) for length in lengths)
    inch = _SIDE / longest
    figure = drawing.new_figure((inch * (width + depth) + 1.9, inch * (height + depth) + 1.3), "compressed")
    grid = figure.subplots(2, 2, width_ratios=(width, depth), height_ratios=(height, depth))
    xy, yz, xz, empty = grid.flat
    empty.set_axis_off()
    norm = drawing.norm_of(stretch, values)
    x_text = drawing.true_minus(f"{x[column] + 0.0:.3g}")
    scales = [inch * side / length for side, length in zip((width, height, depth), lengths, strict=True)]
    places = f"z = {drawing.true_minus(f'{z[plane]:.4g}')}", f"y = {drawing.true_minus(f'{y[row] + 0.0:.3g}')}"
    for axes, level, (i, j), name, place in (
        (xy, levels[0], (0, 1), "xy", places[0]),
        (xz, levels[1], (0, 2), "xz", places[1]),
        (yz, levels[2], (2, 1), "yz", f"x = {x_text}"),
    ):
        u, v = ((x, y, z)[k] for k in (i, j))
        mesh = axes.pcolormesh(_edges(u), _edges(v), level, norm=norm, cmap=drawing.COLOURS, rasterized=True)
        axes.set_title(f"{name} at {place} µm", fontsize=9)
        axes.set(aspect=scales[j] / scales[i], facecolor="black", xlim=limits[i], ylim=limits[j])
    for axes in (xy, yz):
        axes.invert_yaxis()  # rows, from the top
    xy.set_ylabel("y in the sample (µm)")
    xz.set(xlabel="x in the sample (µm)", ylabel="z of the stage (µm)")
    yz.set(xlabel="z of the stage (µm)", yticklabels=[])
    locator = library("matplotlib.ticker", *drawing.USER).MaxNLocator
    xz.yaxis.set_major_locator(locator(4))
    yz.xaxis.set_major_locator(locator(3 if depth > 0.6 * width else 2, symmetric=True))
    lines = _title_lines(psf, z, is_cropped, scales[0] == scales[1] == scales[2])
    drawing.entitle(figure, "\n".join([", ".join(lines[:3]), "; ".join(lines[3:])]).rstrip("\n"))
    label = drawing.bar_label(drawing.MEANING[psf.normalize], stretch)
    figure.colorbar(mesh, ax=grid).set_label(label, fontsize=9)
    return np.array([xy, xz, yz])


_MAX_DARK = 0.05  # largest brightness (0 to 1) of surroundings that are cropped
_RIM = 0.15  # width of the dark rim drawn around the bright region, as a fraction of the region's size


def _limits(places: Sequence[Array], levels: Sequence[Values], stretch: str) -> list[tuple[float, float]]:
    """Return the limits of x, y and z of the bright region in the sections xy, xz, yz, extended by a rim."""
    top = max(float(level.max()) for level in levels) or 1.0
    xy, xz, yz = (drawing.stretched(level / top, stretch) > _MAX_DARK for level in levels)
    bright_along = xy.any(axis=0) | xz.any(axis=0), xy.any(axis=1) | yz.any(axis=1), xz.any(axis=1) | yz.any(axis=0)
    limits = []
    for positions, bright in zip(places, bright_along, strict=True):
        edges, k = _edges(positions), np.flatnonzero(bright)
        first, last = (float(edges[k[0]]), float(edges[k[-1] + 1])) if k.size else (edges[0], edges[-1])
        rim = _RIM * (last - first)
        limits.append((max(float(edges[0]), first - rim), min(float(edges[-1]), last + rim)))
    return limits


def _title_lines(psf: PSFLike, z: Array, is_cropped: bool, to_scale: bool) -> list[str]:
    """Return notes on planes, pixels, cropping and scales for the title of a z stack."""
    steps = np.diff(z)
    is_even = np.ptp(steps) <= 1e-6 * steps.mean()
    size = 1e6 * psf.grid.side / psf.pupil.magnification  # type: ignore[attr-defined]
    return [
        f"{z.size} planes, {steps.mean():.4g} µm apart" if is_even else f"{z.size} planes, not evenly spaced",
        f"{psf.shape[-2]} × {psf.shape[-1]} pixels of {size:.4g} µm in the sample",
        drawing.SAMPLING[psf.sampling],
        *(["dark surroundings are cropped"] if is_cropped else []),
        *([] if to_scale else ["x, y and z have different scales"]),
    ]


def _edges(centres: Array) -> Array:
    """Return the edges of pixels with these `centres`; outer pixels are symmetric about their centres."""
    if centres.size == 1:
        return np.array([centres[0] - 0.5, centres[0] + 0.5])
    middles = 0.5 * (centres[1:] + centres[:-1])
    return np.concatenate([[2.0 * centres[0] - middles[0]], middles, [2.0 * centres[-1] - middles[-1]]])


@display.plot.register(PSFLike)
def plot(psf: PSFLike, ax: Axes | None = None, *, stretch: str = "sqrt") -> drawing.Drawn:
    """Draw a PSF, a stack of PSFs side by side on one brightness scale, or three sections of a z stack.

    Parameters
    ----------
    psf : PSF
        A single PSF or a stack of at most 64. A stack of shape (rows, columns) is drawn in this arrangement, any
        other stack in rows of at most eight. A z stack of a microscope is drawn as sections through its brightest
        voxel (:func:`lommel.show.plot.sections`).
    ax : matplotlib Axes, optional
        Axes for a single PSF. By default the axes of a new figure with a title and a colour bar.
    stretch : {"sqrt", "linear", "log"}
        Brightness scale of the values; "log" shows values down to 1e-5 of the peak.

    Returns
    -------
    matplotlib Axes, or ndarray of Axes
        An array of the shape of the stack, or the three axes of a z stack.

    Raises
    ------
    ValueError
        For a stack of more than 64 PSFs, or if `ax` is passed for a stack.
    ImportError
        If matplotlib is not installed.
    """
    validation.choice("stretch", stretch, drawing.STRETCHES)
    drawing.only_single(ax, psf.pupil.shape)
    if is_z_stack(psf):
        return sections(psf, stretch=stretch)
    drawing.at_most(psf.pupil.shape)
    norm = drawing.norm_of(stretch, psf.values)
    label = drawing.bar_label(drawing.MEANING[psf.normalize], stretch)
    if psf.pupil.shape != ():

        def draw_member(index: tuple[int, ...], axes: Axes) -> Axes:
            return _draw(psf[index], axes, norm)

        return drawing.tiles(psf.pupil.shape, draw_member, drawing.of_pupils(psf.pupil), _title(psf), label)
    sides = (count * pitch for count, pitch in zip(psf.shape, psf.grid.pitch, strict=True))
    axes = _draw(psf, drawing.picture_axes(ax, *sides), norm)
    if ax is None:
        drawing.caption(axes, _title(psf), label)
    return axes


def _title(psf: PSFLike) -> str:
    factor, unit = drawing.lengths(psf.unit)
    height, width = psf.shape[-2:]
    sides = psf.grid.pitch[: 1 if isinstance(psf.pixel, float) else 2]
    size = " × ".join(f"{side * factor:.4g}" for side in sides)
    blurs = "".join(f", {type(blur).__name__}" for blur in psf.blur)
    return f"{height} × {width} pixels of {size} {unit}, {drawing.SAMPLING[psf.sampling]}{blurs}"


def _draw(psf: PSFLike, axes: Axes, norm: Normalize) -> Axes:
    """Draw the values of a single PSF on axes with positions on the sensor."""
    interpolation = "nearest" if max(psf.shape) < 256 else "antialiased"
    return _show(psf.values, psf, axes, cmap=drawing.COLOURS, norm=norm, interpolation=interpolation)


def _show(picture: Values, psf: PSFLike, axes: Axes, **style: Any) -> Axes:
    """Draw values or colours of the pixels of a PSF on axes with positions on the sensor."""
    factor, unit = drawing.lengths(psf.unit)
    half_high, half = (0.5 * side * factor for side in psf.grid.pitch)
    x, y = psf.grid.x * factor, psf.grid.y * factor
    axes.imshow(picture, extent=(x[0] - half, x[-1] + half, y[-1] + half_high, y[0] - half_high), **style)
    place = " on the camera" if isinstance(psf.pupil, ObjectivePupil) else ""  # not in the sample
    axes.set(xlabel=f"x{place} ({unit})", ylabel=f"y{place} ({unit})")
    return axes


@display.plot.register(ColourPSFLike)
def colour(psf: ColourPSFLike, ax: Axes | None = None, *, stretch: str = "sqrt") -> drawing.Drawn:
    """Draw PSFs of three channels in colour, or the channels of a single PSF side by side.

    In colour each channel is divided by its largest value.

    Parameters
    ----------
    psf : ColourPSF
        A single PSF, or with three channels a stack of at most 64, which is drawn in rows of about eight.
    ax : matplotlib Axes, optional
        Axes for a single picture. By default the axes of a new figure.
    stretch : {"sqrt", "linear", "log"}
        Brightness scale of the values; "log" shows values down to 1e-5 of the largest value.

    Returns
    -------
    matplotlib Axes, or ndarray of Axes
        One for each PSF of the stack, or one for each channel unless there are three channels.

    Raises
    ------
    ValueError
        If `stretch` is unknown, for more than 64 pictures, or if `ax` is passed for several pictures.
    ImportError
        If matplotlib is not installed.
    """
    validation.choice("stretch", stretch, ("sqrt", "linear", "log"))
    stack = psf.shape[:-3]
    if len(psf.psfs) == 3:
        shape, pictures = stack, drawing.stretched(colours(psf), stretch)
        titles, scale = drawing.of_pupils(psf.psfs[0].pupil), "each channel / its largest value"
    elif not stack:
        light = np.maximum(psf.values, 0.0) / (float(psf.values.max()) or 1.0)
        shape, pictures = (len(psf.psfs),), drawing.stretched(light, stretch)
        titles, scale = list(psf.channels.names), "all channels / the largest value"
    else:
        raise ValueError(f"a stack must have three channels, got {len(psf.psfs)}; plot a channel: psf[0].plot()")
    drawing.only_single(ax, shape)
    single = psf.psfs[0][(0,) * len(stack)] if stack else psf.psfs[0]
    style = {} if len(psf.psfs) == 3 else {"cmap": "gray", "vmin": 0.0, "vmax": 1.0}
    title = f"brightness: {' '.join(drawing.STRETCHES[stretch].split())}, {scale}"

    def draw_one(index: tuple[int, ...], axes: Axes) -> Axes:
        return _show(pictures[index], single, axes, interpolation="nearest", **style)

    if shape:
        return drawing.tiles(shape, draw_one, titles, title)
    axes = drawing.new_axes(ax, (4.4, 4.2))
    draw_one((), axes)
    if ax is None:
        axes.set_title(drawing.fit_to_width(title, axes), fontsize=9)
    return axes


def compare(answers: Mapping[str, PSFLike], reference: str) -> Figure:
    """Draw a reference PSF, error maps of other PSFs, and the reference and the errors along the central row.

    Parameters
    ----------
    answers : mapping of str to PSF
        PSFs on the same grid by the name of their method. The reference is drawn first, the other PSFs in this order.
    reference : str
        Name of the reference PSF.

    Returns
    -------
    matplotlib Figure

    Raises
    ------
    ValueError
        If `reference` is not a name in `answers`.
    ImportError
        If matplotlib is not installed.
    """
    if reference not in answers:
        raise ValueError(f"reference must be one of {', '.join(answers)}, got {validation.shown(reference)}")
    exact = answers[reference]
    others = {name: psf for name, psf in answers.items() if name != reference}
    count = 1 + len(others)
    rows = -(-count // _MAX_COLUMNS)
    columns = -(-count // rows)
    width = 2.0 * max(columns, 3) + 1.6
    above = 2.2 * rows + 0.7
    figure = drawing.new_figure((width, above + 4.6))
    pictures, graphs = figure.subfigures(2, 1, squeeze=False, height_ratios=(above, 4.6))[:, 0]
    peak = float(exact.values.max())
    scale = library("matplotlib.colors", *drawing.USER).LogNorm(*_ERRORS, clip=True)
    error_axes = []
    for k, name in enumerate([reference, *others]):
        axes = pictures.add_subplot(rows, columns, k + 1)
        if name == reference:
            plot(exact, axes)
        else:
            error = np.maximum(
                np.abs(np.asarray(others[name].values, dtype=np.float64) - exact.values) / peak,
                _ERRORS[0],
            )
            _show(error, exact, axes, cmap="viridis", norm=scale, interpolation="nearest")
            error_axes.append(axes)
        title = f"{name}, the reference (square root)" if name == reference else name
        axes.set_title("\n".join(textwrap.wrap(title, _MAX_LETTERS)), fontsize=8)
        axes.tick_params(labelsize=7)
        axes.xaxis.label.set_fontsize(8)
        axes.yaxis.label.set_fontsize(8)
        drawing.only_outer(axes, k, columns * rows, columns)
    if error_axes:
        bar = pictures.colorbar(error_axes[0].images[0], ax=pictures.axes, extend="min", pad=0.01)
        bar.set_label("error / peak of the reference", fontsize=8)
        bar.ax.tick_params(labelsize=7)
    factor, unit = drawing.lengths(exact.unit)
    slices, errors = graphs.subplots(1, 2, width_ratios=(1.0, 1.35))
    radius, expected = exact.profile()
    max_radius = max(float(radius[-1]), 0.5 * exact.grid.pitch[1]) * factor
    # Pixel averages are drawn as steps, point samples as markers.
    style: dict[str, Any] = (
        {"drawstyle": "steps-mid"} if exact.sampling == "pixel" else {"marker": ".", "markersize": 4}
    )
    slices.plot(radius * factor, expected / peak, color=slices.xaxis.label.get_color(), linewidth=1.4, **style)
    slices.set_title("the reference along x, pixel by pixel", fontsize=9)
    slices.set(ylabel="intensity / peak", xlabel=f"distance from the centre ({unit})", xlim=(0.0, max_radius))
    for k, (name, psf) in enumerate(others.items()):
        difference = np.maximum(np.abs(psf.profile()[1] - expected) / peak, 1e-17)
        errors.semilogy(radius * factor, difference, ".-", color=f"C{k}", linewidth=0.9, markersize=4, label=name)
    errors.set_title("errors along the same line", fontsize=9)
    errors.set(ylabel="error / peak of the reference", ylim=(1e-17, 3.0), xlim=(0.0, max_radius))
    errors.set(xlabel=f"distance from the centre ({unit})")
    errors.grid(alpha=0.3)
    if others:
        errors.legend(fontsize=8, loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False)
    return figure


_MAX_COLUMNS = 6  # largest number of pictures in a row of a comparison
_MAX_LETTERS = 27  # largest number of letters in a line of the title above a picture of a comparison
_ERRORS = (1e-12, 1.0)  # range of the colour scale of errors, relative to the peak


def field(grid: PSFGridLike, ax: Axes | None = None, *, stretch: str = "sqrt") -> Axes:
    """Draw a grid of PSFs, each enlarged at its position on the sensor and divided by its largest value.

    The axes are positions on the sensor, with a tick at each row and column of the grid. The scale bar above the axes
    applies to the enlarged PSFs. y increases downwards, as in an image.

    Parameters
    ----------
    grid : PSFGrid
    ax : matplotlib Axes, optional
        By default the axes of a new figure with a title and, unless in colour, a colour bar.
    stretch : {"sqrt", "linear", "log"}
        Brightness scale of the values; "log" shows values down to 1e-5 of the largest value.

    Returns
    -------
    matplotlib Axes

    Raises
    ------
    ValueError
        If `stretch` is unknown, if the grid has several distances, or if it has two or more than three channels.
    ImportError
        If matplotlib is not installed.
    """
    mpl = library("matplotlib", *drawing.USER)
    validation.choice("stretch", stretch, drawing.STRETCHES)
    if grid.depths is not None:
        raise ValueError("grid must have a single distance, got several: draw one of them, grid.at_depth(0).plot()")
    is_coloured = isinstance(grid.psf, ColourPSFLike)
    pictures = drawing.stretched(colours(grid.psf), stretch) if isinstance(grid.psf, ColourPSFLike) else grid.values
    (rows, columns), (height, width) = grid.values.shape[:2], grid.values.shape[-2:]
    axes = _field_axes(grid) if ax is None else ax
    factor, unit = (1e3, "mm") if grid.unit == "m" else (1.0, "λN")
    sensor = (grid.sensor[0] * factor, grid.sensor[1] * factor)
    psf_height, psf_width = (side * pitch for side, pitch in zip((height, width), grid.psf.grid.pitch, strict=True))
    magnification = min(sensor[0] / rows / psf_height, sensor[1] / columns / psf_width)
    half_height, half_width = 0.5 * psf_height * magnification, 0.5 * psf_width * magnification
    colors = mpl.colormaps[drawing.COLOURS]
    axes.set_facecolor("black" if is_coloured else colors(0.0))
    interpolation = "nearest" if max(height, width) < 24 else "bilinear"
    for i, j in np.ndindex(rows, columns):
        x, y = grid.x[j] * factor, grid.y[i] * factor
        values = pictures[i, j]
        norm = {} if is_coloured else {"cmap": colors, "norm": drawing.norm_of(stretch, values)}
        extent = (x - half_width, x + half_width, y + half_height, y - half_height)
        axes.imshow(values, extent=extent, interpolation=interpolation, **norm)
    half_sensor = 0.5 * sensor[0], 0.5 * sensor[1]
    axes.set(xlim=(-half_sensor[1], half_sensor[1]), ylim=(half_sensor[0], -half_sensor[0]), aspect="equal")
    axes.set_xticks(grid.x * factor, [drawing.true_minus(f"{value:.3g}") for value in grid.x * factor + 0.0])
    axes.set_yticks(grid.y * factor, [drawing.true_minus(f"{value:.3g}") for value in grid.y * factor + 0.0])
    if ax is None:
        title = f"{rows} × {columns} PSFs, each divided by its largest value"
        # Pictures in colour have no colour bar, so that the title states their brightness scale.
        title += f"\nbrightness: {' '.join(drawing.STRETCHES[stretch].split())}" if is_coloured else ""
        axes.set_title(title, fontsize=9, loc="left", pad=22)
    if ax is None and not is_coloured:
        scale = library("matplotlib.cm", *drawing.USER).ScalarMappable(drawing.norm_of(stretch, np.ones(1)), colors)
        label = drawing.bar_label("value / largest value of each PSF", stretch)
        axes.figure.colorbar(scale, ax=axes, shrink=0.75, label=label)
    axes.set(xlabel=f"x on the sensor ({unit})", ylabel=f"y on the sensor ({unit})")
    # Lengths within the PSFs are enlarged by `magnification`.
    inner_factor, inner_unit = drawing.lengths(grid.unit)
    length = drawing.round_length(0.8 * psf_width * inner_factor)
    _scale_bar(axes, length / inner_factor * magnification / sensor[1], f"{length:g} {inner_unit} in the PSFs")
    return axes


def _scale_bar(axes: Axes, length: float, label: str) -> None:
    """Draw a labelled scale bar above the right end of the axes; `length` is a fraction of the axes' width."""
    offset_copy = library("matplotlib.transforms", *drawing.USER).offset_copy
    place = offset_copy(axes.transAxes, fig=axes.figure, y=9.0, units="points")
    color = axes.xaxis.label.get_color()  # white in dark styles
    axes.plot([1.0 - length, 1.0], [1.0, 1.0], color=color, linewidth=2.5, transform=place, clip_on=False)
    axes.text(0.99 - length, 1.0, label, transform=place, ha="right", va="center", fontsize=8)


def _field_axes(grid: PSFGridLike) -> Axes:
    """Return axes of a new figure with the sensor's aspect ratio."""
    ratio = min(max(grid.sensor[0] / grid.sensor[1], 0.25), 2.5)
    width = 8.0 if ratio <= 1.2 else 9.6 / ratio
    return drawing.new_axes(None, (width + 1.1, width * ratio + 0.7))


def difference(a: PSFLike | ArrayLike, b: PSFLike, ax: Axes | None = None) -> Axes:
    """Draw ``(a - b) / max(b)``, in red if `a` is larger and in blue if `a` is smaller.

    Parameters
    ----------
    a : PSF or array_like
        Array of the shape of `b`, or a PSF with the pixel and the normalisation of `b`.
    b : PSF
        A single PSF.
    ax : matplotlib Axes, optional
        By default the axes of a new figure with a colour bar and a title, which states :func:`lommel.peak_error` and
        the square root of :func:`~lommel.measures.errors.mse`.

    Returns
    -------
    matplotlib Axes

    Raises
    ------
    TypeError, ValueError
        If `a` and `b` differ in shape, pixel or normalisation.
    ImportError
        If matplotlib is not installed.

    Examples
    --------
    >>> import lommel as lm
    >>> pupil = lm.Pupil(lm.Wavefront(defocus=3.0))
    >>> exact, fast = (lm.psf(pupil, 64, 0.25, method=method) for method in (None, lm.paper.Fraunhofer(256)))
    >>> axes = lm.show.difference(fast, exact)
    """
    checked(b, "b")
    validation.axes("ax", ax)
    if b.pupil.shape != ():
        raise ValueError(f"b must be a single PSF, got a stack of shape {b.pupil.shape}; index it")
    if is_psf(a):
        for name in ("unit", "normalize"):
            if getattr(a, name) != getattr(b, name):
                raise ValueError(f"a must have the {name} of b, {getattr(b, name)!r}, got {getattr(a, name)!r}")
        if not np.allclose(a.grid.pitch, b.grid.pitch, rtol=1e-9, atol=0.0):
            raise ValueError(f"a must have the pixel of b, {b.grid.named}, got {a.grid.named}")
    values = np.asarray(a, dtype=np.float64)
    if values.shape != b.shape:
        raise ValueError(f"a must have the shape of b, {b.shape}, got {values.shape}")
    largest, mean = peak_error(values, b.values), math.sqrt(mse(values, b.values))
    difference = (values - b.values) / float(b.values.max())
    norm = drawing.even_norm(float(np.abs(difference).max()))
    axes = _show(difference, b, drawing.new_axes(ax), cmap="RdBu_r", norm=norm, interpolation="nearest")
    if ax is None:
        drawing.caption(axes, f"largest difference {largest:.2g} of the peak, rms {mean:.2g}", "difference / peak")
    return axes


def ray_positions(pupil: Pupil, rings: int = 12) -> Array:
    """Return the positions at which rays from concentric circles of pupil points meet the sensor.

    Parameters
    ----------
    pupil : Pupil
        A single pupil.
    rings : int, default 12
        Number of equally spaced circles of points in the pupil, 1 to 100. The k-th circle has 6 k points, the last
        circle is the rim, and an obscuration adds a circle along its edge. A full disc has
        ``3 rings (rings + 1) + 1`` points.

    Returns
    -------
    ndarray, shape (rays, 2)
        x (columns) and y (rows) relative to the axis, metres if the pupil has a wavelength, else units of lambda*N;
        exact up to rounding. As `rings` grows, the rms distance of the positions from their centroid approaches
        :func:`lommel.spot_radius` for uniform amplitude.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, or if the pupil is a stack.
    """
    if checked_pupil(pupil).shape != ():
        raise ValueError(f"pupil must be a single one, got a stack of shape {pupil.shape}")
    count = validation.integer("rings", rings, least=1, most=100)
    points = [1, *(6 * k for k in range(1, count + 1))]
    # Slightly inside the rim, because points on the rim may be rounded to the outside.
    radius = np.arange(count + 1) / count * (1.0 - 1e-12)
    if pupil.obscuration > 0.0:
        points.append(6 * math.ceil(count * pupil.obscuration))
        radius = np.append(radius, pupil.obscuration * (1.0 + 1e-12))
    rho = np.repeat(radius, points)
    theta = np.concatenate([2.0 * math.pi * np.arange(n) / n for n in points])
    x, y = rho * np.cos(theta), rho * np.sin(theta)
    rho = np.maximum(rho, 1e-9)  # slopes() divides by rho
    clear = pupil.opening.margin(x, y) >= 0.0
    if pupil.mask is not None:
        clear &= np.abs(pupil.mask.at(x, y)) > 0.0
    return np.asarray(slopes(pupil, rho[clear], theta[clear])[0].T * (pupil.scale / math.pi))


@display.register("spots")
def spots(psf: PSFLike, ax: Axes | None = None) -> Axes:
    """Draw a PSF with the spot diagram of its rays and the Airy circle of the aperture about the axis.

    Parameters
    ----------
    psf : PSF
        A single PSF of a lens.
    ax : matplotlib Axes, optional
        By default the axes of a new figure with a colour bar and a title, which states the rms radius of the rays
        (:func:`lommel.spot_radius`).

    Returns
    -------
    matplotlib Axes

    Raises
    ------
    TypeError, ValueError
        If `psf` is a stack or the PSF of an objective, or if an argument is out of range.
    ImportError
        If matplotlib is not installed.
    """
    pupil = checked(psf, "psf").pupil
    if not isinstance(pupil, Pupil):
        raise ValueError("psf must be the PSF of a lens for a spot diagram, got the PSF of an Objective")
    if pupil.shape != ():
        raise ValueError(f"psf must be a single one for a spot diagram, got a stack of shape {pupil.shape}; index it")
    validation.axes("ax", ax)
    factor, unit = drawing.lengths(psf.unit)
    x, y = ray_positions(pupil).T * factor
    axes = cast("Axes", plot(psf, ax))  # of a single PSF
    limits = axes.get_xlim(), axes.get_ylim()
    axes.scatter(x, y, s=4.0, color="deepskyblue", linewidths=0.0, label=f"{x.size} rays")
    airy = pupil.airy_radius * factor
    drawing.circle(axes, airy, color="lime", linewidth=1.0, label="Airy circle")
    axes.set(xlim=limits[0], ylim=limits[1])
    axes.legend(fontsize=7, loc="upper right")
    if ax is None:
        low, high = sorted(limits[1])
        outside = int(np.sum((np.abs(x - np.mean(limits[0])) > 0.5 * np.ptp(limits[0])) | (y < low) | (y > high)))
        note = f", {outside} of them beyond the window" if outside else ""
        radius = float(spot_radius(pupil)) * factor
        axes.set_title(f"rays: rms radius {radius:.3g} {unit}{note}; Airy radius {airy:.3g} {unit}", fontsize=9)
    return axes
