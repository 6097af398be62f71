"""What tests of the live page do with it: its controls, its state, its pixels."""

from __future__ import annotations

from typing import Any

from lommel.page.state import FIELDS, Real, Word

IDLE = ".lommel-live-host:not([data-busy])"
REALS = {name: (field.low, field.high) for name, field in FIELDS.items() if isinstance(field, Real)}
WORDS = {name: field.choices for name, field in FIELDS.items() if isinstance(field, Word)}
SLIDERS = [name for name, field in FIELDS.items() if isinstance(field, Real) and not field.row.when] + ["defocus"]
# Settings in which every slider but that of defocus is shown.
ALL_SHOWN = "focus=distances&vanes=1&noise=on"
PIXELS = """() => document.querySelector(".lommel-live-host").shadowRoot.querySelector(".now canvas").toDataURL()"""


def rest(page: Any) -> None:
    """Wait until nothing is computed or about to be, and the address is written."""
    page.wait_for_timeout(50)
    page.wait_for_selector(IDLE, state="attached")


def state(page: Any) -> dict[str, Any]:
    """Return the state of the page."""
    return page.evaluate("live.state")


def slider(page: Any, key: str) -> Any:
    """Return the slider of a key."""
    return page.locator(f'input[type=range][data-key="{key}"]')


def box(page: Any, key: str) -> Any:
    """Return the number box of a key."""
    return page.locator(f'.line input[data-key="{key}"]')


def fragment(page: Any) -> str:
    """Return the fragment of the address, once it is written."""
    page.wait_for_timeout(350)
    return page.url.partition("#")[2]


def default_state(page: Any) -> dict[str, Any]:
    """Return what the page starts with."""
    return page.evaluate("async () => ({ ...(await import('./lommel-live.js')).DEFAULTS })")
