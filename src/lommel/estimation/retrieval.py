"""What was found behind images of a star, and how certain it is."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from os import PathLike
from typing import TYPE_CHECKING, Any

import numpy as np

from lommel import show
from lommel.base import validation
from lommel.base.arrays import Array
from lommel.base.units import LENGTHS
from lommel.estimation import scoring
from lommel.estimation.noise import Noise
from lommel.estimation.scoring import Fits, covariance
from lommel.estimation.star_images import StarImages
from lommel.io import zernike_tables
from lommel.methods.derivative_names import POWERS, Name
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.descriptions import radians_per
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import PSF
from lommel.special import zernike

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_UNITS = {"f_number": "", "obscuration": "", "wavelength": "m"}
_SEEN = 5.0  # standard errors of its flux, of a star that is there
_OWN = {"row": "pixels", "column": "pixels", "flux": "electrons", "background": "electrons/pixel"}


@dataclass(frozen=True, eq=False, repr=False)
class Retrieval:
    """The wavefront behind images of a star: the answer of :func:`lommel.retrieve`.

    Attributes
    ----------
    wavefront : Wavefront
        All of it: what was solved for, and what `pupil` had besides; without tilts of images and known defoci.
    pupil : Pupil
        With this wavefront, and the f-number, wavelength or obscuration that were solved for.
    coefficients : dict of name to float
        What all images share, by the names that were asked for: Zernike terms in radians rms, "defocus" and powers
        of rho in radians (of the wavelength that was given), "f_number", "obscuration", "wavelength" in metres.
    deviation : dict of name to float or ndarray
        Standard error of each, and of "flux", "background", and "row", "column" where solved for, shape (n,): what
        noise alone makes of them. inf where the images do not determine it. See `reliable`.
    covariance : ndarray, shape (k, k)
        Of `coefficients`, in their order, whatever flux, background and places are.
    units : dict of name to str
    chi2 : float
        Pearson's, of all pixels, over its expectation for the fitted model: about 1 where pupil, pixel and noise are
        right, however few the electrons; see the notes.
    converged : bool
        Whether the steps settled where chi2 allows to believe the fit.
    reliable : bool
        Whether it converged and its standard errors hold. They assume images that are linear in the parameters.
        False where those of terms and place add up to more than 0.25 radians rms of phase in an image, for then other
        wavefronts may fit as well, or where that of a coefficient changes by more than an eighth within one standard
        deviation. `message` is then "converged, but the standard errors ... are not to be trusted: ...".
    message : str
        The verdict, in a sentence or several: "converged", "converged, but the standard errors ... are not to be
        trusted", "the steps did not settle", "no star" or "misfit", and why.
    flux, background : ndarray, shape (n,)
        Electrons of a star in an infinite window, and electrons a pixel.
    center : ndarray, shape (n, 2)
        Row and column of the axis in each image, as of :func:`lommel.psf`.
    psf : PSF
        Those of the images, a stack (n, height, width); fractions of all light.
    images, model, residual : ndarray, shape (n, height, width)
        What was measured, NaN where left out; what the fit says, in the same unit; the difference in standard
        deviations of the noise.
    steps, starts : int
        How many were taken, of all starts, and how many starts.

    Notes
    -----
    The expectation of chi2 is ``(1 - p / n) sum((mu + read^2) / v)`` over n pixels that expect mu electrons, for p
    parameters; v, the variance in its denominator, is ``mu + read^2``, but that reading counts as no less than 0.05
    electrons squared. That sum is exact; of the p, each takes the share of a mean pixel.
    In simulations its mean is 0.96 to 1.02 from 100 electrons an image on.
    """

    wavefront: Wavefront
    pupil: Pupil
    coefficients: dict[Name, float]
    deviation: dict[Name, Any]
    covariance: Array
    units: dict[Name, str]
    chi2: float
    converged: bool
    reliable: bool
    message: str
    flux: Array
    background: Array
    center: Array
    psf: PSF = field(repr=False)
    images: Array = field(repr=False)
    model: Array = field(repr=False)
    residual: Array = field(repr=False)
    steps: int
    starts: int

    def in_unit(self, unit: str) -> tuple[dict[Name, float], dict[Name, float]]:
        """Return the terms of the wavefront, and their deviations, in another unit.

        Parameters
        ----------
        unit : str
            "radians", "waves", "metres" or another length such as "nm", which need the wavelength of the pupil. Of
            Zernike terms rms, as in `coefficients`.

        Returns
        -------
        coefficients, deviation : dict of name to float

        Raises
        ------
        ValueError
            If there is no such unit, or no wavelength.
        """
        length = validation.choice("unit", unit, zernike_tables.UNITS) in LENGTHS
        factor = radians_per("metres" if length else unit, self.pupil.wavelength) * LENGTHS.get(unit, 1.0)
        terms = [name for name in self.coefficients if name not in _UNITS]
        return {t: self.coefficients[t] / factor for t in terms}, {t: self.deviation[t] / factor for t in terms}

    def save(self, path: str | PathLike[str]) -> None:
        """Write the wavefront as a table of Noll's terms, waves rms; see :func:`lommel.save_zernike`.

        Parameters
        ----------
        path : path
            Ending in .json, .toml or .csv.

        Raises
        ------
        ValueError
            If the suffix is unknown.
        OSError
            If the file cannot be written.
        """
        table = zernike_tables.ZernikeTable.from_wavefront(self.wavefront, wavelength=self.pupil.wavelength)
        zernike_tables.save_zernike(path, table)

    def plot(self) -> Figure:
        """Draw images, model and residual, and the terms with their deviations, on a figure of matplotlib."""
        labels = [label(name) for name in self.coefficients if name not in _UNITS]
        values, deviations = (list(part.values()) for part in self.in_unit("radians"))
        found = labels, values, deviations
        return show.fit.fit(self.images, self.model, self.residual, found, f"chi2 = {self.chi2:.3g}")

    def _repr_html_(self) -> str:
        rows: list[tuple[str, str]] = [("fit", self.message), ("chi2", f"{self.chi2:.4g} a degree of freedom")]
        rows += [
            (label(n), f"{c:.4g} ± {self.deviation[n]:.2g} {self.units[n]}") for n, c in self.coefficients.items()
        ]
        return show.notebook.retrieval(self.images, self.model, rows)

    def __repr__(self) -> str:
        terms = [
            f"  {label(n)}: {c:.4g} +- {self.deviation[n]:.2g} {self.units[n]}".rstrip()
            for n, c in self.coefficients.items()
        ]
        return "\n".join([f"<Retrieval: {self.message}", *terms]) + ">"


def answered(model: StarImages, fits: Fits, values: Array, noise: Noise, tried: tuple[int, int]) -> Retrieval:
    """Return what the best of `fits`, the first, says of images `values`, after so many steps and starts."""
    steps, starts = tried
    x = _nearer(model, fits)
    scores = model.judged(x, np.float64)
    psf = model.plan(model.pupils(x))
    mean = model.mean(x, psf.values.reshape(1, model.count, -1))[0]
    variance = model.variance(mean)
    seen = model.valid > 0.0
    residual = np.where(seen, (model.counted - mean) / np.sqrt(variance), np.nan)
    inverse = covariance(scores.information[0])
    unknowns, shared, own = model.unknowns, model.shared, model.own_of(x)[0]
    names = unknowns.shared
    deviations = np.sqrt(np.diag(inverse))
    pixels = model.tilt_of_pixel / model.magnification(x)
    spread = dict(
        zip((*unknowns.places, "flux", "background"), deviations[model.own].reshape(-1, model.count), strict=True)
    )
    center = np.tile([float(side // 2) for side in values.shape[1:]], (model.count, 1))
    for j, place in enumerate(unknowns.places):
        center[:, ("row", "column").index(place)] += own[j] / pixels
        spread[place] = spread[place] / pixels
    chi2, limit = float(scores.chi2[0]), float(model.limit(scores)[0])
    optics: dict[str, Any] = model.optics_of(x)
    wavefront = model.wavefront(x[0])
    settled, bright = bool(fits.settled[0]), own[-2] / spread["flux"]
    converged = bool(settled and chi2 < limit and bright.min() >= _SEEN)
    doubt = _doubt(model, x, inverse) if converged else ""
    work = f"after {steps} steps from {starts} start{'s' * (starts > 1)}"
    return Retrieval(
        wavefront=wavefront,
        pupil=replace(model.pupil, wavefront=wavefront, geometry=None, **optics),
        coefficients=dict(zip(names, x[0, :shared].tolist(), strict=True)),
        deviation=dict(zip(names, deviations[:shared].tolist(), strict=True)) | spread,
        covariance=inverse[:shared, :shared],
        units={name: _UNITS.get(name, "rad") for name in names} | {name: _OWN[name] for name in spread},
        chi2=chi2,
        converged=converged,
        reliable=converged and not doubt,
        message=_told(model, chi2, limit, settled, bright, doubt, deviations, work),
        flux=own[-2].copy(),
        background=own[-1].copy(),
        center=center,
        psf=psf[0],
        images=np.where(seen.reshape(values.shape), values, np.nan),
        model=noise.image(mean.reshape(values.shape)),
        residual=residual.reshape(values.shape),
        steps=steps,
        starts=starts,
    )


def label(name: Name) -> str:
    """Return what to call a term in a table: with Noll's index and the name that opticians have for it."""
    if isinstance(name, str):
        if name in POWERS or name in _UNITS:
            return name
        order, index = name.split()
        n, m = zernike.term(int(index), order)
        return f"{name} {zernike.name(n, m)}"
    n, m = name
    return f"noll {zernike.index_of(n, m, 'noll')} {zernike.name(n, m)}"


def _nearer(model: StarImages, fits: Fits) -> Array:
    """Return the parameters, of two wavefronts with the same images those to give."""
    x = fits.x
    if not model.twins:
        return x
    twin = model.twin(x)
    start = np.pad(model.start, (0, model.size - len(model.start)))
    far, near = (float(model.rms(part - start)[0]) for part in (x, twin))
    even = next(j for j, row in enumerate(model.directions) if row[model.even].any())
    if near < far * (1.0 - 1e-6) or (near < far * (1.0 + 1e-6) and twin[0, even] > x[0, even]):
        return twin
    return x


def _doubt(model: StarImages, x: Array, inverse: Array) -> str:
    """Return why the standard errors of the answer `x` are not to be trusted, or nothing."""
    error, axes = scoring.uncertainty(model, inverse)
    if error > scoring.CERTAIN:
        return (
            f"the standard errors are not to be trusted: together they make {error:.2g} rad rms of phase in an "
            "image, and other wavefronts may fit as well"
        )
    changes = scoring.changes(model, x, inverse, axes)
    worst = [k for k in np.argsort(-changes) if changes[k] > scoring.STEADY]
    if not worst:
        return ""
    names = ", ".join(label(model.unknowns.shared[k]) for k in worst[:3])
    more = f" and {len(worst) - 3} more" if len(worst) > 3 else ""
    return (
        f"the standard errors of {names}{more} are not to be trusted: within one standard deviation of the answer "
        f"they change by a factor of up to {changes[worst[0]]:.3g}"
    )


def _told(
    model: StarImages,
    chi2: float,
    limit: float,
    settled: bool,
    bright: Array,
    doubt: str,
    deviations: Array,
    work: str,
) -> str:
    """Return the verdict, and what else to say; `bright` are fluxes over their standard errors."""
    work = f"chi2 {chi2:.3g} a degree of freedom {work}"
    if chi2 >= limit:
        said = [
            f"misfit: {work}; pupil, pixel or noise do not fit, or terms are missing, or no start was near enough"
        ]
    elif bright.min() < _SEEN:
        said = [f"no star: {work}, but the flux of image {int(np.argmin(bright))} is within the noise"]
    elif not settled:
        said = [f"the steps did not settle: {work}"]
    elif doubt:
        said = [f"converged, but {doubt}; {work}"]
    else:
        said = [f"converged: {work}"]
    if chi2 < 2.0 - limit:
        said.append("the images are less noisy than white, read and offset of the noise say")
    if model.twins:
        said.append(
            "one defocus of all images leaves the common sign of the even terms open: images at two would settle it"
        )
    unknown = ~np.isfinite(deviations)
    if unknown.any():
        names = [label(n) for n, blind in zip(model.unknowns.shared, unknown[: model.shared], strict=True) if blind]
        said.append(f"the images do not tell {', '.join(names) or 'all of their places and light'}")
    return "; ".join(said)
