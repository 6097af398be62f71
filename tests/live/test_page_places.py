"""The live page at all widths, in all themes, several on a page, in notebooks."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from live_page import IDLE


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
