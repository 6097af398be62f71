"""What the search for a field map says of its ends."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from lommel.estimation.field_search import Outcome, Rival
from lommel.fit.score_tests import Grade, Marginal


@pytest.mark.parametrize("rival", [None, Rival(2.0, 6.0)])
def test_another_minimum_that_fits_as_well_is_a_doubt(rival):
    found: Any = SimpleNamespace(quality=(1.0, 0.01), model=SimpleNamespace(chosen=np.arange(9)))
    nothing = Grade(Marginal(np.zeros(0), np.zeros((0, 0))), 0.0, 0.0, 0, 1.0, (0.9, 1.1))
    outcome = Outcome(found, np.arange(0), (1.0, 0.1), (1.0, 0.1), np.zeros((9, 2)), {}, [], (), nothing, rival)
    finding = outcome.findings.get("another_minimum")
    assert outcome.findings.converged
    assert outcome.findings.reliable == (rival is None)
    assert (finding is None) == (rival is None)
    if finding is not None:
        assert "6 standard errors away" in finding.text
