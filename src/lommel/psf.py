"""The one front door, :func:`psf`, and its answer, :class:`PSF`."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import lru_cache
from os import PathLike
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from lommel import measures
from lommel.base import validation
from lommel.base.arrays import Numbers, largest
from lommel.core.answers import Declined, ToleranceError
from lommel.measured import Measured
from lommel.methods import question
from lommel.methods.method import Method
from lommel.methods.question import Asked, asked_about
from lommel.optics.base_pupil import BasePupil, imaged
from lommel.optics.grid import Grid
from lommel.show.pictured import Pictured
from lommel.traced.door import Traceable

if TYPE_CHECKING:
    from lommel.blur.blurs import Blur
    from lommel.methods.derivative_names import Name


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
    out: NDArray[Any] | None = None,
    threads: int | None = None,
) -> PSF:
    """Compute the point spread function of a pupil.

    Parameters
    ----------
    pupil : Pupil or ObjectivePupil
        Of a lens, or of a microscope by :meth:`lommel.Objective.pupil`. A stack of pupils gives a stack of images.
    shape : int or (int, int)
        Side of a square, or height and width, in pixels. The centre is the middle of pixel
        ``(height // 2, width // 2)``.
    pixel : float or (float, float)
        Pixel pitch, or height and width of pixels that are not square, in metres if the pupil has a wavelength, else
        in units of lambda*N.
    method : Method, optional
        How to evaluate the diffraction integral; by default what serves the pupil and the window: NijboerZernike for
        circular apertures, ChordalGauss instead for small windows of wavefronts that depend on the direction,
        NonuniformFFT for apertures with a spider, vignetting or a mask. `PSF.method` is the one used.
    tol : float, optional
        Tolerance, relative to the peak: 1e-6 by default where no method is named, else that of the method, in place
        of which it is taken.
    normalize : {"energy", "emitted", "strehl", "peak"}, default "energy"
        "energy": a value is the fraction of all light per pixel: averages over an infinite window sum to 1, and so do
        samples of pixels no larger than lambda*N/2. "emitted", of an Objective: the same over the light that it would
        collect of the emitter far from the glass. "strehl": 1 is the peak of the same aperture without aberration.
        "peak": the largest value in the window is 1.
    dtype : float32 or float64, optional
        Of the values. By default that of `out`, or float64 where the method has a tolerance below 1e-6, else
        float32.
    center : (float, float) or (array_like, array_like), optional
        Row and column of the optical axis, in pixels, 0 being the middle of the first; by default the middle of
        pixel ``(height // 2, width // 2)``. Arrays of rows and of columns, which broadcast with the stack of pupils,
        have a place for each, as `NijboerZernike`, `ChordalGauss` and a `Polychromatic` of these take them.
    integrate : bool, optional
        True: average the intensity over the area of each pixel, as a sensor does; False: sample it at the centre. By
        default a pixel in metres averages and one in units of lambda*N samples; `Geometric`, which has no point
        values, always averages. `PSF.sampling` says which.
    fill : float or (float, float), default 1
        The part of its area that a pixel averages over, or those of height and width; not 1, it averages.
    blur : Blur or sequence of Blur, default ()
        What spreads the light of lenses further: :class:`lommel.Seeing`, :class:`lommel.Jitter`,
        :class:`lommel.Motion`, :class:`lommel.ChargeDiffusion`. Without derivatives.
    derivatives : sequence, default ()
        By what the values are differentiated, into ``PSF.derivatives``. Per radian: "defocus" (C_d), "spherical"
        (C_s), "rho^6", "rho^8", and Zernike terms at the edge as (n, m), "noll 8", "ansi 8" or "fringe 7". Per pixel:
        "row", "column" of the axis. Per metre: "wavelength", of all light in proportion, path differences kept;
        "object_distance", and "focus_distance", for which the sensor moves, of a pupil by :meth:`Lens.pupil`. Per 1:
        "f_number" of the pupil, its phases kept; "obscuration". Of round apertures, by `ChordalGauss`, of radially
        symmetric pupils all but other terms and the obscuration by `NijboerZernike`, or by a `Polychromatic` of
        these; and not of "peak". Of an Objective, by `Stratified` or, with aberrations, `DebyeRings`: per metre "z"
        (of the stage), "depth" (the stage at rest) and, without aberrations, "wavelength" (the stage, all indices and
        the pixel in metres as they are); "row", "column".
    out : ndarray, shape ``pupil.shape + (height, width)``, optional
        A C-contiguous, writable array to put the values in.
    threads : int, optional
        At most so many threads; by default as many as there are processors. All calls together never use more
        helper threads than there are further processors.

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
    if out is not None and dtype is None:
        dtype = question.array("out", out).dtype
    imaged(pupil)  # first, for whoever mixes up the order
    options: dict[str, Any] = {"method": method, "tol": tol, "normalize": normalize, "dtype": dtype}
    options |= {"integrate": integrate, "threads": threads}
    prepared = None
    usual = center is None and type(fill) is float and fill == 1.0 and isinstance(blur, tuple) and not blur
    if usual and type(shape) is int:
        with suppress(TypeError):  # what cannot be a key, or is refused: by the line below, with its own words
            prepared = _kept(shape, pixel, **options)
    if prepared is None:
        prepared = Plan(shape, pixel, center=center, fill=fill, blur=blur, **options)
    return prepared(pupil, derivatives=derivatives, out=out)


class Plan(Traceable):
    """A question asked of many pupils, one after the other: everything but the pupil is checked once.

    Called with a pupil, it answers as :func:`psf` would. After the first call with `out` nothing large is allocated
    and no table is built: tables are kept by the compiled core.

    Parameters
    ----------
    shape, pixel, method, tol, normalize, dtype, center, integrate, fill, blur, threads
        As of :func:`psf`.

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
        method, tol = question.way(method, tol, integrate)
        self.integrate = integrate
        self.blur: tuple[Blur, ...] = ()
        if not isinstance(blur, tuple) or blur:
            from lommel.blur.blurs import blurs  # few images have any

            self.blur = blurs(blur)
        # Which of the two a pupil is recorded on, its unit decides.
        self._averaged = Grid(shape, pixel, center=center, integrate=True, fill=fill)
        self._sampled = self._averaged if self._averaged.partly else Grid(shape, pixel, center=center)
        if integrate is False and self._averaged.partly:
            raise ValueError(f"integrate must not be False with fill={validation.shown(fill)}: samples have no area")
        self._places = self._sampled.stack
        # Whether methods take pixels and light as they are.
        self.plain = self._averaged.square and not self.blur
        self.method, self.tol = method, tol
        self.normalize = validation.choice("normalize", normalize, ("energy", "emitted", "strehl", "peak"))
        self.dtype = question.output_type(dtype, tol)
        self.threads = 0 if threads is None else validation.integer("threads", threads, least=1, most=1024)
        self._asked: Asked | None = None

    def __call__(self, pupil: BasePupil, *, derivatives: Sequence[Name] = (), out: NDArray[Any] | None = None) -> PSF:
        """Compute the PSF of `pupil`; see :func:`psf`."""
        if self._places:
            pupil = question.for_axes(imaged(pupil), self._places)
        if not self.plain:
            return self._spread(imaged(pupil), derivatives, out)
        light = imaged(pupil).aperture, pupil.radial, pupil.shape, pupil.wavelength, pupil.f_number
        asked = self._asked
        if asked is None or asked.light != light:
            asked = self._asked = asked_about(
                pupil, light, self.grid(pupil), self.method, self.tol, self.normalize, self.dtype, self.threads
            )
        _, grid, ways, _, _, _, shape, _, shortcut = asked
        names = () if derivatives is _NONE else question.names(derivatives)
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
                asked = asked._replace(ways=ways[1:])  # which the next method answers
        slopes: dict[Name, NDArray[Any]] = {}
        slope_bounds: dict[Name, float] = {}
        error: float | None
        if found is not None:
            method, (scale, error) = ways[0], found
        else:
            place = None if out is None else question.place(out, shape, self.dtype)
            method, made, found_slopes = asked.images(pupil, names, place)
            values = made.values.reshape(shape) if place is None else place
            scale, error = made.scale.reshape(pupil.shape), None if made.error is None else largest(made.error)
            for name, slope in zip(names, found_slopes, strict=True):
                slopes[name], slope_bounds[name] = slope.values.reshape(shape), largest(slope.error)
        answer: Any = _Draft()
        answer.values, answer.grid, answer.pupil, answer.method = values, grid, pupil, method
        answer.normalize, answer.error_bound, answer.scale = self.normalize, error, scale
        answer.derivatives, answer.derivative_bounds, answer.blur = slopes, slope_bounds, ()
        answer.__class__ = PSF
        done: PSF = answer
        return done

    def _spread(self, pupil: BasePupil, derivatives: Sequence[Name], out: NDArray[Any] | None) -> PSF:
        from lommel.blur.recorded import recorded

        if question.names(derivatives):
            raise ValueError("derivatives need square pixels without fill and blur; take differences of such images")
        settings = self.method, self.tol, self.normalize, self.dtype, self.threads
        return PSF(**recorded(pupil, self.grid(pupil), self.blur, settings, out))

    def __getstate__(self) -> dict[str, Any]:
        # Without what is remembered of the last pupil, which the compiled core has a part in.
        return vars(self) | {"_asked": None}

    def grid(self, pupil: BasePupil) -> Grid:
        """Return the pixels that `pupil` is recorded on, whose unit decides between the two."""
        averages = self.integrate
        if averages is None:
            metric = pupil.wavelength is not None
            averages = metric or (self.method is not None and self.method.sampling == "pixel")
        return self._averaged if averages else self._sampled


_NONE: tuple[Name, ...] = ()  # which there is one of


class _Draft:
    """A PSF while it is made, of parts that were checked: to fill in what is frozen takes a tenth of a small one."""


# Calls like the last ones take the plans of these, types and all: 1 and True are equal, and only one is a number.
_kept = lru_cache(maxsize=16, typed=True)(Plan)


@dataclass(frozen=True, init=False, eq=False, repr=False)
class PSF(Measured, Pictured):
    """A computed point spread function, or a stack of them, and how it was made.

    Attributes
    ----------
    values : ndarray, shape ``pupil.shape + (height, width)``
        float32 or float64; see :attr:`sampling`.
    grid : Grid
        The pixels.
    pupil : Pupil
    method : Method
    normalize : str
        "energy", "strehl" or "peak".
    error_bound : float or None
        Bound on the largest error over the peak, the largest of the stack; None where the method has none.
    scale : ndarray, shape ``pupil.shape``
        What the intensity (1 for the unobscured, unaberrated peak) was multiplied by.
    derivatives : dict of (str or (int, int)) to ndarray
        Derivatives of the values that were asked for, under the same names, each of the shape of the values.
    derivative_bounds : dict of (str or (int, int)) to float
        Bounds on their errors over the peak of the values, the largest of the stack, in the unit of each.
    blur : tuple of Blur
        What spreads the light beside the pupil.

    Raises
    ------
    TypeError, ValueError
        If a part is of another type, or the values are not of its shape.
    """

    def measured(self, measure: Callable[[PSF], Any]) -> Any:
        """Return a `measure` of this PSF; see :class:`lommel.measured.Measured`."""
        return measure(self)

    @property
    def z(self) -> NDArray[np.float64]:
        """Where the stage is in each plane of a stack over z, metres; see :func:`lommel.measures.axial.stage`."""
        return measures.axial.stage(self)

    def axial_fwhm(self, *, of: str = "image") -> Numbers:
        """Return the width at half along z, metres of the stage, `of` the image or the optics without the pixel.

        See :func:`lommel.measures.axial.axial_fwhm`.
        """
        return measures.axial.axial_fwhm(self, of=of)

    def pullback(self, g: ArrayLike, of: Sequence[Name] | None = None) -> dict[Name, NDArray[np.float64]]:
        """Return the gradient of a number from its derivative `g` by the values; see `derivatives` of :func:`psf`.

        Those by the wavefront and the axis cost two images or so, whatever their number; see
        :func:`lommel.measures.pullback.pullback`.
        """
        return measures.pullback.pullback(self, g, of)

    def save(self, path: str | PathLike[str]) -> None:
        """Write ``.tif``, ``.fits``, ``.h5``, ``.mat``, ``.raw``, ...; see :func:`lommel.io.psf_files.save`."""
        from lommel.io import psf_files  # takes as long to import as all that computes

        psf_files.save(self, path)

    @classmethod
    def load(cls, path: str | PathLike[str]) -> PSF:
        """Read a file, `path`, that :meth:`save` wrote; ValueError if it is damaged or another."""
        from lommel.io import psf_files

        return psf_files.load(path, cls)
