"""
Confocal, two-photon and light-sheet PSFs
=========================================

Axial sections of widefield, confocal, two-photon and light-sheet PSFs, and their optical sectioning.
"""

import matplotlib.pyplot as plt
import numpy as np

import lommel as lm

objective = lm.Objective(
    NA=1.2,
    magnification=60,
    immersion=1.333,
    working_distance=0.28e-3,
    coverslip=lm.Layer(1.5255, 170e-6),
    sample=1.36,
)
depth, pixel = 20e-6, 3e-6
z = np.linspace(-2e-6, 2e-6, 21)
emission = objective.pupil(depth=depth, z=z, wavelength=525e-9)
laser = lm.Beam("circular")
# Excitation and emission have different foci: the excitation is computed in the planes of the emission.
excitation = objective.pupil(depth=depth, z=emission.focus, origin="coverslip", wavelength=488e-9, emitter=laser)
infrared = objective.pupil(depth=depth, z=z, wavelength=800e-9, emitter=laser)

# %%
# Axial sections, square root of the values, with lateral and axial FWHM.

stacks = {
    "wide field": lm.psf(emission, 33, pixel, tol=1e-4),
    "confocal, 1 Airy unit": lm.microscopy.confocal(excitation, emission, 33, pixel, tol=1e-4),
    "two photons": lm.microscopy.two_photon(infrared, 33, pixel, tol=1e-4),
    "light sheet of 1 µm": lm.microscopy.light_sheet(emission, 1e-6, 33, pixel, tol=1e-4),
}
figure, panels = plt.subplots(1, len(stacks), figsize=(10.0, 4.4), sharey=True, layout="constrained")
half = 1e6 * 16.5 * pixel / 60
for axes, (name, stack) in zip(panels, stacks.items(), strict=True):
    slice_ = stack.values[:, 16]
    axes.imshow(
        np.sqrt(slice_ / slice_.max()), cmap="inferno", interpolation="bicubic", extent=(-half, half, 2.0, -2.0)
    )
    across, along = 1e9 * stack[10].fwhm() / 60, 1e9 * stack.axial_fwhm()
    axes.set_title(f"{name}\n{across:.0f} × {along:.0f} nm", fontsize=10)
    axes.set_xlabel("x (µm)")
    print(f"{name}: {across:.1f} nm across, {along:.0f} nm along z")
panels[0].set_ylabel("z of the stage (µm)")

# %%
# Signal of a thin uniform layer against z: constant in widefield, and falling with smaller pinholes.

radius = 3e-4  # on the camera, where nearly all of the light is
figure, axes = plt.subplots(figsize=(6.4, 3.6), layout="constrained")
layers = {"wide field": stacks["wide field"], "two photons": stacks["two photons"]}
for pinhole in (0.5, 1.0, 2.0):
    way = lm.microscopy.confocal(excitation, emission, 3, pixel, pinhole=pinhole, tol=1e-4)
    layers[f"confocal, {pinhole:g} Airy units"] = way
for name, stack in layers.items():
    light = stack.encircled_energy(radius)
    axes.plot(1e6 * z, light / light.max(), label=name)
axes.set_xlabel("z of the stage (µm)")
axes.set_ylabel("light of a layer, over the most")
axes.legend(fontsize=9)
axes.grid(alpha=0.3)
plt.show()
