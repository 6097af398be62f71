"""What counts say of a model."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.special import kl_div

from lommel import Lens, Noise
from lommel.deconvolve.likelihood import PhotographLikelihood
from lommel.imaging import DepthBlur, LinearBlur

LENS = Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)


def _blur(shape: tuple[int, int] = (20, 24), channels: int = 1, dtype: type = np.float64) -> DepthBlur:
    return DepthBlur(np.full(shape, 2.2), LENS, 8e-6, channels=(550e-9,) * channels, dtype=dtype)


class Sharp(LinearBlur):
    """Leaves images as they are."""

    def __init__(self, shape: tuple[int, int] = (20, 24), channels: int = 1, dtype: type = np.float64) -> None:
        self.shape, self.channels, self.dtype = shape, channels, np.dtype(dtype)

    def forward(self, image: np.ndarray) -> np.ndarray:
        return image.copy()

    adjoint = forward


def _deviance(found: PhotographLikelihood, model: np.ndarray) -> np.ndarray:
    """Return the Poisson deviance of expected counts, of which reading noise is a part, of an unblurred scene."""
    return found.expected * found.discrepancies_of(model - found.added)


@pytest.mark.parametrize(("dtype", "rtol"), [(np.float64, 1e-12), (np.float32, 2e-3)])
@pytest.mark.parametrize("white", [30.0, 5e6])
def test_the_discrepancy_is_the_poisson_deviance_a_pixel(dtype: type, rtol: float, white: float) -> None:
    rng = np.random.default_rng(0)
    light = rng.random((20, 24))
    mean = np.clip(light * (1.0 + rng.normal(size=light.shape) / np.sqrt(white)), 0.01, None)
    found = PhotographLikelihood(Sharp(dtype=dtype), light, Noise(white=white, read=4.0, offset=-0.1))
    model = (mean + 16.0 / white).astype(dtype)
    wanted = 2.0 * kl_div(white * (light + 0.1 + 16.0 / white), white * model.astype(float)).mean()
    assert _deviance(found, model)[0] == pytest.approx(wanted, rel=rtol)


def test_what_is_right_has_a_discrepancy_of_one_for_each_channel() -> None:
    blur = Sharp((120, 120), 3)
    light = np.random.default_rng(1).random((120, 120, 3)) * [1.0, 0.3, 0.1]
    noise = Noise(white=900.0, read=5.0, offset=0.02)
    photo = noise.record(np.moveaxis(900.0 * light, 2, 0), seed=2)
    found = PhotographLikelihood(blur, np.moveaxis(photo, 0, 2), noise)
    assert _deviance(found, light + found.added) == pytest.approx([1.0] * 3, abs=5 * np.sqrt(2.0 / 120**2))


def test_each_pixel_may_have_its_own_gain_and_noise() -> None:
    rng = np.random.default_rng(3)
    shape = (100, 100)
    noise = Noise(white=rng.uniform(200.0, 2000.0, shape), read=rng.uniform(0.0, 20.0, shape))
    light = rng.random(shape)
    found = PhotographLikelihood(Sharp(shape), noise.record(light * noise.white, seed=4), noise)
    assert found.white == pytest.approx(np.mean(noise.white))
    np.testing.assert_allclose(found.weight * found.white, noise.white, rtol=1e-12)
    assert _deviance(found, light + found.added)[0] == pytest.approx(1.0, abs=0.07)


def test_what_is_unknown_counts_nowhere() -> None:
    rng = np.random.default_rng(5)
    light, noise = rng.random((20, 24)), Noise(white=1000.0, read=2.0)
    hidden = light.copy()
    hidden[3:9, 4:11] = np.nan
    whole, part = (PhotographLikelihood(Sharp(), image, noise) for image in (light, hidden))
    assert part.known.tolist() == [20 * 24 - 42]
    model = rng.random((20, 24)) + 0.1
    known = np.isfinite(hidden)
    each = kl_div(1000.0 * whole.counts[known], 1000.0 * model[known])
    assert _deviance(part, model)[0] == pytest.approx(2.0 * each.mean())
    assert part.start == pytest.approx(light[known].mean())
    blurred = PhotographLikelihood(_blur(), hidden, noise)
    seen = _blur().adjoint(known.astype(float))
    per = blurred.operator.per_seen(0, slice(0, 20), slice(0, 24))
    np.testing.assert_allclose(per * seen, np.where(seen > 1e-6, 1.0, 0.0), atol=1e-9)
    np.testing.assert_allclose(part.image[known], light[known], rtol=1e-12)
    np.testing.assert_allclose(part.image[~known], light[known].mean(), rtol=1e-12)


def test_a_saturated_pixel_asks_for_at_least_so_much() -> None:
    light = np.full((20, 24), 0.5)
    light[5:9, 5:9] = [[0.8, 0.9, 1.0, 7.0]]
    noise = Noise(white=1000.0, read=2.0)
    found = PhotographLikelihood(Sharp(), light, noise, 0.8)
    added = 4.0 / 1000.0
    assert found.known.tolist() == [20 * 24 - 16]
    np.testing.assert_allclose(found.counts[5:9, 5:9], 0.8 + added)
    model = np.full((20, 24), 0.5 + added)
    model[5:9, 5:9] = [[0.3, 0.8 + added, 2.0, 9.0]]
    misfit = np.empty((1, 20, 24))
    found.discrepancies(found.operator, found.operator.planes(model - added), misfit)
    np.testing.assert_allclose(misfit[0, 5:9, 5:9], [[(0.8 + added) / 0.3 - 1.0, 0.0, 0.0, 0.0]] * 4)
    wanted = 4 * 2.0 * kl_div(1000.0 * (0.8 + added), 300.0) / found.known[0]
    assert _deviance(found, model)[0] == pytest.approx(wanted)
    again = found.replaced(found.light + 0.1)
    assert np.array_equal(again.full, found.full)


def test_darkness_is_counted_without_a_fault() -> None:
    found = PhotographLikelihood(_blur(), np.zeros((20, 24)), Noise(white=1000.0, read=0.0))
    assert found.discrepancies_of(np.zeros((20, 24)))[0] == pytest.approx(0.0, abs=1e-20)
    # Less than nothing, which reading makes, is none.
    below = PhotographLikelihood(_blur(), np.full((20, 24), -0.5), Noise(white=1000.0, read=3.0))
    assert not below.counts.any()
    assert np.isfinite(below.flat())


def test_a_photograph_of_which_nothing_is_known_is_refused() -> None:
    with pytest.raises(ValueError, match="no pixel"):
        PhotographLikelihood(_blur(), np.full((20, 24), np.nan), Noise(read=1.0))
    with pytest.raises(ValueError, match="no pixel"):
        PhotographLikelihood(_blur(), np.ones((20, 24)), Noise(read=1.0), 0.5)
    with pytest.raises(ValueError, match="read"):
        PhotographLikelihood(_blur(), np.ones((20, 24)), Noise(read=np.ones((3, 3))))


def test_a_channel_of_which_nothing_is_known_begins_as_bright_as_the_others() -> None:
    light = np.full((20, 24, 3), [0.2, np.nan, 0.4])
    light[:10, :, 2] = np.nan
    found = PhotographLikelihood(_blur(channels=3), light, Noise(white=1000.0, read=2.0))
    # Steps that multiply would never leave 0.
    np.testing.assert_allclose(found.start.ravel(), [0.2, (2 * 0.2 + 0.4) / 3, 0.4], rtol=1e-9)
