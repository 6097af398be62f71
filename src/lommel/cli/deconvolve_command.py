"""The command ``lommel deconvolve``: the stack of a microscope restored, from file to file."""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np
from rich.text import Text

from lommel.base.units import format_length
from lommel.base.validation import line
from lommel.cli.instruments import (
    EXCESS,
    LENS,
    SQUARE_PIXEL,
    camera_map,
    camera_option,
    mask_of,
    microscope_of,
    noise_of,
)
from lommel.cli.options import (
    JSON,
    LENGTHS,
    MICROMETRES,
    NANOMETRES,
    OUTPUT_PATH,
    PATH,
    Option,
    command,
    documented,
    plot_option,
    under,
    with_options,
)
from lommel.cli.output import Facts, Report, Wrapped, figure_format, list_of, require_folder, save_figure, written
from lommel.cli.progress import progress
from lommel.imaging.deconvolution import NOISE, STEPS, RichardsonLucy, TotalVariation
from lommel.microscopy import restore
from lommel.microscopy.deconvolution import FLAT
from lommel.microscopy.depth_model import MODALITIES
from lommel.microscopy.refinement import PARAMETERS
from lommel.microscopy.restoration import INTERRUPTED, MISFIT, between
from lommel.recorded import recordings
from lommel.recorded.noise import Noise

if TYPE_CHECKING:
    from lommel.lensfiles.camera import Camera

METHODS = ("richardson-lucy", "total-variation")
_STACK = click.Path(path_type=Path)  # a file, or a folder of OME-Zarr


@command(
    click.Argument(["stack"], type=_STACK),
    LENS,
    Option("-o", "--output", "outputs", type=OUTPUT_PATH, required=True, multiple=True,
           help="Restored stack: .ome.tif or .ome.zarr; may be repeated."),
    plot_option("Figure of projections before and after, and of the residual"),
    *under(
        "Microscope",
        Option("--depth", type=MICROMETRES,
               help="Depth below the cover glass in focus in the middle plane, such as 10um; by default that of the "
               "file of the objective."),
        Option("--wavelength", type=LENGTHS, metavar="LENGTHS",
               help="Emission, such as 520nm, or one for each channel: 520nm,610nm; by default that of the stack."),
        SQUARE_PIXEL,
        Option("--step", type=NANOMETRES, help="Step between planes, such as 200nm; by default that of the stack."),
        Option("--modality", type=click.Choice(MODALITIES), default="widefield", help="Kind of microscope."),
        Option("--excitation", type=NANOMETRES, help="Excitation wavelength of scanning microscopes, such as 488nm."),
        documented(restore, "pinhole", type=float, help="Diameter of the pinhole in Airy units."),
        Option("--thickness", type=MICROMETRES, help="Thickness of the light sheet, such as 2um (FWHM)."),
        Option("--direction", type=click.Choice(("auto", "up", "down")), default="auto",
               help="up: the first plane is the nearest to the cover glass; auto asks the data."),
    ),
    *under(
        "Camera",
        camera_option("Camera with the noise of the stack: name of an example or a file; options below come first."),
        Option("--gain", "white", metavar="NUMBER|FILE",
               help="Electrons per count; by default estimated from the stack. A file (.tif, .npy) is a map, also of "
               "--read and --offset."),
        Option("--read", metavar="NUMBER|FILE", help="Read noise, rms electrons."),
        Option("--offset", metavar="NUMBER|FILE", help="Counts of a pixel without electrons, such as 100."),
        EXCESS,
        Option("--saturation", type=float, help="Counts from which on pixels are saturated."),
        Option("--mask", "masked", type=PATH,
               help="Image of the pixels to leave out: not 0 there; one for all planes, or one for each."),
    ),
    *under(
        "Restoration",
        Option("--method", type=click.Choice(METHODS), default=METHODS[0],
               help="Richardson-Lucy maximises the likelihood; total variation also smooths and preserves edges, in "
               "three dimensions, and takes a few times as long."),
        Option("--steps", type=click.IntRange(1, 100_000), help="Number of steps, instead of stopping at the noise."),
        Option("--strength", type=float,
               help="Weight of the total variation; by default such that the result agrees with the noise."),
        Option("--background", default=FLAT, metavar="flat|uneven|COUNTS",
               help="Light that is not of the specimen: estimated as one level, or one that varies over the field; "
               "or a known level above the offset, 0 for none. It is no part of the output."),
        documented(restore, "slabs", type=click.IntRange(1, 64),
                   help="Number of PSFs over the depth of the stack; by default as many as are needed."),
        Option("--refine", multiple=True, type=click.Choice(PARAMETERS),
               help="Estimate this from the stack first; may be repeated."),
        Option("--diagnosis/--no-diagnosis", default=True,
               help="Hold photons out, to find the background and to compare PSFs of other indices of the sample; "
               "try other PSFs after a misfit. Without it a stack takes half of the time, or less."),
        Option("--per-plane", is_flag=True,
               help="State the light that is collected in one plane, rather than in all planes of the PSF."),
        Option("--channel", type=click.IntRange(0), help="Channel, from 0; by default all."),
        Option("--time", "time_point", type=click.IntRange(0), help="Time point, from 0."),
        Option("--axes", help='Axes of the file where it does not say, such as "ZYX".'),
        Option("--tile", type=click.IntRange(16), help="Side of chunks in pixels; by default what --memory holds."),
        Option("--memory", type=float, default=2.0, help="Gigabytes that may be used besides the stack."),
        documented(restore, "threads", type=click.IntRange(1), help="Number of threads; by default all processors."),
    ),
    JSON,
)  # fmt: skip
def deconvolve(
    stack: Path,
    lens: Path,
    outputs: tuple[Path, ...],
    figure: Path | None,
    wavelength: tuple[float, ...] | None,
    pixel: float | None,
    camera: Camera | None,
    white: str | None,
    read: str | None,
    offset: str | None,
    excess: float | None,
    masked: Path | None,
    method: str,
    steps: int | None,
    strength: float | None,
    background: str,
    refine: tuple[str, ...],
    time_point: int | None,
    memory: float,
    **given: Any,
) -> Report:
    """Deconvolve the stack of a microscope (3-D deconvolution).

    STACK is an OME-TIFF, a TIFF of ImageJ or a folder of OME-Zarr, or with --axes NPY or FITS, as the camera recorded
    it; LENS is the file of the objective. Voxel sizes, channels and wavelengths are those of STACK. The PSF depends
    on the depth where the sample and the immersion differ. Iterations stop where the result agrees with the recording
    within its noise; a misfit is said, and has exit code 3. Whether another PSF agrees better is tested with
    photons that are held out.

    The output has the voxel sizes of the stack. An output .ome.zarr alone is written chunk by chunk, for stacks
    larger than memory; the same command goes on where it was interrupted. Ctrl-C keeps the steps that are done.

    Examples
    --------
      lommel deconvolve stack.ome.tif zeiss-63x-1.4-oil.toml --depth 8um -o restored.ome.tif --plot restored.png
      lommel deconvolve stack.ome.tif zeiss-63x-1.4-oil.toml --gain 0.46 --read 1.6 --offset 100 -o restored.ome.zarr
    """
    for path in outputs:
        if path.suffix.lower() in (".png", ".pdf", ".svg"):
            raise ValueError(f"a stack must end in .ome.tif or .ome.zarr, got {line(path)}; --plot writes a picture")
        recordings.kind_of(path, stack)
        require_folder(path)
    if figure is not None:
        figure_format(figure)
    if stack.suffix.lower() == ".toml" != lens.suffix.lower():
        raise ValueError(f"the order is STACK LENS, the stack first, got {line(stack)} and then {line(lens)}")
    microscope = microscope_of(lens)
    if microscope is None:
        raise ValueError(f"lommel deconvolve needs a microscope, a file with a section [objective]; {lens} has none")
    texts = {"white": (white, "gain"), "read": (read, "read"), "offset": (offset, "offset")}
    maps: dict[str, Any] = {
        name: None if text is None else camera_map(text, flag) for name, (text, flag) in texts.items()
    }
    maps["excess"] = excess
    noise = None
    if camera is not None:
        noise = noise_of(maps, camera)
    elif any(each is not None for each in maps.values()):
        if maps["read"] is None:
            raise ValueError(
                "--read must be given with --gain, --offset or --excess: electrons of read noise, 0 for none"
            )
        noise = Noise(**{name: each for name, each in maps.items() if each is not None})
    mask = None
    if masked is not None:
        with recordings.open_recording(stack, time=time_point, axes=given["axes"]) as opened:
            mask = mask_of(masked, np.broadcast_to(False, opened.shape[1:]))
    whole = outputs[0] if len(outputs) == 1 and recordings.kind_of(outputs[0]) == "zarr" else None
    begun = time.perf_counter()
    with _kept(whole), progress("reading") as step:
        found = restore(
            stack,
            microscope,
            wavelength=None if wavelength is None else list(wavelength),
            pixel=pixel,
            noise=noise,
            mask=mask,
            refine=refine,
            method=_method(method, steps, strength),
            background=_background(background),
            time=time_point,
            memory=1e9 * memory,
            out=whole,
            progress=lambda share, words: step(words, share),
            **given,
        )
        if whole is None:
            step("writing")
            found.save(*outputs)
        if figure is not None:
            step("drawing")
            save_figure(found.plot(), figure)
    facts = {"stack": str(stack), "name": microscope.name} | found.to_dict()
    facts |= {"notes": [with_options(note) for note in found.notes], "seconds": time.perf_counter() - begun}
    return Report(facts, _parts(facts), converged=found.converged) + written([*outputs, figure])


def _method(name: str, steps: int | None, strength: float | None) -> RichardsonLucy | TotalVariation | None:
    """Return the method that the options describe."""
    if name == METHODS[1]:
        return TotalVariation(strength=strength, steps=steps or TotalVariation.steps, target=1.0)
    if strength is not None:
        raise ValueError(f"--strength needs --method {METHODS[1]}")
    return None if steps is None else RichardsonLucy(steps=steps, target=0.0)


def _background(text: str) -> float | str:
    """Return a number, or the text."""
    try:
        return float(text)
    except ValueError:
        return text


@contextmanager
def _kept(place: Path | None) -> Iterator[None]:
    """Say after Ctrl-C that the chunks of a folder are kept."""
    try:
        yield
    except KeyboardInterrupt:
        if place is not None:
            click.echo("Interrupted: chunks that are done are kept, and the same command goes on.", err=True)
        raise


_STOPPED = {
    NOISE: "at the noise: the result agrees with the recording",
    STEPS: "after all steps",
    INTERRUPTED: "interrupted: the result has the steps that were done",
    MISFIT: "at a misfit: more than noise is left",
}


def _parts(facts: Facts) -> list[Any]:
    planes, height, width = facts["shape"]
    lines = [
        ("stack", f"{planes} planes of {height} x {width}"),
        ("voxels", f"{format_length(facts['pixel_in_sample'])} x {format_length(facts['step'])} along z"),
    ]
    for each in facts["channels"]:
        before, after = each["before"], each["discrepancy"]
        name = f", {each['name']}" if len(facts["channels"]) > 1 else ""
        lines += [
            (f"discrepancy{name}", f"{before:#.3g} before, {after:#.3g} after {each['steps']} steps"),
            ("stopped", _STOPPED.get(each["stopped"], each["stopped"])),
            ("depth in focus", f"{between(*each['depths'])}, {each['psfs']} PSF{'s' * (each['psfs'] > 1)}"),
        ]
    findings = [f"{each['code'].replace('_', ' ')}: {with_options(each['text'])}" for each in facts["findings"]]
    lines.append(("time", f"{facts['seconds']:.3g} s"))
    return [Text(facts["name"], "bold"), list_of(lines), *map(Wrapped, [*findings, *facts["notes"]])]
