"""Fisher scoring: searches end at limits, steps that swing are damped."""

import numpy as np

from lommel.fit.scoring import (
    Progress,
    Scores,
    covariance,
    damped_steps,
    fisher_scoring,
    flux_background,
    search_rows,
)


class Bounded:
    """A parabola whose lowest point is beyond the limit of its parameter."""

    size, degrees_of_freedom, alternatives = 1, 100, False

    def images(self, x, *, fast=False):
        return None, None

    def scores(self, x, *, fast=False, rows=None):
        one = np.ones(len(x))
        return Scores(0.5 * (x[:, 0] - 3.0) ** 2, 3.0 - x, np.ones((len(x), 1, 1)), one, 0.1 * one)

    def scores_of(self, x, values, slopes):
        return self.scores(x)

    def within(self, x, before):
        return np.clip(x, -1.0, 1.0, out=x)

    def rms(self, steps):
        return np.zeros(len(steps))

    def steps(self, scores, damping):
        return damped_steps(scores, damping)


def test_a_search_settles_at_the_limit_of_a_parameter():
    x, scores, settled, taken = search_rows(Bounded(), np.zeros((1, 1)), 20, lambda *_: None, fast=False)
    assert (x[0, 0], scores.deviance[0], settled[0]) == (1.0, 2.0, True)
    assert taken < 5


class Swinging(Bounded):
    """A parabola whose information is stated as little more than half of its curvature."""

    def scores(self, x, *, fast=False, rows=None):
        found = super().scores(x)
        return found._replace(information=np.full((len(x), 1, 1), 0.505))

    def within(self, x, before):
        return x


def test_steps_that_swing_beside_the_answer_are_damped():
    x, _, settled, taken = search_rows(Swinging(), np.array([[2.2]]), 20, lambda *_: None, fast=False)
    assert settled[0]
    assert abs(x[0, 0] - 3.0) < 0.1
    assert taken < 10


class Curve:
    """One parameter of a quartic, whose steps are by the curvature, as a problem of its own."""

    degrees_of_freedom, alternatives = 100, False

    def worth(self, x):
        return Scores(*(np.array([part]) for part in (x**4, -4.0 * x**3, 12.0 * x**2 + 1e-9, 1.0, 0.1)))

    def step(self, x, now, at, damping):
        step = now.slope / (now.information * (1.0 + damping))
        return step, step * now.slope

    def rms(self, step):
        return np.abs(step)

    def attempt(self, x, now, at, step, factor):
        tried = x + float(factor[0] * step[0])
        return tried, self.worth(tried)


class Plain(Curve):
    rms = None


def test_steps_do_not_stretch_unless_they_may():
    steps = [fisher_scoring(curve, 1e3, curve.worth(1e3), 100, lambda *_: None).steps for curve in (Plain(), Curve())]
    assert steps[0] < 60 < steps[1]  # those that stretch are limited to radians, for all but wavefronts far too long


def test_flux_and_background_are_those_of_weighted_least_squares():
    draw = np.random.default_rng(2)
    psf, valid = draw.random((3, 30)), (draw.random((3, 30)) < 0.9).astype(float)
    counted, read = draw.poisson(50.0, (3, 30)).astype(float), np.full((3, 30), 4.0)
    flux, background = flux_background(psf, counted, read, valid)
    for k in range(3):
        root = np.sqrt(valid[k] / (counted[k] + read[k] + 1.0))
        sides = np.stack([root * psf[k], root], axis=1)
        best = np.linalg.lstsq(sides, root * counted[k], rcond=None)[0]
        expected = best if best[0] > 1.0 else (1.0, best[1] + (best[0] - 1.0) * (root**2 @ psf[k]) / (root**2).sum())
        np.testing.assert_allclose([flux[k], background[k]], expected, rtol=1e-9)


def test_the_covariance_is_infinite_where_nothing_is_known():
    information = np.diag([4.0, 0.0, 1.0])
    information[0, 2] = information[2, 0] = 1.0
    found = covariance(information)
    assert np.isinf(found[1, 1])
    np.testing.assert_allclose(found[np.ix_([0, 2], [0, 2])], np.linalg.inv(information[np.ix_([0, 2], [0, 2])]))


def test_a_refit_means_that_less_of_the_time_has_passed():
    told = []
    progress = Progress(lambda done, chi2: told.append(done))
    progress.begin(0.9, 2)
    progress(0, 1.0)
    progress(1)
    progress.resume(0.45)
    progress.begin(0.2, 2)
    progress(0)
    np.testing.assert_allclose(told, [0.45, 0.675, 0.505])


def test_the_remaining_time_is_right_within_a_factor_of_2_if_phases_are_within_2_fifths():
    rng = np.random.default_rng(4)
    for expected in (0.6, 1.0, 1.4):  # steps per phase, relative to those stated
        clock, told = 0.0, []
        progress = Progress(lambda done, chi2, told=told: told.append(done))
        times, left = [], 1.0
        for share, steps in ((0.3, 15), (0.3, 10), (0.5, 20), (0.8, 10)):
            progress.begin(share, steps)
            cost = left * share / steps
            for _ in range(round(expected * steps)):
                clock += cost * rng.uniform(0.7, 1.3)
                progress(0, 1.0)
                times.append(clock)
            left *= 1.0 - share
        time, done = np.array(times), np.array(told)
        assert (np.diff(done) > 0.0).all()
        assert done[-1] < 1.0
        judged = (done >= 0.1) & (done < 0.9)
        ratio = time * (1.0 / done - 1.0) / (clock + left - time)
        assert ratio[judged].min() > 0.5
        assert ratio[judged].max() < 2.0
