"""Data sets of blurred photographs with ground truth: random lenses, sensor noise, worker processes, resumption."""

from __future__ import annotations

import io
import json
import math
import os
import re
import signal
import tarfile
import threading
import warnings
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from contextlib import suppress
from dataclasses import asdict, dataclass, field, replace
from functools import cache, partial
from os import PathLike
from pathlib import Path
from typing import Any, Unpack

import numpy as np

from lommel.base import atomic, reading, validation
from lommel.base.arrays import Array, Json, Values
from lommel.base.atomic import of_bytes, of_file, plain
from lommel.base.encoding import ENCODINGS, from_light
from lommel.base.optional import library
from lommel.base.options import shares
from lommel.imaging.blur import DepthBlur
from lommel.imaging.occlusion import Occlusion
from lommel.imaging.photograph import fill_missing
from lommel.imaging.settings import Keywords, Settings, spectra
from lommel.io import photos
from lommel.io.depth_maps import DepthValues, read_depth
from lommel.io.photos import PhotoError, Picture, png_of_16_bits, read_photo, write_tiff
from lommel.optics.lens import Lens
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.recorded.noise import Noise

FORMATS = ("png", "tif", "exr", "zarr")
"""Formats of the images: 16-bit PNG in the encoding of the photo, or linear light in float32."""

ON_ERROR = ("raise", "skip")
"""Whether a photo or depth map that cannot be used raises an error or is skipped."""

_CALLED = {"scale": "depth_scale", "inverse": "inverse_depth"}  # names of render_dataset for those of DepthValues
_RECORD = "dataset.json"
_FORMAT = 3
_PARTS = "parts"

Range = float | tuple[float, float]
PathOf = str | PathLike[str]


@dataclass(frozen=True, kw_only=True)
class LensRanges:
    """Lenses drawn at random: each parameter is a number, or a pair of its least and greatest value.

    Parameters
    ----------
    focal_length : float or (float, float)
        Metres; drawn uniformly.
    f_number : float or (float, float)
        Drawn uniformly in stops (its logarithm).
    focus_distance : float or (float, float)
        Object distance in focus, metres, may be infinite; drawn uniformly in dioptres (its inverse).
    pixel : float or (float, float)
        Pixel pitch, metres; drawn uniformly.
    spherical : float or (float, float), default 0
        Primary spherical aberration C_s, radians at the pupil edge (the coefficient of rho^4); drawn uniformly.
    wavelength : float, default 540e-9
        Wavelength at which C_s is stated, metres, and that of grey photos.

    Raises
    ------
    TypeError, ValueError
        If a value is not a number in its range, or a pair does not rise.

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
        """Return a lens and a pixel pitch in metres drawn by `random`, which always gives five numbers."""
        # Five numbers even for constant parameters: those of the other parameters then stay the same.
        length, stops, dioptres, pitch, spherical = random.random(5)
        (nearest, farthest), (least, most) = _ends(self.focus_distance), _ends(self.f_number)
        # Uniform in 1 / distance, as blur is linear in it.
        inverse = _between((1.0 / nearest, 1.0 / farthest), dioptres)
        lens = Lens(
            focal_length=_between(self.focal_length, length),
            # Uniform in the logarithm: as many lenses between f/2 and f/2.8 as between f/4 and f/5.6.
            f_number=math.exp(_between((math.log(least), math.log(most)), stops)),
            focus_distance=1.0 / inverse if inverse > 0.0 else math.inf,
            wavelength=self.wavelength,
            aberrations=Wavefront(spherical=_between(self.spherical, spherical)),
        )
        return lens, _between(self.pixel, pitch)


def _range(name: str, value: object) -> Range:
    given = value if isinstance(value, tuple | list) else (value,)
    if len(given) not in (1, 2):
        raise TypeError(f"{name} must be a number or a pair, got {validation.shown(value)}")
    above, infinite = -math.inf if name == "spherical" else 0.0, name == "focus_distance"
    ends = tuple(validation.real(name, each, above=above, infinite=infinite) for each in given)
    if ends[0] > ends[-1]:
        raise ValueError(f"{name} must rise, got {validation.shown(value)}")
    return ends[0] if len(ends) == 1 else (ends[0], ends[1])


def _ends(value: Range) -> tuple[float, float]:
    return value if isinstance(value, tuple) else (value, value)


def _between(value: Range, share: float) -> float:
    first, last = _ends(value)
    return float(first + (last - first) * share)


@dataclass(frozen=True)
class Rendered:
    """One picture of a data set: just written by :func:`lommel.imaging.render_dataset`, or why it could not be.

    Attributes
    ----------
    number : int
        Counted from 0: photo ``number // copies``.
    done, total : int
        Pictures of the data set that there are now, and that there will be.
    files : tuple of path
        The files written; with `shard` the one that will hold them. None of a picture that could not be rendered.
    facts : dict
        What ``NUMBER.json`` holds: names of the photo and the depth map, the lens (metres, radians), noise, errors.
        Of a picture that could not be rendered, the names alone.
    failure : str or None
        Why the picture could not be rendered; with ``on_error="skip"`` only.
    """

    number: int
    done: int
    total: int
    files: tuple[Path, ...]
    facts: Json = field(repr=False)
    failure: str | None = None


def pair_files(photos: PathOf | Sequence[PathOf], depths: PathOf | Sequence[PathOf]) -> list[tuple[Path, Path]]:
    """Return photos with their depth maps: sequences in their order, files of two folders by their names.

    Names are compared without the suffix. Raises ValueError if a file has no partner or two have the same name.
    """
    listed = []
    for name, given in (("photos", photos), ("depths", depths)):
        if isinstance(given, str | PathLike):
            folder = validation.path(name, given)
            if not folder.is_dir():
                raise ValueError(f"{name} must be a folder or a list of files, got {validation.shown(str(folder))}")
            found: dict[str, Path] = {}
            for file in sorted(folder.iterdir()):
                if file.name.startswith(".") or not file.is_file():
                    continue
                if file.stem in found:
                    raise ValueError(f"{validation.line(file)} and {found[file.stem].name} have the same name")
                found[file.stem] = file
            if not found:
                raise ValueError(f"{name} must have files, got the empty folder {validation.shown(str(folder))}")
            listed.append(found)
        else:
            listed.append({str(k): validation.path(name, file) for k, file in enumerate(given)})
    first, second = listed
    for one, other, what in ((first, second, "depth map"), (second, first, "photo")):
        if missing := [file for key, file in one.items() if key not in other]:
            more = f", nor have {len(missing) - 1} other files" if len(missing) > 1 else ""
            raise ValueError(f"{validation.line(missing[0])} has no {what} of the same name{more}")
    return [(first[key], second[key]) for key in first]


@dataclass(frozen=True, kw_only=True)
class _Job:
    """The arguments that all pictures of a data set share."""

    lenses: LensRanges
    seed: int
    copies: int
    noise: Noise | None
    form: str
    encoding: str | None
    psfs: int
    values: DepthValues
    settings: Settings

    def record(self, pairs: Sequence[tuple[Path, Path]], shard: int | None) -> Json:
        """Return the arguments that determine the pictures, as JSON holds them."""
        apart = ("lenses", "noise", "settings", "values")
        given = {name: value for name, value in vars(self).items() if name not in apart}
        given |= {_CALLED.get(name, name): value for name, value in vars(self.values).items()}
        # The number of threads changes no value.
        settings = {name: value for name, value in vars(self.settings).items() if name != "threads"}
        settings["dtype"] = np.dtype(self.settings.dtype).name
        given |= {
            "format": _FORMAT,
            "lenses": asdict(self.lenses),
            "noise": None if self.noise is None else self.noise.to_dict(),
            "settings": settings,
            "shard": shard,
            "pairs": [[photo.name, depth.name] for photo, depth in pairs],
        }
        return plain(given)


@shares(Keywords, Settings)
def render_dataset(
    photos: PathOf | Sequence[PathOf],
    depths: PathOf | Sequence[PathOf],
    out: PathOf,
    lenses: LensRanges,
    *,
    seed: int,
    copies: int = 1,
    noise: Noise | None = None,
    form: str = "png",
    shard: int | None = None,
    encoding: str | None = None,
    psfs: int = 32,
    depth_scale: float | None = None,
    inverse_depth: tuple[float, float] | None = None,
    disparity: tuple[float, float] | None = None,
    zero_is_unknown: bool = False,
    unknown: Sequence[float] = (),
    resample: str | None = None,
    on_error: str = "raise",
    workers: int = 1,
    **options: Unpack[Keywords],
) -> Iterator[Rendered]:
    """Render photos with depth maps by random lenses into a folder, with ground truth, and yield each when written.

    Pictures that are there already are not rendered again: after an interruption the same call goes on. Each picture
    depends on `seed` and its number alone, not on `workers` (but for rounding in its last bit). Its files are moved
    into place together.

    Of picture 12 the folder holds ``000012.image.png`` (blurred, with noise), ``000012.sharp.png``,
    ``000012.depth.npy`` (metres, float32), ``000012.json`` (lens, noise, names of the files), and for the PSF of each
    pixel ``000012.index.png`` (16 bit) with ``000012.psfs.npz``: arrays `defocus` (n,), C_d in radians, and `psfs`
    (n, channels, side, side), float32, each of unit sum; the pixel (y, x) of the scene is spread by about
    ``psfs[index[y, x]]``, that of the nearest C_d. How far that may be off, over the peak of the PSF, is about
    `psfs_error` in the JSON file: half of the largest difference between neighbours of the table. `error` is that of
    the image, which is interpolated. WebDataset groups such names into samples.

    Parameters
    ----------
    photos, depths : path or sequence of path
        Folders whose files have the same names but for their suffixes, or files in the same order: photos as of
        :func:`lommel.imaging.read_photo` and depth maps as of :func:`lommel.imaging.read_depth`, of equal sizes.
    out : path
        Folder, made if there is none.
    lenses : LensRanges
        From which the lens and the pixel pitch of each picture are drawn.
    seed : int
        Of the lenses and of the noise.
    copies : int, default 1
        Number of pictures of each photo, by other lenses.
    noise : Noise, optional
        Photon and read noise of the blurred image, `white` being the electrons at white.
    form : {"png", "tif", "exr", "zarr"}, default "png"
        Format of the images: 16-bit PNG in the encoding of the photo, or linear light in float32 (EXR needs the
        package OpenEXR). Zarr is a group of arrays for each picture, images in chunks of 512 by 512 pixels.
    shard : int, optional
        Number of pictures in each tar file ``shard-000000.tar``, as WebDataset reads them; by default a file each.
    encoding : {"srgb", "linear"}, optional
        Encoding of the photos; by default integers are sRGB and floats are linear.
    psfs : int, default 32
        Number of PSFs of a picture, 2 to 4096, at equal steps of C_d over its scene, or 0 for none.
    depth_scale, inverse_depth : optional
        As `scale` and `inverse` of :func:`lommel.imaging.read_depth`: what makes metres of the values of depth maps.
    disparity, zero_is_unknown, unknown, resample : optional
        As of :func:`lommel.imaging.read_depth`; see `missing` for what is unknown.
    on_error : {"raise", "skip"}, default "raise"
        Whether a photo or depth map that cannot be used ends the iteration, or is yielded with the reason as
        `failure`, and the others are rendered. The next call tries it again. Its shard stays open: the other
        pictures of the shard wait in the folder ``parts``, a tar file each.
    workers : int, default 1
        Number of processes, each with its share of the processors; 1 renders in this process. More are spawned: a
        script must then call this below ``if __name__ == "__main__":``.
    {options}

    Yields
    ------
    Rendered
        In the order in which they are finished.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, files have no partner, or `out` holds pictures of other arguments or of other
        photos of the same names, is damaged, or is being written by another call; then, named
        with the photo, if one of its files cannot be used or its blur exceeds `largest`, unless `on_error` is "skip".
        What is done is kept.
    OSError
        If a file cannot be written or, unless `on_error` is "skip", read.

    Notes
    -----
    Ctrl-C, or closing the iterator, keeps all that is done and lets each worker finish its picture.

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
    validation.instance("lenses", lenses, LensRanges)
    validation.optional("noise", noise, Noise)
    skip = validation.choice("on_error", on_error, ON_ERROR) == "skip"
    if noise is not None and noise.white is None:
        raise ValueError("noise must have a white: electrons at the value 1.0, such as 5000")
    if validation.integer("psfs", psfs, least=0, most=4096) == 1:
        raise ValueError("psfs must be 0, for none, or from 2 to 4096, got 1")
    validation.choice("form", form, FORMATS)
    if encoding is not None:
        validation.choice("encoding", encoding, ENCODINGS)
    settings = Settings.of(render_dataset, options, Keywords)
    if psfs and settings.energy == 1.0:
        raise ValueError("psfs must be 0 with energy=1, where a point reaches the whole image, or energy below 1")
    if shard is not None:
        validation.integer("shard", shard, least=1, most=1_000_000)
    if form == "exr":
        library("OpenEXR", "EXR files need", "exr")
    if form == "zarr":
        library("zarr", "Zarr groups need", "zarr")
    try:
        values = DepthValues(depth_scale, inverse_depth, disparity, zero_is_unknown, unknown, resample)
    except (TypeError, ValueError) as error:
        said = re.sub(r"\b(scale|inverse)\b", lambda found: _CALLED[found[0]], str(error))
        raise type(error)(said) from None
    job = _Job(
        lenses=lenses,
        seed=validation.integer("seed", seed, least=0, most=2**63 - 1),
        copies=validation.integer("copies", copies, least=1, most=1_000_000),
        noise=noise,
        form=form,
        encoding=encoding,
        psfs=psfs,
        values=values,
        settings=settings,
    )
    pairs = pair_files(photos, depths)
    count = validation.integer("workers", workers, least=1, most=1024)
    folder = validation.path("out", out)
    _begin(folder, job.record(pairs, shard))
    return _missing(folder, job, pairs, shard, count, skip)


def _begin(folder: Path, record: Json) -> None:
    """Create the folder of a data set and its file of arguments; ValueError if the folder has others."""
    file = folder / _RECORD
    if not file.exists():
        if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
            raise ValueError(f"{validation.line(folder)} must be a new or empty folder, or a data set to go on with")
        folder.mkdir(parents=True, exist_ok=True)
        with suppress(FileExistsError), atomic.temporary_for(file, new=True) as place:  # another call may begin, too
            place.write_text(json.dumps(record, indent=1), encoding="utf-8")
    if not isinstance(known := _read(file), dict):
        raise ValueError(
            f"{validation.line(file)} is damaged; remove {validation.line(folder)}, or give another folder"
        )
    # Pictures of other arguments must not mix with those already written.
    if known != record:
        names = [name for name in record if known.get(name) != record[name]]
        raise ValueError(
            f"{validation.line(folder)} holds pictures of other arguments ({', '.join(names)}); give another folder"
        )


def _read(file: Path) -> Any:
    """Return the content of a JSON file; None if it is missing or damaged."""
    try:
        return reading.json(reading.contents(file))
    except (FileNotFoundError, ValueError):
        return None


def _complete_pictures(folder: Path, shard: int | None, total: int) -> Iterator[tuple[int, Json]]:
    """Yield the numbers and facts of pictures all of whose files exist unchanged."""
    if shard is None:
        for number in range(total):
            facts = _read(folder / f"{number:06d}.json")
            with suppress(FileNotFoundError):
                if isinstance(facts, dict) and all(
                    of_file(folder / f"{number:06d}.{name}") == known
                    for name, known in facts.get("files", {"": ""}).items()
                ):
                    yield number, facts
        return
    for index in range(-(-total // shard)):
        numbers = range(index * shard, min(total, (index + 1) * shard))
        whole = _shard(folder, index)
        # Pictures are separate tar files until their shard is complete.
        tars = {whole: numbers} if whole.exists() else {_part(folder, number): [number] for number in numbers}
        for tar, held in tars.items():
            if tar.exists():
                yield from _in_tar(tar, held)


def _in_tar(path: Path, numbers: Sequence[int]) -> Iterator[tuple[int, Json]]:
    """Yield the numbers and facts of the pictures in a tar file."""
    try:
        with tarfile.open(path) as tar:
            members = {member.name: member for member in tar}

            def held(number: int, name: str) -> bytes:
                file = tar.extractfile(members[f"{number:06d}.{name}"])
                assert file is not None
                return file.read()

            for number in numbers:
                facts = reading.json(held(number, "json"))
                if any(of_bytes(held(number, name)) != known for name, known in facts["files"].items()):
                    raise ValueError(f"the files of picture {number} were changed after they were written")
                yield number, facts
    except (tarfile.TarError, KeyError, AssertionError, ValueError) as error:
        reason = reading.reason(error)
        raise ValueError(f"{validation.line(path)} is damaged ({reason}); remove it, and call again") from None


def _missing(
    folder: Path, job: _Job, pairs: list[tuple[Path, Path]], shard: int | None, workers: int, skip: bool
) -> Iterator[Rendered]:
    """Yield the missing pictures as they are written."""
    # A lock: two processes in one folder would render the same pictures.
    with atomic.locked(folder / _RECORD, folder):
        total = len(pairs) * job.copies
        where = folder if shard is None else folder / _PARTS
        where.mkdir(exist_ok=True)
        # Copies share their photo: each file is read once for its checksum.
        there, sums = set(), cache(of_file)
        for number, facts in _complete_pictures(folder, shard, total):
            for file, known in zip(pairs[number // job.copies], facts["checksums"], strict=True):
                if sums(file) != known:
                    raise ValueError(
                        f"{validation.line(folder)} holds pictures of another {validation.line(file.name)} ({known}, "
                        f"now {sums(file)}); give another folder"
                    )
            there.add(number)
        left = [number for number in range(total) if number not in there]
        done = total - len(left)
        if shard is not None:
            for index in range(-(-total // shard)):
                _pack(folder, index, shard, total)
        make = partial(_write, job, where, shard is not None, skip)

        def told(number: int, files: list[str], facts: Json, failure: str | None, said: list[str]) -> Rendered:
            nonlocal done
            for note in said:
                validation.tell(note)
            if failure is not None:
                return Rendered(number, done, total, (), facts, failure)
            done += 1
            named = tuple(folder / name for name in files)
            if shard is not None:
                named = (_shard(folder, number // shard),)
                _pack(folder, number // shard, shard, total)
            return Rendered(number, done, total, named, facts)

        if workers == 1:
            for number in left:
                yield told(number, *make(number, *pairs[number // job.copies]))
            return
        # Processes share the processors: together as many threads as there are processors.
        threads = job.settings.threads or max(1, (os.cpu_count() or 1) // workers)
        shared = replace(job, settings=replace(job.settings, threads=threads))
        make = partial(_write, shared, where, shard is not None, skip)
        yield from (told(number, *made) for number, made in _by_processes(make, left, pairs, job.copies, workers))


_Written = tuple[list[str], Json, str | None, list[str]]
# Processes share the processors: together as many threads as there are processors.


def _by_processes(
    make: Callable[[int, Path, Path], _Written],
    left: list[int],
    pairs: list[tuple[Path, Path]],
    copies: int,
    workers: int,
) -> Iterator[tuple[int, _Written]]:
    """Yield numbers of pictures and the results of a function for each, computed by other processes."""
    from multiprocessing import get_context

    # Spawned: a fork copies locks that other threads hold.
    pool = ProcessPoolExecutor(min(workers, max(len(left), 1)), get_context("spawn"), initializer=_serve)
    numbers, running = iter(left), dict[Future[_Written], int]()
    try:
        while True:
            # Two tasks a worker: none waits for the next, and few results are held in memory.
            while len(running) < 2 * workers and (number := next(numbers, None)) is not None:
                running[pool.submit(make, number, *pairs[number // copies])] = number
            if not running:
                return
            for finished in wait(running, return_when=FIRST_COMPLETED).done:
                number = running.pop(finished)
                yield number, finished.result()
    finally:
        pool.shutdown(cancel_futures=True)


def _serve() -> None:
    """Ignore Ctrl-C, which the parent handles, and end when the parent ends."""
    from multiprocessing import connection, parent_process

    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = parent_process()
    if parent is not None:

        def follow() -> None:
            connection.wait([parent.sentinel])
            # Without clean-up: the parent that would wait for it is gone.
            os._exit(1)

        threading.Thread(target=follow, daemon=True).start()


def _shard(folder: Path, index: int) -> Path:
    return folder / f"shard-{index:06d}.tar"


def _part(folder: Path, number: int) -> Path:
    return folder / _PARTS / f"{number:06d}.tar"


def _pack(folder: Path, index: int, shard: int, total: int) -> None:
    """Pack the pictures of a shard into one tar file, if all exist and it does not."""
    target = _shard(folder, index)
    numbers = range(index * shard, min(total, (index + 1) * shard))
    parts = [_part(folder, number) for number in numbers]
    if not target.exists():
        if not all(part.exists() for part in parts):
            return

        def fill(path: Path) -> None:
            with tarfile.open(path, "w") as made:
                for part in parts:
                    with tarfile.open(part) as read:
                        for member in read:
                            made.addfile(member, read.extractfile(member))

        # Parts are removed only after the whole shard is in place.
        atomic.write_by(target, fill)
    for part in parts:
        part.unlink(missing_ok=True)


def _write(job: _Job, folder: Path, packed: bool, skip: bool, number: int, photo: Path, depth: Path) -> _Written:
    """Render a picture and write its files; return their names, the facts, why it was skipped, and notes on it."""
    said: list[str] = []
    try:
        with warnings.catch_warnings(record=True) as seen:
            # Warnings would stay in the worker process: they are recorded and shown by the parent.
            warnings.simplefilter("always", UserWarning)
            try:
                files, facts = _render(job, number, photo, depth)
            finally:
                said += [f"{validation.line(photo)}: {each.message}" for each in seen]
    except (ValueError, OSError) as error:
        named = isinstance(error, PhotoError | OSError) or str(depth) in str(error)
        if skip:
            reason = str(error) if named else f"{validation.line(photo)}: {error}"
            if isinstance(error, OSError) and error.filename:
                reason = f"{validation.line(error.filename)}: {error.strerror}"
            return [], {"photo": photo.name, "depth": depth.name}, reason, said
        if named:
            raise
        raise ValueError(f"{validation.line(photo)}: {error}") from None
    key = f"{number:06d}"
    if packed:
        atomic.write(folder / f"{key}.tar", _tar({f"{key}.{name}": data for name, data in files.items()}))
    else:
        # The last one says that all are there.
        with atomic.whole_files() as put:
            for name, data in files.items():
                target = folder / f"{key}.{name}"
                target.parent.mkdir(parents=True, exist_ok=True)  # of a Zarr array
                put(target, data)
    return list(dict.fromkeys(f"{key}.{name.partition('/')[0]}" for name in files)), facts, None, said


def _tar(files: dict[str, bytes]) -> bytes:
    made = io.BytesIO()
    with tarfile.open(fileobj=made, mode="w") as tar:
        for name, data in files.items():
            entry = tarfile.TarInfo(name)
            entry.size = len(data)
            tar.addfile(entry, io.BytesIO(data))
    return made.getvalue()


def _render(job: _Job, number: int, photo: Path, depth: Path) -> tuple[dict[str, bytes], Json]:
    """Return the files of a picture, the facts last."""
    random = np.random.default_rng([job.seed, number])
    lens, pixel = job.lenses.draw(random)
    sums = [of_file(photo), of_file(depth)]
    picture = read_photo(photo, job.encoding)
    light = picture.light(job.settings.dtype)
    metres = read_depth(depth, shape=light.shape, **vars(job.values))
    known = metres[~np.isnan(metres)]
    ends = [float(end(known)) for end in (np.min, np.max)] if known.size else []
    metres = np.asarray(fill_missing(metres, job.settings.missing), dtype=np.float64)
    channels = job.settings.channels(light.shape, lens.wavelength)
    blur = DepthBlur(metres, lens, pixel, channels=channels, **job.settings.of_blur)
    seen = (Occlusion(blur) if job.settings.occlusion else blur).forward(light)
    if job.noise is not None:
        electrons = np.multiply(np.maximum(seen, 0.0), np.asarray(job.noise.white), dtype=np.float64)
        seen = job.noise.record(electrons, random).astype(seen.dtype)
    table = _psfs(blur, job.psfs) if job.psfs else None
    facts = {
        "photo": photo.name,
        "depth": depth.name,
        "checksums": sums,
        "seed": [job.seed, number],
        "focal_length": lens.focal_length,
        "f_number": lens.f_number,
        "focus_distance": lens.focus_distance if math.isfinite(lens.focus_distance) else "infinity",
        "sensor_distance": lens.sensor_distance,
        "spherical": float(np.asarray(lens.aberrations.spherical)),
        "pixel": pixel,
        "depth_range": [end if math.isfinite(end) else "infinity" for end in ends],
        "depth_unknown": 1.0 - known.size / metres.size,
        "wavelength": lens.wavelength,
        "channels": [[list(line) for line in channel] for channel in spectra("channels", channels)],
        "encoding": picture.encoding if job.form == "png" else "linear",
        "noise": None if job.noise is None else job.noise.to_dict(),
        "window": 2 * max(bank.half for bank in blur.banks) + 1,
        "lost": float(f"{blur.lost:.4g}"),
        "error": float(f"{blur.error:.2g}"),
    }
    if table:
        facts["psfs_error"] = float(f"{_coarseness(table[2]):.2g}")
    if job.form == "zarr":
        arrays = {"image": seen, "sharp": light, "depth": metres}
        if table:
            arrays |= dict(zip(("defocus", "index", "psfs"), table, strict=True))
        files = _zarr(arrays, facts)
    else:
        files = {
            f"image.{job.form}": _encoded(job.form, seen, picture.encoding),
            f"sharp.{job.form}": _sharp(job.form, picture, light),
            "depth.npy": atomic.contents(np.save, metres.astype(np.float32)),
        }
        if table:
            defocus, index, psfs = table
            files["index.png"] = png_of_16_bits(index, None, 1)
            files["psfs.npz"] = atomic.contents(np.savez_compressed, defocus=defocus, psfs=psfs)
    kept = {name: of_bytes(data) for name, data in files.items()}
    files["json"] = json.dumps(facts | {"files": kept}, indent=1).encode()
    return files, facts


_CHUNK = 512  # pixels on each side
_AXES = {"defocus": ("step",), "psfs": ("step", "channel", "row", "column")}


def _zarr(arrays: dict[str, Values], facts: Json) -> dict[str, bytes]:
    """Return the files of a Zarr group of arrays, in single precision but for indices."""
    zarr = library("zarr", "Zarr groups need", "zarr")
    files: Json = {}
    group = zarr.open_group(zarr.storage.MemoryStore(files), mode="w", attributes=facts)
    for name, values in arrays.items():
        kept = values if values.dtype.kind == "u" else values.astype(np.float32)
        sides = kept.shape if name in _AXES else (*(min(side, _CHUNK) for side in kept.shape[:2]), *kept.shape[2:])
        axes = _AXES.get(name, ("y", "x", "channel")[: kept.ndim])
        group.create_array(name, data=kept, chunks=sides, dimension_names=axes)
    return {f"zarr/{name}": part.to_bytes() for name, part in files.items()}


def _psfs(blur: DepthBlur, count: int) -> tuple[Array, Values, Values]:
    """Return defocus at equal steps, the nearest of it for each pixel, and the PSFs there."""
    low, high = float(blur.defocus.min()), float(blur.defocus.max())
    defocus = np.linspace(low, high, count)
    step = (high - low) / (count - 1)
    index = np.rint((blur.defocus - low) / step if step > 0.0 else np.zeros(blur.shape)).astype(np.uint16)
    half = max(bank.half for bank in blur.banks)
    table = np.zeros((count, blur.channels, 2 * half + 1, 2 * half + 1), dtype=np.float32)
    for channel, bank in enumerate(blur.banks):
        inside = slice(half - bank.half, half + bank.half + 1)
        for number, radians in enumerate(defocus):
            table[number, channel, inside, inside] = bank.window(float(radians))
    return defocus, index, table


def _coarseness(psfs: Values) -> float:
    """Return half of the largest difference between PSFs next to each other, over the peak of the fainter one."""
    peaks = psfs.max(axis=(2, 3))
    apart = np.abs(np.diff(psfs, axis=0)).max(axis=(2, 3))
    return float((0.5 * apart / np.minimum(peaks[1:], peaks[:-1])).max())


def _sharp(form: str, picture: Picture, light: Values) -> bytes:
    """Return the photo as a file."""
    stored = picture.values
    if form != "png" or stored.dtype.kind != "u" or stored.dtype.itemsize > 2:
        return _encoded(form, light, picture.encoding)
    # 255 and 65535 are white.
    return png_of_16_bits(stored.astype(np.uint16) * np.uint16(257 if stored.itemsize == 1 else 1), None, 1)


def _encoded(form: str, light: Values, encoding: str) -> bytes:
    """Return light as a file."""
    if form == "png":
        # More pressing takes longer than the blur.
        return png_of_16_bits(from_light(light, encoding, np.uint16), None, 1)
    values = light.astype(np.float32, copy=False)
    return write_tiff(values, 100, None) if form == "tif" else photos.write_exr(values, 100, None)
