"""Options that are declared once, as defaults of arguments and in groups that commands share."""

from __future__ import annotations

import json

import click
from click.testing import CliRunner

from lommel.cli.options import JSON, Group, command, option
from lommel.cli.output import Report


class Shared(Group, heading="Camera"):
    """Options of several commands."""

    gain: float | None = option("--gain", type=float, help="Electrons per count.")
    read: float | None = option("--read", type=float)
    pixel: float | None = option("--pixel", type=float)


class Own(Shared, heading="Camera and noise"):
    """The same, one with another name, one more, one less."""

    gain: float | None = option("--white", type=float, default=1.0)
    pixel: float | None = None
    window: int = option("--window", type=int, default=9)


class Outer(Group, heading="All"):
    """A group with another in its middle, under its own heading."""

    size: int = option("--side", type=int, default=3)
    camera: Shared = Shared()
    name: str = option(default="a")


FILE = click.Argument(["file"])


@command(JSON)
def first(
    name: str = FILE,
    size: int = option("--side", type=int, default=3),
    camera: Shared = Shared(),  # noqa: B008
) -> Report:
    """Print what it takes."""
    return Report({"name": name, "size": size, **vars(camera)}, [])


@command()
def second(camera: Own = Own()) -> Report:  # noqa: B008
    """Print what it takes."""
    return Report({}, [f"{camera.gain} {camera.read} {camera.pixel} {camera.window}"])


@command()
def third(outer: Outer = Outer()) -> Report:  # noqa: B008
    """Print what it takes."""
    return Report({}, [f"{outer.size} {outer.camera.read} {outer.name}"])


def test_values_reach_arguments_and_groups_by_the_names_that_these_have():
    found = CliRunner().invoke(first, ["a", "--side", "4", "--gain", "0.5", "--json"])
    assert json.loads(found.stdout) == {"name": "a", "size": 4, "gain": 0.5, "read": None, "pixel": None}


def test_a_group_replaces_in_place_and_leaves_out_options_of_its_base():
    assert [one.opts for one in Own.options()] == [["--white"], ["--read"], ["--window"]]
    assert CliRunner().invoke(second, ["--read", "2"]).stdout == "1.0 2.0 None 9\n"
    assert "No such option" in CliRunner().invoke(second, ["--gain", "2"]).stderr


def test_help_has_the_options_under_the_heading_of_their_group():
    shown = CliRunner().invoke(first, ["--help"]).stdout
    assert shown.startswith("Usage: first [OPTIONS] NAME\n")
    options, camera = shown.index("\nOptions:\n"), shown.index("\nCamera:\n")
    assert options < shown.index("--side") < shown.index("--json") < camera < shown.index("--gain")


def test_a_group_holds_others_in_place_under_their_own_heading():
    assert [one.opts[0] for one in Outer.options()] == ["--side", "--gain", "--read", "--pixel", "--name"]
    assert CliRunner().invoke(third, ["--read", "2", "--side", "4"]).stdout == "4 2.0 a\n"
    shown = CliRunner().invoke(third, ["--help"]).stdout
    assert shown.index("\nAll:\n") < shown.index("--name") < shown.index("\nCamera:\n") < shown.index("--gain")
