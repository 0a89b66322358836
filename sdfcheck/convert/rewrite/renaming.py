"""Which link and joint of one robot is which of another: by name, or by being alike."""

from __future__ import annotations

from collections.abc import Callable, Container, Iterable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from sdfcheck.robot.motion.mass import default_mass
from sdfcheck.robot.motion.mass_properties import MassProperties
from sdfcheck.robot.motion.mechanism import Geometry, Joint, Link, Mechanism
from sdfcheck.robot.motion.rotations import Array, inverse
from sdfcheck.source.sniff import Kind


@dataclass(frozen=True, slots=True)
class Names:
    """Names in the first robot → names in the second, of all links and joints that are in both."""

    links: dict[str, str]
    joints: dict[str, str]

    @classmethod
    def between(cls, a: Mechanism, b: Mechanism, tolerance: float) -> Names:
        """Pair what has one name; of the rest, pair what is alike if nothing else is."""
        links = same_names(a.links, b.links)

        def alike(name: str, other: str) -> bool:
            return _same_link(a, a.links[name], b, b.links[other], links, tolerance)

        # A renamed link is known by its parent, which may have been renamed as well.
        while found := _unique_pairs(list(a.links), list(b.links), links, alike):
            links.update(found)
        joints = same_names(a.joints, b.joints)

        def between_same_links(name: str, other: str) -> bool:
            return _ends(a.joints[name], links) == _ends(b.joints[other], {})

        joints.update(_unique_pairs(list(a.joints), list(b.joints), joints, between_same_links))
        return cls(
            {name: links[name] for name in a.links if name in links},
            {name: joints[name] for name in a.joints if name in joints},
        )


def same_names(a: Iterable[str], b: Container[str]) -> dict[str, str]:
    """The parts of one name, or of the name that they get where scopes are flattened."""
    same = {name: name for name in a if name in b}
    taken = set(same)
    for name in a:
        flat = name.replace("::", "__")
        if name not in same and flat in b and flat not in taken:
            same[name] = flat
            taken.add(flat)
    return same


def seat(robot: Mechanism, name: str) -> tuple[str, Array]:
    """The link that carries a link, empty for none, and the 4×4 pose in it or in the model."""
    pose = robot.links[name].pose
    for joint in robot.joints.values():
        parent = robot.links.get(joint.parent)
        if joint.child == name and parent is not None and joint.parent != name:
            return parent.name, inverse(parent.pose) @ pose
    return "", pose


def meant_body(link: Link, other: Link) -> MassProperties | None:
    """The mass properties of a link; what an SDF model leaves out is 1 kg, where the other link has any."""
    silent = link.body is None and other.body is not None and link.element.document.kind is Kind.SDF
    return default_mass() if silent else link.body


def filled(robot: Mechanism, other: Mechanism, names: Mapping[str, str]) -> Mechanism:
    """The robot with the mass properties that are meant, where those of the other robot are written."""
    links = {
        name: replace(link, body=meant_body(link, other.links[names[name]])) if name in names else link
        for name, link in robot.links.items()
    }
    return replace(robot, links=links)


def same_pose(a: Array, b: Array, tolerance: float) -> bool:
    scale = max(1.0, float(np.abs(a[:3, 3]).max()))
    return bool(np.allclose(a, b, rtol=0, atol=tolerance * scale))


def same_geometry(a: Geometry, b: Geometry, tolerance: float) -> bool:
    """Are they one shape at one place? Names and files do not matter."""
    is_alike = (a.role, a.kind) == (b.role, b.kind) and a.is_as_large_as(b, tolerance)
    return is_alike and same_pose(a.pose, b.pose, tolerance)


def _unique_pairs(
    before: list[str], after: list[str], known: dict[str, str], alike: Callable[[str, str], bool]
) -> dict[str, str]:
    taken = set(known.values())
    gone = [name for name in before if name not in known]
    new = [name for name in after if name not in taken]
    candidates = {name: [other for other in new if alike(name, other)] for name in gone}
    found = {name: others[0] for name, others in candidates.items() if len(others) == 1}
    chosen = [other for others in candidates.values() for other in others]
    return {name: other for name, other in found.items() if chosen.count(other) == 1}


def _same_link(
    a: Mechanism, link: Link, b: Mechanism, other: Link, links: dict[str, str], tolerance: float
) -> bool:
    parent, here = seat(a, link.name)
    other_parent, there = seat(b, other.name)
    if (links.get(parent) if parent else "") != other_parent or not same_pose(here, there, tolerance):
        return False
    if len(link.geometries) != len(other.geometries) or not _same_body(
        meant_body(link, other), meant_body(other, link)
    ):
        return False
    pairs = zip(link.geometries, other.geometries, strict=True)
    return all(same_geometry(mine, theirs, tolerance) for mine, theirs in pairs)


def _same_body(a: MassProperties | None, b: MassProperties | None) -> bool:
    if a is None or b is None:
        return a is b
    same_mass = bool(np.isclose(a.mass, b.mass, rtol=1e-9, atol=0))
    return same_mass and np.allclose(a.center, b.center) and np.allclose(a.moments, b.moments, rtol=1e-6)


def _ends(joint: Joint, links: dict[str, str]) -> tuple[str, str]:
    return links.get(joint.parent, joint.parent), links.get(joint.child, joint.child)
