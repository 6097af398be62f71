"""Images of FITS files with their cards; headers that state more than there is are refused."""

from __future__ import annotations

import gzip

import numpy as np
import pytest

from lommel.io import fits_images

VALUES = np.arange(12.0).reshape(3, 4)
FILE = fits_images.write([(VALUES, {"BUNIT": ("m", "a comment"), "NUMBER": 2.5})])


@pytest.mark.parametrize("data", [FILE, gzip.compress(FILE)], ids=["plain", "packed"])
def test_images_come_with_their_cards(data):
    ((values, header, number, primary, comments),) = fits_images.read(data, 12)
    assert (number, primary, comments["BUNIT"]) == (0, header, "a comment")
    np.testing.assert_array_equal(values, VALUES)
    assert values.dtype == np.float64
    assert (header["BUNIT"], header["NUMBER"]) == ("m", 2.5)


@pytest.mark.parametrize("side", [b"99999", b"2000000000", b"0", b"-4"])
def test_a_header_that_claims_more_values_than_there_are_is_refused(side):
    at = FILE.index(b"NAXIS1  =")
    claimed = FILE[:at] + b"NAXIS1  =" + side.rjust(21) + FILE[at + 30 :]
    with pytest.raises((ValueError, UserWarning), match=r"-?\d+ x 3 values, more than the file holds|may have been"):
        fits_images.read(claimed, 2**20)


def test_more_values_than_asked_for_are_refused():
    with pytest.raises(ValueError, match="it states 4 x 3 values, more than the file holds or than 11"):
        fits_images.read(FILE, 11)
    twice = fits_images.write([(VALUES, {}), (VALUES, {})])
    assert len(fits_images.read(twice, 24)) == 2
    with pytest.raises(ValueError, match="more than the file holds or than 23"):
        fits_images.read(twice, 23)


def test_files_without_images_are_refused_by_what_they_hold(tmp_path):
    from astropy.io import fits

    def message(*units: object) -> str:
        fits.HDUList(list(units)).writeto(tmp_path / "a.fits", overwrite=True)
        with pytest.raises(ValueError, match="it holds") as error:
            fits_images.read((tmp_path / "a.fits").read_bytes(), 1000)
        return str(error.value)

    table = fits.BinTableHDU.from_columns([fits.Column("A", "D", array=np.arange(3.0))])
    groups = fits.GroupsHDU(fits.GroupData(np.zeros((4, 2, 3), np.float32), parnames=["u"], pardata=[np.arange(4.0)]))
    assert message(fits.PrimaryHDU(), table) == "it holds no image, but tables only"
    assert message(fits.PrimaryHDU()) == "it holds no image, but headers without data"
    assert "compressed in a table (.fz)" in message(fits.PrimaryHDU(), fits.CompImageHDU(np.zeros((4, 4), np.int16)))
    assert message(groups) == "it holds random groups, which are not read: save the images as image extensions"
