"""Terms of the bound of the tuned closed form, a second time, from the notes of its class; and of the best form."""

from __future__ import annotations

import math
from contextlib import nullcontext

import numpy as np
import pytest

import lommel as lm
from lommel.core.answers import FieldValues
from lommel.methods.method import relative_error
from lommel.methods.paper import closed_form
from lommel.methods.paper.closed_form import ClosedForm, TunedClosedForm
from lommel.optics.grid import Grid
from lommel.special.erf import AbramowitzErf, FresnelErf
from lommel.special.piecewise import fit_quadratics

pytest.importorskip("scipy.optimize")  # takes longer to load than any test
PUPIL, V = lm.Pupil(lm.Wavefront([2.0, -1.0], [1.0, 3.0]), obscuration=0.3), np.linspace(0.0, 20.0, 30)


@pytest.mark.parametrize("error", [1e-3, 3e-6, 0.9])
@pytest.mark.parametrize("c", [(3.0, 0.0), (2.0, 5.0), (0.0, -40.0)])
def test_a_field_errs_by_amplitude_phase_series_and_moments(c, error):
    values, bound = closed_form._field(np.array(c), V, error)
    # Half of the error allows for a relative error of the amplitude, 0.0026 (r - 1)^3 on pieces from a to r a.
    r = 1.0 + min(0.6, (0.5 * error * math.sqrt(10.0) / 1.1 / 0.0026) ** (1 / 3))
    pieces, segments, fit = max(1, math.ceil(math.log(2.0) / math.log(r))), 1, fit_quadratics([c[0]], 1)
    if c[1]:
        segments = max(1, math.ceil(0.38 * (abs(c[1]) / (0.4 * error)) ** (1 / 3)))
        while (fit := fit_quadratics(list(c), segments)).bound > 0.4 * error:
            segments = math.ceil(1.3 * segments)
    expected = 1.1 * 0.0026 * (r - 1) ** 3 / math.sqrt(10) + fit.bound + 4e-9
    assert bound == pytest.approx(expected + 1e-10 * math.sqrt(fit.alpha.size + pieces), rel=1e-9, abs=1e-13)
    exact = lm.methods.NijboerZernike(1e-10).evaluate(lm.Pupil(lm.Wavefront(c[0] / 2, c[1])), V).values[0]
    assert np.abs(np.abs(values) - np.abs(exact)).max() <= bound


def test_intensities_are_interpolated_where_that_saves_and_err_by_it(monkeypatch):
    asked, way = [], TunedClosedForm()
    given = FieldValues(np.full((2, 1), 0.3 + 0.4j), np.array([1e-5, 2e-5]))

    def fields(pupil, points, error):
        asked.append(points)
        return given._replace(values=np.repeat(given.values, points.size, axis=1))

    monkeypatch.setattr(way.__class__, "_fields", lambda self, *rest: fields(*rest))
    for v in (V[:20], np.linspace(0.0, 20.0, 9999)):
        values, bound = way._intensities(PUPIL, v, 1e-5)
        assert values == pytest.approx(0.25)
        # The wider of pieces have a tenth of the error by interpolation at 24 points.
        width = 4.0 * (0.1e-5 * math.factorial(24)) ** (1 / 24)
        more = 3.03 * given.error + 2.0 * (width / 4.0) ** 24 / math.factorial(24)
        assert bound == pytest.approx(given.error if v.size == 20 else more, rel=1e-12, abs=0.0)
    assert asked[-1].size == 24 * math.ceil(20.0 / width)


@pytest.mark.parametrize("falls", [0, 2, 9])
def test_less_error_of_fields_is_allowed_until_profiles_are_within_the_tolerance(falls, monkeypatch):
    way, asked = TunedClosedForm(1e-3), []
    intensity = np.array([[0.5, 0.2], [0.1, 0.8]])
    low = 1e-3 * 0.5 / (2.0 * math.sqrt(0.5)) * 0.7

    def intensities(self, pupil, v, error):
        asked.append(error)
        return intensity, np.array([low * (1.0 if len(asked) > falls else 3.0), 1e-9])

    phases = max(abs(PUPIL.coefficients()).sum(axis=1))
    scan, rough = (
        np.linspace(0.0, float(PUPIL.v(PUPIL.geometric_radius()).max()) + 4.0, 48),
        PUPIL.area / (2 * phases + 1),
    )
    peak = np.abs(way._fields(PUPIL, scan, 0.05 * rough).values).max(axis=1).min()
    monkeypatch.setattr(TunedClosedForm, "_intensities", intensities)
    with nullcontext() if falls < 4 else pytest.raises(lm.ToleranceError, match=r"stays at 0\.002"):
        found = way.profile(PUPIL, V)
        assert found.error == pytest.approx(relative_error(intensity, np.array([low, 1e-9])), rel=1e-12, abs=0.0)
        assert found.peak.tolist() == [0.5, 0.8]
    assert asked == pytest.approx(
        [0.2e-3 * max(peak, rough) * 0.2**k for k in range(min(falls + 1, 4))], rel=1e-9, abs=0.0
    )


@pytest.mark.parametrize(("defocus", "side", "pixel"), [(3.0, 15, 1.0), (6.0, 5, 2.0), (30.0, 9, 0.5), (1.0, 9, 1.5)])
def test_the_best_form_has_the_fewest_terms_within_a_hundredth_of_the_least_error(defocus, side, pixel):
    pupil, grid = lm.Pupil(lm.Wavefront(defocus)), Grid(side, pixel)
    made, v = ClosedForm.best(pupil, side, pixel), grid.v(pupil)
    exact = lm.methods.NijboerZernike().profile(pupil, v).values[0]

    def error(tangent, erf):
        values = ClosedForm(tangent, erf).profile(pupil, v).values[0]
        return (grid.multiplicity * (values - exact) ** 2).sum()

    scan = np.geomspace(1.0, 4.0 * v[-1], 48)
    each = [error(t, FresnelErf()) for t in scan]
    start, least = int(np.argmin(each)), error(made.tangent, FresnelErf())
    assert scan[start - 1] < made.tangent <= scan[min(47, start + 1)]
    near = [min(made.tangent * factor, scan[-1]) for factor in (0.99, 1.01)]
    assert least <= min(*each, *(error(t, FresnelErf()) for t in near))
    terms = next(n for n in range(5, 205, 5) if error(made.tangent, AbramowitzErf(n)) <= 1.01 * least)
    assert made.erf == AbramowitzErf(terms)


def test_a_stack_is_interpolated_where_all_of_its_pupils_may_be():
    defocus, v = [1.0, 200.0], np.linspace(0.0, 900.0, 9000)
    found = ClosedForm().evaluate(lm.Pupil(lm.Wavefront(defocus)), v).values
    for c, one in zip(defocus, found, strict=True):
        exact = ClosedForm().evaluate(lm.Pupil(lm.Wavefront(c)), v[::300]).values[0]
        assert np.abs(one[::300] - exact).max() <= 1e-12
