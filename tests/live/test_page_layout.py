"""Nothing moves by what is shown, and everything is in reach: header, scrolling, enlarged screens."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

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
