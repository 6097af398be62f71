r"""Emitters and beams of microscopes, as Hermitian forms of the radial field integrals.

The intensity is ``h0(r) + h1(r) (a cos phi + b sin phi) + h2(r) (c cos 2 phi + d sin 2 phi)``. phi is the azimuth on
the camera from columns to rows. h0, h1, h2 are Hermitian forms of the integrals of :mod:`lommel.optics.layers.debye`.
For a dipole p, let M be three times the mean of ``p p^T`` over its directions. With K0, K1, K2 of
:class:`lommel.optics.layers.objective.FocalField` the intensity is half of

.. math:: (M_{xx} + M_{yy})(|K_0|^2 + |K_2|^2) + 4 M_{zz} |K_1|^2
   - 4 \, \Im[K_1^* (K_0 + K_2)] (M_{xz} \cos\phi + M_{yz} \sin\phi)
   + 2 \, \Re[K_0 K_2^*] ((M_{xx} - M_{yy}) \cos 2\phi + 2 M_{xy} \sin 2\phi).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.optics.layers.debye import Model

Form = NDArray[np.complex128]


_JONES: dict[str, tuple[complex, complex]] = {"circular": (1.0, 1.0j), "x": (1.0, 0.0), "y": (0.0, 1.0)}
_VECTOR_BEAMS = ("radial", "azimuthal", "vortex")


class Harmonic(NamedTuple):
    """Term ``h (cosine cos(order phi) + sine sin(order phi))`` of the intensity, h = sum_jl form[j, l] F_j conj(F_l).

    F_j are the integrals of the model.
    """

    order: int
    form: Form
    cosine: float
    sine: float


class Waves(NamedTuple):
    r"""Intensity ``I = sum_ab form[a, b] U_a conj(U_b)`` for any pupil function P and fields U_a of orders q_a.

    T_a is the factor of ``exp(i psi) J_m rho d rho`` in the integrand of part ``parts[a]`` of the model.

    .. math:: U_a = \frac{1}{2 \pi} \int\!\!\int P \, T_a(\rho) \, e^{i q_a \theta}
       e^{i \psi - i v \rho \cos(\theta - \phi)} \rho \, d\rho \, d\theta .
    """

    orders: tuple[int, ...]
    parts: tuple[int, ...]
    form: Form


class Light(NamedTuple):
    """Model of the field integrals, and forms that convert them to intensities; `harmonics[0]` has order 0."""

    model: Model
    harmonics: tuple[Harmonic, ...]
    waves: Waves

    @property
    def radial(self) -> bool:
        """True if the intensity does not depend on the azimuth."""
        return len(self.harmonics) == 1

    @property
    def shares(self) -> NDArray[np.float64]:
        """Weight of the power of each integral in the total power."""
        return np.diag(self.harmonics[0].form).real


def _form(parts: int, entries: dict[tuple[int, int], complex]) -> Form:
    """Return the Hermitian matrix with these entries on and above its diagonal."""
    form = np.zeros((parts, parts), np.complex128)
    for (j, l), value in entries.items():
        form[j, l], form[l, j] = value, np.conj(value)
    return form


_U = np.eye(5)[:, :, None]  # unit vectors of U_0, U_1, U_-1, U_2, U_-2, which have the parts K0, K1, K1, K2, K2
_B, _C = -0.5 * (_U[3] + _U[4]), -0.5j * (_U[4] - _U[3])
# Fields [x, y on the camera; U; dipole along x, y, z]. By reciprocity they are also the fields along x, y and z in
# the sample of beams polarised along x and y.
_CAMERA = np.stack(
    [np.hstack([_U[0] + _B, _C, _U[1] + _U[2]]), np.hstack([_C, _U[0] - _B, -1j * (_U[1] - _U[2])])]
).astype(np.complex128)


def _vectorial(form: Form, *harmonics: Harmonic) -> Light:
    nonzero = [harmonic for harmonic in harmonics if not harmonic.order or harmonic.cosine or harmonic.sine]
    return Light(Model(), tuple(nonzero), Waves((0, 1, -1, 2, -2), (0, 1, 1, 2, 2), form))


_FORM_1 = _form(3, {(0, 1): 0.5j, (1, 2): -0.5j})
"""Form of ``-Im[K1^* (K0 + K2)]``, of order 1."""
_FORM_2 = _form(3, {(0, 2): 0.5})
"""Form of ``Re[K0 K2^*]``, of order 2."""


@dataclass(frozen=True)
class Dipole:
    """Dipole emitter with a fixed or a partly random orientation.

    Parameters
    ----------
    polar : float
        Polar angle from the optical axis, radians.
    azimuth : float
        Azimuth from the columns (x) of the camera towards its rows (y), radians.
    wobble : float, default 0
        Isotropic fraction of the distribution of orientations: 0 for a fixed dipole, 1 for a freely rotating dipole.

    Raises
    ------
    TypeError, ValueError
        If an argument is not finite, or if the wobble is outside 0 to 1.

    Notes
    -----
    All orientations have the same dipole moment, and a freely rotating dipole emits the mean over all directions.
    PSFs with ``normalize="energy"`` are relative to the light that the objective collects.
    """

    polar: float
    azimuth: float
    wobble: float = 0.0

    def __post_init__(self) -> None:
        polar, azimuth = validation.angle("polar", self.polar), validation.angle("azimuth", self.azimuth)
        wobble = validation.real("wobble", self.wobble, least=0.0)
        if wobble > 1.0:
            raise ValueError(f"wobble must be from 0 to 1, got {wobble:g}")
        vars(self).update(polar=polar, azimuth=azimuth, wobble=wobble)

    @cached_property
    def moments(self) -> Array:
        """Three times the mean of ``p p^T`` over its directions: the unit matrix for a freely rotating dipole."""
        lateral, azimuth = math.sin(self.polar), self.azimuth
        # p is the unit vector of the dipole moment.
        p = np.array([lateral * math.cos(azimuth), lateral * math.sin(azimuth), math.cos(self.polar)])
        return np.asarray(3.0 * (1.0 - self.wobble) * np.outer(p, p) + self.wobble * np.eye(3))

    @cached_property
    def light(self) -> Light:
        """Model of the field integrals, and forms of the intensity."""
        M = self.moments
        level = 0.5 * (M[0, 0] + M[1, 1])
        return _vectorial(
            0.5 * np.einsum("caj,jl,cbl->ab", _CAMERA, M, _CAMERA.conj()),
            Harmonic(0, _form(3, {(0, 0): level, (1, 1): 2.0 * M[2, 2], (2, 2): level}), 1.0, 0.0),
            Harmonic(1, _FORM_1, 2.0 * M[0, 2], 2.0 * M[1, 2]),
            Harmonic(2, _FORM_2, M[0, 0] - M[1, 1], 2.0 * M[0, 1]),
        )


@dataclass(frozen=True)
class Beam:
    """Uniform beam that enters the objective's back aperture and is focused into the sample.

    Parameters
    ----------
    polarization : {"circular", "x", "y", "radial", "azimuthal", "vortex"} or (complex, complex), default "circular"
        Name, or Jones vector (a, b) along columns and rows of the camera, of any length. "circular" is (1, i), which
        without aberrations is equivalent to unpolarized light. "radial" and "azimuthal" polarization point towards
        and around the axis. "vortex" is circular light behind a vortex phase plate (the doughnut of STED). On the
        axis, "azimuthal" and "vortex" have no light.

    Raises
    ------
    TypeError, ValueError
        If `polarization` is neither a known name nor a nonzero pair of finite numbers.
    """

    polarization: str | tuple[complex, complex] = "circular"

    def __post_init__(self) -> None:
        if isinstance(self.polarization, str):
            validation.choice("polarization", self.polarization, (*_JONES, *_VECTOR_BEAMS))
            return
        jones = validation.array("polarization", self.polarization)
        is_pair = jones.shape == (2,) and jones.dtype.kind in "iufc"
        if not is_pair or not np.isfinite(jones).all() or not np.abs(jones).max() > 0.0:
            got = validation.shown(self.polarization)
            raise ValueError(f"polarization must be a name or two finite numbers, not both 0, got {got}")
        object.__setattr__(self, "polarization", tuple(jones.astype(complex).tolist()))

    @cached_property
    def light(self) -> Light:
        """Model of the field integrals, and forms of the intensity."""
        waves = self._waves(np.eye(3))
        if self._vector_beam is not None:
            return _light(self._vector_beam, waves)
        a, b = self._jones
        power = abs(a) ** 2 + abs(b) ** 2
        # Linear polarisation has a term of order 2, which cancels for circular polarisation.
        form_2 = _form(3, {(0, 2): 1.0, (1, 1): 2.0})
        cosine, sine = (abs(a) ** 2 - abs(b) ** 2) / power, 2.0 * (a * np.conj(b)).real / power
        order_0 = Harmonic(0, np.diag([1.0, 2.0, 1.0]).astype(np.complex128), 1.0, 0.0)
        return _vectorial(waves.form, order_0, Harmonic(2, form_2, cosine, sine))

    @property
    def _vector_beam(self) -> str | None:
        """The name of the polarization if its direction or its phase depends on the azimuth, else None."""
        named = isinstance(self.polarization, str) and self.polarization in _VECTOR_BEAMS
        return str(self.polarization) if named else None

    @property
    def _jones(self) -> tuple[complex, complex]:
        return _JONES[self.polarization] if isinstance(self.polarization, str) else self.polarization

    def _waves(self, moments: Array) -> Waves:
        """Return ``sum_jl moments[j, l] E_j conj(E_l)`` for the field E along x, y and z in the sample."""
        orders: tuple[int, ...] = (0, 1, -1, 2, -2)
        parts: tuple[int, ...] = (0, 1, 1, 2, 2)
        if self._vector_beam in (None, "vortex"):
            jones = self._jones if self._vector_beam is None else _JONES["circular"]
            # By reciprocity, the field of a beam in the sample equals the field of dipoles on the camera.
            field = np.einsum("c,cul->lu", jones, _CAMERA) / np.linalg.norm(jones)
            if self._vector_beam:
                # Circular light has orders of one sign only, and the vortex plate adds 1 to each order.
                field, orders, parts = field[:, [0, 1, 3]], (1, 2, 3), (0, 1, 2)
        else:
            # The field along the axis has the factor -i.
            towards, across, along = [0.5, 0.5, 0.0], [-0.5j, 0.5j, 0.0], [0.0, 0.0, -1.0j]
            radial = self._vector_beam == "radial"
            field = np.array([towards, across, along] if radial else [np.negative(across), towards, np.zeros(3)])
            orders, parts = (1, -1, 0), (1, 1, 0)
        return Waves(orders, parts, np.einsum("la,lm,mb->ab", field, moments, field.conj()))


@dataclass(frozen=True)
class Absorbed(Beam):
    """Excitation of a dipole by a beam: three times the intensity of the field component along the dipole.

    The mean over all directions of the dipole is the intensity of the beam.
    """

    dipole: Dipole = Dipole(0.0, 0.0)

    @cached_property
    def light(self) -> Light:
        """Model of the field integrals, and forms of the intensity."""
        return _light(self._vector_beam or "vectorial", self._waves(self.dipole.moments))


def _light(kind: str, waves: Waves) -> Light:
    """Return all azimuthal orders of the intensity of waves, for ``U_q = (-i)^abs(q) exp(i q phi) K_abs(q)``."""
    model, orders = Model(kind), np.array(waves.orders)
    # The factor (-i)^abs(q) is from the Bessel expansion of a plane wave.
    phases = (-1j) ** np.abs(orders)
    form = waves.form * np.multiply.outer(phases, phases.conj())
    harmonics = []
    # The product of two waves has the difference of their orders.
    for m in range(2 * int(orders.max()) + 1):
        F = np.zeros((len(model.orders), len(model.orders)), np.complex128)
        for a, b in np.argwhere(np.subtract.outer(orders, orders) == m):
            F[waves.parts[a], waves.parts[b]] += form[a, b]
        pair = ((F + F.conj().T, 1.0, 0.0), (1j * (F - F.conj().T), 0.0, 1.0)) if m else ((F, 1.0, 0.0),)
        harmonics += [Harmonic(m, *term) for term in pair if not m or np.abs(term[0]).max() > 1e-15]
    return Light(model, tuple(harmonics), waves)


@dataclass(frozen=True)
class Scalar:
    """Emitter of the scalar model of Gibson and Lanni, without polarization and Fresnel losses.

    Parameters
    ----------
    apodization : {"uniform", "aplanatic"}, default "uniform"
        Amplitude across the pupil: 1, as published, or ``c_i^(-1/2)``, by the sine condition.
    supercritical : bool, default True
        Include light beyond the critical angle of the sample, which the published model omits.

    Raises
    ------
    TypeError, ValueError
        If an argument is not one of these values.
    """

    apodization: str = "uniform"
    supercritical: bool = True

    def __post_init__(self) -> None:
        validation.choice("apodization", self.apodization, ("uniform", "aplanatic"))
        validation.truth("supercritical", self.supercritical)

    @cached_property
    def light(self) -> Light:
        """Model of the field integrals, and forms of the intensity."""
        model = Model("scalar", aplanatic=self.apodization == "aplanatic", supercritical=self.supercritical)
        identity = np.eye(1, dtype=np.complex128)
        return Light(model, (Harmonic(0, identity, 1.0, 0.0),), Waves((0,), (0,), identity))


Emitter = Dipole | Beam | Scalar


@lru_cache(maxsize=64)
def light_of(emitter: Emitter) -> Light:
    """Return ``emitter.light``, cached."""
    return emitter.light


_EMITTERS: dict[str, Emitter] = {"isotropic": Dipole(0.0, 0.0, wobble=1.0), "scalar": Scalar()}


def emitter_of(value: object) -> Emitter:
    """Return the emitter of this name, or `value` itself if it is an emitter; else TypeError or ValueError."""
    if isinstance(value, Emitter):
        return value
    if isinstance(value, str) and value in _EMITTERS:
        return _EMITTERS[value]
    raise (ValueError if isinstance(value, str) else TypeError)(
        f'emitter must be "isotropic", "scalar", a Dipole, a Beam or a Scalar, got {validation.shown(value)}'
    )
