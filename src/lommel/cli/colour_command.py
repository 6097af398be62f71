"""What ``lommel psf --colour`` does: PSFs in the channels of a sensor."""

from __future__ import annotations

import time
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import click

from lommel.base.units import format_length
from lommel.base.validation import shown
from lommel.channel_psf import ColourPSF, colour_psf
from lommel.cli import reports
from lommel.cli.parts import figure_format, print_json, save_figure
from lommel.cli.progress import progress
from lommel.cli.tables import console_of, list_of, print_mtf, table_of
from lommel.io import colour_files, field_files
from lommel.optics.colour.spectrum import Channels
from lommel.show.drawing import HOW, MEANING

if TYPE_CHECKING:
    from lommel.field.psf_grid import PSFGrid
    from lommel.lensfiles.instrument import Instrument


def psf(
    instrument: Instrument,
    field: Any,
    outputs: tuple[Path, ...],
    figure: Path | None,
    as_json: bool,
    options: dict[str, Any],
    *,
    mtf: bool = False,
) -> None:
    """Compute PSFs in the channels of a lens file, or in red, green and blue, print what they are, and write them."""
    for path in outputs:
        (colour_files if field is None else field_files).find(path, "--output")
        if field is not None and path.suffix.lower() not in (".npz", ".zarr"):
            raise ValueError(
                f"--colour with --field writes .npz or .zarr, got {shown(str(path))}; leave out --field for the "
                f"colours of one place, or --colour for one wavelength"
            )
    if figure is not None:
        figure_format(figure)
    channels = instrument.channels or Channels.rgb()
    window, pixel = instrument.window, instrument.pixel
    with progress(f"{len(channels)} channels of {window[0]} x {window[1]} pixels"):
        start = time.perf_counter()
        answer: ColourPSF | PSFGrid
        if field is None:
            made = answer = colour_psf(instrument.pupil(), window, pixel, channels, **options)
        else:
            if not isinstance(field, tuple) or len(field) != 2:
                raise ValueError(f"--field must be ROWSxCOLUMNS such as 5x7, got {shown(field)}")
            places = instrument.field()
            assert instrument.sensor is not None  # where there is a field
            answer = places.grid(
                *field, sensor=instrument.sensor, shape=window, pixel=pixel, channels=channels, **options
            )
            assert isinstance(answer.psf, ColourPSF)
            made = answer.psf
        seconds = time.perf_counter() - start
        facts = _facts(instrument, made, seconds)
        if mtf:
            grid = None if field is None else cast("PSFGrid", answer)
            facts |= {"mtf": reports.describe_mtf(instrument, grid, channels)}
        for path in outputs:
            answer.save(path)
        if figure is not None:
            axes = answer.plot()
            first = axes.flat[0] if hasattr(axes, "flat") else axes
            if field is None:
                first.figure.suptitle(instrument.name, fontsize=9)
            else:
                first.set_title(instrument.name, fontsize=9, loc="left", pad=22)
            save_figure(first.figure, figure)
    files = [str(path) for path in (*outputs, *([figure] if figure else []))]
    if as_json:
        print_json(facts | {"files": files})
        return
    _print(facts)
    if mtf:
        print_mtf(facts["mtf"])
    for name in files:
        click.echo(f"wrote {name}")


def _facts(instrument: Instrument, answer: ColourPSF, seconds: float) -> dict[str, Any]:
    """Return what there is to say, the largest values and the light in the window over all of a stack."""
    each = [
        {
            "name": name,
            "wavelengths": [w for w, _ in pairs],
            "weights": [share for _, share in pairs],
            "light": light,
            "peak": float(one.values.max()),
            "energy": float(one.values.sum(axis=(-2, -1), dtype=float).mean())
            if answer.normalize == "energy"
            else None,
        }
        for (name, pairs), light, one in zip(answer.channels, answer.channels.light, answer, strict=True)
    ]
    made = reports.how_made(answer[0], seconds)
    kept = {name: made[name] for name in ("sampling", "pixel", "dtype", "normalize", "seconds")}
    said = {"shape": list(answer.shape), "error_bound": answer.error_bound, "of_spectra": answer.channels.error}
    return {"name": instrument.name, "source": instrument.source} | kept | said | {"channels": each}


def _print(facts: dict[str, Any]) -> None:
    bound = "none claimed" if facts["error_bound"] is None else f"{facts['error_bound']:.2g} of the peak of a channel"
    rows = [
        ("values", f"{' x '.join(map(str, facts['shape']))} {facts['dtype']}, {MEANING[facts['normalize']]}"),
        ("pixel", f"{format_length(facts['pixel'])}, {HOW[facts['sampling']]}"),
        ("error bound", bound),
        ("time", f"{1e3 * facts['seconds']:.1f} ms"),
    ]
    if facts["of_spectra"]:
        rows.insert(
            3, ("few wavelengths", f"off by {facts['of_spectra']:.2g} of the peak without aberration at most")
        )
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
