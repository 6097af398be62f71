r"""Derivatives of images by light of a round pupil that is not where its aperture says.

The amplitude may slope across the pupil, the obscuration be off the middle, and the edge not be round. The field is
``U = E_y P E_x`` of the pupil function P in square cells (doi:10.1364/OE.15.015935). By a change a of the amplitude
the image changes by ``2 Re(U* E_y (a P) E_x)``; at an edge, a is the length by which it moves over the width of a
cell. Within a tenth, not proven.
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

SLANT, SHIFT, OVAL = "light that slopes across the pupil", "obscuration off the middle", "aperture that is not round"
_LEAST, _STEP = 48, 16  # cells across the aperture, and what their number is a multiple of


def changes_of(pupil: Pupil) -> tuple[str, ...]:
    """Return the changes of a pupil by which images have derivatives, each along rows and columns, or none."""
    if not pupil.circular or pupil.mask is not None:
        return ()
    return (SLANT, SHIFT, OVAL) if pupil.obscuration else (SLANT, OVAL)


class UnevenLight:
    """A round pupil in cells, images of which are wanted on a lattice, and Zernike terms there, 1 at the edge."""

    def __init__(self, pupil: Pupil, grid: Grid, terms: Sequence[Term]) -> None:
        pitch = grid.step(pupil)
        # Images repeat after as many lambda*N as there are cells: one of them fills the window.
        side = max(_LEAST, _STEP * math.ceil(max(grid.shape) * pitch / math.pi / _STEP))
        at = cell_centers(side)
        rho, theta = np.hypot(at, at[:, None]), np.arctan2(at[:, None], at)
        inside, width = pupil.obscuration, 2.0 / side
        clear, edge = _edge((1.0 - rho) / width)
        blocked, rim = _edge((inside - rho) / width)
        scale = width**2 / math.pi * math.sqrt(grid.cell(pupil) / (4.0 * math.pi * pupil.transmission))
        light = scale * pupil.illumination.at(np.minimum(rho, 1.0) ** 2)
        clear = clear - blocked if inside else clear
        planes = [clear, -at[:, None] * clear, -at * clear]
        if inside:
            planes += [-rim / width * np.sin(theta), -rim / width * np.cos(theta)]
        planes += [edge / width * np.cos(2.0 * theta), edge / width * np.sin(2.0 * theta)]
        self._light = (light * np.stack(planes)).astype(np.float32)
        self._terms = np.stack([zernike.polynomial(n, m, rho, theta) for n, m in terms]).astype(np.float32)
        self._down, self._across = (
            np.exp(-1j * pitch / grid.side * np.multiply.outer(places, at)).astype(np.complex64)
            for places in (grid.y, grid.x)
        )

    def images(self, edge: Array) -> list[Values]:
        """Return derivatives (r, h, w) by each of the changes, for wavefronts (r, terms)."""
        found = []
        for one in edge.astype(np.float32):
            pupil = self._light * np.exp(1j * np.tensordot(one, self._terms, 1))
            field = self._down @ (pupil @ self._across.T)
            found.append(2.0 * (field[0].conj() * field[1:]).real)
        return list(np.stack(found, axis=1))


def _edge(inward: Array) -> tuple[Array, Array]:
    """Return the parts of cells inside of an edge, of distances inward in cells, and how these change with it."""
    return np.clip(0.5 + inward, 0.0, 1.0), np.maximum(1.0 - np.abs(inward), 0.0)
