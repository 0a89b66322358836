"""What is wrong with a URDF robot as a whole: its tree, its masses, and what refers to its parts."""

from __future__ import annotations

from sdfcheck.source.element import Element, Value
from sdfcheck.source.record import Record


class SeveralRoots(Record):
    """A second tree of links; ``root`` is the link at its top, ``main`` that of the largest tree."""

    root: Element
    main: Element
    size: int


class DisconnectedLink(Record):
    """A link that no joint names, in a robot of several."""

    link: Element
    main: Element


class MisnamedLink(Record):
    """A link that no joint names, where ``ends`` of joints agree on a name that is nearly its own."""

    value: Value
    meant: str
    ends: tuple[Value, ...]


class RootWithInertia(Record):
    """The root link has mass, which KDL drops."""

    link: Element
    inertial: Element


class VanishingRoot(Record):
    """A link at the top of the tree without mass: libsdformat drops it with all ``links`` of its tree.

    ``massless``: no link of the robot has any.
    """

    link: Element
    links: int
    massless: bool


class MasslessMovingLink(Record):
    """A link without mass, neither its own nor of links fixed to it, below a joint that stays a joint.

    That is one that moves, or a fixed one that libsdformat is told to keep. ``mass`` is the value where one
    is written; ``lost`` counts the link and those below it.
    """

    link: Element
    joint: Element
    mass: Value | None
    lost: int


class UndefinedMaterial(Record):
    """A visual names a material that is not defined; ``later`` is a definition that comes too late."""

    value: Value
    suggestion: str | None
    later: Value | None
    uses: int


class EmptyMaterial(Record):
    """A material of the robot that defines neither colour nor texture."""

    material: Element


class DifferentMaterial(Record):
    """A material defined again with another colour or texture: readers take the first, or refuse it."""

    value: Value
    first: Value


class UnknownTransmissionJoint(Record):
    value: Value
    transmission: Element
    suggestion: str | None


class UnknownControlJoint(Record):
    """A joint of ``<ros2_control>`` that the robot does not have."""

    value: Value
    control: Element
    suggestion: str | None


class UnreferencedExtension(Record):
    """A ``<gazebo>`` whose ``reference`` is no link or joint; ``kind`` says what else has that name."""

    value: Value
    suggestion: str | None
    kind: str | None


class DelimiterInExtension(Record):
    """``::`` in a name inside ``<gazebo>``."""

    value: Value
    extension: Element


class MimicOfFixedJoint(Record):
    """A mimic whose leader cannot move; ``leader`` is where its type is written."""

    value: Value
    joint: Element
    leader: Value


class UnconvertedJoint(Record):
    """A joint of a type that SDFormat does not have; ``value`` is the type."""

    value: Value
    joint: Element


class SingularPitch(Record):
    """A pitch so near to 90° that urdfdom takes it for 90°; ``error`` in radians."""

    value: Value
    pitch: float
    error: float
