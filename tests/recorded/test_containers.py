"""What other programs write in OME-Zarr and TIFF: each size is used, named or refused, and values are as stored."""

from __future__ import annotations

import h5py
import numpy as np
import pytest
import tifffile
import xarray
import zarr

import lommel as lm
from lommel.recorded.frames import RecordingError, open_frames

STACK = np.random.default_rng(0).poisson(100, (3, 4, 5)).astype(np.uint16)
SIZES = [0.25, 0.108, 0.108]
SPACE = [{"name": name, "type": "space", "unit": "micrometer"} for name in "zyx"]


def scale(sizes=tuple(SIZES)):
    return {"type": "scale", "scale": list(sizes)}


def affine(matrix):
    return {"type": "affine", "affine": [[*row, 7.0] for row in matrix]}


def multiscales(transforms=(), *, axes=SPACE, name="", levels=("0",), **more):
    made = [{"path": level, "coordinateTransformations": list(transforms)} for level in levels]
    return {"axes": axes, "name": name, "datasets": made, **more}


def folder(path, *scales, arrays=None, version=2, attributes=None, **options):
    """A folder as other programs write it: its arrays by path, and metadata of a version of OME-Zarr."""
    group = zarr.open_group(str(path), mode="w", zarr_format=version)
    for place, values in ({"0": STACK} if arrays is None else arrays).items():
        group.create_array(place, data=np.asarray(values), **options)
    told = {"multiscales": list(scales)} if scales else {}
    told |= attributes or {}
    group.attrs.update({"ome": {"version": "0.5", **told}} if version == 3 else told)
    return path


# By name: transforms of the level, what the file has beside, and the pixel in micrometres or a text of the notes.
TRANSFORMS = {
    "scale": ([scale()], {}, 0.108),
    "scale and translation": ([scale(), {"type": "translation", "translation": [1, 2, 3]}], {}, 0.108),
    "levels and image, both multiply": (
        [scale([0.5, 0.216, 0.216])], {"coordinateTransformations": [scale([0.5, 0.5, 0.5])]}, 0.108),
    "image alone": ([], {"coordinateTransformations": [scale()]}, 0.108),
    "sequence": ([{"type": "sequence", "transformations": [
                 {"type": "identity"}, scale([0.5, 1, 1]), scale([0.5, 0.108, 0.108])]}], {}, 0.108),
    "sequence of sequences": (
        [{"type": "sequence", "transformations": [{"type": "sequence", "transformations": [scale()]}]}], {}, 0.108),
    "affine": ([affine(np.diag(SIZES))], {}, 0.108),
    "affine of four rows": ([{"type": "affine", "affine": np.diag([*SIZES, 1.0]).tolist()}], {}, 0.108),
    "affine times scale": ([affine(np.diag([0.25, 1.08, 1.08])), scale([1, 0.1, 0.1])], {}, 0.108),
    "path": ([{"type": "scale", "path": "sizes"}], {}, 0.108),
    "flipped": ([scale([0.25, -0.108, 0.108])], {}, "negative scale along Y, of which the magnitude was used"),
    "sheared": ([affine([[0.25, 0, 0], [0, 0.108, 0.05], [0, 0, 0.108]])], {},
                "a pixel size of an affine transform with rotation or shear, which cannot be used"),
    "rotation": ([{"type": "rotation", "rotation": np.eye(3).tolist()}], {}, "of the type rotation, which cannot be"),
    "identity": ([{"type": "identity"}], {}, "a pixel size of an identity transform, which cannot be used"),
    "translation alone": ([{"type": "translation", "translation": [1, 2, 3]}], {}, "states no scale"),
    "none": ([], {}, "The file states no scale: the size of its pixels is unknown."),
    "nanometres of one axis": ([scale([250, 0.108, 0.108])], {"axes": [SPACE[0] | {"unit": "nanometer"}, *SPACE[1:]]},
                               0.108),
    "no unit": ([scale()], {"axes": [{"name": n, "type": "space"} for n in "zyx"]}, "0.108 without a unit, which"),
    "unknown unit": ([scale()], {"axes": [a | {"unit": "parsec"} for a in SPACE]}, "0.108 parsec, which cannot be"),
}  # fmt: skip


@pytest.mark.parametrize("version", [2, 3])
@pytest.mark.parametrize("name", TRANSFORMS)
def test_transforms_of_an_ome_zarr_are_used_named_or_refused(name, version, tmp_path):
    transforms, more, found = TRANSFORMS[name]
    folder(tmp_path / "a.zarr", multiscales(transforms, **more), arrays={"0": STACK, "sizes": SIZES}, version=version)
    read = open_frames(tmp_path / "a.zarr").as_channels()
    np.testing.assert_array_equal(read[0], STACK)
    if isinstance(found, str):
        assert found in " ".join(read.notes)
    if name == "flipped" or not isinstance(found, str):
        assert (read.metadata["pixel"], read.metadata["step"]) == (pytest.approx(108e-9), pytest.approx(250e-9))
    else:
        assert (read.metadata["pixel"], read.metadata["step"]) == (None, None)
        assert not any("From the" in note for note in read.notes)


@pytest.mark.parametrize("transforms", [[scale([0.1])], [affine(np.eye(2))], [{"type": "scale", "path": "lost"}]])
def test_transforms_of_another_number_of_axes_are_refused(transforms, tmp_path):
    with pytest.raises(RecordingError, match=r"for 3 axes|metadata are invalid"):
        open_frames(folder(tmp_path / "a.zarr", multiscales(transforms)))


@pytest.mark.parametrize("order", ["xyz", "yxz", "czyx", "zcyx", "xytcz"])
def test_axes_of_an_ome_zarr_may_be_in_any_order(order, tmp_path):
    sizes, units = {"z": 0.25, "y": 108.0, "x": 0.108}, {"z": "micrometer", "y": "nanometer", "x": "micrometer"}
    axes = [{"name": n, "type": "space", "unit": units.get(n)} for n in order]
    lengths = {"t": 2, "c": 3, "z": 4, "y": 5, "x": 6}
    values = np.random.default_rng(1).integers(0, 9, [lengths[n] for n in order])
    scales = multiscales([scale([sizes.get(n, 1.0) for n in order])], axes=axes)
    chunks = [{"t": 1, "c": 2, "z": 3, "y": 4, "x": 2}[n] for n in order]
    with open_frames(folder(tmp_path / "a.zarr", scales, arrays={"0": values}, chunks=chunks)) as read:
        there = read.axes.lower()
        expected = np.einsum(f"{order}->{there}", values)
        assert there == "".join(n for n in order if n not in "yx") + "yx"
        np.testing.assert_array_equal(read[...], expected)
        np.testing.assert_array_equal(read[..., 1, 2:4, ::-1], expected[..., 1, 2:4, ::-1])
        np.testing.assert_array_equal(read.planes.block(tuple(map(slice, [0] * read.ndim, read.shape))), expected)
        found = [read.metadata[key] for key in ("pixel", "down", "step")]
        assert found == pytest.approx([108e-9, 108e-9, 250e-9])
        assert sum(read.planes.chunk_sizes[-1]) == read.shape[-1]


@pytest.mark.parametrize(
    ("axes", "values", "said"),
    [("zzx", STACK, "its axes are z, z, x for 3 axes .*: save it with y and x"), ("zya", STACK, "axes are z, y, a"),
     ("zx", STACK[0], "its axes are z, x"), ("yx", STACK, "its axes are y, x for 3 axes of its array")],
)  # fmt: skip
def test_other_axes_of_an_ome_zarr_are_refused(axes, values, said, tmp_path):
    scales = multiscales([scale()], axes=[{"name": n} for n in axes])
    with pytest.raises(RecordingError, match=said):
        open_frames(folder(tmp_path / "a.zarr", scales, arrays={"0": values}))


def test_names_of_dimensions_that_contradict_the_axes_are_refused(tmp_path):
    folder(tmp_path / "a.zarr", multiscales([scale()]), version=3, dimension_names=["x", "y", "z"])
    with pytest.raises(RecordingError, match="its array names its axes x, y, z, its metadata z, y, x"):
        open_frames(tmp_path / "a.zarr")
    folder(tmp_path / "b.zarr", multiscales([scale()]), version=3, dimension_names=["z", "y", "x"])
    assert open_frames(tmp_path / "b.zarr").axes == "ZYX"


def test_the_finest_level_is_read_in_whatever_order_the_pyramid_is_listed(tmp_path):
    half = STACK[:, ::2, ::2]
    for name, levels in (("a", ("0", "1")), ("b", ("1", "0"))):
        scales = multiscales(levels=levels)
        for level in scales["datasets"]:
            level["coordinateTransformations"] = [scale(SIZES if level["path"] == "0" else [0.25, 0.216, 0.216])]
        read = open_frames(folder(tmp_path / name, scales, arrays={"0": STACK, "1": half}))
        np.testing.assert_array_equal(read[...], STACK)
        assert read.metadata["pixel"] == pytest.approx(108e-9)
    read = open_frames(folder(tmp_path / "c", scales, arrays={"1": half}))
    assert (read.shape, read.notes) == (half.shape, ("The folder lacks the array 0 of its pyramid.",))


def test_one_of_several_images_of_an_ome_zarr_is_named(tmp_path):
    several = [multiscales([scale(np.multiply(k, SIZES))], name=f"well {k}", levels=(str(k),)) for k in (1, 2)]
    path = folder(tmp_path / "a.zarr", *several, arrays={"1": STACK, "2": STACK + 1})
    with pytest.raises(
        RecordingError, match=r"holds 2 images, \[well 1\], \[well 2\]: name one, as in a.zarr\[well 1\]"
    ):
        open_frames(path)
    for part in ("[1]", "[well 2]"):
        read = open_frames(f"{path}{part}")
        np.testing.assert_array_equal(read[...], STACK + 1)
        assert read.metadata["pixel"] == pytest.approx(216e-9)


def test_folders_of_converters_are_read_and_plates_refused(tmp_path):
    root = folder(tmp_path / "a.zarr", arrays={}, attributes={"bioformats2raw.layout": 3})
    folder(root / "0", multiscales([scale()]))
    (root / "OME").mkdir()
    assert open_frames(root).metadata["pixel"] == pytest.approx(108e-9)
    folder(root / "9", multiscales([scale()], name="nine"))
    folder(root / "10", multiscales([scale([0.25, 0.5, 0.5])]), arrays={"0": STACK + 2})
    with pytest.raises(RecordingError, match=r"holds 3 images, \[0\], \[nine\], \[10\]: name one, as in a.zarr\[0\]"):
        open_frames(root)
    np.testing.assert_array_equal(open_frames(f"{root}[10]")[...], STACK + 2)
    for kind, way in (("plate", r"b.zarr/A/1/0"), ("well", r"b.zarr/0")):
        path = folder(tmp_path / "b.zarr", arrays={}, attributes={kind: {"images": []}})
        with pytest.raises(
            RecordingError, match=f"it is a {kind} of several images: give the folder of one, .*{way}"
        ):
            open_frames(path)
    with pytest.raises(RecordingError, match=r"holds no multiscales of OME-Zarr: pass an array"):
        open_frames(folder(tmp_path / "c.zarr"))
    with pytest.raises(RecordingError, match="it lacks all arrays of its pyramid: copy the whole folder"):
        open_frames(folder(tmp_path / "e.zarr", multiscales(levels=("9",))))
    scales = {"coordinateSystems": [], "datasets": [{"path": "0"}]}
    with pytest.raises(RecordingError, match=r"OME-Zarr 0\.6: save it as 0\.4 or 0\.5"):
        open_frames(folder(tmp_path / "d.zarr", scales, version=3))


def tiff(path, **options):
    tifffile.imwrite(path, STACK, photometric="minisblack", **options)
    return path


def resolved(pixels, per, /, **described):
    """A TIFF of ImageJ with pixels per unit of ResolutionUnit, and its description."""
    return {"imagej": True, "resolution": (pixels, pixels), "resolutionunit": per,
            "metadata": {"axes": "ZYX", **described}}  # fmt: skip


def positions(*values, unit="µm", **sizes):
    """An OME-TIFF with a position for each plane."""
    there = {"PositionZ": list(values)} | ({"PositionZUnit": [unit] * len(values)} if unit else {})
    sizes = {
        "PhysicalSizeX": 108.0,
        "PhysicalSizeXUnit": "nm",
        "PhysicalSizeY": 1.08,
        "PhysicalSizeYUnit": "Å",
    } | sizes
    sizes["PhysicalSizeY"] *= 1e3
    return {"ome": True, "metadata": {"axes": "ZYX", "Plane": there, **sizes}}


PLACEHOLDER = {"PhysicalSizeZ": 1.0, "PhysicalSizeZUnit": "µm"}
# What tifffile is to write; pixel and step in nanometres, and a part of the notes, or "" for none but those of sizes.
TIFFS = {
    "positions against a placeholder": (
        positions(10, 10.25, 10.5, **PLACEHOLDER), (108, 250),
        "250 nm apart by their positions (PositionZ), which was used; PhysicalSizeZ is 1 um"),
    "positions alone, falling": (positions(10, 9.75, 9.5), (108, 250), "a negative plane spacing"),
    "positions with jitter": (positions(10, 10.249, 10.502, PhysicalSizeZ=0.25), (108, 250), ""),
    "positions in millimetres": (positions(0, 25e-5, 50e-5, unit="mm"), (108, 250), ""),
    "positions that are not regular": (
        positions(10, 10.25, 10.75, PhysicalSizeZ=0.25), (108, 250), "are not regular, 0.25 to 0.5 µm apart"),
    "positions without a unit": (
        positions(10, 10.25, 10.5, unit="", **PLACEHOLDER), (108, 1000), "0.25 reference frame apart by their"),
    "positions of a reference frame that agree": (
        positions(10, 10.25, 10.5, unit="reference frame", PhysicalSizeZ=0.25), (108, 250), ""),
    "positions, and a step of a pixel": (
        positions(10, 10.25, 10.5, PhysicalSizeZ=1, PhysicalSizeZUnit="pixel"), (108, 250), ""),
    "a negative step": (positions(10, 10, 10, PhysicalSizeZ=-0.25), (108, 250), "states a negative plane spacing"),
    "one position": (positions(10, 10, 10, PhysicalSizeZ=0.25), (108, 250), ""),
    "positions that are no numbers": (positions("a", "b", "c", PhysicalSizeZ=0.25), (108, 250), ""),
    "imagej, micrometres": (resolved(1 / 0.108, "NONE", unit="um", spacing=0.25), (108, 250), ""),
    "imagej, escaped unit": (resolved(1 / 0.108, "NONE", unit="\\u00B5m", spacing=0.25), (108, 250), ""),
    "imagej, z in nanometres": (resolved(1 / 0.108, "NONE", unit="micron", zunit="nm", spacing=250), (108, 250), ""),
    "imagej, centimetres of both": (resolved(1 / 108e-7, "CENTIMETER", unit="cm", spacing=25e-6), (108, 250), ""),
    "imagej, centimetres alone": (resolved(1 / 108e-7, "CENTIMETER"), (108, None), ""),
    "imagej, micrometres and centimetres": (
        resolved(1 / 108e-7, "CENTIMETER", unit="um", spacing=0.25), (108, 250),
        "state pixels of 108 nm and were used; the ImageJ metadata state 0.0108 nm"),
    "imagej, micrometres and the inches of a print": (
        resolved(1 / 0.108, "INCH", unit="um", spacing=0.25), (108, 250), "state pixels of 2.743 mm; the ImageJ"),
    "imagej, pixels": (resolved(1.0, "NONE", unit="pixel"), (None, None), ""),
    "imagej, inches alone": (resolved(0.0254 / 108e-9, "INCH"), (108, None), ""),
    "tifffile's description": (
        {"resolution": (1 / 0.108,) * 2, "metadata": {"axes": "ZYX", "spacing": 0.25, "unit": "um"}}, (108, 250),
        "state pixels of 2.743 mm; the TIFF metadata state 108 nm"),
    "a unit and no resolution": ({"metadata": {"axes": "ZYX", "spacing": 0.25, "unit": "um"}}, (None, 250), ""),
    "sizes as of OME elsewhere": (
        {"metadata": {"axes": "ZYX", **{f"PhysicalSize{n}": 1.08e3 for n in "XYZ"}, "PhysicalSizeXUnit": "Å"}},
        (None, None), "a plane spacing of 1080 without a unit"),
    "plain, centimetres": (
        {"resolution": (1 / 108e-7,) * 2, "resolutionunit": "CENTIMETER"}, (108, None), "From the TIFF metadata"),
    "plain, a print": ({"resolution": (300, 300), "resolutionunit": "INCH"}, (None, None), ""),
    "ome and another resolution": (
        positions(0, 0.25, 0.5) | {"resolution": (1e5, 1e5), "resolutionunit": "CENTIMETER"}, (108, 250),
        "state pixels of 100 nm; the OME metadata state 108 nm"),
}  # fmt: skip


def test_positions_are_compared_within_one_channel(tmp_path):
    options = positions(10, 10.25, 10.5, 90, 90.3, 90.9, **PLACEHOLDER)
    options["metadata"]["axes"] = "CZYX"
    tifffile.imwrite(tmp_path / "a.tif", np.stack([STACK, STACK]), photometric="minisblack", **options)
    assert open_frames(tmp_path / "a.tif").metadata["step"] == pytest.approx(250e-9)


def test_dimensions_of_hdf5_have_the_same_order_or_are_refused(tmp_path):
    with h5py.File(tmp_path / "a.h5", "w") as file:
        stack = file.create_dataset("stack", data=STACK)
        for k, name in enumerate("tyx"):
            stack.dims[k].label = name
        assert open_frames(stack).axes == "TYX"
        stack.dims[2].label, stack.dims[1].label = "y", "x"
        with pytest.raises(ValueError, match="rows and columns as its last axes, got the axes t, x, y"):
            open_frames(stack)


@pytest.mark.parametrize("name", TIFFS)
def test_sizes_in_a_tiff_are_used_or_named(name, tmp_path):
    options, sizes, note = TIFFS[name]
    read = open_frames(tiff(tmp_path / "a.tif", **options)).as_channels(axes="ZYX")
    np.testing.assert_array_equal(read[0], STACK)
    found = [size and 1e9 * size for size in (read.metadata["pixel"], read.metadata["step"])]
    assert found == [None if size is None else pytest.approx(size, rel=5e-3) for size in sizes]
    assert note in " ".join(read.notes)
    assert note or all(text.startswith("From the") for text in read.notes)


def test_names_of_the_axes_of_an_array_are_those_of_its_images(tmp_path):
    values = np.zeros((2, 3, 4, 5), np.uint16)
    for kind in (lambda dims: xarray.DataArray(values, dims=dims), lambda dims: zarr.create_array(
        store={}, data=values, dimension_names=dims
    )):  # fmt: skip
        assert open_frames(kind(("z", "c", "y", "x"))).as_channels().shape == (3, 2, 4, 5)
        with pytest.raises(RecordingError, match="state it, such as axes"):
            open_frames(kind(("pose", "z", "y", "x"))).as_channels()
    with pytest.raises(ValueError, match="must have rows and columns as its last axes, got the axes x, y, z, c"):
        open_frames(kind(("x", "y", "z", "c")))


def test_voxels_that_cannot_be_used_are_named_together(tmp_path):
    sheared = folder(tmp_path / "a.zarr", multiscales(TRANSFORMS["sheared"][0]))
    lens = lm.Objective(NA=1.3, magnification=63, immersion=1.518)
    for given, words in (({}, r"give pixel= \(on the camera\) and step="), ({"pixel": 6.5e-6}, "give step=")):
        with pytest.raises(ValueError, match=rf"a.zarr states an affine .* cannot be used: {words}"):
            lm.microscopy.deconvolve(sheared, lens, wavelength=6e-7, noise=lm.Noise(read=1.0), **given)
