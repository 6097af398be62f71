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
from collections.abc import Callable
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


def _one(folder: Path, name: str) -> tuple[Path, list[str]]:
    path = folder / name
    return path, [str(path)]


def tiff(values: np.ndarray, folder: Path, name: str = "a.tif", dtype: str = "u2", **options: Any) -> list[str]:
    """Write pages by tifffile."""
    path, words = _one(folder, name)
    tifffile.imwrite(path, values.astype(dtype), **_GREY | options)
    return words


def _written(write: Callable[..., object], path: Path, values: np.ndarray) -> list[str]:
    write(path, values)
    return [str(path)]


def pillow(values: np.ndarray, folder: Path, compression: str) -> list[str]:
    """Write pages by Pillow."""
    path, words = _one(folder, "a.tif")
    first, *others = map(Image.fromarray, values)
    first.save(path, save_all=True, append_images=others, compression=compression)
    return words


def reduced(values: np.ndarray, folder: Path) -> list[str]:
    """Write pages, each with one of half its size, as other pages and not below them."""
    path, words = _one(folder, "a.tif")
    with tifffile.TiffWriter(path) as file:
        for plane in values:
            file.write(plane, **_GREY)
            file.write(plane[::2, ::2], subfiletype=1, **_GREY)
    return words


def each(values: np.ndarray, folder: Path, write: Callable[[np.ndarray, Path], object], suffix: str) -> list[str]:
    """Write a file for each plane."""
    paths = [folder / f"plane-{k}{suffix}" for k in range(len(values))]
    for plane, path in zip(values, paths, strict=True):
        write(plane, path)
    return list(map(str, paths))


def imagej(values: np.ndarray, folder: Path, axes: str = "ZYX", across: float = 0.1, **told: Any) -> list[str]:
    """Write a hyperstack of ImageJ, with pixels `across` in its unit."""
    path, words = _one(folder, "a.tif")
    options = {"truncate": told.pop("truncate", False)}
    told = {"axes": axes, "unit": "micron", "spacing": 0.25} | told
    tifffile.imwrite(path, values, imagej=True, resolution=(1.0 / across, 1.0 / across), metadata=told, **options)
    return words


def sizes(scale: float = 1.0, unit: str = "µm") -> dict[str, Any]:
    """Return the sizes of voxels as OME has them, in a unit of which `scale` are a micrometre."""
    lengths = {"X": 0.1, "Y": 0.1, "Z": 0.25}
    return {f"PhysicalSize{letter}": scale * value for letter, value in lengths.items()} | {
        f"PhysicalSize{letter}Unit": unit for letter in lengths
    }


def ome(
    values: np.ndarray, folder: Path, axes: str = "ZYX", told: dict[str, Any] | None = None, **options: Any
) -> Any:
    """Write an OME-TIFF by tifffile."""
    path, words = _one(folder, "a.ome.tif")
    shape = (1,) * (len(axes) - 3) + values.shape
    metadata = {"axes": axes, **(sizes() if told is None else told)}
    tifffile.imwrite(path, values.reshape(shape), ome=True, photometric="minisblack", metadata=metadata, **options)
    return words


def thumbnail(values: np.ndarray, folder: Path, *, last: bool = False) -> list[str]:
    """Write an OME-TIFF of two images, of which one is a thumbnail."""
    path, words = _one(folder, "a.ome.tif")
    small = {"axes": "YX", "Name": "thumbnail"}
    images = [(values[0, ::4, ::4], small), (values, {"axes": "ZYX", "Name": "stack", **sizes()})]
    with tifffile.TiffWriter(path, ome=True) as file:
        for image, told in reversed(images) if last else images:
            file.write(image, photometric="minisblack", metadata=told)
    return words


def pyramid(values: np.ndarray, folder: Path) -> list[str]:
    """Write an OME-TIFF whose planes have smaller ones below them."""
    path, words = _one(folder, "a.ome.tif")
    with tifffile.TiffWriter(path, ome=True) as file:
        told = {"axes": "ZYX", **sizes()}
        file.write(values, subifds=1, photometric="minisblack", tile=(16, 16), metadata=told)
        file.write(values[:, ::2, ::2], subfiletype=1, photometric="minisblack", tile=(16, 16))
    return words


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


def reverse(values: np.ndarray, folder: Path) -> list[str]:
    """Write an OME-TIFF with the last plane first, as its TiffData say."""
    path, words = _one(folder, "a.ome.tif")
    last = len(values) - 1
    data = "".join(f'<TiffData FirstZ="{k}" IFD="{last - k}" PlaneCount="1"/>' for k in range(last + 1))
    with tifffile.TiffWriter(path) as file:
        for k, plane in enumerate(values[::-1]):
            file.write(plane, description=_ome_xml(values, data).encode() if k == 0 else None, **_GREY)
    return words


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


def ome_zarr(values: np.ndarray, folder: Path, version: int = 2, *, axes: str = "zyx", **options: Any) -> list[str]:
    """Write an OME-Zarr, 0.4 by Zarr's format 2 and 0.5 by its format 3."""
    path, words = _one(folder, "a.ome.zarr")
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
    return words


def cube(values: np.ndarray, folder: Path, name: str = "a.fits", dtype: str = "u2") -> list[str]:
    """Write a FITS cube by astropy; unsigned numbers with BZERO, and compressed if the name ends in .gz."""
    path, words = _one(folder, name)
    fits.PrimaryHDU(values.astype(dtype)).writeto(path)
    return words


def packed(
    values: np.ndarray, folder: Path, write: Writer, compress: Callable[[bytes], bytes], more: str
) -> list[str]:
    """Write another file, and compress all of it."""
    (word,) = write(values, folder)
    path = Path(word)
    there = path.with_name(path.name + more)
    there.write_bytes(compress(path.read_bytes()))
    path.unlink()
    return [str(there)]


def extensions(values: np.ndarray, folder: Path) -> list[str]:
    """Write FITS with an extension of errors before that of the images, which is asked for."""
    path, words = _one(folder, "a.fits")
    wrong = np.sqrt(values).astype(np.float32)
    fits.HDUList([fits.PrimaryHDU(), fits.ImageHDU(wrong, name="ERR"), fits.ImageHDU(values, name="SCI")]).writeto(
        path
    )
    return [f"{words[0]}[SCI]"]


def extension_each(values: np.ndarray, folder: Path) -> list[str]:
    """Write FITS with an extension for each plane."""
    path, words = _one(folder, "a.fits")
    fits.HDUList([fits.PrimaryHDU(), *(fits.ImageHDU(plane) for plane in values)]).writeto(path)
    return words


def scaled(values: np.ndarray, folder: Path) -> list[str]:
    """Write FITS of integers, of which each counts for a half."""
    path, words = _one(folder, "a.fits")
    made = fits.PrimaryHDU(values.astype(np.float64))
    made.scale("int32", bscale=0.5, bzero=100.0)
    made.writeto(path)
    return words


def odd_card(values: np.ndarray, folder: Path) -> list[str]:
    """Write FITS with a card that is not standard, as some cameras do."""
    path, words = _one(folder, "a.fits")
    made = fits.PrimaryHDU(values)
    made.header["COMMENT"] = "REPLACED"
    made.writeto(path)
    data = path.read_bytes()
    card = b"Expos.T = 1,5 s / by hand".ljust(80)
    path.write_bytes(data.replace(b"COMMENT REPLACED".ljust(80), card))
    assert card in path.read_bytes()
    return words


def rice(values: np.ndarray, folder: Path) -> list[str]:
    """Write FITS with the compression of its tiles."""
    path, words = _one(folder, "a.fits")
    fits.HDUList([fits.PrimaryHDU(), fits.CompImageHDU(values, compression_type="RICE_1")]).writeto(path)
    return words


def npy(values: np.ndarray, folder: Path, order: str = "C", dtype: str = "<u2") -> list[str]:
    """Write NPY."""
    path, words = _one(folder, "a.npy")
    np.save(path, np.asarray(values.astype(dtype), order=order))
    return words


def npz(values: np.ndarray, folder: Path) -> list[str]:
    """Write NPZ."""
    path, words = _one(folder, "a.npz")
    np.savez(path, images=values)
    return words


def hdf5(values: np.ndarray, folder: Path) -> list[str]:
    """Write HDF5."""
    path, words = _one(folder, "a.h5")
    with h5py.File(path, "w") as file:
        file["images"] = values
    return words


def colours(values: np.ndarray, folder: Path) -> list[str]:
    """Write the same in three channels, red, green and blue."""
    return tiff(np.repeat(values[..., None], 3, axis=-1), folder, photometric="rgb")


def _png(plane: np.ndarray, path: Path) -> None:
    Image.fromarray(plane).save(path)


def _page(plane: np.ndarray, path: Path) -> None:
    tifffile.imwrite(path, plane, photometric="minisblack")


def _image(plane: np.ndarray, path: Path) -> None:
    fits.PrimaryHDU(plane).writeto(path)


_SWAPPED = ">" if sys.byteorder == "little" else "<"
_ESCAPED = "\\u00B5m"  # as ImageJ writes it

STATED: dict[str, Writer] = {
    "imagej": imagej,
    "imagej, an escaped unit": partial(imagej, unit=_ESCAPED),
    "imagej, one directory": partial(imagej, truncate=True),
    "imagej, zunit of its own": partial(imagej, unit="nm", zunit="micron", yunit="nm", across=100.0),
    "ome-tiff": ome,
    "ome-tiff of five axes": partial(ome, axes="TCZYX"),
    "ome-tiff in nm": partial(ome, told=sizes(1e3, "nm")),
    "ome-tiff in mm": partial(ome, told=sizes(1e-3, "mm")),
    "ome-tiff, big-endian and tiled": partial(ome, byteorder=_SWAPPED, tile=(16, 16)),
    "ome-tiff, deflate": partial(ome, compression="zlib"),
    "ome-tiff, bigtiff": partial(ome, bigtiff=True),
    "ome-tiff, planes in reverse": reverse,
    "ome-tiff, a thumbnail first": thumbnail,
    "ome-tiff, a thumbnail last": partial(thumbnail, last=True),
    "ome-tiff, a pyramid": pyramid,
    "ome-tiff of several files": set_of_ome,
    "ome-zarr 0.4": ome_zarr,
    "ome-zarr 0.4 of five axes": partial(ome_zarr, axes="tczyx"),
    "ome-zarr 0.4, not compressed": partial(ome_zarr, compressors=None),
    "ome-zarr 0.5": partial(ome_zarr, version=3),
    "ome-zarr 0.5, not compressed": partial(ome_zarr, version=3, compressors=None),
}
"""Containers that state the sizes of voxels."""

BARE: dict[str, Writer] = {
    "tiff": tiff,
    "tiff with its shape by tifffile": partial(tiff, metadata={}),
    "tiff, planes as colours of one page": partial(tiff, photometric="rgb", planarconfig="separate"),
    "tiff, deflate": partial(tiff, compression="zlib"),
    "tiff, deflate and a predictor": partial(pillow, compression="tiff_adobe_deflate"),
    "tiff, lzw": partial(pillow, compression="tiff_lzw"),
    "tiff, packbits": partial(pillow, compression="packbits"),
    "tiff, big-endian": partial(tiff, byteorder=_SWAPPED),
    "tiff, big-endian deflate": partial(tiff, byteorder=_SWAPPED, compression="zlib"),
    "tiff, bigtiff": partial(tiff, bigtiff=True),
    "tiff, tiled": partial(tiff, tile=(16, 16)),
    "tiff, strips of three rows": partial(tiff, rowsperstrip=3),
    "tiff, upper-case suffix": partial(tiff, name="A B µ.TIFF"),
    "tiff, smaller pages between": reduced,
    "tiff of float32": partial(tiff, dtype="f4"),
    "tiff of float64": partial(tiff, dtype="f8"),
    "tiff of int32": partial(tiff, dtype="i4"),
    "tiff of int16": partial(tiff, dtype="i2"),
    "tiff of uint32": partial(tiff, dtype="u4"),
    "tiff in colour": colours,
    "tiff.gz": partial(packed, write=tiff, compress=gzip.compress, more=".gz"),
    "tiffs": partial(each, write=_page, suffix=".tif"),
    "ome-tiff of several files, all named": partial(set_of_ome, all_named=True),
    "pngs": partial(each, write=_png, suffix=".png"),
    "npy": npy,
    "npy, Fortran order": partial(npy, order="F"),
    "npy, big-endian": partial(npy, dtype=">u2"),
    "npy of float32": partial(npy, dtype="<f4"),
    "npy of int32": partial(npy, dtype="<i4"),
    "npy of uint64": partial(npy, dtype="<u8"),
    "npy of five axes": lambda values, folder: npy(values[None, None], folder),
    "npys": partial(each, write=lambda plane, path: np.save(path, plane), suffix=".npy"),
    "npz": npz,
    "hdf5": hdf5,
    "fits": cube,
    "fits, upper-case suffix": partial(cube, name="A.FIT"),
    "fits of float32": partial(cube, dtype="f4"),
    "fits of int32": partial(cube, dtype="i4"),
    "fits, scaled": scaled,
    "fits.gz": partial(cube, name="a.fits.gz"),
    "fits.bz2": partial(packed, write=cube, compress=bz2.compress, more=".bz2"),
    "fits, SCI after ERR": extensions,
    "fits, an odd card": odd_card,
    "fits, tiles compressed": rice,
    "fits, an extension each": extension_each,
    "fitses": partial(each, write=_image, suffix=".fits"),
}
"""Containers that do not."""

ALL = STATED | BARE


def raster(
    values: np.ndarray, folder: Path, name: str = "photo.png", mode: str | None = None, **options: Any
) -> list[str]:
    """Write a picture of 8 bits by Pillow."""
    path, words = _one(folder, name)
    image = Image.fromarray(values)
    (image if mode is None else image.convert(mode)).save(path, **options)
    return words


def palette(values: np.ndarray, folder: Path) -> list[str]:
    """Write a PNG with a palette of the colours that there are."""
    path, words = _one(folder, "photo.png")
    grey = values.ndim == 2
    found, places = np.unique(values.reshape(-1, 1 if grey else 3), axis=0, return_inverse=True)
    image = Image.fromarray(places.reshape(values.shape[:2]).astype(np.uint8), mode="P")
    image.putpalette(np.broadcast_to(found, (len(found), 3)).astype(np.uint8).tobytes())
    image.save(path)
    return words


def turned(values: np.ndarray, folder: Path, name: str) -> list[str]:
    """Write a picture that lies on its side, as its EXIF says."""
    path, words = _one(folder, name)
    tags = Image.Exif()
    tags[0x0112] = 6  # the stored rows run from the right
    Image.fromarray(np.ascontiguousarray(np.rot90(values))).save(path, exif=tags)
    return words


def deep_png(values: np.ndarray, folder: Path) -> list[str]:
    """Write a PNG of 16 bits, by hand, for Pillow writes those of grey alone."""
    path, words = _one(folder, "photo.png")
    deep = (257 * values.astype(np.uint16)).astype(">u2")
    height, width = values.shape[:2]
    rows = deep.reshape(height, -1).view(np.uint8)
    lines = np.hstack([np.zeros((height, 1), np.uint8), rows]).tobytes()
    kind = 0 if values.ndim == 2 else 2
    parts = [(b"IHDR", struct.pack(">IIBBBBB", width, height, 16, kind, 0, 0, 0)), (b"IDAT", zlib.compress(lines))]
    chunks = [
        struct.pack(">I", len(d)) + n + d + struct.pack(">I", zlib.crc32(n + d)) for n, d in [*parts, (b"IEND", b"")]
    ]
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + b"".join(chunks))
    return words


def light(values: np.ndarray) -> np.ndarray:
    """Return the linear light of sRGB of 8 bits, by IEC 61966-2-1."""
    share = values / 255.0
    return np.where(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055) ** 2.4)


def photo_tiff(values: np.ndarray, folder: Path, **options: Any) -> list[str]:
    """Write a picture as TIFF by tifffile."""
    path, words = _one(folder, "photo.tif")
    told = {"photometric": "rgb" if values.shape[-1] == 3 or values.shape[0] == 3 else "minisblack", "metadata": None}
    tifffile.imwrite(path, values, **told | options)
    return words


def planar(values: np.ndarray, folder: Path) -> list[str]:
    """Write a TIFF with a plane for each colour."""
    return photo_tiff(np.moveaxis(values, 2, 0), folder, planarconfig="separate")


def opaque(values: np.ndarray, folder: Path, name: str) -> list[str]:
    """Write a picture with an alpha that hides nothing."""
    return raster(values, folder, name, mode="LA" if values.ndim == 2 else "RGBA")


def exr(values: np.ndarray, folder: Path, name: str, *channels: str) -> list[str]:
    """Write EXR of float32, by OpenEXR."""
    path, words = _one(folder, name)
    parts = values.astype(np.float32).reshape(*values.shape[:2], -1)
    made = {
        channel: np.ascontiguousarray(parts[..., min(k, parts.shape[2] - 1)]) for k, channel in enumerate(channels)
    }
    OpenEXR.File({"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}, made).write(str(path))
    return words


PHOTOS: dict[str, Writer] = {
    "png": raster,
    "png, upper-case suffix": partial(raster, name="PHOTO µ.PNG"),
    "png without a suffix": partial(raster, name="photo", format="png"),
    "png, a palette": palette,
    "png, opaque": partial(opaque, name="photo.png"),
    "png of 16 bits": deep_png,
    "png on its side": partial(turned, name="photo.png"),
    "tiff": photo_tiff,
    "tiff, deflate": partial(photo_tiff, compression="zlib"),
    "tiff, lzw": partial(raster, name="photo.tif", compression="tiff_lzw"),
    "tiff, packbits": partial(raster, name="photo.tif", compression="packbits"),
    "tiff, big-endian": partial(photo_tiff, byteorder=_SWAPPED),
    "tiff, bigtiff": partial(photo_tiff, bigtiff=True),
    "tiff, tiled": partial(photo_tiff, tile=(16, 16)),
    "tiff, strips of three rows": partial(photo_tiff, rowsperstrip=3),
    "tiff on its side": partial(turned, name="photo.tif"),
    "tiff, opaque": partial(opaque, name="photo.tif"),
    "tiff of 16 bits": lambda values, folder: photo_tiff(257 * values.astype(np.uint16), folder),
    "tiff of 16 bits, big-endian deflate": lambda values, folder: photo_tiff(
        257 * values.astype(np.uint16), folder, byteorder=_SWAPPED, compression="zlib"
    ),
    "tiff of light in float32": lambda values, folder: photo_tiff(light(values).astype(np.float32), folder),
    "tiff of light in float64": lambda values, folder: photo_tiff(light(values), folder),
    "tiff of sRGB in float32": lambda values, folder: [
        *photo_tiff((values / 255.0).astype(np.float32), folder), "--encoding", "srgb"
    ],
    "tiff of int32": lambda values, folder: photo_tiff(values.astype(np.int32), folder),
    "tiff of two pages": lambda values, folder: photo_tiff(np.stack([values, values]), folder),
    "bmp": partial(raster, name="photo.bmp"),
    "gif": partial(raster, name="photo.gif"),
    "npy": lambda values, folder: _written(np.save, folder / "photo.npy", values),
    "fits": lambda values, folder: each(values[None], folder, _image, ".fits"),
}  # fmt: skip
"""Photographs, of 8 bits in sRGB where their names say nothing else; the words may end in options."""

COLOUR: dict[str, Writer] = PHOTOS | {
    "tiff, a plane for each colour": planar,
    "exr of light": lambda values, folder: exr(light(values), folder, "photo.exr", "R", "G", "B"),
}

GREY: dict[str, Writer] = PHOTOS | {
    "png in colour": partial(raster, mode="RGB"),
    "tiff in colour": partial(raster, name="photo.tif", mode="RGB"),
    "exr of light": lambda values, folder: exr(light(values), folder, "photo.exr", "Y"),
    "exr of light, in colour": lambda values, folder: exr(light(values), folder, "photo.exr", "R", "G", "B"),
    "tiff, white at 0": lambda values, folder: photo_tiff(255 - values, folder, photometric="miniswhite"),
}


def pfm(values: np.ndarray, folder: Path, order: str = "<", kind: str = "Pf") -> list[str]:
    """Write PFM, by hand: rows from below, and a sign that tells the order of bytes."""
    path, words = _one(folder, "depth.pfm")
    stored = values if kind == "Pf" else np.repeat(values[..., None], 3, axis=2)
    head = f"{kind}\n{values.shape[1]} {values.shape[0]}\n{'-' if order == '<' else ''}1.0\n"
    path.write_bytes(head.encode() + stored[::-1].astype(f"{order}f4").tobytes())
    return words


def _millimetres(values: np.ndarray, dtype: str) -> np.ndarray:
    return np.round(1e3 * values).astype(dtype)


_MM = ["--depth-scale", "0.001"]


def _depth_npy(values: np.ndarray, folder: Path, dtype: str = "<f8", order: str = "C") -> list[str]:
    return _written(np.save, folder / "depth.npy", np.asarray(values.astype(dtype), order=order))


def _depth_tiff(values: np.ndarray, folder: Path, **options: Any) -> list[str]:
    path, words = _one(folder, "depth.tif")
    tifffile.imwrite(path, values, **_GREY | options)
    return words


def _of_type(dtype: str, **options: Any) -> Writer:
    return lambda values, folder: _depth_tiff(values.astype(dtype), folder, **options)


def _levels(dtype: str, **options: Any) -> Writer:
    return lambda values, folder: [*_depth_tiff(_millimetres(values, dtype), folder, **options), *_MM]


DEPTHS: dict[str, Writer] = {
    "npy": _depth_npy,
    "npy, Fortran order": partial(_depth_npy, order="F"),
    "npy, big-endian": partial(_depth_npy, dtype=">f8"),
    "npy of float32": partial(_depth_npy, dtype="<f4"),
    "npy of float16": partial(_depth_npy, dtype="<f2"),
    "npy in mm": lambda values, folder: [*_depth_npy(_millimetres(values, "<u2"), folder), *_MM],
    "npy in mm, big-endian": lambda values, folder: [*_depth_npy(_millimetres(values, ">i4"), folder, ">i4"), *_MM],
    "npy of three axes": lambda values, folder: _depth_npy(values[..., None], folder),
    "npz": lambda values, folder: _written(np.savez, folder / "depth.npz", values),
    "pfm": pfm,
    "pfm, big-endian": partial(pfm, order=">"),
    "pfm in colour": partial(pfm, kind="PF"),
    "tiff of float32": _of_type("f4"),
    "tiff of float64": _of_type("f8"),
    "tiff of float32, deflate": _of_type("f4", compression="zlib"),
    "tiff of float32, big-endian tiled": _of_type("f4", byteorder=_SWAPPED, tile=(16, 16)),
    "tiff of float32, lzw": lambda values, folder: raster(
        values.astype(np.float32), folder, "depth.tif", compression="tiff_lzw"
    ),
    "tiff of float16": _of_type("f2"),
    "tiff in mm": _levels("u2"),
    "tiff in mm, deflate": _levels("u2", compression="zlib"),
    "tiff in mm, lzw": lambda values, folder: [
        *raster(_millimetres(values, "u2"), folder, "depth.tif", compression="tiff_lzw"), *_MM
    ],
    "tiff in mm, big-endian": _levels("u2", byteorder=_SWAPPED),
    "tiff in mm of int32": _levels("i4"),
    "tiff in mm without a scale": lambda values, folder: _depth_tiff(_millimetres(values, "u2"), folder),
    "png in mm": lambda values, folder: [*raster(_millimetres(values, "u2"), folder, "depth.png"), *_MM],
    "png in colour": lambda values, folder: [
        *raster((100 * values).astype(np.uint8), folder, "depth.png", mode="RGB"), "--depth-scale", "0.01"
    ],
    "png on its side": lambda values, folder: [
        *turned((100 * values).astype(np.uint8), folder, "depth.png"), "--depth-scale", "0.01"
    ],
    "exr, Z": lambda values, folder: exr(values, folder, "depth.exr", "Z"),
    "exr, Y": lambda values, folder: exr(values, folder, "depth.exr", "Y"),
    "exr in colour": lambda values, folder: exr(values, folder, "depth.exr", "R", "G", "B"),
    "fits": lambda values, folder: each(values[None], folder, _image, ".fits"),
}  # fmt: skip
"""Depth maps, in metres where their names say nothing else, of distances that are whole multiples of 0.25 m."""
