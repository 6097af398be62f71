"""The documents of a release: bill of materials, notices, notes, citation, metadata for archives, conda recipe.

Each is made of files of the sources and of the last commit alone, so that the same commit gives the same bytes.
"""

from __future__ import annotations

import hashlib
import importlib.util
import json
import re
import subprocess
import tomllib
import uuid
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import yaml

ROOT = Path(__file__).resolve().parent.parent
# Linked dynamically, so not in the wheels: what auditwheel allows to be left to the system.
SYSTEM = {
    "libstdc++": ("the C++ library of GCC", "GPL-3.0-or-later WITH GCC-exception-3.1"),
    "libgcc": ("the runtime library of GCC", "GPL-3.0-or-later WITH GCC-exception-3.1"),
    "glibc": ("the C library of GNU", "LGPL-2.1-or-later"),
}


@dataclass(frozen=True)
class Release:
    """A version of the package as a commit has it."""

    version: str
    commit: str
    epoch: int
    """The time of the commit, in seconds since 1970."""

    @property
    def date(self) -> str:
        """Return the day of the commit in UTC."""
        return f"{datetime.fromtimestamp(self.epoch, UTC):%Y-%m-%d}"


def git(*words: str) -> str:
    """Return what git says of the repository."""
    run = subprocess.run(["git", *words], cwd=ROOT, check=True, capture_output=True, encoding="utf-8")
    return run.stdout.strip()


def project() -> dict[str, Any]:
    """Return pyproject.toml."""
    return tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))


def current() -> Release:
    """Return the release that the last commit makes."""
    commit, epoch = git("log", "-1", "--format=%H %ct").split()
    return Release(project()["project"]["version"], commit, int(epoch))


def locked(name: str) -> str:
    """Return the version of a package in requirements.lock."""
    lock = (ROOT / "requirements.lock").read_text(encoding="utf-8")
    found = re.search(rf"^{re.escape(name)}==([^ ;]+)", lock, re.MULTILINE)
    if not found:
        raise ValueError(f"requirements.lock does not pin {name}: run make lock")
    return found[1]


def notice_rows() -> list[tuple[str, str, str, str, str]]:
    """Return name, text, home page, place and SPDX licence of all that wheels include, from LICENSES/README.md."""
    rows = []
    place = licence = ""
    for line in (ROOT / "LICENSES" / "README.md").read_text(encoding="utf-8").splitlines():
        if not line.startswith("| `"):
            continue
        files, of, where, terms = (cell.strip() for cell in line.strip("|").split("|"))
        place = place if where == "the same" else where.replace("`", "")
        found = re.match(r"[\w.-]+(?: WITH [\w.-]+)?", terms)
        assert found, line
        licence = found[0]
        home = re.search(r"\]\((.*?)\)", of)
        text = re.sub(r"\[(.*?)\]\(.*?\)", r"\1", of)
        rows += [
            (name, text, home[1] if home else "", place, licence) for name in re.findall(r"`([\w-]+)\.txt`", files)
        ]
    return rows


def robin_map() -> str:
    """Return the version of robin-map that the installed nanobind brings, which its header states."""
    spec = importlib.util.find_spec("nanobind")
    assert spec is not None
    assert spec.origin is not None
    header = Path(spec.origin).parent / "ext" / "robin_map" / "include" / "tsl" / "robin_growth_policy.h"
    numbers = dict(re.findall(r"TSL_RH_VERSION_(\w+) (\d+)", header.read_text(encoding="utf-8")))
    return ".".join(numbers[part] for part in ("MAJOR", "MINOR", "PATCH"))


def required(extra: str | None = None) -> set[str]:
    """Return the names of the packages that lommel requires, or that an extra adds."""
    table = project()["project"]
    names: set[str] = set()
    for line in table["dependencies"] if extra is None else table["optional-dependencies"][extra]:
        own = re.fullmatch(r"lommel\[(.*)\]", line)
        if own:
            names = names.union(*(required(part) for part in own[1].split(",")))
        else:
            names.add(re.split(r"[\[<>=!~ ;]", line)[0].lower())
    return names


def bill(release: Release) -> str:
    """Return the software bill of materials: CycloneDX 1.6, JSON.

    What is compiled into the wheels, the libraries of the system that they load, and the packages that are required,
    at the versions of the lock.
    """
    zig = locked("ziglang")
    versions = {"nanobind": locked("nanobind"), "robin-map": robin_map(), "zig": zig}
    components = []
    for name, text, home, place, licence in notice_rows():
        brought = f"nanobind {versions['nanobind']}" if "_core" in place else f"ziglang {zig}"
        component: dict[str, Any] = {"type": "library", "bom-ref": f"linked/{name}", "name": name}
        if name in versions:
            component["version"] = versions[name]
        component |= {"description": text, "scope": "required", "licenses": [{"expression": licence}]}
        if name == "nanobind":
            component["purl"] = f"pkg:pypi/nanobind@{versions[name]}"
        if home:
            component["externalReferences"] = [{"type": "website", "url": home}]
        facts = {"lommel:linked": place, "lommel:brought-by": brought}
        component["properties"] = [{"name": key, "value": value} for key, value in facts.items()]
        components.append(component)
    for name, (text, licence) in SYSTEM.items():
        components.append(
            {"type": "library", "bom-ref": f"system/{name}", "name": name, "description": text, "scope": "required"}
            | {"licenses": [{"expression": licence}]}
            | {
                "properties": [
                    {"name": "lommel:linked", "value": "loaded from the system on Linux, not in the wheels"}
                ]
            }
        )
    always = required()
    for name in sorted(always | required("all")):
        version = locked(name)
        components.append(
            {"type": "library", "bom-ref": f"package/{name}", "name": name, "version": version}
            | {"scope": "required" if name in always else "optional", "purl": f"pkg:pypi/{name}@{version}"}
        )
    table = project()["project"]
    itself = {"type": "library", "bom-ref": "lommel", "name": "lommel", "version": release.version}
    itself |= {"description": table["description"], "licenses": [{"expression": table["license"]}]}
    itself["purl"] = f"pkg:pypi/lommel@{release.version}"
    document = {
        "bomFormat": "CycloneDX",
        "specVersion": "1.6",
        "serialNumber": f"urn:uuid:{uuid.uuid5(uuid.NAMESPACE_OID, release.commit)}",
        "version": 1,
        "metadata": {
            "timestamp": f"{datetime.fromtimestamp(release.epoch, UTC):%Y-%m-%dT%H:%M:%SZ}",
            "component": itself,
            "properties": [{"name": "lommel:commit", "value": release.commit}],
        },
        "components": components,
        "dependencies": [{"ref": "lommel", "dependsOn": sorted(part["bom-ref"] for part in components)}],
    }
    return json.dumps(document, indent=2, ensure_ascii=False) + "\n"


def notices() -> str:
    """Return the licence of lommel, and the notices of all that wheels include."""
    parts = [("lommel", "the package itself", (ROOT / "LICENSE").read_text(encoding="utf-8"))]
    for name, text, _, place, licence in notice_rows():
        about = f"{text}: {place}; {licence}"
        parts.append((name, about, (ROOT / "LICENSES" / f"{name}.txt").read_text(encoding="utf-8")))
    line = "=" * 78
    return "\n".join(f"{line}\n{name}\n{about}\n{line}\n\n{text.strip()}\n" for name, about, text in parts)


def sections(version: str) -> str:
    """Return the sections of the changelog on a version, without their headings."""
    parts = re.split(r"^## ", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), flags=re.MULTILINE)[1:]
    mine = [
        body for head, _, body in (part.partition("\n") for part in parts) if head.split(",")[0].strip() == version
    ]
    if not mine:
        raise ValueError(f"CHANGELOG.md has no section on {version}: run make changelog")
    return "\n\n".join(body.strip() for body in mine)


def notes(release: Release, draft: str = "") -> str:
    """Return the release notes: the changelog of the version, after what fragments in changes/ would add to it."""
    more = re.sub(r"^## .*\n", "", draft.strip(), flags=re.MULTILINE).strip()
    body = "\n\n".join(part for part in (more, sections(release.version)) if part)
    end = f"Commit {release.commit}. Checksums are in SHA256SUMS, the notices of included code in NOTICES.txt."
    return f"# lommel {release.version}, {release.date}\n\n{body}\n\n{end}\n"


def citation(release: Release) -> str:
    """Return CITATION.cff with version, date and commit."""
    text = (ROOT / "CITATION.cff").read_text(encoding="utf-8").rstrip()
    return f"{text}\nversion: {release.version}\ndate-released: {release.date}\ncommit: {release.commit}\n"


def archive(release: Release) -> str:
    """Return .zenodo.json, what an archive of research software asks for."""
    cited = yaml.safe_load(citation(release))
    entry = {
        "title": f"{cited['title']} {release.version}: {project()['project']['description']}",
        "upload_type": "software",
        "description": cited["abstract"],
        "creators": [{"name": author["name"]} for author in cited["authors"]],
        "license": cited["license"],
        "version": release.version,
        "publication_date": release.date,
        "access_right": "open",
        "keywords": cited["keywords"],
        "related_identifiers": [
            {"identifier": work["doi"], "relation": "cites", "resource_type": "publication-article"}
            for work in cited["references"]
        ],
    }
    return json.dumps(entry, indent=2, ensure_ascii=False) + "\n"


def recipe(release: Release, sources: Path) -> str:
    """Return the conda recipe of the packed sources."""
    text = (ROOT / "release" / "recipe.yaml").read_text(encoding="utf-8")
    fields = {"VERSION": release.version, "SHA256": hashlib.sha256(sources.read_bytes()).hexdigest()}
    for name in ("numpy", "scipy"):
        (line,) = (line for line in project()["project"]["dependencies"] if line.startswith(name))
        fields[name.upper()] = line.replace(">", " >")
    for name, value in fields.items():
        text = text.replace(f"@{name}@", value)
    assert "@" not in text
    return text


def checksums(folder: Path) -> str:
    """Return the SHA-256 sums of all files in a folder, for sha256sum --check."""
    files = sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file())
    sums = {name: hashlib.sha256((folder / name).read_bytes()).hexdigest() for name in files if name != "SHA256SUMS"}
    return "".join(f"{value}  {name}\n" for name, value in sums.items())


def write(release: Release, folder: Path, sources: Path, draft: str = "") -> None:
    """Write all documents but the checksums."""
    made = {
        f"lommel-{release.version}.cdx.json": bill(release),
        "NOTICES.txt": notices(),
        "release-notes.md": notes(release, draft),
        "CITATION.cff": citation(release),
        ".zenodo.json": archive(release),
        "conda/recipe.yaml": recipe(release, sources),
    }
    for name, text in made.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8", newline="\n")
