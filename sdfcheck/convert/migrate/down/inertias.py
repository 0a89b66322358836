"""Automatic inertias as numbers, for versions that do not compute them."""

from __future__ import annotations

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.migrate import numbers
from sdfcheck.convert.migrate.migration import Migration, title
from sdfcheck.convert.migrate.node import Node
from sdfcheck.convert.migrate.places import Places
from sdfcheck.convert.writer import number, settled
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.errors import DescriptionError
from sdfcheck.robot.motion.mass import automatic
from sdfcheck.robot.motion.mass_properties import MassProperties
from sdfcheck.robot.motion.poses import PoseError
from sdfcheck.robot.parts.link import Link

_COMPONENTS = (("ixx", 0, 0), ("ixy", 0, 1), ("ixz", 0, 2), ("iyy", 1, 1), ("iyz", 1, 2), ("izz", 2, 2))


def write_inertias(migration: Migration) -> None:
    """Below 1.11: replace ``auto`` and densities by what comes out of them."""
    places = Places(migration)
    for link in migration.root.of("link"):
        inertial, frame = link.find("inertial"), places.frame(link)
        if inertial is None or (inertial.get("auto") or "").strip().lower() not in {"true", "1"}:
            continue
        if isinstance(frame, Link):
            try:
                _write(inertial, automatic(frame))
            except (DescriptionError, PoseError) as error:
                migration.changed_bodies = True
                text = f"the automatic inertia of {title(link)} is lost: {error}"
                migration.lose(inertial, text, LossKind.CHANGED_INERTIA, Severity.ERROR)
    for inertial in migration.root.of("inertial"):
        inertial.unset("auto")
        _remove(migration, inertial)
    for collision in migration.root.of("collision"):
        _remove(migration, collision)


def _remove(migration: Migration, node: Node) -> None:
    for name in ("density", "auto_inertia_params"):
        for child in node.children(name):
            migration.merge(child)


def _write(inertial: Node, body: MassProperties) -> None:
    pose = inertial.find("pose")
    center = numbers.vector((*body.center, 0, 0, 0))
    if pose is not None:
        for name in ("relative_to", "rotation_format", "degrees"):
            pose.unset(name)
        pose.write(center)
    elif body.center.any():
        inertial.add("pose", center)
    (inertial.find("mass") or inertial.add("mass")).write(number(body.mass))
    inertia = inertial.find("inertia") or inertial.add("inertia")
    largest = float(abs(body.moments).max())
    for name, row, column in _COMPONENTS:
        component = inertia.find(name) or inertia.add(name)
        component.write(number(settled(float(body.moments[row, column]), largest)))
