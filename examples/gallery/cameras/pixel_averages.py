"""
Pixel-integrated and point-sampled PSFs
=======================================

A sensor pixel integrates the light over its area. Sampling the intensity at its centre is equivalent only if the
pixel is small compared with the finest detail of the image, about λN.
"""

import matplotlib.pyplot as plt
import numpy as np

import lommel as lm

pupil = lm.Pupil(lm.Wavefront(defocus=12.0))

# %%
# A defocused lens with pixels of four sizes, point-sampled and pixel-integrated. ``integrate=True`` has the same
# tolerance as point samples; it is not a sum over a few points of unknown error.

sizes = (0.5, 1.5, 3.0, 5.0)
span = 45.0
figure, rows = plt.subplots(2, len(sizes), figsize=(10.5, 5.4), sharex=True, sharey=True, layout="constrained")
for column, pixel in zip(rows.T, sizes, strict=True):
    side = 2 * int(0.5 * span / pixel) + 1
    half = 0.5 * side * pixel
    for axes, integrate in zip(column, (False, True), strict=True):
        answer = lm.psf(pupil, side, pixel, integrate=integrate)
        density = answer.values / pixel**2
        axes.imshow(density, cmap="inferno", extent=(-half, half, half, -half), vmin=0, vmax=0.0042)
        axes.set_title(f"pixels of {pixel:g} λN\nsum of all {answer.values.sum():.3f}", fontsize=10)
        axes.set_xlim(-20, 20)
        axes.set_ylim(20, -20)
    column[1].set_xlabel("x (λN)")
rows[0, 0].set_ylabel("sampled\ny (λN)")
rows[1, 0].set_ylabel("averaged\ny (λN)")

# %%
# Difference of the two against pixel size. In focus, point samples are off by a tenth of the peak for pixels of
# half of λN.

pixels = np.geomspace(0.05, 4.0, 40)
figure, axes = plt.subplots(figsize=(7.5, 4.2), layout="constrained")
for defocus in (0.0, 3.0, 12.0):
    lens = lm.Pupil(lm.Wavefront(defocus))
    differences = []
    for pixel in pixels:
        side = 2 * int(min(0.5 * span / pixel, 60)) + 1
        sampled, averaged = (lm.psf(lens, side, pixel, integrate=way) for way in (False, True))
        differences.append(lm.peak_error(sampled, averaged))
    axes.loglog(pixels, differences, label=f"$C_d$ = {defocus:g} rad")
axes.set_xlabel("pixel pitch (λN)")
axes.set_ylabel("largest difference over the peak\nof the averages")
axes.grid(alpha=0.3)
axes.legend()
print(f"f/1.8 at 550 nm, pixels of 3.45 µm: {3.45 / (0.55 * 1.8):.1f} lambda*N")
plt.show()
