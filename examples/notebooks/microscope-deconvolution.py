# %% [markdown]
# # Deconvolution of a microscope stack
#
# A specimen 10 µm deep in water below an oil objective. Its PSF is not that of an emitter at the cover glass:
# spherical aberration by the mismatch of the refractive indices makes it asymmetric in z. The stack is deconvolved
# with the PSF of that depth and with the PSF of depth 0.

# %%
import matplotlib.pyplot as plt
import numpy as np

import lommel as lm

objective = lm.Objective(
    NA=1.3,
    magnification=60,
    immersion=1.515,
    working_distance=0.2e-3,
    coverslip=lm.Layer(1.5255, 170e-6),
    sample=1.33,
)
step, pixel = 200e-9, 6e-6  # of the stage, and on the camera: 100 nm in the specimen
z = np.arange(-8, 9) * step
psfs = {
    f"{1e6 * depth:.0f} µm": lm.psf(objective.pupil(depth=depth, z=z, wavelength=520e-9), 25, pixel, tol=1e-4)
    for depth in (10e-6, 0.0)
}

figure, panels = plt.subplots(1, 2, figsize=(6.5, 3.6), layout="constrained")
panels[0].set_ylabel("z (steps of 200 nm)")
for panel, (name, psf) in zip(panels, psfs.items(), strict=True):
    panel.imshow(np.sqrt(psf.values[:, 12]), cmap="inferno", aspect=2.0)
    panel.set_title(f"PSF of depth {name}")
    panel.set_xlabel("x (pixels of 100 nm)")

# %% [markdown]
# ## The stack
#
# A hollow sphere and some points, blurred with the PSF of 10 µm and recorded with shot noise and read noise.

# %%
planes, side = 12, 32
k, y, x = np.ogrid[:planes, :side, :side]
away = np.sqrt(((k - 6) * 2.0) ** 2 + (y - 14) ** 2 + (x - 13) ** 2)
specimen = np.where(abs(away - 7.0) < 0.8, 1000.0, 0.0)
specimen[[3, 9, 6], [26, 5, 27], [7, 26, 26]] = 12000.0
blur = lm.microscopy.StackBlur(psfs["10 µm"], specimen.shape)
light = np.moveaxis(blur.forward(np.moveaxis(specimen, 0, -1).astype(np.float32)), -1, 0)
noise = lm.Noise(read=1.5)
stack = noise.record(np.maximum(light, 0.0), seed=3)

# %% [markdown]
# ## Richardson-Lucy deconvolution
#
# `discrepancy` is the residual in units of the noise, which needs no ground truth: near 1 for the PSF of the right
# depth, larger for the wrong one.

# %%
steps = 30
way = lm.imaging.RichardsonLucy(steps=steps, target=0.0)
found = {name: lm.microscopy.deconvolve(stack, psf, noise=noise, method=way) for name, psf in psfs.items()}
for name, one in found.items():
    error = np.sqrt(((one.values - specimen) ** 2).sum() / (specimen**2).sum())
    print(f"PSF of {name}: error {error:.2f} of the specimen, discrepancy {one.channels[0].discrepancy:.2f}")

shown = {"specimen": specimen, "recorded": stack}
shown |= {f"PSF of {name}": one.values for name, one in found.items()}
figure, panels = plt.subplots(2, 4, figsize=(9.0, 4.6), layout="constrained")
panels[0, 0].set_ylabel("y (pixels)")
panels[1, 0].set_ylabel("z (steps)")
for (above, below), (name, values) in zip(panels.T, shown.items(), strict=True):
    above.imshow(np.sqrt(np.maximum(values[6], 0.0)), cmap="inferno", vmin=0.0)
    below.imshow(np.sqrt(np.maximum(values[:, 14], 0.0)), cmap="inferno", vmin=0.0, aspect=2.0)
    above.set_title(name)
    below.set_xlabel("x (pixels)")
