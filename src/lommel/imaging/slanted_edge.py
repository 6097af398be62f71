"""Spatial frequency response of a camera from a picture of a slanted edge (ISO 12233), and a synthetic edge."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel import show
from lommel.base import validation
from lommel.base.arrays import Array, Json, Numbers, numbers, plain
from lommel.base.encoding import Encoding, checked, to_light
from lommel.base.units import per_mm
from lommel.fit.findings import Finding, Findings, Judged
from lommel.imaging.edge_checks import (
    UNTESTED,
    compression_findings,
    edge_findings,
    of_coma,
    require_one_colour,
    require_order,
    unless_brighter,
)
from lommel.imaging.edge_noise import Areas, Evidence, Neighbours, added_variance, evidence_of, processing_findings
from lommel.imaging.edge_profile import MAX_ANGLE, MIN_ANGLE, Mask, Transform, half, locate, require_measurable
from lommel.recorded.counts import Counts, counts_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_MAX_FULL = 0.01  # largest fraction of saturated pixels
_LEAST_SIDE = 20  # pixels
_SYMMETRIC = 0.2  # fraction of edges that are symmetric from which the encoding may be right
_LARGEST_PIXEL = 0.1  # metres
_PITCHES = {"R": 2.0, "G": math.sqrt(2.0), "B": 2.0}  # pixels, of the colours of a mosaic
_COLOURS = {"R": "red", "G": "green", "B": "blue"}
_ORDERS = ("RGGB", "BGGR", "GRBG", "GBRG")


class _Plane(NamedTuple):
    """One channel: light, stored values, known pixels, and their distance, pixels."""

    light: Array
    stored: Array
    known: Mask
    pitch: float = 1.0


@dataclass(frozen=True, eq=False, repr=False)
class EdgeResponse(Judged):
    """The spatial frequency response (SFR) that :func:`lommel.sfr` measures.

    Attributes
    ----------
    frequencies : ndarray
        Spatial frequencies perpendicular to the edge, cycles per metre (cycles per pixel if no pixel was given), from
        0 to the Nyquist frequency of the pixels, or of the pixels of one colour of a mosaic.
    values : ndarray
        Modulation at each frequency, 1 at frequency 0.
    errors : ndarray
        Standard error of each value: noise of the picture, and half of the correction for the light beyond it.
    mtf50 : (float, float)
        Frequency at which the response falls to 0.5, and its standard error; infinity above the Nyquist frequency.
    angle : float
        Direction of the normal of the edge, radians from x (increasing columns) to y (increasing rows). The MTF of a
        lens in this direction is ``lm.mtf(pupil, f * cos(angle), f * sin(angle), pixel=pixel)``.
    contrast : float
        Michelson contrast of the edge, (bright - dark) / (bright + dark).
    findings : Findings
        Findings of the checks of the picture, from which the verdict follows.
    pixel : float or None
        Pixel pitch, metres.
    channels : dict of str to EdgeResponse
        Responses of red, green and blue of a picture in colour or a mosaic, of which this is that of green.
    """

    frequencies: Array
    values: Array
    errors: Array
    mtf50: tuple[float, float]
    angle: float
    contrast: float
    findings: Findings = field(default_factory=Findings)
    pixel: float | None = None
    channels: Mapping[str, EdgeResponse] = field(default_factory=dict)

    def __call__(self, frequency: ArrayLike) -> Numbers:
        """Interpolate the response at `frequency`, cycles per metre (or per pixel); ValueError above Nyquist's."""
        f = validation.real_array("frequency", frequency, least=0.0, unit="" if self.pixel is None else "1/metres")
        if f.size and f.max() > self.frequencies[-1] * (1.0 + 1e-12):
            raise ValueError(
                f"frequency must be at most the Nyquist frequency, {self._shown(self.frequencies[-1])}, "
                f"got {self._shown(float(f.max()))}"
            )
        return numbers(np.interp(f, self.frequencies, self.values), f.shape)

    @property
    def message(self) -> str:
        """Status, response and findings."""
        frequency = self.mtf50[0]
        mtf50 = f"0.5 at {self._shown(frequency)}" if math.isfinite(frequency) else "above 0.5"
        return self._message(f"{mtf50}, {self.values[-1]:.3f} at Nyquist, {self._shown(self.frequencies[-1])}")

    def __repr__(self) -> str:
        return f"<EdgeResponse {self.message}>"

    def plot(self, ax: Axes | None = None) -> Axes:
        """Return matplotlib axes with the response of each channel, in a band of one standard error.

        Parameters
        ----------
        ax : matplotlib Axes, optional
            Axes to draw into; by default those of a new figure.

        Returns
        -------
        matplotlib Axes
        """
        curves = self.channels or {"": self}
        factor, unit = frequency_unit(self.pixel)
        parts = {name: (factor * one.frequencies, one.values, one.errors) for name, one in curves.items()}
        return show.estimates.responses(parts, unit, ax)

    def to_dict(self) -> Json:
        """Return all attributes, the verdict and the frequency of the response 0.5 as plain numbers and lists."""
        mtf50 = dict(zip(("mtf50", "mtf50_error"), self.mtf50, strict=True))
        verdict = {name: getattr(self, name) for name in ("status", "converged", "reliable", "message")}
        data: Json = plain(verdict | vars(self) | mtf50)
        return data

    def _shown(self, frequency: float) -> str:
        return f"{frequency:.3g} cycles/pixel" if self.pixel is None else per_mm(float(frequency))


def sfr(
    image: ArrayLike | Counts, pixel: float | None = None, *, encoding: Encoding = "linear", mosaic: str | None = None
) -> EdgeResponse:
    """Return the spatial frequency response of a camera from its picture of a slanted edge.

    The picture shows one nearly vertical or nearly horizontal edge between two uniform areas. In each row (or
    column), the centroid of the differences between neighbouring pixels estimates the position of the edge. A line
    or, if the edge is curved, a polynomial of degree 3 defines the signed distance of each pixel from the edge.
    Differences between pixels in the order of this distance sample the line spread function, whose Fourier transform
    is the response. Linear trends of the light, and a fall-off alike along and across the edge, are divided out, and
    pixels far from the profile are left out.

    Parameters
    ----------
    image : array_like or Counts, shape (height, width), (height, width, 3) or (frames, height, width)
        At least 20 x 20 pixels, of one channel or red, green and blue, not sharpened; the black level is 0, or the
        offset of Counts. Frames are averaged; NaN and masked elements are left out.
    pixel : float, optional
        Pixel pitch, metres. Without it, frequencies are in cycles per pixel. Those in line widths per picture height
        are ``2 * height`` times as large, for the height of the whole picture in pixels.
    encoding : {"linear", "srgb"} or float, default "linear"
        Encoding of the values; a number states ``light = value ** number``.
    mosaic : str, optional
        Colours of the first two pixels of the first row and of the second, such as "RGGB", of a raw picture. Each
        colour has the Nyquist frequency of its own pixels.

    Returns
    -------
    EdgeResponse
        Response of optics, pixels and processing. Its values have three errors. The first is due to noise. The
        second, below 0.001, is due to the fit of the line. The third is due to light that falls outside the picture,
        of which diffraction alone spreads about 0.3 % beyond 45 pixels if pixels are 2 lambda*N wide. It is
        extrapolated as line spread functions of apertures fall, like 1 / distance^2, and values, which would be too
        large by about its fraction, are corrected. `errors` contain the first, and half of the correction.

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or shape; if the image is overexposed, or a mosaic that is not stated; if
        the edge does not exceed the noise, is nearer than 5 pixels to a side or is not at 2 to 45 degrees to the rows
        or columns; or if its slope is a simple fraction such as 1/3, for which gaps in the profile exceed a quarter
        pixel.

    Notes
    -----
    ISO 12233:2017, e-SFR; P. D. Burns, Proc. IS&T PICS, 135 (2000). Their algorithms average the profile in bins of a
    quarter pixel, which can change the response by up to 0.05 if the bins are filled unevenly. This function avoids
    this error by bins of 1/16 pixel and by the mean position of the samples in each bin. In place of a Hamming
    window, which would suppress the halo of the blur, the window function is 1 over the middle half of the profile.

    Findings name sharpening (overshoot on both sides, or noise of neighbours of opposite sign), denoising,
    demosaicing or resizing (correlated noise), the blocks of JPEG, and profiles that another encoding would make
    symmetric. One crop shows less of mild sharpening than the edges of a chart together
    (:func:`lommel.imaging.sfr_chart`). The note "untested" has the changes of the response that a picture does not
    exclude, by filters with a radius of a pixel ("filter") and by the other one of linear and sRGB ("encoding").

    Examples
    --------
    >>> edge = lm.imaging.slanted_edge((64, 64), angle=5.0, supersample=8)
    >>> lens = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
    >>> depth = np.full(edge.shape, 2.0)
    >>> photo = lm.imaging.depth_of_field(edge, depth, lens, 4e-6, encoding="linear", supersample=8)
    >>> lm.sfr(photo.values, 4e-6)
    <EdgeResponse converged: above 0.5, 0.547 at Nyquist, 125 cycles/mm>
    """
    side = pixel_pitch(pixel)
    counts = image_counts(image)
    require_mosaic(mosaic, counts)
    return with_processing([edge_response(counts, side, checked(encoding), mosaic)])[0]


def frequency_unit(pixel: float | None) -> tuple[float, str]:
    """Return the factor and the unit by which figures show frequencies of edges with this pixel pitch."""
    return (1.0, "cycles/pixel") if pixel is None else (1e-3, "cycles/mm")


def pixel_pitch(pixel: float | None) -> float | None:
    """Return the pixel pitch, metres, or None for frequencies in cycles per pixel; ValueError if it is too large."""
    if pixel is None:
        return None
    if (side := validation.real("pixel", pixel, above=0.0, unit="metres")) > _LARGEST_PIXEL:
        raise ValueError(
            f"pixel must be in metres and at most {_LARGEST_PIXEL:g}, got {side:g}; leave it out for frequencies in "
            "cycles per pixel"
        )
    return side


def require_mosaic(mosaic: str | None, counts: Counts, part: tuple[slice, ...] = ()) -> None:
    """Raise ValueError if the colours of a mosaic are unknown or in another order, by a part of the image."""
    is_plane = len(counts.shape) == 2
    seen = counts[part]
    if mosaic is None:
        if is_plane:
            require_one_colour(seen.filled(), seen.known)
        return
    if not isinstance(mosaic, str) or mosaic not in _ORDERS or not is_plane:
        raise ValueError(
            f"mosaic must be {', '.join(_ORDERS[:-1])} or {_ORDERS[-1]}, of an image (height, width), got "
            f"{validation.shown(mosaic)} and an image {counts.shape}"
        )
    require_order(mosaic, seen.filled(), seen.known)


def image_counts(image: ArrayLike | Counts) -> Counts:
    """Return the counts of a picture; ValueError for another shape."""
    shape = "(height, width), (height, width, 3) or (frames, height, width)"
    counts = counts_of("image", image, sides=(2, 3), shape=shape)
    sides = counts.shape[:2] if counts.shape[2:] in ((), (3,)) else counts.shape[1:]
    if min(sides) < _LEAST_SIDE:
        raise ValueError(f"image must have the shape {shape} of 20 x 20 pixels or more, got {counts.shape}")
    return counts


def edge_response(
    counts: Counts, pixel: float | None, encoding: Encoding, mosaic: str | None, inside: Mask | None = None
) -> tuple[EdgeResponse, dict[str, Evidence]]:
    """Return the response of the edge in a picture, by the pixels `inside`, and the evidence of sharpening."""
    light, stored, known, full = _averaged(counts, encoding)
    if full > _MAX_FULL:
        raise ValueError(
            "image must not be overexposed, got pixels with the largest value of their type: expose less"
        )
    planes = {"": _Plane(light, stored, known)}
    if mosaic is not None:
        planes = _mosaic_planes(mosaic, light, stored, known)
    elif light.ndim == 3:
        names = _COLOURS.values()
        planes = {name: _Plane(light[..., k], stored[..., k], known[..., k]) for k, name in enumerate(names)}
    left_out = [Finding("saturation_assumed", "note", counts.assumed)] if counts.assumed else []
    if count := int((~known).sum()):
        text = f"{count} of {known.size} pixels left out (masked, saturated or NaN)"
        left_out.append(Finding("left_out", "note", text, {"pixels": count, "of": known.size}))
    if inside is None:  # else the blocks may start anywhere
        left_out += compression_findings(stored if stored.ndim == 2 else stored[..., 1])
    rounded = np.asarray(counts.values).dtype.kind in "iu"
    found: dict[str, EdgeResponse] = {}
    evidence: dict[str, Evidence] = {}
    line: Array | None = None
    shared: list[Areas] = []
    for name in sorted(planes, key=lambda name: name != "green"):  # first, for the others start from its edge
        plane = planes[name] if inside is None else planes[name]._replace(known=planes[name].known & inside)
        found[name], evidence[name], line = _measured(plane, encoding, pixel, left_out, line, shared, rounded=rounded)
    if "" in found:
        return found[""], evidence
    return replace(found["green"], channels={name: found[name] for name in planes}), evidence


def with_processing(
    edges: Sequence[tuple[EdgeResponse, dict[str, Evidence]]], *, compressed: bool = False
) -> list[EdgeResponse]:
    """Return the responses of the edges of a picture with the findings on sharpening and denoising of all of them."""
    found, tops, symmetric = {}, {}, {}
    compressed = compressed or any(finding.code == "compressed" for one, _ in edges for finding in one.findings)
    for name in edges[0][1]:
        evidence = [parts[name] for _, parts in edges]
        found[name] = processing_findings(evidence, compressed=compressed)
        tops[name] = max(one.top for one in evidence)
        # Another encoding makes all edges asymmetric, coma those of one direction.
        parts = [one.channels.get(name, one).findings.codes for one, _ in edges]
        gains = [one.encoding[0] for one, codes in zip(evidence, parts, strict=True) if "asymmetric" not in codes]
        many = len(gains) >= _SYMMETRIC * len(edges)
        symmetric[name] = many and sum(gain for gain in gains if gain < math.inf) > UNTESTED

    def joined(one: EdgeResponse, name: str) -> EdgeResponse:
        processed = [part for part in found[name] if part.code in ("sharpened", "correlated_noise")]
        # Sharpening, and the ripples of JPEG, may look like another encoding, which makes no overshoot.
        sharpened = any(part.code == "sharpened" for part in processed)
        overshoots = any(part.numbers.get("overshoot", 0.0) > 0.0 for part in processed)
        others = [
            kept
            for finding in one.findings
            if finding.code != "asymmetric" or not (overshoots or (sharpened and "encoding" not in finding.numbers))
            for kept in unless_brighter(finding, tops[name], processed=compressed or bool(processed))
        ]
        if symmetric[name]:
            others = [of_coma(finding) for finding in others]
        return replace(one, findings=Findings([*others, *found[name]]))

    responses = []
    for one, _ in edges:
        channels = {name: joined(part, name) for name, part in one.channels.items()}
        responses.append(replace(channels["green"], channels=channels) if channels else joined(one, ""))
    return responses


def _averaged(counts: Counts, encoding: Encoding) -> tuple[Array, Array, Mask, float]:
    """Return light, values and known pixels of the mean of all frames, and the fraction of saturated pixels."""
    values, known, stored = np.asarray(counts.values), counts.known, counts.filled()
    if encoding != "linear":
        light = to_light("image", np.where(known, values, values.dtype.type(0)), encoding, np.float64)
    else:
        light = stored - (0.0 if counts.noise is None else counts.noise.offset)
    # Single ones are hot pixels; neighbours of one colour of a mosaic are two pixels apart.
    along = np.moveaxis(np.asarray(counts.full), 1 if values.ndim == 2 or values.shape[2] == len(_COLOURS) else 2, 0)
    full = float((along[2:] & along[:-2]).mean())
    if values.ndim == 2 or values.shape[2] == len(_COLOURS):
        return light, stored, known, full
    number = np.maximum(known.sum(axis=0), 1)
    means = [np.where(known, part, 0.0).sum(axis=0) / number for part in (light, stored)]
    return means[0], means[1], np.asarray(known.any(axis=0)), full


def _mosaic_planes(mosaic: str, light: Array, stored: Array, known: Mask) -> dict[str, _Plane]:
    """Return light, values, known pixels and pitch of each colour of a mosaic."""
    letters = np.array(list(mosaic)).reshape(2, 2)
    height, width = light.shape
    tiled = np.tile(letters, (height // 2 + 1, width // 2 + 1))[:height, :width]
    return {name: _Plane(light, stored, known & (tiled == key), _PITCHES[key]) for key, name in _COLOURS.items()}


def _measured(
    plane: _Plane,
    encoding: Encoding,
    pixel: float | None,
    left_out: list[Finding],
    line: Array | None,
    shared: list[Areas],
    *,
    rounded: bool,
) -> tuple[EdgeResponse, Evidence, Array]:
    """Return the response of one channel, evidence, and its edge, which is near `line` if given."""
    light, stored, known, pitch = plane
    if known.sum() < _LEAST_SIDE**2 / pitch**2:
        raise ValueError(f"image must have known pixels, got {int(known.sum())} of {known.size}")
    # A nearly horizontal edge is transposed to a nearly vertical one.
    sums = [[np.where(known, part, 0.0).sum(axis=k) for part in (light, np.ones_like(light))] for k in (0, 1)]
    spans = [float(np.ptp((total / np.maximum(count, 1.0))[count > 0.0])) for total, count in sums]
    horizontal = spans[1] > spans[0]
    upright = (light.T, stored.T, known.T) if horizontal else (light, stored, known)
    edge = locate(upright[0], upright[2], line)
    require_measurable(edge, pitch)
    position, profile, counts, variances = edge.profile
    neighbours = Neighbours.of(edge, upright[1], pitch, shared, rounded=rounded)
    added = added_variance(edge) / counts
    transform = Transform(position, 0.5 / pitch)
    values, covariance = transform.response(profile, variances, edge.tail, edge.unsure, neighbours.power, added)
    errors = np.sqrt(np.diag(covariance))
    frequencies = transform.frequencies / (pixel or 1.0)
    mtf50, mtf50_error = (float(frequencies[1]) * part for part in half(values, covariance))
    # The normal of the line x = start + slope y is along (1, -slope).
    angle = math.atan2(1.0, -edge.slope) if horizontal else math.atan2(-edge.slope, 1.0)
    contrast = edge.step / max(abs(sum(edge.levels)), 1e-300)
    found, of_encoding = edge_findings(edge, upright[1], encoding, transform, (values, errors))
    findings = Findings([*found, *left_out])
    evidence = evidence_of(
        edge, neighbours, upright[1], (values, errors), of_encoding, pitch, encoding, rounded=rounded
    )
    found_response = EdgeResponse(
        frequencies, values, errors, (mtf50, mtf50_error), angle, float(contrast), findings, pixel
    )
    return found_response, evidence, edge.line


def slanted_edge(
    shape: tuple[int, int],
    *,
    angle: float = 5.0,
    supersample: int = 8,
) -> NDArray[np.float32]:
    """Return a synthetic slanted edge in linear light, 0.1 on the left and 0.9 on the right.

    Parameters
    ----------
    shape : (int, int)
        Height and width, in pixels, of the photograph that is to be rendered from the edge.
    angle : float, default 5.0
        Angle between the edge and the columns, degrees, 2 to 45.
    supersample : int, default 8
        Number of pixels of the result along the side of a pixel of the photograph, 1 to 16.

    Returns
    -------
    ndarray, shape (height supersample, width supersample)
        Light of each pixel. The edge is blurred to the width of one pixel of the result, so that it has the response
        ``sinc(f pixel / supersample)``: 0.9936 at the Nyquist frequency of the photograph for a `supersample` of 8.

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or out of range.
    """
    height, width = validation.image_shape(shape)
    factor = validation.integer("supersample", supersample, least=1, most=16)
    radians = math.radians(validation.real("angle", angle, least=MIN_ANGLE, most=MAX_ANGLE))
    y, x = (np.arange(side * factor) - 0.5 * (side * factor - 1) for side in (height, width))
    covered = np.clip((x + np.tan(radians) * y[:, None]) * math.cos(radians) + 0.5, 0.0, 1.0)
    return np.asarray(0.1 + (0.9 - 0.1) * covered, dtype=np.float32)
