r"""Averages over the aperture: rms wavefront error, Strehl ratio, centroid and spot radius from the wavefront.

All are integrals over the clear aperture. On discs and annuli these are in polar coordinates, by Gauss-Legendre nodes
in ``t = rho^2`` and equal steps in theta; on others by the rule of :meth:`lommel.Pupil.rule`, where segments add
their phases. An average over theta is even in rho, hence smooth in t: convergence is spectral. Polynomials of the
phase are exact with finitely many nodes; oscillating integrands are refined until the result converges.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array, Numbers, numbers
from lommel.core.answers import ToleranceError
from lommel.measures.overlap import cells_of_stack
from lommel.optics.aperture.opening import degree_needed
from lommel.optics.pupil import Pupil, checked, ray_height
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.special import zernike
from lommel.special.legendre import gauss_legendre

_MAX_NODES = 2**24


def rms(pupil: Pupil | Wavefront, *, unit: str = "radians") -> Numbers:
    """Return the root mean square of the phase over the aperture, about its mean: the rms wavefront error.

    Parameters
    ----------
    pupil : Pupil or Wavefront
        The average is weighted by the amplitude of a pupil; a wavefront is averaged over the full disc.
    unit : {"radians", "waves"}, default "radians"

    Returns
    -------
    float or ndarray, shape ``pupil.shape``
        Exact but for rounding. Tilt counts like every other term, though it only moves the image.

    Raises
    ------
    TypeError, ValueError
        If `pupil` is neither, or `unit` is unknown.

    Examples
    --------
    >>> import lommel as lm
    >>> float(lm.rms(lm.Wavefront.zernike({(3, 1): 0.3, (2, 2): 0.4})))
    0.5
    """
    validation.choice("unit", unit, ("radians", "waves"))
    of = Pupil(pupil) if isinstance(pupil, Wavefront) else checked(pupil)
    return numbers(np.sqrt(_variance(of)) / (1.0 if unit == "radians" else 2.0 * math.pi), of.shape)


def least_squares(pupil: Pupil, terms: Sequence[Callable[[Array, Array], Array]]) -> Array:
    """Return the coefficients (radians) of the least-squares fit of functions of (rho, theta) to a pupil's phase.

    A constant is fitted too, over the clear aperture weighted by amplitude: without these terms the rms is least.
    Exact but for rounding for polynomials of no higher degree and order than tilt, defocus and the phase.
    """
    at = _polynomial_rule(checked(pupil), 1.0)
    columns = np.stack([np.ones(at.rho.shape), *(term(at.rho, at.theta) for term in terms)], axis=-1)
    # A constant among the columns: a piston changes no image, and its coefficient is dropped.
    root, phase = np.sqrt(at.weight), at.phase(pupil)
    return np.asarray(np.linalg.lstsq(columns * root[:, None], phase * root, rcond=1e-12)[0][1:])


def marechal(pupil: Pupil) -> Numbers:
    """Return the extended Marechal estimate of the Strehl ratio, ``exp(-sigma^2)``.

    sigma is the rms phase in radians, weighted by the amplitude (:func:`lommel.rms`). It agrees with
    :func:`lommel.strehl` to second order in the phase, and within 10 % for Strehl ratios above 0.38 for defocus, and
    above 0.3 for a Zernike term of astigmatism, coma or spherical aberration.

    Parameters
    ----------
    pupil : Pupil

    Returns
    -------
    float or ndarray, shape ``pupil.shape``

    References
    ----------
    V. N. Mahajan, "Strehl ratio for primary aberrations in terms of their aberration variance",
    J. Opt. Soc. Am. 73, 860 (1983), doi:10.1364/JOSA.73.000860.
    """
    return numbers(np.exp(-_variance(checked(pupil))), pupil.shape)


def strehl(pupil: Pupil) -> Numbers:
    """Return the Strehl ratio: intensity on the axis relative to the same aperture without aberration.

    ``abs(mean of exp(i phase))^2``, weighted by the amplitude. The brightest point of the image may lie elsewhere:
    a tilt moves it away (:func:`lommel.measures.spot.peak_strehl`). :attr:`lommel.PSF.strehl` is that of an image.

    Parameters
    ----------
    pupil : Pupil

    Returns
    -------
    float or ndarray, shape ``pupil.shape``
        Refined until two quadratures differ by less than 1e-12; the finer one is then correct to about rounding.

    Raises
    ------
    TypeError
        If `pupil` is not a Pupil.
    ToleranceError
        If the phase needs more than 2^24 nodes.
    """
    flat = checked(pupil).wavefront.flattened()
    # One by one: the number of nodes depends on the blur of each.
    single = (replace(pupil, wavefront=flat[i], geometry=None) for i in range(*flat.shape))
    return numbers([_strehl(one) for one in single], pupil.shape)


def centroid(pupil: Pupil) -> Array:
    """Return the centroid of the light, from the wavefront: the mean gradient of the phase, weighted by intensity.

    The centroids of the rays and of the light are the same. That of the values in a window,
    :func:`lommel.measures.energy.window_centroid`, approaches it as the window grows. With a complex mask, whose
    phase has no gradient, it is that of the image: of one period around the axis, or of all of it for
    ``squares=True``, as the limit of windows about the axis.

    Parameters
    ----------
    pupil : Pupil

    Returns
    -------
    ndarray, shape ``pupil.shape + (2,)``
        x (columns) and y (rows) from the axis, in metres if the pupil has a wavelength, else in units of lambda*N.
        Exact but for rounding.
    """
    if checked(pupil).phase_mask:
        assert pupil.mask is not None
        found = np.array([one.centroid(squares=pupil.mask.squares) for one in cells_of_stack(pupil)])
        return found.reshape(*pupil.shape, 2) * pupil.scale
    at = _polynomial_rule(pupil, 2.0)
    mean = (at.rays(pupil) * at.weight).sum(axis=-1)
    return np.asarray(mean.reshape(*pupil.shape, 2) * (pupil.scale / math.pi))


def spot_radius(pupil: Pupil) -> Numbers:
    """Return the rms radius of the rays on the sensor about their centroid, weighted by intensity.

    Rays meet the sensor at the gradient of the phase. Diffraction is ignored: the rms radius of a diffraction PSF is
    infinite for any hard-edged aperture.

    Parameters
    ----------
    pupil : Pupil

    Returns
    -------
    float or ndarray, shape ``pupil.shape``
        Metres if the pupil has a wavelength, else units of lambda*N. Exact but for rounding.
    """
    at = _polynomial_rule(checked(pupil), 2.0)
    rays = at.rays(pupil)
    away = rays - (rays * at.weight).sum(axis=-1, keepdims=True)
    variance = (away**2 * at.weight).sum(axis=(-2, -1))
    return numbers(np.sqrt(variance) * (pupil.scale / math.pi), pupil.shape)


def slopes(pupil: Pupil, rho: Array, theta: Array) -> Array:
    """Return the gradient of the phase of the wavefront and of the segments, shape (n, 2, points)."""
    found = gradient(pupil.wavefront, rho, theta)
    if pupil.segmented:
        found = found + pupil.opening.tilted(rho * np.cos(theta), rho * np.sin(theta))[1:]
    return found


def _variance(pupil: Pupil) -> Array:
    """Return the variance of the phase, weighted by amplitude, shape ``pupil.shape``."""
    at = _polynomial_rule(pupil, 1.0)
    phase = at.phase(pupil)
    # About the mean: a piston changes no image.
    away = phase - (phase * at.weight).sum(axis=-1, keepdims=True)
    return np.asarray((away**2 * at.weight).sum(axis=-1))


class _Nodes(NamedTuple):
    """Nodes of an aperture, weights of sum 1, and the phase and slopes of segments and mask at the nodes."""

    rho: Array
    theta: Array
    weight: Array
    added: Array | None = None  # (3, points)

    def phase(self, pupil: Pupil) -> Array:
        """Return the phase, shape ``pupil.shape + (points,)``."""
        found = pupil.wavefront.phase(self.rho, self.theta)
        return found if self.added is None else found + self.added[0]

    def rays(self, pupil: Pupil) -> Array:
        """Return the gradient of the phase, shape (n, 2, points) for the flattened stack."""
        found = gradient(pupil.wavefront, self.rho, self.theta)
        return found if self.added is None else found + self.added[1:]


def _polynomial_rule(pupil: Pupil, power: float) -> _Nodes:
    """Return nodes that are exact for squares of the phase or of its gradient, weighted by amplitude^power."""
    # Angles of complex samples are known modulo 2 pi: neither their mean nor their slope is defined.
    if pupil.phase_mask:
        raise ValueError(
            "mask must be real for measures of the wavefront, since the phase of a complex one is known up to whole "
            "waves at its samples only; give that phase as Zernike terms (lommel.fit_opd), or take lommel.strehl"
        )
    terms = pupil.wavefront.nonradial
    # Squares of the phase have twice its degree in rho, which is its degree in t.
    degree = max(n for n, _ in pupil.wavefront.terms)
    order = max([0, *(abs(m) for _, m in terms)])
    # n nodes are exact to the degree 2 n - 1 in t; a varying amplitude takes some more.
    fall = power * pupil.illumination.slope
    if not pupil.circular:
        return _clear_rule(pupil, power, 2 * degree + 2 + (0 if fall == 0.0 else 48 + math.ceil(fall)))
    radial = degree // 2 + 2 + (0 if fall == 0.0 else 24 + math.ceil(0.5 * fall))
    return _rule(pupil, power, radial, 2 * order + 2)


def _rule(pupil: Pupil, power: float, radial: int, around: int) -> _Nodes:
    low = pupil.obscuration**2
    t, weight = gauss_legendre(radial, low, 1.0)
    # Relative to the brightest zone: a strong apodization underflows otherwise.
    fall = pupil.illumination.exponent_at(t)
    weight = weight * np.exp(-power * (fall - fall.min()))
    theta = np.arange(around) * (2.0 * math.pi / around)
    rho = np.repeat(np.sqrt(t), around)
    return _Nodes(rho, np.tile(theta, radial), np.repeat(weight / (weight.sum() * around), around))


def _clear_rule(pupil: Pupil, power: float, degree: int) -> _Nodes:
    """Return the rule over the clear parts of any aperture, exact to a degree in x and y."""
    x, y, weight = pupil.rule(degree)
    # The rule of a mask has the amplitude of its cells in the weights: a power p of the amplitude needs p - 1 more.
    carried = 1.0 if pupil.mask is None else weight ** (power - 1.0)
    # At the centre of a mask rho is 0, where the slope over rho exists as a limit only.
    rho = np.maximum(np.hypot(x, y), 1e-12)
    weight = weight * carried * pupil.illumination.at(rho**2, power)
    added = None
    if pupil.segmented:
        added = pupil.opening.tilted_nodes(degree) if pupil.mask is None else pupil.opening.tilted(x, y)
    if pupil.phase_mask:
        added = np.zeros((3, x.size)) if added is None else added
        added[0] += np.angle(pupil.mask.at(x, y))  # type: ignore[union-attr]
    return _Nodes(rho, np.arctan2(y, x), weight / weight.sum(), added)


def gradient(wavefront: Wavefront, rho: Array, theta: Array) -> Array:
    """Return ``(dPhi/dx, dPhi/dy)`` at points with rho > 0, shape ``(n, 2, points)`` for the flattened stack."""
    flat = wavefront.flattened()
    # dPhi/drho and (1/rho) dPhi/dtheta, turned to x and y.
    outward = ray_height(flat.edge[:, : flat.symmetric], rho)
    # One Zernike term c R(rho) cos(m theta): radial and tangential derivatives.
    sideways = np.zeros_like(outward)
    for (n, m), c in flat.nonradial.items():
        k = abs(m)
        value, turn = (np.cos, -np.sin(k * theta)) if m > 0 else (np.sin, np.cos(k * theta))
        outward = outward + c[:, None] * (_radial_slope(n, k, rho) * value(k * theta))
        sideways = sideways + c[:, None] * (zernike.radial(n, k, rho) / rho * k * turn)
    cos, sin = np.cos(theta), np.sin(theta)
    return np.stack([outward * cos - sideways * sin, outward * sin + sideways * cos], axis=1)


def _radial_slope(n: int, m: int, rho: Array) -> Array:
    """Return ``dR_n^m/drho`` by ``R_n^m' = n (R_(n-1)^|m-1| + R_(n-1)^(m+1)) + R_(n-2)^m'``, R = 0 for m > n."""
    total = np.zeros_like(rho)
    # The recurrence of the docstring, unrolled down to the lowest degree.
    for degree in range(n, max(m, 1) - 1, -2):
        total += degree * zernike.radial(degree - 1, abs(m - 1), rho)
        if m + 1 <= degree - 1:
            total += degree * zernike.radial(degree - 1, m + 1, rho)
    return total


def _strehl(pupil: Pupil) -> float:
    """Return the Strehl ratio of a single pupil."""
    if not pupil.circular:
        # Error below 1e-12: the rule has positive weights and is exact to the proven degree.
        terms_of = [(n, float(np.abs(c).max())) for (n, _), c in pupil.wavefront.edge_terms().items()]
        # Tilts of segments count as a shift of the window.
        steepest = float(np.hypot(*pupil.opening.phases[:, 1:].T).max())
        at = _clear_rule(pupil, 1.0, degree_needed(terms_of, steepest, pupil.illumination, 1e-13))
        mean = np.sum(at.weight * np.exp(1j * at.phase(pupil)))
        return float(mean.real**2 + mean.imag**2)
    blur = float(pupil.v(pupil.geometric_radius()))
    terms = pupil.wavefront.nonradial
    order = max([0, *(abs(m) for _, m in terms)])
    # Half a node a radian of the geometric blur resolves exp(i phase); the loop below checks it.
    radial = 24 + math.ceil(0.5 * blur + 0.5 * pupil.illumination.slope)
    around = 2 * (16 + 2 * order + math.ceil(0.6 * blur)) if terms else 2

    def quadrature(radial: int, around: int) -> float:
        if radial * around > _MAX_NODES:
            raise ToleranceError(
                f"the Strehl ratio of a phase with a blur of v = {blur:.3g} takes more than {_MAX_NODES} nodes"
            )
        at = _rule(pupil, 1.0, radial, around)
        field = np.sum(at.weight * np.exp(1j * at.phase(pupil)))
        return float(field.real**2 + field.imag**2)

    value = quadrature(radial, around)
    while True:
        radial = math.ceil(1.4 * radial)
        around = 2 * math.ceil(0.7 * around) if terms else around
        before, value = value, quadrature(radial, around)
        # Phases of many radians are known to their rounding only: 1e-15 of the blur.
        if abs(value - before) <= 1e-12 + 1e-15 * blur:
            return value
