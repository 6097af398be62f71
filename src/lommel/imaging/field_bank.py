"""Windows of PSFs at nodes over the field and over defocus, close enough for splines between them."""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from lommel.base.arrays import Array, Values
from lommel.base.cached import cached_property
from lommel.field.maps import FieldMap
from lommel.imaging.sensor_light import too_large
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import psf

_BEYOND = 2.5  # times the window: as far the far light is known pixel by pixel, at least
_ELSEWHERE = 1.2  # times what is off at places that were looked at, for those that were not


@dataclass(frozen=True)
class FarLight:
    """The light that points spread beyond their windows, all alike but for its share."""

    kernel: Array  # the mean over the field; 0 where the window is, of the sum 1
    half: int  # pixels from the middle of the windows to their edges
    error: float  # largest sum of absolute differences to the light of points, with room for points not looked at
    lost: float  # largest share of light beyond the kernel, which is within it instead

    @property
    def reach(self) -> int:
        """Pixels from the middle of the kernel to its edge."""
        return len(self.kernel) // 2


def far_light(light: PointLight, spans: Sequence[Span], tol: float, largest: int, farthest: int) -> FarLight:
    """Return the smallest windows beyond which all points spread their light alike to `tol`, and that light."""
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
    # The smaller the window, the more there is to be off.
    half = 1 + bisect_left(range(1, half), True, key=lambda smaller: _off(windows, smaller) <= tol)
    error, tails = _off(windows, half), windows.copy()
    tails[:, reach - half : reach + half + 1, reach - half : reach + half + 1] = 0.0
    beyond = 1.0 - windows.sum(axis=(1, 2))
    # The share beyond a square falls as one over its side, which that of one over r^3 does.
    enough = int(np.ceil(4.0 * float(beyond.max()) / tol * (reach + 0.5)))
    side = max(reach, min(farthest, enough))
    kernel = np.pad(tails.sum(axis=0), side - reach)
    if side > reach:
        away = np.arange(-side, side + 1.0)
        ring = np.hypot(away[:, None], away)
        ring[side - reach : side + reach + 1, side - reach : side + reach + 1] = np.inf
        ring = ring**-3.0
        kernel += ring * (float(beyond.sum()) * (1.0 - (reach + 0.5) / (side + 0.5)) / ring.sum())
    lost = float(beyond.max()) * (reach + 0.5) / (side + 0.5)
    return FarLight(kernel / kernel.sum(), half, error, lost)


def _off(windows: Array, half: int) -> float:
    """Return the largest sum of absolute differences between tails and their mean, scaled, with room for others."""
    reach = windows.shape[-1] // 2
    inner = slice(reach - half, reach + half + 1)
    outside = np.ones(windows.shape[1:], dtype=np.bool_)
    outside[inner, inner] = False
    tails: Values = windows[:, outside]
    bright = tails.sum(axis=1)
    mean = tails.sum(axis=0) / bright.sum()
    return _ELSEWHERE * float(np.abs(tails - bright[:, None] * mean).sum(axis=1).max())


_MAX_VALUES = 2**27  # of a bank, 1 GiB in double precision
_CHECKED = 1500  # places half-way between nodes that are looked at, where there are more
_FINE = 3e-4  # tolerances below which splines of degree 5 are quicker than cubic ones
_SHARES = (0.9, 1.2, 1.4)  # of the tolerance that one, two, three axes have together: they err at different places
_FAR = 0.4  # of the tolerance for the light beyond the windows, where that counts


@dataclass(frozen=True)
class FieldBank:
    """Windows of one channel: what a point spreads, at any place in the field, at any defocus.

    Attributes
    ----------
    axes : tuple of three Nodes
        Along y and x in the field, and along defocus (radians at the wavelength of the map).
    coefficients : ndarray, shape (y, x, defocus, side, side)
        Of splines along these axes. Every window that they make has the sum 1, or what the far light leaves of it.
    far : FarLight or None
        What holds the light beyond the windows of the whole PSF.
    lost : float
        Largest share of light beyond these that was found, spread over them instead.
    error : float
        Largest sum of absolute differences between what points spread and exact PSFs, but for this, from what was
        found half-way between nodes.
    """

    axes: tuple[Nodes, ...]
    coefficients: Values
    far: FarLight | None
    lost: float
    error: float

    @property
    def half(self) -> int:
        """Pixels from the middle of a window to its edge."""
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
        middle = self.far.reach - self.half
        whole = np.asarray((1.0 - made.sum()) * self.far.kernel)
        whole[middle : middle + len(made), middle : middle + len(made)] += made
        return whole


def build_field_bank(
    light: PointLight,
    spans: Sequence[Span],
    *,
    tol: float,
    energy: float,
    largest: int,
    farthest: int,
    dtype: np.dtype[np.floating],
) -> FieldBank:
    """Return the bank of one channel; ValueError if windows exceed `largest`, or the bank 2^27 values."""
    half, core = light.enough(spans, CORE if energy == 1.0 else energy, largest)
    far = far_light(light, spans, _FAR * tol, largest, farthest) if energy == 1.0 else None
    room = tol
    if far is not None:
        half, room = far.half, tol - far.error
    axes, before = _axes(light, spans, min(core, half), room), math.inf
    if all(nodes.count == 1 for nodes in axes):
        before = 0.0
    while True:
        side = 2 * half + 1
        if math.prod(nodes.count for nodes in axes) * side * side > _MAX_VALUES:
            counts = " x ".join(str(nodes.count) for nodes in axes)
            raise ValueError(
                f"a bank of {counts} windows (down, across, over defocus) of {side} x {side} pixels exceeds the "
                f"limit of {_MAX_VALUES} values; ask for a larger tol than {tol:g}, for less light (energy=), or for "
                "parts of the image, by center="
            )
        windows = light.windows(lattice([nodes.places for nodes in axes]), half)
        held = windows.sum(axis=(1, 2))
        if far is None and held.min() < energy:  # between the places that were looked at
            if half == largest:
                raise light.too_large(lattice([nodes.places for nodes in axes]), energy, largest, held)
            half = min(largest, math.ceil(1.05 * half) + 1)
            continue
        if far is None:
            windows /= held[:, None, None]
        coefficients: Values = windows.reshape(*(nodes.count for nodes in axes), side, side)
        for axis, nodes in enumerate(axes):
            coefficients = nodes.coefficients(coefficients, axis)
        places = lattice(
            [nodes.between if nodes.count > 1 else np.unique([nodes.first, nodes.last]) for nodes in axes]
        )
        if len(places) > _CHECKED:
            places = places[np.random.default_rng(0).choice(len(places), _CHECKED, replace=False)]
        exact = light.windows(places, half)
        between = exact.sum(axis=(1, 2))
        if far is None:
            exact /= between[:, None, None]
        error = UNEVEN * max(  # what a window holds too much, the far light lacks
            off(made, one) + abs(float((made - one).sum()))
            for made, one in zip(_mixed(axes, coefficients, places), exact, strict=True)
        )
        if error <= room:
            lost = 1.0 - float(min(held.min(), between.min())) if far is None else far.lost
            return FieldBank(axes, coefficients.astype(dtype), far, lost, error + tol - room)
        degree = axes[0].degree
        times = max(1.02, (error / (0.9 * room)) ** (1.0 / (degree + 1)))
        # Where nodes that are closer do not help, axes of a single one may need more.
        single, before = error > 0.9 * before, error
        axes = tuple(
            nodes.finer(times) if nodes.first < nodes.last and (single or nodes.count > 1) else nodes
            for nodes in axes
        )


def _axes(light: PointLight, spans: Sequence[Span], half: int, tol: float) -> tuple[Nodes, ...]:
    """Return nodes that are close enough along lines through the spans."""
    # Fewer nodes, of which more count at each place: worth it where there are many.
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
    """Yield the windows that splines make at places, shape (n, 3)."""
    weights = [nodes.weights(along) for nodes, along in zip(axes, places.T, strict=True)]
    for shares in zip(*weights, strict=True):
        used = [np.flatnonzero(share) for share in shares]
        found: Values = coefficients[np.ix_(*used)]
        for share, these in zip(shares, used, strict=True):
            found = np.tensordot(share[these], found, axes=(0, 0))
        yield found.astype(np.float64, copy=False)


CORE = 0.9  # share of the light whose changes decide how close nodes must be

_AT_ONCE = 2**24  # values that are computed at once

Spectrum = Sequence[tuple[float, float]]
Span = tuple[float, float]


@dataclass(frozen=True)
class PointLight:
    """The pixel-integrated PSF of a point anywhere in the field of a lens, at any defocus."""

    field_map: FieldMap
    phase: Callable[[Array], Wavefront] | None
    spectrum: Spectrum | None
    pixel: float  # in the unit of the map
    tol: float  # of each PSF, over its peak
    threads: int | None

    def pupil(self, y: Array, x: Array, defocus: Array) -> Pupil:
        """Return the stack of pupils at places in the field and values of the defocus, arrays of one shape."""
        pupil = self.field_map.pupil(x, y)
        return pupil if self.phase is None else pupil.carrying(pupil.wavefront + self.phase(defocus), None)

    def windows(self, places: Array, half: int) -> Array:
        """Return the share of light in each pixel of windows (n, side, side) of points at y, x and C_d (n, 3)."""
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

UNEVEN = 1.2  # a spline errs most half-way between nodes, or, near the ends, by at most so much more elsewhere

# Distances near the ends over those elsewhere, by the degree: splines err by five times as much there without.
_ENDS = {3: (0.5, 0.8), 5: (0.35, 0.6, 0.8)}


@dataclass(frozen=True)
class Nodes:
    """Places along an axis, closer at its ends, and the not-a-knot splines through values at them."""

    first: float
    last: float
    count: int
    degree: int = 3

    @property
    def places(self) -> Array:
        """Where the nodes are, shape (count,)."""
        return np.asarray(self.first + (self.last - self.first) * self._along)

    @property
    def between(self) -> Array:
        """The places half-way, shape (count - 1,)."""
        return np.asarray(0.5 * (self.places[1:] + self.places[:-1]))

    @cached_property
    def _along(self) -> Array:
        """Where the nodes are, from 0 to 1."""
        cells, closer = np.ones(max(0, self.count - 1)), _ENDS[self.degree]
        if len(cells) > 2 * len(closer):
            cells[: len(closer)] = closer
            cells[-len(closer) :] = closer[::-1]
        ends = np.concatenate([[0.0], np.cumsum(cells)])
        return np.asarray(ends / max(1.0, ends[-1]))

    @cached_property
    def _spline(self) -> Any:
        """Splines that are 1 at one node and 0 at all others."""
        from scipy.interpolate import make_interp_spline

        return make_interp_spline(self._along, np.eye(self.count), k=min(self.degree, self.count - 1))

    def coefficients(self, values: Values, axis: int) -> Values:
        """Return the coefficients of splines from values at the nodes, which lie along `axis`."""
        if self.count == 1:
            return values
        return np.moveaxis(np.tensordot(self._spline.c, values, axes=(1, axis)), 0, axis)

    def weights(self, places: Array) -> Array:
        """Return the weight of each coefficient at places (n,), shape (n, count); beyond the ends that there."""
        return np.ones((len(places), 1)) if self.count == 1 else np.asarray(self._matrix(places).toarray())

    def shares(self, places: Array) -> list[tuple[int, Array]]:
        """Return the columns of :meth:`weights` that are not 0, each with its number, as places; of one node 1."""
        if self.count == 1:
            return [(0, np.ones(()))]
        matrix, found = self._matrix(places.ravel()).tocsc(), []
        for node in range(self.count):
            part = slice(matrix.indptr[node], matrix.indptr[node + 1])
            if part.stop > part.start:
                column = np.zeros(places.size)
                column[matrix.indices[part]] = matrix.data[part]
                found.append((node, column.reshape(places.shape)))
        return found

    def _matrix(self, places: Array) -> Any:
        from scipy.interpolate import BSpline

        along = np.clip((places - self.first) / (self.last - self.first), 0.0, 1.0)
        return BSpline.design_matrix(along, self._spline.t, self._spline.k)

    def finer(self, times: float) -> Nodes:
        """Return nodes whose distances are so many times smaller, and at least one more of them."""
        cells = max(1, self.count - 1)
        return replace(self, count=max(self.count, math.ceil(cells * times)) + 1)


def off(one: Values, other: Values) -> float:
    """Return the largest sum of absolute differences of windows."""
    return float(np.abs(one - other).sum(axis=(-2, -1)).max(initial=0.0))


def enough(sample: Callable[[Array], Array], first: float, last: float, tol: float, degree: int = 3) -> Nodes | None:
    """Return nodes whose splines err by no more than `tol` on ``sample(places)``, or None if it takes too many."""
    if first == last:
        return Nodes(first, first, 1, degree)
    nodes = Nodes(first, last, 3, degree)
    known = sample(nodes.places)
    if off(known, known[:, :1]) <= tol:
        return replace(nodes, count=1)

    def over(nodes: Nodes) -> float:
        """Return how far from close enough nodes are, over their distance."""
        made = interpolated(nodes, sample(nodes.places), nodes.between)
        # The error falls by 2^(degree + 1) where nodes are twice as close.
        return float((UNEVEN * off(made, sample(nodes.between)) / tol) ** (1.0 / (degree + 1)))

    while (ratio := over(nodes)) > 1.0:
        nodes = replace(nodes, count=2 * nodes.count - 1)
        if nodes.count > MOST:
            return None
    # They need not be closer than enough.
    fewer = replace(nodes, count=math.ceil((nodes.count - 1) * max(0.5, ratio)) + 1)
    while fewer.count < nodes.count and (ratio := over(fewer)) > 1.0:
        fewer = replace(fewer, count=max(fewer.count + 1, math.ceil((fewer.count - 1) * ratio) + 1))
    return fewer if fewer.count < nodes.count else nodes


def interpolated(nodes: Nodes, values: Values, places: Array) -> Array:
    """Return splines through values along the second axis, evaluated at places."""
    made = np.tensordot(nodes.weights(places), nodes.coefficients(values, 1), axes=(1, 1))
    return np.moveaxis(made, 0, 1)
