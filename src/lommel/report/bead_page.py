"""Report on beads for a facility: a CSV table that grows with each run, and an HTML page to print."""

from __future__ import annotations

import csv
import io
import math
import re
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from html import escape
from pathlib import Path
from typing import Any

import numpy as np

from lommel.base import atomic
from lommel.base.arrays import Array
from lommel.base.units import number, with_error
from lommel.estimation.bead_table import (
    MEASURES,
    Row,
    chromatic_shifts,
    counted,
    focal_surface,
    middle_of,
    summary,
)
from lommel.show import drawing, estimates

_TEXTS = "bead", "file", "date", "verdict"
# Verdict of the joint fit of a run; errors and doubts of the fit of a bead; both in a few words.
_WORDS = "joint_fit", "reason", "joint_codes", "codes"
_SHORT = {"converged": "good", "doubtful": "in doubt", "left out": "left out", "refused": "refused"}
_MARKS = {"good": "\N{CHECK MARK}", "in doubt": "?"}
_IN_TABLE = (
    "gauss_x", "gauss_y", "gauss_z", "fwhm_x", "fwhm_y", "fwhm_z", "asymmetry", "strehl", "rms", "z", "height",
    "focus",
)  # fmt: skip
_IN_SUMMARY = _IN_TABLE[:9]
_IN_MAPS = "gauss_x", "gauss_y", "gauss_z", "fwhm_z", "strehl", "height"
_LEAST_MAP = 4  # smallest number of beads of a map
_LEAST_SPREAD = 5e-6  # metres: smallest extent of a map; windows cut out by other programs have no places
_DATE = re.compile(r"(?<![\w-])(\d{4}-\d\d-\d\d)(?!\d)")
_NOTES = (
    "FWHM, Gaussian: least-squares Gaussians with a background along lines through the brightest voxel, as "
    "MetroloJ_QC, PSFj and the protocols of QUAREP-LiMi measure beads. Bead and pixel widen them. Standard errors "
    "are those of photon and read noise.",
    "FWHM, PSF: of the PSF fitted to each bead alone, without bead and pixel. Standard errors include those of the "
    "constants of the microscope. Those of means include the part that all beads share, as the joint fit has it. "
    "They hold for the amplitude over the pupil that the surfaces of the stated media have. Other losses towards its "
    "rim, as of coatings, change widths by parts of a percent, unless they are estimated (--apodization).",
    "Lateral asymmetry: the smaller over the larger of the Gaussian FWHM along x and y.",
    "Strehl ratio: peak of the fitted PSF over that of the same pupil with a flat phase. Zernike terms, the depth of "
    "the bead, and a cover glass, immersion or sample that are fitted unlike the design of the objective all reduce "
    "it. Wavefront rms: of this whole wavefront in its best focus, without tilt.",
    "z: position of the stage at which the bead would be sharpest without aberrations; its standard error is "
    "mostly that of the depth, common to all beads. Relative height: z from the mean of the beads of an image, in "
    "which that cancels. Focus: centre of the Gaussian along z, from the middle plane.",
    "Chromatic shifts, PSF: differences of the places of the fitted PSFs, without what coma moves; the error of the "
    "mean has the part that all beads share. Gaussian: of the centres of Gaussians, which aberrations move with the "
    "place of a bead in its pixel and plane: a single one has no standard error, and that of the mean is by the "
    "spread. Planes and stage of both channels must be the same.",
)
_STYLE = """
:root { color-scheme: light dark; --line: #8886; --mark: #8882; }
body { font: 15px/1.5 system-ui, sans-serif; margin: 0 auto; max-width: 76rem; padding: 1rem; }
h1 { font-size: 1.5rem; line-height: 1.25; } h2 { font-size: 1.15rem; margin: 2rem 0 .5rem; }
figure, .table { margin: .5rem 0; overflow-x: auto; /* the right edge is shaded while there is more beyond it */
  background: linear-gradient(to left, Canvas 1rem, transparent) right / 2rem 100% no-repeat local,
    linear-gradient(to left, #888a, transparent) right / 1rem 100% no-repeat; }
svg { max-width: max(100%, 38rem); height: auto; } svg text { fill: currentColor; }
table { border-collapse: collapse; font-size: .86rem; font-variant-numeric: tabular-nums; }
th, td { padding: .2rem .5rem; text-align: right; white-space: nowrap; border-bottom: 1px solid var(--line); }
th { font-weight: 600; white-space: normal; vertical-align: bottom; }
th:first-child, td:first-child, .text th, .text td { text-align: left; white-space: normal; }
th:first-child, td:first-child { position: sticky; left: 0; min-width: 6.5rem; background: Canvas; }
td:first-child, .text td:last-child { overflow-wrap: anywhere; } .date { white-space: nowrap; }
.text td { vertical-align: top; }
tr:nth-child(even) td { background: var(--mark); }
tr:nth-child(even) td:first-child { background: linear-gradient(var(--mark), var(--mark)), Canvas; }
details p { font-size: .86rem; overflow-wrap: anywhere; } summary { cursor: pointer; }
@media (max-width: 45rem) { .text thead { display: none; } .text tr, .text td { display: block; }
  .text td { border: 0; } .text tr { border-bottom: 1px solid var(--line); } }
@media print { @page { size: A4 landscape; margin: 12mm; } :root { color-scheme: light; }
  body { max-width: none; padding: 0; font-size: 9pt; } table { font-size: 7pt; } th, td { padding: .1rem .3rem; }
  figure, tr { break-inside: avoid; } h2 { break-after: avoid; }
  figure, .table { overflow: visible; background: none; }
  details::details-content { content-visibility: visible; display: block; } details p { font-size: 7pt; }
  svg { max-width: 100%; } th:first-child, td:first-child { position: static; } }
"""


def _header(name: str) -> str:
    """Return the heading of a column: the name and the unit."""
    stem, part = _parts(name)
    unit = MEASURES.get(stem, ("", "rad" if stem.startswith("noll") else "", 1.0))[1]
    return f"{stem} ({unit}){part}" if unit else name


def _factor(name: str) -> float:
    return MEASURES.get(_parts(name)[0], ("", "", 1.0))[2]


def _parts(name: str) -> tuple[str, str]:
    """Return the name of a quantity, and "_error" or "_common" if a column is that part of its error."""
    part = next((part for part in ("_error", "_common") if name.endswith(part)), "")
    return name.removesuffix(part), part


def write_csv(path: Path, rows: Sequence[Row]) -> None:
    """Write the rows of beads: lengths in nm, positions x and y and the wavelength in metres."""
    names = list(dict.fromkeys(name for row in rows for name in row))
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([_header(name) for name in names])
    for row in rows:
        values = [row.get(name) for name in names]
        writer.writerow(
            ["" if v is None else v if isinstance(v, str) else repr(float(v * _factor(name)))
             for name, v in zip(names, values, strict=True)]
        )  # fmt: skip
    atomic.write(path, text.getvalue().encode())


def read_csv(path: Path) -> list[Row]:
    """Return the rows that :func:`write_csv` wrote; ValueError for another file."""
    with path.open(newline="", encoding="utf-8") as file:
        lines = list(csv.reader(file))
    names = [_name(header) for header in (lines or [[]])[0]]
    if not {*_TEXTS, "wavelength"} <= {*names} or any(len(line) != len(names) for line in lines):
        raise ValueError(f"{path.name} is no table of beads that this command wrote: name another folder")
    try:
        return [
            {n: v if n in _TEXTS or (v and n in _WORDS) else float(v) / _factor(n) if v else None
             for n, v in zip(names, line, strict=True)}
            for line in lines[1:]
        ]  # fmt: skip
    except ValueError as error:
        raise ValueError(f"{path.name} has a cell that is no number: {error}") from None


def _name(header: str) -> str:
    stem, _, rest = header.partition(" (")
    return stem + _parts(rest)[1] if rest else header


def _value(row: Mapping[str, Any], name: str, factor: float, sign: str = " ± ") -> str:
    value, error = row.get(name), row.get(f"{name}_error")
    if value is None:
        return "–"
    pair = with_error(factor * value, factor * error) if error else (number(factor * value),)
    return drawing.true_minus(sign.join(pair))


def _mean(one: Mapping[str, Any], factor: float, beads: int) -> str:
    """Return a mean, with the number of its values where it is not that of the `beads` of the line."""
    count = one.get("beads", beads)
    return _value(one, "mean", factor) + (f" ({count} beads)" if count != beads else "")


def _table(head: Iterable[str], rows: Iterable[Iterable[str]], kind: str = "") -> str:
    cells = "".join(f"<tr>{''.join(f'<td>{escape(cell)}</td>' for cell in row)}</tr>" for row in rows)
    cells = _DATE.sub(r'<span class="date">\1</span><wbr>', cells)  # lines break after it, not at its hyphens
    return (
        f'<div class="table{kind}"><table><thead><tr>{"".join(f"<th>{escape(name)}</th>" for name in head)}</tr>'
        f"</thead><tbody>{cells}</tbody></table></div>"
    )


def _words(name: str, unit: bool = True) -> str:
    text, in_unit, _ = MEASURES[name]
    return f"{text} ({in_unit})" if unit and in_unit else text


def _figure(figure: Any) -> str:
    """Return a figure as SVG, whose lines and letters have the colour of the page's text."""
    pyplot = drawing.pyplot()
    with pyplot.rc_context({"svg.fonttype": "none", "svg.hashsalt": "lommel"}):
        data = atomic.contents(figure.savefig, format="svg", transparent=True, metadata={"Date": None})
    pyplot.close(figure)
    text = data.decode()
    return f"<figure>{text[text.index('<svg') :].replace('#000000', 'currentColor')}</figure>"


def _array(rows: Sequence[Row], name: str) -> Array:
    return np.array([math.nan if row.get(name) is None else row[name] for row in rows])


def _nanometres(wavelength: float) -> str:
    return f"{1e9 * wavelength:.0f} nm"


def _channels(rows: Sequence[Row]) -> dict[str, list[Row]]:
    waves = sorted({row["wavelength"] for row in rows})
    return {_nanometres(wave): [row for row in rows if row["wavelength"] == wave] for wave in waves}


def _summaries(rows: Sequence[Row]) -> list[str]:
    parts = []
    for channel, beads in _channels(rows).items():
        lines = []
        for one in summary(counted(beads), _IN_SUMMARY):
            factor = MEASURES[one["name"]][2]
            mean = _value(one, "mean", factor)
            spread = "–" if one["spread"] is None else f"{factor * one['spread']:.2g}"
            lines.append([_words(one["name"]), mean, spread, f"{factor * one['error']:.2g}", str(one["beads"])])
        head = channel, "mean ± standard error", "spread over the beads", "standard error of one bead", "beads"
        parts.append(_table(head, lines))
    return parts


def _drawn(rows: Sequence[Row]) -> list[str]:
    parts, rows = list[str](), counted(rows)
    for channel, beads in _channels(rows).items():
        x, y = _array(beads, "x"), _array(beads, "y")
        maps = [(_words(n, False), MEASURES[n][2] * _array(beads, n), MEASURES[n][1]) for n in _IN_MAPS]
        maps = [one for one in maps if np.isfinite(one[1]).sum() >= _LEAST_MAP]
        if maps and np.isfinite(x).sum() >= _LEAST_MAP and np.nanmax(x) - np.nanmin(x) > _LEAST_SPREAD:
            parts += [f"<p>{channel}</p>", _figure(estimates.bead_maps(x, y, maps))]
    curves, middle = [], middle_of(rows)
    for title, names in (("lateral FWHM", ("gauss_x", "gauss_y")), ("axial FWHM", ("gauss_z", "fwhm_z"))):
        series = dict[str, tuple[Array, Array, Array]]()
        for channel, beads in _channels(rows).items():
            x, y = _array(beads, "x"), _array(beads, "y")
            away = 1e6 * np.hypot(x - middle[0], y - middle[1])
            series |= {
                f"{MEASURES[n][0].split(', ')[1] if n[-1] == 'z' else n[-1]}, {channel}": (
                    away, 1e9 * _array(beads, n), 1e9 * _array(beads, f"{n}_error"),
                )
                for n in names
            }  # fmt: skip
        curves.append((title, "distance from the middle of the beads (µm)", "FWHM (nm)", series))
    return [*parts, _figure(estimates.bead_curves(curves))]


def _surfaces(rows: Sequence[Row]) -> list[str]:
    parts = []
    for channel, beads in _channels(rows).items():
        surface = focal_surface(beads, middle_of(rows))
        if surface is None:
            files = {row["file"] for row in beads if row.get("height") is not None}
            parts.append(
                f"<p>{channel}: no tilt or field curvature: they need {max(len(files), 1) + 4} beads with heights, "
                "not all on a line.</p>"
            )
            continue
        lines = [
            ("tilt along x (nm over 100 µm)", _value(surface, "tilt_x", 1e5)),
            ("tilt along y, with the rows (nm over 100 µm)", _value(surface, "tilt_y", 1e5)),
            ("field curvature (nm of height, 100 µm from the middle)", _value(surface, "curvature", 5.0)),
            (
                f"scatter of heights about this surface, in their errors: {_scatter(surface)}",
                number(math.sqrt(surface["chi2"])),
            ),
        ]
        parts.append(_table((f"{channel}: focal surface (stage position), {surface['beads']} beads", ""), lines))
    return parts


def _scatter(surface: Mapping[str, Any]) -> str:
    """Return whether the errors of heights explain their scatter about a surface, and what it means."""
    limit = f"below {number(math.sqrt(surface['limit']))}"
    if surface["chi2"] < surface["limit"]:
        return f"as errors allow, {limit}"
    return f"beads lie at several heights (errors alone: {limit}), which the errors above allow for"


def _counts(beads: Sequence[Row]) -> str:
    """Return how many beads have which verdict, and for which reason: those of fits of single beads."""
    found = Counter(row["verdict"].replace("_", " ") for row in beads)
    reasons = dict[str, list[str]]()
    for row in beads:
        if (reason := row.get("reason")) and reason not in (row.get(_WORDS[0]) or ""):
            number_of = row["bead"].removeprefix(row["file"]).strip()
            chi2 = "" if row.get("chi2") is None else f" (chi2 {row['chi2']:.3f})"
            reasons.setdefault(reason, []).append(f"{number_of}{chi2}".strip() or "all")
    texts = [f"{', '.join(names)}: {reason}" for reason, names in reasons.items()]
    return "; ".join([", ".join(f"{count} {verdict}" for verdict, count in found.most_common()), *texts])


def _short(verdict: str) -> str:
    """Return a verdict on a bead in a word or two."""
    return _SHORT.get(verdict, f"wrong, {verdict.replace('_', ' ')}")


def _marked(word: str, reasons: str = "") -> str:
    mark = _MARKS.get(word, "" if word in _SHORT.values() else "\N{MULTIPLICATION SIGN}")
    return f"{mark} {word}{': ' if reasons else ''}{reasons}".strip()


def _at_a_glance(beads: Sequence[Row]) -> tuple[str, str]:
    """Return the verdicts in a few words: on the fits of single beads, and on that of all."""
    texts = []
    for word, count in Counter(_short(row["verdict"]) for row in beads).most_common():
        some = [row for row in beads if _short(row["verdict"]) == word and word == "in doubt"]
        codes = Counter(code for row in some for code in (row.get("codes") or "").split(", ") if code)
        reasons = ", ".join(f"{code} {number_of}" for code, number_of in codes.most_common())
        texts.append(f"{_marked(word)} {count}" + (f": {reasons}" if reasons else ""))
    said = beads[0].get(_WORDS[0]) or ""
    status, _, rest = said.partition(": ")
    if not rest:
        return "; ".join(texts), "–"
    known = {"converged": "good", "converged, but in doubt": "in doubt"}
    word = known.get(status, f"wrong, {status}")
    return "; ".join(texts), _marked(word, (beads[0].get("joint_codes") or "") if word == "in doubt" else "")


def _verdicts(rows: Sequence[Row]) -> str:
    """Return the verdicts on files at a glance, of the fits of single beads and of the joint fit, and in full."""
    files = dict[tuple[str, float], list[Row]]()
    for row in rows:
        files.setdefault((row["file"], row["wavelength"]), []).append(row)
    lines, full = [], list[str]()
    for (file, wave), beads in files.items():
        lines.append([file, _nanometres(wave), *_at_a_glance(beads)])
        both = f"{_counts(beads)}. All beads: {beads[0].get(_WORDS[0]) or '–'}."
        full.append(f"<p><strong>{escape(file)}, {_nanometres(wave)}</strong>: {escape(both)}</p>")
    head = "file", "channel", "fit of each bead alone", "fit of one wavefront to all beads"
    details = f"<details><summary>Verdicts in full</summary>{''.join(full)}</details>"
    return _table(head, lines, " text") + details


def _chromatic(rows: Sequence[Row]) -> list[str]:
    pairs = chromatic_shifts(rows)
    if not pairs:
        return []
    axes = "x_psf", "y_psf", "z_psf", "x", "y", "z"
    head = ["bead", "channels", *(f"shift {axis}, {kind} (nm)" for kind in ("PSF", "Gaussian") for axis in "xyz")]
    lines, by_waves = [], dict[tuple[float, float], list[Row]]()
    for pair in pairs:
        waves = pair["wavelengths"]
        by_waves.setdefault(waves, []).append(pair)
        cells = [_value(pair, f"shift_{axis}", 1e9) for axis in axes]
        lines.append([pair["bead"], " − ".join(map(_nanometres, waves[::-1])), *cells])
    means = []
    for waves, group in by_waves.items():
        cells = []
        for axis in axes:
            (one,) = summary(group, [f"shift_{axis}"]) or [{"mean": None}]
            cells.append(_mean(one, 1e9, len(group)))
        means.append([f"mean of {len(group)}", " − ".join(map(_nanometres, waves[::-1])), *cells])
    return ["<h2>Chromatic shifts</h2>", _table(head, [*means, *lines])]


def _trend(rows: Sequence[Row]) -> list[str]:
    dates = sorted({row["date"] for row in rows})
    if len(dates) < 2:
        return []
    names = "gauss_x", "gauss_y", "gauss_z", "fwhm_x", "fwhm_y", "fwhm_z", "strehl"
    lines, series = [], {name: dict[str, Any]() for name in names}
    for channel, beads in _channels(rows).items():
        for date in dates:
            of_date = counted([row for row in beads if row["date"] == date])
            found = {one["name"]: one for one in summary(of_date, names)}
            for name, one in found.items():
                part = series[name].setdefault(channel, ([], [], []))
                for values, value in zip(part, (date, one["mean"], one["mean_error"]), strict=True):
                    values.append(value if isinstance(value, str) else MEASURES[name][2] * (value or 0.0))
            most = max((one["beads"] for one in found.values()), default=0)
            cells = [_mean(found[n], MEASURES[n][2], most) if n in found else "–" for n in names]
            if found:
                lines.append([date, channel, str(most), *cells])
    curves = [
        (_words(n, False), "", MEASURES[n][1], series[n]) for n in ("gauss_x", "gauss_z", "strehl") if series[n]
    ]
    head = ["date", "channel", "beads", *map(_words, names)]
    return [
        "<h2>Trend</h2>",
        "<p>Means over the beads of a day ± standard errors, with what these beads share. Beads left out do "
        "not count.</p>",
        _figure(estimates.bead_curves(curves)), _table(head, lines),
    ]  # fmt: skip


def page(
    title: str, facts: Sequence[tuple[str, str]], rows: Sequence[Row], notes: Sequence[str],
) -> str:  # fmt: skip
    """Return the page of rows: those of the newest date in tables and maps, all of them in the trend."""
    newest, *earlier = sorted({row["date"] for row in rows}, reverse=True)
    shown = [row for row in rows if row["date"] == newest]
    parts = [f"<h1>{escape(title)}</h1>", _table(("", ""), facts, " text")]
    if earlier:
        dates = ", ".join(earlier)
        parts.append(
            f"<p>Details are those of {newest}. Of {dates} the page has the trend, and the table all beads.</p>"
        )
    parts += ["<h2>Verdicts</h2>", _verdicts(shown)]
    parts += ["<h2>Widths, Strehl ratio, wavefront</h2>", *_summaries(shown)]
    parts += ["<h2>Over the field</h2>", *_drawn(shown), *_surfaces(shown)]
    parts += _chromatic(shown) + _trend(rows) + ["<h2>Beads</h2>"]
    names = [(row["bead"], _nanometres(row["wavelength"])) for row in shown]
    places = [[_value({k: row.get(k)}, k, 1e6) for k in "xy"] for row in shown]
    ends = [["–" if row.get("chi2") is None else number(row["chi2"]), _short(row["verdict"])] for row in shown]
    # Two tables, each as wide as a sheet of paper.
    for columns, first, last in ((_IN_TABLE[:7], places, None), (_IN_TABLE[7:], None, ends)):
        head = ["bead", "channel", *(["x (µm)", "y (µm)"] if first else []), *map(_words, columns)]
        cells = [
            [*name, *(first[k] if first else []), *(_value(row, one, MEASURES[one][2]) for one in columns),
             *(last[k] if last else [])]
            for k, (name, row) in enumerate(zip(names, shown, strict=True))
        ]  # fmt: skip
        parts.append(_table([*head, *(["chi2", "fit"] if last else [])], cells))
    parts += ["<h2>Notes</h2>", *(f"<p>{escape(note)}</p>" for note in (*notes, *_NOTES))]
    return (
        f'<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><meta name="viewport" '
        f'content="width=device-width, initial-scale=1"><title>{escape(title)}</title><style>{_STYLE}</style></head>'
        f"<body>{''.join(parts)}</body></html>\n"
    )
