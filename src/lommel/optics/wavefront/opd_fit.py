"""Wavefronts fitted to measured radial functions or OPD maps, and OPD maps of wavefronts."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Self

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.base.units import percent
from lommel.optics.wavefront.wavefront import MAX_HIGHER, Wavefront, radians_per
from lommel.special import zernike

MAX_RADIAL = 2 * (2 + MAX_HIGHER)
"""Highest power of rho in a radial fit, and highest degree n of a fit to a map."""

MAX_GROWTH = 1e4
"""Largest amplification of measurement errors in single coefficients, or at least in the phase."""

MAX_ROUNDING = 1e7
"""Largest condition number up to which terms can be orthogonalised on the samples."""

_RESIDUE = 1e-9  # of the largest value: rounding left of a zero
# Equal pixels taken as not measured: their least number, share of all, and ratio to those of any other value.
_LEAST_BLANK, _BLANK, _BLANK_OVER_OTHERS = 8, 0.002, 8
_BLOCK = 16384  # samples at a time, which bounds the memory of fits to large maps
_RADIAL_NODES = 400


@dataclass(frozen=True, eq=False, repr=False)
class OPDMap:
    """Measured map of optical path differences (OPD), or a stack of maps, for :func:`lommel.fit_opd`.

    ``2.0 * opd`` converts a surface error to the path difference in reflection; ``-opd`` changes the sign convention.

    Parameters
    ----------
    values : array_like, shape (..., height, width)
        Optical path difference in metres; x increases with the columns and y with the rows. NaN where there is no
        measurement; masked values become NaN.
    spacing : float, optional
        Pixel spacing in the pupil, metres.
    wavelength : float, optional
        Wavelength of the measurement, metres.

    Attributes
    ----------
    mask : ndarray of bool, of the shape of the values
        True where there is a measurement.

    Raises
    ------
    TypeError, ValueError
        If the values are not real, hold an infinity or no number at all, or have another shape, or if the spacing or
        the wavelength is out of range.

    Examples
    --------
    >>> import lommel as lm
    >>> opd = OPDMap(550e-9 * lm.opd_map(lm.Wavefront(1.0), 24, unit="waves"), wavelength=550e-9)
    >>> round(float(lm.fit_opd(opd).wavefront.defocus), 6)
    1.0
    """

    values: Array
    spacing: float | None = None
    wavelength: float | None = None

    def __post_init__(self) -> None:
        given, hidden = validation.parted("values", self.values)
        values = _real_maps("values", given)
        if hidden is not None:
            values[hidden] = np.nan
        if np.isinf(values).any() or np.isnan(values).all():
            raise ValueError(
                "values must be finite, or NaN where there is no measurement, and somewhere there must be one"
            )
        values.flags.writeable = False
        vars(self).update(values=values)
        if self.spacing is not None:
            vars(self).update(spacing=validation.real("spacing", self.spacing, above=0.0, unit="metres"))
        if self.wavelength is not None:
            vars(self).update(wavelength=validation.wavelength(self.wavelength))

    @property
    def mask(self) -> NDArray[np.bool_]:
        """True where there is a measurement."""
        return ~np.isnan(self.values)

    def __mul__(self, factor: float) -> Self:
        """Return the map times a number."""
        return replace(self, values=self.values * validation.real("factor", factor))

    __rmul__ = __mul__

    def __neg__(self) -> Self:
        """Return the map with the other sign."""
        return -1.0 * self

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> Values:
        """Return `values`."""
        return np.array(self.values, dtype=dtype, copy=copy)

    def __repr__(self) -> str:
        known = [f"{name} {at:g} m" for name in ("spacing", "wavelength") if (at := getattr(self, name)) is not None]
        size = "x".join(map(str, self.values.shape))
        return f"<OPDMap {', '.join([size, f'{percent(self.mask.mean(), 1)} measured', *known])}>"


@dataclass(frozen=True, eq=False)
class WavefrontFit:
    """A wavefront fitted to measurements, and its residual.

    Attributes
    ----------
    wavefront : Wavefront
        Fitted wavefront, without piston; a stack for a stack of maps.
    piston : ndarray, shape ``wavefront.shape``
        Fitted coefficient of the constant Zernike term over the disc, in `unit`: with the other terms over the disc,
        :meth:`Wavefront.to_zernike`, and the residual it adds up to the measurement. With an obscuration too, where
        it is not the mean of the map.
    rms, peak_to_valley : ndarray, shape ``wavefront.shape``
        Rms and peak-to-valley of the residual.
    residual : ndarray
        Measurement minus fit, shaped like the measurement; NaN where there was none.
    samples : ndarray of int, shape ``wavefront.shape``
        Number of samples used.
    condition : float
        Condition number of the worst fit, the amplification of measurement errors in single coefficients; 1 for a
        full pupil. Where it is above 1e4 the phase over the pupil is determined, single coefficients are not.
    unit : str
        Unit of these numbers.
    """

    wavefront: Wavefront
    piston: Array
    rms: Array
    peak_to_valley: Array
    residual: Array
    samples: NDArray[np.int64]
    condition: float
    unit: str


def fit_radial(
    phase: Callable[[Array], ArrayLike] | ArrayLike,
    rho: ArrayLike | None = None,
    *,
    degree: int = MAX_RADIAL,
    unit: str = "radians",
    wavelength: float | None = None,
    tol: float | None = None,
) -> WavefrontFit:
    """Fit a radially symmetric wavefront, a polynomial in rho^2, by least squares.

    Parameters
    ----------
    phase : callable, or array_like of shape (samples,)
        A function of pupil radii (an array in [0, 1], to an array of the same shape), or values at `rho`.
    rho : array_like, shape (samples,), optional
        Pupil radii of the values, 0 to 1, with equal weights. A function is sampled at 400 Gauss-Legendre nodes in
        rho^2, weighted by area.
    degree : int, default 20
        Highest power of rho, even, 2 to 20.
    unit : {"radians", "waves", "metres"}, default "radians"
        Of `phase`; metres of optical path need `wavelength`.
    wavelength : float, optional
        Metres.
    tol : float, optional
        Largest accepted rms residual, in `unit`. In radians it bounds the error of the field relative to an
        unaberrated peak, ``abs(dU) <= mean abs(d phase) <= rms``.

    Returns
    -------
    WavefrontFit
        Residuals at the samples, or at the nodes.

    Raises
    ------
    TypeError, ValueError
        If values are not finite, too few or too close together to determine the terms, or the residual exceeds `tol`.
    """
    scale = radians_per(unit, wavelength)
    limit = math.inf if tol is None else validation.real("tol", tol, above=0.0)
    highest = validation.integer("degree", degree, least=2, most=MAX_RADIAL)
    if highest % 2:
        raise ValueError(f"degree must be even, since rho comes in even powers, got {highest}")
    weights = None
    if callable(phase):
        if rho is not None:
            raise TypeError("rho must be left out where phase is a function")
        # Gauss nodes in rho^2 weight by area.
        x, w = np.polynomial.legendre.leggauss(_RADIAL_NODES)
        at, weights = np.sqrt(0.5 + 0.5 * x), 0.5 * w
        values = validation.real_array("phase", phase(at))
    else:
        if rho is None:
            raise TypeError("rho, the pupil radii of the values, must be given where phase is no function")
        at, values = validation.real_array("rho", rho, least=0.0, most=1.0), validation.real_array("phase", phase)
    if values.shape != at.shape or at.ndim != 1:
        raise ValueError(f"phase must have one value for each rho, got shapes {values.shape} and {at.shape}")
    terms = [(n, 0) for n in range(0, highest + 1, 2)]
    coefficients, residual, condition = _least_squares(at, np.zeros(at.size), values[None], terms, weights)
    return _finish(terms, coefficients, residual, condition, (), unit, scale, limit, weights)


def fit_opd(
    opd: ArrayLike | OPDMap,
    *,
    unit: str | None = None,
    wavelength: float | None = None,
    mask: ArrayLike | None = None,
    degree: int = 8,
    center: tuple[float, float] | None = None,
    radius: float | None = None,
    tol: float | None = None,
    obscuration: float = 0.0,
    within: str = "pupil",
) -> WavefrontFit:
    """Fit Zernike terms to a measured map of optical path differences, or to a stack of maps.

    Parameters
    ----------
    opd : array_like, shape (..., height, width), or OPDMap
        The measurement; x increases with the columns and y with the rows. NaN marks missing pixels, unless a `mask`
        or a masked array is given. :func:`lommel.load_opd` reads one.
    unit : {"radians", "waves", "metres"}
        Unit of `opd`; metres need `wavelength`. An OPDMap is in metres, and may have a wavelength. The sign is that
        of the phase: change it for a map in which a longer path is negative.
    wavelength : float, optional
        Metres.
    mask : array_like of bool, shape (height, width) or that of `opd`, optional
        True where the measurement is valid; False for an obscuration or a vane. Masked values of a masked array are
        ignored in either case. Without it a map is refused that has one value, such as 0, in whole areas, as files
        have it where nothing was measured.
    degree : int, default 8
        All terms with n up to this are fitted, 1 to 20: (degree + 1) (degree + 2) / 2 of them.
    center : (float, float), optional
        Row and column of the centre of the pupil, from the centre of the first pixel. Default: the centre of the map.
    radius : float, optional
        Radius of the pupil in pixels. Default: half the smaller side, the circle inscribed in the array, if the
        samples fill it: a map with a margin is refused, with the circle around its samples as radius and centre to
        give if that is the pupil.
    tol : float, optional
        Largest accepted rms residual, in `unit`.
    obscuration : float, default 0
        Radius of the central obscuration over that of the pupil, 0 to below 1. Pixels whose centre lies within it
        are not used, and the fit is by annular Zernike terms, as in :meth:`lommel.Wavefront.zernike`: to high
        degrees, where terms over the disc are nearly alike over the annulus.
    within : {"pupil", "samples"}, default "pupil"
        Where the phase must be determined. "samples": only among the samples, for a vignetted pupil whose aperture is
        stated elsewhere; beyond them the wavefront may be anything.

    Returns
    -------
    WavefrontFit
        A least-squares fit, also over samples on which the terms are not orthogonal. Pixels whose centre lies outside
        the circle are not used. The wavefront holds terms over the disc.

    Raises
    ------
    TypeError, ValueError
        If the map is not finite inside the mask, areas have one value without a `mask`, it is empty, the samples are
        too few or do not determine the terms, the residual exceeds `tol`, or without a `radius` the smallest circle
        around the samples is smaller than the pupil by more than a pixel and 2 %.
    """
    if isinstance(opd, OPDMap):
        if unit not in (None, "metres"):
            raise ValueError(f"unit must be left out for an OPDMap, which is in metres, got {validation.shown(unit)}")
        unit, wavelength = "metres", opd.wavelength if wavelength is None else wavelength
        # NaN is "not measured" in an OPDMap.
        opd = np.ma.masked_invalid(opd.values)
    elif unit is None:
        raise TypeError("unit must be given, 'radians', 'waves' or 'metres', where opd is no OPDMap")
    scale = radians_per(unit, wavelength)
    limit = math.inf if tol is None else validation.real("tol", tol, above=0.0)
    highest = validation.integer("degree", degree, least=1, most=MAX_RADIAL)
    eps = validation.real("obscuration", obscuration, least=0.0, below=1.0)
    validation.choice("within", within, ("pupil", "samples"))
    # Outside of the mask values may be anything, NaN included.
    maps, valid = _maps(opd, mask)
    height, width = maps.shape[-2:]
    x, y = _pupil_coordinates((height, width), center, radius)
    # A pixel belongs to the pupil if its centre does.
    square = x * x + y * y
    used = valid & (square <= 1.0) & (square >= eps * eps)
    bad = np.argwhere(used & ~np.isfinite(maps))
    if len(bad):
        listed = ", ".join(str(tuple(place.tolist())) for place in bad[:3]) + (", ..." if len(bad) > 3 else "")
        raise ValueError(f"opd must be finite inside the mask, got NaN or infinity at {len(bad)} pixels: {listed}")
    if not used.any(axis=(-2, -1)).all():
        of = "opd" if mask is None else "mask"
        raise ValueError(f"{of} must leave samples inside the pupil of every map, got none")
    if mask is None:
        _require_measured(maps.reshape(-1, height, width), used.reshape(-1, height, width))
    if radius is None:
        _require_filled(np.asarray(valid.any(axis=tuple(range(valid.ndim - 2)))))
    terms = [(n, m) for n in range(highest + 1) for m in range(-n, n + 1, 2)]
    flat = maps.reshape(-1, height, width)
    coefficients = np.empty((len(flat), len(terms)))
    residual = np.full(flat.shape, np.nan)
    condition = 1.0
    # Maps with the same samples share their normal equations.
    alike: dict[bytes, list[int]] = {}
    for i, pattern in enumerate(used.reshape(flat.shape)):
        alike.setdefault(np.packbits(pattern).tobytes(), []).append(i)
    for members in alike.values():
        where = used.reshape(flat.shape)[members[0]]
        rho, theta = np.hypot(x[where], y[where]), np.arctan2(y[where], x[where])
        places = _places(x, y, where if within == "samples" else (square <= 1.0) & (square >= eps * eps))
        found, left, worst = _least_squares(rho, theta, flat[members][:, where], terms, None, eps, places)
        coefficients[members] = found
        for member, rest in zip(members, left, strict=True):
            residual[member][where] = rest
        condition = max(condition, worst)
    return _finish(terms, coefficients, residual, condition, maps.shape[:-2], unit, scale, limit)


def opd_map(
    wavefront: Wavefront,
    shape: int | tuple[int, int],
    *,
    unit: str = "radians",
    wavelength: float | None = None,
    center: tuple[float, float] | None = None,
    radius: float | None = None,
) -> Array:
    """Sample a wavefront at the pixels of a map, as :func:`fit_opd` reads them.

    Parameters
    ----------
    wavefront : Wavefront
    shape : int or (int, int)
        Height and width in pixels.
    unit, wavelength, center, radius
        As those of :func:`fit_opd`; the unit is by default that of a wavefront.

    Returns
    -------
    ndarray, shape ``wavefront.shape + (height, width)``
        In `unit`, without piston; NaN at pixels whose centre lies outside the pupil.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.
    """
    validation.instance("wavefront", wavefront, Wavefront)
    scale = radians_per(unit, wavelength)
    size = validation.image_shape(shape)
    x, y = _pupil_coordinates(size, center, radius)
    rho = np.hypot(x, y)
    inside = rho <= 1.0
    out = np.full((*wavefront.shape, *size), np.nan)
    out[..., inside] = wavefront.phase(rho[inside], np.arctan2(y, x)[inside]) / scale
    return out


def _least_squares(
    rho: Array,
    theta: Array,
    values: Array,
    terms: list[tuple[int, int]],
    weights: Array | None = None,
    obscuration: float = 0.0,
    places: tuple[Array, Array] | None = None,
) -> tuple[Array, Array, float]:
    """Return rms-normalized coefficients (maps, terms), residuals (maps, samples) and the condition of the fit."""
    # Normal equations of nearly orthonormal terms (annular ones over an obscuration) with one refinement: errors of
    # rounding only up to a condition of 1e4. Beyond, terms are orthonormalised on the samples (Cholesky factor), if
    # their sum is determined at all `places`.
    over_disc = _over_disc(terms, obscuration)
    if rho.size < len(terms):
        raise ValueError(f"{len(terms)} terms need at least as many samples, got {rho.size}; lower degree")
    # Equal weights: the mean over the samples stands for the mean over the pupil.
    share = np.full(rho.size, 1.0 / rho.size) if weights is None else weights
    # For terms orthonormal over the disc the Gram matrix of a full pupil is near the unit matrix.
    gram = np.zeros((len(terms), len(terms)))
    for block, basis in _basis(rho, theta, terms, over_disc):
        gram += (basis * share[block]) @ basis.T
    eigenvalues = np.linalg.eigvalsh(gram)
    # The condition number of the terms is the root of that of their normal equations.
    low, high = float(eigenvalues[0]), float(eigenvalues[-1])
    condition = math.sqrt(high / low) if low > 0.0 else math.inf
    if not condition <= MAX_GROWTH:
        if places is None:
            raise _undetermined(rho.size, terms, condition, "", "")
        hints = "" if obscuration else ", state the obscuration of an annular pupil"
        refused = _undetermined(
            rho.size, terms, condition, " over the pupil", f'{hints}, or take within="samples" for a vignetted pupil'
        )
        if not condition <= MAX_ROUNDING:
            raise refused
        whole = _most(places, terms, over_disc)
        own = np.linalg.inv(np.linalg.cholesky(gram)).T
        # Orthonormal on the samples, so that the second fit is well conditioned.
        over_disc = own if over_disc is None else over_disc @ own
        # A sum of squares of terms that grows between the samples means a phase there that no sample determines.
        if not 0.0 < _most(places, terms, over_disc) <= MAX_GROWTH * whole:
            raise refused
        gram = np.zeros_like(gram)
        for block, basis in _basis(rho, theta, terms, over_disc):
            gram += (basis * share[block]) @ basis.T
    coefficients, residual = np.zeros((len(values), len(terms))), values.copy()
    # The second pass fits the residual of the first, which removes most of its rounding error.
    for _ in range(2):
        moments = np.zeros_like(coefficients)
        for block, basis in _basis(rho, theta, terms, over_disc):
            moments += (residual[:, block] * share[block]) @ basis.T
        coefficients += np.linalg.solve(gram, moments.T).T
        for block, basis in _basis(rho, theta, terms, over_disc):
            residual[:, block] = values[:, block] - coefficients @ basis
    return coefficients if over_disc is None else coefficients @ over_disc.T, residual, condition


def _places(x: Array, y: Array, inside: NDArray[np.bool_]) -> tuple[Array, Array]:
    """Return rho and theta at centres of some of the squares of four inner pixels."""
    every = max(1, int(math.sqrt(x.size) / 128))
    four = (inside[1:, 1:] & inside[:-1, 1:] & inside[1:, :-1] & inside[:-1, :-1])[::every, ::every]
    across = 0.5 * (x[1:, 1:] + x[:-1, :-1])[::every, ::every][four]
    down = 0.5 * (y[1:, 1:] + y[:-1, :-1])[::every, ::every][four]
    return np.hypot(across, down), np.arctan2(down, across)


def _most(places: tuple[Array, Array], terms: list[tuple[int, int]], over_disc: Array | None) -> float:
    """Return the root of the largest sum of squares of all terms at `places`; 0 without places."""
    squares = [(basis**2).sum(axis=0).max() for _, basis in _basis(*places, terms, over_disc)]
    return math.sqrt(max(squares, default=0.0))


def _undetermined(samples: int, terms: list[tuple[int, int]], condition: float, where: str, hints: str) -> ValueError:
    return ValueError(
        f"the {samples} samples do not determine {len(terms)} terms{where} (condition {condition:.2g}); lower "
        f"degree{hints}"
    )


def _over_disc(terms: list[tuple[int, int]], obscuration: float) -> Array | None:
    """Return the matrix from coefficients of annular terms to those over the disc, or None without an obscuration."""
    if obscuration == 0.0:
        return None
    made = np.zeros((len(terms), len(terms)))
    for m in {m for _, m in terms}:
        alike = [i for i, (_, k) in enumerate(terms) if k == m]  # of one order, rising n
        made[np.ix_(alike, alike)] = zernike.annular(m, terms[alike[-1]][0], obscuration)
    return made


def _basis(
    rho: Array, theta: Array, terms: list[tuple[int, int]], over_disc: Array | None
) -> Iterator[tuple[slice, Array]]:
    """Yield slices of the samples with the terms there, normalized to their rms, shape (terms, samples)."""
    for start in range(0, rho.size, _BLOCK):
        block = slice(start, start + _BLOCK)
        r, angle = rho[block], theta[block]
        radial = {key: zernike.rms_factor(*key) * zernike.radial(*key, r) for key in {(n, abs(m)) for n, m in terms}}
        azimuth = {m: np.cos(m * angle) if m >= 0 else np.sin(-m * angle) for m in {m for _, m in terms}}
        basis = np.array([radial[n, abs(m)] * azimuth[m] for n, m in terms])
        yield block, basis if over_disc is None else over_disc.T @ basis


def _finish(
    terms: list[tuple[int, int]],
    coefficients: Array,
    residual: Array,
    condition: float,
    stack: tuple[int, ...],
    unit: str,
    scale: float,
    tol: float,
    weights: Array | None = None,
) -> WavefrontFit:
    """Return the fit; ValueError if residuals (first axis the flattened stack, NaN where unused) exceed `tol`."""
    rest = residual.reshape(len(residual), -1)
    count = np.isfinite(rest).sum(axis=1)
    # The constant is among the terms, so that the mean of the residual is 0.
    rms = np.sqrt(np.nanmean(rest**2, axis=1) if weights is None else rest**2 @ weights)
    worst = int(rms.argmax())
    if not rms[worst] <= tol:
        which = f" of map {worst}" if len(rms) > 1 else ""
        raise ValueError(f"the residual{which} has an rms of {rms[worst]:.3g} {unit}, beyond tol={tol:g}")
    found = {t: scale * c.reshape(stack) for t, c in zip(terms, coefficients.T, strict=True)}
    return WavefrontFit(
        wavefront=Wavefront.zernike(found),
        piston=coefficients[:, terms.index((0, 0))].reshape(stack),
        rms=rms.reshape(stack),
        peak_to_valley=(np.nanmax(rest, axis=1) - np.nanmin(rest, axis=1)).reshape(stack),
        residual=residual.reshape(*stack, *residual.shape[1:]),
        samples=count.reshape(stack),
        condition=condition,
        unit=unit,
    )


def _maps(opd: ArrayLike, mask: ArrayLike | None) -> tuple[Array, NDArray[np.bool_]]:
    """Return maps and where they are valid: in the mask, else where not NaN, without masked pixels."""
    given, hidden = validation.parted("opd", opd)
    maps = _real_maps("opd", given)
    if mask is None:
        return maps, ~np.isnan(maps) if hidden is None else ~hidden
    stated = validation.array("mask", mask)
    if stated.dtype != np.bool_:
        raise TypeError(f"mask must hold booleans, got an array of {stated.dtype}")
    if stated.shape not in (maps.shape[-2:], maps.shape):
        raise ValueError(f"mask must have the shape {maps.shape[-2:]} or that of opd, got {stated.shape}")
    return maps, np.broadcast_to(stated, maps.shape) & (True if hidden is None else ~hidden)


def _require_filled(valid: NDArray[np.bool_]) -> None:
    """Raise ValueError if the samples of a map lie in a circle clearly smaller than the inscribed one."""
    rows = np.flatnonzero(valid.any(axis=1))
    ends = valid[rows].argmax(axis=1), valid.shape[1] - 1 - valid[rows, ::-1].argmax(axis=1)
    middle, radius = _enclosing(np.column_stack([np.tile(rows, 2), np.concatenate(ends)]).astype(np.float64))
    pupil = 0.5 * min(valid.shape)
    if radius + 1.0 < 0.98 * pupil:
        raise ValueError(
            f"opd must have samples up to the edge of the pupil, whose radius is by default {pupil:g} pixels, half "
            f"the smaller side; they lie in a circle of radius={radius:.1f} about "
            f"center=({middle[0]:.1f}, {middle[1]:.1f}): give both if that is the pupil, or those of the pupil"
        )


def _require_measured(maps: Array, used: NDArray[np.bool_]) -> None:
    """Raise ValueError if an area of a map has one value, as files use it for pixels without measurement."""
    # Equal neighbours: rare among measured numbers, and equally frequent for all steps of quantised ones.
    for given, inside in zip(maps, used, strict=True):
        # Arithmetic on a map of zeros, such as a change of units, leaves rounding errors.
        tiny = _RESIDUE * float(np.abs(given[inside]).max(initial=0.0))
        opd = np.where(np.abs(given) <= tiny, 0.0, given)
        alike = np.zeros_like(inside)
        for one, next_ in ((np.s_[1:], np.s_[:-1]), (np.s_[:, 1:], np.s_[:, :-1])):
            pairs = (opd[one] == opd[next_]) & inside[one] & inside[next_]
            alike[one] |= pairs
            alike[next_] |= pairs
        values, counts = np.unique(opd[alike], return_counts=True)
        if not values.size:
            continue
        k, total = int(counts.argmax()), int(inside.sum())
        others = int(np.delete(counts, k).max(initial=0))
        if max(_LEAST_BLANK, _BLANK * total, _BLANK_OVER_OTHERS * others) <= counts[k] and np.ptp(opd[inside]) > 0.0:
            exact = 2 * np.count_nonzero(alike & (given == 0.0)) > counts[k]
            such = "opd != 0" if exact else f"abs(opd) > {tiny:.1g}"
            such = f"such as {such}, or " if values[k] == 0.0 else ""
            raise ValueError(
                f"opd is {values[k]:g} at {counts[k]} neighbouring pixels of the pupil "
                f"({percent(counts[k] / total, 1)}), as files have it where nothing was measured: give "
                "mask=, True where there is a measurement "
                f"({such}True everywhere if these are), or obscuration= if they are the middle of an annular pupil"
            )


def _enclosing(points: Array) -> tuple[Array, float]:
    """Return centre and radius of the smallest circle around points, shape (n, 2)."""
    circle = points[0], 0.0
    held = points[:1]
    while True:
        away = np.hypot(*(points - circle[0]).T)
        far = int(away.argmax())
        if away[far] <= circle[1] * (1.0 + 1e-9):
            return circle
        # The circle grows each time: the smallest around its boundary points and the farthest point.
        few = np.vstack([held, points[far]])
        found = [
            (_through(few[list(some)]), few[list(some)]) for k in (2, 3) for some in combinations(range(len(few)), k)
        ]
        fits = [one for one in found if np.hypot(*(few - one[0][0]).T).max() <= one[0][1] * (1.0 + 1e-9)]
        circle, held = min(fits, key=lambda one: one[0][1])


def _through(points: Array) -> tuple[Array, float]:
    """Return centre and radius of the smallest circle through two or three points; infinite if there is none."""
    apart = points[1:] - points[0]
    # Least-norm centre c from the first point with 2 c . p = p^2 for the others.
    center, _, rank, _ = np.linalg.lstsq(2.0 * apart, (apart**2).sum(axis=1), rcond=None)
    return points[0] + center, float(np.hypot(*center)) if rank == len(apart) else math.inf


def _real_maps(name: str, value: ArrayLike) -> Array:
    """Return maps, shape (..., height, width), NaN allowed; TypeError or ValueError if they are none."""
    given = validation.array(name, value)
    if given.dtype.kind not in "iuf":
        raise TypeError(f"{name} must hold real numbers, got an array of {given.dtype}")
    if given.ndim < 2 or given.size == 0:
        raise ValueError(f"{name} must have the shape (..., height, width) and not be empty, got {given.shape}")
    return given.astype(np.float64)


def _pupil_coordinates(
    shape: tuple[int, int], center: tuple[float, float] | None, radius: float | None
) -> tuple[Array, Array]:
    """Return x and y of the pixel centres, over the radius of the pupil."""
    height, width = shape
    row, column = ((height - 1) / 2, (width - 1) / 2) if center is None else validation.position("center", center)
    size = 0.5 * min(shape) if radius is None else validation.real("radius", radius, above=0.0, unit="pixels")
    with np.errstate(over="ignore"):  # pixels far outside of a small pupil; their squares must be finite
        sides = [(np.arange(count) - at) / size for count, at in ((height, row), (width, column))]
    y, x = np.meshgrid(*(np.clip(side, -1e150, 1e150) for side in sides), indexing="ij")
    return x, y
