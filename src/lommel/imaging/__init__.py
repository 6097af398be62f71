"""Images as a lens records them: depth of field, occlusion, blur over the field, deblurring, depth from defocus."""

from lommel.deconvolve.algorithms import Restoration, RichardsonLucy, TotalVariation
from lommel.deconvolve.linear import LinearBlur
from lommel.imaging.alignment import Aligned, align
from lommel.imaging.blended import Blend
from lommel.imaging.blur import DepthBlur
from lommel.imaging.datasets import DatasetOptions, DatasetPicture, LensRanges, render_dataset
from lommel.imaging.defocus_depth import DefocusDepth, DefocusOptions, depth_from_defocus
from lommel.imaging.defocus_verdict import DefocusVerdict
from lommel.imaging.edge_chart import ChartEdge, EdgeChart, sfr_chart
from lommel.imaging.field_blur import FieldBlur
from lommel.imaging.focal_calibration import CalibratedPlane, FocalCalibration, calibrate_focus
from lommel.imaging.live import LiveDepth, LiveDepthMap, LiveDepthOptions, LiveSharpen
from lommel.imaging.occlusion import Occlusion
from lommel.imaging.one_pass import OnePass
from lommel.imaging.photograph import BlurOptions, FocusPlan, Rendered, depth_of_field, field_photograph
from lommel.imaging.restoration import RestoreOptions, restore
from lommel.imaging.slanted_edge import EdgeResponse, slanted_edge
from lommel.imaging.traced_blur import traced_blur
from lommel.imaging.traced_sensor import traced_noise
from lommel.io.depth_maps import DepthMapOptions, read_depth, write_depth
from lommel.io.photos import Exif, PhotoError, Photograph, read_photo, write_photo
from lommel.optics.colour.spectrum import RED_GREEN_BLUE

__all__ = [
    "RED_GREEN_BLUE",
    "Aligned",
    "Blend",
    "BlurOptions",
    "CalibratedPlane",
    "ChartEdge",
    "DatasetOptions",
    "DatasetPicture",
    "DefocusDepth",
    "DefocusOptions",
    "DefocusVerdict",
    "DepthBlur",
    "DepthMapOptions",
    "EdgeChart",
    "EdgeResponse",
    "Exif",
    "FieldBlur",
    "FocalCalibration",
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
    "Rendered",
    "Restoration",
    "RestoreOptions",
    "RichardsonLucy",
    "TotalVariation",
    "align",
    "calibrate_focus",
    "depth_from_defocus",
    "depth_of_field",
    "field_photograph",
    "read_depth",
    "read_photo",
    "render_dataset",
    "restore",
    "sfr_chart",
    "slanted_edge",
    "traced_blur",
    "traced_noise",
    "write_depth",
    "write_photo",
]
