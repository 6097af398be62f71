"""The achievable precision of depth from defocus (Cramér-Rao bound), and the best foci.

The information of a pixel is J of :mod:`lommel.estimation.focal_model`; a Gaussian window of rms width w holds that
of ``4 pi w^2`` pixels.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array, Numbers, numbers
from lommel.estimation.focal_model import FocalLight, FocalModel, transfer_curve
from lommel.optics.base_pupil import object_distances
from lommel.optics.lens import Lens, pixel_of
from lommel.recorded.noise import Noise

_MOST_PHOTONS = 1e12
# Radians of defocus between the points of derivatives by differences of the fourth order.
_STEP = 0.02
# Relative rounding error of the information, which equal photographs leave.
_ROUNDING = 1e-9
# Rounding error of a transfer function; those before and behind a focus differ by no more.
_ALIKE = 1e-9
# Radians of defocus between an object and the foci of the first trials.
_SPANS = np.geomspace(0.15, 30.0, 14)


def depth_precision(
    lenses: Sequence[Lens],
    distance: ArrayLike,
    pixel: float,
    *,
    noise: Noise,
    photons: ArrayLike | None = None,
    contrast: float = 0.35,
    window: float = 4.0,
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
        Of the photographs.
    photons : array_like, optional
        Mean electrons of a pixel: a number, or one for each photograph. By default ``noise.white``.
    contrast : float, default 0.35
        Texture contrast: rms over mean of the structures of 2 to 128 pixels in the focused image. The power spectrum
        falls as the inverse square of the frequency, as in natural scenes.
    window : float, default 4.0
        Rms width of the Gaussian window of constant depth, pixels, at least 1.

    Returns
    -------
    float or ndarray
        Standard error of the best unbiased estimate, metres, of the shape of `distance`; inf where depth cannot
        be determined: at infinity, without texture or light, and where all photographs change equally with depth.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range or of another type, if the pupil of a lens is not circular and radially
        symmetric.
    ToleranceError
        If there is so much defocus that its transfer function takes more than 4096 nodes along a line.

    Notes
    -----
    The Cramér-Rao bound for Gaussian textures (Whittle 1953, doi:10.1007/BF02590998), by finite differences over 0.08
    rad of defocus, with a relative error below 1e-3. A sensor samples a continuous scene: texture beyond its Nyquist
    frequency is as noise. Strong edges hold more information than such textures. Photographs are compared, as by
    :func:`lommel.imaging.depth_from_defocus`: the power spectrum of the texture is unknown, and one has no depth.

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
    surface = _surface(len(lenses), noise, photons, contrast, window)
    found = [_error(lenses, float(each), pitch, surface) for each in metres.ravel()]
    return numbers(np.array(found), metres.shape)


class Foci(NamedTuple):
    """The best pair of focus distances: the answer of :func:`best_foci`.

    Attributes
    ----------
    near, far : float
        Distances to focus on, metres; the far one may be infinite.
    error : float
        Standard error of the distance, metres, as of :func:`depth_precision`.
    lenses : tuple of Lens
        The lens focused at each of them.
    """

    near: float
    far: float
    error: float
    lenses: tuple[Lens, Lens]


def best_foci(
    lens: Lens,
    distance: float,
    pixel: float,
    *,
    noise: Noise,
    photons: float | None = None,
    contrast: float = 0.35,
    window: float = 4.0,
) -> Foci:
    """Return the two focus distances that give the best depth precision for a surface.

    Parameters
    ----------
    lens : Lens
        Its own focus distance is ignored.
    distance : float
        Distance of the surface, metres.
    pixel, noise, photons, contrast, window
        As of :func:`depth_precision`.

    Returns
    -------
    Foci
        The best pair with one focus in front of the surface and one behind it, to about 1 % of their distance from
        it. For a range of depths choose foci at or beyond its ends, and compare :func:`depth_precision` in between.

    Raises
    ------
    TypeError, ValueError
        As of :func:`depth_precision`, and if no pair determines the distance.

    Examples
    --------
    >>> lens = lm.Lens(focal_length=35e-3, f_number=8.0, focus_distance=1.5, wavelength=540e-9)
    >>> best = lm.best_foci(lens, 1.5, 4e-6, noise=lm.Noise(white=1e4, read=3))
    >>> f"{best.near:.2f} m and {best.far:.2f} m: {1e3 * best.error:.2f} mm"
    '1.33 m and 1.76 m: 1.44 mm'
    """
    from scipy.optimize import minimize

    pitch = pixel_of([lens], pixel)
    metres = validation.real("distance", distance, above=0.0, unit="metres")
    surface = _surface(2, noise, photons, contrast, window)
    # C_d = pi a^2 / (2 lambda) times the error of vergence.
    per_radian = 2.0 * lens.wavelength / (math.pi * (0.5 * lens.aperture_diameter) ** 2)

    def focused(spans: Array) -> list[Lens] | None:
        vergence = 1.0 / metres + per_radian * np.exp(spans) * [1.0, -1.0]
        if not (vergence[1] >= 0.0 and vergence[0] < 1.0 / lens.focal_length):
            return None
        return [lens.focused(1.0 / each if each > 0.0 else math.inf) for each in vergence.tolist()]

    def cost(spans: Array) -> float:
        pair = focused(spans)
        return math.inf if pair is None else _error(pair, metres, pitch, surface)

    # The pair is symmetric about the object at first; spans are in logarithms, so that they stay positive.
    starts = [np.log([each, each]) for each in _SPANS]
    first = min(starts, key=cost)
    if not math.isfinite(cost(first)):
        raise ValueError(
            f"no pair of foci determines the distance {metres:g} m: there is no texture, no light, or no focus "
            "distance between the focal length and infinity"
        )
    found = minimize(cost, first, method="Nelder-Mead", options={"xatol": 0.01, "fatol": 1e-4 * cost(first)})
    pair = focused(found.x)
    assert pair is not None
    return Foci(pair[0].focus_distance, pair[1].focus_distance, float(found.fun), (pair[0], pair[1]))


class _Surface(NamedTuple):
    """Electrons of a pixel of each photograph, read noise, contrast and window."""

    light: Array
    read: float
    contrast: float
    window: float


def _surface(count: int, noise: Noise, photons: ArrayLike | None, contrast: float, window: float) -> _Surface:
    validation.instance("noise", noise, Noise)
    read = noise.read
    if not isinstance(read, float) or not isinstance(noise.white, float | None):
        raise ValueError("noise must be the same for all pixels: white and read must be numbers")
    if (given := noise.white if photons is None else photons) is None:
        raise ValueError("photons must be given, the mean electrons of a pixel, where noise has no white")
    light = validation.real_array("photons", given, least=0.0, most=_MOST_PHOTONS)
    if light.shape not in ((), (count,)):
        raise ValueError(f"photons must be a number or {count} of them, got shape {light.shape}")
    contrast = validation.real("contrast", contrast, least=0.0, below=1e3)
    window = validation.real("window", window, least=1.0, below=1e6, unit="pixels")
    # Of light over the excess, and the read noise over it, photons have Poisson's variance.
    light = np.broadcast_to(light / noise.excess, count)
    return _Surface(light, read / noise.excess, contrast, window)


def _error(lenses: Sequence[Lens], distance: float, pixel: float, surface: _Surface) -> float:
    """Return the standard error of one distance, metres."""
    lighted = np.flatnonzero(surface.light)
    if math.isinf(distance) or not surface.contrast or not lighted.size:
        return math.inf
    seen, light = [lenses[int(k)] for k in lighted], surface.light[lighted]
    widest = max(lens.aperture_diameter for lens in seen)
    # In vergence; the widest aperture changes fastest.
    step = _STEP * 2.0 * min(lens.wavelength for lens in seen) / (math.pi * (0.5 * widest) ** 2)
    step = min(step, 0.4 / distance)  # not beyond infinity
    around = 1.0 / distance + step * np.array([-2.0, -1.0, 1.0, 2.0, 0.0])
    frames = FocalLight(float(light[0]), surface.read, tuple((light / light[0]).tolist()), surface.contrast)

    def own_light(lens: Lens, vergence: Array, _: object, pitch: float) -> Callable[[Array], Array]:
        return transfer_curve(lens, vergence, [(lens.wavelength, 1.0)], pitch)

    model = FocalModel.of(seen, around, (), pixel, frames, transfer=own_light)
    h = model.transfer
    if np.abs(h[:2] - h[3:1:-1]).max() <= _ALIKE:
        return math.inf
    # The five-point formula, with an error of the fourth order in the step.
    slope = (h[0] - h[3] + 8.0 * (h[2] - h[1])) / (12.0 * step)
    total = float(model.at(slice(4, 5)).information(slope[None])[0])
    most = model.texture * (slope * slope).sum(0)
    if total <= _ROUNDING * float(most @ model.band.share):
        return math.inf
    # d(1 / v) = -dv / v^2; a Gaussian window of rms width w has 4 pi w^2 independent pixels.
    return distance**2 / math.sqrt(total * (4.0 * math.pi * surface.window**2))
