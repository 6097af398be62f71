"""What PSFs are for: images as a lens records them."""

from lommel.imaging.blur import RED_GREEN_BLUE, DepthBlur
from lommel.imaging.depth_of_field import Photograph, depth_of_field

__all__ = ["RED_GREEN_BLUE", "DepthBlur", "Photograph", "depth_of_field"]
