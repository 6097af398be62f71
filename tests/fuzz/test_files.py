"""Mutated files of every kind that is read: a clear error, or the values that were written, in little memory."""

from __future__ import annotations

import bz2
import gzip
import io
import logging
import os
import random
import re
import shutil
import warnings
import zipfile
from collections.abc import Callable
from pathlib import Path

import h5py
import numpy as np
import pytest
import tifffile
from PIL import Image

import containers
import lommel as lm
from lommel import imaging, stacks
from lommel.io import fits_images, psf_files, psf_formats
from lommel.io.zernike_tables import ZernikeTable
from lommel.lensfiles.tables import read_csv
from lommel.recorded.frames import open_frames, read_images

DEPTH = np.linspace(1.0, 3.0, 12 * 15).reshape(12, 15).astype(np.float32)
GREY = np.arange(12 * 15, dtype=np.uint8).reshape(12, 15)
LENS = """name = "a"
[lens]
focal_length = "50 mm"
f_number = 2
focus_distance = "2 m"
wavelength = "550 nm"
obscuration = 0.1
[aperture.spider]
width = "1 mm"
vanes = 3
[aperture.mask]
file = "mask.npy"
[aberrations]
W040 = 0.25
W131 = 0.5
field = [0.5, 0.5]
[aberrations.zernike]
order = "noll"
unit = "waves"
normalization = "rms"
wavelength = "600 nm"
[aberrations.zernike.terms]
8 = 0.1
[object]
distance = "1.5 m"
[sensor]
pixel = "3 um"
shape = [9, 11]
[report]
encircled_energy = ["5 um", "1 mrad"]
"""

CAMERA = """name = "a"
source = "b"
[camera]
pixel = "6.5 um"
read = 1.4
full_well = 30000
gain = 0.46
offset = 100
"""

OBJECTIVE = """name = "a"
[objective]
NA = 1.3
magnification = 60
working_distance = "0.2 mm"
immersion = 1.518
[coverslip]
index = 1.52
thickness = "170 um"
[[films]]
index = 1.46
thickness = "20 nm"
[design]
immersion = 1.515
[design.coverslip]
index = 1.5255
thickness = "165 um"
[sample]
index = 1.33
depth = "2 um"
[emission]
wavelength = "520 nm"
[emission.dipole]
polar = "60 deg"
[stack]
planes = 5
step = "200 nm"
[sensor]
pixel = "6.5 um"
shape = [9, 11]
"""


def of_psf(path: Path) -> object:
    loaded = lm.PSF.load(path)
    return loaded.values.tobytes(), repr(loaded), repr(loaded.pupil.to_dict())


def of_grid(path: Path) -> object:
    loaded = lm.PSFGrid.load(path)
    return loaded.values.tobytes(), loaded.x.tobytes(), loaded.sensor


def of_colour(path: Path) -> object:
    loaded = lm.ColourPSF.load(path)
    return loaded.values.tobytes(), repr(loaded), repr(loaded.channels)


def of_store(path: Path) -> object:
    stack = lm.open_stack(path)
    return stack[:].values.tobytes(), repr(stack[:]), repr(stack[0].pupil.to_dict()), stack.done


def of_recording(path: Path) -> object:
    with open_frames(path).as_channels() as one:
        return repr(one), [one[0, k].tobytes() for k in range(min(one.shape[1], 8))]


def of_movie(path: Path) -> object:
    with open_frames(path).as_stack() as movie:
        return movie.shape, [block.tobytes() for block in movie.blocks(1)]


def of_images(path: Path) -> object:
    return read_images([path])


def named(stem: str, *suffixes: str) -> list[str]:
    return [f"{stem}{suffix}" for suffix in suffixes]


RECORDINGS = ["plain.ome.tif", "tiles.ome.tif", "imagej.tif", "chunks.zarr", "shards.zarr"]
# Each kind of file and what reads it; the last word is the name of the file.
KINDS: dict[str, Callable[[Path], object]] = {
    **dict.fromkeys(named("psf", ".tif", ".npy", ".npz", ".fits", ".fits.gz", ".h5", ".mat"), of_psf),
    **dict.fromkeys(named("stack", ".tif", ".npz"), of_psf),
    **dict.fromkeys(named("grid", ".tif", ".npz", ".fits", ".fits.gz", ".h5", ".mat", ".zarr"), of_grid),
    **dict.fromkeys(named("colour", ".npz", ".tif"), of_colour),
    "store.zarr": of_store,
    "objective.toml": lm.load_microscope,
    "lens.toml": lambda path: lm.load_instrument(path).pupil(),
    "camera.toml": lm.load_camera,
    "field.csv": lambda path: read_csv(path, "noll"),
    "channels.csv": lm.load_channels,
    **dict.fromkeys([*named("depth", ".npy", ".tif", ".pfm"), "depth-deflated.tif"], imaging.read_depth),
    "levels.png": lambda path: imaging.read_depth(path, scale=1e-3),
    **dict.fromkeys(named("photo", ".tif", ".png", ".jpg", ".bmp"), imaging.read_photo),
    **dict.fromkeys(["deep.png", "exif.jpg", "exif.png"], imaging.read_photo),
    **dict.fromkeys([*named("table", ".json", ".toml", ".csv"), "listing.txt", "code.int"], lm.load_zernike),
    **dict.fromkeys(named("opd", ".fits", ".fits.gz", ".csv", ".datx"), lm.load_opd),
    **dict.fromkeys(named("stars", ".fits", ".tif"), of_images),
    **dict.fromkeys(named("images", ".tif", ".png", ".npy", ".fits.gz", ".fits.bz2"), of_images),
    **dict.fromkeys([f"recording {name}" for name in RECORDINGS], of_recording),
    **dict.fromkeys([f"movie {name}" for name in RECORDINGS[:3]], of_movie),
}
# What has a checksum of ours, which says that a file is as it was written; it keeps out damage, not those who can
# make it, too.
SEALED = (of_psf, of_grid, of_colour, of_store)
RESEALED = [
    *("psf.tif", "psf.npy", "psf.npz", "psf.fits", "psf.fits.gz", "psf.h5", "psf.mat", "stack.npz"),
    *("grid.tif", "grid.npz", "grid.fits", "grid.zarr", "store.zarr", "colour.npz"),
]


@pytest.fixture(scope="module")
def good(tmp_path_factory) -> Path:
    """A folder with a good file of each kind."""
    folder = tmp_path_factory.mktemp("good")
    write_results(folder)
    write_pictures(folder)
    write_wavefronts(folder)
    write_recordings(folder)
    (folder / "camera.toml").write_text(CAMERA)
    return folder


def write_results(folder: Path) -> None:
    """PSFs, stacks, grids and what they are made of."""
    psf = lm.psf(lm.Pupil(lm.Wavefront(1.0, nonradial={(3, 1): 0.2})), 9, 0.5)
    grid = lm.FieldMap.from_seidel(1.0, W131=0.5).grid(2, 2, sensor=(1.0, 1.0), shape=5, pixel=0.5)
    lens = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
    (folder / "objective.toml").write_text(OBJECTIVE)
    through = lm.load_microscope(folder / "objective.toml").objective.pupil(
        depth=2e-6, z=[0.0, 1e-7], wavelength=520e-9, origin="paraxial", emitter="scalar"
    )
    made = {"psf": psf, "grid": grid, "colour": lm.colour_psf(lens.pupil(1.9), 5, 4e-6)}
    made["stack"] = lm.psf(through, 5, 6.5e-6)
    for name in KINDS:
        stem = name.partition(".")[0]
        if stem in made:
            made[stem].save(folder / name)
    lm.psf_to(folder / "store.zarr", lm.Pupil(lm.Wavefront([0.0, 1.0, 2.0])), 5, 0.5, chunk=2)
    np.save(folder / "mask.npy", np.ones((8, 8)))
    (folder / "lens.toml").write_text(LENS)
    (folder / "field.csv").write_text("x,y,Z4,Z8\n0,0,0.1,0.2\n1 mm,0,0.3,0.4\n0,1 mm,0.5,0.6\n")
    rows = "".join(f"{400 + 20 * k},{0.1 + 0.05 * k},{0.9 - 0.05 * k}\n" for k in range(16))
    (folder / "channels.csv").write_text(f"wavelength (nm),red,blue\n{rows}")


def write_pictures(folder: Path) -> None:
    """Depth maps and photographs."""
    np.save(folder / "depth.npy", DEPTH)
    tifffile.imwrite(folder / "depth.tif", DEPTH)
    tifffile.imwrite(folder / "depth-deflated.tif", DEPTH, compression="zlib", tile=(16, 16))
    (folder / "depth.pfm").write_bytes(b"Pf\n15 12\n-1.0\n" + DEPTH.tobytes())
    Image.fromarray((1000 * DEPTH).astype(np.uint16)).save(folder / "levels.png")
    tifffile.imwrite(folder / "photo.tif", np.stack([GREY] * 3, axis=2), photometric="rgb", byteorder=">")
    Image.fromarray(GREY).save(folder / "photo.png")
    Image.fromarray(np.stack([GREY] * 3, axis=2)).save(folder / "photo.jpg")
    Image.fromarray(np.stack([GREY] * 3, axis=2)).save(folder / "photo.bmp")
    imaging.write_photo(folder / "deep.png", np.stack([GREY / 255.0] * 3, axis=2), dtype=np.uint16)
    tags = Image.Exif()
    tags[0x0112] = 6
    tags[0x8769] = {0x920A: 50.0, 0x829D: 2.0, 0xA405: 75}
    for suffix in (".jpg", ".png"):
        Image.fromarray(GREY).save(folder / f"exif{suffix}", exif=tags)


def write_wavefronts(folder: Path) -> None:
    """Tables of Zernike coefficients and maps of path differences."""
    table = ZernikeTable({4: 0.1, 8: -0.25}, "noll", "nm", "rms", 6e-7)
    for suffix in (".json", ".toml", ".csv"):
        lm.save_zernike(folder / f"table{suffix}", table)
    listing = "Listing of Zernike Fringe Coefficient Data\nWavelength : 0.55 µm\nRMS (to chief) : 0.2 waves\n"
    (folder / "listing.txt").write_text(
        listing + "Z   1\t  0.1\t: 1\nZ   2\t -0.25\t: p COS (A)\n", encoding="utf-16"
    )
    (folder / "code.int").write_text("title\nZRN 4 WFR WVL 0.6328 SSZ 1000 NDA 32767\n10 20.5\n-30 1e2\n")
    opd = lm.OPDMap(5e-7 * lm.opd_map(lm.Wavefront(1.0), 8, unit="waves"), spacing=1e-3, wavelength=5e-7)
    for suffix in (".fits", ".fits.gz", ".csv"):
        lm.save_opd(folder / f"opd{suffix}", opd)
    with h5py.File(folder / "opd.datx", "w") as file:
        surface = file.create_dataset("Measurement/Surface", data=opd.values, compression="gzip")
        surface.attrs.update({"Unit": np.bytes_("NanoMeters"), "Wavelength": [5e-7], "No Data": [1e308]})


def write_recordings(folder: Path) -> None:
    """Images of stars, stacks of microscopes and movies."""
    stars = np.random.default_rng(1).poisson(50, (2, 9, 11)).astype(np.uint16)
    (folder / "stars.fits").write_bytes(fits_images.write([(stars.astype(np.float32), {})]))
    tifffile.imwrite(folder / "stars.tif", stars, photometric="minisblack")
    stack = np.random.default_rng(0).poisson(100, (4, 20, 24)).astype(np.uint16)
    containers.ome(stack, folder / "plain.ome.tif")
    containers.ome(stack, folder / "tiles.ome.tif", compression="zlib", tile=(16, 16))
    containers.imagej(stack, folder / "imagej.tif")
    containers.ome_zarr(stack, folder / "chunks.zarr")
    containers.ome_zarr(stack, folder / "shards.zarr", version=3, shards=(4, 32, 32))
    containers.pillow(stack, folder / "images.tif", compression="tiff_lzw")
    Image.fromarray(stack[0]).save(folder / "images.png")
    np.save(folder / "images.npy", stack)
    packed = fits_images.write([(stack.astype(np.float32), {})])
    (folder / "images.fits.gz").write_bytes(gzip.compress(packed))
    (folder / "images.fits.bz2").write_bytes(bz2.compress(packed))


def mutate(path: Path, parts: dict[Path, bytes], draw: random.Random) -> None:
    """Write what is mutated of a file; of a folder one of its files, or in its place something that is no file."""
    for part in parts if path.is_dir() else ():
        part.rmdir() if part.is_dir() else part.unlink(missing_ok=True)
        part.write_bytes(parts[part])
    part = draw.choice(list(parts))
    if path.is_dir() and draw.randrange(8) == 0:
        part.unlink()
        draw.choice((lambda: os.mkfifo(part), lambda: part.symlink_to("/dev/zero"), part.mkdir, lambda: None))()
    else:
        part.write_bytes(mutated(parts[part], draw))


def mutated(data: bytes, draw: random.Random) -> bytes:
    """Bits turned, ends cut, parts moved, and numbers of headers replaced."""
    out = bytearray(data)
    for _ in range(draw.choice((1, 1, 1, 2, 5))):
        at = draw.randrange(min(len(out), draw.choice((32, 256, 1 << 20)))) if out else 0
        way = draw.randrange(7)
        if way == 0 and out:
            out[at] ^= 1 << draw.randrange(8)
        elif way == 1:
            out = out[:at]
        elif way == 2:
            start = draw.randrange(len(out) + 1)
            out[at:at] = out[start : start + draw.randrange(1, 200)]
        elif way == 3:
            del out[at : at + draw.randrange(1, 64)]
        elif way == 4:
            out[at : at + 4] = draw.choice(
                (b"\xff" * 4, b"\x7f\xff\xff\xff", b"\0\0\0\x80", b"\0" * 4, b"\x01\0\0\0")
            )
        elif way == 5:
            out[at : at + 1] = bytes([draw.randrange(256)])
        else:
            out[at:at] = draw.choice(
                (b"9" * 40, b"1e308", b"nan", b"-", b"\n", b"[" * 50, b'"', b"inf", b"\xc3\x28", b",")
            )
    return bytes(out)


@pytest.mark.parametrize("kind", KINDS)
def test_a_mutated_file_is_refused_or_read_as_it_was(kind, good, tmp_path, hunt, count):
    path, read = copied(kind, good, tmp_path), KINDS[kind]
    whole, parts = read(path), contents(path)

    def case(k: int) -> str | None:
        draw = random.Random(f"{kind} {k}")
        mutate(path, parts, draw)
        return judged(path, read, whole if read in SEALED else None)

    findings = hunt(case, count(15, 1000), seconds=10, memory=3 * 2**29)
    assert not findings, "\n".join(findings)


@pytest.mark.parametrize("kind", RESEALED)
def test_a_mutated_file_whose_checksums_are_right_is_refused_or_read(kind, good, tmp_path, hunt, count, monkeypatch):
    path, read = copied(kind, good, tmp_path), KINDS[kind]
    parts = contents(path)
    read(path)  # libraries are there, before any child needs them
    for module in (psf_files, stacks):
        for name in {"checksum", "crc32"} & vars(module).keys():
            monkeypatch.setattr(module, name, lambda *_: Right())

    def case(k: int) -> str | None:
        draw = random.Random(f"resealed {kind} {k}")
        for part, data in parts.items():
            part.write_bytes(data)
        part = draw.choice(list(parts))
        part.write_bytes(resealed(parts[part], draw))
        return judged(path, read, None)

    findings = hunt(case, count(15, 1000), seconds=10, memory=3 * 2**29)
    assert not findings, "\n".join(findings)


class Right(int):
    """A checksum that is equal to that of any file: as if it had been made of what was mutated."""

    __hash__ = int.__hash__

    def __eq__(self, other: object) -> bool:
        return True

    def __ne__(self, other: object) -> bool:
        return False


def resealed(data: bytes, draw: random.Random) -> bytes:
    """Return a mutated file with its checksums made anew: of archives, of gzip and of HDF5; others are `Right`."""
    if data.startswith(b"PK"):
        room = io.BytesIO()
        with zipfile.ZipFile(io.BytesIO(data)) as before, zipfile.ZipFile(room, "w") as after:
            chosen = draw.choice(before.namelist())
            for name in before.namelist():
                part = before.read(name)
                after.writestr(name, reworded(part, draw) if name == chosen else part)
        return room.getvalue()
    if data.startswith(b"\x1f\x8b"):
        return gzip.compress(reworded(gzip.decompress(data), draw))
    at = data.find(psf_formats._CHECKED, 0, 512)
    out = reworded(data, draw)
    if at >= 0 and len(out) > 512:
        at += len(psf_formats._CHECKED)
        out = out[:at] + psf_formats._sum(out) + out[at + 8 :]
    return out


def reworded(data: bytes, draw: random.Random) -> bytes:
    """Return bytes of which a word of the JSON in them is another, of the same length where others count on it."""
    words = list(re.finditer(rb'-?\d+\.?\d*(?:e-?\d+)?|"[^"\\]{0,40}"|null|true|false', data[data.find(b'{"') :]))
    if data.find(b'{"') < 0 or not words or draw.randrange(4) == 0:
        return mutated(data, draw)
    word, start = draw.choice(words), data.find(b'{"')
    new = draw.choice((b"0", b"-1", b"1e400", b"NaN", b"99999999999", b"null", b"[]", b"{}", b"true", b'"x"', b"0.5"))
    if draw.randrange(2):
        new = new[: len(word[0])].ljust(len(word[0]))
    return data[: start + word.start()] + new + data[start + word.end() :]


def copied(kind, good, tmp_path):
    """Copy the good files; return the one of a kind, renamed."""
    shutil.copytree(good, tmp_path, dirs_exist_ok=True)
    path = tmp_path / kind.rpartition(" ")[2]
    return path.rename(tmp_path / f"mutated{''.join(path.suffixes)}")


def contents(path: Path) -> dict[Path, bytes]:
    files = sorted(path.rglob("*")) if path.is_dir() else [path]
    return {part: part.read_bytes() for part in files if part.is_file()}


def judged(path: Path, read, whole: object) -> str | None:
    """Return what is wrong with how a file is read or refused; `whole` is what may come out of it, if not None."""
    records: list[logging.LogRecord] = []
    handler = logging.Handler()
    handler.emit = records.append  # type: ignore[method-assign]
    logging.getLogger().addHandler(handler)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            answer = read(path)
        except (ValueError, OSError) as error:
            message = str(error)
            if isinstance(error, UnicodeError) or "mutated" not in message:
                return f"{type(error).__name__} that does not name the file: {message[:300]}"
            most = 15 if path.suffix in (".toml", ".json", ".csv", ".txt") else 1
            if len(message.splitlines()) > most or len(message) > 300 * most + 200:
                return f"a message of {len(message.splitlines())} lines, {len(message)} characters: {message[:300]}"
            return None if not records else f"logged: {records[0].getMessage()[:200]}"
        except BaseException as error:
            return f"{type(error).__name__}: {str(error)[:300]}"
        finally:
            logging.getLogger().removeHandler(handler)
    if records:
        return f"logged: {records[0].getMessage()[:200]}"
    return "it was read as something else" if whole is not None and answer != whole else None


def test_every_public_reader_is_fuzzed():
    found = set()
    for home in (lm, imaging, lm.localize, lm.microscopy, lm.recorded):
        for name in home.__all__:
            value = getattr(home, name)
            names = [f"{name}.{own}" for own in dir(value)] if isinstance(value, type) else [name]
            found |= {name for name in names if name.rpartition(".")[2].startswith(("load", "open_", "read_"))}
    assert len(found) >= 12
    text = Path(__file__).read_text(encoding="utf-8")
    assert [name for name in sorted(found) if name not in text] == []
