"""The live page as a widget: traits of every control, and the PSF that they ask for."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.page import server
from lommel.page.state import FIELDS, psf_of


@pytest.fixture(autouse=True)
def made(tmp_path, monkeypatch):
    file = tmp_path / server.NAME
    file.write_text("export default { render() {} };\n", encoding="utf-8")
    monkeypatch.setattr(server, "path", lambda: file)
    server._widget_class.cache_clear()
    yield
    server._widget_class.cache_clear()


def test_every_control_is_a_trait_that_reaches_the_page():
    w = lm.live(defocus=1.0, view="averaged")
    assert w.state == {name: field.initial for name, field in FIELDS.items()} | {"defocus": 1.0, "view": "averaged"}
    assert set(FIELDS) | {"controls", "theme", "_esm"} <= set(w.trait_names(sync=True))
    assert "export default" in w._esm
    assert repr(w) == "Live(defocus=1.0, view='averaged')"
    heard = []
    w.observe(lambda change: heard.append((change.name, change.new)), ["coma", "side"])
    w.coma, w.side = 0.5, 64
    assert heard == [("coma", 0.5), ("side", 64)]
    w.state = {"coma": 0.25}
    assert (w.coma, w.side, w.state["coma"]) == (0.25, 64, 0.25)


def test_the_psf_of_a_widget_is_that_of_its_state():
    w = lm.live(side=48, astigmatism=0.4, astigmatism_angle=20.0, obscuration=0.2, pixel=1.5, view="averaged")
    found = w.psf(tol=1e-9)
    assert isinstance(found, lm.PSF)
    assert (found.pixel, found.grid.integrate, found.values.dtype) == (1.5e-6, True, np.float64)
    np.testing.assert_array_equal(found.values, psf_of(w.state, tol=1e-9).values)


def test_a_widget_takes_distances_further_terms_and_vanes():
    w = lm.live(focus="distances", object_distance=1.8, zernike="4,2:0.1", vanes=4, side=32)
    w.zernike = "4,2:0.1;5,-1:.02"
    pupil = w.psf().pupil
    lens = lm.Lens(focal_length=50e-3, f_number=4, focus_distance=2.0, wavelength=550e-9)
    assert pupil.f_number == lens.pupil(1.8).f_number
    assert len(pupil.spider.angles) == 4
    found = pupil.wavefront - lens.pupil(1.8).wavefront
    wanted = lm.Wavefront.zernike({(4, 2): 0.1, (5, -1): 0.02}, unit="waves")
    assert max(abs(c) for c in (found - wanted).edge_terms().values()) < 1e-12


def test_a_lens_file_is_where_it_starts(lenses):
    w = lm.live(lenses["hubble-1990"], map="gray", controls=["defocus", "spherical"], theme="dark")
    assert (w.f_number, w.obscuration, w.map, w.controls, w.theme) == (
        24.0,
        0.33,
        "gray",
        ["defocus", "spherical"],
        "dark",
    )
    assert w.state == lm.live(lm.load_instrument(lenses["hubble-1990"]), map="gray").state
    with pytest.raises(TypeError, match="lens must be an Instrument or the path of a lens file, got 3"):
        lm.live(3)
