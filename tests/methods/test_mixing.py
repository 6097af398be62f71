"""Sums over wavelengths, several at once: their values, their bounds, and what is asked of the parts."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.core.answers import Intensities, ToleranceError
from lommel.methods import Hankel, NijboerZernike, polychromatic
from lommel.methods.polychromatic import Polychromatic, sum_wavelengths
from lommel.optics.colour.spectrum import Component
from lommel.optics.grid import Grid

KEPT, VAGUE = Polychromatic([5e-7]), Polychromatic([5e-7], method=Hankel())
PARTS = [Component(1.0, stretch, None) for stretch in (1.0, 1.25, 0.8)]
SHARES = np.array([[0.0, 0.75, 0.25], [0.5, 0.25, 0.25], [1.0, 0.0, 0.0]])
RNG = np.random.default_rng(4)
VALUES = RNG.random((3, 2, 7))
PEAKS = VALUES.max(axis=2) * np.array([1.0, 3.0, 1.5])[:, None]  # of the second, outside of the window


def parts_of(error):
    """Return what answers for a part: its values, each off by a share of `error` of its peak."""
    asked = []

    def ask(part, tol):
        k = PARTS.index(part)
        asked.append(tol)
        return Intensities(VALUES[k], np.full(2, error(k, tol)), PEAKS[k])

    return ask, asked


@pytest.mark.parametrize("window", [False, True])
def test_sums_and_bounds_are_those_written_out(window):
    ask, asked = parts_of(lambda k, tol: (k + 1) * 1e-6)
    found = sum_wavelengths(PARTS, SHARES, ask, KEPT, 1.0, window)
    assert len(asked) == 3
    for row, made in zip(SHARES, found, strict=True):
        weights = row * np.array([part.stretch**2 for part in PARTS])
        assert made.values == pytest.approx(np.einsum("k,knr->nr", weights, VALUES), rel=1e-14)
        off = sum(w * (k + 1) * 1e-6 * PEAKS[k] for k, w in enumerate(weights))
        highest = made.values.max(axis=1)
        peak = highest if window else np.maximum(highest, (weights[:, None] * PEAKS).max(axis=0))
        assert made.error == pytest.approx(off / (peak - off), rel=1e-9)
        assert np.all(made.error > off / (peak - off))  # rounding counts
        assert made.peak == pytest.approx(peak - off, rel=1e-12)


@pytest.mark.parametrize("worst", [[3e-6, 0.9e-6], [1e-3, 3e-6, 1e-6], [1e-6], [1.9e-6] * 21])
def test_parts_are_tightened_until_their_sum_is_within_the_tolerance(worst, monkeypatch):
    """By the excess and by two, a thousandth at a time at most, down to the least that there is."""
    asked, expected = [], [1e-6]

    def sums(parts, weights, compute, part_tol, window):
        asked.append(part_tol)
        return [Intensities(np.ones((2, 1)), worst[len(asked) - 1] * np.array([0.1, 1.0]), np.ones(2))]

    monkeypatch.setattr(polychromatic, "_sums", sums)
    for one in worst[:-1]:
        expected.append(max(1e-12, expected[-1] * max(1e-3, 0.5 * 1e-6 / one)))
    if worst[-1] > 1e-6:
        with pytest.raises(ToleranceError, match="cannot be met"):
            sum_wavelengths(PARTS, SHARES, None, KEPT, 1e-6)
        expected = expected[: len(asked)]
        assert asked[-1] == 1e-12 < asked[-2]
    else:
        sum_wavelengths(PARTS, SHARES, None, KEPT, 1e-6)
    assert asked == pytest.approx(expected, rel=1e-12, abs=0.0)


def test_sums_of_no_light_have_no_bound_that_holds():
    none = Intensities(np.zeros((2, 7)), np.zeros(2), np.zeros(2))
    (found,) = sum_wavelengths(PARTS, SHARES[:1], lambda *_: none, VAGUE, 1e-6)
    assert found.error.tolist() == [np.inf, np.inf]


@pytest.mark.parametrize(("named", "least"), [(None, 1e-12), (Hankel(), 1e-15)])
def test_parts_are_asked_of_methods_of_their_tolerance(named, least, monkeypatch):
    """Less by what they exceed it, and no less than the least that the method has."""
    asked, made = [], Intensities(VALUES[0], np.full(2, 1e-3), PEAKS[0])
    monkeypatch.setattr(Hankel, "keeps_tol", True)
    monkeypatch.setattr(Hankel, "profile", lambda self, *_: asked.append(self.tol) or made)
    monkeypatch.setattr(NijboerZernike, "profile", lambda self, *_: asked.append(self.tol) or made)
    monkeypatch.setattr(
        polychromatic, "first_within_tolerance", lambda ways, _: asked.append(ways[0].tol) or (ways[0], made)
    )
    white, pupil = Polychromatic([5e-7], method=named, tol=3e-9), lm.Pupil(wavelength=5e-7, f_number=4.0)
    for way in (
        lambda: white.profile(pupil, np.linspace(0.0, 1.0, 7)),
        lambda: white.intensity(pupil, Grid(5, 1e-6), 1),
    ):
        asked.clear()
        with pytest.raises(ToleranceError, match="cannot be met"):
            way()
        thousandths = [3e-9, 3e-12] if named is None else [3e-9, 3e-12, 3e-15]
        assert asked == pytest.approx([*thousandths, least], rel=1e-9, abs=0.0)


def test_a_part_without_a_bound_leaves_its_sums_without_one():
    def ask(part, tol):
        k = PARTS.index(part)
        return Intensities(VALUES[k], None if k == 1 else np.full(2, 1e-9), None if k == 1 else PEAKS[k])

    found = sum_wavelengths(PARTS, SHARES, ask, KEPT, 1e-6)
    assert [made.error is None for made in found] == [True, True, False]
