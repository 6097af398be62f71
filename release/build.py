"""Make the folder that a maintainer uploads: sources, wheels, documents and checksums.

    make release                          # all of it, to dist/release
    make release FLAGS="--arm FOLDER"     # and a wheel for 64-bit ARM; see docs/releasing.md

Everything comes from the last commit: an archive of the sources, wheels that are built from it without a network, and
documents. Every wheel is installed into an environment of its own and tried. The same commit, compiler and pins give
the same bytes.
"""

from __future__ import annotations

import argparse
import os
import platform
import re
import shutil
import subprocess
import sys
import tarfile
import textwrap
from dataclasses import dataclass, field
from fnmatch import fnmatch
from pathlib import Path

import documents  # beside this file

ROOT = documents.ROOT
WORK = ROOT / "build" / "release"
TOOLS = ROOT / ".tools"
CHECK = ROOT / "tests" / "shared" / "wheel_check.py"
# What the compiled core may load from the system, on Linux.
LOADED = {
    "ld-linux-x86-64.so.2",
    "ld-linux-aarch64.so.1",
    "libstdc++.so.6",
    "libgcc_s.so.1",
    "libm.so.6",
    "libc.so.6",
    "libpthread.so.0",
}
ARM = "aarch64-linux-gnu"


@dataclass
class Report:
    """What was made and tried, and what was not, with the reason."""

    wheels: dict[str, str] = field(default_factory=dict)
    missing: list[str] = field(default_factory=list)


def environment(release: documents.Release, **more: str) -> dict[str, str]:
    """Return the environment of a build: with the time of the commit, and no flags that are set outside."""
    kept = {
        name: value for name, value in os.environ.items() if name not in ("CFLAGS", "CXXFLAGS", "CPPFLAGS", "LDFLAGS")
    }
    return kept | {"SOURCE_DATE_EPOCH": str(release.epoch), "PIP_NO_INDEX": "1", "UV_OFFLINE": "1"} | more


def run(*command: str | Path, **more: object) -> subprocess.CompletedProcess[str]:
    """Run a command; where it fails, show what it said."""
    done = subprocess.run(command, capture_output=True, encoding="utf-8", check=False, **more)  # type: ignore[call-overload]
    if done.returncode:
        raise SystemExit(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}\nfailed with {done.returncode}")
    return done


def uv() -> str:
    """Return the uv that the Makefile found."""
    return os.environ.get("UV") or shutil.which("uv") or str(TOOLS / "uv")


def without_network() -> list[str]:
    """Return the words before a command that leave it without a network, where the system has such."""
    words = ["unshare", "--map-root-user", "--net"]
    able = (
        shutil.which("unshare") and subprocess.run([*words, "true"], capture_output=True, check=False).returncode == 0
    )
    return words if able else []


def interpreter(version: str) -> Path | None:
    """Return a Python of a version, such as 3.14t: one that is there, or one that uv fetches, or None."""
    pyenv = Path(os.environ.get("PYENV_ROOT") or Path.home() / ".pyenv")
    places = [*map(str, sorted(pyenv.glob("versions/*/bin"))), os.environ.get("PATH", "")]
    own = {"PATH": os.pathsep.join(places), "UV_PYTHON_INSTALL_DIR": str(TOOLS / "pythons")}
    find = [uv(), "python", "find", "--no-project", "--system", "--no-python-downloads", version]
    for step in (find, [uv(), "python", "install", "--quiet", version], find):
        done = subprocess.run(
            step,
            env=os.environ | own | {"UV_PYTHON_DOWNLOADS": "manual"},
            capture_output=True,
            encoding="utf-8",
            check=False,
        )
        if done.returncode == 0 and done.stdout.strip():
            return Path(done.stdout.strip())
    return None


def sources(release: documents.Release, folder: Path) -> Path:
    """Pack the sources of the last commit."""
    tree = WORK / "tree"
    tree.mkdir(parents=True)
    packed = subprocess.run(["git", "archive", "HEAD"], cwd=ROOT, check=True, capture_output=True).stdout
    subprocess.run(["tar", "-x", "-C", tree], input=packed, check=True)
    # Without isolation and in the environment of this Python, which the lock has filled.
    run(
        *(uv(), "build", "--offline", "--sdist", "--no-build-isolation", "--python", sys.executable),
        *("--out-dir", folder, tree),
        env=environment(release),
    )
    (archive,) = folder.glob("lommel-*.tar.gz")
    return archive


def unpacked(archive: Path) -> Path:
    """Return the folder of the sources that wheels are built from."""
    with tarfile.open(archive) as tar:
        tar.extractall(WORK, filter="data")
    return WORK / archive.name.removesuffix(".tar.gz")


def builder(name: str, python: Path) -> Path:
    """Return the Python of an environment with what the lock has for building."""
    place = TOOLS / "release" / name
    run(uv(), "venv", "--quiet", "--clear", "--python", python, place)
    run(
        *(uv(), "pip", "install", "--quiet", "--python", place / "bin" / "python", "--require-hashes"),
        *("--constraint", "requirements.lock", "--group", "build", "--group", "tools"),
        cwd=ROOT,
    )
    return place / "bin" / "python"


def built(release: documents.Release, name: str, python: Path, tree: Path, flags: list[str], **more: str) -> Path:
    """Build a wheel without a network, in the environment of a Python."""
    out = WORK / f"{name}-wheel"
    path = f"{python.parent}{os.pathsep}{os.environ['PATH']}"
    run(
        *without_network(),
        *(uv(), "build", "--offline", "--wheel", "--no-build-isolation", "--python", python, "--out-dir", out),
        *(f"--config-setting=build-dir={WORK / name}", "--config-setting=wheel.reproducible=true", *flags, tree),
        env=environment(release, PATH=path, **more),
    )
    (wheel,) = out.glob("*.whl")
    return wheel


def tagged(release: documents.Release, wheel: Path, folder: Path) -> Path:
    """Put a wheel into a folder, on Linux with the manylinux tag that auditwheel finds, and with nothing grafted."""
    if sys.platform != "linux":
        return Path(shutil.copy(wheel, folder))
    tools = Path(sys.executable).parent
    before = set(folder.iterdir())
    path = f"{tools}{os.pathsep}{os.environ['PATH']}"
    said = run(tools / "auditwheel", "repair", "--wheel-dir", folder, wheel, env=environment(release, PATH=path))
    (made,) = set(folder.iterdir()) - before
    if "manylinux" not in made.name:
        raise SystemExit(f"auditwheel gave {made.name} no manylinux tag:\n{said.stdout}{said.stderr}")
    code = "import sys; from auditwheel.elfutils import elf_read_dt_needed; from pathlib import Path"
    code += "; print(*elf_read_dt_needed(Path(sys.argv[1])))"
    core = WORK / "core"
    shutil.rmtree(core, ignore_errors=True)
    shutil.unpack_archive(made, core, "zip")
    (module,) = (core / "lommel").glob("_core.*.so")
    loaded = set(run(tools / "python", "-c", code, module).stdout.split())
    if loaded - LOADED or list(core.glob("*.libs")):
        raise SystemExit(f"{made.name} loads {', '.join(sorted(loaded - LOADED))}: state it in LICENSES/README.md")
    return made


def tried(python: Path, wheel: Path, place: Path, prepared: bool = False) -> None:
    """Install a wheel, with what the command line needs, into an empty environment, and run what it must do."""
    if not prepared:
        run(uv(), "venv", "--quiet", "--clear", "--python", python, place)
    inside = place / "bin" / "python"
    install = [uv(), "pip", "install", "--quiet", "--python", inside, "--constraint", ROOT / "requirements.lock"]
    run(*install, "--only-binary", ":all:", f"lommel[cli] @ {wheel.as_uri()}")
    told = run(
        inside, "-W", "error", CHECK, cwd=place, env={k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
    )
    if str(place) not in told.stdout:
        raise SystemExit(f"{wheel.name} was not what {inside} imported: {told.stdout}")


def wheels(release: documents.Release, tree: Path, folder: Path, only: list[str] | None, report: Report) -> None:
    """Build and try a wheel for each Python that pyproject.toml has cibuildwheel build for."""
    project = documents.project()
    named = [line.rpartition(" ")[2] for line in project["project"]["classifiers"] if "Python :: 3." in line]
    abi = project["tool"]["scikit-build"]["wheel"]["py-api"]
    for pattern in project["tool"]["cibuildwheel"]["build"]:
        name = pattern.partition("-")[0]
        version = re.sub(r"^cp3", "3.", name)
        if only and version not in only:
            report.missing.append(f"A wheel for Python {version}: left out by --only.")
            continue
        python = interpreter(version)
        if python is None:
            report.missing.append(
                f"A wheel for Python {version}: no such interpreter is here, nor could uv fetch one."
            )
            continue
        print(f"wheel for Python {version}", flush=True)
        wheel = tagged(release, built(release, name, builder(name, python), tree, []), folder)
        users = [version]
        if name == abi:
            users = [one for one in named if int(one.split(".")[1]) >= int(version.split(".")[1])]
        done = []
        for one in users:
            user = interpreter(one)
            if user is None:
                report.missing.append(f"{wheel.name} under Python {one}: no such interpreter is here to try it.")
                continue
            print(f"{wheel.name}: Python {one}", flush=True)
            tried(user, wheel, WORK / f"try-{one}")
            done.append(f"{platform.machine()}, Python {one}")
        report.wheels[wheel.name] = "; ".join(done)


def arm_wheel(release: documents.Release, tree: Path, root: Path | None, folder: Path, report: Report) -> None:
    """Cross-compile a wheel for 64-bit ARM, and try it in an emulator with the Python of a system's files."""
    tools = [f"{ARM}-g++", "qemu-aarch64"]
    lacking = [tool for tool in tools if not shutil.which(tool)]
    pythons = sorted((root / "usr" / "bin").glob("python3.1[1-9]")) if root else []
    if lacking or not pythons:
        why = f"{' and '.join(lacking)} not on PATH" if lacking else "no files of such a system with a Python (--arm)"
        report.missing.append(f"A wheel for Linux on 64-bit ARM: {why}.")
        return
    assert root is not None
    version = pythons[-1].name.removeprefix("python")
    name = f"cp{version.replace('.', '')}"
    python = interpreter(version)
    if python is None or (name != "cp311" and name != documents.project()["tool"]["scikit-build"]["wheel"]["py-api"]):
        report.missing.append(
            f"A wheel for Linux on 64-bit ARM: {root} has Python {version}, wheels are built by 3.11 and 3.12."
        )
        return
    print(f"wheel for 64-bit ARM, Python {version}", flush=True)
    headers = root / "usr" / "include"
    settings = {
        "CMAKE_SYSTEM_NAME": "Linux",
        "CMAKE_SYSTEM_PROCESSOR": "aarch64",
        "CMAKE_CXX_COMPILER": f"{ARM}-g++",
        # After the compiler's own headers: the system's are of interest for those of Python alone.
        "CMAKE_CXX_FLAGS": f"-idirafter {headers}",
        "Python_INCLUDE_DIR": headers / f"python{version}",
    }
    flags = [f"--config-setting=cmake.define.{key}={value}" for key, value in settings.items()]
    target = {"_PYTHON_HOST_PLATFORM": "linux-aarch64", "SETUPTOOLS_EXT_SUFFIX": f".cpython-{name[2:]}-{ARM}.so"}
    made = built(release, f"{name}-arm", builder(f"{name}-arm", python), tree, flags, **target)
    wheel = tagged(release, made, folder)
    # An environment whose Python is that of the files, emulated: -0 has it look for pyvenv.cfg here.
    place = WORK / "try-arm"
    (place / "bin").mkdir(parents=True)
    inside = place / "bin" / "python"
    inside.write_text(f'#!/bin/sh\nexec qemu-aarch64 -L "{root}" -0 "{inside}" "{pythons[-1]}" "$@"\n')
    inside.chmod(0o755)
    (place / "pyvenv.cfg").write_text(
        f"home = {pythons[-1].parent}\ninclude-system-site-packages = false\nversion = {version}\n"
    )
    print(f"{wheel.name}: emulated", flush=True)
    tried(pythons[-1], wheel, place, prepared=True)
    report.wheels[wheel.name] = f"64-bit ARM emulated by qemu, Python {version}"


def checked(release: documents.Release, folder: Path) -> None:
    """Have other tools read the bill of materials and the conda recipe."""
    python = sys.executable
    read_bill = """
        import sys
        from pathlib import Path
        from cyclonedx.schema import SchemaVersion
        from cyclonedx.validation.json import JsonStrictValidator
        error = JsonStrictValidator(SchemaVersion.V1_6).validate_str(Path(sys.argv[1]).read_text(encoding="utf-8"))
        sys.exit(str(error) if error else 0)
    """
    run(python, "-c", textwrap.dedent(read_bill), folder / f"lommel-{release.version}.cdx.json")
    read_recipe = """
        import sys
        from rattler_build import Stage0Recipe, VariantConfig
        recipe = Stage0Recipe.from_file(sys.argv[1])
        # A channel sets the C library for all of its packages.
        (rendered,) = recipe.render(VariantConfig({"c_stdlib": ["sysroot"], "c_stdlib_version": ["2.28"]}))
        assert rendered.recipe.package.version == sys.argv[2]
    """
    run(python, "-c", textwrap.dedent(read_recipe), folder / "conda" / "recipe.yaml", release.version)


def before_upload(draft: str) -> list[str]:
    """Return what keeps the last commit from being a release."""
    version = documents.current().version
    log = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    left = []
    if draft:
        left.append("changes/ has fragments, which release-notes.md shows in a draft: run make changelog and commit.")
    if f"## {version}, unreleased" in log:
        left.append(f"CHANGELOG.md calls {version} unreleased: write the date.")
    page = (ROOT / "README.md").read_text(encoding="utf-8")
    if "No release yet" in page:
        left.append(
            "README.md, docs/start.md and docs/versions.md say that there is no release: write how it is installed,"
            " once the name is yours on the package index (a test keeps it out until then)."
        )
    if re.search(r"\]\((?!https?:|#)", page) and "urls" not in documents.project()["project"]:
        left.append(
            "README.md has relative links and pyproject.toml no [project.urls]: a package index shows neither."
        )
    if f"v{version}" not in documents.git("tag", "--points-at", "HEAD").split():
        left.append(f"The commit has no tag: git tag v{version}")
    return left


def readme(release: documents.Release, folder: Path, report: Report, left: list[str]) -> str:
    """Return the page on what is in the folder, where it goes, and what is not in it."""
    compiler = run(os.environ.get("CXX", "c++"), "--version").stdout.splitlines()[0]
    offline = "the packed sources, " + ("without a network" if without_network() else "with indexes switched off")
    rows = [
        f"| `packages/{path.name}` | {report.wheels.get(path.name, 'the wheels are built from it')} |"
        for path in sorted(folder.glob("packages/*"))
    ]
    tools = ", ".join(
        f"{name} {documents.locked(name)}" for name in ("nanobind", "scikit-build-core", "cmake", "ninja")
    )
    missing = [*report.missing, *elsewhere()]
    return "\n".join(
        [
            f"# lommel {release.version}, {release.date}",
            "",
            f"Made of commit {release.commit} by {compiler}; {tools}.",
            f"Wheels are built from {offline}.",
            "",
            *([*("Before uploading:", ""), *(f"- {line}" for line in left), ""] if left else []),
            "| file | tried on |",
            "|---|---|",
            *rows,
            "",
            "Each wheel was installed into an empty environment and computed the first PSF of README.md.",
            "",
            "| what | where it goes |",
            "|---|---|",
            "| `packages/*` | the package index, all in one upload |",
            "| `release-notes.md` | the text of the release of the tag, on the host of the repository |",
            "| `packages/*`, `SHA256SUMS`, `NOTICES.txt`, `*.cdx.json` | its attached files |",
            "| `CITATION.cff`, `.zenodo.json` | the archive that gives a DOI |",
            "| `conda/recipe.yaml` | the conda channel, with `path` replaced by the `url` of the sources |",
            "",
            "Not here, and why:",
            "",
            *(f"- {line}" for line in missing),
            "",
        ]
    )


def elsewhere() -> list[str]:
    """Return what no Linux machine makes."""
    return [
        "Wheels for macOS and Windows, and for older versions of glibc: `.github/workflows/wheels.yml` builds and"
        " tries them.",
        "A wheel for Pyodide: its build takes the Emscripten and the Python that Pyodide itself was built with, which"
        " package indexes do not have. Without Python the core runs in browsers as `lommel/page/lommel-live.js`,"
        " within every wheel.",
    ]


def main() -> None:
    """Make the folder."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--output", type=Path, default=ROOT / "dist" / "release", help="the folder to make")
    parser.add_argument("--arm", type=Path, help="the files of a 64-bit ARM Linux with Python and its headers")
    parser.add_argument("--only", nargs="+", metavar="3.12", help="wheels for these Pythons alone")
    asked = parser.parse_args()
    changed = documents.git("status", "--porcelain")
    if changed:
        raise SystemExit(f"Commit or remove what has changed first:\n{changed}")
    release = documents.current()
    shutil.rmtree(WORK, ignore_errors=True)
    made = WORK / "made"
    (made / "packages").mkdir(parents=True)
    print(f"lommel {release.version} of {release.date}: sources", flush=True)
    archive = sources(release, made / "packages")
    for other in (made / "packages").iterdir():
        if not fnmatch(other.name, "lommel-*.tar.gz"):
            other.unlink()  # uv leaves a .gitignore
    tree, report = unpacked(archive), Report()
    wheels(release, tree, made / "packages", asked.only, report)
    arm_wheel(release, tree, asked.arm and asked.arm.resolve(), made / "packages", report)
    draft = ""
    if list((ROOT / "changes").glob("*.*.md")):
        towncrier = Path(sys.executable).parent / "towncrier"
        words = ["build", "--draft", "--version", release.version, "--date", release.date]
        draft = run(towncrier, *words, cwd=ROOT).stdout
    documents.write(release, made, archive, draft)
    checked(release, made)
    left = before_upload(draft)
    (made / "README.md").write_text(readme(release, made, report, left), encoding="utf-8", newline="\n")
    (made / "SHA256SUMS").write_text(documents.checksums(made), encoding="utf-8", newline="\n")
    asked.output.parent.mkdir(parents=True, exist_ok=True)
    shutil.rmtree(asked.output, ignore_errors=True)
    shutil.move(made, asked.output)
    for line in (*report.missing, *left):
        print(f"note: {line}")
    print(asked.output)


if __name__ == "__main__":
    main()
