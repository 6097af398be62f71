"""Field maps from stars: how often they are found, how exactly, beside polynomials of pixels, and how fast.

Stars come from a Cartesian matrix Fourier transform that shares nothing with the package (tests/shared). Each row has
random fields: curvature, tilt of the sensor, astigmatism, coma, spherical aberration and more, 11 terms of degree 3;
33 x 33 pixels of lambda*N/2, blur of 0.6 pixels, signal-to-noise ratios of 30 to 300. `python benchmarks/fields.py
--fields 50` runs all of it; the default is a quick look. Seconds are of processors.

`--telescope SDSS.yaml --terms 14 --degree 4` is the field of a telescope that batoid traces (``pip install batoid``):
its own path differences are made into images by a matrix Fourier transform that shares nothing with the package, and
what :func:`lommel.fit_field` finds is compared with Zernike terms of those path differences.
"""

from __future__ import annotations

import argparse
import math
import sys
import time
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from scipy import ndimage

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests" / "shared"))
sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

import lommel as lm
import searches
import simulated_fields as simulated
from benchmarks.report import Table
from benchmarks.timing import Settings

NOISE = lm.Noise(read=2.0)
EVEN = np.isin(np.arange(4, 15), [4, 5, 6, 11, 12, 13, 14])
SENSOR = (4000, 4000)


class Row(NamedTuple):
    """A row of the table: number of stars, known defoci, doubles among the stars, pixel and blur."""

    name: str
    stars: int
    defocus: tuple[float, ...] = (0.0,)
    doubles: int = 0
    pixel: float = 0.5
    sigma: float = 0.6
    scale: float = 1.0


ROWS = [
    Row("one focus, 100 stars", 100),
    Row("one focus, 50 stars", 50),
    Row("one focus, 300 stars", 300),
    Row("two foci, 100 stars", 100, (-3.0, 3.0)),
    Row("8 doubles of 100 stars", 100, doubles=8),
    Row("pixels of 2.2 lambda*N", 100, pixel=2.2, sigma=0.3),
    Row("twice the aberrations", 100, scale=2.0),
]


def position(places: Any, pixel: float) -> tuple[Any, Any]:
    """Return x and y of rows and columns."""
    return (places[:, 1] - 1999.5) * pixel, (places[:, 0] - 1999.5) * pixel


def one(row: Row, seed: int, telescope: simulated.Telescope) -> dict[str, float]:
    """Return what a fit of a random field is like."""
    draw = np.random.default_rng(seed)
    waves = simulated.field(draw, scale=row.scale)
    options = {"pixel": row.pixel, "sigma": row.sigma, "defocus": row.defocus, "doubles": row.doubles}
    places, images, true = simulated.stars(draw, row.stars, waves, telescope, **options)
    began = time.process_time()
    fit = searches.fit_field(
        images, places, lm.Pupil(), sensor=SENSOR, pixel=row.pixel, noise=NOISE, defocus=row.defocus, integrate=True
    )
    seconds = time.process_time() - began
    values, errors = fit.at(*position(places, row.pixel))
    signs = (1.0, -1.0) if len(row.defocus) == 1 else (1.0,)
    off = [(values - np.where(EVEN, sign, 1.0) * true) / errors for sign in signs]
    ratios = [float(np.sqrt((z**2).mean())) for z in off]
    z = off[int(np.argmin(ratios))]
    within = [float((np.abs(z) < k).mean()) for k in (1, 2, 3)]
    rejected = ~fit.stars.used
    return {
        "found": float(min(ratios) < 2.0), "converged": float(fit.converged), "ratio": min(ratios),
        "chi2": fit.chi2, "held_out": fit.held_out,
        "caught": float(rejected[: row.doubles].sum()), "lost": float(rejected[row.doubles :].sum()),
        "seconds": seconds, **({f"within {k}": w for k, w in zip((1, 2, 3), within, strict=True)}),
    }  # fmt: skip


def pixels(seed: int, stars: int, telescope: simulated.Telescope) -> tuple[float, float]:
    """Return relative rms errors of PSFs from a fit, and of the best polynomials of pixels."""
    draw = np.random.default_rng(seed)
    waves = simulated.field(draw)
    side = 33
    places, images, _ = simulated.stars(draw, stars, waves, telescope)
    fit = searches.fit_field(images, places, lm.Pupil(), sensor=SENSOR, pixel=0.5, noise=NOISE, integrate=True)
    u, v = draw.uniform(-0.95, 0.95, (2, 20))
    fresh = waves(u, v)
    exact = np.stack([telescope.image(one, (0.0, 0.0), 0.5, side, 0.6) for one in fresh])
    x, y = u * 1000.0, v * 1000.0
    made = lm.psf(fit.field.pupil(x, y), side, 0.5, integrate=True, blur=fit.blur).values
    ours = float(np.sqrt(((made - exact) ** 2).sum() / (exact**2).sum()))
    # The same stars moved from the fitted places to the middle, over their flux, which pixels alone know worse.
    level, flux = fit.stars.background[:, 0], fit.stars.flux[:, 0]
    centre = fit.stars.centers[:, 0] - side // 2
    parts = zip(images[:, 0], level, flux, centre, strict=True)
    moved = np.stack([ndimage.shift((image - b) / f, -c, order=5) for image, b, f, c in parts])
    px, py = position(places, 0.5)
    theirs = np.inf
    for degree in range(4):

        def basis(a: Any, b: Any, degree: int = degree) -> Any:
            return np.stack([a**i * b**j for i in range(degree + 1) for j in range(degree + 1 - i)], axis=-1)

        weight = flux[:, None] / flux.max()
        here, there = basis(px / 1000.0, py / 1000.0), basis(u, v)
        for ridge in (0.0, 1e-3, 1e-2, 1e-1):
            normal = here.T @ (weight * here) + ridge * np.eye(here.shape[1])
            found = np.linalg.solve(normal, here.T @ (weight * moved.reshape(len(moved), -1)))
            guess = (there @ found).reshape(exact.shape)
            theirs = min(theirs, float(np.sqrt(((guess - exact) ** 2).sum() / (exact**2).sum())))
    return ours, theirs


def charts(count: int) -> list[str]:
    """Return rows of charts of 35 crossings, five terms of degree 2: errors over standard errors, chi2, seconds."""
    rows, telescope = [], simulated.Telescope(5)
    for seed in range(count):
        draw = np.random.default_rng(seed)
        waves = simulated.field(draw, 5, degree=2)
        places, images, true = simulated.corners(
            draw, 5, 7, waves, telescope, side=33, pixel=0.5, sigma=0.6, pitch=40.0
        )
        began = time.process_time()
        fit = searches.fit_field(
            images, places, lm.Pupil(), sensor=SENSOR, pixel=0.5, noise=NOISE, degree=2, terms=5, kind="crossing",
            size=20.0, integrate=True,
        )  # fmt: skip
        seconds = time.process_time() - began
        values, errors = fit.at(*position(places, 0.5))
        signs = np.where(EVEN[:5], -1.0, 1.0), np.ones(5)
        ratio = min(float(np.sqrt((((values - sign * true) / errors) ** 2).mean())) for sign in signs)
        rows.append(
            f"chart {seed}: errors over standard errors {ratio:.2f}, chi2 {fit.chi2:.3f}, cpu {seconds:.1f} s"
        )
    return rows


def donuts(count: int) -> list[str]:
    """Return rows of exposures of six defocused stars behind vanes, eight terms of degree 1."""
    pixel, sigma, shape, side = 1.0, 0.8, (600, 900), 71
    vanes = [(0.3 + 0.5 * math.pi * k, 0.03) for k in range(4)]
    telescope = simulated.Telescope(8, side=256, obscuration=0.3, vanes=vanes)
    pupil = lm.Pupil(obscuration=0.3, spider=lm.Spider(angles=tuple(angle for angle, _ in vanes), width=0.03))
    rows = []
    for seed in range(count):
        draw, stated = np.random.default_rng(seed), 15.0 if seed % 2 == 0 else -15.0
        slopes, middle = draw.normal(size=(8, 2)) * 0.15, draw.normal(size=8) * 0.4

        def waves(u: Any, v: Any, slopes: Any = slopes, middle: Any = middle) -> Any:
            return middle + np.multiply.outer(u, slopes[:, 0]) + np.multiply.outer(v, slopes[:, 1])

        image = np.full(shape, 50.0)
        for row, column in np.ndindex(2, 3):
            at = np.array([150 + 300 * row, 150 + 300 * column]) + draw.integers(-60, 61, 2)
            place = draw.uniform(-0.5, 0.5, 2)
            v, u = 2.0 * (at + place + 0.5) / shape - 1.0
            light = telescope.image(waves(u, v), place, pixel, 2 * side + 1, sigma, stated)
            image[tuple(slice(k - side, k + side + 1) for k in at)] += 10.0 ** draw.uniform(5.3, 6.0) * light
        image = draw.poisson(image) + draw.normal(size=shape) * 2.0
        spots = lm.detection.find_spots(image, noise=NOISE, window=side, width=9.0)
        began = time.process_time()
        fit = searches.fit_field(
            spots.windows, spots.places, pupil, sensor=shape, pixel=pixel, noise=NOISE, degree=1, terms=8,
            defocus=stated + draw.uniform(-1.0, 1.0), integrate=True,
        )  # fmt: skip
        seconds = time.process_time() - began
        u, v = (part.ravel() for part in np.meshgrid(np.linspace(-0.9, 0.9, 5), np.linspace(-0.9, 0.9, 5)))
        values, errors = fit.at(u * shape[1] / 2.0 * pixel, v * shape[0] / 2.0 * pixel)
        true = waves(u, v)
        off = (values - true)[:, 1:]  # without what is left of the known defocus
        ratio = float(np.sqrt(np.mean((off / errors[:, 1:]) ** 2)))
        error = float(np.median(errors[:, 1:])) / (2.0 * math.pi)
        rows.append(
            f"donuts {seed}: {len(spots)} stars, {fit.message.partition(':')[0]}, errors over standard errors "
            f"{ratio:.2f}, standard errors {error:.5f} waves, chi2 {fit.chi2:.3f}, cpu {seconds:.1f} s"
        )
    return rows


def fields(settings: Settings) -> Table:
    """Random fields, beside polynomials of pixels."""
    found = Table(
        "fields",
        "The PSF over a field from stars",
        "Random fields of 11 Zernike terms of degree 3 from nothing: 33² pixels of λN/2, blur of 0.6 pixels, "
        "signal-to-noise ratios of 30 to 300, stars by a matrix Fourier transform apart from lommel. Seconds are of "
        "processors. Polynomials of pixels are the best of degrees 0 to 3 and four ridges, chosen by the truth.",
        {"what": "text", "found": "text", "errors over standard errors": "number", "held-out chi2": "number",
         "within 1, 2, 3": "text", "seconds": "number"},
    )  # fmt: skip
    telescope = simulated.Telescope()
    for row in (ROWS[3],) if settings.quick else (ROWS[0], ROWS[1], ROWS[3]):
        settings.tick(row.name)
        made = [one(row, seed, telescope) for seed in range(1 if settings.quick else 5)]
        each = {name: np.array([m[name] for m in made]) for name in made[0]}
        shares = ", ".join(f"{100.0 * each[f'within {k}'].mean():.1f}" for k in (1, 2, 3))
        found.add(
            row.name, f"{each['found'].sum():.0f} of {len(made)}", float(each["ratio"].mean()),
            float(each["held_out"].mean()), f"{shares} %", float(np.median(each["seconds"])),
        )  # fmt: skip
    settings.tick("polynomials of pixels")
    ours, theirs = pixels(0, 50, telescope)
    found.notes.append(
        f"Relative rms error of PSFs from 50 stars: {ours:.2g}, of polynomials of pixels {theirs:.2g}, "
        f"{theirs / ours:.2g} times as much."
    )
    return found


POINTS = 128  # of the pupil, along each side
PIXEL, SIDE, SIGMA = 0.5, 33, 0.6  # units of lambda*N, pixels, pixels
OVER, MARGIN = 5, 4
TRACED_TERMS = range(1, 23)


def spread_places(count: int, draw: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Return places all over the field, from -1 to 1: one in each of so many cells."""
    cells = int(np.ceil(np.sqrt(count)))
    cell = draw.permutation(cells * cells)[:count]
    x, y = ((part + draw.uniform(0.2, 0.8, count)) / cells * 2 - 1 for part in (cell % cells, cell // cells))
    return x, y


def traced_star(field: np.ndarray, grid: np.ndarray, light: float, draw: np.random.Generator) -> np.ndarray:
    """Return electrons of a star anywhere in the middle pixel, blurred, with photon and read noise."""
    pixels = np.arange(-(SIDE // 2) - MARGIN, SIDE - SIDE // 2 + MARGIN)
    points = (pixels[:, None] + (np.arange(OVER) - (OVER - 1) / 2) / OVER).ravel()
    y, x = (PIXEL * (points - part) for part in draw.uniform(-0.5, 0.5, 2))
    made = np.exp(-1j * np.pi * np.outer(y, grid)) @ field @ np.exp(-1j * np.pi * np.outer(grid, x))
    image = ndimage.gaussian_filter(np.abs(made) ** 2 * (PIXEL / OVER) ** 2 / light, SIGMA * OVER, truncate=6)
    image = image.reshape(len(pixels), OVER, len(pixels), OVER).sum((1, 3))[MARGIN:-MARGIN, MARGIN:-MARGIN]
    signal_to_noise = np.exp(draw.uniform(np.log(60), np.log(300)))
    electrons = (1.3 * signal_to_noise**2 + 20 * signal_to_noise) * image + 20
    return draw.poisson(electrons) + 2.0 * draw.normal(size=image.shape)


def traced(given: argparse.Namespace) -> None:
    """Trace a telescope, draw the stars, fit, and print how far the terms are from those of batoid."""
    import batoid

    telescope, draw = batoid.Optic.fromYaml(given.telescope), np.random.default_rng(1)
    inner = telescope.pupilObscuration
    grid = (np.arange(POINTS) - POINTS / 2) / (POINTS / 2 - 1)  # batoid's, whose second point is at the edge
    fine = ((np.arange(8 * POINTS) + 0.5) / 8 - 0.5 - POINTS / 2) / (POINTS / 2 - 1)
    radius = np.hypot(fine, fine[:, None])
    aperture = ((radius <= 1) & (radius >= inner)).reshape(POINTS, 8, POINTS, 8).mean((1, 3))
    rho, theta = np.hypot(grid, grid[:, None]), np.arctan2(grid[:, None], grid)
    shapes = np.array([simulated.zernike(*simulated.noll(j), rho, theta) for j in TRACED_TERMS])
    images, true = [], []
    x, y = spread_places(given.stars, draw)
    for one in np.deg2rad(given.field * np.stack([x, y], axis=1)):
        traced = batoid.wavefront(telescope, *one, given.wavelength, nx=POINTS).array  # waves
        seen = ~traced.mask
        terms = np.linalg.lstsq(shapes[:, seen].T, traced.data[seen], rcond=None)[0]
        # Cells at the edge whose middle no ray meets take the terms.
        waves = np.where(seen, np.where(seen, traced.data, 0.0), np.tensordot(terms, shapes, 1))
        field = aperture * np.exp(2j * np.pi * waves)
        images.append(traced_star(field, grid, aperture.sum() * (POINTS - 2) ** 2, draw))
        true.append(2 * np.pi * terms[3 : 3 + given.terms])
    at = np.rint((np.stack([y, x], axis=1) + 1) * SENSOR[0] / 2 - 0.5)
    began = time.process_time()
    fit = searches.fit_field(
        np.array(images), at, lm.Pupil(obscuration=inner), sensor=SENSOR, pixel=PIXEL, integrate=True,
        noise=lm.Noise(read=2.0), degree=given.degree, terms=given.terms, threads=1,
    )  # fmt: skip
    spent = time.process_time() - began
    values, errors = fit.at(*((at[:, axis] - (SENSOR[0] - 1) / 2) * PIXEL for axis in (1, 0)))
    even = np.array([simulated.noll(j)[1] % 2 == 0 for j in range(4, 4 + given.terms)])
    # One focus does not tell the sign of the even terms.
    off = min((values - np.where(even, sign, 1) * np.array(true) for sign in (1, -1)), key=lambda d: (d**2).sum())
    rms = float(np.sqrt((np.array(true) ** 2).sum(axis=1)).mean() / (2 * np.pi))
    print(f"{given.telescope}: {given.stars} stars, wavefronts of {rms:.2f} waves rms in {given.terms} terms")
    print(f"{fit.message}; {spent:.0f} seconds of the processor")
    print(f"a term is {np.sqrt((off**2).mean()) / (2 * np.pi):.4f} waves rms off batoid's, "
          f"{np.sqrt(((off / errors) ** 2).mean()):.2f} standard errors")  # fmt: skip


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--fields", type=int, default=2, help="random fields of each row")
    parser.add_argument("--rows", type=int, nargs="*", default=[0, 1, 3], help="rows, from 0; all without a number")
    parser.add_argument("--charts", type=int, default=0, help="charts of 35 crossings")
    parser.add_argument("--donuts", type=int, default=0, help="exposures of six defocused stars")
    parser.add_argument("--telescope", help="a file of batoid, as SDSS.yaml: only its field, with the options below")
    parser.add_argument("--wavelength", type=float, default=622e-9, help="metres")
    parser.add_argument("--field", type=float, default=0.5, help="half of the width of the field, degrees")
    parser.add_argument("--stars", type=int, default=60)
    parser.add_argument("--terms", type=int, default=14)
    parser.add_argument("--degree", type=int, default=4)
    chosen = parser.parse_args()
    if chosen.telescope:
        traced(chosen)
        return
    if chosen.charts or chosen.donuts:
        print("\n".join([*charts(chosen.charts), *donuts(chosen.donuts)]))
        return
    telescope = simulated.Telescope()
    print("| stars | found | converged | error over bound | chi2 | held out | doubles caught, others lost | cpu s |")
    print("|---|---|---|---|---|---|---|---|")
    for k in chosen.rows or range(len(ROWS)):
        row = ROWS[k]
        made = [one(row, seed, telescope) for seed in range(chosen.fields)]
        each = {name: np.array([m[name] for m in made]) for name in made[0]}
        ratio = each["ratio"][each["found"] > 0]
        print(
            f"| {row.name} | {each['found'].sum():.0f} of {len(made)} | {each['converged'].sum():.0f} | "
            f"{ratio.mean():.2f} ({ratio.min():.2f} to {ratio.max():.2f}) | {each['chi2'].mean():.3f} | "
            f"{np.nanmean(each['held_out']):.3f} | {each['caught'].mean():.1f}, {each['lost'].mean():.1f} | "
            f"{np.median(each['seconds']):.1f} ({each['seconds'].max():.1f}) |",
            flush=True,
        )
    for count in (50, 100)[: 1 + (chosen.fields > 2)]:
        ours, theirs = np.array([pixels(seed, count, telescope) for seed in range(min(chosen.fields, 24))]).T
        print(
            f"{count} stars: relative rms error of PSFs {ours.mean():.4f}, of polynomials of pixels "
            f"{theirs.mean():.3f}, ratio {np.min(theirs / ours):.1f} at least"
        )


if __name__ == "__main__":
    main()
