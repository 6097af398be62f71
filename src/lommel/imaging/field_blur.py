"""Blur that varies over the field of view and with depth, as a linear operator."""

from __future__ import annotations

import copy
import math
from bisect import bisect_left
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cache, partial, reduce
from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple, Unpack, cast

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.base.cached import cached_property
from lommel.base.options import shares
from lommel.base.threads import side_by_side
from lommel.deconvolve.linear import LARGEST, LinearBlur, WindowBlur, copies, without_copies
from lommel.field.maps import FieldMap, require_light, require_one_aperture
from lommel.field.psf_grid import sides
from lommel.imaging.blur import require_depth, require_lens, tell_of_depths
from lommel.imaging.sensor_light import too_large
from lommel.imaging.settings import FieldKeywords, Settings, Spectrum, spectra
from lommel.optics.lens import Lens
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import psf

if TYPE_CHECKING:
    from scipy.interpolate import BSpline
    from scipy.sparse import csr_array


@shares(FieldKeywords, Settings)
class FieldBlur(LinearBlur):
    """Blur that varies over the field and with depth, a linear operator: ``out[q] = sum_p image[p] K_p(q - p)``.

    K_p is the pixel-integrated PSF of the source point p, at its field position, and at its distance where a depth
    is given. It is truncated to a window that holds `energy` of its light, of one size for all points, and divided by
    the light in the window. Between nodes over the field (and over defocus) it is interpolated by splines; the nodes
    are chosen so that the error of K_p is below `tol`. With ``energy=1`` it is not truncated: the light beyond the
    windows is a kernel that all points share, scaled for each.

    Parameters
    ----------
    field_map : FieldMap
        Wavefronts over the field.
    shape : int or (int, int)
        Height and width of the image, pixels.
    pixel : float
        Pixel pitch, in the unit of the map (metres if it has a wavelength).
    depth : array_like, shape (height, width), optional
        Distance of each point from the lens along the axis, metres, positive; may be infinite. The defocus of `lens`
        for it is added to the wavefront of the map.
    lens : Lens
        Required with `depth`, and only with it: the lens that gives the defocus, of the wavelength, f-number and
        aperture of the map, without aberrations.
    center : (float, float), optional
        Row and column of the optical axis, in pixels from the centre of the first; by default the centre of the
        image. For a crop it may lie outside the image.
    sensor : (float, float), optional
        Height and width of the part of the field that the image shows, in the unit of the map; by default
        ``shape * pixel``. A larger one exaggerates the PSFs, to illustrate a lens over its whole field.
    channels : sequence, default (wavelength of the map,)
        For each channel a wavelength (metres), or its spectrum, pairs of wavelength and weight.
    tol : float, default 1e-3
        Bound on the sum of absolute differences between K_p and the exact window, each of sum 1; 1e-6 to 1e-1.
        Checked half-way between nodes.
    {options}

    Attributes
    ----------
    banks : tuple of FieldBank
        One for each channel.
    error : float
        Largest sum of absolute differences found between interpolated windows and exact ones, of any channel.
    lost : float
        Largest fraction found of the light beyond the windows. The sum of absolute differences between a window and
        the whole PSF is at most ``error + 2 * lost``.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range; if the image goes beyond the map; if the blur exceeds `largest`, or takes more
        than 2^27 values.

    Notes
    -----
    Each source spreads its light by its own PSF (scatter), as in a lens; to average around each pixel by its own PSF
    (gather) is the transpose. Light is conserved: for a lens that is darker towards the corners, multiply the image
    by its relative illumination first.

    Beyond the edges, a copy of a point ("reflect", "extend") spreads the PSF of the point that it copies.

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
        tol: float = 1e-3,
        **options: Unpack[FieldKeywords],
    ) -> None:
        validation.instance("field_map", field_map, FieldMap)
        require_one_aperture(field_map)
        light = field_map.pupil_without_wavefront
        metric = light.wavelength is not None
        self.field_map, self.shape = field_map, validation.image_shape(shape)
        self.pixel = validation.pixel(pixel, metric=metric)
        validation.pixel_on(self.pixel, light.scale, metric=metric)
        self.tol = validation.real("tol", tol, least=1e-6, below=0.1 + 1e-12)
        settings = Settings.of(FieldBlur, options, FieldKeywords)
        self.border, self.dtype = settings.border, cast("np.dtype[np.floating]", settings.dtype)
        self.threads = settings.threads or 0
        self._scaled = sensor is not None
        if channels is not None and not metric:
            raise ValueError("channels need a map with a wavelength, to which theirs are related")
        self.spectra = (None,) if channels is None else spectra("channels", channels)
        self.channels = len(self.spectra)
        self.y, self.x = self._places(center, sensor)
        self.lens, self.defocus = lens, self._focus(depth, lens)
        spans = [(float(along[0]), float(along[-1])) for along in (self.y, self.x)]
        spans.append((float(self.defocus.min()), float(self.defocus.max())))

        # Channels with equal spectra share a bank: the windows are by far the largest part of the work.
        @cache
        def made(
            spectrum: tuple[tuple[float, float], ...] | None,
        ) -> tuple[FieldBank, tuple[WindowBlur | MixedBlur, ...]]:
            # PSFs a thousand times as exact as the blur, within what double precision holds.
            phase, accuracy = None if lens is None else lens.phase, min(1e-6, max(1e-10, 1e-3 * tol))
            light = self._points(field_map, phase, spectrum, self.pixel, accuracy, settings.threads)
            bank = build_field_bank(light, spans, self.shape, settings, tol)
            return bank, self._made(bank)

        self.banks: tuple[FieldBank, ...] = tuple(made(spectrum)[0] for spectrum in self.spectra)
        self._parts = tuple(made(spectrum)[1] for spectrum in self.spectra)

    @property
    def error(self) -> float:
        """Largest sum of absolute differences found between interpolated windows and exact ones."""
        return max(bank.error + parts[0].error for bank, parts in zip(self.banks, self._parts, strict=True))

    @property
    def lost(self) -> float:
        """Largest fraction found of the light beyond the windows."""
        return max(bank.lost for bank in self.banks)

    def crop(
        self, shape: int | tuple[int, int], *, center: tuple[float, float], depth: ArrayLike | None = None
    ) -> FieldBlur:
        """Return the blur of another part of the field, or of another depth, with the windows that are known.

        For data sets: the windows of the whole image are computed once, and each crop takes a few milliseconds.

        Parameters
        ----------
        shape : int or (int, int)
            Height and width, pixels; the windows are as large as those of this blur.
        center : (float, float)
            Row and column of the optical axis, in pixels from the centre of the first one of the crop.
        depth : array_like, shape (height, width), optional
            Required if this blur has a depth: metres, within the range of its own.

        Returns
        -------
        FieldBlur
            It shares the `banks` of this one.

        Raises
        ------
        TypeError, ValueError
            If an argument is out of range, or the crop goes beyond the image or the depth of this blur; or if this
            was made with ``sensor=``, whose pixels are not those of PSFs.

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
            raise ValueError("crop needs a blur whose image has its true size, without sensor=")
        made = copy.copy(self)
        made.shape = validation.image_shape(shape)
        made.y, made.x = made._places(validation.position("center", center), None)
        lens = self.lens
        if (depth is None) != (lens is None):
            wanted = "must not have a depth" if lens is None else "needs a depth"
            raise ValueError(f"crop {wanted}, as the blur that it is part of")
        made.defocus = made._focus(depth, lens)
        for name, found, axis in zip(
            ("rows", "columns", "defocus"), (made.y, made.x, made.defocus), self.banks[0].axes, strict=True
        ):
            first, last = axis.first, axis.last
            # A thousandth of a pixel beyond the nodes is rounding: splines are constant beyond their ends.
            slack = 1e-6 * (last - first) + (1e-3 * self.pixel if name != "defocus" else 1e-9)
            if not (first - slack <= found.min() and found.max() <= last + slack):
                unit = "rad" if name == "defocus" else self.field_map.unit
                raise ValueError(
                    f"crop must be within the blur that it is part of: its {name} span {found.min():.6g} to "
                    f"{found.max():.6g} {unit}, and those {first:.6g} to {last:.6g}"
                )
        # Channels with one spectrum share a bank.
        parts = {id(bank): made._made(bank) for bank in {id(bank): bank for bank in self.banks}.values()}
        made._parts = tuple(parts[id(bank)] for bank in self.banks)
        return made

    @property
    def _points(self) -> type[PointLight]:
        """Class that computes the PSFs of points."""
        return PointLight

    def window(self, row: int, column: int, channel: int = 0) -> Array:
        """Return the PSF (side, side) of the point at `row`, `column` in a `channel`; ValueError if there is none."""
        height, width = self.shape
        row = validation.integer("row", row, least=0, most=height - 1)
        column = validation.integer("column", column, least=0, most=width - 1)
        bank = self.banks[validation.integer("channel", channel, least=0, most=self.channels - 1)]
        return bank.window(float(self.y[row]), float(self.x[column]), float(self.defocus[row, column]))

    def forward(self, image: Values) -> Values:
        """Return the image that the lens makes of an `image`: see :meth:`lommel.imaging.LinearBlur.forward`."""
        return self.by_channel(
            image, lambda channel, plane: reduce(np.add, (part.forward(plane) for part in self._parts[channel]))
        )

    def adjoint(self, image: Values) -> Values:
        """Return the transpose of :meth:`forward` of an `image`: see :meth:`lommel.imaging.LinearBlur.adjoint`."""
        return self.by_channel(
            image, lambda channel, plane: reduce(np.add, (part.adjoint(plane) for part in self._parts[channel]))
        )

    def _places(self, center: tuple[float, float] | None, sensor: tuple[float, float] | None) -> tuple[Array, Array]:
        """Return the positions of rows (y) and columns (x) in the field."""
        unit = self.field_map.unit
        axis = [0.5 * (side - 1) for side in self.shape] if center is None else validation.position("center", center)
        pitch = [self.pixel] * 2
        if sensor is not None:
            pitch = [length / side for length, side in zip(sides(sensor, unit), self.shape, strict=True)]
        y, x = (
            np.asarray(step * (np.arange(n) - at), dtype=np.float64)
            for step, n, at in zip(pitch, self.shape, axis, strict=True)
        )
        try:
            self._reached(x[[0, -1]], y[[0, -1], None])
        except ValueError as error:
            height, width = self.shape
            raise ValueError(
                f"{error}: the image spans {height} x {width} pixels with y from {y[0]:.4g} to {y[-1]:.4g} and "
                f"x from {x[0]:.4g} to {x[-1]:.4g} {unit}; take a smaller shape, another center= (row and column of "
                "the axis), or a map of more of the field"
            ) from None
        return y, x

    def _reached(self, x: Array, y: Array) -> None:
        """Raise ValueError for positions outside of the map."""
        self.field_map.pupil(x, y)

    def _focus(self, depth: ArrayLike | None, lens: Lens | None) -> Array:
        """Return the defocus of each point, 0 without a depth."""
        if (depth is None) != (lens is None):
            missing = "lens" if lens is None else "depth"
            raise ValueError(f"{missing} is missing: they go together, for the lens has the defocus of each distance")
        if lens is None or depth is None:
            # A view of one number: no depth means no defocus anywhere.
            return np.broadcast_to(0.0, self.shape)
        require_lens(lens, "field_map, shape, pixel, and depth= and lens=")
        distances = require_depth(depth)
        if distances.shape != self.shape:
            raise ValueError(f"depth must have the shape of the image, {self.shape}, got {distances.shape}")
        require_light(self.field_map.pupil_without_wavefront, lens)
        tell_of_depths(lens, self.pixel, distances)
        defocus = lens.defocus(distances)
        defocus.flags.writeable = False
        return defocus

    def _made(self, bank: FieldBank) -> tuple[WindowBlur | MixedBlur, ...]:
        """Return the operators of a channel: of its windows, and of the light beyond them."""
        made = partial(MixedBlur, border=self.border, threads=self.threads)
        focus, down, across = bank.axes[2], bank.axes[0].weights(self.y), bank.axes[1].weights(self.x)
        near: WindowBlur | MixedBlur | None = None
        # Small windows are mixed for each point directly; of larger ones transforms are faster.
        if bank.coefficients.shape[-1] <= LARGEST[min(2, focus.count)]:
            # ArithmeticError: parabolas in place of the splines would need too many tiles.
            with suppress(ArithmeticError):
                near = WindowBlur(
                    bank.coefficients, bank.axes, self.y, self.x, self.defocus,
                    border=self.border, threads=self.threads, allowed=self.tol - bank.error,
                )  # fmt: skip
        near = near or made(bank.coefficients, (down, across), focus, self.defocus)
        if bank.far is None:
            return (near,)
        # All light: each point sends what its own window does not hold through the common kernel.
        held = np.asarray(bank.coefficients, dtype=np.float64).sum(axis=(-2, -1))
        inside = [down @ plane @ across.T for plane in np.moveaxis(held, 2, 0)]
        beyond = 1.0 - sum(share * inside[node] for node, share in focus.shares(self.defocus))
        kernel, alike = bank.far.kernel.astype(self.dtype), (np.ones((len(self.y), 1)), np.ones((len(self.x), 1)))
        share = np.asarray(beyond, dtype=self.dtype)
        return near, made(kernel[None, None, None], alike, Nodes(0.0, 0.0, 1), self.defocus, share=share)


_KEPT = 2**29  # bytes of spectra that are kept, 512 MiB
_LONGEST = 512  # longest transform, unless windows are longer
_OVERHEAD = 20_000  # of a block, in samples of a transform


class Block(NamedTuple):
    """A block of points that spread light, and the nodes whose windows they mix."""

    rows: slice
    columns: slice
    down: slice
    across: slice


class MixedBlur:
    """Blur by windows mixed of nodes, with the borders of an image, and its transpose.

    ``out[q] = sum_kl sum_p D[p_y, k] A[p_x, l] sum_i c_i[p] x[p] W[k, l, i, q - p]``. A block of points takes one
    transform for each node that it mixes, and one back: the transforms are linear. Those along rows are made before
    the weights down the image are applied, which they do not depend on.
    """

    error = 0.0  # to the windows of the splines

    def __init__(
        self,
        windows: Values,
        weights: tuple[Array, Array],
        focus: Nodes,
        defocus: Array,
        *,
        border: str,
        threads: int,
        share: Values | float = 1.0,
    ) -> None:
        self.windows, self.focus, self.defocus, self.threads, self.share = windows, focus, defocus, threads, share
        self.beyond = windows.shape[-1] - 1  # rows and columns by which a block spreads light beyond itself
        margin = 0 if border == "zero" else self.beyond // 2
        self.before = margin + self.beyond // 2  # index of the image's first pixel in the padded result
        self.rows, self.columns = (copies(len(part), margin, border) for part in weights)
        self.down, self.across = weights[0][self.rows], weights[1][self.columns]
        self.down, self.across = (part.astype(windows.dtype) for part in (self.down, self.across))
        self.sides = _sides(self.down.shape, self.across.shape, self.beyond + 1)
        self._parts = (
            _parts(self.down, self.sides[0] - self.beyond),
            _parts(self.across, self.sides[1] - self.beyond),
        )
        self._spectra: Values | None = None

    def forward(self, plane: Values) -> Values:
        """Return the blurred image of a plane of light."""
        light = (self.share * plane)[self.rows[:, None], self.columns]
        # Blocks overlap by the size of a window: their results are added (overlap-add).
        room = np.zeros([side + self.beyond for side in light.shape], dtype=light.dtype)

        def made(block: Block) -> Values:
            points = light[block.rows, block.columns]
            mixed = reduce(np.add, (self._mixed(block, share * points, node) for node, share in self._shares(block)))
            return self._back(mixed, [side + self.beyond for side in points.shape])

        for block, part in self._each(made):
            room[self._reached(block)] += part
        return room[self.before :, self.before :][: plane.shape[0], : plane.shape[1]]

    def adjoint(self, plane: Values) -> Values:
        """Return the transpose of :meth:`forward` applied to an image."""
        # Transposed: each block reads what its light would reach (overlap-save).
        room = np.pad(plane, self.before)
        taken = np.empty((len(self.rows), len(self.columns)), dtype=plane.dtype)

        def made(block: Block) -> Values:
            spectrum = self._transformed(room[self._reached(block)])
            return reduce(np.add, (share * self._taken(block, spectrum, node) for node, share in self._shares(block)))

        for block, part in self._each(made):
            taken[block.rows, block.columns] = part
        return self.share * without_copies(taken, self.rows, self.columns, (plane.shape[0], plane.shape[1]))

    def _each(self, made: Callable[[Block], Values]) -> Iterator[tuple[Block, Values]]:
        """Yield blocks and their results, a row of blocks at a time."""
        for rows, down in self._parts[0]:
            blocks = [Block(rows, columns, down, across) for columns, across in self._parts[1]]
            yield from zip(blocks, side_by_side(made, blocks, self.threads), strict=True)

    def _reached(self, block: Block) -> tuple[slice, slice]:
        """Return the rows and columns reached by the light of a block."""
        rows, columns = (slice(part.start, part.stop + self.beyond) for part in (block.rows, block.columns))
        return rows, columns

    def _shares(self, block: Block) -> list[tuple[int, Values]]:
        """Return nodes over defocus, and their weights for the points of a block."""
        places = self.defocus[self.rows[block.rows][:, None], self.columns[block.columns]]
        return [(node, share.astype(self.windows.dtype)) for node, share in self.focus.shares(places)]

    def _mixed(self, block: Block, points: Values, node: int) -> Values:
        """Return the transform of the light that points spread by the windows at one node over defocus."""
        from scipy.fft import fft, rfft

        down, across = self.down[block.rows, block.down], self.across[block.columns, block.across]
        # Rows are transformed once for each node across; weights down the image multiply the result.
        lines = rfft(across.T[:, None, :] * points, n=self.sides[1], axis=-1)
        planes = down.T[:, None, :, None] * lines
        spectra = fft(planes, n=self.sides[0], axis=-2, overwrite_x=True)
        # Sum over nodes before the inverse transform, which is linear: one transform back for all of them.
        spectra *= self._of(block, node)
        return np.asarray(spectra.sum(axis=(0, 1)))

    def _back(self, spectrum: Values, shape: Sequence[int]) -> Values:
        from scipy.fft import ifft, irfft

        lines = ifft(spectrum, axis=0, overwrite_x=True)[: shape[0]]
        return np.asarray(irfft(lines, n=self.sides[1], axis=1)[:, : shape[1]])

    def _taken(self, block: Block, spectrum: Values, node: int) -> Values:
        """Return the transpose of :meth:`_mixed` and :meth:`_back`."""
        from scipy.fft import ifft, irfft

        down, across = self.down[block.rows, block.down], self.across[block.columns, block.across]
        spectra = np.conj(self._of(block, node))
        spectra *= spectrum
        planes = ifft(spectra, axis=-2, overwrite_x=True)[..., : len(down), :]
        planes = planes * down.T[:, None, :, None]
        lines = irfft(planes.sum(axis=0), n=self.sides[1], axis=-1)[..., : len(across)]
        return np.asarray((lines * across.T[:, None, :]).sum(axis=0))

    def _of(self, block: Block, node: int) -> Values:
        """Return the transforms of the windows that a block mixes."""
        if self._spectra is None:
            count, size = math.prod(self.windows.shape[:3]), self.sides[0] * (self.sides[1] // 2 + 1)
            if count * size * 2 * self.windows.itemsize > _KEPT:
                return self._transformed(self.windows[block.down, block.across, node])
            self._spectra = self._transformed(self.windows)
        return self._spectra[block.down, block.across, node]

    def _transformed(self, images: Values) -> Values:
        """Return the transforms of small images, padded to the sides of a block."""
        from scipy.fft import fft, rfft

        lines = rfft(images, n=self.sides[1], axis=-1)
        return np.asarray(fft(lines, n=self.sides[0], axis=-2, overwrite_x=True))


def _sides(down: tuple[int, ...], across: tuple[int, ...], window: int) -> tuple[int, int]:
    """Return the sides of transforms, rows and columns, that minimise the work."""
    rows, columns = (_candidates(points, window) for points, _ in (down, across))
    best = (math.inf, (0, 0))
    for fy, by, ny in ((f, b, math.ceil(down[0] / b)) for f, b in rows):
        for fx, bx, nx in ((f, b, math.ceil(across[0] / b)) for f, b in columns):
            # Blocks shorter than the image mix fewer nodes, at least the four of a cubic spline.
            each = 2.0 + math.prod(
                min(count, 4.0 + block * (count - 1) / points)
                for block, (points, count) in ((by, down), (bx, across))
            )
            best = min(best, (ny * nx * (fy * fx * each * math.log2(fy * fx) + _OVERHEAD * 10.0), (fy, fx)))
    return best[1]


def _candidates(points: int, window: int) -> list[tuple[int, int]]:
    """Return fast lengths of transforms, and the number of points that each leaves to a block."""
    from scipy.fft import next_fast_len

    most = next_fast_len(min(points + window - 1, max(_LONGEST, 4 * window)), real=True)
    sides, side = [], window
    while side <= most:
        side = next_fast_len(side, real=True)
        sides.append((side, side - window + 1))
        side += 1
    return [pair for pair in sides if pair[1] >= min(points, 8)] or sides[-1:]


def _parts(weights: Values, length: int) -> list[tuple[slice, slice]]:
    """Return parts of the points, and the nodes with weights there."""
    parts = []
    count = math.ceil(len(weights) / length)
    edges = [round(k * len(weights) / count) for k in range(count + 1)]
    for first, last in pairwise(edges):
        used = np.flatnonzero(weights[first:last].any(axis=0))
        parts.append((slice(first, last), slice(int(used[0]), int(used[-1]) + 1)))
    return parts


_BEYOND = 2.5  # sides of the table of far light, over those of the windows
_ELSEWHERE = 1.2  # factor on errors at the places that were checked, for all others


@dataclass(frozen=True)
class FarLight:
    """Light that points spread beyond their windows: one kernel for all, times a share."""

    kernel: Array  # mean over the field, of sum 1; 0 within the window
    half: int  # pixels from the middle of the windows to their edges
    error: float  # largest sum of absolute differences to the light of points, with a reserve for points not checked
    lost: float  # largest share of light beyond the kernel, which is placed within it


def far_light(light: PointLight, spans: Sequence[Span], tol: float, largest: int, farthest: int) -> FarLight:
    """Return the smallest windows beyond which all points spread light alike to `tol`, and that light."""
    places = overview(spans)
    half = 8
    while True:
        half = min(half, largest)
        reach = int(np.ceil(_BEYOND * half))
        windows = light.windows(places, reach)
        if _off(windows, half) <= tol:
            break
        if half == largest:
            raise ValueError(
                f"light farther than {largest} pixels from its point is not alike to {tol:.2g} all over the field; "
                f"allow larger windows than largest={largest}, ask for a larger tol, or for less light (energy=)"
            )
        half *= 2
    # The error grows as windows shrink: bisection for the smallest.
    half = 1 + bisect_left(range(1, half), True, key=lambda smaller: _off(windows, smaller) <= tol)
    error, tails = _off(windows, half), windows.copy()
    tails[:, reach - half : reach + half + 1, reach - half : reach + half + 1] = 0.0
    beyond = 1.0 - windows.sum(axis=(1, 2))
    # Diffraction at edges falls as r^-3, so that the light beyond a square falls as 1 over its side.
    enough = int(np.ceil(4.0 * float(beyond.max()) / tol * (reach + 0.5)))
    side = max(reach, min(farthest, enough))
    kernel = np.pad(tails.sum(axis=0), side - reach)
    if side > reach:
        away = np.arange(-side, side + 1.0)
        ring = np.hypot(away[:, None], away)
        ring[side - reach : side + reach + 1, side - reach : side + reach + 1] = np.inf
        ring = ring**-3.0
        kernel += ring * (float(beyond.sum()) * (1.0 - (reach + 0.5) / (side + 0.5)) / ring.sum())
    # The same law for what even the kernel leaves out.
    lost = float(beyond.max()) * (reach + 0.5) / (side + 0.5)
    return FarLight(kernel / kernel.sum(), half, error, lost)


def _off(windows: Array, half: int) -> float:
    """Return the largest sum of absolute differences between tails and their scaled mean, with a reserve."""
    reach = windows.shape[-1] // 2
    inner = slice(reach - half, reach + half + 1)
    outside = np.ones(windows.shape[1:], dtype=np.bool_)
    outside[inner, inner] = False
    tails: Values = windows[:, outside]
    bright = tails.sum(axis=1)
    mean = tails.sum(axis=0) / bright.sum()
    return _ELSEWHERE * float(np.abs(tails - bright[:, None] * mean).sum(axis=1).max())


_MAX_VALUES = 2**27  # of a bank, 1 GiB in double precision
_CHECKED = 1500  # most places half-way between nodes that are checked
_FINE = 3e-4  # tolerance below which splines of degree 5 are faster than cubic ones
_SHARES = (0.9, 1.2, 1.4)  # of the tolerance, for 1, 2, 3 axes together: their errors peak at different places
_PARABOLAS = 0.03  # of the tolerance, for parabolas in place of splines
_FAR = 0.4  # of the tolerance, for the light beyond the windows, if it counts


@dataclass(frozen=True)
class FieldBank:
    """PSF windows of one channel over field position and defocus.

    Attributes
    ----------
    axes : tuple of three Nodes
        Nodes along y and x in the field, and along defocus (radians at the wavelength of the map).
    coefficients : ndarray, shape (y, x, defocus, side, side)
        Spline coefficients along these axes. Every interpolated window has the sum 1, less the light of `far`.
    far : FarLight or None
        Light beyond the windows, for ``energy=1``.
    lost : float
        Largest fraction found of the light beyond the windows, which is spread over these instead.
    error : float
        Largest sum of absolute differences between interpolated and exact windows, checked half-way between nodes.
    """

    axes: tuple[Nodes, ...]
    coefficients: Values
    far: FarLight | None
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
        made = next(_mixed(self.axes, self.coefficients, np.array([[y, x, defocus]])))
        if self.far is None:
            return made
        middle = len(self.far.kernel) // 2 - self.half
        whole = np.asarray((1.0 - made.sum()) * self.far.kernel)
        whole[middle : middle + len(made), middle : middle + len(made)] += made
        return whole


def build_field_bank(
    light: PointLight,
    spans: Sequence[Span],
    shape: tuple[int, int],
    settings: Settings,
    tol: float,
) -> FieldBank:
    """Return the bank of one channel for images of this shape; ValueError if windows or bank would be too large."""
    energy, largest = settings.energy, settings.largest or max(1, min(shape) // 2)
    half, core = light.enough(spans, CORE if energy == 1.0 else energy, largest)
    far = far_light(light, spans, _FAR * tol, largest, max(shape)) if energy == 1.0 else None
    beyond = 0.0
    if far is not None:
        half, beyond = far.half, far.error
    room = (1.0 - _PARABOLAS) * tol - beyond
    axes = _axes(light, spans, min(core, half), room)
    before = 0.0 if all(nodes.count == 1 for nodes in axes) else math.inf
    while True:
        side = 2 * half + 1
        _require_few(axes, side, tol)
        windows = light.windows(lattice([nodes.places for nodes in axes]), half)
        held = windows.sum(axis=(1, 2))
        if far is None and held.min() < energy:  # between the places of the first estimate
            if half == largest:
                raise light.too_large(lattice([nodes.places for nodes in axes]), energy, largest, held)
            half = min(largest, math.ceil(1.05 * half) + 1)
            continue
        if far is None:
            windows /= held[:, None, None]
        coefficients: Values = windows.reshape(*(nodes.count for nodes in axes), side, side)
        for axis, nodes in enumerate(axes):
            coefficients = nodes.coefficients(coefficients, axis)
        error, least = _error_between(light, axes, coefficients, whole=far is None)
        if error <= room:
            lost = 1.0 - min(float(held.min()), least) if far is None else far.lost
            return FieldBank(axes, coefficients.astype(settings.dtype), far, lost, error + beyond)
        degree = axes[0].degree
        # The error of a spline of degree d falls as the (d + 1)th power of the spacing; aim a tenth below.
        times = max(1.02, (error / (0.9 * room)) ** (1.0 / (degree + 1)))
        # If closer nodes do not help, axes with a single node may need more.
        single, before = error > 0.9 * before, error
        axes = _finer(axes, times, single=single)


def _finer(axes: Sequence[Nodes], times: float, *, single: bool) -> tuple[Nodes, ...]:
    """Return axes with `times` as many nodes, those with a `single` node included or not."""
    return tuple(
        nodes.finer(times) if nodes.first < nodes.last and (single or nodes.count > 1) else nodes for nodes in axes
    )


def _require_few(axes: Sequence[Nodes], side: int, tol: float) -> None:
    """Raise ValueError if a bank would be too large."""
    if math.prod(nodes.count for nodes in axes) * side * side > _MAX_VALUES:
        counts = " x ".join(str(nodes.count) for nodes in axes)
        raise ValueError(
            f"a bank of {counts} windows (down, across, over defocus) of {side} x {side} pixels exceeds the "
            f"limit of {_MAX_VALUES} values; ask for a larger tol than {tol:g}, for less light (energy=), or for "
            "parts of the image, by center="
        )


def _error_between(
    light: PointLight, axes: Sequence[Nodes], coefficients: Values, *, whole: bool
) -> tuple[float, float]:
    """Return the largest error of windows half-way between nodes, and the least light that exact ones hold there.

    Windows are divided by their light if they stand for the `whole` of it.
    """
    places = lattice([nodes.between if nodes.count > 1 else np.unique([nodes.first, nodes.last]) for nodes in axes])
    # A fixed seed: the same blur twice has the same error.
    if len(places) > _CHECKED:
        places = places[np.random.default_rng(0).choice(len(places), _CHECKED, replace=False)]
    exact = light.windows(places, coefficients.shape[-1] // 2)
    held = exact.sum(axis=(1, 2))
    if whole:
        exact /= held[:, None, None]
    error = UNEVEN * max(  # excess light of a window is missing in the far light: it counts twice
        off(made, one) + abs(float((made - one).sum()))
        for made, one in zip(_mixed(axes, coefficients, places), exact, strict=True)
    )
    return error, float(held.min())


def _axes(light: PointLight, spans: Sequence[Span], half: int, tol: float) -> tuple[Nodes, ...]:
    """Return nodes that are dense enough along lines through the spans."""
    # Degree 5: fewer nodes, of which more count at each place, which pays where there are many.
    degree = 5 if tol < _FINE or spans[2][0] < spans[2][1] else 3
    many = max(1, sum(first != last for first, last in spans))
    share = _SHARES[many - 1] * tol / many
    found = []
    for axis, span in enumerate(spans):
        others = [np.unique(np.linspace(*other, 3)) for other in spans]

        def sample(along: Array, axis: int = axis, others: list[Array] = others) -> Array:
            ticks = [along if k == axis else other for k, other in enumerate(others)]
            windows = light.windows(lattice(ticks), half)
            windows /= windows.sum(axis=(1, 2), keepdims=True)
            shaped = windows.reshape(*(len(tick) for tick in ticks), *windows.shape[1:])
            return np.moveaxis(shaped, axis, 2).reshape(-1, len(along), *windows.shape[1:])

        nodes = enough(sample, *span, share, degree)
        if nodes is None:
            what = ("down the image", "across the image", "over the depth")[axis]
            raise ValueError(
                f"the PSF changes so much {what} that more than {MOST} windows are not enough; ask for a larger tol "
                f"than {tol:g}, or for parts of the image, by center="
            )
        found.append(nodes)
    return tuple(found)


def _mixed(axes: Sequence[Nodes], coefficients: Values, places: Array) -> Iterator[Array]:
    """Yield the windows of splines at places, shape (n, 3)."""
    weights = [nodes.weights(along) for nodes, along in zip(axes, places.T, strict=True)]
    for parts in zip(*weights, strict=True):
        used = [np.flatnonzero(share) for share in parts]
        found: Values = coefficients[np.ix_(*used)]
        for share, these in zip(parts, used, strict=True):
            found = np.tensordot(share[these], found, axes=(0, 0))
        yield found.astype(np.float64, copy=False)


CORE = 0.9  # share of the light whose changes determine the density of nodes

_AT_ONCE = 2**24  # values computed at a time

Span = tuple[float, float]


@dataclass(frozen=True)
class PointLight:
    """The pixel-integrated PSF of a point anywhere in the field of a lens, at any defocus."""

    field_map: FieldMap
    phase: Callable[[Array], Wavefront] | None
    spectrum: Sequence[tuple[float, float]] | None
    pixel: float  # in the unit of the map
    tol: float  # of each PSF, over its peak
    threads: int | None

    def pupil(self, y: Array, x: Array, defocus: Array) -> Pupil:
        """Return the stack of pupils at places in the field and values of the defocus, arrays of one shape."""
        pupil = self.field_map.pupil(x, y)
        return pupil if self.phase is None else pupil.carrying(pupil.wavefront + self.phase(defocus), None)

    def windows(self, places: Array, half: int) -> Array:
        """Return the share of light in each pixel of windows (n, side, side), for points at y, x and C_d (n, 3)."""
        side = 2 * half + 1
        out = np.zeros((len(places), side, side))
        step = max(1, _AT_ONCE // side**2)
        for first in range(0, len(places), step):
            part = slice(first, first + step)
            pupil = self.pupil(*places[part].T)
            for wavelength, weight in self.spectrum or ((None, 1.0),):
                light = pupil if wavelength is None else pupil.in_light(wavelength)
                given: dict[str, Any] = {"integrate": True, "dtype": np.float64, "threads": self.threads}
                out[part] += weight * psf(light, side, self.pixel, tol=self.tol, **given).values
        return out

    def enough(self, spans: Sequence[Span], energy: float, largest: int) -> tuple[int, int]:
        """Return the half widths of windows that hold `energy` of the light, and its core, all over the spans."""
        places = overview(spans)
        half = math.ceil(float(self.pupil(*places.T).geometric_radius().max()) / self.pixel) + 1
        while True:
            half = min(half, largest)
            windows = self.windows(places, half)
            held = windows.sum(axis=(1, 2))
            if held.min() >= energy:
                return _smallest(windows, energy), _smallest(windows, min(energy, CORE))
            if half == largest:
                raise self.too_large(places, energy, largest, held)
            # Thirty per cent larger each time: a few windows more are cheaper than one far too large.
            half = math.ceil(1.3 * half) + 1

    def too_large(self, places: Array, energy: float, largest: int, held: Array) -> ValueError:
        """Return the error of windows at places that would be too large, which hold a share of the light each."""
        spectrum = self.spectrum or ((None, 1.0),)
        return too_large(largest, energy, self.pupil(*places.T), spectrum, self.pixel, float(held.min()))


def lattice(ticks: Sequence[Array]) -> Array:
    """Return all places of a lattice, shape (n, 3), the last coordinate fastest."""
    return np.stack([part.ravel() for part in np.meshgrid(*ticks, indexing="ij")], axis=1)


def overview(spans: Sequence[Span]) -> Array:
    """Return places all over the spans, shape (n, 3)."""
    return lattice([np.unique(np.linspace(*span, 5 if axis < 2 else 3)) for axis, span in enumerate(spans)])


def _smallest(windows: Array, energy: float) -> int:
    """Return half of the smallest windows, of the same middles, that hold `energy`."""
    half = int(windows.shape[-1]) // 2
    while half > 0:
        inner = windows[:, 1:-1, 1:-1]
        if inner.sum(axis=(1, 2)).min() < energy:
            break
        windows, half = inner, half - 1
    return half


MOST = 513  # most nodes along one axis

UNEVEN = 1.2  # largest error of a spline over that half-way between nodes, which occurs near the ends

# Distances near the ends over those elsewhere, by degree: splines would err five times as much there otherwise.
_ENDS = {3: (0.5, 0.8), 5: (0.35, 0.6, 0.8)}


@dataclass(frozen=True)
class Nodes:
    """Nodes along an axis, denser at its ends, and not-a-knot splines through values at them."""

    first: float
    last: float
    count: int
    degree: int = 3

    @property
    def places(self) -> Array:
        """Positions of the nodes, shape (count,)."""
        return np.asarray(self.first + (self.last - self.first) * self._along)

    @property
    def between(self) -> Array:
        """Positions half-way between nodes, shape (count - 1,)."""
        return np.asarray(0.5 * (self.places[1:] + self.places[:-1]))

    @cached_property
    def _along(self) -> Array:
        """Positions of the nodes on [0, 1]."""
        cells, closer = np.ones(max(0, self.count - 1)), _ENDS[self.degree]
        if len(cells) > 2 * len(closer):
            cells[: len(closer)] = closer
            cells[-len(closer) :] = closer[::-1]
        ends = np.concatenate([[0.0], np.cumsum(cells)])
        return np.asarray(ends / max(1.0, ends[-1]))

    @cached_property
    def _spline(self) -> BSpline:
        """Cardinal splines: 1 at one node and 0 at all others."""
        from scipy.interpolate import make_interp_spline

        return make_interp_spline(self._along, np.eye(self.count), k=min(self.degree, self.count - 1))

    @property
    def knots(self) -> tuple[Array, int]:
        """Knots from 0 to 1 of the splines, and their degree."""
        return self._spline.t, self._spline.k

    def coefficients(self, values: Values, axis: int) -> Values:
        """Return the coefficients of splines from values at the nodes, which lie along `axis`."""
        if self.count == 1:
            return values
        return np.moveaxis(np.tensordot(self._spline.c, values, axes=(1, axis)), 0, axis)

    def weights(self, places: Array) -> Array:
        """Return the weight of each coefficient at places (n,), shape (n, count), constant beyond the ends."""
        return np.ones((len(places), 1)) if self.count == 1 else np.asarray(self._matrix(places).toarray())

    def shares(self, places: Array) -> list[tuple[int, Array]]:
        """Return the nodes with weights that are not 0, and these, in the shape of places; 1 for a single node."""
        if self.count == 1:
            return [(0, np.ones(()))]
        # By columns of the sparse matrix: few nodes have weight at any place.
        matrix, found = self._matrix(places.ravel()).tocsc(), []
        for node in range(self.count):
            part = slice(matrix.indptr[node], matrix.indptr[node + 1])
            if part.stop > part.start:
                column = np.zeros(places.size)
                column[matrix.indices[part]] = matrix.data[part]
                found.append((node, column.reshape(places.shape)))
        return found

    def _matrix(self, places: Array) -> csr_array:
        from scipy.interpolate import BSpline

        along = np.clip((places - self.first) / (self.last - self.first), 0.0, 1.0)
        return BSpline.design_matrix(along, self._spline.t, self._spline.k)

    def finer(self, times: float) -> Nodes:
        """Return nodes `times` as dense, and at least one more."""
        cells = max(1, self.count - 1)
        return replace(self, count=max(self.count, math.ceil(cells * times)) + 1)


def off(one: Values, other: Values) -> float:
    """Return the largest sum of absolute differences of windows."""
    return float(np.abs(one - other).sum(axis=(-2, -1)).max(initial=0.0))


def enough(sample: Callable[[Array], Array], first: float, last: float, tol: float, degree: int = 3) -> Nodes | None:
    """Return nodes whose splines err by at most `tol` on ``sample(places)``, None if that takes too many."""
    if first == last:
        return Nodes(first, first, 1, degree)
    nodes = Nodes(first, last, 3, degree)
    known = sample(nodes.places)
    if off(known, known[:, :1]) <= tol:
        return replace(nodes, count=1)

    def over(nodes: Nodes) -> float:
        """Return the factor by which the spacing of nodes exceeds the sufficient one."""
        made = interpolated(nodes, sample(nodes.places), nodes.between)
        # The error falls by 2^(degree + 1) where nodes are twice as close.
        return float((UNEVEN * off(made, sample(nodes.between)) / tol) ** (1.0 / (degree + 1)))

    while (ratio := over(nodes)) > 1.0:
        nodes = replace(nodes, count=2 * nodes.count - 1)
        if nodes.count > MOST:
            return None
    # Doubling overshoots: nodes are thinned out to what suffices.
    fewer = replace(nodes, count=math.ceil((nodes.count - 1) * max(0.5, ratio)) + 1)
    while fewer.count < nodes.count and (ratio := over(fewer)) > 1.0:
        fewer = replace(fewer, count=max(fewer.count + 1, math.ceil((fewer.count - 1) * ratio) + 1))
    return fewer if fewer.count < nodes.count else nodes


def interpolated(nodes: Nodes, values: Values, places: Array) -> Array:
    """Return splines through values along the second axis, evaluated at places."""
    made = np.tensordot(nodes.weights(places), nodes.coefficients(values, 1), axes=(1, 1))
    return np.moveaxis(made, 0, 1)
