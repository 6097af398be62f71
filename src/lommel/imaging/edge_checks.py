"""Checks of the picture of a slanted edge: clipping, JPEG, encoding, uneven light."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from scipy.special import ndtri

from lommel.base.arrays import Array
from lommel.base.encoding import Encoding, named
from lommel.fit.findings import Finding, Severity
from lommel.imaging.edge_profile import MIN_TREND, SIGMA, Edge, Mask, Transform, halo_share
from lommel.imaging.pair_noise import is_compressed

_SLIGHT = 0.005  # change of the response by noise that is clipped from which it is a doubt
_EFFECT = 0.02  # change of the response from which a fault is a doubt
_CURVATURE = 0.15  # least that is told, pixels
_MANY = 0.01  # fraction of outliers from which they are a doubt
_POWERS = np.concatenate([np.geomspace(0.35, 0.8, 6), np.geomspace(1.25, 2.9, 6)])
_GAIN = 12.0  # least gain in chi-squared / 2 by another encoding
UNTESTED = 4.5
"""Gain in chi-squared / 2 over another encoding up to which a profile does not tell which one is right."""
_LOSS = 2.0  # largest loss of it by an encoding that the noise of both sides shows
_LEVEL = 0.005  # uncertainty of the levels of both sides by uneven light, fraction of the step
_GAMMA = 2.2  # of that encoding
_OF_ENCODING = 1.75  # least power that names it
CURVE = 0.5
"""Strength of a tone curve of cameras, from none to 3 v^2 - 2 v^3."""
_FLAT = 0.9  # fraction of equal pixels of a bright side that is clipped, beside a dark one with noise
# Of the last value of a side that many pixels have: least ratio of their number to that of the next value, least
# fraction of pixels beyond both, and largest fraction at which the light is estimated.
_PILED, _WIDE, _HIDDEN = 1.5, 0.02, 0.9
_PHASES = 0.02  # least relative difference of the pixels of a mosaic
_ALIKE = 1.15  # largest ratio of the noise of alike pixels: that of balanced colours is larger
_UNLIKE = 3.0  # ratio of the differences of green pixels by the stated order and by the other one


def require_one_colour(image: Array, known: Mask) -> None:
    """Raise ValueError if pixels of one of four positions differ from their neighbours: a mosaic of colours."""
    phases, error, _ = _phases(image, known)
    if np.ptp(phases) > max(_PHASES, 3.0 * SIGMA * error):
        raise ValueError(
            "image must be of one colour, got a mosaic: pixels of even and odd rows and columns differ by "
            f"{100 * np.ptp(phases):.0f} %; state the mosaic, such as mosaic='RGGB'"
        )


def require_order(mosaic: str, image: Array, known: Mask) -> None:
    """Raise ValueError if no pixels of a mosaic differ, or both green ones and not those of another order."""
    phases, error, noise = _phases(image, known)
    if np.ptp(phases) + SIGMA * error < _PHASES and noise < _ALIKE:
        raise ValueError(
            f"mosaic must be of a raw picture, got {mosaic!r} and pixels that are alike in all four positions, as "
            "those of a grey picture: leave the mosaic out"
        )
    diagonals = abs(float(phases[0] - phases[3])), abs(float(phases[1] - phases[2]))
    green, other = diagonals if mosaic[0] == "G" else diagonals[::-1]
    if green > max(_PHASES, 3.0 * SIGMA * error, _UNLIKE * other):
        orders = ("RGGB", "BGGR") if mosaic[0] == "G" else ("GRBG", "GBRG")
        raise ValueError(
            f"mosaic must be the order of the colours, got {mosaic!r}, whose green pixels of both rows differ "
            f"by {100 * green:.0f} %; those of {orders[0]} and {orders[1]} differ by {100 * other:.1g} %"
        )


def _phases(image: Array, known: Mask) -> tuple[Array, float, float]:
    """Return the light of pixels of even and odd rows and columns, relative to their mean, its error, and noise.

    The noise is the ratio of that of the noisiest and of the quietest of the four, as of colours that were balanced.

    A slope of the light is of opposite sign in blocks that begin at odd rows and columns.
    """
    (even, error, noise), (odd, other, _) = (_block_phases(image[k:, k:], known[k:, k:]) for k in (0, 1))
    return 0.5 * (even + odd[::-1]), max(error, other), noise


def _block_phases(image: Array, known: Mask) -> tuple[Array, float, float]:
    """Return the light of the four pixels of blocks, relative to their mean, its error, and the ratio of noise."""
    height, width = (side // 2 * 2 for side in image.shape)
    blocks = np.where(known, image, np.nan)[:height, :width].reshape(height // 2, 2, width // 2, 2)
    quads = blocks.transpose(1, 3, 0, 2).reshape(4, -1)
    means = quads.mean(axis=0)
    # Black areas count as equal: without them, pixels at the edge might be the majority.
    black = np.abs(means) <= 0.01 * np.nanmax(np.abs(quads), initial=0.0)
    ratios = np.where(black, 1.0, quads / np.where(black, 1.0, means))
    ratios = ratios[:, np.isfinite(ratios).all(axis=0)]
    if ratios.shape[1] < 16:
        return np.ones(4), 0.0, math.inf
    # Medians, over pixels of which few are at the edge.
    middle = np.median(ratios, axis=1)
    spread = np.median(np.abs(ratios - middle[:, None]), axis=1)
    noise = float(spread.max() / max(spread.min(), 1e-12)) if spread.any() else 1.0
    return middle, 1.86 * float(spread.max()) / math.sqrt(ratios.shape[1]), noise


def compression_findings(image: Array) -> list[Finding]:
    """Return the finding on a picture with the blocks of JPEG, as a list."""
    text = "the picture has the blocks of 8 x 8 pixels of JPEG"
    return [Finding("compressed", "doubt", text)] if is_compressed(image) else []


def edge_findings(
    edge: Edge, stored: Array, encoding: Encoding, transform: Transform, found: tuple[Array, Array]
) -> tuple[list[Finding], tuple[float, float, float]]:
    """Return the findings on an edge, and the evidence for its encoding; `found` are its response and the errors.

    The evidence is the gain in chi-squared / 2 of the symmetry of the profile over the other encoding, of sRGB and
    linear, the change of the response by that one, and that by a tone curve, which keeps the symmetry.
    """
    findings = []
    total = int(edge.used.sum()) + edge.outliers
    if edge.outliers:
        many = edge.outliers > _MANY * total
        text = f"{edge.outliers} of {total} pixels are far from the profile, as hot pixels are: left out"
        findings.append(
            Finding("outliers", "doubt" if many else "note", text, {"pixels": edge.outliers, "of": total})
        )
    hidden = halo_share(found[0])
    moves = f", and uneven light beside the edge moves the response by up to {hidden:.1g}"
    if edge.trend > MIN_TREND:
        unsure = hidden > _EFFECT and not edge.tail and 2.0 * edge.unsure > _EFFECT
        text = f"the light is uneven, by {100 * edge.trend:.0f} % across the picture: its trend was divided out"
        severity: Severity = "doubt" if unsure else "note"
        findings.append(Finding("uneven_light", severity, text + moves * unsure, {"trend": edge.trend}))
    if edge.tail > 0.0:
        text = (
            f"both sides change by {100 * edge.tail:.0f} % of the step over the picture: part of the light lies "
            "beyond it, or the light is uneven; take a larger picture"
        )
        findings.append(Finding("uneven_light", "doubt", text, {"tail": edge.tail}))
    if edge.tail < 0.0:
        text = (
            f"both sides fall by {-100 * edge.tail:.0f} % of the step, as where a black level is left: a linear "
            "trend was subtracted"
        )
        severity = "doubt" if hidden > _EFFECT else "note"
        numbers = {"tail": edge.tail, "hidden": hidden}
        findings.append(Finding("uneven_light", severity, text + moves * (hidden > _EFFECT), numbers))
    if edge.curvature > _CURVATURE:
        text = f"the edge is curved, by {edge.curvature:.2g} pixels (distortion): a polynomial was fitted"
        findings.append(Finding("curved_edge", "note", text, {"curvature": edge.curvature}))
    asymmetric, evidence = _of_symmetry(edge, stored, encoding, transform, found)
    return [*findings, *asymmetric, *_clipped(edge, stored)], evidence


def _clipped(edge: Edge, stored: Array) -> list[Finding]:
    """Return a finding if the noise of the dark or bright side ends at a value that many pixels have, as a list.

    The number of pixels falls towards the last values of noise that is not clipped.
    """
    far = _far(edge)
    for name, pixels, sign in (("dark", far[0], 1.0), ("bright", far[1], -1.0)):
        side, light = stored[pixels], edge.light[pixels]
        if not side.size:
            continue
        values, numbers = np.unique(sign * side, return_counts=True)
        share, value = float(numbers[0] / side.size), f"{sign * values[0]:.6g}"
        if name == "dark" and share > _FLAT and values[0] <= 0.0 and np.unique(stored[far[1]]).size > 1:
            text = f"the dark side has one value, {value}: darker light is clipped, which may change the response"
            return [Finding("clipped", "doubt", text, {"share": share})]
        beyond = float(numbers[2:].sum() / side.size)
        first, second = (float(n) for n in (*numbers[:2], 0, 0)[:2])
        if beyond < _WIDE or first < _PILED * second + SIGMA * math.sqrt(first + second):
            continue
        # By which the mean of normal noise moves if this share of it is clipped, relative to the mean of the rest.
        quantile = float(ndtri(min(share, _HIDDEN)))
        density = math.exp(-0.5 * quantile**2) / math.sqrt(2.0 * math.pi)
        rest = density - quantile * (1.0 - share)
        clipped = float(np.median(light[side == sign * values[0]]))
        moved = (density + quantile * share) / rest * abs(float(light.mean()) - clipped) / edge.step
        text = (
            f"{100 * share:.0f} % of the {name} side have its last value, {value}: noise is clipped there, which "
            f"moves the side by {100 * moved:.1g} % of the step, and the response by up to twice as much"
        )
        severity: Severity = "doubt" if 2.0 * moved > _SLIGHT else "note"
        return [Finding("clipped", severity, text, {"share": share, "moved": moved})]
    return []


def _of_symmetry(
    edge: Edge, stored: Array, encoding: Encoding, transform: Transform, found: tuple[Array, Array]
) -> tuple[list[Finding], tuple[float, float, float]]:
    """Return a finding if the profile is not symmetric, as clipped or wrongly encoded values are not, and evidence.

    The light of a symmetric blur at equal distances on both sides of an edge sums to that of both sides.
    """
    position, profile, counts, variances = edge.profile
    bright = max(edge.levels)
    if not min(edge.levels) > 0.0 or position.size < 16:
        return [], (math.inf, 0.0, 0.0)
    scaled, variance = np.maximum(profile / bright, 1e-6), variances / bright**2
    low, high = (level / bright for level in edge.levels)
    # Farther from the edge, errors of a trend of the light are larger than those of noise.
    span = np.arange(0.125, min(edge.width, 0.6 * edge.reach), 0.25)
    smooth = np.bincount(bins := np.floor(4.0 * (position - position.min())).astype(int), counts)
    full = smooth > 0.0
    nodes, values, spread = (
        np.bincount(bins, counts * part)[full] / smooth[full] for part in (position, scaled, counts * variance)
    )
    spread = spread / smooth[full]

    places = np.linspace(-0.3, 0.3, 25)[:, None] + [[[1.0]], [[-1.0]]] * span  # by side, shift and distance

    def chi2(power: float) -> float:
        """Return the least chi-squared of the sums of both sides, over shifts of the edge."""
        light, slope = values**power, power * values ** (power - 1.0)
        step = high**power - low**power
        share = (light - low**power) / step
        noise = slope**2 * spread / step**2 + 4e-6  # of which 0.002 of the step is the sampling
        middle = float(np.interp(0.5, np.maximum.accumulate(share) + 1e-9 * np.arange(share.size), nodes))
        sums, both = (np.interp(middle + places, nodes, part).sum(axis=0) for part in (share, noise))
        # Both levels, which are those far from the edge, may be off near it.
        off, weights = ((sums - 1.0) / both).sum(axis=1), (1.0 / both).sum(axis=1) + 1.0 / _LEVEL**2
        return float(((np.square(sums - 1.0) / both).sum(axis=1) - np.square(off) / weights).min())

    stated = chi2(1.0)
    noisier, quieter = _noise_ratios(edge)
    sizes = [chi2(float(power)) for power in _POWERS] if stated > 2.0 * _GAIN else [stated]
    power = 1.0
    if 0.5 * (stated - min(sizes)) > _GAIN:
        power = float(_POWERS[int(np.argmin(sizes))])
    elif noisier or (quieter and 0.5 * (chi2(1.0 / _GAMMA) - stated) < _LOSS):
        power = _GAMMA if noisier else 1.0 / _GAMMA

    def change_by(power: float, values: Array = profile) -> float:
        """Return the change of the response if values are encoded by another power."""
        other = transform.values((np.maximum(values, 0.0) / bright) ** power, variance, edge.tail)
        return float(np.abs(other - found[0]).max())

    common = _GAMMA if encoding == "linear" else 1.0 / _GAMMA
    gain = 0.5 * (chi2(common) - stated)
    curve = 0.0
    if encoding != "linear":
        encoded = np.clip(profile, 0.0, 1.0) ** (1.0 / _GAMMA)
        curve = change_by(_GAMMA, (1.0 - CURVE) * encoded + CURVE * encoded**2 * (3.0 - 2.0 * encoded))
    evidence = gain, change_by(common) if gain < UNTESTED else 0.0, curve
    change = 0.0 if power == 1.0 else change_by(power)
    (dark, _), (bright_side, value) = _equal(edge, stored)
    if (bright_side > _FLAT or (change >= _EFFECT and bright_side > 0.5)) and dark < 0.5:
        text = f"the bright side has one value, {value:.6g}: it is clipped; expose less"
        return [Finding("flat_top", "error", text, {"change": change, "value": value})], evidence
    if change < _EFFECT:
        return [], evidence
    sides = f"the profile is not symmetric{' and the dark side is noisier' if noisier else ''}"
    numbers: dict[str, Any] = {"power": power, "change": change}
    if (other := _likely_encoding(power, encoding)) is not None:
        numbers["encoding"] = other
        causes = (
            f"values are {'sRGB' if other == 'srgb' else other}, not {named(encoding)}: give encoding={other!r}; "
            "else they are clipped or sharpened at edges, or the lens has coma"
        )
    else:
        causes = (
            "the picture was sharpened at edges or clipped, the lens has coma, or values are not "
            f"{named(encoding)} (light = value ** {power:.2g} would be)"
        )
    text = f"{sides}: {causes}; the response changes by {change:.2g}"
    return [Finding("asymmetric", "doubt", text, numbers)], evidence


def _likely_encoding(power: float, encoding: Encoding) -> str | None:
    """Return the other one of linear and sRGB if a power of the values, which makes profiles symmetric, is its own.

    Sharpening at edges needs powers nearer to 1.
    """
    if encoding == "linear":
        return "srgb" if power > _OF_ENCODING else None
    return "linear" if encoding == "srgb" and power < 1.0 / _OF_ENCODING else None


def unless_brighter(finding: Finding, top: float, *, processed: bool) -> list[Finding]:
    """Return the finding on a clipped side as a list, or another one if pixels of the picture are brighter: `top`.

    Denoised and compressed pictures have areas of one value.
    """
    if finding.code != "flat_top" or not top > finding.numbers["value"]:
        return [finding]
    text = (
        f"most pixels of the bright side have the value {finding.numbers['value']:.6g}, but those of the dark side "
        "have noise: a tone curve or denoising changes the response"
    )
    return [] if processed else [Finding("asymmetric", "doubt", text, finding.numbers)]


def of_coma(finding: Finding) -> Finding:
    """Return the finding, of which another encoding is no cause, since others of the picture are symmetric."""
    if finding.code != "asymmetric" or "encoding" not in finding.numbers:
        return finding
    numbers = {name: value for name, value in finding.numbers.items() if name != "encoding"}
    text = (
        "the profile is not symmetric, which other edges of the picture are: the lens has coma, or the picture was "
        f"sharpened at edges or clipped; by symmetry, the response would change by {numbers['change']:.2g}"
    )
    return Finding(finding.code, finding.severity, text, numbers)


def _far(edge: Edge) -> list[Mask]:
    """Return the pixels of the dark and of the bright side, far from the edge."""
    far = edge.used & (np.abs(edge.distance) > 0.5 * edge.reach)
    sign = math.copysign(1.0, edge.levels[1] - edge.levels[0])
    return [far & (side * sign * edge.distance > 0.0) for side in (-1.0, 1.0)]


def _equal(edge: Edge, stored: Array) -> list[tuple[float, float]]:
    """Return the fractions of pixels of the dark and of the bright side that have its median value, and the value."""
    parts = [stored[pixels] for pixels in _far(edge)]
    values = [float(np.median(part)) if part.size else 0.0 for part in parts]
    return [
        (float(np.mean(part == value)) if part.size else 0.0, value)
        for part, value in zip(parts, values, strict=True)
    ]


def _noise_ratios(edge: Edge) -> tuple[bool, bool]:
    """Return if the noise of the dark side exceeds that of the bright side, as no light does, and if it is too small.

    The variance of light is in proportion to it, or rises less (read noise), or with its square (uneven pixels).
    """
    dark, bright = np.argsort(edge.levels)
    far = edge.used & (np.abs(edge.distance) > 0.6 * edge.reach)
    counts = [max(int((far & (edge.distance * sign > 0.0)).sum()), 1) for sign in (-1.0, 1.0)]
    if min(edge.variances) <= (1e-4 * edge.step) ** 2:
        return False, False
    ratio = math.log(edge.variances[bright] / edge.variances[dark])
    error = math.sqrt(2.0 / counts[0] + 2.0 / counts[1])
    most = math.log(3.0 * edge.levels[bright] / max(edge.levels[dark], 1e-12))
    return ratio < min(-0.1, -SIGMA * error), ratio > most + SIGMA * error
