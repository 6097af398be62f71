"""What ``lommel info`` says of a lens: its numbers are those of the library, in the units of its field."""

from __future__ import annotations

import dataclasses
import math
from types import SimpleNamespace

import numpy as np
import pytest

import lommel as lm
from lommel.report import Report, image_quality
from lommel.report.image_quality import IN_FOCUS
from lommel.report.optics import describe_lens, how_made, summarize_lens
from lommel.report.table import tables


@pytest.fixture(scope="module")
def phone(lenses):
    return dataclasses.replace(lm.load_instrument(lenses["phone"]), object_distance=1.2, pixel=2e-6)


@pytest.fixture(scope="module")
def facts(phone):
    return describe_lens(phone).facts


def test_the_numbers_are_those_of_the_library(facts, phone):
    lens, psf = phone.lens, lm.psf(phone.pupil(), 8, 2e-6)
    c = float(lens.defocus(1.2))
    assert facts["waves"]["W020"] == pytest.approx(c / np.pi)
    assert facts["strehl"] == pytest.approx((np.sin(c) / c) ** 2)
    for key, value in {
        "defocus": c,
        "rms_waves": lm.rms(psf.pupil, unit="waves"),
        "marechal": lm.marechal(psf.pupil),
        "fwhm": psf.fwhm(of="optics"),
        "fwhm_with_pixel": psf.fwhm(),
        "diameter_80": psf.energy_diameter(0.8, of="optics"),
        "diameter_80_with_pixel": psf.energy_diameter(0.8),
        "cutoff": 1 / (lens.wavelength * lens.working_f_number),
        "mtf50": lm.mtf_frequency(psf.pupil),
        "nyquist": 250e3,
        "mtf_at_nyquist": lm.mtf(psf.pupil, 250e3),
        "mtf_at_nyquist_with_pixel": lm.mtf(psf.pupil, 250e3) * 2 / np.pi,
    }.items():
        assert facts[key] == pytest.approx(float(value), rel=1e-5), key
    ideal = lm.psf(psf.pupil.unaberrated(), 1, 2e-6)
    for row in facts["encircled_energy"]:
        assert row["fraction"] == pytest.approx(psf.encircled_energy(row["radius"], of="optics"), abs=1e-6)
        assert row["unaberrated"] == pytest.approx(ideal.encircled_energy(row["radius"], of="optics"), abs=1e-6)


def diameters_80(wavefront: lm.Wavefront) -> tuple[float, float]:
    """Return the diameters of 80 % of the light about the axis and about the centroid, lambda*N, by an FFT."""
    side, across = 512, 64
    x = (np.arange(across) - (across - 1) / 2) * 2 / across
    rho, theta = np.hypot(x, x[:, None]), np.arctan2(x[:, None], x[None])
    field = np.where(rho <= 1, np.exp(1j * wavefront.phase(np.minimum(rho, 1), theta)), 0)
    # The middle of the pupil is between pixels: only phases of the field depend on it.
    light = np.fft.fftshift(np.abs(np.fft.fft2(field, (side, side))) ** 2)
    v = (np.arange(side) - side // 2) * across / side
    light /= light.sum()
    middle = [(light.sum(axis=axis) * v).sum() for axis in (0, 1)]
    found = []
    for center in ((0.0, 0.0), middle):
        r = np.hypot(v - center[0], v[:, None] - center[1]).ravel()
        order = np.argsort(r)
        found.append(2 * r[order][np.searchsorted(np.cumsum(light.ravel()[order]), 0.8)])
    return found[0], found[1]


def test_the_diameter_is_about_the_axis_and_of_comatic_lenses_also_about_the_centroid(phone):
    coma = lm.Wavefront.zernike({(1, 1): 0.2, (3, 1): 0.15, (3, -1): 0.1}, unit="waves")
    lens = dataclasses.replace(phone.lens, aberrations=coma)
    comatic = dataclasses.replace(phone, lens=lens, object_distance=lens.focus_distance)
    found, pupil = describe_lens(comatic).facts, comatic.pupil()
    for key, true in zip(("diameter_80", "diameter_80_about_centroid"), diameters_80(pupil.wavefront), strict=True):
        assert found[key] == pytest.approx(true * pupil.scale, rel=0.03), key
    assert found["diameter_80"] > 1.1 * found["diameter_80_about_centroid"]
    assert found["diameter_80"] == pytest.approx(lm.psf(pupil, 1, 2e-6).energy_diameter(0.8, of="optics"))
    assert "diameter_80_about_centroid" not in describe_lens(phone).facts


@pytest.mark.parametrize("focus", [0.5, 3.0, math.inf])
def test_at_the_ends_of_the_depth_of_field_the_blur_is_of_two_pixels(phone, focus):
    lens = phone.lens.focused(focus)
    found = summarize_lens(dataclasses.replace(phone, lens=lens)).facts
    ends = [found["in_focus"]["near"], math.inf if found["in_focus"]["far"] is None else found["in_focus"]["far"]]
    assert found["in_focus"]["blur"] == IN_FOCUS * phone.pixel
    for end in ends:
        blur = 2 * float(lens.pupil(end).geometric_radius())
        # Beyond the hyperfocal distance all that is far is sharper than that.
        assert blur == pytest.approx(IN_FOCUS * phone.pixel) or (math.isinf(end) and blur < IN_FOCUS * phone.pixel)
    far = phone.lens.focused(found["hyperfocal_distance"])
    assert 2 * float(far.pupil(math.inf).geometric_radius()) == pytest.approx(IN_FOCUS * phone.pixel)


@pytest.mark.parametrize("obscuration", [0.0, 0.25, 0.95])
def test_the_first_dark_ring_is_of_the_obscured_aperture(phone, obscuration):
    lens = dataclasses.replace(phone.lens, obscuration=obscuration)
    facts = describe_lens(dataclasses.replace(phone, lens=lens)).facts
    ring, pupil = facts["dark_ring_radius"], lens.pupil(1.2).unaberrated()
    light = lm.psf(pupil, (1, 100), ring / 99, center=(0, 0), integrate=False, normalize="strehl").values[0]
    assert light[-1] < 1e-9
    assert (np.diff(light) < 1e-9).all()  # none is nearer
    assert ring == pytest.approx(facts["airy_radius"] * {0.0: 1, 0.25: 0.93596, 0.95: 0.64364}[obscuration], rel=1e-5)


def test_the_error_of_the_light_within_radii_is_the_larger_one(phone):
    def told(*errors):
        found = iter([error and SimpleNamespace(fraction=np.full(9, 0.5), error=error[0]) for error in errors])
        return image_quality._encircled(phone, lambda *_: next(found))["encircled_energy_error"]

    assert [told((1e-3,), (2e-3,)), told((2e-3,), (None,)), told(None, (None,))] == [2e-3, 2e-3, None]


def test_each_psf_of_a_stack_has_its_peak_and_the_sum_that_is_not_its_light():
    made = how_made(lm.psf(lm.Pupil(lm.Wavefront([0.0, 2.0])), (3, 5), 3.0, integrate=False), 0.5)
    values = lm.psf(lm.Pupil(lm.Wavefront([0.0, 2.0])), (3, 5), 3.0, integrate=False).values
    assert made["peak"] == [values[0].max(), values[1].max()]
    assert made["sum"] == pytest.approx([values[0].sum(), values[1].sum()])
    assert how_made(lm.psf(lm.Pupil(), 3, 0.5), 0.5)["sum"] is None


def test_values_are_told_with_their_errors_and_none_as_a_dash():
    facts = {
        "terms": {"a": 1.234, "b": 2.0, "d": 2.5e-7}, "others": {"a": 1.0, "c": 2.0}, "images": ["x.tif", "y.tif"],
        "blur": [1.234, None], "counts": [1, 2], "text": "blur",
        "errors": {"a": 0.05, "b": 0.5, "blur": [0.012, 0.1], "d": 3e-9},
        "units": {"a": "nm", "blur": "px", "d": "m"},
    }  # fmt: skip
    (values, _, columns) = tables(facts, {"a": "noll 4"})
    shown = [[*map(str, column._cells)] for column in values.columns]
    assert shown == [
        ["noll 4", "b", "d"], ["1.234", "2.00", "250.0"], ["0.050", "0.50", "3.0"], ["nm", "", "nm"],
    ]  # fmt: skip
    assert [str(column.header) for column in values.columns] == ["terms", "value", "std. error", "unit"]
    assert [[*column._cells] for column in columns.columns] == [["x.tif", "y.tif"], ["1.234+-0.012", "-"]]
    assert [Report({"reliable": given}, []).exit_code for given in (True, False, None)] == [0, 4, 0]
    assert Report({"reliable": False}, [], succeeded=False).exit_code == 3


def test_tilt_moves_the_image_and_is_told_apart(lenses, monkeypatch):
    monkeypatch.setattr("lommel.report.image_quality.mtf50", lambda *_: None)  # takes longer than all others
    instrument = lm.load_instrument(lenses["newtonian-off-axis"])
    tilted = instrument.lens.aberrations + lm.Wavefront.zernike({(1, 1): 5.0, (1, -1): -3.0})
    lens = dataclasses.replace(instrument.lens, aberrations=tilted, focus_distance=math.inf, sensor_distance=None)
    before, after = (describe_lens(one).facts for one in (instrument, dataclasses.replace(instrument, lens=lens)))
    for name in ("strehl_at_peak", "rms_waves_without_tilt"):
        assert after[name] == pytest.approx(before[name], rel=1e-6)
    assert after["rms_waves"] != pytest.approx(before["rms_waves"], rel=0.1)
    assert before["rms_waves_without_tilt"] < 0.5 * before["rms_waves"]
    image = lm.psf(instrument.pupil(), 201, 0.1 * instrument.pupil().scale, integrate=False)
    assert before["strehl_at_peak"] == pytest.approx(image.peak_strehl, rel=1e-2)


def test_the_balancing_defocus_leaves_the_least_rms(lenses):
    facts = describe_lens(lm.load_instrument(lenses["hubble-1990"])).facts
    pupil = lm.load_instrument(lenses["hubble-1990"]).pupil()
    away = (facts["balancing_W020"] - facts["waves"]["W020"]) * np.pi
    at = [lm.rms(dataclasses.replace(pupil, wavefront=pupil.wavefront + lm.Wavefront(away + more), geometry=None))
          for more in (-0.1, 0.0, 0.1)]  # fmt: skip
    assert at[1] < min(at[0], at[2])
    # Over an annulus it balances (1 + obscuration^2) times the spherical aberration.
    assert facts["balancing_W020"] == pytest.approx(-(1 + 0.33**2) * facts["waves"]["W040"])


def test_a_ring_is_brighter_than_the_axis():
    lens = lm.Lens(focal_length=50e-3, f_number=8, focus_distance=2.0, wavelength=550e-9)
    # Two waves of defocus: nothing on the axis.
    near = 1 / (1 / 2.0 + 16 * lens.wavelength / lens.aperture_diameter**2)
    assert float(lens.defocus(near)) == pytest.approx(2 * np.pi, rel=1e-3)
    from lommel.lensfiles.instrument import Instrument

    facts = describe_lens(Instrument("ring", "", lens, near, 1e-6, None, {})).facts
    profile = lm.psf(lens.pupil(near), 121, 0.5e-6, integrate=False)
    assert facts["strehl"] < 1e-4
    assert facts["strehl_at_peak"] == pytest.approx(profile.peak_strehl, rel=1e-2)
