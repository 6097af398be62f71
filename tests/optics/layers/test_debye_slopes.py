"""Derivatives of the integrals over a microscope's light: against differences of these, and within their bounds."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

import lommel as lm
from lommel.optics.layers import debye
from lommel.optics.layers.debye import Model, Points, pieces
from lommel.optics.layers.stratified import Design
from lommel.special.disc_arithmetic import Disc
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


def in_light(of, h):
    """The layers in light whose wavenumber is larger by h of itself."""
    return replace(of, wavelength=of.wavelength * math.exp(-h))


def turned(found, of, model):
    """The derivatives of fields by ln k, with these angles."""
    by_k = debye.turning(found, of, model)
    psi = by_k.rates[0] + np.outer(DEPTH, by_k.rates[1]) + np.outer(FOCUS, by_k.rates[2])
    waves = found.waves(DEPTH, FOCUS)
    made = []
    for m, part in enumerate(found.parts):
        each = waves * 1j * psi * part + (0.0 if by_k.changes is None else waves * by_k.changes[m])
        only = found._replace(parts=(np.ones_like(part),), rates=(0.0 * found.rates[0],) * 3)
        bessel = [
            debye.fields(only._replace(parts=(row,)), One(model, m), np.zeros(1), np.zeros(1), V) for row in each
        ]
        made.append(np.concatenate([one[0] for one in bessel]))
    return made


class One:
    """A model of one part."""

    def __init__(self, model, m):
        self.orders = (model.orders[m],)


@pytest.mark.parametrize("films", [(), FILMS], ids=["bare", "films"])
@pytest.mark.parametrize("model", MODELS, ids=lambda model: model.kind)
def test_intensities_change_with_the_wavenumber_as_differences_say(model, films):
    of = layers(films)

    def at(h):
        found = debye.rule(in_light(of, h), model, DEPTH, FOCUS, float(V[-1]), 1e-13)
        return np.stack([np.abs(part) ** 2 for part in debye.fields(found, model, DEPTH, FOCUS, V)])

    found = debye.rule(of, model, DEPTH, FOCUS, float(V[-1]), 1e-13)
    assert (debye.turning(found, of, model).changes is not None) == (bool(films) and model.kind != "scalar")
    # About as far below 0 as above, which no intensity shows, and bounds do.
    by_focus = debye.turning(found, of, model).rates[2].real
    assert np.abs(by_focus).max() <= 0.51 * np.ptp(found.rates[2].real)
    F = np.stack(debye.fields(found, model, DEPTH, FOCUS, V))
    made = 2.0 * (np.stack(turned(found, of, model)) * F.conj()).real
    expected = difference(at, 2e-3)
    assert np.abs(made - expected).max() <= 1e-8 * np.abs(expected).max()


@pytest.mark.parametrize("films", [(), FILMS], ids=["bare", "films"])
@pytest.mark.parametrize("model", [MODELS[0], MODELS[2]], ids=lambda model: model.kind)
@pytest.mark.parametrize("tol", [1e-3, 1e-6])
def test_few_angles_err_by_no_more_than_is_said(model, films, tol):
    of, far = layers(films), float(V[-1])
    few, many = (debye.rule(of, model, DEPTH, FOCUS, far, asked) for asked in (tol, 1e-13))
    errors = debye.slope_errors(few, of, model, DEPTH, FOCUS, far, tol)
    off = max(np.abs(a - b).max() for a, b in zip(turned(few, of, model), turned(many, of, model), strict=True))
    assert off <= errors[3] <= 1e4 * tol
    for which, error in ((1, errors[0]), (2, errors[1])):
        pair = [
            rule._replace(parts=tuple(1j * rule.rates[which] * part for part in rule.parts)) for rule in (few, many)
        ]
        a, b = (np.stack(debye.fields(rule, model, DEPTH, FOCUS, V)) for rule in pair)
        assert np.abs(a - b).max() <= error
        # Of what changes by as much a metre as waves there are.
        assert error >= 1e6 * tol


@pytest.mark.parametrize("films", [(), FILMS], ids=["bare", "films"])
@pytest.mark.parametrize("model", MODELS, ids=lambda model: model.kind)
def test_collected_light_changes_as_differences_say(model, films):
    of = layers(films)
    near, far = debye.power(of, DEPTH, model, by="wavenumber")
    for made, which in ((near, 0), (far, 1)):
        expected = difference(lambda h, which=which: debye.power(in_light(of, h), DEPTH, model)[which], 2e-3)
        assert made == pytest.approx(expected, abs=1e-9)
    slope, nothing = debye.power(of, DEPTH, model, by="depth")
    expected = difference(lambda h: debye.power(of, DEPTH * (1.0 + h), model)[0], 1e-2)
    assert slope * DEPTH[:, None] == pytest.approx(expected, abs=1e-9)
    assert not nothing.any()


def test_films_change_the_transmission_by_as_much_on_discs_as_at_points():
    of = layers(FILMS)
    for piece in pieces(of, Model()):
        x = np.linspace(piece.low, piece.high, 9)[1:-1] + 0.02j
        at = Points(piece, x)
        made = of.log_slopes(at, at.square)
        for which, log_slope in enumerate(made):
            expected = difference(
                lambda h, at=at, which=which: np.log(
                    in_light(of, h).amplitudes(at, at.square)[which] / at.amplitudes[which]
                ),
                2e-3,
            )
            assert log_slope == pytest.approx(expected, rel=1e-7)
        around = Points(piece, Disc(x, np.full(x.shape, 1e-3)))
        discs = of.log_slopes(around, around.square)
        for turn in np.exp(0.25j * np.pi * np.arange(8)):
            inside = Points(piece, x + 0.999e-3 * turn)
            for disc, value in zip(discs, of.log_slopes(inside, inside.square), strict=True):
                assert (np.abs(value - disc.centre) <= disc.radius).all()
