"""Names that things are given: those that siblings share, and those that reach nothing.

In a model, links, joints, frames and nested models share one name space, in a world
models, joints and frames do; the ``gz sdf`` check refuses any two named siblings,
plugins excepted. Source: libsdformat 17, checked against what it reports.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from sdfcheck.formats.sdf.survey import Survey, notes, survey
from sdfcheck.robot.graph import UNCONVERTED
from sdfcheck.robot.naming.name import Name, Namesakes
from sdfcheck.robot.values import lazy
from sdfcheck.source.document import Element, Value
from sdfcheck.source.text import pattern

if TYPE_CHECKING:
    from collections.abc import Iterable

    from sdfcheck.robot.part import Whole


# Names in the ``<gazebo>`` blocks of a URDF robot: they are siblings of those in what the block is about.


_MERGED = frozenset({"plugin", "visual", "collision"})
"""In a block these share names freely: a shape there is what is added to those of the link."""


def extension_names(root: Whole) -> dict[Element, list[Name]]:
    """Element → the names that the blocks add to it; an element in a block, or what the block is about."""
    found: dict[Element, list[Name]] = {}
    for parent, children in notes(root.document).named.items():
        at, free = parent, frozenset({"plugin"})
        if parent.name == "gazebo":
            at, free = _subject(root, parent), _MERGED
        found.setdefault(at, []).extend(
            Name(kind, text.strip(), Value(element, "name", text), at, is_extension=True)
            for kind, text, element in children
            if text.strip() and kind not in free and ":" not in kind
        )
    return found


def extended_namesakes(root: Whole, given: Iterable[Name]) -> list[Namesakes]:
    """The names in blocks that siblings have already; ``given`` are those of the robot's links and joints."""
    found: list[Namesakes] = []
    for parent, names in extension_names(root).items():
        taken: dict[str, Name] = {}
        if parent is root.element:
            for name in given:
                if name.makes_frame and not _is_dropped(name):
                    taken.setdefault(name.name, name)
        for name in names:
            first = taken.setdefault(name.name, name)
            if first is not name:
                found.append(Namesakes(first, name))
    return found


def _of_shapes(root: Whole) -> Iterator[Name]:
    """The names with ``::`` of visuals and collisions of URDF, which libsdformat gives on."""
    for kind in ("visual", "collision"):
        for shape in root.elements.get(kind, ()):
            own, parent = shape.attribute("name"), shape.parent
            if own is not None and "::" in own.text and parent is not None and parent.name == "link":
                yield Name(kind, own.text, own, parent)


def _is_dropped(name: Name) -> bool:
    """Is it of a joint that libsdformat has no place for? Then the name is free."""
    return name.kind == "joint" and name.value.element.get("type") in UNCONVERTED


def _subject(root: Whole, block: Element) -> Element:
    """The link, joint or robot that a block is about."""
    from sdfcheck.robot.graph import GazeboBlock

    part = root.part_of(block)
    subject = part.subject if isinstance(part, GazeboBlock) else None
    return block if subject is None else subject.element


# Names with ``::`` in worlds up to version 1.7, which libsdformat turns back into nested models.
#
# ``A::x`` in a model becomes ``x`` in a nested model ``A``, and every reference in it
# loses its ``A::``. A reference that has none to lose fails an assertion that ends the
# program. Source: ``unflatten`` in libsdformat 17's Converter.cc and what it does when run.


_MOVED = frozenset({"frame", "joint", "link", "model", "gripper"})
_AXES = ("axis", "axis2")


def foreign_references(surveyed: Survey) -> dict[Element, Value | Element]:
    """The elements whose names cannot be unfolded, with what is in the way."""
    found: dict[Element, Value | Element] = {}
    for model in surveyed.index.get("model", ()):
        if _is_in_world(model):
            found.update(_in_model(model))
    return found


def _is_in_world(element: Element) -> bool:
    return next((each.name for each in element.around if each.name != "model"), "") == "world"


def _in_model(model: Element) -> Iterator[tuple[Element, Value | Element]]:
    for child in model.children():
        name = child.attributes.get("name", "")
        if child.name in _MOVED and "::" in name:
            prefix = name.partition("::")[0]
            obstacle = next(_obstacles(child, prefix), None)
            if obstacle is not None:
                yield child, obstacle


def _obstacles(element: Element, prefix: str) -> Iterator[Value | Element]:
    """The names that do not begin with the prefix, in the order in which they occur."""
    for reference in _references(element):
        if isinstance(reference, Element) or not reference.text.strip().startswith(prefix):
            yield reference


def _references(element: Element) -> Iterator[Value | Element]:
    """The references that are unfolded with an element, and axes that lack the direction they could be on."""
    if element.name == "frame":
        yield from _attribute(element, "attached_to")
    elif element.name == "link":
        for part in element.children():
            yield from _poses(part)
    elif element.name == "joint":
        for role in ("parent", "child"):
            if (end := element.find(role)) is not None and end.content:
                yield end.own_value
        for axis in (child for child in element.children() if child.name in _AXES):
            xyz = axis.find("xyz")
            yield from (axis,) if xyz is None else _attribute(xyz, "expressed_in")
        for sensor in element.children("sensor"):
            yield from _poses(sensor)


def _poses(element: Element) -> Iterator[Value]:
    """The node that the poses of a part of a link, and of its camera, are relative to."""
    for holder in (element, element.find("camera")):
        pose = holder.find("pose") if holder is not None else None
        if pose is not None:
            yield from _attribute(pose, "frame")
            yield from _attribute(pose, "relative_to")


def _attribute(element: Element, name: str) -> Iterator[Value]:
    value = element.attribute(name)
    if value is not None and value.text.strip():
        yield value


# Among names, one a line: what may be reserved, has spaces at its ends, or a colon in it.
_ODD_LINE = pattern(r"^__|^world$|^\s|[ \t\r]$|:", re.MULTILINE)
_ODD_MARKS = ("__", "world", ":", " ", "\t", "\r", "\n\n")
"""Where none of these occurs in ASCII names, they need no closer look."""

# One of these is all that a document may hold, which is reported with its structure.
_SINGLE_AT_ROOT = frozenset({"model", "light", "actor"})


class Names:
    """The names that a file gives."""

    def __init__(self, root: Whole) -> None:
        self.root = root

    @lazy
    def special(self) -> tuple[Name, ...]:
        """The names that are more than plain words: ``world``, with underscores in front, with colons."""
        given = [name for names in self._siblings.values() for name in names]
        if self.root.is_urdf and (own := self.root.element.attribute("name")) is not None:
            given.append(Name("model", own.text, own, self.root.element))
        if self.root.is_urdf and self.root.elements.get("gazebo"):
            given += [name for names in extension_names(self.root).values() for name in names]
        if self.root.is_urdf and self.root.document.source.contains("::"):
            given += _of_shapes(self.root)
        return tuple(name for name in given if _ODD_LINE.search(name.name))

    @lazy
    def padded(self) -> tuple[Name, ...]:
        """The names with spaces around them in SDFormat, which are not part of them; without repeated ones."""
        if self.root.is_urdf:
            return ()
        given = (name for names in self._siblings.values() for name in names)
        padded = [name for name in given if name.value.attribute and name.value.text != name.name]
        return tuple(name for name in padded if all(name is not later for _, later in self.shared))

    @lazy
    def shared(self) -> tuple[Namesakes, ...]:
        """The siblings that share a name, each with the first of that name. Plugins may."""
        repeated = _repeated_in_urdf if self.root.is_urdf else _repeated
        found = [pair for names in self._siblings.values() for pair in repeated(names)]
        document = self.root.document
        if self.root.is_urdf and self.root.elements.get("gazebo"):
            found += extended_namesakes(self.root, _given_in_urdf(self.root))
        if document.library is not None and not self.root.is_urdf and "merge" in document.source.text:
            from sdfcheck.robot.includes.included import merged_namesakes

            found += merged_namesakes(document)
        return tuple(found)

    @lazy
    def obstacles(self) -> dict[Element, Value | Element]:
        """The causes, by their elements, that keep names with ``::`` in older worlds from being
        turned into nested models.

        It makes libsdformat crash: a reference that stays outside, or an axis without direction.
        """
        if self.root.is_urdf or not self.root.is_older_than("1.8"):
            return {}

        return foreign_references(survey(self.root.document))

    @lazy
    def references(self) -> tuple[Value, ...]:
        """All places in SDFormat that refer to something by its name."""
        if self.root.is_urdf:
            return ()
        from sdfcheck.robot.naming.references import written

        return tuple(value for _, value in written(self.root))

    @lazy
    def _siblings(self) -> dict[Element, list[Name]]:
        """The names in each element where anything may be wrong with one."""
        if self.root.is_urdf:
            return {self.root.element: list(_of_urdf(self.root))}
        named = self.root.named
        included = list(_included(self.root))
        doubtful = {*_doubtful(self.root), *(name.parent for name in included)}
        found = {
            parent: [
                Name(kind, text.strip(), Value(element, "name", text), parent)
                for kind, text, element in children
                if text.strip() and kind != "plugin"
            ]
            for parent, children in named.items()
            if parent in doubtful
        }
        for name in included:
            found.setdefault(name.parent, []).append(name)
        return found


def _doubtful(root: Whole) -> Iterator[Element]:
    """The cheap question whose children may have names that something is wrong with."""
    named = root.named
    lines = (name for children in named.values() for kind, name, _ in children if kind != "plugin")
    text = "\n".join(("", *lines))
    if (not text.isascii() or any(mark in text for mark in _ODD_MARKS)) and _ODD_LINE.search(text, 1):
        yield from named
        return
    for parent, children in named.items():
        if len(children) > 1 and len({name for _, name, _ in children}) < len(children):
            yield parent


def _included(root: Whole) -> Iterator[Name]:
    """The names that includes bring into their scopes, as far as they are known."""
    for include in root.elements.get("include", ()):
        from sdfcheck.robot.includes.included import included

        found = included(root.document, include)
        parent = include.parent
        if found.name is None or parent is None:
            continue
        own = include.find("name")
        value = own.own_value if own is not None and own.content else found.uri
        if value is None:
            continue
        if found.merge:
            yield Name("frame", f"_merged__{found.name}__model__", value, parent)
        else:
            yield Name(found.kind or "model", found.name, value, parent)


def _given_in_urdf(root: Whole) -> list[Name]:
    """The names of links, joints and materials of URDF."""
    from sdfcheck.formats.urdf.survey import survey as urdf_survey

    surveyed = urdf_survey(root.document)
    return [
        Name(kind, value.text, value, root.element)
        for kind in ("link", "joint", "material")
        for element in surveyed.top(kind)
        if (value := element.attribute("name")) is not None and value.text.strip()
    ]


def _of_urdf(root: Whole) -> Iterator[Name]:
    """The same, unless they are surely all plain and different."""
    given = _given_in_urdf(root)
    # Links and joints share a name space as soon as libsdformat reads them.
    shared = {(name.kind == "material", name.name) for name in given}
    if len(shared) < len(given) or any(_ODD_LINE.search(name.name) for name in given):
        yield from given


def _repeated(names: list[Name]) -> Iterator[Namesakes]:
    """The names that are taken: by the first of the same kind, or else by the first of all."""
    taken: dict[str, dict[str, Name]] = {}
    for name in names:
        if name.parent.name == "sdf" and name.kind in _SINGLE_AT_ROOT:
            continue
        kinds = taken.setdefault(name.name, {})
        first = kinds.get(name.kind) or next(iter(kinds.values()), name)
        kinds.setdefault(name.kind, name)
        if first is not name:
            yield Namesakes(first, name)


def _repeated_in_urdf(names: list[Name]) -> Iterator[Namesakes]:
    """The same of URDF, links before joints before materials: a joint may also have the name of a link."""
    taken: dict[tuple[str, str], Name] = {}
    for name in names:
        first = taken.setdefault((name.kind, name.name), name)
        if first is not name:
            yield Namesakes(first, name)
        elif name.kind == "joint" and (link := taken.get(("link", name.name))) is not None:
            yield Namesakes(link, name)
