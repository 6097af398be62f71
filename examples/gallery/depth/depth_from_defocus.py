"""
Depth from defocus with two photographs
=======================================

Two photographs at different focus give a depth map with its standard error, and an all-in-focus image. The
exact PSF is compared with the usual approximations, a uniform disc and a Gaussian.

The scene is the motorcycle of the Middlebury benchmark (Scharstein et al., GCPR 2014,
`doi:10.1007/978-3-319-11752-2_3 <https://doi.org/10.1007/978-3-319-11752-2_3>`__), as distributed with
scikit-image, rendered with occlusion, shot noise and read noise. The lens of 35 mm at f/4 is focused at 2.2 m and
at 3.6 m; pixels are 6 µm.
"""

import matplotlib.pyplot as plt
import numpy as np
from scipy.special import j1
from skimage.data import stereo_motorcycle

import lommel as lm
from lommel.base.encoding import to_light
from lommel.estimation.focal_model import transfer_curve
from lommel.io.depth_maps import fill_missing

left, _, disparity = stereo_motorcycle()
part = np.s_[60:380, 180:620]
known = np.isfinite(disparity)
depth = fill_missing(
    np.where(known, 994.978 * 0.193001 / (np.where(known, disparity, 1.0) + 31.086), np.nan), "nearest"
)
light = to_light("image", left, "srgb", np.float32).mean(axis=2)

pixel = 6e-6
lens = lm.Lens(focal_length=35e-3, f_number=4.0, focus_distance=2.2, wavelength=540e-9)
lenses = [lens, lens.focused(3.6)]
noise = lm.Noise(white=2e4, read=3.0)
photographs = [
    noise.record(
        2e4 * lm.imaging.depth_of_field(light, depth, one, pixel, encoding="linear", energy=0.99).values[part], seed
    )
    for seed, one in enumerate(lenses)
]
truth, scene = depth[part], light[part]

# %%
# Depth, standard error and all-in-focus image from the two photographs, the lens and the noise. Grey is
# unknown: areas without texture, and many pixels at depth edges, where a window sees two depths.

camera = {"encoding": "linear", "noise": noise, "between": (1.9, 5.2)}
found = lm.imaging.depth_from_defocus(photographs, lenses, pixel, **camera)
print(found)

figure, places = plt.subplots(2, 3, figsize=(11, 5.8), layout="constrained", sharex=True, sharey=True)
for place, picture, name in zip(
    places[:, 0], photographs, ("photograph, focus 2.2 m", "photograph, focus 3.6 m"), strict=True
):
    place.imshow(np.clip(picture, 0.0, 1.0) ** (1 / 2.2), cmap="gray")
    place.set_title(name, fontsize=9)
span = {"cmap": "viridis_r", "vmin": 2.1, "vmax": 4.8}
places[0, 1].imshow(found.depth, **span)
places[0, 1].set_title(f"depth found, at {100 * found.known:.0f} %", fontsize=9)
shown = places[1, 1].imshow(truth, **span)
places[1, 1].set_title("depth as it is", fontsize=9)
figure.colorbar(shown, ax=places[:, 1], label="depth (m)", shrink=0.8)
shown = places[0, 2].imshow(np.where(np.isfinite(found.errors), 1e3 * found.errors, np.nan), norm="log")
places[0, 2].set_title("its standard error (mm)", fontsize=9)
figure.colorbar(shown, ax=places[0, 2], shrink=0.8)
places[1, 2].imshow(np.clip(found.sharp, 0.0, 1.0) ** (1 / 2.2), cmap="gray")
places[1, 2].set_title("in focus everywhere", fontsize=9)
for place in places.flat:
    place.set_facecolor("0.55")
for place in places[1]:
    place.set_xlabel("x (pixels)")

# %%
# The same with discs of the circle of confusion and Gaussians of the same second moment in place of the PSF of the
# lens.


def imitated(shape_of):
    """Return what makes transfer functions of the radius of the cone alone."""

    def transfer(one, vergence, _spectrum, pitch):
        radii = one.pupil(1.0 / vergence).geometric_radius() / pitch
        return lambda f: np.array([shape_of(2.0 * np.pi * r * f) for r in radii])

    return transfer


def disc(x):
    """Return the transfer function of a uniform disc."""
    return 2.0 * j1(np.maximum(x, 1e-9)) / np.maximum(x, 1e-9)


def gauss(x):
    """Return that of a Gaussian of the same second moment."""
    return np.exp(-(x**2) / 8.0)


models = {"PSF of the lens": transfer_curve, "disc": imitated(disc), "Gaussian": imitated(gauss)}
figure, places = plt.subplots(2, 3, figsize=(11, 5.2), layout="constrained", sharex=True, sharey=True)
for column, (name, model) in zip(places.T, models.items(), strict=True):
    other = lm.imaging.depth_from_defocus(photographs, lenses, pixel, transfer=model, **camera)
    error = 1e3 * (other.depth - truth)
    column[0].set_facecolor("0.55")
    shown = column[0].imshow(error, cmap="RdBu_r", vmin=-150, vmax=150)
    middle, sure = np.nanmedian(np.abs(error)), np.isfinite(error)
    column[0].set_title(f"{name}: off by {middle:.0f} mm, at {100 * sure.mean():.0f} %", fontsize=9)
    column[1].imshow(np.clip(other.sharp, 0.0, 1.0) ** (1 / 2.2), cmap="gray")
    snr = -10.0 * np.log10(np.mean((other.sharp - scene)[8:-8, 8:-8] ** 2))
    column[1].set_title(f"sharp image: {snr:.1f} dB", fontsize=9)
    print(f"{name}: {middle:.1f} mm, {snr:.1f} dB; best photograph:", end=" ")
    column[1].set_xlabel("x (pixels)")
    print(f"{max(-10 * np.log10(np.mean((one - scene)[8:-8, 8:-8] ** 2)) for one in photographs):.1f} dB")
figure.colorbar(shown, ax=places[0].tolist(), label="error of depth (mm)", extend="both", shrink=0.9)
plt.show()
