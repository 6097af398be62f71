"""Pictures and outputs of pages, from the code and commands above them; as a script, draw those kept with them."""

from __future__ import annotations

import ast
import io
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import chdir, redirect_stdout
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure
from PIL import Image

DOCS = Path(__file__).resolve().parents[2] / "docs"
PAGE = DOCS / "pictures.md"
# Pages whose code and commands run from top to bottom in an empty folder.
TUTORIALS = [DOCS / f"start{field}.md" for field in ("", "-camera", "-class", "-depth", "-microscope", "-telescope")]
TUTORIALS.append(DOCS / "apertures.md")
# Pictures kept beside the pages, for readers of the repository: pages name them in this folder.
KEPT = DOCS / "start"
# A block of code, of commands, of a file named in its first line or of what was printed; a picture.
_PARTS = re.compile(
    r"^```(?P<language>python|sh|toml|text)\n(?P<code>.*?)^```"
    r"|(?:_generated/pictures|\(start)/(?P<picture>[\w-]+)\.png",
    re.MULTILINE | re.DOTALL,
)
# The numbers that a comment begins with.
_NUMBERS = re.compile(r"\(?(-?\d[\d.e-]*(?:, ?-?\d[\d.e-]*)*)[,)]*(?=[ :;]|$)")

Made = Figure | Path | str


def parts(page: Path, text: str | None = None) -> Iterator[tuple[str, Made]]:
    """Run the code and commands of a page in the current folder; yield pictures with their names, and printed texts.

    A picture is the file of its name, where a command wrote one, or else the last figure that code drew. What was
    printed comes with the text that the page shows.
    """
    names: dict[str, Any] = {}
    printed = ""
    for part in _PARTS.finditer(page.read_text(encoding="utf-8") if text is None else text):
        if part["language"] == "python":
            plt.close("all")
            with redirect_stdout(io.StringIO()) as stream:
                run(part["code"], names, page.name)
            printed = stream.getvalue()
        elif part["language"] == "sh":
            if part["code"].startswith("lommel "):
                printed = command(part["code"], page.name)
        elif part["language"] == "toml":
            first = part["code"].partition("\n")[0]
            Path(first.removeprefix("# ")).write_text(part["code"], encoding="utf-8")  # a file that the reader saves
        elif part["language"] == "text":
            if not printed:
                raise ValueError(f"{page.name}: no code above prints {part['code']}")
            yield part["code"], printed
        else:
            name, written = part["picture"], Path(f"{part['picture']}.png")
            if not (written.exists() or plt.get_fignums()):
                raise ValueError(f"{page.name}: no code above the picture {name} draws one")
            yield name, written if written.exists() else plt.gcf()
    plt.close("all")


def run(code: str, names: dict[str, Any], where: str) -> None:
    """Run code; of an expression with numbers in the comment behind it, check that these are its value."""
    lines = code.splitlines()
    for statement in ast.parse(code).body:
        if not isinstance(statement, ast.Expr):
            exec(compile(ast.Module([statement], []), where, "exec"), names)
            continue
        value = eval(compile(ast.Expression(statement.value), where, "eval"), names)
        comment = lines[(statement.end_lineno or 1) - 1].encode()[statement.end_col_offset :].decode().strip()
        if stated := _NUMBERS.match(comment.removeprefix("# ")):
            _compare(value, stated[1].replace(" ", "").split(","), f"{where}: {ast.unparse(statement)}")


def _compare(value: Any, stated: list[str], where: str) -> None:
    """Raise ValueError if a value rounded to the digits stated is another."""
    found = np.ravel(np.asarray(value, dtype=float))
    digits = [len(re.sub(r"e.*|^-?0?[.]?0*|[.]", "", text)) or 1 for text in stated]
    shown = [float(f"{each:.{count}g}") for each, count in zip(found, digits, strict=False)]
    if len(found) != len(stated) or shown != [float(text) for text in stated]:
        raise ValueError(f"{where}: the comment states {', '.join(stated)}, but the value is {value}")


def command(lines: str, where: str) -> str:
    """Run commands as a shell does, with the `lommel` of this Python, and return what they print."""
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ.get('PATH', '')}"
    environment = os.environ | {"PATH": path, "COLUMNS": "92", "MPLBACKEND": "Agg", "PYTHONUTF8": "1"}
    done = subprocess.run(["sh", "-euc", lines], env=environment, capture_output=True, encoding="utf-8", check=False)
    if done.returncode:
        raise ValueError(f"{where}: {lines}{done.stderr}")
    return done.stdout


def first_psf() -> Figure:
    """Return the figure that the first code of README.md draws."""
    plt.close("all")
    text = (DOCS.parent / "README.md").read_text(encoding="utf-8")
    code = next(part["code"] for part in _PARTS.finditer(text) if part["language"] == "python")
    exec(compile(code, "README.md", "exec"), {})
    return plt.gcf()


def write(folder: Path, pages: list[Path] | None = None) -> None:
    """Write the pictures of pages, by default pictures.md and the tutorials, into `pictures` in a folder."""
    (folder / "pictures").mkdir(parents=True, exist_ok=True)
    for page in pages or [PAGE, *TUTORIALS]:
        with tempfile.TemporaryDirectory() as empty, chdir(empty):
            for name, made in parts(page):
                if not isinstance(made, str) and name not in kept(page):
                    save(made, folder / "pictures" / f"{name}.png")


def kept(page: Path) -> list[str]:
    """Return the names of the pictures of a page that are kept beside it."""
    return re.findall(r"\(start/([\w-]+)\.png\)", page.read_text(encoding="utf-8"))


def save(made: Figure | Path, path: Path) -> None:
    """Write a figure, or copy the file of a picture."""
    if isinstance(made, Path):
        shutil.copy(made, path)
    else:
        made.savefig(path, dpi=110)


def write_kept() -> None:
    """Draw the pictures kept beside the tutorials anew, with 256 colours, and print what these show."""
    KEPT.mkdir(exist_ok=True)
    for page in TUTORIALS:
        text, names = page.read_text(encoding="utf-8"), kept(page)
        with tempfile.TemporaryDirectory() as empty, chdir(empty):
            for name, made in parts(page, text):
                if isinstance(made, str):
                    text = text.replace(f"```text\n{name}```", f"```text\n{beginning(made, name)}```")
                elif name in names:
                    save(made, KEPT / f"{name}.png")
                    with Image.open(KEPT / f"{name}.png") as picture:
                        few = picture.convert("RGB").quantize(256, dither=Image.Dither.NONE)
                    few.save(KEPT / f"{name}.png", optimize=True)
        page.write_text(text, encoding="utf-8")


def beginning(printed: str, shown: str) -> str:
    """Return as many lines of a printed text as are shown, if these end with a line of three dots."""
    lines = shown.splitlines()
    return "\n".join([*printed.splitlines()[: len(lines) - 1], "...", ""]) if lines[-1] == "..." else printed


def same(shown: str, printed: str) -> bool:
    """Return whether a printed text is the one shown, but for times and small differences of numbers."""
    printed = beginning(printed, shown)
    number = r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?"
    texts = [" ".join(re.sub(r"[\d.]+ m?s\b", "", text).split()) for text in (shown, printed)]
    words, others = (re.sub(number, "#", text) for text in texts)
    values, found = (np.array(re.findall(number, text), dtype=float) for text in texts)
    return words == others and bool(np.allclose(values, found, rtol=0.02, atol=1e-3))


if __name__ == "__main__":
    figure = first_psf()
    figure.set_size_inches(5.4, 4.0)
    figure.savefig(DOCS / "first-psf.png", dpi=100)
    write_kept()
