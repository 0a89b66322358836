from collections.abc import Iterator

from sdfcheck import IN_JOINT, IN_URDF_JOINT, Bad, Diagnostic, Good, Mimic, Rule, Severity

_LIMIT = '<limit lower="-1" upper="1" effort="5" velocity="2"/>'


class UnknownMimicLeader(Rule):
    """A joint mimics a joint, or an axis of one, that does not exist.

    libsdformat refuses it in SDFormat, except in nested models. urdfdom accepts the
    file, and MoveIt and joint_state_publisher fail over it later.
    """

    code = "JNT009"
    name = "unknown-mimic-leader"
    severity = Severity.ERROR
    remedy = """Name a joint of the same model, and an axis that it has.

    The leader is a joint that moves, not a link. In SDFormat the axis is `axis`, or `axis2` for joints that
    have two. If the leader gets a prefix by a macro, the name here needs the same prefix.
    """
    looks_at = (Mimic,)
    scaffold = IN_JOINT

    bad = (
        Bad(
            '<axis><xyz>0 0 1</xyz><mimic joint="«elbow»"><multiplier>1</multiplier></mimic></axis>',
            says="joint `j` mimics `elbow`, which is not a joint of its model",
        ),
        Bad(
            '<axis><xyz>0 0 1</xyz><mimic joint="k" axis="«axis2»"><multiplier>1</multiplier></mimic></axis>'
            '</joint><link name="hand"/><joint name="k" type="revolute">'
            "<parent>arm</parent><child>hand</child><axis><xyz>0 0 1</xyz></axis>",
            says="joint `j` mimics `axis2` of a joint that has no such axis",
        ),
        Bad(
            f'<mimic joint="«elbow»"/>{_LIMIT}',
            scaffold=IN_URDF_JOINT,
            says="which is not a joint of its model",
        ),
        Bad(
            f'{_LIMIT}</joint><link name="hand"/><joint name="wrist" type="revolute"><parent link="arm"/>'
            f'<child link="hand"/>{_LIMIT}<mimic joint="«J»"/>',
            fixed=f'{_LIMIT}</joint><link name="hand"/><joint name="wrist" type="revolute">'
            f'<parent link="arm"/><child link="hand"/>{_LIMIT}<mimic joint="j"/>',
            unsafe=True,
            scaffold=IN_URDF_JOINT,
            says="`j` differs in case only",
        ),
    )
    good = (
        Good(
            '<axis><xyz>0 0 1</xyz><mimic joint="k"><multiplier>1</multiplier></mimic></axis></joint>'
            '<link name="hand"/><joint name="k" type="revolute"><parent>arm</parent><child>hand</child>'
            "<axis><xyz>0 0 1</xyz></axis>"
        ),
    )

    @staticmethod
    def applies(mimic: Mimic) -> bool:
        value, joint = mimic.leader_value, mimic.joint
        if value is None or mimic is not mimic.axis.mimic:
            return False
        if mimic.leader is not None:
            return mimic.is_without_axis
        if mimic.is_urdf:
            return not joint.is_fixed
        name, scope = mimic.leader_name, joint.scope
        return scope.resolve(name) is not None or not ("" in name.split("::") or scope.may_hold(name))

    def check(self, mimic: Mimic) -> Iterator[Diagnostic]:
        value, joint = mimic.leader_value, mimic.joint
        assert value is not None
        if mimic.leader is not None:
            message = f"{joint.title} mimics `{mimic.leader_axis}` of a joint that has no such axis"
            yield self.diagnostic(mimic.attribute("axis") or value, message)
            return
        message = f"{joint.title} mimics `{mimic.leader_name}`, which is not a joint of its model"
        cause = joint.scope.fault_of(mimic.leader_name)
        yield self.diagnostic(value, message, meant=mimic.leader_guess, cause=cause)
