"""Apertures of shapes: proven bounds against references that share nothing with the compiled rules."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import lommel as lm
from column_sums import field, nodes
from lommel import Disc, Ellipse, Mask, Polygon, Pupil, Segments, Spider, Wavefront
from lommel.core.answers import ToleranceError, Wanted
from lommel.methods import NonuniformFFT, nonuniform_fft
from lommel.optics.aperture.opening import Opening
from lommel.optics.aperture.shapes import Combined
from lommel.optics.grid import Grid
from lommel.special import zernike

TOLERANCES = 10.0 ** -np.arange(3.0, 11.0)
SIDES, PIXEL, CENTER = (4, 5), 0.7, (-0.6, 3.3)
DOWN, ACROSS = (math.pi * PIXEL * (np.arange(n) - c) for n, c in zip(SIDES, CENTER, strict=True))


def of_polygon(corners, vx, vy):
    """(1/pi) int exp(-i v.rho) dx dy over a polygon whose corners turn from x to y: the theorem of Stokes."""
    total = np.zeros(np.broadcast_shapes(vx.shape, vy.shape), dtype=complex)
    square = vx * vx + vy * vy
    known = np.where(square == 0.0, 1.0, square)
    for p, q in zip(np.array(corners), np.roll(corners, -1, axis=0), strict=True):
        d, middle = q - p, 0.5 * (p + q)
        along = 0.5 * (vx * d[0] + vy * d[1])
        flux = (vx * d[1] - vy * d[0]) * np.sinc(along / math.pi) * np.exp(-1j * (vx * middle[0] + vy * middle[1]))
        total += 1j * flux / known
    return np.where(square == 0.0, area_of(corners), total / math.pi)


def area_of(corners):
    x, y = np.array(corners).T
    return 0.5 * abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))) / math.pi


def image(pupil, tol, **options):
    return lm.psf(
        pupil, SIDES, PIXEL, method=NonuniformFFT(tol), center=CENTER, normalize="strehl", dtype=np.float64, **options
    )


def check(pupil, reference, uncertain=0.0):
    """Every tolerance is kept by the bound, and the bound by the image."""
    for tol in TOLERANCES:
        answer = image(pupil, tol)
        error = np.abs(answer.values - reference).max()
        assert answer.error_bound <= tol
        assert error <= answer.error_bound * reference.max() + uncertain


@pytest.mark.parametrize("sides", [3, 4, 6, 11])
@pytest.mark.parametrize(("radius", "place"), [(1.0, (0.0, 0.0)), (0.4, (0.3, -0.2)), (1e-3, (0.6, 0.7))])
def test_polygons_have_the_closed_form_of_their_transform(sides, radius, place):
    polygon = Polygon.regular(sides, radius, place, 0.3)
    u = of_polygon(polygon.corners, ACROSS[None, :], DOWN[:, None]) / area_of(polygon.corners)
    check(Pupil(stop=polygon), np.abs(u) ** 2, 2e-12 if radius > 0.1 else 1e-9)


def test_a_hexagon_is_right_to_a_billionth():
    hexagon = Polygon.regular(6, 1.0)
    answer = lm.psf(Pupil(stop=hexagon), 64, 0.4, method=NonuniformFFT(1e-10), normalize="strehl", dtype=np.float64)
    v = math.pi * answer.grid.x
    u = of_polygon(hexagon.corners, v[None, :], v[:, None]) / area_of(hexagon.corners)
    assert np.abs(answer.values - np.abs(u) ** 2).max() <= 1e-9


def test_the_segments_of_jwst_have_the_sum_of_their_closed_forms():
    segments = Segments.hexagonal(2, 0.02)
    rng = np.random.default_rng(5)
    segments = segments.phased(*rng.normal(size=(3, 18)))
    total, area = 0.0, 0.0
    for part, piston, tip, tilt, at in zip(
        segments.shapes, segments.piston, segments.tip, segments.tilt, segments.centers, strict=True
    ):
        turn = np.exp(1j * (piston - tip * at[0] - tilt * at[1]))
        total = total + turn * of_polygon(part.corners, ACROSS[None, :] - tip, DOWN[:, None] - tilt)
        area += area_of(part.corners)
    check(Pupil(stop=segments), np.abs(total / area) ** 2, 1e-12)


WAVEFRONT = Wavefront(2.0, 1.0, nonradial={(1, -1): 1.0, (2, 2): 1.5, (3, 1): 2.0, (7, -5): 0.6})
HOLE = Disc(0.2, (0.3, 0.3))
PUPILS = {
    "a union": {"stop": Disc(0.6, (0.3, 0.0)) | Ellipse(0.7, 0.3, 0.5, (-0.3, 0.1))},
    "a difference with a spider": {"stop": Polygon.regular(6, 1.0) - HOLE, "spider": Spider.equal(3, 0.03, 0.1)},
    "shapes that touch": {"stop": Disc(0.3, (0.3, 0.0)) | Disc(0.3, (-0.3, 0.0))},
    "touching from within": {"stop": Disc(0.9) - Disc(0.5, (0.0, 0.4))},
    "a slit between two edges": {"stop": Polygon.half_plane(0.5, 0.3) - Polygon.half_plane(0.5, 0.299)},
    "almost the same disc": {"stop": Disc(0.9) | Disc(0.9, (0.0, 1e-10))},
    "beyond the rim": {"stop": Polygon(((-3.0, -0.5), (2.0, -0.2), (2.0, 0.4))), "apodization": 0.8},
    "corners on the rim": {"stop": Polygon.regular(4, 1.0) - Polygon.regular(4, 0.5, (0.5, 0.0))},
    "a vast disc": {"stop": Disc(1000.0, (1000.2, 0.0))},
    "segments": {"stop": Segments((Disc(0.3, (0.5, 0)), Disc(0.4, (-0.4, 0.1)) - HOLE), (1.0, 0.0), (0.0, 5.0))},
    "a thin turned ellipse": {"stop": Ellipse(0.5, 1e-4, 0.4, (0.1, 0.3))},
}  # fmt: skip


@pytest.mark.parametrize("name", PUPILS)
def test_every_tolerance_is_kept_on_any_aperture(name):
    pupil = Pupil(WAVEFRONT, **PUPILS[name])
    (coarse, _), (u, amplitude) = (field(pupil, ACROSS, DOWN, fine) for fine in (1.4, 2.0))
    off = np.abs(coarse - u).max() / amplitude
    assert off <= 1e-10
    check(pupil, np.abs(u / amplitude) ** 2, 4.0 * off + 1e-13)


places = st.tuples(st.floats(-0.8, 0.8), st.floats(-0.8, 0.8))
discs = st.builds(Disc, st.floats(0.1, 1.0), places)
ellipses = st.builds(Ellipse, st.floats(0.05, 1.0), st.floats(0.05, 1.0), st.floats(-3, 3), places)
polygons = st.builds(Polygon.regular, st.integers(3, 7), st.floats(0.1, 1.3), places, st.floats(0, 6))
parts = discs | ellipses | polygons
shapes = st.recursive(parts, lambda part: st.builds(Combined, st.sampled_from("|&-"), part, part), max_leaves=5)


@settings(max_examples=30)
@given(shapes, st.sampled_from([1e-3, 1e-5, 1e-7, 1e-9]), st.integers(0, 3))
def test_the_bound_holds_on_random_apertures(shape, tol, aberrations):
    wavefront = Wavefront(float(aberrations), nonradial={(3, -1): 1.0 * aberrations})
    try:
        pupil = Pupil(wavefront, stop=shape)
    except ValueError:
        return  # nothing is clear
    if pupil.area < 1e-4:
        return
    (coarse, _), (u, amplitude) = (field(pupil, ACROSS, DOWN, fine) for fine in (1.4, 2.0))
    reference, off = np.abs(u / amplitude) ** 2, np.abs(coarse - u).max() / amplitude
    answer = image(pupil, tol)
    error = np.abs(answer.values - reference).max()
    assert error <= answer.error_bound * reference.max() + 10.0 * off + 1e-13
    assert answer.error_bound <= tol


@pytest.mark.parametrize(
    "shape",
    [
        Disc(0.9) & Disc(0.8, (0.3, 0.1)),
        Polygon.regular(6, 0.9) - Ellipse(0.4, 0.2, 0.3),
        Disc(0.9) - Disc(0.5, (0, 0.4)),
    ],
    ids=["lens", "hexagon", "touching"],
)  # fmt: skip
@pytest.mark.parametrize("error", [1e-3, 1e-6, 1e-9, 1e-12])
def test_rules_are_within_their_error_for_every_polynomial_of_the_degree(shape, error):
    degree = 32
    (rule,) = Opening(stop=shape).rows(degree, error)
    x, y, w = rule.nodes
    fine = nodes(shape, 2.0)
    assert np.all(w > 0.0)
    for n in range(0, degree + 1, 4):
        for m in range(n % 2, n + 1, 6):
            for sign in (1, -1) if m else (1,):
                at, there = (
                    zernike.polynomial(n, sign * m, np.hypot(a, b), np.arctan2(b, a)) for a, b in ((x, y), fine[:2])
                )
                assert abs(w @ at - fine[2] @ there) <= error + rule.lost + 2e-14
    # Chebyshev's polynomial of a direction, as large off the disc as any.
    for angle in (0.0, 0.9, 0.5 * math.pi):
        at, there = (np.clip(a * math.cos(angle) + b * math.sin(angle), -1, 1) for a, b in ((x, y), fine[:2]))
        exact = fine[2] @ np.cos(degree * np.arccos(there))
        assert abs(w @ np.cos(degree * np.arccos(at)) - exact) <= error + rule.lost + 2e-14


def test_edges_that_rounding_moves_are_in_the_bound():
    for shape, exact in (
        (Ellipse(0.5, 1e-9, 0.4, (0.1, 0.3)), 0.5e-9),
        (Ellipse(1e-7, 1e-8, 0.4, (0.1, 0.3)), 1e-15),
        (Disc(1e-9, (0.6, -0.3)), 1e-18),
    ):
        (rule,) = Opening(stop=shape).rows(16, 1e-22)
        assert abs(rule.weight - exact) <= rule.lost
        assert rule.lost <= 1e-14
    with pytest.raises(ToleranceError, match="cannot be met in double precision"):
        image(Pupil(stop=Ellipse(0.5, 1e-6, 0.4, (0.1, 0.3))), 1e-10)
    # A thousand radii away, an edge has three digits less.
    (rule,) = Opening(stop=Disc(1000.0, (1000.0, 0.0))).rows(16, 1e-15)
    assert 1e-14 <= rule.lost <= 1e-11


@pytest.mark.parametrize("off", [1e-16, 1e-14, 1e-13, 1e-12, 1e-10, 1e-8, 1e-5])
@pytest.mark.parametrize("direction", [(0.0, 1.0), (1.0, 0.0), (0.6, 0.8)])
def test_edges_that_nearly_touch_or_coincide_are_resolved(off, direction):
    def at(distance):
        return (distance * direction[0], distance * direction[1])

    for shape in (
        Disc(0.9) | Disc(0.9, at(off)),
        Disc(0.9) & Disc(0.9, at(off)),
        Disc(0.9) - Disc(0.5, at(0.4 + off)),
        Disc(0.9) - Disc(0.5, at(0.4 - off)),
        Disc(0.3, at(0.3)) | Disc(0.3, at(-0.3 + off)),
        Ellipse(0.8, 0.4, 0.3) - Disc(0.2 + off, (0.6 * math.cos(0.3), 0.6 * math.sin(0.3))),
        Disc(0.5) - Ellipse(0.5 * (1 - off), 0.5, 0.3),
        Polygon.regular(6, 0.8) - Polygon.regular(6, 0.8, at(off)),
        Polygon.regular(6, 0.8) | Polygon.regular(6, 0.8, (0.0, 0.0), off),
    ):
        (rule,) = Opening(stop=shape).rows(16, 1e-14)
        assert abs(rule.weight - nodes(shape, 2.0)[2].sum()) <= rule.lost + 2e-14


def test_derivatives_by_terms_are_those_of_the_reference():
    pupil = Pupil(WAVEFRONT, stop=Polygon.regular(6, 0.9) - Disc(0.25, (0.1, 0.0)), apodization=0.5)
    terms = ((2, 0), (2, -2), (4, 4), (5, 1))
    u, amplitude = field(pupil, ACROSS, DOWN, 2.0)
    peak = np.abs(u).max() ** 2
    exact = []
    for n, m in terms:

        def term(x, y, n=n, m=m):
            return zernike.polynomial(n, m, np.hypot(x, y), np.arctan2(y, x))

        g, _ = field(pupil, ACROSS, DOWN, 2.0, term)
        exact.append(2.0 * (np.conj(u) * 1j * g).real)
    for tol in TOLERANCES:
        wanted = Wanted(scale=1.0 / amplitude**2, terms=terms)
        slopes = NonuniformFFT(tol).images(pupil, Grid(SIDES, PIXEL, center=CENTER), wanted).slopes
        for found, bound, known in zip(slopes.values[:, 0], slopes.error[:, 0], exact, strict=True):
            assert np.abs(found * amplitude**2 - known).max() <= (bound + 1e-12) * peak
            assert bound <= 30.0 * tol


def test_the_largest_value_may_lie_outside_of_the_window():
    pupil = Pupil(Wavefront(nonradial={(1, 1): 40.0}), stop=Polygon.regular(6, 0.9))
    u, amplitude = field(pupil, ACROSS, DOWN, 2.0)
    answer = image(pupil, 1e-6)
    assert answer.error_bound <= 1e-6
    # The peak is 1: the image is shifted.
    assert np.abs(answer.values - np.abs(u / amplitude) ** 2).max() <= answer.error_bound


def test_any_piston_is_taken_modulo_a_wave():
    shapes = (Disc(0.3, (0.4, 0.0)), Disc(0.3, (-0.4, 0.0)))
    few, many = (Pupil(stop=Segments(shapes, piston=(0.5 + 2.0 * math.pi * k, 0.0))) for k in (0, 10**7))
    assert image(many, 1e-6).values == pytest.approx(image(few, 1e-9).values, abs=1e-6)


@pytest.mark.parametrize(
    "many", [None, Mask(np.eye(33) + 0.5 * np.ones((33, 33)) * (1.0 - np.eye(33)), squares=True)]
)
@pytest.mark.parametrize("turns", [1e2, 1e4, 1e6, 1e9, 1e14])
def test_bounds_hold_what_many_turns_of_segments_lose(turns, many):
    segments, rng = Segments.hexagonal(1, 0.01), np.random.default_rng(3)
    piston, tip = turns * rng.uniform(0.5, 1.0, 6), rng.normal(size=6)
    within = np.arctan2(np.sin(piston), np.cos(piston))  # functions of libm reduce by all the digits of pi
    exact = image(Pupil(stop=segments.phased(within, tip), mask=many), 1e-11)
    answered = 0
    for tol in (1e-12, *TOLERANCES[::-1]):
        try:
            answer = image(Pupil(stop=segments.phased(piston, tip), mask=many), tol)
        except ToleranceError:
            continue
        answered += 1
        error = np.abs(answer.values - exact.values).max() / exact.values.max()
        assert error <= answer.error_bound + 1e-14
    assert answered == 0 if turns > 1e13 else answered > 0


CUT = Polygon([(-0.9, -0.7), (0.8, -0.8), (0.5, 0.9)])


@pytest.mark.parametrize(
    ("shape", "center", "half"),
    [
        (33, None, (33, 17)),
        ((20, 24), None, (21, 13)),
        ((20, 25), (9.5, 12.0), (20, 13)),
        ((21, 24), (11.0, 11.5), (23, 12)),
        ((21, 24), (9.0, 13.5), (23, 14)),
        ((21, 24), (2.0, 11.5), None),
        ((21, 24), (10.25, 11.5), None),
        ((21, 24), (10.0, -1.0), None),
    ],
)
def test_images_of_a_real_pupil_are_those_of_one_side_of_the_axis(monkeypatch, shape, center, half):
    pupil, grid = Pupil(stop=CUT, apodization=0.4), Grid(shape, 0.7, center=center)
    computed, rows = [], nonuniform_fft.row_images
    monkeypatch.setattr(nonuniform_fft, "moment_rule_is_faster", lambda *_: False)
    monkeypatch.setattr(nonuniform_fft, "row_images", lambda *args: computed.append(args[3].shape) or rows(*args))
    found = NonuniformFFT(1e-9).images(pupil, grid, Wanted())
    assert computed[0] == (half or grid.shape)
    monkeypatch.setattr(nonuniform_fft, "_half_grid", lambda _: None)
    whole = NonuniformFFT(1e-9).images(pupil, grid, Wanted())
    assert np.abs(found.values - whole.values).max() < 1e-11


@pytest.mark.parametrize(
    "pupil",
    [
        Pupil(Wavefront(nonradial={(3, 1): 1.0}), stop=CUT),
        Pupil(stop=Segments((CUT,), tilt=(2.0,))),
        Pupil(mask=Mask(np.exp(1j * np.arange(64.0).reshape(8, 8)), squares=True)),
    ],
)
def test_images_of_other_pupils_have_two_sides(monkeypatch, pupil):
    found = NonuniformFFT(1e-9).images(pupil, Grid(33, 0.5), Wanted()).values[0]
    monkeypatch.setattr(nonuniform_fft, "_half_grid", lambda _: None)
    whole = NonuniformFFT(1e-9).images(pupil, Grid(33, 0.5), Wanted()).values[0]
    assert np.abs(found - whole).max() < 1e-11
    assert np.abs(whole[:, :16] - whole[::-1, :16:-1]).max() > 0.01 * whole.max()


def test_segments_converge_by_lattices_too():
    segments = Segments.hexagonal(1, 0.05).phased(np.arange(6) * 0.4, tip=1.0, tilt=np.arange(6) * 0.3)
    pupil = Pupil(Wavefront(1.0), stop=segments)
    exact = image(pupil, 1e-9).values
    for method in (lm.methods.MatrixFourier(512), lm.paper.Fraunhofer(512, edge="grey", padding=1.5)):
        made = lm.psf(pupil, SIDES, PIXEL, method=method, center=CENTER, normalize="strehl", dtype=np.float64)
        assert np.abs(made.values - exact).max() <= 2e-3 * exact.max()
