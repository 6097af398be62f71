"""The commands ``lommel blur`` (depth of field) and ``lommel restore`` (deblurring)."""

from __future__ import annotations

import math
import signal
import sys
import time
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from types import FrameType
from typing import TYPE_CHECKING, Annotated, ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Values
from lommel.base.options import Shown
from lommel.cli.command import OUTPUT, command, filled
from lommel.cli.instruments import MaskedPhotoNoise, PhotoCamera, instrument_of, mask_of, noise_of, radial_instrument
from lommel.cli.messages import given_flags, with_options
from lommel.cli.output import progress, written
from lommel.imaging import (
    BlurOptions,
    DatasetOptions,
    DepthMapOptions,
    LensRanges,
    OnePass,
    Photograph,
    Rendered,
    RestoreOptions,
    RichardsonLucy,
    TotalVariation,
    depth_of_field,
    field_photograph,
    read_depth,
    read_photo,
    render_dataset,
    write_photo,
)
from lommel.imaging import restore as restored
from lommel.imaging.field_blur import FieldPhotographOptions
from lommel.io.depth_maps import fill_missing
from lommel.io.photos import find
from lommel.io.registry import suffixes
from lommel.optics.lens import Lens
from lommel.recorded.noise import Noise
from lommel.report import Facts, Report, Wrapped, finite
from lommel.report.table import told

if TYPE_CHECKING:
    from lommel.imaging.photograph import Pixels

_TOLERANCE = 0.02  # largest relative difference from the EXIF, which has rounded nominal values
Encoding = Literal["srgb", "linear"]


@dataclass(frozen=True, kw_only=True)
class DepthMap(DepthMapOptions):
    """Meaning of the values of a depth map."""

    heading: ClassVar[str] = "Depth map"


@dataclass(frozen=True, kw_only=True)
class DataSet(DatasetOptions):
    """Options for a data set instead of a single photograph.

    Parameters
    ----------
    seed
        Seed of the lenses and of the noise.
    white
        Electrons at white, such as 5000, for photon noise.
    read
        Read noise, rms electrons; needs --white.
    """

    heading: ClassVar[str] = "Data set"
    seed: int = 0
    white: float | None = None
    read: float | None = None

    def options(self, depth: DepthMapOptions) -> DatasetOptions:
        """Return the options of :func:`lommel.imaging.render_dataset`."""
        if self.white is None and self.read is not None:
            raise ValueError("--read needs --white, the electrons at white")
        noise = None if self.white is None else Noise(white=self.white, read=self.read or 0.0)
        return DatasetOptions(
            copies=self.copies, workers=self.workers, noise=noise, depth_options=depth, on_error="skip"
        )


def depth_facts(distance: NDArray[np.float64]) -> Facts:
    """Return the range and the unknown fraction of a depth map."""
    valid = distance[~np.isnan(distance)]
    ends = [finite(float(valid.min())), finite(float(valid.max()))] if valid.size else [None, None]
    return {"depth": ends, "depth_unknown": 1.0 - valid.size / distance.size}


@command
@filled(photo=suffixes("photo"))
def blur(
    photo: Path,
    depth: Path,
    lens: Path | None = None,
    /,
    *,
    output: Annotated[Path, OUTPUT],
    encoding: Encoding | None = None,
    over_field: bool = False,
    batch: bool = False,
    camera_options: PhotoCamera = PhotoCamera(),
    depth_map: DepthMap = DepthMap(),
    blurring: BlurOptions = BlurOptions(),
    data: DataSet = DataSet(),
) -> Report:
    """Blur a photo by its depth map or over a lens field.

    PHOTO is a PNG, JPEG, TIFF, EXR, BMP or HEIC, grey or RGB. DEPTH is a depth map of the same size, the
    distance of each point from the lens along the optical axis, in metres: a grey TIFF, NPY, PFM, PNG or EXR. Without
    a lens file LENS, focal length and f-number come from the photo's EXIF; an option that contradicts the EXIF is
    rejected.

    The aberrations of the lens must be radially symmetric (defocus, spherical), and its aperture round: leave out
    coma, astigmatism and other terms with a direction.

    Integer values are clipped at white, as on a sensor, and the clipped fraction is printed.

    Parameters
    ----------
    output
        Blurred photo: {photo}. With --batch: a folder.
    encoding
        Encoding of the photo's values; by default integers are sRGB and floats are linear.
    over_field
        Render PHOTO, as an ideal lens would record it, through the lens file given in place of DEPTH, which needs a
        section [field]: blur over the field, distortion, lateral colour and shading. The axis is in the middle of the
        photo. --tol is then 0.001 by default.
    batch
        Blur all photos of the folder PHOTO by the depth maps of the same names in the folder DEPTH into the folder
        --output, with ground truth. LENS may have pairs in place of numbers: ranges from which the lens of each
        picture is drawn. After an interruption, the same command resumes. Files that cannot be used are reported and
        left out, with exit code 3.
    supersample
        Points of PHOTO and DEPTH along each side of a pixel of the output, which averages them.
    workers
        Number of processes.

    Examples
    --------
      lommel blur photo.jpg depth.tif --focus 1.2m --pixel 4um -o out.jpg
      lommel blur photo.png depth.png phone.toml --depth-scale 0.001 --unknown 0 --missing nearest -o out.tif
      lommel blur photo.png camera-field.toml --over-field --pixel 6um -o out.png
      lommel blur --batch photos/ depths/ phone.toml --seed 1 --workers 2 -o set/
    """
    if over_field:
        return _through_field(photo, (depth, lens), output, encoding, camera_options, blurring)
    if batch:
        return _render(output, (photo, depth, lens), camera_options, depth_map, data)
    _refuse_others(vars(DataSet()), "is an option for data sets, and needs --batch")
    find(output, "--output")
    with terminated_as_interrupted(), progress("reading") as status:
        job = Job((photo, depth, lens), output, encoding, camera_options, depth_map)
        status("computing PSFs")
        start = time.perf_counter()
        rendered = depth_of_field(
            job.photograph.light(),
            job.filled_depth,
            job.lens,
            job.pixel,
            encoding="linear",
            progress=lambda done, total: status("blurring", done / total),
            options=blurring,
        )
        seconds = time.perf_counter() - start
        clipped = job.write(rendered.values)
    return job.report(_errors(rendered, clipped) | {"seconds": seconds}, blurring.supersample)


def _refuse_others(names: Iterable[str], reason: str) -> None:
    """Raise ValueError if the command line states one of the options with these names."""
    for name, flag in given_flags().items():
        if name in names:
            raise ValueError(f"{flag} {reason}")


def _errors(rendered: Rendered, clipped: float) -> Facts:
    """Return interpolation error, window and clipped fraction of a photograph."""
    facts = {"largest_window": rendered.window, "light_beyond_windows": rendered.lost}
    return facts | {"interpolation_error": rendered.error, "clipped": clipped}


def _render(
    folder: Path,
    files: tuple[Path, Path, Path | None],
    camera: PhotoCamera,
    depth_map: DepthMapOptions,
    data: DataSet,
) -> Report:
    """Render a data set into a folder, from folders of photos and of depth maps and from a file of lenses."""
    photos, depths, lens = files
    _refuse_others(
        {"camera", "encoding", *vars(BlurOptions())},
        "is an option for a single photo; it cannot be combined with --batch",
    )
    lenses = _lenses(lens, camera)
    start, rendered = time.perf_counter(), 0
    finished = total = 0
    failed: list[Facts] = []
    rendered_facts: list[Facts] = []
    try:
        with progress("reading") as status:
            pictures = render_dataset(photos, depths, folder, lenses, seed=data.seed, options=data.options(depth_map))
            for picture in pictures:
                finished, total = picture.done, picture.total
                if picture.failure is None:
                    rendered += 1
                    rendered_facts.append(picture.facts)
                    status(f"picture {finished} of {total}", finished / total)
                    continue
                reason = with_options(picture.failure)
                if reason not in [failure["reason"] for failure in failed]:  # not yet reported for another copy
                    print(f"Left out: {reason}", file=sys.stderr)
                failed.append({"number": picture.number, **picture.facts, "reason": reason})
    except KeyboardInterrupt:
        finished_text = f"{finished} of {total} pictures are finished" if rendered else "no picture was finished"
        print(f"Interrupted: {finished_text}; the same command resumes.", file=sys.stderr)
        raise
    seconds = time.perf_counter() - start
    if failed and not finished:
        raise ValueError(f"no picture could be rendered: {failed[0]['reason']}")
    facts = {"output": str(folder), "rendered": rendered, "seconds": seconds, "failed": failed}
    if rendered_facts:
        ends = [float(end) for picture_facts in rendered_facts for end in picture_facts["depth_range"]] or [math.nan]
        unknown_fractions = [picture_facts["depth_unknown"] for picture_facts in rendered_facts]
        facts |= {"depth": [finite(min(ends)), finite(max(ends))]}
        facts |= {"depth_unknown": sum(unknown_fractions) / len(unknown_fractions)}
    return told(facts, succeeded=not failed)


def _lenses(file: Path | None, camera: PhotoCamera) -> LensRanges:
    """Return the lenses of a file, whose values options override."""
    from lommel.lensfiles.lens_files import load_lens_ranges

    if file is None:
        raise ValueError("LENS is missing: give a file with the lens, or with ranges from which lenses are drawn")
    values = {name: getattr(camera, name) for name in ("f_number", "focus_distance", "pixel")}
    overrides = {name: value for name, value in values.items() if value is not None}
    return LensRanges(**{**vars(load_lens_ranges(file)), **overrides})


_FIELD_OPTIONS = {"output", "over_field", "camera", "pixel", "encoding", "tol"}


def _through_field(
    photo: Path,
    files: tuple[Path, Path | None],
    output: Path,
    encoding: Encoding | None,
    camera_options: PhotoCamera,
    blurring: BlurOptions,
) -> Report:
    """Render a photograph through the lens of a file: blur over its field, distortion, lateral colour, shading."""
    path, other = files
    stated = given_flags() | ({} if other is None else {"lens": "DEPTH"})
    for name, flag in stated.items():
        if name not in _FIELD_OPTIONS:
            raise ValueError(f"{flag} cannot be combined with --over-field, which takes PHOTO and the lens file")
    find(output, "--output")
    with terminated_as_interrupted(), progress("reading") as status:
        photograph = read_photo(photo, encoding)
        light = photograph.light()
        instrument = instrument_of(path)
        field = instrument.field()
        if field.vignetting is not None:
            raise ValueError(
                f"{path} must have no [field.vignetting]: state the whole relative illumination in [field.shading]"
            )
        camera = camera_options.camera or instrument.camera
        pitch = camera_options.pixel or (instrument.side if camera is None else camera.side)
        dtype, stored_as = output_type(photograph, output)
        status("computing PSFs and blurring")
        start = time.perf_counter()
        tol = FieldPhotographOptions(tol=blurring.tol) if "tol" in stated else None
        rendered = field_photograph(light, field, pitch, encoding="linear", options=tol)
        seconds = time.perf_counter() - start
        clipped = write_photo(output, rendered.values, encoding=stored_as, dtype=dtype, like=photograph)
    height, width = light.shape[:2]
    x, y = (0.5 * (side - 1) * pitch for side in (width, height))
    shift = math.hypot(*(float(part) for part in field.displacement(x, y))) / pitch
    facts = _errors(rendered, clipped) | {
        "shape": list(light.shape),
        "encoding": {"photo": photograph.encoding, "output": stored_as},
        "read": read_as(photograph, encoding),
        "pixel": pitch,
        "moved": shift,
        "seconds": seconds,
    }
    return told(facts) + written([output])


_METHODS = {"richardson-lucy": RichardsonLucy, "total-variation": TotalVariation, "one-pass": OnePass}
METHOD = Shown(("--method",))


@command
@filled(photo=suffixes("photo"))
def restore(
    photo: Path,
    depth: Path,
    lens: Path | None = None,
    /,
    *,
    output: Annotated[Path, OUTPUT],
    encoding: Encoding | None = None,
    algorithm: Annotated[Literal["richardson-lucy", "total-variation", "one-pass"], METHOD] = "richardson-lucy",
    restoring: RestoreOptions = RestoreOptions(),
    noise_options: MaskedPhotoNoise = MaskedPhotoNoise(),
    camera_options: PhotoCamera = PhotoCamera(),
    depth_map: DepthMap = DepthMap(),
) -> Report:
    """Deblur a photo with a known depth map and lens.

    PHOTO is a PNG, JPEG, TIFF, EXR, BMP or HEIC, grey or RGB, neither sharpened nor denoised. DEPTH is a depth
    map of the same size, the distance of each point from the lens along the optical axis, in metres: a grey TIFF,
    NPY, PFM, PNG or EXR. Without a lens file LENS, focal length and f-number come from the photo's EXIF.

    The printed discrepancy is the Poisson deviance per pixel between the photo and the restored photo, blurred again:
    about 1 where they differ only by noise. A larger value means that depth, lens or noise do not fit the photo: the
    exit code is then 3.

    Parameters
    ----------
    output
        Restored photo: {photo}.
    encoding
        Encoding of the photo's values, such as linear for 16 bits developed from a raw file; by default integers are
        sRGB and floats are linear.
    algorithm
        Richardson-Lucy maximises the likelihood; total variation also smooths and preserves edges: usually less noise
        at the same sharpness, but ten to forty times slower; one-pass applies Wiener filters, and is as good where
        depth has few edges.
    saturation
        Level at which pixels saturate, as a fraction of white in linear light (after decoding sRGB), such as 0.95.

    Examples
    --------
      lommel restore photo.tif depth.tif phone.toml --white 5000 --read 3 -o sharp.tif
      lommel restore photo.tif depth.tif phone.toml --white 5000 --read 3 --method total-variation -o sharp.png
    """
    find(output, "--output")
    with terminated_as_interrupted(), progress("reading") as status:
        job = Job((photo, depth, lens), output, encoding, camera_options, depth_map)
        values = job.photograph.values
        (values,) = apply_mask([values], noise_options.mask)
        status("computing PSFs")
        start = time.perf_counter()

        def step_done(step: int, discrepancy: float, remaining: float) -> None:
            elapsed = time.perf_counter() - start
            status(f"step {step}, discrepancy {discrepancy:.3g}", elapsed / max(elapsed + remaining, 1e-9))

        result = restored(
            values,
            job.filled_depth,
            job.lens,
            job.pixel,
            encoding=job.photograph.encoding,
            noise=noise_of(vars(noise_options), job.camera, photographs=True),
            progress=step_done,
            options=replace(restoring, method=_METHODS[algorithm]()),
        )
        seconds = time.perf_counter() - start
        clipped = job.write(np.asarray(result.light))
    facts = {"seconds": seconds, "method": algorithm} | result.to_dict() | {"clipped": clipped}
    findings = [Wrapped(found.text) for found in result.findings]
    return job.report(facts) + Report({}, findings, result.converged)


def apply_mask(photos: Sequence[Pixels], path: Path | None) -> Sequence[Pixels]:
    """Return photos whose pixels are masked by an image file, if there is one."""
    if path is None:
        return photos
    mask = mask_of(path, np.broadcast_to(False, (len(photos), *photos[0].shape[:2])))
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


class Job:
    """A photograph, its depth map and its lens from the options of a command, and the format of the result."""

    def __init__(
        self,
        files: tuple[Path, Path, Path | None],
        output: Path,
        encoding: Encoding | None,
        stated: PhotoCamera,
        depth_map: DepthMapOptions,
    ) -> None:
        self._photo, depth, lens = files
        self._output, self._encoding = output, encoding
        self.photograph = read_photo(self._photo, encoding)
        shape = self.photograph.values.shape
        self._depth = read_depth(depth, shape=shape, options=replace(depth_map, missing=None))
        self.filled_depth = fill_missing(self._depth, depth_map.missing)
        self.camera = stated.camera
        pixel = stated.pixel if stated.pixel is not None or self.camera is None else self.camera.side
        if lens is None:
            optics = self._lens_of_exif(stated.f_number)
            if pixel is None:
                raise ValueError("without a lens file give --camera or --pixel")
            if stated.focus_distance is None:
                raise ValueError("without a lens file give --focus")
        else:
            instrument = radial_instrument(lens)
            optics = instrument.lens
            pixel = instrument.side if pixel is None else pixel
            self.camera = self.camera or instrument.camera
            try:
                optics = optics if stated.f_number is None else optics.stopped(stated.f_number)
            except ValueError as error:
                raise ValueError(f"--f-number of {lens}: {error}") from None
        self.lens = optics if stated.focus_distance is None else optics.focused(stated.focus_distance)
        self.pixel = pixel
        self._dtype, self._stored_as = output_type(self.photograph, output)
        find(output, "--output", holding=f"of {self._dtype}")

    def _lens_of_exif(self, f_number: float | None) -> Lens:
        """Return a lens with the data of the EXIF, focused at infinity."""
        exif = self.photograph.exif
        number = exif.f_number if f_number is None else f_number
        if exif.focal_length is None or number is None:
            missing = "focal length" if exif.focal_length is None else "f-number"
            raise ValueError(f"give a lens file: the EXIF of {self._photo} has no {missing}")
        if exif.f_number is not None and not math.isclose(number, exif.f_number, rel_tol=_TOLERANCE):
            raise ValueError(
                f"--f-number f/{number:g} contradicts the EXIF of {self._photo}, f/{exif.f_number:g}; give a lens "
                "file"
            )
        wavelength = 540e-9 if self.photograph.values.ndim == 3 else 550e-9
        return Lens(focal_length=exif.focal_length, f_number=number, wavelength=wavelength)

    def write(self, light: Values) -> float:
        """Write the result and return the clipped fraction of its values."""
        return write_photo(self._output, light, encoding=self._stored_as, dtype=self._dtype, like=self.photograph)

    def report(self, facts: Facts, points: int = 1) -> Report:
        """Return the report: facts of the command, after those common to all commands.

        `points` is the number of points of the photograph along each side of a pixel of the result.
        """
        photograph, lens = self.photograph, self.lens
        height, width, *channels = photograph.values.shape
        common = {
            "shape": [height // points, width // points, *channels],
            "encoding": {"photo": photograph.encoding, "output": self._stored_as},
            "read": read_as(photograph, self._encoding),
            "bits": "float" if self._dtype.kind == "f" else str(8 * self._dtype.itemsize),
            "focal_length": lens.focal_length,
            "f_number": lens.f_number,
            "focus_distance": finite(lens.focus_distance),
            "pixel": self.pixel,
        }
        return told(common | depth_facts(self._depth) | facts) + written([self._output])


def read_as(photograph: Photograph, encoding: str | None) -> str:
    """Return a description of the encoding of a photograph, as `encoding` or assumed."""
    kind = "float" if photograph.values.dtype.kind == "f" else f"{8 * photograph.values.dtype.itemsize}-bit"
    names = {"srgb": "sRGB", "linear": "linear"}
    if encoding is not None:
        return f"{kind} values, {names[encoding]}"
    other = "linear" if photograph.encoding == "srgb" else "srgb"
    return f"{kind} values, assumed {names[photograph.encoding]}; if they are {names[other]}, give --encoding {other}"


def output_type(photograph: Photograph, output: Path) -> tuple[np.dtype[np.generic], str]:
    """Return the type and the encoding of the output, as in the photo if the format can store them."""
    kind, suffix = photograph.values.dtype, output.suffix.lower()
    dtype: np.dtype[np.generic] = kind
    if suffix in (".jpg", ".jpeg"):
        dtype = np.dtype(np.uint8)
    elif kind.kind == "f":
        dtype = np.dtype(np.float32 if suffix in (".tif", ".tiff") else np.uint16)
    # Values of the same kind keep their encoding; others get the encoding that readers assume for them.
    return dtype, photograph.encoding if (dtype.kind == "f") == (kind.kind == "f") else "srgb"
