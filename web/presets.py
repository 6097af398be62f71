"""What the live page's menu of presets holds: the lens files of examples/lenses, as far as its controls say them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import lommel as lm
from lommel.page.state import state_of

LENSES = Path(__file__).resolve().parent.parent / "examples" / "lenses"


def presets() -> list[dict[str, Any]]:
    """Return each lens file as name, source, state of the page, and words about what the state leaves out."""
    return [preset(path) for path in sorted(LENSES.glob("*.toml"))]


def preset(path: Path) -> dict[str, Any]:
    """Return one lens file."""
    instrument = lm.load_instrument(path)
    state, left_out = state_of(instrument)
    return {"name": instrument.name, "source": instrument.source, "state": state, "left_out": left_out}
