"""A twin as a module of PyTorch, whose tables move, are saved and are shared among processes as buffers are."""

from __future__ import annotations

from typing import Any

from lommel.base import validation
from lommel.base.optional import library
from lommel.traced.plan_function import Twin


def module(twin: Twin) -> Any:
    """Return a ``torch.nn.Module`` with the tables of a twin as buffers.

    ``.to(device)`` moves it, and ``forward(c)`` and ``certified(c)`` are those of the twin. It has no parameters, and
    its precision cannot be changed.

    Parameters
    ----------
    twin : Twin
        Made by ``plan.traced(pupil, torch)``.

    Returns
    -------
    torch.nn.Module

    Raises
    ------
    TypeError
        If it is none, or of another framework.
    """
    validation.instance("twin", twin, Twin)
    if not repr(twin).split(": ")[0].endswith(" torch"):
        raise TypeError(f"twin must be of torch to be a module, got {twin!r}")
    torch = library("torch", "modules need", "torch")

    class TwinModule(torch.nn.Module):  # type: ignore[misc,name-defined]
        """A PSF as a layer."""

        def __init__(self) -> None:
            super().__init__()
            for k, tables in enumerate(twin.tables):
                for name, table in tables.items():
                    self.register_buffer(f"{name}_{k}", table, persistent=False)

        def twin(self) -> Twin:
            """Return the twin with the tables where they are now."""
            return twin.with_tables(
                tuple({name: getattr(self, f"{name}_{k}") for name in one} for k, one in enumerate(twin.tables))
            )

        def forward(self, c: Any, *, check: bool = True) -> Any:
            return self.twin()(c, check=check)

        def certified(self, c: Any, *, check: bool = True) -> Any:
            return self.twin().certified(c, check=check)

    return TwinModule()
