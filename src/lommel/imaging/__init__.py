"""What PSFs are for: images as a lens records them."""

from lommel.imaging.blur import RED_GREEN_BLUE, DepthBlur
from lommel.imaging.depth_of_field import Photograph, depth_of_field
from lommel.imaging.plan import FocusPlan

__all__ = ["RED_GREEN_BLUE", "DepthBlur", "FocusPlan", "Photograph", "depth_of_field"]
