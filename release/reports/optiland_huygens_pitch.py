"""optiland: the Strehl ratio of HuygensPSF for even and odd image sizes, and the pitch of its pixels."""

import numpy as np
from optiland.psf import HuygensPSF
from optiland.samples.objectives import CookeTriplet

for size in (32, 33, 64, 65):
    psf = HuygensPSF(CookeTriplet(), (0, 0), "primary", num_rays=64, image_size=size, pixel_pitch=0.0005)
    x = np.asarray(psf._get_image_coordinates()[0])[0]
    strehl, top = float(psf.strehl_ratio()), float(np.max(psf.psf)) / 100
    apart, stated = 1e3 * (x[1] - x[0]), 1e3 * psf.pixel_pitch
    print(f"{size} strehl_ratio() = {strehl:.4f}, largest value / 100 = {top:.4f},", end=" ")
    print(f"distance of samples = {apart:.5f} um, pixel_pitch = {stated:.5f} um,", end=" ")
    print(f"axis sampled: {bool((abs(x) < 1e-9).any())}")
