"""The names that a reference can write where the cursor is."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

from sdfcheck.formats import srdf
from sdfcheck.formats.vendor.definitions import Vendor
from sdfcheck.lsp.completion.context import Context, Where
from sdfcheck.lsp.completion.item import Item, Sort
from sdfcheck.lsp.completion.likely import Usage, words_in
from sdfcheck.lsp.completion.semantics import Tree, semantic_scores
from sdfcheck.lsp.completion.tags import slots_at
from sdfcheck.lsp.cursor import elements
from sdfcheck.lsp.names.expanded import MOST_ASSISTANTS, Expanded, expansions, plain, roots_of
from sdfcheck.lsp.names.index import is_made, occurrences, robots_about
from sdfcheck.lsp.workspace import Workspace
from sdfcheck.robot.graph import Model
from sdfcheck.robot.naming.occurrences import Occurrence
from sdfcheck.robot.part import Namespace
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import Document
from sdfcheck.source.sniff import Kind

_NODES = ("link", "joint", "frame", "model")
_SDF_VALUES = {
    ("pose", "relative_to"): _NODES,
    ("pose", "frame"): _NODES,
    ("frame", "attached_to"): _NODES,
    ("xyz", "expressed_in"): _NODES,
    ("model", "canonical_link"): ("link",),
    ("model", "placement_frame"): _NODES,
    ("mimic", "joint"): ("joint",),
}
_SDF_TEXTS = {
    "parent": _NODES,
    "child": _NODES,
    "gearbox_reference_body": ("link",),
    "gripper_link": ("link",),
    "palm_link": ("link",),
    "placement_frame": _NODES,
}
_URDF_VALUES = {
    ("parent", "link"): ("link",),
    ("child", "link"): ("link",),
    ("mimic", "joint"): ("joint",),
    ("gazebo", "reference"): ("link", "joint"),
    ("material", "name"): ("material",),
}
_OF_JOINTS = frozenset({"transmission", "ros2_control"})
_OWN_FRAMES = {"relative_to": "__model__", "attached_to": "__model__", "expressed_in": "__model__"}


def wanted(context: Context, dialect: str, vendors: Sequence[Vendor]) -> tuple[str, ...]:
    """The kinds of things that can be named; none where no name is expected."""
    tag, attribute = context.tag, context.attribute
    if dialect == "srdf":
        place = srdf.at((*context.around, tag)) if context.where is Where.VALUE else None
        own = place.attributes.get(attribute) if place is not None else None
        return tuple(filter(None, (srdf.named_by(own),))) if own is not None else ()
    is_urdf = dialect == "urdf"
    if context.where is Where.VALUE:
        if tag == "insert_block" or (tag == "xacro:insert_block" and attribute == "name"):
            return ("parameter",)
        is_joint = is_urdf and tag == "joint" and attribute == "name"
        if is_joint and _OF_JOINTS.intersection(context.around[-1:]):
            return ("joint",)
        table = _URDF_VALUES if is_urdf else _SDF_VALUES
        return table.get((tag, attribute)) or _of_vendors(tag, attribute, vendors)
    if (
        tag in _SDF_TEXTS
        and not is_urdf
        and (tag not in {"parent", "child"} or "joint" in context.around[-2:])
    ):
        return _SDF_TEXTS[tag]
    if "plugin" in context.around:
        return _of_parameter(tag)
    return _of_vendors(tag, "", vendors)


def _of_parameter(tag: str) -> tuple[str, ...]:
    words = tag.lower()
    if "joint" in words:
        return ("joint",)
    if "link" in words or "body" in words:
        return ("link",)
    return _NODES if "frame" in words else ()


def _of_vendors(tag: str, attribute: str, vendors: Sequence[Vendor]) -> tuple[str, ...]:
    """The parts that a vendor's own tag can name."""
    slots = slots_at(tag, attribute, vendors) if ":" in tag or ":" in attribute else ()
    return next((slot.references for slot in slots if slot.references), ())


def name_items(
    workspace: Workspace,
    document: Document,
    context: Context,
    offset: int,
    usage: Usage,
    kinds: tuple[str, ...],
) -> list[Item]:
    """The names of the kinds that are wanted, the likeliest first."""
    if document.root is None:
        return []
    made = _made(workspace, document)
    near = [value for values in usage.neighbors(place_of(context), offset) for value in values]
    # In a macro people write names with its parameters, unless they do not.
    is_written = "xacro:macro" in context.around and (not near or any("$" in value for value in near))
    items = list(_candidates(made, document, context, offset, kinds, is_written=is_written))
    order = Order(document.source.text, context, offset, usage, items, is_written=is_written)
    more: dict[str, float] = {}
    if document.kind is Kind.SRDF:
        names, tree = [item.label for item in items], Tree(one.document for one in made)
        more = semantic_scores(document.source.text, context, offset, usage, names, tree)
    return sorted(items, key=lambda item: (-order.score(item) - more.get(item.label, 0.0), item.rank))


def place_of(context: Context) -> str:
    """The element, with the attribute, that the cursor is in."""
    return f"{context.tag}@{context.attribute}" if context.attribute else context.tag


def _made(workspace: Workspace, document: Document) -> list[Expanded]:
    """The robots that SRDF is about, or that a file is expanded to or part of."""
    found: list[Expanded] = []
    if document.kind is Kind.XACRO:
        return expansions(workspace, roots_of(document)[:2], turned=False, lately=True)
    for robot in robots_about(workspace, document) if document.kind is Kind.SRDF else ():
        made = expansions(workspace, roots_of(robot), turned=False) if is_made(robot) else [plain(robot)]
        found += made[:MOST_ASSISTANTS]
    return found


def _candidates(
    made: Iterable[Expanded],
    document: Document,
    context: Context,
    offset: int,
    kinds: tuple[str, ...],
    *,
    is_written: bool,
) -> Iterator[Item]:
    if is_made(document) or document.kind is Kind.SRDF:
        names: dict[tuple[str, str], None] = {}
        expanded = [(name, kind) for one in made for kind, name in one.by_name if kind in kinds]
        if document.kind is Kind.SRDF or not is_written:
            names.update(dict.fromkeys(expanded))
        for each in occurrences(document).all:
            if each.symbol.kind in kinds and not _is_at(each, offset) and not _is_no_block(each):
                name = each.span.text.strip() if document.kind is Kind.SRDF else each.symbol.name
                names.setdefault((name, each.symbol.kind))
        yield from (Item(name, Sort.NAME, name, detail=kind, rank=2) for name, kind in names)
        return
    scope = _scope(document, context, offset)
    if scope is not None:
        yield from _in_scope(scope, kinds, context)
    yield from _tags(document, kinds)


def _is_no_block(occurrence: Occurrence) -> bool:
    """Is it a parameter that no block is given for? The others are written with a star."""
    span = occurrence.symbol.span
    return occurrence.symbol.kind == "parameter" and not span.source.text[: span.start].endswith("*")


def _is_at(occurrence: Occurrence, offset: int) -> bool:
    return occurrence.span.start <= offset <= occurrence.span.end


class Order:
    """Which of several names is likely at a place: what its neighbors name, what is defined nearby, what is alike."""

    def __init__(
        self,
        text: str,
        context: Context,
        offset: int,
        usage: Usage,
        items: Sequence[Item],
        *,
        is_written: bool,
    ) -> None:
        self.is_written = is_written
        self.offset = offset
        self.text = text
        place = place_of(context)
        self.before, self.after = usage.neighbors(place, offset)
        self.numbers = {item.label: number for number, item in enumerate(items)}
        self.alphabet = {name: number for number, name in enumerate(sorted(self.numbers))}
        is_top = "<group" in text and context.around == ("robot",)
        holder = [""] if is_top else _holder(text, context, offset)
        self.words = words_in(" ".join(holder))
        self.others = set(holder[1:])
        self.place = place
        self.is_semantic = "<group" in text and place in _SEMANTIC
        self.is_once = place in _ONCE or context.attribute == "link2"
        block = _block(text, context, offset)
        self.used = set(self.before + self.after) if place in _ONCE else set()
        if place in _ONCE_IN_BLOCK:
            self.used = set(re.findall(r"<" + context.tag + r"\b[^<>]*?[\"']([^\"'<>]+)[\"']", block))
        self.children = (
            {a or b for a, b in _CHILD.findall(text)} if place in {"parent@link", "parent"} else set()
        )
        self.last_child = _CHILD.findall(text, 0, offset)[-1:] if place == "parent@link" else []
        self.places = {name: _nearest(text, name, offset) for name in self.numbers}
        distances = sorted(set(self.places.values()))
        self.ranks = {distance: number for number, distance in enumerate(distances)}

    def score(self, item: Item) -> float:
        """How likely a name is."""
        name = item.label
        score = 0.0 if item.rank <= 3 or name in (*self.before[:2], *self.after[:2]) else -2.0
        score -= 3 * (name in self.used or name in self.others)
        score -= _OF_LINKS.get(self.place, 0.0) * (item.detail == "joint")
        score += 0.6 * bool(self.children and name not in self.children)  # a root has many children
        score += (name, "") in self.last_child  # parts hang on one another
        score -= 2 * ("$" in name and not self.is_written)
        if not self.is_semantic:
            score += 1.5 / (1 + self.ranks[self.places[name]])
        if not self.is_once:
            weight = 2.0 if self.is_semantic else 1.0
            score += weight * (name in self.before[:1]) + weight * (name in self.after[:1]) / 2
            score += (name in self.before[1:4]) / 4
        if self.before[:1] and self.before[0] in self.numbers:
            score += 0.8 / (1 + abs(self.numbers[name] - self.numbers[self.before[0]] - 1))
            score += 0.4 / (1 + abs(self.alphabet[name] - self.alphabet[self.before[0]] - 1))
        own = words_in(name)
        return score + 1.5 * len(own & self.words) / max(1, len(own | self.words))


_CHILD = re.compile(r"<child(?:\s+link\s*=\s*[\"']([^\"']+)[\"']|\s*>\s*([^<>\s]+))")
_OF_LINKS = {"parent": 3.0, "child": 3.0, "gazebo@reference": 1.0}
"""Where joints can be named, but hardly are."""
_ONCE = frozenset({"child@link", "child"})
"""Where each name is written once in a whole robot."""
_SEMANTIC = frozenset(f"{element}@{attribute}" for element, attribute in srdf.references())
_ONCE_IN_BLOCK = frozenset({"joint@name", "link@name"})
"""Where each is written once in a group, a state or a block of ``ros2_control``."""


def _holder(text: str, context: Context, offset: int) -> list[str]:
    """The names that the element around writes before the cursor, its own first."""
    name = context.around[-1] if context.around else ""
    if name in {context.tag, ""} and context.where is Where.TEXT:
        name = context.around[-2] if len(context.around) > 1 else ""
    start = max(text.rfind(f"<{name} ", 0, offset), text.rfind(f"<{name}>", 0, offset)) if name else -1
    if start < 0 or offset - start > 3000:
        start = text.rfind("<", 0, offset)
    own = text[start:offset] + text[offset : offset + 200].partition("</" + (name or "?"))[0]
    found = re.search(r"\sname\s*=\s*[\"']([^\"']*)[\"']", own)
    others = re.findall(r"(?:link\d?|reference)\s*=\s*[\"']([^\"']+)[\"']|<(?:parent|child)>([^<]+)<", own)
    return [found[1] if found else "", *(a or b.strip() for a, b in others)]


def _block(text: str, context: Context, offset: int) -> str:
    """The text of the element around."""
    name = context.around[-1] if context.around else ""
    start = text.rfind(f"<{name}", 0, offset)
    end = text.find(f"</{name}", offset)
    own = text.rfind("<", 0, offset)
    return text[start:own] + text[text.find(">", offset) : end if end >= 0 else len(text)]


def _nearest(text: str, name: str, offset: int) -> int:
    """How far it is to the nearest place where a name is given, before the cursor rather than after it."""
    given = f'name="{name}"'
    before = text.rfind(given, max(0, offset - _FAR), offset)
    after = text.find(given, offset, offset + _FAR)
    return min(offset - before if before >= 0 else _FAR, 2 * (after - offset) if after >= 0 else _FAR)


_FAR = 60_000


def _in_scope(scope: Namespace, kinds: tuple[str, ...], context: Context) -> Iterator[Item]:
    if isinstance(scope, Model) and scope.is_urdf:
        known: dict[str, Iterable[str]] = {
            "material": scope.material_names.defined,
            "link": scope.tree.links,
            "joint": scope.joints_by_name,
        }
        for kind, names in known.items():
            if kind in kinds:
                yield from (Item(name, Sort.NAME, name, detail=kind, rank=2) for name in names)
        return
    own = _own_name(scope, context)
    for name in scope.names():
        node = scope.resolve(name)
        if node is not None and node.kind in kinds and name != own and node.kind in _NODES:
            yield Item(name, Sort.NAME, name, detail=node.kind, rank=2 + name.count("::"))
    if context.attribute in _OWN_FRAMES and scope.kind == "model":
        yield Item("__model__", Sort.NAME, "__model__", detail="the model's own frame", rank=4)
    if context.tag in {"parent", "child"} or scope.kind == "world":
        yield Item("world", Sort.NAME, "world", detail="world", rank=4)


def _own_name(scope: Namespace, context: Context) -> str:
    """Parts that cannot refer to themselves."""
    return dict(context.given).get("name", "") if context.where is Where.VALUE else ""


def _scope(document: Document, context: Context, offset: int) -> Namespace | None:
    """The world or model in which a name that is written at a place is looked up."""
    root = root_of(document)
    if root.is_urdf:
        return root.scopes[0]
    element = elements(document).around(offset)
    if element is None:
        element = elements(document).around(max(0, offset - 1))
    if element is None:
        return root.scopes[0] if root.scopes else None
    part = root.part_of(element)
    is_own = isinstance(part, Namespace) and context.attribute in {"canonical_link", "placement_frame"}
    if is_own and isinstance(part, Namespace):
        return part
    found = root.scope_of(element) or (part if isinstance(part, Namespace) else None)
    holder = element.parent
    if found is not None and element.name == "pose" and holder is not None and root.part_of(holder) is found:
        outer = found.holder  # the pose of a model is written where the model is
        return outer if isinstance(outer, Namespace) else found
    return found


def _tags(document: Document, kinds: tuple[str, ...]) -> Iterator[Item]:
    """The names of vendors' own elements."""
    own = {kind for kind in kinds if ":" in kind}
    if not own:
        return
    for element in elements(document).all:
        name = element.attributes.get("name", "")
        if name and element.name in own:
            yield Item(name, Sort.NAME, name, detail=element.name, rank=2)
