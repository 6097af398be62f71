"""Spectra and the channels of a sensor: weighted sums over wavelengths."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array, Json
from lommel.base.units import format_length
from lommel.optics.base_pupil import BasePupil
from lommel.special.legendre import gauss_legendre


class Component(NamedTuple):
    """One of the fields whose intensities add up incoherently.

    Attributes
    ----------
    share : float
        Fraction of the light.
    stretch : float
        Reference wavelength divided by that of this field: the factor from v of the reference to v of this field, so
        that the image of a shorter wavelength is smaller.
    pupil : Pupil
    """

    share: float
    stretch: float
    pupil: Any

    @property
    def weight(self) -> float:
        """Unaberrated peak over that of the reference."""
        return self.share * self.stretch**2


@dataclass(frozen=True, init=False)
class Spectrum:
    """A spectrum: wavelengths and weights.

    Parameters
    ----------
    wavelengths : sequence of float
        Metres.
    weights : sequence of float, optional
        Share of the light at each wavelength, >= 0; made to sum to 1. By default all are equal.

    Raises
    ------
    TypeError, ValueError
        If there is no valid wavelength, or the weights are not one for each, negative or all 0.
    """

    wavelengths: tuple[float, ...]
    weights: tuple[float, ...]

    def __init__(self, wavelengths: Sequence[float], weights: ArrayLike | None = None) -> None:
        waves = checked_wavelengths(wavelengths)
        shares = np.ones(len(waves)) if weights is None else validation.real_array("weights", weights, least=0.0)
        if shares.shape != (len(waves),) or not shares.max() > 0:
            raise ValueError(
                f"weights must be one for each of the {len(waves)} wavelengths, and not all 0, "
                f"got {validation.shown(weights)}"
            )
        shares = shares / shares.max()  # whose sum cannot overflow
        vars(self).update(wavelengths=waves, weights=tuple((shares / shares.sum()).tolist()))

    def components(self, pupil: BasePupil) -> list[Component]:
        """Return the weighted pupil at each wavelength; ValueError if `pupil`, the reference, has no wavelength."""
        if pupil.wavelength is None:
            raise ValueError("a spectrum needs a pupil with a wavelength, to which the others are related")
        return [
            Component(share, pupil.wavelength / w, pupil.in_light(w))
            for w, share in zip(self.wavelengths, self.weights, strict=True)
        ]


def checked_wavelengths(wavelengths: ArrayLike) -> tuple[float, ...]:
    """Return wavelengths in metres; TypeError or ValueError if one is out of range or there are none."""
    given = np.atleast_1d(validation.array("wavelengths", wavelengths))
    if given.ndim > 1:
        raise ValueError(f"wavelengths must be a number or a sequence of them, got shape {given.shape}")
    if not given.size:
        raise ValueError("wavelengths must not be empty")
    return tuple(validation.wavelength(w) for w in given)


# The intensity at a point of the sensor is a sum of ``exp(2 pi i L / lambda) / lambda^2`` over pairs of points of the
# pupil, times factors without the wavelength; L is the difference of the optical paths from the pair to the point. So
# a sum over wavelengths in place of the integral over a spectrum q is in error, relative to the unaberrated peak, by
# no more than the largest of
#
# ``E(L) = | sum_k u_k exp(2 pi i L s_k) - int q(s) exp(2 pi i L s) ds |``,  s = 1 / lambda,
#
# over all paths that occur, where u and q hold the factor 1 / lambda^2 and q has the integral 1. The s_k are Gauss
# nodes all over the spectrum; the u_k >= 0 are those of least squares over L.

_MOST = 256  # wavelengths
_AT_ONCE = 2**20  # waves
_SLACK = 0.1  # of the tolerance: how much |E| may rise between the paths at which it is computed


def few(wavelengths: Array, curves: Array, paths: float, tol: float) -> tuple[Array, Array, float]:
    """Return few wavelengths, weights of each channel that sum to 1, and a bound on the PSF error they cause.

    `paths` is the largest optical path difference in the pupil, metres. ValueError beyond 256 wavelengths.
    """
    # Curves are linear between their wavelengths, so light reaches to the first dark wavelength on either side.
    lit = np.flatnonzero(curves.any(axis=0))
    first, last = max(lit[0] - 1, 0), min(lit[-1] + 1, wavelengths.size - 1)
    low, high = 1.0 / wavelengths[last], 1.0 / wavelengths[first]
    phase = math.pi * (high - low) * paths  # half the range of 2 pi L / lambda over the spectrum
    count = max(1, int(0.5 * phase / math.pi))
    if 0.5 * count > _MOST:
        raise _too_many(paths, tol)
    at, light = _dense(wavelengths, curves, paths)
    path = np.linspace(0.0, paths, math.ceil(phase / (2.0 * math.sqrt(_SLACK * tol))) + 2)
    # E is a mean of waves whose phases change by up to phase / (path.size - 1) = Bh between two paths at which it is
    # computed, and at most 2 (plus its error at L = 0, which is below tol): linear interpolation between them errs by
    # (Bh)^2 / 8 times that (Bernstein's inequality for the second derivative).
    slack = (1.0 + tol) * (0.5 * phase / (path.size - 1)) ** 2
    middle = 0.5 * (low + high)
    bright = light / at**2
    bright /= bright.sum(axis=1, keepdims=True)
    blocks = np.array_split(path, math.ceil(path.size * at.size / _AT_ONCE))
    exact = np.concatenate([bright @ _waves(at, block, middle).T for block in blocks], axis=1)
    while count <= _MOST:
        nodes = 1.0 / (low + (high - low) * gauss_legendre(count, 0.0, 1.0)[0][::-1])
        waves = _waves(nodes, path, middle)
        weights = np.stack([_fitted(waves, one, nodes, row @ at**2) for one, row in zip(exact, bright, strict=True)])
        bright_nodes = weights / nodes**2 * (bright @ at**2)[:, None]
        error = float(np.abs(bright_nodes @ waves.T - exact).max()) + slack
        if error <= tol:
            used = np.flatnonzero(weights.any(axis=0))
            return nodes[used], weights[:, used], error
        count += max(1, count // 8)
    raise _too_many(paths, tol)


def _too_many(paths: float, tol: float) -> ValueError:
    return ValueError(
        f"tol={tol:g} takes more than {_MOST} wavelengths where paths differ by up to {paths:g} m; give a "
        "larger tol or smaller paths"
    )


def _dense(wavelengths: Array, curves: Array, paths: float) -> tuple[Array, Array]:
    """Return the nodes of a quadrature over the curves, to about 1e-10, and light times weight at each node."""
    nodes, weights = gauss_legendre(4, 0.0, 1.0)
    ends = [wavelengths[:1]]
    for a, b in pairwise(wavelengths):
        pieces = max(4, math.ceil(2.0 * math.pi * paths * (1.0 / a - 1.0 / b)))
        ends.append(a + (b - a) * np.arange(1, pieces + 1) / pieces)
    edges = np.concatenate(ends)
    step = np.diff(edges)
    at = (edges[:-1, None] + step[:, None] * nodes).ravel()
    light = np.stack([np.interp(at, wavelengths, curve) for curve in curves])
    return at, light * (step[:, None] * weights).ravel()


def _waves(wavelengths: Array, path: Array, middle: float) -> Array:
    """Return ``exp(2 pi i L (1 / lambda - middle))``, shape (paths, wavelengths)."""
    return np.asarray(np.exp(2j * math.pi * np.outer(path, 1.0 / wavelengths - middle)))


def _fitted(waves: Array, exact: Array, nodes: Array, mean_square: float) -> Array:
    """Return the nonnegative least-squares weights of the nodes, of sum 1, for E over the paths."""
    from scipy.optimize import nnls

    # Least squares need some rows for each unknown; `few` computes the bound at all paths.
    thin = waves[:: max(1, len(waves) // (8 * nodes.size + 32))]
    goal = exact[:: max(1, len(waves) // (8 * nodes.size + 32))]
    scale = mean_square / nodes**2  # u_k over the weight of a node; mean_square: of the wavelength
    rows = np.concatenate([thin.real * scale, thin.imag * scale, math.sqrt(len(thin)) * np.ones((1, nodes.size))])
    try:
        found = np.asarray(nnls(rows, np.concatenate([goal.real, goal.imag, [math.sqrt(len(thin))]]))[0])
    except RuntimeError as error:  # of iterations without end
        raise ValueError(f"the weights of {nodes.size} wavelengths are not found: {error}") from None
    return np.asarray(found / found.sum())


def checked_paths(paths: float, tol: float) -> tuple[float, float]:
    """Return both in range; TypeError or ValueError otherwise."""
    return (
        validation.real("paths", paths, above=0.0, below=1e-2, unit="metres"),
        validation.real("tol", tol, least=1e-6, below=0.5),
    )


RED_GREEN_BLUE = (600e-9, 540e-9, 460e-9)
"""Wavelengths (metres) that stand for the channels of a colour image where none are given."""

_RGB = ("red", "green", "blue")


@dataclass(frozen=True, init=False)
class Channels:
    """Colour channels of a sensor, each a weighted sum over the same wavelengths.

    Parameters
    ----------
    wavelengths : sequence of float, shape (n,)
        Metres, all different.
    weights : array_like, shape (channels, n)
        Response of each channel at each wavelength, >= 0, not all 0 in any channel.
    names : sequence of str, optional
        Distinct names; by default "red", "green" and "blue" for three channels, else "1", "2" and so on.

    Attributes
    ----------
    names : tuple of str
    wavelengths : tuple of float
    weights : tuple of tuple of float
        Weights of each channel, of sum 1.
    light : tuple of float
        Total response of each channel relative to the largest.
    error : float
        Bound on the PSF error due to sampling measured curves at these wavelengths, relative to the unaberrated peak;
        0 if not made by :meth:`from_curves`.
    paths : float or None
        Largest optical path difference in the pupil for which `error` holds, metres; else None.

    Raises
    ------
    TypeError, ValueError
        If numbers or names are not as stated.

    Examples
    --------
    >>> import lommel as lm
    >>> lm.Channels.rgb().names
    ('red', 'green', 'blue')
    """

    names: tuple[str, ...]
    wavelengths: tuple[float, ...]
    weights: tuple[tuple[float, ...], ...]
    light: tuple[float, ...]
    error: float
    paths: float | None

    def __init__(self, wavelengths: Sequence[float], weights: ArrayLike, names: Sequence[str] | None = None) -> None:
        waves = checked_wavelengths(wavelengths)
        if len(set(waves)) != len(waves):
            raise ValueError(f"wavelengths must all be different, got {validation.shown(wavelengths)}")
        rows = validation.real_array("weights", weights, least=0.0)
        if rows.ndim != 2 or rows.shape[1] != len(waves) or not rows.size or not rows.max(axis=1).all():
            raise ValueError(
                f"weights must be of shape (channels, {len(waves)}), one for each of the wavelengths, with light in "
                f"every channel, got {validation.shown(weights)}"
            )
        rows = rows / rows.max()  # whose sums cannot overflow
        if names is None:
            names = _RGB if len(rows) == 3 else [str(k) for k in range(1, len(rows) + 1)]
        listed = isinstance(names, Sequence) and not isinstance(names, str)
        if not listed or not all(isinstance(name, str) and name for name in names):
            raise TypeError(f"names must be texts, one for each channel, got {validation.shown(names)}")
        if len(set(names)) != len(rows) or len(names) != len(rows):
            raise ValueError(f"names must be {len(rows)} that differ, got {validation.shown(names)}")
        light = rows.sum(axis=1)
        vars(self).update(
            names=tuple(names),
            wavelengths=waves,
            weights=tuple(tuple(row) for row in (rows / light[:, None]).tolist()),
            light=tuple((light / light.max()).tolist()),
            error=0.0,
            paths=None,
        )

    @classmethod
    def rgb(cls, width: float = 0.0, count: int = 5) -> Channels:
        """Return red, green and blue around 600, 540 and 460 nm.

        Parameters
        ----------
        width : float, default 0
            Width of each band, metres; 0 for the three wavelengths only.
        count : int, default 5
            Number of wavelengths in a band.

        Raises
        ------
        TypeError, ValueError
            As :meth:`bands`.
        """
        if validation.real("width", width, least=0.0) == 0.0:
            return cls(RED_GREEN_BLUE, np.eye(3))
        return cls.bands(RED_GREEN_BLUE, width, count=count)

    @classmethod
    def bands(
        cls, centers: Sequence[float], width: float, *, names: Sequence[str] | None = None, count: int = 5
    ) -> Channels:
        """Return channels with a uniform response over a band each.

        Parameters
        ----------
        centers : sequence of float
            Metres.
        width : float
            Metres, from edge to edge.
        names : sequence of str, optional
        count : int, default 5
            Number of wavelengths in a band, the nodes of a Gauss-Legendre rule.

        Raises
        ------
        TypeError, ValueError
            If a wavelength is invalid, or the width not above 0.
        """
        middle = [validation.wavelength(w, "centers") for w in validation.real_array("centers", centers).ravel()]
        if not middle:
            raise ValueError("centers must not be empty")
        half = 0.5 * validation.real("width", width, above=0.0, below=2.0 * min(middle), unit="metres")
        nodes, weights = gauss_legendre(validation.integer("count", count, least=1, most=256), -1.0, 1.0)
        bands = [(center + half * nodes).tolist() for center in middle]
        waves = list(dict.fromkeys(wave for band in bands for wave in band))
        rows = np.zeros((len(bands), len(waves)))
        for row, band in zip(rows, bands, strict=True):
            row[[waves.index(wave) for wave in band]] = weights
        return cls(tuple(waves), rows, names)

    @classmethod
    def of_wavelengths(cls, wavelengths: ArrayLike) -> Channels:
        """Return a channel for each of `wavelengths` (metres), named ``"550 nm"``; TypeError or ValueError."""
        waves = checked_wavelengths(wavelengths)
        # The fewest digits that tell the wavelengths apart.
        spelled = ([format_length(w, digits=n) for w in waves] for n in range(4, 18))
        names = next((each for each in spelled if len({*each}) == len(waves)), [repr(w) for w in waves])
        return cls(waves, np.eye(len(waves)), names)

    @classmethod
    def from_curves(
        cls,
        wavelengths: ArrayLike,
        curves: ArrayLike,
        names: Sequence[str] | None = None,
        *,
        tol: float = 1e-3,
        paths: float = 5e-6,
    ) -> Channels:
        """Return channels from measured response curves, with as few wavelengths as a tolerance allows.

        Parameters
        ----------
        wavelengths : array_like, shape (n,)
            Metres, rising, at least two.
        curves : array_like, shape (channels, n)
            Response of each channel, >= 0: quantum efficiency times filter times light, interpolated linearly.
        names : sequence of str, optional
        tol : float, default 1e-3
            Bound on the PSF error of the spectral sampling, relative to the unaberrated peak, 1e-6 to 0.5.
        paths : float, default 5e-6
            Largest optical path difference in the pupil for which that holds, metres: ``lambda C_d / pi`` of defocus,
            ``r / N`` at the distance r from the axis of the sensor.

        Returns
        -------
        Channels
            With the bound as ``error``.

        Raises
        ------
        TypeError, ValueError
            If numbers are not as stated, or more than 256 wavelengths are needed.
        """
        waves = validation.rising("wavelengths", wavelengths, count=2)
        for wave in (waves[0], waves[-1]):
            validation.wavelength(float(wave))
        light = validation.real_array("curves", curves, least=0.0)
        if light.ndim != 2 or light.shape[1] != waves.size or not light.size or not light.max(axis=1).all():
            raise ValueError(
                f"curves must be of shape (channels, {waves.size}), with light in every channel, "
                f"got {validation.shown(curves)}"
            )
        nodes, weights, error = few(waves, light / light.max(), *checked_paths(paths, tol))
        made = cls(tuple(nodes.tolist()), weights * np.trapezoid(light, waves, axis=1).reshape(-1, 1), names)
        vars(made).update(error=error, paths=float(paths))
        return made

    def __len__(self) -> int:
        """Return the number of channels."""
        return len(self.names)

    @property
    def spectra(self) -> tuple[tuple[tuple[float, float], ...], ...]:
        """Pairs of wavelength and nonzero weight for each channel, as the argument `wavelengths` of photographs."""
        return tuple(
            tuple((w, share) for w, share in zip(self.wavelengths, row, strict=True) if share > 0.0)
            for row in self.weights
        )

    def __iter__(self) -> Iterator[tuple[str, tuple[tuple[float, float], ...]]]:
        """Yield the name of each channel and its pairs of wavelength and weight."""
        return iter(zip(self.names, self.spectra, strict=True))

    def to_dict(self) -> Json:
        """Return everything in plain types."""
        return asdict(self)

    @classmethod
    def from_dict(cls, description: Json) -> Channels:
        """Rebuild channels from a `description` by :meth:`to_dict`; TypeError, ValueError or KeyError."""
        parts = dict(description)
        light = validation.real_array("light", parts["light"], least=0.0)
        rows = validation.real_array("weights", parts["weights"]) * light[:, None]
        made = cls(parts["wavelengths"], rows, parts["names"])
        paths, error = parts["paths"], validation.real("error", parts["error"], least=0.0)
        # Not divided again by sums that are 1 but for rounding.
        weights = tuple(tuple(float(w) for w in row) for row in parts["weights"])
        vars(made).update(weights=weights, light=tuple(light.tolist()), error=error, paths=paths and float(paths))
        return made


def checked(channels: object) -> Channels:
    """Return channels, or one for each of some wavelengths; TypeError or ValueError if it is neither."""
    if isinstance(channels, Channels):
        return channels
    if isinstance(channels, Sequence | np.ndarray) and not isinstance(channels, str):
        return Channels.of_wavelengths(channels)
    raise TypeError(
        f"channels must be Channels such as Channels.rgb(), or wavelengths, got {validation.shown(channels)}"
    )
