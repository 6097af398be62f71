"""The field of a telescope that batoid traces, found from images of stars.

batoid's own path differences are made into images by a matrix Fourier transform that shares nothing with the package,
and what :func:`lommel.fit_field` finds is compared with Zernike terms of those path differences. It needs batoid
(``pip install batoid``): ``python benchmarks/traced_telescope.py --telescope SDSS.yaml --terms 14 --degree 4``.
"""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path

import batoid
import numpy as np
from scipy import ndimage

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests" / "shared"))

import lommel as lm
from simulated_fields import noll, zernike

POINTS = 128  # of the pupil, along each side
SENSOR, PIXEL, SIDE, SIGMA = 4000, 0.5, 33, 0.6  # pixels, units of lambda*N, pixels, pixels
OVER, MARGIN = 5, 4
TERMS = range(1, 23)


def places(count: int, draw: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Return places all over the field, from -1 to 1: one in each of so many cells."""
    cells = int(np.ceil(np.sqrt(count)))
    cell = draw.permutation(cells * cells)[:count]
    x, y = ((part + draw.uniform(0.2, 0.8, count)) / cells * 2 - 1 for part in (cell % cells, cell // cells))
    return x, y


def star(field: np.ndarray, grid: np.ndarray, light: float, draw: np.random.Generator) -> np.ndarray:
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


def main(arguments: list[str] | None = None) -> None:
    """Trace, draw the stars, fit, and print how far the terms are from those of batoid."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--telescope", default="SDSS.yaml", help="a file of batoid")
    parser.add_argument("--wavelength", type=float, default=622e-9, help="metres")
    parser.add_argument("--field", type=float, default=0.5, help="half of the width of the field, degrees")
    parser.add_argument("--stars", type=int, default=60)
    parser.add_argument("--terms", type=int, default=14)
    parser.add_argument("--degree", type=int, default=4)
    given = parser.parse_args(arguments)
    telescope, draw = batoid.Optic.fromYaml(given.telescope), np.random.default_rng(1)
    inner = telescope.pupilObscuration
    grid = (np.arange(POINTS) - POINTS / 2) / (POINTS / 2 - 1)  # batoid's, whose second point is at the edge
    fine = ((np.arange(8 * POINTS) + 0.5) / 8 - 0.5 - POINTS / 2) / (POINTS / 2 - 1)
    radius = np.hypot(fine, fine[:, None])
    aperture = ((radius <= 1) & (radius >= inner)).reshape(POINTS, 8, POINTS, 8).mean((1, 3))
    rho, theta = np.hypot(grid, grid[:, None]), np.arctan2(grid[:, None], grid)
    shapes = np.array([zernike(*noll(j), rho, theta) for j in TERMS])
    images, true = [], []
    x, y = places(given.stars, draw)
    for one in np.deg2rad(given.field * np.stack([x, y], axis=1)):
        traced = batoid.wavefront(telescope, *one, given.wavelength, nx=POINTS).array  # waves
        seen = ~traced.mask
        terms = np.linalg.lstsq(shapes[:, seen].T, traced.data[seen], rcond=None)[0]
        # Cells at the edge whose middle no ray meets take the terms.
        waves = np.where(seen, np.where(seen, traced.data, 0.0), np.tensordot(terms, shapes, 1))
        field = aperture * np.exp(2j * np.pi * waves)
        images.append(star(field, grid, aperture.sum() * (POINTS - 2) ** 2, draw))
        true.append(2 * np.pi * terms[3 : 3 + given.terms])
    at = np.rint((np.stack([y, x], axis=1) + 1) * SENSOR / 2 - 0.5)
    began = time.process_time()
    fit = lm.fit_field(
        np.array(images), at, lm.Pupil(obscuration=inner), sensor=(SENSOR, SENSOR), pixel=PIXEL, integrate=True,
        noise=lm.Noise(read=2.0), degree=given.degree, terms=given.terms, threads=1,
    )  # fmt: skip
    spent = time.process_time() - began
    values, errors = fit.at(*((at[:, axis] - (SENSOR - 1) / 2) * PIXEL for axis in (1, 0)))
    even = np.array([noll(j)[1] % 2 == 0 for j in range(4, 4 + given.terms)])
    # One focus does not tell the sign of the even terms.
    off = min((values - np.where(even, sign, 1) * np.array(true) for sign in (1, -1)), key=lambda d: (d**2).sum())
    rms = float(np.sqrt((np.array(true) ** 2).sum(axis=1)).mean() / (2 * np.pi))
    print(f"{given.telescope}: {given.stars} stars, wavefronts of {rms:.2f} waves rms in {given.terms} terms")
    print(f"{fit.message}; {spent:.0f} seconds of the processor")
    print(f"a term is {np.sqrt((off**2).mean()) / (2 * np.pi):.4f} waves rms off batoid's, "
          f"{np.sqrt(((off / errors) ** 2).mean()):.2f} standard errors")  # fmt: skip


if __name__ == "__main__":
    main()
