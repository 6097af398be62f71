"""The live page by hand: touch, keys, undo, play, help; and nothing shown beside a setting that it is not of."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import Any

import pytest

from live_page import box, rest, slider, state

HUBBLE = "Hubble Space Telescope before its 1993 repair, at its best focus"
PHONE = {"viewport": {"width": 390, "height": 844}, "has_touch": True, "is_mobile": True}
# Answers of the core take as long as window.slow says, in ms.
SLOW = """window.slow = 0; window.questions = []; const { postMessage } = Worker.prototype;
Worker.prototype.postMessage = function (message) {
  if (message.method === "start" || !window.slow) return postMessage.call(this, message);
  setTimeout(() => postMessage.call(this, message), window.slow);
};"""


def touch(page: Any, *points: tuple[float, float]) -> None:
    """Swipe along points with one finger."""
    session = page.context.new_cdp_session(page)
    for index, (x, y) in enumerate(points):
        kind = "touchMove" if index else "touchStart"
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [{"x": x, "y": y}]})
        page.wait_for_timeout(16)
    session.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})


def middle(page: Any, key: str) -> tuple[float, float, float]:
    """Return the middle of a slider, in view, and its width."""
    slider(page, key).scroll_into_view_if_needed()
    page.wait_for_timeout(100)
    place = slider(page, key).bounding_box()
    return place["x"] + place["width"] / 2, place["y"] + place["height"] / 2, place["width"]


def text(page: Any, key: str) -> str:
    """Return a number as it is shown."""
    return page.locator(f'dd[data-number="{key}"]').inner_text()


def late(page: Any) -> set[str]:
    """Return the panels that are grey."""
    return set(page.locator(".late").evaluate_all("all => all.map((node) => node.className.split(' ')[0])"))


def test_a_swipe_that_scrolls_changes_nothing(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64", **PHONE)
    x, y, _ = middle(page, "spherical")
    before, at = state(page), page.evaluate("scrollY")
    page.evaluate("window.told = 0; live.set({}); 0")
    touch(page, *((x + 40, y - 12 * k) for k in range(14)))
    rest(page)
    assert page.evaluate("scrollY") > at + 60
    assert state(page) == before
    assert float(slider(page, "spherical").input_value()) == before["spherical"]
    assert page.locator('[data-action="undo"]').get_attribute("aria-disabled") == "true"


def test_a_finger_drags_sideways_and_a_tap_sets(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64", **PHONE)
    x, y, wide = middle(page, "spherical")
    touch(page, *((x + 8 * k, y) for k in range(8)))
    rest(page)
    assert state(page)["spherical"] == pytest.approx(10 * 56 / (wide - 16), abs=0.15)
    touch(page, (x, y))
    rest(page)
    assert abs(state(page)["spherical"]) < 0.1


def test_a_drag_is_one_step_back_and_forth(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64")
    x, y, wide = middle(page, "defocus")
    ends = []
    for shares in ((0.1, 0.2, 0.3), (0.0, -0.2)):
        page.mouse.move(x, y)
        page.mouse.down()
        for share in shares:
            page.mouse.move(x + share * wide, y)
            page.wait_for_timeout(30)
        page.mouse.up()
        rest(page)
        ends.append(state(page)["defocus"])
    undo, redo = page.get_by_role("button", name="Undo"), page.get_by_role("button", name="Redo")
    undo.click()
    assert state(page)["defocus"] == ends[0]
    page.keyboard.press("Control+z")
    assert state(page)["defocus"] == 0.6
    rest(page)
    assert undo.get_attribute("aria-disabled") == "true"
    undo.click(force=True)
    assert state(page)["defocus"] == 0.6
    page.keyboard.press("Control+Shift+z")
    redo.click()
    assert state(page)["defocus"] == ends[1]
    page.locator('select[data-key="light"]').select_option("white")
    page.keyboard.press("Control+z")
    assert state(page)["light"] == "mono"
    rest(page)
    assert redo.get_attribute("aria-disabled") == "false"


@pytest.mark.parametrize(
    ("key", "typed", "said"),
    [
        ("f_number", "0.01", "f-number is 0.7 to 300. Still 4."),
        ("coma", "-0.5", "Coma is 0 to 10 waves; for the other sign turn its angle by 180°. Still 0."),
        ("vanes", "2.5", "Number of vanes is a whole number, 0 to 8. Still 0."),
        ("coma", "1e400", "Coma is 0 to 10 waves. Still 0."),
    ],
)
@pytest.mark.parametrize("end", ["Enter", "Tab"])
def test_a_number_out_of_range_stays_with_its_range_below(
    visit: Callable[..., Any], key: str, typed: str, said: str, end: str
) -> None:
    page = visit("/mounted#side=64")
    before = state(page)
    box(page, key).focus()
    page.keyboard.type(typed)  # of which the beginning may be in range
    page.keyboard.press(end)
    rest(page)
    fault = page.locator(f'[data-row="{key}"] .fault')
    assert fault.inner_text() == said
    assert box(page, key).get_attribute("aria-invalid") == "true"
    assert box(page, key).input_value() == typed
    places = [node.bounding_box() for node in (box(page, key), fault, slider(page, key))]
    for a, b in itertools.combinations(places, 2):  # nothing is covered
        beside = a["x"] + a["width"] <= b["x"] + 1 or b["x"] + b["width"] <= a["x"] + 1
        assert beside or a["y"] + a["height"] <= b["y"] + 1 or b["y"] + b["height"] <= a["y"] + 1
    assert state(page)[key] == before[key]
    page.mouse.click(500, 300)
    assert fault.is_visible()
    slider(page, key).focus()
    page.keyboard.press("ArrowRight")
    rest(page)
    assert fault.is_hidden()
    assert float(box(page, key).input_value()) == pytest.approx(state(page)[key], rel=1e-3)


@pytest.mark.parametrize("typed", ["inf", "Infinity", "∞", "1e12"])
def test_distances_can_be_infinite(visit: Callable[..., Any], typed: str) -> None:
    page = visit("/mounted#side=64&focus=distances&object_distance=120")
    for text, seen, value in (("5000,5", "5000.5", 5000.5), (typed, "∞", 1e12)):
        box(page, "focus_distance").select_text()
        page.keyboard.type(text)
        page.keyboard.press("Enter")
        rest(page)
        assert box(page, "focus_distance").input_value() == seen
        assert state(page)["focus_distance"] == value
    page.keyboard.press("Tab")
    assert slider(page, "focus_distance").get_attribute("aria-valuetext") == "∞ metres"
    assert page.locator(".notice").is_hidden()
    page = visit(f"/mounted#side=64&focus=distances&object_distance=120&focus_distance={typed}")
    assert state(page)["focus_distance"] == 1e12
    assert page.locator(".notice").is_hidden()


def test_an_answer_to_an_older_setting_is_grey_within_a_fifth_of_a_second(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64", before=SLOW)
    assert late(page) == set()
    page.evaluate("window.slow = 3500; live.set({ coma: 0.5 })")
    page.wait_for_function(
        "document.querySelector('.lommel-live-host').shadowRoot.querySelector('.working')", timeout=1500
    )
    assert {"numbers", "plots", "frame", "pupils", "picture", "code"} <= late(page)
    assert page.locator(".work").is_hidden()
    for name in ("png", "csv", "tiff", "python", "hold"):
        assert page.locator(f'[data-action="{name}"]').get_attribute("aria-disabled") == "true", name
    page.locator('[data-action="csv"]').click(force=True)
    assert "computing" in page.locator("p[role=status]").inner_text().lower()
    page.locator(".work", has_text="Computing").wait_for(timeout=3500)
    page.evaluate("window.slow = 0")
    rest(page)
    assert late(page) == set()
    assert page.locator(".work").is_hidden()
    assert page.locator('[data-action="csv"]').get_attribute("aria-disabled") == "false"


def test_stop_leaves_dashes_and_any_change_computes_again(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64", before=SLOW)
    page.evaluate("window.slow = 60000; live.set({ coma: 0.5 })")
    page.get_by_role("button", name="Stop").click(timeout=8000)
    rest(page)
    assert "Stopped" in page.locator(".work").inner_text()
    assert {text(page, key) for key in ("strehl", "largest", "d80", "inside", "bound", "time")} == {"–"}
    assert page.locator(".plot path.curve").count() == 0
    assert page.locator(".code pre").inner_text() == "–"
    assert page.evaluate("live.result() === undefined")
    page.evaluate("window.slow = 0; live.set({ coma: 0.25 })")
    rest(page)
    assert page.locator(".work").is_hidden()
    assert page.evaluate("live.result().state.coma") == 0.25
    assert 0 < float(text(page, "strehl")) < 1


def test_the_source_of_a_preset_goes_with_its_setting(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64")
    assert page.locator("h2.name").inner_text() == "Point spread function, live"
    page.locator('select[data-key="preset"]').select_option(label=HUBBLE)
    rest(page)
    assert page.locator("h2.name").inner_text() == HUBBLE
    assert "Burrows" in page.locator(".source").inner_text()
    page.evaluate("live.set({ defocus: 1 })")
    rest(page)
    assert page.locator("h2.name").inner_text() == f"Changed from: {HUBBLE}"
    assert page.locator(".source").is_hidden()
    assert page.locator('select[data-key="preset"]').input_value() == ""
    page.keyboard.press("Control+z")
    rest(page)
    assert page.locator(".source").is_visible()
    page.locator('[data-action="reset"]').click()
    rest(page)
    assert page.locator("h2.name").inner_text() == "Point spread function, live"
