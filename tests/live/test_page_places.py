"""The live page at all widths, in all themes, several on a page, in notebooks."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from live_page import IDLE, rest


def test_two_on_a_page_are_independent(visit: Callable[..., Any]) -> None:
    page = visit("/empty", wait="")
    page.wait_for_function("window.lommel")
    page.evaluate(
        """() => { window.told = [];
        window.two = [0.25, 1.5].map((defocus, i) => lommel.mount(document.body,
          { state: { defocus, side: 64 }, onchange: (state) => told.push([i, state.defocus]) })); }"""
    )
    page.wait_for_function("two.every((one) => one.result())")
    page.evaluate("two[0].set({ defocus: 2 })")
    page.wait_for_function("two[0].result().state.defocus === 2")
    assert page.evaluate("two.map((one) => one.state.defocus)") == [2, 1.5]
    assert page.evaluate("told") == [[0, 2]]
    assert page.evaluate("location.hash") == ""


def test_mounts_and_destroys_leave_nothing_behind(visit: Callable[..., Any]) -> None:
    page = visit("/empty", wait="")
    page.wait_for_function("window.lommel")
    page.evaluate(
        """async () => { for (let i = 0; i < 20; i++) {
        const one = lommel.mount(document.body, { state: { side: 64 }, url: i % 2 });
        if (i % 4) while (!one.result()) await new Promise((go) => setTimeout(go, 10));
        one.destroy(); } }"""
    )
    page.wait_for_timeout(300)
    assert page.evaluate("document.body.querySelectorAll('.lommel-live-host').length") == 0
    assert len(page.workers) == 0


def test_without_workers_the_page_computes_by_itself(browser: Any, site: str) -> None:
    context = browser.new_context()
    context.add_init_script("window.Worker = class { constructor() { throw new Error('refused'); } };")
    page, said = context.new_page(), []
    page.on("console", lambda message: said.append(message.text))
    page.goto(f"{site}/mounted#side=64")
    page.wait_for_selector(IDLE, state="attached")
    assert page.evaluate("live.result().psf.side") == 64
    assert [text for text in said if "Worker" in text] == said
    assert len(said) == 1
    context.close()


LESSONS = ("", "airy", "quarter", "axis", "contrast", "hubble", "coma", "depth")
# What is cut or lies beside the page: menus by their choice alone, save names of lenses that the heading has too.
CUT = r"""() => {
    const root = document.querySelector(".lommel-live-host").shadowRoot, width = document.documentElement.clientWidth;
    const shown = (node) => node.checkVisibility({ visibilityProperty: true }) && !node.closest(".unseen, svg");
    const found = [...root.querySelectorAll("*")].filter(shown).flatMap((node) => {
        const { left, right } = node.getBoundingClientRect();
        const written = [...node.childNodes].some((child) => child.nodeType === 3 && child.data.trim());
        const cut = written && getComputedStyle(node).display !== "inline" && node.scrollWidth > node.clientWidth + 1;
        return cut || right > width + 1 || left < -1 ? [`${node.className} ${node.textContent}`] : [];
    });
    for (const menu of [...root.querySelectorAll("select")].filter(shown)) {
        const text = menu.selectedOptions[0]?.text ?? "", alone = menu.cloneNode();
        alone.append(new Option(text));
        alone.style.cssText = "position: absolute; width: max-content; max-width: none; flex: none";
        menu.after(alone);
        if (alone.offsetWidth > menu.offsetWidth + 1 && text.length < 40) found.push(`menu ${text}`);
        alone.remove();
    }
    const tiles = [...root.querySelectorAll(".numbers > div")].filter(shown), last = tiles.at(-1)?.offsetTop;
    if (tiles.filter((tile) => tile.offsetTop === last).length === 1) found.push("one number in the last row");
    return found;
}"""


@pytest.mark.parametrize("language", ["en", "de"])
@pytest.mark.parametrize(
    ("width", "height", "large"),
    [(390, 844, ""), (390, 844, "&large"), (640, 900, ""), (900, 700, ""), (1366, 768, ""), (1920, 1080, "")],
)
def test_no_text_is_cut(visit: Callable[..., Any], language: str, width: int, height: int, large: str) -> None:
    page = visit(f"/live?lang={language}{large}#defocus=0", viewport={"width": width, "height": height})
    for lesson in LESSONS:
        if lesson:
            page.locator("select.lessons").select_option(lesson)
            rest(page)
        found = page.evaluate(CUT)
        assert found == [], (lesson, found)


@pytest.mark.parametrize("language", ["en", "de"])
@pytest.mark.parametrize("width", [1280, 1366])
def test_controls_need_no_scrolling_on_a_laptop(visit: Callable[..., Any], language: str, width: int) -> None:
    page = visit(f"/live?lang={language}", viewport={"width": width, "height": 768 if width == 1366 else 720})
    side = page.locator(".side")
    assert side.evaluate("node => node.scrollHeight - node.clientHeight") <= 0
    assert side.evaluate("node => node.getBoundingClientRect().bottom <= innerHeight")
    assert page.locator(".side input[type=range]:visible").count() > 10
