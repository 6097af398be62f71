"""Images behind straight vanes, which cut strips out of an annulus, are within their bounds."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm
from lommel.methods import ChordalGauss, NonuniformFFT
from lommel.methods.choice import candidates
from lommel.optics.grid import Grid
from lommel.special.legendre import gauss_legendre

TERMS = [(2, 0), (2, -2), (2, 2), (3, -1), (3, 1), (4, 0), (3, 3), (5, 1)]


def vaned(seed: int, *, stack: int = 2, tilt: float = 0.0) -> lm.Pupil:
    """Return a stack of aberrated pupils behind random vanes that part within the obscuration."""
    rng = np.random.default_rng(seed)
    count, obscuration = int(rng.integers(1, 7)), float(rng.uniform(0.15, 0.45))
    angles = rng.uniform(0.0, 2.0 * math.pi) + 2.0 * math.pi / count * (
        np.arange(count) + rng.uniform(0.0, 0.2, count)
    )
    spider = lm.Spider(float(rng.uniform(0.005, 0.06)), tuple(angles.tolist()))
    wavefront = lm.Wavefront.zernike(
        {term: rng.normal(0.0, 0.3, stack) for term in TERMS} | {(1, 1): rng.normal(0.0, tilt, stack)},
        normalization="rms",
    )
    gaussian = float(rng.uniform(0.0, 1.0)) if seed % 3 == 0 else 0.0
    return lm.Pupil(wavefront, obscuration=obscuration, spider=spider, apodization=gaussian)


def quadrature(pupil: lm.Pupil, grid: Grid) -> np.ndarray:
    """Return I by sums over the annulus in rings, less those over each vane across and along."""
    r, w = gauss_legendre(60, pupil.obscuration, 1.0)
    theta = 2.0 * math.pi / 160 * (np.arange(160) + 0.5)
    x, y = np.outer(r, np.cos(theta)), np.outer(r, np.sin(theta))
    parts = [(x, y, np.outer(w * r, np.full(160, 2.0 / 160)))]
    spider = pupil.spider
    assert spider is not None
    s, ds = gauss_legendre(14, -0.5 * spider.width, 0.5 * spider.width)
    for angle in spider.angles:
        start, end = np.sqrt(pupil.obscuration**2 - s**2), np.sqrt(1.0 - s**2)
        t, dt = gauss_legendre(40, 0.0, 1.0)
        along = start[:, None] + (end - start)[:, None] * t
        c, d = math.cos(angle), math.sin(angle)
        weight = -np.outer(ds * (end - start), dt) / math.pi
        parts.append((c * along - d * s[:, None], d * along + c * s[:, None], weight))
    field = 0.0
    wide = lm.Pupil(pupil.wavefront, obscuration=0.0, apodization=pupil.apodization)
    for x, y, weight in parts:
        values = (wide.values(x, y) * weight).reshape(*pupil.shape, -1)
        across = np.exp(-1j * math.pi / pupil.scale * np.outer(x.ravel(), grid.x))
        down = np.exp(-1j * math.pi / pupil.scale * np.outer(y.ravel(), grid.y))
        field = field + np.einsum("pk,ky,kx->pyx", values, down, across, optimize=True)
    return np.asarray(np.abs(field) ** 2)


@pytest.mark.parametrize(
    ("seed", "tol", "dtype"),
    [(1, 1e-2, "f4"), (2, 1e-4, "f4"), (3, 1e-5, "f4"), (4, 1e-6, "f8"), (5, 1e-8, "f8"), (6, 1e-9, "f8")],
)
def test_images_behind_vanes_keep_their_bounds(seed: int, tol: float, dtype: str) -> None:
    pupil = vaned(seed, tilt=1.0)
    pixel, shape, center = 0.3 + 0.1 * seed, (11, 14), (4.0, 8.5) if seed % 2 else None
    image = lm.psf(pupil, pixel=pixel, shape=shape, center=center, method=ChordalGauss(tol), dtype=dtype, threads=1)
    exact = quadrature(pupil, Grid(shape, pixel, center=center))
    found = np.asarray(image) / np.asarray(image.scale)[..., None, None]
    wrong = np.abs(found - exact).max(axis=(-2, -1)) / exact.max(axis=(-2, -1))
    assert np.all(wrong <= np.asarray(image.error_bound))
    assert np.all(np.asarray(image.error_bound) <= tol)


@pytest.mark.parametrize("integrate", [False, True])
def test_derivatives_behind_vanes_are_those_of_the_sums_over_rows(integrate: bool) -> None:
    pupil = vaned(7, stack=3)
    names: list[str | tuple[int, int]] = [(2, 0), (3, -1), (6, 2), "row", "column"]
    image, other = (
        lm.psf(pupil, (9, 12), 0.7, integrate=integrate, derivatives=names, dtype="f8", threads=1, method=method)
        for method in (ChordalGauss(1e-7), NonuniformFFT(1e-9))
    )
    peak = float(np.asarray(other).max())
    np.testing.assert_allclose(np.asarray(image), np.asarray(other), rtol=0.0, atol=2e-7 * peak)
    for name in names:
        np.testing.assert_allclose(
            np.asarray(image.derivatives[name]), np.asarray(other.derivatives[name]), rtol=0.0, atol=1e-6 * peak
        )


def test_vanes_are_strips_where_they_part_within_the_obscuration() -> None:
    def strips(spider: lm.Spider, obscuration: float = 0.3) -> np.ndarray | None:
        return lm.Pupil(obscuration=obscuration, spider=spider).strips

    four, three = strips(lm.Spider.equal(4, width=0.02, first=0.5)), strips(lm.Spider.equal(3, width=0.02))
    assert four is not None
    assert three is not None
    assert [len(four), len(three)] == [2, 3]  # opposite vanes are one strip
    assert strips(lm.Spider.equal(4, width=0.02), obscuration=0.0) is None
    assert strips(lm.Spider.equal(6, width=0.28)) is None  # neighbours meet outside of the obscuration
    assert strips(lm.Spider(0.02, (0.0, 0.05))) is None
    assert lm.Pupil(obscuration=0.3, spider=lm.Spider.equal(4, width=0.02), stop=lm.Disc()).strips is None


def test_sums_over_rows_compute_what_strips_do_not() -> None:
    pupil = lm.Pupil(obscuration=0.3, spider=lm.Spider.equal(4, width=0.02, first=0.5))
    meeting = lm.Pupil(obscuration=0.1, spider=lm.Spider.equal(4, width=0.2))
    near, far = (lm.psf(each, pixel=0.5, shape=9, tol=1e-5) for each in (pupil, meeting))
    assert isinstance(near.method, ChordalGauss)
    assert isinstance(far.method, NonuniformFFT)
    assert [type(method) for method in candidates(pupil, Grid(9, 0.5))] == [ChordalGauss, NonuniformFFT]
    # Wide vanes and a large window take more lines than strips have.
    many = lm.Pupil(obscuration=0.5, spider=lm.Spider.equal(3, width=0.3))
    assert isinstance(lm.psf(many, pixel=4.0, shape=33, tol=1e-8, dtype="f8").method, NonuniformFFT)
