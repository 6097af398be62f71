"""EXIF from one photograph to the next: what other programs read of it, whatever the format."""

from __future__ import annotations

import io
import struct

import numpy as np
import pytest
import tifffile
from PIL import Image, TiffImagePlugin

from lommel.imaging import Exif, PhotoError, read_photo, write_photo
from lommel.io.photos import parsed

OWN = {0x010F: "Canon", 0x0110: "EOS R5", 0x0132: "2026:01:02 03:04:05", 0x013B: "An Artist", 0x8298: "(c) Somebody"}
LENS = {
    0x829A: TiffImagePlugin.IFDRational(1, 200),
    0x829D: TiffImagePlugin.IFDRational(18, 10),
    0x9003: "2026:01:02 03:04:05",
    0x9204: TiffImagePlugin.IFDRational(-1, 3),
    0x920A: TiffImagePlugin.IFDRational(50, 1),
    0xA434: "RF50mm F1.8 STM",
}
PLACE = {1: "N", 2: (47.0, 30.0, 12.5)}
VALUES = np.random.default_rng(5).integers(0, 256, (24, 36, 3)).astype(np.uint8)


def block(order: str = "II") -> bytes:
    tags = Image.Exif()
    tags.endian = {"II": "<", "MM": ">"}[order]
    for tag, value in OWN.items():
        tags[tag] = value
    tags[0x0112] = 6
    tags[0x0131] = "of the camera"
    tags[0x8769] = LENS | {0x927C: b"maker" * 30, 0xA002: 36, 0xA003: 24, 0xA001: 1, 0xA20E: 99.0}
    tags[0x8825] = PLACE
    return tags.tobytes()


def found(data: bytes) -> tuple[dict[int, object], dict[int, object], dict[int, object]]:
    """Return the directories that Pillow reads."""
    if data[:2] == b"II":  # of which it reads no image in 16 bits and colour
        tags = Image.Exif()
        tags.load(data)
    else:
        with Image.open(io.BytesIO(data)) as file:
            file.load()
            tags = file.getexif()
    return dict(tags), tags.get_ifd(0x8769), tags.get_ifd(0x8825)


@pytest.mark.parametrize("source", ["a.jpg", "a.png", "a.tif"])
@pytest.mark.parametrize(
    ("output", "dtype"),
    [("o.jpg", np.uint8), ("o.png", np.uint8), ("o.png", np.uint16), ("o.tif", np.uint16), ("o.tif", np.float32)],
)
def test_a_photograph_made_of_another_has_its_camera_date_lens_and_place(tmp_path, source, output, dtype):
    Image.fromarray(VALUES).save(tmp_path / source, exif=block())
    read = read_photo(tmp_path / source)
    assert read.values.shape == (36, 24, 3)  # upright
    write_photo(tmp_path / output, read.light(), dtype=dtype, like=read)
    first, lens, place = found((tmp_path / output).read_bytes())
    assert {tag: first.get(tag) for tag in OWN} == OWN
    assert {tag: float(lens[tag]) if isinstance(text, float | TiffImagePlugin.IFDRational) else lens[tag]
            for tag, text in LENS.items()} == LENS  # fmt: skip
    assert set(lens) == set(LENS)  # no notes of the maker, no size of the picture as it lay
    assert place == PLACE
    assert first.get(0x0112, 1) == 1
    assert first.get(0x0131) != "of the camera"
    again = read_photo(tmp_path / output)
    assert again.values.shape == read.values.shape
    assert again.exif == Exif(0.05, 1.8)
    assert read.exif == Exif(0.05, 1.8, pixel=0.0254 / 99.0)
    assert again.exif.block == read.exif.block


def test_damaged_exif_is_left_out_or_refused_and_never_grows(tmp_path):
    rng = np.random.default_rng(1)
    for _ in range(30):
        data = bytearray(block())
        for at in rng.integers(6, len(data), 4):
            data[at] = rng.integers(256)
        Image.fromarray(VALUES).save(tmp_path / "a.png", exif=bytes(data))
        try:
            read = read_photo(tmp_path / "a.png")
        except PhotoError:
            continue
        write_photo(tmp_path / "b.jpg", read.light(), like=read)
        assert len(read.exif.block or b"") < 2 * len(data)
    # Entries that all point to the same bytes.
    entry = struct.pack("<HHII", 0x8769, 4, 1, 26)
    many = b"".join(struct.pack("<HHII", 0x9000 + k, 7, 4000, 26) for k in range(200))
    data = b"II*\0\x08\0\0\0\x01\0" + entry + bytes(4) + struct.pack("<H", 200) + many + bytes(6000)
    assert parsed({}, data, VALUES.shape).block is None


def test_exif_is_left_out_where_it_cannot_be_written(tmp_path):
    with pytest.raises(TypeError, match="like must be"):
        write_photo(tmp_path / "a.png", np.zeros((4, 5)), like=block())
    Image.fromarray(VALUES).save(tmp_path / "a.jpg", exif=block())
    read = read_photo(tmp_path / "a.jpg")
    write_photo(tmp_path / "a.exr", read.light(), encoding="linear", dtype=np.float32, like=read)
    assert [file.name for file in sorted(tmp_path.iterdir())] == ["a.exr", "a.jpg"]


def test_apertures_zooms_and_subject_distances_are_those_of_the_file():
    found = parsed({0x9202: 6.0, 0x9206: 5.0, 0xA404: 2.0}, None, (4, 6))
    assert (found.f_number, found.focus, found.zoom) == (8.0, 5.0, 2.0)
    assert parsed({0x9202: 6.0, 0x829D: 5.6}, None, (4, 6)).f_number == 5.6


def test_the_white_of_12_bits_in_16_is_the_largest_sample_value_that_the_file_states(tmp_path):
    values = np.array([[0, 1000, 2048], [4095, 7, 300]], np.uint16)
    for tags, white in (([(281, 3, 1, 4095, True)], 4095), ([(281, 3, 1, 4095 - 7, True)], 65535), ([], 65535)):
        tifffile.imwrite(tmp_path / "a.tif", values, photometric="minisblack", extratags=tags)
        np.testing.assert_allclose(read_photo(tmp_path / "a.tif", "linear").light(), values / white, atol=1e-5)
