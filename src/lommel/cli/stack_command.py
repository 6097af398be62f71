"""The command for many PSFs over the distance of the object: ``lommel stack``."""

from __future__ import annotations

import math
import time
from pathlib import Path
from typing import Any

import click
import numpy as np

from lommel.cli.parts import Length, Shape, instrument_of, one_line_errors, print_json
from lommel.cli.progress import progress

_MOST = 10**9


@click.command()
@click.argument("lens", type=click.Path(dir_okay=False, path_type=Path))
@click.option(
    "--between", type=Length(), nargs=2, required=True, help="Nearest and farthest distance: 1m 3m, or 1m inf."
)
@click.option("--count", type=click.IntRange(2, _MOST), required=True, help="How many distances, even in defocus.")
@click.option("-o", "--output", type=click.Path(path_type=Path), required=True, help="The store: .zarr or .h5.")
@click.option("--pixel", type=Length(), help='Pixel pitch, instead of the file\'s: "3.45 um".')
@click.option("--shape", type=Shape(), help="Window in pixels, instead of the file's: 65 or 64x128.")
@click.option("--tol", type=float, help="Tolerance, relative to the peak.")
@click.option("--chunk", type=int, help="Most PSFs in a chunk; by default as many as 16 MiB hold.")
@click.option("--json", "as_json", is_flag=True, help="Print what was made as JSON.")
@one_line_errors
def stack(
    lens: Path,
    between: tuple[float, float],
    count: int,
    output: Path,
    tol: float | None,
    chunk: int | None,
    as_json: bool,
    **options: Any,
) -> None:
    """Compute PSFs over the distance of the object into a store, which need not fit into memory.

    The same command goes on where one was ended.

    \b
    Examples:
      lommel stack lens.toml --between 1m inf --count 200 --shape 17 -o stack.zarr
    """  # noqa: D301 (\b is meant)
    from lommel.stacks.compute import psf_to

    near, far = between
    if not 0.0 < near < far:
        raise ValueError(f"--between must be two rising distances, got {near:g} and {far:g} metres")
    instrument = instrument_of(lens, **options)
    with np.errstate(divide="ignore"):
        distances = 1.0 / np.linspace(1.0 / near, 1.0 / far, count)
    distances[0], distances[-1] = near, far
    window, begun, steps = instrument.window, time.perf_counter(), 0
    with progress(f"{count} PSFs of {window[0]} x {window[1]} pixels") as step:

        def done(chunks: int, total: int) -> None:
            nonlocal steps
            steps += 1
            step(f"chunk {chunks} of {total}", chunks / total)

        made = psf_to(
            output,
            instrument.lens.pupil(distances),
            window,
            instrument.pixel,
            tol=tol,
            chunk=chunk,
            integrate=instrument.integrate,
            progress=done,
        )
    bound, seconds = float(made.error_bound.max()), time.perf_counter() - begun
    if as_json:
        facts = {"store": str(output), "shape": list(made.shape), "dtype": str(made.dtype), "seconds": seconds}
        bounded = None if math.isnan(bound) else bound
        print_json(facts | {"chunks": made.done[1], "computed": steps, "error_bound": bounded})
        return
    shown = "without a bound" if math.isnan(bound) else f"error at most {bound:.2g} of the peak"
    click.echo(f"{made!r}: {shown}; {steps} of {made.done[1]} chunks computed in {seconds:.3g} s")
