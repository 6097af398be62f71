"""Whether the standard errors of a fit hold: whether images are linear in the parameters over their uncertainty."""

from __future__ import annotations

import numpy as np

from lommel.base.arrays import Array
from lommel.estimation.scoring import covariance
from lommel.estimation.star_images import StarImages

CERTAIN = 0.25
"""Radians rms: of images whose phases are known less well, other minima of the likelihood are often as deep."""

STEADY = 1.125
"""Factor by which a standard error may change within one standard deviation of the answer."""


def uncertainty(model: StarImages, inverse: Array) -> tuple[float, Array]:
    """Return the rms error to be expected of the phases of an image, radians, and the principal axes of a covariance.

    The error is the largest of all images, its tilts included. Each row of the axes, shape (k, p), is one standard
    deviation. What has an infinite variance is held.
    """
    known = np.isfinite(np.diag(inverse))
    scale = np.sqrt(np.diag(inverse)[known])
    values, vectors = np.linalg.eigh(inverse[np.ix_(known, known)] / np.outer(scale, scale))
    # The sign of an eigenvector is open: its largest component is made positive.
    vectors *= np.sign(vectors[np.abs(vectors).argmax(axis=0), np.arange(len(values))])
    axes = np.zeros((len(values), model.size))
    axes[:, known] = (vectors * np.sqrt(np.maximum(values, 0.0))).T * scale
    # The mean square of a tilt over the pupil is a quarter of that at its edge.
    tilts = 0.25 * (model.own_of(axes)[:, : len(model.tilts)] ** 2).sum(axis=(0, 1))
    return float(np.sqrt((model.rms(axes) ** 2).sum() + tilts.max())), axes


def changes(model: StarImages, x: Array, inverse: Array, axes: Array) -> Array:
    """Return the factor by which the standard error of each shared parameter changes near the answer `x`, (1, p).

    It is the geometric rms of those at two opposite points, each one standard deviation away along all principal axes
    at once; 1 for what has an infinite standard error.
    """
    found = np.ones(model.shared)
    known = np.isfinite(np.diag(inverse)[: model.shared])
    if known.any():
        points = [model.within(x + step, x) for step in (axes.sum(axis=0), -axes.sum(axis=0))]
        # The numbers of the pupil are the same in a stack.
        stacks = points if model.unknowns.pupil else [np.concatenate(points)]
        squares = [one for stack in stacks for one in model.judged(stack, np.float64).information]
        there = np.array([np.diag(covariance(one))[: model.shared][known] for one in squares])
        ratios = 0.5 * np.log(there / np.diag(inverse)[: model.shared][known])
        found[known] = np.exp(np.sqrt((ratios**2).mean(axis=0)))
    return found
