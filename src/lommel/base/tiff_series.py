"""TIFF files opened by tifffile, whose images are found in a time linear in the number of pages."""

from __future__ import annotations

import logging
import math
import struct
from bisect import bisect_left
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from itertools import product
from operator import index
from pathlib import Path
from typing import IO, NamedTuple

import tifffile
from tifffile.tifffile import shaped_description_metadata

from lommel.base.arrays import Json

Page = tifffile.TiffPage | tifffile.TiffFrame
Series = tifffile.TiffPageSeries
Kind = tuple[str, tuple[int, ...], object]  # axes, shape and type of an image

_MAX_STACKS = 2**11
"""Maximum number of images in a file of tifffile's own format if some have several pages or subpages: comparing all
with all, as tifffile does, takes half a second for so many."""

_COMPRESSION, _DESCRIPTION, _SUBPAGES = 259, 270, 330
_ASCII = 2  # type of texts
_FACTORS: tuple[int, ...] = (2, 3, 4)  # by which a level of a pyramid may be smaller than the last
_PLACES = {273, 324}  # tags with the positions of strips and tiles
_SIZES = {279, 325}  # tags with their sizes
# Tags that decide how a page is decoded, or to which image it belongs: type of page, sides, samples, compression,
# colours, order of bits, orientation, strips, tiles, predictor, subpages, JPEG tables, depth, value of missing parts.
_DECODING = {
    *(254, 255, 256, 257, 258, _COMPRESSION, 262, 266, 274, 277, 278, 284, 317, 322, 323, _SUBPAGES, 338, 339, 347),
    *(32997, 32998, 42113),
}


class File(tifffile.TiffFile):  # type: ignore[misc]  # final in newer versions
    """TIFF file opened by tifffile.

    tifffile compares each image with all others if each page is an image of its own, as in files written frame by
    frame, and each page with all others in files with pages of several kinds. Here pages are compared by the bytes of
    their directories, and images by their shapes in a dictionary; the series are the same.

    Parameters
    ----------
    source : path or binary file
    directories : callable
        ``directories(read, length)`` yields the position and the entries of each page, as
        :func:`lommel.base.reading.tiff_directories`; it raises ValueError where these are damaged.
    afford : callable
        ``afford(pages, frames, length)`` raises ValueError if `pages` of their own kinds and `frames` like others
        would take too much memory for a file of `length` bytes, as :func:`lommel.base.reading.afford_pages`.
    """

    def __init__(
        self,
        source: Path | IO[bytes],
        directories: Callable[[Callable[[int, int], bytes], int], Iterator[tuple[int, bytes]]],
        afford: Callable[[int, int, int], None],
    ) -> None:
        self.directories, self.afford = directories, afford
        super().__init__(source)

    def _series_shaped(self) -> list[Series] | None:
        """Return the images of a file in tifffile's own format, which states the shape of each."""
        directory = _Directory(self)
        stated = directory.shapes()
        if stated is None:
            return super()._series_shaped()
        series = []
        for page, (shape, axes, name, _) in zip(directory.pages(), stated, strict=True):
            series.append(Series([page], shape, page.dtype, axes, name=name, kind="shaped", squeeze=False))
        self.is_uniform = len(series) == 1
        return _without_levels(series, reduced=True)

    def _series_generic(self) -> list[Series] | None:
        """Return the pages and subpages of a file, grouped by what decodes them."""
        groups: dict[int, dict[int, Page]] = {}
        for page in _Directory(self).pages():
            for item in (page, *self._subpages(page)):
                if item.shape:
                    groups.setdefault(item.hash, {}).setdefault(item.offset, item)
        series = []
        for group in groups.values():
            pages = list(group.values())
            shape, axes = (len(pages), *pages[0].shape), "I" + pages[0].axes
            if "S" not in axes:
                shape, axes = (*shape, 1), axes + "S"
            series.append(Series(pages, shape, pages[0].dtype, axes, kind="generic"))
        self.is_uniform = len(series) == 1
        return series if self.is_agilent else _without_levels(series, reduced=False)

    def _subpages(self, page: Page) -> Iterator[tifffile.TiffPage]:
        """Yield the subpages of a page; a damaged one is left out."""
        for k, offset in enumerate(page.subifds or ()):
            if offset >= 8:
                self.filehandle.seek(offset)
                try:
                    subpage = tifffile.TiffPage(self, (page.index, k))
                except Exception as error:  # tifffile raises many types
                    logging.getLogger("tifffile").warning(f"subpage {k} of page {page.index}: {error}")
                else:
                    yield subpage


@dataclass(frozen=True)
class _Layout:
    """Positions of the tags of a page, and masks of the bytes that are equal in pages of one kind."""

    places: dict[int, int]
    masks: tuple[int, int]  # of compressed and of uncompressed pages
    is_plain: bool  # no tag occurs twice


class _Directory:
    """Pages of a file, and their kinds: pages of one kind are decoded alike."""

    def __init__(self, file: File) -> None:
        self._file = file
        self._order, self._big = file.byteorder, file.is_bigtiff
        self._stride, self._inline = (20, 8) if self._big else (12, 4)
        self.kinds = list[int]()  # kind of each page
        self._firsts = list[int]()  # number of the first page of each kind
        self._are_frames = list[bool]()  # whether other pages of the kind need nothing but the places of their data
        self._texts = list[tuple[int, int] | None]()  # length and position of each description
        self._sort()

    def _read(self, offset: int, count: int) -> bytes:
        self._file.filehandle.seek(offset)
        return self._file.filehandle.read(count)

    def _sort(self) -> None:
        """Sort the pages by kind, and find their descriptions."""
        stride, layouts, kinds = self._stride, dict[tuple[bytes, bytes], _Layout](), dict[object, int]()
        for offset, entries in self._file.directories(self._read, self._file.filehandle.size):
            codes = entries[::stride], entries[1::stride]
            if (layout := layouts.get(codes)) is None:
                layout = layouts[codes] = self._layout(entries)
            place = layout.places.get(_COMPRESSION)
            is_plain = place is None or self._number(entries, place) == 1
            key = codes, int.from_bytes(entries) & layout.masks[is_plain]
            if (kind := kinds.setdefault(key, len(kinds))) == len(self._firsts):
                self._firsts.append(len(self.kinds))
                # Of uncompressed pages tifffile expects that several strips follow each other, as in the first page.
                strips = [self._count(entries, layout.places[tag]) for tag in _PLACES if tag in layout.places]
                self._are_frames.append(
                    layout.is_plain and _SUBPAGES not in layout.places and (not is_plain or strips == [1])
                )
            self.kinds.append(kind)
            self._texts.append(self._text_at(offset, entries, layout) if layout.is_plain else None)
        # tifffile uses far more memory for a page of a kind of its own.
        pages = sum(not self._are_frames[kind] for kind in self.kinds)
        self._file.afford(len(kinds) + pages, len(self.kinds), self._file.filehandle.size)

    def _layout(self, entries: bytes) -> _Layout:
        """Return the positions of the tags in the entries of a page, and the masks of the bytes to compare."""
        stride, places, masks = self._stride, dict[int, int](), (bytearray(), bytearray())
        for place in range(0, len(entries), stride):
            (tag,) = struct.unpack_from(f"{self._order}H", entries, place)
            places.setdefault(tag, place)
            for mask, sizes in zip(masks, (set[int](), _SIZES), strict=True):
                if tag in _DECODING | sizes:
                    mask += b"\xff" * stride
                else:
                    # For the places of data their number is compared, for all other tags nothing but the tag itself.
                    compared = stride - self._inline if tag in _PLACES | _SIZES else 2
                    mask += b"\xff" * compared + bytes(stride - compared)
        compressed, plain = map(int.from_bytes, masks)
        return _Layout(places, (compressed, plain), len(places) * stride == len(entries))

    def _number(self, entries: bytes, place: int) -> int:
        """Return the value of a tag of 16 bits."""
        return int(struct.unpack_from(f"{self._order}H", entries, place + self._stride - self._inline)[0])

    def _count(self, entries: bytes, place: int) -> int:
        """Return the number of values of a tag."""
        return int(struct.unpack_from(self._order + ("Q" if self._big else "I"), entries, place + 4)[0])

    def _text_at(self, offset: int, entries: bytes, layout: _Layout) -> tuple[int, int] | None:
        """Return the length and the position of the description of a page."""
        if (place := layout.places.get(_DESCRIPTION)) is None:
            return None
        word = "Q" if self._big else "I"
        _, kind, count, pointer = struct.unpack_from(f"{self._order}HH{word}{word}", entries, place)
        if count <= self._inline:
            pointer = offset + (8 if self._big else 2) + place + self._stride - self._inline
        return (count, pointer) if kind == _ASCII else None

    def pages(self) -> Iterator[Page]:
        """Yield the pages: those that need no tags of their own as frames of the first page of their kind."""
        pages = self._file.pages
        pages.cache = False  # an attempt to read OME metadata may leave unusable frames
        for number, kind in enumerate(self.kinds):
            pages.useframes = self._are_frames[kind]
            if pages.useframes:
                pages.set_keyframe(self._firsts[kind])
            yield pages[number]

    def shapes(self) -> list[Stated] | None:
        """Return what the description of each page states; None unless each states one page, without subpages.

        ValueError if there are too many images of several pages or subpages, or the descriptions overlap.
        """
        firsts = [self._file.pages.get(number, aspage=True) for number in self._firsts]
        found, images, number, is_simple, last = list[Stated](), 0, 0, True, (-1, b"")
        length = 0
        while number < len(self.kinds):
            page, text = firsts[self.kinds[number]], self._texts[number]
            length += text[0] if text else 0
            if length > 2 * self._file.filehandle.size:
                raise ValueError(f"its descriptions claim {length} bytes of a file of {self._file.filehandle.size}")
            key = self.kinds[number], self._read(text[1], text[0]) if text else b""
            if key != last:  # most descriptions are equal
                stated, last = _stated(key[1], page), key
            is_simple &= stated is not None and stated.pages == 1 and not page.subifds
            if stated is not None and is_simple:
                found.append(stated)
            images += 1 + len(page.subifds or ())
            number += max(1, stated.pages) if stated is not None else 1
        if not is_simple and images > _MAX_STACKS:
            raise ValueError(
                f"it holds {images} images, some of several pages; the limit is {_MAX_STACKS}: save them as one stack"
            )
        return found if is_simple else None


class Stated(NamedTuple):
    """Image that a description in tifffile's own format states."""

    shape: tuple[int, ...]
    axes: str
    name: str
    pages: int


def _stated(text: bytes, page: Page) -> Stated | None:
    """Return the image that the description of a page states; None if it needs tifffile's own way."""
    try:
        words = text.rstrip(b"\0").decode("ascii").strip()
        if '"mibi.' in words or not (words.startswith("shape=") or '"shape":' in words):
            return None
        metadata: Json = shaped_description_metadata(words)
        shape, axes = tuple(map(index, metadata["shape"])), metadata.get("axes")
    # Malformed descriptions raise many types.
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        return None
    size, page_size = math.prod(shape), math.prod(page.shape)
    if min(shape, default=0) < 1 or page_size < 1 or size % page_size or "truncated" in metadata:
        return None
    if size == page_size:
        if [side for side in shape if side > 1] != [side for side in page.shape if side > 1]:
            return None
        axes = tifffile.reshape_axes(page.axes, page.shape, shape) if axes is None else axes
        if not isinstance(axes, str) or len(axes) != len(shape):
            return None
    return Stated(shape, axes or "", metadata.get("name", ""), size // page_size)


def _without_levels(series: list[Series], *, reduced: bool) -> list[Series]:
    """Return the series without levels of pyramids, each of which is 2, 3 or 4 times smaller than the last.

    If `reduced`, levels must be marked as such. The same levels as tifffile finds, which tries all pairs.
    """
    kinds: list[Kind] = [(item.axes, item.shape, item.dtype) for item in series]
    places = dict[Kind, list[int]]()  # of the series that can be a level, negative in ascending order
    for place in reversed(range(len(series))):
        if not reduced or series[place].keyframe.is_reduced:
            places.setdefault(kinds[place], []).append(-place)
    levels = set[int]()
    for top, item in enumerate(series if places else ()):
        if top in levels or item.keyframe.is_subifd:
            continue
        last, factors = top, _FACTORS
        while following := [
            (-below[count - 1], factor, kind)
            for factor in factors
            for kind in _smaller(kinds[last], factor)
            if (below := places.get(kind)) and (count := bisect_left(below, -last))
        ]:
            last, factor, kind = min(following, key=lambda level: level[:2])
            factors = (factor,)
            levels.add(last)
            del places[kind][bisect_left(places[kind], -last)]
    return [item for place, item in enumerate(series) if place not in levels]


@lru_cache
def _smaller(kind: Kind, factor: int) -> list[Kind]:
    """Return the kinds of images that are smaller by a factor, rounded down or up along each side."""
    axes, shape, dtype = kind
    spatial = [letter in "XYZxyz" for letter in axes]
    if not any(spatial) or any(side < factor for side, is_side in zip(shape, spatial, strict=True) if is_side):
        return []
    sides = [
        sorted({side // factor, -(-side // factor)}) if is_side else [side]
        for side, is_side in zip(shape, spatial, strict=True)
    ]
    return [(axes, smaller, dtype) for smaller in product(*sides)]
