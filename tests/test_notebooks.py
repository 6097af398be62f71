"""The notebooks of exercises: made from one source, they run, and the solutions agree with theory."""

from __future__ import annotations

import json
import re
import runpy
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import pytest

FOLDER = Path(__file__).resolve().parent.parent / "examples" / "class"
NOTEBOOKS = sorted(FOLDER.glob("*.ipynb"))


def cells(path: Path, kind: str) -> list[str]:
    """Return the text of all cells of a kind."""
    book = json.loads(path.read_text(encoding="utf-8"))
    return ["".join(cell["source"]) for cell in book["cells"] if cell["cell_type"] == kind]


def test_the_notebooks_are_those_of_their_source():
    made = runpy.run_path(str(FOLDER / "notebooks.py"))["notebooks"]()
    assert sorted(made) == NOTEBOOKS
    for path, text in made.items():
        assert path.read_text(encoding="utf-8") == text, f"run python {FOLDER.name}/notebooks.py"


def test_exercises_have_no_solution_and_solutions_check_every_exercise():
    exercises, solutions = (FOLDER / f"{name}.ipynb" for name in ("exercises", "exercises-solutions"))
    assert "assert" not in "".join(cells(exercises, "code"))
    open_ended = [cell for cell in cells(exercises, "code") if "= ..." in cell]
    assert len(open_ended) == len(re.findall(r"^## \d", "\n".join(cells(exercises, "markdown")), re.MULTILINE)) == 6
    answered = "\n".join(cells(solutions, "code"))
    assert "= ..." not in answered
    for name in re.findall(r"^(\w+) = \.\.\.", "\n".join(open_ended), re.MULTILINE):
        assert re.search(rf"^(?:\w+, )*{name}(?:, \w+)* = ", answered, re.MULTILINE), name
        assert re.search(rf"^assert .*\b{name}\b", answered, re.MULTILINE), name


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs_and_its_figures_name_their_axes(path, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {"__name__": "__main__"}
    for number, code in enumerate(cells(path, "code")):
        exec(compile(code, f"{path.name}:{number}", "exec"), names)
    figures = [plt.figure(number) for number in plt.get_fignums()]
    assert all(axes.get_xlabel() + axes.get_ylabel() for figure in figures for axes in figure.axes)
    assert len(figures) == (6 if path.stem.endswith("solutions") else 0)
    plt.close("all")


@pytest.mark.skipif(not (find_spec("nbclient") and find_spec("ipykernel")), reason="no nbclient or no kernel for it")
def test_jupyter_runs_the_solutions():
    import nbclient
    import nbformat

    book = nbformat.read(FOLDER / "exercises-solutions.ipynb", as_version=4)
    nbformat.validate(book)
    nbclient.NotebookClient(book, timeout=300, kernel_name="python3").execute()
    pictures = [out for cell in book.cells for out in cell.get("outputs", ()) if "image/png" in out.get("data", {})]
    assert len(pictures) == 6
