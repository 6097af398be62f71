"""
A star through the atmosphere
=============================

Fraction of the light of a star on one pixel of a small telescope, for good and bad seeing and with mount jitter.
Each multiplies the transfer function, within the proven error bound.
"""

import matplotlib.pyplot as plt
import numpy as np

import lommel as lm

# %%
# A 0.3 m telescope at f/10 with an obscuration of 0.35, at 600 nm. Seeing is the FWHM at 500 nm, as seeing monitors
# report it; jitter is rms, larger along right ascension.

arcsec = 4.848e-6
focal_length = 3.0
telescope = lm.Pupil(obscuration=0.35, wavelength=600e-9, f_number=10.0)


def air(width):
    return lm.Seeing.from_fwhm(width * arcsec, focal_length=focal_length, wavelength=500e-9)


shake = lm.Jitter(1.0 * arcsec * focal_length, 0.2 * arcsec * focal_length)
nights = {
    "no air": (),
    "0.5 arcsec": air(0.5),
    "2 arcsec": air(2.0),
    "2 arcsec, and the mount shakes": [air(2.0), shake],
}
pixel = 0.1 * arcsec * focal_length
stars = {night: lm.psf(telescope, shape=101, pixel=pixel, blur=blur, tol=1e-4) for night, blur in nights.items()}

figure, axes = plt.subplots(1, 4, figsize=(11, 3.4), layout="constrained")
peak = stars["no air"].values.max()
for ax, (night, star) in zip(axes, stars.items(), strict=True):
    shown = ax.imshow(
        np.log10(star.values / peak), extent=(-5.05, 5.05, 5.05, -5.05), cmap="inferno", vmin=-5, vmax=0
    )
    ax.set_title(f"{night}\n{float(star.values.max() / peak):.2g} of the peak", fontsize=9)
    ax.set_xlabel("arcsec")
    print(f"{night}: bound on the error {star.error_bound:.1g} of its peak")
figure.colorbar(shown, ax=axes, label="log10 (1 = peak without air)", shrink=0.8)
plt.show()

# %%
# On a real sensor pixels are larger. What the lens, the air, and the pixel leave of the contrast is one product:

frequency = np.linspace(0.0, 1.2, 121)  # cycles per arcsec
figure, ax = plt.subplots(figsize=(7, 4), layout="constrained")
for night, blur in nights.items():
    f = frequency / (arcsec * focal_length)
    ax.plot(frequency, lm.mtf(telescope, f, pixel=5.5e-6, blur=blur, tol=1e-6), label=night)
ax.set_xlabel("frequency along the rows (cycles per arcsec)")
ax.set_ylabel("contrast, with pixels of 5.5 µm (1 = all)")
ax.set_ylim(0.0, 1.0)
ax.grid(alpha=0.3)
ax.legend()
plt.show()
