"""The live page in a notebook, by anywidget: its state as traits, both ways."""

from __future__ import annotations

from functools import cache
from os import PathLike
from typing import Any

from lommel.base import validation
from lommel.base.arrays import Json
from lommel.base.optional import library
from lommel.lensfiles.instrument import Instrument
from lommel.lensfiles.lens_files import load_instrument
from lommel.page import server
from lommel.page.state import FIELDS, Terms, Whole, Word, complete, psf_of, state_of
from lommel.psf import PSF


def live(lens: Instrument | str | PathLike[str] | None = None, **state: Any) -> Any:
    """Return the live page as a notebook widget, for Jupyter, VS Code, marimo and other hosts of anywidget.

    Every control is a synchronised trait of the widget: ``w.coma = 0.5`` moves the slider, and ``w.observe(...,
    "coma")`` is notified when it is dragged. ``w.state`` is a dict of all controls, and can be set to a dict of some;
    ``w.psf()`` returns the :class:`lommel.PSF` that the page shows, without noise, computed in Python, with further
    arguments as of :func:`lommel.psf`.

    Parameters
    ----------
    lens : Instrument, str or path, optional
        Initial lens: a lens file, or the result of :func:`lommel.load_instrument`.
    **state
        Initial values of controls.

        - Wavefront, waves at the edge of the pupil: `defocus` and `spherical` (W020 and W040), `coma`, `astigmatism`,
          `trefoil` with `coma_angle` and so on (degrees); `zernike`, further terms "n,m:waves;..." in waves rms.
        - `focus`: "waves", or "distances", where `focal_length` (mm), `f_number`, `focus_distance` and
          `object_distance` (m) give the defocus, as :meth:`lommel.Lens.pupil` does.
        - Lens and light: `f_number`, `obscuration`, `vanes` (0 to 8), `vane_width` (over the radius), `vane_angle`
          (degrees), `wavelength` (nm), `light` ("mono", "white").
        - Sensor: `pixel` (um), `view` ("fine", "sampled", "averaged"), `side` (pixels), `noise` ("off", "on"),
          `photons`, `read_noise` (electrons).
        - Display: `rays` ("off", "on"), `stretch`, `map`, `waves_unit`, `length_unit`, `picture`.

        Also `controls`, a list of those to show, and `theme`, "light" or "dark", by default that of the notebook.

    Returns
    -------
    anywidget.AnyWidget

    Raises
    ------
    ImportError
        If anywidget is not installed; the extra "live" of this package installs it.
    FileNotFoundError
        If the page's module was not built.
    TypeError, ValueError
        If a control is unknown or its value invalid, or the lens is out of their range.

    Examples
    --------
    >>> w = lm.live("examples/lenses/hubble-1990.toml")  # doctest: +SKIP
    >>> w.psf().values.shape  # doctest: +SKIP
    (512, 512)
    """
    kind = _kind()
    look = {name: state.pop(name) for name in ("controls", "theme") if name in state}
    start: Json = {}
    if lens is not None:
        if not isinstance(lens, Instrument):
            if not isinstance(lens, (str, PathLike)):
                raise TypeError(
                    f"lens must be an Instrument or the path of a lens file, got {validation.shown(lens)}"
                )
            lens = load_instrument(lens)
        start, _ = state_of(lens)
    return kind(**complete(start | state), **look)


@cache
def _kind() -> type:
    """Return the class of the widget, which is that of an optional library."""
    anywidget: Any = library("anywidget", "lm.live() needs", "live")
    traitlets: Any = library("traitlets", "lm.live() needs", "live")

    class Text(traitlets.Unicode):  # type: ignore[misc]
        """A text of Zernike terms."""

        def validate(self, owner: Any, value: object) -> str:
            try:
                return str(FIELDS[self.name].accepted(self.name, value))
            except (TypeError, ValueError) as error:
                raise traitlets.TraitError(str(error)) from None

    def trait(field: Any) -> Any:
        if isinstance(field, Word):
            return traitlets.Enum(field.choices, default_value=field.initial).tag(sync=True)
        if isinstance(field, Terms):
            return Text(field.initial).tag(sync=True)
        kind = traitlets.CInt if isinstance(field, Whole) else traitlets.CFloat
        return kind(field.initial, min=field.low, max=field.high).tag(sync=True)

    class Live(anywidget.AnyWidget):  # type: ignore[misc]
        """The live page; see :func:`lommel.live`."""

        _esm = server.path()
        controls = traitlets.List(traitlets.Unicode()).tag(sync=True)
        theme = traitlets.Enum(("light", "dark"), default_value=None, allow_none=True).tag(sync=True)

        @property
        def state(self) -> Json:
            """What the controls say."""
            return {name: getattr(self, name) for name in FIELDS}

        @state.setter
        def state(self, change: Json) -> None:
            whole = complete(self.state | change)
            with self.hold_sync():
                for name, value in whole.items():
                    setattr(self, name, value)

        def psf(self, **options: Any) -> PSF:
            """Return the PSF that the page shows, by this Python."""
            return psf_of(self.state, **options)

        def __repr__(self) -> str:
            said = ", ".join(
                f"{name}={value!r}" for name, value in self.state.items() if value != FIELDS[name].initial
            )
            return f"Live({said})"

    made: type = type("Live", (Live,), {name: trait(field) for name, field in FIELDS.items()})
    return made
