"""The folder of a release: its documents say what is in it, and the same commit gives the same bytes."""

from __future__ import annotations

import gzip
import hashlib
import importlib.util
import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
from pathlib import Path
from types import ModuleType

import pytest
import yaml

ROOT = Path(__file__).resolve().parent.parent
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
    assert {"package/matplotlib", "package/click", "package/h5py"} <= set(packages)
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
