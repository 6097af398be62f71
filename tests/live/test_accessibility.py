"""The live page by the rules of axe-core, https://github.com/dequelabs/axe-core."""

from __future__ import annotations

from collections.abc import Callable
from importlib.resources import files
from typing import Any

import pytest

RULES = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"]
FOUND = f"""axe.run(document, {{ runOnly: {RULES} }}).then((found) => found.violations.flatMap(
 ({{ id, nodes }}) => nodes.map((node) => `${{id}}: ${{node.target.flat().join(" ")}}, ${{node.failureSummary}}`)))"""


def axe() -> str:
    """Return axe-core as a script."""
    pytest.importorskip("axe_playwright_python", reason="axe-playwright-python is not installed, which has axe-core")
    return files("axe_playwright_python").joinpath("axe.min.js").read_text(encoding="utf-8")


@pytest.mark.parametrize("width", [390, 1366])
@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("address", ["/live#coma=0.3&side=64", "/live?lesson=depth"])
def test_axe_finds_nothing_in_chromium(visit: Callable[..., Any], address: str, scheme: str, width: int) -> None:
    page = visit(address, color_scheme=scheme, viewport={"width": width, "height": 768})
    page.evaluate(axe())
    assert page.evaluate(FOUND) == []


def test_axe_finds_nothing_in_firefox(tab: Callable[..., Any]) -> None:
    page = tab("/live#coma=0.3&side=64", width=1366, height=768)
    page.evaluate(f"(() => {{ {axe()}; }})()")
    assert page.evaluate(FOUND) == []
