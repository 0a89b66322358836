"""Content that is carried over for others: comments, custom data, and the names in sensors and plugins."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from itertools import takewhile

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.sdf_to_urdf.context import Context
from sdfcheck.convert.sdf_to_urdf.vendor_tags import VendorTags
from sdfcheck.convert.writer import (
    EMPTY,
    INERTIAL,
    JOINT,
    LINK,
    MERGED,
    NOTHING,
    PACKAGES,
    PARENT,
    declare,
    is_mark,
    undeclared_prefixes,
)
from sdfcheck.formats.sdf.survey import PARAMETERS
from sdfcheck.formats.vendor import known_tables
from sdfcheck.formats.vendor.table import vendor
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.source.altered import Xml, copied
from sdfcheck.source.document import Comment, Document, Element
from sdfcheck.source.document import Node as Written

# Comments go where what they speak of goes.


def carry_comments(context: Context, node: Xml, element: Element) -> None:
    """Write the comments right before an element at the end of a node."""
    found = list(takewhile(lambda each: isinstance(each, Comment), element.before))
    node.extend(*_taken(context, reversed(found)))


def carry_inside(context: Context, node: Xml, element: Element) -> None:
    """Write what comments an element has that are not written yet at the start of a node."""
    node.insert(0, *_taken(context, _below(element)))


def carry_around(context: Context, node: Xml, model: Element) -> None:
    """Write the comments of a model that are before no written element: at the start, or at the end."""
    written = ("link", "joint", "model", "include", "frame")
    last = next((child for child in reversed(list(model.children())) if child.name in written), None)
    node.extend(*_taken(context, last.after if last is not None else ()))
    node.insert(0, *_taken(context, model.nodes))


def around_root(element: Element, *, preceding: bool) -> list[Comment]:
    """The comments before or after the root of a document."""
    document = element.document
    nodes = document.prolog if preceding else document.epilog
    return [node for node in nodes if isinstance(node, Comment)]


def _below(element: Element) -> Iterator[Written]:
    """All nodes in an element, in the order of the document."""
    for node in element.nodes:
        yield node
        if isinstance(node, Element):
            yield from _below(node)


def _taken(context: Context, nodes: Iterable[Written]) -> list[Comment]:
    """The comments among nodes that are not written yet."""
    return [node for node in nodes if isinstance(node, Comment) and context.ledger.take_comment(node)]


# Names of links, joints and frames in sensors, plugins and custom elements: rewritten where they change.


_REFERENCES = re.compile(
    "joint|link|body|frame|parent|child|member|relative_to|attached_to|expressed_in", re.IGNORECASE
)
"""Words in the names of parameters that hold names of parts."""
_WORDS = re.compile(r"[^\s,;]+")
_OWN = frozenset({"name", "type", "filename", "reference"})


def follow_names(context: Context, node: Xml, source: Element, scope: str) -> None:
    """Rewrite what a copy of ``source``, which was in a nested model ``scope``, calls by name."""
    done: dict[str, str] = {}
    doubtful: dict[str, str] = {}
    for holder, attribute, name, text in _texts(node, is_top=True):
        renamed = _WORDS.sub(lambda word, name=name: _new_name(context, word[0], name, scope), text)  # type: ignore[misc]
        if renamed == text:
            continue
        if "::" not in text and not _REFERENCES.search(name):
            doubtful[text.strip()] = renamed.strip()
            continue
        done[text.strip()] = renamed.strip()
        if attribute:
            holder.attributes[attribute] = renamed
        else:
            holder.write(renamed)
    if done:
        message = f"names in {source.title} follow the parts that they name: {_list(done)}"
        context.ledger.note(LossKind.RENAMED, source, message, Severity.INFO)
    if doubtful:
        message = f"{source.title} may name what is renamed, and is left as it is: {_list(doubtful)}"
        context.ledger.note(LossKind.RENAMED, source, message)


def _texts(node: Xml, *, is_top: bool = False) -> Iterator[tuple[Xml, str, str, str]]:
    """Xml, attribute or nothing, name of the parameter, and text, of all that may hold a name."""
    for attribute, text in list(node.attributes.items()):
        if not (is_top and attribute in _OWN) and not attribute.startswith("xmlns"):
            yield node, attribute, attribute if attribute not in _OWN | {"value"} else node.name, text
    if node.content:
        yield node, "", node.name, node.content
    for child in node.children():
        yield from _texts(child)


def _new_name(context: Context, text: str, parameter: str, scope: str) -> str:
    """The name in the URDF of what a text names, seen from a nested model; the text itself if it names nothing."""
    tables = [context.links, context.joints, context.frame_names]
    if "joint" in parameter.lower():
        tables.insert(0, context.joints)
    around = scope.split("::") if scope else []
    for depth in range(len(around), -1, -1):
        full = "::".join((*around[:depth], text))
        for table in tables:
            if (new := _within(table, full)) is not None:
                return new
    return text


def _within(table: Mapping[str, str], name: str) -> str | None:
    """The new name of a part, also where something in that part is named."""
    head, rest = name, ""
    while head:
        if head in table:
            return table[head] + rest
        head, delimiter, last = head.rpartition("::")
        rest = f"{delimiter}{last}{rest}"
    return None


def _list(names: Mapping[str, str]) -> str:
    shown = [f"`{old}` → `{new}`" for old, new in list(names.items())[:3]]
    return ", ".join(shown) + (" …" if len(names) > 3 else "")


# Custom elements and attributes: carried over for their consumers, spelled as they are in URDF.


_OF_URDF = "urdf:"
"""The prefix under which the conversion from URDF to SDFormat keeps what URDF alone has."""


def carry_custom(context: Context, node: Xml, element: Element | None, scope: str) -> None:
    """Write the custom attributes and children of an element of a nested model ``scope`` into its equal."""
    if element is None:
        return
    for name, text in element.attributes.items():
        if ":" in name:
            _carry_attribute(context, node, element, name, text, VendorTags(context, scope))
    for child in element.children():
        if not child.is_custom or child.name == PARAMETERS:
            continue
        if child.name.startswith(_OF_URDF) and not (child.name == INERTIAL and is_mark(child)):
            _give_back(context, node, child, scope)
            continue
        if VendorTags(context, scope).put(child, node):
            continue
        copy = copied(child)
        for prefix in {child.name.partition(":")[0], *undeclared_prefixes(copy)}:
            declare(copy, child, prefix, context.namespaces)
        follow_names(context, copy, child, scope)
        node.append(copy)
        message = f"`{child.name}` is carried over for those who read it; poses in it are not translated"
        context.ledger.copy(child)
        context.ledger.note(LossKind.KEPT_AS_EXTENSION, child, message, Severity.INFO)


def _carry_attribute(
    context: Context, node: Xml, element: Element, name: str, text: str, tags: VendorTags
) -> None:
    if name in {MERGED, NOTHING, PACKAGES}:
        context.ledger.take(element, name)
        return
    if name.startswith(_OF_URDF):
        _give_back_attribute(context, node, element, name, text)
        return
    declare(node, element, name.partition(":")[0], context.namespaces)
    if tags.put_attribute(element, name, node):
        return
    if node.attributes.get(name) == text:
        context.ledger.take(element, name)  # one for both
    elif node.attributes.setdefault(name, text) == text:
        context.ledger.copy_attribute(element, name)
    else:
        message = f"attribute `{name}` of {element.title} is left out: there is another one"
        context.ledger.lose_attribute(element, name, message)


def _give_back(context: Context, node: Xml, element: Element, scope: str) -> None:
    """Write what came from URDF, and means something there only, as it was."""
    copy = copied(element)
    for name in [name for name in copy.attributes if name.startswith("xmlns:urdf")]:
        del copy.attributes[name]
    for part in copy.walk():
        part.attributes.update(dict.fromkeys(part.attributes.pop(EMPTY, "").split(), ""))
        part.attributes = {name.removeprefix(_OF_URDF): text for name, text in part.attributes.items()}
    copy.name = element.name.removeprefix(_OF_URDF)
    follow_names(context, copy, element, scope)
    context.ledger.take_whole(element)
    if copy.attributes.pop("block", None) is None:
        node.append(copy)
    else:
        context.blob(node.attributes["name"] if node.name in {"link", "joint"} else "").append(copy)


def _give_back_attribute(context: Context, node: Xml, element: Element, name: str, text: str) -> None:
    """Write an attribute that came from URDF as it was, where nothing is written under its name."""
    own = name.removeprefix(_OF_URDF)
    if node.attributes.setdefault(own, text) == text and name not in {JOINT, LINK, PARENT}:
        context.ledger.take(element, name)
        return
    message = f"attribute `{name}` of {element.title} is left out: it means nothing here"
    context.ledger.lose_attribute(element, name, message)


def carry_parts(context: Context, node: Xml, element: Element, scope: str, *parts: str) -> None:
    """The same for an element and parts of it that are written: ``pose=origin`` where URDF calls them otherwise."""
    carry_custom(context, node, element, scope)
    for part in parts:
        name, _, counterpart = part.partition("=")
        own = element.find(name)
        if own is None or not has_custom(own):
            continue
        # An origin may be empty; a limit may not.
        equal = node.reach(counterpart) if counterpart == "origin" else node.find(counterpart or name)
        if equal is not None:
            carry_custom(context, equal, own, scope)


def has_custom(element: Element) -> bool:
    """Are there custom attributes or children that need an equal to hang on?"""
    return any(":" in name for name in element.attributes) or any(
        child.is_custom for child in element.children()
    )


def namespace_of(document: Document, prefix: str) -> str:
    """The URI to declare for a prefix that its document does not declare."""
    table = known_tables(document.library).get(prefix)
    return f"urn:{prefix}" if table is None else vendor(table, "urdf").namespace
