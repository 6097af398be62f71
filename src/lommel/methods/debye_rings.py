"""Stacks of a microscope with a measured wavefront on top: fields on circles, by orders of the azimuth."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.core.answers import Images, Intensities, Wanted, not_met
from lommel.methods.averaging import averaged_images
from lommel.methods.method import Method, painted
from lommel.optics import azimuths, debye
from lommel.optics.grid import Grid
from lommel.optics.objective_pupil import ObjectivePupil
from lommel.special import equal_steps
from lommel.special.bessel import bessel_sequence

_BAND = 1.2  # radians a step, of what is interpolated
_VALUES = 2**21  # on circles, of one field, at once
_LEAST = 1e-15
_ROUNDING = 2.0**-53


class Circles(NamedTuple):
    """Intensities at equal angles of circles of radii 0, h, 2 h, ..., over what is collected.

    Attributes
    ----------
    values : ndarray, shape (angles, circles, planes)
    error : ndarray, shape (planes,)
        Bound on their error.
    most : int
        The largest order of the azimuth.
    """

    values: Array
    error: Array
    most: int


@dataclass(frozen=True)
class DebyeRings(Method):
    r"""Quadrature over the angles of the light of an objective with a measured wavefront, for any emitter.

    Supports the pupils of :meth:`lommel.Objective.pupil` with `aberrations` only.

    Parameters
    ----------
    tol : float, default 1e-6
        Tolerance over the peak of each plane.

    Raises
    ------
    TypeError, ValueError
        If `tol` is out of range.

    Notes
    -----
    ``exp(i W) = sum_m P_m(rho) exp(i m theta)``, so that each field of a plane is

    .. math:: U(v, \phi) = \sum_m (-i)^{|m + q|} e^{i (m + q) \phi}
       \int P_m(\rho) T(\rho) e^{i \psi} J_{|m + q|}(v \rho) \rho \, d\rho

    with as many orders and nodes as are proven to suffice. A Fourier transform makes these fields at equal angles of
    equally spaced circles, and the intensity there is interpolated, with a proven error too, to the pixels.

    References
    ----------
    J. J. M. Braat, P. Dirksen, A. J. E. M. Janssen and A. S. van de Nes, J. Opt. Soc. Am. A 20, 2281 (2003): fields by
    orders of the azimuth.
    """

    layered: ClassVar[bool | None] = True
    apodized: ClassVar[bool] = True
    nonradial: ClassVar[bool] = True
    aberrated: ClassVar[bool] = True
    tol: float = 1e-6

    def __post_init__(self) -> None:
        object.__setattr__(self, "tol", validation.real("tol", self.tol, least=self.least_tol, below=1e-1))

    def intensity(self, pupil: ObjectivePupil, grid: Grid, threads: int = 0) -> Intensities:
        """Return I on the pixels of `grid`."""
        if grid.integrate:
            made = self.images(pupil, grid, Wanted(threads=threads))
            return Intensities(made.values, made.error, made.peak)
        if not grid.stack:
            return self._sampled(pupil, grid, self.tol)
        alone = [self._sampled(pupil[k], grid[k], self.tol) for k in np.ndindex(pupil.shape)]
        values, error, peak = (np.concatenate(part) for part in zip(*alone, strict=True))
        return Intensities(values, error, peak)

    def images(self, pupil: ObjectivePupil, grid: Grid, wanted: Wanted) -> Images:
        """Return the images of the flattened stack; see :meth:`Method.images`."""
        if wanted.powers or wanted.terms:
            raise ValueError(
                "derivatives are not available of the pupils of an Objective with aberrations; take differences of "
                "PSFs with a small tol"
            )
        if not grid.integrate:
            return super().images(pupil, grid, wanted)
        return averaged_images(self._samples, pupil, grid, self.tol, wanted)

    def _samples(self, pupil: ObjectivePupil, grid: Grid, tol: float, wanted: Wanted) -> Images:
        made = self._sampled(pupil, grid, max(tol, _LEAST))
        return painted(made, grid, wanted)._replace(peak=made.peak)

    def _sampled(self, pupil: ObjectivePupil, grid: Grid, tol: float) -> Intensities:
        """Return I at the centres of pixels around one axis, exact enough for the peak that is found."""
        share = 0.01
        while True:
            values, error, top = _window(pupil, grid, share * tol)
            least = top - error
            relative = np.divide(error, least, out=np.full(top.shape, np.inf), where=least > 0.0)
            if (worst := float(relative.max(initial=0.0))) <= tol:
                return Intensities(values, relative, least)
            if share * tol <= _LEAST:
                raise not_met(self.tol, worst, "the peak")
            share = max(_LEAST / tol, share * max(1e-4, min(0.5, 0.5 * tol / worst)))


def _window(pupil: ObjectivePupil, grid: Grid, error: float) -> tuple[Array, Array, Array]:
    """Return I at pixels, bounds on its error in each plane, and the largest value there, on circles or pixels."""
    x, y = np.broadcast_arrays(grid.x, grid.y[:, None])
    step = grid.step(pupil) / grid.pixel
    v, azimuth = np.hypot(x, y).ravel() * step, np.arctan2(y, x).ravel()
    along = equal_steps.steps(_BAND, error)
    values = np.empty((*grid.shape, pupil.focus.size))
    bounds, tops = np.empty(pupil.focus.size), np.empty(pupil.focus.size)
    for part, circles in on_circles(pupil, float(v.max()), along.taps, error):
        angles, count, planes = circles.values.shape
        around = equal_steps.steps(2.0 * math.pi * max(circles.most, 1) / angles, error)
        matrix = _interpolation(v, azimuth, (angles, count), along, around)
        made = matrix @ circles.values.reshape(angles * count, planes)
        values[..., part] = np.maximum(made, 0.0).reshape(*grid.shape, planes)
        tops[part] = circles.values.max(axis=(0, 1))
        # Of a circle's orders, by Cauchy's inequality.
        rms = np.sqrt(np.mean(circles.values**2, axis=0)).max(axis=0)
        orders = math.sqrt(2 * circles.most + 1) * rms
        gain = along.gain * around.gain
        rounding = (matrix.nnz // v.size + 16) * _ROUNDING * gain * tops[part]
        bounds[part] = along.error + along.gain * around.error * orders + gain * circles.error + rounding
    return np.ascontiguousarray(np.moveaxis(values, -1, 0)), bounds, tops


def on_circles(pupil: ObjectivePupil, far: float, margin: int, error: float) -> Iterator[tuple[slice, Circles]]:
    """Yield parts of a flattened stack on circles `_BAND` / 2 apart in v, `margin` / 2 of them beyond `far`.

    Fields err by about `error`.
    """
    assert pupil.aberrations is not None
    light, depth, focus = pupil.light, pupil.depth.ravel(), pupil.focus.ravel()
    count = math.ceil(2.0 * far / _BAND) + margin // 2 + 1
    terms = azimuths.sizes(pupil.aberrations)
    kept = azimuths.orders(terms, 0.1 * error)
    v = 0.5 * _BAND * np.arange(count)
    asked = pupil.layers, light.model, depth, focus, float(v[-1]), error
    rule = debye.rule(*asked, lambda piece: azimuths.growth(piece, terms))
    measured = azimuths.components(pupil.aberrations, rule.rho, kept)
    mixed = _mixed(light.waves.form)
    reach = max(map(abs, light.waves.orders))
    most = kept.most + reach
    table = _bessel(rule.rho.tobytes(), count, most + 1)
    # Twice the orders of a field are those of the intensity.
    angles = _even(math.ceil(2.0 * math.pi * 2 * max(most, 1) / _BAND))
    size = max(float(np.abs(part).sum()) for part in rule.parts)
    off = rule.error + (kept.error + 64.0 * math.sqrt(angles) * _ROUNDING) * size
    each = max(1, _VALUES // (angles * count))
    for first in range(0, depth.size, each):
        part = slice(first, min(first + each, depth.size))
        waves = rule.waves(depth[part], focus[part])
        across = measured[part] if len(measured) > 1 else measured
        total = np.zeros((angles, count, len(waves)))
        bound = np.zeros(len(waves))
        for row in mixed:
            field = np.zeros((angles, count, len(waves)), np.complex128)
            for n in range(most + 1):
                _put(field, n, table[n], _sources(light, row, waves, rule.parts, across, n))
            values = np.fft.ifft(field, axis=0, norm="forward")
            light_of = values.real**2 + values.imag**2
            total += light_of
            much = off * float(np.abs(row).sum())
            bound += much * (2.0 * np.sqrt(light_of.max(axis=(0, 1))) + much)
        power = pupil.power[part]
        yield part, Circles(total / power, bound / power, 2 * most)


def _mixed(form: NDArray[np.complex128]) -> Array:
    """Return rows T with ``sum_ab form[a, b] U_a conj(U_b) = sum_c abs(sum_a T[c, a] U_a)^2``."""
    if not np.any(form - np.diag(np.diag(form))):
        rows = np.diag(np.sqrt(np.diag(form).astype(np.complex128)))
    else:
        shares, vectors = np.linalg.eigh(form)
        rows = np.sqrt(np.maximum(shares, 0.0))[:, None] * vectors.T
    return np.asarray(rows[np.abs(rows).max(axis=1) > 1e-14])


def _sources(light: Any, row: Any, waves: Any, parts: Any, across: Any, n: int) -> list[Any]:
    """Return what J_n is integrated with, shape (planes, nodes), for exp(i n phi) and then for exp(-i n phi)."""
    middle = across.shape[1] // 2
    found = []
    for order in (n, -n) if n else (0,):
        total: Any = 0.0
        for share, q, j in zip(row, light.waves.orders, light.waves.parts, strict=True):
            if share and abs(order - q) <= middle:
                total = total + share * parts[j] * across[:, middle + order - q]
        found.append(waves * total)
    return found


def _put(field: NDArray[np.complex128], n: int, table: Array, sources: list[Any]) -> None:
    """Add integrals with J_n, shape (circles, nodes), to the orders of a field."""
    rows = np.concatenate([part for source in sources for part in (source.real, source.imag)])
    found = table @ rows.T
    planes = field.shape[2]
    turned = (-1j) ** n
    for k, order in enumerate((n, -n)[: len(sources)]):
        start = 2 * k * planes
        field[order] += turned * (found[:, start : start + planes] + 1j * found[:, start + planes :][:, :planes])


@lru_cache(maxsize=2)
def _bessel(rho: bytes, count: int, orders: int) -> Array:
    """Return J_n at the product of the radii of circles and of rho, shape (orders, circles, nodes)."""
    arguments = np.multiply.outer(0.5 * _BAND * np.arange(count), np.frombuffer(rho))
    found = bessel_sequence(arguments.ravel(), orders).reshape(*arguments.shape, orders)
    return np.ascontiguousarray(np.moveaxis(found, -1, 0))


def _interpolation(
    v: Array, azimuth: Array, shape: tuple[int, int], along: equal_steps.Steps, around: equal_steps.Steps
) -> Any:
    """Return the sparse matrix from values on circles, (angles, circles), to those at polar coordinates."""
    from scipy.sparse import csr_array

    angles, count = shape
    ring, angle = v / (0.5 * _BAND), np.mod(azimuth * (angles / (2.0 * math.pi)), angles)
    first, start = np.floor(ring).astype(np.int64), np.floor(angle).astype(np.int64)
    rings = first[:, None] + np.arange(along.taps) - (along.taps // 2 - 1)
    spokes = start[:, None] + np.arange(around.taps) - (around.taps // 2 - 1)
    # A circle of negative radius is that of the positive one, half a turn on.
    turned = np.where(rings < 0, angles // 2, 0)
    column = np.mod(spokes[:, None, :] + turned[..., None], angles) * count + np.abs(rings)[..., None]
    weights = along.at(ring - first)[..., None] * around.at(angle - start)[:, None, :]
    each = along.taps * around.taps
    places = (weights.ravel(), column.ravel(), np.arange(0, v.size * each + 1, each))
    return csr_array(places, shape=(v.size, angles * count))


def _even(least: int) -> int:
    """Return an even number of which transforms are fast."""
    from scipy.fft import next_fast_len

    return 2 * int(next_fast_len((least + 1) // 2))
