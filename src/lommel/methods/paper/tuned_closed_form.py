"""The paper's closed form, refined until a tolerance is met."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.core import engine
from lommel.core.answers import Declined, FieldValues, Intensities, ToleranceError
from lommel.methods.method import FieldMethod, annulus, powers_cancel, relative_error
from lommel.optics.pupil import Pupil
from lommel.special.piecewise import fit_quadratics

_TRANSITION, _TERMS = 10.0, 10  # of Hankel's expansion, whose remainder is then below 1e-8 of J0
_KERNEL = 1e-10  # error of the Fresnel integral's polynomial
_POINTS = 16
_MAX_SEGMENTS = 4096


@dataclass(frozen=True)
class TunedClosedForm(FieldMethod[Pupil]):
    r"""The closed form with every approximation refined until a tolerance is met: slower than the default.

    Supports every pupil. It answers when, if ever, the closed form is the right choice: it reaches any practical
    accuracy, at a hundred times and more the cost of :class:`NijboerZernike`.

    Parameters
    ----------
    tol : float, default 1e-4
        Bound on ``max|I - I_exact| / max I`` over the window, 1e-6 to 1e-1. :class:`ToleranceError` is raised where
        it is not met: near 1e-6, and for phases of hundreds of radians.

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
