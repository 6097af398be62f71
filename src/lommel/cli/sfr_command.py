"""The command ``lommel sfr``: sharpness (spatial frequency response) from a picture of slanted edges."""

from __future__ import annotations

import csv
import io
import json
import math
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, ClassVar

import numpy as np

from lommel import imaging
from lommel.base import atomic, validation
from lommel.base.arrays import plain
from lommel.base.encoding import Encoding, as_json
from lommel.base.options import Shown
from lommel.base.units import format_length, per_mm
from lommel.cli.command import ENCODING, OUTPUT, PLOT, command
from lommel.cli.instruments import PhotoCamera, instrument_of
from lommel.cli.messages import given_flags, report_findings
from lommel.cli.output import figure_format, progress, require_folder, save_figure, written
from lommel.cli.photo_commands import read_as
from lommel.fit.findings import Finding, Findings
from lommel.imaging.focal_engine import UNMEASURED
from lommel.imaging.slanted_edge import frequency_unit
from lommel.measures.transfer import mtf
from lommel.report import Facts, Parts, Report, Wrapped
from lommel.report.table import Continued, known_keys
from lommel.show import estimates

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from lommel.imaging.edge_chart import EdgeChart
    from lommel.lensfiles.instrument import Instrument

_NYQUIST = 0.5  # cycles per pixel
_MOST_ROWS = 12  # of the table of edges; more are in files only
_ZONES = (("centre", 0.0, 0.35), ("middle", 0.35, 0.7), ("corner", 0.7, np.inf))  # of half the diagonal
_PLACES = ("row", "column", "x", "y", "zone", "direction", "channel")
_CURVES = 4  # edges in a figure: nearest to and farthest from the centre, in both directions
_TOL = 1e-4  # of computed MTFs
_APART, _LEAST = 4.0, 0.01  # errors, and difference, from which mean responses are not those of a lens
_TABLES, _MAPS = (".csv", ".json"), (".png", ".pdf", ".svg")


@dataclass(frozen=True, kw_only=True)
class ChartCamera(PhotoCamera):
    """Camera and lens of the picture of a chart.

    Parameters
    ----------
    f_number
        F-number; overrides the lens file.
    object_distance
        Distance of the chart, such as 2m; overrides the lens file.
    """

    heading: ClassVar[str] = "Camera and lens"
    object_distance: Annotated[float | None, Shown(length="m")] = None


@command
def sfr(
    picture: Path,
    /,
    *,
    outputs: Annotated[tuple[Path, ...], OUTPUT] = (),
    figure: Annotated[Path | None, PLOT] = None,
    frequencies: Annotated[tuple[float, ...], Shown(("--frequency",))] = (0.25,),
    lens: Annotated[Path | None, Shown(metavar="FILE")] = None,
    encoding: Annotated[Encoding | None, ENCODING] = None,
    mosaic: Annotated[str | None, Shown(metavar="RGGB")] = None,
    camera: ChartCamera = ChartCamera(),
) -> Report:
    """Measure sharpness (SFR, MTF50) from a picture of a chart.

    PICTURE is a PNG, JPEG, TIFF, EXR, HEIC or raw photo (DNG, NEF, CR2, ..., which LibRaw demosaics), grey or RGB, of
    slanted squares, an ISO 12233 or eSFR chart, a tilted checkerboard, or one edge, at 2 to 45 degrees to the rows or
    columns. Edges are found, and the response of each is measured by ISO 12233, sagittal (S) and tangential (T), in
    each colour.

    Parameters
    ----------
    outputs
        Table of all edges: .csv or .json; map of MTF50: .png, .pdf or .svg. May be repeated.
    figure
        Figure of the response with standard errors, in the centre and in a corner: .png, .pdf or .svg.
    frequencies
        Frequency at which the response is listed, cycles per pixel; repeat for several.
    lens
        Lens file, of which the computed MTF with pixel is listed beside the measured one, and the difference in
        standard errors of both: the f-number is uncertain by 3 %, or as a calibration states. Doubt if they differ.
    encoding
        Encoding of the picture's values: srgb, linear, or a number, as 1.8 for light = value ** 1.8; by default as
        the picture states (ICC profile), else integers are sRGB; floats are linear.
    mosaic
        Colours of a raw picture: the first two pixels of its first and of its second row, such as RGGB.

    Examples
    --------
      lommel sfr squares.png -o map.png -o edges.csv
      lommel sfr squares.tif --pixel 3.45um --frequency 0.125 0.25 --plot curves.png
      lommel sfr squares.png --lens camera-field.toml
      lommel sfr mosaic.tif --mosaic RGGB --encoding linear --pixel 2.4um -o edges.json
    """
    for path in outputs:
        suffix = path.suffix.lower()
        if suffix not in (*_TABLES, *_MAPS):
            names = f"{', '.join(_TABLES)} (table), {', '.join(_MAPS[:-1])} or {_MAPS[-1]} (map)"
            raise ValueError(f"--output must end in {names}, got {validation.shown(str(path))}")
        if suffix in _MAPS:
            figure_format(path)
        require_folder(path)
    for one in frequencies:
        validation.real("--frequency", one, above=0.0, most=_NYQUIST)
    pixel = camera.pixel or (None if camera.camera is None else camera.camera.side)
    instrument = None if lens is None else instrument_of(lens, **vars(camera))
    if instrument is not None:
        pixel = instrument.side
    elif needless := {"focus_distance", "f_number", "object_distance"} & given_flags().keys():
        raise ValueError(f"{given_flags()[min(needless)]} is of a lens file: give --lens")
    with progress("reading") as status:
        photo = imaging.read_photo(picture, encoding)
        status("measuring edges")
        start = time.process_time()
        chart = imaging.sfr_chart(photo.values, pixel, encoding=photo.encoding, mosaic=mosaic)
        rows = chart.rows(frequencies)
        if lens is not None and instrument is not None:
            status("computing the MTF of the lens")
            misfit = _compare(chart, rows, instrument, frequencies, instrument_of(lens).pixel)
            chart = replace(chart, findings=Findings([*misfit, *chart.findings]))
        seconds = time.process_time() - start
    facts = chart.to_dict() | {"edges": rows, "zones": _zones(chart, rows), "pixel": pixel, "notes": []}
    dtype = photo.values.dtype
    facts |= {"encoding": as_json(photo.encoding), "seconds": seconds}
    facts["read"] = read_as(dtype, 8 * dtype.itemsize, photo.encoding, photo.stated)
    for path in outputs:
        if path.suffix.lower() in _TABLES:
            text = json.dumps(facts, indent=2, allow_nan=False) if path.suffix.lower() == ".json" else _csv(rows)
            atomic.write(path, text.encode())
        else:
            save_figure(chart.plot, path)
    save_figure(lambda: _curves(chart), figure)
    parts: Parts = [Wrapped(facts["read"]), Wrapped(chart.message.partition("; ")[0], "bold"), ""]
    edges = rows if len(rows) <= _MOST_ROWS else []
    parts += [_table("medians", _limits(facts["zones"], chart, pixel)), ""]
    if edges:
        hidden = ("findings", "edge", "mtf50_px_above", *(() if pixel is None else ("row", "column")))
        keys = [key for key in rows[0] if key not in hidden and not key.startswith("error_lens")]
        parts += [_table("edges", _limits(rows, chart, pixel), keys), ""]
    parts += [Wrapped(f"lw ph: line widths per picture height, {chart.shape[0]} pixels as shown")]
    if any(record["mtf50_px_above"] is not None for record in (*facts["zones"], *edges)):
        text = (
            "> is the Nyquist frequency of the pixels, or of those of one colour: the response is above 0.5 up to it."
        )
        parts.append(Wrapped(text))
    parts.append("")
    return report_findings(facts, *parts, headed=False) + written([*outputs, figure])


def _table(name: str, records: Sequence[Facts], keys: Sequence[str] = ()) -> Continued:
    """Return the table of records, in which places, directions and colours begin each line again."""
    keys = keys or known_keys(records)
    first = [key for key in keys if key in _PLACES]
    return Continued(name, records, first, [key for key in keys if key not in first])


def _csv(rows: Sequence[Facts]) -> str:
    """Return records as CSV, findings separated by blanks."""
    file = io.StringIO()
    writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows({**row, "findings": " ".join(row["findings"])} for row in rows)
    return file.getvalue()


def _limits(records: Sequence[Facts], chart: EdgeChart, pixel: float | None) -> list[Facts]:
    """Return records with texts, such as "> 0.25", in place of each MTF50 above the Nyquist frequency."""
    shown = []
    for record in records:
        others, above = dict(record), record["mtf50_px_above"]
        if above is not None:
            others |= {"mtf50_px": f"> {above:.4g}", "lw_ph": f"> {2.0 * chart.shape[0] * above:.4g}"}
            others |= {} if pixel is None else {"mtf50": f"> {per_mm(above / pixel)}"}
        shown.append(others | {"mtf50_px_above": None})
    return shown


def _zone(row: Facts, chart: EdgeChart) -> str:
    """Return the zone of the sensor of a record of an edge."""
    height, width = chart.shape
    place = math.hypot(row["column"] - 0.5 * (width - 1), row["row"] - 0.5 * (height - 1))
    share = place / math.hypot(0.5 * width, 0.5 * height)
    return next(name for name, low, high in _ZONES if low <= share < high)


def _zones(chart: EdgeChart, rows: Sequence[Facts]) -> list[Facts]:
    """Return the medians of MTF50 and responses of each zone of the sensor, direction and channel."""
    found: dict[tuple[str, str, str], list[Facts]] = {}
    for row in rows:
        found.setdefault((_zone(row, chart), row["direction"], row.get("channel", "")), []).append(row)
    order = {name: k for k, (name, _, _) in enumerate(_ZONES)}
    zones = []
    for (zone, direction, channel), part in sorted(found.items(), key=lambda item: (order[item[0][0]], item[0][1])):
        keys = [
            key
            for key in part[0]
            if key.split("_")[0] in ("mtf50", "lw", "at", "lens", "z") and key != "mtf50_px_error"
        ]
        # An MTF50 above the Nyquist frequency is above all others.
        highest = [key for key in keys if key.startswith(("mtf50", "lw"))]
        known = {
            key: [math.inf if x is None else x for row in part if (x := row.get(key)) is not None or key in highest]
            for key in keys
        }
        medians: Facts = {key: plain(float(np.median(x))) if x else None for key, x in known.items()}
        limits = [row["mtf50_px_above"] for row in part if row["mtf50_px_above"] is not None]
        medians["mtf50_px_above"] = limits[0] if medians["mtf50_px"] is None else None
        zones.append({"zone": zone, "direction": direction, "channel": channel, "edges": len(part)} | medians)
    return zones


def _compare(
    chart: EdgeChart,
    rows: list[Facts],
    instrument: Instrument,
    frequencies: Sequence[float],
    in_file: float | tuple[float, float],
) -> list[Finding]:
    """Add the computed MTF with pixel, and the difference in errors of both, to records of green or grey edges.

    The lens has the error of its f-number. Return a finding if the responses differ, as a list.
    """
    field = None if instrument.aberrations_of_field is None else instrument.field()
    scale = 1.0 + (instrument.calibration.f_number_error if instrument.calibration else UNMEASURED[0])
    for row in rows:
        edge = chart.edges[row["edge"]]
        pupil = instrument.pupil() if field is None else field.pupil(edge.x, edge.y)
        cosine, sine = math.cos(edge.response.angle), math.sin(edge.response.angle)
        for one in frequencies:
            keys = [f"lens_{one:g}", f"error_lens_{one:g}", f"z_{one:g}"]
            measured, error = row[f"at_{one:g}"], row[f"error_{one:g}"]
            if row.get("channel", "green") != "green" or not error:
                row |= dict.fromkeys(keys)
                continue
            # An f-number in error scales frequencies, not those of the pixel.
            f = one / instrument.side * np.array([1.0, scale])
            pixel = np.sinc(one * cosine) * np.sinc(one * sine)
            computed, other = np.multiply(pixel, mtf(pupil, f * cosine, f * sine, tol=_TOL)).tolist()
            of_lens = math.hypot(computed - other, _TOL)
            row |= zip(keys, (computed, of_lens, (measured - computed) / math.hypot(error, of_lens)), strict=True)
    return _misfit(chart, rows, instrument, frequencies, in_file)


def _misfit(
    chart: EdgeChart,
    rows: Sequence[Facts],
    instrument: Instrument,
    frequencies: Sequence[float],
    in_file: float | tuple[float, float],
) -> list[Finding]:
    """Return a finding if the mean response of edges, of all or of a zone, is not that of the lens, as a list.

    The pixel pitch of the lens file, which an option may override, is a cause if it is not the one in use.
    """
    found: dict[float, tuple[float, float, str]] = {}
    for one in frequencies:
        for zone in ("", *(name for name, _, _ in _ZONES)):
            part = [row for row in rows if zone in ("", _zone(row, chart)) and row[f"z_{one:g}"] is not None]
            if not part:
                continue
            measured, errors, computed, of_lens = (
                np.array([row[f"{key}{one:g}"] for row in part]) for key in ("at_", "error_", "lens_", "error_lens_")
            )
            weights = 1.0 / np.square(errors)
            mean = float(np.average(measured - computed, weights=weights))
            # The error of the lens is common to all edges.
            z = mean / math.hypot(float(np.mean(of_lens)), 1.0 / math.sqrt(weights.sum()))
            if abs(z) > _APART and abs(mean) > _LEAST and abs(z) > abs(found.get(one, (0.0, 0.0, ""))[1]):
                found[one] = mean, z, zone and f" in the {zone}"
    if not found:
        return []
    worst = max(found, key=lambda one: abs(found[one][1]))
    mean, z, place = found[worst]
    distance, lens = instrument.object_distance, instrument.lens
    others = "" if len(found) == 1 else f" (and at {', '.join(f'{one:g}' for one in found if one != worst)})"
    if mean < 0.0:
        cause = f"the picture is defocused, the f-number is not {lens.f_number:.3g}, or there is motion or aberration"
    elif math.isclose(distance, lens.focus_distance, rel_tol=1e-6):
        cause = f"the f-number is not {lens.f_number:.3g}, or the picture was sharpened"
    else:
        places = f"{format_length(distance)} and the focus at {format_length(lens.focus_distance)}"
        cause = f"the lens has the object at {places}: give --object-distance; or the picture was sharpened"
    if in_file != instrument.pixel:
        pitch = " x ".join(map(format_length, in_file)) if isinstance(in_file, tuple) else format_length(in_file)
        cause = (
            f"the pixel is not {format_length(instrument.side)}, as given, but {pitch}, as in the lens file; {cause}"
        )
    text = (
        f"at {worst:g} cycles/pixel{others} the response{place} is {abs(mean):.2g} "
        f"{'above' if mean > 0.0 else 'below'} that of the lens, {abs(z):.0f} errors of both: {cause}"
    )
    numbers = {f"difference_{one:g}": values[0] for one, values in found.items()}
    numbers |= {f"z_{one:g}": values[1] for one, values in found.items()}
    return [Finding("misfit", "doubt", text, numbers)]


def _curves(chart: EdgeChart) -> Axes:
    """Draw responses of edges in the middle and far from it, sagittal and tangential; of one edge, its colours."""
    if len(chart.edges) == 1:
        return chart.edges[0].response.plot()
    curves = {}
    factor, unit = frequency_unit(chart.edges[0].response.pixel)
    for direction in "ST":
        edges = sorted((e for e in chart.edges if e.direction == direction), key=lambda e: np.hypot(e.x, e.y))
        for name, edge in zip(("centre", "corner"), (edges[0], edges[-1]) if edges else (), strict=False):
            one = edge.response
            curves[f"{name}, {direction}"] = (factor * one.frequencies, one.values, one.errors)
    return estimates.responses(curves, unit)
