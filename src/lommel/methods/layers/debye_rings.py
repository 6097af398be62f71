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
from lommel.core.engine import Window, fft_length, ringed_images
from lommel.core.layers import Rings
from lommel.methods.layers.refinement import LEAST, LayeredMethod, likely_peak
from lommel.methods.method import normalized_error, stored, storing
from lommel.methods.pixels.averaging import averaged_images
from lommel.optics.grid import Grid
from lommel.optics.layers import azimuthal_orders, debye
from lommel.optics.layers.emitter import Waves
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.layers.quadrature_bounds import Piece
from lommel.special import interpolation
from lommel.special.bessel import bessel_sequence

_BANDS = (
    (1.6, 5e-12),
    (1.1, 5e-13),
)  # radians a step of circles, of what is interpolated, and what may be lost at least
_AROUND = 1e-12  # the least that interpolation around circles is asked for
_PARTS = 2**22  # of pupils with a wavefront each, at once
_ROUNDING = 2.0**-53


class Accuracy(NamedTuple):
    """What fields may err by, what interpolation between circles may add to I, and around them relative to it."""

    field: float
    between: float
    around: float


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
    equally spaced circles, and the intensity there is interpolated, with a proven error too, to the pixels; see
    docs/certificate.md, section 16. Bessel functions of circles and nodes are kept for stacks of the same objective,
    wavelength, emitter and window.

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
        return self.images(pupil, grid, Wanted(threads=threads)).intensities

    def images(self, pupil: ObjectivePupil, grid: Grid, wanted: Wanted) -> Images:
        """Return the images of the flattened stack; see :meth:`Method.images`."""
        if wanted.powers or wanted.terms:
            raise ValueError("derivatives by phases are not available of the pupils of an Objective")
        if grid.integrate:
            return averaged_images(self._samples, pupil, grid, self.tol, wanted)
        return self._samples(pupil, grid, self.tol, wanted)

    def _samples(self, pupil: ObjectivePupil, grid: Grid, tol: float, wanted: Wanted) -> Images:
        return self.settled(pupil, grid, tol, wanted)[0]

    def settled(self, pupil: ObjectivePupil, grid: Grid, tol: float, wanted: Wanted) -> tuple[Images, Accuracy]:
        """Return I of a `pupil` at the centres of the pixels of `grid`, as `wanted`, and what that took.

        ToleranceError where rounding keeps `tol` from being met.
        """
        peak = likely_peak(pupil) / 4.0
        # What is divided by its own largest value is off by twice as much, and stored twice.
        twice = 2.0 if wanted.scale is None else 1.0
        aim = max(tol, LEAST) / twice - 2.0 * storing(wanted.dtype)
        while True:
            accuracy = Accuracy(*(_power_of_two(x) for x in (aim * math.sqrt(peak) / 8.0, aim * peak, aim / 100.0)))
            made = ringed(pupil, grid, accuracy, wanted)
            assert made.error is not None
            if (worst := float(made.error.max())) <= tol:
                return made, accuracy
            if accuracy.field <= LEAST:
                raise not_met(self.tol, worst, "the peak")
            peak, aim = peak * 0.25, aim * max(1e-6, min(0.5, 0.5 * tol / worst))


def _power_of_two(x: float) -> float:
    """Return the next lower one, so that taps and angles serve others too."""
    return float(2.0 ** math.floor(math.log2(x)))


class Turn(NamedTuple):
    """A factor of waves, ``(1 + amount (rate - middle)) / 2``, at most 1 for real rho."""

    which: int  # 1 for the rate of the phase by depth, 2 for that by focus
    amount: complex
    middle: float

    def of(self, rates: tuple[NDArray[np.complex128], ...]) -> NDArray[np.complex128]:
        """Return the factor at each angle."""
        return np.asarray(0.5 * (1.0 + self.amount * (rates[self.which] - self.middle)))

    def growth(self, piece: Piece) -> Array:
        """Return the logarithm of a bound on it, on each disc around a piece."""
        away = (piece.covered.rates[self.which] - self.middle).largest
        return np.asarray(np.log(0.5 * (1.0 + abs(self.amount) * away)))


def ringed(pupil: ObjectivePupil, grid: Grid, accuracy: Accuracy, wanted: Wanted, turn: Turn | None = None) -> Images:
    """Return images of fields and intensities so exact, with bounds that are to be compared with a tolerance.

    Waves have a further factor where there is a `turn`.
    """
    step, light = grid.step(pupil), pupil.light
    band, along = _along(accuracy.between)
    circles = math.ceil(grid._farthest * step / (0.5 * band)) + along.taps.size // 2 + along.filter.size + 2
    depth, focus = pupil.depth.ravel(), pupil.focus.ravel()
    assert pupil.aberrations is not None
    wavefront = pupil.aberrations.flattened()
    terms = azimuthal_orders.sizes(wavefront)
    asked = pupil.layers, light.model, depth, focus, 0.5 * band * (circles - 1), accuracy.field
    if turn is None:
        rule = debye.rule(*asked, lambda piece: azimuthal_orders.growth(piece, terms))
    else:
        rule = debye.rule(*asked, lambda piece: azimuthal_orders.growth(piece, terms) + turn.growth(piece))
    turned: Any = 1.0 if turn is None else turn.of(rule.rates)
    rows = _mixed(light.waves.form)
    values = np.empty((depth.size, *grid.shape), wanted.dtype) if wanted.out is None else wanted.out
    scales = np.ones(depth.size) if wanted.scale is None else np.broadcast_to(wanted.scale, depth.size)
    centers = np.stack(np.broadcast_arrays(*grid.center), axis=-1).reshape(-1, 2)
    errors, peaks, tops = np.empty((3, depth.size))
    many = wavefront.shape[0] > 1
    each = max(8, _PARTS // (len(rows) * rule.rho.size * 100) // 8 * 8) if many else depth.size
    for part in (slice(k, min(k + each, depth.size)) for k in range(0, depth.size, each)):
        across, left = azimuthal_orders.components(
            wavefront[part] if many else wavefront, terms, rule, 0.1 * accuracy.field
        )
        shift = max(map(abs, light.waves.orders))
        most = across.shape[1] // 2 + shift
        # The orders of the intensity are twice those of a field, and so many angles tell each from all others.
        angles = fft_length(4 * most + 1)
        around = interpolation.orders(2 * most, 2 * angles, max(accuracy.around, _AROUND))
        sums = Rings(
            _bessel(rule.rho.tobytes(), 0.5 * band, circles, most + 1),
            _parts(light.waves, rows, rule.parts, across, shift),
            np.ascontiguousarray(rule.waves(depth[part], focus[part]) * turned),
            pupil.power[part],
            angles,
            along.filter,
            along.taps.polynomials,
            around.taps.polynomials,
            (along.taps.size, around.taps.size),
            np.stack([around.gains, around.errors]),
        )
        window = Window(grid.shape, centers[part] if len(centers) > 1 else centers, step / (0.5 * band))
        found = ringed_images(sums, window, scales[part], wanted.threads, values[part])
        size = max(float(np.abs(each).sum()) for each in rule.parts)
        off = rule.error + left + 64.0 * math.sqrt(angles) * _ROUNDING * size
        # Between so many angles a field is at most that much larger (Ehlich and Zeller).
        largest = np.sqrt(found.squares) / math.cos(math.pi * most / angles)
        much = off * np.abs(rows).sum(axis=1)[:, None] / np.sqrt(pupil.power[part])
        wrong = (much * (2.0 * largest + much)).sum(axis=0)
        sizes = found.sums + float(np.abs(along.filter).sum()) * found.top
        units = 64.0 * math.sqrt(2 * angles) + 2 * along.filter.size + 64
        errors[part] = (
            along.error
            + along.gain * wrong
            + along.taps.gain * (found.aliases + units * _ROUNDING * around.taps.gain * sizes)
        )
        peaks[part] = np.maximum(found.top - wrong, found.pixel - errors[part])
        tops[part] = found.pixel
    relative = np.divide(errors, peaks, out=np.full(peaks.shape, np.inf), where=peaks > 0.0)
    if wanted.scale is None:
        if not np.all(tops > 0.0):
            raise ValueError('normalize="peak" is impossible: no light falls into the window')
        scales = 1.0 / tops
        np.multiply(values, scales[:, None, None], out=values, casting="same_kind")
        relative = stored(normalized_error(relative), wanted.dtype)
    return Images(values, scales, stored(relative, wanted.dtype), None, peaks)


@lru_cache(maxsize=64)
def _along(error: float) -> tuple[float, interpolation.Steps]:
    band, least = next((way for way in _BANDS if error >= way[1]), _BANDS[-1])
    return band, interpolation.steps(band, max(error, least))


def _mixed(form: NDArray[np.complex128]) -> Array:
    """Return rows T with ``sum_ab form[a, b] U_a conj(U_b) = sum_c abs(sum_a T[c, a] U_a)^2``."""
    if not np.any(form - np.diag(np.diag(form))):
        rows = np.diag(np.sqrt(np.diag(form).astype(np.complex128)))
    else:
        shares, vectors = np.linalg.eigh(form)
        rows = np.sqrt(np.maximum(shares, 0.0))[:, None] * vectors.T
    return np.asarray(rows[np.abs(rows).max(axis=1) > 1e-14])


def _parts(waves: Waves, rows: Any, parts: Any, across: Any, shift: int) -> NDArray[np.complex128]:
    """Return what orders of fields are integrals of, shape (wavefronts, orders, fields, nodes)."""
    made = np.zeros((len(across), across.shape[1] + 2 * shift, len(rows), across.shape[2]), np.complex128)
    for c, row in enumerate(rows):
        for share, q, j in zip(row, waves.orders, waves.parts, strict=True):
            if share:
                made[:, shift + q : shift + q + across.shape[1], c] += share * parts[j] * across
    turns = (-1j) ** np.abs(np.arange(made.shape[1]) - made.shape[1] // 2)
    made *= turns[:, None, None]
    return made


@lru_cache(maxsize=2)
def _bessel(rho: bytes, apart: float, count: int, orders: int) -> Array:
    """Return J_n at the product of the radii of circles and of rho, shape (orders, circles, nodes)."""
    arguments = np.multiply.outer(apart * np.arange(count), np.frombuffer(rho))
    found = bessel_sequence(arguments.ravel(), orders).reshape(*arguments.shape, orders)
    return np.ascontiguousarray(np.moveaxis(found, -1, 0))
