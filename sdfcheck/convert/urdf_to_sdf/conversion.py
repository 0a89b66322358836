"""The conversion from end to end."""

from __future__ import annotations

import numpy as np

from sdfcheck.convert.loss import LossKind, refusal
from sdfcheck.convert.result import Comparison, Conversion, conversion
from sdfcheck.convert.urdf_to_sdf.context import KEPT, Context, pose_of, pose_text
from sdfcheck.convert.urdf_to_sdf.extensions import Extensions
from sdfcheck.convert.urdf_to_sdf.joints import Joints, frame_of
from sdfcheck.convert.urdf_to_sdf.links import Links
from sdfcheck.convert.urdf_to_sdf.materials import Materials
from sdfcheck.convert.urdf_to_sdf.naming import WORLD, legal
from sdfcheck.convert.urdf_to_sdf.options import Options
from sdfcheck.convert.urdf_to_sdf.outcome import correspondence, expected, read_back
from sdfcheck.convert.urdf_to_sdf.plan import plan
from sdfcheck.convert.urdf_to_sdf.plugin_names import PluginNames
from sdfcheck.convert.writer import Node, comment_of, render, undeclared_prefixes, with_line_ends
from sdfcheck.robot.errors import DescriptionError
from sdfcheck.robot.motion.flatten import mechanism_of
from sdfcheck.robot.motion.mechanism import Mechanism
from sdfcheck.robot.motion.poses import PoseError, origin_of
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element

_NAMESPACES = {
    KEPT: "http://ros.org/wiki/urdf/XML",
    "drake": "http://drake.mit.edu",
}


@np.errstate(all="ignore")  # what overflows is not equal to anything
def urdf_to_sdf(document: Document, options: Options, *, verified: bool = True) -> Conversion:
    """Convert a URDF document to a text of SDFormat.

    Raises NotConvertible.
    """
    root = document.root
    assert root is not None
    try:
        robot = mechanism_of(root_of(document).models[0])
    except DescriptionError as error:
        raise refusal(error.element, str(error)) from None
    if not robot.links:
        raise refusal(root, "the robot has no links")
    _refuse_broken(root, robot)
    made = plan(document, robot, options)
    context = Context(options, made, list(made.losses))
    writer = _Writer(document, robot, context)
    text = writer.write()
    source = expected(robot, made, context)
    try:
        result = read_back(text, document.path, context)
    except (DescriptionError, PoseError) as error:
        raise refusal(root, f"with what is in <gazebo> blocks the result cannot be read: {error}") from None
    comparison = Comparison(source, result, correspondence(made, context))
    text = with_line_ends(text, document.source.text)
    return conversion(document, text, context.losses, [comparison], verified=verified)


def _refuse_broken(root: Element, robot: Mechanism) -> None:
    """Raise NotConvertible where names do not tell which link or joint is meant."""
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
        self.materials = Materials(self.root, context)
        self.links = Links(context, self.materials)
        self.materials.uri = self.links.uri
        self.joints = Joints(context)
        self.carriers = {joint.child: joint for joint in reversed(list(robot.joints.values()))}
        self.sdf = Node("sdf", None, version=str(context.options.version))
        self.model = self.sdf.add("model", None, name=legal(robot.name) if robot.name else "robot")

    def write(self) -> str:
        if self.root.has("origin"):
            pose = pose_text(self.root) or pose_of(origin_of(self.root))
            if pose is not None:
                self.model.add("pose", pose)
        self._make_links()
        later: list[Element] = []
        for entry in self.root:
            if (comment := comment_of(entry)) is not None:
                self.model.children.append(comment)
            elif not isinstance(entry.tag, str):
                continue
            elif entry.name == "gazebo":
                later.append(entry)
            else:
                self._entry(entry)
        extensions, plugin_names = Extensions(self.context), PluginNames(self.context)
        for block in later:
            extensions.apply(block, self.model)
            plugin_names.report(block)
        self._declare()
        before = [c for c in map(comment_of, self.root.itersiblings(preceding=True)) if c is not None]
        if self.root.document.is_expanded:
            before = [comment for comment in before if not _is_of_xacro(comment.text)]
        after = [c for c in map(comment_of, self.root.itersiblings()) if c is not None]
        return render(self.sdf, before[::-1], after)

    def _make_links(self) -> None:
        """Empty links for all that survive, so that merged ones have where to go."""
        plan = self.context.plan
        for name, link in self.robot.links.items():
            if plan.is_merged(name):
                continue
            world = plan.is_world(name)
            if world and not link.geometries and (link.body is None or link.body.mass <= 0):
                continue
            node = Node("link", None, name=plan.names.links[name])
            self.context.links[name] = node
            self.joints.place(self.carriers.get(name), name, node)

    def _entry(self, entry: Element) -> None:
        name = entry.attributes.get("name", "")
        if entry.name == "link":
            self._link(entry, name)
        elif entry.name == "joint":
            self._joint(name)
        elif entry.name == "material":
            return
        elif entry.name == "drake:joint":
            text = f"{entry.title} is spelled otherwise in SDFormat; what it carries floats freely"
            self.context.lose(entry, LossKind.APPROXIMATED_JOINT, text)
        elif entry.name != "origin":
            self.context.keep(entry, self.model)

    def _link(self, entry: Element, name: str) -> None:
        plan = self.context.plan
        survivor, offset = plan.home[name]
        node = self.context.links.get(name)
        if node is not None:
            self.model.append(node)
        if survivor in self.context.links:
            self.links.fill(entry, survivor, offset)
        if node is not None and plan.is_world(name):
            self._anchor(name)

    def _anchor(self, name: str) -> None:
        """A link for what the link `world` carries, fixed to the world."""
        names = self.context.plan.names
        link = names.links[name]
        joint = self.model.add("joint", None, name=names.free(f"{WORLD}_joint"), type="fixed")
        joint.add("parent", WORLD)
        joint.add("child", link)
        text = f"what link `{WORLD}` carries goes to link `{link}`, fixed to the world"
        self.context.lose(self.robot.links[name].element, LossKind.RENAMED, text)

    def _joint(self, name: str) -> None:
        joint = self.robot.joints[name]
        if name not in self.context.plan.merged_joints:
            self.joints.write(joint, self.model)
        elif self.context.options.has_frames:
            self.model.children += frame_of(joint, self.context)

    def _declare(self) -> None:
        """Declare the prefixes that the text uses, as the source does."""
        known = {prefix: uri for prefix, uri in self.root.nsmap.items() if prefix}
        for prefix in sorted(undeclared_prefixes(self.model)):
            uri = known.get(prefix) or _NAMESPACES.get(prefix) or f"urn:{prefix}"
            self.sdf.attributes[f"xmlns:{prefix}"] = uri


def _is_of_xacro(comment: str) -> bool:
    """Is it one of those that xacro writes above what it has expanded?"""
    text = comment.strip(" |")
    ruled = not text.strip("=")
    return ruled or text.startswith(("This document was autogenerated by xacro", "EDITING THIS FILE BY HAND"))
