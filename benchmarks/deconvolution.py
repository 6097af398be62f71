"""Deconvolution of a microscope's stack: time, memory and error, beside scikit-image's richardson_lucy.

`python benchmarks/deconvolution.py` measures a stack of 64 x 512 x 512 float32 with a PSF of 64 x 65 x 65 (time of a
step in CPU seconds, memory above the stack). Then it restores beads of known photons on a background, 20 um deep in
water under oil, each blurred by the PSF of its own depth: with PSFs by depth, with one PSF, and with scikit-image.
`--small` takes less.
"""

from __future__ import annotations

import argparse
import json
import os
import time
from pathlib import Path
from typing import Any

os.environ.setdefault("OMP_NUM_THREADS", "1")

import numpy as np
from numpy.typing import NDArray

import lommel as lm
from lommel.microscopy.depth_model import usual_window

Array = NDArray[np.float64]

OIL = lm.Objective(
    NA=1.4,
    magnification=60,
    immersion=1.515,
    working_distance=0.2e-3,
    coverslip=lm.Layer(1.5255, 170e-6),
    sample=1.33,
)
WAVE, PIXEL = 520e-9, 6.5e-6


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


def speed(shape: tuple[int, int, int], steps: int) -> dict[str, float]:
    """Return CPU seconds of a step and memory, and the same of scikit-image, in turns."""
    from skimage.restoration import richardson_lucy

    kernel = psf(5e-6, shape[0], 65, 0.2e-6)
    stack = np.random.default_rng(0).poisson(50.0, shape).astype(np.float32)
    stack[shape[0] // 2, 20::40, 20::40] += 5000.0
    noise, before = lm.Noise(read=1.0), most()
    marks: list[float] = []
    way = lm.imaging.RichardsonLucy(steps=steps, target=0.0)
    lm.microscopy.deconvolve(stack, kernel, noise, method=way, progress=lambda *_: marks.append(time.process_time()))
    memory = most() - before
    plain = (kernel.values / kernel.values.sum()).astype(np.float32)
    scaled, spent = stack / stack.max(), []
    for count in (1, 3):
        begun = time.process_time()
        richardson_lucy(scaled, plain, num_iter=count, clip=False)
        spent.append(time.process_time() - begun)
    ours, theirs = float(np.median(np.diff(marks))), (spent[1] - spent[0]) / 2.0
    return {
        "CPU seconds a step": ours,
        "of scikit-image": theirs,
        "ratio": ours / theirs,
        "CPU seconds of 30 steps": 30.0 * ours,
        "memory above the stack, MB": memory,
    }


def deep(planes: int, side: int, steps: int) -> dict[str, float]:
    """Return errors of restored beads, in cubes of 3 voxels, over the light of the beads."""
    from skimage.restoration import richardson_lucy

    step, middle, rng = 0.6e-6, 20e-6, np.random.default_rng(1)
    table = np.linspace(0.0, 2.5 * middle, 200)
    focus = np.maximum.accumulate(np.asarray(OIL.focus(table, wavelength=WAVE).brightest))
    offset = float(np.interp(middle, table, focus))
    window = usual_window(OIL, WAVE, PIXEL, step, (planes, side, side))
    truth, image = np.zeros((planes, side, side)), np.full((planes, side, side), 20.0)
    for _ in range(12):
        plane, row, column = (int(n) for n in rng.integers([3, 6, 6], [planes - 3, side - 6, side - 6]))
        photons = float(rng.uniform(1e5, 5e5))
        at = float(np.interp(offset + (plane - planes // 2) * step, focus, table))
        around = psf(at, planes, 2 * side + 1, step, plane).values.astype(np.float64)
        rows, columns = (slice(side - k, 2 * side - k) for k in (row, column))
        image += photons / planes * around[:, rows, columns]
        # Light beyond the windows of the PSFs is no part of what any of them restores.
        truth[plane, row, column] += photons / planes * float(psf(at, *window, step).values.sum(dtype=np.float64))
    camera = lm.Noise(white=0.46, read=1.6, offset=100.0)
    stack = camera.record(image, seed=2)
    given: dict[str, Any] = {"pixel": PIXEL, "step": step, "wavelength": WAVE, "depth": middle, "noise": camera}
    given |= {"direction": "up", "method": lm.imaging.RichardsonLucy(steps=steps, target=0.0)}
    found = {}
    for name, slabs in (("PSFs by depth", None), ("one PSF", 1)):
        found[name] = 0.46 * np.asarray(lm.microscopy.restore(stack, OIL, slabs=slabs, **given).values)
    kernel = psf(middle, *window, step).values
    light = np.maximum(camera.electrons(stack), 0.0)
    found["scikit-image"] = light.max() * richardson_lucy(
        light / light.max(), kernel / kernel.sum(), num_iter=steps, clip=False
    )
    cubes = _cubes(truth)
    return {
        name: float(np.abs(_cubes(values - 20.0) - cubes)[cubes > 0.0].sum() / cubes.sum())
        for name, values in found.items()
    }


def _cubes(values: Array) -> Array:
    planes, height, width = (n // 3 for n in values.shape)
    cut = values[: 3 * planes, : 3 * height, : 3 * width]
    return np.asarray(cut.reshape(planes, 3, height, 3, width, 3).sum(axis=(1, 3, 5)))


def main() -> None:
    """Measure, and print as JSON."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--small", action="store_true", help="a stack of 32 x 128 x 128, fewer steps")
    small = parser.parse_args().small
    found = {
        "speed": speed((32, 128, 128) if small else (64, 512, 512), 4 if small else 8),
        "error": deep(16, 40, 20) if small else deep(32, 64, 60),
    }
    print(json.dumps(found, indent=2))


if __name__ == "__main__":
    main()
