"""Set-up, wheels, releases and workflows: what is installed, packed and run is what is stated."""

from __future__ import annotations

import gzip
import hashlib
import importlib.util
import itertools
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tomllib
import venv
import zipfile
from importlib.metadata import distribution, packages_distributions, version
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
import yaml
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
    assert Path(_core.__file__).stat().st_size <= 5.3e6


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


@pytest.mark.parametrize("current", [True, False])
def test_the_live_page_is_made_and_its_compiler_fetched_only_where_its_sources_have_changed(current, place):
    place.make("build")
    place.write(
        "web/build.py", f"import sys\nif sys.argv[1:] == ['--check']: sys.exit({not current})\nopen('made', 'w')"
    )
    fetched = [line for line in place.make_again("page") if has(line, "uv pip install")]
    assert (place.root / "made").exists() == (not current)
    assert [line.endswith("--group page") and has(line, *LOCKED) for line in fetched] == [True] * (not current)


# What the command line needs, and what these need: none of it has the sources of lommel.
WITH = (
    "numpy", "numpy.libs", "scipy", "scipy.libs", "attr", "attrs", "cyclopts", "docstring_parser",
    "rich_rst", "rich", "pygments", "markdown_it", "mdurl", "pydantic",
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


def check(wheel: Path, folder: Path) -> None:
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
    command = [scripts / "python", "-W", "error", ROOT / "tests" / "shared" / "wheel_check.py"]
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
    check(wheel, tmp_path)


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


EPOCH = 1_700_000_000


def module(name: str) -> ModuleType:
    """Return a script of the folder release, which is no package."""
    spec = importlib.util.spec_from_file_location(f"release_{name}", ROOT / "release" / f"{name}.py")
    found = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = found
    spec.loader.exec_module(found)
    return found


documents = module("documents")
RELEASE = documents.Release(documents.project()["project"]["version"], "a" * 40, EPOCH)


@pytest.fixture
def sources(tmp_path):
    """Stand for the packed sources, of which documents have the checksum alone."""
    path = tmp_path / f"lommel-{RELEASE.version}.tar.gz"
    path.write_bytes(b"sources")
    return path


def written(folder: Path, sources: Path) -> dict[str, str]:
    documents.write(RELEASE, folder, sources)
    return {path.relative_to(folder).as_posix(): path.read_text() for path in folder.rglob("*") if path.is_file()}


def test_documents_are_the_same_bytes_in_each_run_with_the_time_of_the_commit(sources, tmp_path, monkeypatch):
    first = written(tmp_path / "a", sources)
    monkeypatch.setenv("TZ", "Asia/Tokyo")
    assert written(tmp_path / "b", sources) == first
    assert RELEASE.date == "2023-11-14"
    for name in ("CITATION.cff", ".zenodo.json", "release-notes.md"):
        assert RELEASE.date in first[name]
    assert "2023-11-14T22:13:20Z" in first[f"lommel-{RELEASE.version}.cdx.json"]
    assert not any(str(ROOT) in text for text in first.values())


def test_the_bill_of_materials_has_all_that_is_linked_and_required_at_the_versions_of_the_lock():
    bill = json.loads(documents.bill(RELEASE))
    parts = {part["bom-ref"]: part for part in bill["components"]}
    assert len(parts) == len(bill["components"])
    texts = {path.stem for path in (ROOT / "LICENSES").glob("*.txt")}
    assert {f"linked/{name}" for name in texts} == {ref for ref in parts if ref.startswith("linked/")}
    lock = (ROOT / "requirements.lock").read_text()
    assert f"\nnanobind=={parts['linked/nanobind']['version']} " in lock
    assert re.fullmatch(r"\d+\.\d+\.\d+", parts["linked/robin-map"]["version"])
    licences = {ref: part["licenses"][0]["expression"] for ref, part in parts.items() if "licenses" in part}
    assert licences["linked/libcxxabi"] == "Apache-2.0 WITH LLVM-exception"
    assert licences["linked/wasi-libc"] == licences["linked/robin-map"] == "MIT"
    where = {ref: part["properties"][0]["value"] for ref, part in parts.items() if "properties" in part}
    assert "_core" in where["linked/robin-map"]
    assert "lommel-live.js" in where["linked/musl"]
    packages = {ref: part for ref, part in parts.items() if ref.startswith("package/")}
    assert {part["name"] for part in packages.values() if part["scope"] == "required"} == {"numpy", "scipy"}
    assert {"package/matplotlib", "package/cyclopts", "package/h5py"} <= set(packages)
    assert all(f"\n{part['name']}=={part['version']} " in lock for part in packages.values())
    assert bill["dependencies"] == [{"ref": "lommel", "dependsOn": sorted(parts)}]


def test_notices_have_every_licence_text_whole():
    text = documents.notices()
    for path in (ROOT / "LICENSE", *(ROOT / "LICENSES").glob("*.txt")):
        assert path.read_text(encoding="utf-8").strip() in text


def test_the_recipe_asks_for_what_pyproject_asks_for(sources):
    text = documents.recipe(RELEASE, sources)
    recipe = yaml.safe_load(text)
    project = documents.project()
    asked = recipe["requirements"]
    for given, lines in (("run", project["project"]["dependencies"]), ("host", project["build-system"]["requires"])):
        assert {line.replace(">", " >") for line in lines} <= set(asked[given])
    assert f"python {project['project']['requires-python']}" in asked["run"]
    assert f"cmake {project['tool']['scikit-build']['cmake']['version']}" in asked["build"]
    (entry,) = recipe["build"]["python"]["entry_points"]
    assert entry == " = ".join(*project["project"]["scripts"].items())
    assert recipe["source"]["sha256"] == hashlib.sha256(b"sources").hexdigest()
    assert recipe["context"]["version"] == RELEASE.version
    assert recipe["about"]["license"] == project["project"]["license"]


def test_packed_sources_have_no_trace_of_time_place_and_user(tmp_path, monkeypatch):
    # A project of a few files: that of all takes seconds, and is packed by the same code.
    tree = tmp_path / "tree"
    tree.mkdir()
    for name in ("pyproject.toml", "README.md", "LICENSE", "CMakeLists.txt", ".gitignore"):
        shutil.copyfile(ROOT / name, tree / name)
    for name in ("LICENSES", "cmake"):
        shutil.copytree(ROOT / name, tree / name)
    page = tree / "src" / "lommel" / "page"
    page.mkdir(parents=True)
    (page / "lommel-live.js").write_text("// as make page writes it")
    (tree / "build").mkdir()
    (tree / "build" / "left.txt").write_text("not a source")
    monkeypatch.chdir(tree)
    monkeypatch.setenv("SOURCE_DATE_EPOCH", str(EPOCH))
    from scikit_build_core.build import build_sdist

    archives = [tmp_path / name / build_sdist(tmp_path / name) for name in ("one", "two")]
    assert archives[0].read_bytes() == archives[1].read_bytes()
    packed = archives[0].read_bytes()
    assert int.from_bytes(packed[4:8], "little") == EPOCH
    assert gzip.decompress(packed)
    with tarfile.open(archives[0]) as tar:
        members = tar.getmembers()
    assert {member.mtime for member in members} == {EPOCH}
    assert {(member.uid, member.gid, member.uname, member.gname) for member in members} == {(0, 0, "", "")}
    names = [member.name.partition("/")[2] for member in members]
    assert "src/lommel/page/lommel-live.js" in names
    assert "build/left.txt" not in names
    assert {"pyproject.toml", "CMakeLists.txt", "LICENSES/nanobind.txt"} <= set(names)


PACKED = {
    ".ci", ".clang-format", ".clang-tidy", ".editorconfig", ".gitattributes", ".github", ".gitignore",
    ".pre-commit-config.yaml",
    "CHANGELOG.md", "CITATION.cff", "CMakeLists.txt", "CMakePresets.json", "CONTRIBUTING.md", "LICENSE", "LICENSES",
    "Makefile", "PKG-INFO", "README.md", "SECURITY.md", "benchmarks", "changes", "cmake", "cpp", "docs", "examples",
    "paper.bib", "paper.md", "pyproject.toml", "release", "requirements.lock", "src", "tests", "tools", "web",
}  # fmt: skip


@pytest.mark.quick
def test_sources_are_packed_with_these_files_and_folders_at_the_top_alone(tmp_path, monkeypatch):
    command = ["git", "ls-files", "--cached", "--others", "--exclude-standard", "-z"]
    listed = subprocess.run(command, cwd=ROOT, capture_output=True, encoding="utf-8", check=False)
    if listed.returncode:
        pytest.skip("the sources are not a git repository")
    # Of each folder one empty file will do: to pack all of them takes seconds.
    tree = tmp_path / "tree"
    there = [name for name in listed.stdout.split("\0") if name and (ROOT / name).is_file()]
    for name in {name.partition("/")[0]: name for name in reversed(there)}.values():
        (tree / name).parent.mkdir(parents=True, exist_ok=True)
        (tree / name).touch()
    for name in ("pyproject.toml", "README.md", "LICENSE", "CMakeLists.txt", ".gitignore"):
        shutil.copyfile(ROOT / name, tree / name)
    monkeypatch.chdir(tree)
    from scikit_build_core.build import build_sdist

    with tarfile.open(tmp_path / build_sdist(tmp_path)) as tar:
        assert {member.name.split("/")[1] for member in tar} == PACKED


def test_the_release_imports_only_what_its_target_installs():
    installed = FIRST | {
        canonicalize_name(Requirement(text).name) for text in GROUPS["maintain"] if isinstance(text, str)
    }
    pages = [path.read_text(encoding="utf-8") for path in (ROOT / "release").glob("*.py")]
    names = {name for page in pages for name in re.findall(r"^(?:import|from) (\w+)", page, re.MULTILINE)}
    owners = packages_distributions()
    assert {canonicalize_name(owner) for name in names for owner in owners.get(name, ())} <= installed
    assert "yaml" in names


@pytest.mark.skipif(not os.environ.get("LOMMEL_RELEASE"), reason="half an hour; LOMMEL_RELEASE=1 makes two releases")
def test_two_releases_are_the_same_bytes(tmp_path):
    made = []
    for name in ("one", "two"):
        command = [sys.executable, ROOT / "release" / "build.py", "--output", tmp_path / name]
        subprocess.run(command, check=True, env=os.environ | {"CCACHE_DISABLE": "1"})
        files = sorted(path for path in (tmp_path / name).rglob("*") if path.is_file())
        made.append({path.relative_to(tmp_path / name).as_posix(): path.read_bytes() for path in files})
    assert any(name.endswith(".whl") for name in made[0])
    assert made[0].keys() == made[1].keys()
    assert [name for name in made[0] if made[0][name] != made[1][name]] == []
    sums = subprocess.run(["sha256sum", "--check", "--quiet", "SHA256SUMS"], cwd=tmp_path / "one", check=False)
    assert sums.returncode == 0


GITHUB = ROOT / ".github"
MAKEFILE = (ROOT / "Makefile").read_text(encoding="utf-8")
TARGETS = set(re.findall(r"^([a-z-]+):", MAKEFILE, re.MULTILINE))
WORKFLOWS = {path.name: yaml.safe_load(path.read_text(encoding="utf-8")) for path in GITHUB.glob("workflows/*.yml")}
STEPS = [
    (f"{name}: {job}", step)
    for name, workflow in WORKFLOWS.items()
    for job, described in workflow["jobs"].items()
    for step in described["steps"]
]


def faults(command: str) -> list[str]:
    """What a line of a workflow names that is not there: targets, scripts, files, groups and extras."""
    first, *words = shlex.split(command)
    if first == "make":
        return [f"no target {word}" for word in words if "=" not in word and word not in TARGETS]
    if first not in ("python", ".tools/uv"):
        return [] if os.access(ROOT / first, os.X_OK) else [f"{first} cannot be run"]
    pairs = [*itertools.pairwise(words)]
    found = [f"no group {name}" for option, name in pairs if option == "--group" and name not in GROUPS]
    found += [f"no extra {name}" for option, name in pairs if option == "--extra" and name not in EXTRAS]
    files = [name for option, name in pairs if option in ("--constraint", "--requirement")]
    return found + [f"no file {name}" for name in files if not (ROOT / name).is_file()]


def test_workflows_run_what_is_there():
    lines = [(where, line) for where, step in STEPS for line in step.get("run", "").splitlines()]
    assert {line for _, line in lines} >= {".ci/run", "make lowest PYTHON=python3.11", "make tidy sanitize"}
    assert {f"{where}: {line}": found for where, line in lines if (found := faults(line))} == {}
    assert faults("make nothing") == ["no target nothing"]
    assert faults(".tools/uv pip install --constraint x.txt --extra x --group y") == [
        "no group y",
        "no extra x",
        "no file x.txt",
    ]


def test_workflows_install_packages_by_their_hashes_alone():
    run = [line for _, step in STEPS for line in step.get("run", "").splitlines()]
    lines = [line for line in run if "install" in line]
    assert lines
    for line in lines:
        assert "--require-hashes" in line or "--no-deps" in line, line
    # What fetches a tool at whichever version there is, and runs it.
    assert not [line for line in run if re.search(r"pipx|\buvx\b|\buv(\.exe)? (tool|run)\b|npx|pip install uv", line)]


def test_workflows_may_only_read_and_pin_what_they_use():
    for name, workflow in WORKFLOWS.items():
        assert workflow["permissions"] == {"contents": "read"}, name
    checkouts = [step for _, step in STEPS if step.get("uses", "").startswith("actions/checkout@")]
    assert all(step["with"]["persist-credentials"] is False for step in checkouts)
    used = [step["uses"] for _, step in STEPS if "uses" in step]
    assert used
    assert [use for use in used if not re.fullmatch(r"[\w-]+/[\w-]+@[0-9a-f]{40}", use)] == []


def test_every_fragment_of_the_changelog_has_a_known_type():
    kinds = [kind["directory"] for kind in PROJECT["tool"]["towncrier"]["type"]]
    pattern = re.compile(rf"(\d+|\+[\w-]+)\.({'|'.join(kinds)})(\.\d+)?\.md")
    names = [path.name for path in (ROOT / "changes").iterdir() if path.name != "README.md"]
    assert [name for name in names if not pattern.fullmatch(name)] == []
    assert [name for name in names if (ROOT / "changes" / name).read_text(encoding="utf-8").startswith("- ")] == []
    about = (ROOT / "changes" / "README.md").read_text(encoding="utf-8")
    assert re.findall(r"^- `(\w+)`:", about, re.MULTILINE) == kinds
