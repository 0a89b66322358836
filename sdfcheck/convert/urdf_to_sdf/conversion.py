"""The conversion from end to end, and its result read by SDFormat's own parser."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from sdfcheck.convert.comparison import Correspondence, Counterpart
from sdfcheck.convert.loss import LossKind, refusal
from sdfcheck.convert.result import Comparison, Conversion, conversion, read_result
from sdfcheck.convert.settings_tree import of_model, of_urdf
from sdfcheck.convert.urdf_to_sdf.gazebo_blocks import Extensions, FollowedNames
from sdfcheck.convert.urdf_to_sdf.joints import Joints
from sdfcheck.convert.urdf_to_sdf.links import Links, Materials, keep_frictions_of_drake
from sdfcheck.convert.urdf_to_sdf.options import Options
from sdfcheck.convert.urdf_to_sdf.plan import (
    KEPT,
    WORLD,
    Context,
    Plan,
    free_joints,
    has_custom,
    legal,
    plan,
    pose_of,
    pose_text,
    without,
)
from sdfcheck.convert.writer import (
    PACKAGES,
    render,
    undeclared_prefixes,
    with_line_ends,
    without_empty_shapes,
)
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.graph import Transmission
from sdfcheck.robot.motion.flatten import mechanism_of
from sdfcheck.robot.motion.mechanism import Axis, Link, Mechanism
from sdfcheck.robot.motion.origin import PoseError
from sdfcheck.robot.motion.poses import origin_of
from sdfcheck.robot.root import root_of
from sdfcheck.source.altered import Xml
from sdfcheck.source.document import Comment, Document, Element, Node
from sdfcheck.source.errors import DescriptionError
from sdfcheck.source.sniff import Kind

# The result, read by SDFormat's own parser, and what it is to be compared with.


_BRINGING = frozenset({"include", "model"})


def read_back(written: Document, context: Context, sdf: Xml) -> Mechanism:
    """The robot of what was written, without what the source has for Gazebo only."""
    own = written
    if (rest := _without_brought(sdf)) is not None:
        own = read_result(render(rest), written, Kind.SDF)
    robot = mechanism_of(root_of(own).models[0], vendors=True)
    for name in context.own_links:
        robot.links.pop(name, None)
    return robot


def _without_brought(sdf: Xml) -> Xml | None:
    """The result without models that ``<gazebo>`` blocks bring, and joints to them; None if there are none."""
    model = next(sdf.children())
    if not any(child.name in _BRINGING for child in model.children()):
        return None
    kept, outer = Xml(model.name, None, **model.attributes), Xml(sdf.name, None, **sdf.attributes)
    kept.extend(
        *(child for child in model.children() if not (child.name in _BRINGING or _reaches_into(child)))
    )
    outer.append(kept)
    return outer


def _reaches_into(joint: Xml) -> bool:
    ends = (joint.find(name) for name in ("parent", "child")) if joint.name == "joint" else ()
    return any(end is not None and "::" in end.content for end in ends)


def expected(robot: Mechanism, plan: Plan, context: Context) -> Mechanism:
    """The source with what was reported, and what it has for Gazebo.

    That is masses supplied, limits that mean none, joints that do not follow.
    """
    links = dict(robot.links)
    for name in plan.supplied - plan.automatic:
        for part in plan.parts(name):
            link = links[part]
            body = plan.bodies[name] if part == name else None
            links[part] = Link(link.name, link.pose, link.element, body, link.geometries)
    for name in plan.dropped_links:
        links[name] = replace(links[name], body=None, geometries=[])
    joints = {}
    free = free_joints(plan, context.options)
    blocks = plan.root.children("gazebo")
    kept = {part.attributes.get("name") for block in blocks for part in block.children("joint")}
    for name, joint in robot.joints.items():
        if name in free:
            # A floating link stays where it is, whatever moves; a joint of a block in its place ties it to its parent.
            if name in kept:
                joints[name] = replace(joint, kind="fixed", axes=())
            continue
        changes: dict[str, Any] = dict(context.overruled.get(plan.names.joints[name], {}))
        axes = tuple(_unbounded(replace(axis, **changes)) for axis in joint.axes)
        if name in context.lost_mimics:
            axes = tuple(replace(axis, mimic=None) for axis in axes)
        joints[name] = replace(joint, axes=axes)
    frames = {name: one for name, one in robot.frames.items() if one[0] not in plan.dropped_links}
    return Mechanism(robot.name, links, joints, frames)


def _unbounded(axis: Axis) -> Axis:
    """Negative effort and velocity mean no limit."""
    effort = axis.effort if axis.effort >= 0 else float("inf")
    velocity = axis.velocity if axis.velocity >= 0 else float("inf")
    return replace(axis, effort=effort, velocity=velocity)


def correspondence(plan: Plan, context: Context) -> Correspondence:
    """The outcomes of the source's links and joints."""
    names = plan.names
    links = {
        name: Counterpart(names.links[survivor], offset) for name, (survivor, offset) in plan.home.items()
    }
    dropped = {name for name, (survivor, _) in plan.home.items() if survivor not in context.links}
    return Correspondence(
        links,
        names.joints,
        dropped_links=frozenset(dropped),
        dropped_joints=frozenset(free_joints(plan, context.options)),
        dropped_shapes=context.dropped_shapes,
        changed_bodies=frozenset(plan.automatic),
    )


# The conversion from end to end.


_NAMESPACES = {KEPT: "http://ros.org/wiki/urdf/XML", "drake": "http://drake.mit.edu"}


@np.errstate(all="ignore")  # what overflows is not equal to anything
def urdf_to_sdf(document: Document, options: Options, *, verified: bool = True) -> Conversion:
    """Convert a URDF document to a text of SDFormat.

    Raises NotConvertible.
    """
    root = document.root
    assert root is not None
    models = root_of(document).models
    if not models:
        raise refusal(root, f"`{root.name}` is not a robot")
    try:
        robot = mechanism_of(models[0], vendors=True)
    except DescriptionError as error:
        raise refusal(error.element, str(error)) from None
    if not robot.links:
        raise refusal(root, "the robot has no links")
    _refuse_broken(root, robot)
    robot = without_empty_shapes(robot)
    made = plan(document, robot, options)
    context = Context(options, made)
    context.losses.extend(made.losses)
    writer = _Writer(document, robot, context)
    try:
        text = with_line_ends(writer.write(), document.source.text)
    except DescriptionError as error:
        raise refusal(error.element, str(error)) from None
    written = read_result(text, document, Kind.SDF)
    assert written.root is not None
    source = expected(robot, made, context)
    try:
        result = read_back(written, context, writer.sdf)
    except (DescriptionError, PoseError) as error:
        raise refusal(root, f"with what is in <gazebo> blocks the result cannot be read: {error}") from None
    context.ledger.close(root)
    context.ledger.prove(written.root)
    contents = (of_urdf(root_of(document).models[0]), of_model(root_of(written).models[0]))
    copies = context.ledger.copies
    comparison = Comparison(source, result, correspondence(made, context), contents, copies=copies)
    return conversion(document, text, written, context.losses, [comparison], verified=verified)


def _refuse_broken(root: Element, robot: Mechanism) -> None:
    """Raise NotConvertible where names do not determine which link or joint is meant."""
    for kind in ("link", "joint"):
        seen: set[str] = set()
        for element in root.children(kind):
            name = element.attributes.get("name", "")
            if name in seen or not name:
                reason = f"there is another {element.title}" if name else f"a {kind} has no name"
                raise refusal(element, reason)
            seen.add(name)
    for joint in robot.joints.values():
        for end in (joint.parent, joint.child):
            if end not in robot.links and (end != WORLD or end == joint.child):
                raise refusal(joint.element, f"joint `{joint.name}` names link `{end}`, which does not exist")
    if loops := robot.loops():
        raise refusal(loops[0].element, f"joint `{loops[0].name}` closes a loop or is a second parent")


class _Writer:
    """Writes the model in the order of the document."""

    def __init__(self, document: Document, robot: Mechanism, context: Context) -> None:
        assert document.root is not None
        self.root: Element = document.root
        self.robot = robot
        self.context = context
        self.materials = Materials(root_of(document).models[0], context)
        self.links = Links(context, self.materials)
        self.materials.uri = self.links.uri
        self.joints = Joints(context)
        self.frames: dict[str, list[Xml]] = {}
        """Merged link → the frames that its joint and it leave."""
        self.carriers = {joint.child: joint for joint in reversed(list(robot.joints.values()))}
        self.sdf = Xml("sdf", None, version=str(context.options.version))
        self.actuators: list[tuple[Element, Node]] = []
        self.model = self.sdf.add("model", None, name=legal(robot.name) if robot.name else "robot")

    def write(self) -> str:
        context = self.context
        context.ledger.take(self.root)
        context.carry_attributes(self.root, self.model)
        origin = self.root.find("origin")
        if origin is not None:
            context.ledger.take(origin)
            pose = pose_text(self.root) or pose_of(origin_of(self.root))
            if pose is not None or has_custom(origin):
                context.carry(origin, self.model.add("pose", pose or "0 0 0 0 0 0"))
        self._make_links()
        later: list[Element] = []
        for entry in self.root.nodes:
            if isinstance(entry, Comment):
                self.context.ledger.take_comment(entry)
                self.model.extend(entry)
            elif not isinstance(entry, Element):
                continue
            elif entry.name == "gazebo":
                later.append(entry)
            else:
                self._entry(entry)
        self._drive()
        self._keep_inertials()
        extensions = Extensions(self.context)
        for block in later:
            extensions.apply(block, self.model)
        names = FollowedNames(self.context, root_of(self.root.document).models[0])
        for copy in self.context.copies:
            names.follow(*copy)
        keep_frictions_of_drake(self.context, self.root)
        self.materials.close()
        self._declare()
        before = [node for node in self.root.document.prolog if isinstance(node, Comment)]
        if self.root.document.is_expanded:
            before = [comment for comment in before if not _is_of_xacro(comment.text)]
        after = [node for node in self.root.document.epilog if isinstance(node, Comment)]
        return render(self.sdf, before, after)

    def _make_links(self) -> None:
        """Empty links for all that survive, so that merged ones have where to go."""
        plan = self.context.plan
        for name, link in self.robot.links.items():
            if plan.is_merged(name) or name in plan.dropped_links:
                continue
            world = plan.is_world(name)
            if world and not link.geometries and (link.body is None or link.body.mass <= 0):
                continue
            node = Xml("link", None, name=plan.names.links[name])
            self.context.links[name] = node
            self.joints.place(self.carriers.get(name), name, node)

    def _entry(self, entry: Element) -> None:
        name = entry.attributes.get("name", "")
        if entry.name == "link":
            self._link(entry, name)
        elif entry.name == "joint":
            if name in self.robot.joints and self.robot.joints[name].element is entry:
                self._joint(name)
            else:
                self.context.ledger.take_whole(entry)  # another one takes its place
        elif entry.name == "material":
            return
        elif entry.name == "drake:joint":
            self._vendor_joint(entry, name)
        elif entry.name == "frame" and entry.get("link") in self.context.plan.dropped_links:
            text = f"{entry.title} is left out with its link"
            self.context.lose(entry, LossKind.DROPPED_FRAME, text)
        elif entry.name == "frame" and (frame := self.context.vendors.frame(entry)) is not None:
            self.context.carry(entry, self.model.append(frame))
        elif entry.name == "transmission":
            self.context.keep(entry, self.model)
            self.actuators.append((entry, self.model.nodes[-1]))
        elif entry.name != "origin":
            self.context.keep(entry, self.model)

    def _vendor_joint(self, entry: Element, name: str) -> None:
        joint = self.robot.joints.get(name)
        if joint is not None and joint.element is entry:
            self._joint(name)
        elif joint is None or joint.kind != "floating":
            # Else it is there for libsdformat as well, in the place of the floating joint.
            text = f"{entry.title} is left out: Drake has no `drake:joint` of type `{entry.attributes.get('type', '')}`"
            self.context.lose(entry, LossKind.APPROXIMATED_JOINT, text)
        else:
            self.context.ledger.take_whole(entry)

    def _drive(self) -> None:
        """Put what vendors say of actuators into the joints, when all are there."""
        self.context.vendors.report_actuators(self.context.joints)
        for entry, kept in self.actuators:
            part = root_of(entry.document).part_of(entry)
            done = (
                self.context.vendors.drive(part, self.context.joints)
                if isinstance(part, Transmission)
                else set()
            )
            if done and isinstance(kept, Xml):
                without(kept, entry, done)

    def _link(self, entry: Element, name: str) -> None:
        plan = self.context.plan
        survivor, offset = plan.home[name]
        if name in plan.dropped_links and not plan.is_world(name):
            text = f"{entry.title} is left out, as Gazebo drops it: it, or a link above it, has no mass"
            self.context.lose(entry, LossKind.MASSLESS_LINK, text)
            return
        self.context.ledger.take(entry)
        node = self.context.links.get(name)
        if node is not None:
            self.model.append(node)
        if survivor in self.context.links:
            self.links.fill(entry, survivor, offset)
        else:
            self._leave_world(entry)
        if node is not None and plan.is_world(name):
            self._anchor(name)

    def _leave_world(self, entry: Element) -> None:
        """Report what a link `world` says without having a shape."""
        for child in entry.children():
            if child.name == "inertial":
                text = "<inertial> of the world means nothing and is left out"
                self.context.lose(child, LossKind.DROPPED_ELEMENT, text, Severity.INFO)
            elif child.name in {"collision", "visual"}:
                text = f"{child.title} of the world is left out: it has no shape"
                self.context.lose(child, LossKind.UNSUPPORTED_GEOMETRY, text)

    def _anchor(self, name: str) -> None:
        """A link for what the link `world` carries, fixed to the world."""
        names = self.context.plan.names
        link = names.links[name]
        own = names.free(f"{WORLD}_joint")
        joint = self.model.add("joint", None, name=own, type="fixed")
        joint.add("parent", WORLD)
        joint.add("child", link)
        text = f"what link `{WORLD}` carries goes to link `{link}`, which joint `{own}` fixes to the world"
        self.context.note(self.robot.links[name].element, LossKind.RENAMED, text)

    def _joint(self, name: str) -> None:
        joint = self.robot.joints[name]
        if name in self.context.plan.dropped_joints:
            text = f"{joint.element.title} is left out, as Gazebo drops it"
            self.context.lose(joint.element, LossKind.MASSLESS_LINK, text)
        elif name not in self.context.plan.merged_joints:
            if name in self.context.plan.locked_joints:
                text = f"{joint.element.title} stays fixed; Gazebo makes a revolute joint of it whose limits are both 0"
                self.context.note(joint.element, LossKind.APPROXIMATED_JOINT, text, Severity.INFO)
            self.joints.write(joint, self.model)
        elif self.context.options.has_frames:
            child = self.robot.links[joint.child].element
            self.frames[joint.child] = self.joints.leave_frame(joint, child)
            self.model.extend(*self.frames[joint.child])
        else:
            self.joints.merge(joint)

    def _keep_inertials(self) -> None:
        """Write the inertials that were summed up where their links are, or the frames that those became."""
        for name, own in self.links.own_inertials.items():
            frames = self.frames.get(name)
            (self.context.links[name] if frames is None else frames[-1]).append(own)

    def _declare(self) -> None:
        """Say which packages became models, and declare the prefixes that the text uses, as the source does."""
        if packages := " ".join(self.context.packages):
            self.model.attributes[PACKAGES] = packages
        for prefix in sorted(undeclared_prefixes(self.model)):
            given = self.context.namespaces.get(prefix) or self.root.declared.get(prefix)
            uri = given or _NAMESPACES.get(prefix) or f"urn:{prefix}"
            self.sdf.attributes[f"xmlns:{prefix}"] = uri


def _is_of_xacro(comment: str) -> bool:
    """Is it one of those that xacro writes above what it has expanded?"""
    text = comment.strip(" |")
    ruled = not text.strip("=")
    return ruled or text.startswith(("This document was autogenerated by xacro", "EDITING THIS FILE BY HAND"))
