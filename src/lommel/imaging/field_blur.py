"""Blur that varies over the field of view and with depth, as a linear operator."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from functools import cache, partial, reduce
from itertools import pairwise
from typing import Any, NamedTuple, Unpack, cast

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.base.options import shares
from lommel.base.threads import side_by_side
from lommel.field.maps import FieldMap, require_light
from lommel.field.psf_grid import sides
from lommel.imaging.blur import require_depth, require_lens
from lommel.imaging.field_bank import FieldBank, Nodes, PointLight, build_field_bank
from lommel.imaging.linear import LinearBlur, gathered
from lommel.imaging.settings import FieldKeywords, Settings, Spectrum, spectra
from lommel.optics.lens import Lens


@shares(FieldKeywords, Settings)
class FieldBlur(LinearBlur):
    """Blur that varies over the field, and with depth, a linear operator: ``out[q] = sum_p image[p] K_p(q - p)``.

    K_p is the pixel-integrated PSF of the source point p, at its place in the field, and at its distance where a
    depth is given. It is truncated to a window that holds `energy` of its light, of one size for all points, and
    divided by the light in the window. Between nodes over the field (and over defocus) it is interpolated by splines;
    the nodes are chosen so that K_p errs by less than `tol`. With ``energy=1`` it is not truncated: the light beyond
    the windows, which then are as large as needed, is a kernel that all points share, scaled for each.

    Parameters
    ----------
    field_map : FieldMap
        Its wavefronts over the field.
    shape : int or (int, int)
        Height and width of the image, pixels.
    pixel : float
        Pixel pitch, in the unit of the map (metres if it has a wavelength).
    depth : array_like, shape (height, width), optional
        Distance of each point from the lens, metres, positive; may be infinite. The defocus that `lens` has for it is
        added to the wavefront of the map.
    lens : Lens
        With `depth`, and only with it. Of the wavelength, f-number and aperture of the map, and without aberrations
        of its own.
    center : (float, float), optional
        Row and column of the optical axis, in pixels, 0 being the middle of the first; by default the middle of the
        image. It may lie outside of the image, which then is a crop.
    sensor : (float, float), optional
        Height and width of the part of the field that the image shows, in the unit of the map; by default
        ``shape * pixel``. With a larger one PSFs are drawn too large for their places, as for pictures of what a lens
        does over all of its field.
    channels : sequence, default (wavelength of the map,)
        For each channel a wavelength (metres), or its spectrum, pairs of wavelength and weight.
    tol : float, default 1e-3
        Bound on the sum of absolute differences between K_p and the exact window, which each have the sum 1; 1e-6
        to 1e-1. Checked half-way between nodes.
    {options}

    Attributes
    ----------
    banks : tuple of FieldBank
        One a channel.
    error : float
        Largest sum of absolute differences found between interpolated windows and exact ones, of any channel.
    lost : float
        Largest share of light beyond the windows that was found. Against the whole PSF a window differs by no more
        than ``error + 2 * lost``, by the sum of absolute differences.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range; if the image goes beyond the map; if the blur exceeds `largest`, or takes more
        than 2^27 values.

    Notes
    -----
    A source spreads its light by its own PSF (scatter), which is what lenses do; that each pixel of the image be a
    mean of others by its own PSF (gather) is the transpose. The light of each source is kept, wherever it is: where a
    lens is darker towards the corners, multiply the image by its relative illumination first.

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
        light = field_map.pupil_without_wavefront
        metric = light.wavelength is not None
        self.field_map, self._shape = field_map, validation.image_shape(shape)
        self.pixel = validation.pixel(pixel, metric=metric)
        validation.pixel_on(self.pixel, light.scale, metric=metric)
        validation.real("tol", tol, least=1e-6, below=0.1 + 1e-12)
        settings = Settings.of(FieldBlur, options, FieldKeywords)
        self.border, self.dtype = settings.border, cast("np.dtype[np.floating]", settings.dtype)
        self.threads = settings.threads or 0
        self.y, self.x = self._places(center, sensor)
        self.lens, self.defocus = lens, self._focus(depth, lens)
        spans = [(float(along[0]), float(along[-1])) for along in (self.y, self.x)]
        spans.append((float(self.defocus.min()), float(self.defocus.max())))
        if channels is not None and not metric:
            raise ValueError("channels need a map with a wavelength, to which theirs are related")
        colours = (None,) if channels is None else spectra("channels", channels)

        @cache
        def made(spectrum: tuple[tuple[float, float], ...] | None) -> tuple[FieldBank, tuple[MixedBlur, ...]]:
            phase, accuracy = None if lens is None else lens.phase, min(1e-6, max(1e-10, 1e-3 * tol))
            bank = build_field_bank(
                PointLight(field_map, phase, spectrum, self.pixel, accuracy, settings.threads),
                spans,
                tol=tol,
                energy=settings.energy,
                largest=settings.largest or max(1, min(self.shape) // 2),
                farthest=max(self.shape),
                dtype=self.dtype,
            )
            return bank, self._made(bank)

        self.banks: tuple[FieldBank, ...] = tuple(made(spectrum)[0] for spectrum in colours)
        self._parts = tuple(made(spectrum)[1] for spectrum in colours)

    @property
    def shape(self) -> tuple[int, int]:
        """Height and width of the images."""
        return self._shape

    @property
    def channels(self) -> int:
        """Number of channels; an image of a single one may lack their axis."""
        return len(self.banks)

    @property
    def error(self) -> float:
        """Largest sum of absolute differences found between interpolated windows and exact ones."""
        return max(bank.error for bank in self.banks)

    @property
    def lost(self) -> float:
        """Largest share of light beyond the windows that was found."""
        return max(bank.lost for bank in self.banks)

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
            image, lambda channel, plane: reduce(np.add, (part.spread(plane) for part in self._parts[channel]))
        )

    def adjoint(self, image: Values) -> Values:
        """Return the transpose of :meth:`forward` of an `image`: see :meth:`lommel.imaging.LinearBlur.adjoint`."""
        return self.by_channel(
            image, lambda channel, plane: reduce(np.add, (part.collect(plane) for part in self._parts[channel]))
        )

    def _places(self, center: tuple[float, float] | None, sensor: tuple[float, float] | None) -> tuple[Array, Array]:
        """Return y of the rows and x of the columns in the field."""
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
            self.field_map.pupil(x[[0, -1]], y[[0, -1], None])
        except ValueError as error:
            height, width = self.shape
            raise ValueError(
                f"{error}: the image spans {height} x {width} pixels with y from {y[0]:.4g} to {y[-1]:.4g} and "
                f"x from {x[0]:.4g} to {x[-1]:.4g} {unit}; take a smaller shape, another center= (row and column of "
                "the axis), or a map of more of the field"
            ) from None
        return y, x

    def _focus(self, depth: ArrayLike | None, lens: Lens | None) -> Array:
        """Return the defocus of each point, 0 without a depth."""
        if (depth is None) != (lens is None):
            missing = "lens" if lens is None else "depth"
            raise ValueError(f"{missing} is missing: they go together, for the lens has the defocus of each distance")
        if lens is None or depth is None:
            return np.broadcast_to(0.0, self.shape)
        require_lens(lens, "field_map, shape, pixel, and depth= and lens=")
        distances = require_depth(depth)
        if distances.shape != self.shape:
            raise ValueError(f"depth must have the shape of the image, {self.shape}, got {distances.shape}")
        require_light(self.field_map.pupil_without_wavefront, lens)
        defocus = lens.defocus(distances)
        defocus.flags.writeable = False
        return defocus

    def _made(self, bank: FieldBank) -> tuple[MixedBlur, ...]:
        """Return the operators of a channel: of its windows, and of the light beyond them."""
        made = partial(MixedBlur, border=self.border, threads=self.threads)
        focus, down, across = bank.axes[2], bank.axes[0].weights(self.y), bank.axes[1].weights(self.x)
        near = made(bank.coefficients, (down, across), focus, self.defocus)
        if bank.far is None:
            return (near,)
        held = np.asarray(bank.coefficients, dtype=np.float64).sum(axis=(-2, -1))
        inside = [down @ plane @ across.T for plane in np.moveaxis(held, 2, 0)]
        beyond = 1.0 - sum(share * inside[node] for node, share in focus.shares(self.defocus))
        kernel, alike = bank.far.kernel.astype(self.dtype), (np.ones((len(self.y), 1)), np.ones((len(self.x), 1)))
        share = np.asarray(beyond, dtype=self.dtype)
        return near, made(kernel[None, None, None], alike, Nodes(0.0, 0.0, 1), self.defocus, share=share)


_KEPT = 2**29  # bytes of spectra that are kept, 512 MiB
_LONGEST = 512  # side of a transform, where windows do not make it longer
_OVERHEAD = 20_000  # of a block, in samples of a transform


class Block(NamedTuple):
    """Some of the points that spread light, and the nodes whose windows they mix."""

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
        self.beyond = windows.shape[-1] - 1  # rows and columns that a block spreads beyond its own
        margin = 0 if border == "zero" else self.beyond // 2
        self.before = margin + self.beyond // 2  # the first pixel of the image, in what blocks make
        mode: Any = "symmetric" if border == "reflect" else "edge"
        # Which row or column each of those is a copy of that spread light, the ones beyond the edges too.
        self.rows, self.columns = (
            np.pad(np.arange(len(part), dtype=np.int64), margin, mode=mode) for part in weights
        )
        self.down, self.across = weights[0][self.rows], weights[1][self.columns]
        self.down, self.across = (part.astype(windows.dtype) for part in (self.down, self.across))
        self.sides = _sides(self.down.shape, self.across.shape, self.beyond + 1)
        self._parts = (
            _parts(self.down, self.sides[0] - self.beyond),
            _parts(self.across, self.sides[1] - self.beyond),
        )
        self._spectra: Values | None = None

    def spread(self, plane: Values) -> Values:
        """Return the blurred image of a plane of light."""
        light = (self.share * plane)[self.rows[:, None], self.columns]
        room = np.zeros([side + self.beyond for side in light.shape], dtype=light.dtype)

        def made(block: Block) -> Values:
            points = light[block.rows, block.columns]
            mixed = reduce(np.add, (self._mixed(block, share * points, node) for node, share in self._shares(block)))
            return self._back(mixed, [side + self.beyond for side in points.shape])

        for block, part in self._each(made):
            room[self._reached(block)] += part
        return room[self.before :, self.before :][: plane.shape[0], : plane.shape[1]]

    def collect(self, plane: Values) -> Values:
        """Return the transpose of :meth:`spread` applied to an image."""
        room = np.pad(plane, self.before)
        taken = np.empty((len(self.rows), len(self.columns)), dtype=plane.dtype)

        def made(block: Block) -> Values:
            spectrum = self._transformed(room[self._reached(block)])
            return reduce(np.add, (share * self._taken(block, spectrum, node) for node, share in self._shares(block)))

        for block, part in self._each(made):
            taken[block.rows, block.columns] = part
        # What points beyond the edges took goes to those that they are copies of.
        found = gathered(gathered(taken, self.rows, plane.shape[0]).T, self.columns, plane.shape[1]).T
        return self.share * found

    def _each(self, made: Callable[[Block], Values]) -> Iterator[tuple[Block, Values]]:
        """Yield blocks and their results, a row of blocks at a time."""
        for rows, down in self._parts[0]:
            blocks = [Block(rows, columns, down, across) for columns, across in self._parts[1]]
            yield from zip(blocks, side_by_side(made, blocks, self.threads), strict=True)

    def _reached(self, block: Block) -> tuple[slice, slice]:
        """Return the rows and columns that the light of a block reaches."""
        rows, columns = (slice(part.start, part.stop + self.beyond) for part in (block.rows, block.columns))
        return rows, columns

    def _shares(self, block: Block) -> list[tuple[int, Values]]:
        """Return nodes over defocus, and the weight of each for the points of a block."""
        places = self.defocus[self.rows[block.rows][:, None], self.columns[block.columns]]
        return [(node, share.astype(self.windows.dtype)) for node, share in self.focus.shares(places)]

    def _mixed(self, block: Block, points: Values, node: int) -> Values:
        """Return the transform of the light that points spread by the windows at one node over defocus."""
        from scipy.fft import fft, rfft

        down, across = self.down[block.rows, block.down], self.across[block.columns, block.across]
        lines = rfft(across.T[:, None, :] * points, n=self.sides[1], axis=-1)
        planes = down.T[:, None, :, None] * lines
        spectra = fft(planes, n=self.sides[0], axis=-2, overwrite_x=True)
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
        """Return the transforms of images, smaller than these, without those of rows beyond them."""
        from scipy.fft import fft, rfft

        lines = rfft(images, n=self.sides[1], axis=-1)
        return np.asarray(fft(lines, n=self.sides[0], axis=-2, overwrite_x=True))


def _sides(down: tuple[int, ...], across: tuple[int, ...], window: int) -> tuple[int, int]:
    """Return sides of the transforms, rows and columns, that make the work least."""
    rows, columns = (_candidates(points, window) for points, _ in (down, across))
    best = (math.inf, (0, 0))
    for fy, by, ny in ((f, b, math.ceil(down[0] / b)) for f, b in rows):
        for fx, bx, nx in ((f, b, math.ceil(across[0] / b)) for f, b in columns):
            each = 2.0 + math.prod(
                min(count, 4.0 + block * (count - 1) / points)
                for block, (points, count) in ((by, down), (bx, across))
            )
            best = min(best, (ny * nx * (fy * fx * each * math.log2(fy * fx) + _OVERHEAD * 10.0), (fy, fx)))
    return best[1]


def _candidates(points: int, window: int) -> list[tuple[int, int]]:
    """Return sides of transforms that are fast, and how many points each leaves to a block."""
    from scipy.fft import next_fast_len

    most = next_fast_len(min(points + window - 1, max(_LONGEST, 4 * window)), real=True)
    sides, side = [], window
    while side <= most:
        side = next_fast_len(side, real=True)
        sides.append((side, side - window + 1))
        side += 1
    return [pair for pair in sides if pair[1] >= min(points, 8)] or sides[-1:]


def _parts(weights: Values, length: int) -> list[tuple[slice, slice]]:
    """Return parts of the points, and of the nodes that have weight there."""
    parts = []
    count = math.ceil(len(weights) / length)
    edges = [round(k * len(weights) / count) for k in range(count + 1)]
    for first, last in pairwise(edges):
        used = np.flatnonzero(weights[first:last].any(axis=0))
        parts.append((slice(first, last), slice(int(used[0]), int(used[-1]) + 1)))
    return parts
