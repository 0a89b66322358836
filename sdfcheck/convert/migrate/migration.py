"""The shared state of a migration's steps, and where the parts of a draft are."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

import numpy as np

from sdfcheck.convert.comparison import Counterpart
from sdfcheck.convert.ledger import Ledger
from sdfcheck.convert.loss import Loss, LossKind
from sdfcheck.convert.migrate.draft import Draft, Node
from sdfcheck.convert.rewrite.include_expansion import ToSdf
from sdfcheck.convert.writer import number
from sdfcheck.formats.schema import Definition
from sdfcheck.formats.sdf.schema import schema
from sdfcheck.formats.vendor.table import tag_of
from sdfcheck.formats.version import NEWEST, Version
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.graph import Model, Scope
from sdfcheck.robot.motion.origin import PoseError
from sdfcheck.robot.motion.poses import Array, inverse, to_rpy, written_pose
from sdfcheck.robot.naming.name import MODEL_FRAME, WORLD_FRAME
from sdfcheck.robot.part import MergedFrame
from sdfcheck.robot.part import Node as RobotNode
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

    def between(self, base: RobotNode, frame: RobotNode) -> Array:
        """The pose of a frame in another one, which may be further in; raises PoseError."""
        return inverse(self.poses.reached(frame.scope, base)) @ self.poses.in_scope(frame)

    def of_frame(self, frame: RobotNode) -> Array:
        pose = self.poses.in_scope(frame)
        if frame.kind == "joint":
            child = frame.find("child")
            below = frame.scope.resolve(child.content) if child is not None else None
            if below is not None:
                return self.between(below, frame)
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


# References of plugins and custom elements to links and joints that get another name.
#
# A vendor's table says what its elements mean. Nobody says it of those of a plugin, or of other
# custom ones: one that is called after a kind of thing (``joint_name``, ``link``) and holds the name
# of one means it; others are reported.

_WORDS = {"joint": ("joint",), "link": ("link", "body", "frame"), "model": ("model",)}


def rename_in_plugins(migration: Migration, model: Node, names: Mapping[tuple[str, str], str]) -> None:
    """Follow new names in the plugins and custom elements of a model; ``names`` are new ones by kind and old name."""
    for holder, node, attribute in list(_places(model)):
        called = f"{node.name}/{attribute}" if attribute else node.name
        text = node.attributes[attribute] if attribute else node.content
        found = _meant(migration, holder, node, called, text, names)
        if found is not None and attribute:
            node.attributes[attribute] = found
        elif found is not None:
            node.write(found)


def _named_kinds(node: Node, attribute: str) -> list[str]:
    """The kinds of thing that a vendor's tag names in an attribute, or in its text; none if no table knows it."""
    is_tag = not attribute or ":" in attribute
    tag = tag_of(node.document, attribute if attribute and is_tag else node.name, "sdf")
    if tag is None:
        return []
    slot = next((place.slot for place in tag.places), None) if is_tag else tag.attributes.get(attribute)
    return list(slot.references) if slot is not None else []


def _places(node: Node, around: Node | None = None) -> Iterator[tuple[Node, Node, str]]:
    """The custom attributes, and the values in plugins and custom elements: what holds it, element, attribute."""
    for child in node.children():
        holder = child if around is None and (child.name == "plugin" or child.is_custom) else around
        for name in child.attributes:
            if ":" in name or (
                holder is not None and (child is not holder or (child.is_custom and name != "name"))
            ):
                yield holder or child, child, name
        if holder is not None and next(child.children(), None) is None:
            yield holder, child, ""
        if holder is not None or child.name != "model":
            yield from _places(child, holder)


def _meant(
    migration: Migration,
    plugin: Node,
    node: Node,
    called: str,
    text: str,
    names: Mapping[tuple[str, str], str],
) -> str | None:
    """The new name of what a text names; None if it names nothing that changes, or nobody knows."""
    new = {kind: names[kind, text] for kind in _WORDS if (kind, text) in names}
    if not new:
        return None
    kinds = _named_kinds(node, called.partition("/")[2]) or [
        kind for kind, words in _WORDS.items() if any(word in called.lower() for word in words)
    ]
    if not kinds and "::" in text and len(new) == 1:
        kinds = list(new)  # nothing else is called so
    for kind in kinds:
        if kind in new:
            say = f"`{text}` in {title(plugin)} is written as `{new[kind]}`, as the {kind} is called now"
            migration.note(node, say, LossKind.RENAMED)
            return new[kind]
    if not kinds:
        kind, name = next(iter(new.items()))
        say = f"`{called}` in {title(plugin)} says `{text}`: is it the {kind} that is called `{name}` now?"
        migration.lose(node, say, LossKind.RENAMED)
    return None


# Defaults that differ between two versions, and dead content that would come alive.
#
# A value that relies on a default that the target does not have is written out.

_ALIKE = frozenset({"lower", "upper", "effort", "velocity", "topic", "dt"})
"""Their defaults are spelled differently and mean the same: no limit, no topic."""
_UNWRITABLE = {("mu", "-1"): "1e16", ("mu2", "-1"): "1e16"}
"""Old defaults that newer consumers refuse, and what means the same to them."""


def write_defaults(migration: Migration) -> None:
    """Give what relies on a default that changes its value in writing."""
    for node, old in list(defined(migration.root, migration.source)):
        new = schema(migration.target).at(old.place)
        if new is None or old.type is not None:
            continue
        for name, child in old.children.items():
            after = new.children.get(name)
            if after is None or not child.default or name in _ALIKE or after.default == child.default:
                continue
            if node.find(name) is None:
                value = _UNWRITABLE.get((name, child.default), child.default)
                node.add(name, value)
                text = f"`{name}` is written out: its default is {after.default} in {migration.target}"
                migration.note(
                    node, f"{text}, {child.default} in {migration.source}", LossKind.CHANGED_DEFAULT
                )


def drop_dead(migration: Migration) -> None:
    """Take out what no consumer of the source regards and a consumer of the target would."""
    for node, definition in list(defined(migration.root, migration.source)):
        now = schema(NEWEST).at(definition.place)
        then = schema(migration.target).at(definition.place)
        if then is None or now is None:
            continue
        dead = f"has no meaning in {migration.source} and is left out"
        for name in then.attributes.keys() - now.attributes.keys() - definition.attributes.keys():
            if node.attributes.get(name) is not None:
                text = f"attribute `{name}` of {title(node)} {dead}"
                migration.lose(node, text, LossKind.DROPPED_ELEMENT)
                node.unset(name)
        for child in node.children():
            name = child.name
            if name in then.children and name not in now.children and name not in definition.children:
                migration.drop(child, f"{title(child)} {dead}")


def defined(root: Node, version: Version) -> Iterator[tuple[Node, Definition]]:
    """The nodes that a version's table places, each with what the table says of it."""

    def walk(node: Node, definition: Definition) -> Iterator[tuple[Node, Definition]]:
        yield node, definition
        if definition.open:
            return
        for child in node.children():
            inner = definition.children.get(child.name)
            if inner is not None:
                yield from walk(child, inner)

    yield from walk(root, schema(version).root)


# Computed poses and vectors as text.

_DUST = 1e-13
"""Smaller components of what was computed are what is left of rounding."""


_NOISY = 3
"""So many digits shorter is what the rounding of noise makes of a number."""


def _number(value: float) -> str:
    exact, rounded = number(value), number(round(value, 15))
    return rounded if len(rounded) <= len(exact) - _NOISY else exact


def vector(values: Iterable[float]) -> str:
    return " ".join("0" if abs(value) < _DUST else _number(float(value)) for value in values)


def pose(transform: Array) -> str:
    """``x y z roll pitch yaw`` of a 4×4 transform."""
    return vector((*transform[:3, 3], *to_rpy(transform[:3, :3])))
