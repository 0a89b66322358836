"""The root of a description: everything that a file says, as one graph of parts."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import chain
from operator import attrgetter
from typing import TYPE_CHECKING, Any, TypeVar, cast, overload

from sdfcheck.formats.sdf.survey import survey
from sdfcheck.formats.version import NEWEST, VERSIONS, Version
from sdfcheck.robot.graph import ELEMENTS, ImplicitWorld, Node, Part, Registry, Scope, class_named, pick
from sdfcheck.robot.naming.name import WORLD_FRAME
from sdfcheck.robot.values import lazy

if TYPE_CHECKING:
    from sdfcheck.formats.sdf.survey import Survey
    from sdfcheck.robot.graph import Model, World
    from sdfcheck.robot.motion.mass import MassProperties
    from sdfcheck.robot.motion.poses import Poses
    from sdfcheck.robot.naming.frames import FrameReference, Ring
    from sdfcheck.robot.naming.names import Names
    from sdfcheck.robot.parts.control import ControlComponent, Ros2Control
    from sdfcheck.robot.parts.files import Include, Resource
    from sdfcheck.robot.parts.gazebo import GazeboBlock
    from sdfcheck.robot.parts.joint import Joint
    from sdfcheck.robot.parts.link import Link
    from sdfcheck.robot.parts.physics import Actor
    from sdfcheck.robot.parts.sensor import Light
    from sdfcheck.source.document import Document, Element


# Parts of the robot that the names of elements alone do not determine.


_LISTENERS = frozenset({"sensor", "audio_source"})


def _customs(root: Root) -> list[Element]:
    if root.is_urdf:
        from sdfcheck.formats.urdf.survey import survey as urdf_survey

        return urdf_survey(root.document).customs
    return survey(root.document).customs


def _contacts(root: Root) -> Iterator[Part]:
    """The contacts of sensors and sounds; surfaces have contacts of their own, and are many."""
    given = root.elements.get("contact", ())
    return (
        root.part_of(each) for each in given if each.parent is not None and each.parent.name in _LISTENERS
    )


def _control(root: Root) -> Sequence[Ros2Control]:
    return root.each("Ros2Control") if root.is_urdf and root.elements.get("ros2_control") else ()


def _components(root: Root) -> Iterator[ControlComponent]:
    return (component for block in _control(root) for component in block.components)


SPECIAL: dict[str, Callable[[Root], Iterable[object]]] = {
    "Custom": lambda root: root.made_of(found, "Custom") if (found := _customs(root)) else (),
    "Contact": _contacts,
    "ControlComponent": _components,
    "ControlInterface": lambda root: chain.from_iterable(map(attrgetter("interfaces"), _components(root))),
    "ControlTransmission": lambda root: (each for block in _control(root) for each in block.transmissions),
    "Include": attrgetter("includes"),
    "FrameReference": attrgetter("frame_references"),
    "Pieces": lambda root: (),  # `sdfcheck.lint.expanded` makes them
    "Resource": attrgetter("resources"),
    "Root": lambda root: (root,),
}
"""Class → its parts, where the names of elements alone do not determine them."""

P = TypeVar("P", bound="Part")
URDF_VERSIONS = ("1.0", "1.1", "1.2")
"""The versions of URDF that urdfdom takes, the oldest first."""


class Root(Part):
    """A whole file: its worlds, and the models, lights and actors that are in none. A URDF file is one model."""

    __slots__ = ("_document", "included")

    def __init__(self, document: Document) -> None:
        element = document.root
        assert element is not None, "a document without elements says nothing"
        self._document = document
        self.holder = None
        self.root = self
        self.element = element
        self.registry: Registry = {}
        self._each: dict[str, tuple[Any, ...]] = {}
        self.is_given = True
        self.is_urdf = element.name == "robot"
        self.included = 0  # included models that were looked into

    def __repr__(self) -> str:
        return f"Root({str(self.document.path)!r})"

    @property
    def version(self) -> str | None:
        """The version of the format that the file declares."""
        return self.document.version

    @property
    def worlds(self) -> tuple[World, ...]:
        """The worlds."""
        return cast("tuple[World, ...]", tuple(node for node in self.scopes if node.kind == "world"))

    @property
    def models(self) -> tuple[Model, ...]:
        """The models that are in no world."""
        return cast("tuple[Model, ...]", tuple(node for node in self.scopes if node.kind == "model"))

    @property
    def lights(self) -> tuple[Light, ...]:
        """The lights that are in no world."""
        return tuple(self._parts("light"))

    @property
    def actors(self) -> tuple[Actor, ...]:
        """The actors that are in no world."""
        return tuple(self._parts("actor"))

    @property
    def read_as(self) -> Version:
        """The version of the format as which it is read: the newest where none or an unknown one is declared."""
        return self._survey.version

    @lazy
    def includes(self) -> tuple[Include, ...]:
        """The includes that libsdformat follows, misplaced ones as well."""
        if self.is_urdf or "<include" not in self.document.source.text:
            return ()
        from sdfcheck.robot.includes.included import includes_of

        return tuple(self.made_of(includes_of(self.document), "Include"))

    @lazy
    def resources(self) -> tuple[Resource, ...]:
        """The meshes, textures, scripts and sounds that it names."""
        from sdfcheck.robot.parts.files import resources_of

        return resources_of(self)

    @lazy
    def scopes(self) -> tuple[Scope, ...]:
        """The worlds and models at the top of the file, in its order."""
        if self.is_urdf:
            return (cast("Scope", self.part(self.element)),)
        return tuple(
            cast("Scope", self.part(top)) for top in self.children() if top.name in {"world", "model"}
        )

    def all_scopes(self) -> Iterator[Scope]:
        """Every world and model that the file itself writes, in the order of the file."""
        waiting = list(reversed(self.scopes))
        while waiting:
            scope = waiting.pop()
            yield scope
            inner = (self.part_of(child) for child in scope.element.children("model"))
            waiting += reversed([model for model in inner if isinstance(model, Scope)])

    def scope_of(self, element: Element) -> Scope | None:
        """The innermost world or model that an element is in."""
        parent = element.parent
        part = None if parent is None else self.part_of(parent)
        while part is not None and not isinstance(part, Scope):
            if part.kind == "gazebo":
                return cast("GazeboBlock", part).scope
            part = part.holder
        return part

    def part_of(self, element: Element) -> Part:
        """The part that an element of this file makes."""
        found = self.registry.get(element)
        if element is self.element:
            return self
        if found is None:
            parent = element.parent
            assert parent is not None, "the root element is known"
            holder = self.part_of(parent)
            if holder is self and self.is_urdf:
                holder = self.scopes[0]
            found = holder.part(element)
        return found

    @overload
    def each(self, kind: type[P]) -> Sequence[P]: ...
    @overload
    def each(self, kind: str) -> Sequence[Any]: ...
    def each(self, kind: type[Part] | str) -> Sequence[Any]:
        """The parts of a class that the file itself writes, in the order of the file."""
        name = kind if isinstance(kind, str) else kind.__name__
        found = self._each.get(name)
        if found is None:
            found = self._each[name] = tuple(SPECIAL[name](self) if name in SPECIAL else self._written(name))
        return found

    def _written(self, name: str) -> Iterator[Any]:
        index = self.elements
        elements = [element for tag in ELEMENTS.get(name, ()) for element in index.get(tag, ())]
        return self.made_of(elements, name) if elements else iter(())

    def made_of(self, elements: Iterable[Element], kind: str) -> Iterator[Any]:
        """The parts of a class that elements of this file make; that of ``robot`` is its model."""
        cls = class_named(kind)
        part_of = self.part_of
        for element in elements:
            part = part_of(element)
            if part is self and self.is_urdf and kind != "Root":
                part = self.scopes[0]
            if isinstance(part, cls):
                yield part

    @property
    def known_versions(self) -> tuple[str, ...]:
        """The versions of the format that consumers know, the oldest first."""
        return URDF_VERSIONS if self.is_urdf else tuple(map(str, VERSIONS))

    def is_older_than(self, version: str) -> bool:
        """Does it declare a version of SDFormat before this one?"""
        return not self.is_urdf and self._survey.version < (Version.parse(version) or NEWEST)

    @lazy
    def names(self) -> Names:
        """The names that the file gives."""
        from sdfcheck.robot.naming.names import Names

        return Names(self)

    @lazy
    def frame_references(self) -> tuple[FrameReference, ...]:
        """The references to frames that the file writes, resolved or not."""
        if self.is_urdf and not self.elements.get("gazebo"):
            return ()
        from sdfcheck.robot.naming.frames import frame_references

        return tuple(frame_references(self))

    @lazy
    def rings(self) -> tuple[Ring, ...]:
        """The frames that are attached to, or placed relative to, each other in a ring."""
        if not self.frame_references:
            return ()
        from sdfcheck.robot.naming.frames import rings

        return rings(self)

    @lazy
    def parent_joints(self) -> dict[Link, list[Joint]]:
        """Link → the joints of this file that carry it, wherever they are; without those that only Gazebo adds."""
        if not (joints := [joint for joint in self.each("Joint") if joint.holder.kind != "gazebo"]):
            return {}
        from sdfcheck.robot.motion.tree import parents_in

        return parents_in(joints)

    @lazy
    def loops(self) -> list[list[Joint]]:
        """The joints of this file that lead round in a circle, whichever world or model they are in."""
        if not self.parent_joints:
            return []
        from sdfcheck.robot.motion.tree import loops

        return loops(self.parent_joints, self.each("Joint"))

    def outermost(self, node: Node) -> Node:
        """The world around a node, or the substitute of a file without a world."""
        at: Part | None = node
        while at is not None:
            if isinstance(at, Scope) and at.kind == "world":
                return at
            at = at.holder
        return self.outside

    @lazy
    def outside(self) -> Node:
        """The substitute for the world in a file without a world."""
        return ImplicitWorld(self, self.element, WORLD_FRAME)

    @lazy
    def poses(self) -> Poses:
        """The poses of all nodes, each worked out once."""
        from sdfcheck.robot.motion.poses import Poses

        return Poses()

    @property
    def document(self) -> Document:
        return self._document

    @lazy
    def elements(self) -> Mapping[str, list[Element]]:
        """The standard elements by name, those in ``<gazebo>`` blocks as well."""
        if self.is_urdf:
            from sdfcheck.formats.urdf.survey import survey as urdf_survey

            index = urdf_survey(self.document).index
            if not index.get("gazebo"):
                return index
            from sdfcheck.robot.parts.gazebo import with_extensions

            return with_extensions(index)
        return self._survey.index

    @property
    def _survey(self) -> Survey:
        return survey(self.document)

    @property
    def named(self) -> Mapping[Element, list[tuple[str, str, Element]]]:
        """Element of SDFormat → its children that have a name: kind, name and element."""
        return self._survey.named

    @property
    def mass_properties(self) -> MassProperties | None:
        """Mass (kg), center of mass (m) and inertia (kg·m²) of everything that is not static, all joints at zero.

        In the frame of the world, or of the only model; None without mass. Raises DescriptionError.
        """
        from sdfcheck.robot.motion.mass_report import mass_report

        return mass_report(self).total

    # Parts by name

    def world(self, key: str | int) -> World:
        """A world by name or index; raises NotFound."""
        return pick(self, "world", self.worlds, key)

    def model(self, key: str | int) -> Model:
        """A model that is in no world, by name or index; raises NotFound."""
        return pick(self, "model", self.models, key)


def root_of(document: Document) -> Root:
    """The root of a document of SDFormat or URDF, read once."""
    return document.view(Root)
