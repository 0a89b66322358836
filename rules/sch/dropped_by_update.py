from collections.abc import Iterator

from sdfcheck import IN_JOINT, IN_LINK, Bad, Diagnostic, Element, Good, Root, Rule, Severity, used

OLD = "1.9"
"""The first version that has none of them."""
JOINT = IN_JOINT.replace("1.12", "1.6")
INERTIAL = IN_LINK.replace("1.12", "1.7")


class DroppedByUpdate(Rule):
    """An element of an old version is lost when consumers bring the file up to the newest one.

    libsdformat and Drake convert a file to the newest version of SDFormat before they read it. Most of what went out of
    the format on the way is translated; `initial_position` of an axis and `relative_to` in the pose of an inertial are
    not, nor `frame`, as it is called before 1.7: Gazebo warns and ignores them, and Drake refuses the file.
    """

    code = "SCH031"
    name = "dropped-by-update"
    severity = Severity.WARNING
    remedy = """Remove it, and write its effect in another way.

    A start position is set by a controller, or by the pose of the joint; for the pose of an inertial write
    the numbers in the frame of the link, which is what it is relative to.
    """
    looks_at = (Root,)
    scaffold = JOINT

    bad = (
        Bad(
            "<axis><xyz>0 0 1</xyz><«initial_position»>1</initial_position></axis>",
            says="`initial_position` is not in SDFormat 1.9, and nothing takes its place",
        ),
        Bad(
            '<inertial><pose «relative_to»="base">0 0 0 0 0 0</pose></inertial>',
            scaffold=INERTIAL,
            says="`relative_to` in the pose of an inertial is not in SDFormat 1.8",
        ),
        Bad(
            '<inertial><pose «frame»="base">0 0 0 0 0 0</pose></inertial>',
            scaffold=INERTIAL.replace("1.7", "1.6"),
            says="`frame` in the pose of an inertial is not in SDFormat 1.8",
        ),
    )
    good = (
        Good("<axis><xyz>0 0 1</xyz></axis>"),
        Good("<inertial><pose>0 0 0 0 0 0</pose></inertial>", scaffold=INERTIAL),
        Good(
            '<inertial><pose frame="">0 0 0 0 0 0</pose></inertial>', scaffold=INERTIAL.replace("1.7", "1.6")
        ),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return root.is_older_than(OLD) and next(dropped(root), None) is not None

    def check(self, root: Root) -> Iterator[Diagnostic]:
        found: dict[str, list[Element]] = {}
        for element in dropped(root):
            found.setdefault(element.name, []).append(element)
        for name, (first, *others) in found.items():
            times = used(1 + len(others))
            if (frame := frame_of(root)) and name == "pose":
                message = f"`{frame}` in the pose of an inertial{times} is not in SDFormat 1.8"
                yield self.diagnostic(first.document.spans.attribute_name(first, frame), message)
            else:
                message = f"`{name}`{times} is not in SDFormat {OLD}, and nothing takes its place"
                yield self.diagnostic(first, message)


def frame_of(root: Root) -> str | None:
    """The attribute by which a pose names its frame in the file's version, if inertials have lost it since."""
    return "frame" if root.is_older_than("1.7") else "relative_to" if root.is_older_than("1.8") else None


def dropped(root: Root) -> Iterator[Element]:
    """The elements of the file's version that are lost on the way to the newest one."""
    for element in root.elements.get("initial_position", ()):
        if element.parent is not None and element.parent.name in {"axis", "axis2"}:
            yield element
    if frame := frame_of(root):
        for inertial in root.elements.get("inertial", ()):
            pose = inertial.find("pose")
            if pose is not None and pose.text_of(frame):
                yield pose
