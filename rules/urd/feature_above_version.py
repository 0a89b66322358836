from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, Value, problems, used

ROBOT = '<robot name="r"{}><link name="a"><visual>{{}}</visual></link></robot>'
CAPSULE = '<geometry><capsule radius="1" length="2"/></geometry>'


class FeatureAboveVersion(Rule):
    """Something of URDF 1.1 or 1.2 is used, and the robot does not declare that version.

    Capsules and `quat_xyzw` came with 1.1 (urdfdom 5.1), limits of acceleration and jerk
    with 1.2 (urdfdom 6). Without the version urdfdom ignores the attributes, so that a
    shape is not turned, and at a capsule it drops the rest of the link. With the version declared, urdfdom
    before 5.1 takes the whole file for one that it does not know. Drake reads capsules in any case. Limits that are
    ignored are a warning: the robot is built as before, and others may read them.
    """

    code = "URD019"
    name = "feature-above-version"
    severity = Severity.ERROR
    remedy = """Declare the version: `<robot name="…" version="1.1">`, or 1.2 for acceleration and jerk.

    For programs with an older urdfdom, do without: a cylinder and two spheres for a capsule, `rpy` for a
    quaternion.
    """
    explains = (problems.FeatureAboveVersion,)
    scaffold = ROBOT.format("")

    bad = (
        Bad(
            CAPSULE.replace("capsule", "«capsule»", 1),
            says="`capsule` came with URDF 1.1, and the robot is of version 1.0",
        ),
        Bad(
            '<link name="b"/><joint name="j" type="revolute"><parent link="a"/><child link="b"/>'
            '<limit lower="0" upper="1" effort="1" velocity="1" «acceleration»="1"/></joint>',
            scaffold='<robot name="r"><link name="a"/>{}</robot>',
            says="`acceleration` came with URDF 1.2",
        ),
        Bad(
            '<origin «quat_xyzw»="0 0 0 1"/><geometry><sphere radius="1"/></geometry>',
            says="`quat_xyzw` came with URDF 1.1",
        ),
        Bad(
            CAPSULE.replace("capsule", "«capsule»", 1) + f"</visual><collision>{CAPSULE}</collision><visual>"
            '<geometry><sphere radius="1"/></geometry>',
            says="`capsule` (used 2 times) came with URDF 1.1",
        ),
    )
    good = (Good(CAPSULE, scaffold=ROBOT.format(' version="1.1"'), why="declared"),)

    def check(self, problem: problems.FeatureAboveVersion) -> Iterator[Diagnostic]:
        place = problem.place
        message = (
            f"`{problem.what}`{used(problem.count)} came with URDF {problem.since}, "
            f"and the robot is of version {problem.declared}"
        )
        advice = f'declare it: <robot version="{problem.since}">'
        target = place.name_span if isinstance(place, Value) else place.span
        is_limit = isinstance(place, Value) and place.element.name == "limit"
        severity = Severity.WARNING if is_limit else None
        yield self.diagnostic(target, message, help=advice, severity=severity)
