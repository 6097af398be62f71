"""The paper's closed-form integral solution (CFIS), Eq. 6-14 and 18-23, and the same refined to a tolerance."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.core import engine
from lommel.core.answers import Declined, FieldValues, Intensities, ToleranceError
from lommel.methods.method import FieldMethod, annulus, powers_cancel, relative_error
from lommel.methods.nijboer_zernike import NijboerZernike
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil, checked
from lommel.special.bessel import j0_series, tangent_line
from lommel.special.erf import AbramowitzErf, Erf, FresnelErf, chirp_moments, unit_moments
from lommel.special.legendre import gauss_panels
from lommel.special.piecewise import FITS, SPLITS, PiecewiseQuadratic, fit_quadratics

# Of the tuned form.
_TRANSITION, _TERMS = 10.0, 10  # of Hankel's expansion, whose remainder is then below 1e-8 of J0
_KERNEL = 1e-10  # error of the Fresnel integral's polynomial
_POINTS = 16
_MAX_SEGMENTS = 4096


@dataclass(frozen=True)
class ClosedForm(FieldMethod[Pupil]):
    r"""Piecewise Bessel approximation integrated in closed form: approximate, with the paper's parameters.

    Supports every pupil: aberrations beyond defocus by piecewise quadratic phases, an obscuration by the difference
    of two disks. Errors of 20 to 40 % of the peak are intrinsic to Eq. (8) and (9); no bound is claimed.

    Parameters
    ----------
    tangent : float, default 100
        Tangent-line centre of Eq. (9), in units of the argument ``2 pi k R`` of the Bessel function.
    erf : Erf, default FresnelErf()
        `AbramowitzErf` (Eq. 14), `TableErf` (the lookup table the paper proposes) or `FresnelErf` (exact).
    transition : float, default 1
        Argument at which the power series (6) gives way to the asymptotic form (7).
    terms : int, default 3
        Terms of the power series (6), 1 to 60.
    variant : {"corrected", "printed"}, default "corrected"
        "corrected" keeps the factor ``sqrt(2/pi)`` of Eq. (7) in the outer integral of Eq. (12); "printed"
        drops it, as Eq. (12) is printed and as the paper's own figures were made.
    truncate : float, optional
        Optical coordinate v beyond which the PSF is set to zero, as the paper's section 3 suggests.
    segments : int, default 16
        Number N of quadratic phases in Eq. (17), where there is more than defocus.
    split : {"optimal", "linear", "sqrt", "log"}, default "optimal"
        Where they meet; see :func:`lommel.special.piecewise.split_edges`.
    fit : {"interpolation", "least-squares", "sweep"}, default "interpolation"
        How they are found; see :func:`lommel.special.piecewise.fit_quadratics`.
    piston : bool, default True
        Whether they have the constants gamma_i, which Eq. (17) leaves out.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.

    Notes
    -----
    Errata of the printed paper, found against adaptive quadrature of its integrands:

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

    All of (21)-(23) reduce to the chirp moments of :func:`lommel.special.erf.chirp_moments`, whose error
    function has its argument on the rays of +-45 degrees always.
    """

    tangent: float = 100.0
    erf: Erf = field(default_factory=FresnelErf)
    transition: float = 1.0
    terms: int = 3
    variant: str = "corrected"
    truncate: float | None = None
    segments: int = 16
    split: str = "optimal"
    fit: str = "interpolation"
    piston: bool = True

    def __post_init__(self) -> None:
        object.__setattr__(self, "tangent", validation.real("tangent", self.tangent, above=0.0))
        object.__setattr__(self, "transition", validation.real("transition", self.transition, above=0.0, below=50.0))
        object.__setattr__(self, "terms", validation.integer("terms", self.terms, least=1, most=60))
        validation.choice("variant", self.variant, ("corrected", "printed"))
        if not isinstance(self.erf, Erf):
            raise TypeError(f"erf must be AbramowitzErf, TableErf or FresnelErf, got {validation.shown(self.erf)}")
        if self.truncate is not None:
            object.__setattr__(self, "truncate", validation.real("truncate", self.truncate, above=0.0))
        object.__setattr__(self, "segments", validation.integer("segments", self.segments, least=1, most=4096))
        validation.choice("split", self.split, SPLITS)
        validation.choice("fit", self.fit, FITS)
        validation.truth("piston", self.piston)

    @classmethod
    def best(cls, pupil: Pupil, shape: int | tuple[int, int], pixel: float, **options: Any) -> ClosedForm:
        """Return the form with the tangent-line centre and the number of erf terms that serve a window best.

        The centre minimises the mean squared error over the window, against :class:`NijboerZernike`: a scan from 1
        to four times the largest argument, refined around its best. The error function is Eq. (14) with the fewest
        terms, in fives, that come within one per cent of that minimum; the exact one where 200 do not.

        Parameters
        ----------
        pupil : Pupil
            A single pupil.
        shape, pixel
            As of :func:`lommel.psf`.
        **options
            Of the form, `tangent` and `erf` excepted.
        """
        from scipy.optimize import minimize_scalar

        if checked(pupil).shape != ():
            raise ValueError(f"pupil must be a single one, got a stack of shape {pupil.shape}")
        if {"tangent", "erf"} & set(options):
            raise TypeError("options must not name tangent and erf, which are what is looked for")
        grid = Grid(shape, pixel)
        grid.require_reach(pupil)
        # Every radius of a small window, some of a large one; each weighs the pixels from it to the next.
        count = grid.radii.size
        chosen = np.unique(np.linspace(0, count - 1, min(count, 600)).astype(int))
        v, weight = grid.v(pupil)[chosen], np.add.reduceat(grid.multiplicity, chosen)
        exact = NijboerZernike().profile(pupil, v).values[0]

        def error(tangent: float, erf: Erf) -> float:
            values = cls(tangent=tangent, erf=erf, **options).profile(pupil, v).values[0]
            return float(np.average((values - exact) ** 2, weights=weight) / exact.max() ** 2)

        scan = np.geomspace(1.0, 4.0 * max(1.0, float(v[-1])), 48)
        start = int(np.argmin([error(float(t), FresnelErf()) for t in scan]))
        around = np.log(scan[max(0, start - 1)]), np.log(scan[min(scan.size - 1, start + 1)])
        found = minimize_scalar(
            lambda x: error(math.exp(x), FresnelErf()), bounds=around, method="bounded", options={"xatol": 1e-3}
        )
        least, tangent = min((error(t, FresnelErf()), t) for t in (math.exp(found.x), float(scan[start])))
        for terms in range(5, 205, 5):
            if error(tangent, AbramowitzErf(terms)) <= 1.01 * least:
                return cls(tangent=tangent, erf=AbramowitzErf(terms), **options)
        return cls(tangent=tangent, erf=FresnelErf(), **options)

    def stretch(self, pupil: Pupil) -> float:
        """Return 8: the form changes at `transition` and where its pieces meet, and is band-limited nowhere."""
        return 8.0

    def unsupported(self, pupil: Pupil) -> str | None:
        """Return the reason where powers of rho do not hold the phase."""
        return powers_cancel(pupil)

    def evaluate(self, pupil: Pupil, v: Array) -> FieldValues:
        """Return U at rising v; no bound is claimed."""
        result = annulus(self._disk, pupil, v)
        if self.truncate is not None:
            result.values[:, v > self.truncate] = 0.0
        return result

    def sub_integrals(self, defocus: float, v: Array) -> NDArray[np.complex128]:
        r"""Return the integrals of the appendix for a `defocus` C_d at `v` above 0; U is twice their sum.

        Their shape is ``(terms + 3, len(v))``.

        In rho = R / R_max, so ``alpha = 2 C_d``, ``beta = v`` and ``T = transition / v``, at most 1. The first
        `terms` are 1, 2, 3 ... of the appendix (Eq. 18-20), with their coefficients from Eq. (6); the last three
        are 4, 5 and 6 (Eq. 21-23), times ``sqrt(2/pi)`` in the corrected variant.
        """
        alpha = 2.0 * defocus
        with np.errstate(divide="ignore", over="ignore"):
            split = np.minimum(self.transition / v, 1.0)
        m = np.arange(self.terms)[:, None]
        factorials = np.array([math.factorial(k) for k in range(self.terms)], dtype=np.float64)[:, None]
        # In x = R / T, where the powers of v T, at most the transition, cannot overflow.
        moments = split**2 * unit_moments(alpha * split**2, self.terms)
        inner = (-0.25 * (v * split) ** 2) ** m / factorials**2 * moments
        outer = np.zeros((3, v.size), dtype=np.complex128)
        beyond = split < 1.0
        outer[:, beyond] = self._beyond(v[beyond], alpha, 0.0, split[beyond], 1.0)
        return np.concatenate([inner, outer])

    def _disk(self, coefficients: Array, v: Array) -> FieldValues:
        rows = []
        for c in coefficients:
            if np.any(c[1:]):
                pieces = fit_quadratics(c.tolist(), self.segments, split=self.split, fit=self.fit, piston=self.piston)
                rows.append(2.0 * self._piecewise(pieces, v))
            else:
                rows.append(2.0 * self.sub_integrals(0.5 * float(c[0]), v).sum(axis=0))
        return FieldValues(np.stack(rows), None)

    def _piecewise(self, pieces: PiecewiseQuadratic, v: Array) -> NDArray[np.complex128]:
        """Return the sum of all integrals over segments with phases alpha R^2 + beta R + gamma (Eq. 17)."""
        with np.errstate(divide="ignore", over="ignore"):
            split = np.minimum(self.transition / v, 1.0)
        total = np.zeros(v.size, dtype=np.complex128)
        for i, (low, high) in enumerate(pairwise(pieces.edges.tolist())):
            alpha, beta = float(pieces.alpha[i]), float(pieces.beta[i])
            part = np.zeros(v.size, dtype=np.complex128)
            inside = split > low
            if np.any(inside):
                part[inside] = self._within(v[inside], alpha, beta, low, np.minimum(split[inside], high))
            beyond = split < high
            if np.any(beyond):
                start = np.maximum(split[beyond], low)
                part[beyond] += self._beyond(v[beyond], alpha, beta, start, high).sum(axis=0)
            total += np.exp(1j * pieces.gamma[i]) * part
        return total

    def _beyond(self, v: Array, alpha: float, beta: float, low: Array, high: float) -> NDArray[np.complex128]:
        """Return the integrals of the asymptotic form (Eq. 7) with the tangent line (Eq. 9), in three parts."""
        a, b = tangent_line(self.tangent)
        parts = np.zeros((3, v.size), dtype=np.complex128)
        for sign in (1.0, -1.0):
            m = chirp_moments(alpha, beta + sign * v, low, high, erf=self.erf)
            parts += 0.5 * np.exp(-0.25j * sign * math.pi) * np.stack([a * v * m[2], b * m[1], m[0] / v])
        return parts * math.sqrt(2.0 / math.pi) if self.variant == "corrected" else parts

    def _within(self, v: Array, alpha: float, beta: float, low: float, high: Array) -> NDArray[np.complex128]:
        """Return the integral of the power series (Eq. 6) up to the transition, by quadrature of its moments."""
        span = (abs(alpha) * (low + high.max()) + abs(beta)) * float((high - low).max())
        x, w = gauss_panels(24 + self.terms // 2 + math.ceil(0.6 * span))
        radius = low + (high - low)[:, None] * x
        wave = w * (high - low)[:, None] * radius * np.exp(1j * radius * (alpha * radius + beta))
        return np.asarray((wave * j0_series(v[:, None] * radius, self.terms)).sum(axis=1))


@dataclass(frozen=True)
class TunedClosedForm(FieldMethod[Pupil]):
    r"""The closed form with all approximations refined to meet a tolerance; slower than the default.

    It shows what the closed form can reach: any practical accuracy, at more than a hundred times the cost of
    :class:`NijboerZernike`.

    Parameters
    ----------
    tol : float, default 1e-4
        Bound on ``max|I - I_exact| / max I`` over the window, 1e-6 to 1e-1. :class:`ToleranceError` is raised where
        it cannot be met: near 1e-6, and for phases of hundreds of radians.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.

    Notes
    -----
    Eq. (8) with the transition at a = 10 and ten terms of Hankel's expansion (DLMF 10.17.3) instead of one; Eq. (9)
    by quadratics at the Chebyshev points of pieces of a that grow geometrically, instead of one tangent line; Eq.
    (17) by interpolation with the constant gamma_i, on ``R_i = (i/S)^(3/4)``; Eq. (13) by real Fresnel integrals.
    Each piece is then exact. The pieces are chosen from bounds on their interpolation, ``|f'''| h^3 / 192``, so that

    - a relative error delta of ``1/sqrt(a)`` changes U by at most ``1.1 delta / sqrt(10)``,
    - an error of the phase changes U by at most itself.

    Roundings and the Fresnel polynomial (1e-10) are estimated, not proven.
    """

    least_tol = 1e-6
    tol: float = 1e-4

    def unsupported(self, pupil: Pupil) -> str | None:
        """Return the reason where powers of rho do not hold the phase."""
        return powers_cancel(pupil)

    def evaluate(self, pupil: Pupil, v: Array) -> FieldValues:
        """Return U at rising v with the bound on its error."""
        return self._fields(pupil, v, self._error(pupil))

    def profile(self, pupil: Pupil, v: Array) -> Intensities:
        """Return I at rising v; the bound is checked against the peak that was found."""
        error = self._error(pupil)
        for _ in range(4):
            intensity, bound = self._intensities(pupil, v, error)
            relative, peak = relative_error(intensity, bound), intensity.max(axis=1)
            if relative.max() <= self.tol:
                return Intensities(intensity, relative, peak)
            error *= 0.2
        raise ToleranceError(
            f"tol={self.tol:g} cannot be met: the error bound stays at {relative.max():.2g} of the largest value"
        )

    def _error(self, pupil: Pupil) -> float:
        """Return the error in U that serves the tolerance, from the peak on a scan of the rays at a tenth of it."""
        phases = float(np.abs(pupil.coefficients()).sum(axis=1).max())
        reach = float(pupil.v(pupil.geometric_radius()).max()) + 4.0
        rough = 0.05 * pupil.area / (2.0 * phases + 1.0)
        scan = self._fields(pupil, np.linspace(0.0, reach, 48), rough)
        peak = max(float(np.abs(scan.values).max(axis=1).min()), pupil.area / (2.0 * phases + 1.0))
        return 0.2 * self.tol * peak

    def _fields(self, pupil: Pupil, v: Array, error: float) -> FieldValues:
        def disk(coefficients: Array, at: Array) -> FieldValues:
            rows = [_field(c, np.ascontiguousarray(at), error) for c in coefficients]
            return FieldValues(np.stack([row[0] for row in rows]), np.array([row[1] for row in rows]))

        return annulus(disk, pupil, v)

    def _intensities(self, pupil: Pupil, v: Array, error: float) -> tuple[Array, Array]:
        """Return I and the bound on U; through pieces of degree 15, as NijboerZernike, where those are fewer."""
        reach = float(v[-1]) if v.size else 0.0
        width = 4.0 * (0.1 * error * math.factorial(_POINTS)) ** (1.0 / _POINTS)
        pieces = max(1, math.ceil(reach / width))
        if pieces * _POINTS >= v.size:
            values, bound = self._fields(pupil, v, error)
            assert bound is not None
            return values.real**2 + values.imag**2, bound
        angles = np.pi * (np.arange(_POINTS)[::-1] + 0.5) / _POINTS
        to_coefficients = 2.0 / _POINTS * np.cos(angles[:, None] * np.arange(_POINTS))
        to_coefficients[:, 0] *= 0.5
        at = (width * (np.arange(pieces)[:, None] + 0.5 * (1.0 + np.cos(angles)))).ravel()
        values, bound = self._fields(pupil, at, error)
        assert bound is not None
        coefficients = values.reshape(-1, pieces, _POINTS) @ to_coefficients
        intensity = np.stack([engine.chebyshev_intensity(np.ascontiguousarray(c), width, v) for c in coefficients])
        # The Lebesgue constant of 16 points, and the error of interpolation.
        return intensity, 2.77 * bound + 2.0 * (0.25 * width) ** _POINTS / math.factorial(_POINTS)


def _field(coefficients: Array, v: Array, error: float) -> tuple[NDArray[np.complex128], float]:
    """Return U of one full disk and the bound on its error."""
    # Half for the amplitude: |f'''| h^3 / 192 for f = sqrt(a) on [a, r a] is 0.00196 (r - 1)^3 of it, and the slowly
    # varying P + iQ adds less than a third.
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
                    f"aberrations of {strength:.3g} rad take {segments} quadratic phases, more than the limit of "
                    f"{_MAX_SEGMENTS}"
                )
            fit = fit_quadratics(coefficients.tolist(), segments)
            assert fit.bound is not None
            if fit.bound <= 0.4 * error:
                break
            segments = math.ceil(1.3 * segments)
    assert fit.bound is not None
    values = engine.closed_form_field(fit.edges, fit.alpha, fit.beta, fit.gamma, _TRANSITION, ratio, _TERMS, v)
    pieces = fit.alpha.size + math.log(max(1.0, float(v[-1]) / _TRANSITION)) / math.log(ratio) if v.size else 1.0
    # The remainder of Hankel's expansion is at most its first neglected terms, here below 4e-9 of U.
    return values, amplitude + fit.bound + 4e-9 + _KERNEL * math.sqrt(pieces)
