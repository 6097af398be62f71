"""
Depth of field, with and without diffraction
============================================

How large is the blur of an object near focus? In geometric optics the circle of confusion shrinks to zero in focus.
With diffraction it has a minimum, which grows as the lens is stopped down.
"""

import matplotlib.pyplot as plt
import numpy as np

import lommel as lm

distance = 1 / np.linspace(1 / 1.5, 1 / 3.0, 241)
radii = np.linspace(0.0, 120e-6, 1201)
share = 0.8  # of the light: the blur is the radius that holds it


def blur_of_waves(pupils: lm.Pupil) -> np.ndarray:
    """Return the radius that holds 80 % of the light, for each of a stack."""
    inside = lm.psf(pupils, shape=1, pixel=1e-6).encircled_energy(radii, of="optics")
    return np.array([np.interp(share, curve, radii) for curve in inside])


def blur_of_rays(pupils: lm.Pupil) -> np.ndarray:
    """Return the same radius of a uniformly lit disk."""
    return np.sqrt(share) * pupils.geometric_radius()


# %%
# A 50 mm lens focused at 2 m. The dotted line is a blur of one pixel of 4 µm, in radius.

figure, curves = plt.subplots(figsize=(8, 4.6), layout="constrained")
for k, stop in enumerate((2.8, 5.6, 11.0, 22.0)):
    lens = lm.Lens(focal_length=50e-3, f_number=stop, focus_distance=2.0, wavelength=550e-9)
    pupils = lens.pupil(distance)
    curves.plot(distance, blur_of_waves(pupils) * 1e6, color=f"C{k}", label=f"f/{stop:g}")
    curves.plot(distance, blur_of_rays(pupils) * 1e6, color=f"C{k}", linestyle="--", linewidth=0.9)
curves.axhline(4.0, color="black", linestyle=":", linewidth=1)
curves.set_yscale("log")
curves.set_ylim(0.5, 100)
curves.set_xlabel("object distance (m)")
curves.set_ylabel(f"radius of {100 * share:.0f} % of the light (µm)")
curves.legend(title="solid: waves\ndashed: rays")

# %%
# At a fixed distance out of focus there is an optimal f-number: wide open, defocus dominates; stopped down,
# diffraction does. In geometric optics the smallest aperture would always be best.

stops = np.geomspace(2.0, 45.0, 60)
figure, choice = plt.subplots(figsize=(8, 4.6), layout="constrained")
for k, s in enumerate((1.9, 1.8, 1.6)):
    pair = []
    for stop in stops:
        lens = lm.Lens(focal_length=50e-3, f_number=float(stop), focus_distance=2.0, wavelength=550e-9)
        pupil = lens.pupil([s])
        pair.append((blur_of_waves(pupil)[0], blur_of_rays(pupil)[0]))
    waves, rays = np.array(pair).T * 1e6
    choice.loglog(stops, waves, color=f"C{k + 4}", label=f"{s:g} m")
    choice.loglog(stops, rays, color=f"C{k + 4}", linestyle="--", linewidth=0.9)
    best = waves.argmin()
    choice.plot(stops[best], waves[best], "o", color=f"C{k + 4}")
    print(f"object at {s:g} m: least blur {waves[best]:.1f} µm at f/{stops[best]:.1f}")
choice.set_xticks([2, 4, 8, 16, 32], ["2", "4", "8", "16", "32"])
choice.minorticks_off()
choice.set_yticks([1, 2, 5, 10, 20, 50, 100], ["1", "2", "5", "10", "20", "50", "100"])
choice.set_ylim(0.8, 120)
choice.set_xlabel("f-number")
choice.set_ylabel(f"radius of {100 * share:.0f} % of the light (µm)")
choice.legend(title="solid: waves\ndashed: rays\nobject at")
plt.show()
