from collections.abc import Iterator

from sdfcheck import Bad, Consumer, Diagnostic, GazeboBlock, Good, Link, Model, Rule, Severity, Value

MEANINGS = {
    "turnGravityOff": ("gravity", ("1", "true", "yes")),
    "gravity": ("gravity", ("0", "false", "no")),
    "selfCollide": ("self_collide", ("0", "false", "no")),
    "self_collide": ("self_collide", ("0", "false", "no")),
}
"""Setting of a link as a whole → its element in SDFormat, and the texts that make that false."""
HALF = 0.5
MASS = '<inertial><mass value="{}"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
ROBOT = (
    f'<robot name="r"><link name="base">{MASS.format(9)}</link><link name="laser">{MASS.format(1)}</link>'
    '<joint name="j" type="fixed"><parent link="base"/><child link="laser"/></joint>{}</robot>'
)
OFF = '<gazebo reference="{}"><turnGravityOff>{}</turnGravityOff></gazebo>'


class SpreadSetting(Rule):
    """A setting for one link changes the link that it is fixed to.

    libsdformat merges links that fixed joints tie together, and a link of Gazebo has one gravity and one answer to
    whether it collides with its own model. A sensor without gravity takes the weight from the robot that it is mounted
    on; of two answers one is left, and libsdformat warns.
    """

    code = "GAZ025"
    name = "spread-setting"
    severity = Severity.WARNING
    remedy = """Remove the setting, or give all links that are merged the same one.

    If the link needs its own, keep it apart with `<preserveFixedJoint>true</preserveFixedJoint>` in a `<gazebo>` block
    about the joint; the link then needs mass.
    """
    looks_at = (Model,)
    selects = ("urdf:robot",)
    needs = ("ravity", "ollide")
    scaffold = ROBOT

    bad = (
        Bad(
            OFF.format("laser", "«true»"),
            says="gravity is off for link `base`, too, which libsdformat makes one link with `laser`",
        ),
        Bad(
            '<gazebo reference="base"><selfCollide>true</selfCollide></gazebo>'
            '<gazebo reference="laser"><selfCollide>«false»</selfCollide></gazebo>',
            says="`selfCollide` of link `laser` is `false`, and that of link `base` `true`; libsdformat makes one link",
        ),
    )
    good = (
        Good(OFF.format("base", "true"), why="the link that is left has its name"),
        Good(OFF.format("laser", "false")),
        Good(OFF.format("base", "true") + OFF.format("laser", "true")),
        Good(
            OFF.format("laser", "true")
            + '<gazebo reference="j"><preserveFixedJoint>true</preserveFixedJoint></gazebo>',
            why="it stays a link of its own",
        ),
    )

    @staticmethod
    def applies(robot: Model) -> bool:
        return any(True for _ in spread(robot))

    def check(self, robot: Model) -> Iterator[Diagnostic]:
        for value, link, other, before in spread(robot):
            merged = {link.parent_joints[0]: "merges them"} if link.parent_joints else {}
            if before is None:
                message = f"gravity is off for {other.title}, too, which libsdformat makes one link with `{link.name}`"
                yield self.diagnostic(value, message, labels={**merged, other: "has no weight, either"})
                continue
            name, text = value.element.name, value.text.strip()
            message = (
                f"`{name}` of {link.title} is `{text}`, and that of {other.title} `{before.text.strip()}`; libsdformat"
                " makes one link of them"
            )
            yield self.diagnostic(value, message, labels={**merged, before: "the other value"})


def spread(robot: Model) -> Iterator[tuple[Value, Link, Link, Value | None]]:
    """The settings that reach another link: the setting, its link, the other one and what that one gives itself."""
    for built in robot.as_built_by(Consumer.GAZEBO).links.values():
        given: dict[str, dict[Link, tuple[bool, Value]]] = {}
        for block in built.blocks if len(built.members) > 1 else ():
            for what, answer in answers(block):
                if block.link is not None:
                    given.setdefault(what, {})[block.link] = answer
        for what, each in given.items():
            (first, (truth, value)), *others = each.items()
            differing = [(link, found) for link, (is_on, found) in others if is_on is not truth]
            if differing:
                link, found = differing[-1]
                yield found, link, first, value
            bearer = bearer_of(built.members, set(each))
            is_weightless = what == "gravity" and not truth and first is not built.origin
            if not differing and is_weightless and bearer is not None:
                yield value, first, bearer, None


def answers(block: GazeboBlock) -> Iterator[tuple[str, tuple[bool, Value]]]:
    """The settings of a block that are about its link as a whole."""
    for name, (what, false) in MEANINGS.items():
        for value in block.settings(name):
            yield what, (value.text.strip().lower() not in false, value)


def bearer_of(members: tuple[Link, ...], weightless: set[Link]) -> Link | None:
    """The heaviest of the links without the setting, if they are most of the mass."""
    masses = {link: link.inertial.mass.number for link in members if link.has_mass}
    others = {link: mass for link, mass in masses.items() if link not in weightless}
    heaviest = max(others, key=lambda link: others[link], default=None)
    return heaviest if sum(others.values()) > HALF * sum(masses.values()) else None
