from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Element, GazeboBlock, Good, Rule, Severity

ARM = '<link name="arm"/><joint name="j" type="continuous"><parent link="base"/><child link="arm"/></joint>'
WHAT = {"link": "a link", "joint": "a joint", "robot": "the robot"}


class UnreadSetting(Rule):
    """A setting for Gazebo is in a block about something that does not have it.

    `mu1`, `material` and `turnGravityOff` are settings of links, `stopCfm` and `provideFeedback` of joints,
    `static` of the robot. libsdformat drops the others in silence: what is in a block without `reference` is not
    for all links. Some settings are those of older releases, and nobody reads them any more.
    """

    code = "GAZ009"
    name = "unread-setting"
    severity = Severity.WARNING
    remedy = """Move the setting to a block whose `reference` is a link or joint that has it, or remove it.

    Write one block for each link: `<gazebo reference="left_wheel"><mu1>1.0</mu1></gazebo>`; a macro of
    xacro saves the repetition. Friction, contact and materials belong to links, `stopCfm`, `stopErp`,
    `implicitSpringDamper` and `provideFeedback` to joints.
    """
    looks_at = (GazeboBlock,)
    scaffold = IN_ROBOT

    bad = (
        Bad("<gazebo><«mu1»>0.5</mu1></gazebo>", says="`mu1` is a setting of a link, not of the robot"),
        Bad(
            f'{ARM}<gazebo reference="j"><«turnGravityOff»>true</turnGravityOff></gazebo>',
            says="`turnGravityOff` is a setting of a link, not of a joint",
        ),
        Bad(
            "<gazebo><«mu1»>0.5</mu1><mu2>0.5</mu2><kp>1e6</kp></gazebo>",
            says="`mu1` and 2 more are settings of a link, not of the robot: they are dropped",
        ),
        Bad(
            f'{ARM}<gazebo reference="j"><«stopKp»>1e6</stopKp></gazebo>',
            says="`stopKp` was read by older releases only",
        ),
    )
    good = (
        Good('<gazebo reference="base"><mu1>0.5</mu1></gazebo>'),
        Good("<gazebo><static>true</static></gazebo>"),
        Good('<gazebo><plugin name="p" filename="p"><mu1>1</mu1></plugin></gazebo>', why="the plugin's own"),
    )

    @staticmethod
    def applies(block: GazeboBlock) -> bool:
        return any(block.unread_settings)

    def check(self, block: GazeboBlock) -> Iterator[Diagnostic]:
        misplaced: dict[str, list[Element]] = {}
        for element, place in block.unread_settings:
            if place:
                misplaced.setdefault(place, []).append(element)
            else:
                message = f"`{element.name}` was read by older releases only"
                yield self.diagnostic(element, message, severity=Severity.INFO)
        about = "robot" if not block.reference else "joint" if block.link is None else "link"
        for place, elements in misplaced.items():
            name, *others = dict.fromkeys(element.name for element in elements)
            where = f"of {WHAT[place]}, not of {WHAT[about]}"
            message = f"`{name}` is a setting {where}: it is dropped"
            if others:
                message = f"`{name}` and {len(others)} more are settings {where}: they are dropped"
            yield self.diagnostic(elements[0], message, cause=block.misnamed("reference"))
