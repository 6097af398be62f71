r"""The achievable precision of depth from defocus (Cramér-Rao bound), and the best foci.

A texture has the power S; n photographs have the transfer functions h_i(u), u = 1 / distance, over their noise: their
spectra at one frequency are Gaussian of covariance ``S h h^T + 1``. The information of a pixel about u is
(Whittle 1953, doi:10.1007/BF02590998)

    J = mean over f of [ 2 S^2 (h.h')^2 / (1 + S h.h)^2  +  S^2 h.h h'_^2 / (1 + S h.h) ] ,

with ``h'_^2 = h'.h' - (h.h')^2 / h.h``, the part of the derivative orthogonal to h. The second term compares
photographs, and needs no knowledge of S; the first compares the blur of each with a known S. A Gaussian window of rms
width w holds the information of ``4 pi w^2`` pixels.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array, Numbers, numbers
from lommel.estimation.noise import Noise
from lommel.estimation.pixel_transfer import WindowError, half_window, pixel_of, pixel_transfer, texture_frequencies
from lommel.optics.base_pupil import object_distances
from lommel.optics.lens import Lens

_MOST_PHOTONS = 1e12
# Largest structures, pixels, of the texture whose contrast is given.
_SIDE = 128
# Radians of defocus between the points of derivatives by differences of the fourth order.
_STEP = 0.02
# Relative rounding error of the information, which equal photographs leave.
_ROUNDING = 1e-9
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
    known_texture: bool = False,
) -> Numbers:
    """Return the Cramér-Rao bound on the depth of a textured surface, as a standard deviation.

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
    known_texture : bool, default False
        Whether the power spectrum of the texture is known, so that one photograph determines its blur. By default
        photographs are compared, as by :func:`lommel.imaging.depth_from_defocus`.

    Returns
    -------
    float or ndarray
        Standard deviation of the best unbiased estimate, metres, of the shape of `distance`; inf where depth cannot
        be determined: at infinity, without texture or light, and where all photographs change equally with depth.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range or of another type, if the pupil of a lens is not circular and radially
        symmetric, or if the blur needs windows of more than 1025 x 1025 pixels.

    Notes
    -----
    The Cramér-Rao bound for Gaussian textures (Whittle 1953, doi:10.1007/BF02590998), by finite differences over
    0.08 rad of defocus, with a relative error below 1e-5. Strong edges hold more information than such textures.

    Examples
    --------
    >>> lens = lm.Lens(focal_length=35e-3, f_number=8.0, focus_distance=1.35, wavelength=540e-9)
    >>> pair = [lens, lens.focused(1.8)]
    >>> deviation = lm.depth_precision(pair, [1.4, 1.5, 1.6], 4e-6, noise=lm.Noise(white=1e4, read=3))
    >>> [f"{1e3 * each:.2f} mm" for each in deviation]
    ['1.87 mm', '1.46 mm', '1.71 mm']
    """
    pitch = pixel_of(lenses, pixel)
    metres = np.asarray(object_distances(distance))
    surface = _surface(len(lenses), noise, photons, contrast, window, known_texture)
    found = [_deviation(lenses, float(each), pitch, surface) for each in metres.ravel()]
    return numbers(np.array(found), metres.shape)


class Foci(NamedTuple):
    """The best pair of focus distances: the answer of :func:`best_foci`.

    Attributes
    ----------
    near, far : float
        Distances to focus on, metres; the far one may be infinite.
    deviation : float
        Standard deviation of the distance, metres, as of :func:`depth_precision`.
    lenses : tuple of Lens
        The lens focused at each of them.
    """

    near: float
    far: float
    deviation: float
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
    known_texture: bool = False,
) -> Foci:
    """Return the two focus distances that give the best depth precision for a surface.

    Parameters
    ----------
    lens : Lens
        Its own focus distance is ignored.
    distance : float
        Distance of the surface, metres.
    pixel, noise, photons, contrast, window, known_texture
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
    >>> f"{best.near:.2f} m and {best.far:.2f} m: {1e3 * best.deviation:.2f} mm"
    '1.33 m and 1.76 m: 1.44 mm'
    """
    from scipy.optimize import minimize

    pitch = pixel_of([lens], pixel)
    metres = validation.real("distance", distance, above=0.0, unit="metres")
    surface = _surface(2, noise, photons, contrast, window, known_texture)
    per_radian = 2.0 * lens.wavelength / (math.pi * (0.5 * lens.aperture_diameter) ** 2)

    def focused(spans: Array) -> list[Lens] | None:
        vergence = 1.0 / metres + per_radian * np.exp(spans) * [1.0, -1.0]
        if not (vergence[1] >= 0.0 and vergence[0] < 1.0 / lens.focal_length):
            return None
        return [lens.focused(1.0 / each if each > 0.0 else math.inf) for each in vergence.tolist()]

    def cost(spans: Array) -> float:
        pair = focused(spans)
        try:
            return math.inf if pair is None else _deviation(pair, metres, pitch, surface)
        except WindowError:
            return math.inf

    starts = [np.log([each, each]) for each in _SPANS]
    first = min(starts, key=cost)
    if not math.isfinite(cost(first)):
        if (pair := focused(starts[0])) is not None:
            _deviation(pair, metres, pitch, surface)  # raises if the windows are too large
        raise ValueError(
            f"no pair of foci determines the distance {metres:g} m: there is no texture, no light, or no focus "
            "distance between the focal length and infinity"
        )
    found = minimize(cost, first, method="Nelder-Mead", options={"xatol": 0.01, "fatol": 1e-4 * cost(first)})
    pair = focused(found.x)
    assert pair is not None
    return Foci(pair[0].focus_distance, pair[1].focus_distance, float(found.fun), (pair[0], pair[1]))


# Noise over light of each photograph; contrast, window, and whether the texture is known.
_Surface = tuple[Array, float, float, bool]


def _surface(
    count: int, noise: Noise, photons: ArrayLike | None, contrast: float, window: float, known: bool
) -> _Surface:
    validation.instance("noise", noise, Noise)
    if not all(isinstance(each, float | None) for each in (noise.white, noise.read)):
        raise ValueError("noise must be the same for all pixels: white and read must be numbers")
    if (given := noise.white if photons is None else photons) is None:
        raise ValueError("photons must be given, the mean electrons of a pixel, where noise has no white")
    light = validation.real_array("photons", given, least=0.0)
    if light.shape not in ((), (count,)):
        raise ValueError(f"photons must be a number or {count} of them, got shape {light.shape}")
    if light.max() > _MOST_PHOTONS:
        raise ValueError(f"photons must be at most {_MOST_PHOTONS:g}, got {light.max():g}")
    light = np.broadcast_to(light, count)
    with np.errstate(divide="ignore", invalid="ignore"):
        over = np.where(light > 0.0, noise.variance(light) / light / light, np.inf)
    contrast = validation.real("contrast", contrast, least=0.0, below=1e3)
    window = validation.real("window", window, least=1.0, below=1e6, unit="pixels")
    return np.sqrt(over), contrast, window, validation.truth("known_texture", known)


def _deviation(lenses: Sequence[Lens], distance: float, pixel: float, surface: _Surface) -> float:
    """Return the standard deviation of one distance, metres."""
    noise, contrast, window, known = surface
    if math.isinf(distance) or not contrast or not np.any(np.isfinite(noise)):
        return math.inf
    widest = max(lens.aperture_diameter for lens in lenses)
    step = _STEP * 2.0 * min(lens.wavelength for lens in lenses) / (math.pi * (0.5 * widest) ** 2)
    step = min(step, 0.4 / distance)  # not beyond infinity
    around = 1.0 / (1.0 / distance + step * np.array([-2.0, -1.0, 1.0, 2.0, 0.0]))
    half = half_window(lenses, around, pixel)
    side = max(_SIDE, 2 * half + 2)
    value, slope = np.zeros((2, len(lenses), side // 2 + 1, side // 2 + 1))
    for k, lens in enumerate(lenses):
        if math.isfinite(noise[k]):
            spectrum = [(lens.wavelength, 1.0)]
            values = pixel_transfer(lens, around, spectrum, pixel, (side, side), half).astype(np.float64) / noise[k]
            value[k] = values[4]
            slope[k] = (values[0] - values[3] + 8.0 * (values[2] - values[1])) / (12.0 * step)
    square, times = texture_frequencies((side, side))
    whole, share = texture_frequencies((_SIDE, _SIDE))
    texture = contrast**2 / float((share / whole).sum()) / square
    hh = (value * value).sum(axis=0)
    along = (value * slope).sum(axis=0)
    with np.errstate(divide="ignore", invalid="ignore"):
        across = np.where(hh > 0.0, (slope * slope).sum(axis=0) - along**2 / hh, 0.0)
    signal = 1.0 + texture * hh
    terms = texture**2 * hh * np.maximum(across, 0.0) / signal
    if known:
        terms += 2.0 * (texture * along / signal) ** 2
    total, most = (float((times * part).sum()) for part in (terms, texture * (slope * slope).sum(axis=0)))
    if total <= _ROUNDING * most:
        return math.inf
    return distance**2 / math.sqrt(total * (4.0 * math.pi * window**2))
