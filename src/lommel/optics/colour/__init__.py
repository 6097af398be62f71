"""Wavelengths, the channels of a sensor, and the dispersion of a lens."""
