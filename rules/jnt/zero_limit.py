from collections.abc import Iterator, Mapping

from sdfcheck import IN_JOINT, IN_URDF_JOINT, Bad, Diagnostic, Good, Joint, Limit, Number, Rule, Severity

LEAST, MOST = 2, 200
"""So many joints whose names differ in a word have other limits, of so many that are compared."""
LIMITED = frozenset({"revolute", "prismatic"})
FINGER = (
    '<link name="{0}"/><joint name="{0}_flex" type="revolute"><parent link="palm"/><child link="{0}"/>'
    '<axis xyz="0 1 0"/><limit lower="0" upper="1" effort="{1}" velocity="1"/></joint>'
)
TURN = (
    '<link name="{1}"/><joint name="{1}_turn" type="revolute"><parent link="{0}"/><child link="{1}"/>'
    '<limit lower="0" upper="1" effort="5" velocity="2"/></joint>'
)
SLOW = (
    f'<robot name="r"><link name="a"/>{TURN.format("a", "b")}{TURN.format("b", "c")}<link name="d"/>'
    '<joint name="lift" type="prismatic"><parent link="c"/><child link="d"/>'
    '<limit lower="0" upper="1" effort="5" velocity="{}"/></joint></robot>'
)


def hand(*efforts: str) -> str:
    """A hand with a finger for each effort."""
    fingers = zip(("index", "ring", "little"), efforts, strict=True)
    return (
        f'<robot name="r"><link name="palm"/>{"".join(FINGER.format(*finger) for finger in fingers)}</robot>'
    )


class ZeroLimit(Rule):
    """The effort and the velocity of a joint are limited to zero, or one of them alone.

    Exporters write 0 where nobody has entered a number. Controllers, planners and programs that read the limits, as
    those for PyBullet and Isaac do, take it as the limit that it is; a joint that only swings freely is not affected.
    An effort of 0 beside a velocity is reported where a joint of nearly the same name has one: many robots have none at
    all. A velocity of 0 beside an effort does not count for MoveIt, which then cannot time a motion unless
    `joint_limits.yaml` has a limit, and keeps the joint still in Drake; it is reported where most joints of the robot
    have a velocity. Where the counterparts of a joint have other limits (the same joint of the other side, or of the
    other fingers), 0 is a mistake and a warning, also if it is one of the two alone; if both are 0, one counterpart
    that has both is enough. Where something drives the joint, powerless-joint says so.
    """

    code = "JNT016"
    name = "zero-limit"
    severity = Severity.INFO
    remedy = """Write the greatest effort and velocity of the drive, or leave the joint without controllers.

    Effort is in Nm (N for prismatic joints) at the joint, after the gear: motor torque × ratio ×
    efficiency. Velocity is in rad/s (m/s): the speed of the motor divided by the ratio, 1 rpm = 0.1047
    rad/s. Both are in the data sheet of the servo. Without one, take a generous guess such as 100 and 10,
    which lets controllers work.
    """
    looks_at = (Limit,)
    scaffold = IN_JOINT

    bad = (
        Bad(
            "<axis><xyz>0 0 1</xyz><limit><effort>«0»</effort><velocity>0</velocity></limit></axis>",
            says="effort and velocity of joint `j` are limited to 0",
        ),
        Bad(
            '<limit lower="-1" upper="1" effort="«0»" velocity="0"/>',
            scaffold=IN_URDF_JOINT,
            says="effort and velocity of joint `j` are limited to 0",
        ),
        Bad(
            SLOW.format("«0»"),
            scaffold="{}",
            says="velocity of joint `lift` is limited to 0",
        ),
        Bad(
            hand("1", "«0»", "0").replace('upper="1" effort="0"', 'upper="0" effort="0"'),
            scaffold="{}",
            says="effort of joint `ring_flex` is limited to 0",
        ),
        Bad(
            hand("1", "«0»", "1"),
            scaffold="{}",
            says="effort of joint `ring_flex` is limited to 0, and that of joint `index_flex` to 1",
        ),
        Bad(
            hand("1", "«0»", "-1").replace('"«0»" velocity="1"', '"«0»" velocity="0"'),
            scaffold="{}",
            says="effort and velocity of joint `ring_flex` are limited to 0, and those of joint `index_flex` to 1 and",
        ),
    )
    good = (
        Good(SLOW.format("0").replace('"2"', '"0"'), scaffold="{}", why="nobody wrote a velocity"),
        Good(hand("-1", "0", "-1"), scaffold="{}", why="nobody wrote an effort"),
        Good("<axis><xyz>0 0 1</xyz><limit><effort>-1</effort></limit></axis>", why="no limit"),
        Good("<axis><xyz>0 0 1</xyz><limit><effort>0</effort></limit></axis>", why="passive, in Drake"),
        Good('<limit lower="0" upper="0" effort="0" velocity="0"/>', why="locked", scaffold=IN_URDF_JOINT),
    )

    @staticmethod
    def applies(limit: Limit) -> bool:
        found = zeros(limit)
        if not found or not limit.joint.moves or is_locked(limit):
            return False
        if limit.axis.limit is not limit or limit.joint.driver is not None:
            return False
        return (
            len(found) > 1
            or is_slow(limit, found)
            or is_weak(limit, found)
            or unlike(limit, found) is not None
        )

    def check(self, limit: Limit) -> Iterator[Diagnostic]:
        found = zeros(limit)
        other = unlike(limit, found)
        names, (first, *_) = " and ".join(found), found.values()
        message = f"{names} of {limit.joint.title} {'are' if len(found) > 1 else 'is'} limited to 0"
        if other is None:
            yield self.diagnostic(first, message)
            return
        its = [getattr(other, name) for name in found]
        there = " and ".join(number.text.strip() for number in its)
        message += f", and {'those' if len(found) > 1 else 'that'} of {other.joint.title} to {there}"
        labels = {its[0]: "its counterpart"}
        yield self.diagnostic(first, message, labels=labels, severity=Severity.WARNING)


def is_slow(limit: Limit, found: Mapping[str, Number]) -> bool:
    """Is the velocity alone 0, in URDF, beside an effort that somebody wrote, where most joints have one?"""
    if "velocity" not in found or not limit.joint.is_urdf or not limit.effort > 0:
        return False
    model = limit.joint.model
    return model is not None and model.mostly_has_speeds


def is_weak(limit: Limit, found: Mapping[str, Number]) -> bool:
    """Is the effort alone 0, in URDF, beside a velocity, where a joint of nearly the same name has one?"""
    if "effort" not in found or not limit.joint.is_urdf or not limit.velocity > 0:
        return False
    efforts = (
        other.axis.limit.effort for group in alike(limit.joint) for other in group if other.type in LIMITED
    )
    return any(effort.is_given and effort > 0 for effort in efforts)


def is_locked(limit: Limit) -> bool:
    """Does it leave one position only?"""
    return limit.lower == limit.upper and limit.range[0] == limit.range[1]


def zeros(limit: Limit) -> dict[str, Number]:
    """The limits that are 0."""
    if limit.effort and limit.velocity:
        return {}
    limits = {"effort": limit.effort, "velocity": limit.velocity}
    return {name: number for name, number in limits.items() if number.is_given and number.number == 0}


def unlike(limit: Limit, zero: Mapping[str, Number]) -> Limit | None:
    """Limits of a counterpart in URDF that are not 0, where those of all are not, or where all of its own are."""
    joint = limit.joint
    if not joint.is_urdf:  # Drake's actuators: the second finger of a gripper is passive.
        return None
    groups = [[joint.mirror]] if joint.mirror is not None else alike(joint)
    for group in groups:
        others = [other.axis.limit for other in group if other.type == joint.type]
        whole = [other for other in others if all(getattr(other, name) > 0 for name in zero)]
        if whole and (len(zero) > 1 or len(whole) == len(others)):
            return whole[0]
    return None


def alike(joint: Joint) -> list[list[Joint]]:
    """The joints of its model whose names differ in one of several words, by that word, where there are enough."""
    words = joint.name.split("_")
    found: dict[int, list[Joint]] = {}
    joints = joint.model.joints if joint.model is not None and joint.type in LIMITED else ()
    for other in joints if len(joints) <= MOST else ():
        theirs = other.name.split("_")
        differing = [at for at, (word, its) in enumerate(zip(words, theirs, strict=False)) if word != its]
        if len(differing) == 1 and len(words) == len(theirs) > 1:
            found.setdefault(differing[0], []).append(other)
    return [group for group in found.values() if len(group) >= LEAST]
