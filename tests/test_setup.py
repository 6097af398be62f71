"""The way from a clone to a first picture: what is installed for it, and when make installs or compiles anew."""

from __future__ import annotations

import os
import re
import runpy
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


def test_the_group_asks_for_nothing_that_the_extras_and_the_builder_do_not():
    names = {Requirement(text).name for text in GROUPS["build"]}
    building = {Requirement(text).name for text in PROJECT["build-system"]["requires"]}
    assert names - building <= {Requirement(text).name for text in EXTRAS["cli"]}
    assert building <= names


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


class Place:
    """A project of a few files with the Makefile, and programs that only write down how they are called."""

    def __init__(self, root: Path) -> None:
        self.root, self.log, bin_folder = root / "project", root / "log", root / "bin"
        for name in ("Makefile", "pyproject.toml", "requirements.lock"):
            self.write(name, (ROOT / name).read_text(encoding="utf-8"))
        for name in ("CMakeLists.txt", "cpp/bindings/one.cpp", "src/lommel/__init__.py", "src/lommel/two.py"):
            self.write(name, "")
        self.log.touch()
        bin_folder.mkdir()
        (root / "missing").touch()
        self.path = f"{bin_folder}:{os.environ['PATH']}"
        cache = Path("build", sys.implementation.cache_tag, "CMakeCache.txt")
        python = f"""case "$*" in *scikit_build_core*) cat {root}/missing;; *) exec {sys.executable} "$@";; esac"""
        self.program(bin_folder / "cmake", f"echo cmake $* >>{self.log}")
        self.program(
            bin_folder / "uv",
            f"""
case "$*" in *--help) exit;; esac
echo uv $* >>{self.log}
case "$*" in
venv*) mkdir -p .venv/bin && cp {root}/python .venv/bin;;
*--editable*) mkdir -p {cache.parent}
    printf '%s\\n' CMAKE_COMMAND:INTERNAL={bin_folder}/cmake SKBUILD_STATE:STRING=editable >{cache};;
esac""",
        )
        self.program(root / "python", python)
        self.cache = self.root / cache

    def program(self, path: Path, script: str) -> None:
        path.write_text(f"#!/bin/sh\n{script}\n", encoding="utf-8")
        path.chmod(0o755)

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

    def make_again(self, target: str) -> list[str]:
        """Return which programs a target calls as the files are."""
        self.log.write_text("")
        environment = os.environ | {"PATH": self.path}
        subprocess.run(["make", target], cwd=self.root, env=environment, check=True, capture_output=True)
        return self.log.read_text().splitlines()


@pytest.fixture
def place(tmp_path) -> Place:
    if shutil.which("make") is None:
        pytest.skip("no make")
    return Place(tmp_path)


LOCKED = ["--require-hashes", "--constraint", "requirements.lock"]


def has(line: str, *words: str) -> bool:
    return f" {' '.join(words)} " in f" {line} "


def test_packages_are_installed_in_two_stages_and_only_by_their_hashes(place):
    made, first, package = place.make("build")
    assert has(made, "uv venv")
    assert has(first, *LOCKED)
    assert first.endswith("--requirement pyproject.toml --extra images --group build")
    assert has(package, "--no-build-isolation", "--no-deps")
    (second,) = place.make("env")
    assert has(second, *LOCKED)
    assert second.endswith("--requirement pyproject.toml --extra all --group dev")
    # The second takes nothing back, and so nothing is compiled again.
    assert not place.make("env")
    assert not place.make("build")
    assert len(place.make("env", "requirements.lock")) == 3


def test_what_builds_is_fetched_where_path_has_none(place):
    (place.root.parent / "missing").write_text("cmake>=3.26 ninja>=1.5\n")
    *_, tools, _ = place.make("build")
    assert has(tools, "--require-hashes", "--requirement", ".venv/tools.txt")
    fetched = (place.root / ".venv" / "tools.txt").read_text()
    lock = (ROOT / "requirements.lock").read_text(encoding="utf-8")
    assert re.findall(r"^([\w-]+)==", fetched, re.MULTILINE) == ["cmake", "ninja"]
    for entry in re.split(r"(?<!\\)\n(?=ninja)", fetched.strip()):
        assert f"\n{entry}\n" in lock


def test_an_edit_of_the_core_is_compiled_without_a_new_install(place):
    place.make("build")
    compiled, copied = place.make("build", "cpp/bindings/one.cpp")
    assert has(compiled, "cmake", "--build", f"build/{sys.implementation.cache_tag}")
    assert has(copied, "cmake", "--install", f"build/{sys.implementation.cache_tag}", "--strip", "--prefix")
    assert not place.make_again("build")
    assert not place.make("build", "src/lommel/two.py")
    place.write("cpp/bindings/three.cpp", "")
    assert len(place.make("build", "cpp/bindings/three.cpp")) == 2


@pytest.mark.parametrize("what", ["a file is gone", "the project changed", "a wheel was built", "its cmake is gone"])
def test_the_package_is_installed_anew_where(what, place):
    place.make("build")
    changed = ["cpp/bindings/one.cpp"]
    if what == "a file is gone":
        (place.root / "src" / "lommel" / "two.py").unlink()
    elif what == "the project changed":
        changed.append("pyproject.toml")
    elif what == "a wheel was built":
        place.cache.write_text(place.cache.read_text().replace("editable", "wheel"))
    else:
        place.cache.write_text(place.cache.read_text().replace("/cmake", "/gone"))
    (line,) = place.make("build", *changed)
    assert has(line, "--reinstall"), line
    assert has(line, "--editable", "."), line


def test_a_core_that_does_not_compile_is_compiled_again(place):
    place.make("build")
    cmake = Path(place.path.partition(":")[0]) / "cmake"
    working = cmake.read_text()
    place.program(cmake, "exit 1")
    with pytest.raises(subprocess.CalledProcessError):
        place.make("build", "cpp/bindings/one.cpp")
    cmake.write_text(working)
    assert len(place.make_again("build")) == 2


@pytest.mark.parametrize("status", [0, 3])
def test_what_a_compiler_takes_is_written_down(status, tmp_path):
    script = runpy.run_path(str(ROOT / "benchmarks" / "setup_times.py"))
    (tmp_path / "launcher.py").write_text(script["LAUNCHER"])
    busy = f"x = bytearray(50_000_000)\nfor _ in range(10**6): pass\nraise SystemExit({status})"
    command = [
        sys.executable,
        "-IS",
        tmp_path / "launcher.py",
        tmp_path / "log",
        sys.executable,
        "-c",
        busy,
        "-c a.cpp",
    ]
    assert subprocess.run(command, check=False).returncode == status
    cpu, memory, source = (tmp_path / "log").read_text().rstrip("\n").split(maxsplit=2)
    assert float(cpu) > 0.0
    assert float(memory) * (1 if sys.platform == "darwin" else 1024) > 50e6
    assert source == "-c a.cpp"
