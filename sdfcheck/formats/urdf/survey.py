"""The one walk over a URDF document: every element against the table.

As in SDFormat's survey, the walk notes where the standard elements are, asks the
table's quick checks, and leaves to :mod:`sdfcheck.formats.urdf.findings` whatever they
do not accept at once.
"""

from __future__ import annotations

import re
from collections import defaultdict
from typing import TYPE_CHECKING

from sdfcheck.formats.sdf.version import Version
from sdfcheck.formats.urdf.table import VERSIONS, UrdfElement, urdf
from sdfcheck.source.document import Aside, Document, Element
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import is_expression

if TYPE_CHECKING:
    from sdfcheck.formats.topology import Displaced
    from sdfcheck.formats.urdf.findings import UrdfFindings

_REMEMBERED = 1000
"""So many accepted texts are kept for each attribute: most robots repeat themselves."""

_WRAPPED_VALUE = re.compile(r"=\s*(?:\"[^\"<]*[\t\n\r]|'[^'<]*[\t\n\r])")


class UrdfSurvey:
    """The results of the walk.

    ``index`` lists the elements by name, in document order: those that are where the
    table places them, so nothing inside ``<gazebo>`` or ``<transmission>``. A document
    that xacro has yet to expand is not looked into.
    """

    __slots__ = ("customs", "displaced", "document", "index", "problems", "root", "version")

    def __init__(self, document: Document) -> None:
        self.document = document
        root = document.root
        is_robot = root is not None and root.name == "robot"
        self.root = root if is_robot and not _is_unexpanded(document) else None
        """The element ``robot``; None where there is none to check."""
        self.version = VERSIONS[0]
        """The declared version of URDF; the first where none or an unknown one is declared."""
        self.index: defaultdict[str, list[Element]] = defaultdict(list)
        self.customs: list[Element] = []
        """Prefixed elements in standard ones."""
        self.displaced: dict[Element, tuple[Displaced, ...]] = {}
        """Prefixed elements → the standard ones in them that could be beside them."""
        self.problems: list[object] = []
        if self.root is not None:
            declared = document.version or ""
            self.version = next((v for v in VERSIONS if str(v) == declared), VERSIONS[0])
            walk = UrdfWalk(document, self.version)
            self.problems = walk.run(self.root)
            self.index = walk.index
            if walk.explained:
                self.customs, self.displaced = walk.explained.customs, walk.explained.displaced

    def top(self, name: str) -> list[Element]:
        """The children of ``robot`` of that name."""
        return [element for element in self.index.get(name, ()) if element.parent is self.root]


def survey(document: Document) -> UrdfSurvey:
    """The survey of a document, made once."""
    return document.view(UrdfSurvey)


def problems(document: Document) -> list[object]:
    """Problems that a URDF document has because of its shape."""
    return survey(document).problems


class UrdfWalk:
    """One walk; what it meets that is not accepted at once goes to its findings."""

    def __init__(self, document: Document, version: Version) -> None:
        self.source = document.source
        self.version = version
        self.index: defaultdict[str, list[Element]] = defaultdict(list)
        self.explained: UrdfFindings | None = None
        # A tab or line break in a value matters, and the parser has turned it into a space.
        self.is_wrapped = _WRAPPED_VALUE.search(document.source.text) is not None

    @property
    def findings(self) -> UrdfFindings:
        """The explaining side, loaded when there is something to explain."""
        if self.explained is None:
            from sdfcheck.formats.urdf.findings import UrdfFindings

            self.explained = UrdfFindings(self.source, self.version)
        return self.explained

    def run(self, root: Element) -> list[object]:
        definition = urdf()
        self.index["robot"].append(root)
        self.attributes(root, definition)
        self.children(root, definition)
        if is_expression(self.source.text):
            self.findings.expressions(root)
        return self.conclude()

    def conclude(self) -> list[object]:
        """All problems, once every element is walked over."""
        for dynamics in self.index.get("dynamics", ()):
            if not {"damping", "friction"}.intersection(dynamics.attributes):
                self.findings.dynamics(dynamics)
        if "<gazebo" in self.source.text:
            self.extensions()
        return self.explained.conclude() if self.explained else []

    def children(self, parent: Element, place: UrdfElement) -> None:  # noqa: C901 - the hot loop
        """Check the children of one container, and theirs."""
        allowed = place.children
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
                self.findings.unexpected(child, parent, place)
                continue
            if tag not in seen:
                seen[tag] = child
            elif definition.single:
                self.findings.repeated(child, seen[tag], parent, place)
                continue
            self.element(child, definition)
        for name in place.required_children:
            if name not in seen:
                self.findings.missing_child(parent, name)
        if parent.name == "geometry" and not (len(seen) == len(parent.nodes) == 1):
            self.findings.shape(parent, place, seen)

    def element(self, element: Element, definition: UrdfElement) -> None:
        """Check an element that is where it may, and all that is in it."""
        self.index[element.name].append(element)
        self.attributes(element, definition)
        if definition.since > self.version:
            self.findings.too_new(element, definition.since)
        if not definition.open and (definition.children or element.nodes or element.text):
            self.children(element, definition)

    def attributes(self, element: Element, definition: UrdfElement) -> None:
        allowed = definition.attributes
        required = 0
        for key, text in element.attributes.items():
            attribute = allowed.get(key)
            if attribute is not None and attribute.required:
                required += 1
            if attribute is None or attribute.since > self.version:
                self.findings.attribute(element, definition, key, text)
                continue
            if text not in attribute.sound:
                if not attribute.accepts(text):
                    self.findings.attribute(element, definition, key, text)
                    continue
                if len(attribute.sound) < _REMEMBERED:
                    attribute.sound.add(text)
            if self.is_wrapped and attribute.is_number:
                self.findings.attribute_value(element, attribute, text)
        if required < len(definition.required_attributes):
            missing = tuple(name for name in definition.required_attributes if name not in element.attributes)
            self.findings.missing_attributes(element, missing)

    def extensions(self) -> None:
        """The values of the settings in ``<gazebo>``."""
        from sdfcheck.formats.urdf.table import extension

        settings = extension().children
        for block in self.index.get("gazebo", ()):
            for child in block.children():
                definition = settings.get(child.name)
                if definition is not None and definition.value is not None:
                    text = child.attributes.get("value") or child.content
                    if not definition.value.accepts(text):
                        self.findings.setting(child, definition.value)


def _is_unexpanded(document: Document) -> bool:
    """Are there elements that xacro is to replace? In what is read as URDF they are elements that nobody knows."""
    if document.kind is not Kind.XACRO or document.root is None or "<xacro:" not in document.source.text:
        return False
    return any(element.name.startswith("xacro:") for element in document.elements[1:])
