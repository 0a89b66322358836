"""The names that a reference can write where the cursor is."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from sdfcheck.formats.vendor import BUILT_IN
from sdfcheck.formats.vendor.table import vendor
from sdfcheck.lsp.completion.context import Context, Where
from sdfcheck.lsp.completion.item import Item, Sort
from sdfcheck.lsp.cursor import elements
from sdfcheck.lsp.names.index import occurrences
from sdfcheck.robot.model import Model
from sdfcheck.robot.root import root_of
from sdfcheck.robot.scope import Scope
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


def wanted(context: Context, *, is_urdf: bool) -> tuple[str, ...]:
    """The kinds of things that can be named; none where no name is expected."""
    tag, attribute = context.tag, context.attribute
    if context.where is Where.VALUE:
        if (
            is_urdf
            and tag == "joint"
            and attribute == "name"
            and _OF_JOINTS.intersection(context.around[-1:])
        ):
            return ("joint",)
        table = _URDF_VALUES if is_urdf else _SDF_VALUES
        return table.get((tag, attribute)) or _of_vendor(tag, f"@{attribute}", is_urdf=is_urdf)
    if (
        tag in _SDF_TEXTS
        and not is_urdf
        and (tag not in {"parent", "child"} or "joint" in context.around[-2:])
    ):
        return _SDF_TEXTS[tag]
    if "plugin" in context.around:
        return _of_parameter(tag)
    return _of_vendor(tag, "", is_urdf=is_urdf)


def _of_parameter(tag: str) -> tuple[str, ...]:
    words = tag.lower()
    if "joint" in words:
        return ("joint",)
    if "link" in words or "body" in words:
        return ("link",)
    return _NODES if "frame" in words else ()


def _of_vendor(tag: str, carrier: str, *, is_urdf: bool) -> tuple[str, ...]:
    """The parts that a vendor's own tag can name."""
    if ":" not in tag:
        return ()
    for path in BUILT_IN:
        known = vendor(path, "urdf" if is_urdf else "sdf").tags.get(tag)
        if known is None:
            continue
        slots = [place.slot for place in known.places if place.carrier == (carrier or "text")]
        slots.append(known.attributes.get(carrier[1:]) if carrier else None)
        found = tuple(kind for slot in slots if slot is not None for kind in slot.references)
        if found:
            return found
    return ()


def name_items(document: Document, context: Context, offset: int) -> Iterator[Item]:
    """The names of the kinds that are wanted, nearest scope first."""
    is_urdf = document.kind is not Kind.SDF
    kinds = wanted(context, is_urdf=is_urdf)
    if not kinds or document.root is None:
        return
    if document.kind is Kind.XACRO:
        seen: dict[str, str] = {}
        for each in occurrences(document).all:
            if each.symbol.kind in kinds:
                seen.setdefault(each.symbol.name, each.symbol.kind)
        yield from (Item(name, Sort.NAME, name, detail=kind, rank=2) for name, kind in sorted(seen.items()))
        return
    scope = _scope(document, context, offset)
    if scope is not None:
        yield from _in_scope(scope, kinds, context)
    yield from _tags(document, kinds)


def _in_scope(scope: Scope, kinds: tuple[str, ...], context: Context) -> Iterator[Item]:
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


def _own_name(scope: Scope, context: Context) -> str:
    """Parts that cannot refer to themselves."""
    return dict(context.given).get("name", "") if context.where is Where.VALUE else ""


def _scope(document: Document, context: Context, offset: int) -> Scope | None:
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
    is_own = isinstance(part, Scope) and context.attribute in {"canonical_link", "placement_frame"}
    if is_own and isinstance(part, Scope):
        return part
    found = root.scope_of(element) or (part if isinstance(part, Scope) else None)
    holder = element.parent
    if found is not None and element.name == "pose" and holder is not None and root.part_of(holder) is found:
        outer = found.holder  # the pose of a model is written where the model is
        return outer if isinstance(outer, Scope) else found
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
