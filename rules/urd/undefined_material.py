from collections.abc import Iterator

from sdfcheck import (
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Material,
    Model,
    Rule,
    Severity,
    used,
    warns,
    write_instead,
)

SHAPE = '<geometry><sphere radius="1"/></geometry>'
LINK = f'<robot name="r">{{}}<link name="a"><visual>{SHAPE}<material name="grey"/></visual></link></robot>'


class UndefinedMaterial(Rule):
    """A visual names a material that is not defined.

    Materials are defined in the robot, or in the first visual that gives their color;
    a definition in a later link comes too late. urdfdom leaves the visual without
    material, Drake refuses the file. A material that is defined twice with different
    looks gets a warning: most consumers take the first for both, Drake refuses that, too.
    """

    code = "URD006"
    name = "undefined-material"
    severity = Severity.ERROR
    remedy = """Define the material once, with a color, directly in the robot and before the first link.

    `<material name="red"><color rgba="0.8 0 0 1"/></material>`: red, green, blue and opacity from 0 to 1.
    Visuals then name it alone, `<material name="red"/>`. Two looks need two names.
    """
    looks_at = (Model,)
    selects = ("urdf:robot",)
    scaffold = LINK

    bad = (
        Bad(
            '<robot name="r"><material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>'
            f'<link name="a"><visual>{SHAPE}<material name="«gray»"/></visual></link></robot>',
            fixed='<robot name="r"><material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>'
            f'<link name="a"><visual>{SHAPE}<material name="grey"/></visual></link></robot>',
            unsafe=True,
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
        Bad('<«material» name="grey"/>', says="material `grey` has neither color nor texture"),
    )
    good = (
        Good('<material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>'),
        Good('<material name="grey"><texture filename="package://p/grey.png"/></material>'),
    )

    @staticmethod
    def applies(robot: Model) -> bool:
        names = robot.material_names
        return bool(names.undefined or names.redefined) or any(map(is_empty, robot.materials))

    def check(self, robot: Model) -> Iterator[Diagnostic]:
        for material in filter(is_empty, robot.materials):
            yield self.diagnostic(material, f"{material.title} has neither color nor texture")
        for material, first in robot.material_names.redefined:
            yield self.redefined(material, first)
        for name, uses in robot.material_names.undefined.items():
            yield self.undefined(robot, name, uses)

    def redefined(self, material: Material, first: Material) -> Diagnostic:
        return self.diagnostic(
            material.name_value or material,
            f"material `{material.get('name')}` was defined otherwise before",
            labels={first.name_value or first: "what most consumers take"},
            severity=Severity.WARNING,
            affects={
                consumer: warns("takes one of the two") for consumer in (Consumer.GAZEBO, Consumer.URDFDOM)
            },
        )

    def undefined(self, robot: Model, name: str, uses: list[Material]) -> Diagnostic:
        defined = robot.material_names.defined
        place = uses[0].name_value or uses[0]
        if name in defined:
            message = f"material `{name}` is not defined yet{used(len(uses))}"
            later = defined[name]
            return self.diagnostic(place, message, labels={later.name_value or later: "defined here"})
        near = robot.nearest(name, defined)
        fix = write_instead(near, *(use.name_value or use for use in uses))
        message = f"material `{name}` is not defined{used(len(uses))}"
        beside = robot.materials[:1] if near is None else ()
        return self.diagnostic(
            place,
            message,
            meant=near,
            fix=fix,
            labels={each.name_value or each: "the robot defines its materials here" for each in beside},
            cause=robot.misnamed("material"),
        )


def is_empty(material: Material) -> bool:
    is_bare = not material.has_look and material.lacks("color") and material.lacks("texture")
    return is_bare and not material.has_foreign_colors
