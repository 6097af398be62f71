"""What files say of their recording: absent, found, or stated and unusable."""

from __future__ import annotations

import math
from types import SimpleNamespace

import pytest

from lommel.recorded import frames
from lommel.recorded.frames import Unusable, open_frames

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
    assert frames.fits_metadata({"BUNIT": "electron", "GAIN": 4.0}) == {"gain": 1.0, "read": None, "saturation": None}
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
