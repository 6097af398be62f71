"""The command ``lommel deconvolve``: deconvolution of a microscope stack, from file to file."""

from __future__ import annotations

import time
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np
from rich.text import Text

from lommel.base.units import format_length
from lommel.base.validation import line
from lommel.cli.instruments import LENS, STACK_FILE, CameraMaps, camera_option, require_microscope, require_order
from lommel.cli.options import (
    JSON,
    LENGTHS,
    OUTPUT_PATH,
    Group,
    command,
    documented,
    option,
    plot_option,
    report_findings,
)
from lommel.cli.output import progress, require_folder, save_figure, written
from lommel.deconvolve.algorithms import NOISE, STEPS, RichardsonLucy, TotalVariation
from lommel.microscopy import restore
from lommel.microscopy.deconvolution import FLAT
from lommel.microscopy.depth_model import MODALITIES
from lommel.microscopy.refinement import PARAMETERS
from lommel.microscopy.restoration import INTERRUPTED, MISFIT, format_depth_range
from lommel.recorded import stack_files
from lommel.recorded.frames import open_frames
from lommel.report import Facts, Report, list_of

if TYPE_CHECKING:
    from rich.table import Table

    from lommel.lensfiles.instrument import Camera
    from lommel.recorded.noise import Noise

METHODS = ("richardson-lucy", "total-variation")


class RecordingOptions(Group, heading="Microscope"):
    """Options for the recording; default values are in the stack, or in the file of the objective."""

    # fmt: off
    depth: float | None = option(length="um",
        help="Depth below the cover glass in focus in plane N // 2 of N planes, counted from 0, such as 10um; by "
        "default from the file of the objective.")
    wavelength: tuple[float, ...] | None = option(type=LENGTHS, metavar="LENGTHS",
        help="Emission, such as 520nm, or one for each channel: 520nm,610nm; by default from the stack.")
    step: float | None = option(length="nm",
        help="Step between planes, such as 200nm; by default from the stack.")
    modality: str = option(type=click.Choice(MODALITIES), default="widefield", help="Kind of microscope.")
    excitation: float | None = option(length="nm",
        help="Excitation wavelength of scanning microscopes, such as 488nm.")
    pinhole: float | None = documented(restore, "pinhole", type=float, help="Diameter of the pinhole in Airy units.")
    thickness: float | None = option(length="um", help="Thickness of the light sheet, such as 2um (FWHM).")
    direction: str = option(type=click.Choice(("auto", "up", "down")), default="auto",
        help="up: the first plane is the nearest to the cover glass; auto determines the direction from the data.")
    # fmt: on


class StackCamera(CameraMaps, heading="Camera"):
    """Options for the camera of a stack, whose noise may be unknown."""

    # fmt: off
    camera: Camera | None = camera_option(
        "Camera with the noise of the stack: name of an example or a file; options below come first.")
    white: Any = option("--gain", metavar="NUMBER|FILE",
        help="Electrons per count; by default estimated from the stack. A file (.tif, .npy) is a map, also of --read "
        "and --offset.")
    offset: Any = option(metavar="NUMBER|FILE", help="Counts of a pixel without electrons, such as 100.")
    # fmt: on

    def noise(self) -> Noise | None:
        """Return the noise, None if no option states any of it."""
        if self.camera is None and self.read is None:
            if self.white is self.offset is self.excess is None:
                return None
            raise ValueError(
                "--read must be given with --gain, --offset or --excess: electrons of read noise, 0 for none"
            )
        return self.resolve({}, self.camera)[0]


class RestorationOptions(Group, heading="Restoration"):
    """Options for the restoration, its memory and its threads."""

    # fmt: off
    method: str = option(type=click.Choice(METHODS), default=METHODS[0],
        help="Richardson-Lucy maximises the likelihood; total variation also smooths and preserves edges, in three "
        "dimensions, and takes a few times as long.")
    steps: int | None = option(type=click.IntRange(1, 100_000),
        help="Number of steps, instead of stopping at the noise.")
    strength: float | None = option(type=float,
        help="Weight of the total variation; by default such that the result agrees with the noise.")
    background: str = option(default=FLAT, metavar="flat|uneven|COUNTS",
        help="Light that is not from the specimen: estimated as one level, or as a level that varies over the field; "
        "or a known level above the offset, 0 for none. The output excludes it.")
    slabs: int | None = documented(restore, "slabs", type=click.IntRange(1, 64),
        help="Number of PSFs over the depth of the stack; by default as many as needed.")
    refine: tuple[str, ...] = option(multiple=True, type=click.Choice(PARAMETERS),
        help="Estimate this parameter from the stack before the restoration; may be repeated.")
    diagnosis: bool = option("--diagnosis/--no-diagnosis", default=True,
        help="Hold out photons, to estimate the background and to compare PSFs of other indices of the sample; try "
        "other PSFs after a misfit. Without it a stack takes half of the time, or less.")
    per_plane: bool = option(is_flag=True,
        help="Restored values are the light collected in one plane, rather than in all planes of the PSF.")
    channel: int | None = option(type=click.IntRange(0), help="Channel, from 0; by default all.")
    time: int | None = option(type=click.IntRange(0), help="Time point, from 0.")
    axes: str | None = option(help='Axes of the file if it does not state them, such as "ZYX".')
    tile: int | None = option(type=click.IntRange(16),
        help="Side of chunks in pixels; by default as large as --memory allows.")
    memory: float = option(type=float, default=2.0, help="Limit of the memory besides the stack, gigabytes.")
    threads: int | None = documented(restore, "threads", type=click.IntRange(1),
        help="Number of threads; by default all processors.")
    # fmt: on

    def arguments(self) -> Facts:
        """Return the arguments of :func:`lommel.microscopy.restore`."""
        arguments = vars(self) | {"memory": 1e9 * self.memory}
        steps, strength = arguments.pop("steps"), arguments.pop("strength")
        arguments["method"] = None if steps is None else RichardsonLucy(steps=steps, target=0.0)
        if self.method == METHODS[1]:
            arguments["method"] = TotalVariation(strength=strength, steps=steps or TotalVariation.steps, target=1.0)
        elif strength is not None:
            raise ValueError(f"--strength needs --method {METHODS[1]}")
        with suppress(ValueError):  # "flat" and "uneven" are not numbers
            arguments["background"] = float(self.background)
        return arguments


@command(JSON)
def deconvolve(
    stack: Path = STACK_FILE,
    lens: Path = LENS,
    outputs: tuple[Path, ...] = option("-o", "--output", type=OUTPUT_PATH, required=True, multiple=True,
        help="Restored stack: .ome.tif or .tif, both OME-TIFF, or .ome.zarr; may be repeated."),
    figure: Path | None = plot_option("Figure of projections before and after, and of the residual"),
    recording_options: RecordingOptions = RecordingOptions(),
    camera: StackCamera = StackCamera(),
    restoration: RestorationOptions = RestorationOptions(),
) -> Report:  # fmt: skip
    """Deconvolve the stack of a microscope (3-D deconvolution).

    STACK is an OME-TIFF, a TIFF of ImageJ or a folder of OME-Zarr, or with --axes NPY or FITS, as the camera recorded
    it; LENS is the file of the objective. Voxel sizes, channels and wavelengths are read from STACK. The PSF depends
    on the depth where the sample and the immersion differ. Iterations stop where the result agrees with the recording
    within its noise; a misfit is printed, and the exit code is then 3. Held-out photons are used to test whether
    another PSF agrees better.

    The output has the voxel sizes of the stack. A single output .ome.zarr is written chunk by chunk, for stacks
    larger than memory; after an interruption the same command resumes. Ctrl-C keeps the completed steps.

    Examples
    --------
      lommel deconvolve stack.ome.tif zeiss-63x-1.4-oil.toml --depth 8um -o restored.ome.tif --plot restored.png
      lommel deconvolve stack.ome.tif zeiss-63x-1.4-oil.toml --gain 0.46 --read 1.6 --offset 100 -o restored.ome.zarr
    """
    for path in outputs:
        if path.suffix.lower() in (".png", ".pdf", ".svg"):
            raise ValueError(f"a stack must end in .ome.tif or .ome.zarr, got {line(path)}; --plot writes a picture")
        stack_files.kind_of(path, stack)
        require_folder(path)
    require_order("STACK LENS, the stack first", stack, lens)
    microscope = require_microscope("deconvolve", lens)
    noise, mask = camera.noise(), None
    if camera.masked is not None:
        with open_frames(stack) as frames:
            recording = frames.as_channels(time=restoration.time, axes=restoration.axes)
            mask = camera.mask(np.broadcast_to(False, recording.shape[1:]))
    arguments = vars(recording_options) | {"pixel": camera.pixel} | restoration.arguments()
    zarr_output = outputs[0] if len(outputs) == 1 and stack_files.kind_of(outputs[0]) == "zarr" else None
    start = time.perf_counter()
    try:
        with progress("reading") as report_progress:
            result = restore(
                stack,
                microscope,
                noise=noise,
                mask=mask,
                saturation=camera.saturation,
                out=zarr_output,
                progress=lambda fraction, description: report_progress(description, fraction),
                **arguments,
            )
            if zarr_output is None:
                report_progress("writing")
                result.save(*outputs)
            if figure is not None:
                report_progress("drawing")
                save_figure(result.plot(), figure)
    except KeyboardInterrupt:
        if zarr_output is not None:
            click.echo("Interrupted: completed chunks are kept, and the same command resumes.", err=True)
        raise
    seconds = time.perf_counter() - start
    facts = {"stack": str(stack), "name": microscope.name} | result.to_dict() | {"seconds": seconds}
    return report_findings(facts, Text(microscope.name, "bold"), _table(facts)) + written([*outputs, figure])


_STOP_TEXTS = {  # reasons to stop, in words
    NOISE: "at the noise: the result agrees with the recording",
    STEPS: "after all steps",
    INTERRUPTED: "interrupted: the result has the completed steps",
    MISFIT: "at a misfit: the residual exceeds the noise",
}


def _table(facts: Facts) -> Table:
    """Return the table of a restored stack."""
    planes, height, width = facts["shape"]
    lines = [
        ("stack", f"{planes} planes of {height} x {width}"),
        ("voxels", f"{format_length(facts['pixel_in_sample'])} x {format_length(facts['step'])} along z"),
    ]
    for channel in facts["channels"]:
        before, after = channel["before"], channel["discrepancy"]
        name = f", {channel['name']}" if len(facts["channels"]) > 1 else ""
        lines += [
            (f"discrepancy{name}", f"{before:#.3g} before, {after:#.3g} after {channel['steps']} steps"),
            ("stopped", _STOP_TEXTS.get(channel["stopped"], channel["stopped"])),
            (
                "depth in focus",
                f"{format_depth_range(*channel['depths'])}, {channel['psfs']} PSF{'s' * (channel['psfs'] > 1)}",
            ),
        ]
    return list_of([*lines, ("time", f"{facts['seconds']:.3g} s")])
