"""The commands for photographs: ``lommel blur`` and ``lommel focus-pull``."""

from __future__ import annotations

import math
import signal
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from lommel.base.units import format_length, parse_length
from lommel.cli.parts import Length, one_line_errors, print_json, progress

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from lommel.imaging import Photograph, Picture
    from lommel.optics.lens import Lens

_AGREE = 0.02  # EXIF has the nominal figures of a lens, rounded

_File = click.Path(dir_okay=False, path_type=Path)


class _Wavelengths(click.ParamType[tuple[float, ...]]):
    name = "lengths"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> tuple[float, ...]:
        try:
            return tuple(parse_length(part.strip()) for part in value.split(","))
        except ValueError as error:
            self.fail(str(error), param, ctx)


def _photo_command(command: Callable[..., None]) -> Callable[..., None]:
    """Add what both commands take."""
    kinds = {"bits": ["8", "16", "float"], "border": ["reflect", "extend", "zero"]}
    parts = [
        click.argument("photo", type=_File),
        click.argument("depth", type=_File),
        click.argument("lens", type=_File, required=False),
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
        click.option("--border", type=click.Choice(kinds["border"]), default="reflect", show_default=True,
                     help="What lies beyond the edges of the photo."),
        click.option("--occlusion/--no-occlusion", default=True, show_default=True,
                     help="Near points hide far ones; without, light is only added, which is quicker."),
        click.option("--energy", type=float, default=0.98, show_default=True,
                     help="Share of the light of each point that its window must hold."),
        click.option("--tol", type=float, default=1e-4, show_default=True,
                     help="Error of interpolated windows, over their peak."),
        click.option("--largest", type=int, help="Pixels from the middle of a window to its edge, at most."),
        click.option("--missing", type=click.Choice(["raise", "nearest", "infinity"]), default="raise",
                     show_default=True, help="What is where the depth is unknown."),
        click.option("--depth-scale", type=float, help="Metres per level; needed for a depth of integers."),
        click.option("--zero-unknown", is_flag=True, help="A depth of 0 means unknown."),
        click.option("--bits", type=click.Choice(kinds["bits"]), help="Of the output; by default the photo's."),
        click.option("--quality", type=int, default=95, show_default=True, help="Of JPEG and WebP, 1 to 100."),
        click.option("--json", "as_json", is_flag=True, help="Print what was done as JSON."),
    ]  # fmt: skip
    for part in reversed(parts):
        command = part(command)
    return command


@click.command()
@_photo_command
@click.option("-o", "--output", required=True, type=_File, help=".png, .jpg or .tif.")
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
    from lommel.io.photos import find, write_photo

    find(output, "--output")
    with _terminated_as_interrupted(), progress("reading"):
        job = _prepare(output, options)
        find(output, "--output", holding=f"of {job.dtype}")
        lens = job.lens(focus, "--focus")
    with _terminated_as_interrupted(), progress("blurring"):
        start = time.perf_counter()
        made = job.photograph(lens)
        seconds = time.perf_counter() - start
        same = job.encoding == job.picture.encoding
        clipped = write_photo(
            output,
            made.values,
            encoding=job.encoding,
            dtype=job.dtype,
            quality=options["quality"],
            profile=job.picture.profile if same else None,
        )
    facts = job.facts(lens) | {"focus_distance": _finite(lens.focus_distance), "seconds": seconds}
    facts |= _quality([made], [clipped]) | {"files": [str(output)]}
    _tell(facts, as_json)


@click.command("focus-pull")
@_photo_command
@click.option("-o", "--output", required=True, type=_File,
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
    from lommel.io.frames import check_pattern, is_animation, write_frames
    from lommel.io.photos import find, stored

    check_pattern(output, "--output")
    for name, distance in (("--from", first), ("--to", last)):
        if not distance > 0.0:
            raise ValueError(f"{name} must be > 0 metres, got {distance:g}")
    steps = [1.0 / first + (1.0 / last - 1.0 / first) * k / (frames - 1) for k in range(frames)]
    photographs: list[Photograph] = []
    shares: list[float] = []
    with _terminated_as_interrupted(), progress("reading", total=frames) as started:
        job = _prepare(output, options)
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
                photographs.append(_without_values(photograph))
                shares.append(clipped)
                yield values

        files = write_frames(output, made(), fps=fps, quality=options["quality"])
        seconds = time.perf_counter() - start
    facts = job.facts(lenses[0]) | {
        "frames": frames,
        "focus_distances": [_finite(lens.focus_distance) for lens in lenses],
        "seconds": seconds,
    }
    _tell(facts | _quality(photographs, shares) | {"files": [str(path) for path in files]}, as_json)


@dataclass(frozen=True, eq=False)
class _Job:
    """A photograph, its depth, and how a lens is to be made of the options."""

    picture: Picture
    light: NDArray[Any]
    depth: NDArray[np.float64]
    encoding: str
    dtype: np.dtype[Any]
    pixel: float
    optics: Lens
    focused: bool
    settings: dict[str, Any]

    def lens(self, focus: float | None, name: str) -> Lens:
        """Return the lens, focused at a distance or, without one, as its file says."""
        if focus is None and not self.focused:
            raise ValueError(f"without a lens file give {name}")
        try:
            return self.optics if focus is None else self.optics.focused(focus)
        except ValueError as error:
            raise ValueError(str(error).replace("focus_distance", name)) from None

    def photograph(self, lens: Lens) -> Photograph:
        """Return what the lens makes of it, as light."""
        from lommel.imaging import depth_of_field

        return depth_of_field(self.light, self.depth, lens, self.pixel, encoding="linear", **self.settings)

    def facts(self, lens: Lens) -> dict[str, Any]:
        """Return what there is to say of all of it."""
        return {
            "shape": list(self.light.shape),
            "encoding": {"photo": self.picture.encoding, "output": self.encoding},
            "bits": "float" if self.dtype.kind == "f" else str(8 * self.dtype.itemsize),
            "focal_length": lens.focal_length,
            "f_number": lens.f_number,
            "pixel": self.pixel,
        }


def _prepare(output: Path, options: dict[str, Any]) -> _Job:
    import numpy as np

    from lommel.imaging import read_depth, read_photo

    picture = read_photo(options["photo"], options["encoding"])
    depth = read_depth(options["depth"], scale=options["depth_scale"], zero_is_unknown=options["zero_unknown"])
    if depth.shape != picture.values.shape[:2]:
        raise ValueError(
            f"{options['depth']} must have the size of the upright photo, "
            f"{picture.values.shape[1]} x {picture.values.shape[0]}, got {depth.shape[1]} x {depth.shape[0]}"
        )
    colours = picture.values.ndim == 3
    wavelengths = options["wavelengths"]
    if wavelengths is not None and len(wavelengths) != (3 if colours else 1):
        raise ValueError(f"--wavelengths must be {'three' if colours else 'one'}, got {len(wavelengths)}")
    lens, pixel = _optics(picture, options, 540e-9 if colours else 550e-9)
    given = options["bits"]
    if given is None:
        small = output.suffix.lower() not in (".tif", ".tiff")
        given = "float" if picture.values.dtype.kind == "f" else str(8 * picture.values.dtype.itemsize)
        if output.suffix.lower() in (".jpg", ".jpeg"):
            given = "8"
        elif given == "float" and small:
            given = "16"
    dtype = np.dtype({"8": np.uint8, "16": np.uint16, "float": np.float32}[given])
    # Values of the same kind stay encoded as they are; others become what readers will take them for.
    kept = (dtype.kind == "f") == (picture.values.dtype.kind == "f")
    encoding = picture.encoding if kept else "linear" if dtype.kind == "f" else "srgb"
    settings = {name: options[name] for name in ("border", "occlusion", "energy", "tol", "largest", "missing")}
    settings["wavelengths"] = wavelengths
    focused = options["lens"] is not None
    return _Job(picture, picture.light(), depth, encoding, dtype, pixel, lens, focused, settings)


def _optics(picture: Picture, options: dict[str, Any], wavelength: float) -> tuple[Lens, float]:
    """Return the lens, focused as its file says or at infinity, and the pixel pitch."""
    from lommel.optics.lens import Lens

    exif = picture.exif
    if options["pixel"] is not None and options["pixel_from_exif"]:
        raise ValueError("give one of --pixel and --pixel-from-exif")
    if options["no_exif"] and options["pixel_from_exif"]:
        raise ValueError("--pixel-from-exif contradicts --no-exif")
    pixel = exif.pixel(picture.values.shape) if options["pixel_from_exif"] else options["pixel"]
    if options["lens"] is not None:
        return _of_file(options, pixel)
    found: dict[str, Any] = {}
    for name, option, show in (
        ("focal_length", "--focal-length", format_length),
        ("f_number", "--f-number", lambda n: f"f/{n:g}"),
    ):
        given, read = options[name], None if options["no_exif"] else getattr(exif, name)
        if given is None and read is None:
            reason = "EXIF is left out" if options["no_exif"] else f"{options['photo']} has none in its EXIF"
            raise ValueError(f"give a lens file or {option}: {reason}")
        if given is not None and read is not None and not math.isclose(given, read, rel_tol=_AGREE):
            raise ValueError(
                f"{option} {show(given)} contradicts the EXIF of {options['photo']}, {show(read)}; "
                "to leave that out give --no-exif"
            )
        found[name] = read if given is None else given
    if pixel is None:
        raise ValueError("without a lens file give --pixel or --pixel-from-exif")
    return Lens(**found, wavelength=wavelength), pixel


def _of_file(options: dict[str, Any], pixel: float | None) -> tuple[Lens, float]:
    from lommel.lensfiles.lens_files import load_instrument

    if options["focal_length"] is not None or options["pixel_from_exif"]:
        stray = "--focal-length" if options["focal_length"] is not None else "--pixel-from-exif"
        raise ValueError(f"{stray} has no meaning with a lens file, which states it")
    instrument = load_instrument(options["lens"])
    if instrument.aberrations_of_field is not None:
        raise ValueError(f"{options['lens']} has aberrations that vary over the field; a blur has one set of them")
    lens = instrument.lens
    if options["f_number"] is not None:
        try:
            lens = lens.stopped(options["f_number"])
        except ValueError as error:
            raise ValueError(f"--f-number of {options['lens']}: {error}") from None
    return lens, instrument.pixel if pixel is None else pixel


def _quality(photographs: list[Photograph], clipped: list[float]) -> dict[str, Any]:
    return {
        "largest_window": max(p.window for p in photographs),
        "light_beyond_windows": max(p.lost for p in photographs),
        "interpolation_error": max(p.error for p in photographs),
        "clipped": max(clipped),
    }


def _without_values(photograph: Photograph) -> Photograph:
    from dataclasses import replace

    return replace(photograph, values=photograph.values[:0])


def _finite(distance: float) -> float | str:
    """Return a distance as JSON can hold it."""
    return distance if math.isfinite(distance) else "infinity"


def _tell(facts: dict[str, Any], as_json: bool) -> None:
    if as_json:
        print_json(facts)
        return
    height, width, *_ = facts["shape"]
    click.echo(
        f"{width} x {height} pixels of {format_length(facts['pixel'])}; "
        f"f = {format_length(facts['focal_length'])}, f/{facts['f_number']:.3g}"
    )
    click.echo(
        f"windows up to {facts['largest_window']} pixels, which leave out {facts['light_beyond_windows']:.2g} of the "
        f"light and err by {facts['interpolation_error']:.2g} of their peak"
    )
    if facts["clipped"]:
        click.echo(f"clipped at white: {100.0 * facts['clipped']:.2g} % of the values")
    for name in facts["files"]:
        click.echo(f"wrote {name}")


@contextmanager
def _terminated_as_interrupted() -> Iterator[None]:
    """Have a SIGTERM clean up as Ctrl-C does."""

    def interrupt(*_: Any) -> None:
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGTERM, interrupt)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before)
