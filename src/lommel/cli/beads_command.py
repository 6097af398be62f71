"""The command ``lommel beads``: the PSF of a microscope from stacks of fluorescent beads."""

from __future__ import annotations

import math
import re
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import click
import numpy as np

from lommel.base.units import format_length, with_error
from lommel.base.validation import line
from lommel.cli.instruments import IMAGES, LENS, CameraOptions, header_differences, require_microscope
from lommel.cli.options import JSON, OUTPUT, Group, command, documented, option, plot_option
from lommel.cli.output import progress, require_file, save_figure, written
from lommel.detection.targets import find_spots
from lommel.estimation.bead_images import CONSTANTS, UNITS
from lommel.estimation.beads import fit_beads
from lommel.estimation.star_images import label
from lommel.fit.findings import Finding, Findings
from lommel.lensfiles.microscope_files import stage_step
from lommel.psf import psf
from lommel.recorded.camera_noise import MaskedStack, hot_pixel_findings, hot_pixels, sharpness
from lommel.recorded.frames import combined_metadata, read_each
from lommel.report import Facts, Parts, Report, Wrapped, paragraphs, table_of

if TYPE_CHECKING:
    from lommel.base.arrays import Values
    from lommel.estimation.beads import BeadFit
    from lommel.lensfiles.microscope_files import Microscope
    from lommel.recorded.frames import Unusable
    from lommel.recorded.noise import Noise

_FIELD_FACTOR = 1.6  # images whose side exceeds this multiple of the window show a field with several beads
_MAX_BEADS = 20  # largest number of beads that are fitted
_MAX_PITCH_DIFFERENCE = 0.05  # relative: five times the error of the pixel pitch that a fit allows for
_SHARPNESS_SIDE = 9  # side in pixels of the PSF whose sharpness is compared with that of hot pixels
_MILLIWAVES = 1e3 / (2.0 * math.pi)  # milliwaves per radian


class BeadCamera(CameraOptions, heading="Camera and noise"):
    """Options for the camera of bead stacks, and for finding beads in a field."""

    # fmt: off
    window: int = option(type=click.IntRange(9, 101), default=31,
        help="Side in pixels of the windows around beads, if a file shows a field of them.")
    threshold: float = documented(find_spots, "threshold", type=float)
    # fmt: on


class BeadModel(Group):
    """Options for the planes, the beads, and the estimated quantities."""

    # fmt: off
    step: float | None = option(length="nm",
        help="Stage step between planes, such as 100nm, positive towards the sample; -100nm if planes were taken "
        "the other way. By default from the metadata of STACKS, positive.")
    diameter: float = option("--bead", length="um", default="0.1um",
        help="Diameter of the beads, such as 0.1um.")
    depth: float | None = option(length="um",
        help="Depth of the centre of the beads below the cover glass; by default their radius: on the glass.")
    terms: int = option(type=click.IntRange(1, 200), default=18,
        help="Number of Zernike terms from Noll 5 on.")
    apodization: int = documented(fit_beads, "apodization", type=click.IntRange(0, 4))
    fixed: bool = option("--fixed/--free", default=False,
        help="Fix indices, depth, NA, pixel and bead diameter at their values, or estimate them within the usual "
        "uncertainties.")
    drift: bool = documented(fit_beads, "drift", is_flag=True)
    wavelength: float | None = option(length="nm",
        help="Emission wavelength of the beads; by default from LENS.")
    # fmt: on

    def arguments(self, planes: int, step: float) -> Facts:
        """Return the arguments of :func:`lommel.fit_beads`, for `planes` planes a `step` apart."""
        arguments = {name: getattr(self, name) for name in ("diameter", "depth", "terms", "apodization", "drift")}
        z = (np.arange(planes) - planes // 2) * step
        return arguments | {"z": z, "priors": {} if self.fixed else None}


@command(JSON)
def beads(
    stacks: tuple[Path, ...] = IMAGES,
    lens: Path = LENS,
    model: BeadModel = BeadModel(),
    output: Path | None = option("-o", "--output", type=OUTPUT,
        help="Microscope file (.toml) with the results, for all other commands."),
    figure: Path | None = plot_option("Figure of planes, model, residuals and terms"),
    camera: BeadCamera = BeadCamera(),
) -> Report:  # fmt: skip
    """Estimate aberrations of a microscope from bead stacks.

    STACKS are z stacks (TIFF, OME-TIFF, OME-Zarr, NPY, FITS) of single beads cut out, or of fields in which isolated
    beads are found. LENS is the file of the objective: its section [sample] has the index of the medium of the beads,
    and [aberrations.zernike], if there is one, the start of the search.

    All beads share the aberrations and the constants of the microscope. chi2 is about 1 where the model fits. It may
    be 1 even for a wrong constant: all constants are tested, and the first line, the verdict, names those that
    disagree with the data. The file of -o is a microscope file with the fitted numbers, their standard errors, and
    the verdict as its source. The exit code is 3 if the fit did not converge: a misfit, a window without a bead,
    or planes in reversed order; it is 4 if the fit is in doubt.

    Examples
    --------
      lommel beads beads.tif zeiss-63x-1.4-oil.toml --step 100nm --bead 0.1um --read 1.6 --offset 100 -o mine.toml
      lommel beads field-1.tif field-2.tif zeiss-63x-1.4-oil.toml --step 100nm --read 1.6 --offset 100 --plot fit.png
    """
    require_file(output, ".toml")
    overrides = {"pixel": camera.pixel, "camera": camera.camera, "wavelength": model.wavelength}
    microscope = require_microscope("beads", lens, **overrides)
    optics = {key: getattr(microscope, key) for key in ("objective", "wavelength", "pixel", "emitter", "aberrations")}
    notes = [f"Emission at {format_length(microscope.wavelength, digits=4)}."]
    camera.require()
    with progress("reading") as status:
        read = list(read_each(stacks))
        metadata = combined_metadata([stack.metadata for stack in read])
        noise, saturation, header = camera.resolve(metadata, microscope.camera)
        steps = {stack.metadata.get("step") for stack in read} if model.step is None else {model.step}
        step = steps.pop() if len(steps) == 1 else None
        if step is None:
            raise ValueError("--step is missing: the files do not all state one step between their planes")
        stage_step(step)
        if model.step is None:
            notes.append(f"The step of {format_length(step)} between planes is that of the files.")
        recorded, camera_text = camera.recorded(lens, microscope.camera, noise)
        notes += [f"Camera: {camera_text}.", *header]
        windows, pitches, findings = list[_Bead](), dict[str, Finding](), list[Finding]()
        arguments = model.arguments(len(read[0]), step)
        sharpest = _sharpest(microscope, arguments)
        for stack in read:
            file = stack.names[0].removesuffix(" [0]")
            differences = header_differences(stack.metadata, microscope, model.step)
            if (pitch := differences.pop("pixel", None)) and pitch not in pitches:
                pitches[pitch] = _pitch_finding(pitch, stack.metadata.get("pixel"), microscope)
            notes += [*stack.notes, *(note for note in differences.values() if note not in notes)]
            values = stack[...]
            mask = camera.mask(values)
            ignored = np.broadcast_to(False if mask is None else mask, values.shape)
            masked = MaskedStack(values, math.inf if saturation is None else saturation, mask=ignored)
            hot = hot_pixels(masked, noise, sharpest, masked.limit)
            prefix = f"{line(file)}: " if len(read) > 1 else ""
            findings += [replace(found, text=f"{prefix}{found.text}") for found in hot_pixel_findings(hot)]
            if (ignored := ignored | hot).any():
                values = np.ma.masked_array(values, ignored)
            windows += _beads(file, values, camera, noise, saturation, notes)
        status("fitting")
        result = fit_beads(
            [window.window for window in windows[:_MAX_BEADS]],
            **optics,
            **arguments,
            noise=noise,
            saturation=saturation,
            integrate=microscope.integrate is not False,
            progress=lambda share, chi2: status(f"chi2 {chi2:.3g}", share),
        )
    result = replace(result, findings=Findings([*pitches.values(), *findings, *result.findings]))
    if output is not None:
        _fitted(microscope, result, step).save(output)
    if figure is not None:
        save_figure(result.plot(), figure)
    if len(windows) > _MAX_BEADS:
        notes.append(f"The first {_MAX_BEADS} of {len(windows)} beads were taken.")
    facts = result.to_dict() | {"wavelength": microscope.wavelength, "noise": recorded, "notes": notes, "fwhm": None}
    if result.converged:
        with suppress(ValueError):  # strong aberrations have no single focus
            widths = np.transpose(result.fwhm(depth=result.beads[0].depth)).tolist()
            facts["fwhm"] = dict(zip("xyz", widths, strict=True))
    facts["places"] = [
        fit | {"row": fit["row"] + bead.corner[0], "column": fit["column"] + bead.corner[1]}
        for fit, bead in zip(facts["beads"], windows, strict=False)
    ]
    facts["beads"] = [window.name for window in windows[:_MAX_BEADS]]
    status_text = "" if result.converged else f", of a fit that has not converged: {result.status}"
    files = written([output, figure], lambda path: status_text if path == output else "")
    return Report(facts, _parts(result, facts), result.converged) + files


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


def _pitch_finding(note: str, stated: float | Unusable | None, microscope: Microscope) -> Finding:
    """Return the finding on pixels that the images state, which differ from those in use; a doubt if by far."""
    in_use = microscope.pixel / microscope.objective.magnification
    differs = isinstance(stated, float) and abs(stated - in_use) > _MAX_PITCH_DIFFERENCE * in_use
    text = f"{note[0].lower()}{note[1:-1]}: correct the one that is wrong"
    return Finding("pixel_pitch", "doubt" if differs else "note", text, {"pixel": in_use})


def _sharpest(microscope: Microscope, arguments: Facts) -> float:
    """Return the largest ratio, in a stack of a point, of the brightest pixel and the brightest of its neighbours."""
    depth = 0.5 * arguments["diameter"] if arguments["depth"] is None else arguments["depth"]
    options = {name: getattr(microscope, name) for name in ("wavelength", "emitter", "aberrations")}
    pupil = microscope.objective.pupil(depth=depth, z=arguments["z"], **options)
    integrate = microscope.integrate is not False
    return sharpness(psf(pupil, _SHARPNESS_SIDE, microscope.pixel, tol=1e-3, integrate=integrate).values)


class _Bead(NamedTuple):
    """A window around a bead, and the position (row, column) of its first pixel in the image."""

    name: str
    window: Values
    corner: tuple[int, int]


def _beads(
    file: str, planes: Values, camera: BeadCamera, noise: Noise, saturation: float | None, notes: list[str]
) -> list[_Bead]:
    """Return the beads of a stack, and add to `notes` how many were refused.

    A stack that shows a single bead is returned as a whole.
    """
    if max(planes.shape[1:]) <= _FIELD_FACTOR * camera.window:
        return [_Bead(f"{file} [0]", planes, (0, 0))]
    window, threshold = camera.window, camera.threshold
    spots = find_spots(planes, noise=noise, window=window, threshold=threshold, saturation=saturation)
    if not len(spots):
        advice = "a smaller --window may do" if spots.refused else "lower --threshold, or check --offset and --gain"
        raise ValueError(f"{line(file)}: no isolated bead; {spots.message}: {advice}")
    if spots.refused:
        notes.append(f"{line(file)}: {spots.message}. Beads need {window} pixels for themselves (--window).")
    corners = (spots.places - np.array(spots.windows.shape[-2:]) // 2).tolist()
    numbered = enumerate(zip(spots.windows, corners, strict=True))
    return [_Bead(f"{file} [{k}]", values, (row, column)) for k, (values, (row, column)) in numbered]


def _parts(result: BeadFit, facts: Facts) -> Parts:
    """Return the verdict, and the tables of terms, constants, and beads."""
    terms, constants, beads = (list[tuple[str, ...]]() for _ in range(3))
    for name, value in result.coefficients.items():
        is_constant = isinstance(name, str)
        factor, unit = UNITS[CONSTANTS[name].unit] if is_constant else (_MILLIWAVES, "")
        title = f"{name} ({unit.strip()})" if unit else name if is_constant else label(name)
        cells = title, *with_error(factor * value, factor * result.errors[name], most=9)
        (constants if is_constant else terms).append(cells)
    factors = {"row": 1.0, "column": 1.0, "z": 1e9, "depth": 1e9, "flux": 1.0}
    for name, place, bead in zip(facts["beads"], facts["places"], result.beads, strict=True):
        row = [_with_error(factor, np.mean(place[key]), bead.errors.get(key, 0.0)) for key, factor in factors.items()]
        beads.append((name, *row, f"{place['chi2']:.3f}{'' if place['used'] else ', left out'}"))
    return paragraphs(
        [Wrapped(result.message, "bold")],
        [table_of(("term", "milliwaves rms", "std. error"), terms)],
        [table_of(("constant", "value", "std. error"), constants)] if constants else [],
        [table_of(("bead", "row", "column", "z (nm)", "depth (nm)", "electrons", "chi2"), beads)],
        map(Wrapped, [*_widths(facts["fwhm"]), *facts["notes"]]),
    )


def _widths(widths: Facts | None) -> list[str]:
    """Return the line with the widths of the fitted PSF; an empty list without widths."""
    if widths is None:
        return []
    texts = (f"{_with_error(1e9, *pair)} nm along {axis}" for axis, pair in widths.items())
    return [f"FWHM of the fitted PSF at the first bead, without bead and pixel: {', '.join(texts)}."]


def _with_error(factor: float, value: float, error: float) -> str:
    """Return a number and its standard error, both times a factor; without an estimate (error 0) only the number."""
    return "+-".join(with_error(factor * value, factor * error, most=3)) if error else f"{factor * value:.4g}"
