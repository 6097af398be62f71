"""The achievable precision of depth from defocus (Cramér-Rao bound), and the best focus distances.

The Fisher information of one pixel is the second term of J in :mod:`lommel.estimation.focal_model`. A Gaussian window
of rms width w (pixels) counts as ``4 pi w^2`` independent pixels; depth from defocus has windows of :data:`WINDOW`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array, Numbers, numbers
from lommel.estimation.focal_model import FocalLight, FocalModel, transfer_curve
from lommel.optics.base_pupil import object_distances
from lommel.optics.lens import Lens, pixel_of
from lommel.recorded.noise import Noise

WINDOW = 4.0
"""Rms width, pixels, of the Gaussian windows in which depth from defocus assumes a constant depth."""

CONTRAST = 0.35
"""Texture contrast of natural scenes: rms / mean, for structures of 2 to 128 pixels."""

_MOST_ELECTRONS = 1e12
_STEP = 0.02  # step of the five-point derivatives, radians of defocus at the pupil edge
# Information below this fraction of its upper limit is rounding error: the photographs change equally with depth.
_ROUNDING = 1e-9
# Change of a transfer function over the step below which its derivative is rounding error.
_TRANSFER_ROUNDING = 1e-9
# Defocus of the surface in each photograph of the trial pairs, radians at the pupil edge.
_TRIAL_DEFOCUS = np.geomspace(0.15, 30.0, 14)


def depth_precision(
    lenses: Sequence[Lens],
    distance: ArrayLike,
    pixel: float,
    *,
    noise: Noise,
    contrast: float = CONTRAST,
) -> Numbers:
    """Return the Cramér-Rao bound on the depth of a textured surface, as a standard error.

    Parameters
    ----------
    lenses : sequence of Lens
        Lens of each photograph, focused; circular apertures and radially symmetric aberrations only.
    distance : array_like
        Distance of the surface, metres.
    pixel : float
        Pixel pitch, metres.
    noise : Noise
        Noise of the photographs, the same for all pixels; ``noise.white`` is the mean number of electrons per pixel.
    contrast : float, default 0.35
        Texture contrast: rms / mean of the structures with periods of 2 to 128 pixels, before any blur. The power
        spectrum falls as the inverse square of the frequency, as in natural scenes. Faint textures have 0.1 or less.

    Returns
    -------
    float or ndarray
        Standard error of the best unbiased estimate, metres, with the shape of `distance`. It is inf where depth
        cannot be determined: at infinity, without texture or light, or if all photographs change equally with depth.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range or of another type, or the pupil of a lens is not circular and radially
        symmetric.
    ToleranceError
        If the defocus is so large that the transfer function needs more than 4096 quadrature nodes along a line.

    Notes
    -----
    The bound holds for Gaussian textures (Whittle 1953, doi:10.1007/BF02590998); strong edges carry more information.
    Derivatives are finite differences over 0.08 rad of defocus, with a relative error below 1e-3. Texture beyond the
    Nyquist frequency of the sensor is aliased and acts as noise. The power of the texture is assumed to be unknown,
    as in :func:`lommel.imaging.depth_from_defocus`: depth follows from differences between photographs, and a single
    photograph does not determine it. Depth is assumed constant in Gaussian windows of 4 pixels rms, as there. The
    bound is local: with one focus the depth on the other side of it, whose photographs are the same, is excluded.

    Examples
    --------
    >>> lens = lm.Lens(focal_length=35e-3, f_number=8.0, focus_distance=1.35, wavelength=540e-9)
    >>> pair = [lens, lens.focused(1.8)]
    >>> errors = lm.depth_precision(pair, [1.4, 1.5, 1.6], 4e-6, noise=lm.Noise(white=1e4, read=3))
    >>> [f"{1e3 * each:.2f} mm" for each in errors]
    ['1.87 mm', '1.46 mm', '1.71 mm']
    """
    pitch = pixel_of(lenses, pixel)
    metres = np.asarray(object_distances(distance))
    surface = _surface(noise, contrast)
    errors = [_error(lenses, float(z), pitch, surface) for z in metres.ravel()]
    return numbers(np.array(errors), metres.shape)


def best_depth_foci(lens: Lens, distance: float, pixel: float, *, noise: Noise) -> tuple[Lens, Lens]:
    """Return the lens at the two focus distances that give the best depth precision for a surface.

    Parameters
    ----------
    lens : Lens
        The lens; its focus distance is ignored.
    distance : float
        Distance of the surface, metres.
    pixel : float
        Pixel pitch, metres.
    noise : Noise
        As in :func:`depth_precision`.

    Returns
    -------
    (Lens, Lens)
        The lens with its ``focus_distance`` in front of the surface and behind it; the latter may be infinite. The
        offsets of the foci from the surface are accurate to about 1 %. For a range of depths choose foci at or beyond
        its ends, and compare :func:`depth_precision` in between.

    Raises
    ------
    TypeError, ValueError
        See :func:`depth_precision`; also if no pair determines the distance.

    Examples
    --------
    >>> lens = lm.Lens(focal_length=35e-3, f_number=8.0, focus_distance=1.5, wavelength=540e-9)
    >>> noise = lm.Noise(white=1e4, read=3)
    >>> near, far = lm.best_depth_foci(lens, 1.5, 4e-6, noise=noise)
    >>> error = lm.depth_precision([near, far], 1.5, 4e-6, noise=noise)
    >>> f"{near.focus_distance:.2f} m and {far.focus_distance:.2f} m: {1e3 * error:.2f} mm"
    '1.33 m and 1.76 m: 1.44 mm'
    """
    pitch = pixel_of([lens], pixel)
    metres = validation.real("distance", distance, above=0.0, unit="metres")
    surface = _surface(noise, CONTRAST)
    # Vergence (1/m) per radian of the defocus coefficient C_d = pi a^2 / (2 lambda) * vergence, a the pupil radius.
    per_radian = 2.0 * lens.wavelength / (math.pi * (0.5 * lens.aperture_diameter) ** 2)

    def focused_lenses(log_defocus: Array) -> list[Lens] | None:
        vergence = 1.0 / metres + per_radian * np.exp(log_defocus) * [1.0, -1.0]
        if not (vergence[1] >= 0.0 and vergence[0] < 1.0 / lens.focal_length):
            return None
        return [lens.focused(1.0 / v if v > 0.0 else math.inf) for v in vergence.tolist()]

    def cost(log_defocus: Array) -> float:
        pair = focused_lenses(log_defocus)
        return math.inf if pair is None else _error(pair, metres, pitch, surface)

    # Trial pairs are symmetric in vergence about the surface. The logarithm keeps the defocus positive in the search.
    starts = [np.log([defocus, defocus]) for defocus in _TRIAL_DEFOCUS]
    best_trial = min(starts, key=cost)
    if not math.isfinite(cost(best_trial)):
        raise ValueError(
            f"no pair of foci determines the distance {metres:g} m: there is no texture, no light, or no focus "
            "distance between the focal length and infinity"
        )
    tolerances = {"xatol": 0.01, "fatol": 1e-4 * cost(best_trial)}
    optimum = scipy.optimize.minimize(cost, best_trial, method="Nelder-Mead", options=tolerances)
    pair = focused_lenses(optimum.x)
    assert pair is not None
    return pair[0], pair[1]


class _Surface(NamedTuple):
    """Electrons per pixel and rms read noise, both divided by the excess noise factor; texture contrast."""

    light: float
    read: float
    contrast: float


def _surface(noise: Noise, contrast: float) -> _Surface:
    validation.instance("noise", noise, Noise)
    if not isinstance(noise.read, float) or not isinstance(noise.white, float | None):
        raise ValueError("noise must be the same for all pixels: white and read must be numbers")
    if noise.white is None:
        raise ValueError("noise must have a white, here the mean number of electrons per pixel, such as 5000")
    if not noise.white <= _MOST_ELECTRONS:
        raise ValueError(f"noise.white must be <= {_MOST_ELECTRONS:g} electrons, got {noise.white:g}")
    contrast = validation.real("contrast", contrast, least=0.0, below=1e3)
    # The excess noise factor multiplies the variance: electrons divided by it have the variance of a Poisson
    # variable.
    return _Surface(noise.white / noise.excess, noise.read / noise.excess, contrast)


def _error(lenses: Sequence[Lens], distance: float, pixel: float, surface: _Surface) -> float:
    """Return the standard error of one distance, metres; inf if the photographs do not determine it."""
    if math.isinf(distance) or not surface.contrast:
        return math.inf
    widest = max(lens.aperture_diameter for lens in lenses)
    # The step of vergence, 1/m, for the widest aperture, whose defocus changes fastest.
    step = _STEP * 2.0 * min(lens.wavelength for lens in lenses) / (math.pi * (0.5 * widest) ** 2)
    step = min(step, 0.4 / distance)  # vergences must remain positive
    vergences = 1.0 / distance + step * np.array([-2.0, -1.0, 1.0, 2.0, 0.0])
    light = FocalLight(surface.light, surface.read, (1.0,) * len(lenses), surface.contrast)

    def transfer(lens: Lens, vergence: Array, _: object, pitch: float) -> Callable[[Array], Array]:
        return transfer_curve(lens, vergence, [(lens.wavelength, 1.0)], pitch)

    model = FocalModel.of(lenses, vergences, (), pixel, light, transfer=transfer)
    h = model.transfer
    if np.abs(h[:2] - h[3:1:-1]).max() <= _TRANSFER_ROUNDING:
        return math.inf
    # Five-point formula for the derivative; its error is of fourth order in the step.
    derivative = (h[0] - h[3] + 8.0 * (h[2] - h[1])) / (12.0 * step)
    information = float(model.at(slice(4, 5)).information(derivative[None])[0])
    upper_limit = model.texture * (derivative * derivative).sum(0)
    if information <= _ROUNDING * float(upper_limit @ model.band.share):
        return math.inf
    # From vergence V to distance z = 1 / V: abs(dz) = z^2 abs(dV).
    return distance**2 / math.sqrt(information * (4.0 * math.pi * WINDOW**2))
