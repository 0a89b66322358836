from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Element, Good, Rule, Semantics, Severity, rename, used, write_instead
from sdfcheck_rules.srd.scaffold import FILE, IN_SRDF

PAIR = '<disable_collision{} link1="base" link2="{}"/>'


class MisspelledSemanticElement(Rule):
    """An element or attribute of SRDF has nearly the name of one that MoveIt reads.

    MoveIt ignores names that it does not know, and says nothing. Pairs whose collisions were to be left out are then
    checked: links beside each other collide in each state, and no plan is found.
    """

    code = "SRD014"
    name = "misspelled-semantic-element"
    severity = Severity.ERROR
    remedy = """Write the name as MoveIt reads it.

    It reads `group`, `group_state`, `end_effector`, `virtual_joint`, `passive_joint`, `joint_property`,
    `disable_collisions`, `enable_collisions`, `disable_default_collisions` and `link_sphere_approximation`.
    """
    looks_at = (Semantics,)
    scaffold = IN_SRDF

    bad = (
        Bad(
            PAIR.format("", "upper").replace("<d", "<«d").replace("n l", "n» l") + PAIR.format("", "hand"),
            fixed=PAIR.format("s", "upper") + PAIR.format("s", "hand"),
            unsafe=True,
            file=FILE,
            says="element `disable_collision` in MoveIt (used 2 times); did you mean `disable_collisions`?",
        ),
        Bad(
            '<«groupstate» name="home" group="all"><joint name="shoulder" value="0"/></groupstate>',
            fixed='<group_state name="home" group="all"><joint name="shoulder" value="0"/></group_state>',
            unsafe=True,
            file=FILE,
            says="did you mean `group_state`?",
        ),
        Bad(
            '<disable_collisions link1="base" «linkk2»="upper"/>',
            fixed='<disable_collisions link1="base" link2="upper"/>',
            unsafe=True,
            file=FILE,
            says="there is no attribute `linkk2` in `disable_collisions` of MoveIt; did you mean `link2`?",
        ),
    )
    good = (
        Good(PAIR.format("s", "upper"), file=FILE),
        Good(
            '<rotor_params><joint name="shoulder" mass="1"/></rotor_params>', file=FILE, why="Pinocchio's own"
        ),
    )

    @staticmethod
    def applies(semantics: Semantics) -> bool:
        return bool(semantics.misspelled or semantics.misspelled_attributes)

    def check(self, semantics: Semantics) -> Iterator[Diagnostic]:
        by_name: dict[tuple[str, str], list[Element]] = {}
        for element, near in semantics.misspelled:
            by_name.setdefault((element.name, near), []).append(element)
        for (name, near), uses in by_name.items():
            message = f"there is no element `{name}` in MoveIt{used(len(uses))}"
            yield self.diagnostic(uses[0], message, meant=near, fix=rename(near, *uses))
        for (element, near), (value, is_needed) in semantics.misspelled_attributes.items():
            message = f"there is no attribute `{value.attribute}` in `{element.name}` of MoveIt"
            fix, severity = write_instead(near, value.name_span), None if is_needed else Severity.WARNING
            yield self.diagnostic(value.name_span, message, meant=near, fix=fix, severity=severity)
