"""Settings that all visuals or all collisions of a link share, and URDF does not have: surfaces,
textures, flags.

libsdformat lays a ``visual`` or ``collision`` in a link's ``gazebo`` element over all that have no
name.
"""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.sdf_to_urdf.context import Context
from sdfcheck.convert.writer import copied
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.motion.mechanism import Link
from sdfcheck.source.element import Element

_SAID = frozenset({"auto_inertia_params", "density", "geometry", "pose"})
"""The settings that are written otherwise: density is in the inertia, if it is used at all."""
_COLOR = frozenset({"diffuse", "ambient"})


def keep_extras(context: Context, link: Link, role: str, parts: list[Element]) -> bool:
    """Keep what the parts have beyond URDF as an extension, if it is the same for all and nothing needs names.

    True if it is kept: then the parts must be written without names.
    """
    each = [list(_extras(part)) for part in parts]
    if not each or not each[0] or _names_matter(link.element, role):
        return False
    meant = [[_canonical(extra) for extra in extras] for extras in each]
    if any(other != meant[0] for other in meant[1:]):
        return False
    blob = context.blob(context.links[link.name]).add(role)
    blob.children.extend(copied(extra) for extra in each[0])
    for extra in (extra for extras in each for extra in extras):
        context.ledger.copy(extra)
    names = ", ".join(f"`{extra.name}`" for extra in each[0])
    message = (
        f"{names} of the {role}s of {link.element.title} is kept for libsdformat alone, and costs their names"
    )
    context.ledger.note(LossKind.KEPT_AS_EXTENSION, each[0][0], message, Severity.INFO)
    return True


def _extras(part: Element) -> Iterator[Element]:
    for child in part.children():
        if child.name == "material":
            if any(inner.name not in _COLOR for inner in child.children()):
                yield child
        elif child.name not in _SAID and not child.is_custom:
            yield child


def _names_matter(link: Element, role: str) -> bool:
    """Does a contact sensor of the link name a collision?"""
    return role == "collision" and any(sensor.has("contact") for sensor in link.children("sensor"))


def _canonical(element: Element) -> tuple[object, ...]:
    inner = tuple(_canonical(child) for child in element.children())
    return (element.name, tuple(sorted(element.attributes.items())), " ".join(element.content.split()), inner)
