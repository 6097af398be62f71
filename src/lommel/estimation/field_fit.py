"""Field maps from stars: wavefronts over the sensor as polynomials of the position, with standard errors."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from dataclasses import field as attribute
from os import PathLike
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel import show
from lommel.base import validation
from lommel.base.arrays import Array
from lommel.base.options import listed
from lommel.base.units import ARCSEC, format_length, with_error
from lommel.blur.blurs import FWHM, Blur, Jitter, Motion, Seeing, blurs, require_unit
from lommel.blur.mixtures import SIGMAS, BlurProfile
from lommel.detection.targets import Targets
from lommel.estimation import EFFORT, Effort
from lommel.estimation.cosmic_rays import cosmic_ray_mask, sharpness
from lommel.estimation.distortion import (
    Distortion,
    Sensor,
    checked_ideal,
    displacement_at,
    fit_distortion,
    places_of,
)
from lommel.estimation.favoured_effects import opened, unsure
from lommel.estimation.field_search import Outcome, Search, Solution, differences, estimated_effects, trails_of
from lommel.estimation.field_signs import highest_degree, monomials, with_errors
from lommel.estimation.field_stars import FieldStars
from lommel.estimation.options import FieldFitOptions
from lommel.estimation.star_checks import missing_findings
from lommel.estimation.star_images import MAX_LINEAR_ERROR, Unknowns, known_defocus, label, single, too_dim_findings
from lommel.estimation.target_readout import Target, relative_light
from lommel.field.maps import FieldMap, save_table
from lommel.fit.findings import Finding, Findings, FitReport, Severity
from lommel.fit.goodness_of_fit import stripe_findings
from lommel.fit.model_error import covered
from lommel.fit.scoring import Progress
from lommel.methods.derivative_names import Name, Term, term_of
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import Plan
from lommel.recorded.counts import Counts, counts_of, recording_findings
from lommel.recorded.noise import Noise
from lommel.special import zernike

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_DISTORTION = 3  # default degree of the polynomials of the distortion
_MAX_SIDE = 10**6  # largest number of rows or columns of a sensor
_AXES = "rows", "columns"
_MAX_SEARCHES = 3  # maximum number of searches, each with other random starts, until one converges
_MAX_LISTED = 3  # maximum number of rejected stars whose places a message lists
_MIN_GAIN = 2.0  # difference of log-likelihood (lnL) below which two shapes of blur are considered equally likely
_SIGN = "images at a single defocus do not determine the common sign of all even terms"


class Coma(NamedTuple):
    """Coma (radians rms), its standard error, and the angle of its axis, degrees, from the x axis towards y."""

    rms: float
    error: float
    degrees: float


class FocusShift(NamedTuple):
    """Distance of the sensor from focus (metres, positive towards the lens), standard error, and sign ambiguity."""

    shift: float
    error: float
    sign_open: bool


@dataclass(frozen=True, eq=False)
class FittedStars:
    """The stars of a field fit.

    Attributes
    ----------
    places : ndarray, shape (n, 2)
        Row and column of the middle pixel of each window on the sensor.
    centers : ndarray, shape (n, e, 2)
        Fitted row and column of each image within its window.
    center_errors : ndarray, shape (n, e, 2)
        Standard errors of `centers`, with the wavefront and the blur estimated; NaN for rejected stars.
    flux, background : ndarray, shape (n, e)
        Electrons of the star in an infinite window, and background in electrons per pixel. For corners of a
        checkerboard, the difference and the mean of the brightness of white and black, electrons per pixel.
    flux_errors, background_errors : ndarray, shape (n, e)
        Standard errors of `flux` and `background`; NaN for rejected stars.
    chi2 : ndarray, shape (n,)
        Pearson's chi2 per degree of freedom of each star, with the wavefront of the fitted field.
    used : ndarray of bool, shape (n,)
        True for stars used in the fit; False for rejected stars, such as double stars, defects and galaxies.
    """

    places: Array
    centers: Array
    center_errors: Array
    flux: Array
    flux_errors: Array
    background: Array
    background_errors: Array
    chi2: Array
    used: NDArray[np.bool_]


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class FieldFit(FitReport):
    """Wavefronts over the field with their standard errors: the result of :func:`lommel.fit_field`.

    Attributes
    ----------
    field : FieldMap
        Wavefront at every position of the sensor: estimated terms, fixed terms of `pupil`, and tilts if
        `distortion` is estimated.
    twin : FieldMap or None
        The field with the even part of all phases negated, if its images are the same (finding "sign_open");
        None if the images determine the sign.
    names : tuple
        The k estimated terms: those requested, then terms that the stars favour (finding "estimated").
    coefficients : ndarray, shape (k, m)
        Coefficients of each term (radians rms) for the m products of Legendre polynomials of the position; see
        :meth:`at`.
    covariance : ndarray, shape (k * m, k * m)
        Covariance of the flattened `coefficients`. Places, flux, background and blur are nuisance parameters.
    blurs : tuple of tuples of blurs
        Blurs of each exposure, as arguments of :func:`lommel.psf`: the known blurs, or estimates
        (:class:`lommel.Seeing`, :class:`lommel.Jitter`, or both, and :class:`lommel.Motion` where the stars favour
        it, finding "estimated"). Fried's parameter r0 of the seeing is for the focal length of the pupil, or for 1 m
        if it has none.
    blur_errors : tuple of tuples of float
        Standard error of r0 (:class:`lommel.Seeing`; the outer scale is unknown), of sigma (:class:`lommel.Jitter`)
        or of the length (:class:`lommel.Motion`); 0 for a known blur.
    chi2 : float
        Pearson's chi2 per degree of freedom of all used stars, about 1 if the model is right.
    held_out : float
        Chi2 of a fifth of the stars, with wavefronts predicted by a fit of the other stars; NaN for too few stars.
    findings : Findings
        Findings of the checks: misfits, rejected stars, an ambiguous sign, the shape of the blur. The doubt "too_dim"
        means too little light: the standard error of the wavefront exceeds 0.22 radians rms (0.22 / sqrt(m) if all
        exposures have one focus), so that other wavefronts may fit as well.
    summary : str
        Chi2, number of stars and degree.
    degree : int
        Total degree of the polynomials in x and y.
    distortion : Distortion or None
        Displacement of the images from the `ideal` places; None if `ideal` was not given.
    stars : FittedStars
    images, model : ndarray, shape (n, e, height, width)
        Images in electrons, NaN at pixels left out of the fit, and the fitted model.
    """

    field: FieldMap = attribute(repr=False)
    twin: FieldMap | None = attribute(repr=False)
    names: tuple[Name, ...]
    coefficients: Array
    covariance: Array = attribute(repr=False)
    blurs: tuple[tuple[Blur, ...], ...]
    blur_errors: tuple[tuple[float, ...], ...]
    chi2: float
    held_out: float
    degree: int
    distortion: Distortion | None
    stars: FittedStars
    images: Array = attribute(repr=False)
    model: Array = attribute(repr=False)
    _sensor: Sensor = attribute(repr=False)
    _terms: tuple[Term, ...] = attribute(repr=False)  # columns of the table that `save` writes
    _pupil: Pupil = attribute(repr=False)
    _defocus: tuple[float, ...] = attribute(repr=False)

    def at(self, x: ArrayLike, y: ArrayLike) -> tuple[Array, Array]:
        """Return the estimated terms and their standard errors at positions of the sensor.

        Parameters
        ----------
        x, y : array_like
            Positions from the middle of the sensor, metres or lambda*N: x increases with the column, y with the row.

        Returns
        -------
        coefficients, errors : ndarray, shape ``(..., k)``
            Radians rms, in the order of `names`.

        Raises
        ------
        TypeError, ValueError
            If a position is not finite or lies outside the sensor.
        """
        across, down = validation.broadcast("x and y", validation.real_array("x", x), validation.real_array("y", y))
        u, v = self._sensor.relative(across, down)
        if (np.maximum(np.abs(u), np.abs(v)) > 1.0 + 1e-9).any():
            raise ValueError("x and y must be on the sensor of the fit, got a position outside the sensor")
        return with_errors(u, v, self.degree, self.coefficients, self.covariance)

    @property
    def blur(self) -> tuple[Blur, ...]:
        """The blur of the first exposure, as an argument of :func:`lommel.psf`."""
        return self.blurs[0]

    @property
    def middle(self) -> tuple[float, float]:
        """Position (x, y) of the middle of the sensor."""
        (left, right), (top, bottom) = self.extent
        return 0.5 * (left + right), 0.5 * (top + bottom)

    @property
    def coma(self) -> Coma | None:
        """The coma in the middle of the sensor, Noll 7 and 8 combined; None if one of the two was not estimated."""
        values, errors = self.at(*self.middle)
        i, j = (self._index(term) for term in ((3, -1), (3, 1)))
        if i is None or j is None:
            return None
        down, across = values[i], values[j]
        size = math.hypot(down, across)
        # First-order error propagation; the correlation of the two terms is neglected.
        error = math.hypot(down * errors[i], across * errors[j]) / max(size, 1e-300)
        return Coma(size, error, math.degrees(math.atan2(down, across)))

    @property
    def focus(self) -> FocusShift | None:
        """Distance of the sensor's middle from focus; None without estimated defocus, or for several exposures."""
        j, pupil = self._index((2, 0)), self._pupil
        if j is None or pupil.wavelength is None or pupil.f_number is None or len(self._defocus) != 1:
            return None
        values, errors = self.at(*self.middle)
        # A coefficient a of Noll 4, a sqrt(3) (2 rho^2 - 1), is a defocus C_d = sqrt(3) a.
        metres = 8.0 * pupil.wavelength * pupil.f_number**2 / math.pi
        known_defocus = self._defocus[0]
        shift, error = metres * (known_defocus + math.sqrt(3.0) * values[j]), metres * math.sqrt(3.0) * errors[j]
        return FocusShift(float(shift), float(error), self.twin is not None and known_defocus == 0.0)

    def _index(self, term: Term) -> int | None:
        """Return the index of `term` in `names`; None if it was not estimated."""
        return next((j for j, name in enumerate(self.names) if term_of(name) == term), None)

    @property
    def extent(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Smallest and largest x, and smallest and largest y, at the outer edges of the sensor's pixels."""
        x, y = self._sensor.grid(2)
        return (float(x[0]), float(x[1])), (float(y[0]), float(y[1]))

    def save(self, path: str | PathLike[str], *, twin: bool = False) -> None:
        """Write the map as a CSV table for ``[field] file =`` of a lens file, with ``unit = "waves"``.

        Parameters
        ----------
        path : path
            Path of the file, ending in .csv.
        twin : bool, default False
            Write `twin` instead of `field`.

        Raises
        ------
        ValueError
            If `path` does not end in .csv, positions are not in metres, or `twin` is True but the fit has no twin.
        OSError
            If the file cannot be written.

        Notes
        -----
        The table has a rectangular grid of positions, on which splines reproduce polynomials of degree 3 exactly.
        Coefficients are in waves rms, by Noll's index; the wavefront of a :class:`lommel.Pupil` given to
        :func:`lommel.fit_field` is subtracted. Comment lines (``#``) contain the message of the fit, the blur (which
        the table does not include), and the standard errors in the middle and at the bottom right corner.
        """
        if (chosen := self.twin if validation.truth("twin", twin) else self.field) is None:
            raise ValueError("twin must be False: the images determine the sign of the even terms; there is no twin")
        if self.field.unit != "m":
            raise ValueError(
                "save requires positions in metres: call fit_field with pixel in metres, and with a pupil that has "
                "wavelength and f_number"
            )
        x, y = _map_positions(self._sensor, self.degree, self.distortion)
        across, down = (part.ravel() for part in np.meshgrid(x, y))
        aberrations = chosen.pupil(across, down).wavefront + self._pupil.wavefront * -1.0
        labels = [name if isinstance(name, str) else f"noll {_noll_index(name)}" for name in self.names]
        comments = [self.message]
        if any(self.blurs):
            texts = (in_words(*pair, self._sensor.pixel) for pair in zip(self.blurs, self.blur_errors, strict=True))
            comments.append(f"not in this table: blur by {'; '.join(texts)}")
        for position, k in (("the middle", len(x) // 2), ("the bottom right corner", -1)):
            place = x[k], y[k]
            errors = self.at(*place)[1] / (2.0 * math.pi)
            listed = ", ".join(f"{name} {error:.2g}" for name, error in zip(labels, errors, strict=True))
            comments.append(f"standard errors in {position}, waves rms: {listed}")
            if self.distortion is not None:
                down_error, across_error = self.distortion.at(*place)[1]
                errors_of = f"rows {down_error:.2g}, columns {across_error:.2g}"
                comments.append(f"standard errors of the distortion in {position}, pixels: {errors_of}")
        indices = [*map(_noll_index, self._terms)]
        save_table(path, {"x": across, "y": down}, aberrations, comments, indices)

    def plot(self, *, unit: str = "waves") -> Figure:
        """Return a matplotlib figure: terms over the field and their standard errors, stars, model images, residuals.

        Parameters
        ----------
        unit : {"waves", "radians"}
            Unit of the terms and of their standard errors.

        Returns
        -------
        matplotlib Figure

        Raises
        ------
        ValueError
            If `unit` is neither "waves" nor "radians".
        ImportError
            If matplotlib is not installed.
        """
        validation.choice("unit", unit, ("waves", "radians"))
        factor = 2.0 * math.pi if unit == "waves" else 1.0
        x, y = self._sensor.grid(25)
        values, errors = self.at(x, y[:, None])
        maps = [(label(name), values[..., j] / factor, errors[..., j] / factor) for j, name in enumerate(self.names)]
        if self.distortion is not None:
            displacement, displacement_errors = self.distortion.at(x, y[:, None])
            pairs = zip(np.moveaxis(displacement, -1, 0), np.moveaxis(displacement_errors, -1, 0), strict=True)
            maps += [(f"distortion of {name}, pixels", *pair) for name, pair in zip(_AXES, pairs, strict=True)]
        x_star, y_star = self._sensor.positions(self.stars.places)
        marks = x_star, y_star, self.stars.chi2, self.stars.used
        return show.estimates.field(
            maps, (x, y, self.field.unit), marks, (self.images, self.model), unit, self.message
        )


@listed(FieldFitOptions)
def fit_field(
    targets: Targets,
    pupil: Pupil | FieldMap,
    *,
    pixel: float,
    options: FieldFitOptions | None = None,
    **given: Any,
) -> FieldFit:
    """Estimate the wavefront over the field of a camera or telescope from an image of stars or of a test chart.

    The coefficients of Zernike terms are polynomials of the position. All stars are fitted jointly, in one exposure
    or in several exposures at known defoci. Each image has an unknown sub-pixel position, flux and background.

    Parameters
    ----------
    targets : Targets
        Images of n stars, pinholes (see `size`) or corners of a checkerboard in e exposures, and their places, from
        :func:`lommel.detection.find_spots` or :func:`lommel.detection.find_crossings`, or
        :class:`lommel.detection.Targets` of places found by other means. Images are linear in the light, with the
        gain and offset of the noise, which is numbers, not maps. NaN, infinite and masked values are left out, and so
        are saturated pixels of integer images and, for stars, pixels hit by cosmic rays. The position of each corner,
        the directions of its two lines and the brightness of black and white are estimated; lines must be straight
        within a window, but need not be perpendicular.
    pupil : Pupil or FieldMap
        Single pupil (no stack): aperture, scale and fixed wavefront. Spiders, segments and masks are supported. Or a
        map of initial wavefronts, for example those of the lens design, which determine the sign of the even terms;
        its aperture applies all over the field.
    pixel : float
        Pixel pitch, in metres if the pupil has a wavelength, else in units of lambda*N.
    options : FieldFitOptions, optional
        Options in one object; keywords change single ones.
    {options}

    Returns
    -------
    FieldFit
        The map with standard errors; check `converged` and `message` before use.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, there are too few stars, places lie outside the sensor, windows overlap, or
        a window is constant or saturated.
    ToleranceError
        If images of stars cannot be computed to the tolerance for any initial wavefront.

    Notes
    -----
    First, the brightest stars are fitted individually from random starts. If all exposures have one focus, the sign
    of the even part of each phase is ambiguous. Initial signs are those of the leading eigenvector of the matrix of
    similarities between stars (synchronisation: Singer 2011, doi:10.1016/j.acha.2010.02.001). Polynomials are fitted
    robustly to these wavefronts. From there all stars are fitted jointly: Fisher scoring maximizes the likelihood of
    :func:`lommel.retrieve`, with position, flux and background of each star eliminated. Blur by turbulence is a
    mixture of Gaussians, whose transfer function differs by less than 3e-4 from the exact one. Blur profiles are
    compared by log-likelihood (lnL): two widths are preferred to one if lnL increases by at least 2. Stars whose chi2
    exceeds the median by five standard deviations are rejected. Pixels that are sharper than any star image are left
    out as hits of cosmic rays (van Dokkum 2001, doi:10.1086/323894). Blur is computed from samples of the PSF (0.45
    lambda*N apart, or farther if the blur is wide), not on the pixels of the camera. Charts may be unevenly lit:
    windows of corners are divided by the illumination, whose logarithm is a polynomial of degree 4 or less, fitted to
    the white areas of all windows.

    Effects that the model lacks are tested, marginalized, graded or estimated as in :func:`lommel.retrieve` (Zernike
    terms, f-number, obscuration, apodization, known defoci). Their values are in the finding "estimated", changed
    apertures in `field`, and terms, which follow the requested ones, in `names`. Additional score
    tests search for polynomials of the next two degrees, for a term that is larger in one of 3 x 3 parts of the
    field, and for blur that has another shape, is anisotropic, or varies over the field. Slopes of the background are
    estimated if they are significant. Three more effects are marginalized, with these prior standard deviations:
    anisotropic blur (0.1 pixels^2 of variance), wings (0.3 of the light) and slopes of the background (1 electron per
    pixel).

    If all exposures have one focus, the search is repeated with other relative signs of even terms (not for corners),
    and the most likely map is returned. If the lnL of another map is lower by less than 8, and a coefficient differs
    by more than three standard errors, this is reported ("another_minimum"). If the aperture has two-fold symmetry,
    the images do not change if all even terms of the phase are negated, those of a known defocus included
    ("sign_open"). The map nearer to the wavefront of `pupil` is returned; the other map is `twin`. At equal
    distances, the map whose first even term has the larger mean is returned. A second exposure at another known
    defocus determines the sign.

    Distortion requires `ideal` places. The displacement is a polynomial of the ideal position, fitted to the
    estimated places by generalised least squares, because errors of places and of coma are correlated. Tilts of the
    map displace the images accordingly (W311 of :meth:`lommel.Wavefront.from_seidel`). The shift, rotation and
    magnification of `ideal` minimize the displacement over the whole sensor. Standard errors include ``scatter``, the
    rms deviation of places in excess of noise. Of several exposures, the places are those of the first.

    Examples
    --------
    >>> import lommel as lm
    >>> import numpy as np
    >>> rng, noise = np.random.default_rng(1), lm.Noise(read=2.0)
    >>> places = np.stack(np.meshgrid([30, 90, 150, 210], [30, 90, 150, 210]), axis=-1).reshape(-1, 2)
    >>> field = lm.FieldMap.from_seidel(150.0, W131=0.3, W222=0.4)
    >>> pupil = field.pupil(*((places[:, ::-1] - 119.5) * 0.5).T)
    >>> images = noise.record(3e4 * lm.psf(pupil, 25, 0.5).values + 20.0, seed=2)
    >>> stars = lm.detection.Targets(windows=images, places=places, shape=(240, 240), noise=noise)
    >>> fit = lm.fit_field(stars, lm.Pupil(), pixel=0.5, degree=2, terms=5)
    >>> fit.converged
    True
    """
    fit_options = FieldFitOptions.of("fit_field", options, given)
    return fit_targets(targets, pupil, pixel=pixel, options=fit_options)


def fit_targets(
    targets: Targets, pupil: Pupil | FieldMap, *, pixel: float, options: FieldFitOptions, effort: Effort = EFFORT,
    draw: np.random.Generator | None = None,
) -> FieldFit:  # fmt: skip
    """Return the wavefront over the field from windows around stars or targets, see :func:`lommel.fit_field`."""
    unknowns = Unknowns(options.terms, ("center",))
    validation.instance("targets", targets, Targets)
    counts = _checked_windows(targets)
    noise = counts.known_noise().require_shape(counts.shape)
    images, valid = counts.filled(), counts.known
    count, exposures, height, width = images.shape
    start, lens = (pupil, pupil.pupil_without_wavefront) if isinstance(pupil, FieldMap) else (None, pupil)
    single(lens, "for the whole field")
    rows, columns = (validation.integer("shape", side, least=1, most=_MAX_SIDE) for side in targets.shape)
    star_places = _checked_places(targets.places, (rows, columns), (count, height, width))
    defoci, blur = known_defocus(options.defocus, exposures, "exposures"), options.blur
    ideal = None if options.ideal is None else checked_ideal(options.ideal, star_places)
    pitch = validation.pixel(pixel, metric=lens.wavelength is not None)
    chip = Sensor((rows, columns), pitch)
    poisson = noise.poisson
    electrons, read = poisson.electrons(images), poisson.variance(np.zeros_like(images))
    plan = Plan((height, width), pitch, tol=effort.tol, integrate=effort.integrate, threads=effort.threads)
    x, y = chip.positions(star_places)
    start_pupils = lens if start is None else _start_pupils(start, chip, x, y)
    target = _target_of(targets, options.size, pitch)
    if not isinstance(blur, bool | Blur | Iterable):
        blur = Jitter(validation.real("blur", blur, least=0.0, below=0.25 * min(height, width)) * pitch)
    illumination = np.ones(1)
    if targets.kind == "crossing":
        across = chip.relative(x[:, None] + pitch * (np.arange(width) - width // 2), y[:, None])[0]
        down = chip.relative(x[:, None], y[:, None] + pitch * (np.arange(height) - height // 2))[1]
        illumination = relative_light(electrons, valid, across, down)
        electrons, read = electrons / illumination, read / illumination**2
    blur_model = _blur_model(blur, lens, pitch, min(height, width), target)
    if target is None:
        sharpest = sharpness(lens, pitch, integrate=bool(plan.grid(lens).integrate))
        valid = valid & ~cosmic_ray_mask(electrons, read, valid, sharpest)
    stars = FieldStars(
        electrons, read, valid, start_pupils, defoci, unknowns, pitch, plan, blur=blur_model, target=target
    )
    if stars.degrees_of_freedom < 1:
        pixels = stars.degrees_of_freedom + stars.size
        raise ValueError(
            f"windows must have more pixels than a star has unknowns, {stars.size}, got {pixels}: use larger windows"
        )
    if count < 4 and options.degree > 0:
        raise ValueError(f"windows must show at least 4 stars unless degree is 0, got {count}")
    u, v = chip.relative(x, y)
    pixel_size = np.array([2.0 / columns, 2.0 / rows])
    degree, draw = highest_degree(options.degree, count), draw or np.random.default_rng(0)
    search = Search(
        stars, np.stack([u, v], axis=1), pixel_size, degree, draw, Progress(options.progress), noise.excess
    )
    outcome = _search_repeatedly(search, start is not None, min(_MAX_SEARCHES, effort.starts))
    distortion_settings = ideal, _DISTORTION if options.distortion is None else options.distortion
    known_blurs = blur_model if isinstance(blur_model, tuple) else ()
    camera = noise, illumination
    return _build_field_fit(
        search, outcome, lens, start, chip, star_places, counts, camera, distortion_settings, known_blurs
    )


def _target_of(targets: Targets, size: float | None, pitch: float) -> Target | None:
    """Return what the windows show, pinholes or crossings; None for stars."""
    if targets.kind == "crossing":
        square = getattr(targets, "square", math.nan)  # pixels
        return Target("crossing", size / pitch if size is not None else square if math.isfinite(square) else math.inf)
    return None if size is None else Target("pinhole", size / pitch)


def _blur_model(
    blur: bool | Blur | Iterable[Blur], pupil: Pupil, pitch: float, side: int, target: Target | None
) -> BlurProfile | tuple[Blur, ...]:
    """Return the initial shape of a blur of unknown width, or the known blurs."""
    if blur is True:
        return BlurProfile.turbulent() if target is None else BlurProfile.gaussian()
    known_blurs = blurs(None if blur is False else blur)
    require_unit(known_blurs, pupil)
    if not all(b.isotropic for b in known_blurs) or sum(isinstance(b, Seeing) for b in known_blurs) > 1:
        raise ValueError(f"blur must be isotropic, with at most one Seeing, got {validation.shown(blur)}")
    if any(max(b.lengths, default=0.0) > 0.25 * side * pitch for b in known_blurs):
        raise ValueError(f"blur must be narrower than a quarter of a window's side, got {validation.shown(blur)}")
    return known_blurs


def _search_repeatedly(search: Search, has_start: bool, attempts: int) -> Outcome:
    """Repeat a search until it converges, at most `attempts` times; return the best outcome."""
    places, best_outcome = search.places, None
    for attempt in range(attempts):
        search.places, search.stars = places, search.initial_stars
        # The known defocus alone is a good start, because it is usually larger than the unknown aberrations.
        from_start = attempt == 0 and (has_start or search.stars.has_defocus)
        first_fit = search.fit_from_start(alone=attempts == 1) if from_start else None
        outcome = search.outcome(search.reject_outliers(first_fit or search.fit_from_single_stars()))
        if outcome.findings.converged or outcome.of_noise:
            return outcome
        best_outcome = outcome if best_outcome is None or outcome.cost < best_outcome.cost else best_outcome
    assert best_outcome is not None
    return best_outcome


def in_words(
    blurs_of_exposure: Sequence[Blur], errors: Sequence[float], pitch: float, focal_length: float | None = None
) -> str:
    """Return blurs with standard errors as text: seeing as FWHM at 500 nm, widths in pixels; "none" without blur.

    `pitch` and `focal_length`, by default that of a :class:`lommel.Seeing`, are in metres.
    """

    def text(blur: Blur, error: float) -> str:
        angle = f" at {math.degrees(getattr(blur, 'angle', 0.0)) % 180.0:.0f} degrees from the rows"
        if isinstance(blur, Motion):
            return f"a line of {' +- '.join(with_error(blur.length / pitch, error / pitch))} pixels{angle}"
        if isinstance(blur, Jitter) and blur.across is not None:
            is_round, sigma = blur.across == blur.sigma, f"{blur.sigma / pitch:.3f} +- {error / pitch:.3f}"
            across = "" if is_round else f" by {blur.across / pitch:.3f}"
            return f"{sigma}{across} pixels (standard deviation){'' if is_round else angle}"
        focal = getattr(blur, "focal_length", None) if focal_length is None else focal_length
        if not isinstance(blur, Seeing) or focal is None:
            return repr(blur)
        width = FWHM / blur.coherence(500e-9) / focal / ARCSEC  # of long exposures
        outer = "" if blur.outer_scale is None else f" for an outer scale of {format_length(blur.outer_scale)}"
        return f"seeing of {' +- '.join(with_error(width, width * error / blur.r0))} arcsec at 500 nm{outer}"

    return " and ".join(map(text, blurs_of_exposure, errors)) or "none"


def _noll_index(term: Term) -> int:
    return int(zernike.index_of(term[0], term[1], "noll"))


def _start_pupils(start: FieldMap, chip: Sensor, x: Array, y: Array) -> Pupil:
    """Return pupils with the wavefronts of the map `start` at the positions of stars."""
    if start.vignetting is not None:
        raise ValueError("pupil must be a map without vignetting, because its aperture applies all over the field")
    across, down = np.meshgrid(*chip.grid(2))
    try:
        start.pupil(across, down)
    except ValueError as error:
        raise ValueError(f"pupil must be a map that reaches the corners of the sensor: {error}") from None
    return start.pupil_without_wavefront.carrying(start.pupil(x, y).wavefront, None)


def _checked_windows(targets: Targets) -> Counts:
    """Return the validated windows, with shape (n, exposures, height, width)."""
    shape = "(n, height, width) or (n, exposures, height, width)"
    counts = counts_of("windows", targets.windows, targets.noise, sides=(3, 4), shape=shape)
    counts.require_known("windows", 0.5).require_light("windows", "a star")
    return counts if counts.values.ndim == 4 else counts[:, None]


def _checked_places(places: ArrayLike, sensor: tuple[int, int], windows: tuple[int, int, int]) -> Array:
    count, height, width = windows
    values = validation.real_array("places", places)
    if values.shape != (count, 2):
        raise ValueError(f"places must be a row and a column for each of {count} windows, got shape {values.shape}")
    outside = (values < -0.5) | (values > np.array(sensor) - 0.5)
    if outside.any():
        k = int(np.flatnonzero(outside.any(axis=1))[0])
        raise ValueError(
            f"places must be on the sensor of {sensor[0]} x {sensor[1]} pixels, got row {values[k, 0]:g}, column "
            f"{values[k, 1]:g}"
        )
    is_near = np.abs(values[:, None] - values[None]) < [height, width]
    overlaps = np.triu(is_near.all(axis=-1), 1)
    if overlaps.any():
        i, j = np.argwhere(overlaps)[0]
        raise ValueError(
            f"windows must not overlap, or light would count twice, got windows {i} and {j} at ({values[i, 0]:g}, "
            f"{values[i, 1]:g}) and ({values[j, 0]:g}, {values[j, 1]:g})"
        )
    return values


def _build_field_fit(
    search: Search,
    outcome: Outcome,
    pupil: Pupil,
    start: FieldMap | None,
    chip: Sensor,
    places: Array,
    counts: Counts,
    camera: tuple[Noise, Array],
    distortion_settings: tuple[Array | None, int],
    known_blurs: tuple[Blur, ...],
) -> FieldFit:
    """Return the result of a search as a FieldFit."""
    fit, rejected, held_out, tests = outcome.fit, outcome.rejected, outcome.held_out[0], outcome.tests
    noise, illumination = camera
    # The best search may be an earlier one than the last, with another profile of blur: restore its places and stars.
    search.places, stars = outcome.places, fit.model.stars
    search.stars, first_star = stars, stars.first_star
    pupil = stars.pupil.carrying(pupil.wavefront, None)
    polynomials, degree = fit.polynomials(), search.degree
    distortion = _estimated_distortion(fit, chip, places, distortion_settings)
    x, y = _map_positions(chip, degree, distortion)
    across, down = np.meshgrid(x, y)
    u, v = chip.relative(across, down)
    # The fixed wavefront, added to the polynomials, is that of the pupil, or of the map `start` at each position.
    fixed_terms = first_star.fixed
    if start is not None:
        fixed_terms = first_star.split(start.pupil(across, down).wavefront.edge_terms(), across.shape)[1]

    def field_of(coefficients: Array) -> FieldMap:
        edge = np.asarray(fixed_terms + monomials(u, v, degree) @ coefficients.T @ first_star.directions)
        if distortion is not None:
            edge[..., first_star.tilts] += displacement_at(distortion, u, v) * first_star.tilt_of_pixel
        return FieldMap.on_grid(x, y, Wavefront.trusted(first_star.terms, edge), aperture=pupil.unaberrated())

    k, m = polynomials.shape
    fit_covariance = fit.model.covariance(fit.scores)
    errors = np.sqrt(np.diag(fit_covariance))[k * m :]
    marginal = outcome.model_error or outcome.grade.marginal
    shift, covariance = marginal.shift[: k * m].reshape(k, m), marginal.covariance[: k * m, : k * m].copy()
    shifted_waves = fit.model.basis @ shift.T
    mean_square = np.einsum("ni,ij,nj->n", shifted_waves, search.metric, shifted_waves).mean()
    # The shift is linear in the parameters: where it is large, it means nothing.
    is_linear = outcome.model_error is not None or mean_square <= MAX_LINEAR_ERROR**2
    coefficients, twin = polynomials + shift if is_linear else polynomials, None
    findings = list[Finding]()
    if first_star.sign_ambiguous:
        twin = field_of(search.twin(coefficients))
        findings = _sign_findings(start is not None, stars.has_defocus, "map" if stars.count > 1 else "wavefront")
    labels = [label(name) for name in first_star.unknowns.terms for _ in range(m)]
    grade = None if outcome.model_error else outcome.grade
    is_named = "gain" not in outcome.findings.codes and not outcome.unexplained
    effects = missing_findings(tests, grade, labels) if is_named else []
    findings = covered([*outcome.findings, *effects, *findings])
    findings += estimated_effects(outcome.rounds, coefficients, np.sqrt(np.diag(covariance)).reshape(k, m))
    # Another effect may be the cause: errors contain the answer with it.
    is_doubted = np.array([name in unsure(outcome.rounds) for name in labels])
    change = np.where(is_doubted, coefficients.ravel(), differences(outcome.rounds).ravel())
    np.fill_diagonal(covariance, np.diag(covariance) + opened(change, np.sqrt(np.diag(covariance))))
    squared_widths = fit.squared_widths()
    width_errors, outer_errors = errors.reshape(squared_widths.shape), search.outer_scale_errors(fit)
    blurs_with_errors = _estimated_blurs(stars, known_blurs, squared_widths, width_errors, outer_errors)
    if stars.trails.any():
        pitch = stars.pixel * float(stars.pupil.scale)
        for blurs_of_exposure, length, error, angle in zip(blurs_with_errors, *trails_of(fit, tests), strict=True):
            blurs_of_exposure.append((Motion(pitch * float(length), float(angle)), pitch * float(error)))
    findings += _blur_findings(stars, outcome.blur_costs)
    table, model = _fitted_stars(search, fit, rejected, polynomials, places, noise.excess)
    findings += _stripe_findings(stars, model, table.used, noise.excess)
    chi2 = float(fit.scores.chi2[0])
    noun = "star" if stars.target is None else stars.target.kind
    summary = f"chi2 {chi2:.4g} per degree of freedom of {table.used.sum()} {noun}s, degree {degree}"
    if math.isfinite(held_out):
        summary += f", held-out chi2 {held_out:.4g}"
    findings += _rejected_finding(noun, places[rejected])
    if distortion is not None:
        summary += f"; {distortion.summary}"
        findings += distortion.findings
    if not fit.settled and outcome.model_error is None and Findings(findings).converged:
        findings.append(Finding("not_settled", "error", "the steps have not settled"))
    if Findings(findings).converged:
        findings += _too_dim_findings(search, fit, fit_covariance[: k * m, : k * m])
    findings += recording_findings([counts[:, e] for e in range(counts.values.shape[1])], noise, "exposure")
    used_pixels = (stars.pixel_data[3] > 0.0).reshape(counts.known.shape)
    findings += _left_out_finding(counts.known & ~used_pixels)
    estimated = (first_star.directions != 0.0).any(axis=0)
    estimated[first_star.tilts] |= distortion is not None
    pairs = zip(first_star.terms, estimated, strict=True)
    saved_terms = tuple(term for term, is_estimated in pairs if is_estimated or start is not None)
    return FieldFit(
        field=field_of(coefficients),
        twin=twin,
        names=first_star.unknowns.terms,
        coefficients=coefficients,
        covariance=covariance,
        blurs=tuple(tuple(blur for blur, _ in blurs_of_exposure) for blurs_of_exposure in blurs_with_errors),
        blur_errors=tuple(tuple(error for _, error in blurs_of_exposure) for blurs_of_exposure in blurs_with_errors),
        chi2=chi2,
        held_out=held_out,
        findings=Findings(findings),
        summary=summary,
        degree=degree,
        distortion=distortion,
        stars=table,
        images=np.where(used_pixels, noise.electrons(counts.filled()), np.nan),
        model=model.reshape(counts.values.shape) * illumination * noise.excess,
        _sensor=chip,
        _terms=saved_terms,
        _pupil=pupil,
        _defocus=tuple(float(c_d) for c_d in stars.defocus),
    )


def _fitted_stars(
    search: Search, fit: Solution, rejected: NDArray[np.intp], polynomials: Array, places: Array, excess: float
) -> tuple[FittedStars, Array]:
    """Return the table of all stars, used and rejected, and the expected electrons of all pixels."""
    stars, squared_widths = search.stars, fit.squared_widths()
    nuisance = np.zeros((stars.count, stars.parameters_per_image, stars.exposures))
    errors = np.full_like(nuisance, np.nan)
    nuisance[fit.model.chosen], errors[fit.model.chosen] = fit.nuisance(), fit.model.nuisance_errors(fit.scores)
    if len(rejected):
        # For rejected stars, only position, flux and background are fitted; the wavefront is that of the field.
        nuisance[rejected] = search.fit_nuisance(rejected, polynomials, squared_widths)
    indices = np.arange(stars.count)
    model = search.model(indices, held=True)
    parameters = model.parts(model.row(polynomials, squared_widths, nuisance))
    psf = stars.images(indices, *parameters, fast=False, derivatives="none")[0]
    quality = stars.quality(indices, psf, nuisance, float(stars.parameters_per_image * stars.exposures))
    shifts, center_errors = (
        tilts[:, :2].swapaxes(1, 2) / stars.first_star.tilt_of_pixel for tilts in (nuisance, errors)
    )
    centers, used = shifts + [side // 2 for side in stars.shape], np.isin(indices, fit.model.chosen)
    table = FittedStars(
        places, centers, center_errors,
        excess * nuisance[:, 2], excess * errors[:, 2], excess * nuisance[:, 3], excess * errors[:, 3],
        quality.chi2, used,
    )  # fmt: skip
    return table, stars.expected(psf, nuisance)


def _stripe_findings(stars: FieldStars, model: Array, used: NDArray[np.bool_], excess: float) -> list[Finding]:
    """Return the finding on stripes in the windows of the used stars; `model` are the expected electrons."""
    counted, _, read, valid = stars.pixel_data.reshape(4, stars.count, -1, *stars.shape)[:, used]
    mean = model.reshape(stars.count, *counted.shape[1:])[used]
    residual = np.where(valid > 0.0, counted - mean, np.nan)
    residual, variance = (part.reshape(-1, *stars.shape) for part in (residual, np.maximum(mean, 0.0) + read))
    return stripe_findings(residual, variance, excess)


def _sign_findings(has_start: bool, has_defocus: bool, noun: str) -> list[Finding]:
    """Return the finding that images in one focus do not determine the common sign of the even terms."""
    choice = f"the {noun} nearer to the wavefront of pupil was chosen"
    severity: Severity = "note"
    if not has_start and not has_defocus:
        choice = "add a second defocus" + (", or pass a design as pupil" if noun == "map" else "")
        severity = "doubt"
    return [Finding("sign_open", severity, f"{_SIGN}: {choice}, the other {noun} is twin")]


def _rejected_finding(noun: str, places: Array) -> list[Finding]:
    """Return the finding on rejected stars, whose rows and columns are `places` (n, 2)."""
    if not len(places):
        return []
    causes = {"star": "doubles, defects", "crossing": "defects, print, curved lines"}.get(noun, "defects")
    positions = ", ".join(f"row {row:.0f} column {column:.0f}" for row, column in places[:_MAX_LISTED])
    suffix = f" and {len(places) - _MAX_LISTED} more" if len(places) > _MAX_LISTED else ""
    text = f"{len(places)} {noun}{'s' * (len(places) > 1)} rejected ({causes}) at {positions}{suffix}"
    return [Finding("rejected", "note", text, {"rejected": len(places)})]


def _left_out_finding(pixels: NDArray[np.bool_]) -> list[Finding]:
    """Return the finding on pixels with a recorded value that the fit leaves out; `pixels` is their mask."""
    count, windows = int(pixels.sum()), int(pixels.any(axis=(1, 2, 3)).sum())
    counts = enumerate(pixels.sum(axis=(0, 2, 3)).tolist(), 1)
    listed = ", ".join(f"{number} in exposure {e}" for e, number in counts if number) if pixels.shape[1] > 1 else ""
    where = f"{windows} window{'s' * (windows > 1)}{f' ({listed})' if listed else ''}"
    text = f"{count} pixels of {where} left out: sharper than star images (cosmic rays, hot pixels)"
    return [Finding("left_out", "note", text, {"pixels": count, "windows": windows})] if count else []


def _estimated_blurs(
    stars: FieldStars, known_blurs: tuple[Blur, ...], squared_widths: Array, errors: Array, outer_errors: Array
) -> list[list[tuple[Blur, float]]]:
    """Return the blurs of each exposure, from squared widths (e, b) in pixels, with their standard errors.

    `errors` (e, b) are those of the squared widths; `outer_errors` (e,), of the seeing, are due to the outer scale.
    """
    exposures: list[list[tuple[Blur, float]]] = [[(blur, 0.0) for blur in known_blurs] for _ in squared_widths]
    pupil, profile = stars.pupil, stars.blur
    pitch = stars.pixel * float(pupil.scale)
    for i, blurs_of_exposure in enumerate(exposures):
        for name, square, error in zip(profile.names, squared_widths[i], errors[i], strict=True):
            width = math.sqrt(max(float(square), 0.0))
            # With s = square and ds = error, the error of sqrt(s) is ds / (2 sqrt(s)). At s = 0 it is sqrt(ds).
            width_error = float(error) / max(2.0 * width, math.sqrt(float(error)), 1e-300)
            if name == "Gaussian":
                blurs_of_exposure.append((Jitter(width * pitch), width_error * pitch))
            elif width > 0.0:
                wavelength = pupil.wavelength
                focal_length = 1.0 if pupil.geometry is None else pupil.geometry.focal_length
                r0 = FWHM / (SIGMAS * width * pitch) * (1.0 if wavelength is None else wavelength * focal_length)
                outer = None if profile.outer is None else profile.outer * r0
                seeing = Seeing(r0, None if wavelength is None else focal_length, wavelength, outer)
                blurs_of_exposure.append((seeing, r0 * math.hypot(width_error / width, outer_errors[i])))
    return exposures


def _blur_findings(stars: FieldStars, blur_costs: dict[str, float]) -> list[Finding]:
    """Return the finding on the most likely profile of blur; `blur_costs` are -lnL of the compared profiles."""
    if not blur_costs:
        return []
    outer = stars.blur.outer
    seeing = "Kolmogorov" if outer is None else f"von Karman with an outer scale of {outer:.0f} r0"
    gain = blur_costs["Gaussian"] - blur_costs["seeing"]
    numbers = {"gain": gain, "outer_over_r0": outer}
    if abs(gain) < _MIN_GAIN:
        text = f"the images do not distinguish Kolmogorov from a Gaussian blur (lnL differs by {abs(gain):.1f})"
    elif gain > 0.0:
        second_blur = " and a Gaussian" if "Gaussian" in stars.blur.names else ""
        text = f"blur by {seeing} turbulence{second_blur}, more likely than a Gaussian by lnL {gain:.0f}"
    else:
        second_blur = " and seeing" if "seeing" in stars.blur.names else ""
        text = f"blur by a Gaussian{second_blur}, more likely than Kolmogorov by lnL {-gain:.0f}"
    return [Finding("blur_shape", "note", text, numbers)]


def _too_dim_findings(search: Search, fit: Solution, covariance: Array) -> list[Finding]:
    """Return the finding that images are not linear functions of the wavefront within its standard error."""
    basis, metric = fit.model.basis, search.metric
    k, m = len(metric), basis.shape[1]
    blocks = covariance.reshape(k, m, k, m)
    rms = math.sqrt(float(np.einsum("ni,kilj,nj,kl->n", basis, blocks, basis, metric, optimize=True).mean()))
    # With one focus, minima with other signs are near, for each of the m ways in which a term varies over the field.
    limit = MAX_LINEAR_ERROR / math.sqrt(m) if search.stars.first_star.one_focus else MAX_LINEAR_ERROR
    return too_dim_findings(rms, limit)


def _map_positions(chip: Sensor, degree: int, distortion: Distortion | None) -> tuple[Array, Array]:
    """Return x and y of a map's grid, finer for degrees above 3, which cubic splines do not reproduce exactly."""
    return chip.grid(5 if max(degree, 0 if distortion is None else distortion.degree) <= 3 else 17)


def _estimated_distortion(
    fit: Solution, chip: Sensor, places: Array, distortion_settings: tuple[Array | None, int]
) -> Distortion | None:
    """Return the distortion relative to the ideal places; None without ideal places."""
    ideal, degree = distortion_settings
    if ideal is None:
        return None
    used, tilt = fit.model.chosen, fit.model.stars.first_star.tilt_of_pixel
    is_known = np.isfinite(ideal[used]).all(axis=1)
    if is_known.sum() < 4:
        raise ValueError(f"ideal must be known for at least 4 of {len(used)} accepted windows, got {is_known.sum()}")
    fitted_places = fit.nuisance()[:, :2].swapaxes(1, 2) / tilt + places[used][:, None]
    blocks = fit.scores.information[0]
    return fit_distortion(ideal, used, places_of(blocks, fitted_places, tilt), degree=degree, sensor=chip)
