"""The controls of the live page, the states that lens files are shown by, and the PSF of a state."""

from __future__ import annotations

import math
from pathlib import Path
from urllib.parse import parse_qsl

import numpy as np
import pytest

import lommel as lm
from lommel.page.state import FIELDS, complete, further_terms, link, psf_of, pupil_of, state_of

LENSES = sorted((Path(__file__).parents[2] / "examples" / "lenses").glob("*.toml"))


@pytest.mark.parametrize("path", LENSES, ids=lambda path: path.stem)
def test_a_lens_file_is_shown_by_a_state_of_the_same_pupil(path):
    instrument = lm.load_instrument(path)
    state, left_out = state_of(instrument)
    assert set(state) <= set(FIELDS)
    found, given = pupil_of(state), instrument.pupil()
    # Of the expansion of an aplanatic phase the terms above degree 12.
    assert ("further Zernike terms, 9e-07 waves rms" in left_out) == (path.stem == "microscope-20x")
    size = 2e-7 if path.stem != "microscope-20x" else 2e-5
    difference = (found.wavefront - given.wavefront).edge_terms()
    assert max((abs(float(c)) for term, c in difference.items() if term != (0, 0)), default=0.0) <= size * (
        1 + lm.rms(given)
    )
    for name in ("f_number", "obscuration", "wavelength"):
        assert math.isclose(getattr(found, name), getattr(given, name), rel_tol=1e-8)
    assert complete(state)["pixel"] == pytest.approx(1e6 * instrument.pixel, rel=1e-8)
    assert (state.get("focus") == "distances") == (path.stem in ("nifty-fifty", "phone", "fast-portrait"))
    assert (given.spider is None) == (found.spider is None)
    if given.spider:
        x, y = np.random.default_rng(2).uniform(-1, 1, (2, 1000))
        assert found.spider.margin(x, y) == pytest.approx(given.spider.margin(x, y), abs=1e-8)


def test_a_lens_with_a_measured_field_is_shown_as_on_the_axis():
    lens = lm.Lens(focal_length=50e-3, f_number=4, focus_distance=2.0, wavelength=550e-9)
    waves = lm.Wavefront.zernike({(4, 0): [0.1, 0.1], (3, 1): [0.0, 0.2]}, unit="waves", normalization="edge")
    field = lm.FieldMap.radial([0.0, 5e-3], waves, aperture=lens.pupil().unaberrated())
    instrument = lm.Instrument("", "", lens, 1.9, 3e-6, None, {}, sensor=(6e-3, 8e-3), aberrations_of_field=field)
    state, left_out = state_of(instrument)
    assert state["spherical"] == pytest.approx(0.6)  # W040 of 0.1 (6 rho^4 - 6 rho^2 + 1)
    assert left_out == "aberrations of the field but those on the axis"


def test_what_a_page_cannot_show_of_a_lens_is_said():
    shapes = {"spider": lm.Spider(0.02, (0.0, 1.0)), "apodization": 0.2, "vignetting": lm.Ellipse(1, 0.8)}
    shapes |= {"stop": lm.Disc() - lm.Disc(0.5), "mask": lm.Mask(np.ones((64, 64)))}
    for kind, shape in shapes.items():
        lens = lm.Lens(focal_length=50e-3, f_number=4, focus_distance=2.0, wavelength=550e-9, **{kind: shape})
        state, left_out = state_of(lm.Instrument("", "", lens, 1.9, 3e-6, None, {}))
        assert left_out == f"the {kind}"
        assert "vanes" not in state


@pytest.mark.parametrize("count", [1, 2, 3, 7])
def test_vanes_of_a_lens_file_are_those_of_the_state(count):
    spider = lm.Spider.equal(count, 0.05, 2.5)
    lens = lm.Lens(focal_length=1.0, aperture_diameter=0.1, wavelength=550e-9, obscuration=0.2, spider=spider)
    state, left_out = state_of(lm.Instrument("", "", lens, math.inf, 3e-6, None, {}))
    x, y = np.random.default_rng(3).uniform(-1, 1, (2, 1000))
    assert left_out == ""
    assert pupil_of(state).spider.margin(x, y) == pytest.approx(spider.margin(x, y), abs=1e-8)


def test_a_state_is_whole_and_checked():
    assert complete({})["defocus"] == FIELDS["defocus"].initial
    assert complete({"side": 64, "view": "averaged"}) | {} == {
        name: {"side": 64, "view": "averaged"}.get(name, field.initial) for name, field in FIELDS.items()
    }
    with pytest.raises(ValueError, match=r"must be one of 'focus', .* got 'field'"):
        complete({"field": 1.0})
    with pytest.raises(ValueError, match=r"coma must be from 0 to 10 waves, got 11"):
        complete({"coma": 11})
    with pytest.raises(ValueError, match="defocus"):
        complete({"defocus": math.nan})


def test_further_zernike_terms_are_checked_one_by_one():
    text = "4,2:0.05;6,0:-.01;5,-5:1e-3"
    assert complete({"zernike": text})["zernike"] == text
    assert further_terms(text) == {(4, 2): 0.05, (6, 0): -0.01, (5, -5): 1e-3}
    for wrong in ("4,1:1", "0,0:1", "2,4:1", "13,1:1", "4,0:11", "4,0:nan", "4,0:1;4,0:2", "4,0", "x", "4,0:1e999"):
        with pytest.raises(ValueError, match=r"zernike must be up to 90 different terms 'n,m:waves'"):
            complete({"zernike": wrong})


def test_a_link_says_what_differs_and_says_it_exactly():
    assert link({}) == ""
    state = {"defocus": 0.1 + 0.2, "f_number": 2.0, "view": "sampled", "focal_length": 1e6, "zernike": "4,2:.1"}
    assert link(state) == ("defocus=0.30000000000000004&zernike=4,2:.1&focal_length=1000000&f_number=2&view=sampled")
    assert dict(parse_qsl(link(state))).keys() == state.keys()


@pytest.mark.parametrize("view", ["fine", "sampled", "averaged"])
@pytest.mark.parametrize("light", ["mono", "white"])
def test_the_psf_of_a_state_is_that_of_its_pupil(view, light):
    state = {"defocus": 0.5, "coma": 0.3, "coma_angle": 30.0, "side": 32, "view": view, "light": light}
    found = psf_of(state, dtype=np.float64)
    wavefront = lm.Wavefront.from_seidel(W020=0.5) + lm.Wavefront.zernike(
        {(3, 1): 0.3 * math.cos(math.pi / 6), (3, -1): 0.3 * math.sin(math.pi / 6)},
        unit="waves",
        normalization="edge",
    )
    pupil = lm.Pupil(wavefront, wavelength=550e-9, f_number=4)
    white = lm.methods.Polychromatic(np.linspace(450e-9, 650e-9, 7), [1] * 7)
    method = white if light == "white" else lm.methods.NijboerZernike()
    pixel = found.pixel if view == "fine" else 2e-6
    given = lm.psf(pupil, 32, pixel, method=method, integrate=view == "averaged", dtype=np.float64)
    assert np.abs(found.values - given.values).max() <= 3e-6 * given.values.max()


def test_a_fine_window_holds_the_light_in_steps():
    pixels = [psf_of({"defocus": w, "side": 64}).pixel for w in (0.0, 1.0, 3.0, 9.0, 27.0)]
    steps = np.log2(np.array(pixels) * 64 / 2e-6)
    np.testing.assert_allclose(2 * steps, np.round(2 * steps), atol=1e-9)
    assert np.all(np.diff(pixels) > 0)
    assert psf_of({"defocus": 27.0, "side": 256}).values.sum() > 0.97


def test_distances_may_be_infinite():
    state = complete({"focus": "distances", "object_distance": math.inf})
    assert state["object_distance"] == 1e12
    with pytest.raises(ValueError, match="pixel must be finite, got inf"):
        complete({"pixel": math.inf})
