"""The command ``lommel deconvolve``: deconvolution of a microscope stack, from file to file."""

from __future__ import annotations

import sys
import time as clock
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import numpy as np
from rich.text import Text

from lommel.base import validation
from lommel.base.executors import connected
from lommel.base.options import HIDDEN, In, Shown
from lommel.cli.command import CLIENT, OUTPUT, PLOT, command
from lommel.cli.instruments import CameraMaps, require_microscope, require_order
from lommel.cli.messages import report_findings
from lommel.cli.output import progress, require_folder, save_figure, written
from lommel.deconvolve.algorithms import RichardsonLucy, TotalVariation
from lommel.microscopy.bead_average import measured_psf
from lommel.microscopy.deconvolution import DeconvolveOptions, run
from lommel.microscopy.sampling import Stated, require_of_psf
from lommel.recorded import stack_files
from lommel.recorded.frames import open_frames
from lommel.report import Report
from lommel.report.table import described

if TYPE_CHECKING:
    from lommel.recorded.noise import Noise


@dataclass(frozen=True, kw_only=True)
class StackCamera(CameraMaps):
    """Options for the camera of a stack, whose noise may be unknown.

    Parameters
    ----------
    camera
        Camera with the noise of the stack: name of an example or a file; options below come first.
    white
        Electrons per count; by default estimated from the stack. A file (.tif, .npy) is a map, also of --read and
        --offset.
    """

    pixel: Annotated[float | None, HIDDEN] = None

    def noise(self) -> Noise | None:
        """Return the noise, None if no option states any of it."""
        if self.camera is None and self.read is None:
            if self.white is self.offset is None:
                return None
            raise ValueError("--read must be given with --gain or --offset: electrons of read noise, 0 for none")
        noise, _, notes = self.resolve({}, self.camera)
        for note in notes:
            validation.tell(note)
        return noise


@command
def deconvolve(
    stack: Path,
    lens: Path | None = None,
    /,
    *,
    outputs: Annotated[tuple[Path, ...], OUTPUT],
    figure: Annotated[Path | None, PLOT] = None,
    client: Annotated[str | None, CLIENT] = None,
    psf: Annotated[Path | None, Shown(metavar="FILE")] = None,
    psf_pixel: Annotated[float | None, Shown(length="um")] = None,
    psf_step: Annotated[float | None, Shown(length="nm")] = None,
    diameter: Annotated[float | None, Shown(("--bead",), length="nm")] = None,
    time: Annotated[int | None, In(least=0)] = None,
    axes: Annotated[str | None, Shown(metavar="LETTERS")] = None,
    camera: StackCamera = StackCamera(),
    algorithm: Annotated[Literal["richardson-lucy", "total-variation"], Shown(("--method",))] = "richardson-lucy",
    steps: Annotated[int | None, In(least=1, most=100_000)] = None,
    strength: Annotated[float | None, In(above=0.0)] = None,
    options: DeconvolveOptions = DeconvolveOptions(),
) -> Report:
    """Deconvolve the stack of a microscope (3-D deconvolution).

    STACK is an OME-TIFF, a TIFF of ImageJ or a folder of OME-Zarr, or with --axes NPY or FITS, as the camera recorded
    it; LENS is the file of the objective, which a measured PSF (--psf) does not need. Voxel sizes, channels and
    wavelengths are read from STACK. The PSF depends on the depth where the sample and the immersion differ.
    Iterations stop where the result agrees with the recording within its noise; a misfit is printed, and the exit
    code is then 3. Held-out photons are used to test whether another PSF agrees better.

    The output has the voxel sizes of the stack. A single output .ome.zarr is written chunk by chunk, for stacks
    larger than memory; after an interruption the same command resumes. Ctrl-C keeps the completed steps.

    Parameters
    ----------
    outputs
        Restored stack: .ome.tif or .tif, both OME-TIFF, or .ome.zarr; may be repeated.
    figure
        Figure of projections before and after, and of the residual: .png, .pdf or .svg.
    client
        Scheduler of a dask cluster whose workers restore the chunks of an output .ome.zarr, such as
        tcp://host:8786; they must see STACK and the folder of the output under these paths.
    psf
        Measured PSF instead of that of LENS: a stack of one bead or many, as the camera recorded it, or a PSF, with
        the channels of STACK. Beads are found, registered and averaged, and the mean has the voxels of STACK.
        With LENS, too, their background and place follow from its PSF.
    psf_pixel
        Pixel in the sample of --psf, such as 0.1um; by default from its file.
    psf_step
        Step between the planes of --psf, such as 200nm; by default from its file.
    diameter
        Diameter of the beads of --psf, such as 0.1um, which is removed.
    time
        Time point, from 0; by default all, one after the other.
    axes
        Axes of the file if it does not state them, such as ZYX.
    algorithm
        Richardson-Lucy maximises the likelihood; total variation also smooths and preserves edges, in three
        dimensions, and takes a few times as long.
    steps
        Number of steps, instead of stopping at the noise.
    strength
        Weight of the total variation; by default such that the result agrees with the noise.
    depth
        Depth below the cover glass in focus in plane N // 2 of N planes, counted from 0, such as 10um; by default
        from the file of the objective.
    wavelength
        Emission, such as 520nm; repeated, one for each channel; by default from the stack.
    pixel
        Pixel pitch on the camera, such as 6.5um; by default from the stack.
    step
        Step between planes, such as 200nm; by default from the stack.
    direction
        up: the first plane is the nearest to the cover glass; auto determines the direction from the data.
    background
        Light that is not from the specimen: estimated as one level, or as a level that varies over the field; or a
        known level above the offset, 0 for none. The output excludes it.
    diagnosis
        Hold out photons, to estimate the background and to compare PSFs of other indices of the sample; try other
        PSFs after a misfit. Without it a stack takes three quarters of the time, or less.
    memory
        Limit of the memory besides the stack, gigabytes; by default 2.

    Examples
    --------
      lommel deconvolve stack.ome.tif zeiss-63x-1.4-oil.toml --depth 8um -o restored.ome.tif --plot restored.png
      lommel deconvolve stack.ome.tif zeiss-63x-1.4-oil.toml --psf beads.ome.tif --bead 0.1um -o restored.ome.tif
      lommel deconvolve stack.ome.tif --psf beads.ome.tif --bead 0.1um -o restored.ome.tif
      lommel deconvolve stack.ome.tif zeiss-63x-1.4-oil.toml --gain 0.46 --read 1.6 --offset 100 -o restored.ome.zarr
    """
    for path in outputs:
        stack_files.kind_of(path, stack)
        require_folder(path)
    if lens is None and psf is None:
        raise ValueError("LENS is missing: give the file of the objective, or --psf, a measured PSF")
    microscope = None
    if lens is not None:
        require_order("STACK LENS, the stack first", stack, lens)
        microscope = require_microscope("deconvolve", lens)
    if psf is None and (psf_pixel, psf_step, diameter) != (None, None, None):
        raise ValueError("--psf-pixel, --psf-step and --bead need --psf")
    if psf is not None:  # before beads are found and averaged
        require_of_psf(Stated(options.depth, options.wavelength, options.pixel, options.step), measured=True)
    noise = camera.noise()
    zarr_output = outputs[0] if len(outputs) == 1 and stack_files.kind_of(outputs[0]) == "zarr" else None
    if client is not None and zarr_output is None:
        raise ValueError("--client needs a single output, NAME.ome.zarr, which is written chunk by chunk")
    start = clock.perf_counter()
    try:
        with (
            progress("reading", elsewhere=client is not None) as report_progress,
            open_frames(stack) as frames,
            connected(client) as cluster,
        ):
            recording = frames.as_channels(time=time, axes=axes, series=True)
            beads: dict[str, Any] = {"microscope": microscope, "diameter": diameter}
            psfs = (
                None
                if psf is None
                else [
                    measured_psf(psf, psf_pixel, psf_step, channel=channel, **beads)
                    for channel in range(recording.shape[-4])
                ]
            )
            result = run(
                recording,
                psfs or microscope,
                noise,
                replace(
                    options,
                    method=_method(algorithm, steps, strength),
                    out=zarr_output,
                    client=cluster,
                    progress=lambda fraction, description: report_progress(description, fraction),
                ),
                mask=camera.mask_of(np.broadcast_to(False, recording.shape[-3:])),
                saturation=camera.saturation,
            )
            if zarr_output is None:
                report_progress("writing")
                result.save(*outputs)
            save_figure(result.plot, figure)
    except KeyboardInterrupt:
        if zarr_output is not None:
            print("Interrupted: completed chunks are kept, and the same command resumes.", file=sys.stderr)
        raise
    seconds = clock.perf_counter() - start
    name = "measured PSF" if microscope is None else microscope.name
    facts = {"stack": str(stack), "name": name} | result.to_dict() | {"seconds": seconds}
    return report_findings(facts, Text(name, "bold"), *described(facts)) + written([*outputs, figure])


def _method(algorithm: str, steps: int | None, strength: float | None) -> RichardsonLucy | TotalVariation:
    """Return the method."""
    if algorithm == "total-variation":
        return TotalVariation(strength=strength, steps=steps or TotalVariation.steps, target=1.0)
    if strength is not None:
        raise ValueError("--strength needs --method total-variation")
    return DeconvolveOptions.method if steps is None else RichardsonLucy(steps=steps, target=0.0)
