"""URDF inside of what xacro has yet to expand: bodies of macros that nothing calls, and libraries
of them.

The content that xacro inserts is unknown, so an element with something of xacro's inside lacks
nothing and has nothing twice, and a value with an expression is taken as it is.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from typing import cast

from sdfcheck.formats.near_names import suggest
from sdfcheck.formats.problems import MissingAttribute
from sdfcheck.formats.schema import Definition
from sdfcheck.formats.urdf.schema import VERSIONS, control, known_parents, urdf
from sdfcheck.formats.urdf.survey import UrdfWalk
from sdfcheck.source.document import Document, Element
from sdfcheck.xacro.language import PREFIX
from sdfcheck.xacro.origins import ExpandedDocument
from sdfcheck.xacro.static.definitions import (
    Definitions,
    Reading,
    is_free,
    lacks_prefix,
    reading,
    visible_definitions,
)
from sdfcheck.xacro.static.likely_mistakes import is_plain_call, with_includers

_PREFIX = "xacro:"
_BLOCK = "xacro:insert_block"
TRANSPARENT = frozenset({"xacro:if", "xacro:unless"})
_PLACES = ("", "link", "joint", "link/inertial", "link/visual", "link/visual/geometry", "joint/limit")
"""Where macros are called: what their bodies hold may be at one of these paths below ``robot``."""
_SHARE = 3
"""A body with fewer known names than so many for each foreign one is not URDF."""

_OF_BUILD = re.compile(r"\s*@\w+@\s*")


class Bodies:
    """Some elements of a xacro document that no expansion shows: what is wrong, and what is in them."""

    __slots__ = ("elements", "problems")

    def __init__(self, document: Document, bodies: Iterable[Element]) -> None:
        walk = _BodyWalk(document, VERSIONS[0])
        for body in bodies:
            place = _place(body)
            if place is not None:
                walk.content(body, place)
        self.problems = [each for each in walk.conclude() if not _may_be_given(each)]
        elements = (element for elements in walk.index.values() for element in elements)
        self.elements = [element for element in elements if not _gets_attributes(element)]


class _BodyWalk(UrdfWalk):
    """The walk over a document, for elements that are not all there yet."""

    def children(self, parent: Element, place: Definition) -> None:
        if not is_unfinished(parent):
            super().children(parent, place)
            return
        self.content(parent, place)
        for name in place.required_children:
            if not parent.has(name) and not may_get(parent, name, place):
                self.findings.missing(parent, place, name)

    def content(self, parent: Element, place: Definition) -> None:
        """Check each child for itself: what else will be there is not known."""
        if not place.open and _has_text(parent):
            self.findings.stray_text(parent)
        for child in content(parent):
            definition = place.children.get(child.name)
            if definition is not None:
                self.element(child, parent, definition)
            elif not place.open and not is_plain_call(child, visible_definitions(child.document)):
                self.findings.unexpected(child, parent, place)


def _may_be_given(problem: object) -> bool:
    """Is an attribute missing that xacro may write?"""
    return isinstance(problem, MissingAttribute) and _gets_attributes(problem.element)


def _gets_attributes(element: Element) -> bool:
    """Will xacro write attributes of an element, which are in no tag yet?"""
    return any(
        child.name == "xacro:attribute" or (child.name in TRANSPARENT and _gets_attributes(child))
        for child in element.children()
    )


def _has_text(element: Element) -> bool:
    """Is there text beside the children of an element, and not what a build puts something in the place of?"""
    texts = (element.text, *(child.tail for child in element.nodes))
    return any(text and not (text.isspace() or _OF_BUILD.fullmatch(text)) for text in texts)


def is_unfinished(element: Element) -> bool:
    """Will xacro put something into an element?"""
    return any(map(_is_of_xacro, element.children()))


def may_get(parent: Element, name: str, place: Definition | None) -> bool:
    """May xacro put a child of that name into an element? A block is called after what it is."""
    put_in = [child for child in parent.children() if _is_of_xacro(child)]
    blocks = {child.attributes.get("name", "") for child in put_in if child.name == _BLOCK}
    is_known = place is not None and len(blocks) == len(put_in) and blocks <= place.children.keys()
    return name in blocks if is_known else bool(put_in)


def _is_of_xacro(element: Element) -> bool:
    return element.name.startswith(_PREFIX) or lacks_prefix(element)


def content(parent: Element) -> Iterator[Element]:
    """The elements that an element holds once xacro has decided, without those that it puts in."""
    for child in parent.children():
        if child.name in TRANSPARENT:
            yield from content(child)
        elif not _is_of_xacro(child):
            yield child


def _place(body: Element) -> Definition | None:
    """Where a body belongs: at the first of the places that know most of it; None where none does."""
    robot = urdf()
    if body.name == "robot":  # or what is included in a ros2_control of one
        return robot if _surplus(body, robot) >= _surplus(body, control()) else None
    if body.name in TRANSPARENT and (path := _path(body)) is not None:
        return robot.at(path)
    best, place = 0, None
    for path in _PLACES:
        candidate = cast("Definition", robot.at(path))
        known, foreign = _fit(body, candidate)
        if known >= _SHARE * foreign and known - foreign > best:
            best, place = known - foreign, candidate
    return None if place is None or _is_of_others(body) else place


def _path(branch: Element) -> str | None:
    """Where the content of a branch goes, below the root; None in a macro, or where xacro makes the place."""
    names: list[str] = []
    above = branch.parent
    while above is not None and above.name != "robot":
        if above.name not in TRANSPARENT:
            names.append(above.name)
        above = above.parent
    if above is None or any(name.startswith(_PREFIX) for name in names):
        return None
    return "/".join(reversed(names))


def _is_of_others(body: Element) -> bool:
    """Whether a macro is called only where other formats are written, as in ``<gazebo>``.

    That is in its file and those that it includes, and in those that include it.
    """
    if body.name != "xacro:macro":
        return False
    name = body.attributes.get("name", "").removeprefix(_PREFIX)
    if not all(map(is_free, body.document.view(_calls_before).get(name, ()))):
        return False
    calls = body.document.view(_calls).get(name, ())
    return bool(calls) and all(map(is_free, calls))


def _calls_before(document: Document) -> dict[str, list[Element]]:
    """Macro → the calls of it, in a file and those that it includes."""
    return _by_macro(visible_definitions(document).readings)


def _calls(document: Document) -> dict[str, list[Element]]:
    """The same with those in files that include it."""
    return _by_macro(with_includers(document, visible_definitions(document)))


def _by_macro(readings: Iterable[Reading]) -> dict[str, list[Element]]:
    calls: dict[str, list[Element]] = {}
    for read in readings:
        for call in read.calls:
            calls.setdefault(call.name.rpartition(".")[2], []).append(call.element)
    return calls


def _surplus(body: Element, place: Definition) -> int:
    """How many more names in an element are known at a place than foreign."""
    known, foreign = _fit(body, place)
    return known - foreign


def _fit(parent: Element, place: Definition) -> tuple[int, int]:
    """How many of the names inside an element are known at a place, and how many are foreign to URDF."""
    known = foreign = 0
    for child in content(parent):
        definition = place.children.get(child.name)
        has_text = (child.text or "").strip() and not child.attributes
        if definition is None or (has_text and definition.attributes):
            foreign += ":" not in child.name and not _is_misspelled(child.name, place)
            continue
        given = [name for name in child.attributes if ":" not in name]
        right = sum(name in definition.attributes for name in given)
        wrong = sum(suggest(name, definition.attributes) is None for name in given)
        inner = (0, 0) if definition.open else _fit(child, definition)
        known += 1 + right + inner[0]
        foreign += wrong + inner[1]
    return known, foreign


def _is_misspelled(name: str, place: Definition) -> bool:
    """Whether an element is URDF's, but misspelled or in another place than its own."""
    return bool(known_parents(name)) or suggest(name, place.children) is not None


# The parts of a xacro file that no expansion shows.

_BRANCHES = frozenset({"xacro:if", "xacro:unless"})


def unexpanded(document: Document, expansions: Sequence[ExpandedDocument]) -> Iterator[Element]:
    """The macros of a document that nothing calls, and the branches that no expansion takes.

    Without an expansion all macros, and the root.
    """
    if document.root is None:
        return
    if not expansions:
        yield document.root
    called = _called(visible_definitions(document)) if expansions else frozenset()
    uncalled = [macro.element for macro in reading(document).macros if macro.name not in called]
    yield from uncalled
    if expansions:
        yield from _not_taken(document, expansions, {*uncalled})


def _not_taken(
    document: Document, expansions: Sequence[ExpandedDocument], done: set[Element]
) -> Iterator[Element]:
    """The branches of which nothing is in an expansion, outside of the elements that are ``done``."""
    branches = [element for element, _ in reading(document).elements if element.name in _BRANCHES]
    if not branches:
        return
    shown = set().union(*(expansion.provenance.offsets_in(document.path) for expansion in expansions))
    for branch in branches:
        if done.isdisjoint(branch.around):
            starts = {content.span.start - 1 for content in _content(branch)}
            if starts and shown.isdisjoint(starts):
                done.add(branch)
                yield branch


def _content(branch: Element) -> Iterator[Element]:
    """The elements that a branch puts into the robot itself."""
    for child in branch.children():
        if not child.name.startswith(PREFIX):
            yield child
        if child.name not in {"xacro:macro", "xacro:property"}:
            yield from _content(child)


def _called(visible: Definitions) -> frozenset[str]:
    """The names of the macros that are called from outside of macros, or from one that is called."""
    waiting = [
        call.name
        for read in visible.readings
        for call in read.calls
        if all(each.name != "xacro:macro" for each in call.element.around)
    ]
    called: set[str] = set()
    while waiting:
        name = waiting.pop().rpartition(".")[2]
        if name not in called:
            called.add(name)
            waiting += [inner for macro in visible.macros.get(name, ()) for inner in macro.calls]
    return frozenset(called)
