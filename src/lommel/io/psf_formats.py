"""Read and write PSFs: NumPy, TIFF, PNG, FITS, HDF5 and MATLAB, with metadata for other programs."""

from __future__ import annotations

import io
import json
import math
import re
import struct
import zipfile
import zlib
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

import numpy as np

from lommel.base import atomic, reading, validation
from lommel.base.arrays import Array, Values
from lommel.base.atomic import sealed
from lommel.base.units import ARCSEC
from lommel.io import fits_images
from lommel.io.registry import DAMAGED, Arrays, Description
from lommel.measures.psf_like import ColourPSFLike, PSFLike, colours
from lommel.optics.colour.spectrum import Spectrum
from lommel.optics.layers.emitter import Beam
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.pupil import Pupil

if TYPE_CHECKING:
    from h5py import File

SLOPE = "derivative "
"""Prefix of the names of derivatives in a file."""

_TERM = re.compile(r"\(([0-9]+), (-?[0-9]+)\)")
_NOT_ASCII = re.compile(r"[^ -~]")
_MARK = b"\n#lommel "  # separates the array from the description in a .npy file
_MIN_PICTURE_SIDE = 512  # minimum side of a picture, pixels; smaller PSFs are enlarged by an integer factor
_UNEVEN_NOTE = "planes are not evenly spaced along z: pupil.z has the position of each, metres"
_STEP_TOLERANCE = 1e-6  # relative difference up to which steps are considered equal
_EXTNAME = "LOMMEL"  # name of the FITS extension with the description as bytes
_MAX_CARDS = 1000  # number of cards such as WAVE999: a FITS keyword has at most 8 characters
_COUNT_UNITS = {"energy": "pixel-1", "emitted": "pixel-1"}
_USER_BLOCK = 512  # bytes of a MATLAB file before its HDF5 part
_CHECKSUM_OFFSET, _CHECKED = 128, b"lommel crc32 "  # position (after the MATLAB header) and prefix of the checksum
_MATLAB = b"MATLAB 7.3 MAT-file, Platform: lommel, HDF5 schema 1.00 ."


StoredPSF: TypeAlias = PSFLike | ColourPSFLike
"""Content of a file: a PSF, or PSFs in channels."""


class Axis(NamedTuple):
    """An axis of the values: name, coordinates (None if unknown) and unit."""

    name: str
    places: Array | None = None
    unit: str = ""


def axes(psf: StoredPSF, description: Description) -> list[Axis]:
    """Return the axes of the values: axes of the stack (z of a microscope, or field and depth), channel, y, x."""
    pupil, grid = psf.pupil, psf.grid
    if field := description.get("field"):
        stack = [Axis(f"field_{side}", np.array(field[side]), psf.unit) for side in "yx"]
        if "depths" in field:
            depths = [np.inf if s is None else s for s in field["depths"]]
            stack.append(Axis("depth", np.array(depths), "m"))
    elif isinstance(pupil, ObjectivePupil) and len(pupil.shape) == 1:
        stack = [Axis("z", pupil.z, "m")]
    else:
        stack = [Axis(f"stack{k}" if k else "stack") for k in range(len(pupil.shape))]
    if isinstance(psf, ColourPSFLike):
        stack.append(Axis("channel"))
    if grid.stack:
        return [*stack, Axis("y"), Axis("x")]
    return [*stack, Axis("y", grid.y, psf.unit), Axis("x", grid.x, psf.unit)]


def light(psf: StoredPSF) -> tuple[Array, Array]:
    """Return the wavelengths (metres) and the fraction of the light at each wavelength; empty if it is unknown.

    For a PSF in channels, the fractions have one row per channel.
    """
    if isinstance(psf, ColourPSFLike):
        return np.array(psf.channels.wavelengths), np.array(psf.channels.weights)
    if isinstance(psf.method, Spectrum):
        return np.array(psf.method.wavelengths), np.array(psf.method.weights)
    wavelengths = [] if psf.pupil.wavelength is None else [psf.pupil.wavelength]
    return np.array(wavelengths), np.ones(len(wavelengths))


def derivative_name(stored: str) -> str | tuple[int, int]:
    """Return the name of a derivative from its text in a file; for a Zernike term, the pair (n, m)."""
    match = _TERM.fullmatch(stored)
    return (int(match[1]), int(match[2])) if match else stored


def text(description: Description, arrays: Arrays) -> str:
    """Return the description with the checksum of the arrays as JSON."""
    return json.dumps(sealed(description, arrays), allow_nan=False)


def _arrays_of(psf: StoredPSF) -> Arrays:
    derivatives = {} if isinstance(psf, ColourPSFLike) else psf.derivatives
    return {"values": np.ascontiguousarray(psf.values)} | {f"{SLOPE}{name}": d for name, d in derivatives.items()}


def _even_step(z: Array) -> float | None:
    """Return the step of evenly spaced planes at `z`, in metres; None if the planes are not evenly spaced."""
    if z.ndim != 1 or z.size < 2 or not np.isfinite(z).all():
        return None
    steps = np.diff(z)
    mean = float(steps.mean())
    return mean if mean and np.abs(steps - mean).max() <= _STEP_TOLERANCE * abs(mean) else None


def write_npy(psf: StoredPSF, description: Description) -> bytes:
    """Return a .npy file to which the description is appended."""
    values = np.ascontiguousarray(psf.values)
    return (
        atomic.contents(np.save, values, allow_pickle=False) + _MARK + text(description, {"values": values}).encode()
    )


def read_npy(data: bytes) -> tuple[Arrays, str]:
    """Return the values and the description."""
    values, record = reading.npy(data)
    if not record.startswith(_MARK):
        raise ValueError("no description of how it was made")
    return {"values": values}, record.removeprefix(_MARK).decode()


def write_npz(psf: StoredPSF, description: Description) -> bytes:
    """Return an archive of the values, the derivatives and the description."""
    return archive(_arrays_of(psf), description)


def archive(arrays: Arrays, description: Description) -> bytes:
    """Return an archive of arrays and their description."""
    # The description is an array of bytes, since readers in other languages do not support arrays of text.
    record = np.frombuffer(text(description, arrays).encode(), np.uint8)
    stored = {
        name: atomic.contents(np.save, values, allow_pickle=False)
        for name, values in (arrays | {"description": record}).items()
    }
    # np.savez is not used: it always writes 64-bit sizes, which other readers do not support.
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as zip_file:
        for name, array in stored.items():
            zip_file.writestr(zipfile.ZipInfo(f"{name}.npy"), array, zipfile.ZIP_DEFLATED)
    return file.getvalue()


def read_npz(data: bytes) -> tuple[Arrays, str]:
    """Return the values, the derivatives and the description."""
    with np.load(io.BytesIO(data), allow_pickle=False) as stored:
        arrays = dict(stored)
    record = arrays.pop("description")
    # Files of early versions have a text.
    return arrays, record.tobytes().decode() if record.dtype == np.uint8 else str(record)


def write_png(answer: StoredPSF, description: Description) -> bytes:
    """Return a picture of the square root of the values: grey of 16 bits, or red, green and blue of 8 bits."""
    from PIL import Image, PngImagePlugin

    if len(answer.pupil.shape) > 0:
        raise ValueError(
            f"a .png holds a single PSF, got a stack of shape {answer.shape}; index it, or draw it by plot()"
        )
    if isinstance(answer, ColourPSFLike):
        levels = np.rint(255.0 * np.sqrt(colours(answer))).astype(np.uint8)
    elif (peak := float(answer.values.max())) > 0.0:
        shares = np.maximum(answer.values.astype(np.float64), 0.0) / peak
        levels = np.rint(65535.0 * np.sqrt(shares)).astype(np.uint16)
    else:
        raise ValueError("a .png needs a positive value; every value of this PSF is 0")
    times = -(-_MIN_PICTURE_SIDE // max(levels.shape[:2]))
    info = PngImagePlugin.PngInfo()
    info.add_text("Software", description["software"])
    info.add_text("Comment", "square root of the values over the largest of all channels")
    image = Image.fromarray(levels.repeat(times, axis=0).repeat(times, axis=1))
    return atomic.contents(image.save, format="png", pnginfo=info)


def ome_unit(unit: str) -> tuple[float, str]:
    """Return the factor that converts lengths in `unit` to the unit used in OME, and the name of that unit."""
    return (1e6, "µm") if unit == "m" else (1.0, "reference frame")


def ome(psf: StoredPSF, order: str, description: Description) -> Description:
    """Return the OME attributes of PSFs; `order` is the order of the axes of the values, such as "ZYX"."""
    factor, unit = ome_unit(psf.unit)
    height, width = (side * factor for side in psf.grid.pitch)
    return {
        "axes": order,
        "PhysicalSizeX": width,
        "PhysicalSizeXUnit": unit,
        "PhysicalSizeY": height,
        "PhysicalSizeYUnit": unit,
        "Name": "point spread function",
        "Description": text(description, {"values": np.ascontiguousarray(psf.values)}),
    }


def write_tiff(psf: PSFLike, description: Description, planes: Description | None = None) -> bytes:
    """Return an OME-TIFF; `planes` are OME attributes of its pages, for a stack that is not a stack over z."""
    import tifffile

    pupil, write = psf.pupil, partial(tifffile.imwrite, photometric="minisblack")
    if isinstance(pupil, ObjectivePupil) and pupil.z.size > 1 and _even_step(pupil.z) is None:
        description = description | {"planes": _UNEVEN_NOTE}  # uneven steps, which OME-XML cannot describe
    fields = ome(psf, "YX" if psf.values.ndim == 2 else "RYX" if planes else "ZYX", description)
    if planes:
        fields["Plane"] = planes
    values = psf.values if psf.values.ndim == 2 else psf.values.reshape(-1, *psf.shape[-2:])
    if not isinstance(pupil, ObjectivePupil):
        return atomic.contents(write, values, ome=True, metadata=fields)
    ome_xml, pages = tifffile.OmeXml(), (pupil.focus.size, 1, 1, psf.shape[-2], psf.shape[-1], 1)
    ome_xml.addimage(values.dtype, values.shape, pages, **fields | _ome_image(psf, pupil))
    instrument = (
        '<Instrument ID="Instrument:0"><Objective ID="Objective:0" '
        f'LensNA="{pupil.layers.NA}" NominalMagnification="{pupil.magnification}"/></Instrument>'
    )
    settings = (
        '<InstrumentRef ID="Instrument:0"/>'
        f'<ObjectiveSettings ID="Objective:0" RefractiveIndex="{pupil.layers.immersion}"/>'
    )
    xml = ome_xml.tostring(declaration=True).replace("<Image ", f"{instrument}<Image ", 1)
    xml = xml.replace("<Pixels ", f"{settings}<Pixels ", 1)  # the schema prescribes this order
    return atomic.contents(write, values, description=xml.encode(), metadata=None)


def _ome_image(psf: PSFLike, pupil: ObjectivePupil) -> Description:
    """Return the attributes and elements of an OME image; lengths are in the sample, not on the sensor."""
    size, step = 1e6 * psf.grid.side / pupil.magnification, _even_step(pupil.z)
    nanometres = 1e9 * pupil.wavelength
    key = "ExcitationWavelength" if isinstance(pupil.emitter, Beam) else "EmissionWavelength"
    layers = pupil.layers
    annotations = {
        "refractive index of the immersion": layers.immersion,
        "refractive index of the cover glass": layers.glass,
        "refractive index of the sample": layers.sample,
        "depth of the emitter in um": _format_range(pupil.depth),
        "stage since the surface of the cover glass was in focus, in um": _format_range(pupil.focus),
        "emitter": repr(pupil.emitter),
    }
    attributes = {
        "PhysicalSizeX": _round(size),
        "PhysicalSizeY": _round(size),
        "Plane": {"PositionZ": [_round(1e6 * z) for z in pupil.z.flat], "PositionZUnit": ["µm"] * pupil.z.size},
        "Channel": {"Name": f"{nanometres:.4g} nm", key: _round(nanometres), f"{key}Unit": "nm"},
        "MapAnnotation": {"Value": annotations},
    }
    if step is not None:
        attributes |= {"PhysicalSizeZ": _round(1e6 * abs(step)), "PhysicalSizeZUnit": "µm"}
    return attributes


def _round(value: float) -> float:
    """Return a length without rounding noise: 0.1, not 0.09999999999999999."""
    return float(f"{value:.12g}")


def _format_range(metres: Array) -> str:
    return " to ".join(f"{end:.6g}" for end in dict.fromkeys((1e6 * metres.min(), 1e6 * metres.max())))


def read_tiff(data: bytes) -> tuple[Arrays, str]:
    """Return the values and the description."""
    with reading.tiff(data) as file:
        if not file.ome_metadata:
            raise ValueError("no OME description")
        description = reading.xml(file.ome_metadata).find(".//{*}Image/{*}Description")
        if description is None or not description.text:
            raise ValueError("no description of how it was made")
        if file.series[0].nbytes > len(data):
            raise ValueError(f"its pages have {file.series[0].nbytes} bytes, more than the file")
        return {"values": file.asarray()}, description.text


def write_fits(psf: StoredPSF, description: Description) -> bytes:
    """Return a FITS file; the cards PIXELSCL, WAVELEN, WAVEn, WGHTn mean the same as in POPPY and WebbPSF."""
    shares = "share of the light" if psf.normalize in _COUNT_UNITS else "of a peak"
    cards: Description = {
        "CREATOR": "lommel",
        "BUNIT": (_COUNT_UNITS.get(psf.normalize, ""), shares),
        "NORMALIZ": (psf.normalize, "what a value of 1 stands for"),
    }
    geometry = psf.pupil.geometry if isinstance(psf.pupil, Pupil) else None
    if geometry is not None and isinstance(psf.pixel, float):
        angle = math.atan(psf.pixel / geometry.sensor_distance) / ARCSEC
        cards["PIXELSCL"] = (angle, "[arcsec/pixel] seen from the lens, on the axis")
    if psf.unit == "m":
        for side, pitch in zip("YX", psf.grid.pitch, strict=True):
            cards[f"{side}PIXSZ"] = (1e6 * pitch, "[um] of a pixel on the sensor")
    elif isinstance(psf.pixel, float):
        cards["PIXELSZ"] = (psf.pixel, "[lambda*N] of a pixel on the sensor")
    waves, weights = light(psf)
    if isinstance(psf, ColourPSFLike):
        means = (weights @ waves).tolist()
        for k, (name, mean) in enumerate(zip(psf.channels.names[:_MAX_CARDS], means, strict=False)):
            cards[f"CHAN{k}"] = (_NOT_ASCII.sub("?", name), "name of the channel")
            cards[f"CWAV{k}"] = (mean, "[m] its mean wavelength")
    else:
        if waves.size:
            cards["WAVELEN"] = (float(waves @ weights), "[m] mean wavelength")
            cards["NWAVES"] = (waves.size, "number of wavelengths")
        for k in range(min(waves.size, _MAX_CARDS)):
            cards[f"WAVE{k}"] = (float(waves[k]), "[m] wavelength")
            cards[f"WGHT{k}"] = (float(weights[k]), "its share of the light")
    pitches = dict(zip("yx", psf.grid.pitch, strict=True))
    # FITS numbers axes from 1, beginning with the last axis of NumPy, and pixels from 1 (FITS standard 4.0, 8.2).
    for k, (name, places, unit) in enumerate(reversed(axes(psf, description)), 1):
        cards[f"CTYPE{k}"] = name.upper()
        step = pitches[name] if name in pitches else places is not None and _even_step(places)
        if places is None or not step:
            continue
        cards[f"CRPIX{k}"] = (1.0 - float(places[0]) / step, "where it is 0, on the axis")
        cards[f"CRVAL{k}"], cards[f"CDELT{k}"] = 0.0, step
        if unit == "m":
            cards[f"CUNIT{k}"] = unit
    record = np.frombuffer(text(description, {"values": psf.values}).encode(), np.uint8)
    return fits_images.write(
        [(np.ascontiguousarray(psf.values), cards), (record, {"EXTNAME": (_EXTNAME, "JSON: how it was made")})]
    )


def read_fits(data: bytes) -> tuple[Arrays, str]:
    """Return the values and the description."""
    images = fits_images.read(data, validation.MAX_VALUES)
    descriptions = [
        image for image in images if image.header.get("EXTNAME") == _EXTNAME and image.values.dtype == np.uint8
    ]
    if len(descriptions) != 1:
        raise ValueError("no description of how it was made")
    return {"values": images[0].values}, descriptions[0].values.tobytes().decode()


def write_hdf5(psf: StoredPSF, description: Description) -> bytes:
    """Return an HDF5 file: `values` and derivatives with attributes and dimension scales, and `description`."""
    arrays, places = _arrays_of(psf), axes(psf, description)
    waves, shares = light(psf)
    attrs: Description = {"pixel": psf.pixel, "unit": psf.unit, "normalize": psf.normalize, "sampling": psf.sampling}
    attrs |= {"wavelength": waves, "weight": shares} if waves.size else {}
    attrs |= {} if psf.error_bound is None else {"error_bound": psf.error_bound}

    def fill(file: File) -> None:
        record = np.bytes_(text(description, arrays).encode())
        file.create_dataset("description", data=record, track_times=False)
        if isinstance(psf, ColourPSFLike):
            names = [name.encode() for name in psf.channels.names]
            file.create_dataset("channel", data=np.array(names), track_times=False)
            file["channel"].make_scale("channel")
        for name, coordinates, unit in places:
            if coordinates is not None:
                scale = file.create_dataset(name, data=coordinates, track_times=False)
                scale.attrs["units"] = np.bytes_(unit)
                scale.make_scale(name)
        for name, values in arrays.items():
            stored = file.create_dataset(name, data=values, track_times=False)
            for key, value in attrs.items():
                stored.attrs[key] = np.bytes_(value) if isinstance(value, str) else value
            for k, axis in enumerate(places):
                stored.dims[k].label = axis.name
                if axis.name in file:
                    stored.dims[k].attach_scale(file[axis.name])

    return _hdf5(fill, b"")


def read_hdf5(data: bytes) -> tuple[Arrays, str]:
    """Return the values, the derivatives and the description."""
    with _open_hdf5(data) as file:
        record = bytes(reading.hdf5_values(file.get("description"))).decode()
        names = ["values", *(name for name in file if name.startswith(SLOPE))]
        return {name: reading.hdf5_values(file.get(name)) for name in names}, record


def write_mat(psf: StoredPSF, description: Description) -> bytes:
    """Return a .mat file: `values`, in MATLAB [height width stack], `x`, `y`, `wavelength`, `description`, ..."""
    waves, shares = light(psf)
    record = text(description, {"values": psf.values})
    texts = {"unit": psf.unit, "normalize": psf.normalize, "sampling": psf.sampling, "description": record}
    if isinstance(psf, ColourPSFLike):
        texts["channel"] = "\n".join(psf.channels.names)
    arrays = {"values": _reorder_for_matlab(psf.values), "pixel": np.array([[psf.pixel]])}
    places = ((axis.name, axis.places) for axis in axes(psf, description))
    arrays |= {name: coordinates.reshape(-1, 1) for name, coordinates in places if coordinates is not None}
    arrays |= {"wavelength": waves[:, None], "weight": np.atleast_2d(shares).T} if waves.size else {}

    def fill(file: File) -> None:
        for name, values in arrays.items():
            stored = file.create_dataset(name, data=values, track_times=False)
            stored.attrs["MATLAB_class"] = np.bytes_("single" if values.dtype == np.float32 else "double")
        for name, content in texts.items():
            codes = np.frombuffer(content.encode("utf-16-le"), "<u2")[:, None]
            stored = file.create_dataset(name, data=codes, track_times=False)
            stored.attrs["MATLAB_class"] = np.bytes_("char")
            stored.attrs["MATLAB_int_decode"] = np.int32(2)

    # Header of a MATLAB file: text, no subsystem data, version 2.0, mark of the byte order.
    return _hdf5(fill, _MATLAB.ljust(116) + bytes(8) + struct.pack("<H", 0x0200) + b"IM")


def read_mat(data: bytes) -> tuple[Arrays, str]:
    """Return the values and the description."""
    with _open_hdf5(data) as file:
        record = reading.hdf5_values(file.get("description")).astype("<u2").tobytes().decode("utf-16-le")
        return {"values": np.ascontiguousarray(_reorder_for_matlab(reading.hdf5_values(file.get("values"))))}, record


def _reorder_for_matlab(values: Values) -> Values:
    """Reorder the axes (..., y, x) so that MATLAB, which reverses the axes of HDF5, has (y, x, ...)."""
    stack = range(values.ndim - 2)
    return values.transpose(*reversed(stack), values.ndim - 1, values.ndim - 2)


def _hdf5(fill: Callable[[File], None], head: bytes) -> bytes:
    """Return an HDF5 file with the contents that `fill` writes, preceded by the header `head` and a checksum."""
    import h5py

    file = io.BytesIO()
    # Write the oldest version of the format, for old readers.
    with h5py.File(file, "w", libver="earliest", userblock_size=_USER_BLOCK) as hdf5_file:
        fill(hdf5_file)
    data = bytearray(file.getvalue())
    data[: len(head)] = head
    mark = _CHECKED + _sum(data)  # checked before reading, since the HDF5 library may crash on damaged files
    data[_CHECKSUM_OFFSET : _CHECKSUM_OFFSET + len(mark)] = mark
    return bytes(data)


def _sum(data: bytes | bytearray) -> bytes:
    return f"{zlib.crc32(memoryview(data)[_USER_BLOCK:]):08x}".encode()


def _open_hdf5(data: bytes) -> File:
    if not data.startswith(_CHECKED, _CHECKSUM_OFFSET):
        raise ValueError("no checksum of how it was written")
    if not data.startswith(_sum(data), _CHECKSUM_OFFSET + len(_CHECKED)):
        raise ValueError(DAMAGED)
    return reading.hdf5(data)
