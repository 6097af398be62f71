"""The commands ``lommel blur`` (depth of field) and ``lommel restore`` (deblurring)."""

from __future__ import annotations

import math
import signal
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, fields, replace
from pathlib import Path
from types import FrameType
from typing import TYPE_CHECKING, Any, Self

import click
import numpy as np
from numpy.typing import NDArray

from lommel.base.units import format_length
from lommel.cli.options import FILE, JSON, LENGTH, LENGTHS, Option, command, documented, under
from lommel.cli.output import Facts, Report, written
from lommel.cli.progress import progress
from lommel.estimation.noise import Noise
from lommel.imaging import FocusPlan, Photograph, Picture, RichardsonLucy, TotalVariation, read_depth, read_photo
from lommel.imaging import restore as restored
from lommel.imaging.settings import BORDERS, MISSING, Settings
from lommel.io.photos import check_pattern, find, is_animation, stored, write_frames, write_photo
from lommel.io.registry import suffixes
from lommel.optics.lens import Lens

if TYPE_CHECKING:
    pass

_AGREE = 0.02  # EXIF has the nominal figures of a lens, rounded
_TYPES: dict[str, np.dtype[np.generic]] = {
    "8": np.dtype(np.uint8),
    "16": np.dtype(np.uint16),
    "float": np.dtype(np.float32),
}

_FRAMES, _FPS = 24, 12.0

_ARGUMENTS = [
    click.Argument(["photo"], type=FILE),
    click.Argument(["depth"], type=FILE),
    click.Argument(["lens"], type=FILE, required=False),
]
_FOCUS = Option("--focus", type=LENGTH, help="Focus distance, such as 1.5m or inf; overrides the lens file.")
_COMMON = [
    JSON,
    *under(
        "Camera",
        Option("--f-number", type=float, help="F-number; by default from the lens file or the EXIF."),
        Option("--focal-length", type=LENGTH,
               help="Focal length, where there is no lens file; by default from the EXIF."),
        Option("--pixel", type=LENGTH, help="Pixel pitch; overrides the lens file."),
        Option("--pixel-from-exif", is_flag=True,
               help="Pixel pitch from the 35 mm equivalent focal length in the EXIF, for uncropped photos; accurate "
               "to a few %."),
        Option("--no-exif", is_flag=True, help="Ignore the lens data of the EXIF."),
        Option("--wavelengths", type=LENGTHS,
               help="Wavelength of each channel; by default 600nm,540nm,460nm, and for a grey photo that of the lens "
               "file, or 550nm."),
    ),
    *under(
        "Photo and depth map",
        Option("--encoding", type=click.Choice(["srgb", "linear"]),
               help="Encoding of the photo's values; by default integers are sRGB and floats are linear."),
        Option("--depth-scale", type=float, help="Metres per level of an integer depth map, such as 0.001."),
        Option("--zero-unknown", is_flag=True, help="Treat depth 0 as unknown."),
        documented(Settings, "missing", type=click.Choice(MISSING)),
    ),
    *under(
        "Blur",
        documented(Settings, "border", type=click.Choice(BORDERS)),
        documented(Settings, "occlusion", "--occlusion/--no-occlusion", sentences=2),
        documented(Settings, "energy", type=float, sentences=3),
        documented(Settings, "tol", type=float),
        documented(Settings, "largest", type=int),
    ),
    *under(
        "Output file",
        Option("--bits", type=click.Choice(list(_TYPES)), help="Bits of the output; by default those of the photo."),
        Option("--quality", type=int, default=95, help="Quality of JPEG and WebP, 1 to 100."),
    ),
]  # fmt: skip


@command(
    *_ARGUMENTS,
    Option("-o", "--output", required=True, type=FILE, metavar="FILE",
           help=f"Blurred photo: {suffixes('photo')}. With --focus-to: numbered photos, such as out-%03d.png, or "
           f"one animation or stack: {suffixes('frames')}."),
    _FOCUS,
    *under(
        "Focus pull",
        Option("--focus-to", "last", type=LENGTH,
               help="Focus distance of the last frame: a focus pull from --focus in equal steps of dioptres."),
        Option("--frames", type=click.IntRange(2, 9999), help=f"Number of frames; by default {_FRAMES}."),
        Option("--fps", type=float, help=f"Frames per second of an animation; by default {_FPS:g}."),
    ),
    *_COMMON,
)  # fmt: skip
def blur(
    output: Path,
    focus: float | None,
    last: float | None,
    frames: int | None,
    fps: float | None,
    **given: Any,
) -> Report:
    """Blur a photo by its depth map, or pull the focus through it.

    PHOTO is a PNG, JPEG or TIFF, grey or RGB. DEPTH is a depth map of the same size, the distance of each point from
    the lens in metres: a grey TIFF, NPY, PFM or PNG. Without a lens file LENS, focal length and f-number come from
    the options or from the photo's EXIF; options that contradict the EXIF are refused.

    Integer values are clipped at white, as on a sensor, and the clipped fraction is printed.

    Examples
    --------
      lommel blur photo.jpg depth.tif --focus 1.2m --pixel 4um -o out.jpg
      lommel blur photo.png depth.png phone.toml --depth-scale 0.001 --zero-unknown --missing nearest -o out.tif
      lommel blur photo.png depth.tif phone.toml --focus 0.8m --focus-to 4m --frames 48 -o pull-%03d.png
      lommel blur photo.png depth.tif phone.toml --focus 0.8m --focus-to inf --fps 24 -o pull.webp
    """
    request = Request.of(given)
    if last is not None:
        return _pull_focus(request, output, (focus, last), frames or _FRAMES, _FPS if fps is None else fps)
    if frames is not None or fps is not None:
        raise ValueError(f"--{'frames' if frames is not None else 'fps'} needs --focus-to, the end of a focus pull")
    return _blur(request, output, focus)


def _blur(request: Request, output: Path, focus: float | None) -> Report:
    """Blur one photograph."""
    find(output, "--output")
    with terminated_as_interrupted(), progress("reading") as started:
        job = request.job(output)
        lens = job.lens(focus)
        started("computing PSFs")
        start = time.perf_counter()
        made = job.photograph(lens, lambda share: started("blurring", share))
        seconds = time.perf_counter() - start
        clipped = job.write(output, made.values)
    facts = job.facts(lens) | {"focus_distance": finite(lens.focus_distance), "seconds": seconds}
    return _blur_report(facts, [made], [clipped], [output])


def _pull_focus(request: Request, output: Path, ends: tuple[float | None, float], frames: int, fps: float) -> Report:
    """Blur a photograph once for each focus distance of a focus pull; a failure leaves no file."""
    first, last = ends
    check_pattern(output, "--output")
    for name, distance in (("--focus", first), ("--focus-to", last)):
        if distance is not None and not distance > 0.0:
            raise ValueError(f"{name} must be > 0 metres, got {distance:g}")
    photographs: list[Photograph] = []
    shares: list[float] = []
    with terminated_as_interrupted(), progress("reading", total=frames) as started:
        job = request.job(output, one_file="%" not in output.name)
        near = 1.0 / (job.lens(None).focus_distance if first is None else first)
        # A lens moves by equal steps where 1 / distance does.
        steps = [near + (1.0 / last - near) * k / (frames - 1) for k in range(frames)]
        lenses = [job.lens(1.0 / step if step else math.inf) for step in steps]
        start = time.perf_counter()

        def made() -> Iterator[NDArray[np.generic]]:
            for number, lens in enumerate(lenses, 1):
                started(f"frame {number} of {frames}, focus {format_length(lens.focus_distance)}")
                photograph = job.photograph(lens)
                values, clipped = stored(photograph.values, job.encoding, job.dtype)
                photographs.append(replace(photograph, values=np.empty(0)))  # a view would keep all of them
                shares.append(clipped)
                yield values

        files = write_frames(output, made(), fps=fps, quality=request.quality)
        seconds = time.perf_counter() - start
    facts = job.facts(lenses[0]) | {
        "frames": frames,
        "focus_distances": [finite(lens.focus_distance) for lens in lenses],
        "seconds": seconds,
    }
    return _blur_report(facts, photographs, shares, files)


_METHODS = ("richardson-lucy", "total-variation")


@command(
    *_ARGUMENTS,
    Option("-o", "--output", required=True, type=FILE, help=f"Restored photo: {suffixes('photo')}."),
    _FOCUS,
    *under(
        "Noise",
        Option("--white", type=float, required=True, help="Electrons of a white pixel, such as 5000."),
        documented(Noise, "read", type=float, required=True),
        Option("--offset", type=float, default=0.0, help="Black level, as a fraction of white."),
        Option("--saturation", type=float, help="Level at which pixels saturate; white is 1."),
    ),
    *under(
        "Restoration",
        Option("--method", type=click.Choice(_METHODS), default=_METHODS[0],
               help="Richardson-Lucy maximises the likelihood; total variation also smooths and preserves edges: "
               "usually less noise at the same sharpness, but ten to forty times slower."),
        Option("--steps", type=int,
               help=f"Maximum number of steps; by default {RichardsonLucy.steps}, with total-variation "
               f"{TotalVariation.steps} for each strength tried."),
        documented(RichardsonLucy, "target", type=float,
                   help="Discrepancy to stop at; below 1, since the result follows some of the noise."),
        Option("--strength", type=float,
               help="Weight of the total variation; by default such that the discrepancy is --target."),
    ),
    *_COMMON,
)  # fmt: skip
def restore(
    output: Path,
    focus: float | None,
    white: float,
    read: float,
    offset: float,
    saturation: float | None,
    method: str,
    steps: int | None,
    target: float,
    strength: float | None,
    **given: Any,
) -> Report:
    """Deblur a photo with a known depth map and lens.

    PHOTO is a PNG, JPEG or TIFF, grey or RGB, neither sharpened nor denoised. DEPTH is a depth map of the same size,
    the distance of each point from the lens in metres: a grey TIFF, NPY, PFM or PNG. Without a lens file LENS,
    focal length and f-number come from the options or from the photo's EXIF.

    The discrepancy compares the blurred result with the photo: it is about 1 where they differ only by noise. A
    larger one means that depth, lens or noise do not fit the photo.

    Examples
    --------
      lommel restore photo.tif depth.tif phone.toml --white 5000 --read 3 -o sharp.tif
      lommel restore photo.tif depth.tif phone.toml --white 5000 --read 3 --method total-variation -o sharp.png
    """
    request = Request.of(given)
    find(output, "--output")
    noise = Noise(white=white, read=read, offset=offset)
    way = _method(method, steps, target, strength)
    with terminated_as_interrupted(), progress("reading") as started:
        job = request.job(output)
        lens = job.lens(focus)
        started("computing PSFs")
        start = time.perf_counter()

        def step_done(step: int, discrepancy: float, left: float) -> None:
            spent = time.perf_counter() - start
            started(f"step {step}, discrepancy {discrepancy:.3g}", spent / max(spent + left, 1e-9))

        found = restored(
            job.picture.values,
            job.depth,
            lens,
            job.pixel,
            encoding=job.picture.encoding,
            noise=noise,
            method=way,
            saturation=saturation,
            progress=step_done,
            **vars(request.settings),
        )
        seconds = time.perf_counter() - start
        clipped = job.write(output, np.asarray(found.light))
    facts = job.facts(lens) | {"focus_distance": finite(lens.focus_distance), "seconds": seconds}
    facts |= {
        "method": method,
        "discrepancy": {"photo": found.before, "result": found.discrepancy, "by_channel": list(found.by_channel)},
        "steps": found.steps,
        "stopped": found.stopped,
        "strength": found.strength,
        "unknown": found.unknown,
        "clipped": clipped,
    }
    lines = [f"discrepancy {found.before:.3g} of the photo, {found.discrepancy:.3g} of the result"]
    if found.strength is not None:
        lines.append(f"strength of the total variation {found.strength:.3g}")
    why = {"noise": "the rest is noise", "steps": "maximum number of steps; more would fit better"}
    lines.append(f"stopped after {found.steps} steps: {why.get(found.stopped, found.stopped)}")
    if found.unknown:
        lines.append(f"saturated or unknown: {100.0 * found.unknown:.2g} % of the values")
    return _report(facts, lines, [output])


def _method(name: str, steps: int | None, target: float, strength: float | None) -> RichardsonLucy | TotalVariation:
    """Return the restoration method that the options describe."""
    if name == _METHODS[1]:
        count = TotalVariation.steps if steps is None else steps
        return TotalVariation(strength=strength, steps=count, target=target)
    if strength is not None:
        raise ValueError(f"--strength needs --method {_METHODS[1]}")
    return RichardsonLucy(steps=RichardsonLucy.steps if steps is None else steps, target=target)


def _blur_report(facts: Facts, photographs: list[Photograph], clipped: list[float], files: list[Path]) -> Report:
    """Return the report of blurred photographs, with the worst of their errors."""
    side, lost, error = (max(getattr(p, name) for p in photographs) for name in ("window", "lost", "error"))
    facts |= {"largest_window": side, "light_beyond_windows": lost, "interpolation_error": error}
    if lost:
        text = f"PSFs of up to {side} pixels, without {lost:.2g} of the light; error {error:.2g} of their peak"
    else:
        text = f"PSFs of up to {side} pixels and all light beyond; error {error:.2g} of the brightest point"
    return _report(facts | {"clipped": max(clipped)}, [text], files)


def _report(facts: Facts, lines: list[str], files: list[Path]) -> Report:
    """Return the report of photographs; the lines are those between what was read and what was clipped."""
    height, width, *_ = facts["shape"]
    f_number = f"f/{facts['f_number']:.3g}"
    pixels = f"{width} x {height} pixels of {format_length(facts['pixel'])}"
    lines = [facts["read"], f"{pixels}; f = {format_length(facts['focal_length'])}, {f_number}", *lines]
    if facts["clipped"]:
        lines.append(f"clipped at white: {100.0 * facts['clipped']:.2g} % of the values")
    return Report(facts, lines) + written(files)


def finite(distance: float) -> float | str:
    """Return a distance as JSON can hold it."""
    return distance if math.isfinite(distance) else "infinity"


@contextmanager
def terminated_as_interrupted() -> Iterator[None]:
    """Clean up after a SIGTERM as after Ctrl-C."""

    def interrupt(_signal: int, _frame: FrameType | None) -> None:
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGTERM, interrupt)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before)


@dataclass(frozen=True, kw_only=True)
class Request:
    """Arguments and options of a command for photographs."""

    photo: Path
    depth: Path
    lens: Path | None
    f_number: float | None
    focal_length: float | None
    pixel: float | None
    pixel_from_exif: bool
    no_exif: bool
    encoding: str | None
    depth_scale: float | None
    zero_unknown: bool
    bits: str | None
    quality: int
    settings: Settings

    @classmethod
    def of(cls, given: Facts) -> Self:
        """Return the request of a command's options, by their names."""
        own = {field.name for field in fields(cls)}
        settings = Settings(**{name: value for name, value in given.items() if name not in own})
        return cls(settings=settings, **{name: value for name, value in given.items() if name in own})

    def job(self, output: Path, *, one_file: bool = False) -> Job:
        """Read the files and choose how the output is stored; `one_file` for the frames of an animation or stack."""
        picture = read_photo(self.photo, self.encoding)
        depth = read_depth(self.depth, scale=self.depth_scale, zero_is_unknown=self.zero_unknown)
        height, width = picture.values.shape[:2]
        if depth.shape != (height, width):
            raise ValueError(
                f"{self.depth} must have the size of the upright photo, {width} x {height}, "
                f"got {depth.shape[1]} x {depth.shape[0]}"
            )
        pixel = self._pixel(picture)
        if self.lens is None:
            lens, file_pixel = self._lens_of_options(picture), None
        else:
            lens, file_pixel = self._lens_of_file(self.lens)
        pixel = file_pixel if pixel is None else pixel
        if pixel is None:
            raise ValueError("without a lens file give --pixel or --pixel-from-exif")
        dtype = _TYPES[self.bits or _bits(picture.values.dtype, output.suffix.lower())]
        if not one_file:
            find(output, "--output", holding=f"of {dtype}")
        elif is_animation(output) and dtype.itemsize > 1:
            raise ValueError(f"{output.suffix} holds 8 bits; give --bits 8, a .tif, or a number such as %03d")
        # Values of the same kind keep their encoding; others get the one that readers will take them for.
        kept = (dtype.kind == "f") == (picture.values.dtype.kind == "f")
        encoding = picture.encoding if kept else "linear" if dtype.kind == "f" else "srgb"
        return Job(self, picture, picture.light(), depth, encoding, dtype, pixel, lens)

    def _pixel(self, picture: Picture) -> float | None:
        """Return the pixel pitch of the options or of the EXIF, or None for that of the lens file."""
        if not self.pixel_from_exif:
            return self.pixel
        if self.pixel is not None:
            raise ValueError("give one of --pixel and --pixel-from-exif")
        if self.no_exif:
            raise ValueError("--pixel-from-exif contradicts --no-exif")
        return picture.exif.pixel(picture.values.shape)

    def _lens_of_options(self, picture: Picture) -> Lens:
        """Return a lens with the data of the options or the EXIF, focused at infinity."""
        exif = picture.exif
        return Lens(
            focal_length=self._agreed("--focal-length", self.focal_length, exif.focal_length, format_length),
            f_number=self._agreed("--f-number", self.f_number, exif.f_number, lambda n: f"f/{n:g}"),
            wavelength=540e-9 if picture.values.ndim == 3 else 550e-9,
        )

    def _agreed(self, option: str, given: float | None, read: float | None, show: Callable[[float], str]) -> float:
        """Return the value of an option or of the EXIF; ValueError if they contradict each other."""
        known = None if self.no_exif else read
        if given is None:
            if known is None:
                reason = "the EXIF is ignored" if self.no_exif else f"{self.photo} has none in its EXIF"
                raise ValueError(f"give a lens file or {option}: {reason}")
            return known
        if known is not None and not math.isclose(given, known, rel_tol=_AGREE):
            raise ValueError(
                f"{option} {show(given)} contradicts the EXIF of {self.photo}, {show(known)}; "
                "give --no-exif to ignore the EXIF"
            )
        return given

    def _lens_of_file(self, path: Path) -> tuple[Lens, float]:
        """Return the lens of a file, stopped down to --f-number, and its pixel pitch."""
        from lommel.lensfiles.lens_files import load_instrument

        if self.focal_length is not None or self.pixel_from_exif:
            stray = "--focal-length" if self.focal_length is not None else "--pixel-from-exif"
            raise ValueError(f"{stray} cannot be combined with a lens file, which states it")
        instrument = load_instrument(path)
        if instrument.aberrations_of_field is not None:
            raise ValueError(f"{path} has aberrations that vary over the field, which this command does not support")
        if self.f_number is None:
            return instrument.lens, instrument.side
        try:
            return instrument.lens.stopped(self.f_number), instrument.side
        except ValueError as error:
            raise ValueError(f"--f-number of {path}: {error}") from None


@dataclass(frozen=True, eq=False)
class Job:
    """A photograph, its depth map, its lens (as in the file, or focused at infinity), and how to store the result."""

    request: Request
    picture: Picture
    light: NDArray[np.floating]
    depth: NDArray[np.float64]
    encoding: str
    dtype: np.dtype[np.generic]
    pixel: float
    optics: Lens

    def lens(self, focus: float | None) -> Lens:
        """Return the lens, focused at a distance or as in its file."""
        if focus is None and self.request.lens is None:
            raise ValueError("without a lens file give --focus")
        try:
            return self.optics if focus is None else self.optics.focused(focus)
        except ValueError as error:
            raise ValueError(str(error).replace("focus_distance", "--focus")) from None

    def photograph(self, lens: Lens, progress: Callable[[float], object] | None = None) -> Photograph:
        """Return the blurred light; `progress` is called with the fraction of the work done."""
        settings = self.request.settings
        plan = FocusPlan(self.light, self.depth, lens, self.pixel, encoding="linear", keep=1, **vars(settings))
        if progress is not None:
            blur = plan.blur()
            # Occlusion blurs a white image too: once for each spectrum, twice where the whole PSF is kept.
            looks = len(set(blur.spectra)) * (2 if settings.energy == 1.0 else 1) if settings.occlusion else 0
            total, done = self.depth.size * (blur.channels + looks), 0

            def watch(points: int) -> None:
                nonlocal done
                done += points
                progress(min(done / total, 1.0))

            blur.watch = watch
        return plan()

    def write(self, output: Path, light: NDArray[Any]) -> float:
        """Write the result and return the clipped fraction of its values."""
        # A profile of other values than these would be wrong.
        profile = self.picture.profile if self.encoding == self.picture.encoding else None
        return write_photo(
            output, light, encoding=self.encoding, dtype=self.dtype, quality=self.request.quality, profile=profile
        )

    def facts(self, lens: Lens) -> Facts:
        """Return a description of the photograph and the lens."""
        return {
            "shape": list(self.light.shape),
            "encoding": {"photo": self.picture.encoding, "output": self.encoding},
            "read": read_as(self.picture, self.request.encoding),
            "bits": "float" if self.dtype.kind == "f" else str(8 * self.dtype.itemsize),
            "focal_length": lens.focal_length,
            "f_number": lens.f_number,
            "pixel": self.pixel,
        }


def read_as(picture: Picture, given: str | None) -> str:
    """Return how the values of a photograph were interpreted, as `given` or by default."""
    kind = "float" if picture.values.dtype.kind == "f" else f"{8 * picture.values.dtype.itemsize}-bit"
    names = {"srgb": "sRGB", "linear": "linear"}
    if given is not None:
        return f"{kind} values, {names[given]}"
    other = "linear" if picture.encoding == "srgb" else "srgb"
    return f"{kind} values, assumed {names[picture.encoding]}; if they are {names[other]}, give --encoding {other}"


def _bits(photo: np.dtype[np.generic], suffix: str) -> str:
    """Return the bits of the output by default: those of the photo, if the format holds them."""
    if suffix in (".jpg", ".jpeg"):
        return "8"
    if photo.kind != "f":
        return str(8 * photo.itemsize)
    return "float" if suffix in (".tif", ".tiff") else "16"
