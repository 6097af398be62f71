"""The command ``collimate``: coma of a telescope from defocused stars, with its direction in the picture."""

from __future__ import annotations

import cmath
import math
import time
import warnings
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

import numpy as np

from lommel import show
from lommel.base.arrays import Array
from lommel.base.encoding import Encoding, named
from lommel.base.options import In, Options, Shown
from lommel.base.units import camera_wavelength, format_length
from lommel.base.validation import line
from lommel.cli.command import ENCODING, PLOT, command
from lommel.cli.instruments import Sensor
from lommel.cli.interrupts import Stop
from lommel.cli.messages import with_options
from lommel.cli.output import progress, save_figure, written
from lommel.io.photos import optics_of, read_photo
from lommel.optics.lens import Lens
from lommel.report import Facts, Report, Wrapped

if TYPE_CHECKING:
    from lommel.estimation.collimation import Collimation, Vector
    from lommel.recorded.headers import Metadata

_JPEG = {".jpg", ".jpeg"}
_PHOTOS = {*_JPEG, ".png", ".tif", ".tiff"}
_SUFFIXES = {*_PHOTOS, ".fits", ".fit", ".fts", ".npy"}
_NOTES = "missed_light", "left_out", "hot_pixels"  # findings that are shown; the first one leads those of a misfit
_POLL = 0.5  # seconds between looks into a folder
_OBSCURATION = 0.33  # where it is not stated
_UNKNOWN = 0.1  # relative error of coma then: 0.2 instead of 0.35 changes it by 12 %, 0.45 by 4 %


@dataclass(frozen=True, kw_only=True)
class Telescope(Options):
    """Telescope, where no lens file states it.

    Parameters
    ----------
    lens
        Lens file of the telescope, which may state its vanes.
    aperture
        Diameter of the aperture, such as 200mm; by default from the header of the pictures (APTDIA).
    focal_length
        Focal length, with a Barlow lens or a reducer, such as 2m; by default from the header (FOCALLEN).
    obscuration
        Diameter of the secondary mirror over that of the aperture, 0 for refractors; without it spherical aberration
        is not reported.
    wavelength
        Mean wavelength of the filter, or of the camera, such as 550nm.
    """

    heading: ClassVar[str] = "Telescope"
    lens: Annotated[Path | None, Shown(("--telescope",), metavar="FILE")] = None
    aperture: Annotated[float | None, In(above=0.0), Shown(length="mm")] = None
    focal_length: Annotated[float | None, In(above=0.0), Shown(length="m")] = None
    obscuration: Annotated[float | None, In(least=0.0, most=0.9)] = None
    wavelength: Annotated[float, Shown(length="nm"), camera_wavelength] = 550e-9

    def instrument(self, header: Metadata, sensor: Sensor) -> tuple[Lens, float]:
        """Return the lens and the pixel, metres, of a picture with this header; ValueError if one is not stated."""
        stated = {"aperture": self.aperture, "focal_length": self.focal_length}
        pixel = sensor.pixel or (sensor.camera and sensor.camera.pixel)
        if self.lens is not None:
            if self.obscuration is not None or any(stated.values()):
                raise ValueError("--telescope must not be combined with --aperture, --focal-length or --obscuration")
            instrument = sensor.instrument(self.lens, "--telescope")
            return instrument.lens_at_place, float(np.min(instrument.side))
        found: dict[str, Any] = {name: value or header.get(name) for name, value in stated.items()}
        found["pixel"] = pixel or header.get("sensor_pixel")
        examples = {"aperture": "--aperture 200mm", "focal_length": "--focal-length 2m", "pixel": "--pixel 3.8um"}
        if missing := [examples[name] for name, value in found.items() if not isinstance(value, float)]:
            raise ValueError(
                f"the header of the picture does not state all of the telescope: add {' '.join(missing)}"
            )
        obscuration = _OBSCURATION if self.obscuration is None else self.obscuration
        lens = Lens(
            focal_length=found["focal_length"],
            aperture_diameter=found["aperture"],
            obscuration=obscuration,
            wavelength=self.wavelength,
        )
        return lens, found["pixel"]


@command
def collimate(
    images: list[Path],
    /,
    *,
    telescope: Telescope = Telescope(),
    outside: bool = False,
    watch: bool = False,
    encoding: Annotated[Encoding | None, ENCODING] = None,
    figure: Annotated[Path | None, PLOT] = None,
    sensor: Sensor = Sensor(),
) -> Report:
    """Measure coma from defocused stars and say in which direction to collimate.

    IMAGES are pictures of a defocused star ("donut"), 3 to 15 waves out of focus, near the middle of the field: FITS,
    TIFF, PNG, NPY or JPEG files, or folders of them. Values are linear in the light, unless the file states another
    encoding, or is a JPEG (sRGB); of colours the mean is used. The brightest star of each picture is fitted with
    seeing and, if it drifted, its trail. Saturated and hot pixels are left out. Expose for a second or more.

    Coma is stated with the direction in which the tail of the sharp star points, in the picture as it is shown: FITS
    files with the first row at the bottom, unless their header states ROWORDER = TOP-DOWN, other files with the first
    row at the top. The donut is narrow and bright on the opposite side. Both are the same on either side of focus.
    The screws of a secondary mirror (Cassegrain, Schmidt-Cassegrain) must move the star in the direction of the tail,
    those of the primary mirror of a Newtonian against it. Bring the star back to the middle with the mount, and
    repeat. Angles are in degrees counterclockwise from the right. Sizes are in waves rms at the wavelength. A bright
    star tests pixel, aperture, focal length and wavelength together, and a doubt names a wrong one; directions do not
    depend on them. If the model does not fit a picture, errors are unknown; the mean of three or more pictures then
    has the error of their scatter. A doubt on what the model lacks is an error that the mean does not reduce. The
    exit code is 3 for a misfit, and 4 for a result in doubt.

    Parameters
    ----------
    outside
        Pictures were taken outside focus (sensor too far from the telescope); by default inside. Only the sign of
        spherical aberration depends on it.
    watch
        Measure the pictures of one folder, and each new one as it is written, until Ctrl-C. Between turns of the
        screws it prints by how much coma moved, and how often to repeat the turn.
    encoding
        Encoding of the values of PNG, TIFF and JPEG files, if not as stated above: srgb, linear, or a number, as 2.2
        for light = value ** 2.2.
    figure
        Figure of the last picture with the direction of coma: .png, .pdf or .svg.

    Examples
    --------
      lommel collimate donut.fits --aperture 200mm --focal-length 2m --pixel 3.8um --obscuration 0.35
      lommel collimate donut.fits --telescope telescope.toml --plot coma.png
    """
    from lommel.estimation.collimation import measure_collimation

    if watch and (len(images) != 1 or not images[0].is_dir()):
        raise ValueError("--watch needs one folder, into which the camera writes")
    unstated = telescope.lens is None and telescope.obscuration is None
    components: list[complex] = []  # of coma, along columns and upwards in the pictures as shown
    errors: list[float | None] = []  # None of misfits
    steady: list[float] = []  # parts of the errors that pictures share
    records: list[Facts] = []
    picture = np.zeros((1, 1))  # the last one that was measured, as shown
    with Stop().signals() as stop, progress("waiting" if watch else "reading", endless=True) as status:
        paths = _pictures(images, stop, watch=watch)
        while (path := stop.next(paths)) is not None:
            status(f"measuring {path.name}")
            record: Facts = {"picture": path.name, "converged": False}
            try:
                values, header, down = _read(path, encoding)
                lens, pixel = telescope.instrument(header, sensor)
                one = measure_collimation(values, lens, pixel, outside=outside)
                record |= _facts(one, down=down, unstated=unstated, notes=header.get("notes", ()))
            except (ValueError, OSError) as error:
                if len(images) == 1 and not images[0].is_dir():
                    raise
                record["message"] = str(error)
            else:
                picture = values if down else values[::-1]
                star = one.star if down else one.star._replace(row=len(values) - 1 - one.star.row)
                errors.append(one.coma.error if one.fit.converged else None)
                steady.append(one.steady)
                components.append(one.components.conjugate() if down else one.components)
                recent = [e**2 - s**2 for e, s in zip(errors[-2:], steady[-2:], strict=True) if e is not None]
                if watch and len(recent) == 2:
                    record["change"] = _change(components[-2], components[-1], math.sqrt(max(sum(recent), 0.0)))
            records.append(record)
            if watch:
                status.tell(f"{path.name}: {_in_words(record)}")
    if not records:
        raise ValueError("IMAGES must be pictures or folders with some, got none")
    facts: Facts = {"pictures": records, "converged": all(r["converged"] for r in records)}
    facts["reliable"] = all(r.get("reliable", False) for r in records)
    shown = [] if watch else records  # told while they were watched
    parts: list[Any] = [Wrapped(f"{record['picture']}: {_in_words(record)}", "bold") for record in shown]
    if components:
        # Screws may have been turned between the pictures of a session: the last one counts.
        used = slice(-1, None) if watch else slice(None)
        coma = _mean(components[used], errors[used], steady[used])
        facts["coma"] = _vector(coma, down=False, unstated=unstated)
        title = _with_direction("coma", facts["coma"])
        if len(components) > 1:
            name = "last picture" if watch else f"mean of {len(components)}"
            parts.append(Wrapped(f"{name}: {title}", "bold"))
        parts += [Wrapped(text) for text in _advice(facts["coma"])]
        facts["telescope"] = _telescope(lens, pixel)
        lengths = {name: format_length(value) for name, value in facts["telescope"].items()}
        words = ", ".join(f"{name.replace('_', ' ')} {length}" for name, length in lengths.items())
        parts.append(Wrapped(f"Sizes in waves hold for {words}."))
        if unstated:
            parts.append("Neither --obscuration nor --telescope is stated: 0.33 was assumed.")
        save_figure(lambda: show.estimates.collimation(picture, star, coma.angle, title), figure)
    return Report(facts, parts, facts["converged"]) + written([figure] if components else [])


def _pictures(images: list[Path], stop: Stop, *, watch: bool) -> Iterator[Path]:
    """Yield files and those of folders; with `watch` those of the first folder, and new ones once they are whole."""
    if not watch:
        for path in images:
            yield from sorted(filter(_is_picture, path.iterdir())) if path.is_dir() else [path]
        return
    stamps: dict[Path, tuple[int, int]] = {}
    done: dict[Path, tuple[int, int]] = {}  # of files that were measured: one may have been written only in part
    while not stop.requested:
        before, stamps = stamps, {path: stamp for path in images[0].iterdir() if (stamp := _stamp(path))}
        for path in sorted(stamps, key=stamps.__getitem__):  # the newest last
            if stamps[path] == before.get(path) and stamps[path] != done.get(path):
                done[path] = stamps[path]
                yield path
        time.sleep(_POLL)


def _stamp(path: Path) -> tuple[int, int] | None:
    """Return the time of the last change of a picture, ns, and its size; None of other, empty and removed files."""
    with suppress(FileNotFoundError):
        if _is_picture(path) and (state := path.stat()).st_size:
            return state.st_mtime_ns, state.st_size
    return None


def _is_picture(path: Path) -> bool:
    """Return whether a path is a picture, by its suffix."""
    return path.suffix.lower() in _SUFFIXES and not path.name.startswith(".") and path.is_file()


def _read(path: Path, encoding: Encoding | None = None) -> tuple[Array, Metadata, bool]:
    """Return a picture with NaN at saturated pixels, its header, and whether its first row is shown at the top."""
    from lommel.recorded.counts import Counts
    from lommel.recorded.frames import read_images
    from lommel.recorded.headers import is_first_row_on_top
    from lommel.recorded.noise import Noise

    if path.suffix.lower() in _PHOTOS and (found := _light(path, encoding)) is not None:
        return found
    if encoding is not None:
        raise ValueError(f"--encoding is of PNG, TIFF and JPEG files of 8 or 16 bits, got {line(path)}")
    read = read_images([path])
    counts = Counts.of(read[...], noise=Noise(read=0.0))
    if len(counts) != 1:
        raise ValueError(f"{line(path)} must be one picture, got {len(counts)}")
    values = np.where(counts.known, counts.values, np.nan)[0]
    return np.asarray(values, np.float64), read.metadata, is_first_row_on_top(read.metadata)


def _light(path: Path, encoding: Encoding | None) -> tuple[Array, Metadata, bool] | None:
    """Return `_read` of a photograph in colours or of values that are not linear; None for others."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of an encoding that is not the stated one
        try:
            photo = read_photo(path)
        except ValueError:
            return None  # stacks, and types of counts
        is_encoded = photo.stated or path.suffix.lower() in _JPEG
        used = encoding or (photo.encoding if is_encoded else "linear")
        colours, is_float = photo.values.ndim == 3, photo.values.dtype.kind == "f"
        if not colours and (is_float or used == "linear"):
            return None
        light = np.asarray(read_photo(path, used).light(), np.float64)
    light = np.where((light < 1.0) | is_float, light, np.nan)
    notes = [f"values {named(used)}" + ", mean of colours" * colours]
    metadata = optics_of(photo.exif) | {"notes": notes}
    return light.mean(axis=-1) if colours else light, metadata, True


def _telescope(lens: Lens, pixel: float) -> Facts:
    """Return the lengths to which waves are proportional, metres."""
    return {
        "pixel": pixel,
        "aperture": lens.focal_length / lens.f_number,
        "focal_length": lens.focal_length,
        "wavelength": lens.wavelength,
    }


def _mean(components: list[complex], errors: list[float | None], steady: Sequence[float]) -> Vector:
    """Return the mean coma of pictures; with misfits its error is the scatter of three or more, or infinite.

    `steady` are the parts of the errors that the pictures share.
    """
    from lommel.estimation.collimation import Vector, mean_coma

    known = [(value, error) for value, error in zip(components, errors, strict=True) if error is not None]
    if len(known) == len(components):
        return mean_coma([value for value, _ in known], [error for _, error in known], steady)
    if len(components) > 2:
        shared = [part for part, error in zip(steady, errors, strict=True) if error is not None]
        return mean_coma(components, [0.0] * len(components), shared)
    mean = sum(components) / len(components)
    return Vector(abs(mean), math.inf, cmath.phase(mean), math.inf)


def _vector(vector: Vector, *, down: bool, unstated: bool = False, folds: int = 1) -> Facts:
    """Return an aberration as facts, with its angle in the picture as shown."""
    error = math.hypot(vector.error, _UNKNOWN * vector.size * unstated)
    found = {
        "waves": vector.size,
        "error": error if math.isfinite(error) else None,
        "degrees": None,
        "degrees_error": None,
    }
    if vector.angle is not None:
        found["degrees"] = math.degrees(-vector.angle if down else vector.angle) % (360.0 / folds)
        found["degrees_error"] = math.degrees(vector.angle_error) if math.isfinite(error) else None
    return found


def _facts(one: Collimation, *, down: bool, unstated: bool, notes: Sequence[str]) -> Facts:
    """Return the result of a picture as data; of a misfit only coma, without an error."""
    fit = one.fit
    facts: Facts = {name: getattr(fit, name) for name in ("converged", "reliable", "message")}
    notes_of_fit = [f for f in fit.findings if f.code in _NOTES[not fit.converged :] and f.severity == "note"]
    facts["notes"] = [*notes, *("; ".join(f.text.split("; ")[:2]) for f in notes_of_fit)]
    if not fit.converged:
        return facts | {"coma": _vector(_mean([one.components], [None], [0.0]), down=down)}
    drift = one.drift and {
        "pixels": one.drift[0],
        "degrees": math.degrees(-one.drift[1] if down else one.drift[1]) % 180.0,
    }
    return facts | {
        "coma": _vector(one.coma, down=down, unstated=unstated),
        "astigmatism": _vector(one.astigmatism, down=down, unstated=unstated, folds=2),
        "spherical": None if unstated else dict(zip(("waves", "error"), one.spherical, strict=True)),
        "defocus": one.waves,
        "drift": drift,
    }


def _change(before: complex, after: complex, error: float) -> Facts | None:
    """Return by how much coma changed, and how often that change is to be repeated; None if it is not significant."""
    from lommel.estimation.collimation import Vector

    change = Vector.of(after - before, error)
    if change.angle is None:
        return None
    times = -(after * (after - before).conjugate()).real / change.size**2
    left = abs(after + times * (after - before))
    return {"waves": change.size, "degrees": math.degrees(change.angle) % 360.0, "times": times, "left": left}


def _hour(degrees: float) -> int:
    """Return the hour of a clock in the direction of an angle, counterclockwise from the right."""
    return round((90.0 - degrees) / 30.0) % 12 or 12


def _with_direction(name: str, part: Facts) -> str:
    """Return the size of coma or astigmatism and its direction in words."""
    if part["error"] is None:
        return f"{name} about {part['waves']:.2f} waves towards {_hour(part['degrees'])} o'clock, errors unknown"
    text = f"{name} {part['waves']:.3f} +- {part['error']:.3f} waves"
    if part["degrees"] is None:
        return text
    angle = f"{part['degrees']:.0f} +- {part['degrees_error']:.0f} degrees"
    return f"{text} along {angle}" if name != "coma" else f"{text} towards {_hour(part['degrees'])} o'clock ({angle})"


def _in_words(record: Facts) -> str:
    """Return the result of a picture in a line."""
    message = with_options(record["message"])
    notes = record.get("notes", ())
    if not record["converged"]:
        found = f"{_with_direction('coma', record['coma'])}: " if "coma" in record else "not measured: "
        return found + "; ".join([*message.split("; ")[:2], *notes])
    texts = [_with_direction(name, record[name]) for name in ("coma", "astigmatism")]
    if (sphere := record["spherical"]) is not None:
        texts.append(f"spherical {sphere['waves']:+.3f} +- {sphere['error']:.3f} waves")
    texts.append(f"{abs(record['defocus']):.1f} waves {'in' if record['defocus'] > 0.0 else 'out'}side focus")
    if (drift := record["drift"]) is not None:
        texts.append(f"the star drifted by {drift['pixels']:.0f} pixels along {drift['degrees']:.0f} degrees")
    if (change := record.get("change")) is not None:
        moved = f"coma moved by {change['waves']:.3f} waves towards {_hour(change['degrees'])} o'clock"
        if record["coma"]["degrees"] is not None:
            way = "more" if change["times"] > 0.0 else "back"
            moved += f", {abs(change['times']):.2g} times that turn {way} leaves {change['left']:.3f} waves"
        texts.append(moved)
    return "; ".join([*texts, *notes] if record["reliable"] else [*texts, *message.split("; ")[:2], *notes])


def _advice(coma: Facts) -> list[str]:
    """Return what to do against coma."""
    degrees = coma["degrees"]
    if coma["error"] is None:
        return ["The direction may be wrong: take three or more pictures, some on the other side of focus."]
    if degrees is None:
        return ["No direction is certain: more or longer exposures are more accurate."]
    towards, against = (f"{_hour(angle)} o'clock" for angle in (degrees, degrees + 180.0))
    return [
        f"The sharp star has its tail towards {towards}; the defocused star is narrow and bright at {against}.",
        f"Cassegrain, Schmidt-Cassegrain: move the star towards {towards} by the screws of the secondary mirror.",
        f"Newtonian: move the star towards {against} by the screws of the primary mirror.",
        "Bring the star back to the middle with the mount, and repeat. If coma grows, go the other way.",
    ]
