"""
Keck, VLT, Subaru and Hubble
============================

Apertures of four telescopes from published dimensions, and their PSFs: hexagons, vanes that miss the axis, pads.
"""

import matplotlib.pyplot as plt
import numpy as np

import lommel as lm

# %%
# Each function of ``lm.telescopes`` returns a stop; ``lm.telescopes.DIAMETERS`` is the diameter it is over, metres.

names = {"keck": "Keck", "vlt": "VLT", "subaru": "Subaru", "hst": "Hubble"}
figure, rows = plt.subplots(2, 4, figsize=(11, 5.8), layout="constrained")
for column, (key, name) in zip(rows.T, names.items(), strict=True):
    pupil = lm.Pupil(stop=getattr(lm.telescopes, key)())
    star = lm.psf(pupil, shape=241, pixel=0.5, normalize="peak")
    pupil.plot(column[0], what="amplitude")
    area = pupil.area * np.pi * (0.5 * lm.telescopes.DIAMETERS[key]) ** 2
    column[0].set_title(f"{name}: {area:.3g} m²", fontsize=10)
    star.plot(column[1], stretch="log")
    column[1].set_title(f"error bound {star.error_bound:.1g}", fontsize=10)
    print(f"{name}: clear area {area:.4g} square metres, bound on the error {star.error_bound:.1g} of the peak")
for axes in rows[:, 1:].ravel():
    axes.set_ylabel("")
plt.show()

# %%
# The hexagonal edges of Keck make six spikes. Each vane makes a pair at right angles to itself; the four vanes of the
# others are parallel two by two, and so make two lines that cross. Along x, on which only Hubble has one:

figure, ax = plt.subplots(figsize=(7.5, 4.2), layout="constrained")
for key, name in names.items():
    line = lm.psf(lm.Pupil(stop=getattr(lm.telescopes, key)()), (1, 961), 0.125, normalize="strehl")
    distance, values = line.profile()
    blocks = values[: values.size // 24 * 24].reshape(-1, 24).mean(axis=1)
    ax.semilogy(distance[12 : 12 + 24 * blocks.size : 24], blocks, label=name)
ax.set_xlabel("distance from the axis along x (λN)")
ax.set_ylabel("intensity over the peak, averaged over 3 λN")
ax.grid(alpha=0.3)
ax.legend()
plt.show()
