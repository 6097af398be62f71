"""PSFs to files and back; every file says how its values were made."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from os import PathLike
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from lommel.base import atomic, reading, validation
from lommel.base.checksums import checksum
from lommel.base.optional import version
from lommel.blur.blurs import blurs_from_dicts
from lommel.io import fits_images, psf_fits, psf_hdf5, psf_numpy, psf_png, psf_tiff, registry
from lommel.io.registry import Format
from lommel.measures.psf_like import PSFLike
from lommel.methods import method_from_dict
from lommel.optics.grid import Grid
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.pupil import FieldPupil, Pupil

Made = TypeVar("Made", bound=PSFLike)
NORMALIZE = ("energy", "emitted", "strehl", "peak")

_fits, _hdf5 = (partial(Format, "psf", library=of, extra=e) for of, e in (("astropy", "fits"), ("h5py", "hdf5")))
registry.register(
    Format("psf", (".tif", ".tiff"), psf_tiff.write, psf_tiff.read, library="tifffile", extra="images"),
    Format("psf", (".npy",), psf_numpy.npy, psf_numpy.read_npy),
    Format("psf", (".npz",), psf_numpy.npz, psf_numpy.read_npz, holds=("with derivatives",)),
    Format("psf", (".png",), psf_png.write, psf_png.read, library="PIL.Image", extra="images"),
    _fits(fits_images.SUFFIXES, psf_fits.write, psf_fits.read),
    _fits(fits_images.PACKED, fits_images.packed(psf_fits.write), psf_fits.read),
    _hdf5((".h5", ".hdf5"), psf_hdf5.write, psf_hdf5.read, holds=("with derivatives",)),
    _hdf5((".mat",), psf_hdf5.write_mat, psf_hdf5.read_mat),
    Format("psf", (".raw",), psf_numpy.write, psf_numpy.read, beside=".json"),
    Format("psf", (".json",), psf_numpy.write_turned, psf_numpy.read_turned, beside=".raw"),
)
find = partial(registry.find, "psf")


class FileError(ValueError):
    """A file that cannot be read as a PSF of this package."""


def save(psf: PSFLike, path: str | PathLike[str]) -> None:
    """Write a PSF; the suffix chooses the format.

    ``.tif``: OME-TIFF with the physical pixel size, all values; that of a microscope has the size in the sample (the
    pixel over the magnification), the step of evenly spaced planes, where each is, the wavelength, and what its
    objective and layers are. ``.npy``: the array, with the description behind it, where NumPy does not look.
    ``.npz``: ``values`` and ``description``. ``.png``: a picture to look at, 16-bit grey, the square root of the
    values over their peak, enlarged by the whole number that makes the longer side 512 pixels or more (a single PSF
    only; :meth:`lommel.PSF.load` gives its values back to 1.6e-5 of the peak). ``.fits``, ``.fits.gz``: the values
    with PIXELSCL (arcsec, of a lens with distances), XPIXSZ and YPIXSZ (um), CDELTn, WAVELEN, WAVEn and WGHTn; the
    description is the bytes of the extension LOMMEL. ``.h5``: the dataset ``values`` with attributes, dimension
    names and scales. ``.mat``: the same for MATLAB (version 7.3), of the size [height width ...]. ``.raw``: numbers,
    little-endian, row by row, with a ``.json`` beside that says their shape, type, pixel and wavelength; both are
    written or none, and either path loads them. See :doc:`/formats` for what reads each.

    Derivatives go into ``.npz`` and ``.h5`` only. The description is JSON: version, pupil (wavefront, obscuration,
    wavelength, f-number, lens distances), method with all its options, normalisation, pixel, error bound, and a
    checksum of all of this and of the values, without which nothing loads. The file is written under a temporary name
    and moved into place, so that a failure leaves what was there before; links are followed and permissions kept.

    Parameters
    ----------
    psf : PSF
    path : path

    Raises
    ------
    ValueError
        If the suffix is unknown, for a PNG of a stack, or for derivatives in anything but ``.npz`` and ``.h5``.
    ImportError
        If tifffile, Pillow, astropy or h5py is not installed.
    OSError
        If the file cannot be written.
    """
    form = find(path, holding="with derivatives" if psf.derivatives else "")
    made = form.write(psf, describe(psf))
    with atomic.together() as put:
        for place, data in zip(form.places(Path(path)), made if form.beside else (made,), strict=True):
            put(place, data)


def load(path: str | PathLike[str], kind: Callable[..., Made]) -> Made:
    """Read a PSF that :func:`lommel.io.psf_files.save` wrote, as one of this kind.

    Raises
    ------
    FileError
        If the file is damaged or was not written by this package.
    OSError
        If it cannot be read.
    """
    return load_described(path, kind)[0]


def load_described(path: str | PathLike[str], kind: Callable[..., Made]) -> tuple[Made, dict[str, Any]]:
    """Read a PSF and the whole description in its file, which may say more than a PSF holds."""
    form, source = find(path, verb="read"), Path(path)
    data = [reading.contents(place) for place in form.places(source)]
    with told(source, "a PSF"):
        arrays, text = form.read(*data)
        description = reading.json(text)
        return rebuild(arrays, description, kind), description


@contextmanager
def told(source: Path, what: str) -> Iterator[None]:
    """Tell whatever goes wrong as a fault of the file, but for a library that is missing."""
    try:
        yield
    except (ImportError, FileError):
        raise
    except Exception as error:
        said = reading.reason(error)
        raise FileError(f"{validation.line(source)} is not {what} written by lommel: {said}") from error


def describe(psf: PSFLike) -> dict[str, Any]:
    """Return how a PSF was made, in plain types.

    Parameters
    ----------
    psf : PSF

    Returns
    -------
    dict
        All but the values; ``lommel.base.checksums.sealed`` adds the checksum of all.
    """
    # What few have is not stated of the others, whose files read as before.
    beyond: dict[str, Any] = {"fill": list(psf.grid.fill)} if psf.grid.partly else {}
    if psf.blur:
        beyond["blur"] = [blur.to_dict() for blur in psf.blur]
    return {
        "software": f"lommel {version()}",
        "pupil": {"kind": type(psf.pupil).__name__} | psf.pupil.to_dict(),
        "method": psf.method.to_dict(),
        "sampling": psf.sampling,
        "normalize": psf.normalize,
        "pixel": psf.pixel,
        "center": [np.asarray(part).tolist() for part in psf.grid.center],
        "integrate": psf.grid.integrate,
        **beyond,
        "unit": psf.unit,
        "error_bound": psf.error_bound,
        "derivative_bounds": {str(name): bound for name, bound in psf.derivative_bounds.items()},
        "scale": psf.scale.tolist(),
        "shape": list(psf.shape),
        "dtype": str(psf.values.dtype),
    }


def rebuild(arrays: dict[str, NDArray[Any]], description: dict[str, Any], kind: Callable[..., Made]) -> Made:
    """Return the PSF of the arrays of a file, by name, and of their sealed description."""
    if "channels" in description:
        raise ValueError("it has channels; ColourPSF.load, or PSFGrid.load, reads it")
    pupil, method = _pupil(description["pupil"]), method_from_dict(description["method"])
    method.require(pupil)
    bound, picture = description["error_bound"], description.get("png")
    if bound is not None:
        # A picture adds half a level of the square root, at its steepest.
        bound = validation.real("error_bound", bound, least=0.0) + (1.0 / psf_png.LEVELS if picture else 0.0)
    dtype = validation.choice("dtype", description["dtype"], ("float32", "float64"))
    scale = validation.real_array("scale", description["scale"], least=0.0)
    shape = tuple(description["shape"])
    if shape[:-2] != pupil.shape or scale.shape != pupil.shape or len(shape) != len(pupil.shape) + 2:
        raise ValueError(f"values of shape {shape} and scales of {scale.shape} for pupils of {pupil.shape}")
    made = kind(
        values=_values(arrays["values"], dtype, picture).reshape(shape),
        grid=Grid(
            shape[-2:],
            description["pixel"],
            center=description["center"],
            integrate=description["integrate"],
            fill=description.get("fill", 1.0),
        ),
        pupil=pupil,
        method=method,
        normalize=validation.choice("normalize", description["normalize"], NORMALIZE),
        error_bound=bound,
        scale=scale,
        derivatives={
            psf_numpy.name(said.removeprefix(psf_numpy.SLOPE)): _values(slope, dtype).reshape(shape)
            for said, slope in arrays.items()
            if said.startswith(psf_numpy.SLOPE)
        },
        blur=blurs_from_dicts(description.get("blur", ())),
        derivative_bounds={psf_numpy.name(k): bound for k, bound in description["derivative_bounds"].items()},
    )
    # Values that are computed as sums may lie below 0 by their error.
    least = -(bound or 0.0) * float(scale.max())
    if float(made.values.min()) < least:
        raise ValueError(f"its values must be >= 0, got {made.values.min():g}")
    if "checksum" not in description:
        raise ValueError("it has no checksum, so nobody knows whether it is whole; save it anew")
    if description["checksum"] != checksum(description, arrays):
        raise ValueError("its checksum is another: it is damaged, or was changed after it was written")
    return made


def _pupil(description: dict[str, Any]) -> Pupil | ObjectivePupil | FieldPupil:
    """Return a pupil of the kind that it says; those of lenses did not always say it."""
    plain = dict(description)
    kinds: dict[str, Any] = {kind.__name__: kind for kind in (Pupil, ObjectivePupil, FieldPupil)}
    found: Pupil = kinds[validation.choice("kind", plain.pop("kind", "Pupil"), kinds)].from_dict(plain)
    return found


def _values(stored: NDArray[Any], kind: str, picture: Any = None) -> NDArray[Any]:
    """Return what a file stores as values, which must be of the stated kind and finite."""
    if picture:
        peak = validation.real("peak", picture["peak"], above=0.0)
        return np.asarray(peak * (stored.astype(np.float64) / psf_png.LEVELS) ** 2, dtype=kind)
    if stored.dtype.newbyteorder("=") != np.dtype(kind):
        raise ValueError(f"its values must be {kind}, got {stored.dtype}")
    if not np.isfinite(stored).all():
        raise ValueError(f"its values must be finite, got {stored[~np.isfinite(stored)].flat[0]}")
    return stored.astype(kind, copy=False)
