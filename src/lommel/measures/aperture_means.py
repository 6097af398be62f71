r"""Averages over the aperture: rms wavefront error, Strehl ratio, centroid and spot radius from the wavefront.

All these measures are integrals over the clear aperture. For discs and annuli the nodes are Gauss-Legendre nodes in
``t = rho^2`` and equal steps in theta. The mean of an integrand over theta is even in rho and therefore a smooth
function of t, so that convergence is spectral. All other apertures, with or without segments, use the nodes of
:meth:`lommel.Pupil.rule`. Integrals of polynomials are exact with a finite number of nodes. For the Strehl ratio of
a disc or an annulus the number of nodes is increased until the result converges.
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

_MAX_NODES = 2**24  # largest number of nodes for a Strehl ratio


def rms(pupil: Pupil | Wavefront, *, unit: str = "radians") -> Numbers:
    """Return the rms wavefront error: the root mean square over the aperture of the phase minus its mean.

    Parameters
    ----------
    pupil : Pupil or Wavefront
        The average over a pupil is weighted by its amplitude. A wavefront is averaged over the full disc.
    unit : {"radians", "waves"}, default "radians"
        Unit of the result.

    Returns
    -------
    float or ndarray, shape ``pupil.shape``
        Rms wavefront error, exact up to rounding. Tilt contributes, although it only shifts the image.

    Raises
    ------
    TypeError, ValueError
        If `pupil` is neither a pupil nor a wavefront, or if `unit` is unknown.

    Examples
    --------
    >>> import lommel as lm
    >>> float(lm.rms(lm.Wavefront.zernike({(3, 1): 0.3, (2, 2): 0.4})))
    0.5
    """
    validation.choice("unit", unit, ("radians", "waves"))
    averaged = Pupil(pupil) if isinstance(pupil, Wavefront) else checked(pupil)
    return numbers(np.sqrt(_variance(averaged)) / (1.0 if unit == "radians" else 2.0 * math.pi), averaged.shape)


def least_squares(pupil: Pupil, terms: Sequence[Callable[[Array, Array], Array]]) -> Array:
    """Return the coefficients (radians) of the least-squares fit of functions of (rho, theta) to a pupil's phase.

    The fit covers the clear aperture, weighted by amplitude, and includes a constant, whose coefficient is omitted
    from the result. Let n be the largest radial degree and m the largest azimuthal order of a term of the phase. The
    result is exact up to rounding if the functions are polynomials of radial degree at most max(n, 2) and azimuthal
    order at most max(m, 1).
    """
    nodes = _polynomial_rule(checked(pupil), 1.0)
    columns = np.stack([np.ones(nodes.rho.shape), *(term(nodes.rho, nodes.theta) for term in terms)], axis=-1)
    root, phase = np.sqrt(nodes.weight), nodes.phase(pupil)
    return np.asarray(np.linalg.lstsq(columns * root[:, None], phase * root, rcond=1e-12)[0][1:])


def marechal(pupil: Pupil) -> Numbers:
    """Return the extended Marechal estimate of the Strehl ratio, ``exp(-sigma^2)``.

    Here sigma is the rms phase in radians, weighted by the amplitude (:func:`lommel.rms`). The estimate agrees with
    :func:`lommel.strehl` to second order in the phase. Its relative error is below 10 % if the Strehl ratio exceeds
    0.38 for defocus, or 0.3 for a single Zernike term of astigmatism, coma or spherical aberration.

    Parameters
    ----------
    pupil : Pupil

    Returns
    -------
    float or ndarray, shape ``pupil.shape``
        Estimated Strehl ratio.

    References
    ----------
    V. N. Mahajan, "Strehl ratio for primary aberrations in terms of their aberration variance",
    J. Opt. Soc. Am. 73, 860 (1983), doi:10.1364/JOSA.73.000860.
    """
    return numbers(np.exp(-_variance(checked(pupil))), pupil.shape)


def strehl(pupil: Pupil) -> Numbers:
    """Return the Strehl ratio, the intensity on the axis relative to the same aperture without aberrations.

    It is ``abs(mean of exp(i phase))^2``, weighted by the amplitude. The brightest point of the image may lie off the
    axis, for example by a tilt: see :func:`lommel.measures.spot.peak_strehl`. The Strehl ratio of a computed image is
    :attr:`lommel.PSF.strehl`.

    Parameters
    ----------
    pupil : Pupil

    Returns
    -------
    float or ndarray, shape ``pupil.shape``
        Strehl ratio, with an error of about 1e-12. For discs and annuli the number of nodes is increased until two
        successive results differ by at most 1e-12 (plus rounding); for other apertures the error is proven.

    Raises
    ------
    TypeError, ValueError
        If `pupil` is not a Pupil, or if no quadrature rule suffices for the phase on this aperture.
    ToleranceError
        If the phase on a disc or an annulus needs more than 2^24 nodes.
    """
    wavefronts = checked(pupil).wavefront.flattened()
    # One pupil at a time, because the numbers of nodes differ.
    pupils = (replace(pupil, wavefront=wavefronts[i], geometry=None) for i in range(*wavefronts.shape))
    return numbers([_strehl(single) for single in pupils], pupil.shape)


def centroid(pupil: Pupil) -> Array:
    """Return the centroid of the light from the wavefront: the mean gradient of the phase, weighted by intensity.

    The centroid of the rays equals the centroid of the light. The centroid of the values in a window,
    :func:`lommel.measures.energy.window_centroid`, converges to it as the window grows. The phase of a complex mask
    has no gradient. For such a mask the function returns the centroid of one period of the image around the axis or,
    if the mask has ``squares=True``, the limit of the centroid in large windows around the axis.

    Parameters
    ----------
    pupil : Pupil

    Returns
    -------
    ndarray, shape ``pupil.shape + (2,)``
        x (columns) and y (rows) relative to the axis, metres if the pupil has a wavelength, else units of lambda*N.
        The result is exact up to rounding.
    """
    if checked(pupil).phase_mask:
        assert pupil.mask is not None
        centroids = np.array([cells.centroid(squares=pupil.mask.squares) for cells in cells_of_stack(pupil)])
        return centroids.reshape(*pupil.shape, 2) * pupil.scale
    nodes = _polynomial_rule(pupil, 2.0)
    mean = (nodes.gradient(pupil) * nodes.weight).sum(axis=-1)
    return np.asarray(mean.reshape(*pupil.shape, 2) * (pupil.scale / math.pi))


def spot_radius(pupil: Pupil) -> Numbers:
    """Return the rms radius of the rays on the sensor about their centroid, weighted by intensity.

    The position of a ray on the sensor is proportional to the gradient of the phase. Diffraction is ignored, because
    the rms radius of a diffraction PSF is infinite for every hard-edged aperture.

    Parameters
    ----------
    pupil : Pupil

    Returns
    -------
    float or ndarray, shape ``pupil.shape``
        Radius in metres if the pupil has a wavelength, else in units of lambda*N, exact up to rounding.
    """
    nodes = _polynomial_rule(checked(pupil), 2.0)
    rays = nodes.gradient(pupil)
    deviation = rays - (rays * nodes.weight).sum(axis=-1, keepdims=True)
    variance = (deviation**2 * nodes.weight).sum(axis=(-2, -1))
    return numbers(np.sqrt(variance) * (pupil.scale / math.pi), pupil.shape)


def slopes(pupil: Pupil, rho: Array, theta: Array) -> Array:
    """Return the phase gradient of wavefront plus segments for the flattened stack, shape (n, 2, points)."""
    slope = gradient(pupil.wavefront, rho, theta)
    if pupil.segmented:
        slope = slope + pupil.opening.tilted(rho * np.cos(theta), rho * np.sin(theta))[1:]
    return slope


def _variance(pupil: Pupil) -> Array:
    """Return the variance of the phase, weighted by amplitude, shape ``pupil.shape``."""
    nodes = _polynomial_rule(pupil, 1.0)
    phase = nodes.phase(pupil)
    deviation = phase - (phase * nodes.weight).sum(axis=-1, keepdims=True)
    return np.asarray((deviation**2 * nodes.weight).sum(axis=-1))


class _Nodes(NamedTuple):
    """Quadrature nodes of an aperture, with weights whose sum is 1.

    `other_phase`, shape (3, points), is the phase of segments and mask at the nodes, and its derivatives by x and y.
    """

    rho: Array
    theta: Array
    weight: Array
    other_phase: Array | None = None

    def phase(self, pupil: Pupil) -> Array:
        """Return the phase at the nodes, shape ``pupil.shape + (points,)``."""
        phase = pupil.wavefront.phase(self.rho, self.theta)
        return phase if self.other_phase is None else phase + self.other_phase[0]

    def gradient(self, pupil: Pupil) -> Array:
        """Return the gradient of the phase at the nodes, shape (n, 2, points) for the flattened stack."""
        slope = gradient(pupil.wavefront, self.rho, self.theta)
        return slope if self.other_phase is None else slope + self.other_phase[1:]


def _polynomial_rule(pupil: Pupil, power: float) -> _Nodes:
    """Return nodes that integrate squares of the phase and of its gradient exactly, weighted by amplitude^power."""
    # A complex mask defines its phase modulo 2 pi only, so that neither the mean nor the slope of the phase exists.
    if pupil.phase_mask:
        raise ValueError(
            "mask must be real for measures of the wavefront, since a complex mask defines its phase modulo one wave "
            "only; pass this phase as Zernike terms (lommel.fit_opd), or use lommel.strehl"
        )
    terms = pupil.wavefront.nonradial
    # The square of a phase of degree n in rho has degree n in t = rho^2.
    degree = max(n for n, _ in pupil.wavefront.terms)
    order = max([0, *(abs(m) for _, m in terms)])
    # n Gauss nodes are exact up to the degree 2 n - 1 in t; a varying amplitude needs additional nodes.
    slope = power * pupil.illumination.slope
    if not pupil.circular:
        return _clear_rule(pupil, power, 2 * degree + 2 + (0 if slope == 0.0 else 48 + math.ceil(slope)))
    radial = degree // 2 + 2 + (0 if slope == 0.0 else 24 + math.ceil(0.5 * slope))
    return _rule(pupil, power, radial, 2 * order + 2)


def _rule(pupil: Pupil, power: float, radial: int, angles: int) -> _Nodes:
    """Return a quadrature rule for discs and annuli: `radial` Gauss-Legendre nodes times `angles` equal angles."""
    t_min = pupil.obscuration**2
    t, weight = gauss_legendre(radial, t_min, 1.0)
    # Amplitudes are relative to the brightest zone, so that a strong apodization does not underflow.
    exponent = pupil.illumination.exponent_at(t)
    weight = weight * np.exp(-power * (exponent - exponent.min()))
    theta = np.arange(angles) * (2.0 * math.pi / angles)
    rho = np.repeat(np.sqrt(t), angles)
    return _Nodes(rho, np.tile(theta, radial), np.repeat(weight / (weight.sum() * angles), angles))


def _clear_rule(pupil: Pupil, power: float, degree: int) -> _Nodes:
    """Return a quadrature rule for any aperture, exact for polynomials of this `degree` in x and y."""
    x, y, weight = pupil.rule(degree)
    # The weights of pupil.rule() already include the amplitude of a mask: multiply by amplitude^(power - 1).
    mask_factor = 1.0 if pupil.mask is None else weight ** (power - 1.0)
    # A mask may have a node at rho = 0, where (1 / rho) d/dtheta would divide by 0.
    rho = np.maximum(np.hypot(x, y), 1e-12)
    weight = weight * mask_factor * pupil.illumination.at(rho**2, power)
    other_phase = None
    if pupil.segmented:
        other_phase = pupil.opening.tilted_nodes(degree) if pupil.mask is None else pupil.opening.tilted(x, y)
    if pupil.phase_mask:
        other_phase = np.zeros((3, x.size)) if other_phase is None else other_phase
        other_phase[0] += np.angle(pupil.mask.at(x, y))  # type: ignore[union-attr]
    return _Nodes(rho, np.arctan2(y, x), weight / weight.sum(), other_phase)


def gradient(wavefront: Wavefront, rho: Array, theta: Array) -> Array:
    """Return ``(dPhi/dx, dPhi/dy)`` at points with rho > 0, shape ``(n, 2, points)`` for the flattened stack."""
    flattened = wavefront.flattened()
    # dPhi/drho and (1/rho) dPhi/dtheta: first the radial terms, then terms c R(rho) times cos or sin of m theta.
    radial = ray_height(flattened.edge[:, : flattened.symmetric], rho)
    tangential = np.zeros_like(radial)
    for (n, m), c in flattened.nonradial.items():
        k = abs(m)
        function, derivative = (np.cos, -np.sin(k * theta)) if m > 0 else (np.sin, np.cos(k * theta))
        radial = radial + c[:, None] * (_radial_slope(n, k, rho) * function(k * theta))
        tangential = tangential + c[:, None] * (zernike.radial(n, k, rho) / rho * k * derivative)
    # Rotate from the radial and tangential directions to x and y.
    cos, sin = np.cos(theta), np.sin(theta)
    return np.stack([radial * cos - tangential * sin, radial * sin + tangential * cos], axis=1)


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
        # The error is below 1e-12, by the proven bound of degree_needed() for rules with positive weights.
        sizes = [(n, float(np.abs(c).max())) for (n, _), c in pupil.wavefront.edge_terms().items()]
        # A segment's tilt is linear in position, like the Fourier kernel: degree_needed() treats it as a distance v.
        largest_tilt = float(np.hypot(*pupil.opening.phases[:, 1:].T).max())
        nodes = _clear_rule(pupil, 1.0, degree_needed(sizes, largest_tilt, pupil.illumination, 1e-13))
        mean = np.sum(nodes.weight * np.exp(1j * nodes.phase(pupil)))
        return float(mean.real**2 + mean.imag**2)
    blur = float(pupil.v(pupil.geometric_radius()))
    terms = pupil.wavefront.nonradial
    order = max([0, *(abs(m) for _, m in terms)])
    # About 0.5 nodes per unit of the blur (in v) resolve exp(i phase); the loop below verifies this estimate.
    radial = 24 + math.ceil(0.5 * blur + 0.5 * pupil.illumination.slope)
    angles = 2 * (16 + 2 * order + math.ceil(0.6 * blur)) if terms else 2

    def quadrature(radial: int, angles: int) -> float:
        if radial * angles > _MAX_NODES:
            raise ToleranceError(
                f"the Strehl ratio of a phase with a blur of v = {blur:.3g} needs more than {_MAX_NODES} nodes"
            )
        nodes = _rule(pupil, 1.0, radial, angles)
        mean = np.sum(nodes.weight * np.exp(1j * nodes.phase(pupil)))
        return float(mean.real**2 + mean.imag**2)

    value = quadrature(radial, angles)
    while True:
        radial = math.ceil(1.4 * radial)
        angles = 2 * math.ceil(0.7 * angles) if terms else angles
        previous, value = value, quadrature(radial, angles)
        # Rounding errors of large phases are about 1e-15 times the blur.
        if abs(value - previous) <= 1e-12 + 1e-15 * blur:
            return value
