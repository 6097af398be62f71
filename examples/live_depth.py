"""Write the moving picture of README.md: two frames of a lens at two foci, the depth found and the sharp image.

A ball rolls over a table between a mug and a book, before a wall with a picture. The scene is rendered on 4 x 4
points a pixel, with photon and read noise, and each pair is measured by `lommel.imaging.LiveDepth` alone.
``python examples/live_depth.py picture.webp`` takes some minutes.
"""

from __future__ import annotations

import io
import sys
from collections.abc import Callable
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure
from PIL import Image, ImageDraw, ImageFont

import lommel as lm

HEIGHT, WIDTH, POINTS = 208, 304, 4
FRAMES, PAUSE = 24, 110  # and milliseconds
BETWEEN, WHITE, PIXEL = (1.2, 2.1), 8000.0, 46.9e-6  # of a sensor of 36 mm read out as 768 pixels
NEAR = lm.Lens(focal_length=50e-3, f_number=1.4, focus_distance=1.35, wavelength=540e-9)
LENSES = (NEAR, NEAR.focused(1.8))
NOISE = lm.Noise(white=1.0, read=3.0, offset=100.0)

# Metres: across, down and along the axis, from the lens.
TABLE, WALL = 0.115, 1.95
MUG, MUG_RADIUS, MUG_HEIGHT = (-0.12, 1.52), 0.043, 0.105
BOOK, BOOK_SIZE, BOOK_TURN = (0.17, 1.72), (0.16, 0.2), 0.35  # middle of its foot, and radians
BALL_RADIUS = 0.05


class Print:
    """Colours on a plane, drawn at `scale` points a metre."""

    def __init__(self, width: float, height: float, ground: str, scale: float = 4000.0) -> None:
        self.scale = scale
        self.image = Image.new("RGB", (round(width * scale), round(height * scale)), ground)
        self.draw = ImageDraw.Draw(self.image)

    def text(self, x: float, y: float, height: float, text: str, colour: str) -> None:
        """Write a line whose middle is at x, with its top at y."""
        font = ImageFont.load_default(height * self.scale)
        self.draw.text((x * self.scale, y * self.scale), text, colour, font, anchor="mt")

    def polygon(self, corners: list[tuple[float, float]], colour: str) -> None:
        """Fill a polygon."""
        self.draw.polygon([(x * self.scale, y * self.scale) for x, y in corners], colour)

    def at(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        """Return the colours, linear, at places inside."""
        stored = np.asarray(self.image) / 255.0
        rows = np.clip((y * self.scale).astype(int), 0, stored.shape[0] - 1)
        columns = np.clip((x * self.scale).astype(int), 0, stored.shape[1] - 1)
        return stored[rows, columns] ** 2.2


def book() -> Print:
    """Return a cover with a title and small print."""
    cover = Print(*BOOK_SIZE, "#a63a2b")
    cover.polygon([(0.01, 0.01), (0.15, 0.01), (0.15, 0.065), (0.01, 0.065)], "#f3e6c4")
    cover.text(0.08, 0.018, 0.022, "OPTICS", "#30201c")
    cover.text(0.08, 0.046, 0.011, "of blurred pictures", "#30201c")
    words = ["light", "wave", "lens", "pupil", "focus", "depth", "phase", "image", "point", "field"]
    draw = np.random.default_rng(3)
    for line in range(11):
        cover.text(0.08, 0.076 + 0.0105 * line, 0.0085, " ".join(draw.choice(words, 5)), "#f3e6c4")
    return cover


def poster() -> Print:
    """Return a picture of mountains under the sun, in a frame."""
    sheet = Print(0.2, 0.135, "#4a3524")
    sheet.polygon([(0.008, 0.008), (0.192, 0.008), (0.192, 0.127), (0.008, 0.127)], "#8fc1dd")
    sheet.draw.ellipse([4000.0 * each for each in (0.135, 0.02, 0.165, 0.05)], "#ffe27a")
    for left, top, foot, colour in ((0.03, 0.03, 0.055, "#5d7186"), (0.12, 0.045, 0.05, "#6f8296")):
        sheet.polygon([(left - foot, 0.1), (left + 0.02, top), (left + 0.03 + foot, 0.1)], colour)
        sheet.polygon([(left + 0.006, top + 0.014), (left + 0.02, top), (left + 0.035, top + 0.014)], "#f4f6f8")
    sheet.polygon([(0.008, 0.1), (0.192, 0.085), (0.192, 0.127), (0.008, 0.127)], "#4f8a4a")
    draw = np.random.default_rng(5)
    for x, y in zip(draw.uniform(0.012, 0.188, 60), draw.uniform(0.1, 0.12, 60), strict=True):
        sheet.polygon([(x - 0.003, y), (x, y - 0.011), (x + 0.003, y)], "#23502a")
    for edge in (
        (0.0, 0.0, 0.2, 0.008),
        (0.0, 0.127, 0.2, 0.135),
        (0.0, 0.0, 0.008, 0.135),
        (0.192, 0.0, 0.2, 0.135),
    ):
        left, top, right, bottom = edge
        sheet.polygon([(left, top), (right, top), (right, bottom), (left, bottom)], "#4a3524")
    return sheet


def grain(seed: int) -> np.ndarray:
    """Return what cloth, paint and leather have of themselves: random, periodic, of mean 0 and rms 1."""
    frequency = np.hypot(np.fft.fftfreq(1024)[:, None], np.fft.rfftfreq(1024))
    noise = np.fft.rfft2(np.random.default_rng(seed).standard_normal((1024, 1024)))
    values = np.fft.irfft2(noise * np.exp(-((frequency / 0.25) ** 2)) / (frequency + 0.004) ** 0.6)
    values -= values.mean()
    return values / values.std()


GRAIN, COVER, POSTER = grain(7), book(), poster()


def rough(x: np.ndarray, y: np.ndarray, share: float, size: float = 0.9e-3) -> np.ndarray:
    """Return factors around 1 at places, metres; grains have this size."""
    return np.maximum(
        1.0 + share * GRAIN[(y / size * 4.0).astype(int) % 1024, (x / size * 4.0).astype(int) % 1024], 0.2
    )


# The middles of the black patches of a football: the corners of an icosahedron.
GOLDEN = 0.5 * (1.0 + np.sqrt(5.0))
CORNERS = np.array([np.roll((0.0, a, b * GOLDEN), turn) for turn in range(3) for a in (-1, 1) for b in (-1, 1)])
CORNERS /= np.linalg.norm(CORNERS[0])


def football(normals: np.ndarray) -> np.ndarray:
    """Return the colours of a football by directions from its middle, as it lies."""
    along = np.sort(normals @ CORNERS.T, axis=-1)
    black = along[..., -1] > 0.94
    # Seams are halfway between the middles of two white patches: those of the icosahedron's faces.
    faces = np.array([corner + one + other for corner in CORNERS for one in CORNERS for other in CORNERS])
    faces = np.unique(faces[np.abs(np.linalg.norm(faces, axis=1) - 2.384) < 0.01].round(9), axis=0) / 2.384
    white = np.sort(normals @ faces.T, axis=-1)
    seam = (white[..., -1] - white[..., -2] < 0.03) | (np.abs(along[..., -1] - 0.94) < 0.006)
    value = np.where(black, 0.05, np.where(seam, 0.25, 0.8))
    tone = rough(0.05 * np.arctan2(normals[..., 1], normals[..., 0]), 0.05 * normals[..., 2], 0.13)
    return value[..., None] * tone[..., None] * np.array([1.0, 0.98, 0.94])


def seen(turn: float) -> tuple[np.ndarray, np.ndarray]:
    """Return light, linear and in three colours, and depth on points; `turn` is where the ball is on its way."""
    shape = HEIGHT * POINTS, WIDTH * POINTS
    slope = PIXEL / POINTS / NEAR.focal_length
    v, u = (np.arange(size) - 0.5 * (size - 1) for size in shape)
    u, v = np.meshgrid(u * slope, v * slope)
    depth = np.full(shape, WALL)
    light = wall(u * WALL, v * WALL)

    def cover(at: np.ndarray, where: np.ndarray, colours: np.ndarray) -> None:
        nearer = where & (at < depth)
        depth[nearer] = at[nearer]
        light[nearer] = colours[nearer]

    with np.errstate(divide="ignore", invalid="ignore"):
        far = np.where(v > 0.0, TABLE / v, np.inf)
    far = np.minimum(far, WALL)
    middle = np.array([0.035 * np.sin(turn), TABLE - BALL_RADIUS, 1.56 - 0.28 * np.cos(turn)])
    cover(far, v * WALL > TABLE, cloth(u * far, far, middle))
    # The book: a plane through its foot, turned about the vertical.
    turned = np.tan(BOOK_TURN)
    at = (BOOK[1] - turned * BOOK[0]) / (1.0 - turned * u)
    x = (u * at - BOOK[0]) / np.cos(BOOK_TURN) + 0.5 * BOOK_SIZE[0]
    y = v * at - (TABLE - BOOK_SIZE[1])
    inside = (x > 0.0) & (x < BOOK_SIZE[0]) & (y > 0.0) & (y < BOOK_SIZE[1])
    cover(at, inside, COVER.at(x, y) * rough(x, y, 0.06)[..., None])
    mug(u, v, cover)
    # The ball, which rolls: it turns by its way over its radius.
    ray = np.stack([u, v, np.ones(shape)], axis=-1)
    square, product = (ray**2).sum(-1), ray @ middle
    root = product**2 - square * (middle @ middle - BALL_RADIUS**2)
    at = (product - np.sqrt(np.maximum(root, 0.0))) / square
    normals = (ray * at[..., None] - middle) / BALL_RADIUS
    way = (middle[2] - 1.28) / BALL_RADIUS
    turning = np.array([[1, 0, 0], [0, np.cos(way), np.sin(way)], [0, -np.sin(way), np.cos(way)]])
    cover(at, root > 0.0, football(normals @ turning.T) * lit(normals)[..., None])
    return np.clip(light, 0.0, 1.0), depth


def lit(normals: np.ndarray) -> np.ndarray:
    """Return the light on surfaces from a window at the left, above and before them."""
    return 0.3 + 0.75 * np.maximum(normals @ np.array([-0.5, -0.6, -0.62]), 0.0)


def wall(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Return wallpaper with a picture on it."""
    stripe = (np.floor(x / 0.03) % 2)[..., None]
    colours = np.where(stripe, [0.42, 0.5, 0.44], [0.55, 0.62, 0.53])
    p, q = (x / 0.03) % 1.0 - 0.5, (y / 0.024 + 0.5 * stripe[..., 0]) % 1.0 - 0.5
    motif = (np.abs(p) + np.abs(q) < 0.26) ^ (np.abs(p) + np.abs(q) < 0.12)
    colours = np.where(motif[..., None], [0.75, 0.72, 0.5], colours) * rough(x, y, 0.1)[..., None]
    colours *= (1.0 - 0.5 * (x + 0.1) - 0.4 * y)[..., None] * 0.85
    left, top = -0.105, -0.16
    inside = (x > left) & (x < left + 0.2) & (y > top) & (y < top + 0.135)
    colours[inside] = POSTER.at((x - left)[inside], (y - top)[inside]) * rough(x, y, 0.05)[inside][:, None]
    return colours


def cloth(x: np.ndarray, z: np.ndarray, ball: np.ndarray) -> np.ndarray:
    """Return a checked cloth, darker under the ball and at the feet of what stands there."""
    woven = 0.5 * ((x / 0.032) % 1.0 < 0.5)[..., None] + 0.5 * ((z / 0.032) % 1.0 < 0.5)[..., None]
    colours = (1.0 - woven) * np.array([0.85, 0.84, 0.8]) + woven * np.array([0.13, 0.24, 0.5])
    shade = np.ones(x.shape)
    feet = ((ball[0] + 0.02, ball[2] + 0.01, BALL_RADIUS), (MUG[0] + 0.02, MUG[1] + 0.01, 1.1 * MUG_RADIUS))
    for across, along, size in feet:
        shade *= 1.0 - 0.65 * np.exp(-((((x - across) ** 2 + (z - along) ** 2) / size**2) ** 2))
    return colours * (rough(x, z, 0.14) * shade)[..., None]


def mug(u: np.ndarray, v: np.ndarray, cover: Callable[[np.ndarray, np.ndarray, np.ndarray], None]) -> None:
    """Cover what is behind a mug with its side and its handle."""
    (across, along), radius = MUG, MUG_RADIUS
    for hollow in (True, False):  # the far side of the inside, then the near one of the outside
        square, product = u**2 + 1.0, u * across + along
        root = product**2 - square * (across**2 + along**2 - radius**2)
        at = (product + (1.0 if hollow else -1.0) * np.sqrt(np.maximum(root, 0.0))) / square
        x, y = u * at - across, v * at - (TABLE - MUG_HEIGHT)
        normals = np.stack([x, np.zeros_like(x), at - along], axis=-1) / radius
        around = radius * np.arctan2(normals[..., 0], -normals[..., 2])
        inside = (root > 0.0) & (y > 0.0) & (y < MUG_HEIGHT)
        middle = y - 0.5 * MUG_HEIGHT
        rhombs = np.abs((around / 0.018) % 1.0 - 0.5) + np.abs(middle / 0.04) < 0.5
        band = (np.abs(middle) < 0.026) & ~rhombs
        colours = np.where(band[..., None], [0.12, 0.25, 0.42], [0.86, 0.8, 0.68])
        colours = colours * (rough(around, y, 0.12) * (0.35 if hollow else lit(normals)))[..., None]
        cover(at, inside, colours)
    x, y = u * along - (across - radius - 0.012), v * along - (TABLE - 0.55 * MUG_HEIGHT)
    ring = np.hypot(x / 0.75, y) / 0.03
    inside = (np.abs(ring - 1.0) < 0.22) & (u * along < across - 0.9 * radius)
    tone = rough(x, y, 0.12) * (0.95 - 0.25 * ring)
    cover(np.full(u.shape, along), inside, np.array([0.86, 0.8, 0.68]) * tone[..., None])


def frames(light: np.ndarray, depth: np.ndarray, seed: int) -> list[np.ndarray]:
    """Return what a camera of 1 electron a count stores at each focus."""
    recorded = []
    for lens in LENSES:
        blurred = lm.imaging.depth_of_field(light, depth, lens, PIXEL / POINTS, encoding="linear", energy=0.99).values
        electrons = WHITE * blurred.reshape(HEIGHT, POINTS, WIDTH, POINTS, 3).mean(axis=(1, 3))
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
            ax.imshow(np.clip(image / (0.9 * WHITE), 0.0, 1.0) ** (1 / 2.2))
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
        LENSES, PIXEL, between=BETWEEN, noise=NOISE, shape=(HEIGHT, WIDTH, 3), light=1.2 * WHITE, sharp=True
    )
    pictures = []
    for k in range(FRAMES):
        light, depth = seen(2.0 * np.pi * k / FRAMES)
        pair = frames(light, depth, 2 * k)
        pictures.append(picture(pair, live(*pair), live.sharp()))
    path.parent.mkdir(parents=True, exist_ok=True)
    pictures[0].save(path, save_all=True, append_images=pictures[1:], duration=PAUSE, loop=0, quality=60, method=6)


if __name__ == "__main__":
    write(Path(sys.argv[1] if len(sys.argv) > 1 else "out/live-depth.webp"))
