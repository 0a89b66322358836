"""From an SDF model to a URDF robot."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace
from pathlib import Path

import numpy as np

from sdfcheck.convert.comparison import Correspondence, Counterpart
from sdfcheck.convert.include_expansion import needs_writing_out
from sdfcheck.convert.ledger import TEXT, Ledger, Words
from sdfcheck.convert.loss import LossKind, NotConvertible, refusal
from sdfcheck.convert.migrate.migrate import written_out
from sdfcheck.convert.result import Comparison, Conversion, conversion, read_result
from sdfcheck.convert.sdf_to_urdf.extensions import (
    around_root,
    carry_around,
    carry_comments,
    carry_custom,
    keep_base,
    keep_frame,
    keep_joint,
    keep_place,
    keep_static,
    model_extensions,
    namespace_of,
    of_frame,
    write_actuators,
)
from sdfcheck.convert.sdf_to_urdf.joints import add_edge, add_fixed
from sdfcheck.convert.sdf_to_urdf.links import DRAKE_SHAPES, add_link, coupling, define_colors, understood
from sdfcheck.convert.sdf_to_urdf.plan import (
    WORLD,
    Context,
    Loops,
    Options,
    Unsupported,
    arrange,
    choose,
    find_files,
    is_same,
    lay_out,
    named,
    others,
    tidy,
)
from sdfcheck.convert.separated import is_marked, separated
from sdfcheck.convert.settings_tree import of_model, of_urdf
from sdfcheck.convert.vendor_spelling import uses
from sdfcheck.convert.writer import render, undeclared_prefixes, with_line_ends, without_empty_shapes
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.graph import ENDLESS, Model
from sdfcheck.robot.motion.flatten import mechanism_of
from sdfcheck.robot.motion.mechanism import Mechanism
from sdfcheck.robot.motion.origin import PoseError
from sdfcheck.robot.motion.poses import inverse
from sdfcheck.robot.part import MergedFrame
from sdfcheck.robot.root import root_of
from sdfcheck.source.altered import Xml
from sdfcheck.source.document import Document, Element
from sdfcheck.source.errors import DescriptionError
from sdfcheck.source.sniff import Kind

# The elements of SDFormat that have a counterpart in URDF, and the attributes in which they say something.


_ELEMENTS = {
    "axis": "",
    "axis2": "",
    "box": "",
    "capsule": "",
    "collision": "name",
    "cylinder": "",
    "dynamics": "",
    "ellipsoid": "",
    "frame": "name attached_to",
    "geometry": "",
    "include": "merge",
    "inertia": "",
    "inertial": "auto",
    "joint": "name type",
    "limit": "",
    "link": "name",
    "material": "",
    "mesh": "optimization",
    "mimic": "joint axis",
    "model": "name canonical_link placement_frame",
    "plane": "",
    "sdf": "version",
    "sphere": "",
    "visual": "name",
    "world": "name",
}
_VALUES = {
    **dict.fromkeys(("ixx", "ixy", "ixz", "iyy", "iyz", "izz", "mass"), ""),
    **dict.fromkeys(("length", "normal", "radii", "radius", "scale", "size", "uri"), ""),
    **dict.fromkeys(("child", "parent", "use_parent_model_frame"), ""),
    **dict.fromkeys(("damping", "effort", "friction", "lower", "upper", "velocity"), ""),
    **dict.fromkeys(("multiplier", "offset", "reference"), ""),
    "pose": "degrees frame relative_to rotation_format",
    "xyz": "expressed_in",
}
WORDS: Words = {
    **{name: frozenset(attributes.split()) for name, attributes in _ELEMENTS.items()},
    **{name: frozenset((TEXT, *attributes.split())) for name, attributes in _VALUES.items()},
}


# The end of a conversion: what is around the model, and what nobody entered.


def close(context: Context, models: list[Element]) -> None:
    """Enter what is around the model, and report what nobody entered."""
    at = context.scope.place.parent
    while at is not None:
        context.ledger.take(at)
        carry_custom(context, context.root, at, "")
        carry_around(context, context.root, at)
        at = at.parent
    for other in others(context.scope.place.document, context.scope):
        message = f"{other.title} is not a part of model `{context.scope.name}`"
        context.ledger.lose(LossKind.DROPPED_ELEMENT, other, message)
    for model in models:
        around = model.parent
        while around is not None and not context.ledger.is_entered(around):
            _leave_custom(context, around)
            around = around.parent
    for element in (context.scope.place.document.root, *models):
        if element is not None:
            context.ledger.close(element)


def _leave_custom(context: Context, around: Element) -> None:
    """Custom data of an included file that is not in its model stays there."""
    context.ledger.take(around)
    for name in around.attributes:
        if ":" in name:
            text = f"attribute `{name}` of `{around.name}` in the included file is left out"
            context.ledger.lose_attribute(around, name, text)
    for child in around.children():
        if child.is_custom and not context.ledger.is_entered(child):
            text = f"`{child.name}` in `{around.name}` of the included file is left out"
            context.ledger.lose(LossKind.DROPPED_ELEMENT, child, text)


# The parts of models in addition to links and joints: nested models, includes, frames, flags.


def enter_models(context: Context) -> list[Element]:
    """Enter the models themselves and keep what extensions can hold of them; returns their elements."""
    elements = [context.scope.element]
    if context.scope.place is not context.scope.element:
        _enter_include(context, context.scope.place, "")
    _enter(context, context.scope.element, "")
    for name, frame in context.frames.items():
        if isinstance(frame, Model) and frame.is_readable:
            message = f"model `{name}` is made a part of the robot; its names begin with `{name.replace('::', '__')}__`"
            context.ledger.note(LossKind.MERGED_MODEL, frame.place, message)
            brought, scope = frame.element, name
        elif isinstance(frame, MergedFrame):
            brought, scope = frame.model.element, name.rpartition("::")[0]
        else:
            continue
        if frame.place.name == "include":
            _enter_include(context, frame.place, scope)
        elements.append(brought)
        _enter(context, brought, scope)
    for element in elements:
        _report_missing(context, element)
    return elements


def _report_missing(context: Context, model: Element) -> None:
    for include in model.children("include"):
        if not context.ledger.is_entered(include):
            message = f"{include_title(include)} is left out: it cannot be read"
            context.ledger.lose(LossKind.UNKNOWN_REFERENCE, include, message)


def _enter(context: Context, model: Element, scope: str) -> None:
    pose = model.find("pose")
    context.ledger.take(model)
    if model is not context.scope.element:
        static = model.find("static")
        context.ledger.take(pose)
        context.ledger.take(static, TEXT)
        if static is not None and static.content.lower() in {"true", "1"} and not context.scope.is_static:
            message = f"{model.title} is static, and what it is part of is not: it moves with it"
            context.ledger.note(LossKind.DROPPED_ELEMENT, static, message)
    model_extensions(context, model, scope)
    carry_custom(context, context.root, model, scope)
    carry_around(context, context.root, model)


def _enter_include(context: Context, include: Element, scope: str) -> None:
    model_extensions(context, include, scope)
    context.ledger.take_parts(include, "uri", "pose")
    for name in ("name", "static", "placement_frame"):
        context.ledger.take(include.find(name), TEXT)
    for parameters in include.children("experimental:params"):
        context.ledger.take_whole(parameters)
    message = f"{include_title(include)} is written out"
    context.ledger.note(LossKind.EXPANDED_INCLUDE, include, message, Severity.INFO)


def include_title(include: Element) -> str:
    """The name of an include's content in a sentence."""
    uri = include.find("uri")
    return f"what `{uri.content}` brings" if uri is not None else "what is included"


def add_frames(context: Context) -> None:
    """Write frames as massless links if that is wanted, else keep them as they are."""
    for name, frame in context.frames.items():
        if frame.kind != "frame":
            continue
        place = context.read.frames.get(name)
        if place is None:
            message = f"frame `{name}` is left out: it moves with no link"
            context.ledger.lose(LossKind.DROPPED_FRAME, frame.element, message)
            continue
        link, pose = place
        own, pose = context.frame_names[name], of_frame(context, link, pose)
        if not context.options.frames:
            keep_frame(context, own, context.links[link], pose, frame)
            continue
        carry_comments(context, context.root, frame.element)
        context.root.add("link", name=own)
        add_fixed(context, f"{own}_joint", context.links[link], own, pose)
        context.ledger.take_parts(frame.element, "pose")


def convert(document: Document, options: Options | None = None, *, verified: bool = True) -> Conversion:
    """Convert the model of a document.

    Raises:
        WrongUsage: the document has no model, or several and none is chosen.
        NotConvertible: URDF cannot say it, or it cannot be worked out.
    """
    options = options or Options()
    source, brought = document, list[Element]()
    if needs_writing_out(document):
        document, expansion = written_out(document)
        brought = expansion.expanded
    if is_marked(document):
        # Marks that somebody has changed since may say what URDF cannot: then the document counts as it is.
        with suppress(NotConvertible):
            done = _converted(source, separated(document), brought, options, verified=verified)
            if done.verification is None or done.verification.is_equal:
                return done
    return _converted(source, document, brought, options, verified=verified)


def _converted(
    source: Document,
    document: Document,
    brought: list[Element],
    options: Options,
    *,
    verified: bool,
) -> Conversion:
    """Convert a document, as which the source is read; the includes that ``brought`` it are written out there."""
    scope = choose(document, options.model)
    try:
        context = _prepare(scope, options, source.path.parent)
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
    for include in brought:
        context.ledger.note(
            LossKind.EXPANDED_INCLUDE, include, f"{include_title(include)} is written out", Severity.INFO
        )
    return conversion(source, text, written, context.ledger.losses, [comparison], verified=verified)


def _text(context: Context) -> str:
    """The file, with the prefixes declared that it uses."""
    element = context.scope.element
    before, after = (around_root(element, preceding=preceding) for preceding in (True, False))
    for prefix in sorted(undeclared_prefixes(context.root)):
        uri = (
            context.namespaces.get(prefix)
            or element.namespaces.get(prefix)
            or namespace_of(element.document, prefix)
        )
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
    root = Xml("robot", name=scope.name)
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
    context.root.extend(*context.blobs.values())
    find_files(context)
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
    return Correspondence(
        links=links,
        joints=dict(context.joints),
        parts=context.parts,
        unlimited=min(context.options.unlimited, ENDLESS),
        dropped_joints=frozenset({joint.name for joint in context.made.loops} | context.floating),
        dropped_shapes=context.dropped_shapes,
        changed_bodies=frozenset(context.heavier),
    )
