"""Bad command lines: exit code 0, 1 or 2, and what is wrong in one line, never a traceback."""

from __future__ import annotations

import random
import warnings
from pathlib import Path

import numpy as np
import pytest

from command_lines import lommel
from lommel import imaging

GOOD = (
    "psf lens.toml --shape 9 -o out.tif", "psf lens.toml --shape 9 -m hankel --tol 1e-8 -o out.npz -o out.png",
    "psf lens.toml --shape 5 --method closed-form --set tangent=20 --set erf=table:64", "info lens.toml --json",
    "psf field.toml --field 2x2 --shape 5 -o field.npz", "info lens.toml --object-distance 2m --pixel 3um",
    "psf lens.toml --shape 5 --normalize peak -o a.npy --json", "compare lens.toml --shape 5",
    "blur photo.png depth.npy lens.toml --focus 2m --supersample 2 -o out.png",
    "blur photo.png depth.npy lens.toml --f-number 11 --pixel 8um --focus 2m -o out.tif --tol 1e-3",
    "psf objective.toml --stack 2 --step 200nm --depth 1um --shape 5 -o a.tif", "info objective.toml --json",
)  # fmt: skip
HOSTILE = (
    "", "x", "-", "--", "-1", "0", "1", "nan", "inf", "-inf", "1e308", "1e-320", "1e400", "9" * 30, "1_0", "٣",
    "1 mm", "0m", "-1mm", "1e300 m", "50", "5um", "1 kg", "a\nb", "\x1b[31m", "ä" * 300, "lens.toml",
    "nowhere.toml", "broken.toml", "photo.png", "depth.npy", ".", "..", "/dev/null", "/dev/zero", "fifo", "fifo.png",
    "out.exe",
    "%d.png", "%s.png", "o%99999999d.png", "%03d%03d.png", "2x", "x2", "2x2x2", "0x0", "99999x99999", "16384x16384",
    "tangent=", "=", "a=b", "tol=1", "erf=junk", "erf=table:0", "erf=table:x", "nodes=1,2", "terms=1e9", "--json",
    "--field", "--help", "--shape", "-o", "--set", "--tol", "--pixel", "8", "16", "float",
    "hankel", "huygens-fresnel", "geometric", "[bold]", "[/]", ":smile:", "\udcff",
)  # fmt: skip


@pytest.fixture
def folder(tmp_path) -> Path:
    """Files that the commands take, and some that they do not."""
    import os

    lens = '[lens]\nfocal_length = "50 mm"\nf_number = 8\nfocus_distance = "2 m"\nwavelength = "550 nm"\n'
    lens = f'name = "a"\n{lens}[object]\ndistance = "1.9 m"\n[sensor]\npixel = "8 um"\nshape = 9\n'
    (tmp_path / "lens.toml").write_text(lens)
    (tmp_path / "field.toml").write_text(lens + '[field]\nsensor = ["1 mm", "1 mm"]\nW131 = 1\n')
    (tmp_path / "broken.toml").write_text(lens.replace("f_number", "f_stop") + '[field]\nfile = "/dev/zero"\n')
    light = '[emission]\nwavelength = "520 nm"\nemitter = "scalar"\n[sensor]\npixel = "6.5 um"\nshape = 5\n'
    glass = '[coverslip]\nindex = 1.52\nthickness = "170 um"\n[sample]\nindex = 1.33\ndepth = "1 um"\n'
    objective = '[objective]\nNA = 1.2\nmagnification = 60\nimmersion = 1.333\nworking_distance = "0.2 mm"\n'
    (tmp_path / "objective.toml").write_text(objective + glass + light)
    np.save(tmp_path / "depth.npy", np.full((20, 30), 1.95))
    imaging.write_photo(tmp_path / "photo.png", np.full((20, 30, 3), 0.5))
    os.mkfifo(tmp_path / "fifo")
    os.mkfifo(tmp_path / "fifo.png")
    return tmp_path


def changed(words: list[str], draw: random.Random) -> list[str]:
    out = list(words)
    for _ in range(draw.choice((1, 1, 2, 3))):
        at = draw.randrange(len(out) + 1)
        way = draw.randrange(4)
        if way == 0 and at < len(out):
            out[at] = draw.choice(HOSTILE)
        elif way == 1:
            out.insert(at, draw.choice(HOSTILE))
        elif way == 2:
            del out[at : at + 1]
        elif at < len(out) and out[at].startswith("--") and at + 1 < len(out):
            out[at + 1] = draw.choice(HOSTILE)
    return out


def test_a_bad_command_line_is_told_in_one_line(folder, hunt, count, monkeypatch):
    monkeypatch.chdir(folder)
    monkeypatch.delenv("LOMMEL_TRACEBACK", raising=False)
    monkeypatch.setenv("COLUMNS", "10000")

    def case(k: int) -> str | None:
        draw = random.Random(k)
        words = changed(draw.choice(GOOD).split(), draw)
        if not words:  # without a word it shows its help
            return None
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            try:
                result = lommel(*words)
            except Exception as error:
                return f"lommel {words!r:.300}: {type(error).__name__}: {error}"
        told = f"lommel {words!r:.300}"
        if result.returncode == 0:
            return None
        lines = [line for line in result.stderr.splitlines() if line.strip()]
        wrong = [line for line in lines if not line.startswith(("Note: ", "Error: "))]
        errors = [line for line in lines if line.startswith("Error: ")]
        if (
            result.returncode != 2
            or wrong
            or len(errors) != 1
            or len(errors[0]) > 1000
            or "Traceback" in result.stderr
        ):
            return f"{told}: {result.returncode}: {result.stderr[:600]!r}"
        return None

    findings = hunt(case, count(40, 2000), seconds=30)
    assert not findings, "\n".join(findings)
