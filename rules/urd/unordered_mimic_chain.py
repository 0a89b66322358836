from collections.abc import Iterator

from sdfcheck import IN_URDF_JOINT, Bad, Diagnostic, Good, Mimic, Rule, Severity

_LIMIT = '<limit lower="0" upper="1" effort="1" velocity="1"/>'
_CHAIN = (
    f'{_LIMIT}</joint><link name="b"/><link name="c"/><joint name="{{0}}" type="revolute"><parent link="base"/>'
    f'<child link="b"/>{_LIMIT}<mimic joint="j"/></joint><joint name="{{1}}" type="revolute">'
    f'<parent link="base"/><child link="c"/>{_LIMIT}<mimic joint="{{2}}"/>'
)


class UnorderedMimicChain(Rule):
    """A joint mimics one that mimics another, and comes before it by name.

    robot_state_publisher works out followers once, in the order of their names: a joint whose leader is a
    follower with a later name is never published. MoveIt and simulators follow chains in any order.
    """

    code = "URD023"
    name = "unordered-mimic-chain"
    severity = Severity.WARNING
    remedy = """Let it mimic the first leader directly.

    Multiply the multipliers of the chain; the offset is multiplier × offset of the middle joint + its own
    offset. Then nothing depends on the order of names.
    """
    default = False
    sources = ("https://github.com/ros/robot_state_publisher",)
    looks_at = (Mimic,)
    selects = ("urdf:joint/mimic",)
    scaffold = IN_URDF_JOINT

    bad = (
        Bad(
            _CHAIN.format("second", "first", "«second»"),
            says="joint `first` mimics `second`, which mimics `j` and comes later by name",
        ),
    )
    good = (Good(_CHAIN.format("first", "second", "first")),)

    @staticmethod
    def applies(mimic: Mimic) -> bool:
        is_late = mimic.next is not None and mimic.leader_name > mimic.joint.name
        return is_late and not mimic.leads_into_ring

    def check(self, mimic: Mimic) -> Iterator[Diagnostic]:
        following, name = mimic.next, mimic.leader_value
        assert following is not None
        assert name is not None
        message = f"{mimic.joint.title} mimics `{mimic.leader_name}`"
        message += f", which mimics `{following.leader_name}` and comes later by name"
        yield self.diagnostic(name, message)
