"""Light of several wavelengths: what stays from one to the other, and what changes."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.optics.colour.spectrum import Spectrum
from lommel.optics.wavefront.wavefront import same_path


@pytest.mark.parametrize("model", ["paraxial", "aplanatic"])
def test_a_lens_in_other_light_is_the_lens_of_that_wavelength(model):
    """The distances of the lens say what its path differences are, at any wavelength."""
    lens = {"focal_length": 50e-3, "f_number": 2.8, "focus_distance": 2.0, "model": model}
    known = lm.Lens(**lens, wavelength=550e-9, spider=lm.Spider.equal(3, 0.1)).pupil([1.7, 2.5])
    for wave in (400e-9, 700e-9):
        there, other = lm.Lens(**lens, wavelength=wave).pupil([1.7, 2.5]), known.in_light(wave)
        rho = np.linspace(0.0, 1.0, 9)
        # What the terms of an aplanatic phase leave out differs.
        left = 2.0 * (known.wavefront.left_out + there.wavefront.left_out) + 1e-9
        np.testing.assert_allclose(other.wavefront.phase(rho, 0.3), there.wavefront.phase(rho, 0.3), atol=left)
        assert (other.wavelength, other.f_number, other.scale) == (wave, there.f_number, there.scale)
        assert other.spider == known.spider
        assert other.geometry == there.geometry


def test_a_path_is_as_long_in_any_light():
    wavefront = lm.Wavefront(2.0, 1.0, nonradial={(3, 1): 0.5})
    found = same_path(wavefront, 500e-9, 400e-9).to_zernike(unit="metres", wavelength=400e-9)
    expected = wavefront.to_zernike(unit="metres", wavelength=500e-9)
    assert list(found) == list(expected)
    np.testing.assert_allclose(list(found.values()), list(expected.values()), rtol=1e-12)


def test_components_share_the_light_and_are_brighter_where_they_are_narrower():
    spectrum = Spectrum([400e-9, 800e-9], [3.0, 1.0])
    parts = spectrum.components(lm.Pupil(lm.Wavefront(2.0), wavelength=600e-9, f_number=4.0))
    assert [part.share for part in parts] == [0.75, 0.25] == list(spectrum.weights)
    assert [part.stretch for part in parts] == pytest.approx([1.5, 0.75])
    assert [part.weight for part in parts] == pytest.approx([0.75 * 1.5**2, 0.25 * 0.75**2])
    assert [float(part.pupil.wavefront.defocus) for part in parts] == pytest.approx([3.0, 1.5])
    with pytest.raises(ValueError, match="a spectrum needs a pupil with a wavelength"):
        spectrum.components(lm.Pupil())


@pytest.mark.parametrize("weights", [[1.0], [0.0, 0.0], [1.0, -1.0], [1.0, np.nan], [[1.0, 1.0]]])
def test_weights_that_share_no_light_are_refused(weights):
    with pytest.raises(ValueError, match="weights"):
        Spectrum([400e-9, 500e-9], weights)
