"""Deconvolution of a microscope's stack: time, memory and error, beside scikit-image's richardson_lucy.

`python benchmarks/deconvolution.py` measures a stack of 64 x 512 x 512 float32 with a PSF of 64 x 65 x 65 (time of a
step in CPU seconds, memory above the stack). Then it restores beads of known photons on a background, 20 um deep in
water under oil, each blurred by the PSF of its own depth: with PSFs by depth, with one PSF, and with other packages.
`--small` takes less, `--only` speed or error one of both.
"""

from __future__ import annotations

import argparse
import itertools
import json
import os
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

os.environ.setdefault("OMP_NUM_THREADS", "1")

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter
from scipy.signal import oaconvolve
from scipy.sparse import csr_matrix
from scipy.special import jv

import lommel as lm
from lommel.microscopy.deconvolution import DeconvolveOptions, Tuning, run
from lommel.microscopy.depth_model import DepthModel, usual_window

Array = NDArray[np.float64]

OIL = lm.Objective(
    NA=1.4,
    magnification=60,
    immersion=1.515,
    working_distance=0.2e-3,
    coverslip=lm.Layer(1.5255, 170e-6),
    sample=1.33,
)
WAVE, PIXEL, BACKGROUND = 520e-9, 6.5e-6, 20.0


def psf(depth: float, planes: int, side: int, step: float, first: int | None = None) -> lm.PSF:
    """Return a PSF, whose plane `first`, by default the middle one, is the brightest."""
    z = (np.arange(planes) - (planes // 2 if first is None else first)) * step
    return lm.psf(OIL.pupil(depth=depth, z=z, wavelength=WAVE), side, PIXEL, tol=1e-4)


def most() -> float:
    """Return the most memory that this process ever had, megabytes; NaN where there is no /proc."""
    status = Path("/proc/self/status")
    if not status.exists():
        return float("nan")
    return next(int(line.split()[1]) for line in status.read_text().splitlines() if line.startswith("VmHWM")) / 1024


def speed(shape: tuple[int, int, int], turns: int) -> dict[str, float]:
    """Return CPU seconds of a step and memory, and the same of scikit-image, in turns: the least of each."""
    from skimage.restoration import richardson_lucy

    kernel = psf(5e-6, shape[0], 65, 0.2e-6)
    stack = np.random.default_rng(0).poisson(50.0, shape).astype(np.float32)
    stack[shape[0] // 2, 20::40, 20::40] += 5000.0
    noise, way = lm.Noise(read=1.0), lm.imaging.RichardsonLucy(steps=5, target=0.0)
    plain = (kernel.values / kernel.values.sum()).astype(np.float32)
    scaled, memory = stack / stack.max(), 0.0
    marks: list[float] = []
    ours, theirs = [], []

    def mark(_: float, message: str) -> None:
        if message.startswith("step"):
            marks.append(time.process_time())

    for turn in range(turns):
        before = most()
        marks.clear()
        lm.microscopy.deconvolve(stack, kernel, noise=noise, method=way, progress=mark)
        memory = memory if turn else most() - before
        ours.append(float(np.diff(marks).min()))
        spent = []
        for count in (1, 3):
            begun = time.process_time()
            richardson_lucy(scaled, plain, num_iter=count, clip=False)
            spent.append(time.process_time() - begun)
        theirs.append((spent[1] - spent[0]) / 2.0)
    return {
        "CPU seconds a step": min(ours),
        "of scikit-image": min(theirs),
        "ratio": min(ours) / min(theirs),
        "CPU seconds of 30 steps": 30.0 * min(ours),
        "memory above the stack, MB": memory,
    }


class Quadrature:
    """PSFs of the same microscope by plain quadrature, which shares no code with the package."""

    def __init__(self, side: int, parts: int = 5) -> None:
        glass, self._k = 1.5255, 2.0 * np.pi / WAVE
        pixel, self._side = PIXEL / OIL.magnification, side
        x, w = np.polynomial.legendre.leggauss(500)
        cosine, below = 0.5 * (x + 1.0), 0.5 * w
        edge = np.sqrt((OIL.NA / OIL.sample) ** 2 - 1.0)  # supercritical light
        x, w = np.polynomial.legendre.leggauss(120)
        beyond, above = 0.5 * edge * (x + 1.0), 0.5 * edge * w
        self._sample = np.concatenate([cosine + 0j, 1j * beyond])
        sine = OIL.sample * np.sqrt(1.0 - self._sample**2).real
        weight = np.concatenate([below * cosine, above * beyond])
        inside, self._oil = (np.sqrt(1.0 - (sine / n) ** 2 + 0j) for n in (glass, OIL.immersion))
        media = [(OIL.immersion, self._oil), (glass, inside), (OIL.sample, self._sample)]
        s_wave, p_wave = np.ones(len(sine), complex), np.ones(len(sine), complex)
        for (n, c), (m, d) in itertools.pairwise(media):
            s_wave *= 2.0 * n * c / (n * c + m * d)
            p_wave *= 2.0 * n * c / (m * c + n * d)
        self._weight = weight
        both = p_wave * self._sample
        shared = weight / np.sqrt(self._oil)
        amplitudes = (shared * (s_wave + both), shared * p_wave * sine / OIL.sample, shared * (s_wave - both))
        points = (np.arange(side * parts) - side * parts // 2) * pixel / parts
        apart = 15e-9
        radii = np.arange(int(-points[0] * np.sqrt(2.0) / apart) + 3) * apart
        self._terms = [
            (amount, jv(order, self._k * radii[:, np.newaxis] * sine), f)
            for order, amount, f in zip(range(3), (1.0, 2.0, 1.0), amplitudes, strict=True)
        ]
        # Averages over pixels, of profiles that are interpolated.
        place = np.hypot(points, points[:, np.newaxis]) / apart
        first = place.astype(int)
        own = np.arange(side * parts) // parts
        pixels = (own[:, np.newaxis] * side + own).ravel()
        shares = np.concatenate([(1.0 - place + first).ravel(), (place - first).ravel()]) / parts**2
        places = np.tile(pixels, 2), np.concatenate([first.ravel(), first.ravel() + 1])
        self._pixels = csr_matrix((shares, places), shape=(side**2, len(radii)))

    def _waves(self, depth: float, stage: Array) -> NDArray[np.complex128]:
        phase = depth * OIL.sample * self._sample[:, np.newaxis] - OIL.immersion * self._oil[:, np.newaxis] * stage
        return np.exp(1j * self._k * phase)

    def psf(self, depth: float, stage: Array) -> Array:
        """Return planes, the stage having moved so far since the glass was in focus."""
        waves = self._waves(depth, stage)
        light = 0.0
        for amount, bessel, amplitude in self._terms:
            f = amplitude[:, np.newaxis] * waves
            light = light + amount * ((bessel @ f.real) ** 2 + (bessel @ f.imag) ** 2)
        return np.asarray((self._pixels @ light).T.reshape(-1, self._side, self._side))

    def collected(self, depth: float) -> float:
        """Return the light in a whole plane, by Parseval's theorem, a pixel."""
        share = np.exp(-2.0 * self._k * depth * OIL.sample * self._sample.imag)
        light = sum(
            amount * float((np.abs(amplitude / self._weight) ** 2 * share * self._weight).sum())
            for amount, _, amplitude in self._terms
        )
        return light * 2.0 * np.pi / (self._k * OIL.sample * PIXEL / OIL.magnification) ** 2

    def brightest(self, depth: float) -> float:
        """Return the movement of the stage at which an emitter is brightest."""
        stage = depth * OIL.immersion / OIL.sample + np.linspace(-0.05, 0.3, 4001) * max(depth, 2e-6)
        return float(stage[(np.abs(self._terms[0][2] @ self._waves(depth, stage)) ** 2).argmax()])


def deep(planes: int, side: int, step: float, beads: int, threads: int) -> dict[str, dict[str, float]]:
    """Return errors of restored beads and filaments, 0 to 20 um deep, and how they were reached.

    The error is rms, over that of an empty stack, once both were smoothed to a resolution of 250 x 250 x 750 nm.
    """
    rng, begin, depths = np.random.default_rng(1), -0.8e-6, np.linspace(0.0, 20e-6, 101)
    emitters = np.zeros((len(depths), side, side))
    for _ in range(beads):
        at = rng.integers([2, 8, 8], [len(depths) - 2, side - 8, side - 8])
        emitters[tuple(at)] += 1e5 * rng.uniform(0.4, 1.0)
    along = np.linspace(0.0, 1.0, 2000)
    for _ in range(3):  # filaments, from the glass to 20 um
        ends, bend = rng.uniform(8, side - 8, (2, 2)), rng.uniform(-8, 8, 2)
        line = ends[0] + np.outer(along, ends[1] - ends[0]) + np.outer(np.sin(np.pi * along), bend)
        level = np.rint((0.025 + 0.95 * along) * (len(depths) - 1)).astype(int)
        np.add.at(emitters, (level, *np.clip(np.rint(line).astype(int), 0, side - 1).T), 150.0)
    optics, stage = Quadrature(2 * side + 1), begin + step * np.arange(planes)
    best = np.array([optics.brightest(float(depth)) for depth in depths])
    middle = float(np.interp(stage[planes // 2], np.maximum.accumulate(best), depths))
    window = usual_window(OIL, WAVE, PIXEL, step, (planes, side, side))
    widths = 0.32e-6 / step, 1.0, 1.0  # of the resolution, standard deviations
    truth, image = np.zeros((planes, side, side)), np.full((planes, side, side), BACKGROUND)
    for each, depth, focus in zip(emitters, depths, best, strict=True):
        if not each.any():
            continue
        psfs = optics.psf(float(depth), stage) / optics.collected(float(depth))
        image += np.maximum(oaconvolve(each[np.newaxis], psfs, axes=(1, 2))[:, side : 2 * side, side : 2 * side], 0.0)
        place = (focus - begin) / step
        # Of all planes of a PSF, at this resolution along z: depths are between planes, too.
        along = np.exp(-0.5 * np.square((np.arange(planes) - place) / widths[0])) / (widths[0] * np.sqrt(2.0 * np.pi))
        truth += window[0] * along[:, np.newaxis, np.newaxis] * each
    camera = lm.Noise(white=0.46, read=1.6, offset=100.0)
    stack = np.clip(np.rint(camera.record(image, seed=2)), 0, 65535).astype(np.uint16)
    light = np.maximum(camera.electrons(stack), 0.0)
    smooth = gaussian_filter(truth, (0.0, *widths[1:]))

    def error(values: Array, depth: float | None = None, *, scaled: bool = False) -> float:
        # Restored light is spread over voxels as B-splines already, of a variance of (degree + 1) / 12.
        splines = (0, 0) if depth is None else DepthModel(OIL, WAVE, PIXEL, step, depth, planes, window).splines
        spread = [(degree + 1) / 12.0 if degree else 0.0 for degree in (splines[0], splines[1], splines[1])]
        left = np.sqrt(np.square(widths) - spread)
        found = gaussian_filter(np.asarray(values, np.float64) - BACKGROUND, left)
        if scaled:
            found *= (found * smooth).sum() / (found**2).sum()
        return float(np.sqrt(((found - smooth) ** 2).sum() / (smooth**2).sum()))

    given: dict[str, Any] = {"pixel": PIXEL, "step": step, "wavelength": WAVE}
    given |= {"direction": "up", "diagnosis": False}
    found, most = {"recording": {"error": error(light)}}, 1
    for name, depth in (
        ("PSFs by depth", middle),
        ("one PSF", middle),
        ("one PSF, as many steps", middle),
        ("one PSF, of the glass", 0.0),
    ):
        method = lm.imaging.RichardsonLucy(steps=most, target=0.0) if "many" in name else None
        options = DeconvolveOptions(method=method, depth=depth, **given)
        made = run(stack, OIL, camera, options, Tuning(slabs=1 if "one" in name else None, threads=threads))
        (channel,) = made.channels
        most = max(most, channel.steps)
        found[name] = {
            "error": error(0.46 * (np.asarray(made.values) + channel.background), depth),
            "steps": channel.steps,
            "discrepancy": channel.discrepancy,
            "PSFs": len(channel.psf_depths),
        }
    kernel = psf(middle, *window, step).values
    for name, method in _others().items():
        # The best of several numbers of steps, and the best scale, which only the ground truth tells: these packages
        # restore light in the window of the PSF alone.
        whole = kernel / kernel.sum(dtype=np.float64)
        tried = {steps: error(method(light, whole, steps), scaled=True) for steps in (30, 100)}
        steps = min(tried, key=lambda count: tried[count])
        found[name] = {"error": tried[steps], "steps": steps}
    return found


def _others() -> dict[str, Callable[[Array, Array, int], Array]]:
    """Return other packages that are installed, as functions of a stack, a PSF and a number of steps.

    RedLionfish computes by SciPy. clij2-fft computes by OpenCL, for which PoCL takes the processor; its library must
    be on LD_LIBRARY_PATH.
    """
    from skimage.restoration import richardson_lucy

    def scikit(light: Array, kernel: Array, steps: int) -> Array:
        return np.asarray(light.max() * richardson_lucy(light / light.max(), kernel, num_iter=steps, clip=False))

    found: dict[str, Callable[[Array, Array, int], Array]] = {"scikit-image": scikit}
    try:
        from RedLionfishDeconv import doRLDeconvolutionFromNpArrays
    except ImportError:
        pass
    else:

        def lionfish(light: Array, kernel: Array, steps: int) -> Array:
            made = doRLDeconvolutionFromNpArrays(
                light.astype(np.float32), kernel.astype(np.float32), niter=steps, method="cpu", resAsUint8=False
            )
            return np.asarray(made)

        found["RedLionfish"] = lionfish
    try:
        from clij2fft.richardson_lucy import richardson_lucy_nc

        richardson_lucy_nc(np.ones((8, 8, 8)), np.ones((1, 1, 1)), 1)
    except (ImportError, OSError):
        return found

    def clij2(weight: float) -> Callable[[Array, Array, int], Array]:
        def run(light: Array, kernel: Array, steps: int) -> Array:
            return np.asarray(richardson_lucy_nc(light, kernel, steps, weight), np.float64)

        return run

    names = {"clij2-fft": 0.0} | {f"clij2-fft, total variation {weight}": weight for weight in (0.0005, 0.002)}
    return found | {name: clij2(weight) for name, weight in names.items()}


def main() -> None:
    """Measure, and print as JSON."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--small", action="store_true", help="a stack of 32 x 128 x 128, fewer steps")
    parser.add_argument("--only", choices=("speed", "error"), help="one of both parts")
    options = parser.parse_args()
    small, found = options.small, {}
    if options.only != "error":
        found["speed"] = speed((32, 128, 128) if small else (64, 512, 512), 2 if small else 4)
    if options.only != "speed":
        found["error"] = deep(65, 32, 0.4e-6, 4, 1) if small else deep(65, 64, 0.4e-6, 10, 2)
    print(json.dumps(found, indent=2))


if __name__ == "__main__":
    main()
