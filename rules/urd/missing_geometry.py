from collections.abc import Iterator

from sdfcheck import (
    IN_URDF_LINK,
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Rule,
    Severity,
    accepts,
    problems,
    refuses,
    unreadable,
    warns,
)


class MissingGeometry(Rule):
    """A visual or collision has no shape, or one that is not known, or a mesh without file.

    urdfdom stops reading the link there, so that it loses the visuals that follow and all
    of its collisions; the rest of the robot is read as if nothing had happened. Drake
    refuses the file. A shape with a prefix is meant for one reader: a warning.
    """

    code = "URD007"
    name = "missing-geometry"
    severity = Severity.ERROR
    affects = {
        Consumer.GAZEBO: warns("drops the rest of the link"),
        Consumer.DRAKE: REFUSES,
        Consumer.URDFDOM: warns("drops the rest of the link"),
        Consumer.MUJOCO: refuses("refuses it in a collision"),
    }
    explains = (problems.MissingGeometry, problems.UnknownShape)
    scaffold = IN_URDF_LINK

    bad = (
        Bad('<«visual»><origin xyz="0 0 1"/></visual>', says="`visual` has no `geometry`"),
        Bad(
            '<collision name="c"><«geometry»/></collision>', says="the geometry of collision `c` has no shape"
        ),
        Bad(
            "<visual><geometry><«mesh»/></geometry></visual>",
            says="the mesh of `visual` has no `filename`",
        ),
        Bad(
            '<visual><geometry><«sphear» radius="1"/></geometry></visual>',
            says="`sphear` is no shape of URDF; did you mean `sphere`?",
        ),
        Bad(
            '<robot name="r" xmlns:drake="http://drake.mit.edu"><link name="a"><collision>'
            '<geometry><«drake:ellipsoid» a="1" b="2" c="3"/></geometry></collision></link></robot>',
            scaffold="",
            says="`drake:ellipsoid` is no shape of URDF",
        ),
    )
    good = (Good('<visual><geometry><mesh filename="package://p/m.stl"/></geometry></visual>'),)

    def check(self, problem: problems.MissingGeometry | problems.UnknownShape) -> Iterator[Diagnostic]:
        element, shown = problem.element, problem.shown
        affects = {Consumer.MUJOCO: unreadable(shown)[Consumer.MUJOCO]}
        if element.name.startswith("drake:"):
            affects[Consumer.DRAKE] = accepts("knows it")
        if isinstance(problem, problems.UnknownShape):
            guess = f"; did you mean `{problem.suggestion}`?" if problem.suggestion else ""
            severity = Severity.WARNING if element.is_custom else None
            yield self.diagnostic(
                element, f"`{element.name}` is no shape of URDF{guess}", severity=severity, affects=affects
            )
        elif element.name == "mesh":
            yield self.diagnostic(element, f"the mesh of {shown.title} has no `filename`", affects=affects)
        elif element.name == "geometry":
            yield self.diagnostic(element, f"the geometry of {shown.title} has no shape", affects=affects)
        else:
            yield self.diagnostic(element, f"{shown.title} has no `geometry`", affects=affects)
