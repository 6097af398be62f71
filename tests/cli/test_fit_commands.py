"""What commands of fits look for, and what they say of the result."""

from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest

import lommel as lm
from lommel.cli import fit_commands


def test_coefficients_blurs_and_rejected_stars_are_told_with_their_errors_in_their_units():
    result = SimpleNamespace(
        extent=((-1.0, 1.0), (-2.0, 2.0)), middle=(0.0, 0.0), distortion=None, focus=None, names=[(3, 1)],
        at=lambda x, y: (np.array([math.pi * (1.0 + x)]), np.array([0.2 * math.pi])),
        coma=SimpleNamespace(rms=math.pi, error=0.1 * math.pi, degrees=30.0),
        blurs=((lm.Jitter(2e-6),), ()), blur_errors=((1e-7,), ()),
        stars=SimpleNamespace(used=np.array([True, False, False]), chi2=np.array([9.0, 2.0, 3.0]),
                              places=np.array([[0, 0], [1, 5], [2, 6]])),
    )  # fmt: skip
    names = "status", "converged", "reliable", "message", "findings", "chi2", "held_out", "degree", "blur_errors"
    result.to_dict = lambda: dict.fromkeys(names, 1)
    facts = fit_commands._facts(result, SimpleNamespace(left_out={}, refused=[]), down=False)
    assert facts["coma"] == {"waves": 0.5, "error": pytest.approx(0.05), "degrees": 30.0}
    assert facts["waves"] == {
        "middle": {"coefficients": [0.5], "errors": pytest.approx([0.1])},
        "corner": {"coefficients": [1.0], "errors": pytest.approx([0.1])},
    }
    assert [star["reason"] for star in facts["rejected_stars"]] == ["rejected, chi2 3", "rejected, chi2 2"]
    (line,) = fit_commands.blurs_in_words(result, 4e-6, None)
    assert line.text == "blur: 0.500 +- 0.025 pixels (standard deviation); none"
    result.blurs = ((lm.Motion(8e-6, 0.5), lm.Jitter(2e-6, 1e-6, 0.25), lm.Seeing.from_fwhm(4.8e-6, 1.0)),)
    result.blur_errors = ((2e-7, 1e-7, 0.01),)
    (line,) = fit_commands.blurs_in_words(result, 4e-6, 1.0)
    line_of, ellipse, seeing = line.text.removeprefix("blur: ").split(" and ")
    assert line_of == "a line of 2.000 +- 0.050 pixels at 29 degrees from the rows"
    assert ellipse == "0.500 +- 0.025 by 0.250 pixels (standard deviation) at 14 degrees from the rows"
    assert seeing.startswith("seeing of 0.99")
    upside_down = fit_commands._facts(result, SimpleNamespace(left_out={}, refused=[]), down=True)
    assert upside_down["coma"]["degrees"] == 330.0  # counterclockwise as shown
    result.coma = None
    assert fit_commands._facts(result, SimpleNamespace(left_out={}, refused=[]), down=True)["coma"] is None


def test_beads_of_a_field_begin_half_a_window_before_their_places(monkeypatch):
    class Spots(SimpleNamespace):
        __len__ = lambda _: 2  # noqa: E731

    spots = Spots(places=np.array([[9, 20], [30, 41]]), windows=np.zeros((2, 3, 5, 7)), refused=[])
    monkeypatch.setattr(fit_commands.detection, "find_spots", lambda *_, **__: spots)
    found = fit_commands._beads(fit_commands._Source("a.tif", 5e-7, ""), "a.tif", np.zeros((3, 60, 60)), None, 7, [])
    assert [(bead.name, bead.corner) for bead in found] == [("a.tif [0]", (7, 17)), ("a.tif [1]", (28, 38))]
