"""PSFs of microscopes that scan, light sheets and beads: their widths, their planes, what is refused."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import lommel as lm
from lommel import microscopy as room
from lommel.optics.layers.emitter import Absorbed

WATER = lm.Objective(
    NA=1.2,
    magnification=60,
    immersion=1.333,
    working_distance=0.28e-3,
    coverslip=lm.Layer(1.5255, 170e-6),
    sample=1.36,
)
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
    small = lm.microscopy.confocal(excitation, emission, 9, PIXEL, pinhole=1e-3, normalize="peak")
    product = lit.values * lm.psf(emission, 9, PIXEL, integrate=False, normalize="strehl").values
    assert small.values == pytest.approx(product / product.max(), abs=1e-5)


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
        lambda tol: lm.microscopy.confocal(excitation, emission, 9, PIXEL, tol=tol, normalize="peak"),
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
    small = lm.microscopy.confocal(excitation, emission, 9, PIXEL, pinhole=1e-3, normalize="peak")
    product = lit.values * lm.psf(emission, 9, PIXEL, integrate=False, normalize="strehl").values
    assert small.values == pytest.approx(product / product.max(), abs=1e-5)


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
    plain, lit = lm.psf(emission, 9, PIXEL), lm.microscopy.light_sheet(emission, 1e-6, 9, PIXEL)
    assert lit.values == pytest.approx(plain.values * 2.0 ** -((Z / 0.5e-6) ** 2)[:, None, None], rel=1e-6)
    away = np.array([0.5e-6])
    half = lm.microscopy.light_sheet(emission, 1e-6, 9, PIXEL, offset=away)
    assert half.values == pytest.approx(0.5 * plain.values, rel=1e-6)
    assert lit.profile([0.0, 1e-5])[1] == pytest.approx(
        plain.profile([0.0, 1e-5])[1] * (lit.scale / plain.scale)[:, None]
    )
    assert lit.axial_fwhm() < plain.axial_fwhm()


def test_a_sheet_takes_dipoles():
    tilted = WATER.pupil(depth=DEPTH, z=Z[2:5], wavelength=525e-9, emitter=lm.Dipole(1.0, 0.3))
    plain, lit = lm.psf(tilted, 5, PIXEL, tol=1e-4), lm.microscopy.light_sheet(tilted, 1e-6, 5, PIXEL, tol=1e-4)
    assert lit.values[1] == pytest.approx(plain.values[1], rel=1e-5)
    assert np.all(lit.values[0] < plain.values[0])


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (
            lambda ex, em: room.confocal(em, ex, 9, PIXEL, normalize="energy"),
            "normalize must be one of 'stre",
        ),
        (lambda ex, em: room.confocal(ex[:2], em, 9, PIXEL), r"of shape \(7,\), got \(2,\)"),
        (
            lambda ex, em: room.confocal(ex[::-1], em, 9, PIXEL),
            "a focus up to 3e-06 metres off; objective.pu",
        ),
        (
            lambda ex, em: room.confocal(488e-9, em, 9, PIXEL),
            "excitation must be an ObjectivePupil, got 4.88",
        ),
        (
            lambda ex, em: room.two_photon(em, 9, PIXEL, normalize="emitted"),
            "normalize must be one of 'stre",
        ),
        (lambda ex, em: room.light_sheet(em, 0.0, 9, PIXEL), "thickness must be > 0 metres, got 0"),
        (lambda ex, em: room.light_sheet(em, 1e-7, 9, PIXEL), "offset must be within 5 times the thickness"),
        (
            lambda ex, em: room.light_sheet(em, 1e-6, 9, PIXEL, offset=[[0.0], [0.0]]),
            "offset must broadcast",
        ),
        (
            lambda ex, em: room.light_sheet(em, 1e-6, 9, PIXEL, offset=[0.0, 1.0]),
            "offset and the stack must",
        ),
        (
            lambda ex, em: room.light_sheet(em, 1e-6, 9, PIXEL, tol=1.0),
            "tol must be >= 1e-12 and < 0.1, got 1",
        ),
        (lambda ex, em: room.bead("bead", 1e-7, 9, PIXEL), "pupil must be an ObjectivePupil, got 'bead'"),
    ],
)
def test_what_makes_no_psf_is_refused(make, said):
    with pytest.raises((TypeError, ValueError), match=said):
        make(*colours(Z))
