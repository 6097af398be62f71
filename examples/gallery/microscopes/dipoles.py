"""
Fixed dipoles
=============

The image of a fixed molecule, a dipole, depends on its orientation; assuming a freely rotating dipole biases its
position.
"""

import matplotlib.pyplot as plt
import numpy as np

import lommel as lm

objective = lm.Objective(
    NA=1.49,
    magnification=100,
    immersion=1.518,
    working_distance=0.12e-3,
    coverslip=lm.Layer(1.518, 170e-6),
    sample=1.33,
)
z = np.array([-0.4, 0.0, 0.4]) * 1e-6
window, pixel, wavelength = 17, 8e-6, 670e-9


def image(emitter):
    """Return the images of a molecule 0.2 µm above the glass, in three planes."""
    pupil = objective.pupil(depth=0.2e-6, z=z, wavelength=wavelength, emitter=emitter)
    return lm.psf(pupil, window, pixel, tol=1e-3, integrate=False)


# %%
# Dipoles at several tilts towards the right, with their images in three planes, each over its own maximum; last, a
# freely rotating dipole.

tilts = np.radians([0.0, 30.0, 60.0, 90.0])
emitters = [lm.Dipole(tilt, 0.0) for tilt in tilts] + [lm.Dipole(0.0, 0.0, wobble=1.0)]
stacks = [image(emitter) for emitter in emitters]
names = [f"{tilt:.0f}°" for tilt in np.degrees(tilts)] + ["turning"]
half = 1e6 * window * pixel / 200
figure, panels = plt.subplots(z.size, len(stacks), figsize=(9.0, 5.6), sharex=True, sharey=True, layout="constrained")
for column, stack, name in zip(panels.T, stacks, names, strict=True):
    for axes, values in zip(column, stack.values, strict=True):
        axes.imshow(values, cmap="inferno", extent=(-half, half, half, -half))
    column[0].set_title(name, fontsize=10)
    column[-1].set_xlabel("x (µm)")
for axes, at in zip(panels[:, 0], z, strict=True):
    axes.set_ylabel(f"z {1e6 * at:+.1f} µm\ny (µm)".replace("-", "−"))

# %%
# Centroid of the image, in the sample: out of focus the image of a tilted dipole shifts by up to a hundred
# nanometres, in opposite directions in front of and behind the focus.

fine = np.radians(np.arange(0.0, 91.0, 15.0))
shift = np.array([[part[0] for part in image(lm.Dipole(tilt, 0.0)).centroid] for tilt in fine]) / 100
figure, axes = plt.subplots(figsize=(6.4, 3.6), layout="constrained")
for at, moved in zip(z, shift.T, strict=True):
    axes.plot(np.degrees(fine), 1e9 * moved, "o-", label=f"z {1e6 * at:+.1f} µm".replace("-", "−"))
axes.set_xlabel("tilt from the axis (degrees)")
axes.set_ylabel("centroid in the window, in the sample (nm)")
axes.legend(fontsize=9)
axes.grid(alpha=0.3)
print(f"largest shift: {1e9 * np.abs(shift).max():.0f} nm")
plt.show()
