"""Tables of localisations of a movie, and their files, written part by part: ThunderSTORM's and Picasso's."""

from __future__ import annotations

import io
import json
import shutil
import tempfile
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field, replace
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lommel.base import atomic, validation
from lommel.base.arrays import Index, Json, Values
from lommel.base.optional import library, version
from lommel.fit.findings import Findings, FitReport
from lommel.io import registry
from lommel.io.registry import Format
from lommel.localize.fitting import STATES

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_ESTIMATES = ("x", "y", "z", "photons", "background")
_COLUMNS = (*_ESTIMATES, *(f"{name}_error" for name in _ESTIMATES))
_OTHERS = ("sigma_x", "sigma_y", "discrepancy", "log_likelihood", "score")


DOUBTFUL = 3.0
"""Discrepancy from which on the image of a molecule is not of the model: noise exceeds it in some of 1000."""
MEDIANS = ("photons", "background", "x_error", "y_error", "z_error", "discrepancy")


@dataclass(frozen=True)
class Recording:
    """What localisations were made from.

    Attributes
    ----------
    frames, rows, columns : int
        Size of the movie.
    pixel : float
        Pixel pitch in the sample, metres.
    box : tuple of int
        Rows and columns of the boxes that were fitted.
    along : {"z", "depth", "none"}
        What z is: position of the stage, or depth below the cover glass; "none" where it is not told.
    name : str
        Name of the movie's file, or "".
    """

    frames: int
    rows: int
    columns: int
    pixel: float
    box: tuple[int, int]
    along: str
    name: str = ""


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

    def __getitem__(self, which: Index) -> Localizations:
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

    def to_dict(self) -> Json:
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
        from lommel.show import estimates

        one = self.recording
        side = None if pixel is None else validation.real("pixel", pixel, above=0.0, below=1e-3)
        sides = one.rows * one.pixel, one.columns * one.pixel
        return estimates.picture(self.table[self.kept], sides, side, one.along, ax)


def columns() -> np.dtype[np.void]:
    """Return the type of a row of ``Localizations.table``."""
    numbers = [(name, np.float64) for name in (*_COLUMNS, *_OTHERS)]
    return np.dtype([("frame", np.int64), *numbers, ("state", np.int32)])


def joined(parts: Sequence[Localizations]) -> Localizations:
    """Return the localisations of parts of one movie, one part or more, as one table."""
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


Rows: TypeAlias = NDArray[np.void]
"""Rows of the table of :class:`lommel.localize.Localizations`."""
Write: TypeAlias = Callable[[Rows, Recording], None]

_TEXT = {"encoding": "utf-8", "newline": ""}

_THUNDERSTORM: dict[str, tuple[str, Callable[[Rows], Values]]] = {
    "frame": ("%d", lambda rows: rows["frame"] + 1),
    "x [nm]": ("%.3f", lambda rows: 1e9 * rows["x"]),
    "y [nm]": ("%.3f", lambda rows: 1e9 * rows["y"]),
    "z [nm]": ("%.3f", lambda rows: 1e9 * rows["z"]),
    "sigma1 [nm]": ("%.2f", lambda rows: 1e9 * rows["sigma_x"]),
    "sigma2 [nm]": ("%.2f", lambda rows: 1e9 * rows["sigma_y"]),
    "intensity [photon]": ("%.2f", lambda rows: rows["photons"]),
    "offset [photon]": ("%.4f", lambda rows: rows["background"]),
    "bkgstd [photon]": ("%.4f", lambda rows: np.sqrt(rows["background"])),
    "uncertainty_xy [nm]": (
        "%.3f", lambda rows: 1e9 * np.sqrt(0.5 * (rows["x_error"] ** 2 + rows["y_error"] ** 2))
    ),
    "uncertainty_z [nm]": ("%.3f", lambda rows: 1e9 * rows["z_error"]),
    "discrepancy": ("%.3f", lambda rows: rows["discrepancy"]),
}  # fmt: skip
_Z = ("z [nm]", "uncertainty_z [nm]")


@contextmanager
def thunderstorm(path: Path) -> Iterator[Write]:
    """Yield a writer of rows of ThunderSTORM's table (M. Ovesny et al., doi:10.1093/bioinformatics/btu202)."""
    kept, done = dict[str, tuple[str, Callable[[Rows], Values]]](), 0

    def begin(along: str) -> None:
        kept.update({name: each for name, each in _THUNDERSTORM.items() if along != "none" or name not in _Z})
        file.write(",".join(f'"{name}"' for name in ("id", *kept)) + "\n")

    with atomic.opened(path, "w", **_TEXT) as file:

        def write(rows: Rows, recording: Recording) -> None:
            nonlocal done
            if not kept:
                begin(recording.along)
            line = ",".join(["%d", *(form for form, _ in kept.values())]) + "\n"
            columns = [np.arange(done + 1, done + 1 + rows.size), *(of(rows) for _, of in kept.values())]
            done += rows.size
            with atomic.as_path_error(path):
                file.writelines(line % row for row in zip(*(each.tolist() for each in columns), strict=True))

        yield write
        # A movie without molecules still has a header.
        if not kept:
            begin("z")


_FLOATS = ("x", "y", "z", "photons", "sx", "sy", "bg", "lpx", "lpy", "lpz", "log_likelihood")


def _locs(recording: Recording) -> np.dtype[np.void]:
    """Return the columns of a recording; without z if it is not estimated."""
    kept = [name for name in _FLOATS if recording.along != "none" or name not in ("z", "lpz")]
    return np.dtype([("frame", np.uint32), *((name, np.float32) for name in kept)])


@contextmanager
def picasso(path: Path, beside: Path) -> Iterator[Write]:
    """Yield what writes the data set of Picasso and its .yaml: J. Schnitzbauer et al., doi:10.1038/nprot.2017.024."""
    h5py, last, done = library("h5py", "files of Picasso need", "hdf5"), Recording(1, 1, 1, 1.0, (1, 1), "z"), 0
    with ExitStack() as stack:
        target = stack.enter_context(atomic.opened(path))
        with atomic.as_path_error(path):
            held = stack.enter_context(tempfile.TemporaryFile(dir=Path(target.name).parent, buffering=0))
        about = stack.enter_context(atomic.opened(beside, "w", **_TEXT))

        def write(rows: Rows, recording: Recording) -> None:
            nonlocal last, done
            last, done = recording, done + rows.size
            found = np.empty(rows.size, _locs(recording))
            found["frame"], found["photons"], found["bg"] = rows["frame"], rows["photons"], rows["background"]
            found["log_likelihood"] = rows["log_likelihood"]
            for name in ("x", "y"):
                found[name] = rows[name] / recording.pixel - 0.5  # from the middle of the first pixel
                found[f"s{name}"] = rows[f"sigma_{name}"] / recording.pixel
                found[f"lp{name}"] = rows[f"{name}_error"] / recording.pixel
            if recording.along != "none":
                found["z"], found["lpz"] = 1e9 * rows["z"], 1e9 * rows["z_error"]
            left = memoryview(found.tobytes())
            with atomic.as_path_error(path):
                while left:  # a disk that is nearly full takes a part
                    left = left[held.write(left) :]

        yield write
        # The HDF5 library writes to memory, with the first of the rows alone: a full disk would end the process.
        made = io.BytesIO()
        with h5py.File(made, "w") as file:
            table = file.create_dataset("locs", (done,), _locs(last))
            table[:1] = np.zeros(min(done, 1), _locs(last))
            offset = table.id.get_offset()
        with atomic.as_path_error(path):
            target.write(made.getvalue())
            if done:
                held.seek(0)
                target.seek(offset)
                shutil.copyfileobj(held, target)
        about.write(_yaml(last))


def _yaml(recording: Recording) -> str:
    """Return the metadata of a movie as Picasso reads them."""
    facts = {
        "Frames": recording.frames,
        "Height": recording.rows,
        "Width": recording.columns,
        "Pixelsize": float(f"{1e9 * recording.pixel:.12g}"),
        "Box Size": max(recording.box),
        "File": recording.name,
        "Generated by": f"lommel {version()} localize",
    }
    if recording.along != "none":
        facts["z"] = "depth" if recording.along == "depth" else "position of the stage"
    return "".join(f"{name}: {json.dumps(value)}\n" for name, value in facts.items())


registry.register(
    Format("molecules", (".csv",), thunderstorm, what="ThunderSTORM", readers="ThunderSTORM, SMAP, Picasso"),
    Format("molecules", (".hdf5",), picasso, library="h5py", beside=".yaml", what="Picasso", readers="Picasso"),
)
