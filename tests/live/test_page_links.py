"""Links to the live page restore what they were copied from, and do no harm."""

from __future__ import annotations

import random
from collections.abc import Callable
from typing import Any

from live_page import PIXELS, REALS, WORDS, default_state, fragment, rest, state
from lommel.page.state import FIELDS, Whole


def random_state(dice: random.Random) -> dict[str, Any]:
    chosen: dict[str, Any] = {"side": dice.choice((64, 96, 128))}
    for key in dice.sample([key for key in REALS if key != "side"], 5):
        near = {"defocus": (-4, 4), "spherical": (-4, 4), "coma": (0, 2), "astigmatism": (0, 2), "trefoil": (0, 2)}
        near |= {"f_number": (1, 20), "pixel": (0.5, 10), "wavelength": (400, 700), "focal_length": (10, 60)}
        near |= {"focus_distance": (1.99, 2.01), "object_distance": (1.99, 2.01), "photons": (10, 1e5)}
        low, high = near.get(key, REALS[key])
        value = dice.uniform(low, high)
        chosen[key] = round(value) if isinstance(FIELDS[key], Whole) else round(value, 4)
    for key in dice.sample(list(WORDS), 3):
        chosen[key] = dice.choice([word for word in WORDS[key] if word != "own"])
    return chosen


def test_the_link_of_any_state_restores_it_and_its_pixels(visit: Callable[..., Any], site: str) -> None:
    page = visit("/mounted#side=64")
    for seed in range(20):
        wanted = random_state(random.Random(seed))
        page.evaluate(
            "wanted => import('./lommel-live.js').then(({ DEFAULTS }) => live.set({ ...DEFAULTS, ...wanted }))",
            wanted,
        )
        rest(page)
        told, link = state(page), fragment(page)
        pixels = page.evaluate(PIXELS)
        assert told == default_state(page) | wanted
        page.goto("about:blank")
        page.goto(f"{site}/mounted#{link}")
        rest(page)
        assert state(page) == told, link
        assert page.evaluate(PIXELS) == pixels, link


HOSTILE = [
    "toString", "__proto__", "constructor", "hasOwnProperty", "1e999", "-1e999", "NaN", "Infinity", "", "null",
    "[object Object]", "%", "%00", "%E0%A4%A", "0x10", "1,5", "9" * 400, "x" * 100_000, "javascript:alert(1)",
    "1e-400", "<img src=x onerror=alert(1)>",
]  # fmt: skip


FOLLOW = """async (texts) => { const told = []; for (const text of texts) {
    location.hash = text; await new Promise((go) => setTimeout(go, 5)); told.push(live.state); } return told; }"""


def test_hostile_fragments_leave_a_page_that_draws_and_a_state_in_range(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64")
    dice, order = random.Random(7), list(default_state(page))
    keys = [*REALS, *WORDS, "toString", "__proto__", "constructor", "", "x" * 1000]
    # What is drawn in the end has a small window, and none of the wavefronts that take longest.
    kind = "side=32&light=mono&coma=1&astigmatism=1&trefoil=1"
    for turn in range(20):
        texts = ["&".join(f"{key}={HOSTILE[turn % len(HOSTILE)]}" for key in keys)]
        texts += [
            "&".join(f"{dice.choice(keys)}={dice.choice(HOSTILE)}" for _ in range(dice.choice((1, 2, 5, 40))))
            for _ in range(8)
        ]
        states = page.evaluate(FOLLOW, [*texts, f"{texts[-1]}&{kind}"[-3000:]])
        rest(page)
        assert "cannot" not in page.locator(".notice").text_content(), texts
        assert len(page.evaluate(PIXELS)) > 500
        for told in states:
            assert list(told) == order
            assert [key for key, (low, high) in REALS.items() if not low <= told[key] <= high] == []
            assert [key for key, words in WORDS.items() if told[key] not in words] == []


def test_what_an_address_says_out_of_range_is_told(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64&pixel=1000&view=fin")
    notice = page.locator(".notice")
    said = "pixel is 0.05 to 200 micrometres, so 200 is shown instead of 1000"
    assert notice.inner_text() == f"Not as in the address: {said}; view=fin is not understood."
    assert state(page)["pixel"] == 200
    page.evaluate("live.set({ coma: 0.5 })")
    rest(page)
    assert notice.is_hidden()
    page.evaluate("location.hash = '#side=64&coma=-0.5'")
    rest(page)
    assert notice.inner_text() == "Not as in the address: coma is 0 to 10 waves, so 0 is shown instead of -0.5."
    page = visit("/mounted?lesson=airi#side=64&comma=1")
    assert page.locator(".notice").inner_text() == "Not as in the address: lesson=airi is unknown; comma is unknown."


def test_a_link_followed_on_the_same_page_is_taken(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#defocus=1")
    page.evaluate("location.hash = '#coma=0.5'")
    rest(page)
    assert state(page)["coma"] == 0.5
    assert state(page)["defocus"] == 0.6
    page.evaluate("location.hash = '#a-heading-of-the-page'")
    rest(page)
    assert state(page)["coma"] == 0.5


def test_back_leads_to_the_setting_before_the_first_change(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#coma=.5&junk=1")
    for defocus in (1, 2, 3):
        page.evaluate("defocus => live.set({ defocus })", defocus)
        assert "defocus" in fragment(page)
    page.go_back()
    rest(page)
    assert fragment(page) == "coma=.5&junk=1"
    assert (state(page)["coma"], state(page)["defocus"]) == (0.5, 0.6)
    page.go_forward()
    rest(page)
    assert (state(page)["coma"], state(page)["defocus"]) == (0.5, 3)
    page.reload()
    rest(page)
    page.evaluate("live.set({ defocus: 4 })")
    assert "defocus=4" in fragment(page)
    # One step for all changes, also of a lesson.
    page.locator("select.lessons").select_option("coma")
    rest(page)
    page.evaluate("live.set({ defocus: 1 })")
    assert "defocus=1" in fragment(page)
    for lesson, defocus in (("coma", 0), ("", 4), ("", 0.6)):
        page.go_back()
        rest(page)
        assert page.locator("select.lessons").input_value() == lesson
        assert state(page)["defocus"] == defocus
    page.go_back()
    assert page.url == "about:blank"
