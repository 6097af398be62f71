"""Stacks of a microscope with a measured wavefront on top: fields on circles, by orders of the azimuth."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.core.answers import Images, Intensities, Wanted, not_met
from lommel.methods.averaging import averaged_images
from lommel.methods.layered import LEAST, LayeredMethod
from lommel.optics import azimuths, debye
from lommel.optics.grid import Grid
from lommel.optics.objective_pupil import ObjectivePupil
from lommel.special import equal_steps
from lommel.special.bessel import bessel_sequence

_BAND = 1.4  # radians a step, of what is interpolated
_VALUES = 2**21  # on circles, of one field, at once
_KEPT = 2**25  # on circles of all planes that are interpolated at once
_WEIGHTS = 2**24  # of pixels, at once
_FINER = 4  # times the angles that tell the orders of the intensity, of which it is interpolated
_FINEST = 2e-13  # of weights
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
class DebyeRings(LayeredMethod):
    r"""Quadrature over the angles of the light of an objective with a measured wavefront, for any emitter.

    Supports the pupils of :meth:`lommel.Objective.pupil` with `aberrations` only.

    Parameters
    ----------
    tol : float, default 1e-6
        Tolerance over the peak of each plane, 1e-12 to 1e-1. Below 1e-10 or so rounding keeps it from being met,
        which :class:`ToleranceError` says.

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
    J. J. M. Braat, P. Dirksen, A. J. E. M. Janssen and A. S. van de Nes, J. Opt. Soc. Am. A 20, 2281 (2003):
    fields by orders of the azimuth.
    """

    tol: float = 1e-6

    def unsupported(self, pupil: ObjectivePupil) -> str | None:
        """Return why `pupil` is not supported, or None if it is."""
        return None if pupil.aberrated else "supports aberrations only; without these use Stratified or DebyeWolf"

    def intensity(self, pupil: ObjectivePupil, grid: Grid, threads: int = 0) -> Intensities:
        """Return I on the pixels of `grid`."""
        if grid.integrate:
            made = self.images(pupil, grid, Wanted(threads=threads))
            return Intensities(made.values, made.error, made.peak)
        return self._centres(pupil, grid, self.tol)

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

    def _sampled(self, pupil: ObjectivePupil, grid: Grid, tol: float) -> Intensities:
        """Return I at the centres of pixels around one axis, exact enough for the peaks that are found."""
        x, y = np.broadcast_arrays(grid.x, grid.y[:, None])
        step = grid.step(pupil) / grid.side
        v, azimuth = np.hypot(x, y).ravel() * step, np.arctan2(y, x).ravel()
        count = math.ceil(2.0 * float(v.max()) / _BAND) + equal_steps.TAPS_MOST // 2 + 1
        values = np.empty((pupil.focus.size, v.size))
        relative, least = np.empty(pupil.focus.size), np.empty(pupil.focus.size)
        fields, first = 2e-5 * tol, 0
        while first < pupil.focus.size:
            circles = on_circles(pupil, first, count, fields)
            part = slice(first, first + circles.error.size)
            tops = circles.values.max(axis=(0, 1))
            worst = float((circles.error / tops).max())
            if worst > 0.03 * tol and fields > LEAST:
                fields = max(LEAST, fields * max(1e-4, min(0.5, 0.02 * tol / worst)))
                continue
            values[part], error = _between(circles, v, azimuth, 0.1 * tol * float(tops.min()))
            least[part] = tops - circles.error
            relative[part] = np.divide(error, least[part], out=np.full(tops.shape, np.inf), where=least[part] > 0.0)
            if (worst := float(relative[part].max())) > tol:
                raise not_met(self.tol, worst, "the peak")
            first = part.stop
        return Intensities(values.reshape(-1, *grid.shape), relative, least)


def _between(circles: Circles, v: Array, azimuth: Array, error: float) -> tuple[Array, Array]:
    """Return I at polar coordinates, shape (planes, places), and a bound on its error in each plane."""
    angles, count, planes = circles.values.shape
    # The moduli of the orders of a circle, by Cauchy's inequality.
    squares = np.einsum("acp,acp->cp", circles.values, circles.values) / angles
    orders = math.sqrt(2 * circles.most + 1) * np.sqrt(squares.max(axis=0))
    along = equal_steps.steps(_BAND, max(error, _FINEST))
    band = 2.0 * math.pi * circles.most / angles
    around = equal_steps.steps(band, max(error / (3.0 * float(orders.max())), _FINEST))
    values = np.empty((planes, v.size))
    each = max(1, _WEIGHTS // (along.taps * around.taps))
    flat = circles.values.reshape(angles * count, planes)
    for start in range(0, v.size, each):
        some = slice(start, start + each)
        made = _interpolation(v[some], azimuth[some], (angles, count), along, around) @ flat
        np.maximum(made.T, 0.0, out=values[:, some])
    gain = along.gain * around.gain
    rounding = (along.taps * around.taps + 64) * _ROUNDING * gain * circles.values.max(axis=(0, 1))
    return values, along.error + along.gain * around.error * orders + gain * circles.error + rounding


def on_circles(pupil: ObjectivePupil, first: int, count: int, error: float) -> Circles:
    """Return I on so many circles `_BAND` / 2 apart in v, by fields that err by about `error`.

    Of planes of the flattened stack from the `first` on, as many as are kept at once.
    """
    from scipy.fft import ifft, irfft, next_fast_len, rfft

    assert pupil.aberrations is not None
    light, terms = pupil.light, azimuths.sizes(pupil.aberrations)
    kept = azimuths.orders(terms, 0.1 * error)
    most = max(1, kept.most + max(map(abs, light.waves.orders)))
    # The orders of the intensity are twice those of a field, and so many angles tell each from all others.
    angles = 2 * next_fast_len(2 * most + 1)
    part = slice(first, first + max(1, _KEPT // (_FINER * angles * count)))
    depth, focus, power = pupil.depth.ravel()[part], pupil.focus.ravel()[part], pupil.power[part]
    asked = pupil.layers, light.model, depth, focus, 0.5 * _BAND * (count - 1), error
    rule = debye.rule(*asked, lambda piece: azimuths.growth(piece, terms))
    wavefront = pupil.aberrations.flattened()
    across = azimuths.components(wavefront[part] if wavefront.shape[0] > 1 else wavefront, rule.rho, kept)
    table = _bessel(rule.rho.tobytes(), count, most + 1)
    size = max(float(np.abs(each).sum()) for each in rule.parts)
    off = rule.error + (kept.error + 64.0 * math.sqrt(angles) * _ROUNDING) * size
    total, bound = np.empty((_FINER * angles, count, depth.size)), np.zeros(depth.size)
    each = max(1, _VALUES // (angles * count))
    for some in (slice(k, min(k + each, depth.size)) for k in range(0, depth.size, each)):
        waves = rule.waves(depth[some], focus[some])
        components = across[some] if len(across) > 1 else across
        summed = np.zeros((angles, count, len(waves)))
        for row in _mixed(light.waves.form):
            field = np.zeros(summed.shape, np.complex128)
            for n in range(most + 1):
                _put(field, n, table[n], _sources(light, row, waves, rule.parts, components, n))
            field = ifft(field, axis=0, norm="forward", overwrite_x=True)
            squared = field.real**2 + field.imag**2
            summed += squared
            much = off * float(np.abs(row).sum())
            bound[some] += much * (2.0 * np.sqrt(squared.max(axis=(0, 1))) + much)
        summed /= power[some]
        orders = rfft(summed, axis=0, norm="forward", overwrite_x=True)
        total[..., some] = irfft(orders, _FINER * angles, axis=0, norm="forward", overwrite_x=True)
    return Circles(total, bound / power, 2 * most)


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
    """Write integrals with J_n, shape (circles, nodes), as orders of a field."""
    rows = np.concatenate([part for source in sources for part in (source.real, source.imag)])
    found = table @ rows.T
    planes = field.shape[2]
    turned = (-1j) ** n
    for k, order in enumerate((n, -n)[: len(sources)]):
        start = 2 * k * planes
        field[order] = turned * (found[:, start : start + planes] + 1j * found[:, start + planes :][:, :planes])


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
    first, start = np.floor(ring).astype(np.int32), np.floor(angle).astype(np.int32)
    rings = first[:, None] + np.arange(1 - along.taps // 2, along.taps // 2 + 1, dtype=np.int32)
    spokes = start[:, None] + np.arange(1 - around.taps // 2, around.taps // 2 + 1, dtype=np.int32)
    column = rings[:, :, None] + (np.mod(spokes, angles) * count)[:, None, :]
    # A circle of negative radius is that of the positive one, half a turn on.
    near = np.flatnonzero(rings[:, 0] < 0)
    turned = np.where(rings[near] < 0, angles // 2, 0)[:, :, None]
    column[near] = np.mod(spokes[near, None, :] + turned, angles) * count + np.abs(rings[near])[:, :, None]
    weights = along.at(ring - first)[:, :, None] * around.at(angle - start)[:, None, :]
    each = along.taps * around.taps
    places = (weights.ravel(), column.ravel(), np.arange(0, v.size * each + 1, each, dtype=np.int32))
    return csr_array(places, shape=(v.size, angles * count))
