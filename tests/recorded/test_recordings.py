"""Files of stacks, written by tifffile and zarr themselves, and what is wrong with others."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
import tifffile
import zarr

from lommel import example_files, load_microscope, microscopy
from lommel.recorded.frames import RecordingError, open_frames
from lommel.recorded.stack_files import save_stack

STACK = np.arange(2 * 5 * 8 * 9, dtype=np.uint16).reshape(2, 5, 8, 9)
SIZES = {
    "PhysicalSizeX": 0.1, "PhysicalSizeXUnit": "µm", "PhysicalSizeY": 100, "PhysicalSizeYUnit": "nm",
    "PhysicalSizeZ": 0.0002, "PhysicalSizeZUnit": "mm",
}  # fmt: skip
COLOURS = {"Name": ["DAPI", "GFP"], "EmissionWavelength": [460, 520], "EmissionWavelengthUnit": ["nm", "nm"]}


def write(path, values, axes, **more):
    tifffile.imwrite(path, values, ome=True, photometric="minisblack", metadata={"axes": axes, **SIZES, **more})
    return path


@pytest.mark.parametrize(
    ("axes", "order"), [("CZYX", (0, 1, 2, 3)), ("ZCYX", (1, 0, 2, 3))], ids=["channels first", "planes first"]
)
def test_an_ome_tiff_has_its_voxels_channels_and_wavelengths(tmp_path, axes, order):
    path = write(tmp_path / "a.ome.tif", STACK.transpose(order), axes, Channel=COLOURS)
    with open_frames(path).as_channels() as found:
        assert found.shape == STACK.shape
        assert (found.metadata["pixel"], found.metadata["step"]) == (pytest.approx(1e-7), pytest.approx(2e-7))
        assert found.metadata["names"] == ("DAPI", "GFP")
        assert found.metadata["emission"] == (pytest.approx(460e-9), pytest.approx(520e-9))
        assert found.notes == ("From the OME metadata of the file: 100 nm pixels, 200 nm planes apart.",)
        for channel in (0, 1):
            np.testing.assert_array_equal(found[channel], STACK[channel])
        np.testing.assert_array_equal(found[1, 2, 3:5, 1:4], STACK[1, 2, 3:5, 1:4])


@pytest.mark.parametrize("suffix", [".ome.tif", ".ome.zarr"])
def test_what_is_written_is_read_again_with_all_metadata(tmp_path, suffix):
    with open_frames(write(tmp_path / "a.ome.tif", STACK, "CZYX", Channel=COLOURS)).as_channels() as first:
        there = Path(tmp_path / f"b{suffix}")
        save_stack(there, STACK.astype(np.float32), first, "restored")
        with open_frames(there).as_channels() as again:
            assert (again.shape, again.metadata["names"]) == (first.shape, first.metadata["names"])
            for name in ("pixel", "step", "emission"):
                assert again.metadata[name] == pytest.approx(first.metadata[name])
            assert again.dtype == np.float32
            np.testing.assert_array_equal(again[1], STACK[1])
    assert {entry.name for entry in tmp_path.iterdir()} == {"a.ome.tif", there.name}


def test_a_tiff_of_imagej_has_its_voxels(tmp_path):
    path, options = tmp_path / "j.tif", {"spacing": 0.3, "unit": "um", "axes": "ZYX"}
    tifffile.imwrite(path, STACK[0], imagej=True, resolution=(10.0, 10.0), metadata=options)
    with open_frames(path).as_channels() as found:
        assert (found.metadata["pixel"], found.metadata["step"]) == (pytest.approx(1e-7), pytest.approx(3e-7))
        np.testing.assert_array_equal(found[0], STACK[0])


def test_the_resolution_per_centimetre_is_the_pixel_as_in_imagej_unless_it_is_of_a_print(tmp_path):
    path = tmp_path / "c.tif"
    for resolution, unit, pixel in ((1e5, "CENTIMETER", 1e-7), (28.35, "CENTIMETER", None), (72.0, "INCH", None)):
        options = {"imagej": True, "resolution": (resolution, resolution), "resolutionunit": unit}
        tifffile.imwrite(path, STACK[0], metadata={"axes": "ZYX"}, **options)
        with open_frames(path).as_channels() as found:
            assert found.metadata["pixel"] == (None if pixel is None else pytest.approx(pixel))
            assert found.metadata["step"] is None
            assert ("pixels of 100 nm" in repr(found)) == (pixel is not None)


def test_a_negative_spacing_is_used_without_its_sign_and_said(tmp_path):
    for spacing in (0.3, -0.3):
        options = {"spacing": spacing, "unit": "um", "axes": "ZYX"}
        tifffile.imwrite(tmp_path / "n.tif", STACK[0], imagej=True, resolution=(10.0, 10.0), metadata=options)
        with open_frames(tmp_path / "n.tif").as_channels() as found:
            assert found.metadata["step"] == pytest.approx(3e-7)
            assert any("a negative plane spacing" in note for note in found.notes) == (spacing < 0.0)


def test_an_ome_zarr_of_version_five_is_read(tmp_path):
    group = zarr.create_group(str(tmp_path / "v.zarr"), zarr_format=3)
    group.create_array("0", data=STACK[np.newaxis], chunks=(1, 1, 3, 8, 9))
    axes = [{"name": "t", "type": "time"}, {"name": "c", "type": "channel"}]
    axes += [{"name": name, "type": "space", "unit": "micrometer"} for name in "zyx"]
    scale = [{"type": "scale", "scale": [1, 1, 0.2, 0.1, 0.1]}]
    scales = [{"axes": axes, "datasets": [{"path": "0", "coordinateTransformations": scale}]}]
    group.attrs["ome"] = {"version": "0.5", "multiscales": scales}
    found = open_frames(tmp_path / "v.zarr").as_channels()
    assert (found.shape, found.metadata["pixel"], found.metadata["step"]) == (
        STACK.shape,
        pytest.approx(1e-7),
        pytest.approx(2e-7),
    )
    np.testing.assert_array_equal(found[1], STACK[1])


def test_time_points_are_asked_for(tmp_path):
    path = write(tmp_path / "t.ome.tif", STACK, "TZYX")
    with pytest.raises(RecordingError, match="holds 2 time points; select one with time=, from 0 to 1"):
        open_frames(path).as_channels()
    with open_frames(path).as_channels(time=1) as found:
        np.testing.assert_array_equal(found[0], STACK[1])
    with open_frames(path).as_channels(series=True) as found:
        assert found.axes == "TCZYX"
        assert found.metadata["names"] == ("channel 0",)
        np.testing.assert_array_equal(found[:, 0], STACK)
    with pytest.raises(ValueError, match="time"):
        open_frames(path).as_channels(time=2)


def test_axes_that_a_file_does_not_state_may_be_given(tmp_path):
    path = tmp_path / "q.tif"
    tifffile.imwrite(path, STACK[0], photometric="minisblack")
    with pytest.raises(RecordingError, match=r'does not state the meaning of its axis of 5 images; .* axes="ZYX"'):
        open_frames(path).as_channels()
    with open_frames(path).as_channels(axes="ZYX") as found:
        assert found.metadata["pixel"] is None
        np.testing.assert_array_equal(found[0], STACK[0])


def test_files_that_are_no_stacks_are_refused(tmp_path):
    movie = write(tmp_path / "movie.ome.tif", STACK[0], "TYX")
    with pytest.raises(RecordingError, match=r'time series of 5 images .* state axes="ZYX"'):
        open_frames(movie).as_channels()
    colours = tmp_path / "rgb.tif"
    tifffile.imwrite(colours, np.zeros((8, 9, 3), np.uint8), photometric="rgb")
    with pytest.raises(RecordingError, match="colours"):
        open_frames(colours).as_channels()
    oblong = write(tmp_path / "oblong.ome.tif", STACK[0], "ZYX", PhysicalSizeY=200)
    with pytest.raises(RecordingError, match="200 nm high and 100 nm wide"):
        open_frames(oblong).as_channels()
    (tmp_path / "no.tif").write_bytes(b"nothing of the kind, but long enough")
    with pytest.raises(RecordingError, match=r"no\.tif"):
        open_frames(tmp_path / "no.tif").as_channels()
    (tmp_path / "empty.zarr").mkdir()
    with pytest.raises(RecordingError, match="no OME-Zarr"):
        open_frames(tmp_path / "empty.zarr").as_channels()
    with pytest.raises(FileNotFoundError):
        open_frames(tmp_path / "missing.tif").as_channels()
    with (
        pytest.raises(ValueError, match=r"end in \.ome\.tif or \.ome\.zarr"),
        open_frames(movie).as_channels(axes="ZYX") as made,
    ):
        save_stack(tmp_path / "a.png", STACK, made)


def test_a_size_that_cannot_be_is_told(tmp_path):
    with open_frames(write(tmp_path / "huge.ome.tif", STACK[0], "ZYX", PhysicalSizeZ=500.0)).as_channels() as found:
        assert found.metadata["step"] is None
        assert found.metadata["unusable"] == {"step": "0.5 m"}
        assert "a plane spacing of 0.5 m, which cannot be used." in " ".join(found.notes)


@pytest.mark.parametrize(
    ("value", "unit", "words"),
    [(0.3, "reference frame", "0.3 reference frame"), (0, "µm", "0 µm"), (0.3, "pixel", "0.3 pixel"),
     ("nan", "µm", "nan µm"), ("x", "µm", "x µm")],
)  # fmt: skip
def test_a_length_that_is_stated_but_unusable_is_not_replaced_by_another(value, unit, words, tmp_path):
    path = write(tmp_path / "a.ome.tif", STACK, "CZYX", PhysicalSizeZ=value, PhysicalSizeZUnit=unit)
    with open_frames(path).as_channels() as found:
        assert (found.metadata["step"], found.metadata["unusable"]) == (None, {"step": words})
        assert f"The file states a plane spacing of {words}, which cannot be used." in found.notes
    objective = load_microscope(example_files()["zeiss-63x-1.4-oil"])
    with pytest.raises(
        ValueError, match=rf"a\.ome\.tif states {words} between planes, .*: give step= \(of the stage\), in metres"
    ):
        microscopy.deconvolve(path, objective)
    bad = {"Name": ["a", "b"], "EmissionWavelength": [0, 520]}
    path = write(tmp_path / "b.ome.tif", STACK, "CZYX", Channel=bad)
    with pytest.raises(ValueError, match="emission wavelength of 'a' is 0 nm, which cannot be used: give"):
        microscopy.deconvolve(path, objective)


def test_imagej_has_units_of_its_own_for_each_axis(tmp_path):
    told = {"spacing": 0.3, "unit": "nm", "yunit": "micron", "zunit": "micron", "axes": "ZYX"}
    tifffile.imwrite(tmp_path / "j.tif", STACK[0], imagej=True, resolution=(1 / 65, 1 / 0.065), metadata=told)
    with open_frames(tmp_path / "j.tif").as_channels() as found:
        assert (found.metadata["pixel"], found.metadata["step"]) == (
            pytest.approx(65e-9, rel=1e-4),
            pytest.approx(300e-9),
        )
    told = {"spacing": 0.3, "unit": "um", "zunit": "furlong", "axes": "ZYX"}
    tifffile.imwrite(tmp_path / "k.tif", STACK[0], imagej=True, resolution=(10.0, 10.0), metadata=told)
    with open_frames(tmp_path / "k.tif").as_channels() as found:
        assert (found.metadata["pixel"], found.metadata["unusable"]) == (pytest.approx(1e-7), {"step": "0.3 furlong"})


def test_an_ome_zarr_states_units_for_each_axis(tmp_path):
    with open_frames(STACK).as_channels() as first:
        save_stack(tmp_path / "a.ome.zarr", STACK, first)
    place = tmp_path / "a.ome.zarr" / ".zattrs"
    told = json.loads(place.read_text())
    scales = told["multiscales"][0]
    scales["datasets"][0]["coordinateTransformations"][0]["scale"] = [1, 0.2, 1e-5, 1e-5]
    for axis in scales["axes"][2:]:
        axis["unit"] = "centimeter"
    place.write_text(json.dumps(told))
    found = open_frames(tmp_path / "a.ome.zarr").as_channels()
    assert (found.metadata["pixel"], found.metadata["step"]) == (pytest.approx(1e-7), None)
    assert found.metadata["unusable"] == {"step": "0.2 without a unit"}


def test_of_several_images_the_largest_is_taken_or_that_which_is_asked_for(tmp_path):
    path = tmp_path / "two.ome.tif"
    with tifffile.TiffWriter(path, ome=True) as file:
        file.write(STACK[0, 0, :4, :4], photometric="minisblack", metadata={"axes": "YX", "Name": "thumbnail"})
        file.write(STACK[0], photometric="minisblack", metadata={"axes": "ZYX", "Name": "stack", **SIZES})
    with open_frames(path).as_channels() as found:
        assert found.notes[0] == (
            "The file holds 2 images, [thumbnail] of 4 x 4, [stack] of 5 x 8 x 9; image 1, counted from 0, was used; "
            "two.ome.tif[0] selects another."
        )
        assert found.metadata["step"] == pytest.approx(2e-7)
        np.testing.assert_array_equal(found[0], STACK[0])
    with open_frames(f"{path}[0]").as_channels() as found:
        assert (found.shape, found.metadata["step"], found.notes) == ((1, 1, 4, 4), None, ())
    with open_frames(f"{path}[Thumbnail]") as found:
        assert found.shape == (4, 4)
    with pytest.raises(ValueError, match=r"it holds 2 images, \[thumbnail\] of 4 x 4, \[stack\] of 5 x 8 x 9: name"):
        open_frames(f"{path}[2]").as_channels()


@pytest.mark.parametrize("sides", [(5, 8, 9), (4, 8, 9), (2, 12, 12)])
def test_of_images_of_about_one_size_none_is_taken(tmp_path, sides):
    path = tmp_path / "two.ome.tif"
    with tifffile.TiffWriter(path, ome=True) as file:
        for name, values in (("first", STACK[0]), ("second", np.ones(sides, np.uint16))):
            file.write(values, photometric="minisblack", metadata={"axes": "ZYX", "Name": name})
    with pytest.raises(
        RecordingError, match=r"it holds 2 images, \[first\] of .*, \[second\].* two.ome.tif\[first\]"
    ):
        open_frames(path)
    assert open_frames(f"{path}[second]").shape == sides


def test_pages_that_imagej_does_not_count_are_told(tmp_path):
    path = tmp_path / "less.tif"
    text = "ImageJ=1.53t\nimages=3\nslices=3\nunit=um\nspacing=0.3\n"
    with tifffile.TiffWriter(path) as file:
        for k, plane in enumerate(STACK[0]):
            file.write(plane, description=text if k == 0 else None, contiguous=False, metadata=None)
    with open_frames(path) as opened:
        found = opened.as_channels()
        assert found.shape == (1, 3, 8, 9)
        assert found.notes[0] == (
            "The file holds 5 pages, of which its description by ImageJ states 3; the others were left out."
        )
        with pytest.raises(RecordingError, match=r"less\.tif: it holds 5 pages, of which its description by ImageJ"):
            opened.as_stack()
