"""
A microscope fitted to a bead
=============================

The aberrations of an objective from a stack of a 100 nm bead on the cover glass. The sample is of another index than
stated: the score test says so, and the PSF 3 µm deep is predicted with its standard error.
"""

import matplotlib.pyplot as plt
import numpy as np

import lommel as lm


def objective(sample):
    """Return the objective before a sample of an index."""
    return lm.Objective(
        NA=1.4,
        magnification=63,
        immersion=1.518,
        working_distance=0.19e-3,
        coverslip=lm.Layer(1.5255, 170e-6),
        sample=sample,
    )


z, pixel, camera = (np.arange(13) - 6) * 150e-9, 6.5e-6, lm.Noise(read=1.6, offset=100)
wave = lm.Wavefront.zernike({5: 0.05, 6: -0.06, 7: 0.04, 8: -0.03, 11: 0.05}, unit="waves", order="noll")
true = {"wavelength": 600e-9, "aberrations": wave}
light = lm.microscopy.bead(objective(1.36).pupil(depth=50e-9, z=z, **true), 100e-9, 19, pixel, tol=1e-4).values
stack = camera.record(2e4 * light + 10.0, seed=3)

# %%
# All constants held at what is stated, water: chi2 is near 1, and yet the index is wrong.

stated = lm.Microscope(objective(1.33), wavelength=600e-9, pixel=pixel)
asked = {"z": z, "noise": camera, "diameter": 100e-9, "terms": 7}
held = lm.fit_beads(stack, stated, **asked, priors={})
print(held.message)

# %%
# With the index unknown, and depth known to 10 nm:

found = lm.fit_beads(stack, stated, **asked, priors={"sample": (1.33, 0.05), "depth": 10e-9})
print(found)
found.plot()

# %%
# The PSF 3 µm deep along x: truth, both fits, and one standard error of the second.

deep = {"depth": 3e-6, "z": [-0.3e-6]}
profiles = {
    "truth": lm.psf(objective(1.36).pupil(**deep, **true), 25, pixel).values[0, 12],
    "index held at 1.33": lm.psf(held.pupil(**deep), 25, pixel).values[0, 12],
    "index estimated": lm.psf(found.pupil(**deep), 25, pixel).values[0, 12],
}
sigma = found.psf_errors(**deep, shape=25)[0, 12]
figure, axes = plt.subplots(figsize=(7.0, 3.6), layout="constrained")
x = (np.arange(25) - 12) * pixel / 63 * 1e6
for (name, values), style in zip(profiles.items(), ("k-", "C3--", "C0-"), strict=True):
    axes.plot(x, 100.0 * values, style, label=name)
low, high = (100.0 * (profiles["index estimated"] + side * sigma) for side in (-1.0, 1.0))
axes.fill_between(x, low, high, color="C0", alpha=0.3, label="one standard error")
axes.set(xlabel="x (µm)", ylabel="light of a pixel (%)")
axes.legend()
plt.show()
