from collections.abc import Iterator

from sdfcheck import IN_ROBOT, REFUSES, Bad, Consumer, Diagnostic, Good, Model, Rule, Severity, accepts

END = r"<(?:parent|child)\s+link\s*=\s*[\"']([^\"']*)[\"']"
"""A joint of the link in a branch of xacro that the arguments do not take."""


class DisconnectedLink(Rule):
    """No joint leads to a link, or on from it, in a robot of several links.

    Such a link is a second root. urdfdom, and with it nearly every program of ROS and the
    conversion to SDFormat, refuses the file; Drake makes a free body of it.
    """

    code = "URD004"
    name = "disconnected-link"
    severity = Severity.ERROR
    remedy = """Add a joint that has this link as its child, or remove the link.

    If another joint names a link that does not exist, the name is likely misspelled on one of the two
    sides. A root that is left over from an edit can be removed.
    """
    looks_at = (Model,)
    selects = ("urdf:robot",)
    scaffold = IN_ROBOT

    bad = (
        Bad('<«link» name="hook"/>', says="no joint ties link `hook` to the rest of the robot"),
        Bad(
            '<link name="a"/><joint name="j" type="fixed"><parent link="base"/><child link="a"/></joint>'
            '<«link» name="b"/>'
        ),
        Bad(
            '<link name="«lower_lge»"/><link name="foot"/>'
            '<joint name="j" type="fixed"><parent link="base"/><child link="lower_leg"/></joint>'
            '<joint name="k" type="fixed"><parent link="lower_leg"/><child link="foot"/></joint>',
            says="and 2 name `lower_leg`, which does not exist",
        ),
    )
    good = (
        Good("", why="one link alone is a robot"),
        Good(
            '<link name="gripper"/>'
            '<joint name="j" type="fixed"><parent link="base"/><child link="griper"/></joint>',
            why="the joint is at fault",
        ),
    )

    @staticmethod
    def applies(robot: Model) -> bool:
        return bool(robot.link_names.misspelled) or any(len(group) == 1 for group in robot.tree.loose_groups)

    def check(self, robot: Model) -> Iterator[Diagnostic]:
        names, tree = robot.link_names, robot.tree
        for meant, link in names.misspelled.items():
            ends = names.unknown[meant]
            message = (
                f"no joint names link `{link.name}`, and {len(ends)} name `{meant}`, which does not exist"
            )
            yield self.diagnostic(
                link.name_value or link,
                message,
                labels={ends[0]: "the first of them"},
                affects=dict.fromkeys(Consumer, REFUSES),
            )
        tied = set(_tied_for_drake(robot))
        is_for_mujoco = robot.find("mujoco") is not None
        for group in tree.loose_groups:
            if len(group) == 1:
                link = group[0]
                message = f"no joint ties {link.title} to the rest of the robot"
                may_be = robot.document.may_name(END, link.name)
                if may_be:
                    message += ", unless an argument brings one"
                known = {Consumer.DRAKE: accepts("knows the joint")} if link.name in tied else {}
                labels = {tree.top(tree.groups[0]): "the root of the rest"}
                # MuJoCo, which the robot has settings for, fixes it to the world.
                severity = Severity.WARNING if may_be or is_for_mujoco else None
                cause = robot.misnamed("joint")
                yield self.diagnostic(
                    link, message, labels=labels, affects=known, severity=severity, cause=cause
                )


def _tied_for_drake(robot: Model) -> Iterator[str]:
    """The links at the ends of joints that Drake alone knows."""
    for joint in robot.children("drake:joint"):
        ends = (joint.find("parent"), joint.find("child"))
        yield from (end.attributes.get("link", "") for end in ends if end is not None)
