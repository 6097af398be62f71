"""Shapes and their combinations, segments, spiders, vignetting, and the pupils that have them."""

from __future__ import annotations

import copy
import itertools
import json
import math
import pickle

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lommel import CatEye, Disc, Ellipse, Mask, Polygon, Pupil, Segments, Spider, Wavefront
from lommel.optics.aperture.mask import cell_centers
from lommel.optics.aperture.opening import Opening
from lommel.optics.aperture.shapes import Combined, disk_overlap, shape_from_dict

GRID = np.meshgrid(np.linspace(-1.1, 1.1, 45), np.linspace(-1.1, 1.1, 47))
MASK = Mask.sample(lambda x, y: np.clip(0.2 + x * x + 0.5 * y, 0, 1), side=12)
SHAPES = {
    "spider": {"spider": Spider.equal(3, 0.1, 0.2)},
    "ellipse": {"vignetting": Ellipse(0.9, 0.5, 0.3)},
    "cat-eye": {"vignetting": CatEye((0.5, -0.2), 0.8)},
    "mask": {"mask": MASK},
    "stop": {"stop": (Polygon.regular(6, 0.9) | Disc(0.3, (0.5, 0.5))) - Ellipse(0.4, 0.2, 0.3, (-0.2, 0.1))},
    "segments": {"stop": Segments.hexagonal(1, 0.05).phased(0.5, tip=[0, 1, 2, 3, 4, 5])},
    "all": {"spider": Spider(0.05, [1.0]), "vignetting": CatEye((0.1, 0.3)), "mask": MASK, "obscuration": 0.2},
}
SHAPED = pytest.mark.parametrize("shape", SHAPES.values(), ids=list(SHAPES))


def test_a_vane_runs_from_the_axis_in_its_direction_only():
    pupil = Pupil(spider=Spider(0.2, [math.pi / 2]))
    x, y = np.array([0.0, 0.0, 0.09, 0.11, 0.5]), np.array([0.5, -0.5, 0.5, 0.5, 0.0])
    assert pupil.values(x, y)[0].tolist() == [0, 1, 0, 1, 1]


def test_equal_vanes_are_at_equal_angles():
    assert Spider.equal(3, 0.1, 0.5).angles == pytest.approx([0.5, 0.5 + 2 * math.pi / 3, 0.5 + 4 * math.pi / 3])


def test_the_angle_of_an_ellipse_runs_from_columns_to_rows():
    pupil = Pupil(vignetting=Ellipse(0.9, 0.3, math.pi / 4))
    assert pupil.values([0.6, 0.6], [0.6, -0.6])[0].tolist() == [1, 0]


def test_a_cat_eye_is_clear_where_both_circles_are():
    x, y = GRID
    clear = Pupil(vignetting=CatEye((0.5, -0.2), 0.8)).values(x, y)[0] != 0
    assert np.array_equal(clear, (np.hypot(x, y) <= 1) & (np.hypot(x - 0.5, y + 0.2) <= 0.8))


@SHAPED
def test_the_pupil_function_is_the_product_of_all_that_is_in_the_way(shape):
    x, y = GRID
    wavefront = Wavefront(2.0, nonradial={(3, 1): 1.0})
    pupil = Pupil(wavefront, apodization=0.7, **shape)
    expected = Pupil(wavefront, apodization=0.7, obscuration=pupil.obscuration).values(x, y)
    for name, part in shape.items():
        if name == "mask":
            expected = expected * part.at(x, y)
        elif name == "stop":
            expected = expected * (part.margin(x, y) >= 0)
            if isinstance(part, Segments):
                expected = expected * np.exp(1j * pupil.opening.phase(x, y))
        elif name != "obscuration":
            expected = expected * (part.margin(x, y) <= 0 if name == "spider" else part.margin(x, y) >= 0)
    assert pupil.values(x, y) == pytest.approx(expected, abs=1e-15)


@SHAPED
@pytest.mark.parametrize("g", [0.0, 1.3])
def test_area_amplitude_and_transmission_are_integrals_of_the_pupil_function(shape, g):
    # The mask has 12 x 12 cells: the fine lattice has its cells in them.
    n = 600
    at = cell_centers(n)
    amplitude = np.abs(Pupil(Wavefront(2.0), apodization=g, **shape).values(at[None, :], at[:, None])[0])
    bare = np.abs(Pupil(**shape).values(at[None, :], at[:, None])[0])
    pupil = Pupil(Wavefront(2.0), apodization=g, **shape)
    cell = 4 / (math.pi * n * n)
    # A mask takes the apodization at the middle of its cells.
    abs_ = 4e-3 if "mask" in shape and g else 6e-4
    assert pupil.area == pytest.approx(bare.sum() * cell, abs=6e-4)
    assert pupil.amplitude == pytest.approx(amplitude.sum() * cell, abs=abs_)
    if "mask" in shape:
        # The pupil function of a mask is constant on a cell: one that the rim crosses has its mean.
        amplitude = np.repeat(np.repeat(amplitude.reshape(12, 50, 12, 50).mean(axis=(1, 3)), 50, axis=0), 50, axis=1)
    assert pupil.transmission == pytest.approx((amplitude**2).sum() * cell, abs=abs_)


@SHAPED
def test_a_shaped_pupil_survives_json_pickling_copies_and_indexing(shape):
    pupil = Pupil(Wavefront([1.0, 2.0]), wavelength=5e-7, f_number=8.0, **shape)
    assert Pupil.from_dict(json.loads(json.dumps(pupil.to_dict(), allow_nan=False))) == pupil
    assert pickle.loads(pickle.dumps(pupil)) == copy.deepcopy(pupil) == pupil
    assert hash(copy.deepcopy(pupil).opening) == hash(pupil.opening)
    assert pupil != Pupil(pupil.wavefront, wavelength=5e-7, f_number=8.0)
    assert pupil[1] == Pupil(Wavefront(2.0), wavelength=5e-7, f_number=8.0, **shape)
    ideal = pupil.unaberrated()
    assert (ideal.spider, ideal.vignetting, ideal.mask) == (pupil.spider, pupil.vignetting, pupil.mask)
    assert ideal.wavefront == Wavefront()


def test_rays_that_are_stopped_do_not_widen_the_blur():
    # |grad Phi| = 4 C_d rho; the ellipse reaches 0.8 at most, the cat's eye 0.3.
    for vignetting, farthest in ((Ellipse(0.8, 0.4, 0.3), 0.8), (CatEye((0.1, 0.0), 0.2), 0.3)):
        pupil = Pupil(Wavefront(10.0), vignetting=vignetting)
        assert pupil.geometric_radius() == pytest.approx(40.0 * farthest / math.pi, rel=2e-3)
    mask = Mask.sample(lambda x, y: np.hypot(x, y) < 0.5, 200)
    assert Pupil(Wavefront(10.0), mask=mask).geometric_radius() == pytest.approx(20.0 / math.pi, rel=0.03)
    assert Pupil(mask=mask).geometric_radius() == 0.0
    one = np.zeros((64, 64))
    one[33, 36] = 1.0
    expected = 40.0 * math.hypot(9, 3) / 64 / math.pi
    assert Pupil(Wavefront(10.0), mask=Mask(one)).geometric_radius() == pytest.approx(expected, rel=0.12)


def test_angles_stay_within_two_turns_when_a_shape_is_turned():
    assert Spider.equal(4, 0.1, first=6.0).angles[1] == pytest.approx(6.0 + 0.5 * math.pi)
    assert Spider.equal(4, 0.1, first=12.0).angles[3] == pytest.approx(12.0 - 0.5 * math.pi)
    assert Spider(0.1, (6.0,)).turned(6.0).angles == pytest.approx((12.0 - 2.0 * math.pi,))
    assert Ellipse(0.5, 0.4, 6.0).turned(6.0).angle == pytest.approx(12.0 - 2.0 * math.pi)


@pytest.mark.parametrize(
    ("make", "error", "message"),
    [
        (lambda: Spider.equal(4, 0.1, first=45), ValueError,
         r"first must be in radians and within two turns, 4 pi, got 45; for degrees give math.radians\(45\)"),
        (lambda: Spider(0.1, (0, 90, 180)), ValueError, r"angles must be .* give math.radians\(90\)"),
        (lambda: Pupil(spider=Spider.equal(2, 1.999), obscuration=0.1, vignetting=Ellipse(0.5, 0.5)), ValueError,
         "spider, vignetting must leave part of the aperture clear, got spider=.* obscuration=0.1"),
    ],
)  # fmt: skip
def test_what_is_no_aperture_is_refused_with_the_argument_and_what_is_allowed(make, error, message):
    with pytest.raises(error, match=message):
        make()


numbers = st.floats(-1.2, 1.2)
points = st.tuples(numbers, numbers)
convex = (
    st.builds(Disc, st.floats(1e-3, 2.0), points)
    | st.builds(Ellipse, st.floats(1e-3, 3.0), st.floats(1e-3, 3.0), st.floats(-4, 4), points)
    | st.builds(Polygon.regular, st.integers(3, 9), st.floats(1e-3, 1.5), points, st.floats(-4, 4))
    | st.builds(Polygon.half_plane, st.floats(-4, 4), st.floats(-1, 1))
    | st.builds(Spider.equal, st.integers(1, 5), st.floats(1e-3, 0.5), st.floats(-3, 3))
    | st.builds(CatEye, points, st.floats(0.8, 2.0))
)
shapes = st.recursive(convex, lambda part: st.builds(Combined, st.sampled_from("|&-"), part, part), max_leaves=6)


def inside(shape, x, y):
    """Whether points lie in a shape, by the definition of each kind."""
    if isinstance(shape, Combined):
        first, second = inside(shape.first, x, y), inside(shape.second, x, y)
        return {"|": first | second, "&": first & second, "-": first & ~second}[shape.kind]
    if isinstance(shape, CatEye):
        shape = shape.disc
    if isinstance(shape, Disc):
        return (x - shape.center[0]) ** 2 + (y - shape.center[1]) ** 2 < shape.radius**2
    if isinstance(shape, Ellipse):
        z = (x - shape.center[0] + 1j * (y - shape.center[1])) * np.exp(-1j * shape.angle)
        return (z.real / shape.a) ** 2 + (z.imag / shape.b) ** 2 < 1
    if isinstance(shape, Spider):
        along = [(x + 1j * y) * np.exp(-1j * angle) for angle in shape.angles]
        return np.any([(np.abs(z.imag) < shape.width / 2) & (z.real > 0) for z in along], axis=0)
    corners = np.array(shape.corners) @ [1, 1j]
    sides = np.roll(corners, -1) - corners
    return np.all([((x + 1j * y - p) * np.conj(d)).imag > 0 for p, d in zip(corners, sides, strict=True)], axis=0)


@given(shapes, st.floats(0, 7), st.integers(0, 2**32 - 1))
def test_margin_is_a_lower_bound_on_the_distance_from_the_edge(shape, turn, seed):
    x, y = np.random.default_rng(seed).uniform(-1.3, 1.3, (2, 40))
    margin, clear = shape.margin(x, y), inside(shape, x, y)
    assert np.array_equal((margin > 0)[np.abs(margin) > 1e-12], clear[np.abs(margin) > 1e-12])
    # Nothing changes within the margin of a point.
    for part in (0.3, 0.999):
        there = inside(shape, x + part * margin * math.cos(turn), y + part * margin * math.sin(turn))
        assert np.array_equal(there[np.abs(margin) > 1e-9], clear[np.abs(margin) > 1e-9])


@given(shapes, st.floats(-4, 4), st.integers(0, 2**32 - 1))
def test_what_is_turned_or_written_is_the_same_shape(shape, angle, seed):
    x, y = np.random.default_rng(seed).uniform(-1.3, 1.3, (2, 40))
    here = shape.margin(x, y)
    assert shape_from_dict(json.loads(json.dumps(shape.to_dict()))) == shape
    c, s = math.cos(angle), math.sin(angle)
    assert shape.turned(angle).margin(c * x - s * y, s * x + c * y) == pytest.approx(here, abs=1e-11)


def test_operators_make_unions_intersections_and_differences():
    a, b = Disc(0.5), Polygon.regular(4, 0.6)
    for made, kind in ((a | b, "|"), (a & b, "&"), (a - b, "-")):
        assert made == Combined(kind, a, b)
    with pytest.raises(TypeError, match="other must be a shape"):
        a | 3


def test_a_strip_a_half_plane_and_a_regular_polygon_are_where_they_should_be():
    strip = Polygon.strip((0.0, 0.0), (0.0, 0.5), 0.2)
    assert strip.margin(np.array([0.05, 0.2, 0.0]), np.array([0.25, 0.25, 0.6])) == pytest.approx([0.05, -0.1, -0.1])
    half = Polygon.half_plane(math.pi / 2, 0.25)
    assert half.margin(np.array([0.3, 0.3]), np.array([0.2, 0.3])) == pytest.approx([0.05, -0.05])
    assert np.hypot(
        *np.array(Polygon.regular(5, 0.7, (0.1, 0.2)).corners).T - np.array([[0.1], [0.2]])
    ) == pytest.approx(0.7)
    clockwise = Polygon(((0, 0), (0, 1), (1, 0)))
    assert clockwise.margin(np.array(0.2), np.array(0.3)) == pytest.approx(0.2)


def test_segments_may_overlap_by_rounding_and_no_more():
    def pair(common):
        left = Polygon(((-0.2, -0.2), (common, -0.2), (common, 0.2), (-0.2, 0.2)))
        return Segments((left, Polygon(((0.0, -0.2), (0.2, -0.2), (0.2, 0.2), (0.0, 0.2)))))

    assert Pupil(stop=pair(1e-11)).area == pytest.approx(0.16 / math.pi, rel=1e-9)
    with pytest.raises(ValueError, match=r"segments must not overlap, .* with an area of 4e-09 in common"):
        Pupil(stop=pair(1e-8))


@pytest.mark.parametrize(("rings", "count"), [(1, 6), (2, 18), (3, 36)])
@pytest.mark.parametrize("gap", [0.0, 0.02])
def test_hexagonal_segments_reach_the_rim_and_leave_the_gap(rings, count, gap):
    segments = Segments.hexagonal(rings, gap, angle=0.3)
    corners = np.concatenate([part.corners for part in segments.shapes])
    assert len(segments.shapes) == count
    assert np.hypot(*corners.T).max() == pytest.approx(1.0, abs=1e-12)
    apart = np.abs(segments.centers[:, None] - segments.centers).reshape(-1, 2)
    pitch = np.sort(np.hypot(*apart.T))[count]
    across = 2 * math.sqrt(0.75) * np.hypot(*(np.array(segments.shapes[0].corners[0]) - segments.centers[0]))
    assert pitch - across == pytest.approx(gap, abs=1e-12)
    area = count * math.sqrt(0.75) * across**2 / math.pi
    assert Pupil(stop=segments).area == pytest.approx(area, rel=1e-12)
    assert len(Segments.hexagonal(rings, gap, middle=True).shapes) == count + 1


def test_segments_have_phases_about_their_centres():
    segments = Segments(
        (Polygon.regular(6, 0.3, (0.5, 0.1)), Disc(0.3, (-0.5, 0.0))),
        piston=(0.4, 0.0),
        tip=(2.0, 0.0),
        tilt=(0.0, 3.0),
    )
    x, y = np.array([0.5, 0.6, -0.5, -0.5]), np.array([0.1, 0.1, 0.0, 0.1])
    assert np.angle(Pupil(stop=segments).values(x, y)[0]) == pytest.approx([0.4, 0.6, 0.0, 0.3])
    assert Pupil(stop=segments).unaberrated().values(x, y)[0].tolist() == [1, 1, 1, 1]
    red = Pupil(stop=segments, wavelength=5e-7, f_number=8.0).in_light(1e-6)
    assert np.angle(red.values(x, y)[0]) == pytest.approx([0.2, 0.3, 0.0, 0.15])
    assert segments.phased(segments.piston, segments.tip, segments.tilt) == segments
    assert shape_from_dict(json.loads(json.dumps(segments.to_dict()))) == segments
    # Rays are turned by 3 radians a radius at most, over pi.
    assert Pupil(stop=segments).geometric_radius() == pytest.approx(3.0 / math.pi)


@pytest.mark.parametrize(
    ("make", "error", "message"),
    [
        (lambda: Polygon(((0, 0), (1, 1), (1, 0), (0, 1))), ValueError, "must be the corners of a convex"),
        (lambda: Polygon(tuple((math.cos(4 * k), math.sin(4 * k)) for k in range(5))), ValueError, "convex polygon"),
        (lambda: Pupil(stop=Segments((Disc(0.5), Disc(0.5, (0.8, 0))))), ValueError, "segments must not overlap"),
        (lambda: Pupil(stop=Disc(0.3), obscuration=0.4), ValueError, "stop must leave part of the aperture clear"),
    ],
)  # fmt: skip
def test_what_is_no_shape_is_refused_with_what_was_given(make, error, message):
    with pytest.raises(error, match=message):
        make()


def dented(
    d,
):  # inwards, at a corner between sides of 1.5 and 0.5: turns of -2 d, with a rounding of 1e-12 times both
    return ((-1.0, 0.0), (0.5, d), (1.0, 0.0), (1.0, 2.0), (-1.0, 2.0))


@pytest.mark.parametrize(
    ("corners", "limit"),
    [
        (dented, 0.375e-12),
        (lambda d: dented(d)[::-1], 0.375e-12),
        (lambda d: ((0.0, 0.0), (1.0, 0.0), (2.0, 1e-24 / d)), 1e-12),  # on a line up to the rounding
        (lambda d: ((0.0, 0.0), (1e-24 / d, 0.0), (1.0, 1.0)), 1e-12),  # two that are one up to the rounding
    ],
)
def test_corners_are_those_of_a_convex_polygon_up_to_rounding(corners, limit):
    assert len(Polygon(corners(0.999 * limit)).corners) in (3, 5)
    assert len(Polygon(dented(0.0)).corners) == 5
    for wrong in (corners(1.001 * limit), ((0.0, 0.0), (1.0, 0.0), (2.0, 0.0))):
        with pytest.raises(ValueError, match="corners of a convex polygon, not on a line"):
            Polygon(wrong)


@pytest.mark.parametrize("offset", [-2.0, 2.0])
def test_a_half_plane_may_begin_two_radii_from_the_axis(offset):
    x, y = np.array([offset - 0.01, offset + 0.01]), np.array([[-1.0], [0.0], [1.0]])
    assert np.all((Polygon.half_plane(0.0, offset).margin(x, y) > 0.0) == [True, False])
    with pytest.raises(ValueError, match="offset must be"):
        Polygon.half_plane(0.0, 1.001 * offset)


def test_parts_wholly_beyond_the_rim_are_refused():
    metres = Disc(0.3, (1.8, 0.0))
    words = (
        r"must be made of parts that reach the aperture, got Disc\(radius=0.3, center=\(1.8, 0.0\)\) wholly beyond"
    )
    for stop in (Disc() - metres, Disc(0.5) | metres, Disc() - (Disc(0.2) | metres)):
        with pytest.raises(ValueError, match=f"stop {words} its rim; lengths are divided by the radius"):
            Pupil(stop=stop)
    with pytest.raises(ValueError, match=f"other {words}"):
        Segments.hexagonal(2) - metres
    # Parts that hold little more than the aperture, or touch it between the points of their outline, are taken.
    corner = Polygon(((0.9999, -3.0), (30.0, -3.0), (30.0, 40.0), (0.9999, 40.0)))
    for part in (Disc(1.5), Disc(0.3, (1.2999, 0.0)), Polygon.strip((-9.0, 0.0), (9.0, 0.0), 3.0), corner):
        assert Pupil(stop=Disc(0.5) | part).area > 0.25
    assert Pupil(stop=Disc()).area == Pupil(stop=Disc(1.2)).area == pytest.approx(1.0)


def test_parts_far_around_the_aperture_are_refused():
    metres = Disc(3.3)
    got = r"got Disc\(radius=3.3, center=\(0.0, 0.0\)\)"
    words = f"edges across the aperture or near its rim, {got} far around all of it;"
    for stop in (
        metres,
        metres - Disc(0.5),
        Disc(0.5) | metres,
        Polygon.strip((-0.5, 0.0), (0.5, 0.0), 0.1) & metres,
    ):
        with pytest.raises(ValueError, match=f"stop must be made of parts with {words} lengths are divided"):
            Pupil(stop=stop)
    with pytest.raises(ValueError, match=f"other .* {words}"):
        Segments.hexagonal(2) - metres
    for part in (Ellipse(2.0, 1.6), Polygon.strip((-9.0, 0.0), (9.0, 0.0), 3.1), Disc(2.0, (0.0, 0.4))):
        with pytest.raises(ValueError, match="far around all of it"):
            Pupil(stop=part)
    assert Pupil(stop=Disc(2.0, (0.6, 0.0))).area == 1.0


@pytest.mark.parametrize("angle", [0.0, 0.4])
def test_hexagonal_segments_are_in_columns_of_rising_x_and_rising_y(angle):
    centers = Segments.hexagonal(3, 0.01, angle=angle).centers
    turn = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
    x, y = np.round(centers @ turn, 9).T
    assert np.lexsort((y, x)).tolist() == list(range(36))
    assert len(set(x)) == 7


def large(a, b, angle, x, y):
    """Area of an ellipse within the unit disc, by Green's theorem along the arcs between the crossings."""
    with mpmath.workdps(40):
        turn = mpmath.expj(angle)
        middle, a, b = mpmath.mpc(x, y) / turn, mpmath.mpf(a), mpmath.mpf(b)

        def square(z):
            return ((z.real - middle.real) / a) ** 2 + ((z.imag - middle.imag) / b) ** 2

        # On z = e^(i t) the square less 1 times z^2 is a polynomial of z.
        p, q = 1 / a**2, 1 / b**2
        one = -(p * middle.real - 1j * q * middle.imag)
        two = (p - q) / 4
        powers = [two, mpmath.conj(one), (p + q) / 2 + p * middle.real**2 + q * middle.imag**2 - 1, one, two]
        while powers and abs(powers[-1]) < 1e-30:
            powers = powers[1:-1]
        # Its roots are the eigenvalues of its companion matrix.
        size = max(len(powers) - 1, 0)
        companion = mpmath.zeros(size)
        for k in range(size):
            companion[k, size - 1] = -powers[k] / powers[-1]
            if k:
                companion[k, k - 1] = 1
        roots = mpmath.eig(companion, left=False, right=False) if size else []
        crossings = [z / abs(z) for z in roots if abs(abs(z) - 1) < 1e-12]
        on = [mpmath.arg(mpmath.mpc((z - middle).real / a, (z - middle).imag / b)) for z in crossings]

        def arcs(angles, at, clear, area):
            ends = sorted(angles) or [mpmath.mpf(0)]
            pairs = zip(ends, [*ends[1:], ends[0] + 2 * mpmath.pi], strict=True)
            return sum(area(s, t) for s, t in pairs if clear(at((s + t) / 2)))

        def ellipse(t):
            return middle + mpmath.mpc(a * mpmath.cos(t), b * mpmath.sin(t))

        def swept(s, t):
            step = ellipse(t) - ellipse(s)
            return (a * b * (t - s) + middle.real * step.imag - middle.imag * step.real) / 2

        total = arcs(
            [mpmath.arg(z) for z in crossings], mpmath.expj, lambda z: square(z) < 1, lambda s, t: (t - s) / 2
        )
        return float(total + arcs(on, ellipse, lambda z: abs(z) < 1, swept))


@given(
    st.floats(-3, 3),
    st.floats(-3, 3),
    st.floats(-4, 4),
    st.floats(-0.98, 0.98),
    st.floats(-4, 4),
    st.integers(0, 2**32 - 1),
)
def test_large_ellipses_have_the_rules_and_the_margins_of_others(wide, high, angle, depth, way, seed):
    # The edge passes the axis at a distance `depth`, wherever the centre is.
    a, b = 10.0**wide, 10.0**high
    t = np.random.default_rng(seed).uniform(0, 7)
    c, s = math.cos(angle), math.sin(angle)
    normal = np.array([math.cos(t) / a, math.sin(t) / b]) / math.hypot(math.cos(t) / a, math.sin(t) / b)
    at = depth * normal - np.array([a * math.cos(t), b * math.sin(t)])
    x, y = c * at[0] - s * at[1], s * at[0] + c * at[1]
    ellipse = Ellipse(a, b, angle, (x, y))
    (rule,) = Opening(stop=ellipse).rows(0, 1e-13)
    assert rule.lost < 1e-11
    assert math.pi * rule.weight == pytest.approx(large(a, b, angle, x, y), abs=1e-11)
    assert Pupil(stop=ellipse).area == pytest.approx(rule.weight, abs=2e-10)
    points = np.random.default_rng(seed).uniform(-1.0, 1.0, (2, 40))
    margin, clear = ellipse.margin(*points), inside(ellipse, *points)
    there = inside(ellipse, *(points + 0.999 * margin * np.array([[math.cos(way)], [math.sin(way)]])))
    assert np.array_equal(there[np.abs(margin) > 1e-9], clear[np.abs(margin) > 1e-9])


NODES, WEIGHTS = np.polynomial.legendre.leggauss(60)

places = st.floats(-3, 3)
radii = st.floats(0, 4)


def _rectangle(a: float, b: float, c: float, d: float) -> tuple[float, float, float, float]:
    return min(a, b), max(a, b), min(c, d), max(c, d)


@given(st.floats(0.1, 4), st.floats(0, math.pi / 2))
def test_a_half_plane_off_the_centre_cuts_a_circular_segment(radius: float, angle: float) -> None:
    """The segment of half-angle phi, beyond ``r cos phi``, is ``r^2 (phi - sin(2 phi) / 2)``."""
    area = float(disk_overlap(radius, radius * math.cos(angle), 9.0, -9.0, 9.0))
    assert area == pytest.approx(radius**2 * (angle - 0.5 * math.sin(2 * angle)), rel=0, abs=4e-15 * radius**2)


@given(radii, places, places, places, places, st.floats(0, 1), st.floats(0, 1))
def test_the_parts_of_a_rectangle_add(
    radius: float, a: float, b: float, c: float, d: float, across: float, down: float
) -> None:
    left, right, low, high = _rectangle(a, b, c, d)
    x, y = left + across * (right - left), low + down * (high - low)
    whole = disk_overlap(radius, left, right, low, high)
    parts = disk_overlap(radius, [left, x, left, x], [x, right, x, right], [low, low, y, y], [y, y, high, high])
    assert float(parts.sum()) == pytest.approx(float(whole), rel=0, abs=1e-13)


def test_it_is_the_integral_of_the_chord() -> None:
    """A rectangle that the circle enters and leaves, by quadrature of its height at each x."""
    radius, left, right, low, high = 1.3, -0.4, 1.2, -0.9, 0.75
    bends = sorted({left, right, *(s * math.sqrt(radius**2 - y**2) for s in (-1, 1) for y in (low, high))})
    total = 0.0
    for start, stop in itertools.pairwise(bends):
        if left <= start and stop <= right:
            at = start + 0.5 * (stop - start) * (1 + NODES)
            arc = np.sqrt(radius**2 - at**2)
            total += float(0.5 * (stop - start) * WEIGHTS @ (np.minimum(high, arc) - np.maximum(low, -arc)))
    assert float(disk_overlap(radius, left, right, low, high)) == pytest.approx(total, rel=0, abs=1e-12)


@pytest.mark.parametrize("radius", [10.3, 256.2, 4000.4, 11000.1])
def test_far_from_the_centre_a_pixel_is_still_cut_to_rounding(radius: float) -> None:
    """A pixel on the axis: the arc enters and leaves through its sides, ``x = sqrt(r^2 - y^2)``."""
    left = math.floor(radius) - 0.5
    y, w = 0.5 * NODES, 0.5 * WEIGHTS
    # sqrt(r^2 - y^2) - r without cancellation; the polynomial rule is exact to rounding for an arc so flat.
    sag = -(y**2) / (radius + np.sqrt(radius**2 - y**2))
    exact = float(w @ (radius - left + sag))
    assert float(disk_overlap(radius, left, left + 2.0, -0.5, 0.5)) == pytest.approx(exact, abs=1e-15 * radius**2)
