"""A robot description as objects: worlds, models, links and joints, by name or index.

What stands in included files is there, too, where they are found. Every object hands
out its XML element, so that custom elements and attributes can be read as the
custom-elements proposal (SDFormat 1.7) has it. Looking at a document never changes it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, TypeVar, overload

from sdfcheck.robot.scopes import Frame, Scope, scopes
from sdfcheck.source.element import Element, Value

if TYPE_CHECKING:
    from sdfcheck.source.document import Document

T = TypeVar("T", str, int, float, bool)
P = TypeVar("P", bound="Part")


class NotFound(LookupError):
    """There is no part of that name or number."""


class Part:
    """Something that has a name; its element is the place of everything that is written about it."""

    __slots__ = ("_name", "element")

    def __init__(self, name: str, element: Element) -> None:
        self._name = name
        self.element = element

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self._name!r})"

    @property
    def name(self) -> str:
        return self._name

    def attribute(self, name: str) -> Value | None:
        """The attribute of that name, prefix included: ``attribute("flatland:type")``."""
        return self.element.attribute(name)

    def has(self, name: str) -> bool:
        """Is there a child element of that name, prefix included?"""
        return self.element.has(name)

    def find(self, name: str) -> Element | None:
        """The first child element of that name, prefix included."""
        return self.element.find(name)

    def children(self, name: str | None = None) -> Iterator[Element]:
        """The child elements, or those of one name."""
        return self.element.children(name)

    @overload
    def get(self, name: str) -> str | None: ...
    @overload
    def get(self, name: str, type: type[T]) -> T | None: ...
    def get(self, name: str, type: type[T] | type[str] = str) -> T | str | None:
        """The value of an attribute, else of a child element, as str, int, float or bool.

        None if there is neither; ValueError, with the place, if it is not of the type.
        """
        return self.element.get(name, type)


class Link(Part):
    """A link."""

    __slots__ = ()


class Joint(Part):
    """A joint; ``parent`` and ``child`` are the names as written, empty where none is."""

    __slots__ = ()

    @property
    def type(self) -> str:
        return self.get("type") or ""

    @property
    def parent(self) -> str:
        return self._end("parent")

    @property
    def child(self) -> str:
        return self._end("child")

    def _end(self, which: str) -> str:
        end = self.find(which)
        return "" if end is None else end.get("link") or end.content


class _Group(Part):
    """A part that others stand in."""

    __slots__ = ("_scope",)

    def __init__(self, scope: Scope) -> None:
        super().__init__(scope.name, scope.element)
        self._scope = scope

    @property
    def models(self) -> tuple[Model, ...]:
        """The models directly inside, included ones among them, in the order of the file."""
        return tuple(Model(frame.inner) for frame in self._frames("model") if frame.inner is not None)

    @property
    def joints(self) -> tuple[Joint, ...]:
        return tuple(Joint(frame.name, frame.element) for frame in self._frames("joint"))

    def model(self, key: str | int) -> Model:
        """A model by name (``outer::inner`` reaches into models) or by index; raises NotFound."""
        return _pick(self, "model", self.models, key)

    def joint(self, key: str | int) -> Joint:
        """A joint by name, also of an inner model (``arm::elbow``), or by index; raises NotFound."""
        return _pick(self, "joint", self.joints, key)

    def _frames(self, kind: str) -> list[Frame]:
        order = {child: number for number, child in enumerate(self._scope.element)}
        found = [frame for frame in self._scope.frames.values() if frame.kind == kind]
        return sorted(found, key=lambda frame: order.get(frame.element, len(order)))


class Model(_Group):
    """A model, or the robot of a URDF file."""

    __slots__ = ()

    @property
    def links(self) -> tuple[Link, ...]:
        return tuple(Link(frame.name, frame.element) for frame in self._frames("link"))

    def link(self, key: str | int) -> Link:
        """A link by name, also of an inner model (``arm::hand``), or by index; raises NotFound."""
        return _pick(self, "link", self.links, key)

    @property
    def include(self) -> Element | None:
        """The ``include`` that brought the model, if one did."""
        return self._scope.placed


class World(_Group):
    """A world."""

    __slots__ = ()


class Root:
    """A whole document: its worlds, and the models that stand in none.

    A URDF file is one model.
    """

    __slots__ = ("document", "element", "models", "worlds")

    def __init__(self, document: Document, element: Element) -> None:
        self.document = document
        self.element = element
        roots = [_urdf_scope(element)] if element.name == "robot" else scopes(document).roots
        self.worlds = tuple(World(scope) for scope in roots if scope.kind == "world")
        self.models = tuple(Model(scope) for scope in roots if scope.kind == "model")

    def __repr__(self) -> str:
        return f"Root({str(self.document.path)!r})"

    @property
    def version(self) -> str | None:
        """The version of the format that the file declares."""
        return self.document.version

    def world(self, key: str | int) -> World:
        """A world by name or index; raises NotFound."""
        return _pick(self, "world", self.worlds, key)

    def model(self, key: str | int) -> Model:
        """A model that stands in no world, by name or index; raises NotFound."""
        return _pick(self, "model", self.models, key)


def _pick(owner: Root | _Group, kind: str, parts: Sequence[P], key: str | int) -> P:
    """The part of a name or number."""
    where = f"{type(owner).__name__.lower()} `{owner.name}`" if isinstance(owner, Part) else "the file"
    if isinstance(key, int):
        if -len(parts) <= key < len(parts):
            return parts[key]
        held = f"{len(parts)} {kind}" if len(parts) == 1 else f"{len(parts)} {kind}s"
        raise NotFound(f"{where} has no {kind} number {key}; it has {held}")
    found = next((part for part in parts if part.name == key), None)
    if found is not None:
        return found
    outer, scoped, inner = key.partition("::")
    if scoped:
        models = owner.models
        model = next((model for model in models if model.name == outer), None)
        if model is not None:
            return getattr(model, kind)(inner)  # type: ignore[no-any-return]
    from sdfcheck.source.wrong_usage import suggestion

    near = suggestion(key, tuple(part.name for part in parts))
    raise NotFound(f"{where} has no {kind} `{key}`{near}")


def _urdf_scope(robot: Element) -> Scope:
    scope = Scope("model", robot.get("name") or "", robot, None)
    for kind in ("link", "joint"):
        for child in robot.children(kind):
            if name := child.get("name"):
                scope.frames.setdefault(name, Frame(kind, name, child, scope))
    return scope
