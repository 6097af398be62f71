"""docs/benchmarks.md, written from benchmarks/results.json."""

from __future__ import annotations

from typing import Any

from benchmarks.report import Table, markdown

_HEAD = """# Benchmarks

Written by `make bench` from `benchmarks/results.json`; do not edit this page.

Every number is a ratio of two runs measured alternately in one process (A B A B ...), warm unless a row says cold:
the median of the ratios of neighbouring runs, with the smallest and the largest in brackets. Each run is the
fastest of three batches of calls of at least 2 ms, which reduces the influence of other programs. BLAS and FFT of
the baselines use one thread, lommel one unless the row says two. Every call of lommel is given a pupil that it has
not seen before.

The true error is `max |I - I_exact| / max I_exact` against quadrature, never against an FFT. For radially symmetric
pupils the reference is Gauss-Legendre quadrature (`lm.Hankel()`) at the radius of every pixel (in windows beyond
1024²: 20 000 pixels and the row through the axis). For all other pupils it is a quadrature over the whole aperture
in plain NumPy, for every pixel of 33 rows of 512², including those about the peak, and for 16 images of a stack.

C_d and C_s are the coefficients of defocus and primary spherical aberration in radians at the edge of the pupil
(W020 = C_d / π and W040 = C_s / (2π) waves); λN is the wavelength times the f-number.
"""

_AGAIN = """## Differentiable PSFs

[Differentiable PSFs](differentiable.md) are measured by `python -m benchmarks.differentiable` on CPUs, and by
`python -m benchmarks.gpu` on graphics processors. No graphics processor has been measured yet: the figures for these
are estimates from the memory traffic of a PSF and the bandwidth of the memory.

## Reproduce

```sh
make bench                                        # everything: a few minutes; writes this page
make peers                                        # first, to include the other packages
.venv/bin/python benchmarks/run.py --quick        # under a minute, writes nothing
.venv/bin/python benchmarks/run.py --only sizes   # one table; --list names them
```

`make bench` also compares the overview with the limits in `benchmarks/limits.py`, and fails if a row exceeds its
limit in two runs. Load from other programs widens the ranges in brackets.
"""

# What is demanded of a row concerns developers: the terminal and the exit status of `make bench` say it.
_DEMANDS = ("must", "aim", "verdict")


# Tables that show what a second machine measured, and the heading of it.
WITH_SECOND = ["targets", "camera", "changes", "threads"]
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


def write(results: dict[str, Any], second: dict[str, Any]) -> str:
    """Return the page as Markdown; what a second machine measured stands beside."""
    machine = results["machine"]
    versions = ", ".join(f"{name} {number}" for name, number in machine["versions"].items())
    yards = ", ".join(f"{name} {value:,.0f} µs".replace(",", " ") for name, value in machine["yardsticks"].items())
    parts = [
        _HEAD,
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
