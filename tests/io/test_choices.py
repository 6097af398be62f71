"""Files that hold several images, written by other libraries: one is named in brackets, never taken in silence."""

from __future__ import annotations

import h5py
import numpy as np
import pytest
import tifffile
from astropy.io import fits

import lommel as lm
from lommel.base import reading
from lommel.cli.instruments import mask_of
from lommel.imaging import read_depth, read_photo
from lommel.io.opd_files import OPDFileError
from lommel.lensfiles.lens_files import load_instrument
from lommel.recorded.stack_files import kind_of

LENS = """
[lens]
focal_length = "50 mm"
f_number = 2.0
wavelength = "550 nm"
[sensor]
pixel = "3.45 um"
shape = 33
[aperture.mask]
file = "{}"
"""
MAPS = {"BEFORE": np.zeros((6, 6)), "AFTER": np.arange(36.0).reshape(6, 6)}


def several_maps(path, **cards):
    units = [fits.PrimaryHDU(), *(fits.ImageHDU(values, name=name) for name, values in MAPS.items())]
    for unit in units[1:]:
        unit.header.update({"BUNIT": "nm", "PUPLSCAL": 0.05} | cards)
    fits.HDUList(units).writeto(path)
    return path


def surfaces(path):
    with h5py.File(path, "w") as file:
        for name, values in MAPS.items():
            file[f"Data/Surface/{name}"] = values
            file[f"Data/Surface/{name}"].attrs["Unit"] = "Nanometers"
    return path


@pytest.mark.parametrize(("write", "name"), [(several_maps, "a.fits"), (surfaces, "a.datx")])
def test_one_of_several_opd_maps_is_named(write, name, tmp_path):
    path = write(tmp_path / name)
    # HDF5 lists names in alphabetical order.
    with pytest.raises(
        OPDFileError, match=r"it holds 2 images, (\[BEFORE\] of 6 x 6|\[AFTER\] of 6 x 6), .*: name one"
    ):
        lm.load_opd(path)
    for part, values in MAPS.items():
        found = lm.load_opd(f"{path}[{part.lower()}]", unit="nm")
        np.testing.assert_allclose(found.values, 1e-9 * values)
    with pytest.raises(OPDFileError, match="name one"):
        lm.load_opd(f"{path}[NEITHER]")
    np.save(tmp_path / "a.npy", MAPS["AFTER"])
    with pytest.raises(OPDFileError, match=r"it holds one map: omit \[1\]"):
        lm.load_opd(f"{tmp_path}/a.npy[1]", unit="nm")


def test_a_number_is_that_of_an_image_even_if_another_has_it_for_a_name(tmp_path):
    assert reading.only("ab", [["1", "0"], ["x", "1"]], ["", ""], "1", "f") == "b"
    assert reading.part_of(tmp_path / "missing.fits[1]") == (tmp_path / "missing.fits[1]", None)


def test_a_link_to_a_surface_is_no_second_one(tmp_path):
    with h5py.File(tmp_path / "a.datx", "w") as file:
        file["Data/Surface/x"] = MAPS["AFTER"]
        file["Measurement/Surface"] = file["Data/Surface/x"]
    assert lm.load_opd(tmp_path / "a.datx", unit="m").values[5, 5] == 35.0


def test_spacings_of_a_header_are_used_named_or_refused(tmp_path):
    def read(name, **cards):
        return lm.load_opd(f"{several_maps(tmp_path / name, **cards)}[2]")

    assert read("a.fits", CDELT1=50.0, CUNIT1="mm", CDELT2=5e4, CUNIT2="um").spacing == 0.05
    with pytest.warns(UserWarning, match="CDELT1 in deg, which is no spacing and was not used"):
        read("b.fits", CDELT1=0.15, CUNIT1="deg")
    for k, cards in enumerate(({"CDELT1": 0.05}, {"CDELT1": 50.0, "CDELT2": 40.0, "CUNIT2": "mm"})):
        with pytest.raises(OPDFileError, match=r"it states the spacings .*, which differ"):
            read(f"{k}.fits", CUNIT1="mm", **cards)


def test_an_extension_has_the_unit_of_a_first_header_without_an_image(tmp_path):
    units = [fits.PrimaryHDU(), fits.ImageHDU(MAPS["AFTER"])]
    units[0].header.update(BUNIT="nm", PUPLSCAL=0.05)
    fits.HDUList(units).writeto(tmp_path / "a.fits")
    assert lm.load_opd(tmp_path / "a.fits").values.max() == pytest.approx(35e-9)


def test_one_of_several_pages_is_named_in_photographs_and_depth_maps(tmp_path):
    pages = np.stack([np.full((4, 5), 7, np.uint8), np.full((4, 5), 9, np.uint8)])
    tifffile.imwrite(tmp_path / "a.tif", pages, photometric="minisblack")
    assert read_photo(f"{tmp_path}/a.tif[1]").values.max() == 9
    assert read_depth(f"{tmp_path}/a.tif[1]", scale=1.0).max() == 9.0
    for read in (read_photo, lambda path: read_depth(path, scale=1.0)):
        with pytest.raises(ValueError, match=r"it holds 2 images, \[0\] of 4 x 5, \[1\] of 4 x 5: name one"):
            read(tmp_path / "a.tif")
    tifffile.imwrite(tmp_path / "b.tif", pages, photometric="minisblack", truncate=True)  # one page states both
    with pytest.raises(ValueError, match="it describes 2 images"):
        read_photo(tmp_path / "b.tif")
    lm.imaging.write_photo(tmp_path / "a.png", np.ones((4, 5), np.float32))
    with pytest.raises(ValueError, match=r"it holds one image: omit \[1\]"):
        read_photo(f"{tmp_path}/a.png[1]")


def test_an_aperture_in_a_lens_file_is_one_that_is_named(tmp_path):
    units = [
        fits.PrimaryHDU(),
        fits.ImageHDU(np.ones((8, 8)), name="FULL"),
        fits.ImageHDU(np.eye(8), name="DIAGONAL"),
    ]
    fits.HDUList(units).writeto(tmp_path / "a.fits")
    (tmp_path / "lens.toml").write_text(LENS.format("a.fits[diagonal]"))
    np.testing.assert_array_equal(load_instrument(tmp_path / "lens.toml").pupil().mask.values, np.eye(8))
    np.save(tmp_path / "a.npy", np.eye(8))
    with pytest.raises(ValueError, match=r"a.npy holds one image: omit \[1\]"):
        lm.recorded.open_frames(f"{tmp_path}/a.npy[1]")
    (tmp_path / "lens.toml").write_text(LENS.format("a.npy[1]"))
    with pytest.raises(ValueError, match=r"'a.npy' holds one array: omit \[1\]"):
        load_instrument(tmp_path / "lens.toml")
    (tmp_path / "lens.toml").write_text(LENS.format("a.fits"))
    with pytest.raises(ValueError, match=r"it holds 2 images, \[FULL\] of 8 x 8, \[DIAGONAL\] of 8 x 8: name one"):
        load_instrument(tmp_path / "lens.toml")


def test_a_mask_is_one_that_is_named_and_notes_on_it_are_told(tmp_path):
    images, path = np.zeros((1, 8, 8)), tmp_path / "mask.ome.tif"
    with tifffile.TiffWriter(path, ome=True) as file:
        for k, side in ((2, 8), (3, 4)):  # the second is a thumbnail
            mask = np.zeros((side, side), np.uint8)
            mask[k] = 1
            file.write(mask, metadata={"axes": "YX"})
    with pytest.warns(UserWarning, match=r"--mask: The file holds 2 images, .* image 0"):
        assert mask_of(path, images)[2].all()
    assert mask_of(tmp_path / "mask.ome.tif[1]", images[:, :4, :4])[3].all()
    with pytest.raises(ValueError, match="must not replace the recording"):
        kind_of(path, f"{path}[1]")
