"""Model error: kappa, length and errors against dense formulas, on draws of a known covariance."""

import numpy as np
import pytest
from scipy import ndimage

from lommel.fit.findings import Finding
from lommel.fit.model_error import (
    MIN_GAIN,
    ModelError,
    covered,
    is_correlated,
    jackknife,
    larger,
    model_error,
    with_errors_of_model,
    with_shared_error,
)

SIDES, KAPPA, LENGTH = (2, 9, 10), 0.12, 1.4
ROWS, COLUMNS = np.indices(SIDES[1:])
LIGHT = np.array(
    [3e4 * np.exp(-0.5 * ((ROWS - 4 - k) ** 2 + (COLUMNS - 4.5) ** 2) / (4 + 3 * k)) + 40 for k in (0, 1)]
)
VARIANCE = LIGHT + 30.0
WAVES = [np.cos(0.5 * k * ROWS + 0.4 * COLUMNS * (k - 2)) for k in range(4)]
DERIVATIVES = np.stack([*(LIGHT * wave for wave in WAVES), LIGHT, np.ones(SIDES)])
BRIGHT = np.array([ndimage.gaussian_filter(image, 1.0) for image in LIGHT])  # the smoothed light


def blocks(kappa, length, kept=None):
    """Return the dense covariance of each image."""
    distance2 = np.subtract.outer(ROWS.ravel(), ROWS.ravel()) ** 2 + np.subtract.outer(*2 * [COLUMNS.ravel()]) ** 2
    correlation = np.exp(-distance2 / (2 * length**2)) if length else np.eye(ROWS.size)
    return [
        np.diag(v.ravel()) + kappa**2 * correlation * np.outer(s.ravel(), s.ravel())
        for v, s in zip(VARIANCE, BRIGHT, strict=True)
    ]


def drawn(seed, kappa=KAPPA):
    draw = np.random.default_rng(seed)
    images = [np.linalg.cholesky(v) @ draw.normal(size=len(v)) for v in blocks(kappa, LENGTH)]
    return np.reshape(images, SIDES)


def dense(residual, kappa, length):
    """Return the restricted ln(likelihood), covariance and step of all valid pixels, from matrices of full size."""
    valid = np.isfinite(residual).ravel()
    v = np.zeros((residual.size, residual.size))
    n = ROWS.size
    for k, block in enumerate(blocks(kappa, length)):
        v[k * n : (k + 1) * n, k * n : (k + 1) * n] = block
    v, a, r = v[np.ix_(valid, valid)], DERIVATIVES.reshape(len(DERIVATIVES), -1)[:, valid].T, residual.ravel()[valid]
    inverse = np.linalg.inv(v)
    normal = a.T @ inverse @ a
    step = np.linalg.solve(normal, a.T @ inverse @ r)
    dets = np.linalg.slogdet(v)[1] + np.linalg.slogdet(normal)[1]
    return -0.5 * (dets + r @ inverse @ (r - a @ step)), np.linalg.inv(normal), step


def test_the_result_is_the_maximum_of_the_dense_restricted_likelihood():
    residual = drawn(1)
    found = model_error(residual, DERIVATIVES, VARIANCE, LIGHT)
    best, covariance, step = dense(residual, found.kappa, found.length)
    assert found.gain == pytest.approx(best - dense(residual, 0.0, 0.0)[0], abs=1e-3)
    others = [(0.93 * found.kappa, LENGTH), (1.07 * found.kappa, LENGTH), (found.kappa, 0.7)]
    assert all(dense(residual, *other)[0] < best for other in others)
    assert found.length == LENGTH
    assert found.kappa == pytest.approx(KAPPA, rel=0.2)
    np.testing.assert_allclose(found.shift, step, rtol=1e-4, atol=1e-6 * np.abs(step).max())
    ratio = np.diag(found.covariance) / np.diag(covariance)
    assert (ratio > 1.0 - 1e-6).all()


def test_errors_contain_the_scatter_that_errors_of_photons_alone_do_not():
    photons = dense(np.zeros(SIDES), 0.0, 0.0)[1]
    z, narrow = [], []
    for seed in range(6):
        residual = drawn(10 + seed)
        found = model_error(residual, DERIVATIVES, VARIANCE, LIGHT)
        z.append(found.shift / np.sqrt(np.diag(found.covariance)))
        narrow.append(dense(residual, 0.0, 0.0)[2] / np.sqrt(np.diag(photons)))
    assert 0.6 < np.sqrt(np.mean(np.square(z))) < 1.2
    assert np.sqrt(np.mean(np.square(narrow))) > 4.0


def test_only_a_model_error_is_significant():
    noise = [model_error(drawn(30 + k, 0.0), DERIVATIVES, VARIANCE, LIGHT) for k in range(3)]
    assert max(found.gain for found in noise) < MIN_GAIN < model_error(drawn(1), DERIVATIVES, VARIANCE, LIGHT).gain
    assert all(found.missed < 0.02 for found in noise)
    assert sum(is_correlated(drawn(100 + k, 0.0), VARIANCE, LIGHT) for k in range(20)) <= 2
    assert is_correlated(drawn(1, 0.02), VARIANCE, LIGHT)


def test_pixels_are_summed_and_left_out_pixels_have_no_effect():
    # Each pixel becomes four, of which one is left out: sums over 2 x 2 of them are the images of before.
    def fine(images):
        parts = np.kron(images, np.ones((2, 2)) / 3)
        parts[..., 1::2, ::2] = np.nan
        return parts

    residual = drawn(3)
    found, coarse = (
        model_error(*args)
        for args in (
            (fine(residual), fine(DERIVATIVES), fine(VARIANCE), fine(LIGHT)),
            (residual, DERIVATIVES, VARIANCE, LIGHT),
        )
    )
    assert found.length == 2 * coarse.length
    np.testing.assert_allclose(found.shift, coarse.shift, rtol=1e-6)


def test_fewer_than_ten_pixels_for_each_parameter_are_refused():
    residual = np.full(SIDES, np.nan)
    residual[0].flat[:59] = 1.0
    assert model_error(residual, DERIVATIVES, VARIANCE, LIGHT) is None
    residual[0].flat[59] = 1.0
    assert model_error(residual, DERIVATIVES, VARIANCE, LIGHT) is not None


def test_the_jackknife_is_that_of_least_squares_without_one_part():
    draw = np.random.default_rng(5)
    design, data, prior = draw.normal(size=(6, 20, 3)), draw.normal(size=(6, 20)), np.diag([0.0, 4.0, 0.0])
    estimates = []
    for k in range(6):
        a, b = (np.concatenate([part for j, part in enumerate(x) if j != k]) for x in (design, data))
        estimates.append(np.linalg.solve(a.T @ a + prior, a.T @ b))
    square = design.swapaxes(1, 2) @ design
    slope = np.einsum("gij,gi->gj", design, data)
    found = jackknife(square, slope, (square.sum(axis=0) + prior, slope.sum(axis=0)))
    np.testing.assert_allclose(found, 5.0 * np.cov(np.transpose(estimates), bias=True), rtol=1e-7)


def test_the_larger_variance_is_kept_with_its_correlations():
    covariance = np.array([[4.0, 1.0], [1.0, 1.0]])
    np.testing.assert_allclose(larger(covariance, np.diag([1.0, 9.0])), [[4.0, 3.0], [3.0, 9.0]])
    np.testing.assert_array_equal(larger(covariance, np.diag([np.nan, np.inf]))[0, 0], 4.0)


def test_errors_hold_in_the_linear_range_and_near_the_maximum():
    error = ModelError(np.array([0.3, -0.3]), np.diag([0.36, 0.36]), 0.1, 0.1, 1.0, 99.0)

    def rms(steps):
        return np.sqrt((steps**2).sum(axis=1))

    assert not error.holds(rms, np.zeros(2))  # 0.85 radians
    assert error.holds(rms, np.zeros(2), 1.0)
    assert not error.holds(rms, np.array([0.0, 0.7]), 1.0)
    assert not error._replace(missed=0.4).holds(rms, np.zeros(2), 1.0)


def test_where_the_model_misses_light_is_told():
    rows, columns = np.indices((21, 21)) - 10
    light = 3e4 * np.exp(-0.125 * (rows**2 + columns**2))
    variance, dark, wave = light + 30.0, light < 1.0, np.cos(rows)
    noise = np.sqrt(variance) * np.random.default_rng(2).normal(size=light.shape)
    told, where = (
        with_errors_of_model([], (noise + part)[None], variance[None], light[None], "a cause")[0]
        for part in (0.1 * light * wave, 12.0 * wave * dark)
    )
    missed = 0.1 * np.sqrt((light**2 * wave**2).sum() / (light**2).sum())
    assert told.numbers == {"missed": pytest.approx(missed, rel=0.1)}
    assert told.text.startswith(f"the model misses {100 * told.numbers['missed']:.2g} % of the light; errors hold")
    assert where.text.startswith("the model misses light where images are faint, ")
    assert where.text.endswith(" electrons per pixel rms; errors hold between exposures of this set-up; a cause")
    assert where.numbers["faint"] == pytest.approx(12.0 * np.sqrt(np.mean(wave[dark] ** 2)), rel=0.25)


@pytest.mark.parametrize(
    ("numbers", "notes"),
    [({"missed": 0.029}, 2), ({"missed": 0.031}, 0), ({"missed": 0.0, "faint": 3.0}, 0)],
)
def test_errors_include_little_light_in_proportion_to_that_of_the_star(numbers, notes):
    found = [Finding(code, "doubt", code, numbers) for code in ("missed_light", "other_explanation", "pattern")]
    assert [one.severity for one in covered(found)] == ["note"] * notes + ["doubt"] * (3 - notes)
    assert covered(found[1:]) == found[1:]


def test_missed_light_of_stars_out_of_focus_states_what_it_may_move_in_all_exposures():
    text = "the model misses 12 % of the light; errors hold between exposures of this set-up; a cause"
    (doubt,) = found = [Finding("missed_light", "doubt", text, {"missed": 0.12})]
    (told,) = with_shared_error(found, np.pi * np.array([-13.0, 5.0]))
    rows, columns = np.indices((401, 401)) / 200.0 - 1.0
    inside = rows**2 + columns**2 < 1.0
    # Coma of 1 wave rms, sqrt(8) (3 rho^3 - 2 rho) cos(theta), moves rays and changes the light by its Laplacian.
    coma = np.sqrt(8.0) * columns * (3.0 * (rows**2 + columns**2) - 2.0)
    laplacian = sum(np.gradient(np.gradient(coma, 0.005, axis=k), 0.005, axis=k) for k in (0, 1))
    per_wave = np.sqrt((laplacian[inside] ** 2).mean()) / (2.0 * 13.0)
    assert told.numbers["shared"] == pytest.approx(2.0 * np.pi * 0.12 / per_wave, rel=0.02)
    assert "what all of them share may move each term by up to 0.58 rad rms; a cause" in told.text
    assert [*with_shared_error(found, np.array([-4.0, 0.0, 4.0]))] == [doubt]
