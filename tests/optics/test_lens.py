"""Focal length, stop and focus: the thin lens and the paper's Eq. 1-3."""

from __future__ import annotations

import math
import re
from dataclasses import fields, replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import lommel as lm

focal_lengths = st.floats(1e-3, 1.0)
f_numbers = st.floats(0.7, 64.0)
wavelengths = st.floats(200e-9, 12e-6)
# How far away an object is, in focal lengths.
distances = st.floats(1.1, 1e5)


@given(f=focal_lengths, n=f_numbers, far=distances, wavelength=wavelengths)
def test_the_sensor_is_at_the_image_of_the_object_in_focus(f, n, far, wavelength):
    lens = lm.Lens(focal_length=f, f_number=n, focus_distance=far * f, wavelength=wavelength)
    assert 1 / (far * f) + 1 / lens.sensor_distance == pytest.approx(1 / f)
    assert lens.focus_distance == pytest.approx(far * f, rel=1e-8)
    # The rounding of 1/d - 1/f, in units of what one focal length of defocus would be.
    whole = math.pi / (8 * wavelength) * f / n**2
    assert abs(lens.defocus(far * f)) < 1e-14 * whole


@given(f=focal_lengths, n=f_numbers, d=st.floats(0.5, 2.0), far=distances, wavelength=wavelengths)
def test_defocus_is_the_path_difference_between_rim_and_middle_to_second_order(f, n, d, far, wavelength):
    lens = lm.Lens(focal_length=f, f_number=n, sensor_distance=d * f, wavelength=wavelength)
    square = (f / n / 2) ** 2
    waves = (square / (2 * d * f) - square / (2 * f) + square / (2 * far * f)) / wavelength
    assert lens.pupil(far * f).wavefront.waves["W020"] == pytest.approx(waves, rel=1e-9, abs=1e-9)


def test_a_lens_is_focused_at_infinity_unless_told_otherwise():
    lens = lm.Lens(focal_length=0.1, f_number=2.0, wavelength=500e-9)
    assert lens.sensor_distance == pytest.approx(0.1)
    assert lens.focus_distance == math.inf
    assert lens == lm.Lens(focal_length=0.1, f_number=2.0, wavelength=500e-9, focus_distance=math.inf)
    assert lens.pupil() == lens.pupil(math.inf)


def test_a_sensor_inside_the_focal_plane_is_focused_on_a_virtual_object():
    lens = lm.Lens(focal_length=0.1, f_number=2.0, wavelength=500e-9, sensor_distance=0.05)
    assert lens.focus_distance == pytest.approx(-0.1)
    with pytest.raises(ValueError, match=r"object_distance must be given: .* sensor at 0.05 m lies inside"):
        lens.pupil()


@given(f=focal_lengths, n=f_numbers, far=distances)
def test_a_lens_without_an_object_is_in_focus(f, n, far):
    lens = lm.Lens(focal_length=f, f_number=n, focus_distance=far * f, wavelength=500e-9)
    assert lens.pupil() == lens.pupil(lens.focus_distance)
    assert abs(lens.defocus()) < 1e-14 * math.pi / (8 * 500e-9) * f / n**2


def test_an_aperture_is_given_by_its_diameter_or_by_the_f_number():
    common = {"focal_length": 0.1, "wavelength": 500e-9}
    assert lm.Lens(f_number=4.0, **common) == lm.Lens(aperture_diameter=0.025, **common)
    assert lm.Lens(aperture_diameter=0.025, **common).f_number == pytest.approx(4.0)


def test_the_aberrations_of_a_lens_add_to_its_defocus():
    extra = lm.Wavefront(defocus=1.0, spherical=2.0, higher=(3.0,))
    lens = lm.Lens(focal_length=0.05, f_number=2.0, focus_distance=2.0, wavelength=550e-9, aberrations=extra)
    assert lens.pupil(1.5).wavefront == lm.Wavefront(lens.defocus(1.5)) + extra
    assert lens.pupil(2.0).wavefront.defocus == pytest.approx(1.0)


def test_a_stack_of_aberrations_broadcasts_with_the_distances():
    spherical = lm.Wavefront(spherical=np.array([[0.0], [1.0]]))
    lens = lm.Lens(focal_length=0.05, f_number=2.0, wavelength=550e-9, aberrations=spherical)
    stack = lens.pupil([1.0, 2.0, math.inf])
    assert stack.shape == (2, 3)
    assert stack.geometry.object_distance == (1.0, 2.0, math.inf) * 2


# One value for each field that a lens and a pupil are made of, none of them the default.
SHAPES = {
    "spider": lm.Spider.equal(3, 0.1),
    "vignetting": lm.Ellipse(0.9, 0.8),
    "mask": lm.Mask(np.full((4, 4), 0.5)),
    "stop": lm.Segments.hexagonal(1, 0.02).phased(np.arange(6) / 10),
}
LENS_PARTS = {
    "focal_length": 0.05,
    "aperture_diameter": 0.01,
    "sensor_distance": 0.052,
    "wavelength": 550e-9,
    "obscuration": 0.2,
    "aberrations": lm.Wavefront(1.0, 2.0, nonradial={(3, 1): 3.0}),
    **SHAPES,
    "model": "aplanatic",
    "corrected_for": "focus",
    "apodization": "aplanatic",
    "colour": lm.Colour([500e-9, 550e-9, 600e-9], [1e-6, 0.0, 2e-6], [1e-6, 0.0, -1e-6], 1e-2),
}


def _parts(thing):
    return {f.name: getattr(thing, f.name) for f in fields(thing) if f.init}


def _same(one, other):
    return all(a is b or a == b for a, b in zip(one.values(), other.values(), strict=True)) and [*one] == [*other]


def _methods_that_return(kind):
    """Return the names of those, and of properties, whose annotation says so."""
    known = {n: m for each in reversed(kind.__mro__) for n, m in vars(each).items()}
    public = {n: m for n, m in known.items() if n.startswith("__") or not n.startswith("_")}
    functions = {n: getattr(m, "fget", None) or getattr(m, "__func__", m) for n, m in public.items()}
    own = kind.__name__, "Self"
    return {n for n, f in functions.items() if getattr(f, "__annotations__", {}).get("return") in own}


def test_nothing_that_a_lens_is_made_of_is_forgotten():
    """Every method that returns a Lens: what it does not change by its purpose, it keeps."""
    assert [f.name for f in fields(lm.Lens)] == [*LENS_PARTS]
    lens = lm.Lens(**LENS_PARTS)
    assert _same(_parts(lens), LENS_PARTS)
    plain = lm.Lens(**LENS_PARTS | {"vignetting": None, "mask": None, "stop": None})
    same_stop = plain.stopped(plain.f_number)
    made = {
        "focused": (lens.focused(3.0), lens, {"sensor_distance": 1 / (1 / 0.05 - 1 / 3.0)}),
        "stopped": (same_stop, plain, {"aberrations": same_stop.aberrations}),
        "in_light": (
            (red := lens.in_light(600e-9)),
            lens,
            {
                "wavelength": 600e-9,
                "focal_length": red.focal_length,
                "aberrations": 550e-9 / 600e-9 * lens.aberrations,
                "stop": lens.stop.scaled(550e-9 / 600e-9),
                "apodization": lens.illumination,
            },
        ),
    }
    assert red.focal_length == pytest.approx(0.05 + 2e-6, abs=1e-15)
    assert set(made) == _methods_that_return(lm.Lens)
    for name, (found, before, changes) in made.items():
        assert _same(_parts(found), _parts(before) | changes), name
    difference = same_stop.aberrations - lens.aberrations
    assert np.abs(list(difference.edge_terms().values())).max() < 1e-14


def test_nothing_that_a_pupil_is_made_of_is_forgotten():
    lens = lm.Lens(**LENS_PARTS)
    pupil = replace(lens.pupil([1.0, 2.0]), apodization=0.3)
    pupil = replace(pupil, colour=pupil.colour.at(np.array([1e-3, 2e-3]), np.zeros(2)))
    defaults = {f.name: f.default for f in fields(lm.Pupil)}
    assert not any(value is None or value == defaults[name] for name, value in _parts(pupil).items())
    kept = {name: getattr(lens, name) for name in ("obscuration", "wavelength", *SHAPES)}
    assert kept.items() <= _parts(pupil).items()
    kept_distances = {"model": "aplanatic", "corrected_for": "focus", "focal_length": 0.05, "sensor_distance": 0.052}
    assert kept_distances.items() <= vars(pupil.geometry).items()
    one, focus = lens.pupil(2.0), lens.pupil()
    made = {
        "__getitem__": (
            pupil[1],
            {
                "wavefront": pupil.wavefront[1],
                "geometry": one.geometry,
                "colour": replace(pupil.colour, x=(2e-3,), y=(0.0,)),
            },
        ),
        "unaberrated": (
            pupil.unaberrated(),
            {"wavefront": lm.Wavefront(), "geometry": focus.geometry, "stop": lm.Segments.hexagonal(1, 0.02)},
        ),
        "broadcast": (
            pupil.broadcast((3, 2)),
            {
                "wavefront": pupil.wavefront.broadcast((3, 2)),
                "geometry": replace(pupil.geometry, object_distance=(1.0, 2.0) * 3),
                "colour": replace(pupil.colour, x=(1e-3, 2e-3) * 3, y=(0.0,) * 6),
            },
        ),
        "carrying": (
            pupil.carrying(lm.Wavefront(2.0), one.geometry),
            {"wavefront": lm.Wavefront(2.0), "geometry": one.geometry},
        ),
        "in_light": (
            (red := pupil.in_light(600e-9)),
            {
                "wavefront": red.wavefront,
                "wavelength": 600e-9,
                "geometry": lens.in_light(600e-9).pupil([1.0, 2.0]).geometry,
                "stop": lens.stop.scaled(550e-9 / 600e-9),
            },
        ),
        "from_dict": (lm.Pupil.from_dict(pupil.to_dict()), {"mask": lm.Mask(np.full((4, 4), 0.5))}),
    }
    assert set(made) == _methods_that_return(lm.Pupil)
    for name, (found, changes) in made.items():
        assert _same(_parts(found), _parts(pupil) | changes), name


def test_what_a_stop_does_not_cover_keeps_its_size():
    lens = lm.Lens(focal_length=0.05, f_number=2.0, wavelength=550e-9, obscuration=0.2,
                   aberrations=lm.Wavefront(1.0, 4.0), spider=lm.Spider.equal(3, 0.1))  # fmt: skip
    half = lens.stopped(4.0)
    assert (half.f_number, half.obscuration, half.spider.width) == (4.0, 0.4, 0.2)
    assert half.aberrations == lm.Wavefront(0.25, 0.25)
    assert half.sensor_distance == lens.sensor_distance
    assert lm.Lens(focal_length=0.05, f_number=2.0, wavelength=550e-9).stopped(1.4).f_number == 1.4


def test_what_light_falls_on_a_lens_does_not_change_with_the_stop():
    common = {"focal_length": 0.05, "f_number": 2.0, "wavelength": 550e-9}
    rho = np.linspace(0.0, 0.5, 7)
    for apodization in (1.2, lm.Apodization([1.0, -2.0])):
        lens = lm.Lens(**common, apodization=apodization)
        assert lens.pupil().apodization == lens.focused(3.0).apodization == apodization
        half = lens.stopped(4.0).pupil().illumination.value(2.0 * rho)
        whole = lens.pupil().illumination.value(rho)
        assert half / half[0] == pytest.approx(whole / whole[0], rel=1e-13)
    # A beam has no rim, a polynomial has.
    assert lm.Lens(**common, apodization=1.2).stopped(1.0).apodization == pytest.approx(4.8)
    with pytest.raises(ValueError, match="up to which its apodization is known, got f/1"):
        lens.stopped(1.0)
    assert lm.Lens(**common, apodization=lm.Apodization()).stopped(1.0).f_number == 1.0


@pytest.mark.parametrize(
    ("changes", "f_number", "message"),
    [
        ({}, 1.4, "f_number must be at least that of the lens, f/5, up to which its aberrations are known, got f/1"),
        ({"vignetting": lm.Ellipse(0.5, 0.5)}, 8.0, "f_number of a lens with vignetting, a mask or a stop"),
    ],
)
def test_a_stop_that_cannot_be_is_refused(changes, f_number, message):
    lens = lm.Lens(**LENS_PARTS | {"vignetting": None, "mask": None, "stop": None} | changes)
    with pytest.raises(ValueError, match=re.escape(message)):
        lens.stopped(f_number)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"f_number": None}, "exactly one of f_number and aperture_diameter, got f_number=None"),
        ({"aperture_diameter": 0.01}, "exactly one of f_number and aperture_diameter, got f_number=2.0"),
        ({"focus_distance": 2.0, "sensor_distance": 0.05}, "at most one of focus_distance and sensor_distance"),
        ({"focus_distance": 0.05}, "focus_distance must exceed the focal length 0.05 m .*got 0.05"),
        ({"f_number": 0.1}, r"f_number, .*, must be >= 0.5, .*, got f/0.1, an aperture of 500 mm; perhaps 1 / N was"),
        ({"f_number": None, "aperture_diameter": 25}, "got f/0.002, an aperture of 25 m; .* millimetres instead of"),
        ({"focal_length": 50.0, "focus_distance": 2.0}, "focal length 50 m .*got 2; for 50 mm give 50e-3"),
    ],
)
def test_contradictions_are_named(options, message):
    with pytest.raises(ValueError, match=message):
        lm.Lens(**{"focal_length": 0.05, "f_number": 2.0, "wavelength": 550e-9} | options)


@pytest.mark.parametrize("model", ["paraxial", "aplanatic"])
@pytest.mark.parametrize("aberrations", [lm.Wavefront(), lm.Wavefront(0.3, 0.2), lm.Wavefront(np.array([1.0, 2.0]))])
def test_the_pupil_of_a_number_is_that_of_an_array_of_one_bit_by_bit(model, aberrations):
    lens = lm.Lens(
        focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=5e-7, model=model, aberrations=aberrations
    )
    for distance in (1.0, np.float64(1.7), 2.0, 3, np.inf, np.float32(4.0)):
        one, other = lens.pupil(distance), lens.pupil(np.array(distance))
        assert one == other
        assert repr(one) == repr(other)
        assert one.wavefront.edge.tobytes() == other.wavefront.edge.tobytes()
        assert one.wavefront.coefficients.tobytes() == other.wavefront.coefficients.tobytes()
        assert not one.wavefront.edge.flags.writeable
        assert not one.wavefront.coefficients.flags.writeable
        assert [type(s) for s in one.geometry.object_distance] == [float] * max(1, len(aberrations.shape) * 2)
        assert one.transmission == replace(one).transmission
        assert lens.defocus(distance).tobytes() == lens.defocus(np.array(distance)).tobytes()
        assert isinstance(lens.defocus(distance), np.ndarray)


def test_a_focal_length_in_metres_that_may_be_one_in_mm_is_asked_about():
    asked = r"^focal_length=50 is 50 metres; for 50 mm give focal_length=50e-3\. For a telescope give aperture"
    with pytest.warns(UserWarning, match=asked) as seen:
        lm.Lens(focal_length=50, f_number=1.8, focus_distance=2000.0, wavelength=550e-9)
    assert seen[0].filename == __file__
    # None of these is asked about; warnings are errors here.
    telescope = lm.Lens(focal_length=8.0, f_number=8.0, wavelength=550e-9, obscuration=0.3)
    refractor = lm.Lens(focal_length=1.2, aperture_diameter=0.15, wavelength=550e-9)
    lm.Lens(focal_length=2.0, f_number=4.0, wavelength=10e-6)
    lm.Lens(focal_length=1.0, f_number=4.0, wavelength=550e-9)
    assert refractor.stopped(12.0).f_number == pytest.approx(12.0)
    assert refractor.focused(50.0).in_light(600e-9).focal_length == 1.2
    assert telescope.stopped(10.0).focal_length == 8.0
