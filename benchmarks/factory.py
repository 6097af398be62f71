"""The making of training data: PSFs and blurred crops a second on one core: ``python -m benchmarks.factory``.

Each PSF has 31 by 31 pixels and random Zernike terms 4 to 11 (Noll) of 1 rad rms together. The FFT beside is the
usual one, 64 points over the pupil and 128 in all, in single precision; its pixels are samples, and its error is that
of these. Crops are 512 by 512 RGB of a lens over its field at random places, with and without a depth map, and with
noise; the windows of the whole field are made once before. Times are those of the processor, the least of several;
give one thread to the libraries, as by ``OPENBLAS_NUM_THREADS=1``.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from importlib.util import find_spec
from typing import Any

import numpy as np
from numpy.typing import NDArray

import lommel as lm
from benchmarks.differentiable import milliseconds

COUNT, SIDE, PIXEL, TERMS = 1000, 31, 0.5, range(4, 12)


def pupils(count: int) -> lm.Pupil:
    """Return pupils of the first of the random wavefronts."""
    c = np.random.default_rng(0).normal(size=(COUNT, len(TERMS)))
    c /= np.linalg.norm(c, axis=1, keepdims=True)
    return lm.Pupil(lm.Wavefront.zernike({j: c[:count, k] for k, j in enumerate(TERMS)}, order="noll"))


def by_fft(stack: lm.Pupil) -> Callable[[], NDArray[np.float32]]:
    """Return a function that makes the images by FFT; the phases are there already."""
    from scipy.fft import fft2, fftshift

    y, x = (np.mgrid[:64, :64] - 31.5) / 32.0
    inside = (x**2 + y**2 <= 1.0).ravel()
    peak = 0.25 * math.pi * PIXEL**2  # share of the light in a sample without aberrations
    field = np.zeros((COUNT, 64 * 64), dtype=np.complex64)
    field[:, inside] = stack.values(x.ravel()[inside], y.ravel()[inside])

    def run() -> NDArray[np.float32]:
        made = []
        for part in np.array_split(field.reshape(-1, 64, 64), COUNT // 50):
            light = np.abs(fft2(part, s=(128, 128), workers=1)) ** 2
            made.append(fftshift(light, axes=(-2, -1))[:, 49:80, 49:80] * (peak / inside.sum() ** 2))
        return np.concatenate(made).astype(np.float32)

    return run


def rows() -> list[tuple[str, float, float]]:
    """Return rows of PSFs: how, PSFs a second, and the largest error of 64 over the peak."""
    stack, few = pupils(COUNT), pupils(64)
    found = []
    for name, averaged in (("sampled", False), ("averaged", True)):
        exact = lm.psf(few, SIDE, PIXEL, tol=1e-8, integrate=averaged, dtype=np.float64).values
        plan = lm.Plan(SIDE, PIXEL, tol=1e-4, integrate=averaged, threads=1, dtype=np.float32)
        made = plan(stack).values[:64]
        found.append((f"lommel, {name}, tol 1e-4", _rate(lambda plan=plan: plan(stack)), _error(made, exact)))
    exact = lm.psf(few, SIDE, PIXEL, tol=1e-8, integrate=False, dtype=np.float64).values
    run = by_fft(stack)
    found.append(("FFT of 128 by 128, complex64, SciPy", _rate(run), _error(run()[:64], exact)))
    if find_spec("torch"):
        import torch

        torch.set_num_threads(1)
        function = lm.Plan(SIDE, PIXEL, tol=1e-4).traced(stack, torch, precision="float32")
        given = torch.tensor(np.array(stack.wavefront.edge), dtype=torch.float32)
        found.append(
            (
                "lommel in PyTorch, sampled",
                _rate(lambda: function(given)),
                _error(function(given)[:64].numpy(), exact),
            )
        )
    return found


def _rate(run: Callable[[], Any]) -> float:
    return 1e3 * COUNT / milliseconds(run, 5)


def _error(made: Any, exact: Any) -> float:
    return float((np.abs(made - exact).max(axis=(1, 2)) / exact.max(axis=(1, 2))).max())


def crops(depth: bool) -> tuple[float, float]:
    """Return how many crops a second are blurred and given noise, each of another place of one field, and the first.

    The second number is the seconds that the windows of the whole field take once: 2400 by 3200 pixels.
    """
    lens = lm.Lens(focal_length=25e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
    field = lm.FieldMap.from_seidel(8e-3, W131=1.5, W222=1.0, aperture=lens.pupil(2.0).unaberrated())
    draw, noise = np.random.default_rng(0), lm.Noise(white=5000, read=3.0)
    image = draw.random((512, 512, 3), dtype=np.float32)
    y, x = np.mgrid[:512, :512]
    metres = 1.0 / (0.5 + 0.1 * np.sin(x / 90.0) * np.cos(y / 70.0))
    begin = time.process_time()
    with_depth: dict[str, Any] = {}
    if depth:
        reach = np.full((2400, 3200), metres.min())
        reach[0] = metres.max()
        with_depth = {"depth": reach, "lens": lens}
    whole = lm.imaging.FieldBlur(
        field, (2400, 3200), 3.45e-6, channels=lm.imaging.RED_GREEN_BLUE, threads=1, **with_depth
    )
    once = time.process_time() - begin

    def run() -> None:
        row, column = draw.uniform(0.0, 1888.0), draw.uniform(0.0, 2688.0)
        blur = whole.crop(512, center=(1199.5 - row, 1599.5 - column), depth=metres if depth else None)
        noise.record(5000.0 * np.maximum(blur.forward(image), 0.0), draw)

    return 1e3 / milliseconds(run, 5), once


if __name__ == "__main__":
    for name, rate, error in rows():
        print(f"{name:40} {rate:9.0f} PSFs a second, off by {error:.0e} of the peak", flush=True)
    for depth in (False, True):
        rate, once = crops(depth)
        name = f"crops over the field{', with depth' if depth else ''}"
        print(f"{name}: {rate:.2f} a second, after {once:.2f} s for the windows", flush=True)
