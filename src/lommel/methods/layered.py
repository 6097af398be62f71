"""What methods for the pupils of objectives share: a tolerance, and samples around one axis or each plane's own."""

from __future__ import annotations

from abc import abstractmethod
from typing import ClassVar

import numpy as np

from lommel.base import validation
from lommel.core.answers import Images, Intensities, Wanted
from lommel.methods.method import Method, painted
from lommel.optics.grid import Grid
from lommel.optics.objective_pupil import ObjectivePupil

LEAST = 1e-15
"""What fields are asked for at the finest."""


class LayeredMethod(Method):
    """A method for the pupils of objectives that samples planes around one axis; dataclasses of it have a `tol`."""

    layered: ClassVar[bool | None] = True
    apodized: ClassVar[bool] = True
    nonradial: ClassVar[bool] = True

    def __post_init__(self) -> None:
        object.__setattr__(self, "tol", validation.real("tol", self.tol, least=self.least_tol, below=1e-1))

    @abstractmethod
    def _sampled(self, pupil: ObjectivePupil, grid: Grid, tol: float) -> Intensities:
        """Return I at the centres of pixels around one axis."""

    def _samples(self, pupil: ObjectivePupil, grid: Grid, tol: float, wanted: Wanted) -> Images:
        made = self._centres(pupil, grid, max(tol, LEAST))
        return painted(made, grid, wanted)._replace(peak=made.peak)

    def _centres(self, pupil: ObjectivePupil, grid: Grid, tol: float) -> Intensities:
        """Return I at the centres of pixels, around one axis or one for each plane."""
        if not grid.stack:
            return self._sampled(pupil, grid, tol)
        alone = [self._sampled(pupil[k], grid[k], tol) for k in np.ndindex(pupil.shape)]
        values, error, peak = (np.concatenate(part) for part in zip(*alone, strict=True))
        return Intensities(values, error, peak)
