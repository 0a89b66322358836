"""Vendors' own elements, in the words and at the places that URDF has for them."""

from __future__ import annotations

import numpy as np

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.sdf_to_urdf.context import Context, mesh_uri
from sdfcheck.convert.sdf_to_urdf.plan import is_same, shortened
from sdfcheck.convert.vendor_spelling import Spelling, moved, spellings
from sdfcheck.formats.vendor.definitions import Tag
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.motion.poses import Array, to_rpy
from sdfcheck.source.altered import Xml, copied
from sdfcheck.source.document import Element
from sdfcheck.source.sniff import Kind

_ACTUATOR = "actuator"
_SIMPLE = "transmission_interface/SimpleTransmission"
_DRIVEN = frozenset({"revolute", "continuous", "prismatic", "screw"})
_MATERIAL = "material/"
_INTERFACE = "hardware_interface/EffortJointInterface"


class VendorTags:
    """Writes the tags of one model or of a part of it; ``scope`` is the nested model, seen from the top."""

    def __init__(self, context: Context, scope: str) -> None:
        self.context = context
        self.scope = scope
        self.spellings = spellings(context.scope.element.document, Kind.URDF, self)

    def put(self, element: Element, node: Xml) -> bool:
        """Write a tag into the counterpart of its parent; False if no table has it."""
        made = self.spellings.get(element.name.partition(":")[0])
        tag = made.target.tags.get(element.name) if made is not None else None
        if made is None or tag is None:
            return False
        self.context.ledger.take_whole(element)
        if not tag.places:
            return self._elsewhere(element, node, made, tag.absent.use if tag.absent else "")
        if tag.name == "drake:joint" or node.name == "geometry":
            return True  # joints and shapes are written
        if tag.places[0].path[0].name == _ACTUATOR:
            self._drive(element, node, made)
        else:
            self._rename(made.write(element, node), tag)
        return True

    def put_attribute(self, element: Element, name: str, node: Xml) -> bool:
        """Write an attribute into the counterpart of its element; False if it is not read there, or no table has it."""
        made, ledger = self.spellings.get(name.partition(":")[0]), self.context.ledger
        if made is None:
            return False
        place = made.place(name, node)
        if made.write_attribute(element, name, node):
            ledger.take(element, name)
        elif made.attribute(element, name) is not None:
            text = f"{made.source.name} does not read attribute `{name}` of {element.title} there in URDF"
            ledger.note(LossKind.KEPT_AS_EXTENSION, element, text)
            return False
        elif place is not None and place.carrier == "attribute":
            text = f"attribute `{name}` of {element.title} is left out: it is ignored here, and would not be in URDF"
            ledger.lose_attribute(element, name, text)
        else:
            return False
        return True

    def _elsewhere(self, element: Element, node: Xml, made: Spelling, use: str) -> bool:
        """What URDF says without a tag, or cannot say."""
        if use == "joint/mimic" and node.name == "joint":
            self._mimic(element, node)
        elif use.startswith(_MATERIAL) and node.name == "material":
            node.add("texture", filename=mesh_uri(self.context, element.content, element))
        else:
            self._keep(element, node, made)
        return True

    def _rename(self, written: Xml | None, tag: Tag) -> None:
        """Names of tags of nested models get those of the models in front, as links do."""
        slot = tag.attributes.get("name")
        if (
            self.scope
            and written
            and slot is not None
            and not slot.references
            and "name" in written.attributes
        ):
            written.attributes["name"] = f"{self.scope}::{written.attributes['name']}".replace("::", "__")

    def _keep(self, element: Element, node: Xml, made: Spelling) -> None:
        """Keep what the vendor has in SDFormat only where the other way round looks for it."""
        reference = node.attributes.get("name", "") if node.name in {"link", "joint"} else ""
        self.context.blob(reference).append(copied(element))
        message = (
            f"{made.source.name} has `{element.name}` in SDFormat only: it is kept as a gazebo extension"
        )
        self.context.ledger.note(LossKind.KEPT_AS_EXTENSION, element, message, Severity.WARNING)

    # The parts that names refer to

    def name(self, text: str, kinds: tuple[str, ...]) -> str:
        """The name in the URDF; where a frame is wanted, one that is there for Drake."""
        full = f"{self.scope}::{text}" if self.scope else text
        context = self.context
        for kind in kinds:
            if kind == "joint" and full in context.joints:
                return context.joints[full]
            if kind == "frame" and full in context.read.frames:
                return self._frame(full, context.frame_names[full], *context.read.frames[full])
            if kind == "link" and full in context.links:
                own = context.links[full]
                return self._frame(full, f"{own}_frame", full, np.eye(4)) if "frame" in kinds else own
            if ":" in kind:
                return full.replace("::", "__")
        return text

    def _frame(self, name: str, wished: str, link: str, pose: Array) -> str:
        """A frame at a pose on a link of the source; the link itself where it is the same."""
        context = self.context
        within = context.layout.within(link, context.robot.links[link].pose @ pose)
        is_link = name in context.links
        if is_link and is_same(within, np.eye(4)):
            return context.links[link]
        if not is_link and context.options.frames:
            return wished
        if (known := context.drake_frames.get(name)) is not None:
            return known
        own = context.drake_frames[name] = context.naming.unique(wished) if is_link else wished
        angles = shortened(to_rpy(within[:3, :3]))
        node = context.root.add("frame", None, name=own, link=context.links[link])
        node.attributes.update(xyz=shortened(within[:3, 3]), rpy=angles)
        return own

    def vector(self, link: str, text: str, *, is_point: bool) -> str:
        """A point or direction of a link whose frame may have moved to its joint."""
        full = f"{self.scope}::{link}" if self.scope and not link.startswith(f"{self.scope}::") else link
        source = self.context.robot.links.get(full)
        if source is None:
            return text
        return moved(text, self.context.layout.within(full, source.pose), is_point=is_point)

    # Joints

    def _drive(self, element: Element, joint: Xml, made: Spelling) -> None:
        """A tag in the joint is in its actuator in URDF."""
        if joint.attributes.get("type") in _DRIVEN:
            self.context.actuators.setdefault(joint.attributes["name"], []).append(made.element(element))
            return
        message = f"`{element.name}` is left out: what is written for the joint has no actuator"
        self.context.ledger.lose(LossKind.DROPPED_ELEMENT, element, message)

    def _mimic(self, element: Element, joint: Xml) -> None:
        """URDF's own, which may be there for another reason."""
        if joint.find("mimic") is None:
            values = {name: element.attributes.get(name, "") for name in ("multiplier", "offset")}
            leader = self.name(element.attributes.get("joint", ""), ("joint",))
            joint.add("mimic", None, joint=leader, **values)


def write_actuators(context: Context) -> None:
    """Write what was in joints into the transmissions of those, which are made where there are none.

    In SDFormat Drake drives each joint with an effort other than 0, in URDF those with a transmission.
    """
    for edge in context.made.edges if context.natives else ():
        joint = context.robot.joints[edge.joint.name]
        if joint.kind in _DRIVEN and joint.axes and joint.axes[0].effort != 0:
            context.actuators.setdefault(context.joints[joint.name], [])
    for name, tags in context.actuators.items():
        actuator = _actuator_of(context, name) or _new_actuator(context, name)
        actuator.extend(*[tag for tag in tags if actuator.find(tag.name) is None])


def _actuator_of(context: Context, joint: str) -> Xml | None:
    for node in context.root.children("transmission"):
        driven = node.find("joint")
        if driven is not None and driven.attributes.get("name") == joint:
            return node.find(_ACTUATOR)
    return None


def _new_actuator(context: Context, joint: str) -> Xml:
    transmission = context.root.add("transmission", None, name=f"{joint}_transmission")
    transmission.add("type", _SIMPLE)
    transmission.add("joint", None, name=joint).add("hardwareInterface", _INTERFACE)
    return transmission.add(_ACTUATOR, None, name=joint)
