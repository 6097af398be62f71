"""Images as a sensor recorded them come from files as they are stored."""

from __future__ import annotations

import copy

import dask.array
import numpy as np
import pytest
import tifffile
import zarr
from astropy.io import fits
from PIL import Image

from lommel.recorded.frames import RecordingError, open_frames, read_images

STACK = np.arange(24, dtype=np.uint16).reshape(2, 3, 4) * 100


def test_pages_stacks_and_single_images_follow_each_other(tmp_path):
    tifffile.imwrite(tmp_path / "pages.tif", STACK, photometric="minisblack")
    np.save(tmp_path / "stack.npy", STACK)
    np.save(tmp_path / "one.npy", STACK[1])
    Image.fromarray(STACK[0]).save(tmp_path / "one.png")
    found = read_images([tmp_path / name for name in ("pages.tif", "one.npy", "stack.npy", "one.png")])[...]
    assert found.dtype == np.uint16
    assert np.array_equal(found, [*STACK, STACK[1], *STACK, STACK[0]])
    # What some programs make of three images.
    three = np.concatenate([STACK, STACK[:1]])
    tifffile.imwrite(tmp_path / "planes.tif", three, photometric="rgb", planarconfig="separate")
    assert np.array_equal(read_images([tmp_path / "planes.tif"])[...], three)
    tifffile.imwrite(tmp_path / "colour.tif", np.moveaxis(three, 0, 2), photometric="rgb")
    with pytest.raises(RecordingError, match=r"it holds colours \(RGB\), 3 x 4 x 3 along YXS"):
        read_images([tmp_path / "colour.tif"])
    Image.fromarray(np.zeros((8, 9, 3), np.uint8)).save(tmp_path / "colour.png")
    with pytest.raises(RecordingError, match="it has 3 channels: save the counts of the sensor in grey"):
        read_images([tmp_path / "colour.png"])


@pytest.mark.parametrize("dtype", ["float32", ">f4", "int16", ">u2"])
def test_values_are_those_that_are_stored(tmp_path, dtype):
    values = (STACK[0] - 50.0).astype(dtype) if "u" not in dtype else STACK[0].astype(dtype)
    tifffile.imwrite(tmp_path / "x.tif", values, byteorder=">" if dtype.startswith(">") else "<")
    found = read_images([str(tmp_path / "x.tif")])[...]
    assert np.array_equal(found[0], values)
    assert found.dtype.isnative


def test_images_of_telescopes_are_read_from_fits(tmp_path):
    fits.PrimaryHDU(STACK).writeto(tmp_path / "stack.fits")
    fits.HDUList([fits.PrimaryHDU(), fits.ImageHDU(STACK[0])]).writeto(tmp_path / "one.fit")
    found = read_images([tmp_path / "stack.fits", tmp_path / "one.fit"])[...]
    assert found.dtype == np.uint16  # which FITS stores as integers with a sign
    assert np.array_equal(found, [*STACK, STACK[0]])
    (tmp_path / "cut.fits").write_bytes((tmp_path / "stack.fits").read_bytes()[:2000])
    with pytest.raises(RecordingError, match=r"cut\.fits: "):
        read_images([tmp_path / "cut.fits"])


def test_what_is_no_grey_image_is_refused(tmp_path):
    np.save(tmp_path / "a.npy", STACK[0])
    np.save(tmp_path / "wide.npy", STACK[0, :, :3])
    np.save(tmp_path / "float.npy", STACK[0].astype(float))
    np.save(tmp_path / "line.npy", STACK[0, 0])
    np.save(tmp_path / "complex.npy", STACK[0] * 1j)
    Image.fromarray(np.zeros((3, 4, 3), np.uint8)).save(tmp_path / "colour.png")
    (tmp_path / "text.tif").write_text("no image", encoding="utf-8")
    with tifffile.TiffWriter(tmp_path / "sizes.tif") as file:
        file.write(STACK[0], photometric="minisblack")
        file.write(STACK[0, :, :3], photometric="minisblack")
    for names, said in [
        (("a.npy", "wide.npy"), r"wide.npy: images of 3 x 3 uint16, but the first images are of 3 x 4 uint16"),
        (("a.npy", "float.npy"), r"images of 3 x 4 float64, but the first images are of 3 x 4 uint16"),
        (("line.npy",), r"line.npy: it must have images of one pixel or more, .*, got the shape \(4,\)"),
        (("complex.npy",), "save one stack of grey images"),
        (("text.tif",), "is not a TIFF"),
        (("sizes.tif",), r"it holds 2 images, \[0\] of 3 x 4, \[1\] of 3 x 3: name one, as in sizes.tif\[0\]"),
    ]:
        with pytest.raises(RecordingError, match=said):
            read_images([tmp_path / name for name in names])
    assert np.array_equal(read_images([f"{tmp_path}/sizes.tif[1]"])[...], STACK[:1, :, :3])
    with pytest.raises(RecordingError, match=r"name one, as in sizes.tif\[0\]"):
        read_images([f"{tmp_path}/sizes.tif[SCI]"])
    with pytest.raises(RecordingError):
        read_images([tmp_path / "colour.png", tmp_path / "a.npy"])
    with pytest.raises(ValueError, match="paths must name a file"):
        read_images([])


OME = """<?xml version="1.0" encoding="UTF-8"?><OME xmlns="http://www.openmicroscopy.org/Schemas/OME/2016-06">
<Image ID="Image:0"><Pixels ID="Pixels:0" DimensionOrder="XYCZT" Type="uint16" SizeX="6" SizeY="5" SizeC="{c}"
SizeZ="{z}" SizeT="1">{channels}{data}</Pixels></Image></OME>"""


def ome(path, planes, ifds, c=1):
    """Write planes, of which OME says where in the file each one is."""
    channels = "".join(f'<Channel ID="Channel:0:{k}" SamplesPerPixel="1"/>' for k in range(c))
    data = "".join(f'<TiffData IFD="{ifd}" FirstZ="{k}" PlaneCount="1"/>' for k, ifd in enumerate(ifds))
    text = OME.format(c=c, z=len(planes) // c, channels=channels, data=data if c == 1 else "<TiffData/>")
    tifffile.imwrite(path, planes, photometric="minisblack", description=text.encode(), metadata=None)


def test_planes_are_in_the_order_that_ome_and_imagej_state(tmp_path):
    planes = np.arange(4 * 5 * 6, dtype=np.uint16).reshape(4, 5, 6)
    ome(tmp_path / "last.ome.tif", planes[::-1], [3, 2, 1, 0])
    assert np.array_equal(read_images([tmp_path / "last.ome.tif"])[...], planes)
    ome(tmp_path / "mixed.ome.tif", planes[[2, 0, 3, 1]], [1, 3, 0, 2])
    assert np.array_equal(read_images([tmp_path / "mixed.ome.tif"])[...], planes)
    # ImageJ keeps stacks above 4 GB behind one page, as this does.
    tifffile.imwrite(tmp_path / "one.tif", planes, imagej=True, truncate=True, metadata={"axes": "ZYX"})
    with tifffile.TiffFile(tmp_path / "one.tif") as file:
        assert len(file.pages) == 1
    assert np.array_equal(read_images([tmp_path / "one.tif"])[...], planes)


def test_planes_of_several_channels_and_planes_that_are_not_there_are_refused(tmp_path):
    planes = np.arange(4 * 5 * 6, dtype=np.uint16).reshape(4, 5, 6)
    ome(tmp_path / "channels.ome.tif", planes, [], c=2)
    with pytest.raises(RecordingError, match=r"it holds 2 x 2 x 5 x 6 values along ZCYX: save one stack of images"):
        read_images([tmp_path / "channels.ome.tif"])
    tifffile.imwrite(tmp_path / "fewer.tif", planes[:3], imagej=True, metadata={"axes": "ZYX"})
    data = (tmp_path / "fewer.tif").read_bytes()
    (tmp_path / "more.tif").write_bytes(data.replace(b"images=3", b"images=9").replace(b"slices=3", b"slices=9"))
    with pytest.raises(RecordingError, match="it is cut off or damaged: ImageJ series metadata"):
        read_images([tmp_path / "more.tif"])
    (tmp_path / "less.tif").write_bytes(data.replace(b"images=3", b"images=2").replace(b"slices=3", b"slices=2"))
    with pytest.raises(RecordingError, match="it holds 3 pages, of which its description by ImageJ states 2"):
        read_images([tmp_path / "less.tif"])


def test_fits_images_are_packed_and_one_of_several_is_named(tmp_path):
    units = [fits.PrimaryHDU(), fits.ImageHDU(STACK[0], name="SCI"), fits.ImageHDU(STACK[1], name="ERR")]
    fits.HDUList(units).writeto(tmp_path / "three.fits")
    with pytest.raises(RecordingError, match=r"it holds 2 images, \[SCI\] of 3 x 4, \[ERR\] of 3 x 4: name one,"):
        read_images([tmp_path / "three.fits"])
    assert np.array_equal(read_images([f"{tmp_path}/three.fits[err]"])[...], STACK[1:])
    assert np.array_equal(read_images([tmp_path / "three.fits[SCI]"])[...], STACK[:1])
    with pytest.raises(RecordingError, match="it holds 2 images"):
        read_images([tmp_path / "three.fits[DQ]"])
    fits.PrimaryHDU(STACK).writeto(tmp_path / "one.fits.gz")
    assert np.array_equal(read_images([tmp_path / "one.fits.gz"])[...], STACK)


def test_a_card_that_is_not_standard_does_no_harm_and_a_file_that_is_cut_off_is_refused(tmp_path):
    fits.PrimaryHDU(STACK.astype(np.float32)).writeto(tmp_path / "a.fits")
    data = bytearray((tmp_path / "a.fits").read_bytes())
    at = data.index(b"END" + b" " * 77)
    data[at : at + 160] = b"HISTOGRAM 'of 1992".ljust(80) + b"END".ljust(80)
    (tmp_path / "odd.fits").write_bytes(data)
    assert np.array_equal(read_images([tmp_path / "odd.fits"])[...], STACK)
    (tmp_path / "cut.fits").write_bytes(data[:2900])
    with pytest.raises(RecordingError, match=r"cut\.fits: "):
        read_images([tmp_path / "cut.fits"])


MANY = np.arange(2 * 3 * 4 * 6 * 7, dtype=np.uint16).reshape(2, 3, 4, 6, 7)


def test_copies_of_frames_close_the_file_that_they_opened(tmp_path):
    path = tmp_path / "many.ome.tif"
    tifffile.imwrite(path, MANY, metadata={"axes": "TCZYX"}, compression="zlib")
    with open_frames(path) as frames:
        copied = copy.deepcopy(frames)
        handle = copied.planes._file.filehandle
        assert not handle.closed
        del copied
        assert handle.closed
        np.testing.assert_array_equal(frames[0], MANY[0])


@pytest.mark.parametrize("suffix", ["ome.tif", "ome.zarr", "array"])
def test_frames_are_sliced_as_arrays_are_and_by_dask(suffix, tmp_path):
    path = tmp_path / f"many.{suffix}"
    if suffix == "ome.tif":
        tifffile.imwrite(path, MANY, metadata={"axes": "TCZYX"}, compression="zlib")
    elif suffix == "ome.zarr":
        kinds = ["time", "channel", "space", "space", "space"]
        axes = [{"name": name, "type": kind} for name, kind in zip("tczyx", kinds, strict=True)]
        group = zarr.create_group(path, zarr_format=2)
        group.create_array("0", data=MANY, chunks=(1, 1, 3, 4, 5))
        scale = {"coordinateTransformations": [{"type": "scale", "scale": [1.0] * 5}]}
        group.attrs["multiscales"] = [{"version": "0.4", "axes": axes, "datasets": [{"path": "0"} | scale]}]
    with open_frames(MANY if suffix == "array" else path) as frames:
        assert (frames.shape, frames.ndim, frames.dtype, len(frames)) == (MANY.shape, 5, MANY.dtype, 2)
        assert frames.axes == ("QQQYX" if suffix == "array" else "TCZYX")
        for at in (
            0, -1, np.s_[1, 2], np.s_[:, 1], np.s_[..., 3], np.s_[0, ..., 2:5, ::-2], np.s_[::-1, 0, 1:1],
            np.s_[1, 2, 3, 4, 5], np.s_[[1, 0], 2, :, 1:3], np.s_[...],
        ):  # fmt: skip
            found = frames[at]
            np.testing.assert_array_equal(found, MANY[at])
            assert np.shape(found) == MANY[at].shape
        lazy = dask.array.from_array(frames, chunks=(1, 1, 2, 3, 7))
        assert int(lazy[1].max().compute()) == MANY[1].max()
        with pytest.raises(IndexError):
            frames[2]
        with pytest.raises(TypeError, match="rows and columns must be integers or slices"):
            frames[0, 0, 0, [1, 2]]


def test_an_array_in_a_file_stays_on_the_disk_until_it_is_read(tmp_path):
    with (tmp_path / "long.npy").open("wb") as file:
        np.lib.format.write_array_header_1_0(file, {"descr": "<u2", "fortran_order": False, "shape": (2**21, 64, 64)})
        file.truncate(file.tell() + 2 * 2**21 * 64 * 64)  # 16 GB, of which the disk has nothing
    assert not open_frames(tmp_path / "long.npy")[2**21 - 1, 60:].any()
    with (tmp_path / "long.npy").open("rb") as file:
        (tmp_path / "cut.npy").write_bytes(file.read(5000))
    with pytest.raises(RecordingError, match=r"cut.npy: its header states more than its 5000 bytes: it is cut off"):
        open_frames(tmp_path / "cut.npy")


def test_an_orientation_that_is_not_applied_is_told(tmp_path):
    tifffile.imwrite(tmp_path / "a.tif", MANY[0, 0, 0], extratags=[(274, 3, 1, 4, True)], metadata=None)
    assert read_images([tmp_path / "a.tif"]).notes == ("The file states the orientation 4, which was not applied.",)


def test_units_in_comments_of_fits_cards_and_contradictions_are_used_or_named(tmp_path):
    def read(**cards: object) -> tuple[dict, str]:
        unit = fits.PrimaryHDU(np.full((9, 9), 7.0, np.float32))
        unit.header["BUNIT"] = "adu"
        unit.header.update(cards)
        unit.writeto(tmp_path / "star.fits", overwrite=True)
        frames = open_frames(tmp_path / "star.fits")
        return frames.metadata, " ".join(frames.notes)

    usual = read(EGAIN=(0.5, "[e-/ADU]"), RDNOISE=(3.0, "[electron]"))
    assert read(EGAIN=(2.0, "[ADU/e-] inverse gain"), RDNOISE=(6.0, "[ADU]")) == usual
    assert read(GAIN=(2.0, "[ADU/e-]"), RDNOISE=(6.0, "[ADU]")) == usual
    assert read(EGAIN=0.5, SATURATE=(600.0, "[e-] full well"))[0]["saturation"] == pytest.approx(1200.0)
    assert "600" in read(SATURATE=(600.0, "[e-] full well"))[0]["saturation"].words
    assert read(EGAIN=0.5, SATURATE=600.0)[0]["saturation"] == 600.0
    assert read(EGAIN=0.5, GAIN=(1.5, "[e-/ADU]"))[0]["gain"].words == "0.5 by EGAIN and 1.5 by GAIN"
    found = read(XPIXSZ=(0.0044, "[mm]"), FOCALLEN=(0.6, "[m]"), YPIXSZ=8.8)
    assert (found[0]["sensor_pixel"], found[0]["focal_length"]) == pytest.approx((4.4e-6, 0.6))
    assert "YPIXSZ = 8.8" in found[1]
    electrons = read(BUNIT="electron", EGAIN=0.5)
    assert electrons[0]["gain"] == 1.0
    assert "EGAIN = 0.5, not used: the values are electrons by BUNIT" in electrons[1]
