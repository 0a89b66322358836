"""The one walk over an SDF document: every element against the table of its version.

Of a URDF document it walks over what is SDFormat: the content of the ``<gazebo>`` blocks.

The walk also notes where the standard elements are, so that a user of "all joints" need not walk
again. A sound document is walked by the fast path alone, which asks ``Definition.accepts``;
whatever that does not accept at once is explained by :mod:`sdfcheck.formats.sdf.findings`, which a
sound document never loads.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from typing import TYPE_CHECKING

from sdfcheck.formats.sdf.schema import Definition, schema
from sdfcheck.formats.sdf.table import stems
from sdfcheck.formats.sdf.version import NEWEST, Version
from sdfcheck.source.document import Aside, Document, Element
from sdfcheck.source.sniff import Kind

if TYPE_CHECKING:
    from sdfcheck.formats.sdf.findings import Findings
    from sdfcheck.formats.topology import Displaced

PARAMETERS = "experimental:params"
"""The element of an include with its parameters."""

_ADDING = frozenset(("add", "replace"))
_REMEMBERED = 1000
"""So many accepted texts are kept for each place: most worlds repeat themselves."""


class Survey:
    """The results of the walk.

    ``index`` lists the standard elements by name, in document order: those that are where the table
    places them, so nothing inside plugins or custom elements. ``named`` lists, per parent, its
    children that have a ``name``.
    """

    __slots__ = (
        "customs",
        "displaced",
        "document",
        "index",
        "misspelled",
        "named",
        "problems",
        "replaced",
        "version",
    )

    def __init__(self, document: Document) -> None:
        root = document.root
        is_sdf = root is not None and root.name == "sdf"
        self.document = document
        self.version = (Version.parse(document.version or "") if is_sdf else None) or NEWEST
        """The declared version; the newest one where none or an unknown one is declared."""
        walk = _Walk(document, self.version)
        self.problems = walk.run(root) if root is not None and is_sdf else walk.extensions()
        self.index = walk.index
        self.named = walk.named
        """Parent → (element name, value of its ``name``, element)."""
        self.customs: list[Element] = []
        """Custom elements in standard ones, and in what parameters of includes add."""
        self.displaced: dict[Element, tuple[Displaced, ...]] = {}
        """Custom elements → the standard ones in them that could be beside them."""
        self.replaced: dict[Element, list[str]] = {}
        """Custom elements → the required ones that are absent where they are given."""
        if walk.explained is not None:
            self._take_customs(walk.explained)
        self.misspelled = walk.explained.misspelled if walk.explained else set()
        """Parts that elements lack only because a child or attribute of theirs is misspelled."""

    def _take_customs(self, found: Findings) -> None:
        self.customs += (custom for custom, _, _ in found.customs)
        self.displaced.update(found.displaced)
        self.replaced.update(found.replaced)
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
    return schema(NEWEST).at(f"{name}:{name}") if name in stems() else None


def survey(document: Document) -> Survey:
    """The survey of a document, made once."""
    return document.view(Survey)


def problems(document: Document) -> list[object]:
    """The problems that the walk found."""
    return survey(document).problems


def examine(element: Element, definition: Definition) -> list[object]:
    """The problems of an element where the walk does not go, compared with ``definition``."""
    return _Walk(element.document, definition.version).part(element, definition)


class _Walk:
    def __init__(self, document: Document, version: Version) -> None:
        self.document = document
        self.version = version
        self.index: defaultdict[str, list[Element]] = defaultdict(list)
        self.named: defaultdict[Element, list[tuple[str, str, Element]]] = defaultdict(list)
        self.explained: Findings | None = None

    @property
    def findings(self) -> Findings:
        """The explaining side, loaded when there is something to explain."""
        if self.explained is None:
            from sdfcheck.formats.sdf.findings import Findings

            self.explained = Findings(self.document, self.version, self.named)
        return self.explained

    def run(self, root: Element) -> list[object]:
        definition = schema(self.version).root
        version = definition.attributes["version"]
        self.index[root.name].append(root)
        if root.attributes.keys() != {"version"} or not version.accepts(root.attributes["version"]):
            self.findings.root(root, definition)
        self.children(root, definition)
        return self.explained.conclude() if self.explained else []

    def extensions(self) -> list[object]:
        """The same for what a URDF file holds in ``<gazebo>`` blocks."""
        if self.document.kind is Kind.URDF and "<gazebo" in self.document.source.text:
            from sdfcheck.formats.sdf.extension import extensions

            for block, content in extensions(self.document):
                self.children(block, content)
        return self.explained.conclude() if self.explained else []

    def part(self, element: Element, definition: Definition) -> list[object]:
        parent = element.parent
        assert parent is not None
        self.attributes(element, parent, definition)
        if definition.type is not None:
            self.findings.value(element, parent, definition)
        elif not definition.open:
            self.children(element, definition)
        return self.explained.conclude() if self.explained else []

    def children(self, parent: Element, place: Definition) -> None:  # noqa: C901, PLR0912 - the hot loop
        """Check the children of one container, and theirs."""
        allowed = place.children
        index = self.index
        seen: dict[str, Element] = {}
        if (text := parent.text) and not text.isspace():
            self.findings.stray_text(parent)
        for child in parent.nodes:
            tag = child.name
            if (text := child.tail) and not text.isspace():
                self.findings.stray_text(parent)
            if isinstance(child, Aside):
                continue
            definition = allowed.get(tag)
            if definition is None:
                definition = self.findings.unexpected(child, parent, place)
                if definition is None:
                    continue
            index[tag].append(child)
            attributes = child.attributes
            if attributes or definition.required_attributes:
                self.attributes(child, parent, definition)
            if tag not in seen:
                seen[tag] = child
            elif definition.single:
                self.findings.repeated(child, seen[tag], parent)
            if definition.type is not None:
                if attributes or child.text not in definition.sound or child.nodes:
                    self.leaf(child, parent, definition)
            elif not definition.open:
                self.children(child, definition)
            if definition.deprecated:
                self.findings.deprecated(child, definition)
        for name in place.needed_children:
            if name not in seen:
                self.findings.missing(parent, place, name)

    def leaf(self, element: Element, parent: Element, definition: Definition) -> None:
        """Check a value that was not met before."""
        text = element.text
        is_odd = element.nodes or "rotation_format" in element.attributes
        if not text and definition.type == "pose" and not is_odd:
            return  # <pose relative_to="…"/>: no displacement
        if is_odd or not definition.accepts(text):
            self.findings.value(element, parent, definition)
        elif len(definition.sound) < _REMEMBERED:
            definition.sound.add(text)

    def attributes(self, element: Element, parent: Element, definition: Definition) -> None:
        allowed, given = definition.attributes, element.attributes
        for key, text in given.items():
            if key == "name":
                self.named[parent].append((element.name, text, element))
            attribute = allowed.get(key)
            if attribute is None and ":" in key:
                continue  # prefixed: free
            if attribute is None or not attribute.accepts(text):
                self.findings.attribute(element, parent, definition, key, text)
        for name in definition.required_attributes:
            if name not in given:
                self.findings.missing_attribute(element, definition, name)
