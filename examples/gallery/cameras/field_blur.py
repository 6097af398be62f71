"""
Blur by coma and astigmatism over the field
===========================================

Coma and astigmatism give every position of the image its own PSF. :class:`lommel.imaging.FieldBlur` blurs the whole
image as a linear operator, and its adjoint lets iterative solvers deblur it.
"""

import matplotlib.pyplot as plt
import numpy as np
from scipy.sparse.linalg import lsqr

import lommel as lm

# %%
# The lens: two waves of coma and one of astigmatism in the corner of a sensor of 21.6 mm by 36 mm, at f/4. The chart:
# Siemens stars, and points of light between them. So few pixels stand for all of the sensor; PSFs are drawn as large
# as they are on pixels of 2 µm.

scale = {"wavelength": 550e-9, "f_number": 4.0}
sensor, shape = (21.6e-3, 36e-3), (216, 360)
field = lm.FieldMap.from_seidel(np.hypot(*sensor) / 2, W131=2.0, W222=1.0, **scale)
given = {"sensor": sensor, "energy": 0.95, "dtype": np.float64}
blur = lm.imaging.FieldBlur(field, shape, 2e-6, **given)
bank = blur.banks[0]
counts = " x ".join(str(nodes.count) for nodes in bank.axes[:2])
print(f"windows of {2 * bank.half + 1}² at {counts} nodes, off by {blur.error:.1e} of the light of a point at most")

y, x = np.mgrid[-36:36, -36:36] + 0.5
star = np.where(np.hypot(x, y) < 32, 0.5 + 0.5 * np.sign(np.sin(12 * np.arctan2(y, x))), 0.0)
chart = np.tile(star, (3, 5))
chart[np.ix_([4, 72, 144, 211], [4, 72, 144, 216, 288, 355])] = 12.0
image = blur.forward(chart)

figure, axes = plt.subplots(2, 1, figsize=(8, 10), layout="constrained")
for ax, values, title in zip(axes, (chart, image), ("chart", "image"), strict=True):
    ax.imshow(values, vmin=0, vmax=1, cmap="gray")
    ax.set_title(title)
    ax.set_xlabel("column (pixels)")
    ax.set_ylabel("row (pixels)")

# %%
# The corner, with a little noise, and what thirty steps of SciPy's least squares make of it: by the operator, and by
# one that has a single PSF, that of half-way to the corner, everywhere.

recorded = image + 0.003 * np.random.default_rng(0).standard_normal(shape)
middle = field.pupil(*(0.25 * side for side in sensor[::-1])).wavefront
corners = [0.5 * side * np.array([-1.0, 1.0]) for side in sensor]
same = lm.FieldMap.on_grid(corners[1], corners[0], lm.Wavefront(np.zeros((2, 2))) + middle, **scale)
single = lm.imaging.FieldBlur(same, shape, 2e-6, **given)
found = {
    name: lsqr(operator.as_linear_operator(), recorded.ravel(), iter_lim=30)[0].reshape(shape)
    for name, operator in (("one PSF for all", single), ("the PSF of each place", blur))
}
figure, axes = plt.subplots(2, 2, figsize=(8, 8), layout="constrained")
for ax, (name, values) in zip(axes.flat, {"chart": chart, "image": recorded, **found}.items(), strict=True):
    off = np.sqrt(np.mean((values - chart)[20:-20, 20:-20] ** 2))
    ax.imshow(values[-80:, -100:], vmin=0, vmax=1, cmap="gray", extent=(260, 360, 216, 136))
    ax.set_title(name if name == "chart" else f"{name}: {off:.2f} rms off")
    ax.set_xlabel("column (pixels)")
    ax.set_ylabel("row (pixels)")
plt.show()
