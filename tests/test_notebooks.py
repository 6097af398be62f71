"""The notebooks: made from their sources, they run, and the solutions of exercises agree with theory."""

from __future__ import annotations

import json
import runpy
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import pytest

from check import empty_axes

EXAMPLES = Path(__file__).resolve().parent.parent / "examples"
FOLDER = EXAMPLES / "class"
EXERCISES = sorted(FOLDER.glob("*.ipynb"))
OTHERS = sorted((EXAMPLES / "notebooks").glob("*.ipynb"))
# The others take seconds, or half a minute to compile in JAX: Jupyter runs them below, and tests of the pages and of
# the gallery run what they call.
QUICK = [path for path in OTHERS if path.stem in ("first-psf", "retrieval")]


def cells(path: Path, kind: str) -> list[str]:
    """Return the text of all cells of a kind."""
    book = json.loads(path.read_text(encoding="utf-8"))
    return ["".join(cell["source"]) for cell in book["cells"] if cell["cell_type"] == kind]


def test_the_notebooks_are_those_of_their_source():
    made = runpy.run_path(str(EXAMPLES / "notebooks.py"))["notebooks"]()
    assert sorted(made) == EXERCISES + OTHERS
    assert len(OTHERS) == 5
    for path, text in made.items():
        assert path.read_text(encoding="utf-8") == text, "run python examples/notebooks.py"


@pytest.mark.parametrize("path", EXERCISES, ids=lambda path: path.stem)
def test_a_notebook_runs_and_its_figures_name_their_axes(path, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {"__name__": "__main__"}
    for number, code in enumerate(cells(path, "code")):
        exec(compile(code, f"{path.name}:{number}", "exec"), names)
    figures = [plt.figure(number) for number in plt.get_fignums()]
    assert all(axes.get_xlabel() + axes.get_ylabel() for figure in figures for axes in figure.axes)
    assert len(figures) == (6 if path.stem.endswith("solutions") else 0)
    plt.close("all")


@pytest.mark.parametrize("path", QUICK, ids=lambda path: path.stem)
def test_a_notebook_runs_and_shows_something_in_every_figure(path, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {"__name__": "__main__"}
    count = 0
    for number, code in enumerate(cells(path, "code")):
        exec(compile(code, f"{path.name}:{number}", "exec"), names)
        for figure in map(plt.figure, plt.get_fignums()):
            count += 1
            assert not empty_axes(figure)
            assert any(axes.get_xlabel() for axes in figure.axes)
        plt.close("all")
    assert count >= 2


@pytest.mark.skipif(not (find_spec("nbclient") and find_spec("ipykernel")), reason="no nbclient or no kernel for it")
@pytest.mark.parametrize("path", [FOLDER / "exercises-solutions.ipynb", *OTHERS], ids=lambda path: path.stem)
def test_jupyter_runs_a_notebook(path):
    import nbclient
    import nbformat

    book = nbformat.read(path, as_version=4)
    nbformat.validate(book)
    nbclient.NotebookClient(book, timeout=600, kernel_name="python3").execute()
    outputs = [out for cell in book.cells for out in cell.get("outputs", ())]
    pictures = [out for out in outputs if "image/png" in out.get("data", {})]
    assert len(pictures) == 6 if path.parent == FOLDER else len(pictures) >= 2
    # Warnings of the package go to stderr.
    assert [out["text"] for out in outputs if out.get("name") == "stderr"] == []
