"""The shared state of a migration's steps: the draft, its target, and the losses."""

from __future__ import annotations

from sdfcheck.convert.ledger import Ledger
from sdfcheck.convert.loss import Loss, LossKind
from sdfcheck.convert.migrate.draft import Draft
from sdfcheck.convert.migrate.node import Node
from sdfcheck.convert.rewrite.include_expansion import ToSdf
from sdfcheck.convert.verify import Counterpart
from sdfcheck.formats.sdf.version import NEWEST, Version
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.source.document import Document
from sdfcheck.source.element import Comment, Element


class Migration:
    """One document on its way from its version to another.

    ``renamed_joints`` and ``moved_links`` have the names that verification uses (``arm::hand``);
    the sets name the parts that are not to be compared because they are losses. ``kept`` stays
    although the target does not have it.
    """

    def __init__(
        self, document: Document, target: Version, to_sdf: ToSdf, *, keep_unknown: bool = False
    ) -> None:
        self.draft = Draft(document)
        self.source = Version.parse(document.version or "") or NEWEST
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
        node.remove()

    def merge(self, node: Node) -> None:
        """Take out a node that is said elsewhere."""
        self.enter(node)
        node.remove()

    def enter_alone(self, node: Node) -> None:
        """A node is going to be said elsewhere, and its comments; what is in it is entered apart."""
        if node.source is not None and node.source.document is self.draft.source:
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
    own = (node.get("name") or "").strip()
    return f"{node.name} `{own}`" if own else f"`{node.name}`"
