"""Depth of frames and photographs that differ in focus: how true it is, beside what is possible, and how fast.

Scenes are continuous, 8 x 8 points a pixel, and rendered without this package (tests/shared/scenes.py): planes, and a
square before a plane. Lenses of 540 nm: 35 mm at f/8 and f/2.8, focused at 1.35 m and 1.8 m, and 8 mm at f/2.8, at
0.5 m and 2 m, with pixels of 4 and 3 um; 50 mm at f/1.8, at 2.3 m and 3.6 m, with pixels of 50 um, whose blur is
geometric. ``python benchmarks/live_depth.py`` prints tables in Markdown; ``--speed`` only those of time, in one
thread, beside an FFT of 1024 x 1024 by NumPy.

``--video`` instead runs `lommel watch` on videos of a square before a wall, by the lens of 35 mm at f/8, with a
camera's faults, one by one and together: frames taken in turn of an object that moves, magnification that differs as
that of a thin lens, brightness that rolls over the rows, values of 8 bits, and H.264; 12000 electrons at white.

``--gaussian`` compares LiveDepth with a simple estimator for Gaussian blur that is calibrated on planes, anew
for each seed: median errors of depth and CPU times, in turn in one process (it needs OpenCV).
"""

from __future__ import annotations

import argparse
import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import json
import math
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple
from unittest.mock import patch

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import affine_transform, distance_transform_edt

import lommel as lm

sys.path.append(str(Path(__file__).resolve().parents[1] / "tests" / "shared"))

from scenes import POINTS, ThinLens, averaged, before, lommel_lens, plane, record, texture
from video_files import frames_of, write_video

Array = NDArray[Any]
SIDE, LIGHT, READ, OFFSET = 256, 5000.0, 3.0, 100.0
NOISE = lm.Noise(read=READ, offset=OFFSET)


class Setup(NamedTuple):
    """A lens at its foci, with the range of distances, those of planes, and the textures that are tried."""

    focal_length: float
    f_number: float
    foci: tuple[float, float]
    pixel: float
    between: tuple[float, float]
    planes: tuple[float, ...]
    textures: tuple[str, ...]

    def lenses(self) -> list[ThinLens]:
        """Return the lens at each focus."""
        return [ThinLens(self.focal_length, self.f_number, focus, 540e-9, self.pixel) for focus in self.foci]


ALL = ("pink", "leaves", "soft", "fine", "dots", "text")
SETUPS = {
    "35 mm f/8": Setup(35e-3, 8.0, (1.35, 1.8), 4e-6, (1.2, 2.0), (1.25, 1.35, 1.45, 1.57, 1.7, 1.8, 1.92), ALL),
    "8 mm f/2.8": Setup(8e-3, 2.8, (0.5, 2.0), 3e-6, (0.3, 5.0), (0.35, 0.5, 0.6, 0.8, 1.1, 2.0, 3.5), ALL),
    "35 mm f/2.8": Setup(35e-3, 2.8, (1.35, 1.8), 4e-6, (1.2, 2.0), (1.25, 1.35, 1.45, 1.57, 1.7, 1.8, 1.92), ALL),
    "50 mm f/1.8, 50 um": Setup(
        50e-3, 1.8, (2.3, 3.6), 50.2e-6, (2.05, 5.0), (2.4, 2.5, 2.9, 3.3), ("soft", "leaves")
    ),
}


def live(
    setup: Setup, shape: tuple[int, int] = (SIDE, SIDE), light: float = LIGHT, threads: int = 1, **options: Any
) -> lm.imaging.LiveDepth:
    """Return what finds depth in frames."""
    lenses = [lommel_lens(lens) for lens in setup.lenses()]
    given: dict[str, Any] = {"between": setup.between, "noise": NOISE, "shape": shape, "light": light}
    with patch("lommel.imaging.live.processors", lambda: threads):
        return lm.imaging.LiveDepth(lenses, setup.pixel, **(given | options))


def standard(depth: Array, errors: Array, truth: Array | float) -> Array:
    """Return errors of 1 / distance over their standard errors, where depth is known."""
    known = np.isfinite(errors)
    u = 1.0 / depth[known].astype(np.float64)
    return np.asarray((u - 1.0 / np.broadcast_to(truth, depth.shape)[known]) / (errors[known] * u**2))


def robust(values: Array) -> float:
    """Return the standard deviation of the middle of values."""
    return float(1.4826 * np.median(np.abs(values - np.median(values))))


def planes(name: str, setup: Setup) -> list[str]:
    """Return rows of each texture and light: the largest and least of what planes came to."""
    rows = []
    for light in (LIGHT, 0.1 * LIGHT):
        finder = live(setup, light=light)
        for kind in setup.textures:
            found = []
            for distance in setup.planes:
                scene = texture(kind, SIDE, 7)
                result = finder(*record(plane(scene, setup.lenses(), distance, light), seed=int(1000 * distance)))
                z = standard(result.depth, result.errors, distance)
                seen = averaged(scene)
                bound = lm.depth_precision(
                    [lommel_lens(lens) for lens in setup.lenses()],
                    distance,
                    setup.pixel,
                    noise=lm.Noise(white=light, read=READ),
                    contrast=float(seen.std() / seen.mean()),
                )
                scatter = robust(result.depth[np.isfinite(result.errors)]) / bound if kind == "pink" else math.nan
                if z.size > 50:
                    found.append((np.median(z), robust(z), np.mean(np.abs(z) > 3.0), scatter))
            medians, spreads, beyond, scatters = np.array(found).T
            told = f"{scatters.min():.2f} to {scatters.max():.2f}" if kind == "pink" else ""
            rows.append(
                f"| {name} | {kind} | {light:g} | {np.abs(medians).max():.2f} | "
                f"{spreads.min():.2f} to {spreads.max():.2f} | "
                f"{100.0 * beyond.max():.1f} % | {told} |"
            )
    return rows


def edges(name: str, setup: Setup, near: float, far: float) -> str:
    """Return a row about a square before a plane."""
    points = SIDE * 8
    mask = np.zeros((points, points))
    mask[points // 4 : 3 * points // 4, points // 4 : 3 * points // 4] = 1.0
    scene = before(texture("leaves", SIDE, 11), mask, near, texture("pink", SIDE, 12), far, setup.lenses(), LIGHT)
    result = live(setup)(*record(scene, seed=4))
    inside = averaged(mask).reshape(SIDE // 4, 4, SIDE // 4, 4).mean(axis=(1, 3)) > 0.5
    truth = np.where(inside, near, far)
    from scipy.ndimage import distance_transform_edt

    away = 4.0 * np.where(inside, distance_transform_edt(inside), distance_transform_edt(~inside)) - 2.0
    cells = []
    for low, high in ((0, 8), (8, 16), (16, 32)):
        here = (away >= low) & (away < high)
        errors = np.where(here, result.errors, np.inf)
        z = standard(result.depth, errors, truth)
        cells.append(f"{1.4826 * np.median(np.abs(z)):.2f} at {100.0 * np.isfinite(errors[here]).mean():.0f} %")
    return f"| {name} | {near:g} m before {far:g} m | " + " | ".join(cells) + " |"


def models(setup: Setup) -> list[str]:
    """Return rows of depth from photographs by several transfer functions: bias and scatter, mm."""

    def imitated(shape: Callable[[Array], Array]) -> Any:
        def transfer(lens: lm.Lens, vergence: Array, _spectrum: Any, pitch: float) -> Callable[[Array], Array]:
            radii = lens.pupil(1.0 / vergence).geometric_radius() / pitch
            return lambda f: np.array([shape(2.0 * math.pi * radius * f) for radius in radii])

        return transfer

    from scipy.special import j1

    from lommel.estimation.focal_model import transfer_curve

    kinds = {
        "the lens's own": transfer_curve,
        "disc": imitated(lambda x: 2.0 * j1(np.maximum(x, 1e-9)) / np.maximum(x, 1e-9)),
        "Gaussian": imitated(lambda x: np.exp(-(x**2) / 8.0)),
    }
    rows = []
    for name, transfer in kinds.items():
        cells = []
        for distance in (1.4, 1.5, 1.6, 1.7):
            counts = record(
                plane(texture("pink", SIDE, 3), setup.lenses(), distance, LIGHT), seed=int(1000 * distance)
            )
            found = lm.imaging.depth_from_defocus(
                [(one - OFFSET) / 1e4 for one in counts],
                [lommel_lens(lens) for lens in setup.lenses()],
                setup.pixel,
                encoding="linear",
                noise=lm.Noise(white=1e4, read=READ),
                between=setup.between,
                transfer=transfer,
            )
            e = 1e3 * (found.depth - distance)[np.isfinite(found.errors)]
            z = standard(found.depth, found.errors, distance)
            cells.append(f"{np.median(e):+.1f}, {robust(e):.1f} ({robust(z):.2f})" if e.size > 500 else "not known")
        rows.append(f"| f/{setup.f_number:g}, {name} | " + " | ".join(cells) + " |")
    return rows


def wiener(electrons: Sequence[Array], lenses: Sequence[ThinLens], distance: float, light: float) -> Array:
    """Return the exact Wiener filter of frames of a known distance, for the texture that the tables are made for."""
    from lommel.estimation.focal_model import FocalLight, transfer_curve
    from lommel.imaging.focal_engine import CONTRAST
    from lommel.imaging.focal_tables import _SHARED_ALIASES

    there = FocalLight(light, READ, (1.0,) * len(lenses), CONTRAST)
    at = np.array([1.0 / distance])
    curves = [transfer_curve(lommel_lens(lens), at, ((lens.wavelength, 1.0),), lens.pixel) for lens in lenses]
    side = len(electrons[0])
    fy, fx = np.meshgrid(np.fft.fftfreq(side), np.fft.fftfreq(side), indexing="ij")

    def of(across: int, down: int) -> tuple[Array, Array, Array]:
        x, y = fx - across, fy - down
        pixel, f = np.sinc(x) * np.sinc(y), np.hypot(x, y)
        return pixel, np.stack([curve(f)[0] for curve in curves]) * pixel, there.power(f)

    pixel, h, power = of(0, 0)
    noise, shared = np.ones_like(h), pixel * power * h
    for across, down in [(a, b) for a in (-1, 0, 1) for b in (-1, 0, 1) if a or b]:
        beyond, seen, strength = of(across, down)
        noise += strength * seen**2
        shared += _SHARED_ALIASES * strength * beyond * seen
    over = shared / noise
    filters = over - power * (h * over).sum(axis=0) / (1.0 + power * (h**2 / noise).sum(axis=0)) * h / noise
    filters[:, 0, 0] = 1.0 / len(lenses)
    return np.asarray(np.fft.ifft2((np.fft.fft2(electrons) * filters).sum(axis=0)).real)


def sharp(name: str, setup: Setup, light: float) -> str:
    """Return a row about sharp images of planes: by how many decibels they are better than others, least to most."""
    lenses, white = setup.lenses(), 3.0 * light
    pairs = live(setup, light=light, sharp=True)
    options: dict[str, Any] = {"between": setup.between, "noise": NOISE, "shape": (SIDE, SIDE), "light": light}
    singles = [lm.imaging.LiveSharpen(lommel_lens(lens), setup.pixel, **options) for lens in lenses]
    found = []
    for kind in ("leaves", "pink"):
        for distance in setup.planes:
            scene = texture(kind, SIDE, 7)
            truth = light * averaged(scene)

            def quality(image: Array, truth: Array = truth) -> float:
                return float(-10.0 * np.log10(np.mean(np.square(image - truth)[32:-32, 32:-32])))

            frames = record(plane(scene, lenses, distance, light), seed=int(1000 * distance))
            electrons = [frame - OFFSET for frame in frames]
            pairs(*frames)
            k = int(np.argmax([quality(each) for each in electrons]))
            results = [
                lm.imaging.restore(
                    electrons[k] / white, np.full((SIDE, SIDE), distance), lommel_lens(lenses[k]), setup.pixel,
                    encoding="linear", noise=lm.Noise(white=white, read=READ), method=method,
                )
                for method in (lm.imaging.RichardsonLucy(), lm.imaging.OnePass())
            ]  # fmt: skip
            iterated, once = (quality(white * np.asarray(one.light)) for one in results)
            pair, single = quality(pairs.sharp()), quality(singles[k](frames[k], distance))
            both, one = (quality(wiener(*each, distance, light)) for each in (
                (electrons, lenses), (electrons[k : k + 1], lenses[k : k + 1])
            ))  # fmt: skip
            photo = quality(electrons[k])
            found.append(
                (pair - both, pair - iterated, single - one, single - iterated, once - iterated, iterated - photo)
            )
    cells = [f"{low:+.2f} to {high:+.2f}" for low, high in zip(np.min(found, 0), np.max(found, 0), strict=True)]
    return f"| {name} | {light:g} | " + " | ".join(cells) + " |"


def frames_of_known_depth(name: str, setup: Setup) -> str:
    """Return a row about the time of sharp frames of 1000 x 1000, by maps of blocks and of pixels."""
    near, far = (1.0 / each for each in setup.between)
    depth = 1.0 / np.linspace(0.9 * near + 0.1 * far, 0.1 * near + 0.9 * far, 1_000_000).reshape(1000, 1000)
    frame = np.random.default_rng(0).poisson(LIGHT, (1000, 1000)).astype(np.uint16)
    out = np.empty((1000, 1000), np.float32)
    options: dict[str, Any] = {"between": setup.between, "noise": NOISE, "shape": (1000, 1000)}
    with patch("lommel.imaging.live.processors", lambda: 1):
        sharpen = lm.imaging.LiveSharpen(lommel_lens(setup.lenses()[0]), setup.pixel, **options)
    maps = (np.ascontiguousarray(depth[::4, ::4]), depth.astype(np.float32))
    times = [fastest(lambda each=each: sharpen(frame, each, out)) for each in maps]  # type: ignore[misc]
    return f"| {name} | " + " | ".join(f"{1e3 * each:.1f} ms, {1.0 / each:.0f}" for each in times) + " |"


def fastest(run: Callable[[], object], turns: int = 25) -> float:
    """Return the least CPU time of a call, in seconds."""
    run()
    times = []
    for _ in range(turns):
        begin = time.process_time()
        run()
        times.append(time.process_time() - begin)
    return min(times)


def speed(name: str, setup: Setup, distance: float, transform: float) -> str:
    """Return a row about frames of 640 x 480, whatever the texture a plane nearly all of which is known."""
    pair = record(plane(texture("leaves", SIDE, 7), setup.lenses(), distance, LIGHT), seed=1)
    frames = [np.ascontiguousarray(np.tile(one, (2, 3))[:480, :640]) for one in pair]
    finder, both = live(setup, (480, 640)), live(setup, (480, 640), sharp=True)

    def with_image() -> None:
        both(*frames)
        both.sharp()

    alone, together = fastest(lambda: finder(*frames)), fastest(with_image)
    pairs = live(setup, (480, 640), threads=2)
    times = []
    for _ in range(25):
        begin = time.perf_counter()
        pairs(*frames)
        times.append(time.perf_counter() - begin)
    return (
        f"| {name} | {finder.binning[0]} | {finder.rank[0]} | {1e3 * alone:.1f} ms | {alone / transform:.2f} | "
        f"{1.0 / alone:.0f} | {1.0 / together:.0f} | {alone / min(times):.2f} |"
    )


SEEDS, INNER = 10, 9  # blocks beside the border that are left out
BOXES = (14, 17)  # pixels: about the area of the windows of LiveDepth, and 1.6 times as much


class GaussianDepth:
    """Depth by Gaussian blur of two frames, whose difference is a multiple of their Laplacian.

    The multiple is a least-squares fit in boxes of side x side pixels of frames smoothed by 1.5 pixels, and a cubic
    of it, fitted to planes, is 1 / distance.
    """

    def __init__(self, side: int, pairs: Sequence[Sequence[Array]], distances: Array) -> None:
        self.side = side
        ratios = [np.median(self.ratio(*pair)[20:-20, 20:-20]) for pair in pairs]
        self.cubic = np.polyfit(ratios, 1.0 / distances, 3)

    def ratio(self, first: Array, second: Array) -> Array:
        """Return the ratio of difference and Laplacian at each pixel."""
        import cv2

        a, b = (cv2.GaussianBlur(one.astype(np.float32), (0, 0), 1.5) for one in (first, second))
        laplacian = 0.5 * cv2.Laplacian(a + b, cv2.CV_32F, ksize=3)
        boxes = (self.side, self.side)
        return np.asarray(cv2.blur((a - b) * laplacian, boxes) / cv2.blur(laplacian**2, boxes))

    def __call__(self, first: Array, second: Array) -> Array:
        """Return the depth of blocks of 4 x 4 pixels."""
        return np.asarray(1.0 / np.polyval(self.cubic, self.ratio(first, second)[2::4, 2::4]))


def gaussian() -> None:
    """Print errors and times of LiveDepth beside those of the estimator for Gaussian blur."""
    import cv2

    cv2.setNumThreads(1)
    setup, side = SETUPS["35 mm f/8"], 192
    lenses, finder = setup.lenses(), live(setup, (side, side))
    distances = 1.0 / np.linspace(1.0 / 1.2, 1.0 / 2.0, 9)[1:-1]
    peers = []
    for seed in range(SEEDS):
        scene = texture("pink", side, 50 + seed)
        pairs = [record(plane(scene, lenses, one, LIGHT), seed=10 * seed + k) for k, one in enumerate(distances)]
        peers.append([GaussianDepth(boxes, pairs, distances) for boxes in BOXES])
    inner = slice(INNER, -INNER)
    print("| texture | LiveDepth, % | Gaussian, % | Gaussian / LiveDepth | in larger boxes |\n|---|---|---|---|---|")
    for kind in ("pink", "leaves", "steep", "fine", "dots", "text"):
        errors = np.empty((SEEDS, 4, 3))
        for seed, k in np.ndindex(SEEDS, 4):
            distance = distances[2 * k]
            pair = record(plane(texture(kind, side, seed + 1), lenses, distance, LIGHT), seed=1000 * (seed + 1) + k)
            found = finder(*pair)
            known = np.isfinite(found.errors)[inner, inner]
            for j, depth in enumerate((found.depth, *(peer(*pair) for peer in peers[seed]))):
                errors[seed, k, j] = np.median(np.abs(depth[inner, inner] / distance - 1.0)[known])
        # Geometric means over distances; standard errors over seeds.
        ratios = np.exp(np.log(errors[..., 1:] / errors[..., :1]).mean(axis=1))
        cells = [" ".join(f"{100.0 * one:.2f}" for one in errors[..., j].mean(axis=0)) for j in (0, 1)]
        spread = ratios.std(axis=0, ddof=1) / math.sqrt(SEEDS)
        cells += [f"{one:.2f} +- {error:.2f}" for one, error in zip(ratios.mean(axis=0), spread, strict=True)]
        print(f"| {kind} | " + " | ".join(cells) + " |", flush=True)
    frames = [np.ascontiguousarray(np.tile(one, (3, 4))[:480, :640]) for one in pairs[3]]
    large = live(setup, (480, 640))
    times = []
    for _ in range(25):
        for run in (large, peers[0][0]):
            begin = time.process_time()
            run(*frames)
            times.append(time.process_time() - begin)
    ours, theirs = np.reshape(times, (-1, 2)).T
    print(f"\n640 x 480: {1e3 * ours.min():.1f} and {1e3 * theirs.min():.1f} ms, {np.median(ours / theirs):.2f}")


PAIRS, WHITE = 6, 12_000.0
FOCI, BETWEEN, NEAR, FAR = (1.35, 1.8), (1.2, 2.0), 1.42, 1.7
LENSES = [ThinLens(35e-3, 8.0, focus, 540e-9, 4e-6) for focus in FOCI]
BESIDE = 16  # pixels from the edge of the object, within which blocks count as edge
LENS = '[lens]\nfocal_length = "35 mm"\nf_number = 8.0\nwavelength = "540 nm"\n[sensor]\npixel = "4 um"\n'


class Fault(NamedTuple):
    """What a camera does wrong, and the options by which the command is told of it.

    `motion` is in points a frame, `rolling` a share of the brightness, of so many `cycles` over the rows.
    """

    name: str
    motion: int = 0
    breathes: bool = False
    rolling: float = 0.0
    cycles: float = 1.0
    lost: int = -1  # number of the frame that is missing
    eight_bits: bool = True
    compressed: dict[str, str] | None = None
    options: tuple[str, ...] = ()


def h264(crf: int) -> dict[str, str]:
    """Return the options of H.264 of a constant quality."""
    return {"codec": "libx264", "stored": "yuv420p", "crf": str(crf)}


def jpeg(step: int) -> dict[str, str]:
    """Return the options of Motion JPEG."""
    return {"codec": "mjpeg", "stored": "yuvj420p", "qmin": str(step), "qmax": str(step)}


LENS_SCALE = ("--magnification", "lens")
TOGETHER = Fault("all: moves 0.5 pixels, breathes, rolls, crf 4", 4, True, 0.03, compressed=h264(4))
CASES = [
    Fault("16 bits, no fault", eight_bits=False),
    Fault("8 bits, lossless"),
    *(Fault(f"moves {points / POINTS:g} pixels a frame", motion=points) for points in (4, 8, 16)),
    Fault("focus breathing of 0.67 %", breathes=True),
    Fault("the same, `--magnification lens`", breathes=True, options=LENS_SCALE),
    Fault("rolling brightness of 3 %, 1 cycle", rolling=0.03),
    Fault("rolling brightness of 10 %, 60 rows", rolling=0.1, cycles=SIDE / 60.0),
    Fault("rolling brightness of 10 %, 20 rows", rolling=0.1, cycles=SIDE / 20.0),
    Fault("flicker of 25 %", rolling=0.25, cycles=0.0),
    Fault("a lost frame, times renumbered", lost=5),
    *(Fault(f"H.264, crf {crf}", compressed=h264(crf)) for crf in (4, 10, 18, 23)),
    *(Fault(f"Motion JPEG, q {step}", compressed=jpeg(step)) for step in (1, 3)),
    TOGETHER,
    TOGETHER._replace(name="the same, `--magnification lens`", options=LENS_SCALE),
    TOGETHER._replace(name="the same at crf 18", options=LENS_SCALE, compressed=h264(18)),
]


def square() -> Array:
    """Return the object, on points."""
    points = SIDE * POINTS
    made = np.zeros((points, points))
    made[points // 4 : 3 * points // 4, points // 5 : 3 * points // 5] = 1.0
    return made


def scaled(points: Array, scale: float) -> Array:
    """Return a scene magnified about its centre."""
    middle = 0.5 * (len(points) - 1)
    return np.asarray(
        affine_transform(points, [1.0 / scale] * 2, middle * (1.0 - 1.0 / scale), order=1, mode="grid-wrap")
    )


@cache
def frame_light(number: int, motion: int, breathes: bool) -> Array:
    """Return electrons of a frame, before its noise."""
    lens = LENSES[number % 2]
    distances = [one.focal_length / (1.0 - one.focal_length / one.focus) for one in LENSES]
    scale = distances[number % 2] / distances[0] if breathes else 1.0
    front, hides, back = texture("leaves", SIDE, 11), square(), texture("pink", SIDE, 12)
    moved = [np.roll(one, number * motion, axis=1) for one in (front, hides)]
    front, hides, back = (one if scale == 1.0 else scaled(one, scale) for one in (*moved, back))
    (found,) = before(front, hides, NEAR, back, FAR, [lens], LIGHT)
    return np.asarray(found)


def frames_of_video(fault: Fault) -> Iterator[Array]:
    """Yield the frames, of one focus and the other in turn."""
    for number in range(2 * PAIRS):
        draw = np.random.default_rng(number)
        rows = 2.0 * np.pi * (fault.cycles * np.arange(SIDE)[:, None] / SIDE + 0.37 * number)
        seen = frame_light(number, fault.motion, fault.breathes) * (1.0 + fault.rolling * np.sin(rows))
        seen = (draw.poisson(seen) + draw.normal(0.0, READ, seen.shape)) / WHITE
        seen = np.clip(seen, 0.0, 1.0)
        if not fault.eight_bits:
            yield np.rint(65535.0 * seen).astype(np.uint16)
            continue
        coded = np.where(seen <= 0.0031308, 12.92 * seen, 1.055 * seen ** (1 / 2.4) - 0.055)
        yield np.rint(255.0 * coded).astype(np.uint8)


def video_row(fault: Fault, folder: Path) -> str:
    """Return what the command finds of a video, beside the truth."""
    (folder / "lens.toml").write_text(LENS, encoding="utf-8")
    frames = [frame for number, frame in enumerate(frames_of_video(fault)) if number != fault.lost]
    write_video(folder / "both.mkv", frames, rate=30, **(fault.compressed or {}))
    words = ["lens.toml", "--source", "both.mkv", "--alternating", "--json"]
    words += [*(f"--focus={focus}m" for focus in FOCI), "--between", *(f"{one}m" for one in BETWEEN)]
    words += [f"--white={WHITE}", f"--read={READ}", "--depth=depth.mkv", "--depth=error.mkv", *fault.options]
    run = subprocess.run(
        [sys.executable, "-m", "lommel", "watch", *words], cwd=folder, capture_output=True, text=True, check=False
    )
    facts = json.loads(run.stdout)
    depth, errors = (frames_of(folder / f"{name}.mkv")[0] * facts["depth_scale"] for name in ("depth", "error"))
    z, edge, shares = [], [], []
    for k in range(len(depth)):
        inside = (
            averaged(np.roll(square(), 2 * k * fault.motion, axis=1)).reshape(SIDE // 4, 4, -1, 4).mean(axis=(1, 3))
        )
        inside = inside > 0.5
        away = 4.0 * np.where(inside, distance_transform_edt(inside), distance_transform_edt(~inside)) - 2.0
        known = depth[k] > 0.0
        inverse = 1.0 / np.where(known, depth[k], 1.0)
        off = (inverse - 1.0 / np.where(inside, NEAR, FAR)) / (np.where(known, errors[k], 1.0) * inverse**2)
        apart = away >= BESIDE
        z.append(np.stack([off[known & apart], inside[known & apart]]))
        edge.append(off[known & ~apart])
        shares.append([100.0 * known[apart & (inside == side)].mean() for side in (True, False)])
    values, within = np.concatenate(z, axis=1)
    medians = " / ".join(f"{np.median(values[within == side]):+.2f}" for side in (1.0, 0.0))
    spread, beside = (1.4826 * np.median(np.abs(each)) for each in (values, np.concatenate(edge)))
    told = ["do not fit"] if (facts["misfit"] or 0.0) > 2.0 else []
    lost = facts["unknown"]
    told += ["compression"] if "Compression adds" in run.stdout + run.stderr else []
    told += ["a lost frame"] if "lost a frame" in run.stderr else []
    causes = " / ".join(f"{100.0 * lost.get(name, 0.0):.0f}" for name in ("compressed", "moved", "bands"))
    return (
        f"| {fault.name} | {medians} | {spread:.2f} | {100.0 * np.mean(np.abs(values) > 3.0):.1f} % | {beside:.2f} | "
        f"{' / '.join(f'{each:.0f}' for each in np.mean(shares, axis=0))} % | {100.0 * facts['unfit']:.0f} % | "
        f"{causes} % | {'' if facts['misfit'] is None else format(facts['misfit'], '.2f')} | {', '.join(told)} |"
    )


def videos() -> None:
    """Print the table of videos."""
    print(
        "| fault | median z, object / wall | robust z | beyond 3 | robust z at the edge | known, object / wall | "
        "left out | compressed / moved / bands | misfit | told |\n|---|---|---|---|---|---|---|---|---|---|"
    )
    for fault in CASES:
        with tempfile.TemporaryDirectory() as folder:
            print(video_row(fault, Path(folder)).replace("+nan", "–").replace("nan", "–"), flush=True)


def main(arguments: Sequence[str] | None = None) -> None:
    """Print all tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--speed", action="store_true", help="only what time it takes")
    parser.add_argument("--video", action="store_true", help="only videos with a camera's faults")
    parser.add_argument("--gaussian", action="store_true", help="only beside an estimator for Gaussian blur")
    asked = parser.parse_args(arguments)
    if asked.gaussian:
        gaussian()
        return
    if asked.video:
        videos()
        return
    values = np.random.default_rng(0).random((1024, 1024))
    transform = fastest(lambda: np.fft.rfft2(values))
    print(f"640 x 480, an FFT of 1024 x 1024 takes {1e3 * transform:.1f} ms\n")
    print("| lens | pixels | images | depth | over the FFT | frames/s | with a sharp image | of two threads |")
    print("|---|---|---|---|---|---|---|---|")
    for name, distance in (("35 mm f/8", 1.5), ("8 mm f/2.8", 0.8), ("35 mm f/2.8", 1.5)):
        print(speed(name, SETUPS[name], distance, transform), flush=True)
    print("\n| sharp frames of 1000 x 1000, frames/s | map of blocks | of pixels |\n|---|---|---|")
    for name in ("35 mm f/8", "8 mm f/2.8", "35 mm f/2.8"):
        print(frames_of_known_depth(name, SETUPS[name]), flush=True)
    if asked.speed:
        return
    print(
        "\n| sharp, dB | electrons | pair - Wiener | pair - restored | frame - Wiener | frame - restored | "
        "OnePass - restored | restored - photograph |\n|---|---|---|---|---|---|---|---|"
    )
    for name in ("35 mm f/8", "8 mm f/2.8", "35 mm f/2.8"):
        for light in (LIGHT, 0.1 * LIGHT):
            print(sharp(name, SETUPS[name], light), flush=True)
    print(
        "\n| lens | texture | electrons | median z | sd of z | beyond 3 | scatter / bound |\n"
        "|---|---|---|---|---|---|---|"
    )
    for name, setup in SETUPS.items():
        print("\n".join(planes(name, setup)), flush=True)
    print("\n| lens | edge | 0 to 8 pixels beside it | 8 to 16 | 16 to 32 |\n|---|---|---|---|---|")
    for name, near, far in (("35 mm f/8", 1.4, 1.75), ("8 mm f/2.8", 0.5, 0.9), ("35 mm f/2.8", 1.4, 1.75)):
        print(edges(name, SETUPS[name], near, far), flush=True)
    print("\n| photographs, PSF | 1.4 m | 1.5 m | 1.6 m | 1.7 m |\n|---|---|---|---|---|")
    for name in ("35 mm f/8", "35 mm f/2.8"):
        print("\n".join(models(SETUPS[name])), flush=True)


if __name__ == "__main__":
    main()
