"""Wavefronts as the engines of the whole disk take them, a second time: docs/certificate.md 5 and 7."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from core_tests import SPACING, UNIT, _core_tests
from lommel import _core
from lommel.core.engine import DiskStack
from lommel.special import zernike

TERMS = [(n, m) for n in range(1, 13) for m in range(-n, n + 1, 2)] + [(60, 0), (59, -3), (40, 38)]
few = settings(max_examples=25)
edges = st.dictionaries(
    st.sampled_from(TERMS), st.floats(-9, 9).filter(lambda c: c == 0 or abs(c) > 1e-3), min_size=1, max_size=6
)
obscurations = st.one_of(st.floats(0.01, 0.99), st.sampled_from([1e-6, 0.5]))


def stack_of(edge, obscuration=0.0, row=0.0, column=0.0, step=1.0, moved=False):
    return _core_tests.disk_stack(
        np.array(list(edge), np.int64), np.array(list(edge.values())), obscuration, row, column, step, moved
    )


def radial(n: int, m: int, rho: mp.mpf) -> mp.mpf:
    """Return R_n^m from its powers."""
    k, total = (n - m) // 2, mp.mpf(0)
    for s in range(k + 1):
        total += (-1) ** s * mp.binomial(n - s, s) * mp.binomial(n - 2 * s, k - s) * rho ** (n - 2 * s)
    return total


def shares(n: int, m: int, eps: float) -> dict[int, mp.mpf]:
    """Return what R_n^m(eps rho) has of R_k^m."""
    values = {k: radial(n, k, mp.mpf(eps)) for k in range(abs(m), n + 1, 2)}
    return {k: value - values.get(k + 2, 0) for k, value in values.items()}


@few
@given(edges, obscurations)
@example({(60, 0): 8.0, (59, -3): -5.0}, 0.6)
def test_the_inner_disk_has_its_terms_and_what_they_lose(edge, obscuration):
    stack = stack_of(edge, obscuration)
    used = {term: c for term, c in edge.items() if c} or dict(list(edge.items())[:1])
    with mp.workdps(60):
        exact: dict[tuple[int, int], mp.mpf] = {}
        sums, recurrences = mp.mpf(0), mp.mpf(0)
        for (n, m), c in used.items():
            recurrences += abs(mp.mpf(c)) * SPACING * n * n * (n + 2)
            for k, share in shares(n, m, obscuration).items():
                exact[k, m] = exact.get((k, m), mp.mpf(0)) + share * mp.mpf(c)
                sums += abs(share * mp.mpf(c))
        lost = mp.mpf(obscuration) ** 2 * (UNIT * (len(used) + 1) * sums + recurrences)
        assert stack["lost"][0] == pytest.approx(float(lost), rel=1e-9, abs=1e-300)
        # Terms are those in use, then what is added; the outer disk is as it was.
        assert stack["terms"][: len(used)] == list(used)
        assert set(stack["terms"]) == set(exact)
        assert stack["outer"] == [used.get(term, 0.0) for term in stack["terms"]]
        inner = dict(zip(stack["terms"], map(mp.mpf, stack["inner"]), strict=True))
        missed = sum(abs(inner[term] - exact[term]) for term in exact)
        assert mp.mpf(obscuration) ** 2 * missed <= lost


@few
@given(edges, obscurations)
def test_the_inner_disk_has_the_phase_of_the_smaller_radius(edge, obscuration):
    stack = stack_of(edge, obscuration)
    rho, theta = np.linspace(0.0, 1.0, 40)[:, None], np.linspace(0.0, 6.0, 30)
    whole = sum(c * zernike.polynomial(n, m, obscuration * rho, theta) for (n, m), c in edge.items())
    parts = zip(stack["terms"], stack["inner"], strict=True)
    assert np.abs(sum(c * zernike.polynomial(n, m, rho, theta) for (n, m), c in parts) - whole).max() < 1e-12


def test_terms_that_are_zero_are_left_out_and_one_is_kept():
    edge = {(2, 0): 0.0, (3, 1): 2.0, (4, 0): -0.0, (2, 2): 1.0}
    assert stack_of(edge)["terms"] == [(3, 1), (2, 2)]
    assert stack_of({(2, 0): 0.0, (4, 0): 0.0})["terms"] == [(2, 0)]
    assert stack_of(edge)["lost"] == [0.0]
    assert stack_of(edge)["inner"] == []


axes = st.one_of(st.floats(-3e3, 3e3), st.just(0.0))
tilts = st.one_of(st.floats(-3e3, 3e3), st.just(0.0))


@given(axes, axes, tilts, tilts, st.floats(1e-2, 9.0))
@example(4.0, 4.5, 0.0, 0.0, 0.7)
@example(1e3, 0.0, -700.0, 3.0, 0.7)
def test_whole_pixels_of_tilt_move_the_axis(row, column, down, across, step):
    edge = {(1, -1): down, (3, 1): 1.0, (1, 1): across}
    stack = stack_of(edge, 0.0, row, column, step, moved=True)
    left, lost = dict(zip(stack["terms"], stack["outer"], strict=True)), mp.mpf(0)
    errors = []
    for at, tilt, place, term in ((row, down, stack["row"], (1, -1)), (column, across, stack["column"], (1, 1))):
        assert place == round(place)
        rest = mp.mpf(left.get(term, 0.0))
        assert abs(rest) <= 0.5 * step * (1 + 1e-9)
        errors.append(abs(mp.mpf(place) + rest / mp.mpf(step) - mp.mpf(at) - mp.mpf(tilt) / mp.mpf(step)) * step / 2)
        if tilt:
            lost += 3 * UNIT * (abs(mp.mpf(tilt)) + abs(mp.mpf(at)) * mp.mpf(step))
    # Where there is no tilt the rest of the axis is rounded once, as any coefficient may be.
    assert sum(errors) <= lost + UNIT * step
    assert stack["lost"][0] == pytest.approx(float(lost), rel=1e-12, abs=1e-322)
    assert left[3, 1] == 1.0


def test_an_axis_out_of_reach_is_refused():
    for edge, message in (({(1, 1): 2e6}, r"axis at column 2e\+06"), ({(1, -1): np.inf}, "axis at row inf")):
        with pytest.raises(ValueError, match=message):
            stack_of(edge, moved=True)


@pytest.mark.parametrize("engine", [_core.series_images, _core.chordal_images])
def test_every_pupil_of_a_stack_has_its_own_inner_disk(engine):
    terms, rng = np.array([(4, 0), (3, 1), (5, -3), (2, 2)], np.int32), np.random.default_rng(4)
    edge = rng.normal(size=(5, 4))

    def image(rows):
        images, numbers = np.empty((len(rows), 6, 7)), np.empty((3, len(rows)))
        stack, window = DiskStack(terms, rows, 0.5, np.zeros(1)), ((6, 7), (2.2, 3.7), 0.9)
        assert engine(stack, window, (1e-9, 1, 1.0), images, numbers) == 0.0
        return images

    together = image(edge)
    for i in range(5):
        assert np.abs(together[i] - image(edge[i : i + 1])[0]).max() < 1e-9
