"""From rays to pupils, for lenses whose rays are known by formula."""

from __future__ import annotations

import json
import math
from dataclasses import replace

import numpy as np
import pytest

import lommel as lm
from lommel.adapters import ray_tracing as tracing
from lommel.special import zernike

WAVELENGTH, N = 550e-9, 4.0
EDGE = 10e-3


def lens(
    *,
    upside_down: bool = False,
    squint: float = 0.0,
    blocked: int = 0,
    image: float = 1.0,
    slower: float = 1.0,
    tilt: float = 0.0,
):
    """The trace of a lens with coma and astigmatism, 10 mm of field, in the frame of a ray tracer.

    Its phases may have a `tilt` in radians, along with the field, that its rays do not have.
    """

    def trace(hx: float, hy: float, x: np.ndarray, y: np.ndarray) -> tracing.TracedField:
        side = -1.0 if upside_down else 1.0
        # In the exit pupil, y upwards.
        u, v = side * x, side * y
        along = u * hx + v * hy
        phase = 3.0 * (u * u + v * v) * along + 2.0 * along**2 + 1.0 * (u**2 + v**2) + squint * hx * u**3
        phase += tilt * along
        phase[:blocked] = np.nan
        sine = 0.5 / N
        position = (image * EDGE * hx, image * EDGE * hy)
        slope_u = 6.0 * u * along + 3.0 * (u * u + v * v) * hx + 4.0 * along * hx + 2.0 * u + 3.0 * squint * hx * u**2
        slope_v = 6.0 * v * along + 3.0 * (u * u + v * v) * hy + 4.0 * along * hy + 2.0 * v
        # Rays meet the sensor at minus the slope of the phase by their direction cosines.
        missed_u, missed_v = (WAVELENGTH / (2.0 * math.pi * sine) * slope for slope in (slower * slope_u, slope_v))
        directions = -sine * u / slower, -sine * v
        return tracing.TracedField(x, y, phase + 7.0, *directions, missed_u, missed_v, position)

    return trace


def single(trace, field, degree=6, tol=1e-6):
    return tracing.single_pupil(lambda wave: trace, field, WAVELENGTH, degree, tol, circular=True)


def test_the_pupil_and_the_position_are_mirrored_so_that_y_rises_downwards():
    pupil = single(lens(), (0.3, 0.8))
    x, y = 0.4, 0.5
    expected = 3.0 * (x * x + y * y) * (x * 0.3 - y * 0.8) + 2.0 * (x * 0.3 - y * 0.8) ** 2 + (x * x + y * y)
    offset = pupil.wavefront.phase(0.0)  # piston is left out
    assert pupil.wavefront.phase(math.hypot(x, y), math.atan2(y, x)) - offset == pytest.approx(expected)
    assert (pupil.wavelength, pupil.obscuration) == (WAVELENGTH, 0.0)


def test_a_pupil_that_is_imaged_upside_down_is_turned_back():
    upright, inverted = single(lens(), (0.3, 0.8)), single(lens(upside_down=True), (0.3, 0.8))
    for term, c in (upright.wavefront - inverted.wavefront).edge_terms().items():
        assert abs(float(c)) < 1e-9, term


def test_the_f_number_is_that_of_the_cone_of_light():
    assert single(lens(), (0.0, 0.0)).f_number == pytest.approx(N)
    assert single(lens(slower=1.21), (0.0, 0.0)).f_number == pytest.approx(1.1 * N)


@pytest.mark.parametrize("image", [1.0, -1.0], ids=["upright", "inverted"])
def test_the_map_of_a_symmetric_lens_agrees_with_its_rays_everywhere(image):
    trace = lens(image=image)
    field = tracing.field_map(trace, 4, None, WAVELENGTH, 6, 1e-6)
    assert field.reach == pytest.approx(EDGE)
    for hx, hy in [(0.0, 1.0), (0.3, 0.4), (-0.6, -0.2), (1.0, 0.0)]:
        found = field.pupil(image * EDGE * hx, -image * EDGE * hy).wavefront
        for term, c in (found - single(trace, (hx, hy)).wavefront).edge_terms().items():
            assert abs(float(c)) < 1e-9, term


def test_a_lens_without_symmetry_is_told_unless_fields_are_given():
    trace = lens(squint=1.0)
    with pytest.raises(ValueError, match="not rotationally symmetric; give fields"):
        tracing.field_map(trace, 4, None, WAVELENGTH, 6, 1e-6)
    points = [(hx, hy) for hx in (-1.0, 0.0, 1.0) for hy in (-1.0, 0.0, 1.0)]
    field = tracing.field_map(trace, 4, points, WAVELENGTH, 6, 1e-6, circular=True)
    found = field.pupil(EDGE, -EDGE).wavefront - single(trace, (1.0, 1.0)).wavefront
    assert all(abs(float(c)) < 1e-9 for c in found.edge_terms().values())


def dispersive(wave):
    """The lens with axial colour, lateral colour and spherochromatism of its own: as in no achromatic lens."""
    relative = wave / WAVELENGTH - 1.0
    trace = lens()

    def traced(hx, hy, x, y):
        rays = trace(hx, hy, x, y)
        # Path differences in metres are those at WAVELENGTH, and others that grow with the distance from it.
        squares = x * x + y * y
        focus, sphere = 2.0 * relative + 5.0 * relative**2, 3.0 * relative
        phase = (rays.phase + focus * squares + sphere * squares**2) / (1.0 + relative)
        reach = WAVELENGTH / (math.pi / N)
        gradient = reach * (2.0 * focus + 4.0 * sphere * squares)
        missed = rays.missed_x + gradient * x, rays.missed_y + gradient * y
        position = tuple(p * (1.0 + 1e-4 * relative) for p in rays.position)
        return replace(rays, phase=phase, missed_x=missed[0], missed_y=missed[1], position=position)

    return traced


@pytest.mark.parametrize("circular", [True, False])
@pytest.mark.parametrize("field", [(0.0, 0.0), (0.3, 0.8)])
def test_a_pupil_over_a_band_has_the_colour_of_the_lens(circular, field):
    options = {"degree": 6, "tol": 1e-3, "circular": circular}
    pupil = tracing.single_pupil(dispersive, field, WAVELENGTH, band=(450e-9, 650e-9), **options)
    for wave in (450e-9, 487e-9, WAVELENGTH, 650e-9):
        alone = tracing.single_pupil(dispersive, field, wave, **options)
        # The image moves along with the chief ray, which is the middle of the image of the pupil alone.
        moved = [EDGE * 1e-4 * (wave / WAVELENGTH - 1.0) * h for h in (field[0], -field[1])]
        pixel, middle = 1e-6, 16.0
        found = lm.psf(pupil.in_light(wave), 33, pixel)
        center = tuple(middle + shift / pixel for shift in reversed(moved))
        np.testing.assert_allclose(
            found.values, lm.psf(alone, 33, pixel, center=center).values, atol=2e-3 * found.values.max()
        )
    again = lm.Pupil.from_dict(json.loads(json.dumps(pupil.to_dict())))
    assert again == pupil
    with pytest.raises(ValueError, match="known from 450 to 650 nm, got 660; pass a wider band"):
        lm.colour_psf(pupil, 9, 1e-6, lm.Channels([660e-9], [[1.0]], ["deep red"]))


def test_a_traced_pupil_or_map_without_a_band_is_not_taken_for_achromatic():
    pupil = tracing.single_pupil(dispersive, (0.0, 0.5), WAVELENGTH, 6, 1e-3, circular=False)
    with pytest.raises(ValueError, match=r"known at 550 nm, not at 6\d\d nm; pass band="):
        lm.colour_psf(pupil, 9, 1e-6)
    with pytest.raises(ValueError, match="or compute a map for each wavelength"):
        tracing.field_map(dispersive(WAVELENGTH), None, None, WAVELENGTH, 6, 1e-3).psf(
            0.0, 0.0, 9, 1e-6
        ).pupil.in_light(6e-7)


@pytest.mark.parametrize("band", [(650e-9, 450e-9), (500e-9, 540e-9), (500e-9, 550e-9, 600e-9), (math.nan, 1.0)])
def test_a_band_that_is_none_is_refused(band):
    with pytest.raises(ValueError, match="band must"):
        tracing.single_pupil(dispersive, (0.0, 0.5), WAVELENGTH, 6, 1e-3, circular=False, band=band)


def wavy(trace, waves):
    """The lens with astigmatism that oscillates over the field: `waves` periods from the axis to the edge."""

    def traced(hx, hy, x, y):
        rays = trace(hx, hy, x, y)
        height = math.hypot(hx, hy) + 1e-12
        bend = 0.5 * math.sin(math.pi * waves * height) ** 2 / height**2
        along, across = x * hx + y * hy, x * hy - y * hx
        phase = rays.phase + bend * (along**2 - across**2)
        # The rays move with the gradient of the phase.
        gx, gy = (2.0 * bend * (along * p + q * across) for p, q in ((hx, -hy), (hy, hx)))
        reach = WAVELENGTH / (math.pi / N)
        return replace(rays, phase=phase, missed_x=rays.missed_x + reach * gx, missed_y=rays.missed_y + reach * gy)

    return traced


@pytest.mark.parametrize("circular", [True, False])
def test_a_map_has_as_many_heights_as_its_pupils_require(circular):
    trace = wavy(lens(), 3.0)
    with pytest.raises(ValueError, match=r"between 7 heights .* differ by up to 0\.\d+ rad rms .* leave heights out"):
        tracing.field_map(trace, 7, None, WAVELENGTH, 6, 0.01, circular=circular)
    field = tracing.field_map(trace, None, None, WAVELENGTH, 6, 0.01, circular=circular)
    for h in np.linspace(0.0, 1.0, 38):
        rest = field.pupil(0.0, -EDGE * h).wavefront - single(trace, (0.0, h), tol=0.01).wavefront
        assert lm.rms(rest) < 0.01
    with pytest.raises(ValueError, match="between 129 heights"):
        tracing.field_map(wavy(lens(), 41.3), None, None, WAVELENGTH, 6, 1e-4, circular=circular)


@pytest.mark.parametrize(
    ("call", "error", "what"),
    [
        (lambda: single(lens(blocked=3), (0, 0)), ValueError, "3 of 119 rays do not reach the image; vignetting"),
        (lambda: single(lens(), (0, 1), degree=2), ValueError, r"up to 2 leave .* rad rms, more than tol=1e-06"),
        (lambda: single(lens(), (0, 2)), ValueError, "field must be fractions of the largest field"),
        (lambda: single(lens(slower=-1.0), (0, 0)), ValueError, "do not converge towards an image"),
        (lambda: tracing.field_map(lens(), 1, None, WAVELENGTH, 6, 1), ValueError, "heights must be from 2 to 1000"),
        (lambda: tracing.field_map(lens(image=0.0), 3, None, WAVELENGTH, 6, 1), ValueError, "image is on the axis"),
    ],
)  # fmt: skip
def test_what_makes_no_sense_is_refused_by_name(call, error, what):
    with pytest.raises(error, match=what):
        call()


def test_the_rays_are_enough_to_see_that_the_degree_is_too_low():
    x, y = tracing.sample_points(8)
    rho, theta = np.hypot(x, y), np.arctan2(y, x)
    assert rho.max() < 1.0
    terms = [(n, m) for n in range(9) for m in range(-n, n + 1, 2)]
    matrix = np.stack([zernike.polynomial(n, m, rho, theta) for n, m in terms], axis=1)
    for n, m in [(9, 9), (9, 1), (10, 0), (10, -10)]:
        beyond = zernike.polynomial(n, m, rho, theta)
        rest = beyond - matrix @ np.linalg.lstsq(matrix, beyond, rcond=None)[0]
        assert np.sqrt(np.mean(rest**2)) > 0.5 * np.sqrt(np.mean(beyond**2)), (n, m)


@pytest.mark.parametrize("tilt", [0.0, 0.05, 1.0, -300.0])
def test_a_tilt_that_rays_do_not_have_is_found(tilt):
    x, y = tracing.sample_points(8)
    sine = 0.5 / N
    phase = 2.0 * (x * x + y * y) + 3.0 * (x * x + y * y) * y
    # Rays meet the sensor at minus the slope of the phase by their direction cosines, which are -sine times x and y.
    missed = [
        WAVELENGTH / (2.0 * math.pi * sine) * slope
        for slope in (4.0 * x + 6.0 * x * y, 4.0 * y + 3.0 * x * x + 9.0 * y * y)
    ]
    traced = tracing.TracedField(x, y, phase + tilt * y, -sine * x, -sine * y, *missed, (0.0, 0.0))
    found = tracing.tilt_off_rays(traced, WAVELENGTH)
    assert found == pytest.approx(abs(tilt) if abs(tilt) > 0.5 else 0.0, rel=1e-6)
    traced.phase[3] = np.nan  # of a ray that is blocked, which is told elsewhere
    assert tracing.tilt_off_rays(traced, WAVELENGTH) == 0.0


@pytest.mark.parametrize(
    "call",
    [
        lambda trace: single(trace, (0.6, 0.8)),
        lambda trace: tracing.single_pupil(lambda wave: trace, (0.0, -1.0), WAVELENGTH, 6, 1e-6, circular=False),
        lambda trace: tracing.field_map(trace, 3, None, WAVELENGTH, 6, 1e-6),
        lambda trace: tracing.field_map(trace, 3, [(0, 0), (0, 1), (1, 0)], WAVELENGTH, 6, 9.0, circular=True),
    ],
    ids=["circle", "ellipse", "map", "fields"],
)
def test_phases_that_do_not_agree_with_the_rays_are_refused(call):
    call(lens())
    with pytest.raises(ValueError, match=r"agree with its rays; at the field .* differ by a tilt"):
        call(lens(tilt=2.0))


CORNERS = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]


@pytest.mark.parametrize("kind", ["heights", "fields", "band"])
def test_what_is_interpolated_is_compared_half_way_and_may_differ_by_the_tolerance(kind, monkeypatch):
    def trace(hx, hy, x, y):
        places.append((hx, hy))
        return lens()(0.0 if kind == "band" else hx, hy, x, y)

    def made(*found):
        differences = iter(found)
        monkeypatch.setattr(tracing, "_difference", lambda *_: next(differences))
        if kind == "band":
            at = {"circular": True, "band": (0.5e-6, 0.6e-6)}
            tracer = lambda wave: lambda _, *rest: trace(1e6 * wave, *rest)  # noqa: E731
            return tracing.single_pupil(tracer, (0, 0), WAVELENGTH, 6, 0.01, **at)
        fields = CORNERS[:3] if kind == "fields" else None
        return tracing.field_map(trace, 3, fields, WAVELENGTH, 6, 0.01, circular=True)

    places = []
    monkeypatch.setattr(tracing, "_BAND_COUNTS", (3,))
    made(0.0099999, 0.0099999)
    half = {"heights": [(0, 0.25), (0, 0.75)], "fields": [(1 / 3, -1 / 3)], "band": [(0.525, 0), (0.575, 0)]}[kind]
    assert all(np.hypot(*(np.array(places) - place).T).min() < 1e-9 for place in half)
    with pytest.raises(ValueError, match=r"more than tol=0\.01"):
        made(*[0.001] * (len(half) - 1), 0.0100001)


def test_a_fit_and_a_symmetry_are_accepted_up_to_the_tolerance():
    x, y = tracing.sample_points(4)
    rho, theta = np.hypot(x, y), np.arctan2(y, x)
    matrix = np.stack([zernike.polynomial(n, m, rho, theta) for n in range(5) for m in range(-n, n + 1, 2)], axis=1)
    rest = math.sqrt(np.mean((matrix @ np.linalg.lstsq(matrix, rho**5, rcond=None)[0] - rho**5) ** 2))
    assert tracing._fit_terms(rho**5, x, y, 4, 1.001 * rest)
    with pytest.raises(ValueError, match="degree must be higher"):
        tracing._fit_terms(rho**5, x, y, 4, 0.999 * rest)
    field = tracing.field_map(lens(), 4, None, WAVELENGTH, 6, 1e-6)
    edge = {t: float(c) for t, c in field.pupil(EDGE, 0.0).wavefront.edge_terms().items() if t != (0, 0)}
    for sign in (-1.0, 1.0):
        tracing._require_symmetry(field, edge | {(3, 1): edge[3, 1] + sign * 0.0999}, (EDGE, 0.0), EDGE, 0.01)
        for terms, place in ((edge | {(3, 1): edge[3, 1] + sign * 0.1001}, EDGE), (edge, EDGE * (1.0 + sign * 2e-6))):
            with pytest.raises(ValueError, match="not rotationally symmetric"):
                tracing._require_symmetry(field, terms, (place, 0.0), EDGE, 0.01)


def test_a_cone_may_change_over_a_band_by_half_of_the_tolerance_and_over_the_field_of_a_map():
    def pupil(change):
        def turned(wave):  # and widened: a change of the square root of 2 times this
            return lambda *point: wider(lens()(*point), change * (wave / WAVELENGTH - 1.0) / 0.1 / math.sqrt(2.0))

        def wider(rays, c):
            x, y = rays.direction_x, rays.direction_y
            return replace(rays, direction_x=x + c * (x - y), direction_y=y + c * (x + y))

        band = WAVELENGTH, 1.1 * WAVELENGTH
        return tracing.single_pupil(turned, (0, 0), WAVELENGTH, 6, 0.01, circular=False, band=band)

    assert pupil(0.00499).colour.wavelengths[-1] == pytest.approx(1.1 * WAVELENGTH)
    with pytest.raises(ValueError, match="cone of light differs"):
        pupil(0.00501)
    trace = lambda hx, hy, x, y: lens(slower=1.0 + 0.21 * (hx * hx + hy * hy))(hx, hy, x, y)  # noqa: E731
    field = tracing.field_map(trace, None, CORNERS, WAVELENGTH, 6, 9.0, circular=True)
    assert field.pupil(0.0, 0.0).f_number == pytest.approx(N)  # that on the axis
