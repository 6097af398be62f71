"""The photograph that a lens takes of a scene whose sharp image and depth are known."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from lommel import validation
from lommel.imaging.blur import RED_GREEN_BLUE, DepthBlur, Spectrum
from lommel.imaging.encoding import from_light, to_light
from lommel.imaging.layers import occlude
from lommel.lens import Lens

MISSING = ("raise", "nearest", "infinity")


@dataclass(frozen=True, eq=False)
class Photograph:
    """What :func:`depth_of_field` returns; an array where one is wanted.

    Attributes
    ----------
    values : ndarray
        Of the shape, type and encoding of the image that was given.
    lost : float
        Largest share of the light of a point that its window did not hold, and that was spread over the window.
    error : float
        Largest error of interpolated windows over their peak that was found.
    window : int
        Side of the largest window, pixels.
    """

    values: NDArray[Any]
    lost: float
    error: float
    window: int

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> NDArray[Any]:
        """Return the values."""
        return np.array(self.values, dtype=dtype, copy=copy)


def depth_of_field(
    image: ArrayLike,
    depth: ArrayLike,
    lens: Lens,
    pixel: float,
    *,
    encoding: str,
    occlusion: bool = False,
    wavelengths: Sequence[Spectrum] | None = None,
    missing: str = "raise",
    border: str = "reflect",
    energy: float = 0.98,
    tol: float = 1e-4,
    largest: int | None = None,
    dtype: DTypeLike = np.float32,
    threads: int | None = None,
) -> Photograph:
    """Blur a sharp image as a lens would, each point by its own distance, with diffraction, aberration and colour.

    Every point of the image spreads its own pixel-averaged PSF; see :class:`lommel.imaging.blur.DepthBlur`.

    Parameters
    ----------
    image : array_like, shape (height, width) or (height, width, channels)
        Unsigned integers (white is their largest value) or floats (white is 1).
    depth : array_like, shape (height, width)
        Distance of each point from the lens, metres; may be infinite.
    lens : Lens
        With radially symmetric aberrations.
    pixel : float
        Pixel pitch, metres.
    encoding : {"srgb", "linear"}
        Of the values of `image`, and of the result.
    occlusion : bool, default False
        Whether near points hide far ones; see :func:`lommel.imaging.layers.occlude`. Without, light is only added:
        what lies behind a near object bleeds over its edges.
    wavelengths : sequence, optional
        A wavelength (metres), or pairs of wavelength and weight, for each channel. By default that of the lens for a
        grey image, and 600, 540 and 460 nm for one of three channels.
    missing : {"raise", "nearest", "infinity"}, default "raise"
        What a NaN in `depth` means: an error, the nearest known depth, or no object.
    border, energy, tol, largest, dtype, threads
        As of :class:`lommel.imaging.blur.DepthBlur`; `dtype` is that of the sums.

    Returns
    -------
    Photograph

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, if shapes do not match, or if an image has two or four channels and no
        `wavelengths` are given: it may have alpha.
    """
    if not isinstance(occlusion, bool | np.bool_):
        raise TypeError(f"occlusion must be True or False, got {occlusion!r}")
    given = np.asarray(image)
    if given.ndim not in (2, 3) or 0 in given.shape:
        raise ValueError(f"image must have the shape (height, width) or (height, width, channels), got {given.shape}")
    distances = fill_missing(depth, missing)
    if distances.shape != given.shape[:2]:
        raise ValueError(f"depth must have the shape of the image, {given.shape[:2]}, got {distances.shape}")
    light = to_light("image", given, encoding, dtype)
    blur = DepthBlur(
        lens,
        distances,
        pixel,
        channels=channels_of(given, lens, wavelengths),
        border=border,
        energy=energy,
        tol=tol,
        largest=largest,
        dtype=dtype,
        threads=threads,
    )
    seen = occlude(blur, light) if occlusion else blur.forward(light)
    values = from_light(seen, encoding, given.dtype)
    return Photograph(
        values,
        blur.lost,
        max(bank.error for bank in blur.banks),
        2 * max(bank.half for bank in blur.banks) + 1,
    )


def channels_of(image: NDArray[Any], lens: Lens, wavelengths: Sequence[Spectrum] | None) -> Sequence[Spectrum]:
    """Return the spectrum of each channel of an image."""
    if not isinstance(lens, Lens):
        raise TypeError(f"lens must be a Lens, got {lens!r}")
    count = 1 if image.ndim == 2 else image.shape[2]
    if wavelengths is not None:
        if not isinstance(wavelengths, Sequence | np.ndarray):
            raise TypeError(f"wavelengths must be a sequence, one for each channel, got {wavelengths!r}")
        if len(wavelengths) != count:
            raise ValueError(f"wavelengths must be one for each of the {count} channels, got {len(wavelengths)}")
        return wavelengths
    if count == 1:
        return (lens.wavelength,)
    if count == 3:
        return RED_GREEN_BLUE
    hint = "; drop the alpha channel" if count in (2, 4) else ""
    raise ValueError(f"an image of {count} channels needs wavelengths, one for each{hint}")


def fill_missing(depth: ArrayLike, missing: str) -> NDArray[Any]:
    """Return depths whose NaNs are filled as `missing` says."""
    validation.choice("missing", missing, MISSING)
    distances = np.asarray(depth)
    if distances.dtype.kind != "f" or missing == "raise" or not np.isnan(distances).any():
        return distances
    unknown = np.isnan(distances)
    if unknown.all():
        raise ValueError("depth is NaN everywhere")
    if missing == "infinity":
        return np.where(unknown, np.inf, distances)
    from scipy.ndimage import distance_transform_edt

    nearest = distance_transform_edt(unknown, return_distances=False, return_indices=True)
    return np.asarray(distances[tuple(nearest)])
