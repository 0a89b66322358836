from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Severity, VendorRule, VendorValue
from sdfcheck_rules.drk.scaffolds import JOINT, MODEL, ROBOT

NESTED = MODEL.replace("{}", '<model name="n"><link name="c"/></model>{}')


class UnknownDrakeReference(VendorRule):
    """One of Drake's elements names a link, frame, joint or group that is not there.

    Names are those of the model that the element is in. In SDF the members of groups, the groups and the
    frames may be reached in nested models (`arm::hand`), the bodies and joints of constraints may not, and
    in URDF there are no scoped names. The world is not a link of a model.
    """

    code = "DRK007"
    name = "unknown-drake-reference"
    severity = Severity.ERROR
    remedy = """Name a link, frame, joint or group of the model that the element is in.

    In SDF, members of groups and frames can be `arm::hand`; bodies and joints of constraints cannot: move
    the constraint into the model that holds both. Nothing can be tied to the world by name: tie it to a
    link that is welded to it.
    """
    prefix = "drake"
    looks_at = (VendorValue,)
    scaffold = MODEL

    bad = (
        Bad(
            '<drake:collision_filter_group name="g"><drake:member>«A»</drake:member>'
            "</drake:collision_filter_group>",
            fixed='<drake:collision_filter_group name="g"><drake:member>a</drake:member>'
            "</drake:collision_filter_group>",
            unsafe=True,
            says="there is no link `A`: Drake refuses the file; did you mean `a`?",
        ),
        Bad(
            '<drake:collision_filter_group name="g"><drake:member>a</drake:member>'
            "<drake:ignored_collision_filter_group>«hand»</drake:ignored_collision_filter_group>"
            "</drake:collision_filter_group>",
            says="there is no drake:collision_filter_group `hand`",
        ),
        Bad(
            '<drake:mimic joint="«k»" multiplier="1" offset="0"/>',
            says="there is no joint `k`",
            scaffold=JOINT,
        ),
        Bad(
            '<drake:joint name="p" type="planar"><drake:parent>«world»</drake:parent>'
            "<drake:child>b</drake:child>"
            "<drake:damping>0 0 0</drake:damping></drake:joint>",
            says="there is no frame or link `world`",
        ),
        Bad(
            '<drake:collision_filter_group name="g"><drake:member link="«j»"/>'
            "</drake:collision_filter_group>",
            says="`j` is a joint, and `drake:member` names a link",
            scaffold=ROBOT,
        ),
        Bad(
            "<drake:ball_constraint><drake:ball_constraint_body_A>a</drake:ball_constraint_body_A>"
            "<drake:ball_constraint_body_B>«n::c»</drake:ball_constraint_body_B>"
            "<drake:ball_constraint_p_AP>0 0 0</drake:ball_constraint_p_AP>"
            "<drake:ball_constraint_p_BQ>0 0 0</drake:ball_constraint_p_BQ></drake:ball_constraint>",
            says="names a link of its own model, and `n::c` is a scoped name",
            scaffold=NESTED,
        ),
    )
    good = (
        Good(
            '<drake:collision_filter_group name="g"><drake:member>n::c</drake:member>'
            "</drake:collision_filter_group>",
            scaffold=NESTED,
        ),
        Good(
            '<include><uri>model://arm</uri></include><drake:collision_filter_group name="g">'
            "<drake:member>arm::hand</drake:member></drake:collision_filter_group>",
            why="nobody knows what is in a file that is not there",
        ),
        Good(
            '<drake:collision_filter_group name="g" ignore="true"><drake:member>gone</drake:member>'
            "</drake:collision_filter_group>",
            why="Drake skips a group that is to be ignored",
        ),
        Good(
            '<drake:joint name="p" type="planar"><drake:parent>__model__</drake:parent>'
            "<drake:child>b</drake:child>"
            "<drake:damping>0 0 0</drake:damping></drake:joint>",
            why="every model has a frame of this name",
        ),
    )

    @staticmethod
    def applies(name: VendorValue) -> bool:
        return name.prefix == "drake" and name.unresolved is not None

    def check(self, name: VendorValue) -> Iterator[Diagnostic]:
        yield from self.unresolved(name)
