from collections.abc import Iterator

from sdfcheck import (
    IN_LINK,
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Inertial,
    Link,
    Reaction,
    Rule,
    Severity,
    accepts,
    drops,
    refuses,
    warns,
)
from sdfcheck_rules.inr.moments import has_moments_only, in_drake, is_remarkable, once_merged

INERTIAL = (
    '<inertial><mass value="{0}"/><inertia ixx="{1}" ixy="0" ixz="0" iyy="{1}" iyz="0" izz="{1}"/></inertial>'
)
FIXED = (
    f'<robot name="r"><link name="a">{INERTIAL.format(1, 1)}</link><link name="b">{INERTIAL}</link>'
    '<joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint></robot>'
)


class NonPositiveMass(Rule):
    """A mass is negative, zero or not a number.

    libsdformat refuses a model with a negative or undefined mass (version 17 drops such a link of a
    URDF robot, with those below it); Drake takes a solid sphere of 1 kg in its place. A mass of 0
    leaves the link without inertia: physics engines drop it, or divide by it. In URDF a link without
    mass may be fixed to another one, but not have moments of inertia: Drake takes the sphere there, too.
    """

    code = "INR001"
    name = "non-positive-mass"
    severity = Severity.ERROR
    remedy = """Give the link the mass of the real part, in kg: more than 0.

    Weigh the part, look it up in the data sheet, or multiply its volume by the density (aluminum 2700
    kg/m³, steel 7850, ABS and PLA about 1050 to 1250, motors 3000 to 5000). A mere frame, such as that of a
    sensor, is in URDF a link without `<inertial>` that is fixed to one with mass, and in SDFormat a
    `<frame>` instead of a link. Mass and moments belong together: change one, and scale the other by the
    same factor.
    """
    looks_at = (Inertial,)
    scaffold = IN_LINK

    bad = (
        Bad("<inertial><mass>«-1»</mass></inertial>", says="mass -1 is negative"),
        Bad("<inertial><mass>«0»</mass></inertial>", says="no mass"),
        Bad(
            '<robot name="r"><link name="a"><inertial><mass value="«-2»"/>'
            '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link></robot>',
            scaffold="",
        ),
        Bad(
            '<sdf version="1.12"><model name="m"><static>true</static><link name="a">'
            "<inertial><mass>«-1»</mass></inertial></link></model></sdf>",
            scaffold="",
        ),
        Bad(
            '<sdf version="1.12"><world name="w"><model name="m"><link name="a">'
            "<inertial><mass>«-1»</mass></inertial></link></model></world></sdf>",
            scaffold="",
        ),
        Bad(FIXED.format("«0»", 1), scaffold="", says="link `b` has moments of inertia and a mass of 0"),
    )
    good = (
        Good(FIXED.format("0", 0), why="no body at all, fixed to one", scaffold=""),
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
        if mass.number == 0:
            if inertial.link.may_be_static:
                return False
            return not inertial.is_urdf or has_moments_only(inertial)
        # A text that is not a number is malformed.
        return mass.number < 0 or mass.text.lower() == "nan"

    def check(self, inertial: Inertial) -> Iterator[Diagnostic]:
        mass, link = inertial.mass, inertial.link
        affects = once_merged(inertial)
        if mass.number == 0:
            what = "moments of inertia and a mass of 0" if inertial.is_urdf else "no mass: 0 kg"
            affects.setdefault(Consumer.GAZEBO, REFUSES if inertial.is_urdf else warns("takes it as it is"))
            affects[Consumer.MUJOCO] = _in_mujoco(inertial)
            message = f"{link.title} has {what}"
            # PyBullet takes such a root for one that stands still.
            stands = inertial.is_urdf and not link.parent_joints and link.root.is_of_python
            severity = Severity.INFO if stands else Severity.WARNING
            yield self.diagnostic(mass, message, severity=severity, affects=affects)
            return
        if not _moves(link):
            affects[Consumer.MUJOCO] = _in_mujoco(inertial)
        affects |= _in_gazebo(link) if inertial.is_urdf else in_drake(inertial)
        what, cause = ("negative", None) if mass.number < 0 else ("not a number", mass.span)
        message, labels = f"mass {mass.text} is {what}", {link: "the mass of this link"}
        yield self.diagnostic(mass, message, labels=labels, affects=affects, cause=cause)


def _in_gazebo(link: Link) -> dict[Consumer, Reaction]:
    """The reaction of libsdformat to a link of URDF with a mass below 0, unless what is fixed to it outweighs that."""
    built = link.model.as_built_by(Consumer.GAZEBO)
    base = built.base(link)
    if base in built.with_mass:
        return {}
    if reason := built.refused_without(base):
        return {Consumer.GAZEBO: refuses(f"refuses the file, for {reason}")}
    return {Consumer.GAZEBO: drops("the link, and before version 17 refuses the file")}


def _in_mujoco(inertial: Inertial) -> Reaction:
    """What MuJoCo does where no joint moves the link."""
    if inertial.tensor.is_indefinite or inertial.tensor.is_impossible:
        return refuses("refuses the moments")
    return accepts("asks for the mass of all that is fixed together, and only where it moves")


def _moves(link: Link) -> bool:
    """Does a joint lead to the link that is not fixed?"""
    return any(
        joint.child_name == link.name and not joint.is_fixed and not joint.is_for_drake_only
        for joint in link.model.joints
    )
