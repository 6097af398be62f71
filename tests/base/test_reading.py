"""What a file of a stranger may cost: told by its header, before anything in it is decoded."""

from __future__ import annotations

import errno
import io
import json
import os
import resource
import struct
import zipfile
import zlib
from pathlib import Path

import numpy as np
import pytest
import tifffile

import hostile_files
import lommel as lm
from lommel import imaging
from lommel.base import reading
from lommel.io import psf_formats
from lommel.io.photos import PhotoError
from lommel.io.psf_files import FileError
from lommel.io.zernike_tables import ZernikeFileError
from lommel.lensfiles.lens_files import LensFileError

LENS = '[lens]\nfocal_length = "50 mm"\nf_number = 2\nwavelength = "550 nm"\n[sensor]\npixel = "3 um"\nshape = 9\n'


@pytest.fixture
def little_memory():
    """At most 512 MB more than there is: what a bomb takes fails at once."""
    before = resource.getrlimit(resource.RLIMIT_AS)
    used = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (used + 2**29, before[1]))
    yield
    resource.setrlimit(resource.RLIMIT_AS, before)


def png(width: int, height: int) -> bytes:
    def chunk(name: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    head = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(b"\0" * 99)) + chunk(b"IEND", b"")
    )


def tiff(values, **options) -> bytes:
    buffer = io.BytesIO()
    tifffile.imwrite(buffer, values, metadata=None, **options)
    return buffer.getvalue()


def changed(data: bytes, tag: int, value: int, count: int | None = None) -> bytes:
    """A little-endian TIFF whose first page has another value, or number of values, of a tag."""
    (at,) = struct.unpack_from("<I", data, 4)
    for k in range(struct.unpack_from("<H", data, at)[0]):
        place = at + 2 + 12 * k
        if struct.unpack_from("<H", data, place)[0] == tag:
            kind, number = struct.unpack_from("<HI", data, place + 2)
            parts = struct.pack("<HHII", tag, kind if count else 4, count or number, value)
            return data[:place] + parts + data[place + 12 :]
    raise AssertionError(tag)


PLAIN = tiff(np.ones((8, 8), np.float32))
BOMB = tiff(np.zeros((16, 16), np.float32), compression="zlib")
# Compressed data of 64 MB in place of those of 16 x 16 values.
SWOLLEN = changed(changed(BOMB, 273, len(BOMB)), 279, len(zlib.compress(bytes(2**26)))) + zlib.compress(bytes(2**26))


@pytest.mark.parametrize(
    ("data", "why"),
    [
        (png(20000, 20000), "20000 x 20000 pixels; the limit is 268435456"),
        (png(2**31 - 1, 1), "pixels; the limit"),
        (png(15, 16056332), "15 x 16056332 pixels; the limit of a side is 65536"),
        (png(16384, 16384), "16384 x 16384 pixels take 268435456 bytes, more than its 12 can inflate to"),
        (changed(PLAIN, 256, 20000), "more than the file holds"),
        (changed(changed(PLAIN, 256, 20000), 257, 20000), "20000 x 20000 pixels; the limit is 268435456"),
        (changed(PLAIN, 273, 8, 2**30), "claims 4294967296 bytes"),
        (SWOLLEN, "inflates to more than its 1024 bytes"),
        (PLAIN[:4] + struct.pack("<I", 2**31) + PLAIN[8:], "pages go beyond its end"),
        (hostile_files.overlapping_tags(3), "its tags claim 3145764 bytes of a file of 1048"),
        (changed(PLAIN, 259, 34925), "its compression is of the kind 34925; save it with none, LZW, deflate"),
    ],
    ids=["png", "png-row", "png-side", "png-bytes", "tiff-row", "tiff", "tags", "inflates", "pages", "same", "lzma"],
)
@pytest.mark.parametrize("read", [imaging.read_photo, imaging.read_depth], ids=["photo", "depth"])
def test_a_picture_that_promises_too_much_is_refused_before_it_is_decoded(read, data, why, tmp_path, little_memory):
    (tmp_path / "a").write_bytes(data)
    with pytest.raises(PhotoError, match=why):
        read(tmp_path / "a")


def test_a_bmp_that_promises_too_much_is_refused_likewise(tmp_path):
    head = struct.pack("<IIIIiiHHIIIIII", 99, 0, 54, 40, 16384, 16384, 1, 24, *6 * [0])
    (tmp_path / "a").write_bytes(b"BM" + head)
    with pytest.raises(PhotoError, match="more than the file"):
        imaging.read_photo(tmp_path / "a")


def test_the_pages_of_a_picture_end(tmp_path):
    end = (
        struct.unpack_from("<I", PLAIN, 4)[0]
        + 2
        + 12 * struct.unpack_from("<H", PLAIN, struct.unpack_from("<I", PLAIN, 4)[0])[0]
    )
    (tmp_path / "a.tif").write_bytes(PLAIN[:end] + PLAIN[4:8] + PLAIN[end + 4 :])
    with pytest.raises(PhotoError, match="circular"):
        imaging.read_photo(tmp_path / "a.tif")


@pytest.mark.parametrize(
    "options", [{}, {"compression": "zlib"}, {"bigtiff": True}, {"byteorder": ">"}, {"tile": (16, 16)}]
)
@pytest.mark.parametrize("shape", [(33, 47), (33, 47, 3)])
def test_what_promises_what_it_holds_is_read(options, shape, tmp_path):
    values = np.random.default_rng(1).integers(0, 65536, shape).astype(np.uint16)
    (tmp_path / "a.tif").write_bytes(tiff(values, photometric="rgb" if len(shape) == 3 else "minisblack", **options))
    np.testing.assert_array_equal(imaging.read_photo(tmp_path / "a.tif").values, values)


@pytest.mark.parametrize(
    ("header", "why"),
    [
        ("{'descr': '<f4', 'fortran_order': False, 'shape': (30000, 30000), }", "the limit is 268435456"),
        ("{'descr': '<f4', 'fortran_order': False, 'shape': (9999, 9999), }", "its values take 399920004 bytes"),
        ("{'descr': '<f4', 'fortran_order': False, 'shape': (9999, ", "its header is not that of an array"),
        ("{'descr': '|O', 'fortran_order': False, 'shape': (1, 1), }", "a pickle"),
        ("(((((", "its header is not that of an array"),
    ],
)
def test_an_array_that_promises_too_much_is_refused(header, why, tmp_path, little_memory):
    text = header.ljust(117).encode() + b"\n"
    (tmp_path / "a.npy").write_bytes(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(text)) + text + bytes(64))
    with pytest.raises(PhotoError, match=why):
        imaging.read_depth(tmp_path / "a.npy")


def test_an_archive_that_inflates_to_more_than_an_image_is_refused(tmp_path, little_memory):
    lm.psf(lm.Pupil(), 3, 0.5).save(tmp_path / "a.npz")
    with zipfile.ZipFile(tmp_path / "a.npz") as archive:
        description = archive.read("description.npy")
    header = b"{'descr': '<f4', 'fortran_order': False, 'shape': (4000, 4000), }".ljust(117) + b"\n"
    with zipfile.ZipFile(tmp_path / "a.npz", "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("description.npy", description)
        with archive.open("values.npy", "w") as file:
            file.write(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header)
            for _ in range(4):
                file.write(bytes(16 * 10**6))
    with pytest.raises(FileError, match="4000 x 4000 values of float32; the limit is 9"):
        lm.PSF.load(tmp_path / "a.npz")


@pytest.mark.parametrize("make", [os.mkfifo, lambda path: path.symlink_to("/dev/zero")], ids=["pipe", "device"])
@pytest.mark.parametrize(
    ("read", "suffix"),
    [
        (lm.PSF.load, ".npy"),
        (lm.load_instrument, ".toml"),
        (lm.load_zernike, ".csv"),
        (imaging.read_photo, ".png"),
        (imaging.read_depth, ".tif"),
    ],
    ids=["psf", "lens", "zernike", "photo", "depth"],
)
def test_what_is_no_file_is_not_read(make, read, suffix, tmp_path):
    path = tmp_path / f"a{suffix}"
    make(path)
    with pytest.raises(OSError, match="is no regular file"):
        read(path)


def test_a_lens_file_that_names_what_is_no_file_is_told_so(tmp_path):
    (tmp_path / "lens.toml").write_text(
        'name = "a"\n' + LENS + '[field]\nsensor = ["1 mm", "1 mm"]\nfile = "/dev/zero"\n'
    )
    with pytest.raises(LensFileError, match="'/dev/zero' cannot be read: is no regular file"):
        lm.load_instrument(tmp_path / "lens.toml")


def test_a_text_has_a_limit(tmp_path):
    with (tmp_path / "lens.toml").open("wb") as file:
        file.truncate(reading.MAX_TOML + 1)
    with pytest.raises(OSError, match="262145 bytes; the limit is 262144") as caught:
        lm.load_instrument(tmp_path / "lens.toml")
    assert caught.value.errno == errno.EFBIG


def test_of_many_faults_twelve_are_told(tmp_path):
    stray = "".join(f"stray_key_{k} = 1\n" for k in range(1000))
    (tmp_path / "lens.toml").write_text('name = "a"\n' + LENS.replace("[sensor]", stray + "[sensor]"))
    with pytest.raises(LensFileError, match=r"(?s)stray_key_11 .*and 988 more$"):
        lm.load_instrument(tmp_path / "lens.toml")


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.toml", "{key} = 1"),
        ("a.toml", "[lens.{key}]\na = 1"),
        ("table.toml", "{key} = 1"),
        ("table.json", '{{"{key}": 1, "{key}": 2}}'),
        ("table.csv", "# {key}: 1\n# {key}: 2\n"),
        ("table.csv", "{key},value\n1,2"),
        ("table.csv", "# order: noll\nindex,value,{key}\n1,2"),
        ("table.csv", "# order: {key}\nnoll,value\n1,2"),
    ],
)
def test_a_long_key_is_told_in_short(name, text, tmp_path):
    (tmp_path / name).write_text(text.format(key="a" * 5000))
    with pytest.raises(ValueError, match="aaa") as caught:
        (lm.load_instrument if name == "a.toml" else lm.load_zernike)(tmp_path / name)
    assert max(map(len, str(caught.value).splitlines())) < 300


@pytest.mark.parametrize("text", ["a = 1\n" + ".".join("a" * 17) + " = 1", "[" + ".".join("a" * 17) + "]",
                                  'b = {"a"' + ". 'a'" * 16 + " = 1}"])  # fmt: skip
def test_a_key_of_many_parts_is_refused_and_one_of_few_is_not(text):
    with pytest.raises(ValueError, match="a key must have at most 16 parts"):
        reading.toml(text)
    assert reading.toml(".".join("a" * 16) + " = 1\nb = '1.2.3'\nc = [" + "1.5, " * 100 + "]")["b"] == "1.2.3"


def test_what_takes_all_memory_is_no_text(monkeypatch):
    import tomllib

    def full(_: str) -> None:
        raise MemoryError

    monkeypatch.setattr(tomllib, "loads", full)
    with pytest.raises(ValueError, match=r"too many or too deep \(MemoryError\)"):
        reading.toml("a = 1")


def test_a_lens_file_of_a_stranger_may_be_kept_to_its_folder(tmp_path):
    (tmp_path / "secret.csv").write_text("root:x:0:0\n")
    (tmp_path / "lenses").mkdir()
    (tmp_path / "lenses" / "field.csv").write_text("height,Z4\n0,0\n1 mm,1\n")
    lens = tmp_path / "lenses" / "lens.toml"
    for name, inside in (("field.csv", True), ("../lenses/field.csv", True), ("../secret.csv", False)):
        lens.write_text('name = "a"\n' + LENS + f'[field]\nsensor = ["1 mm", "1 mm"]\nfile = "{name}"\n')
        if inside:
            assert lm.load_instrument(lens, folder_only=True).sensor == (1e-3, 1e-3)
        else:
            with pytest.raises(LensFileError, match="must lie in the folder of the lens file") as caught:
                lm.load_instrument(lens, folder_only=True)
            assert "root:x" not in str(caught.value)
    for section in ('[aperture.mask]\nfile = "../a.npy"', '[aberrations.zernike]\nfile = "../a.csv"'):
        lens.write_text('name = "a"\n' + LENS + section)
        with pytest.raises(LensFileError, match="must lie in the folder of the lens file"):
            lm.load_instrument(lens, folder_only=True)


@pytest.mark.parametrize(
    ("suffix", "data", "why"),
    [
        (".json", json.dumps({"order": "noll"})[:-1] + ', "terms": {"4": ' + "1" * 100_000 + "}}", "not valid JSON"),
        (".toml", "order = " + "1" * 100_000, "not valid TOML"),
        (".csv", "# order: noll\nindex,value\n4," + "1" * 140_000, "."),
        (".json", json.dumps({"terms": {str(k): 1.0 for k in range(9999)}}), "must be at most 4096 coefficients"),
    ],
)
def test_a_table_that_no_reader_takes_is_told_with_its_name(suffix, data, why, tmp_path):
    (tmp_path / f"table{suffix}").write_text(data)
    with pytest.raises(ZernikeFileError, match=rf"table{suffix}: (.|\n)*{why}"):
        lm.load_zernike(tmp_path / f"table{suffix}")


def test_a_field_with_an_endless_cell_is_told_with_its_name(tmp_path):
    (tmp_path / "field.csv").write_text("height,Z4\n0," + "1" * 131_073)
    (tmp_path / "lens.toml").write_text(
        'name = "a"\n' + LENS + '[field]\nsensor = ["1 mm", "1 mm"]\nfile = "field.csv"\n'
    )
    with pytest.raises(LensFileError, match=r"field\.csv: field larger than field limit"):
        lm.load_instrument(tmp_path / "lens.toml")


def test_numbers_beyond_all_numbers_are_a_fault_of_the_lens_file(tmp_path):
    for entry in ("W020 = 1e308", "W131 = 1e308", 'spherical_rms = "1e300 m"', "defocus = 1e308"):
        (tmp_path / "lens.toml").write_text('name = "a"\n' + LENS + f"[aberrations]\n{entry}\nW040 = 1e308\n")
        with pytest.raises(LensFileError, match=r"lens\.toml: "):
            lm.load_instrument(tmp_path / "lens.toml")


def test_a_name_with_a_line_break_is_told_on_one_line(tmp_path):
    path = tmp_path / "a\nb.png"
    path.write_bytes(b"junk")
    with pytest.raises(PhotoError, match=r"a\\nb.png is not a PNG"):
        imaging.read_photo(path)


def test_arrays_that_compress_too_well_to_be_read_are_stored_plainly():
    small, large = (
        psf_formats.archive({"values": np.zeros((side, side), np.float32)}, {"shape": [side, side]})
        for side in (1000, 4200)
    )
    assert len(small) < 10**5
    assert len(large) > 4 * 4200**2
    assert psf_formats.read_npz(large)[0]["values"].shape == (4200, 4200)


@pytest.mark.parametrize("kind", ["external", "virtual", "group", "compound"])
def test_arrays_of_hdf5_that_are_not_numbers_of_the_file_itself_are_refused(tmp_path, kind):
    h5py = pytest.importorskip("h5py")
    (tmp_path / "secret.raw").write_bytes(np.arange(6.0).tobytes())
    with h5py.File(tmp_path / "a.h5", "w") as file:
        good = file.create_dataset("good", data=np.arange(6.0))
        if kind == "external":
            bad = file.create_dataset("bad", (6,), "f8", external=[(str(tmp_path / "secret.raw"), 0, 48)])
        elif kind == "virtual":
            layout = h5py.VirtualLayout((6,), "f8")
            layout[:] = h5py.VirtualSource(good)
            bad = file.create_virtual_dataset("bad", layout)
        else:
            bad = file.create_group("bad") if kind == "group" else file.create_dataset("bad", (6,), [("x", "f8")])
        np.testing.assert_array_equal(reading.hdf5_values(good, 10_000), np.arange(6.0))
        with pytest.raises(ValueError, match="must be an array of numbers in the file itself"):
            reading.hdf5_values(bad, 10_000)
