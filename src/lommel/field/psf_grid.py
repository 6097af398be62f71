"""PSFs over a sensor, each with its place."""

from __future__ import annotations

from dataclasses import dataclass
from os import PathLike
from typing import TYPE_CHECKING, Any

from lommel import show
from lommel.base import validation
from lommel.io import field_files
from lommel.measures.answer import AnswerGrid
from lommel.psf import PSF

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@dataclass(frozen=True, eq=False, repr=False)
class PSFGrid(AnswerGrid):
    """PSFs over a sensor; ``grid[row, column]`` is one of them.

    Attributes
    ----------
    psf : PSF
        A stack of shape (rows, columns).
    x, y : ndarray, shapes (columns,) and (rows,)
        Where each is, from the optical axis, in :attr:`unit`.
    sensor : (float, float)
        Height and width.

    Raises
    ------
    TypeError, ValueError
        If these do not fit each other.
    """

    psf: PSF

    def __getitem__(self, index: Any) -> PSF:
        """Return part of the stack."""
        return self.psf[index]

    def plot(self, ax: Axes | None = None, *, stretch: str = "sqrt") -> Axes:
        """Draw each PSF, enlarged, in its place on the sensor; see :func:`lommel.show.plot.field`.

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            Where to draw; by default a new figure.
        stretch : str, default "sqrt"
            Of the values.

        Returns
        -------
        matplotlib.axes.Axes

        Raises
        ------
        ImportError
            If matplotlib is not installed.
        TypeError, ValueError
            If an argument is out of range.
        """
        validation.axes("ax", ax)
        return show.plot.field(self, ax, stretch=stretch)

    def _repr_html_(self) -> str:
        return show.notebook.grid(self)

    def save(self, path: str | PathLike[str]) -> None:
        """Write ``.tif``, ``.fits``, ``.h5``, ``.mat``, ``.npz``, ``.zarr``; :func:`lommel.io.field_files.save`.

        Parameters
        ----------
        path : path

        Raises
        ------
        ValueError, ImportError, OSError
            As :func:`lommel.io.field_files.save`.
        """
        field_files.save(self, path)

    @classmethod
    def load(cls, path: str | PathLike[str]) -> PSFGrid:
        """Read a file that :meth:`save` wrote.

        Parameters
        ----------
        path : path

        Returns
        -------
        PSFGrid

        Raises
        ------
        FileError
            If the file is damaged, or was not written as a grid of PSFs.
        OSError
            If it cannot be read.
        """
        return cls(*field_files.load(path, PSF))
