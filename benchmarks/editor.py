"""Asks the language server about many files, as a person at the keyboard would.

``python -m benchmarks.editor FOLDER… [--files 60] [--renames 200] [--seed 1]`` takes descriptions from the folders
and asks for the definition, the references and the renaming at every character of a name; for completion where a
name, value, attribute, tag or call was removed; and renames, lints and expands. It prints the shares.
"""

from __future__ import annotations

import argparse
import builtins
import keyword
import math
import random
import re
import sys
import time
from collections import Counter, defaultdict
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

from lsprotocol import types

from sdfcheck.lsp.answers import Answers
from sdfcheck.lsp.completion import complete
from sdfcheck.lsp.findings import Findings
from sdfcheck.lsp.names import roots_of
from sdfcheck.lsp.rename import Refused
from sdfcheck.lsp.speech import ProtocolTypes, Units, path_of
from sdfcheck.lsp.workspace import Buffer, Workspace
from sdfcheck.robot.root import root_of
from sdfcheck.source.errors import DescriptionError
from sdfcheck.source.sniff import HEAD, Kind, sniff

SHARES = {Kind.XACRO: 24, Kind.URDF: 14, Kind.SDF: 14, Kind.SRDF: 8}
"""Of 60 files so many are of each kind."""
LARGEST = 120_000
MOST_GAPS = 12
"""So many things of a sort are removed from a file."""
FIRST = 5
"""So many suggestions are seen without scrolling."""

_TAG = re.compile(
    r"<!--.*?-->|<(?P<name>[A-Za-z_][\w:.-]*)(?P<inside>(?:[^<>\"']|\"[^\"]*\"|'[^']*')*?)(?P<empty>/?)>",
    re.DOTALL,
)
_ATTRIBUTE = re.compile(r"([\w:.-]+)\s*=\s*(?:\"([^\"]*)\"|'([^']*)')")
_ARGUMENT = re.compile(r"\$\(arg\s+(\w+)\)")
_EXPRESSION = re.compile(r"(?<!\$)\$\{([^{}<>]*)\}")
_WORD = re.compile(r"'[^']*'|\"[^\"]*\"|(?<![\w.])([^\W\d]\w*)(?!\w*\s*=[^=])")
_CALL = re.compile(r"<xacro:(\w+)")
_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)

REFERENCES = {
    Kind.URDF: {"parent@link", "child@link", "mimic@joint", "gazebo@reference"},
    Kind.SDF: {"pose@relative_to", "frame@attached_to", "parent", "child"},
    Kind.SRDF: {
        "link@name",
        "joint@name",
        "chain@base_link",
        "chain@tip_link",
        "disable_collisions@link1",
        "disable_collisions@link2",
        "end_effector@parent_link",
        "end_effector@group",
        "group_state@group",
        "passive_joint@name",
        "virtual_joint@child_link",
    },
}
DEFINITIONS = {
    Kind.URDF: {"link@name", "joint@name"},
    Kind.SDF: {"model@name", "link@name", "joint@name", "frame@name"},
    Kind.SRDF: {"group@name"},
}
REFERENCES[Kind.XACRO] = REFERENCES[Kind.URDF] | {"xacro:insert_block@name"}
DEFINITIONS[Kind.XACRO] = DEFINITIONS[Kind.URDF] | {
    "xacro:macro@name",
    "xacro:property@name",
    "xacro:arg@name",
}
_PYTHON = {*dir(builtins), *dir(math), *keyword.kwlist, "xacro", "load_yaml", "degrees", "radians"}
"""Words that mean something of their own in expressions."""
_XACRO = {
    "arg",
    "attribute",
    "call",
    "element",
    "if",
    "include",
    "insert_block",
    "macro",
    "property",
    "unless",
}
CHOICES = {
    "joint@type",
    "sensor@type",
    "virtual_joint@type",
    "disable_collisions@reason",
    "light@type",
    "command_interface@name",
    "state_interface@name",
    "hardwareInterface",
    "static",
    "gravity",
    "visualize",
    "always_on",
    "self_collide",
    "cast_shadows",
    "child_link_can_move",
    "turnGravityOff",
    "selfCollide",
}


class Name(NamedTuple):
    """A name in a text: its place, and the tag and attribute that hold it."""

    what: str
    start: int
    end: int
    tag: int


def names(text: str, wanted: set[str]) -> Iterator[Name]:
    """The values of tags and attributes in a text, found without the project's own parser."""
    for tag in _TAG.finditer(text):
        if tag["name"] is None:
            continue
        for found in _ATTRIBUTE.finditer(tag["inside"]):
            group = 2 if found[2] is not None else 3
            if f"{tag['name']}@{found[1]}" in wanted and found[group].strip():
                at = tag.start("inside")
                yield Name(
                    f"{tag['name']}@{found[1]}", at + found.start(group), at + found.end(group), tag.start()
                )
        if tag["name"] in wanted and not tag["empty"]:
            end = text.find("<", tag.end())
            raw = text[tag.end() : end]
            if raw.strip() and text.startswith(f"</{tag['name']}", end):
                start = tag.end() + len(raw) - len(raw.lstrip())
                yield Name(tag["name"], start, start + len(raw.strip()), tag.start())


def xacro_words(text: str) -> Iterator[Name]:
    """The words of expressions, the arguments that are asked for, and the macros that are called, in a xacro text."""
    text = _COMMENT.sub(lambda found: " " * len(found[0]), text)
    for expression in _EXPRESSION.finditer(text):
        for word in _WORD.finditer(expression[1]):
            if word[1] and word[1] not in _PYTHON:
                start = expression.start(1) + word.start(1)
                yield Name("word", start, start + len(word[1]), expression.start())
    for found in _ARGUMENT.finditer(text):
        yield Name("argument", found.start(1), found.end(1), found.start())
    for found in _CALL.finditer(text):
        if found[1] not in _XACRO:
            yield Name("call", found.start(1), found.end(1), found.start())


def every_name(text: str, kind: Kind) -> Iterator[Name]:
    """Every name in a text."""
    yield from names(text, REFERENCES[kind] | DEFINITIONS[kind])
    if kind is Kind.XACRO:
        yield from xacro_words(text)


class Editor:
    """One person, who has one file open at a time."""

    def __init__(self) -> None:
        self.workspace = Workspace()
        self.findings = Findings(self.workspace)
        self.speech = ProtocolTypes(self.workspace)
        self.speech.units = Units.UTF32
        self.answers = Answers(self.workspace, self.findings, self.speech)

    def open(self, path: Path, text: str) -> Buffer:
        return self.workspace.open(path.as_uri(), path, text, 1)

    def place(self, buffer: Buffer, offset: int) -> dict[str, Any]:
        position = self.speech.position(buffer.source, offset)
        return {"text_document": types.TextDocumentIdentifier(buffer.uri), "position": position}


def chosen(folders: list[Path], count: int, seed: int) -> list[tuple[Path, Kind, str]]:
    """Descriptions of all kinds from some folders; the same for the same seed."""
    by_kind: dict[Kind, list[tuple[Path, Kind, str]]] = defaultdict(list)
    for folder in folders:
        for path in sorted(folder.rglob("*")):
            if path.suffix not in {".urdf", ".sdf", ".world", ".xacro", ".srdf"} or not path.is_file():
                continue
            data = path.read_bytes()
            kind = sniff(data[:HEAD], path)
            if kind in SHARES and 300 < len(data) < LARGEST:
                by_kind[kind].append((path, kind, data.decode("utf-8", "replace").replace("\r\n", "\n")))
    picked = []
    for kind, share in SHARES.items():
        random.Random(seed).shuffle(by_kind[kind])
        picked += by_kind[kind][: max(1, share * count // 60)]
    return picked


class Tally:
    """How often something was asked, and how often it was answered."""

    def __init__(self) -> None:
        self.asked: Counter[str] = Counter()
        self.right: Counter[str] = Counter()
        self.missed: list[str] = []

    def add(self, what: str, is_right: bool, words: str = "") -> None:
        self.asked[what] += 1
        self.right[what] += is_right
        if not is_right and words:
            self.missed.append(f"{what}: {words}")

    def show(self) -> None:
        for what in sorted(self.asked):
            share = 100 * self.right[what] / self.asked[what]
            print(f"  {what:32} {self.right[what]:6} of {self.asked[what]:6}  {share:5.1f} %")


def every_character(editor: Editor, buffer: Buffer, kind: Kind, tally: Tally) -> None:
    """Definition, references and renaming at each character of each name."""
    for name in every_name(buffer.source.text, kind):
        value = buffer.source.text[name.start : name.end]
        before, is_listed = object(), False
        for offset in range(name.start, name.end):
            place = editor.place(buffer, offset)
            where = f"{buffer.path}:{place['position'].line + 1} {value!r} + {offset - name.start}"
            found = editor.answers.definition(buffer, types.DefinitionParams(**place))
            tally.add(f"definition, {kind.value}", found is not None, where)
            named = editor.answers.named(buffer, place["position"])
            if named is not before:  # references take a while, and are those of the name
                context = types.ReferenceContext(True)
                is_listed = bool(editor.answers.references(buffer, types.ReferenceParams(context, **place)))
                before = named
            tally.add(f"references, {kind.value}", is_listed, where)
            ready = editor.answers.prepared(buffer, types.PrepareRenameParams(**place))
            tally.add(f"rename, {kind.value}", ready is not None, where)


class Gap(NamedTuple):
    """A text with something removed: what, where the cursor is, and what a person would pick."""

    what: str
    text: str
    offset: int
    wanted: str


def gaps(text: str, kind: Kind) -> Iterator[Gap]:
    """The parts that can be removed from a text and asked for."""
    for name in names(text, REFERENCES[kind] | CHOICES):
        value = text[name.start : name.end]
        what = "value" if name.what in CHOICES else "name"
        if "$" not in value:
            yield Gap(what, text[: name.start] + text[name.end :], name.start, value)
    for found in _ARGUMENT.finditer(text) if kind is Kind.XACRO else ():
        yield Gap("argument", text[: found.start(1)] + text[found.end(1) :], found.start(1), found[1])
    for tag in _TAG.finditer(text):
        if tag["name"] is None or text.count("<", 0, tag.start()) < 2:
            continue
        is_call = tag["name"].startswith("xacro:")
        close = tag.end()
        if not tag["empty"]:
            close = text.find(f"</{tag['name']}>", tag.end())
            if f"<{tag['name']}" in text[tag.end() : close] or close < 0:
                continue
            close += len(tag["name"]) + 3
        typed = "<xacro:" if is_call else "<"
        what = "tag" if not is_call else "xacro tag"
        yield Gap(what, text[: tag.start()] + typed + text[close:], tag.start() + len(typed), tag["name"])
        for found in _ATTRIBUTE.finditer(tag["inside"]):
            start, end = tag.start("inside") + found.start(), tag.start("inside") + found.end()
            if not found[1].startswith("xmlns"):
                what = "parameter" if is_call else "attribute"
                yield Gap(what, text[:start] + " " + text[end:], start, found[1])


def completions(
    editor: Editor, path: Path, kind: Kind, text: str, chance: random.Random, tally: Tally
) -> None:
    """Completion where something was removed."""
    by_sort: dict[str, list[Gap]] = defaultdict(list)
    for gap in gaps(text, kind):
        by_sort[gap.what].append(gap)
    for what, found in sorted(by_sort.items()):
        for gap in chance.sample(found, min(MOST_GAPS, len(found))):
            buffer = editor.open(path, gap.text)
            items = complete(editor.workspace, buffer, gap.offset).items
            shown = [item.label for item in items]
            line = gap.text.count("\n", 0, gap.offset) + 1
            words = f"{path}:{line} {gap.wanted!r} not in {shown[:FIRST]} ({gap.wanted in shown})"
            tally.add(f"{what}, {kind.value}", gap.wanted in shown[:FIRST], words)
            tally.add(f"{what}, {kind.value}, anywhere", gap.wanted in shown)


def robots(editor: Editor, paths: set[Path]) -> dict[str, Any]:
    """The results of files: findings by code, and the poses of links, for each file that is or makes a robot."""
    found: dict[str, Any] = {}
    for path in sorted(paths):
        buffer = editor.workspace.buffers.get(editor.workspace.key(path))
        if buffer is None:
            buffer = editor.open(path, path.read_text(errors="replace").replace("\r\n", "\n"))
        editor.findings.lint(buffer)
        codes = Counter(each.code for each in editor.findings.at(path))
        found[str(path)] = codes, _poses(editor, buffer)
    return found


def _poses(editor: Editor, buffer: Buffer) -> list[Any]:
    """The poses of all links as the text makes them, in order; of xacro after its expansion."""
    document = editor.workspace.document(buffer.path)
    if document is None or document.root is None:
        return ["nothing"]
    if document.kind is Kind.XACRO:
        settings = editor.workspace.settings_for(buffer.path)
        expander = editor.workspace.caches.xacro(settings, buffer.path).expander
        document = None if expander is None else expander.expand(document).document
        if document is None:
            return ["not expanded"]
    return [_pose(link) for link in root_of(document).each("Link")]


def _pose(link: Any) -> Any:
    try:
        pose = link.pose("world")
    except DescriptionError as error:
        return type(error).__name__
    return tuple(round(float(each), 9) for each in (*pose.xyz, *pose.rpy))


def rename_once(
    editor: Editor, around: set[Path], buffer: Buffer, offset: int, chance: random.Random, tally: Tally
) -> None:
    """Rename what is at a place, apply that, and compare what the files come to."""
    place = editor.place(buffer, offset)
    ready = editor.answers.prepared(buffer, types.PrepareRenameParams(**place))
    if ready is None or isinstance(ready, Refused):
        tally.add("rename is refused at once", ready is not None, str(ready))
        return
    new = f"{re.sub(r'[^A-Za-z0-9_]', '', ready.placeholder) or 'part'}_{chance.choice('xyz')}"
    where = f"{buffer.path}:{place['position'].line + 1} {ready.placeholder!r} to {new!r}"
    edit = editor.answers.rename(buffer, types.RenameParams(new_name=new, **place))
    if isinstance(edit, Refused):
        tally.add("rename is done", False, f"{where}: {edit}")
        return
    tally.add("rename is done", True)
    touched = {path_of(uri) for uri in edit.changes or {}}
    before = robots(editor, around | touched)
    texts = {each: each_buffer.source.text for each, each_buffer in editor.workspace.buffers.items()}
    for uri, edits in (edit.changes or {}).items():
        path = path_of(uri)
        source = editor.workspace.buffers[editor.workspace.key(path)].source
        text = source.text
        for one in sorted(edits, key=lambda one: (one.range.start.line, one.range.start.character))[::-1]:
            span = editor.speech.span(source, one.range)
            text = text[: span.start] + one.new_text + text[span.end :]
        editor.open(path, text)
    after = robots(editor, around | touched)
    for name in before:
        new_findings = after[name][0] - before[name][0]
        tally.add("rename: no new finding", not new_findings, f"{where}: {name}: {dict(new_findings)}")
        tally.add("rename: same poses", before[name][1] == after[name][1], f"{where}: {name}")
    for key, text in texts.items():
        editor.open(Path(key), text)


def renames(editor_of: Callable[[], Editor], files: list[Any], count: int, seed: int, tally: Tally) -> None:
    """Rename at random places of all files."""
    chance = random.Random(seed)
    while tally.asked["rename is done"] < count:
        path, kind, text = chance.choice(files)
        places = list(every_name(text, kind))
        if not places:
            continue
        editor = editor_of()
        buffer = editor.open(path, text)
        around = {path}
        if kind is Kind.XACRO:
            around |= {root.path for root in roots_of(editor.answers.document(buffer))}
        for name in chance.sample(places, min(3, len(places))):
            rename_once(editor, around, buffer, chance.randrange(name.start, name.end), chance, tally)
            buffer = editor.workspace.buffers[editor.workspace.key(path)]
        editor.workspace.close()


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--files", type=int, default=60)
    parser.add_argument("--renames", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", choices=("names", "completion", "renames"), action="append")
    parser.add_argument("--missed", type=int, default=0, help="show so many questions that were not answered")
    given = parser.parse_args()
    files = chosen([folder.resolve() for folder in given.folders], given.files, given.seed)
    print(f"{len(files)} files: {dict(Counter(kind.value for _, kind, _ in files))}")
    wanted = given.only or ["names", "completion", "renames"]
    for part in wanted:
        tally, started = Tally(), time.perf_counter()
        chance = random.Random(given.seed)
        if part == "renames":
            renames(Editor, files, given.renames, given.seed, tally)
        for path, kind, text in files if part != "renames" else ():
            editor = Editor()
            if part == "names":
                every_character(editor, editor.open(path, text), kind, tally)
            else:
                completions(editor, path, kind, text, chance, tally)
            editor.workspace.close()
        print(f"{part}: {time.perf_counter() - started:.0f} s")
        tally.show()
        for words in chance.sample(tally.missed, min(given.missed, len(tally.missed))):
            print("   ", words)
    return 0


if __name__ == "__main__":
    sys.exit(main())
