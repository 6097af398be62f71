r"""
Achievable depth precision
==========================

The Cramér-Rao bound of the distance of a point source, from the Fisher information of its image: no unbiased
estimate has a smaller standard error.
"""

import matplotlib.pyplot as plt
import numpy as np

import lommel as lm

lens = lm.Lens(focal_length=50e-3, f_number=2.8, focus_distance=2.0, wavelength=550e-9)
camera = {"shape": 65, "pixel": 4.5e-6, "background": 5.0, "noise": lm.Noise(read=3.0)}
unknown = ("object_distance", "photons", "background")

# %%
# One image of a point at 2.1 m of unknown position and brightness. The position does not correlate with the
# distance, and is omitted from here on.

print(lm.fisher(lens.pupil(2.1), of=(*unknown, "row", "column"), photons=1e4, **camera))

# %%
# One exposure, for all focus settings and f-numbers. A wider aperture collects more light and blurs more; both add
# information. In focus the image does not change with distance to first order, and the bound is infinite.

focus = np.linspace(1.6, 2.6, 41)
stops = np.geomspace(1.4, 16.0, 13)


def errors(f_number: float, focus_distance: float) -> float:
    """Return how well the distance of a point at 2 m can be known, metres."""
    there = lens.stopped(f_number).focused(focus_distance)
    photons = 1e4 * (2.8 / f_number) ** 2
    found = lm.fisher(there.pupil(2.0), of=unknown, photons=photons, **camera)
    return float(found.errors["object_distance"])


known = 1e3 * np.array([[errors(stop, distance) for distance in focus] for stop in stops])

# %%
# Two images that share the light, focused in front of and behind the point, determine its distance everywhere.
# Pupils in a list are images of one scene; a stack of distances is one scene each.

distance = np.linspace(1.7, 2.5, 161)
one = lm.fisher(lens.pupil(distance), of=unknown, photons=1e4, **camera)
pair = [lens.focused(1.9).pupil(distance), lens.focused(2.1).pupil(distance)]
two = lm.fisher(pair, of=unknown, photons=0.5e4, **camera)
print(one, two, sep="\n")

figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.2), layout="constrained")
shown = left.pcolormesh(focus, stops, known, norm="log", vmin=0.05, vmax=50, cmap="viridis_r", rasterized=True)
left.set_yscale("log", base=2)
left.set_yticks([1.4, 2, 2.8, 4, 5.6, 8, 11, 16], [f"f/{n:g}" for n in (1.4, 2, 2.8, 4, 5.6, 8, 11, 16)])
left.set_xlabel("lens focused at (m)")
left.set_title("a point at 2 m in one image (white: cannot be known)", fontsize=10)
figure.colorbar(shown, ax=left, label="standard error of its distance (mm)", extend="both")
right.semilogy(distance, 1e3 * one.errors["object_distance"], label="one image, focused at 2 m")
right.semilogy(distance, 1e3 * two.errors["object_distance"], label="two with half the light, at 1.9 m and 2.1 m")
right.set_xlabel("distance of the point (m)")
right.set_ylabel("standard error of its distance (mm)")
right.set_title("at f/2.8", fontsize=10)
right.set_ylim(0.2, 5)
right.set_yticks([0.2, 0.5, 1, 2, 5], ["0.2", "0.5", "1", "2", "5"])
right.minorticks_off()
figure.get_layout_engine().set(w_pad=0.12)
right.legend()
plt.show()
