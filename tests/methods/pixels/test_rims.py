"""Far pixels from the rim of the pupil: against quadrature over the pupil and within each pixel."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm
from core_tests import _core_tests
from disk_quadrature import exact_lattice
from lommel import _core
from lommel.methods.nijboer_zernike import disk_stack, window_of
from lommel.optics.grid import Grid

NOLL = tuple(range(4, 16))  # the degrees 2 to 4


def pupils(rng, count, waves, terms=NOLL, **more):
    sizes = rng.normal(size=(count, len(terms)))
    sizes *= 2 * np.pi * waves / np.linalg.norm(sizes, axis=1)[:, None]
    return lm.Pupil(lm.Wavefront.zernike({j: sizes[:, i] for i, j in enumerate(terms)}, order="noll"), **more)


def exact_averages(pupil, step, places):
    """Return averages over pixels at (row, column) from the axis by Gauss's rule, of direct sums over the pupil."""
    x, w = np.polynomial.legendre.leggauss(int(0.7 * step) + 12)
    found = []
    for row, column in places:
        vx, vy = step * (column + 0.5 * x), step * (row + 0.5 * x)
        turns = math.hypot(np.abs(vx).max(), np.abs(vy).max()) + 3.0 * np.abs(pupil.wavefront.edge).sum()
        field = exact_lattice(pupil, vx, vy, int(0.4 * turns) + 40, int(1.1 * turns) + 60)
        found.append(0.25 * w @ np.abs(field) ** 2 @ w)
    return np.array(found)


def axes_of(window, count):
    """Return the axis of each pupil, (n, 2)."""
    return (
        window.center if isinstance(window.center, np.ndarray) else np.tile(window.center, (count, 1)).astype(float)
    )


def remainders_of(stack, window):
    """Return what rims leave of fields, times v to the power of RIM_ORDERS, and the pixels of the axes."""
    count = len(stack.edge)
    left, axes = np.empty(count), np.empty((count, 2))
    given = (*stack[:4], axes_of(window, count), *window.shape, window.step)
    _core_tests.rim_remainders(*given, 1, left, axes)
    return left, axes


def from_rims(pupil, grid, box, error):
    stack, window = disk_stack(pupil), window_of(pupil, grid)
    count = len(stack.edge)
    left, axes = remainders_of(stack, window)
    values, numbers = np.full((count, *grid.shape), np.nan), np.empty((count, 2))
    near = np.full((count, box, box), -1.0)
    given = (*stack[:4], axes_of(window, count), window.step, error, 1, left, near, np.arange(count))
    _core_tests.rim_averages(*given, values, numbers)
    return values, numbers[:, 0], numbers[:, 1], axes


def averages(pupil, shape, pixel, *, center=None, tol=1e-4, scale=1.0, failing=0):
    """Return averages by the core, which boxes they had, and their bounds."""
    grid = Grid(shape, pixel, center=center, integrate=True)
    stack, window = disk_stack(pupil), window_of(pupil, grid)
    values = np.empty((len(stack.edge), *grid.shape))
    given = (*stack[:4], axes_of(window, len(values)), window.step, tol, scale)
    return values, _core_tests.watched_averages(*given, if_cheaper=False, failing=failing, values=values)


def far_places(rng, axis, box, shape, count):
    """Return some pixels outside a box around the pixel of the axis, about half of them next to it."""
    rows, columns = (np.arange(side) - int(middle) for side, middle in zip(shape, axis, strict=True))
    y, x = np.meshgrid(rows, columns, indexing="ij")
    ring = np.maximum(np.abs(y), np.abs(x))
    beside, all_ = np.argwhere(ring == box // 2 + 1), np.argwhere(ring > box // 2)
    return [tuple(some[rng.integers(len(some))]) for some in (beside, all_) for _ in range(count // 2)]


QUESTIONS = [
    # waves, pixel, box, shape, error, more
    (0.02, 2.65, 5, (33, 33), 1e-5, {}),
    (0.1, 2.65, 11, (33, 33), 3e-6, {}),
    (0.1, 1.0, 27, (41, 41), 1e-5, {}),
    (0.1, 4.0, 7, (21, 33), 3e-6, {}),
    (0.05, 2.65, 11, (33, 33), 3e-8, {}),
    (0.2, 2.65, 17, (33, 33), 3e-6, {}),
    (0.1, 2.65, 11, (33, 33), 3e-6, {"obscuration": 0.3}),
    (0.1, 2.65, 11, (33, 33), 3e-6, {"obscuration": 0.6, "apodization": 0.8}),
    (0.05, 2.65, 11, (33, 33), 3e-6, {"apodization": 1.5}),
    (0.05, 2.65, 13, (17, 45), 3e-6, {"terms": (4, 11, 22, 28, 30)}),
    (0.03, 7.0, 5, (33, 33), 1e-6, {"obscuration": 0.35}),
]


@pytest.mark.parametrize(("waves", "pixel", "box", "shape", "error", "more"), QUESTIONS)
def test_far_averages_are_within_their_bound(waves, pixel, box, shape, error, more):
    rng = np.random.default_rng(7)
    pupil = pupils(rng, 18, waves, **more)
    # Axes anywhere in their pixels, each its own or all the same, and tilts beside them.
    own = rng.random() < 0.5
    center = tuple(side // 2 + rng.uniform(-1.5, 1.5, 18 if own else None) for side in shape)
    grid = Grid(shape, pixel, center=center, integrate=True)
    values, off, top, axes = from_rims(pupil, grid, box, error)
    assert np.median(off) < 30 * error
    largest = 0.0
    for i in range(len(values)):
        place = [float(np.broadcast_to(c, 18)[i]) for c in center]
        assert np.abs(axes[i] - place).max() <= 0.5
        inside = values[i] == -1.0
        rows, columns = (np.abs(np.arange(n) - a) for n, a in zip(shape, axes[i], strict=True))
        ring = np.maximum(rows[:, None], columns)
        assert (inside == (ring <= box // 2)).all()
        assert values[i][~inside].max() == pytest.approx(top[i], rel=1e-12)
        places = far_places(rng, axes[i], box, shape, 2)
        exact = exact_averages(pupil[i], grid.step(pupil), [(y - place[0], x - place[1]) for y, x in places])
        wrong = np.abs([values[i][p] for p in places] - exact)
        assert (wrong <= off[i]).all()
        largest = max(largest, wrong.max() / off[i])
    assert largest > 1e-3  # no bound that anything would be below


def test_what_rims_leave_of_fields_is_in_the_bound():
    # Next to a box too small for the phases it is nearly all of the error: far more than interpolation may add.
    pupil, grid = pupils(np.random.default_rng(6), 3, 0.1, obscuration=0.3), Grid(15, 2.65, integrate=True)
    values, off, _, _ = from_rims(pupil, grid, 5, 1e-8)
    places = [(0, 3), (3, 1), (-3, -3)]
    for i in range(3):
        exact = exact_averages(pupil[i], grid.step(pupil), places)
        wrong = np.abs([values[i][7 + y, 7 + x] for y, x in places] - exact).max()
        assert 1e-6 < wrong <= off[i]


@pytest.mark.parametrize("terms", [NOLL, (4,), (22, 25, 36)])
@pytest.mark.parametrize("apodization", [0.0, 0.7])
def test_what_is_left_is_a_derivative_of_the_pupil_function(terms, apodization):
    """By Cauchy's integral over conj(z) as a variable of its own, where the core takes a recurrence."""
    rng = np.random.default_rng(3)
    pupil = pupils(rng, 4, 0.07, terms, apodization=apodization)
    left, _ = remainders_of(disk_stack(pupil), window_of(pupil, Grid(9, 1.0)))
    order = _core_tests.RIM_ORDERS
    t, weight = np.polynomial.legendre.leggauss(60)
    radius, angle = np.sqrt(0.5 + 0.5 * t), 2 * np.pi * np.arange(120) / 120
    z = (radius[:, None] * np.exp(1j * angle)).ravel()
    around = np.exp(2j * np.pi * np.arange(128) / 128)
    for edge, found in zip(np.atleast_2d(pupil.wavefront.edge), left, strict=True):
        far = 0.35 * around
        other = np.conj(z)[:, None] + far
        square = z[:, None] * other
        phase = 1j * apodization * square
        for (n, m), c in zip(pupil.wavefront.indices, edge, strict=True):
            k, radial = abs(m), 0.0
            for s in range((n - k) // 2 + 1):
                up = math.factorial(n - s) / math.factorial(s)
                up /= math.factorial((n + k) // 2 - s) * math.factorial((n - k) // 2 - s)
                radial = radial + (-1) ** s * up * square ** ((n - k) // 2 - s)
            turn = z[:, None] ** k + other**k if m >= 0 else -1j * (z[:, None] ** k - other**k)
            phase = phase + c * radial * (0.5 * turn if m else 1.0)
        derivative = 2.0**order * math.factorial(order) * np.mean(np.exp(1j * phase) / far**order, axis=1)
        # Over the amplitude, which the bound takes as 1.
        size = np.abs(derivative) ** 2 * np.exp(2 * apodization * np.abs(z) ** 2)
        exact = math.sqrt(0.5 * weight @ size.reshape(60, 120).mean(axis=1))
        assert exact <= found <= 1.02 * exact


@pytest.mark.parametrize("level", ["portable", "avx2", "avx512"])
def test_all_processors_agree(level):
    rng = np.random.default_rng(5)
    pupil, grid = pupils(rng, 21, 0.1, obscuration=0.3), Grid(33, 2.65, integrate=True)
    values, off, _, _ = from_rims(pupil, grid, 11, 3e-6)
    try:
        _core.limit_instructions(level)
        again, other, _, _ = from_rims(pupil, grid, 11, 3e-6)
    finally:
        _core.limit_instructions("avx512")
    np.testing.assert_allclose(again, values, atol=1e-9)
    np.testing.assert_allclose(other, off, rtol=1e-2)


@pytest.mark.parametrize("level", ["portable", "avx2", "avx512"])
@pytest.mark.parametrize("obscuration", [0.0, 0.4])
def test_pupils_alone_are_as_in_a_stack(level, obscuration):
    rng = np.random.default_rng(9)
    count = {"portable": 9, "avx2": 17, "avx512": 34}[level]  # of which one or two are left over
    pupil, grid = pupils(rng, count, 0.1, obscuration=obscuration), Grid((29, 33), 2.65, integrate=True)
    try:
        _core.limit_instructions(level)
        values, off, top, _ = from_rims(pupil, grid, 11, 3e-6)
        for i in (0, count - 1):
            one, bound, largest, _ = from_rims(pupil[i : i + 1], grid, 11, 3e-6)
            np.testing.assert_allclose(one[0], values[i], atol=1e-9)
            np.testing.assert_allclose(bound[0], off[i], rtol=1e-3)
            np.testing.assert_allclose(largest[0], top[i], rtol=1e-4)
    finally:
        _core.limit_instructions("avx512")


@pytest.mark.parametrize("normalize", ["strehl", "peak"])
@pytest.mark.parametrize(("tol", "dtype"), [(1e-3, np.float32), (1e-4, np.float32), (1e-6, np.float64)])
def test_stacks_of_psfs_are_within_their_bound(normalize, tol, dtype):
    rng = np.random.default_rng(11)
    pupil = pupils(rng, 40, 0.1)
    center = tuple(16 + rng.uniform(-2, 2, 40) for _ in range(2))
    made = lm.psf(
        pupil, 33, 2.65, center=center, integrate=True, tol=tol, dtype=dtype, normalize=normalize, threads=1
    )
    scale = 0.0 if normalize == "peak" else 1.0
    assert sum(averages(pupil, 33, 2.65, center=center, tol=tol, scale=scale)[1]["counts"]) >= 40
    assert np.max(made.error_bound) <= tol
    for i in range(0, 40, 7):
        place = np.array([c[i] for c in center])
        some = [tuple(rng.integers(0, 33, 2)) for _ in range(4)] + [tuple(np.rint(place).astype(int))]
        exact = exact_averages(pupil[i], 2.65 * np.pi, [(y - place[0], x - place[1]) for y, x in some])
        got = np.array([made.values[i][p] for p in some], float)
        whole = lm.psf(pupil[i], 33, 2.65, center=tuple(place), integrate=True, tol=1e-9, normalize="strehl").values
        scale = 1.0 / whole.max() if normalize == "peak" else 1.0
        assert np.abs(got - scale * exact).max() <= tol * scale * whole.max()


def taken(pupil, shape, pixel):
    """Return how many pupils have pixels from rims."""
    _, made = averages(pupil, shape, pixel)
    return sum(made["counts"])


def test_rims_serve_stacks_whose_light_is_in_a_small_box():
    rng = np.random.default_rng(2)
    assert taken(pupils(rng, 20, 0.1), 33, 2.65) >= 20
    assert taken(pupils(rng, 1, 0.1), 33, 2.65) == 1
    assert taken(pupils(rng, 1, 0.1), 33, 1.0) == 0  # few nodes take less time
    assert taken(pupils(rng, 20, 0.6), 33, 2.65) == 0  # light is everywhere
    assert taken(pupils(rng, 20, 0.05), 5, 2.65) == 0  # all pixels are near
    assert taken(pupils(rng, 4, 0.05), 150, 2.65) == 0  # tables take longer
    assert taken(pupils(rng, 20, 0.02, (4, 154)), 33, 2.65) == 0  # of degree 17


@pytest.mark.parametrize("obscuration", [0.002, 0.01, 0.03, 0.1, 0.93])
def test_obscurations_of_any_size_are_within_their_bound(obscuration):
    rng = np.random.default_rng(12)
    pupil, step = pupils(rng, 3, 0.01, (6, 12), obscuration=obscuration), 1.6 * np.pi
    values, off, _, _ = from_rims(pupil, Grid(31, 1.6, integrate=True), 9, 1e-6)
    for i in range(3):
        places = [(0, 5), (5, 1), (-6, 9), (14, -15)]
        exact = exact_averages(pupil[i], step, places)
        assert (np.abs([values[i][15 + y, 15 + x] for y, x in places] - exact) <= off[i]).all()


@pytest.mark.parametrize("row", [0.0, -1.0, -60.0, 2.0])
def test_windows_beside_the_axis_are_divided_by_their_own_largest_value(row):
    rng = np.random.default_rng(13)
    made = lm.psf(pupils(rng, 20, 0.05), 33, 2.65, center=(row, 16.3), integrate=True, tol=1e-3, normalize="peak")
    np.testing.assert_allclose(made.values.max(axis=(1, 2)), 1.0, rtol=1e-6)


def test_pupils_that_fail_have_larger_boxes_and_then_nodes():
    pupil = pupils(np.random.default_rng(4), 24, 0.05)
    values, made = averages(pupil, 33, 2.65, failing=5)
    assert made["made"]
    assert len(set(made["sides"])) >= 3
    assert max(made["sides"]) <= 0.7 * 33
    assert made["counts"][-1] == 5
    assert max(made["errors"]) <= 1e-4
    method = lm.methods.NijboerZernike(1e-6)
    exact = lm.psf(pupil, 33, 2.65, integrate=True, normalize="strehl", method=method).values
    assert (np.abs(values - exact).max(axis=(1, 2)) <= 1.01e-4 * exact.max(axis=(1, 2))).all()
    whole, _ = averages(pupil[::5], 33, 2.65, tol=1e-9)
    assert np.abs(values[::5] - whole).max() <= 1e-6  # nodes, which are far more exact than is asked of them


def test_pupils_left_over_do_not_make_others_start_again():
    """Alone, the series would take less time for those of much defocus, and decline for all."""
    defocus = np.r_[[0.3] * 38, [9.0] * 2]
    pupil = lm.Pupil(lm.Wavefront.zernike({(2, 0): defocus, (3, 1): np.full(40, 0.1)}))
    stack, window = disk_stack(pupil), window_of(pupil, Grid(41, 2.65, integrate=True))
    values = np.empty((40, 41, 41))
    given = (*stack[:4], axes_of(window, 40), window.step, 1e-3, 1.0)
    made = _core_tests.watched_averages(*given, if_cheaper=True, failing=0, values=values)
    assert made["made"]
    assert sum(made["counts"]) == 38
    alone = (*stack._replace(edge=stack.edge[38:].copy())[:4], axes_of(window, 2), window.step, 1e-3, 1.0)
    with pytest.raises(ValueError, match="series"):
        _core_tests.watched_averages(*alone, if_cheaper=True, failing=0, values=np.empty((2, 41, 41)))


@pytest.mark.parametrize("waves", [0.02, 0.05, 0.1, 0.2, 0.4, 1.0])
def test_five_hundred_pupils_are_within_their_bounds(waves):
    rng = np.random.default_rng(int(1000 * waves))
    worst = 0.0
    for _ in range(10):
        pixel = float(np.exp(rng.uniform(0.0, math.log(6.0))))
        pupil = pupils(
            rng, 50, waves, obscuration=float(rng.choice([0.0, 0.3])), apodization=float(rng.choice([0.0, 0.5]))
        )
        stack, step = disk_stack(pupil), pixel * np.pi
        remainders, _ = remainders_of(stack, window_of(pupil, Grid(9, pixel)))
        nearest = 1.2 * float(np.median(remainders) / 3e-4) ** (1 / _core_tests.RIM_ORDERS)
        box = max(5, 2 * math.ceil(max(nearest, 20.0) / step) + 1)
        side = box + 8
        error = 10.0 ** rng.uniform(-7, -5)
        values, off, _, _ = from_rims(pupil, Grid(side, pixel, integrate=True), box, error)
        for i in range(50):
            places = far_places(rng, (side // 2, side // 2), box, (side, side), 2)[: 2 if waves < 0.3 else 1]
            exact = exact_averages(pupil[i], step, [(y - side // 2, x - side // 2) for y, x in places])
            wrong = np.abs([values[i][p] for p in places] - exact).max()
            assert wrong <= off[i] + 1e-13
            worst = max(worst, wrong / off[i])
    assert worst > 0.01 or waves > 0.3  # of large phases sums of moduli tell little


def test_fields_near_pixels_start_at_angles_before_the_first_with_a_weight():
    """Stored as numbers without a sign, these places were beyond the ring."""
    wide = np.array([[1.0, 0.0, -0.25, 0.25, 0.0, 1.0, 1.0, 0.0, 0.3]])
    found = _core_tests.rim_starts(box=7, reach=8, step=6.0, error=1e-7, slope=16.0, strips=wide)
    least, largest = np.array(found["least"]), np.array(found["largest"])
    assert -found["margin"] <= least.min() < 0
    assert largest.max() + found["taps"] <= found["margin"]
