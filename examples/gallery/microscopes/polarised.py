"""
Polarised lasers, fixed dipoles and STED
========================================

Confocal spots with a polarised laser and with fixed dipoles, and the STED spot against the saturation of the
depletion beam.
"""

import matplotlib.pyplot as plt
import numpy as np

import lommel as lm

objective = lm.Objective(
    NA=1.4,
    magnification=100,
    immersion=1.518,
    working_distance=0.13e-3,
    coverslip=lm.Layer(1.5255, 170e-6),
    sample=1.518,
)
depth, pixel = 2e-6, 2e-6
emission = objective.pupil(depth=depth, wavelength=680e-9)
dipole = objective.pupil(depth=depth, wavelength=680e-9, emitter=lm.Dipole(polar=0.9, azimuth=0.6))
# All in the planes of the emission.
planes = {"depth": depth, "z": emission.focus, "origin": "coverslip"}
circular, linear = (objective.pupil(**planes, wavelength=640e-9, emitter=lm.Beam(name)) for name in ("circular", "x"))
doughnut = objective.pupil(**planes, wavelength=775e-9, emitter=lm.Beam("vortex"))

# %%
# The dipole absorbs the field component along it. Full widths at half maximum, along the field and across.

spots = {
    "circular laser": lm.microscopy.confocal(circular, emission, 49, pixel, tol=1e-4),
    "laser along x": lm.microscopy.confocal(linear, emission, 49, pixel, tol=1e-4),
    "of a fixed dipole": lm.microscopy.confocal(linear, dipole, 49, pixel, tol=1e-4),
    "doughnut": lm.psf(doughnut, 49, pixel, integrate=False, normalize="strehl", tol=1e-4),
    "STED, saturation 20": lm.microscopy.sted(circular, doughnut, emission, 49, pixel, saturation=20.0, tol=1e-4),
}
figure, panels = plt.subplots(1, len(spots), figsize=(12.0, 3.1), sharey=True, layout="constrained")
half = 1e6 * 24.5 * pixel / 100
for axes, (name, spot) in zip(panels, spots.items(), strict=True):
    axes.imshow(spot.values, cmap="inferno", interpolation="bicubic", extent=(-half, half, half, -half))
    title = name
    if name != "doughnut":
        title += f"\n{1e7 * float(spot.fwhm('x')):.0f} × {1e7 * float(spot.fwhm('y')):.0f} nm"
    axes.set_title(title, fontsize=10)
    axes.set_xlabel("x (µm)")
panels[0].set_ylabel("y (µm)")

# %%
# The width falls with the root of the saturation, at constant peak brightness.

saturation = np.array([0.0, 1.0, 3.0, 10.0, 30.0, 100.0])
made = [lm.microscopy.sted(circular, doughnut, emission, 9, pixel, saturation=s, tol=1e-4) for s in saturation]
figure, axes = plt.subplots(figsize=(6.4, 3.6), layout="constrained")
widths = np.array([1e7 * float(spot.fwhm()) for spot in made])
axes.loglog(1.0 + saturation, widths, "o-")
print("at saturations of", ", ".join(f"{s:g}: {w:.1f} nm" for s, w in zip(saturation, widths, strict=True)))
axes.set_xlabel("1 + saturation on the crest of the doughnut")
axes.set_ylabel("width of the spot (nm)")
axes.set_xticks([1, 10, 100], ["1", "10", "100"])
axes.set_yticks([30, 50, 100, 200], ["30", "50", "100", "200"])
axes.yaxis.set_minor_formatter("")
axes.grid(alpha=0.3)
plt.show()
