"""Write the notebooks of class and notebooks from their sources, without outputs.

    python examples/notebooks.py

Cells begin with `# %%`, those of text with `# %% [markdown]`. Of class/exercises.py, cells tagged "exercise" are in
exercises.ipynb only, those tagged "solution" in exercises-solutions.ipynb. Each file of notebooks is a notebook. Once
pyproject.toml has the address of the repository, they have a badge that opens them in a hosted runtime.
"""

from __future__ import annotations

import json
import re
import tomllib
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
LEFT_OUT = {"exercises": "solution", "exercises-solutions": "exercise"}


def notebook(source: str, left_out: str | None = None) -> dict[str, Any]:
    """Return the notebook of a source, without the cells of a tag."""
    cells: list[dict[str, Any]] = []
    for number, part in enumerate(re.split(r"^# %%", source, flags=re.MULTILINE)[1:]):
        head, _, body = part.partition("\n")
        if left_out and f'"{left_out}"' in head:
            continue
        kind = "markdown" if "[markdown]" in head else "code"
        text = re.sub(r"^# ?", "", body, flags=re.MULTILINE) if kind == "markdown" else body
        cell = {
            "cell_type": kind,
            "id": f"cell-{number}",
            "metadata": {},
            "source": text.strip().splitlines(keepends=True),
        }
        cells.append(cell | ({"execution_count": None, "outputs": []} if kind == "code" else {}))
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    return {"cells": cells, "metadata": {"kernelspec": kernel}, "nbformat": 4, "nbformat_minor": 5}


def repository() -> str | None:
    """Return owner and name of the public repository, where pyproject.toml has its address."""
    project = tomllib.loads((HERE.parent / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    found = re.search(r"github\.com/([\w.-]+/[\w-]+)", project.get("urls", {}).get("Repository", ""))
    return found[1] if found else None


def badge(public: str, name: str) -> str:
    """Return the source of a cell with the badge of a notebook."""
    page = f"https://colab.research.google.com/github/{public}/blob/main/examples/notebooks/{name}.ipynb"
    picture = "https://colab.research.google.com/assets/colab-badge.svg"
    # Built from the repository: two minutes, with the compiler that Colab has.
    note = f'There, first run `%pip install "lommel[plot] @ git+https://github.com/{public}"` in a cell of its own.'
    return f"# %% [markdown]\n# [![Open in Colab]({picture})]({page}) {note}\n"


def notebooks() -> dict[Path, str]:
    """Return the text of each notebook by its path."""
    exercises = (HERE / "class" / "exercises.py").read_text(encoding="utf-8")
    made = {HERE / "class" / f"{name}.ipynb": notebook(exercises, tag) for name, tag in LEFT_OUT.items()}
    public = repository()
    for path in sorted((HERE / "notebooks").glob("*.py")):
        source = path.read_text(encoding="utf-8")
        if public:  # after the first cell, which has the title
            source = source.replace("\n# %%", f"\n{badge(public, path.stem)}\n# %%", 1)
        made[path.with_suffix(".ipynb")] = notebook(source)
    return {path: json.dumps(book, indent=1, ensure_ascii=False) + "\n" for path, book in made.items()}


if __name__ == "__main__":
    for path, text in notebooks().items():
        path.write_text(text, encoding="utf-8", newline="\n")
