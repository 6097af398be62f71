"""STED microscopes: fluorescence excited by one beam and depleted around the axis by a second."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.core.answers import Images, Wanted
from lommel.methods.layers.disc_means import disc_means
from lommel.methods.layers.orders import Orders, highest, light
from lommel.methods.layers.scanning import Confocal, _fixed
from lommel.optics.grid import Grid
from lommel.optics.layers import debye
from lommel.optics.layers.objective_pupil import ObjectivePupil

_MOST = 1e4
_SHARE = 0.02  # of the tolerance: what a polynomial may differ from the exponential by
_COARSE, _FINE = np.linspace(0.1, 8.0, 80), np.linspace(-0.1, 0.1, 101)  # v, where the crest is looked for


@dataclass(frozen=True)
class Sted(Confocal):
    r"""A confocal microscope with a second beam that depletes by stimulated emission what the first has excited.

    ``E(r) P(r) 2^(-s D(r))``: E and P as of :class:`lommel.methods.Confocal`, and D of the depletion what E is of the
    excitation. So light is left of a pulse that is short beside the time in
    which emitters fall back, and s D is its intensity over that which leaves half.

    Parameters
    ----------
    excitation, pinhole, tol
        As of :class:`lommel.methods.Confocal`.
    depletion : ObjectivePupil
        A beam that does not depend on the direction, dark on the axis: ``lm.Beam("vortex")``; whatever its planes.
    saturation : float
        s, at most 1e4; :func:`lommel.microscopy.sted` takes it over the crest of the beam.

    Raises
    ------
    TypeError, ValueError
        If one of them is none of these.

    Notes
    -----
    The exponential of ``-2 a D``, D between 0 and 1, is within ``2 sum_(k > n) exp(-a) I_k(a)`` of a polynomial of
    the degree n, its Chebyshev series, and that polynomial has n times the frequencies of D: so many that what lies
    between values is known from these, with that as a part of the error. n grows like the root of `saturation`, as
    does the sharpness of the spot.

    References
    ----------
    S. W. Hell and J. Wichmann, Opt. Lett. 19, 780 (1994), doi:10.1364/OL.19.000780.
    B. Harke et al., Opt. Express 16, 4154 (2008), doi:10.1364/OE.16.004154: the exponential.
    """

    depletion: ObjectivePupil = field(kw_only=True)
    saturation: float = field(kw_only=True)

    def __post_init__(self) -> None:
        super().__post_init__()
        given = self.depletion
        pupil = ObjectivePupil.from_dict(given) if isinstance(given, dict) else given
        validation.instance("depletion", pupil, ObjectivePupil)
        if not pupil.radial:
            raise ValueError(f"depletion must not depend on the direction, got {pupil!r}")
        if pupil.magnification != self.excitation.magnification:
            raise ValueError(
                f"depletion must have the magnification of the excitation, {self.excitation.magnification:g}, "
                f"got {pupil.magnification:g}"
            )
        object.__setattr__(self, "depletion", pupil[(0,) * len(pupil.shape)])
        s = validation.real("saturation", self.saturation, least=0.0)
        if s > _MOST:
            raise ValueError(f"saturation must be at most {_MOST:g}, got {s:g}")
        object.__setattr__(self, "saturation", s)

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
            raise ValueError("integrate must be False for a Sted whose excitation depends on the direction, got True")
        return super().images(pupil, grid, wanted)

    def _orders(self, pupil: ObjectivePupil, v: Array, asked: float) -> Orders:
        """Return what is left of the product at rising v, of the emission."""
        beam, slower = self.depletion, super().stretch(pupil)
        planes = replace(pupil, layers=beam.layers, emitter=beam.emitter)
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
