"""The commands that fit wavefronts: ``retrieve`` (star images), ``fit-field`` (over the field), ``beads``."""

from __future__ import annotations

import errno
import math
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from datetime import date
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, NamedTuple

import numpy as np

from lommel import detection
from lommel.base import atomic, optional, reading
from lommel.base.arrays import Array, Values, plain
from lommel.base.options import In, Options, Shown
from lommel.base.units import ARCSEC, format_length
from lommel.base.validation import line
from lommel.base.validation import wavelength as wavelength_of
from lommel.blur.blurs import Seeing
from lommel.cli.command import OUTPUT, PLOT, command
from lommel.cli.instruments import CameraNoise, require_microscope
from lommel.cli.messages import report_findings, verdict_lines
from lommel.cli.output import Steps, progress, require_file, require_folder, save_figure, written
from lommel.detection.molecules import smoothed
from lommel.estimation import EFFORT
from lommel.estimation.options import BeadOptions, FieldFitOptions, RetrieveOptions
from lommel.fit.findings import Finding, Findings
from lommel.io import zernike_tables
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront, same_path
from lommel.psf import psf
from lommel.recorded.camera_noise import StackView, hot_pixel_findings, hot_pixels, sharpness
from lommel.recorded.counts import Counts, counts_of, flat_top
from lommel.recorded.headers import is_first_row_on_top, without_compared
from lommel.report import Facts, Parts, Report, Wrapped
from lommel.report.table import described, tables

if TYPE_CHECKING:
    from lommel.estimation.beads import BeadFit
    from lommel.estimation.field_fit import FieldFit
    from lommel.estimation.phase_retrieval import Retrieval
    from lommel.lensfiles.microscope_files import Microscope
    from lommel.recorded.frames import Frames
    from lommel.recorded.noise import Noise

_MOST_CROSSINGS = 100
_WAVE = 2.0 * math.pi  # radians
_FIELD_FACTOR = 1.6  # images whose side exceeds this multiple of the window show a field with several beads
_MUCH_LARGER = 1.5  # images whose sides exceed this multiple of the window around a star are cut
_LONG = 45.0  # seconds: fits that take longer are announced
_BEAD_SECONDS = 5e-6  # processor time of the fit of a bead, for each pixel and parameter
_SHAPE = "(beads, planes, height, width)"
_TABLE, _PAGE = "table.csv", "report.html"  # files of a report
_SUFFIXES = ".tif", ".tiff", ".npy", ".fits", ".fit", ".fits.gz", ".zarr"  # stacks in a folder
_SHARPNESS_SIDE = 9  # side in pixels of the PSF whose sharpness is compared with that of hot pixels


@command
def retrieve(
    images: list[Path],
    lens: Path,
    /,
    *,
    options: RetrieveOptions = RetrieveOptions(),
    blur: bool = False,
    window: Annotated[int | None, In(least=9, most=1025)] = None,
    output: Annotated[Path | None, OUTPUT] = None,
    figure: Annotated[Path | None, PLOT] = None,
    camera: CameraNoise = CameraNoise(),
) -> Report:
    """Estimate a wavefront from star images (phase retrieval).

    IMAGES, of a star or another point source, are TIFF (one image per page), OME-Zarr, NPY, FITS (file.fits[SCI]
    selects one of several images) or 16-bit PNG files of one size, linear in light (no JPEG, no sRGB). LENS is a lens
    file with aperture, wavelength, f-number and pixel pitch; its wavefront is the starting point. Several images need
    the --defocus of each (phase diversity). One image leaves the common sign of the even terms (total defocus,
    astigmatism, spherical) undetermined: the solution nearer to the starting point is returned, or the solution whose
    first even term is positive if both are equally near.

    Coefficients are of Zernike terms in Noll's order, normalised to unit rms, in radians with standard errors;
    defocus and spherical by name are C_d and C_s. x grows with the columns and y with the rows: downwards in a
    picture as shown, but upwards in that of a FITS file, unless it states ROWORDER = TOP-DOWN. The reduced
    chi-squared (chi2) is about 1 where pupil, pixel pitch and noise are right. The exit code is 3 for a misfit, and 4
    for a result in doubt.

    Parameters
    ----------
    terms
        Number of Zernike terms from defocus on (Noll 4, 5, ...), or names: "defocus, spherical", "noll 5, noll 6", or
        as printed, "coma x, coma y".
    defocus
        Known defocus C_d of each image in radians, such as -4 0 4, or one for all; of a single image 0 by default.
        Positive where the sensor was moved towards the lens. The phase is 2 C_d rho^2, rho = 1 at the edge of the
        pupil, so that one wave of defocus is C_d = pi.
    also
        Nuisance parameters to estimate jointly: "center, f_number, wavelength, obscuration", or none.
    blur
        Estimate blur by seeing and a Gaussian (jitter, charge diffusion) in each image, for telescopes on the ground.
    window
        Side of the window around the brightest star, pixels; by default 33, or more as --defocus needs, where images
        are larger by half, else the whole image.
    output
        Wavefront as Zernike coefficients in Noll's order: .json, .toml or .csv.
    figure
        Figure of images, model, residuals and terms: .png, .pdf or .svg.

    Examples
    --------
      lommel retrieve star-*.tif phone.toml --defocus -4 0 4 --read 2 -o wave.json --plot fit.png
      lommel retrieve star-1.tif star-2.tif phone.toml --defocus 0 4 --terms "defocus, spherical" --read 2
    """
    # Engines are imported where they run: the help and a misspelt option of one command need none.
    from lommel.estimation.phase_retrieval import fit_stars
    from lommel.estimation.star_images import label
    from lommel.recorded.frames import read_images

    if output is not None:
        zernike_tables.find(output, "--output")
    instrument = camera.instrument(lens, line(lens.name))
    with progress("reading") as status:
        read = read_images(_files(images))
        sizes = float(np.min(instrument.side)), instrument.lens
        noise, saturation, header = camera.resolve(read.metadata, instrument.camera, *sizes)
        stars = read[...]
        if not options.defocus and len(stars) > 1:
            raise ValueError(f"--defocus must be given for {len(stars)} images: one number for each, such as -4 0 4")
        status("fitting")
        pupil = instrument.pupil()
        if instrument.aberrations_of_field is not None:
            header.append("The initial wavefront is that of the lens file on the axis, from its section [field].")
        counts = Counts.of(stars, noise=noise, mask=camera.mask_of(stars), saturation=saturation)
        radius = _defocused_radius(options.defocus, pupil, sizes[0])
        counts, corners = _star_windows(counts, radius, window)
        if counts.values.shape != stars.shape:
            side = counts.values.shape[-1]
            header.append(f"Windows of {side} x {side} pixels around the star were used; --window sets another side.")
        result = fit_stars(
            counts,
            pupil,
            pixel=instrument.side,
            noise=None,
            options=replace(
                options,
                blur=blur,
                progress=lambda share, chi2: status(
                    f"start {int(EFFORT.starts * share) + 1} of at most {EFFORT.starts}, chi2 {chi2:.3g}", share
                ),
            ),
            effort=EFFORT._replace(integrate=instrument.integrate),
        )
    if output is not None:
        result.save(output)
    save_figure(lambda: result.plot(names=list(read.names)), figure)
    files = written([output, figure], lambda path: ": square roots of images and model" if path == figure else "")
    facts = {"images": list(read.names)} | result.to_dict() | {"notes": [*without_compared(read.notes), *header]}
    facts["center"] = (result.center + corners).tolist()
    row, column = (result.center + corners).T.tolist()
    titles = dict(zip(facts["coefficients"], map(label, result.coefficients), strict=True))
    blurs = blurs_in_words(result, instrument.side, None)
    shown = tables(facts | {"row": row, "column": column}, titles)
    return report_findings(facts, *verdict_lines(facts, result.summary), *shown, *blurs, "") + files


def _defocused_radius(defocus: Sequence[float], pupil: Pupil, pixel: float) -> float:
    """Return the geometric radius of the most defocused star, pixels; `pixel` is in metres."""
    most = Pupil(Wavefront(max(map(abs, defocus), default=0.0)))
    return float(most.geometric_radius()) * pupil.scale / pixel


def _window_side(radius: float) -> int:
    """Return the side of the window around a star of this radius, pixels."""
    return max(33, 2 * math.ceil(1.4 * radius + 8.0) + 1)


def _star_windows(counts: Counts, radius: float, window: int | None) -> tuple[Counts, Array]:
    """Return square windows around the brightest star of each image, and their first rows and columns (n, 2).

    Images that are not much larger than the windows are returned as they are, unless a `window` is stated.
    """
    side, shape = window or _window_side(radius), counts.values.shape[1:]
    is_mapped = any(np.ndim(part) for part in vars(counts.noise).values())
    if min(shape) < side or is_mapped or (window is None and min(shape) < _MUCH_LARGER * side):
        return counts, np.zeros((len(counts), 2), int)
    smooth = [smoothed(image, max(2.0, 0.5 * radius)) for image in counts.filled()]
    places = np.array([np.unravel_index(int(np.argmax(image)), image.shape) for image in smooth])
    corners = np.clip(places - side // 2, 0, np.array(shape) - side)
    pixels = [np.s_[k, row : row + side, column : column + side] for k, (row, column) in enumerate(corners.tolist())]
    values, masks = (np.stack([part[one] for one in pixels]) for part in (counts.values, counts.hidden))
    return Counts.of(values, noise=counts.known_noise(), mask=masks, saturation=counts.saturation), corners


def _files(paths: list[Path]) -> list[Path]:
    """Return the files; patterns that the shell has not expanded are expanded in the order of names."""
    files: list[Path] = []
    for path in paths:
        if path.exists() or reading.part_of(path)[1] is not None or not set("*?[") & set(path.name):
            files.append(path)
        elif matches := sorted(path.parent.glob(path.name)):
            files += matches
        else:
            raise FileNotFoundError(errno.ENOENT, "No file matches", str(path))
    return files


@dataclass(frozen=True, kw_only=True)
class Search(Options):
    """Options for finding stars or crossings, and for the windows around them.

    Parameters
    ----------
    window
        Side of the window around a star or crossing, pixels; by default 33, or more as --defocus and --size need, and
        9 to 21 for crossings, as squares allow.
    threshold
        Minimum height of a star or crossing in standard deviations of the noise, at least 3.
    width
        Standard deviation of the smoothing before the search, pixels; by default 2, or half the radius of defocused
        stars (rings) and pinholes.
    most
        Largest number: the brightest stars, or crossings spread over the image (by default 100).
    """

    heading: ClassVar[str] = "Stars and crossings"
    window: Annotated[int | None, In(least=9, most=401)] = None
    threshold: float = 8.0
    width: float | None = None
    most: Annotated[int | None, In(least=1)] = None

    def find(self, exposures: Counts, targets: str, radius: float) -> detection.PointSources | detection.Crossings:
        """Return the targets found in the exposures; `radius` is the geometric radius of stars and holes, pixels."""
        given: Any = {"threshold": self.threshold, "width": self.width or max(2.0, 0.5 * radius)}
        if targets == "crossing":
            return detection.find_crossings(exposures, window=self.window, most=self.most or _MOST_CROSSINGS, **given)
        return detection.find_spots(exposures, window=self.window or _window_side(radius), most=self.most, **given)


@command
def fit_field(
    images: list[Path],
    lens: Path,
    /,
    *,
    options: FieldFitOptions = FieldFitOptions(),
    kind: Annotated[Literal["star", "pinhole", "crossing"], Shown(("--targets",))] = "star",
    known_blur: Annotated[float | None, In(least=0.0), Shown(metavar="PIXELS")] = None,
    seeing: Annotated[float | None, In(above=0.0, most=60.0), Shown(metavar="ARCSEC")] = None,
    output: Annotated[Path | None, OUTPUT] = None,
    twin: Annotated[Path | None, Shown(metavar="FILE", writes=True)] = None,
    figure: Annotated[Path | None, PLOT] = None,
    spots: Annotated[Path | None, Shown(metavar="FILE", writes=True, figure=True)] = None,
    search: Search = Search(),
    camera: CameraNoise = CameraNoise(),
) -> Report:
    """Estimate wavefronts over the field from stars or a chart.

    IMAGES are exposures of one field of stars, or of one chart of pinholes or squares (FITS, TIFF, NPY or 16-bit PNG,
    linear in light, the whole sensor, pixels of one colour); LENS is a lens file with aperture, wavelength, f-number
    and pixel pitch. Isolated stars or crossings are found, and fitted jointly: Zernike terms as polynomials of the
    position, the blur, and the place, flux and background of each target; for crossings also the directions of both
    lines. Several exposures need the --defocus of each. One focus leaves the common sign of all even terms open
    (defocus, astigmatism, spherical): the map nearer to the known --defocus is written, or the map with positive
    defocus in the mean; --twin writes the other map. One exposure well out of focus ("donuts") is enough to
    collimate.

    x and y of terms and tables grow with columns and rows. Corners, and the direction in degrees of the tail of coma,
    counterclockwise from the right, are those of the picture as programs show it: FITS files with the first row at
    the bottom, unless their header states ROWORDER = TOP-DOWN, other files with the first row at the top.

    The table serves as file of the section [field], with unit = "waves". The first line is the verdict. A misfit is
    also stated in the first line of the table and by "converged" of --json, and the exit code is 3.

    Parameters
    ----------
    terms
        Number of Zernike terms from Noll 4 on, or names, such as "noll 4, noll 8".
    defocus
        Known defocus C_d of each exposure in radians, such as -3 3; positive where the sensor was moved towards the
        lens. One wave of defocus is C_d = pi. 0 if it is left out.
    kind
        Point sources, circular holes of one diameter, or corners of a checkerboard, where two lines cross.
    size
        Diameter of pinholes or side of squares in the image, such as 8um; by default the side of squares is measured.
    distortion
        Estimate distortion, too: displacements as polynomials of this degree, 3 or 5, from the even grid of pinholes
        or squares.
    known_blur
        Standard deviation of a Gaussian blur, where it is known; by default seeing and a Gaussian are estimated.
    seeing
        FWHM of long-exposure seeing (Kolmogorov) at 500 nm, in arcseconds, where it is known.
    output
        Table for `[field] file =` of the lens file: .csv.
    twin
        Table with the other sign of the even terms, which one focus does not determine: .csv.
    figure
        Figure of the terms over the sensor, stars, models and residuals: .png, .pdf or .svg.
    spots
        Figure of the image with the windows used and those refused: .png, .pdf or .svg.

    Examples
    --------
      lommel fit-field stars.fits nifty-fifty.toml --read 2 --degree 3 -o field.csv --plot field.png
      lommel fit-field inside.fits outside.fits nifty-fifty.toml --defocus -3 3 --read 2 -o field.csv
      lommel fit-field chart.tif nifty-fifty.toml --targets crossing --terms 5 --read 2 --saturation 60000
    """
    from lommel.estimation.field_fit import fit_targets
    from lommel.recorded.frames import read_images

    require_file(output, ".csv")
    require_file(twin, ".csv", "--twin")
    if kind != "crossing" and (options.size is None) == (kind == "pinhole"):
        raise ValueError("--size must be given for pinholes, and left out for stars, which are points")
    if kind == "star" and options.distortion is not None:
        raise ValueError(
            "--distortion must be left out for stars, whose true positions are unknown; lommel.fit_field accepts "
            "positions of a catalogue as ideal ones"
        )
    if seeing is not None and known_blur is not None:
        raise ValueError("--seeing and --known-blur must not both be given: either is the whole blur")
    instrument = camera.instrument(lens, line(lens.name))
    focal_length = instrument.lens.focal_length
    blur: Any = True if known_blur is None else known_blur
    if seeing is not None:
        blur = Seeing.from_fwhm(seeing * ARCSEC, focal_length)
    with progress("reading") as status:
        read = read_images(images)
        sizes = float(np.min(instrument.side)), instrument.lens
        noise, saturation, header = camera.resolve(read.metadata, instrument.camera, *sizes)
        values = read[...]
        exposures = Counts.of(values, noise=noise, mask=camera.mask_of(values), saturation=saturation)
        if not options.defocus and len(exposures) > 1:
            raise ValueError(f"--defocus must be given for {len(exposures)} exposures: one number each, such as -3 3")
        status(f"finding {kind}s")
        pupil, pitch = instrument.pupil(), float(min(np.atleast_1d(instrument.side)))
        hole = 0.0 if kind == "crossing" or options.size is None else options.size / pitch
        radius = _defocused_radius(options.defocus, pupil, pitch) + 0.5 * hole
        targets = search.find(exposures, kind, radius)
        save_figure(targets.plot, spots)
        if len(targets) < 4:
            raise ValueError(_too_few(kind, targets))
        given: Facts = {"blur": blur}
        if options.distortion is not None:
            given["ideal"] = _grid(targets)
        status("fitting")
        windows = Counts.of(targets.windows, noise=noise, saturation=saturation)
        result = fit_targets(
            replace(targets, windows=windows, noise=None),
            pupil,
            pixel=instrument.side,
            options=replace(options, progress=lambda share, chi2: status(f"chi2 {chi2:.3g}", share), **given),
            effort=EFFORT._replace(integrate=instrument.integrate),
        )
    if output is not None:
        result.save(output)
    if twin is not None:
        result.save(twin, twin=True)
    save_figure(result.plot, figure)
    note = "" if result.converged else f", of a fit that has not converged: {result.status.replace('_', ' ')}"
    files = written([output, twin, figure, spots], lambda path: note if path in (output, twin) else "")
    down = is_first_row_on_top(read.metadata)
    facts = _facts(result, targets, down=down) | {"notes": [*without_compared(read.notes), *header]}
    middle = described({"coma_in_the_middle": facts["coma"], "focus_in_the_middle": facts["focus"]})
    shown: list[Any] = [*verdict_lines(facts, result.summary), *middle, ""]
    for name, wave in facts["waves"].items():
        found, errors = (dict(zip(facts["terms"], wave[key], strict=True)) for key in ("coefficients", "errors"))
        place = {"corner": f"{'bottom' if down else 'top'} right corner"}.get(name, name)
        shown += [*tables({f"waves rms, {place}": found, "errors": errors}), ""]
    shown += [*blurs_in_words(result, pitch, focal_length), Wrapped(targets.message)]
    return report_findings(facts, *shown, *tables(facts), "") + files


def _grid(targets: detection.PointSources | detection.Crossings) -> Array:
    """Return the positions of pinholes or crossings on their grid, NaN where they are unknown."""
    try:
        ideal = (
            targets.indices if isinstance(targets, detection.Crossings) else detection.grid_indices(targets.centers)
        )
    except ValueError:
        ideal = np.full((len(targets), 2), np.nan)
    if (count := int(np.isfinite(ideal[:, 0]).sum())) < 4:
        raise ValueError(
            f"--distortion needs an even grid with neighbours in the image, got {count} on a grid of {len(targets)}"
        )
    return ideal


def _too_few(targets: str, points: detection.PointSources | detection.Crossings) -> str:
    """Return the reason why the images cannot be fitted, with advice."""
    name = "crossings of a checkerboard" if targets == "crossing" else f"isolated {targets}s"
    return f"images must show at least 4 {name}; {points.message}: --spots shows what --threshold and --window leave"


def blurs_in_words(result: FieldFit | Retrieval, pitch: float, focal_length: float | None) -> list[Wrapped]:
    """Return a line on the fitted blurs: the FWHM of seeing at 500 nm, widths in pixels, with errors.

    `pitch` and `focal_length` are in metres.
    """
    from lommel.estimation.field_fit import in_words

    pairs = zip(result.blurs, result.blur_errors, strict=True)
    texts = [in_words(*pair, pitch, focal_length) for pair in pairs]
    return [Wrapped(f"blur: {'; '.join(texts)}")] if any(result.blurs) else []


def _values(values: tuple[Array, Array], name: str, unit: float) -> Facts:
    """Return (values, standard errors) in a unit as a dictionary with the keys `name` and "errors"."""
    return {key: (part / unit).tolist() for key, part in zip((name, "errors"), values, strict=True)}


def _facts(result: FieldFit, targets: detection.PointSources | detection.Crossings, *, down: bool) -> Facts:
    """Return the results as data that can be written as JSON; `down` if the first row is shown at the top."""
    from lommel.estimation.star_images import label

    x, y = result.extent
    positions = {"middle": result.middle, "corner": (x[1], y[1])}
    distortion: Facts | None = None
    if (warp := result.distortion) is not None:
        distortion = {
            "degree": warp.degree,
            "spacing": float(math.hypot(*warp.pose[:, 0])),
            "rotation": float(math.atan2(warp.pose[1, 0], warp.pose[0, 0])),
            "scatter": warp.scatter,
            "pixels": {name: _values(warp.at(*xy), "displacement", 1.0) for name, xy in positions.items()},
        }
    fit, coma, stars = result.to_dict(), result.coma, result.stars
    names = "status", "converged", "reliable", "message", "findings", "chi2", "held_out", "degree", "blur_errors"
    degrees = coma and (-coma.degrees if down else coma.degrees) % 360.0
    rows = np.flatnonzero(~stars.used)
    rows = rows[np.argsort(-stars.chi2[rows], kind="stable")]
    return {name: fit[name] for name in names} | {
        "coma": coma and {"waves": coma.rms / _WAVE, "error": coma.error / _WAVE, "degrees": degrees},
        "focus": result.focus and result.focus._asdict(),
        "distortion": distortion,
        "terms": [label(name) for name in result.names],
        "waves": {name: _values(result.at(*xy), "coefficients", _WAVE) for name, xy in positions.items()},
        "blur": plain(result.blurs),
        "stars": len(stars.used),
        "rejected": len(rows),
        "rejected_stars": [
            {"row": row, "column": column, "reason": f"rejected, chi2 {chi2:.3g}"}
            for (row, column), chi2 in zip(stars.places[rows].astype(int).tolist(), stars.chi2[rows], strict=True)
        ],
        "left_out": targets.left_out,
        "refused": [{"row": point.row, "column": point.column, "reason": point.reason} for point in targets.refused],
    }


@command
def beads(
    stacks: list[Path],
    lens: Path,
    /,
    *,
    step: Annotated[float | None, Shown(length="nm")] = None,
    wavelength: Annotated[tuple[float, ...], Shown(length="nm")] = (),
    options: BeadOptions = BeadOptions(diameter=1e-7),
    window: Annotated[int, In(least=9, most=101)] = 31,
    output: Annotated[Path | None, OUTPUT] = None,
    folder: Annotated[Path | None, Shown(("--report",), metavar="FOLDER", writes=True)] = None,
    figure: Annotated[Path | None, PLOT] = None,
    camera: CameraNoise = CameraNoise(),
) -> Report:
    """Estimate aberrations of a microscope from bead stacks.

    STACKS are z stacks (TIFF, OME-TIFF, OME-Zarr, NPY, FITS) of single beads cut out, or of fields in which isolated
    beads are found; a folder stands for its stacks. LENS is the file of the objective: its section [sample] has the
    index of the medium of the beads, and [aberrations.zernike], if there is one, the start of the search. Stacks of
    several channels have a fit of each channel.

    All beads share the aberrations and the constants of the microscope, which are estimated within their usual
    uncertainties. chi2 is about 1 where the model fits. It may be 1 even for a wrong constant: all constants are
    tested, and the first line, the verdict, names those that disagree with the data. The file of -o is a microscope
    file with the fitted numbers, their standard errors, and the verdict as its source. The exit code is 3 if the fit
    did not converge: a misfit, a window without a bead, or planes in reversed order; it is 4 if the fit is in doubt.

    Parameters
    ----------
    step
        Stage step between planes, such as 100nm, positive if objective and sample approach (each plane is deeper in
        the sample); -100nm for the other order. By default from the metadata of STACKS, positive.
    wavelength
        Emission, such as 520nm; repeated, one for each channel of STACKS. By default that of LENS, or of several
        channels that of STACKS.
    diameter
        Diameter of the beads, such as 0.1um.
    depth
        Depth of the centre of the beads below the cover glass, with a standard error of 20 nm; by default their
        radius: on the glass.
    terms
        Number of Zernike terms from Noll 5 on, or names, such as "noll 5, noll 6".
    apodization
        Number of terms of the pupil amplitude to estimate, 0 to 4: radial Zernike terms of its logarithm.
    joint
        Largest number of beads that determine terms and constants together, evenly chosen from all beads. Of further
        beads, this fit estimates only position, flux and background; --report also fits each bead alone.
    window
        Side in pixels of the windows around beads, if a file shows a field of them.
    output
        Microscope file (.toml) with the results, for all other commands. Of several channels each has a file with
        its wavelength in the name, such as mine-520nm.toml, and so has a figure.
    folder
        Folder of a report: table.csv with a row for each bead, and report.html to print. Further runs with the same
        folder, of other channels and dates, add rows, chromatic shifts and a trend. The date is that in the name of
        a file, such as 2026-12-01, otherwise that of the file; each date has its own fit.
    figure
        Figure of planes, model, residuals and terms: .png, .pdf or .svg.

    Examples
    --------
      lommel beads beads.tif zeiss-63x-1.4-oil.toml --step 100nm --bead 0.1um --read 1.6 --offset 100 -o mine.toml
      lommel beads field-1.tif field-2.tif zeiss-63x-1.4-oil.toml --step 100nm --read 1.6 --offset 100 --plot fit.png
      lommel beads 2026-12-01 zeiss-63x-1.4-oil.toml --step 100nm --bead 0.1um --read 1.6 --offset 100 --report psf
    """
    from lommel.estimation.bead_table import heights
    from lommel.lensfiles.microscope_files import stage_step
    from lommel.recorded.frames import read_each
    from lommel.recorded.headers import combined_metadata, microscope_facts, microscope_findings, told_early

    require_file(output, ".toml")
    stacks = _bead_files(stacks)
    if folder is not None:
        _earlier(folder)  # whose table is refused before the fits
    microscope = require_microscope("beads", lens, pixel=camera.pixel, camera=camera.camera)
    notes = list[str]()
    if options.depth is None and microscope.depth > 0.5 * options.diameter:
        deep = format_length(microscope.depth)
        notes.append(
            f"Beads are taken to touch the cover glass, not to be {deep} deep as the file says; --depth states it."
        )
    with progress("reading") as status:
        read = list(read_each(tuple(stacks), channels=True))
        metadata = combined_metadata([stack.metadata for stack in read])
        noise, saturation, header = camera.resolve(metadata, microscope.camera)
        steps = {stack.metadata.get("step") for stack in read} if step is None else {step}
        used_step = steps.pop() if len(steps) == 1 else None
        if used_step is None:
            raise ValueError("--step is missing: the files do not all state one step between their planes")
        if not isinstance(used_step, float):
            raise ValueError(
                f"--step must be given: the files state {used_step.words} between planes, which is no length in a "
                "known unit"
            )
        stage_step(used_step)
        if step is None:
            notes.append(f"The step of {format_length(used_step)} between planes is that of the files.")
        recorded, camera_text = camera.recorded(lens, microscope.camera, noise)
        notes += [f"Camera: {camera_text}.", *header]
        windows, contradicted, findings = list[_Bead](), dict[str, Finding](), list[Finding]()
        missing = list[tuple[_Source, ValueError]]()
        z = (np.arange(len(read[0])) - len(read[0]) // 2) * used_step
        waves = [_emission(stack, wavelength, microscope) for stack in read]
        devices = {wave: _in_light(microscope, wave) for wave in waves}
        notes.insert(0, f"Emission at {', '.join(format_length(wave, digits=4) for wave in devices)}.")
        sharpest = {wave: _sharpest(device, z, options) for wave, device in devices.items()}
        dates = {} if folder is None else {path.name: _date(path) for path in stacks}
        for stack, wave in zip(read, waves, strict=True):
            file = stack.names[0].removesuffix(" [0]")
            if stack.axes[0] == "T":
                notes.append(f"{line(file)} states {len(stack)} time points, which were taken as planes along z.")
            facts = microscope_facts(microscope.objective, wave)
            lengths, differences = microscope_findings(stack.metadata, microscope.pixel, used_step, **facts)
            contradicted |= {finding.text: finding for finding in lengths}
            notes += [*stack.notes, *(note for note in differences if note not in notes)]
            recorded_planes = stack[...]
            mask = camera.mask_of(recorded_planes)
            ignored = np.broadcast_to(False if mask is None else mask, recorded_planes.shape)
            masked = StackView(recorded_planes, math.inf if saturation is None else saturation, mask=ignored)
            hot = hot_pixels(masked, noise, sharpest[wave], masked.limit)
            channel = f", {stack.metadata['names'][stack.metadata['channel']]}" if "channel" in stack.metadata else ""
            title = f"{line(file)}{channel}"
            prefix = f"{title}: " if len(read) > 1 else ""
            findings += [replace(found, text=f"{prefix}{found.text}") for found in hot_pixel_findings(hot)]
            hidden = ignored | hot
            top, count = flat_top(recorded_planes, ~hidden, noise)
            if count and not top >= masked.limit:
                hidden = hidden | (recorded_planes >= top)
                text = (
                    f"{prefix}{count} pixels have exactly the largest value, {top:.10g}, taken as saturated: "
                    "--saturation states another limit"
                )
                findings.append(Finding("saturation_assumed", "note", text))
                status.tell(f"{text}.")
            values = np.ma.masked_array(recorded_planes, hidden) if hidden.any() else recorded_planes
            counts = Counts.of(values, noise=noise, saturation=saturation)
            source = _Source(file, wave, dates.get(file, ""))
            try:
                windows += _beads(source, title, values, counts, window, notes)
            except ValueError as failure:
                missing.append((source, failure))
        if not windows:
            raise missing[0][1]
        told_early(list(contradicted.values()))
        status("fitting")
        groups = dict[tuple[str, float], list[_Bead]]()
        for bead in windows:
            groups.setdefault((bead.source.date, bead.source.wavelength), []).append(bead)
        several, several_days = len(devices) > 1, len({day for day, _ in groups}) > 1
        names = {
            (day, wave): ", ".join([day] * several_days + [_nanometres(wave)] * several)
            for day in ("", *dates.values()) for wave in devices
        }  # fmt: skip
        # Fits of a bead: that of all beads takes as long as those of its beads.
        total = sum(min(len(one), options.joint) + (0 if folder is None else len(one)) for one in groups.values())
        columns = 12 + (options.terms if isinstance(options.terms, int) else len(options.terms))
        if (expected := _BEAD_SECONDS * windows[0].window.size * columns * total) > _LONG:
            fewer = ", fewer with --terms 7" if columns > 12 + 7 else ""
            status.tell(f"Fits of {len(windows)} beads: about {expected / 60.0:.0f} min of a processor{fewer}.")
        fits, refusals = _Fits(status, options, z, noise, saturation, total), _Refusals(status, names)
        for source, why in missing:
            refusals.refuse(source, [source.file], why)
        rows, table, told = list[Facts](), dict[str, Any](), dict[tuple[str, float], _BeadReport]()
        # Microscopes change between days; the shortest wavelength of the newest day is the last.
        for (day, wave), group in sorted(groups.items(), key=lambda one: (one[0][0], -one[0][1])):
            try:
                joint = fits.fit(group, devices[wave])
            except ValueError as failure:
                if len(groups) == 1:
                    raise
                for file, source in {bead.source.file: bead.source for bead in group}.items():
                    refusals.refuse(source, [bead.name for bead in group if bead.source.file == file], failure)
                continue
            files_of = [bead.source.file for bead in group]
            relative = heights(joint.z_covariance, np.array([bead.z for bead in joint.beads]), files_of)
            report = _BeadReport(lens.stem, devices[wave], joint, group, relative, noise, used_step)
            told = {key: of for key, of in told.items() if key[0] == day} | {(day, wave): report}
            if folder is not None:
                if not joint.reliable:
                    status.tell(f"{': '.join(filter(None, (names[day, wave], joint.message)))}.")
                table = report.write(folder, report.rows(fits.of_each(report, refusals)), _earlier(folder))
                rows += table["table"]
        if not told:
            raise ValueError("; ".join(one.text for one in refusals.findings))
        if refusals.rows and folder is not None:
            rows += report.write(folder, refusals.rows, _earlier(folder))["table"]
    day, wave, result = *list(told)[-1], report.result
    if several_days:
        notes.append(f"Each date has its own fit, of which that of {day} is told.")
    if several:
        notes.append(f"Each channel has its own fit, of which that of {_nanometres(wave)} is told.")
    others = [
        replace(one, text=f"{names[key]}: {one.text}")
        for key, of in told.items() if of is not report
        for one in of.result.findings if one.severity != "note"
    ]  # fmt: skip
    if name := names[day, wave]:
        own = [replace(one, text=f"{name}: {one.text}") for one in result.findings]
        result = replace(result, findings=Findings(own), summary=f"{name}: {result.summary}")
    found_all = [*contradicted.values(), *findings, *result.findings, *others, *refusals.findings]
    result = replace(result, findings=Findings(found_all))
    fitted = {light: of.result for (_, light), of in told.items()}
    outputs, figures = ({_of_channel(path, one, several): one for one in fitted if path} for path in (output, figure))
    saved = fitted | {wave: result}
    for path, light in outputs.items():
        _fitted(devices[light], saved[light], used_step).save(path)
    for path, light in figures.items():
        save_figure(saved[light].plot, path)
    facts = result.to_dict() | {"wavelength": wave, "noise": recorded, "notes": notes, "fwhm": None}
    if several:
        keys = "wavelength", "status", "message", "coefficients", "errors"
        each = [fitted[light].to_dict() | {"wavelength": light} for light in sorted(fitted)]
        facts["channels"] = [{key: fit[key] for key in keys} for fit in each]
    if result.converged:
        with suppress(ValueError):  # strong aberrations have no single focus
            widths = np.transpose(result.fwhm(depth=result.beads[0].depth)).tolist()
            facts["fwhm"] = dict(zip("xyz", widths, strict=True))
    facts["places"] = report.places(facts["beads"])
    facts["beads"] = [bead.name for bead in report.windows]
    if folder is not None:
        facts["report"] = plain(table | {"table": rows})
    pages = [] if folder is None else [folder / _TABLE, folder / _PAGE]
    doubts = {path: fitted[light].status for path, light in outputs.items() if not fitted[light].converged}
    doubts = {path: f", of a fit that has not converged: {status}" for path, status in doubts.items()}
    files = written([*outputs, *figures, *pages], lambda path: doubts.get(path, ""))
    parts = [Wrapped(f"{_nanometres(light)}: {fitted[light].message}") for light in sorted(fitted) if light != wave]
    return report_findings(facts, *verdict_lines(facts, result.summary), *parts, *_tables(facts, result), "") + files


def _tables(facts: Facts, result: BeadFit) -> Parts:
    """Return the tables of the coefficients, of the places of beads, and of the FWHM if there is a focus."""
    from lommel.estimation.bead_images import CONSTANTS
    from lommel.estimation.star_images import label

    keys = dict(zip(facts["coefficients"], result.coefficients, strict=True))
    units = {key: CONSTANTS[name].unit if isinstance(name, str) else "rad" for key, name in keys.items()}
    titles = {key: name if isinstance(name, str) else label(name) for key, name in keys.items()}
    if untested := result.findings.get("untested"):
        # Their priors say more of these constants than the beads do.
        by_priors = titles.keys() & {name for name, changes in untested.numbers.items() if not changes}
        titles |= {name: f"{name} (by its prior)" for name in by_priors}
    shown = tables({name: facts[name] for name in ("coefficients", "errors")} | {"units": units}, titles)
    shown += ["", *_places(facts["places"], facts["beads"])]
    if widths := facts["fwhm"]:
        nanometres = [{axis: 1e9 * pair[k] for axis, pair in widths.items()} for k in (0, 1)]
        title = "FWHM at the first bead, without bead and pixel"
        shown += ["", *tables({title: nanometres[0], "errors": nanometres[1], "units": dict.fromkeys("xyz", "nm")})]
    return shown


def _nanometres(wavelength: float) -> str:
    return f"{1e9 * wavelength:.0f} nm"


def _of_channel(path: Path, wavelength: float, several: bool) -> Path:
    """Return the path of the file of a channel, of `several` with the wavelength in its name."""
    return path.with_name(f"{path.stem}-{1e9 * wavelength:.0f}nm{path.suffix}") if several else path


def _emission(stack: Frames, stated: tuple[float, ...], microscope: Microscope) -> float:
    """Return the wavelength of a stack: as stated, that of its file if it is one channel of several, or of LENS."""
    names = stack.metadata["names"] if "channel" in stack.metadata else [""]
    number, file = stack.metadata.get("channel", 0), line(stack.names[0].removesuffix(" [0]"))
    texts = f"{len(names)} channels, {', '.join(names)}" if len(names) > 1 else "one channel"
    if stated:
        if len(stated) != len(names):
            raise ValueError(f"--wavelength must be one for each channel: {file} has {texts}, got {len(stated)}")
        return wavelength_of(stated[number], "--wavelength")
    if len(names) == 1:
        return microscope.wavelength
    (wave,) = stack.metadata["emission"]
    if not isinstance(wave, float):
        raise ValueError(f"--wavelength must be given for each channel: {file} has {texts}, without their emission")
    return wavelength_of(wave, f"the emission that {file} states")


def _in_light(microscope: Microscope, wavelength: float) -> Microscope:
    """Return the microscope at a wavelength, with equal paths of its aberrations."""
    aberrations = microscope.aberrations
    if aberrations is not None:
        aberrations = same_path(aberrations, microscope.wavelength, wavelength)
    return replace(microscope, wavelength=wavelength, aberrations=aberrations)


def _places(fits: list[Facts], names: list[str]) -> Parts:
    """Return the table of where beads are and of their light, with standard errors, planes taken together."""
    units = {"z": "nm", "height": "nm", "depth": "nm", "flux": "electrons", "background": "electrons"}
    factors = {"row": 1.0, "column": 1.0, "z": 1e9, "height": 1e9, "depth": 1e9, "flux": 1.0, "background": 1.0}
    known = {k: factor for k, factor in factors.items() if all(k in fit["errors"] for fit in fits)}

    def columns(numbers: list[Facts]) -> Facts:
        used = [one if fit["used"] else None for one, fit in zip(numbers, fits, strict=True)]
        return {
            k: [None if one is None or one[k] is None else f * float(np.mean(one[k])) for one in used]
            for k, f in known.items()
        }

    values, errors = columns(fits), columns([fit["errors"] for fit in fits])
    beads = [f"{name}, chi2 {fit['chi2']:.3g}" for name, fit in zip(names, fits, strict=True)]
    if all(error is None for error in errors.get("depth", [0.0])):  # the priors tell it better than the beads do
        key = "depth (by its prior)"
        units |= {key: units["depth"]}
        values, errors = ({key if k == "depth" else k: v for k, v in part.items()} for part in (values, errors))
    return tables({"images": beads, "errors": errors, "units": units} | values, first="bead")


def _fitted(microscope: Microscope, result: BeadFit, step: float) -> Microscope:
    """Return the fitted microscope; depth, planes and window are those of the first bead, not those of its file."""
    # Sources of example files end in the list of their values that are examples; those written here are not.
    source = re.sub(r"\s*[A-Z][a-z, ]* are examples\.$", "", microscope.source)
    planes, *shape = result.beads[0].images.shape
    return replace(
        microscope.fitted(result), name=f"{microscope.name}, fitted to beads",
        source=f"{source} Fitted to beads: {result.message}.".lstrip(),
        depth=result.beads[0].depth, planes=planes, step=step, origin="brightest", shape=tuple(shape),
    )  # fmt: skip


def _sharpest(microscope: Microscope, z: Values, options: BeadOptions) -> float:
    """Return the largest ratio, in a stack of a point, of the brightest pixel and the brightest of its neighbours."""
    depth: Any = 0.5 * options.diameter if options.depth is None else options.depth
    light = {name: getattr(microscope, name) for name in ("wavelength", "emitter", "aberrations")}
    pupil = microscope.objective.pupil(depth=depth, z=z, **light)
    integrate = microscope.integrate is not False
    return sharpness(psf(pupil, _SHARPNESS_SIDE, microscope.pixel, tol=1e-3, integrate=integrate).values)


class _Source(NamedTuple):
    """A channel of a file by its emission, and the date of its fit, "" without a report."""

    file: str
    wavelength: float
    date: str


class _Bead(NamedTuple):
    """A window around a bead, the position (row, column) of its first pixel in the image, and where it is from."""

    name: str
    window: Values
    corner: tuple[int, int]
    source: _Source


def _bead_files(paths: list[Path]) -> list[Path]:
    """Return the stacks, those in folders sorted by name; ValueError for a folder without one."""
    found = list[Path]()
    for path in paths:
        if not path.is_dir() or any((path / name).exists() for name in ("zarr.json", ".zgroup", ".zattrs")):
            found.append(path)
            continue
        inside = sorted(one for one in path.iterdir() if one.name.lower().endswith(_SUFFIXES))
        if not inside:
            raise ValueError(f"{line(path.name)} has no stacks: TIFF, NPY, FITS or OME-Zarr")
        found += inside
    return found


def _date(path: Path) -> str:
    """Return the date in the name of a file, otherwise that of the file: 2026-12-01."""
    for year, month, day in re.findall(r"(?<!\d)((?:19|20)\d\d)[-_.]?(\d\d)[-_.]?(\d\d)(?!\d)", path.name):
        with suppress(ValueError):
            return date(int(year), int(month), int(day)).isoformat()
    return date.fromtimestamp(path.stat().st_mtime).isoformat()


def _earlier(folder: Path) -> list[dict[str, Any]]:
    """Return the rows of earlier runs with this folder of a report; ValueError if it is not one."""
    from lommel.report.bead_page import read_csv

    optional.require("matplotlib", "nothing was computed: a report needs", "plot")
    require_folder(folder)
    return read_csv(folder / _TABLE) if (folder / _TABLE).exists() else []


class _BeadReport(NamedTuple):
    """What a report on beads has in it: the fit of all of them, their windows, relative heights and noise."""

    lens: str
    microscope: Microscope
    result: BeadFit
    windows: list[_Bead]
    heights: tuple[Array, Array]
    noise: Noise
    step: float

    def places(self, fits: list[Facts]) -> list[Facts]:
        """Return the fits of beads with their places in the image and, if all have one, their relative heights."""
        places = [
            fit | {"row": fit["row"] + bead.corner[0], "column": fit["column"] + bead.corner[1]}
            for fit, bead in zip(fits, self.windows, strict=True)
        ]
        if np.isfinite(self.heights[0][[bead.used for bead in self.result.beads]]).all():
            for place, height, error in zip(places, *map(plain, self.heights), strict=True):
                place["height"], place["errors"] = height, place["errors"] | {"height": error}
        return places

    def rows(self, fits: Iterable[BeadFit]) -> list[Facts]:
        """Return the rows of the beads, by the fit of each of them alone."""
        from lommel.estimation.bead_table import codes_of, place_of, row_of, with_shared

        result, microscope, rows = self.result, self.microscope, list[Facts]()
        depth = float(np.median([bead.depth for bead in result.beads if bead.used] or [result.beads[0].depth]))
        for k, (bead, window, fit) in enumerate(zip(result.beads, self.windows, fits, strict=True)):
            row = row_of(fit, self.noise, self.step, self.pixel, window.corner)
            heights = [None if math.isnan(part[k]) else float(part[k]) for part in self.heights]
            rows.append(
                {"bead": window.name, "file": window.source.file, "date": window.source.date}
                | {"wavelength": microscope.wavelength}
                | (with_shared(row, result, depth) if fit.converged and fit.beads[0].used else row)
                | place_of(bead, result, self.pixel, window.corner)
                | {"height": heights[0], "height_error": heights[1], "flux": float(bead.flux.sum())}
                | {"joint_fit": result.message, "joint_codes": codes_of(result.findings)}
            )
        return rows

    @property
    def pixel(self) -> float:
        """Stated pixel, the same for all beads and channels: errors of estimates would shift beads far from row 0."""
        return self.microscope.pixel / self.microscope.objective.magnification

    def write(self, folder: Path, rows: list[Facts], earlier: list[dict[str, Any]]) -> dict[str, Any]:
        """Write table and page, with the rows of earlier runs but those of the same files; return their numbers."""
        from lommel.estimation.bead_table import focal_surface, middle_of
        from lommel.report.bead_page import page, write_csv

        result, microscope = self.result, self.microscope
        pixel, name = self.pixel, microscope.name or self.lens
        same = {(row["file"], row["wavelength"], row["date"]) for row in rows}
        kept = [row for row in earlier if (row["file"], row["wavelength"], row["date"]) not in same]
        waves = sorted({row["wavelength"] for row in (*kept, *rows)})
        newest = max(row["date"] for row in (*kept, *rows))
        files = dict.fromkeys(row["file"] for row in (*kept, *rows) if row["date"] == newest)
        facts = [
            ("objective", name),
            ("NA, immersion", f"{microscope.objective.NA:.4g}, {microscope.objective.immersion:.4g}"),
            ("emission", ", ".join(format_length(wave, digits=4) for wave in waves)),
            ("pixel in the sample", format_length(pixel, digits=4)),
            ("step between planes", format_length(abs(self.step), digits=4)),
            (
                f"diameter of beads, estimated at {format_length(microscope.wavelength, digits=4)}",
                format_length(result.diameter, digits=3),
            ),
            ("files of this date", ", ".join(files)),
            ("date", newest),
        ]
        title, notes = f"Beads: {name}", [f"{one.severity}: {one.text}" for one in result.findings]
        folder.mkdir(exist_ok=True)
        write_csv(folder / _TABLE, [*kept, *rows])
        text = page(title, facts, [*kept, *rows], notes)
        atomic.write(folder / _PAGE, text.encode())
        return {"table": rows, "surface": focal_surface(rows, middle_of(rows))}


class _Refusals:
    """What cannot be fitted: told at once, as findings, and as rows of the report; the others are fitted."""

    def __init__(self, status: Steps, names: Mapping[tuple[str, float], str]) -> None:
        self._status, self._names = status, names  # names of groups of beads
        self.findings, self.rows = list[Finding](), list[Facts]()

    def tell(self, text: str) -> Finding:
        """Tell what is left out, and return the finding on it."""
        self.findings.append(Finding("left_out", "doubt", text))
        self._status.tell(f"{text}.")
        return self.findings[-1]

    def of(self, name: str, source: _Source) -> str:
        """Return the name of a file or bead with that of its group."""
        return line(", ".join(filter(None, (name, self._names[source.date, source.wavelength]))))

    def refuse(self, source: _Source, beads: Iterable[str], error: ValueError) -> None:
        """Refuse the beads of a file and channel."""
        is_named = str(error).startswith(line(source.file))
        self.tell(f"refused: {error}" if is_named else f"refused: {self.of(source.file, source)}: {error}")
        known = {"file": source.file, "date": source.date, "wavelength": source.wavelength}
        self.rows += [{"bead": one, **known, "verdict": "refused", "reason": str(error)} for one in beads]


@dataclass
class _Fits:
    """Fits of beads of one recording, with the progress of all, `total` in number."""

    status: Steps
    options: BeadOptions
    z: Values
    noise: Noise
    saturation: float | None
    total: int
    done: int = 0

    def fit(self, beads: list[_Bead], model: Microscope, times: float = 1.0, name: str = "", **known: Any) -> BeadFit:
        """Return the fit of beads together; the step between planes is `times` the stated step."""
        from lommel.estimation.beads import fit_beads

        before, part, windows = self.done, min(len(beads), self.options.joint), [bead.window for bead in beads]
        self.done += part

        def show(share: float, chi2: float) -> None:
            self.status(f"{name}chi2 {chi2:.3g}", (before + part * share) / self.total)

        counts = counts_of("stacks", windows, self.noise, sides=(4,), shape=_SHAPE, saturation=self.saturation)
        return fit_beads(counts, model, z=times * self.z, options=replace(self.options, progress=show, **known))

    def of_each(self, report: _BeadReport, refusals: _Refusals) -> Iterator[BeadFit]:
        """Yield the fit of each bead alone; one that shows two beads, or has none, is left out of the report."""
        result, beads, diameter = report.result, report.windows, report.result.diameter
        # Bad constants are bad for each bead: fits of single beads would find that again.
        if not result.converged or len(beads) == 1:
            yield from (replace(result, beads=(bead,)) for bead in result.beads)
            return
        # The constants of all beads are nearer to the truth than the stated ones.
        alone, times = report.microscope.fitted(result), float(result.coefficients.get("step", 1.0))
        for k, (bead, fitted) in enumerate(zip(beads, result.beads, strict=True), 1):
            of_bead = replace(result, beads=(fitted,))
            if fitted.used:
                try:
                    of_bead = self.fit([bead], alone, times, f"bead {k} of {len(beads)}, ", diameter=diameter)
                except ValueError as error:
                    of = refusals.of(bead.name, bead.source)
                    found = refusals.tell(f"{of}, left out, though part of the fit of all beads: {error}")
                    of_bead = replace(result, beads=(replace(fitted, used=False),), findings=Findings([found]))
            yield of_bead


def _beads(source: _Source, title: str, planes: Values, counts: Counts, window: int, notes: list[str]) -> list[_Bead]:
    """Return the beads of a stack, and add to `notes`, with a title, how many were refused.

    A stack that shows a single bead is returned as a whole.
    """
    if max(planes.shape[1:]) <= _FIELD_FACTOR * window:
        return [_Bead(f"{source.file} [0]", planes, (0, 0), source)]
    spots = detection.find_spots(counts, window=window)
    if not len(spots):
        advice = "a smaller --window may do" if spots.refused else "check --offset and --gain"
        raise ValueError(f"{title}: no isolated bead; {spots.message}: {advice}")
    if spots.refused:
        notes.append(f"{title}: {spots.message}. Beads need {window} pixels for themselves (--window).")
    corners = (spots.places - [side // 2 for side in spots.windows.shape[-2:]]).tolist()
    numbered = enumerate(zip(spots.windows, corners, strict=True))
    return [_Bead(f"{source.file} [{k}]", values, (row, column), source) for k, (values, (row, column)) in numbered]
