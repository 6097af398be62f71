"""What scanning microscopes see: light that is excited in one spot, once or twice, through a pinhole or not."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields, replace
from typing import Any, ClassVar

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.core.answers import Intensities
from lommel.methods.disc_means import disc_means
from lommel.methods.method import RadialMethod
from lommel.methods.proven import light, proven
from lommel.optics.objective_pupil import ObjectivePupil

AIRY = 2.0 * math.pi * 0.61
"""``0.61 lambda / NA``, the Airy unit, in v."""
_PINHOLE_MOST = 100.0


class _Scanning(RadialMethod):
    """What both kinds share: an objective's light, to a tolerance."""

    layered: ClassVar[bool | None] = True
    apodized: ClassVar[bool] = True
    tol: float

    def __post_init__(self) -> None:
        object.__setattr__(self, "tol", validation.real("tol", self.tol, least=self.least_tol, below=1e-1))

    def unaberrated_peak(self, pupil: ObjectivePupil) -> float:
        """Return 1: all light in focus, and all of it seen."""
        return 1.0


@dataclass(frozen=True)
class Confocal(_Scanning):
    r"""A confocal microscope: what is excited, times the share of its light that passes a pinhole.

    ``E(r) P(r)`` for an emitter at r from the axis of both: E is the intensity of the excitation over that in the
    focus of a uniform scalar aperture, P the share of the light that the objective collects of the emitter which
    passes the pinhole. Of pupils for emission; the planes are theirs.

    Parameters
    ----------
    excitation : ObjectivePupil
        The light that excites, whatever its planes.
    pinhole : float, default 1
        Its radius in Airy units, ``0.61 lambda / NA`` of the emission.
    tol : float, default 1e-6
        Tolerance over the peak of each plane.

    Raises
    ------
    TypeError, ValueError
        If one of them is none of these.

    Notes
    -----
    E P has the spatial frequencies of both, ``1 + lambda_emission / lambda_excitation`` times those of a field.
    """

    excitation: ObjectivePupil
    pinhole: float = 1.0
    tol: float = 1e-6

    def __post_init__(self) -> None:
        super().__post_init__()
        given = self.excitation
        pupil = ObjectivePupil.from_dict(given) if isinstance(given, dict) else given
        validation.instance("excitation", pupil, ObjectivePupil)
        if not pupil.radial:
            raise ValueError(f"excitation must not depend on the direction, got {pupil.emitter!r}")
        one = pupil[(0,) * len(pupil.shape)] if pupil.shape else pupil
        object.__setattr__(self, "excitation", one)
        pinhole = validation.real("pinhole", self.pinhole, above=0.0)
        if pinhole > _PINHOLE_MOST:
            raise ValueError(f"pinhole must be at most {_PINHOLE_MOST:g} Airy units, got {pinhole:g}")
        object.__setattr__(self, "pinhole", pinhole)

    def unsupported(self, pupil: Any) -> str | None:
        """Return the reason where the excitation is that of another objective."""
        if isinstance(pupil, ObjectivePupil) and pupil.magnification != self.excitation.magnification:
            return (
                f"has an excitation of the magnification {self.excitation.magnification:g}, "
                f"and a pupil of {pupil.magnification:g}"
            )
        return None

    def _stretched(self, pupil: ObjectivePupil) -> float:
        """Return v of the excitation over that of the emission."""
        return pupil.scale / self.excitation.scale

    def stretch(self, pupil: ObjectivePupil) -> float:
        """Return the exponential type of a field whose square is the product."""
        return 1.0 + self._stretched(pupil)

    def profile(self, pupil: ObjectivePupil, v: Array) -> Intensities:
        """Return the product at rising v, of the emission."""
        radius, faster = AIRY * self.pinhole, self._stretched(pupil)
        share = 0.25 * radius**2
        lit = replace(pupil, layers=self.excitation.layers, emitter=self.excitation.emitter)

        def made_of(at: Array, tol: float) -> tuple[Array, Array]:
            means = disc_means(at, radius, tol / max(1.0, share))
            excited, off = light(lit, faster * at, tol, self.tol)
            seen, error = light(pupil, means.places, tol, self.tol)
            passed = np.maximum(share * (seen @ means.weights), 0.0)
            error = share * (error * means.gain + means.error)
            return excited * passed, off * passed.max(axis=1) + error * (excited.max(axis=1) + off) + 2.0**-50

        return proven(v, made_of, self.tol)

    def to_dict(self) -> dict[str, Any]:
        """Return the method's name and options in plain types."""
        options = {item.name: getattr(self, item.name) for item in fields(self)}
        return {"name": type(self).__name__} | options | {"excitation": self.excitation.to_dict()}


@dataclass(frozen=True)
class TwoPhoton(_Scanning):
    r"""A two-photon microscope, whose excitation counts squared; all light is collected, from wherever.

    Of pupils of the light that excites.

    Parameters
    ----------
    tol : float, default 1e-6
        Tolerance over the peak of each plane.

    Raises
    ------
    TypeError, ValueError
        If `tol` is out of range.

    References
    ----------
    W. Denk, J. H. Strickler and W. W. Webb, Science 248, 73 (1990), doi:10.1126/science.2321027.
    """

    tol: float = 1e-6

    def stretch(self, pupil: ObjectivePupil) -> float:
        """Return 2: the square of an intensity."""
        return 2.0

    def profile(self, pupil: ObjectivePupil, v: Array) -> Intensities:
        """Return the square of the intensity at rising v."""

        def made_of(at: Array, tol: float) -> tuple[Array, Array]:
            values, error = light(pupil, at, tol, self.tol)
            return values**2, error * (2.0 * values.max(axis=1) + error) + 2.0**-50

        return proven(v, made_of, self.tol)
