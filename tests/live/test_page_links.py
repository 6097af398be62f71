"""Links to the live page restore what they were copied from, and do no harm."""

from __future__ import annotations

import random
from collections.abc import Callable
from typing import Any

from live_page import PIXELS, REALS, WORDS, default_state, fragment, rest, state


def random_state(dice: random.Random) -> dict[str, Any]:
    chosen: dict[str, Any] = {"side": dice.choice((64, 96, 128))}
    for key in dice.sample([key for key in REALS if key != "side"], 5):
        low, high = REALS[key]
        near = {"defocus": (-4, 4), "spherical": (-4, 4), "coma": (0, 2), "astigmatism": (0, 2), "trefoil": (0, 2)}
        low, high = near.get(key, (low, high))
        if key in ("f_number", "pixel", "wavelength"):
            low, high = {"f_number": (1, 20), "pixel": (0.5, 10), "wavelength": (400, 700)}[key]
        chosen[key] = round(dice.uniform(low, high), 4)
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
    *(
        "toString",
        "__proto__",
        "constructor",
        "hasOwnProperty",
        "1e999",
        "-1e999",
        "NaN",
        "Infinity",
        "",
        "null",
        "[object Object]",
    ),
    *(
        "%",
        "%00",
        "%E0%A4%A",
        "0x10",
        "1,5",
        "9" * 400,
        "x" * 100_000,
        "<img src=x onerror=alert(1)>",
        "javascript:alert(1)",
        "1e-400",
    ),
]


def test_hostile_fragments_leave_a_page_that_draws_and_a_state_in_range(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64")
    dice, keys_in_order = random.Random(7), list(default_state(page))
    keys = [*REALS, *WORDS, "toString", "__proto__", "constructor", "", "x" * 1000]
    for turn in range(200):
        parts = [f"{dice.choice(keys)}={dice.choice(HOSTILE)}" for _ in range(dice.choice((1, 2, 5, 40)))]
        if turn % 20 == 0:
            parts = [f"{key}={HOSTILE[turn // 20]}" for key in keys]
        # The window stays small so that 200 of them take seconds.
        page.evaluate("text => { location.hash = text; }", "&".join([*parts, "side=32"]))
        if turn % 10 == 9:
            rest(page)
            assert page.locator(".notice").is_hidden(), parts
            assert len(page.evaluate(PIXELS)) > 500
        told = state(page)
        assert list(told) == keys_in_order
        for key, (low, high) in REALS.items():
            assert low <= told[key] <= high, (key, parts)
        for key, words in WORDS.items():
            assert told[key] in words, (key, parts)


def test_a_link_followed_on_the_same_page_is_taken(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#defocus=1")
    page.evaluate("location.hash = '#coma=0.5'")
    rest(page)
    assert state(page)["coma"] == 0.5
    assert state(page)["defocus"] == 0.6
