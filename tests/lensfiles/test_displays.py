"""What notebooks and interpreters show of lens and microscope files: their numbers, rounded, and a picture."""

from __future__ import annotations

import dataclasses
from html.parser import HTMLParser

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
