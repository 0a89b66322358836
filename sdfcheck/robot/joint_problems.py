"""What can be wrong with the joints of a robot, said alike for SDFormat and URDF.

``refused`` tells where the formats differ: the condition keeps some reader of this
dialect from building the robot that is written.
"""

from __future__ import annotations

from sdfcheck.source.element import Element, Value
from sdfcheck.source.record import Record


class UnknownJointEnd(Record):
    """A parent or child that names nothing in scope.

    ``role`` is ``parent`` or ``child``. ``suggestion`` is the name that was probably
    meant: a near miss, or the scoped name of what exists elsewhere. ``outside``: an
    enclosing scope has the name, which cannot be reached from here. ``others``: further
    ends with the same name, which are not reported apart.
    """

    value: Value
    joint: Element
    role: str
    suggestion: str | None = None
    outside: Element | None = None
    others: tuple[Value, ...] = ()


class DetachedFrame(Record):
    """A joint's end that moves with no link, because ``model``, to which it leads, is static."""

    value: Value
    joint: Element
    role: str
    model: Element


class SelfJoint(Record):
    """Parent and child are one link; ``link`` is its name where they are spelt differently."""

    child: Value
    parent: Value
    joint: Element
    link: str | None = None


class WorldAsChild(Record):
    """The world hangs below a link."""

    child: Value
    joint: Element


class SeveralParents(Record):
    """A link that is child of more than one joint; ``child`` is where the later joint names it."""

    child: Value
    first: Value
    link: str
    joints: tuple[str, ...]
    refused: bool


class JointLoop(Record):
    """Joints that lead from a link back to it. Reported once, at the first in document order.

    ``ends`` are, along the loop, the places where each joint names its child; ``links`` the
    names of those links.
    """

    ends: tuple[Value, ...]
    links: tuple[str, ...]
    refused: bool


class UnknownMimicLeader(Record):
    """A mimic that follows a joint which does not exist, or (``axis``) an axis that its leader lacks."""

    value: Value
    joint: Element
    suggestion: str | None = None
    axis: str | None = None


class MimicCycle(Record):
    """Joints that follow each other round in a circle (one alone: it follows itself).

    ``leaders`` are the places where each names the next; ``joints`` their names.
    """

    leaders: tuple[Value, ...]
    joints: tuple[str, ...]


Problem = (
    UnknownJointEnd
    | DetachedFrame
    | SelfJoint
    | WorldAsChild
    | SeveralParents
    | JointLoop
    | UnknownMimicLeader
    | MimicCycle
)
