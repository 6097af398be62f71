"""PSFs in channels to files and back, and pictures of them in colour."""

from __future__ import annotations

import json
from collections.abc import Callable
from functools import partial
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from lommel.base import atomic, reading
from lommel.base.checksums import checksum, sealed
from lommel.io import psf_files, psf_numpy, psf_png, psf_tiff, registry
from lommel.io.psf_files import Made
from lommel.io.registry import Format
from lommel.measures.psf_like import ColourPSFLike, colours
from lommel.optics.colour.spectrum import Channels

_EACH = ("pupil", "method", "error_bound", "scale")  # what channels differ in


def save(answer: ColourPSFLike, path: str | PathLike[str]) -> None:
    """Write PSFs in channels; the suffix chooses the format.

    ``.npz``: ``values`` and ``description``, JSON as of :func:`lommel.io.psf_files.save` with the channels and what
    is of each. ``.tif``: OME-TIFF of all values with the same description, the channels with their names. ``.png``: a
    picture to look at, red, green and blue of 8 bit, the square root of the values over the largest of all channels,
    enlarged by the whole number that makes the longer side 512 pixels or more; nothing reads it back.

    Parameters
    ----------
    answer : ColourPSF
    path : path

    Raises
    ------
    ValueError
        If the suffix is unknown, for derivatives, or for a PNG of a stack or of channels that are neither one nor
        three.
    ImportError
        If tifffile or Pillow is not installed.
    OSError
        If the file cannot be written.
    """
    form = find(path)
    require_plain(answer)
    atomic.write(Path(path), form.write(answer, describe(answer)))


def load(path: str | PathLike[str], kind: Callable[..., Made]) -> tuple[Channels, tuple[Made, ...]]:
    """Read what :func:`lommel.io.colour_files.save` wrote: the channels, and a PSF of this kind for each.

    Raises
    ------
    FileError
        If the file is damaged or was not written by this package as a PSF in channels.
    OSError
        If it cannot be read.
    """
    form, source = find(path, verb="read"), Path(path)
    data = reading.contents(source)
    with psf_files.told(source, "a PSF in channels"):
        arrays, text = form.read(data)
        return rebuild(arrays["values"], reading.json(text), kind)


def require_plain(answer: ColourPSFLike) -> None:
    """Raise ValueError if there are derivatives, which files in channels have no place for."""
    if any(psf.derivatives for psf in answer.psfs):
        raise ValueError('derivatives are saved channel by channel, as by answer["red"].save("red.npz")')


def describe(answer: ColourPSFLike) -> dict[str, Any]:
    """Return how PSFs in channels were made, in plain types.

    Parameters
    ----------
    answer : ColourPSF

    Returns
    -------
    dict
        As of :func:`lommel.io.psf_files.describe`, of the first channel, and what is of each.
    """
    said = [psf_files.describe(psf) for psf in answer.psfs]
    each = [{name: one[name] for name in _EACH} for one in said]
    return said[0] | {"channels": answer.channels.to_dict(), "each": each, "shape": list(answer.shape)}


def rebuild(values: Any, description: dict[str, Any], kind: Callable[..., Made]) -> tuple[Channels, tuple[Made, ...]]:
    """Return the channels and their PSFs from the values of a file and its sealed description."""
    if "channels" not in description:
        raise ValueError("it has no channels; PSF.load reads it")
    values = np.ascontiguousarray(values).reshape(description["shape"])
    if description.get("checksum") != checksum(description, {"values": values}):
        raise ValueError("its checksum is another: it is damaged, or was changed after it was written")
    channels, each = Channels.from_dict(description["channels"]), description["each"]
    made, shared = [], {name: said for name, said in description.items() if name not in ("channels", "each")}
    for part, own in zip(np.moveaxis(values, -3, 0), each, strict=True):
        said = shared | {name: own[name] for name in _EACH} | {"shape": list(part.shape)}
        arrays = {"values": np.ascontiguousarray(part)}
        made.append(psf_files.rebuild(arrays, sealed(said, arrays), kind))
    return channels, tuple(made)


def npz(answer: ColourPSFLike, description: dict[str, Any]) -> bytes:
    """Return an archive of the values and the description."""
    return psf_numpy.archive({"values": np.ascontiguousarray(answer.values)}, description)


def _tiff(answer: ColourPSFLike, description: dict[str, Any]) -> bytes:
    import tifffile

    metric, values = answer.unit == "m", np.ascontiguousarray(answer.values)
    factor, unit = (1e6, "µm") if metric else (1.0, "reference frame")
    high, wide = (side * factor for side in answer.grid.pitch)
    metadata: dict[str, Any] = {
        "axes": "CYX" if values.ndim == 3 else "ZCYX",
        "PhysicalSizeX": wide,
        "PhysicalSizeXUnit": unit,
        "PhysicalSizeY": high,
        "PhysicalSizeYUnit": unit,
        "Channel": {"Name": list(answer.channels.names)},
        "Name": "point spread function",
        "Description": json.dumps(sealed(description, {"values": values}), allow_nan=False),
    }
    pages = values if values.ndim == 3 else values.reshape(-1, *values.shape[-3:])
    write = partial(tifffile.imwrite, photometric="minisblack")
    return atomic.contents(write, pages, ome=True, metadata=metadata)


def _png(answer: ColourPSFLike, description: dict[str, Any]) -> bytes:
    from PIL import Image, PngImagePlugin

    if answer.values.ndim != 3:
        raise ValueError(
            f"a .png holds a single PSF, got a stack of shape {answer.shape}; take part(index), or draw it by plot()"
        )
    levels = np.rint(255.0 * np.sqrt(colours(answer))).astype(np.uint8)
    times = psf_png.scale(answer.psfs[0])
    info = PngImagePlugin.PngInfo()
    info.add_text("Software", description["software"])
    info.add_text("Comment", "square root of the values over the largest of all channels")
    image = Image.fromarray(levels.repeat(times, axis=0).repeat(times, axis=1))
    return atomic.contents(image.save, format="png", pnginfo=info)


registry.register(
    Format("colours", (".npz",), npz, psf_numpy.read_npz),
    Format("colours", (".tif", ".tiff"), _tiff, psf_tiff.read, library="tifffile", extra="images"),
    Format("colours", (".png",), _png, library="PIL.Image", extra="images"),
)
find = partial(registry.find, "colours")
