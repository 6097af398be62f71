"""Jobs larger than memory on two workers of a cluster: CPU time per frame or voxel at two sizes, memory, and bits.

`python -m benchmarks.scale` writes a movie of 10^5 frames of 64 x 64 and a stack of 100 x 1024 x 1024, by chunks,
to Zarr in a temporary folder, localises molecules and deconvolves in 3 steps, and blurs 24 photographs of 1632 x 1224
pixels with their depth maps, on two workers of 700 MB each; before that, movie and stack of a hundredth of the size
and 4 photographs. `--small` measures only those, and compares them with one process. `--only` movie, stack or
pictures measures one of them. Memory is the most that a process ever had.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import tempfile
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from typing import Any

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy as np

import lommel as lm
from benchmarks.deconvolution import OIL, PIXEL, WAVE, most

CAMERA, LIMIT, SIDE, EACH = lm.Noise(white=0.46, read=1.6, offset=100.0), "700MB", 64, 3
PHOTOS, PHOTO = (4, 24), (1224, 1632)
FRAMES, STACK, CHUNK = (1_000, 100_000), ((25, 164, 256), (100, 1024, 1024)), 1000


def table() -> lm.localize.Table:
    """Return the table of an astigmatic oil objective, 1 um deep."""
    astigmatism = lm.Wavefront.zernike({6: 0.15}, order="noll", unit="waves")
    pupil = OIL.pupil(depth=1e-6, wavelength=600e-9, aberrations=astigmatism)
    return lm.localize.Table(pupil, shape=11, pixel=PIXEL, z=(-0.4e-6, 0.4e-6), reach=1.0, tol=1e-3)


def write_movie(path: Path, frames: int) -> None:
    """Write a movie, `EACH` molecules in each frame, to an array of Zarr."""
    import zarr

    images, array = (
        table(),
        zarr.create_array(path, shape=(frames, SIDE, SIDE), chunks=(CHUNK, SIDE, SIDE), dtype="u2"),
    )
    for first in range(0, frames, CHUNK):
        random = np.random.default_rng(first)
        light = np.full((min(CHUNK, frames - first), SIDE, SIDE), 8.0)
        frame = np.repeat(np.arange(len(light)), EACH)[:, None, None]
        row, column = random.integers(8, SIDE - 8, (2, frame.size))
        row_shift, column_shift = random.uniform(-0.5, 0.5, (2, frame.size))
        spots = images(5 + row_shift, 5 + column_shift, random.uniform(-3e-7, 3e-7, frame.size))
        down, across = row[:, None, None] + np.arange(-5, 6)[:, None], column[:, None, None] + np.arange(-5, 6)
        np.add.at(light, (frame, down, across), random.uniform(1500.0, 3000.0, frame.size)[:, None, None] * spots)
        array[first : first + len(light)] = np.clip(np.rint(CAMERA.record(light, first)), 0, 65535)


def localised(path: Path, client: Any) -> str:
    """Return a checksum of the localisations of a movie."""
    import zarr

    digest = hashlib.sha256()
    for part in lm.localize.localize_blocks(zarr.open_array(path, mode="r"), table(), noise=CAMERA, client=client):
        digest.update(part.table.tobytes())
    return digest.hexdigest()


def write_stack(path: Path, shape: tuple[int, int, int]) -> None:
    """Write a stack of points on a background to an array of Zarr."""
    import zarr

    array = zarr.create_array(path, shape=shape, chunks=(1, *shape[1:]), dtype="u2")
    for plane in range(shape[0]):
        random = np.random.default_rng(plane)
        light = np.full(shape[1:], 20.0)
        light[random.random(shape[1:]) < 1e-3] += 5000.0
        array[plane] = np.clip(np.rint(CAMERA.record(light, plane)), 0, 65535)


def deconvolved(path: Path, client: Any) -> str:
    """Return a checksum of a restored stack."""
    import zarr

    out = path.with_name(f"{path.stem}-{'here' if client is None else 'there'}.ome.zarr")
    given: dict[str, Any] = {"pixel": PIXEL, "step": 0.3e-6, "wavelength": WAVE, "noise": CAMERA, "memory": 3e8}
    method = lm.imaging.RichardsonLucy(steps=3, target=0.0)
    given |= {"method": method, "diagnosis": False, "direction": "up", "depth": 5e-6}
    lm.microscopy.deconvolve(zarr.open_array(path, mode="r"), OIL, out=out, client=client, **given)
    array, digest = zarr.open_group(out, mode="r")["0"], hashlib.sha256()
    for plane in range(array.shape[-3]):
        digest.update(np.ascontiguousarray(array[..., plane, :, :]).tobytes())
    return digest.hexdigest()


def write_photos(path: Path, count: int) -> None:
    """Write photographs of a random texture in colour, each with a depth map of a ground from 1 m to 10 m."""
    from PIL import Image

    ground = 1.0 / np.linspace(0.1, 1.0, PHOTO[0])[:, None] + np.zeros(PHOTO)
    for name in ("sharp", "far"):
        (path / name).mkdir(parents=True)
    for number in range(count):
        texture = np.random.default_rng(number).integers(0, 256, (PHOTO[0] // 8, PHOTO[1] // 8, 3), dtype=np.uint8)
        Image.fromarray(texture).resize(PHOTO[::-1]).save(path / "sharp" / f"{number}.png")
        np.save(path / "far" / f"{number}.npy", ground.astype(np.float32))


def rendered(path: Path, client: Any) -> str:
    """Return a checksum of the files of a data set, without a client of as many processes as processors."""
    lenses = lm.imaging.LensRanges(
        focal_length=(24e-3, 50e-3), f_number=(1.8, 8.0), focus_distance=(1.0, np.inf), pixel=10e-6
    )
    out = path / ("here" if client is None else "there")
    photos = sorted((path / "sharp").iterdir(), key=lambda file: int(file.stem))
    depths = [path / "far" / f"{photo.stem}.npy" for photo in photos]
    options = lm.imaging.DatasetOptions(
        noise=lm.Noise(white=5000, read=3.0), client=client, workers=(os.cpu_count() or 1) if client is None else 1
    )
    list(lm.imaging.render_dataset(photos, depths, out, lenses, seed=1, options=options))
    # The facts of a picture have the checksums of its files.
    return hashlib.sha256(b"".join(facts.read_bytes() for facts in sorted(out.glob("0*.json")))).hexdigest()


def measured(job: Callable[[Path, Any], str], path: Path) -> dict[str, Any]:
    """Return checksum, CPU seconds of client and workers, and megabytes of the client and the larger worker."""
    import distributed

    with (
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, memory_limit=LIMIT, dashboard_address=None
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        begun, workers_begun = time.process_time(), sum(client.run(time.process_time).values())
        checksum = job(path, client)
        return {
            "checksum": checksum,
            "CPU seconds of the workers": sum(client.run(time.process_time).values()) - workers_begun,
            "of the client": time.process_time() - begun,
            "memory of a worker, MB": max(client.run(most).values()),
            "of the client, MB": most(),
        }


def apart(function: Callable[..., Any], *given: Any) -> Any:
    """Return the result of a function, in a process of its own: memory is that of one job."""
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
        return pool.submit(function, *given).result()


def main() -> None:
    """Measure, and print as JSON."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--small", action="store_true", help="a hundredth of the sizes, beside one process")
    parser.add_argument("--only", choices=("movie", "stack", "pictures"), help="one of them")
    options = parser.parse_args()
    jobs: dict[str, tuple[Any, ...]] = {
        "movie": (write_movie, localised, FRAMES, [float(count) for count in FRAMES]),
        "stack": (write_stack, deconvolved, STACK, [float(np.prod(shape)) for shape in STACK]),
        "pictures": (write_photos, rendered, PHOTOS, [float(count) for count in PHOTOS]),
    }
    found: dict[str, Any] = {}
    for name in [options.only] if options.only else list(jobs):
        write, job, sizes, counts = jobs[name]
        costs = []
        for size, count in list(zip(sizes, counts, strict=True))[: 1 if options.small else 2]:
            with tempfile.TemporaryDirectory() as folder:
                path = Path(folder) / f"{name}.zarr"
                apart(write, path, size)
                made = found[f"{name} of {size}"] = apart(measured, job, path)
                made["same bits as one process"] = (
                    apart(job, path, None) == made["checksum"] if options.small else None
                )
                costs.append((made["CPU seconds of the workers"] + made["of the client"]) / count)
        if len(costs) == 2:
            found[f"cost of a part of the {name}, over that of the smaller"] = costs[1] / costs[0]
    print(json.dumps(found, indent=2))


if __name__ == "__main__":
    main()
