"""Nothing moves by what is shown, and everything is in reach: header, scrolling, enlarged screens."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from live_page import box, rest, slider

SCREEN = {"viewport": {"width": 1366, "height": 768}}
PANELS = "document.querySelector('.lommel-live-host').shadowRoot.querySelector('.panels')"
TOP = f"() => {PANELS}.getBoundingClientRect().top"


@pytest.mark.parametrize("width", [700, 768, 1024, 1200, 1366, 1920])
def test_the_header_is_as_high_with_a_changed_lens_and_with_a_held(visit: Callable[..., Any], width: int) -> None:
    page = visit("/live#side=64", viewport={"width": width, "height": 768})
    high = page.evaluate(TOP)
    page.get_by_role("button", name="Hold as A").click()
    box(page, "coma").fill("0.4")
    page.keyboard.press("Enter")
    rest(page)
    assert page.locator("h1.name").inner_text() == "Changed from: A lens"
    assert page.evaluate(TOP) == high
    for mode in ("flicker", "difference"):
        page.get_by_label("How to compare").select_option(mode)
        assert page.evaluate(TOP) == high
        assert page.evaluate("document.documentElement.scrollWidth") <= width


@pytest.mark.parametrize("size", [(1366, 768), (1024, 768)])
def test_controls_out_of_sight_have_a_cue_that_goes_at_the_end(
    visit: Callable[..., Any], size: tuple[int, int]
) -> None:
    page = visit("/mounted#side=64&noise=on&vanes=4", viewport={"width": size[0], "height": size[1]})
    side = page.locator(".side")
    shown = "node => getComputedStyle(node, '::after').content.includes('more below')"
    assert side.evaluate(shown)
    side.evaluate("node => node.scrollTo(0, node.scrollHeight)")
    page.wait_for_timeout(100)
    assert not side.evaluate(shown)


@pytest.mark.parametrize("lesson", ["airy", "quarter", "axis", "contrast", "hubble"])
@pytest.mark.parametrize("size", [(1366, 768), (1024, 768)])
def test_an_unfolded_answer_leaves_sliders_and_undo_on_the_screen(
    visit: Callable[..., Any], lesson: str, size: tuple[int, int]
) -> None:
    page = visit(f"/mounted?lesson={lesson}", viewport={"width": size[0], "height": size[1]})
    page.locator(".lesson summary").click()
    page.wait_for_timeout(100)
    for part in (".hands", ".controls"):
        area = page.locator(part).bounding_box()
        assert area["y"] >= 0, part
        assert area["y"] + area["height"] <= size[1], part
    text = page.locator(".lesson .body")
    assert text.evaluate("node => node.classList.contains('more') === node.scrollHeight - node.clientHeight > 12")


def test_a_projector_shows_psf_sliders_numbers_and_the_question(visit: Callable[..., Any]) -> None:
    page = visit("/mounted?lesson=quarter&large", viewport={"width": 1024, "height": 768})
    for part in (".now canvas", ".numbers", ".controls", ".question"):
        area = page.locator(part).bounding_box()
        assert area["y"] + area["height"] <= 768, part
    assert page.locator(".now canvas").bounding_box()["height"] > 400


def test_an_enlarged_page_scrolls_and_keeps_the_psf_large(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64", viewport={"width": 683, "height": 384})
    assert page.locator(".now canvas").bounding_box()["height"] > 250
    assert slider(page, "defocus").bounding_box()["y"] < 360
    page = visit("/mounted?lesson=quarter", viewport={"width": 683, "height": 384})
    assert slider(page, "defocus").bounding_box()["y"] < 360


def test_a_phone_shows_the_bar_and_the_numbers_before_the_sliders(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64", viewport={"width": 390, "height": 844}, has_touch=True, is_mobile=True)
    bar, numbers, side = (page.locator(part).bounding_box() for part in (".scale", ".numbers", ".hands"))
    assert bar["height"] > 15
    assert bar["y"] < numbers["y"] < side["y"]
    assert numbers["y"] + numbers["height"] < 844


def test_two_pictures_take_the_width_of_the_screen(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64", **SCREEN)
    page.get_by_role("button", name="Hold as A").click()
    rest(page)
    assert page.locator(".now canvas").bounding_box()["width"] > 370
    assert page.locator(".numbers").bounding_box()["y"] < 600
    ends = page.locator(".plots").bounding_box()
    assert ends["x"] + ends["width"] == pytest.approx(1344, abs=2)


CUT = """() => [...document.querySelector(".lommel-live-host").shadowRoot
    .querySelectorAll(".readout, .legend, .line label, dt:not(.unseen)")]
    .filter((node) => node.scrollWidth > node.clientWidth + 1 || node.scrollHeight > node.clientHeight + 3)
    .map((node) => node.textContent)"""
COVERED = """(node) => {
    const root = document.querySelector(".lommel-live-host").shadowRoot;
    const { left, top, width, height } = node.getBoundingClientRect();
    const seen = root.elementFromPoint(left + width / 2, top + height / 2);
    return !(node === seen || node.contains(seen));
}"""


@pytest.mark.parametrize(
    "path", ["/live#side=64&noise=on&vanes=4", "/live#side=64&focus=distances", "/live?lesson=hubble"]
)
@pytest.mark.parametrize("compared", [False, True])
def test_all_is_in_reach_at_a_zoom_of_200_percent(visit: Callable[..., Any], path: str, compared: bool) -> None:
    # Of a screen of 1366 x 768.
    page = visit(path, viewport={"width": 683, "height": 384}, device_scale_factor=2)
    if compared:
        page.get_by_role("button", name="Hold as A").click()
        page.wait_for_selector(".lommel-live-host:not([data-busy])", state="attached")
    assert page.evaluate("document.documentElement.scrollWidth") <= 683
    assert page.evaluate(CUT) == []
    for control in page.locator("button:visible, select:visible, input:not(.unseen):visible, summary:visible").all():
        control.evaluate("node => node.scrollIntoView({ block: 'center' })")
        area = control.bounding_box()
        name = control.evaluate("node => node.getAttribute('aria-label') ?? node.textContent + node.dataset.key")
        assert area["x"] >= 0, name
        assert area["x"] + area["width"] <= 683, name
        assert area["y"] >= 0, name
        assert area["y"] + area["height"] <= 384, name
        assert not control.evaluate(COVERED), name


def test_the_text_of_a_lesson_is_on_the_first_screen_of_a_phone(visit: Callable[..., Any]) -> None:
    page = visit("/mounted?lesson=hubble", viewport={"width": 390, "height": 844}, has_touch=True, is_mobile=True)
    text, numbers = (page.locator(part).bounding_box() for part in (".lesson", ".numbers"))
    assert text["y"] < 0.6 * 844
    assert text["y"] < numbers["y"]


@pytest.mark.parametrize("width", [390, 1366])
def test_names_of_menus_and_numbers_do_not_touch(visit: Callable[..., Any], width: int) -> None:
    page = visit("/mounted#side=64", viewport={"width": width, "height": 768})
    page.get_by_role("button", name="Hold as A").click()
    rest(page)
    assert page.locator("select[aria-label=Lesson], .tools > select").last.bounding_box()["width"] >= 94
    for row in page.evaluate(
        """() => [...document.querySelector(".lommel-live-host").shadowRoot.querySelectorAll("dt:not(.unseen)")]
        .filter((node) => node.closest(".numbers")).map((node) => {
            const range = document.createRange();
            range.selectNodeContents(node);
            const { left, right, top } = range.getBoundingClientRect();
            return [Math.round(top), left, right];
        }).sort((a, b) => a[0] - b[0] || a[1] - b[1]).map((at, i, all) =>
            i + 1 < all.length && all[i + 1][0] === at[0] ? all[i + 1][1] - at[2] : 99)"""
    ):
        assert row >= 5


@pytest.mark.parametrize("size", [(768, 1024), (1024, 768), (1366, 768), (1920, 1080)])
def test_a_projector_shows_a_curve_on_its_first_screen(visit: Callable[..., Any], size: tuple[int, int]) -> None:
    page = visit("/mounted?large#side=64", viewport={"width": size[0], "height": size[1]})
    for name in ("psf .now canvas", "profile svg"):
        area = page.locator(f"figure.{name}").bounding_box()
        assert area["y"] + area["height"] <= size[1], name
    assert page.evaluate("document.documentElement.scrollWidth") <= size[0]


@pytest.mark.parametrize("width", [390, 768, 1024, 1366, 1920])
@pytest.mark.parametrize("compared", [False, True])
def test_words_beside_curves_and_sliders_are_whole(visit: Callable[..., Any], width: int, compared: bool) -> None:
    page = visit("/mounted#side=64&coma=0.8&pixel=3", viewport={"width": width, "height": 768})
    if compared:
        page.get_by_role("button", name="Hold as A").click()
        box(page, "coma").fill("0.4")
        page.keyboard.press("Enter")
        rest(page)
    text = page.locator("figure.mtf .readout").inner_text()
    assert "with pixel 0." in text
    assert page.evaluate(CUT) == []
    # What is read at rest does not lie over the next figure.
    read, figure = (page.locator(f"figure.mtf{part}").bounding_box() for part in (" .readout", ""))
    assert read["y"] + read["height"] <= figure["y"] + figure["height"] + 1
