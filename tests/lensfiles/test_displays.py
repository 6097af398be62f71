"""What notebooks and interpreters show of lens and microscope files: their numbers, rounded, and a picture."""

from __future__ import annotations

import dataclasses
import re
from html.parser import HTMLParser

import pytest

import lommel as lm
from lommel.lensfiles.example_files import example_files


class Cells(HTMLParser):
    """The cells of the tables of a page, names and values in turn."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.found: list[str] = []
        self.inside = False
        self.feed(page)
        self.close()

    def handle_starttag(self, tag, attrs):
        self.inside = tag in ("th", "td")
        self.found += [""] if self.inside else []

    def handle_data(self, data):
        if self.inside:
            self.found[-1] += data


def rows(page: str) -> dict[str, str]:
    found = Cells(page).found
    return dict(zip(found[::2], found[1::2], strict=True))


def test_an_instrument_is_shown_with_its_psf_and_rounded_numbers(lenses):
    instrument = lm.load_instrument(lenses["nifty-fifty"])
    page = instrument._repr_html_()
    told = rows(page)
    assert "<img" in page
    assert "border-top" in page  # the scale bar
    assert "Instrument: 50 mm f/1.8 camera lens" in page
    assert (told["lens"], told["wavelength"], told["pixels"]) == ("f = 50 mm, f/1.8", "550 nm", "3.45 µm")
    assert (told["focused at"], told["object at"]) == ("2 m", "1.5 m")
    assert told["aberrations (waves)"] == "W020 = 29.23, W040 = 0"
    assert told["Strehl ratio"] == f"{float(lm.strehl(instrument.pupil())):.4g} on the axis"
    assert told["source"] == instrument.source


@pytest.mark.parametrize("name", ["nifty-fifty", "camera-field", "newtonian-off-axis", "zeiss-63x-1.4-oil"])
def test_no_number_has_more_digits_than_it_is_worth(name):
    load = lm.load_microscope if name.startswith("zeiss") else lm.load_instrument
    thing = load(example_files()[name])
    for text in (repr(thing), re.sub(r"base64,[^\"]*", "", thing._repr_html_())):
        assert not re.search(r"\d\.\d{7}", text)
    assert "\n" not in repr(thing)
    assert len(repr(thing)) < 250


def test_a_microscope_is_shown_with_lengths_in_the_sample_and_degrees():
    microscope = lm.load_microscope(example_files()["zeiss-63x-1.4-oil"])
    tilted = dataclasses.replace(microscope, emitter=lm.Dipole(polar=1.0471975511965976, azimuth=0.0))
    told = rows(tilted._repr_html_())
    assert told["objective"] == "NA 1.4, 63x, immersion 1.518"
    assert told["pixels"] == "103.2 nm in the sample (6.5 µm on the camera)"
    assert told["emitter"] == "dipole, 60° from the axis, azimuth 0°, 2 µm deep"
    assert told["planes"] == "64, 100 nm apart"
    assert "<img" in tilted._repr_html_()
    assert repr(microscope).startswith("<Microscope 'Zeiss Plan-Apochromat 63x/1.4 Oil DIC, in water': NA 1.4, 63x, ")


def test_what_cannot_be_computed_does_not_raise(lenses):
    instrument = lm.load_instrument(lenses["nifty-fifty"])
    near = dataclasses.replace(instrument, object_distance=-1.0)
    page = near._repr_html_()
    assert "object_distance must be" in page
    assert "<img" not in page
