"""Pictures of depth."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest
from matplotlib.figure import Figure

from lommel.show import estimates

IMAGE = np.arange(25.0).reshape(5, 5)


def test_errors_of_depth_are_drawn_in_millimetres_and_what_is_not_known_is_left_grey():
    errors = np.where(IMAGE == 7.0, math.inf, 1e-3 * (IMAGE + 1.0))
    depth, error, picture, *_ = estimates.maps(IMAGE, errors, np.ones((5, 5, 3))).axes
    np.testing.assert_allclose(error.images[0].get_array(), np.where(IMAGE == 7.0, math.nan, IMAGE + 1.0))
    assert (depth.get_title(), error.get_title()) == ("depth, known at 96 %", "standard error")
    assert len(picture.images) == 1
    curve, distance = np.array([1e-3, math.inf, 4e-3]), np.array([1.0, 2.0, 3.0])
    axes = estimates.precision(distance, {"near": curve, "far": 2.0 * curve}, "title")
    np.testing.assert_allclose([line.get_ydata() for line in axes.lines], [[1, math.nan, 4], [2, math.nan, 8]])
    assert (axes.get_ylabel(), axes.get_ylim()) == ("standard error of depth (mm)", pytest.approx((0.7, 12.0)))
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["near", "far"]


def test_numbers_of_standard_errors_have_no_powers_of_ten_and_nothing_known_none():
    nothing = estimates.maps(np.full((4, 4), np.nan), np.full((4, 4), np.inf), None)
    assert "known at 0 %" in nothing.axes[0].get_title()
    for empty in (nothing, estimates.precision(IMAGE[0], {"": np.full(5, np.inf)}, "nothing").figure):
        empty.canvas.draw()
    errors = np.geomspace(0.8e-3, 5e-3, 48).reshape(6, 8)
    figure = estimates.maps(1000.0 * errors, errors, None)
    figure.canvas.draw()
    bar = figure.axes[-1]
    ticks = [*bar.yaxis.get_majorticklabels(), *bar.yaxis.get_minorticklabels()]
    texts = {tick.get_text() for tick in ticks if tick.get_text()}
    assert {"1", "2", "3", "5"} <= texts
    assert all(re.fullmatch(r"[\d.]+", text) for text in texts)
    assert bar.get_ylabel() == "standard error of depth (mm)\n(colours: logarithm)"


def test_error_bars_are_as_long_as_the_errors_and_stand_beside_as_numbers():
    terms = ["a", "b", "c"], [1.0, -2.0, 3.0], [0.25, math.inf, 0.04], "um"
    figure = estimates.fit(IMAGE[None], IMAGE[None], 0.0 * IMAGE[None], terms, "fit", ["star"])
    (graph,) = [axes for axes in figure.axes if axes.containers]
    bars = next(each for each in graph.containers if hasattr(each, "has_xerr")).lines[2][0]
    ends = [[[0.75, 0], [1.25, 0]], [[-2.0, 1], [-2.0, 1]], [[2.96, 2], [3.04, 2]]]
    np.testing.assert_allclose(bars.get_segments(), ends, rtol=1e-12)
    assert [text.get_text() for text in graph.texts] == ["1.00 ± 0.25", "−2 ± ∞", "3.000 ± 0.040"]
    assert all(1.0 < text.get_position()[0] < 1.1 for text in graph.texts)
    assert graph.get_title() == "fit\nfitted coefficients ± standard errors"
    assert "residual / noise" in {axes.get_ylabel() for axes in figure.axes}


def test_residuals_of_stacks_are_drawn_in_units_of_the_noise():
    pair = IMAGE, IMAGE[:3]
    axes = estimates.projections([("", [pair, pair, (IMAGE - 9.0, IMAGE[:3])])], (1e-6, 1e-6), "").axes
    assert (axes[-1].get_ylabel(), axes[2].images[0].get_clim()) == ("residual / noise", (-5.0, 5.0))
    np.testing.assert_array_equal(axes[2].images[0].get_array(), IMAGE - 9.0)


def test_residuals_of_stars_are_drawn_in_units_of_their_photon_noise():
    model, place = np.tile(4.0 * IMAGE, (1, 1, 1, 1)), np.zeros(1)
    estimates._stars(figure := Figure(), (model + 6.0, model), (place, place, place == 0.0))
    assert figure.axes[-1].get_ylabel() == "residual / photon noise"
    shown = figure.axes[10].images[0].get_array()
    np.testing.assert_allclose(shown, 6.0 / np.sqrt(np.maximum(4.0 * IMAGE, 1.0)), rtol=1e-12)


@pytest.mark.parametrize("rejected", [False, True])
def test_terms_over_the_sensor_are_drawn_with_the_median_of_their_errors(rejected, monkeypatch):
    monkeypatch.setattr(estimates, "_stars", lambda *_: None)
    maps = [("a term of twenty-two l", IMAGE - 20.0, np.linspace(0.1, 0.5, 9))]
    maps += [("a term of twenty three l", 0.0 * IMAGE, np.array([1.0, 2.0, 70.0]))]
    x, used = np.linspace(-1e-3, 1e-3, 5), np.array([True, True, not rejected, True, True])
    figure = estimates.field(maps, (x, x, "m"), (x, x, np.ones(5), used), (IMAGE, IMAGE), "nm", "")
    first, second, stars = figure.axes[:3]
    assert first.get_title() == "a term of twenty-two l\n± 0.3"
    assert second.get_title() == "a term of twenty three\nl\n± 2"
    assert first.images[0].get_clim() == (-20.0, 20.0)
    assert -1e-9 < second.images[0].get_clim()[0] < 0.0 < second.images[0].get_clim()[1] < 1e-9
    assert stars.get_title() == "stars, chi2" + "\ncrosses: rejected" * rejected
    assert figure.subfigs[0].get_suptitle() == "Zernike terms over the sensor (nm rms), ± median standard error"


def test_a_molecule_is_as_wide_as_the_root_mean_square_of_its_errors():
    rows = np.array([(15.25, 15.25, 1.5, 2.0)], [(name, float) for name in ("x", "y", "x_error", "y_error")])
    profile = estimates.rendered(rows, (30.5, 30.5), 0.5, np.ones((1, 3)))[30, 30:, 0] ** 2
    # sqrt((9 + 16) / 2) = 3.54 pixels, of the widths 2.83 and 4 nearer to 4
    assert profile[9] / profile[6] == pytest.approx(math.exp(-(81 - 36) / 32), rel=1e-3)
