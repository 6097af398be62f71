"""Closed-form integral solution (CFIS) of the paper cited in docs/paper.md, and its refinement to a tolerance.

Equation numbers are those of the paper. R is the pupil radius, a the argument of the Bessel function J0.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import lru_cache
from typing import ClassVar

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.base.cached import cached_property
from lommel.core import engine
from lommel.core.answers import Declined, FieldValues, Intensities, ToleranceError
from lommel.methods.method import FieldMethod, annulus, powers_cancel, relative_error, squared
from lommel.methods.nijboer_zernike import NijboerZernike
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil, checked
from lommel.special.bessel import tangent_line
from lommel.special.erf import AbramowitzErf, Erf, FresnelErf
from lommel.special.interpolation import chebyshev_powers
from lommel.special.piecewise import fit_quadratics, fit_stack

_WIDTH, _POINTS = 8.0, 24  # width (v) and number of points of an interpolation of U with an error below 1e-15
_MIN_SAVED = 400  # number of radii that interpolation must save, times the number of quadratic phases
# Constants of the tuned form.
_TRANSITION, _TERMS = 10.0, 10  # smallest a, and number of terms, of Hankel's expansion of J0; remainder < 1e-8
_SERIES = 28  # number of terms of the power series below the transition; truncation error below rounding errors
_MOMENT_ERROR = 1e-10  # estimated error of a chirp moment: moments lose digits if the phase has little curvature
_MAX_SEGMENTS = 4096  # largest number of quadratic phases


@dataclass(frozen=True)
class ClosedForm(FieldMethod[Pupil]):
    r"""Piecewise Bessel approximation integrated in closed form: approximate, with the paper's parameters.

    Supports uniformly illuminated circular and annular apertures with radially symmetric aberrations. Aberrations
    other than defocus are approximated by piecewise quadratic phases. Eq. (8) and (9) cause errors of 20 to 40 % of
    the peak; there is no error bound.

    Parameters
    ----------
    tangent : float, default 100
        Centre of the tangent line of Eq. (9), as a value of the argument ``2 pi k R`` of the Bessel function.
    erf : Erf, default FresnelErf()
        `AbramowitzErf` (Eq. 14), `TableErf` (the lookup table that the paper proposes) or `FresnelErf` (exact to
        about 1e-13).
    variant : {"corrected", "printed"}, default "corrected"
        "corrected" keeps the factor ``sqrt(2/pi)`` of Eq. (7) in the outer integral of Eq. (12); "printed"
        drops it, as Eq. (12) is printed and as the paper's own figures were made.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.

    Notes
    -----
    Errata of the printed paper, found by comparison with adaptive quadrature of its integrands:

    =============  ===========================================  ====================================
    equation       printed                                      correct
    =============  ===========================================  ====================================
    Eq. 8 to 12    sqrt(2/pi) of (7) dropped in the outer       outer integral carries sqrt(2/pi)
                   integral
    Eq. 13         (1/2) sqrt(2/a)                              (1/2) sqrt(pi/a)
    Eq. 15 to 17   exp[...] called a phase; i, j mixed;         Phi_s = C_s rho^4; the piston only
                   piston -C_d inside the exponential           turns U
    Eq. 21         signs of the last end-point term of each     those terms with the opposite sign,
                   bracket, and of the whole                    then the whole negated
    Eq. 22         prefactor beta/2                             prefactor B_tl/2
    Eq. 23         exp(-pi/4), exp(+pi/4)                       exp(-i pi/4), exp(+i pi/4)
    =============  ===========================================  ====================================

    All of (21)-(23) reduce to moments of the chirp ``exp(i (a R^2 + b R))``. The arguments of the error function then
    always lie on the rays at +-45 degrees.
    """

    tangent: float = 100.0
    erf: Erf = field(default_factory=FresnelErf)
    variant: str = "corrected"
    transition: ClassVar[float] = 1.0
    """Argument at which the asymptotic form (7) replaces the power series (6)."""
    terms: ClassVar[int] = 3
    """Number of terms of the power series (6)."""
    segments: ClassVar[int] = 16
    """Number of quadratic phases in Eq. (17), for pupils with aberrations other than defocus."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "tangent", validation.real("tangent", self.tangent, above=0.0))
        validation.choice("variant", self.variant, ("corrected", "printed"))
        if not isinstance(self.erf, Erf):
            raise TypeError(f"erf must be AbramowitzErf, TableErf or FresnelErf, got {validation.shown(self.erf)}")

    @classmethod
    def best(cls, pupil: Pupil, shape: int | tuple[int, int], pixel: float, variant: str = "corrected") -> ClosedForm:
        """Return the form with the best tangent-line centre, and the best number of erf terms, for a window.

        The centre minimizes the mean squared difference from :class:`~lommel.methods.NijboerZernike` over the window.
        It is searched between 1 and four times the largest v, then refined around the best value. `erf` is Eq. (14)
        with the fewest terms (5, 10, ... 200) whose mean squared error is at most 1 % above the minimum, else
        `FresnelErf`.

        Parameters
        ----------
        pupil : Pupil
            A single pupil.
        shape, pixel
            As for :func:`lommel.psf`.
        variant : {"corrected", "printed"}, default "corrected"
            As for the form.
        """
        if checked(pupil).shape != ():
            raise ValueError(f"pupil must be a single one, got a stack of shape {pupil.shape}")
        grid = Grid(shape, pixel)
        grid.require_reach(pupil)
        # At most 600 radii of the window; the weight of a radius is the number of pixels up to the next radius.
        count = grid.radii.size
        subset = np.unique(np.linspace(0, count - 1, min(count, 600)).astype(int))
        v, weight = grid.v(pupil)[subset], np.add.reduceat(grid.multiplicity, subset)
        exact = NijboerZernike().profile(pupil, v).values[0]

        def error(tangent: float, erf: Erf) -> float:
            values = cls(tangent, erf, variant).profile(pupil, v).values[0]
            return float(np.average((values - exact) ** 2, weights=weight) / exact.max() ** 2)

        scan = np.geomspace(1.0, 4.0 * max(1.0, float(v[-1])), 48)
        start = int(np.argmin([error(float(t), FresnelErf()) for t in scan]))
        bounds = np.log(scan[max(0, start - 1)]), np.log(scan[min(scan.size - 1, start + 1)])
        optimum = scipy.optimize.minimize_scalar(
            lambda x: error(math.exp(x), FresnelErf()), bounds=bounds, method="bounded", options={"xatol": 1e-3}
        )
        least_error, tangent = min((error(t, FresnelErf()), t) for t in (math.exp(optimum.x), float(scan[start])))
        for terms in range(5, 205, 5):
            if error(tangent, AbramowitzErf(terms)) <= 1.01 * least_error:
                return cls(tangent, AbramowitzErf(terms), variant)
        return cls(tangent, FresnelErf(), variant)

    def stretch(self, pupil: Pupil) -> float:
        """Return 8, a nominal value: U is not band-limited, as it jumps at `transition` and between pieces."""
        return 8.0

    def unsupported(self, pupil: Pupil) -> str | None:
        """Return the reason why powers of rho would lose too many digits of the phase, else None."""
        return powers_cancel(pupil)

    def evaluate(self, pupil: Pupil, v: Array) -> FieldValues:
        """Return U at rising v, without an error bound."""
        return self._fields(pupil, v, 1)

    def _threaded_profile(self, pupil: Pupil, v: Array, threads: int) -> Intensities:
        return squared(self._fields(pupil, v, threads))

    def _fields(self, pupil: Pupil, v: Array, threads: int) -> FieldValues:
        def disk(coefficients: Array, points: Array) -> FieldValues:
            return FieldValues(self._disk(coefficients, points, threads), None)

        return annulus(disk, pupil, v)

    def _disk(self, coefficients: Array, v: Array, threads: int) -> NDArray[np.complex128]:
        """Return U of full disks: with one quadratic phase for defocus alone, else with `segments` (Eq. 17)."""
        aberrated = coefficients[:, 1:].any(axis=1)
        any_aberrated = bool(aberrated.any())
        if any_aberrated and not aberrated.all():
            field = np.empty((aberrated.size, v.size), dtype=np.complex128)
            for subset in (aberrated, ~aberrated):
                field[subset] = self._disk(coefficients[subset], v, threads)
            return field
        if any_aberrated:
            edges, rows = fit_stack(coefficients, self.segments, "optimal", "interpolation", piston=True)
        else:
            edges, rows = np.array([0.0, 1.0]), coefficients[:, None, :1] * [1.0, 0.0, 0.0]
        phase, bessel = _phase(edges, rows), self._bessel

        def fields(points: Array) -> NDArray[np.complex128]:
            return engine.closed_form_fields(phase, (*bessel, self.terms), self.erf.compiled, points, threads)

        if not isinstance(self.erf, FresnelErf):
            return fields(v)
        # For v > `start` the transition lies in the first segment. Its contribution to U then varies slowly with 1/v;
        # all other contributions are of exponential type 1.
        alpha, beta = np.abs(rows[:, 0, :2]).max(axis=0).tolist()
        start = max(16.0, self.transition / edges[1], (8.0 * alpha * self.transition**2) ** (1 / 3))
        start = max(start, math.sqrt(6.0 * beta * self.transition))
        return interpolated(fields, v, start, _WIDTH, threads, min_saved=_MIN_SAVED // rows[..., 0].size)

    @cached_property
    def _bessel(self) -> tuple[Array, NDArray[np.complex128]]:
        """Start of the asymptotic form (Eq. 7), and coefficients of its quadratic, with the tangent line (Eq. 9)."""
        a, b = tangent_line(self.tangent)
        return np.array([self.transition]), self._factor * np.array([[1.0, b, a]], dtype=np.complex128)

    @property
    def _factor(self) -> float:
        """Factor of the outer integral: sqrt(2/pi) of Eq. (7), or 1."""
        return math.sqrt(2.0 / math.pi) if self.variant == "corrected" else 1.0


def _phase(edges: Array, rows: Array) -> tuple[Array, Array, Array, NDArray[np.complex128]]:
    """Return edges and coefficients of quadratic phases for the compiled core, with ``2 exp(i gamma)`` for gamma."""
    alpha, beta = np.ascontiguousarray(rows[..., 0]), np.ascontiguousarray(rows[..., 1])
    return edges, alpha, beta, 2.0 * np.exp(1j * rows[..., 2])


def interpolated(
    fields: Callable[[Array], NDArray[np.complex128]],
    v: Array,
    start: float,
    width: float,
    threads: int,
    min_saved: int = 0,
) -> NDArray[np.complex128]:
    """Return fields at rising `v`, interpolated for v >= `start` if this saves more than `min_saved` radii."""
    count = int(np.searchsorted(v, start))
    pieces = max(1, math.ceil((v[-1] - start) / width)) if count < v.size else 0
    if pieces * _POINTS + min_saved >= v.size - count:
        return fields(v)
    width = (v[-1] - start) / pieces
    nodes, to_series, to_powers = _points()
    points = start + width * (np.arange(pieces)[:, None] + nodes)
    values = fields(np.concatenate([v[:count], points.ravel()]))
    powers = values[:, count:].reshape(-1, pieces, _POINTS) @ to_series @ to_powers
    tail = engine.polynomial_fields(powers, start, width, v[count:], threads)
    return np.concatenate([values[:, :count], tail], axis=1) if count else tail


@lru_cache(maxsize=1)
def _points() -> tuple[Array, Array, Array]:
    """Return the Chebyshev points of [0, 1], rising, and the matrices from values to series and series to powers."""
    angles = np.pi * (np.arange(_POINTS)[::-1] + 0.5) / _POINTS
    to_series = 2.0 / _POINTS * np.cos(angles[:, None] * np.arange(_POINTS))
    to_series[:, 0] *= 0.5
    return 0.5 * (1.0 + np.cos(angles)), to_series, chebyshev_powers(_POINTS).T


@dataclass(frozen=True)
class TunedClosedForm(FieldMethod[Pupil]):
    r"""The closed form with all approximations refined to meet a tolerance; slower than the default.

    It takes tens of times as long as :class:`~lommel.methods.NijboerZernike`, or longer.

    Parameters
    ----------
    tol : float, default 1e-4
        Bound on ``max abs(I - I_exact) / max I`` over the window, 1e-6 to 1e-1. :class:`~lommel.ToleranceError` is
        raised if `tol` cannot be met: near 1e-6, and for phases of hundreds of radians.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.

    Notes
    -----
    Changes to the paper's equations: Eq. (8) has its transition at a = 10, and ten terms of Hankel's expansion (DLMF
    10.17.3) instead of one. Eq. (9) has quadratics through Chebyshev points on pieces of a, not one tangent line; the
    lengths of the pieces grow geometrically. Eq. (17) includes the constants gamma_i; the boundaries of its S
    segments are ``R_i = (i/S)^(3/4)``. Eq. (13) uses real Fresnel integrals. The integral over each piece is then
    exact. The interpolation error ``abs(f''') h^3 / 192`` of a function f on a piece of length h determines the
    pieces:

    - a relative error delta of the amplitude ``1/sqrt(a)`` changes U by at most ``1.1 delta / sqrt(10)``,
    - a phase error (radians) changes U by at most the same amount.

    Rounding errors, about 1e-10 for each piece, are estimated, not bounded.
    """

    least_tol = 1e-6
    tol: float = 1e-4

    def unsupported(self, pupil: Pupil) -> str | None:
        """Return the reason why powers of rho would lose too many digits of the phase, else None."""
        return powers_cancel(pupil)

    def evaluate(self, pupil: Pupil, v: Array) -> FieldValues:
        """Return U at rising v with its error bound."""
        return self._fields(pupil, v, self._error(pupil))

    def profile(self, pupil: Pupil, v: Array) -> Intensities:
        """Return I at rising v; the error bound is relative to the computed peak."""
        error = self._error(pupil)
        for _ in range(4):
            intensity, bound = self._intensities(pupil, v, error)
            relative, peak = relative_error(intensity, bound), intensity.max(axis=1)
            if relative.max() <= self.tol:
                return Intensities(intensity, relative, peak)
            error *= 0.2
        raise ToleranceError(
            f"tol={self.tol:g} cannot be met: the error bound stays at {relative.max():.2g} of the largest value; "
            "use a larger tol or another method"
        )

    def _error(self, pupil: Pupil) -> float:
        """Return the allowed error of U, from `tol` and the peak of a rough profile up to the outermost ray."""
        phases = float(np.abs(pupil.coefficients()).sum(axis=1).max())
        largest_v = float(pupil.v(pupil.geometric_radius()).max()) + 4.0
        rough_error = 0.05 * pupil.area / (2.0 * phases + 1.0)
        scan = self._fields(pupil, np.linspace(0.0, largest_v, 48), rough_error)
        peak = max(float(np.abs(scan.values).max(axis=1).min()), pupil.area / (2.0 * phases + 1.0))
        return 0.2 * self.tol * peak

    def _fields(self, pupil: Pupil, v: Array, error: float) -> FieldValues:
        def disk(coefficients: Array, points: Array) -> FieldValues:
            rows = [_field(c, np.ascontiguousarray(points), error) for c in coefficients]
            return FieldValues(np.stack([row[0] for row in rows]), np.array([row[1] for row in rows]))

        return annulus(disk, pupil, v)

    def _intensities(self, pupil: Pupil, v: Array, error: float) -> tuple[Array, Array]:
        """Return I and the error bound of U; U is interpolated if this requires fewer evaluations."""
        width = 4.0 * (0.1 * error * math.factorial(_POINTS)) ** (1.0 / _POINTS)
        bounds = []

        def fields(points: Array) -> NDArray[np.complex128]:
            values, bound = self._fields(pupil, points, error)
            assert bound is not None
            # 3.03: Lebesgue constant of the points. The second term is the error of interpolation.
            bounds.append(
                bound if points is v else 3.03 * bound + 2.0 * (0.25 * width) ** _POINTS / math.factorial(_POINTS)
            )
            return values

        values = interpolated(fields, v, 0.0, width, 1)
        return values.real**2 + values.imag**2, bounds[0]


def _field(coefficients: Array, v: Array, error: float) -> tuple[NDArray[np.complex128], float]:
    """Return U of one full disk, with its error bound."""
    # Half of the error is for the amplitude. For f = sqrt(a) on [a, r a], |f'''| h^3 / 192 is 0.00196 (r - 1)^3 f;
    # the slowly varying factor P + iQ of Hankel's expansion increases this by less than a third.
    delta = 0.5 * error * math.sqrt(_TRANSITION) / 1.1
    ratio = 1.0 + min(0.6, (delta / 0.0026) ** (1.0 / 3.0))
    amplitude = 1.1 / math.sqrt(_TRANSITION) * 0.0026 * (ratio - 1.0) ** 3
    fit = fit_quadratics(coefficients[:1].tolist(), 1)
    if np.any(coefficients[1:]):
        strength = float(np.abs(coefficients[1:]).sum())
        segments = max(1, math.ceil(0.38 * (strength / (0.4 * error)) ** (1.0 / 3.0)))
        while True:
            if segments > _MAX_SEGMENTS:
                raise Declined(
                    f"aberrations of {strength:.3g} rad need {segments} quadratic phases, more than the limit of "
                    f"{_MAX_SEGMENTS}; use a larger tol"
                )
            fit = fit_quadratics(coefficients.tolist(), segments)
            assert fit.bound is not None
            if fit.bound <= 0.4 * error:
                break
            segments = math.ceil(1.3 * segments)
    assert fit.bound is not None
    starts, quadratics = _hankel_pieces(ratio, float(v[-1]) if v.size else 0.0)
    phase = _phase(fit.edges, np.stack([fit.alpha, fit.beta, fit.gamma], axis=-1)[None])
    values = engine.closed_form_fields(phase, (starts, quadratics, _SERIES), FresnelErf().compiled, v, 1)[0]
    pieces = fit.alpha.size + starts.size
    # The remainder of Hankel's expansion is at most its first neglected terms, here below 4e-9 of U.
    return values, amplitude + fit.bound + 4e-9 + _MOMENT_ERROR * math.sqrt(pieces)


def _hankel_pieces(ratio: float, largest_v: float) -> tuple[Array, NDArray[np.complex128]]:
    """Return starts of geometric pieces of x up to `largest_v`, and quadratics in x for the amplitude of x J0(x)."""
    # Each quadratic interpolates values of Hankel's expansion at three Chebyshev points of the piece.
    count = max(1, math.ceil(math.log(max(1.0, largest_v / _TRANSITION)) / math.log(ratio)))
    starts = np.asarray(_TRANSITION * ratio ** np.arange(count), dtype=np.float64)
    x = starts * (0.5 * (1.0 + ratio) + 0.5 * (ratio - 1.0) * np.cos(np.pi * np.array([5, 3, 1]) / 6)[:, None])
    # P + i Q of order 0 (DLMF 10.17): sum_k (i / x)^k a_k with a_k = prod_(j=1..k) (-(2j-1)^2) / (8 j).
    j = np.arange(1.0, _TERMS)
    terms = np.cumprod(np.append(1.0, -((2.0 * j - 1.0) ** 2) / (8.0 * j)))
    f = np.sqrt(2.0 / np.pi * x) * np.polynomial.polynomial.polyval(1j / x, terms)
    slope, next_slope = ((f[k + 1] - f[k]) / (x[k + 1] - x[k]) for k in (0, 1))
    c2 = (next_slope - slope) / (x[2] - x[0])
    c1 = slope - c2 * (x[0] + x[1])
    return starts, np.stack([f[0] - (c1 + c2 * x[0]) * x[0], c1, c2], axis=1)
