"""Parts, everything that a description is made of, and the nodes among them, which references name."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import islice
from typing import TYPE_CHECKING, Any, ClassVar, TypeVar, cast, overload

from sdfcheck.formats.schema import AttributeDefinition, Definition
from sdfcheck.formats.sdf.schema import schema
from sdfcheck.formats.sdf.survey import notes, version_of
from sdfcheck.formats.version import NEWEST, Version
from sdfcheck.robot.naming.name import MODEL_FRAME, NODES, WORLD_FRAME
from sdfcheck.robot.values import Flag, Number, Text, Vector, grouped, is_true, lazy, reference_of
from sdfcheck.source.document import Comment
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind

if TYPE_CHECKING:
    from sdfcheck.formats.topology import Displaced
    from sdfcheck.robot.includes.included import Included
    from sdfcheck.robot.motion.poses import Pose, Poses
    from sdfcheck.source.document import Document, Element, Value
    from sdfcheck.source.text import Span


# Parts by name or number.


P = TypeVar("P", bound="Part")


class NotFound(LookupError):
    """There is no part of that name or number."""


def pick(owner: Part, kind: str, parts: Sequence[P], key: str | int) -> P:
    """The part of a name (``outer::inner`` reaches into models) or number; raises NotFound."""
    where = f"{type(owner).__name__.lower()} `{owner.name}`" if owner.holder is not None else "the file"
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
        model = next((model for model in getattr(owner, "models", ()) if model.name == outer), None)
        if model is not None:
            return getattr(model, kind)(inner)  # type: ignore[no-any-return]
    from sdfcheck.formats.near_names import did_you_mean

    near = did_you_mean(key, (part.name for part in parts))
    raise NotFound(f"{where} has no {kind} `{key}`{near}")


# Values with the defaults that the formats give them.


_NUMBERS = frozenset(("double", "float", "int", "unsigned int"))
_VECTORS = frozenset(("vector3", "vector2d", "vector2i", "color", "pose", "quaternion", "angle", "time"))


def setting(part: Part, name: str) -> Number | Vector | Flag | Text:
    """A value of a part, or its default; raises NotFound where the format has none of that name."""
    if part.is_urdf:
        value = part.value(name)
        if value is None:
            raise NotFound(f"{part.title} has no `{name}`")
        return _typed(value, part.element, "double" if value.number == value.number else "string", "")
    definition: Definition | AttributeDefinition | None = _definition(part.element)
    if not part.is_given and isinstance(definition, Definition):
        definition = definition.children.get(part.kind)
    element: Element | None = part.element if part.is_given else None
    *path, last = name.split("/")
    for step in path:
        definition = definition.children.get(step) if isinstance(definition, Definition) else None
        element = None if element is None else element.find(step)
    place = definition
    if isinstance(place, Definition):
        definition = place.attributes.get(last) or place.children.get(last)
    if definition is None or definition is place or definition.type is None:
        raise NotFound(f"the format has no value `{name}` in {part.title}")
    value = None
    if element is not None:
        child = None if isinstance(definition, AttributeDefinition) else element.find(last)
        value = element.attribute(last) if child is None else child.own_value
    return _typed(
        value, part.element if element is None else element, definition.type, definition.default or ""
    )


def _definition(element: Element) -> Definition | None:
    """The definition of an element in the document's version."""
    names: list[str] = []
    at: Element = element
    while (parent := at.parent) is not None and parent.name != "gazebo":
        names.insert(0, at.name)
        at = parent
    definition: Definition | None = schema(version_of(element.document)).root
    if at.name != "sdf":  # in a <gazebo> block of URDF
        names.insert(0, at.name)
        definition = schema(version_of(element.document)).at(f"{names[0]}:{names[0]}")
        names = names[1:]
    for name in names:
        definition = definition.children.get(name) if definition is not None else None
    return definition


def _typed(value: Value | None, element: Element, kind: str, default: str) -> Number | Vector | Flag | Text:
    if kind in _NUMBERS:
        return Number.of(value, element, _number(default))
    if kind in _VECTORS:
        return Vector.of(value, element, map(_number, default.split()))
    if kind == "bool":
        return Flag.of(value, element, is_true(default))
    return Text.of(value, element, default)


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        return math.nan


# Parts: everything that a description is made of.
#
# A part is an element with a meaning: a link, a joint, a sensor. Parts are made when they
# are asked for, each once, and never change the document. Where the format takes a part
# for granted that is not written, the part exists with its defaults and ``is_given`` is
# False.


T = TypeVar("T", str, int, float, bool)

Registry = dict["Element", "Part"]
"""The parts that elements have become, of one reading of a file: two includes of it make two readings."""


class Part:
    """One part of a description.

    ``holder`` is the part that it is in (None for the root); ``is_urdf`` says which
    format it is written in: what ``<gazebo>`` holds in a URDF file is SDFormat.
    """

    kind: ClassVar[str] = ""
    """The name of its element in SDFormat."""
    is_scope: ClassVar[bool] = False
    """Is it a model or world?"""
    is_custom: ClassVar[bool] = False
    """Is it data with a prefix?"""

    holder: Part | None
    root: Whole
    registry: Registry
    is_urdf: bool
    is_given: bool
    """Is it written in the text? Values that are not written have their defaults."""

    __slots__ = ("__dict__", "__weakref__", "element", "holder", "is_given", "is_urdf", "registry", "root")

    def __init__(self, holder: Part, element: Element | None) -> None:
        self.holder = holder
        self.root = holder.root
        self.registry = holder.registry
        self.is_urdf = holder.is_urdf
        self.is_given = element is not None
        self.element: Element = holder.element if element is None else element

    def __repr__(self) -> str:
        name = self.name
        return f"{type(self).__name__}({name!r})" if name else f"{type(self).__name__}()"

    # Identity

    @property
    def name(self) -> str:
        """Its name, without spaces around it; empty where it has none."""
        return (self._text("name") or "").strip()

    @property
    def name_value(self) -> Value | None:
        """Its name with the place of the text."""
        return self.element.attribute("name") if self.is_given else None

    @property
    def title(self) -> str:
        """Its name in a sentence: ``joint `elbow```."""
        return self.element.title

    @property
    def document(self) -> Document:
        """The file that it is written in; for what an include brings, the included file."""
        return self.element.document

    @property
    def span(self) -> Span:
        """The place of its name in the start tag."""
        return self.element.span

    def within(self, cls: type[P]) -> P | None:
        """The innermost part of a class that it is in: ``visual.within(Link)``."""
        at = self.holder
        while at is not None and not isinstance(at, cls):
            at = at.holder
        return at

    @property
    def scope_around(self) -> Namespace | None:
        """The model or world that it is directly in."""
        return cast("Namespace", self.holder) if self.holder is not None and self.holder.is_scope else None

    # Written values

    def value(self, name: str) -> Value | None:
        """The text of an attribute, else of a child element, with its place; None if there is neither."""
        return self.element.value(name) if self.is_given else None

    def attribute(self, name: str) -> Value | None:
        """The attribute of that name, prefix included: ``attribute("flatland:type")``."""
        return self.element.attribute(name) if self.is_given else None

    def has(self, name: str) -> bool:
        """Is there a child element of that name, prefix included?"""
        return self.is_given and self.element.has(name)

    @property
    def is_extension(self) -> bool:
        """Is it in a ``<gazebo>`` block of a URDF file, so that only Gazebo reads it?"""
        return self.root.is_urdf and not self.is_urdf

    def misnamed(self, name: str) -> Span | None:
        """The place of a child or attribute for whose misspelling it lacks one of that name."""
        if not self.is_given:
            return None
        if self.is_urdf:
            from sdfcheck.formats.urdf.schema import has_known_names

            if has_known_names(self.element):
                return None
            from sdfcheck.formats.urdf.findings import misnamed

            return misnamed(self.element, name)
        return notes(self.document).misspelled.get((self.element, name))

    def switches_off(self, name: str) -> bool:
        """Is a child of that name in a comment?"""
        nodes = self.element.nodes if self.is_given else ()
        return any(isinstance(node, Comment) and f"<{name}" in f"<{node.text}" for node in nodes)

    def find(self, name: str) -> Element | None:
        """The first child element of that name, prefix included."""
        return self.element.find(name) if self.is_given else None

    def children(self, name: str | None = None) -> Iterator[Element]:
        """The child elements, or those of one name."""
        return self.element.children(name) if self.is_given else iter(())

    def all_elements(self) -> Iterator[Element]:
        """All elements in it, those of plugins as well, in the order of the file."""
        return self.element.below if self.is_given else iter(())

    def lacks(self, name: str) -> bool:
        """Is there neither an attribute nor a child element of a name, not even a misspelled one?"""
        if self.value(name) is not None or self.misnamed(name):
            return False
        if not self.is_unfinished:
            return True
        from sdfcheck.formats.urdf.schema import definition
        from sdfcheck.xacro.static.macro_survey import may_get

        return not may_get(self.element, name, definition(self.element))

    @property
    def is_unfinished(self) -> bool:
        """Is it in a file for xacro, or in what xacro has made of one in part, and xacro will put something into it?"""
        if not self.is_given or not (self.document.kind is Kind.XACRO or self.document.is_expanded):
            return False
        from sdfcheck.xacro.static.macro_survey import is_unfinished

        return is_unfinished(self.element)

    def nearest(self, name: str, candidates: Iterable[str]) -> str | None:
        """The candidate that a misspelled name was probably meant to be; None if none is near.

        A document full of unknown names is not guessed at without end.
        """
        from sdfcheck.formats.near_names import nearest

        return nearest(name, candidates, self.document)

    @overload
    def get(self, name: str) -> str | None: ...
    @overload
    def get(self, name: str, type: type[T]) -> T | None: ...
    @overload
    def get(self, name: str, type: type[Vector]) -> Vector | None: ...
    @overload
    def get(self, name: str, type: type[Pose]) -> Pose | None: ...
    def get(self, name: str, type: Any = str) -> Any:
        """The value of an attribute, else of a child element: str, int, float, bool, Vector or Pose.

        ``name`` is as written, prefix included; ``camera/image/width`` leads to what is deeper.
        None if it is not there; ValueError, with the place, if it is not of the type.
        """
        *path, last = name.split("/")
        at: Element | None = self.element if self.is_given else None
        for step in path:
            at = None if at is None else at.find(step)
        if at is None:
            return None
        if type not in {str, int, float, bool, Vector}:
            return type.written(at, last)
        if type is not Vector:
            return at.get(last, type)
        value = at.value(last)
        if value is None:
            return None
        numbers = Vector.of(value, at, ())
        if value.text.strip() and not numbers:
            value.to(float)
        return numbers

    def setting(self, name: str) -> Number | Vector | Flag | Text:
        """A value of the standard, with the default of the format where it is not written.

        ``name`` is that of an attribute or a child element, ``camera/image/width`` that of what
        is deeper. Raises NotFound where the format has no such value here.
        """
        return setting(self, name)

    @property
    def custom(self) -> dict[str, Custom]:
        """Prefixed attributes and elements by their names, the first of each."""
        found: dict[str, Custom] = {}
        if not self.is_given:
            return found
        for name in self.element.attributes:
            if ":" in name and not name.startswith("xml:"):
                found[name] = Custom(self, self.element, self.element.attribute(name))
        for child in self.children():
            if child.is_custom and (part := self.part(child)).is_custom:
                found.setdefault(child.name, cast("Custom", part))
        return found

    def release(self) -> None:
        """Drop all parts of the reading, which refer to one another; its document is not needed any more."""
        for part in (self, *self.registry.values()):
            part.__dict__.clear()
        self.registry.clear()
        del self.root

    @property
    def written_position(self) -> tuple[float, float, float] | None:
        """The position that its ``pose`` or ``origin`` writes; None if that alone does not say it."""
        if self.is_urdf:
            origin = self.find("origin")
            return _three(origin.text_of("xyz", "0 0 0") if origin is not None else "0 0 0")
        pose = self.find("pose")
        if pose is None or not pose.content:
            return 0.0, 0.0, 0.0
        if pose.text_of("relative_to", "").strip() or len(pose.content.split()) < 6:
            return None
        return _three(pose.content)

    # For the parts themselves

    def part(self, element: Element) -> Part:
        """The part that a child element makes, each time the same."""
        found = self.registry.get(element)
        if found is None:
            found = self.registry[element] = self.root.class_of(self, element)(self, element)
        return found

    def _parts(self, name: str) -> Iterator[Any]:
        """The parts that the child elements of a name make."""
        return (self.part(child) for child in self.children(name))

    def _only(self, name: str, cls: type[P]) -> P:
        """The part of the first child element of a name; one with defaults if there is none."""
        child = self.find(name)
        if child is not None:
            found = self.part(child)
            if isinstance(found, cls):
                return found
        return cls(self, child)

    def _text(self, name: str) -> str | None:
        """The text of an attribute."""
        return self.element.text_of(name) if self.is_given else None

    def _number(self, name: str, default: float) -> Number:
        """A number: in SDFormat a child element, in URDF an attribute."""
        return Number.of(self._setting(name), self.element, default)

    def _vector(self, name: str, default: tuple[float, ...]) -> Vector:
        return Vector.of(self._setting(name), self.element, default)

    def _setting(self, name: str) -> Value | None:
        if not self.is_given:
            return None
        if self.is_urdf:
            return self.element.attribute(name)
        child = self.element.find(name)
        return None if child is None else child.own_value


def _three(text: str) -> tuple[float, float, float] | None:
    try:
        x, y, z = (float(word) for word in text.split()[:3])
    except ValueError:
        return None
    return x, y, z


# The whole that parts are of.


def _is_of_python(document: Document) -> bool:
    from sdfcheck.files.packages import is_of_python

    return is_of_python(document.path)


def beside_of(element: Element) -> object:
    """The parent of an element, or the name that its block of URDF is about; the same for all that are beside it."""
    parent = element.parent
    return (
        parent.attributes.get("reference", "") if parent is not None and parent.name == "gazebo" else parent
    )


class Whole(Part):
    """One reading of a file: what the parts in it ask of it. The rest is in its :class:`sdfcheck.robot.root.Root`."""

    __slots__ = ("_document", "included")

    def __init__(self, document: Document) -> None:
        element = document.root
        assert element is not None, "a document without elements says nothing"
        self._document = document
        self.holder = None
        self.root = self
        self.element = element
        self.registry = {}
        self._each: dict[str, tuple[Any, ...]] = {}
        self.is_given = True
        self.is_urdf = element.name == "robot"
        self.included = 0  # included models that were looked into

    def __repr__(self) -> str:
        return f"{type(self).__name__}({str(self.document.path)!r})"

    @property
    def document(self) -> Document:
        return self._document

    @property
    def is_of_python(self) -> bool:
        """Is it in a project of Python, and in no package of ROS?"""
        return self.document.view(_is_of_python)

    @lazy
    def plugins_beside(self) -> dict[object, list[Element]]:
        """Its plugins by what they are in, and those of blocks of URDF by what these are about."""
        return grouped(self.elements.get("plugin", ()), beside_of)

    @lazy
    def unresolved_frames(self) -> dict[object, list[Value]]:
        """World or model → the references to frames in it that lead nowhere, in the order of the file."""
        lost = [each for each in self.each("FrameReference") if each.is_unresolved]
        found: dict[object, list[Value]] = {}
        for reference in sorted(lost, key=lambda each: cast("int", each.span.start)):
            found.setdefault(reference.scope, []).append(reference.value)
        return found

    def class_of(self, holder: Part, element: Element) -> type[Part]:
        """The class of the part that an element in a part makes."""
        raise NotImplementedError

    def _listed(self, kind: str) -> Iterable[Any]:
        raise NotImplementedError

    @property
    def elements(self) -> Mapping[str, list[Element]]:
        """The standard elements by name, those in ``<gazebo>`` blocks as well."""
        raise NotImplementedError

    @overload
    def each(self, kind: type[P]) -> Sequence[P]: ...
    @overload
    def each(self, kind: str) -> Sequence[Any]: ...
    def each(self, kind: type[Part] | str) -> Sequence[Any]:
        """The parts of a class that the file itself writes, in the order of the file."""
        name = kind if isinstance(kind, str) else kind.__name__
        found = self._each.get(name)
        if found is None:
            found = self._each[name] = tuple(self._listed(name))
        return found

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
                holder = self.part(self.element)
            found = holder.part(element)
        return found

    @property
    def named(self) -> Mapping[Element, list[tuple[str, str, Element]]]:
        """Element of SDFormat → its children that have a name: kind, name and element."""
        return notes(self.document).named

    def is_older_than(self, version: str) -> bool:
        """Does it declare a version of SDFormat before this one?"""
        return not self.is_urdf and version_of(self.document) < (Version.parse(version) or NEWEST)

    # Nodes

    def scope_of(self, element: Element) -> Namespace | None:
        """The innermost world or model that an element is in."""
        parent = element.parent
        part = None if parent is None else self.part_of(parent)
        while part is not None and not isinstance(part, Namespace):
            if part.kind == "gazebo":
                return cast("Node", part).scope
            part = part.holder
        return part

    def outermost(self, node: Node) -> Node:
        """The world around a node, or the substitute of a file without a world."""
        at: Part | None = node
        while at is not None:
            if isinstance(at, Namespace) and at.kind == "world":
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


# Custom data: prefixed attributes and elements, of which the format says only where they may be.


class Custom(Part):
    """A prefixed element (``flatland:gear``), or a prefixed attribute.

    Source: the custom-elements proposal of SDFormat 1.7.
    """

    __slots__ = ("own_value",)
    is_custom = True

    def __init__(self, holder: Part, element: Element | None, attribute: Value | None = None) -> None:
        super().__init__(holder, element)
        self.own_value: Value | None = attribute
        """Its text with its place."""
        if attribute is None and element is not None:
            self.own_value = element.own_value

    @property
    def is_attribute(self) -> bool:
        return self.own_value is not None and self.own_value.attribute is not None

    @property
    def tag(self) -> str:
        """Its name as written, prefix included."""
        value = self.own_value
        return value.attribute if value is not None and value.attribute else self.element.name

    @property
    def prefix(self) -> str:
        return self.tag.partition(":")[0]

    @property
    def displaced(self) -> tuple[Displaced, ...]:
        """The standard elements in it that could be beside it, where simulators look for them."""
        if self.is_attribute:
            return ()
        if self.is_urdf:
            from sdfcheck.formats.urdf.survey import survey as urdf_survey

            return urdf_survey(self.document).displaced.get(self.element, ())
        return notes(self.document).displaced.get(self.element, ())

    @property
    def replaced(self) -> tuple[str, ...]:
        """The names of required elements that are absent beside it, and that it seems to replace."""
        return () if self.is_attribute else tuple(notes(self.document).replaced.get(self.element, ()))

    @property
    def text(self) -> str:
        """Its text, or the value of the attribute."""
        return self.own_value.text if self.own_value is not None else ""


# Settings: elements that have a meaning of their own in no other class.


class Setting(Part):
    """An element of the format that is read by its name: ``camera``, ``ode``, ``noise`` …"""

    __slots__ = ()
    kind = "setting"

    @property
    def settings(self) -> tuple[Part, ...]:
        """The parts that its child elements make."""
        return tuple(self.part(child) for child in self.children())


# Placements: ``pose`` in SDFormat, ``origin`` in URDF.


class Placement(Part):
    """A ``pose`` of SDFormat or an ``origin`` of URDF, as it is written."""

    __slots__ = ()
    kind = "pose"

    @property
    def numbers(self) -> Vector:
        """Of a pose: position (m) and rotation, in one row; empty where it cannot be read."""
        return Vector.of(None if self.is_urdf else self.element.own_value, self.element, (0.0,) * 6)

    @property
    def xyz(self) -> Vector:
        """The position (m)."""
        if self.is_urdf:
            return Vector.of(self.attribute("xyz"), self.element, (0.0, 0.0, 0.0))
        return self._part(slice(0, 3))

    @property
    def rotation(self) -> Vector:
        """Roll, pitch, yaw (rad or degrees), or the quaternion x, y, z, w."""
        if not self.is_urdf:
            return self._part(slice(3, None))
        quaternion = self.attribute("quat_xyzw")
        return Vector.of(quaternion or self.attribute("rpy"), self.element, (0.0, 0.0, 0.0))

    @property
    def is_quaternion(self) -> bool:
        if self.is_urdf:
            return self.attribute("quat_xyzw") is not None
        return (self._text("rotation_format") or "").strip() == "quat_xyzw"

    @property
    def reference(self) -> str:
        """The frame that it is relative to, as written; empty for the default."""
        return "" if self.is_urdf else reference_of(self.element)

    def _part(self, part: slice) -> Vector:
        numbers = self.numbers
        found = Vector(tuple(numbers)[part])
        found.value, found.element = numbers.value, numbers.element
        return found


# Nodes: what poses can be relative to, and what references name.
#
# Links, joints, frames and models are nodes of the model or world that they are in, and
# worlds are nodes, too. A frame moves with what it is attached to, a joint with its child,
# a model with its canonical link. A static model moves with nothing, and is a place of its
# own. Source: libsdformat 17's FrameSemantics.cc and parser.cc, checked against what they do.


class Node(Part):
    """A named place: a link, joint, frame, model or world."""

    __slots__ = ("_name", "merged")

    def __init__(self, holder: Part, element: Element | None, name: str | None = None) -> None:
        super().__init__(holder, element)
        self._name = name
        self.merged: MergedFrame | None = None
        """The frame of the model that brought it here, if an include was merged."""

    @property
    def name(self) -> str:
        """The name by which it goes in its model or world."""
        if self._name is None:
            name = self._text("name") or ""
            self._name = name if self.is_urdf else name.strip()
        return self._name

    @property
    def place(self) -> Element:
        """The element of the enclosing file that brings it: its own, or that of the include."""
        return self.element

    @property
    def scope(self) -> Namespace:
        """The model or world in which its name is known."""
        if self.holder is not None and self.holder.kind == "gazebo":
            return cast("Node", self.holder).scope
        return cast("Namespace", self.holder)

    @property
    def scoped_name(self) -> str:
        """Its name from the top of the file: ``robot::arm::hand``."""
        scope: Part | None = self.holder
        outer = scope.scoped_name if isinstance(scope, Node) and scope.kind == "model" else ""
        return f"{outer}::{self.name}" if outer else self.name

    @property
    def unmerged(self) -> Node:
        """It as it is by itself, where an include merged it into another model."""
        return self

    # Motion

    @property
    def attachment(self) -> Node | None:
        """The next node on the way to the link that carries it; None if there is none."""
        return None

    @lazy
    def carrier(self) -> Node | None:
        """The node that it moves with: a link, the world, or a static model; None if that is unknown."""
        seen: set[Node] = set()
        at: Node | None = self
        while at is not None and at not in seen:
            seen.add(at)
            if at.kind in {"link", "world"} or at.stands_still:
                return at
            at = at.attachment
        return None

    @property
    def stands_still(self) -> bool:
        """Is it a model that is itself static? One in a static model need not be."""
        return False

    # Where it is

    @property
    def pose_element(self) -> Element | None:
        """The ``pose`` that counts for it."""
        return self.find("pose")

    @property
    def written_base(self) -> str:
        """The name that its pose is written relative to; empty where there is none."""
        return reference_of(self.pose_element)

    @property
    def base_name(self) -> str:
        """The name of what its pose is relative to; empty where that is the model or world it is in."""
        return self.written_base

    @property
    def urdf_base(self) -> tuple[Node | None, Element | None]:
        """In URDF: the node that it is placed at, and the joint whose origin leads from there to it."""
        return self.merged or self.scope, None

    @property
    def placement_frame(self) -> str:
        """The name of the frame of a model that its pose places; empty: its own frame."""
        return ""

    @property
    def base(self) -> Node | None:
        """The node that its pose is relative to; None where a reference is not resolved."""
        name = self.base_name
        return self.look_up(name) if name else (self.merged or self.scope)

    def look_up(self, reference: str) -> Node | None:
        """The node that a reference written in this part names."""
        if reference == MODEL_FRAME and self.merged is not None:
            return self.merged
        around: Part | None = self.holder
        if around is not None and around.kind == "gazebo":
            return self.scope.resolve(reference)
        return None if self.scope_around is None else self.scope_around.resolve(reference)

    def pose(self, relative_to: str | Node | None = None) -> Pose:
        """Where it is with all joints at zero.

        ``relative_to`` names a frame as a reference in this model would, is a node, or
        ``"world"`` for the outermost model or world; by default the model or world that
        it is in. Lengths in m, angles in rad.

        Raises PoseError where a reference leads nowhere or a number cannot be read.
        """
        return self.root.poses.of_node(self, "world" if relative_to is self.root.outside else relative_to)


class ImplicitWorld(Node):
    """The world around a model that is alone in its file."""

    __slots__ = ()
    kind = "world"


# Frames: named places that are attached to something.


class Frame(Node):
    """A ``frame``, or Drake's ``drake:frame`` in URDF."""

    __slots__ = ()
    kind = "frame"

    @property
    def attached_to_value(self) -> Value | None:
        """The reference to what it is attached to, with its place; None if nothing is written."""
        value = self.attribute("link" if self.is_urdf else "attached_to")
        return value if value is not None and value.text.strip() else None

    @property
    def attached_to(self) -> Node | None:
        """The node that it is attached to, by default its holder; None if the name is unknown."""
        return self.attachment

    @property
    def attachment(self) -> Node | None:
        value = self.attached_to_value
        return self.look_up(value.text.strip()) if value is not None else (self.merged or self.scope)

    @property
    def base_name(self) -> str:
        value = self.attached_to_value
        return self.written_base or (value.text.strip() if value is not None else "")


class MergedFrame(Frame):
    """The frame that represents a model which an include merged into another."""

    __slots__ = ("model",)

    def __init__(self, holder: Part, element: Element, model: Namespace) -> None:
        super().__init__(holder, element, f"_merged__{model.name}__model__")
        self.model = model

    @lazy
    def unmerged(self) -> Namespace:
        """The model as it is by itself, not merged."""
        from sdfcheck.robot.includes.included import included

        model = cast("Namespace", self.model.holder).brought_by(included(self.document, self.element))
        return self.model if model is None else model

    @property
    def attached_to_value(self) -> Value | None:
        return None

    @lazy
    def attachment(self) -> Node | None:
        """The canonical link of the model, which may itself have come by a merge."""
        node = self.unmerged.attachment
        return None if node is None else self.scope.resolve(node.name)

    @property
    def pose_element(self) -> Element | None:
        return self.model.pose_element

    @property
    def base_name(self) -> str:
        return self.written_base


# The name that was probably meant by one that is not defined.


class Guess(NamedTuple):
    """``meant``: a near miss, or the scoped name of what exists in a nested model.

    ``outside``: what an enclosing world or model has by that name, where no reference from
    here can reach it.
    """

    meant: str | None = None
    outside: Element | None = None


class _Reachable:
    """The names that each scope of a document can use, by their last parts."""

    __slots__ = ("_by_scope",)

    def __init__(self, document: Document) -> None:
        self._by_scope: dict[Namespace, dict[str, list[str]]] = {}

    def names(self, scope: Namespace) -> dict[str, list[str]]:
        if scope not in self._by_scope:
            reachable: defaultdict[str, list[str]] = defaultdict(list)
            for name in scope.names():
                reachable[_last(name)].append(name)
            self._by_scope[scope] = reachable
        return self._by_scope[scope]


def guess(scope: Namespace, name: str, but: tuple[str, ...] = (), kind: str = "") -> Guess:
    """The intended name of a reference in a scope: none of ``but``, and of ``kind`` if one is given."""

    def fits(candidate: str) -> bool:
        if candidate in but:
            return False
        return not kind or ((node := scope.resolve(candidate)) is not None and node.kind == kind)

    document = scope.root.document
    reachable = document.view(_Reachable).names(scope)
    deeper = [n for n in reachable.get(_last(name), ()) if n.endswith(f"::{name}") and fits(n)]
    if len(deeper) == 1:
        return Guess(deeper[0])
    if (outside := _outside(scope, name)) is not None:
        return Guess(None, outside.place)
    from sdfcheck.formats.near_names import nearest

    candidates = (n for names in reachable.values() for n in names if fits(n))
    return Guess(nearest(name, candidates, document))


def _last(name: str) -> str:
    return name.rpartition("::")[2]


def _outside(scope: Namespace, name: str) -> Node | None:
    at = scope.scope_around
    while at is not None:
        if (found := at.resolve(name)) is not None:
            return found
        at = at.scope_around
    return None


# Scopes: worlds and models, the nodes that they name, and how references find them.
#
# A model is a scope of its links, joints, frames and nested models, a world of its models,
# joints and frames. ``A::B::name`` reaches down into nested models; nothing reaches up.
# Source: the specification's notes on naming (1.8) and libsdformat 17's FrameSemantics.cc,
# checked against what it does.


N = TypeVar("N", bound=Node)

NEVER_A_REFERENCE = "__root__"

_SEVEN = Version(1, 7)
_LOADED = ("model", "link", "joint", "frame")
"""The order in which libsdformat takes them in."""

_MOST_NAMES = 20_000

Child = tuple[str, str, "Element"]
"""Kind, name and element."""


class Namespace(Node):
    """A model or a world, as far as names go: what each names, and what an include brings.

    ``is_complete`` is False where an include could not be read, so that an unknown name
    proves nothing.
    """

    __slots__ = ("_unread", "chain", "is_readable", "merged_frame")

    is_scope = True
    own_name = MODEL_FRAME
    """The name of the scope's own frame, as references in it write it."""

    def __init__(self, holder: Part, element: Element | None, name: str | None = None) -> None:
        super().__init__(holder, element, name)
        self._unread = False
        self.is_readable = True  # its content could be read
        outer = holder if isinstance(holder, Namespace) else None
        self.chain: tuple[Document, ...] = outer.chain if outer else (self.document,)
        """The files that are being read, from the outside in."""
        self.merged_frame: MergedFrame | None = None
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
        return model.resolve(rest) if isinstance(model, Namespace) else None

    def may_hold(self, reference: str) -> bool:
        """Might it name something in a file that could not be read?"""
        head, delimiter, rest = reference.partition("::")
        if delimiter and head == self.name and rest in self.nodes:
            return False  # its own name, which is not known in it
        if not self.is_complete:
            return True
        model = self.nodes.get(head) if delimiter else None
        return isinstance(model, Namespace) and model.may_hold(rest)

    def lacks(self, reference: str) -> bool:
        """Does a reference surely name nothing here? Not known where a part of it is empty."""
        if self.resolve(reference) is not None or "" in reference.split("::"):
            return False
        return not self.may_hold(reference)

    def guess(self, reference: str, but: tuple[str, ...] = (), kind: str = "") -> Guess:
        """The intended name of a reference that is not resolved here: none of ``but``, and of ``kind``."""
        return guess(self, reference, but, kind)

    def names(self) -> Iterator[str]:
        """The names that a reference here can use, scoped ones included; not all of very many."""
        return islice(self._names(), _MOST_NAMES)

    def _names(self) -> Iterator[str]:
        for name, node in self.nodes.items():
            yield name
            if isinstance(node, Namespace):
                yield from (f"{name}::{deeper}" for deeper in node._names())

    def all_nodes(self, prefix: str = "") -> Iterator[tuple[str, Node]]:
        """All nodes in it and in its models, with their names from here."""
        for name, node in self.nodes.items():
            yield prefix + name, node
            if isinstance(node, Namespace):
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

    def brought_by(self, found: Included) -> Namespace | None:
        """The model that an include in it brings; without content where the file cannot be read or leads in a ring.

        None where not even its name is known.
        """
        raise NotImplementedError

    # Filling

    def _fill(self, nodes: dict[str, Node]) -> None:
        self._take_from(self, nodes)

    def _take_from(self, source: Namespace, nodes: dict[str, Node]) -> None:
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

        if "include" in source.document.names:
            from sdfcheck.robot.includes.included import included

            for include in source.element.children("include"):
                self._include(source, nodes, included(source.document, include))

    def _take(self, source: Namespace, nodes: dict[str, Node], name: str, element: Element) -> None:
        part = source.part(element)
        if isinstance(part, Node):
            part._name = name
            if source is not self:
                part.holder, part.merged = self, source.merged_frame
            nodes.setdefault(name, part)

    def _include(self, source: Namespace, nodes: dict[str, Node], found: Included) -> None:
        """Bring in an included model: as a nested one, or its parts where it is merged."""
        if found.kind not in {"model", None}:
            return  # lights and actors make no frames

        model = source.brought_by(found)
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

        model.merged_frame = MergedFrame(self, found.include, model)
        self._take_from(model, nodes)
        self._unread = self._unread or model._unread
        if found.name:
            nodes.setdefault(model.merged_frame.name, model.merged_frame)


def _named_children(source: Namespace) -> Iterable[Child]:
    """The named parts of a world or model."""
    children: Iterable[Child] = notes(source.document).named.get(source.element, ())
    return _without_clashes(children) if version_of(source.document) < _SEVEN else children


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
