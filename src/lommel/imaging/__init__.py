"""Images as a lens records them: depth of field, occlusion, blur over the field, deblurring, depth from defocus."""

from lommel.deconvolve.algorithms import Restoration, RichardsonLucy, TotalVariation
from lommel.deconvolve.linear import LinearBlur
from lommel.imaging.blur import BlurSlopes, DepthBlur
from lommel.imaging.datasets import LensRanges, Rendered, render_dataset
from lommel.imaging.defocus_depth import DefocusDepth, DefocusOptions, depth_from_defocus
from lommel.imaging.defocus_verdict import DefocusVerdict
from lommel.imaging.field_blur import FieldBlur
from lommel.imaging.live import LiveDepth, LiveDepthMap, LiveDepthOptions, LiveSharpen
from lommel.imaging.occlusion import Occlusion
from lommel.imaging.one_pass import OnePass
from lommel.imaging.photograph import FocusPlan, Photograph, depth_of_field, field_photograph
from lommel.imaging.restoration import restore, restore_with
from lommel.imaging.traced_blur import traced_blur
from lommel.imaging.traced_sensor import traced_demosaic, traced_mosaic, traced_noise
from lommel.io.depth_maps import read_depth, write_depth
from lommel.io.photos import Exif, PhotoError, Picture, read_photo, write_photo
from lommel.measures.slanted_edge import slanted_edge
from lommel.optics.colour.spectrum import RED_GREEN_BLUE

__all__ = [
    "RED_GREEN_BLUE",
    "BlurSlopes",
    "DefocusDepth",
    "DefocusOptions",
    "DefocusVerdict",
    "DepthBlur",
    "Exif",
    "FieldBlur",
    "FocusPlan",
    "LensRanges",
    "LinearBlur",
    "LiveDepth",
    "LiveDepthMap",
    "LiveDepthOptions",
    "LiveSharpen",
    "Occlusion",
    "OnePass",
    "PhotoError",
    "Photograph",
    "Picture",
    "Rendered",
    "Restoration",
    "RichardsonLucy",
    "TotalVariation",
    "depth_from_defocus",
    "depth_of_field",
    "field_photograph",
    "read_depth",
    "read_photo",
    "render_dataset",
    "restore",
    "restore_with",
    "slanted_edge",
    "traced_blur",
    "traced_demosaic",
    "traced_mosaic",
    "traced_noise",
    "write_depth",
    "write_photo",
]
