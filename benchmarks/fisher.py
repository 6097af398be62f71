"""The inverse of Fisher's matrix against the covariance of many fits to new noise.

    python benchmarks/fisher.py [1000]

Prints, for each parameter of a star out of focus, the standard error that :func:`lommel.fisher` tells, the scatter of
fits of largest likelihood over it, and their mean error over that of a mean; then the largest difference between the
two covariances, in units of the standard errors.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import lommel as lm
from lommel.estimation.fisher import Information

NAMES = ("defocus", "spherical", "row", "column", "photons", "background")
TRUTH = np.array([3.0, 1.5, 9.7, 10.4, 20_000.0, 5.0])
NOISE = lm.Noise(read=2.0)
SHAPE, PIXEL = 21, 2.2e-6
LIGHT = {"wavelength": 550e-9, "f_number": 5.6}


@dataclass(frozen=True)
class Compared:
    """What fits scatter by, and what they were told to."""

    told: Information
    fits: NDArray[np.float64]

    @property
    def errors(self) -> NDArray[np.float64]:
        """Return what is told."""
        return np.array([self.told.errors[name] for name in NAMES])

    @property
    def scatter(self) -> NDArray[np.float64]:
        """Return the standard error of the fits over that."""
        return np.asarray(self.fits.std(axis=0, ddof=1) / self.errors)

    @property
    def bias(self) -> NDArray[np.float64]:
        """Return their mean error over the standard error of a mean of so many."""
        return np.asarray((self.fits.mean(axis=0) - TRUTH) / self.errors * np.sqrt(len(self.fits)))

    @property
    def difference(self) -> float:
        """Return the largest difference between the covariances over the standard errors of both parameters."""
        found = np.cov(self.fits.T) - self.told.covariance
        return float(np.abs(found / np.outer(self.errors, self.errors)).max())


def compared(count: int, seed: int) -> Compared:
    """Fit images of one star, each with noise of its own, by Fisher's scoring."""
    told = lm.fisher(
        lm.Pupil(lm.Wavefront(*TRUTH[:2]), **LIGHT),
        SHAPE,
        PIXEL,
        of=NAMES,
        photons=TRUTH[4],
        background=TRUTH[5],
        noise=NOISE,
        center=tuple(TRUTH[2:4]),
    )
    images = NOISE.record(np.broadcast_to(_model(TRUTH[None])[0], (count, SHAPE, SHAPE)), seed).reshape(count, -1)
    fits = np.tile(TRUTH, (count, 1))
    for _ in range(20):
        mean, slopes = (part.reshape(*part.shape[:-2], -1) for part in _model(fits))
        weight = 1.0 / (mean + NOISE.read**2)
        matrix = np.einsum("anq,bnq,nq->nab", slopes, slopes, weight, optimize=True)
        score = np.einsum("anq,nq->na", slopes, weight * (images - mean))
        step = np.linalg.solve(matrix, score[..., None])[..., 0]
        fits += step
        if np.abs(step * np.sqrt(np.diagonal(matrix, axis1=1, axis2=2))).max() < 1e-3:
            return Compared(told, fits)
    raise ArithmeticError("the fits did not come to rest")


def _model(parameters: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the mean of images, and their derivatives, for rows of parameters."""
    defocus, spherical, row, column, photons, background = parameters.T
    pupil = lm.Pupil(lm.Wavefront(defocus, spherical), **LIGHT)
    answer = lm.psf(pupil, SHAPE, PIXEL, center=(row, column), derivatives=NAMES[:4], tol=1e-7, dtype=np.float64)
    photons, background = photons[:, None, None], background[:, None, None]
    slopes = [photons * answer.derivatives[name] for name in NAMES[:4]]
    return photons * answer.values + background, np.stack([*slopes, answer.values, np.ones_like(answer.values)])


def main(count: int) -> None:
    """Compare, and print."""
    found = compared(count, seed=1)
    print(f"{count} fits: standard error told; scatter over it; mean error over that of a mean")
    for name, told, scatter, bias in zip(NAMES, found.errors, found.scatter, found.bias, strict=True):
        print(f"  {name:10} {told:.4g} {found.told.units[name]:16} {scatter:.3f}  {bias:+.1f}")
    print(f"largest difference of the covariances over the standard errors: {found.difference:.3f}")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 1000)
