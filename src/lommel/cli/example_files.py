"""The example files of lenses and objectives, and the exercises."""

from __future__ import annotations

from pathlib import Path

KINDS = {"lenses": ("lens", "*.toml"), "objectives": ("objective", "*.toml"), "class": ("notebook", "*.ipynb")}
"""What the files of each folder describe, and how their names end."""


def files() -> dict[str, Path]:
    """Return the example files by their names without suffix: lenses, objectives, notebooks."""
    here = Path(__file__).resolve()
    # A wheel has them within the package; in the sources they stand at the top.
    for folder in (here.parents[1] / "examples", here.parents[3] / "examples"):
        found = [path for kind, (_, ending) in KINDS.items() for path in sorted((folder / kind).glob(ending))]
        if found:
            return {path.stem: path for path in found}
    raise FileNotFoundError(f"the examples are missing ({here.parents[1] / 'examples'}): wheels bring them")
