"""poppy: measure_fwhm of an Airy pattern, whose full width at half maximum is 1.0290 lambda/D."""

import numpy as np
import poppy
from astropy.io import fits
from scipy.special import j1

for pixel in (0.05, 0.1, 0.25):  # lambda/D
    half = int(8 / pixel)
    y, x = np.mgrid[-half : half + 1, -half : half + 1] * pixel
    v = np.pi * np.hypot(x, y)
    v[half, half] = 1.0
    image = (2 * j1(v) / v) ** 2
    image[half, half] = 1.0
    hdu = fits.HDUList([fits.PrimaryHDU(image)])
    hdu[0].header["PIXELSCL"] = pixel
    fitted, rings = poppy.utils.measure_fwhm(hdu), float(poppy.utils.measure_fwhm_radprof(hdu, nowarn=True))
    print(f"pixels of {pixel}: measure_fwhm {fitted:.4f}, measure_fwhm_radprof {rings:.4f}, exact 1.0290")
