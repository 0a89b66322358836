"""Joints that URDF cannot have, kept as SDFormat: libsdformat puts them back."""

from __future__ import annotations

from sdfcheck.convert.sdf_to_urdf.context import Context
from sdfcheck.convert.sdf_to_urdf.poses import pose_text, shortened
from sdfcheck.convert.sdf_to_urdf.references import follow_names
from sdfcheck.convert.writer import Node, copied
from sdfcheck.robot.motion.mechanism import Joint
from sdfcheck.source.element import Element

_REPLACED = frozenset({"parent", "child", "pose"})
_DIRECTION = frozenset({"xyz", "use_parent_model_frame"})


def keep_joint(context: Context, joint: Joint, *, in_parent: bool = False) -> None:
    """Keep a joint, its ends and directions as they are in the URDF.

    ``in_parent``: say where it is in its parent. libsdformat places the child of a floating
    joint by that joint, which it drops: this one takes its name, and must not lean on the child.
    """
    copy = copied(joint.element)
    copy.attributes["name"] = context.joints[joint.name]
    copy.drop(_REPLACED)
    follow_names(context, copy, joint.element, joint.name.rpartition("::")[0])
    parent, child = context.link_name(joint.parent), context.link_name(joint.child)
    pose = pose_text(context.layout.within(joint.parent if in_parent else joint.child, joint.pose))
    if in_parent:
        place = [Node("pose", pose, relative_to="__model__" if parent == "world" else parent)]
    else:
        place = [Node("pose", pose)] if pose != "0 0 0 0 0 0" else []
    copy.children[:0] = [
        _with_custom(n, joint.element) for n in (*place, Node("parent", parent), Node("child", child))
    ]
    for number, axis in enumerate(joint.axes):
        node = copy.find("axis" if number == 0 else "axis2")
        if node is not None:
            node.drop(_DIRECTION)
            written = joint.element.find(node.name)
            xyz = Node("xyz", shortened(axis.direction))
            node.children.insert(0, xyz if written is None else _with_custom(xyz, written))
    context.blob().append(copy)
    context.kept.add(joint.name)
    context.ledger.take_whole(joint.element)


def _with_custom(node: Node, holder: Element) -> Node:
    """A new node with the custom attributes of what it takes the place of in ``holder``."""
    old = holder.find(node.name)
    for name, text in () if old is None else old.attributes.items():
        if ":" in name:
            node.attributes.setdefault(name, text)
    return node
