"""A microscope objective: its focus, what it collects, and what it is not given."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.special import j1, jv

import lommel as lm
from lommel.methods import ChordalDebye, DebyeRings, DebyeWolf, Stratified
from lommel.optics.layers.objective import aberration, layers_of, media_strehl
from lommel.optics.layers.stratified import Design
from objectives import phase, transmission

GLASS = lm.Layer(1.5255, 170e-6)
GIVEN = {
    "NA": 1.4,
    "magnification": 63,
    "immersion": 1.518,
    "working_distance": 0.19e-3,
    "coverslip": GLASS,
    "sample": 1.33,
}
OBJECTIVE = lm.Objective(**GIVEN)
WAVE = 520e-9


def used(NA, immersion, glass, sample) -> lm.Objective:
    """An objective used as designed."""
    return lm.Objective(
        NA=NA,
        magnification=60,
        immersion=immersion,
        working_distance=1e-3,
        coverslip=lm.Layer(glass, 17e-5),
        sample=sample,
    )


# Depth and brightest focus in um; ratio, axial width in nm and peak where they are known.
TABLE = [
    (used(1.4, 1.515, 1.515, 1.33), 610e-9, 1, 1.396, 0.717, 757, 0.843),
    (used(1.4, 1.515, 1.515, 1.33), 610e-9, 5, 6.342, 0.788, 1131, 0.466),
    (used(1.4, 1.515, 1.515, 1.33), 610e-9, 20, 24.128, 0.829, 1840, 0.214),
    (used(1.4, 1.515, 1.515, 1.33), 610e-9, 50, 59.119, 0.846, 2690, 0.113),
    (used(1.49, 1.518, 1.518, 1.33), 670e-9, 1, 1.409, None, None, None),
    (used(1.49, 1.518, 1.518, 1.33), 670e-9, 5, 6.388, None, None, None),
    (used(1.49, 1.518, 1.518, 1.33), 670e-9, 20, 24.248, None, None, None),
    (used(1.49, 1.518, 1.518, 1.33), 670e-9, 50, 59.353, None, None, None),
    (used(1.2, 1.333, 1.5255, 1.36), 525e-9, 1, 0.961, None, None, 0.992),
    (used(1.2, 1.333, 1.5255, 1.36), 525e-9, 5, 4.804, None, None, 0.983),
    (used(1.2, 1.333, 1.5255, 1.36), 525e-9, 20, 19.223, None, None, 0.844),
    (used(1.2, 1.333, 1.5255, 1.36), 525e-9, 50, 48.388, None, None, 0.469),
    (used(0.95, 1.0, 1.5255, 1.33), 525e-9, 1, 0.605, None, None, 0.689),
    (used(0.95, 1.0, 1.5255, 1.33), 525e-9, 5, 3.051, None, None, 0.500),
    (used(0.95, 1.0, 1.5255, 1.33), 525e-9, 20, 13.520, None, None, 0.192),
    (used(0.95, 1.0, 1.5255, 1.33), 525e-9, 50, 35.180, None, None, 0.100),
]


@pytest.mark.parametrize(("objective", "wave", "depth", "best", "ratio", "width", "peak"), TABLE)
def test_the_focus_at_a_depth_is_that_of_an_independent_quadrature_to_a_nanometre(
    objective, wave, depth, best, ratio, width, peak
):
    focus = objective.focus(depth * 1e-6, wavelength=wave)
    assert focus.brightest == pytest.approx(best * 1e-6, abs=1e-9)
    assert focus.paraxial == pytest.approx(depth * 1e-6 * objective.immersion / objective.sample)
    for value, known, step in ((focus.ratio, ratio, 1e-3), (focus.axial_fwhm, width, 1e-9), (focus.peak, peak, 1e-3)):
        if known is not None:
            assert value == pytest.approx(known * (1e-9 if known > 2 else 1.0), abs=step)


def test_the_brightest_focus_is_a_maximum_of_the_light_on_the_axis():
    focus = OBJECTIVE.focus([0.0, 3e-6], wavelength=WAVE)
    for k, depth in enumerate((0.0, 3e-6)):
        around = focus.brightest[k] + np.linspace(-1e-6, 1e-6, 401)
        light = OBJECTIVE.fields(0.0, depth=depth, focus=around, wavelength=WAVE).intensity
        assert light.argmax() == 200
        assert light[200] == pytest.approx(focus.peak[k])
        width = np.ptp(around[light > 0.5 * light[200]])
        assert width == pytest.approx(focus.axial_fwhm[k], abs=1.1e-8)


def test_the_lateral_width_is_where_the_light_has_fallen_to_half():
    focus = OBJECTIVE.focus(3e-6, wavelength=WAVE)
    light = OBJECTIVE.fields([0.0, 0.5 * focus.lateral_fwhm], depth=3e-6, focus=focus.brightest, wavelength=WAVE)
    assert light.intensity[1] == pytest.approx(0.5 * light.intensity[0], rel=1e-8)


def test_a_dry_objective_of_small_aperture_has_the_widths_of_airy():
    one = used(0.05, 1.0, 1.0001, 1.0)
    focus = one.focus(0.0, wavelength=WAVE)
    assert focus.lateral_fwhm == pytest.approx(0.5145 * WAVE / 0.05, rel=2e-3)
    assert focus.axial_fwhm == pytest.approx(0.8859 * 2 * WAVE / 0.05**2, rel=2e-3)
    assert focus.peak == pytest.approx(1.0, abs=2e-3)
    assert focus.brightest == pytest.approx(0.0, abs=1e-3 * focus.axial_fwhm)


def test_the_peak_is_that_of_scalar_theory_without_surfaces():
    # Paraxial light of unit amplitude in air: Fresnel's amplitude of glass, then of water.
    amplitude = 2.0 / (1.0 + 1.5255) * 2.0 * 1.5255 / (1.5255 + 1.33)
    assert used(0.02, 1.0, 1.5255, 1.33).focus(5e-6, wavelength=WAVE).peak == pytest.approx(amplitude**2, rel=1e-5)
    # In one medium: the aplanatic amplitude and the mean of both polarizations.
    cosine = np.sqrt(1.0 - (1.4 / 1.515) ** 2 * (np.arange(20_000) + 0.5) / 20_000)  # of equal parts of the aperture
    field = float(np.mean((1.0 + cosine) / (2.0 * np.sqrt(cosine))))
    assert used(1.4, 1.515, 1.515, 1.515).focus(5e-6, wavelength=WAVE).peak == pytest.approx(field**2, rel=1e-6)


def test_layers_of_one_index_move_the_focus_with_the_emitter():
    one = used(1.2, 1.4, 1.4, 1.4)
    focus = one.focus([1e-6, 30e-6], wavelength=WAVE)
    assert focus.brightest == pytest.approx([1e-6, 30e-6], abs=1e-13)
    assert focus.ratio == pytest.approx([1.0, 1.0], abs=1e-6)
    assert focus.peak[0] == pytest.approx(focus.peak[1])


def test_glass_that_is_thicker_than_the_design_s_blurs_the_focus():
    thick = replace(used(0.95, 1.0, 1.5255, 1.0), coverslip=lm.Layer(1.5255, 180e-6))
    assert thick.design.coverslip == GLASS
    exact, blurred = (one.focus(0.0, wavelength=WAVE) for one in (used(0.95, 1.0, 1.5255, 1.0), thick))
    assert blurred.peak < 0.5 * exact.peak
    # Rays of the rim meet nearer to the objective: at -(10 um / n_g) (1 - c_i / c_g).
    cosines = [math.sqrt(1 - (0.95 / n) ** 2) for n in (1.0, 1.5255)]
    rim = -10e-6 / 1.5255 * (1 - cosines[0] / cosines[1])
    assert rim < blurred.brightest < -0.5e-6
    assert blurred.paraxial == 0.0


def test_light_is_collected_by_depth():
    depths = [[0.0, 0.5e-6], [2e-6, 20e-6]]
    light = OBJECTIVE.collected(depths, wavelength=WAVE)
    assert light.shape == (2, 2)
    assert (np.diff(light.ravel()) < 0).all()
    assert light[1, 1] == pytest.approx(1.0, abs=1e-4)
    assert used(1.2, 1.333, 1.5255, 1.33).collected(0.0, wavelength=WAVE) == pytest.approx(1.0)


def test_nyquist_s_steps_are_those_of_the_largest_angles():
    steps = OBJECTIVE.nyquist(wavelength=WAVE)
    assert steps.lateral == pytest.approx(WAVE / (4 * 1.4))
    assert steps.axial == pytest.approx(WAVE / (2 * (1.518 - math.sqrt(1.518**2 - 1.4**2))))
    assert steps.pixel == pytest.approx(63 * steps.lateral)


def test_the_critical_angle_is_snell_s():
    angle = OBJECTIVE.critical_angle
    assert math.sin(angle) * 1.518 == pytest.approx(1.33)
    assert used(1.2, 1.333, 1.5255, 1.36).critical_angle is None


def test_fields_have_the_shape_of_the_planes_and_of_the_radii():
    focus = [1e-6, 2e-6, 3e-6, 4e-6]
    fields = OBJECTIVE.fields(np.zeros((2, 3)), depth=[[1e-6], [2e-6]], focus=focus, wavelength=WAVE)
    assert fields.K0.shape == fields.intensity.shape == fields.intensity_error.shape == (2, 4, 2, 3)
    one = OBJECTIVE.fields(0.0, depth=2e-6, focus=3e-6, wavelength=WAVE)
    assert one.K0.shape == ()
    assert fields.K0[1, 2, 0, 0] == pytest.approx(complex(one.K0), abs=2e-10)


POWERS = (0.8, -0.3, 0.5)


def test_fields_with_an_apodization_are_those_of_a_plain_quadrature():
    light, k = lm.Apodization(POWERS), 2.0 * math.pi / WAVE
    depth, focus, r = 0.5e-6, 0.7e-6, 300e-9
    x, w = np.polynomial.legendre.leggauss(300)
    critical = GIVEN["sample"] / GIVEN["NA"]
    u, w = 0.5 * (1.0 + x), 0.5 * w
    # Smooth on both sides of the critical angle.
    rho = np.concatenate([critical * (1.0 - (1.0 - u) ** 2), critical + (1.0 - critical) * u**2])
    weight = np.concatenate([critical * 2.0 * (1.0 - u) * w, (1.0 - critical) * 2.0 * u * w])
    t_s, t_p = transmission(OBJECTIVE, rho, WAVE)
    sine = GIVEN["NA"] * rho
    psi = phase(OBJECTIVE, rho, depth=depth, focus=focus, wavelength=WAVE)
    t = rho**2
    amplitude = np.exp(-(light.exponent[0] + POWERS[0] * t + POWERS[1] * t**2 + POWERS[2] * t**3))
    one = amplitude * (1.0 - (sine / GIVEN["immersion"]) ** 2) ** -0.25 * np.exp(1j * psi) * rho * weight
    c_s = np.sqrt((1.0 - (sine / GIVEN["sample"]) ** 2).astype(complex))
    v = k * GIVEN["NA"] * r * rho
    true = [
        (one * (t_s + t_p * c_s) * jv(0, v)).sum(),
        (one * t_p * sine / GIVEN["sample"] * jv(1, v)).sum(),
        (one * (t_s - t_p * c_s) * jv(2, v)).sum(),
    ]
    found = lm.Objective(**GIVEN, apodization=light).fields(r, depth=depth, focus=focus, wavelength=WAVE)
    np.testing.assert_allclose([found.K0, found.K1, found.K2], true, rtol=0, atol=found.error)
    assert found.error < 1e-9


@pytest.mark.parametrize("aberrations", [None, lm.Wavefront.zernike({5: 0.3, 8: -0.2}, order="noll")])
def test_methods_agree_on_an_apodized_objective_within_their_bounds(aberrations):
    objective = lm.Objective(**GIVEN, apodization=lm.Apodization(POWERS))
    pupil = objective.pupil(depth=0.5e-6, z=[-0.4e-6, 0.3e-6], wavelength=WAVE, aberrations=aberrations)
    methods = (DebyeRings, ChordalDebye) if aberrations else (
        DebyeWolf, Stratified, ChordalDebye
    )  # fmt: skip
    made = [lm.psf(pupil, 13, 6.5e-6, method=method(tol=1e-7)) for method in methods]
    for one in made[1:]:
        off = np.abs(one.values - made[0].values).max()
        assert off <= (one.error_bound + made[0].error_bound) * one.values.max()
    plain = OBJECTIVE.pupil(depth=0.5e-6, z=[-0.4e-6, 0.3e-6], wavelength=WAVE, aberrations=aberrations)
    assert np.abs(lm.psf(plain, 13, 6.5e-6).values - made[0].values).max() > 0.05 * made[0].values.max()
    assert type(pupil).from_dict(pupil.to_dict()) == pupil


def test_a_gaussian_beam_that_fills_little_of_the_pupil_is_wide():
    gaussian = lm.Objective(NA=0.3, immersion=1.0, apodization=8.0)
    width = gaussian.focus(0.0, wavelength=WAVE).lateral_fwhm
    # exp(-g rho^2) has the focus exp(-(k NA r)^2 / (2 g)) where the edge is dark.
    assert width == pytest.approx(2.0 * math.sqrt(8.0 * 2.0 * math.log(2.0)) * WAVE / (2 * math.pi * 0.3), rel=0.01)


def scalar(objective, **how):
    """Return the intensity of the scalar model in focus on the axis and 0.3 and 0.6 um from it, over its light."""
    pupil = objective.pupil(depth=0.0, z=0.0, origin="coverslip", wavelength=WAVE, emitter=lm.Scalar(**how))
    pixel = 0.3e-6 * objective.magnification
    answer = lm.psf(pupil, (1, 5), pixel, tol=1e-10, integrate=False, dtype=np.float64)
    return answer.values[0, 2:] / answer.scale


def test_the_scalar_model_without_layers_is_airy_s():
    one = used(0.6, 1.0, 1.5255, 1.0)
    v = 2 * math.pi / WAVE * 0.6 * np.array([1e-12, 3e-7, 6e-7])
    assert np.abs(scalar(one) - (2 * j1(v) / v) ** 2).max() < 1e-9
    cosine = math.sqrt(1 - 0.6**2)  # 2 int c^(-1/2) rho d rho = (4/3) (1 - c^(3/2)) / NA^2
    lit, light = scalar(one, apodization="aplanatic")[0], 2 * (1 - cosine) / 0.36  # 2 int c^(-1) rho d rho
    assert lit == pytest.approx((4 / 3 * (1 - cosine**1.5) / 0.36) ** 2 / light)


def test_the_published_scalar_model_ends_at_the_critical_angle():
    assert scalar(OBJECTIVE)[0] == pytest.approx(1.0)
    assert scalar(OBJECTIVE, supercritical=False)[0] == pytest.approx((1.33 / 1.4) ** 2)  # of so much light


def test_dipoles_add_up_to_one_that_turns_freely():
    light = OBJECTIVE.fields(2e-7, depth=1e-6, focus=1.5e-6, wavelength=WAVE)
    K0, K1, K2, phi = complex(light.K0), complex(light.K1), complex(light.K2), 0.7
    c, s = math.cos(2 * phi), math.sin(2 * phi)
    x, y, z = (K0 + K2 * c, K2 * s), (K2 * s, K0 - K2 * c), (-2j * K1 * math.cos(phi), -2j * K1 * math.sin(phi))
    total = sum(abs(part) ** 2 for dipole in (x, y, z) for part in dipole)
    # Two directions of the camera for three of the emitter.
    assert total == pytest.approx(2 * light.intensity)


def test_of_one_medium_aperture_and_index_say_all():
    plain = lm.Objective(NA=1.2, immersion=1.34)
    full = lm.Objective(NA=1.2, magnification=60, immersion=1.34, working_distance=1e-4, coverslip=None, sample=1.34)
    planes = {"depth": 3e-6, "z": np.array([-4e-7, 0.0, 5e-7]), "wavelength": 520e-9}
    found = lm.psf(plain.pupil(**planes), 15, 0.1e-6)
    assert np.array_equal(found.values, lm.psf(full.pupil(**planes), 15, 6e-6).values)
    assert found.fwhm() == pytest.approx(lm.psf(full.pupil(**planes), 15, 6e-6).fwhm() / 60)
    # The light is that of the index matched throughout, so that it depends on no depth.
    elsewhere = lm.psf(plain.pupil(**planes | {"depth": 8e-6}), 15, 0.1e-6)
    assert found.values == pytest.approx(elsewhere.values, abs=1e-6 * float(found.values.max()))
    with pytest.raises(ValueError, match=r"at most 10 mm without a working_distance, got 20 mm"):
        plain.pupil(**planes | {"z": 0.02, "depth": 0.0})


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"coverslip": GLASS, "working_distance": 1e-4}, "sample must be given with a coverslip"),
        ({"coverslip": GLASS, "sample": 1.34}, "working_distance must be given, in metres, with a coverslip"),
        ({"design": Design(1.33, None)}, "working_distance must be given, .* with a coverslip or a design"),
    ],
)
def test_what_the_layers_depend_on_must_be_given(given, message):
    with pytest.raises(ValueError, match=message):
        lm.Objective(NA=1.2, immersion=1.34, **given)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"NA": 1.518}, r"NA must be below the index of immersion, 1.518, got 1.518"),
        ({"coverslip": lm.Layer(1.35, 17e-5)}, r"NA must be below the index of coverslip, 1.35, got 1.4"),
        ({"design": Design(1.33, GLASS)}, r"NA must be below the index of design.immersion, 1.33, got 1.4"),
        ({"design": Design(1.5, lm.Layer(1.4, 0.0))}, r"NA must be below the index of design.coverslip, 1.4"),
        ({"working_distance": 0.19}, r"working_distance is in metres .* 0.1, got 0.19; .* for 0.19 mm 0.19e-3"),
        ({"working_distance": 1e-5, "design": Design(1.518, None)}, "working_distance must leave room for"),
    ],
)
def test_what_is_no_objective_is_refused_in_a_line(change, message):
    with pytest.raises((TypeError, ValueError), match=message) as told:
        lm.Objective(**{**GIVEN, **change})
    assert "\n" not in str(told.value)


def debye_waves(depth, sample=1.47, NA=1.4, n=1.518, wave=520e-9):
    """Strehl ratio and rms (waves) of an index step at a depth, by Debye's integral without losses at surfaces."""
    rho = np.sqrt((np.arange(800) + 0.5) / 800)
    path = [np.sqrt(index**2 - (NA * rho) ** 2) for index in (sample, n)]
    weights = (1.0 + path[1] / n) / np.sqrt(path[1])
    z = np.linspace(-2.0, 2.0, 4001) * depth
    k = 2.0 * np.pi / wave
    fields = np.exp(1j * k * (depth * path[0] + z[:, None] * path[1])) @ weights
    basis = np.stack([np.ones_like(rho), path[1]], axis=1)
    left = depth * (path[0] - basis @ np.linalg.lstsq(basis, path[0], rcond=None)[0])
    return np.abs(fields).max() ** 2 / weights.sum() ** 2, left.std() / wave


def test_the_strehl_ratio_of_media_is_that_of_another_integral():
    layers = layers_of(lm.Objective(NA=1.4, immersion=1.518, sample=1.47), 520e-9)
    for depth in (1.5e-6, 3.5e-6):
        strehl, rms = debye_waves(depth)
        assert media_strehl(layers, depth) == pytest.approx(strehl, abs=0.03 * (1.0 - strehl))
        assert np.linalg.norm(aberration(layers, depth, {})) / (2.0 * np.pi) == pytest.approx(rms, rel=1e-3)
    assert media_strehl(layers, 0.0) == pytest.approx(1.0, abs=1e-12)
    assert np.linalg.norm(aberration(layers, 0.0, {(1, 1): 3.0, (2, 2): 0.3, (3, -1): 0.4})) == pytest.approx(0.5)


def test_supercritical_light_that_a_depth_leaves_no_part_of_has_no_wavefront():
    layers = layers_of(lm.Objective(NA=1.49, immersion=1.518, sample=1.33), 520e-9)
    below = layers_of(lm.Objective(NA=1.33 - 1e-6, immersion=1.518, sample=1.33), 520e-9)
    far, inside = (np.linalg.norm(aberration(one, 50e-6, {})) for one in (layers, below))
    assert far == pytest.approx(inside, rel=0.08)
    assert 0.99 < media_strehl(layers, 50e-9) < 1.01
