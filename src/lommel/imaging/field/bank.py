"""Windows of PSFs at nodes over the field and over defocus, close enough to interpolate what lies between."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.imaging.field.light import CORE, PointLight, Span, lattice, overview, too_large
from lommel.imaging.field.nodes import MOST, UNEVEN, Nodes, enough, off

_BEYOND = 2.5  # times the window: as far the far light is known pixel by pixel, at least
_ELSEWHERE = 1.2  # times what is off at places that were looked at, for those that were not


@dataclass(frozen=True)
class FarLight:
    """What a point spreads beyond its window, but for how much of its light that is.

    Attributes
    ----------
    kernel : ndarray, shape (side, side)
        The mean over the field; 0 where the window is, of the sum 1.
    half : int
        Pixels from the middle of the windows to their edges.
    error : float
        Largest sum of absolute differences to the light that points spread there, with some room for points that were
        not looked at.
    lost : float
        Largest share of light beyond the kernel, which is within it instead.
    """

    kernel: NDArray[np.float64]
    half: int
    error: float
    lost: float

    @property
    def reach(self) -> int:
        """Pixels from the middle of the kernel to its edge."""
        return len(self.kernel) // 2


def far_light(light: PointLight, spans: Sequence[Span], tol: float, largest: int, farthest: int) -> FarLight:
    """Find the least windows beyond which all points spread their light alike.

    Parameters
    ----------
    light : PointLight
    spans : sequence of three (float, float)
        Ranges of y, x and defocus.
    tol : float
        Bound on the sum of absolute differences.
    largest : int
        Largest half width of windows, pixels.
    farthest : int
        Pixels that the kernel reaches, if it must.

    Returns
    -------
    FarLight

    Raises
    ------
    ValueError
        If it takes larger windows.
    """
    places = overview(spans)
    half = 8
    while True:
        half = min(half, largest)
        reach = int(np.ceil(_BEYOND * half))
        windows = light.windows(places, reach)
        found = _least(windows, half, tol)
        if found is not None:
            break
        if half == largest:
            raise ValueError(
                f"light farther than {largest} pixels from its point is not alike to {tol:.2g} all over the field; "
                f"allow larger windows than largest={largest}, ask for a larger tol, or for less light (energy=)"
            )
        half *= 2
    least, error = found
    tails = windows.copy()
    tails[:, reach - least : reach + least + 1, reach - least : reach + least + 1] = 0.0
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
    return FarLight(kernel / kernel.sum(), least, _ELSEWHERE * error, lost)


def _least(windows: NDArray[np.float64], most: int, tol: float) -> tuple[int, float] | None:
    """Return half of the least windows beyond which the light of all points is alike, and how far it is not."""
    low, high, known = 0, most, _off(windows, most)
    if _ELSEWHERE * known > tol:
        return None
    while high - low > 1:  # The smaller the window, the more there is to be off.
        half = (low + high) // 2
        error = _off(windows, half)
        if _ELSEWHERE * error <= tol:
            high, known = half, error
        else:
            low = half
    return high, known


def _off(windows: NDArray[np.float64], half: int) -> float:
    """Return the largest sum of absolute differences between tails and the mean, made as bright."""
    reach = windows.shape[-1] // 2
    inner = slice(reach - half, reach + half + 1)
    outside = np.ones(windows.shape[1:], dtype=np.bool_)
    outside[inner, inner] = False
    tails: NDArray[Any] = windows[:, outside]
    bright = tails.sum(axis=1)
    mean = tails.sum(axis=0) / bright.sum()
    return float(np.abs(tails - bright[:, None] * mean).sum(axis=1).max())


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

    axes: tuple[Nodes, Nodes, Nodes]
    coefficients: NDArray[Any]
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

    def window(self, y: float, x: float, defocus: float = 0.0) -> NDArray[np.float64]:
        """Return what one point spreads.

        Parameters
        ----------
        y, x : float
            Place in the field.
        defocus : float, default 0
            C_d, radians.

        Returns
        -------
        ndarray, shape (side, side)
        """
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
    dtype: np.dtype[Any],
) -> FieldBank:
    """Compute the bank of one channel.

    Parameters
    ----------
    light : PointLight
    spans : sequence of three (float, float)
        Ranges of y, x and defocus.
    tol : float
        Nodes are put closer together until interpolated windows err by less, by the sum of absolute differences.
    energy : float
        Share of light that windows must hold; 1 for the whole PSF, with what is beyond them.
    largest : int
        Largest half width allowed, pixels.
    farthest : int
        How far from a point its light counts, pixels, of the whole PSF.
    dtype : dtype
        Of the coefficients.

    Returns
    -------
    FieldBank

    Raises
    ------
    ValueError
        If windows would exceed `largest`, or if the bank would hold more than 2^27 values.
    """
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
            raise _too_many(axes, side, tol)
        windows = light.windows(lattice([nodes.places for nodes in axes]), half)
        held = windows.sum(axis=(1, 2))
        if far is None and held.min() < energy:  # between the places that were looked at
            if half == largest:
                raise too_large(largest, energy)
            half = min(largest, math.ceil(1.05 * half) + 1)
            continue
        if far is None:
            windows /= held[:, None, None]
        coefficients = windows.reshape(*(nodes.count for nodes in axes), side, side)
        for axis, nodes in enumerate(axes):
            coefficients = nodes.coefficients(coefficients, axis)
        places = _half_way(axes)
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
        y, x, defocus = (
            nodes.finer(times) if nodes.first < nodes.last and (single or nodes.count > 1) else nodes
            for nodes in axes
        )
        axes = y, x, defocus


def _too_many(axes: Sequence[Nodes], side: int, tol: float) -> ValueError:
    counts = " x ".join(str(nodes.count) for nodes in axes)
    return ValueError(
        f"a bank of {counts} windows (down, across, over defocus) of {side} x {side} pixels exceeds the limit of "
        f"{_MAX_VALUES} values; ask for a larger tol than {tol:g}, for less light (energy=), or for parts of the "
        "image, by center="
    )


def _axes(light: PointLight, spans: Sequence[Span], half: int, tol: float) -> tuple[Nodes, Nodes, Nodes]:
    """Return nodes that are close enough along lines through the spans."""
    # Fewer nodes, of which more count at each place: worth it where there are many.
    degree = 5 if tol < _FINE or spans[2][0] < spans[2][1] else 3
    many = max(1, sum(first != last for first, last in spans))
    share = _SHARES[many - 1] * tol / many
    found = []
    for axis, span in enumerate(spans):
        others = [np.unique(np.linspace(*other, 3)) for other in spans]

        def sample(
            along: NDArray[np.float64], axis: int = axis, others: list[NDArray[np.float64]] = others
        ) -> NDArray[np.float64]:
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
    y, x, defocus = found
    return y, x, defocus


def _half_way(axes: Sequence[Nodes]) -> NDArray[np.float64]:
    """Return the middles between nodes, shape (n, 3), some of them if they are many."""
    ticks = [nodes.between if nodes.count > 1 else np.unique([nodes.first, nodes.last]) for nodes in axes]
    places = lattice(ticks)
    if len(places) <= _CHECKED:
        return places
    return places[np.random.default_rng(0).choice(len(places), _CHECKED, replace=False)]


def _mixed(
    axes: Sequence[Nodes], coefficients: NDArray[Any], places: NDArray[np.float64]
) -> Iterator[NDArray[np.float64]]:
    """Yield the windows that splines make at places, shape (n, 3)."""
    weights = [nodes.weights(along) for nodes, along in zip(axes, places.T, strict=True)]
    for shares in zip(*weights, strict=True):
        used = [np.flatnonzero(share) for share in shares]
        found: NDArray[Any] = coefficients[np.ix_(*used)]
        for share, these in zip(shares, used, strict=True):
            found = np.tensordot(share[these], found, axes=(0, 0))
        yield found.astype(np.float64, copy=False)
