"""Spectra of the channels of photographs."""

from __future__ import annotations

import pytest

import lommel as lm
from lommel.imaging.settings import channel_spectra, spectra


def test_spectra_have_one_form():
    assert spectra("channels", [5e-7, [(5e-7, 1.0), (6e-7, 3.0)]]) == (((5e-7, 1.0),), ((5e-7, 0.25), (6e-7, 0.75)))
    assert channel_spectra((4, 5), 5e-7) == (5e-7,)
    assert channel_spectra((4, 5, 3), 5e-7) == lm.imaging.RED_GREEN_BLUE
    with pytest.raises(ValueError, match="each channel must have a wavelength of weight above 0"):
        spectra("channels", [[(5e-7, 0.0)]])
