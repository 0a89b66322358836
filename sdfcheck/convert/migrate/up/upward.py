"""Parts that newer versions write otherwise and libsdformat does not convert."""

from __future__ import annotations

import math

import numpy as np

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.migrate import numbers
from sdfcheck.convert.migrate.defaults import write_defaults
from sdfcheck.convert.migrate.migration import Migration, title
from sdfcheck.convert.migrate.node import Node
from sdfcheck.convert.migrate.up.conversions import convert_to
from sdfcheck.convert.migrate.up.new_names import rename_clashing, rename_reserved
from sdfcheck.convert.migrate.up.unflatten import unflatten
from sdfcheck.convert.writer import number
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.motion.poses import PoseError, written_pose

STATES = {"model": "model_state", "light": "light_state", "joint": "joint_state", "link": "link_state"}


def go_up(migration: Migration) -> None:
    """Take a draft to a newer version, step by step."""
    write_defaults(migration)
    for minor in range(migration.source.minor + 1, migration.target.minor + 1):
        for repair in _BEFORE.get(minor, ()):
            repair(migration)
        if minor == 8:
            unflatten(migration)
        convert_to(migration, minor)
    migration.root.set("version", str(migration.target))


def _allow_no_friction_limit(migration: Migration) -> None:
    """-1 meant endless friction up to 1.3; newer consumers refuse the file."""
    for mu in migration.root.of("mu", "mu2"):
        if mu.content.startswith("-"):
            migration.note(
                mu, f"{mu.name} {mu.content} is written as 1e16: both mean no limit", LossKind.CHANGED_LIMIT
            )
            mu.write("1e16")


def _fold_inner_frames(migration: Migration) -> None:
    """Frames inside links and their parts ended with 1.6; poses in them take them in."""
    document = migration.draft.read()
    frames = {
        m
        for m in migration.root.of("frame")
        if m.parent is not None and m.parent.name not in {"model", "world"}
    }
    if not frames or document is None:
        return
    for pose in migration.root.of("pose"):
        reference = (pose.get("frame") or "").strip()
        frame = _inner_frame(pose, reference, frames)
        if frame is None:
            continue
        own = frame.find("pose")
        try:
            outer = written_pose(migration.draft.element(own)) if own is not None else np.eye(4)
            pose.write(numbers.pose(outer @ written_pose(migration.draft.element(pose))))
        except PoseError as error:
            migration.lose(pose, f"the pose cannot be resolved: {error}", LossKind.UNKNOWN_REFERENCE)
        pose.unset("frame")
    for frame in frames:
        if frame.parent is not None:
            text = f"{title(frame)} is left out: frames inside `{frame.parent.name}` ended with 1.6"
            migration.drop(frame, text, LossKind.DROPPED_FRAME)


def _inner_frame(pose: Node, reference: str, frames: set[Node]) -> Node | None:
    at = pose.parent
    while at is not None and reference and at.name not in {"model", "world"}:
        for frame in at.children("frame"):
            if frame in frames and frame.get("name") == reference:
                return frame
        at = at.parent
    return None


def _move_moved_elements(migration: Migration) -> None:
    """imu/topic and ode/provide_feedback left in 1.7; what took their place is older."""
    for imu in migration.root.of("imu"):
        topic = imu.find("topic")
        if topic is not None and imu.parent is not None and imu.parent.find("topic") is None:
            topic.remove()
            imu.parent.append(topic, before=imu)
    for ode in migration.root.of("ode"):
        flag = ode.find("provide_feedback")
        if flag is not None and ode.parent is not None and ode.parent.find("provide_feedback") is None:
            flag.remove()
            ode.parent.append(flag, after=ode)


def _look_for_lost_ends(migration: Migration) -> None:
    for child in migration.root.of("child"):
        if child.content == "world" and child.parent is not None and child.parent.name == "joint":
            text = f"{title(child.parent)} has the world as child, which consumers refuse from 1.7 on"
            migration.lose(child, text, LossKind.UNKNOWN_REFERENCE, Severity.ERROR)


def _drop_inertial_references(migration: Migration) -> None:
    for inertial in migration.root.of("inertial"):
        pose = inertial.find("pose")
        if pose is not None and (reference := (pose.get("relative_to") or "").strip()):
            text = f"the reference `{reference}` of an inertial's pose is left out: no consumer regards it"
            migration.lose(pose, text, LossKind.UNKNOWN_REFERENCE)
            pose.unset("relative_to")


def _report_several_models(migration: Migration) -> None:
    for extra in migration.root.children("model")[1:]:
        text = f"{title(extra)} is not read: from 1.8 on a file has one model at its top"
        migration.lose(extra, text, LossKind.DROPPED_ELEMENT)


def _convert_thread_pitch(migration: Migration) -> None:
    for joint in migration.root.of("joint"):
        old = joint.find("thread_pitch")
        if old is None or joint.find("screw_thread_pitch") is not None:
            continue
        try:
            pitch = -2 * math.pi / float(old.content)
        except (ValueError, ZeroDivisionError):
            continue
        old.rename("screw_thread_pitch")
        old.write(number(pitch))


def _rename_states(migration: Migration) -> None:
    for state in migration.root.of("state"):
        for node in [*state.standard()]:
            inside = node.parent is not None and node.parent.name in {
                "state",
                "model",
                "link",
                *STATES.values(),
            }
            if node.name in STATES and inside and not _is_inserted(node):
                node.rename(STATES[node.name])


def _is_inserted(node: Node) -> bool:
    at = node.parent
    while at is not None and at.name != "state":
        if at.name == "insertions":
            return True
        at = at.parent
    return False


_BEFORE = {
    4: (_allow_no_friction_limit,),
    7: (
        _fold_inner_frames,
        rename_reserved,
        rename_clashing,
        _move_moved_elements,
        _look_for_lost_ends,
    ),
    8: (_drop_inertial_references, _report_several_models),
    10: (_convert_thread_pitch,),
    12: (_rename_states,),
}
