"""Distortion over the field: fitted positions of targets minus their positions without distortion.

Of several exposures, the positions are those of the first.

A target is a star, pinhole or crossing of a checkerboard. A place is its row and column on the sensor; its ideal
place is the place without distortion. The pose maps the places of a chart or catalogue to ideal places on the sensor.
"""

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

_MAX_RELATIVE_RMS = 0.2  # largest (rms distortion) / (rms distance of places from their mean)
_POSE_FITS = 4  # number of alternating fits of polynomials and pose
_HALVINGS = 40  # bisection steps for the scatter
# A place is rejected if its distance from the polynomials exceeds _OUTLIER times the standard deviation of distances,
# which is at least _MIN_DEVIATION pixels.
_OUTLIER, _MIN_DEVIATION = 10.0, 0.03
_MAX_OUTLIERS = 0.2  # fraction of outliers above which none is rejected


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Distortion(FitReport):
    """Displacement of images over the field: `distortion` of a :class:`~lommel.estimation.field_fit.FieldFit`.

    Attributes
    ----------
    coefficients : ndarray, shape (2, m)
        Coefficients of the displacement in row and in column, pixels. The basis functions are products of Legendre
        polynomials of the ideal position.
    covariance : ndarray, shape (2 * m, 2 * m)
        Covariance of the flattened `coefficients`; wavefront, flux, background and blur are nuisance parameters.
    degree : int
        Degree of the polynomials.
    pose : ndarray, shape (2, 3)
        Map from a place (row, column) in the argument `ideal` of the fit to the ideal place on the sensor,
        ``pose[:, :2] @ place + pose[:, 2]``.
    ideal : ndarray, shape (n, 2)
        Row and column on the sensor of each target without distortion; NaN if unknown.
    residuals : ndarray, shape (n, 2)
        Fitted minus predicted row and column of each target, pixels; NaN for targets that were not used.
    scatter : float
        Standard deviation of places about the polynomials in excess of noise, pixels in row or in column. It is
        caused by errors of the chart or catalogue, or by distortion of higher degrees. Standard errors include it.
    chi2 : float
        Chi2 of the places per degree of freedom, for the noise of the images without `scatter`.
    findings : Findings
        Scatter of places in excess of noise, and places that were rejected.
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
            Ideal positions from the axis, x by columns and y by rows, metres or lambda*N; they broadcast.

        Returns
        -------
        displacement, errors : ndarray, shape ``(..., 2)``
            Displacement in row and column, and its standard errors, pixels.

        Raises
        ------
        TypeError, ValueError
            If a position is not finite.
        """
        across, down = validation.broadcast("x and y", validation.real_array("x", x), validation.real_array("y", y))
        return with_errors(*self._sensor.relative(across, down), self.degree, self.coefficients, self.covariance)


def checked_ideal(ideal: ArrayLike, places: Array) -> Array:
    """Return the argument `ideal` as an array (n, 2), NaN where unknown; ValueError if it is far from `places`.

    The distance is that after the best shift, rotation and magnification.
    """
    array = validation.number_array("ideal", ideal).astype(np.float64)
    if array.shape != places.shape:
        raise ValueError(f"ideal must be a row and a column for each of {len(places)} windows, got {array.shape}")
    is_known = np.isfinite(array).all(axis=1)
    if np.isinf(array).any() or is_known.sum() < 4:
        raise ValueError(
            f"ideal must have at least 4 finite places, and NaN elsewhere, got {is_known.sum()} finite places"
        )
    if np.linalg.matrix_rank(array[is_known] - array[is_known].mean(axis=0)) < 2:
        raise ValueError("ideal must be places that are not all on one line")
    known_ideal, known_places = array[is_known], places[is_known]
    predicted = _transformed(_similarity(known_ideal, known_places), known_ideal)
    rms = float(np.sqrt(((predicted - known_places) ** 2).sum(axis=1).mean()))
    place_rms = float(np.sqrt(((known_places - known_places.mean(axis=0)) ** 2).sum(axis=1).mean()))
    if rms > _MAX_RELATIVE_RMS * place_rms:
        raise ValueError(
            "ideal must be near the windows, up to a shift, rotation and magnification, got an rms distance of "
            f"{rms:.3g} pixels: places may be in another order, mirrored, or have rows and columns exchanged"
        )
    return array


def _similarity(places: Array, targets: Array) -> Array:
    """Return the shift, rotation and magnification that map `places` closest to `targets`, as a pose (2, 3)."""
    a, b = places - places.mean(axis=0), targets - targets.mean(axis=0)
    # Least squares for c and s in [[c, -s], [s, c]]: projections on a, and on a rotated by 90 degrees.
    rotated = np.stack([-a[:, 1], a[:, 0]], axis=1)
    norm = (a * a).sum()
    c, s = float((a * b).sum() / norm), float((rotated * b).sum() / norm)
    matrix = np.array([[c, -s], [s, c]])
    return np.column_stack([matrix, targets.mean(axis=0) - matrix @ places.mean(axis=0)])


def _transformed(pose: Array, places: Array) -> Array:
    return np.asarray(places @ pose[:, :2].T + pose[:, 2])


def _pose_basis(m: int, shape: tuple[int, int]) -> Array:
    """Return an orthonormal basis (j, 2 * m) of the coefficients of shifts, rotation and magnification.

    The first m coefficients are those of the displacement in row, the last m those in column.
    """
    rows = [np.eye(1, 2 * m, 0)[0], np.eye(1, 2 * m, m)[0]]
    if m >= 3:  # the first three polynomials are 1, u and v
        # u and v are from -1 to 1 across the sensor: coefficients are proportional to its width and height.
        down, across = np.asarray(shape) / math.hypot(*shape)
        magnification, rotation = np.zeros((2, 2 * m))
        magnification[2], magnification[m + 1] = down, across
        rotation[1], rotation[m + 2] = across, -down
        rows += [magnification, rotation]
    return np.array(rows)


@dataclass(frozen=True)
class Places:
    """Fitted places of r targets (r, 2), pixels, with their covariance.

    `noise` (r, 2, 2) is the covariance for given common parameters of the field (wavefront and blur). `derivatives`
    (r, 2, s) are derivatives of the places by the s common parameters, and `common_information` (s, s) is the
    information matrix of these parameters.
    """

    fitted: Array
    noise: Array
    derivatives: Array
    common_information: Array


def places_of(blocks: Blocks, centers: Array, tilt_of_pixel: float) -> Places:
    """Return places from `centers` (r, e, 2) on the sensor, with covariances from the information of a field fit."""
    common, inverse = blocks.eliminate_nuisance(0.0)
    first = [0, centers.shape[1]]  # the rows of all exposures precede the columns
    # By the implicit function theorem, the derivative of the nuisance parameters by the common parameters is
    # -inverse(information of nuisance parameters) (mixed information).
    derivatives = (inverse @ blocks.mixed.swapaxes(-1, -2))[:, first] / tilt_of_pixel
    k = blocks.wave_count
    by_waves = (derivatives[:, :, :k, None] * blocks.basis[:, None, None]).reshape(len(derivatives), 2, -1)
    noise = inverse[:, first][:, :, first] / tilt_of_pixel**2
    return Places(centers[:, 0], noise, -np.concatenate([by_waves, derivatives[:, :, k:]], axis=-1), common)


def fit_distortion(
    ideal: Array, used: NDArray[np.intp], places: Places, *, degree: int, sensor: Sensor
) -> Distortion:
    """Return the distortion, given the `ideal` places (n, 2) of all targets and the fitted `places` of r targets.

    `used` (r,) are the indices of the fitted targets.
    """
    indices = np.flatnonzero(np.isfinite(ideal[used]).all(axis=1))
    chart_places, fitted_places = ideal[used[indices]], places.fitted[indices]
    degree = highest_degree(degree, len(indices))
    transform = _similarity(chart_places, fitted_places)
    m = (degree + 1) * (degree + 2) // 2
    pose_basis = _pose_basis(m, sensor.shape)
    for iteration in range(_POSE_FITS):
        ideal_places = _transformed(transform, chart_places)
        basis = monomials(*sensor.relative(*sensor.positions(ideal_places)), degree)
        shifts = fitted_places - ideal_places
        polynomials, distance = robust(basis, shifts, np.ones(len(indices)), np.eye(2))
        # 1.4826 times the median estimates the standard deviation of a normal distribution.
        inliers = distance <= _OUTLIER * max(1.4826 * float(np.median(distance)), _MIN_DEVIATION)
        # Many outliers: the degree is too low, or ideal places are far less accurate than images.
        if inliers.mean() < 1.0 - _MAX_OUTLIERS:
            inliers[:] = True
            polynomials = np.asarray(np.linalg.lstsq(basis, shifts, rcond=None)[0].T, np.float64)
        if iteration == _POSE_FITS - 1:
            break
        # The shift, rotation and magnification in the polynomials are moved to the pose.
        pose_part = (pose_basis.T @ (pose_basis @ polynomials.ravel())).reshape(2, m)
        transform = _similarity(chart_places, ideal_places + basis @ pose_part.T)
    accepted_indices = indices[inliers]
    noise, derivatives = places.noise[accepted_indices], places.derivatives[accepted_indices]
    accepted_places = Places(fitted_places[inliers], noise, derivatives, places.common_information)
    displacement = shifts[inliers]
    model = _PlaceModel(basis[inliers], displacement, accepted_places)
    solution, covariance, chi2 = model.fit(0.0)
    low, scatter, high = 0.0, 0.0, max(4.0 * float(np.sqrt((displacement**2).mean())), 1e-6)
    # Bisection for the scatter at which chi2 is 1: chi2 falls as the scatter rises.
    for _ in range(_HALVINGS if chi2 > 1.0 else 0):
        scatter = 0.5 * (low + high)
        solution, covariance, new_chi2 = model.fit(scatter)
        low, high = (scatter, high) if new_chi2 > 1.0 else (low, scatter)
    # Shift, rotation and magnification belong to the pose, not to the distortion.
    projection = np.eye(2 * m) - pose_basis.T @ pose_basis
    coefficients = (projection @ solution[: 2 * m]).reshape(2, m)
    residuals = np.full((len(ideal), 2), np.nan)
    residuals[used[accepted_indices]] = model.residuals(solution)
    limit, findings = float(goodness_of_fit.largest_plausible_chi2(math.sqrt(2.0 / model.degrees_of_freedom))), []
    if chi2 > limit:
        text = f"places scatter by {scatter:.2g} pixels in excess of noise, and standard errors include this scatter"
        findings.append(Finding("scatter", "note", text, {"scatter": scatter, "chi2": chi2, "limit": limit}))
    if rejected_count := len(indices) - len(accepted_indices):
        text = f"rejected {rejected_count} of {len(indices)} places, which are far from the polynomials"
        findings.append(Finding("rejected", "note", text, {"rejected": rejected_count}))
    return Distortion(
        coefficients=coefficients,
        covariance=projection @ covariance[: 2 * m, : 2 * m] @ projection.T,
        degree=degree,
        pose=transform,
        ideal=_transformed(transform, ideal),
        residuals=residuals,
        scatter=scatter,
        chi2=chi2,
        findings=Findings(findings),
        summary=f"distortion of degree {degree} from {len(accepted_indices)} places",
        _sensor=sensor,
    )


class _PlaceModel:
    """Linear model of displacements (r, 2).

    The parameters are the coefficients of polynomials, and changes of the common parameters of the field.
    """

    def __init__(self, basis: Array, displacement: Array, places: Places) -> None:
        self.places, self.data = places, displacement
        self.design = np.kron(np.eye(2), basis[:, None])  # (r, 2, 2 * m)
        coefficient_count = self.design.shape[2]
        self.degrees_of_freedom = max(displacement.size - coefficient_count, 1)
        # The prior of the common parameters is their information in the images.
        self.full_design = np.concatenate([self.design, places.derivatives], axis=-1)
        self.prior = np.zeros((self.full_design.shape[2],) * 2)
        self.prior[coefficient_count:, coefficient_count:] = places.common_information

    def fit(self, scatter: float) -> tuple[Array, Array, float]:
        """Return parameters, their covariance and chi2 per degree of freedom, for a scatter of places in pixels.

        Parameters that the places do not determine are set to 0.
        """
        weight = np.linalg.inv(self.places.noise + scatter**2 * np.eye(2))
        weighted_design = weight @ self.full_design
        normal_matrix = np.tensordot(self.full_design, weighted_design, ([0, 1], [0, 1])) + self.prior
        # The matrix is scaled to a diagonal of 1 because parameters have different units.
        scale = 1.0 / np.sqrt(np.maximum(np.diag(normal_matrix), 1e-300))
        scales = np.outer(scale, scale)
        inverse = np.linalg.pinv(normal_matrix * scales, rcond=1e-13, hermitian=True) * scales
        values = inverse @ np.tensordot(weighted_design, self.data, ([0, 1], [0, 1]))
        residual = self.full_design @ values - self.data
        chi2_sum = float(np.einsum("ni,nij,nj->", residual, weight, residual) + values @ self.prior @ values)
        return values, inverse, chi2_sum / self.degrees_of_freedom

    def residuals(self, solution: Array) -> Array:
        """Return displacements minus those of the polynomials in a solution, (r, 2)."""
        return np.asarray(self.data - self.design @ solution[: self.design.shape[2]])


def displacement_at(distortion: Distortion, u: Array, v: Array) -> Array:
    """Return displacements (..., 2), pixels, at positions u (by columns) and v (by rows) from -1 to 1."""
    return np.asarray(monomials(u, v, distortion.degree) @ distortion.coefficients.T)


@dataclass(frozen=True)
class Sensor:
    """Shape of a sensor, whose middle is on the axis, and its pixel pitch."""

    shape: tuple[int, int]
    pixel: float

    @property
    def axis(self) -> tuple[float, float]:
        """Row and column of the middle of the sensor."""
        rows, columns = self.shape
        return (rows - 1) / 2.0, (columns - 1) / 2.0

    def positions(self, places: Array) -> tuple[Array, Array]:
        """Return the positions x and y of `places`, rows and columns (n, 2)."""
        y, x = ((places[:, i] - self.axis[i]) * self.pixel for i in (0, 1))
        return np.asarray(x), np.asarray(y)

    def relative(self, x: Array, y: Array) -> tuple[Array, Array]:
        """Return positions u by columns and v by rows, which are -1 and 1 at the outer edges of the sensor."""
        row, column = (coordinate / self.pixel + middle for coordinate, middle in zip((y, x), self.axis, strict=True))
        pairs = zip((row, column), self.shape, strict=True)
        v, u = (2.0 * (coordinate + 0.5) / side - 1.0 for coordinate, side in pairs)
        return np.asarray(u), np.asarray(v)

    def grid(self, count: int) -> tuple[Array, Array]:
        """Return x and y of `count` positions each, from edge to edge of the sensor."""
        y, x = (
            (np.linspace(-0.5, side - 0.5, count) - middle) * self.pixel
            for side, middle in zip(self.shape, self.axis, strict=True)
        )
        return np.asarray(x), np.asarray(y)
