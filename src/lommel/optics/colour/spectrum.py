"""Spectra, and colour channels of a sensor, as weighted sums over wavelengths."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
import scipy
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array, Json
from lommel.base.units import format_length
from lommel.optics.base_pupil import BasePupil
from lommel.special.legendre import gauss_legendre


class Component(NamedTuple):
    """One wavelength of an incoherent sum of intensities.

    Attributes
    ----------
    share : float
        Fraction of the total light.
    stretch : float
        Ratio of the reference wavelength to the wavelength of this component. The optical coordinate v of a point is
        larger by this factor than at the reference wavelength: the image at a shorter wavelength is smaller.
    pupil : Pupil
        Pupil at the wavelength of this component.
    """

    share: float
    stretch: float
    pupil: Any

    @property
    def weight(self) -> float:
        """Unaberrated peak of this component, relative to the peak of all light at the reference wavelength."""
        return self.share * self.stretch**2


@dataclass(frozen=True, init=False)
class Spectrum:
    """A spectrum: wavelengths and weights.

    Parameters
    ----------
    wavelengths : sequence of float
        Wavelengths, metres.
    weights : sequence of float, optional
        Fraction of the light at each wavelength, >= 0; normalised to a sum of 1. By default all are equal.

    Raises
    ------
    TypeError, ValueError
        If there is no wavelength or one wavelength is invalid, if the numbers of weights and wavelengths differ, or
        if a weight is negative or all are 0.
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
        shares = shares / shares.max()  # so that their sum does not overflow
        vars(self).update(wavelengths=waves, weights=tuple((shares / shares.sum()).tolist()))

    def components(self, pupil: BasePupil) -> list[Component]:
        """Return the component of each wavelength; ValueError if `pupil` has no (reference) wavelength."""
        if pupil.wavelength is None:
            raise ValueError("a spectrum needs a pupil with a wavelength, which is its reference wavelength")
        return [
            Component(share, pupil.wavelength / w, pupil.in_light(w))
            for w, share in zip(self.wavelengths, self.weights, strict=True)
        ]


def checked_wavelengths(wavelengths: ArrayLike) -> tuple[float, ...]:
    """Return wavelengths in metres; TypeError or ValueError if one is out of range or there are none."""
    waves = np.atleast_1d(validation.array("wavelengths", wavelengths, "metres"))
    if waves.ndim > 1:
        raise ValueError(f"wavelengths must be a number or a sequence of numbers, got shape {waves.shape}")
    if not waves.size:
        raise ValueError("wavelengths must not be empty")
    return tuple(validation.wavelength(w) for w in waves)


# Error of replacing the integral over a spectrum by a sum over few wavelengths. The intensity at a point of the
# sensor is a sum over pairs of points of the pupil. Each pair contributes ``exp(2 pi i L / lambda) / lambda^2`` times
# factors independent of the wavelength, where L is the difference of the optical paths from the two points.
# Relative to the unaberrated peak the error is therefore at most the maximum of
#
# ``E(L) = | sum_k u_k exp(2 pi i L s_k) - int q(s) exp(2 pi i L s) ds |``,  s = 1 / lambda,
#
# over all path differences L that occur. Here q is the spectrum times 1 / lambda^2, normalised to integral 1, and the
# weights u_k include the same factor. The wavenumbers s_k are Gauss nodes, and the u_k >= 0 are fitted by least
# squares over L.

_MAX_WAVELENGTHS = 256
_MAX_BLOCK = 2**20  # largest number of complex values computed in one call
_SLACK = 0.1  # bound on the increase of |E| between the sampled values of L, as a fraction of the tolerance


def fit_wavelengths(wavelengths: Array, curves: Array, paths: float, tol: float) -> tuple[Array, Array, float]:
    """Return wavelengths, weights of each channel (sum 1), and a bound on the PSF error of this sampling.

    `wavelengths` (n,) and `curves` (channels, n) are measured responses, and `paths` is the largest optical path
    difference in the pupil, metres. ValueError if more than 256 wavelengths are needed.
    """
    # Curves are interpolated linearly: the response extends to the first zero on either side.
    nonzero = np.flatnonzero(curves.any(axis=0))
    first, last = max(nonzero[0] - 1, 0), min(nonzero[-1] + 1, wavelengths.size - 1)
    low, high = 1.0 / wavelengths[last], 1.0 / wavelengths[first]
    phase = math.pi * (high - low) * paths  # half the range of 2 pi L / lambda over the spectrum
    count = max(1, int(0.5 * phase / math.pi))
    if 0.5 * count > _MAX_WAVELENGTHS:
        raise _too_many(paths, tol)
    dense, responses = _quadrature(wavelengths, curves, paths)
    path = np.linspace(0.0, paths, math.ceil(phase / (2.0 * math.sqrt(_SLACK * tol))) + 2)
    # E is a mean of waves of modulus at most 2 + tol, whose phases change by at most phase / (path.size - 1) = Bh
    # between two neighbouring samples of L. By Bernstein's inequality for the second derivative, E exceeds the larger
    # of the two samples by at most (Bh)^2 / 8 times 2 + tol.
    slack = (1.0 + tol) * (0.5 * phase / (path.size - 1)) ** 2
    middle = 0.5 * (low + high)
    spectrum = responses / dense**2  # q, times the weights of the quadrature
    spectrum /= spectrum.sum(axis=1, keepdims=True)
    blocks = np.array_split(path, math.ceil(path.size * dense.size / _MAX_BLOCK))
    exact = np.concatenate([spectrum @ _waves(dense, block, middle).T for block in blocks], axis=1)
    mean_squares = spectrum @ dense**2  # mean squared wavelength of each channel
    while count <= _MAX_WAVELENGTHS:
        nodes = 1.0 / (low + (high - low) * gauss_legendre(count, 0.0, 1.0)[0][::-1])
        waves = _waves(nodes, path, middle)
        weights = np.stack(
            [_fit_weights(waves, row, nodes, q @ dense**2) for row, q in zip(exact, spectrum, strict=True)]
        )
        u = weights / nodes**2 * mean_squares[:, None]
        error = float(np.abs(u @ waves.T - exact).max()) + slack
        if error <= tol:
            selected = np.flatnonzero(weights.any(axis=0))
            return nodes[selected], weights[:, selected], error
        count += max(1, count // 8)
    raise _too_many(paths, tol)


def _too_many(paths: float, tol: float) -> ValueError:
    return ValueError(
        f"tol={tol:g} takes more than {_MAX_WAVELENGTHS} wavelengths where paths differ by up to {paths:g} m; use a "
        "larger tol or smaller paths"
    )


def _quadrature(wavelengths: Array, curves: Array, paths: float) -> tuple[Array, Array]:
    """Return nodes (m,) of a quadrature over the spectrum, and responses times weights, (channels, m).

    The error of the quadrature is about 1e-10.
    """
    nodes, weights = gauss_legendre(4, 0.0, 1.0)
    ends = [wavelengths[:1]]
    for a, b in pairwise(wavelengths):
        pieces = max(4, math.ceil(2.0 * math.pi * paths * (1.0 / a - 1.0 / b)))
        ends.append(a + (b - a) * np.arange(1, pieces + 1) / pieces)
    edges = np.concatenate(ends)
    step = np.diff(edges)
    dense = (edges[:-1, None] + step[:, None] * nodes).ravel()
    responses = np.stack([np.interp(dense, wavelengths, curve) for curve in curves])
    return dense, responses * (step[:, None] * weights).ravel()


def _waves(wavelengths: Array, path: Array, middle: float) -> Array:
    """Return ``exp(2 pi i L (1 / lambda - middle))``, shape (paths, wavelengths)."""
    return np.asarray(np.exp(2j * math.pi * np.outer(path, 1.0 / wavelengths - middle)))


def _fit_weights(waves: Array, exact: Array, nodes: Array, mean_square: float) -> Array:
    """Return the weights of the nodes, of sum 1, that minimise E by nonnegative least squares over the paths.

    `exact` (paths,) is the integral in E, and `mean_square` is the mean squared wavelength of the spectrum q.
    """
    # A few paths for each unknown suffice for the fit; `fit_wavelengths` computes the error at all paths.
    sampled = waves[:: max(1, len(waves) // (8 * nodes.size + 32))]
    target = exact[:: max(1, len(waves) // (8 * nodes.size + 32))]
    scale = mean_square / nodes**2  # ratio of u_k to the weight of a node
    # The last row requires that the weights sum to 1.
    sum_row = math.sqrt(len(sampled)) * np.ones((1, nodes.size))
    rows = np.concatenate([sampled.real * scale, sampled.imag * scale, sum_row])
    try:
        weights = np.asarray(
            scipy.optimize.nnls(rows, np.concatenate([target.real, target.imag, [math.sqrt(len(sampled))]]))[0]
        )
    except RuntimeError as error:  # too many iterations
        raise ValueError(f"the fit of weights for {nodes.size} wavelengths did not converge: {error}") from None
    return np.asarray(weights / weights.sum())


def checked_paths(paths: float, tol: float) -> tuple[float, float]:
    """Return the arguments `paths` and `tol` if both are in range; TypeError or ValueError otherwise."""
    return (
        validation.real("paths", paths, above=0.0, below=1e-2, unit="metres"),
        validation.real("tol", tol, least=1e-6, below=0.5),
    )


RED_GREEN_BLUE = (600e-9, 540e-9, 460e-9)
"""Default wavelengths (metres) of the channels of a colour image."""

_RGB = ("red", "green", "blue")


@dataclass(frozen=True, init=False)
class Channels:
    """Colour channels of a sensor, each a weighted sum over the same wavelengths.

    Parameters
    ----------
    wavelengths : sequence of float, shape (n,)
        Wavelengths, metres, all different.
    weights : array_like, shape (channels, n)
        Response of each channel at each wavelength, >= 0, not all 0 in any channel.
    names : sequence of str, optional
        Distinct names; by default "red", "green" and "blue" for three channels, else "1", "2" and so on.

    Attributes
    ----------
    names : tuple of str
    wavelengths : tuple of float
    weights : tuple of tuple of float
        Weights of each channel, with sum 1.
    light : tuple of float
        Total response of each channel, divided by the largest total response.
    error : float
        Bound on the PSF error due to sampling measured curves at these wavelengths, relative to the unaberrated peak;
        0 unless channels are from :meth:`from_curves`.
    paths : float or None
        Largest optical path difference in the pupil for which `error` is valid, metres; None without measured curves.

    Raises
    ------
    TypeError, ValueError
        If an argument has an invalid value, shape or type.

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
        rows = rows / rows.max()  # so that their sums do not overflow
        if names is None:
            names = _RGB if len(rows) == 3 else [str(k) for k in range(1, len(rows) + 1)]
        is_list = isinstance(names, Sequence) and not isinstance(names, str)
        if not is_list or not all(isinstance(name, str) and name for name in names):
            raise TypeError(f"names must be texts, one for each channel, got {validation.shown(names)}")
        if len(set(names)) != len(rows) or len(names) != len(rows):
            raise ValueError(f"names must be {len(rows)} different names, got {validation.shown(names)}")
        totals = rows.sum(axis=1)
        vars(self).update(
            names=tuple(names),
            wavelengths=waves,
            weights=tuple(tuple(row) for row in (rows / totals[:, None]).tolist()),
            light=tuple((totals / totals.max()).tolist()),
            error=0.0,
            paths=None,
        )

    @classmethod
    def rgb(cls, width: float = 0.0, count: int = 5) -> Channels:
        """Return red, green and blue channels at 600, 540 and 460 nm.

        Parameters
        ----------
        width : float, default 0
            Width of each band, metres; 0 for the three wavelengths only.
        count : int, default 5
            Number of wavelengths in a band.

        Raises
        ------
        TypeError, ValueError
            See :meth:`bands`.
        """
        if validation.real("width", width, least=0.0, unit="metres") == 0.0:
            return cls(RED_GREEN_BLUE, np.eye(3))
        return cls.bands(RED_GREEN_BLUE, width, count=count)

    @classmethod
    def bands(
        cls, centers: Sequence[float], width: float, *, names: Sequence[str] | None = None, count: int = 5
    ) -> Channels:
        """Return channels that each have a uniform response over a band of wavelengths.

        Parameters
        ----------
        centers : sequence of float
            Central wavelength of each band, metres.
        width : float
            Width of each band, metres.
        names : sequence of str, optional
            Names of the channels; see :class:`Channels`.
        count : int, default 5
            Number of wavelengths in a band, the nodes of a Gauss-Legendre rule.

        Raises
        ------
        TypeError, ValueError
            If a wavelength is invalid, or the width not above 0.
        """
        metres = validation.real_array("centers", centers, unit="metres").ravel()
        middle = [validation.wavelength(w, "centers") for w in metres]
        if not middle:
            raise ValueError("centers must not be empty")
        half_width = 0.5 * validation.real("width", width, above=0.0, below=2.0 * min(middle), unit="metres")
        nodes, weights = gauss_legendre(validation.integer("count", count, least=1, most=256), -1.0, 1.0)
        bands = [(center + half_width * nodes).tolist() for center in middle]
        waves = list(dict.fromkeys(wave for band in bands for wave in band))
        rows = np.zeros((len(bands), len(waves)))
        for row, band in zip(rows, bands, strict=True):
            row[[waves.index(wave) for wave in band]] = weights
        return cls(tuple(waves), rows, names)

    @classmethod
    def of_wavelengths(cls, wavelengths: ArrayLike) -> Channels:
        """Return a channel for each of `wavelengths` (metres), named ``"550 nm"``; TypeError or ValueError."""
        waves = checked_wavelengths(wavelengths)
        # The smallest number of digits for which all names differ.
        candidates = ([format_length(w, digits=n) for w in waves] for n in range(4, 18))
        names = next((texts for texts in candidates if len({*texts}) == len(waves)), [repr(w) for w in waves])
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
        """Return channels from measured response curves, sampled at as few wavelengths as the tolerance allows.

        Parameters
        ----------
        wavelengths : array_like, shape (n,)
            Wavelengths, metres, ascending, at least two.
        curves : array_like, shape (channels, n)
            Response of each channel, >= 0: quantum efficiency times filter times light, interpolated linearly.
        names : sequence of str, optional
            Names of the channels; see :class:`Channels`.
        tol : float, default 1e-3
            Bound on the PSF error of the spectral sampling, relative to the unaberrated peak, 1e-6 to 0.5.
        paths : float, default 5e-6
            Largest optical path difference in the pupil for which the bound is valid, metres. A defocus coefficient
            C_d (radians at the pupil edge) contributes ``lambda C_d / pi``, a distance r from the axis on the sensor
            ``r / N``, N the f-number.

        Returns
        -------
        Channels
            Channels whose attribute ``error`` is the bound.

        Raises
        ------
        TypeError, ValueError
            If an argument is invalid, or more than 256 wavelengths are needed.
        """
        waves = validation.rising("wavelengths", wavelengths, count=2, unit="metres")
        for wave in (waves[0], waves[-1]):
            validation.wavelength(float(wave))
        values = validation.real_array("curves", curves, least=0.0)
        if values.ndim != 2 or values.shape[1] != waves.size or not values.size or not values.max(axis=1).all():
            raise ValueError(
                f"curves must be of shape (channels, {waves.size}), with light in every channel, "
                f"got {validation.shown(curves)}"
            )
        paths, tol = checked_paths(paths, tol)
        nodes, weights, error = fit_wavelengths(waves, values / values.max(), paths, tol)
        channels = cls(tuple(nodes.tolist()), weights * np.trapezoid(values, waves, axis=1).reshape(-1, 1), names)
        vars(channels).update(error=error, paths=paths)
        return channels

    def __len__(self) -> int:
        """Return the number of channels."""
        return len(self.names)

    @property
    def spectra(self) -> tuple[tuple[tuple[float, float], ...], ...]:
        """Pairs (wavelength, nonzero weight) of each channel, as in the option `wavelengths` of photographs."""
        return tuple(
            tuple((w, weight) for w, weight in zip(self.wavelengths, row, strict=True) if weight > 0.0)
            for row in self.weights
        )

    def __iter__(self) -> Iterator[tuple[str, tuple[tuple[float, float], ...]]]:
        """Yield the name of each channel and its pairs of wavelength and weight."""
        return iter(zip(self.names, self.spectra, strict=True))

    def to_dict(self) -> Json:
        """Return the attributes in plain types; :meth:`from_dict` is the inverse."""
        return asdict(self)

    @classmethod
    def from_dict(cls, description: Json) -> Channels:
        """Rebuild channels from a `description` by :meth:`to_dict`; TypeError, ValueError or KeyError."""
        parts = dict(description)
        total = validation.real_array("light", parts["light"], least=0.0)
        rows = validation.real_array("weights", parts["weights"]) * total[:, None]
        channels = cls(parts["wavelengths"], rows, parts["names"])
        paths, error = parts["paths"], validation.real("error", parts["error"], least=0.0)
        # Stored weights are used, since a second normalisation would change their last digits.
        weights = tuple(tuple(float(w) for w in row) for row in parts["weights"])
        vars(channels).update(weights=weights, light=tuple(total.tolist()), error=error, paths=paths and float(paths))
        return channels


def checked(channels: object) -> Channels:
    """Return `channels`, converted from a sequence of wavelengths if necessary; TypeError or ValueError otherwise."""
    if isinstance(channels, Channels):
        return channels
    if isinstance(channels, Sequence | np.ndarray) and not isinstance(channels, str):
        return Channels.of_wavelengths(channels)
    raise TypeError(
        f"channels must be Channels such as Channels.rgb(), or wavelengths, got {validation.shown(channels)}"
    )
