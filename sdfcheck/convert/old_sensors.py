"""Parts of links in ``<gazebo>`` blocks as they were written up to 1.6, in today's words."""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.convert.migrate.up import Operation, operations
from sdfcheck.formats.version import Version
from sdfcheck.source.altered import Xml
from sdfcheck.source.document import Comment

_SINCE = Version(1, 6)
"""From here on the noise of an imu is said for each axis."""
_RELATIVE = Version(1, 7)
"""From here on ``relative_to`` of a pose says what was its ``frame``."""
_IMU = "//imu"


def renew(node: Xml, version: Version) -> bool:
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


def _for_each_axis(imu: Xml, noise: Xml) -> None:
    for operation in operations(_SINCE.minor):
        if operation.at == _IMU and operation.target:
            _copy(imu, operation)
    imu.remove(noise)
    for part in _all(noise):
        for name, text in part.attributes.items():
            if ":" in name:
                imu.attributes.setdefault(name, text)
        imu.extend(*(node for node in part.nodes if isinstance(node, Comment) or _is_custom(node)))


def _copy(imu: Xml, operation: Operation) -> None:
    found: Xml | None = imu
    for name in operation.source.split("/"):
        found = found.find(name) if found is not None else None
    if found is None or not found.content:
        return
    path, _, attribute = operation.target.partition("/@")
    target = imu.reach(*path.split("/"))
    if attribute:
        target.attributes.setdefault(attribute, found.content)
    elif not target.content:
        target.write(found.content)


def _is_custom(child: object) -> bool:
    return isinstance(child, Xml) and ":" in child.name


def _all(node: Xml) -> Iterator[Xml]:
    """A node and those below it, but what is in plugins and custom ones."""
    if node.name == "plugin" or _is_custom(node):
        return
    yield node
    for child in node.children():
        yield from _all(child)
