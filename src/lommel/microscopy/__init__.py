"""What microscopes make of PSFs: with pinholes, two photons, sheets of light, of beads and of whole specimens."""

from lommel.microscopy.made import bead, confocal, light_sheet, two_photon
from lommel.microscopy.stack_blur import StackBlur, deconvolve

__all__ = ["StackBlur", "bead", "confocal", "deconvolve", "light_sheet", "two_photon"]
