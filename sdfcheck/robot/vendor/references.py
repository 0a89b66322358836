"""The parts that the names in vendors' tags refer to: in SDF by scope, in URDF among the robot's parts."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import chain
from typing import TYPE_CHECKING

from sdfcheck.formats.near_names import nearest
from sdfcheck.formats.vendor.definitions import Slot, Vendor
from sdfcheck.robot.reserved import MODEL_FRAME
from sdfcheck.robot.root import root_of
from sdfcheck.robot.scope import Scope
from sdfcheck.robot.vendor.relations import is_skipped
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind

if TYPE_CHECKING:
    from sdfcheck.robot.vendor.value import VendorValue

_URDF_KINDS = frozenset({"frame", "joint", "link"})
_UNKNOWABLE = "?"


def owner_of(element: Element) -> Element | None:
    """The model or robot that the names in an element belong to."""
    return next((each for each in element.around if each.name in {"model", "robot"}), None)


class Unresolved(NamedTuple):
    """A name that nothing of the right kind has."""

    kinds: tuple[str, ...]
    """The kinds that would do."""
    found: str | None
    """The kind of what has the name instead."""
    near: str | None
    """The name that was probably meant."""


class _Found(NamedTuple):
    """The part of a name (None: nothing; ``?``: that cannot be determined), and the names that would do."""

    kind: str | None
    candidates: Iterable[str]


class References:
    """Resolves the names in the tags of one vendor in a document."""

    def __init__(self, document: Document, vendor: Vendor) -> None:
        self.document = document
        self.vendor = vendor
        self.is_sdf = document.kind is Kind.SDF
        self._parts: dict[tuple[Element, tuple[str, ...]], dict[str, str]] = {}
        self._right: dict[tuple[Element, tuple[str, ...], bool], list[str]] = {}
        self._tags: dict[tuple[Element, str], dict[str, None]] = {}

    def unresolved(self, value: VendorValue) -> Unresolved | None:
        """The fault of a name that is not defined; None for one that may refer to something."""
        slot, name = value.slot, value.text.strip()
        owner = owner_of(value.value.element)
        if owner is None:
            return None
        found = self.look_up(owner, slot, name)
        if found.kind in slot.references or found.kind == _UNKNOWABLE:
            return None
        return Unresolved(slot.references, found.kind, nearest(name, found.candidates, self.document))

    def look_up(self, owner: Element, slot: Slot, name: str) -> _Found:
        own = [kind for kind in slot.references if ":" in kind]
        found = _Found(None, [])
        if len(own) < len(slot.references):
            found = self.in_sdf(owner, slot, name) if self.is_sdf else self.in_urdf(owner, slot, name)
        for kind in own:
            if found.kind not in slot.references:
                tags = self.among_tags(owner, kind, slot, name)
                found = _Found(tags.kind or found.kind, chain(found.candidates, tags.candidates))
        return found

    def in_sdf(self, owner: Element, slot: Slot, name: str) -> _Found:
        scope = self.scope(owner)
        if scope is None or (name == MODEL_FRAME and "frame" in slot.references):
            return _Found(_UNKNOWABLE, [])
        right = self.right_in(owner, scope, slot)
        if "::" in name and not slot.scoped:
            return _Found(None, right)
        if scope.resolve(name) is None and scope.may_hold(name):
            return _Found(_UNKNOWABLE, [])
        return _Found(_kind(scope, name), right)

    def right_in(self, owner: Element, scope: Scope, slot: Slot) -> list[str]:
        """The names in a model that would do, in its order."""
        key = (owner, slot.references, slot.scoped)
        if key not in self._right:
            self._right[key] = [
                candidate
                for candidate in scope.names()
                if (slot.scoped or "::" not in candidate) and _kind(scope, candidate) in slot.references
            ]
        return self._right[key]

    def scope(self, owner: Element) -> Scope | None:
        part = root_of(self.document).part_of(owner)
        return part if isinstance(part, Scope) else None

    def in_urdf(self, owner: Element, slot: Slot, name: str) -> _Found:
        kinds = self.parts_of(owner, slot.references)
        key = (owner, slot.references, False)
        if key not in self._right:
            self._right[key] = [own for own, kind in kinds.items() if kind in slot.references]
        return _Found(None if name == "world" else kinds.get(name), self._right[key])

    def parts_of(self, owner: Element, wanted: tuple[str, ...]) -> dict[str, str]:
        """The kinds of a robot's parts by their names; of several of a name one that is wanted."""
        key = (owner, wanted)
        if key not in self._parts:
            kinds = self._parts[key] = {}
            for child in owner.children():
                kind = child.name.removeprefix(f"{self.vendor.prefix}:")
                own = child.attributes.get("name", "")
                if kind in _URDF_KINDS and own and kinds.get(own) not in wanted:
                    kinds[own] = kind
        return self._parts[key]

    def among_tags(self, owner: Element, kind: str, slot: Slot, name: str) -> _Found:
        """Tags of a kind in the same model or, where scoped names are understood, in nested ones."""
        path, delimiter, last = name.rpartition("::")
        if not delimiter:
            names = self.named(owner, kind)
            return _Found(kind if name in names else None, names)
        scope = self.scope(owner) if self.is_sdf and slot.scoped else None
        if scope is None:
            return _Found(None, self.named(owner, kind))
        model = scope.resolve(path)
        if not isinstance(model, Scope) or not model.is_complete:
            return _Found(_UNKNOWABLE if scope.may_hold(name) else None, [])
        names = self.named(model.element, kind)
        return _Found(kind if last in names else None, (f"{path}::{own}" for own in names))

    def named(self, owner: Element, kind: str) -> dict[str, None]:
        """The names of an element's children of one kind, in their order."""
        key = (owner, kind)
        if key not in self._tags:
            tags = (child for child in owner.children(kind) if not is_skipped(self.vendor, child))
            names = (child.text_of("name", "") for child in tags)
            self._tags[key] = dict.fromkeys(filter(None, names))
        return self._tags[key]


def _kind(scope: Scope, name: str) -> str | None:
    frame = None if name == "world" else scope.resolve(name)
    return None if frame is None else frame.kind
