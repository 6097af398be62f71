"""Depth from two photographs: how exact it is beside what is possible, and beside what other PSFs make of it.

A 35 mm lens at f/8 and f/2.8, focused at 1.35 m and 1.8 m, pixels of 4 um, 10^4 electrons a pixel, reading noise 3;
light of 540 nm. Textures of a power that falls as the squared frequency, contrast 0.35 of structures of 2 to 128
pixels. Planes at 1.4 to 1.7 m are spread by their PSFs, of 257 x 257 pixels; a slanted plane with a bump, by
DepthBlur: not by the transfer functions that the estimate is of. `python benchmarks/depth_from_defocus.py --help` has
the options.
"""

from __future__ import annotations

import argparse
import math
import time
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

import lommel as lm
from lommel.estimation.pixel_transfer import multiplicity, pixel_transfer, squared_frequency
from lommel.imaging import DefocusDepth, depth_from_defocus

Array = NDArray[Any]
PIXEL, ELECTRONS, CONTRAST, WINDOW = 4e-6, 1e4, 0.35, 4.0
NOISE = lm.Noise(white=ELECTRONS, read=3.0)
NEAR, FAR, BETWEEN, BETWEEN_SLANTED = 1.35, 1.8, (1.2, 2.0), (1.2, 2.1)
DISTANCES = (1.4, 1.5, 1.6, 1.7)
EDGE = 24


def pair(f_number: float) -> list[lm.Lens]:
    """Return the lens at both foci."""
    lens = lm.Lens(focal_length=35e-3, f_number=f_number, focus_distance=NEAR, wavelength=540e-9)
    return [lens, lens.focused(FAR)]


def texture(side: int, seed: int) -> Array:
    """Return light with the mean 1."""
    square = squared_frequency((128, 128))
    square[0, 0] = np.inf
    power = CONTRAST**2 / float((multiplicity((128, 128)) / square).sum())
    f = np.fft.fftfreq(side)
    square = f[:, None] ** 2 + f**2
    square[0, 0] = np.inf
    white = np.fft.fft2(np.random.default_rng(seed).normal(size=(side, side)))
    return np.asarray(np.maximum(1.0 + np.fft.ifft2(white * np.sqrt(power / square)).real, 0.02))


def plane(f_number: float, distance: float, seed: int, side: int = 256) -> list[Array]:
    """Return photographs of a plane, and noise of their own."""
    from scipy.signal import fftconvolve

    scene = texture(side + 256, seed)
    out = []
    for k, lens in enumerate(pair(f_number)):
        spread = lm.psf(lens.pupil(distance), 257, PIXEL, integrate=True, dtype=np.float64).values
        light = fftconvolve(scene - 1.0, spread, mode="same")[128:-128, 128:-128] + 1.0
        out.append(NOISE.record(ELECTRONS * np.maximum(light, 0.0), seed=1000 * seed + k))
    return out


def slanted(side: int, f_number: float = 2.8, seed: int = 0) -> tuple[list[Array], Array, Array]:
    """Return photographs of a slanted plane with a bump, its depth, and itself."""
    y, x = np.mgrid[:side, :side] / (side - 1.0)
    depth = 1.3 + 0.6 * (0.15 * y + 0.85 * x)
    depth -= 0.1 * np.exp(-((x - 0.6) ** 2 + (y - 0.5) ** 2) / (2.0 * 0.12**2))
    scene = texture(side, seed)
    out = []
    for k, lens in enumerate(pair(f_number)):
        blur = lm.imaging.DepthBlur(depth, lens, PIXEL, energy=0.998, largest=side)
        light = blur.forward(scene.astype(np.float32))
        out.append(NOISE.record(ELECTRONS * np.maximum(light, 0.0), seed=7 + k))
    return out, depth, scene


def imitated(window: Callable[[float, Array], Array]) -> Callable[..., NDArray[np.float32]]:
    """Return what makes transfer functions of a model that knows the radius of the cone of rays, in pixels, alone."""

    def transfer(
        lens: lm.Lens, distances: Array, _spectrum: Any, pixel: float, shape: tuple[int, int], _half: int
    ) -> NDArray[np.float32]:
        f = np.sqrt(squared_frequency(shape))
        down, across = (np.arange(side // 2 + 1) / side for side in shape)
        averaged = np.sinc(down)[:, None] * np.sinc(across)
        radii = lens.pupil(distances).geometric_radius() / pixel
        return np.array([window(float(radius), f) * averaged for radius in radii], dtype=np.float32)

    return transfer


def disc(radius: float, f: Array) -> Array:
    """Return the transfer function of a uniform disc."""
    from scipy.special import j1

    x = np.maximum(2.0 * math.pi * radius * f, 1e-9)
    return np.asarray(2.0 * j1(x) / x)


def gauss(radius: float, f: Array) -> Array:
    """Return the transfer function of a Gaussian of the second moment of the disc."""
    return np.asarray(np.exp(-0.5 * (math.pi * radius * f) ** 2))


MODELS: dict[str, Callable[..., NDArray[np.float32]]] = {
    "exact": pixel_transfer,
    "disc": imitated(disc),
    "Gaussian": imitated(gauss),
}


def solve(
    images: Sequence[Array], f_number: float, between: tuple[float, float] = BETWEEN, model: str = "exact"
) -> DefocusDepth:
    """Find the depth by one of the models, of 61 candidates."""
    return depth_from_defocus(
        images, pair(f_number), PIXEL, encoding="linear", noise=NOISE, between=between, window=WINDOW, candidates=61,
        transfer=MODELS[model],
    )  # fmt: skip


class Row(NamedTuple):
    """Of planes at one distance."""

    model: str
    f_number: float
    distance: float
    known: float
    bias: float
    std: float
    bound: float
    compared: float
    scatter: float

    def line(self) -> str:
        """Return a row of a table in Markdown; lengths in mm."""
        return (
            f"| f/{self.f_number:g} | {self.distance:g} m | {self.model} | {100 * self.known:.1f} % | "
            f"{1e3 * self.bias:+.2f} | {1e3 * self.std:.2f} | {1e3 * self.bound:.2f} | {self.std / self.bound:.2f} | "
            f"{self.std / self.compared:.2f} | {abs(self.bias) / self.bound:.2f} | {self.scatter:.2f} |"
        )


HEAD = """| stop | plane | PSF | known | bias | std | bound | std / bound | by comparison | bias / bound | std of z |
|---|---|---|---|---|---|---|---|---|---|---|"""


def planes(f_number: float, distance: float, model: str, draws: int) -> Row:
    """Return what comes of planes, `EDGE` pixels from their borders."""
    errors, deviations = [], []
    for seed in range(draws):
        found = solve(plane(f_number, distance, seed + int(1000 * distance)), f_number, model=model)
        inner = np.s_[EDGE:-EDGE, EDGE:-EDGE]
        errors.append((found.depth - distance)[inner])
        deviations.append(found.deviation[inner])
    e, d = np.array(errors), np.array(deviations)
    known = np.isfinite(d)
    given: Any = {"noise": NOISE, "contrast": CONTRAST, "window": WINDOW}
    bound, compared = (
        float(lm.depth_precision(pair(f_number), distance, PIXEL, known_texture=texture_known, **given))
        for texture_known in (True, False)
    )
    if not known.any():
        return Row(model, f_number, distance, 0.0, math.nan, math.nan, bound, compared, math.nan)
    e = e[known]
    return Row(
        model, f_number, distance, float(known.mean()), float(e.mean()), float(e.std()), bound, compared,
        float((e / d[known]).std()),
    )  # fmt: skip


def slope(side: int) -> list[str]:
    """Return lines about the slanted scene by each model, and about the sharp image."""
    images, depth, scene = slanted(side)
    lines = []
    inner = np.s_[EDGE:-EDGE, EDGE:-EDGE]
    for name in MODELS:
        found = solve(images, 2.8, BETWEEN_SLANTED, name)
        error, z = (found.depth - depth)[inner], ((found.depth - depth) / found.deviation)[inner]
        known = np.isfinite(z)
        rms, middle = np.sqrt(np.mean(error[known] ** 2)), np.median(np.abs(error[known]))
        sharp = 20.0 * np.log10(1.0 / (found.sharp - scene)[inner].std())
        lines.append(
            f"| {side} x {side} | {name} | {100 * known.mean():.1f} % | {1e3 * rms:.2f} | {1e3 * middle:.2f} | "
            f"{z[known].std():.2f} | {np.median(found.misfit[inner]):.2f} | {sharp:.1f} |"
        )
    best = max(20.0 * np.log10(1.0 / (image - scene)[inner].std()) for image in images)
    lines.append(f"| {side} x {side} | one average, by Wiener | | | | | | {_averaged(images, scene):.1f} |")
    lines.append(f"| {side} x {side} | better photograph as it is | | | | | | {best:.1f} |")
    return lines


def _averaged(images: Sequence[Array], scene: Array) -> float:
    """Return how near to the scene the best Wiener filter comes by the mean transfer function of the range."""
    near, far = BETWEEN_SLANTED
    distances = 1.0 / np.linspace(1.0 / far, 1.0 / near, 61)
    shape = scene.shape
    best = -math.inf
    h = np.array(
        [pixel_transfer(lens, distances, [(540e-9, 1.0)], PIXEL, shape, 64).mean(axis=0) for lens in pair(2.8)]
    )
    square = squared_frequency(shape)
    square[0, 0] = np.inf
    rows = np.minimum(np.arange(shape[0]), shape[0] - np.arange(shape[0]))
    inner = np.s_[EDGE:-EDGE, EDGE:-EDGE]
    spectra = [np.fft.rfft2(image) for image in images]
    for level in np.geomspace(0.01, 1e3, 26):
        ratio = level / square
        ratio[0, 0] = 1e30
        filters = ratio * h / (1.0 + ratio * (h * h).sum(axis=0))
        made = np.fft.irfft2(sum(one[rows] * part for one, part in zip(filters, spectra, strict=True)), s=shape)
        best = max(best, 20.0 * math.log10(1.0 / float((made - scene)[inner].std())))
    return best


def flat(f_number: float) -> str:
    """Return a line about a plane of which a half has no texture."""
    from scipy.signal import fftconvolve

    scene = texture(512, 5)
    scene[:, 256:] = 1.0
    images = []
    for k, lens in enumerate(pair(f_number)):
        spread = lm.psf(lens.pupil(1.6), 257, PIXEL, integrate=True, dtype=np.float64).values
        light = fftconvolve(scene - 1.0, spread, mode="same")[128:-128, 128:-128] + 1.0
        images.append(NOISE.record(ELECTRONS * np.maximum(light, 0.0), seed=k))
    found = solve(images, f_number)
    known = np.isfinite(found.deviation)
    return (
        f"f/{f_number:g}, half of it flat: depth is known at {100 * known[:, EDGE : 128 - EDGE].mean():.1f} % of the "
        f"texture and {100 * known[:, 128 + EDGE :].mean():.2f} % of the flat half"
    )


def seconds(f_number: float, turns: int = 3) -> float:
    """Return the CPU time a pixel, of 512 x 512 and 61 candidates, all in; the best of several."""
    images = plane(f_number, 1.55, 9, side=512)
    times = []
    for _ in range(turns):
        start = time.process_time()
        solve(images, f_number)
        times.append(time.process_time() - start)
    return min(times) / images[0].size


def main() -> None:
    """Run all and print tables in Markdown."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--draws", type=int, default=4, help="textures of each plane")
    options = parser.parse_args()
    print(HEAD)
    for f_number in (8.0, 2.8):
        for model in MODELS:
            for distance in DISTANCES:
                print(planes(f_number, distance, model, options.draws).line(), flush=True)
    print("\n| slanted, f/2.8 | PSF | known | rms (mm) | median (mm) | std of z | misfit | sharp, dB |")
    print("|---|---|---|---|---|---|---|---|")
    for side in (256, 512):
        print("\n".join(slope(side)), flush=True)
    print()
    for f_number in (8.0, 2.8):
        print(flat(f_number))
        print(f"f/{f_number:g}: {1e6 * seconds(f_number):.1f} us of CPU time a pixel, 61 candidates", flush=True)


if __name__ == "__main__":
    main()
