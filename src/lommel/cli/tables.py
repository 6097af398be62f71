"""The command line's tables: what :mod:`lommel.cli.reports` says, for people."""

from __future__ import annotations

import math
import sys
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from rich.console import Console
from rich.table import Table

from lommel.base.units import format_length
from lommel.measures.psf_like import checked
from lommel.show.drawing import HOW, MEANING

if TYPE_CHECKING:
    from lommel.estimation.phase_retrieval import Retrieval
    from lommel.field.psf_grid import PSFGrid
    from lommel.lensfiles.instrument import Instrument
    from lommel.psf import PSF


_NOTES = {
    "HuygensFresnel": "takes the lens for a flat, thin one, without the Fresnel approximation",
    "Geometric": "no diffraction",
}


def console_of() -> Console:
    """Return where tables go, standard output."""
    # A pipe has no width; tables are then as wide as they need to be. Names are shown as they are written.
    width = None if sys.stdout.isatty() else 160
    return Console(width=width, markup=False, emoji=False, highlight=False)


def table_of(*names: str, left: int = 0, no_wrap: bool = False, title: str | None = None) -> Table:
    """Return a table with columns of these names, that at the place `left` of words and the others of numbers."""
    table = Table(box=None, pad_edge=False, title=title, title_justify="left")
    for place, name in enumerate(names):
        table.add_column(name, justify="left" if place == left else "right", no_wrap=no_wrap)
    return table


def list_of(rows: Iterable[tuple[str, str]], title: str | None = None) -> Table:
    """Return a table of what there is to say, each with its name."""
    table = Table(box=None, pad_edge=False, title=title, title_justify="left", show_header=False)
    table.add_column(style="cyan")
    table.add_column()
    for row in rows:
        table.add_row(*row)
    return table


def made_how(facts: dict[str, Any]) -> list[tuple[str, str]]:
    """Return rows about the error and the time of values."""
    bound = "none claimed" if facts["error_bound"] is None else f"{facts['error_bound']:.2g} of the peak"
    return [("error bound", bound), ("time", f"{1e3 * facts['seconds']:.1f} ms")]


def print_lens(facts: dict[str, Any]) -> None:
    """Print what :func:`lommel.cli.reports.describe_lens` says."""
    waves = ", ".join(f"{name} = {value:.4g}" for name, value in facts["waves"].items())
    focused, seen = _told_apart(facts["focus_distance"], facts["object_distance"])
    lines = [
        ("lens", f"f = {format_length(facts['focal_length'])}, f/{facts['f_number']:.3g}"
         + (f", obscuration {facts['obscuration']:.3g}" if facts["obscuration"] else "")),
        *_aperture(facts),
        ("focused at", focused),
        ("object at", seen),
        ("wavelength", format_length(facts["wavelength"])),
        ("lambda*N", f"{format_length(facts['wavelength'] * facts['working_f_number'])}"
         f" (working f/{facts['working_f_number']:.4g})"),
        ("pixel", _pitch(facts["pixel"])),
        ("model", _model(facts)),
        *([] if facts["apodization"] == 0.0 else [("amplitude", _amplitude(facts))]),
        *([] if _identical(facts["other_model"]) else [("other model", model_in_words(facts["other_model"]))]),
        ("defocus C_d", f"{facts['defocus']:.4g} rad"),
        ("spherical C_s", f"{facts['spherical']:.4g} rad"),
        *[(f"rho^{6 + 2 * k}", f"{c:.4g} rad") for k, c in enumerate(facts["higher"])],
        ("in waves", waves),
        ("Airy radius", format_length(facts["airy_radius"])),
        ("geometric blur radius", format_length(facts["geometric_radius"])),
        ("rms wavefront error", f"{facts['rms_waves']:.4g} waves"),
        ("Strehl ratio (on axis)", "-" if facts["strehl"] is None else f"{facts['strehl']:.4g}"),
        ("Marechal's estimate", f"{facts['marechal']:.4g}"
         + (" (holds where it is above 0.3)" if facts["marechal"] < 0.3 else "")),
        ("full width at half", "-" if facts["fwhm"] is None else format_length(facts["fwhm"])),
        *([
            ("MTF falls to 50 % at", f"{_per_mm(facts['mtf50'])} (cutoff {_per_mm(facts['cutoff'])})"),
        ] if facts["mtf50"] is not None else []),
        *([
            ("MTF at Nyquist", f"{facts['mtf_at_nyquist']:.4g} at {_per_mm(facts['nyquist'])},"
             f" with the pixel {facts['mtf_at_nyquist_with_pixel']:.4g}"),
        ] if facts["mtf_at_nyquist_with_pixel"] is not None else []),
    ]  # fmt: skip
    terms = table_of("name", "(n, m)", "waves rms", title="Zernike terms")
    for term in facts["zernike"]:
        terms.add_row(term["name"], f"({term['n']}, {term['m']})", f"{term['waves_rms']:+.4g}")
    energies = table_of("within", "radius", "this lens", "unaberrated", title="Encircled energy")
    for row in facts["encircled_energy"]:
        here = "-" if row["fraction"] is None else f"{row['fraction']:.1%}"
        ideal = "-" if row["unaberrated"] is None else f"{row['unaberrated']:.1%}"
        energies.add_row(row["within"], format_length(row["radius"]), here, ideal)
    console = console_of()
    console.print(facts["name"], style="bold")
    console.print(list_of(lines))
    if any(term["m"] for term in facts["zernike"]):
        console.print()
        console.print(terms)
    if facts["field"] is not None:
        _print_field_of_lens(console, facts["field"])
    console.print()
    console.print(energies)
    if facts["encircled_energy_error"] is not None:
        console.print(f"errors below {facts['encircled_energy_error']:.1g}", style="dim")
    elif any(facts["aperture"].values()):
        console.print("no error bound", style="dim")
    for reason in facts["refused"]:
        console.print(f"not all could be computed: {reason}", style="dim")


def _told_apart(*distances: float | None) -> list[str]:
    """Return lengths with as many digits as it takes to tell those apart that differ."""
    for digits in range(4, 13):
        texts = ["infinity" if d is None else format_length(d, digits=digits) for d in distances]
        if len(set(texts)) == len(set(distances)):
            break
    return texts


def _print_field_of_lens(console: Console, field: dict[str, Any]) -> None:
    seidel = ", ".join(f"{name} = {waves:.4g}" for name, waves in field["seidel"].items())
    if seidel:
        seidel = f": {seidel} waves {format_length(field['reach'])} from the axis"
    names = ("from the axis", "Strehl ratio", "rms (waves)", "largest Zernike terms (waves rms)")
    table = table_of(*names, left=3, title=f"Over the field{seidel}")
    for place in field["places"]:
        largest = sorted(place["zernike"], key=lambda term: -abs(term["waves_rms"]))[:3]
        terms = ", ".join(f"{term['name']} {term['waves_rms']:+.2g}" for term in largest if term["waves_rms"])
        distance = format_length(place["distance"], like=field["reach"])
        table.add_row(distance, f"{place['strehl']:.4g}", f"{place['rms_waves']:.4g}", terms)
    console.print()
    console.print(table)
    console.print("along a diagonal of the sensor; all else is of the axis", style="dim")


def _amplitude(facts: dict[str, Any]) -> str:
    kind = facts["apodization"]
    if isinstance(kind, float):
        name = f"Gaussian, exp(-{kind:.4g} rho^2)"
    else:
        name = "cos(theta)^(-1/2)" if kind == "aplanatic" else "a polynomial of rho^2 in the exponent"
    return f"{name}: at the rim {facts['rim_amplitude']:.4g} of that of the middle"


def _model(facts: dict[str, Any]) -> str:
    side = f", corrected for the {facts['corrected_for']}" if facts["model"] == "aplanatic" else ""
    return f"{facts['model']}{side}"


def model_in_words(other: dict[str, Any]) -> str:
    """Return in a line what :func:`lommel.cli.reports.other_model` says."""
    if other["reason"] is not None:
        return f"{other['model']}: {other['reason']}"
    if _identical(other):
        return f"{_model(other)}: identical"
    return (
        f"{_model(other)}: differs by {other['peak_error']:.2g} of the peak, geometric blur radius "
        f"{format_length(other['geometric_radius'])}"
    )


def _identical(other: dict[str, Any]) -> bool:
    """Return whether the other model makes the same PSF within the tolerance of both, 1e-6."""
    return other["reason"] is None and bool(other["peak_error"] < 1e-6)


def _aperture(facts: dict[str, Any]) -> list[tuple[str, str]]:
    """Return rows about what narrows the aperture, if anything does."""
    spider, edge, mask = (facts["aperture"][name] for name in ("spider", "vignetting", "mask"))
    rows = []
    if spider is not None:
        angles = ", ".join(f"{math.degrees(angle):.4g}" for angle in spider["angles"])
        width = format_length(spider["width"] * 0.5 * facts["aperture_diameter"])
        rows.append(("vanes", f"{width} wide, at {angles} degrees from x to y"))
    if edge is not None and edge["name"] == "Ellipse":
        rows.append(
            ("ellipse", f"{edge['a']:.4g} x {edge['b']:.4g} radii, at {math.degrees(edge['angle']):.4g} degrees")
        )
    elif edge is not None:
        x, y = edge["shift"]
        rows.append(("cat's eye", f"a circle of {edge['radius']:.4g} radii around ({x:.4g}, {y:.4g})"))
    if mask is not None:
        rows.append(("mask", f"{mask['side']} x {mask['side']} samples"))
    return [*rows, ("clear area", f"{facts['clear_area']:.2%} of the full aperture")] if rows else []


def _per_mm(frequency: float) -> str:
    return f"{1e-3 * frequency:.4g} cycles/mm"


def print_mtf(facts: dict[str, Any]) -> None:
    """Print what :func:`lommel.cli.reports.describe_mtf` says."""
    first = facts["rows"][0]
    places, channels = first["x"] is not None, first["channel"] is not None
    heads = [*(("place x, y",) if places else ()), *(("channel",) if channels else ())]
    columns = ("x, Nyquist", "y, Nyquist", "x, half", "y, half")
    table = table_of(*heads, *columns, left=0 if heads else -1, title="MTF, with the pixel")
    for row in facts["rows"]:
        name = [f"{format_length(row['x'], like=1e-3)}, {format_length(row['y'], like=1e-3)}"] if places else []
        name += [row["channel"]] if channels else []
        table.add_row(*name, *(f"{value:.4f}" for part in ("nyquist", "half_nyquist") for value in row[part]))
    console = console_of()
    console.print()
    console.print(table)
    across, down = (_per_mm(frequency) for frequency in facts["frequency"])
    at = across if across == down else f"{across} along x and {down} along y"
    console.print(f"Nyquist: {at}; along x the frequency is that of vertical lines", style="dim")


def print_psf(answer: PSF, facts: dict[str, Any]) -> None:
    """Print what :func:`lommel.cli.reports.describe_psf` says."""
    lines = [
        ("method", repr(answer.method)),
        ("values", f"{' x '.join(map(str, facts['shape']))} {facts['dtype']}, {MEANING[facts['normalize']]}"),
        ("pixels", f"{HOW[facts['sampling']]}, {facts['pixel_over_lambda_N']:.3g} lambda*N wide"),
        ("largest value", f"{facts['peak']:.4g}"),
        ("energy in the window", f"{facts['energy']:.2%}"),
        *made_how(facts),
    ]
    console = console_of()
    console.print()
    console.print(list_of(lines, title="PSF"))
    if facts["sum"] is not None:
        console.print(
            f"The values sum to {facts['sum']:.4g}, not to the light in the window: samples this far apart are no "
            "share of it. A sensor averages: --integrate."
        )
    if facts["wide_enough"] is not None:
        side = facts["wide_enough"]
        console.print(
            f"The window holds {facts['energy']:.0%} of the light; {side} x {side} pixels would hold about 98 %: "
            f"--shape {side}."
        )


def print_field(grid: PSFGrid, facts: dict[str, Any]) -> None:
    """Print what :func:`lommel.cli.reports.describe_field` says: the largest value of each PSF, in its place."""
    rows, columns, height, width = facts["shape"]
    lines = [
        ("sensor", f"{format_length(facts['sensor'][0])} x {format_length(facts['sensor'][1])} (height x width)"),
        ("method", repr(checked(grid.psf).method)),
        ("values", f"{rows} x {columns} PSFs of {height} x {width} {facts['dtype']}, {MEANING[facts['normalize']]}"),
        ("pixel", f"{_pitch(facts['pixel'])}, {HOW[facts['sampling']]}"),
    ]
    if facts["sum"] is not None:
        sums = [value for row in facts["sum"] for value in row]
        said = f"{min(sums):.4g} to {max(sums):.4g}: samples this far apart are no share of the light"
        lines.append(("sums of the values", said))
    held = [value for row in facts["energy"] for value in row]
    lines.append(("energy in a window", f"{min(held):.2%} to {max(held):.2%}"))
    peaks = Table(box=None, pad_edge=False, title="Largest value at y (down) and x (across)", title_justify="left")
    peaks.add_column("", style="cyan", justify="right", no_wrap=True)
    reach = max(facts["sensor"])
    for x in facts["x"]:
        peaks.add_column(format_length(x, like=reach), justify="right", no_wrap=True)
    for y, values in zip(facts["y"], facts["peak"], strict=True):
        peaks.add_row(format_length(y, like=reach), *(f"{value:.4g}" for value in values))
    console = console_of()
    console.print(facts["name"], style="bold")
    console.print(list_of([*lines, *made_how(facts)]))
    if min(held) < 0.95:
        console.print(f"One window holds {min(held):.0%} of the light only; larger ones hold more: --shape.")
    console.print()
    console.print(peaks)


def print_comparison(
    instrument: Instrument, rows: list[dict[str, Any]], reference: str, sampling: str, other: dict[str, Any]
) -> None:
    """Print the rows of :func:`lommel.cli.reports.compare`, judged by the `reference` of that name."""
    height, width = instrument.window
    size = f"{height} x {width} pixels of {_pitch(instrument.pixel)}, {HOW[sampling]}"
    table = table_of("method", "time", "MSE", "peak error", "error bound", no_wrap=True)
    table.add_column("")

    def number(value: float | None) -> str:
        return "-" if value is None else f"{value:.2g}"

    for row in rows:
        # "X supports defocus only; this pupil ..." stands beside the name of X.
        reason = row["reason"] and row["reason"].removeprefix(row["method"]).split(";")[0].strip()
        note = reason or ("the reference" if row["method"] == reference else _NOTES.get(row["method"], ""))
        if row["method"] == "HuygensFresnel" and instrument.lens.model == "aplanatic":
            note = "the same model, without its expansion in powers of rho"
        if row["sampling"] not in (None, sampling):
            note = f"{HOW[row['sampling']]}; {note}"
        spent = "-" if row["seconds"] is None else f"{1e3 * row['seconds']:.1f} ms"
        errors = (number(row[key]) for key in ("mse", "peak_error", "error_bound"))
        table.add_row(row["method"], spent, *errors, note)
    console = console_of()
    console.print(instrument.name, style="bold")
    # A reference with a row of its own is marked there.
    console.print(size if any(row["method"] == reference for row in rows) else f"{size}; judged by {reference}")
    console.print(table)
    console.print(f"model: {instrument.lens.model}; {model_in_words(other)}")


def print_examples(rows: list[dict[str, Any]]) -> None:
    """Print the rows of ``lommel examples``."""
    table = Table(box=None, pad_edge=False)
    for name in ("name", "kind", "what it is"):
        table.add_column(name, no_wrap=name != "what it is")
    for row in rows:
        table.add_row(row["name"], row["kind"], row["what"])
    console_of().print(table)


def print_methods(rows: list[dict[str, Any]]) -> None:
    """Print the rows of ``lommel methods``."""
    table = Table(box=None, pad_edge=False, show_lines=False)
    for name in ("method", "what it is", "options (defaults)"):
        table.add_column(name, no_wrap=name == "method")
    for row in rows:
        table.add_row(row["name"], row["what"], " ".join(f"{name}={value}" for name, value in row["options"].items()))
    console_of().print(table)


def print_numbers(rows: list[dict[str, Any]]) -> None:
    """Print the rows of :func:`lommel.paper.numbers.rows`."""
    from lommel.paper.numbers import closest_text, number

    names = ("quantity", "paper", "as printed", "corrected", "closest, as printed")
    table = table_of(*names, no_wrap=True, title="The numbers of the paper")
    for row in rows:
        values = [number(row[key]) for key in ("paper", "printed", "corrected")]
        table.add_row(row["quantity"], *values, closest_text(row["closest"]["printed"]))
    console_of().print(table)


def print_retrieval(found: Retrieval, unit: str) -> None:
    """Print what was found behind images, the wavefront in this unit, and what it is worth."""
    from lommel.estimation.phase_retrieval import label

    console = console_of()
    short = {"radians": "rad"}.get(unit, unit)
    values, deviations = found.in_unit(unit)
    table = table_of("term", f"{short}", "+-")
    for name, value in values.items():
        table.add_row(label(name), *_with_deviation(value, deviations[name]))
    for name in found.coefficients.keys() - values.keys():
        cells = _with_deviation(found.coefficients[name], found.deviation[name])
        table.add_row(f"{name} {found.units[name]}".rstrip(), *cells)
    console.print(table)
    console.print()
    own = [name for name in ("row", "column", "flux", "background") if name in found.deviation]
    each = dict(zip(("row", "column"), found.center.T, strict=True)) | {
        "flux": found.flux,
        "background": found.background,
    }
    images = table_of("image", *(column for name in own for column in (name, "+-")))
    for k in range(len(found.flux)):
        pairs = [_with_deviation(float(each[name][k]), float(found.deviation[name][k])) for name in own]
        images.add_row(str(k), *(cell for pair in pairs for cell in pair))
    console.print(images)
    console.print()
    console.print(found.message)


def print_precision(rows: Iterable[tuple[float, float]]) -> None:
    """Print distances and how well each can be known, metres."""
    table = table_of("distance", "+-", "of it")
    for distance, deviation in rows:
        known = math.isfinite(deviation)
        share = f"{100.0 * deviation / distance:.2g} %" if known else ""
        table.add_row(format_length(distance), format_length(deviation, digits=3) if known else "inf", share)
    console_of().print(table)


def _with_deviation(value: float, deviation: float) -> tuple[str, str]:
    """Return a number and its deviation, which has two digits, to the same place."""
    if not 0.0 < deviation < math.inf:
        return f"{value:.6g}", "-" if deviation == 0.0 else "inf"
    places = max(0, 1 - math.floor(math.log10(deviation)))
    return f"{value:.{places}f}", f"{deviation:.{places}f}"


def _pitch(pixel: float | Sequence[float]) -> str:
    """Return the side of a pixel with its unit, or height and width."""
    return " x ".join(format_length(side) for side in ([pixel] if isinstance(pixel, float) else pixel))
