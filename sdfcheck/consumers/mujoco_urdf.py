"""What MuJoCo's reader of URDF refuses in robots that other readers take.

Checked with MuJoCo 4.0. It reads collisions, and visuals only on request, fuses links that do
not move into those that they hang on, and asks the mass of what is left.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import PurePosixPath

from sdfcheck.formats.sdf.values import number
from sdfcheck.formats.urdf.survey import UrdfSurvey, survey
from sdfcheck.formats.urdf.table import is_expression
from sdfcheck.robot.urdf_tree import MOVING, UrdfTree, tree
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element, Value
from sdfcheck.source.record import Record

FORMATS = (".msh", ".obj", ".stl")
"""The mesh files that it decodes."""

LEAST = 1e-15
"""What the mass and the moments of a body that moves must exceed."""


class UnopenedMesh(Record):
    """A mesh whose URI has a scheme, which MuJoCo takes for a folder; ``uses`` counts such meshes."""

    value: Value
    scheme: str
    uses: int


class UndecodedMesh(Record):
    """A mesh file of another format than ``FORMATS``; ``uses`` counts those with its suffix."""

    value: Value
    suffix: str
    uses: int


class MasslessBody(Record):
    """A link that moves by ``joint``, without mass or moments, as is all that is fixed to it."""

    link: Element
    joint: Element


def problems(document: Document) -> Iterator[object]:
    """Everything that keeps MuJoCo from loading a robot, in no particular order."""
    surveyed = survey(document)
    if surveyed.root is None:
        return
    yield from _meshes(surveyed)
    yield from _massless(tree(document))


def _meshes(surveyed: UrdfSurvey) -> Iterator[object]:
    settings = _settings(surveyed)
    roles = ("collision",) if settings.get("discardvisual") != "false" else ("collision", "visual")
    schemes: dict[str, list[Value]] = {}
    suffixes: dict[str, list[Value]] = {}
    for mesh in surveyed.index.get("mesh", ()):
        value, geometry = mesh.attribute("filename"), mesh.parent
        holder = None if geometry is None else geometry.parent
        if value is None or holder is None or holder.name not in roles or is_expression(value.text):
            continue
        scheme, found, _ = value.text.strip().partition(":/")
        if found and settings.get("strippath") != "true":
            schemes.setdefault(scheme, []).append(value)
        suffix = PurePosixPath(value.text.strip()).suffix.lower()
        if suffix not in FORMATS:
            suffixes.setdefault(suffix, []).append(value)
    for scheme, values in sorted(schemes.items()):
        yield UnopenedMesh(values[0], scheme, len(values))
    for suffix, values in sorted(suffixes.items()):
        yield UndecodedMesh(values[0], suffix, len(values))


def _settings(surveyed: UrdfSurvey) -> dict[str, str]:
    """The attributes of ``<mujoco><compiler>`` in the robot."""
    found: dict[str, str] = {}
    assert surveyed.root is not None
    for extension in surveyed.root.children("mujoco"):
        for compiler in extension.children("compiler"):
            found |= compiler.attributes
    return found


def _massless(robot: UrdfTree) -> Iterator[MasslessBody]:
    moved = {name: joints[0] for name, joints in robot.parents.items() if joints[0].type in MOVING}
    for name, joint in moved.items():
        fused = [name]
        for link in fused:
            fixed = (robot.ends(each) for each in robot.children[link] if each.type == "fixed")
            fused += [ends[1] for ends in fixed if ends is not None and ends[1] not in fused]
        if not any(_has_mass(robot.links[link]) for link in fused):
            yield MasslessBody(robot.links[name], joint.element)


def _has_mass(link: Element) -> bool:
    """By its inertial, or by its collisions where it has none; what is no number is told elsewhere."""
    inertial = link.find("inertial")
    if inertial is None:
        return link.has("collision")
    mass, inertia = inertial.find("mass"), inertial.find("inertia")
    if mass is None or inertia is None:
        return True
    values = [
        mass.attributes.get("value", ""),
        *(inertia.attributes.get(m, "") for m in ("ixx", "iyy", "izz")),
    ]
    given = [number(text) for text in values]
    return all(value is None or value > LEAST for value in given)
