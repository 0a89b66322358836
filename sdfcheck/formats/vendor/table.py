"""Reading a vendor's table, of which sdfcheck.formats.vendor.definitions holds the result."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.formats.vendor import known_tables, prefix_of
from sdfcheck.formats.vendor.definitions import (
    DIALECTS,
    BadTable,
    Effect,
    Elsewhere,
    Keys,
    Outcome,
    Place,
    Slot,
    Tag,
    Vendor,
)
from sdfcheck.source.text import pattern

if TYPE_CHECKING:
    from sdfcheck.source.document import Document

TYPES = frozenset(
    ("", "bool", "double", "file", "flag", "int", "name", "string", "truth", "vector2", "vector3", "word")
)

_OWN = pattern(r"(?<![\w:]):(?=[A-Za-z_])")
"""The colon of a name that has the vendor's own prefix left out."""


@cache
def vendor(path: Path, dialect: str) -> Vendor:
    """A vendor's table, as ``dialect`` (``sdf`` or ``urdf``) has it.

    Raises:
        BadTable: it cannot be read; the text names the line at fault.
    """
    prefix = prefix_of(path)
    reader = _Reader(prefix, dialect)
    try:
        lines = path.read_text("utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise BadTable(f"{path.name}: {error}") from None
    for number, line in enumerate(lines, 1):
        if not line.strip() or line.startswith("#"):
            continue
        try:
            reader.take(_OWN.sub(f"{prefix}:", line.rstrip()))
        except (BadTable, ValueError, IndexError, KeyError) as error:
            reason = error if isinstance(error, BadTable) else "not understood"
            raise BadTable(f"{path.name}:{number}: {reason}") from None
    if reader.vendor is None:
        raise BadTable(f"{path.name}: no line `vendor`")
    for tag in reader.vendor.tags.values():
        for key in ("at-most", "differs"):
            name = ":".join(tag.keys.text(key).split(":")[:2])
            if name and name not in reader.vendor.tags:
                raise BadTable(f"{path.name}: {tag.name} refers to {name}, which is not there")
    return reader.vendor


def check_tables(tables: Iterable[Path]) -> None:
    """Make sure that tables can be read; raises BadTable."""
    for table in tables:
        for dialect in DIALECTS:
            vendor(table, dialect)


def vendors(library: object | None, dialect: str) -> list[Vendor]:
    """The tables that the documents of a library are read with."""
    return [vendor(table, dialect) for table in known_tables(library).values()]


def tag_of(document: Document, name: str, dialect: str) -> Tag | None:
    """The entry of a prefixed name in the tables around a document; None if none of them has it."""
    table = known_tables(document.library).get(name.partition(":")[0])
    return None if table is None else vendor(table, dialect).tags.get(name)


class _Reader:
    """Takes line by line; those of the other dialect leave no trace."""

    def __init__(self, prefix: str, dialect: str) -> None:
        self.prefix = prefix
        self.dialect = dialect
        self.vendor: Vendor | None = None
        self.tag: Tag | None = None
        self.type, self.default = "", ""
        self.fields: list[tuple[str, str]] = []

    def take(self, line: str) -> None:
        fields = line.strip(" ").split("\t")
        head = fields[0]
        if line[0] == " ":
            self.below(head, fields)
        elif head == "vendor":
            name, namespace = (*fields[1:3], "")[:2]
            self.vendor = Vendor(self.prefix, name, namespace, Keys(_keys(fields[3:]), self.dialect))
        elif self.vendor is None:
            raise BadTable("the line `vendor` comes first, its fields separated by tabs")
        elif head in {"reads", "unknown"} and len(fields) > 2 and fields[1] in DIALECTS:
            self.convention(head, *fields[1:])
        else:
            self.start(head, fields)

    def convention(self, head: str, dialect: str, word: str, paths: str = "") -> None:
        """How the consumer takes numbers, and what it does about what it does not know."""
        assert self.vendor is not None
        if dialect != self.dialect:
            return
        if head == "reads":
            if word not in {"lenient", "strict"}:
                raise BadTable(f"`{word}` is neither lenient nor strict")
            self.vendor.is_lenient = word == "lenient"
        elif paths:
            self.vendor.ignored_in = tuple(paths.split(","))
        else:
            self.vendor.unknown = _known(word)

    def start(self, head: str, fields: list[str]) -> None:
        assert self.vendor is not None
        self.type, self.default = (*fields[1:3], "", "")[:2]
        _check_type(self.type)
        self.fields = _keys(fields[3:])
        name = f"{self.prefix}:{head}"
        if name in self.vendor.tags:
            raise BadTable(f"{name} is there already")
        self.tag = self.vendor.tags[name] = Tag(name, Keys(self.fields, self.dialect))

    def below(self, head: str, fields: list[str]) -> None:
        """A place (``sdf``, ``urdf``), an attribute (``@name``) or a plain child (``/name``)."""
        if self.tag is None:
            raise BadTable("a line below no tag")
        if head[0] in "@/":
            kind, required, default, *rest = (*fields[1:], "", "", "")
            _check_type(kind)
            keys = Keys(_keys(list(filter(None, rest))), self.dialect)
            if keys.text("in") in {"", self.dialect}:
                slots = self.tag.attributes if head[0] == "@" else self.tag.parts
                slots[head[1:]] = Slot(head, (kind, required, default), keys)
            return
        if head not in DIALECTS:
            raise BadTable(f"`{head}` is neither sdf, urdf, an attribute (@) nor a plain child (/)")
        if head == self.dialect:
            self.place(fields)

    def place(self, fields: list[str]) -> None:
        assert self.tag is not None
        parent, carrier, multiplicity = (*fields[1:4], "", "", "")[:3]
        own = _keys(fields[4:])
        keys = Keys([*own, *self.fields], self.dialect)
        if parent == "-":
            effect = Keys(own, self.dialect).effect("wrong") or Effect(Outcome.IGNORED)
            self.tag.absent = Elsewhere(effect, keys.text("use"), keys.words("within"))
            return
        slot = None
        if carrier:
            name = "" if carrier in {"text", "attribute"} else carrier
            slot = Slot(name, (self.type, "1", self.default), keys)
        self.tag.places.append(Place(parent, carrier, multiplicity, Keys(own, self.dialect), slot))


def _keys(fields: list[str]) -> list[tuple[str, str]]:
    found = []
    for field in filter(None, fields):
        key, sign, value = field.partition("=")
        if not sign:
            raise BadTable(f"`{field}` is not key=value")
        found.append((key, value))
    return found


def _known(word: str) -> Effect:
    effect = Effect.of(word)
    if effect.outcome is Outcome.READ:
        raise BadTable(f"`{word}` is not one of {', '.join(outcome.value for outcome in Outcome)}")
    return effect


def _check_type(word: str) -> None:
    if word not in TYPES:
        raise BadTable(f"`{word}` is not a type: {', '.join(sorted(filter(None, TYPES)))}")
