"""Vendors' own elements and attributes, in the words and at the places that SDFormat has for them."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.urdf_to_sdf.options import Options
from sdfcheck.convert.urdf_to_sdf.plan import Plan
from sdfcheck.convert.vendor_spelling import Spelling, moved, spellings, uses
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.graph import Transmission
from sdfcheck.robot.root import root_of
from sdfcheck.source.altered import Xml
from sdfcheck.source.document import Element
from sdfcheck.source.sniff import Kind

_SIMPLE = "SimpleTransmission"
"""The only kind of transmission that Drake looks into."""
_DRIVABLE = frozenset({"revolute", "continuous", "prismatic", "screw"})


class VendorTags:
    """Writes the tags that a table is about; what no table knows is left to others."""

    def __init__(self, plan: Plan, options: Options, lose: Callable[..., None]) -> None:
        self.plan = plan
        self.options = options
        self.lose = lose
        self.spellings = spellings(plan.root.document, Kind.SDF, self)
        self.named: dict[tuple[str, str], str] = {}
        """Kind and name of a frame or tag → its name in the model, where all names differ."""
        self.moved: list[str] = []
        """The losses of names in the last tag that was written."""
        for child in plan.root.children():
            own = child.attributes.get("name", "")
            is_named = child.name == "frame" or (child.name != "drake:joint" and self.of(child) is not None)
            if own and is_named:
                self.named[child.name, own] = plan.names.free(own)

    def of(self, element: Element) -> Spelling | None:
        """The spelling of an element; None if it is not a vendor's tag that SDFormat can express."""
        made = self.spellings.get(element.name.partition(":")[0])
        return made if made is not None and made.knows(element.name) else None

    def put(self, element: Element, node: Xml) -> bool:
        """Write a tag into the counterpart of its parent; False if no table has it."""
        made = self.spellings.get(element.name.partition(":")[0])
        if made is None:
            return False
        if made.must_drop(element):
            self._drop(element, made)
            return True
        if not made.knows(element.name):
            return False
        self.moved.clear()
        written = made.write(element, node)
        for child in made.dropped:
            self._drop(child, made)
        made.dropped.clear()
        if written is not None:
            own = self.named.get((element.name, written.attributes.get("name", "")))
            if own is not None:
                self._rename(element, written, own)
        self._report_names(element)
        return True

    def _report_names(self, element: Element) -> None:
        for text in dict.fromkeys(self.moved):
            self.lose(element, LossKind.RENAMED, f"{text} in {element.title}", Severity.INFO)

    def _drop(self, element: Element, made: Spelling) -> None:
        text = (
            f"{element.title} is left out: {made.source.name} ignores it here, "
            "and in SDFormat would read it or refuse the file"
        )
        self.lose(element, LossKind.DROPPED_ELEMENT, text)

    def _rename(self, element: Element, written: Xml, own: str) -> None:
        if written.attributes["name"] != own:
            self.lose(element, LossKind.RENAMED, f"{element.title} is named `{own}`")
            written.attributes["name"] = own

    def name(self, text: str, kinds: tuple[str, ...]) -> str:
        """The new name of a link, joint, frame or tag; a link that was merged is what it was merged into."""
        new = self._new_name(text, kinds)
        if new != text:
            self.moved.append(f"`{text}` is now `{new}`")
        return new

    def vector(self, link: str, text: str, *, is_point: bool) -> str:
        """A point or direction of a link, in the frame of the link that it was merged into."""
        home = self.plan.home.get(link)
        return text if home is None else moved(text, home[1], is_point=is_point)

    def _new_name(self, name: str, kinds: tuple[str, ...]) -> str:
        plan = self.plan
        for kind in kinds:
            if (kind, name) in self.named:
                return self.named[kind, name]
            if kind == "joint" and name in plan.names.joints:
                return plan.names.joints[name]
            if kind == "link" and name in plan.home:
                has_frame = "frame" in kinds and self.options.has_frames
                return plan.names.links[name if has_frame else plan.home[name][0]]
        return name

    def put_attribute(self, element: Element, name: str, node: Xml) -> bool:
        """Write an attribute into the counterpart of its element; False if no table knows where."""
        made = self.spellings.get(name.partition(":")[0])
        self.moved.clear()
        is_written = made is not None and made.write_attribute(element, name, node)
        self._report_names(element)
        if not is_written and made is not None and made.attribute(element, name) is not None:
            text = f"{made.source.name} does not read attribute `{name}` of {element.title} there in SDFormat"
            self.lose(element, LossKind.KEPT_AS_EXTENSION, text)
        return is_written

    # Actuators

    def drive(self, transmission: Transmission, joints: Mapping[str, Xml]) -> set[Element]:
        """Put what vendors say of an actuator into the written joint that it drives; returns what was put there."""
        joint = joints.get(_driven(transmission))
        if joint is None or joint.attributes.get("type") == "fixed":
            return set()
        done = set()
        for child in transmission.actuators[0].children():
            if joint.find(child.name) is None and self.put(child, joint):
                done.add(child)
        return done

    def report_actuators(self, joints: Mapping[str, Xml]) -> None:
        """Drake drives joints with a transmission in URDF, and in SDFormat those with an effort other than 0."""
        if not uses(self.plan.root, "drake"):
            return
        models = root_of(self.plan.root.document).models
        driven = {name for each in models[0].transmissions if (name := _driven(each))}
        for name, joint in self.plan.robot.joints.items():
            if name not in joints or joint.kind not in _DRIVABLE or not joint.axes:
                continue
            effort = joint.axes[0].effort
            if name not in driven and effort != 0:
                what = "an actuator in SDFormat: it has an effort, and no transmission"
            elif name in driven and effort == 0:
                what = "no actuator in SDFormat: its effort is 0"
            else:
                continue
            self.lose(joint.element, LossKind.CHANGED_DEFAULT, f"Drake gives {joint.element.title} {what}")

    # Frames

    def frame(self, element: Element) -> Xml | None:
        """Drake's ``frame`` of a robot; None where SDFormat cannot have it."""
        plan = self.plan
        link, own = element.attributes.get("link", ""), element.attributes.get("name", "")
        if not self.options.has_frames or link not in plan.home or plan.is_world(link) or not own:
            return None
        node = Xml("frame", None, name=self.named["frame", own], attached_to=plan.names.links[link])
        if node.attributes["name"] != own:
            text = f"{element.title} is named `{node.attributes['name']}`"
            self.lose(element, LossKind.RENAMED, text)
        texts = (" ".join(element.attributes.get(name, "").split()) or "0 0 0" for name in ("xyz", "rpy"))
        node.add("pose", " ".join(texts))
        return node


def _driven(transmission: Transmission) -> str:
    """The joint that Drake drives by a transmission; empty where it looks at nothing in it."""
    kind, names = transmission.type_value, transmission.joint_names
    is_read = kind is not None and _SIMPLE in kind.text and names and transmission.actuators
    return names[0].text if is_read else ""


def without(node: Xml, source: Element, gone: set[Element]) -> None:
    """Take the copies of some elements out of the copy of ``source``."""
    for copy, child in zip(list(node.children()), source.children(), strict=True):
        if child in gone:
            node.remove(copy)
        else:
            without(copy, child, gone)
