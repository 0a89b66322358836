"""The root of a description: everything that a file says, as one graph of parts."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import lru_cache
from itertools import chain
from operator import attrgetter
from typing import TYPE_CHECKING, Any, TypeVar, cast

from sdfcheck.files.library import library_of
from sdfcheck.formats.sdf.survey import survey
from sdfcheck.formats.version import VERSIONS, Version
from sdfcheck.robot.graph import (
    Actor,
    Axis,
    Collision,
    Contact,
    ControlComponent,
    ControlInterface,
    ControlTransmission,
    Dynamics,
    GazeboBlock,
    Gripper,
    Include,
    Inertial,
    Joint,
    Light,
    Limit,
    Link,
    Mimic,
    Model,
    Physics,
    Plugin,
    Ros2Control,
    Scope,
    Sensor,
    State,
    Transmission,
    Visual,
    World,
)
from sdfcheck.robot.part import Custom, Frame, Node, Part, Placement, Setting, Whole, pick
from sdfcheck.robot.resources import Resource, Unbuilt, unbuilt
from sdfcheck.robot.shapes import Geometry, Material, Surface
from sdfcheck.robot.values import lazy, reference_value
from sdfcheck.source.document import Value
from sdfcheck.source.record import Record

if TYPE_CHECKING:
    from sdfcheck.formats.sdf.survey import Survey
    from sdfcheck.robot.bridges import BridgeFault, BridgeGap
    from sdfcheck.robot.controllers import Parameter
    from sdfcheck.robot.motion.mass import MassProperties
    from sdfcheck.robot.naming.names import Names
    from sdfcheck.robot.ros_files import BaseFrame, LaunchedWorld
    from sdfcheck.source.document import Document, Element
    from sdfcheck.source.text import Span
    from sdfcheck.xacro.static.launches import LaunchFault


# Which class an element becomes, by its name and by what it is in.


_CLASSES: dict[str, type[Part]] = {
    "actor": Actor,
    "axis": Axis,
    "axis2": Axis,
    "collision": Collision,
    "contact": Contact,
    "drake:frame": Frame,
    "drake:joint": Joint,
    "dynamics": Dynamics,
    "frame": Frame,
    "gazebo": GazeboBlock,
    "geometry": Geometry,
    "gripper": Gripper,
    "include": Include,
    "inertial": Inertial,
    "joint": Joint,
    "light": Light,
    "limit": Limit,
    "link": Link,
    "material": Material,
    "mimic": Mimic,
    "model": Model,
    "origin": Placement,
    "physics": Physics,
    "plugin": Plugin,
    "pose": Placement,
    "robot": Model,
    "ros2_control": Ros2Control,
    "sensor": Sensor,
    "state": State,
    "surface": Surface,
    "transmission": Transmission,
    "visual": Visual,
    "world": World,
}
"""Element → the class of its part; all others make a :class:`Setting`, prefixed ones a :class:`Custom`."""


_OF_CONTROL: dict[str, type[Part]] = {
    "command_interface": ControlInterface,
    "gpio": ControlComponent,
    "joint": ControlComponent,
    "sensor": ControlComponent,
    "state_interface": ControlInterface,
    "transmission": ControlTransmission,
}
"""Names that mean this in a ``ros2_control`` block only → the class."""


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


ELEMENTS: dict[str, tuple[str, ...]] = {}
"""Class → the elements that become parts of it."""
for _element, _class in _CLASSES.items():
    ELEMENTS[_class.__name__] = (*ELEMENTS.get(_class.__name__, ()), _element)


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
        return _OF_CONTROL[name]
    found = _CLASSES.get(name)
    if found is not None and (kind != "setting" or holder not in _SCOPES or name not in _SCOPED):
        wanted = _OF_JOINTS.get(name)
        at = holder if wanted is None else kind
        wanted = wanted or _ELSEWHERE.get(name)
        if wanted is None or at in wanted:
            return found
    return Custom if ":" in name else Setting


# Parts of the robot that the names of elements alone do not determine.


_LISTENERS = frozenset({"sensor", "audio_source"})


def _is_wheel(joint: Joint) -> bool:
    return joint.type == "continuous" and "wheel" in f"{joint.name} {joint.child_name}".lower()


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


class Root(Whole):
    """A whole file: its worlds, and the models, lights and actors that are in none. A URDF file is one model."""

    __slots__ = ()

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

    @lazy
    def launch_fault(self) -> LaunchFault | None:
        """The first place where a launch file of its project does not get what it expands to."""
        if self.document.path.suffix != ".xacro" or not any(model.links for model in self.models):
            return None
        from sdfcheck.xacro.static.launches import launch_fault

        return launch_fault(self.document)

    @property
    def is_launched_as_text(self) -> bool:
        """Do the launch files of the project take what it expands to for text, not for YAML?"""
        from sdfcheck.xacro.static.launches import is_launched_as_text

        return is_launched_as_text(self.document)

    @property
    def is_superseded(self) -> bool:
        """Does the `model.config` of its folder name it, and another file for those who know a newer version?"""
        from sdfcheck.robot.includes.model_config import is_superseded

        return is_superseded(self.document)

    @property
    def read_as(self) -> Version:
        """The version of the format as which it is read: the newest where none or an unknown one is declared."""
        return self._survey.version

    @lazy
    def tied_names(self) -> frozenset[str]:
        """The names of the links that a joint of the document ties, without those of their models."""
        return frozenset(
            name.rpartition("::")[2]
            for joint in self.each(Joint)
            for name in (joint.parent_name, joint.child_name)
        )

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
        from sdfcheck.robot.resources import resources_of

        return resources_of(self)

    @lazy
    def has_ros_files(self) -> bool:
        """Has its project files that may say what ROS starts with it? What reads them is loaded only then."""
        library = library_of(self.document)
        return library is not None and library.packages(self.document.path).has_ros_files

    @lazy
    def bridge_gaps(self) -> tuple[BridgeGap, ...]:
        """The sensors and systems whose messages no bridge to ROS of the project carries, though one means to."""
        if not self.has_ros_files or not (self.elements.get("sensor") or self.elements.get("plugin")):
            return ()
        from sdfcheck.robot.bridges import gaps

        return tuple(gaps(self.document, self.each(Sensor), self.each(Plugin)))

    @lazy
    def unbuilt(self) -> tuple[Unbuilt, ...]:
        """The faults in the build of its package, if the file says something of its own."""
        is_whole = bool(self.worlds) or any(model.links for model in self.models)
        return tuple(unbuilt(self.document)) if is_whole else ()

    @lazy
    def tabs_in_parameters(self) -> tuple[Span, ...]:
        """A tab in each file of parameters in its package that no program can read for it."""
        if not self.has_ros_files or not any(model.links for model in self.models):
            return ()
        from sdfcheck.robot.ros_files import tabs_in_parameters

        return tuple(tabs_in_parameters(self.document))

    @lazy
    def untyped_controllers(self) -> tuple[tuple[Plugin, Parameter], ...]:
        """The controllers that are started and have parameters and no type, each with the plugin of their file."""
        found = [
            (plugin, plugin.controllers.untyped)
            for model in self.models
            for plugin in model.control_plugins
            if plugin.controllers.untyped
        ]
        if not found:
            return ()
        from sdfcheck.robot.ros_files import started_untyped

        return tuple((one, each) for one, names in found for each in started_untyped(self.document, names))

    @lazy
    def second_manager(self) -> Span | None:
        """Where a launch file starts a controller manager beside that of Gazebo, for which all hardware is."""
        blocks = [block for model in self.models for block in model.ros2_control]
        if not blocks or not all(block.is_simulated for block in blocks):
            return None
        if not any(model.control_plugins for model in self.models):
            return None
        from sdfcheck.robot.ros_files import second_manager

        return second_manager(self.document)

    @lazy
    def odometry_filters(self) -> tuple[BaseFrame, ...]:
        """The filters of its project that publish the odometry of a robot in Gazebo, each with the link."""
        if not self.has_ros_files:
            return ()
        from sdfcheck.robot.ros_files import odometry_filters

        return odometry_filters(self.document)

    @lazy
    def lost_states(self) -> Span | None:
        """Where a launch file makes transforms of the states of joints, although nothing in its project has these."""
        if not self.has_ros_files:
            return None
        from sdfcheck.robot.ros_files import lost_states

        return lost_states(self.document)

    @lazy
    def is_shown_alone(self) -> bool:
        """Is showing it in RViz all that the launch files of its project do?"""
        if not self.has_ros_files:
            return False
        from sdfcheck.robot.ros_files import is_shown_alone

        return is_shown_alone(self.document)

    @lazy
    def unstarted_broadcasters(self) -> tuple[tuple[Plugin, str], ...]:
        """The controllers for states of joints that no launch file starts, each with the plugin of their file."""
        found = [
            (plugin, file.broadcaster, {need.controller for need in file.needs})
            for model in self.models
            for plugin in model.control_plugins
            if (file := plugin.controllers).broadcaster
        ]
        if not found:
            return ()
        from sdfcheck.robot.ros_files import unstarted_broadcaster

        return tuple(
            (one, name) for one, name, others in found if unstarted_broadcaster(self.document, name, others)
        )

    @lazy
    def has_other_states(self) -> bool:
        """May a node that its project starts publish states of joints, or make no transforms of them at all?"""
        if not self.has_ros_files:
            return True
        from sdfcheck.robot.ros_files import has_other_states

        return has_other_states(self.document)

    @lazy
    def launched_world(self) -> LaunchedWorld | None:
        """The world of its project in which a launch file creates it, if that is known."""
        if not self.has_ros_files or not any(model.links for model in self.models):
            return None
        from sdfcheck.robot.ros_files import launched_world

        return launched_world(self.document)

    @lazy
    def unbridged_clock(self) -> Span | None:
        """Where a launch file takes the time of Gazebo for the robot, which no bridge of its project carries."""
        if not self.has_ros_files or not any(model.links for model in self.models):
            return None
        from sdfcheck.robot.bridges import unbridged_clock

        return unbridged_clock(self.document)

    @lazy
    def unserved_sensors(self) -> tuple[tuple[Sensor, tuple[str, ...]], ...]:
        """The sensors of a robot that need a system which the world does not list in which it is created."""
        if not self.elements.get("sensor") or self.worlds or self.launched_world is None:
            return ()
        if "physics" not in self.launched_world.systems:
            return ()
        from sdfcheck.formats.plugins import served
        from sdfcheck.robot.ros_files import is_served

        needs = served()
        sensors = [each for each in self.each(Sensor) if each.type in needs]
        return tuple(
            (each, needs[each.type]) for each in sensors if not is_served(self.document, needs[each.type])
        )

    @lazy
    def bridge_faults(self) -> tuple[BridgeFault, ...]:
        """The entries of bridges of the project that are not taken, and are for its sensors and systems."""
        if not self.has_ros_files or not (self.elements.get("sensor") or self.elements.get("plugin")):
            return ()
        from sdfcheck.robot.bridges import faults

        return tuple(faults(self.document, self.each(Sensor), self.each(Plugin)))

    @lazy
    def missing_bases(self) -> tuple[BaseFrame, ...]:
        """The frames that nodes of ROS take for the base of a robot of URDF on wheels, and that its project lacks."""
        robot = self.models[0] if self.is_urdf and self.models else None
        if robot is None or not robot.is_complete or not robot.tree.roots or not self.has_ros_files:
            return ()
        if not any(map(_is_wheel, robot.joints)):
            return ()
        from sdfcheck.robot.ros_files import missing_bases

        return tuple(missing_bases(self.document, {link.name for link in robot.links}))

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
        return cast("Scope | None", super().scope_of(element))

    def class_of(self, holder: Part, element: Element) -> type[Part]:
        return part_class(holder, element)

    def _listed(self, kind: str) -> Iterable[Any]:
        return SPECIAL[kind](self) if kind in SPECIAL else self._written(kind)

    def _written(self, name: str) -> Iterator[Any]:
        index = self.elements
        elements = [element for tag in ELEMENTS.get(name, ()) for element in index.get(tag, ())]
        return self.made_of(elements, name) if elements else iter(())

    def made_of(self, elements: Iterable[Element], kind: str) -> Iterator[Any]:
        """The parts of a class that elements of this file make; that of ``robot`` is its model."""
        cls = _NAMED[kind]
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

        return tuple(frame_references(self))

    @lazy
    def rings(self) -> tuple[FrameCycle, ...]:
        """The frames that are attached to, or placed relative to, each other in a ring."""
        if not self.frame_references:
            return ()

        return rings(self)

    @lazy
    def parent_joints(self) -> dict[Link, list[Joint]]:
        """Link → the joints of this file that carry it, wherever they are; without those that only Gazebo adds."""
        if not (joints := [joint for joint in self.each("Joint") if joint.holder.kind != "gazebo"]):
            return {}
        from sdfcheck.robot.graph import parents_in

        return parents_in(joints)

    @lazy
    def loops(self) -> list[list[Joint]]:
        """The joints of this file that lead round in a circle, whichever world or model they are in."""
        if not self.parent_joints:
            return []
        from sdfcheck.robot.graph import loops

        return loops(self.parent_joints, self.each("Joint"))

    @lazy
    def elements(self) -> Mapping[str, list[Element]]:
        """The standard elements by name, those in ``<gazebo>`` blocks as well."""
        if self.is_urdf:
            from sdfcheck.formats.urdf.survey import survey as urdf_survey

            index = urdf_survey(self.document).index
            if not index.get("gazebo"):
                return index
            from sdfcheck.robot.graph import with_extensions

            return with_extensions(index)
        return self._survey.index

    @property
    def _survey(self) -> Survey:
        return survey(self.document)

    @property
    def mass_properties(self) -> MassProperties | None:
        """Mass (kg), center of mass (m) and inertia (kg·m²) of everything that is not static, all joints at zero.

        In the frame of the world, or of the only model; None without mass. Raises DescriptionError.
        """
        from sdfcheck.robot.motion.mass_report import mass_report

        return mass_report(self.scopes).total

    # Parts by name

    def world(self, key: str | int) -> World:
        """A world by name or index; raises NotFound."""
        return pick(self, "world", self.worlds, key)

    def model(self, key: str | int) -> Model:
        """A model that is in no world, by name or index; raises NotFound."""
        return pick(self, "model", self.models, key)


_NAMED = {
    cls.__name__: cls
    for cls in (*_CLASSES.values(), *_OF_CONTROL.values(), Custom, Setting, Part, Resource, Root)
}
"""The classes by their names."""


def root_of(document: Document) -> Root:
    """The root of a document of SDFormat or URDF, read once."""
    return document.view(Root)


# References: the names of frames that poses, attachments and axes write.


_SEVEN = Version(1, 7)


class FrameReference:
    """The name of a frame in SDFormat, as it is written.

    ``role`` is ``relative_to`` (of a pose, also where it was called ``frame``),
    ``attached_to`` (of a frame) or ``expressed_in`` (of an axis).
    """

    __slots__ = ("__dict__", "role", "root", "value")

    def __init__(self, root: Root, role: str, value: Value) -> None:
        self.root = root
        self.role = role
        self.value = value

    def __repr__(self) -> str:
        return f"FrameReference({self.role} {self.name!r})"

    @property
    def name(self) -> str:
        """The name that it writes."""
        return self.value.text.strip()

    @property
    def span(self) -> Span:
        """The place of the name."""
        return self.value.span

    @property
    def owner_element(self) -> Element:
        """The element that it is about: what has the pose, the frame, or the ``xyz`` of the axis."""
        element = self.value.element
        parent = element.parent if element.name == "pose" else None
        return element if parent is None else parent

    @property
    def owner(self) -> Part:
        """The part that it is about."""
        return self.root.part_of(self.owner_element)

    @lazy
    def scope(self) -> Scope | None:
        """The world or model in which the name is looked up; None around what is at the top of the file."""
        return self.root.scope_of(self.owner_element)

    @lazy
    def target(self) -> Node | None:
        """The node that it names; None if the name is unknown."""
        return None if self.scope is None else self.scope.resolve(self.name)

    @property
    def is_extension(self) -> bool:
        """Is it in a ``<gazebo>`` block of a URDF file?"""
        return self.root.is_urdf

    @property
    def is_unresolved(self) -> bool:
        """Does it surely name nothing?"""
        return self.scope is not None and self.scope.lacks(self.name)


def frame_references(root: Root) -> Iterator[FrameReference]:
    """The references to frames in SDFormat, also in ``<gazebo>`` blocks; those that nobody reads are left out."""
    surveyed = survey(root.document)
    for pose in surveyed.index.get("pose", ()):
        for name, text in pose.attributes.items():
            is_read = name == "relative_to" or (name == "frame" and surveyed.version < _SEVEN)
            if is_read and text.strip():
                reference = FrameReference(root, "relative_to", Value(pose, name, text))
                if reference.owner_element.name != "inertial" and not _is_in_state(pose):
                    yield reference
    for kind, role in (("xyz", "expressed_in"), ("frame", "attached_to")):
        for element in surveyed.index.get(kind, ()):
            value = element.attribute(role)
            if value is not None and value.text.strip() and not _is_in_state(element):
                yield FrameReference(root, role, value)


def _is_in_state(element: Element) -> bool:
    """Is it in a ``<state>``, whose frames libsdformat does not read?"""
    return any(around.name == "state" for around in element.around)


# Rings among frames: what is attached to, or placed relative to, itself by way of others.

_Step = tuple[Value | None, Node | None]
"""The reference that leads on from a node (None where it is implied), and where to."""


class FrameCycle(Record):
    """Frames that are attached to, or placed relative to, each other in a ring.

    ``role`` is ``attached_to`` or ``relative_to``. ``members`` are the references that make
    the ring, ``names`` the frames that hold them; both begin with the first of this file.
    """

    role: str
    members: tuple[Value, ...]
    names: tuple[str, ...]
    cause: Span | None
    """The place of a misspelled pose or reference without which there may be no ring."""


def rings(root: Root) -> tuple[FrameCycle, ...]:
    """The rings that references of this file take part in."""
    starts = [
        node
        for reference in root.frame_references
        if reference.role != "expressed_in" and (node := _node(reference.owner)) is not None
    ]
    # A reported ring of attachments contains a frame: rings of joints alone are left out.
    has_frames = bool(root.includes) or any(each.role == "attached_to" for each in root.frame_references)
    attached = _search("attached_to", starts, _attachment) if has_frames else ()
    return (*attached, *_search("relative_to", starts, _placement))


def _node(part: Part) -> Node | None:
    """The node that a part is, or that an include makes."""
    if part.kind == "include":
        return cast("Include", part).node
    return part if isinstance(part, Node) else None


def _attachment(node: Node) -> _Step:
    """The node that a node moves with."""
    value = None
    if isinstance(node, Frame):
        value = node.attached_to_value
    elif isinstance(node, Joint):
        value = node.child_value
    return (None, None) if value is None else (value, node.look_up(value.text.strip()))


def _placement(node: Node) -> _Step:
    """The node that a node is placed relative to: at the end, the model around it."""
    value = _pose_reference(node)
    if value is not None:
        return value, node.look_up(value.text.strip())
    value, on = _attachment(node)
    if value is not None:
        return value, on
    around = node.merged or node.holder
    return None, around if isinstance(around, Node) and around.kind != "world" else None


def _pose_reference(node: Node) -> Value | None:
    """The reference of the pose of a node that something is around."""
    if not isinstance(node.holder, Scope):
        return None
    value = reference_value(node.pose_element)
    return value if value is not None and value.text.strip() else None


def _search(role: str, starts: list[Node], step: Callable[[Node], _Step]) -> list[FrameCycle]:
    found: list[FrameCycle] = []
    done: set[Node] = set()
    for start in starts:
        path: dict[Node, Value | None] = {}
        at: Node | None = start
        while at is not None and at not in done and at not in path:
            path[at], at = step(at)
        if at is not None and at in path:
            nodes = list(path)
            ring = _ring(role, nodes[nodes.index(at) :], path)
            found += [] if ring is None else [ring]
        done.update(path)
    return found


def _ring(role: str, nodes: list[Node], path: Mapping[Node, Value | None]) -> FrameCycle | None:
    if role == "attached_to" and all(isinstance(node, Joint) for node in nodes):
        return None  # what joints lead to is their own matter
    if role == "relative_to" and all(_pose_reference(node) is None for node in nodes):
        return None  # the ring of attachments
    members = [(value, node.name) for node in nodes if (value := path[node]) is not None]
    document = nodes[0].root.document
    own = [at for at, (value, _) in enumerate(members) if value.element.document is document]
    if not own:
        return None  # it is reported in its own file
    first = min(own, key=lambda at: members[at][0].span.start)
    members = members[first:] + members[:first]
    cause = next(filter(None, map(_misspelled_reference, nodes)), None)
    return FrameCycle(role, tuple(value for value, _ in members), tuple(name for _, name in members), cause)


def _misspelled_reference(node: Node) -> Span | None:
    pose = node.pose_element
    return node.misnamed("pose") if pose is None else node.part(pose).misnamed("relative_to")
