"""The command ``lommel stack``: many PSFs over object distance, in a store on disk."""

from __future__ import annotations

import math
import time
from pathlib import Path
from typing import TYPE_CHECKING

import click
import numpy as np

from lommel.cli.instruments import CAMERA, LENS, SHAPE, SQUARE_PIXEL, instrument_of
from lommel.cli.options import JSON, OUTPUT_PATH, command, documented, option
from lommel.cli.output import Report, progress
from lommel.psf import psf
from lommel.stacks.compute import psf_to

if TYPE_CHECKING:
    from lommel.lensfiles.instrument import Camera


@command(JSON)
def stack(
    lens: Path = LENS,
    between: tuple[float, float] = option(length="m", nargs=2, required=True, metavar="NEAR FAR",
        help="Nearest and farthest object distance, such as 1m 3m or 1m inf."),
    count: int = option(type=click.IntRange(2, 10**9), required=True,
        help="Number of distances, equally spaced in defocus."),
    output: Path = option("-o", "--output", type=OUTPUT_PATH, required=True, help="Store to write, a folder .zarr."),
    camera: Camera | None = CAMERA,
    pixel: float | None = SQUARE_PIXEL,
    shape: int | tuple[int, int] | None = SHAPE,
    tol: float | None = documented(psf, "tol", type=float,
        help="Tolerance, relative to the peak; by default 1e-6."),
    chunk: int | None = option(type=int,
        help="Maximum number of PSFs in a chunk; by default as many as fit in 16 MiB."),
) -> Report:  # fmt: skip
    """Compute PSFs over a range of object distances, on disk.

    The PSFs are written to a store on disk, which may be larger than memory. An interrupted command can be repeated:
    it computes only the missing chunks.

    Example:
      lommel stack phone.toml --between 1m inf --count 200 --shape 17 -o stack.zarr
    """
    near, far = between
    if not 0.0 < near < far:
        raise ValueError(f"--between must be two rising distances, got {near:g} and {far:g} metres")
    instrument = instrument_of(lens, camera=camera, pixel=pixel, shape=shape)
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
    facts = {"store": str(output), "shape": list(made.shape), "dtype": str(made.dtype), "seconds": seconds}
    facts |= {"chunks": made.done[1], "computed": steps, "error_bound": None if math.isnan(bound) else bound}
    shown = "no error bound" if math.isnan(bound) else f"error at most {bound:.2g} of the peak"
    computed = f"{steps} of {made.done[1]} chunks computed in {seconds:.3g} s"
    return Report(facts, [f"{made!r}: {shown}; {computed}"])
