"""Restored photographs: how much nearer to the scene, by which blur and method, and at what cost.

A crop of the motorcycle (Middlebury 2014, as scikit-image has it), grey: 35 mm f/2 focused at 2.2 m, pixels of 6 um,
540 nm, 5000 electrons at white, read noise 3. The photograph is made of the whole scene, with windows that hold more
light than those that restore it, and cropped, so that light of what is not seen comes in; then noise is drawn.
`python benchmarks/restoration.py --help` has the options. PSNR is that of sRGB, less 16 pixels at the edges.
"""

from __future__ import annotations

import argparse
import copy
import os
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

os.environ.setdefault("OMP_NUM_THREADS", "1")

import numpy as np
from numpy.typing import NDArray
from scipy.special import erf

import lommel as lm
from lommel.base.encoding import from_light, to_light
from lommel.deconvolve.iterations import iterated
from lommel.deconvolve.likelihood import PhotographLikelihood
from lommel.imaging import DepthBlur, LinearBlur, Occlusion, RichardsonLucy, TotalVariation, restore
from lommel.io.depth_maps import fill_missing

Array = NDArray[np.float64]

LENS = lm.Lens(focal_length=35e-3, f_number=2.0, focus_distance=2.2, wavelength=540e-9)
PIXEL, WHITE, EDGE, CROP = 6e-6, 5000.0, 16, np.s_[60:380, 200:600]
NOISE = lm.Noise(white=WHITE, read=3.0)
METHODS = {"Richardson-Lucy": RichardsonLucy(), "total variation": TotalVariation()}
PSFS = ("exact", "disc", "Gaussian", "one average")


class Scene(NamedTuple):
    """Sharp light and depth, metres, and the lens before it."""

    light: Array
    depth: Array
    lens: lm.Lens

    @classmethod
    def motorcycle(cls, lens: lm.Lens) -> Scene:
        """Return the whole scene; `examples/motorcycle.py` says where its figures come from."""
        from skimage.data import stereo_motorcycle

        left, _, disparity = stereo_motorcycle()
        known = np.isfinite(disparity)
        depth = np.where(known, 994.978 * 0.193001 / (np.where(known, disparity, 1.0) + 31.086), np.nan)
        light = to_light("left", left, "srgb", np.float64) @ [0.2126, 0.7152, 0.0722]
        return cls(light, np.asarray(fill_missing(depth, "nearest")), lens)

    def photograph(self, occlusion: bool, seed: int) -> Array:
        """Return the crop as a sensor records it."""
        blur = DepthBlur(self.depth, self.lens, PIXEL, energy=0.995, dtype=np.float64, threads=1)
        seen = (Occlusion(blur) if occlusion else blur).forward(self.light)
        return NOISE.record(np.maximum(WHITE * seen, 0.0), seed)[CROP]


def psnr(light: Array, truth: Array) -> float:
    """Return the ratio of peak and noise of sRGB, decibels."""
    one, other = (from_light(np.clip(part, 0.0, 1.0), "srgb", np.float64) for part in (light, truth))
    return float(-10.0 * np.log10(np.mean((one - other)[EDGE:-EDGE, EDGE:-EDGE] ** 2)))


def imitated(blur: DepthBlur, kind: str) -> DepthBlur:
    """Return the same operator with other PSFs: discs, Gaussians of their second moment, or the average for all."""
    if kind == "exact":
        return blur
    bank = blur.banks[0]
    side, middle = 2 * bank.half + 1, bank.half
    defocus = bank.start + bank.spacing * np.arange(bank.count)
    cones = lm.Pupil(lm.Wavefront(defocus), wavelength=LENS.wavelength, f_number=LENS.working_f_number)
    cuts = bank.cuts
    if kind == "disc":
        kernels = lm.psf(cones, side, PIXEL, method="geometric", dtype=np.float64).values
    elif kind == "Gaussian":
        width = np.maximum(cones.geometric_radius() / 2.0, 1e-3 * PIXEL)
        edges = (np.arange(side + 1) - middle - 0.5) * PIXEL
        share = np.diff(0.5 * erf(edges / (np.sqrt(2.0) * width[:, None])), axis=1)
        kernels = share[:, :, None] * share[:, None, :]
    else:
        kernels = np.broadcast_to(average(blur), (bank.count, side, side))
        cuts = np.full_like(cuts, middle)
    other = copy.copy(blur)
    other.banks = (bank.with_kernels(kernels, cuts),)
    return other


def average(blur: DepthBlur) -> Array:
    """Return the mean PSF of all points, from some of them."""
    points = np.random.default_rng(0).choice(blur.defocus.ravel(), 500)
    return np.mean([blur.banks[0].window(float(point)) for point in points], axis=0)


def operator(scene: Scene, occlusion: bool, kind: str = "exact", scale: float = 1.0) -> LinearBlur:
    """Return the blur of the crop, of depths times a scale."""
    blur = imitated(DepthBlur(scale * scene.depth[CROP], scene.lens, PIXEL, threads=1), kind)
    # One PSF for all hides nothing.
    return Occlusion(blur) if occlusion and kind != "one average" else blur


def pictures(scene: Scene, occlusion: bool, seeds: range) -> Iterator[str]:
    """Yield rows of a table: PSNR of every method and kind of PSF, each where it stops by itself."""
    truth = scene.light[CROP]
    photos = [scene.photograph(occlusion, seed) for seed in seeds]
    light = "occluded" if occlusion else "added"
    yield f"| {light} | photograph | | {_mean(psnr(y, truth) for y in photos)} | | |"
    for kind in PSFS:
        blur = operator(scene, occlusion, kind)
        for name, method in METHODS.items():
            found = [restore(y, None, blur, encoding="linear", noise=NOISE, method=method) for y in photos]
            quality = f"{_mean(psnr(f.light, truth) for f in found)} | {_mean(f.discrepancy for f in found)}"
            yield f"| {light} | {kind} | {name} | {quality} | {found[0].stopped.split(':')[0]}, {found[0].steps} |"


def _mean(values: Any) -> str:
    """Return a mean, and the extremes where they differ."""
    found = list(values)
    spread = f" ({min(found):.2f} to {max(found):.2f})" if len(found) > 1 else ""
    return f"{np.mean(found):.2f}{spread}"


def peer(photo: Array, truth: Array, psf: Array, most: int) -> tuple[float, int, float]:
    """Return the best PSNR of scikit-image over the number of its steps, that number, and the PSNR of its default."""
    from skimage.restoration import richardson_lucy

    image = np.clip(photo, 0.0, 1.0).astype(np.float32)
    found = [psnr(richardson_lucy(image, psf.astype(np.float32), num_iter=n), truth) for n in range(1, most + 1)]
    default = psnr(richardson_lucy(image, psf.astype(np.float32)), truth)
    return max(found), int(np.argmax(found)) + 1, default


def odd(scene: Scene) -> Iterator[str]:
    """Yield what is said of wrong depths, and of images that are dark, saturated or have holes."""
    truth = scene.light[CROP]
    photo = scene.photograph(True, 1)
    for scale in (0.95, 0.98, 1.02, 1.05):
        for name, method in METHODS.items():
            found = restore(
                photo, None, operator(scene, True, scale=scale), encoding="linear", noise=NOISE, method=method
            )
            quality = f"{found.discrepancy:.2f} | {psnr(found.light, truth):.2f}"
            yield f"| depth x {scale} | {name} | {quality} | {found.stopped} |"
    holes = photo.copy()
    holes[100:130, 150:200] = np.nan
    for said, image in (("black", 0.0 * photo), ("a third is saturated", photo), ("a hole of 30 x 50", holes)):
        limit = float(np.quantile(photo, 2 / 3)) if "third" in said else np.inf
        for name, method in METHODS.items():
            found = restore(
                image, None, operator(scene, True), encoding="linear", noise=NOISE, method=method, saturation=limit
            )
            finite = "finite" if np.isfinite(found.light).all() else "NOT FINITE"
            yield f"| {said} | {name} | {found.discrepancy:.2f} | {finite} | {found.stopped} |"


def cost(scene: Scene, rounds: int) -> Iterator[str]:
    """Yield the CPU time of a step over one of scikit-image, in neighbouring turns of one thread."""
    from skimage.restoration import richardson_lucy

    image = np.clip(scene.light, 0.02, 1.0).astype(np.float32)
    psf = np.full((27, 27), 1.0 / 27**2, np.float32)
    steps, method = 8, RichardsonLucy(steps=8, target=0.0)
    blur = DepthBlur(scene.depth, scene.lens, PIXEL, threads=1)
    largest = 2 * blur.banks[0].half + 1
    for name, one in (("DepthBlur", blur), ("Occlusion", Occlusion(blur))):
        observed = PhotographLikelihood(one, image, NOISE)

        def mine(observed: PhotographLikelihood = observed) -> Any:
            return iterated(method, observed, lambda *_: None)

        mine()
        ratios, times = [], []
        for _ in range(rounds):
            seconds = []
            for call in (mine, lambda: richardson_lucy(image, psf, num_iter=steps)):
                start = time.thread_time()
                call()
                seconds.append((time.thread_time() - start) / steps)
            ratios.append(seconds[0] / seconds[1])
            times.append(seconds)
        ours, theirs = 1e3 * np.median(times, axis=0)
        yield f"| {name}, windows up to {largest}² | {ours:.1f} ms | {theirs:.1f} ms | {np.median(ratios):.2f} |"


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seeds", type=int, default=3, help="Noises that are drawn.")
    parser.add_argument("--most", type=int, default=60, help="Steps of scikit-image that are tried.")
    parser.add_argument("--waves", type=float, default=0.0, help="Of spherical aberration, W040, of the lens.")
    parser.add_argument("--rounds", type=int, default=9, help="Of the race.")
    parser.add_argument("--only", choices=["pictures", "peer", "odd", "cost"])
    given = parser.parse_args()
    scene = Scene.motorcycle(replace(LENS, aberrations=lm.Wavefront.from_seidel(W040=given.waves)))

    def table(key: str, head: str, rows: Callable[[], Iterator[str]]) -> None:
        if given.only in (None, key):
            print(f"{head}\n{'|---' * (head.count('|') - 1)}|", flush=True)
            for row in rows():
                print(row, flush=True)
            print()

    def pairs() -> Iterator[str]:
        for occlusion in (False, True):
            yield from pictures(scene, occlusion, range(1, given.seeds + 1))

    def best() -> Iterator[str]:
        psf = average(DepthBlur(scene.depth[CROP], scene.lens, PIXEL, threads=1))
        for occlusion in (False, True):
            photo = scene.photograph(occlusion, 1)
            found, steps, default = peer(photo, scene.light[CROP], psf, given.most)
            yield f"| {'seen' if occlusion else 'added'} | {found:.2f} | {steps} | {default:.2f} |"

    table("pictures", "| light | PSF | method | PSNR (dB) | discrepancy | stopped, steps |", pairs)
    table("peer", "| light | best of scikit-image (dB) | at step | by its default, 50 |", best)
    table("odd", "| what is odd | method | discrepancy | PSNR (dB) | stopped |", lambda: odd(scene))
    table("cost", "| one step, 500 x 741 | lommel | scikit-image, 27² | ratio |", lambda: cost(scene, given.rounds))


if __name__ == "__main__":
    sys.path[0] = str(Path(__file__).resolve().parent.parent)
    main()
