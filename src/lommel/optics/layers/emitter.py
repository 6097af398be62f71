r"""Emitters and beams of microscopes, as Hermitian forms of the radial field integrals.

The intensity is ``h0(r) + h1(r) (a cos phi + b sin phi) + h2(r) (c cos 2 phi + d sin 2 phi)``, each h a
Hermitian form of the integrals of :mod:`lommel.optics.layers.debye`, phi the azimuth on the camera from columns to
rows. With M the mean of ``p p^T`` over the directions of a dipole and K0, K1, K2 of
:class:`lommel.optics.layers.objective.FocalField`:

.. math:: (M_{xx} + M_{yy})(|K_0|^2 + |K_2|^2) + 4 M_{zz} |K_1|^2
   - 4 \, \Im[K_1^* (K_0 + K_2)] (M_{xz} \cos\phi + M_{yz} \sin\phi)
   + 2 \, \Re[K_0 K_2^*] ((M_{xx} - M_{yy}) \cos 2\phi + 2 M_{xy} \sin 2\phi).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.optics.layers.debye import Model

Form = NDArray[np.complex128]


_JONES: dict[str, tuple[complex, complex]] = {"circular": (1.0, 1.0j), "x": (1.0, 0.0), "y": (0.0, 1.0)}
_AROUND = ("radial", "azimuthal", "vortex")


class Harmonic(NamedTuple):
    """One azimuthal order: ``h = sum_jl form[j, l] F_j conj(F_l)`` of parts F, and factors of its cosine and sine."""

    order: int
    form: Form
    cosine: float
    sine: float


class Waves(NamedTuple):
    r"""Fields ``U_a`` of orders q and parts T with any pupil phase, ``I = sum_ab form[a, b] U_a conj(U_b)``.

    .. math:: U_a = \frac{1}{2 \pi} \int\!\!\int P \, T_a(\rho) \, e^{i q_a \theta}
       e^{i \psi - i v \rho \cos(\theta - \phi)} \rho \, d\rho \, d\theta .
    """

    orders: tuple[int, ...]
    parts: tuple[int, ...]
    form: Form


class Light(NamedTuple):
    """The integrals of a model, and the forms that make intensities of them, the diagonal order 0 first."""

    model: Model
    harmonics: tuple[Harmonic, ...]
    waves: Waves

    @property
    def radial(self) -> bool:
        """Whether the intensity does not depend on the azimuth."""
        return len(self.harmonics) == 1

    @property
    def shares(self) -> NDArray[np.float64]:
        """Weight of the light of each part."""
        return np.diag(self.harmonics[0].form).real


def _form(parts: int, entries: dict[tuple[int, int], complex]) -> Form:
    """Return the Hermitian matrix with these entries on and above its diagonal."""
    # Intensities are real: the form is Hermitian.
    form = np.zeros((parts, parts), np.complex128)
    for (j, l), value in entries.items():
        form[j, l], form[l, j] = value, np.conj(value)
    return form


_U = np.eye(5)[:, :, None]  # U_0, U_1, U_-1, U_2 and U_-2, of K0, K1, K1, K2, K2
_B, _C = -0.5 * (_U[3] + _U[4]), -0.5j * (_U[4] - _U[3])
# The fields along x and y on the camera of dipoles along x, y and z. By reciprocity these are fields of beams, too,
# along x, y and z in the sample.
_CAMERA = np.stack(
    [np.hstack([_U[0] + _B, _C, _U[1] + _U[2]]), np.hstack([_C, _U[0] - _B, -1j * (_U[1] - _U[2])])]
).astype(np.complex128)


def _vectorial(form: Form, *harmonics: Harmonic) -> Light:
    kept = [each for each in harmonics if not each.order or each.cosine or each.sine]
    return Light(Model(), tuple(kept), Waves((0, 1, -1, 2, -2), (0, 1, 1, 2, 2), form))


_ALONG = _form(3, {(0, 1): 0.5j, (1, 2): -0.5j})
"""``Im[K1^* (K0 + K2)]``, negative: of order 1."""
_ACROSS = _form(3, {(0, 2): 0.5})
"""``Re[K0 K2^*]``, of order 2."""


@dataclass(frozen=True)
class Dipole:
    """Dipole emitter with a fixed orientation, or one that wobbles about it.

    Parameters
    ----------
    polar : float
        Polar angle from the optical axis, radians.
    azimuth : float
        Azimuth from the columns (x) of the camera towards its rows (y), radians.
    wobble : float, default 0
        0 for a fixed dipole, 1 for a freely rotating one: the isotropic share of its directions.

    Raises
    ------
    TypeError, ValueError
        If an argument is not finite, or the wobble outside 0 to 1.

    Notes
    -----
    The dipole moment is that of a freely rotating dipole, whose emission is the mean over all directions; PSFs with
    ``normalize="energy"`` are relative to the light that the objective collects.
    """

    polar: float
    azimuth: float
    wobble: float = 0.0

    def __post_init__(self) -> None:
        polar, azimuth = validation.real("polar", self.polar), validation.real("azimuth", self.azimuth)
        wobble = validation.real("wobble", self.wobble, least=0.0)
        if wobble > 1.0:
            raise ValueError(f"wobble must be from 0 to 1, got {wobble:g}")
        vars(self).update(polar=polar, azimuth=azimuth, wobble=wobble)

    @property
    def moments(self) -> Array:
        """Three times the mean of ``p p^T`` over its directions: the unit matrix for a freely rotating dipole."""
        flat, azimuth = math.sin(self.polar), self.azimuth
        # The unit vector of the dipole moment.
        p = np.array([flat * math.cos(azimuth), flat * math.sin(azimuth), math.cos(self.polar)])
        return np.asarray(3.0 * (1.0 - self.wobble) * np.outer(p, p) + self.wobble * np.eye(3))

    @property
    def light(self) -> Light:
        """Integrals and forms of the intensity."""
        M = self.moments
        level = 0.5 * (M[0, 0] + M[1, 1])
        return _vectorial(
            0.5 * np.einsum("caj,jl,cbl->ab", _CAMERA, M, _CAMERA.conj()),
            Harmonic(0, _form(3, {(0, 0): level, (1, 1): 2.0 * M[2, 2], (2, 2): level}), 1.0, 0.0),
            Harmonic(1, _ALONG, 2.0 * M[0, 2], 2.0 * M[1, 2]),
            Harmonic(2, _ACROSS, M[0, 0] - M[1, 1], 2.0 * M[0, 1]),
        )


@dataclass(frozen=True)
class Beam:
    """A uniform beam through the back of the objective, focused into the sample.

    Parameters
    ----------
    polarization : {"circular", "x", "y", "radial", "azimuthal", "vortex"} or (complex, complex), default "circular"
        Jones vectors ``(a, b)`` are along columns and rows of the camera, of any length. "circular" is (1, i),
        equivalent to unpolarized light without aberrations. "radial" and "azimuthal" polarization are towards and
        around the axis; "azimuthal" and "vortex" (circular light behind a vortex phase plate, the doughnut of STED)
        are dark on it.

    Raises
    ------
    TypeError, ValueError
        If `polarization` is none of these.
    """

    polarization: str | tuple[complex, complex] = "circular"

    def __post_init__(self) -> None:
        if isinstance(self.polarization, str):
            validation.choice("polarization", self.polarization, (*_JONES, *_AROUND))
            return
        jones = validation.array("polarization", self.polarization)
        fit = jones.shape == (2,) and jones.dtype.kind in "iufc"
        if not fit or not np.isfinite(jones).all() or not np.abs(jones).max() > 0.0:
            got = validation.shown(self.polarization)
            raise ValueError(f"polarization must be a name or two finite numbers, not both 0, got {got}")
        object.__setattr__(self, "polarization", tuple(jones.astype(complex).tolist()))

    @property
    def light(self) -> Light:
        """Integrals and forms of the intensity."""
        waves = self._waves(np.eye(3))
        if self._around is not None:
            return _light(self._around, waves)
        a, b = self._jones
        power = abs(a) ** 2 + abs(b) ** 2
        # Order 2 of linearly polarised light; the cross terms of circular light cancel.
        turned = _form(3, {(0, 2): 1.0, (1, 1): 2.0})
        across, along = (abs(a) ** 2 - abs(b) ** 2) / power, 2.0 * (a * np.conj(b)).real / power
        steady = Harmonic(0, np.diag([1.0, 2.0, 1.0]).astype(np.complex128), 1.0, 0.0)
        return _vectorial(waves.form, steady, Harmonic(2, turned, across, along))

    @property
    def _around(self) -> str | None:
        """The polarization, if it or its phase rotates with the azimuth."""
        named = isinstance(self.polarization, str) and self.polarization in _AROUND
        return str(self.polarization) if named else None

    @property
    def _jones(self) -> tuple[complex, complex]:
        return _JONES[self.polarization] if isinstance(self.polarization, str) else self.polarization

    def _waves(self, moments: Array) -> Waves:
        """Return ``sum_jl moments[j, l] E_j conj(E_l)``, E the field along x, y and z in the sample."""
        orders: tuple[int, ...] = (0, 1, -1, 2, -2)
        parts: tuple[int, ...] = (0, 1, 1, 2, 2)
        if self._around in (None, "vortex"):
            jones = self._jones if self._around is None else _JONES["circular"]
            # By reciprocity, the field of a beam in the sample is that of dipoles on the camera.
            field = np.einsum("c,cul->lu", jones, _CAMERA) / np.linalg.norm(jones)
            if self._around:
                # Of circular light there is one sense of each order, and its phase turns once more.
                field, orders, parts = field[:, [0, 1, 3]], (1, 2, 3), (0, 1, 2)
        else:
            # The part along the axis has a factor i.
            towards, across, along = [0.5, 0.5, 0.0], [-0.5j, 0.5j, 0.0], [0.0, 0.0, -1.0j]
            radial = self._around == "radial"
            field = np.array([towards, across, along] if radial else [np.negative(across), towards, np.zeros(3)])
            orders, parts = (1, -1, 0), (1, 1, 0)
        return Waves(orders, parts, np.einsum("la,lm,mb->ab", field, moments, field.conj()))


@dataclass(frozen=True)
class Absorbed(Beam):
    """Excitation of a dipole by a beam: three times the intensity of the field along the dipole.

    Its mean over all directions of the dipole is the intensity of the beam.
    """

    dipole: Dipole = Dipole(0.0, 0.0)

    @property
    def light(self) -> Light:
        """Integrals and forms of the intensity."""
        return _light(self._around or "vectorial", self._waves(self.dipole.moments))


def _light(kind: str, waves: Waves) -> Light:
    """Return all azimuthal orders of waves, whose ``U_q`` is ``(-i)^abs(q) exp(i q phi)`` times its K."""
    model, orders = Model(kind), np.array(waves.orders)
    # (-i)^abs(q) of the Bessel expansion of a plane wave, for each order q.
    turns = (-1j) ** np.abs(orders)
    form = waves.form * np.multiply.outer(turns, turns.conj())
    found = []
    # Products of two waves have the difference of their orders.
    for m in range(2 * int(orders.max()) + 1):
        F = np.zeros((len(model.orders), len(model.orders)), np.complex128)
        for a, b in np.argwhere(np.subtract.outer(orders, orders) == m):
            F[waves.parts[a], waves.parts[b]] += form[a, b]
        each = ((F + F.conj().T, 1.0, 0.0), (1j * (F - F.conj().T), 0.0, 1.0)) if m else ((F, 1.0, 0.0),)
        found += [Harmonic(m, *one) for one in each if not m or np.abs(one[0]).max() > 1e-15]
    return Light(model, tuple(found), waves)


@dataclass(frozen=True)
class Scalar:
    """Scalar emitter of the model of Gibson and Lanni, without polarization and Fresnel losses.

    Parameters
    ----------
    apodization : {"uniform", "aplanatic"}, default "uniform"
        Amplitude across the pupil: 1, as published, or ``c_i^(-1/2)``, of the sine condition.
    supercritical : bool, default True
        Whether to include light beyond the critical angle of the sample, which the published model omits.

    Raises
    ------
    TypeError, ValueError
        If an argument is none of these.
    """

    apodization: str = "uniform"
    supercritical: bool = True

    def __post_init__(self) -> None:
        validation.choice("apodization", self.apodization, ("uniform", "aplanatic"))
        validation.truth("supercritical", self.supercritical)

    @property
    def light(self) -> Light:
        """Integrals and forms of the intensity."""
        model = Model("scalar", aplanatic=self.apodization == "aplanatic", supercritical=self.supercritical)
        one = np.eye(1, dtype=np.complex128)
        return Light(model, (Harmonic(0, one, 1.0, 0.0),), Waves((0,), (0,), one))


Emitter = Dipole | Beam | Scalar


@lru_cache(maxsize=64)
def light_of(emitter: Emitter) -> Light:
    """Return ``emitter.light``, kept for the pupils that share it."""
    return emitter.light


_NAMED: dict[str, Emitter] = {"isotropic": Dipole(0.0, 0.0, wobble=1.0), "scalar": Scalar()}


def emitter_of(value: object) -> Emitter:
    """Return the emitter of a name, or itself; TypeError or ValueError otherwise."""
    if isinstance(value, Emitter):
        return value
    if isinstance(value, str) and value in _NAMED:
        return _NAMED[value]
    raise (ValueError if isinstance(value, str) else TypeError)(
        f'emitter must be "isotropic", "scalar", a Dipole, a Beam or a Scalar, got {validation.shown(value)}'
    )
