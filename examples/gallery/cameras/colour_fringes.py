"""
Colour fringes of a fast lens
=============================

Axial colour: a lens focuses wavelengths at different distances. Achromats bring two of them together; the remaining
secondary spectrum shows at large apertures as purple fringes in front of the focus and green ones behind it.
"""

import matplotlib.pyplot as plt
import numpy as np

import lommel as lm

# %%
# An 85 mm achromat at f/1.4: blue and red focus together, about f/2000 behind green. ``focus_shift`` is the
# increase of the focal length at each wavelength.

wavelengths = np.array([420, 460, 500, 550, 600, 650, 690]) * 1e-9
colour = lm.Colour(wavelengths, focus_shift=np.array([95, 36, 9, 0, 8, 25, 42]) * 1e-6)
lens = lm.Lens(focal_length=85e-3, f_number=1.4, focus_distance=2.0, wavelength=550e-9, colour=colour)
channels = lm.Channels.rgb(width=70e-9)

# %%
# One call for all distances and channels. Each wavelength is computed once, with its own defocus.

distances = np.array([1.955, 1.975, 1.99, 2.0, 2.01, 2.025, 2.045])
stack = lm.colour_psf(lens.pupil(distances), 51, 3.76e-6, channels)

# %%
# Where each wavelength is in focus follows from the table alone, and how wide points are from the PSFs:
# the diameter of half of their light, by channel.

many = np.linspace(1.95, 2.05, 41)
answers = lm.colour_psf(lens.pupil(many), 9, 3.76e-6, channels)

figure = plt.figure(figsize=(10.5, 5.4), layout="constrained")
above, below = figure.subfigures(2, 1, height_ratios=(1, 1.4))
half = 0.5e3 * stack.pixel * stack.shape[-1]
for k, axes in enumerate(above.subplots(1, len(distances))):
    light = np.moveaxis(stack.values[k], 0, -1)
    axes.imshow(np.sqrt(light / light.max()), extent=(-half, half, half, -half))
    axes.set_title(f"{distances[k]:.3f} m", fontsize=10)
    axes.set_xticks([])
    axes.set_yticks([])
above.suptitle("square root of the light over its largest value, by object distance: 0.19 mm a side", fontsize=10)

focus, width = below.subplots(1, 2)
between = np.linspace(wavelengths[0], wavelengths[-1], 200)
focus.plot(between * 1e9, [lens.in_light(w).focus_distance for w in between], color="black")
for name, pairs in channels:
    waves = [w for w, _ in pairs]
    focus.axvspan(min(waves) * 1e9, max(waves) * 1e9, color=name, alpha=0.15)
focus.set_xlabel("wavelength (nm)")
focus.set_ylabel("object distance in focus (m)")

for name, answer in zip(answers.names, answers, strict=True):
    width.plot(many, answer.energy_diameter(0.5) * 1e6, color=name, label=name)
width.set_xlabel("object distance (m)")
width.set_ylabel("diameter of half of the light (µm)")
width.legend()

print(f"error bound {stack.error_bound:.1e} of the peak of each channel")
plt.show()

# %%
# In front of focus (left) blue and red are blurred most, and the edge is blue to purple; behind it (right) green is
# blurred most. The colour of the fringe thus tells a camera, from a single photograph, on which side of focus an
# object lies.
