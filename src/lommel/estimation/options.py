"""Options of phase retrieval, of fits to beads, and of field maps; commands read them without the fits."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.options import HIDDEN, In, Options, Shown
from lommel.blur.blurs import Blur
from lommel.recorded.noise import random_numbers


def defoci(name: str, value: ArrayLike) -> tuple[float, ...]:
    """Return the known defocus of images as a tuple; ValueError if `value` is neither a number nor a sequence."""
    values = validation.real_array(name, value, unit="radians")
    if values.ndim > 1:
        raise ValueError(f"{name} must be a number, or one for each image, got shape {values.shape}")
    return tuple(np.atleast_1d(values).tolist())


def require_seed(_: str, value: int | np.random.Generator) -> Any:
    """Return a seed or generator; TypeError if it is neither."""
    random_numbers(value)
    return value


def names_in(text: str) -> list[str]:
    """Return the names in a text with commas; none for "none"."""
    names = [name.strip() for name in text.split(",")]
    return [] if names in (["none"], [""]) else names


def terms_in(text: str) -> int | list[str]:
    """Return the number, or the names, of Zernike terms in a text; names may be those printed in tables."""
    from lommel.special import zernike

    if text.strip().isdecimal():
        return int(text)
    noll_names = {zernike.name(*zernike.term(j, "noll")): f"noll {j}" for j in range(_LAST_NAMED, 4, -1)}
    names = []
    for name in names_in(text):
        order, _, remainder = name.partition(" ")
        index, _, printed = remainder.partition(" ")
        # The table prints "noll 8 coma x"; the user may also write "coma x" alone.
        if order in zernike.ORDERS and printed:
            name = f"{order} {index}"
        names.append(noll_names.get(name, name) if name not in ("defocus", "spherical") else name)
    return names


_LAST_NAMED = 66  # Noll index of the last term with a name of its own


Terms: TypeAlias = Annotated[int | Sequence[tuple[int, int] | str], Shown(metavar="TERMS", parse=terms_in)]
Defoci: TypeAlias = Annotated[tuple[float, ...], defoci, Shown(metavar="NUMBERS")]
KnownBlur: TypeAlias = Annotated[bool | float | Blur | Iterable[Blur], HIDDEN]


@dataclass(frozen=True, kw_only=True)
class FitOptions(Options):
    """Options of all fits.

    Parameters
    ----------
    progress : callable, optional
        Called as ``progress(fraction, chi2)`` before each step; `fraction` of the time rises from 0 to at most 1,
        and falls where another fit follows. An exception raised by this function stops the search.
    """

    progress: Annotated[Callable[[float, float], object] | None, HIDDEN] = None


@dataclass(frozen=True, kw_only=True)
class RetrieveOptions(FitOptions):
    """Options of :func:`lommel.retrieve`.

    Parameters
    ----------
    terms : int or sequence, default 15
        Terms to estimate: a number of Zernike terms from defocus on (15: Noll's indices 4 to 18), or a sequence of
        pairs (n, m) or names such as "noll 11", "ansi 12", "fringe 9" (radians rms), "defocus" (C_d), "spherical"
        (C_s), "rho^6", "rho^8" (radians, see :class:`lommel.Wavefront`). May be empty. Other terms of `pupil` are
        fixed.
    defocus : float or array_like, shape (n,), default ()
        Known additional defocus C_d of each image, radians; positive if the sensor was moved towards the lens. See
        :attr:`lommel.Wavefront.defocus`.
    also : str or sequence of str, default ("center",)
        Nuisance parameters: "center" ("row" and "column" of each image) and, common to all images, "f_number",
        "obscuration" (without a mask) and "wavelength" (at fixed path differences). Pass an empty sequence if the
        axis is known to be in the middle of pixel ``(height // 2, width // 2)``.
    blur : bool, float, Blur or iterable of Blur, default False
        Blur of each image. True: estimate seeing and a Gaussian (vibration, charge diffusion), as
        :func:`lommel.fit_field` does. A number is the known standard deviation of a Gaussian in pixels. Known
        isotropic blurs may be given, such as :class:`lommel.Seeing` and :class:`lommel.Jitter`. Unless `blur` is
        False, `also` must be "center".
    seed : int or Generator, default 0
        Seed or generator of random starts.
    checks : bool, default True
        False: omit the tests of effects that the model lacks, of patterns and of standard errors, which take longer
        than the fit of small images. Coefficients are then those of maximum likelihood, `errors` the Cramér-Rao
        bound, and the result is in doubt until :meth:`~lommel.estimation.phase_retrieval.Retrieval.checked` tests it.
        With `blur`, tests are part of the fit.
    """

    terms: Terms = 15
    defocus: Defoci = ()
    also: Annotated[str | Sequence[str], Shown(metavar="NAMES", parse=names_in)] = ("center",)
    blur: KnownBlur = False
    seed: Annotated[int | np.random.Generator, require_seed, HIDDEN] = 0
    checks: Annotated[bool, HIDDEN] = True


@dataclass(frozen=True, kw_only=True)
class BeadOptions(FitOptions):
    """Options of :func:`lommel.fit_beads`.

    Parameters
    ----------
    diameter : float, default 0
        Diameter of the beads, metres; 0 for points.
    depth : float or sequence, optional
        Depth of the centre of each bead below the cover glass, metres; by default the radius (beads on the glass).
    terms : int or sequence, default 18
        Zernike terms to estimate: a number of terms from Noll's index 5 on, or a sequence of pairs (n, m) or names
        such as "noll 11". Piston, tilts and defocus are excluded: the positions of the beads replace them.
    apodization : int, default 0
        Number of terms of the pupil amplitude to estimate, 0 to 4: radial Zernike terms of degree 2, 4, 6, 8 of the
        logarithm of the amplitude, see :meth:`lommel.Apodization.zernike`. Their names, in `priors` and in the
        result, are "apodization_2" to "apodization_8".
    drift : bool, default False
        Estimate a lateral drift of each bead, linear in time.
    joint : int, default 20
        Largest number of beads that determine terms and constants, evenly chosen from all beads. Of further beads,
        only position, flux and background are estimated: their time is short, and linear in their number.
    priors : mapping, optional
        Constants to estimate: name -> standard error of the prior, or (value, standard error); inf means no prior
        knowledge. Names are "sample" and "immersion" (refractive indices), "coverslip" (thickness), "NA", "pixel",
        "diameter", "blur" (variance of a Gaussian, pixels squared), "step" (factor of z), "wavelength", "depth"
        (separate for each bead). The default is depth 20 nm, sample 0.003, coverslip 5 um, pixel 1 %, diameter 10 %,
        and NA 0.02 if a bead is within a wavelength of the cover glass. An empty mapping fixes all constants.
    """

    diameter: Annotated[float, In(least=0.0, most=1e-5, unit="metres"), Shown(("--bead",), length="nm")] = 0.0
    depth: Annotated[float | Sequence[float] | None, Shown(length="um")] = None
    terms: Terms = 18
    apodization: Annotated[int, In(least=0, most=4)] = 0
    drift: bool = False
    joint: Annotated[int, In(least=1)] = 20
    priors: Annotated[Mapping[str, float | tuple[float, float]] | None, HIDDEN] = None


@dataclass(frozen=True, kw_only=True)
class FieldFitOptions(FitOptions):
    """Options of :func:`lommel.fit_field`.

    Parameters
    ----------
    degree : int, default 3
        Total degree of the polynomials in x and y, 0 to 6. It is lowered if there are fewer than two stars for each
        coefficient.
    terms : int or sequence, default 11
        Terms to estimate, see :func:`lommel.retrieve`: 11 means Noll's indices 4 to 14.
    defocus : float or array_like, shape (e,), default ()
        Known additional defocus C_d of each exposure, radians; positive if the sensor was moved towards the lens.
    blur : bool, float, Blur or iterable of Blur, default True
        True: estimate the blur of each exposure. For stars it is seeing (Kolmogorov, or von Karman with an outer
        scale of 1000, 240 or 60 r0), a Gaussian (jitter or charge diffusion), or both, whichever is most likely; for
        pinholes and corners it is a Gaussian. False: no blur. A number is the known standard deviation of a Gaussian
        in pixels. Known isotropic blurs may be given, such as :class:`lommel.Seeing` and :class:`lommel.Jitter`.
    size : float, optional
        Diameter of the images of pinholes, by default points; or side of the image of a square, by default the
        `square` of :func:`lommel.detection.find_crossings`, else infinite. In the unit of `pixel`.
    ideal : array_like, shape (n, 2), optional
        Row and column of each target without distortion, in any unit and from any origin, for example the nominal
        positions of pinholes, or catalogue positions of stars in the tangent plane; NaN if unknown. If given,
        distortion of the first exposure is estimated, with the shift, rotation and magnification of these places.
    distortion : int, optional
        Total degree, 0 to 9, of the polynomials in x and y that describe the displacement: 3, the default, for
        third-order distortion (W311), 5 for fifth order. It is lowered if there are fewer than two known places per
        coefficient.
    """

    degree: Annotated[int, In(least=0, most=6)] = 3
    terms: Terms = 11
    defocus: Defoci = ()
    blur: KnownBlur = True
    size: Annotated[float | None, In(above=0.0, unit="the unit of pixel"), Shown(length="um")] = None
    ideal: Annotated[ArrayLike | None, HIDDEN] = None
    distortion: Annotated[int | None, In(least=0, most=9), Shown(metavar="DEGREE")] = None
