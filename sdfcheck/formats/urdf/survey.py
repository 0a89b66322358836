"""The one walk over a URDF document: every element against the table of its version."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterator
from typing import TYPE_CHECKING

from sdfcheck.formats.problems import EmptyName
from sdfcheck.formats.urdf.schema import VERSIONS, extension, urdf
from sdfcheck.formats.version import Version
from sdfcheck.formats.walk import Walk
from sdfcheck.source.document import Document, Element
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import is_expression

if TYPE_CHECKING:
    from sdfcheck.formats.topology import Displaced
    from sdfcheck.formats.urdf.findings import UrdfFindings

_NAMED = ("link", "joint", "material")
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
                self.customs = [custom for custom, _, _ in walk.explained.customs]
                self.displaced = walk.explained.displaced

    def top(self, name: str) -> list[Element]:
        """The children of ``robot`` of that name."""
        return [element for element in self.index.get(name, ()) if element.parent is self.root]

    @property
    def empty_names(self) -> Iterator[EmptyName]:
        """The names of the robot, its links, joints, materials and shapes that are empty or blank."""
        tops = [self.root, *(element for kind in _NAMED for element in self.top(kind))]
        for element in filter(None, tops):
            name = element.attribute("name")
            if name is not None and not name.text.strip():
                yield EmptyName(name)
        for kind in ("visual", "collision"):
            found = [element.attribute("name") for element in self.index.get(kind, ())]
            if blank := [name for name in found if name is not None and not name.text.strip()]:
                yield EmptyName(blank[0], shapes=len(blank))


def survey(document: Document) -> UrdfSurvey:
    """The survey of a document, made once."""
    return document.view(UrdfSurvey)


def problems(document: Document) -> list[object]:
    """Problems that a URDF document has because of its shape."""
    surveyed = survey(document)
    return [*surveyed.problems, *surveyed.empty_names]


class UrdfWalk(Walk["UrdfFindings"]):
    """The walk over a robot, or over a part of one."""

    def __init__(self, document: Document, version: Version) -> None:
        super().__init__(document, version)
        # A tab or line break in a value matters, and the parser has turned it into a space, as that of xacro does.
        is_read_as_written = document.kind is not Kind.XACRO
        self.is_wrapped = is_read_as_written and _WRAPPED_VALUE.search(document.source.text) is not None

    def explain(self) -> UrdfFindings:
        from sdfcheck.formats.urdf.findings import UrdfFindings

        return UrdfFindings(self.document, self.version)

    def run(self, root: Element) -> list[object]:
        self.element(root, root, urdf(self.version))
        if is_expression(self.document.source.text):
            self.findings.expressions(root)
        return self.conclude()

    def conclude(self) -> list[object]:
        for dynamics in self.index.get("dynamics", ()):
            if not {"damping", "friction"}.intersection(dynamics.attributes):
                self.findings.dynamics(dynamics)
        if "<gazebo" in self.document.source.text:
            self.settings()
        return super().conclude()

    def settings(self) -> None:
        """The values of the settings in ``<gazebo>``."""
        known = extension().children
        for block in self.index.get("gazebo", ()):
            for child in block.children():
                setting = known.get(child.name)
                if setting is not None and not setting.accepts(
                    child.attributes.get("value") or child.content
                ):
                    self.findings.value(child, block, setting)


def _is_unexpanded(document: Document) -> bool:
    """Are there elements that xacro is to replace? In what is read as URDF they are elements that nobody knows."""
    if document.kind is not Kind.XACRO or document.root is None or "<xacro:" not in document.source.text:
        return False
    return any(element.name.startswith("xacro:") for element in document.elements[1:])


# Is a robot whole as it is written, or a part of one, which another file has?


_USES = {
    ("joint", "parent"): ("link", "link"),
    ("joint", "child"): ("link", "link"),
    ("joint", "mimic"): ("joint", "joint"),
    ("transmission", "joint"): ("name", "joint"),
    ("ros2_control", "joint"): ("name", "joint"),
}
"""An element of a robot and one in it: the attribute that names a part, and the kind of that."""


def is_unknown(text: str) -> bool:
    """Is there an expression of xacro in a text?"""
    return "${" in text or "$(" in text


def is_whole(document: Document) -> bool:
    """Does a robot have links, all parts that it names, and no expression?"""
    root = document.root
    has_links = root is not None and root.has("link")
    return has_links and not lacks_parts(document) and not is_unknown(document.source.text)


def lacks_parts(document: Document) -> bool:
    """Whether a robot names links, joints or materials that it does not have, or has links without joints."""
    root = document.root
    if root is None or document.kind is not Kind.URDF:
        return False
    own = {kind: {part.text_of("name") for part in root.children(kind)} for kind in ("link", "joint")}
    for part in root.children():
        for inner in part.children():
            attribute, kind = _USES.get((part.name, inner.name), ("", ""))
            if kind and inner.text_of(attribute) not in own[kind]:
                return True
    if len(own["link"]) > len(own["joint"]) + 1:
        return True
    blocks = (block.text_of("reference") for block in root.children("gazebo"))
    if any(name and name not in own["link"] and name not in own["joint"] for name in blocks):
        return True
    visuals = (visual for link in root.children("link") for visual in link.children("visual"))
    materials = [*root.children("material"), *(each for one in visuals for each in one.children("material"))]
    defined = {each.text_of("name") for each in materials if each.has("color") or each.has("texture")}
    return any((name := each.text_of("name")) and name not in defined for each in materials)
