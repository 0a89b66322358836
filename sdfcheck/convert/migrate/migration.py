"""The document that is brought to another version, with its lines, and all that its steps ask."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING

import numpy as np

from sdfcheck.convert.comparison import Counterpart
from sdfcheck.convert.include_expansion import ToSdf
from sdfcheck.convert.ledger import Ledger
from sdfcheck.convert.loss import Loss, LossKind, refusal
from sdfcheck.convert.result import with_text
from sdfcheck.convert.writer import aside_text, number, start_of
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
from sdfcheck.source.altered import Altered, Xml, copied_as
from sdfcheck.source.document import Aside, Comment, Document, Element
from sdfcheck.source.document import Node as Read
from sdfcheck.source.text import IN_QUOTES, escape

# Elements that can be changed, on lines of their own.


_DEFAULT_INDENT = "  "


class Node(Xml):
    """An element of a draft; ``source`` is the element as which it is written if nothing changes.

    ``origin`` is the element of the source that it comes from, None for one that a step made.
    """

    __slots__ = ("source",)
    parent: Node | None

    def __init__(self, name: str, text: str | None = None, /, **attributes: str) -> None:
        super().__init__(name, text, **attributes)
        self.source: Element | None = None

    if TYPE_CHECKING:

        def children(self, name: str | None = None) -> Iterator[Node]: ...
        def walk(self) -> Iterator[Node]: ...
        def reach(self, *names: str) -> Node: ...

    @property
    def place(self) -> Element | None:
        """The nearest element of the source: where to point when speaking of this node."""
        at: Node | None = self
        while at is not None and at.origin is None:
            at = at.parent
        return at.origin if at is not None else None

    @property
    def is_as_read(self) -> bool:
        """Is its start tag the one of its source?"""
        source = self.source
        return source is not None and (self.name, self.attributes) == (source.name, source.attributes)

    # Looking

    def find(self, path: str) -> Node | None:
        """The first child of a name, or what a path of such steps leads to."""
        at: Node | None = self
        for step in path.split("/"):
            at = next(at.children(step), None) if at is not None else None
        return at

    def standard(self) -> Iterator[Node]:
        """All nodes below this one that are the format's: nothing custom, nothing inside plugins."""
        waiting: list[Read] = [self]
        while waiting:
            node = waiting.pop()
            if isinstance(node, Node):
                if node is not self:
                    yield node
                if node.name != "plugin":
                    waiting += [
                        inner for inner in reversed(node.nodes) if inner.name and ":" not in inner.name
                    ]

    def of(self, *names: str) -> list[Node]:
        """The standard nodes below this one that have one of the names."""
        return [node for node in self.standard() if node.name in names]

    # Changing

    def unset(self, name: str) -> None:
        """Take an attribute out; what it says must be said elsewhere."""
        self.attributes.pop(name, None)

    def rename_attribute(self, name: str, to: str) -> None:
        self.attributes = {to if key == name else key: text for key, text in self.attributes.items()}

    def copy(self) -> Node:
        """A copy of it, without a parent."""
        made = copied_as(Node, self)
        for one, other in zip(made.walk(), self.walk(), strict=True):
            one.origin, one.source = other.origin, other.source
        return made

    def take_out(self) -> None:
        """Take the node out of its parent, with the line that it leaves empty."""
        parent = self.parent
        assert parent is not None
        place = parent.nodes.index(self)
        before, after = self._before, self.tail
        is_beside = place > 0 and isinstance(parent.nodes[place - 1], Aside) and "\n" not in before
        if before and not is_beside and not before.rpartition("\n")[2].strip():
            follows = place + 1 < len(parent.nodes) and isinstance(parent.nodes[place + 1], Aside)
            rest = after.lstrip(" \t")
            if rest[:1] in {"\n", "\r"} or not (rest or follows):
                before = before.rstrip(" \t").removesuffix("\n").removesuffix("\r")
            else:
                after = rest
        del parent.nodes[place]
        if place:
            parent.nodes[place - 1].tail = before + after
        else:
            parent.text = before + after
        self.parent = None

    def exchange(self, others: list[Node]) -> None:
        """Put others in the place of this node, each on a line of its own, after the comments in it."""
        parent, indent = self.parent, self.indent
        assert parent is not None
        row: list[Read] = [*(node for node in self.nodes if isinstance(node, Comment)), *others]
        for node in row:
            node.parent, node.tail = parent, "\n" + indent
        for other in others:
            other.shift(indent)
        row[-1].tail = self.tail
        place = parent.nodes.index(self)
        parent.nodes[place : place + 1] = row
        self.parent = None

    def enter(self, child: Node, *, before: Node | None = None, after: Node | None = None) -> Node:
        """Put a child last, or beside a sibling, on a line of its own."""
        siblings = list(self.children())
        beside = before or after or (siblings[-1] if siblings else None)
        child.parent = self
        if beside is None:
            self._enter_first(child)
            return child
        indent = beside.indent
        child.shift(indent)
        place = self.nodes.index(beside)
        if before is not None:
            child.tail = "\n" + indent
            self.nodes.insert(place, child)
        else:
            child.tail, beside.tail = beside.tail, "\n" + indent
            self.nodes.insert(place + 1, child)
        return child

    def _enter_first(self, child: Node) -> None:
        child.tail = ""
        if self.nodes or self.text.strip():
            self.nodes.append(child)
            return
        own = self.indent
        inner = own + self._step
        child.shift(inner)
        self.text, child.tail = "\n" + inner, "\n" + own
        self.nodes = [child]

    def add(self, name: str, text: str | None = None, /, **attributes: str) -> Node:
        """A new last child."""
        return self.enter(Node(name, text, **attributes))

    def add_first(self, name: str) -> Node:
        """A new first child."""
        return self.enter(Node(name), before=next(self.children(), None))

    # Lines

    @property
    def _before(self) -> str:
        """The text between it and the node before it."""
        assert self.parent is not None
        place = self.parent.nodes.index(self)
        return self.parent.nodes[place - 1].tail if place else self.parent.text

    @property
    def indent(self) -> str:
        """The spaces before the node on its line; empty if something else is there."""
        if self.parent is None:
            return ""
        _, line, blanks = self._before.rpartition("\n")
        return blanks if line and not blanks.strip() else self.parent.indent

    @property
    def _step(self) -> str:
        own, outer = self.indent, self.parent.indent if self.parent is not None else ""
        return own[len(outer) :] or _DEFAULT_INDENT

    def shift(self, indent: str) -> None:
        """Indent the lines below the first as for a node that is at ``indent``."""
        last = self.nodes[-1].tail if self.nodes else self.text
        _, line, old = last.rpartition("\n")
        if line and not old.strip() and old != indent:
            self._reindent("\n" + old, "\n" + indent)

    def _reindent(self, old: str, new: str) -> None:
        self.text = self.text.replace(old, new)
        for node in self.nodes:
            node.tail = node.tail.replace(old, new)
            if isinstance(node, Node):
                node._reindent(old, new)
            else:
                node.text = node.text.replace(old, new)


_ENCODING = re.compile(
    r"""(<\?xml[^<>]*?encoding\s*=\s*["'])(?!utf-8["']|(?:us-)?ascii["'])[\w.:-]+""", re.IGNORECASE
)
_LONE = re.compile(r"(?<!\r)\n")
_ATTRIBUTE = re.compile(r"""(?<!\s)(\s+)([^\s=<>/"']+)\s*=\s*("[^"]*"|'[^']*')""")
# A piece without an end goes on to the last character: many of them must not be searched one by one.
_ASIDE = re.compile(r"<!--.*?(?:-->|\Z)|<\?.*?(?:\?>|\Z)|(<!\[CDATA\[.*?(?:\]\]>|\Z))", re.DOTALL)
_NAME = re.compile(r"<[^\s/>]*")
_Run = tuple[str | tuple[str], ...]
"""The texts and (as tuples) the comments and instructions between two elements."""
_Runs = dict[tuple[_Run, Element | None], str]
"""A run, and the element after it → how it is spelled in the file."""


class Draft(Altered):
    """A document whose elements change. Text that no step touches is written as it was: spaces, quotes, entities.

    ``text`` is that of the file, where the document has another one with the same places.
    """

    root: Node
    _seen: Altered
    """The document as it was read last."""

    def __init__(self, document: Document, raw: str | None = None) -> None:
        super().__init__(document, Node)
        self._raw = document.source.text if raw is None else raw
        self._laid: dict[Element, Element] = {}
        """Element of the document → the one with its places, where it has none in the text."""
        read = document
        if isinstance(document, Altered):
            read = with_text(document, self._raw)
            self._laid = dict(zip(document.elements, read.elements, strict=True))
        for node in self.root.walk():
            node.source = node.origin
        assert read.root is not None
        place = read.spans.place(read.root)
        # Results are written as UTF-8, whatever the source was.
        self._head = _ENCODING.sub(r"\1UTF-8", self._raw[: place.start])
        self._end = self._raw[place.close_end :]
        self._has_crlf = "\r\n" in self._raw and not _LONE.search(self._raw)

    def read(self) -> Altered:
        """The document as it is now, in which no later change is."""
        self.number()
        self._seen = Altered(self)
        return self._seen

    def element(self, node: Node) -> Element:
        """The element of a node, as of the last reading."""
        return self._seen.copies[node]

    def reread(self, text: str) -> Document:
        """The document as which the text of the draft is read."""
        if text == self.original.source.text:
            return self.original
        made = with_text(self.original, text)
        root = made.root
        if root is None or [one.name for one in root.walk()] != [one.name for one in self.root.walk()]:
            # A parser guesses otherwise at broken text once something around it has changed.
            place = self.original.root
            assert place is not None
            raise refusal(place, "the text is broken, so that it cannot be changed and read again")
        return made

    # Writing

    def text(self) -> str:
        text = f"{self._head}{self._written(self.root)}{self._end}"
        return _LONE.sub("\r\n", text) if self._has_crlf else text

    def _written(self, node: Node) -> str:
        start, runs, end = f"{start_of(node)}>", _Runs(), f"</{node.name}>"
        if node.source is not None:
            start, runs, end = self._as_read(node, node.source)
        spelled: dict[str, str] | None = None
        pieces: list[str] = []
        for run, child in _runs(node):
            raw = runs.get((run, child.source if isinstance(child, Node) else None))
            if raw is None:
                if spelled is None:
                    spelled = dict(
                        word for (known, _), text in runs.items() for word in _spelled(known, text)
                    )
                raw = "".join(_respelled(one, spelled) for one in run)
            pieces.append(raw)
            if isinstance(child, Node):
                pieces.append(self._written(child))
        inner = "".join(pieces)
        if inner and start.endswith("/>"):
            start, end = f"{start.removesuffix('/>').rstrip()}>", f"</{node.name}>"
        return f"{start}{inner}{end}"

    def _as_read(self, node: Node, source: Element) -> tuple[str, _Runs, str]:
        """The start tag of a node, its texts as its source has them, and the end tag."""
        read = self._laid.get(source, source)
        text = self._raw if source.document is self.original else read.document.source.text
        spans = read.document.spans
        place = spans.place(read)
        start, end = text[place.start : place.end], text[place.close : place.close_end]
        is_renamed = source is self.original.root and self._raw is not self.original.source.text
        if is_renamed or node.name != source.name:
            start = _NAME.sub(f"<{node.name}", start, count=1)
            end = f"</{node.name}>" if end else ""
        if not node.is_as_read:
            start = _changed(start, node.attributes, source.attributes)
        runs = _Runs()
        at = place.end
        for (run, child), own in zip(_runs(read), (*source.children(), None), strict=True):
            inner = spans.place(child) if child is not None else None
            runs[run, own] = text[at : place.close if inner is None else inner.start]
            at = at if inner is None else inner.close_end
        return start, runs, end


def _runs(element: Element) -> Iterator[tuple[_Run, Element | None]]:
    """The texts and comments before each element in one, and those after the last."""
    run: list[str | tuple[str]] = [element.text]
    for node in element.nodes:
        if isinstance(node, Element):
            yield tuple(run), node
            run = [node.tail]
        else:
            run += [(aside_text(node),), node.tail]
    yield tuple(run), None


def _spelled(run: _Run, raw: str) -> Iterator[tuple[str, str]]:
    """Each text and comment of a run, without blanks around it, and how it is spelled in the file."""
    ends = [0, *(place for match in _ASIDE.finditer(raw) if not match[1] for place in match.span()), len(raw)]
    for one, start, end in zip(run, ends, ends[1:], strict=False):
        yield (one.strip() if isinstance(one, str) else one[0]), raw[start:end].strip()


def _respelled(one: str | tuple[str], spelled: dict[str, str]) -> str:
    """A text or comment as it is spelled in the file, as far as it was there."""
    if not isinstance(one, str):
        return spelled.get(one[0], one[0])
    words = one.strip()
    return one.replace(words, spelled.get(words, escape(words))) if words else one


def _changed(tag: str, now: dict[str, str], before: dict[str, str]) -> str:
    """A start tag with the attributes that an element has now."""
    pairs = zip(before.items(), now.items(), strict=False)
    renamed = {
        old: new for (old, text), (new, same) in pairs if text == same and not (old in now or new in before)
    }
    found = {match[2]: match for match in _ATTRIBUTE.finditer(tag)}
    for name, match in sorted(found.items(), key=lambda pair: -pair[1].start()):
        to = renamed.get(name, name)
        if name not in before:
            continue
        if to not in now:
            tag = tag[: match.start()] + tag[match.end() :]
        elif now[to] != before[name]:
            tag = tag[: match.start(3)] + _quoted(now[to], match[3][0]) + tag[match.end(3) :]
        elif to != name:
            tag = tag[: match.start(2)] + to + tag[match.end(2) :]
    kept = tag.removesuffix(">").removesuffix("/").rstrip()
    known = {*found, *renamed.values()}
    added = (name for name in now if name not in known and now[name] != before.get(name))
    return kept + "".join(f" {name}={_quoted(now[name])}" for name in added) + tag[len(kept) :]


def _quoted(value: str, quote: str = '"') -> str:
    return quote + escape(value, {quote: IN_QUOTES[quote]}) + quote


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
        self.dropped_shapes: set[Element] = set()
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
        if kind is LossKind.UNSUPPORTED_GEOMETRY and node.source is not None:
            self.dropped_shapes.add(node.source)

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
