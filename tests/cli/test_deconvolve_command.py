"""The command that restores a stack, from a file that tifffile wrote to one that tifffile reads."""

from __future__ import annotations

import json
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, nullcontext

import numpy as np
import pytest
import tifffile
import zarr

from lommel.cli.deconvolve_command import StackCamera
from lommel.microscopy import refinement

OBJECTIVE = """
[objective]
NA = 1.4
magnification = 60
working_distance = "0.2 mm"
immersion = 1.515
[coverslip]
index = 1.5255
thickness = "170 um"
[sample]
index = 1.33
depth = "8 um"
[emission]
wavelength = "520 nm"
[sensor]
pixel = "6.5 um"
"""


@pytest.fixture
def files(tmp_path):
    z, y, x = np.indices((9, 24, 24)) - np.array([4, 12, 12])[:, None, None, None]
    spot = 500.0 * np.exp(-(x**2 + y**2) / 8.0 - z**2 / 6.0)
    stack = (np.random.default_rng(0).poisson(20.0 + spot) + 100).astype(np.uint16)
    fields = {"axes": "ZYX", "PhysicalSizeX": 0.108, "PhysicalSizeY": 0.108, "PhysicalSizeZ": 0.25}
    tifffile.imwrite(tmp_path / "stack.ome.tif", stack, ome=True, metadata=fields)
    tifffile.imwrite(tmp_path / "plain.tif", stack, photometric="minisblack")
    tifffile.imwrite(
        tmp_path / "movie.ome.tif", np.stack([stack, stack]), ome=True, metadata=fields | {"axes": "TZYX"}
    )
    (tmp_path / "lens.toml").write_text(OBJECTIVE)
    (tmp_path / "confocal.toml").write_text(f'{OBJECTIVE}[modality]\nkind = "confocal"\n')
    return tmp_path


@pytest.fixture
def run(call_lommel, files):
    return lambda *words: call_lommel("deconvolve", *words, folder=files)


CAMERA = ("--gain", 1, "--read", 1.6, "--offset", 100, "--steps", 3, "--no-diagnosis")


def test_all_time_points_are_restored_unless_one_is_given(run, files):
    found = run("movie.ome.tif", "lens.toml", *CAMERA, "--direction", "up", "-o", "all.ome.tif")
    assert "2 time points" in found.stdout + found.stderr
    run("movie.ome.tif", "lens.toml", *CAMERA, "--direction", "up", "--time", 1, "-o", "one.ome.tif")
    with tifffile.TiffFile(files / "all.ome.tif") as everything, tifffile.TiffFile(files / "one.ome.tif") as one:
        assert everything.series[0].axes == "TZYX"
        assert one.series[0].axes == "ZYX"
        np.testing.assert_array_equal(everything.asarray()[1], one.asarray())


def test_a_stack_is_restored_from_file_to_file(run, files, monkeypatch):
    monkeypatch.setattr(refinement, "_STEPS", 4)  # of each of both directions
    there = files / "restored.ome.tif"
    picture = files / "restored.png"
    found = run(files / "stack.ome.tif", files / "lens.toml", *CAMERA, "-o", there, "--plot", picture)
    assert found.returncode == 3, found.stderr  # three steps leave more than the noise
    assert f"wrote {picture}" in " ".join(found.stdout.split())
    assert picture.read_bytes().startswith(b"\x89PNG")
    assert "From the OME metadata of the file: 108 nm pixels, 250 nm planes apart." in found.stdout
    assert "The wavelength of the objective file, 520 nm, was used." in found.stdout
    with tifffile.TiffFile(there) as file:
        assert file.asarray().shape == (9, 24, 24)
        assert 'PhysicalSizeZ="0.25"' in file.ome_metadata


def test_a_gain_of_1_beside_a_known_read_noise_is_an_assumption():
    with pytest.warns(UserWarning, match="No gain is known: 1 electron per count was assumed"):
        assert StackCamera(read=1.6).noise().white is None


def test_a_stack_of_beads_is_the_psf(run, files):
    """The bead stack, of other voxels, is found and resampled; nothing else is computed from the objective file."""
    z, y, x = np.indices((11, 31, 31)) - np.array([5, 15, 15])[:, None, None, None]
    bead = 40.0 + 1e4 * np.exp(-(x**2 + y**2) / 8.0 - z**2 / 6.0)
    np.save(files / "beads.npy", np.random.default_rng(0).poisson(bead))
    words = (files / "stack.ome.tif", files / "lens.toml", *CAMERA, "-o", files / "restored.ome.tif")
    measured = ("--psf", files / "beads.npy", "--bead", "0.1um")
    found = run(*words, *measured, "--psf-pixel", "0.1um", "--psf-step", "0.2um", "--json")
    assert found.returncode == 3, found.stderr  # three steps leave more than the noise
    findings = [finding for finding in json.loads(found.stdout)["findings"] if finding["code"] == "measured_psf"]
    assert [finding["numbers"]["pixel"] for finding in findings] == [pytest.approx(1e-7)] * 2
    assert "the diameter of 100 nm was removed" in findings[0]["text"]
    assert "must be stated (--psf-pixel)" in run(*words, *measured).stderr
    assert "need --psf" in run(*words, "--bead", "0.1um").stderr
    early = run(*words, "--psf", files / "no-such-file.npy", "--wavelength", "520nm").stderr
    assert "--wavelength must not be given with a PSF, which has its own light" in early
    alone = [word for word in words if word != files / "lens.toml"]
    facts = {"spacing": 0.22, "unit": "um", "axes": "ZYX"}
    tifffile.imwrite(
        files / "beads.tif", np.load(files / "beads.npy").astype(np.float32), imagej=True, metadata=facts
    )
    stated = ("--psf", files / "beads.tif", "--psf-pixel", "0.1um", "--psf-step", "0.2um")
    found = run(*alone, *stated, "--json")
    texts = {finding["text"]: finding["severity"] for finding in json.loads(found.stdout)["findings"]}
    assert any("the PSF was resampled" in text for text in texts)
    doubt = "the images of the PSF state planes 220 nm apart, but 200 nm was used, and lengths of the PSF along z are"
    assert [severity for text, severity in texts.items() if text.startswith(f"{doubt} 0.909 times")] == ["doubt"]
    assert found.stderr.count(f"Note: T{doubt[1:]}") == 1
    assert "LENS is missing: give the file of the objective, or --psf" in run(*alone).stderr


def test_memory_is_in_gigabytes(run):
    found = run("stack.ome.tif", "lens.toml", "--memory", "300MB", "-o", "restored.ome.tif")
    assert found.returncode == 2
    assert found.stderr.endswith("--memory: must be a number of gigabytes, such as 0.3, got '300MB'\n")


def test_json_and_zarr(run, files):
    there = files / "restored.ome.zarr"
    words = (files / "stack.ome.tif", files / "lens.toml", *CAMERA, "--direction", "up", "--json", "-o", there)
    found = run(*words, "--background", 0)
    assert found.returncode == 3, found.stderr
    (channel,) = json.loads(found.stdout)["channels"]
    assert (channel["steps"], channel["background"], channel["strength"]) == (3, 0.0, None)
    assert channel["discrepancy"] < channel["before"]
    assert (channel["name"], channel["wavelength"]) == ("channel 0", pytest.approx(520e-9))
    assert (there / ".zattrs").exists()


def test_a_cluster_gives_the_same_values(run, files, monkeypatch):
    @contextmanager
    def connected(address):
        with nullcontext() if address is None else ThreadPoolExecutor(2) as client:
            yield client

    monkeypatch.setattr("lommel.cli.deconvolve_command.connected", connected)
    words = ["stack.ome.tif", "lens.toml", *CAMERA, "--direction", "up"]
    cluster = ["--client", "tcp://scheduler:8786"]
    facts = []
    for more in (["-o", "a.ome.zarr"], ["-o", "b.ome.zarr", *cluster]):
        result = run(*words, "--json", *more)
        assert result.stderr == ""
        facts.append(json.loads(result.stdout) | {"seconds": 0.0, "files": []})
    assert facts[0] == facts[1]
    values = [zarr.open(str(files / name), mode="r")["0"][...] for name in ("a.ome.zarr", "b.ome.zarr")]
    np.testing.assert_array_equal(*values)
    for others in (["-o", "c.ome.tif"], ["-o", "c.ome.zarr", "-o", "c.ome.tif"]):
        refused = run(*words, *others, *cluster)
        assert refused.returncode == 2
        assert "--client needs a single output, NAME.ome.zarr" in refused.stderr


def test_total_variation_and_an_uneven_background_are_asked_for(run, files):
    words = (files / "stack.ome.tif", files / "lens.toml", *CAMERA, "--direction", "up", "--json")
    way = ("--method", "total-variation", "--strength", 0.02, "--background", "uneven")
    found = run(*words, *way, "-o", files / "restored.ome.tif")
    assert found.returncode == 3, found.stderr
    answer = json.loads(found.stdout)
    assert (answer["status"], answer["converged"]) == ("not_settled", False)  # after three steps
    (channel,) = answer["channels"]
    assert channel["strength"] == 0.02
    assert 10.0 < channel["background"] < 40.0
    for more, said in ((("--strength", 1), "needs --method"), (("--background", "x"), '"uneven", or the light')):
        assert said in run(*words, *more, "-o", files / "restored.ome.tif").stderr


def test_a_misfit_is_written_and_has_an_exit_code_of_its_own(run, files):
    there = files / "restored.ome.tif"
    words = (files / "stack.ome.tif", files / "lens.toml", "--gain", 1, "--read", 90, "--offset", 100)
    found = run(*words, "--direction", "up", "-o", there)
    assert found.returncode == 3, found.stderr
    assert "too quiet: the stack is quieter than its noise" in " ".join(found.stdout.split())
    assert there.exists()


@pytest.mark.parametrize(("output", "kept"), [("a.ome.zarr", True), ("a.ome.tif", False)])
def test_after_ctrl_c_it_is_said_whether_chunks_are_kept(run, files, monkeypatch, output, kept):
    def interrupted(*_, **__):
        raise KeyboardInterrupt

    monkeypatch.setattr("lommel.cli.deconvolve_command.run", interrupted)
    found = run(files / "stack.ome.tif", files / "lens.toml", "-o", files / output)
    assert found.returncode == 1
    assert ("the same command resumes" in found.stderr) == kept
