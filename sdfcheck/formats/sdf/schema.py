"""What SDFormat allows where, for each of its versions.

The walk over a document asks for plain attributes only: ``definition.children.get(tag)``,
``definition.attributes.get(name)``, ``definition.accepts(text)``. They are built at their
first use, so that a document pays for the part of the format that it uses.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any

from sdfcheck.formats.sdf.row_in_version import RowInVersion
from sdfcheck.formats.sdf.table import Row, at, block, newest_name
from sdfcheck.formats.sdf.version import Version

NOT_GIVEN = "__default__"
"""The default that means "not given": no value would be sensible."""

_NEEDED = frozenset(
    """
    attenuation/range battery/voltage blend/fade_dist blend/min_height
    box/size capsule/length capsule/radius cone/length cone/radius cylinder/length cylinder/radius
    ellipsoid/radii image/height image/scale image/width polyline/height polyline/point sphere/radius
    intrinsics/cx intrinsics/cy intrinsics/fx intrinsics/fy
    axis/xyz axis2/xyz inertia/ixx inertia/iyy inertia/izz
    joint/child joint/parent
    lidar/range lidar/scan ray/range ray/scan range/max range/min scan/horizontal
    horizontal/max_angle horizontal/min_angle horizontal/samples
    logical_camera/aspect_ratio logical_camera/far logical_camera/horizontal_fov logical_camera/near
    population/model road/point sonar/max sonar/min sonar/radius spot/outer_angle
    spherical_coordinates/latitude_deg spherical_coordinates/longitude_deg
    texture/size trajectory/waypoint vertical/max_angle vertical/min_angle vertical/samples
    waypoint/pose waypoint/time
    """.split()
)
"""Required children that make another robot when they are left out, or nothing sensible at all.

libsdformat fills in every required child but the ends of a joint, and says nothing. For
most (the atmosphere of a world, the step of a physics) the default is what an author who
leaves them out expects. Where that depends on something else, ``structure`` decides.
"""


class AttributeDefinition(RowInVersion):
    """An attribute, as one version allows it at one place."""

    __slots__ = ("default", "required", "type")
    type: str
    default: str
    required: bool

    def __init__(self, version: Version, row: Row, place: str) -> None:
        minor = version.minor
        self.row = row
        self.version = version
        self.name = row.name[1:]
        self.place = f"{place}/{row.name}"
        self.type = at(row.type, minor)
        self.default = at(row.default, minor)
        self.required = at(row.multiplicity, minor) == "1"

    def __repr__(self) -> str:
        return f"AttributeDefinition({self.place!r}, {self.version})"

    @property
    def needs_value(self) -> bool:
        """Whether an empty text is refused."""
        return self.required


class Definition(RowInVersion):
    """An element, as one version allows it below one kind of parent.

    ``multiplicity`` (``0``, ``1``, ``+``, ``*``, or ``-1`` for deprecated) is the one written where
    the element is used; libsdformat uses ``own_multiplicity``, that of the definition.
    """

    __slots__ = (
        "_schema",
        "attributes",
        "children",
        "default",
        "deprecated",
        "multiplicity",
        "needed_children",
        "open",
        "own_multiplicity",
        "path",
        "required_attributes",
        "required_children",
        "single",
        "sound",
        "type",
    )
    path: str
    """The names from the element that starts the definition: ``joint/axis/limit/lower``."""
    type: str | None
    """None for an element that holds elements."""
    default: str | None
    deprecated: bool
    open: bool
    """Content is free: nothing inside is the format's business."""
    single: bool
    """At most one below a parent."""
    sound: set[str | None]
    """Texts that ``accepts`` has accepted, remembered by those who walk over documents."""
    attributes: dict[str, AttributeDefinition]
    children: dict[str, Definition]
    required_attributes: tuple[str, ...]
    required_children: tuple[str, ...]
    needed_children: tuple[str, ...]
    """Those of the required children whose silent default makes another robot."""

    def __init__(self, parent: Definition | None, schema: Schema, row: Row, use: Row) -> None:
        minor = schema.version.minor
        self._schema = schema
        self.row = row
        self.version = schema.version
        if row is use and parent is not None:
            self.path = f"{parent.path}/{row.name}"
            self.place = f"{parent.place}/{row.name}"
            self.name = row.name
        else:
            self.path = at(row.extra("name"), minor) or row.name
            self.place = f"{row.name}:{newest_name(row)}"
            self.name = use.name if parent is not None else self.path
        self.type = at(row.type, minor) or None
        self.default = at(row.default, minor) if self.type else None
        self.multiplicity = at(use.multiplicity, minor)
        self.own_multiplicity = (use.extras and at(use.extra("own"), minor)) or self.multiplicity
        self.single = self.multiplicity not in {"*", "+"}
        self.sound = set()
        self.deprecated = row.extras != [] and at(row.extra("deprecated"), minor) != ""
        self.open = row.extras != [] and row.extra("open") != ""

    def __repr__(self) -> str:
        return f"Definition({self.place!r}, {self.version})"

    @property
    def needs_value(self) -> bool:
        """Whether an empty text is refused; elsewhere it means the default."""
        return self.type is not None and self.own_multiplicity == "1"

    def _unfold(self) -> None:
        schema, minor = self._schema, self.version.minor
        self.children = children = {}
        self.attributes = attributes = {}
        for row in self.row.rows:
            if not row.lives(minor):
                continue
            if row.name[0] == "@":
                attributes[row.name[1:]] = AttributeDefinition(self.version, row, self.place)
            else:
                children[row.name] = schema.define(self, row)
        self.required_children = tuple(
            name for name, child in children.items() if child.multiplicity in {"1", "+"}
        )
        self.required_attributes = tuple(name for name, attribute in attributes.items() if attribute.required)
        self.needed_children = tuple(
            name
            for name in self.required_children
            if children[name].default == NOT_GIVEN or f"{self.name}/{name}" in _NEEDED
        )

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            if name not in _UNFOLDED:
                return super().__getattr__(name)
            self._unfold()
            return object.__getattribute__(self, name)


_UNFOLDED = {"attributes", "children", "needed_children", "required_attributes", "required_children"}


class Schema:
    """The format in one version."""

    __slots__ = ("_uses", "root", "version")

    def __init__(self, version: Version) -> None:
        self.version = version
        self._uses: dict[tuple[str, str, str, str], Definition] = {}
        self.root = Definition(None, self, block("root"), block("root"))
        """The element ``sdf``."""

    def __repr__(self) -> str:
        return f"Schema({self.version})"

    def define(self, parent: Definition, row: Row) -> Definition:
        """The definition of a child; one object for all uses that say the same."""
        if not row.type.startswith("^"):
            return Definition(parent, self, row, row)
        minor = self.version.minor
        key = (row.type, row.name, at(row.multiplicity, minor), at(row.extra("own"), minor))
        if key not in self._uses:
            self._uses[key] = Definition(parent, self, block(row.type[1:]), row)
        return self._uses[key]

    def at(self, place: str) -> Definition | None:
        """The definition at a place such as ``joint:joint/axis``, or None; as a part of no special parent."""
        stem, _, path = place.partition(":")
        top = block(stem)
        if not top.lives(self.version.minor):
            return None
        key = (stem, "", "", "")
        if key not in self._uses:
            self._uses[key] = Definition(None, self, top, top)
        found: Definition | None = self._uses[key]
        for name in path.split("/")[1:]:
            found = found and found.children.get(name)
        return found


@cache
def schema(version: Version) -> Schema:
    """The format in a version, built once a process."""
    return Schema(version)
