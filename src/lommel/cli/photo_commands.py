"""The commands for photographs: ``lommel blur`` and ``lommel focus-pull``."""

from __future__ import annotations

import math
import signal
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np

from lommel.base.options import sentence
from lommel.base.units import format_length
from lommel.cli.parts import FILE, Length, one_line_errors, print_json
from lommel.cli.photo_job import KINDS, Request
from lommel.cli.progress import progress
from lommel.imaging import Photograph
from lommel.imaging.settings import BORDERS, MISSING, Settings
from lommel.io.frames import check_pattern, is_animation, write_frames
from lommel.io.photos import find, stored, write_photo

if TYPE_CHECKING:
    from numpy.typing import NDArray


class _Wavelengths(click.ParamType[tuple[float, ...]]):
    name = "lengths"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> tuple[float, ...]:
        return tuple(Length().convert(part.strip(), param, ctx) for part in value.split(","))


def photo_command(command: Callable[..., None]) -> Callable[..., None]:
    """Add what all commands take that are about a photograph, its depth and its lens."""
    parts = [
        click.argument("photo", type=FILE),
        click.argument("depth", type=FILE),
        click.argument("lens", type=FILE, required=False),
        click.option("--f-number", type=float, help="Instead of the lens file's, or without EXIF's."),
        click.option("--focal-length", type=Length(), help="Without a lens file; by default EXIF's."),
        click.option("--pixel", type=Length(), help="Pixel pitch, instead of the lens file's."),
        click.option("--pixel-from-exif", is_flag=True,
                     help="Pixel pitch by EXIF's 35 mm equivalent, good to a few per cent, of an uncropped photo."),
        click.option("--no-exif", is_flag=True, help="Do not look at what the photo says of its lens."),
        click.option("--wavelengths", type=_Wavelengths(),
                     help='One a channel: "600nm, 540nm, 460nm", the default for colours. Grey: the lens file\'s, '
                     "or 550 nm."),
        click.option("--encoding", type=click.Choice(["srgb", "linear"]),
                     help="Of the photo's values. By default integers are sRGB, floats linear."),
        _of_settings("border", type=click.Choice(BORDERS)),
        _of_settings("occlusion", "--occlusion/--no-occlusion"),
        _of_settings("energy", type=float),
        _of_settings("tol", type=float),
        _of_settings("largest", type=int),
        _of_settings("missing", type=click.Choice(MISSING)),
        click.option("--depth-scale", type=float, help="Metres per level; needed for a depth of integers."),
        click.option("--zero-unknown", is_flag=True, help="A depth of 0 means unknown."),
        click.option("--bits", type=click.Choice(list(KINDS)), help="Of the output; by default the photo's."),
        click.option("--quality", type=int, default=95, show_default=True, help="Of JPEG and WebP, 1 to 100."),
        click.option("--json", "as_json", is_flag=True, help="Print what was done as JSON."),
    ]  # fmt: skip
    for part in reversed(parts):
        command = part(command)
    return command


def _of_settings(name: str, *flags: str, **more: Any) -> Callable[..., Any]:
    """Return an option for one of the settings of a photograph, with its default and its text."""
    default = getattr(Settings, name)
    shown = default is not None
    return click.option(
        *(flags or (f"--{name}",)), default=default, show_default=shown, help=sentence(Settings, name), **more
    )


@click.command()
@photo_command
@click.option("-o", "--output", required=True, type=FILE, help=".png, .jpg or .tif.")
@click.option("--focus", type=Length(), help='Distance in focus: "1.5 m", "inf"; instead of the lens file\'s.')
@one_line_errors
def blur(output: Path, focus: float | None, as_json: bool, **options: Any) -> None:
    """Blur a sharp photograph by its depth, as a lens would.

    PHOTO is PNG, JPEG or TIFF, grey or RGB. DEPTH has the distance of each of its points from the lens, in metres: a
    grey TIFF, NPY, PFM or PNG of the same size. LENS is a lens file; without it, focal length and f-number are the
    options', or those of the photo's EXIF, which must not contradict the options.

    What is brighter than white stays white in integers, as on a sensor; how much, is told.

    \b
    Examples:
      lommel blur photo.jpg depth.tif --focus "1.2 m" --pixel 4um -o out.jpg
      lommel blur photo.png depth.png lens.toml --depth-scale 0.001 --zero-unknown --missing nearest -o out.tif
    """  # noqa: D301 (\b is meant)
    request = Request.of(options)
    find(output, "--output")
    with terminated_as_interrupted(), progress("reading") as started:
        job = request.job(output)
        find(output, "--output", holding=f"of {job.dtype}")
        lens = job.lens(focus, "--focus")
        started("making windows")
        start = time.perf_counter()
        made = job.photograph(lens, lambda share: started("blurring", share))
        seconds = time.perf_counter() - start
        same = job.encoding == job.picture.encoding
        clipped = write_photo(
            output,
            made.values,
            encoding=job.encoding,
            dtype=job.dtype,
            quality=request.quality,
            profile=job.picture.profile if same else None,
        )
    facts = job.facts(lens) | {"focus_distance": finite(lens.focus_distance), "seconds": seconds}
    facts |= _quality([made], [clipped]) | {"files": [str(output)]}
    _tell(facts, as_json)


@click.command("focus-pull")
@photo_command
@click.option("-o", "--output", required=True, type=FILE,
              help="Numbered, as out-%03d.png (.jpg, .tif), or one .gif, .png, .webp or .tif.")  # fmt: skip
@click.option("--from", "first", type=Length(), required=True, help="Distance in focus of the first frame.")
@click.option("--to", "last", type=Length(), required=True, help='Of the last; may be "inf".')
@click.option("--frames", type=click.IntRange(2, 9999), default=24, show_default=True)
@click.option("--fps", type=float, default=12.0, show_default=True, help="Of an animation.")
@one_line_errors
def focus_pull(
    output: Path, first: float, last: float, frames: int, fps: float, as_json: bool, **options: Any
) -> None:
    """Turn the focus of a lens through a photograph, from one distance to another.

    Frames are equally spaced in dioptres, which is how a lens moves. Arguments are those of `lommel blur`. A run that
    fails, or is interrupted, writes nothing.

    \b
    Examples:
      lommel focus-pull photo.png depth.tif lens.toml --from "0.8 m" --to "4 m" --frames 48 -o pull-%03d.png
      lommel focus-pull photo.png depth.tif lens.toml --from "0.8 m" --to inf --fps 24 -o pull.webp
    """  # noqa: D301 (\b is meant)
    request = Request.of(options)
    check_pattern(output, "--output")
    for name, distance in (("--from", first), ("--to", last)):
        if not distance > 0.0:
            raise ValueError(f"{name} must be > 0 metres, got {distance:g}")
    steps = [1.0 / first + (1.0 / last - 1.0 / first) * k / (frames - 1) for k in range(frames)]
    photographs: list[Photograph] = []
    shares: list[float] = []
    with terminated_as_interrupted(), progress("reading", total=frames) as started:
        job = request.job(output)
        if is_animation(output) and job.dtype.itemsize > 1:
            raise ValueError(f"{output.suffix} holds 8 bits; give --bits 8, a .tif, or a number such as %03d")
        if "%" in output.name:
            find(output, "--output", holding=f"of {job.dtype}")
        lenses = [job.lens(1.0 / step if step else math.inf, "--from and --to") for step in steps]
        start = time.perf_counter()

        def made() -> Iterator[NDArray[Any]]:
            for number, lens in enumerate(lenses, 1):
                started(f"frame {number} of {frames}, focus {format_length(lens.focus_distance)}")
                photograph = job.photograph(lens)
                values, clipped = stored(photograph.values, job.encoding, job.dtype)
                photographs.append(replace(photograph, values=np.empty(0)))  # a view would keep them all
                shares.append(clipped)
                yield values

        files = write_frames(output, made(), fps=fps, quality=request.quality)
        seconds = time.perf_counter() - start
    facts = job.facts(lenses[0]) | {
        "frames": frames,
        "focus_distances": [finite(lens.focus_distance) for lens in lenses],
        "seconds": seconds,
    }
    _tell(facts | _quality(photographs, shares) | {"files": [str(path) for path in files]}, as_json)


def _quality(photographs: list[Photograph], clipped: list[float]) -> dict[str, Any]:
    return {
        "largest_window": max(p.window for p in photographs),
        "light_beyond_windows": max(p.lost for p in photographs),
        "interpolation_error": max(p.error for p in photographs),
        "clipped": max(clipped),
    }


def finite(distance: float) -> float | str:
    """Return a distance as JSON can hold it."""
    return distance if math.isfinite(distance) else "infinity"


def _tell(facts: dict[str, Any], as_json: bool) -> None:
    if as_json:
        print_json(facts)
        return
    click.echo(facts["read"])
    height, width, *_ = facts["shape"]
    click.echo(
        f"{width} x {height} pixels of {format_length(facts['pixel'])}; "
        f"f = {format_length(facts['focal_length'])}, f/{facts['f_number']:.3g}"
    )
    if facts["light_beyond_windows"]:
        click.echo(
            f"windows up to {facts['largest_window']} pixels, which leave out {facts['light_beyond_windows']:.2g} of "
            f"the light and err by {facts['interpolation_error']:.2g} of their peak"
        )
    else:
        click.echo(
            f"windows up to {facts['largest_window']} pixels and a remainder, which leave out nothing and err by "
            f"{facts['interpolation_error']:.2g} of the brightest point"
        )
    if facts["clipped"]:
        click.echo(f"clipped at white: {100.0 * facts['clipped']:.2g} % of the values")
    for name in facts["files"]:
        click.echo(f"wrote {name}")


@contextmanager
def terminated_as_interrupted() -> Iterator[None]:
    """Have a SIGTERM clean up as Ctrl-C does."""

    def interrupt(*_: Any) -> None:
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGTERM, interrupt)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before)
