"""The same data in every array that can hold them: equal answers, and masks that count or are refused."""

from __future__ import annotations

import dataclasses
import io
import re
from collections.abc import Callable
from functools import cache, partial
from pathlib import Path
from typing import Any, NamedTuple

import astropy.units
import dask.array
import h5py
import numpy as np
import pytest
import xarray
import zarr
from astropy.nddata import CCDData, NDData, NDDataArray
from astropy.utils.masked import Masked

import lommel as lm
from lommel import imaging, localize, microscopy
from lommel.detection.targets import find_spots
from lommel.recorded.counts import Counts, counts_of
from objectives import OIL
from planes import NOISE as PHOTOS_NOISE
from planes import PAIR, PIXEL
from small_recordings import DEPTH, NOISES, bead, grey, light_of_pair, movie, sky, stack, stars

ROOT = Path(__file__).resolve().parents[2]
LENS = lm.Lens(focal_length=50e-3, f_number=2.8, focus_distance=2.0, wavelength=550e-9)
FEW = imaging.RichardsonLucy(steps=2, target=0.0)


def retrieve(images: Any) -> np.ndarray:
    found = lm.retrieve(
        images, lm.Pupil(wavelength=550e-9, f_number=4.0), pixel=1.1e-6, noise=NOISES["retrieve"],
        terms=["noll 4", "noll 8"], defocus=[-4.0, 0.0, 4.0],
    )  # fmt: skip
    return np.array([*found.coefficients.values(), found.chi2])


def fit_beads(images: Any) -> np.ndarray:
    found = lm.fit_beads(
        images, lm.Microscope(OIL, 600e-9, 6.5e-6), z=(np.arange(5) - 2) * 250e-9, noise=NOISES["beads"], terms=1,
        priors={},
    )  # fmt: skip
    return np.array([*found.coefficients.values(), found.chi2])


def fit_field(images: Any) -> np.ndarray:
    noise = NOISES["fit-field"]
    found = find_spots(images, noise=noise, window=17, threshold=8.0, width=2.0)
    pupil = lm.Pupil(wavelength=550e-9, f_number=8.0)
    fitted = lm.fit_field(found, pupil, pixel=2.2e-6, degree=0, terms=5, defocus=[-2.5, 0.0, 2.5], blur=0.0)
    return np.array([*np.ravel(found.places), fitted.chi2])


@cache
def table() -> localize.Table:
    made = lm.load_microscope(ROOT / "examples" / "objectives" / "zeiss-63x-astigmatic.toml")
    return localize.Table(dataclasses.replace(made, planes=1).pupil(), 11, made.pixel, z=(-3e-7, 3e-7), reach=1.0)


def localize_movie(frames: Any) -> np.ndarray:
    found = localize.localize_movie(frames, table(), noise=NOISES["localize"]).table
    return np.array([found["x"], found["y"], found["z"], found["photons"]])


def restore_stack(images: Any) -> np.ndarray:
    return microscopy.deconvolve(
        images, OIL, depth=2e-6, wavelength=600e-9, pixel=6.3e-6, step=250e-9, noise=NOISES["deconvolve"],
        direction="up", background=0.0, method=FEW, diagnosis=False,
    ).values  # fmt: skip


@cache
def psfs() -> lm.PSF:
    return lm.psf(OIL.pupil(depth=2e-6, z=(np.arange(5) - 2) * 250e-9, wavelength=600e-9), 15, 6.5e-6)


def deconvolve(images: Any) -> np.ndarray:
    return microscopy.deconvolve(images, psfs(), noise=NOISES["deconvolve"], method=FEW).values


def estimate_noise(images: Any) -> np.ndarray:
    return np.array([microscopy.estimate_noise(images).white])


def depth_from_defocus(photographs: Any) -> np.ndarray:
    return imaging.depth_from_defocus(
        photographs, PAIR, PIXEL, encoding="linear", noise=PHOTOS_NOISE, between=(1.2, 2.0)
    ).depth


def restore(photo: Any, depth: Any = DEPTH) -> np.ndarray:
    noise = lm.Noise(white=5000.0, read=3.0)
    return imaging.restore(photo, depth, LENS, 30e-6, encoding="linear", noise=noise, method=FEW).values


def depth_of_field(image: Any, depth: Any = DEPTH) -> np.ndarray:
    return imaging.depth_of_field(image, depth, LENS, 30e-6, encoding="linear").values


@cache
def photo() -> np.ndarray:
    return (grey() / 255.0) ** 2.2


class Door(NamedTuple):
    """A function, what it takes, and what it is when some of it is wrong, at which places."""

    call: Callable[[Any], np.ndarray]
    values: Callable[[], np.ndarray]
    place: tuple[Any, ...]
    wrong: float = 6e4


SOME = slice(8, 11), slice(9, 12)
DOORS = {
    "lommel.retrieve": Door(retrieve, stars, (1, 14, 13)),
    "lommel.fit_beads": Door(fit_beads, bead, (2, 7, 6), 300.0),
    "lommel.fit_field": Door(fit_field, sky, (1, 18, 18)),
    "localize.localize_movie": Door(localize_movie, movie, (slice(None), 24, 24)),
    # As bright as what is beside it, for single voxels of others are left out as hot.
    "microscopy.deconvolve": Door(restore_stack, stack, (2, *SOME), 300.0),
    "microscopy.deconvolve, PSF": Door(deconvolve, stack, (2, *SOME), 300.0),
    "microscopy.estimate_noise": Door(estimate_noise, lambda: np.tile(movie(), (2, 1, 1)), (slice(None), 24, 24)),
    "imaging.depth_from_defocus": Door(depth_from_defocus, light_of_pair, (0, slice(18, 22), slice(18, 22)), 0.9),
    "imaging.restore, photo": Door(restore, photo, SOME, 0.95),
    "imaging.restore, depth": Door(lambda depth: restore(photo(), depth), lambda: DEPTH, SOME, 2.0),
    "imaging.depth_of_field, image": Door(depth_of_field, photo, SOME, 0.95),
    "imaging.depth_of_field, depth": Door(lambda depth: depth_of_field(photo(), depth), lambda: DEPTH, SOME, 2.0),
}


def lazy(values: np.ndarray) -> Any:
    return dask.array.from_array(values, chunks=(1, *values.shape[1:]))


def labelled(values: Any) -> xarray.DataArray:
    return xarray.DataArray(values, dims=("z", "y", "x")[-len(values.shape) :])


def locked(values: np.ndarray) -> np.ndarray:
    made = values.copy()
    made.flags.writeable = False
    return made


def in_zarr(values: np.ndarray) -> Any:
    made = zarr.create_array({}, shape=values.shape, dtype=values.dtype, chunks=(1, *values.shape[1:]))
    made[:] = values
    return made


def in_hdf5(values: np.ndarray) -> Any:
    return h5py.File(io.BytesIO(), "w").create_dataset("images", data=values)


ccd = partial(CCDData, unit="ct")
PLAIN: dict[str, Callable[[np.ndarray], Any]] = {
    "list": list,
    "tuple": tuple,
    "nested lists": lambda values: values.tolist(),
    "Fortran order": np.asfortranarray,
    "list of Fortran order": lambda values: [np.asfortranarray(one) for one in values],
    "big-endian": lambda values: values.astype(values.dtype.newbyteorder(">")),
    "every second column": lambda values: np.repeat(values, 2, axis=-1)[..., ::2],
    "rows backwards": lambda values: np.ascontiguousarray(values[..., ::-1, :])[..., ::-1, :],
    "read-only": locked,
    "float64": lambda values: values.astype(np.float64),
    "objects": lambda values: values.astype(object),
    "dask": lazy,
    "list of dask": lambda values: [lazy(one) for one in values],
    "xarray": labelled,
    "list of xarray": lambda values: [xarray.DataArray(one) for one in values],
    "xarray of dask": lambda values: labelled(lazy(values)),
    "zarr": in_zarr,
    "hdf5": in_hdf5,
    "quantity": lambda values: values * astropy.units.ct,
    "np.ma": np.ma.masked_array,
    "np.ma, an empty mask": lambda values: np.ma.masked_array(values, np.zeros(values.shape, dtype=bool)),
    "astropy Masked": lambda values: Masked(values, mask=np.zeros(values.shape, dtype=bool)),
    "NDData": NDData,
    "CCDData": ccd,
    "list of CCDData": lambda values: [ccd(one) for one in values],
}
MASKS: dict[str, Callable[[np.ndarray, np.ndarray], Any]] = {
    "np.ma": np.ma.masked_array,
    "list of np.ma": lambda values, mask: list(map(np.ma.masked_array, values, mask)),
    "tuple of np.ma": lambda values, mask: tuple(map(np.ma.masked_array, values, mask)),
    "NDData": lambda values, mask: NDData(values, mask=mask),
    "NDData, flags": lambda values, mask: NDData(values, mask=4 * mask.astype(np.uint8)),
    "NDDataArray": lambda values, mask: NDDataArray(values, mask=mask),
    "CCDData": lambda values, mask: ccd(values, mask=mask),
    "list of CCDData": lambda values, mask: [
        ccd(one, mask=hidden) for one, hidden in zip(values, mask, strict=True)
    ],
    "astropy Masked": lambda values, mask: Masked(values, mask=mask),
    "list of astropy Masked": lambda values, mask: [
        Masked(one, mask=hidden) for one, hidden in zip(values, mask, strict=True)
    ],
    "astropy Masked quantity": lambda values, mask: Masked(values.astype(float) * astropy.units.ct, mask=mask),
    "xarray with NaN": lambda values, mask: labelled(np.where(mask, np.nan, values)),
    "xarray, where": lambda values, mask: labelled(values).where(~labelled(mask)),
    "xarray of masked dask": lambda values, mask: labelled(dask.array.ma.masked_where(lazy(mask), lazy(values))),
    "dask of np.ma": lambda values, mask: lazy(np.ma.masked_array(values, mask)),
    "dask, masked_where": lambda values, mask: dask.array.ma.masked_where(lazy(mask), lazy(values)),
    "list of dask of np.ma": lambda values, mask: [
        lazy(np.ma.masked_array(one, hidden)) for one, hidden in zip(values, mask, strict=True)
    ],
}  # fmt: skip
PHOTOGRAPHS = "imaging.depth_from_defocus"
REFUSED = {
    "objects": "must hold (real numbers|unsigned integers or floats|metres)",
    "NDData": "must hold (real numbers|unsigned integers or floats|metres)",
}
DASK_PAIR = "must both be dask arrays if one is"
COUNTS = r"depth(\[0\])? must be in metres, got the unit ct"  # these containers hold counts


def cases(kinds: dict[str, Any]) -> list[Any]:
    return [pytest.param(door, kind, id=f"{door} - {kind}") for door in DOORS for kind in kinds]


def ask(door: str, given: Any) -> tuple[np.ndarray | None, str]:
    """Return an answer, or why there is none."""
    try:
        return DOORS[door].call(given), ""
    except (TypeError, ValueError) as error:
        return None, str(error)


@cache
def plain(door: str) -> np.ndarray:
    return DOORS[door].call(DOORS[door].values())


@cache
def spoilt(door: str) -> tuple[np.ndarray, np.ndarray]:
    """Return values of which some are wrong, and where these are."""
    values = DOORS[door].values()
    mask = np.zeros(values.shape, dtype=bool)
    mask[DOORS[door].place] = True
    return np.where(mask, np.array(DOORS[door].wrong, values.dtype), values), mask


@cache
def without(door: str) -> np.ndarray | None:
    """Return the answer where these values are NaN, or None where that is refused."""
    values, mask = spoilt(door)
    found, refusal = ask(door, np.where(mask, np.nan, values))
    assert found is not None or re.search("NaN|must be finite", refusal), refusal
    return found


def counted(images: Any) -> Counts:
    return counts_of("images", images, sides=(3,), shape="(planes, height, width)")


@pytest.mark.parametrize("kind", [kind for kind in PLAIN if kind != "objects"])
def test_any_array_is_read_as_the_same_counts(kind):
    found = counted(PLAIN[kind](stack()))
    np.testing.assert_array_equal(found.values, stack())
    assert not found.hidden.any()
    assert not found.full.any()


def test_arrays_of_objects_are_refused():
    with pytest.raises(TypeError, match=f"images {REFUSED['objects']}"):
        counted(PLAIN["objects"](stack()))


@pytest.mark.parametrize("kind", MASKS)
def test_the_mask_of_any_array_hides_the_same_counts(kind):
    values, mask = spoilt("microscopy.deconvolve")
    found, refusal = None, ""
    try:
        found = counted(MASKS[kind](values, mask))
    except TypeError as error:
        refusal = str(error)
    if found is None:
        assert "must not be masked; fill the masked values" in refusal
    else:
        np.testing.assert_array_equal(found.hidden, mask)
        np.testing.assert_array_equal(np.asarray(found.values)[~mask], values[~mask])


@pytest.mark.drawn("kind")
@pytest.mark.parametrize(("door", "kind"), cases(PLAIN))
def test_any_array_has_the_same_answer(door, kind):
    found, refusal = ask(door, PLAIN[kind](DOORS[door].values()))
    if found is None:
        pattern = DASK_PAIR if "depth_of_field" in door and "dask" in kind else REFUSED.get(kind, COUNTS)
        assert re.search(pattern, refusal), refusal
    else:
        np.testing.assert_array_equal(found, plain(door))


@pytest.mark.drawn("kind")
@pytest.mark.parametrize(("door", "kind"), cases(MASKS))
def test_what_is_masked_in_any_array_is_left_out_or_refused(door, kind):
    known = without(door)
    found, refusal = ask(door, MASKS[kind](*spoilt(door)))
    if found is None:
        pattern = f"must not be masked; fill the masked values|{COUNTS}|{DASK_PAIR}" + (
            "|NaN|must be finite" if known is None else ""
        )
        assert re.search(pattern, refusal), refusal
    else:
        assert known is not None
        np.testing.assert_array_equal(found, known)


@pytest.mark.parametrize("door", DOORS)
def test_what_is_wrong_would_change_the_answer(door):
    """Or the tests of masks would show nothing."""
    found, refusal = ask(door, spoilt(door)[0])
    assert found is not None or "the noise cannot be estimated" in refusal
    assert without(door) is None or not np.array_equal(found, without(door), equal_nan=True)
