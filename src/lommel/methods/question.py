"""Prepared computations: checks and methods shared by all pupils that differ only in phase."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple, TypeVar, cast

import numpy as np
from numpy.typing import DTypeLike

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.core.answers import Declined, DType, Pixels, Samples, Wanted
from lommel.methods.choice import candidates, first_within_tolerance, instead, of_derivatives
from lommel.methods.method import Method, Shortcut, require_period, with_model_error
from lommel.optics.base_pupil import BasePupil
from lommel.optics.grid import Grid

if TYPE_CHECKING:
    from lommel.methods.derivative_names import Name
    from lommel.methods.derivatives import Slope
    from lommel.optics.layers.objective_pupil import ObjectivePupil
    from lommel.optics.wavefront.wavefront import Wavefront


class Prepared(NamedTuple):
    """Window, methods and settings for all pupils that differ only in phase."""

    light: tuple[object, ...]  # pupil properties except the phase, and True if the phase is radially symmetric
    grid: Grid
    methods: tuple[Method, ...]  # in the order in which they are tried
    is_named: bool  # True if the caller chose the method
    energy: bool  # True if values are fractions of all light
    wanted: Wanted  # requested output, without `out` and derivatives
    shape: tuple[int, ...]  # shape of the values
    flat_shape: tuple[int, ...]  # shape of the values of the flattened stack, (n, height, width)
    shortcut: Shortcut | None  # faster computation that replaces :meth:`images`, None if there is none: Method.plan

    def images(
        self, pupil: BasePupil, names: tuple[Name, ...] = (), out: Pixels | None = None
    ) -> tuple[Method, Samples, list[Slope]]:
        """Return the method used, the images of a pupil, and their derivatives by `names`; ignores the shortcut."""
        self.methods[0].require(pupil)
        request = self.wanted._replace(out=None if out is None else out.reshape(self.flat_shape))
        if names and pupil.layered:
            from lommel.methods.layers.slopes import layered_slopes

            objective_pupil = cast("ObjectivePupil", pupil)
            return first_within_tolerance(
                self.methods if self.is_named else of_derivatives(objective_pupil, self.methods),
                lambda method: layered_slopes(method, objective_pupil, self.grid, names, request),
            )[1]
        if names:
            from lommel.methods.derivatives import differentiated
            from lommel.optics.pupil import checked

            chosen_method = self.methods[0] if self.is_named else None
            lens_pupil, tol = checked(pupil), self.methods[0].tol
            return differentiated(chosen_method, lens_pupil, self.grid, names, request, tol, energy=self.energy)

        def images_by(method: Method) -> Samples:
            images = method.images(pupil, self.grid, request)
            return with_model_error(images, pupil, method, normalized=request.scale is None)

        try:
            method, images = first_within_tolerance(self.methods, images_by)
        except Declined as declined:
            if self.is_named:
                raise declined.advised() from None
            raise Declined(f"{declined}{instead(pupil, self.grid)}") from None
        return method.reported, images, []


def prepare(
    pupil: BasePupil,
    light: tuple[object, ...],
    grid: Grid,
    method: Method | None,
    tol: float,
    normalize: str,
    dtype: DType,
    threads: int,
) -> Prepared:
    """Return the prepared computation for pupils that differ only in phase; see :class:`lommel.Plan`."""
    if grid.stack:
        grid = grid.broadcast(pupil.shape)
    methods = candidates(pupil, grid, tol) if method is None else (method,)
    wanted = output_spec(grid, pupil, methods[0], normalize, dtype, threads)
    stack, is_named, energy = pupil.shape, method is not None, normalize == "energy"
    shortcut = methods[0].plan(pupil, grid, wanted)
    flat_shape = (math.prod(stack), *grid.shape)
    return Prepared(light, grid, methods, is_named, energy, wanted, stack + grid.shape, flat_shape, shortcut)


def output_spec(grid: Grid, pupil: BasePupil, method: Method, normalize: str, dtype: DType, threads: int) -> Wanted:
    """Return the requested scale, dtype and threads of images; ValueError for unsupported pupils or windows."""
    method.require(pupil)
    for pitch in grid.pitch:
        validation.pixel_on(pitch, pupil.scale, metric=pupil.wavelength is not None)
    # All methods limit the distance from the axis, except Geometric, which has no point samples.
    if method.sampling == "center":
        grid.require_reach(pupil)
    if pupil.period < math.inf:
        require_period(method.period(pupil), pupil, grid, edges=grid.integrate)
    count = math.prod(pupil.shape) * grid.height * grid.width
    if count > validation.MAX_VALUES:
        raise ValueError(
            f"shape {grid.shape} for {math.prod(pupil.shape)} pupils makes {count} values, "
            f"more than the limit of {validation.MAX_VALUES}; compute it in parts"
        )
    scale: float | Array | None = None
    if normalize == "emitted":
        scale = grid.cell(pupil) / (4.0 * math.pi) * pupil.collected.ravel()
    elif normalize == "energy":
        # The integral of I over the plane in v is 4 pi times the transmission (Parseval's theorem).
        scale = grid.cell(pupil) / (4.0 * math.pi * pupil.transmission)
    elif normalize == "strehl":
        scale = 1.0 / method.unaberrated_peak(pupil)
    return Wanted(scale, dtype, threads=threads)


def gradient(
    method: Method,
    pupil: BasePupil,
    grid: Grid,
    names: tuple[Name, ...] | None,
    weights: Array,
    scale: Array,
    normalize: str,
) -> dict[Name, Array]:
    """Return the derivatives, each (n,), of the sum over pixels of `weights` (n, height, width) times values.

    Values are `scale` (n,) times the intensity of the flattened stack. `names` are the checked parameters by which
    the sum is differentiated, or None for all terms of the wavefront.
    """
    energy = normalize == "energy"
    if pupil.layered:
        from lommel.methods.layers.slopes import layered_gradient

        objective_pupil = cast("ObjectivePupil", pupil)
        parameters, far = _terms(objective_pupil.aberrations) if names is None else names, normalize == "emitted"
        result = layered_gradient(method, objective_pupil, grid, parameters, weights, scale, far=far)
        return {name: result[name] for name in parameters}
    from lommel.methods import derivatives
    from lommel.optics.pupil import checked

    lens_pupil = checked(pupil)
    parameters = _terms(lens_pupil.wavefront) if names is None else names
    result = derivatives.gradient(method, lens_pupil, grid, parameters, weights, float(scale[0]), energy=energy)
    return {name: result[name] for name in parameters}


def _terms(wavefront: Wavefront | None) -> tuple[Name, ...]:
    """Return the terms of a wavefront except the constant phase, which has no effect on the intensity."""
    return tuple(term for term in wavefront.terms if term != (0, 0)) if wavefront else ()


AnyPupil = TypeVar("AnyPupil", bound=BasePupil)


def names(
    derivatives: Sequence[str | tuple[int, int]], argument: str = "derivatives"
) -> tuple[str | tuple[int, int], ...]:
    """Return checked names of derivatives; TypeError or ValueError with the name `argument` if one is not valid."""
    if isinstance(derivatives, tuple) and not derivatives:
        return ()
    from lommel.methods.derivative_names import checked  # imported on use, which is rare

    return checked(derivatives, argument)


def array(name: str, value: object) -> Pixels:
    """Return `value` if it is an array; TypeError with the name of the argument otherwise."""
    if not isinstance(value, np.ndarray):
        raise TypeError(f"{name} must be a NumPy array, got {type(value).__name__}")
    return value


def place(out: Pixels, shape: tuple[int, ...], dtype: DType) -> Pixels:
    """Return `out` if values of this shape and dtype can be written into it; TypeError or ValueError otherwise."""
    if array("out", out).shape != shape:
        raise ValueError(f"out must have the shape {shape}, got {out.shape}")
    if out.dtype != dtype:
        raise ValueError(f"out must be of {dtype}, got {out.dtype}")
    flags = out.flags
    if not (flags.c_contiguous and flags.writeable):
        kind = "a read-only array" if flags.c_contiguous else "an array of other strides"
        raise ValueError(f"out must be C-contiguous and writable, got {kind}")
    return out


def output_type(dtype: DTypeLike | None, tol: float) -> DType:
    """Return `dtype`, or the coarsest dtype for values accurate to `tol`; ValueError if `dtype` is too coarse."""
    if dtype is None:
        # Rounding to float32 is an error of 2^-24 = 6e-8 of the peak, a small fraction of a tolerance of 1e-6.
        return np.dtype(np.float32 if tol >= 1e-6 else np.float64)
    kind = validation.kind("dtype", dtype, np.float32, np.float64)
    if kind == np.float32 and tol < 2.0**-22:
        raise ValueError(f"dtype float32 cannot hold tol={tol:g}; use float64, or a tolerance of at least 2.4e-7")
    return kind


def for_axes(pupil: AnyPupil, center_shape: tuple[int, ...]) -> AnyPupil:
    """Return the stack of pupils broadcast with `center_shape`, the shape of an array of window centres."""
    try:
        return pupil.broadcast(np.broadcast_shapes(pupil.shape, center_shape))
    except ValueError:
        raise ValueError(
            f"center must broadcast with the stack of pupils, got centres of shape {center_shape} for {pupil.shape}"
        ) from None


def checked_method(method: object, tol: float | None, integrate: object) -> tuple[Method | None, float]:
    """Return the method (None for the default) with the tolerance; TypeError or ValueError if arguments conflict."""
    if isinstance(method, str):
        from lommel.methods.registry import LAYERED, METHODS  # imports all methods

        kinds = METHODS | LAYERED
        method = kinds[validation.choice("method", method, tuple(kinds))]()
    if method is not None and not isinstance(method, Method):
        raise TypeError(f"method must be a name such as 'hankel', a Method or None, got {validation.shown(method)}")
    if not (integrate is None or isinstance(integrate, bool)):
        raise TypeError(f"integrate must be True, False or None, got {validation.shown(integrate)}")
    if integrate is False and method is not None and method.sampling == "pixel":
        raise ValueError(
            f"integrate must not be False for {type(method).__name__}, which has no point values; leave it out"
        )
    if tol is None:
        tol = (method or Method).tol
    elif method is None:
        tol = validation.real("tol", tol, least=Method.least_tol, below=1e-1)
    else:
        method = method.with_tol(tol)
    return method, tol
