"""The lens and objective files that come with the package: real instruments, each with the source of its figures."""

from __future__ import annotations

from pathlib import Path

from lommel.lensfiles import toml_files

KINDS = {"lenses": "lens", "objectives": "objective"}
"""Their folders, and what is in them."""


def files() -> dict[str, Path]:
    """Return the files by their names without suffix, lenses first.

    Returns
    -------
    dict of str to Path

    Raises
    ------
    FileNotFoundError
        If the package was taken out of its folder by hand, without them.
    """
    here = Path(__file__).resolve()
    # A wheel has them within the package; in the sources, installed editable or not, they stand at the top.
    for folder in (here.parents[1] / "examples", here.parents[3] / "examples"):
        found = [path for kind in KINDS for path in sorted((folder / kind).glob("*.toml"))]
        if found:
            return {path.stem: path for path in found}
    raise FileNotFoundError(f"the examples are not there ({here.parents[1] / 'examples'}): wheels bring them")


def title(path: Path) -> str:
    """Return what an example says of itself.

    Parameters
    ----------
    path : Path

    Returns
    -------
    str

    Raises
    ------
    LensFileError, OSError
        If it is no TOML, or cannot be read.
    """
    _, raw = toml_files.parsed(path)
    return str(raw["name"])
