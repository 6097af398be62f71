"""What contributors meet is true: workflows, hooks, templates and fragments of the changelog name what is there."""

from __future__ import annotations

import itertools
import os
import re
import shlex
import tomllib
from pathlib import Path

import yaml

ROOT = Path(__file__).resolve().parent.parent
GITHUB = ROOT / ".github"
MAKEFILE = (ROOT / "Makefile").read_text(encoding="utf-8")
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
TARGETS = set(re.findall(r"^([a-z-]+):", MAKEFILE, re.MULTILINE))
GROUPS, EXTRAS = PROJECT["dependency-groups"], PROJECT["project"]["optional-dependencies"]
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
    about = (ROOT / "changes" / "README.md").read_text(encoding="utf-8")
    assert re.findall(r"^- `(\w+)`:", about, re.MULTILINE) == kinds
