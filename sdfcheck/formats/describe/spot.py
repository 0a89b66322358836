"""The definition of a place that is known by the names of the elements around it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from sdfcheck.formats.describe.description import Description, UnknownPlace
from sdfcheck.formats.schema import Definition
from sdfcheck.formats.sdf.schema import schema
from sdfcheck.formats.urdf.schema import urdf
from sdfcheck.formats.version import NEWEST, Version
from sdfcheck.source.record import NamedTuple

_TRANSPARENT = frozenset({"xacro:if", "xacro:unless"})
_EXTENDED = ("model/link", "model/joint", "model", "model/link/collision", "model/link/visual")
"""Where what a ``<gazebo>`` block holds belongs in SDFormat."""
_IN_MACROS = {
    "sdf": (
        "model",
        "model/link",
        "model/joint",
        "world",
        "model/link/visual",
        "model/link/visual/geometry",
        "model/link/inertial",
    ),
    "robot": ("", "link", "joint", "link/visual", "link/inertial", "link/visual/geometry"),
}
"""Where the content of a macro may belong, by the name of the root."""


class Spot(NamedTuple):
    """A place of a format: an element, and its parent."""

    definition: Definition
    parent: Definition | None = None

    @property
    def is_block(self) -> bool:
        """Is it a ``<gazebo>`` block of URDF, which holds SDFormat, too?"""
        return self.definition.place == "gazebo:gazebo"

    @property
    def is_open(self) -> bool:
        """Is anything allowed inside?"""
        return self.definition.open and not self.is_block

    def describe(self, attribute: str = "") -> Description | None:
        """The definition of the element, or of an attribute of it; None for one that is unknown."""
        from sdfcheck.formats.describe.definition import describe_attribute, describe_definition

        if not attribute:
            return describe_definition(self.parent, self.definition)
        known = attribute in self.definition.attributes
        return describe_attribute(self.definition, attribute) if known else None


def spot(names: Sequence[str], version: Version = NEWEST) -> Spot | None:
    """The place to which the names of elements lead, from the root's on; None where no format has one.

    The content of a macro of xacro belongs where the macro is, or in a model, link or joint.
    """
    first, *inner = [name for name in names if name not in _TRANSPARENT] or [""]
    if first not in _IN_MACROS:
        return None
    root = Spot(schema(version).root if first == "sdf" else urdf())
    last = max((number for number, name in enumerate(inner) if name.startswith("xacro:")), default=-1)
    if last < 0:
        return _inside(root, inner, version)
    around = "/".join(name for name in inner[:last] if not name.startswith("xacro:"))
    for place in (around, *_IN_MACROS[first]):
        holder = _inside(root, filter(None, place.split("/")), version)
        found = None if holder is None else _inside(holder, inner[last + 1 :], version)
        if found is not None and (found is not holder or place == around):
            return found
    return None


def _inside(start: Spot, names: Iterable[str], version: Version) -> Spot | None:
    at, waiting = start, list(names)
    while waiting:
        definition = at.definition
        known = definition.children.get(waiting[0])
        if at.is_block and (known is None or len(waiting) > 1):
            return _in_block(waiting, version)
        if at.is_open or known is None:
            return None
        at = Spot(known, definition)
        del waiting[0]
    return at


def _in_block(names: list[str], version: Version) -> Spot | None:
    """Elements of SDFormat in a ``<gazebo>`` block."""
    for place in _EXTENDED:
        holder = schema(version).root.at(place)
        found = None if holder is None else _inside(Spot(holder), names, version)
        if found is not None:
            return found
    return None


def describe_custom(
    name: str, outer: Sequence[str], tables: Mapping[str, Path], *, is_urdf: bool
) -> Description | None:
    """The entry of a vendor's table for a prefixed element or attribute (``@name``, ``element/@name``)."""
    from sdfcheck.formats.describe.vendor import describe_vendor

    own = tuple(name.split("/"))
    prefix = own[0].removeprefix("@").partition(":")[0]
    wanted = "(URDF)" if is_urdf else "(SDFormat)"
    for steps in ((*outer[-1:], *own), own):
        try:
            found = describe_vendor(prefix, steps, tables)
        except UnknownPlace:
            continue
        return next((one for one in found if one.format.endswith(wanted)), found[0])
    return None
