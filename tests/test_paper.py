"""Every figure and number of the paper."""

from __future__ import annotations

import csv
import io
import json
import math
from itertools import pairwise

import numpy as np
import pytest
import scipy.special

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


def test_errors_of_forms_of_j0_are_drawn_as_they_are_and_none_at_1e_17():
    data = paper.bessel_forms(samples=4, max_a=8.0)
    errors = {name: data.columns[name] - scipy.special.j0(np.geomspace(0.05, 8.0, 4)) for name in paper._BESSEL}
    for name, error in errors.items():
        np.testing.assert_allclose(data.columns[f"error of {name}"], error, atol=1e-14)
        assert data.facts["largest_errors"][name] == pytest.approx(np.abs(error).max(), rel=1e-9)
        data.columns[f"error of {name}"][1] = 0.0
    right = paper.draw_bessel_forms(data).axes[1]
    for line, error in zip(right.lines, errors.values(), strict=False):
        np.testing.assert_allclose(
            line.get_ydata(), [abs(error[0]), 1e-17, *np.abs(error[2:])], rtol=1e-6, atol=1e-18
        )
    assert (right.get_xlim(), right.get_ylim()) == (pytest.approx((0.05, 8.0)), (1e-7, 3.0))
    assert (right.get_ylabel(), right.get_title()) == ("absolute error", "errors of the approximations")


def test_errors_of_images_are_drawn_as_their_differences_from_the_exact_one():
    data, images = paper.compare_with_fft(Setting(shape=10)), Setting(shape=10).images()
    *_, slices, errors = (figure := paper.draw_comparison(data)).axes
    lines = {line.get_label(): line.get_ydata() for line in errors.lines}
    for name in ("fft", *VARIANTS):
        row = images[name][5, 5:] - images["exact"][5, 5:]
        np.testing.assert_allclose(lines[paper._LABELS[name]], row, atol=1e-9)
        assert data.facts[name].get("peak_error_of_slice", np.abs(row).max()) == pytest.approx(np.abs(row).max())
        away = images[name] - images["exact"]
        assert data.facts[name]["mse"] == pytest.approx(np.mean(away**2), rel=1e-3)
        assert data.facts[name]["peak_error"] == pytest.approx(np.abs(away).max(), rel=1e-3)
    assert errors.get_xlim() == slices.get_xlim() == (0.0, data.columns["v"][-1])
    assert (errors.get_ylabel(), len(figure.axes)) == ("error / peak, along the slice", 7)


@pytest.mark.parametrize("errors", [False, True])
def test_of_a_varied_parameter_images_are_drawn_or_their_errors(errors):
    data = paper.vary("terms", Setting(shape=10), (10, 30))
    *pictures, bar = (figure := paper._draw_errors(data) if errors else paper.draw_varied(data)).axes
    for axes, (variant, k) in zip(pictures, [(v, k) for v in VARIANTS for k in (0, 1)], strict=True):
        image, exact = (data.arrays[f"{name}_{(10, 30)[k]}"] for name in (variant, "exact"))
        shown = image - exact if errors else image
        np.testing.assert_allclose(axes.images[0].get_array(), shown, atol=1e-6)
        told = f": MSE {data.facts['panels'][k][variant]['mse']:.3g}\nlargest {np.abs(shown).max():.2f}"
        assert axes.get_title() == f"N = {(10, 30)[k]}" + told * errors
        assert axes.images[0].norm.vmin == (-axes.images[0].norm.vmax if errors else 0.0)
    assert bar.get_ylabel() == ("error" if errors else "intensity") + " / exact peak"
    assert figure.get_suptitle().startswith("CFIS minus exact PSF, C_d" if errors else "CFIS, C_d")
    assert ("−0.1" in [text.get_text() for text in bar.get_yticklabels()]) == errors


def test_costs_are_drawn_with_the_error_at_the_largest_size():
    none = [[math.nan] * 2] * 5
    ratio, error = np.array([[2.0, 3.0], [4.0, math.nan], *none]), np.array([[0.1, 0.0], [0.2, math.nan], *none])
    arrays = {"n": np.array([64, 512]), "methods": np.array([*paper._STYLES]), "ratio": ratio, "peak_error": error}
    right = paper.draw_methods_cost(paper.FigureData("", arrays, {})).axes[1]
    assert [line.get_xydata().tolist() for line in right.lines] == [[[3.0, 1e-17]], [[4.0, 0.2]]]
    assert [(text.get_text(), text.xy) for text in right.texts[:-1]] == [("n = 64", (4.0, 0.2))]


def test_errors_of_pieces_are_differences_of_phasors_and_drawn_down_to_a_millionth():
    data, rho = paper.quartic_phase(samples=20, max_pieces=1), (np.arange(20) + 0.5) / 20
    phases = [paper.fit_quartic(kind, 10.0).phase(rho) - 10.0 * rho**4 for kind in VARIANTS]
    found = np.array([data.arrays[f"{kind} error"] for kind in VARIANTS])
    np.testing.assert_allclose(found, 2.0 * np.abs(np.sin(0.5 * np.array(phases))), atol=1e-12)
    assert not np.any(data.arrays["printed_gamma"])
    assert data.arrays["mse_linear_printed"][0] > data.facts["printed"]["mse"]
    for kind in VARIANTS:
        data.arrays[f"{kind} error"][0] = 0.0
    for line, kind, error in zip(paper.draw_quartic_phase(data).axes[1].lines, VARIANTS, found, strict=True):
        np.testing.assert_allclose(line.get_ydata(), [1e-6, *error[1:]], rtol=1e-9)
        assert line.get_label().endswith(f"MSE {data.facts[kind]['mse']:.3g}")


def test_windows_within_a_hundredth_of_the_papers_number_are_counted(monkeypatch):
    sizes = dict(zip((100.0, 110.0, 120.0, 130.0, 140.0), (1.006, 0.993, 1.015, 0.985, 1.03), strict=True))
    monkeypatch.setattr(paper, "WINDOWS", np.array(list(sizes)))
    monkeypatch.setattr(paper, "_slice_error", lambda setting, _: 0.368 * sizes[setting.window])
    mean, slices = paper._first_rows(Setting(shape=10))
    assert "at 2 of the 5 windows" in slices["remark"]
    closest, errors = mean["closest"]["printed"], paper.squared_errors(Setting(window=140.0), "printed")
    assert closest["value"] == pytest.approx(paper.mean_over_window(errors, closest["at"]["window"]), rel=1e-9)
    assert paper._closest("x", np.array([1.0, 2.0, 3.0]), [3.4, 1.1, 5.0], 2.0) == {"value": 3.4, "at": {"x": 1.0}}
