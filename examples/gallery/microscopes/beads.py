"""
Beads through focus
===================

Images of 100 nm beads at depths of 2 µm and 20 µm, through oil into water: the deeper bead is elongated, dimmer and
shifted in focus.
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
wavelength, pixel, size = 520e-9, 6e-6, 100e-9

# %%
# Sections about the brightest plane, square root of the values over their maximum: for the deeper bead marginal
# rays focus beyond paraxial rays.

window = (-0.8, 0.8, 0.8, -0.8)
z = np.array([-1.2, -0.6, 0.0, 0.6, 1.2]) * 1e-6
figure, panels = plt.subplots(2, z.size, figsize=(9.0, 4.0), sharex=True, sharey=True, layout="constrained")
for row, depth in zip(panels, (2e-6, 20e-6), strict=True):
    pupil = objective.pupil(depth=depth, z=z, wavelength=wavelength)
    stack = lm.microscopy.bead(pupil, size, shape=17, pixel=pixel, tol=1e-3)
    for axes, at, image in zip(row, z, stack.values, strict=True):
        axes.imshow(np.sqrt(image / stack.values.max()), cmap="inferno", vmin=0.0, vmax=1.0, extent=window)
        axes.set_title(f"z {1e6 * at:+.1f} µm".replace("-", "−"), fontsize=9)
    row[0].set_ylabel(f"{1e6 * depth:g} µm deep\ny (µm)")
    print(f"{1e6 * depth:g} µm: each value is off by at most {stack.error_bound:.1e} of the peak of its plane")
for axes in panels[1]:
    axes.set_xlabel("x (µm)")

# %%
# Focus of the beads: each is brightest beyond its paraxial focus, the deeper one by far. The axial width is that of
# the PSF, since 100 nm are small beside it.

figure, axes = plt.subplots(figsize=(7.0, 3.6), layout="constrained")
for depth, color in ((2e-6, "C0"), (20e-6, "C1")):
    focus = objective.focus(depth, wavelength=wavelength)
    z = np.linspace(-3e-6, 2.4e-6, 28)
    pupil = objective.pupil(depth=depth, z=z, wavelength=wavelength)
    stack = lm.microscopy.bead(pupil, size, shape=3, pixel=pixel, integrate=False, tol=1e-3)
    axis = stack.profile([0.0])[1][:, 0]
    beyond = float(focus.brightest - focus.paraxial)
    axes.plot(1e6 * (z + beyond), axis / axis.max(), color, label=f"{1e6 * depth:g} µm deep")
    print(f"{1e6 * depth:g} µm: brightest {1e9 * beyond:.0f} nm beyond the paraxial focus, ratio {focus.ratio:.3f}")
    print(f"width along z {1e9 * stack.axial_fwhm():.0f} nm, of a point {1e9 * focus.axial_fwhm:.0f} nm")
axes.axvline(0.0, color="0.6", label="paraxial focus, $d\\, n_i / n_s$")
axes.set_xlabel("movement of the stage beyond the paraxial focus (µm)")
axes.set_ylabel("light on the axis, over its largest")
axes.legend(fontsize=9)
axes.grid(alpha=0.3)
plt.show()
