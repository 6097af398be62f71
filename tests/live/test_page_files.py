"""What the live page saves and copies, read back."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import lommel as lm
from live_page import rest


def saved(page: Any, name: str) -> bytes:
    with page.expect_download() as caught:
        page.locator(f'[data-action="{name}"]').click()
    return Path(caught.value.path()).read_bytes()


@pytest.mark.parametrize(
    "look",
    [
        "view=fine&coma=0.4&coma_angle=30",
        "view=averaged&obscuration=0.3",
        "view=sampled&light=white",
        "vanes=3&zernike=4,0:.1",
    ],
)
def test_the_tiff_is_one_that_the_package_reads(visit: Callable[..., Any], tmp_path: Path, look: str) -> None:
    page = visit(f"/mounted#side=96&{look}&defocus=-0.00004&f_number=5.6")
    path = tmp_path / "psf.tif"
    path.write_bytes(saved(page, "tiff"))
    psf = lm.PSF.load(path)
    values = page.evaluate("Array.from(live.result().psf.values)")
    assert np.array_equal(psf.values.ravel(), np.array(values, dtype=np.float32))
    assert psf.pixel == pytest.approx(page.evaluate("live.result().psf.pixel") * 1e-6, rel=1e-12)
    again = lm.psf(psf.pupil, 96, psf.pixel, method=psf.method, integrate=psf.grid.integrate)
    assert np.abs(again.values - psf.values).max() <= 2e-6 * again.values.max()


def test_the_csv_holds_the_curves_and_the_state(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64&defocus=0.25")
    text = saved(page, "csv").decode()
    lines = text.splitlines()
    assert "# defocus=0.25 *" in lines
    rows = list(csv.DictReader(io.StringIO("\n".join(line for line in lines if not line.startswith("#")))))
    measures = page.evaluate(
        """() => { const { profile, energy, mtf } = live.result().measures;
        return [profile.r, profile.mean, energy.share, mtf.f, mtf.limit].map((part) => Array.from(part)); }"""
    )
    wide = page.evaluate("live.result().measures.d80_axis")
    heads = ("radius (um)", "profile", "encircled energy", "frequency (cycles/mm)", "MTF diffraction limit")
    for head, wanted in zip(heads, measures, strict=True):
        near = 5.1e-7 if head.startswith("MTF") else 1e-9
        assert [float(row[head]) for row in rows if row[head]] == pytest.approx(wanted, rel=1e-7, abs=near)
        assert max(len(row[head].replace(".", "").lstrip("0")) for row in rows) <= 11
    assert f"# diameter_80_percent_about_axis_um={float(wide):.4g}" in lines


def test_the_csv_of_a_comparison_has_the_settings_as_they_look(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64&vanes=4&pixel=4&stretch=sqrt")
    page.get_by_role("button", name="Hold as A").click()
    page.get_by_label("Stretch").select_option("log")
    rest(page)
    lines = saved(page, "csv").decode().splitlines()
    assert "# stretch=log *" in lines
    assert "# vanes=4 *" in lines
    rows = list(csv.DictReader(io.StringIO("\n".join(line for line in lines if not line.startswith("#")))))
    for axis in "xy":
        wanted = page.evaluate(f"Array.from(live.result().measures.mtf.pixel_{axis})")
        column = [float(row[f"MTF {axis} with pixel"]) for row in rows if row[f"MTF {axis} with pixel"]]
        assert column == pytest.approx(wanted, abs=5.1e-7)


def test_the_link_of_a_lens_file_has_its_name_and_says_that_no_picture_is_in_it(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64", permissions=["clipboard-read", "clipboard-write"])
    text = 'name = "Our 200 mm & more"\n[lens]\nfocal_length = "200 mm"\nf_number = 4\nwavelength = "550 nm"\n'
    text += '[sensor]\npixel = "3 um"\n'
    assert page.evaluate("text => live.open(new File([text], 'ours.toml'))", text)
    rest(page)
    page.locator('[data-action="link"]').click()
    page.wait_for_timeout(50)
    link = page.evaluate("navigator.clipboard.readText()")
    assert page.locator(".tip").is_hidden()
    there = visit(link[link.index("/mounted") :])
    assert there.locator("h2.name").inner_text() == "Our 200 mm & more"
    there.evaluate("live.set({ coma: 0.3 })")
    rest(there)
    assert there.locator("h2.name").inner_text() == "Changed from: Our 200 mm & more"
    page.evaluate("live.set({ picture: 'own' })")
    rest(page)
    page.locator('[data-action="link"]').click()
    page.wait_for_timeout(50)
    assert page.locator(".tip").inner_text() == "Not in the link: your own picture."


def test_copies_a_link_and_the_call_in_python(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#defocus=0.25&side=64", permissions=["clipboard-read", "clipboard-write"])
    page.locator('[data-action="link"]').click()
    page.wait_for_timeout(50)
    assert page.evaluate("navigator.clipboard.readText()") == page.url
    page.locator('[data-action="python"]').click()
    page.wait_for_timeout(50)
    text = page.evaluate("navigator.clipboard.readText()")
    assert "wavelength=5.5e-07" in text
    assert re.search(r"pixel=\d\.?\d*e-0\d, ", text)
    scope: dict[str, Any] = {}
    exec(text, scope)
    values = np.array(page.evaluate("Array.from(live.result().psf.values)")).reshape(64, 64)
    assert np.abs(scope["psf"].values - values).max() <= 2e-6 * values.max()
