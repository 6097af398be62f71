"""What the commands for photographs are asked, and what is made of it: picture, depth, lens, and how to store it."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from lommel.base.units import format_length
from lommel.imaging import FocusPlan, Photograph, Picture, read_depth, read_photo
from lommel.imaging.settings import Settings
from lommel.optics.lens import Lens

_AGREE = 0.02  # EXIF has the nominal figures of a lens, rounded
KINDS: dict[str, Any] = {"8": np.uint8, "16": np.uint16, "float": np.float32}


@dataclass(frozen=True, kw_only=True)
class Request:
    """Arguments and options that ``lommel blur`` and ``lommel focus-pull`` share, by their names."""

    photo: Path
    depth: Path
    lens: Path | None
    f_number: float | None
    focal_length: float | None
    pixel: float | None
    pixel_from_exif: bool
    no_exif: bool
    encoding: str | None
    depth_scale: float | None
    zero_unknown: bool
    bits: str | None
    quality: int
    settings: Settings

    @classmethod
    def of(cls, options: dict[str, Any]) -> Self:
        """Return the request of what a command was given."""
        own = {field.name for field in fields(cls)}
        settings = Settings(**{name: value for name, value in options.items() if name not in own})
        return cls(settings=settings, **{name: value for name, value in options.items() if name in own})

    def job(self, output: Path) -> Job:
        """Read the files, and say what is to be made of them and how it is to be stored."""
        picture = read_photo(self.photo, self.encoding)
        depth = read_depth(self.depth, scale=self.depth_scale, zero_is_unknown=self.zero_unknown)
        height, width = picture.values.shape[:2]
        if depth.shape != (height, width):
            raise ValueError(
                f"{self.depth} must have the size of the upright photo, {width} x {height}, "
                f"got {depth.shape[1]} x {depth.shape[0]}"
            )
        pixel = self._pixel(picture)
        if self.lens is None:
            lens, file_pixel = self._lens_of_options(picture), None
        else:
            lens, file_pixel = self._lens_of_file(self.lens)
        pixel = file_pixel if pixel is None else pixel
        if pixel is None:
            raise ValueError("without a lens file give --pixel or --pixel-from-exif")
        dtype = np.dtype(KINDS[self.bits or _bits(picture.values.dtype, output.suffix.lower())])
        # Values of the same kind stay encoded as they are; others become what readers will take them for.
        kept = (dtype.kind == "f") == (picture.values.dtype.kind == "f")
        encoding = picture.encoding if kept else "linear" if dtype.kind == "f" else "srgb"
        return Job(self, picture, picture.light(), depth, encoding, dtype, pixel, lens)

    def _pixel(self, picture: Picture) -> float | None:
        """Return the pixel pitch where it is named, or asked of EXIF."""
        if not self.pixel_from_exif:
            return self.pixel
        if self.pixel is not None:
            raise ValueError("give one of --pixel and --pixel-from-exif")
        if self.no_exif:
            raise ValueError("--pixel-from-exif contradicts --no-exif")
        return picture.exif.pixel(picture.values.shape)

    def _lens_of_options(self, picture: Picture) -> Lens:
        """Return a lens of what the options or EXIF state, focused at infinity."""
        exif = picture.exif
        return Lens(
            focal_length=self._agreed("--focal-length", self.focal_length, exif.focal_length, format_length),
            f_number=self._agreed("--f-number", self.f_number, exif.f_number, lambda n: f"f/{n:g}"),
            wavelength=540e-9 if picture.values.ndim == 3 else 550e-9,
        )

    def _agreed(self, option: str, given: float | None, read: float | None, show: Callable[[float], str]) -> float:
        """Return what an option says, or EXIF where it says nothing; ValueError if they contradict each other."""
        known = None if self.no_exif else read
        if given is None and known is None:
            reason = "EXIF is left out" if self.no_exif else f"{self.photo} has none in its EXIF"
            raise ValueError(f"give a lens file or {option}: {reason}")
        if given is None or known is None:
            return known if given is None else given  # type: ignore[return-value]
        if not math.isclose(given, known, rel_tol=_AGREE):
            raise ValueError(
                f"{option} {show(given)} contradicts the EXIF of {self.photo}, {show(known)}; "
                "to leave that out give --no-exif"
            )
        return given

    def _lens_of_file(self, path: Path) -> tuple[Lens, float]:
        """Return the lens of a file, stopped as the options say, and its pixel pitch."""
        from lommel.lensfiles.lens_files import load_instrument

        if self.focal_length is not None or self.pixel_from_exif:
            stray = "--focal-length" if self.focal_length is not None else "--pixel-from-exif"
            raise ValueError(f"{stray} has no meaning with a lens file, which states it")
        instrument = load_instrument(path)
        if instrument.aberrations_of_field is not None:
            raise ValueError(f"{path} has aberrations that vary over the field; a blur has one set of them")
        if self.f_number is None:
            return instrument.lens, instrument.side
        try:
            return instrument.lens.stopped(self.f_number), instrument.side
        except ValueError as error:
            raise ValueError(f"--f-number of {path}: {error}") from None


@dataclass(frozen=True, eq=False)
class Job:
    """A photograph, its depth, the lens (focused as its file says, or at infinity), and how the result is stored."""

    request: Request
    picture: Picture
    light: NDArray[Any]
    depth: NDArray[np.float64]
    encoding: str
    dtype: np.dtype[Any]
    pixel: float
    optics: Lens

    def lens(self, focus: float | None, name: str) -> Lens:
        """Return the lens, focused at a distance that the option `name` states, or else as its file says."""
        if focus is None and self.request.lens is None:
            raise ValueError(f"without a lens file give {name}")
        try:
            return self.optics if focus is None else self.optics.focused(focus)
        except ValueError as error:
            raise ValueError(str(error).replace("focus_distance", name)) from None

    def photograph(self, lens: Lens, told: Callable[[float], object] | None = None) -> Photograph:
        """Return what the lens makes of it, as light; `told` is called with the share of the work that is done."""
        settings = self.request.settings
        plan = FocusPlan(self.light, self.depth, lens, self.pixel, encoding="linear", keep=1, **vars(settings))
        if told is not None:
            blur = plan.blur()
            # What hides what is found by spreading white: once for each spectrum, or twice if windows do not end.
            looks = len(set(blur.spectra)) * (2 if settings.energy == 1.0 else 1) if settings.occlusion else 0
            total, done = self.depth.size * (blur.channels + looks), 0

            def watch(points: int) -> None:
                nonlocal done
                done += points
                told(min(done / total, 1.0))

            blur.watch = watch
        return plan()

    def facts(self, lens: Lens) -> dict[str, Any]:
        """Return what there is to say of all of it."""
        return {
            "shape": list(self.light.shape),
            "encoding": {"photo": self.picture.encoding, "output": self.encoding},
            "read": read_as(self.picture, self.request.encoding),
            "bits": "float" if self.dtype.kind == "f" else str(8 * self.dtype.itemsize),
            "focal_length": lens.focal_length,
            "f_number": lens.f_number,
            "pixel": self.pixel,
        }


def read_as(picture: Picture, given: str | None) -> str:
    """Return what the values of a photograph are taken for, by what is `given` or by default."""
    kind = "floats" if picture.values.dtype.kind == "f" else f"{8 * picture.values.dtype.itemsize} bits"
    names = {"srgb": "sRGB", "linear": "linear"}
    if given is not None:
        return f"values of {kind}, {names[given]}"
    other = "linear" if picture.encoding == "srgb" else "srgb"
    return (
        f"values of {kind}, taken for {names[picture.encoding]}; if they are {names[other]}, give --encoding {other}"
    )


def _bits(stored: np.dtype[Any], suffix: str) -> str:
    """Return the bits of the output where none are named: those of the photo, if the format holds them."""
    if suffix in (".jpg", ".jpeg"):
        return "8"
    if stored.kind != "f":
        return str(8 * stored.itemsize)
    return "float" if suffix in (".tif", ".tiff") else "16"
