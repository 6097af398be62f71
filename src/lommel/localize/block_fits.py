"""Search and fits of the blocks of a movie, in this process or by workers, and results that are kept meanwhile.

The fits of a block depend on its frames and on the state after the blocks before it: the assumed saturation, and
whether backgrounds are tilted. Workers begin blocks with the state at hand, and those that it has changed are fitted
again.
"""

from __future__ import annotations

import io
import json
import math
from collections.abc import Callable, Generator, Iterable, Iterator
from contextlib import closing, contextmanager
from dataclasses import dataclass, fields, replace
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from lommel.base import atomic
from lommel.base.arrays import Json, Values
from lommel.base.atomic import Unfinished, checksum
from lommel.base.executors import Shared, Workers
from lommel.base.optional import version
from lommel.detection.molecules import Spots, box_pixels, find, frame_counts
from lommel.fit.findings import Finding
from lommel.localize.checks import FirstFrames, with_images
from lommel.localize.fitting import MoleculeErrors, Molecules, fit
from lommel.localize.table import Table
from lommel.recorded.frames import block_size
from lommel.recorded.movie_parts import Part, parts_of
from lommel.recorded.noise import Noise


@dataclass
class State:
    """Smallest value of saturated pixels, None if it is not known, and background of the boxes."""

    saturation: float | None
    background: str

    def is_of(self, fitted: Fitted) -> bool:
        """Return True if a block was fitted with this state, or to the same result."""
        saturation, background = fitted.given
        return background == self.background and self.saturation in (saturation, fitted.saturation)


class Fitted(NamedTuple):
    """Spots and fits of a block of frames.

    Attributes
    ----------
    frames : int
        Number of frames.
    given : tuple
        Saturation and background that were given.
    saturation, is_assumed : float, bool
        Smallest value of saturated pixels, and whether it was assumed.
    first : FirstFrames or None
        Findings on the frames, only of the first block.
    checksum : int
        Checksum of the frames.
    kept : ndarray of int or None
        Indices of the spots whose images `spots` has; None for all.
    """

    frames: int
    spots: Spots
    molecules: Molecules
    given: tuple[float | None, str]
    saturation: float
    is_assumed: bool
    first: FirstFrames | None
    checksum: int = 0
    kept: NDArray[np.intp] | None = None

    def reduced(self, table: Table) -> Self:
        """Return the fits with the images that checks need."""
        kept = with_images(self.spots, self.molecules, table)
        return self._replace(spots=replace(self.spots, images=self.spots.images[kept]), kept=kept)

    def restored(self) -> Self:
        """Return the fits with 0 in place of the images that checks do not need."""
        images = np.zeros((len(self.spots), *self.spots.images.shape[1:]), self.spots.images.dtype)
        images[self.kept] = self.spots.images
        return self._replace(spots=replace(self.spots, images=images), kept=None)

    def to_bytes(self) -> bytes:
        """Return the contents of a file."""
        arrays: dict[str, Any] = {}
        facts: Json = {}
        for prefix, part in (("spots_", self.spots), ("", self.molecules), ("errors_", self.molecules.errors)):
            for name in (field.name for field in fields(part)):
                value = getattr(part, name)
                if isinstance(value, np.ndarray):
                    arrays[prefix + name] = value
                elif not isinstance(value, MoleculeErrors):
                    facts[prefix + name] = value
        for name in ("frames", "given", "saturation", "is_assumed", "checksum"):
            facts[name] = getattr(self, name)
        if self.first is not None:
            found = [[one.code, one.severity, one.text, dict(one.numbers)] for one in self.first.findings]
            facts["first"] = [self.first.steady, found]
        return atomic.contents(np.savez, **arrays, kept=self.kept, facts=np.array(json.dumps(facts)))

    @classmethod
    def from_bytes(cls, data: bytes) -> Self:
        """Return the fits of the contents of a file."""
        with np.load(io.BytesIO(data), allow_pickle=False) as file:
            arrays: dict[str, Any] = dict(file)
        facts: Json = json.loads(str(arrays.pop("facts")))

        def part(kind: Any, prefix: str, **more: Any) -> Any:
            names = [field.name for field in fields(kind) if field.name not in more]
            return kind(
                **more, **{n: arrays[prefix + n] if prefix + n in arrays else facts[prefix + n] for n in names}
            )

        first = facts.get("first")
        return cls(
            facts["frames"],
            part(Spots, "spots_"),
            part(Molecules, "", errors=part(MoleculeErrors, "errors_")),
            (facts["given"][0], facts["given"][1]),
            facts["saturation"],
            facts["is_assumed"],
            None if first is None else FirstFrames(first[0], tuple(Finding(*one) for one in first[1])),
            facts["checksum"],
            arrays["kept"],
        )


class BlockFits:
    """Function that searches and fits a block of frames, on one thread of a worker or on all of this process."""

    def __init__(self, table: Table, noise: Noise, width: float, threads: int | None) -> None:
        self._arguments = table, noise, width, threads
        self.table, self.noise = table, noise
        self.search = partial(find, box=table.shape, noise=noise, width=width, threads=threads)
        # `Counts.marked` replaces saturated pixels by NaN: fits need no test of saturation.
        self.fit_boxes = partial(fit, noise=noise, saturation=math.inf, threads=threads)
        self._last: tuple[Any, ...] | None = None

    def __reduce__(self) -> tuple[type[BlockFits], tuple[Any, ...]]:
        return BlockFits, self._arguments

    def __call__(self, frames: Values, first: int, mask: Any, saturation: float | None, background: str) -> Fitted:
        """Return the spots and fits of frames, of which the first has the number `first`."""
        found, self._last = self._last, None
        if found is None or found[0] != (first, saturation):
            counts = frame_counts(frames, self.table.shape, saturation=saturation, mask=mask)
            checked = None if first else FirstFrames.of(counts, self.noise, self.search)
            found = (first, saturation), counts, checked, self.search(counts, first=first)
        _, counts, checked, spots = found
        if (
            self._arguments[-1] is None
        ):  # a block whose background is tilted is fitted again; workers have other movies
            self._last = found
        fit_boxes = partial(self.fit_boxes, self.table, background=background)
        molecules = _recentred(counts.marked(), spots, first, self.table, fit_boxes)
        limit, given = counts.saturation, (saturation, background)
        return Fitted(len(frames), spots, molecules, given, limit, bool(counts.assumed), checked)

    def of_part(
        self,
        part: Part,
        blocks: list[slice],
        mask: Any,
        saturation: float | None,
        background: str,
        known: dict[int, int] | None,
    ) -> Iterator[Fitted | None]:
        """Yield the fits of each block of a part of a movie, None if the checksum of its frames is in `known`.

        Without `known` checksums are 0.
        """
        images = part.read()
        for block in blocks:
            within = slice(block.start - part.first, block.stop - part.first)
            frames, checksum = images[within], 0
            if known is not None:
                hidden = {"mask": np.ma.getmaskarray(frames)} if np.ma.isMaskedArray(frames) else {}
                checksum = atomic.crc32({}, {"frames": np.asarray(frames), **hidden})
                if known.get(block.start) == checksum:
                    yield None
                    continue
            hidden_part = mask if np.ndim(mask) < 3 else mask[within]
            fitted = self(frames, block.start, hidden_part, saturation, background)
            yield fitted._replace(checksum=checksum)


def _reduced(
    shared: Shared[tuple[BlockFits, Any]], part: Part, blocks: list[slice], mask: Any, *state: Any
) -> Iterable[Fitted | None]:
    """Return the fits of the blocks of a part, with the images that checks need; a mask of the frame is shared."""
    fits, of_frame = shared.value
    found = fits.of_part(part, blocks, of_frame if mask is None else mask, *state)
    return [None if fitted is None else fitted.reduced(fits.table) for fitted in found]


@contextmanager
def kept_results(
    path: Path | None, images: Any, size: int | None, fits: BlockFits, mask: Any
) -> Iterator[Unfinished | None]:
    """Yield the folder of results that are kept beside a path, None without one; it is removed at the end."""
    if path is None:
        yield None
        return
    noise, table = fits.noise, fits.table
    maps = {
        name: np.asarray(getattr(noise, name))
        for name in ("white", "read", "offset")
        if getattr(noise, name) is not None
    }
    arrays = maps | {"table": table._parts["coefficients"], "mask": np.asarray(False if mask is None else mask)}
    request = {
        "software": f"lommel {version()}",
        "shape": list(images.shape),
        "block": block_size(images.shape, size),
        "fits": checksum({"excess": noise.excess, "limits": table.limits.tolist(), "pixel": table.pixel}, arrays),
    }
    with atomic.unfinished_folder(path, request, Path.mkdir) as unfinished:
        yield unfinished
        unfinished.remove()


class MovieBlocks:
    """Fits of the blocks of a movie by the workers of a client, or in this process.

    Parameters
    ----------
    images : Frames or array
    mask : ndarray or None
        Pixels to ignore, of the frame or of each frame.
    size : int or None
        Number of frames of a block.
    fits : BlockFits
    state : State
        State with which the next blocks are begun.
    client
    unfinished : Unfinished or None
        Folder of results that are kept.
    """

    def __init__(
        self,
        images: Any,
        mask: Any,
        size: int | None,
        fits: BlockFits,
        state: State,
        client: Any,
        unfinished: Unfinished | None,
    ) -> None:
        self._images, self._mask, self._size, self._fits, self._state = images, mask, size, fits, state
        self._workers, self._shared = (
            None if client is None else Workers.of(client),
            Shared((fits, mask if np.ndim(mask) < 3 else None)),
        )
        self._unfinished = unfinished

    @property
    def kept(self) -> int:
        """Number of frames of which results are kept."""
        if self._unfinished is None:
            return 0
        size, total = block_size(self._images.shape, self._size), self._images.shape[0]
        starts = {int(path.name.partition(" ")[0]) for path in self._unfinished.new.glob("[0-9]* *.npz")}
        return sum(min(size, total - start) for start in starts)

    def fitted(self, first: int) -> Generator[Fitted]:
        """Yield the fits of the blocks from the frame `first` on, with all images that checks need."""
        results: Generator[tuple[tuple[Any, ...], Iterable[Fitted | None]]]
        if self._workers is None:
            results = ((task, self._fits.of_part(*task)) for task in self._tasks(first))
        else:
            results = self._workers.run(_reduced, self._tasks(first), ordered=True, shared=self._shared)
        with closing(results):
            for task, found in results:
                *_, blocks, _, saturation, background, _ = task
                for block, fitted in zip(blocks, found, strict=True):
                    name = f"{block.start} {saturation} {background}"
                    if fitted is None:
                        if (fitted := self._kept(name)) is None:
                            raise ValueError(
                                f"what was kept of the frames from {block.start} on changed: repeat the call"
                            )
                    elif self._unfinished is not None:
                        fitted = self._keep(name, fitted)
                    yield fitted if fitted.kept is None else fitted.restored()

    def _tasks(self, first: int) -> Iterator[tuple[Any, ...]]:
        state = self._state
        for part, blocks in parts_of(self._images, self._size):
            if part.last <= first:
                continue
            if part.first < first:  # blocks that were fitted before the state changed
                blocks = [block for block in blocks if block.start >= first]
                part = replace(part, first=first)
            mask = self._mask if self._workers is None else None  # workers have that of the frame
            mask = self._mask[part.first : part.last] if np.ndim(self._mask) == 3 else mask
            known = None
            if self._unfinished is not None:
                names = {block.start: f"{block.start} {state.saturation} {state.background}" for block in blocks}
                kept = {start: self._kept(name) for start, name in names.items()}
                known = {start: fitted.checksum for start, fitted in kept.items() if fitted is not None}
            yield part, blocks, mask, state.saturation, state.background, known

    def _keep(self, name: str, fitted: Fitted) -> Fitted:
        """Write the fits of a block, and return what is read."""
        assert self._unfinished is not None
        fitted = fitted if fitted.kept is not None else fitted.reduced(self._fits.table)
        data = fitted.to_bytes()
        self._unfinished.require_there()
        atomic.write(self._unfinished.new / f"{name}.npz", data)
        self._unfinished.record(name, "", np.frombuffer(data, np.uint8))
        return fitted

    def _kept(self, name: str) -> Fitted | None:
        """Return the fits of a block that were kept, None if there are none, or the file is damaged."""
        assert self._unfinished is not None
        try:
            data = (self._unfinished.new / f"{name}.npz").read_bytes()
        except FileNotFoundError:
            return None
        is_complete = self._unfinished.is_complete(name, "", np.frombuffer(data, np.uint8))
        return Fitted.from_bytes(data) if is_complete else None


_MAX_MOVES = 3  # largest number of times that a box is moved


def _recentred(
    frames: Values, spots: Spots, first_frame: int, table: Table, fit_boxes: Callable[..., Molecules]
) -> Molecules:
    """Fit the boxes of spots; fit molecules that are off-centre, for example due to coma, again in centred boxes.

    `frames` (frames, rows, columns) begin at frame `first_frame` of the movie.
    """

    def boxes(frame: NDArray[np.int64], corner: NDArray[np.int64]) -> Values:
        return np.asarray(frames[frame[:, None, None], *box_pixels(corner, table.shape)])

    frame, corners = spots.frame - first_frame, spots.corners
    molecules = fit_boxes(boxes(frame, corners), corners=corners)
    last_corner, middle = np.array(frames.shape[1:]) - table.shape, np.array(table.shape) // 2
    indices = np.arange(len(frame))  # molecules whose boxes were moved in the last round
    for _ in range(_MAX_MOVES):
        positions = np.stack([molecules.row[indices], molecules.column[indices]], axis=1)
        new_corners = np.clip(np.round(positions).astype(np.int64) - middle, 0, last_corner)
        off_centre = (new_corners != corners[indices]).any(axis=1)
        indices, new_corners = indices[off_centre], new_corners[off_centre]
        if not indices.size:
            break
        refitted = fit_boxes(boxes(frame[indices], new_corners), corners=new_corners)
        # The old fit is kept if it converged and the new fit did not.
        replace_fit = refitted.converged | ~molecules.converged[indices]
        indices, new_corners = indices[replace_fit], new_corners[replace_fit]
        molecules, corners[indices] = molecules.replaced(indices, refitted[replace_fit]), new_corners
    return molecules
