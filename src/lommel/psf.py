"""Point spread functions: :func:`psf` computes one, :class:`Plan` many alike, and :class:`PSF` holds the result."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import lru_cache
from os import PathLike
from typing import TYPE_CHECKING, Any, TypeVar, cast

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from lommel import measures
from lommel.base import display, validation
from lommel.base.arrays import Array, Numbers, Values, largest
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
    from lommel.methods.derivative_names import Name
    from lommel.optics.pupil import FieldPupil, Pupil
    from lommel.traced.traced_psf import TracedPSF


def psf(
    pupil: BasePupil,
    shape: int | tuple[int, int],
    pixel: float | tuple[float, float],
    *,
    method: Method | None = None,
    tol: float | None = None,
    normalize: str = "energy",
    dtype: DTypeLike | None = None,
    center: tuple[ArrayLike, ArrayLike] | None = None,
    integrate: bool | None = None,
    fill: float | tuple[float, float] = 1.0,
    blur: Blur | Sequence[Blur] = (),
    derivatives: Sequence[Name] = (),
    out: Values | None = None,
    threads: int | None = None,
) -> PSF:
    """Compute the point spread function of a pupil.

    Parameters
    ----------
    pupil : Pupil or ObjectivePupil
        Pupil of a lens, or of a microscope (:meth:`lommel.Objective.pupil`). A stack gives a stack of images.
    shape : int or (int, int)
        Side of a square, or height and width, in pixels. The centre is the middle of pixel
        ``(height // 2, width // 2)``.
    pixel : float or (float, float)
        Pixel pitch, or height and width of pixels that are not square, in metres if the pupil has a wavelength, else
        in units of lambda*N.
    method : Method, optional
        How to evaluate the diffraction integral; by default chosen by pupil and window: NijboerZernike for
        circular apertures, ChordalGauss instead where it is likely to take less time for wavefronts that depend on
        the direction, NonuniformFFT for apertures with a spider, vignetting or a mask. `PSF.method` is what was used.
    tol : float, optional
        Tolerance relative to the peak of the PSF, in the window or not, or to the largest value in the window if
        `normalize` is "peak"; by default that of the method, or 1e-6 if no method is given.
    normalize : {"energy", "emitted", "strehl", "peak"}, default "energy"
        "energy": a value is the fraction of all light per pixel: averages over an infinite window sum to 1, and so do
        samples of pixels no larger than lambda*N. "emitted", of an Objective: the same over the light that it would
        collect of the emitter far from the glass. "strehl": 1 is the peak of the same aperture without aberration.
        "peak": the largest value in the window is 1.
    dtype : float32 or float64, optional
        Type of the values; by default that of `out`, else float64 for tolerances below 1e-6 and float32 otherwise.
    center : (float, float) or (array_like, array_like), optional
        Row and column of the optical axis, in pixels from the middle of the first; by default the middle of pixel
        ``(height // 2, width // 2)``. Arrays of rows and columns, broadcast with the stack of pupils, give each pupil
        its own axis (`NijboerZernike`, `ChordalGauss`, a `Polychromatic` of these; of objectives `Stratified`,
        `DebyeRings` and `ChordalDebye`).
    integrate : bool, optional
        True for pixel-integrated values (averages over the area of each pixel), False for point samples at pixel
        centres. By default pixels in metres integrate and pixels in units of lambda*N sample; `Geometric`, which has
        no point values, always integrates. `PSF.sampling` says which.
    fill : float or (float, float), default 1
        Fill factor: the active fraction of the area of a pixel, or of its height and width. Below 1 pixels integrate.
    blur : Blur or sequence of Blur, default ()
        Further blur of lenses, such as :class:`lommel.Seeing` or :class:`lommel.Jitter`; :doc:`/sensor` lists all.
        Without derivatives.
    derivatives : sequence, default ()
        Parameters with respect to which derivatives are computed, for ``PSF.derivatives``. Per radian: "defocus"
        (C_d), "spherical" (C_s), "rho^6", "rho^8", and Zernike terms at the edge as (n, m), "noll 8", "ansi 8" or
        "fringe 7". Per pixel: "row", "column" of the axis. Per metre: "wavelength", of all light in proportion, path
        differences kept; "object_distance", and "focus_distance", for which the sensor moves, of a pupil by
        :meth:`Lens.pupil`. Per 1: "f_number" of the pupil, its phases kept; "obscuration". Of round apertures, by
        `ChordalGauss`, of radially symmetric pupils all but other terms and the obscuration by `NijboerZernike`; of
        any aperture all but the obscuration, and the wavelength where segments have phases, by `NonuniformFFT`; or
        by a `Polychromatic` of these; and not of "peak". Of an Objective, by `Stratified`, `ChordalDebye` or, with
        aberrations, `DebyeRings`: per metre "z" (of the stage), "depth" (the stage at rest) and "wavelength" (the
        stage, all indices, the pixel in metres and path differences of aberrations as they are); "row", "column"; and
        Zernike terms. The last, and with aberrations the wavelength, by `ChordalDebye` in small windows only. `tol`
        is that of the values, which may differ from those without derivatives within their bound;
        ``PSF.derivative_bounds`` says what derivatives are off by.
    out : ndarray, shape ``pupil.shape + (height, width)``, optional
        C-contiguous, writable array for the values.
    threads : int, optional
        Maximum number of threads; by default the number of processors, which all calls share.

    Returns
    -------
    PSF
        With ``values`` of shape ``pupil.shape + (height, width)``, the stack broadcast with the places in `center`.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, if the method does not support the pupil or has no tolerance to be named, if
        the answer would exceed 2^31 values, or if float32 is asked for with a tolerance that it cannot hold (below
        2.4e-7).
    ToleranceError
        If the method cannot meet its tolerance.

    Examples
    --------
    >>> import lommel as lm
    >>> answer = lm.psf(lm.Pupil(lm.Wavefront(defocus=10.0, spherical=3.0)), shape=512, pixel=0.25)
    >>> answer.values.shape
    (512, 512)
    """
    # The type of the array that values go to decides, so that callers need not give it twice.
    if out is not None and dtype is None:
        dtype = question.array("out", out).dtype
        if dtype != np.float32 and dtype != np.float64:
            validation.kind("out.dtype", dtype, np.float32, np.float64)  # says so by the name that was given
    imaged(pupil)  # first, for whoever mixes up the order
    # Plans of the last calls are kept: calls with the same options pay for checks and tables once.
    options: dict[str, Any] = {"method": method, "tol": tol, "normalize": normalize, "dtype": dtype}
    options |= {"integrate": integrate, "threads": threads}
    prepared = None
    usual = type(fill) is float and fill == 1.0 and isinstance(blur, tuple) and not blur
    # 1 and True are equal, and only one is a number: of what is within a tuple, keys do not tell.
    plain = center is None or (type(center) is tuple and all(type(part) in _NUMBERS for part in center))
    if usual and plain and type(shape) is int:
        with suppress(TypeError):  # what cannot be a key, or is refused: by the line below, with its own words
            prepared = _kept(shape, pixel, center=center, **options)
    if prepared is None:
        prepared = Plan(shape, pixel, center=center, fill=fill, blur=blur, **options)
    return prepared(pupil, derivatives=derivatives, out=out)


class Plan:
    """A prepared computation of PSFs for many pupils, one after the other; the options are checked once.

    Called with a pupil, it returns the same as :func:`psf`. After the first call with `out` no image is allocated,
    and no table is built while the caches hold those of the last calls.

    Parameters
    ----------
    shape, pixel, method, tol, normalize, center, integrate, fill, blur, threads
        As of :func:`psf`.
    dtype : float32 or float64, optional
        Type of the values, which `out` must have; by default float64 for tolerances below 1e-6 and float32 otherwise.

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
        method: Method | None = None,
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
            from lommel.blur.blurs import blurs  # few images have any

            self.blur = blurs(blur)
        # Which of the two a pupil is recorded on, its unit decides.
        self._averaged = Grid(shape, pixel, center=center, integrate=True, fill=fill)
        # Pixels with a fill factor below 1 always average.
        self._sampled = self._averaged if self._averaged.partly else self._averaged.sampled
        if integrate is False and self._averaged.partly:
            raise ValueError(f"integrate must not be False with fill={validation.shown(fill)}: samples have no area")
        self._places = self._sampled.stack
        # Whether methods take pixels and light as they are.
        self.plain = self._averaged.square and not self.blur
        self.method, self.tol = method, tol
        self.normalize = validation.choice("normalize", normalize, ("energy", "emitted", "strehl", "peak"))
        self.dtype = question.output_type(dtype, tol)
        self.threads = 0 if threads is None else validation.integer("threads", threads, least=1, most=1024)
        self._asked: Prepared | None = None

    def __call__(self, pupil: BasePupil, *, derivatives: Sequence[Name] = (), out: Values | None = None) -> PSF:
        """Compute the PSF of `pupil`; see :func:`psf`."""
        pupil = imaged(pupil)
        if not pupil.one_aperture:
            return self._one_by_one(cast("FieldPupil", pupil), derivatives, out)
        if self._places:
            pupil = question.for_axes(pupil, self._places)
        if not self.plain:
            return self._spread(pupil, derivatives, out)
        # What checks, methods and tables depend on; pupils of a fit or a stack differ in their phase alone.
        light = pupil.aperture, pupil.radial, pupil.shape, pupil.wavelength, pupil.f_number
        asked = self._asked
        if asked is None or asked.light != light:
            asked = self._asked = prepare(
                pupil, light, self.grid(pupil), self.method, self.tol, self.normalize, self.dtype, self.threads
            )
        _, grid, ways, _, _, _, shape, _, shortcut = asked
        names = () if isinstance(derivatives, tuple) and not derivatives else question.names(derivatives)
        if names and self.normalize == "peak":
            raise ValueError('derivatives need normalize="energy" or "strehl", not "peak", which has kinks')
        found = None
        if shortcut is not None and not names and (out is None or isinstance(out, np.ndarray)):
            values = np.empty(shape, self.dtype) if out is None else out
            try:
                found = shortcut(pupil, values)
            except (Declined, ToleranceError):
                if len(ways) == 1:
                    raise
                asked = asked._replace(methods=ways[1:])  # which the next method answers
        if found is None:
            return self._computed(asked, pupil, names, out)
        (scale, error), method = found, ways[0].reported
        # The parts have been checked: the initializer would take a tenth of the time of a small image.
        psf = object.__new__(PSF)
        parts = psf.__dict__
        parts["values"], parts["grid"], parts["pupil"], parts["method"] = values, grid, pupil, method
        parts["normalize"], parts["error_bound"], parts["scale"] = self.normalize, error, scale
        parts["derivatives"], parts["derivative_bounds"], parts["blur"] = {}, {}, ()
        return psf

    def _computed(self, asked: Prepared, pupil: BasePupil, names: tuple[Name, ...], out: Values | None) -> PSF:
        """Return a PSF, with derivatives by checked names, where no shortcut answers."""
        place = None if out is None else question.place(out, asked.shape, self.dtype)
        method, made, slopes = asked.images(pupil, names, place)
        psf = object.__new__(PSF)  # as above
        psf.__dict__.update(
            values=made.values.reshape(asked.shape) if place is None else place,
            grid=asked.grid,
            pupil=pupil,
            method=method,
            normalize=self.normalize,
            error_bound=None if made.error is None else largest(made.error),
            scale=made.scale.reshape(pupil.shape),
            derivatives={n: slope.values.reshape(asked.shape) for n, slope in zip(names, slopes, strict=True)},
            derivative_bounds={n: largest(slope.error) for n, slope in zip(names, slopes, strict=True)},
            blur=(),
        )
        return psf

    def _spread(self, pupil: BasePupil, derivatives: Sequence[Name], out: Values | None) -> PSF:
        from lommel.blur.recorded import recorded

        if question.names(derivatives):
            raise ValueError("derivatives need square pixels without fill and blur; take differences of such images")
        settings = self.method, self.tol, self.normalize, self.dtype, self.threads
        return PSF(**recorded(pupil, self.grid(pupil), self.blur, settings, out))

    def _one_by_one(self, pupil: FieldPupil, derivatives: Sequence[Name], out: Values | None) -> PSF:
        """Return the stack of PSFs of pupils whose apertures differ."""
        if question.names(derivatives):
            raise ValueError(
                "derivatives need one aperture: compute each position by itself where vignetting changes it"
            )
        if self._places:
            raise ValueError("center must be one for a stack whose apertures differ; compute each position by itself")
        shape = (*pupil.shape, *self._sampled.shape)
        place = np.empty(shape, self.dtype) if out is None else question.place(out, shape, self.dtype)
        # One plan serves them one by one, each with its own aperture.
        windows = place.reshape(-1, *self._sampled.shape)
        found = [self(one, out=window) for one, window in zip(pupil.pupils, windows, strict=True)]
        # A stack has a bound if all of its images have one.
        bounds = [one.error_bound for one in found if one.error_bound is not None]
        return replace(
            next((one for one in found if not one.pupil.circular), found[0]),  # whose method stands for all
            values=place,
            pupil=pupil,
            error_bound=max(bounds) if len(bounds) == len(found) else None,
            scale=np.reshape([float(one.scale) for one in found], pupil.shape),
        )

    def __getstate__(self) -> dict[str, object]:
        # Without what is remembered of the last pupil, which the compiled core has a part in.
        return vars(self) | {"_asked": None}

    def grid(self, pupil: BasePupil) -> Grid:
        """Return the grid of pixels for `pupil`, in metres or in units of lambda*N."""
        averages = self.integrate
        if averages is None:
            # Pixels in metres are those of a camera, which average.
            metric = pupil.wavelength is not None
            averages = metric or (self.method is not None and self.method.sampling == "pixel")
        return self._averaged if averages else self._sampled

    def traced(
        self, pupil: Pupil, xp: ModuleType | str | None = None, *, device: object = None, precision: str = "auto"
    ) -> TracedPSF:
        """Return the plan as a differentiable function of coefficients, in JAX, PyTorch or any array API.

        Parameters
        ----------
        pupil : Pupil
            A stack whose coefficients define the valid range: for radially symmetric pupils the box around them; for
            others coefficients no larger than those of a member. Aperture, amplitude and lengths are those of the
            stack.
        xp : module or str, optional
            ``jax.numpy``, ``torch``, ``cupy``, ``numpy`` or another of the array API, or its name; NumPy by default.
        device : optional
            Device of the framework for tables and coefficients.
        precision : {"auto", "float64", "float32"}, default "auto"
            Type of the computation: by default float64 if the framework has it. In float32 no error of 1e-6 can be
            proven.

        Returns
        -------
        TracedPSF
            A function ``images = f(c)``; c has the shape (..., k), with a column for each of ``f.terms``, radians.

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
            raise ValueError("pixel must be one number for a traced plan, and fill and blur left out")
        if isinstance(pupil, BasePupil) and pupil.layered:
            raise TypeError(
                "pupil must be that of a lens for a traced plan, got that of an Objective; PSF.pullback has the "
                "gradient of a loss by its aberrations, stage and depth"
            )
        grid = self.grid(checked(pupil))
        values = self.tol, self.normalize, str(self.dtype)
        return traced_psf.traced(pupil, grid, self.method, values, (xp, device, precision))


# Calls like the last ones take the plans of these, types and all.
_kept = lru_cache(maxsize=64, typed=True)(Plan)
_NUMBERS = (float, int)


Found = TypeVar("Found")


class Measured:
    """Image quality measures of a PSF, of the optics with blur and pixels.

    They are computed from the transfer function, and so do not depend on the window or the sampling, only on the
    pixel as part of the image, unless ``of="optics"``. Arrays have the shape of the stack of pupils, then an axis of
    channels, if any, then that of the argument. Errors are stated in the functions that each method links.
    """

    def measured(self, measure: Callable[[PSF], Found]) -> Found:
        """Return the `measure` of each PSF."""
        raise NotImplementedError

    @property
    def energy(self) -> Numbers:
        """Fraction of all light that falls inside the window, to the edges of its outer pixels."""
        return self.measured(measures.energy.window_energy)

    @property
    def strehl(self) -> Numbers:
        """Strehl ratio: intensity on the axis relative to that without aberration; see :func:`lommel.strehl`."""
        return self.measured(measures.spot.axis_strehl)

    @property
    def peak_strehl(self) -> Numbers:
        """Largest value in the window, relative to the peak of the same aperture without aberration."""
        return self.measured(measures.spot.peak_strehl)

    @property
    def peak_position(self) -> NDArray[np.float64]:
        """Position (x, y) of the largest value, from the axis; see :func:`lommel.measures.spot.peak_position`."""
        return self.measured(measures.spot.peak_position)

    @property
    def centroid(self) -> NDArray[np.float64]:
        """Centroid (x, y) of all light, from the axis; see :func:`lommel.measures.energy.image_centroid`."""
        return self.measured(measures.energy.image_centroid)

    def encircled_energy(self, radius: ArrayLike, *, about: str = "axis", of: str = "image") -> Numbers:
        """Return the fraction of all light within `radius` (metres or lambda*N) of the axis, or `about` the centroid.

        Of the image, or `of` the "optics" without the pixel; also beyond the window. See
        :func:`lommel.measures.energy.encircled_energy`.
        """
        return self.measured(lambda one: measures.energy.encircled_energy(one, radius, about=about, of=of))

    def ensquared_energy(self, half_width: ArrayLike, *, about: str = "axis", of: str = "image") -> Numbers:
        """Return the fraction of all light within a square of sides ``2 half_width``.

        `about` the axis or the centroid, `of` the image or the optics: see
        :func:`lommel.measures.energy.ensquared_energy`.
        """
        return self.measured(lambda one: measures.energy.ensquared_energy(one, half_width, about=about, of=of))

    def energy_diameter(self, fraction: float, *, about: str = "axis", of: str = "image") -> Numbers:
        """Return the diameter of the circle that holds `fraction` of all light: 0.5 for D50, 0.8 for D80.

        `about` the axis or the centroid, `of` the image or the optics: see
        :func:`lommel.measures.spot.energy_diameter`.
        """
        return self.measured(lambda one: measures.spot.energy_diameter(one, fraction, about=about, of=of))

    def fwhm(self, along: str = "mean", *, of: str = "image") -> Numbers:
        """Return the full width at half maximum along "x", "y" or their mean, of the image or `of` the optics.

        See :func:`lommel.measures.spot.fwhm`.
        """
        return self.measured(lambda one: measures.spot.fwhm(one, along, of=of))

    def otf(self, fx: ArrayLike, fy: ArrayLike = 0.0, *, of: str = "image") -> NDArray[np.complex128] | np.complex128:
        """Return the optical transfer function of the image, or `of` the optics, at frequencies `fx`, `fy`.

        For lenses from the wavefront, also beyond the Nyquist frequency of the pixels: see :func:`lommel.otf`. The
        transform of the values themselves is :func:`lommel.measures.transfer.sampled_otf`.
        """
        return self.measured(lambda one: measures.transfer.image_otf(one, fx, fy, of=of))

    def mtf(self, fx: ArrayLike, fy: ArrayLike = 0.0, *, of: str = "image") -> Numbers:
        """Return the modulation transfer function, the modulus of :meth:`otf`, at `fx`, `fy`, `of` the same."""
        return np.abs(self.otf(fx, fy, of=of))


@dataclass(frozen=True, eq=False, repr=False)
class PSF(Measured, PSFLike, display.Shown):
    """A computed point spread function (PSF), or a stack of them, with its pupil, grid, method and error bound.

    Attributes
    ----------
    values : ndarray, shape ``pupil.shape + (height, width)``
        float32 or float64; see :attr:`sampling`.
    grid : Grid
        The pixels.
    pupil : Pupil
    method : Method
    normalize : str
        "energy", "emitted", "strehl" or "peak", as of :func:`psf`.
    error_bound : float or None
        Bound on the largest error relative to the peak of the PSF, in the window or not ("peak": to the largest value
        in the window), the largest of the stack; None if the method has none. The peak of a pixel-integrated PSF is
        the largest average over a pixel of this size anywhere, which may exceed all pixels of the image (up to 3.8
        times for coarse pixels with the axis at a corner).
    scale : ndarray, shape ``pupil.shape``
        Factor by which the intensity was multiplied, which is 1 at the peak without obscuration and aberration.
    derivatives : dict of (str or (int, int)) to ndarray
        Derivatives of the values with respect to the requested parameters, each of the shape of the values.
    derivative_bounds : dict of (str or (int, int)) to float
        Bounds on their errors relative to the peak of the values, the largest of the stack, in the unit of each.
    blur : tuple of Blur
        Blur besides the diffraction of the pupil.

    Raises
    ------
    TypeError, ValueError
        If a part is of another type, or the values are not of its shape.
    """

    pupil_hint = "a PSF; psf.pupil is its pupil, and psf.mtf(fx, fy) and psf.otf(fx, fy) are those of the image"
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
        # Files make PSFs too, so that all parts are checked.
        wanted = self.pupil.shape + self.grid.shape
        if not isinstance(self.values, np.ndarray) or self.values.dtype not in (np.float32, np.float64):
            raise TypeError(f"values must be an array of float32 or float64, got {validation.shown(self.values)}")
        if self.values.shape != wanted:
            raise ValueError(f"values must have the shape {wanted}, got {self.values.shape}")

    def __len__(self) -> int:
        """Return how many PSFs, or stacks of them, the first axis of a stack holds."""
        if self.pupil.shape == ():
            raise TypeError("a single PSF has no length; its pixels are in `values`")
        return self.pupil.shape[0]

    def __bool__(self) -> bool:
        """Return True, whether it has a length or not."""
        return True

    def __repr__(self) -> str:
        bound = "none" if self.error_bound is None else f"{self.error_bound:.2g}"
        pixel = pitch_in_words(self.grid.pixel) if self.unit == "m" else f"{self.grid.named} {self.unit}"
        how = "averaged over pixels" if self.grid.integrate else "sampled at pixel centres"
        how += "".join(f", {type(blur).__name__}" for blur in self.blur)
        # Samples farther apart than lambda*N do not sum to the light.
        if not self.sum_is_light:
            sums = self.values.sum(axis=(-2, -1), dtype=np.float64)
            how += f", which sum to {' to '.join(f'{s:.3g}' for s in sorted({float(sums.min()), float(sums.max())}))}"
        return (
            f"<{type(self).__name__} {'x'.join(map(str, self.shape))} {self.values.dtype}, "
            f"pixel {pixel}, {how}, {type(self.method).__name__}, "
            f"normalize {self.normalize!r}, error bound {bound}>"
        )

    def measured(self, measure: Callable[[PSF], Found]) -> Found:
        """Return the `measure` of this PSF."""
        return measure(self)

    @property
    def z(self) -> NDArray[np.float64]:
        """Stage position of each plane of a stack over z, metres; see :func:`lommel.measures.spot.stage`."""
        return measures.spot.stage(self)

    def axial_fwhm(self, *, of: str = "image") -> Numbers:
        """Return the full width at half maximum along z, metres of the stage, `of` the image or of the "optics".

        See :func:`lommel.measures.spot.axial_fwhm`.
        """
        return measures.spot.axial_fwhm(self, of=of)

    def pullback(self, g: ArrayLike, of: Sequence[Name] | None = None) -> dict[Name, NDArray[np.float64]]:
        """Return the gradient of a loss from its derivative with respect to the values (reverse mode).

        ``sum g * derivative`` over pixels. Derivatives by phase coefficients and shifts are computed in reverse mode,
        by a transform to the pupil: they cost about two images, for any number of parameters. So are those of an
        Objective with aberrations by the stage and the depth, in windows that :class:`lommel.ChordalDebye` takes; all
        others, and those of radially symmetric pupils, are computed in forward mode.

        Parameters
        ----------
        g : array_like
            Of the shape of the values.
        of : sequence, optional
            As `derivatives` of :func:`psf`; by default the names of `derivatives`, or the terms of the
            wavefront.

        Returns
        -------
        dict of name to ndarray
            Of the shape of the pupil.

        Raises
        ------
        TypeError, ValueError
            If `g` is not real and finite or of another shape, or where there are no such derivatives.
        ToleranceError
            If the tolerance of the method cannot be met.
        """
        if self.blur or not self.grid.square:
            raise ValueError("psf must have square pixels without fill and blur for its derivatives, got others")
        names = tuple(self.derivatives) or None if of is None else question.names(of, "of")
        weights = validation.real_array("g", g)
        if weights.shape != self.shape:
            raise ValueError(f"g must have the shape of the values, {self.shape}, got {weights.shape}")
        if self.normalize == "peak":
            raise ValueError(
                'of a PSF with normalize="peak" there are no derivatives, since it has kinks; use "energy"'
            )
        images, scale = weights.reshape(-1, *self.grid.shape), np.asarray(self.scale).ravel()
        found = question.gradient(self.method, self.pupil, self.grid, names, images, scale, self.normalize)
        return {name: slope.reshape(self.pupil.shape) for name, slope in found.items()}

    def save(self, path: str | PathLike[str]) -> None:
        """Write ``.tif``, ``.fits``, ``.h5``, ``.mat``, ``.raw``, ...; see :func:`lommel.io.psf_files.save`."""
        display.save(self, path)

    @classmethod
    def load(cls, path: str | PathLike[str]) -> PSF:
        """Read a file, `path`, that :meth:`save` wrote; ValueError if it is damaged or not such a file."""
        found: PSF = display.named("load PSF", "file")(path, cls)
        return found

    def plot(self, ax: Axes | None = None, *, stretch: str = "sqrt") -> Axes | NDArray[np.object_]:
        """Draw the PSF with matplotlib and return the axes, an array of them for a stack; sections for a z stack.

        See :func:`lommel.show.plot.plot`.
        """
        validation.axes("ax", ax)
        axes: Axes | NDArray[np.object_] = display.plot(self, ax, stretch=stretch)
        return axes

    def plot_mtf(self, ax: Axes | None = None) -> Axes:
        """Draw the modulation transfer function along x and y, beside that of the aperture without aberration.

        See :func:`lommel.show.curves.mtf`.
        """
        axes: Axes = display.named("mtf", "plot")(self, ax)
        return axes

    def plot_encircled_energy(self, ax: Axes | None = None, *, radius: float | None = None) -> Axes:
        """Draw the encircled energy up to a `radius`; see :func:`lommel.show.curves.encircled_energy`."""
        axes: Axes = display.named("encircled energy", "plot")(self, ax, radius=radius)
        return axes

    def plot_spots(self, ax: Axes | None = None, *, rings: int = 12, stretch: str = "sqrt") -> Axes:
        """Draw the spot diagram over the PSF; see :func:`lommel.show.plot.spots`."""
        axes: Axes = display.named("spots", "plot")(self, ax, rings=rings, stretch=stretch)
        return axes
