r"""Derivatives of images by light of a round pupil that is not where its aperture says.

The field is ``U = (1/pi) E_y P E_x`` of the pupil function P in square cells (doi:10.1364/OE.15.015935). By a change
U' of the field the image changes by ``2 Re(U* U')``: U' is that of an amplitude ``a P`` over the cells, or the
integral of P along an edge times the length by which it moves outward. Within a few percent, not proven.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from lommel.base.arrays import Array, Values
from lommel.methods.derivative_names import Term
from lommel.optics.aperture.mask import cell_centers
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil
from lommel.special import zernike

SLANT = "light that slopes across the pupil"
FOLDS = tuple(f"light of {n} folds in the pupil" for n in ("two", "three", "four"))
SHIFT, OVAL = "obscuration off the middle", "aperture that is not round"
ASPECT = "image that is longer along y than along x"
_LEAST, _STEP, _MOST = 48, 16, 256  # cells across the aperture, what their number is a multiple of, and most of them
_TURN = 0.6  # radians by which phases may change from cell to cell
_ANGLES = 4  # points along an edge for each cell across


def changes_of(pupil: Pupil) -> dict[str, int]:
    """Return changes of a round pupil and the number of derivatives of images by each; none of other pupils."""
    if not pupil.circular or pupil.mask is not None:
        return {}
    inner = {SHIFT: 2} if pupil.obscuration else {}
    return {SLANT: 2, **dict.fromkeys(FOLDS, 2), **inner, OVAL: 2, ASPECT: 1}


class UnevenLight:
    """A round pupil with wavefronts (r, terms), Zernike terms of 1 at the edge, and a lattice of its images."""

    def __init__(self, pupil: Pupil, grid: Grid, terms: Sequence[Term], edge: Array) -> None:
        self._edge = edge.astype(np.float32)
        unit = grid.step(pupil) / grid.side
        # A term changes by up to n^2 over a radius. Images repeat after as many lambda*N as there are cells.
        steep = float((np.abs(edge) @ [n * n for n, _ in terms]).max(initial=0.0))
        needed = max(2.0 * steep / _TURN, max(grid.shape) * grid.step(pupil) / math.pi)
        side = min(_MOST, max(_LEAST, _STEP * math.ceil(needed / _STEP)))
        at, inside, width = cell_centers(side), pupil.obscuration, 2.0 / side
        rho, theta = np.hypot(at, at[:, None]), np.arctan2(at[:, None], at)
        scale = math.sqrt(grid.cell(pupil) / (4.0 * math.pi * pupil.transmission)) / math.pi
        clear = np.clip(0.5 + (1.0 - rho) / width, 0.0, 1.0)
        if inside:
            clear -= np.clip(0.5 + (inside - rho) / width, 0.0, 1.0)
        light = scale * width**2 * clear * pupil.illumination.at(np.minimum(rho, 1.0) ** 2)
        folds = [rho**n * turn(n * theta) for n in (2, 3, 4) for turn in (np.cos, np.sin)]
        factors = np.stack([np.ones_like(rho), -rho * np.sin(theta), -rho * np.cos(theta), *folds])
        self._light = (light * factors).astype(np.float32)
        self._terms = _of(terms, rho, theta)
        self._places = [unit * places for places in (grid.y, grid.x)]
        self._waves = [_waves(places, at) for places in self._places]
        angles: Array = np.linspace(0.0, 2.0 * math.pi, _ANGLES * side, endpoint=False)
        #: Of each edge its terms, its waves along rows and columns, and the amplitudes by which it moves.
        self._rims = []
        for radius, turns in (
            (inside, (-np.sin(angles), -np.cos(angles))),
            (1.0, (np.cos(2 * angles), np.sin(2 * angles))),
        ):
            if radius:
                waves = [
                    _waves(places, radius * turn(angles))
                    for places, turn in zip(self._places, (np.sin, np.cos), strict=True)
                ]
                amplitude = (
                    scale * radius * (angles[1] - angles[0]) * float(pupil.illumination.at(np.array(radius**2)))
                )
                self._rims.append(
                    (_of(terms, np.full(angles.shape, radius), angles), waves, amplitude * np.stack(turns))
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
            found.append([2.0 * (field.conj() * each).real for each in (*changes, stretched)])
        return list(np.asarray(found, np.float32).swapaxes(0, 1))


def _of(terms: Sequence[Term], rho: Array, theta: Array) -> Values:
    """Return Zernike terms at points, 1 at the edge."""
    return np.stack([zernike.polynomial(n, m, rho, theta) for n, m in terms]).astype(np.float32)


def _waves(places: Array, at: Array) -> Array:
    """Return waves (places, points) of points of the pupil along one axis."""
    return np.exp(-1j * np.multiply.outer(places, at)).astype(np.complex64)
