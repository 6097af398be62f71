"""The command ``lommel localize``: molecules of a movie in three dimensions, in a table."""

from __future__ import annotations

import dataclasses
import math
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeGuard

import click
import numpy as np
from rich.text import Text

from lommel.base.units import format_length
from lommel.base.validation import line
from lommel.cli.instruments import (
    CAMERA,
    DEPTH,
    EXCESS,
    LENS,
    SQUARE_PIXEL,
    camera_map,
    differing,
    microscope_of,
    noise_of,
    take_header,
)
from lommel.cli.options import (
    JSON,
    MICROMETRES,
    OUTPUT,
    PATH,
    WINDOW,
    Option,
    command,
    documented,
    plot_option,
    under,
)
from lommel.cli.output import Facts, Report, Wrapped, list_of, require_folder, save_figure, written
from lommel.cli.progress import progress
from lommel.io import registry
from lommel.localize import Localizations, Movie, Table, find, fit, localize_blocks, open_movie, writer
from lommel.localize.detection import DEFECT, frame_counts
from lommel.localize.fitting import STATES
from lommel.localize.localizations import joined
from lommel.localize.movie_fits import Recurrence, likelier
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.recorded.counts import flat_tops
from lommel.recorded.movies import BLOCK
from lommel.recorded.noise import Noise

if TYPE_CHECKING:
    from rich.console import RenderableType

    from lommel.lensfiles.camera import Camera
    from lommel.lensfiles.microscope_files import Microscope

_Z = {"z": (-0.7e-6, 0.7e-6), "depth": (0.0, 1e-6)}


_CAMERA = under(
    "Camera",
    CAMERA,
    Option("--gain", "white", metavar="NUMBER|FILE",
           help="Electrons per count; by default that of the camera, or 1. A file (.tif, .npy) is a map with a value "
           "for each pixel, also of --read and --offset."),
    Option("--read", metavar="NUMBER|FILE",
           help="Read noise, rms electrons; 0 for none; by default that of the camera."),
    Option("--offset", metavar="NUMBER|FILE",
           help="Counts of a pixel without electrons, such as 100; by default that of the camera, or 0."),
    EXCESS,
    documented(find, "saturation", type=float,
               help="Value in the file at which pixels saturate, such as 60000; they do not count in fits."),
    SQUARE_PIXEL,
)  # fmt: skip


@command(
    click.Argument(["movie"], type=PATH),
    LENS,
    Option("-o", "--output", "outputs", type=OUTPUT, required=True, multiple=True,
           help=f"Table of molecules: {registry.suffixes('molecules', described=True)}; may be repeated."),
    plot_option("Picture of the molecules, coloured by z"),
    *_CAMERA,
    *under(
        "Molecules",
        Option("--z", type=MICROMETRES, nargs=2, metavar="FROM TO",
               help="Range of z, such as -0.7um 0.7um, which it is by default; with --along depth 0um 1um."),
        documented(Table, "along", type=click.Choice(("z", "depth"))),
        Option("--flat", is_flag=True,
               help="Estimate x and y alone, for images that do not tell z, as without astigmatism."),
        DEPTH,
        Option("--box", "shape", type=WINDOW, default="15",
               help="Pixels of the boxes that are fitted, such as 15 or 15x17, at least 5 a side."),
        documented(find, "threshold", type=float),
        documented(localize_blocks, "width", type=float,
                   help="Standard deviation in pixels by which frames are smoothed to find spots; by default that of "
                   "the images of molecules."),
    ),
    *under(
        "Fits",
        documented(Table, "reach", type=float, default=3.0),
        documented(Table, "tol", type=float),
        documented(fit, "starts", type=int),
        documented(fit, "threads", type=int),
        documented(localize_blocks, "block", type=int,
                   help="Frames in memory at once; by default as many as have four million pixels."),
    ),
    JSON,
)  # fmt: skip
def localize(
    movie: Path,
    lens: Path,
    outputs: tuple[Path, ...],
    figure: Path | None,
    camera: Camera | None,
    white: str | None,
    read: str | None,
    offset: str | None,
    pixel: float | None,
    depth: float | None,
    z: tuple[float, float] | None,
    along: str,
    shape: int | tuple[int, int],
    reach: float,
    tol: float,
    threads: int | None,
    **given: Any,
) -> Report:
    """Localise the molecules of a movie in three dimensions.

    MOVIE is a TIFF, OME-TIFF, OME-Zarr, FITS or NPY file of any length, as the camera recorded it. LENS is the file
    of an objective with a section [aberrations.zernike], such as astigmatism: it describes the images of molecules at
    the depth of the file (or --depth), from which positions are fitted by maximum likelihood.

    x and y are in the sample, from the outer corner of the first pixel along columns and rows. z is the position of
    the stage at which a molecule at this depth would look so, positive towards the sample: molecules deeper in the
    sample have a smaller z. With --along depth it is the depth of the molecule below the cover glass, the stage at
    rest at the origin of the file. Fits that end at the range of z (--z) or beyond --reach, or do not converge, are
    counted, not written. Drift is not corrected, and molecules seen in several frames are a row in each. The exit
    code is 3 where no molecule is written, or where the opposite sign of the astigmatism is likelier.

    Examples
    --------
      lommel localize movie.tif zeiss-63x-astigmatic.toml --read 1.6 --offset 100 -o found.csv --plot found.png
      lommel localize movie.tif zeiss-63x-astigmatic.toml --read 1.6 --offset dark.tif --z -0.5um 0.5um -o a.hdf5
    """
    for path in outputs:
        registry.find("molecules", path, "--output")
        require_folder(path)
    if movie.suffix.lower() == ".toml" != lens.suffix.lower():
        raise ValueError(f"the order is MOVIE LENS, the movie first, got {line(movie)} and then {line(lens)}")
    side = shape if isinstance(shape, int) else min(shape)
    if side < _LEAST_SIDE:
        raise ValueError(
            f"--box must be at least {_LEAST_SIDE} pixels a side, got {side}: smaller boxes do not hold "
            "the image of a molecule; 15 is the default"
        )
    microscope = microscope_of(lens, camera=camera, pixel=pixel, depth=depth)
    if microscope is None:
        raise ValueError(f"lommel localize needs a microscope, a file with a section [objective]; {lens} has none")
    texts = {"white": ("gain", white), "read": ("read", read), "offset": ("offset", offset)}
    maps: Facts = {name: text and camera_map(text, flag) for name, (flag, text) in texts.items()}
    maps["excess"] = given.pop("excess")
    begun = time.perf_counter()
    parts: list[Localizations] = []
    ends, seen = 0, Recurrence()
    with progress("table of images") as step, open_movie(movie) as frames:
        maps["saturation"] = given["saturation"]
        header = [*frames.notes, *take_header(maps, frames.said, microscope.camera)]
        header += differing(frames.said, microscope)
        given["saturation"] = maps.pop("saturation")
        noise = noise_of(maps, microscope.camera)
        table = Table(
            dataclasses.replace(microscope, planes=1).pupil(),
            shape,
            microscope.pixel,
            z=_Z[along] if z is None else z,
            along=along,
            reach=reach,
            tol=tol,
            threads=threads,
        )

        def done(count: int, total: int) -> None:
            step(f"frame {count} of {total}", count / total)

        with writer(*outputs) as write:
            for part in localize_blocks(frames, table, noise=noise, threads=threads, progress=done, **given):
                write(part)
                ends += _at_ends(part, table)
                seen.count(part)
                parts.append(part if figure is not None else _brief(part))
        dark, flat_tops = _first(frames, noise, table.shape, given["saturation"])
        flat = given.pop("flat")
        turned = None if flat else _turned(frames, table, microscope, noise=noise, threads=threads, **given)
    found = joined(parts)
    if figure is not None:
        drawn: Any = found.plot().get_figure(root=True)
        save_figure(drawn, figure)
    facts: Facts = {"movie": str(movie), "name": microscope.name, "source": microscope.source}
    facts |= {"aberrations": microscope.aberrations is not None}
    facts |= {"camera": None if microscope.camera is None else microscope.camera.name}
    facts |= _facts(found, table, ends, time.perf_counter() - begun)
    own = microscope.camera
    values = {} if own is None else {"gain": (white, own.gain), "offset": (offset, own.offset)}
    facts |= {"assumed": [name for name, pair in values.items() if pair == (None, None)]}
    facts |= {"recurring": seen.places(), "opposite_astigmatism": turned}
    facts |= {"notes": [*header, *([f"{flat_tops}."] if flat_tops else []), *_notes(facts, microscope, dark)]}
    places = [place for path in outputs for place in registry.find("molecules", path).places(path)]
    trusted = facts["written"] > 0 and not _is_opposite(turned)
    return Report(facts, _parts(facts, noise), trusted) + written([*places, figure])


_MEDIANS = ("photons", "background", "x_deviation", "y_deviation", "z_deviation", "discrepancy")


def _brief(part: Localizations) -> Localizations:
    """Return localisations with what the report needs alone, for long movies."""
    names = ["state", *_MEDIANS]
    kinds = [(name, np.int32 if name == "state" else np.float32) for name in names]
    kept = np.empty(len(part), np.dtype(kinds))
    for name in names:
        kept[name] = part.table[name]
    return dataclasses.replace(part, table=kept)


def _at_ends(part: Localizations, table: Table) -> int:
    """Return how many fits are at an end of the range of z; all others at a border are beyond the reach."""
    return int(np.isin(part.table["z"][part.table["state"] == _BORDER], table.z).sum())


def _first(frames: Movie, noise: Noise, box: tuple[int, int], saturation: float | None) -> tuple[float, str]:
    """Return of the first frames the share of counts below the offset, and what to say of their largest value."""
    _, rows, columns = frames.shape
    first = frames.frames(0, min(len(frames), max(1, BLOCK // (rows * columns))))
    told = flat_tops([frame_counts(first, box, saturation)], noise, "movie")
    return float(np.mean(first < noise.offset)), told


def _turned(
    frames: Movie, table: Table, microscope: Microscope, *, block: int | None, **options: Any
) -> Facts | None:
    """Return by how much molecules of the first frames are likelier with astigmatism of the opposite sign."""
    told = microscope.aberrations
    if told is None or not any(abs(m) == 2 for _, m in told.amplitudes()):
        return None
    edge = {(n, m): -one if abs(m) == 2 else one for (n, m), one in zip(told.terms, told.edge.T, strict=True)}
    opposite = dataclasses.replace(microscope, planes=1, aberrations=Wavefront.from_edge(edge, told.error))
    made: Facts = {name: getattr(table, name) for name in ("z", "along", "reach", "tol")}
    other = Table(opposite.pupil(), table.shape, table.pixel, **made)
    count, gain, error = likelier(frames, table, other, block=block, **options)
    if count < _LEAST_TRIED:
        return None
    return {"molecules": count, "log_likelihood": gain, "deviation": error}


def _is_opposite(turned: Facts | None) -> TypeGuard[Facts]:
    """Return whether the opposite sign is likelier beyond doubt."""
    return turned is not None and turned["log_likelihood"] > max(_LIKELIER, 4.0 * turned["deviation"])


def _notes(facts: Facts, microscope: Microscope, dark: float) -> list[str]:
    """Return what is likely to be wrong, in sentences."""
    notes, told = [], microscope.aberrations
    if facts["saturated"]:
        notes.append(
            f"{facts['saturated']} pixels of boxes are saturated and do not count; --saturation states from which "
            "value on."
        )
    if facts["left_out"]:
        notes.append(f"{facts['left_out']} pixels of boxes are NaN or infinite and do not count.")
    if not facts["spots"]:
        notes.append("No spot is above --threshold: check --offset, --gain and --read, or lower it.")
    if places := facts["recurring"]:
        row, column, count = places[0]
        many = "A spot is" if len(places) == 1 else f"{len(places)} spots are"
        notes.append(
            f"{many} in the same place in many frames, the first in {count} of {facts['frames']} at row {row}, "
            f"column {column}: a bead, or a hot pixel, which a map by --read with {DEFECT:g} electrons there leaves "
            "out."
        )
    plain = not any(n % 2 == 0 and (n, m) != (2, 0) for n, m in ({} if told is None else told.amplitudes()))
    if plain and facts["along"] != "none":
        notes.append(f"{_PLAIN if told is None else _ODD}: {_ALIKE}")
    finest = microscope.objective.nyquist(wavelength=microscope.wavelength).lateral
    if facts["pixel_in_sample"] < _FINE * finest:
        notes.append(
            f"A pixel is {format_length(facts['pixel_in_sample'], digits=3)} in the sample, far below Nyquist's "
            f"{format_length(finest, digits=3)}: the pixel, of the file or by --pixel, is that of the camera, before "
            "magnification."
        )
    if dark > _DARK:
        notes.append(f"{100 * dark:.0f} % of the counts of the first frames are below the offset: check --offset.")
    sources = "neither the option nor the file of the camera gives it"
    notes += [f"The {name} is taken to be {_ASSUMED[name]}: {sources}." for name in facts["assumed"]]
    if _is_opposite(turned := facts["opposite_astigmatism"]):
        notes.append(
            f"{turned['molecules']} molecules of the first frames are likelier with astigmatism of the opposite sign "
            f"(log-likelihood {turned['log_likelihood']:.3g} +- {turned['deviation']:.2g} larger), and z is then "
            "reversed: check the sign in [aberrations.zernike] and the direction of the movie's rows."
        )
    ends = facts["border_fits"]["z"]
    if facts["along"] != "none" and ends > _MANY * facts["spots"]:
        notes.append(f"{ends} of {facts['spots']} spots are at an end of the range of z: a wider --z may hold them.")
    value = facts["medians"]["discrepancy"]
    if value is not None and abs(value) > max(_DISCREPANT, 4.0 * _error_of_median(facts)):
        why = (
            "the gain or the offset may be wrong: check --gain and --offset"
            if value < 0.0
            else "the PSF (sign of the astigmatism, depth, indices, wavelength), the gain or the offset may be wrong"
        )
        notes.append(f"The median discrepancy, {value:.2g}, is not 0 within its error: {why}.")
    return notes


def _error_of_median(facts: Facts) -> float:
    """Return the standard error of the median discrepancy, each being normal of unit variance."""
    return math.sqrt(0.5 * math.pi / max(1, facts["written"]))


def _facts(found: Localizations, table: Table, ends: int, seconds: float) -> Facts:
    kept = found.table[found.converged]
    flat = found.recording.along == "none"
    told = [name for name in _MEDIANS if not (flat and name == "z_deviation")]
    medians = {name: float(np.median(kept[name])) if kept.size else None for name in told}
    return {
        "frames": found.recording.frames,
        "shape": [found.recording.rows, found.recording.columns],
        "pixel_in_sample": _rounded(found.recording.pixel),
        "spots": found.spots,
        "borders": found.borders,
        "overlapping": found.overlapping,
        "saturated": found.saturated,
        "left_out": found.left_out,
        "states": found.counts,
        "border_fits": {"z": ends, "reach": found.counts["border"] - ends},
        "written": kept.size,
        "medians": medians,
        "along": found.recording.along,
        "z": [_rounded(end) for end in table.z],
        "table_error_bound": table.error_bound,
        "seconds": seconds,
    }


def _rounded(length: float) -> float:
    """Return a length without the digits that divisions leave."""
    return float(f"{length:.12g}")


def _parts(facts: Facts, noise: Noise) -> list[RenderableType]:
    """Return the table of what was found, and what was not corrected."""
    n, (rows, columns) = facts["frames"], facts["shape"]
    units = {
        "white": ("gain", " electrons per count"),
        "offset": ("offset", ""),
        "read": ("read noise", " electrons"),
    }
    values = {key: 1.0 if (value := getattr(noise, key)) is None else value for key in units}
    told = ", ".join(
        f"{name} {f'{values[key]:g}{unit}' if isinstance(values[key], float) else 'by a map'}"
        for key, (name, unit) in units.items()
    )
    told = told if facts["camera"] is None else f"{facts['camera']}, {told}"
    left = f"left out {facts['borders']} at borders and {facts['overlapping']} beside brighter ones"
    counts = facts["border_fits"] | facts["states"]
    others = ", ".join(f"{counts[name]} {words}" for name, words in _OTHERS.items() if counts[name])
    low, high = (format_length(end, like=1e-6) for end in facts["z"])
    what = {"depth": "depth", "none": "not told"}.get(facts["along"], "position of the stage")
    lines = [
        (
            "movie",
            f"{n} frame{'s' * (n != 1)} of {rows} x {columns}, {format_length(facts['pixel_in_sample'])} a pixel",
        ),
        ("camera", told),
        ("spots", f"{facts['spots']}; {left}"),
        ("localised", f"{facts['written']}{f'; not written: {others}' if others else ''}"),
        ("z", f"{low} to {high}, {what}"),
        *_of_medians(facts["medians"], _error_of_median(facts)),
        ("table of images", f"each value within {facts['table_error_bound']:.2g} of the dimmest plane's largest"),
        ("time", f"{facts['seconds']:.3g} s"),
    ]
    notes = [*map(Wrapped, facts["notes"]), Wrapped("Drift is not corrected.", "dim")]
    return [Text(facts["name"], "bold"), list_of(lines), *notes]


_LEAST_SIDE = 5  # pixels of a box
_BORDER = STATES.index("border")
_FINE = 0.1  # of Nyquist's pixel
_DARK = 0.75  # of the counts: half are below where there is no light
_DISCREPANT = 0.3  # smaller ones are of imperfections that every PSF has
_MANY = 0.1  # of the spots
_ASSUMED = {"gain": "1 electron per count", "offset": "0 counts"}
_LEAST_TRIED = 10  # molecules, of which the spread is known
_LIKELIER = 10.0  # log-likelihood, by which one of two wavefronts must be the likelier to be spoken of
_PLAIN = "The file of the objective has no section [aberrations.zernike]"
_ODD = "The wavefront of the objective has no even term besides defocus, such as astigmatism"
_ALIKE = "images above and below focus are nearly alike, and z may have the wrong sign; --flat gives x and y alone."
_OTHERS = {
    "z": "at an end of the range of z (--z)",
    "reach": "farther from the middle of their box than --reach",
    "steps": "without convergence",
    "undetermined": "undetermined",
}


def _of_medians(medians: dict[str, float | None], error: float) -> list[tuple[str, str]]:
    if any(value is None for value in medians.values()):
        return []
    sides = [name for name in "xyz" if f"{name}_deviation" in medians]
    each = ", ".join(f"{name} {format_length(medians[f'{name}_deviation'] or 0.0, digits=3)}" for name in sides)
    return [
        ("median light", f"{medians['photons']:.4g} photons, background {medians['background']:.3g} a pixel"),
        ("median precision", f"{each} (Cramer-Rao bound)"),
        ("median discrepancy", f"{medians['discrepancy']:.2g} (0 +- {error:.1g} where PSF and noise are right)"),
    ]
