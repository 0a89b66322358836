"""Scopes: worlds and models, the nodes that they name, and how references find them.

A model is a scope of its links, joints, frames and nested models, a world of its models,
joints and frames. ``A::B::name`` reaches down into nested models; nothing reaches up.
Source: the specification's notes on naming (1.8) and libsdformat 17's FrameSemantics.cc,
checked against what it does.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import islice
from typing import TYPE_CHECKING, TypeVar, cast

from sdfcheck.formats.sdf.version import Version
from sdfcheck.robot.node import Node
from sdfcheck.robot.reserved import MODEL_FRAME, NODES
from sdfcheck.robot.values import lazy

if TYPE_CHECKING:
    from sdfcheck.robot.frame import Frame, MergedFrame
    from sdfcheck.robot.includes.included import Included
    from sdfcheck.robot.model import Model
    from sdfcheck.robot.naming.guess import Guess
    from sdfcheck.robot.naming.unresolved import Unresolved
    from sdfcheck.robot.part import Part
    from sdfcheck.robot.parts.joint import Joint
    from sdfcheck.robot.parts.link import Link
    from sdfcheck.source.document import Document
    from sdfcheck.source.element import Element

N = TypeVar("N", bound=Node)

NEVER_A_REFERENCE = "__root__"

_SEVEN = Version(1, 7)
_LOADED = ("model", "link", "joint", "frame")
"""The order in which libsdformat takes them in."""

_MOST_NAMES = 20_000

Child = tuple[str, str, "Element"]
"""Kind, name and element."""


class Scope(Node):
    """A model or a world.

    ``is_complete`` is False where an include could not be read, so that an unknown name
    proves nothing.
    """

    __slots__ = ("_unread", "chain", "stand_in")

    is_scope = True
    own_name = MODEL_FRAME
    """The name of the scope's own frame, as references in it write it."""

    def __init__(self, holder: Part, element: Element | None, name: str | None = None) -> None:
        super().__init__(holder, element, name)
        self._unread = False
        outer = holder if isinstance(holder, Scope) else None
        self.chain: tuple[Document, ...] = outer.chain if outer else (self.document,)
        """The files that are being read, from the outside in."""
        self.stand_in: MergedFrame | None = None
        """The frame that represents it where an include merged it."""

    # Nodes

    @lazy
    def nodes(self) -> dict[str, Node]:
        """Everything that a reference can name here without ``::``; of several of a name the first."""
        found: dict[str, Node] = {}
        self._fill(found)
        return found

    @property
    def is_complete(self) -> bool:
        """Could everything that it includes be read?"""
        _ = self.nodes
        return not self._unread

    @property
    def links(self) -> tuple[Link, ...]:
        """The links directly in it, in the order of the file."""
        return cast("tuple[Link, ...]", self._members("link"))

    @property
    def joints(self) -> tuple[Joint, ...]:
        """The joints directly in it, in the order of the file."""
        return cast("tuple[Joint, ...]", self._members("joint"))

    @property
    def frames(self) -> tuple[Frame, ...]:
        """The frames that are written as ``frame``, and those of merged models."""
        return cast("tuple[Frame, ...]", self._members("frame"))

    @property
    def models(self) -> tuple[Model, ...]:
        """The models directly in it, included ones among them."""
        return cast("tuple[Model, ...]", self._members("model"))

    def resolve(self, reference: str) -> Node | None:
        """The node that a reference names; None if the name is unknown here."""
        if not self.is_urdf:
            reference = reference.strip()
        if reference == self.own_name:
            return self
        if reference == NEVER_A_REFERENCE:
            return None
        found = self.nodes.get(reference)
        if found is not None or "::" not in reference:
            return found
        head, _, rest = reference.partition("::")
        model = self.nodes.get(head)
        return model.resolve(rest) if isinstance(model, Scope) else None

    def may_hold(self, reference: str) -> bool:
        """Might it name something in a file that could not be read?"""
        if not self.is_complete:
            return True
        head, delimiter, rest = reference.partition("::")
        model = self.nodes.get(head) if delimiter else None
        return isinstance(model, Scope) and model.may_hold(rest)

    def lacks(self, reference: str) -> bool:
        """Does a reference surely name nothing here? Not known where a part of it is empty."""
        if self.resolve(reference) is not None or "" in reference.split("::"):
            return False
        return not self.may_hold(reference)

    def guess(self, reference: str, but: tuple[str, ...] = (), kind: str = "") -> Guess:
        """The intended name of a reference that is not resolved here: none of ``but``, and of ``kind``."""
        from sdfcheck.robot.naming.guess import guess

        return guess(self, reference, but, kind)

    @lazy
    def unresolved(self) -> Unresolved:
        """The names by which its joints refer to nothing, with the ends of joints that use them."""
        from sdfcheck.robot.naming.unresolved import unresolved_ends

        return unresolved_ends(self)

    @lazy
    def lost_names(self) -> frozenset[str]:
        """Those of the unresolved names for which not the joints are at fault, but what has lost its name."""
        from sdfcheck.robot.naming.unresolved import lost_names

        return lost_names(self, self.unresolved)

    def names(self) -> Iterator[str]:
        """The names that a reference here can use, scoped ones included; not all of very many."""
        return islice(self._names(), _MOST_NAMES)

    def _names(self) -> Iterator[str]:
        for name, node in self.nodes.items():
            yield name
            if isinstance(node, Scope):
                yield from (f"{name}::{deeper}" for deeper in node._names())

    def all_nodes(self, prefix: str = "") -> Iterator[tuple[str, Node]]:
        """All nodes in it and in its models, with their names from here."""
        for name, node in self.nodes.items():
            yield prefix + name, node
            if isinstance(node, Scope):
                yield from node.all_nodes(f"{prefix}{name}::")

    def _members(self, kind: str) -> tuple[Node, ...]:
        """The nodes of a kind, those without a name or with one that is taken as well."""
        named = [node for node in self.nodes.values() if node.kind == kind]
        elements = list(self.children(kind))
        if len(elements) == len(named):
            return tuple(self._in_order(named))
        own = [cast("Node", self.part(element)) for element in elements]
        known = set(own)
        return tuple(self._in_order([*own, *(node for node in named if node not in known)]))

    def _in_order(self, nodes: list[N]) -> list[N]:
        if all(node.place.name != "include" for node in nodes):
            return nodes
        order = {child: number for number, child in enumerate(self.children())}
        return sorted(nodes, key=lambda node: order.get(node.place, len(order)))

    # Parts by name

    def model(self, key: str | int) -> Model:
        """A model by name (``outer::inner`` reaches into models) or by index; raises NotFound."""
        from sdfcheck.robot.access.lookup import pick

        return pick(self, "model", self.models, key)

    def joint(self, key: str | int) -> Joint:
        """A joint by name, also of an inner model (``arm::elbow``), or by index; raises NotFound."""
        from sdfcheck.robot.access.lookup import pick

        return pick(self, "joint", self.joints, key)

    # Filling

    def _fill(self, nodes: dict[str, Node]) -> None:
        self._take_from(self, nodes)

    def _take_from(self, source: Scope, nodes: dict[str, Node]) -> None:
        """Take in the named children of a source: the scope itself, or a model that is merged into it."""
        if source.is_urdf:
            for kind in ("link", "joint"):
                for child in source.element.children(kind):
                    if name := child.text_of("name", ""):
                        self._take(source, nodes, name, child)
            return
        for kind, name, child in _named_children(source):
            if kind in NODES and (name := name.strip()):
                self._take(source, nodes, name, child)
        from sdfcheck.formats.sdf.survey import survey

        if survey(source.document).index.get("include"):
            from sdfcheck.robot.includes.included import included

            for include in source.element.children("include"):
                self._include(source, nodes, included(source.document, include))

    def _take(self, source: Scope, nodes: dict[str, Node], name: str, element: Element) -> None:
        part = source.part(element)
        if isinstance(part, Node):
            part._name = name
            if source is not self:
                part.holder, part.merged = self, source.stand_in
            nodes.setdefault(name, part)

    def _include(self, source: Scope, nodes: dict[str, Node], found: Included) -> None:
        """Bring in an included model: as a nested one, or its parts where it is merged."""
        if found.kind not in {"model", None}:
            return  # lights and actors make no frames
        from sdfcheck.robot.includes.brought import included_model

        model = included_model(source, found)
        if not found.merge:
            if found.name is None or model is None:
                self._unread = True
            else:
                model.holder = self
                nodes.setdefault(found.name, model)
            return
        if model is None or not model.is_readable:
            self._unread = True
            return
        from sdfcheck.robot.frame import MergedFrame

        model.stand_in = MergedFrame(self, found.include, model)
        self._take_from(model, nodes)
        self._unread = self._unread or model._unread
        if found.name:
            nodes.setdefault(model.stand_in.name, model.stand_in)


def _named_children(source: Scope) -> Iterable[Child]:
    """The named parts of a world or model."""
    from sdfcheck.formats.sdf.survey import survey

    surveyed = survey(source.document)
    children: Iterable[Child] = surveyed.named.get(source.element, ())
    return _without_clashes(children) if surveyed.version < _SEVEN else children


def _without_clashes(children: Iterable[Child]) -> Iterable[Child]:
    """As libsdformat has it before 1.7: of two kinds with one name, the one taken in later gets another."""
    found = [entry for entry in children if entry[0] in NODES]
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
