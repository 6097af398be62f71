"""The commands on lenses and their files: ``examples``, ``info``, ``live``, ``compare``, ``methods``, ``paper``."""

from __future__ import annotations

import dataclasses
import errno
import json
import sys
from pathlib import Path
from typing import Annotated, Any, Literal

from rich.text import Text

from lommel.base import atomic
from lommel.base.options import In, Shown, near
from lommel.base.units import pitch_in_words
from lommel.base.validation import shown
from lommel.cli.command import PLOT, command
from lommel.cli.help_text import continued
from lommel.cli.instruments import PLACE, WINDOW, Optics, instrument_of, microscope_of
from lommel.cli.output import progress, save_figure, written
from lommel.lensfiles import KINDS, example_files
from lommel.methods import ERFS, METHODS
from lommel.paper import ClosedForm
from lommel.report import Facts, Parts, Report, Wrapped
from lommel.report.table import described, records_of
from lommel.show.drawing import SAMPLING


@command
def examples(
    names: tuple[str, ...] = (),
    /,
    *,
    folder: Annotated[Path, Shown(("--output", "-o"), metavar="DIRECTORY")] = Path(),
    text: Annotated[str | None, Shown(("--find",), metavar="TEXT")] = None,
) -> Report:
    """List or copy example files of lenses, objectives, cameras; make data sets.

    NAMES are the names of the files to copy. Notebooks are for Jupyter; the other files describe real instruments and
    state the source of their numbers. Cameras need no copy: --camera takes their names. Data are simulated recordings
    with noise, one set for each field: the command to run with them is printed, and the true numbers. Existing files
    are not overwritten: unchanged copies are left alone, and files that differ are refused.

    Parameters
    ----------
    folder
        Folder to copy to, created if needed; by default the current folder.
    text
        List only examples with these words in kind, name or description: "nikon water", "camera".

    Examples
    --------
      lommel examples                      # list them
      lommel examples --find "nikon oil"   # those with both words
      lommel examples phone                # copy phone.toml to the current folder
      lommel examples chart                # a picture of a chart, for lommel sfr
      lommel examples exercises            # a Jupyter notebook for class
      lommel examples first-psf            # a notebook to start with
    """
    from lommel.cli.example_data import SETS

    files = example_files()
    if text is not None and names:
        raise ValueError("--find lists examples: leave it out to copy them")
    if not names:
        return _list_examples(files, (text or "").lower().split())
    stems = [name.removesuffix(".toml").removesuffix(".ipynb") for name in names]
    for name in stems:
        if name not in files and name not in SETS:
            raise ValueError(f"NAMES must be names of examples, got {shown(name)}; {_suggest(name, [*files, *SETS])}")
    sets = [SETS[name] for name in stems if name in SETS]
    copied = [name for name in stems if name in files] + [one.instrument for one in sets if one.instrument]
    copies = {folder / files[name].name: files[name].read_bytes() for name in copied}
    for one in sets:
        copies |= {folder / name: data for name, data in one.make().items()}
    existing = [path for path in copies if path.exists()]
    for path in existing:
        if path.is_dir() or path.read_bytes() != copies[path]:
            raise FileExistsError(errno.EEXIST, "File exists and differs from the example", str(path))
    folder.mkdir(parents=True, exist_ok=True)
    with atomic.whole_files() as write:
        for path in copies.keys() - existing:
            write(path, copies[path])
    report = written(path for path in copies if path not in existing)
    parts: Parts = [*report.parts, *(f"{path} is already there, unchanged" for path in existing)]
    for one in sets:
        parts += [*(Text(continued(f"  {command}")) for command in one.commands), f"true: {one.truth}"]
    data = [{"commands": list(one.commands), "truth": one.truth} for one in sets]
    return Report(report.facts | ({"data": data} if data else {}), parts)


def _list_examples(files: dict[str, Path], terms: list[str]) -> Report:
    """Return the list of the examples that contain all `terms`, a table for each kind."""
    from lommel.cli.example_data import SETS

    named = [(KINDS[path.parent.name][0], name, _title(path)) for name, path in files.items()]
    named += [("data", name, one.title) for name, one in SETS.items()]
    rows = [
        {"name": name, "kind": kind, "what": title}
        for kind, name, title in named
        if all(term in f"{kind} {name} {title}".lower() for term in terms)
    ]
    parts: Parts = []
    for kind, heading in _HEADINGS.items():
        if found := [row for row in rows if row["kind"] == kind]:
            parts += [*([""] if parts else []), records_of(heading, found, ("name", "what"))]
    return Report({"examples": rows}, parts or ["No example has these words."])


_HEADINGS = {
    "lens": "Lenses",
    "objective": "Objectives",
    "camera": "Cameras",
    "notebook": "Notebooks",
    "data": "Data",
}


def _suggest(name: str, names: list[str]) -> str:
    """Return a suggestion for a misspelt name of an example, or how to list the names."""
    suggestion = near(name, names)
    return suggestion if suggestion.startswith("did") else "`lommel examples` lists them"


def _title(path: Path) -> str:
    """Return the name in a lens or objective file, or the heading of a notebook."""
    from lommel.lensfiles import toml_files

    if path.suffix == ".toml":
        return str(toml_files.parsed(path)[1]["name"])
    heading: str = json.loads(path.read_bytes())["cells"][0]["source"][0]
    return heading.lstrip("# ").rstrip()


@command
def live(
    lens: Path | None = None,
    /,
    *,
    port: Annotated[int | None, In(least=0, most=65535)] = None,
    no_browser: bool = False,
    saved: Annotated[Path | None, Shown(("--save",), metavar="FILE", writes=True)] = None,
) -> None:
    """Open an interactive page of the PSF in the browser.

    The page shows the PSF, its curves and a test image, with sliders for every parameter. It starts with the lens
    file LENS or, if none is given, with a defocused lens. All computation is done in the browser; the page is served
    to this machine only, stops at Ctrl-C, and sends no data.

    Parameters
    ----------
    port
        Port of the page; by default any free port.
    no_browser
        Print the address without opening a browser.
    saved
        Write the page to a stand-alone HTML file instead.

    Examples
    --------
      lommel live
      lommel live hubble-1990.toml --port 8000 --no-browser
      lommel live hubble-1990.toml --save hubble.html
    """
    import webbrowser

    from lommel.lensfiles.lens_files import load_instrument
    from lommel.page.server import PageServer, html
    from lommel.page.state import state_of

    state: dict[str, float] = {}
    name = left_out = ""
    if lens is not None:
        instrument = load_instrument(lens)
        state, left_out = state_of(instrument)
        name = instrument.name or lens.name
        if left_out:
            print(f"The page does not show {left_out}.", file=sys.stderr)
    if saved is not None:
        atomic.write(saved, html(state, name, left_out, alone=True).encode())
        print(f"wrote {saved}")
        return
    with PageServer(state, name, port or 0, left_out) as server:
        print(f"{server.url} shows {name or 'lommel'}; Ctrl-C stops it.", flush=True)
        if not no_browser:
            webbrowser.open(server.url)
        try:
            server.serve_forever()
        except KeyboardInterrupt:
            print()


_NOTES = {"HuygensFresnel": "flat, thin lens without the Fresnel approximation", "Geometric": "no diffraction"}


@command
def info(
    lens: Path, /, *, optics: Optics = Optics(), depth: Annotated[float | None, Shown(length="um")] = None
) -> Report:
    """Print the image quality of a lens or a microscope.

    Lens: wavefront in radians and waves, aperture, Airy radius, geometric blur, Strehl ratio and Marechal's estimate,
    full width at half maximum (FWHM), for circular apertures the MTF at the Nyquist frequency and the frequency at
    which it falls to 50 %, encircled energy (also without aberrations), and the difference between the paraxial and
    the aplanatic model of the lens.

    Microscope (a file with a section [objective]): focus position, width and peak against the depth of the emitter,
    collected light, critical angle, and Nyquist sampling.

    Parameters
    ----------
    shape
        Window in pixels in which the paraxial and the aplanatic model are compared, such as 65 or 64x128 (height x
        width); overrides the file.
    depth
        Depth of the emitter below the cover glass of a microscope, such as 2um; by default from the file.

    Examples
    --------
      lommel info phone.toml --object-distance 3m
      lommel info zeiss-63x-1.4-oil.toml --depth 10um
    """
    from lommel.report.optics import describe_lens, describe_microscope  # slow, and other commands do not need it

    microscope = microscope_of(lens, depth=depth, **vars(optics))
    return (
        describe_lens(instrument_of(lens, **vars(optics))) if microscope is None else describe_microscope(microscope)
    )


@command
def compare(
    lens: Path,
    /,
    *,
    shape: Annotated[Any, WINDOW] = None,
    place: Annotated[tuple[float, float] | None, PLACE] = None,
    figure: Annotated[Path | None, PLOT._replace(flags=("--figure",))] = None,
) -> Report:
    """Compare the accuracy and speed of all methods for a lens.

    The reference has a proven error bound: for circular and annular apertures Hankel (direct quadrature) if the
    wavefront is radially symmetric, otherwise NijboerZernike at a tolerance of 1e-9; for other apertures
    NonuniformFFT at a tolerance of 1e-9. Methods are listed by the names that `lommel psf --method` takes. Those that
    do not support the pupil are listed below with the reason.

    Errors are relative to the peak of the reference; MSE is the mean squared error divided by the square of the peak.
    For a paraxial lens the error listed for HuygensFresnel is the error of the Fresnel approximation, which all other
    methods use. HuygensFresnel is always compared at pixel centres. ClosedForm uses the
    values of its options `tangent` and `erf` (see `lommel methods`) that give the least MSE in this window. Times are
    measured at the second call, or at the first if it takes more than 1 s. The last line compares the paraxial and
    the aplanatic model of the lens.

    Parameters
    ----------
    shape
        Window in pixels, such as 65 or 64x128 (height x width); overrides the file.
    place
        Place on the sensor, from its middle right and down (in FITS pictures up), such as 1.5mm -2mm; needs a section
        [field]. By default the axis.
    figure
        Figure of the reference, error maps of the other methods, slices: .png, .pdf or .svg.

    Examples
    --------
      lommel compare phone.toml --figure methods.png
    """
    from lommel.report.image_quality import compare_methods, other_model
    from lommel.report.optics import describe_place
    from lommel.show import plot

    instrument = instrument_of(lens, shape=shape, place=place)
    pupil = instrument.pupil()
    with progress("", total=len(METHODS) + 1) as status:
        # The closed form of the paper with its best options, for a fair comparison.
        best = ClosedForm.best(pupil, instrument.window, instrument.side) if pupil.radial else ClosedForm()
        methods = [best if kind is ClosedForm else kind() for kind in METHODS.values()]
        rows, answers = compare_methods(instrument, methods, status)
        reference = next(iter(answers))
        sampling = answers[reference].sampling
        notes = []
        for row in rows:
            method, why = row["method"], _reason(row)
            row["name"] = name = _command_line_name(method)
            note = why or ("the reference" if method == reference else _NOTES.get(method, ""))
            if method == "HuygensFresnel" and instrument.lens.model == "aplanatic":
                note = "aplanatic model without expansion in powers of the pupil radius"
            if row["sampling"] not in (None, sampling):
                note = f"{SAMPLING[row['sampling']]}; {note}"
            if note:
                notes.append(Wrapped(f"{name}: {note}", "dim"))
        by_name = {_command_line_name(name): answer for name, answer in answers.items()}
        save_figure(lambda: plot.compare(by_name, next(iter(by_name))), figure)
    table = records_of("", rows, ("name", "seconds", "mse", "peak_error", "error_bound"))
    height, width = instrument.window
    size = f"{height} x {width} pixels of {pitch_in_words(instrument.pixel)}, {SAMPLING[sampling]}"
    if all(row["method"] != reference for row in rows):  # the reference is then not marked in the table
        size += f"; reference {next(iter(by_name))}"
    facts: Facts = {"name": instrument.name, "reference": reference, "sampling": sampling, "rows": rows}
    facts["other_model"] = other_model(instrument)
    model = described({"model": instrument.lens.model, "other_model": facts["other_model"]})
    files = written([figure], lambda _: ": the reference, maps of the errors, and slices").parts
    at_place = describe_place(instrument)
    head = [Text(instrument.name, "bold"), *at_place.parts, Wrapped(size)]
    return Report(facts | at_place.facts, [*head, table, *notes, *model, *files])


def _reason(row: dict[str, Any]) -> str:
    """Return the reason why a method does not apply, without the name of the method; empty if the method applies."""
    return str(row["reason"] or "").removeprefix(row["method"]).split(";")[0].strip()


def _command_line_name(method: str) -> str:
    """Return the command-line name of a method, from the name of its class or from its repr."""
    kind, _, options = method.partition("(")
    name = next((name for name, method_class in METHODS.items() if method_class.__name__ == kind), kind)
    return f"{name} ({options}" if options else name


@command
def methods() -> Report:
    """List the methods and their options, for --method and --set.

    Examples
    --------
      lommel methods
    """
    rows: list[Facts] = []
    for name, kind in METHODS.items():
        summary = (kind.__doc__ or "").partition("\n")[0].replace("``", "").rstrip(".")
        options = {item.name: _default(item) for item in dataclasses.fields(kind)}  # type: ignore[arg-type]
        rows.append({"name": name, "what": summary, "options": options})
    shown = [row | {"options": " ".join(f"{name}={value}" for name, value in row["options"].items())} for row in rows]
    return Report({"methods": rows}, [records_of("", shown)])


def _default(item: dataclasses.Field[object]) -> str:
    """Return the default of an option in the syntax of --set."""
    factory = item.default_factory
    default = item.default if factory is dataclasses.MISSING else factory()
    return next((name for name, kind in ERFS.items() if isinstance(default, kind)), str(default).lower())


@command
def paper(
    outdir: Path,
    /,
    *,
    figures: Annotated[tuple[Literal["1", "2", "3", "4", "5", "6", "7", "eq17"], ...], Shown(("--figure",))] = (),
) -> Report:
    """Reproduce the figures and numbers of the paper.

    The paper is "Bridging ray tracing and wave optics: a computationally efficient model for defocus and spherical
    aberration", the source of the method closed-form. This takes about half a minute.

    Each figure is written to OUTDIR as figure-N.png, its data as figure-N.npz, its curves as figure-N.csv. table.md
    and table.json compare each number of the paper with the computed one, for Eq. (12) as printed and as corrected.

    Parameters
    ----------
    figures
        Compute only this figure, without the table; may be repeated. eq17: piecewise quadratic phase of Eq. (17).

    Examples
    --------
      lommel paper out
      lommel paper out --figure 3 --figure eq17
    """
    from lommel.paper.figures import FIGURES, closest_text, reproduce

    selected = list(figures) or None
    with progress("", total=len(selected) if selected else len(FIGURES) + 1) as status:
        results = reproduce(outdir, selected, status)
    parts: Parts = [f"wrote {name}" for name in results["files"]]
    if results["table"] is not None:
        rows = [row | {"closest": closest_text(row["closest"]["printed"])} for row in results["table"]]
        keys = ("quantity", "paper", "printed", "corrected", "closest")
        parts.insert(0, records_of("The numbers of the paper", rows, keys))
    return Report(results, parts)
