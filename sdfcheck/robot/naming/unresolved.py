"""The names by which the joints of a world or model refer to nothing, and those of them that others explain."""

from __future__ import annotations

from typing import TYPE_CHECKING, cast

from sdfcheck.robot.reserved import NODES

if TYPE_CHECKING:
    from collections.abc import Collection

    from sdfcheck.robot.parts.joint import Joint
    from sdfcheck.robot.scope import Scope
    from sdfcheck.source.element import Value

Unresolved = dict[str, list["Value"]]
"""Name → the ends of joints that use it."""


def unresolved_ends(scope: Scope) -> Unresolved:
    """The names that name nothing in a scope of SDFormat, with the ends of its joints that use them.

    Left out are names that are malformed or might be in a file that could not be read,
    and joints whose ends are one name, or whose child is the world.
    """
    found: Unresolved = {}
    for element in scope.children("joint"):
        joint = cast("Joint", scope.part(element))
        if joint.kind != "joint" or joint.child_name in {"world", joint.parent_name}:
            continue
        for value, node in ((joint.parent_value, joint.parent), (joint.child_value, joint.child)):
            if value is None or node is not None or "" in value.text.split("::"):
                continue
            if not scope.may_hold(value.text):
                found.setdefault(value.text, []).append(value)
    return found


def lost_names(scope: Scope, unresolved: Collection[str]) -> frozenset[str]:
    """The unresolved names that belong to what has lost its name, so that they are reported there.

    That are parts of the scope without a name, with that of another, or misspelled ones.
    """
    if not unresolved:
        return frozenset()
    parts = [child for child in scope.children() if child.name in NODES]
    names = [name for part in parts if (name := part.attributes.get("name", ""))]
    nameless = len(parts) - len(names) + sum(map(scope.misspells, NODES))
    if len(unresolved) <= nameless:
        return frozenset(unresolved)
    doubled = len(names) - len(set(names))
    if not doubled:
        return frozenset()
    from sdfcheck.formats.suggest import suggest_in

    # A name like another may be misspelled, while a part with the name of another has lost any name.
    document = scope.document
    unlike = frozenset(name for name in unresolved if suggest_in(document, name, set(names)) is None)
    return unlike if len(unlike) <= nameless + doubled else frozenset()
