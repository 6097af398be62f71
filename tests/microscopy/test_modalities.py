"""Confocal, two-photon, light-sheet and STED PSFs."""

from __future__ import annotations

import dataclasses
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.special import jv

import lommel as lm
from lommel import microscopy as room
from lommel.methods.layers.scanning import crest
from lommel.optics.layers.emitter import Absorbed
from objectives import WATER_60X, phase, transmission

WATER = WATER_60X
DEPTH, PIXEL = 20e-6, 6e-6
Z = np.linspace(-1.5e-6, 1.5e-6, 7)


def colours(z=0.0):
    emission = WATER.pupil(depth=DEPTH, z=z, wavelength=525e-9)
    beam = {"wavelength": 488e-9, "emitter": lm.Beam("circular"), "origin": "coverslip"}
    return WATER.pupil(depth=DEPTH, z=emission.focus, **beam), emission


def test_widths_are_those_that_quadrature_gave():
    excitation, emission = colours()
    infrared = WATER.pupil(depth=DEPTH, wavelength=800e-9, emitter=lm.Beam("circular"))
    wide = lm.psf(emission, 9, PIXEL)
    sharp = lm.microscopy.confocal(excitation, emission, 9, PIXEL)
    twice = lm.microscopy.two_photon(infrared, 9, PIXEL)
    found = [1e9 * float(made.fwhm(of="optics")) / 60 for made in (wide, sharp, twice)]
    assert found == pytest.approx([246.7, 219.5, 267.4], abs=0.15)


def test_a_wide_pinhole_leaves_the_excitation_and_a_small_one_the_product():
    excitation, emission = colours()
    # Far from the axis, in a circle of 8 Airy units, nearly all light arrives.
    wide = lm.microscopy.confocal(excitation, emission, 9, PIXEL, pinhole=8.0)
    lit = lm.psf(excitation, 9, PIXEL, integrate=False, normalize="strehl")
    assert wide.values == pytest.approx(lit.values, rel=0.06)
    small = lm.microscopy.confocal(excitation, emission, 9, PIXEL, pinhole=1e-3)
    product = lit.values * lm.psf(emission, 9, PIXEL, integrate=False, normalize="strehl").values
    assert small.values / small.values.max() == pytest.approx(product / product.max(), abs=1e-5)


def test_layers_out_of_focus_fade_where_there_is_a_pinhole_or_two_photons():
    excitation, emission = colours(Z)
    layer = {
        "wide": lm.psf(emission, 9, PIXEL),
        "confocal": lm.microscopy.confocal(excitation, emission, 9, PIXEL),
        "two photons": lm.microscopy.two_photon(excitation, 9, PIXEL),
    }
    light = {name: made.encircled_energy(4e-4) for name, made in layer.items()}
    assert np.ptp(light["wide"]) < 0.03
    for name in ("confocal", "two photons"):
        assert light[name][[0, -1]].max() < 0.35 * light[name].max()


def test_bounds_are_below_the_tolerance_and_hold_against_a_finer_one():
    excitation, emission = colours(Z[::3])
    ways = [
        lambda tol: lm.microscopy.confocal(excitation, emission, 9, PIXEL, tol=tol),
        lambda tol: lm.microscopy.two_photon(excitation, 9, PIXEL, tol=tol),
        lambda tol: lm.microscopy.light_sheet(emission, 1e-6, 9, PIXEL, tol=tol),
        lambda tol: lm.microscopy.bead(emission, 200e-9, 9, PIXEL, tol=tol),
    ]
    for way in ways:
        fine = way(1e-8).values
        for tol in (1e-3, 1e-6):
            made = way(tol)
            error = np.abs(made.values - fine).max(axis=(1, 2)) / fine.max(axis=(1, 2))
            assert error.max() <= made.error_bound + 1e-8
            assert made.error_bound <= tol


def polarised(polarization, emitter="isotropic", z=0.0):
    emission = WATER.pupil(depth=DEPTH, z=z, wavelength=525e-9, emitter=emitter)
    laser = {"wavelength": 488e-9, "emitter": lm.Beam(polarization), "origin": "coverslip"}
    return WATER.pupil(depth=DEPTH, z=emission.focus, **laser), emission


@pytest.mark.parametrize("emitter", ["isotropic", lm.Dipole(0.8, 0.5)], ids=repr)
def test_two_crossed_lasers_are_twice_one_that_is_not_polarised(emitter):
    # Its part along a dipole, too, is the sum of both: (1, i) has a quarter of a wave between them.
    made = {
        name: lm.microscopy.confocal(*polarised(name, emitter, Z[2:4]), 9, PIXEL, tol=1e-8).values
        for name in ("x", "y", "circular")
    }
    if emitter == "isotropic":
        assert made["x"] + made["y"] == pytest.approx(2.0 * made["circular"], abs=1e-7)
        assert made["y"] == pytest.approx(made["x"].swapaxes(1, 2), abs=1e-8)
        return
    left = lm.microscopy.confocal(*polarised((1.0, -1.0j), emitter, Z[2:4]), 9, PIXEL, tol=1e-8).values
    assert made["x"] + made["y"] == pytest.approx(made["circular"] + left, abs=1e-7)
    assert np.abs(left - made["circular"]).max() > 0.01 * left.max()


def test_a_polarised_laser_makes_a_longer_spot_and_around_the_axis_the_same():
    excitation, emission = polarised("x")
    long = lm.microscopy.confocal(excitation, emission, 17, 3e-6)
    assert float(long.fwhm("x")) > 1.04 * float(long.fwhm("y"))
    even = lm.microscopy.confocal(*polarised("circular"), 17, 3e-6)
    assert float(even.fwhm()) == pytest.approx(float(long.fwhm("mean")), rel=0.02)
    # The mean over all azimuths is that of light that is not polarised; its square is not.
    v = np.linspace(0.0, 8.0, 20)
    assert long.method.profile(emission, v).values == pytest.approx(even.method.profile(emission, v).values, abs=1e-6)
    infrared = [WATER.pupil(depth=DEPTH, wavelength=8e-7, emitter=lm.Beam(name)) for name in ("x", "circular")]
    twice = [lm.microscopy.two_photon(pupil, 9, PIXEL).method.profile(pupil, v).values for pupil in infrared]
    assert np.all(twice[0] >= twice[1] - 1e-6)
    assert twice[0].max() == pytest.approx(twice[1].max(), rel=1e-5)
    assert (twice[0] - twice[1]).max() > 1e-3


def test_all_turns_with_the_laser_and_the_dipole():
    quarter = np.pi / 2
    first = lm.microscopy.confocal(*polarised("x", lm.Dipole(0.8, 0.3)), 9, PIXEL, tol=1e-8).values
    turned = lm.microscopy.confocal(*polarised("y", lm.Dipole(0.8, 0.3 + quarter)), 9, PIXEL, tol=1e-8).values
    # From columns towards rows.
    assert turned == pytest.approx(np.rot90(first, -1), abs=1e-8)
    assert np.abs(first - np.rot90(first, 2)).max() > 1e-3 * first.max()


def test_a_dipole_that_turns_freely_is_no_dipole():
    free = lm.microscopy.confocal(*polarised("x", lm.Dipole(0.8, 0.3, wobble=1.0)), 9, PIXEL).values
    assert np.array_equal(free, lm.microscopy.confocal(*polarised("x"), 9, PIXEL).values)
    nearly = lm.microscopy.confocal(*polarised("x", lm.Dipole(0.8, 0.3, wobble=1.0 - 1e-9)), 9, PIXEL).values
    assert nearly == pytest.approx(free, abs=2e-6)


def test_a_wide_pinhole_leaves_what_a_dipole_absorbs():
    dipole = lm.Dipole(1.2, 0.7)
    excitation, emission = polarised("x", dipole)
    wide = lm.microscopy.confocal(excitation, emission, 9, PIXEL, pinhole=8.0)
    felt = replace(excitation, emitter=Absorbed("x", dipole))
    lit = lm.psf(felt, 9, PIXEL, integrate=False, normalize="strehl")
    share = float(felt.power[0] / excitation.power[0])
    assert wide.values == pytest.approx(share * lit.values, abs=0.06 * share * float(lit.values.max()))
    small = lm.microscopy.confocal(excitation, emission, 9, PIXEL, pinhole=1e-3)
    product = lit.values * lm.psf(emission, 9, PIXEL, integrate=False, normalize="strehl").values
    assert small.values / small.values.max() == pytest.approx(product / product.max(), abs=1e-5)


def test_a_bead_of_dipoles_is_a_point_where_it_is_small():
    emission = WATER.pupil(depth=DEPTH, z=Z[2:4], wavelength=525e-9, emitter=lm.Dipole(0.8, 0.5))
    for integrate in (False, True):
        point = lm.psf(emission, 7, PIXEL, integrate=integrate).values
        small = lm.microscopy.bead(emission, 1e-9, 7, PIXEL, integrate=integrate)
        assert small.values == pytest.approx(point, abs=1e-5 * float(point.max()))
        assert small.error_bound <= 1e-6


def test_stacks_of_polarised_light_are_measured_and_kept(tmp_path):
    made = lm.microscopy.confocal(*polarised("x", z=Z), 9, PIXEL)
    assert 0.4e-6 < float(made.axial_fwhm()) < 0.8e-6
    made.save(tmp_path / "spot.npz")
    again = lm.PSF.load(tmp_path / "spot.npz")
    assert np.array_equal(again.values, made.values)
    assert again.method == made.method
    assert lm.psf(again.pupil[3], 9, PIXEL, method=again.method, normalize="strehl", integrate=False).values == (
        pytest.approx(made.values[3], abs=2e-6)
    )


def test_a_sheet_lights_what_is_in_it():
    _, emission = colours(Z)
    plain = lm.psf(emission, 9, PIXEL)
    lit = lm.microscopy.light_sheet(emission, 1e-6, 9, PIXEL, offset=Z)
    assert lit.values == pytest.approx(plain.values * 2.0 ** -((Z / 0.5e-6) ** 2)[:, None, None], rel=1e-6)
    away = np.array([0.5e-6])
    half = lm.microscopy.light_sheet(emission, 1e-6, 9, PIXEL, offset=away)
    assert half.values == pytest.approx(0.5 * plain.values, rel=1e-6)
    assert lit.profile([0.0, 1e-5])[1] == pytest.approx(
        plain.profile([0.0, 1e-5])[1] * (lit.scale / plain.scale)[:, None]
    )
    assert lit.axial_fwhm() < plain.axial_fwhm()


def test_a_sheet_stays_in_focus_where_the_sample_has_another_index():
    # Of a small aperture, the plane in focus moves by the ratio of the indices.
    oil = lm.Objective(NA=0.2, magnification=10, immersion=1.518, sample=1.33, working_distance=2e-3)
    emission = oil.pupil(depth=30e-6, z=[-3e-6, 0.0, 3e-6], wavelength=525e-9)
    plain, lit = lm.psf(emission, 9, PIXEL), lm.microscopy.light_sheet(emission, 4e-6, 9, PIXEL)
    part = 2.0 ** -((3.0 * 1.33 / 1.518 / 2.0) ** 2)
    assert lit.values[[0, 2]] == pytest.approx(part * plain.values[[0, 2]], rel=0.02)


def test_a_sheet_takes_dipoles():
    tilted = WATER.pupil(depth=DEPTH, z=Z[2:5], wavelength=525e-9, emitter=lm.Dipole(1.0, 0.3))
    plain, lit = lm.psf(tilted, 5, PIXEL, tol=1e-4), lm.microscopy.light_sheet(tilted, 1e-6, 5, PIXEL, tol=1e-4)
    assert lit.values[1] == pytest.approx(plain.values[1], rel=1e-5)
    assert np.all(lit.values[0] < plain.values[0])


WATER_DEPLETED = dataclasses.replace(WATER_60X, sample=1.333)


def three(z=0.0, depth=2e-6, depleting="vortex", **other):
    emission = WATER_DEPLETED.pupil(depth=depth, z=z, wavelength=680e-9)
    planes = {"depth": depth, "z": emission.focus, "origin": "coverslip"}
    excitation = WATER_DEPLETED.pupil(**planes, wavelength=640e-9, emitter=lm.Beam(**other))
    return excitation, WATER_DEPLETED.pupil(**planes, wavelength=775e-9, emitter=lm.Beam(depleting)), emission


def test_half_is_left_on_the_crest_at_a_saturation_of_1():
    excitation, doughnut, emission = three()
    window = {"shape": 65, "pixel": 1e-6, "tol": 1e-8}
    crest = lm.psf(doughnut, 65, 1e-6, integrate=False, normalize="strehl").values.argmax()
    confocal = lm.microscopy.confocal(excitation, emission, **window).values.ravel()
    for saturation in (1.0, 3.0):
        left = lm.microscopy.sted(excitation, doughnut, emission, **window, saturation=saturation).values.ravel()
        assert left[crest] / confocal[crest] == pytest.approx(0.5**saturation, rel=1e-3)
        assert left.max() == pytest.approx(confocal.max(), rel=1e-6)


def test_spots_become_sharper_like_the_root_of_the_saturation():
    made = [lm.microscopy.sted(*three(), 9, 1e-6, saturation=s) for s in (0.0, 30.0, 90.0)]
    none, some, more = (float(each.fwhm()) / 60 for each in made)
    assert none == pytest.approx(285.4e-9, abs=0.1e-9)
    # With widths added as those of Gaussians: 1 / w^2 grows by as much for every unit.
    slopes = (some**-2 - none**-2) / 30.0, (more**-2 - none**-2) / 90.0
    assert slopes[0] == pytest.approx(slopes[1], rel=0.01)
    assert max(each.error_bound for each in made) <= 1e-6


def test_planes_out_of_focus_are_dark_for_longer_and_a_polarised_laser_serves():
    # A doughnut leaves all of the axis: the spot is a needle, as long as that of the confocal microscope.
    z = np.linspace(-1e-6, 1e-6, 9)
    excitation, doughnut, emission = three(z, polarization="x")
    needle = lm.microscopy.sted(excitation, doughnut, emission, 17, 2e-6, saturation=10.0)
    plain = lm.microscopy.confocal(excitation, emission, 17, 2e-6)
    assert needle.axial_fwhm() == pytest.approx(float(plain.axial_fwhm()), rel=0.01)
    assert needle.values[:, 8, 8] == pytest.approx(plain.values[:, 8, 8], rel=1e-4)
    assert float(needle[4].fwhm("x")) < 0.45 * float(plain[4].fwhm("x"))


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (lambda ex, _, em: room.confocal(ex[:2], em, 9, PIXEL), r"of shape \(7,\), got \(2,\)"),
        (lambda ex, _, em: room.confocal(ex[::-1], em, 9, PIXEL), "a focus up to 3e-06 metres off; objective.pu"),
        (lambda ex, _, em: room.light_sheet(em, 1e-6, 9, PIXEL, offset=[0.0, 1.0]), "offset and the stack must"),
        (lambda ex, de, em: room.sted(ex, de[::-1], em, 9, 1e-6, saturation=1.0), "depletion must have"),
        (lambda ex, de, em: room.sted(ex[::-1], de, em, 9, 1e-6, saturation=1.0), "excitation must have"),
    ],
)
def test_what_makes_no_psf_is_refused(make, said):
    with pytest.raises((TypeError, ValueError), match=said):
        make(*three(Z, DEPTH))


OIL = lm.Objective(
    NA=1.4,
    magnification=60,
    immersion=1.518,
    working_distance=0.19e-3,
    coverslip=lm.Layer(1.5255, 170e-6),
    sample=1.33,
)
WAVELENGTH = 775e-9
Complex = NDArray[np.complex128]


def angles(objective: lm.Objective) -> tuple[NDArray[np.float64], NDArray[np.float64], list[Complex]]:
    """Nodes in rho that crowd at the critical angle, weights with rho, and the amplitudes of K0, K1 and K2."""
    x, w = np.polynomial.legendre.leggauss(800)
    s, w = 0.5 * (x + 1.0), 0.5 * w
    critical = min(1.0, objective.sample / objective.NA)
    below, above = critical * (1.0 - (1.0 - s) ** 2), critical + (1.0 - critical) * s**2
    rho = np.append(below, above)
    weight = rho * np.append(2.0 * critical * (1.0 - s) * w, 2.0 * (1.0 - critical) * s * w)
    t_s, t_p = transmission(objective, rho, WAVELENGTH)
    sample = np.sqrt((1.0 - (objective.NA * rho / objective.sample) ** 2).astype(complex))
    a = (1.0 - (objective.NA * rho / objective.immersion) ** 2) ** -0.25
    return (
        rho,
        weight,
        [a * (t_s + t_p * sample), a * t_p * objective.NA * rho / objective.sample, a * (t_s - t_p * sample)],
    )


def total(parts: list[Complex], weight: NDArray[np.float64], fading: NDArray[np.float64]) -> float:
    """``(k NA)^2 / (4 pi) int I d^2r`` over a plane, by Parseval."""
    each = [np.abs(part) ** 2 * fading**2 for part in parts]
    return float(0.5 * weight @ (each[0] + 2.0 * each[1] + each[2]))


@pytest.mark.parametrize("depth", [0.3e-6, 3e-6])
def test_two_photons_are_excited_by_light_over_that_in_the_plane_of_the_emitter(depth):
    pupil = OIL.pupil(depth=depth, wavelength=WAVELENGTH, emitter=lm.Beam("circular"))
    found = lm.microscopy.two_photon(pupil, (1, 9), 6e-6)
    field = OIL.fields(np.abs(found.grid.x) / 60, depth=depth, focus=float(pupil.focus), wavelength=WAVELENGTH)
    light = np.abs(field.K0) ** 2 + 2.0 * np.abs(field.K1) ** 2 + np.abs(field.K2) ** 2
    rho, weight, parts = angles(OIL)
    psi = phase(OIL, rho, depth=depth, focus=float(pupil.focus), wavelength=WAVELENGTH)
    held = total(parts, weight, np.exp(-psi.imag))
    assert found.values[0] == pytest.approx((light / held) ** 2, abs=2e-6 * float(found.values.max()))
    # Far from the glass less light is in the plane, by what is collected of such light: one power of the laser.
    far = total([part * (rho < OIL.sample / OIL.NA) for part in parts], weight, np.ones(rho.shape))
    assert float(pupil.collected) == pytest.approx(held / far, rel=1e-6)
    if depth < 1e-6:
        assert float(pupil.collected) > 1.05


def test_the_crest_is_that_of_a_doughnut_whose_waves_have_lost_their_phase():
    pupil = OIL.pupil(depth=2e-6, wavelength=WAVELENGTH, emitter=lm.Beam("vortex"))
    rho, weight, parts = angles(OIL)
    psi = phase(OIL, rho, depth=2e-6, focus=float(pupil.focus), wavelength=WAVELENGTH)
    fading = np.exp(-psi.imag)
    v = np.linspace(1.0, 3.0, 401)
    K = [(weight * part * fading) @ jv(n + 1, np.outer(rho, v)) for n, part in enumerate(parts)]
    light = np.abs(K[0]) ** 2 + 2.0 * np.abs(K[1]) ** 2 + np.abs(K[2]) ** 2
    assert crest(pupil) == pytest.approx(float(light.max()) / total(parts, weight, fading), rel=1e-5)
