"""Depth of video by `lommel watch` with a camera's faults, one by one and together, on rendered scenes.

An object in front of a wall, both textured, on 8 x 8 points a pixel and rendered without this package
(tests/shared/scenes.py): 35 mm f/8 at 540 nm, foci of 1.35 m and 1.8 m, pixels of 4 um, 12000 electrons at white, 3
electrons of read noise. Faults: frames taken in turn of an object that moves, magnification that differs as that of a
thin lens, brightness that rolls over the rows, values of 8 bits, and H.264. `python benchmarks/live_video.py` renders
the videos into a temporary folder, runs the command on each, and prints a table in Markdown.
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import affine_transform, distance_transform_edt

sys.path.append(str(Path(__file__).resolve().parents[1] / "tests" / "shared"))

from scenes import POINTS, ThinLens, averaged, before, texture
from video_files import frames_of, write_video

Array = NDArray[Any]
SIDE, PAIRS, WHITE, LIGHT, READ = 256, 6, 12_000.0, 5000.0, 3.0
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
    Fault("rolling brightness of 3 %, 3 cycles", rolling=0.03, cycles=3.0),
    *(Fault(f"H.264, crf {crf}", compressed=h264(crf)) for crf in (4, 10, 18, 23)),
    *(Fault(f"Motion JPEG, q {step}", compressed=jpeg(step)) for step in (1, 4)),
    TOGETHER,
    TOGETHER._replace(name="the same, `--magnification lens`", options=LENS_SCALE),
    TOGETHER._replace(name="the same at crf 18", options=LENS_SCALE, compressed=h264(18)),
]


def mask() -> Array:
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
def light(number: int, motion: int, breathes: bool) -> Array:
    """Return electrons of a frame, before its noise."""
    lens = LENSES[number % 2]
    distances = [one.focal_length / (1.0 - one.focal_length / one.focus) for one in LENSES]
    scale = distances[number % 2] / distances[0] if breathes else 1.0
    front, hides, back = texture("leaves", SIDE, 11), mask(), texture("pink", SIDE, 12)
    moved = [np.roll(one, number * motion, axis=1) for one in (front, hides)]
    front, hides, back = (one if scale == 1.0 else scaled(one, scale) for one in (*moved, back))
    (found,) = before(front, hides, NEAR, back, FAR, [lens], LIGHT)
    return np.asarray(found)


def video(fault: Fault) -> Iterator[Array]:
    """Yield the frames, of one focus and the other in turn."""
    for number in range(2 * PAIRS):
        draw = np.random.default_rng(number)
        rows = 2.0 * np.pi * (fault.cycles * np.arange(SIDE)[:, None] / SIDE + 0.37 * number)
        seen = light(number, fault.motion, fault.breathes) * (1.0 + fault.rolling * np.sin(rows))
        seen = (draw.poisson(seen) + draw.normal(0.0, READ, seen.shape)) / WHITE
        seen = np.clip(seen, 0.0, 1.0)
        if not fault.eight_bits:
            yield np.rint(65535.0 * seen).astype(np.uint16)
            continue
        coded = np.where(seen <= 0.0031308, 12.92 * seen, 1.055 * seen ** (1 / 2.4) - 0.055)
        yield np.rint(255.0 * coded).astype(np.uint8)


def row(fault: Fault, folder: Path) -> str:
    """Return what the command finds of a video, beside the truth."""
    (folder / "lens.toml").write_text(LENS, encoding="utf-8")
    write_video(folder / "both.mkv", list(video(fault)), rate=30, **(fault.compressed or {}))
    words = ["lens.toml", "--source", "both.mkv", "--alternating", "--no-show", "--json"]
    words += [*(f"--focus={focus}m" for focus in FOCI), "--between", *(f"{one}m" for one in BETWEEN)]
    words += [f"--white={WHITE}", f"--read={READ}", "--depth=depth.mkv", "--depth=error.mkv", *fault.options]
    run = subprocess.run(
        [sys.executable, "-m", "lommel", "watch", *words], cwd=folder, capture_output=True, text=True, check=True
    )
    facts = json.loads(run.stdout)
    depth, errors = (frames_of(folder / f"{name}.mkv")[0] * facts["depth_scale"] for name in ("depth", "error"))
    z, edge, shares = [], [], []
    for k in range(PAIRS):
        inside = (
            averaged(np.roll(mask(), 2 * k * fault.motion, axis=1)).reshape(SIDE // 4, 4, -1, 4).mean(axis=(1, 3))
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
    told = ["do not fit"] if facts["misfit"] > 2.0 else []
    told += ["compression"] if facts["bits"] is not None and facts["bits"] < facts["noise_bits"] else []
    bits = "" if facts["bits"] is None else f"{facts['bits']:.2g}"
    return (
        f"| {fault.name} | {medians} | {spread:.2f} | {100.0 * np.mean(np.abs(values) > 3.0):.1f} % | {beside:.2f} | "
        f"{' / '.join(f'{each:.0f}' for each in np.mean(shares, axis=0))} % | {100.0 * facts['unfit']:.0f} % | "
        f"{facts['misfit']:.2f} | {bits} | {', '.join(told)} |"
    )


def main() -> None:
    """Print the table."""
    print(
        "| fault | median z, object / wall | robust z | beyond 3 | robust z at the edge | known, object / wall | "
        "left out | misfit | bits a pixel | told |\n|---|---|---|---|---|---|---|---|---|---|"
    )
    for fault in CASES:
        with tempfile.TemporaryDirectory() as folder:
            print(row(fault, Path(folder)), flush=True)


if __name__ == "__main__":
    main()
