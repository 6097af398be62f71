"""Depth-dependent blur as a linear operator, with its adjoint."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.base.options import listed
from lommel.base.threads import side_by_side
from lommel.base.units import format_length
from lommel.core import engine
from lommel.core.answers import DType
from lommel.deconvolve.linear import LinearBlur, folded
from lommel.imaging.bank import Bank, build_bank
from lommel.imaging.sensor_light import SensorLight
from lommel.imaging.settings import FILL, OperatorOptions, Spectrum, spectra
from lommel.optics.lens import Lens, require_round

_BAND = 2**17  # number of points that are spread together if `watch` is set


class Points(NamedTuple):
    """Points of one channel that spread light, by position in the bank."""

    positions: Array  # positions in the bank of windows; negative for points that spread no light
    layers: Values | None = None  # layer of each point, counted from the front


@listed(OperatorOptions)
class DepthBlur(LinearBlur):
    r"""Blur by depth, a linear operator without occlusion: ``out[q] = sum_p image[p] K(q - p; C_d(depth[p]))``.

    K is the pixel-integrated PSF at the defocus C_d of the source point p. It is truncated to a window that holds the
    fraction `energy` of its light, and divided by this fraction: the blur conserves light. Windows are interpolated
    by cubics in a bank, a table of windows over defocus. At its edges the image, with its depth, is mirrored. For
    occlusion see :class:`lommel.imaging.Occlusion`.

    Parameters
    ----------
    depth : array_like, shape (height, width)
        Distance of each point from the lens along the axis, metres, positive or infinite.
    lens : Lens
        Lens with radially symmetric aberrations.
    pixel : float
        Pixel pitch, metres.
    channels : sequence, default (lens.wavelength,)
        For each channel a wavelength (metres), or a spectrum: a sequence of pairs (wavelength, weight).
    options : OperatorOptions, optional
        Options as an object, which keywords change.
    {options}

    Attributes
    ----------
    banks : tuple of Bank
        Bank of windows of each channel.
    spectra : tuple
        Spectrum of each channel: pairs of a wavelength (metres) and a weight.
    lost : float
        Largest fraction of the light outside the window, over all points and channels.
    error : float
        Largest error of interpolated windows relative to their peaks, checked half-way between windows.

    Raises
    ------
    TypeError, ValueError
        If an argument is of the wrong type or out of range, or if a window would be wider than `largest` allows.
    """

    # Optional progress callback; the argument is the number of points that were blurred since the last call.
    watch: Callable[[int], object] | None = None

    # Cache of `positions`: defocus map, banks, and the positions of the points of this map in each bank.
    _placed: tuple[Array, tuple[Bank, ...], tuple[Array, ...]] | None = None

    def __init__(
        self,
        depth: ArrayLike,
        lens: Lens,
        pixel: float,
        *,
        channels: Sequence[Spectrum] | None = None,
        options: OperatorOptions | None = None,
        **given: Any,
    ) -> None:
        o = OperatorOptions.of("DepthBlur", options, given)
        require_lens(lens, "depth, lens, pixel")
        require_round("lens", lens)
        self.lens = lens
        self.pixel = validation.pixel(pixel, metric=True)
        validation.pixel_on(self.pixel, lens.wavelength * lens.working_f_number, metric=True)
        self.dtype, self.threads = cast("np.dtype[np.floating]", o.dtype), o.threads or 0
        self.place(depth)
        warn_of_depths(lens, self.pixel, depth)
        defocus_range = (float(self.defocus.min()), float(self.defocus.max()))
        # By default at most half of the image: a larger window would spread most of its light outside the image.
        largest = o.largest or max(1, min(self.shape) // 2)
        self.spectra = spectra("channels", [lens.wavelength] if channels is None else channels)
        self.channels = len(self.spectra)

        def bank(spectrum: tuple[tuple[float, float], ...]) -> Bank:
            light = SensorLight.of(lens, spectrum, self.pixel, self.threads)
            return build_bank(light, defocus_range, tol=o.tol, energy=o.energy, largest=largest, dtype=self.dtype)

        # Channels with equal spectra share a bank; the banks of different spectra are computed in parallel.
        distinct = tuple(dict.fromkeys(self.spectra))
        bank_of = dict(zip(distinct, side_by_side(bank, distinct, self.threads), strict=True))
        self.banks = tuple(bank_of[spectrum] for spectrum in self.spectra)

    def place(self, depth: ArrayLike) -> None:
        """Replace the depth map by `depth` (metres), within the range of the first map; ValueError unless all > 0."""
        distances = require_depth(depth)
        self.defocus = self.lens.defocus(distances)
        self.defocus.flags.writeable = False
        self.shape = distances.shape[0], distances.shape[1]

    @property
    def lost(self) -> float:
        """Largest fraction of the light outside the window, over all points and channels."""
        return max(bank.lost for bank in self.banks)

    @property
    def error(self) -> float:
        """Largest error of interpolated windows relative to their peaks."""
        return max(bank.error for bank in self.banks)

    def forward(self, image: Values) -> Values:
        """Return the blurred `image`: see :meth:`lommel.imaging.LinearBlur.forward`."""
        return self.by_channel(
            image, lambda channel, plane: self.spread(channel, [(plane, Points(self.positions(channel)))])
        )

    def adjoint(self, image: Values) -> Values:
        """Return the transpose of :meth:`forward` of `image`: see :meth:`lommel.imaging.LinearBlur.adjoint`."""
        return self.by_channel(
            image, lambda channel, plane: next(self.collect(channel, plane, [Points(self.positions(channel))]))
        )

    def spread(self, channel: int, sources: Sequence[tuple[Values, Points]], seen: Values | None = None) -> Values:
        """Return the blurred light of several `sources` in one `channel`.

        Each source is a pair: light, shape (height, width), and the points that spread it. `seen` is the number of
        layers that each pixel sees, a real number; None for all layers. Planes have the shape and the dtype of the
        operator.
        """
        bank, margins = self._padded_bank(channel)
        padded = np.zeros([side + sum(pair) for side, pair in zip(self.shape, margins, strict=True)], self.dtype)
        seen_around = None if seen is None else np.pad(seen, margins, mode="symmetric")
        for plane, points in sources:
            for band, rim in self._bands(bank.half):
                positions = points.positions[band]
                layers = None if points.layers is None else points.layers[band]
                limits = layers, None if seen_around is None else seen_around[rim]
                engine.spread(parts(bank), positions, plane[band], self.threads, padded[rim], *limits)
                if self.watch is not None:
                    self.watch(int(np.count_nonzero(positions >= 0.0)))
        # Light that leaves the image is reflected into it.
        return folded(padded, [before for before, _ in margins], self.shape)

    def collect(
        self, channel: int, plane: Values, sources: Sequence[Points], seen: Values | None = None
    ) -> Iterator[Values]:
        """Yield the transpose of :meth:`spread`, applied to a `plane`, for each of the `sources`."""
        bank, margins = self._padded_bank(channel)
        padded = np.pad(plane, margins, mode="symmetric")
        seen_around = None if seen is None else np.pad(seen, margins, mode="symmetric")
        for points in sources:
            sums = np.empty(self.shape, dtype=self.dtype)
            engine.collect(parts(bank), points.positions, padded, self.threads, sums, points.layers, seen_around)
            yield sums

    def _padded_bank(self, channel: int) -> tuple[Bank, list[tuple[int, int]]]:
        """Return the bank of a channel, and the margins that windows need."""
        bank = self.banks[channel]
        return bank, [(width,) * 2 for width in bank.beyond]

    def _bands(self, half: int) -> Iterator[tuple[slice, slice]]:
        """Yield pairs: a band of rows, and the rows that receive its light; one band unless `watch` is set."""
        # A band has at least eight half widths of rows: rows that receive light of two bands take twice the time.
        height = self.shape[0] if self.watch is None else max(_BAND // self.shape[1], 8 * half, 64)
        for first in range(0, self.shape[0], height):
            last = min(first + height, self.shape[0])
            yield slice(first, last), slice(first, last + 2 * half)

    def positions(self, channel: int) -> Array:
        """Return the position of each point in the bank of a `channel`."""
        placed = self._placed
        if placed is None or placed[0] is not self.defocus or placed[1] is not self.banks:
            on_grid = {(b.start, b.spacing): np.maximum(b.positions(self.defocus), 0.0) for b in self.banks}
            in_banks = tuple(on_grid[bank.start, bank.spacing] for bank in self.banks)
            self._placed = placed = self.defocus, self.banks, in_banks
        return placed[2][channel]


def parts(bank: Bank) -> tuple[Values, NDArray[np.int64], Array]:
    """Return windows, half widths and energies of a bank in the layout of the compiled core."""
    return bank.windows, bank.halves, bank.energies


def require_lens(lens: object, order: str) -> Lens:
    """Return `lens`; TypeError unless it is a Lens: the message states the `order` of the arguments."""
    if not isinstance(lens, Lens):
        raise TypeError(f"lens must be a Lens, got {type(lens).__name__}; the order of arguments is {order}")
    return lens


def require_depth(depth: ArrayLike) -> Array:
    """Return depth as float64; raise TypeError or ValueError unless it is a 2-D array of distances > 0 in metres."""
    distances = validation.array("depth", depth, "metres")
    require_metres(distances.dtype)
    if distances.ndim != 2 or 0 in distances.shape:
        raise ValueError(f"depth must have the shape (height, width), got {distances.shape}")
    metres = distances.astype(np.float64, copy=False)
    if not np.all(metres > 0.0):
        if (unknown := np.isnan(metres)).any():
            count = int(unknown.sum())
            raise ValueError(f"depth is NaN at {count} of {metres.size} points; {FILL}")
        raise ValueError(f"depth must be > 0 metres, got {metres[~(metres > 0.0)].flat[0]}")
    return metres


def require_metres(kind: DType) -> None:
    """Raise TypeError unless depth has a float dtype: the unit of integer levels is unknown."""
    if kind.kind != "f":
        raise TypeError(
            f"depth must hold metres in floats, got {kind}; if one level is a millimetre, pass 0.001 * depth"
        )


_IN_FOCUS = 2.0  # largest circle of confusion, pixels, of a point that `lommel info` reports as sharp


def warn_of_depths(lens: Lens, pixel: float, depth: ArrayLike) -> None:
    """Warn if the whole depth map is implausible for this lens, such as millimetres instead of metres."""
    distances = np.asarray(depth, dtype=np.float64)
    low, high = (float(end(distances, initial=initial)) for end, initial in ((np.min, math.inf), (np.max, 0.0)))
    # Hyperfocal distance f (1 + D / c), c the circle of confusion.
    hyperfocal = lens.focal_length * (1.0 + lens.aperture_diameter / (_IN_FOCUS * pixel))
    if hyperfocal < low < math.inf:
        location = f"beyond the hyperfocal distance, {format_length(hyperfocal)}, where blur hardly depends on depth"
    elif high < lens.focal_length:
        location = f"within the focal length, {format_length(lens.focal_length)}"
    else:
        return
    ends = " to ".join(format_length(end) for end in dict.fromkeys((low, high)))
    validation.tell(f"all of the depth, {ends}, is {location}: is it in metres?")
