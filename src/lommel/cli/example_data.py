"""Data sets that `lommel examples` computes: simulated recordings with noise, one for each field."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from lommel.base import atomic
from lommel.base.arrays import Array, Values
from lommel.blur.blurs import Jitter
from lommel.io.photos import stored, write_png, write_tiff
from lommel.lensfiles import example_files
from lommel.lensfiles.lens_files import load_instrument
from lommel.lensfiles.microscope_files import Microscope, load_microscope
from lommel.methods import Bead
from lommel.optics.lens import Lens
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import psf
from lommel.recorded.noise import Noise

_PIXEL, _POINTS = 3.45e-6, 4  # of photographs: pitch, metres, and points along a pixel of their scenes
_WHITE = Noise(white=1e4, read=3.0)  # of photographs, electrons
_SCMOS = Noise(read=1.6, offset=100.0)  # of stacks and movies, counts of one electron


@dataclass(frozen=True)
class DataSet:
    """A data set: its files by name, the example file of its instrument, commands for it, and the true numbers."""

    title: str
    make: Callable[[], dict[str, bytes]]
    instrument: str | None
    commands: tuple[str, ...]
    truth: str


def _chart() -> dict[str, bytes]:
    """Return a picture of two dark squares, turned by 6 degrees, in focus."""
    y, x = ((np.arange(size * _POINTS) + 0.5) / _POINTS for size in (120, 200))
    turn, light = np.radians(6.0), np.full((y.size, x.size), 0.8)
    for middle in (50.0, 150.0):
        across, down = x - middle, y[:, None] - 60.0
        u, v = across * np.cos(turn) + down * np.sin(turn), down * np.cos(turn) - across * np.sin(turn)
        light[np.maximum(abs(u), abs(v)) < 32.0] = 0.08
    seen = _recorded(_blurred(light, _camera(8.0, 2.0), 2.0), 1)
    return {"chart.png": write_png(stored(seen, "srgb", np.uint8)[0], None)}


def _focus_pair() -> dict[str, bytes]:
    """Return two photographs, at different focus, of a wall at 1.65 m behind one at 1.45 m."""
    near, far = (_leaves((130 * _POINTS, 200 * _POINTS), 6.0 * _POINTS, seed) for seed in (2, 3))
    mask = np.zeros(near.shape)
    mask[:, : 100 * _POINTS] = 1.0
    files = {}
    for seed, (name, focus) in enumerate({"near": 1.35, "far": 1.8}.items()):
        lens = _camera(8.0, focus)
        front, hidden, back = _blurred(near * mask, lens, 1.45), _blurred(mask, lens, 1.45), _blurred(far, lens, 1.65)
        files[f"{name}.tif"] = write_tiff(_recorded(front + (1.0 - hidden) * back, seed), None)
    return files


def _photo() -> dict[str, bytes]:
    """Return a photograph of two walls, its depth map, and the scene without blur."""
    from lommel.imaging.photograph import depth_of_field

    light = _leaves((160, 200), 3.0, 3)
    depth = np.where(np.arange(200) < 100, 1.8, 2.2) + np.zeros(light.shape)
    lens = _camera(8.0, 2.0)
    files = {
        "photo": _recorded(depth_of_field(light, depth, lens, _PIXEL, encoding="linear", energy=0.99).values, 5),
        "depth": depth.astype(np.float32),
    }
    return {
        f"{name}.tif": write_tiff(values, None)
        for name, values in (files | {"scene": light.astype(np.float32)}).items()
    }


def _beads() -> dict[str, bytes]:
    """Return a stack of a bead of 100 nm on the cover glass."""
    microscope = _microscope("zeiss-63x-1.4-oil")
    wave = Wavefront.zernike({6: 0.06, 8: -0.04}, order="noll", unit="waves")
    z = 200e-9 * (np.arange(11) - 5)
    pupil = microscope.objective.pupil(depth=50e-9, z=z, wavelength=microscope.wavelength, aberrations=wave)
    light = psf(pupil, 31, microscope.pixel, method=Bead(0.1e-6, 1e-4), integrate=True).values
    return {"beads.tif": write_tiff(_counts(4e4 * light + 10.0, 36), None)}


def _stack() -> dict[str, bytes]:
    """Return a stack of a helix in water, 6 um deep."""
    import tifffile

    from lommel.microscopy.stack_blur import StackBlur

    microscope = _microscope("zeiss-63x-1.4-oil")
    step, planes, side = 0.2, 16, 48
    z = 1e-6 * step * np.arange(1 - planes, planes)
    pupil = microscope.objective.pupil(depth=6e-6, z=z, wavelength=microscope.wavelength)
    specimen, turn = np.zeros((side, side, planes), np.float32), np.linspace(0.0, 4.0 * np.pi, 400)
    place = 24.0 + 12.0 * np.sin(turn), 24.0 + 12.0 * np.cos(turn), 4.0 + 7.0 * turn / turn[-1]
    np.add.at(specimen, tuple(np.rint(place).astype(int)), 500.0)
    blur = StackBlur(psf(pupil, 2 * side - 1, microscope.pixel, tol=1e-4), (planes, side, side))
    light = np.moveaxis(blur.forward(specimen), -1, 0)
    sizes = {f"PhysicalSize{axis}": size for axis, size in zip("XYZ", (6.5 / 63, 6.5 / 63, step), strict=True)}
    uuid = "3f0e7a52-0000-5000-8000-000000000001"  # else the file would be another one each time
    file = atomic.contents(
        tifffile.imwrite,
        _counts(np.maximum(light, 0.0) + 5.0, 7),
        ome=True,
        metadata={"axes": "ZYX", "UUID": uuid, **sizes},
    )
    return {"stack.ome.tif": file}


def _molecules() -> dict[str, bytes]:
    """Return a movie of molecules on a ring of 4 um, with z from -0.3 to 0.3 um."""
    microscope, draw, window = _microscope("zeiss-63x-astigmatic"), np.random.default_rng(8), 21
    angle = (2.0 * np.pi * (np.arange(40)[:, None] + draw.random((40, 1))) / 40.0 + [0.0, np.pi]).ravel()
    pitch = microscope.pixel / microscope.objective.magnification
    place = 31.5 + 2e-6 / pitch * np.stack([np.sin(angle), np.cos(angle)], axis=1)
    middle = np.rint(place).astype(int)
    pupil = microscope.objective.pupil(
        depth=microscope.depth,
        z=0.3e-6 * np.sin(3.0 * angle),
        wavelength=microscope.wavelength,
        aberrations=microscope.aberrations,
    )
    centre = tuple((place - middle + window // 2).T)
    mean = np.full((40, 64, 64), 8.0)
    for number, image in enumerate(psf(pupil, window, microscope.pixel, center=centre).values):
        row, column = middle[number] - window // 2
        mean[number // 2, row : row + window, column : column + window] += 2500.0 * image
    return {"movie.tif": write_tiff(_counts(mean, 9), None)}


def _donut() -> dict[str, bytes]:
    """Return a star 6 waves out of focus, with coma of 0.2 waves rms."""
    wave = Wavefront.zernike({7: -0.16, 8: 0.12}, order="noll", unit="waves") + Wavefront(6.0 * np.pi)
    pupil = Pupil(wave, obscuration=0.35, wavelength=550e-9, f_number=10.0)
    light = psf(pupil, 96, 7.6e-6, blur=Jitter(8e-6), tol=1e-4).values
    return {"donut.tif": write_tiff(_counts(4e5 * light + 10.0, 1), None)}


def _stars() -> dict[str, bytes]:
    """Return a point of light at three sensor positions, by the phone's lens with astigmatism and coma."""
    phone = load_instrument(example_files()["phone"])
    wave = Wavefront.zernike({6: 0.6, 8: -0.4}, order="noll") + Wavefront([-4.0, 0.0, 4.0])
    light = psf(phone.pupil().carrying(wave, None), 33, phone.pixel).values
    return {f"star-{k}.tif": write_tiff(_counts(5e4 * one + 20.0, k), None) for k, one in enumerate(light, 1)}


def _camera(f_number: float, focus: float) -> Lens:
    return load_instrument(example_files()["nifty-fifty"]).lens.stopped(f_number).focused(focus)


def _blurred(light: Array, lens: Lens, distance: float) -> Array:
    """Return the mean light of each pixel of a plane, of some points along a pixel."""
    from scipy.signal import fftconvolve

    kernel = psf(lens.pupil(distance), 40 * _POINTS + 1, _PIXEL / _POINTS).values
    seen = fftconvolve(np.pad(light, 20 * _POINTS, "reflect"), kernel / kernel.sum(), mode="valid")
    pixels: Array = seen.reshape(seen.shape[0] // _POINTS, _POINTS, -1, _POINTS).mean(axis=(1, 3))
    return pixels


def _recorded(light: Array, seed: int) -> Values:
    """Return a photograph with noise, linear in light."""
    return np.clip(_WHITE.record(1e4 * np.maximum(light, 0.0), seed), 0.0, 1.0).astype(np.float32)


def _leaves(shape: tuple[int, int], least: float, seed: int) -> Array:
    """Return a texture of overlapping discs from a least radius on."""
    draw, light = np.random.default_rng(seed), np.full(shape, 0.4)
    y, x = np.ogrid[: shape[0], : shape[1]]
    for _ in range(int(0.4 * light.size / least**2)):
        radius = least / np.sqrt(1.0 - 0.98 * draw.random())
        middle = draw.uniform(0.0, shape)
        rows, columns = (slice(max(int(at - radius), 0), int(at + radius) + 2) for at in middle)
        inside = (y[rows] - middle[0]) ** 2 + (x[:, columns] - middle[1]) ** 2 < radius**2
        light[rows, columns][inside] = draw.uniform(0.1, 0.7)
    return light


def _microscope(name: str) -> Microscope:
    return load_microscope(example_files()[name])


def _counts(electrons: Array, seed: int) -> Values:
    return np.rint(_SCMOS.record(electrons, seed)).clip(0, 65535).astype(np.uint16)


_PHOTO = "nifty-fifty.toml --f-number 8"
_CAMERA = "--read 1.6 --offset 100"

SETS = {
    "chart": DataSet(
        "slanted squares, for lommel sfr",
        _chart,
        "nifty-fifty",
        ("lommel sfr chart.png --lens nifty-fifty.toml --f-number 8 --object-distance 2m",),
        "MTF50 0.267 cycles/pixel at all edges, that of the lens with the pixel",
    ),
    "focus-pair": DataSet(
        "two photographs of different focus, for lommel depth",
        _focus_pair,
        "nifty-fifty",
        (
            f"lommel depth near.tif far.tif {_PHOTO} --focus 1.35m --focus 1.8m --between 1.2m 2m --white 10000 "
            "--read 3 -o distances.tif",
        ),
        "1.45 m in the left half, 1.65 m in the right half",
    ),
    "photo": DataSet(
        "a photograph and its depth map, for lommel restore and blur",
        _photo,
        "nifty-fifty",
        (
            f"lommel restore photo.tif depth.tif {_PHOTO} --white 10000 --read 3 -o sharp.tif",
            f"lommel blur scene.tif depth.tif {_PHOTO} -o blurred.tif",
        ),
        "scene.tif is the scene without blur, photo.tif what the camera records of it: the blur with noise",
    ),
    "beads": DataSet(
        "a bead in a microscope, for lommel beads",
        _beads,
        "zeiss-63x-1.4-oil",
        (
            f"lommel beads beads.tif zeiss-63x-1.4-oil.toml --step 200nm --bead 0.1um {_CAMERA} --terms 7 "
            "-o fitted.toml",
        ),
        "NA 1.4, sample 1.33; astigmatism 0 (Noll 6) 0.377 rad, coma x (Noll 8) -0.251 rad, other terms 0",
    ),
    "stack": DataSet(
        "a stack of a helix in water, for lommel deconvolve",
        _stack,
        "zeiss-63x-1.4-oil",
        (
            f"lommel deconvolve stack.ome.tif zeiss-63x-1.4-oil.toml --depth 6um {_CAMERA} --gain 1 "
            "-o restored.ome.tif",
        ),
        "a helix of two turns and radius 1.24 um in planes 4 to 11; background 5 electrons",
    ),
    "molecules": DataSet(
        "a movie of single molecules, for lommel localize",
        _molecules,
        "zeiss-63x-astigmatic",
        (f"lommel localize movie.tif zeiss-63x-astigmatic.toml {_CAMERA} --gain 1 -o molecules.csv",),
        "80 molecules of 2500 photons on a ring of radius 2 um about x = y = 3.302 um, z = 300 nm sin(3 angle)",
    ),
    "donut": DataSet(
        "a defocused star in a telescope, for lommel collimate",
        _donut,
        None,
        ("lommel collimate donut.tif --aperture 200mm --focal-length 2m --pixel 7.6um --obscuration 0.35",),
        "coma 0.200 waves rms towards 1 o'clock (53 degrees); 6 waves inside focus",
    ),
    "stars": DataSet(
        "a point of light at three sensor positions, for lommel retrieve",
        _stars,
        "phone",
        (f"lommel retrieve star-1.tif star-2.tif star-3.tif phone.toml --defocus -4 0 4 {_CAMERA} --gain 1",),
        "astigmatism 0 (Noll 6) 0.600 rad, coma x (Noll 8) -0.400 rad, other terms 0",
    ),
}
"""Data sets by name."""
