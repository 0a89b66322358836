from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Link, Plugin, Rule, Severity, Value

WHEEL = (
    '<link name="{0}"><collision name="c"><geometry><sphere><radius>0.1</radius></sphere></geometry>'
    "<surface><friction><ode><mu>{1}</mu><mu2>{2}</mu2></ode></friction></surface></collision></link>"
    '<joint name="{0}_joint" type="revolute"><parent>base</parent><child>{0}</child><axis><xyz>0 1 0</xyz></axis>'
    "</joint>"
)
DRIVE = (
    '<plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive">'
    "<left_joint>left_joint</left_joint><right_joint>right_joint</right_joint></plugin>"
)
IN_SDF = f'<sdf version="1.9"><model name="m"><link name="base"/>{{}}{DRIVE}</model></sdf>'
IN_URDF = (
    '<robot name="r"><link name="base"/>'
    + "".join(
        f'<link name="{side}"><collision><geometry><sphere radius="0.1"/></geometry></collision></link>'
        f'<joint name="{side}_joint" type="continuous"><parent link="base"/><child link="{side}"/></joint>'
        for side in ("left", "right")
    )
    + f"{{}}<gazebo>{DRIVE}</gazebo></robot>"
)


class SlipperyWheel(Rule):
    """A wheel that a drive turns has no friction.

    It spins, and the robot stays where it is. Casters and planar drives have no friction on purpose; a driven wheel
    holds the ground with a coefficient near 1.
    """

    code = "GAZ018"
    name = "slippery-wheel"
    severity = Severity.WARNING
    remedy = """Give the wheel friction: 1 is rubber on a floor.

    In SDFormat it is `<surface><friction><ode><mu>1</mu><mu2>1</mu2>` in the collision, in URDF `<mu1>` and
    `<mu2>` in a `<gazebo>` block about the link.
    """
    looks_at = (Plugin,)

    bad = (
        Bad(
            WHEEL.format("left", "«0»", "0") + WHEEL.format("right", "1", "1"),
            scaffold=IN_SDF,
            says="link `left` has no friction, and drive `gz::sim::systems::DiffDrive` turns it",
        ),
        Bad('<gazebo reference="left"><mu1>«0.0»</mu1><mu2>0.0</mu2></gazebo>', scaffold=IN_URDF),
    )
    good = (
        Good(WHEEL.format("left", "1", "1") + WHEEL.format("right", "1", "1"), scaffold=IN_SDF),
        Good(
            WHEEL.format("left", "1", "0") + WHEEL.format("right", "0", "1"), scaffold=IN_SDF, why="rollers"
        ),
        Good(
            WHEEL.format("left", "1", "1")
            + WHEEL.format("right", "1", "1")
            + WHEEL.format("caster", "0", "0"),
            scaffold=IN_SDF,
            why="nothing drives it",
        ),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return bool(slippery(plugin))

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        for link, values in slippery(plugin):
            message = f"{link.title} has no friction, and drive `{plugin.name}` turns it"
            yield self.diagnostic(values[0], message, labels={plugin: "this drive"})


def slippery(plugin: Plugin) -> list[tuple[Link, list[Value]]]:
    """The wheels without friction that a plugin turns, each with the coefficients."""
    if "drive" not in plugin.filename.lower():
        return []
    found = []
    for joint in dict.fromkeys(reference.joint for reference in plugin.references):
        link = joint.child_link if joint is not None else None
        values = coefficients(link) if link is not None and link.has("collision") else []
        if link is not None and values and all(value.number == 0 for value in values):
            found.append((link, values))
    return found


def coefficients(link: Link) -> list[Value]:
    """The coefficients of friction that are written for a link; none unless both directions have one everywhere."""
    names = ("mu1", "mu2")
    if link.is_urdf:
        found = [[value for block in link.gazebo_blocks for value in block.settings(name)] for name in names]
        return [value for values in found for value in values] if all(found) else []
    written = []
    for collision in link.collisions:
        at = collision.find("surface")
        for name in ("friction", "ode"):
            at = at.find(name) if at is not None else None
        both = [
            child.own_value
            for name in ("mu", "mu2")
            if at is not None and (child := at.find(name)) is not None
        ]
        if len(both) < len(names):
            return []
        written += both
    return written
