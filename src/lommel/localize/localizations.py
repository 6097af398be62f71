"""Tables of the localisations of a movie, and their files (ThunderSTORM, Picasso), written part by part."""

from __future__ import annotations

import io
import json
import shutil
import tempfile
from collections.abc import Callable, Iterable, Iterator
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
_EXTRA_COLUMNS = ("sigma_x", "sigma_y", "discrepancy", "log_likelihood", "score")


DOUBTFUL = 3.0
"""Smallest discrepancy of an image that contradicts the model; noise alone exceeds it in a few of 1000 fits."""
MEDIANS = ("photons", "background", "x_error", "y_error", "z_error", "discrepancy")


@dataclass(frozen=True)
class MovieInfo:
    """The movie from which localisations were computed.

    Attributes
    ----------
    frames, rows, columns : int
        Size of the movie.
    pixel : float
        Pixel pitch in the sample, metres.
    box : tuple of int
        Rows and columns of the boxes that were fitted.
    along : {"z", "depth", "none"}
        Meaning of z: position of the stage, or depth below the cover glass; "none" if z is not estimated.
    name : str
        File name of the movie, or "" if it is an array.
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
        Fields: ``frame``, from 0; ``x`` (by columns) and ``y`` (by rows), position in the sample from the outer
        corner of the first pixel, metres; ``z``, metres; ``photons``, electrons; ``background``, electrons per pixel;
        ``x_error``, ``y_error``, ``z_error``, ``photons_error`` and ``background_error``, Cramer-Rao standard errors;
        ``sigma_x`` and ``sigma_y``, standard deviations of a Gaussian fitted to the PSF at this z, metres;
        ``discrepancy`` and ``log_likelihood`` of the fit; ``score`` of the spot; ``state``, an index into ``states``.
        ``pandas.DataFrame(localizations.table)`` converts the table to a data frame.
    recording : MovieInfo
        Size of the movie, pixel pitch and meaning of z.
    spots : int
        Number of spots that were fitted.
    borders, overlapping, saturated, left_out : int
        Numbers of spots that were not fitted, and of pixels that were ignored; see :class:`lommel.localize.Spots`.
    ends : int
        Number of fits in the state "border" that are at an end of the range of z.
    states : tuple of str
        "converged", "border", "steps" and "undetermined", see :class:`lommel.localize.Molecules`. Positions are
        estimates only in the state "converged".
    findings, summary, converged, reliable, status, message
        Results of the checks of all molecules, and the verdict; see :class:`lommel.fit.FitReport`. For a
        block of frames, these attributes describe the movie up to the end of the block.
    """

    table: NDArray[np.void] = field(repr=False)
    recording: MovieInfo
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
        """Return a selection of localisations by a slice, a mask or an array of indices."""
        selected = self.table[which]
        if selected.ndim != 1:
            raise TypeError(f"which must be a slice, a mask or indices, got {validation.shown(which)}")
        return replace(self, table=selected)

    @property
    def kept(self) -> NDArray[np.bool_]:
        """True for fits that converged, which are written to files."""
        return np.asarray(self.table["state"] == 0)

    @property
    def doubtful(self) -> NDArray[np.bool_]:
        """True for a discrepancy of 3 or more, for example due to a second molecule in the box."""
        return np.asarray(self.table["discrepancy"] >= DOUBTFUL)

    @property
    def counts(self) -> dict[str, int]:
        """Number of fits in each state."""
        numbers = np.bincount(self.table["state"], minlength=len(self.states))
        return dict(zip(self.states, numbers.tolist(), strict=True))

    def to_dict(self) -> Json:
        """Return the result as plain data, without the table.

        Returns
        -------
        dict
            Verdict and findings, numbers of spots and fits, and medians over the fits that converged.
        """
        numbers, recording = super().to_dict(), self.recording
        del numbers["recording"]
        converged, without_z = self.table[self.kept], recording.along == "none"
        names = [name for name in MEDIANS if not (without_z and name == "z_error")]
        medians = {name: float(np.median(converged[name])) if converged.size else None for name in names}
        return numbers | {
            "frames": recording.frames,
            "shape": [recording.rows, recording.columns],
            "pixel_in_sample": float(f"{recording.pixel:.12g}"),
            "along": recording.along,
            "states": self.counts,
            "border_fits": {"z": self.ends, "reach": self.counts["border"] - self.ends},
            "written": converged.size,
            "doubtful": int(self.doubtful[self.kept].sum()),
            "medians": medians,
        }

    def save(self, *paths: str | PathLike[str]) -> None:
        """Write the converged localisations to files: .csv (ThunderSTORM) or .hdf5 (Picasso).

        See :func:`lommel.localize.writer`.

        Parameters
        ----------
        *paths : path
            Files to write.

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
        """Draw the converged localisations as Gaussians of their standard errors, coloured by z.

        Parameters
        ----------
        pixel : float, optional
            Pixel pitch of the picture, metres in the sample. A side has at most 4096 pixels, by default 800.
        ax : matplotlib Axes, optional
            Axes to draw in; by default a new figure.

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

        movie = self.recording
        picture_pixel = None if pixel is None else validation.real("pixel", pixel, above=0.0, below=1e-3, unit="m")
        sides = movie.rows * movie.pixel, movie.columns * movie.pixel
        return estimates.picture(self.table[self.kept], sides, picture_pixel, movie.along, ax)


def columns() -> np.dtype[np.void]:
    """Return the type of a row of ``Localizations.table``."""
    numbers = [(name, np.float64) for name in (*_COLUMNS, *_EXTRA_COLUMNS)]
    return np.dtype([("frame", np.int64), *numbers, ("state", np.int32)])


def joined(parts: Iterable[Localizations]) -> Localizations:
    """Return the localisations of successive parts of a movie (at least one) in a single table."""
    sums: Json = dict.fromkeys(("spots", "borders", "overlapping", "saturated", "left_out", "ends"), 0)
    data = bytearray()  # which grows in place: neither parts nor a second table take memory
    for part in parts:
        data += part.table.tobytes()
        sums = {name: count + getattr(part, name) for name, count in sums.items()}
    return replace(part, table=np.frombuffer(data, part.table.dtype), **sums)


@contextmanager
def writer(*paths: str | PathLike[str]) -> Iterator[Callable[[Localizations], None]]:
    """Write files of localisations part by part, for movies of any length.

    Parameters
    ----------
    *paths : path
        Files to write, with the suffix .csv (ThunderSTORM) or .hdf5 (Picasso; requires h5py). A .hdf5 file has a
        .yaml file with metadata in the same folder.

    Yields
    ------
    callable
        Function to be called with the :class:`lommel.localize.Localizations` of each part of a movie, in the order of
        frames. Fits that did not converge are not written. Files have temporary names until the end of the ``with``
        block, and are removed after an error.

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
    The .csv file has the columns of ThunderSTORM, which SMAP and Picasso also read: id, frame (from 1), x, y, z in
    nanometres, sigma1 (x) and sigma2 (y) in nanometres, intensity (photons), offset (photons per pixel), bkgstd (the
    square root of offset), uncertainty_xy (rms of the errors of x and y) and uncertainty_z in nanometres, and the
    discrepancy of the fit. The .hdf5 file has the data set ``locs`` of Picasso: frame (from 0); x, y, sx, sy, lpx,
    lpy in pixels of the camera, where 0 is the middle of the first pixel; photons, bg; z and lpz in nanometres;
    log_likelihood. In both files, z is the position of the stage or the depth, as in the localisations.

    Examples
    --------
    >>> with writer("molecules.csv", "molecules.hdf5") as write:  # doctest: +SKIP
    ...     for part in localize_blocks(movie, table, noise=camera):
    ...         write(part)
    """
    if not paths:
        raise TypeError("paths must be one or more files to write, got none")
    with ExitStack() as files:
        formats = [(registry.find("molecules", path), validation.path("path", path)) for path in paths]
        writers = [files.enter_context(form.write(*form.places(path))) for form, path in formats]

        def write(part: Localizations) -> None:
            rows = validation.instance("part", part, Localizations).table[part.kept]
            for write_rows in writers:
                write_rows(rows, part.recording)

        yield write


Rows: TypeAlias = NDArray[np.void]
"""Rows of the table of :class:`lommel.localize.Localizations`."""
Write: TypeAlias = Callable[[Rows, MovieInfo], None]
"""Function that appends rows to a file."""

_TEXT = {"encoding": "utf-8", "newline": ""}

# Number format of each column, and its values.
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
    columns, row_count = dict[str, tuple[str, Callable[[Rows], Values]]](), 0

    def write_header(along: str) -> None:
        columns.update({name: column for name, column in _THUNDERSTORM.items() if along != "none" or name not in _Z})
        file.write(",".join(f'"{name}"' for name in ("id", *columns)) + "\n")

    with atomic.opened(path, "w", **_TEXT) as file:

        def write(rows: Rows, recording: MovieInfo) -> None:
            nonlocal row_count
            if not columns:
                write_header(recording.along)
            line = ",".join(["%d", *(number_format for number_format, _ in columns.values())]) + "\n"
            indices = np.arange(row_count + 1, row_count + 1 + rows.size)
            numbers = [indices, *(values(rows) for _, values in columns.values())]
            row_count += rows.size
            with atomic.as_path_error(path):
                file.writelines(line % row for row in zip(*(column.tolist() for column in numbers), strict=True))

        yield write
        # Without molecules, the file has only a header.
        if not columns:
            write_header("z")


_FLOATS = ("x", "y", "z", "photons", "sx", "sy", "bg", "lpx", "lpy", "lpz", "log_likelihood")


def _locs(recording: MovieInfo) -> np.dtype[np.void]:
    """Return the type of a row of Picasso's data set, without z if it is not estimated."""
    names = [name for name in _FLOATS if recording.along != "none" or name not in ("z", "lpz")]
    return np.dtype([("frame", np.uint32), *((name, np.float32) for name in names)])


@contextmanager
def picasso(path: Path, yaml_path: Path) -> Iterator[Write]:
    """Yield a writer of rows of Picasso's data set, with metadata in a .yaml file.

    J. Schnitzbauer et al., doi:10.1038/nprot.2017.024. Rows are collected in a temporary file, since their number is
    needed at the beginning of the HDF5 file.
    """
    h5py, movie = library("h5py", "files of Picasso need", "hdf5"), MovieInfo(1, 1, 1, 1.0, (1, 1), "z")
    row_count = 0
    with ExitStack() as stack:
        target = stack.enter_context(atomic.opened(path))
        with atomic.as_path_error(path):
            row_file = stack.enter_context(tempfile.TemporaryFile(dir=Path(target.name).parent, buffering=0))
        metadata = stack.enter_context(atomic.opened(yaml_path, "w", **_TEXT))

        def write(rows: Rows, recording: MovieInfo) -> None:
            nonlocal movie, row_count
            movie, row_count = recording, row_count + rows.size
            locs = np.empty(rows.size, _locs(recording))
            locs["frame"], locs["photons"], locs["bg"] = rows["frame"], rows["photons"], rows["background"]
            locs["log_likelihood"] = rows["log_likelihood"]
            for name in ("x", "y"):
                locs[name] = rows[name] / recording.pixel - 0.5  # from the middle of the first pixel
                locs[f"s{name}"] = rows[f"sigma_{name}"] / recording.pixel
                locs[f"lp{name}"] = rows[f"{name}_error"] / recording.pixel
            if recording.along != "none":
                locs["z"], locs["lpz"] = 1e9 * rows["z"], 1e9 * rows["z_error"]
            unwritten = memoryview(locs.tobytes())
            with atomic.as_path_error(path):
                while unwritten:  # a nearly full disk accepts only a part at a time
                    unwritten = unwritten[row_file.write(unwritten) :]

        yield write
        # On a full disk the HDF5 library would end the process: it writes to memory, and only the first row,
        # which reserves the space of all rows in the file.
        header = io.BytesIO()
        with h5py.File(header, "w") as file:
            table = file.create_dataset("locs", (row_count,), _locs(movie))
            table[:1] = np.zeros(min(row_count, 1), _locs(movie))
            offset = table.id.get_offset()
        with atomic.as_path_error(path):
            target.write(header.getvalue())
            if row_count:
                row_file.seek(0)
                target.seek(offset)
                shutil.copyfileobj(row_file, target)
        metadata.write(_yaml(movie))


def _yaml(recording: MovieInfo) -> str:
    """Return the metadata of a movie in the format of Picasso."""
    entries = {
        "Frames": recording.frames,
        "Height": recording.rows,
        "Width": recording.columns,
        "Pixelsize": float(f"{1e9 * recording.pixel:.12g}"),
        "Box Size": max(recording.box),
        "File": recording.name,
        "Generated by": f"lommel {version()} localize",
    }
    if recording.along != "none":
        entries["z"] = "depth" if recording.along == "depth" else "position of the stage"
    return "".join(f"{name}: {json.dumps(value)}\n" for name, value in entries.items())


registry.register(
    Format("molecules", (".csv",), thunderstorm, what="ThunderSTORM", readers="ThunderSTORM, SMAP, Picasso"),
    Format("molecules", (".hdf5",), picasso, library="h5py", beside=".yaml", what="Picasso", readers="Picasso"),
)
