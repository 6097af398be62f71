"""Figures of docs/pictures.md, each drawn by the code above it; run as a script, the figure of README.md."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
from matplotlib.figure import Figure

PAGE = Path(__file__).resolve().parent / "pictures.md"
# A block of code, or a picture that the build makes.
_PARTS = re.compile(r"^```python\n(.*?)^```|_generated/pictures/([\w-]+)\.png", re.MULTILINE | re.DOTALL)


def figures(page: Path = PAGE) -> Iterator[tuple[str, Figure]]:
    """Run the code of a page and yield the name of each picture with the last figure drawn above it."""
    names: dict[str, Any] = {}
    for part in _PARTS.finditer(page.read_text(encoding="utf-8")):
        code, name = part.groups()
        if code is not None:
            plt.close("all")
            exec(compile(code, page.name, "exec"), names)
        elif not plt.get_fignums():
            raise ValueError(f"{page.name}: no code above the picture {name} draws one")
        else:
            yield name, plt.gcf()
    plt.close("all")


def first_psf() -> Figure:
    """Return the figure that the first code of README.md draws."""
    plt.close("all")
    part = _PARTS.search((PAGE.parents[1] / "README.md").read_text(encoding="utf-8"))
    assert part
    exec(compile(part[1], "README.md", "exec"), {})
    return plt.gcf()


def write(folder: Path) -> None:
    """Write the figures of docs/pictures.md into a folder."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, figure in figures():
        figure.savefig(folder / f"{name}.png", dpi=110)


if __name__ == "__main__":
    figure = first_psf()
    figure.set_size_inches(4.4, 3.4)
    figure.savefig(PAGE.parent / "first-psf.png", dpi=100)
