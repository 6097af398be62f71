"""Depth-dependent blur as a linear operator, with its adjoint and derivatives."""

from __future__ import annotations

import copy
import math
import os
import warnings
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple, Unpack, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.base.options import shares
from lommel.base.threads import side_by_side
from lommel.base.units import format_length
from lommel.core import engine
from lommel.core.answers import DType
from lommel.deconvolve.linear import LinearBlur, copies, folded, linear_operator, without_copies
from lommel.imaging.bank import Bank, MirroredKernels, Remainder, build_bank, stored_windows
from lommel.imaging.sensor_light import SensorLight, cut, find_cuts, sums_of_quarters
from lommel.imaging.settings import FILL, BlurKeywords, Settings, Spectrum, spectra
from lommel.optics.lens import Lens, require_round

if TYPE_CHECKING:
    from scipy.sparse.linalg import LinearOperator


_BAND = 2**17  # number of points that are spread together if `watch` is set


class Points(NamedTuple):
    """Points of one channel that spread light, by position in the bank."""

    positions: Array  # positions in the bank of windows; negative for points that spread no light
    layers: Values | None = None  # layer of each point, counted from the front


@shares(BlurKeywords, Settings)
class DepthBlur(LinearBlur):
    r"""Blur by depth, a linear operator without occlusion: ``out[q] = sum_p image[p] K(q - p; C_d(depth[p]))``.

    K is the pixel-integrated PSF at the defocus C_d of the source point p. It is truncated to a window that holds the
    fraction `energy` of its light, and divided by this fraction: the blur conserves light. With ``energy=1``, K is
    the sum of a window and an unbounded smooth remainder. Windows are interpolated by cubics in a bank, a table of
    windows over defocus. For occlusion see :class:`lommel.imaging.Occlusion`.

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
    {options}

    Attributes
    ----------
    banks : tuple of Bank
        Bank of windows of each channel.
    spectra : tuple
        Spectrum of each channel: pairs of a wavelength (metres) and a weight.
    lost : float
        Largest fraction of the light outside the window, over all points and channels; 0 with ``energy=1``.
    error : float
        Largest error of interpolated windows relative to their peaks, checked half-way between windows. With
        ``energy=1``: the sum over pixels of the largest error of K at the distances of the scene. The error of a
        blurred pixel is at most this sum times the brightest point; a warning is issued if the sum exceeds 2 tol.

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
        **options: Unpack[BlurKeywords],
    ) -> None:
        require_lens(lens, "depth, lens, pixel")
        require_round("lens", lens)
        self.lens = lens
        self.pixel = validation.pixel(pixel, metric=True)
        validation.pixel_on(self.pixel, lens.wavelength * lens.working_f_number, metric=True)
        settings = Settings.of(DepthBlur, options, BlurKeywords)
        self.border, self.energy = settings.border, settings.energy
        self.dtype, self.threads = cast("np.dtype[np.floating]", settings.dtype), settings.threads or 0
        self.place(depth)
        warn_of_depths(lens, self.pixel, depth)
        defocus_range = (float(self.defocus.min()), float(self.defocus.max()))
        # By default at most half of the image: a larger window would spread most of its light outside the image.
        largest = settings.largest or max(1, min(self.shape) // 2)
        self.spectra = spectra("channels", [lens.wavelength] if channels is None else channels)
        self.channels = len(self.spectra)

        def bank(spectrum: tuple[tuple[float, float], ...]) -> Bank:
            light = SensorLight.of(lens, spectrum, self.pixel, self.threads)
            return build_bank(
                light, defocus_range, tol=settings.tol, energy=settings.energy, largest=largest, dtype=self.dtype
            )

        # Channels with equal spectra share a bank; the banks of different spectra are computed in parallel.
        distinct = tuple(dict.fromkeys(self.spectra))
        bank_of = dict(zip(distinct, side_by_side(bank, distinct, self.threads), strict=True))
        self.banks = tuple(bank_of[spectrum] for spectrum in self.spectra)
        self.beyond = (
            Beyond([bank.remainder for bank in self.banks if bank.remainder is not None], settings.tol)
            if settings.energy == 1.0
            else None
        )
        if self.beyond is not None and (error := self.error) > 2.0 * settings.tol:
            rounding = "dtype=float64, " if 2.0 * self.beyond.rounding(self.dtype) > error else ""
            warnings.warn(
                f"with energy=1 the error of a pixel may reach {error:.2g} of the brightest point, more than twice "
                f"tol={settings.tol:g}; choose {rounding}a larger tol, or energy=0.9999, with an interpolation error "
                "below tol",
                stacklevel=3,
            )

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
        """Largest error of windows relative to their peaks; with ``energy=1``, sum of the errors of K over pixels."""
        return max(bank.error for bank in self.banks) if self.beyond is None else self.beyond.error(self)

    def forward(self, image: Values, weight: Values | None = None) -> Values:
        """Return the blurred `image`; if the bool map `weight` is given, only its points spread light."""
        return np.stack(self.act(self.planes(image), weight), axis=-1).reshape(np.shape(image))

    def adjoint(self, image: Values, weight: Values | None = None) -> Values:
        """Return the transpose of :meth:`forward` applied to an `image`; points outside of `weight` receive 0."""
        planes = self.act(self.planes(image), weight, transposed=True)
        return np.stack(planes, axis=-1).reshape(np.shape(image))

    def act(
        self,
        planes: Sequence[Values] | Values,
        weight: Values | None = None,
        *,
        slopes: bool = False,
        transposed: bool = False,
    ) -> list[Values]:
        """Apply :meth:`forward`, or with `transposed` :meth:`adjoint`, to the `planes` of all channels.

        `weight` is the bool map of :meth:`forward`. With `slopes`, windows are replaced by their derivatives with
        respect to the position in the bank.
        """
        images = []
        for channel, plane in enumerate(planes):
            points = Points(self._positions(channel, weight))
            if transposed:
                images.append(next(self.collect(channel, plane, [points], slopes=slopes)))
            else:
                images.append(self.spread(channel, [(plane, points)], slopes=slopes))
        if self.beyond is not None:
            sources = planes if weight is None or transposed else [plane * weight for plane in planes]
            # Light outside the windows is computed for all points together and added to the whole image.
            outside = self.beyond.act(self, range(self.channels), sources, slopes=slopes, transposed=transposed)
            for image, far_image in zip(images, outside, strict=True):
                image += far_image if weight is None or not transposed else far_image * weight
        return images

    def spread(
        self,
        channel: int,
        sources: Sequence[tuple[Values, Points]],
        seen: Values | None = None,
        *,
        bank: Bank | None = None,
        slopes: bool = False,
    ) -> Values:
        """Return the blurred light of several `sources` in one `channel`.

        Each source is a pair: light, shape (height, width), and the points that spread it. `seen` is the number of
        layers that each pixel sees, a real number; None for all layers. `bank` has the layout of the bank of the
        channel and replaces it. `slopes` replaces windows by their derivatives with respect to position. Raises
        TypeError or ValueError if the channel does not exist, or a plane is not of the dtype of the operator.
        """
        rows, columns, margins = self._padded_indices(channel)
        if not isinstance(sources, Sequence):
            raise TypeError(f"sources must be a sequence of planes and points, got {validation.shown(sources)}")
        for plane, points in sources:
            self._require(plane, points)
        padded = np.zeros([side + sum(pair) for side, pair in zip(self.shape, margins, strict=True)], self.dtype)
        seen_around = self._pad_layers(seen, margins)
        bank_used = bank or self.banks[channel]
        for plane, points in sources:
            for band, rim in self._bands(rows, bank_used.half):
                indices = points.positions, rows[band], columns
                limits = points.layers, None if seen_around is None else seen_around[rim]
                engine.spread(parts(bank_used), indices, plane, self.threads, padded[rim], *limits, slopes)
                if self.watch is not None:
                    self.watch(int(np.count_nonzero(points.positions[rows[band]] >= 0.0)))
        if self.border == "reflect":  # light that leaves the image is reflected into it
            return folded(folded(padded, margins[0][0], self.shape[0]).T, margins[1][0], self.shape[1]).T
        (top, _), (left, _) = margins
        return padded[top:, left:][: self.shape[0], : self.shape[1]]

    def collect(
        self,
        channel: int,
        plane: Values,
        sources: Sequence[Points],
        seen: Values | None = None,
        *,
        bank: Bank | None = None,
        slopes: bool = False,
    ) -> Iterator[Values]:
        """Yield the transpose of :meth:`spread`, applied to a `plane`, for each of the `sources`.

        `channel`, `seen`, `bank` and `slopes` are those of :meth:`spread`.
        """
        rows, columns, margins = self._padded_indices(channel)
        for points in sources:
            self._require(plane, points)
        padded = np.pad(plane, margins, mode="symmetric" if self.border == "reflect" else "constant")
        seen_around = self._pad_layers(seen, margins)
        for points in sources:
            sums = np.empty((rows.size, columns.size), dtype=self.dtype)
            indices, tables = (points.positions, rows, columns), parts(bank or self.banks[channel])
            engine.collect(tables, indices, padded, self.threads, sums, points.layers, seen_around, slopes)
            yield without_copies(sums, rows, columns, self.shape)

    def _require(self, plane: object, points: object) -> None:
        """Raise TypeError unless `points` are Points, and `plane` has the shape and dtype of the operator."""
        validation.instance("points", points, Points)
        if not isinstance(plane, np.ndarray) or plane.shape != self.shape or plane.dtype != self.dtype:
            raise TypeError(
                f"plane must be an array of {self.dtype} of the shape {self.shape}, got {validation.shown(plane)}"
            )

    def _padded_indices(self, channel: int) -> tuple[NDArray[np.int64], NDArray[np.int64], list[tuple[int, int]]]:
        """Return the row and column indices of the image, padded with edge copies, and the margins of the result."""
        bank = self.banks[validation.integer("channel", channel, least=0, most=len(self.banks) - 1)]
        # Other borders need no copies: a reflected border is folded back after blurring, and a dark border is empty.
        margin = bank.half if self.border == "extend" else 0
        rows, columns = (copies(side, margin, self.border) for side in self.shape)
        return rows, columns, [(margin + width,) * 2 for width in bank.beyond]

    def _bands(self, rows: NDArray[np.int64], half: int) -> Iterator[tuple[slice, slice]]:
        """Yield pairs: a band of rows, and the rows that receive its light; one band unless `watch` is set."""
        # A band has at least eight half widths of rows: rows that receive light of two bands take twice the time.
        height = len(rows) if self.watch is None else max(_BAND // self.shape[1], 8 * half, 64)
        for first in range(0, len(rows), height):
            last = min(first + height, len(rows))
            yield slice(first, last), slice(first, last + 2 * half)

    def _pad_layers(self, seen: Values | None, margins: list[tuple[int, int]]) -> Values | None:
        """Return `seen`, the number of layers that each pixel sees, padded by `margins`; None for None."""
        return (
            None if seen is None else np.pad(seen, margins, mode="symmetric" if self.border == "reflect" else "edge")
        )

    def positions(self, channel: int) -> Array:
        """Return the position of each point in the bank of a `channel`; ValueError if there is no such channel."""
        channel = validation.integer("channel", channel, least=0, most=len(self.banks) - 1)
        placed = self._placed
        if placed is None or placed[0] is not self.defocus or placed[1] is not self.banks:
            on_grid = {(b.start, b.spacing): np.maximum(b.positions(self.defocus), 0.0) for b in self.banks}
            in_banks = tuple(on_grid[bank.start, bank.spacing] for bank in self.banks)
            self._placed = placed = self.defocus, self.banks, in_banks
        return placed[2][channel]

    def _positions(self, channel: int, weight: Values | None) -> Array:
        """Return the :meth:`positions` of all points, with negative values outside of `weight`."""
        positions = self.positions(channel)
        if weight is None:
            return positions
        mask = validation.array("weight", weight)
        if not isinstance(weight, np.ndarray) or mask.dtype != np.bool_ or mask.shape != self.shape:
            got = f"{mask.dtype} of the shape {mask.shape}"
            raise TypeError(f"weight must be an array of bool of the shape {self.shape}, got {got}")
        return np.where(weight, positions, -1.0)


def parts(bank: Bank) -> tuple[Values, NDArray[np.int64], Array]:
    """Return windows, half widths and energies of a bank in the layout of the compiled core."""
    return bank.windows, bank.halves, bank.energies


def require_lens(lens: object, order: str) -> None:
    """Raise TypeError unless `lens` is a Lens; the message states the `order` of the arguments."""
    if not isinstance(lens, Lens):
        raise TypeError(f"lens must be a Lens, got {type(lens).__name__}; the order of arguments is {order}")


def require_depth(depth: ArrayLike) -> Array:
    """Return depth as float64; raise TypeError or ValueError unless it is a 2-D array of distances > 0 in metres."""
    distances = validation.array("depth", depth)
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


_ROUNDING = 32.0  # rounding error of a sum / machine epsilon; the largest measured, in single precision, was 9
_MIN_THREADED = 2**16  # smallest number of pixels for threads: starting threads takes longer than smaller images


class Beyond:
    """Light outside the windows, from every point to every pixel, as an operator with its transpose."""

    def __init__(self, remainders: Sequence[Remainder], tol: float) -> None:
        self._remainders, self._tol = remainders, tol
        self._kernels: dict[tuple[Remainder, tuple[int, int], str], MirroredKernels] = {}
        self._factors: dict[Remainder, tuple[Array, Values]] = {}

    def error(self, blur: DepthBlur) -> float:
        """Return the sum over pixels of the largest error of K in this scene, the maximum over channels."""
        # With a dark border, only light that stays inside the image counts.
        shape = blur.shape if blur.border == "zero" else None
        largest = max(
            remainder.error(blur.positions(channel), shape) + self._kernels_of(blur, channel).error
            for channel, remainder in enumerate(self._remainders)
        )
        return largest + self.rounding(blur.dtype)

    @staticmethod
    def rounding(dtype: np.dtype[np.floating]) -> float:
        """Return the rounding error assumed for a pixel of this `dtype`, relative to the brightest point."""
        return _ROUNDING * float(np.finfo(dtype).eps)

    def act(
        self,
        blur: DepthBlur,
        channels: Sequence[int],
        planes: Sequence[Values] | Values,
        *,
        slopes: bool = False,
        transposed: bool = False,
    ) -> list[Values]:
        """Return the light outside the windows for one plane of each of the `channels`; see :meth:`DepthBlur.act`."""
        threads = (blur.threads or os.cpu_count() or 1) if math.prod(blur.shape) >= _MIN_THREADED else 1
        kernels = [self._kernels_of(blur, channel) for channel in channels]
        factors = [self._factors_of(blur, channel, slopes) for channel in channels]
        if transposed:
            inputs = [kernel.padded_transform(plane, threads) for kernel, plane in zip(kernels, planes, strict=True)]
        else:
            inputs = [np.ascontiguousarray(plane) for plane in planes]

        def term(pair: tuple[int, int]) -> Values:
            index, r = pair
            if transposed:
                return np.asarray(kernels[index].transposed(r, inputs[index]) * factors[index][r])
            return kernels[index].transformed(r, factors[index][r] * inputs[index])

        pairs = [(index, r) for index, rows in enumerate(factors) for r in range(len(rows))]
        sums: list[Values] = []
        for (_, r), summand in zip(pairs, side_by_side(term, pairs, threads), strict=True):
            if r == 0:
                sums.append(summand)
            else:
                sums[-1] += summand
        if transposed:
            return sums
        return [kernel.image(total, threads) for kernel, total in zip(kernels, sums, strict=True)]

    def _kernels_of(self, blur: DepthBlur, channel: int) -> MirroredKernels:
        """Return the kernels of a channel for images of the shape and border of `blur`; cached."""
        remainder = self._remainders[channel]
        key = (remainder, blur.shape, blur.border)
        if key not in self._kernels:
            self._kernels[key] = MirroredKernels(remainder, blur.shape, blur.border, blur.dtype, self._tol)
        return self._kernels[key]

    def _factors_of(self, blur: DepthBlur, channel: int, slopes: bool) -> Values:
        """Return the a_r of all points, cached for one depth map; with `slopes` their derivatives, not cached."""
        remainder, positions = self._remainders[channel], blur.positions(channel)
        if slopes:
            return remainder.factors(positions, blur.dtype, slopes=True, threads=blur.threads)
        cached = self._factors.get(remainder)
        if cached is None or cached[0] is not positions:
            cached = self._factors[remainder] = (
                positions,
                remainder.factors(positions, blur.dtype, threads=blur.threads),
            )
        return cached[1]


# Central differences of fourth order with respect to ln d, d the sensor distance, as pairs (offset in steps, weight).
# A step changes C_d by at most _STEP_OF_DEFOCUS (rad) and ln d by at most _STEP_OF_SCALE.
_DIFFERENCES = ((-2.0, 1.0 / 12.0), (-1.0, -2.0 / 3.0), (1.0, 2.0 / 3.0), (2.0, -1.0 / 12.0))
_STEP_OF_DEFOCUS, _STEP_OF_SCALE = 0.03, 1e-3


# If the distance z of a point with the light x changes by delta, its image changes by x delta (dC_d/dz) (dK/dC_d).
# K is a sum of four windows with cubic weights; dK/dC_d is the sum of these windows with the derivatives of the
# weights. C_d is k (1/d - 1/f + 1/z) at the sensor distance d, with k = pi R^2 / (2 lambda): dC_d/dz = -k / z^2, and
# dC_d/dd = -k / d^2 for all points. A change of d also scales all windows in proportion to d.
class BlurSlopes:
    """Derivatives of ``blur.forward(image)`` with respect to the depth of every point and to the focus.

    A linear operator from changes of depth to changes of the photograph, with its exact transpose. The operator and
    the transpose each take about as long as the blur. The interpolated windows are differentiated: the error of
    dK/dC_d, relative to the peak, is about `tol` per radian, and more where windows are far apart.

    Parameters
    ----------
    image : ndarray of float
        The scene, linear light, of the shape that :meth:`lommel.imaging.DepthBlur.forward` takes.
    blur : DepthBlur
        Blur at the depth map of the derivatives; a later ``blur.place`` does not change them.

    Raises
    ------
    TypeError, ValueError
        If `blur` is not a DepthBlur, or if :meth:`lommel.imaging.DepthBlur.forward` does not accept `image`.

    Examples
    --------
    >>> lens = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
    >>> depth, light = np.full((20, 30), 2.3), np.random.default_rng(0).random((20, 30))
    >>> blur = lm.imaging.DepthBlur(depth, lens, 8e-6, dtype=np.float64, tol=1e-6)
    >>> slopes = lm.imaging.BlurSlopes(light, blur)
    >>> before, change = blur.forward(light), np.full((20, 30), 1e-6)
    >>> blur.place(depth + change)
    >>> bool(np.allclose(blur.forward(light) - before, slopes.forward(change), rtol=1e-3, atol=1e-9))
    True
    """

    def __init__(self, image: Values, blur: DepthBlur) -> None:
        validation.instance("blur", blur, DepthBlur)
        self._blur, self.shape = copy.copy(blur), blur.shape
        self._planes = np.array(blur.planes(image))
        self._shape = np.shape(image)
        lens = blur.lens
        infinite = float(lens.defocus(math.inf))
        # dC_d/dz; it is 0 at an infinite distance.
        self._per_metre = -((blur.defocus - infinite) ** 2) / (float(lens.defocus(1.0)) - infinite)

    def forward(self, change: Values) -> Values:
        """Return the first-order change of the photograph for a `change` of depth (m); ValueError by shape."""
        metres = validation.real_array("change", change)
        if metres.shape != self.shape:
            raise ValueError(f"change must have the shape of the depth, {self.shape}, got {metres.shape}")
        radians = metres * self._per_metre
        products = [plane * self._position_changes(channel, radians) for channel, plane in enumerate(self._planes)]
        return np.stack(self._blur.act(products, slopes=True), axis=-1).reshape(self._shape)

    def adjoint(self, image: Values) -> Values:
        """Return the gradient, per metre of depth, of the sum of `image` times the photograph."""
        by_position = self._blur.act(self._blur.planes(image), slopes=True, transposed=True)
        total = np.zeros(self.shape, dtype=self._blur.dtype)
        for channel, plane in enumerate(self._planes):
            total += by_position[channel] * plane * self._position_changes(channel, self._per_metre)
        return total

    def focus(self) -> Values:
        """Return the derivative of the photograph with respect to the sensor distance, light per metre.

        The aperture keeps its diameter. The derivative with respect to the focus distance s is ``-(d / s)**2`` times
        the derivative returned, with d = ``lens.sensor_distance``. Raises ValueError for ``energy=1``.
        """
        blur = self._blur
        if blur.beyond is not None:
            raise ValueError("energy must be below 1 for the derivative by focus, for example 0.9999, got 1")
        operator = copy.copy(blur)
        distinct = dict(zip(blur.banks, blur.spectra, strict=True))
        derivatives = {bank: _differentiate_by_focus(blur, bank, spectrum) for bank, spectrum in distinct.items()}
        operator.banks = tuple(derivatives[bank] for bank in blur.banks)
        return np.stack(operator.act(self._planes), axis=-1).reshape(self._shape) / blur.lens.sensor_distance

    def as_linear_operator(self) -> LinearOperator:
        """Return the operator for SciPy's solvers: from vectors of depth changes (m) to vectors of pixel changes."""
        return linear_operator(self.forward, self.adjoint, self._shape, self.shape, self._blur.dtype)

    def _position_changes(self, channel: int, radians: Array) -> Values:
        """Convert changes of C_d in radians to changes of the position in the bank of a channel."""
        return (radians / self._blur.banks[channel].spacing).astype(self._blur.dtype)


def _differentiate_by_focus(blur: DepthBlur, bank: Bank, spectrum: tuple[tuple[float, float], ...]) -> Bank:
    """Return a bank of the derivatives of windows with respect to ln d at fixed points, d the sensor distance.

    The derivatives are finite differences of truncated and normalised windows. These windows are smooth in d except
    where half widths have kinks.
    """
    lens, infinite = blur.lens, float(blur.lens.defocus(math.inf))
    defocus = bank.start + bank.spacing * np.arange(bank.count, dtype=np.float64)
    rate = (float(lens.defocus(1.0)) - infinite) / lens.sensor_distance
    step = min(_STEP_OF_SCALE, _STEP_OF_DEFOCUS / rate)
    terms = []
    for steps, weight in _DIFFERENCES:
        refocused = replace(lens, sensor_distance=lens.sensor_distance * (1.0 + steps * step))
        light = SensorLight.of(refocused, spectrum, blur.pixel, blur.threads)
        pupils = light.defocused(defocus + (float(refocused.defocus(math.inf)) - infinite))
        octants = light.shares(pupils, bank.half + 2)
        quarter = cut(octants, find_cuts(octants, bank.half + 2, blur.energy))
        terms.append(weight / step * quarter / sums_of_quarters(quarter)[:, None, None])
    widest = max(quarter.shape[1] for quarter in terms)
    sums = sum(np.pad(quarter, ((0, 0), *[(0, widest - quarter.shape[1])] * 2)) for quarter in terms)
    half_widths, energies = np.full(bank.count, widest - 1.0), np.ones(bank.count)
    return replace(bank, windows=stored_windows(np.asarray(sums), blur.dtype), cuts=half_widths, energies=energies)
