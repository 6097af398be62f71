"""Photographs and depth maps in files."""

from __future__ import annotations

import io
import struct
import sys
import zlib
from contextlib import nullcontext, suppress

import numpy as np
import pytest
import tifffile
from PIL import Image, ImageCms, ImageOps

import lommel as lm
from lommel import imaging
from lommel.base import reading
from lommel.base.encoding import from_light, to_light
from lommel.imaging import Exif, PhotoError, Photograph, read_depth, read_photo, write_photo
from lommel.io import photos
from lommel.io.photos import stored
from lommel.recorded.frames import RecordingError, read_images

RNG = np.random.default_rng(4)
GREY, COLOUR = (7, 5), (7, 5, 3)


def exif(orientation: int = 1, **lens: object) -> bytes:
    tags = Image.Exif()
    tags[0x0112] = orientation
    numbers = {"focal": 0x920A, "f_number": 0x829D}
    tags[0x8769] = {numbers[name]: value for name, value in lens.items()}
    return tags.tobytes()


@pytest.mark.parametrize("shape", [GREY, COLOUR])
@pytest.mark.parametrize(
    ("name", "dtype"),
    [
        ("a.png", np.uint8),
        ("a.png", np.uint16),
        ("a.tif", np.uint8),
        ("a.tiff", np.uint16),
        ("a.tif", np.float32),
    ],
)
def test_every_level_comes_back(tmp_path, name, dtype, shape):
    light = RNG.random(shape).astype(np.float32)
    encoding = "linear" if dtype == np.float32 else "srgb"
    of_colours = ImageCms.ImageCmsProfile(ImageCms.createProfile("sRGB")).tobytes()
    like = Photograph(light, encoding, profile=of_colours)
    assert write_photo(tmp_path / name, light, encoding=encoding, dtype=dtype, like=like) == 0.0
    with pytest.warns(UserWarning, match="taken as linear") if dtype == np.float32 else nullcontext():
        back = read_photo(tmp_path / name)
    assert (back.encoding, back.values.dtype, back.profile) == (encoding, dtype, of_colours)
    np.testing.assert_array_equal(back.values, from_light(light, encoding, dtype))
    assert np.abs(back.light() - light).max() <= {1: 5e-3, 2: 2e-5, 4: 0.0}[np.dtype(dtype).itemsize]


def test_sixteen_bits_of_colour_are_read_as_other_programs_write_them(tmp_path):
    # Pillow itself keeps eight of them. Filters of every kind, as an encoder chooses row by row.
    values = RNG.integers(0, 65536, (6, 4, 3)).astype(np.uint16)
    rows = values.astype(">u2").view(np.uint8).reshape(6, -1).astype(int)
    left = np.pad(rows, ((0, 0), (6, 0)))[:, :-6]
    up = np.pad(rows, ((1, 0), (0, 0)))[:-1]
    corner = np.pad(left, ((1, 0), (0, 0)))[:-1]
    guess = left + up - corner
    far = np.abs(np.stack([guess - left, guess - up, guess - corner]))
    paeth = np.choose(far.argmin(axis=0), [left, up, corner])
    filters = [0 * rows, left, up, (left + up) // 2, paeth]
    lines = b"".join(
        bytes([y % 5]) + ((rows[y] - filters[y % 5][y]) % 256).astype(np.uint8).tobytes() for y in range(6)
    )

    def chunk(name: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    header = struct.pack(">IIBBBBB", 4, 6, 16, 2, 0, 0, 0)
    body = chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(lines)) + chunk(b"IEND", b"")
    (tmp_path / "a.png").write_bytes(b"\x89PNG\r\n\x1a\n" + body)
    np.testing.assert_array_equal(read_photo(tmp_path / "a.png").values, values)


@pytest.mark.parametrize("orientation", range(1, 9))
@pytest.mark.parametrize("name", ["a.png", "a.jpg", "a.tif"])
def test_a_photo_is_turned_as_its_exif_says(tmp_path, name, orientation):
    picture = Image.fromarray(np.add.outer(np.arange(0, 80, 2), 3 * np.arange(24)).astype(np.uint8))
    picture.save(tmp_path / name, exif=exif(orientation), **({"quality": 100} if name == "a.jpg" else {}))
    picture.save(tmp_path / "reference.png", exif=exif(orientation))
    with Image.open(tmp_path / "reference.png") as file:
        expected = np.asarray(ImageOps.exif_transpose(file)).astype(int)
    found = read_photo(tmp_path / name).values
    assert found.shape == expected.shape
    assert np.abs(found - expected).max() <= (2 if name == "a.jpg" else 0)


@pytest.mark.parametrize("name", ["a.png", "a.jpg", "a.tif"])
def test_exif_tells_the_lens(tmp_path, name):
    picture = Image.new("RGB", (40, 30))
    picture.save(tmp_path / name, exif=exif(focal=4.25, f_number=1.8))
    found = read_photo(tmp_path / name).exif
    assert (found.focal_length, found.f_number) == (pytest.approx(4.25e-3), pytest.approx(1.8))
    picture.save(tmp_path / name, exif=exif(focal=0))
    assert read_photo(tmp_path / name).exif == Exif()


def test_lzw_that_pillow_cannot_unpack_names_the_package(tmp_path, monkeypatch):
    path = tmp_path / "a.tif"
    tifffile.imwrite(path, np.zeros((6, 4, 3), np.float32), photometric="rgb")
    with tifffile.TiffFile(path, mode="r+") as file:
        file.pages[0].tags["Compression"].overwrite(5)
    monkeypatch.setattr(reading, "find_spec", lambda name: None)
    with pytest.raises(PhotoError, match=r"LZW of float32 in colour needs .* pip install imagecodecs, or save the"):
        read_photo(path)


def test_integers_are_srgb_and_floats_linear_unless_one_says_otherwise(tmp_path):
    tifffile.imwrite(tmp_path / "a.tif", np.full(GREY, 128, np.uint8), photometric="minisblack")
    tifffile.imwrite(tmp_path / "b.tif", np.full(GREY, 0.5, np.float32), photometric="minisblack")
    curve = ((128 / 255 + 0.055) / 1.055) ** 2.4
    assert read_photo(tmp_path / "a.tif").light()[0, 0] == pytest.approx(curve)
    assert read_photo(tmp_path / "a.tif", "linear").light()[0, 0] == pytest.approx(128 / 255)
    assert read_photo(tmp_path / "b.tif").light()[0, 0] == 0.5
    assert read_photo(tmp_path / "b.tif", "srgb").light()[0, 0] == pytest.approx(((0.5 + 0.055) / 1.055) ** 2.4)


@pytest.mark.parametrize("order", ["<", ">"])
@pytest.mark.parametrize("planes", ["contig", "separate"])
def test_a_tiff_may_have_either_byte_order_and_either_order_of_planes(tmp_path, order, planes):
    values = RNG.integers(0, 65536, COLOUR).astype(np.uint16)
    stored_as = values if planes == "contig" else np.moveaxis(values, 2, 0)
    tifffile.imwrite(tmp_path / "a.tif", stored_as, byteorder=order, photometric="rgb", planarconfig=planes)
    np.testing.assert_array_equal(read_photo(tmp_path / "a.tif").values, values)


@pytest.mark.parametrize("mode", ["1", "P"])
def test_palettes_and_bits_become_levels(tmp_path, mode):
    picture = Image.fromarray(RNG.integers(0, 2, (8, 8)).astype(np.uint8) * 255).convert(mode)
    picture.save(tmp_path / "a.png")
    np.testing.assert_array_equal(
        read_photo(tmp_path / "a.png").values, np.asarray(picture.convert("L" if mode == "1" else "RGB"))
    )


@pytest.mark.parametrize(("dtype", "levels"), [(np.uint8, 255), (np.uint16, 65535)])
@pytest.mark.parametrize("encoding", ["srgb", "linear"])
def test_what_half_a_level_beyond_white_or_black_is_clipped_and_counted(dtype, levels, encoding):
    top = float(to_light("a", np.array([1.0 + 0.6 / levels]), encoding, np.float64)[0])
    near = float(to_light("a", np.array([1.0 + 0.4 / levels]), encoding, np.float64)[0])
    values, share = stored(np.array([[0.0, 1.0, near, top, 7.0]]), encoding, dtype)
    assert share == pytest.approx(2 / 5)
    assert values.tolist() == [[0, levels, levels, levels, levels]]
    assert stored(np.array([[-1.0, 0.5]]), encoding, dtype)[1] == 0.5
    assert stored(np.array([[7.0, -1.0]]), "linear", np.float32)[0].tolist() == [[7.0, -1.0]]


def png(**options: object) -> bytes:
    buffer = io.BytesIO()
    mode = str(options.pop("mode", "RGB"))
    Image.new(mode, (9, 8)).save(buffer, "png", **options)
    return buffer.getvalue()


def tiff(values: np.ndarray, **options: object) -> bytes:
    buffer = io.BytesIO()
    tifffile.imwrite(buffer, values, **options)
    return buffer.getvalue()


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (b"", "is empty"),
        (b"GIF89a", "is not a PNG, JPEG, TIFF, EXR, BMP or HEIC file"),
        (png()[:43], "cannot be read as a PNG photograph"),
        (png(mode="RGBA"), "it has alpha that is not opaque everywhere; put it on a"),
        (png(mode="LA"), "it has alpha"),
        (png(transparency=(0, 0, 0)), "it has alpha"),
        (png(save_all=True, append_images=[Image.new("RGB", (9, 8), "red")]), "an animation of 2 frames"),
        (tiff(np.zeros((2, 8, 9), np.uint8), photometric="minisblack"), "it holds 2 images, "),
        (tiff(np.zeros((8, 9, 4), np.uint8), photometric="rgb", extrasamples=["unassalpha"]), "it has alpha"),
        (tiff(np.zeros((8, 9), np.uint8), photometric="miniswhite"), "MINISWHITE, neither grey nor RGB"),
        (tiff(np.zeros((8, 9), np.int32), photometric="minisblack"), "int32, neither uint8"),
        (tiff(np.zeros((8, 9), np.uint8), photometric="minisblack")[:120], "cannot be read as a TIFF photograph"),
    ],
)
def test_what_is_no_photograph_is_refused_in_one_line(tmp_path, data, message):
    (tmp_path / "a.png").write_bytes(data)
    with pytest.raises(PhotoError, match=message) as refused:
        read_photo(tmp_path / "a.png")
    assert "\n" not in str(refused.value)
    assert "a.png" in str(refused.value)


@pytest.mark.parametrize("suffix", ["png", "jpg", "tif"])
def test_a_file_cut_off_anywhere_is_never_a_photograph_of_other_values(tmp_path, suffix):
    write_photo(tmp_path / f"a.{suffix}", RNG.random((40, 30, 3)))
    data, whole = (tmp_path / f"a.{suffix}").read_bytes(), read_photo(tmp_path / f"a.{suffix}").values
    for length in range(0, len(data) - 1, max(1, len(data) // 40)):
        (tmp_path / "cut").write_bytes(data[:length])
        with suppress(PhotoError):
            np.testing.assert_array_equal(read_photo(tmp_path / "cut").values, whole)


def chunked(values: np.ndarray, kind: int) -> bytes:
    """A PNG of 16 bits by the standard alone."""

    def chunk(name: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    height, width = values.shape[:2]
    lines = b"".join(b"\0" + np.ascontiguousarray(row).astype(">u2").tobytes() for row in values)
    head = struct.pack(">IIBBBBB", width, height, 16, kind, 0, 0, 0)
    parts = (b"IHDR", head), (b"IDAT", zlib.compress(lines)), (b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + b"".join(chunk(*part) for part in parts)


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16, np.float32])
@pytest.mark.parametrize("suffix", ["png", "tif"])
@pytest.mark.parametrize("colour", [True, False])
def test_alpha_that_is_opaque_everywhere_is_left_out(tmp_path, dtype, suffix, colour):
    if suffix == "png" and dtype == np.float32:
        return
    full = 1.0 if dtype == np.float32 else np.iinfo(dtype).max
    own = RNG.integers(0, 256, (7, 5, 3 if colour else 1)).astype(dtype) / dtype(full if dtype == np.float32 else 1)
    stored = np.concatenate([own * 1, np.full((7, 5, 1), full)], axis=2).astype(dtype)
    # Of 16 bits one has the highest byte, the other the lowest.
    for alpha in (full, 0.999 if dtype == np.float32 else full - 1, full - 256 if dtype == np.uint16 else 0):
        stored[6, 4, -1] = alpha
        path = tmp_path / f"a.{suffix}"
        if suffix == "tif":
            tifffile.imwrite(
                path, stored, photometric="rgb" if colour else "minisblack", extrasamples=["unassalpha"],
                planarconfig="contig",
            )  # fmt: skip
        elif dtype == np.uint16:
            path.write_bytes(chunked(stored, 6 if colour else 4))
        else:
            Image.fromarray(stored, None if colour else "LA").save(path)
        if alpha == full:
            found = read_photo(path).values
            assert found.dtype == dtype
            np.testing.assert_array_equal(found, own if colour else own[..., 0])
        else:
            with pytest.raises(PhotoError, match=r"is not opaque everywhere; .* magick IN -background black"):
                read_photo(path)


@pytest.mark.parametrize("mode", ["P", "RGB", "L"])
def test_a_transparent_colour_that_no_pixel_has_is_no_alpha(tmp_path, mode):
    picture = Image.fromarray(RNG.integers(0, 200, (8, 8)).astype(np.uint8)).convert(mode)
    absent = {"P": bytes(256 * [255]), "RGB": (255, 3, 7), "L": 233}[mode]
    picture.save(tmp_path / "a.png", transparency=absent)
    np.testing.assert_array_equal(
        read_photo(tmp_path / "a.png").values, np.asarray(picture.convert("RGB" if mode == "P" else mode))
    )
    present = {"P": bytes(256), "RGB": picture.convert("RGB").getpixel((2, 3)), "L": picture.getpixel((2, 3))}[mode]
    picture.save(tmp_path / "a.png", transparency=present)
    with pytest.raises(PhotoError, match="is not opaque everywhere"):
        read_photo(tmp_path / "a.png")


def test_a_bmp_is_read(tmp_path):
    values = RNG.integers(0, 256, (40, 30, 3)).astype(np.uint8)
    for one in (values, values[..., 0], values[..., 0] > 128):
        Image.fromarray(one).save(tmp_path / "a.bmp")
        np.testing.assert_array_equal(read_photo(tmp_path / "a.bmp").values, one * (255 if one.dtype == bool else 1))


def test_a_bmp_that_is_cut_off_is_refused(tmp_path):
    Image.new("RGB", (9, 8), "red").save(tmp_path / "c.bmp")
    (tmp_path / "c.bmp").write_bytes((tmp_path / "c.bmp").read_bytes()[:-9])
    with pytest.raises(PhotoError, match="truncated"):
        read_photo(tmp_path / "c.bmp")


def test_heic_is_read_by_the_package_that_can(tmp_path, monkeypatch):
    heif = pytest.importorskip("pillow_heif")
    smooth = np.stack([np.add.outer(np.arange(64), c * np.arange(48)) for c in (1, 2, 3)], axis=2).astype(np.uint8)
    heif.from_pillow(Image.fromarray(smooth)).save(tmp_path / "a.heic", quality=95, exif=exif(6, focal=4.25))
    found = read_photo(tmp_path / "a.heic")
    assert np.abs(found.values.astype(int) - np.rot90(smooth, -1)).mean() < 3.0
    assert found.exif.focal_length == pytest.approx(4.25e-3)
    heif.from_pillow(Image.fromarray(smooth)).save(tmp_path / "b.heic", quality=95)
    assert np.abs(read_photo(tmp_path / "b.heic").values.astype(int) - smooth).mean() < 3.0
    for name in ("pillow_heif", "pillow_heif.as_plugin"):
        monkeypatch.setitem(sys.modules, name, None)
    with pytest.raises(ImportError, match=r"the format HEIC needs pillow_heif: pip install pillow-heif"):
        read_photo(tmp_path / "a.heic")


def test_cmyk_is_refused(tmp_path):
    Image.new("CMYK", (9, 8)).save(tmp_path / "a.jpg")
    with pytest.raises(PhotoError, match="its colours are CMYK, neither grey nor RGB"):
        read_photo(tmp_path / "a.jpg")


@pytest.mark.parametrize(
    ("name", "light", "options", "message"),
    [
        ("a.gif", np.zeros(GREY), {}, "path must end in .png, .jpg, .jpeg, .tif, .tiff"),
        ("a.jpg", np.zeros(GREY), {"dtype": np.uint16}, "path must end in .png, .tif, .tiff for a photograph"),
        ("a.png", np.zeros(GREY), {"dtype": np.float32}, "path must end in .tif, .tiff, .exr for a photograph"),
        ("a.png", np.zeros(GREY), {"dtype": np.int16}, "dtype must be uint8, uint16 or float32"),
        ("a.png", np.zeros((7, 5, 4)), {}, "light must have the shape"),
        ("a.png", np.full(GREY, np.nan), {}, "light must be finite, got nan"),
        ("a.png", np.zeros(GREY), {"encoding": "gamma"}, "encoding must be one of"),
    ],
)
def test_what_cannot_be_written_leaves_nothing(tmp_path, name, light, options, message):
    with pytest.raises((ValueError, TypeError), match=message):
        write_photo(tmp_path / name, light, **options)
    assert not list(tmp_path.iterdir())


DEPTH = np.array([[1.0, 2.5, 4.0], [8.0, 0.5, 1.5]])


def test_depth_comes_in_metres_from_every_format(tmp_path):
    np.save(tmp_path / "a.npy", DEPTH)
    tifffile.imwrite(tmp_path / "a.tif", DEPTH.astype(np.float32), photometric="minisblack")
    for order in ("<", ">"):
        header = f"Pf\n3 2\n{-1.0 if order == '<' else 1.0}\n".encode()
        (tmp_path / f"{ord(order)}.pfm").write_bytes(header + DEPTH[::-1].astype(f"{order}f4").tobytes())
    Image.fromarray((DEPTH * 1000).astype(np.uint16)).save(tmp_path / "a.png")
    for path in tmp_path.iterdir():
        found = read_depth(path, scale=1e-3 if path.suffix == ".png" else None)
        np.testing.assert_allclose(found, DEPTH, rtol=1e-12, err_msg=str(path))


def test_zero_is_unknown_only_where_one_says_so(tmp_path):
    levels = np.array([[0, 1000], [2000, 0]], np.uint16)
    Image.fromarray(levels).save(tmp_path / "a.png")
    with pytest.raises(ValueError, match=r"is 0 at 2 of 4 points; if .*, state it as `unknown`"):
        read_depth(tmp_path / "a.png", scale=1e-3)
    found = read_depth(tmp_path / "a.png", scale=1e-3, unknown=0)
    np.testing.assert_array_equal(found, [[np.nan, 1.0], [2.0, np.nan]])


def npy(values: np.ndarray) -> bytes:
    buffer = io.BytesIO()
    np.save(buffer, values, allow_pickle=True)
    return buffer.getvalue()


@pytest.mark.parametrize(
    ("data", "options", "message"),
    [
        (npy(np.ones((2, 3), np.uint16)), {}, "is an integer image; give the scale, e.g. scale=0.001 for"),
        (npy(np.ones((2, 3), object)), {}, "cannot be read as a depth map"),
        (npy(np.ones((2, 3), complex)), {}, "holds complex128"),
        (npy(np.ones((2, 3, 3))), {}, r"shape \(2, 3, 3\); a depth map has"),
        (npy(np.ones((2, 3)))[:-4], {}, "cannot be read as a depth map"),
        (npy(-np.ones((2, 3))), {}, "must hold distances > 0 metres, got -1"),
        (npy(np.ones((2, 3))), {"scale": 0.0}, "scale must be >= 1e-12"),
        (b"Pf\n3 2\n-1\n" + bytes(20), {}, "3 x 2 values take 24 bytes, got 20"),
        (b"PF\n3 2\n-1\n" + bytes(72), {}, "it is in colour"),
        (b"Pf\n3 2\n-0.5\n" + bytes(24), {}, "its header states the scale -0.5"),
        (b"Pf\nthree", {}, "its header is not that of a PFM file"),
        (b"P5\n3 2\n255\n", {}, "is not a NPY, PFM, TIFF, PNG or EXR file"),
        (b"", {}, "is empty"),
        (b"\xff\xd8\xff\xe0", {}, "is a JPEG, which does not preserve depth; save it as TIFF or 16-bit PNG"),
    ],
)
def test_what_is_no_depth_map_is_refused_by_name(tmp_path, data, options, message):
    (tmp_path / "depth.bin").write_bytes(data)
    with pytest.raises(ValueError, match=message) as refused:
        read_depth(tmp_path / "depth.bin", **options)
    assert "\n" not in str(refused.value)


def preview(**options) -> bytes:
    """A TIFF of one page, as some raw photographs begin."""
    buffer = io.BytesIO()
    tifffile.imwrite(buffer, np.zeros((12, 16), np.uint8), metadata=None, **options)
    return buffer.getvalue()


def raw_photograph(**first) -> bytes:
    """A TIFF as cameras write them: a preview, and below it the mosaic."""
    buffer = io.BytesIO()
    with tifffile.TiffWriter(buffer) as file:
        file.write(np.zeros((12, 16, 3), np.uint8), photometric="rgb", subifds=1, metadata=None, **first)
        file.write(np.zeros((48, 64), np.uint16), photometric=32803, metadata=None, subfiletype=0)
    return buffer.getvalue()


@pytest.mark.parametrize(
    ("name", "data"),
    [
        ("a.tif", raw_photograph(subfiletype=1)),
        ("a.tif", raw_photograph()),
        ("a.tif", raw_photograph(extratags=[(50706, 1, 4, b"\1\4\0\0", True)])),
        ("a.tif", preview(subfiletype=1)),
        ("a.tif", preview(extratags=[(50706, 1, 4, b"\1\4\0\0", True)])),
        ("a.tif", preview(photometric=32803)),
        ("a.nef", raw_photograph()),
        ("a.RW2", b"IIU\0" + bytes(99)),
        ("a.raf", b"junk"),
        ("a.jpg", b"FUJIFILMCCD-RAW 0201"),
        ("a.jpg", bytes(4) + b"ftypcrx " + bytes(99)),
    ],
)
def test_a_raw_photograph_is_never_read_as_its_preview(name, data, tmp_path):
    (tmp_path / name).write_bytes(data)
    with pytest.raises(PhotoError, match="is a raw photograph, not a depth map"):
        imaging.read_depth(tmp_path / name)
    pytest.importorskip("rawpy")
    with pytest.raises(PhotoError, match="cannot be read as a raw photograph: "):
        imaging.read_photo(tmp_path / name)
    with pytest.raises(RecordingError, match="a\\."):
        read_images([tmp_path / name])


def jpeg(path, exif: bytes) -> None:
    buffer = io.BytesIO()
    Image.fromarray(np.full((8, 8), 90, np.uint8)).save(buffer, format="jpeg", exif=exif)
    path.write_bytes(buffer.getvalue())


@pytest.mark.parametrize("orientation", [0, 9, 255])
def test_an_orientation_that_has_no_meaning_is_refused(tmp_path, orientation):
    exif = Image.Exif()
    exif[0x0112] = orientation
    jpeg(tmp_path / "turned.jpg", exif.tobytes())
    with pytest.raises(photos.PhotoError, match=f"orientation {orientation}; 1 to 8"):
        photos.read_photo(tmp_path / "turned.jpg")
    exif[0x0112] = 8
    jpeg(tmp_path / "good.jpg", exif.tobytes())
    assert photos.read_photo(tmp_path / "good.jpg").values.shape == (8, 8)


exr = pytest.importorskip("OpenEXR")


def write(path, channels, **header):
    with exr.File({"compression": exr.PIZ_COMPRESSION, "type": exr.scanlineimage} | header, channels) as file:
        file.write(str(path))


@pytest.mark.parametrize("shape", [(7, 11), (7, 11, 3)])
def test_photographs_come_back_and_are_those_that_the_library_reads(tmp_path, shape):
    light = np.random.default_rng(0).normal(size=shape).astype(np.float32)
    assert lm.imaging.write_photo(tmp_path / "a.exr", light, encoding="linear", dtype=np.float32) == 0.0
    again = lm.imaging.read_photo(tmp_path / "a.exr")
    assert again.encoding == "linear"
    assert np.array_equal(again.values, light)
    with exr.File(str(tmp_path / "a.exr")) as file:
        assert np.array_equal(file.channels()["RGB" if len(shape) == 3 else "Y"].pixels, light)


def test_halves_are_read_and_depth_maps_keep_what_is_unknown(tmp_path):
    light = np.random.default_rng(0).random((5, 6, 3)).astype(np.float16)
    write(tmp_path / "half.exr", {"RGB": light})
    assert np.array_equal(lm.imaging.read_photo(tmp_path / "half.exr").values, light.astype(np.float32))
    depth = np.linspace(0.5, 9.0, 30).reshape(5, 6)
    depth[0, :2] = np.inf, np.nan
    lm.imaging.write_depth(tmp_path / "z.exr", depth)
    assert np.array_equal(lm.imaging.read_depth(tmp_path / "z.exr"), depth.astype(np.float32), equal_nan=True)
    rendered = {"RGB": light.astype(np.float32), "Z": depth.astype(np.float32)}
    write(tmp_path / "all.exr", rendered)
    assert np.array_equal(lm.imaging.read_depth(tmp_path / "all.exr"), depth.astype(np.float32), equal_nan=True)


def test_other_channels_cropped_windows_and_damage_are_refused(tmp_path, capsys):
    light = np.zeros((5, 6, 4), np.float32)
    write(tmp_path / "alpha.exr", {"RGBA": light})
    with pytest.raises(
        lm.imaging.PhotoError, match="alpha channel that is not 1 everywhere; composite it onto a background"
    ):
        lm.imaging.read_photo(tmp_path / "alpha.exr")
    write(tmp_path / "two.exr", {"U": light[..., 0], "V": light[..., 1]})
    with pytest.raises(lm.imaging.PhotoError, match="channels are U, V, neither R, G, B nor Y"):
        lm.imaging.read_photo(tmp_path / "two.exr")
    coloured = np.random.default_rng(1).random((5, 6, 3)).astype(np.float32)
    write(tmp_path / "coloured.exr", {"RGB": coloured})
    for name in ("two.exr", "coloured.exr"):
        with pytest.raises(lm.imaging.PhotoError, match="a depth map has one, or one named Z"):
            lm.imaging.read_depth(tmp_path / name)
    corners = (np.array([0, 0], np.int32), np.array([9, 9], np.int32))
    write(tmp_path / "part.exr", {"Y": light[..., 0]}, displayWindow=corners)
    with pytest.raises(lm.imaging.PhotoError, match="save it uncropped"):
        lm.imaging.read_photo(tmp_path / "part.exr")
    data = (tmp_path / "alpha.exr").read_bytes()
    for count in (8, 60, 330, len(data) - 5):
        (tmp_path / "short.exr").write_bytes(data[:count])
        with pytest.raises(lm.imaging.PhotoError):
            lm.imaging.read_depth(tmp_path / "short.exr")
    (tmp_path / "flipped.exr").write_bytes(data[:-40] + bytes(byte ^ 255 for byte in data[-40:]))
    with pytest.raises(lm.imaging.PhotoError, match=r"flipped\.exr .*: its pixels are damaged: Unable to query"):
        lm.imaging.read_depth(tmp_path / "flipped.exr")
    assert capsys.readouterr().out == ""


def test_opaque_alpha_depth_beside_grey_in_three_channels_and_layers_are_read(tmp_path):
    light = np.random.default_rng(0).random((5, 6, 4)).astype(np.float32)
    light[..., 3] = 1.0
    depth = np.linspace(0.5, 9.0, 30, dtype=np.float32).reshape(5, 6)
    write(tmp_path / "opaque.exr", {"RGBA": light, "Z": depth})
    assert np.array_equal(lm.imaging.read_photo(tmp_path / "opaque.exr").values, light[..., :3])
    assert np.array_equal(lm.imaging.read_depth(tmp_path / "opaque.exr"), depth)
    write(tmp_path / "grey.exr", {"RGB": np.repeat(depth[..., None], 3, axis=2)})
    assert np.array_equal(lm.imaging.read_depth(tmp_path / "grey.exr"), depth)
    layers = {f"ViewLayer.Combined.{name}": light[..., k] for k, name in enumerate("RGBA")}
    write(tmp_path / "layers.exr", layers | {"ViewLayer.Depth.Z": depth})
    assert np.array_equal(lm.imaging.read_depth(tmp_path / "layers.exr"), depth)
