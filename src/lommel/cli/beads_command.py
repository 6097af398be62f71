"""The command ``lommel beads``: the PSF of a microscope from stacks of fluorescent beads."""

from __future__ import annotations

import math
import re
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple

from lommel.base.options import In, Shown
from lommel.base.units import format_length
from lommel.base.validation import line
from lommel.cli.command import OUTPUT, PLOT, command
from lommel.cli.instruments import CameraNoise, header_differences, require_microscope
from lommel.cli.messages import report_findings
from lommel.cli.output import progress, require_file, save_figure, written
from lommel.estimation.options import BeadOptions
from lommel.report import Report, Wrapped
from lommel.report.table import tables

if TYPE_CHECKING:
    from lommel.base.arrays import Values
    from lommel.estimation.beads import BeadFit
    from lommel.fit.findings import Finding
    from lommel.lensfiles.microscope_files import Microscope
    from lommel.recorded.counts import Counts
    from lommel.recorded.frames import Unusable

_FIELD_FACTOR = 1.6  # images whose side exceeds this multiple of the window show a field with several beads
_MAX_BEADS = 20  # largest number of beads that are fitted
_MAX_PITCH_DIFFERENCE = 0.05  # relative: five times the error of the pixel pitch that a fit allows for
_SHAPE = "(beads, planes, height, width)"
_SHARPNESS_SIDE = 9  # side in pixels of the PSF whose sharpness is compared with that of hot pixels


@command
def beads(
    stacks: list[Path],
    lens: Path,
    /,
    *,
    step: Annotated[float | None, Shown(length="nm")] = None,
    options: BeadOptions = BeadOptions(diameter=1e-7),
    window: Annotated[int, In(least=9, most=101)] = 31,
    output: Annotated[Path | None, OUTPUT] = None,
    figure: Annotated[Path | None, PLOT] = None,
    camera: CameraNoise = CameraNoise(),
) -> Report:
    """Estimate aberrations of a microscope from bead stacks.

    STACKS are z stacks (TIFF, OME-TIFF, OME-Zarr, NPY, FITS) of single beads cut out, or of fields in which isolated
    beads are found. LENS is the file of the objective: its section [sample] has the index of the medium of the beads,
    and [aberrations.zernike], if there is one, the start of the search.

    All beads share the aberrations and the constants of the microscope, which are estimated within their usual
    uncertainties. chi2 is about 1 where the model fits. It may be 1 even for a wrong constant: all constants are
    tested, and the first line, the verdict, names those that disagree with the data. The file of -o is a microscope
    file with the fitted numbers, their standard errors, and the verdict as its source. The exit code is 3 if the fit
    did not converge: a misfit, a window without a bead, or planes in reversed order; it is 4 if the fit is in doubt.

    Parameters
    ----------
    step
        Stage step between planes, such as 100nm, positive towards the sample; -100nm if planes were taken the other
        way. By default from the metadata of STACKS, positive.
    diameter
        Diameter of the beads, such as 0.1um.
    depth
        Depth of the centre of the beads below the cover glass; by default their radius: on the glass.
    terms
        Number of Zernike terms from Noll 5 on, or names, such as "noll 5, noll 6".
    apodization
        Number of terms of the pupil amplitude to estimate, 0 to 4: radial Zernike terms of its logarithm.
    window
        Side in pixels of the windows around beads, if a file shows a field of them.
    output
        Microscope file (.toml) with the results, for all other commands.
    figure
        Figure of planes, model, residuals and terms: .png, .pdf or .svg.

    Examples
    --------
      lommel beads beads.tif zeiss-63x-1.4-oil.toml --step 100nm --bead 0.1um --read 1.6 --offset 100 -o mine.toml
      lommel beads field-1.tif field-2.tif zeiss-63x-1.4-oil.toml --step 100nm --read 1.6 --offset 100 --plot fit.png
    """
    import numpy as np

    from lommel.estimation.bead_images import CONSTANTS
    from lommel.estimation.beads import fit_beads
    from lommel.estimation.star_images import label
    from lommel.fit.findings import Finding, Findings
    from lommel.lensfiles.microscope_files import stage_step
    from lommel.recorded.camera_noise import StackView, hot_pixel_findings, hot_pixels
    from lommel.recorded.counts import Counts, counts_of
    from lommel.recorded.frames import combined_metadata, read_each

    require_file(output, ".toml")
    microscope = require_microscope("beads", lens, pixel=camera.pixel, camera=camera.camera)
    notes = [f"Emission at {format_length(microscope.wavelength, digits=4)}."]
    with progress("reading") as status:
        read = list(read_each(tuple(stacks)))
        metadata = combined_metadata([stack.metadata for stack in read])
        noise, saturation, header = camera.resolve(metadata, microscope.camera)
        steps = {stack.metadata.get("step") for stack in read} if step is None else {step}
        used_step = steps.pop() if len(steps) == 1 else None
        if used_step is None:
            raise ValueError("--step is missing: the files do not all state one step between their planes")
        stage_step(used_step)
        if step is None:
            notes.append(f"The step of {format_length(used_step)} between planes is that of the files.")
        recorded, camera_text = camera.recorded(lens, microscope.camera, noise)
        notes += [f"Camera: {camera_text}.", *header]
        windows, pitches, findings = list[_Bead](), dict[str, Finding](), list[Finding]()
        z = (np.arange(len(read[0])) - len(read[0]) // 2) * used_step
        sharpest = _sharpest(microscope, z, options)
        for stack in read:
            file = stack.names[0].removesuffix(" [0]")
            differences = header_differences(stack.metadata, microscope, step)
            if (pitch := differences.pop("pixel", None)) and pitch not in pitches:
                pitches[pitch] = _pitch_finding(pitch, stack.metadata.get("pixel"), microscope)
            notes += [*stack.notes, *(note for note in differences.values() if note not in notes)]
            recorded_planes = stack[...]
            mask = camera.mask_of(recorded_planes)
            ignored = np.broadcast_to(False if mask is None else mask, recorded_planes.shape)
            masked = StackView(recorded_planes, math.inf if saturation is None else saturation, mask=ignored)
            hot = hot_pixels(masked, noise, sharpest, masked.limit)
            prefix = f"{line(file)}: " if len(read) > 1 else ""
            findings += [replace(found, text=f"{prefix}{found.text}") for found in hot_pixel_findings(hot)]
            hidden = ignored | hot
            values = np.ma.masked_array(recorded_planes, hidden) if hidden.any() else recorded_planes
            windows += _beads(file, values, Counts.of(values, noise=noise, saturation=saturation), window, notes)
        cut_out = [bead.window for bead in windows[:_MAX_BEADS]]
        status("fitting")
        result = fit_beads(
            counts_of("stacks", cut_out, noise, sides=(4,), shape=_SHAPE, saturation=saturation),
            microscope,
            z=z,
            options=replace(options, progress=lambda share, chi2: status(f"chi2 {chi2:.3g}", share)),
        )
    result = replace(result, findings=Findings([*pitches.values(), *findings, *result.findings]))
    if output is not None:
        _fitted(microscope, result, used_step).save(output)
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
    keys = dict(zip(facts["coefficients"], result.coefficients, strict=True))
    units = {key: CONSTANTS[name].unit if isinstance(name, str) else "rad" for key, name in keys.items()}
    titles = {key: name if isinstance(name, str) else label(name) for key, name in keys.items()}
    numbers = {name: facts[name] for name in ("coefficients", "errors")} | {"units": units, "places": facts["places"]}
    shown = tables(numbers, titles)
    if widths := facts["fwhm"]:
        nanometres = [{axis: 1e9 * pair[k] for axis, pair in widths.items()} for k in (0, 1)]
        title = "FWHM at the first bead, without bead and pixel"
        shown += ["", *tables({title: nanometres[0], "errors": nanometres[1], "units": dict.fromkeys("xyz", "nm")})]
    verdict = Wrapped(facts["message"].partition("; ")[0], "bold")
    return report_findings(facts, verdict, "", *shown, "") + files


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
    from lommel.fit.findings import Finding

    in_use = microscope.pixel / microscope.objective.magnification
    differs = isinstance(stated, float) and abs(stated - in_use) > _MAX_PITCH_DIFFERENCE * in_use
    text = f"{note[0].lower()}{note[1:-1]}: correct the one that is wrong"
    return Finding("pixel_pitch", "doubt" if differs else "note", text, {"pixel": in_use})


def _sharpest(microscope: Microscope, z: Values, options: BeadOptions) -> float:
    """Return the largest ratio, in a stack of a point, of the brightest pixel and the brightest of its neighbours."""
    from lommel.psf import psf
    from lommel.recorded.camera_noise import sharpness

    depth: Any = 0.5 * options.diameter if options.depth is None else options.depth
    light = {name: getattr(microscope, name) for name in ("wavelength", "emitter", "aberrations")}
    pupil = microscope.objective.pupil(depth=depth, z=z, **light)
    integrate = microscope.integrate is not False
    return sharpness(psf(pupil, _SHARPNESS_SIDE, microscope.pixel, tol=1e-3, integrate=integrate).values)


class _Bead(NamedTuple):
    """A window around a bead, and the position (row, column) of its first pixel in the image."""

    name: str
    window: Values
    corner: tuple[int, int]


def _beads(file: str, planes: Values, counts: Counts, window: int, notes: list[str]) -> list[_Bead]:
    """Return the beads of a stack, and add to `notes` how many were refused.

    A stack that shows a single bead is returned as a whole.
    """
    if max(planes.shape[1:]) <= _FIELD_FACTOR * window:
        return [_Bead(f"{file} [0]", planes, (0, 0))]
    from lommel.detection.targets import find_spots

    spots = find_spots(counts, window=window)
    if not len(spots):
        advice = "a smaller --window may do" if spots.refused else "check --offset and --gain"
        raise ValueError(f"{line(file)}: no isolated bead; {spots.message}: {advice}")
    if spots.refused:
        notes.append(f"{line(file)}: {spots.message}. Beads need {window} pixels for themselves (--window).")
    corners = (spots.places - [side // 2 for side in spots.windows.shape[-2:]]).tolist()
    numbered = enumerate(zip(spots.windows, corners, strict=True))
    return [_Bead(f"{file} [{k}]", values, (row, column)) for k, (values, (row, column)) in numbered]
