from collections.abc import Iterator

from sdfcheck import IN_MODEL, Bad, Diagnostic, Fix, Good, Joint, Plugin, Root, Rule, Severity, replace

JOINT = (
    '<link name="b"/><joint name="j" type="{}"><parent>base</parent><child>b</child>'
    "<axis><xyz>0 0 1</xyz>{}</axis>{}</joint>"
)
SECOND = "<axis2><xyz>1 0 0</xyz></axis2>"
LACKING = ("continuous", "revolute2", "gearbox")
DRIVE = (
    '<plugin filename="gz-sim-joint-controller-system" name="gz::sim::systems::JointController">'
    "<joint_name>j</joint_name></plugin>"
)


class JointMadeFixed(Rule):
    """The physics of Gazebo does not have the type of a joint, and makes a fixed one.

    SDFormat has the type `continuous`, and libsdformat reads it; but the new Gazebo logs an error and makes a fixed
    joint, so that a wheel does not turn, and Gazebo Classic leaves the joint out. So it is with `revolute2` and
    `gearbox`, which Gazebo Classic has, in the new Gazebo.
    """

    code = "GAZ039"
    name = "joint-made-fixed"
    severity = Severity.WARNING
    remedy = """Write a `revolute` joint: without limits it turns for ever.

    Instead of `revolute2`, two of them in a row, with a small link that has mass between them; instead of `gearbox`, a
    `mimic` of the other joint.
    """
    looks_at = (Root,)
    needs = LACKING
    scaffold = IN_MODEL
    sources = ("https://github.com/gazebosim/gz-physics/blob/main/dartsim/src/SDFFeatures.cc",)

    bad = (
        Bad(
            JOINT.format("«continuous»", "", ""),
            fixed=JOINT.format("revolute", "", ""),
            unsafe=True,
            says="joint `j` is fixed in Gazebo, which has no type `continuous`",
        ),
        Bad(JOINT.format("«continuous»", "<limit><upper>1</upper></limit>", ""), also=("JNT011",)),
        Bad(
            JOINT.format("«revolute2»", "", SECOND) + DRIVE,
            also=("DRK008",),
        ),
    )
    good = (
        Good(JOINT.format("revolute", "", "")),
        Good(JOINT.format("revolute2", "", SECOND), why="nothing says that it is for the new Gazebo"),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return not root.is_urdf and any(True for _ in made_fixed(root))

    def check(self, root: Root) -> Iterator[Diagnostic]:
        for joint in made_fixed(root):
            message = f"{joint.title} is fixed in Gazebo, which has no type `{joint.type}`"
            yield self.diagnostic(joint.type_value or joint, message, fix=without_limits(joint))


def made_fixed(root: Root) -> Iterator[Joint]:
    """The joints of a type that no Gazebo has which the file may be for."""
    joints = [joint for joint in root.each(Joint) if joint.type in LACKING]
    is_for_new = bool(joints) and any(plugin.generation == "gz" for plugin in root.each(Plugin))
    return (joint for joint in joints if is_for_new or joint.type == "continuous")


def without_limits(joint: Joint) -> Fix | None:
    """The fix that makes it `revolute`, where Drake builds the same joint of that; it has limits in ROS."""
    if joint.type != "continuous" or joint.type_value is None or joint.axis.limit.is_given:
        return None
    return replace(joint.type_value, "revolute", "write `revolute`", unsafe=True)
