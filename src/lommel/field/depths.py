"""What places of the sensor see of objects at several distances: the field of a map, the focus of a lens."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.optics.lens import Lens
from lommel.optics.pupil import Pupil


def require_light(light: Pupil, lens: Lens) -> None:
    """Raise ValueError where a lens is not that of a map: of `light`, its pupil without wavefront.

    Parameters
    ----------
    light : Pupil
    lens : Lens
    """
    if not lens.aberrations.flat:
        raise ValueError("lens must have no aberrations, for the map has those of all places: add them to it")
    there = lens.pupil(1.0).unaberrated()
    for name, own, other in (
        ("wavelength", there.wavelength, light.wavelength),
        ("working f-number", there.f_number, light.f_number),
        ("aperture", there.aperture, light.aperture),
    ):
        if own != other:
            raise ValueError(
                f"lens must have the {name} of the map, {other}, got {own}; make the map with "
                "aperture=lens.pupil(1.0).unaberrated()"
            )


def at_depths(pupil: Pupil, lens: Lens, depths: ArrayLike) -> Pupil:
    """Return what each place sees of objects at each distance.

    Parameters
    ----------
    pupil : Pupil
        A stack of shape ``places``, with the aberrations of the field.
    lens : Lens
        Without aberrations, of the same light.
    depths : array_like, shape (k,)
        Distances of objects from the lens, metres; may be infinite.

    Returns
    -------
    Pupil
        A stack of shape ``places + (k,)``.

    Raises
    ------
    TypeError, ValueError
        If the distances are none, or the lens is not that of the pupils.
    """
    validation.instance("lens", lens, Lens)
    require_light(pupil, lens)
    distances = np.atleast_1d(np.asarray(depths))
    if distances.ndim != 1:
        raise ValueError(f"depths must be of shape (k,), got {distances.shape}")
    near, shape = lens.pupil(distances), (*pupil.shape, distances.size)
    places = pupil[(..., None)].broadcast(shape)
    geometry = near.geometry
    assert geometry is not None
    own = tuple(np.broadcast_to(distances, shape).ravel().tolist())
    return replace(
        places,
        wavefront=places.wavefront + near.wavefront,
        geometry=replace(geometry, object_distance=own),
        colour=places.colour or near.colour,
    )
