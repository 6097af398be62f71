"""Lens files, microscope files, and tables of Zernike coefficients and spectra."""

from __future__ import annotations

from pathlib import Path

KINDS = {
    "lenses": ("lens", "*.toml"),
    "objectives": ("objective", "*.toml"),
    "cameras": ("camera", "*.toml"),
    "class": ("notebook", "*.ipynb"),
    "notebooks": ("notebook", "*.ipynb"),
}
"""What the files of each folder describe, and how their names end."""


def example_files() -> dict[str, Path]:
    """Return the example files that come with the package: lenses, objectives, cameras and notebooks.

    Returns
    -------
    dict of str to Path
        Files by name, as ``lommel examples`` lists them: ``"zeiss-63x-1.4-oil"``.

    Raises
    ------
    FileNotFoundError
        If the installation lacks them.

    Examples
    --------
    >>> import lommel as lm
    >>> microscope = lm.load_microscope(lm.example_files()["zeiss-63x-1.4-oil"])
    >>> microscope.objective.NA
    1.4
    """
    here = Path(__file__).resolve()
    # A wheel has them within the package; in the sources they stand at the top.
    for folder in (here.parents[1] / "examples", here.parents[3] / "examples"):
        found = [path for kind, (_, ending) in KINDS.items() for path in sorted((folder / kind).glob(ending))]
        if found:
            return {path.stem: path for path in found}
    raise FileNotFoundError(f"the examples are missing ({here.parents[1] / 'examples'}): wheels bring them")


def of_kind(kind: str) -> dict[str, Path]:
    """Return the example files of one kind, such as "camera", by name."""
    return {name: path for name, path in example_files().items() if KINDS[path.parent.name][0] == kind}
