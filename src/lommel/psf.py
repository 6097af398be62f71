"""Point spread functions: `psf` computes one PSF, `Plan` many PSFs with the same options; both return a `PSF`."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from os import PathLike
from typing import TYPE_CHECKING, Any, TypeVar, cast

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from lommel import measures
from lommel.base import display, validation
from lommel.base.arrays import Array, Numbers, Values, largest
from lommel.base.quantities import in_unit
from lommel.base.units import pitch_in_words
from lommel.core.answers import Declined, ToleranceError
from lommel.measures.psf_like import PSFLike
from lommel.methods import question
from lommel.methods.method import Method
from lommel.methods.question import Prepared, prepare
from lommel.optics.base_pupil import BasePupil, imaged
from lommel.optics.grid import Grid

if TYPE_CHECKING:
    from types import ModuleType

    from matplotlib.axes import Axes

    from lommel.blur.blurs import Blur
    from lommel.measures.measured_psf import MeasuredPSF
    from lommel.methods.derivative_names import Name
    from lommel.optics.pupil import FieldPupil, Pupil
    from lommel.traced.traced_psf import TracedPSF


def psf(
    pupil: BasePupil,
    shape: int | tuple[int, int],
    pixel: float | tuple[float, float],
    *,
    method: Method | str | None = None,
    tol: float | None = None,
    normalize: str = "energy",
    dtype: DTypeLike | None = None,
    center: tuple[ArrayLike, ArrayLike] | None = None,
    integrate: bool | None = None,
    fill: float | tuple[float, float] = 1.0,
    blur: Blur | Sequence[Blur] = (),
    derivatives: Sequence[Name] = (),
    threads: int | None = None,
) -> PSF:
    """Compute the point spread function of a pupil.

    Parameters
    ----------
    pupil : Pupil or ObjectivePupil
        Pupil of a lens, or of a microscope (:meth:`lommel.Objective.pupil`). A stack of pupils gives a stack of PSFs.
    shape : int or (int, int)
        Side of a square window, or height and width, in pixels. The centre of the window is the centre of pixel
        ``(height // 2, width // 2)``.
    pixel : float or (float, float)
        Pixel pitch, or height and width of pixels that are not square, in metres if the pupil has a wavelength, else
        in units of lambda*N.
    method : str or Method, optional
        Method that evaluates the diffraction integral, by its name in lower case, such as "hankel" or
        "nijboer-zernike", or with options, such as ``lommel.methods.Hankel(tol=1e-12)``. By default it is chosen for
        pupil and window: NijboerZernike for circular apertures; ChordalGauss instead if the wavefront is not radially
        symmetric and ChordalGauss is likely to be faster; of ChordalGauss and NonuniformFFT the one that is likely to
        be faster behind straight vanes (those that ChordalGauss supports); NonuniformFFT for other vanes, vignetting,
        segments, stops and masks. `PSF.method` is the method used.
    tol : float, optional
        Tolerance relative to the peak of the PSF, which may lie outside the window; if `normalize` is "peak",
        relative to the largest value in the window. By default the tolerance of the method, or 1e-6 without a method.
    normalize : {"energy", "emitted", "strehl", "peak"}, default "energy"
        "energy": a value is the fraction of all light per pixel. Pixel averages over an infinite window sum to 1, and
        so do point samples if the pixels are no larger than lambda*N. "emitted", for an Objective: as "energy", but
        relative to the light that the objective would collect if the emitter were far from the glass. "strehl": the
        peak of the same aperture without aberration is 1. "peak": the largest value in the window is 1.
    dtype : float32 or float64, optional
        Type of the values; by default float64 for tolerances below 1e-6 and float32 otherwise.
    center : (float, float) or (array_like, array_like), optional
        Row and column of the optical axis, in pixels from the centre of the first pixel; by default the centre of
        pixel ``(height // 2, width // 2)``. Arrays of rows and columns, broadcast with the stack of pupils, give each
        pupil its own axis; supported by `NijboerZernike`, `ChordalGauss`, a `Polychromatic` of these, and for
        objectives by `Stratified`, `DebyeRings` and `ChordalDebye`.
    integrate : bool, optional
        True for pixel-integrated values (averages over the area of each pixel), False for point samples at pixel
        centres. By default values are pixel-integrated if pixels are in metres, and point-sampled if pixels are in
        units of lambda*N. `Geometric` has no point values and always integrates. See `PSF.sampling`.
    fill : float or (float, float), default 1
        Fill factor: the active fraction of the area of a pixel, or of its height and width. Values are always
        pixel-integrated if it is below 1, which is not supported with derivatives.
    blur : Blur or sequence of Blur, default ()
        Additional blur of images by lenses, such as :class:`lommel.Seeing` or :class:`lommel.Jitter`; see
        :doc:`/sensor`. Not supported with derivatives.
    derivatives : sequence, default ()
        Parameters with respect to which derivatives are computed, returned as ``PSF.derivatives``.
        For lenses, per radian: "defocus" (C_d), "spherical" (C_s), "rho^6", "rho^8", and Zernike coefficients
        at the pupil edge as (n, m), "noll 8", "ansi 8" or "fringe 7"; per pixel: "row" and "column" of the axis; per
        metre: "wavelength" (all wavelengths scale in proportion, optical path differences are fixed), and for a pupil
        of :meth:`Lens.pupil` "object_distance" and "focus_distance" (the sensor moves); per 1: "f_number" (phases are
        fixed) and "obscuration". `ChordalGauss` supports all for circular apertures; `NijboerZernike`, for radially
        symmetric pupils, all but the obscuration and terms that are not radially symmetric; `NonuniformFFT`, for any
        aperture, all but the obscuration, and the wavelength unless segments have phases. A `Polychromatic` supports
        the same parameters as these methods.
        For objectives, per metre: "z" of the stage and "depth" (the stage is fixed); per pixel: "row", "column"; per
        radian: Zernike terms. `Stratified`, `ChordalDebye` and, with aberrations, `DebyeRings` support them; Zernike
        terms and, with aberrations, "z" and "depth" require `ChordalDebye` and a small window.
        Not supported for ``normalize="peak"``. `tol` applies to the values, which may differ from the values without
        derivatives within their error bound; ``PSF.derivative_bounds`` bounds the errors of the derivatives.
    threads : int, optional
        Maximum number of threads; by default the number of processors, which all calls share.

    Returns
    -------
    PSF
        With ``values`` of shape ``pupil.shape + (height, width)``, where the stack is broadcast with `center`.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, if the method does not support the pupil, or pupil and window take more than
        its limits (leave `method` out, or follow the message), if `tol` is given for a method without an error
        bound, if the result would exceed 2^31 values, or if float32 is requested with a tolerance below 2.4e-7,
        which rounding to float32 would exceed.
    ToleranceError
        If the method cannot meet its tolerance.

    Examples
    --------
    >>> import lommel as lm
    >>> answer = lm.psf(lm.Pupil(lm.Wavefront(defocus=10.0, spherical=3.0)), shape=512, pixel=0.25)
    >>> answer.values.shape
    (512, 512)
    """
    imaged(pupil)  # checked first, in case the caller passes arguments in the wrong order
    if type(pixel) is not float:
        pixel = in_unit("pixel", pixel, pupil.unit)
    # Recent plans are cached, so that calls with the same options check them and build tables only once.
    options: dict[str, Any] = {"method": method, "tol": tol, "normalize": normalize, "dtype": dtype}
    options |= {"integrate": integrate, "threads": threads}
    no_blur = type(fill) is float and fill == 1.0 and isinstance(blur, tuple) and not blur
    # The cache ignores types inside tuples, so that (True, True), which must be refused, would equal (1, 1).
    hashable = center is None or (type(center) is tuple and all(type(part) in _NUMBERS for part in center))
    if no_blur and hashable and type(shape) is int:
        return cached_plan(shape, pixel, center=center, **options)(pupil, derivatives=derivatives)
    return Plan(shape, pixel, center=center, fill=fill, blur=blur, **options)(pupil, derivatives=derivatives)


class Plan:
    """A prepared computation of PSFs for many pupils, one after the other; the options are checked only once.

    A call with a pupil returns the same PSF as :func:`psf`. With `out`, calls after the first allocate no image, and
    build no table that is still in the caches.

    Parameters
    ----------
    shape, pixel, method, tol, normalize, dtype, center, integrate, fill, blur, threads
        As for :func:`psf`.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.

    Examples
    --------
    >>> import lommel as lm
    >>> import numpy as np
    >>> focus = lm.Plan(shape=33, pixel=0.5)
    >>> frame = np.empty((33, 33), np.float32)
    >>> for defocus in (0.0, 1.0, 2.0):
    ...     answer = focus(lm.Pupil(lm.Wavefront(defocus)), out=frame)
    """

    def __init__(
        self,
        shape: int | tuple[int, int],
        pixel: float | tuple[float, float],
        *,
        method: Method | str | None = None,
        tol: float | None = None,
        normalize: str = "energy",
        dtype: DTypeLike | None = None,
        center: tuple[ArrayLike, ArrayLike] | None = None,
        integrate: bool | None = None,
        fill: float | tuple[float, float] = 1.0,
        blur: Blur | Sequence[Blur] = (),
        threads: int | None = None,
    ) -> None:
        method, tol = question.checked_method(method, tol, integrate)
        self.integrate = integrate
        self.blur: tuple[Blur, ...] = ()
        if not isinstance(blur, tuple) or blur:
            from lommel.blur.blurs import blurs  # imported only here, since most PSFs have no blur

            self.blur = blurs(blur)
        # Grids with pixel-integrated and with point-sampled values; :meth:`grid` chooses one of them for each pupil.
        self._integrated_grid = Grid(shape, pixel, center=center, integrate=True, fill=fill)
        # With a fill factor below 1, values are always pixel-integrated.
        partly = self._integrated_grid.partly
        self._sampled_grid = self._integrated_grid if partly else self._integrated_grid.sampled
        if integrate is False and partly:
            raise ValueError(
                f"integrate must not be False with fill={validation.shown(fill)}: point samples have no fill factor"
            )
        self._center_shape = self._sampled_grid.stack
        # True if a method computes the values directly: square pixels without fill factor and blur.
        self.plain = self._integrated_grid.square and not self.blur
        self.method, self.tol = method, tol
        self.normalize = validation.choice("normalize", normalize, ("energy", "emitted", "strehl", "peak"))
        self.dtype = question.output_type(dtype, tol)
        self.threads = 0 if threads is None else validation.integer("threads", threads, least=1, most=1024)
        self._prepared: Prepared | None = None

    def __call__(self, pupil: BasePupil, *, derivatives: Sequence[Name] = (), out: Values | None = None) -> PSF:
        """Compute the PSF of `pupil`; see :func:`psf`. `out` is a C-contiguous, writable array for the values."""
        pupil = imaged(pupil)
        if not pupil.one_aperture:
            return self._aperture_by_aperture(cast("FieldPupil", pupil), derivatives, out)
        if self._center_shape:
            pupil = question.for_axes(pupil, self._center_shape)
        if not self.plain:
            return self._blurred(pupil, derivatives, out)
        prepared = self.prepared(pupil)
        _, grid, candidates, _, _, _, shape, _, shortcut = prepared
        names = () if isinstance(derivatives, tuple) and not derivatives else question.names(derivatives)
        if names and self.normalize == "peak":
            raise ValueError(
                'derivatives need normalize="energy" or "strehl", got "peak", since a maximum over pixels has kinks'
            )
        result = None
        if shortcut is not None and not names and (out is None or isinstance(out, np.ndarray)):
            values = np.empty(shape, self.dtype) if out is None else out
            try:
                result = shortcut(pupil, values)
            except (Declined, ToleranceError) as fault:
                if len(candidates) == 1:
                    raise fault.advised() if isinstance(fault, Declined) else fault from None
                prepared = prepared._replace(methods=candidates[1:])  # try the next method
        if result is None:
            return self._compute(prepared, pupil, names, out)
        (scale, error), method = result, candidates[0].reported
        # The attributes are valid already; the checks of PSF() would take a tenth of the time of a small image.
        psf = object.__new__(PSF)
        parts = psf.__dict__
        parts["values"], parts["grid"], parts["pupil"], parts["method"] = values, grid, pupil, method
        parts["normalize"], parts["error_bound"], parts["scale"] = self.normalize, error, scale
        parts["derivatives"], parts["derivative_bounds"], parts["blur"] = {}, {}, ()
        return psf

    def prepared(self, pupil: BasePupil) -> Prepared:
        """Return the prepared computation for pupils that differ from `pupil` only in phase."""
        # Checks, methods and tables depend only on these properties; successive pupils often differ only in phase.
        light = pupil.aperture, pupil.radial, pupil.shape, pupil.wavelength, pupil.f_number
        # Another thread may replace the attribute at any time: plans of the cache are shared.
        prepared = self._prepared
        if prepared is None or prepared.light != light:
            prepared = self._prepared = prepare(
                pupil, light, self.grid(pupil), self.method, self.tol, self.normalize, self.dtype, self.threads
            )
        return prepared

    def _compute(self, prepared: Prepared, pupil: BasePupil, names: tuple[Name, ...], out: Values | None) -> PSF:
        """Return a PSF, with derivatives by checked `names`, computed without the shortcut of :class:`Prepared`."""
        target = None if out is None else question.place(out, prepared.shape, self.dtype)
        method, images, slopes = prepared.images(pupil, names, target)
        psf = object.__new__(PSF)  # without checks, as in __call__
        psf.__dict__.update(
            values=images.values.reshape(prepared.shape) if target is None else target,
            grid=prepared.grid,
            pupil=pupil,
            method=method,
            normalize=self.normalize,
            error_bound=None if images.error is None else largest(images.error),
            scale=images.scale.reshape(pupil.shape),
            derivatives={n: slope.values.reshape(prepared.shape) for n, slope in zip(names, slopes, strict=True)},
            derivative_bounds={n: largest(slope.error) for n, slope in zip(names, slopes, strict=True)},
            blur=(),
        )
        return psf

    def _blurred(self, pupil: BasePupil, derivatives: Sequence[Name], out: Values | None) -> PSF:
        """Return a PSF with blur, with a fill factor, or on pixels that are not square."""
        from lommel.blur.recorded import recorded

        if question.names(derivatives):
            raise ValueError(
                "derivatives need square pixels without fill and blur; compute finite differences of the PSFs instead"
            )
        settings = self.method, self.tol, self.normalize, self.dtype, self.threads
        return PSF(**recorded(pupil, self.grid(pupil), self.blur, settings, out))

    def _aperture_by_aperture(self, pupil: FieldPupil, derivatives: Sequence[Name], out: Values | None) -> PSF:
        """Return the stack of PSFs of pupils whose apertures differ, such as vignetted pupils over the field."""
        if question.names(derivatives):
            raise ValueError(
                "derivatives need pupils of one aperture, got several (vignetting); compute each pupil alone"
            )
        if self._center_shape:
            raise ValueError(
                "center must be one (row, column) for pupils whose apertures differ; compute each pupil alone"
            )
        shape = (*pupil.shape, *self._sampled_grid.shape)
        target = np.empty(shape, self.dtype) if out is None else question.place(out, shape, self.dtype)
        windows = target.reshape(-1, *self._sampled_grid.shape)
        psfs = [self(single, out=window) for single, window in zip(pupil.pupils, windows, strict=True)]
        # The stack has an error bound only if every PSF has an error bound.
        bounds = [psf.error_bound for psf in psfs if psf.error_bound is not None]
        # The stack has the method of its first pupil that is not circular.
        return replace(
            next((psf for psf in psfs if not psf.pupil.circular), psfs[0]),
            values=target,
            pupil=pupil,
            error_bound=max(bounds) if len(bounds) == len(psfs) else None,
            scale=np.reshape([float(psf.scale) for psf in psfs], pupil.shape),
        )

    def __getstate__(self) -> dict[str, object]:
        # `_prepared` holds objects of the compiled core, which cannot be pickled.
        return vars(self) | {"_prepared": None}

    def grid(self, pupil: BasePupil) -> Grid:
        """Return the grid of pixels for `pupil`, in metres or in units of lambda*N."""
        integrated = self.integrate
        if integrated is None:
            # Pixels in metres are the pixels of a camera, which integrate over their area.
            metric = pupil.wavelength is not None
            integrated = metric or (self.method is not None and self.method.sampling == "pixel")
        return self._integrated_grid if integrated else self._sampled_grid

    def traced(
        self, pupil: Pupil, xp: ModuleType | str | None = None, *, device: object = None, precision: str = "auto"
    ) -> TracedPSF:
        """Return the plan as a differentiable function of coefficients, in JAX, PyTorch or any array API.

        Parameters
        ----------
        pupil : Pupil
            A stack whose coefficients define the valid range of coefficients. For radially symmetric pupils the range
            is the smallest box that contains the coefficients of the stack; for other pupils it contains coefficients
            that are no larger than those of one pupil of the stack. Aperture, amplitude, wavelength and f-number of
            the function are the same as of the stack.
        xp : module or str, optional
            ``jax.numpy``, ``torch``, ``cupy``, ``numpy`` or another array API module, or its name; NumPy by default.
        device : optional
            Device of the framework for tables and coefficients.
        precision : {"auto", "float64", "float32"}, default "auto"
            Type of the computation; "auto" is float64 if the framework supports it. In float32 an error bound of 1e-6
            cannot be proven.

        Returns
        -------
        TracedPSF
            A function ``images = f(c)`` of coefficients c of shape (..., k), in radians, one for each of the k terms
            ``f.terms``.

        Raises
        ------
        TypeError, ValueError
            If an argument is out of range, the aperture is obstructed, or the framework lacks the precision.
        ImportError
            If the framework is not installed.
        ToleranceError
            If the tolerance cannot be proven for a pupil of the stack.

        Examples
        --------
        >>> import lommel as lm
        >>> pupils = lm.Pupil(lm.Wavefront([-10.0, 10.0]))
        >>> f = lm.Plan(shape=33, pixel=0.5).traced(pupils)
        >>> f.terms
        ('defocus', 'spherical')
        >>> f([[3.0, 0.0], [4.0, 0.5]]).shape
        (2, 33, 33)
        """
        from lommel.optics.pupil import checked
        from lommel.traced import traced_psf

        validation.choice("precision", precision, ("auto", "float64", "float32"))
        if not self.plain:
            raise ValueError("a traced plan needs square pixels without fill and blur; make a plan without them")
        if isinstance(pupil, BasePupil) and pupil.layered:
            raise TypeError(
                "pupil must be the pupil of a lens for a traced plan, got one of an Objective; PSF.pullback computes "
                "the gradient of a loss with respect to its aberrations, stage and depth"
            )
        grid = self.grid(checked(pupil))
        values = self.tol, self.normalize, str(self.dtype)
        return traced_psf.traced(pupil, grid, self.method, values, (xp, device, precision))


# Plans of recent calls and fits. `typed` distinguishes equal options of different types, such as 1 and True.
_plans = lru_cache(maxsize=64, typed=True)(Plan)


def cached_plan(*window: Any, **options: Any) -> Plan:
    """Return the plan with these options, of recent calls or a new one."""
    try:
        return _plans(*window, **options)
    except TypeError:  # of an unhashable or invalid option: the constructor raises the proper error
        return Plan(*window, **options)


_NUMBERS = (float, int)


Found = TypeVar("Found")


class Measured:
    """Image quality measures of a PSF.

    Most measures are computed from the optical transfer function and do not depend on the window. By default they are
    measures of the image, that is with blur and averaging over pixels; with ``of="optics"``, without averaging.
    Results have the shape of the stack of pupils, followed by the axis of channels, if any, and by the shape of the
    argument. The function that a method refers to documents the error of the measure.
    """

    def apply(self, measure: Callable[[PSF], Found]) -> Found:
        """Return the result of `measure` for each PSF."""
        raise NotImplementedError

    @property
    def energy(self) -> Numbers:
        """Fraction of all light that falls inside the window, which ends at the outer edges of its pixels."""
        return self.apply(measures.energy.window_energy)

    @property
    def strehl(self) -> Numbers:
        """Strehl ratio: intensity on the axis divided by its value without aberration; see :func:`lommel.strehl`."""
        return self.apply(measures.spot.axis_strehl)

    @property
    def peak_strehl(self) -> Numbers:
        """Largest value in the window, relative to the peak of the same aperture without aberration."""
        return self.apply(measures.spot.peak_strehl)

    @property
    def centroid(self) -> NDArray[np.float64]:
        """Centroid (x, y) of all light relative to the axis; see :func:`lommel.measures.energy.image_centroid`."""
        return self.apply(measures.energy.image_centroid)

    def encircled_energy(self, radius: ArrayLike, *, about: str = "axis", of: str = "image") -> Numbers:
        """Return the fraction of all light within `radius` (in the unit of the pixel), which may exceed the window.

        `about` is "axis" or "centroid", `of` is "image" or "optics" (without the pixel); see
        :func:`lommel.measures.energy.encircled_energy`.
        """
        return self.apply(lambda psf: measures.energy.encircled_energy(psf, radius, about=about, of=of))

    def ensquared_energy(self, half_width: ArrayLike, *, about: str = "axis", of: str = "image") -> Numbers:
        """Return the fraction of all light within a square of side ``2 * half_width``.

        `about` is "axis" or "centroid", `of` is "image" or "optics"; see
        :func:`lommel.measures.energy.ensquared_energy`.
        """
        return self.apply(lambda psf: measures.energy.ensquared_energy(psf, half_width, about=about, of=of))

    def energy_diameter(self, fraction: float, *, about: str = "axis", of: str = "image") -> Numbers:
        """Return the diameter of the circle that contains `fraction` of all light: 0.5 for D50, 0.8 for D80.

        `about` is "axis" or "centroid", `of` is "image" or "optics"; see
        :func:`lommel.measures.spot.energy_diameter`.
        """
        return self.apply(lambda psf: measures.spot.energy_diameter(psf, fraction, about=about, of=of))

    def fwhm(self, along: str = "mean", *, of: str = "image") -> Numbers:
        """Return the full width at half maximum `along` "x", along "y", or the "mean" of both.

        `of` is "image" or "optics"; see :func:`lommel.measures.spot.fwhm`.
        """
        return self.apply(lambda psf: measures.spot.fwhm(psf, along, of=of))

    def otf(self, fx: ArrayLike, fy: ArrayLike = 0.0, *, of: str = "image") -> NDArray[np.complex128] | np.complex128:
        """Return the optical transfer function of the image, or `of` the "optics", at frequencies `fx`, `fy`.

        For lenses it is computed from the wavefront, also beyond the Nyquist frequency of the pixels; see
        :func:`lommel.otf`.
        """
        return self.apply(lambda psf: measures.transfer.image_otf(psf, fx, fy, of=of))

    def mtf(self, fx: ArrayLike, fy: ArrayLike = 0.0, *, of: str = "image") -> Numbers:
        """Return the modulation transfer function, the modulus of :meth:`otf`, for the same arguments."""
        return np.abs(self.otf(fx, fy, of=of))


@dataclass(frozen=True, eq=False, repr=False)
class PSF(Measured, PSFLike, display.Shown):
    """A computed point spread function (PSF), or a stack of them, with its pupil, grid, method and error bound.

    Attributes
    ----------
    values : ndarray, shape ``pupil.shape + (height, width)``
        float32 or float64; see :attr:`sampling`.
    grid : Grid
        Grid of pixels.
    pupil : Pupil or ObjectivePupil
    method : Method
    normalize : str
        "energy", "emitted", "strehl" or "peak", as for :func:`psf`.
    error_bound : float or None
        Bound on the largest error of the values relative to the peak of the PSF, which may lie outside the window; if
        `normalize` is "peak", relative to the largest value in the window. Of a stack, the maximum over its PSFs.
        None if the method has no bound. The peak of a pixel-integrated PSF is the largest average over a pixel at any
        position, which exceeds the largest pixel by up to 3.8 times if pixels are coarse and the axis is at a corner.
    scale : ndarray, shape ``pupil.shape``
        Factor by which intensities were multiplied whose peak without obscuration and aberration is 1.
    derivatives : dict of (str or (int, int)) to ndarray
        Derivatives of the values with respect to the requested parameters, each of the shape of the values.
    derivative_bounds : dict of (str or (int, int)) to float
        Bounds on the errors of the derivatives relative to the peak of the values, per unit of the parameter. Of a
        stack, the maximum over its PSFs.
    blur : tuple of Blur
        Blur in addition to the diffraction by the pupil.

    Raises
    ------
    TypeError, ValueError
        If an attribute has the wrong type, or if the values do not have the shape ``pupil.shape + grid.shape``.
    """

    pupil_hint = "a PSF; its pupil is psf.pupil, and psf.mtf(fx, fy) and psf.otf(fx, fy) are measures of the image"
    values: Values
    grid: Grid
    pupil: BasePupil
    method: Method
    normalize: str
    error_bound: float | None
    scale: Array = field(repr=False)
    derivatives: dict[Name, Values] = field(default_factory=dict, repr=False)
    derivative_bounds: dict[Name, float] = field(default_factory=dict, repr=False)
    blur: tuple[Blur, ...] = ()

    def __post_init__(self) -> None:
        for name, kind in (("grid", Grid), ("pupil", BasePupil), ("method", Method)):
            validation.instance(name, getattr(self, name), kind)
        if self.grid.stack not in ((), self.pupil.shape):
            raise ValueError(
                f"grid must have one center, or one for each pupil of a stack of shape {self.pupil.shape}, "
                f"got {self.grid.stack}"
            )
        # All attributes are checked, since they may come from a file.
        expected = self.pupil.shape + self.grid.shape
        if not isinstance(self.values, np.ndarray) or self.values.dtype not in (np.float32, np.float64):
            raise TypeError(f"values must be an array of float32 or float64, got {validation.shown(self.values)}")
        if self.values.shape != expected:
            raise ValueError(f"values must have the shape {expected}, got {self.values.shape}")

    def __len__(self) -> int:
        """Return the length of the first axis of a stack."""
        if self.pupil.shape == ():
            raise TypeError("a single PSF has no length; its pixels are in `values`")
        return self.pupil.shape[0]

    def __bool__(self) -> bool:
        """Return True, also for a single PSF, which has no length."""
        return True

    def __repr__(self) -> str:
        bound = "none" if self.error_bound is None else f"{self.error_bound:.2g}"
        pixel = pitch_in_words(self.grid.pixel) if self.unit == "m" else f"{self.grid.named} {self.unit}"
        values = "averaged over pixels" if self.grid.integrate else "sampled at pixel centres"
        values += "".join(f", {type(blur).__name__}" for blur in self.blur)
        # Point samples more than lambda*N apart do not sum to the total light, so that their sum is shown.
        if not self.sum_is_light:
            sums = self.values.sum(axis=(-2, -1), dtype=np.float64)
            values += (
                f", which sum to {' to '.join(f'{s:.3g}' for s in sorted({float(sums.min()), float(sums.max())}))}"
            )
        return (
            f"<{type(self).__name__} {'x'.join(map(str, self.shape))} {self.values.dtype}, "
            f"pixel {pixel}, {values}, {type(self.method).__name__}, "
            f"normalize {self.normalize!r}, error bound {bound}>"
        )

    def apply(self, measure: Callable[[PSF], Found]) -> Found:
        """Return the result of `measure` for this PSF, or for the PSF of each pupil if apertures differ."""
        if self.pupil.one_aperture:
            return measure(self)
        # Measures of a stack assume the same aperture for all pupils.
        results = [np.asarray(measure(self[index])) for index in np.ndindex(self.pupil.shape)]
        return cast("Found", np.reshape(results, self.pupil.shape + results[0].shape))

    @property
    def z(self) -> NDArray[np.float64]:
        """Stage position of each plane of a stack over z, metres; see :func:`lommel.measures.spot.stage`."""
        return measures.spot.stage(self)

    def axial_fwhm(self, *, of: str = "image") -> Numbers:
        """Return the full width at half maximum along z, in metres of stage travel, `of` the "image" or the "optics".

        See :func:`lommel.measures.spot.axial_fwhm`.
        """
        return measures.spot.axial_fwhm(self, of=of)

    def pullback(self, g: ArrayLike, of: Sequence[Name] | None = None) -> dict[Name, NDArray[np.float64]]:
        """Return the gradient of a loss from its derivative `g` with respect to the values (reverse mode).

        The gradient with respect to a parameter p is the sum of ``g * d values / dp`` over the pixels. For phase
        coefficients and shifts of pupils that are not radially symmetric, it is computed in reverse mode, by a
        transform to the pupil, in the time of about two images for any number of parameters. The same holds for the
        stage and the depth of an Objective with aberrations, in windows that :class:`lommel.methods.ChordalDebye`
        supports. All other derivatives are computed in forward mode.

        Parameters
        ----------
        g : array_like
            Derivative of the loss, with the shape of the values.
        of : sequence, optional
            Parameters, as `derivatives` of :func:`psf`; by default the keys of ``PSF.derivatives``, or the terms of
            the wavefront if there are none.

        Returns
        -------
        dict of name to ndarray
            Gradient with respect to each parameter, with the shape of the pupil.

        Raises
        ------
        TypeError, ValueError
            If `g` is not real and finite or has the wrong shape, or if a derivative is not supported.
        ToleranceError
            If the tolerance of the method cannot be met.
        """
        if self.blur or not self.grid.square:
            raise ValueError("derivatives need square pixels without fill and blur; compute the PSF without them")
        names = tuple(self.derivatives) or None if of is None else question.names(of, "of")
        weights = validation.real_array("g", g)
        if weights.shape != self.shape:
            raise ValueError(f"g must have the shape of the values, {self.shape}, got {weights.shape}")
        if self.normalize == "peak":
            raise ValueError(
                'derivatives need normalize="energy" or "strehl", got "peak", since a maximum over pixels has kinks'
            )
        images, scale = weights.reshape(-1, *self.grid.shape), np.asarray(self.scale).ravel()
        gradient = question.gradient(self.method, self.pupil, self.grid, names, images, scale, self.normalize)
        return {name: slope.reshape(self.pupil.shape) for name, slope in gradient.items()}

    def save(self, path: str | PathLike[str]) -> None:
        """Write ``.tif``, ``.fits``, ``.h5``, ``.mat``, ...; see :func:`lommel.io.psf_files.save`."""
        display.save(self, path)

    @staticmethod
    def measured(
        array: str | PathLike[str] | ArrayLike,
        pixel: float | None = None,
        step: float | None = None,
        *,
        microscope: Any = None,
        diameter: float | None = None,
        background: float | None = None,
    ) -> MeasuredPSF:
        """Return a measured PSF, for deconvolution and deblurring: of beads, a point, or another program.

        Parameters
        ----------
        array : path, array_like or Frames, shape (planes, height, width) or (height, width)
            Stack of one bead, or of a field in which isolated beads are found, as recorded; or a PSF. For photographs
            the image of one point of light, such as a star, in linear light.
        pixel, step : float, optional
            Pixel in the sample and step between planes, metres; by default those of the file. For photographs the
            pixel pitch.
        microscope : Microscope, optional
            Microscope of the beads: its objective states the light of each plane, and the place of the point.
        diameter : float, optional
            Diameter of the beads, metres, which is removed from the PSF.
        background : float, optional
            Background and offset per voxel, 0 for a PSF without them; by default estimated for each bead.

        Returns
        -------
        MeasuredPSF

        Raises
        ------
        TypeError, ValueError
            If an argument is of another type or out of range; if the voxel is not known, no bead has a peak, or more
            than 20 % of the light is on the outermost pixels.

        Notes
        -----
        Beads are found by :func:`lommel.detection.find_spots` in the widest window in which ten are isolated. The
        background of a bead is the one with which its light in and around the middle of all planes is that of one
        point through the objective; without an objective it is the median of the outer pixels of the planes in focus.
        Beads are shifted to their mean by least squares, and averaged. A Wiener filter by the power in rings of equal
        frequencies along z and across removes what is outside of the pass band, negative values are set to 0, and the
        sum is 1. The point is where the PSF of the objective fits best, or at the peak, that of an image in its
        centroid. There is no error bound.

        Examples
        --------
        >>> psf = lm.PSF.measured("beads.tif", microscope=microscope, diameter=1e-7)  # doctest: +SKIP
        >>> found = lm.microscopy.deconvolve("stack.tif", psf)  # doctest: +SKIP
        """
        given = {"microscope": microscope, "diameter": diameter, "background": background}
        result: MeasuredPSF = display.named("measured PSF", "beads")(array, pixel, step, **given)
        return result

    @classmethod
    def load(cls, path: str | PathLike[str]) -> PSF:
        """Read the file at `path`, written by :meth:`save`; ValueError if it is damaged or has another content."""
        psf: PSF = display.named("load PSF", "file")(path, cls)
        return psf

    def plot(self, ax: Axes | None = None, *, stretch: str = "sqrt") -> Axes | NDArray[np.object_]:
        """Draw the PSF with matplotlib (sections of a z stack); return the axes, for a stack an array of axes.

        See :func:`lommel.show.plot.plot`.
        """
        validation.axes("ax", ax)
        axes: Axes | NDArray[np.object_] = display.plot(self, ax, stretch=stretch)
        return axes

    def plot_mtf(self, ax: Axes | None = None) -> Axes:
        """Draw the modulation transfer functions along x and y, and of the aperture without aberration.

        See :func:`lommel.show.curves.mtf`.
        """
        axes: Axes = display.named("mtf", "plot")(self, ax)
        return axes

    def plot_encircled_energy(self, ax: Axes | None = None) -> Axes:
        """Draw the encircled energy; see :func:`lommel.show.curves.encircled_energy`."""
        axes: Axes = display.named("encircled energy", "plot")(self, ax)
        return axes

    def plot_spots(self, ax: Axes | None = None) -> Axes:
        """Draw the spot diagram over the PSF; see :func:`lommel.show.plot.spots`."""
        axes: Axes = display.named("spots", "plot")(self, ax)
        return axes
