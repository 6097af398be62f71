"""Huygens' superposition ("ray tracing" in the paper of docs/paper.md): the sum of waves from the aperture."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.core.answers import FieldValues, Intensities
from lommel.core.engine import huygens_sum
from lommel.methods.averaging import average_strips, averaging_filter
from lommel.methods.method import FieldMethod
from lommel.optics.base_pupil import Geometry
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import expansion, path
from lommel.special import zernike
from lommel.special.legendre import gauss_legendre

_MAX_WAVELETS = 10**11  # largest number of sources times points of the image
_MAX_RADIAL = 20_000  # largest number of radii of sources
_MAX_SOURCES = 5 * 10**7  # largest number of sources
_BLOCK = 2**22  # number of wavelets in one call of the core, which takes well below a second: Ctrl+C is not delayed


@dataclass(frozen=True)
class HuygensFresnel(FieldMethod[Pupil]):
    r"""Huygens-Fresnel sum of wavelets with exact path differences (no Fresnel approximation).

    The method needs physical distances, hence a pupil from :meth:`lommel.Lens.pupil`, and depends on the model of the
    lens.

    A *paraxial* lens is modelled as flat and thin, emitting spherical wavelets. It is stigmatic for the plane in
    focus, where it agrees with the Fresnel approximation at small angles. At large angles it includes the obliquity
    factor, the curvature of the image field and the higher orders of the defocus. The difference from the other
    methods is their Fresnel error. In this model the *tangents* of the angles of rays are proportional to the pupil
    coordinate, which is rare in real lenses.

    An *aplanatic* lens emits plane waves from its reference sphere, in directions whose *sines* are proportional to
    the pupil coordinate: the Debye integral with exact path differences. The other methods expand the same phase in
    powers of the squared pupil coordinate, and agree with this method. The Debye integral neglects the finite
    distance of the pupil, and thus phases of up to ``k r^2 (R_max / d)^2 / (2 d)`` at the distance r from the axis.

    Parameters
    ----------
    symmetry : bool, default True
        True: one sum over half of the aperture for each distinct radius. False: one sum over the whole aperture for
        every pixel, O(n^4) for an n x n image.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.

    Notes
    -----
    The nodes, Gauss-Legendre in the squared pupil coordinate and equally spaced in azimuth, are chosen for an error
    of about 1e-10 of the unaberrated field.

    Paraxial: ``U(r) = 1/(pi R_max^2) int exp(i Phi) (d/l)^2 exp(i k (l - l_0)) dA``, Rayleigh-Sommerfeld diffraction
    of the first kind. Here l, ``abs((x, y, 0) - (r, 0, d))``, is the distance from a point of the aperture to a point
    of the sensor, and l_0 the distance to the sensor on the axis (r = 0). The phase Phi at the distance R from the
    axis is ``k (sqrt(s^2 + R^2) - s)`` for the object at the distance s, minus this phase for the object in focus,
    plus the aberrations. J. W. Goodman, *Introduction to Fourier Optics*, 3rd ed., Eq. (3-41).

    Aplanatic: ``U(x, y) = 1/pi int exp(i Phi) exp(-i k (R_max / d) (x p + y q)) dp dq`` over the points (p, q) of the
    unit disk. M. Born and E. Wolf, *Principles of Optics*, 7th ed., section 8.8.
    """

    apodized = True
    symmetry: bool = True

    def __post_init__(self) -> None:
        validation.truth("symmetry", self.symmetry)

    def unsupported(self, pupil: Pupil) -> str | None:
        """Return the reason if the physical distances are unknown, else None."""
        if pupil.geometry is None:
            return "needs the physical distances of a lens; make the pupil with Lens.pupil(object_distance)"
        return None

    def evaluate(self, pupil: Pupil, v: Array) -> FieldValues:
        """Return U at ascending v by sums over one half of the aperture (by symmetry), without an error bound."""
        radii = v * pupil.scale / math.pi
        return FieldValues(self._sums(pupil, radii, np.zeros_like(radii), half=True), None)

    def intensity(self, pupil: Pupil, grid: Grid, threads: int) -> Intensities:
        """Return I at the distinct radii of the pixels, or at every pixel if not `symmetry`."""
        if self.symmetry:
            return super().intensity(pupil, grid, threads)
        if grid.integrate:
            taps = averaging_filter(grid.step(pupil), 1e-9)
            values = np.empty((math.prod(pupil.shape), *grid.shape))
            average_strips(lambda samples: [self._samples(pupil, samples)], values[None], grid, taps, threads)
            return Intensities(values, None)
        return Intensities(self._samples(pupil, grid), None)

    def _samples(self, pupil: Pupil, grid: Grid) -> Array:
        """Return the point-sampled intensity at every pixel, shape (n, height, width)."""
        grid.require_one_axis()
        y, x = (part.ravel() for part in np.meshgrid(grid.y, grid.x, indexing="ij"))
        field = self._sums(pupil, x, y, half=False)
        return np.asarray(field.real**2 + field.imag**2).reshape(-1, *grid.shape)

    def _sums(self, pupil: Pupil, x: Array, y: Array, *, half: bool) -> NDArray[np.complex128]:
        """Return U at positions x, y (m) on the sensor, shape (n, positions).

        `half`: sum over the azimuths from 0 to pi only, which suffices for y = 0.
        """
        geometry = pupil.geometry
        assert geometry is not None
        assert pupil.wavelength is not None
        wavenumber = 2.0 * math.pi / pupil.wavelength
        largest_v = float(pupil.v(np.hypot(x, y).max())) if x.size else 0.0
        radial, azimuthal = _nodes(pupil, geometry, largest_v)
        if radial > _MAX_RADIAL or radial * azimuthal > _MAX_SOURCES:
            raise ValueError(
                f"HuygensFresnel would need {radial:.3g} x {azimuthal:.3g} sources in the aperture, more than the "
                f"limits of {_MAX_RADIAL} radii and {_MAX_SOURCES:.0g} in all; use a smaller window or less defocus"
            )
        wavelets = math.prod(pupil.shape) * x.size * radial * azimuthal // (2 if half else 1)
        if wavelets > _MAX_WAVELETS:
            raise ValueError(
                f"HuygensFresnel would sum {wavelets:.2g} wavelets, more than the limit of {_MAX_WAVELETS:.0g}; "
                "use a smaller shape"
            )
        t, weights = gauss_legendre(radial, pupil.obscuration**2, 1.0)
        weights = weights * pupil.illumination.at(t)
        phase = exact_phase(pupil, geometry, t)
        points = azimuthal // 2 if half else azimuthal
        angle = (np.arange(points) + 0.5) * ((math.pi if half else 2.0 * math.pi) / points)
        ring = geometry.aperture_radius * np.sqrt(t)[:, None]
        source_x = np.ascontiguousarray((ring * np.cos(angle)).ravel())
        source_y = np.ascontiguousarray((ring * np.sin(angle)).ravel())
        fields = np.empty((phase.shape[0], x.size), dtype=np.complex128)
        positions = max(1, _BLOCK // source_x.size)
        for start in range(0, x.size, positions):
            block = slice(start, start + positions)
            if geometry.model == "aplanatic":
                k_over_d = wavenumber / geometry.sensor_distance
                waves = np.exp(-1j * k_over_d * (np.outer(x[block], source_x) + np.outer(y[block], source_y)))
                rings = waves.reshape(-1, radial, points).mean(axis=2)
                fields[:, block] = (weights * np.exp(1j * phase)) @ rings.T
                continue
            for values, row in zip(fields, phase, strict=True):
                amplitude = np.repeat(weights / points * np.exp(1j * row), points)
                values[block] = huygens_sum(
                    source_x, source_y, amplitude, x[block], y[block], geometry.sensor_distance, wavenumber
                )
        return fields


def exact_phase(pupil: Pupil, geometry: Geometry, t: Array) -> Array:
    """Return the exact phase in the aperture at ``rho^2 = t``, shape ``(n, t)``, for pupil coordinates rho.

    The phase of the pupil contains approximate defocus; the difference from exact defocus is added.
    """
    assert pupil.wavelength is not None
    wavenumber = 2.0 * math.pi / pupil.wavelength
    square = geometry.aperture_radius**2 * t
    if geometry.model == "aplanatic":
        sphere = geometry.aperture_radius, geometry.sphere, geometry.vergence
        approximate = zernike.legendre_sum(expansion(*sphere, pupil.wavelength)[0], 2.0 * t - 1.0)
        exact = wavenumber * path(t, *sphere)
        return np.asarray(pupil.radial_phase(t) + (exact - approximate))
    vergence = 1.0 / np.asarray(geometry.object_distance)[:, None]
    parabolic = 0.5 * wavenumber * (vergence - geometry.in_focus) * square
    exact = wavenumber * (_sag(vergence, square) - _sag(np.asarray(geometry.in_focus), square))
    return np.asarray(pupil.radial_phase(t) + (exact - parabolic))


def _sag(vergence: Array, square: Array) -> Array:
    """Return ``sqrt(s^2 + R^2) - s`` from 1/s (of either sign, or 0) and R^2, without cancellation."""
    return np.asarray(vergence * square / (1.0 + np.sqrt(1.0 + vergence**2 * square)))


def _nodes(pupil: Pupil, geometry: Geometry, largest_v: float) -> tuple[int, int]:
    """Return the numbers of radial and azimuthal nodes for an error of about 1e-10 at radii up to `largest_v`."""
    t_min = pupil.obscuration**2
    t = np.linspace(t_min, 1.0, 1025)
    slope = np.abs(np.diff(exact_phase(pupil, geometry, t), axis=1)) / (t[1] - t[0])
    middle = 0.5 * (t[1:] + t[:-1])
    # Bandwidth of the phase in Chebyshev polynomials of t, plus 10 % for orders beyond the Fresnel approximation.
    bandwidth = 1.1 * float((np.sqrt((middle - t_min) * (1.0 - middle)) * slope).max() + 0.5 * largest_v)
    log_accuracy = 27.6  # natural logarithm of 1e12
    # Half of the bandwidth, since n Gauss-Legendre nodes are exact to degree 2 n - 1, plus the width of a transition.
    radial = 0.5 * bandwidth + 0.587 * log_accuracy ** (2 / 3) * bandwidth ** (1 / 3) + 0.2 * log_accuracy + 4.0
    radial += 0.5 * pupil.illumination.slope
    # Bessel functions J_n(v) vanish for n above v plus a transition of width v^(1/3).
    azimuthal = 1.1 * largest_v + 12.0 * (largest_v + 1.0) ** (1 / 3) + 24.0
    return math.ceil(radial), 2 * math.ceil(0.5 * azimuthal)
