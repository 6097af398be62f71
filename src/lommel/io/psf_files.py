"""PSFs to files and back; every file says how its values were made."""

from __future__ import annotations

import io
import json
import math
from os import PathLike
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from lommel.base import atomic, optional, reading, validation
from lommel.base.checksums import checksum, sealed
from lommel.base.version import version
from lommel.measures.answer import Answer
from lommel.methods import method_from_dict
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil

SUFFIXES = (".tif", ".tiff", ".npy", ".npz", ".png")

_MARK = b"\n#lommel "  # between the array and the description in a .npy file
_SLOPE = "derivative "  # before the name of a derivative in a .npz file
_PNG_LEVELS = 65535
_PNG_SIDE = 512
"""Of pictures: what is smaller is enlarged to it or more, by a whole number."""


Made = TypeVar("Made", bound=Answer)
_Contents = tuple[dict[str, NDArray[Any]], str]  # values and derivatives, description


class FileError(ValueError):
    """A file that cannot be read as a PSF of this package."""


def save(psf: Answer, path: str | PathLike[str]) -> None:
    """Write a PSF; the suffix chooses the format.

    ``.tif``: OME-TIFF with the physical pixel size, all values. ``.npy``: the array, with the description behind
    it, where NumPy does not look. ``.npz``: ``values`` and ``description``. ``.png``: a picture to look at,
    16-bit grey, the square root of the values over their peak, enlarged by the whole number that makes the longer
    side 512 pixels or more (a single PSF only; :meth:`lommel.PSF.load` gives its values back to 1.6e-5 of the peak).

    Derivatives go into ``.npz`` only. The description is JSON: version, pupil (wavefront, obscuration, wavelength,
    f-number, lens distances), method with all its options, normalisation, pixel, error bound, and a checksum of all
    of this and of the values, without which nothing loads. The file is written
    under a temporary name and moved into place, so that a failure leaves what was there before; links are followed
    and permissions kept.

    Raises
    ------
    ValueError
        If the suffix is unknown, for a PNG of a stack, or for derivatives in anything but ``.npz``.
    ImportError
        If tifffile or Pillow is not installed.
    OSError
        If the file cannot be written.
    """
    target = validation.path("path", path)
    writers = {".tif": _tiff, ".tiff": _tiff, ".npy": _npy, ".npz": _npz, ".png": _png}
    writer = writers.get(target.suffix.lower())
    if writer is None:
        raise ValueError(f"path must end in {', '.join(SUFFIXES)}, got {validation.shown(str(path))}")
    if psf.derivatives and writer is not _npz:
        raise ValueError(f"path must end in .npz for a PSF with derivatives, got {validation.shown(str(path))}")
    atomic.write(target, writer(psf, describe(psf)))


def load(path: str | PathLike[str], kind: type[Made]) -> Made:
    """Read a PSF that :func:`lommel.io.psf_files.save` wrote, as one of this kind.

    Raises
    ------
    FileError
        If the file is damaged or was not written by this package.
    OSError
        If it cannot be read.
    """
    return load_described(path, kind)[0]


def load_described(path: str | PathLike[str], kind: type[Made]) -> tuple[Made, dict[str, Any]]:
    """Read a PSF and the whole description in its file, which may say more than a PSF holds."""
    source = validation.path("path", path)
    readers = {
        ".tif": _read_tiff,
        ".tiff": _read_tiff,
        ".npy": _read_npy,
        ".npz": _read_npz,
        ".png": _read_png,
    }
    reader = readers.get(source.suffix.lower())
    if reader is None:
        raise ValueError(f"path must end in {', '.join(SUFFIXES)}, got {validation.shown(str(path))}")
    data = reading.contents(source)
    try:
        arrays, text = reader(data)
        description = json.loads(text)
        return rebuild(arrays, description, kind), description
    except ImportError:
        raise
    except Exception as error:
        raise FileError(
            f"{validation.line(source)} is not a PSF written by lommel: {reading.reason(error)}"
        ) from error


def describe(psf: Answer) -> dict[str, Any]:
    """Return how a PSF was made, in plain types."""
    return {
        "software": f"lommel {version()}",
        "pupil": psf.pupil.to_dict(),
        "method": psf.method.to_dict(),
        "sampling": psf.sampling,
        "normalize": psf.normalize,
        "pixel": psf.pixel,
        "center": list(psf.grid.center),
        "integrate": psf.grid.integrate,
        "unit": psf.unit,
        "error_bound": psf.error_bound,
        "derivative_bounds": psf.derivative_bounds,
        "scale": psf.scale.tolist(),
        "shape": list(psf.shape),
        "dtype": str(psf.values.dtype),
    }


def rebuild(arrays: dict[str, NDArray[Any]], description: dict[str, Any], kind: type[Made]) -> Made:
    """Return the PSF of the arrays of a file, by name, and of their sealed description."""
    pupil, method = Pupil.from_dict(description["pupil"]), method_from_dict(description["method"])
    method.require(pupil)
    bound, picture = description["error_bound"], description.get("png")
    if bound is not None:
        # A picture adds half a level of the square root, at its steepest.
        bound = validation.real("error_bound", bound, least=0.0) + (1.0 / _PNG_LEVELS if picture else 0.0)
    dtype = validation.choice("dtype", description["dtype"], ("float32", "float64"))
    scale = validation.real_array("scale", description["scale"], least=0.0)
    shape = tuple(description["shape"])
    if shape[:-2] != pupil.shape or scale.shape != pupil.shape or len(shape) != len(pupil.shape) + 2:
        raise ValueError(f"values of shape {shape} and scales of {scale.shape} for pupils of {pupil.shape}")
    made = kind(
        values=_values(arrays["values"], dtype, picture).reshape(shape),
        grid=Grid(
            shape[-2:],
            description["pixel"],
            center=description["center"],
            integrate=description["integrate"],
        ),
        pupil=pupil,
        method=method,
        normalize=validation.choice("normalize", description["normalize"], ("energy", "strehl", "peak")),
        error_bound=bound,
        scale=scale,
        derivatives={
            name.removeprefix(_SLOPE): _values(slope, dtype).reshape(shape)
            for name, slope in arrays.items()
            if name.startswith(_SLOPE)
        },
        derivative_bounds=dict(description["derivative_bounds"]),
    )
    # Values that are computed as sums may lie below 0 by their error.
    least = -(bound or 0.0) * float(scale.max())
    if float(made.values.min()) < least:
        raise ValueError(f"its values must be >= 0, got {made.values.min():g}")
    if "checksum" not in description:
        raise ValueError("it has no checksum, so nobody knows whether it is whole; save it anew")
    if description["checksum"] != checksum(description, arrays):
        raise ValueError("its checksum is another: it is damaged, or was changed after it was written")
    return made


def _values(stored: NDArray[Any], kind: str, picture: Any = None) -> NDArray[Any]:
    """Return what a file stores as values, which must be of the stated kind and finite."""
    if picture:
        peak = validation.real("peak", picture["peak"], above=0.0)
        return np.asarray(peak * (stored.astype(np.float64) / _PNG_LEVELS) ** 2, dtype=kind)
    if stored.dtype.newbyteorder("=") != np.dtype(kind):
        raise ValueError(f"its values must be {kind}, got {stored.dtype}")
    if not np.isfinite(stored).all():
        raise ValueError(f"its values must be finite, got {stored[~np.isfinite(stored)].flat[0]}")
    return stored.astype(kind, copy=False)


def _images(name: str) -> Any:
    return optional.library(name, "this format needs", "images")


def _text(psf: Answer, description: dict[str, Any], **slopes: NDArray[Any]) -> str:
    return json.dumps(sealed(description, {"values": psf.values} | slopes), allow_nan=False)


def _tiff(psf: Answer, description: dict[str, Any], planes: dict[str, Any] | None = None) -> bytes:
    """Return an OME-TIFF; `planes` are lists of OME attributes of its pages, which are then no stack in depth."""
    tifffile = _images("tifffile")
    metric = psf.unit == "m"
    size = psf.pixel * (1e6 if metric else 1.0)
    unit = "µm" if metric else "reference frame"
    metadata: dict[str, Any] = {
        "axes": "YX" if psf.values.ndim == 2 else "RYX" if planes else "ZYX",
        "PhysicalSizeX": size,
        "PhysicalSizeXUnit": unit,
        "PhysicalSizeY": size,
        "PhysicalSizeYUnit": unit,
        "Name": "point spread function",
        "Description": _text(psf, description),
    }
    if planes:
        metadata["Plane"] = planes
    values = psf.values if psf.values.ndim == 2 else psf.values.reshape(-1, *psf.shape[-2:])
    buffer = io.BytesIO()
    tifffile.imwrite(buffer, values, ome=True, photometric="minisblack", metadata=metadata)
    return buffer.getvalue()


def _read_tiff(data: bytes) -> _Contents:
    from xml.etree import ElementTree as ET

    tifffile = _images("tifffile")
    reading.tiff(data)
    with reading.quietly(), tifffile.TiffFile(io.BytesIO(data)) as file:
        if not file.ome_metadata:
            raise ValueError("no OME description")
        description = ET.fromstring(file.ome_metadata).find(".//{*}Image/{*}Description")
        if description is None or not description.text:
            raise ValueError("no description of how it was made")
        if file.series[0].nbytes > len(data):
            raise ValueError(f"its pages have {file.series[0].nbytes} bytes, more than the file")
        return {"values": file.asarray()}, description.text


def _npy(psf: Answer, description: dict[str, Any]) -> bytes:
    buffer = io.BytesIO()
    np.save(buffer, psf.values, allow_pickle=False)
    return buffer.getvalue() + _MARK + _text(psf, description).encode()


def _read_npy(data: bytes) -> _Contents:
    values, rest = reading.npy(data)
    if not rest.startswith(_MARK):
        raise ValueError("no description of how it was made")
    return {"values": values}, rest.removeprefix(_MARK).decode()


def _npz(psf: Answer, description: dict[str, Any]) -> bytes:
    buffer = io.BytesIO()
    slopes: dict[str, Any] = {f"{_SLOPE}{name}": values for name, values in psf.derivatives.items()}
    text = np.array(_text(psf, description, **slopes))
    np.savez_compressed(buffer, values=psf.values, description=text, **slopes)
    return buffer.getvalue()


def _read_npz(data: bytes) -> _Contents:
    arrays = reading.npz(data)
    text = str(arrays.pop("description")(reading.MAX_PIXELS))
    most = math.prod(json.loads(text)["shape"])
    return {name: read(most) for name, read in arrays.items()}, text


def _png(psf: Answer, description: dict[str, Any]) -> bytes:
    image, info = _images("PIL.Image"), _images("PIL.PngImagePlugin").PngInfo()
    if psf.values.ndim != 2:
        raise ValueError(f"a .png holds a single PSF, got a stack of shape {psf.shape}")
    peak = float(psf.values.max())
    if peak <= 0:
        raise ValueError("a .png needs a positive value; every value of this PSF is 0")
    shares = np.maximum(psf.values.astype(np.float64), 0.0) / peak
    grey = np.rint(np.sqrt(shares) * _PNG_LEVELS).astype(np.uint16)
    scale = png_scale(psf)
    picture = {"png": {"peak": peak, "stretch": "sqrt", "levels": _PNG_LEVELS, "scale": scale}}
    info.add_text("Software", description["software"])
    info.add_text("lommel", json.dumps(sealed(description | picture, {"values": grey})))
    buffer = io.BytesIO()
    image.fromarray(_enlarged(grey, scale)).save(buffer, format="png", pnginfo=info)
    return buffer.getvalue()


def _read_png(data: bytes) -> _Contents:
    # Opened as what it is: Pillow's limit on the size of pictures from strangers is not for a PSF.
    _images("PIL.Image")
    with _images("PIL.PngImagePlugin").PngImageFile(io.BytesIO(data)) as file:
        text = str(file.info["lommel"])  # which stands before the picture
        description = json.loads(text)
        scale = validation.integer("scale", description["png"]["scale"], least=1, most=_PNG_SIDE)
        if list(file.size[::-1]) != [scale * side for side in description["shape"]]:
            raise ValueError(f"it has {file.size[0]} x {file.size[1]} pixels, other than it says")
        reading.pixels(*file.size)
        file.load()
        grey = np.asarray(file, dtype=np.uint16)
    values = np.ascontiguousarray(grey[::scale, ::scale])
    if not np.array_equal(_enlarged(values, scale), grey):
        raise ValueError("its pixels are not enlarged as it says")
    return {"values": values}, text


def png_scale(psf: Answer) -> int:
    """Return how many pixels a side stand for one of a PSF in a picture."""
    return -(-_PNG_SIDE // max(psf.shape[-2:]))


def _enlarged(grey: NDArray[Any], scale: int) -> NDArray[Any]:
    return np.repeat(np.repeat(grey, scale, axis=0), scale, axis=1)
