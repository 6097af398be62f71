"""Grids of PSFs over a sensor."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from os import PathLike
from typing import TYPE_CHECKING, Any

import numpy as np

from lommel import show
from lommel.base import validation
from lommel.base.arrays import Array, Index
from lommel.channel_psf import ColourPSF
from lommel.io import field_files
from lommel.measures.psf_like import PSFGridLike
from lommel.optics.base_pupil import object_distances
from lommel.psf import PSF, Measured

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@dataclass(frozen=True, eq=False, repr=False)
class PSFGrid(Measured, PSFGridLike):
    """PSFs on a grid of positions over a sensor; ``grid[row, column]`` is the PSF of one position.

    Attributes
    ----------
    psf : PSF or ColourPSF
        A stack of shape (rows, columns), or (rows, columns, depths).
    x, y : ndarray, shapes (columns,) and (rows,)
        Positions from the optical axis, in :attr:`unit`.
    sensor : (float, float)
        Height and width of the sensor, in :attr:`unit`.
    depths : ndarray, shape (depths,), or None
        Distances of the object from the lens, metres.

    Raises
    ------
    TypeError, ValueError
        If the arguments are inconsistent.
    """

    psf: PSF | ColourPSF
    x: Array
    y: Array
    sensor: tuple[float, float]
    depths: Array | None = None

    def __post_init__(self) -> None:
        if not isinstance(self.psf, PSF | ColourPSF):
            raise TypeError(f"psf must be a PSF or ColourPSF, got {validation.shown(self.psf)}")
        shape = self.psf.pupil.shape
        axes = 2 if self.depths is None else 3
        for name, axis in (("y", 0), ("x", 1)):
            positions = validation.real_array(name, getattr(self, name))
            if len(shape) != axes or positions.shape != shape[axis : axis + 1]:
                raise ValueError(f"{name} must fit a stack of PSFs of shape {shape}, got shape {positions.shape}")
            object.__setattr__(self, name, positions)
        object.__setattr__(self, "sensor", sides(self.sensor, self.unit))
        if self.depths is not None:
            distances = np.atleast_1d(object_distances(self.depths))
            if distances.shape != shape[2:]:
                raise ValueError(f"depths must fit a stack of PSFs of shape {shape}, got shape {distances.shape}")
            object.__setattr__(self, "depths", distances)

    def __len__(self) -> int:
        """Return the number of rows."""
        return int(self.y.size)

    def __repr__(self) -> str:
        size = f"{self.sensor[0]:g} x {self.sensor[1]:g} {self.unit}"
        distances = "" if self.depths is None else f" x {self.depths.size} distances"
        return f"<{type(self).__name__} {self.y.size} x {self.x.size}{distances} on {size}: {self.psf!r}>"

    def __getitem__(self, index: Index) -> PSF | ColourPSF:
        """Return part of the stack, in all channels; `index` is a NumPy index of an array with the stack's shape."""
        return self.psf.part(index) if isinstance(self.psf, ColourPSF) else self.psf[index]

    def apply(self, measure: Callable[[PSF], Any]) -> Any:
        """Return the value of `measure` for the PSF at each position, distance and channel."""
        return self.psf.apply(measure)

    def channel(self, channel: str | int) -> PSFGrid:
        """Return the grid of one `channel`, given by name or number; ValueError or KeyError for other channels."""
        if not isinstance(self.psf, ColourPSF):
            raise ValueError("this grid has no channels; compute it with FieldMap.grid(..., channels=...)")
        return replace(self, psf=self.psf[channel])

    def at_depth(self, index: int) -> PSFGrid:
        """Return the grid at the distance ``depths[index]``; ValueError without distances, or for another index."""
        if self.depths is None:
            raise ValueError("this grid has no distances; compute it with FieldMap.grid(..., depths=..., lens=...)")
        depth_index = validation.integer("index", index, least=-self.depths.size, most=self.depths.size - 1)
        return replace(self, psf=self[:, :, depth_index], depths=None)

    def plot(self, ax: Axes | None = None, *, stretch: str = "sqrt") -> Axes:
        """Draw each PSF, enlarged, at its position on the sensor; a grid of three channels is drawn in colour.

        See :func:`lommel.show.plot.field` for `ax` and `stretch`.
        """
        validation.axes("ax", ax)
        return show.plot.field(self, ax, stretch=stretch)

    def _repr_html_(self) -> str:
        return show.notebook.grid(self)

    def save(self, path: str | PathLike[str]) -> None:
        """Write the grid to a `path` ending in .tif, .fits, .h5, .mat, .npz or .zarr.

        See :func:`lommel.io.field_files.save`.
        """
        field_files.save(self, path)

    @classmethod
    def load(cls, path: str | PathLike[str]) -> PSFGrid:
        """Read a grid from `path`, a file that :meth:`save` wrote; FileError if it is damaged or of another kind."""
        psf, x, y, sensor, depths = field_files.load(path, PSF)
        return cls(psf if isinstance(psf, PSF) else ColourPSF(*psf), x, y, sensor, depths)


def sides(sensor: object, unit: str) -> tuple[float, float]:
    """Return the height and width of a sensor; TypeError or ValueError unless `sensor` is a pair of lengths."""
    if not isinstance(sensor, tuple | list) or len(sensor) != 2:
        raise TypeError(f"sensor must be (height, width), got {validation.shown(sensor)}")
    height, width = (validation.real(f"sensor[{k}]", side, above=0.0, unit=unit) for k, side in enumerate(sensor))
    return height, width
