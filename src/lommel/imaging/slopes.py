r"""How photographs change with the depth of a scene, and with the focus.

Where a point moves by ``delta``, its light x moves by ``x delta dC_d/dz dK/dC_d`` (chain rule; K as in
:class:`lommel.imaging.DepthBlur`). K is a mixture of four windows by cubic weights, and its derivative one of the
same four by the derivatives of the weights: it costs what the blur costs. Of ``C_d = k (1/d - 1/f + 1/z)``, with
``k = pi R^2 / (2 lambda)``, the derivative is ``-k / z^2`` by the distance z of a point, and ``-k / d^2`` by the
distance d of the sensor, for all points; but the sensor also moves the scale of all windows, in proportion to d.
"""

from __future__ import annotations

import copy
import math
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.imaging.bank import Bank, stored_windows
from lommel.imaging.blur import DepthBlur, Points
from lommel.imaging.sensor_light import SensorLight
from lommel.imaging.window_sizes import cut, find_cuts, sums_of_quarters

if TYPE_CHECKING:
    from scipy.sparse.linalg import LinearOperator

# Differences of fourth order: over steps of so much of C_d, of which phases turn by twice as much, and of the scale.
_DIFFERENCES = ((-2.0, 1.0 / 12.0), (-1.0, -2.0 / 3.0), (1.0, 2.0 / 3.0), (2.0, -1.0 / 12.0))
_STEP_OF_DEFOCUS, _STEP_OF_SCALE = 0.03, 1e-3


class BlurSlopes:
    """The derivatives of ``blur.forward(image)`` by the depth of every point, and by the focus: for fits of either.

    A linear operator, from changes of depth to changes of the photograph, with its exact transpose; both cost what
    the blur costs. Derivatives are those of the windows that are interpolated: beside the derivatives of exact ones,
    they err by about `tol` of the peak for each radian of C_d, and more where windows are far apart.

    Parameters
    ----------
    image : ndarray of float
        The scene, linear light, of the shape that :meth:`lommel.imaging.DepthBlur.forward` takes.
    blur : DepthBlur
        Placed at the depths around which things change; is not to be placed elsewhere afterwards.

    Raises
    ------
    TypeError, ValueError
        If `blur` is none, or as :meth:`lommel.imaging.DepthBlur.forward`.

    Examples
    --------
    >>> lens = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
    >>> depth, light = np.full((20, 30), 2.3), np.random.default_rng(0).random((20, 30))
    >>> blur = lm.imaging.DepthBlur(depth, lens, 8e-6, dtype=np.float64, tol=1e-6)
    >>> slopes = lm.imaging.BlurSlopes(light, blur)
    >>> before, change = blur.forward(light), np.full((20, 30), 1e-6)
    >>> blur.place(depth + change)
    >>> bool(np.allclose(blur.forward(light) - before, slopes.forward(change), rtol=1e-3, atol=1e-9))
    True
    """

    def __init__(self, image: NDArray[Any], blur: DepthBlur) -> None:
        validation.instance("blur", blur, DepthBlur)
        self._blur = copy.copy(blur)
        self._planes = np.array(blur.planes(image))
        self._shape = np.shape(image)
        lens = blur.lens
        infinite = float(lens.defocus(math.inf))
        # 0 at an infinite distance.
        self._per_metre = -((blur.defocus - infinite) ** 2) / (float(lens.defocus(1.0)) - infinite)

    @property
    def shape(self) -> tuple[int, int]:
        """Height and width."""
        return self._blur.shape

    def forward(self, change: NDArray[Any]) -> NDArray[Any]:
        """Return what the photograph changes by, to first order, where the depth does.

        Parameters
        ----------
        change : ndarray of float, shape (height, width)
            Metres.

        Returns
        -------
        ndarray
            Light, of the shape of the image and of the type of the sums.

        Raises
        ------
        TypeError, ValueError
            If `change` is not finite or of another shape.
        """
        metres = validation.real_array("change", change)
        if metres.shape != self.shape:
            raise ValueError(f"change must have the shape of the depth, {self.shape}, got {metres.shape}")
        radians = metres * self._per_metre
        moved = [plane * self._steps(channel, radians) for channel, plane in enumerate(self._planes)]
        made = [
            self._blur.spread(channel, [(plane, self._points(channel))], slopes=True)
            for channel, plane in enumerate(moved)
        ]
        if (beyond := self._blur.beyond) is not None:
            for onto, more in zip(
                made, beyond.spread(self._blur, range(len(moved)), moved, slopes=True), strict=True
            ):
                onto += more
        return np.stack(made, axis=-1).reshape(self._shape)

    def adjoint(self, image: NDArray[Any]) -> NDArray[Any]:
        """Return the transpose of :meth:`forward`: the gradient by depth of ``sum(image * photograph)``.

        Parameters
        ----------
        image : ndarray of float
            Of the shape of the photograph.

        Returns
        -------
        ndarray, shape (height, width)
            For each metre, of the type of the sums.

        Raises
        ------
        TypeError, ValueError
            As :meth:`lommel.imaging.DepthBlur.adjoint`.
        """
        given = list(self._blur.planes(image))
        taken = [
            next(self._blur.collect(channel, plane, [self._points(channel)], slopes=True))
            for channel, plane in enumerate(given)
        ]
        if (beyond := self._blur.beyond) is not None:
            for onto, more in zip(
                taken, beyond.collect(self._blur, range(len(given)), given, slopes=True), strict=True
            ):
                onto += more
        total = np.zeros(self.shape, dtype=self._blur.dtype)
        for channel, plane in enumerate(self._planes):
            total += taken[channel] * plane * self._steps(channel, self._per_metre)
        return total

    def focus(self) -> NDArray[Any]:
        """Return the derivative of the photograph by the distance of the sensor from the lens.

        The aperture keeps its diameter. That by the distance in focus is ``-(d / s)**2`` of it, d being
        ``lens.sensor_distance`` and s ``lens.focus_distance``.

        Returns
        -------
        ndarray
            Light for each metre, of the shape of the image and of the type of the sums.

        Raises
        ------
        ValueError
            If the blur has the whole PSF, ``energy=1``.
        """
        blur = self._blur
        if blur.beyond is not None:
            raise ValueError("energy must be below 1 for the derivative by focus, such as 0.9999, got 1")
        moved = copy.copy(blur)
        known: dict[int, Bank] = {}
        for bank, spectrum in zip(blur.banks, blur.spectra, strict=True):
            if id(bank) not in known:
                known[id(bank)] = _by_sensor(blur, bank, spectrum)
        moved.banks = tuple(known[id(bank)] for bank in blur.banks)
        made = [moved.spread(channel, [(plane, self._points(channel))]) for channel, plane in enumerate(self._planes)]
        return np.stack(made, axis=-1).reshape(self._shape) / blur.lens.sensor_distance

    def as_linear_operator(self) -> LinearOperator:
        """Return the operator as SciPy's solvers want it, from depths in metres to photographs, as vectors.

        Returns
        -------
        scipy.sparse.linalg.LinearOperator
            Of the shape (values of the image, points), of the type of the sums.
        """
        from scipy.sparse.linalg import LinearOperator

        shape = math.prod(self._shape), math.prod(self.shape)
        return LinearOperator(
            shape,
            matvec=lambda vector: self.forward(np.reshape(vector, self.shape)).reshape(-1),
            rmatvec=lambda vector: self.adjoint(np.reshape(vector, self._shape)).reshape(-1),
            dtype=self._blur.dtype,
        )

    def _points(self, channel: int) -> Points:
        return Points(self._blur.positions(channel))

    def _steps(self, channel: int, radians: NDArray[np.float64]) -> NDArray[Any]:
        """Return changes of C_d as those of positions in a bank, of the type of the sums."""
        return (radians / self._blur.banks[channel].spacing).astype(self._blur.dtype)


def _by_sensor(blur: DepthBlur, bank: Bank, spectrum: tuple[tuple[float, float], ...]) -> Bank:
    """Return a bank of the derivatives of windows by ln d, of points that stay where they are while the sensor moves.

    By differences of windows as they are cut and divided, which are smooth in d but for bends of the cuts.
    """
    lens, infinite = blur.lens, float(blur.lens.defocus(math.inf))
    defocus = bank.start + bank.spacing * np.arange(bank.count, dtype=np.float64)
    rate = (float(lens.defocus(1.0)) - infinite) / lens.sensor_distance
    step = min(_STEP_OF_SCALE, _STEP_OF_DEFOCUS / rate)
    made = []
    for steps, weight in _DIFFERENCES:
        there = replace(lens, sensor_distance=lens.sensor_distance * (1.0 + steps * step))
        light = SensorLight.of(there, spectrum, blur.pixel, blur.threads)
        pupils = light.defocused(defocus + (float(there.defocus(math.inf)) - infinite))
        octants = light.shares(pupils, bank.half + 2)
        quarter = cut(octants, find_cuts(octants, bank.half + 2, blur.energy))
        made.append(weight / step * quarter / sums_of_quarters(quarter)[:, None, None])
    widest = max(quarter.shape[1] for quarter in made)
    sums = sum(np.pad(quarter, ((0, 0), *[(0, widest - quarter.shape[1])] * 2)) for quarter in made)
    whole, ones = np.full(bank.count, widest - 1.0), np.ones(bank.count)
    return replace(bank, windows=stored_windows(np.asarray(sums), blur.dtype), cuts=whole, energies=ones)
