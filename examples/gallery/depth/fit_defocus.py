"""
Fitting defocus to a noisy image
================================

The PSF comes with its derivatives with respect to defocus and spherical aberration. A least-squares fit needs a few
evaluations, and the derivatives give the covariance of the estimate.
"""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Ellipse
from scipy.optimize import least_squares

import lommel as lm

rng = np.random.default_rng(1885)
plan = lm.Plan(shape=41, pixel=0.5, dtype="float64")
photons, background = 20_000.0, 2.0
names = ("defocus", "spherical")


def model(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the expected counts for (C_d, C_s, photons, background), and their derivatives."""
    answer = plan(lm.Pupil(lm.Wavefront(x[0], x[1])), derivatives=names)
    image = answer.values.ravel()
    slopes = [x[2] * answer.derivatives[name].ravel() for name in names]
    return x[2] * image + x[3], np.stack([*slopes, image, np.ones_like(image)], axis=1)


def fit(counts: np.ndarray, start: tuple[float, float]) -> np.ndarray:
    """Fit all four numbers; counts are weighted by the noise of a count of their size."""
    weight = 1.0 / np.sqrt(np.maximum(counts, 1.0))
    return least_squares(
        lambda x: (model(x)[0] - counts) * weight,
        jac=lambda x: model(x)[1] * weight[:, None],
        x0=[*start, counts.sum(), 1.0],
        x_scale=[1.0, 1.0, 1e4, 1.0],
    ).x


# %%
# One image, with photon noise. A single image leaves the sign of the wavefront open, so the fit starts on the right
# side; a second image at another focus would decide it.

truth = np.array([6.0, 4.0, photons, background])
expected, slopes = model(truth)
counts = rng.poisson(expected).astype(float)
found = fit(counts, start=(5.0, 2.0))

# %%
# The Cramér-Rao bound, from the derivatives at the ground truth, against the scatter of 300 fits with independent
# noise.

covariance = np.linalg.inv(slopes.T @ (slopes / expected[:, None]))
fits = np.array([fit(rng.poisson(expected).astype(float), start=(5.5, 3.0)) for _ in range(300)])
for k, name in enumerate(("C_d", "C_s")):
    bound, scatter = np.sqrt(covariance[k, k]), fits[:, k].std()
    print(f"{name}: {truth[k]:g}, found {found[k]:.3f}; bound {bound:.3f}, scatter of the fits {scatter:.3f}")

figure, (seen, fitted, rest, cloud) = plt.subplots(
    1, 4, figsize=(12.5, 3.5), layout="constrained", width_ratios=(1, 1, 1, 1.25)
)
extent = (-10.25, 10.25, 10.25, -10.25)
top = counts.max()
seen.imshow(counts.reshape(41, 41), cmap="inferno", extent=extent, vmax=top)
seen.set_title("measured")
shown = fitted.imshow(model(found)[0].reshape(41, 41), cmap="inferno", extent=extent, vmax=top)
fitted.set_title("fitted")
figure.colorbar(shown, ax=(seen, fitted), label="photons per pixel", location="bottom", shrink=0.6)
residual = (counts - model(found)[0]) / np.sqrt(model(found)[0])
shown = rest.imshow(residual.reshape(41, 41), cmap="RdBu_r", extent=extent, vmin=-4, vmax=4)
rest.set_title("difference")
figure.colorbar(shown, ax=rest, label="standard deviations", location="bottom", shrink=0.8)
for axes in (seen, fitted, rest):
    axes.set_xlabel("x (λN)")
seen.set_ylabel("y (λN)")

values, vectors = np.linalg.eigh(covariance[:2, :2])
angle = np.degrees(np.arctan2(vectors[1, 1], vectors[0, 1]))
for sigma in (1, 2, 3):
    width, height = 2 * sigma * np.sqrt(values[::-1])
    cloud.add_patch(Ellipse(truth[:2], width, height, angle=angle, fill=False, color="C3", linewidth=1))
cloud.plot(*fits[:, :2].T, ".", markersize=3, color="C0")
cloud.plot(*truth[:2], "+", color="black", markersize=10)
cloud.set_xlabel("$C_d$ (rad)")
cloud.set_ylabel("$C_s$ (rad)")
cloud.set_title("300 fits; bound at 1, 2, 3 σ")
plt.show()
