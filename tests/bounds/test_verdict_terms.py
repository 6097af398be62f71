"""What makes a verdict, a second time: its limits on both sides, standard errors by brute force."""

from __future__ import annotations

import contextlib
import math
from types import SimpleNamespace

import numpy as np
import pytest
from scipy import special

from lommel.deconvolve.iterations import Iteration
from lommel.estimation import beads, field_fit, fisher, phase_retrieval
from lommel.estimation.field_search import Outcome
from lommel.estimation.fisher import Information
from lommel.fit import goodness_of_fit, score_tests
from lommel.fit.goodness_of_fit import ExcessTest
from lommel.imaging import window_blur
from lommel.localize import checks
from lommel.microscopy import deconvolution
from lommel.recorded import camera_noise
from lommel.recorded.noise import Noise

RNG = np.random.default_rng(0)
SPREAD = math.sqrt(2.0 / 500.0)


def told(findings):
    return [(one.code, one.severity) for one in findings]


def tail(chi2, spread=SPREAD):
    """Return the probability of a larger chi2: that of a chi-squared variable of 2 / spread^2 degrees of freedom."""
    degrees = 2.0 / spread**2
    return float(special.chdtrc(degrees, degrees * chi2))


def test_plausible_chi2_are_those_that_one_fit_in_ten_thousand_is_beyond():
    high, low = (
        float(one(SPREAD))
        for one in (goodness_of_fit.largest_plausible_chi2, goodness_of_fit.smallest_plausible_chi2)
    )
    assert tail(high) == pytest.approx(1e-4, rel=1e-6)
    assert 1.0 - tail(low) == pytest.approx(1e-4, rel=1e-6)
    assert goodness_of_fit.chance(1.1, SPREAD) == pytest.approx(tail(1.1), rel=1e-9)


@pytest.mark.parametrize(
    ("probability", "expected"),
    [
        (0.9e-4, [("misfit", "error")]), (1.1e-4, [("rare_chi2", "doubt")]), (0.9e-3, [("rare_chi2", "doubt")]),
        (1.1e-3, [("rare_chi2", "note")]), (0.9e-2, [("rare_chi2", "note")]), (1.1e-2, []), (1 - 1.1e-4, []),
        (1 - 0.9e-4, [("too_quiet", "doubt")]),
    ],
)  # fmt: skip
def test_a_chi2_is_judged_by_its_probability(probability, expected):
    chi2 = float(special.gammainccinv(1.0 / SPREAD**2, probability)) * SPREAD**2
    found = goodness_of_fit.chi2_findings(chi2, SPREAD, "causes")
    assert told(found) == expected
    assert all(one.numbers["chance"] == pytest.approx(probability, rel=1e-5) for one in found)


@pytest.mark.parametrize(("share", "error", "flat", "found"), [
    (1.0, 0.19, True, True), (1.0, 0.21, True, False), (0.81, 0.1, True, True), (0.79, 0.1, True, False),
    (1.39, 0.1, True, True), (1.41, 0.1, True, False), (1.0, 0.1, False, False), (1.0, math.inf, True, False),
])  # fmt: skip
def test_excess_noise_is_found_near_one_and_by_five_standard_errors(share, error, flat, found):
    test = ExcessTest(share, error, flat)
    assert test.found == found
    assert told(test.findings(1.0)) == ([("excess_noise", "error")] if found else [])
    assert test.findings(1.01) == []
    assert test.sigmas == (0.0 if math.isinf(error) else share / error)


@pytest.mark.parametrize("dim", [1.0, 0.2])
def test_the_share_of_excess_noise_is_a_weighted_mean_of_squares(dim):
    light, read = RNG.uniform(0.5, 40.0, 4000), 2.0
    variance = light + read + light * np.where(light < 10.0, dim, 1.0)
    residual = RNG.normal(size=4000) * np.sqrt(variance)
    residual[7] = np.nan
    found = goodness_of_fit.excess_test(residual, light, read)
    kept = np.isfinite(residual) & (light / (light + read) > 0.1)
    r, m = residual[kept], light[kept]
    v = m + read
    share = ((m / v) * (r * r / v - 1.0)).sum() / ((m / v) ** 2).sum()
    error = math.sqrt((((m / v) ** 2) * (2.0 + 1.0 / v)).sum()) / ((m / v) ** 2).sum()
    assert (found.share, found.error) == (pytest.approx(share, rel=1e-9), pytest.approx(error, rel=1e-9))
    order = np.argsort(m)
    group = np.minimum((np.cumsum(m[order]) - m[order] * 1e-9) / m.sum() * 8, 7).astype(int)
    worst = 0.0
    for k in range(8):
        a, b, c = (one[order][group == k] for one in (m, v, r))
        own = ((a / b) * (c * c / b - 1.0)).sum() / ((a / b) ** 2).sum()
        off = math.sqrt((((a / b) ** 2) * (2.0 + 1.0 / b)).sum()) / ((a / b) ** 2).sum()
        worst = max(worst, abs(own - share) / (0.3 * max(share, 1.0) + 5.0 * (1.0 + max(share, 0.0)) * off))
    assert found.flat == (worst <= 1.0)


def outcome(**changes):
    fit = SimpleNamespace(quality=(1.0, SPREAD), model=SimpleNamespace(chosen=np.arange(30)))
    given = {"fit": fit, "rejected": np.arange(0), "held_out": (1.0, 0.1), "bright_chi2": (1.0, SPREAD),
    "places": np.zeros((3, 2)),
             "blur_costs": {}, "notes": [], "tests": (), "grade": None, "rival": None}  # fmt: skip
    return Outcome(**given | changes)


@pytest.mark.parametrize(("changes", "expected"), [
    ({}, []),
    ({"held_out": (1.449, 0.1)}, []), ({"held_out": (1.451, 0.1)}, [("held_out", "error")]),
    ({"rejected": np.arange(10)}, []), ({"rejected": np.arange(11)}, [("many_rejected", "error")]),
    ({"bright_chi2": (math.nan, 0.1)}, []),
    ({"bright_chi2": (0.999 * float(goodness_of_fit.largest_plausible_chi2(0.1)), 0.1)}, []),
    ({"bright_chi2": (float(goodness_of_fit.largest_plausible_chi2(0.1)), 0.1)}, [("misfit", "error")]),
])  # fmt: skip
def test_a_map_of_a_field_is_judged_by_stars_that_were_held_out_rejected_or_bright(changes, expected):
    found = outcome(**changes).findings
    assert told(found) == expected
    assert all(one.numbers["limit"] == pytest.approx(1.45) for one in found if one.code == "held_out")


@pytest.mark.parametrize(("chi2", "severity"), [(0.89, "error"), (0.9, None), (0.91, None)])
def test_images_that_are_much_too_quiet_are_an_error(chi2, severity):
    fit = SimpleNamespace(quality=(chi2, 0.01), model=SimpleNamespace(chosen=np.arange(30)))
    assert told(outcome(fit=fit).findings) == ([("too_quiet", severity)] if severity else [])


def test_a_root_of_information_is_that_of_derivatives_over_deviations_with_bounds_of_columns():
    shape, member = (4, 5), ()
    values, slope = RNG.random(shape), RNG.normal(size=shape)
    psf = SimpleNamespace(
        values=values, error_bound=1e-3, derivatives={"row": slope}, derivative_bounds={"row": 2e-3}
    )
    photons, background, read = 500.0, 3.0, RNG.uniform(1.0, 2.0, shape)
    names = ("row", "photons", "background")
    root, bounds = fisher._root(psf, member, names, photons, background, read)
    variance = photons * values + background + photons * values.max() * 1e-3 + read
    columns = np.stack(
        [(one / np.sqrt(variance)).ravel() for one in (photons * slope, values, np.ones(shape))], axis=1
    )
    assert root.T @ root == pytest.approx(columns.T @ columns, rel=1e-9, abs=1e-9)
    weight = math.sqrt((1.0 / variance).sum())
    peak, eps = values.max(), float(np.finfo(float).eps)
    rounding = 20 * 3 * fisher._EPS * np.sqrt((columns**2).sum(axis=0))
    expected = np.array([photons * peak * 2e-3, 1e-3 * peak, 0.0]) * weight + rounding
    assert bounds == pytest.approx(expected, rel=1e-9)
    assert 4 * eps >= fisher._EPS
    bare = SimpleNamespace(values=values, error_bound=None, derivatives={}, derivative_bounds={})
    unknown = fisher._root(bare, member, ("photons",), photons, background, read)[1]
    assert unknown[0] < 1e-9 * bounds[1]


@pytest.mark.parametrize(("norm", "lost"), [(0.99e-3, True), (1.01e-3, False)])
def test_a_column_within_its_error_is_nothing(norm, lost):
    found = Information.of_root(("p", "q"), dict.fromkeys("pq", ""), np.diag([norm, 2.0]), np.array([1e-3, 0.0]))
    assert found.unidentifiable == (("p",) if lost else ())
    assert found.errors["q"] == pytest.approx(0.5)


@pytest.mark.parametrize(("lowest", "expected"), [(5.01, []), (4.99, [("no_light", "error")])])
def test_a_star_is_seen_by_five_standard_errors_of_its_flux(lowest, expected):
    assert told(phase_retrieval._light_findings(np.array([40.0, 2.0 * lowest]), np.array([4.0, 2.0]))) == expected


@pytest.mark.parametrize(("rms", "image", "moved", "expected"), [
    (0.219, 1.99e-3, 0.0, []), (0.221, 1e-9, 0.0, [("too_dim", "doubt")]),
    (0.1, 2e-3, 1.01, [("model_error", "doubt")]), (0.1, 2e-3, 0.99, [("model_error", "note")]),
    (0.1, math.inf, math.inf, [("model_error", "doubt")]),
])  # fmt: skip
def test_beads_are_too_dim_where_images_are_not_linear(rms, image, moved, expected):
    found = beads._error_findings(np.diag([0.5, 0.5]) * rms**2, image, ("NA", moved))
    assert told(found) == expected
    assert [one.text.startswith("aberrations are too strong") for one in found] == [math.isinf(image)] * len(found)


@pytest.mark.parametrize("one_focus", [False, True])
@pytest.mark.parametrize("side", [0.99, 1.01])
def test_fields_are_too_dim_by_the_mean_square_over_stars(one_focus, side):
    basis = RNG.normal(size=(5, 2))
    directions, squares = RNG.normal(size=(3, 4)), RNG.uniform(0.5, 1.0, 4)
    root = RNG.normal(size=(6, 6))
    covariance = root @ root.T
    total = 0.0
    for star in basis:
        for point, weight in zip(directions.T, squares, strict=True):
            vector = np.kron(point, star)
            total += weight * vector @ covariance @ vector
    rms = math.sqrt(total / len(basis))
    limit = 0.22 / (math.sqrt(2.0) if one_focus else 1.0)
    stars = SimpleNamespace(first_star=SimpleNamespace(one_focus=one_focus))
    search = SimpleNamespace(metric=directions * squares @ directions.T, stars=stars)
    fit = SimpleNamespace(model=SimpleNamespace(basis=basis))
    found = field_fit._too_dim_findings(search, fit, covariance * (side * limit / rms) ** 2)
    assert told(found) == ([("too_dim", "doubt")] if side > 1.0 else [])
    assert all(one.numbers["rms"] == pytest.approx(side * limit, rel=1e-9) for one in found)


@pytest.mark.parametrize(
    ("scale", "tested", "expected"), [(3.0, None, True), (3.0, 3.1, True), (3.0, 3.0, False), (1e-3, None, False)]
)
def test_a_stated_number_is_untested_where_its_error_moves_a_result_and_is_not_seen(scale, tested, expected):
    information = np.array([[4.0, 0.5, 1.0], [0.5, 9.0, 2.0], [1.0, 2.0, 3.0]])
    number = SimpleNamespace(name="depth", scale=scale, columns=[2])
    tests = [] if tested is None else [SimpleNamespace(name="depth", errors=np.array([tested]))]
    found = score_tests.untested(information, [0, 1], {"a": 0, "b": 1}, [number], tests)
    square = information[:2, :2]
    moved = np.abs(scale * np.linalg.solve(square, information[:2, 2])) / np.sqrt(np.diag(np.linalg.inv(square)))
    seen = tested is not None and tested <= scale
    name = "ab"[int(moved.argmax())]
    assert bool(found) == expected == (not seen and moved.max() > 1.0)
    assert found == (
        {"depth": (name, pytest.approx(np.abs(scale * np.linalg.solve(square, information[:2, 2]))[moved.argmax()]))}
        if expected
        else {}
    )


def test_molecules_fit_where_the_median_discrepancy_is_small_or_within_four_standard_errors():
    kind = next(one for one in vars(checks).values() if isinstance(one, type) and "_fit_findings" in vars(one))
    for count, median, expected in (
        (1000, 0.29, []), (1000, 0.31, [("misfit", "doubt")]), (1000, 0.99, [("misfit", "doubt")]),
        (1000, 1.0, [("misfit", "doubt")]), (1000, 1.01, [("misfit", "error")]),
        (1000, -0.29, []), (1000, -0.31, [("too_quiet", "doubt")]), (50, 0.7, []), (50, 0.72, [("misfit", "doubt")]),
        (50, -0.7, []),
        (50, -0.72, [("too_quiet", "doubt")]),
    ):  # fmt: skip
        made = SimpleNamespace(
            _sums={"spots": 2000, "doubtful": 0, "far": 0, "kept": count}, molecules=count, median=median,
            _is_dense=False, _is_structured=False, _is_explained=False,
        )  # fmt: skip
        findings = []
        with contextlib.suppress(AttributeError, KeyError):  # what comes after the median is of other sums
            findings.extend(kind._fit_findings(made))
        assert told(findings)[:1] == expected, (count, median)


@pytest.mark.parametrize("tilted", [False, True])
def test_the_slope_of_backgrounds_is_the_more_significant_of_two_tests(tilted):
    count = 60
    tilts = (vars(one).get("tilt") for one in vars(checks).values() if isinstance(one, type))
    tilt = next(one for one in tilts if one and "shape" in one.__code__.co_varnames[: one.__code__.co_argcount])
    row, column = RNG.uniform(0, 64, count), RNG.uniform(0, 64, count)
    information = np.zeros((count, 4, 4))
    information[:, :2, :2] = np.eye(2) * RNG.uniform(1.0, 2.0, (count, 1, 1)) + 0.2
    truth = np.array([0.9, -0.1]) if tilted else np.zeros(2)
    slope = np.einsum("nij,j->ni", information[:, :2, :2], truth) + 0.3 * RNG.normal(size=(count, 2))
    made = SimpleNamespace(row=row, column=column, slope=np.pad(slope, ((0, 0), (0, 2))), information=information)
    found = tilt(made, (64, 64))
    candidates = []
    cell = [4 * min(int(r // 16), 3) + min(int(c // 16), 3) for r, c in zip(row, column, strict=True)]
    for groups in ([range(count)], [[i for i in range(count) if cell[i] == k] for k in sorted(set(cell))]):
        total, best = 0.0, (0.0, 0.0, 0.0)
        for members in groups:
            members = list(members)
            matrix, vector = information[members, :2, :2].sum(axis=0), slope[members].sum(axis=0)
            size, error = np.linalg.solve(matrix, vector), np.sqrt(np.diag(np.linalg.inv(matrix)))
            total += vector @ size
            for s, e in zip(size, error, strict=True):
                best = max(best, (abs(s) / e, abs(s), e))
        candidates.append((float(special.chdtrc(2 * len(groups), total)), best[1], best[2]))
    chance, size, error = min(candidates)
    assert found == pytest.approx((-float(special.ndtri(max(0.5 * chance, 1e-300))), size, error), rel=1e-9)


@pytest.mark.parametrize(
    ("change", "noise", "expected"),
    [
        (0.099, 0.0, []),
        (0.101, 0.0, [("plane_light", "doubt")]),
        (-0.101, 0.0, [("plane_light", "doubt")]),
        (0.2, 8.0, []),
    ],
)
@pytest.mark.parametrize("reverse", [False, True])
def test_the_light_of_planes_rises_or_falls_by_a_tenth_or_not(change, noise, expected, reverse):
    z = np.linspace(-0.5, 0.5, 9)
    light = 100.0 * (1.0 + change * z) + noise * np.array([1, -1, 1, -1, 0, 1, -1, 1, -1])
    stack = 5.0 + 20.0 + light[:, None, None] * np.ones((9, 4, 4))
    found = deconvolution.plane_light_findings(stack, Noise(read=1.0, offset=5.0), 20.0, reverse=reverse)
    design = np.stack([np.ones(9), z, z * z - (z * z).mean()], axis=1)
    (mean, slope, _), misfit = np.linalg.lstsq(design, light, rcond=None)[:2]
    error = math.sqrt(float(misfit[0]) / 6.0 / (z * z).sum()) if noise else 0.0
    least = max(0.1 * mean, 0.01 * (mean + 20.0), 3.0 * error)
    assert bool(found) == bool(expected) == (abs(slope) >= least)
    if found:
        assert found[0].numbers["change"] == pytest.approx((-slope if reverse else slope) / mean, rel=1e-6)


@pytest.mark.parametrize("fading", [False, True])
def test_light_of_planes_falls_in_all_parts_of_the_field_or_crosses_its_edges(fading):
    z, light = np.linspace(-0.5, 0.5, 9), np.full((8, 8), 100.0)
    slopes = np.full((8, 8), -0.3)
    if not fading:  # the same light in all, lost at one edge
        slopes[:, 2:], slopes[:, :2] = 0.0, -1.2
    stack = light * (1.0 + slopes * z[:, None, None])
    found = deconvolution.plane_light_findings(stack, Noise(read=1.0), 0.0)
    assert told(found) == ([("plane_light", "note")] if fading else [])


@pytest.mark.parametrize(("missing", "expected"), [(0.019, []), (0.021, [("plane_light", "note")])])
def test_light_of_planes_is_not_judged_where_bright_pixels_are_unknown_in_some(missing, expected):
    stack = np.full((9, 10, 10), 100.0)
    stack[3, 0, 0] = 1e4
    bright = 100.0 * 900 * missing / (1.0 - missing) / 8.0
    stack[:3, 0, 0] = stack[4:, 0, 0] = bright - 0.0
    found = deconvolution.plane_light_findings(stack, Noise(read=1.0), 0.0, 9e3)
    rest = stack.copy()
    rest[3, 0, 0] = 0.0
    assert told(found) == ([("plane_light", "note")] if rest[:, 0, 0].sum() / rest.sum() > 0.02 else [])
    assert bool(found) == bool(expected) or abs(missing - 0.02) < 2e-3


@pytest.mark.parametrize(("target", "discrepancy", "history", "settled"), [
    (1.0, 1.04, [2.0, 1.5, 0.99], True), (1.0, 1.06, [2.0, 1.5, 0.99], False), (0.9, 0.91, [2.0, 1.0, 0.5], False),
    (0.9, 0.9, [2.0, 1.0, 0.9], True), (0.0, 0.0, [0.0], False), (1.0, 1.0, [3.0, 2.0, 1.96], True),
    (1.0, 1.0, [3.0, 2.0, 1.94], False),
    (1.0, 1.0, [3.0, 2.5, 2.0, 1.9, 1.8], False), (1.2, 1.19, [3.0], False),
])  # fmt: skip
def test_iterations_end_once_all_and_the_specimen_have_settled(target, discrepancy, history, settled):
    """The slack of all voxels is 0.05, that of the specimen 0.05: two steps against the first half of them."""
    made = SimpleNamespace(
        _counted=SimpleNamespace(slack=0.05, of_specimen=(history[-1], 0.05)), _specimen_discrepancies=history
    )
    expected = target != 0.0 and discrepancy <= (max(target, 1.05) if target >= 1.0 else target)
    expected = expected and (history[-1] <= target or history[(len(history) - 1) // 2] - history[-1] < 0.05)
    assert Iteration._specimen_settled(made, discrepancy, target) == expected
    assert expected == settled or len(history) == 1


class Ramp:
    """Nodes whose weights are cubics of the place."""

    def weights(self, places):
        t = np.asarray(places)
        return np.stack([1.0 - t**3, t**3], axis=1)


@pytest.mark.parametrize("allowed", [1e-2, 1e-4])
def test_parabolas_in_tiles_are_off_by_less_than_is_allowed(allowed):
    x = np.linspace(0.0, 1.0, 50)
    windows = RNG.random((2, 2, 3, 3, 3))
    weights = Ramp().weights(x)
    tile, nodes, points, error = window_blur._parabolas(weights, Ramp(), x, slice(0, 2), windows, allowed)
    made = np.stack([sum(points[k, j] * nodes[2 * tile[k] + j] for j in range(3)) for k in range(50)])
    off = np.tensordot(weights - made, windows, axes=(1, 1))
    exact = np.abs(off).sum(axis=(-2, -1)).max()
    assert exact <= error * (1.0 + 1e-9) <= allowed
    assert error == pytest.approx(exact, rel=1e-6)
    count = tile.max() + 1
    # The cubic of one tile, from the error of parabolas: (1 / tiles)^3.
    assert count <= 2 + math.ceil(
        2.0 * (np.abs(windows[:, 1] - windows[:, 0]).sum(axis=(-2, -1)).max() * 0.0481 / allowed) ** (1 / 3)
    )


@pytest.mark.parametrize("rise", [0.5, 2.0])
def test_a_photon_transfer_curve_is_the_line_of_weighted_squares(rise):
    light = np.linspace(0.0, 100.0, 4000)
    squares = (3.0 + rise * light) * RNG.normal(size=4000) ** 2
    constant, slope, error = camera_noise._fit_line(light, squares)
    variance = constant + slope * light
    weight = (squares < camera_noise._STRUCTURE * variance) / variance**2
    matrix = np.linalg.inv(np.array([[weight.sum(), weight @ light], [weight @ light, weight @ light**2]]))
    assert np.array([constant, slope]) == pytest.approx(
        matrix @ [weight @ squares, weight @ (light * squares)], rel=1e-4
    )
    assert error == pytest.approx(math.sqrt(2.0 * matrix[1, 1]), rel=1e-4)
    noise, relative = camera_noise._fit_noise(light + 7.0, squares, 0.25, 1.5)
    assert relative == pytest.approx(2.0 * error / slope, rel=1e-2)
    assert noise.white == pytest.approx(1.0 / slope, rel=1e-2)
    assert noise.offset == pytest.approx(
        min(7.0 + light[4] - constant / slope + 1.5**2 * slope, 7.0 + light[4]), abs=0.3
    )
    with pytest.raises(ValueError, match="cannot be estimated"):
        camera_noise._fit_noise(light + 7.0, squares, 0.9 * (error / slope / 0.3) ** 2, 1.5)
    camera_noise._fit_noise(light + 7.0, squares, 1.2 * (error / slope / 0.3) ** 2, 1.5)
