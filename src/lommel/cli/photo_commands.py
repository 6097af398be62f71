"""The commands ``lommel blur`` (depth of field) and ``lommel restore`` (deblurring)."""

from __future__ import annotations

import math
import signal
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from types import FrameType
from typing import TYPE_CHECKING, cast

import click
import numpy as np
from click.core import ParameterSource
from numpy.typing import NDArray

from lommel.base.arrays import Values
from lommel.base.units import format_length
from lommel.cli.instruments import CAMERA, instrument_of, mask_of, noise_of, radial_instrument
from lommel.cli.options import (
    FILE,
    JSON,
    LENGTHS,
    OUTPUT,
    OUTPUT_PATH,
    PATH,
    Group,
    argument,
    command,
    documented,
    flag_of,
    option,
    with_options,
)
from lommel.cli.output import progress, written
from lommel.imaging import (
    FocusPlan,
    OnePass,
    Photograph,
    Picture,
    RichardsonLucy,
    TotalVariation,
    field_photograph,
    read_depth,
    read_photo,
)
from lommel.imaging import restore as restored
from lommel.imaging.datasets import FORMATS, LensRanges, render_dataset
from lommel.imaging.settings import BORDERS, MISSING, Settings
from lommel.io.depth_maps import RESAMPLE, DepthValues
from lommel.io.photos import check_pattern, find, is_animation, stored, write_frames, write_like
from lommel.io.registry import suffixes
from lommel.optics.lens import Lens
from lommel.recorded.noise import Noise
from lommel.report import Facts, Report, finite

if TYPE_CHECKING:
    from lommel.imaging.photograph import Pixels
    from lommel.io.depth_maps import DepthKeywords
    from lommel.lensfiles.instrument import Camera


class DepthMap(Group):
    """Meaning of the values of a depth map, as in :class:`lommel.io.depth_maps.DepthKeywords`."""

    # fmt: off
    scale: float | None = documented(DepthValues, "scale", "--depth-scale", type=float)
    inverse: tuple[float, float] | None = documented(DepthValues, "inverse", "--inverse-depth", length="m", nargs=2,
        metavar="NEAR FAR")
    disparity: tuple[float, float] | None = documented(DepthValues, "disparity", type=float, nargs=2,
        metavar="FB OFFSET")
    zero_is_unknown: bool = documented(DepthValues, "zero_is_unknown", "--zero-unknown", is_flag=True)
    unknown: tuple[float, ...] = option(type=float, multiple=True,
        help="Treat this stored value of the depth map, such as -1 or 255, as unknown.")
    resample: str | None = documented(DepthValues, "resample", type=click.Choice(RESAMPLE))
    # fmt: on


def depth_facts(distance: NDArray[np.float64]) -> tuple[Facts, Callable[[str], str]]:
    """Return the range and the unknown fraction of a depth map, and a function that formats them with a focus."""
    valid = distance[~np.isnan(distance)]
    low, high = (float(end(valid)) if valid.size else math.nan for end in (np.min, np.max))
    unknown_fraction = 1.0 - valid.size / distance.size
    facts = {"depth": [finite(low), finite(high)] if valid.size else [None, None], "depth_unknown": unknown_fraction}
    return facts, lambda focus: depth_line(low, high, unknown_fraction, focus)


def depth_line(low: float, high: float, unknown: float, focus: str) -> str:
    """Return a line with a range of depth (NaN if all is unknown), a focus, and the unknown fraction."""
    range_text = "not known" if math.isnan(low) else " to ".join(map(format_length, dict.fromkeys((low, high))))
    return f"depth {range_text}, {focus}" + (f", {100.0 * unknown:.2g} % unknown" if unknown else "")


class DataSet(Group, heading="Data set"):
    """Options for a data set instead of a single photograph."""

    # fmt: off
    batch: bool = option(is_flag=True,
        help="Blur all photos of the folder PHOTO by the depth maps of the same names in the folder DEPTH into the "
        "folder --output, with ground truth. LENS may have pairs in place of numbers: ranges from which the lens of "
        "each picture is drawn. After an interruption, the same command resumes. Files that cannot be used are "
        "reported and left out, with exit code 3.")
    seed: int = option(type=int, default=0, help="Seed of the lenses and of the noise.")
    copies: int = documented(render_dataset, "copies", type=int)
    workers: int = documented(render_dataset, "workers", type=int, help="Number of processes.")
    form: str = documented(render_dataset, "form", type=click.Choice(FORMATS),
        help="Format of the images: png has 16 bits and the encoding of the photo, the others are linear.")
    shard: int | None = documented(render_dataset, "shard", type=int,
        help="Number of pictures in each tar file, as WebDataset reads them; by default a file for each.")
    psfs: int = documented(render_dataset, "psfs", type=int,
        help="Number of PSFs stored with each picture, to which its pixels refer by an index; 0 for none.")
    white: float | None = option(type=float, default=None, help="Electrons at white, such as 5000, for photon noise.")
    read: float | None = option(type=float, default=None, help="Read noise, rms electrons; needs --white.")
    # fmt: on

    def arguments(self) -> Facts:
        """Return the arguments of :func:`lommel.imaging.render_dataset`."""
        arguments = vars(self).copy()
        white, read = arguments.pop("white"), arguments.pop("read")
        if white is None and read is not None:
            raise ValueError("--read needs --white, the electrons at white")
        del arguments["batch"]
        return arguments | {"noise": None if white is None else Noise(white=white, read=read or 0.0)}


_SINGLE_PHOTO_OPTIONS = ("bits", "pixel_from_exif", "no_exif", "last", "frames", "fps", "camera")


def render(
    folder: Path,
    files: tuple[Path, Path, Path | None],
    focus: float | None,
    pull: Facts,
    data: DataSet,
    options: PhotoOptions,
) -> Report:
    """Render a data set into a folder, from folders of photos and of depth maps and from a file of lenses."""
    photos, depths, lens = files
    stated = vars(options.output_file) | vars(options.photo_camera) | pull
    for name in _SINGLE_PHOTO_OPTIONS:
        if stated[name]:
            raise ValueError(f"{flag_of(name)} is an option for a single photo; it cannot be combined with --batch")
    lenses = _lenses(lens, stated | {"focus_distance": focus})
    arguments = data.arguments() | {"encoding": options.encoding}
    values: Facts = {**options.depth_values}
    arguments |= {"depth_scale": values.pop("scale"), "inverse_depth": values.pop("inverse"), **values}
    Settings(**options.settings)
    arguments |= options.settings
    start, rendered = time.perf_counter(), 0
    finished = total = 0
    failed: list[Facts] = []
    rendered_facts: list[Facts] = []
    try:
        with progress("reading") as status:
            for picture in render_dataset(photos, depths, folder, lenses, on_error="skip", **arguments):
                finished, total = picture.done, picture.total
                if picture.failure is None:
                    rendered += 1
                    rendered_facts.append(picture.facts)
                    status(f"picture {finished} of {total}", finished / total)
                    continue
                reason = with_options(picture.failure)
                if reason not in [failure["reason"] for failure in failed]:  # not yet reported for another copy
                    click.echo(f"Left out: {reason}", err=True)
                failed.append({"number": picture.number, **picture.facts, "reason": reason})
    except KeyboardInterrupt:
        finished_text = f"{finished} of {total} pictures are finished" if rendered else "no picture was finished"
        click.echo(f"Interrupted: {finished_text}; the same command resumes.", err=True)
        raise
    seconds = time.perf_counter() - start
    if failed and not finished:
        raise ValueError(f"no picture could be rendered: {failed[0]['reason']}")
    facts = {"output": str(folder), "rendered": rendered, "seconds": seconds, "failed": failed}
    text = (
        f"{rendered} pictures rendered in {seconds:.3g} s" if rendered or failed else "all pictures existed already"
    )
    lines = [text, f"folder {folder}"]
    if rendered_facts:
        unknown_fractions = [picture_facts["depth_unknown"] for picture_facts in rendered_facts]
        ends = [float(end) for picture_facts in rendered_facts for end in picture_facts["depth_range"]] or [math.nan]
        focuses = [float(picture_facts["focus_distance"]) for picture_facts in rendered_facts]
        focus_range = " to ".join(map(format_length, dict.fromkeys((min(focuses), max(focuses)))))
        unknown_fraction = sum(unknown_fractions) / len(unknown_fractions)
        facts |= {"depth": [finite(min(ends)), finite(max(ends))], "depth_unknown": unknown_fraction}
        lines.insert(0, depth_line(min(ends), max(ends), unknown_fraction, f"focus {focus_range}"))
    if failed:
        lines.append(f"{len(failed)} of {total} pictures left out; correct their files and repeat the command")
    return Report(facts, lines, succeeded=not failed)


def _lenses(file: Path | None, stated: Facts) -> LensRanges:
    """Return the lenses of a file, whose values options override; without a file, the lenses of the options."""
    from lommel.lensfiles.lens_files import load_lens_ranges

    values = {name: stated[name] for name in ("focal_length", "f_number", "focus_distance", "pixel")}
    overrides = {name: value for name, value in values.items() if value is not None}
    if file is not None:
        return LensRanges(**{**vars(load_lens_ranges(file)), **overrides})
    if missing_flags := [flag_of(name) for name in values if name not in overrides]:
        raise ValueError(f"give a lens file or {', '.join(missing_flags)}")
    return LensRanges(**overrides)


_TOLERANCE = 0.02  # largest relative difference from the EXIF, which has rounded nominal values
_TYPES: dict[str, np.dtype[np.generic]] = {
    "8": np.dtype(np.uint8),
    "16": np.dtype(np.uint16),
    "float": np.dtype(np.float32),
}

_FRAMES, _FPS = 24, 12.0

FOCUS = option("--focus", length="m", help="Focus distance, such as 1.5m or inf; overrides the lens file.")


class PhotoNoise(Group, heading="Noise"):
    """Options for the noise of photographs."""

    # fmt: off
    white: float | None = option(type=float,
        help="Number of electrons at white, such as 5000; by default the full well of the camera. White is the "
        "largest integer, or 1.0 in floats.")
    read: float | None = documented(Noise, "read", type=float, default=None,
        help="Read noise, rms electrons; 0 for none; by default from the camera.")
    offset: float = option(type=float, default=0.0, help="Black level, as a fraction of white.")
    # fmt: on


class PhotoCamera(Group, heading="Camera"):
    """Lens and camera of a photograph, if no file states them."""

    # fmt: off
    f_number: float | None = option(type=float, help="F-number; by default from the lens file or the EXIF.")
    focal_length: float | None = option(length="mm",
        help="Focal length, where there is no lens file; by default from the EXIF.")
    camera: Camera | None = CAMERA
    pixel: float | None = option(length="um", help="Pixel pitch; overrides the lens file and the camera.")
    pixel_from_exif: bool = option(is_flag=True,
        help="Pixel pitch from the 35 mm equivalent focal length in the EXIF, for uncropped photos; accurate to a "
        "few %.")
    no_exif: bool = option(is_flag=True, help="Ignore the lens data of the EXIF.")
    wavelengths: tuple[float, ...] | None = option(type=LENGTHS,
        help="Wavelength of each channel; by default 600nm,540nm,460nm, and for a grey photo from the lens file, "
        "or 550nm.")
    # fmt: on


class PhotoDepth(DepthMap, heading="Photo and depth map"):
    """Meaning of the values of a depth map, and treatment of missing values."""

    missing: str = documented(Settings, "missing", type=click.Choice(MISSING))


class Blurring(Group, heading="Blur"):
    """Settings of the blur."""

    border: str = documented(Settings, "border", type=click.Choice(BORDERS))
    occlusion: bool = documented(Settings, "occlusion", "--occlusion/--no-occlusion", sentences=2)
    energy: float = documented(Settings, "energy", type=float, sentences=3)
    tol: float = documented(Settings, "tol", type=float)
    largest: int | None = documented(Settings, "largest", type=int)


class OutputFile(Group, heading="Output file"):
    """Format of the result."""

    # fmt: off
    bits: str | None = option(type=click.Choice(list(_TYPES)),
        help="Bits of the output; by default as in the photo.")
    quality: int = option(type=int, default=95, help="Quality of JPEG and WebP, 1 to 100.")
    # fmt: on


class PhotoOptions(Group, heading="Photo and depth map"):
    """Options common to the commands on one photograph with a depth map."""

    # fmt: off
    photo_camera: PhotoCamera = PhotoCamera()
    encoding: str | None = option(type=click.Choice(["srgb", "linear"]),
        help="Encoding of the photo's values; by default integers are sRGB and floats are linear.")
    depth_map: PhotoDepth = PhotoDepth()
    blurring: Blurring = Blurring()
    output_file: OutputFile = OutputFile()
    # fmt: on

    @property
    def depth_values(self) -> DepthKeywords:
        """Keyword arguments for the values of the depth map."""
        return cast("DepthKeywords", {k: v for k, v in vars(self.depth_map).items() if k != "missing"})

    @property
    def settings(self) -> Facts:
        """Arguments of :class:`lommel.imaging.settings.Settings`."""
        return {"wavelengths": self.photo_camera.wavelengths, "missing": self.depth_map.missing} | vars(self.blurring)


class FocusPull(Group, heading="Focus pull"):
    """The end and the frames of a focus pull."""

    # fmt: off
    last: float | None = option("--focus-to", length="m",
        help="Focus distance of the last frame: a focus pull from --focus in equal steps of dioptres.")
    frames: int | None = option(type=click.IntRange(2, 9999),
        help=f"Number of frames; by default {_FRAMES}.")
    fps: float | None = option(type=float, help=f"Frames per second of an animation; by default {_FPS:g}.")
    # fmt: on


class FieldOfView(Group, heading="Field of view"):
    """Rendering of a photograph over the field of a lens."""

    # fmt: off
    over: bool = option("--over-field", is_flag=True,
        help="Render PHOTO, as an ideal lens would record it, through the lens file given in place of DEPTH, which "
        "needs a section [field]: blur over the field, distortion, lateral colour and shading. The axis is in the "
        "middle of the photo. --tol is then 0.001 by default.")
    # fmt: on


@command(JSON)
def blur(
    photo: Path = argument("photo", type=PATH),
    depth: Path = argument("depth", type=PATH),
    lens: Path | None = argument("lens", type=FILE, required=False),
    output: Path = option("-o", "--output", required=True, type=OUTPUT_PATH, metavar="FILE",
        help=f"Blurred photo: {suffixes('photo')}. With --focus-to: numbered photos, such as out-%03d.png, or one "
        f"animation or stack: {suffixes('frames')}."),
    focus_distance: float | None = FOCUS,
    supersample: int = option(type=click.IntRange(1, 16), default=1,
        help="Points of PHOTO and DEPTH along each side of a pixel of the output, which averages them."),
    pull: FocusPull = FocusPull(),
    field: FieldOfView = FieldOfView(),
    data: DataSet = DataSet(),
    options: PhotoOptions = PhotoOptions(),
) -> Report:  # fmt: skip
    """Blur a photo by its depth map or over a lens field.

    PHOTO is a PNG, JPEG, TIFF, EXR, WebP, BMP or HEIC, grey or RGB. DEPTH is a depth map of the same size, the
    distance of each point from the lens along the optical axis, in metres: a grey TIFF, NPY, PFM, PNG or EXR. Without
    a lens file LENS, focal length and f-number come from the options or from the photo's EXIF; an option that
    contradicts the EXIF is rejected.

    The aberrations of the lens must be radially symmetric (defocus, spherical), and its aperture round: leave out
    coma, astigmatism and other terms with a direction.

    Integer values are clipped at white, as on a sensor, and the clipped fraction is printed.

    Examples
    --------
      lommel blur photo.jpg depth.tif --focus 1.2m --pixel 4um -o out.jpg
      lommel blur photo.png depth.png phone.toml --depth-scale 0.001 --zero-unknown --missing nearest -o out.tif
      lommel blur photo.png depth.tif phone.toml --focus 0.8m --focus-to 4m --frames 48 -o pull-%03d.png
      lommel blur photo.png depth.tif phone.toml --focus 0.8m --focus-to inf --fps 24 -o pull.webp
      lommel blur photo.png camera-field.toml --over-field --pixel 6um -o out.png
      lommel blur --batch photos/ depths/ phone.toml --seed 1 --workers 2 -o set/
    """
    for flag, is_set in (
        ("--over-field", field.over),
        ("--batch", data.batch),
        ("--pixel-from-exif", options.photo_camera.pixel_from_exif),
    ):
        if supersample > 1 and is_set:
            raise ValueError(f"--supersample cannot be combined with {flag}, got {supersample}")
    if field.over:
        return _through_field(photo, depth, output, options)
    if data.batch:
        return render(output, (photo, depth, lens), focus_distance, vars(pull), data, options)
    for param in DataSet.options():
        if param.name != "batch" and getattr(data, param.name or "") != param.default:
            raise ValueError(f"--{param.name} is an option for data sets, and needs --batch")
    open_job = partial(Job, photo, depth, lens, output, options, supersample=supersample)
    if pull.last is not None:
        return _pull_focus(open_job, output, (focus_distance, pull.last), pull)
    if pull.frames is not None or pull.fps is not None:
        name = "fps" if pull.frames is None else "frames"
        raise ValueError(f"--{name} needs --focus-to, the end of a focus pull")
    find(output, "--output")
    with terminated_as_interrupted(), progress("reading") as status:
        job = open_job()
        focused_lens = job.focused(focus_distance)
        status("computing PSFs")
        start = time.perf_counter()
        photograph = job.photograph(focused_lens, lambda share: status("blurring", share))
        seconds = time.perf_counter() - start
        clipped = job.write(photograph.values)
    facts, lines = _largest_errors([photograph], [clipped])
    facts = {"focus_distance": finite(focused_lens.focus_distance), "seconds": seconds} | facts
    return job.report(focused_lens, facts, lines, [output])


_FIELD_OPTIONS = ("photo", "depth", "output", "over", "as_json", "camera", "pixel", "encoding", "bits", "quality")
_BLUR_OPTIONS = ("wavelengths", "border", "energy", "tol", "largest")


def _through_field(photo: Path, path: Path, output: Path, options: PhotoOptions) -> Report:
    """Render a photograph through the lens of a file: blur over its field, distortion, lateral colour, shading."""
    context = click.get_current_context()
    stated = {
        param.name or "": "DEPTH" if param.name == "lens" else param.opts[0]
        for param in context.command.params
        if context.get_parameter_source(param.name or "") is ParameterSource.COMMANDLINE
    }
    for name, flag in stated.items():
        if name not in (*_FIELD_OPTIONS, *_BLUR_OPTIONS):
            raise ValueError(f"{flag} cannot be combined with --over-field, which takes PHOTO and the lens file")
    find(output, "--output")
    photo_camera, stored_as = options.photo_camera, options.output_file
    with terminated_as_interrupted(), progress("reading") as status:
        picture = read_photo(photo, options.encoding)
        light = picture.light()
        instrument = instrument_of(path)
        field = instrument.field()
        if field.vignetting is not None:
            raise ValueError(
                f"{path} must have no [field.vignetting]: state the whole relative illumination in [field.shading]"
            )
        camera = photo_camera.camera or instrument.camera
        pitch = photo_camera.pixel or (instrument.side if camera is None else camera.side)
        dtype, encoding = output_type(picture, output, stored_as.bits)
        status("computing PSFs and blurring")
        start = time.perf_counter()
        stated_settings = {name: value for name, value in options.settings.items() if name in stated}
        photograph = field_photograph(light, field, pitch, encoding="linear", **stated_settings)
        seconds = time.perf_counter() - start
        clipped = write_like(
            picture, output, photograph.values, encoding=encoding, dtype=dtype, quality=stored_as.quality
        )
    height, width = light.shape[:2]
    x, y = (0.5 * (side - 1) * pitch for side in (width, height))
    shift = math.hypot(*(float(part) for part in field.displacement(x, y))) / pitch
    facts, lines = _largest_errors([photograph], [clipped])
    read = read_as(picture, options.encoding)
    facts |= {
        "shape": list(light.shape),
        "encoding": {"photo": picture.encoding, "output": encoding},
        "read": read,
        "pixel": pitch,
        "moved": shift,
        "seconds": seconds,
    }
    lines = [
        read,
        f"{width} x {height} pixels of {format_length(pitch)}; the lower right corner is moved by {shift:.3g} pixels",
        *lines,
    ]
    if clipped:
        lines.append(f"clipped at white: {100.0 * clipped:.2g} % of the values")
    return Report(facts, lines) + written([output])


def _pull_focus(
    open_job: Callable[..., Job], output: Path, ends: tuple[float | None, float], pull: FocusPull
) -> Report:
    """Blur a photograph once for each focus distance of a focus pull; a failure leaves no file."""
    first, last = ends
    frames, fps = pull.frames or _FRAMES, _FPS if pull.fps is None else pull.fps
    check_pattern(output, "--output")
    for name, distance in (("--focus", first), ("--focus-to", last)):
        if distance is not None and not distance > 0.0:
            raise ValueError(f"{name} must be > 0 metres, got {distance:g}")
    photographs: list[Photograph] = []
    clipped_fractions: list[float] = []
    with terminated_as_interrupted(), progress("reading", total=frames) as status:
        job = open_job(one_file="%" not in output.name)
        first_dioptres = 1.0 / (job.focused(None).focus_distance if first is None else first)
        # Equal steps of 1 / distance are equal movements of a lens.
        steps = [first_dioptres + (1.0 / last - first_dioptres) * k / (frames - 1) for k in range(frames)]
        lenses = [job.focused(1.0 / step if step else math.inf) for step in steps]
        start = time.perf_counter()

        def frame_values() -> Iterator[NDArray[np.generic]]:
            for number, lens in enumerate(lenses, 1):
                status(f"frame {number} of {frames}, focus {format_length(lens.focus_distance)}")
                photograph = job.photograph(lens)
                values, clipped = stored(photograph.values, job.stored_as, job.dtype)
                photographs.append(replace(photograph, values=np.empty(0)))  # a view would keep all values in memory
                clipped_fractions.append(clipped)
                yield values

        files = write_frames(
            output, frame_values(), fps=fps, quality=job.options.output_file.quality, exif=job.picture.exif
        )
        seconds = time.perf_counter() - start
    distances = [finite(lens.focus_distance) for lens in lenses]
    facts, lines = _largest_errors(photographs, clipped_fractions)
    facts = {"frames": frames, "focus_distances": distances, "seconds": seconds} | facts
    return job.report(lenses[0], facts, lines, files, until=lenses[-1])


def _largest_errors(photographs: list[Photograph], clipped: list[float]) -> tuple[Facts, list[str]]:
    """Return (1) the largest interpolation error, window and clipped fraction of photographs, (2) text on them."""
    side, light_beyond, error = (max(getattr(p, name) for p in photographs) for name in ("window", "lost", "error"))
    if light_beyond:
        text = (
            f"PSFs up to {side} pixels wide, with all but {100.0 * light_beyond:.2g} % of their light; interpolation "
            f"error {error:.2g} of their peak"
        )
    else:
        text = (
            f"PSFs up to {side} pixels wide and all their light beyond; interpolation error {error:.2g} of the "
            "brightest point"
        )
    facts = {"largest_window": side, "light_beyond_windows": light_beyond, "interpolation_error": error}
    return facts | {"clipped": max(clipped)}, [text]


_METHODS = ("richardson-lucy", "total-variation", "one-pass")


class RestoredNoise(PhotoNoise, heading="Noise"):
    """Noise of a photograph, and pixels to ignore."""

    # fmt: off
    saturation: float | None = option(type=float,
        help="Level at which pixels saturate, as a fraction of white in linear light (after decoding sRGB), such as "
        "0.95.")
    masked: Path | None = option("--mask", type=FILE,
        help="Image whose nonzero pixels mark the pixels of the photo to ignore.")
    # fmt: on


class Restoring(Group, heading="Restoration"):
    """Method of the restoration and its settings."""

    # fmt: off
    method: str = option(type=click.Choice(_METHODS), default=_METHODS[0],
        help="Richardson-Lucy maximises the likelihood; total variation also smooths and preserves edges: usually "
        "less noise at the same sharpness, but ten to forty times slower; one-pass applies Wiener filters, and is as "
        "good where depth has few edges.")
    steps: int | None = option(type=int,
        help=f"Maximum number of steps; by default {RichardsonLucy.steps}, with total-variation "
        f"{TotalVariation.steps} for each strength tried.")
    target: float = documented(RichardsonLucy, "target", type=float,
        help="Discrepancy at which to stop. The default is below 1 because the restored photo also fits part of the "
        "noise.")
    strength: float | None = option(type=float,
        help="Weight of the total variation; by default such that the discrepancy is --target.")
    # fmt: on

    def restoration_method(self) -> RichardsonLucy | TotalVariation | OnePass:
        """Return the restoration method."""
        if self.method == _METHODS[2]:
            if self.steps is not None or self.strength is not None:
                raise ValueError(f"--steps and --strength need --method {_METHODS[0]} or {_METHODS[1]}")
            return OnePass()
        if self.method == _METHODS[1]:
            steps = TotalVariation.steps if self.steps is None else self.steps
            return TotalVariation(strength=self.strength, steps=steps, target=self.target)
        if self.strength is not None:
            raise ValueError(f"--strength needs --method {_METHODS[1]}")
        return RichardsonLucy(steps=RichardsonLucy.steps if self.steps is None else self.steps, target=self.target)


@command(JSON)
def restore(
    photo: Path = argument("photo", type=FILE),
    depth: Path = argument("depth", type=FILE),
    lens: Path | None = argument("lens", type=FILE, required=False),
    output: Path = option("-o", "--output", required=True, type=OUTPUT, help=f"Restored photo: {suffixes('photo')}."),
    focus_distance: float | None = FOCUS,
    noise_options: RestoredNoise = RestoredNoise(),
    restoring: Restoring = Restoring(),
    options: PhotoOptions = PhotoOptions(),
) -> Report:  # fmt: skip
    """Deblur a photo with a known depth map and lens.

    PHOTO is a PNG, JPEG, TIFF, EXR, WebP, BMP or HEIC, grey or RGB, neither sharpened nor denoised. DEPTH is a depth
    map of the same size, the distance of each point from the lens along the optical axis, in metres: a grey TIFF,
    NPY, PFM, PNG or EXR. Without a lens file LENS, focal length and f-number come from the options or from the
    photo's EXIF.

    The printed discrepancy is the Poisson deviance per pixel between the photo and the restored photo, blurred again:
    about 1 where they differ only by noise. A larger value means that depth, lens or noise do not fit the photo: the
    exit code is then 3.

    Examples
    --------
      lommel restore photo.tif depth.tif phone.toml --white 5000 --read 3 -o sharp.tif
      lommel restore photo.tif depth.tif phone.toml --white 5000 --read 3 --method total-variation -o sharp.png
    """
    find(output, "--output")
    method = restoring.restoration_method()
    with terminated_as_interrupted(), progress("reading") as status:
        job = Job(photo, depth, lens, output, options)
        focused_lens = job.focused(focus_distance)
        values = job.picture.values
        if noise_options.masked is not None:
            (values,) = apply_mask([values], noise_options.masked)
        status("computing PSFs")
        start = time.perf_counter()

        def step_done(step: int, discrepancy: float, remaining: float) -> None:
            elapsed = time.perf_counter() - start
            status(f"step {step}, discrepancy {discrepancy:.3g}", elapsed / max(elapsed + remaining, 1e-9))

        result = restored(
            values,
            job.distance,
            focused_lens,
            job.pitch,
            encoding=job.picture.encoding,
            noise=noise_of(vars(noise_options), job.camera, photographs=True),
            method=method,
            saturation=noise_options.saturation,
            progress=step_done,
            **options.settings,
        )
        seconds = time.perf_counter() - start
        clipped = job.write(np.asarray(result.light))
    facts = {"focus_distance": finite(focused_lens.focus_distance), "seconds": seconds, "method": restoring.method}
    facts |= result.to_dict() | {"clipped": clipped}
    lines = [f"discrepancy {result.before:.3g} of the photo, {result.discrepancy:.3g} of the result"]
    if result.strength is not None:
        lines.append(f"strength of the total variation {result.strength:.3g}")
    reason = result.findings.text or {"noise": "the rest is noise"}.get(result.stopped, result.stopped)
    lines.append(f"stopped after {result.steps} steps: {reason}")
    if result.unknown:
        lines.append(f"saturated or unknown: {100.0 * result.unknown:.2g} % of the values")
    return job.report(focused_lens, facts, lines, [output]) + Report({}, [], result.converged)


def apply_mask(photos: Sequence[Pixels], masked: Path) -> list[Pixels]:
    """Return photos whose pixels are masked by an image file."""
    mask = mask_of(masked, np.broadcast_to(False, (len(photos), *photos[0].shape[:2])))
    masks = [mask] * len(photos) if mask.ndim == 2 else list(mask)
    return [
        np.ma.masked_array(photo, np.broadcast_to(m.reshape(*m.shape, *[1] * (photo.ndim - 2)), photo.shape))
        for photo, m in zip(photos, masks, strict=True)
    ]


@contextmanager
def terminated_as_interrupted() -> Iterator[None]:
    """Clean up after a SIGTERM as after Ctrl-C."""

    def interrupt(_signal: int, _frame: FrameType | None) -> None:
        raise KeyboardInterrupt

    old_handler = signal.signal(signal.SIGTERM, interrupt)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, old_handler)


@dataclass
class Job:
    """A photograph, its depth map and its lens from the options of a command, and the format of the result.

    The lens is focused as in its file, or at infinity without a file. With `one_file` all frames of the result are
    written to one file.
    """

    photo: Path
    depth: Path
    lens: Path | None
    output: Path
    options: PhotoOptions
    one_file: bool = False
    supersample: int = 1

    def __post_init__(self) -> None:
        options, photo_camera = self.options, self.options.photo_camera
        self.settings = Settings(**options.settings)
        self.picture = read_photo(self.photo, options.encoding)
        self.distance = read_depth(self.depth, shape=self.picture.values.shape, **options.depth_values)
        self.pixel, self.camera = photo_camera.pixel, photo_camera.camera
        if photo_camera.pixel_from_exif:
            if self.pixel is not None:
                raise ValueError("give one of --pixel and --pixel-from-exif")
            if photo_camera.no_exif:
                raise ValueError("--pixel-from-exif contradicts --no-exif")
            self.pixel = self.picture.exif.pixel(self.picture.values.shape)
        if self.pixel is None and self.camera is not None:
            self.pixel = self.camera.side
        self.optics = self._lens_of_options() if self.lens is None else self._lens_of_file(self.lens)
        if self.pixel is None:
            raise ValueError("without a lens file give --camera, --pixel or --pixel-from-exif")
        self.pitch = self.pixel
        self.dtype, self.stored_as = output_type(self.picture, self.output, options.output_file.bits)
        if not self.one_file:
            find(self.output, "--output", holding=f"of {self.dtype}")
        elif is_animation(self.output) and self.dtype.itemsize > 1:
            raise ValueError(f"{self.output.suffix} holds 8 bits; give --bits 8, a .tif, or a number such as %03d")

    def _lens_of_options(self) -> Lens:
        """Return a lens with the data of the options or the EXIF, focused at infinity."""
        exif, photo_camera = self.picture.exif, self.options.photo_camera
        return Lens(
            focal_length=self._resolve("--focal-length", photo_camera.focal_length, exif.focal_length, format_length),
            f_number=self._resolve("--f-number", photo_camera.f_number, exif.f_number, lambda n: f"f/{n:g}"),
            wavelength=540e-9 if self.picture.values.ndim == 3 else 550e-9,
        )

    def _resolve(self, option: str, value: float | None, exif: float | None, show: Callable[[float], str]) -> float:
        """Return the value of an option, or else of the EXIF; ValueError if the two contradict each other."""
        is_ignored = self.options.photo_camera.no_exif
        exif_value = None if is_ignored else exif
        if value is None:
            if exif_value is None:
                reason = "the EXIF is ignored" if is_ignored else f"{self.photo} has none in its EXIF"
                raise ValueError(f"give a lens file or {option}: {reason}")
            return exif_value
        if exif_value is not None and not math.isclose(value, exif_value, rel_tol=_TOLERANCE):
            raise ValueError(
                f"{option} {show(value)} contradicts the EXIF of {self.photo}, {show(exif_value)}; "
                "give --no-exif to ignore the EXIF"
            )
        return value

    def _lens_of_file(self, path: Path) -> Lens:
        """Return the lens of a file, stopped down to --f-number, and keep the pixel pitch of the file."""
        photo_camera = self.options.photo_camera
        if photo_camera.focal_length is not None or photo_camera.pixel_from_exif:
            flag = "--focal-length" if photo_camera.focal_length is not None else "--pixel-from-exif"
            raise ValueError(f"{flag} cannot be combined with a lens file, which states this value")
        instrument = radial_instrument(path)
        side = instrument.side
        self.pixel = side if self.pixel is None else self.pixel
        self.camera = self.camera or instrument.camera
        try:
            stop = photo_camera.f_number
            return instrument.lens if stop is None else instrument.lens.stopped(stop)
        except ValueError as error:
            raise ValueError(f"--f-number of {path}: {error}") from None

    def focused(self, focus: float | None) -> Lens:
        """Return the lens focused at a distance, or for None at the focus distance in its file."""
        if focus is None and self.lens is None:
            raise ValueError("without a lens file give --focus")
        return self.optics if focus is None else self.optics.focused(focus)

    def photograph(self, lens: Lens, progress: Callable[[float], object] | None = None) -> Photograph:
        """Return the blurred light; `progress` is called with the fraction of the work done."""
        settings = self.settings
        arguments: Facts = {"keep": 1, "supersample": self.supersample} | vars(settings)
        plan = FocusPlan(self.picture.light(), self.distance, lens, self.pitch, encoding="linear", **arguments)
        if progress is not None:
            blur = plan.blur()
            # If the whole PSF is kept, occlusion also blurs white images: twice for each spectrum.
            occlusion_passes = 2 * len(set(blur.spectra)) if settings.occlusion and settings.energy == 1.0 else 0
            total, done_points = self.distance.size * (blur.channels + occlusion_passes), 0

            def watch(points: int) -> None:
                nonlocal done_points
                done_points += points
                progress(min(done_points / total, 1.0))

            blur.watch = watch
        return plan()

    def write(self, light: Values) -> float:
        """Write the result and return the clipped fraction of its values."""
        quality = self.options.output_file.quality
        return write_like(
            self.picture, self.output, light, encoding=self.stored_as, dtype=self.dtype, quality=quality
        )

    def report(
        self, lens: Lens, facts: Facts, lines: list[str], files: Iterable[Path], until: Lens | None = None
    ) -> Report:
        """Return the report of the job: facts and lines of the command, after those common to all commands."""
        read, (height, width, *_) = read_as(self.picture, self.options.encoding), self.picture.values.shape
        height, width = height // self.supersample, width // self.supersample
        common = {
            "shape": [height, width, *self.picture.values.shape[2:]],
            "encoding": {"photo": self.picture.encoding, "output": self.stored_as},
            "read": read,
            "bits": "float" if self.dtype.kind == "f" else str(8 * self.dtype.itemsize),
            "focal_length": lens.focal_length,
            "f_number": lens.f_number,
            "pixel": self.pitch,
        }
        facts_of_depth, depth_text = depth_facts(self.distance)
        common |= facts_of_depth
        end = f" to {format_length(until.focus_distance)}" if until else ""
        focus = f"focus {format_length(lens.focus_distance)}{end}"
        pixels = f"{width} x {height} pixels of {format_length(self.pitch)}"
        lines = [
            read,
            f"{pixels}; f = {format_length(lens.focal_length)}, f/{lens.f_number:.3g}",
            depth_text(focus),
            *lines,
        ]
        if facts["clipped"]:
            lines.append(f"clipped at white: {100.0 * facts['clipped']:.2g} % of the values")
        return Report(common | facts, lines) + written(files)


def read_as(picture: Picture, encoding: str | None) -> str:
    """Return a description of the encoding of a photograph, as `encoding` or assumed."""
    kind = "float" if picture.values.dtype.kind == "f" else f"{8 * picture.values.dtype.itemsize}-bit"
    names = {"srgb": "sRGB", "linear": "linear"}
    if encoding is not None:
        return f"{kind} values, {names[encoding]}"
    other = "linear" if picture.encoding == "srgb" else "srgb"
    return f"{kind} values, assumed {names[picture.encoding]}; if they are {names[other]}, give --encoding {other}"


def output_type(picture: Picture, output: Path, bits: str | None) -> tuple[np.dtype[np.generic], str]:
    """Return the type and the encoding of the output, by default as in the photo."""
    kind = picture.values.dtype
    dtype = _TYPES[bits or _bits(kind, output.suffix.lower())]
    # Values of the same kind keep their encoding; others get the encoding that readers assume for them.
    same_kind = (dtype.kind == "f") == (kind.kind == "f")
    return dtype, picture.encoding if same_kind else "linear" if dtype.kind == "f" else "srgb"


def _bits(photo: np.dtype[np.generic], suffix: str) -> str:
    """Return the default bits of the output: the bits of the photo, if the format can store them."""
    if suffix in (".jpg", ".jpeg"):
        return "8"
    if photo.kind != "f":
        return str(8 * photo.itemsize)
    return "float" if suffix in (".tif", ".tiff") else "16"
