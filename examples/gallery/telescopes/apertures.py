"""
Spiders, vignetting and masks
=============================

Apertures with a spider, cat's-eye vignetting, and a segmented mirror as a mask, with their PSFs.
"""

import matplotlib.pyplot as plt
import numpy as np

import lommel as lm
from lommel.optics.aperture.mask import cell_centers

# %%
# A `Spider` has straight vanes, `CatEye` and `Ellipse` are edges within which light passes, and a `Mask` holds the
# amplitude over the aperture, sampled from any function. They combine with each other, with an obscuration, a
# Gaussian beam, and any wavefront.


def hexagons(x: np.ndarray, y: np.ndarray, size: float = 0.37, gap: float = 0.03) -> np.ndarray:
    """Six hexagons around an empty place, their flat sides up; `size` is the distance of their middles."""
    clear = np.zeros(np.broadcast_shapes(x.shape, y.shape), dtype=bool)
    for direction in np.pi / 6 + np.pi / 3 * np.arange(6):
        u, v = x - 1.55 * size * np.cos(direction), y - 1.55 * size * np.sin(direction)
        sides = [np.abs(u * np.cos(a) + v * np.sin(a)) for a in np.pi / 6 + np.pi / 3 * np.arange(3)]
        clear |= np.max(sides, axis=0) < 0.5 * (1.55 * size - gap)
    return clear


defocus = lm.Wavefront(defocus=16.0)
pupils = {
    "four vanes": lm.Pupil(obscuration=0.33, spider=lm.Spider.equal(4, width=0.03, first=np.pi / 4)),
    "three vanes": lm.Pupil(obscuration=0.33, spider=lm.Spider.equal(3, width=0.03, first=np.pi / 2)),
    "hexagons": lm.Pupil(mask=lm.Mask.sample(hexagons, side=512)),
    "cat's eye, defocused": lm.Pupil(defocus, vignetting=lm.CatEye(shift=(0.6, 0.3))),
    "the same with coma": lm.Pupil(
        defocus + lm.Wavefront(nonradial={(3, 1): 4.0, (3, -1): 2.0}), vignetting=lm.CatEye(shift=(0.6, 0.3))
    ),
}

# %%
# The method is chosen by the pupil: the series for discs and annuli, a non-uniform FFT from Gauss nodes for these.

at = cell_centers(400)
figure, rows = plt.subplots(2, len(pupils), figsize=(10.5, 5.0), layout="constrained")
for column, (name, pupil) in zip(rows.T, pupils.items(), strict=True):
    answer = lm.psf(pupil, shape=201, pixel=0.25, normalize="peak")
    column[0].imshow(np.abs(pupil.values(at[None, :], at[:, None])[0]), cmap="gray", extent=(-1, 1, 1, -1))
    column[0].set_title(name, fontsize=10)
    column[0].set_xlabel("x (radii)")
    answer.plot(column[1], stretch="sqrt" if "eye" in name or "coma" in name else "log")
rows[0, 0].set_ylabel("y (radii)")
for axes in rows.ravel():
    axes.tick_params(labelsize=9)
    axes.xaxis.label.set_size(10)
for axes in rows[:, 1:].ravel():
    axes.set_ylabel("")

# %%
# Accuracy, against a tolerance of 1e-11, beside sampled pupils: the matrix Fourier transform of Soummer et al. with
# binary and grey edges.

pupil = pupils["four vanes"]
exact = lm.psf(pupil, 65, 0.5, tol=1e-11)
samples = np.array([64, 96, 128, 192, 256, 384, 512, 768, 1024])
figure, axes = plt.subplots(figsize=(7.5, 4.2), layout="constrained")
for edge in ("binary", "grey"):
    errors = [
        lm.peak_error(lm.psf(pupil, 65, 0.5, method=lm.methods.MatrixFourier(int(n), edge)), exact) for n in samples
    ]
    axes.loglog(samples, errors, "o-", label=f"MatrixFourier, {edge}")
axes.axhline(
    lm.peak_error(lm.psf(pupil, 65, 0.5, dtype="float64"), exact), color="C3", label="NonuniformFFT, tol = 1e-6"
)
axes.set_xlabel("samples across the aperture")
axes.set_ylabel("largest error over the peak")
axes.grid(alpha=0.3)
axes.legend()
stopped = 100 * (1 - pupil.area / (1 - 0.33**2))
print(f"chosen: {lm.psf(pupil, 9, 0.5).method!r}; the vanes stop {stopped:.1f} % of the light")
plt.show()
