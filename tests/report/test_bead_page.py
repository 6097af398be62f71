"""Report on beads: the table that grows, and a page that has all of it without scripts."""

from __future__ import annotations

import re

import numpy as np
import pytest

from lommel.report import bead_page
from lommel.report.bead_page import page, read_csv, write_csv


def rows(date="2026-12-01", wave=5.2e-7, count=5):
    """Return rows of beads on a circle."""
    pair = {"gauss_x": 2.6e-7, "gauss_y": 2.7e-7, "gauss_z": 8e-7, "asymmetry": 0.97, "strehl": 0.82, "height": 4e-9}
    return [
        {"bead": f"<b>{k}", "file": "field.tif", "date": date, "verdict": "converged", "wavelength": wave}
        | {"joint_fit": f"joint {wave}"}
        | {"x": 1e-5 * k, "y": 1e-5 * (k * k % 3), "chi2": 1.0, "noll 5 astigmatism 45": 0.1, "rms": None}
        | {"x_error": 2e-9, "y_error": 2e-9, "focus": 1e-7 + 1e-8 * k, "focus_error": 3e-9, "z": None}
        | {"x_psf": 1e-5 * k, "x_psf_error": 2e-9, "x_psf_common": 1e-9}
        | {"reason": "drift = 0.3 +- 0.1" if k == 2 else None}
        | {name: value * (1.0 + 0.01 * k) for name, value in pair.items()}
        | {f"{name}_error": 0.01 * value for name, value in pair.items()}
        for k in range(count)
    ]  # fmt: skip


def test_a_table_is_read_as_it_was_written(tmp_path):
    beads = rows()
    write_csv(tmp_path / "table.csv", beads)
    head = (tmp_path / "table.csv").read_text().split("\n")[0].split(",")
    assert {"gauss_x (nm)", "gauss_x (nm)_error", "noll 5 astigmatism 45 (rad)", "strehl"} <= {*head}
    for found, bead in zip(read_csv(tmp_path / "table.csv"), beads, strict=True):
        assert found == {name: pytest.approx(value, rel=1e-12) if isinstance(value, float) else value
                         for name, value in bead.items()}  # fmt: skip


@pytest.mark.parametrize("text", ["", "a,b\n1,2\n", "bead,file,date,verdict,wavelength\nx,y,2026-12-01,ok,red\n"])
def test_another_table_is_refused(tmp_path, text):
    (tmp_path / "table.csv").write_text(text)
    with pytest.raises(ValueError, match=r"table\.csv"):
        read_csv(tmp_path / "table.csv")


def test_a_page_has_tables_maps_shifts_and_the_trend_of_all_dates():
    red = [row | {"file": "2026-12-01_green.tif"} for row in rows(wave=6.1e-7)]
    both = [*rows("2026-11-01"), *rows(), *red]
    text = page("Beads: <lens>", [("files", "a & b")], both, ["a note"])
    assert not re.search(r"<script|https?://(?!www\.w3\.org|purl|creativecommons|matplotlib)|<b>|<lens>", text)
    assert text.count("<svg") == 4  # maps of two channels, curves, trend
    titles = re.findall(r"<h2>(.*?)</h2>", text)
    assert titles == [
        "Verdicts", "Widths, Strehl ratio, wavefront", "Over the field", "Chromatic shifts", "Trend", "Beads",
        "Notes",
    ]  # fmt: skip
    for part in (
        "520 nm: focal surface (stage position), 5 beads",
        "610 nm: focal surface (stage position), 5 beads",
        "tilt along x",
        "joint 5.2e-07",
        "joint 6.1e-07",
        "5 converged",
        '<span class="date">2026-11-01</span>',
        '<span class="date">2026-12-01</span><wbr>_green.tif',
        "scatter of heights about this surface, in their errors",
        ": as errors allow, below ",
        "5 converged; &lt;b&gt;2 (chi2 1.000): drift = 0.3 +- 0.1",
        "mean of 5",
        "shift x, PSF (nm)",
        "0.0 ± 1.8",  # two errors of 1.7 nm each over 5 beads, and 1.4 nm that beads share
        "610 nm − 520 nm",
        "currentColor",
        "a &amp; b",
    ):
        assert part in text, part
    assert "Details are those of 2026-12-01. Of 2026-11-01 the page has the trend, and the table all beads." in text
    alone = page("Beads", [], rows(count=1), [])
    assert "Details" not in alone
    assert not re.search(r"Chromatic shifts</h2>|Trend|focal surface", alone)
    assert "520 nm: no tilt or field curvature: they need 5 beads with heights, not all on a line." in alone


def test_a_scatter_that_errors_do_not_explain_has_its_meaning():
    tilted = [row | {"height": 1e-7 * (-1) ** k} for k, row in enumerate(rows(count=8))]
    text = page("Beads", [], tilted, [])
    assert re.search(r": beads lie at several heights \(errors alone: below [\d.]+\), which .*</td><td>\d{3,}", text)


def test_a_mean_of_equal_beads_has_the_error_of_their_errors():
    equal = [row | {"gauss_x": 2.6e-7, "gauss_x_error": 2.6e-9} for row in rows()]
    assert "260.0 ± 1.2" in page("Beads", [], equal, [])


def test_the_trend_has_the_error_that_all_beads_of_a_date_share(monkeypatch):
    monkeypatch.setattr(bead_page.estimates, "bead_curves", list)
    monkeypatch.setattr(bead_page.estimates, "bead_maps", lambda *_: None)
    monkeypatch.setattr(bead_page, "_figure", lambda _: "")
    both = [
        row | {"strehl": 0.9, "strehl_error": 0.03, "strehl_common": 0.03} for row in [*rows("2026-11-01"), *rows()]
    ]
    trend = page("Beads", [], both, []).split("<h2>Trend</h2>")[1].split("<h2>")[0]
    assert trend.count("<td>0.900 ± 0.030</td>") == 2


def test_distances_count_from_the_middle_of_all_channels(monkeypatch):
    seen = []
    monkeypatch.setattr(bead_page.estimates, "bead_curves", seen.extend)
    monkeypatch.setattr(bead_page, "_figure", lambda _: "")
    few = rows(wave=6.1e-7)[:1]
    page("Beads", [], [*rows(), *few], [])
    x, y = (np.array([row[key] for row in [*rows(), *few]]) for key in "xy")
    away = 1e6 * np.hypot(x - x.mean(), y - y.mean())
    series = seen[0][3]
    np.testing.assert_allclose(series["x, 520 nm"][0], away[:5])
    np.testing.assert_allclose(series["x, 610 nm"][0], away[5:])


def test_means_and_trend_are_of_the_same_beads_for_both_kinds_without_those_left_out(monkeypatch):
    monkeypatch.setattr(bead_page, "_figure", lambda _: "")
    beads = [row | {"fwhm_x": 2.0e-7, "fwhm_x_error": 2e-9, "fwhm_y": 2.1e-7, "fwhm_z": 7e-7} for row in rows()]
    touching = {"verdict": "left out", "fwhm_x": None, "fwhm_y": None, "fwhm_z": None, "gauss_x": 5e-7}
    unfit = {"verdict": "misfit", "fwhm_x": None, "fwhm_y": None, "fwhm_z": None, "gauss_x": 6e-7}
    day = [*beads, rows()[0] | touching, rows()[1] | unfit]
    alone, text = (page("Beads", [], [*rows("2026-11-01"), *some], []) for some in (beads, day))
    for heading in ("Widths, Strehl ratio, wavefront", "Trend"):
        first, second = (one.split(f"<h2>{heading}</h2>")[1].split("<h2>")[0] for one in (alone, text))
        assert first == second
    trend = text.split("<h2>Trend</h2>")[1].split("<h2>")[0]
    assert "<th>FWHM x, PSF (nm)</th><th>FWHM y, PSF (nm)</th>" in trend
    assert "<td>200.00 ± 0.89</td>" in trend
    # Where no fit converged, Gaussians are those of all beads that were not left out.
    unknown = page("Beads", [], [rows()[0] | touching, *rows()], [])
    assert "<td>FWHM x, Gaussian (nm)</td><td>265.2" in unknown


def test_each_mean_has_the_number_of_its_values(monkeypatch):
    monkeypatch.setattr(bead_page, "_figure", lambda _: "")
    red = [row | ({"x_psf": None} if k < 2 else {}) for k, row in enumerate(rows(wave=6.1e-7))]
    text = page("Beads", [], [*rows(), *red], [])
    assert re.search(r"<td>mean of 5</td><td>610 nm − 520 nm</td><td>[^<]*\(3 beads\)</td>", text)
    assert text.count(" beads)</td>") == 1


def test_verdicts_are_a_few_words_and_their_texts_are_below(monkeypatch):
    monkeypatch.setattr(bead_page, "_figure", lambda _: "")
    reason = "the model misses 2 % of the light; errors hold between exposures"
    joint = {"joint_fit": f"converged, but in doubt: {reason}", "joint_codes": "missed light, pattern"}
    doubtful = {"verdict": "doubtful", "reason": f"{reason} of this set-up", "codes": "missed light"}
    refused = {"bead": "other.tif", "file": "other.tif", "date": "2026-12-01", "wavelength": 5.2e-7}
    beads = [row | joint | (doubtful if k > 2 else {}) for k, row in enumerate(rows())]
    beads += [rows()[0] | joint | {"verdict": "left out"}, refused | {"verdict": "refused", "reason": "no bead"}]
    beads += [row | {"file": "bad.tif", "joint_fit": "misfit: chi2 30", "verdict": "misfit"} for row in rows()]
    text = page("Beads", [], beads, [])
    table, full = text.split("<h2>Verdicts</h2>")[1].split("<h2>")[0].split("<details>")
    cells = re.findall(r"<td>([^<]*)</td>", table)
    assert "✓ good 3; ? in doubt 2: missed light 2; left out 1" in cells
    assert "? in doubt: missed light, pattern" in cells
    assert cells[-2:] == ["× wrong, misfit 5", "× wrong, misfit"]
    assert max(map(len, cells)) < 80
    assert reason in full
    assert "refused; all: no bead" in full.replace("1 refused", "refused")
