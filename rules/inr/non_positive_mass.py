from collections.abc import Iterator

from sdfcheck import (
    IN_LINK,
    Bad,
    Consumer,
    Diagnostic,
    Element,
    Good,
    Rule,
    Severity,
    accepts,
    problems,
    refuses,
    warns,
)


class NonPositiveMass(Rule):
    """A mass is negative, zero or not a number.

    libsdformat refuses a model with a negative or undefined mass; Drake aborts. A zero
    mass is accepted and leaves the link without inertia: physics engines drop it, or
    divide by it.
    """

    code = "INR001"
    name = "non-positive-mass"
    severity = Severity.ERROR
    explains = (problems.NonPositiveMass,)
    affects = {
        Consumer.GAZEBO: refuses("refuses a negative mass"),
        Consumer.DRAKE: warns("takes a solid sphere in its place"),
        Consumer.MUJOCO: refuses("refuses a link that moves"),
    }
    scaffold = IN_LINK

    bad = (
        Bad("<inertial><mass>«-1»</mass></inertial>", says="mass -1 is negative"),
        Bad("<inertial><mass>«0»</mass></inertial>", says="no mass"),
        Bad(
            '<robot name="r"><link name="a"><inertial><mass value="«-2»"/>'
            '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link></robot>',
            scaffold="",
        ),
    )
    good = (
        Good("<inertial><mass>1e-9</mass></inertial>", why="small, but a mass"),
        Good(
            '<sdf version="1.12"><model name="m"><static>true</static><link name="a">'
            "<inertial><mass>0</mass></inertial></link></model></sdf>",
            why="nothing in a static model moves",
            scaffold="",
        ),
    )

    def check(self, problem: problems.NonPositiveMass) -> Iterator[Diagnostic]:
        link = problem.link.attributes.get("name", "")
        if problem.is_zero:
            message = f"link `{link}` has no mass: 0 kg"
            affects = {
                Consumer.GAZEBO: warns("takes it as it is"),
                Consumer.MUJOCO: accepts("asks the mass of all that is fixed together"),
            }
            yield self.diagnostic(problem.value, message, severity=Severity.WARNING, affects=affects)
            return
        text = problem.value.text
        what = "negative" if problem.value.number < 0 else "not a number"
        yield self.diagnostic(
            problem.value,
            f"mass {text} is {what}",
            labels={problem.link: "the mass of this link"},
            affects={}
            if moves(problem.link)
            else {Consumer.MUJOCO: accepts("needs no mass where nothing moves")},
        )


def moves(link: Element) -> bool:
    """Does a joint of URDF lead to the link that is not fixed?"""
    robot, name = link.parent, link.attributes.get("name")
    joints = robot.children("joint") if robot is not None else ()
    ends = ((joint.attributes.get("type"), joint.find("child")) for joint in joints)
    return any(
        end is not None and end.attributes.get("link") == name and kind != "fixed" for kind, end in ends
    )
