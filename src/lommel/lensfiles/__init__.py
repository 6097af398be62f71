"""Lens files, microscope files, and tables of Zernike coefficients and spectra."""
