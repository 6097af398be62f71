"""The command ``lommel fit-field``: the wavefront over the field from stars, pinholes or a checkerboard."""

from __future__ import annotations

import math
from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING

import click
import numpy as np

from lommel.base.arrays import plain
from lommel.base.units import format_length, with_error
from lommel.blur.blurs import FWHM, Blur, Jitter, Seeing
from lommel.cli.instruments import DEFOCUS_UNIT, IMAGES, LENS, SeveralNumbers, StarCamera, defocus_coefficients
from lommel.cli.options import JSON, OUTPUT, Group, command, documented, option, plot_option
from lommel.cli.output import progress, require_file, save_figure, written
from lommel.detection.targets import Crossings, find_crossings, find_spots, grid_indices
from lommel.estimation.field_fit import TARGET_KINDS
from lommel.estimation.field_fit import fit_field as fit
from lommel.estimation.star_images import label
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.recorded.frames import read_images
from lommel.report import Facts, Parts, Report, Wrapped, paragraphs, table_of
from lommel.show.drawing import figure_of

if TYPE_CHECKING:
    from lommel.base.arrays import Array, Values
    from lommel.detection.targets import PointSources
    from lommel.estimation.field_fit import FieldFit
    from lommel.lensfiles.instrument import Instrument

_MOST_CROSSINGS = 100
_ARCSEC = math.pi / 648000.0
_WAVE = 2.0 * math.pi  # radians
_MAX_LISTED = 12  # largest number of stars left out that are printed one by one


class Chart(Group):
    """Options for the targets in the images."""

    # fmt: off
    targets: str = documented(fit, "targets", type=click.Choice(TARGET_KINDS))
    size: float | None = option(length="um",
        help="Diameter of pinholes or side of squares in the image, such as 8um; by default the side of squares is "
        "measured.")
    # fmt: on

    def side(self, targets: PointSources | Crossings, pitch: float) -> float | None:
        """Return the stated size, or else the measured side of squares, metres; None if there is neither."""
        if isinstance(targets, Crossings) and self.size is None and math.isfinite(targets.square):
            return targets.square * pitch
        return self.size


class FieldModel(Group):
    """Options for estimated and for known quantities."""

    # fmt: off
    degree: int = documented(fit, "degree", type=click.IntRange(0, 6))
    distortion: int | None = option(type=click.IntRange(0, 9), metavar="DEGREE",
        help="Estimate distortion, too: displacements as polynomials of this degree, 3 or 5, from the even grid "
        "of pinholes or squares.")
    terms: int = option(type=click.IntRange(1, 60), default=11, help="Number of Zernike terms from Noll 4 on.")
    defocus: str | None = option(metavar="NUMBERS",
        help="Known defocus of each exposure, such as -3 3; positive where the sensor was moved towards the lens. By "
        "default coefficients C_d in radians; one wave of defocus is C_d = pi. 0 if it is left out.")
    defocus_unit: str = DEFOCUS_UNIT
    known_blur: float | None = option(type=click.FloatRange(0.0), metavar="PIXELS",
        help="Standard deviation of a Gaussian blur, where it is known; by default seeing and a Gaussian are "
        "estimated.")
    seeing: float | None = option(type=click.FloatRange(0.0, 60.0, min_open=True), metavar="ARCSEC",
        help="FWHM of long-exposure seeing (Kolmogorov) at 500 nm, in arcseconds, where it is known.")
    # fmt: on

    def require(self, chart: Chart) -> None:
        """Raise ValueError if options contradict the targets or each other."""
        if chart.targets == "star" and chart.size is not None:
            raise ValueError("--size must be left out for stars, which are points; choose --targets")
        if chart.targets == "star" and self.distortion is not None:
            raise ValueError(
                "--distortion must be left out for stars, whose true positions are unknown; lommel.fit_field accepts "
                "positions of a catalogue as ideal ones"
            )
        if chart.targets == "pinhole" and chart.size is None:
            raise ValueError(
                "--size must be the diameter of the pinholes in the image, such as 8um, for --targets pinhole"
            )
        if self.seeing is not None and self.known_blur is not None:
            raise ValueError("--seeing and --known-blur must not both be given: either is the whole blur")

    def arguments(self, exposures: int, instrument: Instrument) -> Facts:
        """Return the arguments of :func:`lommel.fit_field`, except the arguments of the distortion."""
        if self.defocus is None and exposures > 1:
            raise ValueError(f"--defocus must be given for {exposures} exposures: one number each, such as -3 3")
        blur: float | bool | Seeing = True if self.known_blur is None else self.known_blur
        if self.seeing is not None:
            blur = Seeing.from_fwhm(self.seeing * _ARCSEC, instrument.lens.focal_length)
        defocus = defocus_coefficients(self.defocus or "0", self.defocus_unit, instrument)
        return {"degree": self.degree, "terms": self.terms, "defocus": defocus, "blur": blur}


class Files(Group):
    """Tables and figures to write."""

    # fmt: off
    output: Path | None = option("-o", "--output", type=OUTPUT,
        help="Table for `[field] file =` of the lens file: .csv.")
    twin: Path | None = option(type=OUTPUT,
        help="Table with the other sign of the even terms, which one focus does not determine: .csv.")
    figure: Path | None = plot_option("Figure of the terms over the sensor, stars, models and residuals")
    spots: Path | None = option(type=OUTPUT, help="Figure of the image with the windows used and those refused.")
    # fmt: on

    def require(self) -> None:
        """Raise ValueError if a table is not a .csv file, before anything is computed."""
        require_file(self.output, ".csv")
        require_file(self.twin, ".csv", "--twin")

    def write(self, result: FieldFit) -> Report:
        """Write the requested files of a fit, and return the report of the files."""
        if self.output is not None:
            result.save(self.output)
        if self.twin is not None:
            result.save(self.twin, twin=True)
        if self.figure is not None:
            save_figure(result.plot(), self.figure)
        note = "" if result.converged else f", of a fit that has not converged: {result.status.replace('_', ' ')}"
        tables = (self.output, self.twin)
        return written([*tables, self.figure, self.spots], lambda path: note if path in tables else "")


class Search(Group, heading="Stars and crossings"):
    """Options for finding stars or crossings, and for the windows around them."""

    # fmt: off
    window: int | None = option(type=click.IntRange(9, 401),
        help="Side of the window around a star or crossing, pixels; by default 33, or more as --defocus and --size "
        "need, and 9 to 21 for crossings, as squares allow.")
    threshold: float = documented(find_spots, "threshold", type=float)
    width: float | None = option(type=float,
        help="Standard deviation of the smoothing before the search, pixels; by default 2, or half the radius of "
        "defocused stars (rings) and pinholes.")
    most: int | None = option(type=click.IntRange(1),
        help="Largest number: the brightest stars, or crossings spread over the image (by default 100).")
    # fmt: on

    def find(self, exposures: Values, targets: str, radius: float, recorded: Facts) -> PointSources | Crossings:
        """Return the targets found in the exposures; `radius` is the geometric radius of stars and holes, pixels."""
        arguments = recorded | {"threshold": self.threshold, "width": self.width or max(2.0, 0.5 * radius)}
        if targets == "crossing":
            return find_crossings(exposures, window=self.window, most=self.most or _MOST_CROSSINGS, **arguments)
        side = max(33, 2 * math.ceil(1.4 * radius + 8.0) + 1)
        return find_spots(exposures, window=self.window or side, most=self.most, **arguments)


@command(JSON, kind=SeveralNumbers)
def fit_field(
    images: tuple[Path, ...] = IMAGES,
    lens: Path = LENS,
    chart: Chart = Chart(),
    model: FieldModel = FieldModel(),
    files: Files = Files(),
    search: Search = Search(),
    camera: StarCamera = StarCamera(),
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

    The table serves as file of the section [field], with unit = "waves". The first line is the verdict. A misfit is
    also stated in the first line of the table and by "converged" of --json, and the exit code is 3.

    Examples
    --------
      lommel fit-field stars.fits nifty-fifty.toml --read 2 --degree 3 -o field.csv --plot field.png
      lommel fit-field inside.fits outside.fits nifty-fifty.toml --defocus -3 3 --read 2 -o field.csv
      lommel fit-field chart.tif nifty-fifty.toml --targets crossing --terms 5 --read 2 --saturation 60000
    """
    files.require()
    model.require(chart)
    instrument = camera.instrument_of_file(lens)
    with progress("reading") as status:
        read = read_images(list(images))
        noise, saturation, header = camera.resolve(read.metadata, instrument.camera)
        pupil, focal_length = instrument.pupil(), instrument.lens.focal_length
        arguments = model.arguments(len(read), instrument)
        status(f"finding {chart.targets}s")
        pitch = float(min(np.atleast_1d(instrument.side)))
        hole = 0.0 if chart.targets == "crossing" or chart.size is None else chart.size / pitch
        defocused = Pupil(Wavefront(float(np.abs(arguments["defocus"]).max())))
        radius = float(defocused.geometric_radius()) * pupil.scale / pitch + 0.5 * hole  # pixels
        recorded = {"noise": noise, "mask": camera.mask(read[...]), "saturation": saturation}
        targets = search.find(read[...], chart.targets, radius, recorded)
        if files.spots is not None:
            save_figure(figure_of(targets.plot()), files.spots)
        if len(targets) < 4:
            raise ValueError(_too_few(chart.targets, targets))
        if model.distortion is not None:
            arguments |= {"ideal": _grid(targets), "distortion": model.distortion}
        status("fitting")
        result = fit(
            targets.windows,
            targets.places,
            pupil,
            sensor=targets.shape,
            pixel=instrument.side,
            noise=noise,
            targets=chart.targets,
            size=chart.side(targets, pitch),
            saturation=saturation,
            integrate=instrument.integrate,
            **arguments,
            progress=lambda share, chi2: status(f"chi2 {chi2:.3g}", share),
        )
    facts = _facts(result, targets) | {"notes": [*read.notes, *header]}
    parts = _parts(facts, targets, _describe_blur(result, pitch, focal_length))
    return Report(facts, parts, result.converged) + files.write(result)


def _grid(targets: PointSources | Crossings) -> Array:
    """Return the positions of pinholes or crossings on their grid, NaN where they are unknown."""
    try:
        ideal = targets.indices if isinstance(targets, Crossings) else grid_indices(targets.centers)
    except ValueError:
        ideal = np.full((len(targets), 2), np.nan)
    if (count := int(np.isfinite(ideal[:, 0]).sum())) < 4:
        raise ValueError(
            f"--distortion needs an even grid with neighbours in the image, got {count} on a grid of {len(targets)}"
        )
    return ideal


def _too_few(targets: str, points: PointSources | Crossings) -> str:
    """Return the reason why the images cannot be fitted, with advice."""
    names = {"star": "isolated stars", "pinhole": "isolated pinholes", "crossing": "crossings of a checkerboard"}
    problem = f"images must show at least 4 {names[targets]}; {points.message}"
    counts = Counter(point.reason for point in points.refused)
    if counts["saturated"]:
        return f"{problem}: expose less, below saturation"
    if counts:
        advice = {"neighbor": "a smaller --window", "edge": "a smaller --window", "masked": "check --mask"}
        main_reason = counts.most_common(1)[0][0]
        return f"{problem}: {advice.get(main_reason, 'look at --spots')}"
    if targets == "crossing":
        return f"{problem}: squares must be larger than four times --width, and their contrast above --threshold"
    return (
        f"{problem}: lower --threshold, check --offset, or give --width, about the standard deviation of images in "
        "pixels, or half the radius of rings"
    )


def _seeing_fwhm(seeing: Seeing, focal_length: float) -> float:
    """Return the FWHM of long exposures at 500 nm, arcseconds."""
    return FWHM / seeing.coherence(500e-9) / focal_length / _ARCSEC


def blur_in_words(blur: Blur, error: float, pitch: float, focal_length: float | None) -> str:
    """Return the FWHM of seeing at 500 nm, or sigma of a Gaussian in pixels, with its standard error, as a text.

    `error` is that of r0 or sigma; `pitch` and `focal_length` are in metres. Other blurs are shown as in Python.
    """
    if isinstance(blur, Jitter) and blur.across == blur.sigma:
        return f"{blur.sigma / pitch:.3f} +- {error / pitch:.3f} pixels (standard deviation)"
    if not isinstance(blur, Seeing) or focal_length is None:
        return repr(blur)
    width = _seeing_fwhm(blur, focal_length)
    outer = "" if blur.outer_scale is None else f" for an outer scale of {format_length(blur.outer_scale)}"
    error_text = " +- ".join(with_error(width, width * error / blur.r0))
    return f"seeing of {error_text} arcsec (0.98 wavelengths / r0 at 500 nm{outer})"


def _describe_blur(result: FieldFit, pitch: float, focal_length: float) -> str:
    """Return a sentence on the blur, and on the options that apply it to PSFs."""
    blur_texts, options = [], []
    for blurs, errors in zip(result.blurs, result.blur_errors, strict=True):
        texts, flags = [], []
        for blur, error in zip(blurs, errors, strict=True):
            texts.append(blur_in_words(blur, error, pitch, focal_length))
            if isinstance(blur, Seeing):
                flags.append(f"--seeing {_seeing_fwhm(blur, focal_length):.4g}")
                if blur.outer_scale is not None:
                    flags.append(f"--outer-scale {blur.outer_scale:.3g}m")
            elif isinstance(blur, Jitter):
                flags.append(f"--jitter {blur.sigma / focal_length / _ARCSEC:.3g}")
        blur_texts.append(" and ".join(texts) or "none")
        options.append(" ".join(flags))
    advice = f". The table excludes it: add it by lommel psf {options[0]}, or in Python by the blur of the fit"
    return f"blur: {'; '.join(blur_texts)}{advice if any(result.blurs) else ''}"


def _parts(facts: Facts, targets: PointSources | Crossings, blur: str) -> Parts:
    """Return the verdict, the table of terms in the middle and in a corner, and the stars that were left out."""
    waves, distortion = facts["waves"].values(), facts["distortion"]
    rows = [
        [name, *(f"{values['coefficients'][j]:+.4f} +- {values['errors'][j]:.4f}" for values in waves)]
        for j, name in enumerate(facts["terms"])
    ]
    for j, name in enumerate(("rows", "columns") if distortion else ()):
        displacements = distortion["pixels"].values()
        cells = (f"{values['displacement'][j]:+.3f} +- {values['errors'][j]:.3f}" for values in displacements)
        rows.append([f"distortion of {name}, pixels", *cells])
    lines = []
    if coma := facts["coma"]:
        lines.append(
            f"coma in the middle: {coma['waves']:.4f} +- {coma['error']:.4f} waves rms, axis at "
            f"{coma['degrees']:.0f} degrees from columns to rows"
        )
    if focus := facts["focus"]:
        direction = "towards the lens" if focus["shift"] > 0.0 else "away from the lens"
        shift = " +- ".join(with_error(1e3 * abs(focus["shift"]), 1e3 * focus["error"], most=6))
        sign = ", or as far the other way" if focus["sign_open"] else ""
        lines.append(f"focus in the middle: the sensor is {shift} mm {direction}{sign}")
    refused_points = ({**p, "reason": f"refused, {p['reason']}"} for p in facts["refused"])
    left_out = [
        f"- row {p['row']}, column {p['column']}: {p['reason']}" for p in (*facts["rejected_stars"], *refused_points)
    ]
    if len(left_out) > _MAX_LISTED:
        left_out[_MAX_LISTED:] = [f"- and {len(left_out) - _MAX_LISTED} more, in --json"]
    table = table_of(("term, waves rms", "middle", "bottom right corner"), rows)
    closing_lines = map(Wrapped, (blur, targets.message, *left_out, *facts["notes"]))
    return paragraphs([Wrapped(facts["message"], "bold")], map(Wrapped, lines), [table], closing_lines)


def _values(values: tuple[Array, Array], name: str, unit: float) -> Facts:
    """Return (values, standard errors) in a unit as a dictionary with the keys `name` and "errors"."""
    return {key: (part / unit).tolist() for key, part in zip((name, "errors"), values, strict=True)}


def _facts(result: FieldFit, targets: PointSources | Crossings) -> Facts:
    """Return the results as data that can be written as JSON."""
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
    rows = np.flatnonzero(~stars.used)
    rows = rows[np.argsort(-stars.chi2[rows], kind="stable")]
    return {name: fit[name] for name in names} | {
        "coma": coma and {"waves": coma.rms / _WAVE, "error": coma.error / _WAVE, "degrees": coma.degrees},
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
