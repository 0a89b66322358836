"""Names: unique in their scope, not reserved, and sound as references.

Scopes and severities as libsdformat 17 has them: in a model, links, joints, frames and
nested models share one name space, in a world models, joints and frames do; the
``gz sdf`` check refuses any two named siblings, plugins excepted.
"""

from __future__ import annotations

from typing import NamedTuple

from sdfcheck.formats.survey import Survey, survey
from sdfcheck.formats.version import Version
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element, Value

FRAME_KINDS = frozenset({"link", "joint", "frame", "model"})
"""Elements whose names make frames, and so share one name space in their scope."""

_SEVEN, _EIGHT = Version(1, 7), Version(1, 8)

RESERVABLE = frozenset(
    "world model link joint frame visual collision light sensor physics projector particle_emitter".split()
)
"""Elements whose names libsdformat checks against the reserved ones."""

_REFERENCE_ATTRIBUTES = {
    "frame": ("attached_to",),
    "pose": ("relative_to",),
    "xyz": ("expressed_in",),
    "model": ("canonical_link", "placement_frame"),
    "mimic": ("joint",),
}
_REFERENCE_ELEMENTS = ("parent", "child", "placement_frame", "gearbox_reference_body")


class DuplicateName(NamedTuple):
    """Two siblings of one kind with one name; ``value`` is the later one's name."""

    value: Value
    first: Value
    parent: Element


class ClashingName(NamedTuple):
    """Siblings of different kinds with one name.

    ``shares_frames``: both make frames. ``renamed``: an old version, for which
    libsdformat renames the later one instead of refusing the file.
    """

    value: Value
    first: Value
    parent: Element
    shares_frames: bool
    renamed: bool


class ReservedName(NamedTuple):
    value: Value


class DelimiterInName(NamedTuple):
    """``::`` in a definition; ``refused`` from version 1.8 on."""

    value: Value
    refused: bool


class MalformedScopedName(NamedTuple):
    """A reference with a part missing before, behind or between ``::``."""

    value: Value


class EmptyName(NamedTuple):
    element: Element


Problem = DuplicateName | ClashingName | ReservedName | DelimiterInName | MalformedScopedName | EmptyName


def problems(document: Document) -> list[Problem]:
    """Everything about names that is wrong in an SDF document, in no particular order."""
    surveyed = survey(document)
    found: list[Problem] = []
    for parent, children in surveyed.named.items():
        _look_at_siblings(surveyed, parent, children, found)
    _look_at_references(surveyed, found)
    return found


def is_reserved(name: str) -> bool:
    """``world``, and ``__any__``: at least four characters between double underscores."""
    return name == "world" or (len(name) >= 4 and name.startswith("__") and name.endswith("__"))


def _look_at_siblings(
    surveyed: Survey, parent: Element, children: list[tuple[str, str, Element]], found: list[Problem]
) -> None:
    taken: dict[str, tuple[str, Element]] = {}
    for kind, text, element in children:
        name = text.strip()
        if not name:
            found.append(EmptyName(element))
            continue
        if kind in RESERVABLE and is_reserved(name):
            found.append(ReservedName(Value(element, "name", text)))
        if kind == "plugin":
            continue
        if "::" in name and ":" not in kind:
            found.append(DelimiterInName(Value(element, "name", text), surveyed.version >= _EIGHT))
        earlier = taken.setdefault(name, (kind, element))
        if earlier[1] is not element:
            found.append(_clash(surveyed, parent, (kind, element), earlier))


def _clash(
    surveyed: Survey, parent: Element, later: tuple[str, Element], earlier: tuple[str, Element]
) -> Problem:
    value, first = (Value(e, "name", e.attributes["name"]) for _, e in (later, earlier))
    if later[0] == earlier[0]:
        return DuplicateName(value, first, parent)
    both = later[0] in FRAME_KINDS and earlier[0] in FRAME_KINDS
    return ClashingName(value, first, parent, both, both and surveyed.version < _SEVEN)


def _look_at_references(surveyed: Survey, found: list[Problem]) -> None:
    index = surveyed.index
    for kind, names in _REFERENCE_ATTRIBUTES.items():
        for element in index.get(kind, ()):
            for name, text in element.items():
                if name in names and "::" in text and "" in text.split("::"):
                    found.append(MalformedScopedName(Value(element, name, text)))
    for kind in _REFERENCE_ELEMENTS:
        for element in index.get(kind, ()):
            if "::" in (text := element.content) and "" in text.split("::"):
                found.append(MalformedScopedName(element.own_value))
