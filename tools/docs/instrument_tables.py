"""The tables of example objectives and cameras, from their files."""

from __future__ import annotations

from pathlib import Path

import lommel as lm
from lommel.lensfiles import of_kind


def objectives() -> list[str]:
    """Return the rows of the objectives."""
    rows = []
    for name, path in of_kind("objective").items():
        microscope = lm.load_microscope(path)
        one = microscope.objective
        medium = {1.0: "air"}.get(one.immersion, f"{one.immersion:g}")
        rows.append(
            f"| `{name}` | {one.magnification:g}x | {one.NA:g} | {medium} | {1e3 * one.working_distance:.2g} mm "
            f"| {_origin(microscope.source)} |"
        )
    return ["| name | | NA | immersion | working distance | part |", "|---|---|---|---|---|---|", *rows]


def cameras() -> list[str]:
    """Return the rows of the cameras."""
    rows = []
    for name in of_kind("camera"):
        camera = lm.load_camera(name)
        cells = (camera.read, camera.full_well, camera.gain)
        stated = " | ".join("" if value is None else f"{value:g}" for value in cells)
        rows.append(f"| `{name}` | {1e6 * camera.side:g} µm | {stated} | {_origin(camera.source)} |")
    head = "| name | pixel | read noise (e-) | full well (e-) | gain (e-/count) | source |"
    return [head, "|---|---|---|---|---|---|", *rows]


def _origin(source: str) -> str:
    """Return a source up to its figures."""
    return source.partition(":")[0].removesuffix(" (arXiv")


def write(folder: Path) -> None:
    """Write `objectives.inc` and `cameras.inc`, which the page of instruments includes, into a folder."""
    folder.mkdir(exist_ok=True)
    for name, rows in (("objectives", objectives()), ("cameras", cameras())):
        (folder / f"{name}.inc").write_text("\n".join([*rows, ""]), encoding="utf-8")
