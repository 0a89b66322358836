"""The graph of a description: parts, nodes that references name, and the models and worlds that know them."""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Sequence
from functools import cache, lru_cache
from importlib import import_module
from itertools import islice
from typing import TYPE_CHECKING, Any, ClassVar, Protocol, TypeVar, cast, overload

from sdfcheck.formats.schema import AttributeDefinition, Definition
from sdfcheck.formats.sdf.schema import schema
from sdfcheck.formats.sdf.survey import survey
from sdfcheck.formats.version import Version
from sdfcheck.robot.naming.name import MODEL_FRAME, NODES, WORLD_FRAME
from sdfcheck.robot.values import Flag, Number, Text, Vector, is_true, lazy, parts, reference_of
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import is_expression

if TYPE_CHECKING:
    from collections.abc import Collection

    from sdfcheck.formats.topology import Displaced
    from sdfcheck.robot.includes.included import Included
    from sdfcheck.robot.motion.mass import MassProperties
    from sdfcheck.robot.motion.origin import Origin
    from sdfcheck.robot.motion.poses import Pose
    from sdfcheck.robot.motion.rotations import Array
    from sdfcheck.robot.motion.tree import Tree
    from sdfcheck.robot.parts.control import ControlComponent, Ros2Control, Transmission
    from sdfcheck.robot.parts.gazebo import GazeboBlock
    from sdfcheck.robot.parts.joint import Joint
    from sdfcheck.robot.parts.link import Link
    from sdfcheck.robot.parts.physics import Actor, Physics
    from sdfcheck.robot.parts.plugin import Plugin
    from sdfcheck.robot.parts.sensor import Light, Sensor
    from sdfcheck.robot.parts.shape import Material
    from sdfcheck.robot.root import Root
    from sdfcheck.source.document import Document, Element, Value
    from sdfcheck.source.text import Span


# Which class an element becomes, by its name and by what it is in.


_HOMES = {
    "actor": "parts.physics:Actor",
    "axis": "parts.joint:Axis",
    "axis2": "parts.joint:Axis",
    "collision": "parts.shape:Collision",
    "contact": "parts.sensor:Contact",
    "drake:frame": "graph:Frame",
    "drake:joint": "parts.joint:Joint",
    "dynamics": "parts.joint:Dynamics",
    "frame": "graph:Frame",
    "gazebo": "parts.gazebo:GazeboBlock",
    "geometry": "parts.shape:Geometry",
    "gripper": "parts.physics:Gripper",
    "include": "parts.files:Include",
    "inertial": "parts.link:Inertial",
    "joint": "parts.joint:Joint",
    "light": "parts.sensor:Light",
    "limit": "parts.joint:Limit",
    "link": "parts.link:Link",
    "material": "parts.shape:Material",
    "mimic": "parts.joint:Mimic",
    "model": "graph:Model",
    "origin": "graph:Placement",
    "physics": "parts.physics:Physics",
    "plugin": "parts.plugin:Plugin",
    "pose": "graph:Placement",
    "robot": "graph:Model",
    "ros2_control": "parts.control:Ros2Control",
    "sensor": "parts.sensor:Sensor",
    "state": "parts.physics:State",
    "surface": "parts.shape:Surface",
    "transmission": "parts.control:Transmission",
    "visual": "parts.shape:Visual",
    "world": "graph:World",
}
"""Element → where the class of its part is; all others make a :class:`Setting`, prefixed ones a :class:`Custom`."""

_OF_CONTROL = {
    "command_interface": "parts.control:ControlInterface",
    "gpio": "parts.control:ControlComponent",
    "joint": "parts.control:ControlComponent",
    "sensor": "parts.control:ControlComponent",
    "state_interface": "parts.control:ControlInterface",
    "transmission": "parts.control:ControlTransmission",
}
"""Names that mean this in a ``ros2_control`` block only → where the class is."""

_CONTROL = frozenset(("ros2_control", "component"))

_ELSEWHERE = {
    "contact": frozenset(("sensor", "audio_source")),
    "link": frozenset(("model", "robot", "gazebo")),
    "model": frozenset(("sdf", "world", "model", "gazebo")),
    "inertial": frozenset(("link",)),
    "joint": frozenset(("model", "world", "robot", "gazebo")),
    "frame": frozenset(("model", "world", "gazebo")),
    "gazebo": frozenset(("robot",)),
    "material": frozenset(("visual", "robot", "collision")),
    "physics": frozenset(("world",)),
    "plugin": frozenset(
        ("world", "model", "sensor", "visual", "gui", "actor", "light", "projector", "gazebo")
    ),
}
"""Names that mean something else elsewhere → the elements in which they mean this."""

_OF_JOINTS = {
    "axis": frozenset(("joint",)),
    "axis2": frozenset(("joint",)),
    "limit": frozenset(("axis", "joint")),
    "mimic": frozenset(("axis", "joint")),
    "dynamics": frozenset(("axis", "joint")),
}
"""Names that mean this only in a joint, or in an axis of one → the kinds of part."""

_SCOPES = frozenset(("gazebo", "link", "model", "world"))
_SCOPED = frozenset(("frame", "inertial", "joint", "link", "model"))
"""Names that mean this in such a part only, and not in a setting: the link of an actor, the model of a population."""

CLASSES = {
    name: home
    for home in {
        *_HOMES.values(),
        *_OF_CONTROL.values(),
        "graph:Custom",
        "graph:Part",
        "parts.gazebo:ExtendedModel",
        "parts.files:Resource",
        "graph:Setting",
        "root:Root",
    }
    for name in (home.partition(":")[2],)
}
"""Class → where it is."""

ELEMENTS: dict[str, tuple[str, ...]] = {}
"""Class → the elements that become parts of it."""
for _element, _home in _HOMES.items():
    _class = _home.partition(":")[2]
    ELEMENTS[_class] = (*ELEMENTS.get(_class, ()), _element)


def part_class(holder: Part, element: Element) -> type[Part]:
    """The class of the part that an element in a holder makes."""
    return _class_of(holder.element.name, holder.kind, element.name) or _class_in(
        _place(holder), holder.kind, element.name
    )


@lru_cache(maxsize=1000)
def _class_of(holder: str, kind: str, tag: str) -> type[Part] | None:
    """The same for names without a colon; None for others."""
    names = holder + tag
    return _class_in(holder, kind, tag) if names.isascii() and "{" not in names and ":" not in names else None


def _place(holder: Part) -> str:
    """The name of the holder's element; a macro of xacro counts as the link or joint that it writes."""
    place = holder.element.name
    return holder.kind if place.startswith("xacro:") else place


@lru_cache(maxsize=1000)
def _class_in(holder: str, kind: str, name: str) -> type[Part]:
    if kind in _CONTROL and name in _OF_CONTROL:
        return class_named(_OF_CONTROL[name].partition(":")[2])
    home = _HOMES.get(name)
    if home is not None and (kind != "setting" or holder not in _SCOPES or name not in _SCOPED):
        wanted = _OF_JOINTS.get(name)
        at = holder if wanted is None else kind
        wanted = wanted or _ELSEWHERE.get(name)
        if wanted is None or at in wanted:
            return class_named(home.partition(":")[2])
    return class_named("Custom" if ":" in name else "Setting")


@cache
def class_named(name: str) -> type[Part]:
    """A class of the model by its name."""
    module, _, attribute = CLASSES[name].partition(":")
    found: type[Part] = getattr(import_module(f"sdfcheck.robot.{module}"), attribute)
    return found


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
    definition: Definition | None = schema(survey(element.document).version).root
    if at.name != "sdf":  # in a <gazebo> block of URDF
        names.insert(0, at.name)
        definition = schema(survey(element.document).version).at(f"{names[0]}:{names[0]}")
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
    root: Root
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
    def scope_around(self) -> Scope | None:
        """The model or world that it is directly in."""
        return cast("Scope", self.holder) if self.holder is not None and self.holder.is_scope else None

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

    def misspells(self, name: str) -> bool:
        """Does it lack a child or attribute of that name only because it is misspelled?"""
        if not self.is_given:
            return False
        if self.is_urdf:
            from sdfcheck.formats.urdf.findings import misspells

            return misspells(self.element, name)

        return (self.element, name) in survey(self.document).misspelled

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
        if self.value(name) is not None or self.misspells(name):
            return False
        if not self.is_unfinished:
            return True
        from sdfcheck.formats.urdf.findings import definition
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
                made: Any = class_named("Custom")
                found[name] = made(self, self.element, self.element.attribute(name))
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
        if pose.text_of("relative_to", "").strip():
            return None
        return _three(pose.content)

    # For the parts themselves

    def part(self, element: Element) -> Part:
        """The part that a child element makes, each time the same."""
        found = self.registry.get(element)
        if found is None:
            found = self.registry[element] = part_class(self, element)(self, element)
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
        return survey(self.document).displaced.get(self.element, ())

    @property
    def replaced(self) -> tuple[str, ...]:
        """The names of required elements that are absent beside it, and that it seems to replace."""
        return () if self.is_attribute else tuple(survey(self.document).replaced.get(self.element, ()))

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
    def scope(self) -> Scope:
        """The model or world in which its name is known."""
        if self.holder is not None and self.holder.kind == "gazebo":
            return cast("Node", self.holder).scope
        return cast("Scope", self.holder)

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
        from sdfcheck.robot.motion.poses import resolved

        return resolved(self, relative_to)


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

    def __init__(self, holder: Part, element: Element, model: Model) -> None:
        super().__init__(holder, element, f"_merged__{model.name}__model__")
        self.model = model

    @lazy
    def unmerged(self) -> Model:
        """The model as it is by itself, not merged."""
        from sdfcheck.robot.includes.included import included

        model = included_model(cast("Scope", self.model.holder), included(self.document, self.element))
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


# The model that an include brings.


MOST_MODELS = 10_000
"""So many included models are looked into: includes of includes can multiply without end."""
DEEPEST = 50


def included_model(source: Scope, found: Included) -> Model | None:
    """The model that an include brings; without content where the file cannot be read or leads in a ring.

    None where not even its name is known.
    """
    chain, inside = source.chain, found.document
    root = source.root
    is_readable = (
        found.model is not None and inside is not None and inside not in chain and len(chain) <= DEEPEST
    )
    if is_readable:
        root.included += 1
        is_readable = root.included <= MOST_MODELS
    if found.name is None and not is_readable:
        return None
    made: Any = class_named("Model")
    model: Model = made(source, found.model if is_readable else found.include, found.name or "")
    model.registry = {}
    model.include, model.is_readable = found.include, is_readable
    if is_readable and inside is not None:
        model.chain = (*chain, inside)
    return model


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
        self._by_scope: dict[Scope, dict[str, list[str]]] = {}

    def names(self, scope: Scope) -> dict[str, list[str]]:
        if scope not in self._by_scope:
            reachable: defaultdict[str, list[str]] = defaultdict(list)
            for name in scope.names():
                reachable[_last(name)].append(name)
            self._by_scope[scope] = reachable
        return self._by_scope[scope]


def guess(scope: Scope, name: str, but: tuple[str, ...] = (), kind: str = "") -> Guess:
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


def _outside(scope: Scope, name: str) -> Node | None:
    at = scope.scope_around
    while at is not None:
        if (found := at.resolve(name)) is not None:
            return found
        at = at.scope_around
    return None


# The names by which the joints of a world or model refer to nothing, and those of them that others explain.


Unresolved = dict[str, list["Value"]]
"""Name → the ends of joints that use it."""


def unresolved_ends(scope: Scope) -> Unresolved:
    """The names that name nothing in a scope of SDFormat, with the ends of its joints that use them.

    Left out are names that are malformed or might be in a file that could not be read,
    and joints whose ends are one name, or whose child is the world.
    """
    found: Unresolved = {}
    for element in scope.children("joint"):
        joint = cast("Joint", scope.part(element))
        if joint.kind != "joint" or joint.child_name in {"world", joint.parent_name}:
            continue
        for value, node in ((joint.parent_value, joint.parent), (joint.child_value, joint.child)):
            if value is None or node is not None or "" in value.text.split("::"):
                continue
            if not scope.may_hold(value.text):
                found.setdefault(value.text, []).append(value)
    return found


def lost_names(scope: Scope, unresolved: Collection[str]) -> frozenset[str]:
    """The unresolved names that belong to what has lost its name, so that they are reported there.

    That are parts of the scope without a name, with that of another, or misspelled ones.
    """
    if not unresolved:
        return frozenset()
    parts = [child for child in scope.children() if child.name in NODES]
    names = [name for part in parts if (name := part.attributes.get("name", ""))]
    nameless = len(parts) - len(names) + sum(map(scope.misspells, NODES))
    if len(unresolved) <= nameless:
        return frozenset(unresolved)
    doubled = len(names) - len(set(names))
    if not doubled:
        return frozenset()
    from sdfcheck.formats.near_names import suggest_in

    # A name like another may be misspelled, while a part with the name of another has lost any name.
    document = scope.document
    unlike = frozenset(name for name in unresolved if suggest_in(document, name, set(names)) is None)
    return unlike if len(unlike) <= nameless + doubled else frozenset()


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


class Scope(Node):
    """A model or a world.

    ``is_complete`` is False where an include could not be read, so that an unknown name
    proves nothing.
    """

    __slots__ = ("_unread", "chain", "merged_frame")

    is_scope = True
    own_name = MODEL_FRAME
    """The name of the scope's own frame, as references in it write it."""

    def __init__(self, holder: Part, element: Element | None, name: str | None = None) -> None:
        super().__init__(holder, element, name)
        self._unread = False
        outer = holder if isinstance(holder, Scope) else None
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

    @lazy
    def links(self) -> tuple[Link, ...]:
        """The links directly in it, in the order of the file."""
        return cast("tuple[Link, ...]", self._members("link"))

    @lazy
    def joints(self) -> tuple[Joint, ...]:
        """The joints directly in it, in the order of the file."""
        return cast("tuple[Joint, ...]", self._members("joint"))

    @lazy
    def frames(self) -> tuple[Frame, ...]:
        """The frames that are written as ``frame``, and those of merged models."""
        return cast("tuple[Frame, ...]", self._members("frame"))

    @lazy
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
        return guess(self, reference, but, kind)

    @lazy
    def unresolved(self) -> Unresolved:
        """The names by which its joints refer to nothing, with the ends of joints that use them."""
        return unresolved_ends(self)

    @lazy
    def lost_names(self) -> frozenset[str]:
        """Those of the unresolved names for which not the joints are at fault, but what has lost its name."""
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
        return pick(self, "model", self.models, key)

    def joint(self, key: str | int) -> Joint:
        """A joint by name, also of an inner model (``arm::elbow``), or by index; raises NotFound."""
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

        if survey(source.document).index.get("include"):
            from sdfcheck.robot.includes.included import included

            for include in source.element.children("include"):
                self._include(source, nodes, included(source.document, include))

    def _take(self, source: Scope, nodes: dict[str, Node], name: str, element: Element) -> None:
        part = source.part(element)
        if isinstance(part, Node):
            part._name = name
            if source is not self:
                part.holder, part.merged = self, source.merged_frame
            nodes.setdefault(name, part)

    def _include(self, source: Scope, nodes: dict[str, Node], found: Included) -> None:
        """Bring in an included model: as a nested one, or its parts where it is merged."""
        if found.kind not in {"model", None}:
            return  # lights and actors make no frames

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

        model.merged_frame = MergedFrame(self, found.include, model)
        self._take_from(model, nodes)
        self._unread = self._unread or model._unread
        if found.name:
            nodes.setdefault(model.merged_frame.name, model.merged_frame)


def _named_children(source: Scope) -> Iterable[Child]:
    """The named parts of a world or model."""
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


# The names by which the joints of a URDF robot call its links, and those that the links have.


class LinkNames:
    """Which mistake explains a name that joints use and no link has: that in the joint, or that in the link."""

    def __init__(self, model: Model) -> None:
        self.model = model
        self.links: dict[str, Link] = model.tree.links
        self.unknown: dict[str, list[Value]] = {}
        """The names that joints use and no link has, with the places; unexpanded expressions are left out."""
        for joint in model.joints:
            for value in (joint.parent_value, joint.child_value):
                if value is not None and value.text not in self.links and not is_expression(value.text):
                    self.unknown.setdefault(value.text, []).append(value)

    @property
    def explained(self) -> set[str]:
        """The unknown names for which links are at fault, so that they are reported there."""
        return {*self.lost, *self.misspelled} if self.unknown else set()

    @lazy
    def lost(self) -> frozenset[str]:
        """The unknown names that belong to links without a name, or with that of another link."""
        if not self.unknown:
            return frozenset()
        nameless = self._nameless
        if len(self.unknown) <= nameless:
            return frozenset(self.unknown)
        doubled = len(self.model.links) - len(self.links) - self._unnamed
        if not doubled:
            return frozenset()
        from sdfcheck.formats.near_names import suggest_in

        # A name like that of a link may be misspelled, while a link with the name of another has lost any name.
        document = self.model.document
        unlike = frozenset(name for name in self.unknown if suggest_in(document, name, self.links) is None)
        return unlike if len(unlike) <= nameless + doubled else frozenset()

    @lazy
    def misspelled(self) -> dict[str, Link]:
        """Unknown names on which several joint ends agree → the link, used by no joint, that they mean."""
        agreed = [name for name, values in self.unknown.items() if len(values) > 1]
        if not agreed:
            return {}
        from sdfcheck.formats.near_names import suggest_in

        used = {name for joint in self.model.joints for name in (joint.parent_name, joint.child_name)}
        free = [name for name in self.links if name not in used]
        document = self.model.document
        found = {name: meant for name in agreed if (meant := suggest_in(document, name, free)) is not None}
        times = Counter(found.values())
        return {name: self.links[meant] for name, meant in found.items() if times[meant] == 1}

    @property
    def _unnamed(self) -> int:
        return sum(not link.name or is_expression(link.name) for link in self.model.links)

    @property
    def _nameless(self) -> int:
        """How many links have no name, one that is yet to be expanded, or are not even called ``link``."""
        from sdfcheck.formats.near_names import suggest
        from sdfcheck.formats.urdf.schema import urdf

        known = urdf().children
        others = (child.name for child in self.model.children() if child.name not in known)
        return self._unnamed + sum(suggest(name, ("joint", "link")) == "link" for name in others)


# The materials of a URDF robot, in the order in which urdfdom reads them: those of the robot, then of each link.


class MaterialNames:
    """The materials that the names in a robot reach. Nobody reads those of collisions."""

    def __init__(self, model: Model) -> None:
        self.model = model
        self.defined: dict[str, Material] = {}
        """Name → the first definition: one of the robot, or of the first visual that says what it looks like."""
        self.redefined: list[tuple[Material, Material]] = []
        """Materials that look otherwise than the first of their name, with that one."""
        nameless = 0
        for material in model.materials:
            if name := material.element.text_of("name"):
                self.defined.setdefault(name, material)
            else:
                nameless += 1
        missing: dict[str, list[Material]] = {}
        for name, material in self._used():
            if material.has_look:
                first = self.defined.setdefault(name, material)
                if first.has_look and first.look != material.look:
                    self.redefined.append((material, first))
            elif name not in self.defined:
                missing.setdefault(name, []).append(material)
        # Where a material has lost its name, that is reported, not wherever it is missed.
        found = missing if len(missing) > nameless else {}
        self.undefined = {name: uses for name, uses in found.items() if not is_expression(name)}
        """Names of which nothing has said the look so far → the materials that only name them."""

    def _used(self) -> Iterator[tuple[str, Material]]:
        for link in self.model.links:
            for visual in link.visuals:
                value = visual.own_material.name_value
                if value is not None and value.text:
                    yield value.text, visual.own_material


# Models: robots and everything else that has links.


Built_co = TypeVar("Built_co", covariant=True)
_BOOLEANS = frozenset({"", "true", "1", "false", "0"})


class Builder(Protocol[Built_co]):
    """A consumer of which it is known what it makes of a robot."""

    def build(self, robot: Model) -> Built_co:
        """The robot that it makes of one."""


_DRIVING = ("drive", "controller", "steering", "thruster")
"""Words in the names of libraries of Gazebo that move joints."""


class Model(Scope):
    """A model of SDFormat, or the robot of a URDF file.

    One that an include brought has its ``include``; its ``element`` is then that of the
    included file, or the ``include`` itself where the file cannot be read.
    """

    __slots__ = ("include", "is_readable")
    kind = "model"

    def __init__(self, holder: Part, element: Element | None, name: str | None = None) -> None:
        super().__init__(holder, element, name)
        self.include: Element | None = None
        """The ``include`` that brought it, if one did."""
        self.is_readable = True  # its content could be read
        self.is_urdf = self.element.name == "robot"

    @property
    def place(self) -> Element:
        return self.element if self.include is None else self.include

    @property
    def is_complete(self) -> bool:
        is_open = self.document.is_open or self.document.kind is Kind.XACRO
        return self.is_readable and not is_open and super().is_complete

    def _fill(self, nodes: dict[str, Node]) -> None:
        if self.is_readable:
            super()._fill(nodes)

    # Content

    @lazy
    def plugins(self) -> tuple[Plugin, ...]:
        """The plugins of the model; in URDF those of its ``<gazebo>`` blocks without reference."""
        if self.is_urdf:
            blocks = (block for block in self.gazebo_blocks if not block.reference)
            return tuple(plugin for block in blocks for plugin in block.plugins)
        return tuple(self._parts("plugin"))

    @lazy
    def materials(self) -> tuple[Material, ...]:
        """The materials that a URDF robot defines for all its links."""
        return tuple(self._parts("material")) if self.is_urdf else ()

    @lazy
    def transmissions(self) -> tuple[Transmission, ...]:
        """The transmissions of a URDF robot."""
        return tuple(self._parts("transmission")) if self.is_urdf else ()

    @lazy
    def ros2_control(self) -> tuple[Ros2Control, ...]:
        """The ``ros2_control`` blocks of a URDF robot."""
        return tuple(self._parts("ros2_control")) if self.is_urdf else ()

    @lazy
    def has_simulated_hardware(self) -> bool:
        """Do some of its ``ros2_control`` blocks ask for the hardware of a simulator?"""
        return any(block.is_simulated for block in self.ros2_control)

    @lazy
    def control_joints(self) -> dict[str, list[ControlComponent]]:
        """The joints of all ``ros2_control`` blocks by their names; of two of one name in a block the first."""
        found: dict[str, list[ControlComponent]] = {}
        for block in self.ros2_control:
            for name, joint in block.joints.items():
                if name:
                    found.setdefault(name, []).append(joint)
        return found

    @lazy
    def poses_at_rest(self) -> dict[Link, Origin]:
        """The poses of the links of a robot of URDF in its root, all joints at zero, in plain numbers."""
        from sdfcheck.robot.motion.origin import links_at_rest

        return links_at_rest(self)

    @lazy
    def drivers(self) -> dict[Joint, Part]:
        """The joints that something moves on command, each with the first that does."""
        found: dict[Joint, Part] = {}
        for joint, driver in self._drives():
            if joint is not None:
                found.setdefault(joint, driver)
        return found

    def _drives(self) -> Iterator[tuple[Joint | None, Part]]:
        for components in self.control_joints.values():
            yield from ((component.joint, component) for component in components if component.commands)
        for transmission in self.transmissions:
            names = transmission.joint_names
            yield from ((self.joints_by_name.get(name.text), transmission) for name in names)
        for element in self.root.elements.get("plugin", ()):
            plugin = cast("Plugin", self.root.part_of(element))
            if plugin.kind == "plugin" and any(word in plugin.filename.lower() for word in _DRIVING):
                joints = (each.joint for each in plugin.references)
                yield from ((joint, plugin) for joint in joints if joint is not None and joint.model is self)

    @lazy
    def control_by_name(self) -> dict[str, Ros2Control]:
        """The ``ros2_control`` blocks of a URDF robot, by name; of two of one name the first."""
        found: dict[str, Ros2Control] = {}
        for block in self.ros2_control:
            found.setdefault(block.name, block)
        return found

    @lazy
    def gazebo_blocks(self) -> tuple[GazeboBlock, ...]:
        """The ``<gazebo>`` blocks of a URDF robot."""
        return tuple(self._parts("gazebo")) if self.is_urdf else ()

    @lazy
    def blocks_by_reference(self) -> dict[str, list[GazeboBlock]]:
        """The ``<gazebo>`` blocks by the link or joint that they are about; those about the robot under ``""``."""
        found: dict[str, list[GazeboBlock]] = {}
        for block in self.gazebo_blocks:
            found.setdefault(block.reference, []).append(block)
        return found

    @lazy
    def extended(self) -> Model:
        """The same robot with what its ``<gazebo>`` blocks add, as Gazebo has it."""
        return cast("Model", class_named("ExtendedModel")(self, self.element))

    # Properties

    @property
    def is_static(self) -> bool:
        """Does nothing in it move, because it or a model around it is static?"""
        outer = self.holder
        return self.stands_still or (isinstance(outer, Model) and outer.is_static)

    @property
    def may_be_static(self) -> bool:
        """Is it static, or does it say something about that which is neither true nor false?"""
        value = self.static_value
        return self.is_static or (value is not None and value.text.lower() not in _BOOLEANS)

    @property
    def is_included_as_static(self) -> bool:
        """Is it the model of a file that was reached by an include which makes it static?"""
        from sdfcheck.robot.includes.included import is_made_static

        return self.holder is self.root and is_made_static(self.document)

    @lazy
    def static_value(self) -> Value | None:
        """Where it says whether it is static."""
        given = self.include.find("static") if self.include is not None else None
        if given is None:
            given = self.find("static")
        return None if given is None else given.own_value

    @lazy
    def stands_still(self) -> bool:
        if self.is_urdf:
            blocks = self.blocks_by_reference.get("", ())
            return any(is_true(static.content) for block in blocks for static in block.children("static"))
        value = self.static_value
        return value is not None and is_true(value.text)

    @property
    def canonical_link_value(self) -> Value | None:
        """The reference to its canonical link, with its place; None if nothing is written."""
        value = self.attribute("canonical_link")
        return value if value is not None and value.text.strip() else None

    @property
    def canonical_link_name(self) -> str:
        """The name that ``canonical_link`` writes; empty if there is none."""
        value = self.canonical_link_value
        return "" if value is None else value.text.strip()

    @lazy
    def canonical_link(self) -> Link | None:
        """The link that the model moves with: the one that it names, or its first, nested models included."""
        node = self.attachment
        seen: set[Node] = set()
        while isinstance(node, Model) and node not in seen:
            seen.add(node)
            node = node.attachment
        return cast("Link", node) if node is not None and node.kind == "link" else None

    @property
    def attachment(self) -> Node | None:
        if not self.is_complete or self.canonical_link_name:
            return self.resolve(self.canonical_link_name) if self.is_complete else None
        first = next((node for node in self.nodes.values() if node.kind == "link"), None)
        if first is not None:
            return first
        return next((node for node in self.nodes.values() if node.kind == "model"), None)

    @property
    def pose_element(self) -> Element | None:
        own = self.include.find("pose") if self.include is not None else None
        return self.find("pose") if own is None and self.is_readable else own

    @property
    def placement_frame_value(self) -> Value | None:
        """The frame that its pose places, as the model itself writes it, with its place."""
        value = self.attribute("placement_frame")
        return value if value is not None and value.text.strip() else None

    @property
    def placement_frame(self) -> str:
        """The name of the frame of the model that its pose places; empty: its own frame."""
        given = self.include.find("placement_frame") if self.include is not None else None
        if given is not None and given.content:
            return given.content
        return (self._text("placement_frame") or "").strip()

    # How it hangs together

    @lazy
    def tree(self) -> Tree:
        """Its links and joints as a tree: roots, children, parents, loops."""
        from sdfcheck.robot.motion.tree import Tree

        return Tree(self)

    @lazy
    def joints_by_name(self) -> dict[str, Joint]:
        """Its joints by name, of several of a name the first; in URDF a link may have the same name."""
        found: dict[str, Joint] = {}
        for joint in self.joints:
            found.setdefault(joint.name, joint)
        return found

    @lazy
    def driven(self) -> dict[str, Joint]:
        """In URDF: the joints that something can drive by name, Drake's own (``drake:joint``) among them."""
        elements = (child for child in self.children() if child.name in {"joint", "drake:joint"})
        found: dict[str, Joint] = {}
        for joint in cast("Iterator[Joint]", map(self.part, elements)):
            found.setdefault(joint.name, joint)
        return found

    @lazy
    def unresolved(self) -> Unresolved:
        return self.link_names.unknown if self.is_urdf else super().unresolved

    @lazy
    def lost_names(self) -> frozenset[str]:
        return frozenset(self.link_names.explained) if self.is_urdf else super().lost_names

    @lazy
    def link_names(self) -> LinkNames:
        """In URDF: the names by which joints call links, and those that the links have."""
        return LinkNames(self)

    @lazy
    def material_names(self) -> MaterialNames:
        """In URDF: what the names of its materials reach."""
        return MaterialNames(self)

    def as_built_by(self, consumer: Builder[Built_co]) -> Built_co:
        """In URDF: the robot that a consumer makes of it."""
        if consumer not in self._built:
            self._built[consumer] = consumer.build(self)
        return cast("Built_co", self._built[consumer])

    @lazy
    def _built(self) -> dict[object, object]:
        return {}

    @property
    def mass_properties(self) -> MassProperties | None:
        """Mass, center of mass and inertia of all its links, in its frame; None if no link has any."""
        from sdfcheck.robot.motion.mass import of_model

        return of_model(self)

    @lazy
    def reach(self) -> float:
        """The longest distance (m) from a joint of the robot to the one that carries it; 0 where that is unknown.

        In SDFormat the longest distance of a link from the first one.
        """
        from sdfcheck.robot.motion.bounds import reach_of

        return reach_of(self)

    @lazy
    def has_mesh(self) -> bool:
        """Has one of its links a shape whose mesh file is there?"""
        return any(link.has_mesh for link in self.links)

    @lazy
    def density(self) -> float:
        """The mass of its links by the volume of the boxes around their shapes (kg/m³); nan where few are known."""
        from sdfcheck.robot.motion.bounds import density_of

        return density_of(self)

    @property
    def is_out_of_scale(self) -> bool:
        """Is it, as a whole, lighter than any gas, or heavier than any material by far?"""
        if not self.joints or self.may_be_static or not self.has_mesh:
            return False
        return 0 < self.density < 0.05 or self.density > 1e6

    @property
    def bounds(self) -> Array | None:
        """The box around the bounds of all its links, all joints at zero: lowest and highest x, y, z.

        In m, in its frame, shape (2, 3); None where no shape has a known size. Raises PoseError.
        """
        from sdfcheck.robot.motion.bounds import as_array, of_model

        return as_array(of_model(self))

    # Parts by name

    def link(self, key: str | int) -> Link:
        """A link by name, also of an inner model (``arm::hand``), or by index; raises NotFound."""
        return pick(self, "link", self.links, key)

    def all_links(self) -> Iterator[Link]:
        """The links of the model and of all models in it."""
        return (cast("Link", node) for _, node in self.all_nodes() if node.kind == "link")


# Worlds.


class World(Scope):
    """A world."""

    __slots__ = ()
    kind = "world"
    own_name = WORLD_FRAME

    physics: lazy[tuple[Physics, ...]] = parts("physics", "The physics profiles.")
    lights: lazy[tuple[Light, ...]] = parts("light", "The lights directly in it.")
    actors: lazy[tuple[Actor, ...]] = parts("actor", "The actors.")
    plugins: lazy[tuple[Plugin, ...]] = parts("plugin", "The plugins of the world itself.")

    @property
    def gravity(self) -> Vector:
        """The acceleration of gravity (m/s²)."""
        return self._vector("gravity", (0.0, 0.0, -9.8))

    @lazy
    def unserved_sensors(self) -> tuple[tuple[Sensor, tuple[str, ...]], ...]:
        """Its sensors that need a system of Gazebo which is not there, with those that would do.

        None where the world lists no system of gz-sim: Gazebo then brings its own.
        """
        elements = self.root.elements
        if not elements.get("sensor") or not elements.get("plugin"):
            return ()
        from sdfcheck.formats.plugins import GZ_SIM, served

        plugins: list[Plugin] = list(self.root.each("Plugin"))
        present = {plugin.known.file for plugin in plugins if plugin.known is not None}
        if not any(plugin.known is not None and plugin.known.generation == GZ_SIM for plugin in self.plugins):
            return ()
        needs = served()
        sensors: list[Sensor] = [s for s in self.root.each("Sensor") if s.within(World) is self]
        return tuple(
            (sensor, needs[sensor.type])
            for sensor in sensors
            if sensor.type in needs and present.isdisjoint(needs[sensor.type])
        )
