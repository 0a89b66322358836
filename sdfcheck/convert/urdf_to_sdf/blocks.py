"""Copies of what is in ``<gazebo>`` blocks, as the version that is written has it.

Names there must not have ``::`` in them, nor be those of two things in one link.
"""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.old_sensors import renew
from sdfcheck.convert.urdf_to_sdf.context import Context
from sdfcheck.convert.urdf_to_sdf.naming import legal
from sdfcheck.convert.writer import Node
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.source.element import Element

_SINGLE = frozenset({"light", "particle_emitter", "projector", "sensor"})
"""The parts of a link or joint that libsdformat looks up by name."""


def copied_entry(context: Context, entry: Element, holder: Node) -> Node:
    """The copy of an entry of a block, entered as such; ``holder`` is where it goes."""
    made = context.copied(entry)
    context.ledger.copy(entry)
    context.copies.append((entry, made, holder))
    _settle_names(context, entry, made, holder)
    if renew(made, context.options.version):
        text = f"the noise of {entry.title} is written for each axis, as SDFormat has it since 1.6"
        context.note(entry, LossKind.CHANGED_DEFAULT, text, Severity.INFO)
    return made


def _settle_names(context: Context, entry: Element, made: Node, holder: Node) -> None:
    for node in _checked(made):
        own = node.attributes.get("name", "")
        if "::" in own:
            node.attributes["name"] = legal(own)
            _report(context, entry, node, own)
    own = made.attributes.get("name", "")
    if made.name not in _SINGLE or not own:
        return
    taken = {child.attributes.get("name") for child in holder.elements(made.name)}
    number = 1
    while made.attributes["name"] in taken:
        number += 1
        made.attributes["name"] = f"{own}_{number}"
    if number > 1:
        _report(context, entry, made, own)


def _report(context: Context, entry: Element, node: Node, own: str) -> None:
    message = f"{node.name} `{own}` of a <gazebo> block is named `{node.attributes['name']}`"
    context.note(entry, LossKind.RENAMED, message)


def _checked(node: Node) -> Iterator[Node]:
    """The elements whose names libsdformat checks: not those of plugins and custom elements, nor what is in them."""
    if node.name == "plugin" or ":" in node.name:
        return
    yield node
    for child in node.elements():
        yield from _checked(child)
