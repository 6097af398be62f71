"""`lommel stack`, run as a user runs it."""

from __future__ import annotations

import json
import re
import time

import numpy as np

import lommel as lm

WINDOW = ("--shape", 5, "--pixel", "2 um")


def test_distances_are_even_in_defocus_and_the_command_goes_on_where_it_was(lenses, tmp_path, call_lommel):
    lens = lenses["nifty-fifty"]
    command = ("stack", lens, "--between", "1 m", "inf", "--count", 9, *WINDOW, "-o", "a.zarr")
    start = time.perf_counter()
    result = call_lommel(*command, "--json", folder=tmp_path)
    assert result.returncode == 0, result.stderr
    facts = json.loads(result.stdout)
    made = lm.open_stack(tmp_path / "a.zarr")
    assert (facts["shape"], facts["chunks"], facts["computed"]) == ([9, 5, 5], 1, 1)
    assert facts["error_bound"] == made.error_bound.max() <= 1e-6
    assert 0.0 < facts["seconds"] < time.perf_counter() - start
    at = made.axes["object_distance"]
    assert (at[0], at[-1]) == (1.0, np.inf)
    np.testing.assert_allclose(np.diff(made[:].pupil.wavefront.defocus, 2), 0.0, atol=1e-9)
    asked = lm.psf(lm.load_instrument(lens).lens.pupil(at[:3]), 5, 2e-6)
    np.testing.assert_array_equal(made[:3].values, asked.values)
    again = call_lommel(*command, folder=tmp_path)
    assert again.returncode == 0, again.stderr
    assert re.search(r"chunks +1\ncomputed +0\nerror bound +\S+ of the peak\n", again.stdout)
