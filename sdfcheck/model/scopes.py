"""Name scopes: worlds and models, the frames that they name, and how references find them.

A model is a scope of its links, joints, frames and nested models, a world of its models,
joints and frames. ``A::B::name`` reaches down into nested scopes; nothing reaches up.
Source: the specification's notes on naming (1.8) and libsdformat 17's FrameSemantics.cc,
checked against what it does.
"""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.formats.survey import survey
from sdfcheck.model.includes import Included, included
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element

MODEL_FRAME = "__model__"
WORLD_FRAME = "world"
NEVER_A_REFERENCE = "__root__"

_FRAME_KINDS = frozenset({"link", "joint", "frame", "model"})
_MERGED = frozenset({"link", "joint", "frame", "model"})


class Frame:
    """Something that poses can be relative to: a link, joint, frame, model, or a scope's own frame.

    ``inner`` is the scope of a model. ``element`` is an ``include`` where one brought it.
    """

    __slots__ = ("element", "inner", "kind", "name", "scope")

    def __init__(self, kind: str, name: str, element: Element, scope: Scope, inner: Scope | None = None) -> None:
        self.kind = kind
        self.name = name
        self.element = element
        self.scope = scope
        self.inner = inner

    def __repr__(self) -> str:
        return f"Frame({self.kind} {self.name})"


class Scope:
    """One world or model.

    ``complete`` is False where an include could not be read, so that an unknown name
    proves nothing.
    """

    __slots__ = ("complete", "element", "frames", "is_static", "kind", "name", "own", "parent", "placed")

    def __init__(self, kind: str, name: str, element: Element, parent: Scope | None) -> None:
        self.kind = kind
        self.name = name
        self.element = element
        self.parent = parent
        self.frames: dict[str, Frame] = {}
        self.complete = True
        self.is_static = _is_static(element) or (parent is not None and parent.is_static)
        own = MODEL_FRAME if kind == "model" else WORLD_FRAME
        self.own = Frame(kind, own, element, self, self)
        """The frame of the scope itself: ``__model__`` or ``world``."""
        self.placed: Element | None = None
        """The ``include`` that brought this model, if one did."""

    def __repr__(self) -> str:
        return f"Scope({self.kind} {self.name}, {len(self.frames)} frames)"

    @property
    def inner(self) -> Iterator[Scope]:
        """The scopes of the nested models."""
        for frame in self.frames.values():
            if frame.inner is not None:
                yield frame.inner

    def links(self) -> Iterator[Frame]:
        return (frame for frame in self.frames.values() if frame.kind == "link")

    def find(self, reference: str) -> Frame | None:
        """What a reference names; None if nothing of that name is known here."""
        if reference == self.own.name:
            return self.own
        found = self.frames.get(reference)
        if found is not None or "::" not in reference:
            return found
        head, _, rest = reference.partition("::")
        model = self.frames.get(head)
        return model.inner.find(rest) if model is not None and model.inner is not None else None

    def may_hold(self, reference: str) -> bool:
        """Might it name something in a file that could not be read?"""
        if not self.complete:
            return True
        head, delimiter, rest = reference.partition("::")
        model = self.frames.get(head) if delimiter else None
        return model is not None and (model.inner is None or model.inner.may_hold(rest))

    def names(self) -> Iterator[str]:
        """Every name that a reference here can use, scoped ones included."""
        for name, frame in self.frames.items():
            yield name
            if frame.inner is not None:
                yield from (f"{name}::{deeper}" for deeper in frame.inner.names())


class Scopes:
    """All scopes of a document: its worlds and top-level models, and what is in them."""

    __slots__ = ("by_element", "roots")

    def __init__(self, document: Document) -> None:
        self.by_element: dict[Element, Scope] = {}
        """The scopes of this document's own world and model elements."""
        root = document.root
        self.roots: list[Scope] = []
        if root is None:
            return
        for kind, name, element in survey(document).named.get(root, ()):
            if kind in {"world", "model"}:
                self.roots.append(self._build(document, kind, name, element, None))

    def of(self, element: Element) -> Scope | None:
        """The innermost scope that an element stands in."""
        at = element.parent
        while at is not None:
            if at in self.by_element:
                return self.by_element[at]
            at = at.parent
        return None

    def all(self) -> Iterator[Scope]:
        """Every scope that this document's own elements make, in document order."""
        return iter(self.by_element.values())

    def _build(
        self, document: Document, kind: str, name: str, element: Element, parent: Scope | None, depth: int = 0
    ) -> Scope:
        scope = Scope(kind, name, element, parent)
        if depth == 0:
            self.by_element[element] = scope
        self._fill(document, scope, element, depth)
        return scope

    def _fill(self, document: Document, scope: Scope, element: Element, depth: int) -> None:
        if element.tag == "robot":
            self._fill_from_urdf(scope, element)
            return
        surveyed = survey(document)
        for kind, name, child in surveyed.named.get(element, ()):
            if kind not in _FRAME_KINDS or not name:
                continue
            inner = self._build(document, "model", name, child, scope, depth) if kind == "model" else None
            scope.frames.setdefault(name, Frame(kind, name, child, scope, inner))
        if surveyed.index.get("include"):
            for include in element.children("include"):
                self._include(scope, included(document, include), depth)

    def _fill_from_urdf(self, scope: Scope, robot: Element) -> None:
        for kind in ("link", "joint"):
            for child in robot.children(kind):
                if name := child.attributes.get("name", ""):
                    scope.frames.setdefault(name, Frame(kind, name, child, scope))

    def _include(self, scope: Scope, found: Included, depth: int) -> None:
        """Bring in an included model: as a nested one, or its parts when it is merged."""
        if found.kind not in {"model", None}:
            return  # lights and actors make no frames
        if found.merge:
            self._merge(scope, found, depth)
            return
        if found.name is None:
            scope.complete = False
            return
        inner = None
        if found.model is not None:
            inner = self._build(found.model.document, "model", found.name, found.model, scope, depth + 1)
            inner.is_static = inner.is_static or found.is_static
            inner.placed = found.include
        scope.frames.setdefault(found.name, Frame("model", found.name, found.include, scope, inner))

    def _merge(self, scope: Scope, found: Included, depth: int) -> None:
        if found.model is None:
            scope.complete = False
            return
        self._fill(found.model.document, scope, found.model, depth + 1)
        if found.name:
            own = f"_merged__{found.name}__model__"
            scope.frames.setdefault(own, Frame("frame", own, found.include, scope))


def scopes(document: Document) -> Scopes:
    """The scopes of a document, worked out once."""
    return document.view(Scopes)


def _is_static(element: Element) -> bool:
    static = element.find("static")
    return static is not None and static.content.lower() in {"true", "1"}
