"""What microscopes make of PSFs: by pinholes, two photons, depletion, sheets, of beads and of whole specimens."""

from lommel.microscopy.deconvolution import deconvolve
from lommel.microscopy.modalities import bead, confocal, light_sheet, sted, two_photon
from lommel.microscopy.stack_blur import StackBlur

__all__ = ["StackBlur", "bead", "confocal", "deconvolve", "light_sheet", "sted", "two_photon"]
