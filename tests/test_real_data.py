"""The page of real data: its sets, what is judged wrong, and that it is written from what was measured."""

from __future__ import annotations

import math
import re
import shlex
import sys
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from benchmarks import real_data, real_sets
from benchmarks.real_data import Result, Set, judged, load, number, page, summary, table
from benchmarks.real_sets import Row

SETS = load()
ROOT = Path(__file__).resolve().parent.parent


def verdict_of(status: str, severity: str = "note", text: str = "") -> dict[str, object]:
    """Return what a command prints of its verdict."""
    findings = [{"severity": severity, "text": text}] if text else []
    return {"status": status, "reliable": status == "converged", "findings": findings}


def a_set(key: str = "x", **more: object) -> Set:
    """Return a set without files."""
    plain = {"title": "A set", "task": "a task", "unit": "nm", "data": "Data.", "picture": "a.png"}
    return Set(**{"key": key, **plain, "steps": ["lommel sfr a.tif"], "says": ["Said."], "files": {}} | more)


def test_the_page_is_written_from_what_was_measured_of_every_set():
    kept = real_data.kept()
    assert set(kept) == {one.key for one in SETS}
    assert real_data.PAGE.read_text(encoding="utf-8") == page(SETS, kept)


def test_no_result_is_wrong_and_called_good():
    assert [key for key, one in real_data.kept().items() if one.is_wrong_and_good] == []


def test_every_file_has_a_public_address_at_a_commit_a_checksum_and_a_place_of_its_own():
    files = [file for one in SETS for file in one.files.values()]
    for file in files:
        assert re.fullmatch(r"[0-9a-f]{40}", file.commit), file
        assert re.fullmatch(r"[0-9a-f]{64}", file.sha256), file
        assert re.fullmatch(r"https://raw\.githubusercontent\.com/[\w-]+/[\w-]+/[0-9a-f]{40}/[\w./%-]+", file.url), (
            file
        )
    assert len({file.sha256 for file in files}) == len({file.name for file in files}) == len(files)


def test_every_set_has_measures_pictures_light_in_bytes_and_links_to_its_repositories():
    assert set(real_sets.MEASURE) == {one.key for one in SETS} >= set(real_sets.PREPARE)
    for one in SETS:
        assert (real_data.PICTURES / f"{one.key}.png").stat().st_size < 80_000, one.key
        assert len(one.says) <= 3
        commits = {file.commit for file in one.files.values()}
        assert commits == set(re.findall(r"\(https://github\.com/[\w/-]+/tree/(\w{40})\)", one.data))


@pytest.mark.parametrize("line", [step for one in SETS for step in one.steps if step.startswith("lommel ")])
def test_a_command_asks_for_its_files_and_for_nothing_else(line, call_lommel, tmp_path):
    # Without these it ends at the first that is missing, having understood all of its options.
    result = call_lommel(*shlex.split(line.replace("\\\n", " "))[1:], folder=tmp_path)
    assert result.returncode == 2
    assert "No such file" in result.stderr or "does not exist" in result.stderr or "no file" in result.stderr


@pytest.mark.parametrize(
    ("status", "values", "wrong"),
    [
        ("converged", [(1.0, 1.0, 0.1), (1.0, 1.39, 0.1)], False),
        ("converged", [(1.0, 1.41, 0.1)], True),
        ("converged", [(1.0, 0.59, 0.1)], True),
        ("converged", [(1.0, 1.0, math.nan)], True),
        ("converged", [(1.0, math.nan, 0.1)], True),
        ("doubtful", [(1.0, 9.0, 0.1)], False),
        ("misfit", [(1.0, math.nan, math.nan)], False),
    ],
)
def test_a_good_result_is_wrong_beyond_four_standard_errors_or_without_any(status, values, wrong):
    result = judged([Row("a", *each) for each in values], [verdict_of(status), {"crop": [1, 2]}])
    assert result.is_wrong_and_good is wrong
    assert result.reliable is (status == "converged")


def test_one_good_verdict_among_others_is_enough_to_be_wrong():
    result = judged([Row("a", 0.0, 9.0, 1.0)], [verdict_of("misfit", "error", "chi2"), verdict_of("converged")])
    assert result.is_wrong_and_good
    assert result.said == ["chi2"]
    assert result.worst == 9.0


def test_the_headline_counts_every_set():
    rows = [Row("a", 0.0, 9.0, 1.0), Row("b", 0.0, 1.0, 1.0)]
    results = {
        "x": judged(rows, [verdict_of("converged")]),
        "y": judged(rows[:1], [verdict_of("misfit", "error", "chi2")]),
        "z": judged(rows[1:], [verdict_of("converged")]),
    }
    lines = summary([a_set("x"), a_set("y"), a_set("z"), a_set("not measured")], results)
    assert lines[0].startswith("3 sets, 4 numbers: 2 called good, 1 of them wrong. In 2 a number is off by more than")
    cells = [line.split(" | ") for line in lines[4:]]
    assert [(each[2], each[3], each[4], each[5]) for each in cells] == [
        ("2", "9.0", "good", "**yes** |"),
        ("1", "9.0", "misfit", "no |"),
        ("1", "1.0", "good", "no |"),
    ]


def test_rows_have_the_digits_of_their_errors():
    rows = [Row("a", 12.3456, 12.5, 0.123), Row("b", 1234.5, 1200.0, 45.0), Row("c", 30.0, 31.0, math.nan)]
    assert table(Result(rows, [], False), "nm")[2:] == [
        "| a | 12.35 | 12.50 ± 0.12 | 1.3 |",
        "| b | 1234 | 1200 ± 45 | -0.8 |",
        "| c | 30 | 31 | – |",
    ]
    assert number(math.nan) == "–"


def test_results_are_stored_and_read(tmp_path, monkeypatch):
    monkeypatch.setattr(real_data, "KEPT", tmp_path / "kept.json")
    assert real_data.kept() == {}
    rows = [Row("a", 1.234567890123, 2.0, 0.5), Row("b", 3.0, 4.0, math.nan)]
    real_data.keep({"x": Result(rows, ["misfit"], False, ["chi2"], 12.4)})
    (again,) = real_data.kept().values()
    assert again.rows[0] == Row("a", 1.23456789, 2.0, 0.5)
    assert math.isnan(again.rows[1].error)
    assert (again.statuses, again.said, again.seconds) == (["misfit"], ["chi2"], 12)


def test_without_a_network_a_sentence_says_where_files_may_lie(monkeypatch):
    class Cache:
        def fetch(self, name: str) -> str:
            raise ConnectionError("no route")

    pooch = ModuleType("pooch")
    pooch.os_cache = lambda name: name
    pooch.create = lambda **options: Cache()
    monkeypatch.setitem(sys.modules, "pooch", pooch)
    file = real_data.File("a/b", "0" * 40, "c d.tif", "1" * 64)
    with pytest.raises(SystemExit, match=r"a/b/0{40}/c%20d\.tif .*no route.*LOMMEL_REAL_DATA .* a/b/c d\.tif"):
        real_data.fetched([file])


def test_pooch_is_given_addresses_checksums_and_the_folder(monkeypatch):
    given = {}

    class Cache:
        def fetch(self, name: str) -> str:
            return f"/cache/{name}"

    def create(**options):
        given.update(options)
        return Cache()

    pooch = ModuleType("pooch")
    pooch.os_cache = lambda name: name
    pooch.create = create
    monkeypatch.setitem(sys.modules, "pooch", pooch)
    file = real_data.File("a/b", "0" * 40, "c.tif", "1" * 64)
    assert real_data.fetched([file]) == [Path("/cache/a/b/c.tif")]
    assert given["registry"] == {"a/b/c.tif": "1" * 64}
    assert given["urls"] == {"a/b/c.tif": f"https://raw.githubusercontent.com/a/b/{'0' * 40}/c.tif"}
    assert given["env"] == "LOMMEL_REAL_DATA"


def test_without_pooch_a_sentence_says_how_it_is_installed(monkeypatch):
    monkeypatch.setitem(sys.modules, "pooch", None)
    with pytest.raises(SystemExit, match=r"make \.venv/real\.stamp"):
        real_data.fetched([])


def test_iso_12233_gives_the_response_of_a_gaussian_edge():
    from scipy.special import ndtr

    angle, sigma = math.radians(7.0), 0.9
    y, x = np.mgrid[:120, :64]
    image = 20.0 + 200.0 * ndtr(((x - 31.7) * math.cos(angle) - (y - 60.0) * math.sin(angle)) / sigma)
    frequencies = np.array(real_sets._FREQUENCIES)
    exact = np.exp(-2.0 * (math.pi * sigma * frequencies) ** 2)
    for turned in (image, image.T):
        assert real_sets.iso_12233(turned) == pytest.approx(exact, abs=0.01)


def test_changes_of_terms_have_the_sign_of_lommel_and_the_errors_of_both_pairs():
    names = list(real_sets._NOLL.values())
    pairs = [{"coefficients": dict.fromkeys(names, k), "errors": dict.fromkeys(names, 0.3)} for k in (1.0, 2.0)]
    rows = list(real_sets.change_of_terms(pairs))
    nm = 670.0 / (2.0 * math.pi)
    assert [row.value for row in rows] == pytest.approx([nm] * 7)
    assert rows[0].error == pytest.approx(0.3 * math.sqrt(2.0) * nm)
    assert rows[1].reference == pytest.approx(137.7 - 42.6, abs=0.1)


def test_positions_are_matched_in_their_frame_within_a_pixel():
    found = {
        "frame": np.array([0.0, 0.0, 1.0]),
        "x": 1e-7 * np.array([5.1, 9.0, 5.0]),
        "y": 1e-7 * np.array([3.0, 3.0, 7.5]),
        "x_error": np.full(3, 1e-9),
        "y_error": np.full(3, 2e-9),
    }
    known = np.array([0.0, 0.0, 1.0]), np.array([5.0, 7.0, 5.0]), np.array([3.0, 3.0, 3.0])
    count, x, y = real_sets.position_rows(found, 1e-7, known, "P")
    assert (count.reference, count.value) == (3, 1)
    assert (x.value, x.error) == (pytest.approx(0.1), pytest.approx(0.01))
    assert (y.value, y.error) == (pytest.approx(0.0), pytest.approx(0.02))
