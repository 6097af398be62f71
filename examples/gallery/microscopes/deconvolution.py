"""
3-D deconvolution with right and wrong PSFs
===========================================

A hollow sphere, a filament and some points, 10 µm deep in water below an oil objective: a noisy stack is
deconvolved with the PSF of that depth, and with PSFs of wrong depth.
"""

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
z = np.arange(-10, 11) * step


def psf_at(depth):
    """Return the PSF of emitters at a depth, brightest where z is 0."""
    return lm.psf(objective.pupil(depth=depth, z=z, wavelength=520e-9), shape=25, pixel=pixel, tol=1e-4)


# %%
# The ground truth is known. The recording has some hundred photons in the brightest voxels and a read noise of 1.5
# electrons.

planes, side = 16, 40
k, y, x = np.ogrid[:planes, :side, :side]
away = np.sqrt(((k - 8) * 2.0) ** 2 + (y - 18) ** 2 + (x - 15) ** 2)
specimen = np.where(abs(away - 9.0) < 0.8, 1000.0, 0.0)
specimen[np.arange(3, 14), np.arange(28, 6, -2), 30] = 4000.0
specimen[[4, 12, 9], [33, 6, 34], [9, 8, 33]] = 12000.0

right = psf_at(10e-6)
blur = lm.microscopy.StackBlur(right, specimen.shape)
light = np.moveaxis(blur.forward(np.moveaxis(specimen, 0, -1).astype(np.float32)), -1, 0)
noise = lm.Noise(read=1.5)
stack = noise.record(np.maximum(light, 0.0), seed=3)
print(f"{light.max():.0f} photons in the brightest voxel, {light.mean():.0f} on average")


def error(values):
    """Return the difference from the specimen over the specimen, rms."""
    return float(np.sqrt(((values - specimen) ** 2).sum() / (specimen**2).sum()))


# %%
# Forty steps of Richardson-Lucy with the right PSF, with that of an emitter on the glass, which is symmetric in z,
# and with that of twice the depth. Sections through the centre of the sphere, square root of the values.

way = lm.imaging.RichardsonLucy(steps=40, target=0.0)
psfs = {"the right one": right, "of depth 0": psf_at(0.0), "of depth 20 µm": psf_at(20e-6)}
restored = {name: lm.microscopy.deconvolve(stack, psf, noise=noise, method=way) for name, psf in psfs.items()}
print(f"before: {error(stack):.2f} of the specimen")
for name, found in restored.items():
    print(f"with the PSF {name}: {error(found.values):.2f}, discrepancy {found.channels[0].discrepancy:.2f}")

shown = {"specimen": specimen, "recording": stack} | {name: found.values for name, found in restored.items()}
figure, panels = plt.subplots(2, 5, figsize=(10.5, 4.6), layout="constrained", height_ratios=(1.0, 0.8))
for (above, below), (name, values) in zip(panels.T, shown.items(), strict=True):
    for axes, part, height in ((above, values[8], 4.0), (below, values[:, 18], 3.2)):
        axes.imshow(np.sqrt(np.maximum(part, 0.0)), cmap="inferno", vmin=0.0, extent=(0.0, 4.0, height, 0.0))
    above.set_title(name, fontsize=10)
    below.set_xlabel("x (µm)")
panels[0, 0].set_ylabel("y (µm)")
panels[1, 0].set_ylabel("z of the stage (µm)")

# %%
# Error against steps, and the discrepancy, which needs no ground truth: it falls to 1, the noise level, only for
# the right PSF.

counts = [5, 10, 20, 40]
figure, (left, middle) = plt.subplots(1, 2, figsize=(9.0, 3.4), layout="constrained")
for name, psf in psfs.items():
    found = [
        lm.microscopy.deconvolve(stack, psf, noise=noise, method=lm.imaging.RichardsonLucy(steps=n, target=0.0))
        for n in counts[:-1]
    ] + [restored[name]]
    left.plot(counts, [error(one.values) for one in found], "o-", label=name)
    middle.semilogy(counts, [one.channels[0].discrepancy for one in found], "o-")
left.axhline(error(stack), color="0.6", label="recording")
left.set_ylabel("rms error over that of nothing")
left.legend(fontsize=9)
middle.set_ylabel("discrepancy")
middle.set_yticks([1, 1.5, 2, 3, 4], ["1", "1.5", "2", "3", "4"])
middle.minorticks_off()
for axes in (left, middle):
    axes.set_xlabel("steps")
    axes.grid(alpha=0.3)
plt.show()
