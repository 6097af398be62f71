"""A wheel, installed where nothing but NumPy, SciPy and what the command line needs can be imported, works."""

from __future__ import annotations

import os
import subprocess
import sys
import sysconfig
import tomllib
import venv
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
# What the command line needs, and what these need: none of it has the sources of lommel.
WITH = (
    "numpy", "numpy.libs", "scipy", "scipy.libs", "click", "rich", "pygments", "markdown_it", "mdurl", "pydantic",
    "pydantic_core", "annotated_types", "typing_extensions.py", "typing_inspection",
)  # fmt: skip
SUFFIX = f"cp{sys.version_info.major}{sys.version_info.minor}"


def fits(wheel: Path) -> bool:
    """Return whether a wheel is for this Python: its own, or of the stable ABI from 3.12 on."""
    python, abi = wheel.stem.split("-")[2:4]
    return python == SUFFIX or (abi == "abi3" and int(python[3:]) <= sys.version_info.minor)


def newest(folder: Path) -> Path | None:
    wheels = sorted(filter(fits, folder.glob("lommel-*.whl")), key=lambda path: path.stat().st_mtime)
    return wheels[-1] if wheels else None


def check(wheel: Path, folder: Path, *flags: str) -> None:
    """Install a wheel into an environment of its own, as files alone, and run what it must do."""
    venv.create(folder / "bare", symlinks=True)
    scheme = sysconfig.get_paths("venv", vars={"base": str(folder / "bare"), "platbase": str(folder / "bare")})
    site, scripts = Path(scheme["purelib"]), Path(scheme["scripts"])
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(site)
    there = Path(sysconfig.get_path("purelib"))
    for name in WITH:
        if (there / name).exists():
            (site / name).symlink_to(there / name)
    entry = f"#!{scripts / 'python'}\nimport sys\nfrom lommel.cli.main import main\nsys.exit(main())\n"
    (scripts / "lommel").write_text(entry)
    (scripts / "lommel").chmod(0o755)
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    command = [scripts / "python", "-W", "error", ROOT / "tests" / "shared" / "wheel_check.py", *flags]
    run = subprocess.run(command, cwd=folder, env=environment, capture_output=True, encoding="utf-8", check=False)
    assert run.returncode == 0, run.stderr
    assert str(site) in run.stdout


@pytest.mark.skipif(sys.platform == "win32", reason="links to packages take rights that users have not")
def test_a_wheel_in_dist_works_on_its_own(tmp_path):
    wheel = newest(ROOT / "dist")
    if wheel is None:
        pytest.skip("no wheel for this Python in dist: make wheel")
    newer = [path for path in (ROOT / "src").rglob("*.py*") if path.stat().st_mtime > wheel.stat().st_mtime]
    if any(path.suffix in (".py", ".pyi") for path in newer):
        pytest.skip(f"{wheel.name} in dist is older than the sources: make wheel")
    check(wheel, tmp_path)


@pytest.mark.skipif(not os.environ.get("LOMMEL_WHEEL"), reason="minutes; LOMMEL_WHEEL=1 builds a wheel and tries it")
def test_a_wheel_that_is_built_now_works_on_its_own(tmp_path):
    settings = [f"--config-setting=build-dir={tmp_path / 'build'}", "--no-build-isolation"]
    command = ["uv", "build", "--wheel", *settings, "--python", sys.executable, "--out-dir", tmp_path / "dist"]
    subprocess.run([*command, ROOT], check=True, capture_output=True)
    wheel = newest(tmp_path / "dist")
    assert wheel is not None
    # One for 3.12 and every later Python; 3.11 has its own.
    assert ("abi3" in wheel.name) == (sys.version_info >= (3, 12))
    flags = [] if (ROOT / "src" / "lommel" / "page" / "lommel-live.js").is_file() else ["--no-page"]
    check(wheel, tmp_path, *flags)


def test_what_builds_wheels_knows_every_python_that_the_package_names():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    assert project["tool"]["scikit-build"]["wheel"]["py-api"] == "cp312"
    built = project["tool"]["cibuildwheel"]["build"]
    # 3.11 has no stable ABI that nanobind can use; the wheel of 3.12 is that of all later ones.
    assert {"cp311-*", "cp312-*"} <= set(built)
    named = [line.rpartition(" ")[2] for line in project["project"]["classifiers"] if "Python :: 3." in line]
    assert min(named, key=lambda version: int(version.partition(".")[2])) == "3.11"
