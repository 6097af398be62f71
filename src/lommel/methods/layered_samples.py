r"""Derivatives of microscopes' light that depends on the azimuth: of samples, and of averages made of these.

Fixed dipoles and beams have the engine of :mod:`lommel.methods.stratified`. With a measured wavefront fields E are
sums over circles (:mod:`lommel.methods.debye_rings`); with waves times ``(1 +- i s dpsi/dx) / 2`` these are
``(E +- s G) / 2``, G being the derivative of E, and the difference of their intensities is ``s Re(E conj G)``, half
of s times the derivative of ``abs(E)^2``: no difference quotient, whatever s is.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.core.answers import Images, Slopes, Wanted
from lommel.methods.averaging import Sample, averaged_images
from lommel.methods.debye_rings import DebyeRings, Turn, ringed
from lommel.methods.method import Method, storing, widened
from lommel.methods.stratified import By, Stratified, differentiated
from lommel.optics import debye_slopes
from lommel.optics.grid import Grid
from lommel.optics.objective_pupil import ObjectivePupil

Rates = Callable[[ObjectivePupil], Sequence[By]]
"""From planes to the derivatives that are wanted of these."""


class Sampled(NamedTuple):
    """Images, with derivatives as these are stored.

    Attributes
    ----------
    images : Images
    values : ndarray, shape (k, n, height, width)
    error : ndarray, shape (k, n)
        Bounds over the peak of the images.
    """

    images: Images
    values: NDArray[Any]
    error: Array


def sampled_slopes(method: Method, pupil: ObjectivePupil, grid: Grid, rates: Rates, wanted: Wanted) -> Sampled:
    """Return images by DebyeRings or Stratified and their derivatives.

    Parameters
    ----------
    method : Stratified or DebyeRings
    pupil, grid
    rates : callable
    wanted : Wanted
        With a scale.

    Returns
    -------
    Sampled

    Raises
    ------
    ValueError
        If Stratified has no such windows.
    ToleranceError
        If the tolerance cannot be met.
    """
    by = rates(pupil)
    most = debye_slopes.steepest(pupil.layers, pupil.light.model, pupil.depth.ravel(), pupil.focus.ravel())
    # What derivatives are divided by, so that their transfer functions are at most twice that of the aperture.
    sizes = [abs(one.factor) * most[min(one.which, 2)] + 0.5 * float(np.abs(one.own).max(initial=0.0)) for one in by]
    sample = _by_circles(method, rates, sizes, most) if isinstance(method, DebyeRings) else _by_engine(rates, sizes)
    question = wanted._replace(terms=((0, 0),) * len(by))  # as many
    make = averaged_images if grid.integrate else _at_centres
    made = widened(make(sample, pupil, grid, method.tol, question), pupil, method, normalized=False)
    assert made.slopes is not None
    count = np.array(sizes)
    for values, size in zip(made.slopes.values, sizes, strict=True):
        values *= size
    return Sampled(made._replace(slopes=None), made.slopes.values, count[:, None] * made.slopes.error)


def engine_slopes(
    pupil: ObjectivePupil,
    grid: Grid,
    by: Sequence[By],
    tol: float,
    wanted: Wanted,
    otherwise: Callable[[], Images] | None,
) -> Sampled | None:
    """Return images and derivatives by the engine, or None where it has no such windows.

    Derivatives have bounds and no tolerance: where rounding keeps the engine from that of the images, they come with
    a looser one, and images are those that `otherwise` returns, or of a looser one too.
    """
    for looser in (1.0, 10.0, 100.0, 1000.0):
        if (found := differentiated(pupil, grid, by, looser * tol, wanted)) is not None:
            images, values, wrong = found
            assert images.peak is not None
            error = wrong / images.peak
            return Sampled(images if looser == 1.0 or otherwise is None else otherwise(), values, error)
    return None


def _at_centres(sample: Sample, pupil: ObjectivePupil, grid: Grid, tol: float, wanted: Wanted) -> Images:
    return sample(pupil, grid, tol, wanted)


def _by_engine(rates: Rates, sizes: Sequence[float]) -> Sample:
    """Return samples by Stratified, with derivatives over `sizes`."""

    def sample(pupil: ObjectivePupil, grid: Grid, tol: float, wanted: Wanted) -> Images:
        by = [
            one._replace(factor=one.factor / size, own=np.asarray(one.own) / size)
            for one, size in zip(rates(pupil), sizes, strict=True)
        ]
        question, way = wanted._replace(terms=()), Stratified(max(tol, Stratified.least_tol))
        found = engine_slopes(pupil, grid, by, way.tol, question, lambda: way._samples(pupil, grid, tol, question))
        if found is None:
            raise ValueError(
                "derivatives of light that depends on the azimuth are in windows up to "
                f"{110.0 / grid.step(pupil):.0f} pixels from each axis; ask for a smaller shape, or a larger tol"
            )
        return found.images._replace(slopes=Slopes(found.values, found.error))

    return sample


def _by_circles(method: DebyeRings, rates: Rates, sizes: Sequence[float], most: tuple[float, float, float]) -> Sample:
    """Return samples by DebyeRings, with derivatives over `sizes`; `most` is what factors are at most."""

    def sample(pupil: ObjectivePupil, grid: Grid, tol: float, wanted: Wanted) -> Images:
        made, accuracy = method.settled(pupil, grid, tol, wanted._replace(terms=()))
        plain = Wanted(threads=wanted.threads)
        assert made.error is not None
        assert made.peak is not None
        values = np.empty((len(sizes), *made.values.shape), wanted.dtype)
        error = np.empty((len(sizes), len(made.values)))
        for k, (one, size) in enumerate(zip(rates(pupil), sizes, strict=True)):
            steep, middle = most[one.which], pupil.layers.middle_rates()[1 + one.which]
            up, down = (
                ringed(pupil, grid, accuracy, plain, Turn(one.which + 1, sign * 1j / steep, middle))
                for sign in (1.0, -1.0)
            )
            share = 2.0 * one.factor * steep / size
            own = np.broadcast_to(np.asarray(one.own) / size, made.scale.shape)
            slope = share * (up.values - down.values) * made.scale[:, None, None] + own[:, None, None] * made.values
            off = _absolute(up) + _absolute(down)
            largest = np.abs(slope).reshape(len(slope), -1).max(axis=1) / made.scale
            wrong = abs(share) * off + (storing(wanted.dtype) + 2.0**-48) * largest
            values[k], error[k] = slope, wrong / made.peak + np.abs(own) * (made.error + 1e-12)
        return made._replace(slopes=Slopes(values, error))

    return sample


def _absolute(made: Images) -> Array:
    """Return the bound on the error of I."""
    assert made.error is not None
    assert made.peak is not None
    return made.error * made.peak
