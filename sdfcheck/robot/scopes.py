"""Name scopes: worlds and models, the frames that they name, and how references find them.

A model is a scope of its links, joints, frames and nested models, a world of its models,
joints and frames. ``A::B::name`` reaches down into nested scopes; nothing reaches up.
Source: the specification's notes on naming (1.8) and libsdformat 17's FrameSemantics.cc,
checked against what it does.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from itertools import islice
from typing import TYPE_CHECKING

from sdfcheck.formats.sdf.survey import survey
from sdfcheck.formats.sdf.version import Version
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element
from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    from sdfcheck.robot.includes.alterations import Alterations
    from sdfcheck.robot.includes.included import Included

MODEL_FRAME = "__model__"
WORLD_FRAME = "world"
NEVER_A_REFERENCE = "__root__"

_SEVEN = Version(1, 7)
_FRAME_KINDS = frozenset({"link", "joint", "frame", "model"})
_LOADED = ("model", "link", "joint", "frame")
"""The order in which libsdformat takes them in."""

MOST_MODELS = 10_000
"""So many included models are looked into: includes of includes can multiply without end."""
_MOST_NAMES = 20_000
DEEPEST = 50


class Frame:
    """Something that poses can be relative to: a link, joint, frame, model, or a scope's own frame.

    ``inner`` is the scope of a model; that of an included one is built when it is asked
    for. ``element`` is an ``include`` where one brought it.
    """

    __slots__ = ("_inner", "element", "kind", "name", "scope")

    def __init__(
        self,
        kind: str,
        name: str,
        element: Element,
        scope: Scope,
        inner: Scope | Callable[[], Scope | None] | None = None,
    ) -> None:
        self.kind = kind
        self.name = name
        self.element = element
        self.scope = scope
        self._inner = inner

    def __repr__(self) -> str:
        return f"Frame({self.kind} {self.name})"

    @property
    def inner(self) -> Scope | None:
        inner = self._inner
        if inner is not None and not isinstance(inner, Scope):
            inner = self._inner = inner()
        return inner


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
        self.is_static: bool = _is_static(element) or (parent is not None and parent.is_static)
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
        if model is None or model.kind != "model":
            return False
        return model.inner is None or model.inner.may_hold(rest)

    def names(self) -> Iterator[str]:
        """The names that a reference here can use, scoped ones included; not all of very many."""
        return islice(self._names(), _MOST_NAMES)

    def _names(self) -> Iterator[str]:
        for name, frame in self.frames.items():
            yield name
            if frame.inner is not None:
                yield from (f"{name}::{deeper}" for deeper in frame.inner._names())


class _Origin(NamedTuple):
    """Where the content of an included model comes from, while a scope is filled with it."""

    include: Element
    alterations: Alterations | None
    chain: tuple[Document, ...]
    """The documents that are being read, from the outside in."""


class Scopes:
    """All scopes of a document: its worlds and top-level models, and what is in them."""

    __slots__ = ("_built", "by_element", "document", "roots")

    def __init__(self, document: Document) -> None:
        self.by_element: dict[Element, Scope] = {}
        """The scopes of this document's own world and model elements."""
        self.document = document
        self._built = 0
        root = document.root
        self.roots: list[Scope] = []
        if root is None:
            return
        for kind, name, element in survey(document).named.get(root, ()):
            if kind in {"world", "model"}:
                self.roots.append(self._build(kind, name, element, None, None))

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

    def of_included(self, found: Included, parent: Scope | None) -> Scope | None:
        """The scope of the model that an include of this document brings, as the include alters it."""
        return self._included(found, parent, None)

    def _build(
        self, kind: str, name: str, element: Element, parent: Scope | None, origin: _Origin | None
    ) -> Scope:
        scope = Scope(kind, name, element, parent)
        if origin is None:
            self.by_element[element] = scope
        self._fill(scope, element, origin)
        return scope

    def _fill(self, scope: Scope, element: Element, origin: _Origin | None) -> None:
        if element.tag == "robot":
            self._fill_from_urdf(scope, element)
            return
        document = element.document
        children: Iterable[tuple[str, str, Element]] = survey(document).named.get(element, ())
        if origin is not None and origin.alterations is not None:
            children = origin.alterations.named(element, origin.include, children)
        if survey(document).version < _SEVEN:
            children = _without_clashes(children)
        for kind, name, child in children:
            if kind not in _FRAME_KINDS or not name:
                continue
            inner = self._build("model", name, child, scope, origin) if kind == "model" else None
            scope.frames.setdefault(name, Frame(kind, name, child, scope, inner))
        if survey(document).index.get("include"):
            from sdfcheck.robot.includes.included import included

            for include in element.children("include"):
                self._include(scope, included(document, include), origin)

    def _fill_from_urdf(self, scope: Scope, robot: Element) -> None:
        for kind in ("link", "joint"):
            for child in robot.children(kind):
                if name := child.attributes.get("name", ""):
                    scope.frames.setdefault(name, Frame(kind, name, child, scope))

    def _include(self, scope: Scope, found: Included, origin: _Origin | None) -> None:
        """Bring in an included model: as a nested one, or its parts when it is merged."""
        if found.kind not in {"model", None}:
            return  # lights and actors make no frames
        if found.merge:
            self._merge(scope, found, origin)
            return
        if found.name is None:
            scope.complete = False
            return
        scope.frames.setdefault(
            found.name,
            Frame("model", found.name, found.include, scope, lambda: self._included(found, scope, origin)),
        )

    def _included(self, found: Included, parent: Scope | None, origin: _Origin | None) -> Scope | None:
        inside = self._enter(found, origin)
        if found.model is None or inside is None:
            return None
        scope = Scope("model", found.name or "", found.model, parent)
        scope.is_static = scope.is_static or found.is_static
        scope.placed = found.include
        self._fill(scope, found.model, inside)
        return scope

    def _merge(self, scope: Scope, found: Included, origin: _Origin | None) -> None:
        inside = self._enter(found, origin)
        if found.model is None or inside is None:
            scope.complete = False
            return
        self._fill(scope, found.model, inside)
        if found.name:
            own = f"_merged__{found.name}__model__"
            scope.frames.setdefault(own, Frame("frame", own, found.include, scope))

    def _enter(self, found: Included, origin: _Origin | None) -> _Origin | None:
        """The way into an included file; None where it leads in a ring, or to too much."""
        chain = origin.chain if origin is not None else (self.document,)
        inside = found.document
        if inside is None or inside in chain or len(chain) > DEEPEST:
            return None
        self._built += 1
        if self._built > MOST_MODELS:
            return None
        alterations = origin.alterations if origin is not None else None
        if alterations is None and found.include.has("experimental:params"):
            from sdfcheck.robot.includes.parameters import parameters

            alterations = parameters(found).alterations
        return _Origin(found.include, alterations, (*chain, inside))


def _without_clashes(children: Iterable[tuple[str, str, Element]]) -> Iterable[tuple[str, str, Element]]:
    """As libsdformat has it before 1.7: of two kinds with one name, the one taken in later gets another."""
    found = [entry for entry in children if entry[0] in _FRAME_KINDS]
    if len({name for _, name, _ in found}) == len(found):
        return found
    taken: dict[str, str] = {}
    renamed = []
    for kind, name, child in sorted(found, key=lambda entry: _LOADED.index(entry[0])):
        own, number = name, 1
        while taken.setdefault(own, kind) != kind:
            own, number = f"{name}_{kind}{number if number > 1 else ''}", number + 1
        renamed.append((kind, own, child))
    return renamed


def scopes(document: Document) -> Scopes:
    """The scopes of a document, worked out once."""
    return document.view(Scopes)


def _is_static(element: Element) -> bool:
    static = element.find("static")
    return static is not None and static.content.lower() in {"true", "1"}
