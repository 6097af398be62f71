"""Plane layers: Fresnel's amplitudes, films, and the phase with its derivatives."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm
from lommel.optics.layers.stratified import Design, Layers, cosines
from objectives import phase, transmission

RHO = np.linspace(0.0, 1.0, 41)
WAVE = 520e-9
K = 2.0 * math.pi / WAVE


def layers(NA=1.4, immersion=1.518, glass=1.5255, sample=1.33, films=()) -> Layers:
    return Layers(NA, immersion, glass, sample, tuple(films), (), WAVE)


def amplitudes(of: Layers, rho=RHO):
    return of.amplitudes(lambda index: cosines(of.NA, rho, index), ((of.NA * rho) ** 2).astype(complex))


def test_waves_fade_with_the_distance_beyond_the_critical_angle():
    c = cosines(1.4, RHO, 1.33)
    beyond = RHO > 1.33 / 1.4
    assert (c.imag[beyond] > 0).all()
    assert (c.real[beyond] == 0).all()
    assert (c.imag[~beyond] == 0).all()
    assert c**2 == pytest.approx(1 - (1.4 * RHO / 1.33) ** 2, abs=1e-15)


def test_what_an_interface_does_not_reflect_it_transmits():
    of = layers(NA=1.2, immersion=1.5, glass=1.5, sample=1.33)
    c1, c2 = cosines(1.2, RHO, 1.5).real, cosines(1.2, RHO, 1.33).real
    found = amplitudes(of)
    for t, a, b in ((found.s, 1.5 * c1, 1.33 * c2), (found.p, 1.33 * c1, 1.5 * c2)):
        reflected = ((a - b) / (a + b)) ** 2
        assert 1.33 * c2 / (1.5 * c1) * np.abs(t) ** 2 + reflected == pytest.approx(np.ones(41), abs=1e-14)


def test_no_light_of_p_is_reflected_at_brewsters_angle():
    rho = math.sin(math.atan(1.33 / 1.5)) * 1.5 / 1.2
    found = amplitudes(layers(NA=1.2, immersion=1.5, glass=1.5), np.array([rho]))
    assert abs(found.p[0]) == pytest.approx(1.5 / 1.33)
    assert abs(found.s[0]) < 0.995 * 1.5 / 1.33


@pytest.mark.parametrize("index", [1.0, 1.38, 2.0])
@pytest.mark.parametrize("sample", [1.33, 1.45])
def test_a_film_is_airys_sum_over_its_reflections(index, sample):
    thickness = 180e-9
    found = amplitudes(layers(immersion=1.6, glass=1.6, sample=sample, films=[(index, thickness)]))
    c = [cosines(1.4, RHO, n) for n in (1.6, index, sample)]
    through = np.exp(1j * K * index * thickness * c[1])
    for name, n in (("s", (1.6, index, sample)), ("p", (1 / 1.6, 1 / index, 1 / sample))):
        a, b, z = (one * cosine for one, cosine in zip(n, c, strict=True))
        # Of E along s and of H along p, whose E is H over the index.
        r12, r23 = (a - b) / (a + b), (b - z) / (b + z)
        t = (2 * a / (a + b)) * (2 * b / (b + z)) * through / (1 + r12 * r23 * through**2)
        t *= 1.0 if name == "s" else 1.6 / sample
        assert np.abs(getattr(found, name) - t).max() < 1e-13


def test_two_films_of_one_index_are_one_and_one_of_the_samples_index_is_sample():
    one = amplitudes(layers(films=[(2.0, 120e-9)]))
    two = amplitudes(layers(films=[(2.0, 50e-9), (2.0, 70e-9)]))
    assert np.abs(one.s - two.s).max() < 1e-14
    assert np.abs(one.p - two.p).max() < 1e-14
    bare, sample = amplitudes(layers()), amplitudes(layers(films=[(1.33, 120e-9)]))
    phase = np.exp(1j * K * 1.33 * 120e-9 * cosines(1.4, RHO, 1.33))
    assert np.abs(sample.s - bare.s * phase).max() < 1e-14
    assert np.abs(sample.p - bare.p * phase).max() < 1e-14


@pytest.mark.parametrize("films", [(), ((1.38, 90e-9), (2.1, 60e-9))])
def test_light_on_its_way_back_has_the_same_amplitudes(films):
    rho = RHO[:-1]
    there = amplitudes(layers(immersion=1.55, glass=1.55, sample=1.45, films=films), rho)
    back = amplitudes(layers(immersion=1.45, glass=1.45, sample=1.55, films=films[::-1]), rho)
    ratio = 1.55 * cosines(1.4, rho, 1.55) / (1.45 * cosines(1.4, rho, 1.45))
    assert np.abs(back.s * ratio - there.s).max() < 1e-13
    assert np.abs(back.p * ratio - there.p).max() < 1e-13


def test_glass_is_thick():
    of = layers()
    both = amplitudes(of)
    first = amplitudes(layers(glass=1.5255, sample=1.5255))
    second = amplitudes(layers(immersion=1.5255))
    assert both.s == pytest.approx(first.s * second.s)
    assert both.p == pytest.approx(first.p * second.p)


OBJECTIVE = lm.Objective(
    NA=1.4,
    magnification=63,
    immersion=1.515,
    working_distance=0.19e-3,
    coverslip=lm.Layer(1.52, 175e-6),
    sample=1.33,
    design=Design(1.518, lm.Layer(1.5255, 170e-6)),
)


def test_the_phase_is_that_of_gibson_and_lanni():
    depth, focus = 3e-6, 4e-6
    psi = phase(OBJECTIVE, RHO, depth=depth, focus=focus, wavelength=WAVE)
    t_i = 1.515 * (170e-6 / 1.5255 + 0.19e-3 / 1.518 - 175e-6 / 1.52) - focus
    length = np.zeros(41, complex)
    for index, thickness in ((1.33, depth), (1.52, 175e-6), (1.5255, -170e-6), (1.515, t_i), (1.518, -0.19e-3)):
        length += thickness * np.emath.sqrt(index**2 - (1.4 * RHO) ** 2)
    assert np.abs(psi - K * length).max() < 1e-9
    assert (psi.imag[RHO > 0.951] > 0).all()


def test_an_objective_used_as_designed_has_the_phase_of_depth_and_focus_alone():
    plain = lm.Objective(
        NA=0.8, magnification=20, immersion=1.0, working_distance=1e-3, coverslip=lm.Layer(1.52, 1e-4), sample=1.33
    )
    sine = (0.8 * RHO) ** 2
    expected = K * (2e-6 * np.sqrt(1.33**2 - sine) - 1e-6 * np.sqrt(1.0 - sine))
    assert phase(plain, RHO, depth=2e-6, focus=1e-6, wavelength=WAVE) == pytest.approx(expected, abs=1e-12)


def test_the_phase_is_linear_in_depth_and_focus_with_the_derivatives_told():
    layers = OBJECTIVE._layers(WAVE)
    _, by_depth, by_focus = layers.rates(layers.cosine(RHO))
    base = phase(OBJECTIVE, RHO, depth=0.0, focus=0.0, wavelength=WAVE)
    there = phase(OBJECTIVE, RHO, depth=5e-6, focus=-2e-6, wavelength=WAVE)
    assert np.abs(there - base - 5e-6 * by_depth + 2e-6 * by_focus).max() < 1e-9
    assert by_focus == pytest.approx(-K * np.sqrt(1.515**2 - (1.4 * RHO) ** 2))
    assert by_depth.real.min() == 0.0 < by_depth.imag.max()


def test_films_change_the_amplitudes_of_an_objective():
    coated = lm.Objective(
        NA=1.2,
        magnification=60,
        immersion=1.333,
        working_distance=0.28e-3,
        coverslip=lm.Layer(1.5255, 170e-6),
        sample=1.36,
        films=[lm.Layer(2.0, 30e-9), lm.Layer(1.46, 40e-9)],
    )
    t_s, t_p = transmission(coated, RHO, WAVE)
    of = Layers(1.2, 1.333, 1.5255, 1.36, ((2.0, 30e-9), (1.46, 40e-9)), (), WAVE)
    assert (t_s == amplitudes(of).s).all()
    assert (t_p == amplitudes(of).p).all()
    assert t_s[0] == pytest.approx(t_p[0])  # no difference on the axis
