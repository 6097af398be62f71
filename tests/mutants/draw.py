"""Faults drawn by a seed: lines of the code at random, and on each an operator, a constant, a condition or a check.

A change replaces text: (start, end, new). In Python they come from the syntax tree; in C++ from the tokens, each
as the expression or statement around it, which run.py can put behind a switch. Comments, docstrings, annotations,
messages of errors and __repr__ have none, nor what C++ needs while it compiles.
"""

from __future__ import annotations

import ast
import io
import random
import re
import tokenize
from collections.abc import Iterator
from itertools import accumulate

Change = tuple[int, int, str]

COMPARED = {
    "<": ("<=", ">="), "<=": ("<", ">"), ">": (">=", "<="), ">=": (">", "<"), "==": ("!=",), "!=": ("==",),
    "is": ("is not",), "is not": ("is",), "in": ("not in",), "not in": ("in",),
}  # fmt: skip
COMPUTED = {
    "+": ("-",), "-": ("+",), "*": ("/",), "/": ("*",), "//": ("*", "%"), "%": ("*",), "**": ("*",), "&": ("|",),
    "|": ("&",), "<<": (">>",), ">>": ("<<",), "^": ("&",),
}  # fmt: skip
JOINED = {"and": ("or",), "or": ("and",), "&&": ("||",), "||": ("&&",)}
SWAPPED = {
    "min": "max", "minimum": "maximum", "fmin": "fmax", "any": "all", "floor": "ceil", "sin": "cos",
    "argmin": "argmax",
}  # fmt: skip
SWAPPED |= {new: old for old, new in SWAPPED.items()}


def numbers(text: str) -> tuple[str, ...]:
    """Return what a number becomes: one more or one less, or twice as much."""
    if re.fullmatch(r"(0[xX][\dA-Fa-f_]+|\d[\d_]*)", text):
        value = int(text, 0)
        return (str(value + 1),) if value == 0 else (str(value + 1), str(value - 1))
    try:
        value = float(text.replace("'", ""))
    except ValueError:
        return ()
    return ("1.0",) if value == 0.0 else (repr(2.0 * value), repr(0.5 * value))


# Arguments that change what memory is used, or how something looks.
_UNSEEN = {"copy", "repr", "stacklevel", "alpha", "fontsize", "linewidth", "markersize", "pad_edge", "zorder"}


class _Python:
    """The places of a Python file."""

    def __init__(self, text: str) -> None:
        self.text, self.found = text, list[Change]()
        lines = text.splitlines(keepends=True)
        self.lines, self.starts = lines, [0, *accumulate(map(len, lines))]
        reader = tokenize.generate_tokens(io.StringIO(text).readline)
        kinds = (tokenize.OP, tokenize.NAME)
        self.tokens = [(self.starts[t.start[0] - 1] + t.start[1], t.string) for t in reader if t.type in kinds]
        self.visit(ast.parse(text))

    def span(self, node: ast.AST) -> tuple[int, int]:
        """Return where a node is, which ast counts in bytes."""
        first, last = node.lineno - 1, node.end_lineno - 1
        start = len(self.lines[first].encode()[: node.col_offset].decode())
        end = len(self.lines[last].encode()[: node.end_col_offset].decode())
        return self.starts[first] + start, self.starts[last] + end

    def between(self, left: ast.AST, right: ast.AST, table: dict[str, tuple[str, ...]]) -> None:
        """Add what replaces the operator between two operands."""
        begin, end = self.span(left)[1], self.span(right)[0]
        here = [(at, string) for at, string in self.tokens if begin <= at < end and string not in "()"]
        old = " ".join(string for _, string in here)
        if here and old in table:
            stop = here[-1][0] + len(here[-1][1])
            self.found += [(here[0][0], stop, new) for new in table[old]]

    def replace(self, node: ast.AST, *news: str) -> None:
        """Add what replaces a node."""
        self.found += [(*self.span(node), new) for new in news]

    def negate(self, test: ast.expr) -> None:
        """Add the opposite of a condition."""
        start, end = self.span(test)
        if not isinstance(test, ast.UnaryOp):
            self.replace(test, f"(not ({self.text[start:end]}))")

    def visit(self, node: ast.AST) -> None:
        """Add what is in a node."""
        match node:
            case ast.FunctionDef(name="__repr__" | "__str__" | "_repr_html_" | "_repr_png_"):
                return
            case ast.If(test=ast.Name(id="TYPE_CHECKING")) | ast.JoinedStr() | ast.Assert():
                return
            case ast.Assign(targets=[ast.Name(id="__all__")]) | ast.Import() | ast.ImportFrom():
                return
            case ast.Subscript(value=ast.Name(id="Literal" | "Annotated")):
                return
            case ast.Raise(exc=ast.Call()):
                # The text of a message is not looked into; that it comes is.
                self.replace(node, "pass")
                return
            case ast.Expr(value=ast.Call(func=ast.Attribute(value=ast.Name(id="warnings" | "logging" | "logger")))):
                return
            case ast.keyword(arg=str(name)) if name in _UNSEEN:
                return
            case ast.Expr(value=ast.Call()):
                self.replace(node, "pass")
            case ast.Compare(ops=[_]):
                self.between(node.left, node.comparators[0], COMPARED)
            case ast.Compare():
                for left, right in zip([node.left, *node.comparators], node.comparators, strict=False):
                    self.between(left, right, COMPARED)
            case ast.BinOp() if not _is_text(node.left) and not _is_text(node.right):
                self.between(node.left, node.right, COMPUTED)
            case ast.BoolOp():
                for left, right in zip(node.values, node.values[1:], strict=False):
                    self.between(left, right, JOINED)
            case ast.UnaryOp(op=ast.Not() | ast.USub() | ast.Invert()):
                start, end = self.span(node.operand)
                self.replace(node, f"({self.text[start:end]})")
            case ast.Constant(value=bool()):
                self.replace(node, str(not node.value))
            case ast.Constant(value=int() | float()):
                start, end = self.span(node)
                self.replace(node, *numbers(self.text[start:end]))
            case ast.AugAssign():
                self.between(
                    node.target, node.value, {f"{k}=": tuple(f"{v}=" for v in n) for k, n in COMPUTED.items()}
                )
            case ast.If() | ast.IfExp():
                self.negate(node.test)
            case ast.Call(func=ast.Name(id=name) | ast.Attribute(attr=name)) if name in SWAPPED:
                end = self.span(node.func)[1]
                self.found.append((end - len(name), end, SWAPPED[name]))
            case _:
                pass
        for child in self.parts(node):
            self.visit(child)

    def parts(self, node: ast.AST) -> Iterator[ast.AST]:
        """Yield what is in a node, without annotations and docstrings."""
        for field, value in ast.iter_fields(node):
            if field in {"annotation", "returns", "type_params", "type_comment", "decorator_list"}:
                continue
            for child in value if isinstance(value, list) else [value]:
                is_text = isinstance(child, ast.Expr) and _is_text(child.value)
                if isinstance(child, ast.AST) and not is_text:
                    yield child


def _is_text(node: ast.AST) -> bool:
    return isinstance(node, ast.JoinedStr) or (isinstance(node, ast.Constant) and isinstance(node.value, str | bytes))


def in_python(text: str) -> list[Change]:
    """Return all that may be changed in a Python file, in order."""
    return sorted(set(_Python(text).found))


def differs(text: str, change: Change) -> bool:
    """Return whether a Python file is still one, and another, after a change."""
    start, end, new = change
    try:
        return ast.dump(ast.parse(text[:start] + new + text[end:])) != ast.dump(ast.parse(text))
    except SyntaxError:
        return False


_CPP = re.compile(
    r"(?P<skip>//[^\n]*|/\*.*?\*/|^[ \t]*\#(?:[^\n\\]|\\.|\\\n)*|\s+)"
    r'|(?P<text>"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\')'
    r"|(?P<number>(?:0[xX][\dA-Fa-f']+|(?:\d[\d']*\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)[uUlLfFzZ]*)|(?P<name>[A-Za-z_]\w*)"
    r"|(?P<sign>::|->|\+\+|--|<<=|>>=|<=|>=|==|!=|&&|\|\||<<|>>|[-+*/%&|^]=|.)",
    re.MULTILINE | re.DOTALL,
)
_ASSIGNED = {"=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="}
_EDGES = {"(", ")", "[", "]", "{", "}", ",", ";", "?", ":", "return", *_ASSIGNED}
_FIXED = {"constexpr", "throw", "static_assert", "template", "using", "typedef", "case", "enum"}


def cpp_tokens(text: str) -> list[tuple[int, str, str]]:
    """Return the code of a C++ file: where each token is, its kind and its text."""
    return [
        (match.start(), match.lastgroup or "", match[0])
        for match in _CPP.finditer(text)
        if match.lastgroup != "skip"
    ]  # fmt: skip


def in_cpp(text: str) -> list[Change]:
    """Return all that may be changed in a C++ header: expressions, or statements to their semicolon."""
    tokens = cpp_tokens(text)
    words = [word for _, _, word in tokens]
    found: set[Change] = set()
    for i, (at, kind, word) in enumerate(tokens):
        if kind == "text" or _FIXED & set(words[_statement(words, i) : i]):
            continue
        spaced = text[at - 1].isspace() and text[at + len(word) : at + len(word) + 1].isspace()
        news: tuple[str, ...] = ()
        end = at + len(word)
        if kind == "number":
            digits = word.rstrip("uUlLfFzZ")
            news = tuple(number + word[len(digits) :] for number in numbers(digits.replace("'", "")))
        elif kind == "name" and word in SWAPPED and words[i - 2 : i] == ["std", "::"]:
            news = (SWAPPED[word],)
        elif word in {"true", "false"}:
            news = ("false" if word == "true" else "true",)
        elif word == "!" and not spaced:
            news = ("",)
        elif spaced:
            news = COMPARED.get(word) or COMPUTED.get(word) or JOINED.get(word) or ()
        if (spaced and word in _ASSIGNED - {"="}) or word == "throw":
            found |= set(_changed_statement(text, tokens, i))
            continue
        if not news:
            continue
        if unit := _around(text, tokens, i):
            start, stop = unit
            found |= {(start, stop, text[start:at] + new + text[end:stop]) for new in news}
    return sorted(found)


def _statement(words: list[str], i: int) -> int:
    """Return where the statement around a token begins."""
    while i > 0 and words[i - 1] not in {";", "{", "}"}:
        i -= 1
    return i


def _changed_statement(text: str, tokens: list[tuple[int, str, str]], i: int) -> Iterator[Change]:
    """Yield an assignment of another kind, or a check that is gone, as a whole statement."""
    words = [word for _, _, word in tokens]
    first = _statement(words, i)
    last = i
    while last < len(words) and words[last] not in {";", "{", "}"}:
        last += 1
    # The part of for (...; x += 1) is no statement.
    inside = words[first:last]
    if words[last : last + 1] != [";"] or inside.count("(") != inside.count(")"):
        return
    start, end = tokens[first][0], tokens[last][0] + 1
    at, _, word = tokens[i]
    if word == "throw":
        if first == i:
            yield start, end, ";"
        return
    for new in COMPUTED.get(word[:-1], ()):
        yield start, end, f"{text[start:at]}{new}={text[at + len(word) : end]}"


def _around(text: str, tokens: list[tuple[int, str, str]], i: int) -> tuple[int, int] | None:
    """Return the smallest expression around a token that ends at brackets, commas and assignments, or None."""
    pairs = {")": "(", "]": "[", "}": "{"}
    first, open_ = i, 0
    while first > 0:
        word = tokens[first - 1][2]
        if word in pairs:
            if word == "}":
                return None
            open_ += 1
        elif word in pairs.values() and open_:
            open_ -= 1
        elif word in _EDGES and not open_:
            break
        first -= 1
    last, open_ = i, 0
    while last + 1 < len(tokens):
        word = tokens[last + 1][2]
        if word in pairs.values():
            if word == "{":
                return None
            open_ += 1
        elif word in pairs and open_:
            open_ -= 1
        elif word in _EDGES and not open_:
            break
        last += 1
    start, end = tokens[first][0], tokens[last][0] + len(tokens[last][2])
    # What is no expression.
    heads = {"operator", "class", "typename", "if", "for", "while", "else", "do", "new", "delete"}
    return (
        None
        if heads & {word for _, _, word in tokens[first : last + 1]} or "\n#" in text[start:end]
        else (start, end)
    )


def draw(texts: dict[str, str], seed: int) -> Iterator[tuple[str, Change]]:
    """Yield a change of each line that has any, the lines in the order of chance."""
    by_line: dict[tuple[str, int], list[Change]] = {}
    for file, text in sorted(texts.items()):
        for change in in_python(text) if file.endswith(".py") else in_cpp(text):
            by_line.setdefault((file, text.count("\n", 0, change[0])), []).append(change)
    chance, places = random.Random(seed), sorted(by_line)
    for file, line in chance.sample(places, len(places)):
        change = chance.choice(by_line[file, line])
        if not file.endswith(".py") or differs(texts[file], change):
            yield file, change
