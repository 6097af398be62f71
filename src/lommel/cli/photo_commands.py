"""The commands on photographs: ``blur``, ``restore``, ``align``, ``depth`` (from defocus) and its ``precision``."""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

from lommel import imaging
from lommel.base.arrays import Values, plain
from lommel.base.encoding import Encoding, as_json, named, to_light
from lommel.base.executors import connected
from lommel.base.options import In, Shown, filled
from lommel.cli.command import CLIENT, ENCODING, OUTPUT, PLOT, command, length
from lommel.cli.instruments import (
    PLACE,
    MaskedPhotoNoise,
    PhotoCamera,
    Sensor,
    instrument_of,
    mask_of,
    noise_of,
    radial_instrument,
    states_noise,
    tell_optics,
)
from lommel.cli.interrupts import Stop
from lommel.cli.messages import given_flags, with_options
from lommel.cli.output import progress, save_figure, written
from lommel.estimation.depth_precision import CONTRAST, WINDOW, best_depth_foci, depth_precision
from lommel.imaging.field_blur import FieldPhotographOptions
from lommel.imaging.settings import channel_spectra
from lommel.io import photos as photo_files
from lommel.io.depth_maps import fill_missing
from lommel.io.registry import suffixes
from lommel.measures.measured_psf import MeasuredPSF
from lommel.optics.lens import Lens
from lommel.psf import PSF
from lommel.recorded.counts import full_value
from lommel.recorded.noise import Noise
from lommel.report import Facts, Report, Wrapped, finite
from lommel.report.table import described, records_of, told
from lommel.show import estimates

if TYPE_CHECKING:
    from lommel.imaging.defocus_verdict import DefocusVerdict
    from lommel.imaging.photograph import Pixels
    from lommel.lensfiles.instrument import Instrument

_UNIT_PIXEL = 1e-6  # pitch of the pixels of a measured PSF, metres: only the ratio to that of the photo matters
_READ = 3.0  # default read noise, rms electrons, without a camera
_MOST_BLOCKS = 64  # in a table; more are in JSON only
_ROWS, _POINTS = 11, 121  # numbers of distances in the table and in the figure


_LENS_FLAGS = {"f_number", "focus_distance", "pixel"}

BETWEEN = Shown(length="m", metavar="NEAR FAR")
"""Form of the nearest and the farthest distance."""


@dataclass(frozen=True, kw_only=True)
class DataSet(imaging.DatasetOptions):
    """Options for a data set instead of a single photograph.

    Parameters
    ----------
    seed
        Seed of the lenses and of the noise.
    white
        Electrons at white, such as 5000, for photon noise.
    read
        Read noise, rms electrons; needs --white.
    client
        Scheduler of a dask cluster that renders, such as tcp://host:8786; its workers must reach all folders.
    """

    heading: ClassVar[str] = "Data set"
    seed: int = 0
    white: float | None = None
    read: float | None = None
    client: Annotated[str | None, CLIENT] = None

    def options(self, depth: imaging.DepthMapOptions, client: Any) -> imaging.DatasetOptions:
        """Return the options of :func:`lommel.imaging.render_dataset`."""
        if self.white is None and self.read is not None:
            raise ValueError("--read needs --white, the electrons at white")
        noise = None if self.white is None else Noise(white=self.white, read=self.read or 0.0)
        return imaging.DatasetOptions(
            copies=self.copies,
            workers=self.workers,
            client=client,
            noise=noise,
            depth_options=depth,
            on_error="skip",
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
    encoding: Annotated[Encoding | None, ENCODING] = None,
    over_field: bool = False,
    batch: bool = False,
    camera_options: PhotoCamera = PhotoCamera(),
    depth_map: imaging.DepthMapOptions = imaging.DepthMapOptions(),
    blurring: imaging.BlurOptions = imaging.BlurOptions(),
    data: DataSet = DataSet(),
) -> Report:
    """Blur a photo by its depth map or over a lens field.

    PHOTO is a PNG, JPEG, TIFF, EXR or HEIC, grey or RGB. DEPTH is a depth map of the same size, the
    distance of each point from the lens along the optical axis, in metres: a grey TIFF, NPY, PFM, PNG or EXR. Without
    a lens file LENS, focal length and f-number come from the photo's EXIF; a lens file or an option that contradicts
    the EXIF is named.

    The aberrations of the lens must be radially symmetric (defocus, spherical), and its aperture round: leave out
    coma, astigmatism and other terms with a direction.

    Integer values are clipped at white, as on a sensor, and the clipped fraction is printed.

    Parameters
    ----------
    output
        Blurred photo: {photo}. With --batch: a folder.
    encoding
        Encoding of the photo's values: srgb, linear, or a number, as 1.8 for light = value ** 1.8; by default as the
        photo states (ICC profile), else integers are sRGB; floats are linear.
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
    _refuse(vars(DataSet()).keys() & given_flags(), "is an option for data sets, and needs --batch")
    photo_files.find(output, "--output")
    with Stop().signals(), progress("reading") as status:
        job = Job((photo, depth, lens), output, encoding, camera_options, depth_map, blurring.supersample)
        status("computing PSFs")
        start = time.perf_counter()
        rendered = imaging.depth_of_field(
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
    return job.report(_errors(rendered, clipped) | {"seconds": seconds})


def _refuse(names: Iterable[str], reason: str) -> None:
    """Raise ValueError if there are options, by these names of arguments, that do not apply."""
    for name in sorted(names):
        raise ValueError(f"{given_flags()[name]} {reason}")


def _errors(rendered: imaging.Rendered, clipped: float) -> Facts:
    """Return interpolation error, window and clipped fraction of a photograph."""
    facts = {"largest_window": rendered.window, "light_beyond_windows": rendered.lost}
    return facts | {"interpolation_error": rendered.error, "clipped": clipped}


def _render(
    folder: Path,
    files: tuple[Path, Path, Path | None],
    camera: PhotoCamera,
    depth_map: imaging.DepthMapOptions,
    data: DataSet,
) -> Report:
    """Render a data set into a folder, from folders of photos and of depth maps and from a file of lenses."""
    photos, depths, lens = files
    _refuse(
        {"camera", "encoding", *vars(imaging.BlurOptions())} & given_flags().keys(),
        "is an option for a single photo; it cannot be combined with --batch",
    )
    lenses = _lenses(lens, camera)
    start, finished, total = time.perf_counter(), 0, 0
    failed: list[Facts] = []
    rendered: list[Facts] = []
    try:
        elsewhere = data.client is not None or data.workers > 1
        with progress("reading", elsewhere=elsewhere) as status, connected(data.client) as cluster:
            pictures = imaging.render_dataset(
                photos, depths, folder, lenses, seed=data.seed, options=data.options(depth_map, cluster)
            )
            for picture in pictures:
                finished, total = picture.done, picture.total
                if picture.failure is None:
                    rendered.append(picture.facts)
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
    facts = {"output": str(folder), "rendered": len(rendered), "seconds": seconds, "failed": failed}
    if rendered:
        ends = [float(end) for picture in rendered for end in picture["depth_range"]] or [math.nan]
        unknown = sum(picture["depth_unknown"] for picture in rendered) / len(rendered)
        facts |= {"depth": [finite(min(ends)), finite(max(ends))], "depth_unknown": unknown}
    return told(facts, succeeded=not failed)


def _lenses(file: Path | None, camera: PhotoCamera) -> imaging.LensRanges:
    """Return the lenses of a file, whose values options override."""
    from lommel.lensfiles.lens_files import load_lens_ranges

    if file is None:
        raise ValueError("LENS is missing: give a file with the lens, or with ranges from which lenses are drawn")
    values = {name: getattr(camera, name) for name in ("f_number", "focus_distance", "pixel")}
    overrides = {name: value for name, value in values.items() if value is not None}
    return imaging.LensRanges(**{**vars(load_lens_ranges(file)), **overrides})


_FIELD_OPTIONS = {"output", "over_field", "camera", "pixel", "encoding", "tol"}


def _through_field(
    photo: Path,
    files: tuple[Path, Path | None],
    output: Path,
    encoding: Encoding | None,
    camera_options: PhotoCamera,
    blurring: imaging.BlurOptions,
) -> Report:
    """Render a photograph through the lens of a file: blur over its field, distortion, lateral colour, shading."""
    path, other = files
    reason = "cannot be combined with --over-field, which takes PHOTO and the lens file"
    if other is not None:
        raise ValueError(f"DEPTH {reason}")
    _refuse(given_flags().keys() - _FIELD_OPTIONS, reason)
    photo_files.find(output, "--output")
    with Stop().signals(), progress("reading") as status:
        photograph = imaging.read_photo(photo, encoding)
        light = photograph.light()
        instrument = instrument_of(path)
        field = instrument.field()
        if field.vignetting is not None:
            raise ValueError(
                f"{path} must have no [field.vignetting]: state the whole relative illumination in [field.shading]"
            )
        camera = camera_options.camera or instrument.camera
        pitch = camera_options.pixel or (instrument.side if camera is None else camera.side)
        tell_optics(photo.name, photograph.exif, pitch, instrument.lens)
        dtype, stored_as = output_type(photograph, output)
        status("computing PSFs and blurring")
        start = time.perf_counter()
        tol = FieldPhotographOptions(tol=blurring.tol) if "tol" in given_flags() else None
        rendered = imaging.field_photograph(light, field, pitch, encoding="linear", options=tol)
        seconds = time.perf_counter() - start
        clipped = imaging.write_photo(output, rendered.values, encoding=stored_as, dtype=dtype, like=photograph)
    height, width = light.shape[:2]
    x, y = (0.5 * (side - 1) * pitch for side in (width, height))
    shift = math.hypot(*(float(part) for part in field.displacement(x, y))) / pitch
    facts = _errors(rendered, clipped) | {
        "shape": list(light.shape),
        "encoding": _encodings(photograph, stored_as),
        "read": _read_as(photograph),
        "pixel": pitch,
        "moved": shift,
        "seconds": seconds,
    }
    return told(facts) + written([output])


_METHODS = {
    "blend": imaging.Blend,
    "richardson-lucy": imaging.RichardsonLucy,
    "total-variation": imaging.TotalVariation,
    "one-pass": imaging.OnePass,
}
METHOD = Shown(("--method",))


def _distance(text: str) -> float | str:
    """Return a distance in metres, or "unknown"."""
    return text if text == "unknown" else length("m", text)


AT = Shown(metavar="DISTANCE|unknown", parse=_distance)
"""Form of the distance of a whole scene."""


@command
@filled(photo=suffixes("photo"))
def restore(
    photo: Path,
    depth: Path | None = None,
    lens: Path | None = None,
    /,
    *,
    output: Annotated[Path, OUTPUT],
    at: Annotated[float | str | None, AT] = None,
    field: Annotated[Path | None, Shown(metavar="FILE")] = None,
    psf: Annotated[Path | None, Shown(metavar="FILE")] = None,
    encoding: Annotated[Encoding | None, ENCODING] = None,
    algorithm: Annotated[Literal["blend", "richardson-lucy", "total-variation", "one-pass"] | None, METHOD] = None,
    restoring: imaging.RestoreOptions = imaging.RestoreOptions(),
    noise_options: MaskedPhotoNoise = MaskedPhotoNoise(),
    camera_options: PhotoCamera = PhotoCamera(),
    depth_map: imaging.DepthMapOptions = imaging.DepthMapOptions(),
) -> Report:
    """Deblur a photo, with a known lens by its depth map or distance.

    PHOTO is a PNG, JPEG, TIFF, EXR or HEIC, grey or RGB, neither sharpened nor denoised. DEPTH is a depth
    map of the same size, the distance of each point from the lens along the optical axis, in metres: a grey TIFF,
    NPY, PFM, PNG or EXR; with --at there is none. Without a lens file LENS, focal length and f-number come from the
    photo's EXIF. With PHOTO alone, the blur is estimated as a disc, the same all over the photo.

    With one distance, the stated blur is compared with others. A photo that is sharper than stated, or that was moved
    during the exposure, is a doubt; --accept then restores by the blur that agrees better.

    The printed discrepancy is the Poisson deviance per pixel between the photo and the restored photo, blurred again:
    about 1 where they differ only by noise. Where it shows that depth, lens or noise do not fit, the photo is
    written, and the exit code is 3.

    Parameters
    ----------
    output
        Restored photo: {photo}.
    encoding
        Encoding of the photo's values, such as linear for 16 bits developed from a raw file; by default integers are
        sRGB and floats are linear.
    at
        Distance of the whole scene in place of DEPTH, such as 1.5m; unknown: estimated from the blur of the photo,
        where depth varies in blocks of 256 pixels.
    field
        Aberrations over the field in place of DEPTH: a table as written by lommel fit-field (.csv), or a lens file
        with a section [field]. The axis is in the middle of the photo.
    psf
        Measured PSF in place of DEPTH and LENS: the photo of one point of light, such as a star or a pinhole, by the
        same camera, focus and distance, with the channels of PHOTO or grey; not saturated. --encoding states that
        of both photos; integers of 16 bits, too, are sRGB without it.
    algorithm
        Blend mixes Wiener filters and total variation for one distance, and is the default there. For depth maps,
        Richardson-Lucy, the default, maximises the likelihood; total variation also preserves edges, but is ten to
        forty times slower; one-pass applies Wiener filters, and is as good where depth has few edges.
    saturation
        Level at which pixels saturate, as a fraction of white in linear light (after decoding sRGB), such as 0.95.

    Examples
    --------
      lommel restore photo.tif phone.toml --focus 2m --at 1.5m --white 5000 --read 3 -o sharp.tif
      lommel restore photo.tif phone.toml --focus 2m --at unknown --white 5000 --read 3 -o sharp.tif
      lommel restore photo.tif phone.toml --field field.csv --white 5000 --read 3 -o sharp.tif
      lommel restore photo.tif --psf star.tif --white 5000 --read 3 -o sharp.tif
      lommel restore photo.tif --white 5000 --read 3 -o sharp.tif
      lommel restore photo.tif depth.tif phone.toml --white 5000 --read 3 -o sharp.tif
      lommel restore photo.tif depth.tif phone.toml --white 5000 --read 3 --method total-variation -o sharp.png
    """
    photo_files.find(output, "--output")
    with Stop().signals(), progress("reading") as status:
        states = {"--at": at, "--field": field, "--psf": psf}
        stated = [flag for flag, value in states.items() if value is not None]
        if len(stated) > 1:
            raise ValueError(f"{stated[0]} cannot be combined with {stated[1]}, which states the blur")
        if stated:
            if lens is not None or (psf is not None and depth is not None):
                raise ValueError(f"{'DEPTH' if psf is None else 'a lens'} cannot be combined with {stated[0]}")
            depth, lens = None, depth
        elif depth is None and _LENS_FLAGS & given_flags().keys():
            raise ValueError("give a depth map DEPTH, or --at, the distance of the whole scene (or unknown)")
        needs_lens = psf is None and bool(stated or depth)
        job = Job((photo, depth, lens), output, encoding, camera_options, depth_map, needs_lens=needs_lens)
        values = job.photograph.values
        (values,) = apply_mask([values], noise_options.mask)
        status("computing PSFs")
        start = time.perf_counter()

        def step_done(step: int, discrepancy: float, remaining: float) -> None:
            elapsed = time.perf_counter() - start
            status(f"step {step}, discrepancy {discrepancy:.3g}", elapsed / max(elapsed + remaining, 1e-9))

        chosen = replace(restoring, method=_METHODS[algorithm]() if algorithm else None)
        place: tuple[Any, ...] = "unknown", None, None
        read: Facts = {}
        if psf is not None:
            star = imaging.read_photo(psf, encoding)
            place, read = (None, _measured_psfs(psf, star), None), {"psf_read": _read_as(star)}
        elif field is not None:
            place = None, _field_blur(field, job), None
            chosen = replace(chosen, saturation=chosen.saturation or 1.0)
        elif needs_lens:
            place = job.filled_depth if at is None else at, job.lens, job.pixel
        result = imaging.restore(
            values,
            *place,
            encoding=job.photograph.encoding,
            noise=noise_of(vars(noise_options), job.camera, photographs=True),
            progress=step_done,
            options=chosen,
        )
        seconds = time.perf_counter() - start
        clipped = job.write(np.asarray(result.light))
    facts = read | {"seconds": seconds, "method": algorithm or "default"} | result.to_dict() | {"clipped": clipped}
    findings = [Wrapped(with_options(found.text)) for found in result.findings.printed]
    hidden = {"blocks": facts.pop("blocks")} if len(result.blocks) > _MOST_BLOCKS else {}
    return job.report(facts) + Report(hidden, findings, result.converged)


def _measured_psfs(path: Path, photograph: imaging.Photograph) -> list[MeasuredPSF]:
    """Return the PSFs of the channels of the photo of a point, in units of pixels."""
    light = photograph.light()
    if (full := float(light.max())) >= 1.0 and photograph.values.dtype.kind == "u":
        raise ValueError(f"--psf must not be saturated, got {path.name} with pixels at {full:g} of white")
    planes = np.moveaxis(light.reshape(*light.shape[:2], -1), 2, 0)
    try:
        return [PSF.measured(plane, _UNIT_PIXEL) for plane in planes]
    except ValueError as error:
        reason = str(error).removeprefix("array ")
        raise ValueError(
            f"--psf {path.name} {reason}; the point must be whole, with dark pixels around it"
        ) from error


def _field_blur(path: Path, job: Job) -> imaging.FieldBlur:
    """Return the blur of a photograph by a table of wavefronts over the field, or by a lens file with one."""
    from lommel.lensfiles.tables import read_csv

    if path.suffix.lower() == ".toml":
        field = instrument_of(path).field()
    else:
        pupil = job.lens.pupil()
        table = read_csv(path, "noll")
        field = table.field_map(pupil, unit="waves", normalization="rms", direction="x") + pupil.wavefront
    shape = job.photograph.values.shape
    channels = channel_spectra(shape, job.lens.wavelength)
    return imaging.FieldBlur(field, (shape[0], shape[1]), job.pixel, channels=channels)


def read_alike(paths: Sequence[Path], encoding: Encoding | None) -> list[imaging.Photograph]:
    """Return photos; ValueError unless they have one type and one encoding."""
    pictures = [imaging.read_photo(path, encoding) for path in paths]
    if len({(picture.values.dtype, picture.encoding) for picture in pictures}) > 1:
        raise ValueError("the photos must have one type and one encoding; give --encoding or convert them")
    return pictures


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


class Job:
    """A photograph, its depth map and its lens from the options of a command, and the format of the result."""

    def __init__(
        self,
        files: tuple[Path, Path | None, Path | None],
        output: Path,
        encoding: Encoding | None,
        stated: PhotoCamera,
        depth_map: imaging.DepthMapOptions,
        points: int = 1,
        needs_lens: bool = True,
    ) -> None:
        """Read the files, of which a depth map may be missing, and the lens unless it is not needed.

        `points` is the number of points of the photo along each side of a pixel of the result.
        """
        self._photo, depth, lens = files
        self._output = output
        self.photograph = imaging.read_photo(self._photo, encoding)
        shape = self.photograph.values.shape
        self._depth = np.empty((0, 0))
        if depth is not None:
            self._depth = imaging.read_depth(depth, shape=shape, options=replace(depth_map, missing=None))
        self.filled_depth = fill_missing(self._depth, depth_map.missing)
        self._has_lens, self.camera = needs_lens, stated.camera
        if not needs_lens:
            _refuse(_LENS_FLAGS & given_flags().keys(), "cannot be combined with --psf")
        elif lens is not None:
            instrument = radial_instrument(lens, **vars(stated))
            self.lens, self.pixel, self.camera = instrument.lens, instrument.side, instrument.camera
        else:
            self.lens = self._lens_of_exif(stated.f_number)
            pixel = stated.pixel or (None if stated.camera is None else stated.camera.side)
            if pixel is None:
                raise ValueError("without a lens file give --camera or --pixel")
            if stated.focus_distance is None:
                raise ValueError("without a lens file give --focus")
            self.lens = self.lens.focused(stated.focus_distance)
            self.pixel = pixel
        if needs_lens:
            tell_optics(self._photo.name, self.photograph.exif, self.pixel / points, self.lens)
        self._points = points
        self._dtype, self._stored_as = output_type(self.photograph, output)
        photo_files.find(output, "--output", holding=f"of {self._dtype}")

    def _lens_of_exif(self, f_number: float | None) -> Lens:
        """Return a lens with the data of the EXIF, focused at infinity."""
        exif = self.photograph.exif
        number = exif.f_number if f_number is None else f_number
        if exif.focal_length is None or number is None:
            missing = "focal length" if exif.focal_length is None else "f-number"
            raise ValueError(f"give a lens file: the EXIF of {self._photo} has no {missing}")
        wavelength = 540e-9 if self.photograph.values.ndim == 3 else 550e-9
        return Lens(focal_length=exif.focal_length, f_number=number, wavelength=wavelength)

    def write(self, light: Values) -> float:
        """Write the result and return the clipped fraction of its values."""
        return imaging.write_photo(
            self._output, light, encoding=self._stored_as, dtype=self._dtype, like=self.photograph
        )

    def report(self, facts: Facts) -> Report:
        """Return the report: facts of the command, after those common to all commands."""
        photograph = self.photograph
        height, width, *channels = photograph.values.shape
        common: Facts = {
            "shape": [height // self._points, width // self._points, *channels],
            "encoding": _encodings(photograph, self._stored_as),
            "read": _read_as(photograph),
            "bits": "float" if self._dtype.kind == "f" else str(8 * self._dtype.itemsize),
        }
        if self._has_lens:
            common |= {
                "focal_length": self.lens.focal_length,
                "f_number": self.lens.f_number,
                "focus_distance": finite(self.lens.focus_distance),
                "pixel": self.pixel,
            }
        depth = depth_facts(self._depth) if self._depth.size else {}
        return told(common | depth | facts) + written([self._output])


def read_as(dtype: np.dtype[np.generic], bits: int, encoding: Encoding, stated: bool) -> str:
    """Return a description of the encoding of values, as stated or assumed."""
    text = f"{'float' if dtype.kind == 'f' else f'{bits}-bit'} values, "
    if stated:
        return text + named(encoding)
    other = "linear" if encoding == "srgb" else "srgb"
    return f"{text}assumed {named(encoding)}; if they are {named(other)}, give --encoding {other}"


def _encodings(photograph: imaging.Photograph, stored_as: Encoding) -> Facts:
    return {"photo": as_json(photograph.encoding), "output": as_json(stored_as)}


def _read_as(photograph: imaging.Photograph) -> str:
    dtype = photograph.values.dtype
    return read_as(dtype, 8 * dtype.itemsize, photograph.encoding, photograph.stated)


def _white_of(photos: Sequence[Values]) -> str:
    """Return which value is white, for integers of at most half of their type, as 12 bits in 16; else ""."""
    if photos[0].dtype.kind != "u":
        return ""
    largest, white = max(int(photo.max()) for photo in photos), int(np.iinfo(photos[0].dtype).max)
    if 2 * largest > white:
        return ""
    limit = min(full_value([photo], None)[0] for photo in photos)
    taken = f"{limit:.0f} is" if limit < white else "no smaller value is"
    return f"; the largest is {largest}, but white (--white) is {white}: {taken} taken as saturated (--mask)"


def output_type(photograph: imaging.Photograph, output: Path) -> tuple[np.dtype[np.generic], Encoding]:
    """Return the type and the encoding of the output, as in the photo if the format can store them."""
    kind, suffix = photograph.values.dtype, output.suffix.lower()
    dtype: np.dtype[np.generic] = kind
    if suffix in (".jpg", ".jpeg"):
        dtype = np.dtype(np.uint8)
    elif kind.kind == "f":
        dtype = np.dtype(np.float32 if suffix in (".tif", ".tiff") else np.uint16)
    # Values of the same kind keep their encoding; others get the encoding that readers assume for them.
    return dtype, photograph.encoding if (dtype.kind == "f") == (kind.kind == "f") else "srgb"


@dataclass(frozen=True, kw_only=True)
class PairCamera(Sensor):
    """Lens settings and camera of images that differ in focus or aperture.

    Parameters
    ----------
    foci
        Focus distance from the lens, not from the sensor, such as 1.35m: once for all images, or repeated for each;
        overrides the lens file.
    f_numbers
        F-number: once for all images, or repeated for each; overrides the lens file.
    """

    foci: Annotated[tuple[float, ...], Shown(("--focus",), length="m")] = ()
    f_numbers: Annotated[tuple[float, ...], Shown(("--f-number",))] = ()


def each_lens(instrument: Instrument, count: int, stated: PairCamera, images: str = "photos") -> list[Lens]:
    """Return the lens of each photo, by the calibration of the lens file where options do not state it."""
    lens, calibration = instrument.lens, instrument.calibration
    foci, f_numbers = stated.foci, stated.f_numbers
    if calibration is not None:
        foci, f_numbers = foci or calibration.focus_distances, f_numbers or calibration.f_numbers
    for name, numbers in (("--focus", foci), ("--f-number", f_numbers)):
        if len(numbers) not in (0, 1, count):
            raise ValueError(f"{name} must be given once, or for each of {count} {images}, got {len(numbers)}")
    lenses = [lens.stopped(stop) for stop in f_numbers] or [lens]
    lenses *= count // len(lenses)
    if foci:
        lenses = [copy.focused(focus) for copy, focus in zip(lenses, foci * (count // len(foci)), strict=True)]
    scale = 1.0 if calibration is None else calibration.f_number_scale
    return [replace(copy, aperture_diameter=copy.aperture_diameter / scale) for copy in lenses]


def with_calibration(options: imaging.DefocusOptions, instrument: Instrument) -> imaging.DefocusOptions:
    """Return the options, with errors of the calibration of the lens file where flags do not state them."""
    errors: dict[str, Any] = {} if instrument.calibration is None else instrument.calibration.errors
    return replace(options, **{name: error for name, error in errors.items() if name not in given_flags()})


def lens_facts(lenses: list[Lens]) -> Facts:
    """Return focus distances and f-numbers of several frames."""
    return {
        "focus_distances": [finite(lens.focus_distance) for lens in lenses],
        "f_numbers": [lens.f_number for lens in lenses],
        "focal_length": lenses[0].focal_length,
    }


def verdict_report(verdict: DefocusVerdict) -> Report:
    """Return the report of the test of lenses and noise, and of the parts that could not be tested."""
    untested_finding = verdict.findings.get("untested")
    facts = verdict.to_dict()
    del facts["misfit"]  # commands report their own misfit
    facts |= {"agrees": verdict.agrees, "untested": untested_finding and untested_finding.numbers["what"]}
    lines = [] if math.isnan(verdict.misfit) else [verdict.summary]
    lines += [finding.text for finding in verdict.findings.printed]
    return Report(facts, [*map(with_options, lines)], verdict.converged)


@command
@filled(photos=suffixes("photo"))
def align(
    photos: list[Path],
    /,
    *,
    outputs: Annotated[tuple[Path, ...], OUTPUT],
    encoding: Annotated[Encoding | None, ENCODING] = None,
) -> Report:
    """Align photos of one scene: hand-held ones, bursts, or those of two foci, whose sizes differ (focus breathing).

    PHOTOS are two or more files of one size. The others are shifted, turned and scaled to the place of the first, and
    all are cropped to what they share. They are refused where the displacement is uncertain by over 0.25 pixels. The
    exit code is 4 where parts of a photo moved otherwise than all of it.

    Parameters
    ----------
    outputs
        Aligned photos, one for each of PHOTOS, encoded as these: {photos}.
    encoding
        Encoding of the photos' values: srgb, linear, or a number, as 1.8 for light = value ** 1.8; by default as the
        photos state (ICC profile), else integers are sRGB; floats are linear.

    Examples
    --------
      lommel align shot-1.tif shot-2.tif -o aligned-1.tif -o aligned-2.tif
    """
    if len(outputs) != len(photos):
        raise ValueError(f"--output must be given for each of the {len(photos)} photos, got {len(outputs)}")
    for path in outputs:
        photo_files.find(path, "--output")
    with progress("reading") as status:
        pictures = read_alike(photos, encoding)
        status("comparing the photos")
        aligned = imaging.align([picture.light() for picture in pictures])
        for path, picture, light in zip(outputs, pictures, aligned.frames, strict=True):
            dtype, stored_as = output_type(picture, path)
            imaging.write_photo(path, light, encoding=stored_as, dtype=dtype, like=picture)
    return told(aligned.to_dict() | {"read": _read_as(pictures[0])}) + written(outputs)


@command
@filled(depths=suffixes("depth map"), photos=suffixes("photo"))
def depth(
    photos: list[Path],
    lens: Path,
    /,
    *,
    between: Annotated[tuple[float, float], BETWEEN],
    outputs: Annotated[tuple[Path, ...], OUTPUT] = (),
    sharp: Annotated[Path | None, Shown(metavar="FILE", writes=True)] = None,
    figure: Annotated[Path | None, PLOT] = None,
    encoding: Annotated[Encoding | None, ENCODING] = None,
    cameras: PairCamera = PairCamera(),
    options: imaging.DefocusOptions = imaging.DefocusOptions(),
    photo_noise: MaskedPhotoNoise = MaskedPhotoNoise(),
) -> Report:
    """Estimate a depth map from photos (depth from defocus).

    PHOTOS are two or more PNG, JPEG or TIFF files of one size, taken from the same place with different focus or
    aperture, neither denoised nor sharpened. LENS is a lens file. Areas without texture have no depth: NaN, with an
    infinite standard error.

    Parameters
    ----------
    between
        Nearest and farthest distance to search, such as 1m 3m or 1m inf.
    outputs
        Depth map in metres; given a second time, its standard error: {depths}.
    sharp
        All-in-focus image, encoded as PHOTOS: {photos}.
    figure
        Figure of depth map, standard error and all-in-focus image: .png, .pdf or .svg.
    encoding
        Encoding of the photos' values: srgb, linear, or a number, as 1.8 for light = value ** 1.8; by default as the
        photos state (ICC profile), else integers are sRGB; floats are linear.
    white
        Number of electrons at white, such as 5000; by default the full well of the camera. Without --white, --read
        and a camera that states them, the noise is estimated from the photos.
    mask
        Image that is not 0 at pixels to ignore; one for all photos, or one for each.

    Examples
    --------
      lommel depth near.tif far.tif phone.toml --focus 1.3m --focus 2m --between 1m 3m --white 5000 --read 3 -o d.tif
    """
    if len(outputs) > 2:
        raise ValueError(f"--output takes the depth map and its standard error, got {len(outputs)} files")
    for path in outputs:
        photo_files.find_depth(path, "--output")
    if sharp is not None:
        photo_files.find(sharp, "--sharp")
    instrument = radial_instrument(lens, camera=cameras.camera, pixel=cameras.pixel)
    stated, camera = vars(photo_noise), instrument.camera
    noise = noise_of(stated, camera, photographs=True) if states_noise(stated, camera) else None
    lenses = each_lens(instrument, len(photos), cameras)
    with progress("reading") as status:
        pictures = read_alike(photos, encoding)
        for path, picture, used in zip(photos, pictures, lenses, strict=True):
            tell_optics(path.name, picture.exif, instrument.side, used)
        images = apply_mask([picture.values for picture in pictures], photo_noise.mask)
        status("computing the PSFs of every distance")
        start = time.perf_counter()
        estimate = imaging.depth_from_defocus(
            images,
            lenses,
            instrument.side,
            encoding=pictures[0].encoding,
            noise=noise,
            between=between,
            progress=lambda finished, tiles: status(f"tile {finished} of {tiles}", finished / tiles),
            options=with_calibration(options, instrument),
        )
        status("comparing the blur with the blur of other apertures")
        estimate.verdict  # noqa: B018 (computed here, and kept)
        seconds = time.perf_counter() - start
        for path, values in zip(outputs, (estimate.depth, estimate.errors), strict=False):
            imaging.write_depth(path, values)
        if sharp is not None:
            image = to_light("sharp", estimate.sharp, estimate.encoding, np.float32)
            dtype, stored_as = output_type(pictures[0], sharp)
            imaging.write_photo(sharp, image, encoding=stored_as, dtype=dtype)
        save_figure(estimate.plot, figure)
    facts = estimate.to_dict() | lens_facts(lenses) | {"seconds": seconds, "pixel": instrument.side}
    facts["read"] = _read_as(pictures[0]) + _white_of([picture.values for picture in pictures])
    return told(facts) + verdict_report(estimate.verdict) + written([*outputs, sharp, figure])


@command
def precision(
    lens: Path,
    /,
    *,
    foci: Annotated[tuple[float, ...], Shown(("--focus",), length="m")],
    photons: Annotated[float, In(above=0.0)],
    pair: float | None = None,
    best: bool = False,
    f_number: float | None = None,
    place: Annotated[tuple[float, float] | None, PLACE] = None,
    between: Annotated[tuple[float, float] | None, BETWEEN] = None,
    read: float | None = None,
    figure: Annotated[Path | None, PLOT] = None,
    sensor: Sensor = Sensor(),
) -> Report:
    """Compute the achievable depth precision (Cramer-Rao bound).

    The bound is the least standard error of the distance of a textured surface, estimated from photos with
    different focus. It assumes a random texture with the power spectrum of natural scenes, and holds for every
    unbiased estimator without knowledge of the texture; strong edges allow better precision. Use it to choose
    aperture, focus distances and exposure before taking the photos.

    Parameters
    ----------
    foci
        Focus distance, such as 1.5m; repeat for each photo (two or more), or give once with --pair or --best.
    photons
        Mean signal per pixel, in detected photons (electrons).
    pair
        Two photos, one focused this many dioptres (1/m) nearer than --focus, the other that many farther.
    best
        Find the two focus distances that give the best precision for a surface at --focus.
    f_number
        F-number; overrides the lens file.
    place
        Place on the sensor, from its middle right and down (in FITS pictures up), such as 1.5mm -2mm; needs a section
        [field]. By default the axis.
    between
        Nearest and farthest distance to list; by default around the focus distances.
    read
        Read noise, rms electrons; by default from the camera, or 3.
    figure
        Figure of the standard error against the distance: .png, .pdf or .svg.

    Examples
    --------
      lommel precision phone.toml --focus 1.5m --pair 0.1 --photons 1e4 --plot precision.png
      lommel precision nifty-fifty.toml --focus 1.5m --best --f-number 4 --photons 5000
      lommel precision phone.toml --focus 1.35m --focus 1.8m --photons 1e4 --between 1.2m 2.5m
    """
    from lommel.report.optics import describe_place  # slow, and other commands do not need it

    if (pair is not None) + best + (len(foci) > 1) != 1:
        raise ValueError("give --focus twice or more, or --focus once with --pair or with --best")
    instrument = instrument_of(lens, place=place, **vars(sensor))
    if read is None:
        read = _READ if instrument.camera is None or instrument.camera.read is None else instrument.camera.read
    lens_in_use = instrument.lens_at_place
    if f_number is not None:
        lens_in_use = lens_in_use.stopped(f_number)
    noise = Noise(white=photons, read=read)
    start = time.perf_counter()
    if best:
        lenses = list(best_depth_foci(lens_in_use, foci[0], instrument.side, noise=noise))
    elif pair is not None:
        lenses = _lens_pair(lens_in_use, foci[0], pair)
    else:
        lenses = [lens_in_use.focused(focus) for focus in foci]
    nearest, *_, farthest = sorted(photo.focus_distance for photo in lenses)
    # The default range is from a little nearer than the nearest focus to a little farther than the farthest.
    near, far = between or (0.85 * nearest, 1.2 * farthest if math.isfinite(farthest) else 4.0 * nearest)
    if not 0.0 < near < far:
        raise ValueError(f"--between must be the nearest and the farthest distance, got {near:g} m and {far:g} m")
    distance = np.geomspace(near, far, _ROWS if figure is None else _POINTS)
    errors = np.asarray(depth_precision(lenses, distance, instrument.side, noise=noise))
    seconds = time.perf_counter() - start
    if figure is not None:
        title = f"{instrument.name}\nf/{lens_in_use.f_number:.3g}, {photons:g} electrons a pixel"
        axes = estimates.precision(distance, {"": errors}, title, [photo.focus_distance for photo in lenses])
        save_figure(lambda: axes, figure)
    facts = {
        "focus_distances": [finite(photo.focus_distance) for photo in lenses],
        "f_number": lens_in_use.f_number,
        "distance": distance.tolist(),
        "errors": plain(errors),
        "seconds": seconds,
    }
    rows = [
        {"distance": float(distance[k]), "standard_error": float(errors[k])}
        for k in np.linspace(0, len(distance) - 1, _ROWS).round().astype(int)
    ]
    setting = {name: facts[name] for name in ("focus_distances", "f_number", "seconds")} | {"pixel": instrument.side}
    setting |= {"electrons": photons, "contrast": CONTRAST, "window_rms": WINDOW}
    report = Report(facts, [*described(setting), "", records_of("", rows)]) + describe_place(instrument)
    return report + written([figure])


def _lens_pair(lens: Lens, focus: float, dioptres: float) -> list[Lens]:
    """Return two lenses, one focused `dioptres` nearer and one focused `dioptres` farther than a distance."""
    vergence = [1.0 / focus + sign * dioptres for sign in (1.0, -1.0)]
    if not dioptres > 0.0 or vergence[1] < 0.0:
        raise ValueError(
            f"--pair must be > 0 and at most {1.0 / focus:.4g} dioptres (focus at infinity), got {dioptres:g}"
        )
    return [lens.focused(1.0 / v if v > 0.0 else math.inf) for v in vergence]
