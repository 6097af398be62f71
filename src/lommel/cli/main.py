"""The command line: ``lommel psf``, ``lommel info``, ``lommel compare``, ``lommel paper``; more beside."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import Any

from lommel.base.optional import how_to_get
from lommel.base.validation import brief, shown
from lommel.methods import METHODS, ClosedForm

try:
    import click
    import rich as _rich  # noqa: F401 (what follows imports it when it prints)

    from lommel.cli import microscope_command
    from lommel.cli.methods import build_method
    from lommel.cli.parts import (
        FILE,
        Length,
        Pitch,
        Shape,
        figure_format,
        instrument_of,
        of_picture,
        one_line_errors,
        print_json,
        require_folder,
        save_figure,
    )
    from lommel.cli.progress import progress
except ImportError as missing:  # pragma: no cover
    sys.exit(f"The command line needs {how_to_get(missing.name or 'click', 'cli')}")


_BESIDE = {
    "blur": "photo_commands",
    "depth": "depth_commands",
    "examples": "examples_command",
    "focus-pull": "photo_commands",
    "live": "live_command",
    "methods": "methods",
    "precision": "depth_commands",
    "restore": "restore_command",
    "retrieve": "retrieve_command",
    "stack": "stack_command",
}
"""The files of commands that are imported when they are called or listed: to import what they need takes long."""


class _Commands(click.Group):
    """Those of this file, and those beside it; errors are short, whatever they were given."""

    def make_context(self, *args: Any, **extra: Any) -> click.Context:
        with _brief():
            return super().make_context(*args, **extra)

    def invoke(self, ctx: click.Context) -> Any:
        with _brief():
            return super().invoke(ctx)

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Return all names."""
        return sorted({*super().list_commands(ctx), *_BESIDE})

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Return the command of a name, if there is one."""
        if cmd_name in _BESIDE and cmd_name not in self.commands:
            found = getattr(import_module(f"lommel.cli.{_BESIDE[cmd_name]}"), cmd_name.replace("-", "_"))
            self.add_command(found)
        return super().get_command(ctx, cmd_name)


def _lens_command(command: Callable[..., None], *more: Callable[..., Any]) -> Callable[..., None]:
    """Add what every command takes: the lens file, what overrides it, and --json."""
    parts = [
        click.argument("lens", type=FILE),
        click.option("--object-distance", type=Length(), help='Instead of the file\'s: "1.5 m", "inf".'),
        click.option(
            "--pixel", type=Pitch(), help='Instead of the file\'s: "3.45 um", or height x width, "4 um x 6 um".'
        ),
        click.option("--shape", type=Shape(), help="Window in pixels, instead of the file's: 65 or 64x128."),
        *more,
        click.option("--json", "as_json", is_flag=True, help="Print what the tables show as JSON."),
    ]
    for part in reversed(parts):
        command = part(command)
    return command


def _psf_command(command: Callable[..., None]) -> Callable[..., None]:
    """Add what every command takes that makes PSFs."""
    return _lens_command(
        command,
        click.option("--integrate/--sample", default=None,
                     help="Average over the area of each pixel, as a sensor does and is the default, or sample its "
                     "centre; instead of the file's."),
    )  # fmt: skip


@contextmanager
def _brief() -> Iterator[None]:
    """Shorten what Click repeats of a command line."""
    try:
        yield
    except click.ClickException as error:
        if not isinstance(error, click.exceptions.NoArgsIsHelpError):  # whose message is the help
            vars(error).update(message=brief(error.message, 240))
        raise


@click.group(cls=_Commands, context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100})
@click.version_option(package_name="lommel")
def main() -> None:
    """Point spread functions of defocused and aberrated lenses.

    A lens is described by a TOML file, and so is a microscope; `lommel examples` has some of either. Lengths carry
    units: "550 nm", "3.45 um", "1.5 m".

    \b
    Examples:
      lommel examples phone                             # a lens file to begin with
      lommel info    lens.toml                          # what is known without an image
      lommel psf     lens.toml -o psf.tif -o psf.png    # the PSF, as data and as a picture
      lommel psf     objective.toml -o stack.ome.tif -o sections.png    # that of a microscope
      lommel compare lens.toml --figure compare.png     # every method against the reference
      lommel methods                                    # what they are, and their options
      lommel paper   out                                # every figure and number of the paper
      lommel blur    photo.jpg depth.tif lens.toml --focus "2 m" -o out.jpg    # a photograph
      lommel restore photo.jpg depth.tif lens.toml --white 5000 --read 3 -o sharp.jpg    # and back
      lommel depth   near.tif far.tif lens.toml --focus 1.3m --focus 2m --between 1m 3m --white 5000 --read 3
      lommel retrieve star-*.tif lens.toml --defocus -4 0 4 --read 2   # the wavefront behind images of a star
      lommel stack   lens.toml --between 1m 3m --count 500 --shape 17 -o depths.zarr    # over the distance
      lommel live    lens.toml                          # the PSF in the browser, with every slider
    """  # noqa: D301 (\b is meant)


def commands() -> dict[str, click.Command]:
    """Return all commands by their names."""
    context = click.Context(main)
    found = {name: main.get_command(context, name) for name in main.list_commands(context)}
    return {name: command for name, command in found.items() if command is not None}


@main.command()
@_psf_command
@microscope_command.stack_options
@click.option("-o", "--output", "outputs", multiple=True, type=FILE,
              help="The values: .tif (OME), .fits, .h5, .mat (MATLAB), .npy, .npz or .raw (with a .json beside); or "
              "a grey picture to look at: .png, the square root of the values, enlarged to 512 pixels or more. "
              "Repeatable. With --field .tif, .fits, .h5, .mat, .zarr or .npz.")  # fmt: skip
@click.option("--field", type=Shape(), metavar="ROWSxCOLUMNS",
              help="A grid of PSFs over the sensor, such as 5x7; the lens file needs a section [field].")  # fmt: skip
@click.option("--colour", is_flag=True,
              help="In the channels of the file, [channels], or in red, green and blue: data in .npz or .tif (OME), "
              ".png in colour; with --field .npz or .zarr.")  # fmt: skip
@click.option("--mtf", is_flag=True,
              help="Also the MTF at the Nyquist frequency of the pixels and at half of it, along x and y, the pixel "
              "included; with --field at each place, with --colour in each channel.")  # fmt: skip
@click.option("--plot", "figure", type=FILE,
              help="A figure with axes and scale, the square root of the values: .png, .pdf, .svg.")  # fmt: skip
@click.option("-m", "--method", "method_name", default="auto", show_default=True,
              type=click.Choice(("auto", *METHODS)),
              help="How to evaluate the diffraction integral; auto: what suits the pupil.")  # fmt: skip
@click.option("--tol", type=float, help="Tolerance, relative to the peak, of methods that have one.")
@click.option("--set", "settings", multiple=True, metavar="NAME=VALUE",
              help="An option of the method, such as tangent=200 or erf=abramowitz:30; may be repeated.")  # fmt: skip
@click.option("--normalize", default="energy", show_default=True,
              type=click.Choice(["energy", "emitted", "strehl", "peak"]),
              help="Fraction of all light per pixel, or of what a microscope collects far from the glass, or 1 = "
              "unaberrated peak, or 1 = largest value.")  # fmt: skip
@click.option("--dtype", type=click.Choice(["float32", "float64"]), help="Of the values.")
@one_line_errors
def psf(
    outputs: tuple[Path, ...],
    field: Any,
    colour: bool,
    mtf: bool,
    figure: Path | None,
    method_name: str,
    tol: float | None,
    settings: tuple[str, ...],
    as_json: bool,
    normalize: str,
    dtype: str | None,
    stack: int | None,
    step: float | None,
    depth: float | None,
    **lens: Any,
) -> None:
    """Compute the PSF of a lens, print what it is, and write it to files.

    Or of a microscope, where the file has a section [objective]: a stack of planes, whose pictures are sections.

    \b
    Examples:
      lommel psf hubble.toml -o hubble.tif -o hubble.png
      lommel psf camera.toml --object-distance "1.2 m" --tol 1e-9 -o camera.npz
      lommel psf camera.toml --method closed-form --set tangent=200 --set erf=abramowitz:30
      lommel psf camera.toml --field 5x7 --plot field.png -o field.tif
      lommel psf camera.toml --field 5x7 --colour --mtf
      lommel psf camera.toml --colour -o camera.png -o camera.npz
      lommel psf objective.toml --stack 64 --step "100 nm" --depth "2 um" -o psf.ome.tif -o psf.png
    """  # noqa: D301 (\b is meant)
    from lommel.cli import reports, tables
    from lommel.io import field_files, psf_files
    from lommel.psf import psf as compute

    registry = psf_files if field is None else field_files
    forms = [(path, registry.find(path, "--output")) for path in (() if colour else outputs)]
    written = [place for path, form in forms for place in form.places(path)]
    for path in (*outputs, *written):
        require_folder(path)
    if figure is not None:
        figure_format(figure)
    options: dict[str, Any] = {"method": build_method(method_name, settings), "tol": tol, "normalize": normalize}
    options["dtype"] = dtype
    if tol is not None and any(setting.startswith("tol=") for setting in settings):
        raise ValueError("tol is given twice, by --tol and by --set")
    of_kinds: dict[str, Any] = {
        "field": field,
        "colour": colour or None,
        "mtf": mtf or None,
        "stack": stack,
        "step": step,
        "depth": depth,
    }
    microscope = microscope_command.microscope_of(**lens, **of_kinds)
    if microscope is not None:
        microscope_command.psf(microscope, outputs, written, figure, as_json, options)
        return
    instrument = instrument_of(**lens)
    window, pixel = instrument.window, instrument.pixel
    options |= instrument.sensor_options
    if colour:
        from lommel.cli import colour_command

        colour_command.psf(instrument, field, outputs, figure, as_json, options, mtf=mtf)
        return
    work: Callable[[], Any]
    if field is None:
        count, work = "", partial(compute, instrument.pupil(), window, pixel, **options)
    else:
        if not isinstance(field, tuple) or len(field) != 2:
            raise ValueError(f"--field must be ROWSxCOLUMNS such as 5x7, got {shown(field)}")
        count, options["sensor"] = f"{field[0]} x {field[1]} PSFs of ", instrument.sensor
        work = partial(instrument.field().grid, *field, shape=window, pixel=pixel, **options)
    with progress(f"{count}{window[0]} x {window[1]} pixels"):
        start = time.perf_counter()
        answer: Any = work()
        seconds = time.perf_counter() - start
        if field is None:
            facts = reports.describe_lens(instrument) | {"psf": reports.describe_psf(answer, seconds)}
        else:
            facts = reports.describe_field(instrument, answer, seconds)
        if mtf:
            facts |= {"mtf": reports.describe_mtf(instrument, None if field is None else answer)}
        for path in outputs:
            answer.save(path)
        if figure is not None:
            axes = answer.plot()
            if field is None:
                axes.set_title(f"{instrument.name}\n{axes.get_title()}", fontsize=9)
            else:
                axes.set_title(instrument.name, fontsize=9, loc="left", pad=22)
            save_figure(axes.figure, figure)
    if as_json:
        print_json(facts | {"files": [str(path) for path in (*written, *([figure] if figure else []))]})
        return
    if field is None:
        tables.print_lens(facts)
        tables.print_psf(answer, facts["psf"])
    else:
        tables.print_field(answer, facts)
    if mtf:
        tables.print_mtf(facts["mtf"])
    for path in written:
        click.echo(f"wrote {path}{'' if field else of_picture(answer, path)}")
    if figure is not None:
        click.echo(f"wrote {figure}: the square root of the values{', each PSF over its largest' if field else ''}")


@main.command()
@_lens_command
@microscope_command.DEPTH
@one_line_errors
def info(as_json: bool, depth: float | None, **lens: Any) -> None:
    """Print what is known about a lens, or a microscope.

    Wavefront in radians and waves, what narrows the aperture, Airy radius, geometric blur, Strehl ratio and
    Marechal's estimate of it, full width at half of the largest intensity, contrast at the Nyquist frequency of the
    pixels and frequency of half contrast (of round apertures), and encircled energies beside those of the same
    aperture without aberration.

    Of a microscope, a file with a section [objective]: where an emitter is in focus by its depth, how wide and how
    bright that is, how much light is collected, the critical angle, and how finely to sample.

    \b
    Examples:
      lommel info camera.toml --object-distance "3 m"
      lommel info objective.toml --depth "10 um"
    """  # noqa: D301 (\b is meant)
    from lommel.cli import reports, tables

    microscope = microscope_command.microscope_of(**lens, depth=depth)
    if microscope is not None:
        microscope_command.info(microscope, as_json)
        return
    facts = reports.describe_lens(instrument_of(**lens))
    if as_json:
        print_json(facts)
    else:
        tables.print_lens(facts)


@main.command()
@_psf_command
@click.option("--figure", type=FILE,
              help="The PSFs, the square root of their values, and their slices: .png, .pdf, .svg.")  # fmt: skip
@one_line_errors
def compare(as_json: bool, figure: Path | None, **lens: Any) -> None:
    """Compute the PSF of a lens by every method and judge each by a reference.

    That is plain quadrature (Hankel); where the wavefront depends on the direction the certified series at a
    tolerance of 1e-9, and where the aperture is not round the non-uniform FFT at 1e-11. Methods that do not take such
    a pupil are named with the reason.

    Errors are relative to the peak of the reference; MSE is the mean squared error over the squared peak. That of
    HuygensFresnel, of a paraxial lens, is the Fresnel approximation of all the others, and is of samples at the
    centres of the pixels; ClosedForm has the tangent-line centre and the erf of least mean square error in this
    window. Times are those of a second call, where the first takes less than a second. What the other model of the
    lens would change is told below.

    \b
    Example:
      lommel compare camera.toml --figure methods.png
    """  # noqa: D301 (\b is meant)
    from lommel.cli import reports, tables

    if figure is not None:
        figure_format(figure)
    instrument = instrument_of(**lens)
    pupil = instrument.pupil()
    with progress("", total=len(METHODS) + 1) as started:
        methods = [
            # The paper's form at its best, so that nobody compares with it at its worst.
            ClosedForm.best(pupil, instrument.window, instrument.side)
            if kind is ClosedForm and pupil.radial
            else kind()
            for kind in METHODS.values()
        ]
        rows, answers = reports.compare(instrument, methods, started)
        reference = reports.reference_name(pupil)
        sampling = answers[reference].sampling
        if figure is not None:
            from lommel.show import plot

            save_figure(plot.compare(answers, reference), figure)
    if as_json:
        named = {"name": instrument.name, "reference": reference, "sampling": sampling}
        print_json(named | {"rows": rows, "other_model": reports.other_model(instrument)})
    else:
        tables.print_comparison(instrument, rows, reference, sampling, reports.other_model(instrument))
        if figure is not None:
            click.echo(f"wrote {figure}: the square root of the values, and slices")


@main.command()
@click.argument("outdir", type=click.Path(path_type=Path))
@click.option("--figure", "figures", multiple=True, type=click.Choice([*"1234567", "17", "100"]),
              help="One, without the table; may be repeated. 17: Eq. (17); 100: where the forms hold.")  # fmt: skip
@click.option("--json", "as_json", is_flag=True, help="Print settings, errors and the table as JSON.")
@one_line_errors
def paper(outdir: Path, figures: tuple[str, ...], as_json: bool) -> None:
    """Regenerate every figure and number of the paper, in OUTDIR, in about half a minute.

    Each figure becomes figure-N.png, figure-N.npz with all of its data and figure-N.csv with its curves.
    table.md and table.json set each number of the paper beside the one computed, from
    Eq. (12) as printed and corrected.

    \b
    Examples:
      lommel paper out
      lommel paper out --figure 3 --figure 5
    """  # noqa: D301 (\b is meant)
    from lommel.cli import tables
    from lommel.paper.write import FIGURES, reproduce

    wanted = [int(number) for number in figures] or None
    with progress("", total=len(wanted) if wanted else len(FIGURES) + 1) as started:
        made = reproduce(outdir, wanted, started)
    if as_json:
        print_json(made)
        return
    if made["table"] is not None:
        tables.print_numbers(made["table"])
    for name in made["files"]:
        click.echo(f"wrote {name}")
