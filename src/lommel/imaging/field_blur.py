"""Blur that varies over the field of view and with depth, as a linear operator."""

from __future__ import annotations

import copy
import math
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import cache, reduce
from itertools import pairwise
from typing import Annotated, Any, NamedTuple, cast

import numpy as np
import scipy
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.base.options import In, listed
from lommel.base.threads import side_by_side
from lommel.deconvolve.linear import LinearBlur, copies, folded
from lommel.field.maps import FieldMap, require_light, require_one_aperture
from lommel.field.psf_grid import sides
from lommel.imaging.blur import require_depth, require_lens, warn_of_depths
from lommel.imaging.sensor_light import too_large
from lommel.imaging.settings import SizeOptions, Spectrum, WindowOptions, spectra
from lommel.imaging.spline_nodes import ERROR_RATIO, MAX_NODES, Nodes, sufficient_nodes, window_difference
from lommel.imaging.window_blur import LARGEST, WindowBlur
from lommel.optics.lens import Lens
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import psf


@dataclass(frozen=True, kw_only=True)
class FieldPhotographOptions(WindowOptions):
    """Options of photographs through a field map.

    Parameters
    ----------
    tol : float, default 1e-3
        Largest sum of absolute differences between an interpolated and an exact window, both of sum 1; 1e-6 to 1e-1.
        Checked half-way between nodes.
    """

    tol: Annotated[float, In(least=1e-6, most=0.1)] = 1e-3


@dataclass(frozen=True, kw_only=True)
class FieldOptions(SizeOptions, FieldPhotographOptions):
    """Options of a blur that varies over the field."""


@listed(FieldOptions)
class FieldBlur(LinearBlur):
    """Blur that varies over the field and with depth, a linear operator: ``out[q] = sum_p image[p] K_p(q - p)``.

    K_p is the pixel-integrated PSF of the source point p, at its field position and, if `depth` is given, at its
    distance. It is truncated to a window (a square of pixels, of one size for all points) that contains at least the
    fraction `energy` of the light, and normalised to sum 1. Windows are computed at nodes (positions over the field
    and over defocus) and interpolated by splines; the number of nodes follows from `tol`.

    Parameters
    ----------
    field_map : FieldMap
        Wavefronts over the field.
    shape : int or (int, int)
        Height and width of the image, pixels.
    pixel : float
        Pixel pitch, in the unit of the map (metres if it has a wavelength).
    depth : array_like, shape (height, width), optional
        Distance of each point from the lens along the axis, metres, positive or infinite. The defocus of `lens` at
        this distance is added to the wavefront of the map.
    lens : Lens, optional
        Lens for the defocus, without aberrations, with the wavelength, f-number and aperture of the map. Required
        with `depth`, and not accepted without `depth`.
    center : (float, float), optional
        Row and column of the optical axis, in pixels from the centre of the first pixel; by default the centre of
        the image. For a crop the axis may lie outside the image.
    sensor : (float, float), optional
        Height and width of the part of the field that the image shows, in the unit of the map; by default
        ``shape * pixel``. A larger sensor exaggerates the blur, to illustrate a lens over its whole field.
    channels : sequence, default (wavelength of the map,)
        For each channel a wavelength (metres), or a spectrum: pairs of wavelength and weight.
    {options}

    Attributes
    ----------
    banks : tuple of FieldBank
        Bank (table of windows) of each channel.
    error : float
        Largest sum of absolute differences between interpolated and exact windows, over the checked positions of all
        channels.
    lost : float
        Largest fraction of the light outside a window, over the checked positions. The sum of absolute differences
        between a window and the whole PSF is at most ``error + 2 * lost``.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, if the image extends beyond the map, if a window exceeds `largest`, or if the
        windows of a channel have more than 2^27 values in total.

    Notes
    -----
    Each source point spreads its light by its own PSF (scatter), as in a lens. Averaging around each pixel with the
    PSF of that pixel (gather) would be the transpose. Light is conserved: for a lens with vignetting, multiply the
    image by the relative illumination first.

    At its edges the image is mirrored; the copy of a point has the PSF of the original.

    Examples
    --------
    >>> field = lm.FieldMap.from_seidel(6e-3, W131=1.5, W222=1.0, wavelength=550e-9, f_number=4.0)
    >>> blur = lm.imaging.FieldBlur(field, (60, 80), 2e-6, center=(2000.0, -1500.0))
    >>> star = np.zeros((60, 80))
    >>> star[30, 40] = 1.0
    >>> blur.forward(star).shape
    (60, 80)
    """

    def __init__(
        self,
        field_map: FieldMap,
        shape: int | tuple[int, int],
        pixel: float,
        *,
        depth: ArrayLike | None = None,
        lens: Lens | None = None,
        center: tuple[float, float] | None = None,
        sensor: tuple[float, float] | None = None,
        channels: Sequence[Spectrum] | None = None,
        **given: Any,
    ) -> None:
        validation.instance("field_map", field_map, FieldMap)
        require_one_aperture(field_map)
        pupil = field_map.pupil_without_wavefront
        metric = pupil.wavelength is not None
        self.field_map, self.shape = field_map, validation.image_shape(shape)
        self.pixel = validation.pixel(pixel, metric=metric)
        validation.pixel_on(self.pixel, pupil.scale, metric=metric)
        o = FieldOptions.of("FieldBlur", None, given)
        self.tol, self.dtype = o.tol, cast("np.dtype[np.floating]", o.dtype)
        self._scaled = sensor is not None  # the pixels of the image are not those of the PSFs
        if channels is not None and not metric:
            raise ValueError("channels need a map with a wavelength; make the map with wavelength= and f_number=")
        self.spectra = (None,) if channels is None else spectra("channels", channels)
        self.channels = len(self.spectra)
        self.y, self.x = self._field_positions(center, sensor)
        self.lens, self.defocus = lens, self._defocus_map(depth, lens)
        spans = [(float(positions[0]), float(positions[-1])) for positions in (self.y, self.x)]
        spans.append((float(self.defocus.min()), float(self.defocus.max())))

        # Channels with equal spectra share a bank: computing windows takes most of the time.
        @cache
        def bank(spectrum: tuple[tuple[float, float], ...] | None) -> FieldBank:
            phase, psf_tol = None if lens is None else lens.phase, min(1e-6, 1e-3 * o.tol)
            source = self._point_light(field_map, phase, spectrum, self.pixel, psf_tol)
            return build_field_bank(source, spans, self.shape, o)

        self.banks = tuple(map(bank, self.spectra))
        self._operators = tuple(map(cache(self._operator), self.banks))

    @property
    def error(self) -> float:
        """Largest sum of absolute differences between interpolated and exact windows, at the checked positions."""
        return max(bank.error + blur.error for bank, blur in zip(self.banks, self._operators, strict=True))

    @property
    def lost(self) -> float:
        """Largest fraction of the light outside a window, at the checked positions."""
        return max(bank.lost for bank in self.banks)

    def crop(
        self, shape: int | tuple[int, int], *, center: tuple[float, float], depth: ArrayLike | None = None
    ) -> FieldBlur:
        """Return the blur of a part of this image, or with another depth, without computing new windows.

        For data sets: the windows of the whole image are computed once, and each crop takes a few milliseconds.

        Parameters
        ----------
        shape : int or (int, int)
            Height and width of the crop, pixels. The size of the windows does not change.
        center : (float, float)
            Row and column of the optical axis, in pixels from the centre of the first pixel of the crop.
        depth : array_like, shape (height, width), optional
            Distances (m) within the depth range of this blur. Required if this blur has a depth.

        Returns
        -------
        FieldBlur
            It shares the `banks` of this blur.

        Raises
        ------
        TypeError, ValueError
            If an argument is out of range, if the crop exceeds the image or the depth range of this blur, or if this
            blur was made with ``sensor=``: its image and its PSFs have different pixel pitches.

        Examples
        --------
        >>> field = lm.FieldMap.from_seidel(6e-3, W131=1.5, W222=1.0, wavelength=550e-9, f_number=4.0)
        >>> whole = lm.imaging.FieldBlur(field, (600, 800), 4e-6)
        >>> part = whole.crop(64, center=(299.5 - 100, 399.5 - 500))  # rows from 100, columns from 500
        >>> star = np.zeros((64, 64))
        >>> star[20, 30] = 1.0
        >>> bool(np.allclose(part.window(20, 30), whole.window(120, 530)))
        True
        """
        if self._scaled:
            raise ValueError("crop needs a blur made without sensor=, which changes the pixel pitch of the image")
        crop = copy.copy(self)
        crop.shape = validation.image_shape(shape)
        crop.y, crop.x = crop._field_positions(validation.position("center", center), None)
        lens = self.lens
        if (depth is None) != (lens is None):
            requirement = "must not have a depth" if lens is None else "needs a depth"
            raise ValueError(f"crop {requirement}, like the blur that it is a part of")
        crop.defocus = crop._defocus_map(depth, lens)
        for name, positions, axis in zip(
            ("rows", "columns", "defocus"), (crop.y, crop.x, crop.defocus), self.banks[0].axes, strict=True
        ):
            first, last = axis.first, axis.last
            # Rounding may exceed the nodes by up to 1e-3 pixel; splines are constant beyond their ends.
            slack = 1e-6 * (last - first) + (1e-3 * self.pixel if name != "defocus" else 1e-9)
            if not (first - slack <= positions.min() and positions.max() <= last + slack):
                unit = "rad" if name == "defocus" else self.field_map.unit
                raise ValueError(
                    f"crop must be within the blur that it is a part of: its {name} span {positions.min():.6g} to "
                    f"{positions.max():.6g} {unit}, the {name} of the blur {first:.6g} to {last:.6g} {unit}"
                )
        crop._operators = tuple(map(cache(crop._operator), self.banks))
        return crop

    @property
    def _point_light(self) -> type[PointLight]:
        """Class that computes the PSFs of points."""
        return PointLight

    def window(self, row: int, column: int, channel: int = 0) -> Array:
        """Return the PSF (side, side) of the point at `row`, `column` in a `channel`.

        Raises ValueError for a row, column or channel outside the image.
        """
        height, width = self.shape
        row = validation.integer("row", row, least=0, most=height - 1)
        column = validation.integer("column", column, least=0, most=width - 1)
        bank = self.banks[validation.integer("channel", channel, least=0, most=self.channels - 1)]
        return bank.window(float(self.y[row]), float(self.x[column]), float(self.defocus[row, column]))

    def forward(self, image: Values) -> Values:
        """Return the blurred `image`: see :meth:`lommel.imaging.LinearBlur.forward`."""
        return self.by_channel(image, lambda channel, plane: self._operators[channel].forward(plane))

    def adjoint(self, image: Values) -> Values:
        """Return the transpose of :meth:`forward` of `image`: see :meth:`lommel.imaging.LinearBlur.adjoint`."""
        return self.by_channel(image, lambda channel, plane: self._operators[channel].adjoint(plane))

    def _field_positions(
        self, center: tuple[float, float] | None, sensor: tuple[float, float] | None
    ) -> tuple[Array, Array]:
        """Return the field coordinates of rows y (height,) and columns x (width,), in the unit of the map."""
        unit = self.field_map.unit
        axis = [0.5 * (side - 1) for side in self.shape] if center is None else validation.position("center", center)
        pitch = [self.pixel] * 2
        if sensor is not None:
            pitch = [length / side for length, side in zip(sides(sensor, unit), self.shape, strict=True)]
        self._pitch = pitch
        y, x = (
            np.asarray(step * (np.arange(n) - centre), dtype=np.float64)
            for step, n, centre in zip(pitch, self.shape, axis, strict=True)
        )
        try:
            self._require_within_map(x[[0, -1]], y[[0, -1], None])
        except ValueError as error:
            height, width = self.shape
            raise ValueError(
                f"{error}: the image spans {height} x {width} pixels with y from {y[0]:.4g} to {y[-1]:.4g} and "
                f"x from {x[0]:.4g} to {x[-1]:.4g} {unit}; use a smaller shape, another center= (row and column of "
                "the axis), or a map of a larger field"
            ) from None
        return y, x

    def _require_within_map(self, x: Array, y: Array) -> None:
        """Raise ValueError for positions outside of the map."""
        self.field_map.pupil(x, y)

    def _defocus_map(self, depth: ArrayLike | None, lens: Lens | None) -> Array:
        """Return the defocus C_d (rad) of each point, shape (height, width); 0 without a depth."""
        if (depth is None) != (lens is None):
            absent = "lens" if lens is None else "depth"
            raise ValueError(f"{absent} is missing: depth= and lens= must be given together")
        if lens is None or depth is None:
            # A read-only view of one number: without a depth map, defocus is 0 everywhere.
            return np.broadcast_to(0.0, self.shape)
        require_lens(lens, "field_map, shape, pixel, and depth= and lens=")
        distances = require_depth(depth)
        if distances.shape != self.shape:
            raise ValueError(f"depth must have the shape of the image, {self.shape}, got {distances.shape}")
        require_light(self.field_map.pupil_without_wavefront, lens)
        warn_of_depths(lens, self.pixel, distances)
        defocus = lens.defocus(distances)
        defocus.flags.writeable = False
        return defocus

    def _operator(self, bank: FieldBank) -> WindowBlur | MixedBlur:
        """Return the operator of a channel."""
        # Small windows are interpolated for each point directly; for large windows Fourier transforms are faster.
        focus = bank.axes[2]
        if bank.coefficients.shape[-1] <= LARGEST[min(2, focus.count)]:
            # ArithmeticError: WindowBlur replaces the splines by parabolas, and would need too many pieces.
            with suppress(ArithmeticError):
                return WindowBlur(
                    bank.coefficients, bank.axes, self.y, self.x, self.defocus, allowed=self.tol - bank.error
                )  # fmt: skip
        weights = bank.axes[0].weights(self.y), bank.axes[1].weights(self.x)
        return MixedBlur(bank.coefficients, weights, focus, self.defocus)


_MAX_KEPT_BYTES = 2**29  # transforms of all windows are cached up to this size, 512 MiB
_LONGEST = 512  # longest transform; windows above 1/4 of this length have transforms up to 4 times their own length
_OVERHEAD = 20_000  # time of a block without its transforms / time of a transform per sample


class Block(NamedTuple):
    """A block of points, and the nodes down and across the image that have nonzero weights in it."""

    rows: slice
    columns: slice
    row_nodes: slice
    column_nodes: slice


class MixedBlur:
    """Blur by windows that are weighted sums over nodes, computed by Fourier transforms, and its transpose.

    ``out[q] = sum_kl sum_p D[p_y, k] A[p_x, l] sum_i c_i[p] x[p] W[k, l, i, q - p]``. Since transforms are linear, a
    block of points takes one forward transform for each of its nodes, but a single inverse transform. Transforms
    along rows do not depend on the weights D down the image, and are therefore computed before D is applied.

    Parameters
    ----------
    windows : ndarray, shape (k, l, i, side, side)
        Spline coefficients W over nodes down and across the image and over defocus.
    weights : two ndarray, shapes (height, k) and (width, l)
        D and A.
    focus : Nodes
        Nodes over defocus, with the weights c.
    defocus : ndarray, shape (height, width)
        C_d in radians.
    threads : int
    """

    error = 0.0  # the splines are evaluated exactly

    def __init__(
        self,
        windows: Values,
        weights: tuple[Array, Array],
        focus: Nodes,
        defocus: Array,
        *,
        threads: int = 0,
    ) -> None:
        self.windows, self.focus, self.defocus, self.threads = windows, focus, defocus, threads
        self.excess = windows.shape[-1] - 1  # rows and columns by which the result of a block exceeds the block
        margin = self.excess // 2
        self.image_start = 2 * margin  # index of the image's first pixel in the padded result
        self.rows, self.columns = (copies(len(part), margin) for part in weights)
        self.down, self.across = weights[0][self.rows], weights[1][self.columns]
        self.down, self.across = (part.astype(windows.dtype) for part in (self.down, self.across))
        self.sides = _sides(self.down.shape, self.across.shape, self.excess + 1)
        self._parts = (
            _parts(self.down, self.sides[0] - self.excess),
            _parts(self.across, self.sides[1] - self.excess),
        )
        self._spectra: Values | None = None

    def forward(self, plane: Values) -> Values:
        """Return the blurred image of a plane of light."""
        light = plane[self.rows[:, None], self.columns]
        # The results of neighbouring blocks overlap by the size of a window, and are added (overlap-add).
        padded = np.zeros([side + self.excess for side in light.shape], dtype=light.dtype)

        def blurred(block: Block) -> Values:
            points = light[block.rows, block.columns]
            spectra = (
                self._blurred_spectrum(block, weight * points, node) for node, weight in self._focus_weights(block)
            )
            return self._inverse_transform(reduce(np.add, spectra), [side + self.excess for side in points.shape])

        for block, part in self._results(blurred):
            padded[self._reached_area(block)] += part
        return padded[self.image_start :, self.image_start :][: plane.shape[0], : plane.shape[1]]

    def adjoint(self, plane: Values) -> Values:
        """Return the transpose of :meth:`forward` applied to an image."""
        # Overlap-save: a block of the result depends on the pixels that the light of the block reaches in `forward`.
        padded = np.pad(plane, self.image_start)
        result = np.empty((len(self.rows), len(self.columns)), dtype=plane.dtype)

        def correlated(block: Block) -> Values:
            spectrum = self._transform(padded[self._reached_area(block)])
            parts = (weight * self._correlated(block, spectrum, node) for node, weight in self._focus_weights(block))
            return reduce(np.add, parts)

        for block, part in self._results(correlated):
            result[block.rows, block.columns] = part
        return folded(result, (self.excess // 2,) * 2, plane.shape)

    def _results(self, function: Callable[[Block], Values]) -> Iterator[tuple[Block, Values]]:
        """Yield pairs (block, function(block)); the blocks of one row of blocks are computed in parallel."""
        for rows, row_nodes in self._parts[0]:
            blocks = [Block(rows, columns, row_nodes, column_nodes) for columns, column_nodes in self._parts[1]]
            yield from zip(blocks, side_by_side(function, blocks, self.threads), strict=True)

    def _reached_area(self, block: Block) -> tuple[slice, slice]:
        """Return the rows and columns of the padded image that the light of a block reaches."""
        rows, columns = (slice(part.start, part.stop + self.excess) for part in (block.rows, block.columns))
        return rows, columns

    def _focus_weights(self, block: Block) -> list[tuple[int, Values]]:
        """Return the nodes over defocus with nonzero weights in a block, each with its weights at the points."""
        places = self.defocus[self.rows[block.rows][:, None], self.columns[block.columns]]
        return [(node, weight.astype(self.windows.dtype)) for node, weight in self.focus.nonzero_weights(places)]

    def _blurred_spectrum(self, block: Block, points: Values, node: int) -> Values:
        """Return the transform of the image of points (rows, columns), with the windows at one node over defocus."""
        down, across = self.down[block.rows, block.row_nodes], self.across[block.columns, block.column_nodes]
        # Rows are transformed once for each node across; weights down the image multiply the result.
        lines = scipy.fft.rfft(across.T[:, None, :] * points, n=self.sides[1], axis=-1)
        planes = down.T[:, None, :, None] * lines
        spectra = scipy.fft.fft(planes, n=self.sides[0], axis=-2, overwrite_x=True)
        # Sum over nodes before the inverse transform: one inverse transform is enough.
        spectra *= self._window_spectra(block, node)
        return np.asarray(spectra.sum(axis=(0, 1)))

    def _inverse_transform(self, spectrum: Values, shape: Sequence[int]) -> Values:
        """Return the first rows and columns of the inverse transform."""
        lines = scipy.fft.ifft(spectrum, axis=0, overwrite_x=True)[: shape[0]]
        return np.asarray(scipy.fft.irfft(lines, n=self.sides[1], axis=1)[:, : shape[1]])

    def _correlated(self, block: Block, spectrum: Values, node: int) -> Values:
        """Return the transpose of :meth:`_blurred_spectrum` and :meth:`_inverse_transform`."""
        down, across = self.down[block.rows, block.row_nodes], self.across[block.columns, block.column_nodes]
        spectra = np.conj(self._window_spectra(block, node))
        spectra *= spectrum
        planes = scipy.fft.ifft(spectra, axis=-2, overwrite_x=True)[..., : len(down), :]
        planes = planes * down.T[:, None, :, None]
        lines = scipy.fft.irfft(planes.sum(axis=0), n=self.sides[1], axis=-1)[..., : len(across)]
        return np.asarray((lines * across.T[:, None, :]).sum(axis=0))

    def _window_spectra(self, block: Block, node: int) -> Values:
        """Return the transforms of the windows of a block at one node over defocus; cached if all fit in memory."""
        if self._spectra is None:
            count, size = math.prod(self.windows.shape[:3]), self.sides[0] * (self.sides[1] // 2 + 1)
            if count * size * 2 * self.windows.itemsize > _MAX_KEPT_BYTES:
                return self._transform(self.windows[block.row_nodes, block.column_nodes, node])
            self._spectra = self._transform(self.windows)
        return self._spectra[block.row_nodes, block.column_nodes, node]

    def _transform(self, images: Values) -> Values:
        """Return the Fourier transforms over the last two axes, zero-padded to the sides of a block."""
        lines = scipy.fft.rfft(images, n=self.sides[1], axis=-1)
        return np.asarray(scipy.fft.fft(lines, n=self.sides[0], axis=-2, overwrite_x=True))


def _sides(down: tuple[int, ...], across: tuple[int, ...], window: int) -> tuple[int, int]:
    """Return the numbers of rows and columns of the transforms that minimise the computing time.

    `down` and `across` are (number of points, number of nodes) along the axes; `window` is the side of a window.
    """
    # Along each axis f is the length of the transform, b the number of points of a block, n the number of blocks.
    rows, columns = (_candidates(points, window) for points, _ in (down, across))
    best = (math.inf, (0, 0))  # computing time, lengths of the transforms
    for fy, by, ny in ((f, b, math.ceil(down[0] / b)) for f, b in rows):
        for fx, bx, nx in ((f, b, math.ceil(across[0] / b)) for f, b in columns):
            # Number of transforms of a block: one for each node with nonzero weights. A cubic spline has at least
            # four such nodes along each axis.
            transforms = 2.0 + math.prod(
                min(count, 4.0 + block * (count - 1) / points)
                for block, (points, count) in ((by, down), (bx, across))
            )
            best = min(best, (ny * nx * (fy * fx * transforms * math.log2(fy * fx) + _OVERHEAD * 10.0), (fy, fx)))
    return best[1]


def _candidates(points: int, window: int) -> list[tuple[int, int]]:
    """Return pairs: a length for which the transform is fast, and the number of points of a block of this length."""
    longest = scipy.fft.next_fast_len(min(points + window - 1, max(_LONGEST, 4 * window)), real=True)
    sides, side = [], window
    while side <= longest:
        side = scipy.fft.next_fast_len(side, real=True)
        sides.append((side, side - window + 1))
        side += 1
    return [pair for pair in sides if pair[1] >= min(points, 8)] or sides[-1:]


def _parts(weights: Values, length: int) -> list[tuple[slice, slice]]:
    """Divide points into parts of at most `length`, and return pairs (points, nodes with nonzero weights).

    `weights` has the shape (points, nodes).
    """
    parts = []
    count = math.ceil(len(weights) / length)
    edges = [round(k * len(weights) / count) for k in range(count + 1)]
    for first, last in pairwise(edges):
        nonzero = np.flatnonzero(weights[first:last].any(axis=0))
        parts.append((slice(first, last), slice(int(nonzero[0]), int(nonzero[-1]) + 1)))
    return parts


_MAX_VALUES = 2**27  # numbers in a bank: 1 GiB in double precision
_MAX_CHECKED = 1500  # largest number of positions half-way between nodes at which windows are checked
_QUINTIC_BELOW = 3e-4  # tolerance below which splines of degree 5 are faster than cubic ones
# Fractions of the tolerance. First, for splines along 1, 2 or 3 axes in total: above 1, since the errors of different
# axes peak at different positions. Second, for splines replaced by parabolas.
_SPLINE_SHARES = (0.9, 1.2, 1.4)
_PARABOLA_SHARE = 0.03


@dataclass(frozen=True, eq=False)
class FieldBank:
    """PSF windows of one channel over field position and defocus.

    Attributes
    ----------
    axes : tuple of three Nodes
        Nodes along y and x in the field, and along defocus (radians at the wavelength of the map).
    coefficients : ndarray, shape (y, x, defocus, side, side)
        Spline coefficients along these axes. Every interpolated window has the sum 1.
    lost : float
        Largest fraction of the light outside a window.
    error : float
        Largest sum of absolute differences between interpolated and exact windows, checked half-way between nodes.
    """

    axes: tuple[Nodes, ...]
    coefficients: Values
    lost: float
    error: float

    @property
    def half(self) -> int:
        """Half width of a window, pixels."""
        return int(self.coefficients.shape[-1]) // 2

    @property
    def count(self) -> int:
        """Number of windows."""
        return math.prod(self.coefficients.shape[:3])

    def window(self, y: float, x: float, defocus: float = 0.0) -> Array:
        """Return the light of a point at `y`, `x` in the field and `defocus` C_d in radians, shape (side, side)."""
        return next(_interpolated_windows(self.axes, self.coefficients, np.array([[y, x, defocus]])))


def build_field_bank(source: PointLight, spans: Sequence[Span], shape: tuple[int, int], o: FieldOptions) -> FieldBank:
    """Return the bank of one channel for images of this shape; ValueError if windows or bank would be too large.

    `spans` are the ranges of y, x and C_d. The tolerance is divided among splines and parabolas.
    """
    energy, tol, largest = o.energy, o.tol, o.largest or max(1, min(shape) // 2)
    half, core_half = source.half_widths(spans, energy, largest)
    spline_tol = (1.0 - _PARABOLA_SHARE) * tol
    axes = _axes(source, spans, min(core_half, half), spline_tol)
    previous_error = 0.0 if all(nodes.count == 1 for nodes in axes) else math.inf
    while True:
        side = 2 * half + 1
        _require_few(axes, side, tol)
        windows = source.windows(lattice([nodes.places for nodes in axes]), half)
        energies = windows.sum(axis=(1, 2))
        # The half width was estimated at a few positions, and PSFs between these positions may be wider.
        if energies.min() < energy:
            if half == largest:
                raise too_large(largest, energy, float(energies.min()))
            half = min(largest, math.ceil(1.05 * half) + 1)
            continue
        windows /= energies[:, None, None]
        coefficients: Values = windows.reshape(*(nodes.count for nodes in axes), side, side)
        for axis, nodes in enumerate(axes):
            coefficients = nodes.coefficients(coefficients, axis)
        error, least_energy = _error_between(source, axes, coefficients)
        if error <= spline_tol:
            lost = 1.0 - min(float(energies.min()), least_energy)
            return FieldBank(axes, coefficients.astype(cast("np.dtype[np.floating]", o.dtype)), lost, error)
        degree = axes[0].degree
        # The error of a spline of degree d is proportional to spacing^(d + 1); the aim is 0.9 spline_tol.
        factor = max(1.02, (error / (0.9 * spline_tol)) ** (1.0 / (degree + 1)))
        # If denser nodes do not reduce the error, axes with a single node may need more nodes.
        change_single, previous_error = error > 0.9 * previous_error, error
        axes = _finer(axes, factor, change_single=change_single)


def _finer(axes: Sequence[Nodes], factor: float, *, change_single: bool) -> tuple[Nodes, ...]:
    """Return axes with the number of gaps multiplied by `factor`; a single node changes only if `change_single`."""
    return tuple(
        nodes.finer(factor) if nodes.first < nodes.last and (change_single or nodes.count > 1) else nodes
        for nodes in axes
    )


def _require_few(axes: Sequence[Nodes], side: int, tol: float) -> None:
    """Raise ValueError if a bank would be too large."""
    if math.prod(nodes.count for nodes in axes) * side * side > _MAX_VALUES:
        counts = " x ".join(str(nodes.count) for nodes in axes)
        raise ValueError(
            f"a bank of {counts} windows (down, across, over defocus) of {side} x {side} pixels exceeds the "
            f"limit of {_MAX_VALUES} values; increase tol={tol:g}, reduce energy, or compute parts of the image "
            "(center=)"
        )


def _error_between(source: PointLight, axes: Sequence[Nodes], coefficients: Values) -> tuple[float, float]:
    """Return the largest error of interpolated windows half-way between nodes, and the smallest sum of exact windows.

    Exact windows are divided by their sums before the comparison.
    """
    places = lattice([nodes.between if nodes.count > 1 else np.unique([nodes.first, nodes.last]) for nodes in axes])
    # A fixed seed: equal arguments yield equal errors.
    if len(places) > _MAX_CHECKED:
        places = places[np.random.default_rng(0).choice(len(places), _MAX_CHECKED, replace=False)]
    exact = source.windows(places, coefficients.shape[-1] // 2)
    energies = exact.sum(axis=(1, 2))
    exact /= energies[:, None, None]
    # An error of the sum of a window causes an equal error of the light outside, and therefore counts twice.
    error = ERROR_RATIO * max(
        window_difference(window, exact_window) + abs(float((window - exact_window).sum()))
        for window, exact_window in zip(_interpolated_windows(axes, coefficients, places), exact, strict=True)
    )
    return error, float(energies.min())


def _axes(source: PointLight, spans: Sequence[Span], half: int, tol: float) -> tuple[Nodes, ...]:
    """Return nodes along y, x and C_d that are dense enough for windows of this half width.

    Each axis is sampled along lines through the start, middle and end of the other two spans.
    """
    # Splines of degree 5 need fewer nodes, but more nonzero weights at each point: faster if there are many nodes.
    degree = 5 if tol < _QUINTIC_BELOW or spans[2][0] < spans[2][1] else 3
    varying_count = max(1, sum(first != last for first, last in spans))
    axis_tol = _SPLINE_SHARES[varying_count - 1] * tol / varying_count
    axes = []
    for axis, span in enumerate(spans):
        other_ticks = [np.unique(np.linspace(*other, 3)) for other in spans]

        def sample(positions: Array, axis: int = axis, other_ticks: list[Array] = other_ticks) -> Array:
            """Return windows (lines, len(positions), side, side) at positions along the axis."""
            ticks = [positions if k == axis else other for k, other in enumerate(other_ticks)]
            windows = source.windows(lattice(ticks), half)
            windows /= windows.sum(axis=(1, 2), keepdims=True)
            shaped = windows.reshape(*(len(tick) for tick in ticks), *windows.shape[1:])
            return np.moveaxis(shaped, axis, 2).reshape(-1, len(positions), *windows.shape[1:])

        nodes = sufficient_nodes(sample, *span, axis_tol, degree)
        if nodes is None:
            direction = ("down the image", "across the image", "over the depth")[axis]
            raise ValueError(
                f"the PSF changes so much {direction} that more than {MAX_NODES} windows are needed; increase "
                f"tol={tol:g}, or compute parts of the image (center=)"
            )
        axes.append(nodes)
    return tuple(axes)


def _interpolated_windows(axes: Sequence[Nodes], coefficients: Values, places: Array) -> Iterator[Array]:
    """Yield the window (side, side) of the splines at each place; places (n, 3) are y, x and C_d."""
    weights = [nodes.weights(coordinates) for nodes, coordinates in zip(axes, places.T, strict=True)]
    for place_weights in zip(*weights, strict=True):
        indices = [np.flatnonzero(axis_weights) for axis_weights in place_weights]
        window: Values = coefficients[np.ix_(*indices)]
        for axis_weights, nonzero in zip(place_weights, indices, strict=True):
            window = np.tensordot(axis_weights[nonzero], window, axes=(0, 0))
        yield window.astype(np.float64, copy=False)


CORE = 0.9  # the number of nodes is first estimated for windows that hold at most this fraction of the light

_MAX_BATCH_VALUES = 2**24  # number of window values computed in one call

Span = tuple[float, float]


@dataclass(frozen=True)
class PointLight:
    """The pixel-integrated PSF of a point anywhere in the field of a lens, at any defocus."""

    field_map: FieldMap
    phase: Callable[[Array], Wavefront] | None  # wavefronts for values of the defocus C_d; None: no defocus
    spectrum: Sequence[tuple[float, float]] | None  # wavelengths (m) and weights; None: the wavelength of the map
    pixel: float  # pixel pitch, in the unit of the map
    tol: float  # error of each PSF relative to its peak

    def pupil(self, y: Array, x: Array, defocus: Array) -> Pupil:
        """Return the stack of pupils at places in the field and values of the defocus, arrays of one shape."""
        pupil = self.field_map.pupil(x, y)
        return pupil if self.phase is None else pupil.carrying(pupil.wavefront + self.phase(defocus), None)

    def windows(self, places: Array, half: int) -> Array:
        """Return the windows (n, side, side) of points at y, x and C_d (n, 3): fractions of light on each pixel."""
        side = 2 * half + 1
        result = np.zeros((len(places), side, side))
        step = max(1, _MAX_BATCH_VALUES // side**2)
        for start in range(0, len(places), step):
            batch = slice(start, start + step)
            pupil = self.pupil(*places[batch].T)
            for wavelength, weight in self.spectrum or ((None, 1.0),):
                coloured = pupil if wavelength is None else pupil.in_light(wavelength)
                options: dict[str, Any] = {"integrate": True, "dtype": np.float64}
                result[batch] += weight * psf(coloured, side, self.pixel, tol=self.tol, **options).values
        return result

    def half_widths(self, spans: Sequence[Span], energy: float, largest: int) -> tuple[int, int]:
        """Return the half widths (pixels) of windows that hold `energy`, and that hold min(`energy`, `CORE`).

        The windows hold these fractions of the light at all positions of a coarse lattice over the spans.
        """
        places = overview(spans)
        half = math.ceil(float(self.pupil(*places.T).geometric_radius().max()) / self.pixel) + 1
        while True:
            half = min(half, largest)
            windows = self.windows(places, half)
            energies = windows.sum(axis=(1, 2))
            if energies.min() >= energy:
                return _smallest_half(windows, energy), _smallest_half(windows, min(energy, CORE))
            if half == largest:
                raise too_large(largest, energy, float(energies.min()))
            # Growth by 30 %: several windows that are too small take less time than one that is far too large.
            half = math.ceil(1.3 * half) + 1


def lattice(ticks: Sequence[Array]) -> Array:
    """Return all points of the lattice with these coordinates along three axes, (n, 3); the last varies fastest."""
    return np.stack([part.ravel() for part in np.meshgrid(*ticks, indexing="ij")], axis=1)


def overview(spans: Sequence[Span]) -> Array:
    """Return a coarse lattice over the spans of y, x and C_d, shape (n, 3)."""
    return lattice([np.unique(np.linspace(*span, 5 if axis < 2 else 3)) for axis, span in enumerate(spans)])


def _smallest_half(windows: Array, energy: float) -> int:
    """Return the half width of the smallest centred windows that all contain `energy` of the light."""
    half = int(windows.shape[-1]) // 2
    while half > 0:
        inner = windows[:, 1:-1, 1:-1]
        if inner.sum(axis=(1, 2)).min() < energy:
            break
        windows, half = inner, half - 1
    return half
