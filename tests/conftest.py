"""What every test shares."""

from __future__ import annotations

import os
from pathlib import Path

import matplotlib as mpl
from hypothesis import HealthCheck, settings

mpl.use("Agg")

# No deadline: shared machines stall. HYPOTHESIS_PROFILE=thorough searches longer.
settings.register_profile("quick", deadline=None, max_examples=40, suppress_health_check=[HealthCheck.too_slow])
settings.register_profile("thorough", deadline=None, max_examples=1000)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "quick"))

ROOT = Path(__file__).resolve().parent.parent
LENSES = sorted((ROOT / "examples" / "lenses").glob("*.toml"))
