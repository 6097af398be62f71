"""Options of the commands that read depth maps, and the line that tells of a map."""

from __future__ import annotations

import math
from collections.abc import Callable

import click
import numpy as np
from numpy.typing import NDArray

from lommel.base.units import format_length
from lommel.cli.options import Group, documented, option
from lommel.cli.output import Facts
from lommel.io.depth_maps import RESAMPLE, DepthValues


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
