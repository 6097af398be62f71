"""
Focal shift and elongation with depth
=====================================

With an oil objective and a sample of water, the PSF becomes longer and dimmer with depth, and the stage moves
farther than the depth of the emitter, by a factor that depends on depth.
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
wavelength = 520e-9

# %%
# Axial sections of PSFs at four depths, each about its brightest plane: square root of the intensity over its
# maximum. z is the movement of the stage. Spherical aberration makes the two sides of focus different.

depths = np.array([0.0, 2e-6, 10e-6, 40e-6])
focus = objective.focus(depths, wavelength=wavelength)
z = np.linspace(-3e-6, 3e-6, 161)
r = np.linspace(0.0, 1.2e-6, 97)
figure, panels = plt.subplots(1, depths.size, figsize=(10.5, 4.6), sharey=True, layout="constrained")
for axes, depth, best, peak in zip(panels, depths, focus.brightest, focus.peak, strict=True):
    light = objective.fields(r, depth=depth, focus=best + z, wavelength=wavelength)
    both = np.hstack([light.intensity[:, :0:-1], light.intensity])
    axes.imshow(np.sqrt(both / both.max()), cmap="inferno", extent=(-1.2, 1.2, 3, -3))
    axes.set_title(f"{1e6 * depth:g} µm deep\npeak {peak:.2f}", fontsize=10)
    axes.set_xlabel("x (µm)")
    print(f"{1e6 * depth:g} µm: each value is off by at most {light.intensity_error.max():.0e}")
panels[0].set_ylabel("z of the stage, from the brightest plane (µm)")

# %%
# Ratio of depth to stage movement: nowhere the ratio of the refractive indices, and the axial width grows with
# depth. An emitter closer to the glass than a wavelength sends supercritical light.

depths = np.geomspace(0.2e-6, 100e-6, 97)
focus = objective.focus(depths, wavelength=wavelength)
figure, (left, middle, right) = plt.subplots(1, 3, figsize=(10.5, 3.6), layout="constrained")
left.semilogx(1e6 * depths, focus.ratio, label="where it is brightest")
left.axhline(objective.sample / objective.immersion, color="0.6", label="paraxial, $n_s / n_i$")
left.set_ylabel("depth over movement of the stage")
left.legend(fontsize=9)
middle.loglog(1e6 * depths, 1e9 * focus.axial_fwhm, label="along z")
middle.loglog(1e6 * depths, 1e9 * focus.lateral_fwhm, label="across")
middle.set_ylabel("full width at half maximum (nm)")
middle.set_yticks([200, 500, 1000, 2000], ["200", "500", "1000", "2000"])
middle.minorticks_off()
middle.legend(fontsize=9)
right.semilogx(1e6 * depths, objective.collected(depths, wavelength=wavelength))
right.set_ylabel("light collected, over that far away")
figure.get_layout_engine().set(w_pad=0.12)
for axes in (left, middle, right):
    axes.set_xlabel("depth (µm)")
    axes.grid(alpha=0.3)
plt.show()
