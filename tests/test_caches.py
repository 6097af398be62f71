"""Tables that calls share: one asked for after another, alike but for one thing, is not the other."""

from __future__ import annotations

import functools
import itertools
import math
import sys
import threading

import numpy as np
import pytest

import lommel as lm
from core_tests import _core_tests
from lommel import _core
from lommel.methods import ChordalGauss, Hankel, NijboerZernike
from lommel.optics.grid import Grid
from lommel.special.legendre import gauss_legendre
from tiers import ROOT

STACK = lm.Pupil(lm.Wavefront(np.linspace(-4.0, 5.0, 6), np.linspace(2.0, -1.0, 6)))


def polar(pupil: lm.Pupil, grid: Grid) -> np.ndarray:
    """Return I of a single pupil by Gauss-Legendre in the radius and equal angles."""
    r, w = gauss_legendre(70, pupil.obscuration, 1.0)
    theta = 2.0 * math.pi * (np.arange(640) + 0.5) / 640
    x, y = np.outer(r, np.cos(theta)), np.outer(r, np.sin(theta))
    values = (pupil.values(x, y)[0] * (2.0 / 640 * w * r)[:, None]).ravel()
    across = np.exp(-1j * np.outer(x.ravel(), math.pi * grid.x))
    down = np.exp(-1j * np.outer(y.ravel(), math.pi * grid.y))
    return np.asarray(np.abs((values[:, None] * down).T @ across) ** 2)


def agrees(pupil: lm.Pupil, shape, pixel: float, method: lm.methods.method.Method, center=None) -> None:
    """Compare with a reference that shares no table."""
    answer = lm.psf(pupil, shape, pixel, method=method, center=center, normalize="strehl", dtype=np.float64)
    scale = np.asarray(answer.scale)[..., None, None]
    if pupil.radial:
        exact = lm.psf(pupil, shape, pixel, method=Hankel(1e-12), center=center, normalize="strehl").values / scale
    else:
        exact = polar(pupil, Grid(shape, pixel, center=center))
    assert np.abs(answer.values / scale - exact).max() <= answer.error_bound * exact.max() + 1e-12


@pytest.mark.parametrize("times", [1, 2])
def test_stacks_ask_for_pitches_sizes_and_tolerances_in_turn(times):
    # Loose before tight, so that more terms are wanted of the same window.
    sizes, pitches, tolerances = [(13, 11), (13, 17), (9, 11), (11, 13)], [0.31, 0.62, 0.31], [1e-3, 1e-9, 1e-5]
    for (shape, pixel), tol in itertools.product(itertools.product(sizes, pitches), tolerances * times):
        agrees(STACK, shape, pixel, NijboerZernike(tol))


def test_a_stack_of_stronger_pupils_wants_more_of_the_same_window():
    for strength in (0.1, 30.0, 3.0):
        agrees(lm.Pupil(lm.Wavefront(strength * np.linspace(0.5, 1.0, 5))), 15, 0.43, NijboerZernike(1e-6))


def test_single_pupils_want_farther_pieces_and_more_rows_in_turn():
    # Rows first: few terms, then many, of the same pieces; then pieces beyond, for few terms and many.
    for defocus, pixel in ((1.0, 0.5), (300.0, 0.5), (1.0, 7.1), (400.0, 7.1), (2.0, 17.3), (700.0, 17.3)):
        for tol in (1e-4, 1e-8):
            agrees(lm.Pupil(lm.Wavefront(defocus)), (1, 41), pixel, NijboerZernike(tol))


COMA, WEAK = lm.Pupil(lm.Wavefront(1.0, nonradial={(3, 1): 1.5, (2, -2): 0.5})), np.linspace(0.05, 0.1, 5)


@pytest.mark.parametrize(
    ("pupil", "strong", "shape", "pixel", "options"),
    [
        (lm.Pupil(lm.Wavefront(2.7, [4.7])), lm.Pupil(lm.Wavefront(-10.3, [6.4])), 49, 2.8636, {"integrate": True}),
        (lm.Pupil(lm.Wavefront(WEAK)), lm.Pupil(lm.Wavefront(300.0 * WEAK)), 15, 0.43, {"center": None}),
        (COMA, lm.Pupil(20.0 * COMA.wavefront, obscuration=0.3), 33, 0.43, {}),
    ],
    ids=["averages", "stack", "general"],
)
def test_no_bit_depends_on_what_was_asked_for_before(pupil, strong, shape, pixel, options):
    wanted = {"method": NijboerZernike(1e-9), "dtype": np.float64, "center": (shape / 2 - 1, shape / 2)} | options

    def ask(pupil: lm.Pupil) -> bytes:
        return lm.psf(pupil, shape, pixel, **wanted).values.tobytes()

    lm.clear_caches()
    first = ask(pupil)
    ask(strong)
    assert ask(pupil) == first


SERIES, CHORDS = NijboerZernike(1e-7), ChordalGauss(1e-7)


@pytest.mark.quick
@pytest.mark.parametrize("method", [SERIES, CHORDS], ids=["series", "chords"])
def test_pupils_that_are_not_radial_ask_for_windows_around_any_axis_in_turn(method):
    shapes, centers = [(9, 11), (11, 11), (9, 9), (9, 11)], [(4.0, 5.0), (4.0, 3.0), (2.0, 5.0), (2.5, 4.25)]
    for shape, center in itertools.product(shapes, centers):
        agrees(COMA, shape, 0.47, method, center)


@pytest.mark.parametrize("method", [SERIES, CHORDS], ids=["series", "chords"])
def test_pupils_that_are_not_radial_ask_for_pitches_amplitudes_terms_and_tolerances_in_turn(method):
    for pixel in (0.33, 0.34, 0.33):
        agrees(COMA, (7, 9), pixel, method)
    for apodization in (0.5, 0.55, 0.0):
        agrees(lm.Pupil(COMA.wavefront, apodization=apodization), (7, 9), 0.33, method)
    for obscuration in (0.3, 0.33, 0.0):
        agrees(lm.Pupil(COMA.wavefront, obscuration=obscuration), (7, 9), 0.33, method)
    for terms in ({(3, 1): 1.5, (2, 2): 0.5}, {(3, 3): 1.5, (2, 2): 0.5}, {(3, 1): 0.5, (4, 2): 1.0}):
        agrees(lm.Pupil(lm.Wavefront(nonradial=terms)), (7, 9), 0.33, method)
    for tol in (1e-3, 1e-9, 1e-6):
        agrees(COMA, (7, 9), 0.33, type(method)(tol))


def test_quadrature_rules_of_one_degree_serve_few_azimuthal_orders_and_many():
    for terms in ({(8, 2): 4.0}, {(40, 40): 0.5}, {(40, 0): 0.5, (3, 1): 0.1}, {(44, 44): 3.0}, {(8, 2): 4.0}):
        agrees(lm.Pupil(lm.Wavefront(nonradial={t: c for t, c in terms.items() if t[1]})), (7, 7), 0.9, SERIES)


def test_quadrature_rules_of_azimuthal_orders_enough_serve_their_own_degree_only():
    exact = []
    for n, c in ((2, 0.01), (20, 0.5)):
        agrees(lm.Pupil(lm.Wavefront(nonradial={(n, 2): c})), (7, 7), 1.2, SERIES)
        made = _core_tests.zernike_bounds(np.array([(n, 2)]), np.array([c]), np.zeros(1), 16.0, 1e-8)
        exact.append(made["exact"])
    # Every rule has so few orders: one that others left behind, of a high degree, would serve both, and well.
    assert exact[0] < exact[1]


def test_derivatives_ask_for_their_own_rules():
    for c, tol in itertools.product((0.5, 40.0), (1e-4, 1e-8)):
        pupil, h = lm.Pupil(lm.Wavefront(c)), 1e-3
        answer = lm.psf(pupil, 9, 0.5, method=NijboerZernike(tol), derivatives=("defocus",), normalize="strehl")
        ahead, behind = (
            lm.psf(lm.Pupil(lm.Wavefront(c + d)), 9, 0.5, method="hankel", normalize="strehl").values for d in (h, -h)
        )
        slope = (ahead - behind) / (2 * h)
        assert (
            np.abs(answer.derivatives["defocus"] - slope).max() <= 1e-5 * answer.values.max() + 2 * answer.error_bound
        )


def kept() -> dict[str, int]:
    """How many things each bounded cache of the package holds."""
    return {
        f"{name}.{part}": value.cache_info().currsize
        for name, module in sys.modules.items()
        if name.startswith("lommel.")
        for part, value in vars(module).items()
        if isinstance(value, type(functools.lru_cache(len))) and value.cache_info().maxsize is not None
    }


def asked() -> list[np.ndarray]:
    """Values of every kind of table: samples and averages, of rotationally symmetric pupils, of others, of layers."""
    x = np.linspace(-1.0, 1.0, 40)
    mask = lm.Mask((x[:, None] ** 2 + x**2 < 0.6).astype(float))
    oil = lm.Objective(NA=1.4, immersion=1.518)
    made = [
        lm.psf(STACK, 33, 0.3),
        lm.psf(STACK, 21, 0.9, integrate=True),
        lm.psf(lm.Pupil(lm.Wavefront(80.0)), 300, 0.5),
        lm.psf(COMA, 200, 0.4, method=SERIES),
        lm.psf(COMA, 15, 0.4, method=CHORDS, integrate=True),
        lm.psf(COMA, 15, 0.4, derivatives=("defocus", (3, 1))),
        lm.psf(lm.Pupil(mask=mask), 33, 0.4),
        lm.psf(oil.pupil(depth=0.0, z=[0.0, 5e-7], wavelength=520e-9), 21, 0.1e-6),
        lm.psf(lm.Pupil(), 9, 0.7, blur=lm.Seeing(0.5), tol=1e-4),
    ]
    return [answer.values for answer in made]


def test_clearing_frees_what_is_kept_and_changes_no_bit():
    lm.clear_caches()  # of what other tests left
    before = asked()
    held, limit = _core.cached_bytes()
    assert 2**20 < held < limit
    assert f"up to {1e-9 * limit:.1f} GB" in (ROOT / "docs" / "running.md").read_text(encoding="utf-8")
    assert {"lommel.psf._plans", "lommel.optics.layers.debye._powers"} <= {
        name for name, count in kept().items() if count
    }
    lm.clear_caches()
    assert _core.cached_bytes() == (0, limit)
    assert {name for name, count in kept().items() if count} == set()
    again = asked()
    assert _core.cached_bytes()[0] > 2**20
    assert all(np.array_equal(one, other) for one, other in zip(before, again, strict=True))


def test_caches_may_be_cleared_while_other_threads_compute():
    def work(found: list[list[np.ndarray]]) -> None:
        found.extend([lm.psf(STACK, 33, 0.3).values, lm.psf(COMA, 60, 0.4, method=SERIES).values] for _ in range(2))

    lm.clear_caches()
    expected: list[list[np.ndarray]] = []
    work(expected)
    found: list[list[np.ndarray]] = []
    threads = [threading.Thread(target=work, args=(found,)) for _ in range(3)]
    for thread in threads:
        thread.start()
    while any(thread.is_alive() for thread in threads):
        lm.clear_caches()
        threads[0].join(1e-3)
    assert len(found) == 6
    assert all(np.array_equal(a, b) for made in found for a, b in zip(made, expected[0], strict=True))
