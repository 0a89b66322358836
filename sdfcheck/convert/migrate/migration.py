"""The shared state of a migration's steps, and where the parts of a draft are."""

from __future__ import annotations

import numpy as np

from sdfcheck.convert.comparison import Counterpart
from sdfcheck.convert.ledger import Ledger
from sdfcheck.convert.loss import Loss, LossKind
from sdfcheck.convert.migrate.draft import Draft, Node
from sdfcheck.convert.rewrite.include_expansion import ToSdf
from sdfcheck.formats.version import NEWEST, Version
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.graph import MergedFrame, Model, Scope
from sdfcheck.robot.graph import Node as RobotNode
from sdfcheck.robot.motion.poses import PoseError, written_pose
from sdfcheck.robot.motion.rotations import Array, inverse
from sdfcheck.robot.reserved import MODEL_FRAME, WORLD_FRAME
from sdfcheck.robot.root import root_of
from sdfcheck.robot.values import reference_of
from sdfcheck.source.document import Comment, Element

# The shared state of a migration's steps: the draft, its target, and the losses.


class Migration:
    """One document on its way from its version to another.

    ``renamed_joints`` and ``moved_links`` have the names that verification uses (``arm::hand``);
    the sets name the parts that are not to be compared because they are losses. ``kept`` stays
    although the target does not have it.
    """

    def __init__(self, draft: Draft, target: Version, to_sdf: ToSdf, *, keep_unknown: bool = False) -> None:
        self.draft = draft
        self.source = Version.parse(draft.version or "") or NEWEST
        self.target = target
        self.to_sdf = to_sdf
        self.keep_unknown = keep_unknown
        self.ledger = Ledger(None, f"SDFormat {target}")
        self.renamed_joints: dict[str, str] = {}
        self.moved_links: dict[str, Counterpart] = {}
        self.dropped_joints: set[str] = set()
        self.dropped_shapes: set[str] = set()
        self.kept: set[Node] = set()
        self.brought: list[tuple[Element, frozenset[str]]] = []
        """The includes that were written out, and the names of the custom data in what takes their place."""
        self.lost_mimics = False
        self.changed_bodies = False

    @property
    def losses(self) -> list[Loss]:
        return self.ledger.losses

    @property
    def root(self) -> Node:
        return self.draft.root

    def goes_below(self, minor: int) -> bool:
        """Is the target older than 1.``minor``?"""
        return self.target.minor < minor

    def lose(self, node: Node, message: str, kind: LossKind, severity: Severity = Severity.WARNING) -> None:
        place = node.place
        if place is not None:
            self.ledger.note(kind, place, message, severity)

    def note(self, node: Node, message: str, kind: LossKind) -> None:
        """Say of something that it is written in another way and means the same."""
        self.lose(node, message, kind, Severity.INFO)

    def drop(
        self,
        node: Node,
        message: str,
        kind: LossKind = LossKind.DROPPED_ELEMENT,
        severity: Severity = Severity.WARNING,
    ) -> None:
        self.lose(node, message, kind, severity)
        if node.source is not None:
            self.ledger.drop(node.source)
        node.take_out()

    def merge(self, node: Node) -> None:
        """Take out a node that is said elsewhere."""
        self.enter(node)
        node.take_out()

    def enter_alone(self, node: Node) -> None:
        """A node is going to be said elsewhere, and its comments; what is in it is entered apart."""
        if node.source is not None and node.source.document is self.draft.original:
            self.ledger.take(node.source)
            for part in node.source.nodes:
                if isinstance(part, Comment):
                    self.ledger.take_comment(part)

    def enter(self, node: Node) -> None:
        """A node is going to be said elsewhere."""
        if node.source is not None:
            self.ledger.take_all(node.source)


def title(node: Node) -> str:
    """The name of a node in a sentence."""
    own = node.attributes.get("name", "").strip()
    return f"{node.name} `{own}`" if own else f"`{node.name}`"


# Where the parts of a draft are, in every frame that a version may ask for.


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
