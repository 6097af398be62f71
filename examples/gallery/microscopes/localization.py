"""
Localization of molecules in three dimensions
=============================================

Maximum-likelihood localization with derivatives of the exact PSF reaches the Cramér-Rao bound in x, y and z.
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
wavelength, pixel, side = 670e-9, 10e-6, 17
photons, background = 3000.0, 10.0
names = ("z", "row", "column")

# %%
# Molecules at ten stage positions, forty each, anywhere within the central pixel, as a camera counts them.
# Molecules on the glass are in focus at stage position 0, where an image carries no information about z to first
# order.

random = np.random.default_rng(1)
heights = np.linspace(0.25e-6, 0.75e-6, 10)
z = np.repeat(heights, 40)
place = side // 2 + random.uniform(-0.5, 0.5, (2, z.size))


def model(z, place):
    """Return the images of molecules on the glass, and their derivatives."""
    pupil = objective.pupil(depth=0.0, z=z, wavelength=wavelength)
    return lm.psf(pupil, side, pixel, center=tuple(place), derivatives=names, tol=1e-4, dtype=np.float64)


counts = random.poisson(photons * model(z, place).values + background)

# %%
# Fisher scoring for all molecules at once, with five unknowns each, including flux and background.

found = np.array([z + random.normal(0.0, 5e-8, z.size), *np.full((2, z.size), side // 2)])
light, dark = np.full(z.size, 2500.0), np.full(z.size, 8.0)
for _ in range(12):
    psf = model(found[0], found[1:])
    expected = light[:, None, None] * psf.values + dark[:, None, None]
    slopes = [light[:, None, None] * psf.derivatives[name] for name in names]
    slopes = np.stack([*slopes, psf.values, np.ones_like(psf.values)], axis=1)
    scale = np.array([1e-7, 1.0, 1.0, 1e3, 10.0])  # of the unknowns, so that all are about one
    slopes = (slopes * scale[:, None, None]).reshape(z.size, 5, -1)
    weighted = slopes / expected.reshape(z.size, 1, -1)
    information = weighted @ slopes.transpose(0, 2, 1)
    residual = (counts - expected).reshape(z.size, -1, 1)
    step = np.linalg.solve(information, weighted @ residual)[..., 0] * scale
    found += np.clip(step[:, :3].T, -np.array([[1e-7], [0.5], [0.5]]), np.array([[1e-7], [0.5], [0.5]]))
    light, dark = light + step[:, 3], np.maximum(dark + step[:, 4], 0.5)

# %%
# Standard deviation of the estimates at each height, and the Cramér-Rao bound of :func:`lommel.fisher`. z is that
# of the stage, the others are lengths in the sample.

unit = 1e9 * np.array([1.0, pixel / 100, pixel / 100])
error = unit[:, None] * (found - np.array([z, *place]))
rms = np.sqrt((error.reshape(3, heights.size, -1) ** 2).mean(axis=-1))
pupils = objective.pupil(depth=0.0, z=heights, wavelength=wavelength)
best = lm.fisher(pupils, side, pixel, of=(*names, "photons", "background"), photons=photons, background=background)
bound = unit[:, None] * np.array([best.errors[name] for name in names])
figure, axes = plt.subplots(figsize=(6.4, 4.0), layout="constrained")
for label, colour, had, least in zip(names, ("C0", "C1", "C2"), rms, bound, strict=True):
    axes.plot(1e9 * heights, had, "o", color=colour, label=f"{label}: found")
    axes.plot(1e9 * heights, least, "-", color=colour, label=f"{label}: bound")
axes.set_ylim(0.0, None)
axes.set_xlabel("z of the stage (nm)")
axes.set_ylabel("standard error, in the sample (nm)")
axes.legend(fontsize=8, ncols=3)
axes.grid(alpha=0.3)
print(f"deviation over the bound, all heights: {', '.join(f'{r:.2f}' for r in (rms / bound).mean(axis=1))}")
plt.show()
