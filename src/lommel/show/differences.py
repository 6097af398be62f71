"""A picture of how far two PSFs are from each other."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.measures.answer import Answer, checked
from lommel.measures.errors import mse, peak_error
from lommel.show.drawing import even_norm, lengths, new_axes

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def difference(a: Answer | ArrayLike, b: Answer, ax: Axes | None = None) -> Any:
    """Draw ``a - b`` over the peak of `b`, red where `a` is larger and blue where it is smaller.

    Parameters
    ----------
    a : PSF or array_like
        Of the shape of `b`; a PSF of the same pixel and normalisation. An array may come from anywhere.
    b : PSF
        A single one.
    ax : matplotlib Axes, optional
        By default those of a new figure, which has a bar and a title with :func:`lommel.peak_error` and the root of
        :func:`lommel.mse`.

    Returns
    -------
    matplotlib Axes

    Raises
    ------
    TypeError, ValueError
        If these do not go together.
    ImportError
        If matplotlib is not installed.

    Examples
    --------
    >>> import lommel as lm
    >>> pupil = lm.Pupil(lm.Wavefront(defocus=3.0))
    >>> exact, fast = (lm.psf(pupil, 64, 0.25, method=method) for method in (None, lm.Fraunhofer(256)))
    >>> axes = lm.show.difference(fast, exact)
    """
    checked(b, "b")
    validation.axes("ax", ax)
    if b.pupil.shape != ():
        raise ValueError(f"b must be a single PSF, got a stack of shape {b.pupil.shape}; index it")
    if isinstance(a, Answer):
        for name in ("unit", "normalize"):
            if getattr(a, name) != getattr(b, name):
                raise ValueError(f"a must have the {name} of b, {getattr(b, name)!r}, got {getattr(a, name)!r}")
        if not np.allclose(a.grid.pitch, b.grid.pitch, rtol=1e-9, atol=0.0):
            raise ValueError(f"a must have the pixel of b, {b.grid.named}, got {a.grid.named}")
    values = np.asarray(a, dtype=np.float64)
    if values.shape != b.shape:
        raise ValueError(f"a must have the shape of b, {b.shape}, got {values.shape}")
    largest, mean = peak_error(values, b.values), math.sqrt(mse(values, b.values))
    away = (values - b.values) / float(b.values.max())
    factor, unit = lengths(b.unit)
    high, half = (0.5 * side * factor for side in b.grid.pitch)
    x, y = b.grid.x * factor, b.grid.y * factor
    axes = new_axes(ax)
    image = axes.imshow(
        away,
        extent=(x[0] - half, x[-1] + half, y[-1] + high, y[0] - high),
        cmap="RdBu_r",
        norm=even_norm(float(np.abs(away).max())),
        interpolation="nearest",
    )
    axes.set_xlabel(f"x ({unit})")
    axes.set_ylabel(f"y ({unit})")
    if ax is None:
        axes.set_title(f"largest difference {largest:.2g} of the peak, rms {mean:.2g}", fontsize=9)
        axes.figure.colorbar(image, ax=axes, label="difference over the peak")
    return axes
