"""Commands that are generated from functions, options classes and docstrings."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal

import pytest

from lommel.base.options import HIDDEN, In, Options, Shown
from lommel.cli.command import OUTPUT, application, call, command
from lommel.report import Report


@dataclass(frozen=True, kw_only=True)
class Grinding(Options):
    """How a mirror is ground.

    Parameters
    ----------
    grit : int, default 80
        Number of the grit, see :func:`lommel.psf`.
    depth : float, optional
        Sagitta, such as 2mm.
    strokes : tuple of float
        Lengths of the strokes
        in radii.
    seed : int
        Seed of the random strokes.
    """

    heading: ClassVar[str] = "Workshop"
    grit: Annotated[int, In(least=40, most=3000)] = 80
    depth: Annotated[float | None, In(above=0.0, unit="metres"), Shown(("--sagitta",), length="mm")] = None
    strokes: tuple[float, ...] = ()
    seed: Annotated[int, HIDDEN] = 0


def doubled(text: str) -> str:
    """Return a text twice."""
    if not text:
        raise ValueError("an empty text is no name")
    return 2 * text


@command
def grind(
    blanks: list[Path],
    drawing: Path,
    /,
    *,
    options: Grinding = Grinding(grit=120),
    output: Annotated[Path | None, OUTPUT] = None,
    radii: Annotated[tuple[float, ...], Shown(("--radius",), length="m")] = (),
    span: Annotated[tuple[float, float] | None, Shown(length="m", metavar="FROM TO")] = None,
    finish: Literal["rough", "fine"] = "rough",
    names: tuple[str, ...] = (),
    dry: bool = False,
    wet: Annotated[bool | None, Shown(negative="--not-wet")] = None,
    tag: Annotated[Any, Shown(parse=doubled)] = None,
) -> Report:
    """Grind mirrors.

    BLANKS are ground to
    the DRAWING.

    Parameters
    ----------
    output
        Report of the work.
    span
        Range of radii.

    Examples
    --------
      lommel grind a.toml drawing.toml --grit 80
    """
    if options.grit == 666:
        raise ValueError("grit must be even, got 666; or span=(1, 2)")
    facts = {"blanks": [*map(str, blanks)], "drawing": str(drawing), "grit": options.grit, "depth": options.depth}
    facts |= {
        "radii": radii,
        "strokes": list(options.strokes),
        "seed": options.seed,
        "output": output and str(output),
        "span": span,
    }
    return Report(facts | {"finish": finish, "names": list(names), "dry": dry, "wet": wet, "tag": tag}, ["ground"])


@pytest.fixture
def run(capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")

    def call_it(line: str):
        app = application()
        grind.add_to(app, "grind")
        code = call(app, ["grind", *grind.arranged(line.split())])
        shown = capsys.readouterr()
        return code, shown.out, shown.err

    return call_it


def facts(run, line):
    code, out, err = run(f"{line} --json")
    assert (code, err) == (0, "")
    return json.loads(out)


def test_defaults_are_those_of_the_instance_and_the_function(run):
    found = facts(run, "a.toml d.toml")
    assert (found["blanks"], found["drawing"]) == (["a.toml"], "d.toml")
    assert (found["grit"], found["depth"], found["seed"], found["finish"]) == (120, None, 0, "rough")
    assert (found["strokes"], found["names"], found["dry"], found["wet"]) == ([], [], False, None)
    assert run("a.toml d.toml")[1] == "ground\n"


def test_all_files_but_the_last_are_the_first_argument(run):
    found = facts(run, "a b --grit 40 c --dry d")
    assert (found["blanks"], found["drawing"], found["grit"]) == (["a", "b", "c"], "d", 40)


@pytest.mark.parametrize("line", ["--strokes -4 0 .5 a d", "a d --strokes -4 --strokes 0 --strokes=.5"])
def test_numbers_follow_one_flag_or_several(run, line):
    found = facts(run, line)
    assert (found["strokes"], found["blanks"], found["drawing"]) == ([-4.0, 0.0, 0.5], ["a"], "d")


def test_values_with_a_unit_of_their_own_syntax_and_three_states(run):
    lengths = "--sagitta 2mm --span -1m 3cm --radius 1m --radius 2m"
    found = facts(run, f"a d {lengths} --tag x --names p --names q --dry --not-wet --finish fine")
    assert (found["depth"], found["span"], found["tag"]) == (pytest.approx(2e-3), [-1.0, pytest.approx(0.03)], "xx")
    assert (found["names"], found["dry"], found["wet"], found["finish"]) == (["p", "q"], True, False, "fine")
    assert found["radii"] == [1.0, 2.0]
    assert facts(run, "a d --wet")["wet"] is True


@pytest.mark.parametrize(
    ("line", "error"),
    [
        ("a d --grit 39", "--grit must be from 40 to 3000, got 39"),
        ("a d --grit", "--grit needs a value"),
        ("a d --strokes -4,0", "--strokes must be a number, got '-4,0'; several numbers follow with blanks: "
         "--strokes -4 0"),
        ("a d --seed 3", 'Unknown option: --seed.'),
        ("a d --sagitta 2", "--sagitta: '2' is a length without a unit; write for example '2 mm'"),
        ("a d --sagitta -2mm", "--sagitta must be > 0 metres, got -0.002"),
        ("a d --span 1m", "--span needs a value"),
        ("a d --grit 50 --grit 60", "Parameter --grit specified multiple times."),
        ("a d --grit 666", "--grit must be even, got 666; or --span (1, 2)"),
        ("a d -o ./d", "--output must be another file than DRAWING, got d for both"),
    ],
)  # fmt: skip
def test_a_wrong_line_is_one_line_with_its_flag(run, line, error):
    code, out, err = run(line)
    assert (code, out) == (2, "")
    assert err == f"Error: {error}\n"


def test_help_has_usage_text_options_under_headings_and_examples(run):
    code, out, _ = run("--help")
    assert code == 0
    assert out.startswith("Usage: lommel grind [OPTIONS] BLANKS... DRAWING\n\nGrind mirrors.\n\nBLANKS are ground to")
    rows = [
        "Options:", "  --output, -o FILE  Report of the work.", "  --span FROM TO     Range of radii.",
        "  --finish CHOICE    [rough, fine] [default: rough]", "  --wet, --not-wet", "Workshop:",
        "  --grit INT          Number of the grit, see psf. [default: 120]",
        "  --sagitta LENGTH    Sagitta, such as 2mm.",
        "  --strokes FLOAT...  Lengths of the strokes in radii.", "  lommel grind a.toml drawing.toml --grit 80",
    ]  # fmt: skip
    lines = out.splitlines()
    assert [row for row in rows if row not in lines] == []
    assert "seed" not in out
    assert all(line == line.rstrip() and len(line) <= 80 for line in lines)
