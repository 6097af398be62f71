"""The tables that the commands print."""

from __future__ import annotations

import math
import sys
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from rich.console import Console
from rich.table import Table

from lommel.base.units import format_length
from lommel.cli.options import Facts
from lommel.measures.psf_like import checked
from lommel.show.drawing import HOW, MEANING

if TYPE_CHECKING:
    from lommel.estimation.phase_retrieval import Retrieval
    from lommel.field.psf_grid import PSFGrid
    from lommel.lensfiles.instrument import Instrument
    from lommel.psf import PSF


_NOTES = {
    "HuygensFresnel": "flat, thin lens without the Fresnel approximation",
    "Geometric": "no diffraction",
}


def console_of() -> Console:
    """Return the console of standard output."""
    # A pipe has no width; tables are then as wide as they need to be. Brackets in names are no markup.
    width = None if sys.stdout.isatty() else 160
    return Console(width=width, markup=False, emoji=False, highlight=False)


def table_of(*names: str, left: int = 0, no_wrap: bool = False, title: str | None = None) -> Table:
    """Return a table with columns of these names, numbers but for the column at `left`, which holds words."""
    table = Table(box=None, pad_edge=False, title=title, title_justify="left")
    for place, name in enumerate(names):
        table.add_column(name, justify="left" if place == left else "right", no_wrap=no_wrap)
    return table


def list_of(rows: Iterable[tuple[str, str]], title: str | None = None) -> Table:
    """Return a table of names and values."""
    table = Table(box=None, pad_edge=False, title=title, title_justify="left", show_header=False)
    table.add_column(style="cyan")
    table.add_column()
    for row in rows:
        table.add_row(*row)
    return table


def _error_and_time(facts: Facts) -> list[tuple[str, str]]:
    """Return rows for the error bound and the time."""
    bound = "none" if facts["error_bound"] is None else f"{facts['error_bound']:.2g} of the peak"
    return [("error bound", bound), ("time", f"{1e3 * facts['seconds']:.1f} ms")]


def print_lens(facts: Facts) -> None:
    """Print the description of a lens."""
    waves = ", ".join(f"{name} = {value:.4g}" for name, value in facts["waves"].items())
    focused, seen = _distinct(facts["focus_distance"], facts["object_distance"])
    lines = [
        ("lens", f"f = {format_length(facts['focal_length'])}, f/{facts['f_number']:.3g}"
         + (f", obscuration {facts['obscuration']:.3g}" if facts["obscuration"] else "")),
        *_aperture(facts),
        ("focus distance", focused),
        ("object distance", seen),
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
         + (" (valid above 0.3)" if facts["marechal"] < 0.3 else "")),
        ("FWHM", "-" if facts["fwhm"] is None else format_length(facts["fwhm"])),
        *([
            ("MTF50", f"{_per_mm(facts['mtf50'])} (cutoff {_per_mm(facts['cutoff'])})"),
        ] if facts["mtf50"] is not None else []),
        *([
            ("MTF at Nyquist", f"{facts['mtf_at_nyquist']:.4g} at {_per_mm(facts['nyquist'])},"
             f" pixel included {facts['mtf_at_nyquist_with_pixel']:.4g}"),
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
        console.print(f"error bound {facts['encircled_energy_error']:.1g}", style="dim")
    elif any(facts["aperture"].values()):
        console.print("no error bound", style="dim")
    for reason in facts["refused"]:
        console.print(f"not computed: {reason}", style="dim")


def _distinct(*distances: float | None) -> list[str]:
    """Return lengths with enough digits for different ones to look different."""
    for digits in range(4, 13):
        texts = ["infinity" if d is None else format_length(d, digits=digits) for d in distances]
        if len(set(texts)) == len(set(distances)):
            break
    return texts


def _print_field_of_lens(console: Console, field: Facts) -> None:
    seidel = ", ".join(f"{name} = {waves:.4g}" for name, waves in field["seidel"].items())
    if seidel:
        seidel = f": {seidel} waves at an image height of {format_length(field['reach'])}"
    names = ("image height", "Strehl ratio", "rms (waves)", "largest Zernike terms (waves rms)")
    table = table_of(*names, left=3, title=f"Field{seidel}")
    for place in field["places"]:
        largest = sorted(place["zernike"], key=lambda term: -abs(term["waves_rms"]))[:3]
        terms = ", ".join(f"{term['name']} {term['waves_rms']:+.2g}" for term in largest if term["waves_rms"])
        distance = format_length(place["distance"], like=field["reach"])
        table.add_row(distance, f"{place['strehl']:.4g}", f"{place['rms_waves']:.4g}", terms)
    console.print()
    console.print(table)
    console.print("along a diagonal of the sensor; all other values are on the axis", style="dim")


def _amplitude(facts: Facts) -> str:
    kind = facts["apodization"]
    if isinstance(kind, float):
        name = f"Gaussian, exp(-{kind:.4g} rho^2)"
    else:
        name = "cos(theta)^(-1/2)" if kind == "aplanatic" else "exponential of a polynomial in rho^2"
    return f"{name}: {facts['rim_amplitude']:.4g} at the edge of the pupil"


def _model(facts: Facts) -> str:
    side = f", corrected for the {facts['corrected_for']}" if facts["model"] == "aplanatic" else ""
    return f"{facts['model']}{side}"


def model_in_words(other: Facts) -> str:
    """Return the difference of the paraxial and the aplanatic model in one line."""
    if other["reason"] is not None:
        return f"{other['model']}: {other['reason']}"
    if _identical(other):
        return f"{_model(other)}: identical"
    return (
        f"{_model(other)}: differs by {other['peak_error']:.2g} of the peak, geometric blur radius "
        f"{format_length(other['geometric_radius'])}"
    )


def _identical(other: Facts) -> bool:
    """Return whether the other model makes the same PSF within the tolerance of both, 1e-6."""
    return other["reason"] is None and bool(other["peak_error"] < 1e-6)


def _aperture(facts: Facts) -> list[tuple[str, str]]:
    """Return rows for the spider, the vignetting and the mask, if there are any."""
    spider, edge, mask = (facts["aperture"][name] for name in ("spider", "vignetting", "mask"))
    rows = []
    if spider is not None:
        angles = ", ".join(f"{math.degrees(angle):.4g}" for angle in spider["angles"])
        width = format_length(spider["width"] * 0.5 * facts["aperture_diameter"])
        rows.append(("vanes", f"{width} wide, at {angles} degrees from x towards y"))
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


def print_mtf(facts: Facts) -> None:
    """Print the MTF of each place and channel."""
    first = facts["rows"][0]
    places, channels = first["x"] is not None, first["channel"] is not None
    heads = [*(("position x, y",) if places else ()), *(("channel",) if channels else ())]
    columns = ("x, Nyquist", "y, Nyquist", "x, half", "y, half")
    table = table_of(*heads, *columns, left=0 if heads else -1, title="MTF, pixel included")
    for row in facts["rows"]:
        name = [f"{format_length(row['x'], like=1e-3)}, {format_length(row['y'], like=1e-3)}"] if places else []
        name += [row["channel"]] if channels else []
        table.add_row(*name, *(f"{value:.4f}" for part in ("nyquist", "half_nyquist") for value in row[part]))
    console = console_of()
    console.print()
    console.print(table)
    across, down = (_per_mm(frequency) for frequency in facts["frequency"])
    at = across if across == down else f"{across} along x and {down} along y"
    console.print(f"Nyquist frequency: {at}; x: vertical lines", style="dim")


def print_psf(answer: PSF, facts: Facts) -> None:
    """Print the description of a PSF."""
    lines = [
        ("method", repr(answer.method)),
        ("values", f"{' x '.join(map(str, facts['shape']))} {facts['dtype']}, {MEANING[facts['normalize']]}"),
        ("pixels", f"{HOW[facts['sampling']]}, {facts['pixel_over_lambda_N']:.3g} lambda*N wide"),
        ("largest value", f"{facts['peak']:.4g}"),
        ("energy in the window", f"{facts['energy']:.2%}"),
        *_error_and_time(facts),
    ]
    console = console_of()
    console.print()
    console.print(list_of(lines, title="PSF"))
    if facts["sum"] is not None:
        console.print(
            f"The values sum to {facts['sum']:.4g}, not to the light in the window: point samples this far apart "
            "miss some of it. Use --integrate for pixel-integrated values."
        )
    if facts["wide_enough"] is not None:
        side = facts["wide_enough"]
        console.print(f"The window holds {facts['energy']:.0%} of the light; --shape {side} would hold about 98 %.")


def print_field(grid: PSFGrid, facts: Facts) -> None:
    """Print the description of a grid of PSFs."""
    rows, columns, height, width = facts["shape"]
    lines = [
        ("sensor", f"{format_length(facts['sensor'][0])} x {format_length(facts['sensor'][1])} (height x width)"),
        ("method", repr(checked(grid.psf).method)),
        ("values", f"{rows} x {columns} PSFs of {height} x {width} {facts['dtype']}, {MEANING[facts['normalize']]}"),
        ("pixel", f"{_pitch(facts['pixel'])}, {HOW[facts['sampling']]}"),
    ]
    if facts["sum"] is not None:
        sums = [value for row in facts["sum"] for value in row]
        said = f"{min(sums):.4g} to {max(sums):.4g}: point samples this far apart miss some of the light"
        lines.append(("sums of the values", said))
    held = [value for row in facts["energy"] for value in row]
    lines.append(("energy in the window", f"{min(held):.2%} to {max(held):.2%}"))
    peaks = Table(box=None, pad_edge=False, title="Largest value at y (down) and x (across)", title_justify="left")
    peaks.add_column("", style="cyan", justify="right", no_wrap=True)
    reach = max(facts["sensor"])
    for x in facts["x"]:
        peaks.add_column(format_length(x, like=reach), justify="right", no_wrap=True)
    for y, values in zip(facts["y"], facts["peak"], strict=True):
        peaks.add_row(format_length(y, like=reach), *(f"{value:.4g}" for value in values))
    console = console_of()
    console.print(facts["name"], style="bold")
    console.print(list_of([*lines, *_error_and_time(facts)]))
    if min(held) < 0.95:
        console.print(f"One window holds only {min(held):.0%} of the light; a larger --shape holds more.")
    console.print()
    console.print(peaks)


def print_comparison(instrument: Instrument, rows: list[Facts], reference: str, sampling: str, other: Facts) -> None:
    """Print the errors and times of the methods against the reference."""
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
            note = "same model, without its expansion in powers of rho"
        if row["sampling"] not in (None, sampling):
            note = f"{HOW[row['sampling']]}; {note}"
        spent = "-" if row["seconds"] is None else f"{1e3 * row['seconds']:.1f} ms"
        errors = (number(row[key]) for key in ("mse", "peak_error", "error_bound"))
        table.add_row(row["method"], spent, *errors, note)
    console = console_of()
    console.print(instrument.name, style="bold")
    # A reference with a row of its own is marked there.
    console.print(size if any(row["method"] == reference for row in rows) else f"{size}; reference {reference}")
    console.print(table)
    console.print(f"model: {instrument.lens.model}; {model_in_words(other)}")


def print_examples(rows: list[Facts]) -> None:
    """Print the examples."""
    table = Table(box=None, pad_edge=False)
    for name in ("name", "kind", "description"):
        table.add_column(name, no_wrap=name != "description")
    for row in rows:
        table.add_row(row["name"], row["kind"], row["what"])
    console_of().print(table)


def print_methods(rows: list[Facts]) -> None:
    """Print the methods and their options."""
    table = Table(box=None, pad_edge=False, show_lines=False)
    for name in ("method", "description", "options (defaults)"):
        table.add_column(name, no_wrap=name == "method")
    for row in rows:
        table.add_row(row["name"], row["what"], " ".join(f"{name}={value}" for name, value in row["options"].items()))
    console_of().print(table)


def print_numbers(rows: list[Facts]) -> None:
    """Print the numbers of the paper beside the computed ones."""
    from lommel.paper.numbers import closest_text, number

    names = ("quantity", "paper", "as printed", "corrected", "closest, as printed")
    table = table_of(*names, no_wrap=True, title="The numbers of the paper")
    for row in rows:
        values = [number(row[key]) for key in ("paper", "printed", "corrected")]
        table.add_row(row["quantity"], *values, closest_text(row["closest"]["printed"]))
    console_of().print(table)


def print_retrieval(found: Retrieval, unit: str) -> None:
    """Print a retrieved wavefront in a unit, with standard errors and the verdict."""
    from lommel.estimation.phase_retrieval import label

    console = console_of()
    short = {"radians": "rad"}.get(unit, unit)
    values, deviations = found.in_unit(unit)
    table = table_of("term", short, "std. error")
    for name, value in values.items():
        table.add_row(label(name), *_with_error(value, deviations[name]))
    for name in found.coefficients.keys() - values.keys():
        cells = _with_error(found.coefficients[name], found.deviation[name])
        table.add_row(f"{name} {found.units[name]}".rstrip(), *cells)
    console.print(table)
    console.print()
    own = [name for name in ("row", "column", "flux", "background") if name in found.deviation]
    each = dict(zip(("row", "column"), found.center.T, strict=True)) | {
        "flux": found.flux,
        "background": found.background,
    }
    images = table_of("image", *(column for name in own for column in (name, "std. error")))
    for k in range(len(found.flux)):
        pairs = [_with_error(float(each[name][k]), float(found.deviation[name][k])) for name in own]
        images.add_row(str(k), *(cell for pair in pairs for cell in pair))
    console.print(images)
    console.print()
    console.print(found.message)


def print_precision(rows: Iterable[tuple[float, float]]) -> None:
    """Print the depth precision at each distance, metres."""
    table = table_of("distance", "standard deviation", "relative")
    for distance, deviation in rows:
        known = math.isfinite(deviation)
        share = f"{100.0 * deviation / distance:.2g} %" if known else ""
        table.add_row(format_length(distance), format_length(deviation, digits=3) if known else "inf", share)
    console_of().print(table)


def _with_error(value: float, deviation: float) -> tuple[str, str]:
    """Return a number and its standard error, which has two digits, to the same place."""
    if not 0.0 < deviation < math.inf:
        return f"{value:.6g}", "-" if deviation == 0.0 else "inf"
    places = max(0, 1 - math.floor(math.log10(deviation)))
    return f"{value:.{places}f}", f"{deviation:.{places}f}"


def _pitch(pixel: float | Sequence[float]) -> str:
    """Return the pixel pitch with its unit, or height x width."""
    return " x ".join(format_length(side) for side in ([pixel] if isinstance(pixel, float) else pixel))


def print_colour(facts: Facts) -> None:
    """Print the description of PSFs in colour channels."""
    bound = "none" if facts["error_bound"] is None else f"{facts['error_bound']:.2g} of the peak of a channel"
    rows = [
        ("values", f"{' x '.join(map(str, facts['shape']))} {facts['dtype']}, {MEANING[facts['normalize']]}"),
        ("pixel", f"{format_length(facts['pixel'])}, {HOW[facts['sampling']]}"),
        ("error bound", bound),
        ("time", f"{1e3 * facts['seconds']:.1f} ms"),
    ]
    if facts["of_spectra"]:
        rows.insert(3, ("spectral sampling", f"error at most {facts['of_spectra']:.2g} of the unaberrated peak"))
    table = table_of("channel", "wavelengths", "light", "largest value", "sum of values")
    for one in facts["channels"]:
        waves = one["wavelengths"]
        ends = (
            format_length(waves[0])
            if len(waves) == 1
            else (f"{len(waves)} from {format_length(min(waves))} to {format_length(max(waves))}")
        )
        energy = "-" if one["energy"] is None else f"{one['energy']:.2%}"
        table.add_row(one["name"], ends, f"{one['light']:.3g}", f"{one['peak']:.4g}", energy)
    console = console_of()
    console.print(facts["name"], style="bold")
    console.print(list_of(rows))
    console.print()
    console.print(table)


def print_microscope(facts: Facts) -> None:
    """Print the description of a microscope."""
    nyquist = facts["nyquist"]
    lines = [
        ("objective", f"NA {facts['NA']:g}, {facts['magnification']:g}x, immersion {facts['immersion']:g}, "
         f"working distance {format_length(facts['working_distance'])}"),
        ("cover glass", _layer(facts["coverslip"]) or "none (dipping objective)"),
        *[("film", _layer(film)) for film in facts["films"]],
        *([] if facts["design"] is None else [("designed for", _design(facts["design"]))]),
        ("sample", f"index {facts['sample']:g}, emitter at a depth of {format_length(facts['depth'])}"),
        ("critical angle", _angle(facts)),
        ("wavelength", format_length(facts["wavelength"])),
        ("emitter", facts["emitter"]),
        ("planes", _planes(facts)),
        ("pixel", f"{format_length(facts['pixel'])}, {format_length(facts['pixel_in_sample'])} in the sample"),
        ("Nyquist sampling", f"pixel {format_length(nyquist['pixel'])}, "
         f"{format_length(nyquist['lateral'])} in the sample; stage step {format_length(nyquist['axial'])}"),
    ]  # fmt: skip
    console = console_of()
    console.print(facts["name"], style="bold")
    console.print(list_of(lines))
    for name in facts["too_coarse"]:
        limit = nyquist["axial" if name == "step" else "pixel"]
        console.print(
            f"The {name}, {format_length(facts[name])}, is coarser than Nyquist sampling, {format_length(limit)}: "
            "images lose their finest detail. The PSF itself is not affected."
        )
    if facts["focus"]:
        _print_foci(facts)


def _print_foci(facts: Facts) -> None:
    """Print the focus of emitters at several depths."""
    console = console_of()
    heads = (
        "depth um",
        "paraxial um",
        "best um",
        "depth / best",
        "axial nm",
        "lateral nm",
        "peak",
        "/ at 0",
        "light",
    )
    table = table_of(*heads, left=-1, title="Focus of a freely rotating dipole")
    for column in table.columns:
        column.overflow = "fold"  # or digits would be cut off
    for row in facts["focus"]:
        table.add_row(
            f"{1e6 * row['depth']:.4g}",
            *(f"{1e6 * row[name]:.3f}" for name in ("paraxial", "brightest")),
            "-" if row["ratio"] is None else f"{row['ratio']:.3f}",
            *(f"{1e9 * row[name]:.0f}" for name in ("axial_fwhm", "lateral_fwhm")),
            *(f"{row[name]:.3f}" for name in ("peak", "peak_of_surface", "collected")),
        )
    console.print()
    console.print(table)
    console.print(
        "paraxial, best (brightest): stage travel from the focus on the surface of the cover glass; axial, lateral: "
        "full width at half maximum; light: collected light relative to an emitter far from the glass",
        style="dim",
    )
    for reason in facts["refused"]:
        console.print(f"not computed: {reason}", style="dim")


def print_stack(answer: PSF, facts: Facts) -> None:
    """Print the description of a stack of planes."""
    peaks, energies = facts["peak"], facts["energy"]
    lines = [
        ("method", repr(answer.method)),
        ("values", f"{' x '.join(map(str, facts['shape']))} {facts['dtype']}, {MEANING[facts['normalize']]}"),
        ("pixels", f"{format_length(facts['pixel_in_sample'])} in the sample, {HOW[facts['sampling']]}"),
    ]
    if facts["brightest"] is None:
        lines += [("largest value", f"{peaks:.4g}"), ("energy in the window", f"{energies:.2%}")]
    else:
        best = facts["brightest"]
        ends = (format_length(facts[name][best], like=1e-6) for name in ("z", "focus"))
        at = "plane {}, z = {}, stage at {}".format(best, *ends)
        lines += [
            ("largest value", f"{peaks[best]:.4g} in {at}"),
            ("energy in the window", f"{min(energies):.2%} to {max(energies):.2%}, by plane"),
        ]
    console = console_of()
    console.print()
    console.print(list_of([*lines, *_error_and_time(facts)], title="PSF"))


def _layer(layer: dict[str, float] | None) -> str:
    return "" if layer is None else f"{format_length(layer['thickness'])} of index {layer['index']:g}"


def _design(design: Facts) -> str:
    return f"immersion {design['immersion']:g}, cover glass {_layer(design['coverslip']) or 'none'}"


def _angle(facts: Facts) -> str:
    rim = f"pupil edge at {math.degrees(facts['rim_angle']):.1f} deg in the immersion"
    if facts["critical_angle"] is None:
        return f"none, all light of the pupil passes through the sample; {rim}"
    return f"{math.degrees(facts['critical_angle']):.1f} deg; {rim}"


def _planes(facts: Facts) -> str:
    if facts["step"] is None:
        return f"one, at {_ORIGINS[facts['origin']]}"
    return f"{facts['planes']}, {format_length(facts['step'])} apart, centred on {_ORIGINS[facts['origin']]}"


_ORIGINS = {
    "brightest": "the brightest focus of the emitter",
    "paraxial": "the paraxial focus of the emitter",
    "coverslip": "the surface of the cover glass",
}
