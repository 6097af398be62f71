"""Data sets of blurred photographs with ground truth: random lenses, sensor noise, worker processes, resumption."""

from __future__ import annotations

import errno
import json
import math
import multiprocessing
import os
import signal
import threading
from collections.abc import Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from contextlib import ExitStack, closing, suppress
from dataclasses import asdict, dataclass, field, replace
from functools import cache, partial
from os import PathLike
from pathlib import Path
from typing import Annotated, Any, Literal, NamedTuple

import numpy as np

from lommel.base import atomic, encoding, executors, reading, validation
from lommel.base.arrays import Array, Json, Values
from lommel.base.atomic import plain, size_and_checksum_of_bytes, size_and_checksum_of_file
from lommel.base.executors import Workers
from lommel.base.options import HIDDEN, In, Options, listed
from lommel.imaging.blur import DepthBlur
from lommel.imaging.occlusion import Occlusion
from lommel.imaging.settings import channel_spectra, spectra
from lommel.io.depth_maps import DepthMapOptions, fill_missing, read_depth
from lommel.io.photos import PhotoError, Photograph, png_of_16_bits, read_photo
from lommel.optics.lens import Lens
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.recorded.noise import Noise

_RECORD = "dataset.json"  # file with the arguments of a data set
_FORMAT = 4  # version of the format of a data set
_PSFS = 32  # number of PSFs that are stored with a picture

Range = float | tuple[float, float]
PathOf = str | PathLike[str]


@dataclass(frozen=True, kw_only=True)
class LensRanges:
    """Ranges of random lenses: each parameter is a number, or a pair (smallest value, largest value).

    Parameters
    ----------
    focal_length : float or (float, float)
        Focal length, metres; drawn uniformly.
    f_number : float or (float, float)
        F-number; its logarithm (stops) is drawn uniformly.
    focus_distance : float or (float, float)
        Object distance in focus, metres, also infinite; the inverse of the distance (dioptres) is drawn uniformly.
    pixel : float or (float, float)
        Pixel pitch, metres; drawn uniformly.
    spherical : float or (float, float), default 0
        Primary spherical aberration C_s, radians at the pupil edge (the coefficient of rho^4); drawn uniformly.
    wavelength : float, default 540e-9
        Wavelength of C_s and of grey photos, metres.

    Raises
    ------
    TypeError, ValueError
        If a value is not a number in its valid range, or the first value of a pair exceeds the second.

    Examples
    --------
    >>> lenses = lm.imaging.LensRanges(
    ...     focal_length=(24e-3, 85e-3), f_number=(1.4, 8.0), focus_distance=(0.5, np.inf), pixel=4e-6
    ... )
    >>> lens, pixel = lenses.draw(np.random.default_rng(0))
    >>> 24e-3 <= lens.focal_length <= 85e-3, pixel
    (True, 4e-06)
    """

    focal_length: Range
    f_number: Range
    focus_distance: Range
    pixel: Range
    spherical: Range = 0.0
    wavelength: float = 540e-9

    def __post_init__(self) -> None:
        for name in ("focal_length", "f_number", "focus_distance", "pixel", "spherical"):
            vars(self)[name] = _range(name, getattr(self, name))
        vars(self)["wavelength"] = validation.wavelength(self.wavelength)
        longest, nearest = _ends(self.focal_length)[1], _ends(self.focus_distance)[0]
        if not nearest > longest:
            raise ValueError(f"focus_distance must exceed the focal length, {longest:g} m, got {nearest:g}")

    def draw(self, random: np.random.Generator) -> tuple[Lens, float]:
        """Return a random lens and pixel pitch in metres, from five numbers of `random`."""
        # Five numbers are drawn for any ranges: making one parameter constant does not change the other parameters.
        length, stops, dioptres, pitch, spherical = random.random(5)
        (nearest, farthest), (least, most) = _ends(self.focus_distance), _ends(self.f_number)
        # Uniform in 1 / distance, because blur is linear in 1 / distance.
        inverse = _interpolate((1.0 / nearest, 1.0 / farthest), dioptres)
        lens = Lens(
            focal_length=_interpolate(self.focal_length, length),
            # Uniform in the logarithm: as many lenses between f/2 and f/2.8 as between f/4 and f/5.6.
            f_number=math.exp(_interpolate((math.log(least), math.log(most)), stops)),
            focus_distance=1.0 / inverse if inverse > 0.0 else math.inf,
            wavelength=self.wavelength,
            aberrations=Wavefront(spherical=_interpolate(self.spherical, spherical)),
        )
        return lens, _interpolate(self.pixel, pitch)


def _range(name: str, value: object) -> Range:
    """Return `value` as a number or a pair (smallest, largest); TypeError or ValueError unless it is in range."""
    values = value if isinstance(value, tuple | list) else (value,)
    if len(values) not in (1, 2):
        raise TypeError(f"{name} must be a number or a pair (smallest, largest), got {validation.shown(value)}")
    above, infinite = -math.inf if name == "spherical" else 0.0, name == "focus_distance"
    ends = tuple(validation.real(name, number, above=above, infinite=infinite) for number in values)
    if ends[0] > ends[-1]:
        raise ValueError(f"{name} must be a pair (smallest, largest), got {validation.shown(value)}")
    return ends[0] if len(ends) == 1 else (ends[0], ends[1])


def _ends(value: Range) -> tuple[float, float]:
    return value if isinstance(value, tuple) else (value, value)


def _interpolate(value: Range, fraction: float) -> float:
    first, last = _ends(value)
    return float(first + (last - first) * fraction)


@dataclass(frozen=True)
class DatasetPicture:
    """One picture of a data set, written or skipped by :func:`lommel.imaging.render_dataset`.

    Attributes
    ----------
    number : int
        Number of the picture, from 0; its photo is ``number // copies``.
    done, total : int
        Number of complete pictures, and number of all pictures of the data set.
    files : tuple of path
        The files of the picture; empty for a skipped picture.
    facts : dict
        Content of ``NUMBER.json``: names of the photo and the depth map, lens (metres, radians), noise, errors of the
        PSFs. For a skipped picture, the names of the photo and the depth map only.
    failure : str or None
        Reason why the picture was skipped (with ``on_error="skip"``); None for a complete picture.
    """

    number: int
    done: int
    total: int
    files: tuple[Path, ...]
    facts: Json = field(repr=False)
    failure: str | None = None


def pair_files(photos: PathOf | Sequence[PathOf], depths: PathOf | Sequence[PathOf]) -> list[tuple[Path, Path]]:
    """Return pairs of photo and depth map: sequences are paired in order, files of two folders by name.

    Names are compared without suffix. Raise FileNotFoundError if a folder is missing, ValueError if a file has no
    partner, or two files have the same name.
    """
    listed = []
    for name, source in (("photos", photos), ("depths", depths)):
        if isinstance(source, str | PathLike):
            folder = validation.path(name, source)
            if not folder.exists():
                raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), str(folder))
            if not folder.is_dir():
                raise ValueError(f"{name} must be a folder or a list of files, got {validation.shown(str(folder))}")
            by_name: dict[str, Path] = {}
            for file in sorted(folder.iterdir()):
                if file.name.startswith(".") or not file.is_file():
                    continue
                if file.stem in by_name:
                    raise ValueError(
                        f"{name} must have names of their own, got {validation.line(file)} and "
                        f"{by_name[file.stem].name}; rename one"
                    )
                by_name[file.stem] = file
            if not by_name:
                raise ValueError(f"{name} must have files, got the empty folder {validation.shown(str(folder))}")
            listed.append(by_name)
        elif isinstance(source, Mapping | set) or not isinstance(source, Iterable) or getattr(source, "ndim", 1) == 0:
            raise TypeError(f"{name} must be a folder or a list of files, got {validation.shown(source)}")
        else:
            listed.append({str(k): validation.path(name, file) for k, file in enumerate(source)})
    photo_of, depth_of = listed
    for files, partners, partner_kind in ((photo_of, depth_of, "depth map"), (depth_of, photo_of, "photo")):
        if missing := [file for key, file in files.items() if key not in partners]:
            others = f"; nor have {len(missing) - 1} other files" if len(missing) > 1 else ""
            raise ValueError(
                f"photos and depths must be pairs: {validation.line(missing[0])} has no {partner_kind} of the same "
                f"name{others}"
            )
    return [(photo_of[key], depth_of[key]) for key in photo_of]


def _with_white(_: str, noise: Noise) -> Noise:
    validation.instance("noise", noise, Noise)
    if noise.white is None:
        raise ValueError("noise must have a white: the number of electrons at the value 1.0, such as 5000")
    return noise


def _depth_options(name: str, value: DepthMapOptions) -> DepthMapOptions:
    validation.instance(name, value, DepthMapOptions)
    return value


@dataclass(frozen=True, kw_only=True)
class DatasetOptions(Options):
    """Options of data sets.

    Parameters
    ----------
    copies : int, default 1
        Number of pictures of each photo, each with another random lens.
    noise : Noise, optional
        Photon and read noise of the blurred image; ``noise.white`` is the number of electrons at the value 1.0.
    depth_options : DepthMapOptions, optional
        Conversion of depth maps to metres, and treatment of unknown depth; see :func:`lommel.imaging.read_depth`.
    on_error : {"raise", "skip"}, default "raise"
        Handling of a photo or depth map that cannot be used: raise an error, or yield the picture with the reason as
        `failure` and continue. The next call tries a skipped picture again.
    workers : int, default 1
        Number of processes, among which the processors are divided; 1 renders in this process. More processes are
        spawned: a script must then call this function below ``if __name__ == "__main__":``.
    client : distributed.Client or concurrent.futures.Executor, optional
        Executor that renders the pictures, in place of `workers`. Its workers must reach photos, depth maps and `out`
        under the same paths. Each picture is rendered by one thread, to the same bits wherever it is rendered.
    """

    copies: Annotated[int, In(least=1, most=1_000_000)] = 1
    noise: Annotated[Noise | None, _with_white, HIDDEN] = None
    depth_options: Annotated[DepthMapOptions | None, _depth_options, HIDDEN] = None
    on_error: Annotated[Literal["raise", "skip"], HIDDEN] = "raise"
    workers: Annotated[int, In(least=1, most=1024)] = 1
    client: Annotated[Any, HIDDEN] = None


class _Job(NamedTuple):
    """What all pictures of a data set have in common."""

    lenses: LensRanges
    seed: int
    o: DatasetOptions
    threads: int | None = None

    def record(self, pairs: Sequence[tuple[Path, Path]]) -> Json:
        """Return the arguments that determine the pictures, in JSON types."""
        noise = self.o.noise
        return plain({
            "format": _FORMAT,
            "seed": self.seed,
            "copies": self.o.copies,
            "lenses": asdict(self.lenses),
            "noise": None if noise is None else noise.to_dict(),
            "depth_options": asdict(self.o.depth_options or DepthMapOptions()),
            "pairs": [[photo.name, depth.name] for photo, depth in pairs],
        })  # fmt: skip


@listed(DatasetOptions)
def render_dataset(
    photos: PathOf | Sequence[PathOf],
    depths: PathOf | Sequence[PathOf],
    out: PathOf,
    lenses: LensRanges,
    *,
    seed: int,
    options: DatasetOptions | None = None,
    **given: Any,
) -> Iterator[DatasetPicture]:
    """Render photos with depth maps through random lenses into a folder, with ground truth; yield each picture.

    Complete pictures are not rendered again: after an interruption, repeat the call to continue. The random lens and
    noise of a picture depend on `seed` and the picture's number only. The number of `workers` changes the results by
    rounding in the last bit only. All files of a picture appear in the folder together, when they are complete.

    For picture 12 the folder contains ``000012.image.png`` (blurred, with noise), ``000012.sharp.png``,
    ``000012.depth.npy`` (metres, float32) and ``000012.json`` (lens, noise, names of the files). ``000012.psfs.npz``
    contains PSFs: arrays `defocus` (n,), the defocus coefficients C_d in radians, and `psfs`, float32 (n, channels,
    side, side), each of unit sum. ``000012.index.png`` (16 bit) contains for each pixel the index of the nearest C_d:
    the scene pixel (y, x) is blurred by approximately ``psfs[index[y, x]]``. In the JSON file, `psfs_error` is an
    estimate of the error of this PSF relative to its peak: half of the largest difference between adjacent PSFs.
    `error` is the error of the interpolated PSFs that blur the image. WebDataset groups files by the first part of
    their names.

    Parameters
    ----------
    photos, depths : path or sequence of path
        Folders whose files have the same names except for the suffixes, or files in the same order. Photos are read
        by :func:`lommel.imaging.read_photo`, depth maps of equal size by :func:`lommel.imaging.read_depth`.
    out : path
        Output folder, created if it does not exist.
    lenses : LensRanges
        Ranges from which the lens and the pixel pitch of each picture are drawn.
    seed : int
        Random seed of the lenses and of the noise.
    options : DatasetOptions, optional
        Options as an object, which keywords change.
    {options}

    Yields
    ------
    DatasetPicture
        The pictures, in the order of completion.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, a file has no partner, or the data set in `out` is damaged, locked by another
        call, or made from other arguments or files. With ``on_error="raise"``, during the iteration, if a photo or
        depth map cannot be used or the blur is too large; complete pictures are kept.
    OSError
        If a folder of photos or depth maps is missing, or a file cannot be written or, with ``on_error="raise"``,
        cannot be read.
    RuntimeError
        If the client cancels pictures, as when the scheduler of its cluster ends. The same call, with a new client,
        continues.

    Notes
    -----
    After Ctrl-C, or if the iterator is closed, each worker finishes its current picture; complete pictures are kept.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> room = pathlib.Path(tempfile.mkdtemp())
    >>> _ = lm.imaging.write_photo(room / "a.png", np.random.default_rng(0).random((24, 32, 3)))
    >>> lm.imaging.write_depth(room / "a.npy", np.full((24, 32), 1.5))
    >>> lenses = lm.imaging.LensRanges(focal_length=50e-3, f_number=(2.0, 8.0), focus_distance=1.2, pixel=20e-6)
    >>> made = lm.imaging.render_dataset([room / "a.png"], [room / "a.npy"], room / "set", lenses, seed=1, copies=2)
    >>> [picture.number for picture in made]
    [0, 1]
    """
    o = DatasetOptions.of("render_dataset", options, given)
    validation.instance("lenses", lenses, LensRanges)
    job = _Job(lenses, validation.integer("seed", seed, least=0, most=2**63 - 1), o)
    pairs = pair_files(photos, depths)
    folder = validation.path("out", out)
    _create_folder(folder, job.record(pairs))
    return _render_missing(folder, job, pairs)


def _create_folder(folder: Path, record: Json) -> None:
    """Create the folder of a data set with the file of arguments; ValueError if the folder has other arguments."""
    file = folder / _RECORD
    if not file.exists():
        if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
            raise ValueError(f"{validation.line(folder)} must be a new or empty folder, or an incomplete data set")
        folder.mkdir(parents=True, exist_ok=True)
        # FileExistsError: another call created the same data set at the same time.
        with suppress(FileExistsError), atomic.temporary_for(file, exclusive=True) as place:
            place.write_text(json.dumps(record, indent=1), encoding="utf-8")
    if not isinstance(existing := _read(file), dict):
        raise ValueError(
            f"{validation.line(file)} is damaged; remove {validation.line(folder)}, or choose another folder"
        )
    # A data set must not mix pictures of different arguments.
    if existing != record:
        names = [name for name in record if existing.get(name) != record[name]]
        raise ValueError(
            f"{validation.line(folder)} holds pictures of other arguments ({', '.join(names)}); choose another folder"
        )


def _read(file: Path) -> Any:
    """Return the content of a JSON file; None if it is missing or damaged."""
    try:
        return reading.json(reading.contents(file))
    except (FileNotFoundError, ValueError):
        return None


def _complete_pictures(folder: Path, total: int) -> Iterator[tuple[int, Json]]:
    """Yield the numbers and facts of the complete pictures: all their files exist with unchanged checksums."""
    for number in range(total):
        facts = _read(folder / f"{number:06d}.json")
        with suppress(FileNotFoundError):
            if isinstance(facts, dict) and all(
                size_and_checksum_of_file(folder / f"{number:06d}.{name}") == checksum
                for name, checksum in facts.get("files", {"": ""}).items()
            ):
                yield number, facts


def _render_missing(folder: Path, job: _Job, pairs: list[tuple[Path, Path]]) -> Iterator[DatasetPicture]:
    """Render the missing pictures, and yield each picture after its files are written."""
    copies, workers, client = job.o.copies, job.o.workers, job.o.client
    with ExitStack() as stack:
        # Without the lock, two processes in one folder would render the same pictures.
        stack.enter_context(atomic.locked(folder / _RECORD, folder))
        scratch = stack.enter_context(atomic.scratch_folder(folder))
        total = len(pairs) * copies
        # Several pictures may have the same photo: its checksum is computed once.
        complete, checksum_of = set(), cache(size_and_checksum_of_file)
        for number, facts in _complete_pictures(folder, total):
            for file, checksum in zip(pairs[number // copies], facts["checksums"], strict=True):
                if checksum_of(file) != checksum:
                    raise ValueError(
                        f"{validation.line(folder)} holds pictures of another {validation.line(file.name)} "
                        f"({checksum}, now {checksum_of(file)}); choose another folder"
                    )
            complete.add(number)
        missing = [number for number in range(total) if number not in complete]
        done, tasks = len(complete), ((number, *pairs[number // copies]) for number in missing)
        if client is None and workers == 1:
            results: Iterator[Any] = ((task, _write(job, folder, scratch, *task)) for task in tasks)
        else:
            if client is not None:
                found, job = Workers.of(client), job._replace(threads=1)
                tasks = ((number, photo.absolute(), depth.absolute()) for number, photo, depth in tasks)
            else:
                # Processes are spawned, not forked: a fork would copy locks that other threads hold.
                spawn = multiprocessing.get_context("spawn")
                count = min(workers, max(len(missing), 1))
                pool = stack.enter_context(ProcessPoolExecutor(count, spawn, initializer=_set_up_worker))
                # The processors are divided among the processes. With two tasks per worker, no worker waits.
                found = Workers(pool, 2 * workers - 1)
                job = job._replace(threads=max(1, (os.cpu_count() or 1) // workers))
            job = job._replace(o=replace(job.o, client=None))
            render = partial(_write, job, folder.absolute(), scratch.absolute())
            results = stack.enter_context(closing(found.run(render, tasks)))
        try:
            for (number, *_), (files, facts, failure, notes) in results:
                for note in notes:
                    validation.tell(note)
                done += failure is None
                yield DatasetPicture(number, done, total, tuple(folder / name for name in files), facts, failure)
        except _ScratchError:
            if client is not None and scratch.is_dir():
                raise ValueError(executors.unseen(folder)) from None
            raise
        except FileNotFoundError as error:
            if client is not None and error.filename and Path(error.filename).exists():
                raise ValueError(executors.unseen(Path(error.filename).parent)) from None
            raise


_Output = tuple[list[str], Json, str | None, list[str]]  # names of the files, facts, reason of a failure, warnings


class _ScratchError(ValueError):
    """Error for a folder that was removed or replaced while pictures were rendered."""


def _set_up_worker() -> None:
    """Set up this worker process: ignore Ctrl-C, which the parent handles, and exit when the parent exits."""
    from multiprocessing import connection, parent_process

    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = parent_process()
    if parent is not None:

        def exit_with_parent() -> None:
            connection.wait([parent.sentinel])
            # Skip the clean-up, which requires the parent.
            os._exit(1)

        threading.Thread(target=exit_with_parent, daemon=True).start()


def _write(job: _Job, folder: Path, scratch: Path, number: int, photo: Path, depth: Path) -> _Output:
    """Render a picture and write its files; return file names, facts, failure and warnings (see `_Output`)."""
    notes: list[str] = []
    try:
        # Notes are issued by the calling process: those of a worker would be lost.
        with validation.collected(notes, f"{validation.line(photo)}: "):
            files, facts = _render(job, number, photo, depth)
    except (ValueError, OSError) as error:
        names_file = isinstance(error, PhotoError | OSError) or str(depth) in str(error)
        if job.o.on_error == "skip":
            reason = str(error) if names_file else f"{validation.line(photo)}: {error}"
            if isinstance(error, OSError) and error.filename:
                reason = f"{validation.line(error.filename)}: {error.strerror}"
            return [], {"photo": photo.name, "depth": depth.name}, reason, notes
        if names_file:
            raise
        raise ValueError(f"{validation.line(photo)}: {error}") from None
    try:
        with atomic.whole_files(scratch) as write:
            for name, data in files.items():
                write(folder / f"{number:06d}.{name}", data)
    except (FileNotFoundError, NotADirectoryError):
        raise _ScratchError(
            f"{validation.line(folder)} was removed or replaced while its pictures were rendered; repeat the call"
        ) from None
    return [f"{number:06d}.{name}" for name in files], facts, None, notes


def _render(job: _Job, number: int, photo: Path, depth: Path) -> tuple[dict[str, bytes], Json]:
    """Render a picture; return the contents of its files by name (the JSON file last), and the facts."""
    random = np.random.default_rng([job.seed, number])
    lens, pixel = job.lenses.draw(random)
    checksums = [size_and_checksum_of_file(photo), size_and_checksum_of_file(depth)]
    picture = read_photo(photo)
    light, o = picture.light(), job.o.depth_options or DepthMapOptions()
    metres = read_depth(depth, shape=light.shape, options=replace(o, missing=None))
    known_depths = metres[~np.isnan(metres)]
    ends = [float(end(known_depths)) for end in (np.min, np.max)] if known_depths.size else []
    unknown_fraction = 1.0 - known_depths.size / metres.size
    metres = fill_missing(metres, o.missing)
    channels = channel_spectra(light.shape, lens.wavelength)
    blur = DepthBlur(metres, lens, pixel, channels=channels, threads=job.threads)
    image = Occlusion(blur).forward(light, copies=False)
    if (noise := job.o.noise) is not None:
        electrons = np.multiply(np.maximum(image, 0.0), np.asarray(noise.white), dtype=np.float64)
        image = noise.record(electrons, random).astype(image.dtype)
    defocus, index, psfs = _psfs(blur)
    facts = {
        "photo": photo.name,
        "depth": depth.name,
        "checksums": checksums,
        "seed": [job.seed, number],
        "focal_length": lens.focal_length,
        "f_number": lens.f_number,
        "focus_distance": lens.focus_distance if math.isfinite(lens.focus_distance) else "infinity",
        "sensor_distance": lens.sensor_distance,
        "spherical": float(np.asarray(lens.aberrations.spherical)),
        "pixel": pixel,
        "depth_range": [end if math.isfinite(end) else "infinity" for end in ends],
        "depth_unknown": unknown_fraction,
        "wavelength": lens.wavelength,
        "channels": [[list(line) for line in channel] for channel in spectra("channels", channels)],
        "encoding": encoding.as_json(picture.encoding),
        "noise": None if noise is None else noise.to_dict(),
        "window": 2 * max(bank.half for bank in blur.banks) + 1,
        "lost": float(f"{blur.lost:.4g}"),
        "error": float(f"{blur.error:.2g}"),
        "psfs_error": float(f"{_nearest_psf_error(psfs):.2g}"),
    }
    files = {
        "image.png": _png(image, picture),
        "sharp.png": _png_of_photo(picture, light),
        "depth.npy": atomic.contents(np.save, metres.astype(np.float32)),
        "index.png": png_of_16_bits(index, None, 1),
        "psfs.npz": atomic.contents(np.savez_compressed, defocus=defocus, psfs=psfs),
    }
    # The JSON file is written last: it lists the checksums of the other files.
    facts_with_checksums = facts | {"files": {name: size_and_checksum_of_bytes(data) for name, data in files.items()}}
    files["json"] = json.dumps(facts_with_checksums, indent=1).encode()
    return files, facts


def _psfs(blur: DepthBlur) -> tuple[Array, Values, Values]:
    """Return (1) equally spaced values of C_d, (2) for each pixel the index of the nearest value, (3) the PSFs."""
    low, high = float(blur.defocus.min()), float(blur.defocus.max())
    defocus = np.linspace(low, high, _PSFS)
    step = (high - low) / (_PSFS - 1)
    index = np.rint((blur.defocus - low) / step if step > 0.0 else np.zeros(blur.shape)).astype(np.uint16)
    max_half = max(bank.half for bank in blur.banks)
    table = np.zeros((_PSFS, blur.channels, 2 * max_half + 1, 2 * max_half + 1), dtype=np.float32)
    for channel, bank in enumerate(blur.banks):
        centre = slice(max_half - bank.half, max_half + bank.half + 1)
        for number, radians in enumerate(defocus):
            table[number, channel, centre, centre] = bank.window(float(radians))
    return defocus, index, table


def _nearest_psf_error(psfs: Values) -> float:
    """Return the largest half difference between adjacent PSFs, divided by the lower of the two peaks."""
    peaks = psfs.max(axis=(2, 3))
    differences = np.abs(np.diff(psfs, axis=0)).max(axis=(2, 3))
    return float((0.5 * differences / np.minimum(peaks[1:], peaks[:-1])).max())


def _png_of_photo(picture: Photograph, light: Values) -> bytes:
    """Return the unblurred photo as a 16-bit PNG."""
    stored = picture.values
    if stored.dtype.kind != "u":
        return _png(light, picture)
    # 8-bit values times 257: white, 255, becomes 65535.
    return png_of_16_bits(
        stored.astype(np.uint16) * np.uint16(257 if stored.itemsize == 1 else 1), _profile(picture), 1
    )


def _png(light: Values, picture: Photograph) -> bytes:
    """Return linear light as a 16-bit PNG. Compression level 1: a higher level takes longer than the blur."""
    return png_of_16_bits(encoding.from_light(light, picture.encoding, np.uint16), _profile(picture), 1)


def _profile(picture: Photograph) -> bytes | None:
    """Return the ICC profile of a photo that readers would not take for what it is."""
    return None if picture.encoding == "srgb" or picture.values.dtype.kind == "f" else picture.profile
