"""
A microscope that looks deep
============================

An oil objective and a sample of water: the deeper an emitter, the longer and dimmer its image along z. The stage
moves farther than the emitter is deep, by a factor that depends on the depth.
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
# Slices through the light of emitters at four depths, each about the plane in which it is brightest: roots of the
# intensity over its largest value. z is the movement of the stage. One side of the focus is not like the other, since
# rays of the rim meet farther than those near the axis.

depths = np.array([0.0, 2e-6, 10e-6, 40e-6])
focus = objective.focus(depths, wavelength=wavelength)
z = np.linspace(-3e-6, 3e-6, 161)
r = np.linspace(0.0, 1.2e-6, 97)
figure, panels = plt.subplots(1, depths.size, figsize=(10.5, 4.6), sharey=True, layout="constrained")
for axes, depth, best, peak in zip(panels, depths, focus.brightest, focus.peak, strict=True):
    light = objective.fields(r, depth=depth, focus=best + z, wavelength=wavelength)
    both = np.hstack([light.intensity[:, :0:-1], light.intensity])
    axes.imshow(np.sqrt(both / both.max()), cmap="magma", extent=(-1.2, 1.2, 3, -3))
    axes.set_title(f"{1e6 * depth:g} µm deep\npeak {peak:.2f}", fontsize=10)
    axes.set_xlabel("x (µm)")
    print(f"{1e6 * depth:g} um: each value is off by at most {light.intensity_error.max():.0e}")
panels[0].set_ylabel("z of the stage, from the brightest plane (µm)")

# %%
# How deep is what the stage tells? The ratio of depth to movement is that of the indices nowhere, and the width along
# z grows with the depth. An emitter nearer to the glass than a wavelength sends in light beyond the critical angle.

depths = np.geomspace(0.2e-6, 100e-6, 25)
focus = objective.focus(depths, wavelength=wavelength)
figure, (left, middle, right) = plt.subplots(1, 3, figsize=(10.5, 3.6), layout="constrained")
left.semilogx(1e6 * depths, focus.ratio, label="where it is brightest")
left.axhline(objective.sample / objective.immersion, color="0.6", label="paraxial, $n_s / n_i$")
left.set_ylabel("depth over movement of the stage (1)")
left.legend(fontsize=9)
middle.loglog(1e6 * depths, 1e9 * focus.axial_fwhm, label="along z")
middle.loglog(1e6 * depths, 1e9 * focus.lateral_fwhm, label="across")
middle.set_ylabel("full width at half maximum (nm)")
middle.legend(fontsize=9)
right.semilogx(1e6 * depths, objective.collected(depths, wavelength=wavelength))
right.set_ylabel("light collected, over that far away (1)")
for axes in (left, middle, right):
    axes.set_xlabel("depth (µm)")
    axes.grid(alpha=0.3)
plt.show()
