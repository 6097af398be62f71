"""The figures and the table of the paper, written to files."""

from __future__ import annotations

import errno
import io
import json
import tempfile
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from lommel.base import atomic
from lommel.paper import figures, numbers
from lommel.paper.figures import Facts, FigureData

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class _Plan:
    caption: str
    compute: Callable[[], FigureData]
    draw: Callable[[FigureData], Figure]


_draw_errors = partial(figures.draw_varied, errors=True)
FIGURES = {
    "1": _Plan("Methods and cost against n", figures.methods_cost, figures.draw_methods_cost),
    "2": _Plan("Comparison of various forms of J0(a)", figures.bessel_forms, figures.draw_bessel_forms),
    "3": _Plan("PSF comparison between FFT and CFIS", figures.compare_with_fft, figures.draw_comparison),
    "4": _Plan("CFIS PSF for varying N", partial(figures.vary, "terms"), figures.draw_varied),
    "5": _Plan("Error of the CFIS PSF for varying N", partial(figures.vary, "terms"), _draw_errors),
    "6": _Plan("Error of the CFIS PSF for varying defocus", partial(figures.vary, "defocus"), _draw_errors),
    "7": _Plan(
        "Error of the CFIS PSF for varying tangent-line centres (TLC)", partial(figures.vary, "tangent"), _draw_errors
    ),
    "eq17": _Plan("The piecewise quadratic phase of Eq. (17)", figures.quartic_phase, figures.draw_quartic_phase),
    "validity": _Plan("Where the closed forms hold, over C_d and v", figures.validity, figures.draw_validity),
}
"""Figures by their numbers in the paper; eq17 is of Eq. (17), validity is not in the paper."""

TABLE = ("table.md", "table.json")


def names(figure: str) -> tuple[str, str, str]:
    """Return the file names of a figure: picture, all data, one-dimensional data."""
    return f"figure-{figure}.png", f"figure-{figure}.npz", f"figure-{figure}.csv"


def reproduce(
    folder: Path,
    chosen: Iterable[str] | None = None,
    started: Callable[[str], object] = str,
    *,
    dpi: float = 130.0,
) -> Facts:
    """Write figures by their names, or all of them and the table; return files, facts of figures, and the table."""
    wanted = list(FIGURES) if chosen is None else list(dict.fromkeys(chosen))
    for figure in wanted:
        if figure not in FIGURES:
            raise ValueError(f"there is no figure {figure}; there are {', '.join(FIGURES)}")
    targets = [name for figure in wanted for name in names(figure)] + ([*TABLE] if chosen is None else [])
    _prepare(folder, targets)
    files: list[str] = []

    def keep(name: str, data: bytes) -> None:
        atomic.write(folder / name, data)
        files.append(str(folder / name))

    facts = {}
    for figure in wanted:
        started(f"figure {figure}: {FIGURES[figure].caption}")
        data = FIGURES[figure].compute()
        # All three are made before the first is written.
        made = (picture(FIGURES[figure].draw(data), dpi), archive(data), spreadsheet(data))
        for name, content in zip(names(figure), made, strict=True):
            keep(name, content)
        facts[figure] = {"caption": FIGURES[figure].caption} | data.facts
    table = None
    if chosen is None:
        started("the numbers")
        table = numbers.rows()
        keep(TABLE[0], numbers.markdown(table).encode())
        keep(TABLE[1], (json.dumps({"rows": table}, indent=2, allow_nan=False) + "\n").encode())
    return {"files": files, "figures": facts, "table": table}


def _prepare(folder: Path, targets: Iterable[str]) -> None:
    """Make the folder and check that it can be written, before the figures take minutes."""
    made = [part for part in (folder, *folder.parents) if not part.exists()]
    try:
        if folder.exists() and not folder.is_dir():
            raise NotADirectoryError(errno.ENOTDIR, "Not a directory", str(folder))
        folder.mkdir(parents=True, exist_ok=True)
        try:
            with tempfile.TemporaryFile(dir=folder):
                pass
        except OSError as error:
            raise type(error)(error.errno, error.strerror, str(folder)) from None
        for name in targets:
            if (folder / name).is_dir():
                raise IsADirectoryError(errno.EISDIR, "Is a directory", str(folder / name))
    except OSError:
        for part in made:
            if part.is_dir():
                part.rmdir()
        raise


def picture(figure: Figure, dpi: float) -> bytes:
    """Return a figure as a PNG."""
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", dpi=dpi)
    return buffer.getvalue()


def archive(data: FigureData) -> bytes:
    """Return the arrays as an .npz, with the facts as JSON in "description"."""
    buffer = io.BytesIO()
    arrays: Facts = dict(data.arrays)
    description = json.dumps({"title": data.title} | data.facts, allow_nan=False)
    np.savez_compressed(buffer, description=np.array(description), **arrays)
    return buffer.getvalue()


def spreadsheet(data: FigureData) -> bytes:
    """Return the columns as a .csv, names in the first line; NaN is an empty cell."""
    lines = [",".join(f'"{name}"' if "," in name else name for name in data.columns)]
    lines += [
        ",".join("" if np.isnan(value) else f"{value:.9g}" for value in row)
        for row in zip(*data.columns.values(), strict=True)
    ]
    return ("\n".join(lines) + "\n").encode()
