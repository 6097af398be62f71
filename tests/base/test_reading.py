"""Files that state more than they hold, are none, or lie elsewhere: refused by name."""

from __future__ import annotations

import csv
import errno
import io
import os
import struct
import zlib

import numpy as np
import pytest
import tifffile

import lommel as lm
from lommel import imaging
from lommel.base import reading
from lommel.io import text_files
from lommel.io.photos import PhotoError
from lommel.lensfiles.lens_files import LensFileError

LENS = '[lens]\nfocal_length = "50 mm"\nf_number = 2\nwavelength = "550 nm"\n[sensor]\npixel = "3 um"\nshape = 9\n'


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


@pytest.mark.parametrize(
    ("data", "why"),
    [
        (png(20000, 20000), "20000 x 20000 pixels; the limit is 268435456"),
        (png(2**31 - 1, 1), "pixels; the limit"),
        (png(15, 16056332), "15 x 16056332 pixels; the limit of a side is 65536"),
        (changed(PLAIN, 256, 60), "its values take"),
        (changed(changed(PLAIN, 256, 20000), 257, 20000), "20000 x 20000 pixels; the limit is 268435456"),
    ],
    ids=["png", "png-row", "png-side", "tiff-row", "tiff"],
)
@pytest.mark.parametrize("read", [imaging.read_photo, imaging.read_depth], ids=["photo", "depth"])
def test_a_picture_that_promises_too_much_is_refused_before_it_is_decoded(read, data, why, tmp_path):
    (tmp_path / "a").write_bytes(data)
    with pytest.raises(PhotoError, match=why):
        read(tmp_path / "a")


@pytest.mark.parametrize(
    "options", [{}, {"compression": "zlib"}, {"bigtiff": True}, {"byteorder": ">"}, {"tile": (16, 16)}]
)
@pytest.mark.parametrize("shape", [(33, 47), (33, 47, 3)])
def test_what_promises_what_it_holds_is_read(options, shape, tmp_path):
    values = np.random.default_rng(1).integers(0, 65536, shape).astype(np.uint16)
    (tmp_path / "a.tif").write_bytes(tiff(values, photometric="rgb" if len(shape) == 3 else "minisblack", **options))
    np.testing.assert_array_equal(imaging.read_photo(tmp_path / "a.tif").values, values)


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


def test_numbers_beyond_all_numbers_are_a_fault_of_the_lens_file(tmp_path):
    for entry in ("W020 = 1e308", "W131 = 1e308", 'spherical_rms = "1e300 m"', "defocus = 1e308"):
        (tmp_path / "lens.toml").write_text('name = "a"\n' + LENS + f"[aberrations]\n{entry}\nW040 = 1e308\n")
        with pytest.raises(LensFileError, match=r"lens\.toml: "):
            lm.load_instrument(tmp_path / "lens.toml")


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
        np.testing.assert_array_equal(reading.hdf5_values(good), np.arange(6.0))
        with pytest.raises(ValueError, match="must be an array of numbers in the file itself"):
            reading.hdf5_values(bad)


def test_what_is_at_a_limit_is_read_and_what_is_beyond_it_is_told(tmp_path):
    (tmp_path / "six").write_bytes(b"sixsix")
    assert reading.contents(tmp_path / "six", 6) == b"sixsix"
    with pytest.raises(OSError, match="has 6 bytes; the limit is 5"):
        reading.contents(tmp_path / "six", 5)
    np.save(tmp_path / "six.npy", np.zeros((2, 3)))
    assert reading.npy((tmp_path / "six.npy").read_bytes(), 6)[0].shape == (2, 3)
    with pytest.raises(ValueError, match="has 2 x 3 values; the limit is 5"):
        reading.npy((tmp_path / "six.npy").read_bytes(), 5)


def test_a_cell_in_quotes_is_one_and_a_line_may_be_as_long_as_a_cell():
    long = "x" * csv.field_size_limit()
    assert list(text_files.rows(f'"a, b", c\n# no\n{long}')) == [(1, ["a, b", "c"]), (3, [long])]
    with pytest.raises(ValueError, match="in line 1"):
        list(text_files.rows(f"{long}x"))
