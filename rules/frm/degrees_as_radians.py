import math
import re
from collections.abc import Iterator

from sdfcheck import (
    IN_LINK,
    IN_ROBOT,
    Bad,
    Diagnostic,
    Element,
    Good,
    Rule,
    Severity,
    TextEdit,
    Value,
    listed,
    make_fix,
)

_WHOLE_TURN = 2 * math.pi
_STEP = 0.5
"""Degrees that people write by hand are multiples of it."""
_NOT_ROTATED = (" 0 0 0", " 0.0 0.0 0.0")
"""How most poses end: a world holds thousands, and hardly one rotation to look at."""
_LARGE = re.compile(r"(?<![\d.])0*(?:[6-9]|[1-9]\d)|[eE]")
"""A number of 6 or more."""


class DegreesAsRadians(Rule):
    """An angle of more than a full turn is a round number of degrees.

    Roll, pitch and yaw are radians in SDFormat and URDF. `90` is read as 14.3 turns, which
    leaves the part at an odd angle. From SDFormat 1.9 on a pose may say `degrees="true"`.
    """

    code = "FRM006"
    name = "degrees-as-radians"
    severity = Severity.WARNING
    remedy = """Write the angle in radians: degrees × π / 180.

    90° is 1.5707963 rad, 45° 0.7853982 and 180° 3.1415927. From SDFormat 1.9 on `<pose degrees="true">`
    takes degrees as they are, and `sdfcheck print --degrees FILE` writes all poses so. In xacro write
    `${radians(90)}` or `${pi/2}`.
    """
    looks_at = (Element,)
    selects = ("sdf:pose", "urdf:origin", "urdf:robot/gazebo")
    scaffold = IN_LINK

    bad = (
        Bad(
            "<pose>0 0 1 0 0 «90»</pose>",
            fixed="<pose>0 0 1 0 0 1.5707963267948966</pose>",
            unsafe=True,
            says="yaw 90 is read as radians, and looks like degrees",
        ),
        Bad(
            "<pose>0 0 1 «-180» 0 45</pose>",
            fixed="<pose>0 0 1 -3.141592653589793 0 0.7853981633974483</pose>",
            unsafe=True,
            says="roll -180 and yaw 45 are read as radians, and look like degrees",
        ),
        Bad(
            '<pose relative_to="__model__">0 0 1 0 0 «90»</pose>',
            fixed='<pose relative_to="__model__">0 0 1 0 0 1.5707963267948966</pose>',
            unsafe=True,
        ),
        Bad(
            '<link name="arm"><inertial><origin rpy="«90» 0 0"/><mass value="1"/>'
            '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>'
            '<joint name="j" type="fixed"><parent link="base"/><child link="arm"/></joint>',
            scaffold=IN_ROBOT,
            says="roll 90",
        ),
        Bad(
            '<gazebo reference="base"><sensor name="s" type="imu"><pose>0 0 0 0 0 «90»</pose></sensor></gazebo>',
            scaffold=IN_ROBOT,
            says="yaw 90",
        ),
    )
    good = (
        Good('<pose degrees="true">0 0 1 0 0 90</pose>'),
        Good('<pose rotation_format="quat_xyzw">0 0 1 0 0 90 0</pose>', why="a quaternion"),
        Good("<pose>90 0 0 0 0 0</pose>", why="the first three are meters"),
        Good("<pose>0 0 1 0 0 7.853981633974483</pose>", why="a turn and a quarter, in radians"),
        Good("<pose>0 0 1 0 0 6</pose>", why="less than a turn"),
    )

    @staticmethod
    def applies(element: Element) -> bool:
        return any(map(_is_in_degrees, _posed(element)))

    def check(self, element: Element) -> Iterator[Diagnostic]:
        for each in filter(_is_in_degrees, _posed(element)):
            value = _value(each)
            found = [angle for angle in _angles(each) if _is_whole_degrees(angle[2])]
            shown = listed(f"{name} {word}" for _, name, word in found)
            are, look = ("is", "looks") if len(found) == 1 else ("are", "look")
            edits = tuple(
                TextEdit(value.part(at), repr(math.radians(float(word))))
                for at, _, word in found
                if value is not None
            )
            yield self.diagnostic(
                edits[0].span,
                f"{shown} {are} read as radians, and {look} like degrees",
                fix=make_fix("write radians", edits, unsafe=True),
            )


def _posed(element: Element) -> list[Element]:
    """The element itself, or the poses of sensors in a block of URDF."""
    if element.name != "gazebo":
        return [element]
    return [
        each
        for child in element.children()
        if child.name == "sensor"
        for each in child.below
        if each.name == "pose"
    ]


def _is_in_degrees(element: Element) -> bool:
    text = element.content if element.name == "pose" else element.text_of("rpy", "")
    if text.endswith(_NOT_ROTATED) or _LARGE.search(text) is None:
        return False
    return any(_is_whole_degrees(word) for _, _, word in _angles(element))


def _value(element: Element) -> Value | None:
    """The text with the angles."""
    return element.attribute("rpy") if element.name == "origin" else element.own_value


def _angles(element: Element) -> list[tuple[int, str, str]]:
    """The angles that are read as radians: the index of the word, what it is called, and the word."""
    value = _value(element)
    words = value.text.split() if value is not None else []
    first = 0
    if element.name == "pose":
        first = 3
        if len(words) != 6 or _says_otherwise(element):
            return []
    if not all(map(_is_number, words)):
        return []
    return list(zip(range(first, first + 3), ("roll", "pitch", "yaw"), words[first:], strict=False))


def _says_otherwise(pose: Element) -> bool:
    """Does it say that it is in degrees, or a quaternion?"""
    holder = pose.parent
    if holder is not None and "degrees" in holder.attributes:  # the business of misplaced-degrees
        return True
    if not pose.attributes:
        return False
    given = pose.attributes
    is_quaternion = given.get("rotation_format", "").strip() == "quat_xyzw"
    return is_quaternion or given.get("degrees", "").strip().lower() in {"true", "1"}


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True


def _is_whole_degrees(word: str) -> bool:
    """Is it more than a turn in radians, and a round number of degrees?"""
    angle = float(word)
    return abs(angle) > _WHOLE_TURN and angle % _STEP == 0
