"""The wavelengths that light consists of, and the pupil in each of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.optics.base_pupil import BasePupil


class Component(NamedTuple):
    """One of the fields whose intensities add up to what is recorded.

    Attributes
    ----------
    share : float
        Of the light.
    stretch : float
        How much faster its field varies over the sensor than that of the reference: wavelength there over its own.
    pupil : Pupil
    """

    share: float
    stretch: float
    pupil: Any

    @property
    def weight(self) -> float:
        """Peak without aberration over that of the reference: as much light is brighter where its spot is smaller."""
        return self.share * self.stretch**2


@dataclass(frozen=True, init=False)
class Spectrum:
    """Wavelengths and how much light there is at each.

    Parameters
    ----------
    wavelengths : sequence of float
        Metres.
    weights : sequence of float, optional
        Share of the light at each wavelength, >= 0; made to sum to 1. By default all are equal.

    Raises
    ------
    TypeError, ValueError
        On what is no wavelength or none at all, or if the weights are not one for each, negative or all 0.
    """

    wavelengths: tuple[float, ...]
    weights: tuple[float, ...]

    def __init__(self, wavelengths: Sequence[float], weights: ArrayLike | None = None) -> None:
        waves = checked_wavelengths(wavelengths)
        shares = np.ones(len(waves)) if weights is None else validation.real_array("weights", weights, least=0.0)
        if shares.shape != (len(waves),) or not shares.max() > 0:
            raise ValueError(
                f"weights must be one for each of the {len(waves)} wavelengths, and not all 0, "
                f"got {validation.shown(weights)}"
            )
        shares = shares / shares.max()  # whose sum cannot overflow
        vars(self).update(wavelengths=waves, weights=tuple((shares / shares.sum()).tolist()))

    def components(self, pupil: BasePupil) -> list[Component]:
        """Return what light of each wavelength makes of a pupil.

        Parameters
        ----------
        pupil : Pupil
            Its wavelength is the reference.

        Returns
        -------
        list of Component

        Raises
        ------
        ValueError
            If the pupil has no wavelength.
        """
        if pupil.wavelength is None:
            raise ValueError("a spectrum needs a pupil with a wavelength, to which the others are related")
        return [
            Component(share, pupil.wavelength / w, pupil.in_light(w))
            for w, share in zip(self.wavelengths, self.weights, strict=True)
        ]


def checked_wavelengths(wavelengths: ArrayLike) -> tuple[float, ...]:
    """Return wavelengths in metres; TypeError or ValueError if one of them is none, or there are none."""
    waves = tuple(validation.wavelength(w) for w in np.atleast_1d(validation.array("wavelengths", wavelengths)))
    if not waves:
        raise ValueError("wavelengths must not be empty")
    return waves
