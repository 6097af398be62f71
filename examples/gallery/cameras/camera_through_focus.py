"""
A camera lens through focus
===========================

PSFs of a 50 mm lens at f/2.8, focused at 2 m, for object distances around the plane of focus. An array of object
distances makes a stack of pupils, computed in one call.
"""

import matplotlib.pyplot as plt
import numpy as np

import lommel as lm

lens = lm.Lens(focal_length=50e-3, f_number=2.8, focus_distance=2.0, wavelength=550e-9)

# %%
# Equal steps in 1/s, the reciprocal of the object distance, are equal steps of defocus (Eq. 3 of the paper).

vergence = np.linspace(1 / 2.22, 1 / 1.82, 7)
stack = lm.psf(lens.pupil(1 / vergence), shape=141, pixel=0.5e-6, normalize="peak")
half = 0.5e6 * stack.pixel * stack.shape[-1]

# %%
# A window one pixel high is a section through the PSF. Many of them, one for each distance, show the cone of light,
# the maxima and minima on its axis, and the symmetry about focus.

many = np.linspace(vergence[0], vergence[-1], 401)
slices = lm.psf(lens.pupil(1 / many), shape=(1, 301), pixel=0.25e-6, normalize="strehl")
defocus = slices.pupil.wavefront.defocus

figure = plt.figure(figsize=(10.5, 5.6), layout="constrained")
above, below = figure.subfigures(2, 1, height_ratios=(1, 1.7))
for axes, image, s in zip(above.subplots(1, len(vergence)), stack.values, 1 / vergence, strict=True):
    axes.imshow(np.sqrt(image), cmap="inferno", extent=(-half, half, half, -half))
    axes.set_title(f"{s:.2f} m", fontsize=10)
    axes.set_xticks([-25, 0, 25])
    axes.set_yticks([-25, 0, 25] if axes.get_subplotspec().is_first_col() else [])
    axes.tick_params(labelsize=8)
    axes.set_xlabel("x (µm)", fontsize=8)
above.suptitle("square root of the intensity over its peak, by object distance\n", fontsize=10)

axes = below.subplots()
level = np.log10(np.maximum(slices.values[:, 0, :].T, 1e-6))
mesh = axes.pcolormesh(defocus, slices.grid.x * 1e6, level, cmap="inferno", vmin=-5, vmax=0, rasterized=True)
blur = slices.pupil.geometric_radius() * 1e6
for side in (1, -1):
    axes.plot(defocus, side * blur, color="white", linewidth=0.8, linestyle="--")
axes.set_xlabel("defocus constant $C_d$ (rad)")
axes.set_ylabel("x (µm)")
axes.set_ylim(-35, 35)
below.colorbar(mesh, ax=axes, label="log10 of the intensity\n(1 = in focus, on the axis)")

print(f"error bound {stack.error_bound:.1e} of each peak, {slices.error_bound:.1e} of the slices'")
plt.show()

# %%
# Positive :math:`C_d` is an object nearer than the plane of focus. The intensity on the axis is :math:`(\sin C_d /
# C_d)^2`, which vanishes at non-zero multiples of :math:`\pi`, that is whole waves of W020. The dashed lines mark
# the circle of confusion; the rings inside it are diffraction.
