"""Image quality of a pupil beyond its averages: the brightest point, balanced wavefronts, the first dark ring."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from lommel.base.arrays import Array
from lommel.measures import aperture_means, spot
from lommel.measures.energy import optics
from lommel.methods.choice import of_profiles
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront


def strehl_at_peak(pupil: Pupil) -> float:
    """Return the Strehl ratio at the brightest point of the image."""
    if not pupil.radial:
        # An additional tilt moves the brightest point to the axis.
        x, y = spot.brightest_position(optics(pupil))
        return float(aperture_means.strehl(_with_tilt(pupil, -math.pi * x, -math.pi * y)))
    method, max_v = of_profiles(), float(pupil.v(pupil.geometric_radius())) + 4.0
    v = np.linspace(0.0, max_v, 64 + math.ceil(10.0 * max_v))
    # Find the brightest radius by coarse samples, then by fine samples around the brightest coarse sample.
    coarse_peak = v[np.argmax(method.profile(pupil, v).values[0])]
    fine_v = np.abs(coarse_peak + np.linspace(-v[1], v[1], 101))
    top = method.profile(pupil, np.append(0.0, fine_v)).values.max()
    return float(top / method.unaberrated_peak(pupil))


def rms_without_tilt(pupil: Pupil) -> float:
    """Return the rms wavefront error, waves, without the best-fit tilt, which only shifts the image."""
    tilt = -aperture_means.least_squares(pupil, [_tilt_x, _tilt_y])
    return float(aperture_means.rms(_with_tilt(pupil, *tilt), unit="waves"))


def balancing_defocus(pupil: Pupil) -> float | None:
    """Return the W020 (waves) of the least rms wavefront error; None without spherical or higher radial terms."""
    wavefront = pupil.wavefront
    if not (wavefront.spherical or any(wavefront.higher)):
        return None
    # Tilt, which only shifts the image, is fitted too.
    excess = aperture_means.least_squares(pupil, [lambda rho, _: rho**2, _tilt_x, _tilt_y])[0]
    return float(wavefront.waves["W020"] - excess / (2.0 * math.pi))


def dark_ring_radius(pupil: Pupil) -> float | None:
    """Return the radius of the first dark ring without aberrations; None unless a uniform disc or annulus."""
    # The field of an annulus is the field of the disc minus the field of the obscuration, and is 0 at
    # J1(v) = eps J1(eps v).
    from scipy.optimize import brentq
    from scipy.special import j1, jn_zeros

    shapes = (pupil.spider, pupil.vignetting, pupil.stop, pupil.mask)
    if not pupil.illumination.uniform or any(shape is not None for shape in shapes):
        return None
    airy, eps = float(jn_zeros(1, 1)[0]), pupil.obscuration
    ring = float(brentq(lambda v: j1(v) - eps * j1(eps * v), 0.5, airy)) if eps else airy
    return pupil.airy_radius * ring / airy


def _tilt_x(rho: Array, theta: Array) -> Array:
    return rho * np.cos(theta)


def _tilt_y(rho: Array, theta: Array) -> Array:
    return rho * np.sin(theta)


def _with_tilt(pupil: Pupil, x: float, y: float) -> Pupil:
    """Return a pupil with additional tilts along x and y, radians at the edge of the pupil."""
    # A Zernike tilt with an rms of 1 over the disc has the value 2 at the edge.
    tilt = Wavefront.zernike({(1, 1): 0.5 * x, (1, -1): 0.5 * y})
    return replace(pupil, wavefront=pupil.wavefront + tilt, geometry=None)
