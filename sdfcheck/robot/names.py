"""Names: unique in their scope, not reserved, and sound as references.

Scopes and severities as libsdformat 17 has them: in a model, links, joints, frames and
nested models share one name space, in a world models, joints and frames do; the
``gz sdf`` check refuses any two named siblings, plugins excepted.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from sdfcheck.formats.sdf.survey import Survey, survey
from sdfcheck.formats.sdf.version import Version
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element, Value
from sdfcheck.source.record import NamedTuple, Record

FRAME_KINDS = frozenset({"link", "joint", "frame", "model"})
"""Elements whose names make frames, and so share one name space in their scope."""

# Among names, one a line: what may be reserved, has blanks at its ends, or a colon in it.
_ODD_LINE = re.compile(r"^__|^world$|^\s|[ \t\r]$|:", re.MULTILINE)

_SEVEN, _EIGHT = Version(1, 7), Version(1, 8)

# One of these is all that a document may hold, which the analysis of structure tells.
_SINGLE_AT_ROOT = frozenset({"model", "light", "actor"})

_REFERENCE_ATTRIBUTES = {
    "frame": ("attached_to",),
    "pose": ("relative_to",),
    "xyz": ("expressed_in",),
    "model": ("canonical_link", "placement_frame"),
    "mimic": ("joint",),
    "custom_rpy": ("parent_frame",),
}
_REFERENCE_ELEMENTS = (
    "parent",
    "child",
    "placement_frame",
    "gearbox_reference_body",
    "gripper_link",
    "palm_link",
)


class DuplicateName(Record):
    """Two siblings of one kind with one name; ``value`` is the later one's name.

    For an include that gives no name of its own ``value`` is the uri that brings it.
    """

    value: Value
    first: Value
    parent: Element
    name: str
    kind: str


class ClashingName(Record):
    """Siblings of different kinds, ``kind`` and ``first_kind``, with one name.

    ``makes_frame``: one of them at least makes a frame. ``renamed``: both do, in an old
    version, for which libsdformat renames the later one instead of refusing the file.
    """

    value: Value
    first: Value
    parent: Element
    name: str
    kind: str
    first_kind: str
    makes_frame: bool
    renamed: bool


class ReservedName(Record):
    """A name that libsdformat keeps for itself; ``is_reference`` where it is used, not given."""

    value: Value
    is_reference: bool = False


class DelimiterInName(Record):
    """``::`` in a definition; ``refused`` from version 1.8 on.

    ``foreign`` is what makes libsdformat crash when it unfolds the names of an older
    world: a reference that stays outside, or an axis without direction.
    """

    value: Value
    refused: bool
    foreign: Value | Element | None


class MalformedScopedName(Record):
    """A reference with a part missing before, behind or between ``::``."""

    value: Value


Problem = DuplicateName | ClashingName | ReservedName | DelimiterInName | MalformedScopedName


class _Named(NamedTuple):
    """One name in a scope: what it is counted as, the name, and where that stands."""

    kind: str
    name: str
    value: Value


def problems(document: Document) -> list[Problem]:
    """Everything about names that is wrong in an SDF document, in no particular order."""
    surveyed = survey(document)
    included = list(_included(surveyed))
    doubtful = {*_doubtful(surveyed), *(parent for parent, _ in included)}
    siblings = {
        parent: [
            _Named(kind, text.strip(), Value(element, "name", text))
            for kind, text, element in children
            if text.strip()
        ]
        for parent, children in surveyed.named.items()
        if parent in doubtful
    }
    for parent, named in included:
        siblings.setdefault(parent, []).append(named)
    found: list[Problem] = []
    foreign = _unfolded(surveyed, siblings)
    for parent, children in siblings.items():
        found += _unsound(surveyed, children, foreign)
        found += _repeated(surveyed, parent, children)
    if _has_odd_delimiter(document.source.text):
        found += _references(surveyed)
    found += _root_references(surveyed)
    return found


def _doubtful(surveyed: Survey) -> Iterator[Element]:
    """The cheap question whose children may have names that something is wrong with."""
    named = surveyed.named
    lines = (name for children in named.values() for kind, name, _ in children if kind != "plugin")
    if _ODD_LINE.search("\n".join(lines)):
        yield from named
        return
    for parent, children in named.items():
        if len(children) > 1 and len({name for _, name, _ in children}) < len(children):
            yield parent


def is_reserved(name: str) -> bool:
    """``world``, and ``__any__``: at least four characters between double underscores."""
    return name == "world" or (len(name) >= 4 and name.startswith("__") and name.endswith("__"))


def _included(surveyed: Survey) -> Iterator[tuple[Element, _Named]]:
    """The names that includes bring into their scopes, as far as they are known."""
    for include in surveyed.index.get("include", ()):
        from sdfcheck.robot.includes import included

        found = included(surveyed.document, include)
        parent = include.parent
        if found.name is None or parent is None:
            continue
        own = include.find("name")
        value = own.own_value if own is not None and own.content else found.uri
        if value is None:
            continue
        name = f"_merged__{found.name}__model__" if found.merge else found.name
        yield parent, _Named("frame" if found.merge else found.kind or "model", name, value)


def _unfolded(surveyed: Survey, siblings: dict[Element, list[_Named]]) -> dict[Element, Value | Element]:
    if surveyed.version >= _EIGHT or not any("::" in n.name for named in siblings.values() for n in named):
        return {}
    from sdfcheck.robot.unfold import foreign_references

    return foreign_references(surveyed)


def _is_checked(kind: str) -> bool:
    """Whether names of elements of a kind are compared with the reserved ones."""
    from sdfcheck.formats.sdf.history import reserved_name_holders

    return kind in reserved_name_holders()


def _unsound(
    surveyed: Survey, children: list[_Named], foreign: dict[Element, Value | Element]
) -> Iterator[Problem]:
    """Names that are wrong by themselves."""
    for kind, name, value in children:
        element = value.element
        if is_reserved(name) and _is_checked(kind):
            yield ReservedName(value)
        if "::" in name and ":" not in kind and kind != "plugin":
            yield DelimiterInName(value, surveyed.version >= _EIGHT, foreign.get(element))


def _repeated(surveyed: Survey, parent: Element, children: list[_Named]) -> Iterator[Problem]:
    """Names that are taken."""
    taken: dict[str, _Named] = {}
    is_root = parent.parent is None
    for named in children:
        if named.kind == "plugin" or (is_root and named.kind in _SINGLE_AT_ROOT):
            continue
        first = taken.setdefault(named.name, named)
        if first is named:
            continue
        if first.kind == named.kind:
            yield DuplicateName(named.value, first.value, parent, named.name, named.kind)
            continue
        makes_frame = {named.kind in FRAME_KINDS, first.kind in FRAME_KINDS}
        renamed = makes_frame == {True} and surveyed.version < _SEVEN
        is_custom = ":" in named.kind or ":" in first.kind
        yield ClashingName(
            named.value,
            first.value,
            parent,
            named.name,
            named.kind,
            first.kind,
            True in makes_frame and not is_custom,
            renamed,
        )


def _has_odd_delimiter(text: str) -> bool:
    """The cheap question whether any ``::`` has nothing before or behind it."""
    ends = frozenset("\"'<>: \t\r\n")
    return any(
        text[match.start() - 1] in ends or text[match.end() : match.end() + 1] in ends
        for match in re.finditer("::", text)
    )


def _references(surveyed: Survey) -> Iterator[Problem]:
    index = surveyed.index
    for kind, names in _REFERENCE_ATTRIBUTES.items():
        for element in index.get(kind, ()):
            for value in filter(None, map(element.attribute, names)):
                if "::" in value.text and "" in value.text.strip().split("::"):
                    yield MalformedScopedName(value)
    for kind in _REFERENCE_ELEMENTS:
        for element in index.get(kind, ()):
            if "::" in (text := element.content) and "" in text.split("::"):
                yield MalformedScopedName(element.own_value)


def _root_references(surveyed: Survey) -> Iterator[Problem]:
    for element in surveyed.index.get("custom_rpy", ()):
        frame = element.attribute("parent_frame")
        if frame is not None and frame.text.strip() == "__root__":
            yield ReservedName(frame, is_reference=True)
