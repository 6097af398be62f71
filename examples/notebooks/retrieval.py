# %% [markdown]
# # Phase retrieval: the wavefront from images of a star
#
# Three images of a star, in focus and on either side of it (phase diversity), determine the Zernike coefficients of a
# telescope, each with its standard error.

# %%
import matplotlib.pyplot as plt
import numpy as np

import lommel as lm
from lommel.special import zernike

telescope = {"obscuration": 0.3, "wavelength": 700e-9, "f_number": 15.0}
pixel, defocus = 5.25e-6, [-4.0, 0.0, 4.0]  # metres; radians at the edge of the pupil
noise = lm.Noise(read=3.0)  # electrons rms

# %% [markdown]
# ## The images
#
# Simulated with known aberrations, so that the answer can be compared: astigmatism, coma and spherical aberration.

# %%
true = lm.Wavefront.zernike({5: 0.5, 7: -0.35, 11: 0.3}, order="noll")
pupil = lm.Pupil(true + lm.Wavefront(defocus=defocus), **telescope)
stars = noise.record(1e5 * lm.psf(pupil, 35, pixel).values + 8.0, seed=3)

figure, panels = plt.subplots(1, 3, figsize=(9.0, 3.6), layout="constrained")
panels[0].set_ylabel("y (pixels)")
for panel, image, extra in zip(panels, stars, defocus, strict=True):
    panel.imshow(np.sqrt(np.maximum(image, 0.0)), cmap="inferno")
    panel.set_title(f"defocus {extra:+g} rad".replace("-", "−"))
    panel.set_xlabel("x (pixels)")

# %% [markdown]
# ## The fit
#
# Aperture, wavelength, pixel, noise and defocus of each image are known. Position, flux and background are estimated
# jointly.

# %%
found = lm.retrieve(stars, lm.Pupil(**telescope), pixel=pixel, noise=noise, defocus=defocus, terms=11)
print(found.message)

# %% [markdown]
# Estimated coefficients beside the true ones. The error bars are three standard errors.

# %%
truth = true.to_zernike()
names = [zernike.name(*term) for term in found.coefficients]
values = np.array(list(found.coefficients.values()))
errors = np.array([found.errors[term] for term in found.coefficients])

figure, axes = plt.subplots(figsize=(7.0, 3.8), layout="constrained")
axes.errorbar(values, range(len(names)), xerr=3.0 * errors, fmt="o", capsize=3, label="found")
axes.plot([truth.get(term, 0.0) for term in found.coefficients], range(len(names)), "k|", ms=14, label="true")
axes.set_yticks(range(len(names)), names)
axes.set_xlabel("coefficient (radians rms)")
axes.legend()
axes.grid(axis="x", alpha=0.3)
