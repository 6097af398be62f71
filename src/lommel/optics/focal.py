"""What an objective tells of its focus."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array, Numbers


@dataclass(frozen=True, eq=False)
class FocalField:
    """The vectorial field of a microscope, in three integrals that everything is made of.

    A fixed dipole p, with z towards the objective and phi the azimuth on the camera, has there
    ``Ex = p_x (K0 + K2 cos 2 phi) + p_y K2 sin 2 phi - 2i p_z K1 cos phi`` and
    ``Ey = p_x K2 sin 2 phi + p_y (K0 - K2 cos 2 phi) - 2i p_z K1 sin phi``; light that enters polarised along x has
    ``E = (K0 + K2 cos 2 phi, K2 sin 2 phi, -2i K1 cos phi)`` in the sample.

    Parameters
    ----------
    K0, K1, K2 : ndarray of complex, shape planes + radii
    error : float
        Of each of these: proven for the quadrature, with an allowance for rounding.
    """

    K0: NDArray[np.complex128]
    K1: NDArray[np.complex128]
    K2: NDArray[np.complex128]
    error: float

    @property
    def intensity(self) -> Array:
        """``abs(K0)^2 + 2 abs(K1)^2 + abs(K2)^2``: an emitter that turns freely, or light that is not polarised."""
        return np.asarray(np.abs(self.K0) ** 2 + 2.0 * np.abs(self.K1) ** 2 + np.abs(self.K2) ** 2)

    @property
    def intensity_error(self) -> Array:
        """How much `intensity` may be off: ``4 error sqrt(intensity) + 4 error^2`` each."""
        return np.asarray(4.0 * self.error * (np.sqrt(self.intensity) + self.error))


@dataclass(frozen=True, eq=False)
class ScalarField:
    """The field of the scalar model of Gibson and Lanni.

    Parameters
    ----------
    U : ndarray of complex, shape planes + radii
    error : float
        Of each: proven for the quadrature, with an allowance for rounding.
    """

    U: NDArray[np.complex128]
    error: float

    @property
    def intensity(self) -> Array:
        """``abs(U)^2``."""
        return np.asarray(np.abs(self.U) ** 2)

    @property
    def intensity_error(self) -> Array:
        """How much `intensity` may be off: ``2 error sqrt(intensity) + error^2`` each."""
        return np.asarray(self.error * (2.0 * np.abs(self.U) + self.error))


@dataclass(frozen=True, eq=False)
class Focus:
    """Where an emitter is in focus, one for each depth.

    Parameters
    ----------
    depth : float or ndarray
        Metres from the glass.
    paraxial, brightest : float or ndarray
        How far the objective has been driven towards the sample since the surface of the sample was in paraxial
        focus, metres: for paraxial rays, and where the light on the axis is brightest.
    peak : float or ndarray
        The intensity there. 1 is that of an aperture of the same light without layers or polarisation.
    axial_fwhm, lateral_fwhm : float or ndarray
        Full widths at half maximum through there, metres of the stage and metres in the sample.
    """

    depth: Numbers
    paraxial: Numbers
    brightest: Numbers
    peak: Numbers
    axial_fwhm: Numbers
    lateral_fwhm: Numbers

    @property
    def ratio(self) -> Numbers:
        """Depth over the position of the brightest focus, the factor for distances along the axis; NaN at depth 0."""
        with np.errstate(invalid="ignore", divide="ignore"):
            found: Numbers = np.where(np.asarray(self.depth) > 0.0, np.divide(self.depth, self.brightest), np.nan)[()]
        return found


@dataclass(frozen=True)
class Nyquist:
    """The coarsest sampling that keeps all of an image, metres.

    Parameters
    ----------
    lateral, axial : float
        In the sample, and of the stage.
    pixel : float
        `lateral` on the camera.
    """

    lateral: float
    axial: float
    pixel: float
