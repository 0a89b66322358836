"""Links."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, cast

from sdfcheck.robot.node import Node
from sdfcheck.robot.parts.inertial import Inertial
from sdfcheck.robot.values import lazy, parts
from sdfcheck.source.sniff import Kind

if TYPE_CHECKING:
    from sdfcheck.bodies.box import Box
    from sdfcheck.robot.model import Model
    from sdfcheck.robot.motion.mass_properties import MassProperties
    from sdfcheck.robot.motion.rotations import Array
    from sdfcheck.robot.parts.gazebo import GazeboBlock
    from sdfcheck.robot.parts.joint import Joint
    from sdfcheck.robot.parts.light import Light
    from sdfcheck.robot.parts.plugin import Plugin
    from sdfcheck.robot.parts.sensor import Sensor
    from sdfcheck.robot.parts.shape import Collision, Shape, Visual


class Link(Node):
    """A rigid body."""

    __slots__ = ()
    kind = "link"

    @property
    def model(self) -> Model:
        """The model that it is part of."""
        return cast("Model", self.holder)

    @property
    def is_static(self) -> bool:
        """Is it part of something that does not move?"""
        return bool(getattr(self.holder, "is_static", False))

    @property
    def may_be_static(self) -> bool:
        """Is it part of something that does not move, or of which that cannot be read?"""
        return bool(getattr(self.holder, "may_be_static", False))

    @lazy
    def inertial(self) -> Inertial:
        """Its mass and inertia; with ``is_given`` False where nothing is written."""
        return self._only("inertial", Inertial)

    @property
    def has_mass(self) -> bool:
        """Is its mass other than 0? In URDF a text that is not a number counts, for it is reported for itself."""
        return self.inertial.has_mass

    visuals: lazy[tuple[Visual, ...]] = parts("visual", "The visible shape of it.")
    collisions: lazy[tuple[Collision, ...]] = parts("collision", "The shape of it that touches other things.")

    @property
    def shapes(self) -> tuple[Shape, ...]:
        """Its visuals and collisions."""
        return (*self.visuals, *self.collisions)

    @lazy
    def solids(self) -> tuple[Shape, ...]:
        """The primitive shapes whose place in it is known: of its collisions, or of its visuals if it has none.

        None in a macro of xacro, where more may be added.
        """
        if self.document.kind is Kind.XACRO:
            return ()
        shapes: tuple[Shape, ...] = self.collisions or self.visuals
        return tuple(
            shape for shape in shapes if shape.geometry.solid is not None and shape.position is not None
        )

    @property
    def sensors(self) -> tuple[Sensor, ...]:
        """Its sensors; in URDF those of the ``<gazebo>`` blocks about it."""
        blocks = (sensor for block in self.gazebo_blocks for sensor in block.sensors)
        return (*(() if self.is_urdf else self._parts("sensor")), *blocks)

    @property
    def lights(self) -> tuple[Light, ...]:
        """Its lights; in URDF those of the ``<gazebo>`` blocks about it."""
        blocks = (light for block in self.gazebo_blocks for light in block.lights)
        return (*(() if self.is_urdf else self._parts("light")), *blocks)

    @property
    def plugins(self) -> tuple[Plugin, ...]:
        """The plugins of the ``<gazebo>`` blocks about it."""
        return tuple(plugin for block in self.gazebo_blocks for plugin in block.plugins)

    @property
    def gazebo_blocks(self) -> tuple[GazeboBlock, ...]:
        """The ``<gazebo>`` blocks about it, in URDF."""
        return tuple(self.model.blocks_by_reference.get(self.name, ())) if self.is_urdf else ()

    @lazy
    def box(self) -> Box | None:
        """The box around its collisions, or its visuals where it has none of known size (m), in plain numbers."""
        from sdfcheck.robot.motion.bounds import of_shapes

        return of_shapes(self.collisions) or of_shapes(self.visuals)

    @property
    def bounds(self) -> Array | None:
        """The box around its collisions, or its visuals where it has none: lowest and highest x, y, z.

        In m, in its frame, shape (2, 3), meshes included; None where no shape has a known size.
        """
        from sdfcheck.robot.motion.bounds import as_array

        return as_array(self.box)

    @lazy
    def visual_box(self) -> Box | None:
        """The box around its visuals (m); None unless the size of each of them is known."""
        return self._around(self.visuals)

    @lazy
    def collision_box(self) -> Box | None:
        """The box around its collisions (m); None unless the size of each of them is known."""
        return self._around(self.collisions)

    @lazy
    def extent(self) -> Box | None:
        """The box around its visuals and collisions (m); of either kind only if the size of each is known."""
        from sdfcheck.bodies.box import around

        return around((self.visual_box, self.collision_box))

    @lazy
    def fixed_extent(self) -> Box | None:
        """The same, with the links that fixed joints of URDF tie to it from below; None unless all are known."""
        from sdfcheck.robot.motion.bounds import with_fixed

        return with_fixed(self)

    def _around(self, shapes: tuple[Shape, ...]) -> Box | None:
        """The box around shapes that are all known; None in a macro of xacro, where more may be added."""
        if self.document.kind is Kind.XACRO:
            return None
        from sdfcheck.robot.motion.bounds import of_shapes

        return of_shapes(shapes) if all(shape.box is not None for shape in shapes) else None

    @lazy
    def has_mesh(self) -> bool:
        """Has it a shape whose mesh file is there?"""
        if not self.document.source.contains("<mesh") and not self.document.source.contains(":mesh"):
            return False
        return any(shape.geometry.mesh is not None for shape in self.shapes)

    @lazy
    def size_to_reach(self) -> float:
        """Its greatest length to the longest distance between joints of its model; nan where one is not known."""
        reach = self.model.reach if self.holder is not None and self.holder.kind == "model" else 0.0
        box = self.box if reach else None
        return max(box.size) / reach if box is not None else math.nan

    @property
    def counterparts(self) -> tuple[Link, ...]:
        """The other links of its model whose names differ only by the side: those of the other wheels or legs."""
        from sdfcheck.robot.naming.sides import without_sides

        key = without_sides(self.name)
        if key == self.name:
            return ()
        links = self.model.links
        return tuple(link for link in links if link is not self and without_sides(link.name) == key)

    # How it hangs together with others

    @property
    def parent_joints(self) -> tuple[Joint, ...]:
        """The joints whose child it is; more than one is a mistake, or closes a loop."""
        return tuple(self.model.tree.parents.get(self, ()))

    @property
    def child_joints(self) -> tuple[Joint, ...]:
        """The joints whose parent it is."""
        return tuple(self.model.tree.children.get(self, ()))

    def below(self) -> Iterator[Link]:
        """The link and all links that hang on it, each once."""
        return self.model.tree.below(self)

    @property
    def mass_properties(self) -> MassProperties | None:
        """Mass (kg), center of mass (m) and inertia (kg·m²) in its frame; None where the format gives none.

        An inertia that the simulator computes (``auto="true"``) is computed. Raises
        DescriptionError for numbers that cannot be read and shapes that cannot be measured.
        """
        from sdfcheck.robot.motion.mass import of_link

        return of_link(self)
