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
from lommel.imaging.settings import BlurKeywords, Settings, Spectrum, spectra
from lommel.optics.lens import Lens, require_round

if TYPE_CHECKING:
    from scipy.sparse.linalg import LinearOperator


_BAND = 2**17  # points spread at a time while progress is watched


class Points(NamedTuple):
    """Points of one channel that spread light."""

    positions: Array  # in the bank; negative for points that spread nothing
    layers: Values | None = None  # layer of each point, counted from the front


@shares(BlurKeywords, Settings)
class DepthBlur(LinearBlur):
    r"""Blur by depth, a linear operator without occlusion: ``out[q] = sum_p image[p] K(q - p; C_d(depth[p]))``.

    K is the pixel-integrated PSF at the defocus of each source point, truncated to a window that holds `energy` of
    its light and divided by the light in the window, so that light is conserved; with ``energy=1`` it is the sum of a
    window and an unbounded smooth remainder. Between the windows of a bank it is interpolated by cubics. For
    occlusion see :class:`lommel.imaging.Occlusion`.

    Parameters
    ----------
    depth : array_like, shape (height, width)
        Distance of each point from the lens along the axis, metres, positive; may be infinite.
    lens : Lens
        Its aberrations must be radially symmetric.
    pixel : float
        Pixel pitch, metres.
    channels : sequence, default (lens.wavelength,)
        For each channel a wavelength (metres), or its spectrum, pairs of wavelength and weight.
    {options}

    Attributes
    ----------
    banks : tuple of Bank
        One for each channel.
    spectra : tuple
        Pairs of a wavelength (metres) and a weight for each channel.
    lost : float
        Largest fraction of the light beyond the windows, of any point and channel; 0 for the whole PSF.
    error : float
        Largest error of interpolated windows over their peak, checked half-way between windows. For the whole PSF the
        sum over pixels of the largest error of K, at the distances of the scene: no pixel is off by more than this
        times the brightest point. A warning is given where that exceeds twice `tol`.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range; if the blur exceeds `largest`.
    """

    # Called with the number of points spread since the last call, if set; see `_bands`.
    watch: Callable[[int], object] | None = None

    # Positions of the points in the banks, with the defocus and the banks that they belong to.
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
        tell_of_depths(lens, self.pixel, depth)
        reach = (float(self.defocus.min()), float(self.defocus.max()))
        # Half the image at most: a larger window would spread more light outside than inside.
        largest = settings.largest or max(1, min(self.shape) // 2)
        self.spectra = spectra("channels", [lens.wavelength] if channels is None else channels)
        self.channels = len(self.spectra)

        def bank(spectrum: tuple[tuple[float, float], ...]) -> Bank:
            light = SensorLight.of(lens, spectrum, self.pixel, self.threads)
            return build_bank(
                light, reach, tol=settings.tol, energy=settings.energy, largest=largest, dtype=self.dtype
            )

        # Channels with equal spectra share a bank, and distinct ones are computed side by side.
        distinct = tuple(dict.fromkeys(self.spectra))
        known = dict(zip(distinct, side_by_side(bank, distinct, self.threads), strict=True))
        self.banks = tuple(known[spectrum] for spectrum in self.spectra)
        self.beyond = (
            Beyond([bank.remainder for bank in self.banks if bank.remainder is not None], settings.tol)
            if settings.energy == 1.0
            else None
        )
        if self.beyond is not None and (error := self.error) > 2.0 * settings.tol:
            rounding = "for dtype=float64, " if 2.0 * self.beyond.rounding(self.dtype) > error else ""
            warnings.warn(
                f"with energy=1 a pixel may be off by {error:.2g} of the brightest point, more than "
                f"tol={settings.tol:g}; ask {rounding}for a tol of that size, or for energy=0.9999, whose windows "
                "err by less than tol",
                stacklevel=3,
            )

    def place(self, depth: ArrayLike) -> None:
        """Set another `depth` (metres) within the range of the first; ValueError unless it is > 0."""
        distances = require_depth(depth)
        self.defocus = self.lens.defocus(distances)
        self.defocus.flags.writeable = False
        self.shape = distances.shape[0], distances.shape[1]

    @property
    def lost(self) -> float:
        """Largest fraction of the light beyond the windows, of any point and channel."""
        return max(bank.lost for bank in self.banks)

    @property
    def error(self) -> float:
        """Largest error of interpolated windows over their peak; with ``energy=1`` that of K, summed over pixels."""
        return max(bank.error for bank in self.banks) if self.beyond is None else self.beyond.error(self)

    def forward(self, image: Values, weight: Values | None = None) -> Values:
        """Return the blurred image of an `image`, or of only its points in the bool map `weight`."""
        return np.stack(self.act(self.planes(image), weight), axis=-1).reshape(np.shape(image))

    def adjoint(self, image: Values, weight: Values | None = None) -> Values:
        """Return the transpose of :meth:`forward` applied to an `image`; points outside of `weight` receive 0."""
        taken = self.act(self.planes(image), weight, transposed=True)
        return np.stack(taken, axis=-1).reshape(np.shape(image))

    def act(
        self,
        planes: Sequence[Values] | Values,
        weight: Values | None = None,
        *,
        slopes: bool = False,
        transposed: bool = False,
    ) -> list[Values]:
        """Return what :meth:`forward` makes of the `planes` of all channels, or with `transposed` :meth:`adjoint`.

        `weight` is as there; with `slopes` windows are replaced by their derivatives by positions.
        """
        made = []
        for channel, plane in enumerate(planes):
            points = Points(self._positions(channel, weight))
            if transposed:
                made.append(next(self.collect(channel, plane, [points], slopes=slopes)))
            else:
                made.append(self.spread(channel, [(plane, points)], slopes=slopes))
        if self.beyond is not None:
            light = planes if weight is None or transposed else [plane * weight for plane in planes]
            # Light beyond the windows is smooth and common to all points: it is added to the whole image.
            far = self.beyond.act(self, range(self.channels), light, slopes=slopes, transposed=transposed)
            for onto, more in zip(made, far, strict=True):
                onto += more if weight is None or not transposed else more * weight
        return made

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

        Each source is a plane of light, shape (height, width), and its points. `seen` is the number of layers that
        each pixel sees, a real number, by default all; `bank` replaces the bank of the channel by another of the same
        layout; `slopes` replaces windows by their derivatives with respect to position. Raises TypeError or
        ValueError if there is no such channel, or a plane is not of the dtype of the operator.
        """
        rows, columns, around = self._room(channel)
        if not isinstance(sources, Sequence):
            raise TypeError(f"sources must be a sequence of planes and points, got {validation.shown(sources)}")
        for plane, points in sources:
            self._require(plane, points)
        room = np.zeros([side + sum(more) for side, more in zip(self.shape, around, strict=True)], dtype=self.dtype)
        shown = self._shown(seen, around)
        used = bank or self.banks[channel]
        for plane, points in sources:
            for band, rim in self._bands(rows, used.half):
                where = points.positions, rows[band], columns
                limits = points.layers, None if shown is None else shown[rim]
                engine.spread(parts(used), where, plane, self.threads, room[rim], *limits, slopes)
                if self.watch is not None:
                    self.watch(int(np.count_nonzero(points.positions[rows[band]] >= 0.0)))
        if self.border == "reflect":  # light that leaves a mirrored image enters from the mirror
            return folded(folded(room, around[0][0], self.shape[0]).T, around[1][0], self.shape[1]).T
        (top, _), (left, _) = around
        return room[top:, left:][: self.shape[0], : self.shape[1]]

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
        """Yield the transpose of :meth:`spread` of a `plane`, for each of the `sources`.

        `channel`, `seen`, `bank` and `slopes` are those of :meth:`spread`.
        """
        rows, columns, around = self._room(channel)
        for points in sources:
            self._require(plane, points)
        room = np.pad(plane, around, mode="symmetric" if self.border == "reflect" else "constant")
        shown = self._shown(seen, around)
        for points in sources:
            taken = np.empty((rows.size, columns.size), dtype=self.dtype)
            where = points.positions, rows, columns
            engine.collect(
                parts(bank or self.banks[channel]), where, room, self.threads, taken, points.layers, shown, slopes
            )
            yield without_copies(taken, rows, columns, self.shape)

    def _require(self, plane: object, points: object) -> None:
        """Raise TypeError unless a plane has the shape and dtype of the operator."""
        validation.instance("points", points, Points)
        if not isinstance(plane, np.ndarray) or plane.shape != self.shape or plane.dtype != self.dtype:
            raise TypeError(
                f"plane must be an array of {self.dtype} of the shape {self.shape}, got {validation.shown(plane)}"
            )

    def _room(self, channel: int) -> tuple[NDArray[np.int64], NDArray[np.int64], list[tuple[int, int]]]:
        """Return the rows and columns of the image with copies of its edges, and the margins for their windows."""
        bank = self.banks[validation.integer("channel", channel, least=0, most=len(self.banks) - 1)]
        # A reflected edge is folded back afterwards; darkness needs no copies.
        margin = bank.half if self.border == "extend" else 0
        rows, columns = (copies(side, margin, self.border) for side in self.shape)
        return rows, columns, [(margin + more,) * 2 for more in bank.beyond]

    def _bands(self, rows: NDArray[np.int64], half: int) -> Iterator[tuple[slice, slice]]:
        """Yield bands of rows that are spread together (all unless `watch` is set), and the rows that they reach."""
        # Bands of at least eight windows: the overlap of neighbouring bands is computed twice.
        height = len(rows) if self.watch is None else max(_BAND // self.shape[1], 8 * half, 64)
        for first in range(0, len(rows), height):
            last = min(first + height, len(rows))
            yield slice(first, last), slice(first, last + 2 * half)

    def _shown(self, seen: Values | None, around: list[tuple[int, int]]) -> Values | None:
        """Return the layers seen by each pixel, with margins."""
        return (
            None if seen is None else np.pad(seen, around, mode="symmetric" if self.border == "reflect" else "edge")
        )

    def positions(self, channel: int) -> Array:
        """Return the position of each point in the bank of a `channel`; ValueError if there is no such channel."""
        channel = validation.integer("channel", channel, least=0, most=len(self.banks) - 1)
        placed = self._placed
        if placed is None or placed[0] is not self.defocus or placed[1] is not self.banks:
            known = {(b.start, b.spacing): np.maximum(b.positions(self.defocus), 0.0) for b in self.banks}
            each = tuple(known[bank.start, bank.spacing] for bank in self.banks)
            self._placed = placed = self.defocus, self.banks, each
        return placed[2][channel]

    def _positions(self, channel: int, weight: Values | None) -> Array:
        """Return positions as :meth:`positions`, negative for the points outside of `weight`."""
        positions = self.positions(channel)
        if weight is None:
            return positions
        given = validation.array("weight", weight)
        if not isinstance(weight, np.ndarray) or given.dtype != np.bool_ or given.shape != self.shape:
            got = f"{given.dtype} of the shape {given.shape}"
            raise TypeError(f"weight must be an array of bool of the shape {self.shape}, got {got}")
        return np.where(weight, positions, -1.0)


def parts(bank: Bank) -> tuple[Values, NDArray[np.int64], Array]:
    """Return windows, half widths and energies of a bank in the layout of the compiled core."""
    return bank.windows, bank.halves, bank.energies


def require_lens(lens: object, order: str) -> None:
    """Raise TypeError unless `lens` is one, saying in which `order` arguments are given."""
    if not isinstance(lens, Lens):
        raise TypeError(f"lens must be a Lens, got {type(lens).__name__}; the order is {order}")


def require_depth(depth: ArrayLike) -> Array:
    """Return depth as float64; raise TypeError or ValueError unless it is an image of metres above 0."""
    distances = validation.array("depth", depth)
    require_metres(distances.dtype)
    if distances.ndim != 2 or 0 in distances.shape:
        raise ValueError(f"depth must have the shape (height, width), got {distances.shape}")
    metres = distances.astype(np.float64, copy=False)
    if not np.all(metres > 0.0):
        if (unknown := np.isnan(metres)).any():
            count = int(unknown.sum())
            raise ValueError(f"depth is NaN at {count} of {metres.size} points; say what is there by `missing`")
        raise ValueError(f"depth must be > 0 metres, got {metres[~(metres > 0.0)].flat[0]}")
    return metres


def require_metres(kind: DType) -> None:
    """Raise TypeError unless depth is in floats: the scale of integer levels is known to their author only."""
    if kind.kind != "f":
        raise TypeError(
            f"depth must hold metres in floats, got {kind}; for levels of a millimetre give 0.001 * depth"
        )


_IN_FOCUS = 2.0  # pixels, the largest blur that `lommel info` calls sharp


def tell_of_depths(lens: Lens, pixel: float, depth: ArrayLike) -> None:
    """Warn if all finite distances are implausible as metres for this lens."""
    distances = np.asarray(depth, dtype=np.float64)
    low, high = (float(end(distances, initial=other)) for end, other in ((np.min, math.inf), (np.max, 0.0)))
    # Hyperfocal distance f (1 + D / c), c the circle of confusion.
    hyperfocal = lens.focal_length * (1.0 + lens.aperture_diameter / (_IN_FOCUS * pixel))
    if hyperfocal < low < math.inf:
        where = f"beyond the hyperfocal distance, {format_length(hyperfocal)}, where blur hardly depends on it"
    elif high < lens.focal_length:
        where = f"within the focal length, {format_length(lens.focal_length)}"
    else:
        return
    ends = " to ".join(format_length(end) for end in dict.fromkeys((low, high)))
    validation.tell(f"all of the depth, {ends}, is {where}: is it in metres?")


_ROUNDING = 32.0  # units of rounding of a sum in single precision; measured: 9
_LARGE = 2**16  # pixels from which starting threads pays


class Beyond:
    """Remainders of all channels of a blur (a little light from every point on every pixel), with the transpose."""

    def __init__(self, remainders: Sequence[Remainder], tol: float) -> None:
        self._remainders, self._tol = remainders, tol
        self._kernels: dict[tuple[Remainder, tuple[int, int], str], MirroredKernels] = {}
        self._factors: dict[Remainder, tuple[Array, Values]] = {}

    def error(self, blur: DepthBlur) -> float:
        """Return the sum over pixels of the largest error of K, of any channel, for this scene."""
        # With darkness around, light comes from no farther than the size of the image.
        shape = blur.shape if blur.border == "zero" else None
        found = max(
            remainder.error(blur.positions(channel), shape) + self._kernels_of(blur, channel).error
            for channel, remainder in enumerate(self._remainders)
        )
        return found + self.rounding(blur.dtype)

    @staticmethod
    def rounding(dtype: np.dtype[np.floating]) -> float:
        """Return the rounding error of sums of this type, over the brightest point."""
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
        """Return the light beyond the windows of planes of these channels, as :meth:`DepthBlur.act`."""
        threads = (blur.threads or os.cpu_count() or 1) if math.prod(blur.shape) >= _LARGE else 1
        kernels = [self._kernels_of(blur, channel) for channel in channels]
        factors = [self._factors_of(blur, channel, slopes) for channel in channels]
        if transposed:
            given = [each.known(plane, threads) for each, plane in zip(kernels, planes, strict=True)]
        else:
            given = [np.ascontiguousarray(plane) for plane in planes]

        def part(at: tuple[int, int]) -> Values:
            index, r = at
            if transposed:
                return np.asarray(kernels[index].taken(r, given[index]) * factors[index][r])
            return kernels[index].transformed(r, factors[index][r] * given[index])

        each = [(index, r) for index, found in enumerate(factors) for r in range(len(found))]
        sums: list[Values] = []
        for (_, r), found in zip(each, side_by_side(part, each, threads), strict=True):
            if r == 0:
                sums.append(found)
            else:
                sums[-1] += found
        return sums if transposed else [each.image(total, threads) for each, total in zip(kernels, sums, strict=True)]

    def _kernels_of(self, blur: DepthBlur, channel: int) -> MirroredKernels:
        """Return the kernels of a channel for images of this shape and border; kept."""
        remainder = self._remainders[channel]
        key = (remainder, blur.shape, blur.border)
        if key not in self._kernels:
            self._kernels[key] = MirroredKernels(remainder, blur.shape, blur.border, blur.dtype, self._tol)
        return self._kernels[key]

    def _factors_of(self, blur: DepthBlur, channel: int, slopes: bool) -> Values:
        """Return the a_r of all points, kept for the depth of the last call, or their derivatives, which are not."""
        remainder, positions = self._remainders[channel], blur.positions(channel)
        if slopes:
            return remainder.factors(positions, blur.dtype, slopes=True, threads=blur.threads)
        last = self._factors.get(remainder)
        if last is None or last[0] is not positions:
            last = self._factors[remainder] = (
                positions,
                remainder.factors(positions, blur.dtype, threads=blur.threads),
            )
        return last[1]


# Differences of fourth order: over steps of so much of C_d, of which phases turn by twice as much, and of the scale.
_DIFFERENCES = ((-2.0, 1.0 / 12.0), (-1.0, -2.0 / 3.0), (1.0, 2.0 / 3.0), (2.0, -1.0 / 12.0))
_STEP_OF_DEFOCUS, _STEP_OF_SCALE = 0.03, 1e-3


# Where a point moves by delta, its light x moves by x delta dC_d/dz dK/dC_d (chain rule). K is a mixture of four
# windows by cubic weights, and its derivative one of the same four by the derivatives of the weights. Of
# C_d = k (1/d - 1/f + 1/z), k = pi R^2 / (2 lambda), the derivative is -k / z^2 by the distance z of a point, and
# -k / d^2 by the distance d of the sensor, for all points; but the sensor also scales all windows in proportion to d.
class BlurSlopes:
    """Derivatives of ``blur.forward(image)`` with respect to the depth of every point and to the focus.

    A linear operator from changes of depth to changes of the photograph, with its exact transpose; each costs about
    as much as the blur. Derivatives are those of the interpolated windows: their error is about `tol` of the peak per
    radian of C_d, and more where windows are far apart.

    Parameters
    ----------
    image : ndarray of float
        The scene, linear light, of the shape that :meth:`lommel.imaging.DepthBlur.forward` takes.
    blur : DepthBlur
        Placed at the depths of the derivatives; must not be placed elsewhere afterwards.

    Raises
    ------
    TypeError, ValueError
        If `blur` is not a DepthBlur, or as :meth:`lommel.imaging.DepthBlur.forward`.

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
        # 0 at an infinite distance.
        self._per_metre = -((blur.defocus - infinite) ** 2) / (float(lens.defocus(1.0)) - infinite)

    def forward(self, change: Values) -> Values:
        """Return the first-order change of the photograph with a `change` of depth (metres); or ValueError."""
        metres = validation.real_array("change", change)
        if metres.shape != self.shape:
            raise ValueError(f"change must have the shape of the depth, {self.shape}, got {metres.shape}")
        radians = metres * self._per_metre
        moved = [plane * self._steps(channel, radians) for channel, plane in enumerate(self._planes)]
        return np.stack(self._blur.act(moved, slopes=True), axis=-1).reshape(self._shape)

    def adjoint(self, image: Values) -> Values:
        """Return the gradient, per metre of depth, of the sum of `image` times the photograph."""
        taken = self._blur.act(self._blur.planes(image), slopes=True, transposed=True)
        total = np.zeros(self.shape, dtype=self._blur.dtype)
        for channel, plane in enumerate(self._planes):
            total += taken[channel] * plane * self._steps(channel, self._per_metre)
        return total

    def focus(self) -> Values:
        """Return the derivative of the photograph with respect to the sensor distance, light per metre.

        The aperture keeps its diameter. The derivative with respect to the focus distance is ``-(d / s)**2`` times
        this, d being ``lens.sensor_distance`` and s ``lens.focus_distance``. Raises ValueError for ``energy=1``.
        """
        blur = self._blur
        if blur.beyond is not None:
            raise ValueError("energy must be below 1 for the derivative by focus, such as 0.9999, got 1")
        moved = copy.copy(blur)
        distinct = dict(zip(blur.banks, blur.spectra, strict=True))
        slopes = {bank: _by_sensor(blur, bank, spectrum) for bank, spectrum in distinct.items()}
        moved.banks = tuple(slopes[bank] for bank in blur.banks)
        return np.stack(moved.act(self._planes), axis=-1).reshape(self._shape) / blur.lens.sensor_distance

    def as_linear_operator(self) -> LinearOperator:
        """Return the operator for SciPy's solvers, from depths in metres to values of the photograph, as vectors."""
        return linear_operator(self.forward, self.adjoint, self._shape, self.shape, self._blur.dtype)

    def _steps(self, channel: int, radians: Array) -> Values:
        """Return changes of C_d as changes of positions in a bank."""
        return (radians / self._blur.banks[channel].spacing).astype(self._blur.dtype)


def _by_sensor(blur: DepthBlur, bank: Bank, spectrum: tuple[tuple[float, float], ...]) -> Bank:
    """Return a bank of the derivatives of windows by ln d, of points that stay where they are while the sensor moves.

    By differences of windows as they are cut and divided, which are smooth in d but for bends of the cuts.
    """
    lens, infinite = blur.lens, float(blur.lens.defocus(math.inf))
    defocus = bank.start + bank.spacing * np.arange(bank.count, dtype=np.float64)
    rate = (float(lens.defocus(1.0)) - infinite) / lens.sensor_distance
    step = min(_STEP_OF_SCALE, _STEP_OF_DEFOCUS / rate)
    made = []
    for steps, weight in _DIFFERENCES:
        there = replace(lens, sensor_distance=lens.sensor_distance * (1.0 + steps * step))
        light = SensorLight.of(there, spectrum, blur.pixel, blur.threads)
        pupils = light.defocused(defocus + (float(there.defocus(math.inf)) - infinite))
        octants = light.shares(pupils, bank.half + 2)
        quarter = cut(octants, find_cuts(octants, bank.half + 2, blur.energy))
        made.append(weight / step * quarter / sums_of_quarters(quarter)[:, None, None])
    widest = max(quarter.shape[1] for quarter in made)
    sums = sum(np.pad(quarter, ((0, 0), *[(0, widest - quarter.shape[1])] * 2)) for quarter in made)
    whole, ones = np.full(bank.count, widest - 1.0), np.ones(bank.count)
    return replace(bank, windows=stored_windows(np.asarray(sums), blur.dtype), cuts=whole, energies=ones)
