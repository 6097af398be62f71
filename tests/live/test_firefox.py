"""The live page in Firefox: the same numbers and the same hands as in Chromium."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from live_page import IDLE, rest

ROOT = "document.querySelector('.lommel-live-host').shadowRoot"
RESTS = f"document.querySelector({IDLE!r}) !== null"
STATE = "#defocus=1.3&coma=0.7&coma_angle=20&light=white&side=96"
RESULT = """(() => { const { psf, measures } = live.result(); const some = psf.values.filter((_, i) => i % 37 === 0);
  return { values: Array.from(some), bound: psf.bound,
  strehl: measures.strehl, d80: measures.d80, mtf: Array.from(measures.mtf.x) }; })()"""


def test_firefox_has_the_numbers_of_chromium(tab: Callable[..., Any], visit: Callable[..., Any]) -> None:
    there = tab(f"/mounted{STATE}").evaluate(RESULT)
    page = visit(f"/mounted{STATE}")
    rest(page)
    here = page.evaluate(RESULT)
    assert there["values"] == here["values"]
    assert (there["bound"], there["strehl"], there["d80"]) == (here["bound"], here["strehl"], here["d80"])
    assert there["mtf"] == pytest.approx(here["mtf"], abs=1e-10)


def test_a_slider_is_dragged_sideways_by_a_finger_and_by_keys(tab: Callable[..., Any]) -> None:
    page = tab("/mounted#side=64", width=390, height=844)
    slider = (
        "document.querySelector('.lommel-live-host').shadowRoot.querySelector('input[type=range][data-key=coma]')"
    )
    page.evaluate(f"{slider}.scrollIntoView({{ block: 'center' }})")
    x, y, width, height = page.evaluate(
        f"(() => {{ const b = {slider}.getBoundingClientRect(); return [b.x, b.y, b.width, b.height]; }})()"
    )
    at = {"y": round(y + height / 2)}
    page.pointer(
        "touch",
        {"type": "pointerMove", "x": round(x + 6), **at},
        {"type": "pointerDown", "button": 0},
        {"type": "pointerMove", "x": round(x + width / 2), "duration": 200, **at},
        {"type": "pointerUp", "button": 0},
    )
    page.wait_for("Math.abs(live.state.coma - 1.5) < 0.1")
    page.evaluate(f"{slider}.focus()")
    before = page.evaluate("live.state.coma")
    page.press("\ue014")  # the right arrow key
    page.wait_for(f"live.state.coma > {before}")
    page.wait_for(RESTS)
    assert page.evaluate("live.result().state.coma === live.state.coma")
