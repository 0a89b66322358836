"""The walk over a document: every element against the table of its format and version.

The walk also notes where the standard elements are, so that a user of "all joints" need not walk
again. A sound document is walked by the fast path alone, which asks ``Definition.accepts``;
whatever that does not accept at once is explained by :mod:`sdfcheck.formats.findings` and the findings
of the format, which a sound document never loads.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections import defaultdict
from typing import TYPE_CHECKING, Generic, TypeVar

from sdfcheck.formats.schema import Definition
from sdfcheck.formats.version import Version
from sdfcheck.source.document import Aside, Document, Element

if TYPE_CHECKING:
    from sdfcheck.formats.findings import Findings

F = TypeVar("F", bound="Findings")

_REMEMBERED = 1000
"""So many accepted texts are kept for each place: most worlds repeat themselves."""


class Walk(ABC, Generic[F]):
    """One walk; what it meets that is not accepted at once goes to its findings."""

    is_wrapped = False
    """Are there tabs or line breaks in attributes, which matter to the consumers of the format?"""

    def __init__(self, document: Document, version: Version) -> None:
        self.document = document
        self.version = version
        self.index: defaultdict[str, list[Element]] = defaultdict(list)
        """The elements that are where the table places them, by name, in the order of the document."""
        self.named: defaultdict[Element, list[tuple[str, str, Element]]] = defaultdict(list)
        """Parent → (element name, value of its ``name``, element)."""
        self.explained: F | None = None

    @property
    def findings(self) -> F:
        """The explaining side, loaded when there is something to explain."""
        if self.explained is None:
            self.explained = self.explain()
        return self.explained

    @abstractmethod
    def explain(self) -> F:
        """The findings of the format, empty."""

    def conclude(self) -> list[object]:
        """All problems, once every element is walked over."""
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
            if tag not in seen:
                seen[tag] = child
            elif definition.single and self.findings.repeated(child, seen[tag], parent):
                continue
            index[tag].append(child)
            attributes = child.attributes
            if attributes or definition.required_attributes:
                self.attributes(child, parent, definition)
            if definition.type is not None:
                if attributes or child.text not in definition.sound or child.nodes:
                    self.leaf(child, parent, definition)
            elif not definition.open and (child.nodes or child.text or definition.needed_children):
                self.children(child, definition)
            if definition.deprecated:
                self.findings.deprecated(child, definition)
        for name in place.needed_children:
            if name not in seen:
                self.findings.missing(parent, place, name)
        if place.exclusive and len(parent.nodes) > 1:
            self.findings.several(parent, place)

    def element(self, element: Element, parent: Element, definition: Definition) -> None:
        """Check an element that is where it may be, and all that is in it."""
        self.index[element.name].append(element)
        self.attributes(element, parent, definition)
        if definition.type is not None:
            self.leaf(element, parent, definition)
        elif not definition.open:
            self.children(element, definition)

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
        """Check the attributes of an element."""
        allowed, given = definition.attributes, element.attributes
        for key, text in given.items():
            if key == "name":
                self.named[parent].append((element.name, text, element))
            attribute = allowed.get(key)
            if attribute is None and ":" in key:
                continue  # prefixed: free
            if attribute is None or not attribute.accepts(text):
                self.findings.attribute(element, definition, key, text)
        for name in definition.required_attributes:
            if name not in given:
                self.findings.missing_attribute(element, definition, name)
        if self.is_wrapped:
            self.findings.wrapped(element, definition)
