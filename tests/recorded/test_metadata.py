"""What files say of their recording: absent, found, or stated and unusable."""

from __future__ import annotations

import math
import re
from types import SimpleNamespace

import numpy as np
import pytest
from astropy.io import fits

import lommel as lm
from lommel.cli.instruments import optics_notes
from lommel.recorded import frames
from lommel.recorded.frames import Unusable, open_frames
from lommel.recorded.headers import microscope_facts, size_notes, without_compared

OME = """<?xml version="1.0"?><OME xmlns="http://www.openmicroscopy.org/Schemas/OME/2016-06">
<Instrument ID="Instrument:0">
<Objective ID="Objective:0" LensNA="0.8" NominalMagnification="20"/>
<Objective ID="Objective:1" LensNA="1.4" NominalMagnification="63" CalibratedMagnification="62.7"/>
</Instrument>
<Image ID="Image:0" Name="a">{used}<Pixels ID="Pixels:0" SizeX="4" SizeY="4" SizeC="1" SizeZ="1" SizeT="1"
PhysicalSizeX="65" PhysicalSizeXUnit="nm"><Channel ID="C:0" {wave}/></Pixels></Image></OME>"""


def said(used: str = "", wave: str = "") -> dict:
    file = SimpleNamespace(ome_metadata=OME.format(used=used, wave=wave), series=[SimpleNamespace(name="a")])
    return frames.ome_metadata(file, 0)


def test_the_objective_is_the_one_that_the_image_names():
    one = said('<ObjectiveSettings ID="Objective:1" RefractiveIndex="1.518"/>')
    assert (one["NA"], one["magnification"], one["immersion"]) == (1.4, 62.7, 1.518)
    assert said('<ObjectiveSettings ID="Objective:0"/>')["NA"] == 0.8
    for other in ("", '<ObjectiveSettings ID="Objective:7"/>'):  # of two, nothing says which
        assert "NA" not in said(other)


@pytest.mark.parametrize(
    ("value", "unit", "found"),
    [
        (None, "nm", None),
        ("", "nm", None),
        ("0.3", "", Unusable("0.3 without a unit")),
        ("0.3", "furlong", Unusable("0.3 furlong")),
        ("0", "nm", Unusable("0 nm")),
        ("nan", "nm", Unusable("nan nm")),
        ("thick", "nm", Unusable("thick nm")),
        (1.0, None, None),
        (1.0, "pixel", None),
    ],
)
def test_lengths_have_three_outcomes(value, unit, found):
    assert frames.length(value, unit) == found
    assert frames.length("-0.3", "micron") == pytest.approx(3e-7)


def test_numbers_of_fits_headers_have_three_outcomes():
    assert frames.fits_metadata({}) == {"gain": None, "read": None, "saturation": None}
    found = frames.fits_metadata({"EGAIN": "1.3", "READNOIS": 0, "SATLEVEL": math.inf, "GAIN": 120})
    assert (found["gain"], found["read"], found["saturation"]) == (1.3, 0.0, Unusable("inf"))
    assert "unsure" not in found
    assert frames.fits_metadata({"GAIN": 120})["unsure"] == "GAIN = 120"
    electrons = {"gain": 1.0, "read": None, "saturation": None, "electrons": "electron"}
    assert frames.fits_metadata({"BUNIT": "electron", "GAIN": 4.0}) == electrons
    assert frames.fits_metadata({"RDNOISE": -1})["read"] == Unusable("-1")


def test_a_wavelength_in_the_wrong_unit_is_no_wavelength(tmp_path):
    import tifffile

    sizes = {"PhysicalSizeX": 0.1, "PhysicalSizeY": 0.1, "PhysicalSizeZ": 0.3}
    for value, unit in ((0.52, "nm"), (520, "µm"), (0, "nm")):
        meta = {"axes": "ZYX", **sizes, "Channel": {"EmissionWavelength": value, "EmissionWavelengthUnit": unit}}
        tifffile.imwrite(tmp_path / "a.ome.tif", [[[1, 2], [3, 4]]] * 3, metadata=meta, dtype="uint16")
        with open_frames(tmp_path / "a.ome.tif").as_channels() as found:
            assert found.metadata["emission"] == (None,)
            assert "emission 0" in found.metadata["unusable"]
            assert any("the emission of channel 0 is" in note and "cannot be used" in note for note in found.notes)


def test_files_that_state_electron_multiplication_state_its_excess_noise():
    assert frames.fits_metadata({"EMGAIN": 300})["excess"] == 2.0
    assert "excess" not in frames.fits_metadata({"EMGAIN": 1})
    detector = '<Detector ID="Detector:0" Type="{}"/></Instrument>'
    for kind, found in (("EMCCD", 2.0), ("CMOS", None)):
        text = OME.format(used="", wave="").replace("</Instrument>", detector.format(kind), 1)
        assert detector.format(kind) in text
        file = SimpleNamespace(ome_metadata=text, series=[SimpleNamespace(name="a")])
        assert frames.ome_metadata(file, 0).get("excess") == found


def test_microscopes_that_images_state_are_compared_with_the_one_in_use():
    objective = SimpleNamespace(NA=1.4, magnification=63.0, immersion=1.518)
    facts = microscope_facts(objective, 520e-9) | {"pixel": 1e-7, "down": 1e-7, "step": 2e-7}
    stated = {"NA": 1.4, "magnification": 63.0, "immersion": 1.515, "emission": [525e-9], "step": 2e-7, "down": 1e-7}
    assert size_notes(stated | {"pixel": 1e-7, "modality": ("widefield", "AcquisitionMode WideField")}, **facts) == {}
    others = {
        "NA": (1.2, "an NA of 1.2, but 1.4"),
        "magnification": (100.0, "a magnification of 100, but 63"),
        "immersion": (1.333, "an immersion of the index 1.333, but 1.518"),
        "emission": ((610e-9,), "an emission of 610 nm, but 520 nm"),
        "down": (2e-7, "pixels 200 nm high, but 100 nm"),
        "pixel": (Unusable("0.1 pixel"), "0.1 pixel in the sample, which is no length in a known unit: 100 nm was"),
        "modality": (("confocal", "PinholeSize 50"), "PinholeSize 50, but a widefield microscope"),
        "is_step_negative": (True, "a negative plane spacing"),
    }
    for key, (value, words) in others.items():
        (note,) = size_notes(stated | {key: value}, **facts).values()
        assert words in note
    assert not size_notes(stated | {"is_step_negative": True}, **facts | {"step": -2e-7})


def test_detectors_and_modes_of_ome_are_stated(tmp_path):
    wave = 'AcquisitionMode="SpinningDiskConfocal"><DetectorSettings ID="D:0" Binning="2x2" Gain="0.5"/></Channel'
    text = OME.format(used="", wave=wave).replace("/></Pixels>", "></Pixels>")
    text = text.replace(" SizeX=", ' SignificantBits="12" SizeX=')
    found = frames.ome_metadata(SimpleNamespace(ome_metadata=text, series=[SimpleNamespace(name="a")]), 0)
    assert found["modality"] == ("spinning disc", "AcquisitionMode SpinningDiskConfocal")
    (note,) = found["notes"]
    assert "state Binning 2x2, Gain 0.5, SignificantBits 12 of the detector, not used" in note
    assert "modality" not in said()
    assert said(wave='PinholeSize="50"')["modality"] == ("confocal", "PinholeSize 50")


def test_signed_integers_of_imagej_are_read_and_other_calibrations_named(tmp_path):
    import tifffile

    signed = np.arange(-6, 6, dtype=np.int16).reshape(2, 2, 3)
    for constant, slope, values in ((-32768, 1, signed), (0, 0.46, None)):
        stored = (signed.astype(int) + 32768).astype(np.uint16)
        tifffile.imwrite(tmp_path / "a.tif", stored, imagej=True, metadata={"axes": "ZYX"})
        text = tifffile.tiffcomment(tmp_path / "a.tif").rstrip() + f"\ncf=0\nc0={constant}\nc1={slope}\nvunit=x\n"
        tifffile.tiffcomment(tmp_path / "a.tif", text.encode())
        with open_frames(tmp_path / "a.tif") as images:
            np.testing.assert_array_equal(images[...], stored if values is None else values)
            assert ("calibration 0 + 0.46 * value (x), which was not applied" in " ".join(images.notes)) is (
                values is None
            )


def fits_file(path, values, *, unit=None, **cards):
    image = fits.PrimaryHDU(np.asarray(values))
    for name, card in cards.items():
        image.header[name] = card
    if unit:
        image.header["BUNIT"] = unit
    image.writeto(path, overwrite=True)
    return path


COUNTS = np.arange(20.0, dtype=np.float32).reshape(4, 5)


@pytest.mark.parametrize(
    ("cards", "note"),
    [
        ({"ROWORDER": "BOTTOM-UP"}, r"ROWORDER = BOTTOM-UP, .* sine terms \(m < 0: coma y, .* change sign"),
        ({"FLIPSTAT": "Flip"}, "FLIPSTAT = Flip, .* change sign"),
        ({"XPIXSZ": 7.6, "YPIXSZ": 7.6}, r"states XPIXSZ = 7.6, YPIXSZ = 7.6, not used: pixel, focal length"),
        (
            {"FOCALLEN": 2000, "SCALE": 0.8, "ROWORDER": "TOP-DOWN"},
            "states SCALE = 0.8, FOCALLEN = 2000, not used: .* wavelength are those given",
        ),
        (
            {"BUNIT": "MJy/sr"},
            "BUNIT = MJy/sr, not counts: photon noise is right only if the gain is in electrons per",
        ),
        ({"BUNIT": "adu/s"}, "BUNIT = adu/s, not counts"),
        ({"CCDXBIN": 2, "FILTER": "R", "COLORTYP": "GRAY"}, "states CCDXBIN = 2, FILTER = R, not used.$"),
        ({"COLORTYP": "RGGB"}, "COLORTYP = RGGB, a mosaic of colours"),
        ({"STACKCNT": 9}, "that 9 images were combined, .* mean state 9 times the gain .* 3 times the read noise"),
        ({"WAVELNTH": 6563.0, "WAVEUNIT": "furlong"}, "states WAVELNTH = 6563.0, not used.$"),
    ],
)
def test_cards_that_turn_or_scale_images_are_named_with_what_they_change(tmp_path, cards, note):
    with open_frames(fits_file(tmp_path / "a.fits", COUNTS, **cards)) as images:
        (found,) = images.notes
        assert re.search(note, found), found
        assert isinstance(images.metadata["gain"], Unusable) is ("BUNIT" in cards)
    ordinary = {"XBINNING": 1, "CCDSUM": "1 1", "FILTER": "", "BUNIT": "ADU / pixel"}
    with open_frames(fits_file(tmp_path / "a.fits", COUNTS, **ordinary)) as images:
        assert images.notes == ()


def test_cards_of_unequal_sides_wavelengths_colours_and_planes_are_named_used_or_refused(tmp_path):
    for cards in ({"XPIXSZ": 3.8, "YPIXSZ": 7.6}, {"XBINNING": 1, "YBINNING": 2}):
        with open_frames(fits_file(tmp_path / "a.fits", COUNTS, **cards)) as images:
            assert "pixels that are not square: pixel= must state" in images.notes[0]
    lens = lm.Lens(focal_length=2.0, aperture_diameter=0.2, wavelength=550e-9)
    for cards in ({"WAVELEN": 656.3e-9}, {"WAVELNTH": 6563, "WAVEUNIT": "angstrom"}, {"WAVELEN": 656.3}):
        with open_frames(fits_file(tmp_path / "a.fits", COUNTS, **cards)) as images:
            (note,) = optics_notes("It", images.metadata, 4e-6, lens)
            assert note == "It states a wavelength of 656.3 nm; 550 nm was used."
            assert without_compared(images.notes) == []
    for card in ({"CTYPE3": "RGB"}, {"COLORTYP": "RGB"}):
        with pytest.raises(frames.RecordingError, match=r"a.fits: it holds colours .* = RGB., not planes"):
            open_frames(fits_file(tmp_path / "a.fits", [COUNTS] * 3, **card))
    with open_frames(fits_file(tmp_path / "a.fits", [COUNTS] * 3, CDELT3=-0.1, CUNIT3="um")) as images:
        assert (images.metadata["step"], images.metadata["is_step_negative"]) == (pytest.approx(1e-7), True)


def test_the_width_of_a_pixel_on_the_sky_is_that_of_astropy(tmp_path):
    from astropy.wcs import WCS, utils

    for cards in (
        {"CTYPE1": "RA---TAN", "CTYPE2": "DEC--TAN", "CDELT1": -2.7e-4, "CDELT2": 3.1e-4},
        {"CTYPE1": "RA---TAN", "CTYPE2": "DEC--TAN", "CD1_1": 1e-4, "CD1_2": 3e-4, "CD2_1": -2e-4, "CD2_2": 1e-4},
        {"CTYPE1": "GLON-CAR", "CTYPE2": "GLAT-CAR", "CUNIT1": "arcsec", "CUNIT2": "arcsec", "CDELT1": 0.97},
    ):
        world = WCS(header := fits.Header(cards))
        expected = np.deg2rad(utils.proj_plane_pixel_scales(world)[0])
        for given in (header, world.to_header()):  # the latter has PC, and degrees
            with open_frames(fits_file(tmp_path / "a.fits", COUNTS, **given)) as images:
                assert images.metadata["scale"] == pytest.approx(expected)
                assert re.search(
                    r"states pixels of \S+ (deg|arcsec) by its world coordinates", " ".join(images.notes)
                )
    for cards in (
        {"CDELT1": 2.0, "CTYPE1": "LINEAR"},
        {"CDELT1": 0.1, "CUNIT1": "s"},
        {"CDELT1": 1e-9, "CUNIT1": "m", "CTYPE1": "WAVE"},
        {"PIXSCALE": (9.0, "[um]")},
    ):
        with open_frames(fits_file(tmp_path / "a.fits", COUNTS, **cards)) as images:
            assert not images.metadata.keys() & {"scale", "plane_pixel"}


def test_images_of_counts_have_the_lens_of_their_exif_and_several_files_that_of_each(tmp_path):
    from PIL import Image

    for name, focal, resolution in (("0.tif", 50.0, 2500.0), ("1.png", 85.0, 2500.0), ("2.tif", 50.0, 0.0)):
        tags = Image.Exif()
        tags[0x8769] = {0x920A: focal, 0x829D: 2.8, 0xA20E: resolution, 0xA210: 3}
        Image.fromarray(COUNTS.astype(np.uint16)).save(tmp_path / name, exif=tags.tobytes())
    paths = [tmp_path / name for name in ("0.tif", "1.png", "2.tif")]
    with open_frames(paths[0]) as images:
        assert images.metadata["focal_length"] == pytest.approx(0.05)
        assert (images.metadata["f_number"], images.metadata["sensor_pixel"]) == pytest.approx((2.8, 4e-6))
    metadata = open_frames(*paths).metadata
    assert metadata["focal_length"] == pytest.approx((0.05, 0.085, 0.05))
    assert metadata["sensor_pixel"] == pytest.approx((4e-6, 4e-6))
    lens = lm.Lens(focal_length=0.05, f_number=2.8, wavelength=550e-9)
    (note,) = optics_notes("It", metadata, 4e-6, lens)
    assert note == "It states a focal length of 85 mm; 50 mm was used."


def test_files_of_two_orders_of_rows_are_refused(tmp_path):
    paths = [
        fits_file(tmp_path / f"{k}.fits", COUNTS, ROWORDER=order) for k, order in enumerate(("TOP-DOWN", "BOTTOM-UP"))
    ]
    with pytest.raises(frames.RecordingError, match=r"0.fits states ROWORDER = TOP-DOWN, but 1.fits states ROWORDER"):
        open_frames(*paths)


def test_comments_of_cards_state_units_of_gain_and_read_noise(tmp_path):
    def metadata(**cards):
        with open_frames(fits_file(tmp_path / "a.fits", COUNTS, **cards)) as images:
            return images.metadata

    assert metadata(EGAIN=0.5, RDNOISE=(7.0, "[ADU] read noise"))["read"] == 3.5
    assert metadata(EGAIN=0.5, RDNOISE=(7.0, "read noise in electrons"))["read"] == 7.0
    assert metadata(EGAIN=0.5, RDNOISE=7.0)["read"] == 7.0
    assert metadata(EGAIN=0.5, RDNOISE=(7.0, "[ADU] read noise"), BUNIT="electron")["read"] == 3.5
    assert metadata(RDNOISE=(7.0, "counts"))["read"] == Unusable("7 counts, without a gain")
    assert metadata(GAIN=(1.4, "[e-/ADU] gain"))["gain"] == 1.4
    assert metadata(GAIN=(139, "sensor gain"))["unsure"] == "GAIN = 139"


@pytest.mark.parametrize("name", ["a.png", "a.tif"])
def test_images_of_counts_that_state_an_encoding_are_named(tmp_path, name):
    import tifffile
    from PIL import Image, ImageCms

    stated = ImageCms.ImageCmsProfile(ImageCms.createProfile("sRGB")).tobytes()
    values = COUNTS.astype(np.uint8)
    if name == "a.png":
        Image.fromarray(values).save(tmp_path / name, icc_profile=stated)
    else:
        tifffile.imwrite(tmp_path / name, values, iccprofile=stated)
    with open_frames(tmp_path / name) as images:
        assert images.notes == ("The file states values sRGB; they were taken as linear counts.",)
