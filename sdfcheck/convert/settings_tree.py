"""Settings as trees of names and values, whatever they were written in, and how two trees differ."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from copy import copy

import numpy as np

from sdfcheck.convert.vendor_spelling import uses
from sdfcheck.convert.writer import BLOCK, MARKS, SCRIPTS, is_mark
from sdfcheck.formats.schema import NOT_GIVEN, Definition
from sdfcheck.formats.sdf.schema import schema
from sdfcheck.formats.sdf.sensors import NEWEST_TYPES
from sdfcheck.formats.sdf.survey import version_of
from sdfcheck.formats.urdf.schema import settings
from sdfcheck.formats.vendor import known_tables
from sdfcheck.formats.vendor.definitions import Slot, Tag, value_at
from sdfcheck.formats.vendor.table import tag_of, vendors
from sdfcheck.formats.vendor.values import as_read
from sdfcheck.formats.version import NEWEST
from sdfcheck.robot.graph import PRESERVING, Joint, Link, Model, Shape, Visual, World, text_of_setting
from sdfcheck.robot.motion.origin import PoseError
from sdfcheck.robot.motion.poses import Array, to_rpy
from sdfcheck.robot.part import MergedFrame
from sdfcheck.robot.shapes import Material
from sdfcheck.source.document import Document, Element
from sdfcheck.source.errors import DescriptionError
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind

Same = Callable[[str, str], bool]
"""Do two texts say the same?"""

_NEAR = 1e-9
"""Poses nearer than this are one (m, and entries of rotations)."""
_BOOLEANS = {"true": "1", "false": "0"}


class Entry:
    """One setting: its value, its attributes, and the settings in it."""

    __slots__ = ("attributes", "children", "definition", "element", "name", "own", "pose", "text")

    def __init__(
        self, name: str, text: str = "", element: Element | None = None, definition: Definition | None = None
    ) -> None:
        self.name = name
        self.text = text
        self.element = element
        """The place in the text that it comes from."""
        self.definition = definition
        """Its definition in the format; None for a custom element, or free content."""
        self.attributes: dict[str, str] = {}
        self.children: list[Entry] = []
        self.pose: Array | None = None
        """Where it is in its link, 4×4, if the link places it."""
        self.own = ""
        """The name that its author gave it."""

    @property
    def title(self) -> str:
        return f"{self.name} `{self.own}`" if self.own else self.name

    def add(self, child: Entry) -> Entry:
        self.children.append(child)
        return child

    def find(self, name: str) -> Entry | None:
        return next((child for child in self.children if child.name == name), None)

    def reach(self, path: tuple[str, ...], element: Element | None = None) -> Entry:
        """The setting at the end of a path, made where it is missing."""
        at = self
        for name in path:
            definition = at.definition.children.get(name) if at.definition is not None else None
            at = at.find(name) or at.add(Entry(name, "", element, definition))
        return at

    def seen_from(self, frame: Array) -> Entry:
        """The settings of a link in another frame, in which the link's own has a 4×4 pose."""
        made = copy(self)
        made.children = [copy(child) for child in self.children]
        for child in made.children:
            child.pose = None if child.pose is None else frame @ child.pose
        return made

    def is_default(self) -> bool:
        """Does it say no more than the format takes for granted?"""
        definition = self.definition
        if definition is None or definition.open:
            return False
        if any(not _is_taken(text, definition, name) for name, text in self.attributes.items()):
            return False
        if definition.type is not None:
            default = definition.default
            return default not in {None, NOT_GIVEN} and same_text(self.text, default or "")
        return not self.own and all(child.is_default() for child in self.children)


def entry_of(element: Element, definition: Definition | None, without: frozenset[str] = frozenset()) -> Entry:
    """An element with all that is in it, apart from some of its children; of what may be once the first counts."""
    made = Entry(element.name, " ".join(element.content.split()), element, definition)
    for name, text in element.attributes.items():
        if name == "name":
            made.own = text
        elif name not in MARKS:
            made.attributes[name] = text
    for child in element.children():
        if child.name not in without:
            inner = (
                definition.children.get(child.name)
                if definition is not None and not definition.open
                else None
            )
            if inner is None or not inner.single or made.find(child.name) is None:
                made.add(entry_of(child, inner))
    if element.name == "sensor":
        _say_in_newest_words(made)
    return made


def _say_in_newest_words(sensor: Entry) -> None:
    """Give the type and the settings of a sensor the names of the newest version."""
    kind = sensor.attributes.get("type", "")
    sensor.attributes["type"] = NEWEST_TYPES.get(kind, kind)
    for child in sensor.children:
        newest = NEWEST_TYPES.get(child.name)
        if newest is not None and sensor.find(newest) is None:
            child.name = newest


class Divergence(NamedTuple):
    """One thing in which two trees differ: where, and what either says; ``none`` for nothing."""

    path: str
    before: str
    after: str
    element: Element | None
    """The place in the first text, or the nearest one."""

    @property
    def name(self) -> str:
        """The element or attribute that differs, prefix included."""
        return self.path.rpartition("@")[2].rpartition("/")[2]

    @property
    def is_custom(self) -> bool:
        """Is it data under a prefix of which no table knows what reads it?"""
        prefix, colon, _ = self.name.partition(":")
        document = None if self.element is None else self.element.document
        return bool(colon) and prefix not in known_tables(document and document.library)


def same_text(a: str, b: str, tolerance: float = 1e-9) -> bool:
    """Do two values say the same: as numbers, as booleans, or word for word?"""
    if a == b:
        return True
    mine, theirs = a.split(), b.split()
    return len(mine) == len(theirs) and all(
        x == y or _same_word(x, y, tolerance) for x, y in zip(mine, theirs, strict=True)
    )


def _same_word(a: str, b: str, tolerance: float) -> bool:
    x, y = (_BOOLEANS.get(word.lower(), word) for word in (a, b))
    if x == y:
        return True
    try:
        mine, theirs = float(x), float(y)
    except ValueError:
        return False
    return same_number(mine, theirs, tolerance)


def same_number(a: float, b: float, tolerance: float) -> bool:
    """Are two numbers of a robot equal, but for rounding?"""
    return a == b or math.isclose(a, b, rel_tol=tolerance, abs_tol=min(tolerance, 1e-12))


def divergences(
    a: Entry, b: Entry, same: Same = same_text, path: str = "", *, deep: bool = False
) -> Iterator[Divergence]:
    """In what two settings of one name differ; ``deep``: with each setting in one that is missing."""
    yield from _values(a, b, same, path)
    if a.pose is not None and b.pose is not None and float(np.abs(a.pose - b.pose).max()) > _NEAR:
        yield Divergence(f"{path}/pose", _placed(a.pose), _placed(b.pose), a.element)
    yield from _children_apart(a, b, same, path, deep=deep)


def _children_apart(a: Entry, b: Entry, same: Same, path: str, *, deep: bool) -> Iterator[Divergence]:
    """In what the settings inside two others differ."""
    left = _keyed(b)
    for key, child in _keyed(a).items():
        inner = f"{path}/{child.title}" if path else child.title
        other = left.pop(key, None)
        if other is not None:
            yield from divergences(child, other, same, inner, deep=deep)
        elif deep and child.children and not child.own:
            empty = Entry(child.name, "", None, child.definition)
            yield from divergences(child, empty, same, inner, deep=True)
        elif not child.is_default():
            yield Divergence(
                inner, _shown(child), "none", a.element if child.element is None else child.element
            )
    for child in left.values():
        if not child.is_default():
            inner = f"{path}/{child.title}" if path else child.title
            yield Divergence(inner, "none", _shown(child), a.element)


def _values(a: Entry, b: Entry, same: Same, path: str) -> Iterator[Divergence]:
    mine, theirs = _value(a), _value(b)
    if not same(mine, theirs):
        yield Divergence(path, mine or "none", theirs or "none", a.element)
    for name in dict.fromkeys((*a.attributes, *b.attributes)):
        mine, theirs = (entry.attributes.get(name, _default(entry, name)) for entry in (a, b))
        if not same(mine, theirs):
            yield Divergence(f"{path} @{name}".lstrip(), mine or "none", theirs or "none", a.element)


def _value(entry: Entry) -> str:
    """Its text; an empty one means the default."""
    definition = entry.definition
    if entry.text and definition is not None and definition.type == "color" and len(entry.text.split()) == 3:
        return f"{entry.text} 1"
    if entry.text or definition is None or definition.type is None:
        return entry.text
    return "" if definition.default in {None, NOT_GIVEN} else definition.default or ""


def _placed(pose: Array) -> str:
    return " ".join(
        f"{0.0 if abs(number) < _NEAR else number:.6g}" for number in (*pose[:3, 3], *to_rpy(pose[:3, :3]))
    )


def _default(entry: Entry, name: str) -> str:
    known = entry.definition.attributes.get(name) if entry.definition is not None else None
    return "" if known is None or known.default == NOT_GIVEN else known.default


def _is_taken(text: str, definition: Definition, name: str) -> bool:
    known = definition.attributes.get(name)
    return known is not None and same_text(text, known.default)


def _keyed(entry: Entry) -> dict[tuple[str, str, int], Entry]:
    """The settings inside one, by name, the author's name for it, and number among its like."""
    found: dict[tuple[str, str, int], Entry] = {}
    counts: Counter[tuple[str, str]] = Counter()
    for child in entry.children:
        name = child.name, child.own
        found[child.name, child.own, counts[name]] = child
        counts[name] += 1
    return found


def _shown(entry: Entry) -> str:
    kind = entry.attributes.get("type") or entry.attributes.get("filename") or ""
    text = (
        entry.text or kind or entry.own or (f"{len(entry.children)} settings" if entry.children else "given")
    )
    return text if len(text) <= 60 else f"{text[:60]}…"


class Contents:
    """Settings by kind and name of their part (``link``, ``joint``, ``model``), and by the element of their shape."""

    __slots__ = ("name", "parts", "shapes")

    def __init__(self, name: str) -> None:
        self.name = name
        """That of the robot."""
        self.parts: dict[tuple[str, str], Entry] = {}
        self.shapes: dict[Element, Entry] = {}

    def add(self, kind: str, name: str, entry: Entry) -> Entry:
        """The settings of a part; of several of a name the first."""
        return self.parts.setdefault((kind, name), entry)

    def of(self, kind: str, name: str) -> Entry:
        """The settings of a part; none are an empty entry."""
        return self.parts.get((kind, name)) or Entry(kind)

    def count(self) -> dict[str, int]:
        """How many sensors, plugins, lights, materials and pieces of custom data there are."""
        found: dict[str, int] = {}
        entries = [*self.parts.values(), *self.shapes.values()]
        while entries:
            entry = entries.pop()
            kind = "custom element" if ":" in entry.name else entry.name
            if kind in COUNTED:
                found[kind] = found.get(kind, 0) + 1
            if kind not in {"plugin", "custom element"}:
                entries += entry.children
        return found


COUNTED = ("sensor", "light", "plugin", "material", "surface", "custom element")
"""The settings that a summary counts."""


# Tags of vendors as trees in which it does not show which dialect wrote them.

_KEPT = "urdf:"
"""Before the names of elements that a conversion kept from URDF."""


def custom_entries(elements: Iterable[Element], kind: Kind) -> Iterator[Entry]:
    """The custom ones among some elements; tags of a table only where they are read."""
    for element in elements:
        if element.is_custom and _is_read(element, kind):
            yield custom_entry(element, kind)


def custom_entry(element: Element, kind: Kind) -> Entry:
    """A custom element; one that a table is about by the values that are read alone."""
    tag = tag_of(element.document, element.name, kind.value)
    if tag is not None:
        return _tag_entry(element, tag, kind)
    own = element.name.removeprefix(_KEPT)
    # One that SDFormat has as well, made of something else, is another one.
    made = Entry(f"{_KEPT}{own}" if own in COUNTED else own, " ".join(element.content.split()), element)
    for name, text in element.attributes.items():
        if name.removeprefix(_KEPT) == "name":
            made.own = text
        elif text and name not in MARKS:
            made.attributes[name.removeprefix(_KEPT)] = text
    made.children += [custom_entry(child, kind) for child in element.children()]
    return made


def _tag_entry(element: Element, tag: Tag, kind: Kind) -> Entry:
    made = Entry(element.name, "", element)
    place = next((place for place in tag.places if place.slot is not None), None)
    value = value_at(element, place.carrier) if place is not None else None
    if place is not None and place.slot is not None and value is not None:
        made.text = _read(place.slot, value.text)
    for name, slot in tag.attributes.items():
        if (given := element.attribute(name)) is None:
            continue
        if name == "name":
            made.own = given.text
        else:
            made.add(Entry(name, _read(slot, given.text), element))
    for child in element.children():
        if child.name in tag.parts:
            made.add(Entry(child.name, _read(tag.parts[child.name], child.content), child))
    for inner in custom_entries(element.children(), kind):
        inner.name = _local(inner.name)
        made.add(inner)
    return made


def _read(slot: Slot, text: str) -> str:
    """A value as it is read, by the lenient of the dialects."""
    words = " ".join(text.split())
    if slot.type in {"bool", "truth"}:
        return str(words.lower() in {"true", "1"}).lower()
    return as_read(slot, words)


def _is_read(element: Element, kind: Kind) -> bool:
    """Does its consumer look for it where it is? Elements that no table has may be anybody's."""
    if not _has_table(element, element.name):
        return True
    tag, parent = tag_of(element.document, element.name, kind.value), element.parent
    if tag is None or parent is None:
        return False
    if any(above.name == "gazebo" for above in element.around):
        return True  # it is kept there for SDFormat
    return any(place.encloses(parent) and place.holds(parent) for place in tag.places)


def attribute_entry(element: Element, name: str, text: str, kind: Kind) -> Entry | None:
    """A tag that is an attribute where it is read; None if it is not."""
    tag = tag_of(element.document, name, kind.value)
    places = () if tag is None else tag.places
    read = (place.slot for place in places if place.carrier == "attribute" and place.encloses(element))
    slot = next(read, None)
    return None if slot is None else Entry(name, _read(slot, text), element)


def take_attributes(made: Entry, element: Element, kind: Kind) -> None:
    """Give a part what its attributes say to vendors, as another dialect may have elements for that."""
    for name, text in element.attributes.items():
        if ":" in name and _has_table(element, name):
            made.attributes.pop(name, None)
            if (entry := attribute_entry(element, name, text, kind)) is not None:
                made.add(entry)


def attribute_entries(element: Element, kind: Kind) -> Iterator[Entry]:
    """The attributes of an element that are custom, each as an entry of its own."""
    for name, text in element.attributes.items():
        if ":" not in name or name.startswith("xmlns:"):
            continue
        if _has_table(element, name):
            entry = attribute_entry(element, name, text, kind)
        else:
            entry = Entry(name.removeprefix(_KEPT), text, element)
        if entry is not None:
            yield entry


def _has_table(element: Element, name: str) -> bool:
    return name.partition(":")[0] in known_tables(element.document.library)


def seen_from_links(document: Document) -> set[str]:
    """The tags, without prefix, whose numbers change when the frame of a link does."""
    tags = (tag for table in vendors(document.library, "sdf") for tag in table.tags.values())
    return {_local(tag.name) for tag in tags if tag.keys.text("point-in") or tag.keys.text("direction-in")}


def _local(name: str) -> str:
    """The name without the vendor's prefix: what is a tag in one dialect is an attribute in the other."""
    return name.rpartition(":")[2]


# The contents of an SDFormat file beyond bodies and joints that move.

_OF_MODELS = frozenset({"link", "joint", "frame", "model", "include", "pose", "static", "drake:joint"})
_OF_WORLDS = frozenset({"model", "include", "joint", "frame"})
_FIELDS = frozenset({"gravity", "magnetic_field"})
"""They were in the physics before 1.6."""
_OF_LINKS = frozenset({"pose", "inertial", "visual", "collision"})
_OF_SHAPES = frozenset({"pose", "geometry", "density", "auto_inertia_params"})
_OF_JOINTS = frozenset(
    {"pose", "parent", "child", "axis", "axis2", "screw_thread_pitch", "thread_pitch", "drake:mimic"}
)
_OF_AXES = frozenset({"xyz", "use_parent_model_frame", "mimic", "limit", "dynamics"})
_LIMITS = frozenset({"lower", "upper", "effort", "velocity"})
_DYNAMICS = frozenset({"damping", "friction"})
_OF_BLOCKS = frozenset({"axis", "child", "material", "parent", "pose"})
_ENDS = {"parent": "", "child": ""}


def of_model(model: Model) -> Contents:
    """The contents of a model and of all models in it, by names from the top."""
    found = Contents(model.name)
    _model(found, model, "", _definition(model.element, "model"))
    for name, node in model.all_nodes():
        if isinstance(node, Model):
            if node.is_readable:
                _model(found, node, name, _definition(node.element, "model"))
        elif isinstance(node, MergedFrame):
            inner = _entry(node.model.element, _definition(node.model.element, "model"), _OF_MODELS)
            found.of("model", name.rpartition("::")[0]).children += inner.children
        elif isinstance(node, Link):
            _link(found, node, name)
        elif node.kind == "joint":
            found.add("joint", name, _joint(node.element))
    return found


def of_world(world: World) -> Entry:
    """The contents of a world in addition to models."""
    definition = schema(version_of(world.document)).root.children.get("world")
    made = _entry(world.element, definition, _OF_WORLDS)
    for physics in [child for child in made.children if child.name == "physics"]:
        for field in [child for child in physics.children if child.name in _FIELDS]:
            physics.children.remove(field)
            if made.find(field.name) is None:
                made.add(field)
    return made


def _model(found: Contents, model: Model, name: str, definition: Definition | None) -> None:
    made = _entry(model.element, definition, _OF_MODELS)
    for attribute in ("canonical_link", "placement_frame"):
        made.attributes.pop(attribute, None)
    for child in () if model.include is None else model.include.children("plugin"):
        made.add(entry_of(child, definition.children.get("plugin") if definition is not None else None))
    found.add("model", name, made)


def _link(found: Contents, link: Link, name: str) -> None:
    element = link.element
    definition = _definition(element, "link")
    made = found.add("link", name, _entry(element, definition, _OF_LINKS))
    for child in made.children:
        _place(child, link)
    for part in (part for role in ("visual", "collision") for part in element.children(role)):
        inner = definition.children.get(part.name) if definition is not None else None
        shape = found.shapes[part] = _entry(part, inner, _OF_SHAPES)
        geometry = part.find("geometry")
        for solid in () if geometry is None else geometry.children():
            _add_custom(shape, solid)


def _place(entry: Entry, link: Link) -> None:
    """Let the pose of a part of a link be in the link's frame, whatever it is relative to."""
    pose = entry.find("pose")
    if pose is None or entry.element is None or entry.definition is None:
        return
    try:
        placed = link.root.poses.of_part(entry.element, link)
    except (DescriptionError, PoseError):
        return
    entry.children.remove(pose)
    entry.pose = placed


def _joint(element: Element) -> Entry:
    definition = _definition(element, "joint")
    made = _entry(element, definition, _OF_JOINTS)
    if made.attributes.pop("type", None) == "fixed":
        made.children = [
            child for child in made.children if child.element is None or not _is_idle(child.element)
        ]
    for name in ("axis", "axis2"):
        axis, inner = element.find(name), definition.children.get(name) if definition is not None else None
        if axis is None:
            continue
        place = made.add(_entry(axis, inner, _OF_AXES))
        _lift_custom(place, made)
        for part, without in (("limit", _LIMITS), ("dynamics", _DYNAMICS)):
            written = axis.find(part)
            if written is not None:
                known = inner.children.get(part) if inner is not None else None
                _lift_custom(place.add(_entry(written, known, without)), made)
    return made


def _is_idle(element: Element) -> bool:
    """Is it kept from a fixed joint of URDF, where it meant nothing? What a block said counts."""
    return element.name.startswith("urdf:") and BLOCK not in element.attributes


def _lift_custom(part: Entry, joint: Entry) -> None:
    """Move what is custom in an axis or its limit to the joint: URDF has these elsewhere."""
    joint.children += [child for child in part.children if ":" in child.name]
    part.children = [child for child in part.children if ":" not in child.name]
    if part.element is not None:
        joint.children += attribute_entries(part.element, Kind.SDF)
    part.attributes = {name: text for name, text in part.attributes.items() if ":" not in name}


def _entry(element: Element, definition: Definition | None, without: frozenset[str]) -> Entry:
    """An element without what is compared as part of the mechanism, custom data as such."""
    customs = frozenset(child.name for child in element.children() if child.is_custom)
    made = entry_of(element, definition, without | customs)
    made.attributes = {name: text for name, text in made.attributes.items() if name not in _ENDS}
    take_attributes(made, element, Kind.SDF)
    others = (
        child
        for child in element.children()
        if child.name not in without and not is_mark(child) and not _is_kept_idle(child)
    )
    made.children += custom_entries(others, Kind.SDF)
    return made


def _is_kept_idle(element: Element) -> bool:
    """Is it kept from URDF, where it meant nothing: in a link, or in a block for a joint or about another kind?"""
    local = element.name.removeprefix("urdf:")
    if local == element.name or element.parent is None:
        return False
    holder = element.parent.name
    if BLOCK not in element.attributes:
        return holder == "link"
    return local in (settings("joint") if holder == "link" else _OF_BLOCKS)


def _add_custom(shape: Entry, element: Element) -> None:
    """The custom parts of a shape."""
    shape.children += custom_entries(element.children(), Kind.SDF)


def _definition(element: Element, kind: str) -> Definition | None:
    """The definition of a link, joint or model in the version of its file."""
    model = schema(version_of(element.document)).root.children.get("model")
    return model if kind == "model" or model is None else model.children.get(kind)


# The contents of a URDF file beyond bodies and joints that move, in SDFormat's words.
#
# That is ``<gazebo>`` blocks, materials and custom data.

_TRANSLATED = {
    "axis": frozenset({"xyz"}),
    "dynamics": frozenset({"damping", "friction"}),
    "robot": frozenset({"frame", "gazebo", "joint", "link", "material", "origin"}),
    "collision": frozenset({"geometry", "origin"}),
    "joint": frozenset({"axis", "child", "dynamics", "limit", "mimic", "origin", "parent"}),
    "limit": frozenset({"effort", "lower", "upper", "velocity"}),
    "visual": frozenset({"geometry", "material", "origin"}),
}
"""Element → the parts and attributes for which SDFormat has words; it has others under a prefix only."""
_HINTS = frozenset({*PRESERVING, "material"})
_OF_ROBOTS = frozenset({"pose", "static", "frame", "joint", "link", "model", "include"})
_MOTION = frozenset({"axis", "pose", "parent", "child"})


def of_urdf(model: Model) -> Contents:
    """The contents of a robot."""
    found = Contents(model.name)
    sdf = schema(NEWEST).root.children["model"]
    robot = found.add("model", "", _urdf_entry("model", model.element, sdf))
    _add_customs(robot, model.element.children(), ("drake:joint",))
    for kept in _add_own(robot, model.element):
        for actuator in (child for child in kept.children if child.name == "actuator"):
            # Vendor tags of it are the joint's.
            actuator.children = [child for child in actuator.children if ":" not in child.name]
    for link in model.links:
        _urdf_link(found, link, sdf.children["link"])
    for joint in model.joints:
        _urdf_joint(found, joint, sdf.children["joint"])
    for block in model.blocks_by_reference.get("", ()):
        for entry in block.element.children():
            if entry.name not in _OF_ROBOTS and (entry.name in sdf.children or ":" in entry.name):
                _add(robot, entry)
    _drive(found, model)
    return found


def _urdf_link(found: Contents, link: Link, definition: Definition) -> None:
    made = found.add("link", link.name, _urdf_entry("link", link.element, definition))
    _add_customs(made, link.element.children())
    shapes = [(shape, _shape(shape, definition)) for shape in link.shapes]
    for shape, entry in shapes:
        found.shapes[shape.element] = entry
    for block in link.gazebo_blocks:
        for element in block.element.children():
            _of_block(made, link, element, shapes)


def _of_block(made: Entry, link: Link, element: Element, shapes: list[tuple[Shape, Entry]]) -> None:
    """The settings that a block has for a link."""
    name = element.name
    setting = settings("link").get(name)
    if name in {"visual", "collision"}:
        for entry in (entry for shape, entry in shapes if shape.kind == name):
            _lay_over(entry, entry_of(element, entry.definition))
    elif setting is not None:
        text = setting.translated(text_of_setting(element))
        for path in setting.counterparts:
            if path[0] == "collision":
                for entry in (entry for shape, entry in shapes if shape.kind == "collision"):
                    entry.reach(path[1:], element).text = text
            else:
                made.reach(path, element).text = text
    elif name == "material":
        _script(element, [entry for shape, entry in shapes if shape.kind == "visual"])
    elif name not in _HINTS and name not in settings("joint") and not _is_of_joint(link, element):
        _add(made, element)


def _script(element: Element, visuals: Iterable[Entry]) -> None:
    """The script of classic Gazebo that a block has for the visuals of a link."""
    if name := text_of_setting(element):
        for visual in visuals:
            for part, text in (("name", name), ("uri", SCRIPTS)):
                visual.reach(("material", "script", part), element).text = text


def _is_of_joint(link: Link, element: Element) -> bool:
    """Where a joint has the link's name: is a setting the joint's?"""
    return element.name == "physics" and any(joint.name == link.name for joint in link.model.joints)


def _shape(shape: Shape, definition: Definition) -> Entry:
    made = _urdf_entry(shape.kind, shape.element, definition.children.get(shape.kind))
    _add_customs(made, shape.element.children())
    _add_own(made, shape.element)
    geometry = shape.geometry.shape_element
    _add_customs(made, () if geometry is None else geometry.children())
    if isinstance(shape, Visual) and shape.own_material.is_given:
        _material(made, shape.material)
    return made


def _material(shape: Entry, material: Material) -> None:
    color, texture = material.element.find("color"), material.element.find("texture")
    if color is not None and (rgba := color.attributes.get("rgba", "").split()):
        # URDF has one color, in whatever light.
        shape.reach(("material", "diffuse"), color).text = " ".join(rgba)
    if texture is not None and (file := texture.attributes.get("filename", "").strip()):
        shape.reach(("material", "pbr", "metal", "albedo_map"), texture).text = file
        if texture.document.root is not None and uses(texture.document.root, "drake"):
            shape.reach(("material", "drake:diffuse_map"), texture).text = file


def _urdf_joint(found: Contents, joint: Joint, definition: Definition) -> None:
    made = found.add("joint", joint.name, _urdf_entry("joint", joint.element, definition))
    _add_customs(made, joint.element.children())
    if not joint.is_fixed:  # of one that was merged nothing is left but a frame
        _add_own(made, joint.element)
    for name in ("axis", "limit", "dynamics"):
        inner = joint.find(name)
        if inner is not None:
            _add_customs(made, inner.children())
            made.children += attribute_entries(inner, Kind.URDF)
            own = inner.attributes.items() if not joint.is_fixed else ()
            made.children += [
                Entry(key, text, inner)
                for key, text in own
                if key not in _TRANSLATED[name] and ":" not in key
            ]
    for element in (element for block in joint.gazebo_blocks for element in block.element.children()):
        if (setting := settings("joint").get(element.name)) is not None:
            for path in setting.counterparts:
                made.reach(path, element).text = setting.translated(text_of_setting(element))
        elif element.name not in _HINTS and element.name not in _MOTION and not _is_of_link(joint, element):
            _add(made, element)


def _is_of_link(joint: Joint, element: Element) -> bool:
    """Where a link has the joint's name: is a setting the link's?"""
    model = joint.model
    return (
        model is not None
        and any(link.name == joint.name for link in model.links)
        and element.name != "physics"
    )


def _drive(found: Contents, model: Model) -> None:
    """Vendor tags of the actuator of a joint."""
    for transmission in model.transmissions:
        kind, names = transmission.type_value, transmission.joint_names
        if kind is None or "SimpleTransmission" not in kind.text or not names or not transmission.actuators:
            continue
        joint = found.parts.get(("joint", names[0].text))
        if joint is not None:
            _add_customs(joint, transmission.actuators[0].children())


def _add(made: Entry, element: Element) -> None:
    """A setting that a block has as SDFormat has it."""
    definition = made.definition.children.get(element.name) if made.definition is not None else None
    entry = custom_entry(element, Kind.SDF) if element.is_custom else entry_of(element, definition)
    there = made.find(element.name) if definition is not None and definition.single else None
    if there is not None:
        _lay_over(there, entry)
    else:
        made.add(entry)


def _lay_over(entry: Entry, other: Entry) -> None:
    """The values of one setting take precedence over those of the other."""
    entry.attributes.update(other.attributes)
    entry.text = other.text or entry.text
    for child in other.children:
        there = entry.find(child.name) if child.name not in {"plugin", "sensor"} else None
        if there is None:
            entry.add(child)
        else:
            _lay_over(there, child)


def _add_own(made: Entry, element: Element) -> list[Entry]:
    """What URDF alone has in an element, or nobody."""
    translated = _TRANSLATED[element.name]
    found = [child for child in element.children() if not child.is_custom and child.name not in translated]
    return [made.add(custom_entry(child, Kind.URDF)) for child in found]


def _urdf_entry(kind: str, element: Element, definition: Definition | None) -> Entry:
    """A part of the robot, with the attributes that are custom."""
    made = Entry(kind, "", element, definition)
    made.attributes = {name: text for name, text in element.attributes.items() if ":" in name}
    take_attributes(made, element, Kind.URDF)
    return made


def _add_customs(made: Entry, elements: Iterable[Element], without: tuple[str, ...] = ()) -> None:
    made.children += custom_entries((e for e in elements if e.name not in without), Kind.URDF)
