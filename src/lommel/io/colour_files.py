"""Files and pictures of PSFs in colour channels."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from os import PathLike
from pathlib import Path

import numpy as np

from lommel.base import atomic, reading
from lommel.base.checksums import checksum, sealed
from lommel.io import psf_files, psf_formats, registry
from lommel.io.psf_files import Made
from lommel.io.registry import DAMAGED, Description, Format, Values
from lommel.measures.psf_like import ColourPSFLike, colours
from lommel.optics.colour.spectrum import Channels

_EACH = ("pupil", "method", "error_bound", "scale")  # what differs between channels


def _tiff(answer: ColourPSFLike, description: Description) -> bytes:
    import tifffile

    values = np.ascontiguousarray(answer.values)
    fields = psf_formats.ome(answer, "CYX" if values.ndim == 3 else "ZCYX", description)
    fields["Channel"] = {"Name": list(answer.channels.names)}
    pages = values if values.ndim == 3 else values.reshape(-1, *values.shape[-3:])
    write = partial(tifffile.imwrite, photometric="minisblack")
    return atomic.contents(write, pages, ome=True, metadata=fields)


def _png(answer: ColourPSFLike, description: Description) -> bytes:
    from PIL import Image, PngImagePlugin

    if answer.values.ndim != 3:
        raise ValueError(
            f"a .png holds a single PSF, got a stack of shape {answer.shape}; take part(index), or draw it by plot()"
        )
    levels = np.rint(255.0 * np.sqrt(colours(answer))).astype(np.uint8)
    info = PngImagePlugin.PngInfo()
    info.add_text("Software", description["software"])
    info.add_text("Comment", "square root of the values over the largest of all channels")
    image = Image.fromarray(psf_formats.enlarged(levels, psf_formats.enlargement(answer.psfs[0])))
    return atomic.contents(image.save, format="png", pnginfo=info)


registry.register(
    Format("colours", (".npz",), psf_formats.write_npz, psf_formats.read_npz, what="NumPy archive"),
    Format("colours", (".tif", ".tiff"), _tiff, psf_formats.read_tiff, library="tifffile", what="OME-TIFF"),
    Format("colours", (".png",), _png, library="PIL.Image", what="8-bit picture, square root of the values"),
)
find = partial(registry.find, "colours")


@registry.documented("colours")
def save(answer: ColourPSFLike, path: str | PathLike[str]) -> None:
    """Write PSFs in channels; the suffix chooses the format.

    {formats}

    The picture shows red, green and blue over the largest value of all channels, enlarged to 512 pixels or more;
    nothing reads it back. The other files have the description of :func:`lommel.io.psf_files.save` and the channels.

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
    """Read the channels and a PSF of this kind for each; FileError for a damaged file or another."""
    form, source = find(path, verb="read"), Path(path)
    data = reading.contents(source)
    with psf_files.told(source, "a PSF in channels"):
        arrays, text = form.read(data)
        return rebuild(arrays["values"], reading.json(text), kind)


def require_plain(answer: ColourPSFLike) -> None:
    """Raise ValueError for derivatives, which files of PSFs in channels do not hold."""
    if any(psf.derivatives for psf in answer.psfs):
        raise ValueError('derivatives are saved channel by channel, as by answer["red"].save("red.npz")')


def describe(answer: ColourPSFLike) -> Description:
    """Return how PSFs in channels were computed: the description of the first, and what differs between channels."""
    said = [psf_files.describe(psf) for psf in answer.psfs]
    each = [{name: one[name] for name in _EACH} for one in said]
    return said[0] | {"channels": answer.channels.to_dict(), "each": each, "shape": list(answer.shape)}


def rebuild(values: Values, description: Description, kind: Callable[..., Made]) -> tuple[Channels, tuple[Made, ...]]:
    """Return the channels and their PSFs from the values of a file and its sealed description."""
    if "channels" not in description:
        raise ValueError("it has no channels; PSF.load reads it")
    values = np.ascontiguousarray(values).reshape(description["shape"])
    if description.get("checksum") != checksum(description, {"values": values}):
        raise ValueError(DAMAGED)
    channels, each = Channels.from_dict(description["channels"]), description["each"]
    made, shared = [], {name: said for name, said in description.items() if name not in ("channels", "each")}
    for part, own in zip(np.moveaxis(values, -3, 0), each, strict=True):
        said = shared | {name: own[name] for name in _EACH} | {"shape": list(part.shape)}
        arrays = {"values": np.ascontiguousarray(part)}
        made.append(psf_files.rebuild(arrays, sealed(said, arrays), kind))
    return channels, tuple(made)
