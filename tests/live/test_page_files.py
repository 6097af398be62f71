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
