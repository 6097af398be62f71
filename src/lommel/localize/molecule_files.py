"""Files of localisations, written part by part: ThunderSTORM's table and Picasso's HDF5."""

from __future__ import annotations

import io
import json
import shutil
import tempfile
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from lommel.base import atomic
from lommel.base.arrays import Values
from lommel.base.optional import library, version
from lommel.io import registry
from lommel.io.registry import Format

Rows: TypeAlias = NDArray[np.void]
"""Rows of the table of :class:`lommel.localize.Localizations`."""


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
    """Yield what writes rows of ThunderSTORM's table: M. Ovesny et al., doi:10.1093/bioinformatics/btu202."""
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
            with atomic.told_as(path):
                file.writelines(line % row for row in zip(*(each.tolist() for each in columns), strict=True))

        yield write
        if not kept:
            begin("z")


_FLOATS = ("x", "y", "z", "photons", "sx", "sy", "bg", "lpx", "lpy", "lpz", "log_likelihood")
_LOCS = np.dtype([("frame", np.uint32), *((name, np.float32) for name in _FLOATS)])


def _locs(recording: Recording) -> np.dtype[np.void]:
    """Return the columns of a recording; without z where it is not told."""
    kept = [name for name in _LOCS.names or () if recording.along != "none" or name not in ("z", "lpz")]
    return np.dtype([(name, _LOCS[name]) for name in kept])


@contextmanager
def picasso(path: Path, beside: Path) -> Iterator[Write]:
    """Yield what writes the data set of Picasso and its .yaml: J. Schnitzbauer et al., doi:10.1038/nprot.2017.024."""
    h5py, last, done = library("h5py", "files of Picasso need", "hdf5"), Recording(1, 1, 1, 1.0, (1, 1), "z"), 0
    with ExitStack() as stack:
        target = stack.enter_context(atomic.opened(path))
        with atomic.told_as(path):
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
            with atomic.told_as(path):
                while left:  # a disk that is nearly full takes a part
                    left = left[held.write(left) :]

        yield write
        # The HDF5 library writes to memory, with the first of the rows alone: a full disk would end the process.
        made = io.BytesIO()
        with h5py.File(made, "w") as file:
            table = file.create_dataset("locs", (done,), _locs(last))
            table[:1] = np.zeros(min(done, 1), _locs(last))
            offset = table.id.get_offset()
        with atomic.told_as(path):
            target.write(made.getvalue())
            if done:
                held.seek(0)
                target.seek(offset)
                shutil.copyfileobj(held, target)
        about.write(_yaml(last))


def _yaml(recording: Recording) -> str:
    """Return what Picasso reads of a movie."""
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
