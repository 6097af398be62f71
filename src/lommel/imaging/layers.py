"""Points that hide one another: a scene cut into layers of similar defocus, laid over each other from the front."""

from __future__ import annotations

import copy
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.imaging.blur import DepthBlur
from lommel.optics.pupil import ray_height

MOST_LAYERS = 64
"""Layers are made thicker than a pixel of blur where there would be more of them."""

# The share of a point's sharp light that it keeps, so that what is divided by is never 0.
_TRACE = 1e-9


def occlude(blur: DepthBlur, light: NDArray[Any]) -> NDArray[Any]:
    r"""Return the image of linear light in which near points hide far ones.

    Points are sorted into layers, within each of which the diameter of the blur changes by a pixel (or by a 64th of
    its range over the scene, if that is more). From the nearest layer to the farthest, the light B and the coverage A
    (the same for a scene that is white) are spread, each point by its own PSF, and as much is taken of them as the
    layers before have left of the aperture: ``out = sum w B / A``, ``w = min(A, 1 - sum of w before)``.

    Coverages add up, up to all of the aperture, instead of being multiplied as those of independent screens would be
    (``T *= 1 - A``): points of one slanted surface lie in many layers and see disjoint parts of the aperture. A
    product would leave such a surface transparent, and weigh its near points more; with the sum, the result is that
    of :meth:`lommel.imaging.DepthBlur.forward` wherever nothing is hidden, but for what makes a white scene white
    where the blur varies. Two separate screens before a third surface cover rather too much of it.

    Where a near surface ends before a far one, the lens sees round it some of what the image does not show: points
    closer to the edge than the radii of their blurs differ. These are given a second point, behind, with light and
    defocus of the point of the far surface mirrored at the edge. Dividing by the coverage instead would leave a sharp
    line in the blurred edge of a near object, at the last pixel where the far surface is known; repeating the last
    point of it would draw streaks out of highlights. What neither covers, behind surfaces hidden twice or at slopes
    of depth near the limit, is filled by dividing by the sum of w.

    Memory: 60 bytes a point, and 55 a point and channel (105 in float64). Time, as measured on one grey image over
    that of :meth:`lommel.imaging.DepthBlur.forward`: with windows of 17 pixels 6 for two planes, 15 for a slanted one
    of thirty layers, 26 for one with bars before it, most of it the distance transform of each layer; with windows of
    51 pixels, and 64 layers, 3, 6 and 8.

    Parameters
    ----------
    blur : DepthBlur
    light : ndarray of float, shape (height, width) or (height, width, channels)

    Returns
    -------
    ndarray
        Of the shape of `light`.

    Raises
    ------
    TypeError, ValueError
        As :meth:`lommel.imaging.DepthBlur.forward`.
    """
    blur.require(light)
    layer, radius = _layers(blur)
    behind = _behind(layer, radius)
    hidden_layer = np.where(behind >= 0, layer.ravel()[behind], -1)
    hidden_defocus = blur.defocus.ravel()[behind]
    hidden_light = light.reshape(-1, *light.shape[2:])[behind]
    part = copy.copy(blur)
    cover = copy.copy(blur)
    # Darkness beyond the edges is no hole: it is as far away as the last points are.
    cover.border = "extend" if blur.border == "zero" else blur.border
    white = np.ones(light.shape, dtype=blur.dtype)
    out, taken = np.zeros_like(white), np.zeros_like(white)
    for index in np.unique(layer):
        # A hidden point is in a farther layer than the one before it, so no pixel has two points in a layer.
        hidden = hidden_layer == index
        points = hidden | (layer == index)
        part.defocus = cover.defocus = np.where(hidden, hidden_defocus, blur.defocus)
        shown = hidden if light.ndim == 2 else hidden[:, :, None]
        spread = part.forward(np.where(shown, hidden_light, light), points)
        covered = np.maximum(cover.forward(white, points), 0.0)
        left = np.maximum(1.0 - taken, 0.0)
        share = np.divide(left, covered, out=np.ones_like(white), where=covered > left)
        out += share * spread
        taken += share * covered
        if np.all(taken >= 1.0):
            break
    return np.asarray((out + _TRACE * light) / (taken + _TRACE), dtype=blur.dtype)


def _layers(blur: DepthBlur) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Return the layer of each point, 0 the nearest, and the signed radius of its geometric blur in pixels."""
    # Where a ray from the edge of the pupil meets the sensor, at v = 4 C_d if paraxial, else nearly in proportion to
    # C_d. Near points have the largest.
    defocus = np.linspace(blur.defocus.min(), blur.defocus.max(), 129)
    rim = ray_height(blur.lens.phase(defocus).edge, np.ones(1))[:, 0]
    unit = blur.lens.wavelength * blur.lens.working_f_number / (math.pi * blur.pixel)
    radius = unit * np.interp(blur.defocus, defocus, rim)
    depth = radius.max() - radius
    thickness = max(0.5, float(depth.max()) / MOST_LAYERS)
    return np.minimum((depth / thickness).astype(np.int64), MOST_LAYERS - 1), radius


def _behind(layer: NDArray[np.int64], radius: NDArray[np.float64]) -> NDArray[np.int64]:
    """Return for each point the flat index of the one that stands for what it hides, or -1 if the lens sees nothing.

    A point hides something that the lens can see if a farther one is closer than their radii differ: rays through
    the rim of the aperture then pass the edge between them. The nearest such point marks the edge. (Diffraction
    reaches a little beyond the rim; the percent of light that it brings there is filled by dividing.)
    """
    behind = np.full(layer.shape, -1, dtype=np.int64)
    if not _torn(radius):
        return behind
    from scipy.ndimage import distance_transform_edt

    (height, width), (y, x) = layer.shape, np.indices(layer.shape)
    for index in np.unique(layer)[1:]:
        far = layer >= index
        row, column = distance_transform_edt(~far, return_distances=False, return_indices=True)
        near = np.hypot(row - y, column - x) < radius - radius[row, column]
        found = near & ~far & (behind < 0)
        y2, x2 = 2 * row - y, 2 * column - x
        inside = (y2 >= 0) & (y2 < height) & (x2 >= 0) & (x2 < width)
        mirrored = np.where(inside, y2 * width + x2, 0)
        mirrored = np.where(inside & far.ravel()[mirrored], mirrored, row * width + column)
        behind = np.where(found, mirrored, behind)
    return behind


def _torn(radius: NDArray[np.float64]) -> bool:
    """Return whether radii differ by more than the distance of the points anywhere.

    Then they do, but for 8 %, between neighbours: paths over neighbours are at most so much longer than straight.
    """
    limit = math.cos(math.pi / 8.0)
    steps = [(radius[1:], radius[:-1], 1.0), (radius[:, 1:], radius[:, :-1], 1.0)]
    steps += [(radius[1:, 1:], radius[:-1, :-1], math.sqrt(2.0)), (radius[1:, :-1], radius[:-1, 1:], math.sqrt(2.0))]
    return any(bool(np.any(np.abs(a - b) > limit * step)) for a, b, step in steps)
