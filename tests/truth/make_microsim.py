"""Record ``microsim.ome.tif`` and ``microsim-beads.tif``, stacks that microsim simulates and other packages write.

microsim 0.0.12 (Talley Lambert and others, BSD-3-Clause) computes the image of fluorophores by the vectorial model of
Gibson and Lanni, with a camera. The first stack, three beads in water over a level of 20 electrons, is written as
OME-TIFF by bioio-ome-tiff 1.4 with ome-types, the second, one bead in steps of 100 nm, by microsim itself, without
metadata. ``microsim.json`` has what is true of them: voxels of the beads, and photons in the middle plane before the
camera.

Usage, in an environment of its own (the versions of zarr that the two packages ask for exclude each other, which does
no harm here)::

    pip install microsim==0.0.12.post0 tifffile==2026.3.3
    pip install bioio-ome-tiff==1.4.0 "numpy<2"
    python tests/truth/make_microsim.py
"""

import json
import os
from pathlib import Path

os.environ["MICROSIM_CACHE"] = "0"  # nothing is kept in the home directory

import microsim.schema as ms
import numpy as np
from bioio_base.types import PhysicalPixelSizes
from bioio_ome_tiff.writers import OmeTiffWriter
from microsim.schema.optical_config import OpticalConfig
from microsim.schema.optical_config.filter import Bandpass

HERE = Path(__file__).parent
PIXEL, FINE = 6.5 / 60, 3  # of a camera, micrometres in the sample; steps of the simulation in one of them
LENS = ms.ObjectiveLens(
    na=1.2, numerical_aperture=1.2,  # the second name alone is checked, the first alone is used
    coverslip_ri=1.5255, coverslip_ri_spec=1.5255,
    immersion_medium_ri=1.333, immersion_medium_ri_spec=1.333, specimen_ri=1.33,
)  # fmt: skip
GFP = OpticalConfig(
    name="GFP",
    filters=[
        Bandpass(bandcenter=488, bandwidth=10, placement="EX"),
        Bandpass(bandcenter=520, bandwidth=4, placement="EM"),
    ],
)
CAMERA = ms.CameraCMOS(read_noise=1.6, full_well=30000, bit_depth=16, offset=100, dark_current=200.0, qe=0.8)
# Plane, row and column of the camera, light. Between pixels by a third where they end in .33 or .67.
BEADS = [(4, 8, 10.33, 3.0), (8, 15.67, 19, 4.0), (11, 20, 8, 2.0)]


def simulated(beads, planes, step, side, around, output=None):
    """Return the simulation of beads in a field of so many pixels, and as many around it."""
    field = FINE * (side + 2 * around)
    truth = np.zeros((planes, field, field), np.float32)
    for plane, row, column, light in beads:
        truth[plane, *(round(FINE * (at + around)) + FINE // 2 for at in (row, column))] = 1e5 * light
    return ms.Simulation.from_ground_truth(
        truth,
        (step, PIXEL / FINE, PIXEL / FINE),
        output_space={"downscale": (1, FINE, FINE)},
        objective_lens=LENS,
        channels=[GFP],
        detector=CAMERA,
        exposure_ms=100.0,
        output_path=output,
        settings=ms.Settings(random_seed=0, max_psf_radius_aus=None, np_backend="numpy"),
    )


def stack():
    """Record beads in a volume, and return what is true of them."""
    planes, side, step = 16, 28, 0.35
    inside = {"y": slice(side, 2 * side), "x": slice(side, 2 * side)}
    recorded = simulated(BEADS, planes, step, side, side).digital_image().isel(inside)
    sizes = PhysicalPixelSizes(step, PIXEL, PIXEL)
    values = np.asarray(recorded.data)
    said = OmeTiffWriter.build_ome(
        [values.shape],
        [values.dtype],
        dimension_order=["CZYX"],
        channel_names=[["GFP"]],
        image_name=["beads"],
        physical_pixel_sizes=[sizes],
    )
    said.images[0].pixels.channels[0].emission_wavelength = 520.0
    OmeTiffWriter.save(values, HERE / "microsim.ome.tif", dim_order="CZYX", ome_xml=said)
    true = []
    for bead in BEADS:
        alone = simulated([bead], planes, step, side, side).digital_image(with_detector_noise=False)
        true.append({"voxel": bead[:3], "photons": round(float(alone.data[0, bead[0]].sum()), 1)})
    return true


def bead():
    """Record one bead in steps of 100 nm, as microsim writes it, and return what is true of it."""
    planes, side, middle = 24, 33, (12, 16, 16, 4.0)
    seen = simulated([middle], planes, 0.1, side, 0, HERE / "microsim-beads.tif")
    seen.run()
    photons = float(seen.digital_image(with_detector_noise=False).data[0, middle[0]].sum())
    # What falls beside so small a field, a wider one tells.
    wide = simulated([middle], planes, 0.1, side, side).digital_image(with_detector_noise=False).data[0, middle[0]]
    share = float(wide[side : 2 * side, side : 2 * side].sum() / wide.sum())
    return {"voxel": middle[:3], "photons": round(photons / share, 1)}


if __name__ == "__main__":
    true = {"stack": stack(), "bead": bead()}
    (HERE / "microsim.json").write_text(json.dumps(true, indent=1) + "\n", encoding="utf-8")
