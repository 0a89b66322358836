"""The elements and attributes that a format allows: rows of its table as one version has them.

The walk over a document asks for plain attributes only: ``definition.children.get(tag)``,
``definition.attributes.get(name)``, ``definition.accepts(text)``. They are built at their first use,
so that a document pays for the part of the format that it uses.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from sdfcheck.formats.table import Range, Row, Table, at, newest_name
from sdfcheck.formats.version import Version
from sdfcheck.source.document import Element

if TYPE_CHECKING:
    from sdfcheck.formats.choices import Choices

Accepts = Callable[[str], object]

NOT_GIVEN = "__default__"
"""The default that means "not given": no value would be sensible."""


class RowInVersion:
    """An element or attribute; ``choices``, ``range``, ``may_be_infinite`` and ``accepts`` at their first use."""

    __slots__ = ("accepts", "choices", "may_be_infinite", "name", "place", "range", "row", "schema")
    schema: Schema
    row: Row
    name: str
    place: str
    """Its path over all versions, such as ``joint:joint/axis/limit/lower`` or ``joint:joint/@type``."""
    range: Range | None
    """Bounds that hold by meaning or by the table; libsdformat does not check those of attributes."""
    choices: Choices | None
    may_be_infinite: bool
    accepts: Accepts
    """True for text that is surely read as written and nothing can be said against.

    For a pose: with rotation_format euler_rpy, the default.
    """

    if TYPE_CHECKING:
        type: str | None
        default: str | None
        multiplicity: str

        @property
        def needs_value(self) -> bool: ...
    else:

        def __getattr__(self, name: str) -> Any:
            if name == "choices":
                self.choices = self._read_choices()
            elif name == "range":
                self.range = Range.of(self.row, self.version.minor) if self.row.extras else None
            elif name == "may_be_infinite":
                self.may_be_infinite = "inf" in self.row.default or self.row.extra("infinite") != ""
            elif name == "accepts":
                self.accepts = self.schema.format.acceptance(self)
            else:
                raise AttributeError(name)
            return object.__getattribute__(self, name)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.place!r}, {self.version})"

    @property
    def version(self) -> Version:
        return self.schema.version

    @property
    def listed(self) -> tuple[str, ...]:
        """The values listed for the version; empty where they are free."""
        return self.choices.listed if self.choices is not None else ()

    @property
    def usual(self) -> tuple[str, ...]:
        """Values that most have, where any may be written."""
        return tuple(filter(None, self.row.extra("usual").split(",")))

    @property
    def given_default(self) -> str:
        """The default, if there is a sensible one."""
        return "" if self.default is None or self.default == NOT_GIVEN else self.default

    @property
    def units(self) -> tuple[str, ...]:
        """The unit of a number, as far as one is stated; two where it depends on the joint: angular, linear."""
        return tuple(filter(None, self.row.extra("unit").split("|")))

    @property
    def consumers(self) -> tuple[str, ...]:
        """Its consumers, where almost all of the format ignore it."""
        return tuple(filter(None, self._remark("consumers").split(",")))

    @property
    def release(self) -> str:
        """The first releases of its consumer that know it, in words; empty: all do."""
        return self._remark("release")

    def _remark(self, key: str) -> str:
        return self.row.extra(key)

    def _read_choices(self) -> Choices | None:
        if not self.row.extra("choices"):
            return None
        from sdfcheck.formats.choices import Choices

        return Choices.of(self.row, self.version)


class AttributeDefinition(RowInVersion):
    """An attribute, as one version allows it at one place."""

    __slots__ = ("default", "multiplicity", "required", "type")
    type: str
    default: str
    multiplicity: str
    required: bool

    def __init__(self, schema: Schema, row: Row, place: str) -> None:
        minor = schema.version.minor
        self.row = row
        self.schema = schema
        self.name = row.name[1:]
        self.place = f"{place}/{row.name}"
        self.type = at(row.type, minor)
        self.default = at(row.default, minor)
        self.multiplicity = "1" if at(row.multiplicity, minor) == "1" else "0"
        self.required = self.multiplicity == "1"

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
        "_use",
        "attributes",
        "children",
        "default",
        "deprecated",
        "exclusive",
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
    exclusive: bool
    """Consumers look at the first element in it and at nothing else."""
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
        self.schema = schema
        self.row = row
        self._use = use
        if row is use and parent is not None:
            self.path = f"{parent.path}/{row.name}"
            self.place = f"{parent.place}/{row.name}"
            self.name = row.name
        else:
            self.path = self.name = use.name if parent else at(row.extra("name"), minor) or row.name
            self.place = f"{row.name}:{newest_name(row)}"
        self.type = at(row.type, minor) or None
        self.default = at(row.default, minor) if self.type else None
        self.multiplicity = at(use.multiplicity, minor)
        self.own_multiplicity = (use.extras and at(use.extra("own"), minor)) or self.multiplicity
        self.single = self.multiplicity not in {"*", "+"}
        self.sound = set()
        self.deprecated = row.extras != [] and at(row.extra("deprecated"), minor) != ""
        self.exclusive = row.extras != [] and row.extra("exclusive") != ""
        self.open = row.extras != [] and row.extra("open") != ""

    @property
    def needs_value(self) -> bool:
        """Whether an empty text is refused; elsewhere it means the default."""
        return self.type is not None and self.own_multiplicity == "1"

    def at(self, path: str) -> Definition | None:
        """The definition at a path below this one, such as ``joint/limit``; None without one."""
        found: Definition | None = self
        for name in filter(None, path.split("/")):
            found = found and found.children.get(name)
        return found

    def known(self, element: Element) -> Iterator[tuple[Element, Definition]]:
        """An element that it defines and all elements in that, as far as they are known, with their definitions."""
        yield element, self
        for child in element.children():
            if (inner := self.children.get(child.name)) is not None:
                yield from inner.known(child)

    def _remark(self, key: str) -> str:
        return self._use.extra(key) or self.row.extra(key)

    def _unfold(self) -> None:
        schema, minor = self.schema, self.schema.version.minor
        self.children = children = {}
        self.attributes = attributes = {}
        for row in self.row.rows:
            if not row.lives(minor):
                continue
            if row.name[0] == "@":
                attributes[row.name[1:]] = AttributeDefinition(schema, row, self.place)
            else:
                children[row.name] = schema.define(self, row)
        self.required_children = tuple(
            name for name, child in children.items() if child.multiplicity in {"1", "+"}
        )
        self.required_attributes = tuple(name for name, attribute in attributes.items() if attribute.required)
        is_needed = schema.format.is_needed
        self.needed_children = tuple(
            name for name in self.required_children if is_needed(self, children[name])
        )

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            if name not in _UNFOLDED:
                return super().__getattr__(name)
            self._unfold()
            return object.__getattribute__(self, name)


_UNFOLDED = {"attributes", "children", "needed_children", "required_attributes", "required_children"}


class Schema:
    """A format in one version."""

    __slots__ = ("_uses", "format", "root", "version")

    def __init__(self, format: Format, version: Version) -> None:
        self.format = format
        self.version = version
        self._uses: dict[tuple[str, ...], Definition] = {}
        top = format.table.block(format.root)
        self.root = Definition(None, self, top, top)
        """The element ``sdf`` or ``robot``."""

    def __repr__(self) -> str:
        return f"Schema({self.version})"

    def define(self, parent: Definition, row: Row) -> Definition:
        """The definition of a child; one object for all uses that say the same."""
        if not row.type.startswith("^"):
            return Definition(parent, self, row, row)
        key = (row.type, row.name, row.multiplicity, *row.extras)
        if key not in self._uses:
            self._uses[key] = Definition(parent, self, self.format.table.block(row.type[1:]), row)
        return self._uses[key]

    def at(self, place: str) -> Definition | None:
        """The definition at a place such as ``joint:joint/axis``, or None; as a part of no special parent."""
        stem, _, path = place.partition(":")
        top = self.format.table.block(stem)
        if not top.lives(self.version.minor):
            return None
        key = (stem,)
        if key not in self._uses:
            self._uses[key] = Definition(None, self, top, top)
        return self._uses[key].at(path.partition("/")[2])


class Format:
    """A format: its table and versions, and what its consumers do that no row says.

    ``acceptance`` makes the quick check of a place; ``is_needed`` says whether a required child that is
    missing makes another robot.
    """

    __slots__ = ("_schemas", "acceptance", "is_needed", "root", "table", "versions")

    def __init__(
        self,
        table: Table,
        root: str,
        versions: tuple[Version, ...],
        acceptance: Callable[[RowInVersion], Accepts],
        is_needed: Callable[[Definition, Definition], bool],
    ) -> None:
        self.table = table
        self.root = root
        self.versions = versions
        self.acceptance = acceptance
        self.is_needed = is_needed
        self._schemas: dict[Version, Schema] = {}

    @property
    def newest(self) -> Version:
        return self.versions[-1]

    def schema(self, version: Version) -> Schema:
        """The format in a version, built once a process."""
        if version not in self._schemas:
            self._schemas[version] = Schema(self, version)
        return self._schemas[version]
