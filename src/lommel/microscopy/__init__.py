"""Microscopy: confocal, two-photon, STED and light-sheet PSFs, images of beads, and deconvolution of stacks."""

from lommel.microscopy.deconvolution import deconvolve
from lommel.microscopy.modalities import bead, confocal, light_sheet, sted, two_photon
from lommel.microscopy.stack_blur import StackBlur

__all__ = ["StackBlur", "bead", "confocal", "deconvolve", "light_sheet", "sted", "two_photon"]
