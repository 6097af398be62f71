"""Images and their derivatives by what :mod:`lommel.methods.derivatives` names, each with a proven bound.

Phases that are radially symmetric, of pupils that are too, are differentiated by the radial series, whose samples
tell of shifts and of growth as well; all else by the chordal rule. White light is the sum of what each wavelength
makes.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.core.answers import Images, Wanted
from lommel.methods.choice import first_proven
from lommel.methods.chordal_gauss import ChordalGauss
from lommel.methods.derivatives import Name, Parts, Term, parts
from lommel.methods.growth import TILTS, growth, tilted
from lommel.methods.method import Method, storing, widened
from lommel.methods.nijboer_zernike import NijboerZernike
from lommel.methods.polychromatic import Polychromatic
from lommel.methods.rim import by_obscuration
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil
from lommel.special import zernike

Key = int | Term
"""What engines differentiate by: the coefficient of rho^(2k), under k, or that of a Zernike term."""

_MOST_POWERS = 4  # of rho^2, that the radial terms are taken as, whose powers cancel
_MOST_CANCELLED = 321.0


class Slope(NamedTuple):
    """A derivative of images.

    Attributes
    ----------
    values : ndarray, shape (n, height, width)
    error : ndarray, shape (n,)
        Bound on its error over the peak of the images.
    """

    values: NDArray[Any]
    error: Array


class Piece(NamedTuple):
    """What a derivative is summed from, with a bound on its error, shape (n,), absolute."""

    values: Array
    error: Array


def differentiated(
    method: Method | None,
    pupil: Pupil,
    grid: Grid,
    names: Sequence[Name],
    wanted: Wanted,
    tol: float,
    *,
    energy: bool,
) -> tuple[Method, Images, list[Slope]]:
    """Return images, their derivatives by checked names, and the method that made them.

    Parameters
    ----------
    method : Method or None
        None where none was named.
    pupil : Pupil
        That the method supports.
    grid : Grid
    names : sequence
    wanted : Wanted
        Of the images, with a scale.
    tol : float
        That of the method.
    energy : bool
        Whether values are fractions of all light.

    Returns
    -------
    method : Method
    images : Images
    slopes : list of Slope
        One for each name.

    Raises
    ------
    ValueError
        If the aperture, the method or the pupil has no such derivatives.
    ToleranceError
        If the tolerance cannot be met.
    """
    sums = [parts(name, pupil, grid.step(pupil), energy=energy) for name in names]
    way, engine = engines(method, pupil, names, sums, tol)
    powers = isinstance(engine, NijboerZernike)
    sums = [each._replace(phases=translated(each.phases, powers=powers)) for each in sums]
    # What is one derivative times a factor is stored by what makes the images, all else summed in double precision.
    easy = [way is engine and _single(each, engine) for each in sums]
    simple, others = (
        [each for each, is_one in zip(sums, easy, strict=True) if is_one is which] for which in (True, False)
    )
    keys = _keys(simple)
    made = widened(_asked(way, pupil, grid, wanted, keys), pupil, way, normalized=False)
    taken = iter(_taken(made, simple, keys))
    pieces = _pieces(way, engine, pupil, grid, made, wanted, others) if others else {}
    slopes = [
        next(taken) if is_one else _combined(each, made, pieces, wanted.dtype)
        for each, is_one in zip(sums, easy, strict=True)
    ]
    return way, made, slopes


def _keys(sums: Sequence[Parts]) -> tuple[Key, ...]:
    """Return what derivatives are wanted by, each once."""
    return tuple(dict.fromkeys(key for each in sums for key in each.phases))


def single_light(method: Method | None) -> Method | None:
    """Return the method for each wavelength; None where none was named."""
    return method.method if isinstance(method, Polychromatic) else method


def engines(
    method: Method | None, pupil: Pupil, names: Sequence[Name], sums: Sequence[Parts], tol: float
) -> tuple[Method, Method]:
    """Return what makes images, and what makes their derivatives at each wavelength.

    Parameters
    ----------
    method : Method or None
        None where none was named.
    pupil : Pupil
    names : sequence
    sums : sequence of Parts
        What each is made of.
    tol : float
        Where none was named.

    Returns
    -------
    (Method, Method)

    Raises
    ------
    ValueError
        If nothing has these derivatives, or not what was named.
    """
    if not pupil.circular:
        raise ValueError(
            "derivatives are available of round apertures only; with a spider, vignetting or a mask take "
            "differences, as (psf(a + h) - psf(a - h)) / (2 h)"
        )
    engine, radial = single_light(method), pupil.radial and all(map(_radial, sums))
    if engine is None:
        engine = NijboerZernike(tol) if radial else ChordalGauss(tol)
    elif isinstance(engine, NijboerZernike) and not radial:
        listed = ", ".join(map(repr, names))
        raise ValueError(
            f"derivatives by {listed} are not available from NijboerZernike, which has those by radially symmetric "
            "terms and by shifts, of pupils that are radially symmetric too; use ChordalGauss, or name no method"
        )
    elif not isinstance(engine, NijboerZernike | ChordalGauss):
        raise ValueError(
            f"derivatives are not available from {type(engine).__name__}; use NijboerZernike or ChordalGauss, or "
            "name no method"
        )
    return (method if isinstance(method, Polychromatic) else engine), engine


def _radial(each: Parts) -> bool:
    """Return whether a derivative is by powers of rho, terms that are few of these, or what samples of I tell."""

    def known(key: Key) -> bool:
        return isinstance(key, int) or key in TILTS or (key[1] == 0 and key[0] <= 2 * _MOST_POWERS)

    return all(map(known, each.phases)) and not each.rim


def _single(each: Parts, engine: Method) -> bool:
    """Return whether a derivative is one by a coefficient, times a factor, as the engine has it along with images."""
    tilt = isinstance(engine, NijboerZernike) and any(key in TILTS for key in each.phases)
    return len(each.phases) == 1 and not (tilt or np.any(each.own) or np.any(each.growth) or each.rim)


def translated(phases: Mapping[Key, Any], *, powers: bool) -> dict[Key, Any]:
    """Return factors by powers of rho as such by Zernike terms, whose sums these are, or the other way round.

    Parameters
    ----------
    phases : mapping
        As of :attr:`Parts.phases`.
    powers : bool
        Whether all are to be by powers.

    Returns
    -------
    dict
    """
    found: dict[Key, Any] = {}
    for key, factor in phases.items():
        shares: dict[Key, float] = {key: 1.0}
        if powers and isinstance(key, tuple) and key not in TILTS:
            column = zernike.legendre_to_powers(key[0] // 2)[:, -1]
            shares = {k: float(share) for k, share in enumerate(column, 1)}
        elif not powers and isinstance(key, int):
            column = zernike.powers_to_legendre(key)[1:, -1]
            shares = {(2 * j, 0): float(share) for j, share in enumerate(column, 1)}
        for other, share in shares.items():
            found[other] = found.get(other, 0.0) + share * factor
    return found


def _asked(engine: Method, pupil: Pupil, grid: Grid, wanted: Wanted, keys: tuple[Key, ...] = ()) -> Images:
    """Return images and their derivatives by some coefficients, which are powers of rho or Zernike terms."""
    powers = tuple(key for key in keys if isinstance(key, int))
    terms = tuple(key for key in keys if isinstance(key, tuple))
    return engine.images(pupil, grid, wanted._replace(powers=powers, terms=terms))


def _brightest(made: Images) -> Array:
    """Return what the peak of images is at least, shape (n,)."""
    top = made.values.reshape(len(made.values), -1).max(axis=1).astype(np.float64)
    if made.peak is not None:
        top = np.maximum(top, made.peak * made.scale)
    assert made.error is not None
    return np.asarray(top / (1.0 + made.error))


def _taken(made: Images, sums: Sequence[Parts], keys: tuple[Key, ...]) -> list[Slope]:
    """Return derivatives that are those by one coefficient each, times a factor."""
    found, taken = [], set[int]()
    for each in sums:
        assert made.slopes is not None
        ((key, factor),) = each.phases.items()
        at = keys.index(key)
        values, error, by = made.slopes.values[at], made.slopes.error[at], _each(factor, len(made.values))
        if not np.all(by == 1.0):
            values = (values * by[:, None, None]).astype(values.dtype)
            rounded = _most(values) * storing(values.dtype) * (by != 2.0)  # a power of two rounds nothing
            error = np.abs(by) * error + rounded / _brightest(made)
        elif at in taken:
            values = values.copy()
        taken.add(at)
        found.append(Slope(values, error))
    return found


def _each(factor: Any, count: int) -> Array:
    """Return a factor for each pupil."""
    return np.broadcast_to(np.asarray(factor, dtype=np.float64), (count,))


def _most(values: NDArray[Any]) -> Array:
    """Return the largest magnitude in each image."""
    return np.asarray(np.abs(values).reshape(len(values), -1).max(axis=1), dtype=np.float64)


def _pieces(
    way: Method,
    engine: Method,
    pupil: Pupil,
    grid: Grid,
    made: Images,
    wanted: Wanted,
    sums: Sequence[Parts],
) -> dict[Any, Piece]:
    """Return all that the derivatives of images are summed from but these, in double precision, over all light."""
    # Powers cancel, by those of the highest radial term 321 times at most.
    size = max(
        sum(float(np.abs(by).max()) for key, by in each.phases.items() if isinstance(key, int)) for each in sums
    )
    closer = engine.tightened(engine.tol / min(size, _MOST_CANCELLED)) if size > 2.0 else engine
    grows, rim = (any(np.any(getattr(each, part)) for each in sums) for part in ("growth", "rim"))
    keys = _keys(sums)
    asked = tuple(dict.fromkeys((*keys, *TILTS))) if grows else keys
    by_samples = isinstance(engine, NijboerZernike)  # of radially symmetric pupils, whose tilts are not
    assert isinstance(wanted.scale, float)
    faintest = float(_brightest(made).min()) / wanted.scale
    found: dict[Any, Piece] = {}

    def add(key: Any, values: Array, error: Array, factor: float) -> None:
        before = found.get(key, Piece(np.zeros((1, 1, 1)), np.zeros(1)))
        found[key] = Piece(before.values + factor * values, before.error + factor * error)

    for part in way.components(pupil):
        scale, threads = wanted.scale * part.weight, wanted.threads
        left = (part.pupil.wavefront.left_out + 2.0 * part.pupil.illumination.error) * part.pupil.amplitude**2
        add("unknown", np.zeros((1, 1, 1)), np.full(1, 2.0 * left), scale)
        slopes: dict[Key, Piece] = {}
        if by_samples and any(key in TILTS for key in asked):
            for term, (values, error) in zip(TILTS, tilted(engine, part.pupil, grid, threads), strict=True):
                slopes[term] = Piece(values, error + 4.0 * left)
        if rest := tuple(key for key in asked if key not in slopes):
            ask = partial(_asked, pupil=part.pupil, grid=grid, wanted=Wanted(threads=threads), keys=rest)
            _, here = first_proven((closer, engine), ask)
            assert here.slopes is not None
            assert here.peak is not None
            for key, values, error in zip(rest, *here.slopes, strict=True):
                slopes[key] = Piece(values, error * here.peak + 4.0 * left)
        for key in keys:
            # Phases are path differences: in radians they grow as the wavelength falls.
            add(key, *slopes[key], scale * part.stretch)
        if grows:
            add("growth", *growth(engine, part.pupil, grid, [slopes[key] for key in TILTS], threads), scale)
        if rim:
            add("rim", *by_obscuration(part.pupil, grid, 0.1 * engine.tol * faintest), scale)
    return found


def _combined(each: Parts, made: Images, pieces: Mapping[Any, Piece], dtype: Any) -> Slope:
    """Return the sum of pieces, each times its factor, and of the images themselves, as it is stored."""
    assert made.error is not None
    count, bright = len(made.values), _brightest(made)
    factors: dict[Any, Any] = {**each.phases, "growth": each.growth, "rim": each.rim, "unknown": each.unknown}
    total = made.values * _each(each.own, count)[:, None, None].astype(np.float64)
    error = np.abs(_each(each.own, count)) * made.error * bright * (1.0 + made.error)
    size = _most(total)
    for key, factor in factors.items():
        by = _each(factor, count)
        if by.any():
            total += by[:, None, None] * pieces[key].values
            error = error + np.abs(by) * pieces[key].error
            size = size + np.abs(by) * _most(pieces[key].values)
    values = total.astype(dtype)
    error = error + (len(factors) + 8) * 2.0**-53 * size + storing(dtype) * _most(total)
    return Slope(values, error / bright)
