"""Score tests of PSFs against elimination by least squares, with blurs that are matrices."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.deconvolve.iterations import State
from lommel.deconvolve.likelihood import PoissonLikelihood
from lommel.deconvolve.linear import PlaneOperator
from lommel.microscopy import psf_scores
from lommel.microscopy.psf_scores import PSFScores

SHAPE, WHOLE = (2, 5, 6), (1, 2, 2)
CAMERA = lm.Noise(white=0.5, read=1.5, offset=100.0)
DRAW = np.random.default_rng(2)
BLUR, SLOPE = DRAW.uniform(0.0, 1.0, (2, 60, 5))  # the fifth column is that of light beyond the specimen
LIGHT, LEVEL = DRAW.uniform(50.0, 300.0, 5), 20.0


class Matrix(PlaneOperator):
    """A blur by a matrix, with light beyond the specimen."""

    shape, whole = SHAPE, WHOLE

    def __init__(self, matrix):
        self.matrix, self.outside, self.per_outside = matrix, np.ones(1), 1.0 / matrix[:, 4].sum()

    def forward(self, specimen, consume):
        image = self.matrix @ np.append(specimen, self.outside)
        for plane, values in enumerate(image.reshape(SHAPE).astype(np.float32)):
            consume(plane, slice(0, 5), slice(0, 6), values)

    def adjoint(self, recording, consume):
        *inside, self.outside_back = self.matrix.T @ recording.ravel()
        consume(0, slice(0, 2), slice(0, 2), np.reshape(inside, WHOLE)[0])

    def per_seen(self, plane, rows, columns):
        return 1.0 / self.matrix[:, :4].sum(axis=0).reshape(WHOLE)[plane]


def test_what_another_specimen_explains_is_eliminated(monkeypatch):
    monkeypatch.setattr(psf_scores, "_STEPS", 7)  # as many as unknowns, and one
    mean, true_change = (BLUR + 0.03 * SLOPE) @ LIGHT + LEVEL, 0.03
    counts = CAMERA.record(mean.reshape(SHAPE), seed=4).astype(float)
    counts[1, 2, 3] = np.nan
    state = State(LIGHT[:4].reshape(WHOLE).astype(np.float32), LIGHT[4:].astype(np.float32))
    tests = PSFScores(Matrix(BLUR), PoissonLikelihood(counts, CAMERA), state, LEVEL)
    score = tests.of(Matrix(BLUR + 0.1 * SLOPE), 0.1)

    model = BLUR @ LIGHT + LEVEL
    sigma = np.sqrt((model + 1.5**2 / 0.5) / 0.5)  # counts: of shot noise, and of 1.5 electrons of the camera
    known = np.isfinite(counts.ravel())
    unknowns, slope, residual = (
        (values.T / sigma).T[known]
        for values in (np.column_stack([BLUR, np.ones(60)]), SLOPE @ LIGHT, counts.ravel() - 100.0 - model)
    )
    rest = slope - unknowns @ np.linalg.lstsq(unknowns, slope, rcond=None)[0]
    assert score.information == pytest.approx(rest @ rest, rel=1e-3)
    assert score.slope == pytest.approx(rest @ residual, rel=1e-3)
    assert tests.chi2 == pytest.approx(residual @ residual / 59, rel=1e-5)
    assert abs(score.change - true_change) < 3.0 * score.error
    gain, error = score.gain(score.change)
    assert 2.0 * gain == pytest.approx(score.deviance)
    assert error == pytest.approx(abs(score.change) / score.error)


def test_a_parameter_that_changes_no_image_has_no_score():
    state = State(LIGHT[:4].reshape(WHOLE).astype(np.float32), LIGHT[4:].astype(np.float32))
    tests = PSFScores(Matrix(BLUR), PoissonLikelihood(np.full(SHAPE, 500.0), CAMERA), state, LEVEL)
    assert tests.of(Matrix(BLUR), 0.1) is None
