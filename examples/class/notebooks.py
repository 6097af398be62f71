"""Write exercises.ipynb and exercises-solutions.ipynb from exercises.py, without outputs.

    python examples/class/notebooks.py

Cells begin with `# %%`, those of text with `# %% [markdown]`. Cells tagged "exercise" are in the first notebook only,
those tagged "solution" in the second.
"""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
LEFT_OUT = {"exercises": "solution", "exercises-solutions": "exercise"}


def notebook(source: str, left_out: str) -> dict[str, Any]:
    """Return the notebook of a source, without the cells of a tag."""
    cells: list[dict[str, Any]] = []
    for number, part in enumerate(re.split(r"^# %%", source, flags=re.MULTILINE)[1:]):
        head, _, body = part.partition("\n")
        if f'"{left_out}"' in head:
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


def notebooks() -> dict[Path, str]:
    """Return the text of each notebook by its path."""
    source = (HERE / "exercises.py").read_text(encoding="utf-8")
    made = {HERE / f"{name}.ipynb": notebook(source, tag) for name, tag in LEFT_OUT.items()}
    return {path: json.dumps(book, indent=1, ensure_ascii=False) + "\n" for path, book in made.items()}


if __name__ == "__main__":
    for path, text in notebooks().items():
        path.write_text(text, encoding="utf-8", newline="\n")
