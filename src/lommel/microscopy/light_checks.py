"""Checks of restored light: a floor between the structures, and light of planes that changes along the stack."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array, Values
from lommel.base.units import percent
from lommel.deconvolve.iterations import Background
from lommel.fit.findings import Finding
from lommel.recorded.counts import Stack, plane_of
from lommel.recorded.noise import Noise

_FLOOR_BLOCK = 8  # side, pixels, of the blocks whose means show the floor of the restored light
_FLOOR_REGIONS = 3  # regions along each side of the field, each with a floor of its own
_FLOOR_PERCENTILE = 10.0  # of the means of the blocks of a region, which is the floor
# Largest share of the floor in the light: below 0.02 in simulations with flat backgrounds, 0.18 with an uneven one.
_MAX_FLOOR = 0.05

# Least change of the light along the stack that is named: over that of the specimen, over that of all, and over its
# standard error; that over the standard error which so many parts of the field, along each side, show; and the least
# number of planes.
_FADING, _FADING_OF_ALL, _FADING_SIGMAS, _FADING_PLANES = 0.1, 0.01, 3.0, 5
_FADING_PARTS, _FADING_SPREADS = 4, 4.5
_FADING_LEFT_OUT = 0.02  # largest share of the light in pixels that are unknown in some planes


def plane_light_findings(
    stack: Stack, noise: Noise, background: float, limit: float = np.inf, *, reverse: bool = False
) -> list[Finding]:
    """Return the finding if the light of the planes of a wide-field stack rises or falls along z, else nothing.

    Without absorption every plane of a wide-field stack has the same light (the missing cone of the transfer
    function), unless the specimen fades, or light crosses the edges of the frame, which parts of the field tell. A
    restoration fits such a stack, too: light beyond the first or last plane makes up for the difference. Values of
    `limit` or more are unknown; planes are numbered from the other end if `reverse`.
    """
    # Only pixels that are known in every plane: what is left out of some would itself change the light of these.
    # Planes are read twice, one by one: a stack may be larger than the memory.
    number, known, light_of_pixels = len(stack), np.ones(stack.shape[1:], bool), np.zeros(stack.shape[1:])
    if number < _FADING_PLANES:
        return []
    for k in range(number):
        plane = plane_of(stack, k)
        valid = np.isfinite(plane) & (plane < limit)
        known &= valid
        light_of_pixels += np.where(valid, plane - noise.offset - background, 0.0)
    left_out = float(light_of_pixels[~known].sum() / max(light_of_pixels.sum(), 1e-300))
    if not known.any() or left_out > _FADING_LEFT_OUT:
        text = (
            "it was not tested whether the light of the planes falls or rises along the stack, since bright pixels "
            "are saturated or unknown in some of them"
        )
        return [Finding("plane_light", "note", text, {"left_out": left_out, "most": _FADING_LEFT_OUT})]
    tiles = [
        (down[:, None], across)
        for down in np.array_split(np.arange(known.shape[0]), _FADING_PARTS)
        for across in np.array_split(np.arange(known.shape[1]), _FADING_PARTS)
        if known[down[:, None], across].any()
    ]
    counts = np.array([known[tile].sum() for tile in tiles])
    parts = np.empty((number, len(tiles)))
    for k in range(number):
        plane = np.where(known, plane_of(stack, k) - noise.offset - background, 0.0)
        parts[k] = [plane[tile].sum(dtype=np.float64) for tile in tiles]
    light = parts.sum(axis=1) / counts.sum()
    # A parabola has the light that leaves the frame far from focus; its slope in the middle is the change along z.
    z = np.linspace(-0.5, 0.5, number)
    terms = np.stack([np.ones(number), z, z**2 - (z**2).mean()])
    (mean, change, _), (misfit, *_), *_ = np.linalg.lstsq(terms.T, light, rcond=None)
    error = float(np.sqrt(misfit / (number - 3) / (z**2).sum()))
    # Light that crosses edges, or leaves the focus, changes parts of the field by different amounts.
    changes = (np.linalg.lstsq(terms.T, parts, rcond=None)[0][1] - change * counts) / counts.mean()
    spread = float(np.sqrt(np.square(changes).sum() / max(len(tiles) - 1, 1) / len(tiles)))
    total, least = mean + background, max(_FADING_SIGMAS * error, _FADING_SPREADS * spread)
    if total <= 0.0 or abs(change) < max(_FADING * mean, _FADING_OF_ALL * total, least):
        return []
    share = float(-change if reverse else change) / max(mean, _FADING_OF_ALL * total)
    text = (
        f"the light of the planes {'falls' if share < 0.0 else 'rises'} by {percent(abs(share))} along the stack, "
        "all over the field: if the specimen fades, restored light is wrong: record plane 1 again"
    )
    return [Finding("plane_light", "note", text, {"change": share, "least": _FADING})]


class Floor:
    """The floor of the light of a specimen that was restored chunk by chunk: of its darkest blocks.

    A background that varies over the field, where a flat one is estimated, is restored in part as such a floor.
    """

    def __init__(self) -> None:
        self._means: list[tuple[Array, Array, Values]] = []  # rows, columns (block centres), and means of blocks
        self._light = self._voxels = 0.0

    def add(self, restored: Values, rows: slice, columns: slice) -> None:
        """Add a restored chunk (planes, height, width) at `rows` and `columns` of the field."""
        self._light += float(restored.sum(dtype=np.float64))
        self._voxels += restored.size
        edges = [np.linspace(0, side, max(side // _FLOOR_BLOCK, 1) + 1).astype(int) for side in restored.shape[1:]]
        sums = np.add.reduceat(np.add.reduceat(restored, edges[0][:-1], axis=1), edges[1][:-1], axis=2)
        down, across = (
            at.start + 0.5 * (edge[1:] + edge[:-1]) for at, edge in zip((rows, columns), edges, strict=True)
        )
        means = sums / np.outer(np.diff(edges[0]), np.diff(edges[1])).astype(np.float32)
        self._means.append((down, across, means))

    def finding(self, shape: tuple[int, ...], background: Background) -> Finding | None:
        """Return the finding if an estimated `background` left a floor of more than _MAX_FLOOR of the light."""
        if background.level is not None or not self._light > 0.0 or (share := self._share(*shape[-2:])) <= _MAX_FLOOR:
            return None
        advice = 'background="uneven" estimates' if background.points == 1 else "a background in the offset removes"
        text = (
            f"{percent(share)} of the restored light is a floor between the structures, in part of the field: a "
            "specimen that fills it, light from outside of a small crop, or a background that is not flat, which "
            f"{advice}"
        )
        return Finding("uneven_background", "doubt", text, {"share": share, "most": _MAX_FLOOR})

    def _share(self, height: int, width: int) -> float:
        """Return the share of the light in the floor: the darkest blocks in each of 3 x 3 regions of the field."""
        floors = []
        for i in range(_FLOOR_REGIONS):
            for j in range(_FLOOR_REGIONS):
                values = [
                    means[:, _region(down, height, i)][:, :, _region(across, width, j)].ravel()
                    for down, across, means in self._means
                ]
                region = np.concatenate(values)
                if region.size:
                    floors.append(float(np.percentile(region, _FLOOR_PERCENTILE)))
        return float(np.mean(floors)) * self._voxels / self._light


def _region(centres: Array, side: int, number: int) -> NDArray[np.bool_]:
    """Return which block centres are in a region, one of _FLOOR_REGIONS equal parts of a side of the field."""
    return np.asarray(np.minimum((centres * _FLOOR_REGIONS / side).astype(int), _FLOOR_REGIONS - 1) == number)
