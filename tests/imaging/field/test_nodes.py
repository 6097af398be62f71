"""Nodes over the field, and blocks between them."""

from __future__ import annotations

import numpy as np
import pytest

from lommel.imaging import field_blur
from lommel.imaging.field_blur import MixedBlur
from lommel.imaging.spline_nodes import MAX_NODES, Nodes, interpolated, sufficient_nodes
from point_sums import sum_over_points


@pytest.mark.parametrize("degree", [3, 5])
@pytest.mark.parametrize("count", [1, 2, 3, 4, 5, 7, 9, 20])
def test_splines_pass_polynomials_of_their_degree_and_weights_sum_to_one(count: int, degree: int) -> None:
    nodes = Nodes(-2.0, 3.0, count, degree)
    places = np.linspace(-2.0, 3.0, 57)
    weights = nodes.weights(places)
    assert weights.shape == (57, count)
    assert np.abs(weights.sum(axis=1) - 1.0).max() < 1e-13
    assert (np.count_nonzero(weights, axis=1) <= degree + 1).all()
    degree = min(degree, count - 1)
    values = nodes.places[:, None] ** np.arange(degree + 1)
    made = weights @ nodes.coefficients(values, 0)
    assert np.abs(made - places[:, None] ** np.arange(degree + 1)).max() < 1e-10


def test_nodes_are_closer_at_the_ends_and_end_there() -> None:
    nodes = Nodes(1.0, 4.0, 12)
    assert nodes.places[[0, -1]] == pytest.approx([1.0, 4.0], rel=1e-15)
    steps = np.diff(nodes.places)
    assert steps / steps[5] == pytest.approx([0.5, 0.8, *[1.0] * 7, 0.8, 0.5])
    assert nodes.between == pytest.approx(nodes.places[:-1] + 0.5 * steps)
    finer = Nodes(1.0, 4.0, 12, 5)
    steps = np.diff(finer.places)
    assert steps / steps[5] == pytest.approx([0.35, 0.6, 0.8, *[1.0] * 5, 0.8, 0.6, 0.35])
    beyond = nodes.weights(np.array([0.5, 4.5]))
    assert beyond == pytest.approx(nodes.weights(np.array([1.0, 4.0])))


@pytest.mark.parametrize("count", [1, 7])
def test_shares_are_the_columns_of_weights_that_count(count: int) -> None:
    nodes = Nodes(0.0, 1.0, count)
    places = np.random.default_rng(0).uniform(0.3, 0.45, (3, 5))
    weights = nodes.weights(places.ravel())
    found = nodes.nonzero_weights(places)
    assert [place for place, _ in found] == np.flatnonzero(weights.any(axis=0)).tolist()
    for place, share in found:
        np.testing.assert_array_equal(share, weights[:, place].reshape(3, 5))


@pytest.mark.parametrize("frequency", [0.5, 3.0, 30.0])
@pytest.mark.parametrize("degree", [3, 5])
@pytest.mark.parametrize("tol", [1e-2, 3e-4, 1e-5])
def test_nodes_are_close_enough_and_not_much_closer(frequency: float, tol: float, degree: int) -> None:
    """Waves of two phases, as windows of one pixel."""

    def waves(places: np.ndarray) -> np.ndarray:
        return np.stack([np.cos(frequency * places + phase) for phase in (0.0, 1.0)])[..., None, None]

    def worst(nodes: Nodes) -> float:
        places = np.linspace(0.0, 2.0, 3001)
        return float(np.abs(interpolated(nodes, waves(nodes.places), places) - waves(places)).max())

    nodes = sufficient_nodes(waves, 0.0, 2.0, tol, degree)
    assert nodes is not None
    assert nodes.degree == degree
    assert worst(nodes) <= 1.05 * tol
    if nodes.count > 6:
        assert worst(Nodes(0.0, 2.0, round(0.6 * nodes.count), degree)) > tol


def test_what_does_not_change_takes_one_node_and_what_changes_too_much_has_none() -> None:
    def flat(places: np.ndarray) -> np.ndarray:
        return np.ones((1, len(places), 1, 1))

    def steep(places: np.ndarray) -> np.ndarray:
        return np.cos(1e4 * places)[None, :, None, None]

    assert sufficient_nodes(flat, 0.0, 1.0, 1e-3, 3) == Nodes(0.0, 1.0, 1)
    assert sufficient_nodes(steep, 0.5, 0.5, 1e-3, 3) == Nodes(0.5, 0.5, 1)
    assert sufficient_nodes(steep, 0.0, 1.0, 1e-3, 3) is None
    assert Nodes(0.0, 1.0, 1).finer(1.1).count == 3
    assert Nodes(0.0, 1.0, MAX_NODES).finer(2.0).count == 2 * MAX_NODES - 1


HEIGHT, WIDTH, SIDE = 23, 31, 5


def made(deep: bool, dtype: type = np.float64, threads: int = 2) -> tuple[MixedBlur, np.ndarray, np.ndarray]:
    """Points of the left half take the first window over defocus alone, others a mixture, which varies."""
    windows = np.random.default_rng(0).standard_normal((5, 7, 3, SIDE, SIDE)).astype(dtype)
    down, across = (
        Nodes(0.0, 1.0, count).weights(np.linspace(0.0, 1.0, n)) for count, n in ((5, HEIGHT), (7, WIDTH))
    )
    column = np.arange(WIDTH) + 0.0 * np.arange(HEIGHT)[:, None]
    defocus = np.where(column < WIDTH / 2, 0.0, column / WIDTH)
    focus, defocus = (Nodes(0.0, 1.0, 3), defocus) if deep else (Nodes(0.0, 0.0, 1), 0.0 * defocus)
    return MixedBlur(windows, (down, across), focus, defocus, threads=threads), down, across


def direct(engine: MixedBlur, down: np.ndarray, across: np.ndarray, light: np.ndarray) -> np.ndarray:
    def window(y: int, x: int) -> np.ndarray:
        shares = engine.focus.weights(engine.defocus[y, x, None])[0]
        return np.einsum("a,b,k,abkuv->uv", down[y], across[x], shares, engine.windows[:, :, : len(shares)])

    return sum_over_points(light, window, SIDE)


@pytest.mark.parametrize("deep", [False, True])
@pytest.mark.parametrize("kept", [True, False])
@pytest.mark.parametrize("longest", [9, 16, 512])
def test_blocks_of_any_size_add_up_to_the_sum_over_points(monkeypatch, deep, kept, longest):
    monkeypatch.setattr(field_blur, "_OVERHEAD", 0 if longest < 100 else 20_000)
    monkeypatch.setattr(field_blur, "_LONGEST", longest)
    monkeypatch.setattr(field_blur, "_MAX_KEPT_BYTES", field_blur._MAX_KEPT_BYTES if kept else 0)
    engine, down, across = made(deep)
    light, image = np.random.default_rng(1).standard_normal((2, HEIGHT, WIDTH))
    out, exact = engine.forward(light), direct(engine, down, across, light)
    assert np.abs(out - exact).max() < 1e-12 * np.abs(exact).max()
    assert np.vdot(out, image) == pytest.approx(np.vdot(light, engine.adjoint(image)), rel=1e-12)


def test_threads_do_not_change_a_bit():
    light = np.random.default_rng(1).random((HEIGHT, WIDTH)).astype(np.float32)
    one, other = (made(True, np.float32, threads)[0].forward(light) for threads in (1, 5))
    assert one.dtype == np.float32
    assert one.tobytes() == other.tobytes()
