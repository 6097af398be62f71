"""Random questions about circular and annular pupils whose wavefronts depend on the direction."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

import lommel as lm
from lommel.optics.aperture.shapes import Shape
from lommel.optics.grid import Grid

TERMS = [(n, m) for n in range(2, 15) for m in range(-n, n + 1, 2)]


class DiskQuestion(NamedTuple):
    """A stack of pupils, a window and a tolerance."""

    pupil: lm.Pupil
    grid: Grid
    tol: float

    def __str__(self) -> str:
        """Return it in a line."""
        averaged = ", averaged" if self.grid.integrate else ""
        return (
            f"{self.grid.height}² of {self.grid.side:.2g}{averaged}, {math.prod(self.pupil.shape)} pupils of "
            f"{len(self.pupil.wavefront.terms)} terms, obscuration {self.pupil.obscuration:.2g}, tol {self.tol:.1g}"
        )


def disk_question(index: int, *, averages: bool = False) -> DiskQuestion:
    """Return a question, the same for the same index: windows to 400², up to 110 terms and 50 rad, up to 40 pupils.

    With `averages`, a third of them are averaged over pixels.
    """
    rng = np.random.default_rng(index)

    def between(low: float, high: float) -> float:
        return float(np.exp(rng.uniform(np.log(low), np.log(high))))

    side, count, pupils = round(between(8, 400)), round(between(1, 110)), 1
    if rng.random() > 0.55:
        pupils = round(between(2, 40 if side <= 128 else 4))
    among = TERMS[: max(3, int(count * rng.uniform(1.0, 2.0)))]
    terms = sorted(among[k] for k in rng.permutation(len(among))[:count])
    if all(m == 0 for _, m in terms):
        terms.append((3, 1))
    c = rng.standard_normal((len(terms), pupils))
    c *= between(0.1, 50.0) / np.sqrt((c**2).sum(axis=0))
    obscuration = 0.0 if rng.random() < 0.7 else float(rng.uniform(0.1, 0.7))
    place = rng.random()
    middle = side // 2 if place < 0.6 else side / 2 - 0.5
    center = (middle, middle) if place < 0.75 else tuple(map(float, rng.uniform(0.0, side - 1.0, 2)))
    pixel, tol = between(0.08, 1.5), 10.0 ** rng.uniform(-9.0, -2.0)
    wavefront = lm.Wavefront.zernike({term: of if pupils > 1 else of[0] for term, of in zip(terms, c, strict=True)})
    integrate = averages and rng.random() < 0.33
    return DiskQuestion(
        lm.Pupil(wavefront, obscuration=obscuration), Grid(side, pixel, center=center, integrate=integrate), tol
    )


def camera_question(index: int) -> DiskQuestion:
    """Return a question of a camera, the same for the same index: averages over pixels of 0.7 to 8 lambda N.

    Windows of 7² to 120², axes in the middle or near it, in a third of the stacks one for each of up to 1000 pupils;
    0.01 to 0.6 waves rms of up to 40 Zernike terms.
    """
    rng = np.random.default_rng([index, 67])

    def between(low: float, high: float) -> float:
        return float(np.exp(rng.uniform(np.log(low), np.log(high))))

    side, count, pupils = round(between(7, 120)), round(between(2, 40)), 1
    if rng.random() > 0.35:
        pupils = round(between(2, 1000 if side <= 48 else 60))
    c = rng.standard_normal((count, pupils))
    c *= 2.0 * math.pi * between(0.01, 0.6) / np.sqrt((c**2).sum(axis=0))
    terms = dict(zip(range(4, 4 + count), c if pupils > 1 else c[:, 0], strict=True))
    obscuration = 0.0 if rng.random() < 0.7 else float(rng.uniform(0.1, 0.5))
    place, middle = rng.random(), side // 2
    own = (pupils,) if pupils > 1 and place > 0.7 else ()
    away = 0.1 * side if place > 0.4 else 0.0
    row, column = (middle + away * rng.uniform(-1.0, 1.0, own) for _ in range(2))
    wavefront = lm.Wavefront.zernike(terms, order="noll")
    grid = Grid(side, between(0.7, 8.0), center=(row, column), integrate=True)
    return DiskQuestion(lm.Pupil(wavefront, obscuration=obscuration), grid, 10.0 ** rng.uniform(-6.5, -2.5))


APERTURES = ("annulus", "vanes", "three vanes", "vlt", "jwst", "hexagon", "off axis")


def aperture(kind: str, wavefront: lm.Wavefront) -> lm.Pupil:
    """Return a pupil behind the aperture of this name, one of APERTURES."""
    if kind == "annulus":
        return lm.Pupil(wavefront, obscuration=0.3)
    if kind == "vanes":
        return lm.Pupil(wavefront, obscuration=0.3, spider=lm.Spider.equal(4, 0.02))
    if kind == "three vanes":  # two off the axis, of three widths
        stop: Shape = lm.Disc() - lm.Disc(0.28)
        for angle, offset, width in ((90.0, 0.0, 0.03), (212.0, 0.06, 0.02), (328.0, 0.0, 0.045)):
            c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
            x, y = -offset * s, offset * c
            stop = stop - lm.Polygon.strip((x, y), (x + 2.5 * c, y + 2.5 * s), width)
        return lm.Pupil(wavefront, stop=stop)
    if kind in ("hexagon", "off axis"):
        disc = lm.Disc() - lm.Disc(0.28, center=(0.1, 0.05))
        return lm.Pupil(wavefront, stop=lm.Polygon.regular(6, 1.0) if kind == "hexagon" else disc)
    return lm.Pupil(wavefront, stop=lm.telescopes.jwst() if kind == "jwst" else lm.telescopes.vlt())


def aperture_question(index: int) -> tuple[str, DiskQuestion]:
    """Return an aperture's name and a question about it, the same for the same index.

    Windows of 9² to 128², samples or averages of 0.25 to 4 lambda N, 1 to 1000 pupils of 1 to 29 Zernike terms.
    """
    rng = np.random.default_rng([index, 100])
    kind = str(rng.choice(APERTURES))
    side, pixel = int(rng.choice([9, 33, 65, 128])), float(rng.choice([0.25, 0.5, 1.0, 2.0, 4.0]))
    integrate, tol = bool(rng.random() < 0.5), 10.0 ** -float(rng.uniform(3.0, 8.0))
    pupils, count = int(rng.choice([1, 20, 60, 1000])), int(rng.choice([1, 7, 29]))
    # Stacks that take seconds are cut.
    pupils = min(pupils, max(1, int(1.5e5 / (side * max(1.0, pixel / 0.5)) ** 2)))
    c = rng.standard_normal((count, pupils))
    c *= 2.0 * math.pi * float(np.exp(rng.uniform(np.log(0.01), np.log(0.4)))) / np.sqrt((c**2).sum(axis=0))
    terms = dict(zip(range(5, 5 + count), c if pupils > 1 else c[:, 0], strict=True))
    wavefront = lm.Wavefront.zernike(terms, order="noll", normalization="rms")
    return kind, DiskQuestion(aperture(kind, wavefront), Grid(side, pixel, integrate=integrate), tol)
