from collections.abc import Iterator

from sdfcheck import Bad, Consumer, Diagnostic, Good, Rule, Severity, named, problems, warns

BOX = '<geometry><box size="1 1 1"/></geometry>'
ROBOT = f'<robot name="r"><link name="base"><collision name="hull">{BOX}</collision></link>{{}}</robot>'


class ExtensionLostByName(Rule):
    """Settings for a link in a `gazebo` block do not reach a shape that has a name.

    libsdformat hands friction, contact and laser settings on to the collisions of the link,
    and materials to its visuals, by comparing names. A collision or visual with a name of its own
    is passed over without a word, unless the name begins with that of the link.
    """

    code = "GAZ004"
    name = "extension-lost-by-name"
    severity = Severity.WARNING
    affects = {Consumer.GAZEBO: warns("drops the settings")}
    explains = (problems.ExtensionLostByName,)
    scaffold = ROBOT

    bad = (
        Bad(
            '<gazebo reference="base"><«mu1»>0.2</mu1><mu2>0.2</mu2></gazebo>',
            says="`mu1` and `mu2` do not reach collision `hull` of link `base`, because it has a name",
        ),
        Bad(
            '<gazebo reference="base"><«material»>Gazebo/Red</material></gazebo>',
            says="visual `shell`",
            scaffold=ROBOT.replace(
                "</link>", f'<visual name="shell">{BOX}<material name="red"/></visual></link>'
            ).replace("{}", '<material name="red"><color rgba="1 0 0 1"/></material>{}'),
        ),
    )
    good = (
        Good('<gazebo reference="base"><selfCollide>true</selfCollide></gazebo>', why="for the link itself"),
        Good(
            '<gazebo reference="base"><mu1>0.2</mu1></gazebo>',
            why="the name begins with the link's",
            scaffold=ROBOT.replace("hull", "base_hull"),
        ),
        Good(
            '<gazebo reference="base"><mu1>0.2</mu1></gazebo>',
            scaffold=ROBOT.replace(' name="hull"', ""),
        ),
    )

    def check(self, problem: problems.ExtensionLostByName) -> Iterator[Diagnostic]:
        first, shape = problem.settings[0], problem.name.element
        names = dict.fromkeys(setting.name for setting in problem.settings)
        verb = "do" if len(names) > 1 else "does"
        others = f" and {problem.count - 1} more" if problem.count > 1 else ""
        yield self.diagnostic(
            first,
            f"{named(names)} {verb} not reach {shape.title}{others} of link `{problem.link}`, because it has a name",
            labels={problem.name: "this name"},
            help=f"remove the name, or let it begin with `{problem.link}`",
        )
