"""Photons that are held out: two independent halves, the highest background, and the index of the sample."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

import lommel as lm
from lommel.microscopy import held_out
from lommel.microscopy.held_out import Best, HeldOut
from lommel.microscopy.refinement import Looked
from lommel.microscopy.stack_steps import State
from objectives import OIL_60X

NOISE = lm.Noise(white=0.5, read=1.6, offset=100.0)


class Model:
    """A model whose only parameter is the index of the sample, from 1.32 on."""

    def __init__(self, sample):
        self.objective = SimpleNamespace(sample=sample)

    def changed(self, _, value):
        if value < 1.32:
            raise ValueError
        return Model(value)


def held(stack, model=None, limit=np.inf):
    return HeldOut(Looked(stack, model or Model(1.33), NOISE, limit, 1), lambda *_: None)


def flat(light=40.0, planes=20):
    draw = np.random.default_rng(5)
    electrons = draw.poisson(light, (planes, 32, 32)) + draw.normal(0.0, 1.6, (planes, 32, 32))
    return np.rint(100.0 + electrons / 0.5).astype(np.uint16)


def test_halves_add_up_to_the_counts_and_are_independent():
    stack = flat()
    stack[3, 4, 5] = 4000
    one, other = held(stack, limit=4000)._halves
    assert np.isnan(one[3, 4, 5])
    known = np.isfinite(one)
    assert known.sum() == stack.size - 1
    np.testing.assert_allclose((one + other)[known], stack[known] - 100.0, rtol=1e-5)
    assert abs(np.corrcoef(one[known], other[known])[0, 1]) < 0.03
    assert np.mean(one[known]) == pytest.approx(40.0, rel=0.01)  # 20 electrons


def test_the_background_is_the_highest_that_held_out_photons_allow(monkeypatch):
    asked = []

    def walked(_, words, model, fold, background, start, steps, course=None):
        asked.append((background.level, float(start.light[0]), steps))
        loss = 0.5 * ((background.level - 15.0) / 0.05) ** 2
        return Best(loss, 0, np.zeros(1), np.zeros(1), background.level, State(), [])

    monkeypatch.setattr(HeldOut, "_walked", walked)
    free = Best(99.0, 50, np.zeros(1), np.zeros(1), 14.7, State(np.full(1, 7.0, np.float32)), [])
    level = held(flat()).level(free)
    assert level == pytest.approx(2.0 * 15.1, abs=0.06)
    assert len(asked) < 7
    for place, light, steps in asked:  # what the background gains the specimen loses
        assert place + light == pytest.approx(21.7)
        assert steps == held_out._SETTLE


def trial(monkeypatch, truth, stated, bend=2e5, noise=0.0):
    """Return a finding where lnL falls from the true index on as a parabola; `noise` is what a second half adds."""
    calls = []

    def best(_, words, model, fold=0, course=None):
        off = model.objective.sample - truth
        calls.append((round(model.objective.sample, 4), fold))
        electrons = np.full(1000, 30.0) * np.where(np.arange(1000) % 2, np.exp(3.0 * off), np.exp(-3.0 * off))
        losses = np.full(1000, (0.5 * bend * off**2 + (noise * off if fold else 0.0)) / 1000)
        return Best(float(losses.sum()), 40, losses, electrons, 15.0, State(), [])

    monkeypatch.setattr(HeldOut, "best", best)
    given = held(flat(), Model(stated))
    return given.finding(given.best("own", Model(stated))), calls


def test_another_index_is_told_where_held_out_photons_are_sure(monkeypatch):
    found, calls = trial(monkeypatch, 1.33, 1.345)
    assert (found.code, found.severity) == ("psf_doubtful", "doubt")
    assert found.numbers["preferred"] == pytest.approx(1.33, abs=1e-6)
    assert found.numbers["preferred_error"] == pytest.approx(2.0 / np.sqrt(2e5), rel=1e-3)
    assert found.numbers["lnL"] > held_out._SURE * found.numbers["lnL_error"]
    assert (1.33, 0) in calls  # it went on until lnL fell


def test_the_right_index_is_compared_and_stays(monkeypatch):
    found, calls = trial(monkeypatch, 1.33, 1.33)
    assert (found.code, found.severity) == ("psf_compared", "note")
    assert {at for at, _ in calls} == {1.325, 1.33, 1.335}
    assert "lnL changes by -5 +- 4 with 1.325 and -2 +- 3 with 1.335" in found.text


def test_of_a_flat_stack_nothing_is_compared():
    given = {"pixel": 6.5e-6, "step": 0.3e-6, "wavelength": 520e-9, "direction": "up", "noise": NOISE}
    found = lm.microscopy.restore(flat(planes=6)[:, :16, :16], OIL_60X, psf_shape=(5, 9), **given)
    assert found.findings.codes == ("untested",)


def test_where_one_half_is_not_sure_the_other_one_decides_too(monkeypatch):
    for noise, code in ((0.0, "psf_doubtful"), (-1040.0, "psf_compared")):  # it is two standard errors in one half
        found, calls = trial(monkeypatch, 1.33, 1.335, bend=4.16e5, noise=noise)
        assert {(1.335, 1), (1.33, 1)} <= set(calls), found.numbers
        assert found.code == code, found.numbers


def test_an_index_that_is_not_possible_is_not_tried(monkeypatch):
    found, calls = trial(monkeypatch, 1.33, 1.321)
    assert 1.316 not in {at for at, _ in calls}
    assert found.code == "psf_doubtful"
