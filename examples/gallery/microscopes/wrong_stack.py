"""
A wrong refractive index, a reversed z
======================================

A stack of beads 12 µm deep in water below an oil objective is restored with the right PSFs, with those of another
refractive index of the sample, and as if its planes ran the other way: what such mistakes look like, and how to
notice them without a ground truth.
"""

from dataclasses import replace

import matplotlib.pyplot as plt
import numpy as np

import lommel as lm

objective = lm.Objective(
    NA=1.3,
    magnification=60,
    immersion=1.515,
    working_distance=0.2e-3,
    coverslip=lm.Layer(1.5255, 170e-6),
    sample=1.33,
)
wavelength, pixel, step = 520e-9, 6e-6, 300e-9  # pixels of 100 nm in the specimen
planes, side, depth = 28, 48, 12e-6
z = step * np.arange(-planes, planes + 1)


def psf_at(depth, objective=objective):
    """Return the PSF of a bead at a depth, brightest where z is 0."""
    pupil = objective.pupil(depth=depth, z=z, wavelength=wavelength)
    return lm.psf(pupil, shape=2 * side + 1, pixel=pixel, tol=1e-4).values


# %%
# Every bead has the PSF of its own depth. The depth in focus in each plane follows from the brightest focus of the
# objective. The camera has an offset of 100 counts, 0.46 electrons per count and a read noise of 1.6 electrons.

table = np.linspace(1e-6, 30e-6, 100)
focus = objective.focus(table, wavelength=wavelength).brightest
middle = np.interp(depth, table, focus)
light = np.full((planes, side, side), 10.0)
beads = [(5, 12, 24, 4000.0), (9, 30, 12, 8000.0), (14, 24, 30, 15000.0), (20, 36, 24, 10000.0), (23, 18, 14, 8000.0)]
for plane, row, column, photons in beads:
    at = np.interp(middle + (plane - planes // 2) * step, focus, table)
    seen = np.s_[planes - plane : 2 * planes - plane, side - row : 2 * side - row, side - column : 2 * side - column]
    light += photons * psf_at(at)[seen]
camera = lm.Noise(white=0.46, read=1.6, offset=100.0)
stack = np.rint(camera.record(light, seed=1)).astype(np.uint16)

# %%
# Forty steps each. The reversed z is forced by `direction`, which by default is found from the stack.

given = {"depth": depth, "wavelength": wavelength, "pixel": pixel, "step": step, "noise": camera}
given["method"] = lm.imaging.RichardsonLucy(steps=40, target=0.0)
tries = {
    "right": (objective, "up"),
    "sample of 1.40, not 1.33": (replace(objective, sample=1.40), "up"),
    "z reversed": (objective, "down"),
}
restored = {
    name: lm.microscopy.deconvolve(stack, lens, direction=way, **given) for name, (lens, way) in tries.items()
}
for name, found in restored.items():
    print(f"{name}: discrepancy {found.channels[0].discrepancy:.2f}")

# %%
# Maximum projections along y, square root of the values; circles show where the beads are. A wrong index displaces
# the beads along z and leaves tails on one side. With z reversed the beads are long, and their cones of light
# remain. The discrepancy, about 1 where PSF and noise are right, needs no ground truth.

figure, panels = plt.subplots(1, 4, figsize=(11.0, 4.2), layout="constrained", sharey=True)
extent = (0.0, side * 0.1, planes * 0.3, 0.0)
shown = {"recording": stack - 100.0} | {name: np.asarray(found) for name, found in restored.items()}
for axes, (name, values) in zip(panels, shown.items(), strict=True):
    axes.imshow(np.sqrt(np.maximum(values, 0.0).max(axis=1)), cmap="inferno", extent=extent, aspect="auto")
    axes.scatter(
        [(column + 0.5) * 0.1 for _, _, column, _ in beads],
        [(plane + 0.5) * 0.3 for plane, *_ in beads],
        s=90, facecolors="none", edgecolors="c", linewidths=0.8,
    )  # fmt: skip
    after = "" if name == "recording" else f"\ndiscrepancy {restored[name].channels[0].discrepancy:.2f}"
    axes.set_title(name + after, fontsize=10)
    axes.set_xlabel("x (µm)")
panels[0].set_ylabel("z of the stage (µm)")

# %%
# The picture that `lommel deconvolve --plot` writes, of the wrong index: rings and tails in the residual, which is
# noise without a pattern where PSF and noise are right.

restored["sample of 1.40, not 1.33"].plot()

# %%
# The PSF beside a bead, which can be compared before anything is restored: the tail and the cone must be on the same
# side, and as long.

_, row, _, _ = beads[2]
plane, column = 14, 30
part = np.s_[plane - 10 : plane + 11, row, column - 14 : column + 15]
own = np.s_[planes - 10 : planes + 11, side, side - 14 : side + 15]
pictures = {
    "a bead of the stack": stack[part] - 100.0,
    "PSF": psf_at(depth)[own],
    "PSF, sample of 1.40": psf_at(depth, replace(objective, sample=1.40))[own],
    "PSF, z reversed": psf_at(depth)[own][::-1],
}
figure, panels = plt.subplots(1, 4, figsize=(11.0, 3.6), layout="constrained", sharey=True)
for axes, (name, values) in zip(panels, pictures.items(), strict=True):
    axes.imshow(np.sqrt(np.maximum(values, 0.0)), cmap="inferno", extent=(-1.45, 1.45, 3.15, -3.15), aspect="auto")
    axes.set_title(name, fontsize=10)
    axes.set_xlabel("x (µm)")
panels[0].set_ylabel("z of the stage (µm)")
plt.show()
