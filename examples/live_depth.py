"""Write the moving picture of README.md: two frames of a lens at two foci, the depth found and the sharp image.

A ball comes nearer in front of a wall that leans. It is rendered on 4 x 4 points a pixel, with photon and read noise,
and each pair is measured by `lommel.imaging.LiveDepth` alone. ``python examples/live_depth.py picture.webp`` takes a
few minutes.
"""

from __future__ import annotations

import io
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure
from PIL import Image

import lommel as lm

HEIGHT, WIDTH, POINTS = 208, 304, 4
FRAMES, PAUSE = 24, 90  # and milliseconds
BETWEEN, WHITE, PIXEL = (1.2, 2.1), 8000.0, 4e-6
NEAR = lm.Lens(focal_length=35e-3, f_number=8.0, focus_distance=1.35, wavelength=540e-9)
LENSES = (NEAR, NEAR.focused(1.8))
NOISE = lm.Noise(white=1.0, read=3.0, offset=100.0)


def rectangles(shape: tuple[int, int], seed: int) -> np.ndarray:
    """Opaque rectangles of all sizes, from 0.1 to 1."""
    draw = np.random.default_rng(seed)
    values = np.full(shape, 0.5)
    for _ in range(6000):
        size = min(2.0 * POINTS / np.sqrt(1.0 - draw.random()), 40.0 * POINTS)
        height, width = (max(2, int(size * draw.uniform(0.4, 1.6))) for _ in range(2))
        top, left = draw.integers(-height, shape[0]), draw.integers(-width, shape[1])
        values[max(top, 0) : top + height, max(left, 0) : left + width] = draw.uniform(0.1, 1.0)
    return values


def scenes() -> list[tuple[np.ndarray, np.ndarray]]:
    """Brightness and depth of all frames on points."""
    shape = HEIGHT * POINTS, WIDTH * POINTS
    y, x = np.meshgrid(np.linspace(-1.0, 1.0, shape[0]), np.linspace(-1.5, 1.5, shape[1]), indexing="ij")
    wall, ball = rectangles(shape, 1), rectangles(shape, 2)
    made = []
    for frame in range(FRAMES):
        turn = 2.0 * np.pi * frame / FRAMES
        middle = 1.55 - 0.25 * np.cos(turn)
        across, radius = 0.75 * np.sin(turn), 0.7 / middle
        inside = np.hypot(x - across, y) < radius
        bulge = np.sqrt(np.maximum(radius**2 - (x - across) ** 2 - y**2, 0.0))
        moved = np.roll(ball, int(across * shape[1] / 3.0), axis=1)
        depth = np.where(inside, middle - 0.12 * bulge, 1.93 - 0.04 * y)
        made.append((np.where(inside, moved, wall), depth))
    return made


def frames(light: np.ndarray, depth: np.ndarray, seed: int) -> list[np.ndarray]:
    """Return what a camera of 1 electron a count stores at each focus."""
    recorded = []
    for lens in LENSES:
        seen = lm.imaging.depth_of_field(light, depth, lens, PIXEL / POINTS, encoding="linear", energy=0.99).values
        electrons = WHITE * seen.reshape(HEIGHT, POINTS, WIDTH, POINTS).mean(axis=(1, 3))
        recorded.append(NOISE.record(electrons, seed + len(recorded)).round().astype(np.uint16))
    return recorded


def picture(pair: list[np.ndarray], found: lm.imaging.LiveDepthMap, sharp: np.ndarray) -> Image.Image:
    """Draw frames, depth and the sharp image."""
    figure = Figure(figsize=(8.0, 5.9), dpi=80, layout="constrained", facecolor="white")
    axes = figure.subplots(2, 2)
    known = np.isfinite(found.errors)
    error = 1e3 * np.median(found.errors[known])
    titles = ("focused at 1.35 m", "focused at 1.8 m", f"depth, standard error {error:.0f} mm", "sharp image")
    images = (pair[0] - 100.0, pair[1] - 100.0, 1.0 / found.depth, sharp)
    for ax, title, image in zip(axes.flat, titles, images, strict=True):
        if ax is axes[1, 0]:
            colours = plt.colormaps["viridis"].with_extremes(bad="0.75")
            shown = ax.imshow(
                image, cmap=colours, vmin=1.0 / BETWEEN[1], vmax=1.0 / BETWEEN[0], interpolation="nearest"
            )
        else:
            ax.imshow(np.clip(image / WHITE, 0.0, 1.0) ** 0.7, cmap="gray", vmin=0.0, vmax=1.0)
        ax.set_title(title, fontsize=12)
        ax.axis("off")
    bar = figure.colorbar(shown, ax=axes[1, 0], location="bottom", fraction=0.05, aspect=36, shrink=0.94, pad=0.02)
    marks = [2.0, 1.8, 1.6, 1.4, 1.2]
    bar.set_ticks([1.0 / mark for mark in marks], labels=[f"{mark:g} m" for mark in marks])
    stored = io.BytesIO()
    figure.savefig(stored, format="png")
    return Image.open(stored).convert("RGB")


def write(path: Path) -> None:
    """Write the moving picture."""
    live = lm.imaging.LiveDepth(
        LENSES, PIXEL, between=BETWEEN, noise=NOISE, shape=(HEIGHT, WIDTH), light=0.5 * WHITE, sharp=True
    )
    pictures = []
    for k, (light, depth) in enumerate(scenes()):
        pair = frames(light, depth, 2 * k)
        pictures.append(picture(pair, live(*pair), live.sharp()))
    path.parent.mkdir(parents=True, exist_ok=True)
    pictures[0].save(path, save_all=True, append_images=pictures[1:], duration=PAUSE, loop=0, quality=60, method=6)


if __name__ == "__main__":
    write(Path(sys.argv[1] if len(sys.argv) > 1 else "out/live-depth.webp"))
