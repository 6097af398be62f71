"""Camera files in TOML, and two sections of lens and microscope files: [sensor] and [aberrations.zernike]."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from os import PathLike
from pathlib import Path
from typing import Annotated

from pydantic import AfterValidator, BeforeValidator, Field, PlainValidator, ValidationInfo, model_validator

from lommel.base import validation
from lommel.base.options import near
from lommel.io import text_files, zernike_tables
from lommel.io.zernike_tables import ZernikeTable
from lommel.lensfiles import of_kind, toml_files
from lommel.lensfiles.instrument import Camera
from lommel.lensfiles.toml_files import (
    Context,
    Length,
    LensFileError,
    Number,
    Section,
    Toml,
    checked_by,
    pitch,
    read_beside,
)
from lommel.optics.wavefront.wavefront import Wavefront

NAME = "the name of an example (lommel examples --find camera) or of a .toml file"
"""Description of the valid values of `camera`, for error messages."""


class _Camera(Section):
    pixel: Annotated[float | tuple[float, float], PlainValidator(pitch)]
    read: Annotated[Number, Field(ge=0)] | None = None
    full_well: Annotated[Number, Field(gt=0)] | None = None
    gain: Annotated[Number, Field(gt=0)] | None = None
    offset: Annotated[Number, Field(ge=0)] | None = None
    excess: Annotated[Number, Field(ge=1, le=100)] | None = None
    em_gain: Annotated[Number, Field(ge=1)] | None = None


class _File(Section):
    name: str | None = None
    source: str = ""
    camera: _Camera


def load_camera(path: str | PathLike[str]) -> Camera:
    """Read a camera file.

    Keys: ``name`` (by default the name of the file) and ``source``. The section ``[camera]`` has ``pixel``, a string
    with a unit such as ``"6.5 um"`` or a list of height and width. Its other keys are optional: ``read`` (electrons
    rms), ``full_well`` (electrons), ``gain`` (electrons per count), ``offset`` (counts) and ``excess`` (1 to 100),
    the excess noise factor of electron multiplication.

    If there is ``em_gain``, the multiplication gain, ``gain`` and ``read`` in the file refer to the output
    amplifier. They are divided by ``em_gain``: in the :class:`lommel.Camera`, gain and read noise refer to electrons
    before multiplication. The default of ``excess`` is then 2 (for ``em_gain`` above 1), otherwise 1.

    Parameters
    ----------
    path : path or str
        The file, or the name of an example such as ``"andor-zyla-5.5"``. ``lommel examples --find camera`` lists the
        examples.

    Returns
    -------
    Camera

    Raises
    ------
    LensFileError
        If the file is not valid TOML or has missing, unknown or invalid entries; all are reported together, with key
        and line.
    ValueError
        If no example has this name.
    OSError
        If the file cannot be read.

    Examples
    --------
    >>> import lommel as lm
    >>> lm.load_camera("andor-zyla-5.5").noise.read
    1.38
    """
    source = validation.path("path", path)
    if is_example_name(source):
        examples = of_kind("camera")
        if source.name not in examples:
            hint = near(source.name, examples)
            # There are too many examples for a message: only a similar name is included.
            suggestion = f"; {hint}" if hint.startswith("did") else ""
            raise ValueError(f"camera must be {NAME}, got {validation.shown(source.name)}{suggestion}")
        source = examples[source.name]
    text, entries = toml_files.parsed(source)
    if "camera" not in entries and ("lens" in entries or "objective" in entries):
        kind = "lens" if "lens" in entries else "objective"
        raise LensFileError(f"{validation.line(source)}: is not a camera file, because it has a section [{kind}]")
    return toml_files.built(source, entries, text, _File, partial(_camera_of_file, stem=source.stem))


def is_example_name(path: Path) -> bool:
    """Return True if a path may be the name of an example: it has no folder and no suffix .toml."""
    return path.suffix.lower() != ".toml" and path.name == str(path)


def _camera_of_file(file: _File, *, stem: str) -> Camera:
    values = dict(file.camera)
    em_gain = values.pop("em_gain")
    # Electron multiplication multiplies the variance of the light by the excess noise factor.
    if values["excess"] is None:
        values["excess"] = _EXCESS if em_gain is not None and em_gain > 1.0 else 1.0
    for name in ("gain", "read"):
        if em_gain is not None and (name == "gain" or values[name] is not None):
            # The quotient refers to electrons before multiplication.
            values[name] = (1.0 if values[name] is None else values[name]) / em_gain
    return Camera(stem if file.name is None else file.name, file.source, **values)


_EXCESS = 2.0  # excess noise factor of an electron multiplication register with many stages of small gain


def read_zernike(entries: Toml, text: str, context: Context) -> tuple[ZernikeTable | None, list[str]]:
    """Return the table of the section [aberrations.zernike], or None without this section, and error messages."""
    aberrations = entries.get("aberrations")
    section = aberrations.get("zernike") if isinstance(aberrations, dict) else None
    if not isinstance(section, dict):
        return None, []  # the section is absent, or pydantic reports its wrong type

    def place_of(keys: Sequence[str]) -> str:
        return text_files.place(text, ["aberrations", "zernike", *keys])

    if "file" not in section:
        return zernike_tables.build_section(section, place_of)
    try:
        if other_keys := [key for key in section if key != "file"]:
            raise ValueError(f"the table file replaces all other keys; leave out {', '.join(other_keys)}")
        table = read_beside(context, section["file"], "the path of a table", zernike_tables.load_zernike)
        if table.wavelength is None and table.unit in ("radians", "waves"):
            raise ValueError(
                f"{validation.line(section['file'])}: must state the wavelength, as its unit is {table.unit}"
            )
        return table, []
    except ValueError as error:
        # The message has one line for each error of the table; the lines are joined.
        return None, [f"{place_of(['file'])}: {'; '.join(part.strip() for part in str(error).splitlines())}"]


def wavefront_of(table: ZernikeTable, wavelength: float) -> Wavefront:
    """Return the wavefront of a table at a wavelength (metres), which is also the default wavelength of the table."""
    table_wavelength = wavelength if table.wavelength is None else table.wavelength
    return replace(table, wavelength=table_wavelength).wavefront(wavelength)


def _camera_or_error(value: object) -> object:
    """Return a camera; if `value` is the error of reading it, raise the error, which pydantic reports."""
    if isinstance(value, ValueError):
        raise value
    return value


class Sensor(Section):
    """The section [sensor]: pixels and window."""

    pixel: Annotated[Length, AfterValidator(partial(validation.pixel, metric=True))]
    shape: Annotated[tuple[int, int], BeforeValidator(checked_by(validation.image_shape))] | None = None
    integrate: Annotated[bool, Field(strict=True)] | None = None
    camera: Annotated[Camera | None, BeforeValidator(_camera_or_error)] = None

    @model_validator(mode="before")
    @classmethod
    def _of_camera(cls, raw: object, info: ValidationInfo) -> object:
        """Return the section with its camera, whose pixel pitch is the default of `pixel`."""
        if not isinstance(raw, dict) or "camera" not in raw:
            return raw
        name = raw["camera"]
        try:
            if isinstance(name, str) and is_example_name(Path(name)):
                camera = load_camera(name)
            else:
                camera = read_beside(info.context, name, NAME, load_camera)
        except ValueError as error:
            # The pixel pitch is a placeholder: only the error is reported.
            return {"pixel": "1 um"} | raw | {"camera": error}
        sides = [camera.pixel] if isinstance(camera.pixel, float) else list(camera.pixel)
        texts = [f"{side!r} m" for side in sides]
        return {"pixel": texts if len(texts) > 1 else texts[0]} | raw | {"camera": camera}


class PhotoSensor(Sensor):
    """The section [sensor] of a lens: pixels may be rectangular and have a fill factor."""

    pixel: Annotated[float | tuple[float, float], PlainValidator(pitch)]  # type: ignore[assignment]
    fill: Annotated[tuple[float, float], PlainValidator(checked_by(partial(validation.fill, "fill")))] = (1.0, 1.0)
