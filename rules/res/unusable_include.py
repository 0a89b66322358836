from collections.abc import Iterator

from sdfcheck import IN_WORLD, REFUSES, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems
from sdfcheck.problems import Obstacle

ARM = {"arm.sdf": '<sdf version="1.12"><model name="arm"><link name="l"/></model></sdf>'}


class UnusableInclude(Rule):
    """An include leads to a file that holds nothing to include, or cannot be carried out.

    The file has to be SDFormat with a model, actor or light at its top, or a URDF. A
    world cannot be included, and a xacro file has to be expanded first. libsdformat
    refuses the including document; an empty `<name>`, `<static>` or `<placement_frame>`
    ends its process.
    """

    code = "RES012"
    name = "unusable-include"
    severity = Severity.ERROR
    affects = {Consumer.GAZEBO: REFUSES, Consumer.DRAKE: REFUSES}
    explains = (problems.UnusableInclude, problems.EmptyIncludeSetting)
    scaffold = IN_WORLD

    bad = (
        Bad(
            "<include><uri>«yard.sdf»</uri></include>",
            files={"yard.sdf": '<sdf version="1.12"><world name="yard"/></sdf>'},
            says="a world cannot be included",
        ),
        Bad(
            "<include><uri>«none.sdf»</uri></include>",
            files={"none.sdf": '<sdf version="1.12"/>'},
            says="holds no model, actor or light",
        ),
        Bad(
            "<include><uri>«arm.dae»</uri></include>",
            files={"arm.dae": "<COLLADA/>"},
            says="its root element is `COLLADA`",
        ),
        Bad(
            "<include><uri>«arm.urdf»</uri></include>",
            files={"arm.urdf": '<robot name="r"><xacro:leg/></robot>'},
            says="has to be expanded",
        ),
        Bad(
            "<include><uri>arm.sdf</uri><«name»/></include>",
            files=ARM,
            says="`name` of this include is empty",
        ),
    )
    good = (
        Good("<include><uri>arm.sdf</uri><name>left</name></include>", files=ARM),
        Good(
            "<include><uri>arm.urdf</uri></include>",
            files={"arm.urdf": '<robot name="r"><link name="l"/></robot>'},
        ),
    )

    def check(self, problem: problems.UnusableInclude | problems.EmptyIncludeSetting) -> Iterator[Diagnostic]:
        if isinstance(problem, problems.EmptyIncludeSetting):
            yield self.diagnostic(problem.element, f"`{problem.element.name}` of this include is empty")
            return
        name = f"`{problem.file.name}`"
        if problem.obstacle is Obstacle.UNREADABLE:
            message = f"{name} cannot be read"
        elif problem.obstacle is Obstacle.XACRO:
            message = f"{name} is xacro, which has to be expanded before it can be included"
        elif problem.obstacle is Obstacle.FOREIGN:
            message = f"{name} is neither SDFormat nor URDF: its root element is `{problem.root}`"
        elif problem.holds_world:
            message = f"{name} holds no model but a world, and a world cannot be included"
        else:
            message = f"{name} holds no model, actor or light"
        yield self.diagnostic(problem.uri, message)
