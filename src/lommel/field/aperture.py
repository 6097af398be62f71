"""The aperture that every position of a field sees: a pupil without wavefront, whole or by its most common parts."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any, TypedDict

from lommel.base import options, validation
from lommel.optics.pupil import Pupil


class ApertureKeywords(TypedDict, total=False):
    """What says which aperture it is."""

    aperture: Pupil | None
    wavelength: float | None
    f_number: float | None
    obscuration: float | None


@dataclass(frozen=True)
class ApertureOptions:
    """What says which aperture it is, together.

    Parameters
    ----------
    aperture : Pupil, optional
        With a flat wavefront; such as ``lens.pupil(2.0).unaberrated()``. Its obscuration, spider, vignetting, mask,
        apodization and scale are those of the whole field; its geometry, which is known on the axis only, is not.
    wavelength, f_number, obscuration : float, optional
        As of :class:`lommel.Pupil`, for what `aperture` does not state.
    """

    aperture: Pupil | None = None
    wavelength: float | None = None
    f_number: float | None = None
    obscuration: float | None = None

    def bare(self) -> Pupil:
        """Return the pupil without wavefront.

        Raises
        ------
        TypeError, ValueError
            If the aperture is no pupil, has a wavefront, or contradicts what is stated beside it, or if that is out
            of range.
        """
        stated = {name: v for name, v in vars(self).items() if name != "aperture" and v is not None}
        if self.aperture is None:
            return Pupil(**stated)
        given: Pupil = validation.instance("aperture", self.aperture, Pupil)
        if not given.wavefront.flat:
            raise ValueError(
                "aperture must have a flat wavefront, for the map has those of all positions: give "
                "aperture.unaberrated(), and add its wavefront to the map where it is meant (field + wavefront)"
            )
        for name, value in stated.items():
            if (known := getattr(given, name)) not in (None, value):
                raise ValueError(f"{name} must be that of the aperture, {known:g}, or be left out, got {value!r}")
        return replace(given, geometry=None, **stated)


def bare_pupil(door: Callable[..., Any], given: Mapping[str, Any]) -> Pupil:
    """Return the pupil without wavefront of what `door` was given; TypeError for what it does not take."""
    options.require_known(door, given, ApertureKeywords)
    return ApertureOptions(**given).bare()
