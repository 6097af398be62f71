"""The sharp scene behind a photograph whose depth, lens and noise are known."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any, Unpack, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.encoding import to_light
from lommel.base.options import shares
from lommel.estimation.noise import Noise
from lommel.field.maps import FieldMap
from lommel.imaging.blur import DepthBlur, require_lens
from lommel.imaging.field.blur import FieldBlur, FieldKeywords
from lommel.imaging.linear import LinearBlur
from lommel.imaging.occlusion import Occlusion
from lommel.imaging.restoration.observed import Method
from lommel.imaging.restoration.restore_with import (
    Progress,
    Restoration,
    checked_method,
    checked_progress,
    restore_with,
)
from lommel.imaging.scene import fill_missing, stored
from lommel.imaging.settings import Keywords, Settings
from lommel.optics.lens import Lens


@shares(Keywords, Settings)
def restore(
    photo: ArrayLike,
    depth: ArrayLike | None,
    lens: Lens | FieldMap,
    pixel: float,
    *,
    encoding: str,
    noise: Noise,
    method: Method | None = None,
    saturation: float | None = None,
    progress: Progress | None = None,
    **options: Unpack[Keywords],
) -> Restoration:
    """Undo the blur of a photograph as far as its noise lets it: every point by its own PSF, near before far.

    The inverse of :func:`lommel.imaging.depth_of_field`: the same operator, exact to its tolerances, and its exact
    transpose.

    Parameters
    ----------
    photo : array_like, shape (height, width) or (height, width, channels)
        Unsigned integers (white is their largest value) or floats (white is 1), not sharpened, nor freed of noise. A
        NaN is a pixel of which nothing is known.
    depth : array_like, shape (height, width), or None
        Distance of each point from the lens, metres; may be infinite. None for a FieldMap.
    lens : Lens or FieldMap
        A lens with radially symmetric aberrations; or the wavefront over the field, of all the scene at its distance,
        the axis being in the middle of the photograph: see :class:`lommel.imaging.FieldBlur`.
    pixel : float
        Pixel pitch, metres.
    encoding : {"srgb", "linear"}
        Of the values of `photo`, and of the result.
    noise : Noise
        Of linear values whose white is 1, whatever `photo` holds: ``white=`` electrons at white.
    method : RichardsonLucy or TotalVariation, optional
        By default ``RichardsonLucy()``.
    saturation : float, optional
        Light, 1 being white, from which on pixels are saturated: they tell only that there was at least so much. By
        default 1; of integers the largest value always is. Infinity for floats that are right beyond.
    progress : callable, optional
        As of :func:`lommel.imaging.restore_with`.
    {options}

    Returns
    -------
    Restoration

    Raises
    ------
    TypeError, ValueError
        If an argument is unknown or out of range, if shapes do not match, if the lens is not radially symmetric, if
        the blur exceeds `largest`, or if no pixel is known.

    Examples
    --------
    >>> lens = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
    >>> depth = np.full((40, 60), 2.3)
    >>> scene = np.full((40, 60), 30000, np.uint16)
    >>> scene[10:30, 20:40] = 50000
    >>> photo = lm.imaging.depth_of_field(scene, depth, lens, 8e-6, encoding="srgb").values
    >>> noise = lm.Noise(white=5000, read=3.0)
    >>> sharp = lm.imaging.restore(photo, depth, lens, 8e-6, encoding="srgb", noise=noise)
    >>> sharp.values.dtype, sharp.discrepancy < sharp.before
    (dtype('uint16'), True)
    """
    settings = Settings.of(restore, options, Keywords)
    way = checked_method(method)
    checked_progress(progress)
    validation.instance("noise", noise, Noise)
    given = validation.array("photo", photo)
    light, limit = recorded(given, encoding, saturation)
    if isinstance(lens, FieldMap):
        blur: LinearBlur = _over_the_field(given.shape, depth, lens, pixel, settings, options)
    else:
        blur = blur_of(given.shape, depth, lens, pixel, settings)
    found = restore_with(light, blur, noise, method=way, saturation=limit, progress=progress)
    values, clipped = stored(found.values, encoding, given.dtype, settings.threads or 0)
    return replace(found, values=values, clipped=clipped)


def recorded(photo: NDArray[Any], encoding: str, saturation: float | None = None) -> tuple[NDArray[Any], float]:
    """Return the light of a photograph, NaN where it is unknown, and the light from which on it is saturated.

    Parameters
    ----------
    photo : ndarray
    encoding : {"srgb", "linear"}
    saturation : float, optional
        As of :func:`lommel.imaging.restore`.

    Returns
    -------
    light : ndarray of float64, of the shape of `photo`
    saturation : float

    Raises
    ------
    TypeError, ValueError
        If `photo` is no image, is infinite, or has no pixel that is known.
    """
    if photo.ndim not in (2, 3) or 0 in photo.shape:
        raise ValueError(f"photo must have the shape (height, width) or (height, width, channels), got {photo.shape}")
    limit = 1.0
    if saturation is not None:
        limit = validation.real("saturation", saturation, above=0.0, infinite=True)
    unknown = np.isnan(photo) if photo.dtype.kind == "f" else np.zeros(photo.shape, dtype=bool)
    light = to_light("photo", np.where(unknown, np.asarray(0, photo.dtype), photo), encoding, np.float64)
    if photo.dtype.kind == "u":
        limit = min(limit, 1.0)
    light[unknown] = np.nan
    if not np.any(light < limit):
        raise ValueError(
            f"photo must have pixels that are neither NaN nor saturated, got none below {limit:g}; white is 1, "
            "and saturation= says where else pixels are full"
        )
    return light, limit


def _over_the_field(
    shape: tuple[int, ...],
    depth: ArrayLike | None,
    field_map: FieldMap,
    pixel: float,
    settings: Settings,
    given: Mapping[str, Any],
) -> FieldBlur:
    """Return the operator of a map, with its middle in the middle of a photograph of this shape."""
    if depth is not None:
        raise ValueError(
            "depth must be None with a FieldMap, which has the defocus of one distance; of several, hand "
            "FieldBlur(field_map, shape, pixel, depth=, lens=) to lommel.imaging.restore_with"
        )
    for name in ("occlusion", "missing", "tol"):
        if name in given:
            raise ValueError(
                f"{name} is for photographs with a depth, got a FieldMap; leave it out, or hand a FieldBlur to "
                "lommel.imaging.restore_with"
            )
    wavelength = field_map.pupil_without_wavefront.wavelength
    channels = None
    if wavelength is not None or len(shape) == 3 or settings.wavelengths is not None:
        channels = settings.channels(shape, wavelength)
    options = {name: getattr(settings, name) for name in FieldKeywords.__annotations__}
    return FieldBlur(field_map, (shape[0], shape[1]), pixel, channels=channels, **cast("FieldKeywords", options))


def blur_of(
    shape: tuple[int, ...], depth: ArrayLike | None, lens: Lens, pixel: float, settings: Settings
) -> LinearBlur:
    """Return the operator that blurred a photograph of this shape."""
    require_lens(lens, "photo, depth, lens, pixel")
    if depth is None:
        raise ValueError("depth must be the distance of each point, metres, where lens is a Lens, got None")
    distances = np.asarray(fill_missing(depth, settings.missing))
    if distances.shape != shape[:2]:
        raise ValueError(f"depth must have the shape of the photo, {shape[:2]}, got {distances.shape}")
    blur = DepthBlur(distances, lens, pixel, channels=settings.channels(shape, lens.wavelength), **settings.of_blur)
    return Occlusion(blur) if settings.occlusion else blur
