"""The commands ``lommel info``, ``compare``, ``methods`` and ``paper``."""

from __future__ import annotations

import dataclasses
from pathlib import Path
from typing import TYPE_CHECKING

import click
from rich.table import Column, Table
from rich.text import Text

from lommel.base.units import pitch_in_words
from lommel.cli.instruments import DEPTH, LENS, Seen, instrument_of, microscope_of
from lommel.cli.options import JSON, PATH, WINDOW, argument, command, option, plot_option
from lommel.cli.output import Report, Wrapped, progress, save_figure, table_of, written
from lommel.methods import ERFS, METHODS, ClosedForm
from lommel.show.drawing import HOW

if TYPE_CHECKING:
    from rich.console import RenderableType

_NOTES = {"HuygensFresnel": "flat, thin lens without the Fresnel approximation", "Geometric": "no diffraction"}


class Described(Seen):
    """The same, with a window for the comparison of models alone."""

    # fmt: off
    shape: int | tuple[int, int] | None = option(type=WINDOW,
        help="Window in pixels in which the paraxial and the aplanatic model are compared, such as 65 or 64x128 "
        "(height x width); overrides the file.")
    # fmt: on
    integrate: bool | None = None


@command(JSON)
def info(lens: Path = LENS, seen: Described = Described(), depth: float | None = DEPTH) -> Report:
    """Print the image quality of a lens or a microscope.

    Lens: wavefront in radians and waves, aperture, Airy radius, geometric blur, Strehl ratio and Marechal's estimate,
    full width at half maximum (FWHM), for circular apertures the MTF at the Nyquist frequency and the frequency at
    which it falls to 50 %, encircled energy (also without aberrations), and the difference between the paraxial and
    the aplanatic model of the lens.

    Microscope (a file with a section [objective]): focus position, width and peak against the depth of the emitter,
    collected light, critical angle, and Nyquist sampling.

    Examples
    --------
      lommel info phone.toml --object-distance 3m
      lommel info zeiss-63x-1.4-oil.toml --depth 10um
    """
    from lommel.cli import reports  # what these need takes longer to import than the list of commands

    microscope = microscope_of(lens, depth=depth, **vars(seen))
    if microscope is not None:
        return reports.describe_microscope(microscope)
    return reports.describe_lens(instrument_of(lens, **vars(seen)))


@command(JSON)
def compare(
    lens: Path = LENS,
    seen: Seen = Seen(),
    figure: Path | None = plot_option(
        "Figure of the reference, maps of the errors of the others, and slices", "--figure"
    ),
) -> Report:
    """Compare the accuracy and speed of all methods for a lens.

    The reference has a proven error bound: for circular and annular apertures Hankel (direct quadrature) if the
    wavefront is radially symmetric, otherwise NijboerZernike at a tolerance of 1e-9; for other apertures
    NonuniformFFT at a tolerance of 1e-9. Methods are listed by the names that `lommel psf --method` takes. Those that
    do not support the pupil are listed below with the reason.

    Errors are relative to the peak of the reference; MSE is the mean squared error divided by the square of the peak.
    For a paraxial lens the error listed for HuygensFresnel is that of the Fresnel approximation, which all other
    methods make. HuygensFresnel is always compared at pixel centres, also with --integrate. ClosedForm uses the
    values of its options `tangent` and `erf` (see `lommel methods`) that give the least MSE in this window. Times are
    those of the second call, or of the first if that takes more than 1 s. The last line compares the paraxial and the
    aplanatic model of the lens.

    Example:
      lommel compare phone.toml --figure methods.png
    """
    from lommel.cli import reports  # what these need takes longer to import than the list of commands
    from lommel.lensfiles.image_quality import compare_methods, other_model

    instrument = instrument_of(lens, **vars(seen))
    pupil = instrument.pupil()
    with progress("", total=len(METHODS) + 1) as started:
        methods = [
            # The paper's form at its best, for a fair comparison.
            ClosedForm.best(pupil, instrument.window, instrument.side)
            if kind is ClosedForm and pupil.radial
            else kind()
            for kind in METHODS.values()
        ]
        rows, answers = compare_methods(instrument, methods, started)
        reference = next(iter(answers))
        sampling = answers[reference].sampling
        if figure is not None:
            from lommel.show import plot

            shown = {_called(name): answer for name, answer in answers.items()}
            save_figure(plot.compare(shown, _called(reference)), figure)
    other = other_model(instrument)
    table = table_of(("method", "time", "MSE", "peak error", "error bound"), (), no_wrap=True)
    notes = []
    for row in rows:
        row["name"] = name = _called(row["method"])
        # "X supports defocus only; this pupil ..." stands beside the name of X.
        reason = row["reason"] and row["reason"].removeprefix(row["method"]).split(";")[0].strip()
        note = reason or ("the reference" if row["method"] == reference else _NOTES.get(row["method"], ""))
        if row["method"] == "HuygensFresnel" and instrument.lens.model == "aplanatic":
            note = "same model, without its expansion in powers of rho"
        if row["sampling"] not in (None, sampling):
            note = f"{HOW[row['sampling']]}; {note}"
        if note:
            notes.append(Wrapped(f"{name}: {note}", "dim"))
        spent = "-" if row["seconds"] is None else f"{1e3 * row['seconds']:.1f} ms"
        errors = ("-" if row[key] is None else f"{row[key]:.2g}" for key in ("mse", "peak_error", "error_bound"))
        table.add_row(name, spent, *errors)
    height, width = instrument.window
    size = f"{height} x {width} pixels of {pitch_in_words(instrument.pixel)}, {HOW[sampling]}"
    if all(row["method"] != reference for row in rows):  # which is then not marked in the table
        size += f"; reference {_called(reference)}"
    facts = {
        "name": instrument.name,
        "reference": reference,
        "sampling": sampling,
        "rows": rows,
        "other_model": other,
    }
    model = f"model: {instrument.lens.model}; {reports.model_in_words(other)}"
    files = written([figure], lambda _: ": the reference, maps of the errors, and slices").parts
    return Report(facts, [Text(instrument.name, "bold"), Wrapped(size), table, *notes, model, *files])


def _called(method: str) -> str:
    """Return the name on the command line of a method, given as its name or its text in Python."""
    kind, _, options = method.partition("(")
    name = next((name for name, one in METHODS.items() if one.__name__ == kind), kind)
    return f"{name} ({options}" if options else name


@command(JSON)
def methods() -> Report:
    """List the methods and their options, for --method and --set.

    Example:
      lommel methods
    """
    table = Table(Column("method", no_wrap=True), "description", "options (defaults)", box=None, pad_edge=False)
    rows = []
    for name, kind in METHODS.items():
        what = (kind.__doc__ or "").partition("\n")[0].replace("``", "").rstrip(".")
        options = {item.name: _default(item) for item in dataclasses.fields(kind)}  # type: ignore[arg-type]
        rows.append({"name": name, "what": what, "options": options})
        table.add_row(name, what, " ".join(f"{option}={value}" for option, value in options.items()))
    return Report({"methods": rows}, [table])


def _default(item: dataclasses.Field[object]) -> str:
    """Return the default of an option as --set takes it."""
    factory = item.default_factory
    default = item.default if factory is dataclasses.MISSING else factory()
    return next((name for name, kind in ERFS.items() if isinstance(default, kind)), str(default).lower())


@command(JSON)
def paper(
    outdir: Path = argument("outdir", type=PATH),
    figures: tuple[str, ...] = option("--figure", multiple=True, type=click.Choice([*"1234567", "eq17", "validity"]),
        help="Compute only this figure, without the table; may be repeated. eq17: piecewise quadratic phase of "
        "Eq. (17); validity: where the closed forms hold."),
) -> Report:  # fmt: skip
    """Reproduce the figures and numbers of the paper.

    The paper is "Bridging ray tracing and wave optics: a computationally efficient model for defocus and spherical
    aberration", the source of the method closed-form. This takes about half a minute.

    Each figure is written to OUTDIR as figure-N.png, its data as figure-N.npz, its curves as figure-N.csv. table.md
    and table.json compare each number of the paper with the computed one, for Eq. (12) as printed and as corrected.

    Examples
    --------
      lommel paper out
      lommel paper out --figure 3 --figure eq17
    """
    from lommel.paper.write import FIGURES, closest_text, number, reproduce

    wanted = list(figures) or None
    with progress("", total=len(wanted) if wanted else len(FIGURES) + 1) as started:
        made = reproduce(outdir, wanted, started)
    parts: list[RenderableType] = [f"wrote {name}" for name in made["files"]]
    if made["table"] is not None:
        names = ("quantity", "paper", "as printed", "corrected", "closest, as printed")
        rows = [
            (
                row["quantity"],
                *(number(row[key]) for key in ("paper", "printed", "corrected")),
                closest_text(row["closest"]["printed"]),
            )
            for row in made["table"]
        ]
        parts.insert(0, table_of(names, rows, no_wrap=True, title="The numbers of the paper"))
    return Report(made, parts)
