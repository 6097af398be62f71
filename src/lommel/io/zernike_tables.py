"""Zernike coefficients as they were written down, with what is needed to know what they mean."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from os import PathLike
from typing import Any

from lommel.base import atomic, display, validation
from lommel.base.units import LENGTHS
from lommel.optics.wavefront.coefficients import NORMALIZATIONS
from lommel.optics.wavefront.wavefront import Wavefront, same_path
from lommel.special import zernike

SUFFIXES = (".json", ".toml", ".csv")
"""Of files of tables."""

UNITS = ("radians", "waves", "metres", *LENGTHS)


@dataclass(frozen=True)
class ZernikeTable:
    """Zernike coefficients as they were written down, of a single wavefront.

    Parameters
    ----------
    terms : mapping of index to float
        Integers, or pairs (n, m) for the order "nm".
    order : {"nm", "noll", "ansi", "fringe"}
    unit : str
        "radians", "waves", or that of a path length: "metres", "nm", "um", ...
    normalization : {"rms", "edge"}
        As in :meth:`lommel.Wavefront.zernike`.
    wavelength : float, optional
        Metres; that at which the waves or radians were measured.

    Raises
    ------
    TypeError, ValueError
        If there is no such term, order, unit, or normalization, or a number is not finite.
    """

    terms: Mapping[Any, float]
    order: str
    unit: str
    normalization: str
    wavelength: float | None = None

    def __post_init__(self) -> None:
        validation.choice("order", self.order, zernike.ORDERS)
        validation.choice("unit", self.unit, UNITS)
        validation.choice("normalization", self.normalization, NORMALIZATIONS)
        if self.wavelength is not None:
            object.__setattr__(self, "wavelength", validation.wavelength(self.wavelength))
        if not isinstance(self.terms, Mapping):
            raise TypeError(f"terms must map indices to coefficients, got {validation.shown(self.terms)}")
        terms = {i: validation.real(f"the Zernike coefficient {i!r}", c) for i, c in self.terms.items()}
        object.__setattr__(self, "terms", terms)
        Wavefront.zernike(terms, order=self.order)  # which names the terms that do not exist

    @classmethod
    def from_wavefront(
        cls,
        wavefront: Wavefront,
        *,
        order: str = "noll",
        unit: str = "waves",
        normalization: str = "rms",
        wavelength: float | None = None,
    ) -> ZernikeTable:
        """Describe a single wavefront; units of length need `wavelength`, in metres.

        Parameters
        ----------
        wavefront : Wavefront
        order, unit, normalization : str
            Of the table.
        wavelength : float, optional
            Metres.

        Returns
        -------
        ZernikeTable

        Raises
        ------
        TypeError, ValueError
            If it is a stack, if there is no such order, unit or normalization, or if a wavelength is missing.
        """
        if validation.instance("wavefront", wavefront, Wavefront).shape != ():
            raise ValueError(f"wavefront must be a single one, got a stack of shape {wavefront.shape}")
        plain, size = _unit(validation.choice("unit", unit, UNITS))
        found = wavefront.to_zernike(order=order, unit=plain, normalization=normalization, wavelength=wavelength)
        return cls({i: float(c) / size for i, c in found.items()}, order, unit, normalization, wavelength)

    def wavefront(self, wavelength: float | None = None) -> Wavefront:
        """Return the wavefront at a wavelength in metres, by default that of the table.

        A path length is the same at every wavelength (dispersion is left out): at another one, waves and radians
        change by the ratio of the wavelengths.

        Parameters
        ----------
        wavelength : float, optional
            Metres.

        Returns
        -------
        Wavefront

        Raises
        ------
        ValueError
            If a length is to become a phase and no wavelength is known, or if `wavelength` is given and the table
            does not say at which its waves or radians were measured.
        """
        plain, size = _unit(self.unit)
        at = self.wavelength if wavelength is None else validation.wavelength(wavelength)
        if plain == "metres" and at is None:
            raise ValueError(f"wavelength must be given, since the unit of the table is {self.unit!r}")
        if plain != "metres" and wavelength is not None and self.wavelength is None:
            raise ValueError(f"the table must state the wavelength at which its {self.unit} were measured")
        scaled = {i: size * c for i, c in self.terms.items()}
        made = Wavefront.zernike(
            scaled, order=self.order, unit=plain, normalization=self.normalization, wavelength=at
        )
        if plain == "metres" or at is None or self.wavelength is None or at == self.wavelength:
            return made
        return same_path(made, self.wavelength, at)


def save_zernike(path: str | PathLike[str], table: ZernikeTable | Wavefront) -> None:
    """Write a table; the suffix chooses the format, and :func:`lommel.load_zernike` reads the very same numbers.

    A single wavefront is written as a table of Noll's terms in waves rms; :meth:`ZernikeTable.from_wavefront` makes
    those of other orders and units. The file is written under a temporary name and moved into place.

    Parameters
    ----------
    path : path
        Ending in .json, .toml or .csv.
    table : ZernikeTable or Wavefront

    Raises
    ------
    TypeError, ValueError
        If `table` is neither, or a stack, or if the suffix is unknown.
    OSError
        If the file cannot be written.
    """
    if isinstance(table, Wavefront):
        table = ZernikeTable.from_wavefront(table)
    if not isinstance(table, ZernikeTable):
        raise TypeError(f"table must be a ZernikeTable or a Wavefront, got {validation.shown(table)}")
    form = suffix(path)
    settings = {"order": table.order, "unit": table.unit, "normalization": table.normalization}
    if table.wavelength is not None:
        settings["wavelength"] = f"{table.wavelength!r} m"
    pair = table.order == "nm"
    terms = {(f"{i[0]},{i[1]}" if pair else str(i)): c for i, c in table.terms.items()}
    if form == ".json":
        text = json.dumps(settings | {"terms": terms}, indent=2, allow_nan=False) + "\n"
    elif form == ".toml":
        head = [f'{key} = "{value}"' for key, value in settings.items()]
        text = "\n".join([*head, "", "[terms]", *(f'"{key}" = {c!r}' for key, c in terms.items()), ""])
    else:
        head = [f"# {key}: {value}" for key, value in settings.items()]
        text = "\n".join(
            [*head, "n,m,value" if pair else "index,value", *(f"{k},{c!r}" for k, c in terms.items()), ""]
        )
    atomic.write(validation.path("path", path), text.encode())


@display.save.register(Wavefront)
def save_wavefront(
    wavefront: Wavefront,
    path: str | PathLike[str],
    *,
    order: str = "noll",
    unit: str = "waves",
    normalization: str = "rms",
    wavelength: float | None = None,
) -> None:
    """Write the Zernike coefficients of a single wavefront: :meth:`ZernikeTable.from_wavefront`, saved.

    Parameters
    ----------
    wavefront : Wavefront
    path : path
        Ending in .json, .toml or .csv.
    order, unit, normalization : str
        Of the table.
    wavelength : float, optional
        Metres; units of length need it.

    Raises
    ------
    TypeError, ValueError
        If it is a stack, if there is no such order, unit or normalization, if a wavelength is missing, or if the
        suffix is unknown.
    OSError
        If the file cannot be written.
    """
    suffix(path)
    table = ZernikeTable.from_wavefront(
        wavefront, order=order, unit=unit, normalization=normalization, wavelength=wavelength
    )
    save_zernike(path, table)


def suffix(path: str | PathLike[str], name: str = "path") -> str:
    """Return the suffix of a table, in small letters; ValueError with all of them, for `name`, if it is another."""
    found = validation.path(name, path).suffix.lower()
    if found not in SUFFIXES:
        raise ValueError(f"{name} must end in {', '.join(SUFFIXES)}, got {validation.shown(str(path))}")
    return found


def _unit(unit: str) -> tuple[str, float]:
    """Return a unit of :meth:`lommel.Wavefront.zernike`, and how many of it one `unit` is."""
    return ("metres", LENGTHS.get(unit, 1.0)) if unit not in ("radians", "waves") else (unit, 1.0)
