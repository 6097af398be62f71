"""What type checkers see of the package: mypy reads this file with the package, and a test runs it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, assert_type

import lommel as lm

assert_type(lm.psf(lm.Pupil(), 3, 0.5), lm.PSF)
assert_type(lm.Wavefront(defocus=1.0), lm.Wavefront)
assert_type(lm.__version__, str)
# A module that nothing imported waits for its first use.
of_modules: list[Callable[..., Any]] = [lm.imaging.depth_of_field, lm.show.plot.field]

try:
    # That mypy ignores an error here is one where there is no error.
    unknown = lm.fft  # type: ignore[attr-defined]
except AttributeError:
    pass
else:
    raise AssertionError(unknown)
