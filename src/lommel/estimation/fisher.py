"""Fisher information of images and the Cramér-Rao bound, computed from the derivatives of the PSFs."""

from __future__ import annotations

import math
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import Self

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array, Numbers, numbers
from lommel.base.units import format_length
from lommel.core.answers import ToleranceError
from lommel.methods.derivative_names import Name
from lommel.methods.derivative_names import checked as checked_names
from lommel.optics.base_pupil import BasePupil, imaged
from lommel.psf import PSF, Plan
from lommel.recorded.noise import Noise


@dataclass(frozen=True, eq=False, repr=False)
class Information:
    """Fisher information of images about parameters, and the Cramér-Rao bound that follows from it.

    No unbiased estimate from these images has a standard error below :attr:`errors`; maximum likelihood estimates
    approach this bound with enough light. Rows and columns of the matrices are in the order of `names`.

    Attributes
    ----------
    names : tuple
        Names of the parameters, as in `of`; parameters of single images are numbered: ``"photons[0]"``.
    units : dict of name to str
        Units of the parameters: "rad", "m", "pixels", "electrons", "electrons/pixel", or "" if dimensionless.
    matrix : ndarray, shape ``stack + (k, k)``
        Fisher information of k parameters, for each of a stack of scenes.
    covariance : ndarray, shape ``stack + (k, k)``
        Inverse of `matrix`, the bound on the covariance of estimates. Diagonal elements of unidentifiable parameters
        are infinite. An off-diagonal element is infinite if only a combination of its two parameters is identifiable.
    correlation : ndarray, shape ``stack + (k, k)``
        The covariance divided by both standard errors; its limit for unidentifiable parameters.
    """

    names: tuple[Name, ...]
    units: dict[Name, str]
    matrix: Array
    covariance: Array
    correlation: Array

    @classmethod
    def of_root(cls, names: tuple[Name, ...], units: dict[Name, str], root: Array, error: Array) -> Self:
        """Return the Fisher information for a given Jacobian of independent data.

        Parameters
        ----------
        names, units
            Attributes `names` and `units` of the result.
        root : ndarray, shape ``stack + (rows, k)``, rows >= k
            Derivatives of the data divided by their standard deviations, or any other array R for which ``R^T R`` is
            the information matrix.
        error : ndarray, shape ``stack + (k,)``
            Bound on the Euclidean norm of the error of each column of `root`.

        Returns
        -------
        Information

        Notes
        -----
        Each column of `root` is divided by its Euclidean norm, and so is the bound on its error, which becomes r. A
        column whose norm is at most the bound on its error is set to 0. Let v be a right singular vector of the
        scaled root, with the singular value s. If ``s <= sum(abs(v) r)``, errors of the derivatives may account for
        s, and v is an undetermined direction.

        The errors of the derivatives also rotate these directions. A unit vector n in the null space of the exact
        root satisfies ``norm(root n) <= norm(r)``: its component along directions of singular values of at least s is
        at most ``norm(r) / s``. A parameter is unidentifiable if its component along the undetermined directions
        exceeds this limit for the smallest singular value of a determined direction.
        """
        norms = np.sqrt((root**2).sum(axis=-2))
        error = error + root.shape[-2] * root.shape[-1] * _EPS * norms  # rounding of this norm and of the SVD
        is_zero = norms <= error
        scale = np.where(is_zero, 1.0, norms)
        relative_error = error / scale
        scaled_root = np.where(is_zero, 0.0, 1.0)[..., None, :] * root / scale[..., None, :]
        # With columns of norm 1, the singular values do not depend on the units of the parameters.
        _, singular_values, directions = np.linalg.svd(scaled_root, full_matrices=False)
        largest_error = (np.abs(directions) @ np.where(is_zero, 1.0, relative_error)[..., None])[..., 0]
        is_undetermined = singular_values <= largest_error
        determined_size = np.where(is_undetermined, math.inf, singular_values)
        columns = np.swapaxes(directions, -1, -2)
        # Projection onto the undetermined directions, and pseudo-inverse of the information in the other directions.
        null_projection, inverse = (
            columns @ (weight[..., None] * directions) for weight in (1.0 * is_undetermined, determined_size**-2.0)
        )
        limit = np.sqrt((np.where(is_zero, 0.0, relative_error) ** 2).sum(axis=-1)) / determined_size.min(axis=-1)
        # In any direction, the largest component is at least 1 / sqrt(k): some parameter exceeds the limit.
        limit = np.minimum(limit, 0.5 / math.sqrt(len(names)))[..., None, None]
        is_unidentifiable = np.sqrt(np.diagonal(null_projection, axis1=-2, axis2=-1)) > limit[..., 0]
        row, column = is_unidentifiable[..., None], is_unidentifiable[..., None, :]
        is_infinite = row & column & ((np.abs(null_projection) > limit) | np.eye(len(names), dtype=bool))
        covariance = np.where(
            is_infinite, np.copysign(math.inf, null_projection), inverse / (scale[..., None] * scale[..., None, :])
        )
        determined_correlation = np.where(row | column, 0.0, _correlation(inverse))
        correlation = np.where(row & column, _correlation(null_projection), determined_correlation)
        matrix = np.swapaxes(root, -1, -2) @ root
        return cls(names, units, 0.5 * (matrix + np.swapaxes(matrix, -1, -2)), covariance, correlation)

    @property
    def errors(self) -> dict[Name, Numbers]:
        """Cramér-Rao bounds on the standard errors, with the shape of the stack; inf if unidentifiable."""
        variance = np.diagonal(self.covariance, axis1=-2, axis2=-1)
        return {name: numbers(np.sqrt(variance[..., k]), variance.shape[:-1]) for k, name in enumerate(self.names)}

    @property
    def unidentifiable(self) -> tuple[Name, ...]:
        """Names of the parameters that are unidentifiable in at least one scene."""
        return tuple(name for name, errors in self.errors.items() if np.isinf(errors).any())

    def __repr__(self) -> str:
        stack = self.matrix.shape[:-2]
        width = max(len(str(name)) for name in self.names)
        errors = self.errors.items()
        lines = [
            f"{name!s:{width}} {_errors_in_words(np.asarray(value), self.units[name])}" for name, value in errors
        ]
        return "\n  ".join([f"<{type(self).__name__}{f' of a stack of {stack}' if stack else ''}", *lines]) + ">"


def _correlation(covariance: Array) -> Array:
    """Return the correlation matrix of a covariance: 1 on the diagonal, and otherwise 0 for variances of 0."""
    errors = np.sqrt(np.diagonal(covariance, axis1=-2, axis2=-1))
    errors = np.where(errors > 0.0, errors, 1.0)
    correlation = np.clip(covariance / errors[..., None] / errors[..., None, :], -1.0, 1.0)
    return np.asarray(np.where(np.eye(correlation.shape[-1], dtype=bool), 1.0, correlation))


def _errors_in_words(errors: Array, unit: str) -> str:
    """Return the smallest and the largest finite standard error of a stack as text."""
    finite = errors[np.isfinite(errors)]
    infinite_count = errors.size - finite.size
    if not finite.size:
        return "unidentifiable"
    smallest, largest = float(finite.min()), float(finite.max())
    if unit == "m":
        low, high = (format_length(limit, like=largest, digits=3) for limit in (smallest, largest))
        low = low.partition(" ")[0]
    else:
        low, high = f"{smallest:.3g}", f"{largest:.3g} {unit}".rstrip()
    text = high if smallest == largest else f"{low} to {high}"
    return f"+- {text}" + (f", unidentifiable in {infinite_count} of {errors.size}" if infinite_count else "")


_UNITS: dict[Name, str] = {
    **dict.fromkeys(("wavelength", "object_distance", "focus_distance", "z", "depth"), "m"),
    **dict.fromkeys(("row", "column"), "pixels"),
    **dict.fromkeys(("f_number", "obscuration"), ""),
    "photons": "electrons",
    "background": "electrons/pixel",
}
_PER_IMAGE = ("photons", "background")
_TOLERANCES = (1e-8, 1e-7, 1e-6)
_EPS = float(np.finfo(np.float64).eps)


def fisher(
    pupil: BasePupil | Sequence[BasePupil],
    shape: int | tuple[int, int],
    pixel: float,
    *,
    of: Sequence[Name],
    photons: ArrayLike,
    background: ArrayLike = 0.0,
    noise: Noise | None = None,
    together: bool = False,
    center: tuple[ArrayLike, ArrayLike] | None = None,
    tol: float | None = None,
) -> Information:
    """Return the Fisher information and Cramér-Rao bounds of parameters, from images of a point source.

    Parameters
    ----------
    pupil : Pupil, ObjectivePupil or a sequence of these
        Pupil of the image. Each element of a stack is a scene with one image, and standard errors are arrays. A
        sequence of pupils describes several images of one scene, for example at several foci, whose information is
        added. If pupils in a sequence are stacks, they broadcast, and each element is a scene.
    shape, pixel, center
        Arguments of :func:`lommel.psf`.
    of : sequence
        Parameters that are estimated jointly; all others are assumed to be known. Names are "photons", "background"
        and the `derivatives` of :func:`lommel.psf`, such as "defocus", "row", "column", a Zernike term (3, 1),
        "object_distance" or a microscope's "z". Images of one scene have all parameters in common except "photons"
        and "background", which are estimated for each image.
    photons : array_like
        Flux of the point source: electrons in an infinite window. It broadcasts with the shape of the images: the
        shape of the stack, preceded by the number of pupils if `pupil` is a sequence.
    background : array_like, default 0
        Sky, haze and dark current, electrons per pixel. It broadcasts like `photons`.
    noise : Noise, optional
        Noise of the camera; by default there is no read noise. `white` and `offset` are ignored, since `photons` and
        `background` are in electrons.
    together : bool, default False
        If True, the images of a stack show one scene, and their information is added.
    tol : float, optional
        Tolerance of :func:`lommel.psf`; by default the smallest of 1e-8, 1e-7 and 1e-6 that can be met.

    Returns
    -------
    Information
        Fisher information and Cramér-Rao bounds of each scene.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range or of a wrong shape, or if `of` is empty or names a parameter that the pupil
        does not have.
    ToleranceError
        If the method cannot meet its tolerance.

    Notes
    -----
    With the PSF h, the mean of a pixel is ``mu = photons h + background`` electrons. The information is a sum over
    pixels, ``F[a, b] = sum(d_a mu d_b mu / (mu + read**2))`` (Snyder et al. 1993, doi:10.1364/JOSAA.10.001014). With
    fine pixels in a wide window, without background and read noise, the standard error of the centre of an Airy disc
    is ``lambda N / (pi sqrt(photons))`` (Ober et al. 2004, doi:10.1016/S0006-3495(04)74193-4).

    Unidentifiable parameters have the standard error inf. An example is the defocus of an image in focus, which does
    not change the image to first order. The proven error bounds of the derivatives determine which parameters are
    unidentifiable, see :meth:`~lommel.estimation.fisher.Information.of_root`. The Cramér-Rao bound is local: it
    ignores ambiguities between distant values, such as a defocus and its negative.

    Examples
    --------
    >>> import lommel as lm
    >>> lens = lm.Lens(focal_length=50e-3, f_number=2.8, focus_distance=2.0, wavelength=550e-9)
    >>> camera = {"shape": 33, "pixel": 3.45e-6, "photons": 1e4, "background": 5, "noise": lm.Noise(read=2)}
    >>> lm.fisher(lens.pupil(1.9), of=("object_distance", "row", "column"), **camera)
    <Information
      object_distance +- 402 um
      row             +- 0.0152 pixels
      column          +- 0.0152 pixels>
    >>> lm.fisher(lens.pupil(2.0), of=("object_distance", "row", "column"), **camera).unidentifiable
    ('object_distance',)
    """
    names = _names(of)
    flux = validation.real_array("photons", photons, least=0.0, unit="counts")
    if not np.all(flux > 0.0):
        raise ValueError(f"photons must be > 0 electrons, got {flux.min():g}")
    level = validation.real_array("background", background, least=0.0, unit="counts")
    for name, values in (("photons", flux), ("background", level)):
        if not values.size:
            raise ValueError(f"{name} must not be empty, got shape {values.shape}")
    validation.optional("noise", noise, Noise)
    validation.truth("together", together)
    camera = noise or Noise(read=0.0)
    excess, read = camera.excess, camera.poisson.variance(np.zeros(validation.image_shape(shape)))
    tolerances = _TOLERANCES if tol is None else (tol,)
    plans = [Plan(shape, pixel, dtype=np.float64, center=center, tol=value) for value in tolerances]
    single_pupil = isinstance(pupil, BasePupil)
    psfs = [_most_accurate_psf(plans, value, names) for value in _pupils(pupil)]
    stack_shapes = validation.broadcast("stacks of pupils", *(np.empty(image_psf.pupil.shape) for image_psf in psfs))
    images = stack_shapes[0].shape if single_pupil else (len(psfs), *stack_shapes[0].shape)
    flux, level, _ = validation.broadcast("photons, background and images", flux, level, np.empty(images))
    flux_shape = flux.shape
    if not single_pupil and flux_shape[-len(images)] != len(psfs):
        raise ValueError(f"photons and background must broadcast with images of shape {images}, got {flux_shape}")
    roots, errors = np.empty((*flux_shape, len(names), len(names))), np.empty((*flux_shape, len(names)))
    for index in np.ndindex(flux_shape):
        image_psf = psfs[0 if single_pupil else index[-len(images)]]
        stack = image_psf.pupil.shape
        member = tuple(min(i, side - 1) for i, side in zip(index[len(index) - len(stack) :], stack, strict=True))
        # Electrons divided by the excess noise factor have a Poisson distribution (Noise.poisson).
        electrons = float(flux[index]) / excess, float(level[index]) / excess
        roots[index], errors[index] = _root(image_psf, member, names, *electrons, read)
    unit_factors = np.array([1.0 / excess if name in _PER_IMAGE else 1.0 for name in names])
    roots, errors = roots * unit_factors, errors * unit_factors
    pupil_axis = () if single_pupil else (len(flux_shape) - len(images),)
    return _scene_information(names, roots, errors, tuple(range(len(flux_shape))) if together else pupil_axis)


def _pupils(pupil: BasePupil | Sequence[BasePupil]) -> list[BasePupil]:
    """Return the pupils of all images of a scene; TypeError if there are none."""
    if isinstance(pupil, BasePupil):
        return [pupil]
    argument: object = pupil
    if not isinstance(argument, Sequence) or not argument or isinstance(argument, str):
        raise TypeError(f"pupil must be a Pupil or a sequence of pupils, got {validation.shown(argument)}")
    return [imaged(element) for element in argument]


def _most_accurate_psf(plans: list[Plan], pupil: BasePupil, names: tuple[Name, ...]) -> PSF:
    """Return the PSF and its derivatives, computed by the first plan whose tolerance can be met."""
    derivatives = tuple(name for name in names if name not in _PER_IMAGE)
    for plan in plans[:-1]:
        with suppress(ToleranceError):
            return plan(pupil, derivatives=derivatives)
    return plans[-1](pupil, derivatives=derivatives)


def _root(
    image_psf: PSF, member: tuple[int, ...], names: tuple[Name, ...], photons: float, background: float, read: Array
) -> tuple[Array, Array]:
    """Return a triangular root R of one image's information ``R^T R``, and bounds on the errors of its columns."""
    values = image_psf.values[member]
    peak = float(values.max())
    relative_bound = _EPS if image_psf.error_bound is None else image_psf.error_bound
    # The error bound is added to the variance: the error of a dark pixel must not increase the information.
    # A root of the Fisher information of Poisson data: derivatives of the mean divided by the standard deviation.
    variance = np.maximum(photons * values + background, 0.0) + photons * peak * relative_bound + read
    weight = np.divide(1.0, np.sqrt(variance), out=np.zeros(values.shape), where=variance > 0.0)
    columns, bounds = np.empty((values.size, len(names))), np.empty(len(names))
    for k, name in enumerate(names):
        if name == "background":
            derivative, bounds[k] = np.ones_like(values), 0.0
        elif name == "photons":
            derivative, bounds[k] = values, relative_bound * peak
        else:
            derivative = photons * image_psf.derivatives[name][member]
            bounds[k] = photons * peak * image_psf.derivative_bounds[name]
        columns[:, k] = (weight * derivative).ravel()
    root = np.zeros((len(names), len(names)))
    # The factor R of the QR decomposition loses no digits, unlike the product of the columns.
    factor = _triangular_factor(columns)
    root[: len(factor)] = factor
    rounding = columns.size * _EPS * np.sqrt((columns**2).sum(axis=0))
    return root, bounds * math.sqrt((weight**2).sum()) + rounding


def _triangular_factor(columns: Array) -> Array:
    """Return R of the QR decomposition of a matrix, in blocks of rows because LAPACK is slow for few long columns."""
    count = columns.shape[1]
    block = max(2 * count, 8192 // count)
    while len(columns) > block:
        rows = np.pad(columns, ((0, -len(columns) % block), (0, 0)))
        columns = np.asarray(np.linalg.qr(rows.reshape(-1, block, count), mode="r")).reshape(-1, count)
    return np.asarray(np.linalg.qr(columns, mode="r"))


def _scene_information(names: tuple[Name, ...], roots: Array, errors: Array, axes: tuple[int, ...]) -> Information:
    """Return the information of scenes from a stack of images: those along `axes` show the same scene."""
    count, stack = len(names), errors.shape[:-1]
    scenes = tuple(side for axis, side in enumerate(stack) if axis not in axes)
    last_axes = range(len(scenes), len(stack))
    roots = np.moveaxis(roots, axes, last_axes).reshape(*scenes, -1, count, count)
    errors = np.moveaxis(errors, axes, last_axes).reshape(*scenes, -1, count)
    labels = [f"[{', '.join(map(str, index))}]" if axes else "" for index in np.ndindex(*(stack[a] for a in axes))]
    parts = {name: [f"{name}{i}" for i in labels] if name in _PER_IMAGE else [name] for name in names}
    all_names = tuple(full_name for name in names for full_name in parts[name])
    # 1 where parameter k of image i is parameter j of the scene.
    selection = np.zeros((len(labels), count, len(all_names)))
    for i, k in np.ndindex(len(labels), count):
        selection[i, k, all_names.index(parts[names[k]][i if names[k] in _PER_IMAGE else 0])] = 1.0
    root = (roots @ selection).reshape(*scenes, -1, len(all_names))
    units = {full_name: _UNITS.get(name, "rad") for name in names for full_name in parts[name]}
    return Information.of_root(all_names, units, root, np.sqrt(np.einsum("...ik,ikj->...j", errors**2, selection)))


def _names(of: Sequence[Name]) -> tuple[Name, ...]:
    if isinstance(of, str) or not isinstance(of, Sequence):
        raise TypeError(f"of must be a sequence of names such as ('defocus', 'row'), got {validation.shown(of)}")
    if not of:
        raise ValueError("of must name at least one parameter, such as 'defocus', got none")
    noun = "of, except 'photons' and 'background',"
    return tuple(dict.fromkeys(name if name in _PER_IMAGE else checked_names((name,), noun)[0] for name in of))
