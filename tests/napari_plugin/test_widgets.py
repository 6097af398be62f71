"""The plugin in a real napari: manifest, sample data, reader and widget. Needs napari, Qt and a display."""

from __future__ import annotations

import os
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import lommel as lm

pytest.importorskip("napari")
if sys.platform == "linux" and not os.environ.get("DISPLAY"):
    pytest.skip("napari needs a display: xvfb-run", allow_module_level=True)

ROOT = Path(__file__).resolve().parents[2]
pytestmark = pytest.mark.filterwarnings("default")


@pytest.fixture(scope="module")
def viewer():
    import napari
    from npe2 import PluginManager

    PluginManager.instance().discover()
    made = napari.Viewer(show=False)
    yield made
    made.close()


def wait(condition, seconds: float = 120.0) -> None:
    """Let the windows work until a condition holds."""
    from qtpy.QtWidgets import QApplication

    end = time.monotonic() + seconds
    while not condition():
        QApplication.processEvents()
        time.sleep(0.01)
        assert time.monotonic() < end, "the widget did not finish"


def panel_of(viewer):
    _, widget = viewer.window.add_plugin_dock_widget("lommel", "Deconvolution")
    return widget.panel


def test_napari_finds_the_manifest_and_its_contributions(viewer):
    from npe2 import PluginManager

    manifest = PluginManager.instance().get_manifest("lommel")
    assert [part.display_name for part in manifest.contributions.widgets] == ["Deconvolution"]
    assert [part.key for part in manifest.contributions.sample_data] == ["beads"]


def test_a_psf_file_opens_with_its_voxels(viewer, tmp_path):
    from lommel.napari_plugin import contributions

    data, options, _ = contributions.beads()[1]
    options["metadata"]["lommel"].save(tmp_path / "psf.ome.tif")
    (layer,) = viewer.open(tmp_path / "psf.ome.tif", plugin="lommel")
    np.testing.assert_array_equal(layer.data, data)
    assert tuple(layer.scale) == pytest.approx((0.2, 6.5 / 63, 6.5 / 63))
    viewer.layers.clear()


def test_the_deconvolution_widget_restores_the_sample_by_depth_as_the_command_does(viewer):
    viewer.open_sample("lommel", "beads")
    panel = panel_of(viewer)
    fields = {one.label: one for one in panel.widget if hasattr(one, "label")}
    assert fields["pixel in sample (nm)"].value == pytest.approx(6500 / 63, abs=0.01)
    assert fields["step (nm)"].value == 200.0
    fields["depth (um)"].value = 6.0
    fields["steps at most"].value = 4
    panel.start()
    wait(lambda: panel.run.enabled)
    found = viewer.layers["beads deconvolved"]
    assert panel.status.value.startswith("4 steps, discrepancy "), panel.status.value
    assert "The noise was estimated from the stack" in " ".join(panel.status.value.split())
    microscope = lm.load_microscope(lm.example_files()["zeiss-63x-1.4-oil"])
    given = {"pixel": 6.5e-6, "step": 200e-9, "depth": 6e-6, "wavelength": microscope.wavelength}
    way = lm.imaging.RichardsonLucy(steps=4, target=1.0)
    truth = lm.microscopy.deconvolve(viewer.layers["beads"].data, microscope, method=way, **given)
    np.testing.assert_allclose(found.data, truth.values, rtol=1e-3, atol=1e-2)
    viewer.layers.clear()


def test_the_stack_of_another_package_opens_with_its_voxels_and_is_restored(viewer):
    (layer,) = viewer.open(ROOT / "tests" / "truth" / "microsim.ome.tif", plugin="lommel")
    assert tuple(layer.scale) == pytest.approx((0.35, 6.5 / 60, 6.5 / 60))
    panel = panel_of(viewer)
    fields = {one.label: one for one in panel.widget if hasattr(one, "label")}
    fields["objective"].value = "nikon-60x-1.27-water"  # of another wavelength
    assert fields["wavelength (nm)"].value == pytest.approx(520.0)
    assert fields["step (nm)"].value == pytest.approx(350.0)
    fields["steps at most"].value = 2
    panel.start()
    wait(lambda: panel.run.enabled)
    assert panel.status.value.startswith("2 steps, discrepancy "), panel.status.value
    assert tuple(viewer.layers["microsim deconvolved"].scale) == tuple(layer.scale)
    viewer.layers.clear()


def test_the_deconvolution_widget_takes_a_psf_of_its_own_and_can_be_stopped(viewer):
    panel = panel_of(viewer)
    panel.start()
    assert panel.status.value.startswith("open a stack")
    viewer.open_sample("lommel", "beads")
    fields = {one.label: one for one in panel.widget if hasattr(one, "label")}
    assert fields["stack"].value == "beads"
    fields["PSF"].value = "PSF of the beads"
    fields["camera"].value = "hamamatsu-orca-flash4-v3"
    assert fields["offset (counts)"].value == 100.0
    fields["steps at most"].value = 12
    shares = []
    panel.bar.changed.connect(shares.append)
    panel.start()
    wait(lambda: panel.run.enabled)
    found = viewer.layers["beads deconvolved"]
    assert panel.status.value.startswith("12 steps, discrepancy "), panel.status.value
    assert len(set(shares)) > 3
    assert tuple(found.scale) == tuple(viewer.layers["beads"].scale)
    # As sharp as the library makes it.
    noise = lm.load_camera("hamamatsu-orca-flash4-v3").noise
    kernel = viewer.layers["PSF of the beads"].metadata["lommel"]
    method = lm.imaging.RichardsonLucy(steps=12, target=1.0)
    truth = lm.microscopy.deconvolve(viewer.layers["beads"].data, kernel, noise=noise, method=method)
    np.testing.assert_allclose(found.data, truth.values, rtol=1e-4, atol=1e-3)
    fields["steps at most"].value = 1000
    panel.start()
    wait(lambda: panel.bar.value > 0 or panel.run.enabled)
    panel.stop()
    wait(lambda: panel.run.enabled)
    assert panel.status.value == "cancelled"
    assert "beads deconvolved [1]" not in viewer.layers
    viewer.layers.clear()


def test_errors_of_the_library_are_told_in_the_widget(viewer, monkeypatch):
    from lommel.napari_plugin import contributions

    def refuse(*_: object, **__: object) -> None:
        raise ValueError("the stack must have more planes")

    monkeypatch.setattr(contributions, "deconvolve", refuse)
    viewer.open_sample("lommel", "beads")
    panel = panel_of(viewer)
    panel.start()
    wait(lambda: panel.run.enabled)
    assert panel.status.value == "the stack must have more planes"
    viewer.layers.clear()
