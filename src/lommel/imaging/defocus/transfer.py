"""The transfer function of a lens and its pixels, by the windows that photographs are made of."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.estimation.pixel_transfer import transfer_of_windows
from lommel.imaging.sensor_light import SensorLight
from lommel.methods.pixel_rule import quarters
from lommel.optics.lens import Lens


def sensor_transfer(
    lens: Lens,
    distances: Array,
    spectrum: Sequence[tuple[float, float]],
    pixel: float,
    shape: tuple[int, int],
    half: int,
) -> NDArray[np.float32]:
    """Do as :func:`lommel.estimation.pixel_transfer.pixel_transfer`, at no more cost for pixels of many lambda*N.

    Parameters
    ----------
    lens, distances, spectrum, pixel, shape, half
        As there.

    Returns
    -------
    ndarray, shape (count, height // 2 + 1, width // 2 + 1)
    """
    light = SensorLight.of(lens, spectrum, pixel)
    octants = light.shares(light.defocused(lens.defocus(distances)), half)
    return transfer_of_windows(np.asarray(quarters(octants, half)), shape)
