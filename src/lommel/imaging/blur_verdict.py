"""Blur of a photograph by its likelihood: a verdict on a stated blur, and an estimate of an unknown one."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import NamedTuple, Self

import numpy as np
import scipy

from lommel.base.arrays import Array
from lommel.estimation.focal_model import Spectrum, pupil_curve
from lommel.imaging.blur_spectrum import FREQUENCIES, BlurSpectrum
from lommel.imaging.edge_spread import sharper_edges
from lommel.imaging.motion import Motion, likely_motion
from lommel.measures.transfer import otf
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront

# Factors of the defocus; the first is as stated.
_SCALES = 1.0, 0.3, 0.45, 0.6, 0.7, 0.8, 0.9, 0.95, 1.05, 1.1, 1.2, 1.35
_SPHERICAL = -1.0, -0.5, 0.5, 1.0  # waves of spherical aberration that are compared if another defocus is likelier
# Exponents of textures behind the stated blur, below which a gain of _FLAT_GAIN is a doubt, and below which the
# restoration has more fine detail than scenes.
_FLAT, _FLAT_GAIN, _WHITE = 1.75, 3.0, 1.25
_WEAK_GAIN = 2.0  # gain of a wider blur from which a weak one is no doubt
# Variation is compared in windows (pixels) with more of it than this share of them; gain from which edges ring, where
# their profiles do not or do agree with the stated blur, and from which they agree with a likelier blur.
_EDGE_WINDOW, _EDGES, _RINGS, _SHARPER = 7, 0.9, (0.7, 0.8), 0.4
_OF_EDGES = [_SCALES.index(0.3), _SCALES.index(0.6), 0]  # blurs to which profiles of edges are compared
# Evidence of the profiles of edges from which they are sharper than behind the stated blur, and as soft.
_SHARP_EDGES, _SOFT_EDGES = 2.5, -6.0
_SHARPENED = 3.0  # gain in log-likelihood from which a photograph counts as sharpened
_MIN_GAIN = 6.0  # gain in log-likelihood from which another blur is preferred
_NYQUIST = 0.5  # cycles per pixel
_LOBES, _NODES = 12.0, 72  # OTFs with spherical aberration have _NODES frequencies up to _LOBES / diameter
_TOL = 1e-4  # of these values
_TINY = 1e-12
_DIAMETERS = np.geomspace(0.6, 40.0, 105)  # pixels, from which an unknown blur is estimated
_LARGEST = 0.25  # largest of them / shorter side of the photograph
_PARTS = 6  # of a stack of blurs, each with as many frequencies as its largest blur needs
_REFINED = np.linspace(-0.08, 0.08, 17)  # of ln(diameter), around the most likely of the diameters
_ERROR_FACTOR = 1.3  # standard error of ln(diameter) / that of the likelihood
_SOFTNESS = 1.4  # softness of scenes, pixels: an error of the diameter, added in quadrature
_MOST_ERROR = 0.08  # largest standard error of ln(diameter) of a known blur
_VALLEY = 4.5  # log-likelihood by which another diameter must be less likely
_BEYOND = 3.0  # standard errors by which it must differ
# The same where scenes may be soft: what softness gains less _CHANCE_GAIN, and at most _SOFT_GAIN, from which a scene
# is soft.
_CHANCE_GAIN, _SOFT_GAIN = 3.0, 10.0
# Exponents of textures that are neither patterns nor soft scenes; others need light beyond the first zero of a blur,
# by a gain in log-likelihood above _LOBE_GAIN.
_NATURAL, _LOBE_GAIN = (1.5, 2.75), 3.5


Blurs = Callable[[Array], Array]
"""Transfer functions at FREQUENCIES by a parameter of a blur, such as defocus: (blurs) -> (blurs, frequencies)."""


def is_sharpened(sharpening: float) -> bool:
    """Return True if the gain of an unsharp mask shows that a photograph was sharpened, or has more noise."""
    return sharpening > _SHARPENED


class BlurVerdict(NamedTuple):
    """The most likely of the blurs that were compared with the stated one.

    `factor` multiplies the defocus, or the size of a measured PSF, `waves` are those of spherical aberration, `gain`
    is that in log-likelihood, and `sharpness` the power that the blur transmits, divided by that of the stated blur.
    `sharpening` is the gain of an unsharp mask over these blurs. `noise` is the most likely variance of the noise
    above the stated one, by the stated blur, and `noise_gain` its gain. Of a mask and noise the less likely
    explanation has a gain of 0. `slope` is the exponent of the texture behind the stated blur. A photograph that was
    moved has its `motion`. A `weak` blur has no zeros at the frequencies of pixels: its `edges` are the gain of the
    total variation at strong edges by restoration, over that of the height of a thin line, and its `profiles` the
    evidence of those of edges for less blur.
    """

    factor: float
    waves: float
    gain: float
    sharpness: float
    sharpening: float
    noise: float
    noise_gain: float
    slope: float
    weak: bool = False
    motion: Motion | None = None
    edges: float = 0.0
    profiles: float = 0.0

    @property
    def doubtful(self) -> bool:
        """True if the photograph is sharper than stated: its restoration may be farther from the scene than it is.

        Or if it was moved. The fall of a texture looks like a blur without zeros: of a weak blur edges must agree.
        """
        return self.motion is not None or (self.sharper and not (self.weak and self.edges <= _SHARPER))

    @property
    def as_stated(self) -> bool:
        """True if a blur with zeros is about the likeliest, and leaves no more fine detail than scenes have."""
        unlikely = self.doubtful or self.softer or self.noisier or is_sharpened(self.sharpening)
        return not (unlikely or self.weak) and self.slope >= _WHITE

    @property
    def sharper(self) -> bool:
        """True if the texture agrees better with a sharper blur."""
        return self.gain > (_FLAT_GAIN if self.slope < _FLAT else _MIN_GAIN) and self.sharpness > 1.0

    @property
    def flat(self) -> bool:
        """True if a weak blur leaves more fine detail than most scenes have: the photograph may be sharper."""
        softer = self.gain > _WEAK_GAIN and self.sharpness < 1.0
        return self.weak and self.slope <= _FLAT and not softer and not self.doubtful

    @property
    def soft_edges(self) -> bool:
        """True if steps in the photograph are as soft as a weak blur makes them."""
        return self.profiles < _SOFT_EDGES

    @property
    def ringing(self) -> bool:
        """True if edges are sharper than behind a weak blur, or its restoration makes them ring.

        Blur keeps the total variation of a monotonic edge, and restoration therefore does not raise it.
        """
        sharp = self.profiles > _SHARP_EDGES or self.edges > _RINGS[self.soft_edges]
        return self.weak and not self.doubtful and sharp

    @property
    def implausible(self) -> bool:
        """True if any share of the result may harm: of weak blurs, or with more fine detail than scenes have."""
        if self.motion is not None or not self.doubtful:
            return False
        return self.weak or self.slope < _WHITE or self.gain <= _MIN_GAIN

    @property
    def softer(self) -> bool:
        """True if the photograph, or its scene, is softer than stated."""
        return self.gain > _MIN_GAIN and self.sharpness < 1.0 and self.motion is None

    @property
    def noisier(self) -> bool:
        """True if the photograph has a floor that no texture behind the stated blur has: more noise than stated."""
        return self.noise_gain > _MIN_GAIN and not self.doubtful

    @property
    def bound(self) -> str:
        """Words where the factor is the smallest or the largest that was compared."""
        return {min(_SCALES): " or less", max(_SCALES): " or more"}.get(self.factor, "")

    def applied(self, pupil: Pupil, defocus: float) -> Pupil:
        """Return the preferred pupil, given the stated one and its defocus C_d (rad)."""
        return changed(pupil, (self.factor - 1.0) * defocus, self.waves)


def compare_blurs(
    curves_of: Blurs, spherical: Callable[[Array], Array] | None, plane: Array, variance: Array, restored: Array
) -> BlurVerdict:
    """Compare the stated blur of one channel of a photograph with others.

    `curves_of` returns transfer functions at FREQUENCIES by factors of the size, and `spherical` those by waves of
    spherical aberration. `variance` is the stated noise variance of each pixel of the `plane`, and `restored` its
    restoration by the stated blur.
    """
    factors = np.array(_SCALES)
    curves = curves_of(factors)
    waves = np.zeros_like(factors)
    rings = BlurSpectrum.windowed(plane[None], variance[None])
    texture = rings.texture(curves[0], 0)
    noise = texture.noise
    likelihood = rings.likelihood(curves, 0, noise)
    weak = bool(curves[0][FREQUENCIES < _NYQUIST].min() > 0.0)
    # The texture behind a weak blur looks like a sharpened one.
    sharpening = 0.0 if weak else rings.sharpening(curves[[0, int(np.argmax(likelihood))]], 0, noise)
    if spherical is not None and likelihood.max() - likelihood[0] > _MIN_GAIN:
        # Spherical aberration takes more time: it is compared where the stated blur is not the best one.
        factors, waves = np.append(factors, np.ones(len(_SPHERICAL))), np.append(waves, _SPHERICAL)
        curves = np.concatenate([curves, spherical(np.array(_SPHERICAL))])
        likelihood = rings.likelihood(curves, 0, noise)
    best = int(np.argmax(likelihood))
    power = np.square(curves[:, : len(FREQUENCIES) // 3]).sum(axis=1)
    gain = float(likelihood[best] - likelihood[0])
    sharpness = float(power[best] / power[0])
    more, noise_gain, beyond = rings.more_noise(curves[0], 0, noise)
    if is_sharpened(sharpening) and sharpening > beyond:
        noise_gain = 0.0  # an unsharp mask explains the noise, and better
    elif noise_gain > _MIN_GAIN:
        sharpening = 0.0
    return BlurVerdict(
        float(factors[best]), float(waves[best]), gain, sharpness, sharpening, more, noise_gain, texture.slope,
        weak, likely_motion(curves, plane, variance), _edge_gain(curves[0], plane, restored) if weak else 0.0,
        sharper_edges(curves[_OF_EDGES], plane, variance) if weak else 0.0,
    )  # fmt: skip


def _edge_gain(curve: Array, plane: Array, restored: Array) -> float:
    """Return the gain in total variation where a `plane` has most of it, by its restoration.

    It is in units of the gain in height of the thinnest line, of which the transfer `curve` leaves less.
    """
    if min(plane.shape) <= 2 * _EDGE_WINDOW:
        return 0.0

    def variation(values: Array) -> Array:
        sums = [
            scipy.ndimage.uniform_filter(np.abs(np.diff(values, axis=axis, append=0.0)), _EDGE_WINDOW)
            for axis in (0, 1)
        ]
        inside = slice(_EDGE_WINDOW, -_EDGE_WINDOW)
        return np.asarray(np.hypot(*sums)[inside, inside])

    before, after = variation(plane), variation(restored)
    strong = before >= max(float(np.quantile(before, _EDGES)), _TINY)
    # Of a step or line, blur and pixels leave at most this between neighbouring pixels.
    left = 2.0 * float(np.trapezoid(curve * np.sinc(FREQUENCIES) ** 2, FREQUENCIES)) + 2.0 * FREQUENCIES[0]
    gains = after[strong] / before[strong] - 1.0
    return float(np.median(gains) / max(1.0 / left - 1.0, _TOL)) if strong.any() else 0.0


class BlurEstimate(NamedTuple):
    """Most likely blur: its parameter, the relative standard error of it, and the diameter of the blur (pixels).

    `known` is False if the error is too large or another diameter is about as likely; `sign_known` is False if the
    parameter of the other sign has the same blur. `sharpening` is the gain in log-likelihood of an unsharp mask.
    """

    value: float
    error: float
    diameter: float
    known: bool
    sign_known: bool
    sharpening: float


def defocused(focused: Pupil, spectrum: Spectrum, pixel: float) -> Blurs:
    """Return the transfer functions of a pupil by its defocus C_d (rad), given the pupil without it."""
    computed: dict[bytes, Array] = {}  # parts of a photograph have the same stacks

    def curves_of(stack: Array) -> Array:
        if (key := stack.tobytes()) not in computed:
            parts = [pupil_curve(changed(focused, q, 0.0), spectrum, pixel) for q in np.array_split(stack, _PARTS)]
            computed[key] = np.concatenate([part(FREQUENCIES) for part in parts])
        return computed[key]

    return curves_of


def estimate_blur(curves_of: Blurs, symmetric: bool, unit: float, plane: Array, variance: Array) -> BlurEstimate:
    """Return the most likely blur of one channel of a photograph.

    `curves_of` returns transfer functions at FREQUENCIES by a parameter, `symmetric` states that its sign does not
    change them, and `unit` is the diameter of the blur in pixels for the parameter 1.
    """
    size = _DIAMETERS[_LARGEST * min(plane.shape) >= _DIAMETERS] / unit
    stack = size if symmetric else np.concatenate([-size[::-1], size])
    rings = BlurSpectrum.windowed(plane[None], variance[None])
    curves = curves_of(stack)
    plain, with_soft, slopes = rings.soft_likelihood(curves, 0)
    softness = float(with_soft.max() - plain.max())
    soft = softness > _SOFT_GAIN
    summit, soft_summit = (_Summit.of(stack * unit, each) for each in (with_soft if soft else plain, with_soft))
    best = summit.place
    sharpening = rings.sharpening(curves[[best]], 0, 1.0)
    if math.isinf(summit.error):
        return BlurEstimate(float(stack[best]), math.inf, abs(float(stack[best])) * unit, False, False, sharpening)
    # The likelihood falls more steeply towards larger blurs.
    fine = curves_of(stack[best] * np.exp(_REFINED))
    likelihoods = rings.soft_likelihood(fine, 0)[1] if soft else rings.likelihood(fine, 0, 1.0)
    top = int(np.argmax(likelihoods))
    near = slice(max(top - 4, 0), top + 5)
    value = float(stack[best]) * math.exp(_REFINED[top] + _peak(_REFINED[near] - _REFINED[top], likelihoods[near])[1])
    alone = summit.valley > _VALLEY and soft_summit.valley > min(softness - _CHANCE_GAIN, _SOFT_GAIN)
    # Without light beyond the first zero, a disc looks like the Gaussian of a soft scene, and its texture is steep.
    dark = np.logical_or.accumulate(curves[best] <= 0.0)
    lobes = rings.soft_likelihood(np.stack([curves[best], np.where(dark, 0.0, curves[best])]), 0)[1]
    distinct = _NATURAL[0] <= slopes[best] <= _NATURAL[1] or float(lobes[0] - lobes[1]) > _LOBE_GAIN
    opposite = np.sign(stack) != np.sign(value)
    likelihood = with_soft if soft else plain
    sign_known = not symmetric and bool(likelihood[opposite].max() < likelihood[best] - _VALLEY)
    known = alone and bool(distinct) and summit.error < _MOST_ERROR
    return BlurEstimate(value, summit.error, abs(value) * unit, known, sign_known, sharpening)


class _Summit(NamedTuple):
    """Highest likelihood of blurs: its place, standard error (inf at an end), and the valley around it."""

    place: int
    error: float
    valley: float

    @classmethod
    def of(cls, diameters: Array, likelihood: Array) -> Self:
        """Return the summit by ln of signed diameters; one of the other sign of defocus is no valley."""
        best, x = int(np.argmax(likelihood)), np.log(np.abs(diameters))
        side = np.flatnonzero(np.sign(diameters) == np.sign(diameters[best]))
        near = side[np.abs(side - best) <= 2]
        curvature, shift, height = _peak(x[near] - x[best], likelihood[near])
        if curvature <= 0.0 or best in (side[0], side[-1]):
            return cls(best, math.inf, 0.0)
        error = math.hypot(
            _ERROR_FACTOR / math.sqrt(2.0 * curvature), 0.5 * (_SOFTNESS / diameters[best] * math.exp(-shift)) ** 2
        )
        # Other valleys are farther than the error; the other sign has another blur if there is spherical aberration.
        other = np.abs(x - x[best] - shift) > max(_BEYOND * error, _MOST_ERROR)
        return cls(best, error, height - float(likelihood[other].max(initial=-math.inf)))


def _peak(x: Array, likelihood: Array) -> tuple[float, float, float]:
    """Return half of minus the second derivative of a log-likelihood, its maximum near x = 0, and its value there."""
    curvature, slope, least = np.polyfit(x, -likelihood, 2)
    if curvature <= 0.0:
        return float(curvature), 0.0, float(likelihood.max())
    shift = float(np.clip(-slope / (2.0 * curvature), -0.1, 0.1))
    return float(curvature), shift, -float(least + shift * (slope + shift * curvature))


def changed(pupil: Pupil, defocus: float | Array, waves: float | Array) -> Pupil:
    """Return a pupil, or a stack, with more defocus (rad) and spherical aberration (waves)."""
    change = Wavefront(defocus=defocus, spherical=2.0 * math.pi * np.asarray(waves)) if np.any(waves) else None
    return replace(pupil, wavefront=pupil.wavefront + (change or Wavefront(defocus=defocus)))


def aberrated_curves(pupil: Pupil, spectrum: Spectrum, pixel: float, waves: Array) -> Array:
    """Return the OTFs with spherical aberration at FREQUENCIES; frequencies beyond some lobes do not matter."""
    aberrated = changed(pupil, 0.0, waves)
    diameter = 2.0 * float(aberrated.geometric_radius().max()) / pixel
    f = np.linspace(0.0, min(FREQUENCIES[-1], _LOBES / max(diameter, 1e-9)), _NODES)
    wavelength = float(np.average([w for w, _ in spectrum], weights=[s for _, s in spectrum]))
    values = otf(aberrated.in_light(wavelength), f / pixel, tol=_TOL).real
    curve = scipy.interpolate.CubicSpline(f, values, axis=1)(np.minimum(FREQUENCIES, f[-1]))
    return np.where(f[-1] >= FREQUENCIES, curve, 0.0)
