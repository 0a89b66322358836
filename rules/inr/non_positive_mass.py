from collections.abc import Iterator

from sdfcheck import (
    IN_LINK,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Inertial,
    Link,
    Rule,
    Severity,
    accepts,
    refuses,
    warns,
)
from sdfcheck_rules.inr.moments import is_remarkable


class NonPositiveMass(Rule):
    """A mass is negative, zero or not a number.

    libsdformat refuses a model with a negative or undefined mass; Drake aborts. A zero
    mass is accepted and leaves the link without inertia: physics engines drop it, or
    divide by it.
    """

    code = "INR001"
    name = "non-positive-mass"
    severity = Severity.ERROR
    looks_at = (Inertial,)
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

    @staticmethod
    def applies(inertial: Inertial) -> bool:
        if not is_remarkable(inertial):
            return False
        mass = inertial.mass
        # No mass in URDF: it depends on the joint. What is not a number at all is malformed.
        return mass.number < 0 or (mass.number == 0 and not inertial.is_urdf) or mass.text.lower() == "nan"

    def check(self, inertial: Inertial) -> Iterator[Diagnostic]:
        mass, link = inertial.mass, inertial.link
        if mass.number == 0:
            affects = {
                Consumer.GAZEBO: warns("takes it as it is"),
                Consumer.MUJOCO: accepts("asks the mass of all that is fixed together"),
            }
            message = f"link `{link.name}` has no mass: 0 kg"
            yield self.diagnostic(mass, message, severity=Severity.WARNING, affects=affects)
            return
        what = "negative" if mass.number < 0 else "not a number"
        yield self.diagnostic(
            mass,
            f"mass {mass.text} is {what}",
            labels={link: "the mass of this link"},
            affects={} if _moves(link) else {Consumer.MUJOCO: accepts("needs no mass where nothing moves")},
        )


def _moves(link: Link) -> bool:
    """Does a joint lead to the link that is not fixed?"""
    return any(
        joint.child_name == link.name and not joint.is_fixed and not joint.is_for_drake_only
        for joint in link.model.joints
    )
