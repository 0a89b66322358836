from collections.abc import Iterator

from sdfcheck import REFUSES, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, used, warns

SHAPE = '<geometry><sphere radius="1"/></geometry>'
LINK = f'<robot name="r">{{}}<link name="a"><visual>{SHAPE}<material name="grey"/></visual></link></robot>'


class UndefinedMaterial(Rule):
    """A visual names a material that is not defined.

    Materials are defined in the robot, or in the first visual that gives their colour;
    a definition in a later link comes too late. urdfdom leaves the visual without
    material, Drake refuses the file. A material that is defined twice with different
    looks gets a warning: most readers take the first for both, Drake refuses that, too.
    """

    code = "URD006"
    name = "undefined-material"
    severity = Severity.ERROR
    affects = {
        Consumer.GAZEBO: warns("leaves out the material"),
        Consumer.DRAKE: REFUSES,
        Consumer.URDFDOM: warns("leaves out the material"),
    }
    explains = (problems.UndefinedMaterial, problems.EmptyMaterial, problems.DifferentMaterial)
    scaffold = LINK

    bad = (
        Bad(
            '<robot name="r"><material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>'
            f'<link name="a"><visual>{SHAPE}<material name="«gray»"/></visual></link></robot>',
            scaffold="",
            says="material `gray` is not defined; did you mean `grey`?",
        ),
        Bad(
            f'<robot name="r"><link name="a"><visual>{SHAPE}<material name="«red»"/></visual>'
            f'<visual>{SHAPE}<material name="red"/></visual></link></robot>',
            scaffold="",
            says="material `red` is not defined (used 2 times)",
        ),
        Bad(
            f'<robot name="r"><link name="a"><visual>{SHAPE}<material name="«red»"/></visual>'
            f'<visual>{SHAPE}<material name="red"><color rgba="1 0 0 1"/></material></visual></link></robot>',
            scaffold="",
            says="material `red` is not defined yet",
        ),
        Bad(
            '<robot name="r"><link name="a">'
            f'<visual>{SHAPE}<material name="red"><color rgba="1 0 0 1"/></material></visual>'
            f'<visual>{SHAPE}<material name="«red»"><color rgba="0.9 0 0 1"/></material></visual>'
            "</link></robot>",
            scaffold="",
            says="material `red` was defined otherwise before",
        ),
        Bad('<«material» name="grey"/>', says="material `grey` has neither colour nor texture"),
    )
    good = (
        Good('<material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>'),
        Good('<material name="grey"><texture filename="package://p/grey.png"/></material>'),
    )

    def check(
        self, problem: problems.UndefinedMaterial | problems.EmptyMaterial | problems.DifferentMaterial
    ) -> Iterator[Diagnostic]:
        if isinstance(problem, problems.EmptyMaterial):
            yield self.diagnostic(
                problem.material, f"{problem.material.title} has neither colour nor texture"
            )
            return
        value = problem.value
        name = value.text
        if isinstance(problem, problems.DifferentMaterial):
            yield self.diagnostic(
                value,
                f"material `{name}` was defined otherwise before",
                labels={problem.first: "what most readers take"},
                severity=Severity.WARNING,
                affects={
                    reader: warns("takes one of the two") for reader in (Consumer.GAZEBO, Consumer.URDFDOM)
                },
            )
            return
        if problem.later is not None:
            message = f"material `{name}` is not defined yet{used(problem.uses)}"
            yield self.diagnostic(value, message, labels={problem.later: "defined here"})
        else:
            guess = f"; did you mean `{problem.suggestion}`?" if problem.suggestion else ""
            yield self.diagnostic(value, f"material `{name}` is not defined{used(problem.uses)}{guess}")
