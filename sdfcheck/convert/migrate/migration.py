"""What the steps of a migration share: the draft, where it goes, and what got lost on the way."""

from __future__ import annotations

from sdfcheck.convert.loss import Loss, LossKind, loss_at
from sdfcheck.convert.migrate.draft import Draft
from sdfcheck.convert.migrate.node import Node
from sdfcheck.convert.rewrite.include_expansion import ToSdf
from sdfcheck.convert.verify import Counterpart
from sdfcheck.formats.sdf.version import NEWEST, Version
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.source.document import Document


class Migration:
    """One document on its way from its version to another.

    ``renamed_joints`` and ``moved_links`` go by the names that verification uses
    (``arm::hand``); the sets name what is not to be compared because it is a loss.
    ``kept`` stays although the target does not have it.
    """

    def __init__(
        self, document: Document, target: Version, to_sdf: ToSdf, *, keep_unknown: bool = False
    ) -> None:
        self.draft = Draft(document)
        self.source = Version.parse(document.version or "") or NEWEST
        self.target = target
        self.to_sdf = to_sdf
        self.keep_unknown = keep_unknown
        self.losses: list[Loss] = []
        self.renamed_joints: dict[str, str] = {}
        self.moved_links: dict[str, Counterpart] = {}
        self.dropped_joints: set[str] = set()
        self.dropped_shapes: set[str] = set()
        self.kept: set[Node] = set()
        self.lost_mimics = False
        self.changed_bodies = False

    @property
    def root(self) -> Node:
        return self.draft.root

    def goes_below(self, minor: int) -> bool:
        """Is the target older than 1.``minor``?"""
        return self.target.minor < minor

    def lose(self, node: Node, message: str, kind: LossKind, severity: Severity = Severity.WARNING) -> None:
        place = node.place
        if place is not None:
            self.losses.append(loss_at(place, kind, message, severity))

    def note(self, node: Node, message: str, kind: LossKind) -> None:
        """Say of something that it is written in another way and means the same."""
        self.lose(node, message, kind, Severity.INFO)

    def drop(self, node: Node, message: str, kind: LossKind = LossKind.DROPPED_ELEMENT) -> None:
        self.lose(node, message, kind)
        node.remove()


def title(node: Node) -> str:
    """What to call a node in a sentence."""
    own = (node.get("name") or "").strip()
    return f"{node.name} `{own}`" if own else f"`{node.name}`"
