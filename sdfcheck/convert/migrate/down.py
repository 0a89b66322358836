"""Steps to an older version: each rewrites what the version does not have."""

from __future__ import annotations

import math
from pathlib import PurePosixPath

import numpy as np

from sdfcheck.convert.comparison import Counterpart
from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.migrate import migration as numbers
from sdfcheck.convert.migrate.migration import Migration, Node, Places, rename_in_plugins, title
from sdfcheck.convert.migrate.up import STATES
from sdfcheck.convert.writer import number, settled
from sdfcheck.formats.schema import Definition
from sdfcheck.formats.sdf.schema import schema
from sdfcheck.formats.sdf.values import floats
from sdfcheck.formats.version import NEWEST, Version
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.graph import Link, Scope
from sdfcheck.robot.motion.mass import MassProperties
from sdfcheck.robot.motion.origin import PoseError
from sdfcheck.robot.motion.poses import Array, from_rpy, transform, written_pose
from sdfcheck.robot.part import Namespace
from sdfcheck.robot.part import Node as RobotNode
from sdfcheck.robot.values import reference_of
from sdfcheck.source.errors import DescriptionError

# The directions of joint axes as older versions write them.


_MODEL = "__model__"
_FLAG = "use_parent_model_frame"
_CLOSE = 1e-15


def express_axes(migration: Migration) -> None:
    """Below 1.7: in the joint's frame or, flagged, in the model's; below 1.5 always in the model's."""
    places = Places(migration)
    changes: list[tuple[Node, Array, str]] = []
    for joint in migration.root.of("joint"):
        frame = places.frame(joint)
        if frame is None:
            continue
        axes = (*joint.children("axis"), *joint.children("axis2"))
        turned = ((axis, _turned(migration, places, frame, axis)) for axis in axes)
        changes += [(axis, *turn) for axis, turn in turned if turn is not None]
    for axis, turn, flag in changes:
        _write_axis(migration, axis, turn, flag)


def _turned(migration: Migration, places: Places, joint: RobotNode, axis: Node) -> tuple[Array, str] | None:
    try:
        turn, flag = _turn(migration, places, joint, axis)
        _vector(axis)
        return turn, flag
    except (PoseError, ValueError) as error:
        migration.lose(axis, f"the axis cannot be resolved: {error}", LossKind.UNKNOWN_REFERENCE)
        return None


def _turn(migration: Migration, places: Places, joint: RobotNode, axis: Node) -> tuple[Array, str]:
    """How to turn the numbers, and what the flag is to say (nothing: no flag)."""
    xyz, flag = axis.find("xyz"), axis.find(_FLAG)
    expressed = xyz.attributes.get("expressed_in", "").strip() if xyz is not None else ""
    flagged = flag is not None and flag.content.lower() in {"true", "1"}
    source = migration.source
    if not expressed and source < Version(1, 7) and (flagged or source < Version(1, 5)):
        expressed = _MODEL
    to_model = migration.goes_below(5)
    in_joint = places.poses.in_scope(joint)[:3, :3] if expressed or to_model else np.eye(3)
    if not expressed:
        return (in_joint if to_model else np.eye(3)), ""
    if expressed == _MODEL:
        return np.eye(3), "" if to_model else "true"
    in_model = places.poses.named(joint.scope, expressed)[:3, :3]
    return (in_model if to_model else in_joint.T @ in_model), ""


def _vector(axis: Node) -> Array:
    """The direction that an axis writes, shape (3,); raises ValueError."""
    xyz = axis.find("xyz")
    text = xyz.content if xyz is not None and xyz.content else "0 0 1"
    found = floats(text)
    if found is None or len(found) != len("xyz"):
        raise ValueError(f"`{text}` is not three numbers")
    return np.array(found)


def _write_axis(migration: Migration, axis: Node, turn: Array, flag: str) -> None:
    xyz, old = axis.find("xyz"), axis.find(_FLAG)
    if xyz is not None:
        xyz.unset("expressed_in")
    if np.abs(turn - np.eye(3)).max() > _CLOSE:
        (xyz or axis.add("xyz")).write(numbers.vector(turn @ _vector(axis)))
    elif xyz is None and migration.goes_below(5):
        axis.add("xyz").write("0 0 1")  # the default since 1.5; before, there must be one
    if flag and old is None:
        axis.enter(Node(_FLAG, flag), after=xyz)
    elif flag and old is not None and old.content.lower() not in {"true", "1"}:
        old.write(flag)
    elif not flag and old is not None:
        migration.merge(old)


# Capsules as what they are made of, for versions without: a cylinder and two spheres.


_OWNERS = frozenset({"collision", "visual"})


def split_capsules(migration: Migration) -> None:
    """Below 1.8, with poses in plain numbers."""
    capsules = migration.root.of("capsule")
    if capsules:
        migration.draft.read()
    for capsule in capsules:
        owner = capsule.parent.parent if capsule.parent is not None else None
        radius, length = _size(capsule, "radius"), _size(capsule, "length")
        if owner is None or owner.name not in _OWNERS or radius is None or length is None:
            continue
        if owner.find("geometry/capsule") is not capsule:
            continue  # nobody reads it
        try:
            at = written_pose(migration.draft.element(owner).find("pose"))
        except PoseError:
            continue
        for end, z in (("bottom", -length / 2), ("top", length / 2)):
            _add_sphere(owner, _free_name(owner, end), radius, at @ _lifted(z))
        capsule.name = "cylinder"
        text = f"the capsule of {title(owner)} is written as a cylinder and two spheres: {migration.target} has none"
        migration.lose(owner, text, LossKind.UNSUPPORTED_GEOMETRY)


def _size(capsule: Node, name: str) -> float | None:
    child = capsule.find(name)
    try:
        return float(child.content) if child is not None else None
    except ValueError:
        return None


def _lifted(z: float) -> Array:
    transform = np.eye(4)
    transform[2, 3] = z
    return transform


def _free_name(owner: Node, end: str) -> str:
    assert owner.parent is not None
    name = f"{owner.attributes.get('name')}_{end}"
    while name in {sibling.attributes.get("name") for sibling in owner.parent.children(owner.name)}:
        name += "_"
    return name


def _add_sphere(owner: Node, name: str, radius: float, pose: Array) -> None:
    assert owner.parent is not None
    copied = owner.copy()
    copied.attributes["name"] = name
    sphere = Node("sphere")
    capsule = copied.find("geometry/capsule")
    assert capsule is not None
    capsule.exchange([sphere])
    sphere.nodes = [Node("radius", number(radius))]
    owner.parent.enter(copied, after=owner)
    (copied.find("pose") or copied.add_first("pose")).write(numbers.pose(pose))


# Nested models written into the model around them, for versions without: ``arm::hand`` is ``arm__hand``.


_NAMED = frozenset({"link", "joint", "gripper", "model"})
_MOVED = _NAMED | {"plugin"}
_ENDS = ("parent", "child", "gripper_link", "palm_link")


def flatten(migration: Migration) -> None:
    """Below 1.5, with all poses plain: put nested models into those around them, the inmost first."""
    for top in [*migration.root.children("model"), *_in_worlds(migration.root)]:
        for nested in reversed([m for m in top.of("model") if not _is_inserted(m)]):
            _into_parent(migration, nested)


def _in_worlds(root: Node) -> list[Node]:
    return [model for world in root.children("world") for model in world.children("model")]


def _is_inserted(node: Node) -> bool:
    return any(part.name in {"state", "population"} for part in _above(node))


def _above(node: Node) -> list[Node]:
    found, at = [], node.parent
    while at is not None:
        found.append(at)
        at = at.parent
    return found


def _into_parent(migration: Migration, nested: Node) -> None:
    name = nested.attributes.get("name", "")
    outer = _pose(nested)
    _rename_ends(nested, name)
    _rename_in_plugins(migration, nested, name)
    parts: list[Node] = []
    own = {child.attributes.get("name") for child in nested.children() if child.name in _NAMED}
    turn = outer[:3, :3]
    for part in nested.children():
        if part.name not in _MOVED and not part.is_custom:
            if part.name not in {"pose", "static"}:
                text = f"{title(part)} of nested model `{name}` is left out: {migration.target} does not nest"
                migration.drop(part, text)
            continue
        part.take_out()
        _rename(part, name, own)
        if part.name == "link":
            inner = _pose(part)
            if np.abs(outer - np.eye(4)).max() > 0:
                (part.find("pose") or part.add_first("pose")).write(numbers.pose(outer @ inner))
        elif part.name == "joint" and np.abs(turn - np.eye(3)).max() > 0:
            _turn_axes(part, turn)
        parts.append(part)
    migration.note(nested, f"nested model `{name}` is written into the one around it", LossKind.MERGED_MODEL)
    for part in [nested, *nested.children()]:
        migration.enter_alone(part)
    if parts:
        nested.exchange(parts)
    else:
        nested.take_out()


def _rename_in_plugins(migration: Migration, nested: Node, name: str) -> None:
    inside = [child for child in nested.children() if child.name in _NAMED]
    own = {
        (child.name, child.attributes.get("name", "")): f"{name}__{child.attributes.get('name')}"
        for child in inside
    }
    rename_in_plugins(migration, nested, own)
    assert nested.parent is not None
    outside = {(kind, f"{name}::{old}"): new for (kind, old), new in own.items()}
    rename_in_plugins(migration, nested.parent, outside)


def _rename_ends(nested: Node, name: str) -> None:
    """In the model around it, what refers into the nested one."""
    assert nested.parent is not None
    for user in (*nested.parent.children("joint"), *nested.parent.children("gripper")):
        for end in user.of(*_ENDS):
            if end.content.startswith(f"{name}::"):
                end.write(f"{name}__{end.content[len(name) + 2 :]}")


def _pose(node: Node) -> Array:
    pose = node.find("pose")
    if pose is None or not pose.content:
        return np.eye(4)
    values = [float(part) for part in pose.content.split()]
    return transform(from_rpy(*values[3:6]), values[:3])


def _turn_axes(joint: Node, turn: Array) -> None:
    """Axes are in the model's frame, which is another one now."""
    for axis in (*joint.children("axis"), *joint.children("axis2")):
        xyz = axis.find("xyz")
        text = xyz.content if xyz is not None and xyz.content else "0 0 1"
        turned = turn @ np.array([float(part) for part in text.split()])
        (xyz or axis.add("xyz")).write(numbers.vector(turned))


def _rename(part: Node, model: str, own: set[str | None]) -> None:
    if part.name in _NAMED:
        part.attributes["name"] = f"{model}__{part.attributes.get('name')}"
    for end in part.of(*_ENDS):
        first = end.content.partition("::")[0]
        if first in own:
            end.write(f"{model}__{end.content}")


def flat_links(names: list[str]) -> dict[str, Counterpart]:
    """Where verification finds the links of nested models."""
    return {name: Counterpart(name.replace("::", "__")) for name in names if "::" in name}


# Automatic inertias as numbers, for versions that do not compute them.


_COMPONENTS = (("ixx", 0, 0), ("ixy", 0, 1), ("ixz", 0, 2), ("iyy", 1, 1), ("iyz", 1, 2), ("izz", 2, 2))


def write_inertias(migration: Migration) -> None:
    """Below 1.11: replace ``auto`` and densities by what comes out of them."""
    links = ((link, link.find("inertial")) for link in migration.root.of("link"))
    computed = [(link, own) for link, own in links if own is not None and _is_automatic(own)]
    places = Places(migration) if computed else None
    for link, inertial in computed:
        frame = places.frame(link) if places is not None else None
        if isinstance(frame, Link):
            try:
                _write(inertial, frame.automatic_mass())
            except (DescriptionError, PoseError) as error:
                migration.changed_bodies = True
                text = f"the automatic inertia of {title(link)} is lost: {error}"
                migration.lose(inertial, text, LossKind.CHANGED_INERTIA, Severity.ERROR)
    for inertial in migration.root.of("inertial"):
        inertial.unset("auto")
        _remove(migration, inertial)
    for collision in migration.root.of("collision"):
        _remove(migration, collision)


def _is_automatic(inertial: Node) -> bool:
    return inertial.attributes.get("auto", "").strip().lower() in {"true", "1"}


def _remove(migration: Migration, node: Node) -> None:
    for name in ("density", "auto_inertia_params"):
        for child in node.children(name):
            migration.merge(child)


def _write(inertial: Node, body: MassProperties) -> None:
    pose = inertial.find("pose")
    center = numbers.vector((*body.center, 0, 0, 0))
    if pose is not None:
        for name in ("relative_to", "rotation_format", "degrees"):
            pose.unset(name)
        pose.write(center)
    elif body.center.any():
        inertial.add("pose", center)
    (inertial.find("mass") or inertial.add("mass")).write(number(body.mass))
    inertia = inertial.find("inertia") or inertial.add("inertia")
    largest = float(abs(body.moments).max())
    for name, row, column in _COMPONENTS:
        component = inertia.find(name) or inertia.add(name)
        component.write(number(settled(float(body.moments[row, column]), largest)))


# Parts that the target's table does not have: taken out and reported, or kept on request.
#
# A name that no version knows has as little effect as before, and stays. On the way up so does what is
# newer than the target: consumers let a file use more than its version has.


_SHAPES = frozenset({"box", "capsule", "cone", "cylinder", "ellipsoid", "sphere", "mesh", "polyline"})
_KINDS = {"mimic": LossKind.DROPPED_MIMIC, "frame": LossKind.DROPPED_FRAME, "plugin": LossKind.DROPPED_PLUGIN}


def drop_leftovers(migration: Migration) -> None:
    """Leave what the target allows; elements and attributes with a prefix are nobody's but the author's."""
    if not migration.keep_unknown:
        _drop_in(migration, migration.root, schema(migration.target).root)


def _drop_in(migration: Migration, node: Node, definition: Definition) -> None:
    for name in list(node.attributes):
        if ":" in name or name == "xmlns" or name in definition.attributes:
            continue
        if any(name in known.attributes for known in _meanings(migration, definition)):
            text = f"attribute `{name}` of {title(node)} is left out: {migration.target} does not have it"
            migration.lose(node, text, LossKind.DROPPED_ELEMENT)
            node.unset(name)
    if definition.open or definition.type is not None:
        return
    for child in node.children():
        if child.is_custom or child.parent is not node or child in migration.kept:
            continue
        inner = definition.children.get(child.name)
        if inner is not None:
            _drop_in(migration, child, inner)
        elif any(child.name in known.children for known in _meanings(migration, definition)):
            _drop(migration, child)


def _meanings(migration: Migration, definition: Definition) -> list[Definition]:
    """The parent definitions of a place in the versions that the source may have."""
    source, target = migration.source.minor, migration.target.minor
    minors = range(source, target) if source < target else range(source, NEWEST.minor + 1)
    found = (schema(Version(1, minor)).at(definition.place) for minor in minors)
    return [known for known in found if known is not None]


def _drop(migration: Migration, node: Node) -> None:
    parent = node.parent
    text = f"{title(node)} is left out: {migration.target} does not have it there"
    if (
        node.name in _SHAPES
        and parent is not None
        and parent.name == "geometry"
        and parent.parent is not None
    ):
        text = f"{title(parent.parent)} is left out: {migration.target} does not have `{node.name}`"
        if parent.parent.parent is not None:
            migration.drop(parent.parent, text, LossKind.UNSUPPORTED_GEOMETRY)
        return
    severity = Severity.WARNING
    if node.name == "mimic":
        migration.lost_mimics = True
        severity = Severity.ERROR
    migration.drop(node, text, _KINDS.get(node.name, LossKind.DROPPED_ELEMENT), severity)


# Elements with another name in older versions, and the values that they write otherwise.


_ENDLESS = {"inf", "+inf", "infinity"}


def rename_states(migration: Migration) -> None:
    """Below 1.12."""
    older = {new: old for old, new in STATES.items()}
    for state in migration.root.of("state"):
        for node in [*state.standard()]:
            if node.name in older:
                node.name = older[node.name]


def write_limits(migration: Migration) -> None:
    """Below 1.10: no limit is ±1e16 for positions and -1 for effort and velocity."""
    for limit in migration.root.of("limit"):
        for child in limit.children():
            text = child.content.lower()
            endless, below = text in _ENDLESS, text.removeprefix("-") in _ENDLESS and text[:1] == "-"
            if child.name in {"effort", "velocity"} and (endless or below):
                child.write("-1")
            elif child.name in {"lower", "upper"} and (endless or below):
                child.write("-1e16" if below else "1e16")


def write_thread_pitch(migration: Migration) -> None:
    """Below 1.10: radians per meter, left-handed."""
    for joint in migration.root.of("joint"):
        pitch, old = joint.find("screw_thread_pitch"), joint.find("thread_pitch")
        if pitch is None:
            continue
        try:
            turned = number(-2 * math.pi / float(pitch.content))
        except (ValueError, ZeroDivisionError):
            continue
        if old is not None:
            old.write(turned)
            migration.merge(pitch)
        else:
            pitch.name = "thread_pitch"
            pitch.write(turned)


def name_plugins(migration: Migration) -> None:
    """Below 1.10 a plugin has a name."""
    for plugin in migration.root.of("plugin"):
        if not plugin.attributes.get("name", "").strip():
            name = PurePosixPath(plugin.attributes.get("filename", "plugin")).stem.removeprefix("lib")
            plugin.attributes["name"] = name
            migration.note(
                plugin, f"{title(plugin)} was given this name: older consumers want one", LossKind.RENAMED
            )


def rename_sensors(migration: Migration) -> None:
    """navsat was gps before 1.7, lidar ray before 1.6."""
    words = {"navsat": "gps"} if migration.goes_below(7) else {}
    if migration.goes_below(6):
        words |= {"lidar": "ray", "gpu_lidar": "gpu_ray"}
    for sensor in migration.root.of("sensor"):
        kind = sensor.attributes.get("type", "").strip()
        if kind in words:
            sensor.attributes["type"] = words[kind]
        for child in sensor.children():
            if child.name in words and sensor.find(words[child.name]) is None:
                child.name = words[child.name]


def rename_frame_ids(migration: Migration) -> None:
    """Below 1.12 only cameras say in which frame they see."""
    for sensor in migration.root.of("sensor"):
        frame_id, camera = sensor.find("frame_id"), sensor.find("camera")
        if frame_id is not None and camera is not None and camera.find("optical_frame_id") is None:
            frame_id.take_out()
            frame_id.name = "optical_frame_id"
            camera.enter(frame_id)


def put_gravity_into_physics(migration: Migration) -> None:
    """Below 1.6 gravity and the magnetic field are physics, and there is one physics."""
    for world in migration.root.children("world"):
        physics = list(world.children("physics"))
        kept = next((p for p in physics if p.attributes.get("default", "").lower() in {"true", "1"}), None)
        kept = kept or (physics[0] if physics else None)
        for other in physics:
            if other is not kept:
                migration.drop(other, f"{title(other)} is left out: {migration.target} has one physics")
        fields = [node for name in ("gravity", "magnetic_field") if (node := world.find(name)) is not None]
        if fields and kept is None:
            kept = Node("physics", type="ode")
            world.enter(kept, before=fields[0])
        for node in fields:
            assert kept is not None
            if kept.find(node.name) is None:
                node.take_out()
                kept.enter(node)
            else:
                migration.drop(node, f"{title(node)} is left out: the physics has its own")


def drop_frames(migration: Migration) -> None:
    """Below 1.7 nothing can depend on a frame any more; those of older sources are another thing."""
    if migration.source < Version(1, 7):
        return
    for holder in [migration.root, *migration.root.of("model", "world")]:
        for frame in holder.children("frame"):
            if frame.origin is not None and frame.origin.name != "frame":
                migration.merge(frame)  # it stood for a merged model, as an include that is written out says
                continue
            text = f"{title(frame)} is left out: before 1.7 nothing can be relative to it"
            migration.drop(frame, text, LossKind.DROPPED_FRAME)


def put_canonical_links_first(migration: Migration) -> None:
    """Below 1.7 a model moves with its first link."""
    for model in migration.root.of("model"):
        name, links = model.attributes.get("canonical_link", "").strip(), list(model.children("link"))
        if not name:
            continue
        named = next((link for link in links if link.attributes.get("name") == name), None)
        if named is None:
            migration.lose(model, f"canonical link `{name}` cannot be kept", LossKind.REORDERED)
        elif named is not links[0]:
            named.take_out()
            model.enter(named, before=links[0])
            migration.note(named, f"link `{name}` comes first: the model moves with it", LossKind.REORDERED)
        model.unset("canonical_link")


# Poses as older versions write them: plain numbers, relative to what the format prescribes.


_FORMAT = ("rotation_format", "degrees")


def resolve_poses(migration: Migration) -> None:
    """Write poses without what the target lacks: references, other spellings of rotations, placement frames."""
    places, everything = Places(migration), migration.goes_below(7)
    changes: list[tuple[Node, Node | None, Array]] = []
    for owner in migration.root.standard():
        pose = owner.find("pose")
        placed = migration.goes_below(8) and owner.name in {"model", "include"} and places.is_placed(owner)
        if not placed and (pose is None or not _needs_change(pose, everything)):
            continue
        try:
            refers = everything and pose is not None and bool(pose.attributes.get("relative_to", "").strip())
            plain = refers or placed
            element = migration.draft.element(owner).find("pose")
            changes.append((owner, pose, places.plain(owner) if plain else written_pose(element)))
        except (PoseError, KeyError) as error:
            migration.lose(pose or owner, f"the pose cannot be resolved: {error}", LossKind.UNKNOWN_REFERENCE)
    for owner, pose, value in changes:
        _write_pose(migration, owner, pose, value, everything=everything)


def _needs_change(pose: Node, everything: bool) -> bool:
    given = pose.attributes
    if everything and "relative_to" in given:
        return True
    return any(name in given for name in _FORMAT)


def _write_pose(
    migration: Migration, owner: Node, pose: Node | None, value: Array, *, everything: bool
) -> None:
    if migration.goes_below(8):
        owner.unset("placement_frame")
        if owner.name == "include" and (given := owner.find("placement_frame")) is not None:
            migration.merge(given)
    if pose is None:
        pose = owner.add_first("pose")
    text = numbers.pose(value)
    if _differs(pose, value):
        pose.write(text)
    for name in _FORMAT if migration.goes_below(9) else ():
        pose.unset(name)
    if everything or owner.name in {"model", "include"}:
        pose.unset("relative_to")


def _differs(pose: Node, value: Array) -> bool:
    """Does the text, read as plain radians, say something else?"""
    try:
        written = [float(part) for part in pose.content.split()]
    except ValueError:
        return True
    if not written and not pose.attributes.keys() & set(_FORMAT):
        return bool(np.abs(value - np.eye(4)).max() > 0)

    if len(written) != 6:
        return True
    return bool(np.abs(transform(from_rpy(*written[3:]), written[:3]) - value).max() > 1e-15)


def attach_joints_to_links(migration: Migration) -> None:
    """Below 1.8: a joint's parent and child are links; its pose stays where it was."""
    places = Places(migration)
    changes: list[tuple[Node, str, Array | None]] = []
    for joint in migration.root.of("joint"):
        frame = places.frame(joint)
        if frame is None:
            continue
        for role in ("parent", "child"):
            end = joint.find(role)
            named = places.named(frame, end.content) if end is not None else None
            if end is None or named is None or named.kind in {"link", "world"}:
                continue
            found = places.carrier(named)
            if found is None:
                text = f"{role} {end.content!r} of joint `{frame.name}` leads to no link"
                migration.lose(end, text, LossKind.UNKNOWN_REFERENCE)
                continue
            link, name = _as_seen(frame.scope, *found, named)
            moved = role == "child" and not reference_of(frame.element.find("pose"))
            try:
                changes.append((end, name, places.between(link, frame) if moved else None))
            except PoseError as error:
                migration.lose(end, f"the pose cannot be resolved: {error}", LossKind.UNKNOWN_REFERENCE)
    for end, name, pose in changes:
        migration.note(
            end, f"{end.name} `{end.content}` is written as its link `{name}`", LossKind.DROPPED_FRAME
        )
        end.write(name)
        own = end.parent.find("pose") if end.parent is not None else None
        if pose is not None and end.parent is not None and (own or np.abs(pose - np.eye(4)).max() > 0):
            own = own or end.parent.add_first("pose")
            own.write(numbers.pose(pose))
            for attribute in _FORMAT:
                own.unset(attribute)


def _as_seen(scope: Namespace, link: RobotNode, name: str, named: RobotNode) -> tuple[RobotNode, str]:
    """A link and its name from a scope above that of the frame that leads to it."""
    at = named.scope
    while at is not scope and isinstance(at.holder, Scope):
        name = f"{at.name}::{name}"
        at = at.scope
    return link, name


# Joints between the world and a model, for versions that have joints in models only.


_END_NAMES = ("parent", "child")


def move_world_joints(migration: Migration) -> None:
    """Below 1.10: into the one model that they are about; those of two models are lost."""
    worlds = [world for world in migration.root.children("world") if world.has("joint")]
    if not worlds:
        return
    places = Places(migration)
    for world in worlds:
        for joint in world.children("joint"):
            model = _only_model(world, joint)
            namesake = _namesake(joint, model) if model is not None else None
            if model is not None and namesake is None:
                _move(migration, places, joint, model)
            elif not migration.goes_below(7):
                reason = f"{migration.target} has no joints between models of a world"
                if model is not None and namesake is not None:
                    reason = (
                        f"{migration.target} has joints in models only, and in {title(model)} its name is that of a "
                        f"{namesake.name}"
                    )
                migration.drop(joint, f"{title(joint)} is left out: {reason}", severity=Severity.ERROR)


def _namesake(joint: Node, model: Node) -> Node | None:
    """The part of a model that has the name of a joint."""
    return next(
        (other for other in model.children() if other.attributes.get("name") == joint.attributes.get("name")),
        None,
    )


def _only_model(world: Node, joint: Node) -> Node | None:
    """The model that a joint connects with the world, or with itself."""
    ends = [end.content for name in _END_NAMES if (end := joint.find(name)) is not None]
    heads = {end.partition("::")[0] for end in ends if end != "world"}
    if len(ends) != len(_END_NAMES) or len(heads) != 1 or ends[1] == "world":
        return None
    models = {model.attributes.get("name"): model for model in world.children("model")}
    return models.get(heads.pop())


def _move(migration: Migration, places: Places, joint: Node, model: Node) -> None:
    try:
        pose, turns = _resolved(places, joint)
    except (PoseError, ValueError) as error:
        migration.lose(joint, f"the joint cannot be resolved: {error}", LossKind.UNKNOWN_REFERENCE)
        return
    if pose is not None and (own := joint.find("pose")) is not None:
        for name in ("relative_to", "rotation_format", "degrees"):
            own.unset(name)
        own.write(numbers.pose(pose))
    for xyz, direction in turns:
        xyz.unset("expressed_in")
        xyz.write(numbers.vector(direction))
    for end in filter(None, map(joint.find, _END_NAMES)):
        if end.content != "world":
            end.write(end.content.partition("::")[2] or "__model__")
    joint.take_out()
    model.enter(joint)
    text = f"{title(joint)} of the world is written into {title(model)}"
    migration.note(joint, text, LossKind.REORDERED)


def _resolved(places: Places, joint: Node) -> tuple[Array | None, list[tuple[Node, Array]]]:
    """Parts relative to frames of the world: the pose in the child, and axes in the joint."""
    own, frame = joint.find("pose"), places.frame(joint)
    refers = own is not None and bool(own.attributes.get("relative_to", "").strip())
    turns: list[tuple[Node, Array]] = []
    for axis in (*joint.children("axis"), *joint.children("axis2")):
        xyz = axis.find("xyz")
        expressed = xyz.attributes.get("expressed_in", "").strip() if xyz is not None else ""
        if xyz is None or not expressed or frame is None:
            continue
        turn = places.poses.in_scope(frame)[:3, :3].T @ places.poses.named(frame.scope, expressed)[:3, :3]
        turns.append((xyz, turn @ [float(part) for part in (xyz.content or "0 0 1").split()]))
    return (places.plain(joint) if refers else None), turns
