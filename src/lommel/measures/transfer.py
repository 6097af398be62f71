"""Optical transfer function (OTF) of pupils and PSFs, and its modulus (MTF), phase (PTF) and focus tolerance.

The OTF is the normalized Fourier transform of the PSF, ``OTF(f) = int I(r) exp(-2 pi i f.r) dr / int I dr``. It is
computed as the autocorrelation of the pupil function (overlap.py).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import TypedDict

import numpy as np
import scipy
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Numbers, numbers
from lommel.base.quantities import in_unit
from lommel.blur.blurs import Blur, blurs, frequencies, require_unit
from lommel.measures.continuous_image import ImageModel, sampled_transfer
from lommel.measures.overlap import autocorrelation
from lommel.measures.psf_like import Measurable, PSFLike
from lommel.methods.polychromatic import Polychromatic
from lommel.optics.base_pupil import BasePupil
from lommel.optics.colour.spectrum import Component
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil, checked
from lommel.optics.wavefront.wavefront import Wavefront

Complexes = np.complex128 | NDArray[np.complex128]

Pitch = float | tuple[float, float]
"""Pixel pitch: one number, or height and width."""
_NEAR_ONE = 0.99


class Sensor(TypedDict, total=False):
    """Options of :func:`otf` that describe pixels, blur and light."""

    pixel: Pitch | None
    fill: Pitch
    blur: tuple[Blur, ...]
    spectrum: Polychromatic | None


def otf(
    pupil: Pupil | Measurable,
    fx: ArrayLike,
    fy: ArrayLike = 0.0,
    *,
    pixel: float | tuple[float, float] | None = None,
    fill: float | tuple[float, float] = 1.0,
    blur: Blur | Sequence[Blur] = (),
    spectrum: Polychromatic | None = None,
    tol: float = 1e-10,
) -> Complexes:
    """Return the optical transfer function (OTF) of a pupil, or of the image of a PSF.

    Parameters
    ----------
    pupil : Pupil, PSF, ColourPSF or PSFGrid
        A PSF includes its pixels (if pixel-integrated), blur and spectrum.
    fx, fy : array_like
        Spatial frequencies in x and y, cycles per metre if the pupil has a wavelength, else cycles per lambda*N. The
        arrays broadcast: ``fx[None, :], fy[:, None]`` is a lattice of frequencies.
    pixel : float or (float, float), optional
        Pixel pitch, or (height, width). The OTF is multiplied by the transfer function of pixel integration,
        ``sinc(fx width) sinc(fy height)`` for pixels without gaps.
    fill : float or (float, float), default 1
        Fill factor of the pixel, as a fraction of its area or of (height, width); see :func:`lommel.psf`.
    blur : Blur or sequence of Blur, default ()
        Additional blur, such as motion or seeing, whose transfer functions multiply the OTF; see :func:`lommel.psf`.
    spectrum : Polychromatic, optional
        Spectrum over which the OTF is summed, with equal optical path differences at all wavelengths.
    tol : float, default 1e-10
        Absolute tolerance, at least 1e-13 and below 0.1. For circular and annular apertures quadrature nodes are
        added until two successive results agree within `tol`, which is no proof. For other apertures the error is
        proven to be at most `tol` plus rounding, and each frequency takes a few milliseconds. Ignored for apertures
        with a mask.

    Returns
    -------
    complex or complex ndarray, shape ``pupil.shape + s``
        OTF at each frequency; s is the shape to which `fx` and `fy` broadcast. The OTF is 1 at frequency 0, and 0
        from ``pupil.cutoff`` on. A shift of the image by (a, b) multiplies it by ``exp(-2 pi i (fx a + fy b))``.

        With a mask the aperture consists of square cells of constant amplitude and phase. The OTF is then exact up to
        rounding, and extends beyond the cutoff if cells extend beyond the rim. At multiples of ``cutoff / side`` it
        is also the OTF of one period of the sampled image (:class:`lommel.Mask`).

        For a PSF of an Objective or by the method `Geometric`, the OTF is computed from samples of the image, up to
        64 lambda*N beyond the blur. Its error is up to 1e-3 below a fifth of the cutoff, and up to 1e-4 above.

    Raises
    ------
    TypeError, ValueError
        If an argument is not real and finite, or out of range; if the frequencies do not broadcast; or if pixel,
        fill, blur or spectrum is given with a PSF, which includes these.
    ToleranceError
        If `tol` needs more than 4096 nodes along a line of a circular or annular aperture.

    Examples
    --------
    >>> import lommel as lm
    >>> round(float(abs(lm.otf(lm.Pupil(), 0.5))), 6)
    0.391002
    """
    tolerance = validation.real("tol", tol, least=1e-13, below=0.1)
    if isinstance(pupil, Measurable):
        _require_default(pixel=pixel is not None, fill=fill != 1.0, blur=blur != (), spectrum=spectrum is not None)
        return pupil.apply(lambda psf: image_otf(psf, fx, fy, tol=tol))
    checked(pupil)
    x_f, y_f = frequencies(fx, fy, pupil.unit)
    pixel_transfer, blurs_used = _pixel_transfer(pupil, x_f, y_f, pixel, fill), blurs(blur)
    require_unit(blurs_used, pupil)
    total = np.zeros((math.prod(pupil.shape), x_f.size), dtype=np.complex128)
    parts = [Component(1.0, 1.0, pupil)]
    if spectrum is not None:
        parts = validation.instance("spectrum", spectrum, Polychromatic).components(pupil)
    for weight, _, part in parts:
        # Frequencies in units of 1 / (lambda N) at the wavelength of the component.
        f = np.stack([x_f.ravel(), y_f.ravel()], axis=-1) * part.scale
        # The transfer function of seeing depends on the wavelength of the component.
        factors = [kernel.transfer(x_f, y_f, wavelength=part.wavelength) for kernel in blurs_used]
        total += (
            weight * autocorrelation(part, f, tolerance) * np.prod([np.ravel(factor) for factor in factors], axis=0)
        )
    result: Complexes = (total.reshape(pupil.shape + x_f.shape) * pixel_transfer)[()]
    _tell_low(pupil, x_f, y_f, result)
    return result


def image_otf(
    psf: PSFLike, fx: ArrayLike, fy: ArrayLike = 0.0, *, of: str = "image", tol: float = 1e-10
) -> Complexes:
    """Return the optical transfer function of the continuous image that the values of a PSF sample.

    Parameters
    ----------
    psf : PSF
    fx, fy : array_like
        As in :func:`lommel.otf`. Frequencies may exceed the Nyquist frequency of the pixels.
    of : {"image", "optics"}, default "image"
        "image": with the transfer function of the pixel if values are pixel-integrated; "optics": without it.
    tol : float, default 1e-10
        As in :func:`lommel.otf`.

    Returns
    -------
    complex or complex ndarray, shape ``psf.pupil.shape + s``
        See :func:`lommel.otf`.

    Raises
    ------
    TypeError, ValueError
        If the frequencies are not finite or do not broadcast, or if `of` is unknown.
    ToleranceError
        As in :func:`lommel.otf`.
    """
    pupil, grid, method = psf.pupil, psf.grid, psf.method
    averaged = validation.choice("of", of, ("image", "optics")) == "image" and grid.integrate
    if isinstance(pupil, Pupil) and method.sampling == "center":
        pixels = {"pixel": grid.pixel, "fill": grid.fill} if averaged else {}
        spectrum = method if isinstance(method, Polychromatic) else None
        return otf(pupil, fx, fy, **pixels, blur=psf.blur, spectrum=spectrum, tol=tol)
    x_f, y_f = frequencies(fx, fy, pupil.unit)
    scaled = x_f.ravel() * pupil.scale, y_f.ravel() * pupil.scale
    result: Complexes = sampled_transfer(ImageModel.of(psf, of), *scaled).reshape(pupil.shape + x_f.shape)[()]
    _tell_low(pupil, x_f, y_f, result)
    return result


def _tell_low(pupil: BasePupil, fx: Array, fy: Array, values: Complexes) -> None:
    """Tell that frequencies are probably per millimetre: far below the cutoff, and with an OTF near 1."""
    highest = float(np.hypot(fx, fy).max(initial=0.0))
    # In cycles per millimetre numbers of frequencies are below a thousandth of the cutoff in cycles per metre.
    if pupil.unit == "m" and 0.0 < highest < 1e-3 * pupil.cutoff and np.abs(values).min(initial=1.0) > _NEAR_ONE:
        validation.tell(
            f"frequencies are in cycles per metre: {highest:g} is {highest / pupil.cutoff:.1g} of the cutoff, where "
            f"the MTF is near 1; for {highest:g} cycles/mm give {highest:g}e3"
        )


def _pixel_transfer(pupil: Pupil, x_f: Array, y_f: Array, pixel: Pitch | None, fill: Pitch) -> Array:
    """Return the transfer function of pixel integration; 1 without pixels."""
    if pixel is None:
        if validation.fill("fill", fill) != (1.0, 1.0):
            raise ValueError(f"fill must be omitted without pixel=, which it modifies, got {validation.shown(fill)}")
        return np.ones(x_f.shape)
    pixel = in_unit("pixel", pixel, pupil.unit)
    metric, sensor = pupil.wavelength is not None, Grid(1, pixel, integrate=True, fill=fill)
    for side in sensor.pitch:
        validation.pixel(side, metric=metric)
    height, width = sensor.active
    return np.asarray(np.sinc(x_f * width) * np.sinc(y_f * height))


def disc_transfer(diameter: float | Array, f: Array) -> Array:
    """Return the transfer function of a uniform disc, ``2 J1(x) / x`` with ``x = pi * diameter * f``."""
    x = np.maximum(math.pi * diameter * f, 1e-6)
    return np.asarray(2.0 * scipy.special.j1(x) / x)


def mtf(
    pupil: Pupil | Measurable,
    fx: ArrayLike,
    fy: ArrayLike = 0.0,
    *,
    pixel: float | tuple[float, float] | None = None,
    fill: float | tuple[float, float] = 1.0,
    blur: Blur | Sequence[Blur] = (),
    spectrum: Polychromatic | None = None,
    tol: float = 1e-10,
) -> Numbers:
    """Return the modulation transfer function ``abs(OTF)``; see :func:`lommel.otf`.

    Parameters
    ----------
    pupil : Pupil, PSF, ColourPSF or PSFGrid
    fx, fy : array_like
        Spatial frequencies, cycles per metre if the pupil has a wavelength, else cycles per lambda*N.
    pixel, fill, blur, spectrum, tol
        As in :func:`lommel.otf`.

    Returns
    -------
    float or ndarray, shape ``pupil.shape + s``
        MTF, 0 to 1; s is the shape to which `fx` and `fy` broadcast.

    Examples
    --------
    >>> import lommel as lm
    >>> camera = lm.Pupil(lm.Wavefront(1.5), wavelength=550e-9, f_number=2.8)
    >>> at_nyquist = lm.mtf(camera, 1 / (2 * 3.45e-6), pixel=3.45e-6)
    """
    value = otf(pupil, fx, fy, pixel=pixel, fill=fill, blur=blur, spectrum=spectrum, tol=tol)
    return numbers(np.abs(value), value.shape)


def ptf(pupil: Pupil | Measurable, fx: ArrayLike, fy: ArrayLike = 0.0) -> Numbers:
    """Return the phase transfer function, the argument of the OTF in radians, above -pi and up to pi.

    The error of the phase is about ``1e-10 / MTF``. If the MTF is at most 1e-10, the phase is undefined and the
    result is 0. See :func:`lommel.otf`.

    Parameters
    ----------
    pupil : Pupil, PSF, ColourPSF or PSFGrid
    fx, fy : array_like
        Spatial frequencies, cycles per metre if the pupil has a wavelength, else cycles per lambda*N.

    Returns
    -------
    float or ndarray, shape ``pupil.shape + s``
        Phase in radians; s is the shape to which `fx` and `fy` broadcast.
    """
    value = otf(pupil, fx, fy)
    return numbers(np.where(np.abs(value) > 1e-10, np.angle(value), 0.0), value.shape)


def mtf_frequency(
    pupil: Pupil | Measurable,
    level: float = 0.5,
    *,
    angle: float = 0.0,
    pixel: float | tuple[float, float] | None = None,
    fill: float | tuple[float, float] = 1.0,
    blur: Blur | Sequence[Blur] = (),
) -> Numbers:
    """Return the lowest frequency at which the MTF falls to a level, for example MTF50.

    Parameters
    ----------
    pupil : Pupil, PSF, ColourPSF or PSFGrid
        A PSF of a lens includes its pixels (if pixel-integrated), blur and spectrum.
    level : float, default 0.5
        Level of the MTF, above 0 and below 1.
    angle : float, default 0
        Direction of the frequency, radians from x (increasing columns) to y (increasing rows).
    pixel, fill, blur
        As in :func:`lommel.otf`.

    Returns
    -------
    float or ndarray, shape ``pupil.shape``
        Frequency in cycles per metre or cycles per lambda*N. A scan in steps of at most ``cutoff / 128`` brackets the
        first crossing, and a root search refines it to ``1e-10 cutoff``. The steps are smaller for masks and for
        large defocus or motion blur, whose MTF oscillates.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.
    """
    threshold = validation.real("level", level, above=0.0, below=1.0)
    direction = validation.angle("angle", angle)
    if isinstance(pupil, Measurable):
        _require_default(pixel=pixel is not None, fill=fill != 1.0, blur=blur != ())

        def of_image(single: PSFLike) -> Numbers:
            sensor: Sensor = {"blur": single.blur}
            if single.grid.integrate:
                sensor |= {"pixel": single.grid.pixel, "fill": single.grid.fill}
            if isinstance(single.method, Polychromatic):
                sensor["spectrum"] = single.method
            return _first_crossing(checked(single.pupil), threshold, direction, sensor)

        return pupil.apply(of_image)
    return _first_crossing(checked(pupil), threshold, direction, {"pixel": pixel, "fill": fill, "blur": blurs(blur)})


def focus_tolerance(
    pupil: Pupil,
    frequency: float,
    *,
    least: float = 0.3,
    pixel: float | tuple[float, float] | None = None,
) -> tuple[float, float]:
    """Return the focus tolerance, the largest sensor displacements in both directions that keep an MTF acceptable.

    Parameters
    ----------
    pupil : Pupil
        A single pupil, with a wavelength.
    frequency : float
        Spatial frequency on the sensor, cycles per metre, along x and along y; the lower MTF is used.
    least : float, default 0.3
        Smallest acceptable MTF, above 0 and below 1.
    pixel : float or (float, float), optional
        As in :func:`lommel.otf`.

    Returns
    -------
    (float, float)
        Displacements in metres at which the MTF along x or y first falls to `least`: a negative one (towards the
        lens) and a positive one. Their errors are at most ``1e-4 lambda N^2``, where N is the working f-number. A
        displacement has the defocus coefficient ``C_d = -pi displacement / (8 lambda N^2)`` (paraxial, first order).

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, or if the MTF without displacement is below `least`.

    Examples
    --------
    >>> import lommel as lm
    >>> lens = lm.Lens(focal_length=50e-3, f_number=2.8, focus_distance=2.0, wavelength=550e-9)
    >>> near, far = lm.focus_tolerance(lens.pupil(), 72e3, pixel=3.45e-6)  # half of the Nyquist frequency
    >>> f"{1e6 * near:.1f} um to {1e6 * far:.1f} um"
    '-36.5 um to 36.5 um'
    """
    return displacements(pupil, frequency, least, {"pixel": pixel})


def displacements(pupil: Pupil, frequency: float, least: float, sensor: Sensor) -> tuple[float, float]:
    """Return the displacements of :func:`focus_tolerance` for a sensor."""
    f = validation.real("frequency", frequency, above=0.0, unit="1/metres")
    threshold = validation.real("least", least, above=0.0, below=1.0)
    wavelength, number = checked(pupil).wavelength, pupil.f_number
    if wavelength is None or number is None or pupil.shape:
        raise ValueError(f"pupil must be a single one with a wavelength and an f-number, got {pupil!r}")
    metres_per_radian = -8.0 * wavelength * number**2 / math.pi  # displacement per defocus coefficient C_d

    def margin_at(c: ArrayLike) -> Array:
        displaced = replace(pupil, wavefront=pupil.wavefront + Wavefront.of_defocus(np.asarray(c)), geometry=None)
        values = np.asarray(mtf(displaced, np.array([f, 0.0]), np.array([0.0, f]), **sensor, tol=1e-8))
        return np.asarray(values.min(axis=-1) - threshold)

    if (margin := float(margin_at(0.0))) < 0.0:
        raise ValueError(
            f"least must be at most the MTF without displacement, {margin + threshold:.3g}, got {threshold:g}; use a "
            "smaller least or frequency"
        )
    # C_d is scanned in steps that are a fraction of the defocus at which the MTF at this frequency first vanishes.
    fraction = min(f / pupil.cutoff, 0.5)
    step = 0.1 / (fraction * (1.0 - fraction))
    ends = []
    for side in (1.0, -1.0):  # towards the lens first
        for start in range(0, 4096, 8):
            c = side * step * np.arange(start, start + 9)
            is_below = margin_at(c[1:]) <= 0.0
            if is_below.any():
                k = int(is_below.argmax())
                # An error of 1e-5 rad in C_d is 2.5e-5 lambda N^2 in the displacement.
                end = scipy.optimize.brentq(lambda x: float(margin_at(x)), c[k], c[k + 1], xtol=1e-5)
                ends.append(metres_per_radian * float(end))
                break
        else:
            raise ValueError(f"least must be an MTF that defocus reaches, got {threshold:g}; use a larger value")
    return ends[0], ends[1]


def _require_default(**options: bool) -> None:
    """Raise ValueError if the caller passed an option (True) with a PSF, which already includes it."""
    if redundant := [name for name, is_passed in options.items() if is_passed]:
        raise ValueError(f"{redundant[0]} must be left out for a PSF, which includes it; or pass psf.pupil instead")


def _first_crossing(pupil: Pupil, threshold: float, angle: float, sensor: Sensor) -> Numbers:
    """Return the lowest frequency at which the MTF falls to `threshold`; see :func:`mtf_frequency`."""
    cos, sin = math.cos(angle), math.sin(angle)
    cutoff = pupil.cutoff
    if spectrum := sensor.get("spectrum"):
        cutoff *= spectrum.stretch(pupil)
    # Steps must resolve the zeros of the OTF: of J1(2 pi r f) for a blur circle of radius r, and multiples of 1 / d
    # for motion blur of length d.
    oscillation = float(pupil.v(pupil.geometric_radius()).max())
    oscillation += 4.0 * sum(math.hypot(*b.streak) for b in sensor["blur"]) / pupil.scale
    steps = math.ceil(max(128.0, 2.0 * oscillation, 0.0 if pupil.mask is None else min(pupil.mask.side, 1024)))
    crossing = np.zeros(math.prod(pupil.shape), dtype=np.int64)
    # For circular apertures several frequencies are computed together, so that larger blocks are faster.
    block = 32 if pupil.circular else 4
    for start in range(1, steps + 1, block):
        k = np.arange(start, min(start + block, steps + 1))
        f = k * (cutoff / steps)
        is_below = np.asarray(mtf(pupil, f * cos, f * sin, **sensor, tol=1e-8)).reshape(-1, k.size) <= threshold
        crossing = np.where((crossing == 0) & is_below.any(axis=1), k[is_below.argmax(axis=1)], crossing)
        if crossing.all():
            break
    pupils = replace(pupil, wavefront=pupil.wavefront.flattened(), geometry=None)
    results = np.empty(crossing.size)
    for i, k_high in enumerate(crossing):

        def margin_at(f: float, single: Pupil = pupils[i]) -> float:
            return float(mtf(single, f * cos, f * sin, **sensor)) - threshold

        low, high = (float(k) * (cutoff / steps) for k in (k_high - 1, k_high))
        # The scan has a larger tolerance than the root search, so that the bracket may contain no crossing.
        ends = margin_at(low), margin_at(high)
        if ends[0] <= 0.0 or ends[1] >= 0.0:
            results[i] = low if ends[0] <= 0.0 else high
        else:
            results[i] = scipy.optimize.brentq(margin_at, low, high, xtol=1e-10 * cutoff)
    return numbers(results, pupil.shape)
