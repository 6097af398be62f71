"""Units and labelled axes of every public argument: the number they mean, or an error that names the argument."""

from __future__ import annotations

import functools
import numbers
import warnings

import numpy as np
import pytest

from tests.fuzz.test_arguments import NAMES, UNCHECKED, entries, files

u = pytest.importorskip("astropy.units")
xr = pytest.importorskip("xarray")

_ = files  # the fixture
# Units that an argument may have, each with another.
UNITS = (("m", "mm"), ("m", "nm"), ("rad", "deg"), ("1/m", "1/mm"), ("s", "ms"), ("pix", "pix"), ("", "%"))


def is_number(value: object) -> bool:
    return isinstance(value, numbers.Real) and not isinstance(value, bool)


def is_array(value: object) -> bool:
    kind = value.dtype.kind if isinstance(value, np.ndarray) else ""
    flat = isinstance(value, list | tuple) and len(value) > 0 and all(map(is_number, value))
    return flat or (isinstance(value, np.ndarray) and value.ndim > 0 and kind in "iuf")


def same(first: object, second: object, deep: int = 5) -> bool:
    """Whether two results have equal numbers, as far as one sees into them; none keeps a unit.

    What files and labels say besides the numbers may differ.
    """
    if isinstance(first, u.Quantity) or isinstance(second, u.Quantity):
        return False
    if isinstance(first, np.ndarray | numbers.Number) and np.asarray(first).dtype.kind in "iufc":
        return np.allclose(first, second, rtol=1e-6, atol=1e-10, equal_nan=True)
    if type(first) is not type(second) or deep == 0:
        return type(first) is type(second)
    if isinstance(first, list | tuple):
        return len(first) == len(second) and all(same(*pair, deep - 1) for pair in zip(first, second, strict=True))
    if isinstance(first, dict):
        return first.keys() == second.keys() and all(same(first[k], second[k], deep - 1) for k in first)
    told = [
        {name: value for name, value in getattr(v, "__dict__", {}).items() if name != "metadata"}
        for v in (first, second)
    ]
    return same(*told, deep - 1)


def faults(entry, argument, value, right) -> list[str]:
    """Return what is wrong with the answer to a value that has a unit or labels: nothing, or a sentence."""
    name, call, given = entry
    told = f"{name}({argument}={' '.join(repr(value).split())[:100]})"
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            answer = call(**given | {argument: value})
        except (TypeError, ValueError, IndexError) as error:
            named = (argument, *NAMES.get(argument, ()))
            return [] if any(word in str(error) for word in named) else [f"{told}: names none: {error}"]
        return [] if right is not None and same(right(), answer) else [f"{told}: is taken for something else"]


def numeric(known):
    """Yield (entry, argument, value, its right answer) of arguments that are numbers or arrays of numbers."""
    for name, call, given in known:
        right = functools.cache(lambda call=call, given=given: call(**given))
        for argument, value in given.items():
            # A result's own fields are not arguments that anybody converts; metres of path are 1e7 radians, whose
            # rounding shows (tests/optics/wavefront/test_opd_fit.py has units of maps).
            if name == "PSF" or (name, argument) in UNCHECKED | {("fit_opd", "opd")}:
                continue
            if is_number(value) or is_array(value):
                yield (
                    (name, call, given),
                    argument,
                    np.asarray(value, np.float64) if is_array(value) else value,
                    right,
                )


@pytest.mark.quick
def test_a_quantity_of_another_kind_is_refused_by_the_name_of_its_argument(files):
    found = [
        f
        for entry, argument, value, _ in numeric(entries(files))
        for f in faults(entry, argument, value * u.kg, None)
    ]
    assert not found, "\n".join(found)


def test_a_quantity_is_converted_or_refused_by_the_name_of_its_argument(files):
    found = []
    for entry, argument, value, right in numeric(entries(files)):
        for unit, other in UNITS:
            found += faults(entry, argument, u.Quantity(value, unit).to(other), right)
    assert not found, "\n".join(found)


def test_labelled_axes_in_another_order_are_put_in_order_or_refused(files):
    found = []
    for entry, argument, value, right in numeric(entries(files)):
        if np.ndim(value) < 2:
            continue
        others = ["a", "b", "c"][: value.ndim - 2]
        labelled = xr.DataArray(value, dims=[*others, "y", "x"])
        found += faults(entry, argument, labelled, right)
        for order in (("x", "y", *others), ("x", *others, "y"), (*others, "x", "y")):
            found += faults(entry, argument, labelled.transpose(*order), right)
        found += faults(entry, argument, xr.DataArray(value, dims=[*others, "p", "q"]), None)
    assert not found, "\n".join(found)


def test_the_unit_that_an_attribute_of_a_labelled_array_states_is_converted_or_refused(files):
    found = []
    for entry, argument, value, right in numeric(entries(files)):
        dims = ["a", "b", "c", "y", "x"][-np.ndim(value) :] if np.ndim(value) else []
        for unit, size in (("mm", 1e3), ("micrometer", 1e6), ("1/mm", 1e-3), ("degrees", 180 / np.pi)):
            found += faults(entry, argument, xr.DataArray(value * size, dims=dims, attrs={"units": unit}), right)
        found += faults(entry, argument, xr.DataArray(value, dims=dims, attrs={"units": "furlong"}), None)
    assert not found, "\n".join(found)


def test_arrays_that_are_masked_read_only_or_of_another_byte_order_are_the_same_numbers(files):
    found = []
    for entry, argument, value, right in numeric(entries(files)):
        if np.ndim(value) == 0 or argument == "out":
            continue
        still = np.array(value)
        still.flags.writeable = False
        for other in (
            still,
            value.astype(value.dtype.newbyteorder(">")),
            np.ma.masked_array(value),
            value[..., ::-1].copy()[..., ::-1],
        ):
            found += faults(entry, argument, other, right)
    assert not found, "\n".join(found)
