"""Zernike tables: what they mean as wavefronts, and back."""

from __future__ import annotations

import math

import pytest

import lommel as lm
from lommel.io.zernike_tables import ZernikeTable


def test_a_wavefront_becomes_a_table_and_comes_back():
    wavefront = lm.Wavefront(3.0, -1.0, nonradial={(3, 1): 0.5, (4, -2): 0.25})
    for unit in ("waves", "radians", "nm", "metres"):
        table = ZernikeTable.from_wavefront(wavefront, order="ansi", unit=unit, wavelength=550e-9)
        difference = (table.wavefront() - wavefront).to_zernike()
        assert max([0.0, *(abs(float(c)) for c in difference.values())]) < 1e-14
    assert ZernikeTable.from_wavefront(wavefront, unit="nm", wavelength=550e-9).terms[8] == pytest.approx(
        0.5 / math.sqrt(8) / (2 * math.pi) * 550
    )


def test_a_path_is_as_long_at_every_wavelength():
    waves = ZernikeTable({7: 0.1}, "noll", "waves", "rms", 600e-9)
    metres = ZernikeTable({7: 60.0}, "noll", "nm", "rms")
    for wavelength in (600e-9, 400e-9):
        one, two = waves.wavefront(wavelength), metres.wavefront(wavelength)
        assert float(one.nonradial[3, -1]) == pytest.approx(float(two.nonradial[3, -1]), rel=1e-14)
    assert float(waves.wavefront(400e-9).to_zernike(order="noll", unit="waves")[7]) == pytest.approx(0.15)
    assert waves.wavefront() == waves.wavefront(600e-9)


def test_a_phase_needs_to_know_its_wavelength():
    with pytest.raises(ValueError, match="wavelength must be given, since the unit of the table is 'nm'"):
        ZernikeTable({7: 60.0}, "noll", "nm", "rms").wavefront()
    unstated = ZernikeTable({7: 0.1}, "noll", "waves", "rms")
    assert unstated.wavefront() == lm.Wavefront.zernike({7: 0.1}, order="noll", unit="waves")
    with pytest.raises(ValueError, match="must state the wavelength at which its waves were measured"):
        unstated.wavefront(500e-9)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"wavelength": 550}, "for 550 nm give 550e-9"),
        ({"terms": {4: math.nan}}, "the Zernike coefficient 4 must be finite, got nan"),
        ({"terms": {0: 1.0}}, "must be from 1 to 1891, got 0"),
    ],
)
def test_a_bad_table_is_refused(change, message):
    with pytest.raises((ValueError, TypeError), match=message):
        ZernikeTable(**{"terms": {4: 1.0}, "order": "noll", "unit": "waves", "normalization": "rms"} | change)


def test_a_table_is_of_a_single_wavefront():
    with pytest.raises(ValueError, match=r"single one, got a stack of shape \(2,\)"):
        ZernikeTable.from_wavefront(lm.Wavefront([1.0, 2.0]))
    with pytest.raises(ValueError, match="needs the wavelength"):
        ZernikeTable.from_wavefront(lm.Wavefront(1.0), unit="nm")
