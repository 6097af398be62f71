"""Huygens' superposition, the paper's "ray tracing": every point of the aperture a wave."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.core.answers import FieldValues, Intensities
from lommel.core.engine import huygens_sum
from lommel.methods.averaging import filtered, filtered_by
from lommel.methods.method import FieldMethod
from lommel.optics.base_pupil import Geometry
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import expansion, path
from lommel.special import zernike
from lommel.special.legendre import gauss_legendre

_MAX_WAVELETS = 10**11
_MAX_RADIAL = 20_000
_MAX_SOURCES = 5 * 10**7
_BLOCK = 2**22  # wavelets between two looks at the keyboard: well below a second


@dataclass(frozen=True)
class HuygensFresnel(FieldMethod[Pupil]):
    r"""Huygens-Fresnel sum of wavelets with exact path differences (no Fresnel approximation).

    Needs physical distances, hence a pupil from :meth:`lommel.Lens.pupil`, and depends on the model of the lens.

    A *paraxial* lens is modelled as flat and thin, emitting spherical wavelets. It is stigmatic for the plane in
    focus, where it agrees with the Fresnel approximation at small angles; at large ones it includes the obliquity
    ``(d / rho)^2``, the curvature of the image field and the higher orders of the defocus. The difference from the
    other methods is their Fresnel error. In this model the *tangents* of the angles are proportional to rho, which is
    rare in real lenses.

    An *aplanatic* lens emits plane waves from its reference sphere, in directions whose sines are proportional to
    rho: the Debye integral with exact path differences. The other methods compute the same from an expansion in
    powers of rho^2, and agree. The Debye integral neglects the finite distance of the pupil: phases of up to ``k r^2
    (R_max / d)^2 / 2 d`` at the distance r from the axis.

    Parameters
    ----------
    symmetry : bool, default True
        True: one sum for each distinct radius, over one half of the aperture. False: one sum for every pixel,
        over the whole aperture, O(n^4) for an n x n image.
    nodes : (int, int), optional
        Radial Gauss-Legendre nodes in rho^2 and azimuthal points over the full circle; by default for an error of
        about 1e-10 of the unaberrated field.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.

    Notes
    -----
    Flat: ``U(r) = 1/(pi R_max^2) int exp(i Phi_lens) (d/rho)^2 exp(i k (rho - rho_0)) dA`` with
    ``rho = |(x, y, 0) - (r, 0, d)|``: Rayleigh-Sommerfeld diffraction of the first kind. The phase in the
    aperture is ``k (sqrt(s^2 + R^2) - s)`` of the object at s less that of the object in focus, plus the
    aberrations. J. W. Goodman, *Introduction to Fourier Optics*, 3rd ed., Eq. (3-41).

    Aplanatic: ``U(x, y) = 1/pi int exp(i Phi) exp(-i k (R_max / d) (x p + y q)) dp dq`` over the points (p, q) of the
    pupil. M. Born and E. Wolf, *Principles of Optics*, 7th ed., section 8.8.
    """

    apodized = True
    symmetry: bool = True
    nodes: tuple[int, int] | None = None

    def __post_init__(self) -> None:
        validation.truth("symmetry", self.symmetry)
        if self.nodes is not None:
            if not isinstance(self.nodes, Sequence) or isinstance(self.nodes, str) or len(self.nodes) != 2:
                raise ValueError(f"nodes must be (radial, azimuthal), got {validation.shown(self.nodes)}")
            pair = tuple(validation.integer("nodes", n, least=2, most=10**6) for n in self.nodes)
            object.__setattr__(self, "nodes", pair)

    def unsupported(self, pupil: Pupil) -> str | None:
        """Return the reason where the physical distances are unknown."""
        if pupil.geometry is None:
            return "needs the physical distances of a lens; make the pupil with Lens.pupil(object_distance)"
        return None

    def evaluate(self, pupil: Pupil, v: Array) -> FieldValues:
        """Return U at rising v, each radius summed over one half of the aperture; no bound is claimed."""
        radii = v * pupil.scale / math.pi
        return FieldValues(self._sums(pupil, radii, np.zeros_like(radii), half=True), None)

    def intensity(self, pupil: Pupil, grid: Grid, threads: int = 0) -> Intensities:
        """Return I at the distinct radii, or at every pixel if not `symmetry`."""
        if self.symmetry:
            return super().intensity(pupil, grid, threads)
        if grid.integrate:
            taps = filtered_by(grid.step(pupil), 1e-9)
            values = np.empty((math.prod(pupil.shape), *grid.shape))
            filtered(lambda fine: [self._samples(pupil, fine)], values[None], grid, taps, threads)
            return Intensities(values, None)
        return Intensities(self._samples(pupil, grid), None)

    def _samples(self, pupil: Pupil, grid: Grid) -> Array:
        grid.require_one_axis()
        y, x = (part.ravel() for part in np.meshgrid(grid.y, grid.x, indexing="ij"))
        field = self._sums(pupil, x, y, half=False)
        return np.asarray(field.real**2 + field.imag**2).reshape(-1, *grid.shape)

    def _sums(self, pupil: Pupil, x: Array, y: Array, *, half: bool) -> NDArray[np.complex128]:
        geometry = pupil.geometry
        assert geometry is not None
        assert pupil.wavelength is not None
        wavenumber = 2.0 * math.pi / pupil.wavelength
        reach = float(pupil.v(np.hypot(x, y).max())) if x.size else 0.0
        radial, azimuthal = self.nodes or _nodes(pupil, geometry, reach)
        if radial > _MAX_RADIAL or radial * azimuthal > _MAX_SOURCES:
            raise ValueError(
                f"HuygensFresnel would take {radial:.3g} x {azimuthal:.3g} sources in the aperture, more than the "
                f"limits of {_MAX_RADIAL} radii and {_MAX_SOURCES:.0g} in all"
            )
        wavelets = math.prod(pupil.shape) * x.size * radial * azimuthal // (2 if half else 1)
        if wavelets > _MAX_WAVELETS:
            raise ValueError(
                f"HuygensFresnel would sum {wavelets:.2g} wavelets, more than the limit of {_MAX_WAVELETS:.0g}; "
                "use a smaller shape or fewer nodes"
            )
        t, weights = gauss_legendre(radial, pupil.obscuration**2, 1.0)
        weights = weights * pupil.illumination.at(t)
        phase = exact_phase(pupil, geometry, t)
        points = (azimuthal + 1) // 2 if half else azimuthal
        angle = (np.arange(points) + 0.5) * ((math.pi if half else 2.0 * math.pi) / points)
        ring = geometry.aperture_radius * np.sqrt(t)[:, None]
        from_x = np.ascontiguousarray((ring * np.cos(angle)).ravel())
        from_y = np.ascontiguousarray((ring * np.sin(angle)).ravel())
        out = np.empty((phase.shape[0], x.size), dtype=np.complex128)
        rows = max(1, _BLOCK // from_x.size)
        for start in range(0, x.size, rows):
            block = slice(start, start + rows)
            if geometry.model == "aplanatic":
                lean = wavenumber / geometry.sensor_distance
                waves = np.exp(-1j * lean * (np.outer(x[block], from_x) + np.outer(y[block], from_y)))
                rings = waves.reshape(-1, radial, points).mean(axis=2)
                out[:, block] = (weights * np.exp(1j * phase)) @ rings.T
                continue
            for field, row in zip(out, phase, strict=True):
                amplitude = np.repeat(weights / points * np.exp(1j * row), points)
                field[block] = huygens_sum(
                    from_x, from_y, amplitude, x[block], y[block], geometry.sensor_distance, wavenumber
                )
        return out


def exact_phase(pupil: Pupil, geometry: Geometry, t: Array) -> Array:
    """Return the phase in the aperture at ``rho^2 = t``, without the Fresnel approximation, shape ``(n, t)``."""
    assert pupil.wavelength is not None
    wavenumber = 2.0 * math.pi / pupil.wavelength
    square = geometry.aperture_radius**2 * t
    if geometry.model == "aplanatic":
        known = geometry.aperture_radius, geometry.sphere, geometry.vergence
        approximate = expansion(*known, pupil.wavelength)[0]
        left = wavenumber * path(t, geometry.aperture_radius, geometry.sphere, geometry.vergence)
        return np.asarray(pupil.radial_phase(t) + (left - zernike.legendre_sum(approximate, 2.0 * t - 1.0)))
    vergence = 1.0 / np.asarray(geometry.object_distance)[:, None]
    parabolic = 0.5 * wavenumber * (vergence - geometry.in_focus) * square
    exact = wavenumber * (_sag(vergence, square) - _sag(np.asarray(geometry.in_focus), square))
    return np.asarray(pupil.radial_phase(t) + (exact - parabolic))


def _sag(vergence: Array, square: Array) -> Array:
    """Return ``sqrt(s^2 + R^2) - s`` from 1/s (of either sign, or 0) and R^2, without cancellation."""
    return np.asarray(vergence * square / (1.0 + np.sqrt(1.0 + vergence**2 * square)))


def _nodes(pupil: Pupil, geometry: Geometry, reach: float) -> tuple[int, int]:
    """Return radial and azimuthal counts: half the bandwidth in t, and all Bessel orders that v reaches."""
    low = pupil.obscuration**2
    t = np.linspace(low, 1.0, 1025)
    slope = np.abs(np.diff(exact_phase(pupil, geometry, t), axis=1)) / (t[1] - t[0])
    middle = 0.5 * (t[1:] + t[:-1])
    # A tenth more for the orders beyond Fresnel's.
    bandwidth = 1.1 * float((np.sqrt((middle - low) * (1.0 - middle)) * slope).max() + 0.5 * reach)
    digits = 27.6  # log(1e12)
    radial = 0.5 * bandwidth + 0.587 * digits ** (2 / 3) * bandwidth ** (1 / 3) + 0.2 * digits + 4.0
    radial += 0.5 * pupil.illumination.slope
    azimuthal = 1.1 * reach + 12.0 * (reach + 1.0) ** (1 / 3) + 24.0
    return math.ceil(radial), 2 * math.ceil(0.5 * azimuthal)
