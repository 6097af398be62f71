"""Derivatives of the integrals over a microscope's light: against differences of these, and within their bounds."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.optics.layers import debye
from lommel.optics.layers.debye import Model
from lommel.optics.layers.stratified import Design
from objectives import oil

FILMS = [lm.Layer(2.0, 60e-9), lm.Layer(1.46, 300e-9)]
WAVE = 520e-9
DEPTH, FOCUS = np.array([0.05e-6, 1e-6]), np.array([0.3e-6, 2e-6])
V = np.linspace(0.0, 12.0, 7)
MODELS = [Model(), Model("scalar"), Model("radial"), Model("azimuthal")]


def layers(films=()):
    return oil(design=Design(1.515, lm.Layer(1.5255, 168e-6)), films=films)._layers(WAVE)


def difference(at, h):
    return (45 * (at(h) - at(-h)) - 9 * (at(2 * h) - at(-2 * h)) + (at(3 * h) - at(-3 * h))) / (60 * h)


@pytest.mark.parametrize("films", [(), FILMS], ids=["bare", "films"])
@pytest.mark.parametrize("model", [MODELS[0], MODELS[2]], ids=lambda model: model.kind)
@pytest.mark.parametrize("tol", [1e-3, 1e-6])
def test_few_angles_err_by_no_more_than_is_said(model, films, tol):
    of, far = layers(films), float(V[-1])
    few, many = (debye.rule(of, model, DEPTH, FOCUS, far, asked) for asked in (tol, 1e-13))
    errors = debye.slope_errors(few, of, model, DEPTH, FOCUS, far, tol)
    for which, error in ((1, errors[0]), (2, errors[1])):
        pair = [
            rule._replace(parts=tuple(1j * rule.rates[which] * part for part in rule.parts)) for rule in (few, many)
        ]
        a, b = (np.stack(debye.fields(rule, model, DEPTH, FOCUS, V)) for rule in pair)
        assert np.abs(a - b).max() <= error
        # Of what changes by as much a metre as waves there are.
        assert 1e6 * tol <= error <= 1e11 * tol


@pytest.mark.parametrize("films", [(), FILMS], ids=["bare", "films"])
@pytest.mark.parametrize("model", MODELS, ids=lambda model: model.kind)
def test_collected_light_changes_with_depth_as_differences_say(model, films):
    of = layers(films)
    slope, nothing = debye.power(of, DEPTH, model, by_depth=True)
    expected = difference(lambda h: debye.power(of, DEPTH * (1.0 + h), model)[0], 1e-2)
    assert slope * DEPTH[:, None] == pytest.approx(expected, abs=1e-9)
    assert not nothing.any()
