"""Photographs of one scene as depth from defocus takes them: electrons of equal exposures, and what to leave out."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.encoding import to_light
from lommel.estimation.noise import Noise
from lommel.optics.lens import Lens

MAGNIFICATIONS = ("registered", "lens")
_LEAK, _FAR = 0.02, 6.0  # of amplitude, and from how many windows away
_LEAST = 1e-3  # of the mean variance, for pixels of no light that are read without noise


@dataclass(frozen=True, eq=False)
class Exposures:
    """Several photographs of one scene.

    Attributes
    ----------
    images : ndarray of float32, shape (channels, photographs, height, width)
        Electrons, over the relative exposure of each photograph.
    variances : ndarray of float32, of that shape
        Of the noise of each pixel, from the light around it.
    valid : ndarray of bool, shape (height, width)
        Whether all photographs and channels know a pixel.
    exposures : tuple of float
        Light of each photograph over that of the first.
    """

    images: NDArray[np.float32]
    variances: NDArray[np.float32]
    valid: NDArray[np.bool_]
    exposures: tuple[float, ...]


def expose(
    photographs: Sequence[ArrayLike],
    lenses: Sequence[Lens],
    *,
    encoding: str,
    noise: Noise,
    exposures: Sequence[float] | None,
    magnification: str,
    saturation: float | None,
    window: float,
) -> Exposures:
    """Return photographs as electrons; arguments as of :func:`lommel.imaging.depth_from_defocus`."""
    stored = [_checked(f"photographs[{k}]", one) for k, one in enumerate(photographs)]
    shapes = [one.shape for one in stored]
    if len(set(shapes)) > 1:
        raise ValueError(f"photographs must be of one shape, got {', '.join(map(str, shapes))}")
    electrons, known = zip(
        *(_electrons(f"photographs[{k}]", one, encoding, noise, saturation) for k, one in enumerate(stored)),
        strict=True,
    )
    images = np.stack(electrons, axis=1)
    valid = np.all(known, axis=0)
    if not valid.any():
        raise ValueError("photographs have no pixel that all of them know: they are NaN or saturated")
    if validation.choice("magnification", magnification, MAGNIFICATIONS) == "lens":
        images, valid = _rescaled(images, valid, lenses)
    light = _relative(images[..., valid], exposures)
    mean = _smooth(images, window)
    variances = noise.variance(np.maximum(mean, 0.0)) + _leaked(images - mean, window)
    over = np.asarray(light)[:, None, None]
    variances = np.maximum(variances, _LEAST * float(variances.mean())) / over**2
    if not np.all(variances > 0.0):
        raise ValueError("noise must be above 0: the photographs hold no light, and reading adds no noise")
    return Exposures((images / over).astype(np.float32), variances.astype(np.float32), valid, light)


def _smooth(images: NDArray[np.float64], width: float) -> NDArray[np.float64]:
    """Return means in nearly Gaussian windows of an rms width, three boxes on one another."""
    from scipy.ndimage import uniform_filter1d

    side = max(1, round(math.sqrt(4.0 * width**2 + 1.0)))
    for axis in (-2, -1):
        for _ in range(3):
            images = uniform_filter1d(images, side, axis=axis, mode="reflect")
    return images


def _leaked(texture: NDArray[np.float64], window: float) -> NDArray[np.float64]:
    """Return what stronger texture beyond a window adds to the noise in it, for no filter ends with the window."""
    energy = texture**2
    return _LEAK**2 * np.maximum(_smooth(energy, _FAR * window) - _smooth(energy, window), 0.0)


def _checked(name: str, photograph: ArrayLike) -> NDArray[Any]:
    values = validation.array(name, photograph)
    if values.ndim not in (2, 3) or 0 in values.shape:
        raise ValueError(
            f"{name} must have the shape (height, width) or (height, width, channels), got {values.shape}"
        )
    return values


def _electrons(
    name: str, values: NDArray[Any], encoding: str, noise: Noise, saturation: float | None
) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """Return the electrons of one photograph, channels first, and which pixels are known; those filled by others."""
    known = np.ones(values.shape, dtype=np.bool_)
    if values.dtype.kind == "f":
        known = np.isfinite(values)
    elif values.dtype.kind == "u":
        known = values < np.iinfo(values.dtype).max
    if saturation is not None:
        with np.errstate(invalid="ignore"):
            known &= values < validation.real("saturation", saturation, above=0.0)
    pixels: NDArray[np.bool_] = np.asarray(known.reshape(*known.shape[:2], -1).all(axis=2))
    if not pixels.all() and pixels.any():
        from scipy.ndimage import distance_transform_edt

        nearest = distance_transform_edt(~pixels, return_distances=False, return_indices=True)
        values = values[tuple(nearest)]
    elif not pixels.any():
        return np.zeros((1, *pixels.shape)), pixels
    light = to_light(name, values, encoding, np.float64)
    return noise.electrons(np.moveaxis(light.reshape(*pixels.shape, -1), 2, 0)), pixels


def _relative(images: NDArray[np.float64], exposures: Sequence[float] | None) -> tuple[float, ...]:
    """Return the light of each photograph over that of the first, as stated or as measured."""
    if exposures is not None:
        given = validation.real_array("exposures", exposures)
        if given.shape != (images.shape[1],) or not np.all(given > 0.0):
            raise ValueError(
                f"exposures must be {images.shape[1]} numbers > 0, one for each photograph, "
                f"got {validation.shown(exposures)}"
            )
        return tuple((given / given[0]).tolist())
    sums = images.sum(axis=(0, 2))
    if not np.all(sums > 0.0):
        raise ValueError("photographs must hold light on average to compare their exposures; give exposures=")
    return tuple((sums / sums[0]).tolist())


def _rescaled(
    images: NDArray[np.float64], valid: NDArray[np.bool_], lenses: Sequence[Lens]
) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """Return images enlarged about their middle to the sensor distance of the first, and what is known of them."""
    from scipy.ndimage import affine_transform

    out, known = images.copy(), valid.copy()
    middle = 0.5 * (np.array(valid.shape) - 1.0)
    for k, lens in enumerate(lenses[1:], 1):
        scale = lens.sensor_distance / lenses[0].sensor_distance
        offset, zoom = middle * (1.0 - scale), scale * np.eye(2)
        for channel in range(len(images)):
            out[channel, k] = affine_transform(images[channel, k], zoom, offset, order=5, mode="mirror")
        whole = affine_transform(valid.astype(np.float64), zoom, offset, order=1, mode="constant", cval=0.0)
        known &= whole > 1.0 - 1e-6
    return out, known
