"""The C interface: the header in strict C, and the shared library as C, Rust and ctypes meet it."""

from __future__ import annotations

import ctypes
import os
import shlex
import shutil
import subprocess
import tomllib
from pathlib import Path

import numpy as np
import pytest

import lommel as lm
import programs

ROOT = Path(__file__).resolve().parents[2]
HEADER = ROOT / "cpp" / "c" / "lommel.h"
EXAMPLES = ROOT / "examples" / "c"
VERSION = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["version"]
TERMS = {(2, 0): 1.1, (2, 2): -0.7, (3, 1): 0.9, (3, -1): 0.4, (4, 0): 0.3}
OK, INVALID, TOLERANCE, LIMIT = 0, 1, 2, 3


def run(*command: str | Path) -> subprocess.CompletedProcess[str]:
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done


@pytest.mark.parametrize("language", ["c", "c++"])
def test_the_header_and_the_examples_are_strict_c(language):
    compiler = shlex.split(os.environ.get("CC", "cc") if language == "c" else os.environ.get("CXX", "c++"))
    flags = ["-std=c99"] if language == "c" else ["-std=c++17"]
    run(*compiler, *flags, "-pedantic-errors", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-x", language, HEADER)
    for name, standard in {"frames.c": "c99", "live_depth.c": "c11"}.items() if language == "c" else ():
        strict = f"-std={standard}", "-pedantic-errors", "-Wall", "-Wextra", "-Werror", "-fsyntax-only"
        run(*compiler, *strict, f"-I{HEADER.parent}", EXAMPLES / name)


def test_the_interface_agrees_with_its_header_and_with_the_core():
    compiler, core = shlex.split(os.environ.get("CXX", "c++")), ROOT / "cpp"
    macros = "-DLOMMEL_COMPILED", "-DLOMMEL_BUILDS_C", '-DLOMMEL_VERSION=""'
    flags = "-std=c++17", "-Wno-psabi", "-fsyntax-only", *macros, f"-I{core / 'include'}"
    run(*compiler, *flags, *sorted((core / "c").glob("*.cpp")))


@pytest.fixture(scope="module")
def prefix(tmp_path_factory) -> Path:
    if not os.environ.get("LOMMEL_C"):
        pytest.skip("compiles the core once more, half a minute: make test-c, or LOMMEL_C=1")
    place = tmp_path_factory.mktemp("c")
    tools = "-G", "Ninja", f"-DCMAKE_MAKE_PROGRAM={programs.ninja()}", "-DCMAKE_BUILD_TYPE=Release"
    flags = "-DLOMMEL_C=ON", f"-DCMAKE_CXX_FLAGS_RELEASE={os.environ.get('LOMMEL_C_FLAGS', '-O0')}"
    run(programs.cmake(), *tools, *flags, "-S", ROOT, "-B", place / "build")
    run(programs.cmake(), "--build", place / "build")
    run(programs.cmake(), "--install", place / "build", "--prefix", place / "prefix")
    return place / "prefix"


@pytest.fixture(scope="module")
def library(prefix) -> ctypes.CDLL:
    (file,) = prefix.glob(f"lib*/liblommel.so.{VERSION}")
    loaded = ctypes.CDLL(str(file))
    loaded.lommel_plan_new.restype = ctypes.c_void_p
    loaded.lommel_plan_new.argtypes = [ctypes.c_int32, ctypes.c_int32, ctypes.c_double, ctypes.c_double]
    loaded.lommel_message.restype = loaded.lommel_version.restype = ctypes.c_char_p
    return loaded


class Plan:
    """A plan of the library, and arrays for its answers."""

    def __init__(self, library, shape, pixel, tol, *, center=None, integrate=0, obscuration=0.0, normalize=0):
        self.library, self.shape = library, shape
        self.plan = ctypes.c_void_p(library.lommel_plan_new(*shape, pixel, tol))
        assert self.plan, library.lommel_message()
        codes = [
            library.lommel_plan_integrate(self.plan, integrate),
            library.lommel_plan_obscuration(self.plan, ctypes.c_double(obscuration)),
            library.lommel_plan_normalize(self.plan, normalize),
        ]
        if center:
            codes.append(library.lommel_plan_center(self.plan, *map(ctypes.c_double, center)))
        assert codes == [OK] * len(codes), library.lommel_message()

    def ask(self, terms, *, dtype=np.float64):
        """Return the code, the image and its bound."""
        (n, m), edge = np.array(list(terms), np.int32).T.copy(), np.array(list(terms.values()), float)
        image, bound = np.full(self.shape, np.nan, dtype), np.full(1, np.nan)
        name = "lommel_psf_zernike" + ("_float" if dtype == np.float32 else "")
        arrays = [ctypes.c_void_p(array.ctypes.data) for array in (n, m, edge, image, bound)]
        return getattr(self.library, name)(self.plan, 1, len(edge), *arrays), image, float(bound[0])

    def __del__(self):
        self.library.lommel_plan_free(self.plan)


@pytest.mark.parametrize("integrate", [0, 1])
@pytest.mark.parametrize("case", range(6))
def test_images_are_those_of_the_package_within_their_bounds(library, case, integrate):
    center, obscuration = ((None, 0.0), ((7.3, 11.8), 0.35))[case % 2]
    normalize, pixel = case % 3, (0.4, 1.3, 2.9)[case // 2]
    for terms in (TERMS, {(2, 0): 2.0, (4, 0): 0.6}):
        wavefront = lm.Wavefront.from_edge({term: np.asarray(value) for term, value in terms.items()})
        place = {"center": center} if center else {}
        truth = lm.psf(
            lm.Pupil(wavefront, obscuration=obscuration), (17, 21), pixel, tol=1e-10, dtype="float64",
            integrate=bool(integrate), normalize=("energy", "strehl", "peak")[normalize], **place,
        )  # fmt: skip
        for dtype, tol in ((np.float64, 1e-8), (np.float32, 1e-6)):
            plan = Plan(
                library, (17, 21), pixel, tol, center=center, integrate=integrate, obscuration=obscuration,
                normalize=normalize,
            )  # fmt: skip
            code, image, bound = plan.ask(terms, dtype=dtype)
            assert code == OK, library.lommel_message()
            off = np.abs(image - truth.values).max() / truth.values.max()
            assert off <= bound + 1e-10
            assert bound <= tol


def test_what_is_wrong_has_a_code_and_a_message(library):
    plan = Plan(library, (9, 9), 0.5, 1e-6)
    message = library.lommel_message
    assert plan.ask({(2, 1): 1.0})[0] == INVALID
    assert b"n and m" in message()
    assert plan.ask({(2, 2): np.nan})[0] == INVALID
    assert b"finite" in message()
    assert plan.ask({(2, 2): 1e7})[0] == LIMIT
    assert b"phases of 1e+07 rad" in message()
    assert library.lommel_plan_center(plan.plan, ctypes.c_double(np.nan), ctypes.c_double(0.0)) == INVALID
    assert library.lommel_plan_center(None, ctypes.c_double(0.0), ctypes.c_double(0.0)) == INVALID
    assert message() == b"plan is NULL"
    assert library.lommel_plan_new(0, 9, 0.5, 1e-6) is None
    assert library.lommel_plan_new(9, 9, 0.5, 0.0) is None
    assert b"tol" in message()
    assert Plan(library, (9, 9), 0.5, 1e-8).ask(TERMS, dtype=np.float32)[0] == INVALID
    far = Plan(library, (3, 3), 0.5, 1e-12, center=(90000.0, 0.0), normalize=2)
    assert far.ask({(2, 0): 1.0})[0] == TOLERANCE
    assert b"bound" in message()
    assert plan.ask(TERMS)[0] == OK  # a plan outlives what went wrong


def test_only_the_functions_of_the_header_are_exported(prefix, library):
    declared = set(HEADER.read_text().replace("(", " ").replace("*", " ").split())
    (file,) = prefix.glob(f"lib*/liblommel.so.{VERSION}")
    if not shutil.which("nm"):
        pytest.skip("no nm")
    exported = {line.split()[-1] for line in run("nm", "-D", "--defined-only", file).stdout.splitlines()}
    assert len(exported) >= 19
    assert exported <= declared
    assert library.lommel_version().decode() == VERSION
    assert f"#define LOMMEL_ABI {library.lommel_abi()}\n" in HEADER.read_text()


def test_a_frame_loop_in_c_finds_the_library_and_allocates_nothing(prefix, tmp_path):
    tools = "-G", "Ninja", f"-DCMAKE_MAKE_PROGRAM={programs.ninja()}"
    run(programs.cmake(), *tools, f"-DCMAKE_PREFIX_PATH={prefix}", "-S", EXAMPLES, "-B", tmp_path / "build")
    run(programs.cmake(), "--build", tmp_path / "build")
    assert "sharpest at 2.00 m with 0.8978" in run(tmp_path / "build" / "frames").stdout
    refused = subprocess.run([tmp_path / "build" / "live_depth", "none", "64x64"], capture_output=True, check=False)
    assert (refused.returncode, refused.stderr) == (2, b"none: No such file or directory\n")
    counter, told = programs.allocation_counter(tmp_path), {}
    for frames in (400, 800):
        command = [str(tmp_path / "build" / "frames"), str(frames)]
        done = subprocess.run(command, env=os.environ | counter, capture_output=True, text=True, check=True)
        told[frames] = int(done.stderr)
    assert told[400] > 0
    assert told[800] - told[400] < 40  # tables that further defocus values need, not something of each frame


def test_a_program_in_rust_computes_the_same(prefix, tmp_path):
    if not shutil.which("rustc"):
        pytest.skip("no rustc")
    (folder,) = {path.parent for path in prefix.glob("lib*/liblommel.so")}
    run("rustc", "-L", folder, "-C", f"link-arg=-Wl,-rpath,{folder}", EXAMPLES / "psf.rs", "-o", tmp_path / "psf")
    largest, refused = run(tmp_path / "psf").stdout.splitlines()
    wavefront = lm.Wavefront.from_edge({(2, 0): np.asarray(0.5), (3, 1): np.asarray(0.8)})
    psf = lm.psf(lm.Pupil(wavefront), 65, 0.25, tol=1e-8, normalize="strehl", dtype="float64")
    assert largest.startswith(f"largest value {psf.values.max():.6f}, bound ")
    assert refused.startswith("n and m")
