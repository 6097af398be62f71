"""Microscope files in TOML: a microscope with its emitter, planes and camera; all errors are reported together."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass, field, replace
from functools import partial
from os import PathLike
from typing import Annotated, Literal, TypeAlias

import numpy as np
from pydantic import AfterValidator, Field

from lommel.base import atomic, validation
from lommel.base.arrays import Array
from lommel.base.units import format_length
from lommel.estimation.beads import BeadFit
from lommel.io.zernike_tables import ZernikeTable
from lommel.lensfiles import camera_files, toml_files
from lommel.lensfiles.camera_files import Sensor
from lommel.lensfiles.instrument import Camera
from lommel.lensfiles.toml_files import (
    Angle,
    BuiltSection,
    Context,
    Length,
    LensFileError,
    Number,
    Section,
    SignedLength,
    Toml,
)
from lommel.optics.aperture.apodization import Apodization, illumination
from lommel.optics.layers.emitter import Beam, Dipole, Emitter, emitter_of
from lommel.optics.layers.modality import WIDEFIELD, Kind, Modality
from lommel.optics.layers.objective import FocalSurface, Objective
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.layers.stratified import DEPTH_MOST, Design, Layer, length, refractive_index
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import PSF, psf
from lommel.show import notebook
from lommel.show.drawing import length_in_words, of_emitter
from lommel.special import zernike

PLANES_MOST = 4096
_LEAST_SIDE, _MOST_SIDE = 33, 513
_ISOTROPIC = emitter_of("isotropic")
_NOTEBOOK_SIDE = 65  # largest side of the image in notebooks, pixels


def stage_step(value: float) -> float:
    """Return the stage step between planes, metres; ValueError if it is 0 or as large as 10 mm."""
    if not 0.0 < abs(value) < DEPTH_MOST:
        raise ValueError(f"step must be a stage step, not 0 and below 10 mm, got {value:g} m")
    return value


@dataclass(frozen=True)
class Microscope:
    """Microscope: objective, emitter, planes and camera, for example from a file with a section [objective].

    Attributes
    ----------
    objective : Objective
        Objective with immersion, cover glass and sample.
    wavelength : float
        Vacuum wavelength, metres.
    pixel : float
        Pixel pitch on the camera, metres.
    depth : float
        Depth of the emitter below the cover glass, metres.
    emitter : Dipole, Beam or Scalar
        Emitter or excitation beam, by default a freely rotating dipole; see :meth:`lommel.Objective.pupil`.
    planes : int
        Number of planes; 1 for a single image.
    step : float
        Stage step between planes, metres.
    origin : str
        Origin of z, at which the plane ``planes // 2`` lies; see :meth:`lommel.Objective.pupil`.
    shape : tuple of int, or None
        Height and width of the window in pixels, if the file states them; see :attr:`window`.
    integrate : bool or None
        Pixel-integrated (True) or point-sampled values, see :func:`lommel.psf`; None if the file has no such entry.
    aberrations : Wavefront, or None
        Measured phase at `wavelength`, added to the aberrations of the layers.
    camera : Camera, or None
        Camera, if the file names one.
    modality : Modality
        Illumination and detection, for :func:`lommel.microscopy.deconvolve`.
    errors : mapping
        Standard errors of fitted parameters, by name: "noll 5" in waves rms, "sample" and other constants in the
        units of :func:`lommel.fit_beads`.
    focal_surface : FocalSurface, or None
        Focal surface over the frame, for :func:`lommel.localize.localize_movie`; PSFs are of its middle.
    name, source : str
        Name of the microscope, and source of its numbers.

    Raises
    ------
    TypeError, ValueError
        If `planes` is not from 1 to 4096, or if there are several planes and `step` is 0 or at least 10 mm.

    Examples
    --------
    A microscope without a file, and its PSF; `errors` come from :meth:`fitted`:

    >>> import lommel as lm
    >>> oil = lm.Objective(NA=1.3, magnification=60, immersion=1.515, working_distance=1.5e-4, sample=1.38)
    >>> light = {"wavelength": 520e-9, "depth": 2e-6, "emitter": lm.Dipole(0.0, 0.0, wobble=1.0)}
    >>> coma = lm.Wavefront.zernike({(3, 1): 0.05}, unit="waves")
    >>> mine = lm.Microscope(
    ...     oil,
    ...     pixel=6.5e-6,
    ...     **light,
    ...     planes=3,
    ...     step=2e-7,
    ...     origin="paraxial",
    ...     shape=(33, 33),
    ...     integrate=True,
    ...     aberrations=coma,
    ...     camera=lm.load_camera("andor-zyla-5.5"),
    ...     errors={},
    ... )
    >>> lm.psf(mine.pupil(), mine.window, mine.pixel, integrate=mine.integrate).shape
    (3, 33, 33)
    """

    pupil_hint = "a Microscope; microscope.pupil() is its pupil"

    objective: Objective
    wavelength: float
    pixel: float
    depth: float = 0.0
    emitter: Emitter = _ISOTROPIC
    planes: int = 1
    step: float = 0.0
    origin: str = "brightest"
    shape: tuple[int, int] | None = None
    integrate: bool | None = None
    aberrations: Wavefront | None = None
    camera: Camera | None = None
    modality: Modality = WIDEFIELD
    errors: Mapping[str, float] = field(default_factory=dict)
    focal_surface: FocalSurface | None = None
    name: str = ""
    source: str = ""

    def __post_init__(self) -> None:
        validation.integer("planes", self.planes, least=1, most=PLANES_MOST)
        if self.planes > 1:
            stage_step(validation.real("step", self.step))

    def __repr__(self) -> str:
        planes = f", {self.planes} planes {format_length(abs(self.step))} apart" if self.planes > 1 else ""
        lens = f"NA {self.objective.NA:g}, {self.objective.magnification:g}x"
        emission = f"{of_emitter(self.emitter)} at {format_length(self.depth)}, {format_length(self.wavelength)}"
        return f"<Microscope {self.name!r}: {lens}, {emission}, pixels of {format_length(self.pixel)}{planes}>"

    def _repr_html_(self) -> str:
        lens, text = self.objective, length_in_words
        nyquist = lens.nyquist(wavelength=self.wavelength)
        layer = lens.coverslip
        glass = "none" if layer is None else f"{text(layer.thickness)} of index {layer.index:.4g}"
        planes = f"{self.planes}, {text(abs(self.step))} apart" if self.planes > 1 else "1"
        terms = {} if self.aberrations is None else self.aberrations.to_zernike(unit="waves")
        rms = math.hypot(*map(float, terms.values()))
        rows: list[notebook.Row] = [
            (
                "objective",
                f"NA {lens.NA:.4g}, {lens.magnification:.4g}x, immersion {lens.immersion:.4g}",
            ),
            ("cover glass", glass),
            ("sample", f"index {lens.sample:.4g}"),
            ("emitter", f"{notebook.emitter(self.emitter)}, {text(self.depth)} deep"),
            ("wavelength", text(self.wavelength)),
            ("aberrations", f"{rms:.4g} waves rms" if rms else None),
            (
                "pixels",
                f"{text(self.pixel / lens.magnification)} in the sample ({text(self.pixel)} on the camera)",
            ),
            ("planes", planes),
            ("Nyquist sampling", f"{text(nyquist.lateral)} in the sample, {text(nyquist.axial)} of the stage"),
            ("source", self.source or None),
        ]

        def image() -> PSF:
            height, width = self.window
            shape = min(height, _NOTEBOOK_SIDE), min(width, _NOTEBOOK_SIDE)
            return psf(replace(self, planes=1).pupil(), shape, self.pixel, integrate=self.integrate)

        return notebook.device(f"Microscope: {self.name}", rows, image)

    def fitted(self, found: BeadFit) -> Microscope:
        """Return the microscope with parameters fitted to stacks of beads.

        Parameters
        ----------
        found : BeadFit
            Result of :func:`lommel.fit_beads`.

        Returns
        -------
        Microscope
            Copy with the fitted objective, wavelength, emitter, pixel, aberrations and standard errors, otherwise
            unchanged.
        """
        errors: dict[str, float] = {}
        for name, error in found.errors.items():
            if not math.isfinite(error):  # known by its prior
                continue
            if isinstance(name, str):
                errors[name] = error
            else:
                n, m = name
                errors[f"noll {zernike.index_of(n, m, 'noll')}"] = error / (2.0 * math.pi)
        names = "objective", "wavelength", "emitter", "pixel", "aberrations"
        return replace(self, errors=errors, **{name: getattr(found, name) for name in names})

    def save(self, path: str | PathLike[str]) -> None:
        """Write a microscope file for :func:`load_microscope` and for the command line.

        Parameters
        ----------
        path : path
            File to write, ending in .toml.

        Raises
        ------
        ValueError
            If the suffix is not .toml, if the objective has no working distance, or if the emitter is a beam whose
            polarization has no name.
        OSError
            If the file cannot be written.
        """
        target = validation.path("path", path)
        if target.suffix.lower() != ".toml":
            raise ValueError(f"path must end in .toml, got {validation.line(target)}")
        atomic.write(target, _file_text(self).encode())

    @property
    def z(self) -> Array:
        """Stage position of each plane, metres from the origin."""
        return np.asarray((np.arange(self.planes) - self.planes // 2) * self.step, np.float64)

    @property
    def window(self) -> tuple[int, int]:
        """Height and width of the window in pixels: `shape`, or else a square of 33 to 513 pixels.

        The square extends ten lambda N beyond the geometric blur (lambda: wavelength; N: f-number at the camera).
        """
        if self.shape is not None:
            return self.shape
        pupil = self.pupil()
        half = math.ceil((float(pupil.geometric_radius().max()) + 10.0 * pupil.scale) / self.pixel)
        return (max(_LEAST_SIDE, min(2 * half + 1, _MOST_SIDE)),) * 2

    def pupil(self) -> ObjectivePupil:
        """Return the pupil: a stack of all planes, or a single pupil for one plane.

        Returns
        -------
        ObjectivePupil

        Raises
        ------
        ValueError
            See :meth:`lommel.Objective.pupil`.
        """
        return self.objective.pupil(
            depth=self.depth,
            z=self.z if self.planes > 1 else 0.0,
            wavelength=self.wavelength,
            origin=self.origin,
            emitter=self.emitter,
            aberrations=self.aberrations,
        )


Index = Annotated[Number, AfterValidator(partial(refractive_index, "index"))]
Immersion = Annotated[Number, AfterValidator(partial(refractive_index, "immersion"))]


def _illumination(value: float | list[float]) -> Apodization:
    return illumination(Apodization(tuple(value)) if isinstance(value, list) else value)


class _Objective(BuiltSection):
    NA: Annotated[Number, Field(gt=0)]
    magnification: Annotated[Number, Field(gt=0)]
    working_distance: Length
    immersion: Immersion
    dipping: Annotated[bool, Field(strict=True)] = False
    apodization: Annotated[Number | list[Number], AfterValidator(_illumination)] = 0.0

    def build(self) -> Objective:
        """Return the objective without cover glass, films and sample."""
        return Objective(**{name: value for name, value in self if name != "dipping"})


class _Layer(BuiltSection):
    index: Index
    thickness: Length

    def build(self) -> Layer:
        """Return the layer."""
        return Layer(self.index, self.thickness)


class _Design(Section):
    immersion: Immersion | None = None
    coverslip: _Layer | None = None


class _Sample(Section):
    index: Index
    depth: Annotated[SignedLength, AfterValidator(partial(length, "depth", most=DEPTH_MOST))] = 0.0


class _Dipole(Section):
    polar: Angle
    azimuth: Angle = 0.0
    wobble: Annotated[Number, Field(ge=0, le=1)] = 0.0


class _Beam(Section):
    polarization: Annotated[str, Field(strict=True), AfterValidator(lambda p: Beam(p).polarization)] = "circular"


class _Emission(BuiltSection):
    wavelength: Annotated[Length, AfterValidator(validation.wavelength)]
    emitter: Literal["isotropic", "scalar"] = "isotropic"
    dipole: _Dipole | None = None
    beam: _Beam | None = None

    @classmethod
    def fault(cls, entries: Toml) -> str | None:
        """Return an error message if the section has more than one of the keys emitter, dipole and beam."""
        kinds = sorted({"emitter", "dipole", "beam"} & set(entries))
        return f"takes one of emitter, dipole and beam, got {' and '.join(kinds)}" if len(kinds) > 1 else None

    def build(self) -> Emitter:
        """Return the emitter or the excitation beam."""
        if self.dipole is not None:
            return Dipole(**dict(self.dipole))
        return emitter_of(self.emitter) if self.beam is None else Beam(self.beam.polarization)


class _Modality(BuiltSection):
    kind: Kind = "widefield"
    excitation: Annotated[Length, AfterValidator(validation.wavelength)] | None = None
    pinhole: Annotated[Number, Field(gt=0)] = 1.0
    thickness: Length | None = None

    def build(self) -> Modality:
        """Return the modality."""
        return Modality(**dict(self))


class _FocalSurface(BuiltSection):
    frame: tuple[int, int]
    terms: dict[Literal["x", "y", "xx", "xy", "yy"], SignedLength]

    def build(self) -> FocalSurface:
        """Return the focal surface."""
        return FocalSurface(**dict(self))


class _Aberrations(Section):
    zernike: Toml | None = None  # validated by `camera_files.read_zernike`


class _Stack(Section):
    planes: Annotated[int, Field(strict=True, ge=1, le=PLANES_MOST)]
    step: Annotated[SignedLength, AfterValidator(stage_step)]
    origin: Literal["brightest", "paraxial", "coverslip"] = "brightest"


class _File(Section):
    name: str | None = None
    source: str = ""
    objective: _Objective
    coverslip: _Layer | None = None
    films: list[_Layer] = Field(default_factory=list)
    design: _Design | None = None
    sample: _Sample
    emission: _Emission
    modality: _Modality = _Modality()
    aberrations: _Aberrations = _Aberrations()
    errors: dict[str, Annotated[Number, Field(ge=0)]] = Field(default_factory=dict)
    focal_surface: _FocalSurface | None = None
    stack: _Stack | None = None
    sensor: Sensor

    @classmethod
    def fault(cls, entries: Toml) -> str | None:
        """Return an error message if a section [coverslip] contradicts the key "dipping" of the objective."""
        objective = entries.get("objective")
        dipping = objective.get("dipping", False) if isinstance(objective, dict) else False
        if dipping is not ("coverslip" in entries):
            return None  # also if `dipping` is not a boolean, which pydantic reports
        if dipping:
            return "[coverslip] must be left out for an objective that dips into the sample, dipping = true"
        return "[coverslip] is missing; it may be left out only for an objective with dipping = true"


def _file_text(microscope: Microscope) -> str:
    """Return the text of a microscope file."""
    if microscope.objective.working_distance is None:
        raise ValueError("objective must have a working_distance, which microscope files require, got None")
    lines = [f"name = {_value(microscope.name)}", f"source = {_value(microscope.source)}"]
    layers = _layer_sections(microscope.objective)
    for name, entries in (*layers, *_light_sections(microscope), *_plane_sections(microscope)):
        lines.append(f"\n[{name}]")
        lines += [f"{key} = {_value(value)}" for key, value in entries.items() if value is not None]
    if microscope.aberrations is not None:
        waves = microscope.aberrations.to_zernike(order="noll", unit="waves")
        terms = sorted((index, float(c)) for index, c in waves.items() if float(c) and index > 1)
        lines += ["\n[aberrations.zernike]", 'order = "noll"', 'unit = "waves"', 'normalization = "rms"']
        lines.append("terms = { " + ", ".join(f"{index} = {c:.12g}" for index, c in terms) + " }")
    if microscope.errors:
        lines.append("\n[errors]")
        lines += [f"{json.dumps(name)} = {_value(float(error))}" for name, error in microscope.errors.items()]
    return "\n".join(lines) + "\n"


_Sections: TypeAlias = Iterator[tuple[str, Mapping[str, object]]]


def _layer_sections(objective: Objective) -> _Sections:
    """Yield the sections of an objective and of its layers."""
    assert objective.working_distance is not None
    yield (
        "objective",
        {
            "NA": objective.NA,
            "magnification": objective.magnification,
            "working_distance": _micrometres(objective.working_distance),
            "immersion": objective.immersion,
            "dipping": True if objective.coverslip is None else None,
            "apodization": list(illumination(objective.apodization).powers) or None,
        },
    )
    if objective.coverslip is not None:
        yield "coverslip", _layer_entries(objective.coverslip)
    for film in objective.films:
        yield "[films]", _layer_entries(film)
    if objective.design != Design(objective.immersion, objective.coverslip):
        yield "design", {"immersion": objective.design.immersion}
        if objective.design.coverslip is not None:
            yield "design.coverslip", _layer_entries(objective.design.coverslip)


def _layer_entries(layer: Layer) -> Mapping[str, object]:
    return {"index": layer.index, "thickness": _micrometres(layer.thickness)}


def _light_sections(microscope: Microscope) -> _Sections:
    """Yield the sections of the sample and of the emission; ValueError if files do not support the emitter."""
    emitter = microscope.emitter
    yield "sample", {"index": microscope.objective.sample, "depth": _micrometres(microscope.depth)}
    name = next((name for name in ("isotropic", "scalar") if emitter_of(name) == emitter), None)
    yield "emission", {"wavelength": _micrometres(microscope.wavelength), "emitter": name}
    if microscope.modality != WIDEFIELD:
        lengths = {key: getattr(microscope.modality, key) for key in ("excitation", "thickness")}
        yield (
            "modality",
            vars(microscope.modality)
            | {key: None if metres is None else _micrometres(metres) for key, metres in lengths.items()},
        )
    if name is not None:
        return
    if isinstance(emitter, Dipole):
        yield "emission.dipole", asdict(emitter)
    elif isinstance(emitter, Beam) and isinstance(emitter.polarization, str):
        yield "emission.beam", {"polarization": emitter.polarization}
    else:
        raise ValueError(f"emitter must be one that microscope files support (see load_microscope), got {emitter!r}")


def _plane_sections(microscope: Microscope) -> _Sections:
    """Yield the sections of the focal surface, of the stack, if it has several planes, and of the sensor."""
    if (surface := microscope.focal_surface) is not None:
        terms = {f"terms.{name}": _micrometres(value) for name, value in surface.terms.items()}
        yield "focal_surface", {"frame": [*surface.frame], **terms}
    if microscope.planes > 1:
        step = _micrometres(microscope.step)
        yield "stack", {"planes": microscope.planes, "step": step, "origin": microscope.origin}
    shape = None if microscope.shape is None else list(microscope.shape)
    pixel = _micrometres(microscope.pixel)
    yield "sensor", {"pixel": pixel, "shape": shape, "integrate": microscope.integrate}


def _micrometres(metres: float) -> str:
    # Twelve digits hide the rounding error of the conversion.
    return f"{1e6 * metres:.12g} um"


def _value(value: object) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float):
        return f"{value:.12g}" if math.isfinite(value) else "inf"
    return json.dumps(value, ensure_ascii=False)


def describes_microscope(path: str | PathLike[str]) -> bool:
    """Return True if a file describes a microscope: it has a section [objective] and no section [lens]."""
    _, entries = toml_files.parsed(validation.path("path", path))
    return "objective" in entries and "lens" not in entries


def load_microscope(path: str | PathLike[str], *, folder_only: bool = False) -> Microscope:
    """Read a microscope file.

    Lengths are strings with a unit (``"170 um"``); angles are strings with a unit or numbers in radians. Keys:

    - ``name`` (by default the name of the file), ``source``
    - ``[objective]``: NA, magnification, working_distance, immersion (refractive index), dipping (true for an
      objective without a cover glass), apodization (a number, or the powers of :class:`lommel.Apodization`)
    - ``[coverslip]`` and ``[[films]]`` (thin films in order from glass to sample): index, thickness
    - ``[design]`` and ``[design.coverslip]``: media for which the objective was corrected, if other media are used
    - ``[sample]``: index, depth of the emitter below the cover glass (by default 0)
    - ``[emission]``: wavelength, emitter ("isotropic", the default, or "scalar"). The key emitter may be replaced by
      a section ``[emission.dipole]`` (polar, azimuth, wobble) or, for an excitation beam, ``[emission.beam]``
      (polarization)
    - ``[modality]``: kind ("widefield", the default, "confocal", "spinning disc", "light sheet" or "two-photon"),
      excitation (wavelength), pinhole (Airy units) and thickness (of the light sheet), as in
      :class:`lommel.microscopy.Modality`
    - ``[aberrations.zernike]``: measured wavefront, as in :func:`lommel.load_instrument`; by default its wavelength
      is the emission wavelength
    - ``[errors]``: standard errors of fitted parameters, by name
    - ``[focal_surface]``: frame (rows, columns) and terms, as in :class:`lommel.localize.FocalSurface`
    - ``[stack]``: planes, step and origin of z, at which plane ``planes // 2`` lies ("brightest", the default,
      "paraxial" or "coverslip"); without this section there is a single plane, at the brightest focus
    - ``[sensor]``: camera, or pixel (pitch on the camera); shape and integrate, as for a lens

    Parameters
    ----------
    path : path
        Microscope file to read.
    folder_only : bool, default False
        If True, an error is raised for tables of aberrations outside the folder of the file, as in
        :func:`lommel.load_instrument`.

    Returns
    -------
    Microscope

    Raises
    ------
    LensFileError
        If the file is not valid TOML or has missing, unknown or invalid entries; all are reported together, with
        key and line.
    OSError
        If the file cannot be read.

    Examples
    --------
    >>> import lommel as lm
    >>> microscope = lm.load_microscope("examples/objectives/zeiss-63x-1.4-oil.toml")  # doctest: +SKIP
    >>> psf = lm.psf(microscope.pupil(), microscope.window, microscope.pixel)  # doctest: +SKIP
    """
    source = validation.path("path", path)
    text, entries = toml_files.parsed(source)
    if "lens" in entries and "objective" not in entries:
        raise LensFileError(
            f"{validation.line(source)}: describes a lens (section [lens]), not a microscope; read it with "
            "lommel.load_instrument"
        )
    context: Context = {"folder": source.parent, "folder_only": validation.truth("folder_only", folder_only)}
    table, errors = camera_files.read_zernike(entries, text, context)
    build = partial(_microscope, table=table, stem=source.stem)
    return toml_files.built(source, entries, text, _File, build, context=context, earlier_errors=tuple(errors))


def _microscope(file: _File, *, table: ZernikeTable | None, stem: str) -> Microscope:
    coverslip, design = None if file.coverslip is None else file.coverslip.build(), None
    if file.design is not None:
        glass = file.design.coverslip
        immersion = file.objective.immersion if file.design.immersion is None else file.design.immersion
        design = Design(immersion, coverslip if glass is None else glass.build())
    entries: Toml = {name: value for name, value in file.objective if name != "dipping"}
    films = [film.build() for film in file.films]
    objective = Objective(**entries, coverslip=coverslip, sample=file.sample.index, films=films, design=design)
    stack = dict(file.stack) if file.stack is not None else {}
    microscope = Microscope(
        objective,
        file.emission.wavelength,
        name=stem if file.name is None else file.name,
        source=file.source,
        depth=file.sample.depth,
        emitter=file.emission.build(),
        aberrations=None if table is None else camera_files.wavefront_of(table, file.emission.wavelength),
        errors=file.errors,
        focal_surface=None if file.focal_surface is None else file.focal_surface.build(),
        modality=file.modality.build(),
        **stack,
        **dict(file.sensor),
    )
    replace(microscope, origin="paraxial").pupil()  # raises if the focus lies beyond the working distance
    return microscope
