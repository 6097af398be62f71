"""The page of the documentation, from the results as they stand in the JSON file."""

from __future__ import annotations

from typing import Any

from benchmarks.report import Table, markdown

_HEAD = """# Benchmarks

Written by `make bench` from `benchmarks/results.json`; not to be edited.

Every number is a ratio of two things measured in one process, in turn (A B A B ...), warm unless it says cold: the
median of the ratios of neighbouring turns, in brackets the smallest and the largest. A turn is the fastest of three
batches of calls, each of 2 ms or more, so that what else the machine does counts for little. The BLAS and the FFT of
the baselines use one thread, lommel one unless the row says two. Each call of lommel gets a pupil that it has not
seen. An error is always `max |I - I_exact| / max I_exact` against quadrature, never against an FFT. For a radially
symmetric pupil this is Gauss-Legendre quadrature (`lm.Hankel()`) at the radius of every pixel (of 20 000 pixels and
the row through the axis in windows beyond 1024²). For any other it is one over the whole aperture, in plain NumPy,
for every pixel of 33 rows of 512², those about the peak among them, and for 16 images of a stack.
"""

_AGAIN = """## Inside other frameworks

[Twins](twins.md) in JAX and PyTorch are measured by `python -m benchmarks.twins` on processors, and by
`python -m benchmarks.gpu` on graphics processors. None of the latter has been measured: what that page says of them
are estimates, from the bytes that a PSF takes over the bandwidth of the memory.

## How to run it again

```sh
make bench                                        # everything: a few minutes; writes this page
make peers                                        # first, to have the other packages measured as well
.venv/bin/python benchmarks/run.py --quick        # under a minute, writes nothing
.venv/bin/python benchmarks/run.py --only sizes   # one table; --list names them
```

`make bench` fails if a row of the first table misses what it must reach, twice in a row: a busy machine is given a
second chance, and the note of the row says so. What other programs do to the caches and to memory at the same time
shows in the brackets.
"""


def write(results: dict[str, Any], figure: str) -> str:
    """Return the page."""
    machine = results["machine"]
    versions = ", ".join(f"{name} {number}" for name, number in machine["versions"].items())
    yards = ", ".join(f"{name} {value:,.0f} µs".replace(",", " ") for name, value in machine["yardsticks"].items())
    parts = [
        _HEAD,
        f"Machine: {machine['processor']}, {machine['processors in use']} processors, {machine['memory']}, "
        f"{machine['system']}. Versions: {versions}. Date: {results['date']}. For scale, in this run: {yards}.\n",
    ]
    for plain in results["tables"]:
        parts.append(markdown(Table(**plain)))
        if plain["key"] == "sizes":
            parts.append(f"![Cost of one PSF against the side of the window, for each way to compute it]({figure})\n")
    parts.append(_AGAIN)
    return "\n".join(parts)


_FIRST, _LAST = "<!-- benchmarks: written by make bench -->", "<!-- end of benchmarks -->"


def first_screen(readme: str, results: dict[str, Any], figure: str) -> str:
    """Return the README with the figure and the targets between its two marks."""
    targets = next(Table(**plain) for plain in results["tables"] if plain["key"] == "targets")
    head, _, rest = readme.partition(_FIRST)
    _, mark, tail = rest.partition(_LAST)
    if not mark:
        raise ValueError(f"README.md must have the marks {_FIRST!r} and {_LAST!r}")
    names = list(targets.columns)
    lines = [names, ["---"] * len(names), *(c for c in targets.cells() if c[names.index("must")] != "–")]
    table = "\n".join("| " + " | ".join(line) + " |" for line in lines)
    text = (
        "One thread unless the row says otherwise, through the public Python call; medians of ratios taken in one "
        "process, in\nbrackets the extremes; the worst of all cases of a row. 'Must' and 'aim' are what was asked "
        "of it.\n[How, and much more](docs/benchmarks.md).\n"
    )
    picture = f"![Cost of one PSF against the side of the window, for each way to compute it]({figure})"
    return f"{head}{_FIRST}\n{picture}\n\n{text}\n{table}\n{_LAST}{tail}"
