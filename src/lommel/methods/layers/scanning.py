"""Scanning microscopes: confocal with a pinhole of any size, and two-photon excitation."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.methods.layers.disc_means import disc_means
from lommel.methods.layers.orders import Orders, ProvenMethod, highest, light, product
from lommel.methods.method import RadialMethod
from lommel.optics.layers.emitter import Absorbed, Beam, Dipole
from lommel.optics.layers.objective_pupil import ObjectivePupil

AIRY = 2.0 * math.pi * 0.61  # ``0.61 lambda / NA``, half an Airy unit, in v
_PINHOLE_MOST = 100.0


@dataclass(frozen=True)
class Confocal(ProvenMethod):
    r"""A confocal microscope: what is excited, times the share of its light that passes a pinhole.

    ``E(r) P(r)`` where the axis of both is at r from the emitter: E is the intensity of the excitation, relative to
    the focus of a uniform scalar aperture that sends as much light through the same plane of the sample, P the share
    of the light that the objective collects of the emitter which passes the pinhole. Of pupils for emission; the
    planes are theirs. An emitter that is a :class:`lommel.Dipole` absorbs as it emits: E is then the part of the
    field along it, three times its intensity, averaged over how it wobbles; where it turns freely, all of the
    intensity.

    Parameters
    ----------
    excitation : ObjectivePupil
        The light that excites, whatever its planes.
    pinhole : float, default 1
        Its diameter in Airy units, ``1.22 lambda / NA`` of the emission.
    tol : float, default 1e-6
        Tolerance over the peak of each plane.

    Raises
    ------
    TypeError, ValueError
        If one of them is none of these.

    Notes
    -----
    ``E(r) = 4 pi / (k NA)^2 I(r) / int I d^2r``, the integral over the plane of the emitter, the same at every
    focus; for circular light ``I = abs(K0)^2 + 2 abs(K1)^2 + abs(K2)^2`` of :meth:`lommel.Objective.fields`.
    Fresnel's losses and light beyond the critical angle are in the integral, which near the glass changes with the
    depth.

    E P has the spatial frequencies of both, ``1 + lambda_emission / lambda_excitation`` times those of a field.

    References
    ----------
    T. Ha, T. A. Laurence, D. S. Chemla and S. Weiss, J. Phys. Chem. B 103, 6839 (1999), doi:10.1021/jp990948j:
    dipoles in polarised light.
    """

    excitation: ObjectivePupil
    pinhole: float = 1.0
    tol: float = 1e-6

    def __post_init__(self) -> None:
        super().__post_init__()
        given = self.excitation
        pupil = ObjectivePupil.from_dict(given) if isinstance(given, dict) else given
        validation.instance("excitation", pupil, ObjectivePupil)
        if pupil.aberrated:
            raise ValueError(f"excitation must be without aberrations, got {pupil.aberrations!r}")
        if not (pupil.radial or isinstance(pupil.emitter, Beam)):
            raise ValueError(f"excitation must be the light of a Beam, got that of {pupil.emitter!r}")
        one = pupil[(0,) * len(pupil.shape)] if pupil.shape else pupil
        object.__setattr__(self, "excitation", one)
        pinhole = validation.real("pinhole", self.pinhole, above=0.0)
        if pinhole > _PINHOLE_MOST:
            raise ValueError(f"pinhole must be at most {_PINHOLE_MOST:g} Airy units, got {pinhole:g}")
        object.__setattr__(self, "pinhole", pinhole)

    def unsupported(self, pupil: ObjectivePupil) -> str | None:
        """Return the reason where there are aberrations, or the excitation is that of another objective."""
        if pupil.magnification != self.excitation.magnification:
            return (
                f"has an excitation of the magnification {self.excitation.magnification:g}, "
                f"and a pupil of {pupil.magnification:g}"
            )
        if reason := super().unsupported(pupil):
            return reason
        if _fixed(pupil) and not isinstance(self.excitation.emitter, Beam):
            return f"needs an excitation by a Beam for {pupil.emitter!r}, got {self.excitation.emitter!r}"
        if not self._lit(pupil).power.min() > 0.0:
            return f"has an excitation without a field along {pupil.emitter!r}"
        return None

    def along_radius(self, pupil: ObjectivePupil) -> RadialMethod | None:
        """Return the method itself where neither light depends on the direction, else None."""
        return self if pupil.radial and self._lit(pupil).radial else None

    def _ceiling(self, pupil: ObjectivePupil) -> float:
        """Return what the product is at most, and the integral of the modulus of its transfer function."""
        return max(1.0, self._share) * float(self._absorbed(pupil).max())

    @property
    def _share(self) -> float:
        """The light through the pinhole over the mean of the intensity across it."""
        return 0.25 * (AIRY * self.pinhole) ** 2

    def _lit(self, pupil: ObjectivePupil) -> ObjectivePupil:
        """Return what excites in the planes of the emission, as its emitter absorbs it."""
        beam = self.excitation.emitter
        if isinstance(beam, Beam) and (dipole := _fixed(pupil)):
            beam = Absorbed(beam.polarization, dipole)
        return replace(pupil, layers=self.excitation.layers, emitter=beam, aberrations=None)

    def _absorbed(self, pupil: ObjectivePupil) -> Array:
        """Return the light that is absorbed in each plane, wherever, over that of the beam."""
        lit = self._lit(pupil)
        return lit.power / replace(lit, emitter=self.excitation.emitter).power

    def stretch(self, pupil: ObjectivePupil) -> float:
        """Return the exponential type of a field whose square is the product."""
        return 1.0 + pupil.scale / self.excitation.scale

    def _orders(self, pupil: ObjectivePupil, v: Array, asked: float) -> Orders:
        """Return the product at rising v, of the emission."""
        excited = light(self._lit(pupil), pupil.scale / self.excitation.scale * v, asked, self.tol)
        means = disc_means(v, AIRY * self.pinhole, asked / max(1.0, self._share), highest(pupil))
        seen = light(pupil, means.places, asked, self.tol)
        passed = Orders(means.of(seen.values), seen.error * means.gain + means.error)
        return product(excited.times(self._absorbed(pupil)), passed.times(np.full(len(seen.error), self._share)))


def _fixed(pupil: ObjectivePupil) -> Dipole | None:
    """Return the dipole of a pupil, unless it turns freely."""
    emitter = pupil.emitter
    return emitter if isinstance(emitter, Dipole) and emitter.wobble < 1.0 else None


@dataclass(frozen=True)
class TwoPhoton(ProvenMethod):
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

    def _orders(self, pupil: ObjectivePupil, v: Array, asked: float) -> Orders:
        """Return the square of the intensity at rising v."""
        once = light(pupil, v, asked, self.tol)
        return product(once, once)
