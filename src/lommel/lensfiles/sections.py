"""Sections that the files of lenses and of microscopes share: [sensor], and tables of Zernike coefficients."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Annotated, Any

from pydantic import AfterValidator, BeforeValidator, Field, PlainValidator, ValidationInfo, model_validator

from lommel.base import validation
from lommel.io import text_files, zernike_tables
from lommel.io.zernike_tables import ZernikeTable
from lommel.lensfiles.camera_files import NAME, load_camera, named
from lommel.lensfiles.instrument import Camera
from lommel.lensfiles.toml_files import Context, Length, Section, Toml, checked_by, pitch, read_beside
from lommel.optics.wavefront.wavefront import Wavefront


def read(raw: Toml, text: str, context: Context) -> tuple[ZernikeTable | None, list[str]]:
    """Return the table of [aberrations.zernike], if there is one, and its errors."""
    above = raw.get("aberrations")
    section = above.get("zernike") if isinstance(above, dict) else None
    if not isinstance(section, dict):
        return None, []  # absent, or an error that pydantic reports

    def where(keys: Sequence[str]) -> str:
        return text_files.place(text, ["aberrations", "zernike", *keys])

    if "file" not in section:
        return zernike_tables.build_section(section, where)
    try:
        if others := [key for key in section if key != "file"]:
            raise ValueError(f"the file states everything; leave out {', '.join(others)}")
        table = read_beside(context, section["file"], "the path of a table", zernike_tables.load_zernike)
        if table.wavelength is None and table.unit in ("radians", "waves"):
            raise ValueError(f"{validation.line(section['file'])}: must state the wavelength of its {table.unit}")
        return table, []
    except ValueError as error:
        # One line for each error of the table.
        return None, [f"{where(['file'])}: {'; '.join(part.strip() for part in str(error).splitlines())}"]


def wavefront(table: ZernikeTable, wavelength: float) -> Wavefront:
    """Return the wavefront of a table at a wavelength, which its waves and radians refer to unless it has its own."""
    own = wavelength if table.wavelength is None else table.wavelength
    return replace(table, wavelength=own).wavefront(wavelength)


def _read(value: object) -> Any:
    """Return a camera; what was wrong with it is raised here, so that it is told with all other errors."""
    if isinstance(value, ValueError):
        raise value
    return value


class Sensor(Section):
    """The section [sensor]: pixels and window."""

    pixel: Annotated[Length, AfterValidator(partial(validation.pixel, metric=True))]
    shape: Annotated[tuple[int, int], BeforeValidator(checked_by(validation.image_shape))] | None = None
    integrate: Annotated[bool, Field(strict=True)] | None = None
    camera: Annotated[Camera | None, BeforeValidator(_read)] = None

    @model_validator(mode="before")
    @classmethod
    def _of_camera(cls, raw: object, info: ValidationInfo) -> Any:
        """Return the section with its camera read, whose pixels it has unless it states its own."""
        if not isinstance(raw, dict) or "camera" not in raw:
            return raw
        name = raw["camera"]
        try:
            if isinstance(name, str) and named(Path(name)):
                camera = load_camera(name)
            else:
                camera = read_beside(info.context, name, NAME, load_camera)
        except ValueError as error:
            return {"pixel": "1 um"} | raw | {"camera": error}  # whose pixels nobody sees
        sides = [camera.pixel] if isinstance(camera.pixel, float) else list(camera.pixel)
        texts = [f"{side!r} m" for side in sides]
        return {"pixel": texts if len(texts) > 1 else texts[0]} | raw | {"camera": camera}


class PhotoSensor(Sensor):
    """The section [sensor] of a lens, whose pixels may be rectangular and have a fill factor."""

    pixel: Annotated[float | tuple[float, float], PlainValidator(pitch)]  # type: ignore[assignment]
    fill: Annotated[tuple[float, float], PlainValidator(checked_by(partial(validation.fill, "fill")))] = (1.0, 1.0)
