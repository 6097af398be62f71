"""The compiled core: what it returns, what it refuses, and that it lets other threads run."""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from nanobind.stubgen import StubGen
from numpy.typing import NDArray

import lommel
from lommel import _core
from rendering import grouped, rendered

STUB = Path(lommel.__file__).with_name("_core.pyi")
CONTIGUOUS = np.linspace(0.0, 5.0, 6)


def _pixels(rows: int, cols: int) -> NDArray[np.int64]:
    return np.arange(rows + 1)[:, None] ** 2 + np.arange(cols + 1) ** 2


def test_the_stub_is_what_the_compiled_module_says_of_itself() -> None:
    generator = StubGen(_core)
    generator.put(_core)
    assert STUB.read_text() == generator.get()


@pytest.mark.parametrize(("rows", "cols"), [(0, 0), (0, 5), (3, 1), (7, 7), (40, 100)])
def test_distinct_radii_rank_every_pixel_of_a_quadrant(rows: int, cols: int) -> None:
    squares, index = _core.distinct_radii(rows, cols)
    assert squares.dtype == np.int64
    assert index.dtype == np.int32
    assert np.array_equal(squares, np.unique(_pixels(rows, cols)))
    assert np.array_equal(squares[index], _pixels(rows, cols))


@given(st.integers(1, 12), st.integers(1, 12), st.integers(1, 3), st.sampled_from([np.float32, np.float64]))
def test_scatter_puts_the_value_of_its_radius_on_every_pixel(height: int, width: int, stack: int, kind: type) -> None:
    squares, _ = _core.distinct_radii(height // 2, width // 2)
    # The profile is the squared radius itself, so the image tells where each value came from.
    profiles = np.ascontiguousarray(np.arange(1.0, stack + 1)[:, None] * squares)
    scales = 1.0 / np.arange(1, stack + 1) ** 2
    out = np.full((stack, height, width), np.nan, dtype=kind)
    _core.scatter(profiles, scales, 2, out)
    y, x = np.mgrid[:height, :width]
    distance = (y - height // 2) ** 2 + (x - width // 2) ** 2
    assert out == pytest.approx(distance / np.arange(1, stack + 1)[:, None, None], rel=1e-6)


# What an image is asked for with, whichever way.
_ASKED: dict[str, Any] = {
    "obscuration": 0.1,
    "amplitude": np.array([0.0, 0.2]),
    "center_y": 2.0,
    "center_x": 3.0,
    "step": 0.5,
    "integrate": False,
    "tol": 1e-6,
    "threads": 1,
    "scale": 1.0,
}


def _render(**changes: Any) -> float:
    n, k, kind = 2, 1, np.float64
    arguments: dict[str, Any] = {
        "coefficients": np.ones((n, 2)),
        "images": np.empty((n, 5, 7), kind),
        "numbers": np.empty((3, n)),
        "powers": np.ones(k, np.int64),
        "derivative_images": np.empty((k, n, 5, 7), kind),
        "derivative_bounds": np.empty((k, n)),
    }
    return _core.render(**grouped(_ASKED | arguments | changes))


@pytest.mark.parametrize(
    "changes",
    [
        {"obscuration": float("nan")},
        {"amplitude": np.array([0.0, -1.0])},
        {"amplitude": np.array([0.2, -1.0, 1.0])},
        {"amplitude": np.array([0.0, 101.0])},
        {"tol": float("nan")},
        {"coefficients": np.full((2, 2), np.nan)},
    ],
)
def test_rendering_refuses_pupils_that_no_bound_holds_for(changes: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match=r"obscuration must|amplitude must|must be positive|exceed the limit"):
        _render(**changes)


def _plan(**changes: Any) -> _core.RadialPlan:
    return _core.RadialPlan(**grouped(_ASKED | {"height": 5, "width": 7, "kind": "d"} | changes))


def test_a_plan_leaves_alone_what_it_does_not_take() -> None:
    fits: dict[str, Any] = {"coefficients": np.ones((2, 3)), "images": np.zeros((2, 5, 7)), "scales": np.zeros(2)}
    frozen = {name: array.copy() for name, array in fits.items()}
    for array in frozen.values():
        array.flags.writeable = False
    for name, others in {
        "coefficients": (
            np.ones(3),
            np.ones((1, 2, 3)),
            np.ones((3, 3)),
            np.ones((3, 2)).T,
            np.ones((2, 3), np.float32),
        ),
        "images": (
            *(np.zeros(shape) for shape in ((5, 7), (1, 2, 5, 7), (2, 7, 5), (2, 5, 6), (3, 5, 7), (2, 35))),
            np.zeros((2, 5, 14))[:, :, ::2],
            np.zeros((2, 5, 7), np.float32),
            np.zeros((2, 5, 7), ">f8"),
            frozen["images"],
        ),
        "scales": (np.zeros(()), np.zeros(3), np.zeros((2, 1)), np.zeros(4)[::2], frozen["scales"]),
    }.items():
        for other in (*others, 1.0, "", [[1.0]]):
            assert _plan().render(**(fits | {name: other})) is None
            assert not fits["images"].any()
            assert not fits["scales"].any()
    bound = _plan().render(**(fits | {"coefficients": frozen["coefficients"]}))
    assert 0.0 < bound <= 1e-6
    alone = np.zeros((2, 5, 7))
    assert _plan().render(fits["coefficients"], alone) == bound
    assert np.array_equal(alone, fits["images"])
    assert fits["images"].all()
    assert fits["scales"].all()


def test_a_tolerance_that_is_not_met_is_told_by_the_bound_that_is() -> None:
    far = np.full((2, 2), 300.0)
    unmet = _render(coefficients=far, tol=1e-13)
    assert unmet > 1e-13
    assert _plan(tol=1e-13).render(far, np.empty((2, 5, 7)), np.empty(2)) == -unmet


def test_the_instructions_in_use_can_be_limited_and_not_misspelt() -> None:
    widest = _core.instructions()
    _core.limit_instructions("portable")
    assert _core.instructions() == "portable"
    with pytest.raises(ValueError, match="level must be"):
        _core.limit_instructions("mmx")
    _core.limit_instructions("avx512")
    assert _core.instructions() == widest


def test_the_wavelets_add_up_and_keep_their_digits_far_from_the_sensor() -> None:
    """Against extended precision, where k rho is ten million radians."""
    rng = np.random.default_rng(7)
    x, y = rng.uniform(-5e-3, 5e-3, (2, 50))
    amplitude = rng.normal(size=50) + 1j * rng.normal(size=50)
    sx, sy = rng.uniform(-1e-4, 1e-4, (2, 9))
    distance, wavenumber = 0.8, 2 * np.pi / 5e-7
    d, k = np.longdouble(distance), np.longdouble(wavenumber)
    rho = np.sqrt((x - sx[:, None].astype(np.longdouble)) ** 2 + (y - sy[:, None].astype(np.longdouble)) ** 2 + d * d)
    axis = np.sqrt(x.astype(np.longdouble) ** 2 + y.astype(np.longdouble) ** 2 + d * d)
    phase = (k * (rho - axis)).astype(np.float64)
    exact = (amplitude * (d / rho).astype(np.float64) ** 2 * np.exp(1j * phase)).sum(axis=1)
    field = _core.huygens_sum(x, y, amplitude, sx, sy, distance, wavenumber)
    assert np.abs(field - exact).max() <= 1e-10


def test_sequences_have_a_row_for_each_argument_and_may_be_empty() -> None:
    for function in (_core.bessel_sequence, _core.legendre_transforms):
        assert function(CONTIGUOUS, 4).shape == (6, 4)
        assert function(CONTIGUOUS, 4).flags.c_contiguous
        assert function(CONTIGUOUS, 0).shape == (6, 0)
        assert function(np.zeros(0), 4).shape == (0, 4)
        with pytest.raises(TypeError, match="incompatible function arguments"):
            function(CONTIGUOUS[:, None], 4)
        with pytest.raises(TypeError, match="incompatible function arguments"):
            function(CONTIGUOUS, -1)
        # Single precision and strides are converted, not misread.
        assert np.array_equal(function(CONTIGUOUS[::2], 4), function(CONTIGUOUS, 4)[::2])
        assert np.array_equal(function(CONTIGUOUS.astype(np.float32), 4), function(CONTIGUOUS, 4))


def test_an_answer_outlives_its_call_and_may_be_changed() -> None:
    nodes, weights = _core.gauss_legendre(5)
    kept = nodes.copy()
    del weights
    _core.gauss_legendre(5)[0][:] = 7.0
    assert np.array_equal(nodes, kept)


def _calls(scale: int) -> dict[str, Callable[[], Any]]:
    """Return one call of each function; at scale 1 it takes tens of milliseconds."""
    v = np.linspace(0.0, 300.0, 12_000 // scale)
    squares, _ = _core.distinct_radii(700, 700)
    profiles = np.ascontiguousarray(np.tile(np.sqrt(squares), (max(1, 12 // scale), 1)))
    pupils = np.ascontiguousarray(np.linspace([-90.0, 0.0], [90.0, 50.0], max(1, 200 // scale)))
    far = np.linspace(0.0, 64.0, 40_000 // scale)
    sources, points = np.linspace(-1e-3, 1e-3, 4000), np.linspace(0.0, 1e-5, 400 // scale)

    def scatter() -> NDArray[np.float32]:
        out = np.empty((len(profiles), 1401, 1400), dtype=np.float32)
        _core.scatter(profiles, np.ones(len(profiles)), 2, out)
        return out

    def render() -> NDArray[np.float32]:
        return rendered(pupils, 0.0, [0.0], (300, 301), 1.0, 1e-6, dtype=np.float32, threads=2).images

    def pixels() -> NDArray[np.float32]:
        some = pupils[: max(1, len(pupils) // 4)]
        place: dict[str, Any] = {"center": (150.0, 150.0 / scale), "integrate": True, "threads": 2}
        return rendered(some, 0.0, [0.0], (300, 301), 0.7, 1e-6, dtype=np.float32, **place).images

    def averages() -> NDArray[np.float64]:
        place = (100.5, 77.7, 0.7, True, 8, 2)
        v = _core.pixel_radii(1600 // scale, 300, *place)[0]
        out = np.empty((1, 1600 // scale, 300))
        _core.pixel_values(np.exp(-v / 500)[None], *place, out)
        return out

    return {
        "bessel_sequence": lambda: _core.bessel_sequence(v, 300),
        "legendre_transforms": lambda: _core.legendre_transforms(v, 150),
        "gauss_legendre": lambda: np.stack(_core.gauss_legendre(4000 // scale)),
        "distinct_radii": lambda: _core.distinct_radii(4000 // scale, 4000 // scale)[1],
        "scatter": scatter,
        "render": render,
        "field": lambda: _core.field((pupils, 0.3, np.array([0.0, 0.5])), far, 1e-6)[0][0],
        "profile": lambda: _core.profile((pupils, 0.3, np.array([0.0, 0.5])), far, 1e-6)[0][0],
        "render with averages": pixels,
        "pixel_values": averages,
        "huygens_sum": lambda: _core.huygens_sum(sources, sources, np.exp(1e4j * sources), points, points, 0.1, 1e7),
    }


NAMES = list(_calls(16))


@pytest.mark.parametrize("name", NAMES)
def test_many_threads_at_once_find_what_one_does(name: str) -> None:
    call = _calls(16)[name]
    alone = call()
    with ThreadPoolExecutor(8) as pool:
        for answer in pool.map(lambda _: call(), range(24)):
            assert np.array_equal(answer, alone)


def _ticks_during(call: Callable[[], Any]) -> int:
    """Count how often a thread that wakes up again and again can do so during up to 100 calls.

    The interpreter is kept from taking the lock away, so it can only where the call itself gives the lock. A single
    call of a few milliseconds may end before a busy machine runs the other thread.
    """
    ticks: list[None] = []
    done = threading.Event()

    def tick() -> None:
        while not done.is_set():
            ticks.append(None)
            time.sleep(1e-4)

    clock = threading.Thread(target=tick)
    usual = sys.getswitchinterval()
    sys.setswitchinterval(1000.0)
    clock.start()
    try:
        before = len(ticks)
        for _ in range(100):
            call()
            if len(ticks) > before:
                break
        return len(ticks) - before
    finally:
        done.set()
        clock.join()
        sys.setswitchinterval(usual)


@pytest.mark.parametrize("name", NAMES)
def test_other_threads_run_while_the_core_computes(name: str) -> None:
    assert _ticks_during(_calls(1)[name]) > 0


def test_no_other_thread_runs_while_python_itself_computes() -> None:
    """Or else the test above could not fail."""
    assert _ticks_during(lambda: sum(i * i for i in range(30_000))) == 0
