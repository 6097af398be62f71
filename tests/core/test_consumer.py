"""The headers alone, as a stranger's C++ project meets them: installed and found, or taken in; without Python."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import tomllib
from pathlib import Path

import pytest

import programs

ROOT = Path(__file__).resolve().parents[2]
STRANGER = ROOT / "tests" / "cmake_consume"
VERSION = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["version"]
CMAKE, NINJA = programs.cmake(), programs.ninja()


def run(*command: str | Path) -> str:
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def configure(source: Path, build: Path, *options: str) -> None:
    tools = "-G", "Ninja", f"-DCMAKE_MAKE_PROGRAM={NINJA}"
    run(CMAKE, *tools, "-DCMAKE_CXX_FLAGS=-O0", "-S", source, "-B", build, *options)


def answer(build: Path) -> str:
    run(CMAKE, "--build", build)
    return run(build / "stranger")


@pytest.fixture(scope="module")
def installed(tmp_path_factory) -> Path:
    place = tmp_path_factory.mktemp("installed")
    # What would be needed for Python is not there to be found.
    configure(ROOT, place / "build", *(f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON" for name in ("Python", "nanobind")))
    run(CMAKE, "--install", place / "build", "--prefix", place / "prefix")
    shutil.rmtree(place / "build")
    return place / "prefix"


def test_what_is_installed_is_found_and_computes_a_psf(installed, tmp_path):
    configure(STRANGER, tmp_path, f"-DCMAKE_PREFIX_PATH={installed}", f"-DLOMMEL_WANTED={VERSION}")
    assert "off by" in answer(tmp_path)
    folders = ROOT / "cpp" / "include", installed / "include"
    here, there = (sorted(path.relative_to(folder) for path in folder.rglob("*.hpp")) for folder in folders)
    assert here == there


def test_another_version_is_refused(installed, tmp_path):
    with pytest.raises(AssertionError, match=re.escape(f"version: {VERSION}")):
        configure(STRANGER, tmp_path, f"-DCMAKE_PREFIX_PATH={installed}", "-DLOMMEL_WANTED=99.0")


def test_arithmetic_that_no_bound_holds_for_is_refused():
    compiler = shlex.split(os.environ.get("CXX", "c++"))
    command = (*compiler, "-std=c++17", "-ffast-math", "-E", f"-I{ROOT / 'cpp' / 'include'}", STRANGER / "main.cpp")
    with pytest.raises(AssertionError, match="leave -ffast-math out"):
        run(*command)


def test_the_source_taken_in_computes_in_one_thread(tmp_path):
    configure(STRANGER, tmp_path, f"-DLOMMEL_SOURCE={ROOT}", "-DLOMMEL_SINGLE_THREADED=ON")
    assert "off by" in answer(tmp_path)
    opened = run(NINJA, "-C", tmp_path, "-t", "deps")
    assert "lommel/base/parallel.hpp" in opened
    # Whatever the standard library includes by itself, none of these is asked for.
    assert not re.search(r"/(thread|mutex|condition_variable|shared_mutex|future)\s", opened)
