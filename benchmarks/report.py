"""Tables: plain data that is printed, written to JSON, drawn, and turned into docs/benchmarks.md."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.timing import Spread


@dataclass
class Table:
    """Rows under headings.

    Attributes
    ----------
    key : str
        Short name, for ``--only``.
    title, about : str
        `about` is a paragraph of Markdown.
    columns : dict of str to str
        Headings, each with the format of its column: text, ratio, times, error or number.
    rows : list of dict
        A missing value means that there is nothing to say.
    notes : list of str
    """

    key: str
    title: str
    about: str
    columns: dict[str, str]
    rows: list[dict[str, Any]] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)

    def add(self, *values: Any) -> dict[str, Any]:
        """Append a row, in the order of the columns."""
        row = {
            name: asdict(value) if isinstance(value, Spread) else value
            for name, value in zip(self.columns, values, strict=True)
            if value is not None
        }
        self.rows.append(row)
        return row

    def cells(self) -> list[list[str]]:
        """Return the rows as text."""
        return [
            [_FORMATS[kind](row[name]) if name in row else "–" for name, kind in self.columns.items()]
            for row in self.rows
        ]

    def to_dict(self) -> dict[str, Any]:
        """Return everything in plain types."""
        return asdict(self)


def number(value: float) -> str:
    """Write a number with two or three digits."""
    if not math.isfinite(value):
        return "–"
    if value >= 100:
        return f"{value:,.0f}".replace(",", " ")
    return f"{value:.3g}" if value < 1 else f"{value:.1f}"


def _median(value: float | dict[str, Any]) -> str:
    return number(value["median"] if isinstance(value, dict) else value)


def _spread(value: float | dict[str, Any]) -> str:
    if not isinstance(value, dict):
        return number(value)
    return f"{number(value['median'])} ({number(value['low'])} to {number(value['high'])})"


def _error(value: float) -> str:
    return f"{value:.1e}" if math.isfinite(value) else "–"


_FORMATS: dict[str, Callable[[Any], str]] = {
    "text": str,
    "number": _median,
    "spread": _spread,
    "error": _error,
}


def markdown(table: Table) -> str:
    """Write a table as a section of the details of the page."""
    lines = [f"### {table.title}", "", table.about, ""]
    if not table.rows:
        return "\n".join(lines)
    lines.append("| " + " | ".join(table.columns) + " |")
    lines.append("|" + "|".join("---" if kind == "text" else "---:" for kind in table.columns.values()) + "|")
    lines += ["| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |" for row in table.cells()]
    if table.notes:
        lines += ["", *(f"- {note}" for note in table.notes)]
    return "\n".join(lines) + "\n"


def show(console: Any, table: Table) -> None:
    """Print a table to a terminal."""
    from rich import box
    from rich.table import Table as RichTable

    styles = {"aim": "green", "must": "yellow", "MISSED": "bold red"}
    rich = RichTable(title=table.title, box=box.SIMPLE_HEAD, title_justify="left", title_style="bold")
    for name, kind in table.columns.items():
        rich.add_column(name, justify="left" if kind == "text" else "right", overflow="fold")
    for row in table.cells():
        rich.add_row(*(f"[{styles[cell]}]{cell}[/]" if cell in styles else _plain(cell) for cell in row))
    console.print(rich)
    for note in table.notes:
        console.print(f"  {_plain(note)}", style="dim", highlight=False)


def _plain(text: str) -> str:
    from rich.markup import escape

    return escape(text.replace("`", ""))


_HEAD = """# Benchmarks

<!-- Written by `make bench` from benchmarks/results.json: do not edit this page. -->

## In short

Time of the other over that of lommel, one thread each. Pupils are new in every call; the window, its size and pixels,
is that of a call before, which made the tables. The tolerance that is stated is met by lommel. An FFT is the
transform alone, whatever the error of an image by it; SciPy's is not the fastest ([ducc0's](#all-rows) is faster).

{short}

[All rows](#all-rows) have their true errors, and the ranges of the ratios on the first machine.

## Details

### How it is measured

Every number is a ratio of two runs measured alternately in one process (A B A B ...), warm unless a row says cold.
It is the median of the ratios of neighbouring runs, with the smallest and the largest in brackets. Each run is the
fastest of three batches of calls of at least 2 ms, which reduces the influence of other programs. BLAS and FFT of
the baselines use one thread, lommel one unless the row says two. Every call of lommel is given a pupil that it has
not seen before.

The true error is `max |I - I_exact| / max I_exact` against quadrature, never against an FFT. For radially symmetric
pupils the reference is Gauss-Legendre quadrature (`Hankel`) at the radius of every pixel (in windows beyond
1024²: 20 000 pixels and the row through the axis). For all other pupils it is a quadrature over the whole aperture
in plain NumPy, for every pixel of 33 rows of 512², including those about the peak, and for 16 images of a stack.

C_d and C_s are the coefficients of defocus and primary spherical aberration in radians at the edge of the pupil
(W020 = C_d / π and W040 = C_s / (2π) waves). The unit λN is the wavelength times the f-number.
"""

_AGAIN = """### Differentiable PSFs

[Differentiable PSFs](differentiable.md) are measured by `python -m benchmarks.differentiable` on CPUs, and by
`python -m benchmarks.gpu` on graphics processors. No graphics processor has been measured yet: the figures for these
are estimates from the memory traffic of a PSF and the bandwidth of the memory.

### Reproduce

```sh
make bench                                        # everything: a few minutes; writes this page
make peers                                        # first, to include the other packages
.venv/bin/python benchmarks/run.py --quick        # under a minute, writes nothing
.venv/bin/python benchmarks/run.py --only sizes   # one table; --list names them
```

`make bench` also compares *All rows* with the limits in `benchmarks/targets.py`, and fails if a row exceeds its
limit in two runs. Load from other programs widens the ranges in brackets.
"""

# What is demanded of a row concerns developers: the terminal and the exit status of `make bench` say it.
_DEMANDS = ("must", "aim", "verdict")


# Tables that show what a second machine measured, and the heading of it.
WITH_SECOND = ["targets", "camera", "paper", "changes", "threads"]
_SECOND = "on an older machine"

_FIGURES = {
    "sizes": "![Cost of one PSF against the side of the window, for each way to compute it](benchmarks.png)",
    "costs": "![Cost of a pixel against window, aberration, terms, tolerance and pupils](benchmarks-costs.png)",
}
# Drawn, and in benchmarks/results.json.
_LEFT_OUT = ("costs",)


def _by_words(table: dict[str, Any]) -> dict[tuple[str, ...], dict[str, Any]]:
    """Return the rows by what they say that they measure, "the same" included."""
    known: dict[tuple[str, ...], dict[str, Any]] = {}
    before: list[str] = []
    for row in table["rows"]:
        work, against = (row.get(name, "") for name in list(table["columns"])[:2])
        before = [*before, work] if work.startswith("the same") else [work]
        known[*before, against if isinstance(against, str) else ""] = row
    if len(known) < len(table["rows"]):
        raise ValueError(f"rows of {table['title']!r} say the same")
    return known


def _with_second(table: dict[str, Any], second: dict[str, Any] | None) -> dict[str, Any]:
    """Return a table with what another machine measured beside it, where that has such a table."""
    if second is None:
        return table
    measured = next(name for name, kind in table["columns"].items() if kind == "spread")
    theirs = _by_words(second)
    rows = [
        row | ({_SECOND: theirs[words][measured]} if measured in theirs.get(words, {}) else {})
        for words, row in _by_words(table).items()
    ]
    columns: dict[str, str] = {}
    for name, kind in table["columns"].items():
        columns |= {name: kind} | ({_SECOND: "number"} if name == measured else {})
    return table | {"columns": columns, "rows": rows}


# Questions of users: the words of the page, the table, the beginnings of the rows that answer them and of what these
# are measured against, where that is a column; the least favourable row counts. Last, which of the row's ratios.
_ROUND, _OTHERS = "512², float32, tol 1e-6, abs(C_d), abs(C_s) ≤ 50", "512², float32, tol 1e-6, pixels of"
IN_SHORT = [
    ("512² samples, defocus C_d and spherical aberration C_s of up to 50 rad, to 1e-6",
     "SciPy's FFT of 1024², complex128", "targets", _ROUND, "scipy.fft", 0),
    ("the same", "quadrature over the radius in NumPy, J0 cached, at the distinct radii", "targets", _ROUND,
     "NumPy: quadrature, cached J0, the distinct radii", 0),
    ("512² samples, defocus, coma, astigmatism and trefoil of up to 10 rad each, the worst of three pixels, to 1e-6",
     "SciPy's FFT of 1024², complex128", "targets", _OTHERS, "scipy.fft", 0),
    ("the same", "ducc0's non-uniform FFT, tuned, in single precision", "targets", "the same, pixels of",
     "ducc0's non-uniform FFT", 0),
    ("1000 of 33² samples, 15 Zernike terms of 1 rad rms together, to 1e-4", "SciPy's FFT of 128² each", "targets",
     "1000 of 33², 15 Zernike terms of 1 rad rms together, float32, tol 1e-4", "scipy.fft", 0),
    ("1000 of 33² camera pixels (4 µm, f/2.8), averaged, 12 terms of 0.1 waves rms, to 1e-4",
     "SciPy's FFT of 128² each", "camera", "f/2.8, 4 µm (2.6 λN), 0.1 waves rms, 1000 PSFs", "", 0),
    ("the same", "the smallest FFT method in complex64 within 1e-4", "camera",
     "f/2.8, 4 µm (2.6 λN), 0.1 waves rms, 1000 PSFs", "", 1),
    ("the same, 12 terms of 0.2 waves rms", "SciPy's FFT of 128² each", "camera",
     "f/2.8, 4 µm (2.6 λN), 0.2 waves rms, 1000 PSFs", "", 0),
    ("1000 of 33² such averages of a telescope: pixels of 1 λN, obscuration of 0.3, four vanes, 0.1 waves rms",
     "the smallest FFT method in complex64 within 1e-4", "camera",
     "f/8, 4.4 µm (1 λN), 0.1 waves rms, obscuration 0.3, 4 vanes, 1000 PSFs", "", 1),
    ("50 of 33² of JWST, pixels of 0.99 λN", "the same", "camera", "jwst", "", 1),
    ("one of 33², four vanes, pixels of 2.6 λN, seeing of D / r0 = 12", "the same", "camera",
     "f/8, 11.6 µm (2.6 λN), 0.1 waves rms, obscuration 0.3, 4 vanes, D / r0 = 12", "", 1),
    ("64 planes of 64² of a microscope, NA 1.4, oil, an objective seen before, to 1e-6",
     "psfmodels, vectorial, oversample_factor=1", "microscopes", "64 planes of 64²", "", 1),
    ("the same", "pyotf, scalar light in one medium", "microscopes", "64 planes of 64²", "", 2),
]  # fmt: skip


def in_short(results: dict[str, Any]) -> list[float | None]:
    """Return the ratio of each of these questions, None where a machine has not measured it."""
    tables = {table["key"]: table["rows"] for table in results["tables"]}
    found: list[float | None] = []
    for _, _, key, words, against, which in IN_SHORT:
        rows, task = [], ""
        for row in tables.get(key, ()):
            # A row of a "task" repeats no words that the last one has.
            task = task if row.get("work") == "the same" else next(iter(row.values()))
            if task.startswith(words) and str(row.get("against", "")).startswith(against):
                rows.append(row)
        medians = [[value["median"] for value in row.values() if isinstance(value, dict)] for row in rows]
        found.append(min((each[which] for each in medians if len(each) > which), default=None))
    return found


def _short(results: dict[str, Any], second: dict[str, Any]) -> str:
    """Return the table of these, of two machines."""
    cells = [
        ["–" if value is None else f"{value:.3g}" for value in column] for column in map(in_short, (results, second))
    ]
    rows = [f"| {q[0]} | {q[1]} | {a} | {b} |" for q, a, b in zip(IN_SHORT, *cells, strict=True)]
    text = "\n".join(["| task | against | Xeon, AVX-512 | EPYC of 2021, AVX2 |", "|---|---|---:|---:|", *rows])
    # Cells are narrow on phones, and lines break at hyphens.
    return text.replace("1e-4", "10⁻⁴").replace("1e-6", "10⁻⁶")


def write(results: dict[str, Any], second: dict[str, Any]) -> str:
    """Return the page as Markdown; what a second machine measured stands beside."""
    machine = results["machine"]
    versions = ", ".join(f"{name} {number}" for name, number in machine["versions"].items())
    yards = ", ".join(f"{name} {value:,.0f} µs".replace(",", " ") for name, value in machine["yardsticks"].items())
    parts = [
        _HEAD.format(short=_short(results, second)),
        f"Machine: {machine['processor']}, {machine['processors in use']} processors, {machine['memory']}, "
        f"{machine['system']}. Versions: {versions}. Date: {results['date']}. For scale, in this run: {yards}.\n",
        f"The column *{_SECOND}* of some tables: {second['description']}; the medians of {second['date']}.\n",
    ]
    theirs = {table["key"]: table for table in second["tables"]}
    known = {table["key"] for table in results["tables"]}
    alone = [table | {"about": f"Measured {_SECOND} only. {table['about']}"} for table in second["tables"]]
    first, *others = results["tables"]
    for plain in [first, *(table for table in alone if table["key"] not in known), *others]:
        plain = _with_second(plain, theirs.get(plain["key"]) if plain["key"] in known else None)
        columns = {name: kind for name, kind in plain["columns"].items() if name not in _DEMANDS}
        rows = [] if plain["key"] in _LEFT_OUT else plain["rows"]
        parts.append(markdown(Table(**plain | {"columns": columns, "rows": rows})))
        if plain["key"] in _FIGURES:
            parts.append(_FIGURES[plain["key"]] + "\n")
    parts.append(_AGAIN)
    return "\n".join(parts)


# Colour of each way in the figure of sizes, and its name there.
_CURVES = {
    "lommel": ("#c1121f", "lommel, to 1e-6"),
    "FFT, alone": ("#8d99ae", "FFT alone, twice the side"),
    "FFT, whole method": ("#2b2d42", "FFT method, all its steps"),
    "quadrature": ("#2a9d8f", "quadrature over the radius"),
    "closed form, Fresnel": ("#e9a23b", "closed form of the paper, Fresnel integrals"),
    "closed form, Abramowitz 30": ("#b5651d", "closed form of the paper, series of 30 terms"),
    "ray tracing": ("#7b2cbf", "sum over wavelets (Huygens-Fresnel)"),
}


def draw(sizes: dict[str, Any], path: Path, machine: dict[str, Any]) -> None:
    """Draw the table of sizes, as it stands in the JSON file, beside the time of the unit on that machine."""
    from matplotlib.figure import Figure

    curves: dict[str, list[tuple[int, float]]] = {}
    for row in sizes["rows"]:
        curves.setdefault(row["way"], []).append((int(row["n"]), row["cost"]["median"]))
    figure = Figure(figsize=(9.6, 5.2), layout="constrained")
    figure.get_layout_engine().set(w_pad=0.1, h_pad=0.08)  # type: ignore[union-attr, call-arg]
    axes = figure.add_subplot()
    # The legend has the order of the curves at the right.
    ways = sorted(curves.keys() & _CURVES.keys(), key=lambda way: -curves[way][-1][1] / curves[way][-1][0] ** 2)
    for way in ways:
        n, cost = np.array(curves[way]).T
        color, name = _CURVES[way]
        width = 2.6 if way == "lommel" else 1.5
        axes.loglog(n, cost, "o-", color=color, label=name, linewidth=width, markersize=4)
    unit = 1e-3 * machine["yardsticks"]["FFT 1024²"]
    axes.set_xlabel("pixels along a side of the image")
    axes.set_ylabel("time of one PSF (1 = one FFT of 1024 × 1024)")
    milliseconds = axes.secondary_yaxis("right", functions=(lambda cost: unit * cost, lambda time: time / unit))
    milliseconds.set_ylabel(f"time on {machine['processor']} (ms)")
    axes.set_title("Time of one PSF of a defocused lens on one thread", fontsize=11)
    axes.grid(linewidth=0.3)
    sides = sorted({n for curve in curves.values() for n, _ in curve})
    axes.set_xticks(sides, [str(n) for n in sides])
    axes.minorticks_off()
    figure.legend(*axes.get_legend_handles_labels(), fontsize=8, loc="outside right upper", frameon=False)
    figure.savefig(path, dpi=130, metadata={"Software": None})


# Title and label of x for each panel of the figure of costs, and the names of its curves.
_PANELS = {
    "side of the window, pixels": ("Larger images", "pixels along a side of the image"),
    "aberration, rad rms (radial: defocus at the edge)": (
        "Stronger aberrations, 512 × 512 pixels",
        "wavefront error (rad): rms, or defocus at the edge",
    ),
    "Zernike terms, 1 rad rms together, 33²": ("More Zernike terms, 33 × 33 pixels, 1 rad rms", "Zernike terms"),
    "tolerance, 512²": ("Smaller tolerances, 512 × 512 pixels", "tolerance (fraction of the peak)"),
    "pupils of 17²": ("More PSFs in one call, 17 × 17 pixels", "PSFs in one call"),
}
_PUPILS = {
    "radial": "radially symmetric",
    "15 terms": "15 Zernike terms",
    "one pupil": "1 PSF in a call",
    "16 pupils": "16 PSFs in a call",
}


def draw_costs(costs: dict[str, Any], path: Path) -> None:
    """Draw the table of costs of a pixel, as it stands in the JSON file: a panel for each that they are against."""
    from matplotlib.figure import Figure

    panels: dict[str, dict[str, list[tuple[float, float]]]] = {}
    for row in costs["rows"]:
        curves = panels.setdefault(row["against"], {})
        curves.setdefault(row["pupil"], []).append((float(row["at"]), row["cost"]["median"]))
    figure = Figure(figsize=(9.6, 9.0), layout="constrained")
    figure.get_layout_engine().set(w_pad=0.1, h_pad=0.1)  # type: ignore[union-attr, call-arg]
    figure.suptitle("Time of a pixel on one thread (1 = absolute value of a complex number by NumPy)", fontsize=11)
    for k, (against, curves) in enumerate(panels.items()):
        axes = figure.add_subplot(3, 2, k + 1)
        for (name, curve), color in zip(curves.items(), ("#c1121f", "#2b2d42"), strict=False):
            x, y = np.array(curve).T
            axes.loglog(x, y, "o-", color=color, label=_PUPILS.get(name, name), markersize=4)
        if against.startswith("tolerance"):
            axes.invert_xaxis()
        title, label = _PANELS.get(against, (against, against))
        axes.set_title(title, fontsize=10)
        axes.set_xlabel(label)
        axes.set_ylabel("time of a pixel")
        axes.grid(linewidth=0.3)
        axes.minorticks_off()
        axes.legend(fontsize=8)
    figure.savefig(path, dpi=120, metadata={"Software": None})
