"""Models: robots and everything else that has links."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Protocol, TypeVar, cast

from sdfcheck.robot.scope import Scope
from sdfcheck.robot.values import is_true, lazy

if TYPE_CHECKING:
    from sdfcheck.robot.motion.mass_properties import MassProperties
    from sdfcheck.robot.motion.rotations import Array
    from sdfcheck.robot.motion.tree import Tree
    from sdfcheck.robot.naming.link_names import LinkNames
    from sdfcheck.robot.naming.material_names import MaterialNames
    from sdfcheck.robot.naming.unresolved import Unresolved
    from sdfcheck.robot.node import Node
    from sdfcheck.robot.part import Part
    from sdfcheck.robot.parts.actuation import Transmission
    from sdfcheck.robot.parts.control import Ros2Control
    from sdfcheck.robot.parts.control_component import ControlComponent
    from sdfcheck.robot.parts.gazebo import GazeboBlock
    from sdfcheck.robot.parts.joint import Joint
    from sdfcheck.robot.parts.link import Link
    from sdfcheck.robot.parts.material import Material
    from sdfcheck.robot.parts.plugin import Plugin
    from sdfcheck.source.element import Element, Value

Built_co = TypeVar("Built_co", covariant=True)
_BOOLEANS = frozenset({"", "true", "1", "false", "0"})


class Builder(Protocol[Built_co]):
    """A consumer of which it is known what it makes of a robot."""

    def build(self, robot: Model) -> Built_co:
        """The robot that it makes of one."""


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
        return self.is_readable and super().is_complete

    def _fill(self, nodes: dict[str, Node]) -> None:
        if self.is_readable:
            super()._fill(nodes)

    # Content

    @property
    def plugins(self) -> tuple[Plugin, ...]:
        """The plugins of the model; in URDF those of its ``<gazebo>`` blocks without reference."""
        if self.is_urdf:
            blocks = (block for block in self.gazebo_blocks if not block.reference)
            return tuple(plugin for block in blocks for plugin in block.plugins)
        return tuple(self._parts("plugin"))

    @property
    def materials(self) -> tuple[Material, ...]:
        """The materials that a URDF robot defines for all its links."""
        return tuple(self._parts("material")) if self.is_urdf else ()

    @lazy
    def materials_by_name(self) -> dict[str, Material]:
        """The materials that a URDF robot defines, by name; of two of one name the first."""
        found: dict[str, Material] = {}
        for material in self.materials:
            found.setdefault(material.name, material)
        return found

    @property
    def transmissions(self) -> tuple[Transmission, ...]:
        """The transmissions of a URDF robot."""
        return tuple(self._parts("transmission")) if self.is_urdf else ()

    @lazy
    def ros2_control(self) -> tuple[Ros2Control, ...]:
        """The ``ros2_control`` blocks of a URDF robot."""
        return tuple(self._parts("ros2_control")) if self.is_urdf else ()

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
    def control_by_name(self) -> dict[str, Ros2Control]:
        """The ``ros2_control`` blocks of a URDF robot, by name; of two of one name the first."""
        found: dict[str, Ros2Control] = {}
        for block in self.ros2_control:
            found.setdefault(block.name, block)
        return found

    @property
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
        from sdfcheck.robot.kinds import class_named

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
    def driven_names(self) -> frozenset[str]:
        """In URDF: the names of all joints that something can drive, Drake's own (``drake:joint``) among them."""
        own = (joint.attributes.get("name", "") for joint in self.children("drake:joint"))
        return frozenset((*self.joints_by_name, *own))

    @lazy
    def unresolved(self) -> Unresolved:
        return self.link_names.unknown if self.is_urdf else super().unresolved

    @lazy
    def lost_names(self) -> frozenset[str]:
        return frozenset(self.link_names.explained) if self.is_urdf else super().lost_names

    @lazy
    def link_names(self) -> LinkNames:
        """In URDF: the names by which joints call links, and those that the links have."""
        from sdfcheck.robot.naming.link_names import LinkNames

        return LinkNames(self)

    @lazy
    def material_names(self) -> MaterialNames:
        """In URDF: what the names of its materials reach."""
        from sdfcheck.robot.naming.material_names import MaterialNames

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
        from sdfcheck.robot.access.lookup import pick

        return pick(self, "link", self.links, key)

    def all_links(self) -> Iterator[Link]:
        """The links of the model and of all models in it."""
        return (cast("Link", node) for _, node in self.all_nodes() if node.kind == "link")
