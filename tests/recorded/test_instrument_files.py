"""Files as microscopes and cameras write them: axes, lengths, channels, values, or an error that names the file."""

from __future__ import annotations

import struct
import sys
from importlib.util import find_spec
from types import ModuleType, SimpleNamespace

import numpy as np
import pytest
import tifffile

from lommel.imaging import read_photo
from lommel.io.photos import PhotoError
from lommel.recorded.frames import RecordingError, Unusable, open_frames

RNG = np.random.default_rng(5)
STACK = RNG.integers(0, 60000, (2, 3, 2, 6, 8), np.uint16)  # along T, Z, C, Y, X


def variant(values) -> str:
    """Values as XML of Nikon's version 2."""
    kinds = {bool: "bool", int: "lx_uint32", float: "double", str: "CLxStringW"}
    return "".join(
        f'<{name} runtype="CLxLiteVariant">{variant(value)}</{name}>'
        if isinstance(value, dict)
        else f'<{name} runtype="{kinds[type(value)]}" value="{value}"/>'
        for name, value in values.items()
    )


def write_nd2(path, frames, loops=(), calibrated=True, **metadata):
    """An ND2 of version 2.1, frames (n, height, width, channels)."""
    count, height, width, channels = frames.shape
    planes = {
        f"a{k}": {
            "sDescription": f"dye {k}",
            "uiCompCount": 1,
            "uiSampleIndex": k,
            "pFluorescentProbe": {
                f"m_{name}Spectrum": {
                    "uiCount": 1,
                    "pPoint": {"Point0": {"dTValue": 1.0, "dWavelength": wave, "eType": 2}},
                }
                for name, wave in (("Excitation", 488.0 + 50 * k), ("Emission", 520.0 + 50 * k))
            },
        }
        for k in range(channels)
    }
    picture = {"bCalibrated": calibrated, "dCalibration": 0.108, "dObjectiveMag": 60.0, "dObjectiveNA": 1.4}
    picture |= {"dRefractIndex1": 1.515, "sPicturePlanes": {"uiCount": channels, "sPlaneNew": planes}} | metadata
    size = {"uiWidth": width, "uiHeight": height, "uiWidthBytes": 2 * width * channels, "uiComp": channels}
    size |= {"uiBpcInMemory": 16, "uiBpcSignificant": 16, "uiSequenceCount": count, "eCompression": 2}
    experiment: dict = {}
    for kind, parameters in loops[::-1]:
        inner = {"ppNextLevelEx": {"i0000000000": experiment}} if experiment else {}
        experiment = {"eType": kind, "uLoopPars": parameters} | inner
    chunks = {"ImageAttributes!": size, "ImageMetadataSeq|0!": picture} | (
        {"ImageMetadata!": experiment} if loops else {}
    )
    data = {
        name: f'<variant version="1.0"><no_name runtype="CLxListVariant">{variant(one)}</no_name></variant>'.encode()
        for name, one in chunks.items()
    }
    data |= {f"ImageDataSeq|{k}!": bytes(8) + frame.astype("<u2").tobytes() for k, frame in enumerate(frames)}
    file = bytearray(
        struct.pack("<IIQ", 0x0ABECEDA, 32, 64) + b"ND2 FILE SIGNATURE CHUNK NAME01!" + b"Ver2.1".ljust(64, b"\0")
    )
    entries = b""
    for name, body in data.items():
        entries += name.encode() + struct.pack("<QQ", len(file), len(body))
        file += struct.pack("<IIQ", 0x0ABECEDA, 4072, len(body)) + name.encode().ljust(4072, b"\0") + body
    start, end = len(file), b"ND2 CHUNK MAP SIGNATURE 0000001!"
    entries += end + struct.pack("<Q", start)
    file += struct.pack("<IIQ", 0x0ABECEDA, 32, len(entries)) + b"ND2 FILEMAP SIGNATURE NAME 0001!" + entries
    path.write_bytes(file)


Z_LOOP = (
    4,
    {"uiCount": 3, "dZLow": 0.0, "dZHigh": 0.6, "dZStep": 0.3, "iType": 1, "bAbsolute": False, "dZHome": 0.3},
)
T_LOOP = (1, {"uiCount": 2, "dStart": 0.0, "dPeriod": 5.0, "dDuration": 10.0})


def test_a_nikon_stack_has_its_axes_lengths_and_objective(tmp_path):
    pytest.importorskip("nd2")
    frames = np.moveaxis(STACK, 2, -1).reshape(6, 6, 8, 2)
    write_nd2(tmp_path / "a.nd2", frames, [T_LOOP, Z_LOOP])
    with open_frames(tmp_path / "a.nd2") as found:
        assert (found.axes, found.shape) == ("TZCYX", STACK.shape)
        assert np.array_equal(found[...], STACK)
        assert np.array_equal(found[1, 2, 0, 1:3], STACK[1, 2, 0, 1:3])
        channels = found.as_channels(time=1)
    assert np.array_equal(channels.numbers.shape, (2, 3))
    used = channels.metadata
    assert (used["pixel"], used["step"]) == pytest.approx((0.108e-6, 0.3e-6))
    assert (used["NA"], used["magnification"], used["immersion"]) == (1.4, 60.0, 1.515)
    assert used["names"] == ("dye 0", "dye 1")
    assert used["emission"] == pytest.approx((520e-9, 570e-9))
    assert used["excitation"] == pytest.approx((488e-9, 538e-9))
    assert "From the ND2 metadata of the file: 108 nm pixels, 300 nm planes apart." in channels.notes


def test_positions_of_a_nikon_file_are_images_by_name(tmp_path):
    pytest.importorskip("nd2")
    points = {f"i{k:010}": {"dPosX": 9.0 * k, "dPosY": 0.0, "dPosName": f"well {k}"} for k in range(3)}
    write_nd2(
        tmp_path / "a.nd2", STACK.reshape(12, 6, 8)[:6, ..., None], [T_LOOP, (2, {"uiCount": 3, "Points": points})]
    )
    with pytest.raises(RecordingError, match=r"it holds 3 images, \[well 0\] of 2 T x 6 Y x 8 X, .*: name one"):
        open_frames(tmp_path / "a.nd2")
    for name in ("well 2", "2"):
        with open_frames(tmp_path / f"a.nd2[{name}]") as found:
            assert found.axes == "TYX"
            assert np.array_equal(found[...], STACK.reshape(12, 6, 8)[[2, 5]])


def test_a_nikon_file_that_is_not_calibrated_states_no_pixel(tmp_path):
    pytest.importorskip("nd2")
    write_nd2(tmp_path / "a.nd2", np.moveaxis(STACK[0, :1], 1, -1), calibrated=False)
    with open_frames(tmp_path / "a.nd2") as found:
        assert (found.axes, found.shape) == ("CYX", (2, 6, 8))
        assert found.metadata["pixel"] is found.metadata["step"] is None
    write_nd2(tmp_path / "b.nd2", np.zeros((2, 6, 8, 1)), [(1, {**T_LOOP[1], "uiCount": 3})])
    with open_frames(tmp_path / "b.nd2") as found:
        assert not found[1].any()
        with pytest.raises(RecordingError, match="image 2: it is missing: the recording was stopped"):
            found[2]
    data = (tmp_path / "a.nd2").read_bytes()
    (tmp_path / "cut.nd2").write_bytes(data[:-2000])
    with pytest.raises(RecordingError, match=r"cut\.nd2: "):
        open_frames(tmp_path / "cut.nd2")


def write_lif(path, images):
    """A LIF of version 2: images by name as (sizes by number of the axis, values, length of an axis in metres)."""
    elements, blocks = "", b""
    for k, (name, (dims, values)) in enumerate(images.items()):
        step, described = values.itemsize, ""
        for number, (count, extent) in dims.items():
            origin = 500e-9 if number == 5 else 0.0  # metres: a sweep of wavelengths
            described += (
                f'<DimensionDescription DimID="{number}" NumberOfElements="{count}" Origin="{origin}" '
                f'Length="{extent}" Unit="m" BitInc="0" BytesInc="{step}"/>'
            )
            step *= count
        channels = values.nbytes // step
        listed = "".join(
            '<ChannelDescription DataType="0" ChannelTag="0" Resolution="16" NameOfMeasuredQuantity="" Min="0" '
            f'Max="1" Unit="" LUTName="{name}" IsLUTInverted="0" BytesInc="{c * step}" BitInc="0"/>'
            for c, name in enumerate(("Green", "Red")[:channels])
        )
        elements += (
            f'<Element Name="{name}" UniqueID="{k}"><Data><Image><ImageDescription><Channels>{listed}</Channels>'
            f"<Dimensions>{described}</Dimensions></ImageDescription>"
            '<Attachment Name="HardwareSetting"><ATLConfocalSettingDefinition NumericalAperture="1.3" '
            'Magnification="63" RefractionIndex="1.46" PinholeAiry="1"/></Attachment></Image></Data>'
            f'<Memory Size="{values.nbytes}" MemoryBlockID="MemBlock_{k}"/><Children/></Element>'
        )
        identity = f"MemBlock_{k}"
        head = (
            b"*"
            + struct.pack("<Q", values.nbytes)
            + b"*"
            + struct.pack("<I", len(identity))
            + identity.encode("utf-16-le")
        )
        blocks += struct.pack("<II", 0x70, len(head)) + head + values.tobytes()
    text = (
        '<LMSDataContainerHeader Version="2"><Element Name="all" UniqueID="all"><Data/>'
        f'<Memory Size="0" MemoryBlockID="none"/><Children>{elements}</Children></Element></LMSDataContainerHeader>'
    )
    head = b"*" + struct.pack("<I", len(text)) + text.encode("utf-16-le")
    path.write_bytes(struct.pack("<II", 0x70, len(head)) + head + blocks)


def test_a_leica_file_names_its_images_and_has_steps_of_its_axes(tmp_path):
    pytest.importorskip("liffile")
    stack = np.ascontiguousarray(np.moveaxis(STACK[0], 1, 0))  # along C, Z, Y, X: channels have the longest stride
    sweep = STACK[0, :, 0]
    sizes = {1: (8, 7 * 0.1e-6), 2: (6, 5 * 0.1e-6)}
    images = {"bead": (sizes | {3: (3, 2 * 0.25e-6)}, stack), "sweep": (sizes | {5: (3, 20e-9)}, sweep)}
    write_lif(tmp_path / "a.lif", images | {"xz": ({1: (8, 1e-6), 3: (6, 1e-6)}, sweep[0])})
    with pytest.raises(RecordingError, match=r"it holds 3 images, \[bead\] of .*, \[sweep\] of .*: name one"):
        open_frames(tmp_path / "a.lif")
    with open_frames(tmp_path / "a.lif[bead]") as found:
        channels = found.as_channels()
        assert np.array_equal(channels[...], stack)
    used = channels.metadata
    assert (used["pixel"], used["step"]) == pytest.approx((0.1e-6, 0.25e-6))
    assert (used["NA"], used["magnification"], used["immersion"]) == (1.3, 63.0, 1.46)
    assert (used["names"], used["modality"]) == (("Green", "Red"), ("confocal", "PinholeAiry 1"))
    with open_frames(tmp_path / "a.lif[sweep]") as found:
        channels = found.as_channels()
    assert channels.metadata["emission"] == pytest.approx((500e-9, 510e-9, 520e-9))
    assert channels.metadata["names"] == ("500 nm", "510 nm", "520 nm")
    with pytest.raises(RecordingError, match="its axes are ZX: images of rows"):
        open_frames(tmp_path / "a.lif[xz]")
    (tmp_path / "cut.lif").write_bytes((tmp_path / "a.lif").read_bytes()[:-700])
    with pytest.raises(RecordingError, match=r"cut\.lif: "), open_frames(tmp_path / "cut.lif[0]") as found:
        found[...]


def test_a_zeiss_file_has_its_axes_scales_and_scenes(tmp_path):
    czi = pytest.importorskip("pylibCZIrw.czi")
    with czi.create_czi(str(tmp_path / "a.czi")) as file:
        for t, z, c in np.ndindex(2, 3, 2):
            file.write(data=STACK[t, z, c], plane={"T": t, "Z": z, "C": c})
        file.write_metadata("a", channel_names={0: "DAPI", 1: "GFP"}, scale_x=0.1e-6, scale_y=0.1e-6, scale_z=0.3e-6)
    with open_frames(tmp_path / "a.czi") as found:
        assert (found.axes, found.shape) == ("TCZYX", (2, 2, 3, 6, 8))
        channels = found.as_channels(time=1)
        assert np.array_equal(channels[...], np.moveaxis(STACK[1], 1, 0))
    assert (channels.metadata["pixel"], channels.metadata["step"]) == pytest.approx((0.1e-6, 0.3e-6))
    assert channels.metadata["names"] == ("DAPI", "GFP")
    assert channels.metadata["NA"] is channels.metadata["emission"][0] is None
    with czi.create_czi(str(tmp_path / "two.czi")) as file:
        for scene in (0, 1):
            file.write(data=STACK[scene, 0, 0], location=(20 * scene, 5), scene=scene)
    with pytest.raises(RecordingError, match=r"it holds 2 images, \[0\] of 6 x 8, \[1\] of 6 x 8: name one"):
        open_frames(tmp_path / "two.czi")
    with open_frames(tmp_path / "two.czi[1]") as found:
        assert np.array_equal(found[...], STACK[1, 0, 0])
        assert found.metadata["pixel"] == Unusable("0 m")  # as the library writes an unknown scale
    with czi.create_czi(str(tmp_path / "colour.czi")) as file:
        file.write(data=np.zeros((6, 8, 3), np.uint8))
    with pytest.raises(RecordingError, match="its channels are Bgr24: save channels in grey"):
        open_frames(tmp_path / "colour.czi")
    (tmp_path / "cut.czi").write_bytes((tmp_path / "a.czi").read_bytes()[:3000])
    with pytest.raises(RecordingError, match=r"cut\.czi: "), open_frames(tmp_path / "cut.czi") as found:
        found[...]


def rational(tag, *values):
    return (tag, 5, len(values) // 2, values, True)


def write_dng(path, mosaic, **changed):
    """A DNG of a mosaic RG/GB with the black level 256 and the white level 4095, of a lens of 50 mm."""
    options = {"black": (256, 256, 256, 256), "cfa": bytes([0, 1, 1, 2])} | changed
    tags = [
        (50706, 1, 4, b"\1\4\0\0", True),
        (50708, 2, 4, "own", True),
        (33421, 3, 2, (2, 2), True),
        (33422, 1, 4, options["cfa"], True),
        (50713, 3, 2, (2, 2), True),
        (50714, 3, 4, options["black"], True),
        (50717, 3, 1, 4095, True),
        (50721, 10, 9, [v for k in range(9) for v in (int(k % 4 == 0), 1)], True),
        rational(50728, 1, 2, 1, 1, 1, 2),
    ]
    tifffile.imwrite(path, mosaic, photometric=32803, subfiletype=0, metadata=None, extratags=tags)


def mosaic_of(red, green, blue, shape=(40, 60)):
    """Counts of one scene colour, with the black level."""
    values = np.full(shape, 256 + green, np.uint16)
    values[::2, ::2], values[1::2, 1::2] = 256 + red, 256 + blue
    return values


def test_each_colour_of_a_raw_photograph_is_an_image_less_its_black_level(tmp_path):
    pytest.importorskip("rawpy")
    mosaic = mosaic_of(400, 800, 200)
    mosaic[20, 30], mosaic[20, 31] = 256 + 900, 100
    write_dng(tmp_path / "a.dng", mosaic, black=(256, 240, 248, 200))
    with pytest.raises(RecordingError, match=r"it holds 3 images, \[R\] of 40 x 60, \[G\] .*, \[B\] .*: name one"):
        open_frames(tmp_path / "a.dng")
    black = np.array([[256.0, 240.0], [248.0, 200.0]])
    for name, places in (("R", [(0, 0)]), ("G", [(0, 1), (1, 0)]), ("2", [(1, 1)])):
        found = open_frames(tmp_path / f"a.dng[{name}]")
        expected = np.full(mosaic.shape, np.nan)
        for i, j in places:
            expected[i::2, j::2] = mosaic[i::2, j::2] - black[i, j]  # also below black
        assert np.array_equal(found[...], expected, equal_nan=True)
        assert found.metadata["saturation"] == 4095 - black[places[0]]
    assert "The black level 200 was subtracted; the white level is 4095." in found.notes[0]


def test_a_raw_photograph_is_linear_rgb_in_the_balance_of_the_camera(tmp_path):
    pytest.importorskip("rawpy")
    write_dng(tmp_path / "a.dng", mosaic_of(400, 800, 400))
    photograph = read_photo(tmp_path / "a.dng")
    assert (photograph.values.dtype, photograph.values.shape) == (np.uint16, (40, 60, 3))
    assert photograph.stated
    light = photograph.light()[10:-10, 10:-10]
    assert np.ptp(light, axis=(0, 1)).max() < 1e-3
    write_dng(tmp_path / "half.dng", mosaic_of(200, 400, 200))
    half = read_photo(tmp_path / "half.dng").light()[10:-10, 10:-10]
    assert light == pytest.approx(2.0 * half, rel=2e-3)
    assert light.mean((0, 1)) == pytest.approx(light.mean(), rel=0.02)  # as red and blue of half a neutral grey


def test_a_raw_photograph_that_is_cut_off_is_refused(tmp_path):
    pytest.importorskip("rawpy")
    mosaic = mosaic_of(400, 800, 200)
    mosaic[-4:] = 0  # what LibRaw leaves of lines that are missing
    write_dng(tmp_path / "a.dng", mosaic)
    with pytest.raises(RecordingError, match="its last rows are empty: it is cut off"):
        open_frames(tmp_path / "a.dng[R]")
    with pytest.raises(PhotoError, match=r"cannot be read as a raw photograph: its last rows are empty"):
        read_photo(tmp_path / "a.dng")


def test_movies_that_a_text_describes_have_their_frames_and_pixel(tmp_path):
    movie = STACK.reshape(12, 6, 8)
    movie.astype(">u2").tofile(tmp_path / "a.dax")
    inf = "binning = 2 x 2\ndata type = 16 bit integers (binary, big endian)\nframe dimensions = 8 x 6\n"
    (tmp_path / "a.inf").write_text(f"{inf}number of frames = 12\nLock Target = 0.0\n")
    with open_frames(tmp_path / "a.dax") as found:
        assert (found.axes, found.shape, found.dtype) == ("TYX", (12, 6, 8), np.uint16)
        assert np.array_equal(found[...], movie)
        assert "binning 2 x 2" in found.notes[0]
    movie.astype("<f4").tofile(tmp_path / "b.raw")
    yaml = (
        "Byte Order: <\nCamera.Pixelsize: 160\nData Type: float32\nFrames: 12\nHeight: 6\nWidth: 8\n---\nFrames: 5\n"
    )
    (tmp_path / "b.yaml").write_text(yaml)
    with open_frames(tmp_path / "b.raw") as found:
        assert np.array_equal(found[...], movie)
        assert found.metadata["pixel"] == pytest.approx(160e-9)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("frame dimensions = 8 x 6\nnumber of frames = 12\n", "does not state 'data type'"),
        ("data type = 8 bit\nframe dimensions = 8 x 6\nnumber of frames = 12\n", "data type is '8 bit', not 16 bit"),
        (
            "data type = 16 bit integers\nframe dimensions = 8 x 6\nnumber of frames = 13\n",
            "of 1248 bytes, the file has 1152",
        ),
        ("data type = 16 bit integers\nframe dimensions = 0 x 6\nnumber of frames = 0\n", "0 frames of 6 x 0"),
        ("data type = 16 bit integers\nframe dimensions = 8\nnumber of frames = 12\n", "a.dax: "),
    ],
)
def test_a_movie_that_its_text_does_not_describe_is_refused(tmp_path, text, message):
    STACK.tofile(tmp_path / "a.dax")
    (tmp_path / "a.inf").write_text(text)
    with pytest.raises(RecordingError, match=message):
        open_frames(tmp_path / "a.dax")


@pytest.mark.parametrize(
    ("file", "start", "module", "message"),
    [
        ("a.nd2", b"\xda\xce\xbe\n", "nd2", 'reading ND2 files needs nd2: pip install nd2 .the extra "microscopes"'),
        ("a.lif", b"p\0\0\0\1\0\0\0*", "liffile", 'needs liffile: pip install liffile .the extra "microscopes"'),
        ("a.czi", b"ZISRAWFILE", "pylibCZIrw", 'needs pylibCZIrw: pip install pylibCZIrw .the extra "czi"'),
        ("a.nef", b"II*\0", "rawpy", 'raw photographs need rawpy: pip install rawpy .the extra "raw"'),
        ("a.dv", b"", "bioio", "reading .dv files needs two packages: pip install bioio bioio-dv"),
    ],
)
def test_a_library_that_is_missing_is_named_with_its_extra(tmp_path, monkeypatch, file, start, module, message):
    monkeypatch.setitem(sys.modules, module, None)
    monkeypatch.setitem(sys.modules, f"{module}.czi", None)
    (tmp_path / file).write_bytes(start + bytes(99))
    with pytest.raises(ImportError, match=message):
        open_frames(tmp_path / file)


@pytest.mark.parametrize(
    ("file", "start", "message"),
    [
        ("a.sif", b"Andor Technology Multi-Channel File\n", r"a.sif: SIF \(Andor\) is not read; export FITS or TIFF"),
        ("a.spe", b"\0\0\1\0", r"a.spe: SPE \(Princeton Instruments\) is not read; export FITS or TIFF"),
        ("a.ser", b"LUCAM-RECORDER", r"a.ser: SER \(planetary video\) is not read; export FITS or TIFF"),
        ("a.oib", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", "pip install bioio bioio-bioformats"),
        ("a.ims", b"\x89HDF\r\n\x1a\n", "pip install bioio bioio-bioformats"),
        ("a.vsi", b"II*\0", "pip install bioio bioio-vsi"),
        ("a.cr3", b"\0\0\0\x18ftypcrx ", "LibRaw: [A-Z]"),
    ],
)
def test_formats_that_are_not_read_are_named_with_a_way_out(tmp_path, file, start, message):
    if file == "a.cr3":
        pytest.importorskip("rawpy")
    (tmp_path / file).write_bytes(start + bytes(4200))
    with pytest.raises((RecordingError, ImportError), match=message):
        open_frames(tmp_path / file)


def test_packed_bits_of_a_tiff_are_values_or_an_error_that_names_the_package(tmp_path):
    values = STACK[0, 0, 0] % 4096
    data = int("".join(f"{value:012b}" for value in values.ravel()), 2).to_bytes(72, "big")
    entries = [(256, 3, 1, 8), (257, 3, 1, 6), (258, 3, 1, 12), (259, 3, 1, 1), (262, 3, 1, 1), (273, 4, 1, 8)]
    entries += [(277, 3, 1, 1), (278, 3, 1, 6), (279, 4, 1, 72)]
    body = struct.pack("<H", 9) + b"".join(struct.pack("<HHII", *entry) for entry in entries) + bytes(4)
    (tmp_path / "a.tif").write_bytes(b"II*\0" + struct.pack("<I", 80) + data + body)
    with open_frames(tmp_path / "a.tif") as found:
        if find_spec("imagecodecs"):
            assert np.array_equal(found[...], values)
        else:
            with pytest.raises(RecordingError, match=r"12-bit integers requires .*: pip install imagecodecs"):
                found[...]


def test_a_raw_photograph_whose_strips_end_beyond_it_is_refused(tmp_path):
    pytest.importorskip("rawpy")
    write_dng(tmp_path / "a.dng", mosaic_of(400, 800, 200))
    data = (tmp_path / "a.dng").read_bytes()
    (tmp_path / "cut.dng").write_bytes(data[:-500])
    with pytest.raises(
        RecordingError, match=f"it is cut off: it has {len(data) - 500} bytes, and states {len(data)}"
    ):
        open_frames(tmp_path / "cut.dng[R]")


def test_planes_that_a_zeiss_file_lacks_are_no_zeros(tmp_path):
    czi = pytest.importorskip("pylibCZIrw.czi")
    with czi.create_czi(str(tmp_path / "a.czi")) as file:
        for z in (0, 2):
            file.write(data=STACK[0, z, 0], plane={"Z": z, "T": 0, "C": 0})
    with open_frames(tmp_path / "a.czi") as found:
        assert np.array_equal(found[2], STACK[0, 2, 0])
        with pytest.raises(RecordingError, match="image 1: it is missing: the recording was stopped"):
            found[...]


def test_files_of_other_formats_are_read_by_the_plugin_of_bioio(tmp_path, monkeypatch):
    """By a stand-in with the interface of bioio 3."""
    data = np.moveaxis(STACK, 2, 1)

    class BioImage:
        scenes = ("first", "second")
        dims = SimpleNamespace(order="TCZYX")
        physical_pixel_sizes = SimpleNamespace(Z=None, Y=0.1, X=0.1)
        channel_names = ("DAPI", "GFP")

        def __init__(self, path):
            self.scene = "first"

        def set_scene(self, scene):
            self.scene = scene

        def get_image_dask_data(self, order):
            assert order == "TCZYX"
            return data if self.scene == "second" else data[:, :1]

    bioio, plugin = ModuleType("bioio"), ModuleType("bioio_dv")
    bioio.BioImage = BioImage
    for module in (bioio, plugin):
        module.__spec__ = SimpleNamespace(name=module.__name__)
        monkeypatch.setitem(sys.modules, module.__name__, module)
    (tmp_path / "a.dv").write_bytes(bytes(99))
    with pytest.raises(RecordingError, match=r"it holds 2 images, \[first\], \[second\]: name one"):
        open_frames(tmp_path / "a.dv")
    channels = open_frames(tmp_path / "a.dv[second]").as_channels(time=1)
    assert np.array_equal(channels[...], data[1])
    assert channels.metadata["names"] == ("DAPI", "GFP")
    assert channels.metadata["pixel"] == pytest.approx(0.1e-6)
    assert channels.metadata["step"] is None
    assert "Of the metadata, bioio-dv returns voxels and names of channels alone." in channels.notes
