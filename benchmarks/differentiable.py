"""Traced plans on a CPU beside the core and an FFT in JAX; training data: ``python -m benchmarks.differentiable``.

Times are those of the processor, the least of several, so that what else runs counts little; one thread where the
shell says so, as by ``taskset -c 0`` and ``OPENBLAS_NUM_THREADS=1``. ``--training`` measures the making of training
data instead. Its PSFs have 31 by 31 pixels and random Zernike terms 4 to 11 (Noll) of 1 rad rms together. The FFT
beside is the usual one, 64 points over the pupil and 128 in all, in single precision; its pixels are samples, and its
error is that of these. Crops are 512 by 512 RGB of a lens over its field at random places, with and without a depth
map, and with noise; the windows of the whole field are made once before.
"""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Callable
from importlib.util import find_spec
from typing import Any

import numpy as np
from numpy.typing import NDArray

import lommel as lm
from benchmarks.wavefronts import random_zernikes

COUNT, SIDE, PIXEL, REACH = 1000, 33, 0.5, 10.0


def milliseconds(run: Callable[[], Any], rounds: int = 7) -> float:
    """Return the least time of the processor that a call took, after a first one."""
    run()
    times = []
    for _ in range(rounds):
        begin = time.process_time()
        run()
        times.append(time.process_time() - begin)
    return 1e3 * min(times)


def coefficients() -> np.ndarray:
    """Return defocus and spherical aberration of as many pupils."""
    return np.random.default_rng(0).uniform(-1.0, 1.0, (COUNT, 2)) * [REACH, 1.0]


def by_fft(jnp: Any, c: Any) -> Any:
    """Return images by the FFT of 128 by 128 that users write, the pupil in 64, its edge grey."""
    y, x = jnp.meshgrid(*[(jnp.arange(64) - 31.5) / 32] * 2, indexing="ij")
    rho2 = x**2 + y**2
    amplitude = jnp.clip(0.5 + (1.0 - jnp.sqrt(rho2)) * 32, 0.0, 1.0)
    field = amplitude * jnp.exp(1j * (2 * c[..., 0, None, None] * rho2 + c[..., 1, None, None] * rho2**2))
    image = jnp.abs(jnp.fft.fftshift(jnp.fft.fft2(field, s=(128, 128)), axes=(-2, -1))) ** 2
    return image[..., 48:81, 48:81] / (128.0**2 * jnp.sum(amplitude**2))


def rows() -> list[tuple[str, float, float, float]]:
    """Return what was measured: its name, images, gradient, and the largest error over the peak."""
    import jax
    import jax.numpy as jnp

    c = coefficients()
    pupils = lm.Pupil(lm.Wavefront(c[:, 0], c[:, 1]))
    exact = lm.psf(pupils, SIDE, PIXEL, tol=1e-10).values
    core = lm.Plan(SIDE, PIXEL, threads=1)
    found = [("compiled core", milliseconds(lambda: core(pupils)), np.nan, _error(core(pupils).values, exact))]
    reach = lm.Pupil(lm.Wavefront([-REACH, REACH], [-1.0, 1.0]))
    makers: list[tuple[str, bool, Callable[[], Callable[..., Any]]]] = [
        ("traced, float64 inside", True, lambda: lm.Plan(SIDE, PIXEL).traced(reach, jnp)),
        ("traced, float32", False, lambda: lm.Plan(SIDE, PIXEL, tol=1e-3).traced(reach, jnp)),
        ("FFT of 128 by 128, complex64", False, lambda: lambda c: by_fft(jnp, c)),
    ]
    for name, double, make in makers:
        with jax.enable_x64(double):
            function, given = make(), jnp.asarray(c)
            weight = jnp.asarray(exact, dtype=jnp.float32)
            images = jax.jit(function)
            gradient = jax.jit(jax.grad(lambda c, w, of=function: jnp.sum(of(c) * w)))
            found.append(
                (
                    name,
                    milliseconds(lambda run=images, c=given: run(c).block_until_ready()),
                    milliseconds(lambda run=gradient, c=given, w=weight: run(c, w).block_until_ready()),
                    _error(np.asarray(images(given)), exact),
                )
            )
    found += _in_torch("traced, float32", lm.Plan(SIDE, PIXEL, tol=1e-3), reach, c, exact)
    pupils = random_zernikes(False)(1)[0]
    exact = lm.psf(pupils, SIDE, PIXEL, tol=1e-8).values
    core = lm.Plan(SIDE, PIXEL, method=lm.methods.ChordalGauss(1e-4), threads=1)
    found.append(
        (
            "fifteen terms: compiled core",
            milliseconds(lambda: core(pupils)),
            np.nan,
            _error(core(pupils).values, exact),
        )
    )
    with jax.enable_x64(False):
        images = jax.jit(lm.Plan(SIDE, PIXEL, tol=1e-4).traced(pupils, jnp))
        gradient = jax.jit(jax.grad(lambda c, w: jnp.sum(images(c) * w)))
        given, weight = jnp.asarray(pupils.wavefront.edge), jnp.asarray(exact, dtype=jnp.float32)
        times = [milliseconds(lambda: images(given).block_until_ready())]
        times.append(milliseconds(lambda: gradient(given, weight).block_until_ready()))
        found.append(("fifteen terms: traced, float32", *times, _error(np.asarray(images(given)), exact)))
    plan = lm.Plan(SIDE, PIXEL, tol=1e-4)
    return found + _in_torch("fifteen terms: traced, float32", plan, pupils, pupils.wavefront.edge, exact)


def _in_torch(name: str, plan: lm.Plan, reach: lm.Pupil, c: Any, exact: Any) -> list[tuple[str, float, float, float]]:
    """Return the row of a traced plan in PyTorch, uncompiled, where that is installed, for coefficients `c`."""
    if not find_spec("torch"):
        return []
    import torch

    torch.set_num_threads(1)
    function = plan.traced(reach, torch, precision="float32")
    given = torch.tensor(np.array(c), dtype=torch.float32)
    followed, weight = given.clone().requires_grad_(), torch.tensor(np.array(exact), dtype=torch.float32)

    def gradient() -> None:
        torch.autograd.grad((function(followed) * weight).sum(), followed)

    error = _error(function(given).numpy(), exact)
    return [(f"{name}, PyTorch", milliseconds(lambda: function(given)), milliseconds(gradient), error)]


def _error(images: Any, exact: Any) -> float:
    return float((np.abs(images - exact).max(axis=(1, 2)) / exact.max(axis=(1, 2))).max())


TERMS = {(2, 2): 1.0, (2, -2): 1.0, (3, 1): 1.0, (3, -1): 1.0, (4, 0): 1.0}


def blurs() -> list[tuple[str, float, float]]:
    """Return rows of the blur by depth: what was done, milliseconds, and these over the row that it is named after.

    512 by 512 RGB in float32, 25 mm f/4, 3.45 um, 1 to 4 m; the last row is 50 mm f/1.8, 12 um, 0.5 to 10 m, one
    channel, made.
    """
    lens = lm.Lens(focal_length=25e-3, f_number=4.0, focus_distance=1.6, wavelength=550e-9)
    draw, colours = np.random.default_rng(0), lm.imaging.RED_GREEN_BLUE
    image = draw.random((3, 512, 512)).astype(np.float32)
    depth = 1.0 / draw.uniform(0.26, 0.99, (512, 512))
    rows = np.ascontiguousarray(np.moveaxis(image, 0, -1))

    def compiled() -> Any:
        return lm.imaging.DepthBlur(depth, lens, 3.45e-6, channels=colours, threads=1).forward(rows)

    core = milliseconds(compiled, 3)
    found = [("DepthBlur, made and applied", core, 1.0)]
    if find_spec("torch"):
        import torch

        torch.set_num_threads(1)
        light, distance = torch.tensor(image), torch.tensor(depth, dtype=torch.float32)
        blur = lm.imaging.traced_blur(lens, [1.0, 4.0], 3.45e-6, torch, wavelengths=colours)
        plain = milliseconds(lambda: blur(light, distance), 3)
        found.append(("traced blur in PyTorch over DepthBlur", plain, plain / core))
        learned = lm.imaging.traced_blur(
            lens, [1.0, 4.0], 3.45e-6, torch, wavelengths=colours, focus_distances=(1.5, 1.7), zernike=TERMS
        )
        focus, terms = torch.tensor(1.6), torch.zeros(5)
        place = [part.clone().requires_grad_() for part in (light, distance, focus, terms)]

        def gradient() -> None:
            made = learned(place[0], place[1], focus_distance=place[2], zernike=place[3])
            torch.autograd.grad((made**2).sum(), place)

        forward = milliseconds(lambda: learned(light, distance, focus_distance=focus, zernike=terms), 3)
        found.append(("with focus and five Zernike terms over that without", forward, forward / plain))
        both = milliseconds(gradient, 3)
        found.append(("forward and backward over forward", both, both / forward))
        seen = milliseconds(lambda: blur(light, distance, occlusion=True), 1)
        found.append(("with occlusion over without", seen, seen / plain))
    fast = lm.Lens(focal_length=50e-3, f_number=1.8, focus_distance=2.0, wavelength=550e-9)
    begin = time.process_time()
    lm.imaging.traced_blur(fast, [0.5, 10.0], 12e-6)
    wide = 1e3 * (time.process_time() - begin)
    return [*found, ("0.5 to 10 m made, over DepthBlur of the rows above", wide, wide / core)]


TRAINED, NOLL = 31, range(4, 12)  # pixels along a side, and terms, of PSFs of training data


def pupils(count: int) -> lm.Pupil:
    """Return pupils of the first of the random wavefronts."""
    c = np.random.default_rng(0).normal(size=(COUNT, len(NOLL)))
    c /= np.linalg.norm(c, axis=1, keepdims=True)
    return lm.Pupil(lm.Wavefront.zernike({j: c[:count, k] for k, j in enumerate(NOLL)}, order="noll"))


def stack_by_fft(stack: lm.Pupil) -> Callable[[], NDArray[np.float32]]:
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


def training_rows() -> list[tuple[str, float, float]]:
    """Return rows of PSFs: how, PSFs a second, and the largest error of 64 over the peak."""
    stack, few = pupils(COUNT), pupils(64)
    found = []
    for name, averaged in (("sampled", False), ("averaged", True)):
        exact = lm.psf(few, TRAINED, PIXEL, tol=1e-8, integrate=averaged, dtype=np.float64).values
        plan = lm.Plan(TRAINED, PIXEL, tol=1e-4, integrate=averaged, threads=1, dtype=np.float32)
        made = plan(stack).values[:64]
        found.append((f"lommel, {name}, tol 1e-4", _rate(lambda plan=plan: plan(stack)), _error(made, exact)))
    exact = lm.psf(few, TRAINED, PIXEL, tol=1e-8, integrate=False, dtype=np.float64).values
    run = stack_by_fft(stack)
    found.append(("FFT of 128 by 128, complex64, SciPy", _rate(run), _error(run()[:64], exact)))
    if find_spec("torch"):
        import torch

        torch.set_num_threads(1)
        function = lm.Plan(TRAINED, PIXEL, tol=1e-4).traced(stack, torch, precision="float32")
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
    whole = lm.imaging.FieldBlur(field, (2400, 3200), 3.45e-6, channels=lm.imaging.RED_GREEN_BLUE, **with_depth)
    once = time.process_time() - begin

    def run() -> None:
        row, column = draw.uniform(0.0, 1888.0), draw.uniform(0.0, 2688.0)
        blur = whole.crop(512, center=(1199.5 - row, 1599.5 - column), depth=metres if depth else None)
        noise.record(5000.0 * np.maximum(blur.forward(image), 0.0), draw)

    return 1e3 / milliseconds(run, 5), once


def main() -> None:
    """Print the tables of training data, or all others."""
    if "--training" in sys.argv[1:]:
        for name, rate, error in training_rows():
            print(f"{name:40} {rate:9.0f} PSFs a second, off by {error:.0e} of the peak", flush=True)
        for depth in (False, True):
            rate, once = crops(depth)
            name = f"crops over the field{', with depth' if depth else ''}"
            print(f"{name}: {rate:.2f} a second, after {once:.2f} s for the windows", flush=True)
        return
    for name, taken, ratio in blurs():
        print(f"{name:52} {taken:8.1f} ms  ratio {ratio:6.2f}", flush=True)
    for name, images, gradient, error in rows():
        print(f"{name:37} {images:8.2f} ms  gradient {gradient:8.2f} ms  off by {error:.0e} of the peak")


if __name__ == "__main__":
    main()
