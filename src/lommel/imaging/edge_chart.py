"""Sharpness over the sensor from a picture of a chart: its slanted edges, found and measured."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike
from scipy import ndimage

from lommel import show
from lommel.base.arrays import Array, Json, Values, plain
from lommel.base.encoding import Encoding, checked
from lommel.fit.findings import Finding, Findings, Judged, Severity
from lommel.imaging.edge_checks import compression_findings
from lommel.imaging.edge_noise import Evidence
from lommel.imaging.edge_profile import MAX_ANGLE, MIN_ANGLE, Mask
from lommel.imaging.slanted_edge import (
    EdgeResponse,
    edge_response,
    frequency_unit,
    image_counts,
    pixel_pitch,
    require_mosaic,
    with_processing,
)
from lommel.recorded.counts import Counts

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_REDUCED = 1.5e6  # largest number of pixels of the picture in which edges are found
_SIGMAS, _CONTRAST = 8.0, 0.06  # least gradient of an edge: standard deviations, and of the largest
_LEAST_LENGTH, _LEAST_HALF = 24.0, 9.0  # pixels along the edge, and on both sides of it
_MOST_LENGTH, _MOST_HALF = 64.0, 24.0  # that are used, more if the blur is wide
_SHARPEST = 2.4  # pixels of the reduced picture to which the gradient of a sharp edge extends
_DIAGONAL = 25.0  # degrees to rows or columns from which an edge is steep
_STRAIGHT = 0.15  # largest thickness of the gradient along an edge, of its length
_FALL, _RISE = 0.2, 0.25  # fractions of the gradient at which the edge ends, and at which another structure begins
_MIDDLE_SIDE = 1024  # pixels of the middle of a picture in which blocks of JPEG and mosaics are looked for
_CENTRE, _LEAST_CENTRE = 0.5, 3  # of the field in which both directions are compared, and edges of each
_APART, _UNLIKE = 4.5, 0.02  # standard errors, and logarithm of the ratio, from which both directions differ
_LEAST_SIDE, _LEAST_FREE, _LEAST_SHARE = 6, 12, 0.3  # edges of a side, degrees of freedom, share no other explains
_SIDES = "right_to_left", "bottom_to_top"
_UNLIKE_SIDES, _BETWEEN = 0.05, 0.2  # logarithm of the ratio of both sides, and share of the field between them
_LARGEST_CROP = 512  # pixels of a side of a picture of one edge, of which all pixels are used


class _Candidate(NamedTuple):
    """A straight piece of an edge in pixels: its middle, unit normal, length, free width on both sides."""

    row: float
    column: float
    normal: tuple[float, float]  # along rows (down) and columns (right)
    length: float
    half: float


@dataclass(frozen=True, eq=False)
class ChartEdge:
    """An edge of a chart.

    Attributes
    ----------
    row, column : float
        Middle of the edge in the picture, pixels.
    x, y : float
        Its place from the middle of the picture, right and down; metres, or pixels if no pixel was given.
    direction : {"S", "T"}
        Sagittal or tangential response: the nearest of both, by the direction of the normal of the edge.
    response : EdgeResponse
    """

    row: float
    column: float
    x: float
    y: float
    direction: str
    response: EdgeResponse


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class EdgeChart(Judged):
    """Slanted edges of a picture of a chart, returned by :func:`lommel.imaging.sfr_chart`.

    Attributes
    ----------
    edges : tuple of ChartEdge
        Edges that were measured, by rows.
    refused : tuple of (float, float, str)
        Row, column and reason of edges that were found and not measured.
    shape : (int, int)
        Height and width of the picture, pixels.
    findings : Findings
        Findings on the picture, and on its edges by number.
    """

    edges: tuple[ChartEdge, ...]
    refused: tuple[tuple[float, float, str], ...]
    shape: tuple[int, int]
    findings: Findings = field(default_factory=Findings)

    @property
    def message(self) -> str:
        """Status, numbers of edges, and findings."""
        plural = "edge" if len(self.edges) == 1 else "edges"
        return self._message(f"{len(self.edges)} {plural} measured, {len(self.refused)} refused")

    def __repr__(self) -> str:
        return f"<EdgeChart {self.message}>"

    def rows(self, frequencies: Sequence[float] = ()) -> list[Json]:
        """Return a record for each edge and channel: place, direction, MTF50, responses, findings.

        Parameters
        ----------
        frequencies : sequence of float
            Frequencies, cycles per pixel, at which the response is listed, with its standard error.

        Returns
        -------
        list of dict
            MTF50 is in cycles per pixel ("mtf50_px"), in line widths per picture height ("lw_ph") and, if the pixel
            is known, in cycles per metre ("mtf50"). Where the response is above 0.5 up to the Nyquist frequency, they
            are None, and "mtf50_px_above" is that frequency, cycles per pixel.
        """
        records: list[Json] = []
        for number, edge in enumerate(self.edges):
            for name, one in (edge.response.channels or {"": edge.response}).items():
                pixel = one.pixel or 1.0
                mtf50, error = (pixel * value for value in one.mtf50)
                record: Json = {"edge": number, "row": edge.row, "column": edge.column}
                record |= {} if one.pixel is None else {"x": edge.x, "y": edge.y}
                record |= {"direction": edge.direction} | ({"channel": name} if name else {})
                above = math.nan if math.isfinite(mtf50) else pixel * float(one.frequencies[-1])
                record |= {"mtf50_px": mtf50, "mtf50_px_error": error, "mtf50_px_above": above}
                record |= {"lw_ph": 2.0 * self.shape[0] * mtf50}
                record |= {} if one.pixel is None else {"mtf50": one.mtf50[0]}
                for f in frequencies:
                    at = f / pixel <= one.frequencies[-1] * (1.0 + 1e-12)
                    record[f"at_{f:g}"] = float(one(f / pixel)) if at else math.nan
                    record[f"error_{f:g}"] = (
                        float(np.interp(f / pixel, one.frequencies, one.errors)) if at else math.nan
                    )
                records.append(plain(record | {"status": one.status, "findings": list(one.findings.codes)}))
        return records

    @property
    def sides(self) -> dict[str, tuple[float, float]]:
        """Ratios of MTF50 of opposite sides at like distances from the middle, with their standard errors.

        "right_to_left" and "bottom_to_top" are of the picture as shown; one that the edges do not determine is left
        out. About 20 edges around the middle determine both.
        """
        return _sides(self.edges)

    def plot(self, channel: str = "green") -> Figure:
        """Return a matplotlib figure with maps of MTF50, sagittal and tangential, per mm if the pixel is known.

        Parameters
        ----------
        channel : {"red", "green", "blue"}, default "green"
            Channel of a picture in colour.

        Returns
        -------
        matplotlib Figure
        """
        found = [(edge, edge.response.channels.get(channel, edge.response)) for edge in self.edges]
        factor, unit = frequency_unit(found[0][1].pixel)
        table = [(e.column, e.row, factor * one.mtf50[0], e.direction) for e, one in found]
        name = channel if self.edges[0].response.channels else ""
        return show.estimates.sharpness(table, self.shape, unit, factor * float(found[0][1].frequencies[-1]), name)

    def to_dict(self) -> Json:
        """Return the verdict and the records of all edges as plain data."""
        verdict = {name: getattr(self, name) for name in ("status", "converged", "reliable", "message")}
        data: Json = plain(verdict | {"shape": self.shape, "edges": self.rows(), "refused_edges": self.refused})
        sides = {name: {"ratio": ratio, "error": error} for name, (ratio, error) in self.sides.items()}
        return data | {"sides": plain(sides), "findings": plain(self.findings)}


def sfr_chart(
    image: ArrayLike | Counts, pixel: float | None = None, *, encoding: Encoding = "linear", mosaic: str | None = None
) -> EdgeChart:
    """Find the slanted edges in a picture of a chart, and measure the response of each as :func:`lommel.sfr` does.

    The chart has straight edges at 2 to 45 degrees to the rows or columns, at least 24 pixels long, between uniform
    areas of 9 pixels or more: slanted squares, ISO 12233, eSFR, a tilted checkerboard, or one edge.

    Parameters
    ----------
    image : array_like or Counts, shape (height, width) or (height, width, 3)
        As for :func:`lommel.sfr`. The middle of the picture is taken as that of the sensor.
    pixel : float, optional
        Pixel pitch, metres.
    encoding : {"linear", "srgb"} or float, default "linear"
        Encoding of the values; a number states ``light = value ** number``.
    mosaic : str, optional
        Colours of a raw picture, such as "RGGB".

    Returns
    -------
    EdgeChart

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or out of range, or if no edge is found.

    Notes
    -----
    Edges are pieces of the largest gradients, of one sign along rows or columns, in a picture that is reduced to 1.5
    million pixels. Each is measured in its middle part, clear of corners and of other structures by its blur.
    """
    side, encoding = pixel_pitch(pixel), checked(encoding)
    counts = image_counts(image)
    middle = _middle(counts)
    if counts.shape[2:] not in ((), (3,)):
        raise ValueError(f"image must have the shape (height, width) or (height, width, 3), got {counts.shape}")
    edges: list[ChartEdge] = []
    evidence: list[dict[str, Evidence]] = []
    refused: list[tuple[float, float, str]] = []
    require_mosaic(mosaic, counts, middle)
    part = np.asarray(counts.values[middle] if len(counts.shape) == 2 else counts.values[*middle, 1], float)
    compression = compression_findings(np.where(np.isfinite(part), part, 0.0))
    candidates, angles = _candidates(counts, mosaic is not None)
    reason = ""
    if len(candidates) < 2 and max(counts.shape[:2]) <= _LARGEST_CROP:
        try:  # all pixels of a crop, as lm.sfr does
            place = candidates[0][:2] if candidates else (0.5 * (counts.shape[0] - 1), 0.5 * (counts.shape[1] - 1))
            one, found = edge_response(counts, side, encoding, mosaic)
            edges.append(_chart_edge(counts.shape, place, side, one))
            evidence.append(found)
            candidates = []
        except ValueError as error:
            if not str(error).startswith("image must show one"):
                reason = str(error)
    for candidate in candidates:
        try:
            edge, found = _measure(counts, candidate, side, encoding, mosaic)
        except ValueError as error:
            refused.append((candidate.row, candidate.column, str(error).removeprefix("image ")))
        else:
            edges.append(edge)
            evidence.append(found)
    if not edges and refused:
        (cause, count), *_ = Counter(reason for _, _, reason in refused).most_common(1)
        reason = f"image {cause}" + f" ({count} of {len(refused)} edges that were found)" * (len(refused) > 1)
    if not edges:
        straight = "".join(f"; one is at {angle:.1f} degrees" for angle in angles[:1])
        raise ValueError(
            reason
            or f"image must show slanted edges at {MIN_ANGLE:g} to {MAX_ANGLE:g} degrees to its rows or columns, "
            f"{_LEAST_LENGTH:g} pixels long or more, between uniform areas of {_LEAST_HALF:g} pixels or more, got "
            f"none{straight}"
        )
    measured = [(edge.response, one) for edge, one in zip(edges, evidence, strict=True)]
    responses = with_processing(measured, compressed=bool(compression))
    edges = [replace(edge, response=one) for edge, one in zip(edges, responses, strict=True)]
    return EdgeChart(
        edges=tuple(edges),
        refused=tuple(refused),
        shape=(counts.shape[0], counts.shape[1]),
        findings=Findings(
            [
                *_findings(counts, edges, compression),
                *_refusals(refused, len(edges)),
                *_motion(edges),
                *_unlike_sides(_sides(edges)),
            ]
        ),
    )


def middle_edge(image: ArrayLike, pixel: float | None, *, encoding: Encoding) -> ChartEdge:
    """Return the measurable edge of a picture that is nearest to its middle; ValueError if there is none."""
    counts = image_counts(image)
    middle = [0.5 * (side - 1) for side in counts.shape[:2]]

    def far(edge: _Candidate) -> float:
        return math.hypot(edge.row - middle[0], edge.column - middle[1])

    for candidate in sorted(_candidates(counts, False)[0], key=far):
        with suppress(ValueError):
            edge, evidence = _measure(counts, candidate, pixel_pitch(pixel), encoding, None)
            return replace(edge, response=with_processing([(edge.response, evidence)])[0])
    raise ValueError("image must show slanted edges, 24 pixels long or more, got none")


def _middle(counts: Counts) -> tuple[slice, ...]:
    """Return the rows and columns of the middle of a picture, from the start of a block of JPEG."""
    starts = [max(0, side - _MIDDLE_SIDE) // 16 * 8 for side in counts.shape[:2]]
    return tuple(slice(start, start + _MIDDLE_SIDE) for start in starts)


def _findings(counts: Counts, edges: list[ChartEdge], compression: list[Finding]) -> Findings:
    """Return findings on a picture: those of its edges, by the number that have them, and compression."""
    findings = [Finding("saturation_assumed", "note", counts.assumed)] if counts.assumed else []
    findings += compression
    done = ("left_out", *(found.code for found in findings))
    every = [[*(edge.response.channels or {"": edge.response}).values()] for edge in edges]
    parts = [[found for one in each for found in one.findings if found.code not in done] for each in every]
    return Findings([*findings, *shared_findings(parts, "edges")])


def shared_findings(parts: Sequence[Sequence[Finding]], name: str) -> list[Finding]:
    """Return the findings of edges or frames by the number that have each, as notes unless half are in doubt."""
    findings = []
    for code in dict.fromkeys(found.code for part in parts for found in part):
        each = [Findings(found for found in part if found.code == code) for part in parts]
        worst = [several[0] for several in each if several]
        bad = [found for found in worst if found.severity != "note"]
        first = Findings(worst)[0]
        severity: Severity = first.severity if 2 * len(bad) >= len(parts) else "note"
        several_named = len(parts) > 1 and code != "untested"
        text = f"{len(worst)} of {len(parts)} {name}: {first.text}" if several_named else first.text
        findings.append(Finding(code, severity, text, {**first.numbers, name: len(worst), "of": len(parts)}))
    return findings


def _refusals(refused: Sequence[tuple[float, float, str]], measured: int) -> list[Finding]:
    """Return a finding on the edges that were found and not measured, by cause, as a list."""
    if not refused:
        return []
    causes = Counter(reason.partition(",")[0] for _, _, reason in refused)
    text = (
        f"{len(refused)} of {len(refused) + measured} edges were found and not measured: "
        f"{'; '.join(f'each {cause} ({count})' for cause, count in causes.most_common())}"
    )
    return [Finding("left_out", "note", text, {"edges": len(refused), "of": len(refused) + measured})]


def _motion(edges: list[ChartEdge]) -> list[Finding]:
    """Return a finding if the response in the centre differs between both directions, as a list.

    There, lenses of rotational symmetry blur alike in all directions.
    """
    far = max(math.hypot(edge.x, edge.y) for edge in edges)
    groups: list[list[tuple[float, float]]] = [[], []]
    for edge in edges:
        one = edge.response
        if math.hypot(edge.x, edge.y) <= _CENTRE * far and math.isfinite(one.mtf50[0]):
            groups[abs(math.cos(one.angle)) < math.sqrt(0.5)].append(one.mtf50)
    if min(map(len, groups)) < _LEAST_CENTRE:
        return []
    values = [np.array([value for value, _ in group]) for group in groups]
    means = [float(part.mean()) for part in values]
    # The larger of the standard errors and of the scatter: the response changes over the field.
    spreads = [
        max(float(np.mean(np.square([error for _, error in group]))), float(part.var(ddof=1))) / part.size
        for group, part in zip(groups, values, strict=True)
    ]
    ratio = means[0] / means[1]
    if abs(means[0] - means[1]) < _APART * math.sqrt(sum(spreads)) or abs(math.log(ratio)) < _UNLIKE:
        return []
    text = (
        f"in the centre, MTF50 across the columns is {ratio:.2g} times that across the rows: motion, or astigmatism "
        "of a decentred lens"
    )
    return [Finding("unlike_directions", "note", text, {"ratio": ratio})]


def _sides(edges: Sequence[ChartEdge]) -> dict[str, tuple[float, float]]:
    """Return the ratios of MTF50 at the right to that at the left, and at the bottom to that at the top, with errors.

    Those that the edges do not determine are left out.

    Steps between the sides are fitted to the logarithm of MTF50, beside functions of the distance from the middle and
    of the direction of edges, which lenses of rotational symmetry and motion have on both sides.
    """
    known = [edge for edge in edges if math.isfinite(edge.response.mtf50[0])]
    if not known:
        return {}
    x, y, turn, mtf50, errors = np.array([(e.x, e.y, e.response.angle, *e.response.mtf50) for e in known]).T
    far = (x**2 + y**2) / max(float(np.max(x**2 + y**2)), 1e-30)
    radial = far * np.cos(2.0 * (turn - np.arctan2(y, x)))
    alike = [np.ones(x.size), far, far**2, radial, far * radial, np.cos(2.0 * turn), np.sin(2.0 * turn)]
    steps = [np.sign(place) * (np.abs(place) > _BETWEEN * np.max(np.abs(place))) for place in (x, y)]
    functions, values = np.array([*alike, *steps]).T, np.log(mtf50)
    inverse = np.linalg.pinv(functions, max(functions.shape) * np.finfo(np.float64).eps)
    fitted, free = inverse @ values, x.size - round(float(np.trace(inverse @ functions)))
    if free < _LEAST_FREE:
        return {}
    # The larger of the standard errors and of the scatter, which has what the functions do not follow.
    scatter = float(np.sum(np.square(values - functions @ fitted))) / free
    spread = max(float(np.mean(np.square(errors / mtf50))), scatter)
    ratios: dict[str, tuple[float, float]] = {}
    for k, (step, name) in enumerate(zip(steps, _SIDES, strict=True), len(alike)):
        variance = float(inverse[k] @ inverse[k])  # of the fitted step, relative to that of a value
        # This product is 1 unless the other functions follow the step.
        is_known = float(inverse[k] @ step) > 1.0 - 1e-6 and variance * float(step @ step) <= 1.0 / _LEAST_SHARE
        if not is_known or min((step > 0.0).sum(), (step < 0.0).sum()) < _LEAST_SIDE:
            continue
        ratio = math.exp(2.0 * float(fitted[k]))
        ratios[name] = ratio, 2.0 * ratio * math.sqrt(spread * variance)
    return ratios


def _unlike_sides(sides: Mapping[str, tuple[float, float]]) -> list[Finding]:
    """Return a finding if MTF50 differs between left and right, or top and bottom, as a list."""
    texts: list[str] = []
    numbers: dict[str, float] = {}
    for name, (ratio, absolute) in sides.items():
        names, difference, error = name.split("_to_"), math.log(ratio), absolute / ratio
        numbers |= {name: ratio, f"{name}_error": absolute}
        if abs(difference) > max(_APART * error, _UNLIKE_SIDES):
            worse, better = names if difference < 0.0 else names[::-1]
            least = math.exp(-abs(difference))
            texts.append(f"at the {worse} is {least:.2f}+-{max(least * error, 0.01):.1g} of that at the {better}")
    if not texts:
        return []
    text = (
        f"MTF50 {' and '.join(texts)}: a tilted or decentred lens, a chart that is not parallel to the sensor, or a "
        "crop beside the middle of the picture"
    )
    return [Finding("unlike_sides", "note", text, numbers)]


def _measure(
    counts: Counts, edge: _Candidate, pixel: float | None, encoding: Encoding, mosaic: str | None
) -> tuple[ChartEdge, dict[str, Evidence]]:
    """Return an edge with its response and the evidence of sharpening, by the pixels around it."""
    height, width = counts.shape[:2]
    down, right = edge.normal
    sides = [
        0.5 * edge.length * abs(across) + (edge.half + 1.0) * abs(along)
        for along, across in ((down, right), (right, down))
    ]
    # Rectangles around the edge, whose corners far from it are hidden; they start at the first colour of a mosaic.
    rows, columns = (
        slice(max(0, int(middle - reach)) // 2 * 2, min(side, int(middle + reach) + 1))
        for middle, reach, side in zip((edge.row, edge.column), sides, (height, width), strict=True)
    )
    # Rows and columns along the edge end with it: beyond them are corners.
    if abs(right) > abs(down):
        rows = slice(
            max(0, int(edge.row - 0.5 * edge.length * abs(right))) // 2 * 2,
            min(height, int(edge.row + 0.5 * edge.length * abs(right)) + 1),
        )
    else:
        columns = slice(
            max(0, int(edge.column - 0.5 * edge.length * abs(down))) // 2 * 2,
            min(width, int(edge.column + 0.5 * edge.length * abs(down)) + 1),
        )
    y, x = np.ogrid[rows, columns]
    inside = np.abs((y - edge.row) * down + (x - edge.column) * right) <= edge.half + 0.5
    mask = None if counts.mask is None else counts.mask[rows, columns]
    part = replace(counts, values=np.ascontiguousarray(counts.values[rows, columns]), mask=mask)
    part = replace(part, stated=counts.saturation if math.isfinite(counts.saturation) else None)
    found, evidence = edge_response(part, pixel, encoding, mosaic, inside)
    return _chart_edge(counts.shape, (edge.row, edge.column), pixel, found), evidence


def _chart_edge(
    shape: tuple[int, ...], place: tuple[float, float], pixel: float | None, found: EdgeResponse
) -> ChartEdge:
    """Return the edge at a place (row, column) of a picture."""
    (row, column), (height, width) = place, shape[:2]
    u, v, scale = column - 0.5 * (width - 1), row - 0.5 * (height - 1), pixel or 1.0
    along = abs(u * math.cos(found.angle) + v * math.sin(found.angle))
    direction = "T" if along >= math.hypot(u, v) / math.sqrt(2.0) else "S"
    return ChartEdge(row, column, scale * u, scale * v, direction, found)


def _reduced(counts: Counts, mosaic: bool) -> tuple[Array, int]:
    """Return the picture of one channel, smaller by an integer factor, and the factor."""
    values: Values = counts.values if len(counts.shape) == 2 else counts.values[..., 1]
    height, width = values.shape
    factor = max(1, math.ceil(math.sqrt(values.size / _REDUCED)))
    factor += factor % 2 if mosaic else 0
    part = values[: height // factor * factor, : width // factor * factor]
    blocks = part.reshape(height // factor, factor, width // factor, factor)
    total = np.zeros((height // factor, width // factor))
    for k in range(factor):
        for j in range(factor):
            total += blocks[:, k, :, j]
    return np.where(np.isfinite(total), total, 0.0) / factor**2, factor


def _empty(image: Array) -> Mask:
    """Return the areas of exactly 0 at the border of a picture, as of one that was turned: their edges are none."""
    labels, count = ndimage.label(image == 0.0)
    border = np.concatenate([labels[0], labels[-1], labels[:, 0], labels[:, -1]])
    return np.isin(labels, border[border > 0]) if count else np.zeros(image.shape, bool)


def _candidates(counts: Counts, mosaic: bool) -> tuple[list[_Candidate], list[float]]:
    """Return straight pieces of edges with uniform areas on both sides, by rows, and the angles of other ones.

    Gradients of one sign along rows or columns belong together; of steep edges, those of one sign along both.
    """
    image, factor = _reduced(counts, mosaic)
    smooth = ndimage.gaussian_filter(ndimage.median_filter(image, 3), 0.8, mode="nearest")  # without hot pixels
    down, right = (np.gradient(smooth, axis=axis) for axis in (0, 1))
    size = np.hypot(down, right)
    noise = 1.4826 * float(np.median(np.abs(np.diff(image[::3], axis=1)))) / math.sqrt(2.0) * 0.25
    least = max(_SIGMAS * noise, _CONTRAST * float(np.max(size)))
    strong = (size > least) & ~ndimage.binary_dilation(_empty(image), iterations=3)
    vertical = np.abs(right) > np.abs(down)
    kinds = np.where(vertical, np.where(right > 0.0, 1, 2), np.where(down > 0.0, 3, 4)) * strong
    diagonal = np.where(right > 0.0, np.where(down > 0.0, 1, 2), np.where(down > 0.0, 3, 4)) * strong
    found: list[_Candidate] = []
    angles: list[float] = []
    for kind in range(8):
        labels, count = ndimage.label((kinds, diagonal)[kind // 4] == kind % 4 + 1, np.ones((3, 3)))
        if not count:
            continue
        places = np.nonzero(labels)
        index, weight = labels[places], size[places]
        y, x = (np.asarray(part, float) for part in places)
        total = np.bincount(index, weight, count + 1)[1:]
        rows, columns = (np.bincount(index, weight * part, count + 1)[1:] / total for part in (y, x))
        yy, xx, xy = (
            np.bincount(index, weight * a * b, count + 1)[1:] / total - first * second
            for a, b, first, second in ((y, y, rows, rows), (x, x, columns, columns), (y, x, rows, columns))
        )
        turn = 0.5 * np.arctan2(2.0 * xy, xx - yy)  # of the longer axis from the columns' direction
        mean, spread = 0.5 * (xx + yy), np.hypot(0.5 * (xx - yy), xy)
        lengths, thick = (np.sqrt(12.0 * np.maximum(mean + sign * spread, 0.0)) for sign in (1.0, -1.0))
        for k in np.flatnonzero((factor * lengths >= _LEAST_LENGTH) & (thick < np.maximum(_STRAIGHT * lengths, 4.0))):
            normal = -math.cos(turn[k]), math.sin(turn[k])
            slant = math.degrees(math.atan2(min(map(abs, normal)), max(map(abs, normal))))
            if (slant > _DIAGONAL) != (kind >= 4):
                continue
            if slant >= MIN_ANGLE - 0.5:
                candidate = _fitted(size, (float(rows[k]), float(columns[k])), normal, float(lengths[k]), factor)
                if candidate is not None:
                    found.append(candidate)
            else:
                angles.append(slant)
    return sorted(found, key=lambda edge: (edge.row, edge.column)), angles


def _fitted(
    size: Array, middle: tuple[float, float], normal: tuple[float, float], length: float, factor: int
) -> _Candidate | None:
    """Return an edge in pixels with the width of uniform areas beside it, by gradients; None if they are narrow."""
    reach = max(round(4.0 * _MOST_HALF / factor), 12)
    offsets = np.arange(-reach, reach + 1.0)
    along = np.linspace(-0.32, 0.32, 17) * length
    places = [
        np.rint(m + offsets[:, None] * n + along * t).astype(int)
        for m, n, t in zip(middle, normal, (-normal[1], normal[0]), strict=True)
    ]
    inside = ((places[0] >= 0) & (places[0] < size.shape[0]) & (places[1] >= 0) & (places[1] < size.shape[1])).all(
        axis=1
    )
    rows, columns = (np.clip(part, 0, side - 1) for part, side in zip(places, size.shape, strict=True))
    values = size[rows, columns]
    profile = np.where(inside, np.sort(values, axis=1)[:, -3], np.inf)
    peak = float(np.median(values[reach - 1 : reach + 2].max(axis=0)))
    free, blur, extent = [], 1, 0.0
    for side in (profile[reach:], profile[reach::-1]):
        below = np.flatnonzero(side < _FALL * peak)
        if not below.size:
            return None
        start = int(below[0])
        above = np.flatnonzero(side[start:] > _RISE * peak)
        end = start + (int(above[0]) if above.size else side.size - start)
        # The areas end before the blur of the next structure.
        free.append(
            float(end - (1.5 * start + 1.0 if above.size and np.isfinite(side[min(end, side.size - 1)]) else 1))
        )
        blur = max(blur, start)
        nodes = np.arange(max(start - 1, 0), start + 1)
        extent += 0.5 * float(np.interp(-_FALL * peak, -side[nodes], nodes))
    half = factor * min(free)
    wanted = max(_MOST_HALF, 6.0 * factor * math.sqrt(max(extent**2 - _SHARPEST**2, 0.0)))
    long = factor * (length - 3.0 * blur - 2.0)
    if half < max(_LEAST_HALF, 1.2 * factor * blur) or long < 0.8 * _LEAST_LENGTH:
        return None
    row, column = (factor * (part + 0.5) - 0.5 for part in middle)
    return _Candidate(row, column, normal, min(long, _MOST_LENGTH), min(half, wanted))
