"""
A photograph out of focus, made sharp
=====================================

A photograph that is out of focus by an unknown distance is deblurred with one command, and compared with two methods
of scikit-image that are given the PSF of the true distance. All have the same photograph and noise.

The scene is the portrait of Eileen Collins (NASA) that scikit-image distributes. It is blurred without lommel: by the
Fourier transform of the pupil, on two by two points per pixel, with light from outside of the frame.
"""

import matplotlib.pyplot as plt
import numpy as np
from scipy.ndimage import uniform_filter, zoom
from scipy.signal import fftconvolve
from skimage.data import astronaut
from skimage.restoration import richardson_lucy, unsupervised_wiener

import lommel as lm
from lommel.base.encoding import from_light, to_light

FOCAL_LENGTH, F_NUMBER, FOCUS, PIXEL = 50e-3, 2.8, 2.0, 6e-6
DISTANCE, WAVELENGTHS = 1.8, (610e-9, 540e-9, 465e-9)
FINE, EDGE = 2, 16  # points along a side of a pixel; pixels beyond the frame
lens = lm.Lens(focal_length=FOCAL_LENGTH, f_number=F_NUMBER, focus_distance=FOCUS, wavelength=540e-9)
noise = lm.Noise(white=5000, read=3.0)


def spread(wavelength: float) -> np.ndarray:
    """Return the PSF on the fine points, by the Fourier transform of the pupil."""
    side, finer, radius = 1280, 5, 0.5 * FOCAL_LENGTH / F_NUMBER
    image = 1.0 / (1.0 / FOCAL_LENGTH - 1.0 / FOCUS)
    step = wavelength * image * finer * FINE / (side * PIXEL)  # of the points of the pupil
    r2 = np.add.outer(*2 * [np.square((np.arange(side) - side // 2) * step)])
    phase = np.pi / wavelength * (1.0 / DISTANCE - 1.0 / FOCUS) * r2
    light = np.abs(np.fft.fftshift(np.fft.fft2((r2 < radius**2) * np.exp(1j * phase)))) ** 2
    reach = EDGE * FINE * finer
    part = slice(side // 2 - reach, side // 2 + reach + 1, finer)
    light = uniform_filter(light, finer)[part, part]
    return light / light.sum()


def pixels(fine: np.ndarray) -> np.ndarray:
    """Return the averages over pixels."""
    height, width = (side // FINE for side in fine.shape)
    return fine[: height * FINE, : width * FINE].reshape(height, FINE, width, FINE).mean((1, 3))


scene = 0.9 * to_light("image", astronaut(), "srgb", np.float64)
channels = []
for channel, wavelength in enumerate(WAVELENGTHS):
    fine = np.clip(zoom(scene[..., channel], FINE, order=3), 0.0, 1.0)
    margin = EDGE * FINE
    blurred = fftconvolve(fine, spread(wavelength), "valid")
    seen = noise.record(5000.0 * np.maximum(pixels(blurred), 0.0), seed=channel)
    channels.append((pixels(fine[margin:-margin, margin:-margin]), seen))
truth, photo = (np.clip(np.stack(images, axis=2), 0.0, 1.0) for images in zip(*channels, strict=True))
photo = from_light(photo, "srgb", np.uint16)


def shown(light: np.ndarray) -> np.ndarray:
    """Return 8 bits of sRGB."""
    return from_light(np.clip(light, 0.0, 1.0), "srgb", np.uint8)


def quality(light: np.ndarray) -> str:
    """Return the PSNR of sRGB, less the edges."""
    off = (shown(light).astype(float) - shown(truth))[16:-16, 16:-16] / 255.0
    return f"{-10.0 * np.log10(np.mean(off**2)):.1f} dB"


# %%
# The distance is not stated: it is estimated from the blur, with its standard error, on either side of the focus. In
# the shell this is ``lommel restore photo.tif lens.toml --focus 2m --at unknown --white 5000 --read 3 -o sharp.tif``.

found = lm.imaging.restore(photo, "unknown", lens, PIXEL, encoding="srgb", noise=noise)
print(found)
for distance, error in zip(found.distances, found.distance_errors, strict=True):
    print(f"{distance:.3f} m +- {error:.3f} m")

light = to_light("image", photo, "srgb", np.float64)
figure, places = plt.subplots(1, 2, figsize=(10, 5.4), layout="constrained")
for place, name, picture in zip(places, ("photograph", "restored"), (light, found.light), strict=True):
    place.imshow(shown(picture)[20:-20, 20:-20])
    place.set_title(f"{name}, {quality(picture)}", fontsize=11)
    place.set_xlabel("x (pixels)")
places[0].set_ylabel("y (pixels)")

# %%
# scikit-image has the PSF of the true distance, and the number of steps of Richardson-Lucy that is nearest to the
# scene. Borders are mirrored.

pad = 32
window = [lm.psf(lens.pupil(DISTANCE).in_light(wave), 33, PIXEL, dtype=np.float64).values for wave in WAVELENGTHS]


def by_channel(method, *arguments, **options) -> np.ndarray:
    """Return the result of a method of scikit-image for each channel."""
    planes = [np.pad(light[..., c], pad, mode="symmetric") for c in range(3)]
    made = [method(plane, h / h.sum(), *arguments, **options) for plane, h in zip(planes, window, strict=True)]
    return np.stack([each[0] if isinstance(each, tuple) else each for each in made], 2)[pad:-pad, pad:-pad]


steps = {n: by_channel(richardson_lucy, num_iter=n, clip=False) for n in (10, 20, 40)}
best = min(steps, key=lambda n: np.mean(np.square(shown(steps[n]).astype(float) - shown(truth))))
pictures = {
    "scene": truth,
    f"photograph\n{quality(light)}": light,
    f"lommel, distance unknown\n{quality(found.light)}": found.light,
    f"scikit-image, Richardson-Lucy,\nbest of 10, 20, 40 steps: {quality(steps[best])}": steps[best],
}
wiener = by_channel(unsupervised_wiener, rng=0, clip=False)
pictures[f"scikit-image,\nunsupervised Wiener {quality(wiener)}"] = wiener
figure, places = plt.subplots(2, 5, figsize=(12.5, 5.8), layout="constrained")
for row, part in enumerate((np.s_[60:190, 140:270], np.s_[330:460, 300:430])):
    for place, (name, picture) in zip(places[row], pictures.items(), strict=True):
        place.imshow(shown(picture)[part])
        place.set_title("" if row else name, fontsize=10)
        place.tick_params(labelsize=7)
    places[row, 0].set_ylabel("y (pixels)")
plt.show()
