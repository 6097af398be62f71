"""
An aperture mask for interferometry
===================================

Seven holes in front of a segmented telescope: fringes of 21 baselines, none of which is there twice.
"""

import matplotlib.pyplot as plt
import numpy as np

import lommel as lm

# %%
# A stop is a union, intersection or difference of shapes. Holes of the mask in NIRISS on the James Webb Space
# Telescope (Sivaramakrishnan et al. 2023, doi:10.1088/1538-3873/acaebd) are hexagons of 0.8 m, each before one of
# seven segments.

radius = 0.5 * lm.telescopes.DIAMETERS["jwst"]
centers = lm.telescopes.jwst().centers
seven = [7, 8, 9, 11, 12, 16, 17]  # segments B2, B3, B4, B6, C1, C5 and C6
holes = [lm.Polygon.regular(6, 0.8 / np.sqrt(3.0) / radius, tuple(centers[k])) for k in seven]
mask = lm.Segments(tuple(holes))
pupil = lm.Pupil(stop=mask)
star = lm.psf(pupil, shape=161, pixel=0.25, normalize="peak")
print(f"{star!r}")
print(f"light that passes: {100 * pupil.area / lm.Pupil(stop=lm.telescopes.jwst()).area:.1f} %")

# %%
# The modulus of the transfer function has a peak at each baseline: twice 21 besides the one in the middle.

pairs = np.array([centers[a] - centers[b] for i, a in enumerate(seven) for b in seven[i + 1 :]])
both = np.concatenate([pairs, -pairs])
apart = np.hypot(*(both[:, None] - both).T) + 9.0 * np.eye(len(both))
print(f"{len(pairs)} baselines, the nearest two {apart.min() * radius:.2f} m apart")
spectrum = np.abs(np.fft.fftshift(np.fft.fft2(np.fft.ifftshift(star.values), s=(161, 161))))
figure, axes = plt.subplots(1, 3, figsize=(11, 3.8), layout="constrained")
pupil.plot(axes[0], what="amplitude")
axes[0].set_title("seven holes", fontsize=10)
star.plot(axes[1], stretch="log")
axes[1].set_title(f"PSF, error bound {star.error_bound:.1g}", fontsize=10)
edge = 2.0  # cycles per lambda*N at the Nyquist frequency of these pixels, in units of the cutoff
shown = axes[2].imshow(
    np.log10(spectrum / spectrum.max()), vmin=-3, vmax=0, extent=(-edge, edge, edge, -edge), cmap="magma"
)
axes[2].set_xlim(-1, 1)
axes[2].set_ylim(1, -1)
axes[2].set_title("transfer function", fontsize=10)
axes[2].set_xlabel("frequency over the cutoff")
figure.colorbar(shown, ax=axes[2], label="log10 of the modulus", shrink=0.75)
plt.show()
