"""What tests of the live page do with it: its controls, its state, its pixels."""

from __future__ import annotations

from typing import Any

IDLE = ".lommel-live-host:not([data-busy])"
REALS = {
    "defocus": (-50, 50),
    "spherical": (-25, 25),
    "coma": (0, 10),
    "coma_angle": (-180, 180),
    "astigmatism": (0, 10),
    "astigmatism_angle": (-90, 90),
    "trefoil": (0, 10),
    "trefoil_angle": (-60, 60),
    "f_number": (0.7, 100),
    "obscuration": (0, 0.9),
    "wavelength": (200, 2000),
    "pixel": (0.05, 50),
    "side": (16, 1024),
    "focal_length": (0.1, 1e6),
}
WORDS = {
    "light": ("mono", "white"),
    "view": ("fine", "sampled", "averaged"),
    "stretch": ("sqrt", "linear", "log"),
    "map": ("inferno", "viridis", "cividis", "gray"),
    "waves_unit": ("waves", "rad", "nm"),
    "length_unit": ("um", "arcsec", "lambdaN"),
    "picture": ("star", "bars", "text", "points", "own"),
}
SLIDERS = [key for key in REALS if key != "focal_length"]
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
    return page.locator(f'input[type=number][data-key="{key}"]')


def fragment(page: Any) -> str:
    """Return the fragment of the address, once it is written."""
    page.wait_for_timeout(350)
    return page.url.partition("#")[2]


def default_state(page: Any) -> dict[str, Any]:
    """Return what the page starts with."""
    return page.evaluate("async () => ({ ...(await import('./lommel-live.js')).DEFAULTS })")
