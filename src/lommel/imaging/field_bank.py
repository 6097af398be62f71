"""Windows of PSFs at nodes over the field and over defocus, close enough to interpolate what lies between."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.field.maps import FieldMap
from lommel.imaging.nodes import MOST, UNEVEN, Nodes, enough, off
from lommel.optics.pupil import Pupil
from lommel.optics.spectrum import in_light
from lommel.optics.wavefront import Wavefront
from lommel.psf import psf

_MAX_VALUES = 2**27  # of a bank, 1 GiB in double precision
_AT_ONCE = 2**24  # values that are computed at once
_CHECKED = 1500  # places half-way between nodes that are looked at, where there are more
_FINE = 3e-4  # tolerances below which splines of degree 5 are quicker than cubic ones
_CORE = 0.9  # of the light, which tells how close nodes must be
_SHARE = 0.85  # of the tolerance that the axes share: their errors add up to no more than they promise

Spectrum = Sequence[tuple[float, float]]
Span = tuple[float, float]


@dataclass(frozen=True)
class PointLight:
    """The light of a point on the pixels of a sensor, anywhere in the field, at any defocus.

    Attributes
    ----------
    field_map : FieldMap
    phase : callable, optional
        Makes wavefronts of defocus, as :meth:`lommel.Lens.phase`.
    spectrum : sequence of (wavelength, weight), optional
        Metres; weights sum to 1. By default the wavelength of the map.
    pixel : float
        In the unit of the map.
    tol : float
        Of each PSF, over its peak.
    threads : int, optional
    """

    field_map: FieldMap
    phase: Callable[[NDArray[np.float64]], Wavefront] | None
    spectrum: Spectrum | None
    pixel: float
    tol: float
    threads: int | None

    def pupil(self, y: NDArray[np.float64], x: NDArray[np.float64], defocus: NDArray[np.float64]) -> Pupil:
        """Return what some places see at a defocus each, arrays of one shape: a stack."""
        pupil = self.field_map.pupil(x, y)
        return pupil if self.phase is None else pupil.carrying(pupil.wavefront + self.phase(defocus), None)

    def windows(self, places: NDArray[np.float64], half: int) -> NDArray[np.float64]:
        """Return the share of light in each pixel of windows of points.

        Parameters
        ----------
        places : ndarray, shape (n, 3)
            y and x in the field, and the defocus C_d, radians.
        half : int
            Pixels from the middle of a window to its edge.

        Returns
        -------
        ndarray, shape (n, 2 half + 1, 2 half + 1)
        """
        side = 2 * half + 1
        out = np.zeros((len(places), side, side))
        step = max(1, _AT_ONCE // side**2)
        for first in range(0, len(places), step):
            part = slice(first, first + step)
            pupil = self.pupil(*places[part].T)
            for wavelength, weight in self.spectrum or ((None, 1.0),):
                light = pupil if wavelength is None else in_light(pupil, wavelength)
                given: dict[str, Any] = {"integrate": True, "dtype": np.float64, "threads": self.threads}
                out[part] += weight * psf(light, side, self.pixel, tol=self.tol, **given).values
        return out

    def enough(self, spans: Sequence[Span], energy: float, largest: int) -> tuple[int, int]:
        """Return half of a window that holds `energy` of the light at places all over the spans, and of its core."""
        places = _lattice([np.linspace(*span, 5 if axis < 2 else 3) for axis, span in enumerate(spans)])
        half = math.ceil(float(self.pupil(*places.T).geometric_radius().max()) / self.pixel) + 1
        while True:
            half = min(half, largest)
            windows = self.windows(places, half)
            if windows.sum(axis=(1, 2)).min() >= energy:
                return _least(windows, energy), _least(windows, min(energy, _CORE))
            if half == largest:
                raise too_large(largest, energy)
            half = math.ceil(1.3 * half) + 1


@dataclass(frozen=True)
class FieldBank:
    """Windows of one channel: what a point spreads, at any place in the field, at any defocus.

    Attributes
    ----------
    axes : tuple of three Nodes
        Along y and x in the field, and along defocus (radians at the wavelength of the map).
    coefficients : ndarray, shape (y, x, defocus, side, side)
        Of splines along these axes. Every window that they make has the sum 1.
    lost : float
        Largest share of light beyond the windows that was found, spread over these instead.
    error : float
        Largest sum of absolute differences between interpolated windows and exact ones, from what was found half-way
        between nodes.
    """

    axes: tuple[Nodes, Nodes, Nodes]
    coefficients: NDArray[Any]
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
        """Return the window of one point.

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
        return next(_mixed(self.axes, self.coefficients, np.array([[y, x, defocus]])))


def build_field_bank(
    light: PointLight, spans: Sequence[Span], *, tol: float, energy: float, largest: int, dtype: np.dtype[Any]
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
        Share of light that windows must hold.
    largest : int
        Largest half width allowed, pixels.
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
    half, core = light.enough(spans, energy, largest)
    axes, before = _axes(light, spans, core, tol), math.inf
    if all(nodes.count == 1 for nodes in axes):
        before = 0.0
    while True:
        side = 2 * half + 1
        if math.prod(nodes.count for nodes in axes) * side * side > _MAX_VALUES:
            raise _too_many(axes, side, tol)
        windows = light.windows(_lattice([nodes.places for nodes in axes]), half)
        held = windows.sum(axis=(1, 2))
        if held.min() < energy:  # between the places that were looked at
            if half == largest:
                raise too_large(largest, energy)
            half = min(largest, math.ceil(1.05 * half) + 1)
            continue
        coefficients = (windows / held[:, None, None]).reshape(*(nodes.count for nodes in axes), side, side)
        for axis, nodes in enumerate(axes):
            coefficients = nodes.coefficients(coefficients, axis)
        places = _half_way(axes)
        exact = light.windows(places, half)
        between = exact.sum(axis=(1, 2))
        exact /= between[:, None, None]
        error = UNEVEN * max(
            off(made, one) for made, one in zip(_mixed(axes, coefficients, places), exact, strict=True)
        )
        if error <= tol:
            lost = 1.0 - float(min(held.min(), between.min()))
            return FieldBank(axes, coefficients.astype(dtype), lost, error)
        times = max(1.05, (error / (_SHARE * tol)) ** (1.0 / (axes[0].degree + 1)))
        # Where nodes that are closer do not help, axes of a single one may need more.
        single, before = error > 0.9 * before, error
        y, x, defocus = (
            nodes.finer(times) if nodes.first < nodes.last and (single or nodes.count > 1) else nodes
            for nodes in axes
        )
        axes = y, x, defocus


def too_large(largest: int, energy: float) -> ValueError:
    """Return what tells that windows would be too large."""
    return ValueError(
        f"the blur takes windows of more than {2 * largest + 1} pixels a side to hold {energy:g} of the light; stop "
        f"down, allow larger windows (largest={largest + 1} or more), or ask for less of it (energy=)"
    )


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
    share = _SHARE * tol / max(1, sum(first != last for first, last in spans))
    found = []
    for axis, span in enumerate(spans):
        others = [np.unique(np.linspace(*other, 3)) for other in spans]

        def sample(
            along: NDArray[np.float64], axis: int = axis, others: list[NDArray[np.float64]] = others
        ) -> NDArray[np.float64]:
            ticks = [along if k == axis else other for k, other in enumerate(others)]
            windows = light.windows(_lattice(ticks), half)
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


def _lattice(ticks: Sequence[NDArray[np.float64]]) -> NDArray[np.float64]:
    """Return all places of a lattice, shape (n, 3), the last coordinate fastest."""
    return np.stack([part.ravel() for part in np.meshgrid(*ticks, indexing="ij")], axis=1)


def _half_way(axes: Sequence[Nodes]) -> NDArray[np.float64]:
    """Return the middles between nodes, shape (n, 3), some of them if they are many."""
    ticks = [nodes.between if nodes.count > 1 else np.unique([nodes.first, nodes.last]) for nodes in axes]
    places = _lattice(ticks)
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


def _least(windows: NDArray[np.float64], energy: float) -> int:
    """Return half of the least windows, of the same middles, that hold so much."""
    half = int(windows.shape[-1]) // 2
    while half > 0:
        inner = windows[:, 1:-1, 1:-1]
        if inner.sum(axis=(1, 2)).min() < energy:
            break
        windows, half = inner, half - 1
    return half
