"""Parts of links in ``<gazebo>`` blocks as they were written up to 1.6, in today's words."""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.convert.migrate.up import Operation, operations
from sdfcheck.convert.writer import Node
from sdfcheck.formats.version import Version
from sdfcheck.source.document import Comment

_SINCE = Version(1, 6)
"""From here on the noise of an imu is said for each axis."""
_RELATIVE = Version(1, 7)
"""From here on ``relative_to`` of a pose says what was its ``frame``."""
_IMU = "//imu"


def renew(node: Node, version: Version) -> bool:
    """Say the noise of the imus, and the frames of poses, in a copied element as a version has them.

    True if there was noise.
    """
    if version >= _RELATIVE:
        for pose in [*_all(node)]:
            if pose.name == "pose" and (frame := pose.attributes.pop("frame", None)):
                pose.attributes.setdefault("relative_to", frame)
    changed = False
    if version >= _SINCE:
        for imu in [*_all(node)]:
            noise = imu.find("noise") if imu.name == "imu" else None
            if noise is not None:
                _for_each_axis(imu, noise)
                changed = True
    return changed


def _for_each_axis(imu: Node, noise: Node) -> None:
    for operation in operations(_SINCE.minor):
        if operation.at == _IMU and operation.target:
            _copy(imu, operation)
    imu.children.remove(noise)
    for part in _all(noise):
        for name, text in part.attributes.items():
            if ":" in name:
                imu.attributes.setdefault(name, text)
        imu.children += [c for c in part.children if isinstance(c, Comment) or _is_custom(c)]


def _copy(imu: Node, operation: Operation) -> None:
    found: Node | None = imu
    for name in operation.source.split("/"):
        found = found.find(name) if found is not None else None
    if found is None or not found.text:
        return
    path, _, attribute = operation.target.partition("/@")
    target = imu.reach(*path.split("/"))
    if attribute:
        target.attributes.setdefault(attribute, found.text)
    elif target.text is None:
        target.text = found.text


def _is_custom(child: object) -> bool:
    return isinstance(child, Node) and ":" in child.name


def _all(node: Node) -> Iterator[Node]:
    """A node and those below it, but what is in plugins and custom ones."""
    if node.name == "plugin" or _is_custom(node):
        return
    yield node
    for child in node.elements():
        yield from _all(child)
