"""The names that images are differentiated by: which there are, what they mean, and what is refused."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

import lommel as lm
from lommel.core.answers import Wanted
from lommel.methods import ChordalGauss, Hankel, NijboerZernike, Polychromatic
from lommel.methods.derivative_names import POWERS, parts
from lommel.optics.grid import Grid

LENS = lm.Lens(focal_length=50e-3, f_number=2.8, focus_distance=2.0, wavelength=5.5e-7, obscuration=0.3)
COMA = lm.Wavefront(2.0, 0.5, nonradial={(3, 1): 1.0, (2, -2): 0.6})
ALL = ("defocus", "spherical", "rho^6", "rho^8", "row", "column", "wavelength", "f_number", "obscuration")


def test_derivatives_have_the_names_that_were_asked_for():
    names = [(3, 1), "noll 8", "ansi  7", [2, 2], "defocus", "defocus", (np.int64(2), np.int64(-2))]
    answer = lm.psf(lm.Pupil(COMA), 9, 0.5, derivatives=names)
    assert list(answer.derivatives) == [(3, 1), "noll 8", "ansi  7", (2, 2), "defocus", (2, -2)]
    assert list(answer.derivative_bounds) == list(answer.derivatives)
    assert np.array_equal(answer.derivatives[3, 1], answer.derivatives["noll 8"])
    assert not np.shares_memory(answer.derivatives[3, 1], answer.derivatives["noll 8"])
    assert np.abs(answer.derivatives["noll 8"] - answer.derivatives["ansi  7"]).max() > 1e-3


def test_a_plan_gives_what_a_psf_does_with_a_place_for_the_values():
    pupil, out = lm.Pupil(COMA), np.empty((9, 9))
    plan = lm.Plan(9, 0.5, dtype=np.float64)
    for names in (((3, 1), "row"), (), ("defocus",)):
        alone = lm.psf(pupil, 9, 0.5, dtype=np.float64, derivatives=names)
        answer = plan(pupil, derivatives=names, out=out)
        assert answer.values is out
        assert np.array_equal(out, alone.values)
        assert answer.method == alone.method == ChordalGauss()
        for name in names:
            assert np.array_equal(answer.derivatives[name], alone.derivatives[name])
    assert answer.error_bound <= 1e-6


def test_radial_terms_and_shifts_of_radial_pupils_are_by_the_series_and_all_others_by_the_chordal_rule():
    pupil = lm.Pupil(lm.Wavefront(2.0, 1.0), obscuration=0.3)
    for names, method in (
        ((*POWERS, (2, 0), (4, 0), (8, 0)), NijboerZernike()),
        (("defocus", "row", (1, 1)), NijboerZernike()),
        (("row", (3, 1)), ChordalGauss()),
        (("row", "obscuration"), ChordalGauss()),
        (((10, 0),), ChordalGauss()),
    ):
        answer = lm.psf(pupil, 9, 0.5, derivatives=names, dtype=np.float64)
        assert answer.method == method
        other = lm.psf(pupil, 9, 0.5, derivatives=names, method=ChordalGauss(1e-10), dtype=np.float64)
        for name in names:
            off = np.abs(answer.derivatives[name] - other.derivatives[name]).max() / other.values.max()
            assert off <= answer.derivative_bounds[name] + other.derivative_bounds[name]
            assert answer.derivative_bounds[name] < 3e-6


def _moved(pupil: lm.Pupil, by: float, **more) -> lm.PSF:
    """Return a window whose axis is so many parts of 32 of a pixel below the middle."""
    return lm.psf(pupil, 33, 10e-6, center=(16.0 + by / 32.0, 16.0), dtype=np.float64, tol=1e-8, **more)


def test_strong_defocus_and_large_windows_shift_and_grow_too():
    # The chordal rule would take more chords than it may.
    pupil = lm.Lens(focal_length=50e-3, f_number=1.4, focus_distance=2.0, wavelength=550e-9).pupil(1.5)
    names = ("row", "column", "f_number", "wavelength", "object_distance", "focus_distance")
    answer = lm.psf(pupil, 65, 10e-6, derivatives=names, dtype=np.float64)
    # A shift is what the sum of shifts between makes, each by the derivative there: of 1 / 16, three radians.
    rows = [_moved(pupil, s).values for s in (-1.0, 1.0)]
    t, w = np.polynomial.legendre.leggauss(6)
    slopes = [_moved(pupil, s, derivatives=("row",)).derivatives["row"] for s in t]
    summed = np.einsum("k,kij->ij", w, slopes) / 32.0
    assert answer.method == NijboerZernike()
    assert np.abs(summed - (rows[1] - rows[0])).max() <= 5e-8 * answer.values.max()
    # What grows keeps its light: the derivative by ln N sums to nothing where the window holds nearly all of it.
    assert abs(answer.derivatives["f_number"].sum()) * pupil.f_number < 5e-3
    assert all(np.isfinite(answer.derivatives[name]).all() for name in names)


def test_powers_of_rho_are_sums_of_radial_terms_and_twice_the_defocus_is_the_first():
    answer = lm.psf(lm.Pupil(COMA), 9, 0.5, derivatives=(*POWERS, (2, 0), (4, 0), (6, 0)), tol=1e-10)
    second, fourth, sixth = (answer.derivatives[n, 0] for n in (2, 4, 6))
    # 2 rho^2 = 1 + R_2, 6 rho^4 = 2 + 3 R_2 + R_4, 20 rho^6 = 5 + 9 R_2 + 5 R_4 + R_6.
    for name, sums in (
        ("defocus", second),
        ("spherical", (3.0 * second + fourth) / 6.0),
        ("rho^6", (9.0 * second + 5.0 * fourth + sixth) / 20.0),
    ):
        assert answer.derivatives[name] == pytest.approx(sums, abs=1e-12 * answer.values.max())


def test_a_positive_tilt_and_a_higher_axis_move_the_image_alike():
    answer = lm.psf(lm.Pupil(COMA), 9, 0.4, derivatives=("row", "column", (1, 1), (1, -1)), tol=1e-9)
    pitch = 0.4 * math.pi
    assert answer.derivatives["column"] == pytest.approx(pitch * answer.derivatives[1, 1], abs=1e-12)
    assert answer.derivatives["row"] == pytest.approx(pitch * answer.derivatives[1, -1], abs=1e-12)
    # Right of the middle of an image that moves right it gets brighter, where light falls outwards.
    airy = lm.psf(lm.Pupil(), 9, 0.2, derivatives=("row", "column")).derivatives
    assert airy["column"][4, 6] > 0 > airy["column"][4, 2]
    assert airy["row"][6, 4] > 0 > airy["row"][2, 4]


def test_in_focus_the_middle_falls_with_the_f_number_as_light_spreads():
    pupil = lm.Pupil(wavelength=5e-7, f_number=4.0)
    asked = {"derivatives": ("f_number", "wavelength"), "integrate": False, "tol": 1e-10}
    answer = lm.psf(pupil, 9, 1e-7, **asked)
    peak = answer.values[4, 4]
    assert answer.derivatives["f_number"][4, 4] == pytest.approx(-2.0 * peak / 4.0, rel=1e-9)
    assert answer.derivatives["wavelength"][4, 4] == pytest.approx(-2.0 * peak / 5e-7, rel=1e-9)
    relative = lm.psf(pupil, 9, 1e-7, normalize="strehl", **asked).derivatives
    assert relative["f_number"][4, 4] == pytest.approx(0.0, abs=1e-9)
    assert relative["f_number"][4, 6] > 0.0


def test_without_obscuration_its_derivative_is_none():
    for normalize in ("energy", "strehl"):
        answer = lm.psf(lm.Pupil(COMA), 9, 0.5, derivatives=("obscuration",), normalize=normalize)
        assert not answer.derivatives["obscuration"].any()
        assert answer.derivative_bounds["obscuration"] == 0.0


def test_at_infinity_distances_do_not_count():
    lens = LENS.focused(math.inf)
    answer = lm.psf(lens.pupil(math.inf), 9, 1e-6, derivatives=("object_distance", "focus_distance"))
    assert not answer.derivatives["object_distance"].any()
    assert np.abs(answer.derivatives["focus_distance"]).max() < 1e-12 * answer.values.max()
    near = lm.psf(lens.pupil([math.inf, 5.0]), 9, 1e-6, derivatives=("object_distance",)).derivatives
    assert not near["object_distance"][0].any()
    assert near["object_distance"][1].any()


def test_a_stack_has_what_its_pupils_have():
    stack = replace(LENS, aberrations=COMA).pupil([1.9, 2.0, 2.3])
    names = (*ALL, "object_distance", "focus_distance", (3, 1))
    answer = lm.psf(stack, 9, 1e-6, derivatives=names, center=([4.0, 4.2, 3.8], 4.5), dtype=np.float64)
    for i in range(3):
        part = answer[i]
        alone = lm.psf(stack[i], 9, 1e-6, derivatives=names, center=part.grid.center, dtype=np.float64)
        for name in names:
            off = np.abs(part.derivatives[name] - alone.derivatives[name]).max() / alone.values.max()
            assert off <= answer.derivative_bounds[name] + alone.derivative_bounds[name]
            assert np.isfinite(answer.derivative_bounds[name])


def test_factors_are_those_of_the_conventions():
    pupil = LENS.pupil([1.9, math.inf])
    lens, step = pupil.geometry, 1.7
    rate = math.pi * lens.aperture_radius**2 / (2.0 * 5.5e-7)
    found = parts("object_distance", pupil, step, energy=True).phases
    assert found[1] == pytest.approx([-2.0 * rate / 1.9**2, 0.0])
    focus = parts("focus_distance", pupil, step, energy=True)
    assert focus.phases[1] == pytest.approx(2.0 * rate / 2.0**2)
    assert focus.scaling == pytest.approx(lens.sensor_distance / 2.0**2)
    assert focus.image == pytest.approx(2.0 * focus.scaling)


@pytest.mark.parametrize(
    ("method", "wanted", "told"),
    [
        (Hankel(), Wanted(powers=(1,)), "not available from Hankel"),
        (Hankel(), Wanted(terms=((3, 1),)), "not available from Hankel"),
        (NijboerZernike(), Wanted(terms=((3, 1),)), "use ChordalGauss"),
        (Polychromatic([5e-7], [1]), Wanted(terms=((3, 1),)), "are not available from Polychromatic"),
        (Polychromatic([5e-7], [1]), Wanted(powers=(1,)), "are not available from Polychromatic"),
    ],
)
def test_no_method_leaves_derivatives_out_silently(method, wanted, told):
    with pytest.raises(ValueError, match=told):
        method.images(lm.Pupil(wavelength=5e-7, f_number=2.0), Grid(5, 1e-6), wanted)


def test_the_bound_of_a_stack_is_its_largest():
    pupil = lm.Pupil(lm.Wavefront([0.0, 30.0]))
    asked = {"shape": 9, "pixel": 0.5, "derivatives": ("defocus",), "tol": 1e-9}
    alone = [lm.psf(pupil[i], **asked).derivative_bounds["defocus"] for i in range(2)]
    assert max(alone) > 2.0 * min(alone)
    assert lm.psf(pupil, **asked).derivative_bounds["defocus"] >= 0.9 * max(alone)
