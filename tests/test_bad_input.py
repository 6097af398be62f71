"""Bad input beyond what tests/fuzz/test_arguments.py gives to every argument: ranges, shapes, kinds of objects."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

import lommel as lm
from cases import each
from lommel.imaging.blur import Points
from lommel.measures.errors import mse
from lommel.methods import METHODS, Hankel, NijboerZernike
from lommel.optics.base_pupil import Geometry
from lommel.paper import FresnelErf

BAD = (ValueError, TypeError)
METHOD = each("method", [kind() for kind in METHODS.values()])
PUPIL = lm.Lens(focal_length=50e-3, f_number=2.0, focus_distance=2.0, wavelength=500e-9).pupil(1.9)
SPHERICAL = lm.Pupil(lm.Wavefront(spherical=1.0))

NOT_POSITIVE = [(0, "0"), (-1.0, "-1")]


def table(*rows: tuple[str, list[tuple[object, str]]]) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Rows of an argument and its bad values, flattened."""
    return each("name, value, shown", [(name, value, shown) for name, values in rows for value, shown in values])


def refuses(call, name: str, shown: str) -> None:
    with pytest.raises(BAD) as caught:
        call()
    assert name in str(caught.value)
    assert shown in str(caught.value)


@table(
    ("shape", [(0, "0"), (-1, "-1"), (2.5, "2.5"), ((0, 5), "0"), ((5, -5), "-5"), ((3,), "(3,)")]),
    ("shape", [((3, 3, 3), "(3, 3, 3)"), ((), "()"), (10**6, "1000000"), ((5, 16385), "16385")]),
    ("shape", [((5, 2.5), "2.5"), ((5, None), "None")]),
    ("pixel", [*NOT_POSITIVE, (3.45, "3.45e-6"), (1e300, "1e+300"), ([1e-6], "[1e-06]")]),
    ("center", [(1, "1"), ((1, 2, 3), "(1, 2, 3)"), (("a", 1), "'a'"), ((1, math.nan), "nan"), ((1e9, 1), "1e+09")]),
    ("derivatives", [(("coma",), "'coma'"), ("defocus", "got 'defocus'"), (None, "None"), (1, "1")]),
    ("threads", [(0, "0"), (1025, "1025")]),
    ("normalize", [("Energy", "'Energy'"), (None, "None"), (["peak"], "['peak']")]),
    ("dtype", [("float16", "'float16'"), (int, "int"), (complex, "complex"), ("junk", "'junk'"), (">f8", "'>f8'")]),
    ("dtype", [("2f4", "'2f4'"), (3, "3"), (np.longdouble, "longdouble")]),
    ("pupil", [(lm.Wavefront(1.0), "a Wavefront"), (None, "None"), (1.0, "1.0"), ([PUPIL], "[<Pupil")]),
)  # fmt: skip
def test_a_bad_argument_of_psf_is_refused_by_every_method(name, value, shown):
    for kind in METHODS.values():
        arguments = {"pupil": PUPIL, "shape": 5, "pixel": 1e-6, "method": kind()} | {name: value}
        refuses(lambda given=arguments: lm.psf(**given), name, shown)


@table(("method", [("henkel", "'henkel'"), (1, "1"), (Hankel, "Hankel"), (FresnelErf(), "FresnelErf()")]))
def test_what_is_no_method_is_refused(name, value, shown):
    refuses(lambda: lm.psf(PUPIL, 5, 1e-6, method=value), name, shown)


@each("kind", [name for name in METHODS if name != "huygens-fresnel"])
@each("pixel", [1e200, 1e300])
def test_a_pixel_beyond_all_numbers_is_refused_in_lambda_N_too(kind, pixel):
    refuses(lambda: lm.psf(lm.Pupil(), 5, pixel, method=METHODS[kind]()), "pixel", "1e+")


@table(
    ("defocus", [([0.0, math.nan], "nan"), ([True], "[True]")]),
    ("higher", [(1.0, "1.0"), (np.ones(2), "array("), ({}, "{}"), ([0.0] * 9, "9"), (b"11", "b'11'")]),
    ("higher", [([0.0, math.nan], "higher[1]"), ([0.0, "1"], "higher[1]")]),
)
def test_a_bad_wavefront_is_refused(name, value, shown):
    refuses(lambda: lm.Wavefront(**{name: value}), name, shown)


@each(
    ("coefficients", "shapes"),
    [(([0.0, 1.0], [0.0, 1.0, 2.0]), ["(2,)", "(3,)"]), ((np.ones((2, 3)), 0.0, [np.ones(2)]), ["(2, 3)", "(2,)"])],
)
def test_coefficients_that_do_not_broadcast_are_refused_with_their_shapes(coefficients, shapes):
    with pytest.raises(ValueError, match="defocus, spherical, higher and nonradial must broadcast") as caught:
        lm.Wavefront(*coefficients)
    assert all(shape in str(caught.value) for shape in shapes)


@each(
    "make",
    [lambda: lm.Wavefront([]), lambda: lm.Wavefront(0.0, np.ones((2, 0))), lambda: lm.Wavefront([1.0, 2.0])[2:]],
)
def test_an_empty_stack_is_refused(make):
    with pytest.raises(ValueError, match=r"must not be empty, got shape \(.*0"):
        make()


@table(
    ("wavefront", [([lm.Wavefront()], "[Wavefront(")]),
    ("obscuration", [(1.0, "1"), (-0.1, "-0.1"), ([0.1], "[0.1]")]),
    ("wavelength", [*NOT_POSITIVE, (550, "550e-9"), (None, "None"), (0.55, "0.55e-6"), (1e-13, "1e-13")]),
    ("f_number", [*NOT_POSITIVE, ([2.0], "[2.0]")]),
    ("geometry", [((1.0, 1.0, 1.0, 1.0), "(1.0, "), ("lens", "'lens'")]),
)
def test_a_bad_pupil_is_refused(name, value, shown):
    refuses(lambda: lm.Pupil(**{"wavelength": 500e-9, "f_number": 2.0} | {name: value}), name, shown)


@each(("options", "missing"), [({"wavelength": 5e-7}, "f_number"), ({"f_number": 2}, "wavelength")])
def test_a_wavelength_needs_an_f_number_and_the_other_way_round(options, missing):
    with pytest.raises(ValueError, match=f"given together .*{missing}=None"):
        lm.Pupil(**options)


LENGTH = [*NOT_POSITIVE, ([1.0], "[1.0]")]


@table(
    *[(name, LENGTH) for name in ("focal_length", "f_number", "aperture_diameter", "focus_distance")],
    ("sensor_distance", LENGTH),
    ("wavelength", [*LENGTH, (550, "550e-9"), (0.55, "0.55e-6")]),
    ("obscuration", [(1, "1"), (-0.1, "-0.1")]),
)
def test_a_bad_lens_is_refused(name, value, shown):
    arguments = {"focal_length": 0.05, "wavelength": 550e-9, "f_number": 2.0}
    if name == "aperture_diameter":
        del arguments["f_number"]
    refuses(lambda: lm.Lens(**arguments | {name: value}), name, shown)


@table(("object_distance", [*NOT_POSITIVE, (-math.inf, "-inf"), ([1.0, 0.0], "0.0"), ([], "(0,)")]))
def test_a_bad_object_distance_is_refused(camera, name, value, shown):
    refuses(lambda: camera.pupil(value), name, shown)


@each("kind", ["lommel-series"])
@each("wavefront", [{"spherical": 1.0}, {"higher": (0.0, 1.0)}, {"spherical": [0.0, 1.0]}])
def test_a_method_for_defocus_refuses_spherical_aberration(kind, wavefront):
    with pytest.raises(ValueError, match=f"{METHODS[kind].__name__} supports defocus only"):
        lm.psf(lm.Pupil(lm.Wavefront(**wavefront)), 5, 0.5, method=METHODS[kind]())


def test_a_method_for_lenses_refuses_a_pupil_without_distances():
    with pytest.raises(ValueError, match=r"HuygensFresnel needs the physical distances .* Lens.pupil"):
        lm.psf(lm.Pupil(lm.Wavefront(1.0), wavelength=5e-7, f_number=2.0), 5, 1e-6, method="huygens-fresnel")
    assert isinstance(PUPIL.geometry, Geometry)


@each("method", [NijboerZernike(tol=1e-9), Hankel()])
def test_float32_is_refused_where_it_cannot_hold_the_tolerance(method):
    with pytest.raises(ValueError, match=f"dtype float32 cannot hold tol={method.tol:g}; use float64"):
        lm.psf(PUPIL, 5, 1e-6, method=method, dtype="float32")


def test_a_stack_too_large_for_memory_is_refused_before_anything_is_computed():
    stack = lm.Pupil(lm.Wavefront(np.zeros(100)))
    with pytest.raises(ValueError, match=r"shape \(16384, 16384\) for 100 pupils .* limit of 2147483648"):
        lm.psf(stack, 16384, 0.1)


@METHOD
@each("defocus", [1e12, 1e300])
def test_a_phase_that_a_method_cannot_carry_is_refused_in_one_short_line(method, defocus):
    pupil = lm.Pupil(lm.Wavefront(defocus), wavelength=5e-7, f_number=2.0, geometry=PUPIL.geometry)
    message = ""
    try:
        assert np.all(np.isfinite(lm.psf(pupil, 3, 1e-6, method=method).values))
    except (ValueError, ArithmeticError) as error:
        message = str(error)
    assert len(message) < 250


@table(
    ("NijboerZernike.tol", [(0, "0"), (1e-13, "1e-13"), (0.1, "0.1")]),
    ("Hankel.tol", [(0, "0"), (1e-16, "1e-16"), (0.01, "0.01")]),
    ("ClosedForm.tangent", NOT_POSITIVE),
    ("ClosedForm.erf", [("fresnel", "'fresnel'"), (math.erf, "erf"), (FresnelErf, "FresnelErf")]),
    ("AbramowitzErf.terms", [(0, "0"), (10**9, "1000000000")]),
    ("TableErf.samples", [(1, "1"), (10**9, "1000000000")]),
    ("Fraunhofer.samples", [(7, "7"), (8193, "8193")]),
    ("Fraunhofer.padding", [(0.5, "0.5")]),
    ("Geometric.rings", [(0, "0"), (65, "65")]),
    ("HuygensFresnel.nodes", [(5, "5"), ((5,), "(5,)"), ((5, 5, 5), "(5, 5, 5)"), ("55", "'55'"), ((1, 5), "1")]),
    ("HuygensFresnel.nodes", [((2.5, 5), "2.5"), ((10**7, 5), "10000000"), ((True, 5), "True")]),
)
def test_a_bad_option_of_a_method_is_refused(name, value, shown):
    kind, option = name.split(".")
    home = lm.paper if kind in lm.paper.__all__ else lm.methods
    refuses(lambda: getattr(home, kind)(**{option: value}), option, shown)


@METHOD
def test_a_method_has_no_options_but_its_own(method):
    with pytest.raises(TypeError, match="sharpness"):
        type(method)(sharpness=1)


@table(("radius", [(-1.0, "-1"), ([0.0, -1.0], "-1")]))
@each(
    "ask",
    [
        lm.psf(PUPIL, 5, 1e-6).encircled_energy,
        lm.psf(PUPIL, 5, 1e-6, method="geometric").encircled_energy,
        lm.psf(PUPIL, 5, 1e-6).profile,
        lambda radius: lm.best_focus(PUPIL, radius),
    ],
)
def test_a_bad_radius_is_refused(ask, name, value, shown):
    refuses(lambda: ask(value), name, shown)


@each("value", ["x", 550, math.nan, [5e-7], True])
def test_a_wavelength_that_has_no_meaning_is_looked_at_all_the_same(value):
    calls = [
        lambda: lm.Wavefront.zernike({4: 1.0}, order="noll", unit="waves", wavelength=value),
        lambda: lm.Wavefront(1.0).to_zernike(unit="waves", wavelength=value),
        lambda: lm.fit_opd(np.zeros((9, 9)), unit="waves", degree=2, wavelength=value),
        lambda: lm.opd_map(lm.Wavefront(), 5, unit="radians", wavelength=value),
    ]
    for call in calls:
        refuses(call, "wavelength", "got ")


CAMERA = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
BLUR = lm.imaging.DepthBlur(np.full((6, 7), 2.02), CAMERA, 8e-6, largest=20)
PLANE = np.zeros((6, 7), np.float32)
AT = Points(BLUR.positions(0))
HUGE = np.full((3, 3), 1.7e308)
NOISE = lm.Noise(white=1e4, read=3.0)


@each(
    ("call", "told"),
    [
        (lambda: PUPIL.in_light(10**400), "wavelength must be finite"),
        (lambda: lm.Pupil().in_light(5e-7), "wavelength and f_number of the pupil must be given"),
        (lambda: PUPIL.carrying(0.5, None), "wavefront must be a Wavefront, got 0.5"),
        (lambda: PUPIL.radial_phase(math.nan), "t must be finite"),
        (lambda: PUPIL.broadcast(2**63), "shape must be a tuple of integers"),
        (lambda: PUPIL.broadcast((2**40,)), "shape must be from 0 to"),
        (lambda: PUPIL.broadcast((2**15, 2**15)), "shape must hold at most"),
        (lambda: PUPIL.wavefront.broadcast((2**40,)), "shape must be from 0 to"),
        (lambda: CAMERA.pupil([1.0, 2.0]).broadcast((3,)), "shape must be one that (2,) broadcasts to, got (3,)"),
        (lambda: BLUR.positions(16385), "channel must be from 0 to 0, got 16385"),
        (lambda: BLUR.spread(1, []), "channel must be from 0 to 0, got 1"),
        (lambda: BLUR.spread(0, 5), "sources must be a sequence of planes and points, got 5"),
        (lambda: BLUR.spread(0, [(PLANE, 5)]), "points must be a Points, got 5"),
        (lambda: BLUR.spread(0, [(PLANE[1:], AT)]), "plane must be an array of float32 of the shape (6, 7)"),
        (lambda: BLUR.spread(0, [(PLANE.astype(float), AT)]), "plane must be an array of float32"),
        (lambda: next(BLUR.collect(0, 5, [AT])), "plane must be an array of float32"),
        (lambda: next(BLUR.collect(1, PLANE, [AT])), "channel must be from 0 to 0"),
        (lambda: BLUR.by_channel(PLANE, 5), "make must be callable, got 5"),
        (lambda: BLUR.by_channel(PLANE, lambda channel, plane: np.zeros(3)), "make must return planes of the shape"),
        (lambda: BLUR.planes(np.ma.masked_equal(PLANE, 0)), "image must not be masked"),
        (lambda: BLUR.planes(CAMERA), "image must hold floats in proportion to light, got object"),
        (lambda: BLUR.planes(PLANE[1:]), "image must have the shape (6, 7), got (5, 7)"),
        (lambda: BLUR.forward(np.full((6, 7), 1e300)), "at most 3.4e+38, the largest float32, got 1e+300"),
        (lambda: CAMERA.phase(1e308), "must be finite"),
        (lambda: replace(CAMERA, model="aplanatic").phase(1e308), "model 'aplanatic' is not possible"),
        (lambda: lm.Wavefront.zernike({11: 1e308}, order="noll"), "must be finite"),
        (lambda: mse(HUGE, np.ones((3, 3))), "values and reference must not differ so much"),
        (lambda: mse(-HUGE, HUGE), "values and reference must not differ so much"),
        (
            lambda: lm.measures.errors.peak_error(HUGE, np.full((3, 3), 1e-300)),
            "values and reference must not differ so much",
        ),
        (lambda: lm.psf(PUPIL, 5, 1e-6, derivatives=0.5, blur=lm.Jitter(1e-6)), "derivatives must be a sequence"),
        (lambda: lm.ColourPSF(lm.Channels.rgb(), 1e9), "psfs must be a PSF for each of the 3 channels, got 1"),
        (lambda: NOISE.record(np.ones((2, 2)), seed="a" * 10000), "seed must be an integer >= 0 or a Generator"),
        (lambda: NOISE.record(np.ones((2, 2)), seed=-1), "seed must be an integer >= 0 or a Generator, got -1"),
        (lambda: lm.imaging.write_depth(CAMERA, np.ones((2, 2))), "path must be a path, got <Lens"),
        (lambda: lm.imaging.restore(np.full((6, 7), 0.5), np.full((6, 7), 2.1), CAMERA, 8e-6, encoding="linear",
                                    noise=NOISE, saturation=np.ones(2)), "saturation must be a real number"),
    ],
)  # fmt: skip
def test_what_is_below_the_front_doors_is_checked_too(call, told):
    with pytest.raises((TypeError, ValueError)) as caught:
        call()
    assert told in str(caught.value)
    assert len(str(caught.value)) < 300


def test_errors_of_large_values_are_those_of_small_ones():
    rng = np.random.default_rng(3)
    a, b = rng.random((2, 5, 5))
    for scale in (1e300, 1e-200):
        assert mse(scale * a, scale * b) == pytest.approx(mse(a, b), rel=1e-12)


def test_no_radii_give_no_energies():
    assert lm.psf(SPHERICAL, 3, 0.5).encircled_energy([]).shape == (0,)
    assert lm.measures.energy.encircled(SPHERICAL, []).fraction.shape == (0,)


@each("value", [np.ones((50, 50)), [1.0] * 5000, "x" * 5000, "a\nb", {str(k): k for k in range(999)}, 10**400])
def test_a_message_is_one_line_and_short_whatever_is_given(value):
    for call in (lambda: lm.psf(value, 5, 0.5), lambda: lm.Pupil(obscuration=value), lambda: lm.Spider(0.1, value)):
        with pytest.raises(BAD) as caught:
            call()
        assert len(str(caught.value).splitlines()) == 1
        assert len(str(caught.value)) < 300


def test_refused_arguments_of_a_stack_say_how_it_is_given():
    pupil, axes = lm.Pupil(), np.zeros((5, 2))
    with pytest.raises(TypeError, match="a stack is one Pupil of a Wavefront whose coefficients are arrays"):
        lm.psf([pupil, pupil], 9, 0.5)
    with pytest.raises(ValueError, match=r"give tuple\(center\.T\)"):
        lm.psf(pupil, 9, 0.5, center=axes)
    with pytest.raises(TypeError, match="text with a unit is for files and the command line"):
        lm.psf(pupil, 9, "4 um")
    with pytest.raises(TypeError, match=r"such as zip\(range\(4, 16\), coefficients\), got"):
        lm.Wavefront.zernike(np.zeros(12), order="noll", unit="waves")
