from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Root, Rule, Severity, named

MASS = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
ROBOT = (
    f'<robot name="r"><{{}} name="base_link"/><link name="body">{MASS}</link><link name="left_wheel">{MASS}</link>'
    '<joint name="tie" type="fixed"><parent link="base_link"/><child link="body"/></joint>'
    '<joint name="turn" type="continuous"><parent link="body"/><child link="left_wheel"/><axis xyz="0 1 0"/></joint>'
    "</robot>"
)
WRONG, SOUND = ROBOT.format("«link»"), ROBOT.format("link")
MAPPER = "slam_toolbox:\n  ros__parameters:\n    odom_frame: odom\n    base_frame: base_footprint\n"
PUBLISHER = "arguments=['--frame-id', 'base_link', '--child-frame-id', 'base_footprint']\n"


class MissingBaseFrame(Rule):
    """A node of ROS takes a frame for the base of the robot that the robot does not have.

    Looked at are YAML files of the project: `robot_base_frame` of Nav2, `base_frame_id` of AMCL, `base_frame` of
    slam_toolbox and `base_link_frame` of robot_localization. The node waits for a transform that nobody publishes:
    maps stay empty, messages of sensors are dropped, goals are refused. Nothing is said if any other description,
    launch file or program of the project has the name.
    """

    code = "FRM014"
    name = "missing-base-frame"
    severity = Severity.WARNING
    remedy = """Write a link of the robot in the parameters, mostly its root.

    Or give the robot such a link: `base_footprint` is the root, on the floor below `base_link`, which hangs on it by a
    fixed joint.
    """
    looks_at = (Root,)
    needs = ("wheel",)
    scaffold = "{}"

    bad = (
        Bad(
            WRONG,
            files={"params.yaml": MAPPER},
            says="`slam_toolbox` in `params.yaml` takes `base_footprint` for the base, a link that robot `r` does "
            "not have: its root is `base_link`",
        ),
    )
    good = (
        Good(SOUND, files={"params.yaml": MAPPER.replace("base_footprint", "base_link")}),
        Good(SOUND, files={"params.yaml": MAPPER, "launch/tf.py": PUBLISHER}, why="a program publishes it"),
        Good(
            SOUND,
            files={"params.yaml": MAPPER.replace("slam_toolbox", "camera")},
            why="the node is not known",
        ),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return bool(root.missing_bases)

    def check(self, root: Root) -> Iterator[Diagnostic]:
        robot = root.models[0]
        top = robot.tree.roots[0]
        for name in dict.fromkeys(frame.name for frame in root.missing_bases):
            frames = [frame for frame in root.missing_bases if frame.name == name]
            nodes = named(dict.fromkeys(frame.node for frame in frames))
            files = named(dict.fromkeys(frame.span.source.path.name for frame in frames))
            takes = "takes" if nodes.count("`") == 2 else "take"
            message = (
                f"{nodes} in {files} {takes} `{name}` for the base, a link that {robot.title} does not have"
            )
            yield self.diagnostic(
                top, f"{message}: its root is `{top.name}`", labels={frames[0].span: "taken here"}
            )
