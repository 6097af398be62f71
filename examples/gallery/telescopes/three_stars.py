"""
Phase retrieval from three star images
======================================

The wavefront of a telescope from three images of a star, in focus and on either side of it (phase diversity). A
single image leaves the sign of even aberrations open; together they determine fifteen Zernike terms to a thousandth
of a wave.
"""

import matplotlib.pyplot as plt
import numpy as np

import lommel as lm
from lommel.special import zernike

telescope = {"obscuration": 0.3, "wavelength": 700e-9, "f_number": 15.0}
pixel, defocus = 5.25e-6, [-4.0, 0.0, 4.0]
camera = lm.Noise(white=0.8, read=3.0, offset=100.0)  # electrons per count, rms electrons, counts

# %%
# The ground truth: half a radian of astigmatism, coma, spherical aberration and trefoil. The stars have arbitrary
# subpixel positions, and one image is brighter.

true = lm.Wavefront.zernike({4: 0.2, 5: 0.5, 7: -0.35, 9: 0.25, 11: 0.3}, order="noll")
rows, columns = np.array([20.3, 19.6, 20.1]), np.array([19.8, 20.4, 20.2])
light = lm.Pupil(true + lm.Wavefront(defocus=defocus), **telescope)
psf = lm.psf(light, 41, pixel, center=(rows, columns))
electrons = np.array([8e4, 1.2e5, 8e4])[:, None, None] * psf.values + 8.0
stars = np.round(camera.record(electrons, seed=1885))

figure, axes = plt.subplots(1, 3, figsize=(9, 3.4), layout="constrained")
for image, extra, ax in zip(stars, defocus, axes, strict=True):
    shown = ax.imshow(np.sqrt(np.maximum(image - 95.0, 0.0)), cmap="inferno")
    ax.set_title(f"$C_d$ {extra:+g} rad: {image.max():.0f} counts at most".replace("-", "−"), fontsize=9)
    ax.set_xlabel("column (pixels)")
axes[0].set_ylabel("row (pixels)")

# %%
# Known are aperture, wavelength, pixel, camera noise and sensor displacement. Position, flux and background of each
# image are estimated jointly.

found = lm.retrieve(stars, lm.Pupil(**telescope), pixel=pixel, noise=camera, defocus=defocus, terms=15)
print(found.message)
found.plot()
plt.gcf().set_size_inches(10.5, 5.6)

# %%
# Estimates beside the ground truth, with standard errors.

truth = true.to_zernike()
waves, errors = found.in_unit("waves")
for term, value in waves.items():
    expected = float(truth.get(term, 0.0)) / (2.0 * np.pi)
    name = zernike.name(*term)
    print(f"{name:24s} {value:+.4f} +- {errors[term]:.4f} waves rms, in truth {expected:+.4f}")
off = np.array([(value - truth.get(term, 0.0)) / found.errors[term] for term, value in found.coefficients.items()])
assert found.converged
assert np.abs(off).max() < 4.0

plt.show()
