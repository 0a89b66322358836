from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Joint, Link, Plugin, Rule, Severity

MECANUM = "gz-sim-mecanum-drive-system"
WHEELS = ("front_left", "front_right", "back_left", "back_right")
ROLLERS = "<surface><friction><ode><mu>1</mu><mu2>0</mu2><fdir1>1 1 0</fdir1></ode></friction></surface>"
WHEEL = (
    '<link name="{0}"><collision name="c"><geometry><sphere><radius>0.1</radius></sphere></geometry>{1}</collision>'
    '</link><joint name="{0}_joint" type="revolute"><parent>base</parent><child>{0}</child><axis><xyz>0 1 0</xyz>'
    "</axis></joint>"
)
ROLLER = '<link name="roller"/><joint name="r" type="revolute"><parent>front_left</parent><child>roller</child></joint>'


def drive(plugin: str, surface: str, more: str = "") -> str:
    """A robot with four wheels, and the drive that turns them."""
    wheels = "".join(WHEEL.format(name, surface) for name in WHEELS)
    joints = "".join(f"<{name}_joint>{name}_joint</{name}_joint>" for name in WHEELS)
    return (
        wheels
        + more
        + f'<{plugin} filename="{MECANUM}" name="gz::sim::systems::MecanumDrive">{joints}</plugin>'
    )


class GrippingMecanum(Rule):
    """The wheels of a mecanum drive hold the floor in all directions.

    The drive of Gazebo turns the wheels, and friction does the rest. Wheels without rollers, and without a direction in
    which they slide, roll straight ahead: the robot does not move sideways, and slides where it should turn.
    """

    code = "GAZ031"
    name = "gripping-mecanum"
    severity = Severity.WARNING
    remedy = """Give the collision of each wheel a direction of friction, 45° from its axle, and none across it.

    In `<surface><friction><ode>`: `<mu>1</mu>`, `<mu2>0</mu2>` and
    `<fdir1 gz:expressed_in="base_link">1 -1 0</fdir1>` for front left and back right, `1 1 0` for the other two.
    Without `gz:expressed_in` the direction turns with the wheel.
    """
    looks_at = (Plugin,)
    scaffold = '<sdf version="1.9"><model name="m"><link name="base"/>{}</model></sdf>'
    sources = ("https://github.com/gazebosim/gz-sim/blob/gz-sim8/examples/worlds/mecanum_drive.sdf",)

    bad = (
        Bad(
            drive("«plugin»", ""),
            says="its wheels hold the floor in all directions",
        ),
    )
    good = (
        Good(drive("plugin", ROLLERS)),
        Good(drive("plugin", "", ROLLER), why="rollers"),
        Good(drive("plugin", "").replace("mecanum-drive", "diff-drive"), why="another drive"),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        if plugin.known is None or plugin.known.file != MECANUM or plugin.root.elements.get("fdir1"):
            return False
        wheels = [link for reference in plugin.references if (link := turned(reference.joint)) is not None]
        return len(wheels) >= len(WHEELS) and not any(link.child_joints for link in wheels)

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        words = "its wheels hold the floor in all directions: the robot does not move sideways"
        yield self.diagnostic(plugin, words)


def turned(joint: Joint | None) -> Link | None:
    """The link of a wheel that touches the floor."""
    link = joint.child_link if joint is not None else None
    return link if link is not None and link.has("collision") else None
