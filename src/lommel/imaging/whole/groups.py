"""Points that spread windows of one bank, of which pixels see all or some: the parts of a blur with occlusion."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.imaging.bank import Bank
from lommel.imaging.blur import DepthBlur, Points


class Group(NamedTuple):
    """Points that spread windows of one bank.

    Attributes
    ----------
    sources : list of (int, Points)
        0 for light of the scene, 1 for what is behind it, and the points.
    bank : Bank, optional
        If another than that of the channel.
    hidden : bool
        Whether pixels see only some of it.
    taken_off : bool
        Whether it is subtracted.
    """

    sources: list[tuple[int, Points]]
    bank: Bank | None = None
    hidden: bool = True
    taken_off: bool = False


def groups_of_whole(blur: DepthBlur, channel: int, sources: list[Points], seen: NDArray[Any]) -> list[Group]:
    """Return groups for a blur of which nothing is lost, so that the remainder shows nothing that is hidden.

    A window holds the PSF less what the remainder holds of it, which nothing hides. A point that some pixel in its
    window does not see spreads its PSF, hidden, less what the remainder holds within the window, all of it.

    Parameters
    ----------
    blur : DepthBlur
    channel : int
    sources : list of Points
        Those of the scene and, if any, those behind it.
    seen : ndarray, shape (height, width)
        How many layers each pixel sees.

    Returns
    -------
    list of Group
    """
    from scipy.ndimage import minimum_filter

    assert blur.beyond is not None
    within, filled = blur.beyond.apart(channel)
    scene, *behind = sources
    assert scene.layers is not None
    least = minimum_filter(seen, 2 * within.half + 1, mode="reflect" if blur.border == "reflect" else "nearest")
    free = least >= scene.layers + 1
    groups = [Group([(0, Points(np.where(free, scene.positions, -1.0)))], hidden=False)]
    if behind or not free.all():
        hidden = np.where(free, -1.0, scene.positions)
        groups.append(Group([(0, Points(hidden, scene.layers)), *((1, points) for points in behind)], within))
        groups.append(Group([(0, Points(hidden))], filled, hidden=False, taken_off=True))
    return groups


def spread_groups(
    blur: DepthBlur, channel: int, planes: Sequence[NDArray[Any]], seen: NDArray[Any], groups: list[Group]
) -> NDArray[Any]:
    """Return what light of a scene, and of what is behind it, makes of one channel.

    Parameters
    ----------
    blur : DepthBlur
    channel : int
    planes : sequence of ndarray, shape (height, width)
        Light of the scene, and of what is behind it.
    seen : ndarray, shape (height, width)
        How many layers each pixel sees.
    groups : list of Group

    Returns
    -------
    ndarray, shape (height, width)
    """
    total = np.zeros(blur.shape, dtype=blur.dtype)
    for group in groups:
        given = [(planes[behind], points) for behind, points in group.sources]
        made = blur.spread(channel, given, seen if group.hidden else None, bank=group.bank)
        total += -made if group.taken_off else made
    if blur.beyond is not None:
        total += blur.beyond.spread(blur, [channel], [planes[0]])[0]
    return total


def collect_groups(
    blur: DepthBlur, channel: int, plane: NDArray[Any], seen: NDArray[Any], groups: list[Group]
) -> tuple[NDArray[Any], NDArray[Any]]:
    """Return what the transpose of :func:`spread_groups` gives to the scene and to what is behind it.

    Parameters
    ----------
    blur : DepthBlur
    channel : int
    plane : ndarray, shape (height, width)
    seen : ndarray, shape (height, width)
        How many layers each pixel sees.
    groups : list of Group

    Returns
    -------
    scene, behind : ndarray, shape (height, width)
    """
    taken = np.zeros((2, *blur.shape), dtype=blur.dtype)
    for group in groups:
        points = [each for _, each in group.sources]
        given = blur.collect(channel, plane, points, seen if group.hidden else None, bank=group.bank)
        for (behind, _), more in zip(group.sources, given, strict=True):
            taken[behind] += -more if group.taken_off else more
    if blur.beyond is not None:
        taken[0] += blur.beyond.collect(blur, [channel], [plane])[0]
    return taken[0], taken[1]
