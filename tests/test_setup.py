"""The way from a clone to a first picture: what is installed for it, and when make installs or compiles anew."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tomllib
from importlib.metadata import distribution, packages_distributions
from pathlib import Path

import numpy as np
import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name
from PIL import Image

from lommel import _core

ROOT = Path(__file__).resolve().parent.parent
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
EXTRAS, GROUPS = PROJECT["project"]["optional-dependencies"], PROJECT["dependency-groups"]
# What fetches and builds; the last two only where PATH has none.
TOOLS = ("uv", "cmake", "ninja")


def needed(*wanted: str) -> set[str]:
    """Return the names of packages and of all that these need here."""
    found: set[str] = set()
    waiting = [(Requirement(text), "") for text in wanted]
    while waiting:
        requirement, extra = waiting.pop()
        name = canonicalize_name(requirement.name)
        if requirement.marker and not requirement.marker.evaluate({"extra": extra}):
            continue
        extras = ["", *sorted(requirement.extras)]
        if name in found and extras == [""]:
            continue
        found.add(name)
        waiting += [(Requirement(text), each) for each in extras for text in distribution(name).requires or ()]
    return found


FIRST = needed(*PROJECT["project"]["dependencies"], *EXTRAS["images"], *GROUPS["build"])


def test_few_packages_are_installed_before_the_first_picture():
    assert len(FIRST | set(TOOLS)) <= 25
    assert not FIRST & {"matplotlib", "pytest", "mypy", "jax", "astropy"}


def test_the_compiled_module_is_small():
    assert Path(_core.__file__).stat().st_size <= 5.0e6


def test_what_is_installed_first_is_of_the_lock_and_has_hashes():
    lock = (ROOT / "requirements.lock").read_text(encoding="utf-8")
    entries = re.findall(r"^([\w.-]+)==[^\n]*\\\n(?:    --hash=sha256:[0-9a-f]{64}(?: \\)?\n)+", lock, re.MULTILINE)
    assert len(entries) == len(re.findall("==", re.sub("[<>=!]= '.*", "", lock)))
    assert FIRST | set(TOOLS) <= set(entries)


def test_the_first_picture_imports_no_package_of_the_second_stage(tmp_path):
    owned = packages_distributions().items()
    others = {module for module, owners in owned if not (FIRST | {"lommel"}) & {*map(canonicalize_name, owners)}}
    assert {"matplotlib", "pytest"} <= others
    code = f"""
import sys

class Missing:
    def find_spec(self, name, path=None, target=None):
        if name in {others!r}:
            raise ModuleNotFoundError(name, name=name)

sys.meta_path.insert(0, Missing())
import runpy
command = sys.argv.pop(1)
if command.endswith(".py"):
    sys.argv.pop(0)
    sys.argv.insert(0, command)
    runpy.run_path(command, run_name="__main__")
else:
    from lommel.cli.main import main
    main()
"""
    lines = re.findall(
        r"^\t\.venv/bin/(?:python )?(\S+ .*out/hubble.*)$", (ROOT / "Makefile").read_text(), re.MULTILINE
    )
    assert len(lines) == 2
    for line in lines:
        words = [word.replace("out/", f"{tmp_path}/") for word in line.split()]
        run = [sys.executable, "-c", code, *words]
        done = subprocess.run(run, cwd=ROOT, check=False, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
    assert {path.name for path in tmp_path.iterdir()} == {"hubble-1990.tif", "hubble-1990.png"}
    with Image.open(tmp_path / "hubble-1990.png") as drawn:
        colours = np.asarray(drawn.convert("RGB"), dtype=float)
    # White paper, and two pictures of which no more than a part is dark.
    assert min(colours.shape[:2]) >= 1000
    pictures = colours[112:752, 60:1370].max(axis=-1)
    assert 60 < pictures.mean() < 160
    assert pictures.max() > 240


# What recipes and the scripts in .ci call, beside compilers, uv and Python.
UTILITIES = ("awk", "cat", "cp", "env", "find", "make", "mkdir", "mv", "printf", "rm", "sed", "sh", "touch")


class Place:
    """A project of a few files with the Makefile, and programs that only write down how they are called.

    Nothing else is on PATH, so that a compiler or uv can be missing.
    """

    def __init__(self, root: Path) -> None:
        self.root, self.log, self.bin = root / "project", root / "log", root / "bin"
        for name in ("Makefile", "pyproject.toml", "requirements.lock"):
            self.write(name, (ROOT / name).read_text(encoding="utf-8"))
        shutil.copytree(ROOT / ".ci", self.root / ".ci")
        for name in ("CMakeLists.txt", "cpp/bindings/one.cpp", "src/lommel/__init__.py", "src/lommel/two.py"):
            self.write(name, "")
        for name in (
            "cpp/include/one.hpp",
            "cpp/wasm/one.cpp",
            "src/lommel/page/state.py",
            "examples/lenses/one.toml",
        ):
            self.write(name, "")
        self.write("web/build.py", "import pathlib, sys\npathlib.Path(sys.argv[2]).mkdir(parents=True)")
        self.log.touch()
        self.bin.mkdir()
        for name in UTILITIES:
            found = shutil.which(name)
            if found is None:
                pytest.skip(f"no {name}")
            (self.bin / name).symlink_to(found)
        (root / "missing").touch()
        self.core = Path("build", sys.implementation.cache_tag, "_core.so")
        cache = self.core.with_name("CMakeCache.txt")
        self.program("cmake", f"echo cmake $* >>{self.log}")
        self.program("c++", "exit 0")
        self.program(
            "uv",
            f"""
case "$*" in *--help) echo help; exit;; esac
echo uv $* >>{self.log}
env >{root}/environment
case "$*" in
venv*) mkdir -p .venv/bin && cp {root}/bin/python3 .venv/bin/python;;
*--editable*) mkdir -p {cache.parent} && echo CMAKE_COMMAND:INTERNAL={self.bin}/cmake >{cache};;
esac""",
        )
        self.program(
            "python3",
            f"""
case "$*" in
*_base_executable*) echo {self.bin}/python3;;
*scikit_build_core*) cat {root}/missing;;
*"-m pip --version") ;;
*"-m pip install"*) echo pip $* >>{self.log}; mkdir -p .tools/tmp/bin; cp {root}/uv .tools/tmp/bin;;
*) exec {sys.executable} "$@";;
esac""",
        )

    def program(self, name: str, script: str) -> None:
        (self.bin / name).write_text(f"#!/bin/sh\n{script}\n", encoding="utf-8")
        (self.bin / name).chmod(0o755)

    def write(self, name: str, text: str) -> None:
        (self.root / name).parent.mkdir(parents=True, exist_ok=True)
        (self.root / name).write_text(text, encoding="utf-8")

    def make(self, target: str, *changed: str) -> list[str]:
        """Return which programs a target calls after some files were written, all others being of one age."""
        for path in self.root.rglob("*"):
            os.utime(path, (1e9, 1e9))
        for name in changed:
            os.utime(self.root / name, (1e9 + 10, 1e9 + 10))
        return self.make_again(target)

    def make_again(self, *words: str) -> list[str]:
        """Return which programs a target calls as the files are."""
        run = self.run(*words)
        assert run.returncode == 0, run.stderr
        return self.log.read_text().splitlines()

    def run(self, *words: str, **more: str) -> subprocess.CompletedProcess[str]:
        self.log.write_text("")
        environment = {"PATH": str(self.bin), **more}
        return subprocess.run(
            ["make", *words], cwd=self.root, env=environment, check=False, capture_output=True, text=True
        )

    def environment(self) -> dict[str, str]:
        """Return the environment that uv was last called in."""
        lines = (self.root.parent / "environment").read_text().splitlines()
        return dict(line.split("=", 1) for line in lines if "=" in line)


@pytest.fixture
def place(tmp_path) -> Place:
    return Place(tmp_path)


LOCKED = ["--require-hashes", "--constraint", "requirements.lock"]


def has(line: str, *words: str) -> bool:
    return f" {' '.join(words)} " in f" {line} "


def test_packages_are_installed_in_two_stages_and_only_by_their_hashes(place):
    made, first, package, _ = place.make("build")
    assert has(made, "uv venv")
    assert has(first, *LOCKED)
    assert first.endswith("--requirement pyproject.toml --extra images --group build")
    assert has(package, "--no-build-isolation", "--no-deps")
    (second,) = place.make("env")
    assert has(second, *LOCKED)
    assert second.endswith("--requirement pyproject.toml --extra all --group dev")
    # The second takes nothing back, and so nothing is compiled again.
    assert not place.make("env")
    assert len(place.make("build")) == 1
    assert len(place.make("env", "requirements.lock")) == 3


@pytest.mark.parametrize(
    ("name", "script", "words"),
    [
        ("c++", None, ["no C++17 compiler", "g++ or clang++", "CXX="]),
        ("c++", "exit 1", ["no C++17 compiler", "g++ or clang++", "CXX="]),
        ("python3", "echo /bare/python3; exit 1", ["Python.h", "/bare/python3", "python3-dev"]),
        ("python3", "exit 1", ["no Python >= 3.11", "PYTHON="]),
    ],
)
@pytest.mark.parametrize("uv", ["there", "missing"])
def test_what_is_missing_is_said_before_anything_is_installed(name, script, words, uv, place):
    (place.bin / name).unlink()
    if script:
        place.program(name, script)
    if uv == "missing":
        (place.bin / "uv").unlink()
    run = place.run("psf")
    assert run.returncode != 0
    said = [line for line in run.stderr.splitlines() if "***" not in line]
    assert all(line.startswith("make: ") for line in said)
    assert all(word in " ".join(said) for word in words)
    assert len(" ".join(said)) <= 300
    assert place.log.read_text() == ""
    assert not (place.root / ".venv").exists()
    assert not (place.root / ".tools").exists()


def test_an_edit_of_the_core_is_compiled_without_a_new_install(place):
    place.make("build")
    folder = str(place.core.parent)
    (compiled,) = place.make("build", "cpp/bindings/one.cpp")
    assert has(compiled, "cmake", "--build", folder)
    place.write(str(place.core), "")
    compiled, copied = place.make("build", str(place.core))
    assert has(copied, "cmake", "--install", folder, "--strip", "--prefix")
    assert len(place.make_again("build")) == 1
    assert len(place.make("build", "src/lommel/two.py")) == 1
