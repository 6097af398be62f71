"""Scanning microscopes: confocal with a pinhole of any size, two-photon excitation, and STED."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from typing import cast

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.core.answers import Images, Wanted
from lommel.methods.layers.disc_means import disc_means
from lommel.methods.layers.orders import Orders, ProvenMethod, highest, light, product
from lommel.methods.layers.samples import Samples, disc_filter, light_samples
from lommel.methods.method import RadialMethod
from lommel.optics.grid import Grid
from lommel.optics.layers import debye
from lommel.optics.layers.emitter import Absorbed, Beam, Dipole
from lommel.optics.layers.objective_pupil import ObjectivePupil

AIRY = 2.0 * math.pi * 0.61  # ``0.61 lambda / NA``, half an Airy unit, in v
_PINHOLE_MOST = 100.0
_SATURATION_MOST = 1e4
_SHARE = 0.02  # of the tolerance: what a polynomial may differ from the exponential by
_COARSE, _FINE = np.linspace(0.1, 8.0, 80), np.linspace(-0.1, 0.1, 101)  # v, where the crest is looked for


@dataclass(frozen=True)
class Confocal(ProvenMethod):
    r"""Confocal microscope: excitation intensity times the fraction of the emission that passes the pinhole.

    ``E(r) P(r)``, r being the distance of the emitter from the axis: E is the excitation intensity, relative to the
    focus of a uniform scalar aperture that sends as much light through the same plane of the sample; P is the
    fraction of the collected emission that passes the pinhole. The pupil is that of the emission, and gives the
    planes. A :class:`lommel.Dipole` absorbs the field along its moment: E is then three times the intensity of that
    component, averaged over its wobble; for a freely rotating dipole it is the total intensity.

    Parameters
    ----------
    excitation : ObjectivePupil
        Excitation light, in any planes.
    pinhole : float, default 1
        Diameter of the pinhole in Airy units, ``1.22 lambda / NA`` of the emission.
    tol : float, default 1e-6
        Tolerance relative to the peak of each plane.

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or out of range.

    Notes
    -----
    ``E(r) = 4 pi / (k NA)^2 I(r) / int I d^2r``, the integral over the plane of the emitter, the same at every
    focus; for circular light ``I = abs(K0)^2 + 2 abs(K1)^2 + abs(K2)^2`` of :meth:`lommel.Objective.fields`.
    The integral includes Fresnel losses and light beyond the critical angle; near the glass it changes with depth.

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
        pupil = _given("excitation", self.excitation)
        if not (pupil.light.radial or isinstance(pupil.emitter, Beam)):
            raise ValueError(f"excitation must be the light of a Beam, got that of {pupil.emitter!r}")
        object.__setattr__(self, "excitation", _one_plane("excitation", pupil))
        pinhole = validation.real("pinhole", self.pinhole, above=0.0, most=_PINHOLE_MOST, unit="Airy units")
        object.__setattr__(self, "pinhole", pinhole)

    def unsupported(self, pupil: ObjectivePupil) -> str | None:
        """Return the reason where the excitation is that of another objective, or leaves the emitter dark."""
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
        return self if pupil.radial and self._lit(pupil).radial and not self._aberrated(pupil) else None

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
        return replace(pupil, layers=self.excitation.layers, emitter=beam, aberrations=self.excitation.aberrations)

    def _aberrated(self, pupil: ObjectivePupil) -> bool:
        """Return whether any of the light has aberrations."""
        return pupil.aberrated or self.excitation.aberrated

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

    def _pixels(self, pupil: ObjectivePupil, grid: Grid, asked: float, threads: int) -> Samples:
        """Return the product at the centres of pixels."""
        accuracy = asked / max(1.0, self._share)
        means = disc_filter(grid.step(pupil), AIRY * self.pinhole, accuracy)
        seen = means.of(light_samples(pupil, means.samples(grid), accuracy / means.gain, threads), threads)
        excited = light_samples(self._lit(pupil), grid, asked, threads).times(self._absorbed(pupil))
        return excited.times(seen.times(np.full(len(seen.error), self._share)))


def _one_plane(name: str, pupil: ObjectivePupil) -> ObjectivePupil:
    """Return the pupil in one of its planes, which share their aberrations."""
    if pupil.aberrations is not None and pupil.aberrations.shape:
        raise ValueError(f"{name} must have one set of aberrations for all planes, got a stack")
    return pupil[(0,) * len(pupil.shape)] if pupil.shape else pupil


def _given(name: str, given: object) -> ObjectivePupil:
    """Return a pupil that was given, or rebuild it from its description."""
    pupil = ObjectivePupil.from_dict(given) if isinstance(given, dict) else given
    return cast("ObjectivePupil", validation.instance(name, pupil, ObjectivePupil))


def _fixed(pupil: ObjectivePupil) -> Dipole | None:
    """Return the dipole of a pupil, unless it turns freely."""
    emitter = pupil.emitter
    return emitter if isinstance(emitter, Dipole) and emitter.wobble < 1.0 else None


@dataclass(frozen=True)
class TwoPhoton(ProvenMethod):
    r"""Two-photon microscope: the squared excitation intensity; all emitted light is collected.

    The pupil is that of the excitation.

    Parameters
    ----------
    tol : float, default 1e-6
        Tolerance relative to the peak of each plane.

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

    def _pixels(self, pupil: ObjectivePupil, grid: Grid, asked: float, threads: int) -> Samples:
        """Return the square of the intensity at the centres of pixels."""
        once = light_samples(pupil, grid, asked, threads)
        return once.times(once)


@dataclass(frozen=True)
class Sted(Confocal):
    r"""Confocal microscope with stimulated emission depletion (STED).

    ``E(r) P(r) 2^(-s D(r))``: E and P as of :class:`lommel.methods.Confocal`, D the intensity of the depletion beam
    in the units of E. This holds for pulses that are short compared with the lifetime of the excited state; s D is
    the intensity relative to that which depletes half.

    Parameters
    ----------
    excitation, pinhole, tol
        As of :class:`lommel.methods.Confocal`.
    depletion : ObjectivePupil
        A rotationally symmetric beam that is dark on the axis: ``lm.Beam("vortex")``, in any planes.
    saturation : float
        s, at most 1e4; :func:`lommel.microscopy.sted` takes it relative to the maximum of the beam.

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or out of range.

    Notes
    -----
    ``exp(-2 a D)``, D between 0 and 1, differs by at most ``2 sum_(k > n) exp(-a) I_k(a)`` from its Chebyshev series
    of degree n, which has n times the bandwidth of D, so that it can be interpolated with a proven error. n grows
    like the square root of `saturation`, as does the resolution.

    References
    ----------
    S. W. Hell and J. Wichmann, Opt. Lett. 19, 780 (1994), doi:10.1364/OL.19.000780.
    B. Harke et al., Opt. Express 16, 4154 (2008), doi:10.1364/OE.16.004154: the exponential.
    """

    depletion: ObjectivePupil = field(kw_only=True)
    saturation: float = field(kw_only=True)

    def __post_init__(self) -> None:
        super().__post_init__()
        pupil = _given("depletion", self.depletion)
        if not pupil.light.radial:
            raise ValueError(f"depletion must not depend on the direction, got {pupil!r}")
        if self.excitation.magnification != pupil.magnification:
            raise ValueError(
                f"depletion must have the magnification of the excitation, {self.excitation.magnification:g}, "
                f"got {pupil.magnification:g}"
            )
        object.__setattr__(self, "depletion", _one_plane("depletion", pupil))
        saturation = validation.real("saturation", self.saturation, least=0.0, most=_SATURATION_MOST)
        object.__setattr__(self, "saturation", saturation)

    def unsupported(self, pupil: ObjectivePupil) -> str | None:
        """Return the reason where emitters do not turn freely, or a confocal microscope has one."""
        if _fixed(pupil):
            return f"supports emitters that turn freely only, got {pupil.emitter!r}"
        return super().unsupported(pupil)

    def stretch(self, pupil: ObjectivePupil) -> float:
        """Return the exponential type of a field whose square is as close to the product as it is to be."""
        return super().stretch(pupil) + self._degree * pupil.scale / self.depletion.scale

    def images(self, pupil: ObjectivePupil, grid: Grid, wanted: Wanted) -> Images:
        """Return the images of the flattened stack; see ``Method.images``."""
        if grid.integrate and self.along_radius(pupil) is None:
            raise ValueError("integrate must be False for a Sted whose light depends on the direction, got True")
        return super().images(pupil, grid, wanted)

    def _aberrated(self, pupil: ObjectivePupil) -> bool:
        """Return whether any of the light has aberrations."""
        return super()._aberrated(pupil) or self.depletion.aberrated

    def _depleting(self, pupil: ObjectivePupil) -> ObjectivePupil:
        """Return what depletes in the planes of the emission."""
        beam = self.depletion
        return replace(pupil, layers=beam.layers, emitter=beam.emitter, aberrations=beam.aberrations)

    def _pixels(self, pupil: ObjectivePupil, grid: Grid, asked: float, threads: int) -> Samples:
        """Return what is left of the product at the centres of pixels."""
        rate = math.log(2.0) * self.saturation
        excited = super()._pixels(pupil, grid, asked, threads)
        depleting = light_samples(self._depleting(pupil), grid, asked / max(1.0, rate), threads)
        left = np.exp(-rate * np.maximum(depleting.values, 0.0))
        return excited.times(Samples(left, rate * depleting.error))

    def _orders(self, pupil: ObjectivePupil, v: Array, asked: float) -> Orders:
        """Return what is left of the product at rising v, of the emission."""
        beam, slower = self.depletion, super().stretch(pupil)
        planes = self._depleting(pupil)
        rate, faster = math.log(2.0) * self.saturation, pupil.scale / beam.scale
        finer, ceiling = max(1.0, rate), self._ceiling(pupil)
        # Both are band-limited, and what is left of them is wanted at many more radii.
        means = disc_means(slower * v, 0.0, 0.1 * asked / ceiling, highest(self._lit(pupil)))
        known = super()._orders(pupil, means.places / slower, asked)
        excited = Orders(means.of(known.values), known.error * means.gain + ceiling * means.error)
        means = disc_means(faster * v, 0.0, 0.1 * asked / finer)
        known = light(planes, means.places, asked / finer, self.tol / finer)
        depleting = Orders(means.of(known.values), known.error * means.gain + means.error)
        left = np.exp(-rate * depleting.mean)
        # Twice the last: what is known is that far from the polynomial, and what is wanted as far.
        off = rate * depleting.error + 2.0 * _SHARE * self.tol
        return Orders(excited.values * left[:, None], excited.error + excited.most * off)

    @property
    def _degree(self) -> int:
        """That of the polynomial."""
        from scipy.special import ive

        a = 0.5 * math.log(2.0) * self.saturation
        # Beyond 40 terms more than the root of 80 a what is left is below 1e-17.
        k = np.arange(1, math.ceil(math.sqrt(80.0 * a)) + 41)
        beyond = 2.0 * np.cumsum(ive(k, a)[::-1])[::-1]  # of degrees below each
        return int(np.argmax(beyond <= _SHARE * self.tol))


def crest(pupil: ObjectivePupil) -> float:
    """Return the largest intensity of a radial beam, of those in all its planes, without the phase of the layers.

    Each plane wave keeps what interfaces and films transmit and how it fades with the depth, and loses the phase psi
    of :meth:`lommel.Objective.phase`. To 1e-6, as E of :class:`lommel.methods.Confocal` is normalised.
    """
    from scipy.special import jv

    model, depth, focus = pupil.light.model, pupil.depth.ravel(), pupil.focus.ravel()
    rule = debye.rule(pupil.layers, model, depth, focus, float(_COARSE[-1] + _FINE[-1]), 1e-10)
    waves = np.abs(rule.waves(depth, focus))

    def bright(v: Array) -> Array:
        arguments = np.multiply.outer(rule.rho, v)
        each = zip(pupil.light.shares, model.orders, rule.parts, strict=True)
        total = sum(share * np.abs((waves * part) @ jv(order, arguments)) ** 2 for share, order, part in each)
        return np.asarray((total / pupil.power[:, None]).max(axis=0))

    return float(bright(_COARSE[bright(_COARSE).argmax()] + _FINE).max())
