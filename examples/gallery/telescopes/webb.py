"""
The James Webb Space Telescope with piston errors
=================================================

PSFs of 18 segments in phase, with piston errors, and tilted apart, each with a proven error bound.
"""

import matplotlib.pyplot as plt
import numpy as np

import lommel as lm

# %%
# ``lm.telescopes.jwst()`` is the aperture from the published corners of the segments, behind the three struts of
# the secondary mirror. Each segment takes a piston, a tip and a tilt. Here at 2 micrometres, with pixels of NIRCam,
# 31 mas or 18 micrometres.

webb = lm.telescopes.jwst()
common = {"focal_length": 119.8, "aperture_diameter": lm.telescopes.DIAMETERS["jwst"], "wavelength": 2e-6}
errors = np.random.default_rng(3).normal(scale=0.06, size=18)  # waves
apart = 24.0 * webb.centers.T  # waves of tip and tilt at the edge of the aperture, away from the axis
states = {
    "in phase": webb,
    f"pistons of {errors.std():.2g} waves rms": webb.phased(errors, unit="waves"),
    "segments tilted apart": webb.phased(0.0, *apart, unit="waves"),
}
pupils = {name: lm.Lens(**common, stop=stop).pupil() for name, stop in states.items()}

figure, rows = plt.subplots(2, 3, figsize=(10.5, 6.6), layout="constrained")
for column, (name, pupil) in zip(rows.T, pupils.items(), strict=True):
    pixel = 18e-6 if "tilted" in name else 4.5e-6
    star = lm.psf(pupil, shape=201, pixel=pixel, integrate=False, normalize="peak")
    pupil.plot(column[0])
    column[0].set_title(f"{name}\nStrehl ratio {float(lm.strehl(pupil)):.3g}", fontsize=10)
    star.plot(column[1], stretch="log")
    column[1].set_title(f"error bound {star.error_bound:.1g} of the peak", fontsize=10)
    print(f"{name}: Strehl ratio {float(lm.strehl(pupil)):.4f}, bound on the error {star.error_bound:.1g}")
plt.show()

# %%
# Tips and tilts are the change of the phase over a radius of the aperture: T waves move the image of a segment by
# 2 T lambda*N, which gives 18 images, as in the first weeks after launch. With small piston errors the Strehl ratio
# follows Maréchal's estimate.

rms = np.linspace(0.0, 0.14, 15)
unit = errors / errors.std()
bare = pupils["in phase"]
ratios = [lm.strehl(lm.Pupil(stop=webb.phased(size * unit, unit="waves"))) for size in rms]
figure, ax = plt.subplots(figsize=(7, 4), layout="constrained")
ax.plot(rms, ratios, label="Strehl ratio")
ax.plot(rms, np.exp(-((2.0 * np.pi * rms) ** 2)), "--", label="exp(-σ²), equal segments")
ax.set_xlabel("piston errors (waves rms)")
ax.set_ylabel("Strehl ratio")
ax.set_ylim(0.0, 1.0)
ax.grid(alpha=0.3)
ax.legend()
print(f"clear area: {bare.area * np.pi * (0.5 * lm.telescopes.DIAMETERS['jwst']) ** 2:.1f} square metres")
plt.show()
