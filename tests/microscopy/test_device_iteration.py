"""Stacks on a device: the values of arrays of NumPy, on the device of the stack."""

from __future__ import annotations

import array_api_strict as strict
import numpy as np
import pytest

import lommel as lm
from lommel.microscopy import device_iteration, stack_blur
from lommel.traced.namespaces import Placement
from objectives import OIL_60X
from restored_stacks import deconvolved

DEVICE = strict.Device("device1")
RNG = np.random.default_rng(1)
STACK = RNG.poisson(20.0 + 900.0 * np.exp(-((np.indices((6, 16, 20)) - 8.0) ** 2).sum(axis=0) / 6.0)).astype(
    np.float32
)
STEPS = lm.imaging.RichardsonLucy(steps=3, target=0.0)
GIVEN = {
    "pixel": 6e-6, "step": 0.5e-6, "wavelength": 520e-9, "depth": 3e-6, "direction": "up", "diagnosis": False,
    "noise": lm.Noise(white=0.5, read=1.0), "method": STEPS, "window": (5, 9), "margin": (1, 2), "slabs": 1,
}  # fmt: skip


def there(values):
    return strict.asarray(values, device=DEVICE)


@pytest.mark.parametrize(
    "options",
    [
        {},
        {"background": "uneven", "noise": lm.Noise(white=RNG.uniform(0.4, 0.6, (16, 20)), read=1.0)},
        {"background": 2.0, "mask": RNG.random(STACK.shape) > 0.95, "tile": 16},
        {"window": (9, 13), "margin": (2, 4), "slabs": None},
        {"window": (9, 13), "margin": (2, 4), "slabs": None, "method": lm.imaging.RichardsonLucy(target=1.0)},
    ],
    ids=["one PSF", "uneven", "chunks and a mask", "a PSF for each plane", "until the noise"],
)
def test_a_stack_on_a_device_has_the_values_of_numpy(options):
    given = GIVEN | options
    expected, found = (deconvolved(stack, OIL_60X, **given) for stack in (STACK, there(STACK)))
    assert isinstance(found.values, type(there(STACK)))
    assert (found.values.device, found.values.dtype, found.values.shape) == (DEVICE, strict.float32, STACK.shape)
    # More steps, with their extrapolation, add up more roundings.
    limit = (1e-6 if given["method"] is STEPS else 3e-6) * expected.values.max()
    np.testing.assert_allclose(np.asarray(found), np.asarray(expected), rtol=0.0, atol=limit)
    one, other = (result.channels[0] for result in (expected, found))
    assert (one.steps, one.stopped) == (other.steps, other.stopped)
    assert other.discrepancy == pytest.approx(one.discrepancy, rel=1e-6)
    np.testing.assert_allclose(other.background, one.background, rtol=1e-6)


def test_a_result_on_a_device_is_saved(tmp_path):
    found = deconvolved(there(STACK), OIL_60X, **GIVEN)
    found.save(tmp_path / "a.ome.tif")
    with lm.recorded.open_frames(tmp_path / "a.ome.tif") as frames:
        np.testing.assert_array_equal(np.squeeze(frames[...]), np.asarray(found))
    assert found.to_dict()["shape"] == [6, 16, 20]


@pytest.mark.parametrize(
    ("option", "message"),
    [
        ({"out": "a.zarr"}, "out needs a file, or an array of NumPy, dask or Zarr; stack is one of array_api_strict"),
        ({"client": object()}, "client needs a file, or an array of NumPy"),
        ({"method": lm.imaging.TotalVariation()}, "method must be RichardsonLucy for arrays of array_api_strict"),
    ],
)
def test_what_a_device_does_not_support_is_named(option, message):
    with pytest.raises(ValueError, match=message):
        lm.microscopy.deconvolve(there(STACK), OIL_60X, **option)


KERNELS = RNG.random((2, 5, 7, 7))
EVEN = KERNELS + KERNELS[:, :, ::-1] + KERNELS[:, :, :, ::-1] + KERNELS[:, :, ::-1, ::-1]


@pytest.mark.parametrize("kernels", [KERNELS, EVEN], ids=["any", "even"])
@pytest.mark.parametrize("tiles", ["one tile", "tiles"])
@pytest.mark.parametrize(("planes", "margin"), [(4, (0, 3)), (5, (1, 2)), (3, (2, 3))])
def test_operators_on_a_device_are_those_of_the_host(kernels, tiles, planes, margin, monkeypatch):
    if tiles == "tiles":
        monkeypatch.setattr(stack_blur, "_MIN_VALUES", 0)
        monkeypatch.setattr(stack_blur, "_MAX_MEMORY_RATIO", 0.5)
    weights = RNG.random((2, planes + 2 * margin[0]))
    blur = stack_blur.TiledBlur(kernels, (planes, 21, 40), margin, weights=weights)
    assert blur._is_single_tile == (tiles == "one tile")
    operator = device_iteration._tiled(Placement.of(there(STACK)), blur)
    for transposed, source in ((False, blur.whole), (True, blur.shape)):
        light = RNG.random(source).astype(np.float32)
        expected = stack_blur._stored(blur, light, transposed=transposed)
        found = Placement.of(there(light)).to_numpy(operator(there(light), transposed=transposed))
        np.testing.assert_allclose(found, expected, rtol=0.0, atol=2e-6 * np.abs(expected).max())
