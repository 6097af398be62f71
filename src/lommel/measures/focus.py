"""Best focus: the defocus with the most light in a circle."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.measures.energy import radial_energy, require_radial
from lommel.methods.choice import of_profiles
from lommel.methods.method import RadialMethod
from lommel.optics.pupil import Pupil, checked
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.special import zernike


def best_focus(pupil: Pupil, radius: float, *, method: RadialMethod | None = None) -> float:
    """Return the defocus C_d (radians) that, added to `pupil`, maximises the encircled energy within `radius`.

    Parameters
    ----------
    pupil : Pupil
        A single pupil.
    radius : float
        Metres if the pupil has a wavelength, else units of lambda*N.
        Above 0.
    method : RadialMethod, default NijboerZernike(tol=1e-6)

    Returns
    -------
    float

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, the pupil is a stack or not radially symmetric, or the method does not support
        it.

    Notes
    -----
    The defocus is scanned in steps of half a radian over the range that brings any zone of the pupil to focus,
    then refined by Brent's method to 1e-6 rad.
    """
    from scipy.optimize import minimize_scalar

    way = validation.instance("method", of_profiles() if method is None else method, RadialMethod)
    at = validation.real("radius", radius, above=0.0)
    if checked(pupil).shape != ():
        raise ValueError(f"pupil must be a single one, got a stack of shape {pupil.shape}")
    if not pupil.radial:
        raise ValueError(
            "pupil must be radially symmetric for its best focus in a circle, got other terms or another aperture; "
            "compare psf.encircled_energy of some defoci"
        )
    require_radial(way, pupil)
    # dPhi/d(rho^2) of the aberration, over the pupil: minus half of it is the defocus that focuses the zone.
    t = np.linspace(pupil.obscuration**2, 1.0, 257)
    slope = 2.0 * zernike.legendre_slope(pupil.radial_terms()[0], 2.0 * t - 1.0)
    low, high = -0.5 * slope.max() - 6.0, -0.5 * slope.min() + 6.0
    scan = np.linspace(low, high, math.ceil(2.0 * (high - low)) + 1)

    def within(defocus: ArrayLike) -> NDArray[np.float64]:
        moved = replace(pupil, wavefront=pupil.wavefront + Wavefront(defocus), geometry=None)
        return np.asarray(radial_energy(way, moved, at))

    start = float(scan[np.argmax(within(scan))])
    bounds, options = (start - 0.5, start + 0.5), {"xatol": 1e-6}
    return float(minimize_scalar(lambda c: -float(within(c)), bounds=bounds, method="bounded", options=options).x)
