"""The padded FFT: on the pixels, converging as it should, and refusing where it would alias."""

from __future__ import annotations

import re

import numpy as np
import pytest
from numpy.typing import NDArray

import lommel as lm
from lommel import Pupil, Wavefront
from lommel.methods import Hankel
from lommel.paper import Fraunhofer

PUPILS = {
    "in focus": Pupil(),
    "defocused": Pupil(Wavefront(10.0)),
    "obscured": Pupil(obscuration=0.33),
    "obscured and spherical": Pupil(Wavefront(10.0, -5.0), obscuration=0.33),
}


def _image(
    pupil: Pupil, shape: int | tuple[int, int], pixel: float, method: lm.methods.Method
) -> NDArray[np.float64]:
    return lm.psf(pupil, shape, pixel, method=method, normalize="strehl", dtype=np.float64, integrate=False).values


def _error(pupil: Pupil, method: Fraunhofer) -> float:
    exact = _image(pupil, 40, 0.5, Hankel())
    return float(np.sqrt(np.mean((_image(pupil, 40, 0.5, method) - exact) ** 2)) / exact.max())


@pytest.mark.parametrize(("edge", "steepest", "flattest"), [("binary", -1.9, -0.9), ("grey", -2.2, -1.9)])
@pytest.mark.parametrize("name", PUPILS)
def test_the_error_falls_with_the_samples_by_the_order_of_the_edge(
    name: str, edge: str, steepest: float, flattest: float
) -> None:
    """A staircase at the rim is of first order or a little better, a grey rim of second."""
    samples = np.array([64, 80, 96, 128, 160, 192, 256, 320, 384, 512])
    errors = [_error(PUPILS[name], Fraunhofer(int(n), padding=1.5, edge=edge)) for n in samples]
    order = np.polyfit(np.log(samples), np.log(errors), 1)[0]
    assert steepest <= order <= flattest
    assert errors[-1] <= (2e-3 if edge == "binary" else 3e-4)


@pytest.mark.parametrize("pixel", [0.2, 0.25, 0.7, 1.3, 3.4])
@pytest.mark.parametrize("shape", [(9, 9), (10, 10), (7, 12), (12, 7), (1, 11), (33, 2)])
def test_the_samples_land_on_the_pixels_and_the_centre_in_the_middle(shape: tuple[int, int], pixel: float) -> None:
    pupil = Pupil(Wavefront(4.0, 2.0), obscuration=0.2)
    image = _image(pupil, shape, pixel, Fraunhofer(samples=256, edge="grey"))
    # The pixels that have a partner on the other side of (H // 2, W // 2).
    height, width = shape
    up, left = (height - 1) // 2, (width - 1) // 2
    middle = image[height // 2 - up : height // 2 + up + 1, width // 2 - left : width // 2 + left + 1]
    assert np.abs(middle - middle[::-1]).max() <= 1e-15
    assert np.abs(middle - middle[:, ::-1]).max() <= 1e-15
    y, x = np.mgrid[-up : up + 1, -left : left + 1]
    assert abs(np.sum(middle * y)) <= 1e-13 * np.sum(middle)
    assert abs(np.sum(middle * x)) <= 1e-13 * np.sum(middle)
    exact = _image(pupil, shape, pixel, Hankel())
    assert np.abs(image - exact).max() <= 2e-3 * exact.max()


@pytest.mark.parametrize("padding", [1.0, 1.001, 1.5, 2.0, 7.3])
@pytest.mark.parametrize("edge", ["binary", "grey"])
def test_padding_does_not_change_what_the_pixels_hold(edge: str, padding: float) -> None:
    """With none at all, the two ends of the aperture share a sample of the transform, and both count."""
    pupil = Pupil(Wavefront(3.0))
    exact = _image(pupil, 15, 1.0, Hankel())
    image = _image(pupil, 15, 1.0, Fraunhofer(samples=128, padding=padding, edge=edge))
    assert np.abs(image - image[::-1]).max() <= 1e-15
    assert np.abs(image - exact).max() <= (0.01 if edge == "binary" else 0.001) * exact.max()


@pytest.mark.parametrize(
    ("pupil", "shape", "pixel"),
    [
        (Pupil(Wavefront(50.0)), 65, 0.5),
        (Pupil(Wavefront(-50.0, 10.0)), (20, 65), 0.5),
        (Pupil(Wavefront(0.0, 30.0), obscuration=0.5), (65, 20), 0.25),
        (Pupil(Wavefront([1.0, 60.0])), 9, 2.0),
        (Pupil(), 128, 1.0),
    ],
)
def test_aliasing_is_refused_and_the_samples_it_asks_for_suffice(
    pupil: Pupil, shape: int | tuple[int, int], pixel: float
) -> None:
    with pytest.raises(ValueError, match=r"Fraunhofer\(samples=16\) would alias: .* at least samples=\d+;") as caught:
        lm.psf(pupil, shape, pixel, method=Fraunhofer(samples=16))
    needed = int(re.findall(r"at least samples=(\d+);", str(caught.value))[0])
    with pytest.raises(ValueError, match=f"need at least samples={needed}"):
        lm.psf(pupil, shape, pixel, method=Fraunhofer(samples=needed - 1))
    # As many put the ghost of the blur next to the window; more sample the phase better.
    exact = _image(pupil, shape, pixel, Hankel())
    errors = [np.abs(_image(pupil, shape, pixel, Fraunhofer(k * needed, edge="grey")) - exact).max() for k in (1, 4)]
    assert errors[1] <= 0.5 * errors[0]
    assert errors[1] <= 0.1 * exact.max()


@pytest.mark.parametrize("padding", [1.0, 4.0])
@pytest.mark.parametrize("pixel", [0.2, 0.7, 3.0])
def test_averages_over_pixels_are_those_of_its_own_samples(pixel: float, padding: float) -> None:
    pupil, method = Pupil(Wavefront(2.0, 1.0), obscuration=0.3), Fraunhofer(512, padding=padding, edge="grey")
    found, exact = (
        lm.psf(pupil, 8, pixel, method=way, integrate=True, dtype=np.float64) for way in (method, Hankel())
    )
    assert lm.peak_error(found, exact) < 1e-4
