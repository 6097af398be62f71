# %% [markdown]
# # Defocus of a camera, and depth from it
#
# A tilted surface photographed at two focus distances. From the two photographs follow its depth, the standard
# error of the depth, and the sharp image.

# %%
import matplotlib.pyplot as plt
import numpy as np

import lommel as lm

pixel = 3.45e-6
lens = lm.Lens(focal_length=50e-3, f_number=1.8, focus_distance=1.6, wavelength=550e-9)
noise = lm.Noise(white=5000, read=3.0)  # electrons of a white pixel, read noise in electrons rms

# %% [markdown]
# PSFs through focus, each pixel-integrated:

# %%
places = np.array([1.55, 1.58, 1.6, 1.62, 1.65])
stack = lm.psf(lens.pupil(places), shape=33, pixel=pixel)
figure, panels = plt.subplots(1, 5, figsize=(9.0, 2.4), layout="constrained")
panels[0].set_ylabel("y (pixels)")
for panel, values, distance in zip(panels, stack.values, places, strict=True):
    panel.imshow(values, cmap="inferno")
    panel.set_title(f"{distance} m")
    panel.set_xlabel("x (pixels)")

# %% [markdown]
# ## Two photographs
#
# The surface has a random texture and rises from 1.57 m on the left to 1.63 m on the right. `depth_of_field` blurs it
# as the lens does.

# %%
rows, columns = 56, 96
rng = np.random.default_rng(0)
texture = 0.2 + 0.6 * rng.random((rows, columns))  # 1 is white
depth = np.broadcast_to(np.linspace(1.57, 1.63, columns), (rows, columns))
lenses = [lens.focused(distance) for distance in (1.55, 1.65)]
photos = []
for one in lenses:
    light = lm.imaging.depth_of_field(texture, depth, one, pixel, encoding="linear").values
    photos.append(noise.record(noise.white * light, seed=len(photos)))

figure, panels = plt.subplots(1, 2, figsize=(9.0, 3.0), layout="constrained")
panels[0].set_ylabel("y (pixels)")
for panel, photo, one in zip(panels, photos, lenses, strict=True):
    panel.imshow(photo, "gray")
    panel.set_title(f"focused at {one.focus_distance:.2f} m")
    panel.set_xlabel("x (pixels)")

# %% [markdown]
# ## Depth from defocus
#
# The standard error is that of the noise, from the Fisher information of both photographs.

# %%
found = lm.imaging.depth_from_defocus(photos, lenses, pixel, encoding="linear", noise=noise, between=(1.5, 1.7))
error = np.abs(found.depth - depth)[8:-8, 8:-8]
print(f"median error {1e3 * np.nanmedian(error):.1f} mm")

figure, (left, right) = plt.subplots(1, 2, figsize=(9.0, 3.0), layout="constrained")
shown = left.imshow(found.depth, vmin=1.56, vmax=1.64)
left.set_xlabel("x (pixels)")
left.set_ylabel("y (pixels)")
figure.colorbar(shown, label="depth (m)")
known = np.isfinite(found.depth[8:-8]).any(axis=0)  # beside the border nothing is
right.plot(np.flatnonzero(known), np.nanmedian(found.depth[8:-8, known], axis=0), label="found, median of the rows")
right.plot(depth[0], "k--", label="true")
right.set_xlabel("x (pixels)")
right.set_ylabel("depth (m)")
right.legend()
right.grid(alpha=0.3)
