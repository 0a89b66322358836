"""The shared state of the writers of the parts."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from sdfcheck.convert.ledger import Ledger, Words
from sdfcheck.convert.loss import Loss, LossKind
from sdfcheck.convert.urdf_to_sdf.options import Options
from sdfcheck.convert.urdf_to_sdf.plan import Plan
from sdfcheck.convert.urdf_to_sdf.vendor_tags import VendorTags
from sdfcheck.convert.writer import BLOCK, EMPTY, LINK, declare, numbers, spaced, undeclared_prefixes
from sdfcheck.formats.schema import Definition
from sdfcheck.formats.sdf.schema import schema
from sdfcheck.formats.sdf.values import floats
from sdfcheck.formats.urdf.schema import Setting
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.graph import text_of_setting
from sdfcheck.robot.motion.poses import Array, to_rpy
from sdfcheck.source.altered import Xml, copied
from sdfcheck.source.document import Comment, Element
from sdfcheck.source.record import NamedTuple

# The elements of URDF that have a counterpart in SDFormat, and the attributes in which they say something.


_PAIRS = {
    "axis": "xyz",
    "box": "size",
    "capsule": "radius length",
    "child": "link",
    "collision": "name",
    "color": "rgba",
    "cylinder": "radius length",
    "drake:capsule": "radius length",
    "drake:ellipsoid": "a b c",
    "drake:joint": "name type",
    "dynamics": "damping friction",
    "frame": "link name xyz rpy",
    "gazebo": "reference",
    "geometry": "",
    "inertia": "ixx ixy ixz iyy iyz izz",
    "inertial": "",
    "joint": "name type",
    "limit": "lower upper effort velocity",
    "link": "name",
    "mass": "value",
    "material": "name",
    "mesh": "filename scale",
    "mimic": "joint multiplier offset",
    "origin": "xyz rpy quat_xyzw",
    "parent": "link",
    "robot": "name version",
    "sphere": "radius",
    "texture": "filename",
    "visual": "name",
}
WORDS: Words = {name: frozenset(attributes.split()) for name, attributes in _PAIRS.items()}


KEPT = "urdf"
"""The prefix of what only URDF has."""


class Given(NamedTuple):
    """A setting of a link: the element of a block, the link that this is about, what was written and where."""

    entry: Element
    link: str
    text: str
    node: Xml


@dataclass(slots=True)
class Context:
    options: Options
    plan: Plan
    ledger: Ledger = field(default_factory=lambda: Ledger(WORDS, "SDFormat"))
    links: dict[str, Xml] = field(default_factory=dict)
    """The element that was written for each link (of the source) that survives."""
    joints: dict[str, Xml] = field(default_factory=dict)
    shapes_of: dict[tuple[str, str], list[Xml]] = field(default_factory=dict)
    """Link of the source and kind → the shapes that were written for it."""
    shapes: dict[Element, tuple[Xml, Xml]] = field(default_factory=dict)
    """The visuals and collisions of the source → the link and the element that were written for each."""
    copies: list[tuple[Element, Xml, Xml]] = field(default_factory=list)
    """The elements of blocks that were copied, their copies, and what holds these."""
    own_names: dict[str, str] = field(default_factory=dict)
    """Names of links, joints, frames and models of blocks, and those that they get."""
    own_links: set[str] = field(default_factory=set)
    """Links that only <gazebo> blocks have."""
    dropped_shapes: set[str] = field(default_factory=set)
    lost_mimics: set[str] = field(default_factory=set)
    """Joints that do not follow another any more."""
    given: dict[tuple[int, tuple[str, ...]], Given] = field(default_factory=dict)
    """Setting of a written link, by its identity and path → who gave it."""
    overruled: dict[str, dict[str, float]] = field(default_factory=dict)
    """Joint (of the result) → what a <gazebo> block says of its limits and dynamics."""
    namespaces: dict[str, str] = field(default_factory=dict)
    """Prefix → what it is at the root of the result."""
    reported: set[str] = field(default_factory=set)
    packages: list[str] = field(default_factory=list)
    """Packages whose files are named as those of models."""
    vendors: VendorTags = field(init=False)
    """The writer of vendors' tags in SDFormat."""

    def __post_init__(self) -> None:
        self.vendors = VendorTags(self.plan, self.options, self.note)

    @property
    def losses(self) -> list[Loss]:
        return self.ledger.losses

    def note(
        self, element: Element, kind: LossKind, message: str, severity: Severity = Severity.WARNING
    ) -> None:
        """Something about an element is written otherwise."""
        self.ledger.note(kind, element, message, severity)

    def lose(
        self, element: Element, kind: LossKind, message: str, severity: Severity = Severity.WARNING
    ) -> None:
        """An element is not in the result, nor is what is in it."""
        self.ledger.lose(kind, element, message, severity)

    def carry(self, element: Element | None, node: Xml, *attributes: str) -> None:
        """An element is said by a node, in these attributes (none: all); its custom data goes there as well."""
        if element is None:
            return
        self.ledger.take(element, *attributes)
        self.carry_attributes(element, node)
        for child in element.children():
            if child.is_custom and self.ledger.is_free(child):
                self.keep(child, node)

    def mark(self, node: Xml, link: str) -> None:
        """Say on a node which link of the source it is of, where that became part of another."""
        if self.options.has_frames and self.plan.is_merged(link):
            node.attributes[LINK] = self.plan.names.links[link]

    def carry_attributes(self, element: Element, node: Xml) -> None:
        """Write the attributes of an element that are not of URDF, under the prefix that they have or ours."""
        known = WORDS[element.name]
        for name, text in element.attributes.items():
            if name in known:
                continue
            if self.vendors.put_attribute(element, name, node):
                self.ledger.take(element, name)
                continue
            own = name if ":" in name else f"{KEPT}:{name}"
            if node.attributes.get(own) == text:
                self.ledger.take(element, name)  # one for both
            elif node.attributes.setdefault(own, text) != text:
                message = f"attribute `{name}` of {element.title} is left out: there is another one"
                self.ledger.lose_attribute(element, name, message)
            elif own == name:
                declare(node, element, name.partition(":")[0], self.namespaces)
                self.ledger.copy_attribute(element, name)
            else:
                message = (
                    f"attribute `{name}` of {element.title} means nothing in SDFormat; it is kept as `{own}`"
                )
                kind = LossKind.KEPT_AS_EXTENSION
                self.ledger.lose_attribute(element, name, message, kind, Severity.INFO)

    def once(self, key: str) -> bool:
        """True at the first call with a key."""
        if key in self.reported:
            return False
        self.reported.add(key)
        return True

    def carry_comments(self, element: Element, node: Xml) -> None:
        """Write the comments in an element, but those in what is kept as it is."""
        for part in element.nodes:
            if isinstance(part, Comment):
                if self.ledger.take_comment(part):
                    node.extend(part)
            elif isinstance(part, Element) and part.name in WORDS:
                self.carry_comments(part, node)

    def allows(self, place: str) -> bool:
        """Whether the version has an element at a place below ``model``, such as ``link/sensor``."""
        definition: Definition | None = schema(self.options.version).root.children.get("model")
        for name in place.split("/"):
            definition = definition.children.get(name) if definition is not None else None
        return definition is not None

    def translated(self, entry: Element, setting: Setting) -> str | None:
        """The text of a setting of ``<gazebo>`` as SDFormat has it; None, and reported, if it is malformed."""
        kind = setting.type
        text = (
            text_of_setting(entry) if kind == "flag" else self.numbers(entry, 3 if kind == "vector3" else 1)
        )
        if text is None:
            return None
        return text.removesuffix(".0") if kind == "int" else setting.translated(text)

    def numbers(self, setting: Element, count: int = 1) -> str | None:
        """The numbers of a setting as they are written; None, and reported, if there are not so many."""
        text = text_of_setting(setting)
        found = floats(text) or ()
        if len(found) == count and all(map(math.isfinite, found)):
            return text
        wanted = "a number" if count == 1 else f"{count} numbers"
        message = f"<{setting.name}> is left out: `{text}` is not {wanted}"
        self.lose(setting, LossKind.EXTENSION_NOT_CARRIED, message)
        return None

    def copied(self, element: Element) -> Xml:
        """A copy of an element, with the prefixes declared that are others at the root of the result."""
        made = copied(element)
        for prefix in undeclared_prefixes(made):
            declare(made, element, prefix, self.namespaces)
        return made

    def keep(self, element: Element, node: Xml, *, of_block: bool = False) -> None:
        """Carry something over that the target has no word for, under a prefix of its own."""
        if element.name.startswith("xacro:"):
            text = f"{element.title} is left out: nobody has expanded it"
            self.lose(element, LossKind.DROPPED_ELEMENT, text)
            return
        if self.vendors.put(element, node):
            self.ledger.take_whole(element)
            return
        made = self.copied(element)
        if element.is_custom:
            self.ledger.copy(element)
            self.name_anew(element, made, node)
            node.append(made)
            return
        self.ledger.take_whole(element)
        made.name = f"{KEPT}:{made.name}"
        text = f"{element.title} means nothing in SDFormat; it is kept as <{made.name}>"
        self.note(element, LossKind.KEPT_AS_EXTENSION, text, Severity.INFO)
        if of_block:
            made.attributes[BLOCK] = "true"
        own = made.attributes.get("name")
        if own and node.name == "model" and not self.plan.names.claim(own):
            # libsdformat requires different names of everything in a model, known to it or not.
            made.attributes = {
                f"{KEPT}:name" if key == "name" else key: text for key, text in made.attributes.items()
            }
        for part in made.walk():
            # It complains about attributes without a value, too.
            if empty := [name for name, text in part.attributes.items() if not text]:
                part.attributes = {name: text for name, text in part.attributes.items() if text}
                part.attributes[EMPTY] = " ".join(empty)
        node.append(made)

    def name_anew(self, element: Element, made: Xml, node: Xml) -> None:
        """Give custom data at the model a name that nothing there has."""
        if node.name == "model" and (own := made.attributes.get("name")) is not None:
            name = made.attributes["name"] = self.plan.names.free(own)
            if name != own:
                self.note(element, LossKind.RENAMED, f"{element.title} is named `{name}`")


def pose_text(element: Element) -> str | None:
    """An element's ``origin`` as the text of a pose, with the author's numbers; None where it is identity."""
    origin = element.find("origin")
    if origin is None or "quat_xyzw" in origin.attributes:
        return None
    texts = [spaced(origin.attributes.get(name, "")) or "0 0 0" for name in ("xyz", "rpy")]
    joined = " ".join(texts)
    return None if all(float(part) == 0 for part in joined.split()) else joined


def pose_of(pose: Array) -> str | None:
    """A 4×4 pose as text; None where it is identity."""
    text = numbers((*pose[:3, 3], *to_rpy(pose[:3, :3])))
    return None if text == "0 0 0 0 0 0" else text


def has_custom(element: Element | None) -> bool:
    """Has an element anything that needs a node to hang on?"""
    if element is None:
        return False
    known = WORDS[element.name]
    return any(name not in known for name in element.attributes) or any(
        child.is_custom for child in element.children()
    )


def is_quaternion(element: Element) -> bool:
    origin = element.find("origin")
    return origin is not None and "quat_xyzw" in origin.attributes
