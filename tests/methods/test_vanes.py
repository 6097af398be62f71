"""Images behind straight vanes, which cut strips out of an annulus, are within their bounds."""

from __future__ import annotations

import dataclasses
import math
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import lommel as lm
from disk_questions import aperture
from lommel.core.answers import Declined, Wanted
from lommel.methods import ChordalGauss, NonuniformFFT
from lommel.methods.choice import candidates
from lommel.methods.chordal_gauss import ChordalIfCheaper
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


def offset(seed: int, *, stack: int = 1) -> tuple[lm.Pupil, list[tuple[float, float, float]]]:
    """Return pupils whose stop lacks a disc and strips off the axis, and direction and range across of each strip."""
    rng, start = np.random.default_rng(seed), float(np.random.default_rng(seed).uniform(0.2, 0.4))
    turn, opening, width = rng.uniform(0.0, 6.0), rng.uniform(0.7, 1.2), rng.uniform(0.005, 0.08) * start
    stop, vanes = lm.Disc() - lm.Disc(start), []
    for side in (0.0, math.pi):
        # Two vanes from a point within the obscuration, as of large telescopes; one is wider than the other.
        x, y = (start * rng.uniform(0.3, 0.8) * each for each in (math.cos(turn + side), math.sin(turn + side)))
        for angle, wide in ((turn + side + opening, width), (turn + side - opening, 1.5 * width)):
            c, s = math.cos(angle), math.sin(angle)
            stop = stop - lm.Polygon.strip((x, y), (x + 2.5 * c, y + 2.5 * s), wide)
            middle = y * c - x * s
            vanes.append((angle, middle - 0.5 * wide, middle + 0.5 * wide))
    wavefront = lm.Wavefront.zernike({term: rng.normal(0.0, 0.3, stack) for term in TERMS}, normalization="rms")
    return lm.Pupil(wavefront, stop=stop, apodization=0.4 * (seed % 2)), vanes


def quadrature(
    pupil: lm.Pupil,
    grid: Any,
    vanes: list[tuple[float, float, float]] | None = None,
    rings: int = 60,
    around: int = 160,
) -> np.ndarray:
    """Return I at grid.y, grid.x by sums over the annulus in rings, less those over each vane across and along."""
    assert pupil.strips is not None
    inner = pupil.strips[0]
    r, w = gauss_legendre(rings, inner, 1.0)
    theta = 2.0 * math.pi / around * (np.arange(around) + 0.5)
    x, y = np.outer(r, np.cos(theta)), np.outer(r, np.sin(theta))
    parts = [(x, y, np.outer(w * r, np.full(around, 2.0 / around)))]
    if vanes is None:
        spider = pupil.spider
        assert spider is not None
        vanes = [(angle, -0.5 * spider.width, 0.5 * spider.width) for angle in spider.angles]
    for angle, low, high in vanes:
        s, ds = gauss_legendre(14, low, high)
        start, end = np.sqrt(inner**2 - s**2), np.sqrt(1.0 - s**2)
        t, dt = gauss_legendre(2 * rings // 3, 0.0, 1.0)
        along = start[:, None] + (end - start)[:, None] * t
        c, d = math.cos(angle), math.sin(angle)
        weight = -np.outer(ds * (end - start), dt) / math.pi
        parts.append((c * along - d * s[:, None], d * along + c * s[:, None], weight))
    return np.asarray(np.abs(field_of(pupil, grid, parts)) ** 2)


def clear_parts(pupil: lm.Pupil, bars: list[tuple[float, float]]) -> list[tuple[np.ndarray, np.ndarray, np.ndarray]]:
    """Return nodes and weights between vanes from the axis, in polar coordinates, or between horizontal bars."""
    t, w = gauss_legendre(40, 0.0, 1.0)
    parts = []
    if pupil.spider is None:
        edges = [-1.0, *(edge for bar in bars for edge in bar), 1.0]
        for low, high in zip(edges[::2], edges[1::2], strict=True):
            turn = math.asin(low) + (math.asin(high) - math.asin(low)) * t
            x, y = np.outer(np.cos(turn), 2.0 * t - 1.0), np.repeat(np.sin(turn)[:, None], 40, axis=1)
            weight = np.outer(w * np.cos(turn) ** 2, w) * 2.0 * (math.asin(high) - math.asin(low)) / math.pi
            parts.append((x, y, weight))
        return parts
    angles, half = sorted(pupil.spider.angles), 0.5 * pupil.spider.width
    for a, b in zip(angles, [*angles[1:], angles[0] + 2.0 * math.pi], strict=True):
        apex = np.linalg.solve([(-math.sin(a), math.cos(a)), (-math.sin(b), math.cos(b))], [half, -half])
        c, s = np.cos(a + (b - a) * t), np.sin(a + (b - a) * t)
        along = apex[0] * c + apex[1] * s
        radius = np.outer(np.sqrt(along**2 + 1.0 - apex @ apex) - along, t)
        weight = np.outer(w, w) * radius**2 / t * (b - a) / math.pi
        parts.append((apex[0] + radius * c[:, None], apex[1] + radius * s[:, None], weight))
    return parts


def field_of(pupil: lm.Pupil, grid: Grid, parts: list[tuple[np.ndarray, np.ndarray, np.ndarray]]) -> np.ndarray:
    """Return U by sums over nodes x, y with weights."""
    field = np.zeros((*pupil.shape, *grid.shape), dtype=complex)
    wide = lm.Pupil(pupil.wavefront, obscuration=0.0, apodization=pupil.apodization)
    for x, y, weight in parts:
        values = (wide.values(x, y) * weight).reshape(*pupil.shape, -1)
        across = np.exp(-1j * math.pi / pupil.scale * np.outer(x.ravel(), grid.x))
        down = np.exp(-1j * math.pi / pupil.scale * np.outer(y.ravel(), grid.y))
        field += np.einsum("pk,ky,kx->pyx", values, down, across, optimize=True)
    return field


def within_bounds(
    pupil: lm.Pupil,
    grid: Grid,
    tol: float,
    dtype: str,
    vanes: list[tuple[float, float, float]] | None = None,
    exact: np.ndarray | None = None,
) -> None:
    """Require that images are within their bounds, these within the tolerance."""
    shape, pixel, center = grid.shape, grid.pixel, grid.center
    image = lm.psf(pupil, pixel=pixel, shape=shape, center=center, method=ChordalGauss(tol), dtype=dtype, threads=1)
    exact = quadrature(pupil, grid, vanes) if exact is None else exact
    found = np.asarray(image) / np.asarray(image.scale)[..., None, None]
    wrong = np.abs(found - exact).max(axis=(-2, -1)) / exact.max(axis=(-2, -1))
    assert np.all(wrong <= np.asarray(image.error_bound))
    assert np.all(np.asarray(image.error_bound) <= tol)


@pytest.mark.parametrize(
    ("seed", "tol", "dtype", "stack"),
    [
        (1, 1e-2, "f4", 2),
        (2, 1e-4, "f4", 9),
        (3, 1e-5, "f4", 1),
        (4, 1e-6, "f8", 5),
        (5, 1e-8, "f8", 2),
        (6, 1e-9, "f8", 5),
    ],
)
def test_images_behind_vanes_keep_their_bounds(seed: int, tol: float, dtype: str, stack: int) -> None:
    grid = Grid((11, 14), 0.3 + 0.1 * seed, center=(4.0, 8.5) if seed % 2 else None)
    within_bounds(vaned(seed, tilt=1.0, stack=stack), grid, tol, dtype)


@pytest.mark.parametrize("first", [0.0, 1e-9, 0.5, 0.25 * math.pi, 1.3])
@pytest.mark.parametrize(("tol", "dtype"), [(1e-5, "f4"), (1e-9, "f8")])
def test_a_single_image_shares_weights_along_rows_and_columns(first: float, tol: float, dtype: str) -> None:
    # More rows and columns than vectors have lanes, neither a multiple of them; pixels of several places each.
    pupil = dataclasses.replace(vaned(8, stack=1), spider=lm.Spider.equal(4, width=0.03, first=first))
    within_bounds(pupil, Grid((37, 18), 0.9, center=(5.0, 2.5)), tol, dtype)


@pytest.mark.parametrize(
    ("seed", "tol", "dtype", "stack"), [(1, 1e-4, "f4", 9), (2, 1e-5, "f4", 1), (3, 1e-8, "f8", 5)]
)
def test_vanes_off_the_axis_keep_their_bounds(seed: int, tol: float, dtype: str, stack: int) -> None:
    pupil, vanes = offset(seed, stack=stack)
    within_bounds(pupil, Grid((12, 19), 0.4 + 0.2 * seed), tol, dtype, vanes)


@pytest.mark.parametrize(
    ("angles", "bars", "lines"),
    [
        ((0.3, 0.3 + 0.5 * math.pi, 0.3 + math.pi, 0.3 + 1.5 * math.pi), [], 2),
        ((0.1, 2.0, 4.4), [], 6),
        ((0.2, 0.9, 2.6, 0.2 + math.pi, 4.4), [], 10),
        ((0.2, 1.2, 0.2 + math.pi, 1.2 + math.pi), [], 4),
        (None, [(0.2, 0.25)], 1),
        (None, [(-0.03, 0.03)], 1),
        (None, [(-0.6, -0.52), (-0.03, 0.03), (0.3, 0.33)], 3),
    ],
)
@pytest.mark.parametrize(("tol", "dtype", "stack"), [(1e-4, "f4", 9), (1e-5, "f4", 1), (1e-9, "f8", 2)])
def test_vanes_without_an_obscuration_keep_their_bounds(
    angles: tuple[float, ...] | None, bars: list[tuple[float, float]], lines: int, tol: float, dtype: str, stack: int
) -> None:
    rng, stop = np.random.default_rng(stack), lm.Disc()
    for low, high in bars:
        stop = stop - lm.Polygon.strip((-2.0, 0.5 * (low + high)), (2.0, 0.5 * (low + high)), high - low)
    wavefront = lm.Wavefront.zernike({term: rng.normal(0.0, 0.3, stack) for term in TERMS}, normalization="rms")
    pupil = lm.Pupil(
        wavefront,
        spider=None if angles is None else lm.Spider(0.06, angles),
        stop=stop if angles is None else None,
        apodization=0.3,
    )
    assert pupil.strips is not None
    assert pupil.strips[0] == 0.0
    assert len(pupil.strips[1]) == lines
    grid = Grid((9, 10), 0.8, center=(3.0, 4.5))
    within_bounds(pupil, grid, tol, dtype, exact=np.abs(field_of(pupil, grid, clear_parts(pupil, bars))) ** 2)


@pytest.mark.parametrize("angles", [(0.4,), (0.4, 1.1), (0.4, 0.4 + math.pi), (0.0, 1.0, 2.0)])
def test_vanes_end_at_the_axis_where_none_is_near(angles: tuple[float, ...]) -> None:
    wavefront = lm.Wavefront.zernike({(2, 0): [0.3, 0.1], (3, 1): [0.2, -0.4]}, normalization="rms")
    pupil = lm.Pupil(wavefront, spider=lm.Spider(0.2, angles))
    other = lm.psf(pupil, (9, 11), 0.7, method=NonuniformFFT(1e-10), dtype="f8", normalize="strehl")
    within_bounds(
        pupil, Grid((9, 11), 0.7), 1e-7, "f8", exact=np.asarray(other) / np.asarray(other.scale)[..., None, None]
    )


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


@pytest.mark.parametrize("pixel", [0.6, 2.5])
def test_averages_of_one_and_of_many_pupils_are_the_same(pixel: float) -> None:
    pupil = vaned(11, stack=5)
    window: Any = {"pixel": pixel, "shape": (9, 8), "integrate": True, "dtype": "f8", "threads": 1}
    many, other = (lm.psf(pupil, method=method, **window) for method in (ChordalGauss(1e-6), NonuniformFFT(1e-8)))
    one = lm.psf(pupil[2], method=ChordalGauss(1e-6), **window)
    peak = np.asarray(other).max(axis=(1, 2))
    assert np.all(np.abs(np.asarray(many) - np.asarray(other)).max(axis=(1, 2)) <= 1.1e-6 * peak)
    assert np.abs(np.asarray(one) - np.asarray(other)[2]).max() <= 1.1e-6 * peak[2]
    assert float(one.error_bound) <= 1e-6


@pytest.mark.parametrize(
    ("seed", "gaussian", "tol", "count"), [(3, 0.0, 1e-4, 32), (7, 0.0, 1e-5, 88), (5, 0.6, 3e-4, 18)]
)
def test_averages_far_from_the_axis_keep_their_bounds(seed: int, gaussian: float, tol: float, count: int) -> None:
    # The window is too wide for nodes of all pixels: those far from the axis follow from rims and strips.
    pixel, side = 5.5, 27
    pupil = dataclasses.replace(vaned(seed, stack=count, tilt=1.0), apodization=gaussian)
    image = lm.psf(pupil, side, pixel, integrate=True, method=ChordalGauss(tol), dtype="f8", threads=1)
    assert np.all(np.asarray(image.error_bound) <= tol)
    spider = pupil.spider
    assert spider is not None
    middle, (t, w) = side // 2, gauss_legendre(16, -0.5, 0.5)
    # Pixels on the spike of a vane, beside it, and between spikes; of all quadrants.
    across = spider.angles[0] + 0.5 * math.pi
    polar = [(4.0, 0.0), (9.0, 0.0), (12.0, math.pi), (7.8, 2.24), (6.4, 5.4), (6.0, 0.8), (8.0, 0.3)]
    averages = np.asarray(image) / np.asarray(image.scale).reshape(-1, 1, 1)
    bounds = np.broadcast_to(image.error_bound, count) * averages.max(axis=(1, 2))
    for i, (radius, turn) in enumerate(polar):
        angle = across + turn
        row, column = (round(middle + radius * each) for each in (math.sin(angle), math.cos(angle)))
        y, x = pixel * (row - middle + t), pixel * (column - middle + t)
        points = SimpleNamespace(shape=(len(t), len(t)), y=y, x=x)
        p = 5 * i % count
        exact = w @ quadrature(pupil[p : p + 1], points, rings=160, around=600)[0] @ w
        assert abs(averages[p, row, column] - exact) <= bounds[p]


def test_vanes_are_strips_where_they_part_within_the_obscuration() -> None:
    def strips(**aperture: Any) -> int:
        found = lm.Pupil(**aperture).strips
        return 0 if found is None else len(found[1])

    equal = lm.Spider.equal
    assert strips(obscuration=0.3, spider=equal(4, width=0.02, first=0.5)) == 2  # opposite vanes are one strip
    assert strips(obscuration=0.3, spider=equal(3, width=0.02)) == 3
    assert (
        strips(spider=equal(4, width=0.02, first=0.5)) == 2
    )  # each vane, with its mirror image and the opposite one
    assert strips(spider=equal(3, width=0.02)) == 3
    assert strips(spider=lm.Spider(0.02, (0.0, 1.0))) == 4  # halves of a vane begin at different lines
    assert strips(spider=lm.Spider(0.02, (0.0, 1.0, 3.0, 4.0))) == 8
    assert strips(spider=equal(2, width=0.02)) == 1
    assert strips(spider=lm.Spider(0.02, (0.0, 0.02))) == 0  # neighbours meet far from the axis
    assert strips(spider=lm.Spider(0.02, (0.0, 0.0))) == 0
    assert strips(spider=equal(1, width=1.7)) == 0
    assert strips(obscuration=0.3, spider=equal(6, width=0.28)) == 3
    assert strips(obscuration=0.3, spider=equal(6, width=0.32)) == 0  # neighbours meet outside of the obscuration
    assert strips(obscuration=0.3, spider=lm.Spider(0.02, (0.0, 0.05))) == 0
    assert strips(obscuration=0.3, spider=lm.Spider(0.52, (0.0,))) == 0  # almost as wide as the obscuration


def test_a_stop_lacks_strips_that_begin_within_its_obscuration() -> None:
    strip, annulus = lm.Polygon.strip, lm.Disc() - lm.Disc(0.3)
    across, half = strip((-1.5, 0.1), (1.5, 0.1), 0.02), strip((0.1, 0.0), (0.1, 2.0), 0.02)

    def strips(stop: lm.Shape) -> int:
        found = lm.Pupil(stop=stop, obscuration=0.2).strips
        assert found is None or found[0] == 0.3
        return 0 if found is None else len(found[1])

    assert strips(annulus - across) == 1
    assert strips(annulus - half) == 1
    assert strips(annulus - (across | half)) == 2
    assert strips(annulus - half - half.turned(0.5 * math.pi)) == 2
    assert strips(annulus - half - half.turned(math.pi)) == 1
    assert strips(annulus - half - strip((0.1, 0.0), (0.1, -2.0), 0.02)) == 1  # opposite vanes
    assert strips(lm.Disc() & (annulus - lm.Spider.equal(4, width=0.02))) == 2
    assert strips(annulus) == 0
    assert strips(annulus - strip((0.1, 0.0), (0.1, 0.9), 0.02)) == 0  # ends before the rim
    assert strips(annulus - strip((0.1, 0.4), (0.1, 2.0), 0.02)) == 0  # begins outside of the obscuration
    assert strips(annulus - strip((0.1, -0.4), (0.1, 2.0), 0.02)) == 0  # sticks out on the other side
    assert strips(annulus - strip((0.28, 0.0), (0.28, 2.0), 0.02)) == 0  # too far from the axis
    assert strips(annulus - half - half.turned(0.02)) == 0  # vanes that cross
    assert strips(annulus - lm.Polygon(((0.0, -0.1), (2.0, -0.2), (2.0, 0.2), (0.0, 0.1)))) == 0
    assert strips(annulus - half - lm.Disc(0.05, (0.9, 0.0))) == 0
    assert lm.Pupil(stop=annulus - half, vignetting=lm.Ellipse(0.95, 0.95)).strips is None
    assert lm.Pupil(stop=lm.telescopes.hst()).strips is None
    assert all(lm.Pupil(stop=stop).strips is not None for stop in (lm.telescopes.vlt(), lm.telescopes.subaru()))


def test_a_stop_without_an_obscuration_lacks_bars_or_vanes_from_the_axis() -> None:
    strip = lm.Polygon.strip
    bar, lower, vane = (
        strip((-2.0, 0.1), (2.0, 0.1), 0.1),
        strip((-2, -0.3), (2, -0.3), 0.02),
        strip((0, 0), (2, 1), 0.02),
    )

    def strips(stop: lm.Shape) -> int:
        found = lm.Pupil(stop=stop).strips
        return 0 if found is None else len(found[1])

    assert strips(lm.Disc() - bar) == 1
    assert strips(lm.Disc() - bar - lower) == 2
    assert strips(lm.Disc() - vane) == 1
    assert strips(lm.Disc() - vane - vane.turned(math.pi)) == 1
    assert strips(lm.Disc() - vane - vane.turned(2.0)) == 4
    assert strips(lm.Disc() - vane - strip((0, 0), (-2, 1), 0.03)) == 0  # of other widths
    assert strips(lm.Disc() - bar - bar.turned(1.0)) == 0  # bars that cross off the axis
    assert strips(lm.Disc() - bar - strip((-2, 0.13), (2, 0.13), 0.1)) == 0  # that overlap
    assert strips(lm.Disc() - bar - vane) == 0
    assert strips(lm.Disc() - strip((-2.0, 0.7), (2.0, 0.7), 0.3)) == 0  # too far from the axis
    assert strips(lm.Disc() - strip((-0.1, 0.0), (2.0, 0.0), 0.1)) == 0  # begins beside the axis


def test_averages_behind_strips_from_lines_are_those_of_samples() -> None:
    pupil = lm.Pupil(lm.Wavefront(np.linspace(0.0, 2.0, 6)), spider=lm.Spider.equal(4, width=0.05))
    found = lm.psf(pupil, 7, 1.2, integrate=True, dtype="f8")
    other = lm.psf(pupil, 7, 1.2, integrate=True, dtype="f8", method=NonuniformFFT(1e-9))
    assert isinstance(found.method, NonuniformFFT)
    assert isinstance(lm.psf(pupil[:2], 7, 1.2, integrate=True).method, ChordalGauss)
    np.testing.assert_allclose(
        np.asarray(found), np.asarray(other), rtol=0.0, atol=1e-6 * float(np.asarray(other).max())
    )


def test_sums_over_rows_compute_what_strips_do_not() -> None:
    pupil = lm.Pupil(obscuration=0.3, spider=lm.Spider.equal(4, width=0.02, first=0.5))
    meeting = lm.Pupil(obscuration=0.1, spider=lm.Spider.equal(4, width=0.3))
    near, far = (lm.psf(each, pixel=0.5, shape=9, tol=1e-5) for each in (pupil, meeting))
    assert isinstance(near.method, ChordalGauss)
    assert isinstance(far.method, NonuniformFFT)
    assert [type(one.reported) for one in candidates(pupil, Grid(9, 0.5))] == [ChordalGauss, NonuniformFFT]
    # Wide vanes and a large window take more lines than strips have.
    many = lm.Pupil(obscuration=0.5, spider=lm.Spider.equal(3, width=0.3))
    assert isinstance(lm.psf(many, pixel=4.0, shape=33, tol=1e-8, dtype="f8").method, NonuniformFFT)


@pytest.mark.parametrize(("kind", "pixel", "tol", "declines"), [
    ("three vanes", 2.0, 1e-4, True), ("three vanes", 2.0, 1e-5, True), ("three vanes", 1.0, 1e-5, False),
    ("vanes", 1.5, 1e-4, False), ("vanes", 4.5, 1e-5, True), ("vlt", 3.0, 1e-5, True),
])  # fmt: skip
def test_averages_in_wide_windows_behind_wide_vanes_are_by_nodes_of_the_aperture(
    kind: str, pixel: float, tol: float, declines: bool
) -> None:
    """Where strips take longer, as benchmarks/choice.py measures; where they do not, they are computed."""
    pupil = aperture(kind, lm.Wavefront.zernike({(3, 1): np.linspace(0.1, 0.3, 5)}))
    wanted, grid = Wanted(dtype=np.float32, threads=1), Grid(33 if declines else 17, pixel, integrate=True)
    if declines:
        with pytest.raises(Declined, match="nodes of the aperture"):
            ChordalIfCheaper(tol).images(pupil, grid, wanted)
    else:
        assert ChordalIfCheaper(tol).images(pupil, grid, wanted).error.max() <= tol


def test_averages_by_a_method_that_is_named_are_computed_also_where_another_is_faster() -> None:
    pupil = lm.Pupil(
        lm.Wavefront.zernike({(3, 1): np.linspace(0.1, 0.3, 5)}), spider=lm.Spider.equal(3, 0.04)
    )  # of vanes that meet at the axis
    options: dict[str, Any] = {"shape": 7, "pixel": 1.0, "integrate": True, "normalize": "strehl"}
    named = lm.psf(pupil, method="chordal-gauss", tol=1e-6, **options)
    other = lm.psf(pupil, tol=1e-9, dtype="f8", **options)
    assert isinstance(other.method, NonuniformFFT)
    assert np.abs(np.asarray(named) - np.asarray(other)).max() <= 2e-6


def test_a_named_method_without_an_answer_says_what_to_do() -> None:
    wide = lm.Pupil(obscuration=0.5, spider=lm.Spider.equal(3, width=0.3))
    with pytest.raises(ValueError, match=r"lines across a strip; .*leave method out"):
        lm.psf(wide, 33, 4.0, method=ChordalGauss(1e-8))
    with pytest.raises(ValueError, match=r"lines across a strip; .*leave method out"):
        lm.Plan(33, 4.0, method=ChordalGauss(1e-8))(wide)


def test_a_stack_on_disk_behind_vanes_has_the_images_of_psf(tmp_path: Path) -> None:
    pupil = vaned(9, stack=3)
    stack = lm.psf_to(tmp_path / "vanes.zarr", pupil, shape=9, pixel=0.5, tol=1e-5)
    np.testing.assert_allclose(
        np.asarray(stack), np.asarray(lm.psf(pupil, shape=9, pixel=0.5, tol=1e-5)), rtol=0.0, atol=1e-6
    )
