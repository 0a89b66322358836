from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Semantics, Severity, named

MANIFEST = "<package><name>arm</name><buildtool_depend>{}</buildtool_depend></package>"
ROBOT = (
    '<robot name="arm"><link name="base"/><link name="upper"/><joint name="shoulder" type="revolute">'
    '<parent link="base"/><child link="upper"/><limit lower="-1" upper="1" effort="5" velocity="2"/></joint></robot>'
)
LIMITS = (
    "joint_limits:\n  shoulder:\n    has_velocity_limits: true\n    max_velocity: 2.0\n"
    "    has_acceleration_limits: {}\n    max_acceleration: {}\n"
)
SRDF = '<robot name="arm"><group name="{}"><chain base_link="base" tip_link="upper"/></group></robot>'
NEW = "response_adapters: [default_planning_response_adapters/AddTimeOptimalParameterization]\n"
OLD = "request_adapters: default_planner_request_adapters/AddTimeOptimalParameterization\n"


def files(limits: str, build: str = "ament_cmake", **more: str) -> dict[str, str]:
    own = {"arm.urdf": ROBOT, "package.xml": MANIFEST.format(build), "joint_limits.yaml": limits}
    return own | {f"{name}.yaml": text for name, text in more.items()}


class MissingAccelerationLimit(Rule):
    """MoveIt plans for a joint whose acceleration nothing limits.

    From Jazzy on, MoveIt times each trajectory by the limits of velocity and acceleration, and gives up where a joint
    has none: "No acceleration limit was defined for joint". URDF up to 1.1 has no place for it; MoveIt's assistant
    writes `has_acceleration_limits: false` into `joint_limits.yaml`. Packages whose pipeline of planners is that of
    Humble, which took 1 rad/s², are left alone.
    """

    code = "JNT038"
    name = "missing-acceleration-limit"
    severity = Severity.WARNING
    remedy = """Write `has_acceleration_limits: true` and `max_acceleration: 3.0` into `joint_limits.yaml`.

    The number is that of the drives, in rad/s² or m/s²; a few times the velocity is a usual guess.
    """
    looks_at = (Semantics,)
    scaffold = "{}"
    sources = ("https://github.com/moveit/moveit2",)

    bad = (
        Bad(
            SRDF.format("«all»"),
            file="arm.srdf",
            files=files(LIMITS.format("false", "0.0"), ompl_planning=NEW),
            says="group `all` has joint `shoulder`, whose acceleration `joint_limits.yaml` does not limit",
        ),
    )
    good = (
        Good(SRDF.format("all"), file="arm.srdf", files=files(LIMITS.format("true", "3.0"))),
        Good(
            SRDF.format("all"),
            file="arm.srdf",
            files=files(LIMITS.format("false", "0.0"), "catkin"),
            why="ROS 1 has 1 rad/s²",
        ),
        Good(
            SRDF.format("all"),
            file="arm.srdf",
            files=files(LIMITS.format("false", "0.0"), ompl_planning=OLD),
            why="planners of Humble",
        ),
    )

    @staticmethod
    def applies(semantics: Semantics) -> bool:
        return bool(semantics.beside) and any(True for _ in semantics.unlimited_joints)

    def check(self, semantics: Semantics) -> Iterator[Diagnostic]:
        value, joints, span = next(semantics.unlimited_joints)
        group, file = value.text.strip(), span.source.path.name
        some = f"joint{'s' * (len(joints) > 1)} {named(joints, most=3)}"
        message = f"group `{group}` has {some}, whose acceleration `{file}` does not limit"
        severity = None if semantics.parameters.release else Severity.INFO
        yield self.diagnostic(value, message, labels={span: "written here"}, severity=severity)
