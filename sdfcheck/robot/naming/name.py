"""One name that a file gives, and one that reaches nothing."""

from __future__ import annotations

from sdfcheck.robot.reserved import NODES
from sdfcheck.source.document import Element, Value
from sdfcheck.source.record import NamedTuple

DEFAULT = "__default__"
"""The word of the format for nothing in particular."""


class UnknownName(NamedTuple):
    """A name that a part writes and nothing of its ``kind`` has in ``scope``; ``names`` are those that are there."""

    value: Value
    kind: str
    scope: Element
    names: tuple[str, ...]


class Name(NamedTuple):
    """The name of a part: ``kind`` is the kind that it counts as, ``parent`` the part that it is in.

    For an include that gives no name of its own ``value`` is the uri that brings it, and
    so for the parts of a model that it merges (``is_merged``).
    """

    kind: str
    name: str
    value: Value
    parent: Element
    is_merged: bool = False
    is_extension: bool = False
    """Is it in a ``<gazebo>`` block of a URDF file?"""

    @property
    def makes_frame(self) -> bool:
        """Is it the name of a frame?"""
        return self.kind in NODES

    @property
    def is_compared(self) -> bool:
        """Does libsdformat compare it with the names that it reserves?"""
        from sdfcheck.formats.history import reserved_name_holders

        return self.kind in reserved_name_holders()


class Namesakes(NamedTuple):
    """Two siblings that share a name."""

    first: Name
    later: Name
