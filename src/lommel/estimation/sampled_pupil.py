r"""Images of an aperture of any shape from samples of its pupil: within about 1e-3 of the peak, not proven.

The field at row y and column x of the image is ``U = E_y P E_x``, two products of matrices (Soummer et al., Opt.
Express 15, 15935 (2007), doi:10.1364/OE.15.015935), P being the pupil function in square cells, each with the part of
it that is clear; derivatives by a Zernike term Z are those of ``i Z P``. A search, whose images need be no nearer to
the true ones than noise is, is an order of magnitude faster than by rules that are proven for vanes and segments.

Of large images the same sums are computed by FFT.

Where the pupil function changes, so does the field, by U', and the image by ``2 Re(U* U')``: light that is uneven is
an amplitude ``a P`` over the cells, an edge elsewhere the integral of P along it times the length by which it moves
outward. Within a few percent, not proven.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from scipy import fft

from lommel.base.arrays import Array, Values
from lommel.estimation.star_readout import products, unfolded
from lommel.methods.derivative_names import Term
from lommel.optics.aperture.mask import cell_centers
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil
from lommel.special import zernike

_LEAST, _STEP = 96, 16  # least samples across the aperture, and the number that they are a multiple of
SMALL = 160  # samples along a side up to which matrices are used
_FINE = 4  # parts of a cell along an axis, which determine its clear share
SLANT = "light that slopes across the pupil"
FOLDS = tuple(f"light of {n} folds in the pupil" for n in ("two", "three", "four"))
SHIFT, OBSCURATION, OVAL = "obscuration off the middle", "obscuration", "aperture that is not round"
ASPECT = "image that is longer along y than along x"
_FEWEST, _MOST = 48, 256  # least and most samples across for uneven light
_TURN = 0.6  # radians: largest change of the phase from cell to cell
_ANGLES = 4  # points along an edge for each cell across the aperture


class SampledPupil:
    """An aperture in cells, whose images are computed on a grid, and wavefront terms there."""

    def __init__(self, pupil: Pupil, grid: Grid, terms: Sequence[tuple[int, int]]) -> None:
        step = grid.step(pupil) / grid.side
        # Images repeat after as many lambda*N as there are samples: one of them fills the window.
        across = max(grid.shape) * grid.step(pupil) / math.pi
        side = max(_LEAST, _STEP * math.ceil(across / _STEP))
        width = 2.0 / side
        #: Length of Fourier transforms; 0 for products of matrices, which take less time where images are small.
        self._length = fft.next_fast_len(max(grid.shape)) if max(grid.shape) > SMALL else 0
        if self._length:
            width = 2.0 * math.pi / (self._length * grid.step(pupil))
            side = 2 * math.ceil(1.0 / width)
        at, fine = (0.5 * width * side * cell_centers(count) for count in (side, side * _FINE))
        parts = pupil.opening.coverage(fine[None, :], fine[:, None], 0.5 * width / _FINE)
        clear = _sums(parts)
        # Phases in the middle of a cell are off by as much as those in the middle of what is clear, the other way.
        share = np.maximum(clear, 1e-12)
        x, y = (
            np.where(clear > 0.0, 0.5 * (_sums(parts * across) / share + middle), middle)
            for across, middle in ((fine, at), (fine[:, None], at[:, None]))
        )
        rho, theta = np.hypot(x, y), np.arctan2(y, x)
        light = clear / _FINE**2 * pupil.illumination.at(np.minimum(rho, 1.0) ** 2) + 0.0j
        if pupil.segmented:
            light *= np.exp(1j * pupil.opening.phase(x, y))
        # The share of light in a pixel: its area in v over 4 pi times the transmission, as of lommel.psf.
        scale = math.sqrt(grid.cell(pupil) / (4.0 * math.pi * pupil.transmission))
        self._light = (light * (scale * width**2 / math.pi)).astype(np.complex64)
        self._terms = np.stack([zernike.polynomial(n, m, rho, theta) for n, m in terms]).astype(np.float32)
        half = at[side // 2 :]
        #: Cosines and sines of rows and columns at and beyond the axis, (places, cells).
        self._down, self._across = ([] if self._length else _waves(step * y, half) for y in (grid.y, grid.x))
        self._shape = grid.shape

    def images(self, edge: Array, by: Sequence[int], *, values: bool = True) -> list[Values]:
        """Return images (r, h, w) of wavefronts (r, first terms), if `values`, and derivatives by some terms."""
        found = np.empty((values + len(by), len(edge), *self._shape), np.float32)
        factors, terms = self._terms[list(by)], self._terms[: edge.shape[1]]
        if not len(found):
            return []
        for k, one in enumerate(edge.astype(np.float32)):
            phase = np.tensordot(one, terms, 1)
            planes = self._light * np.cos(phase), self._light * np.sin(phase)
            pupil = np.stack([planes[0].real - planes[1].imag, planes[0].imag + planes[1].real])[None]
            real, imaginary = self._fields(np.concatenate([pupil, factors[:, None] * pupil]))
            if values:
                found[0, k] = real[0] ** 2 + imaginary[0] ** 2
            # U' = i G, and I' = 2 Re(conj(U) U').
            found[int(values) :, k] = (2.0 * imaginary[0]) * real[1:] - (2.0 * real[0]) * imaginary[1:]
        return list(found)

    def _fields(self, planes: Values) -> tuple[Values, Values]:
        """Return the real and imaginary parts of the fields (n, h, w) of pupils of real parts (n, 2, y, x)."""
        if self._length:
            # Cells begin at the first sample of the transform: a phase that all fields have in common.
            size = self._length, self._length
            field = fft.fft2(planes[:, 0] + np.complex64(1j) * planes[:, 1], size)
            rows, columns = (np.arange(side) - side // 2 for side in self._shape)
            field = field[:, rows[:, None], columns]
            return field.real, field.imag
        (cc, sc), (cs, ss) = self._parts(planes)
        # Sines are times -i, which makes the real part the imaginary one.
        right, down = (np.stack([part[:, 1], -part[:, 0]], axis=1) for part in (cs, sc))
        parts = unfolded([[cc, right], [down, -ss]], self._shape)
        return parts[:, 0], parts[:, 1]

    def _parts(self, planes: Values) -> list[list[Values]]:
        """Return cosine and sine transforms (n, 2, h, w) along columns and rows of pupils of real parts (n, 2, y, x).

        Of sums and differences of cells on both sides of the axis: matrices are real, and half as large.
        """
        parts = [products(half, wave) for half, wave in zip(_halves(planes), self._across, strict=True)]
        turned = [_halves(part.swapaxes(-1, -2)) for part in parts]
        return [[products(wave, half) for wave, half in zip(self._down, halves, strict=True)] for halves in turned]


def _waves(places: Array, at: Array) -> list[Values]:
    """Return cosines and sines (places, cells) of the places from the axis on, of windows whose middle is there."""
    beyond = np.linspace(0.0, -places[0], len(places) // 2 + 1)
    angle = np.multiply.outer(beyond, at)
    return [np.cos(angle).astype(np.float32), np.sin(angle).astype(np.float32)]


def _halves(planes: Values) -> tuple[Values, Values]:
    """Return sums and differences of the cells beyond the axis and those before it, along the last axis."""
    middle = planes.shape[-1] // 2
    beyond, before = planes[..., middle:], planes[..., middle - 1 :: -1]
    return beyond + before, beyond - before


def _sums(parts: Array) -> Array:
    """Return sums over the parts of each cell."""
    side = len(parts) // _FINE
    return np.asarray(parts.reshape(side, _FINE, side, _FINE).sum(axis=(1, 3)))


def changes_of(pupil: Pupil) -> dict[str, int]:
    """Return changes of a round pupil, and the number of derivatives of images by each; none for other pupils."""
    if not pupil.circular or pupil.mask is not None:
        return {}
    inner = {SHIFT: 2, OBSCURATION: 1} if pupil.obscuration else {}
    return {SLANT: 2, **dict.fromkeys(FOLDS, 2), **inner, OVAL: 2, ASPECT: 1}


class UnevenLight:
    """A round pupil with wavefronts (r, terms), Zernike terms of 1 at the edge, and a lattice of its images."""

    def __init__(self, pupil: Pupil, grid: Grid, terms: Sequence[Term], edge: Array) -> None:
        self._edge = edge.astype(np.float32)
        unit = grid.step(pupil) / grid.side
        # A term changes by up to n^2 over a radius. Images repeat after as many lambda*N as there are cells.
        steep = float((np.abs(edge) @ [n * n for n, _ in terms]).max(initial=0.0))
        needed = max(2.0 * steep / _TURN, max(grid.shape) * grid.step(pupil) / math.pi)
        side = min(_MOST, max(_FEWEST, _STEP * math.ceil(needed / _STEP)))
        at, inside, width = cell_centers(side), pupil.obscuration, 2.0 / side
        rho, theta = np.hypot(at, at[:, None]), np.arctan2(at[:, None], at)
        scale = math.sqrt(grid.cell(pupil) / (4.0 * math.pi * pupil.transmission)) / math.pi
        # Cells at the edge count with the part that is inside it, along the radius.
        clear = np.clip(0.5 + (1.0 - rho) / width, 0.0, 1.0)
        if inside:
            clear -= np.clip(0.5 + (inside - rho) / width, 0.0, 1.0)
        light = scale * width**2 * clear * pupil.illumination.at(np.minimum(rho, 1.0) ** 2)
        folds = [rho**n * turn(n * theta) for n in (2, 3, 4) for turn in (np.cos, np.sin)]
        factors = np.stack([np.ones_like(rho), -rho * np.sin(theta), -rho * np.cos(theta), *folds])
        self._light = (light * factors).astype(np.float32)
        self._terms = _zernike_values(terms, rho, theta)
        self._places = [unit * places for places in (grid.y, grid.x)]
        self._waves = [_plane_waves(places, at) for places in self._places]
        angles: Array = np.linspace(0.0, 2.0 * math.pi, _ANGLES * side, endpoint=False)
        #: Of each edge its terms, its waves along rows and columns, and the amplitudes by which it moves.
        self._rims = []
        for radius, turns in (
            (inside, (-np.sin(angles), -np.cos(angles), -np.ones_like(angles))),
            (1.0, (np.cos(2 * angles), np.sin(2 * angles))),
        ):
            if radius:
                waves = [
                    _plane_waves(places, radius * turn(angles))
                    for places, turn in zip(self._places, (np.sin, np.cos), strict=True)
                ]
                amplitude = (
                    scale * radius * (angles[1] - angles[0]) * float(pupil.illumination.at(np.array(radius**2)))
                )
                self._rims.append(
                    (
                        _zernike_values(terms, np.full(angles.shape, radius), angles),
                        waves,
                        amplitude * np.stack(turns),
                    )
                )

    def images(self) -> list[Values]:
        """Return derivatives (r, h, w) by each of the changes."""
        (down, across), (v, u) = self._waves, self._places
        found = []
        for one in self._edge:
            pupil = self._light * np.exp(1j * np.tensordot(one, self._terms, 1))
            field, *changes = down @ (pupil @ across.T)
            # By the place of a pixel the field changes by i times what it does by a sloping amplitude.
            stretched = 1j * (u * changes[1] - v[:, None] * changes[0])
            for terms, (rows, columns), moves in self._rims:
                rim = np.exp(1j * np.tensordot(one, terms, 1))
                changes += [(rows * (move * rim)) @ columns.T for move in moves]
            # I = |U|^2: I' = 2 Re(U* U').
            found.append([2.0 * (field.conj() * each).real for each in (*changes, stretched)])
        return list(np.asarray(found, np.float32).swapaxes(0, 1))


def _zernike_values(terms: Sequence[Term], rho: Array, theta: Array) -> Values:
    """Return Zernike terms at points, 1 at the edge."""
    return np.stack([zernike.polynomial(n, m, rho, theta) for n, m in terms]).astype(np.float32)


def _plane_waves(places: Array, at: Array) -> Array:
    """Return waves (places, points) of pupil points along one axis."""
    return np.exp(-1j * np.multiply.outer(places, at)).astype(np.complex64)
