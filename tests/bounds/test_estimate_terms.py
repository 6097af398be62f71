"""Errors, limits and verdicts of estimates of wavefronts, fields, distortion and depth, a second time."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace as Made

import numpy as np
import pytest
from scipy import interpolate, ndimage, special

import lommel as lm
import searches
from lommel.estimation import (
    cosmic_rays,
    depth_precision,
    distortion,
    field_fit,
    field_search,
    field_stars,
    fisher,  # fmt: skip
    phase_retrieval,
    star_checks,
    star_images,
)
from lommel.estimation.field_fit import FieldFit
from lommel.estimation.fisher import Information
from lommel.fit import Finding
from lommel.fit.goodness_of_fit import largest_plausible_chi2
from lommel.fit.score_tests import Grade, Marginal
from lommel.fit.scoring import Scores

_ = interpolate, ndimage  # whose first import is no cost of a test
RNG, TURN = np.random.default_rng(0), 2.0 * math.pi
SURE, LIMIT = (float(largest_plausible_chi2(0.1, chance)) for chance in (1e-3, 1e-4))


def test_coma_and_focus_have_errors_of_first_order_and_blurs_those_of_their_widths():
    values, errors = np.array([0.3, -0.4, 0.2]), np.array([0.01, 0.02, 0.05])
    lens = Made(wavelength=5e-7, f_number=4.0, wavefront=lm.Wavefront())
    fit = Made(names=((2, 0), (3, -1), (3, 1)), at=lambda *_: (values, errors), middle=(0.0, 0.0), _pupil=lens)
    fit._index = lambda term: FieldFit._index(fit, term)
    changes = [np.hypot(*(values[1:] + h)) - np.hypot(*(values[1:] - h)) for h in 1e-6 * np.diag(errors[1:])]
    coma = FieldFit.coma.fget(fit)
    assert (coma[0], coma[1]) == pytest.approx((np.hypot(-0.4, 0.2), np.hypot(*changes) / 2e-6), rel=1e-6)
    for fit._defocus, fit.twin in (((0.7,), 1), ((0.7,), None), ((0.0,), 1), ((0.0,), None)):
        metres, focus = 8.0 * 5e-7 * 16.0 / math.pi, FieldFit.focus.fget(fit)
        expected = metres * (fit._defocus[0] + math.sqrt(3.0) * 0.3), metres * math.sqrt(3.0) * 0.01
        assert tuple(focus)[:2] == pytest.approx(expected, rel=1e-9)
        assert tuple(focus)[2] == (fit.twin == 1 and fit._defocus == (0.0,))
    values[:] = 0.0
    assert FieldFit.coma.fget(fit)[1] == 0.0
    pupil = Made(wavelength=None, scale=2.0, geometry=None)
    stars = Made(pupil=pupil, pixel=0.25, blur=Made(names=("seeing", "Gaussian"), outer=None))
    squares, of_squares = np.array([[0.49, 0.0], [0.04, 0.25]]), np.array([[0.07, 4e-4], [0.01, 0.02]])
    found = field_fit._estimated_blurs(stars, (), squares, of_squares, np.array([0.1, 0.2]))
    for k, (width, gaussian) in enumerate(((0.7, 0.02), (0.2, 0.02))):
        r0 = found[k][0][0].r0
        assert found[k][0][1] == pytest.approx(r0 * math.hypot(of_squares[k, 0] / (2.0 * width**2), [0.1, 0.2][k]))
        assert found[k][1][1] == pytest.approx(0.5 * gaussian)
        assert found[k][1][0].sigma == pytest.approx(0.5 * math.sqrt(squares[k, 1]))


def test_tables_and_plots_of_fields_have_standard_errors_in_waves(monkeypatch, tmp_path):
    lens, chip = Made(wavefront=lm.Wavefront()), distortion.Sensor((10, 20), 1.0)
    names, field = ((2, 0), (3, 1)), Made(unit="m", pupil=lambda *_: Made(wavefront=lm.Wavefront()))

    def at(x, y):
        x, y = np.broadcast_arrays(x, y)
        return np.stack([x, y], axis=-1), 0.1 * np.stack([x + 11.0, y + 7.0], axis=-1)

    fit = Made(names=names, at=at, _pupil=lens, _sensor=chip, degree=1, field=field, twin=None, message="", blurs=(),
        images=None, _terms=names, distortion=Made(at=at, degree=1), model=None, stars=Made(places=np.zeros((1, 2)),
        chi2=None, used=None))  # fmt: skip
    monkeypatch.setattr(field_fit, "save_table", lambda *parts: tables.append(parts[3]))
    monkeypatch.setattr(field_fit.show.estimates, "field", lambda maps, *_: maps)
    tables = []
    FieldFit.save(fit, tmp_path / "a.csv")
    x, y = chip.grid(5)
    for place, k in (("the middle", 2), ("the bottom right corner", -1)):
        across, down = 0.1 * (x[k] + 11.0), 0.1 * (y[k] + 7.0)
        told = f"standard errors in {place}, waves rms: noll 4 {across / TURN:.2g}, noll 8 {down / TURN:.2g}"
        assert told in tables[0]
        told = f"standard errors of the distortion in {place}, pixels: rows {across:.2g}, columns {down:.2g}"
        assert told in tables[0]
    maps, (x, y) = FieldFit.plot(fit), chip.grid(25)
    across, down = at(x, y[:, None])
    for k, factor in enumerate((TURN, TURN, 1.0, 1.0)):
        assert np.allclose(maps[k][1], across[..., k % 2] / factor)
        assert np.allclose(maps[k][2], down[..., k % 2] / factor)


STAR, NOISE = {"shape": 11, "pixel": 0.5}, lm.Noise(read=2.0, excess=2.0)
COMA = lm.Pupil(lm.Wavefront.zernike({8: 0.4}, order="noll"))
OF = ((3, 1), "row", "column", "photons", "background")
FIT = {"pixel": 0.5, "terms": ["noll 8"], "starts": 1, "steps": 60}


def star_matrix(pupil, center, flux, background):
    """Return the information on coma (radians), the place and the light of a star."""
    given = {"center": tuple(center), "photons": flux, "background": background, "noise": NOISE, "tol": 1e-6}
    return lm.fisher(pupil, **STAR, of=OF, **given).matrix


def test_errors_of_a_star_are_those_of_its_information(monkeypatch):
    none = Marginal(np.zeros(1), np.full((1, 1), 0.25))
    monkeypatch.setattr(phase_retrieval, "star_tests", lambda *_: ((), Grade(none, 0.0, 0.0, 0, 1.0, (0.0, 2.0)), []))
    doubt = Finding("errors_change", "doubt", "")
    monkeypatch.setattr(phase_retrieval, "error_findings", lambda *_: [doubt])
    image = 2e4 * lm.psf(COMA, **STAR).values + 9.0
    record = NOISE.record(image, seed=2)
    fit = searches.retrieve(record, lm.Pupil(), noise=NOISE, **FIT)
    inverse = np.linalg.inv(star_matrix(fit.pupil, fit.center[0], fit.flux[0], fit.background[0]))
    errors = [fit.errors[name][0] for name in ("row", "column", "flux", "background")]
    assert errors == pytest.approx(np.sqrt(np.diag(inverse)[1:]), rel=1e-3)
    assert fit.errors["noll 8"] == 0.5
    mean = fit.flux[0] * lm.psf(fit.pupil, **STAR, center=tuple(fit.center[0])).values + fit.background[0]
    chi2 = ((record - mean) ** 2 / (2.0 * mean + 4.0)).sum() / (mean.size - 5)
    assert fit.chi2 == pytest.approx(chi2, rel=1e-3)
    assert [one.code for one in fit.findings if one.severity != "note"] == ["errors_change"]
    told = searches.retrieve(NOISE.record(30.0 * image, seed=2), lm.Pupil(), noise=lm.Noise(read=2.0), **FIT)
    assert {"excess_noise", "misfit"} <= {*told.findings.codes} <= {"excess_noise", "misfit", "pattern"}
    early = searches.retrieve(record, lm.Pupil(), noise=NOISE, **FIT | {"steps": 1})
    assert "not_settled" in early.findings.codes
    field = [fit.coefficients, fit.errors]
    metres = [{"noll 8": one["noll 8"] / TURN} for one in field]
    assert fit.in_unit("waves") == tuple(map(pytest.approx, metres))


def test_errors_of_stars_of_a_field_are_those_of_their_information_together(monkeypatch):
    places = [(20, 20), (20, 60), (60, 20), (60, 60)]
    images = [2e4 * (1 + k) * lm.psf(COMA, **STAR).values + 9.0 for k in range(4)]
    windows = NOISE.record(np.array(images), seed=2)
    given = {"sensor": (80, 80), "pixel": 0.5, "terms": ["noll 8"], "tol": 1e-4, "noise": NOISE, "degree": 0,
        "blur": False}  # fmt: skip
    refine = field_fit.Search.refine
    monkeypatch.setattr(field_fit.Search, "refine", lambda *a, **b: replace(refine(*a, **b), settled=False))
    nothing = (), Grade(Marginal(np.zeros(1), np.eye(1)), 0.0, 0.0, 0, 1.0, (0.0, 2.0)), []
    monkeypatch.setattr(field_search, "missing_tests", lambda *_: nothing)
    monkeypatch.setattr(field_search, "slope_findings", lambda *_: [])
    fit = searches.fit_field(windows, places, lm.Pupil(), **given)
    stars, pupil = fit.stars, fit.field.pupil(0.0, 0.0)
    light = [stars.centers[:, 0], stars.flux[:, 0], stars.background[:, 0]]
    matrices = [star_matrix(pupil, *one) for one in zip(*light, strict=True)]
    common = 1.0 / sum(m[0, 0] - m[0, 1:] @ np.linalg.solve(m[1:, 1:], m[1:, 0]) for m in matrices)
    for k, m in enumerate(matrices):
        inverse = np.linalg.inv(m[1:, 1:])
        shift = inverse @ m[1:, 0]
        errors = np.sqrt(np.diag(inverse) + shift**2 * common)
        found = [*stars.center_errors[k, 0], stars.flux_errors[k, 0], stars.background_errors[k, 0]]
        assert found == pytest.approx(errors, rel=1e-2)
    assert math.isfinite(fit.held_out)
    assert fit.status == "not_settled"


def starts_of(*rows):
    return [tuple(map(np.array, zip(*row, strict=True))) for row in rows]


@pytest.mark.parametrize(("rows", "best", "settled", "tried"), [(starts_of([(1.0, 0.999 * SURE, True)]), 1.0, True,
    1), (starts_of([(1.0, SURE, True)], [(1.5, 9.0, True), (1.9, 9.0, True)]), 1.0, True, 3), (starts_of([(1.0, SURE,
    True)], [(1.5, 9.0, True), (2.1, 9.0, True)], [(1.0, 9.0, True)] * 2), 1.0, True, 5), (starts_of([(1.0, 0.9,
    False)], *[[(2.0, 1.9, True), (3.0, 2.1, True)]] * 2), 1.0, False, 5), (starts_of([(1.0, 9.0, True)], *[[(5.0,
    1.0, False), (6.0, 1.9, True)]] * 2), 6.0, True, 5), (starts_of([(1.0, 9.0, True)], *[[(5.0, 0.9, False), (6.0,
    1.9, True)]] * 2), 5.0, False, 5), (starts_of([(1.0, LIMIT, True)], *[[(1.0, LIMIT, True)] * 2] * 2), 1.0, True,
    5), (starts_of([(1.0, 0.999 * LIMIT, True)], *[[(1.0, LIMIT, True)] * 2] * 2), 1.0, True, 3), (starts_of([(1.0,
    LIMIT, True)], *[[(1.0, LIMIT, True), (4.0, LIMIT, True)]] * 2, [(1.0, LIMIT, True)] * 2), 1.0, True,
    7)])  # fmt: skip
def test_starts_end_where_one_is_sure_or_some_agree(rows, best, settled, tried, monkeypatch):
    """Three agree on what is plausible, five on a misfit; a start that has not settled must have half of chi2."""
    left = iter(rows)

    def search(model, x, steps, report, *, fast):
        x, chi2, ended = next(left) if fast else (x, np.ones(1), np.array([True]))
        one = np.ones(len(chi2))
        return x.reshape(-1, 1), Scores(one, one, one[:, None, None], chi2, 0.1 * one), ended, len(chi2)

    monkeypatch.setattr(phase_retrieval, "_centroid_starts", lambda _: np.zeros((2, 1)))
    monkeypatch.setattr(phase_retrieval, "_random_starts", lambda *_: None)
    monkeypatch.setattr(phase_retrieval, "search_rows", search)
    model = Made(unknowns=Made(pupil=()), nearest=lambda x: x)
    fit, extent = phase_retrieval._search(model, None, None, Made(starts=5 if tried < 7 else 99, steps=9))
    assert (fit.x.item(), fit.settled, extent[1]) == (best, settled, tried)


ROWS, IMAGES = 2000, Made(pupil=Made(shape=(2,)))


@pytest.mark.parametrize("side", [0.9, 1.1])
def test_rounding_of_columns_grows_with_their_number_and_length(side):
    """Two columns of norm 1 that differ by d have the singular value d / sqrt(2), of errors sqrt(2) r."""
    root = np.zeros((ROWS, 2))
    off = 2.0 * side * 2 * ROWS * 2.0**-52
    root[:2] = [[1.0, math.cos(off)], [0.0, math.sin(off)]]
    assert bool(Information.of_root(("p", "q"), {}, 3.0 * root, np.zeros(2)).unidentifiable) == (side < 1.0)


@pytest.mark.parametrize("side", [0.99, 1.01])
@pytest.mark.parametrize(("errors", "zero"), [([0.02, 0.01, 0.0], False), ([0.02, 0.01, 0.0], True), ([0.5, 0.0,
    0.0], False)])  # fmt: skip
def test_a_parameter_is_unidentifiable_by_its_part_in_directions_that_are(side, errors, zero):
    """q = p + d r: p - q + d r is nothing."""
    limit = min(np.linalg.norm(errors), 0.5 / math.sqrt(3 + zero))
    for _ in range(3):  # the least singular value depends on d to second order
        d = math.sqrt(2.0) * side * limit / math.sqrt(1.0 - (side * limit) ** 2)
        p, r = np.eye(3)[:2]
        columns = np.stack([p, (p + d * r) / math.hypot(1.0, d), r], axis=1)
        null = np.array([1.0, -math.hypot(1.0, d), d])
        component = abs(null[2]) / np.linalg.norm(null)
        s = np.linalg.svd(columns)[1][1]
        limit = min(np.linalg.norm(errors) / s, 0.5 / math.sqrt(3 + zero)) * (side * limit / component)
    root = np.zeros((4, 3 + zero))
    root[:3, :3] = columns
    exact = min(np.linalg.norm(errors) / s, 0.5 / math.sqrt(3 + zero))
    found = Information.of_root(("p", "q", "r", "z")[: 3 + zero], {}, root, np.array([*errors, *[0.0] * zero]))
    projection = np.outer(null, null) / (null @ null)
    lost = np.sqrt(np.diag(projection)) > exact
    both = np.outer(lost, lost) & ((np.abs(projection) > exact) | np.eye(3, dtype=bool))
    assert lost[2] == (component > exact)
    assert np.isinf(found.covariance[:3, :3]).tolist() == both.tolist()


def test_the_bounds_of_a_scene_are_those_of_its_images(monkeypatch):
    """Derivatives by light divided by the excess factor are of light; a common parameter has all of its errors."""
    made, plans = [], []
    monkeypatch.setattr(fisher, "_scene_information", lambda *parts: made.append(parts))
    monkeypatch.setattr(fisher, "_root", lambda *_: (np.eye(2), np.array([1.0, 3.0])))
    monkeypatch.setattr(fisher, "_most_accurate_psf", lambda found, *_: plans.append(found) or IMAGES)
    for together, tol in ((False, None), (True, 1e-5)):
        given = {"of": ("row", "photons"), "photons": 9.0, "noise": NOISE, "together": together, "tol": tol}
        lm.fisher(lm.Pupil(lm.Wavefront([0.0, 1.0])), 5, 0.5, **given)
    monkeypatch.undo()
    assert [[one.tol for one in found] for found in plans] == [[1e-8, 1e-7, 1e-6], [1e-5]]
    for (names, roots, errors, axes), expected in zip(made, ((), (0,)), strict=True):
        assert (names, axes) == (("row", "photons"), expected)
        assert (roots[0].tolist(), errors[0].tolist()) == ([[1.0, 0.0], [0.0, 0.5]], [1.0, 1.5])
    monkeypatch.setattr(fisher, "Information", Made(of_root=lambda *parts: parts))
    errors = RNG.uniform(1.0, 2.0, (3, 2))
    found = fisher._scene_information(("row", "photons"), np.zeros((3, 2, 2)), errors, (0,))[3]
    assert found == pytest.approx([math.sqrt((errors[:, 0] ** 2).sum()), *errors[:, 1]], rel=1e-9)
    monkeypatch.undo()
    roots = np.stack([np.eye(2), np.diag([1.0, 0.0])])
    assert Information.of_root(("a", "b"), {}, roots, np.zeros((2, 2))).unidentifiable == ("b",)
    found = fisher._correlation(np.array([[0.25, 0.1, 0.5], [0.1, 0.25, 0.0], [0.5, 0.0, 0.25]]))
    assert found == pytest.approx(np.array([[1.0, 0.4, 1.0], [0.4, 1.0, 0.0], [1.0, 0.0, 1.0]]))
    assert fisher._correlation(np.array([[1.0, -2.0], [-2.0, 1.0]])).tolist() == [[1.0, -1.0], [-1.0, 1.0]]
    words = fisher._errors_in_words
    assert words(np.array([1.0, np.inf, 2.0]), "rad") == "+- 1 to 2 rad, unidentifiable in 1 of 3"
    assert words(np.array([1.2345e-6, 2e-6]), "m") == "+- 1.23 to 2 um"


@pytest.mark.parametrize("chi2", [0.7, 1.0 / 0.9, 0.999, 1.001])
def test_places_scatter_where_chi2_is_more_than_one_and_are_told_above_its_limit(chi2):
    """With white noise, the scatter at which chi2 is 1 adds to the noise in squares."""
    v, u = (part.ravel() for part in np.mgrid[-0.9:0.9:4j, -0.9:0.9:5j])
    sensor, used = distortion.Sensor((1000, 1000), 1.0), np.arange(20)
    ideal = np.stack([500.0 * (v + 1.0), 500.0 * (u + 1.0)], axis=1) - 0.5
    fitted = ideal + 0.01 * np.random.default_rng(3).normal(size=(20, 2))

    def fit(variance):
        places = distortion.Places(fitted, np.tile(variance * np.eye(2), (20, 1, 1)), np.zeros((20, 2, 1)), np.eye(1))
        return distortion.fit_distortion(ideal, used, places, degree=1, sensor=sensor)

    square, limit = fit(1.0).chi2, float(largest_plausible_chi2(math.sqrt(2.0 / 34)))
    basis = np.stack([np.ones(20), u, v], axis=1)
    assert square == pytest.approx(np.linalg.lstsq(basis, fitted - ideal, rcond=None)[1].sum() / 34, rel=1e-4)
    chi2 = chi2 * limit if 0.99 < chi2 < 1.01 else chi2
    found = fit(square / chi2)
    assert found.chi2 == pytest.approx(chi2, rel=1e-6)
    assert found.scatter == pytest.approx(math.sqrt(max(square - square / chi2, 0.0)), rel=1e-6)
    assert found.findings.codes == ("scatter",) * (chi2 > limit)


def test_common_parameters_of_places_have_the_prior_of_their_images():
    basis, shift, slopes = RNG.normal(size=(6, 1)), RNG.normal(size=(6, 2)), RNG.normal(size=(6, 2, 1))
    places = distortion.Places(shift, np.tile(0.5 * np.eye(2), (6, 1, 1)), slopes, np.array([[3.0]]))
    model = distortion._PlaceModel(basis, shift, places)
    design = np.concatenate([np.kron(np.eye(2), basis[:, None]), slopes], axis=2).reshape(12, 3)
    rows = np.vstack([design / math.sqrt(0.75), [0.0, 0.0, math.sqrt(3.0)]])
    best, square, *_ = np.linalg.lstsq(rows, np.append(shift.ravel() / math.sqrt(0.75), 0.0), rcond=None)
    values, _, chi2 = model.fit(0.5)
    assert (values, chi2) == (pytest.approx(best), pytest.approx(square[0] / 10))


@pytest.mark.parametrize("side", [0.999, 1.001])
@pytest.mark.parametrize("beside", [False, True])
def test_cosmic_rays_are_six_deviations_above_a_multiple_of_their_neighbours_or_three_beside_a_track(beside, side):
    """The deviation is that of a pixel and of the multiple of its neighbours, and by Bernstein's bound of a tail."""
    level, read, ratio = 50.0, 4.0, (5.0 if beside else 10.0)
    dark = 20.0
    sky = dark - special.ndtri(0.02) * math.sqrt(dark + read)
    median, noise = level - sky, read + sky
    variance = noise + ratio * median + (0.25 * ratio) ** 2 * (noise + median)
    limit = 3.0 if beside else 6.0
    # x / sqrt(variance + x / 3) = limit
    x = (limit**2 / 3.0 + math.sqrt(limit**4 / 9.0 + 4.0 * limit**2 * variance)) / 2.0
    image = np.full((1, 21, 21), level)
    image[0, 0] = dark
    image[0, 10, 10] = sky + ratio * median + x * side
    image[0, 10, 11 if beside else 10] += 1e5 if beside else 0.0
    mask = cosmic_rays.cosmic_ray_mask(image, np.full(image.shape, read), np.full(image.shape, True), 5.0)
    assert mask[0, 10, 9] == (side > 1.0)


def test_tolerances_of_searches_are_below_the_read_noise_and_masks_symmetric_within_a_millionth():
    for read, tol in ((4.0, 1e-6), (1e4, 1e-6), (1e4, 1e-3), (1e-6, 1e-6)):
        data = np.array([[0.0, 2e4], [1.0, 1.0], [read, 2.0 * read], [1.0, 1.0]])
        expected = min(max(tol, 0.3 * math.sqrt(read) / 2e4), max(tol, 1e-4))
        assert star_images.loosest_tolerance(data, tol) == pytest.approx(expected, rel=1e-9)
    x = np.array([0.5, -0.25])
    for off, margin, symmetric in ((0.75e-6, 1.0, True), (1.5e-6, 1.0, False), (None, 1.0, True), (None, -1.0,
        False), (0.0, -1.0, False)):  # fmt: skip
        opening = Made(rule=lambda _: (x, x, None), margin=lambda *_, margin=margin: np.array([1.0, margin]))
        mask = None if off is None else Made(values=np.array([[0.0, 1.0, 0.0], [0.0, 1.0, off], [0.0, 1.0, 0.0]]))
        pupil = Made(circular=False, segmented=False, phase_mask=False, opening=opening, mask=mask)
        assert star_images._point_symmetric(pupil) == symmetric
    model = Made(size=3, pupil_columns=slice(1, 3), unknowns=Made(pupil=("wavelength", "f_number")))
    found = star_images.StarImages.pupil_parameters(model, np.arange(6.0))
    assert found == {"wavelength": 1.0, "f_number": 2.0}


@pytest.mark.parametrize(("error", "factor", "codes"), [(0.2499, 1.124, []), (0.2501, 1.0, ["too_dim"]), (0.2499,
    1.126, ["errors_change"])])  # fmt: skip
def test_standard_errors_are_doubted_by_the_phase_or_by_how_they_change(error, factor, codes, monkeypatch):
    monkeypatch.setattr(star_checks, "uncertainty", lambda *_: (error, None))
    monkeypatch.setattr(star_checks, "error_factors", lambda *_: np.array([1.0, factor]))
    found = star_checks.error_findings(Made(names=((2, 0), (3, 1))), None, None)
    assert [one.code for one in found] == codes


def test_squared_widths_fall_to_a_quarter_at_most_and_to_zero_from_below_their_limit():
    before = np.array([[[0.4, 0.4]], [[0.9, 0.1]], [[1.0, 1.0]], [[0.5, 0.5]]])
    after = np.array([[[0.0, 0.0]], [[0.1, 0.1]], [[9.0, -1.0]], [[0.0, 0.0]]])
    field_stars.limit_widths(after, before, 8.5, zero_limit=1.0)
    assert after.tolist() == [[[0.0, 0.0]], [[0.125, 0.125]], [[8.1, 0.0]], [[0.125, 0.125]]]
    model = field_stars._StarModel.__new__(field_stars._StarModel)
    stars = Made(exposures=1, width_count=1, parameters_per_image=4)
    stars.limit_nuisance = lambda new, old: np.clip(new, old - 0.1, old + 0.1, out=new)
    field_stars._StarModel.__init__(model, stars, np.arange(1), 2, 100.0)
    found = model.within(np.array([[5.0, 0.0, 1.0, 1.0, 1.0, 1.0]]), np.array([[1.0, 0.4, 0.0, 0.0, 0.0, 0.0]]))
    assert found == pytest.approx(np.array([[5.0, 0.1, 0.1, 0.1, 0.1, 0.1]]))


@pytest.mark.parametrize("offsets", [(2.0, 3.0), (0.5, 4.0)])
def test_the_best_foci_are_those_of_the_least_error_in_vergence(offsets, monkeypatch):
    lens, distance = lm.Lens(focal_length=0.035, f_number=8.0, focus_distance=1.5, wavelength=5.4e-7), 1.5
    unit = 2.0 * 5.4e-7 / (math.pi * (0.5 * 0.035 / 8.0) ** 2)

    def error(pair, metres, pitch, surface):
        found = [abs(1.0 / one.focus_distance - 1.0 / metres) / unit for one in pair]
        return 1e-3 * (
            1.0 + sum(math.log(max(one, 1e-9) / best) ** 2 for one, best in zip(found, offsets, strict=True))
        )

    monkeypatch.setattr(depth_precision, "_error", error)
    pair = lm.best_depth_foci(lens, distance, 4e-6, noise=lm.Noise(white=1e4, read=3.0))
    found = [abs(1.0 / one.focus_distance - 1.0 / distance) / unit for one in pair]
    assert found == pytest.approx(offsets, rel=0.03)


class _AskedError(Exception):
    """What was asked for."""


def test_images_of_a_search_have_the_tolerance_of_a_search_and_others_their_own(monkeypatch):
    def plan(shape, pixel, *, tol, integrate, threads):
        raise _AskedError(tol, integrate)

    def prepared_with(tol):
        def prepared(_):
            raise _AskedError(tol, False)

        return Made(prepared=prepared)

    monkeypatch.setattr(field_stars, "Plan", plan)
    plain = {"search_tol": 1e-4, "tol": 1e-6, "shape": (5, 5), "pixel": 0.5, "threads": 1, "pupil": lm.Pupil()}
    stars = Made(**plain, first_star=Made(terms=((2, 0),)))
    plans = {"plan": prepared_with(1e-6), "_search_plan": prepared_with(1e-4)}
    image = Made(pupils=lambda _: lm.Pupil(), derivatives=(), **plans)
    for fast, tol in ((True, 1e-4), (False, 1e-6)):
        for asked in (
            lambda fast=fast: field_stars.FieldStars._block(
                stars, None, np.zeros((1, 1, 1)), None, None, fast, "none"
            ),
            lambda fast=fast: star_images.StarImages.images(image, np.zeros((1, 1)), fast=fast),
        ):
            with pytest.raises(_AskedError) as found:
                asked()
            assert found.value.args == (tol, False)
    model = Made(
        fixed=np.array([0.1, 0.2]), wave_columns=slice(0, 1), directions=np.array([[0.0, 2.0]]),
        terms=((2, 0), (4, 0)), pupil_parameters=len, wavelength_ratio=lambda _: 1.3, pupil=lm.Pupil(),
    )  # fmt: skip
    found = star_images.StarImages.wavefront(model, np.array([0.5, 9.0])).edge_terms()
    assert found == pytest.approx({(2, 0): 0.13, (4, 0): 1.56})


def test_a_blurred_star_has_the_errors_of_its_field(monkeypatch):
    nothing = (), Grade(Marginal(np.zeros(1), np.full((1, 1), 0.25)), 0.0, 0.0, 0, 1.0, (0.0, 2.0)), []
    monkeypatch.setattr(field_search, "missing_tests", lambda *_: nothing)
    monkeypatch.setattr(field_search, "slope_findings", lambda *_: [])
    record = NOISE.record(2e4 * lm.psf(COMA, **STAR).values + 9.0, seed=2)
    fit = searches.retrieve(record, lm.Pupil(), noise=NOISE, blur=lm.Jitter(1e-3), **FIT)
    inverse = np.linalg.inv(star_matrix(fit.pupil, fit.center[0], fit.flux[0], fit.background[0]))
    errors = [fit.errors[name][0] for name in ("row", "column", "flux", "background")]
    assert errors == pytest.approx(np.sqrt(np.diag(inverse)[1:]), rel=0.02)
    assert fit.errors["noll 8"] == 0.5
