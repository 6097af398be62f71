"""Energy in the window, encircled and ensquared energy, and centroids."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import NamedTuple, cast

import numpy as np
import scipy
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Numbers, numbers
from lommel.measures import aperture_means
from lommel.measures.continuous_image import CUT_ERROR, KERNEL_NORM, CartesianImage, Image, ImageModel, energy_images
from lommel.measures.psf_like import PSFLike, checked
from lommel.methods.choice import candidates, of_profiles
from lommel.methods.method import Method, RadialMethod, require_period
from lommel.optics.base_pupil import BasePupil
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil
from lommel.optics.pupil import checked as checked_pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.special import zernike
from lommel.special.legendre import gauss_panels


def encircled_energy(psf: PSFLike, radius: ArrayLike, *, about: str = "axis", of: str = "image") -> Numbers:
    """Return the encircled energy, the fraction of all light within `radius` of the axis or of the centroid.

    Parameters
    ----------
    psf : PSF
    radius : array_like
        Radius, >= 0, metres if the pupil has a wavelength, else units of lambda*N. The circle may exceed the window.
    about : {"axis", "centroid"}, default "axis"
        Centre of the circle. The centroid is :func:`image_centroid`, or the axis for a radially symmetric PSF.
    of : {"image", "optics"}, default "image"
        "image": optics, blur and, if values are pixel-integrated, the pixel; "optics": optics and blur only.

    Returns
    -------
    float or ndarray, shape ``pupil.shape + radius.shape``
        Fraction of all light, independent of pixel pitch and window. For radially symmetric lenses the error is at
        most 1e-9 with blur or pixels, else the tolerance of the method. For other lenses the error is at most
        ``2e-8 + 4 A e``, where A is the area of the circle and e the error bound of the light per area
        (`error_bound` times the peak). The actual error is far smaller, since this bound assumes errors of equal sign
        everywhere. With :class:`lommel.Seeing` the error is at most about 1e-5 for every aperture and radius.

    Raises
    ------
    TypeError, ValueError
        If a radius is negative or not finite; if it is too large for a pupil that is not radially symmetric (the
        limit is about 700 lambda*N minus the extent of the blur, and none with seeing); if the circle extends beyond
        half of the period of a sampled image (:class:`lommel.Mask`, :class:`lommel.methods.MatrixFourier`); or if
        `about` or `of` has an unknown value.
    """
    model, radii = ImageModel.of(psf, of), validation.real_array("radius", radius, least=0.0, unit=psf.pupil.unit)
    centers = energy_centers(psf, about) / psf.pupil.scale
    if model.radial_method is not None:
        return radial_energy(model.radial_method, psf.pupil, radii)

    def light_within(image: Image, radii: Array, center: Array) -> Array:
        return image.circles(radii, (float(center[0]), float(center[1])))

    return _light_within(model, "radius", radii, centers, np.hypot(*centers.T), light_within)


def ensquared_energy(psf: PSFLike, half_width: ArrayLike, *, about: str = "axis", of: str = "image") -> Numbers:
    """Return the ensquared energy: the fraction of all light within a square of side ``2 half_width``.

    Parameters
    ----------
    psf : PSF
    half_width : array_like
        Half of the side, >= 0, metres if the pupil has a wavelength, else units of lambda*N.
    about : {"axis", "centroid"}, default "axis"
    of : {"image", "optics"}, default "image"
        As in :func:`lommel.measures.energy.encircled_energy`.

    Returns
    -------
    float or ndarray, shape ``pupil.shape + half_width.shape``
        Fraction of all light; its error is that of :func:`lommel.measures.energy.encircled_energy`.

    Raises
    ------
    TypeError, ValueError
        On the conditions of :func:`lommel.measures.energy.encircled_energy`, with `half_width` in place of `radius`.
    """
    model = ImageModel.of(psf, of)
    half_widths = validation.real_array("half_width", half_width, least=0.0, unit=psf.pupil.unit)
    centers = energy_centers(psf, about) / psf.pupil.scale
    if model.radial_method is not None:
        return radial_square_energy(model.radial_method, psf.pupil, half_widths)

    def light_within(image: Image, half_widths: Array, center: Array) -> list[float]:
        x, y = center
        return [image.rectangle((x - a, y - a), (x + a, y + a)) for a in half_widths]

    return _light_within(model, "half_width", half_widths, centers, np.abs(centers), light_within)


def _light_within(
    model: ImageModel, name: str, sizes: Array, centers: Array, offsets: Array, light_within: Callable[..., object]
) -> Numbers:
    """Return ``light_within(image, sizes, center)`` for each image of a stack, shape ``pupil.shape + sizes.shape``.

    `sizes` are in the unit of the pupil. `centers` (n, 2), their `offsets` from the axis, and the arguments of
    `light_within` are in units of lambda*N.
    """
    pupil, lengths = model.pupil, sizes.ravel() / model.pupil.scale
    reach = float(lengths.max(initial=0.0)) + float(offsets.max(initial=0.0))
    validation.reach(f"{name}={sizes.max(initial=0.0):g}", math.pi * reach, pupil.scale, pupil.unit)
    pairs = zip(energy_images(model, reach, name), centers, strict=True)
    return numbers([light_within(image, lengths, center) for image, center in pairs], pupil.shape + sizes.shape)


def image_centroid(psf: PSFLike) -> Array:
    """Return the centroid of all light, (x, y) from the axis.

    For lenses the centroid is computed from the wavefront (:func:`lommel.centroid`), over all wavelengths of the PSF;
    blur and pixels do not change it. For an Objective it is the centroid of the values, :func:`window_centroid`.

    Parameters
    ----------
    psf : PSF

    Returns
    -------
    ndarray, shape ``pupil.shape + (2,)``
        Position in metres or units of lambda*N; for lenses exact up to rounding.

    Raises
    ------
    ValueError
        If no light of an Objective falls into the window.
    """
    checked(psf)
    if not isinstance(psf.pupil, Pupil):
        return window_centroid(psf)
    parts = psf.method.components(psf.pupil)
    # The centroids of the components (wavelengths) are averaged with their light as weights.
    total = sum(part.share * aperture_means.centroid(part.pupil) for part in parts)
    return np.asarray(total / sum(part.share for part in parts))


def window_centroid(psf: PSFLike) -> Array:
    """Return the centroid of the values in the window, (x, y) from the axis: a sum over pixels.

    It differs from :func:`image_centroid`, the centroid of all light, as it omits the light outside the window. The
    difference decreases slowly, like the reciprocal of the size of the window.

    Parameters
    ----------
    psf : PSF

    Returns
    -------
    ndarray, shape ``pupil.shape + (2,)``
        Position in metres or units of lambda*N.

    Raises
    ------
    ValueError
        If no light falls into the window.
    """
    checked(psf)
    light = energy_per_pixel(psf)
    total = light.sum(axis=(-2, -1))
    if not np.all(total > 0):
        raise ValueError("psf must have light in the window to have a centroid, got a sum of values of 0")
    x, y = (light.sum(axis=-2) * psf.grid.x).sum(axis=-1), (light.sum(axis=-1) * psf.grid.y).sum(axis=-1)
    return np.stack([x / total, y / total], axis=-1)


def energy_centers(psf: PSFLike, about: str) -> Array:
    """Return the position (x, y) of the axis or of the centroid for each PSF of the flattened stack, shape (n, 2)."""
    validation.choice("about", about, ("axis", "centroid"))
    # The centroid of a radially symmetric image is the axis.
    if about == "axis" or all(part.pupil.radial for part in psf.method.components(psf.pupil)):
        return np.zeros((math.prod(psf.pupil.shape), 2))
    return image_centroid(psf).reshape(-1, 2)


def require_radial(method: RadialMethod, pupil: BasePupil) -> None:
    """Raise ValueError if a pupil is not radially symmetric or if the method does not support it."""
    if not pupil.radial:
        raise ValueError(
            "pupil must be radially symmetric, got a wavefront or an aperture that depends on the direction"
        )
    method.require(pupil)


def radial_energy(method: RadialMethod, pupil: BasePupil, radius: ArrayLike) -> Numbers:
    """Return the fraction of all light within `radius`, ``int_0^v I v dv / (2 tau)``, by quadrature.

    v is the radius in optical units (pi at lambda*N), and tau the transmission of the pupil, ``1 - eps^2`` for an
    annulus with the obscuration eps.

    Parameters
    ----------
    method : RadialMethod
    pupil : Pupil
        A radially symmetric pupil.
    radius : array_like
        Radius, metres if the pupil has a wavelength, else units of lambda*N; >= 0.

    Returns
    -------
    float or ndarray, shape ``pupil.shape + radius.shape``
        Fraction of all light; its error is at most the tolerance of the method.

    Raises
    ------
    TypeError, ValueError
        If the method is not radial or does not support the pupil, or if a radius is negative or not finite.
    """
    validation.instance("method", method, RadialMethod)
    radii = validation.real_array("radius", radius, least=0.0)
    method.require(pupil)
    if radii.size == 0:
        return np.zeros(pupil.shape + radii.shape)
    # v refers to the reference wavelength; at the shortest wavelength I oscillates faster by the factor `stretch`.
    stretch = method.stretch(pupil)
    edges, index = np.unique(_v_within_reach(pupil, "radius", radii, stretch), return_inverse=True)
    # A node on the axis, with weight 0, because the error of a profile is relative to its largest value.
    nodes, weights, counts = [np.zeros(1)], [np.zeros(1)], []
    for low, high in zip(np.append(0.0, edges), edges, strict=False):
        # I v is of exponential type 2 * stretch: with this number of nodes the accuracy is spectral.
        x, w = gauss_panels(math.ceil(0.6 * stretch * (high - low)) + 24, low, high)
        nodes.append(x)
        weights.append(w * x)
        counts.append(x.size)
    intensity = method.profile(pupil, np.concatenate(nodes)).values
    # Panels end at the radii, so that one cumulative sum includes the integrals to all radii.
    integrals = np.cumsum(intensity * np.concatenate(weights), axis=1)
    # E = int I v dv / (2 tau), because the integral of I over the plane, int I 2 pi v dv, is 4 pi tau.
    return numbers(integrals[:, np.cumsum(counts)[index]] / (2.0 * pupil.transmission), pupil.shape + radii.shape)


def radial_square_energy(method: RadialMethod, pupil: BasePupil, half_width: Array) -> Numbers:
    """Return the fraction of all light of a radial pupil within squares about the axis, by quadrature."""
    half_sides = _v_within_reach(pupil, "half_width", half_width, method.stretch(pupil)).tolist()
    fractions = [_light_in_rectangles(method, pupil, [(4.0, a, a)]) for a in half_sides]
    return numbers(np.transpose(fractions), pupil.shape + half_width.shape)


def _v_within_reach(pupil: BasePupil, name: str, distance: Array, stretch: float) -> Array:
    """Return distances from the axis as values of v, flattened; ValueError if a distance is too large."""
    edge = float(distance.max(initial=0.0))
    validation.reach(f"{name}={edge:g}", stretch * (math.pi / pupil.scale * edge), pupil.scale / stretch, pupil.unit)
    return pupil.v(distance).ravel()


def window_energy(psf: PSFLike) -> Numbers:
    """Return the fraction of all light that falls on the window, for any fill factor of its pixels.

    Parameters
    ----------
    psf : PSF

    Returns
    -------
    float or ndarray, shape ``pupil.shape``
        Fraction of all light; its error is that of :func:`lommel.measures.energy.encircled_energy`. For
        pixel-integrated values with a fill factor of 1 it is the sum of the values.

    Raises
    ------
    ValueError
        If the window exceeds the limits of the radius in :func:`lommel.measures.energy.encircled_energy`.
    """
    checked(psf)
    pupil, grid = psf.pupil, psf.grid
    radial = psf.radial_method
    require_period(psf.method.period(pupil), pupil, grid, edges=True)
    if radial is None and grid.integrate and not grid.partly:
        return numbers(energy_per_pixel(psf).sum(axis=(-2, -1)), pupil.shape)
    if grid.stack:
        return numbers([window_energy(psf[index]) for index in np.ndindex(pupil.shape)], pupil.shape)
    half_y, half_x = (0.5 * side for side in grid.pitch)
    left, right, top, bottom = (
        float(end) for end in (grid.x[0] - half_x, grid.x[-1] + half_x, grid.y[0] - half_y, grid.y[-1] + half_y)
    )
    if radial is None:
        low, high = np.array([left, top]) / pupil.scale, np.array([right, bottom]) / pupil.scale
        # A window with an even number of pixels is off-centre: one of its sides may exceed half the period of a
        # sampled image by half a pixel.
        reach = min(float(np.abs([low, high]).max()), 0.5 * psf.method.period(pupil))
        images = energy_images(ImageModel.of(psf, "optics"), reach, "the window")
        return numbers([image.rectangle((low[0], low[1]), (high[0], high[1])) for image in images], pupil.shape)
    step = math.pi / pupil.scale
    # The window as a signed sum of rectangles with one corner on the axis.
    corners = [
        (float(np.sign(a) * np.sign(b)), abs(a) * step, abs(b) * step) for a in (right, -left) for b in (bottom, -top)
    ]
    return numbers(_light_in_rectangles(radial, pupil, corners), pupil.shape)


def _light_in_rectangles(
    method: RadialMethod, pupil: BasePupil, rectangles: list[tuple[float, float, float]]
) -> Array:
    """Return the weighted sum of the fractions of light in rectangles, for each pupil of the stack, shape (n,).

    A rectangle (weight, a, b) extends from the axis to the corner (a, b) in units of v.
    """
    nodes, weights = [np.zeros(1)], [np.zeros(1)]
    for weight, a, b in rectangles:
        if a > 1e-150 and b > 1e-150:  # smaller sides hold no light, and a / v or b / v could overflow
            v, w = _quadrant_rule(a, b, method.stretch(pupil))
            nodes.append(v)
            weights.append(weight * w)
    v, w = np.concatenate(nodes), np.concatenate(weights)
    order = np.argsort(v)
    intensity = method.profile(pupil, v[order]).values
    return np.asarray(intensity @ w[order] / (4.0 * math.pi * pupil.transmission))


def _quadrant_rule(a: float, b: float, stretch: float) -> tuple[Array, Array]:
    """Return nodes v and weights to integrate a radial function of type ``2 stretch`` over [0, a] x [0, b]."""
    shorter, longer = min(a, b), max(a, b)
    # Three ranges of radii: full quarter circles, arcs cut by the nearer side, and arcs cut by both sides.
    pieces = [(0.0, shorter), (shorter, longer), (longer, math.hypot(a, b))]
    nodes, weights = [], []
    for low, high in pieces:
        # The length of the arc has a square-root singularity at v = low, which v = low + (high - low) s^2 removes.
        s, w = gauss_panels(math.ceil(1.2 * stretch * (high - low)) + 24)
        v = low + (high - low) * s * s
        # Angle of the arc of radius v within the rectangle, radians.
        arc = np.arcsin(np.minimum(1.0, b / v)) - np.arccos(np.minimum(1.0, a / v))
        nodes.append(v)
        weights.append(2.0 * (high - low) * s * w * v * np.maximum(arc, 0.0))
    return np.concatenate(nodes), np.concatenate(weights)


def energy_per_pixel(psf: PSFLike) -> Array:
    """Return the values as fractions of all light per pixel, whatever the normalisation of the PSF."""
    # Values are `scale` times I, and the integral of I over the plane in v is 4 pi times the transmission.
    factor = psf.grid.cell(psf.pupil) / (4.0 * math.pi * psf.pupil.transmission)
    return np.asarray(psf.values * (factor / psf.scale)[..., None, None], dtype=np.float64)


MAX_RADIUS = 250.0
"""Largest radius in :func:`encircled` for pupils that are not radially symmetric, lambda*N."""


class Encircled(NamedTuple):
    """Encircled energy about the axis.

    Attributes
    ----------
    fraction : ndarray
        Fraction of all light within each radius.
    error : float or None
        Error bound of the fractions; None if the method has no error bound or if the pupil is radially symmetric.
    """

    fraction: NDArray[np.float64]
    error: float | None


def encircled(pupil: Pupil, radius: ArrayLike, *, method: Method | None = None) -> Encircled:
    """Return the encircled energy about the axis for a single pupil, without pixel and blur.

    Parameters
    ----------
    pupil : Pupil
        A single pupil.
    radius : array_like, shape (n,)
        Radius, metres if the pupil has a wavelength, else units of lambda*N; at most 250 lambda*N unless the pupil is
        radially symmetric.
    method : Method, optional
        Method that computes the image; by default the one that :func:`lommel.psf` uses. Ignored for a radially
        symmetric pupil.

    Returns
    -------
    Encircled
        The error bound is ``2e-8 + 3.94 A e``, with the area A of the largest circle and the error bound e of the
        light per area: at most a few times 1e-4 for a radius of 10 lambda*N and a tolerance of 1e-6. The actual error
        is mostly far smaller.

    Raises
    ------
    TypeError, ValueError
        If a radius is not finite or out of range, or if the pupil is a stack.
    """
    radii = np.atleast_1d(validation.real_array("radius", radius, least=0.0))
    if method is not None:
        validation.instance("method", method, Method)
    if checked_pupil(pupil).shape != ():
        raise ValueError(f"pupil must be a single one, got a stack of shape {pupil.shape}")
    if pupil.radial:
        return Encircled(np.atleast_1d(radial_energy(of_profiles(), pupil, radii)), None)
    reach = radii / pupil.scale
    if reach.size and reach.max() > MAX_RADIUS:
        raise ValueError(
            f"radius must be at most {MAX_RADIUS:g} lambda*N for a pupil that is not radially symmetric, "
            f"got {reach.max():.6g} lambda*N"
        )
    if method is not None:
        method.require(pupil)
    (image,) = energy_images(optics(pupil, method), float(reach.max(initial=0.0)), "radius")
    # In the worst case the errors of all samples have the same sign (docs/certificate.md, "From samples").
    area = math.pi * float(reach.max(initial=0.0)) ** 2
    has_bound = isinstance(image, CartesianImage) and not math.isnan(image.error)
    error = CUT_ERROR + KERNEL_NORM * area * cast("CartesianImage", image).error if has_bound else None
    return Encircled(image.circles(reach), error)


def optics(pupil: Pupil, method: Method | None = None) -> ImageModel:
    """Return the model of an image without pixel and blur, with `method` or the default method."""
    return ImageModel(pupil, method or candidates(pupil, Grid(3, 0.25 * pupil.scale))[-1])


__all__ = ["MAX_RADIUS", "Encircled", "encircled", "optics"]


def best_focus(pupil: Pupil, radius: float) -> float:
    """Return the defocus C_d (radians) that, added to `pupil`, maximises the encircled energy within `radius`.

    Parameters
    ----------
    pupil : Pupil
        A single pupil.
    radius : float
        Radius above 0, metres if the pupil has a wavelength, else units of lambda*N.

    Returns
    -------
    float
        Defocus coefficient C_d, radians.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, or if the pupil is a stack or not radially symmetric.

    Notes
    -----
    The function scans defocus in steps of half a radian over the range in which some zone of the pupil is in focus,
    extended by 6 rad at both ends. Brent's method refines the maximum of the scan to 1e-6 rad.
    """
    valid_radius = validation.real("radius", radius, above=0.0, unit=checked_pupil(pupil).unit)
    if checked_pupil(pupil).shape != ():
        raise ValueError(f"pupil must be a single one, got a stack of shape {pupil.shape}")
    method = of_profiles()
    require_radial(method, pupil)
    # A zone of the pupil is in focus if the slope dPhi/d(rho^2) of its phase and the slope 2 C_d of the added defocus
    # cancel.
    t = np.linspace(pupil.obscuration**2, 1.0, 257)
    slope = 2.0 * zernike.legendre_slope(pupil.radial_terms()[0], 2.0 * t - 1.0)
    low, high = -0.5 * slope.max() - 6.0, -0.5 * slope.min() + 6.0
    scan = np.linspace(low, high, math.ceil(2.0 * (high - low)) + 1)

    def energy(defocus: ArrayLike) -> NDArray[np.float64]:
        defocused = replace(pupil, wavefront=pupil.wavefront + Wavefront(defocus), geometry=None)
        return np.asarray(radial_energy(method, defocused, valid_radius))

    start = float(scan[np.argmax(energy(scan))])
    bounds, options = (start - 0.5, start + 0.5), {"xatol": 1e-6}
    search = scipy.optimize.minimize_scalar
    return float(search(lambda c: -float(energy(c)), bounds=bounds, method="bounded", options=options).x)
