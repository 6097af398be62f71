"""Which method answers where none was named."""

from __future__ import annotations

from importlib.util import find_spec

from lommel.methods.method import Method
from lommel.methods.nijboer_zernike import NijboerZernike
from lommel.methods.nonuniform_fft import NonuniformFFT
from lommel.pupil import Pupil

_SERIES, _SUM = NijboerZernike(), NonuniformFFT()


def choose(pupil: Pupil) -> Method:
    """Return the method for a pupil: the series for discs and annuli, the non-uniform FFT for other apertures.

    Both keep to a tolerance of 1e-6 of the peak.

    Raises
    ------
    ValueError
        If the pupil needs finufft, which is not installed.
    """
    # What is no pupil is refused by the method, as ever.
    if getattr(pupil, "circular", True):
        return _SERIES
    if find_spec("finufft") is None:
        raise ValueError(
            "method must be named for a pupil with a spider, vignetting or a mask where finufft is missing: install "
            '"lommel[nufft]", or pass method=MatrixFourier(...)'
        )
    return _SUM
