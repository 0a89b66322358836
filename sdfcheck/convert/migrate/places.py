"""Where the parts of a draft are, in every frame that a version may ask for."""

from __future__ import annotations

import numpy as np

from sdfcheck.convert.migrate.migration import Migration, title
from sdfcheck.convert.migrate.node import Node
from sdfcheck.robot.frame import MergedFrame
from sdfcheck.robot.model import Model
from sdfcheck.robot.motion.poses import PoseError, written_pose
from sdfcheck.robot.motion.rotations import Array, inverse
from sdfcheck.robot.node import Node as RobotNode
from sdfcheck.robot.parts.placement import reference_of
from sdfcheck.robot.reserved import MODEL_FRAME, WORLD_FRAME
from sdfcheck.robot.root import root_of
from sdfcheck.robot.scope import Scope
from sdfcheck.source.element import Element

_HOLDERS = frozenset({"link", "joint"})


class Places:
    """The frames of a draft as it was read last, and the poses of its elements."""

    def __init__(self, migration: Migration) -> None:
        self.migration = migration
        self.root = root_of(migration.draft.read())
        self.poses = self.root.poses
        self.frames: dict[Element, RobotNode] = {
            node.place: node for scope in self.root.all_scopes() for node in scope.nodes.values()
        }

    def frame(self, node: Node) -> RobotNode | None:
        """The frame that a node makes."""
        return self.frames.get(self.migration.draft.element(node))

    def scope(self, node: Node) -> Scope | None:
        """The scope that a node is in."""
        return self.root.scope_of(self.migration.draft.element(node))

    def plain(self, owner: Node) -> Array:
        """The pose of a node in what the oldest versions mean by it.

        A model, link or light in what holds it, a joint in its child, a part in its link
        or joint, a camera in its sensor.
        """
        frame = self.frame(owner)
        if frame is not None:
            return self.of_frame(frame)
        if owner.name == "inertial" or owner.parent is None:
            return written_pose(self.migration.draft.element(owner).find("pose"))
        holder = self.holder(owner)
        outer = self.in_holder(owner.parent, holder) if owner.parent is not holder else np.eye(4)
        return inverse(outer) @ self.in_holder(owner, holder)

    def of_frame(self, frame: RobotNode) -> Array:
        pose = self.poses.in_scope(frame)
        if frame.kind == "joint":
            child = frame.find("child")
            below = frame.scope.resolve(child.content) if child is not None else None
            if below is not None:
                return inverse(self.poses.reached(frame.scope, below)) @ pose
        return pose if frame.merged is None else inverse(self.poses.in_scope(frame.merged)) @ pose

    def holder(self, node: Node) -> Node | None:
        """The link or joint around a part."""
        at = node.parent
        while at is not None and at.name not in _HOLDERS:
            at = at.parent
        return at

    def in_holder(self, node: Node, holder: Node | None) -> Array:
        """The pose of a part in its link or joint, or of something in a world or model in that."""
        pose = self.migration.draft.element(node).find("pose")
        reference = reference_of(pose)
        frame = self.frame(holder) if holder is not None else None
        if not reference:
            return written_pose(pose)
        if frame is not None:
            return self.poses.of_part(self.migration.draft.element(node), frame)
        scope = self.scope(node)
        if scope is None:
            element = self.migration.draft.element(node)
            raise PoseError(f"there is no frame {reference!r} around {title(node)}", element)
        return self.poses.named(scope, reference) @ written_pose(pose)

    def is_placed(self, node: Node) -> bool:
        """Is it a model that is placed by one of its frames?"""
        frame = self.frame(node)
        if isinstance(frame, MergedFrame):
            frame = frame.model
        return isinstance(frame, Model) and bool(frame.placement_frame)

    def carrier(self, frame: RobotNode) -> tuple[RobotNode, str] | None:
        """The link or world that a frame moves with, and its name as seen from the frame's scope."""
        found = frame.carrier
        if found is None:
            return None
        if found.stands_still or found.kind == "world":
            return found, MODEL_FRAME if found.kind == "model" else WORLD_FRAME
        names, scope = [found.name], found.scope
        while scope is not frame.scope:
            if not isinstance(scope.holder, Scope):
                return None
            names.insert(0, scope.name)
            scope = scope.scope
        return found, "::".join(names)

    def named(self, frame: RobotNode, reference: str) -> RobotNode | None:
        return frame.look_up(reference)
