"""The controls of the live page in a browser, what it saves, and its rules of access."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Callable
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import lommel as lm
from live_page import ALL_SHOWN, PIXELS, REALS, SLIDERS, box, default_state, rest, slider, state


def test_dragging_any_slider_moves_its_value_its_box_and_the_picture(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=128&coma=0.3&astigmatism=0.3&trefoil=0.3")
    defaults = default_state(page)
    for key in SLIDERS:
        before, picture = state(page)[key], page.evaluate(PIXELS)
        slider(page, key).scroll_into_view_if_needed()
        place = slider(page, key).bounding_box()
        y = place["y"] + place["height"] / 2
        page.mouse.move(place["x"] + place["width"] * 0.3, y)
        page.mouse.down()
        seen = set()
        for share in (0.4, 0.6, 0.7, 0.85):
            page.mouse.move(place["x"] + place["width"] * share, y, steps=4)
            page.wait_for_timeout(40)
            seen.add(state(page)[key])
        page.mouse.up()
        rest(page)
        assert len(seen) >= 3, key
        after = state(page)[key]
        assert after != before, key
        assert float(box(page, key).input_value()) == pytest.approx(after, rel=5e-4), key
        if key != "pixel":  # which the fine view does not show
            assert page.evaluate(PIXELS) != picture, key
        assert page.evaluate("live.result().state")[key] == after, key
        slider(page, key).dblclick()
        rest(page)
        assert state(page)[key] == defaults[key], key
        page.evaluate("([key, value]) => live.set({ [key]: value })", [key, before])
        rest(page)


def test_arrow_keys_move_every_slider_and_no_page_around_sees_them(visit: Callable[..., Any]) -> None:
    page = visit(f"/mounted#side=64&{ALL_SHOWN}")
    defaults = default_state(page)
    page.evaluate("window.heard = 0; addEventListener('keydown', () => window.heard++)")
    for key in [key for key in REALS if key != "defocus"]:
        page.evaluate("live.set({ vanes: 1 })")  # its own turn hides what depends on it
        rest(page)
        before = state(page)[key]
        slider(page, key).focus()
        said = slider(page, key).get_attribute("aria-valuetext")
        page.keyboard.press("ArrowRight")
        page.keyboard.press("ArrowRight")
        rest(page)
        assert state(page)[key] != before, key
        assert slider(page, key).get_attribute("aria-valuetext") != said, key
        page.keyboard.press("Delete")
        rest(page)
        assert state(page)[key] == defaults[key]
    assert page.evaluate("heard") == 0


def test_units_change_what_is_shown_and_not_the_state(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64&defocus=0.5&wavelength=600&f_number=5&focal_length=1000&length_unit=um")
    before = state(page)
    wide = float(page.locator('dd[data-number="d80"]').inner_text().split()[0])
    for unit, text in (("rad", "3.142"), ("nm", "300"), ("waves", "0.5")):
        page.get_by_label("Unit of the wavefront").select_option(unit)
        rest(page)
        assert box(page, "defocus").input_value() == text
    for unit, factor in (("arcsec", 0.206264806), ("lambdaN", 1 / 3.0), ("um", 1.0)):
        page.get_by_label("Unit of lengths").select_option(unit)
        rest(page)
        shown = float(page.locator('dd[data-number="d80"]').inner_text().rstrip("″µmλN "))
        assert shown == pytest.approx(wide * factor, rel=2e-3)
    assert state(page) == before


def test_teachers_choose_what_is_shown(visit: Callable[..., Any]) -> None:
    page = visit("/mounted?controls=defocus,coma")
    shown = page.locator("input[type=range]").evaluate_all("all => all.map(node => node.dataset.key)")
    assert shown == ["defocus", "coma", "coma_angle"]
    assert page.locator("select").count() == 0
    assert page.locator(".numbers").is_visible()
    page = visit("/mounted?controls=coma,curves")
    assert page.locator(".plots").is_visible()
    assert page.locator(".numbers").is_hidden()
    assert page.locator(".picture").is_hidden()


def test_presets_are_the_lens_files(visit: Callable[..., Any], lenses: dict[str, Path]) -> None:
    page = visit("/mounted#side=64")
    names = page.locator('select[data-key="preset"] option').all_inner_texts()
    hubble = lm.load_instrument(lenses["hubble-1990"])
    assert {lm.load_instrument(path).name for path in lenses.values()} <= set(names)
    page.locator('select[data-key="preset"]').select_option(label=hubble.name)
    rest(page)
    told = state(page)
    seen = lm.Wavefront.from_seidel(W020=told["defocus"], W040=told["spherical"])
    assert seen.defocus == pytest.approx(hubble.pupil().wavefront.defocus, rel=1e-4)
    assert seen.spherical == pytest.approx(hubble.pupil().wavefront.spherical, rel=1e-4)
    assert told["obscuration"] == 0.33
    assert "Burrows" in page.locator(".source").inner_text()


def test_a_picture_of_ones_own_is_blurred_here_and_stays_here(visit: Callable[..., Any]) -> None:
    image = pytest.importorskip("PIL.Image")
    file = io.BytesIO()
    image.fromarray(np.random.default_rng(1).integers(0, 255, (40, 60, 3), dtype=np.uint8)).save(file, "PNG")
    page = visit("/mounted#side=64")
    page.locator("input[type=file]").set_input_files(
        {"name": "own.png", "mimeType": "image/png", "buffer": file.getvalue()}
    )
    page.wait_for_function("live.state.picture === 'own'")
    rest(page)
    assert page.locator(".picture canvas").evaluate("node => [node.width, node.height]") == [60, 40]
    page.evaluate("live.set({ picture: 'bars' })")
    page.locator(".picture").evaluate(
        """async (node) => { const canvas = new OffscreenCanvas(30, 20); canvas.getContext("2d").fillRect(0, 0, 9, 9);
        const dropped = new DataTransfer();
        dropped.items.add(new File([await canvas.convertToBlob()], "dropped.png", { type: "image/png" }));
        node.dispatchEvent(new DragEvent("drop", { dataTransfer: dropped, bubbles: true, cancelable: true })); }"""
    )
    page.wait_for_function("live.state.picture === 'own'")
    rest(page)
    assert page.locator(".picture canvas").evaluate("node => [node.width, node.height]") == [30, 20]
    page.locator("input[type=file]").set_input_files(
        {"name": "no.png", "mimeType": "image/png", "buffer": b"no picture"}
    )
    page.locator(".notice", has_text="no.png is not a picture").wait_for()


REFUSING = """const { postMessage } = Worker.prototype;
Worker.prototype.postMessage = function (message) {
  const refused = message.arguments[0].defocus === 13;
  postMessage.call(this, refused ? { ...message, method: "refuse" } : message);
};"""
COUNTING = """window.made = []; const Plain = Worker;
Worker = class extends Plain { constructor(...given) { super(...given); made.push(this); } };"""


def test_an_error_of_the_core_is_a_sentence_and_the_page_lives_on(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64", before=REFUSING)
    page.evaluate("live.set({ defocus: 13 })")
    rest(page)
    assert "cannot be computed" in page.locator(".notice").inner_text()
    page.evaluate("live.set({ defocus: 1 })")
    rest(page)
    assert page.locator(".notice").is_hidden()
    assert page.evaluate("live.result().state.defocus") == 1


def test_a_newer_setting_does_not_wait_for_one_that_takes_long(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64", before=COUNTING)
    slow = {
        "coma": 10,
        "astigmatism": 10,
        "trefoil": 10,
        "defocus": 50,
        "spherical": 25,
        "light": "white",
        "side": 1024,
    }
    page.evaluate("slow => live.set(slow)", slow)
    page.wait_for_timeout(200)
    page.evaluate("import('./lommel-live.js').then(({ DEFAULTS }) => live.set({ ...DEFAULTS, side: 64 }))")
    rest(page)
    assert page.evaluate("live.result().state.side") == 64
    assert page.locator(".notice").is_hidden()


def test_a_worker_that_dies_is_replaced(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64", before=COUNTING)
    page.evaluate("made[0].dispatchEvent(new ErrorEvent('error', { message: 'it died', cancelable: true }))")
    page.evaluate("live.set({ defocus: 1 })")
    rest(page)
    assert page.evaluate("live.result().state.defocus") == 1
    assert page.evaluate("made.length") == 3


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


@pytest.mark.parametrize("view", ["", "&view=averaged"])
def test_copies_a_link_and_the_call_in_python(visit: Callable[..., Any], view: str) -> None:
    page = visit(
        f"/mounted#defocus=0.25&coma=0.5&pixel=1.5{view}&side=64", permissions=["clipboard-read", "clipboard-write"]
    )
    page.locator('[data-action="link"]').click()
    page.wait_for_timeout(50)
    assert page.evaluate("navigator.clipboard.readText()") == page.url
    page.locator('[data-action="python"]').click()
    page.wait_for_timeout(50)
    text = page.evaluate("navigator.clipboard.readText()")
    assert "wavelength=5.5e-07" in text
    assert re.search(r"pixel=\d\.?\d*e-0\d[,)]", text)
    scope: dict[str, Any] = {}
    exec(text, scope)
    values = np.array(page.evaluate("Array.from(live.result().psf.values)")).reshape(64, 64)
    assert np.abs(scope["psf"].values - values).max() <= 2e-6 * values.max()
    (diameter,) = re.findall(r"psf\.energy_diameter\(.*?\)", text)
    (width,) = re.findall(r"psf\.fwhm\(.*?\)", text)
    assert eval(diameter, scope) == pytest.approx(1e-6 * page.evaluate("live.result().measures.d80"), rel=1e-3)
    shown = float(page.locator('dd[data-number="fwhm"]').inner_text().split()[0])
    assert eval(width, scope) == pytest.approx(1e-6 * shown, rel=6e-3)


RULES = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"]
FOUND = f"""axe.run(document, {{ runOnly: {RULES} }}).then((found) => found.violations.flatMap(
 ({{ id, nodes }}) => nodes.map((node) => `${{id}}: ${{node.target.flat().join(" ")}}, ${{node.failureSummary}}`)))"""


def axe() -> str:
    """Return axe-core as a script."""
    pytest.importorskip("axe_playwright_python", reason="axe-playwright-python is not installed, which has axe-core")
    return files("axe_playwright_python").joinpath("axe.min.js").read_text(encoding="utf-8")


@pytest.mark.parametrize("width", [390, 1366])
@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("address", ["/live#coma=0.3&side=64", "/live?lesson=depth"])
def test_axe_finds_nothing_in_chromium(visit: Callable[..., Any], address: str, scheme: str, width: int) -> None:
    page = visit(address, color_scheme=scheme, viewport={"width": width, "height": 768})
    page.evaluate(axe())
    assert page.evaluate(FOUND) == []
