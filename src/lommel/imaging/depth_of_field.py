"""The photograph that a lens takes of a scene whose sharp image and depth are known."""

from __future__ import annotations

from typing import Unpack

from numpy.typing import ArrayLike

from lommel.base.options import require_known, shares
from lommel.imaging.plan import FocusPlan
from lommel.imaging.scene import Photograph
from lommel.imaging.settings import Keywords, Settings
from lommel.optics.lens import Lens


@shares(Keywords, Settings)
def depth_of_field(
    image: ArrayLike, depth: ArrayLike, lens: Lens, pixel: float, *, encoding: str, **options: Unpack[Keywords]
) -> Photograph:
    """Blur a sharp image as a lens would, each point by its own distance, with diffraction, aberration and colour.

    Every point of the image spreads its own pixel-averaged PSF; see :class:`lommel.imaging.blur.DepthBlur`,
    and :func:`lommel.imaging.layers.occlude` of what hides what.

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
    {options}

    Returns
    -------
    Photograph

    Raises
    ------
    TypeError, ValueError
        If an argument is unknown or out of range, if shapes do not match, if the lens is not radially symmetric, if
        the blur exceeds `largest`, or if an image has two or four channels and no `wavelengths` are given: it may
        have alpha.
    """
    require_known(depth_of_field, options, Keywords)
    return FocusPlan(image, depth, lens, pixel, encoding=encoding, **options)()
