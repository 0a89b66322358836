"""The one walk over an SDF document: every element against the table of its version.

Of a URDF document it walks over what is SDFormat: the content of the ``<gazebo>`` blocks.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from sdfcheck.formats.schema import Definition
from sdfcheck.formats.sdf.schema import SDF, schema
from sdfcheck.formats.version import NEWEST, OLDEST, Version
from sdfcheck.formats.walk import Walk
from sdfcheck.source.document import Document, Element
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind

if TYPE_CHECKING:
    from sdfcheck.formats.sdf.findings import SdfFindings
    from sdfcheck.formats.topology import Displaced
    from sdfcheck.source.text import Span

PARAMETERS = "experimental:params"
"""The element of an include with its parameters."""

_ADDING = frozenset(("add", "replace"))


class Noted(NamedTuple):
    """The notes of the walk about single elements."""

    named: dict[Element, list[tuple[str, str, Element]]]
    """Parent → its children that have a ``name``: element name, value of ``name``, element."""
    displaced: dict[Element, tuple[Displaced, ...]]
    """Custom elements → the standard ones in them that could be beside them."""
    replaced: dict[Element, list[str]]
    """Custom elements → the required ones that are absent where they are given."""
    misspelled: dict[tuple[Element, str], Span]
    """Parts that elements lack only because a child or attribute of theirs is misspelled, with its place."""


class Survey:
    """The results of the walk.

    ``index`` lists the standard elements by name, in document order: those that are where the table
    places them, so nothing inside plugins or custom elements.
    """

    __slots__ = ("customs", "document", "index", "noted", "problems", "version")

    def __init__(self, document: Document) -> None:
        root = document.root
        self.document = document
        self.version = version_of(document)
        walk = _Walk(document, self.version)
        self.problems = walk.run(root) if root is not None and root.name == "sdf" else walk.extensions()
        self.index = walk.index
        self.customs: list[Element] = []
        """Custom elements in standard ones, and in what parameters of includes add."""
        self.noted = Noted(walk.named, {}, {}, walk.explained.misspelled if walk.explained else {})
        if walk.explained is not None:
            self._take_customs(walk.explained)

    def _take_customs(self, found: SdfFindings) -> None:
        self.customs += (custom for custom, _, _ in found.customs)
        self.noted.displaced.update(found.displaced)
        self.noted.replaced.update(found.replaced)
        for custom, _, _ in found.customs:
            for element, definition in _additions(custom) if custom.name == PARAMETERS else ():
                walk = _Walk(self.document, definition.version)
                walk.part(element, definition)
                if walk.explained is not None:
                    self._take_customs(walk.explained)


def _additions(block: Element) -> Iterator[tuple[Element, Definition]]:
    """Elements that parameters of an include add, with its definition."""
    for entry in block.children():
        definition = defined_alone(entry.name)
        if definition is None:
            continue
        if entry.attributes.get("action") in _ADDING:
            yield entry, definition
            continue
        for child in entry.children():
            place = definition.children.get(child.name)
            if place is not None and child.attributes.get("action") in _ADDING:
                yield child, place


def defined_alone(name: str) -> Definition | None:
    """The definition of an element that the format defines by itself, wherever it is used."""
    return schema(NEWEST).at(f"{name}:{name}") if name in SDF.table.stems() else None


def survey(document: Document) -> Survey:
    """The survey of a document, made once."""
    return document.view(Survey)


def notes(document: Document) -> Noted:
    """The survey's notes; where a part of a document is looked at, they are known without it."""
    return document.view(noted_in)


def noted_in(document: Document) -> Noted:
    """The notes of a survey, which :func:`notes` keeps."""
    return survey(document).noted


def version_of(document: Document) -> Version:
    """The declared version; the newest one where none or an unknown one is declared, the oldest for one before it."""
    return document.view(_version)


def _version(document: Document) -> Version:
    is_sdf = document.root is not None and document.root.name == "sdf"
    if is_sdf and document.version in _BEFORE:
        return OLDEST
    return (Version.parse(document.version or "") if is_sdf else None) or NEWEST


_BEFORE = ("1.0", "1.1")
"""Versions that were before those that consumers know."""


def problems(document: Document) -> list[object]:
    """The problems that the walk found."""
    return survey(document).problems


def examine(element: Element, definition: Definition) -> list[object]:
    """The problems of an element where the walk does not go, compared with ``definition``."""
    return _Walk(element.document, definition.version).part(element, definition)


class _Walk(Walk["SdfFindings"]):
    def explain(self) -> SdfFindings:
        from sdfcheck.formats.sdf.findings import SdfFindings

        return SdfFindings(self.document, self.version, self.named)

    def run(self, root: Element) -> list[object]:
        definition = schema(self.version).root
        version = definition.attributes["version"]
        self.index[root.name].append(root)
        if root.attributes.keys() != {"version"} or not version.accepts(root.attributes["version"]):
            self.findings.root(root, definition)
        self.children(root, definition)
        return self.conclude()

    def extensions(self) -> list[object]:
        """The same for what a URDF file holds in ``<gazebo>`` blocks."""
        if self.document.kind is Kind.URDF and "<gazebo" in self.document.source.text:
            from sdfcheck.formats.sdf.extension import extensions

            for block, content in extensions(self.document):
                self.children(block, content)
        return self.conclude()

    def part(self, element: Element, definition: Definition) -> list[object]:
        """The same for one element where the walk does not go."""
        assert element.parent is not None
        self.element(element, element.parent, definition)
        return self.conclude()
