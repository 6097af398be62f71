"""Plots of estimates: depth maps and their precision, fitted wavefronts, field maps, molecules, restored stacks."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base.arrays import Array, Values
from lommel.base.optional import library
from lommel.base.units import format_length, with_error
from lommel.show import drawing

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure, FigureBase, SubFigure
    from matplotlib.image import AxesImage

Colours = NDArray[np.uint8]

_GREY, _BACKGROUND, _INK = 128, 24, 235  # grey levels of unknown depth, of the background and of letters, 0 to 255
_BAR, _TEXT = 24, 12  # height of the colour bar and of its letters, pixels
_MIN_GRADIENT = 100  # smallest length of the colour gradient, pixels, beside which the bar also shows grey


class DepthColours:
    """Picture of depth maps in colour, from yellow (nearest) to violet (farthest), linear in 1 / distance.

    Parameters
    ----------
    between : (float, float)
        Nearest and farthest distance, metres; the farthest may be infinite.
    shape : (int, int)
        Height and width of the frames, pixels.
    block : int
        Side, in pixels, of the square of the frames that one value of the depth map covers.
    beside : bool
        True to reserve space for a grey image to the right of the depth map.
    """

    def __init__(self, between: tuple[float, float], shape: tuple[int, int], block: int, beside: bool) -> None:
        user = ("the colours of depth need", "plot")
        colours = library("matplotlib", *user).colormaps["viridis_r"](np.linspace(0.0, 1.0, 255))
        grey = [[_GREY] * 3]
        self._table: Colours = np.concatenate([grey, np.rint(255.0 * colours[:, :3])]).astype(np.uint8)
        self._near, self._far = (1.0 / distance for distance in between)
        self._shape, self._block = shape, block
        height, width = shape[0], shape[1] * (1 + beside)
        self._picture = np.full((height + _BAR, width, 3), _BACKGROUND, np.uint8)
        self._picture[:height] = _GREY
        self._picture[height:] = self._bar(between, width)

    def _bar(self, between: tuple[float, float], width: int) -> Colours:
        """Return the colour bar, labelled with both distances and, if wide enough, with the grey of unknown depth."""
        image, drawing = (
            library(f"PIL.{name}", "the bar of colours needs", "images") for name in ("Image", "ImageDraw")
        )
        canvas = image.new("RGB", (width, _BAR), (_BACKGROUND,) * 3)
        draw = drawing.Draw(canvas)
        draw.fontmode = "L"
        font = library("PIL.ImageFont", "the bar of colours needs", "images").load_default(_TEXT)
        ends = [format_length(distance) if math.isfinite(distance) else "infinity" for distance in between]
        labels = [*ends, "not known"]
        left, right, unknown = (math.ceil(draw.textlength(text, font=font)) for text in labels)
        start = left + 10
        stop = width - right - 10
        show_grey = stop - start - unknown - _BAR - 12 >= _MIN_GRADIENT
        if show_grey:
            stop -= unknown + _BAR + 12
            draw.rectangle((stop + right + 18, 6, stop + right + 18 + _BAR - 8, _BAR - 7), fill=(_GREY,) * 3)
            draw.text((width - unknown - 4, _BAR // 2), labels[2], fill=(_INK,) * 3, font=font, anchor="lm")
        draw.text((4, _BAR // 2), labels[0], fill=(_INK,) * 3, font=font, anchor="lm")
        draw.text((stop + 6, _BAR // 2), labels[1], fill=(_INK,) * 3, font=font, anchor="lm")
        bar = np.array(canvas)
        if stop - start > 8:
            places = 1 + np.rint(np.linspace(0.0, 254.0, stop - start)).astype(int)
            bar[6:-6, start:stop] = self._table[places]
        return bar

    def __call__(self, depth: NDArray[np.float32], image: Colours | None = None) -> Colours:
        """Return the picture of a depth map in metres (NaN: unknown depth), with the grey `image` to its right.

        If `image` is None, its space, if reserved, is grey. The next call overwrites the picture.
        """
        with np.errstate(invalid="ignore"):
            fraction = (self._near - 1.0 / depth) / (self._near - self._far)
            level = np.where(np.isfinite(depth), 1.0 + 254.0 * np.clip(fraction, 0.0, 1.0), 0.0).astype(np.uint8)
        blocks = self._table[level]
        picture = np.repeat(np.repeat(blocks, self._block, axis=0), self._block, axis=1)
        height, width = picture.shape[:2]
        self._picture[:height, :width] = picture
        rows, columns = self._shape
        self._picture[:rows, columns:] = _GREY if image is None else image[..., None]
        return self._picture


_MAX_COLUMNS = 5  # largest number of panels in a row
_SIGMAS = 4.0  # colour scale of residuals: from -4 to 4 standard deviations


def field(
    maps: Sequence[tuple[str, Array, Array]],
    axes: tuple[Array, Array, str],
    stars: tuple[Array, Array, Array, NDArray[np.bool_]],
    images: tuple[Array, Array],
    unit: str,
    title: str,
) -> Figure:
    """Draw maps of Zernike terms over the sensor, the fitted stars, and the images and models of five stars.

    A map is (name, values, standard errors). `axes` are x and y of the maps and their unit. `stars` are x, y and
    chi^2 of each star, and a mask that is True for the stars of the fit. `images` are measured images and models.
    """
    x, y, length = axes
    star_x, star_y, chi2, used = stars
    factor, name = (1e3, "mm") if length == "m" else (1.0, "λN")
    rows = math.ceil((len(maps) + 1) / _MAX_COLUMNS)
    columns = math.ceil((len(maps) + 1) / rows)
    figure = drawing.new_figure((2.6 * _MAX_COLUMNS + 1.0, 2.7 * rows + 4.6))
    upper, lower = figure.subfigures(2, 1, height_ratios=(2.7 * rows, 4.2))  # type: ignore[misc]
    panels = upper.subplots(rows, columns, squeeze=False)
    extent = [factor * x[0], factor * x[-1], factor * y[-1], factor * y[0]]
    for panel, (term, values, errors) in zip(panels.flat, maps, strict=False):
        limit = max(float(np.abs(values).max()), 1e-12)
        image = panel.imshow(values, cmap="RdBu_r", vmin=-limit, vmax=limit, extent=extent, aspect="equal")
        bar = upper.colorbar(image, ax=panel, shrink=0.75)
        bar.ax.tick_params(labelsize=7)
        panel.set_title("\n".join([*textwrap.wrap(term, 22), f"± {np.median(errors):.2g}"]), fontsize=8)
        panel.set(xticks=[], yticks=[])
    panel = panels.flat[len(maps)]
    dots = panel.scatter(
        factor * star_x[used],
        factor * star_y[used],
        c=chi2[used],
        s=14,
        cmap=drawing.COLOURS,
        vmin=0.8,
        vmax=1.4,
    )
    if not used.all():
        panel.plot(factor * star_x[~used], factor * star_y[~used], "x", color="C3", markersize=6)
    panel.set(xlim=extent[:2], ylim=extent[2:], aspect="equal")
    panel.set_xlabel(f"x ({name})", fontsize=8)
    panel.set_ylabel(f"y ({name})", fontsize=8)
    panel.tick_params(labelsize=7)
    panel.set_title("stars, chi2" + ("" if used.all() else "\ncrosses: rejected"), fontsize=8)
    upper.colorbar(dots, ax=panel, shrink=0.75).ax.tick_params(labelsize=7)
    for empty in panels.flat[len(maps) + 1 :]:
        empty.remove()
    upper.suptitle(f"Zernike terms over the sensor ({unit} rms), ± median standard error", fontsize=10)
    _stars(lower, images, (star_x, star_y, used))
    figure.suptitle(textwrap.fill(title, 130), fontsize=9)
    return figure


def _stars(figure: SubFigure, images: tuple[Array, Array], stars: tuple[Array, Array, NDArray[np.bool_]]) -> None:
    """Draw images, models and residuals of the stars nearest to the middle and to the corners of the field."""
    measured, model = images
    star_x, star_y, is_fitted = stars
    fitted = np.flatnonzero(is_fitted)
    width, height = max(float(np.ptp(star_x)), 1e-300), max(float(np.ptp(star_y)), 1e-300)
    places = {
        "top left": (star_x.min(), star_y.min()),
        "top right": (star_x.max(), star_y.min()),
        "middle": (np.median(star_x), np.median(star_y)),
        "bottom left": (star_x.min(), star_y.max()),
        "bottom right": (star_x.max(), star_y.max()),
    }
    columns = []
    for name, (u, v) in places.items():
        k = fitted[np.argmin(((star_x[fitted] - u) / width) ** 2 + ((star_y[fitted] - v) / height) ** 2)]
        image, fit = measured[k, 0], model[k, 0]
        columns.append((name, image, fit, (image - fit) / np.sqrt(np.maximum(fit, 1.0))))
    panels, residual = _residual_rows(figure, columns, font_size=8)
    figure.colorbar(residual, ax=panels.ravel().tolist(), label="residual / photon noise", shrink=0.6)


def _residual_rows(
    figure: FigureBase, columns: Sequence[tuple[str, Array, Array, Array]], font_size: float
) -> tuple[NDArray[np.object_], AxesImage]:
    """Draw image, model and residual below the title of each column; return the panels and the last residual."""
    panels = figure.subplots(3, len(columns), squeeze=False)
    norm = library("matplotlib.colors", *drawing.USER).PowerNorm
    for column, (title, image, model, residual) in zip(panels.T, columns, strict=True):
        scale = norm(0.5, np.nanmin(image), np.nanmax(image))
        for panel, values in zip(column[:2], (image, model), strict=True):
            panel.imshow(values, cmap=drawing.COLOURS, norm=scale, interpolation="nearest")
        shown = column[2].imshow(residual, cmap="RdBu_r", vmin=-_SIGMAS, vmax=_SIGMAS, interpolation="nearest")
        column[0].set_title(title, fontsize=8)
    rows = "measured\n(square root)", "model\n(square root)", "residual"
    for row, text in zip(panels, rows, strict=True):
        row[0].set_ylabel(text, fontsize=font_size)
    for panel in panels.flat:
        panel.set(xticks=[], yticks=[], facecolor="0.5")  # colour of NaN pixels
    return panels, shown


_COLOURS = "turbo"  # colour map of z or depth
_MAX_PIXELS, _DEFAULT_PIXELS = 4096, 800  # largest and default number of pixels along the longer side
_MIN_PIXEL = 5e-9  # smallest default pixel, metres
_WIDTHS = 2.0 ** (0.5 * np.arange(-1, 13))  # rounded standard deviations of molecules, pixels
_AXES = {"z": "stage position z (µm)", "depth": "depth (µm)"}


def picture(
    rows: NDArray[np.void], size: tuple[float, float], pixel: float | None, along: str, ax: Axes | None
) -> Axes:
    """Draw molecules in a field of `size` (height, width) with about this `pixel` pitch, metres in the sample.

    `along` is the quantity that colours represent: "z", "depth" or "none".
    """
    axes = drawing.new_axes(ax, (6.4, 5.6))
    side = max(_MIN_PIXEL, max(size) / _DEFAULT_PIXELS) if pixel is None else max(pixel, max(size) / _MAX_PIXELS)
    one_colour = along == "none"
    colour_values = np.zeros(rows.size) if one_colour else 1e6 * rows["z"]
    low, high = np.percentile(colour_values, [1.0, 99.0]) if rows.size else (0.0, 1.0)
    map_ = library("matplotlib.cm", *drawing.USER).ScalarMappable(cmap=_COLOURS)
    map_.set_clim(low, max(high, low + 1e-3))
    extent = (0.0, 1e6 * size[1], 1e6 * size[0], 0.0)
    colours = np.ones((rows.size, 3)) if one_colour or not rows.size else map_.to_rgba(colour_values)[:, :3]
    axes.imshow(rendered(rows, size, side, colours), extent=extent, interpolation="antialiased")
    figure = drawing.figure_of(axes)
    if not one_colour:
        figure.colorbar(map_, ax=axes, label=_AXES[along], extend="both", shrink=0.85)
    axes.set(xlabel="x (µm)", ylabel="y (µm)", title=f"{rows.size} localisations, pixels of {1e9 * side:.3g} nm")
    return axes


def rendered(rows: NDArray[np.void], size: tuple[float, float], side: float, colours: Array) -> Array:
    """Return an RGB image, 0 to 1, of molecules as Gaussians as wide as their localisation errors, on black."""
    height, width = (max(1, math.ceil(length / side - 1e-9)) for length in size)
    light = np.zeros((4, height, width))
    row, column = (np.floor(rows[name] / side).astype(int) for name in ("y", "x"))
    inside = (row >= 0) & (row < height) & (column >= 0) & (column < width)
    sigma = np.sqrt(0.5 * (rows["x_error"] ** 2 + rows["y_error"] ** 2)) / side
    nearest = np.abs(np.log(_WIDTHS) - np.log(np.maximum(sigma, 1e-6))[:, None]).argmin(axis=1)
    for k in np.unique(nearest[inside]):
        group = inside & (nearest == k)
        place = row[group] * width + column[group]
        for channel, weights in enumerate((None, *colours[group].T)):
            sums = np.bincount(place, weights, height * width).astype(float).reshape(height, width)
            light[channel] += scipy.ndimage.gaussian_filter(sums, _WIDTHS[k], mode="constant")
    density = light[0]
    bright_values = density[density > 1e-3 * density.max(initial=0.0)]
    white = float(np.percentile(bright_values, 99.0)) if bright_values.size else 1.0
    brightness = np.clip(density / white, 0.0, 1.0) ** 0.5
    colour = np.divide(light[1:], density, out=np.zeros_like(light[1:]), where=density > 0.0)
    return np.ascontiguousarray(np.moveaxis(np.clip(colour * brightness, 0.0, 1.0), 0, -1))


_UNKNOWN = "0.55"  # colour of unknown values
_SIDE = 3.3  # longer side of an xy projection, inches
_STACK_SIGMAS = 5.0  # colour scale of the residuals of stacks: from -5 to 5 standard deviations
_MIN_XZ_HEIGHT = 0.18  # smallest height of an xz projection, as a fraction of the height of the xy projection


def projections(
    channels: Sequence[tuple[str, Sequence[tuple[Values, Values]]]], voxel: tuple[float, float], title: str
) -> Figure:
    """Draw recorded, restored and residual stacks of each channel, projected along z (above) and along y (below).

    A channel is its name and three pairs of projections, along z and along y. `voxel` is the step along z and the
    pixel pitch, metres. Brightness is proportional to the square root of the values, from 0 to the largest value of
    the projection along z; residuals are in standard deviations.
    """
    height, width = channels[0][1][0][0].shape
    planes = len(channels[0][1][0][1])
    step, pixel = voxel
    width_m, height_m, depth = width * pixel, height * pixel, planes * step
    inch = _SIDE / max(width_m, height_m)
    xz_height = max(depth, _MIN_XZ_HEIGHT * height_m)
    size = 3 * (inch * width_m + 0.25) + 1.1, len(channels) * (inch * (height_m + xz_height) + 0.75) + 0.5
    figure = drawing.new_figure(size, "compressed")
    axes = figure.subplots(2 * len(channels), 3, height_ratios=[height_m, xz_height] * len(channels), squeeze=False)
    for rows, (name, pictures) in zip(axes.reshape(len(channels), 2, 3), channels, strict=True):
        for column, (label, pair) in enumerate(zip(("recorded", "restored", "residual"), pictures, strict=True)):
            for panel, values, extent in zip(
                rows[:, column], pair, ((0.0, width_m, height_m, 0.0), (0.0, width_m, depth, 0.0)), strict=True
            ):
                style: dict[str, Any] = {"cmap": "RdBu_r", "vmin": -_STACK_SIGMAS, "vmax": _STACK_SIGMAS}
                if label != "residual":
                    style = {
                        "cmap": drawing.COLOURS,
                        "vmin": 0.0,
                        "vmax": math.sqrt(float(np.nanmax(pair[0], initial=1e-30))),
                    }
                    values = np.sqrt(np.maximum(values, 0.0))
                image = panel.imshow(values, extent=extent, interpolation="nearest", **style)
                panel.set(xticks=[], yticks=[], facecolor=_UNKNOWN)
                panel.set_aspect("equal" if xz_height == depth or extent[2] == height_m else "auto")
            scale = "" if label == "residual" else " (square root)"
            rows[0, column].set_title(f"{name}{label}{scale}", fontsize=9)
        rows[0, 0].set_ylabel("xy", fontsize=9)
        rows[1, 0].set_ylabel("xz", fontsize=9)
        figure.colorbar(image, ax=rows[:, 2].tolist(), label="residual / noise", shrink=0.9, extend="both")
        _scale_bar(rows[1, 0], width_m)
    drawing.entitle(figure, title)
    return figure


def _scale_bar(axes: Axes, width: float) -> None:
    """Draw a scale bar with its length below axes of this `width`, metres."""
    length = drawing.round_length(0.3 * width)
    color = axes.yaxis.label.get_color()  # white in dark styles
    place = axes.get_xaxis_transform()
    axes.plot([0.0, length], [-0.09, -0.09], color=color, linewidth=2.5, transform=place, clip_on=False)
    label = f" {1e6 * length:g} µm; z is the position of the stage"
    axes.text(length, -0.09, label, transform=place, fontsize=8, va="center")


def maps(depth: Array, errors: Array, light: Values | None) -> Figure:
    """Draw maps of depth and its standard error (metres; NaN is grey) and the all-in-focus image `light`, if any."""
    height, width = depth.shape
    count = 2 if light is None else 3
    tall = _MAP * min(max(height / width, 0.4), 2.0)
    wide = min(_MAP, tall * width / height)
    size = count * wide + 2 * _BAR_WIDTH + 0.8, tall + 1.0
    figure = drawing.new_figure(size, "compressed")
    axes = figure.subplots(1, count, squeeze=False)[0]
    is_known = np.isfinite(errors)
    low, high = np.percentile(depth[is_known], [0.5, 99.5]) if is_known.any() else (0.0, 1.0)
    image = axes[0].imshow(depth, cmap="viridis_r", vmin=low, vmax=high, interpolation="nearest")
    _bar(figure, image, axes[0], "depth (m)")
    axes[0].set_title(f"depth, known at {100.0 * is_known.mean():.3g} %", fontsize=9)
    norm, label = None, "standard error of depth (mm)"
    millimetres = np.where(is_known, 1e3 * errors, np.nan)
    if is_known.any():
        ends = np.percentile(millimetres[is_known], [0.5, 99.5]) * [0.99, 1.01]
        norm = library("matplotlib.colors", *drawing.USER).LogNorm(*ends)
        label = drawing.bar_label(label, "log")
    image = axes[1].imshow(millimetres, cmap=drawing.COLOURS, norm=norm, interpolation="nearest")
    bar = _bar(figure, image, axes[1], label)
    if is_known.any():
        _plain_log_ticks(bar.ax.yaxis, *ends)
    axes[1].set_title("standard error", fontsize=9)
    if light is not None:
        top = float(np.percentile(light, 99.5))
        brightness = np.clip(light / top if top > 0.0 else light, 0.0, 1.0) ** (1.0 / 2.2)
        axes[2].imshow(brightness, cmap="gray" if light.ndim == 2 else None, interpolation="nearest")
        axes[2].set_title("all-in-focus image", fontsize=9)
    for panel in axes:
        panel.set(facecolor=_UNKNOWN)
        panel.set_xlabel("x (pixels)", fontsize=8)
        panel.tick_params(labelsize=7, labelleft=panel is axes[0])
    axes[0].set_ylabel("y (pixels)", fontsize=8)
    return figure


_MAP, _BAR_WIDTH = 3.6, 0.9  # width of a depth map, and of a colour bar with numbers and label, inches


def _bar(figure: Figure, image: AxesImage, axes: Axes, label: str) -> Any:
    """Add a colour bar beside axes, with arrows for values beyond its ends."""
    bar = figure.colorbar(image, ax=axes, extend="both", aspect=25)
    bar.set_label(label, fontsize=8)
    bar.ax.tick_params(labelsize=7, which="both")
    return bar


def _plain_log_ticks(axis: Any, low: float, high: float) -> None:
    """Label a logarithmic axis with plain numbers at powers of ten, and also between them below 1.5 decades."""
    ticker = library("matplotlib.ticker", *drawing.USER)
    formatter = ticker.FuncFormatter(lambda value, _: f"{value:g}")
    axis.set_major_formatter(formatter)
    if math.log10(high / low) < 1.5:
        axis.set_minor_locator(ticker.LogLocator(subs=(2.0, 3.0, 5.0)))
        axis.set_minor_formatter(formatter)
    else:
        axis.set_minor_formatter(ticker.NullFormatter())


def precision(distance: Array, curves: Mapping[str, Array], title: str, foci: Sequence[float] = ()) -> Axes:
    """Draw standard errors of depth (logarithmic axis) against distance, metres; infinite errors are gaps.

    Dotted lines mark the focus distances `foci` within the range.
    """
    axes = drawing.new_axes(None, (7.0, 4.4))
    finite = np.concatenate([curve[np.isfinite(curve)] for curve in curves.values()])
    for name, curve in curves.items():
        axes.semilogy(distance, np.where(np.isfinite(curve), 1e3 * curve, np.nan), label=name)
    if finite.size:
        # Limit the axis, because errors are very large near distances at which depth cannot be determined.
        least = 1e3 * float(finite.min())
        axes.set_ylim(0.7 * least, min(1.5e3 * float(finite.max()), 300.0 * least))
    axes.set(xlabel="distance (m)", ylabel="standard error of depth (mm)")
    axes.set_title(drawing.fit_to_width(title, axes, 10), fontsize=10)
    axes.grid(alpha=0.3)
    for focus in foci:
        if distance[0] <= focus <= distance[-1]:
            axes.axvline(focus, color="0.4", linewidth=1.0, linestyle=":")
            label = f" focus {drawing.length_in_words(focus)}"
            place = axes.get_xaxis_transform()
            axes.text(focus, 0.98, label, transform=place, fontsize=8, rotation=90, va="top", ha="right")
    if len(curves) > 1:
        axes.legend(fontsize=9)
    _plain_log_ticks(axes.yaxis, *axes.get_ylim())
    return axes


def responses(curves: Mapping[str, tuple[Array, Array, Array]], unit: str, ax: Axes | None = None) -> Axes:
    """Draw spatial frequency responses (frequencies, values, standard errors) by name, in bands of one error."""
    axes = drawing.new_axes(ax, (6.4, 4.2))
    colours = {"red": "C3", "green": "C2", "blue": "C0"}
    for k, (name, (frequencies, values, errors)) in enumerate(curves.items()):
        colour = colours.get(name, f"C{k}")
        axes.plot(frequencies, values, color=colour, label=name)
        axes.fill_between(frequencies, values - errors, values + errors, color=colour, alpha=0.3, linewidth=0.0)
    axes.axhline(0.5, color="0.5", linewidth=0.8, linestyle=":")
    axes.set(xlabel=f"spatial frequency ({unit})", ylabel="response", xlim=(0.0, None), ylim=(0.0, None))
    axes.grid(alpha=0.3)
    if any(curves):
        axes.legend(fontsize=9)
    return axes


_MAX_NUMBERS = 120  # largest number of edges whose values are written into a map


def sharpness(
    edges: Sequence[tuple[float, float, float, str]],
    shape: tuple[int, int],
    unit: str,
    nyquist: float,
    channel: str = "",
) -> Figure:
    """Draw maps of MTF50 (column, row, value, "S" or "T") over a picture of this height and width, of one channel.

    Triangles are edges with an infinite value: their MTF50 is above the Nyquist frequency.
    """
    figure = drawing.new_figure((10.0, 1.5 + 4.2 * shape[0] / shape[1]))
    panels = figure.subplots(1, 2, sharex=True, sharey=True)
    limited = [min(value, nyquist) for _, _, value, _ in edges]
    scale = {"vmin": min(limited), "vmax": max(limited), "s": 60, "cmap": "viridis"}
    for axes, (key, name) in zip(panels, (("S", "sagittal"), ("T", "tangential")), strict=True):
        part = [edge for edge in edges if edge[3] == key]
        columns, rows, values = (np.array([edge[k] for edge in part], float) for k in range(3))
        above = ~np.isfinite(values)
        points = axes.scatter(columns[~above], rows[~above], c=values[~above], **scale)
        axes.scatter(columns[above], rows[above], c=[nyquist] * above.sum(), marker="^", **scale)
        for x, y, value in zip(columns, rows, values, strict=True) if len(edges) <= _MAX_NUMBERS else ():
            text = f"{value:.3g}" if math.isfinite(value) else f"> {nyquist:.3g}"
            axes.annotate(text, (x, y), (0, 6), textcoords="offset points", fontsize=6, ha="center")
        axes.set(xlim=(0, shape[1]), ylim=(shape[0], 0), aspect="equal", xlabel="column")
        axes.set_title(", ".join(filter(None, ("MTF50", name, channel))))
    panels[0].set_ylabel("row")
    if any(math.isinf(value) for _, _, value, _ in edges):
        unit += f" (triangles: above Nyquist's, {nyquist:.3g})"
    figure.colorbar(points, ax=panels, label=unit, shrink=0.8)
    return figure


_MAX_IMAGES = 8  # largest number of images in one figure


def fit(
    images: Array,
    model: Array,
    residual: Array,
    terms: tuple[list[str], list[float], list[float], str],
    title: str,
    titles: Sequence[str],
) -> Figure:
    """Draw images (n, height, width), models, residual / noise, and fitted coefficients with standard errors.

    `terms` are names, coefficients, standard errors and their common unit; `titles` are the titles of the images.
    """
    names, values, errors, unit = terms
    count = min(len(images), _MAX_IMAGES)
    height = max(6.2, 0.2 * len(names) + 1.4)
    figure = drawing.new_figure((1.9 * count + 1.2 + _TERMS, height))
    pictures, graph = figure.subfigures(1, 2, squeeze=False, width_ratios=(1.9 * count + 1.2, _TERMS))[0]
    short_titles = [title if len(title) < 22 else f"…{title[-20:]}" for title in titles[:count]]
    columns = list(zip(short_titles, images[:count], model[:count], residual[:count], strict=True))
    panels, residual_image = _residual_rows(pictures, columns, font_size=9)
    # Beside all rows, so that all have the same width and their labels fit.
    bar = {"label": "residual / noise", "shrink": 0.3, "anchor": (0.0, 0.0)}
    pictures.colorbar(residual_image, ax=panels.ravel().tolist(), **bar)
    axes = graph.subplots()
    unit = "µm" if unit == "um" else unit
    positions = np.arange(len(names))
    finite = [d if np.isfinite(d) else 0.0 for d in errors]
    axes.barh(positions, values, color="C0", alpha=0.6)
    axes.errorbar(
        values, positions, xerr=finite, fmt="none", ecolor=axes.xaxis.label.get_color(), capsize=2, linewidth=1.0
    )
    axes.axvline(0.0, color="0.5", linewidth=0.8)
    axes.set_yticks(positions, names, fontsize=8)
    axes.locator_params(axis="x", nbins=4)  # numbers of many digits would overlap
    axes.set(xlabel=f"coefficient ({unit})", ylim=(len(names) - 0.4, -0.6))  # the first on top
    # Error bars may be too short to be visible: write their numbers beside the graph.
    margin = axes.get_yaxis_transform()
    for k, pair in enumerate(map(with_error, values, errors)):
        number, error = map(drawing.true_minus, pair)
        axes.text(1.02, k, f"{number} ± {error.replace('inf', '∞')}", transform=margin, fontsize=8, va="center")
    axes.set_title(f"{title}\nfitted coefficients ± standard errors", fontsize=9)
    return figure


_TERMS = 5.4  # width of the graph of fitted terms with names and numbers, inches


_REASONS = {
    "saturated": ("s", "C3"),
    "edge": ("^", "C1"),
    "masked": ("D", "C5"),
    "neighbor": ("o", "C4"),
    "defect": ("x", "C2"),
}


_MASKED = "#f7cdbb"  # colour of NaN and masked pixels


def collimation(image: Array, star: tuple[float, float, float], angle: float | None, title: str) -> Axes:
    """Draw a defocused star, its first row at the top, with the direction of coma and the hours of a clock.

    `star` are its row, column and radius, pixels, and `angle` is counterclockwise from the right, None for none.
    """
    axes = drawing.new_axes(None, (5.4, 5.7))
    row, column, radius = star
    axes.imshow(image, cmap="gray", interpolation="nearest")
    for hour in range(1, 13):
        turn = math.radians(30.0 * hour)
        place = column + 1.75 * radius * math.sin(turn), row - 1.75 * radius * math.cos(turn)
        axes.text(*place, str(hour), color="w", fontsize=9, ha="center", va="center")
    if angle is not None:
        tail = column + 1.55 * radius * math.cos(angle), row - 1.55 * radius * math.sin(angle)
        axes.annotate("", tail, (column, row), arrowprops={"arrowstyle": "->", "color": "C1", "linewidth": 2.0})
    axes.set(xlim=(column - 2.0 * radius, column + 2.0 * radius), ylim=(row + 2.0 * radius, row - 2.0 * radius))
    axes.set(xticks=[], yticks=[], facecolor="k")
    axes.set_title(drawing.fit_to_width(title, axes, 10), fontsize=10)
    return axes


def spots(
    image: Array,
    places: Values,
    box: tuple[int, int],
    refused: Sequence[tuple[int, int, str]],
    title: str,
    ax: Axes | None,
) -> Axes:
    """Draw an image with windows of size `box` at accepted spots, and markers at rejected (row, column, reason)."""
    axes = drawing.new_axes(ax, (7.0, 7.0 * min(max(image.shape[0] / image.shape[1], 0.4), 1.4) + 0.8))
    low, high = np.nanpercentile(image, [1.0, 99.8])
    norm = library("matplotlib.colors", *drawing.USER).PowerNorm(0.5, low, max(high, low + 1e-9), clip=True)
    axes.imshow(image, cmap="gray_r", norm=norm, interpolation="nearest")
    axes.set_facecolor(_MASKED)
    rectangle = library("matplotlib.patches", *drawing.USER).Rectangle
    for k, (row, column) in enumerate(places.tolist()):
        corner = column - box[1] // 2 - 0.5, row - box[0] // 2 - 0.5
        label = "window" if k == 0 else None
        axes.add_patch(rectangle(corner, box[1], box[0], fill=False, edgecolor="C0", linewidth=1.0, label=label))
    for reason, (marker, colour) in _REASONS.items():
        points = np.array([(column, row) for row, column, code in refused if code == reason])
        if points.size:
            axes.plot(*points.T, marker, markersize=6, color=colour, fillstyle="none", label=f"refused: {reason}")
    if len(places) or refused:
        axes.legend(fontsize=8, loc="upper left", bbox_to_anchor=(0.0, -0.13), ncols=3, frameon=False)
    axes.set(xlabel="column", ylabel="row", xlim=(-0.5, image.shape[1] - 0.5), ylim=(image.shape[0] - 0.5, -0.5))
    axes.set_title(drawing.fit_to_width(title, axes, 10), fontsize=10)
    return axes


def bead_maps(x: Array, y: Array, maps: Sequence[tuple[str, Array, str]]) -> Figure:
    """Draw maps of quantities of beads, each (name, values, unit), at positions x and y in the sample, metres."""
    columns = min(len(maps), 3)
    rows = math.ceil(len(maps) / columns)
    figure = drawing.new_figure((3.1 * columns, 2.7 * rows))
    panels = figure.subplots(rows, columns, squeeze=False)
    for k, (panel, (name, values, unit)) in enumerate(zip(panels.flat, maps, strict=False)):
        dots = panel.scatter(1e6 * x, 1e6 * y, c=values, s=34, cmap="viridis")
        panel.set(aspect="equal", xlabel="x (µm)", ylabel="y (µm)")
        panel.invert_yaxis()  # as in the image
        panel.margins(0.12)
        panel.set_title(f"{name} ({unit})" if unit else name, fontsize=9)
        panel.tick_params(labelsize=7)
        drawing.only_outer(panel, k, len(maps), columns)
        figure.colorbar(dots, ax=panel, shrink=0.8).ax.tick_params(labelsize=7)
    for empty in panels.flat[len(maps) :]:
        empty.remove()
    return figure


def bead_curves(curves: Sequence[tuple[str, str, str, Mapping[str, tuple[Any, Array, Array]]]]) -> Figure:
    """Draw panels (title, x label, y label, series); a series is x, values and standard errors (NaN: none)."""
    figure = drawing.new_figure((3.4 * len(curves), 3.0))
    for panel, (title, along, label, series) in zip(
        figure.subplots(1, len(curves), squeeze=False).flat, curves, strict=True
    ):
        for (name, (x, values, errors)), mark in zip(series.items(), "os^vDP" * len(series), strict=False):
            panel.errorbar(x, values, errors, fmt=mark, markersize=3.5, linewidth=1.0, label=name)
        panel.set_title(title, fontsize=9)
        panel.set_xlabel(along, fontsize=8)
        panel.set_ylabel(label, fontsize=8)
        panel.tick_params(labelsize=7)
        panel.grid(alpha=0.3)
        panel.margins(0.08, 0.15)
        if any(isinstance(one, str) for x, *_ in series.values() for one in x):
            panel.tick_params(axis="x", labelrotation=30)
        if len(series) > 1:
            panel.legend(fontsize=6, framealpha=0.0, ncols=2, loc="upper center", bbox_to_anchor=(0.5, -0.25))
    return figure
