"""Microscopy: confocal, two-photon, STED and light-sheet PSFs, images of beads, and deconvolution of stacks."""

from lommel.measures.measured_psf import MeasuredPSF
from lommel.microscopy.deconvolution import DeconvolveOptions, deconvolve
from lommel.microscopy.modalities import bead, confocal, light_sheet, sted, two_photon
from lommel.microscopy.restored_stack import RestoredChannel, RestoredStack
from lommel.microscopy.stack_blur import StackBlur
from lommel.optics.layers.modality import Modality
from lommel.recorded.camera_noise import estimate_noise

__all__ = [
    "DeconvolveOptions",
    "MeasuredPSF",
    "Modality",
    "RestoredChannel",
    "RestoredStack",
    "StackBlur",
    "bead",
    "confocal",
    "deconvolve",
    "estimate_noise",
    "light_sheet",
    "sted",
    "two_photon",
]
