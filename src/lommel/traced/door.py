"""What plans of PSFs have of twins: the one door to them, which imports what is behind it when it is opened."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from lommel.base import validation

if TYPE_CHECKING:
    from lommel.methods.method import Method
    from lommel.optics.base_pupil import BasePupil
    from lommel.optics.grid import Grid
    from lommel.optics.pupil import Pupil
    from lommel.traced.plan_function import Twin


class Traceable:
    """What :class:`lommel.Plan` is, beside that it answers itself: it makes functions for frameworks."""

    method: Method | None
    tol: float
    normalize: str
    dtype: np.dtype[Any]

    if TYPE_CHECKING:
        plain: bool

        def grid(self, pupil: BasePupil) -> Grid:
            """Return the pixels."""

    def traced(self, pupil: Pupil, xp: Any = None, *, device: Any = None, precision: str = "auto") -> Twin:
        """Return the plan as a differentiable function of coefficients, in JAX, PyTorch or any array API.

        Parameters
        ----------
        pupil : Pupil
            A stack: its coefficients are the reach that the function is made for. Of radially symmetric pupils that
            is the box around them; of others what is no larger than a member. Aperture, amplitude and lengths are
            those of the stack.
        xp : module or str, optional
            ``jax.numpy``, ``torch``, ``cupy``, ``numpy`` or another of the array API, or its name; NumPy by default.
        device : optional
            Of the framework, where tables are and coefficients must be.
        precision : {"auto", "float64", "float32"}, default "auto"
            Of what is inside: float64 wherever the framework has it there. In float32 no error of 1e-6 can be proven.

        Returns
        -------
        Twin
            ``images = f(c)``, with c of shape (..., k) a column for each of ``f.terms``, radians.

        Raises
        ------
        TypeError, ValueError
            If an argument is out of range, the aperture is not round, or the framework lacks the precision.
        ImportError
            If the framework that is named is not installed.
        ToleranceError
            If the tolerance is not proven for a pupil of the stack.

        Examples
        --------
        >>> import lommel as lm
        >>> reach = lm.Pupil(lm.Wavefront([-10.0, 10.0]))
        >>> f = lm.Plan(shape=33, pixel=0.5).traced(reach)
        >>> f.terms
        ('defocus', 'spherical')
        >>> f([[3.0, 0.0], [4.0, 0.5]]).shape
        (2, 33, 33)
        """
        from lommel.optics.pupil import checked
        from lommel.traced import plan

        validation.choice("precision", precision, ("auto", "float64", "float32"))
        if not self.plain:
            raise ValueError("pixel must be one number for a twin, and fill and blur left out")
        grid = self.grid(checked(pupil))
        values = self.tol, self.normalize, str(self.dtype)
        return plan.traced(pupil, grid, self.method, values, (xp, device, precision))
