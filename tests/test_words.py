"""The words of the project, in everything that a person reads: plain ones, and lines that fit a page."""

from __future__ import annotations

import ast
import inspect
import re
import tokenize
from collections.abc import Iterator
from pathlib import Path

import pytest

from sdfcheck.cli.convert.command import COMMANDS as CONVERSIONS
from sdfcheck.cli.main import COMMANDS, main
from sdfcheck.convert.loss import LossKind
from tests.test_rules import RULES
from tests.test_style import CODE

ROOT = Path(__file__).parents[1]
PAGES = [
    *(ROOT / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md")),
    *sorted((ROOT / "docs").rglob("*.md")),
]
LONGEST = 120
INSTEAD = {
    r"readers?": "consumer, or its name",
    r"told|tells? of": "report",
    r"mend(?:s|ed|ing)?|remed(?:y|ies)|cures?": "fix",
    r"parted by": "separated by",
    r"(?:is|was|comes?|stands?) behind": "after",
    r"stands? (?:for|in|at|beside|without)": "be, mean, appear in",
    r"pass(?:es|ed)? over": "ignore",
    r"say for|at hand|besides|all the same": "leave it out, or: also, available, in addition, still",
    r"(?<!if there )(?<!where there )(?:is|are) (?-i:none)": "is not one",
    r"(?<!there )is no(?! longer\b| less\b| more\b| larger\b)": "is not a",
    r"labelled|licence|metres?|modelling|(?:normal|recogn|organ|initial)ised": "US spelling",
    r"neighbours?|colours?|centres?|behaviours?": "US spelling",
    r"astray|slips?|folk|teller|barren|shelves": "a plain word",
    r"blame[sd]?|culprits?|whoever|lest|be it|let go|happens? to be": "a plain word",
    r"as (?:it stands|they stand)|(?:is|are|was|were) met": "as it is, occurs",
}
"""A word to avoid → its replacement."""
WORDS = re.compile(rf"(?<![\w-])(?:{'|'.join(INSTEAD)})(?![\w-])", re.IGNORECASE)
SUBJECT = re.compile(r"(?:\A|(?<=[.:] )|(?<=\n\n)|(?<=\n- )|(?<=\| ))(?:What|Who|Whoever) [a-z](?![^.]*\?)")
"""A sentence that begins with a clause: name the thing instead."""
NAMES = re.compile(
    r"(?:^|_)(?:tells?|told|blamed?|slips?|cure|mend(?:s|ed)?|mentions|folk|astray|whoever|colours?)(?:_|$)",
    re.IGNORECASE,
)
"""Words that are not in the names of things, either."""
CLAUSE = re.compile(r"_*(?:test_)?(?:what|who)_[a-z]")
"""A name that is such a sentence."""
GENERATED = {"conditions.py", "rule_index.py"}
_FENCE = re.compile(r"^( *)```.*?^\1```$", re.MULTILINE | re.DOTALL)
_CODE = re.compile(r"``[^`]+``|`[^`\n]*`")


def without_code(markdown: str) -> str:
    """A page without its blocks of code; the lines stay where they are."""
    return _FENCE.sub(lambda match: "\n" * match[0].count("\n"), markdown)


def prose(markdown: str) -> str:
    return _CODE.sub("`…`", without_code(markdown))


def complaints(text: str, where: str) -> Iterator[str]:
    for match in (*WORDS.finditer(text), *SUBJECT.finditer(text)):
        line = text.count("\n", 0, match.start()) + 1
        around = " ".join(text[max(0, match.start() - 40) : match.end() + 30].split())
        yield f"{where}:{line}: {match[0]!r} in …{around}…"


def test_pages_use_plain_words() -> None:
    found = [
        complaint
        for page in PAGES
        for complaint in complaints(prose(page.read_text(encoding="utf-8")), page.name)
    ]
    assert not found, "\n".join(found)


def test_lines_of_pages_fit() -> None:
    """Tables and code cannot be folded."""
    long = [
        f"{page.name}:{number}"
        for page in PAGES
        for number, line in enumerate(without_code(page.read_text(encoding="utf-8")).splitlines(), 1)
        if len(line) > LONGEST and not line.lstrip().startswith("|")
    ]
    assert long == [], "run `make format`"


@pytest.mark.parametrize("name", [*(name for name in COMMANDS if name != "convert"), *CONVERSIONS, ""])
def test_help_uses_plain_words(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    line = ["convert", name] if name in CONVERSIONS else [name] if name else []
    main([*line, "--help"])
    text = " ".join(capsys.readouterr().out.split())
    assert [*complaints(text, name)] == []


def test_manuals_use_plain_words() -> None:
    found = [
        complaint
        for rule in RULES
        for text in (rule.__doc__ or "", _FENCE.sub("", inspect.cleandoc(getattr(rule, "remedy", ""))))
        for complaint in complaints(_CODE.sub("`…`", " ".join(text.split())), rule.__name__)
    ]
    assert not found, "\n".join(found)


def test_losses_use_plain_words() -> None:
    found = [one for kind in LossKind for one in complaints(kind.facts.summary, kind.facts.code)]
    assert not found, "\n".join(found)


Place = tuple[int, str]
"""A line, and a text on it."""


def sentences(nodes: list[ast.AST]) -> Iterator[Place]:
    """The texts of a module that have several words, but for its docstrings: messages and titles."""
    notes = {id(node.value) for node in nodes if isinstance(node, ast.Expr)}
    for node in nodes:
        if not isinstance(node, ast.Constant) or not isinstance(node.value, str) or id(node) in notes:
            continue
        if " " in node.value.strip() and "<" not in node.value:
            yield node.lineno, node.value


def notes(path: Path, nodes: list[ast.AST]) -> Iterator[Place]:
    """The comments and docstrings of a module, each as one line a paragraph."""
    with tokenize.open(path) as file:
        for token in tokenize.generate_tokens(file.readline):
            if token.type == tokenize.COMMENT:
                yield token.start[0], token.string.lstrip("#: ")
    for node in nodes:
        match node:
            case ast.Expr(value=ast.Constant(value=str() as text)):
                yield node.lineno, "\n\n".join(" ".join(part.split()) for part in text.split("\n\n"))


def names(nodes: list[ast.AST]) -> Iterator[Place]:
    """The names that a module defines: of functions, classes, arguments and variables."""
    for node in nodes:
        match node:
            case ast.FunctionDef(name=name) | ast.AsyncFunctionDef(name=name) | ast.ClassDef(name=name):
                yield node.lineno, name
            case ast.arg(arg=name) | ast.Name(id=name, ctx=ast.Store()):
                yield node.lineno, name
            case ast.Attribute(attr=name, ctx=ast.Store()):
                yield node.lineno, name


def nodes_of(path: Path) -> list[ast.AST]:
    return list(ast.walk(ast.parse(path.read_text(encoding="utf-8"))))


@pytest.mark.parametrize("folder", [*CODE, "action.py"])
def test_code_uses_plain_words(folder: str) -> None:
    """In comments, docstrings and names; in texts, too, where people read them."""
    found: list[str] = []
    for path in modules(ROOT / folder):
        nodes, where = nodes_of(path), path.relative_to(ROOT)
        texts = [*notes(path, nodes)]
        if folder in {"rules", "sdfcheck", "action.py"}:
            texts += [place for place in sentences(nodes) if not SUBJECT.match(place[1])]
        for number, text in texts:
            found += complaints(_CODE.sub("`…`", text), f"{where}:{number}")
        odd = (place for place in names(nodes) if NAMES.search(place[1]) or CLAUSE.match(place[1]))
        found += [f"{where}:{number}: {name}" for number, name in odd]
    assert not found, "\n".join(found)


def modules(top: Path) -> list[Path]:
    found = [top] if top.is_file() else sorted(top.rglob("*.py"))
    assert found
    return [path for path in found if path.name not in GENERATED]


def test_comments_docstrings_and_names_are_read(tmp_path: Path) -> None:
    module = tmp_path / "module.py"
    module.write_text('def told(one):\n    """First.\n\n    Then,\n    more."""\n    one.slips = 1  # why\n')
    nodes = nodes_of(module)
    assert [*notes(module, nodes)] == [(6, "why"), (2, "First.\n\nThen, more.")]
    assert sorted(names(nodes)) == [(1, "one"), (1, "told"), (6, "slips")]
    assert NAMES.search("_tell_all")
    assert not NAMES.search("slipped")
    assert CLAUSE.match("test_what_is_left")
    assert not CLAUSE.match("test_whatever")


def test_the_words_are_found() -> None:
    assert [*complaints("so it is told\nto whom it is no use", "x")] == [
        "x:1: 'told' in …so it is told to whom it is no use…",
        "x:2: 'is no' in …so it is told to whom it is no use…",
    ]
    assert [*complaints("It ends. What is left is kept. What now?", "x")] == [
        "x:1: 'What i' in …It ends. What is left is kept. What now?…"
    ]
    assert [*complaints("there is no link; a wheel-slip plugin; it is no longer read", "x")] == []
