"""Microscopy: confocal, two-photon, STED and light-sheet PSFs, images of beads, and deconvolution of stacks."""

from lommel.microscopy.deconvolution import deconvolve
from lommel.microscopy.modalities import bead, confocal, light_sheet, sted, two_photon
from lommel.microscopy.restoration import RestoredChannel, RestoredStack, restore
from lommel.microscopy.stack_blur import StackBlur
from lommel.recorded.camera_noise import estimate_noise

__all__ = [
    "RestoredChannel",
    "RestoredStack",
    "StackBlur",
    "bead",
    "confocal",
    "deconvolve",
    "estimate_noise",
    "light_sheet",
    "restore",
    "sted",
    "two_photon",
]
