"""
Molecules of a movie in three dimensions
========================================

Blinking molecules on a helix, imaged through an astigmatic objective: found in each frame and localised by maximum
likelihood with the PSF of their depth, and with that of beads on the glass.
"""

import matplotlib.pyplot as plt
import numpy as np

import lommel as lm

objective = lm.Objective(
    NA=1.4,
    magnification=63,
    immersion=1.518,
    working_distance=0.19e-3,
    coverslip=lm.Layer(1.5255, 170e-6),
    sample=1.33,
)
light = {"wavelength": 600e-9, "aberrations": lm.Wavefront.zernike({6: 0.15}, order="noll", unit="waves")}
pixel, side = 6.5e-6, 72
in_sample = pixel / objective.magnification
camera = lm.Noise(white=0.46, read=1.6, offset=100)

# %%
# Molecules blink at random along one turn of a helix of 2 µm radius, 1 µm deep: two on opposite sides in each frame,
# with about 3000 photons each.

random = np.random.default_rng(2)
count = 300
along = (random.uniform(0.0, 1.0, (count, 1)) + np.array([0.0, 0.5])) % 1.0
angle, z = 2.0 * np.pi * (along - 0.5), 0.9e-6 * (along - 0.5)
row = side / 2 + 2e-6 / in_sample * np.sin(angle)
column = side / 2 + 2e-6 / in_sample * np.cos(angle)
planes = objective.pupil(depth=1e-6, z=z.ravel(), **light)
images = lm.psf(planes, 21, pixel, center=(10 + (row % 1).ravel(), 10 + (column % 1).ravel())).values
frames = np.full((count, side, side), 8.0)
photons = random.gamma(9.0, 3000.0 / 9.0, row.size)
places = zip(np.repeat(np.arange(count), 2), row.ravel().astype(int), column.ravel().astype(int), strict=True)
for image, much, (frame, down, across) in zip(images, photons, places, strict=True):
    frames[frame, down - 10 : down + 11, across - 10 : across + 11] += much * image
movie = np.round(camera.record(frames, seed=3)).astype(np.uint16)

# %%
# A table of the images at the depth of the molecules, and one of beads on the glass, which is what a calibration with
# beads gives.

deep, glass = (
    lm.localize.Table(objective.pupil(depth=depth, **light), pixel=pixel, z=(-0.8e-6, 0.8e-6), reach=3.0)
    for depth in (1e-6, 0.0)
)
found, shifted = (lm.localize.localize_movie(movie, table, noise=camera) for table in (deep, glass))
print(found)

# %%
# The sum of the movie is a blurred ring; the molecules are the helix, of which z is the colour. Beads on the glass
# would compress and bend it.

figure, axes = plt.subplots(2, 2, figsize=(9.0, 8.0), layout="constrained")
extent = 1e6 * in_sample * np.array([0.0, side, side, 0.0])
axes[0, 0].imshow(movie[0], cmap="gray", extent=extent)
axes[0, 0].set_title("a frame")
axes[0, 1].imshow(movie.sum(axis=0, dtype=float), cmap="gray", extent=extent)
axes[0, 1].set_title("all frames")
found.plot(pixel=30e-9, ax=axes[1, 0])
for what, colour, label in ((found, "C0", "PSF at 1 µm"), (shifted, "C1", "beads on the glass")):
    rows = what.table[what.kept]
    turned = np.arctan2(1e6 * rows["y"] - extent[1] / 2, 1e6 * rows["x"] - extent[1] / 2)
    axes[1, 1].plot(np.degrees(turned), 1e9 * rows["z"], ".", ms=2, color=colour, label=label)
axes[1, 1].plot([-180, 180], [-450, 450], "k-", lw=0.8, label="true")
axes[1, 1].set(xlabel="angle (deg)", ylabel="z of the stage (nm)", title="along the helix")
axes[1, 1].legend(fontsize=8, loc="upper left")
for ax in axes[0]:
    ax.set(xlabel="x (µm)", ylabel="y (µm)")
plt.show()
