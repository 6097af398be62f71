"""Encodings that files state: ICC profiles, chunks of PNG, EXIF; light by Little CMS and by closed forms."""

from __future__ import annotations

import io
import struct
import zlib

import numpy as np
import pytest
import tifffile
from PIL import Image, ImageCms

import lommel as lm
from lommel.base.encoding import agree, to_light
from lommel.imaging import Photograph, read_photo, write_photo
from lommel.io import icc

LEVELS = np.arange(256, dtype=np.uint8)
RAMP = np.repeat(np.tile(LEVELS, (2, 1))[..., None], 3, axis=2)
X = LEVELS / 255.0


def tag(kind: bytes, form: str, *values: float) -> bytes:
    return kind + bytes(4) + struct.pack(form, *values)


def para(kind: int, *numbers: float) -> bytes:
    return tag(b"para", f">HH{len(numbers)}i", kind, 0, *(round(65536 * number) for number in numbers))


def curv(*levels: int) -> bytes:
    return tag(b"curv", f">I{len(levels)}H", len(levels), *levels)


def profile(*curves: bytes, lut: bool = False, space: bytes = b"XYZ ") -> bytes:
    """Return an ICC profile with the primaries of sRGB, as the specification states it."""
    places = ((0.4361, 0.2225, 0.0139), (0.3851, 0.7169, 0.0971), (0.1431, 0.0606, 0.7141), (0.9642, 1.0, 0.8249))
    xyz = [tag(b"XYZ ", ">3i", *(round(65536 * value) for value in place)) for place in places]
    grey = len(curves) == 1
    tags = {
        b"wtpt": xyz[3],
        b"desc": tag(b"desc", ">I2s", 2, b"a\0") + bytes(78),
        b"cprt": tag(b"text", ">2s", b"a\0"),
    }
    if lut:
        tags[b"A2B0"] = tag(b"mft1", ">I", 0)
    elif grey:
        tags[b"kTRC"] = curves[0]
    else:
        names = (b"rXYZ", b"gXYZ", b"bXYZ", b"rTRC", b"gTRC", b"bTRC")
        tags |= dict(zip(names, [*xyz[:3], *curves], strict=True))
    table, body, start = struct.pack(">I", len(tags)), b"", 132 + 12 * len(tags)
    for name, data in tags.items():
        table += struct.pack(">4sII", name, start + len(body), len(data))
        body += data + bytes(-len(data) % 4)
    space_of_colours = b"GRAY" if grey else b"RGB "
    head = struct.pack(">I4sI4s4s4s12s4s", start + len(body), b"lcms", 0x4200000, b"mntr", space_of_colours,
                       space, struct.pack(">6H", 2026, 1, 1, 0, 0, 0), b"acsp")  # fmt: skip
    head += bytes(28) + xyz[3][8:]
    return head.ljust(128, b"\0") + table + body


def light_by_lcms(values: np.ndarray, icc_profile: bytes) -> np.ndarray:
    """Return the light of 8-bit values: Little CMS converts them to sRGB of 8 bits, which is decoded."""
    source = ImageCms.ImageCmsProfile(io.BytesIO(icc_profile))
    mode = "RGB" if values.ndim == 3 else "L"
    change = ImageCms.buildTransform(source, ImageCms.createProfile("sRGB"), mode, "RGB")
    found = np.asarray(ImageCms.applyTransform(Image.fromarray(values), change)) / 255.0
    found = found if values.ndim == 3 else found[..., 1]
    return np.where(found <= 0.04045, found / 12.92, ((found + 0.055) / 1.055) ** 2.4)


def photo_of(path, values, icc_profile):
    if path.suffix == ".tif":
        tifffile.imwrite(
            path, values, iccprofile=icc_profile, photometric="rgb" if values.ndim == 3 else "minisblack"
        )
    else:
        quality = {"quality": 100, "subsampling": 0} if path.suffix == ".jpg" else {}
        Image.fromarray(values).save(path, icc_profile=icc_profile, **quality)
    return path


CURVES = {
    "gamma 1.0": (curv(), X),
    "gamma 1.8": (curv(round(1.8 * 256)), X ** (461 / 256)),
    "para 0": (para(0, 2.2), X**2.2),
    "para 1": (para(1, 2.2, 1.1, -0.1), np.maximum(1.1 * X - 0.1, 0.0) ** 2.2),
    "para 2": (para(2, 2.2, 0.85, 0.05, 0.08), (0.85 * X + 0.05) ** 2.2 + 0.08),
    "para 3": (para(3, 1 / 0.45, 1 / 1.099, 0.099 / 1.099, 1 / 4.5, 0.081),
               np.where(X < 0.081, X / 4.5, ((X + 0.099) / 1.099) ** (1 / 0.45))),
    "para 4": (para(4, 2.0, 0.9, 0.05, 0.2, 0.1, 0.02, 0.0),
               np.where(X < 0.1, 0.2 * X, (0.9 * X + 0.05) ** 2 + 0.02)),
    "table": (curv(0, 13107, 65535), np.interp(X, [0, 0.5, 1], [0, 0.2, 1])),
}  # fmt: skip


@pytest.mark.parametrize("suffix", ["tif", "png", "jpg"])
@pytest.mark.parametrize("name", CURVES)
def test_tone_curves_of_a_profile_are_applied_and_the_result_has_the_profile(tmp_path, name, suffix):
    curve, wanted = CURVES[name]
    stated = profile(curve, curve, curve)
    found = read_photo(photo_of(tmp_path / f"a.{suffix}", RAMP, stated))
    error = 1e-4 if suffix != "jpg" else 0.03
    assert np.abs(found.light() - wanted[None, :, None]).max() < error
    # Little CMS scales curves that do not start at black; two levels of 8 bits near white are 0.02.
    assert wanted[0] > 0.0 or np.abs(found.light() - light_by_lcms(found.values, stated)).max() < 0.02
    write_photo(tmp_path / "b.tif", found.light(), encoding=found.encoding, dtype=np.uint16, like=found)
    with tifffile.TiffFile(tmp_path / "b.tif") as file:
        assert file.pages[0].iccprofile == stated
    assert np.abs(read_photo(tmp_path / "b.tif").light() - found.light()).max() < 1e-4


def test_grey_and_different_curves_of_channels_are_applied(tmp_path):
    grey = profile(para(0, 1.8))
    found = read_photo(photo_of(tmp_path / "a.png", RAMP[..., 0], grey))
    assert found.encoding == pytest.approx(1.8, abs=1e-5)
    assert np.abs(found.light() - light_by_lcms(found.values, grey)).max() < 0.02
    three = profile(para(0, 1.0), para(0, 1.8), curv(0, 20000, 65535))
    found = read_photo(photo_of(tmp_path / "b.png", np.tile(RAMP, (8, 1, 1)), three))
    wanted = np.stack([X, X**1.8, np.interp(X, [0, 0.5, 1], [0, 20000 / 65535, 1])], axis=-1)
    np.testing.assert_allclose(found.light()[0], wanted, atol=1e-5)
    lens = lm.Lens(focal_length=50e-3, f_number=8.0, focus_distance=1.9, wavelength=550e-9)
    blurred = lm.imaging.depth_of_field(found.values, np.full((16, 256), 1.9), lens, 20e-6, encoding=found.encoding)
    linear = lm.imaging.depth_of_field(found.light(), np.full((16, 256), 1.9), lens, 20e-6, encoding="linear")
    again = to_light("blurred", blurred.values, found.encoding, np.float64)
    assert np.abs(again - linear.values).max() < 0.011  # a level of 8 bits
    with pytest.raises(ValueError, match="encoding has curves of red, green and blue, got values of the shape"):
        to_light("a", RAMP[..., 0], found.encoding, np.float64)


def test_sixteen_bits_that_are_written_by_their_curves_decode_to_the_light(tmp_path):
    light = np.random.default_rng(1).random((4, 5, 3)).astype(np.float32)
    for encoding in (1.8, "linear", 0.5):
        for name in ("a.tif", "a.png"):
            write_photo(tmp_path / name, light, encoding=encoding, dtype=np.uint16)
            found = read_photo(tmp_path / name)
            assert found.stated
            assert agree(found.encoding, encoding)
            assert np.abs(found.light() - light).max() < 1e-4
        write_photo(tmp_path / "a.png", light, encoding=encoding)
        with Image.open(tmp_path / "a.png") as file:
            by_profile = light_by_lcms(np.asarray(file), file.info["icc_profile"])
        assert np.abs(by_profile - light).max() < 0.05
    write_photo(tmp_path / "b.png", light[..., 0], encoding=2.5)
    with Image.open(tmp_path / "b.png") as file:
        assert np.abs(light_by_lcms(np.asarray(file), file.info["icc_profile"]) - light[..., 0]).max() < 0.03


def test_profiles_of_srgb_change_nothing(tmp_path):
    toe = np.linspace(0.0, 1.0, 1024)
    table = np.rint(65535 * np.where(toe <= 0.04045, toe / 12.92, ((toe + 0.055) / 1.055) ** 2.4)).astype(int)
    for k, stated in enumerate((ImageCms.ImageCmsProfile(ImageCms.createProfile("sRGB")).tobytes(),
                                profile(*[curv(*table)] * 3))):  # fmt: skip
        found = read_photo(photo_of(tmp_path / f"{k}.png", RAMP, stated))
        assert (found.encoding, found.stated, found.profile) == ("srgb", True, stated)


@pytest.mark.parametrize(
    ("stated", "message"),
    [
        (profile(b"", lut=True), r"look-up tables \(LUT\)"),
        (profile(para(0, 1.0))[:140], "damaged"),
        (profile(para(9, 1.0)), "unknown type"),
        (profile(para(0, 1.0), space=b"Lab "), "lightness"),
        (profile(curv(65535, 0)), "fall"),
    ],
)
def test_a_profile_that_is_not_applied_is_named(tmp_path, stated, message):
    path = photo_of(tmp_path / "a.tif", RAMP, stated)
    with pytest.warns(UserWarning, match=f"a.tif: its ICC profile .*{message}.*taken as sRGB"):
        assert read_photo(path).profile == stated


def test_encodings_that_contradict_the_file_are_named_and_floats_are_linear(tmp_path):
    path = photo_of(tmp_path / "a.tif", RAMP, profile(*[para(0, 1.8)] * 3))
    with pytest.warns(
        UserWarning, match=r"a.tif states values light = value \*\* 1.8, but .* linear, and its ICC profile was"
    ):
        found = read_photo(path, "linear")
    assert (found.encoding, found.profile) == ("linear", None)
    assert read_photo(path, 1.8).profile is not None
    photo_of(path, (RAMP / 255.0).astype(np.float32), profile(*[para(0, 1.8)] * 3))
    with pytest.warns(UserWarning, match="taken as linear; give their encoding if they are not"):
        assert read_photo(path).light()[0, 128, 0] == pytest.approx(128 / 255)
    assert read_photo(path, 1.8).light()[0, 128, 0] == pytest.approx((128 / 255) ** 1.8)


def with_chunks(**chunks: bytes) -> bytes:
    file = io.BytesIO()
    Image.fromarray(RAMP).save(file, "PNG")
    data, middle = file.getvalue(), b""
    for name, body in chunks.items():
        full = name.encode() + body
        middle += struct.pack(">I", len(body)) + full + struct.pack(">I", zlib.crc32(full))
    return data[:33] + middle + data[33:]


GAMMA = struct.pack(">I", 45455)


@pytest.mark.parametrize(
    ("chunks", "wanted"),
    [
        ({"gAMA": GAMMA}, 2.2),
        ({"gAMA": struct.pack(">I", 100000)}, "linear"),
        ({"gAMA": struct.pack(">I", 55556)}, 1.8),
        ({"gAMA": GAMMA, "sRGB": b"\0"}, "srgb"),
        ({"gAMA": GAMMA, "sRGB": b"\0", "cICP": bytes([1, 8, 0, 1])}, "linear"),
        ({"gAMA": GAMMA, "cICP": bytes([12, 13, 0, 1])}, "srgb"),
        ({"iCCP": b"a\0\0" + zlib.compress(profile(*[para(0, 1.5)] * 3)), "gAMA": GAMMA}, 1.5),
    ],
)
def test_chunks_of_png_state_the_encoding(tmp_path, chunks, wanted):
    (tmp_path / "a.png").write_bytes(with_chunks(**chunks))
    found = read_photo(tmp_path / "a.png")
    assert found.stated
    assert found.encoding == wanted or agree(found.encoding, wanted)
    if wanted != "linear":
        with pytest.warns(UserWarning, match="but they were taken as linear"):
            read_photo(tmp_path / "a.png", "linear")


def test_png_of_a_transfer_function_of_hdr_is_refused(tmp_path):
    (tmp_path / "a.png").write_bytes(with_chunks(cICP=bytes([9, 16, 0, 1])))
    with pytest.raises(lm.imaging.PhotoError, match="HDR"):
        read_photo(tmp_path / "a.png")


def test_exif_states_adobe_rgb_and_gamma(tmp_path):
    for tags, wanted in (({0xA005: {1: "R03"}}, 563 / 256), ({0xA500: 1.8}, 1.8), ({0xA500: 1.8, 0xA001: 1}, "srgb")):
        exif = Image.Exif()
        exif.get_ifd(0x8769).update(tags)
        Image.fromarray(RAMP).save(tmp_path / "a.jpg", exif=exif)
        found = read_photo(tmp_path / "a.jpg")
        assert found.stated
        assert agree(found.encoding, wanted)


def test_an_encoding_is_a_name_or_a_number(tmp_path):
    photo = Photograph(RAMP, 1.8)
    np.testing.assert_allclose(photo.light()[0, :, 0], X**1.8, rtol=1e-5)
    for wrong in ("gamma", 0.01, 11.0):
        with pytest.raises(ValueError, match="encoding must be"):
            Photograph(RAMP, wrong).light()
    with pytest.raises(TypeError, match="encoding must be"):
        Photograph(RAMP, None).light()
    with pytest.raises(ValueError, match=r"must be from 0 to 1 for the curves of an ICC profile, got 1.5"):
        to_light("a", np.array([1.5]), icc.encoding_of(profile(CURVES["table"][0]), grey=True), np.float64)


def test_commands_blur_in_the_light_of_the_profile(tmp_path, call_lommel):
    gamma = 1.8
    scene = np.full((24, 24, 3), 0.05)
    scene[10:14, 10:14] = 0.95
    stated = profile(*[para(0, gamma)] * 3)
    lens = lm.Lens(focal_length=50e-3, f_number=2.0, focus_distance=1.9, wavelength=550e-9)
    depth = np.full((24, 24), 2.4, np.float32)
    np.save(tmp_path / "depth.npy", depth)
    right = lm.imaging.depth_of_field(scene, depth, lens, 20e-6, encoding="linear").values
    (tmp_path / "lens.toml").write_text(
        '[lens]\nfocal_length = "50 mm"\nf_number = 2.0\nfocus_distance = "1.9 m"\nwavelength = "550 nm"\n'
        '[sensor]\npixel = "20 um"\n',
        encoding="utf-8",
    )
    photo_of(tmp_path / "a.tif", np.rint(65535 * scene ** (1 / gamma)).astype(np.uint16), stated)
    run = call_lommel("blur", "a.tif", "depth.npy", "lens.toml", "-o", "b.tif", folder=tmp_path)
    assert run.returncode == 0
    assert "16-bit values, light = value ** 1.8\n" in run.stdout
    spot = right > 0.06
    light = (tifffile.imread(tmp_path / "b.tif") / 65535.0) ** gamma
    assert (light - 0.05)[spot].sum() == pytest.approx((right - 0.05)[spot].sum(), rel=0.01)
    words = ["blur", "a.tif", "depth.npy", "lens.toml", "--encoding", "1.5", "-o", "c.tif"]
    run = call_lommel(*words, folder=tmp_path)
    assert run.returncode == 0
    assert "light = value ** 1.5" in run.stdout
    assert "a.tif states values" in run.stdout
    assert agree(read_photo(tmp_path / "c.tif").encoding, 1.5)
