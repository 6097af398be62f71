"""What an installed wheel must do on its own: run by tests/test_packaging.py, and by cibuildwheel for each one."""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tempfile
from importlib import metadata
from pathlib import Path
from typing import Any

import numpy as np

import lommel as lm


def main() -> None:
    """Fail with a traceback where something is missing, else print a line."""
    home = Path(lm.__file__).resolve().parent
    assert "site-packages" in home.parts, f"{home} is no installed package"
    answer = lm.psf(lm.Pupil(lm.Wavefront(defocus=3.0)), 33, 0.25, dtype="float64")
    # Lommel's series is in Python alone and shares nothing with the compiled core.
    apart = np.abs(answer.values - lm.psf(answer.pupil, 33, 0.25, method="lommel-series", dtype="float64").values)
    assert apart.max() <= answer.error_bound * answer.values.max() + 1e-13
    first_psf()
    assert (home / "py.typed").is_file()
    assert (home / "_core.pyi").is_file()
    assert (home / "page" / "lommel-live.js").is_file()
    files = lm.example_files()
    assert {"phone", "hubble-1990", "zeiss-63x-1.4-oil", "exercises", "first-psf"} <= set(files)
    assert all(path.is_relative_to(home) for path in files.values())
    told = command("--version").stdout
    assert metadata.version("lommel") in told, told
    if "--no-cli" not in sys.argv:
        with tempfile.TemporaryDirectory() as folder:
            command("examples", "phone", "-o", folder)
            facts = json.loads(command("info", str(Path(folder) / "phone.toml"), "--json").stdout)
            assert abs(facts["f_number"] - 1.8) < 1e-9
    print(f"lommel {metadata.version('lommel')} of {home} works, within {answer.error_bound:.2g} of the peak")


def first_psf() -> None:
    """Compute the first PSF of README.md, without its plot, which takes Matplotlib."""
    text = Path(__file__).resolve().parents[2].joinpath("README.md").read_text(encoding="utf-8")
    found = re.search(r"^## First PSF\n+```python\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    assert found, "README.md has no first PSF"
    names: dict[str, Any] = {}
    exec("\n".join(line for line in found[1].splitlines() if "plot" not in line), names)
    psf = names["psf"]
    assert psf.values.shape == (101, 101)
    assert 0.0 < psf.error_bound <= 1e-6
    # Nearly all of the light of a disc of half the window, the more of it the larger the radius.
    assert 0.97 < psf.values.sum() < 1.0
    assert 0.0 < psf.energy_diameter(0.8) < 101 * 0.5e-6


def command(*words: str) -> subprocess.CompletedProcess[str]:
    """Run lommel as the wheel has it."""
    script = Path(sys.executable).with_name("lommel.exe" if sys.platform == "win32" else "lommel")
    return subprocess.run([script, *words], check=True, capture_output=True, encoding="utf-8")


if __name__ == "__main__":
    main()
