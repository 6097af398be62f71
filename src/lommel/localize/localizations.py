"""Tables of localisations of a movie: positions, light, standard errors, with what files of them state."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field, replace
from os import PathLike
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.fit.findings import Findings, FitReport
from lommel.io import registry
from lommel.localize.fitting import STATES
from lommel.localize.molecule_files import Recording

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_ESTIMATES = ("x", "y", "z", "photons", "background")
_COLUMNS = (*_ESTIMATES, *(f"{name}_error" for name in _ESTIMATES))
_OTHERS = ("sigma_x", "sigma_y", "discrepancy", "log_likelihood", "score")


DOUBTFUL = 3.0
"""Discrepancy from which on the image of a molecule is not of the model: noise exceeds it in some of 1000."""
MEDIANS = ("photons", "background", "x_error", "y_error", "z_error", "discrepancy")


@dataclass(frozen=True, eq=False, repr=False)
class Localizations(FitReport):
    """Molecules of a movie, one row for each fit, by :func:`lommel.localize.localize_movie`.

    Attributes
    ----------
    table : structured ndarray, shape (n,)
        ``frame``, from 0; ``x``, ``y`` in the sample from the outer corner of the first pixel, along columns and
        rows, metres; ``z``, metres; ``photons``, electrons; ``background``, electrons a pixel; the Cramer-Rao
        standard errors of these five, ``x_error`` and so on; ``sigma_x``, ``sigma_y``, the standard
        deviations of a Gaussian fitted to the PSF at this z, metres; ``discrepancy`` and ``log_likelihood`` of the
        fit; ``score`` of the spot; ``state``, an index into ``states``. ``pandas.DataFrame(found.table)`` makes
        a data frame.
    recording : Recording
        Size of the movie, pixel pitch, direction of z.
    spots, borders, overlapping, saturated, left_out : int
        Spots found and fitted, and those left out; pixels of boxes that do not count; see
        :class:`lommel.localize.Spots`.
    ends : int
        Fits at an end of the range of z, of those at a border.
    states : tuple of str
        "converged"; "border", "steps" and "undetermined", whose positions are no estimates.
    findings, summary, converged, reliable, status, message
        What the checks of all molecules together found, and the verdict that follows, see
        :class:`lommel.fit.FitReport`; of a block of frames, those of the movie up to its end.
    """

    table: NDArray[np.void] = field(repr=False)
    recording: Recording
    spots: int = 0
    borders: int = 0
    overlapping: int = 0
    saturated: int = 0
    left_out: int = 0
    ends: int = 0
    states: tuple[str, ...] = field(default=STATES, repr=False)
    findings: Findings = field(default=Findings(), kw_only=True)
    summary: str = field(default="", kw_only=True)

    def __len__(self) -> int:
        return self.table.size

    def __repr__(self) -> str:
        counts = ", ".join(f"{n} {name}" for name, n in self.counts.items() if n)
        n = self.recording.frames
        return f"<Localizations: {len(self)} in {n} frame{'s' * (n != 1)}{': ' if counts else ''}{counts}>"

    def __getitem__(self, which: Any) -> Localizations:
        """Return some of them, by a slice, a mask or an array of indices."""
        chosen = self.table[which]
        if chosen.ndim != 1:
            raise TypeError(f"which must be a slice, a mask or indices, got {validation.shown(which)}")
        return replace(self, table=chosen)

    @property
    def kept(self) -> NDArray[np.bool_]:
        """Which fits converged: files have these."""
        return np.asarray(self.table["state"] == 0)

    @property
    def doubtful(self) -> NDArray[np.bool_]:
        """Which images noise does not explain, as with another molecule in the box: a discrepancy of 3 or more."""
        return np.asarray(self.table["discrepancy"] >= DOUBTFUL)

    @property
    def counts(self) -> dict[str, int]:
        """Number of fits in each state."""
        found = np.bincount(self.table["state"], minlength=len(self.states))
        return dict(zip(self.states, found.tolist(), strict=True))

    def to_dict(self) -> dict[str, Any]:
        """Return the result as plain data, without the table.

        Returns
        -------
        dict
            Verdict and findings, numbers of spots and fits, and medians of those that converged.
        """
        numbers, recording = super().to_dict(), self.recording
        del numbers["recording"]
        kept, flat = self.table[self.kept], recording.along == "none"
        names = [name for name in MEDIANS if not (flat and name == "z_error")]
        medians = {name: float(np.median(kept[name])) if kept.size else None for name in names}
        return numbers | {
            "frames": recording.frames,
            "shape": [recording.rows, recording.columns],
            "pixel_in_sample": float(f"{recording.pixel:.12g}"),
            "along": recording.along,
            "states": self.counts,
            "border_fits": {"z": self.ends, "reach": self.counts["border"] - self.ends},
            "written": kept.size,
            "doubtful": int(self.doubtful[self.kept].sum()),
            "medians": medians,
        }

    def save(self, *paths: str | PathLike[str]) -> None:
        """Write those that converged to files: ThunderSTORM's .csv or Picasso's .hdf5.

        See :func:`lommel.localize.writer`.

        Parameters
        ----------
        *paths : path

        Raises
        ------
        TypeError, ValueError
            If there is no path, or a suffix is unknown.
        OSError
            If a file cannot be written.
        ImportError
            If h5py is missing, for .hdf5.
        """
        with writer(*paths) as write:
            write(self)

    def plot(self, *, pixel: float | None = None, ax: Axes | None = None) -> Axes:
        """Draw those that converged as Gaussians of their standard deviations, coloured by z.

        Parameters
        ----------
        pixel : float, optional
            Pixel pitch of the picture, metres in the sample, at most 4096 a side; by default 800 a side.
        ax : matplotlib Axes, optional
            Where to draw; by default a new figure.

        Returns
        -------
        matplotlib Axes

        Raises
        ------
        TypeError, ValueError
            If `pixel` is out of range.
        ImportError
            If matplotlib is missing.
        """
        from lommel.show import molecules

        one = self.recording
        side = None if pixel is None else validation.real("pixel", pixel, above=0.0, below=1e-3)
        sides = one.rows * one.pixel, one.columns * one.pixel
        return molecules.picture(self.table[self.kept], sides, side, one.along, ax)


def columns() -> np.dtype[np.void]:
    """Return the type of a row of ``Localizations.table``."""
    numbers = [(name, np.float64) for name in (*_COLUMNS, *_OTHERS)]
    return np.dtype([("frame", np.int64), *numbers, ("state", np.int32)])


def joined(parts: Sequence[Localizations]) -> Localizations:
    """Return the localisations of parts of one movie, at least one, together."""
    names = ("spots", "borders", "overlapping", "saturated", "left_out", "ends")
    sums = {name: sum(getattr(part, name) for part in parts) for name in names}
    return replace(parts[-1], table=np.concatenate([part.table for part in parts]), **sums)


@contextmanager
def writer(*paths: str | PathLike[str]) -> Iterator[Callable[[Localizations], None]]:
    """Write files of localisations part by part, for movies of any length.

    Parameters
    ----------
    *paths : path
        Each ending in .csv (ThunderSTORM) or .hdf5 (Picasso, with a .yaml beside it, which needs h5py).

    Yields
    ------
    callable
        Called with :class:`lommel.localize.Localizations` of one movie, in turn; those that did not converge are left
        out. Files have temporary names until the end of the block, and there is none after an error.

    Raises
    ------
    TypeError, ValueError
        If there is no path, or a suffix is unknown.
    OSError
        If a file cannot be written.
    ImportError
        If h5py is missing, for .hdf5.

    Notes
    -----
    The .csv has the columns of ThunderSTORM, which SMAP, Picasso and others read too: id, frame (from 1), x, y, z in
    nanometres, sigma1 (x) and sigma2 (y) in nanometres, intensity, offset and bkgstd (photons, a pixel; the root of
    the background), uncertainty_xy (rms of both) and uncertainty_z in nanometres; and discrepancy, that of the fit.
    The .hdf5 has the data set ``locs`` of Picasso: frame (from 0), x, y, sx, sy, lpx, lpy in pixels of the camera, 0
    being the middle of the first pixel; photons, bg; z and lpz in nanometres; log_likelihood. z is that of the
    localisations in both: a position of the stage, or a depth.

    Examples
    --------
    >>> with writer("molecules.csv", "molecules.hdf5") as write:  # doctest: +SKIP
    ...     for part in localize_blocks(movie, table, noise=camera):
    ...         write(part)
    """
    if not paths:
        raise TypeError("paths must be one or more, got none")
    with ExitStack() as files:
        found = [(registry.find("molecules", path), validation.path("path", path)) for path in paths]
        writes = [files.enter_context(form.write(*form.places(path))) for form, path in found]

        def write(part: Localizations) -> None:
            kept = validation.instance("part", part, Localizations).table[part.kept]
            for each in writes:
                each(kept, part.recording)

        yield write
