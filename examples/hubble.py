"""Draw the Hubble Space Telescope in 1990 beside the telescope as designed: ``python hubble.py FILE.png``.

Pillow draws it, so that the first picture needs no plotting library. The gallery has the same by matplotlib.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

import lommel as lm

LENS = Path(__file__).with_name("lenses") / "hubble-1990.toml"
SIDE, FIELD, DECADES = 640, 4.0, 6  # pixels, arcsec and powers of ten of a picture
RADII = 2.0  # arcsec
# The colour map inferno, at ten equal steps.
INFERNO = ["000004", "1b0c41", "4a0c6b", "781c6d", "a52c60", "cf4446", "ed6925", "fb9b06", "f7d13d", "fcffa4"]
INK, GREY, COLOURS = "#1a1a1a", "#b0b0b0", ("#c2410c", "#1d4ed8")
FINE = 2  # lines are drawn this much finer, then reduced: Pillow's own are jagged


class Canvas:
    """A white picture, with lengths in pixels of the result."""

    def __init__(self, width: int, height: int) -> None:
        self.image = Image.new("RGB", (FINE * width, FINE * height), "white")
        self.draw = ImageDraw.Draw(self.image)

    def text(self, x: float, y: float, words: str, anchor: str = "lm", size: int = 22, fill: str = INK) -> None:
        """Write words at a point of theirs, the anchor."""
        self.draw.text((FINE * x, FINE * y), words, fill, ImageFont.load_default(FINE * size), anchor)

    def line(self, points: list[tuple[float, float]], fill: str = INK, width: float = 1.0) -> None:
        """Draw a line through points."""
        self.draw.line([(FINE * x, FINE * y) for x, y in points], fill, round(FINE * width), "curve")

    def paste(self, x: int, y: int, colours: np.ndarray) -> None:
        """Set an array of colours with its upper left corner at a point."""
        height, width, _ = colours.shape
        self.image.paste(Image.fromarray(colours).resize((FINE * width, FINE * height), 0), (FINE * x, FINE * y))

    def save(self, path: Path) -> None:
        """Write the picture."""
        self.image.reduce(FINE).save(path)


def inferno(level: np.ndarray) -> np.ndarray:
    """Return the colours of levels from 0 to 1."""
    known = np.array([[int(colour[at : at + 2], 16) for at in (0, 2, 4)] for colour in INFERNO])
    steps = np.linspace(0.0, 1.0, len(known))
    return np.stack([np.interp(level, steps, band) for band in known.T], axis=-1).round().astype(np.uint8)


def main(path: Path) -> None:
    """Compute both PSFs and draw them over the curves of their encircled energy."""
    instrument = lm.load_instrument(LENS)
    arcsec = instrument.lens.focal_length * math.pi / 648000  # metres on the sensor
    before = lm.psf(instrument.pupil(), SIDE, FIELD / SIDE * arcsec)
    after = lm.psf(before.pupil.unaberrated(), SIDE, FIELD / SIDE * arcsec)
    peak = float(after.values.max())

    canvas = Canvas(1500, 1180)
    canvas.text(60, 42, "Hubble Space Telescope: a star in 1990 and as designed", size=32)
    names = ("1990, spherical aberration of 265 nm rms", "as designed")
    for k, (answer, name) in enumerate(zip((before, after), names, strict=True)):
        left = 60 + k * (SIDE + 30)
        canvas.text(left, 92, f"{name}: Strehl ratio {float(answer.strehl):.2f}")
        level = 1.0 + np.log10(np.maximum(answer.values / peak, 10.0**-DECADES)) / DECADES
        canvas.paste(left, 112, inferno(level))
        bar = SIDE / FIELD
        canvas.line([(left + 24, 725), (left + 24 + bar, 725)], "white", 4)
        canvas.text(left + 24 + 0.5 * bar, 703, "1 arcsec", "mm", fill="white")
    canvas.paste(1400, 112, np.repeat(inferno(np.linspace(1.0, 0.0, SIDE))[:, None], 22, axis=1))
    for power in range(0, DECADES + 1, 2):
        canvas.text(1430, 112 + SIDE * power / DECADES, f"1e-{power}" if power else "1", size=18)
    canvas.text(1440, 92, "logarithmic: 1 = peak as designed", "rm", 18)

    left, top, width, height = 130, 810, 1240, 290
    canvas.text(left, 790, "Encircled energy: light within a radius", size=22)
    for tick in range(6):
        y = top + height * (1.0 - tick / 5)
        canvas.line([(left, y), (left + width, y)], GREY)
        canvas.text(left - 12, y, f"{20 * tick} %", "rm", 18)
    for tick in range(9):
        x = left + width * tick / 8
        canvas.line([(x, top), (x, top + height)], GREY)
        canvas.text(x, top + height + 18, f"{RADII * tick / 8:g}", "mm", 18)
    canvas.text(left + width / 2, top + height + 50, "radius (arcsec)", "mm", 20)
    radius = np.linspace(0.0, RADII, 401)
    for answer, name, colour in zip((before, after), ("1990", "as designed"), COLOURS, strict=True):
        inside = answer.encircled_energy(radius * arcsec, of="optics")
        points = zip(left + width * radius / RADII, top + height * (1.0 - inside), strict=True)
        canvas.line([(float(x), float(y)) for x, y in points], colour, 3)
        near = float(answer.encircled_energy(0.1 * arcsec, of="optics"))
        y = top + height * (1.0 - float(inside[100])) + 26
        canvas.text(left + 0.27 * width, y, f"{name}: {100.0 * near:.0f} % within 0.1 arcsec", fill=colour)
    canvas.save(path)
    print(f"wrote {path}: a star in 1990 and as designed, logarithmic, with the curves of encircled energy")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
