"""Distortion over the field: fitted places of targets beside those where an ideal lens has them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from dataclasses import field as attribute

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.estimation.field_signs import highest_degree, monomials, robust, with_errors
from lommel.estimation.field_stars import Blocks
from lommel.fit import goodness_of_fit
from lommel.fit.findings import Finding, Findings, FitReport

POSES = ("free", "known")
_FAR = 0.2  # of the spread of places: largest rms distortion
_TURNS = 4  # alternations of polynomials and alignment
_HALVINGS = 40  # of the bisection for the scatter
_OUTLIER, _NEAREST = 10.0, 0.03  # times the median distance, or this distance in pixels: places beyond are rejected
_MOST_OUTLIERS = 0.2  # of the places: more mean that the degree is too low


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Distortion(FitReport):
    """Displacement of images over the field: `distortion` of a :class:`lommel.FieldFit`.

    Attributes
    ----------
    coefficients : ndarray, shape (2, m)
        Displacement by rows and by columns, pixels, in products of Legendre polynomials of the ideal position.
    covariance : ndarray, shape (2 * m, 2 * m)
        Of the coefficients, row by row; wavefront, light and blur being nuisance parameters.
    degree : int
        Of the polynomials.
    pose : ndarray, shape (2, 3)
        Ideal places (row, column) on the sensor are ``pose[:, :2] @ ideal + pose[:, 2]`` of the places given.
    ideal : ndarray, shape (n, 2)
        Row and column on the sensor of each target without distortion; NaN where not known.
    residuals : ndarray, shape (n, e, 2)
        Fitted less predicted row and column of each image, pixels; NaN where the place or the star was not used.
    scatter : float
        Standard deviation of places about the polynomials beside what noise explains, pixels by rows or by columns:
        of the chart, of the catalogue, or of higher degrees. Standard errors include it.
    chi2 : float
        Of the places per degree of freedom, with the noise of the images alone.
    findings : Findings
        Scatter of places beside noise, and places that were rejected.
    summary : str
        Degree and number of places.
    """

    coefficients: Array
    covariance: Array = attribute(repr=False)
    degree: int
    pose: Array
    ideal: Array
    residuals: Array
    scatter: float
    chi2: float
    _sensor: Sensor = attribute(repr=False)

    def at(self, x: ArrayLike, y: ArrayLike) -> tuple[Array, Array]:
        """Return the displacement of images and its standard error at ideal positions.

        Parameters
        ----------
        x, y : array_like
            From the axis, x along columns and y along rows, metres or lambda*N; they broadcast.

        Returns
        -------
        displacement, errors : ndarray, shape ``(..., 2)``
            By rows and by columns, pixels.

        Raises
        ------
        TypeError, ValueError
            If a position is not finite.
        """
        across, down = validation.broadcast("x and y", validation.real_array("x", x), validation.real_array("y", y))
        return with_errors(*self._sensor.relative(across, down), self.degree, self.coefficients, self.covariance)


def checked_ideal(ideal: ArrayLike, places: Array, *, free: bool) -> Array:
    """Return ideal places (n, 2), NaN where unknown; ValueError unless they are those of the images, roughly."""
    found = validation.number_array("ideal", ideal).astype(np.float64)
    if found.shape != places.shape:
        raise ValueError(f"ideal must be a row and a column for each of {len(places)} windows, got {found.shape}")
    known = np.isfinite(found).all(axis=1)
    if np.isinf(found).any() or known.sum() < 4:
        raise ValueError(f"ideal must be at least 4 finite places, and NaN for those not known, got {known.sum()}")
    if free and np.linalg.matrix_rank(found[known] - found[known].mean(axis=0)) < 2:
        raise ValueError("ideal must be places that are not all on one line")
    at = _moved(_similarity(found[known], places[known]) if free else np.eye(2, 3), found[known])
    off = float(np.sqrt(((at - places[known]) ** 2).sum(axis=1).mean()))
    spread = float(np.sqrt(((places[known] - places[known].mean(axis=0)) ** 2).sum(axis=1).mean()))
    if off > _FAR * spread:
        how = "up to a shift, rotation and magnification " if free else ""
        raise ValueError(
            f"ideal must be where the windows are {how}but for distortion, got {off:.3g} pixels apart in the rms: "
            "they may be in another order, mirrored, or have rows and columns exchanged"
        )
    return found


def _similarity(one: Array, other: Array) -> Array:
    """Return the shift, rotation and magnification (2, 3) that bring places (n, 2) closest to others."""
    a, b = one - one.mean(axis=0), other - other.mean(axis=0)
    # Least squares for c and s in [[c, -s], [s, c]]: projections on the places and on them turned by 90 degrees.
    turned = np.stack([-a[:, 1], a[:, 0]], axis=1)
    size = (a * a).sum()
    c, s = float((a * b).sum() / size), float((turned * b).sum() / size)
    matrix = np.array([[c, -s], [s, c]])
    return np.column_stack([matrix, other.mean(axis=0) - matrix @ one.mean(axis=0)])


def _moved(pose: Array, places: Array) -> Array:
    return np.asarray(places @ pose[:, :2].T + pose[:, 2])


def _alignment(m: int, shape: tuple[int, int]) -> Array:
    """Return an orthonormal basis (j, 2 * m) of shifts, rotation and magnification among polynomials of a sensor."""
    rows = [np.eye(1, 2 * m, 0)[0], np.eye(1, 2 * m, m)[0]]
    if m >= 3:  # 1, u, v: displacements by rows are half a height times v
        # Relative coordinates are over the sides: equal magnification takes factors in proportion to these.
        down, across = np.asarray(shape) / math.hypot(*shape)
        grown, turned = np.zeros((2, 2 * m))
        grown[2], grown[m + 1] = down, across
        turned[1], turned[m + 2] = across, -down
        rows += [grown, turned]
    return np.array(rows)


@dataclass(frozen=True)
class Places:
    """Fitted places (r, e, 2), pixels, of r targets, and what is known of their errors.

    `noise` (r, 2e, 2e) is the covariance, rows first, were the wavefront known; `mixed` (r, 2e, s) how places follow
    the s shared parameters of a field, and `shared` (s, s) the information on these.
    """

    fitted: Array
    noise: Array
    mixed: Array
    shared: Array


def places_of(blocks: Blocks, centers: Array, tilt_of_pixel: float) -> Places:
    """Return the places of targets at `centers` (r, e, 2) on the sensor, from the information of a field fit."""
    shared, inverse = blocks.damped(0.0)
    twice = 2 * centers.shape[1]
    # How the places of maximum likelihood move when shared parameters change: inverse information times mixed one.
    follow = (inverse @ blocks.mixed.swapaxes(-1, -2))[:, :twice] / tilt_of_pixel
    k = blocks.waves
    waves = (follow[:, :, :k, None] * blocks.basis[:, None, None]).reshape(len(follow), twice, -1)
    noise = inverse[:, :twice, :twice] / tilt_of_pixel**2
    return Places(centers, noise, -np.concatenate([waves, follow[:, :, k:]], axis=-1), shared)


def fit_distortion(
    ideal: Array, used: NDArray[np.intp], places: Places, *, pose: str, degree: int, sensor: Sensor
) -> Distortion:
    """Return the distortion from ideal places (n, 2) of all targets and the fitted ones of those `used` (r,)."""
    known = np.isfinite(ideal[used]).all(axis=1)
    at = np.flatnonzero(known)
    given, seen = ideal[used[at]], places.fitted[at]
    first = seen[:, 0]
    degree = highest_degree(degree, len(at))
    transform = _similarity(given, first) if pose == "free" else np.eye(2, 3)
    m = (degree + 1) * (degree + 2) // 2
    held = _alignment(m, sensor.shape) if pose == "free" else np.zeros((0, 2 * m))
    for turn in range(_TURNS):
        spots = _moved(transform, given)
        basis = monomials(*sensor.relative(*sensor.positions(spots)), degree)
        found, distance = robust(basis, first - spots, np.ones(len(at)), np.eye(2))
        # 1.4826 times the median is the standard deviation of a normal distribution.
        good = distance <= _OUTLIER * max(1.4826 * float(np.median(distance)), _NEAREST)
        if good.mean() < 1.0 - _MOST_OUTLIERS:  # the degree is too low, or places are far less exact than images
            good[:] = True
            found = np.asarray(np.linalg.lstsq(basis, first - spots, rcond=None)[0].T, np.float64)
        if pose == "known" or turn == _TURNS - 1:
            break
        # What polynomials have of an alignment moves the ideal places instead.
        own = (held.T @ (held @ found.ravel())).reshape(2, m)
        transform = _similarity(given, spots + basis @ own.T)
    kept = at[good]
    part = Places(seen[good], places.noise[kept], places.mixed[kept], places.shared)
    off = part.fitted - spots[good][:, None]
    model = _PlaceModel(basis[good], off, part)
    most = max(4.0 * float(np.sqrt((off**2).mean())), 1e-6)
    solution, covariance, chi2 = model.fit(0.0)
    low, scatter, high = 0.0, 0.0, most
    # The scatter with which chi2 is 1, by bisection: chi2 falls as the scatter rises.
    for _ in range(_HALVINGS if chi2 > 1.0 else 0):
        scatter = 0.5 * (low + high)
        solution, covariance, above = model.fit(scatter)
        low, high = (scatter, high) if above > 1.0 else (low, scatter)
    # Without the alignment, which is that of the pose and no distortion.
    rest = np.eye(2 * m) - held.T @ held
    coefficients = (rest @ solution[: 2 * m]).reshape(2, m)
    residuals = np.full((len(ideal), seen.shape[1], 2), np.nan)
    residuals[used[kept]] = model.residuals(solution)
    limit, findings = float(goodness_of_fit.most(math.sqrt(2.0 / model.freedom))), []
    if chi2 > limit:
        text = f"places scatter by {scatter:.2g} pixels beside noise, which standard errors include"
        findings.append(Finding("scatter", "note", text, {"scatter": scatter, "chi2": chi2, "limit": limit}))
    if lost := len(at) - len(kept):
        findings.append(Finding("rejected", "note", f"{lost} places far off rejected", {"rejected": lost}))
    return Distortion(
        coefficients=coefficients,
        covariance=rest @ covariance[: 2 * m, : 2 * m] @ rest.T,
        degree=degree,
        pose=transform,
        ideal=_moved(transform, ideal),
        residuals=residuals,
        scatter=scatter,
        chi2=chi2,
        findings=Findings(findings),
        summary=f"distortion of degree {degree} from {len(kept)} places",
        _sensor=sensor,
    )


class _PlaceModel:
    """Displacements (r, e, 2) as polynomials, an alignment of each later exposure, and shared parameters."""

    def __init__(self, basis: Array, off: Array, places: Places) -> None:
        self.basis, self.off, self.places = basis, off, places
        r, e, _ = off.shape
        m, own = basis.shape[1], min(3, basis.shape[1])
        # Rows of the design are those of `noise`: rows of all exposures, then columns.
        design = np.zeros((r, 2, e, 2 * m + 2 * own * (e - 1)))
        for j in range(2):
            design[:, j, :, j * m : (j + 1) * m] = basis[:, None]
            for i in range(1, e):
                start = 2 * m + own * (2 * (i - 1) + j)
                design[:, j, i, start : start + own] = basis[:, :own]
        self.design = design.reshape(r, 2 * e, -1)
        self.freedom = max(2 * e * r - self.design.shape[2], 1)
        # The shared parameters are known as well as the images tell them.
        self.joined = np.concatenate([self.design, places.mixed], axis=-1)
        self.prior = np.zeros((self.joined.shape[2],) * 2)
        self.prior[self.design.shape[2] :, self.design.shape[2] :] = places.shared
        self.data = off.swapaxes(1, 2).reshape(r, -1)
        # A hole that is off its place is so in all exposures.
        self.alike = np.kron(np.eye(2), np.ones((e, e)))

    def fit(self, scatter: float) -> tuple[Array, Array, float]:
        """Return parameters, their covariance and chi2 per degree of freedom, for a scatter of places.

        Parameters that nothing determines are 0.
        """
        weight = np.linalg.inv(self.places.noise + scatter**2 * self.alike)
        weighted = weight @ self.joined
        normal = np.tensordot(self.joined, weighted, ([0, 1], [0, 1])) + self.prior
        # Scaled to a diagonal of 1: parameters have different units.
        scale = 1.0 / np.sqrt(np.maximum(np.diag(normal), 1e-300))
        scales = np.outer(scale, scale)
        inverse = np.linalg.pinv(normal * scales, rcond=1e-13, hermitian=True) * scales
        values = inverse @ np.tensordot(weighted, self.data, ([0, 1], [0, 1]))
        off = self.joined @ values - self.data
        total = float(np.einsum("ni,nij,nj->", off, weight, off) + values @ self.prior @ values)
        return values, inverse, total / self.freedom

    def residuals(self, solution: Array) -> Array:
        """Return displacements minus those of a solution, (r, e, 2)."""
        model = (self.design @ solution[: self.design.shape[2]]).reshape(len(self.off), 2, -1)
        return np.asarray(self.off - model.swapaxes(1, 2))


def displaced(found: Distortion, u: Array, v: Array) -> Array:
    """Return displacements (..., 2), pixels, at relative positions."""
    return np.asarray(monomials(u, v, found.degree) @ found.coefficients.T)


@dataclass(frozen=True)
class Sensor:
    """Rows and columns of a sensor, with the axis in its middle, and its pixel pitch."""

    shape: tuple[int, int]
    pixel: float

    @property
    def axis(self) -> tuple[float, float]:
        """Row and column of the middle."""
        rows, columns = self.shape
        return (rows - 1) / 2.0, (columns - 1) / 2.0

    def positions(self, places: Array) -> tuple[Array, Array]:
        """Return x and y of rows and columns (n, 2)."""
        y, x = ((places[:, i] - self.axis[i]) * self.pixel for i in (0, 1))
        return np.asarray(x), np.asarray(y)

    def relative(self, x: Array, y: Array) -> tuple[Array, Array]:
        """Return positions over the sensor, from -1 to 1."""
        row, column = (part / self.pixel + at for part, at in zip((y, x), self.axis, strict=True))
        # The outer edges of the pixels are at -1 and 1.
        v, u = (2.0 * (part + 0.5) / side - 1.0 for part, side in zip((row, column), self.shape, strict=True))
        return np.asarray(u), np.asarray(v)

    def grid(self, count: int) -> tuple[Array, Array]:
        """Return x and y of `count` positions from edge to edge."""
        y, x = (
            (np.linspace(-0.5, side - 0.5, count) - at) * self.pixel
            for side, at in zip(self.shape, self.axis, strict=True)
        )
        return np.asarray(x), np.asarray(y)
