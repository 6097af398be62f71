"""
PSFs over the field of a camera
===============================

A lens is at its best on the axis. Towards the corners of the sensor coma grows with the distance from the axis,
astigmatism and field curvature with its square, and every point of the picture has a PSF of its own.
"""

import matplotlib.pyplot as plt
import numpy as np

import lommel as lm

# %%
# A 35 mm lens at f/2 on a full-frame sensor, 24 mm by 36 mm. The coefficients are in waves in the corner and
# illustrative, of the size that a classic fast lens has. One call computes all 35 images. Each is drawn enlarged in
# its place, its brightness the square root of the intensity over its own peak.

sensor = (24e-3, 36e-3)
corner = np.hypot(*sensor) / 2
field = lm.FieldMap.from_seidel(
    corner, W020=-0.4, W040=0.4, W131=2.0, W222=1.6, W220=-0.9, wavelength=550e-9, f_number=2.0
)
grid = field.grid(5, 7, sensor=sensor, shape=49, pixel=0.5e-6)
grid.plot()

# %%
# The tails of coma point away from the axis, and the lens is symmetric: what is seen along one line from the axis to
# the corner is seen along all. Designs are therefore given as Zernike coefficients at a few heights. Here are those
# of the same lens, at four heights; the map between them is a spline, and rotates.

heights = np.array([0.0, 0.4, 0.7, 1.0]) * corner
design = field.pupil(heights, 0.0).wavefront.to_zernike(order="fringe", unit="waves", normalization="edge")
for index, values in design.items():
    print(f"Fringe {index}:", "  ".join(f"{value:+.2f}" for value in values), "waves")
wavefronts = lm.Wavefront.zernike(design, order="fringe", unit="waves", normalization="edge")
same = lm.FieldMap.radial(heights, wavefronts, wavelength=550e-9, f_number=2.0)
again = same.grid(5, 7, sensor=sensor, shape=49, pixel=0.5e-6)
print(f"largest difference: {np.abs(again.values - grid.values).max() / grid.values.max():.1e} of the peak")

# %%
# How much does it cost? The brightest point of each image over that of a perfect lens, along the diagonal, with the
# sensor where it is and moved by 10 µm either way: no position of a flat sensor suits all of a curved field.

fraction = np.linspace(0.0, 1.0, 21)
along = fraction[:, None] * corner * np.array([0.8, 0.6])
figure, axes = plt.subplots(figsize=(8, 4.2), layout="constrained")
for shift, color in ((-10e-6, "C0"), (0.0, "C1"), (10e-6, "C2")):
    # Towards the lens, defocus rises by pi shift / (8 lambda N^2).
    moved = field + lm.Wavefront(-np.pi * shift / (8 * 550e-9 * 2.0**2))
    psf = moved.psf(along[:, 0], along[:, 1], 61, 0.2e-6, normalize="strehl")
    axes.plot(fraction * corner * 1e3, psf.values.max(axis=(1, 2)), color=color, label=f"{shift * 1e6:+.0f} µm")
axes.set_xlabel("distance from the axis (mm)")
axes.set_ylabel("peak over that of a perfect lens")
axes.set_ylim(0.0, None)
axes.legend(title="sensor moved by")
plt.show()
