"""The same images in many kinds of files, written by the libraries of other programs and never by this package.

A writer takes images of uint16, shape (planes, height, width), and a folder, and returns the words that name them on
a command line. Those of `STATED` also say that pixels are `PIXEL` and planes `STEP` apart, in metres.
"""

from __future__ import annotations

import bz2
import gzip
import struct
import sys
import uuid
import zlib
from collections.abc import Callable, Iterable
from functools import partial
from pathlib import Path
from typing import Any
from xml.sax.saxutils import quoteattr

import h5py
import numpy as np
import OpenEXR
import tifffile
import zarr
from astropy.io import fits
from PIL import Image

Writer = Callable[[np.ndarray, Path], list[str]]

PIXEL, STEP = 0.1e-6, 0.25e-6
_GREY: dict[str, Any] = {"photometric": "minisblack", "metadata": None}


def in_file(
    name: str,
    write: Callable[..., object],
    /,
    *words: str,
    of: Callable[[np.ndarray], np.ndarray] = np.asarray,
    **options: Any,
) -> Writer:
    """Return what writes a function `of` the images to one file of this name, whose options are `words`."""

    def writer(values: np.ndarray, folder: Path) -> list[str]:
        write(of(values), folder / name, **options)
        return [str(folder / name), *words]

    return writer


def each(values: np.ndarray, folder: Path, write: Callable[..., object], suffix: str, **options: Any) -> list[str]:
    """Write a file for each plane."""
    paths = [folder / f"plane-{k}{suffix}" for k in range(len(values))]
    for plane, path in zip(values, paths, strict=True):
        write(plane, path, **options)
    return list(map(str, paths))


def as_type(dtype: str) -> Callable[[np.ndarray], np.ndarray]:
    """Return what makes values of this type."""
    return lambda values: values.astype(dtype)


def tiff(values: np.ndarray, path: Path, **options: Any) -> None:
    """Write pages by tifffile."""
    tifffile.imwrite(path, values, **_GREY | options)


def pillow(values: np.ndarray, path: Path, compression: str) -> None:
    """Write pages by Pillow."""
    first, *others = map(Image.fromarray, values)
    first.save(path, save_all=True, append_images=others, compression=compression)


def reduced(values: np.ndarray, path: Path) -> None:
    """Write pages, each with one of half its size, as other pages and not below them."""
    with tifffile.TiffWriter(path) as file:
        for plane in values:
            file.write(plane, **_GREY)
            file.write(plane[::2, ::2], subfiletype=1, **_GREY)


def imagej(values: np.ndarray, path: Path, across: float = 0.1, *, truncate: bool = False, **told: Any) -> None:
    """Write a hyperstack of ImageJ, with pixels `across` in its unit."""
    told = {"axes": "ZYX", "unit": "micron", "spacing": 0.25} | told
    resolution = (1.0 / across, 1.0 / across)
    tifffile.imwrite(path, values, imagej=True, resolution=resolution, metadata=told, truncate=truncate)


def sizes(scale: float = 1.0, unit: str = "µm") -> dict[str, Any]:
    """Return the sizes of voxels as OME has them, in a unit of which `scale` are a micrometre."""
    lengths = {"X": 0.1, "Y": 0.1, "Z": 0.25}
    return {f"PhysicalSize{letter}": scale * value for letter, value in lengths.items()} | {
        f"PhysicalSize{letter}Unit": unit for letter in lengths
    }


def ome(
    values: np.ndarray, path: Path, axes: str = "ZYX", told: dict[str, Any] | None = None, **options: Any
) -> None:
    """Write an OME-TIFF by tifffile."""
    shape = (1,) * (len(axes) - 3) + values.shape
    metadata = {"axes": axes, **(sizes() if told is None else told)}
    tifffile.imwrite(path, values.reshape(shape), ome=True, photometric="minisblack", metadata=metadata, **options)


def thumbnail(values: np.ndarray, path: Path, *, last: bool = False) -> None:
    """Write an OME-TIFF of two images, of which one is a thumbnail."""
    small = {"axes": "YX", "Name": "thumbnail"}
    images = [(values[0, ::4, ::4], small), (values, {"axes": "ZYX", "Name": "stack", **sizes()})]
    with tifffile.TiffWriter(path, ome=True) as file:
        for image, told in reversed(images) if last else images:
            file.write(image, photometric="minisblack", metadata=told)


def pyramid(values: np.ndarray, path: Path) -> None:
    """Write an OME-TIFF whose planes have smaller ones below them."""
    with tifffile.TiffWriter(path, ome=True) as file:
        told = {"axes": "ZYX", **sizes()}
        file.write(values, subifds=1, photometric="minisblack", tile=(16, 16), metadata=told)
        file.write(values[:, ::2, ::2], subfiletype=1, photometric="minisblack", tile=(16, 16))


def _ome_xml(values: np.ndarray, data: str, more: str = "") -> str:
    planes, height, width = values.shape
    told = " ".join(f"{name}={quoteattr(str(value))}" for name, value in sizes().items())
    return (
        '<?xml version="1.0" encoding="UTF-8"?>'
        f'<OME xmlns="http://www.openmicroscopy.org/Schemas/OME/2016-06" {more}>'
        f'<Image ID="Image:0"><Pixels ID="Pixels:0" DimensionOrder="XYZCT" Type="uint16" SizeX="{width}" '
        f'SizeY="{height}" SizeZ="{planes}" SizeC="1" SizeT="1" {told}>'
        f'<Channel ID="Channel:0:0" SamplesPerPixel="1"/>{data}</Pixels></Image></OME>'
    )


def reverse(values: np.ndarray, path: Path) -> None:
    """Write an OME-TIFF with the last plane first, as its TiffData say."""
    last = len(values) - 1
    data = "".join(f'<TiffData FirstZ="{k}" IFD="{last - k}" PlaneCount="1"/>' for k in range(last + 1))
    with tifffile.TiffWriter(path) as file:
        for k, plane in enumerate(values[::-1]):
            file.write(plane, description=_ome_xml(values, data).encode() if k == 0 else None, **_GREY)


def set_of_ome(values: np.ndarray, folder: Path, *, all_named: bool = False) -> list[str]:
    """Write an OME-TIFF of a file for each plane, of which the first, or all, are named to the command."""
    paths = [folder / f"plane-{k}.ome.tif" for k in range(len(values))]
    names = [str(uuid.UUID(int=k + 1)) for k in range(len(values))]
    data = "".join(
        f'<TiffData FirstZ="{k}" IFD="0" PlaneCount="1">'
        f'<UUID FileName="{path.name}">urn:uuid:{name}</UUID></TiffData>'
        for k, (path, name) in enumerate(zip(paths, names, strict=True))
    )
    for plane, path, name in zip(values, paths, names, strict=True):
        description = _ome_xml(values, data, f'UUID="urn:uuid:{name}"').encode()
        tifffile.imwrite(path, plane, description=description, **_GREY)
    return list(map(str, paths if all_named else paths[:1]))


def ome_zarr(values: np.ndarray, path: Path, version: int = 2, *, axes: str = "zyx", **options: Any) -> None:
    """Write an OME-Zarr, 0.4 by Zarr's format 2 and 0.5 by its format 3."""
    group = zarr.create_group(str(path), zarr_format=version)
    lead = len(axes) - 3
    chunks = (1,) * lead + (2, *(min(16, side) for side in values.shape[1:]))
    if version == 2:
        options["chunk_key_encoding"] = {"name": "v2", "separator": "/"}
    group.create_array("0", data=values.reshape((1,) * lead + values.shape), chunks=chunks, **options)
    kinds = {"t": "time", "c": "channel"}
    told = [{"name": name, "type": kinds[name]} for name in axes[:lead]]
    told += [{"name": name, "type": "space", "unit": "micrometer"} for name in axes[lead:]]
    scale = [{"type": "scale", "scale": [1.0] * lead + [0.25, 0.1, 0.1]}]
    scales = [{"axes": told, "datasets": [{"path": "0", "coordinateTransformations": scale}]}]
    if version == 2:
        group.attrs["multiscales"] = [{"version": "0.4", **scales[0]}]
    else:
        group.attrs["ome"] = {"version": "0.5", "multiscales": scales}


def cube(values: np.ndarray, path: Path) -> None:
    """Write a FITS cube by astropy; unsigned numbers with BZERO, and compressed if the name ends in .gz."""
    fits.PrimaryHDU(values).writeto(path)


def packed(
    values: np.ndarray, path: Path, write: Callable[[np.ndarray, Path], object], compress: Callable[[bytes], bytes]
) -> None:
    """Write another file, and compress all of it."""
    inner = path.with_suffix("")
    write(values, inner)
    path.write_bytes(compress(inner.read_bytes()))
    inner.unlink()


def extensions(values: np.ndarray, path: Path, make: Callable[[np.ndarray], Iterable[Any]]) -> None:
    """Write FITS whose images are in extensions."""
    fits.HDUList([fits.PrimaryHDU(), *make(values)]).writeto(path)


def after_errors(values: np.ndarray, folder: Path) -> list[str]:
    """Write FITS with an extension of errors before that of the images, which is asked for."""
    wrong = np.sqrt(values).astype(np.float32)
    parts = [fits.ImageHDU(wrong, name="ERR"), fits.ImageHDU(values, name="SCI")]
    extensions(values, folder / "a.fits", lambda _: parts)
    return [f"{folder / 'a.fits'}[SCI]"]


def scaled(values: np.ndarray, path: Path) -> None:
    """Write FITS of integers, of which each counts for a half."""
    made = fits.PrimaryHDU(values.astype(np.float64))
    made.scale("int32", bscale=0.5, bzero=100.0)
    made.writeto(path)


def odd_card(values: np.ndarray, path: Path) -> None:
    """Write FITS with a card that is not standard, as some cameras do."""
    made = fits.PrimaryHDU(values)
    made.header["COMMENT"] = "REPLACED"
    made.writeto(path)
    data = path.read_bytes()
    card = b"Expos.T = 1,5 s / by hand".ljust(80)
    path.write_bytes(data.replace(b"COMMENT REPLACED".ljust(80), card))
    assert card in path.read_bytes()


def npy(values: np.ndarray, path: Path, order: str = "C") -> None:
    """Write NPY."""
    np.save(path, np.asarray(values, order=order))


def npz(values: np.ndarray, path: Path) -> None:
    """Write NPZ."""
    np.savez(path, images=values)


def hdf5(values: np.ndarray, path: Path) -> None:
    """Write HDF5."""
    with h5py.File(path, "w") as file:
        file["images"] = values


def raster(values: np.ndarray, path: Path, mode: str | None = None, **options: Any) -> None:
    """Write a picture by Pillow."""
    image = Image.fromarray(values)
    (image if mode is None else image.convert(mode)).save(path, **options)


_SWAPPED = ">" if sys.byteorder == "little" else "<"
_ESCAPED = "\\u00B5m"  # as ImageJ writes it

STATED: dict[str, Writer] = {
    "imagej": in_file("a.tif", imagej),
    "imagej, an escaped unit": in_file("a.tif", imagej, unit=_ESCAPED),
    "imagej, one directory": in_file("a.tif", imagej, truncate=True),
    "imagej, zunit of its own": in_file("a.tif", imagej, unit="nm", zunit="micron", yunit="nm", across=100.0),
    "ome-tiff": in_file("a.ome.tif", ome),
    "ome-tiff of five axes": in_file("a.ome.tif", ome, axes="TCZYX"),
    "ome-tiff in nm": in_file("a.ome.tif", ome, told=sizes(1e3, "nm")),
    "ome-tiff in mm": in_file("a.ome.tif", ome, told=sizes(1e-3, "mm")),
    "ome-tiff, big-endian and tiled": in_file("a.ome.tif", ome, byteorder=_SWAPPED, tile=(16, 16)),
    "ome-tiff, deflate": in_file("a.ome.tif", ome, compression="zlib"),
    "ome-tiff, bigtiff": in_file("a.ome.tif", ome, bigtiff=True),
    "ome-tiff, planes in reverse": in_file("a.ome.tif", reverse),
    "ome-tiff, a thumbnail first": in_file("a.ome.tif", thumbnail),
    "ome-tiff, a thumbnail last": in_file("a.ome.tif", thumbnail, last=True),
    "ome-tiff, a pyramid": in_file("a.ome.tif", pyramid),
    "ome-tiff of several files": set_of_ome,
    "ome-zarr 0.4": in_file("a.ome.zarr", ome_zarr),
    "ome-zarr 0.4 of five axes": in_file("a.ome.zarr", ome_zarr, axes="tczyx"),
    "ome-zarr 0.4, not compressed": in_file("a.ome.zarr", ome_zarr, compressors=None),
    "ome-zarr 0.5": in_file("a.ome.zarr", ome_zarr, version=3),
    "ome-zarr 0.5, not compressed": in_file("a.ome.zarr", ome_zarr, version=3, compressors=None),
}
"""Containers that state the sizes of voxels."""

BARE: dict[str, Writer] = {
    "tiff": in_file("a.tif", tiff),
    "tiff with its shape by tifffile": in_file("a.tif", tiff, metadata={}),
    "tiff, planes as colours of one page": in_file("a.tif", tiff, photometric="rgb", planarconfig="separate"),
    "tiff, deflate": in_file("a.tif", tiff, compression="zlib"),
    "tiff, deflate and a predictor": in_file("a.tif", pillow, compression="tiff_adobe_deflate"),
    "tiff, lzw": in_file("a.tif", pillow, compression="tiff_lzw"),
    "tiff, packbits": in_file("a.tif", pillow, compression="packbits"),
    "tiff, big-endian": in_file("a.tif", tiff, byteorder=_SWAPPED),
    "tiff, big-endian deflate": in_file("a.tif", tiff, byteorder=_SWAPPED, compression="zlib"),
    "tiff, bigtiff": in_file("a.tif", tiff, bigtiff=True),
    "tiff, tiled": in_file("a.tif", tiff, tile=(16, 16)),
    "tiff, strips of three rows": in_file("a.tif", tiff, rowsperstrip=3),
    "tiff, upper-case suffix": in_file("A B µ.TIFF", tiff),
    "tiff, smaller pages between": in_file("a.tif", reduced),
    "tiff of float32": in_file("a.tif", tiff, of=as_type("f4")),
    "tiff of float64": in_file("a.tif", tiff, of=as_type("f8")),
    "tiff of int32": in_file("a.tif", tiff, of=as_type("i4")),
    "tiff of int16": in_file("a.tif", tiff, of=as_type("i2")),
    "tiff of uint32": in_file("a.tif", tiff, of=as_type("u4")),
    "tiff in colour": in_file("a.tif", tiff, of=lambda v: np.repeat(v[..., None], 3, axis=-1), photometric="rgb"),
    "tiff.gz": in_file("a.tif.gz", packed, write=tiff, compress=gzip.compress),
    "tiffs": partial(each, write=tiff, suffix=".tif", metadata={}),
    "ome-tiff of several files, all named": partial(set_of_ome, all_named=True),
    "pngs": partial(each, write=raster, suffix=".png"),
    "npy": in_file("a.npy", npy),
    "npy, Fortran order": in_file("a.npy", npy, order="F"),
    "npy, big-endian": in_file("a.npy", npy, of=as_type(">u2")),
    "npy of float32": in_file("a.npy", npy, of=as_type("<f4")),
    "npy of int32": in_file("a.npy", npy, of=as_type("<i4")),
    "npy of uint64": in_file("a.npy", npy, of=as_type("<u8")),
    "npy of five axes": in_file("a.npy", npy, of=lambda values: values[None, None]),
    "npys": partial(each, write=npy, suffix=".npy"),
    "npz": in_file("a.npz", npz),
    "hdf5": in_file("a.h5", hdf5),
    "fits": in_file("a.fits", cube),
    "fits, upper-case suffix": in_file("A.FIT", cube),
    "fits of float32": in_file("a.fits", cube, of=as_type("f4")),
    "fits of int32": in_file("a.fits", cube, of=as_type("i4")),
    "fits, scaled": in_file("a.fits", scaled),
    "fits.gz": in_file("a.fits.gz", cube),
    "fits.bz2": in_file("a.fits.bz2", packed, write=cube, compress=bz2.compress),
    "fits, SCI after ERR": after_errors,
    "fits, an odd card": in_file("a.fits", odd_card),
    "fits, tiles compressed": in_file(
        "a.fits", extensions, make=lambda values: [fits.CompImageHDU(values, compression_type="RICE_1")]
    ),
    "fits, an extension each": in_file("a.fits", extensions, make=lambda values: map(fits.ImageHDU, values)),
    "fitses": partial(each, write=cube, suffix=".fits"),
}
"""Containers that do not."""

ALL = STATED | BARE


def palette(values: np.ndarray, path: Path) -> None:
    """Write a PNG with a palette of the colours that there are."""
    grey = values.ndim == 2
    found, places = np.unique(values.reshape(-1, 1 if grey else 3), axis=0, return_inverse=True)
    image = Image.fromarray(places.reshape(values.shape[:2]).astype(np.uint8), mode="P")
    image.putpalette(np.broadcast_to(found, (len(found), 3)).astype(np.uint8).tobytes())
    image.save(path)


def turned(values: np.ndarray, path: Path) -> None:
    """Write a picture that lies on its side, as its EXIF says."""
    tags = Image.Exif()
    tags[0x0112] = 6  # the stored rows run from the right
    Image.fromarray(np.ascontiguousarray(np.rot90(values))).save(path, exif=tags)


def deep(values: np.ndarray) -> np.ndarray:
    """Return 16 bits from 8."""
    return 257 * values.astype(np.uint16)


def png(values: np.ndarray, kind: int) -> bytes:
    """A PNG by the standard alone, of 8 or 16 bits."""

    def chunk(name: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    height, width = values.shape[:2]
    rows = values.astype(f">u{values.itemsize}").tobytes()
    step = len(rows) // height
    lines = b"".join(b"\0" + rows[at : at + step] for at in range(0, len(rows), step))
    head = struct.pack(">IIBBBBB", width, height, 8 * values.itemsize, kind, 0, 0, 0)
    parts = (b"IHDR", head), (b"IDAT", zlib.compress(lines)), (b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + b"".join(chunk(*part) for part in parts)


def deep_png(values: np.ndarray, path: Path) -> None:
    """Write a PNG of 16 bits, by hand, for Pillow writes those of grey alone."""
    path.write_bytes(png(deep(values), 0 if values.ndim == 2 else 2))


def light(values: np.ndarray) -> np.ndarray:
    """Return the linear light of sRGB of 8 bits, by IEC 61966-2-1."""
    share = values / 255.0
    return np.where(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055) ** 2.4)


def photo_tiff(values: np.ndarray, path: Path, **options: Any) -> None:
    """Write a picture as TIFF by tifffile."""
    told = {"photometric": "rgb" if values.shape[-1] == 3 or values.shape[0] == 3 else "minisblack"}
    tiff(values, path, **told | options)


def opaque(values: np.ndarray, path: Path) -> None:
    """Write a picture with an alpha that hides nothing."""
    raster(values, path, mode="LA" if values.ndim == 2 else "RGBA")


def exr(values: np.ndarray, path: Path, channels: str) -> None:
    """Write EXR of float32, by OpenEXR, with channels of one letter."""
    parts = values.astype(np.float32).reshape(*values.shape[:2], -1)
    made = {
        channel: np.ascontiguousarray(parts[..., min(k, parts.shape[2] - 1)]) for k, channel in enumerate(channels)
    }
    OpenEXR.File({"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}, made).write(str(path))


PHOTOS: dict[str, Writer] = {
    "png": in_file("photo.png", raster),
    "png, upper-case suffix": in_file("PHOTO µ.PNG", raster),
    "png without a suffix": in_file("photo", raster, format="png"),
    "png, a palette": in_file("photo.png", palette),
    "png, opaque": in_file("photo.png", opaque),
    "png of 16 bits": in_file("photo.png", deep_png),
    "png on its side": in_file("photo.png", turned),
    "tiff": in_file("photo.tif", photo_tiff),
    "tiff, deflate": in_file("photo.tif", photo_tiff, compression="zlib"),
    "tiff, lzw": in_file("photo.tif", raster, compression="tiff_lzw"),
    "tiff, packbits": in_file("photo.tif", raster, compression="packbits"),
    "tiff, big-endian": in_file("photo.tif", photo_tiff, byteorder=_SWAPPED),
    "tiff, bigtiff": in_file("photo.tif", photo_tiff, bigtiff=True),
    "tiff, tiled": in_file("photo.tif", photo_tiff, tile=(16, 16)),
    "tiff, strips of three rows": in_file("photo.tif", photo_tiff, rowsperstrip=3),
    "tiff on its side": in_file("photo.tif", turned),
    "tiff, opaque": in_file("photo.tif", opaque),
    "tiff of 16 bits": in_file("photo.tif", photo_tiff, of=deep),
    "tiff of 16 bits, big-endian deflate": in_file(
        "photo.tif", photo_tiff, of=deep, byteorder=_SWAPPED, compression="zlib"
    ),
    "tiff of light in float32": in_file("photo.tif", photo_tiff, of=lambda values: light(values).astype(np.float32)),
    "tiff of light in float64": in_file("photo.tif", photo_tiff, of=light),
    "tiff of sRGB in float32": in_file(
        "photo.tif", photo_tiff, "--encoding", "srgb", of=lambda values: (values / 255.0).astype(np.float32)
    ),
    "tiff of int32": in_file("photo.tif", photo_tiff, of=as_type("i4")),
    "tiff of two pages": in_file("photo.tif", photo_tiff, of=lambda values: np.stack([values, values])),
    "bmp": in_file("photo.bmp", raster),
    "gif": in_file("photo.gif", raster),
    "npy": in_file("photo.npy", npy),
    "fits": in_file("photo.fits", cube),
}
"""Photographs, of 8 bits in sRGB where their names say nothing else; the words may end in options."""

COLOUR: dict[str, Writer] = PHOTOS | {
    "tiff, a plane for each colour": in_file(
        "photo.tif", photo_tiff, of=lambda values: np.moveaxis(values, 2, 0), planarconfig="separate"
    ),
    "exr of light": in_file("photo.exr", exr, of=light, channels="RGB"),
}

GREY: dict[str, Writer] = PHOTOS | {
    "png in colour": in_file("photo.png", raster, mode="RGB"),
    "tiff in colour": in_file("photo.tif", raster, mode="RGB"),
    "exr of light": in_file("photo.exr", exr, of=light, channels="Y"),
    "exr of light, in colour": in_file("photo.exr", exr, of=light, channels="RGB"),
    "tiff, white at 0": in_file("photo.tif", photo_tiff, of=lambda values: 255 - values, photometric="miniswhite"),
}


def pfm(values: np.ndarray, path: Path, order: str = "<", kind: str = "Pf") -> None:
    """Write PFM, by hand: rows from below, and a sign that tells the order of bytes."""
    stored = values if kind == "Pf" else np.repeat(values[..., None], 3, axis=2)
    head = f"{kind}\n{values.shape[1]} {values.shape[0]}\n{'-' if order == '<' else ''}1.0\n"
    path.write_bytes(head.encode() + stored[::-1].astype(f"{order}f4").tobytes())


def millimetres(dtype: str) -> Callable[[np.ndarray], np.ndarray]:
    """Return what makes whole millimetres of metres."""
    return lambda values: np.round(1e3 * values).astype(dtype)


def centimetres(values: np.ndarray) -> np.ndarray:
    """Return whole centimetres."""
    return (100 * values).astype(np.uint8)


_MM, _CM = ("--depth-scale", "0.001"), ("--depth-scale", "0.01")

DEPTHS: dict[str, Writer] = {
    "npy": in_file("depth.npy", npy),
    "npy, Fortran order": in_file("depth.npy", npy, order="F"),
    "npy, big-endian": in_file("depth.npy", npy, of=as_type(">f8")),
    "npy of float32": in_file("depth.npy", npy, of=as_type("<f4")),
    "npy of float16": in_file("depth.npy", npy, of=as_type("<f2")),
    "npy in mm": in_file("depth.npy", npy, *_MM, of=millimetres("<u2")),
    "npy in mm, big-endian": in_file("depth.npy", npy, *_MM, of=millimetres(">i4")),
    "npy of three axes": in_file("depth.npy", npy, of=lambda values: values[..., None]),
    "npz": in_file("depth.npz", npz),
    "pfm": in_file("depth.pfm", pfm),
    "pfm, big-endian": in_file("depth.pfm", pfm, order=">"),
    "pfm in colour": in_file("depth.pfm", pfm, kind="PF"),
    "tiff of float32": in_file("depth.tif", tiff, of=as_type("f4")),
    "tiff of float64": in_file("depth.tif", tiff, of=as_type("f8")),
    "tiff of float32, deflate": in_file("depth.tif", tiff, of=as_type("f4"), compression="zlib"),
    "tiff of float32, big-endian tiled": in_file(
        "depth.tif", tiff, of=as_type("f4"), byteorder=_SWAPPED, tile=(16, 16)
    ),
    "tiff of float32, lzw": in_file("depth.tif", raster, of=as_type("f4"), compression="tiff_lzw"),
    "tiff of float16": in_file("depth.tif", tiff, of=as_type("f2")),
    "tiff in mm": in_file("depth.tif", tiff, *_MM, of=millimetres("u2")),
    "tiff in mm, deflate": in_file("depth.tif", tiff, *_MM, of=millimetres("u2"), compression="zlib"),
    "tiff in mm, lzw": in_file("depth.tif", raster, *_MM, of=millimetres("u2"), compression="tiff_lzw"),
    "tiff in mm, big-endian": in_file("depth.tif", tiff, *_MM, of=millimetres("u2"), byteorder=_SWAPPED),
    "tiff in mm of int32": in_file("depth.tif", tiff, *_MM, of=millimetres("i4")),
    "tiff in mm without a scale": in_file("depth.tif", tiff, of=millimetres("u2")),
    "png in mm": in_file("depth.png", raster, *_MM, of=millimetres("u2")),
    "png in colour": in_file("depth.png", raster, *_CM, of=centimetres, mode="RGB"),
    "png on its side": in_file("depth.png", turned, *_CM, of=centimetres),
    "exr, Z": in_file("depth.exr", exr, channels="Z"),
    "exr, Y": in_file("depth.exr", exr, channels="Y"),
    "exr in colour": in_file("depth.exr", exr, channels="RGB"),
    "fits": in_file("depth.fits", cube),
}
"""Depth maps, in metres where their names say nothing else, of distances that are whole multiples of 0.25 m."""
