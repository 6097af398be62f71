"""Field maps of objectives: aberrations over the field from beads that were fitted one place at a time."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.estimation.bead_images import Setup
from lommel.estimation.beads import BeadFit
from lommel.estimation.field_sensor import Sensor
from lommel.estimation.field_signs import highest_degree, monomials, robust, with_errors
from lommel.fit.findings import Finding, Findings, FitReport
from lommel.fit.least_squares import LinearFit, fit_scatter, inliers, least_squares, scatter_findings
from lommel.methods.derivative_names import Term
from lommel.optics.layers.objective import Objective
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.special import zernike

_MOST_DEGREE = 4


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class ObjectiveField(FitReport):
    """Aberrations of an objective over the field: the answer of :func:`lommel.fit_objective_field`.

    Attributes
    ----------
    names : tuple of (n, m)
        The k Zernike terms.
    coefficients : ndarray, shape (k, m)
        Of each term (radians rms) in products of Legendre polynomials of the position, -1 to 1 over the sensor.
    constants : dict of str to float
        Of the microscope, those that the fits estimated: one value for all of the field.
    covariance : ndarray, shape (k * m + c, k * m + c)
        Of the coefficients, row by row, and the constants.
    objective : Objective
        With these constants.
    degree : int
        Of the polynomials.
    scatter : float
        Standard deviation of each term about the polynomials beside the noise of the fits, radians rms; standard
        errors include it.
    chi2 : float
        Of the fits about the polynomials, per degree of freedom, with their stated errors alone.
    used : ndarray of bool, shape (n,)
        Fits that converged and are not far from the polynomials.
    residuals : ndarray, shape (n, k)
        Terms of each fit less those of the map, radians rms.
    findings, summary, converged, reliable, status, message
        As of :class:`lommel.fit.FitReport`: whether terms scatter by more than their errors, and fits left out.
    """

    names: tuple[Term, ...]
    coefficients: Array
    constants: dict[str, float]
    covariance: Array
    objective: Objective = field(repr=False)
    degree: int
    scatter: float
    chi2: float
    used: Any
    residuals: Array = field(repr=False)
    _setup: Setup = field(repr=False)
    _fixed: Wavefront = field(repr=False)
    _sensor: Sensor = field(repr=False)

    def at(self, row: ArrayLike, column: ArrayLike) -> tuple[Array, Array]:
        """Return the terms and their standard errors at positions of the image.

        Parameters
        ----------
        row, column : array_like
            Pixels of the camera, as `places`; they broadcast.

        Returns
        -------
        coefficients, errors : ndarray, shape ``(..., k)``
            Radians rms, in the order of `names`.

        Raises
        ------
        TypeError, ValueError
            If a position is not finite or outside of the sensor.
        """
        down, across = validation.broadcast(
            "row and column", validation.real_array("row", row), validation.real_array("column", column)
        )
        u, v = self._sensor.relative(across, down)
        if (np.maximum(np.abs(u), np.abs(v)) > 1.0 + 1e-9).any():
            raise ValueError("row and column must be on the sensor that was stated, got a position outside of it")
        return with_errors(u, v, self.degree, self.coefficients, self.covariance)

    def aberrations(self, row: float, column: float) -> Wavefront:
        """Return the aberrations at a position, with what the fits held fixed, as of :meth:`lommel.Objective.pupil`.

        Parameters
        ----------
        row, column : float

        Returns
        -------
        Wavefront

        Raises
        ------
        TypeError, ValueError
            As :meth:`at`.
        """
        values = self.at(validation.real("row", row), validation.real("column", column))[0]
        edge = {term: value * zernike.rms_factor(*term) for term, value in zip(self.names, values, strict=True)}
        whole = self._fixed.edge_terms() | edge
        return Wavefront.zernike(whole, normalization="edge")

    def pupil(self, row: float, column: float, *, depth: ArrayLike, z: ArrayLike = 0.0) -> ObjectivePupil:
        """Return the pupil at a position, with an emitter at a depth and the stage at z, metres.

        Parameters
        ----------
        row, column : float
        depth, z : array_like
            As of :meth:`lommel.BeadFit.pupil`.

        Returns
        -------
        ObjectivePupil

        Raises
        ------
        TypeError, ValueError
            As :meth:`at`, or if a depth or z is out of range.
        """
        return self._setup.pupil(self.aberrations(row, column), depth, z)

    def __repr__(self) -> str:
        return f"<ObjectiveField: {self.message}>"


def fit_objective_field(
    fits: Sequence[BeadFit], places: ArrayLike, *, sensor: tuple[int, int], degree: int = 2
) -> ObjectiveField:
    """Combine fits of beads all over the image into aberrations of the objective as polynomials of the position.

    Parameters
    ----------
    fits : sequence of BeadFit, n
        Of :func:`lommel.fit_beads`, each of a bead, or of some beads side by side, with the same terms, constants
        and priors. Those that did not converge are left out.
    places : array_like, shape (n, 2)
        Row and column of each in the image.
    sensor : (int, int)
        Rows and columns of the image.
    degree : int, default 2
        Total degree of the polynomials in row and column, 0 to 4, lower where there are fewer than two fits for each
        coefficient.

    Returns
    -------
    ObjectiveField

    Raises
    ------
    TypeError, ValueError
        If fits are of different microscopes or terms, fewer than four converged, or places are outside of the image.

    Notes
    -----
    Of each fit the terms and constants with their covariance are what its images say, and the priors of constants,
    which are taken out of all of them and put in once: a wrong prior is one error, not n. The terms are polynomials
    and the constants are the same all over the field (generalised least squares). What terms differ by beyond their
    errors is `scatter`. Tilts of the field (distortion) and defocus (field curvature) are not in it, for beads have
    unknown places and depths.

    Examples
    --------
    >>> import lommel as lm
    >>> oil = lm.Objective(NA=1.3, magnification=63, immersion=1.518, sample=1.33)
    >>> z, places = np.linspace(-0.6e-6, 0.6e-6, 5), [(0, 0), (0, 999), (999, 0), (999, 999)]
    >>> camera, fits = lm.Noise(read=1.6), []
    >>> for row, column in places:
    ...     wave = lm.Wavefront.zernike({5: 0.2, 7: 3e-4 * column}, order="noll")
    ...     truth = oil.pupil(depth=0.0, z=z, wavelength=600e-9, aberrations=wave)
    ...     bead = camera.record(2e4 * lm.psf(truth, 13, 6.5e-6, tol=1e-4).values + 10, seed=row + column)
    ...     options = {"z": z, "wavelength": 600e-9, "pixel": 6.5e-6, "noise": camera, "priors": {}}
    ...     fits.append(lm.fit_beads(bead, oil, terms=["noll 5", "noll 7"], **options))
    >>> found = fit_objective_field(fits, places, sensor=(1000, 1000), degree=1)
    >>> found.at(500, [100, 900])[0].round(1).tolist()
    [[0.2, 0.0], [0.2, 0.3]]
    """
    if not isinstance(fits, Sequence) or not all(isinstance(one, BeadFit) for one in fits):
        raise TypeError(f"fits must be a sequence of BeadFit, got {validation.shown(fits)}")
    if not (isinstance(sensor, Sequence | np.ndarray) and len(sensor) == 2):
        raise TypeError(f"sensor must be its rows and columns, got {validation.shown(sensor)}")
    rows, columns = (validation.integer("sensor", side, least=1, most=10**6) for side in sensor)
    at = validation.real_array("places", places)
    if at.shape != (len(fits), 2):
        raise ValueError(f"places must be a row and a column for each of {len(fits)} fits, got shape {at.shape}")
    if ((at < -0.5) | (at > np.array([rows, columns]) - 0.5)).any():
        raise ValueError(f"places must be in the image of {rows} x {columns} pixels, got one outside")
    most_degree = validation.integer("degree", degree, least=0, most=_MOST_DEGREE)
    used = np.array([one.converged for one in fits], dtype=bool)
    if used.sum() < 4:
        raise ValueError(f"fits must be at least 4 that converged, got {int(used.sum())} of {len(fits)}")
    first, *_ = kept = [one for one, good in zip(fits, used, strict=True) if good]
    _require_alike(first, kept)
    names = tuple(name for name in first.coefficients if not isinstance(name, str))
    chip = Sensor((rows, columns), 1.0, (0.0, 0.0))
    u, v = chip.relative(at[:, 1], at[:, 0])
    order = highest_degree(most_degree, int(used.sum()))
    basis = monomials(u, v, order)
    waves = np.array([[one.coefficients.get(name, math.nan) for name in names] for one in fits])
    _, apart = robust(basis[used], waves[used], np.ones(int(used.sum())), np.eye(len(names)))
    converged, near = int(used.sum()), inliers(apart)
    if near is not None:
        used[np.flatnonzero(used)[~near]] = False
    joined = _Joined([one for one, good in zip(fits, used, strict=True) if good], names, basis[used])
    most = 4.0 * float(np.sqrt(((waves[used] - waves[used].mean(axis=0)) ** 2).mean())) + 1e-6
    found, scatter, chi2 = fit_scatter(joined.fit, most)
    solution, covariance = found.values * joined.units, found.covariance * np.outer(joined.units, joined.units)
    k, m = len(names), basis.shape[1]
    coefficients = solution[: k * m].reshape(k, m)
    constants = dict(zip(joined.constants, solution[k * m :].tolist(), strict=True))
    setup = first._state.setup.with_constants(constants)
    findings = scatter_findings("terms", "radians rms", scatter, chi2, joined.freedom)
    if lost := converged - len(joined.fits):
        findings.append(Finding("left_out", "note", f"{lost} far off rejected", {"rejected": lost}))
    if converged < len(fits):
        lost = len(fits) - converged
        findings.append(Finding("left_out", "note", f"{lost} did not converge", {"not_converged": lost}))
    fixed = {term: value for term, value in first.aberrations.edge_terms().items() if term not in names}
    return ObjectiveField(
        names=names,
        coefficients=coefficients,
        constants=constants,
        covariance=covariance,
        objective=setup.objective,
        degree=order,
        scatter=scatter,
        chi2=chi2,
        used=used,
        residuals=waves - basis @ coefficients.T,
        findings=Findings(findings),
        summary=f"terms of degree {order} from {len(joined.fits)} fits, chi2 {chi2:.3g}",
        _setup=setup,
        _fixed=Wavefront.zernike(fixed, normalization="edge"),
        _sensor=chip,
    )


def _require_alike(first: BeadFit, fits: Sequence[BeadFit]) -> None:
    """Raise ValueError unless fits are of one microscope."""
    stated = {name: value for name, value in first.coefficients.items() if isinstance(name, str)}
    setup = first._state.setup.with_constants(stated)
    for k, one in enumerate(fits):
        if tuple(one.coefficients) != tuple(first.coefficients):
            raise ValueError(
                f"fits must have the same terms and constants, got {len(one.coefficients)} of fit {k} that differ "
                f"from the {len(first.coefficients)} of the first"
            )
        if one._state.setup.with_constants(stated) != setup or one._priors != first._priors:
            raise ValueError(f"fits must be of one objective, camera, wavelength and priors, got another of fit {k}")


class _Joined:
    """What fits say of polynomials and constants together, the priors of these counted once."""

    def __init__(self, fits: Sequence[BeadFit], names: tuple[Term, ...], basis: Array) -> None:
        self.fits = fits
        self.waves = len(names)
        self.constants = [name for name in fits[0].coefficients if isinstance(name, str)]
        self.scale = np.sqrt(np.diag(fits[0].covariance))
        values = np.array([list(one.coefficients.values()) for one in fits]) / self.scale
        posterior = np.array([np.linalg.inv(one.covariance / np.outer(self.scale, self.scale)) for one in fits])
        prior, mean = np.zeros(len(self.scale)), np.zeros(len(self.scale))
        for j, name in enumerate(self.constants, self.waves):
            given = fits[0]._priors[name]
            prior[j] = (self.scale[j] / given.error) ** 2
            mean[j] = given.value / self.scale[j]
        self.information = posterior - np.diag(prior)
        vectors = np.einsum("nij,nj->ni", posterior, values) - prior * mean
        self.data = np.einsum("nij,nj->ni", np.linalg.pinv(self.information, rcond=1e-9, hermitian=True), vectors)
        c, m = len(self.constants), basis.shape[1]
        size = self.waves * m + c
        self.design = np.zeros((len(fits), self.waves + c, size))
        for j in range(self.waves):
            self.design[:, j, j * m : (j + 1) * m] = basis / self.scale[j]
        for j in range(c):
            self.design[:, self.waves + j, self.waves * m + j] = 1.0
        self.freedom = len(fits) * (self.waves + c) + int((prior > 0.0).sum()) - size
        # Of the parameters, constants in units of `scale`.
        none = np.zeros(self.waves * m)
        self.prior = np.diag(np.concatenate([none, prior[self.waves :]]))
        self.mean = np.concatenate([none, mean[self.waves :]])
        self.units = np.concatenate([none + 1.0, self.scale[self.waves :]])

    def fit(self, scatter: float) -> LinearFit:
        """Return the fit for a standard deviation of terms about the polynomials."""
        k, weight = self.waves, self.information
        if scatter > 0.0:
            loose = np.diag((self.scale[:k] / scatter) ** 2) + weight[:, :k, :k]
            weight = weight - weight[:, :, :k] @ np.linalg.solve(loose, weight[:, :k])
        return least_squares(self.design, self.data, weight, self.prior, self.mean, self.freedom)
