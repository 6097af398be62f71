r"""
Diffraction spikes
==================

The vanes of a spider block little light, but each diffracts a pair of spikes at right angles to itself.
"""

import matplotlib.pyplot as plt
import numpy as np

import lommel as lm

# %%
# The same obscured aperture without vanes, with four, and with three, whose spikes are six. The scale is logarithmic,
# over six decades.

apertures = {
    "no vanes": None,
    "four vanes": lm.Spider.equal(4, width=0.02),
    "three vanes": lm.Spider.equal(3, width=0.02, first=np.pi / 2),
}
side, pixel = 321, 0.5
figure, axes = plt.subplots(1, 3, figsize=(12.5, 4.4), layout="constrained")
half = 0.5 * side * pixel
for place, (name, spider) in zip(axes, apertures.items(), strict=True):
    pupil = lm.Pupil(obscuration=0.3, spider=spider)
    image = lm.psf(pupil, side, pixel, normalize="strehl")
    shown = place.imshow(
        np.log10(np.maximum(image.values, 1e-12)), vmin=-6, vmax=0, cmap="inferno", extent=(-half, half, half, -half)
    )
    place.set_title(name)
    place.set_xlabel("x (λN)")
    stopped = 100 * (1 - pupil.area / (1 - 0.3**2))
    print(f"{name}: {stopped:.2f} % of the light stopped, by {type(image.method).__name__}")
axes[0].set_ylabel("y (λN)")
figure.colorbar(shown, ax=axes, label="log10 of the intensity over the peak", shrink=0.8)

# %%
# Without vanes the intensity falls with the third power of the distance. A spike is the diffraction pattern of a
# slit as wide as the vane: it extends to its first zero, here at 100 lambda*N.

figure, axes = plt.subplots(figsize=(7.5, 4.2), layout="constrained")
line = lm.psf(lm.Pupil(obscuration=0.3, spider=apertures["four vanes"]), (1, 1201), 0.1, normalize="strehl")
bare = lm.psf(lm.Pupil(obscuration=0.3), (1, 1201), 0.1, normalize="strehl")
for name, image in (("along a spike", line), ("no vanes", bare)):
    distance, values = image.profile()
    blocks = values[: values.size // 30 * 30].reshape(-1, 30).mean(axis=1)
    axes.loglog(distance[15 : 15 + 30 * blocks.size : 30], blocks, label=name)
axes.set_xticks([2, 5, 10, 20, 50], ["2", "5", "10", "20", "50"])
axes.minorticks_off()
axes.set_xlabel("distance from the axis (λN)")
axes.set_ylabel("intensity over the peak, averaged over 3 λN")
axes.set_xticks([2, 5, 10, 20, 50], ["2", "5", "10", "20", "50"])
axes.xaxis.set_minor_formatter("")
axes.grid(alpha=0.3)
axes.legend()
plt.show()

# %%
# A lens file describes any spider in a section ``[aperture.spider]``, as in the Newtonian example.
