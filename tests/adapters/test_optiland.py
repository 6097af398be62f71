"""A Cooke triplet of optiland: rays, focus and PSF agree with the pupils made of it."""

from __future__ import annotations

import math
import runpy
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import lommel as lm
from lommel.adapters import optiland as adapter

# What optiland and what it imports warn of is not ours.
pytestmark = pytest.mark.filterwarnings("ignore")


@pytest.fixture(scope="module")
def triplet() -> Any:
    """f/5, 20 degrees of field, millimetres."""
    return pytest.importorskip("optiland.samples.objectives").CookeTriplet()


def slope(pupil: lm.Pupil, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Where rays through the pupil meet the sensor: the gradient of the phase, metres."""
    h = 1e-5

    def phase(dx: float, dy: float) -> np.ndarray:
        return pupil.wavefront.phase(np.hypot(x + dx, y + dy), np.arctan2(y + dy, x + dx))

    scale = pupil.scale / math.pi / (2.0 * h)
    return scale * (phase(h, 0) - phase(-h, 0)), scale * (phase(0, h) - phase(0, -h))


@pytest.mark.parametrize(("field", "within"), [((0.0, 0.0), 0.003), ((0.0, 0.7), 0.06), ((0.4, 0.5), 0.06)])
def test_rays_meet_the_sensor_at_the_gradient_of_the_phase(triplet, field, within):
    angle = np.linspace(0.0, 6.0, 12)
    for radius in (0.3, 0.9):
        x, y = radius * np.cos(angle), radius * np.sin(angle)
        traced = [triplet.trace_generic(*field, Px=a, Py=b, wavelength=0.55) for a, b in zip(x, y, strict=True)]
        chief = triplet.trace_generic(*field, Px=0.0, Py=0.0, wavelength=0.55)
        across = 1e-3 * np.array([float(ray.x[0] - chief.x[0]) for ray in traced])
        up = 1e-3 * np.array([float(ray.y[0] - chief.y[0]) for ray in traced])
        found = slope(adapter.pupil(triplet, field, wavelength=550e-9, circular=True), x, -y)
        size = np.hypot(across, up).max()
        # Off the axis the two directions have f-numbers of their own, 3 % either way of the mean.
        np.testing.assert_allclose(found[0], across, atol=within * size)
        np.testing.assert_allclose(found[1], -up, atol=within * size)


def test_a_sensor_nearer_to_the_lens_has_a_higher_defocus(triplet):
    before = adapter.pupil(triplet)
    nearer = type(triplet)()
    gap = float(nearer.surfaces.get_thickness(nearer.surfaces.num_surfaces - 2)[0])
    nearer.set_thickness(gap - 0.05, nearer.surfaces.num_surfaces - 2)
    after = adapter.pupil(nearer)
    by_hand = math.pi * 50e-6 / (8 * 550e-9 * 4.98**2)
    balanced = float(after.wavefront.edge_terms()[2, 0] - before.wavefront.edge_terms()[2, 0])
    # The Zernike term is C_d; the sphere's own rho^4 is 1 % of it at f/5.
    assert balanced == pytest.approx(by_hand, rel=0.02)


@pytest.mark.parametrize("field", [(0.0, 0.0), (0.0, 0.7), (0.3, 0.6), (0.0, 1.0)])
def test_the_psf_is_theirs_with_y_upwards(triplet, field):
    psf = pytest.importorskip("optiland.psf").FFTPSF(triplet, field, "primary", num_rays=128, grid_size=1024)
    theirs = np.asarray(psf.psf)[480:545, 480:545][::-1] / 100.0
    pupil = adapter.pupil(triplet, field, circular=True)
    # Samples of theirs are lambda N (rays - 1) / grid apart.
    ours = lm.psf(
        pupil, 65, pupil.scale * 127 / 1024, method=lm.paper.Fraunhofer(samples=512, edge="grey"), normalize="strehl"
    )
    # They count 128 samples across the pupil, an edge of one of them: 2 %.
    assert np.abs(ours.values - theirs).max() < 0.02 * theirs.max()
    assert np.abs(ours.values[::-1] - theirs).max() > 0.1 * theirs.max() or field == (0.0, 0.0)
    assert psf.strehl_ratio() == pytest.approx(float(ours.values.max()), rel=0.02)


@pytest.mark.parametrize(
    ("sample", "field", "within", "of_circles"),
    [
        ("CookeTriplet", (0.0, 0.0), 2e-4, 0.0),
        ("CookeTriplet", (0.0, 0.7), 5e-3, 0.03),
        ("HeliarLens", (0.5, 0.6), 1e-4, 4e-3),
    ],
)
def test_the_psf_is_the_sum_of_huygens_over_the_rays(sample, field, within, of_circles):
    checked = runpy.run_path(str(Path(__file__).parents[2] / "benchmarks" / "optiland_checked.py"))
    lens = getattr(pytest.importorskip("optiland.samples.objectives"), sample)()
    pupil, circle = (adapter.pupil(lens, field, circular=each) for each in (False, True))
    pitch = 0.7e6 * pupil.scale
    places = checked["steps"](15, pitch)
    truth = checked["huygens"](lens, field, places, places)
    found, other = (lm.psf(each, 15, 1e-6 * pitch, integrate=False).values[::-1] for each in (pupil, circle))
    assert checked["error"](found, truth) < within
    assert checked["error"](other, truth) >= of_circles
    assert (pupil.vignetting is None) == (field == (0.0, 0.0))


def test_the_map_is_exact_where_it_was_traced_and_close_in_between(triplet):
    field = adapter.field_map(triplet, heights=9, circular=True, tol=0.03)
    assert field.pupil_without_wavefront.f_number == pytest.approx(4.98, abs=0.005)
    assert field.pupil_without_wavefront.wavelength == pytest.approx(550e-9)
    for hx, hy, within in [(0.0, 0.5, 1e-6), (0.0, 1.0, 1e-6), (0.0, 0.7, 0.02), (0.3, 0.4, 0.02), (-0.5, 0.1, 0.02)]:
        chief = triplet.trace_generic(hx, hy, Px=0.0, Py=0.0, wavelength=0.55)
        found = field.pupil(1e-3 * float(chief.x[0]), -1e-3 * float(chief.y[0])).wavefront
        rest = found - adapter.pupil(triplet, (hx, hy), circular=True).wavefront
        for term, c in rest.edge_terms().items():
            assert abs(float(c)) < within, (hx, hy, term)


def test_a_map_of_ellipses_has_the_psfs_of_huygens_sum_where_circles_are_wrong(triplet):
    checked = runpy.run_path(str(Path(__file__).parents[2] / "benchmarks" / "optiland_checked.py"))
    ellipses, circles = (adapter.field_map(triplet, circular=each) for each in (False, True))
    pitch = 0.7e6 * circles.pupil_without_wavefront.scale
    places = checked["steps"](15, pitch)
    for h in ((0.0, 0.75), (0.5, 0.6)):  # traced, and between
        chief = triplet.trace_generic(*h, Px=0.0, Py=0.0, wavelength=0.55)
        place = 1e-3 * float(chief.x[0]), -1e-3 * float(chief.y[0])
        truth = checked["huygens"](triplet, h, places, places)
        found, other = (of.psf(*place, 15, 1e-6 * pitch, integrate=False).values[::-1] for of in (ellipses, circles))
        assert checked["error"](found, truth) < 0.006
        assert checked["error"](other, truth) > 0.05


def test_a_pupil_over_a_band_has_the_psfs_of_huygens_sum_at_other_wavelengths(triplet):
    checked = runpy.run_path(str(Path(__file__).parents[2] / "benchmarks" / "optiland_checked.py"))
    blue = type(triplet)()
    for wavelength in blue.wavelengths.wavelengths:
        if wavelength.is_primary:
            wavelength._value = wavelength._value_in_um = 0.45
    assert blue.primary_wavelength == 0.45
    for h in ((0.0, 0.0), (0.5, 0.6)):
        pupil = adapter.pupil(triplet, h, band=(440e-9, 650e-9))
        pitch = 0.7e6 * pupil.scale
        places = checked["steps"](15, pitch)
        chief = triplet.trace_generic(*h, Px=0.0, Py=0.0, wavelength=0.55)
        truth = checked["huygens"](blue, h, places, places, about=(float(chief.x[0]), float(chief.y[0])))
        found = lm.psf(pupil.in_light(450e-9), 15, 1e-6 * pitch, integrate=False).values[::-1]
        assert checked["error"](found, truth) < 0.006


def test_distortion_moves_the_light_of_elliptical_pupils_to_the_chief_ray(triplet):
    straight, bent = (adapter.field_map(triplet, heights=17, distortion=each) for each in (False, True))
    at, ideal = straight.vignetting.height[12], bent.vignetting.height[12]
    assert bent.vignetting.along == straight.vignetting.along
    assert abs(at - ideal) > 4e-6
    axis = 7.0 + (at - ideal) / 2e-6  # of rows downwards, where the field is upwards
    moved = bent.psf(0.0, -ideal, 15, 2e-6, center=(axis, 7.0))
    kept = straight.psf(0.0, -at, 15, 2e-6)
    np.testing.assert_allclose(moved.values, kept.values, atol=1e-5 * kept.values.max())


def test_fields_that_are_named_are_traced_instead(triplet):
    points = [(0.0, 0.0), (0.5, 0.0), (0.0, 0.5), (0.5, 0.5)]
    field = adapter.field_map(triplet, fields=points, circular=True, tol=1.0)
    chief = triplet.trace_generic(0.5, 0.5, Px=0.0, Py=0.0, wavelength=0.55)
    found = field.pupil(1e-3 * float(chief.x[0]), -1e-3 * float(chief.y[0])).wavefront
    rest = found - adapter.pupil(triplet, (0.5, 0.5), circular=True).wavefront
    assert all(abs(float(c)) < 1e-8 for c in rest.edge_terms().values())


def test_what_is_no_lens_or_no_wavelength_is_refused(triplet):
    with pytest.raises(TypeError, match="optic must be an optiland Optic, got 5"):
        adapter.pupil(5)
    with pytest.raises(ValueError, match=r"wavelength is in metres .* for 550 nm give 550e-9"):
        adapter.pupil(triplet, wavelength=550)
    with pytest.raises(ValueError, match="fields need circular=True"):
        adapter.field_map(triplet, circular=False, fields=[(0.0, 0.0), (0.5, 0.0), (0.0, 0.5)])
    with pytest.raises(ValueError, match="degree must be higher: Zernike terms up to 2 leave"):
        adapter.pupil(triplet, degree=2)


def test_vignetting_is_refused(triplet):
    lens = type(triplet)()
    lens.fields.fields[-1].vy = 0.2
    with pytest.raises(ValueError, match=r"the field \(0, 1\) has vignetting factors"):
        adapter.pupil(lens, (0.0, 1.0))


@pytest.mark.parametrize("sample", ["CookeTriplet", "ReverseTelephoto"])
def test_distortion_is_that_of_their_analysis(sample):
    """Of f tan(theta), in per cent there, at the heights that both trace."""
    lens = getattr(pytest.importorskip("optiland.samples.objectives"), sample)()
    analysis = pytest.importorskip("optiland.analysis").Distortion(lens, wavelengths="primary", num_points=5)
    theirs = 0.01 * np.ravel(np.asarray(analysis.data[0]))[1:]
    field = adapter.field_map(lens, heights=5, distortion=True, degree=20, tol=0.5)
    plain = adapter.field_map(lens, heights=5, degree=20, tol=0.5)
    edge = math.radians(float(lens.fields.max_field))
    straight = field.reach * np.tan(edge * np.linspace(0.0, 1.0, 5)[1:]) / math.tan(edge)
    chief = straight * (1.0 + theirs)
    assert plain.reach == pytest.approx(chief[-1], rel=1e-7)
    for x, y in ((1.0, 0.0), (0.0, 1.0), (0.6, -0.8)):
        # The wavefront about the chief ray has a tilt of its own, where there is coma.
        inside = (1.0 - 1e-9) * np.minimum(chief, plain.reach)
        found = np.array(field.displacement(straight * x, straight * y))
        found -= plain.displacement(inside * x, inside * y)
        np.testing.assert_allclose(found, np.outer((x, y), theirs * straight), atol=1e-7 * field.reach)


def test_maps_of_several_wavelengths_differ_by_the_lateral_colour_of_the_chief_rays(triplet):
    blue, red = (adapter.field_map(triplet, distortion=True, wavelength=w, circular=True) for w in (480e-9, 650e-9))
    assert blue.reach == red.reach
    chief = [1e-3 * float(triplet.trace_generic(0.0, 1.0, 0.0, 0.0, w).y[0]) for w in (0.48, 0.65)]
    edge = [adapter.pupil(triplet, (0.0, 1.0), wavelength=w, circular=True).wavefront for w in (480e-9, 650e-9)]
    rest = [
        float(wavefront.edge_terms()[1, -1] * one.pupil(0, 0).scale)
        for wavefront, one in zip(edge, (blue, red), strict=True)
    ]
    moved = [float(one.displacement(0.0, -one.reach)[1]) for one in (blue, red)]
    # Tilts of the wavefronts about the chief rays are those of coma.
    np.testing.assert_allclose(moved[0] - moved[1], chief[1] - chief[0] + (rest[0] - rest[1]) / math.pi, atol=1e-9)
    assert abs(chief[0] - chief[1]) > 3e-7


def imaged_at(triplet: Any, kind: str, height: float) -> Any:
    """The triplet with a field up to an image height, millimetres."""
    made = type(triplet)()
    made.set_field_type(kind)
    made.fields.fields.clear()
    for y in (0.0, height):
        made.fields.add(y=y)
    return made


@pytest.mark.parametrize("kind", ["real_image_height", "paraxial_image_height"])
@pytest.mark.parametrize("height", [0.02, 12.4])
def test_a_field_given_by_its_image_height_has_the_pupil_of_its_angle(kind, height, triplet):
    # Theirs has the tilt of the wave where rays begin for angles alone: 1168 waves at 12.4 mm.
    other = imaged_at(triplet, kind, height)
    chief = other.ray_tracer.ray_generator.generate_rays(0.0, 1.0, 0.0, 0.0, 0.55)
    angle = math.degrees(math.asin(float(np.ravel(chief.M)[0])))
    found = adapter.pupil(other, (0.0, 1.0), wavelength=550e-9)
    expected = adapter.pupil(triplet, (0.0, angle / 20.0), wavelength=550e-9)
    assert found.f_number == pytest.approx(expected.f_number, rel=1e-9)
    for term, c in (found.wavefront - expected.wavefront).edge_terms().items():
        assert abs(float(c)) < 1e-6, term


@pytest.mark.parametrize(
    ("kind", "edge"),
    [("object_height", 100.0), ("angle", 15.0), ("real_image_height", 10.0), ("paraxial_image_height", 10.0)],
)
def test_phases_of_near_objects_agree_with_the_rays_in_every_kind_of_field(kind, edge, triplet):
    lens = imaged_at(triplet, kind, edge)
    lens.surfaces.surfaces[0].geometry.cs.z = -300.0
    assert 4.9 < adapter.pupil(lens, (0.0, 0.7), degree=20, tol=1.0).f_number < 5.2


def test_phases_that_no_known_tilt_reconciles_with_the_rays_are_refused(triplet, monkeypatch):
    exact = adapter._phase_at_start  # as of a field type to come
    monkeypatch.setattr(adapter, "_phase_at_start", lambda *args: 1.01 * exact(*args))
    with pytest.raises(
        ValueError, match=r"the lens must have phases .*; at the field \(0, 1\) they differ by a tilt"
    ):
        adapter.pupil(imaged_at(triplet, "real_image_height", 10.0), (0.0, 1.0))


def test_distortion_needs_a_symmetric_lens(triplet):
    with pytest.raises(ValueError, match="fields must be left out with distortion"):
        adapter.field_map(triplet, fields=[(0.0, 0.0), (0.0, 1.0), (1.0, 0.0)], distortion=True)
