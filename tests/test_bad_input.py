"""Bad input beyond what tests/fuzz/test_arguments.py gives to every argument: ranges, shapes, kinds of objects."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from functools import partial

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
SCALE = {"wavelength": 500e-9, "f_number": 2.0}
PUPIL = lm.Lens(focal_length=50e-3, f_number=2.0, focus_distance=2.0, wavelength=500e-9).pupil(1.9)
SPHERICAL = lm.Pupil(lm.Wavefront(spherical=1.0))
NOT_POSITIVE = [(0, "0"), (-1.0, "-1")]
FRACTION = [(1.0, "1"), (-0.1, "-0.1"), ([0.1], "[0.1]")]
LENGTHS = [(550, "550e-9"), (0.55, "0.55e-6")]
CAMERA = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
BARE = {"focal_length": 0.05, "wavelength": 550e-9, "f_number": 2.0}


def table(*rows: tuple[str, list[tuple[object, str]]]) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Rows of an argument and its bad values, flattened."""
    return each("name, value, shown", [(name, value, shown) for name, values in rows for value, shown in values])


def refuses(call, name: str, shown: str) -> None:
    with pytest.raises(BAD) as caught:
        call()
    assert name in str(caught.value)
    assert shown in str(caught.value)


@table(
    ("shape", [(0, "0"), (-1, "-1"), ((0, 5), "0"), ((5, -5), "-5"), ((3,), "(3,)"), ((3, 3, 3), "(3, 3, 3)")]),
    ("shape", [((), "()"), (10**6, "1000000"), ((5, 16385), "16385"), ((5, 2.5), "2.5"), (True, "True")]),
    ("shape", [((5, None), "None"), (5j, "5j")]),
    ("pixel", [*NOT_POSITIVE, (math.inf, "inf"), (3.45, "3.45e-6"), (1e300, "1e+300"), ([1e-6], "[1e-06]")]),
    ("center", [(1, "1"), ((1, 2, 3), "(1, 2, 3)"), (("a", 1), "'a'"), ((1, math.nan), "nan"), ((1e9, 1), "1e+09")]),
    ("derivatives", [(("coma",), "'coma'"), ("defocus", "got 'defocus'"), (None, "None")]),
    ("threads", [(0, "0"), (-1, "-1"), (True, "True"), (10**6, "1000000")]),
    ("dtype", [("float16", "'float16'"), (complex, "complex"), (">f8", "'>f8'"), ("2f4", "'2f4'")]),
)  # fmt: skip
def test_a_bad_argument_of_psf_is_refused_by_every_method(name, value, shown):
    for kind in METHODS.values():
        arguments = {"pupil": PUPIL, "shape": 5, "pixel": 1e-6, "method": kind()} | {name: value}
        refuses(lambda given=arguments: lm.psf(**given), name, shown)


OUT_OF_RANGE = [
    (lm.Wavefront, "higher", [([0.0] * 9, "9"), (b"11", "b'11'"), (1.0, "1.0"), (np.ones(2), "array(")]),
    (lm.Wavefront, "higher", [([0.0, math.nan], "higher[1]"), ([0.0, "1"], "higher[1]")]),
    (lm.Wavefront, "defocus", [([0.0, math.nan], "nan"), ([True], "[True]")]),
    (partial(lm.Wavefront.balanced_spherical, 1.0), "obscuration", FRACTION),
    (partial(lm.Pupil, **SCALE), "obscuration", FRACTION),
    (partial(lm.Pupil, **SCALE), "wavelength", [*NOT_POSITIVE, *LENGTHS, (1e-13, "1e-13"), (None, "None")]),
    (partial(lm.Pupil, **SCALE), "geometry", [((1.0, 1.0, 1.0, 1.0), "(1.0, "), ("lens", "'lens'")]),
    (partial(lm.Pupil, **SCALE), "f_number", [*NOT_POSITIVE, ([2.0], "[2.0]")]),
    *((partial(lm.Lens, **BARE), name, NOT_POSITIVE) for name in ("focal_length", "f_number", "sensor_distance")),
    (partial(lm.Lens, focal_length=0.05, wavelength=550e-9), "aperture_diameter", NOT_POSITIVE),
    (partial(lm.Lens, **BARE), "focus_distance", NOT_POSITIVE),
    (partial(lm.Lens, **BARE), "wavelength", [*NOT_POSITIVE, *LENGTHS]),
    (partial(lm.Lens, **BARE), "obscuration", FRACTION),
    (CAMERA.pupil, "object_distance", [*NOT_POSITIVE, (-math.inf, "-inf"), ([1.0, 0.0], "0.0"), ([], "(0,)")]),
    (NijboerZernike, "tol", [(0, "0"), (1e-13, "1e-13"), (0.1, "0.1"), (-1e-6, "-1e-06")]),
    (Hankel, "tol", [(0, "0"), (1e-16, "1e-16"), (0.01, "0.01")]),
    (lm.paper.ClosedForm, "tangent", NOT_POSITIVE),
    (lm.paper.ClosedForm, "variant", [("Printed", "'Printed'")]),
    (lm.paper.ClosedForm, "erf", [("fresnel", "'fresnel'"), (math.erf, "erf"), (FresnelErf, "FresnelErf")]),
    (lm.paper.AbramowitzErf, "terms", [(0, "0"), (10**9, "1000000000")]),
    (lm.paper.TableErf, "samples", [(1, "1"), (10**9, "1000000000")]),
    (lm.paper.Fraunhofer, "samples", [(7, "7"), (8193, "8193")]),
    (lm.paper.Fraunhofer, "padding", [(0.5, "0.5")]),
    (lm.paper.Fraunhofer, "edge", [("gray", "'gray'")]),
    (lm.paper.Geometric, "rings", [(0, "0"), (65, "65")]),
    (lm.paper.HuygensFresnel, "nodes", [((5,), "(5,)"), ((5, 5, 5), "(5, 5, 5)"), ((1, 5), "1"), ((2.5, 5), "2.5"),
                                        ((5, None), "None"), ((10**7, 5), "10000000"), ((True, 5), "True")]),
    *((ask, "radius", [(-1.0, "-1"), ([0.0, -1.0], "-1")]) for ask in (
        lm.psf(PUPIL, 5, 1e-6).encircled_energy, lm.psf(PUPIL, 5, 1e-6).profile, partial(lm.best_focus, PUPIL))),
    (lm.Wavefront(1.0).phase, "rho", [(-0.1, "-0.1"), (True, "True")]),
]  # fmt: skip


@each(
    "make, name, value, shown",
    [(make, name, value, shown) for make, name, values in OUT_OF_RANGE for value, shown in values],
)
def test_a_value_out_of_range_is_refused_by_name(make, name, value, shown):
    refuses(lambda: make(**{name: value}), name, shown)


@each("kind", [name for name in METHODS if name != "huygens-fresnel"])
@each("pixel", [1e200, 1e300])
def test_a_pixel_beyond_all_numbers_is_refused_in_lambda_N_too(kind, pixel):
    refuses(lambda: lm.psf(lm.Pupil(), 5, pixel, method=METHODS[kind]()), "pixel", "1e+")


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


@each(("options", "missing"), [({"wavelength": 5e-7}, "f_number"), ({"f_number": 2}, "wavelength")])
def test_a_wavelength_needs_an_f_number_and_the_other_way_round(options, missing):
    with pytest.raises(ValueError, match=f"given together .*{missing}=None"):
        lm.Pupil(**options)


def test_a_method_for_lenses_refuses_a_pupil_without_distances():
    with pytest.raises(ValueError, match=r"HuygensFresnel needs the physical distances .* Lens.pupil"):
        lm.psf(lm.Pupil(lm.Wavefront(1.0), wavelength=5e-7, f_number=2.0), 5, 1e-6, method="huygens-fresnel")
    assert isinstance(PUPIL.geometry, Geometry)


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
        (lambda: lm.psf([PUPIL, PUPIL], 9, 0.5), "a stack is one Pupil of a Wavefront whose coefficients are arrays"),
        (lambda: lm.psf(PUPIL, 9, 1e-6, center=np.zeros((5, 2))), "give tuple(center.T)"),
        (lambda: lm.psf(PUPIL, 9, "4 um"), "text with a unit is for files and the command line"),
        (lambda: lm.Wavefront.zernike(np.zeros(12), order="noll"), "such as zip(range(4, 16), coefficients), got"),
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
