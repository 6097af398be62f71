"""Output of the command line: its width, and its bar."""

from __future__ import annotations

import io
import re
from pathlib import Path

import numpy as np
import pytest
import tifffile
from PIL import Image
from rich.console import Console

import lommel as lm
from lommel.cli import output as bars
from lommel.cli.main import COMMANDS
from lommel.imaging import blur as blur_module
from lommel.imaging import defocus_depth
from lommel.recorded import frames


@pytest.mark.parametrize("name", ["", *COMMANDS])
def test_help_fits_80_columns_without_a_broken_word(name, call_lommel, tmp_path, monkeypatch):
    shown = {}
    for width in (100, 80):
        monkeypatch.setenv("COLUMNS", str(width))
        shown[width] = call_lommel(*name.split(), "--help", folder=tmp_path).stdout
    assert max(map(len, shown[80].splitlines())) <= 80
    # Words with a hyphen may go on behind it, but not the names of options.
    assert set(re.split(r"[\s-]+", shown[80])) <= set(re.split(r"[\s-]+", shown[100]))
    assert not re.search(r"--[a-z-]*-$", shown[80], re.MULTILINE)
    summaries = shown[80].partition("Commands:")[2]
    assert "..." not in summaries


OBJECTIVES_PROGRESS = Path(__file__).resolve().parents[2] / "examples" / "objectives"
LENS = """\
[lens]
focal_length = "35 mm"
f_number = 4
focus_distance = "1.6 m"
wavelength = "540 nm"
[sensor]
pixel = "6 um"
"""
NOISE = ("--white", "5000000", "--read", "3")
LONG = {
    "blur": ("blur", "photo.png", "depth.npy", "lens.toml", "-o", "out.png"),
    "restore": (
        "restore", "photo.png", "depth.npy", "lens.toml", *NOISE, "--method", "total-variation", "-o", "out.png",
    ),
    "depth": (
        "depth", "photo.png", "photo.png", "lens.toml", "--focus", "1.5m", "--focus", "1.8m",
        "--between", "1.4m", "2m", *NOISE,
    ),
    "retrieve": ("retrieve", "star.tif", "lens.toml", "--read", "2", "--terms", "3"),
    "localize": ("localize", "movie.tif", "zeiss-63x-astigmatic.toml", "--read", "0", "-o", "a.csv"),
    "compare": ("compare", "lens.toml", "--shape", "5"),
    "paper": ("paper", "out", "--figure", "2", "--figure", "3"),
}  # fmt: skip


@pytest.fixture
def folder_of_progress(tmp_path):
    rng = np.random.default_rng(3)
    Image.fromarray(rng.integers(60, 180, (80, 96), dtype=np.uint8)).save(tmp_path / "photo.png")
    np.save(tmp_path / "depth.npy", np.linspace(1.5, 1.8, 80 * 96).reshape(80, 96))
    (tmp_path / "lens.toml").write_text(LENS)
    pupil = lm.load_instrument(tmp_path / "lens.toml").pupil()
    star = lm.psf(pupil, 15, 6e-6).values
    tifffile.imwrite(tmp_path / "star.tif", lm.Noise(read=2.0).record(1e5 * star, seed=1).astype(np.float32))
    movie = rng.poisson(5.0, (6, 24, 24)).astype(np.uint16)
    tifffile.imwrite(tmp_path / "movie.tif", movie, photometric="minisblack")
    objective = OBJECTIVES_PROGRESS / "zeiss-63x-astigmatic.toml"
    (tmp_path / objective.name).write_text(objective.read_text(encoding="utf-8"), encoding="utf-8")
    return tmp_path


@pytest.mark.parametrize("command", LONG)
def test_every_long_command_tells_rising_shares_of_its_work(call_lommel, folder_of_progress, monkeypatch, command):
    seen, console = [], Console(file=io.StringIO(), force_terminal=True, width=120)
    monkeypatch.setattr("rich.console.Console", lambda **_: console)
    monkeypatch.setattr(blur_module, "_BAND", 1)
    monkeypatch.setattr(defocus_depth, "_ROWS", 48)
    monkeypatch.setattr(frames, "BLOCK", 2 * 24 * 24)
    tell = bars.Steps.__call__

    def told(self, *given):
        tell(self, *given)
        (task,) = self._bar.tasks
        seen.append(task.percentage if task.total else None)

    monkeypatch.setattr(bars.Steps, "__call__", told)
    result = call_lommel(*LONG[command], folder=folder_of_progress)
    assert result.returncode == (
        # Noise has no molecules and no blur, and one photograph twice is no pair.
        {"localize": 3, "depth": 3, "restore": 3, "retrieve": 4}.get(command, 0)
    ), result.stderr
    shares = [share for share in seen if share is not None]
    assert len(set(shares)) >= 2
    assert shares == sorted(shares)
    assert shares[0] >= 0.0
    assert shares[-1] <= 100.0


def drawn(*calls, total=None):
    console = Console(file=io.StringIO(), force_terminal=True, width=120)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("rich.console.Console", lambda **_: console)
        with bars.progress("first", total) as started:
            for call in calls:
                started(*call)
    return re.sub(r"\x1b\[[0-9;?]*[A-Za-z]", "", console.file.getvalue())


def test_the_bar_shows_what_is_done_its_share_and_the_time_that_is_left():
    last = drawn(("blurring", 0.25)).rstrip().splitlines()[-1]
    assert "blurring" in last
    assert "25%" in last
    assert re.search(r"left \S*:", last)


def test_a_step_counts_once_it_is_over():
    assert "50%" in drawn(("one",), ("two",), total=2)
    assert "100%" not in drawn(("one",), ("two",), total=2)


def test_no_share_is_made_up_where_none_is_known():
    assert "%" not in drawn(("reading",), ("writing",))


def logged(monkeypatch, capsys, *calls, total=None):
    """Return the lines of a log, of calls at given seconds."""
    seconds = [0.0]
    monkeypatch.setattr(bars.time, "monotonic", lambda: seconds[0])
    with bars.progress("first", total) as started:
        for at, *call in calls:
            seconds[0] = at
            started(*call)
    return capsys.readouterr().err.splitlines()


def test_a_log_gets_a_line_now_and_then_with_the_time_that_is_left(monkeypatch, capsys):
    calls = [(float(at), f"trial {at // 30}", at / 600.0) for at in range(300)]
    lines = logged(monkeypatch, capsys, *calls)
    assert lines[0] == "30 s, 5 %, about 10 min left: trial 1"
    assert 4 < len(lines) < 9
    counted = logged(monkeypatch, capsys, (1.0, "one"), (40.0, "two"), (75.0, "three"), total=4)
    assert counted == ["40 s, 25 %, about 2 min left: two", "75 s, 50 %, about 75 s left: three"]


def test_a_short_command_leaves_nothing_in_a_log(monkeypatch, capsys):
    assert logged(monkeypatch, capsys, (1.0, "one"), (29.0, "two", 0.9)) == []
