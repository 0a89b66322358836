"""The plan for each link and joint, with the names that a model can hold, before anything is written."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import numpy as np

from sdfcheck.consumers.gazebo import BuiltShape, GazeboRobot
from sdfcheck.convert.ledger import Ledger, Words
from sdfcheck.convert.loss import Loss, LossKind, loss_at, refusal
from sdfcheck.convert.urdf_to_sdf.options import FixedJoints, Massless, Options
from sdfcheck.convert.vendor_spelling import Spelling, moved, spellings, uses
from sdfcheck.convert.writer import BLOCK, EMPTY, LINK, declare, numbers, spaced, undeclared_prefixes
from sdfcheck.formats.schema import Definition
from sdfcheck.formats.sdf.schema import schema
from sdfcheck.formats.sdf.values import floats
from sdfcheck.formats.urdf.schema import TRUE, Setting, settings
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.graph import PRESERVING, Transmission, text_of_setting
from sdfcheck.robot.motion.mass import SMALL, MassProperties
from sdfcheck.robot.motion.mechanism import Joint, Link, Mechanism
from sdfcheck.robot.motion.poses import Array, inverse, to_rpy
from sdfcheck.robot.root import root_of
from sdfcheck.source.altered import Xml, copied
from sdfcheck.source.document import Comment, Document, Element
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind

# Names that a model can hold: one space for links, joints and frames, no ``::``, nothing reserved.


WORLD = "world"


class Names:
    """The new names of links and joints; a link goes before a joint of its name."""

    def __init__(self, robot: Mechanism, *, world_is_root: bool) -> None:
        self.links: dict[str, str] = {}
        self.joints: dict[str, str] = {}
        self.losses: list[Loss] = []
        self._taken: set[str] = set()
        for name, link in robot.links.items():
            wished = f"{name}_link" if name == WORLD else legal(name)
            self.links[name] = self._settle(wished)
            # The root link `world` is the world itself, and only its shapes need a link.
            if self.links[name] != name and not (world_is_root and name == WORLD):
                self._report(
                    f"link `{name}` is named `{self.links[name]}`",
                    loss_at(link.element, LossKind.RENAMED, ""),
                )
        for name, joint in robot.joints.items():
            wished = legal(name)
            if joint.kind == "floating":  # it is not written: its name is free, also for a block's own joint
                self.joints[name] = wished
                continue
            if wished in self._taken:
                wished = f"{wished}_joint"
            self.joints[name] = self._settle(wished)
            if self.joints[name] != name:
                text = f"joint `{name}` is named `{self.joints[name]}`"
                self._report(text, loss_at(joint.element, LossKind.RENAMED, ""))

    def free(self, wished: str) -> str:
        """A name that nothing else has; it is taken from now on."""
        return self._settle(wished)

    def claim(self, name: str) -> bool:
        """Take a name; False if something else has it."""
        if name in self._taken:
            return False
        self._taken.add(name)
        return True

    def _settle(self, wished: str) -> str:
        name, number = wished, 1
        while name in self._taken:
            number += 1
            name = f"{wished}_{number}"
        self._taken.add(name)
        return name

    def _report(self, text: str, at: Loss) -> None:
        self.losses.append(Loss(at.kind, at.span, text, Severity.WARNING, (), at.origins))


def legal(name: str) -> str:
    """A name without what SDFormat reads into names."""
    text = name.strip().replace("::", "__")
    if text == WORLD:
        return f"{WORLD}_"
    if len(text) > 4 and text.startswith("__") and text.endswith("__"):
        return f"{text[2:-2]}_"
    return text or "unnamed"


_TIED = frozenset({"fixed", "revolute", "continuous", "prismatic", "ball", "universal", "screw"})
FOR_DRAKE = frozenset({"planar", "curvilinear"})
"""Kinds of joint that only Drake has in SDFormat, between frames."""
OF_JOINTS = frozenset(("physics", *PRESERVING, *settings("joint")))
"""Settings that only joints have."""
OF_MOVING_JOINTS = frozenset(settings("joint")) - {"provideFeedback"}
"""Settings that say nothing of a fixed joint."""


@dataclass(slots=True)
class Plan:
    """``home`` is where a link's frame ends up: the link that survives, and the 4×4 pose in it."""

    root: Element
    robot: Mechanism
    names: Names
    home: dict[str, tuple[str, Array]]
    bodies: dict[str, MassProperties | None]
    """The mass properties of the links that survive; None: those as written."""
    automatic: set[str] = field(default_factory=set)
    supplied: set[str] = field(default_factory=set)
    merged_joints: set[str] = field(default_factory=set)
    losses: list[Loss] = field(default_factory=list)
    has_world: bool = False
    """Whether the root link `world` is the world."""
    parts_of: dict[str, list[str]] = field(default_factory=dict)
    """Surviving link → those that became part of it."""
    dropped_links: set[str] = field(default_factory=set)
    dropped_joints: set[str] = field(default_factory=set)
    """Those that the consumer leaves out that is followed."""
    locked_joints: set[str] = field(default_factory=set)
    """Fixed joints of which it makes revolute ones that do not move."""
    shapes: dict[Element, BuiltShape] | None = None
    """The visuals and collisions that it reads, each as it builds it; None without such a consumer."""

    def is_merged(self, link: str) -> bool:
        return self.home[link][0] != link

    def is_summed(self, link: str, survivor: str) -> bool:
        """Are a link's mass properties part of those of the link that survives, or beside them?"""
        given = self.robot.links[link].body is not None
        return given and (
            link != survivor or (self.bodies.get(survivor) is not None and survivor not in self.supplied)
        )

    def is_world(self, link: str) -> bool:
        return self.has_world and link == WORLD

    def parts(self, link: str) -> list[str]:
        """The links that a surviving link is made of, itself first."""
        return [link, *self.parts_of.get(link, ())]


def plan(document: Document, robot: Mechanism, options: Options) -> Plan:
    """Decide.

    Raises NotConvertible where the options forbid a link without mass.
    """
    carried = {joint.child for joint in robot.joints.values()}
    has_world = WORLD in robot.links and WORLD not in carried and len(robot.links) > 1
    names = Names(robot, world_is_root=has_world)
    home = {name: (name, np.eye(4)) for name in robot.links}
    assert document.root is not None
    made = Plan(document.root, robot, names, home, {}, has_world=has_world, losses=names.losses)
    merger = _Merger(made, document, options)
    if options.like is None:
        merger.run()
    else:
        built = root_of(document).models[0].as_built_by(options.like)
        if not built.links:
            raise refusal(
                made.root, "Gazebo makes nothing of it: no link has mass, or all hang on one without"
            )
        merger.follow(built)
        _leave_out(made, built)
    for name, link in robot.links.items():
        if not made.is_merged(name) and name not in made.dropped_links:
            _weigh(made, link, options)
    return made


class _Merger:
    """Joins links along fixed joints, from the leaves up."""

    def __init__(self, made: Plan, document: Document, options: Options) -> None:
        self.plan = made
        self.options = options
        self.kept = _kept_joints(document, made.robot)
        self.mass = {name: _mass(link) for name, link in made.robot.links.items()}
        self.into: dict[str, str] = {}
        """Merged link → the link that it is a part of, or one that this one is a part of."""

    def run(self) -> None:
        fixed = [
            joint
            for joint in reversed(self.plan.robot.tree())
            if joint.kind == "fixed"
            and joint.name not in self.kept
            and joint.parent in self.plan.robot.links
            and not self.plan.is_world(joint.parent)
        ]
        everything = self.options.fixed_joints is FixedJoints.MERGE
        # Without frames a merged link's name would be gone.
        massless = self.options.massless is Massless.MERGE and self.options.has_frames
        for joint in fixed:
            if everything or (massless and self.mass[joint.child] <= 0):
                self.merge(joint)
        if massless:
            for joint in fixed:
                survivor = self.survivor(joint.parent)
                if joint.name not in self.plan.merged_joints and self.mass[survivor] <= 0:
                    self.merge(joint)
        self.settle()

    def follow(self, built: GazeboRobot) -> None:
        """Join those that a consumer joins."""
        lumped = {frame.name for frame in built.frames if frame.origin.kind == "joint"}
        for joint in reversed(self.plan.robot.tree()):
            if joint.name in lumped:
                self.merge(joint)
        self.settle()

    def survivor(self, link: str) -> str:
        """The link that a link is a part of by now; itself for one that is not merged."""
        passed = []
        while link in self.into:
            passed.append(link)
            link = self.into[link]
        self.into.update(dict.fromkeys(passed, link))
        return link

    def settle(self) -> None:
        """Say where the frames of all merged links end up, from the root to the leaves."""
        home, links = self.plan.home, self.plan.robot.links
        for joint in self.plan.robot.tree():
            if joint.name in self.plan.merged_joints:
                survivor, outer = home[joint.parent]
                offset = outer @ inverse(links[joint.parent].pose) @ links[joint.child].pose
                home[joint.child] = survivor, offset
        for name, (survivor, _) in home.items():
            if name != survivor:
                self.plan.parts_of.setdefault(survivor, []).append(name)

    def merge(self, joint: Joint) -> None:
        made, child = self.plan, joint.child
        survivor = self.into[child] = self.survivor(joint.parent)
        links = made.robot.links
        self.mass[survivor] += self.mass[child]
        made.merged_joints.add(joint.name)
        text = f"link `{child}` becomes part of link `{survivor}`"
        if self.options.has_frames:
            text += ", and its name that of a frame"
        severity = Severity.INFO if self.options.has_frames else Severity.WARNING
        made.losses.append(loss_at(links[child].element, LossKind.MERGED_LINK, text, severity))
        body = links[child].body
        if body is not None and body.mass <= 0 and body.moments.any():
            text = (
                f"link `{child}` has moments of inertia without mass; they are added to those of `{survivor}`"
            )
            made.losses.append(loss_at(links[child].element, LossKind.CHANGED_INERTIA, text))


def _leave_out(made: Plan, built: GazeboRobot) -> None:
    """Take over from a consumer what it leaves out, and how it builds the shapes of the rest."""
    made.shapes = {
        shape.origin.element: shape
        for link in built.links.values()
        for shape in (*link.visuals, *link.collisions)
    }
    made.dropped_links = {name for name, (base, _) in made.home.items() if base not in built.links}
    made.locked_joints = {
        name for name, joint in built.joints.items() if joint.origin.is_fixed and joint.type != "fixed"
    }
    made.dropped_joints = {
        name
        for name, joint in made.robot.joints.items()
        if joint.child in made.dropped_links or (name not in built.joints and name not in made.merged_joints)
    }


def _mass(link: Link) -> float:
    return link.body.mass if link.body is not None else 0.0


def _kept_joints(document: Document, robot: Mechanism) -> set[str]:
    """Joints with something of their own, such as a sensor, or that are to be kept by request."""
    kept = set()
    assert document.root is not None
    for block in document.root.children("gazebo"):
        name = block.attributes.get("reference", "")
        for child in block.children():
            # A tag that a link and a joint of one name could both have is the link's.
            concerned = child.name in OF_JOINTS or name not in robot.links
            idle = child.name in OF_MOVING_JOINTS or (child.name in PRESERVING and not _says_yes(child))
            if concerned and not idle:
                kept.add(name)
    return kept


def _says_yes(element: Element) -> bool:
    return text_of_setting(element).lower() in TRUE


def _weigh(made: Plan, link: Link, options: Options) -> None:
    """Settle the mass properties of a surviving link."""
    name = link.name
    if made.is_world(name) and not link.geometries:
        return
    parts = made.parts(name)
    alone = all(made.robot.links[part].body is None for part in parts[1:])
    if alone and _mass(link) > 0:
        made.bodies[name] = None
        return
    total: MassProperties | None = None
    for part in parts:
        body = made.robot.links[part].body
        if body is not None:
            seen = body.seen_from(made.home[part][1])
            total = seen if total is None else total.joined_with(seen)
    if total is not None and total.mass > 0:
        made.bodies[name] = total
        return
    _supply(made, link, options)


def _supply(made: Plan, link: Link, options: Options) -> None:
    name = link.name
    if options.massless is Massless.REFUSE:
        raise refusal(link.element, f"link `{name}` has no mass")
    solid = any(g.role == "collision" and g.kind != "mesh" for g in link.geometries)
    if options.massless is Massless.AUTO and options.has_mimic and solid:
        made.automatic.add(name)
        text = f"link `{name}` has no mass; the simulator has to compute it from the collisions"
    else:
        made.bodies[name] = SMALL
        text = f"link `{name}` has no mass; it gets {SMALL.mass:g} kg"
    made.supplied.add(name)
    made.losses.append(loss_at(link.element, LossKind.MASSLESS_LINK, text))


def is_for_drake(made: Plan, joint: Joint, options: Options) -> bool:
    """Is a joint written as ``drake:joint``? Its frames are on links."""
    on_link = joint.parent in made.home and not made.is_world(joint.parent)
    return joint.kind in FOR_DRAKE and on_link and options.has_frames


def free_joints(made: Plan, options: Options) -> set[str]:
    """Joints that are not written: left out, or of kinds that SDFormat expresses by having none."""
    joints = made.robot.joints.values()
    return made.dropped_joints | {
        joint.name for joint in joints if joint.kind not in _TIED and not is_for_drake(made, joint, options)
    }


# Vendors' own elements and attributes, in the words and at the places that SDFormat has for them.


_SIMPLE = "SimpleTransmission"
"""The only kind of transmission that Drake looks into."""
_DRIVABLE = frozenset({"revolute", "continuous", "prismatic", "screw"})


class VendorTags:
    """Writes the tags that a table is about; what no table knows is left to others."""

    def __init__(self, plan: Plan, options: Options, lose: Callable[..., None]) -> None:
        self.plan = plan
        self.options = options
        self.lose = lose
        self.spellings = spellings(plan.root.document, Kind.SDF, self)
        self.named: dict[tuple[str, str], str] = {}
        """Kind and name of a frame or tag → its name in the model, where all names differ."""
        self.moved: list[str] = []
        """The losses of names in the last tag that was written."""
        for child in plan.root.children():
            own = child.attributes.get("name", "")
            is_named = child.name == "frame" or (child.name != "drake:joint" and self.of(child) is not None)
            if own and is_named:
                self.named[child.name, own] = plan.names.free(own)

    def of(self, element: Element) -> Spelling | None:
        """The spelling of an element; None if it is not a vendor's tag that SDFormat can express."""
        made = self.spellings.get(element.name.partition(":")[0])
        return made if made is not None and made.knows(element.name) else None

    def put(self, element: Element, node: Xml) -> bool:
        """Write a tag into the counterpart of its parent; False if no table has it."""
        made = self.spellings.get(element.name.partition(":")[0])
        if made is None:
            return False
        if made.must_drop(element):
            self._drop(element, made)
            return True
        if not made.knows(element.name):
            return False
        self.moved.clear()
        written = made.write(element, node)
        for child in made.dropped:
            self._drop(child, made)
        made.dropped.clear()
        if written is not None:
            own = self.named.get((element.name, written.attributes.get("name", "")))
            if own is not None:
                self._rename(element, written, own)
        self._report_names(element)
        return True

    def _report_names(self, element: Element) -> None:
        for text in dict.fromkeys(self.moved):
            self.lose(element, LossKind.RENAMED, f"{text} in {element.title}", Severity.INFO)

    def _drop(self, element: Element, made: Spelling) -> None:
        text = (
            f"{element.title} is left out: {made.source.name} ignores it here, "
            "and in SDFormat would read it or refuse the file"
        )
        self.lose(element, LossKind.DROPPED_ELEMENT, text)

    def _rename(self, element: Element, written: Xml, own: str) -> None:
        if written.attributes["name"] != own:
            self.lose(element, LossKind.RENAMED, f"{element.title} is named `{own}`")
            written.attributes["name"] = own

    def name(self, text: str, kinds: tuple[str, ...]) -> str:
        """The new name of a link, joint, frame or tag; a link that was merged is what it was merged into."""
        new = self._new_name(text, kinds)
        if new != text:
            self.moved.append(f"`{text}` is now `{new}`")
        return new

    def vector(self, link: str, text: str, *, is_point: bool) -> str:
        """A point or direction of a link, in the frame of the link that it was merged into."""
        home = self.plan.home.get(link)
        return text if home is None else moved(text, home[1], is_point=is_point)

    def _new_name(self, name: str, kinds: tuple[str, ...]) -> str:
        plan = self.plan
        for kind in kinds:
            if (kind, name) in self.named:
                return self.named[kind, name]
            if kind == "joint" and name in plan.names.joints:
                return plan.names.joints[name]
            if kind == "link" and name in plan.home:
                has_frame = "frame" in kinds and self.options.has_frames
                return plan.names.links[name if has_frame else plan.home[name][0]]
        return name

    def put_attribute(self, element: Element, name: str, node: Xml) -> bool:
        """Write an attribute into the counterpart of its element; False if no table knows where."""
        made = self.spellings.get(name.partition(":")[0])
        self.moved.clear()
        is_written = made is not None and made.write_attribute(element, name, node)
        self._report_names(element)
        if not is_written and made is not None and made.attribute(element, name) is not None:
            text = f"{made.source.name} does not read attribute `{name}` of {element.title} there in SDFormat"
            self.lose(element, LossKind.KEPT_AS_EXTENSION, text)
        return is_written

    # Actuators

    def drive(self, transmission: Transmission, joints: Mapping[str, Xml]) -> set[Element]:
        """Put what vendors say of an actuator into the written joint that it drives; returns what was put there."""
        joint = joints.get(_driven(transmission))
        if joint is None or joint.attributes.get("type") == "fixed":
            return set()
        done = set()
        for child in transmission.actuators[0].children():
            if joint.find(child.name) is None and self.put(child, joint):
                done.add(child)
        return done

    def report_actuators(self, joints: Mapping[str, Xml]) -> None:
        """Drake drives joints with a transmission in URDF, and in SDFormat those with an effort other than 0."""
        if not uses(self.plan.root, "drake"):
            return
        models = root_of(self.plan.root.document).models
        driven = {name for each in models[0].transmissions if (name := _driven(each))}
        for name, joint in self.plan.robot.joints.items():
            if name not in joints or joint.kind not in _DRIVABLE or not joint.axes:
                continue
            effort = joint.axes[0].effort
            if name not in driven and effort != 0:
                what = "an actuator in SDFormat: it has an effort, and no transmission"
            elif name in driven and effort == 0:
                what = "no actuator in SDFormat: its effort is 0"
            else:
                continue
            self.lose(joint.element, LossKind.CHANGED_DEFAULT, f"Drake gives {joint.element.title} {what}")

    # Frames

    def frame(self, element: Element) -> Xml | None:
        """Drake's ``frame`` of a robot; None where SDFormat cannot have it."""
        plan = self.plan
        link, own = element.attributes.get("link", ""), element.attributes.get("name", "")
        if not self.options.has_frames or link not in plan.home or plan.is_world(link) or not own:
            return None
        node = Xml("frame", None, name=self.named["frame", own], attached_to=plan.names.links[link])
        if node.attributes["name"] != own:
            text = f"{element.title} is named `{node.attributes['name']}`"
            self.lose(element, LossKind.RENAMED, text)
        texts = (" ".join(element.attributes.get(name, "").split()) or "0 0 0" for name in ("xyz", "rpy"))
        node.add("pose", " ".join(texts))
        return node


def _driven(transmission: Transmission) -> str:
    """The joint that Drake drives by a transmission; empty where it looks at nothing in it."""
    kind, names = transmission.type_value, transmission.joint_names
    is_read = kind is not None and _SIMPLE in kind.text and names and transmission.actuators
    return names[0].text if is_read else ""


def without(node: Xml, source: Element, gone: set[Element]) -> None:
    """Take the copies of some elements out of the copy of ``source``."""
    for copy, child in zip(list(node.children()), source.children(), strict=True):
        if child in gone:
            node.remove(copy)
        else:
            without(copy, child, gone)


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
    shapes_of: dict[tuple[str, str], list[Element]] = field(default_factory=dict)
    """Link of the source and kind → its visuals or collisions, as far as they were written."""
    shapes: dict[Element, tuple[Xml, Xml]] = field(default_factory=dict)
    """The visuals and collisions of the source → the link and the element that were written for each."""
    copies: list[tuple[Element, Xml, Xml]] = field(default_factory=list)
    """The elements of blocks that were copied, their copies, and what holds these."""
    own_names: dict[str, str] = field(default_factory=dict)
    """Names of links, joints, frames and models of blocks, and those that they get."""
    own_links: set[str] = field(default_factory=set)
    """Links that only <gazebo> blocks have."""
    dropped_shapes: set[Element] = field(default_factory=set)
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
