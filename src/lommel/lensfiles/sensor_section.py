"""The section [sensor] of files of lenses and microscopes: pixels and window, and the camera that has them."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import Annotated, Any

from pydantic import AfterValidator, BeforeValidator, Field, PlainValidator, ValidationInfo, model_validator

from lommel.base import validation
from lommel.lensfiles.camera import Camera
from lommel.lensfiles.camera_files import NAME, load_camera, named
from lommel.lensfiles.toml_files import Length, Section, checked_by, pitch, read_beside


def _read(value: Any) -> Any:
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
    def _of_camera(cls, raw: Any, info: ValidationInfo) -> Any:
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
