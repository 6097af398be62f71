r"""Images of radial pupils through isotropic blur, from the product of both transfer functions.

``e(v) = (8 / pi) int O(f) T(f) J0(2 f v) f df``, f over the cutoff, O the autocorrelation of the pupil function and T
the transfer function of the blur, which for seeing ends early: a few hundred nodes in place of a lattice as wide as
the halo. What is left out is bounded (docs/certificate.md, section 17).
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import lru_cache
from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.blur.blurs import Blur
from lommel.blur.fading import Fading
from lommel.blur.overlap_rule import ETAS, Part, Slopes, gauss_nodes, parts, rounding
from lommel.core.answers import Declined, Intensities, not_met
from lommel.methods.method import RadialMethod
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil
from lommel.special.legendre import gauss_legendre

_ARCS = 64  # that cover half of an ellipse
_PHASE = 40.0  # radians of J0 in a panel, about
_MANY_RADII = 1000
_AT_ONCE = 2**21
_TRIES = 6
_U = 2.0**-53
_ETAS = ETAS[(ETAS > 0.1) & (ETAS < 3.0)]


class Panel(NamedTuple):
    """Nodes of one part of the autocorrelation over a range of f, over the cutoff, and how many it takes itself."""

    part: Part
    f: Array
    weight: Array  # of (8 / pi) T f df
    counts: tuple[int, int]


class Rule(NamedTuple):
    """Panels, a bound on what they leave out, the frequency that they end at, and ``int T f df`` beyond."""

    panels: tuple[Panel, ...]
    error: float
    end: float
    left: float


@lru_cache(maxsize=16)
def rule(fading: Fading, of: tuple[Part, ...], slopes: Slopes, left: float, v: float, allowed: float) -> Rule:
    """Return the rule for radii up to `v` that leaves out `allowed`, ending where ``int T f df`` is `left`."""
    end, left = fading.end(left)
    if any(part.kind == "disc" and part.end < end for part in of):
        raise Declined("an obscuration has no proven rule where blur ends beyond (1 - obscuration) / 2 of the cutoff")
    share, panels, error = allowed / len(of), [], 0.0
    own = 0.25 * share * math.pi / (8.0 * fading.light)
    turning = v + 2.0 * float(slopes.at(np.zeros(1))[0][0])
    for part in of:
        edges, missing = _edges(part, min(end, part.end), turning, 0.1 * share)
        error += missing
        for f, weight, low, high in _panels(fading, part, slopes, edges, v, 0.65 * share):
            panels.append(Panel(part, f, weight, part.counts(slopes, low, high, own)))
    return Rule(tuple(panels), error + 0.9 * allowed, end, left)


def _edges(part: Part, end: float, turning: float, allowed: float) -> tuple[Array, float]:
    """Return the edges of panels in f, and a bound on what is beyond the last."""
    missing = 0.0
    close = end > 0.7 * part.end and part.kind == "lens"
    if close and end > part.end * (
        1.0 - (least := 2.0 ** math.floor(0.4 * math.log2(allowed / 15.0 / part.radius**4)))
    ):
        # A lens is below 4 sqrt(2) a^2 (1 - f / a)^(3/2).
        end, missing = part.end * (1.0 - least), 32.0 * math.sqrt(2.0) / math.pi * part.radius**4 * least**2.5
    edges = np.linspace(0.0, end, max(2, math.ceil(end * 2.0 * turning / _PHASE)) + 1)
    if close:
        # Panels end no nearer to the singularity than they are long.
        finer = part.end * (1.0 - 0.5 ** np.arange(0.0, 60.0))
        edges = np.unique(np.concatenate([edges, finer[(finer > 0.0) & (finer < end)]]))
    return edges, missing


def _panels(
    fading: Fading, part: Part, slopes: Slopes, edges: Array, v: float, allowed: float
) -> Iterator[tuple[Array, Array, float, float]]:
    """Yield nodes, weights and ends of panels that together err by at most `allowed`."""
    end = float(edges[-1])
    ends = np.cbrt(edges / end)
    wide = np.diff(ends)
    # Points of half of each ellipse, and discs around them that cover it: (panels, ellipses, points).
    angle = math.pi / _ARCS * (np.arange(_ARCS) + 0.5)
    half, eta = 0.5 * wide[:, None, None], _ETAS[:, None]
    middle: NDArray[np.complex128] = (ends[:-1, None, None] + half).astype(np.complex128)
    x = middle + half * np.cosh(eta + 1j * angle)
    radius = np.broadcast_to(half * np.cosh(eta) * (0.5 * math.pi / _ARCS), x.shape)
    size = np.abs(x)
    f, around = end * x**3, end * ((size + radius) ** 3 - size**3)
    far = edges[1:, None, None]
    off = np.abs(f - np.clip(f.real, 0.0, far)) + around
    with np.errstate(over="ignore", invalid="ignore"):
        log = fading.log_bound(x, radius, end) + part.log_bound(slopes, far, off)
        log += 2.0 * v * (np.abs(f.imag) + around) + np.log(24.0 / math.pi * end**2 * (size + radius) ** 5)
    log = np.where(np.isnan(log), np.inf, log).max(axis=-1)
    counts = gauss_nodes(log, allowed / len(wide) / wide, _ETAS)
    for k, count in enumerate(counts.astype(int)):
        at, weight = gauss_legendre(int(count), float(ends[k]), float(ends[k + 1]))
        f_at = end * at**3
        yield f_at, 24.0 / math.pi * end**2 * at**5 * weight * fading.at(f_at), float(edges[k]), float(edges[k + 1])


class Summed(NamedTuple):
    """A sum of ``terms J0(2 f v)`` for a flattened stack, valid for radii v up to `far`."""

    f: Array
    terms: Array  # (n, len(f))
    far: float
    allowed: float
    error: float  # bound on what the rule leaves out below its end
    left: float  # int T f df beyond it
    rounded: float  # bound on the relative rounding of terms

    @classmethod
    def of(cls, made: Rule, pupil: Pupil, far: float, allowed: float) -> Summed:
        """Return that of a stack by a rule."""
        f = np.concatenate([panel.f for panel in made.panels])
        terms = [panel.part.at(pupil, panel.f, panel.counts) * panel.weight for panel in made.panels]
        own = max(rounding(pupil, math.prod(panel.counts)) for panel in made.panels)
        return cls(f, np.concatenate(terms, axis=1), far, allowed, made.error, made.left, own)

    @property
    def size(self) -> float:
        """What the moduli of the terms add up to at most."""
        return float(np.abs(self.terms).sum(axis=1).max())

    def rounding(self, v: float) -> float:
        """Bound what rounding adds to a sum up to v, over :attr:`size`."""
        return self.rounded + _U * (self.f.size + 60.0 + 4.0 * float(self.f.max()) * v)

    def at(self, v: Array) -> Array:
        """Return the sums at radii v, shape ``(n, len(v))``."""
        values = np.empty((len(self.terms), v.size))
        many = max(1, _AT_ONCE // self.f.size)
        for start in range(0, v.size, many):
            some = slice(start, start + many)
            values[:, some] = self.terms @ scipy.special.j0(np.multiply.outer(2.0 * self.f, v[some]))
        return values


@dataclass(frozen=True)
class TransferIntegral(RadialMethod[Pupil]):
    """Blurred images of radial pupils by quadrature over the product of transfer functions, to `tol` of the peak."""

    tol: float = 1e-6
    blur: tuple[Blur, ...] = ()
    # The last sum of each pupil, which further radii of the same image are taken from.
    kept: dict[int, tuple[Pupil, Summed]] = field(default_factory=dict, init=True, repr=False, compare=False)

    apodized = True

    def fading(self, pupil: Pupil) -> Fading:
        """Return the blur in the light of a pupil; Declined where it depends on the direction."""
        found = Fading.of(self.blur, pupil.scale, pupil.wavelength)
        if found is None:
            raise Declined("blur depends on the direction")
        return found

    def _ceiling(self, pupil: Pupil) -> float:
        """Return what the image is nowhere brighter than."""
        # What is summed exceeds the image by its error.
        return (1.0 + 2.0 * self.tol) * min(pupil.amplitude**2, 8.0 * pupil.transmission * self.fading(pupil).light)

    def _likely_peak(self, pupil: Pupil) -> float:
        """Estimate the lowest peak: that of light spread over the areas of both."""
        light = pupil.transmission
        return light / (light / pupil.likely_peak + 1.0 / (8.0 * self.fading(pupil).light))

    def stretch(self, pupil: Pupil) -> float:
        """Return the bandwidth of the image over that of the optics."""
        end, _ = self.fading(pupil).end(self._left(pupil))
        return end

    def seconds(self, pupil: Pupil, grid: Grid) -> float:
        """Estimate the time of images on a `grid`."""
        end, (gradient, second, _) = self.stretch(pupil), Slopes.of(pupil).at(np.zeros(1))
        panels = max(2.0, end * (grid.reach(pupil) + 2.0 * float(gradient[0])) / 20.0) + (12.0 if end > 0.7 else 0.0)
        nodes = (3.0 + 1.2 * min(end, 0.5) * (1.0 - min(end, 0.5)) * second[0]) * (8.0 + 0.6 * end * second[0])
        radii = min(grid.height * grid.width / 8.0, _MANY_RADII)
        sums = 6e-8 * float(nodes) * math.prod(pupil.shape) + 3e-8 * radii
        return 2e-3 + panels * (4e-4 + 25.0 * sums)

    def _left(self, pupil: Pupil) -> float:
        return 0.02 * self.tol * self._likely_peak(pupil) / (8.0 * pupil.transmission)

    def intensity(self, pupil: Pupil, grid: Grid, threads: int = 0) -> Intensities:
        """Return the image at the distinct radii of `grid`, or on its pixels where these are none, or very many."""
        if not grid.symmetric or grid.radii.size > _MANY_RADII:
            return self.on_pixels(pupil, grid, threads)
        made = self.profile(pupil, grid.v(pupil))
        # Light is nowhere negative, and no value less exact for that.
        return made._replace(values=np.maximum(made.values, 0.0))

    def profile(self, pupil: Pupil, v: Array) -> Intensities:
        """Return the image at rising v for the flattened stack, with a bound on its error over its peak."""
        fading = self.fading(pupil)
        allowed = 0.12 * self.tol * self._likely_peak(pupil)
        # The peak may lie beside the radii that are asked for.
        near = np.linspace(0.0, float(pupil.v(pupil.geometric_radius()).max()) + 4.0, 9)
        places = np.concatenate([v, near])
        far = float(places.max())
        for _ in range(_TRIES):
            summed = self._summed(pupil, fading, far, 2.0 ** math.floor(math.log2(allowed)))
            values, size = summed.at(places), summed.size
            left_out = pupil.left_out[0] + 2.0 * pupil.left_out[1]
            # No autocorrelation exceeds that at 0.
            off = summed.error + 8.0 * pupil.transmission * summed.left
            off += size * (left_out * (2.0 + left_out) + summed.rounding(far))
            peak = values.max(axis=1) - off
            relative = np.divide(off, peak, out=np.full(peak.shape, np.inf), where=peak > 0.0)
            if relative.max() <= self.tol:
                break
            allowed *= 0.5 * max(self.tol / float(relative.max()), 1e-4)
        else:
            raise not_met(self.tol, float(relative.max()), "the peak")
        return Intensities(values[:, : v.size], relative, peak)

    def _summed(self, pupil: Pupil, fading: Fading, far: float, allowed: float) -> Summed:
        """Return the sum over frequencies for radii up to `far` that leaves out at most `allowed`."""
        of, kept = self.kept.get(id(pupil), (None, None))
        left = fading.end(self._left(pupil))[1]
        if kept is not None and of is pupil and kept.far >= far and kept.allowed <= allowed and kept.left == left:
            return kept
        made = rule(fading, tuple(parts(pupil)), Slopes.of(pupil), self._left(pupil), far, allowed)
        found = Summed.of(made, pupil, far, allowed)
        self.kept[id(pupil)] = pupil, found
        return found
