"""What is a number, or an array of them: one for each of a stack."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Numbers = np.float64 | NDArray[np.float64]
