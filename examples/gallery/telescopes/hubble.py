"""
The Hubble Space Telescope before and after its repair
======================================================

The primary mirror of the Hubble Space Telescope had spherical aberration, corrected in 1993. How much light did it
lose within 0.1 arcsec?
"""

import math

import matplotlib.pyplot as plt
import numpy as np

import lommel as lm

# %%
# 2.4 m aperture at f/24 with an obscuration of 0.33, and about 0.265 µm rms of spherical aberration (C. J. Burrows
# et al., Astrophys. J. 369, L21 (1991), doi:10.1086/185950). Balanced spherical aberration has the least variance,
# but that is not where most light is within 0.1 arcsec: ``best_focus`` finds the defocus that is.

wavelength = 0.55e-6
options = {"obscuration": 0.33, "wavelength": wavelength, "f_number": 24.0}
arcsec = 57.6 * math.pi / 648000  # metres on the sensor
balanced = lm.Wavefront.balanced_spherical(2 * math.pi * 0.265e-6 / wavelength, obscuration=0.33)
refocus = lm.Wavefront(lm.best_focus(lm.Pupil(balanced, **options), 0.1 * arcsec))
before = lm.psf(lm.Pupil(balanced + refocus, **options), shape=401, pixel=0.01 * arcsec)
after = lm.psf(before.pupil.unaberrated(), shape=401, pixel=0.01 * arcsec)

radius = np.linspace(0.0, 2.0, 401)
figure = plt.figure(figsize=(10.5, 6.6), layout="constrained")
pictures, graph = figure.subfigures(2, 1, height_ratios=(1.15, 1))
for axes, answer, title in zip(pictures.subplots(1, 2), (before, after), ("1990", "as designed"), strict=True):
    shown = axes.imshow(
        np.log10(np.maximum(answer.values / after.values.max(), 1e-9)),
        extent=(-2.005, 2.005, 2.005, -2.005),
        cmap="inferno",
        vmin=-6,
        vmax=0,
    )
    axes.set_title(title)
    axes.set_xlabel("arcsec")
    axes.set_ylabel("arcsec")
pictures.colorbar(shown, ax=pictures.axes, label="log10 of the intensity\n(1 = peak as designed)")

axes = graph.subplots()
for answer, label in ((before, "1990, at best focus"), (after, "as designed")):
    inside = answer.encircled_energy(radius * arcsec, of="optics")
    axes.plot(radius, inside, label=label)
    within = float(answer.encircled_energy(0.1 * arcsec, of="optics"))
    axes.plot(0.1, within, "o", color=axes.lines[-1].get_color())
    axes.annotate(f"{100 * within:.1f} % within 0.1 arcsec", (0.1, within), (0.22, within - 0.035))
    print(f"{label}: {100 * within:.1f} % within 0.1 arcsec, Strehl ratio {float(answer.strehl):.3f}")
axes.set_xlim(0.0, 2.0)
axes.set_ylim(0.0, 1.0)
axes.set_xlabel("radius (arcsec)")
axes.set_ylabel("fraction of all light inside")
axes.grid(alpha=0.3)
axes.legend(loc="lower right")
plt.show()

# %%
# This is the effect of spherical aberration alone: no jitter, micro-roughness, struts or bandwidth. Encircled
# energies are computed from the profile by quadrature, to the tolerance of the method.
