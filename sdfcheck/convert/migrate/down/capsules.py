"""Capsules as what they are made of, for versions without: a cylinder and two spheres."""

from __future__ import annotations

import numpy as np

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.migrate import numbers
from sdfcheck.convert.migrate.migration import Migration, title
from sdfcheck.convert.migrate.node import Node
from sdfcheck.convert.writer import number
from sdfcheck.robot.motion.poses import PoseError, written_pose
from sdfcheck.robot.motion.rotations import Array

_OWNERS = frozenset({"collision", "visual"})


def split_capsules(migration: Migration) -> None:
    """Below 1.8, with poses in plain numbers."""
    migration.draft.read()
    for capsule in migration.root.of("capsule"):
        owner = capsule.parent.parent if capsule.parent is not None else None
        radius, length = _size(capsule, "radius"), _size(capsule, "length")
        if owner is None or owner.name not in _OWNERS or radius is None or length is None:
            continue
        try:
            at = written_pose(migration.draft.element(owner).find("pose"))
        except PoseError:
            continue
        for end, z in (("bottom", -length / 2), ("top", length / 2)):
            _add_sphere(owner, _free_name(owner, end), radius, at @ _lifted(z))
        capsule.rename("cylinder")
        migration.dropped_shapes.add("capsule")
        text = f"the capsule of {title(owner)} is written as a cylinder and two spheres: {migration.target} has none"
        migration.lose(owner, text, LossKind.UNSUPPORTED_GEOMETRY)


def _size(capsule: Node, name: str) -> float | None:
    child = capsule.find(name)
    try:
        return float(child.content) if child is not None else None
    except ValueError:
        return None


def _lifted(z: float) -> Array:
    transform = np.eye(4)
    transform[2, 3] = z
    return transform


def _free_name(owner: Node, end: str) -> str:
    assert owner.parent is not None
    name = f"{owner.get('name')}_{end}"
    while name in {sibling.get("name") for sibling in owner.parent.children(owner.name)}:
        name += "_"
    return name


def _add_sphere(owner: Node, name: str, radius: float, pose: Array) -> None:
    assert owner.parent is not None
    copied = owner.copy()
    copied.set("name", name)
    sphere = Node("sphere")
    capsule = copied.find("geometry/capsule")
    assert capsule is not None
    capsule.replace([sphere])
    size = Node("radius")
    size.parts, size.parent = [number(radius)], sphere
    sphere.parts.append(size)
    owner.parent.append(copied, after=owner)
    (copied.find("pose") or copied.add("pose", first=True)).write(numbers.pose(pose))
