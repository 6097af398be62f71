"""Alignment of frames that differ by a shift, a rotation and a scale: of a hand-held camera, of focus breathing."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import scipy
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Values, plain
from lommel.imaging.frame_phases import motion

_STEPS = 12  # largest number of steps
# Step after which none follows, rms over the frame: pixels, by phases also a share of the standard error.
_SETTLED, _COARSE, _SETTLED_SHARE = 0.005, 0.1, 0.3
_MAX_COARSE = 1.0  # pixels, rms: largest standard error by phases, which larger differences of blur leave
_BLUR = 4.0  # pixels: blur radius of the standard errors by phases
_MAX_ERROR, _MIN_OVERLAP = 0.25, 0.5  # pixels, rms, and share of the frame: beyond them frames are refused
_WINDOW = 96  # pixels: least side of the windows, of which a side has two or three, after one of the whole frame
# Gaussian blurs, pixels rms, that make frames alike, of both before, and of the local means of differences; pixels of
# a frame above which averages are compared; parts per side that count as independent.
_WIDTHS = (0.0, 0.5, 0.7, 1.0, 1.4, 2.0, 2.8, 4.0, 5.6)
_SMOOTH, _LOCAL, _PIXELS, _PARTS = 1.0, 6.0, 1e6, 4
_MISFIT = 0.15  # pixels, rms: displacements of parts of a frame that are told


@dataclass(frozen=True, eq=False, repr=False)
class Aligned:
    """Frames in the place of the first one, and how they were moved: of :func:`~lommel.imaging.align`.

    Attributes
    ----------
    frames : tuple of ndarray
        Frames, resampled by quintic splines where they were moved, cropped to what all of them show.
    crop : tuple of slice
        Rows and columns of the first frame that are left.
    shifts : ndarray, shape (n, 2)
        Shift of each frame down and to the right, relative to the first, pixels, at the middle of the frame.
    scales, angles : ndarray, shape (n,)
        Magnification relative to the first frame, and rotation from x to y, radians.
    errors : ndarray, shape (n,)
        Standard error of the displacement, pixels, rms over the frame.
    misfits : ndarray, shape (n,)
        Difference of the displacements of parts of the frame from these, pixels, rms: noise, parallax, motion.
    """

    frames: tuple[Values, ...]
    crop: tuple[slice, slice]
    shifts: Array
    scales: Array
    angles: Array
    errors: Array
    misfits: Array

    def __repr__(self) -> str:
        return f"<Aligned: {len(self.frames)} frames, to {max(self.errors):.2g} pixels>"

    @property
    def notes(self) -> tuple[str, ...]:
        """Sentences on parts of frames that moved otherwise than the whole."""
        return tuple(
            f"Parts of frame {k} moved otherwise than all of it, by {misfit:.2g} pixels rms: parallax of a camera "
            "that moved, or motion of the scene."
            for k, misfit in enumerate(self.misfits)
            if misfit > _MISFIT
        )

    @property
    def reliable(self) -> bool:
        """Whether all parts of the frames moved alike: there are no notes."""
        return not self.notes

    def to_dict(self) -> dict[str, Any]:
        """Return all but the frames in plain types, for JSON."""
        facts = {name: getattr(self, name).tolist() for name in ("shifts", "scales", "angles", "errors", "misfits")}
        crop = [[side.start, side.stop] for side in self.crop]
        return dict(plain(facts | {"crop": crop, "notes": list(self.notes), "reliable": self.reliable}))


def align(frames: Sequence[ArrayLike] | Values) -> Aligned:
    """Move frames of one scene to the place of the first, by a shift, a rotation and a scale.

    Displacements of parts of the frames follow from the phases of their cross-spectra, which symmetric blur leaves.
    Then the frames are compared by least squares, after the sharper one is blurred, pixel by pixel, until they are
    alike: they may be focused differently, by up to 11 pixels of blur radius, more in frames above a megapixel.

    Parameters
    ----------
    frames : sequence of array_like, each of the shape (height, width) or (height, width, 3)
        Two frames or more of one shape, best of linear light; NaN and masked pixels are refused.

    Returns
    -------
    Aligned

    Raises
    ------
    TypeError, ValueError
        If the frames are not of one shape of at least 192 pixels a side; if a displacement is uncertain by more than
        0.25 pixels or does not settle (other scenes, no texture), or a frame shows less than half of the first.

    Examples
    --------
    >>> import numpy as np
    >>> from scipy.ndimage import gaussian_filter
    >>> rng = np.random.default_rng(0)
    >>> scene = gaussian_filter(rng.normal(size=(208, 260)), 1.5)
    >>> found = align([scene[4:-4, 4:-4], scene[6:-2, 1:-7]])
    >>> np.round(found.shifts[1], 1).tolist()
    [-2.0, 3.0]
    """
    arrays = [validation.array(f"frames[{k}]", frame, "counts") for k, frame in enumerate(frames)]
    if len(arrays) < 2 or len({one.shape for one in arrays}) > 1 or arrays[0].ndim not in (2, 3):
        raise ValueError(f"frames must be two or more of one shape, got {[one.shape for one in arrays]}")
    shape = arrays[0].shape[:2]
    if min(shape) < 2 * _WINDOW:
        raise ValueError(f"frames must have at least {2 * _WINDOW} pixels a side, got {shape}")
    grey = [one.mean(axis=2) if one.ndim == 3 else one.astype(np.float64) for one in arrays]
    for k, one in enumerate(grey):
        if not np.isfinite(one).all():
            raise ValueError(f"frames[{k}] must be finite")
    moves, errors, misfits = [(0j, 1.0 + 0j)], [0.0], [0.0]
    for k in range(1, len(grey)):
        move, error, misfit = _found(grey[0], grey[k], f"frames[{k}]")
        moves, errors, misfits = [*moves, move], [*errors, error], [*misfits, misfit]
    inside = np.all([_places(shape, move)[1] for move in moves], axis=0)
    crop = _crop(inside)
    aligned = [
        one[crop] if k == 0 else _moved(one, moves[k])[crop].astype(np.result_type(one, np.float32))
        for k, one in enumerate(arrays)
    ]
    shifts = np.array([[move.imag, move.real] for move, _ in moves])
    scales, angles = (np.array([function(turn) for _, turn in moves]) for function in (abs, cmath.phase))
    return Aligned(tuple(aligned), crop, shifts, scales, angles, np.array(errors), np.array(misfits))


_Move = tuple[complex, complex]  # shift x + iy at the middle, and scale * exp(i angle)


def _found(first: Array, other: Array, name: str) -> tuple[_Move, float, float]:
    """Return the move of a frame relative to the first, its standard error and its misfit, pixels, rms."""
    shape, radius = first.shape, math.hypot(*first.shape) / math.sqrt(12.0)
    shift, turn, error = 0j, 1.0 + 0j, math.inf
    splines = scipy.ndimage.spline_filter(other, order=3, mode="mirror")
    for parts in (1, *[min(3, min(shape) // _WINDOW)] * _STEPS):
        places, inside = _places(shape, (shift, turn))
        if inside.mean() < _MIN_OVERLAP:
            break
        moved = scipy.ndimage.map_coordinates(splines, places, order=3, mode="mirror", prefilter=False)
        step, covariance, _ = motion(first, moved, inside, _BLUR, parts)
        if parts == 1:
            shift += complex(step[1], step[0])
            continue
        error = math.sqrt(np.diag(covariance) @ [1.0, 1.0, radius**2, radius**2])
        shift, turn = shift + turn * complex(step[1], step[0]), turn * cmath.exp(complex(step[2], step[3]))
        if math.hypot(step[0], step[1], radius * step[2], radius * step[3]) < max(_COARSE, _SETTLED_SHARE * error):
            break
    else:
        raise ValueError(f"{name} cannot be aligned with the first frame: no displacement fits all parts of it")
    if inside.mean() < _MIN_OVERLAP:
        raise ValueError(f"{name} shows {100.0 * inside.mean():.0f} % of the first frame, at least half is needed")
    move, misfit = (shift, turn), math.inf
    if error < _MAX_COARSE:
        move, error, misfit = _refined(first, other, move, name)
    if error > _MAX_ERROR:
        raise ValueError(
            f"{name} cannot be aligned with the first frame: its displacement is uncertain by {error:.2g} pixels"
        )
    return move, error, misfit


def _refined(first: Array, other: Array, move: _Move, name: str) -> tuple[_Move, float, float]:
    """Return a move after which frames that are blurred alike differ least, its standard error and its misfit.

    Squares of differences are weighted by the inverse of their local mean, and parts of the frame count as
    independent: edges where one blur ends and another begins fit no displacement.
    """
    side = math.ceil(math.sqrt(first.size / _PIXELS))
    # What lies between the middle of the frame and that of averages over side x side pixels.
    between = sum(
        turn * (side * (0.5 * (n // side)) + 0.5 * (side - 1) - 0.5 * n)
        for turn, n in zip((1j, 1.0), first.shape, strict=True)
    )
    first, other = (_averages(one, side) for one in (first, other))
    shift, turn = (move[0] + (move[1] - 1.0) * between) / side, move[1]
    shape, radius = first.shape, math.hypot(*first.shape) / math.sqrt(12.0)
    rows, columns = np.arange(shape[0])[:, None] - 0.5 * shape[0], np.arange(shape[1]) - 0.5 * shape[1]
    starts = [np.linspace(0, n, _PARTS, endpoint=False).astype(int) for n in shape]
    splines = scipy.ndimage.spline_filter(other, order=3, mode="mirror")
    near = scipy.ndimage.gaussian_filter(first, _SMOOTH)
    for _ in range(_STEPS):
        places, inside = _places(shape, (shift, turn))
        moved = scipy.ndimage.map_coordinates(splines, places, order=3, mode="mirror", prefilter=False)
        left, (down, right), square = _alike(near, scipy.ndimage.gaussian_filter(moved, _SMOOTH))
        floor = max(float(np.median(square[inside])), 1e-9 * float(near.var()))
        terms = np.stack([down, right, right * columns + down * rows, down * columns - right * rows])
        weighted = terms * (inside / (square + floor))
        inverse = np.linalg.inv(np.tensordot(weighted, terms, ((1, 2), (1, 2))))
        step = inverse @ np.tensordot(weighted, left, ((1, 2), (0, 1)))
        shift, turn = shift + turn * complex(step[1], step[0]), turn * cmath.exp(complex(step[2], step[3]))
        if math.hypot(step[0], step[1], radius * step[2], radius * step[3]) < _SETTLED:
            break
    else:
        raise ValueError(f"{name} cannot be aligned with the first frame: no displacement fits all parts of it")
    left = left - np.tensordot(step, terms, 1)
    gradients = _sums(weighted * left, starts)
    covariance = inverse @ (gradients @ gradients.T) @ inverse * (_PARTS**2 / (_PARTS**2 - len(step)))
    error = math.sqrt(np.diag(covariance) @ [1.0, 1.0, radius**2, radius**2])
    # Displacements of parts by themselves, weighted by what each of them knows.
    known = _sums(weighted[[0, 0, 1, 1]] * terms[[0, 1, 0, 1]], starts).T.reshape(-1, 2, 2)
    apart = (np.linalg.pinv(known, hermitian=True) @ gradients[:2].T[:, :, None])[:, :, 0]
    weights = np.trace(known, axis1=1, axis2=2)
    misfit = math.sqrt(weights @ (apart**2).mean(axis=1) / weights.sum())
    return (side * shift - (turn - 1.0) * between, turn), side * error, side * misfit


def _averages(frame: Array, side: int) -> Array:
    """Return averages over side x side pixels."""
    height, width = (n // side for n in frame.shape)
    return np.asarray(frame[: height * side, : width * side].reshape(height, side, width, side).mean(axis=(1, 3)))


def _sums(values: Array, starts: list[NDArray[np.int_]]) -> Array:
    """Return sums of arrays, (n, height, width), over parts that begin at these rows and columns, (n, parts)."""
    sums = np.add.reduceat(np.add.reduceat(values, starts[0], axis=1), starts[1], axis=2)
    return np.asarray(sums.reshape(len(values), -1))


def _alike(first: Array, other: Array) -> tuple[Array, tuple[Array, Array], Array]:
    """Return the difference of frames where the sharper one is blurred, slopes, and the local mean of its square.

    Each pixel has the Gaussian blur of one of the frames by which the mean is least, and the slopes down and to the
    right of the frame that is blurred, or of the mean of both.
    """
    left, down, right, square = (np.full(first.shape, np.inf) for _ in range(4))
    for width in _WIDTHS:
        for frame, sign, sharp in ((first, 1.0, other), (other, -1.0, first))[: 1 + (width > 0.0)]:
            soft = scipy.ndimage.gaussian_filter(frame, width, truncate=3.0) if width else frame
            difference = sign * (soft - sharp)
            mean = scipy.ndimage.gaussian_filter(difference**2, _LOCAL, truncate=3.0)
            slopes = np.gradient(soft if width else 0.5 * (soft + sharp))
            best = mean < square
            for found, value in zip((left, down, right, square), (difference, *slopes, mean), strict=True):
                np.copyto(found, value, where=best)
    return left, (down, right), square


def _places(shape: tuple[int, ...], move: _Move) -> tuple[Array, NDArray[np.bool_]]:
    """Return places in a moved frame, (2, height, width), of the pixels of the first, and which are inside."""
    shift, turn = move
    rows, columns = np.arange(shape[0]) - 0.5 * shape[0], np.arange(shape[1]) - 0.5 * shape[1]
    where = turn * (columns + 1j * rows[:, None]) + shift + 0.5 * complex(shape[1], shape[0])
    # Splines near the border are those of repeated values.
    inside = (where.imag > 1.0) & (where.imag < shape[0] - 2.0) & (where.real > 1.0) & (where.real < shape[1] - 2.0)
    return np.stack([where.imag, where.real]), inside | (move == (0j, 1.0 + 0j))


def _moved(frame: Values, move: _Move) -> Values:
    """Return a frame, also of channels, in the place of the first one."""
    places = _places(frame.shape[:2], move)[0]
    channels = np.moveaxis(frame.reshape(*frame.shape[:2], -1).astype(np.float64), 2, 0)
    moved = [scipy.ndimage.map_coordinates(one, places, order=5, mode="nearest") for one in channels]
    return np.stack(moved, axis=-1).reshape(frame.shape)


def _crop(inside: NDArray[np.bool_]) -> tuple[slice, slice]:
    """Return rows and columns of a rectangle that is all inside: of a border, the worse side is cut off first."""
    top, bottom, left, right = 0, inside.shape[0], 0, inside.shape[1]
    while bottom - top > 1 and right - left > 1:
        part = inside[top:bottom, left:right]
        outside = [1.0 - edge.mean() for edge in (part[0], part[-1], part[:, 0], part[:, -1])]
        worst = int(np.argmax(outside))
        if outside[worst] == 0.0:
            break
        top, bottom, left, right = (
            top + (worst == 0),
            bottom - (worst == 1),
            left + (worst == 2),
            right - (worst == 3),
        )
    return slice(top, bottom), slice(left, right)
