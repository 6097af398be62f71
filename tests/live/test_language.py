"""The live page in German: every text that is shown is translated, and every text of the table is one of the page."""

from __future__ import annotations

import itertools
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from live_page import rest, state

ROOT = Path(__file__).resolve().parent.parent.parent
LESSONS = ("", "airy", "quarter", "axis", "contrast", "hubble", "coma", "depth")
# Each text and each of the attributes that are read out, in order.
TEXTS = """() => { const found = [], root = document.querySelector(".lommel-live-host").shadowRoot;
    const walk = (node) => {
      if (node.nodeType === 3 && /\\S/.test(node.data)) found.push(node.data);
      if (node.nodeType !== 1 || node.matches("style, math, [translate=no], .lesson .note")) return;
      for (const name of ["title", "aria-label", "aria-valuetext"])
        if (node.hasAttribute(name)) found.push(node.getAttribute(name));
      node.childNodes.forEach(walk); };
    root.childNodes.forEach(walk);
    return found; }"""
COMPUTED = """() => { const root = document.querySelector(".lommel-live-host").shadowRoot;
    return root.querySelector("[data-depth=numbers]").textContent; }"""
SAME = {"lommel", "Text", "Sensor", "linear", "inferno", "viridis", "cividis", "PNG", "CSV", "TIFF", "MTF", "Nyquist"}
SAME |= {"e⁻ rms", "Astigmatismus", "Pause", "rad", "µm", "Hubble, 1990", "5: Hubble, 1990"}
ENGLISH = re.compile(r"\b(the|of|and|with|is|are|from|to|by|not|for|or|no|at|waves?|picture|light|cycles)\b")


def switch(page: Any) -> None:
    """Press the button of languages; the pointer stays where it is."""
    page.locator('button[data-action="language"]').evaluate("node => node.click()")


@pytest.mark.parametrize("lesson", LESSONS)
def test_every_text_has_a_translation(visit: Callable[..., Any], lesson: str) -> None:
    extra = "#coma=0.3&trefoil=0.1&vanes=4&noise=on&view=averaged&rays=on&zernike=4,2:0.05" if not lesson else ""
    page = visit(f"/mounted?lesson={lesson}{extra}", reduced_motion="reduce")
    if not lesson:
        page.locator('button[data-action="hold"]').click()
        page.locator("figure.mtf svg").hover()
    if lesson == "depth":
        page.wait_for_function(COMPUTED)
    page.wait_for_timeout(800)  # sentences for those who do not see are told last
    english = page.evaluate(TEXTS)
    switch(page)
    german = page.evaluate(TEXTS)
    assert len(german) == len(english) > 150
    kept = {b for a, b in zip(english, german, strict=True) if a == b and re.search(r"[^\W\d]{3}", a)}
    assert kept - SAME == set()
    left = {text for text in german if ENGLISH.search(text) and "doi:" not in text}
    assert sorted(left) == [], "\n".join(sorted(left))
    switch(page)
    assert page.evaluate(TEXTS) == english


def test_the_language_is_that_of_the_browser_or_of_the_address(visit: Callable[..., Any]) -> None:
    page = visit("/mounted", locale="de-AT")
    box = page.get_by_label("Blendenzahl").first
    assert page.locator(".lommel-live").get_attribute("lang") == "de"
    page.evaluate("live.set({ f_number: 5.6 })")
    page.wait_for_timeout(100)
    text = page.locator('input[type="text"][data-key="f_number"]')
    assert text.input_value() == "5,6"
    text.fill("2,8")
    text.press("Enter")
    assert state(page)["f_number"] == 2.8
    assert box.is_visible()
    assert "defocus=" in page.locator("pre").text_content() or "lm.psf" in page.locator("pre").text_content()
    switch(page)
    assert text.input_value() == "2.8"
    assert "lang=en" in page.url
    page = visit("/mounted?lang=de")
    assert page.locator(".numbers dt", has_text="Halbwertsbreite").is_visible()
    page = visit("/mounted?lang=en", locale="de-DE")
    assert page.locator(".numbers dt", has_text="FWHM").is_visible()


def test_sources_and_refusals_are_german(visit: Callable[..., Any]) -> None:
    page = visit("/mounted?lang=de#pixel=1000&view=fin&coma=-0.5&side=64")
    said = [page.locator(".notice").inner_text()]
    assert "Koma" not in said[0]  # keys of the address are as they are there
    menu = page.locator('select[data-key="preset"]')
    for index in range(1, menu.locator("option").count() - 1):
        menu.select_option(str(index))
        rest(page)
        said.append(page.locator("details.source").text_content())
    for key, value in (("coma", "-1"), ("vanes", "2.5"), ("f_number", "0.1")):
        page.locator(f'.line input[data-key="{key}"]').fill(value)
        page.keyboard.press("Enter")
        said.append(page.locator(f'[data-row="{key}"] .fault').inner_text())
    assert all(said)
    assert len(set(said)) == len(said) > 8
    names = re.compile(r"Journal of|Hubble Space Telescope Primer|doi:\S+")
    assert [text for text in said if ENGLISH.search(names.sub("", text))] == []


def test_texts_made_of_parts_are_german(visit: Callable[..., Any]) -> None:
    page = visit("/mounted?lang=de#defocus=99&coma=99&zernike=1,1:.1;4,4:.05;6,0:.02;5,1:.01")
    said = [page.locator(".notice").inner_text(), page.locator('[data-row="zernike"] span').inner_text()]
    assert "gezeigt ist 50 statt 99; coma geht" in said[0]
    assert "Kippung x" in said[1]
    page.evaluate(
        'live.set({ defocus: 0, zernike: "", focus: "distances", coma: 10, f_number: 0.8, object_distance: 0.7 })'
    )
    rest(page)
    said.append(page.locator(".notice").inner_text())
    assert "blenden Sie ab auf f/" in said[2]
    assert [text for text in said if ENGLISH.search(text)] == []


def test_every_key_of_the_table_is_a_text_of_the_page() -> None:
    table = (ROOT / "web" / "german.js").read_text(encoding="utf-8")
    keys = re.findall(r'^  (?:"((?:[^"\\]|\\.)+)"|(\w+)): "', table, re.MULTILINE)
    assert len(keys) == len(set(keys)) > 250
    patterns = ("web/*.js", "cpp/wasm/*.cpp", "src/lommel/page/state.py", "examples/lenses/*.toml")
    files = [path for pattern in patterns for path in ROOT.glob(pattern) if path.name != "german.js"]
    texts = [path.read_text(encoding="utf-8") for path in files]
    said = set().union(*(pairs(text) | {(word,) for word in words(text)} for text in texts))
    parts = {part for quoted, bare in keys for part in re.split(r"\{\d\}", quoted or bare) if pairs(part)}
    # Half of their pairs of words: texts are joined from pieces.
    unused = [part for part in parts if 2 * len(pairs(part) & said) < len(pairs(part))]
    assert unused == [], "\n".join(unused)


def words(text: str) -> list[str]:
    """Return the words of a text."""
    return re.findall(r"[^\W\d_]+", text.replace("\\n", " ").lower())


def pairs(text: str) -> set[tuple[str, ...]]:
    """Return the neighbouring words of a text, or the only one."""
    return set(itertools.pairwise(words(text))) or {(word,) for word in words(text)}
