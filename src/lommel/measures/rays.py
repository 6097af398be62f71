"""Where rays meet the sensor: at the gradient of the phase, with no diffraction."""

from __future__ import annotations

import math

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.measures.aperture_means import gradient
from lommel.optics.pupil import Pupil, checked


def spots(pupil: Pupil, rings: int = 12) -> Array:
    """Return where the rays through evenly spread points of the clear aperture meet the sensor.

    Parameters
    ----------
    pupil : Pupil
        A single one.
    rings : int, default 12
        Of points about the axis, six more on each than on the one within: ``3 rings (rings + 1) + 1`` of a full disc,
        each for about the same area. 1 to 100.

    Returns
    -------
    ndarray, shape (rays, 2)
        x (columns) and y (rows) from the axis, in metres if the pupil has a wavelength, else in units of lambda*N.
        Exact but for rounding; their rms about their centroid approaches :func:`lommel.spot_radius` of even light as
        `rings` grow.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, or the pupil is a stack.
    """
    if checked(pupil).shape != ():
        raise ValueError(f"pupil must be a single one, got a stack of shape {pupil.shape}")
    count = validation.integer("rings", rings, least=1, most=100)
    ring = np.repeat(np.arange(count + 1), [1, *(6 * k for k in range(1, count + 1))])
    place = np.concatenate([np.arange(max(6 * k, 1)) for k in range(count + 1)])
    # In the middle, where slopes over rho have a limit only, beside it.
    rho = np.maximum(ring / (count + 0.5), 1e-9)
    theta = place * math.pi / (3.0 * np.maximum(ring, 1))
    x, y = rho * np.cos(theta), rho * np.sin(theta)
    clear = pupil.opening.margin(x, y) >= 0.0
    if pupil.mask is not None:
        clear &= pupil.mask.at(x, y) > 0.0
    return np.asarray(gradient(pupil.wavefront, rho[clear], theta[clear])[0].T * (pupil.scale / math.pi))
