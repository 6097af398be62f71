"""Blur by depth: against one fixed kernel for the whole image, and against a PSF by an FFT for every point."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

import lommel as lm
from benchmarks.timing import Contender, Measured, Settings, Spread, race
from lommel.imaging import RED_GREEN_BLUE, DepthBlur, FocusPlan, Occlusion

TOL = 1e-4
HEIGHT, WIDTH, SIDE, PIXEL = 500, 741, 33, 6.6e-6
_THREADS = 2
_FRAMES = 30
_PATCH = 8  # side of what is judged, pixels
_PART = 300  # points whose PSF the FFT computes
_LENS = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=1.7, wavelength=550e-9)


@lru_cache(maxsize=1)
def scene() -> tuple[NDArray[np.float32], NDArray[np.float64]]:
    """Return light and depth: a floor, waves upon it, and boxes with edges; from sharp to windows of 33²."""
    image = np.random.default_rng(0).random((HEIGHT, WIDTH, 3)).astype(np.float32)
    y, x = np.mgrid[:HEIGHT, :WIDTH]
    depth = 1.0 + 0.9 * y / HEIGHT + 0.6 * (np.sin(x / 90) + 1) + 0.3 * ((x // 120 + y // 150) % 2)
    return image, depth


def _made() -> DepthBlur:
    return DepthBlur(scene()[1], _LENS, PIXEL, channels=RED_GREEN_BLUE, tol=TOL, threads=_THREADS)


@lru_cache(maxsize=1)
def _ready() -> DepthBlur:
    blur = _made()
    largest = 2 * max(bank.half for bank in blur.banks) + 1
    if largest != SIDE:
        raise AssertionError(f"the windows must be up to {SIDE}², got {largest}²")
    return blur


def photograph() -> Contender:
    """Return the blur of the scene, its windows made."""
    image, blur = scene()[0], _ready()
    return Contender("depth", lambda _: blur.forward(image), "DepthBlur.forward(image)")


def _fixed(channels: Sequence[int] = range(3)) -> Contender:
    from scipy.signal import oaconvolve

    planes = [np.ascontiguousarray(scene()[0][..., channel]) for channel in channels]
    kernel = np.full((SIDE, SIDE), 1.0 / SIDE**2, np.float32)
    what = "each float32 channel" if len(planes) > 1 else "a float32 channel"
    config = f"scipy.signal.oaconvolve of {what} with one fixed {SIDE}²"
    return Contender(
        "fixed",
        lambda _: [oaconvolve(plane, kernel, mode="same") for plane in planes],
        config,
        values=lambda _: np.empty(0),
    )


def _exact() -> NDArray[np.float64]:
    """Return a patch of the middle channel by the sum of exact windows."""
    image, depth = scene()
    bank, defocus = _ready().banks[1], _ready().defocus
    half = bank.half
    rows, columns = (slice(side // 2 - half, side // 2 + _PATCH + half) for side in (HEIGHT, WIDTH))
    total = np.zeros((_PATCH + 4 * half,) * 2)
    pupil = _LENS.pupil(depth[rows, columns].ravel())
    there = lm.Pupil(
        (_LENS.wavelength / RED_GREEN_BLUE[1]) * pupil.wavefront,
        wavelength=RED_GREEN_BLUE[1],
        f_number=_LENS.working_f_number,
    )
    windows = lm.psf(there, SIDE, PIXEL, integrate=True, dtype=np.float64).values.reshape(-1, SIDE, SIDE)
    wide = _PATCH + 2 * half
    for k, window in enumerate(windows):
        y, x = divmod(k, wide)
        at = rows.start + y, columns.start + x
        inside = window[SIDE // 2 - half : SIDE // 2 + half + 1, SIDE // 2 - half : SIDE // 2 + half + 1]
        inside = bank.pixel_weights(defocus[at]) * inside
        total[y : y + 2 * half + 1, x : x + 2 * half + 1] += image[at][1] * inside / inside.sum()
    return total[2 * half : 2 * half + _PATCH, 2 * half : 2 * half + _PATCH]


def _error(made: NDArray[Any]) -> float:
    patch = made[HEIGHT // 2 : HEIGHT // 2 + _PATCH, WIDTH // 2 : WIDTH // 2 + _PATCH, 1]
    exact = _exact()
    return float(np.abs(patch - exact).max() / exact.max())


def against_fixed(settings: Settings, *, bank: bool) -> Measured:
    """Measure the blur against one fixed kernel; `bank`: with the making of its windows."""
    image, blur = scene()[0], _ready()
    mine, other = photograph(), _fixed()
    if bank:
        mine = Contender("depth", lambda _: _made().forward(image), "DepthBlur(...).forward(image)")
    result = race([mine, other], settings.rounds)
    count = ", ".join(f"{b.count} windows" for b in blur.banks)
    cuts = [np.interp(b.positions(blur.defocus), np.arange(b.count), b.cuts) for b in blur.banks]
    mean = np.mean([np.mean((2.0 * np.ceil(cut) + 1.0) ** 2) for cut in cuts])
    note = (
        f"{mine.config}, {_THREADS} threads, {1e3 * result.median(mine.name):.0f} ms, {count}, {mean:.0f} pixels a "
        f"window in the mean. Against {other.config}, {1e3 * result.median(other.name):.0f} ms. Error over the "
        f"largest value of {_PATCH}² pixels, against the sum of exact windows"
    )
    return Measured(result.ratio(mine.name, other.name), _error(result.values[mine.name]), note)


def _by_fft(planes: NDArray[np.float32], defocus: NDArray[np.float64]) -> Any:
    """Return a function that computes the PSF of some points by an FFT each, and adds them."""
    from scipy.fft import fft2

    n = 64
    x = (np.arange(n) - n // 2) / (n // 4)
    squares = (x[:, None] ** 2 + x**2).astype(np.float32)
    inside = (squares <= 1.0).astype(np.float32)
    points = np.random.default_rng(1).choice(defocus.size, _PART, replace=False)
    out = np.zeros((HEIGHT + SIDE, WIDTH + SIDE), np.float32)
    half = SIDE // 2
    crop = np.r_[-half : half + 1]

    def run(_: Any) -> NDArray[np.float32]:
        for point in points:
            phase = (2.0 * defocus.flat[point]).astype(np.float32) * squares
            field = fft2(inside * np.exp(1j * phase).astype(np.complex64), workers=1, overwrite_x=True)
            window = (field.real**2 + field.imag**2)[crop[:, None], crop]
            y, x = divmod(int(point), WIDTH)
            out[y : y + SIDE, x : x + SIDE] += planes[y, x] / window.sum() * window
        return out

    return run


def against_points(settings: Settings) -> Measured:
    """Measure the blur against a PSF by an FFT of 64² for every point, from some of them."""
    image, blur = scene()[0], _ready()
    mine = Contender("depth", lambda _: blur.forward(image), "DepthBlur.forward(image)")
    config = f"scipy.fft.fft2 of 64² complex64 for each point, measured on {_PART} and scaled to {3 * HEIGHT * WIDTH}"
    other = Contender("points", _by_fft(image[..., 1], blur.defocus), config, values=lambda _: np.empty(0))
    result = race([mine, other], settings.rounds)
    ratio, scale = result.ratio(other.name, mine.name), 3 * HEIGHT * WIDTH / _PART
    scaled = Spread(scale * ratio.median, scale * ratio.low, scale * ratio.high, ratio.rounds)
    return Measured(scaled, _error(result.values[mine.name]), f"{mine.config}, {_THREADS} threads. Against {config}")


def _depths() -> dict[str, NDArray[np.float64]]:
    """Return scenes of one layer and many, in which few points or most hide something."""
    y, x = np.mgrid[:HEIGHT, :WIDTH]
    slant = 1.0 / (1.0 / 1.1 + (1.0 / 6.0 - 1.0 / 1.1) * x / WIDTH)
    return {
        "one plane": np.full((HEIGHT, WIDTH), 1.4),
        "squares of two planes": np.where((x // 60 + y // 60) % 2 == 0, 1.2, 3.0),
        "a slanted plane": slant,
        "bars before it": np.where(x // 20 % 3 == 0, 1.05, slant),
        "the floor": scene()[1],
    }


def occluded(settings: Settings) -> Measured:
    """Measure a blur in which points hide one another, what hides what being known: the worst of several scenes."""
    light, found, fixed = np.ascontiguousarray(scene()[0][..., 1]), {}, _fixed([1])
    for name, depth in _depths().items():
        blur = DepthBlur(depth, _LENS, PIXEL, tol=TOL, threads=_THREADS)
        operator = Occlusion(blur)
        operator.forward(light)
        operator.forward(light)  # from the second call at a depth map on, what pixels see is kept
        mine = Contender("occluded", lambda _, made=operator: made.forward(light), "Occlusion(blur).forward(light)")
        found[name] = race([mine, fixed], settings.rounds).ratio("occluded", "fixed")
    worst = max(found.values(), key=lambda ratio: ratio.median)
    each = ", ".join(f"{name} {ratio.median:.1f}" for name, ratio in found.items())
    note = f"Occlusion(blur).forward(light) after the second, {_THREADS} threads. Against {fixed.config}: {each}"
    return Measured(worst, None, note)


def occluded_once(settings: Settings) -> Measured:
    """Measure photographs at depth maps that nothing is known of, windows included: the worst of several scenes."""
    image, found = scene()[0], {}
    for name, depth in _depths().items():

        def blurred(occlusion: bool, depth: NDArray[np.float64] = depth) -> NDArray[np.floating]:
            blur = DepthBlur(depth, _LENS, PIXEL, channels=RED_GREEN_BLUE, tol=TOL, threads=_THREADS)
            return (Occlusion(blur) if occlusion else blur).forward(image)

        contenders = [
            Contender("occluded", lambda _, run=blurred: run(True), "Occlusion(DepthBlur(...)).forward"),
            Contender("added", lambda _, run=blurred: run(False), "DepthBlur(...).forward"),
        ]
        result = race(contenders, settings.rounds)
        found[name] = result.ratio("occluded", "added")
    worst = max(found.values(), key=lambda ratio: ratio.median)
    each = ", ".join(f"{name} {ratio.median:.1f}" for name, ratio in found.items())
    return Measured(worst, None, f"blur of {HEIGHT} x {WIDTH} RGB, {_THREADS} threads: {each}")


def focus_pull(settings: Settings) -> Measured:
    """Measure a frame of a pull of the focus, every one with windows of its own, against one fixed kernel."""
    image, depth = scene()
    stored = (200.0 * image).astype(np.uint8)
    plan = FocusPlan(stored, depth, _LENS, PIXEL, encoding="srgb", occlusion=False)
    out, sides = np.empty_like(stored), set()

    def pull(_: Any) -> NDArray[np.uint8]:
        for distance in np.linspace(1.6, 1.9, _FRAMES):
            sides.add(plan(focus_distance=float(distance), out=out).window)
        return out

    mine, other = Contender("pull", pull), _fixed()
    result = race([mine, other], 1 if settings.quick else 5)
    if out.max() == 0:
        raise AssertionError("the frames must hold light")
    took = result.ratio(mine.name, other.name)
    each = Spread(took.median / _FRAMES, took.low / _FRAMES, took.high / _FRAMES, took.rounds)
    note = (
        f"FocusPlan(..., occlusion=False)(focus_distance=..., out=out), sRGB uint8, all processors, "
        f"{_FRAMES} frames from 1.6 to 1.9 m, {1e3 * result.median(mine.name) / _FRAMES:.0f} ms each; windows of "
        f"{min(sides)}² to {max(sides)}². Against {other.config}"
    )
    return Measured(each, None, note)
