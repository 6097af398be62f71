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
"""Kind and file name pattern of the examples in each folder."""


def example_files() -> dict[str, Path]:
    """Return the example files that come with the package: lenses, objectives, cameras and notebooks.

    Returns
    -------
    dict of str to Path
        Path of each file by its name without suffix, such as ``"zeiss-63x-1.4-oil"`` (``lommel examples`` lists
        them).

    Raises
    ------
    FileNotFoundError
        If the installation lacks the example files.

    Examples
    --------
    >>> import lommel as lm
    >>> microscope = lm.load_microscope(lm.example_files()["zeiss-63x-1.4-oil"])
    >>> microscope.objective.NA
    1.4
    """
    module = Path(__file__).resolve()
    # A wheel has the examples within the package, the source tree at its top.
    for folder in (module.parents[1] / "examples", module.parents[3] / "examples"):
        files = [path for kind, (_, ending) in KINDS.items() for path in sorted((folder / kind).glob(ending))]
        if files:
            return {path.stem: path for path in files}
    raise FileNotFoundError(f"no examples in {module.parents[1] / 'examples'}: install a wheel, which includes them")


def of_kind(kind: str) -> dict[str, Path]:
    """Return the example files of one kind, such as "camera", by name."""
    return {name: path for name, path in example_files().items() if KINDS[path.parent.name][0] == kind}
