"""Every figure and number of the paper."""

from __future__ import annotations

import csv
import io
import json
import math
from itertools import pairwise

import numpy as np
import pytest

import lommel as lm
import make_paper
from lommel.measures.errors import mse
from lommel.optics.grid import Grid
from lommel.paper import figures as paper
from lommel.paper.figures import VARIANTS, Setting

SMALL = Setting(shape=96)


@pytest.fixture(scope="module")
def table():
    return {row["quantity"]: row for row in paper.rows()}


def test_the_window_is_what_the_setting_says():
    assert SMALL.v[-1] == pytest.approx(145.0 * 47 / 48)
    assert Grid(96, SMALL.pixel).step(lm.Pupil()) == pytest.approx(145.0 / 48)


@pytest.mark.parametrize("window", [100.0, 145.0, 185.0])
def test_the_fft_of_the_paper_is_as_large_as_the_image(window):
    setting = Setting(window=window)
    stride, side, spacing = setting.fft()._layout(lm.Pupil(lm.Wavefront(10.0)), Grid(512, setting.pixel))
    assert (stride, side) == (1, 512)
    assert 1.0 / spacing == pytest.approx(window / math.pi)


def test_the_first_headline_comes_out_as_printed_within_15_percent(table):
    row = table["MSE at C_d = 10, TLC = 100, N = 30"]
    assert row["printed"] == pytest.approx(row["paper"], rel=0.15)
    assert row["against_fft"] == pytest.approx(row["paper"], rel=0.15)
    assert row["corrected"] > 1.5 * row["paper"]


def test_peak_errors_are_of_the_size_of_the_papers(table):
    row = table["peak error of the slice"]
    assert row["printed"] == pytest.approx(row["paper"], rel=0.15)
    assert row["closest"]["printed"]["value"] == pytest.approx(row["paper"], rel=0.01)


def test_the_tangent_line_centre_lowers_the_error_as_printed_and_raises_it_when_corrected(table):
    near, far = (table[f"MSE of strong defocus at TLC = {t}"] for t in (100, 200))
    assert near["printed"] == pytest.approx(near["paper"], rel=0.35)
    assert far["printed"] == pytest.approx(far["paper"], rel=0.15)
    assert near["printed"] > 6.0 * far["printed"]
    assert near["corrected"] < far["corrected"]


def test_five_quadratics_reach_the_papers_error_without_a_constant_and_a_tenth_of_it_with(table):
    row = table["MSE of 5 quadratic exponentials"]
    assert row["printed"] <= 1.4e-4
    assert row["corrected"] <= 1.5e-5
    assert row["closest"]["printed"]["value"] == pytest.approx(row["paper"], rel=0.02)


def test_where_the_search_says_a_number_is_closest_the_image_has_that_number(table):
    row = table["MSE of strong defocus at TLC = 100"]
    for variant in VARIANTS:
        closest = row["closest"][variant]
        setting = Setting(**closest["at"])
        exact = setting.image(lm.methods.Hankel())
        assert mse(setting.image(setting.closed_form(variant)), exact) == pytest.approx(closest["value"], rel=0.03)


def test_the_mean_over_a_square_of_one_is_one_and_of_v_squared_two_thirds_of_the_window_squared():
    v = (np.arange(20_000) + 0.5) * 0.01
    assert paper.mean_over_window((v, np.ones_like(v)), 100.0) == pytest.approx(1.0)
    assert paper.mean_over_window((v, v**2), 100.0) == pytest.approx(2.0e4 / 3.0, rel=1e-4)


def test_errors_of_the_comparison_are_those_of_its_images():
    data = paper.compare_with_fft(SMALL)
    exact = lm.psf(lm.Pupil(lm.Wavefront(10.0)), 96, SMALL.pixel, method="hankel", normalize="strehl")
    np.testing.assert_allclose(data.arrays["exact"], exact.values / exact.values.max(), atol=1e-6)
    for variant in VARIANTS:
        error = data.arrays[variant] - data.arrays["exact"]
        assert data.facts[variant]["mse"] == pytest.approx(np.mean(error**2), rel=1e-3)
        assert data.facts[variant]["peak_error"] == pytest.approx(np.abs(error).max(), rel=1e-3)
    assert data.facts["fft"]["mse"] < 0.1 * data.facts["printed"]["mse"]


def test_rings_at_the_edge_fade_as_the_series_of_erf_gets_longer():
    data = paper.vary("terms", SMALL)
    for variant in VARIANTS:
        rims = [data.arrays[f"{variant}_{n}"][0].mean() for n in paper.VARIED["terms"].values]
        assert all(later < earlier for earlier, later in pairwise(rims))
        errors = [panel[variant]["mse"] for panel in data.facts["panels"]]
        assert errors == sorted(errors, reverse=True)


def test_strong_defocus_is_worse_as_printed():
    panels = paper.vary("defocus", SMALL).facts["panels"]
    errors = [panel["printed"]["mse"] for panel in panels if panel["defocus"] >= 10]
    assert errors == sorted(errors)


def test_forms_of_j0_agree_where_each_is_meant_to_hold():
    c = paper.bessel_forms(samples=301).columns
    assert np.abs(c["error of series"][c["a"] <= 1.0]).max() < 5e-4
    assert np.abs(c["error of asymptotic"][c["a"] > 50.0]).max() < 5e-4
    beyond = c["a"] > 1.0
    ratio = c["corrected"][beyond] / c["printed"][beyond]
    np.testing.assert_allclose(ratio, math.sqrt(2.0 / math.pi))


def test_costs_are_ratios_to_one_fft_and_a_method_over_its_budget_is_left_out():
    data = paper.methods_cost(sizes=(16, 32), budget=0.0)
    names = list(data.arrays["methods"])
    assert np.all(data.arrays["ratio"][:, 0] > 0)
    assert np.all(np.isnan(data.arrays["ratio"][:, 1]))
    errors = dict(zip(names, data.arrays["peak_error"][:, 0], strict=True))
    assert errors["Hankel"] < 1e-8
    assert errors["NijboerZernike"] < 1e-6
    assert 0.01 < errors["CFIS, Eq. (14), N = 30"] < 0.6
    assert errors["Huygens, every pixel"] == pytest.approx(errors["Huygens, every radius"], rel=1e-3)


def test_pieces_of_the_quartic_phase_are_worse_by_their_mse_only():
    data = paper.quartic_phase(samples=4000, max_pieces=5)
    for kind in ("printed", "corrected"):
        mean = np.mean(data.columns[f"{kind} error"] ** 2)
        assert data.facts[kind]["mse"] == pytest.approx(mean, rel=1e-2)
    assert not np.any(data.arrays["printed_gamma"])
    assert data.arrays["mse_linear_printed"][4] == pytest.approx(data.facts["printed"]["mse"])


@pytest.mark.parametrize(
    ("data", "draw", "panels"),
    [
        (lambda: paper.methods_cost(sizes=(16,), budget=0.0), paper.draw_methods_cost, 2),
        (lambda: paper.bessel_forms(samples=51), paper.draw_bessel_forms, 2),
        (lambda: paper.compare_with_fft(SMALL), paper.draw_comparison, 7),
        (lambda: paper.vary("terms", SMALL, (10, 30)), paper.draw_varied, 5),
        (lambda: paper.vary("defocus", SMALL, (5.0, 20.0)), paper._draw_errors, 5),
        (lambda: paper.quartic_phase(samples=50, max_pieces=5), paper.draw_quartic_phase, 3),
    ],
    ids=["cost", "bessel", "comparison", "intensity", "error", "spherical"],
)
def test_every_figure_is_drawn_and_its_data_read_back(data, draw, panels):
    made = data()
    figure = draw(made)
    figure.canvas.draw()
    assert len(figure.axes) == panels
    assert all(axes.get_xlabel() or axes.images or axes.get_ylabel() for axes in figure.axes)
    with np.load(io.BytesIO(paper.archive(made)), allow_pickle=False) as file:
        assert set(file.files) == {*made.arrays, "description"}
        assert json.loads(str(file["description"]))["title"] == made.title
    rows = list(csv.reader(io.StringIO(paper.spreadsheet(made).decode())))
    assert rows[0] == list(made.columns)
    for k, values in enumerate(made.columns.values()):
        read = [math.nan if row[k] == "" else float(row[k]) for row in rows[1:]]
        np.testing.assert_allclose(read, values, rtol=1e-8)


def test_figures_are_written_as_picture_data_and_table(call_lommel, tmp_path):
    result = call_lommel("paper", "new/out", "--figure", 2, "--figure", "3", "--json", folder=tmp_path)
    assert (result.returncode, result.stderr) == (0, "")
    files = sorted(path.name for path in (tmp_path / "new" / "out").iterdir())
    assert files == sorted([*paper.names("2"), *paper.names("3")])
    assert (tmp_path / "new/out/figure-2.png").read_bytes().startswith(b"\x89PNG")
    facts = json.loads(result.stdout)
    assert list(facts["figures"]) == ["2", "3"]
    assert facts["table"] is None
    assert len(facts["files"]) == 6


TINY = paper._FigurePlan("tiny", lambda: paper.bessel_forms(51), paper.draw_bessel_forms)


def test_without_a_choice_all_figures_and_the_table_are_written(call_lommel, tmp_path, monkeypatch):
    tiny = dict.fromkeys(("1", "eq17"), TINY)
    monkeypatch.setattr(paper, "FIGURES", tiny)
    monkeypatch.setattr(paper, "WINDOWS", np.array([145.0, 150.0]))
    monkeypatch.setattr(paper, "DEFOCI", np.array([22.0]))
    monkeypatch.setattr(paper, "SPHERICALS", np.array([10.0]))
    result = call_lommel("paper", "out", folder=tmp_path)
    assert (result.returncode, result.stderr) == (0, "")
    wanted = {name for number in tiny for name in paper.names(number)} | set(paper.TABLE)
    assert {path.name for path in (tmp_path / "out").iterdir()} == wanted
    rows = json.loads((tmp_path / "out/table.json").read_text(encoding="utf-8"))["rows"]
    text = (tmp_path / "out/table.md").read_text(encoding="utf-8")
    for row in rows:
        assert row["quantity"] in text
        assert row["quantity"] in result.stdout
        assert paper.number(row["printed"]) in text


def test_the_page_opens_with_what_the_benchmarks_measured():
    opening = make_paper.INTRODUCTION.format(**make_paper.measured())
    assert (make_paper.DOCS / "paper.md").read_text(encoding="utf-8").startswith(opening)
