"""From an SDF model to a URDF robot."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from sdfcheck.convert.contents.of_sdf import of_model
from sdfcheck.convert.contents.of_urdf import of_urdf
from sdfcheck.convert.empty_shapes import without_empty_shapes
from sdfcheck.convert.ledger import TEXT, Ledger
from sdfcheck.convert.loss import LossKind, refusal
from sdfcheck.convert.result import Comparison, Conversion, conversion, read_result
from sdfcheck.convert.rewrite.written_out import WrittenOut, needs_writing_out, written_out
from sdfcheck.convert.sdf_to_urdf.closing import close
from sdfcheck.convert.sdf_to_urdf.comments import around_root
from sdfcheck.convert.sdf_to_urdf.context import Context
from sdfcheck.convert.sdf_to_urdf.custom import namespace_of
from sdfcheck.convert.sdf_to_urdf.extensions import keep_base, keep_place, keep_static
from sdfcheck.convert.sdf_to_urdf.joints import add_edge, add_fixed
from sdfcheck.convert.sdf_to_urdf.kept_joints import keep_joint
from sdfcheck.convert.sdf_to_urdf.links import add_link
from sdfcheck.convert.sdf_to_urdf.materials import define_colors
from sdfcheck.convert.sdf_to_urdf.models import add_frames, enter_models, include_title
from sdfcheck.convert.sdf_to_urdf.options import Loops, Options, Unsupported
from sdfcheck.convert.sdf_to_urdf.plan.arrange import WORLD, arrange
from sdfcheck.convert.sdf_to_urdf.plan.choose import choose
from sdfcheck.convert.sdf_to_urdf.plan.layout import is_same, lay_out, tidy
from sdfcheck.convert.sdf_to_urdf.plan.meaning import coupling, understood
from sdfcheck.convert.sdf_to_urdf.plan.naming import named
from sdfcheck.convert.sdf_to_urdf.shapes import DRAKE_SHAPES, HELD
from sdfcheck.convert.sdf_to_urdf.vendor_tags import write_actuators
from sdfcheck.convert.sdf_to_urdf.words import WORDS
from sdfcheck.convert.vendor.spelling import uses
from sdfcheck.convert.verify import Correspondence, Counterpart
from sdfcheck.convert.writer import Node, render, undeclared_prefixes, with_line_ends
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.errors import DescriptionError
from sdfcheck.robot.model import Model
from sdfcheck.robot.motion.flatten import mechanism_of
from sdfcheck.robot.motion.mechanism import Mechanism
from sdfcheck.robot.motion.poses import PoseError
from sdfcheck.robot.motion.rotations import inverse
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element
from sdfcheck.source.sniff import Kind


def convert(
    document: Document, options: Options | None = None, *, folder: Path | None = None, verified: bool = True
) -> Conversion:
    """Convert the model of a document; ``folder`` is where the result is going to be.

    Raises:
        WrongUsage: the document has no model, or several and none is chosen.
        NotConvertible: URDF cannot say it, or it cannot be worked out.
    """
    options = options or Options()
    source = document
    if needs_writing_out(document):
        document, _ = written_out(document)
    scope = choose(document, options.model)
    try:
        context = _prepare(scope, options, folder or document.path.parent)
        _write(context)
    except (DescriptionError, PoseError) as error:
        raise refusal(getattr(error, "element", scope.element), str(error)) from None
    text = _text(context)
    written = read_result(text, source, Kind.URDF)
    assert written.root is not None
    try:
        result = mechanism_of(root_of(written).models[0], vendors=True)
    except DescriptionError as error:
        raise refusal(scope.element, f"in the result, at {error.element.title}: {error}") from None
    for name in context.between:
        result.links[name] = replace(result.links[name], body=None)
    context.ledger.prove(written.root)
    contents = (of_model(scope), of_urdf(root_of(written).models[0]))
    copies = context.ledger.copies
    comparison = Comparison(_expected(context), result, _correspondence(context), contents, copies=copies)
    for include in document.expanded if isinstance(document, WrittenOut) else ():
        context.ledger.note(
            LossKind.EXPANDED_INCLUDE, include, f"{include_title(include)} is written out", Severity.INFO
        )
    return conversion(source, text, written, context.ledger.losses, [comparison], verified=verified)


def _text(context: Context) -> str:
    """The file, with the prefixes declared that it uses."""
    element = context.scope.element
    before, after = (around_root(element, preceding=preceding) for preceding in (True, False))
    for prefix in sorted(undeclared_prefixes(context.root)):
        uri = context.namespaces.get(prefix) or element.namespaces.get(prefix) or namespace_of(prefix)
        context.root.attributes[f"xmlns:{prefix}"] = uri
    return with_line_ends(render(context.root, before, after), element.document.source.text)


def _prepare(scope: Model, options: Options, folder: Path) -> Context:
    robot = without_empty_shapes(mechanism_of(scope, vendors=True))
    if not robot.links:
        raise refusal(scope.element, f"{scope.element.title} has no link")
    poses = scope.root.poses
    for_drake = uses(scope.element, "drake")
    natives = DRAKE_SHAPES if for_drake else frozenset[str]()
    meant = understood(robot, options.planes, natives)
    frames = dict(scope.all_nodes())
    canonical = scope.canonical_link
    canonical_name = next((name for name, frame in frames.items() if frame is canonical), "")
    made = arrange(meant, canonical_name)
    couplings = robot.joints.keys() - meant.joints.keys()
    naming, links, joints, places = named(meant, robot.frames, sorted(couplings))
    world = inverse(poses.in_scope(scope))
    layout = lay_out(meant, made, world, keep=options.keep_link_frames, naming=naming)
    root = Node("robot", name=scope.name)
    return Context(
        scope,
        poses,
        robot,
        meant,
        frames,
        made,
        layout,
        naming,
        links,
        joints,
        places,
        options,
        folder,
        Ledger(WORDS, "URDF"),
        root,
        natives=natives,
    )


def _write(context: Context) -> None:
    """Write the robot: colors, links, joints, frames, extensions."""
    define_colors(context)
    _add_root(context)
    for name in _in_order(context):
        add_link(context, name)
        _report_name(context, "link", name, context.links[name])
        _report_shift(context, name)
    for edge in context.made.edges:
        _report_name(context, "joint", edge.joint.name, context.joints[edge.joint.name])
        add_edge(context, edge)
    _tie_tops(context)
    _leave_out(context)
    add_frames(context)
    brought = enter_models(context)
    write_actuators(context)
    context.root.children.extend(context.blobs.values())
    close(context, brought)


def _in_order(context: Context) -> list[str]:
    """The links; the canonical one first, as consumers that count on that expect it."""
    names = list(context.robot.links)
    canonical = context.scope.canonical_link
    first = next((name for name in names if context.frames[name] is canonical), "")
    if not context.scope.element.attributes.get("canonical_link") or first in {"", names[0]}:
        return names
    message = f"link `{first}` goes first: a URDF does not say which link is the canonical one"
    context.ledger.note(LossKind.REORDERED, context.robot.links[first].element, message, Severity.INFO)
    return [first, *(name for name in names if name != first)]


def _add_root(context: Context) -> None:
    """The root of the URDF, where it is not a link of the model: the world, or a base for several trees."""
    made, scope = context.made, context.scope
    element = scope.element
    pose = element.find("pose")
    context.ledger.take_parts(element, "pose")
    static = element.find("static")
    context.ledger.take(static, TEXT)
    if scope.is_static:
        at = static if static is not None else element
        keep_static(context, at)
        message = f"static {element.title} is tied to the link `{WORLD}` by a fixed joint"
        context.ledger.note(LossKind.APPROXIMATED_JOINT, at, message)
    elif len(made.tops) > (0 if made.has_world else 1):
        _report_forest(context)
    if made.has_world or scope.is_static or len(made.tops) > 1:
        context.begins_in_world = True
        context.root.add("link", name=WORLD)
    else:
        _keep_place(context, pose)


def _keep_place(context: Context, pose: Element | None) -> None:
    """Keep the pose of a model whose root is a link: a URDF begins there, wherever it is."""
    root = context.made.tops[0]
    place = inverse(context.layout.frames[WORLD]) @ context.layout.frames[root]
    if is_same(place, np.eye(4)):
        return
    keep_place(context, tidy(place))
    at = context.robot.links[root].element.find("pose") if pose is None else pose
    message = (
        f"where {context.scope.element.title} stands is kept for libsdformat alone: "
        "a URDF is placed by who loads it"
    )
    context.ledger.note(
        LossKind.KEPT_AS_EXTENSION, context.scope.element if at is None else at, message, Severity.INFO
    )


def _report_forest(context: Context) -> None:
    tops, policy = context.made.tops, context.options.forest
    some = ", ".join(f"`{name}`" for name in tops[:5]) + (" …" if len(tops) > 5 else "")
    message = f"no joint ties {some} to one robot"
    at = context.robot.links[tops[-1]].element
    if policy is Unsupported.ERROR:
        raise refusal(at, message)
    message = f"{message}: {policy.value} joints are written, from the link `{WORLD}`"
    context.ledger.note(LossKind.APPROXIMATED_JOINT, at, message, Severity.ERROR)


def _tie_tops(context: Context) -> None:
    if not context.begins_in_world:
        return
    policy = Unsupported.FIXED if context.scope.is_static else context.options.forest
    start = context.layout.frames[WORLD]
    for name in context.made.tops:
        own = context.links[name]
        pose = inverse(start) @ context.layout.frames[name]
        joint = add_fixed(context, f"{own}_base", WORLD, own, pose, policy.value)
        if policy is Unsupported.FLOATING:
            keep_base(context, joint, pose)


def _leave_out(context: Context) -> None:
    """Joints that are not in the tree: those that close loops, and gearboxes."""
    for joint in context.made.loops:
        what = f"{joint.element.title} closes a loop, which URDF cannot have"
        if context.options.loops is Loops.ERROR:
            raise refusal(joint.element, f"{what}; --loops cut leaves it to libsdformat")
        keep_joint(context, joint)
        message = f"{what}: it is kept for libsdformat alone"
        context.ledger.note(LossKind.CLOSED_LOOP, joint.element, message, Severity.ERROR)
    apart = {name: joint for name, joint in context.read.joints.items() if joint.kind != "gearbox"}
    before = list(understood(Mechanism("", {}, apart)).joints.values())
    for joint in context.read.joints.values():
        if joint.kind != "gearbox":
            continue
        found = coupling(before, joint)
        if found is None:
            keep_joint(context, joint)
            message = f"URDF has no gearbox: {joint.element.title} is kept for libsdformat alone"
            severity = Severity.ERROR
        else:
            message = f"{joint.element.title} is written as a mimic of joint `{found[0].name}`"
            severity = Severity.WARNING
        context.ledger.lose(LossKind.APPROXIMATED_JOINT, joint.element, message, severity)


def _report_name(context: Context, kind: str, name: str, new: str) -> None:
    element = (context.robot.links if kind == "link" else context.robot.joints)[name].element
    scope, delimiter, _ = name.rpartition("::")
    name = f"{scope}{delimiter}{element.attributes.get('name', '')}"
    if new != name.replace("::", "__"):
        message = f"{kind} `{name}` is called `{new}`: in a URDF names are unique"
        context.ledger.note(LossKind.RENAMED, element, message)


def _report_shift(context: Context, name: str) -> None:
    link, frame = context.robot.links[name], context.layout.frames[name]
    edge = context.made.carriers.get(name)
    if edge is None or is_same(frame, link.pose):
        return
    distance = float(np.linalg.norm(frame[:3, 3] - link.pose[:3, 3]))
    how = f"by {distance:.3g} m" if distance > 1e-9 else "in place"
    message = (
        f"the frame of link `{name}` moves {how} to its joint `{edge.joint.name}`; "
        "--keep-link-frames keeps it"
    )
    context.ledger.note(LossKind.SHIFTED_LINK_FRAME, link.element, message)


def _expected(context: Context) -> Mechanism:
    """The robot that the result must be equal to: couplings that were reported as lost are not in it."""
    joints = dict(context.robot.joints)
    for name in context.unmimicked:
        joint = joints[name]
        joints[name] = replace(joint, axes=tuple(replace(axis, mimic=None) for axis in joint.axes))
    return Mechanism(context.robot.name, context.robot.links, joints, context.robot.frames)


def _correspondence(context: Context) -> Correspondence:
    links = {
        name: Counterpart(context.links[name], context.layout.within(name, link.pose))
        for name, link in context.robot.links.items()
    }
    kinds = {geometry.kind for link in context.robot.links.values() for geometry in link.geometries}
    return Correspondence(
        links=links,
        joints=dict(context.joints),
        parts=context.parts,
        unlimited=min(context.options.unlimited, 1e15),
        dropped_joints=frozenset({joint.name for joint in context.made.loops} | context.floating),
        dropped_geometries=frozenset(kinds - HELD - context.natives),
    )
