"""Options and reports that the commands on depth share: maps of it, lenses of several photos, the verdict on them."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import click
import numpy as np
from numpy.typing import NDArray

from lommel.base.units import format_length
from lommel.cli.options import Group, documented, option
from lommel.cli.output import Facts, Report
from lommel.io.depth_maps import RESAMPLE, DepthValues

if TYPE_CHECKING:
    from lommel.imaging.defocus_verdict import DefocusVerdict
    from lommel.optics.lens import Lens


class DepthMap(Group):
    """What the values of a depth map mean, as :class:`lommel.io.depth_maps.DepthKeywords`."""

    # fmt: off
    scale: float | None = documented(DepthValues, "scale", "--depth-scale", type=float)
    inverse: tuple[float, float] | None = documented(DepthValues, "inverse", "--inverse-depth", length="m", nargs=2,
        metavar="NEAR FAR")
    disparity: tuple[float, float] | None = documented(DepthValues, "disparity", type=float, nargs=2,
        metavar="FB OFFSET")
    zero_is_unknown: bool = documented(DepthValues, "zero_is_unknown", "--zero-unknown", is_flag=True)
    unknown: tuple[float, ...] = option(type=float, multiple=True,
        help="Treat this stored value of the depth map, such as -1 or 255, as unknown.")
    resample: str | None = documented(DepthValues, "resample", type=click.Choice(RESAMPLE))
    # fmt: on


def finite(distance: float) -> float | str:
    """Return a distance as JSON can hold it."""
    return distance if math.isfinite(distance) else "infinity"


def depth_facts(distance: NDArray[np.float64]) -> tuple[Facts, Callable[[str], str]]:
    """Return the range of a depth map and the share that is not known, and a line of them around a focus."""
    known = distance[~np.isnan(distance)]
    low, high = (float(end(known)) if known.size else math.nan for end in (np.min, np.max))
    share = 1.0 - known.size / distance.size
    facts = {"depth": [finite(low), finite(high)] if known.size else [None, None], "depth_unknown": share}
    return facts, lambda focus: depth_line(low, high, share, focus)


def depth_line(low: float, high: float, unknown: float, focus: str) -> str:
    """Return the line of a range of depth, NaN where none is known, and of the share that is not known."""
    where = "not known" if math.isnan(low) else " to ".join(map(format_length, dict.fromkeys((low, high))))
    return f"depth {where}, {focus}" + (f", {100.0 * unknown:.2g} % unknown" if unknown else "")


BETWEEN = option("--between", length="m", nargs=2, required=True, metavar="NEAR FAR",
    help="Nearest and farthest distance to search, such as 1m 3m or 1m inf.")  # fmt: skip


def lens_options(which: str) -> list[Any]:
    """Return the options that :func:`each_lens` takes, for "all photos" or other images."""
    once = f"once for {which}, or repeated for each; overrides the lens file."
    return [
        option("--focus", length="m", multiple=True, help=f"Focus distance, such as 1.35m: {once}"),
        option("--f-number", type=float, multiple=True, help=f"F-number: {once}"),
    ]


def each_lens(
    lens: Lens, count: int, foci: tuple[float, ...], f_numbers: tuple[float, ...], what: str = "photos"
) -> list[Lens]:
    """Return the lens of each photo."""
    for name, given in (("--focus", foci), ("--f-number", f_numbers)):
        if len(given) not in (0, 1, count):
            raise ValueError(f"{name} must be given once, or for each of {count} {what}, got {len(given)}")
    if count < 2:
        raise ValueError("PHOTOS must be two or more: in a single photo blur looks like smooth texture; got 1")
    lenses = [lens.stopped(stop) for stop in f_numbers] or [lens]
    lenses *= count // len(lenses)
    if foci:
        lenses = [one.focused(focus) for one, focus in zip(lenses, foci * (count // len(foci)), strict=True)]
    return lenses


def lens_facts(lenses: list[Lens]) -> tuple[Facts, str]:
    """Return focus distances and f-numbers of frames, and the same in words."""
    facts = {
        "focus_distances": [finite(one.focus_distance) for one in lenses],
        "f_numbers": [one.f_number for one in lenses],
        "focal_length": lenses[0].focal_length,
    }
    each = (f"{format_length(one.focus_distance)} at f/{one.f_number:.3g}" for one in lenses)
    return facts, f"focus {', '.join(each)}"


def verdict_report(verdict: DefocusVerdict) -> Report:
    """Return what was tested of the lenses and the noise, and what could not be."""
    untested = verdict.findings.get("untested")
    facts = verdict.to_dict()
    del facts["misfit"]  # commands have their own
    facts |= {"agrees": verdict.agrees, "untested": untested and untested.numbers["what"]}
    lines = [] if math.isnan(verdict.misfit) else [verdict.summary]
    return Report(facts, [*lines, *(each.text for each in verdict.findings)], verdict.converged)
