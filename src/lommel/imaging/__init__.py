"""What PSFs are for: images as a lens records them."""

from lommel.imaging.blur import DepthBlur
from lommel.imaging.chunks import depth_of_field_of_chunks
from lommel.imaging.defocus.depth import DefocusDepth, depth_from_defocus
from lommel.imaging.field.blur import FieldBlur
from lommel.imaging.linear import LinearBlur
from lommel.imaging.occlusion import Occlusion
from lommel.imaging.photograph import FocusPlan, depth_of_field
from lommel.imaging.restoration.restore import restore
from lommel.imaging.restoration.restore_with import Restoration, restore_with
from lommel.imaging.restoration.richardson_lucy import RichardsonLucy
from lommel.imaging.restoration.tiles import restore_by_tiles
from lommel.imaging.restoration.total_variation import TotalVariation
from lommel.imaging.scene import Photograph
from lommel.imaging.slopes import BlurSlopes
from lommel.imaging.tiles import depth_of_field_by_tiles
from lommel.imaging.traced_blur import traced_blur
from lommel.io.depthmaps import read_depth, write_depth
from lommel.io.photos import Exif, PhotoError, Picture, read_photo, write_photo
from lommel.optics.colour.spectrum import RED_GREEN_BLUE

__all__ = [
    "RED_GREEN_BLUE",
    "BlurSlopes",
    "DefocusDepth",
    "DepthBlur",
    "Exif",
    "FieldBlur",
    "FocusPlan",
    "LinearBlur",
    "Occlusion",
    "PhotoError",
    "Photograph",
    "Picture",
    "Restoration",
    "RichardsonLucy",
    "TotalVariation",
    "depth_from_defocus",
    "depth_of_field",
    "depth_of_field_by_tiles",
    "depth_of_field_of_chunks",
    "read_depth",
    "read_photo",
    "restore",
    "restore_by_tiles",
    "restore_with",
    "traced_blur",
    "write_depth",
    "write_photo",
]
