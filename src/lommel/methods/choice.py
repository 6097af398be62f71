"""Which method answers where none was named."""

from __future__ import annotations

import math
from importlib.util import find_spec

from lommel.methods.averaging import samples_across
from lommel.methods.chordal_gauss import ChordalGauss
from lommel.methods.method import Method
from lommel.methods.nijboer_zernike import NijboerZernike
from lommel.methods.nonuniform_fft import NonuniformFFT
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil

SERIES, _MATRIX, _SUM = NijboerZernike(), ChordalGauss(), NonuniformFFT()


def choose(pupil: Pupil, grid: Grid) -> Method:
    """Return the method for a pupil and a window, each with a tolerance of 1e-6 of the peak.

    The series for circular apertures; the chordal rule where their wavefront is not radially symmetric and the window
    is small, up to 64 samples a side or, of eight pupils or more, 128; the non-uniform FFT for other apertures.

    Raises
    ------
    ValueError
        If the pupil needs finufft, which is not installed.
    """
    # What is no pupil is refused by the method, as ever.
    if getattr(pupil, "radial", True):
        return SERIES
    if pupil.circular:
        # Averages are made of finer samples.
        side = max(grid.shape) * (samples_across(grid.step(pupil)) if grid.integrate else 1)
        small = side <= 64 or (side <= 128 and math.prod(pupil.shape) >= 8)
        return _MATRIX if small else SERIES
    if find_spec("finufft") is None:
        raise ValueError(
            "method must be named for a pupil with a spider, vignetting or a mask where finufft is missing: "
            "pip install finufft, or pass method=MatrixFourier(...)"
        )
    return _SUM
