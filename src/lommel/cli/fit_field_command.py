"""The command ``lommel fit-field``: the wavefront over the field from stars, pinholes or a checkerboard."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

from lommel.base.arrays import plain
from lommel.base.options import In, Options, Shown
from lommel.base.units import format_length, with_error
from lommel.blur.blurs import FWHM, Blur, Jitter, Seeing
from lommel.cli.command import OUTPUT, PLOT, command
from lommel.cli.instruments import CameraNoise
from lommel.cli.messages import report_findings
from lommel.cli.output import progress, require_file, save_figure, written
from lommel.estimation import EFFORT
from lommel.estimation.options import FieldFitOptions
from lommel.report import Facts, Report, Wrapped
from lommel.report.table import tables

if TYPE_CHECKING:
    from lommel.base.arrays import Array
    from lommel.detection.targets import Crossings, PointSources
    from lommel.estimation.field_fit import FieldFit
    from lommel.estimation.phase_retrieval import Retrieval
    from lommel.recorded.counts import Counts

_MOST_CROSSINGS = 100
_ARCSEC = math.pi / 648000.0
_WAVE = 2.0 * math.pi  # radians


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

    def find(self, exposures: Counts, targets: str, radius: float) -> PointSources | Crossings:
        """Return the targets found in the exposures; `radius` is the geometric radius of stars and holes, pixels."""
        from lommel.detection.targets import find_crossings, find_spots

        given: Any = {"threshold": self.threshold, "width": self.width or max(2.0, 0.5 * radius)}
        if targets == "crossing":
            return find_crossings(exposures, window=self.window, most=self.most or _MOST_CROSSINGS, **given)
        side = max(33, 2 * math.ceil(1.4 * radius + 8.0) + 1)
        return find_spots(exposures, window=self.window or side, most=self.most, **given)


@command
def fit_field(
    images: list[Path],
    lens: Path,
    /,
    *,
    options: FieldFitOptions = FieldFitOptions(),
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

    The table serves as file of the section [field], with unit = "waves". The first line is the verdict. A misfit is
    also stated in the first line of the table and by "converged" of --json, and the exit code is 3.

    Parameters
    ----------
    terms
        Number of Zernike terms from Noll 4 on, or names, such as "noll 4, noll 8".
    defocus
        Known defocus C_d of each exposure in radians, such as -3 3; positive where the sensor was moved towards the
        lens. One wave of defocus is C_d = pi. 0 if it is left out.
    targets
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
    import numpy as np

    from lommel.estimation.field_fit import fit_windows, target_of
    from lommel.optics.pupil import Pupil
    from lommel.optics.wavefront.wavefront import Wavefront
    from lommel.recorded.counts import Counts
    from lommel.recorded.frames import read_images
    from lommel.show.drawing import figure_of

    require_file(output, ".csv")
    require_file(twin, ".csv", "--twin")
    target_of(options, 1.0)  # raises ValueError if the size contradicts the targets
    kind = options.targets
    if kind == "star" and options.distortion is not None:
        raise ValueError(
            "--distortion must be left out for stars, whose true positions are unknown; lommel.fit_field accepts "
            "positions of a catalogue as ideal ones"
        )
    if seeing is not None and known_blur is not None:
        raise ValueError("--seeing and --known-blur must not both be given: either is the whole blur")
    instrument = camera.instrument(lens)
    focal_length = instrument.lens.focal_length
    blur: Any = True if known_blur is None else known_blur
    if seeing is not None:
        blur = Seeing.from_fwhm(seeing * _ARCSEC, focal_length)
    with progress("reading") as status:
        read = read_images(images)
        noise, saturation, header = camera.resolve(read.metadata, instrument.camera)
        values = read[...]
        exposures = Counts.of(values, noise=noise, mask=camera.mask_of(values), saturation=saturation)
        if not options.defocus and len(exposures) > 1:
            raise ValueError(f"--defocus must be given for {len(exposures)} exposures: one number each, such as -3 3")
        status(f"finding {kind}s")
        pupil, pitch = instrument.pupil(), float(min(np.atleast_1d(instrument.side)))
        hole = 0.0 if kind == "crossing" or options.size is None else options.size / pitch
        defocused = Pupil(Wavefront(max(map(abs, options.defocus), default=0.0)))
        radius = float(defocused.geometric_radius()) * pupil.scale / pitch + 0.5 * hole  # pixels
        targets = search.find(exposures, kind, radius)
        if spots is not None:
            save_figure(figure_of(targets.plot()), spots)
        if len(targets) < 4:
            raise ValueError(_too_few(kind, targets))
        given: Facts = {"blur": blur}
        if options.distortion is not None:
            given["ideal"] = _grid(targets)
        if options.size is None and math.isfinite(square := getattr(targets, "square", math.nan)):  # of crossings
            given["size"] = square * pitch
        status("fitting")
        result = fit_windows(
            Counts.of(targets.windows, noise=noise, saturation=saturation),
            targets.places,
            pupil,
            sensor=targets.shape,
            pixel=instrument.side,
            noise=None,
            options=replace(options, progress=lambda share, chi2: status(f"chi2 {chi2:.3g}", share), **given),
            effort=EFFORT._replace(integrate=instrument.integrate),
        )
    if output is not None:
        result.save(output)
    if twin is not None:
        result.save(twin, twin=True)
    if figure is not None:
        save_figure(result.plot(), figure)
    note = "" if result.converged else f", of a fit that has not converged: {result.status.replace('_', ' ')}"
    files = written([output, twin, figure, spots], lambda path: note if path in (output, twin) else "")
    facts = _facts(result, targets) | {"notes": [*read.notes, *header]}
    shown: list[Any] = [Wrapped(facts["message"].partition("; ")[0], "bold"), "", *_in_the_middle(facts)]
    for name, wave in facts["waves"].items():
        found, errors = (dict(zip(facts["terms"], wave[key], strict=True)) for key in ("coefficients", "errors"))
        shown += [*tables({f"waves rms, {name}": found, "errors": errors}), ""]
    shown += [*blurs_in_words(result, pitch, focal_length), Wrapped(targets.message)]
    return report_findings(facts, *shown, *tables(facts), "") + files


def _in_the_middle(facts: Facts) -> list[Wrapped]:
    """Return lines on coma and focus in the middle of the sensor."""
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
    return [*map(Wrapped, lines)]


def _grid(targets: PointSources | Crossings) -> Array:
    """Return the positions of pinholes or crossings on their grid, NaN where they are unknown."""
    import numpy as np

    from lommel.detection.targets import Crossings, grid_indices

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
    advice = {
        "saturated": "expose less, below saturation",
        "neighbor": "a smaller --window",
        "edge": "a smaller --window",
        "masked": "check --mask",
        "crossing": "squares must be larger than four times --width, and their contrast above --threshold",
        "star": "lower --threshold, check --offset, or give --width, about the standard deviation of images",
    }
    counts = Counter(point.reason for point in points.refused)
    reason = "saturated" if counts["saturated"] else next((name for name, _ in counts.most_common(1)), targets)
    name = "crossings of a checkerboard" if targets == "crossing" else f"isolated {targets}s"
    known = advice.get(reason, "look at --spots" if counts else advice["star"])
    return f"images must show at least 4 {name}; {points.message}: {known}"


def blurs_in_words(result: FieldFit | Retrieval, pitch: float, focal_length: float | None) -> list[Wrapped]:
    """Return a line on the fitted blurs: the FWHM of seeing at 500 nm, or sigma of a Gaussian in pixels, with errors.

    `pitch` and `focal_length` are in metres. Other blurs are shown as in Python.
    """

    def text(blur: Blur, error: float) -> str:
        if isinstance(blur, Jitter) and blur.across == blur.sigma:
            return f"{blur.sigma / pitch:.3f} +- {error / pitch:.3f} pixels (standard deviation)"
        focal = getattr(blur, "focal_length", None) if focal_length is None else focal_length
        if not isinstance(blur, Seeing) or focal is None:
            return repr(blur)
        width = FWHM / blur.coherence(500e-9) / focal / _ARCSEC  # of long exposures
        outer = "" if blur.outer_scale is None else f" for an outer scale of {format_length(blur.outer_scale)}"
        return f"seeing of {' +- '.join(with_error(width, width * error / blur.r0))} arcsec at 500 nm{outer}"

    pairs = zip(result.blurs, result.blur_errors, strict=True)
    texts = [" and ".join(map(text, blurs, errors)) or "none" for blurs, errors in pairs]
    return [Wrapped(f"blur: {'; '.join(texts)}")] if any(result.blurs) else []


def _values(values: tuple[Array, Array], name: str, unit: float) -> Facts:
    """Return (values, standard errors) in a unit as a dictionary with the keys `name` and "errors"."""
    return {key: (part / unit).tolist() for key, part in zip((name, "errors"), values, strict=True)}


def _facts(result: FieldFit, targets: PointSources | Crossings) -> Facts:
    """Return the results as data that can be written as JSON."""
    import numpy as np

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
