"""
White light
===========

Diffraction rings scale with the wavelength. In white light the rings of all wavelengths average out.
"""

import matplotlib.pyplot as plt
import numpy as np

import lommel as lm

# %%
# A 35 mm lens at f/4, focused at 3 m, and an object at 1.7 m. ``Polychromatic`` takes the phase as a path
# difference, the same for all wavelengths, as for a mirror or a well corrected lens: there is no chromatic
# aberration here.

lens = lm.Lens(focal_length=35e-3, f_number=4.0, focus_distance=3.0, wavelength=550e-9)
pupil = lens.pupil(1.7)
window = {"shape": 161, "pixel": 0.6e-6}


def band(center: float, width: float) -> lm.methods.Polychromatic:
    """Return a Gaussian band of wavelengths, its width the standard deviation."""
    wavelengths = center + width * np.linspace(-2.5, 2.5, 31)
    return lm.methods.Polychromatic(wavelengths, weights=np.exp(-0.5 * ((wavelengths - center) / width) ** 2))


mono = lm.psf(pupil, **window)
narrow = lm.psf(pupil, method=band(550e-9, 10e-9), **window)
white = lm.psf(pupil, method=band(550e-9, 55e-9), **window)
colours = [lm.psf(pupil, method=band(c, 20e-9), **window).values for c in (610e-9, 540e-9, 460e-9)]

figure = plt.figure(figsize=(10.5, 6.2), layout="constrained")
pictures, graph = figure.subfigures(2, 1, height_ratios=(1, 1))
half = 0.5e6 * mono.pixel * mono.shape[0]
titles = ("550 nm alone", "10 nm wide", "55 nm wide", "red, green and blue bands")
top = float(white.values.max())
rgb = np.clip(np.stack(colours, axis=-1) / (0.7 * max(c.max() for c in colours)), 0, 1)
images = [np.clip(a.values / (1.3 * top), 0, 1) for a in (mono, narrow, white)] + [rgb]
for axes, image, title in zip(pictures.subplots(1, 4, sharey=True), images, titles, strict=True):
    axes.imshow(image**0.7, cmap="gray", extent=(-half, half, half, -half))
    axes.set_title(title, fontsize=10)
    axes.set_xlabel("x (µm)")
pictures.axes[0].set_ylabel("y (µm)")

axes = graph.subplots()
radius = np.linspace(0.0, 55e-6, 1500)
for answer, title, width in zip((mono, narrow, white), titles, (0.9, 1.2, 2.0), strict=False):
    axes.plot(radius * 1e6, answer.profile(radius)[1] / top, label=title, linewidth=width)
blur = float(pupil.geometric_radius()) * 1e6
axes.axvline(blur, color="black", linestyle=":", linewidth=1)
axes.annotate("edge of the geometric blur", (blur, 1.2), (blur + 0.5, 1.2))
axes.set_xlim(0, 55)
axes.set_ylim(0, 1.4)
axes.set_xlabel("distance from the centre (µm)")
axes.set_ylabel("intensity over the peak\nof the widest band")
axes.legend(loc="upper right", bbox_to_anchor=(1.0, 0.8), title="spectrum (standard deviation)")
print(f"C_d = {float(pupil.wavefront.defocus):.1f} rad at 550 nm; error bound {white.error_bound:.1e}")
plt.show()
