"""A wheel, installed where nothing but NumPy, SciPy and what the command line needs can be imported, works."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import sysconfig
import tomllib
import venv
import zipfile
from importlib.metadata import distribution, version
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
        held = {Path(name).name for name in archive.namelist() if "/licenses/" in name}
    assert {path.name for path in (ROOT / "LICENSES").iterdir()} | {"LICENSE"} <= held
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
    uv = shutil.which("uv") or ROOT / ".tools" / "uv"
    command = [uv, "build", "--wheel", *settings, "--python", sys.executable, "--out-dir", tmp_path / "dist"]
    subprocess.run([*command, ROOT], check=True, capture_output=True)
    wheel = newest(tmp_path / "dist")
    assert wheel is not None
    # One for 3.12 and every later Python; 3.11 has its own.
    assert ("abi3" in wheel.name) == (sys.version_info >= (3, 12))
    flags = [] if (ROOT / "src" / "lommel" / "page" / "lommel-live.js").is_file() else ["--no-page"]
    check(wheel, tmp_path, *flags)


def test_the_changelog_is_about_the_version_of_the_package():
    lines = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8").splitlines()
    first = next(line for line in lines if line.startswith("## "))
    assert first.split()[1].rstrip(",") == version("lommel")


def test_wheels_carry_the_notices_of_all_that_is_linked_into_them():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    patterns = project["project"]["license-files"]
    listed = {path.relative_to(ROOT).as_posix() for pattern in patterns for path in ROOT.glob(pattern)}
    table = (ROOT / "LICENSES" / "README.md").read_text(encoding="utf-8")
    named = set(re.findall(r"`([\w-]+\.txt)`", table))
    assert listed == {"LICENSE", "LICENSES/README.md", *(f"LICENSES/{name}" for name in named)}
    for name in named:
        text = (ROOT / "LICENSES" / name).read_text(encoding="utf-8")
        assert re.search(r"copyright", text, re.IGNORECASE), name
    # Of what is installed here the very text.
    of_nanobind = distribution("nanobind")
    (notice,) = (path for path in of_nanobind.files or () if path.name == "LICENSE")
    assert (ROOT / "LICENSES" / "nanobind.txt").read_text(encoding="utf-8") == notice.read_text(encoding="utf-8")
    (header,) = (path for path in of_nanobind.files or () if path.name == "robin_map.h")
    flat = " ".join(re.sub(r"^[ /]?\*+/?", "", header.read_text(encoding="utf-8"), flags=re.MULTILINE).split())
    assert " ".join((ROOT / "LICENSES" / "robin-map.txt").read_text(encoding="utf-8").split()) in flat
    pinned = (ROOT / "requirements.lock").read_text()
    for package, release in re.findall(r"\b(nanobind|ziglang) ([\d.]+\d)", table):
        assert f"\n{package}=={release} " in pinned  # a newer one may have other notices
