"""
PSFs over the field of a camera lens
====================================

Towards the corners of the sensor coma grows linearly with the field, astigmatism and field curvature quadratically,
so that every position has its own PSF.
"""

import matplotlib.pyplot as plt
import numpy as np

import lommel as lm

# %%
# A 35 mm lens at f/2 on a full-frame sensor of 24 mm by 36 mm. The Seidel coefficients, in waves in the corner, are
# illustrative for a classic fast lens. One call computes all 35 PSFs. Each is enlarged at its position and shows
# the square root of the intensity over its own peak.

sensor = (24e-3, 36e-3)
corner = np.hypot(*sensor) / 2
field = lm.FieldMap.from_seidel(
    corner, W020=-0.4, W040=0.4, W131=2.0, W222=1.6, W220=-0.9, wavelength=550e-9, f_number=2.0
)
grid = field.grid(5, 7, sensor=sensor, shape=49, pixel=0.5e-6)
grid.plot()

# %%
# Coma tails point away from the axis. For a rotationally symmetric lens one radial line describes the whole field,
# which is why designs list Zernike coefficients at a few heights. Here are those of the same lens at four heights;
# the field map interpolates them by a spline and rotates them.

heights = np.array([0.0, 0.4, 0.7, 1.0]) * corner
design = field.pupil(heights, 0.0).wavefront.to_zernike(order="fringe", unit="waves", normalization="edge")
for index, values in design.items():
    print(f"Fringe {index}:", "  ".join(f"{value:+.2f}" for value in values), "waves")
wavefronts = lm.Wavefront.zernike(design, order="fringe", unit="waves", normalization="edge")
same = lm.FieldMap.radial(heights, wavefronts, wavelength=550e-9, f_number=2.0)
again = same.grid(5, 7, sensor=sensor, shape=49, pixel=0.5e-6)
print(f"largest difference: {np.abs(again.values - grid.values).max() / grid.values.max():.1e} of the peak")

# %%
# Strehl ratio (peak of each PSF over that of a perfect lens) along the diagonal, with the sensor in place and moved
# by 10 µm either way: with field curvature no sensor position suits the whole field.

fraction = np.linspace(0.0, 1.0, 81)
along = fraction[:, None] * corner * np.array([0.8, 0.6])
figure, axes = plt.subplots(figsize=(8, 4.2), layout="constrained")
for shift, color in ((-10e-6, "C0"), (0.0, "C1"), (10e-6, "C2")):
    # Towards the lens, defocus rises by pi shift / (8 lambda N^2).
    moved = field + lm.Wavefront(-np.pi * shift / (8 * 550e-9 * 2.0**2))
    psf = moved.psf(along[:, 0], along[:, 1], 61, 0.2e-6, normalize="strehl")
    label = f"{shift * 1e6:+.0f} µm".replace("-", "−")
    axes.plot(fraction * corner * 1e3, psf.values.max(axis=(1, 2)), color=color, label=label)
axes.set_xlabel("distance from the axis (mm)")
axes.set_ylabel("peak over that of a perfect lens")
axes.set_ylim(0.0, None)
axes.legend(title="sensor moved by")
plt.show()
