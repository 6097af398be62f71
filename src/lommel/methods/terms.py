"""Pupils and windows in the form that the compiled core takes."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from lommel.core.answers import Declined, Images, Wanted
from lommel.core.engine import DiskStack, RadialStack, Window
from lommel.optics.grid import Grid

if TYPE_CHECKING:
    from lommel.optics.pupil import Pupil


def radial_stack(pupil: Pupil) -> RadialStack:
    """Return the flattened stack of a radially symmetric pupil."""
    if not pupil.radial:
        raise Declined(
            "a pupil that is not radially symmetric has no radial profile; ask for its image with lommel.psf"
        )
    return RadialStack(pupil.radial_terms(), pupil.obscuration, pupil.illumination.exponent)


def disk_stack(pupil: Pupil) -> DiskStack:
    """Return the flattened stack of a pupil of any wavefront over a round aperture."""
    edge, indices = pupil.wavefront.edge, pupil.wavefront.indices
    return DiskStack(indices, edge.reshape(-1, len(indices)), pupil.obscuration, pupil.illumination.exponent)


def window_of(pupil: Pupil, grid: Grid) -> Window:
    """Return the pixels of a grid in v."""
    each = (np.stack([np.ravel(part) for part in grid.center], axis=1),) if grid.stack else None
    return Window(grid.shape, each or grid.axis, grid.step(pupil))


def disk_images(
    sample: Callable[[DiskStack, Window, float, Wanted], Images], pupil: Pupil, grid: Grid, tol: float, wanted: Wanted
) -> Images:
    """Return the images of any wavefront by what samples pixels: as it is, or averaged from finer samples."""

    def sampled(some: Pupil, pixels: Grid, tol: float, wanted: Wanted) -> Images:
        return sample(disk_stack(some), window_of(some, pixels), tol, wanted)

    if not grid.integrate:
        return sampled(pupil, grid, tol, wanted)
    from lommel.methods.pixels.averaging import averaged_images

    return averaged_images(sampled, pupil, grid, tol, wanted)
