"""The plan for each link and joint, with the names that a model can hold, before anything is written."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from sdfcheck.consumers.gazebo import GazeboRobot
from sdfcheck.convert.loss import Loss, LossKind, loss_at, refusal
from sdfcheck.convert.urdf_to_sdf.options import FixedJoints, Massless, Options
from sdfcheck.formats.urdf.schema import TRUE, settings
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.graph import PRESERVING, text_of_setting
from sdfcheck.robot.motion.mass import SMALL, MassProperties
from sdfcheck.robot.motion.mechanism import Joint, Link, Mechanism
from sdfcheck.robot.motion.poses import Array, inverse
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import Document, Element

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
    text = name.replace("::", "__")
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
    shape_names: dict[Element, str] | None = None
    """The names that it gives to the visuals and collisions that it reads; None without such a consumer."""

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
    """Take over from a consumer what it leaves out, and what it calls the shapes of the rest."""
    made.shape_names = {
        shape.origin.element: shape.name
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
