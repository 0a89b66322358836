"""The definition of a place that is known by the names of the elements around it."""

from __future__ import annotations

from collections.abc import Sequence

from sdfcheck.formats.describe.description import Description, UnknownPlace
from sdfcheck.formats.sdf.schema import Definition, schema
from sdfcheck.formats.sdf.version import NEWEST, Version
from sdfcheck.formats.urdf.table import UrdfElement, extension, urdf
from sdfcheck.source.record import NamedTuple

_TRANSPARENT = frozenset({"xacro:if", "xacro:unless"})
_EXTENDED = (
    "sdf/model/link",
    "sdf/model/joint",
    "sdf/model",
    "sdf/model/link/collision",
    "sdf/model/link/visual",
)
"""Where what a ``<gazebo>`` block holds belongs in SDFormat."""

_IN_MACROS = (
    ("model",),
    ("model", "link"),
    ("model", "joint"),
    ("world",),
    ("model", "link", "visual"),
    ("model", "link", "visual", "geometry"),
    ("model", "link", "inertial"),
)
"""Where the content of a macro may belong in SDFormat."""


class Spot(NamedTuple):
    """A place of a format: an element of SDFormat with its parent, or one of URDF with the names that lead there."""

    definition: Definition | None = None
    parent: Definition | None = None
    urdf: UrdfElement | None = None
    path: tuple[str, ...] = ()

    @property
    def is_open(self) -> bool:
        """Is anything allowed inside?"""
        if self.definition is not None:
            return self.definition.open
        return self.urdf is not None and self.urdf.open and self.urdf.name != "gazebo"

    def describe(self, attribute: str = "") -> Description | None:
        """The definition of the element, or of an attribute of it; None for one that is unknown."""
        if self.definition is not None:
            from sdfcheck.formats.describe import sdf

            if not attribute:
                return sdf.describe_definition(self.parent, self.definition)
            known = attribute in self.definition.attributes
            return sdf.describe_attribute(self.definition, attribute) if known else None
        if self.urdf is not None:
            from sdfcheck.formats.describe import urdf as tables

            if not attribute:
                return tables.describe_definition(self.path, self.urdf)
            known = attribute in self.urdf.attributes
            return tables.describe_attribute(self.path, self.urdf, attribute) if known else None
        return None


def spot(names: Sequence[str], version: Version = NEWEST) -> Spot | None:
    """The place to which the names of elements lead, from the root's on; None where no format has one."""
    plain = [name for name in names if name not in _TRANSPARENT]
    if not plain:
        return None
    if plain[0] == "sdf":
        return _in_sdf_or_macro(plain[1:], version)
    if plain[0] != "robot":
        return None
    for number, name in enumerate(plain):
        if name.startswith("xacro:"):
            return _in_macro(plain[number + 1 :], version)
    return _in_urdf(plain, version)


def _in_sdf_or_macro(names: Sequence[str], version: Version) -> Spot | None:
    """A place of SDFormat, or one in a macro of xacro, whose content belongs where it is, or in a model or link."""
    start = Spot(schema(version).root)
    last = max((number for number, name in enumerate(names) if name.startswith("xacro:")), default=-1)
    if last < 0:
        return _in_sdf(start, names)
    around = tuple(name for name in names[:last] if not name.startswith("xacro:"))
    for place in (around, *_IN_MACROS):
        holder = _in_sdf(start, place)
        found = None if holder is None else _in_sdf(holder, names[last + 1 :])
        if found is not None and (found is not holder or place == around):
            return found
    return None


def _in_sdf(start: Spot, names: Sequence[str]) -> Spot | None:
    at = start
    for name in names:
        definition = at.definition
        if definition is None or definition.open or name not in definition.children:
            return None
        at = Spot(definition.children[name], definition)
    return at


def _in_urdf(names: Sequence[str], version: Version) -> Spot | None:
    at = urdf()
    for number, name in enumerate(names[1:], 2):
        if name not in at.children:
            return None
        at = at.children[name]
        if name == "gazebo" and len(names) > number:
            return _in_gazebo(names[number:], version)
    return Spot(urdf=at, path=tuple(names))


def _in_gazebo(names: Sequence[str], version: Version) -> Spot | None:
    """The content of a ``<gazebo>`` block: settings of its own, or elements of SDFormat."""
    own = extension().children.get(names[0])
    if own is not None and len(names) == 1:
        return Spot(urdf=own, path=("robot", "gazebo", names[0]))
    for place in _EXTENDED:
        start = _in_sdf(Spot(schema(version).root), place.split("/")[1:])
        found = None if start is None else _in_sdf(start, names)
        if found is not None:
            return found
    return None


def _in_macro(names: Sequence[str], version: Version) -> Spot | None:
    """The content of a macro or a block of xacro: parts of a robot, of a link or of a joint."""
    if not names:
        return Spot(urdf=urdf(), path=("robot",))
    robot = urdf()
    for around in ("", "link", "joint", "link/visual", "link/inertial", "link/visual/geometry"):
        holder = robot.at(around)
        if holder is not None and names[0] in holder.children:
            path = ("robot", *filter(None, around.split("/")))
            return _below(holder, path, names, version)
    return None


def _below(holder: UrdfElement, path: tuple[str, ...], names: Sequence[str], version: Version) -> Spot | None:
    if path == ("robot",):
        return _in_urdf(["robot", *names], version)
    at = holder
    for name in names:
        if name not in at.children:
            return None
        at, path = at.children[name], (*path, name)
    return Spot(urdf=at, path=path)


def describe_custom(name: str, outer: Sequence[str], *, is_urdf: bool) -> Description | None:
    """The entry of a vendor's table for a prefixed element or attribute (``@name``, ``element/@name``)."""
    from sdfcheck.formats.describe.vendor import describe_vendor

    own = tuple(name.split("/"))
    prefix = own[0].removeprefix("@").partition(":")[0]
    wanted = "(URDF)" if is_urdf else "(SDFormat)"
    for steps in ((*outer[-1:], *own), own):
        try:
            found = describe_vendor(prefix, steps)
        except UnknownPlace:
            continue
        return next((one for one in found if one.format.endswith(wanted)), found[0])
    return None
