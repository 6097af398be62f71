"""What sets of docs/real-data.md need beside real_data.toml: files that commands read, and rows of numbers."""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import tifffile
from numpy.typing import NDArray

Array = NDArray[np.float64]
Facts = dict[str, Any]
"""What a command prints with --json, or the names that code leaves."""


class Row(NamedTuple):
    """A number beside its reference; `error` is its stated standard error, nan where there is none."""

    what: str
    reference: float
    value: float
    error: float

    @property
    def off(self) -> float:
        """Error in standard errors."""
        return (self.value - self.reference) / self.error


_NOLL = {5: "2,-2", 6: "2,2", 7: "3,-1", 8: "3,1", 9: "3,-3", 10: "3,3", 11: "4,0"}
# Noll 5 to 11 of both pairs as printed in examples/AuxTel2001.ipynb of CWFS, nanometres.
_CWFS_NM = (
    (-6.26481943, 137.74661812, 40.99011616, 37.98610521, -38.14227693, -2.27884537, -7.45553831),
    (41.73833098, 42.61086748, 29.83620146, -6.23734934, -27.33510745, -20.39833327, -16.31023311),
)
_AUXTEL_NM, _RUBIN_NM = 670.0, 3850.0
_FREQUENCIES = (0.1, 0.2, 0.3, 0.4)
_PUPIL = 22.5e-3
"""Metres from the front of the 50 mm lens to its entrance pupil, by rf50mm.zmx of the same repository."""
_BEAD = 20
_STARS, _HALF = 3, 16
_COLUMNS = ("frame", "x", "y", "x_error", "y_error")


def linked(places: dict[str, Path]) -> None:
    """Show files of the cache in the current folder by the names of a set."""
    for name, place in places.items():
        Path(name).symlink_to(place)


def change_of_terms(facts: list[Facts]) -> Iterator[Row]:
    """Yield the change of Noll 5 to 11 from the first pair to the second; CWFS has the opposite sign."""
    nm = _AUXTEL_NM / (2.0 * math.pi)
    first, second = facts
    for (noll, name), before, after in zip(_NOLL.items(), *_CWFS_NM, strict=True):
        error = math.hypot(first["errors"][name], second["errors"][name])
        change = second["coefficients"][name] - first["coefficients"][name]
        yield Row(f"Noll {noll}", before - after, nm * change, nm * error)


def rubin_donuts(places: dict[str, Path]) -> None:
    """Write the donuts as arrays, of a million counts each."""
    for name, place in places.items():
        np.save(Path(name).stem, 1e3 * np.loadtxt(place))


def simulated_terms(facts: list[Facts]) -> Iterator[Row]:
    """Yield Noll 5 to 11 beside the one simulated; CWFS has the opposite sign, and turns the rows of texts."""
    (fact,) = facts
    nm = _RUBIN_NM / (2.0 * math.pi)
    for noll, name in _NOLL.items():
        reference = -0.25 * 770.0 if noll == 7 else 0.0
        yield Row(f"Noll {noll}", reference, nm * fact["coefficients"][name], nm * fact["errors"][name])


def listed_rms(facts: list[Facts]) -> Iterator[Row]:
    """Yield the rms of the wavefront beside that of the listing, from its coefficients, with and without tilt."""
    fitted = Path("listing.txt").read_text(encoding="utf-16").partition("fitted coefficients:")[2]
    for name, label, key in (
        ("chief", "rms", "rms_waves"),
        ("centroid", "rms without tilt", "rms_waves_without_tilt"),
    ):
        (listed,) = re.findall(rf"RMS \(to {name}\)\s*:\s*([\d.]+) waves", fitted)
        yield Row(label, float(listed), facts[0][key], 1e-8)


def bead(places: dict[str, Path]) -> None:
    """Write the bead with the pixels around it."""
    stack = tifffile.imread(places["stack.tif"])
    row, column = np.unravel_index(stack.max(axis=0).argmax(), stack.shape[1:])
    near = np.s_[:, row - _BEAD : row + _BEAD + 1, column - _BEAD : column + _BEAD + 1]
    tifffile.imwrite("bead.tif", stack[near], photometric="minisblack")


def constants(facts: list[Facts]) -> Iterator[Row]:
    """Yield the estimated constants beside those that the file's name states."""
    (fact,) = facts
    for name, label, scale, stated in (
        ("NA", "NA", 1.0, 0.85),
        ("pixel", "pixel in the sample, nm", 1e9 / 50.0, 130.0),
    ):
        if name in fact["coefficients"]:
            value, error = fact["coefficients"][name], fact["errors"][name]
            yield Row(label, stated, scale * value, math.nan if error is None else scale * error)


def iso_12233(image: Array, frequencies: tuple[float, ...] = _FREQUENCIES) -> Array:
    """Return the response of a slanted edge by ISO 12233: quarter-pixel bins, Hamming window; nothing of lommel."""
    if np.abs(np.diff(image, axis=0)).sum() > np.abs(np.diff(image, axis=1)).sum():
        image = image.T
    steps, places = np.diff(image, axis=1), np.arange(image.shape[1] - 1) + 0.5
    weights = np.broadcast_to(np.hamming(len(places)), steps.shape)
    for _ in range(4):
        middle = (steps * weights * places).sum(axis=1) / (steps * weights).sum(axis=1)
        weights = np.exp(-(((places - middle[:, None]) / (len(places) / 5.0)) ** 2))
    line = np.polyfit(np.arange(len(image)), middle, 1)
    across = np.arange(image.shape[1]) - np.polyval(line, np.arange(len(image)))[:, None]
    bins = np.round(4.0 * across * math.cos(math.atan(line[0]))).astype(int)
    count = np.bincount((bins - bins.min()).ravel())
    mean = np.bincount((bins - bins.min()).ravel(), image.ravel()) / np.maximum(count, 1)
    full = np.flatnonzero(count > 3)
    profile = np.interp(np.arange(full[0], full[-1] + 1), full, mean[full])
    spread, center = np.gradient(profile), -int(bins.min()) - int(full[0])
    half = min(center, len(spread) - center) - 1
    window = spread[center - half : center + half + 1] * np.hamming(2 * half + 1)
    response = np.abs(np.fft.rfft(window))
    grid = np.fft.rfftfreq(len(window), 0.25)
    # The central difference of bins two apart.
    return np.asarray(np.interp(frequencies, grid, response / response[0] / np.sinc(0.5 * grid)))


def edge_responses(facts: list[Facts]) -> Iterator[Row]:
    """Yield responses beside ISO 12233, and beside the closed form where the edge is a Gaussian of known width."""
    # The width in the file's name is that along rows, of an edge at 16.77655 degrees.
    sigma = 2.101313 * math.cos(math.radians(16.77655)) / math.sqrt(8.0 * math.log(2.0))
    exact = np.exp(-2.0 * (math.pi * sigma * np.array(_FREQUENCIES)) ** 2)
    for name, fact in zip(("sfrmat5", "sfrmat3", "gaussian"), facts, strict=True):
        seen = np.asarray(tifffile.imread(f"{name}.tif"), dtype=float)
        (edge,) = fact["edges"]
        for frequency, known in zip(_FREQUENCIES, exact if name == "gaussian" else iso_12233(seen), strict=True):
            error = edge[f"error_{frequency}"]
            stated = error if error > 1e-6 else math.nan  # of an edge that is drawn, without noise
            yield Row(f"{name}, {frequency} cycles/pixel", float(known), edge[f"at_{frequency}"], stated)


def plane_depths(_: list[Facts]) -> Iterator[Row]:
    """Yield the depth of the plane that was not calibrated on, from the front of the lens."""
    depth, error = np.load("depth.npy"), np.load("error.npy")
    known = np.isfinite(depth) & np.isfinite(error)
    found, stated = (float(np.median(part[known])) if known.any() else math.nan for part in (depth, error))
    yield Row(f"plane at 1.5 m, {100.0 * known.mean():.0f} % of it known", 1.5, found - _PUPIL, stated)


def picasso_movie(places: dict[str, Path]) -> None:
    """Write the movie as TIFF."""
    frames = np.fromfile(places["testdata.raw"], "<u2").reshape(100, 32, 32)
    tifffile.imwrite("movie.tif", frames, photometric="minisblack")
    Path("locs.hdf5").symlink_to(places["testdata_locs.hdf5"])


def matched(
    found: tuple[Array, Array, Array], known: tuple[Array, Array, Array], reach: float
) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Return the indices of points (frame, x, y) and of the nearest known one in the same frame, within reach."""
    apart = np.hypot(found[1][:, None] - known[1], found[2][:, None] - known[2])
    apart[found[0][:, None] != known[0]] = np.inf
    nearest = apart.argmin(axis=1)
    near = apart[np.arange(len(apart)), nearest] < reach
    return np.flatnonzero(near), nearest[near]


def draw_places(frame: Array, ours: Sequence[Array], theirs: Sequence[Array], label: str) -> None:
    """Draw positions (x, y) of lommel and of a reference, pixels from the outer corner, on a frame; to places.png."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(6.4, 5.6), layout="constrained")
    axes = figure.add_subplot()
    height, width = frame.shape
    axes.imshow(frame, cmap="gray", extent=(0.0, width, height, 0.0))
    axes.plot(*theirs, "o", mfc="none", mec="tab:orange", ms=11, mew=1.5, label=label)
    axes.plot(*ours, "+", mec="deepskyblue", ms=9, mew=1.5, label="lommel")
    axes.set(xlim=(0.0, width), ylim=(height, 0.0), xlabel="x (pixels)", ylabel="y (pixels)")
    figure.legend(loc="outside upper center", ncols=2, frameon=False)
    figure.savefig("places.png", dpi=100)


def position_rows(
    found: dict[str, Array], pixel: float, known: tuple[Array, Array, Array], reference: str
) -> Iterator[Row]:
    """Yield how many known positions were found, and the rms difference beside the median standard error.

    `found` has frames, and x, y and their errors in metres; `known` frames and pixels from the outer corner.
    """
    spots = found["frame"], found["x"] / pixel, found["y"] / pixel
    ours, theirs = matched(spots, known, 1.0)
    count = len(known[0])
    yield Row(f"positions of {reference} found", count, float(len(np.unique(theirs))), math.nan)
    for axis, name in enumerate("xy", 1):
        off = spots[axis][ours] - known[axis][theirs]
        stated = float(np.median(found[f"{name}_error"][ours])) / pixel
        yield Row(f"{name}, rms difference, pixels", 0.0, float(np.sqrt(np.mean(off**2))), stated)


def picasso_positions(facts: list[Facts]) -> Iterator[Row]:
    """Yield positions beside Picasso's table, whose origin is the middle of the first pixel."""
    import h5py

    with h5py.File("locs.hdf5") as file:
        table = file["locs"][:]
    table = table[table["frame"] < 100]
    known = table["frame"].astype(float), table["x"] + 0.5, table["y"] + 0.5
    found = {name: np.asarray(facts[-1]["found"].table[name], dtype=float) for name in _COLUMNS}
    brightest = tifffile.imread("movie.tif").max(axis=0).astype(float)
    draw_places(brightest, [found[name] / 160e-9 for name in "xy"], known[1:], "Picasso")
    return position_rows(found, 160e-9, known, "Picasso")


def storm_movie(places: dict[str, Path]) -> None:
    """Write the movie, big-endian integers, as TIFF."""
    frames = np.fromfile(places["test.dax"], ">u2").astype(np.uint16).reshape(10, 256, 256)
    tifffile.imwrite("movie.tif", frames, photometric="minisblack")
    Path("ref.hdf5").symlink_to(places["test_ref.hdf5"])


def storm_positions(_: list[Facts]) -> Iterator[Row]:
    """Yield positions of the first frame beside those that were simulated."""
    import h5py

    with h5py.File("ref.hdf5") as file:
        x, y = (file["fr_0"][name][:].astype(float) for name in "xy")
    with Path("found.csv").open(encoding="utf-8") as file:
        table = [{name: float(cell) for name, cell in row.items()} for row in csv.DictReader(file)]
    first = [row for row in table if row["frame"] == 1.0]
    found = {name: 1e-9 * np.array([row[f"{name} [nm]"] for row in first]) for name in "xy"}
    error = 1e-9 * np.array([row["uncertainty_xy [nm]"] for row in first])
    found |= {"frame": np.ones(len(first)), "x_error": error, "y_error": error}
    known = np.ones(len(x)), x + 0.5, y + 0.5
    corner = tifffile.imread("movie.tif")[0, :100, :100].astype(float)
    draw_places(corner, [found[name] / 160e-9 for name in "xy"], known[1:], "simulated")
    return position_rows(found, 160e-9, known, "the simulation")


def decam_stars(places: dict[str, Path]) -> None:
    """Write the brightest stars of the table, with their background, and where SExtractor saw them."""
    from astropy.io import fits

    table = fits.getdata(places["findstars.fits"], 2)
    middle = table["VIGNET"].shape[1] // 2
    inner = np.s_[middle - _HALF : middle + _HALF + 1]
    whole = [k for k, image in enumerate(table["VIGNET"]) if (image[inner, inner] > -1e29).all()]
    best = sorted(whole, key=lambda k: -table["FLUX_MAX"][k])[:_STARS]
    places_in_window = []
    for number, k in enumerate(best, 1):
        image = (table["VIGNET"][k][inner, inner] + table["BACKGROUND"][k]).astype(np.float32)
        fits.PrimaryHDU(image).writeto(f"star-{number}.fits")
        windowed = [
            float(table[f"{axis}WIN_IMAGE"][k]) - round(float(table[f"{axis}_IMAGE"][k])) + _HALF for axis in "YX"
        ]
        places_in_window.append(windowed)
    np.save("places.npy", places_in_window)


def star_places(facts: list[Facts]) -> Iterator[Row]:
    """Yield rows and columns of the stars beside SExtractor's windowed centroids."""
    for number, (fact, seen) in enumerate(zip(facts, np.load("places.npy"), strict=True), 1):
        for axis, name in enumerate(("row", "column")):
            if "center" in fact:
                yield Row(
                    f"star {number}, {name}", float(seen[axis]), fact["center"][0][axis], fact["errors"][name][0]
                )


PREPARE: dict[str, Callable[[dict[str, Path]], None]] = {
    "bead": bead,
    "lsst": rubin_donuts,
    "decam": decam_stars,
    "picasso": picasso_movie,
    "storm": storm_movie,
}
MEASURE: dict[str, Callable[[list[Facts]], Iterator[Row]]] = {
    "auxtel": change_of_terms,
    "bead": constants,
    "edges": edge_responses,
    "rf50": plane_depths,
    "decam": star_places,
    "lsst": simulated_terms,
    "opticstudio": listed_rms,
    "picasso": picasso_positions,
    "storm": storm_positions,
}
