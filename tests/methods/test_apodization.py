"""Illumination that is not even: a Gaussian beam that the aperture clips, and any other amplitude."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from scipy.special import j0

import lommel as lm
from lommel.methods import METHODS, ChordalGauss, Hankel, MatrixFourier, NijboerZernike, NonuniformFFT, Polychromatic
from lommel.paper import Fraunhofer, HuygensFresnel, LommelSeries

V = np.linspace(0.0, 60.0, 241)
# Numbers are Gaussian.
amplitudes = st.one_of(
    st.floats(0, 20),
    st.lists(st.floats(-3, 3), min_size=2, max_size=5).map(lm.Apodization),
    st.floats(0.05, 0.9).map(lambda sine: lm.Apodization.cosine(sine, -0.5)),
)


def test_a_beam_much_narrower_than_the_aperture_stays_gaussian():
    # int_0^inf exp(-g t) J0(v sqrt t) dt = exp(-v^2 / 4g) / g; the rim cuts off exp(-g).
    g = 30.0
    pupil = lm.Pupil(apodization=g)
    exact = np.exp(-(V**2) / (4 * g)) / g
    for method in (NijboerZernike(1e-10), Hankel()):
        assert np.abs(method.field(pupil, V) - exact).max() <= np.exp(-g) / g + 1e-14


def test_defocus_widens_a_gaussian_beam_as_the_formula_says():
    # With exp(2i C t) the width g becomes g - 2i C.
    g, c = 30.0, 12.0
    width = g - 2j * c
    exact = np.exp(-(V**2) / (4 * width)) / width
    field = NijboerZernike(1e-10).field(lm.Pupil(lm.Wavefront(c), apodization=g), V)
    assert np.abs(field - exact).max() <= np.exp(-g) / g + 1e-13


@given(st.floats(-80, 80), st.floats(-80, 80), amplitudes, st.sampled_from([0.0, 0.33, 0.8]), st.floats(3, 8))
def test_the_contract_holds_for_apodized_pupils(defocus, spherical, apodization, obscuration, digits):
    pupil = lm.Pupil(lm.Wavefront(defocus, spherical), obscuration=obscuration, apodization=apodization)
    # Where next to no light passes, rounding may exceed a small tolerance, and is refused.
    assume(pupil.amplitude > 1e-3)
    tol = 10.0**-digits
    assume(pupil.illumination.error < 1e-3 * tol)
    answer = lm.psf(pupil, (21, 90), 0.4, method=NijboerZernike(tol), dtype=np.float64)
    exact = lm.psf(pupil, (21, 90), 0.4, method="hankel")
    assert lm.peak_error(answer, exact) <= answer.error_bound <= tol


def test_a_tolerance_below_the_rounding_of_a_nearly_dark_pupil_is_refused():
    dark = lm.Pupil(lm.Wavefront(), obscuration=0.9, apodization=40.0)
    with pytest.raises(lm.ToleranceError, match="tol=1e-08 cannot be met"):
        lm.psf(dark, 33, 0.4, method=NijboerZernike(1e-8))


def test_a_stack_of_apodized_pupils_keeps_the_contract():
    stack = lm.Pupil(lm.Wavefront(np.linspace(-20, 20, 33)), apodization=1.5)
    answer = lm.psf(stack, 33, 0.5, dtype=np.float64)
    for i in (0, 7, 32):
        exact = lm.psf(stack[i], 33, 0.5, method="hankel")
        assert lm.peak_error(answer[i], exact) <= answer.error_bound


@pytest.mark.parametrize("obscuration", [0.0, 0.4])
@pytest.mark.parametrize("apodization", [1e-13, 0.5, 3.0])
def test_light_is_counted_as_it_passes(apodization, obscuration):
    pupil = lm.Pupil(lm.Wavefront(2.0), obscuration=obscuration, apodization=apodization)
    t = np.linspace(obscuration**2, 1.0, 20_001)
    amplitude = np.exp(-apodization * t)
    assert pupil.amplitude == pytest.approx(np.trapezoid(amplitude, t), rel=1e-8)
    assert pupil.transmission == pytest.approx(np.trapezoid(amplitude**2, t), rel=1e-8)
    answer = lm.psf(pupil, 301, 0.5, dtype=np.float64)
    assert answer.energy == pytest.approx(answer.values.sum(), abs=3e-4)
    assert 0.97 < answer.energy < 1.0
    perfect = lm.psf(pupil.unaberrated(), 9, 0.5, normalize="strehl", dtype=np.float64)
    assert perfect.values.max() == pytest.approx(1.0, abs=1e-6)
    assert perfect.strehl == pytest.approx(1.0, abs=1e-6)


def test_derivatives_of_apodized_pupils_are_the_limits_of_differences():
    def at(defocus: float, **more: object) -> lm.PSF:
        pupil = lm.Pupil(lm.Wavefront(defocus, 4.0), apodization=2.0, obscuration=0.2)
        return lm.psf(pupil, 31, 0.5, method=NijboerZernike(1e-9), normalize="strehl", **more)

    h, answer = 1e-4, at(6.0, derivatives=("defocus",))
    difference = (at(6.0 + h).values - at(6.0 - h).values) / (2 * h)
    assert np.abs(answer.derivatives["defocus"] - difference).max() < 1e-5 * answer.values.max()


@pytest.mark.parametrize("name", METHODS)
def test_methods_for_uniform_illumination_refuse_any_other(name):
    kind = METHODS[name]
    lens = lm.Lens(focal_length=0.05, f_number=8.0, wavelength=5e-7)
    pupil = lm.Pupil(wavelength=5e-7, f_number=8.0, apodization=1.0, geometry=lens.pupil().geometry)
    if kind.apodized:
        every = (NijboerZernike, Hankel, ChordalGauss, Fraunhofer, MatrixFourier, NonuniformFFT)
        every += (HuygensFresnel,)
        assert kind in every
        assert lm.psf(pupil, 5, 1e-6, method=kind()).values.shape == (5, 5)
    else:
        with pytest.raises(ValueError, match=f"{kind.__name__} supports uniform illumination only"):
            lm.psf(pupil, 5, 1e-6, method=kind())


def test_a_spectrum_can_be_apodized_if_its_method_can(tmp_path):
    pupil = lm.Pupil(wavelength=5e-7, f_number=8.0, apodization=1.0)
    answer = lm.psf(pupil, 9, 1e-6, method=Polychromatic([5e-7, 6e-7], [1, 1]), normalize="strehl")
    assert answer.strehl == pytest.approx(1.0, abs=2e-6)
    answer.save(tmp_path / "a.npy")
    assert lm.PSF.load(tmp_path / "a.npy").pupil.apodization == 1.0
    with pytest.raises(ValueError, match="uniform illumination only"):
        lm.psf(pupil, 9, 1e-6, method=Polychromatic([5e-7], [1], LommelSeries()))


# Brighter in the middle and at the rim than between; what is drawn is computed on its own.
RINGED = lm.Apodization([2.0, -3.0, 0.5, 0.2])
LOW = 0.2**2


def ringed(wavefront: lm.Wavefront = lm.Wavefront(3.0, -2.0), **more: object) -> lm.Pupil:  # noqa: B008
    return lm.Pupil(wavefront, apodization=RINGED, obscuration=0.2, **more)


def drawn(t: np.ndarray) -> np.ndarray:
    """Return the amplitude: the exponent is least at the rim, -0.3."""
    return np.exp(-0.3 - 2.0 * t + 3.0 * t**2 - 0.5 * t**3 - 0.2 * t**4)


def quadrature(v: np.ndarray, power: int = 0, scale: float = 1.0) -> np.ndarray:
    """Return int t^power A exp(i Phi) J0(v sqrt t) dt by 120 nodes."""
    nodes, weights = np.polynomial.legendre.leggauss(120)
    t = LOW + (1.0 - LOW) * 0.5 * (nodes + 1.0)
    source = 0.5 * (1.0 - LOW) * weights * drawn(t) * t**power * np.exp(1j * scale * (6.0 * t - 2.0 * t**2))
    return j0(np.outer(v, np.sqrt(t))) @ source


def test_the_field_of_any_amplitude_is_that_of_quadrature():
    assert drawn(np.ones(1)) == pytest.approx(1.0, abs=1e-15)
    assert RINGED.value([0.0, 1.0]) == pytest.approx([math.exp(-0.3), 1.0], abs=1e-13)
    for method in (NijboerZernike(1e-10), Hankel()):
        assert np.abs(method.field(ringed(), V) - quadrature(V)).max() <= 1e-11
        profile = method.profile(ringed(), V)
        assert profile.values[0] == pytest.approx(np.abs(quadrature(V)) ** 2, abs=1e-11)


@pytest.mark.parametrize("center", [None, (2.3, 4.0)])
@pytest.mark.parametrize("integrate", [False, True])
def test_derivatives_with_any_amplitude_are_those_of_quadrature(integrate, center):
    method = NijboerZernike(1e-8)
    more = {"normalize": "strehl", "dtype": np.float64, "method": method, "integrate": integrate, "center": center}
    answer = lm.psf(ringed(), 7, 0.4, derivatives=("defocus", "spherical"), **more)
    nodes, weights = np.polynomial.legendre.leggauss(9) if integrate else (np.zeros(1), np.array([2.0]))
    y, x = (0.4 * math.pi * (np.arange(7)[:, None] + 0.5 * nodes - c) for c in center or (3, 3))
    v = np.hypot(y[:, None, :, None], x[None, :, None, :])
    u, inside = quadrature(v.ravel()), {"defocus": (2.0, 1), "spherical": (1.0, 2)}
    mean = 0.25 * weights[:, None] * weights
    for name, (factor, power) in inside.items():
        slope = 2.0 * factor * (u.conj() * 1j * quadrature(v.ravel(), power)).real
        exact = (slope.reshape(v.shape) * mean).sum(axis=(2, 3)) * answer.scale
        bound = answer.derivative_bounds[name] * answer.values.max()
        assert np.abs(answer.derivatives[name] - exact).max() <= bound + 1e-12


def test_white_light_of_any_amplitude_is_the_sum_of_quadratures():
    pupil = ringed(wavelength=500e-9, f_number=2.0)
    method = Polychromatic([400e-9, 600e-9], [1.0, 3.0], NijboerZernike(1e-9))
    answer = lm.psf(pupil, 9, 0.7e-6, method=method, integrate=False, normalize="strehl", dtype=np.float64)
    v = np.pi / 1e-6 * 0.7e-6 * np.arange(5)
    parts = [(0.25, 1.25), (0.75, 500 / 600)]
    exact = sum(share * s**2 * np.abs(quadrature(s * v, scale=s)) ** 2 for share, s in parts)
    assert answer.values[4, 4:] / answer.scale == pytest.approx(exact, abs=1e-9)


def test_encircled_energy_of_any_amplitude_is_the_sum_of_rings():
    pupil = ringed()
    answer = lm.psf(pupil, 5, 0.4, dtype=np.float64)
    nodes, weights = np.polynomial.legendre.leggauss(200)
    for radius in (1.0, 4.0):
        v = 0.5 * math.pi * radius * (nodes + 1.0)
        # Parseval: all light is 2 int |U|^2 v dv / 4.
        light = 0.5 * 0.5 * math.pi * radius * weights @ (v * np.abs(quadrature(v)) ** 2)
        assert answer.encircled_energy(radius) == pytest.approx(light / pupil.transmission, abs=1e-6)
    t = LOW + (1.0 - LOW) * 0.5 * (nodes + 1.0)
    assert pupil.transmission == pytest.approx(0.5 * (1.0 - LOW) * weights @ drawn(t) ** 2, rel=1e-13)


def test_the_mtf_and_the_numbers_of_any_amplitude_are_those_of_quadrature():
    pupil = ringed()
    x, w = np.polynomial.legendre.leggauss(400)
    t = LOW + (1.0 - LOW) * 0.5 * (x + 1.0)
    weight = w * drawn(t) / (w @ drawn(t))
    phase = 6.0 * t - 2.0 * t**2
    assert float(lm.strehl(pupil)) == pytest.approx(abs(weight @ np.exp(1j * phase)) ** 2, abs=1e-12)
    spread = weight @ (phase - weight @ phase) ** 2
    assert float(lm.rms(pupil)) == pytest.approx(math.sqrt(spread), rel=1e-12)
    # The overlap of two pupils, on a lattice with steps at the rims.
    across = (np.arange(1600) + 0.5) / 800 - 1.0
    for f in (0.1, 0.4, 0.8):
        one, two = ((across + sign * f) ** 2 + across[:, None] ** 2 for sign in (-1, 1))
        clear = (np.minimum(one, two) >= LOW) & (np.maximum(one, two) <= 1.0)
        one, two = one[clear], two[clear]
        swing = 6.0 * (one - two) - 2.0 * (one**2 - two**2)
        seen = (drawn(one) * drawn(two) * np.cos(swing)).sum() / (math.pi * 800**2 * pupil.transmission)
        assert float(lm.otf(pupil, f).real) == pytest.approx(seen, abs=3e-4)


def test_pupils_of_a_stack_share_their_amplitude():
    stack = ringed(lm.Wavefront(np.linspace(-9.0, 9.0, 12)))
    for method in (NijboerZernike(1e-8), ChordalGauss(1e-8)):
        for integrate in (False, True):
            answer = lm.psf(stack, 9, 0.5, method=method, integrate=integrate, dtype=np.float64)
            one = lm.psf(stack[5], 9, 0.5, method="hankel", integrate=integrate, dtype=np.float64)
            assert lm.peak_error(answer[5], one) <= 2e-8


@pytest.mark.parametrize("normalize", ["strehl", "energy", "peak"])
def test_what_an_amplitude_leaves_out_counts_in_the_bound(normalize):
    """Off by as much as is stated: the true error is within the bound, and that not far from it."""
    ask = {"method": NijboerZernike(1e-5), "normalize": normalize, "dtype": np.float64}
    e, wave = 1e-6, lm.Wavefront(0.5)
    stated = lm.Apodization([1.0], error=e)
    # As wrong as may be: brighter by e in the middle and dimmer by e at the rim.
    other = lm.Apodization([1.0 + 2.0 * e])
    answer, plain, true = (lm.psf(lm.Pupil(wave, apodization=a), 9, 0.4, **ask) for a in (stated, 1.0, other))
    off = np.abs(answer.values - true.values).max() / true.values.max()
    added = answer.error_bound - plain.error_bound
    assert 0.02 * added <= off <= added <= 20 * e
    # 2 |U| times the error of U over the peak, that of U twice e times the amplitude; again for a division by it.
    pupil, peak = lm.Pupil(apodization=1.0), answer.values.max() / answer.scale
    times = 2.0 if normalize == "peak" else 1.0
    assert added == pytest.approx(times * 2.0 * 2.0 * e * pupil.amplitude / math.sqrt(peak), rel=1e-4)
    assert np.array_equal(answer.values, plain.values)
    with pytest.raises(lm.ToleranceError, match="leave up to 0 rad of the phase out, the terms of the apodization"):
        lm.psf(lm.Pupil(apodization=stated), 9, 0.4, method=NijboerZernike(1e-6))
