"""Answers over a sensor, each with its place, and where they are asked for at several distances and in channels."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.measures.answer import Answer, checked
from lommel.measures.answer_channels import AnswerChannels
from lommel.optics.base_pupil import object_distances


@dataclass(frozen=True, eq=False)
class AnswerGrid:
    """The data of a :class:`lommel.PSFGrid`, whose attributes these are."""

    psf: Answer | AnswerChannels[Any]
    x: Array
    y: Array
    sensor: tuple[float, float]
    depths: Array | None = None

    def __post_init__(self) -> None:
        stack = (self.psf if isinstance(self.psf, AnswerChannels) else checked(self.psf, "psf")).pupil.shape
        axes = 2 if self.depths is None else 3
        for name, count in (("y", 0), ("x", 1)):
            places = validation.real_array(name, getattr(self, name))
            if len(stack) != axes or places.shape != stack[count : count + 1]:
                raise ValueError(f"{name} must be the places of PSFs of shape {stack}, got shape {places.shape}")
            object.__setattr__(self, name, places)
        object.__setattr__(self, "sensor", sides(self.sensor, self.unit))
        if self.depths is not None:
            distances = np.atleast_1d(object_distances(self.depths))
            if distances.shape != stack[2:]:
                raise ValueError(f"depths must be those of PSFs of shape {stack}, got shape {distances.shape}")
            object.__setattr__(self, "depths", distances)

    @property
    def values(self) -> NDArray[Any]:
        """Values, shape (rows, columns, height, width), with axes of depths and channels before the last two."""
        return self.psf.values

    @property
    def dims(self) -> tuple[str, ...]:
        """Names of the axes of the values."""
        depth = () if self.depths is None else ("depth",)
        channel = ("channel",) if isinstance(self.psf, AnswerChannels) else ()
        return ("field_y", "field_x", *depth, *channel, "y", "x")

    @property
    def unit(self) -> str:
        """Unit of positions: ``"m"`` or ``"lambda*N"``."""
        return self.psf.unit

    def __len__(self) -> int:
        """Return the number of rows."""
        return int(self.y.size)

    def __repr__(self) -> str:
        size = f"{self.sensor[0]:g} x {self.sensor[1]:g} {self.unit}"
        deep = "" if self.depths is None else f" x {self.depths.size} distances"
        return f"<{type(self).__name__} {self.y.size} x {self.x.size}{deep} on {size}: {self.psf!r}>"


def sides(sensor: Any, unit: str) -> tuple[float, float]:
    """Return the height and width of a sensor; TypeError or ValueError if it has none."""
    if not isinstance(sensor, tuple | list) or len(sensor) != 2:
        raise TypeError(f"sensor must be (height, width), got {validation.shown(sensor)}")
    height, width = (validation.real(f"sensor[{k}]", side, above=0.0, unit=unit) for k, side in enumerate(sensor))
    return height, width
