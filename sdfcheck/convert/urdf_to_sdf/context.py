"""What the writers of the parts share."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from sdfcheck.convert.loss import Loss, LossKind, loss_at
from sdfcheck.convert.urdf_to_sdf.options import Options
from sdfcheck.convert.urdf_to_sdf.plan import Plan
from sdfcheck.convert.urdf_to_sdf.settings import value_of
from sdfcheck.convert.writer import Comment, Node, comment_of, copied, numbers, spaced
from sdfcheck.formats.sdf.schema import Definition, schema
from sdfcheck.formats.sdf.values import floats
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.motion.rotations import Array, to_rpy
from sdfcheck.source.element import Element

KEPT = "urdf"
"""The prefix of what only URDF has."""


@dataclass(slots=True)
class Context:
    options: Options
    plan: Plan
    losses: list[Loss] = field(default_factory=list)
    links: dict[str, Node] = field(default_factory=dict)
    """What was written for each link (of the source) that survives."""
    joints: dict[str, Node] = field(default_factory=dict)
    came_from: dict[int, str] = field(default_factory=dict)
    """The link (of the source) that a written shape came from, by the identity of its node."""
    own_links: set[str] = field(default_factory=set)
    """Links that only <gazebo> blocks have."""
    dropped_shapes: set[str] = field(default_factory=set)
    lost_mimics: set[str] = field(default_factory=set)
    """Joints that do not follow another any more."""
    overruled: dict[str, dict[str, float]] = field(default_factory=dict)
    """Joint (of the result) → what a <gazebo> block says of its limits and dynamics."""
    reported: set[str] = field(default_factory=set)

    def lose(
        self, element: Element, kind: LossKind, message: str, severity: Severity = Severity.WARNING
    ) -> None:
        self.losses.append(loss_at(element, kind, message, severity))

    def once(self, key: str) -> bool:
        """True at the first call with a key."""
        if key in self.reported:
            return False
        self.reported.add(key)
        return True

    def allows(self, place: str) -> bool:
        """Whether the version has an element at a place below ``model``, such as ``link/sensor``."""
        definition: Definition | None = schema(self.options.version).root.children.get("model")
        for name in place.split("/"):
            definition = definition.children.get(name) if definition is not None else None
        return definition is not None

    def numbers(self, setting: Element, count: int = 1) -> str | None:
        """The numbers of a setting as they are written; None, and reported, if there are not so many."""
        text = value_of(setting)
        found = floats(text) or ()
        if len(found) == count and all(map(math.isfinite, found)):
            return text
        wanted = "a number" if count == 1 else f"{count} numbers"
        message = f"<{setting.name}> is left out: `{text}` is not {wanted}"
        self.lose(setting, LossKind.EXTENSION_NOT_CARRIED, message)
        return None

    def keep(self, element: Element, node: Node) -> None:
        """Carry something over that the target has no word for, under a prefix of its own."""
        made = copied(element)
        if not element.is_custom:
            made.name = f"{KEPT}:{made.name}"
            text = f"{element.title} means nothing in SDFormat; it is kept as <{made.name}>"
            self.lose(element, LossKind.KEPT_AS_EXTENSION, text, Severity.INFO)
            own = made.attributes.get("name")
            if own is not None and node.name == "model" and not self.plan.names.claim(own):
                # libsdformat wants different names of everything in a model, known to it or not.
                made.attributes = {
                    f"{KEPT}:name" if key == "name" else key: text for key, text in made.attributes.items()
                }
        elif node.name == "model" and (own := made.attributes.get("name")) is not None:
            name = made.attributes["name"] = self.plan.names.free(own)
            if name != own:
                self.lose(element, LossKind.RENAMED, f"{element.title} is named `{name}`")
        node.append(made)


def comments_in(element: Element) -> list[Comment]:
    """The comments anywhere inside an element."""
    found = (comment_of(node) for node in element.iter())
    return [comment for comment in found if comment is not None]


def pose_text(element: Element) -> str | None:
    """An element's ``origin`` as the text of a pose, with the author's numbers; None where it is identity."""
    origin = element.find("origin")
    if origin is None or "quat_xyzw" in origin.attributes:
        return None
    texts = [spaced(origin.attributes.get(name, "")) or "0 0 0" for name in ("xyz", "rpy")]
    joined = " ".join(texts)
    return None if all(float(part) == 0 for part in joined.split()) else joined


def pose_of(pose: Array) -> str | None:
    """A 4×4 pose as text; None where it is identity."""
    text = numbers((*pose[:3, 3], *to_rpy(pose[:3, :3])))
    return None if text == "0 0 0 0 0 0" else text


def is_quaternion(element: Element) -> bool:
    origin = element.find("origin")
    return origin is not None and "quat_xyzw" in origin.attributes
