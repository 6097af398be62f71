"""The photograph that a lens takes of a scene whose sharp image and depth are known."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, DTypeLike

from lommel.imaging.blur import Spectrum
from lommel.imaging.plan import FocusPlan
from lommel.imaging.scene import Photograph
from lommel.optics.lens import Lens


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
    return FocusPlan(
        image,
        depth,
        lens,
        pixel,
        encoding=encoding,
        occlusion=occlusion,
        wavelengths=wavelengths,
        missing=missing,
        border=border,
        energy=energy,
        tol=tol,
        largest=largest,
        dtype=dtype,
        threads=threads,
    )()
