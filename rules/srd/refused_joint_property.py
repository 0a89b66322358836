from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Semantics, Severity, listed, suggest
from sdfcheck_rules.srd.scaffold import FILE, IN_SRDF

BASE = '<virtual_joint name="drive" type="{}" parent_frame="odom" child_link="base"/>'
PROPERTY = '<joint_property joint_name="{}" property_name="{}" value="{}"/>'


class RefusedJointProperty(Rule):
    """A property of a joint is one that MoveIt does not know, that such a joint does not have, or of a wrong value.

    MoveIt logs an error and plans without it: a base with wheels, for example, is moved sideways.
    """

    code = "SRD016"
    name = "refused-joint-property"
    severity = Severity.WARNING
    remedy = """Write a property that the joint has, with a value of its kind.

    Planar joints have `motion_model`, which is `holonomic` or `diff_drive`, and `min_translational_distance`; planar
    and floating ones `angular_distance_weight`. The last two are numbers.
    """
    looks_at = (Semantics,)
    scaffold = IN_SRDF

    bad = (
        Bad(
            BASE.format("planar") + PROPERTY.format("drive", "«motion_modle»", "diff_drive"),
            fixed=BASE.format("planar") + PROPERTY.format("drive", "motion_model", "diff_drive"),
            unsafe=True,
            file=FILE,
            says="joints have no property `motion_modle` in MoveIt",
        ),
        Bad(
            BASE.format("fixed") + PROPERTY.format("«drive»", "motion_model", "diff_drive"),
            file=FILE,
            says="joint `drive` is not planar, and MoveIt ignores its `motion_model`",
        ),
        Bad(
            BASE.format("planar") + PROPERTY.format("drive", "motion_model", "«differential»"),
            file=FILE,
            says="`motion_model` should be holonomic or diff_drive, not `differential`",
        ),
        Bad(
            BASE.format("floating") + PROPERTY.format("drive", "angular_distance_weight", "«heavy»"),
            file=FILE,
            says="`angular_distance_weight` should be a number, not `heavy`",
        ),
    )
    good = (
        Good(BASE.format("planar") + PROPERTY.format("drive", "motion_model", "diff_drive"), file=FILE),
        Good(BASE.format("floating") + PROPERTY.format("drive", "angular_distance_weight", "0.5"), file=FILE),
    )

    @staticmethod
    def applies(semantics: Semantics) -> bool:
        return any(True for _ in semantics.refused_properties)

    def check(self, semantics: Semantics) -> Iterator[Diagnostic]:
        for value, choices in semantics.refused_properties:
            text = value.text.strip()
            name = value.element.attributes["property_name"].strip()
            if value.attribute == "property_name":
                near = suggest(text, choices)
                yield self.diagnostic(value, f"joints have no property `{text}` in MoveIt", meant=near)
            elif value.attribute == "joint_name":
                kinds = listed(choices, "or")
                yield self.diagnostic(
                    value, f"joint `{text}` is not {kinds}, and MoveIt ignores its `{name}`"
                )
            else:
                yield self.diagnostic(value, f"`{name}` should be {listed(choices, 'or')}, not `{text}`")
