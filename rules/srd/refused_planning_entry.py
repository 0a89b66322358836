from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Semantics, Severity
from sdfcheck_rules.srd.scaffold import FILE, ROBOT

SRDF = '<«robot» name="arm"><group name="all"><chain base_link="base" tip_link="hand"/></group></robot>'
SOUND = SRDF.translate({ord("«"): None, ord("»"): None})
MANIFEST = {
    "package.xml": "<package><name>arm</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
}
SENT = "moveit_simple_controller_manager:\n  controller_names: [c]\n  c: {{{}joints: [shoulder]}}\n"
WHOLE = "action_ns: follow_joint_trajectory, type: FollowJointTrajectory, "
PLUGIN = "occupancy_map_monitor/PointCloudOctomapUpdater"
CLOUD = (
    "max_range: 5.0, padding_offset: 0.1, padding_scale: 1.0, point_subsample: 1, max_update_rate: 1.0, "
    "filtered_cloud_topic: near"
)


def files(**texts: str) -> dict[str, str]:
    return ROBOT | MANIFEST | {f"config/{name}.yaml": text for name, text in texts.items()}


def sensor(more: str) -> str:
    return f"sensors: [depth]\ndepth: {{sensor_plugin: {PLUGIN}, {more}, {CLOUD}}}\n"


class RefusedPlanningEntry(Rule):
    """MoveIt leaves out a controller or sensor of its files, for its entry lacks something.

    MoveIt does not send to a controller without `action_ns`, `type` or `joints`: it plans, and then says that it cannot
    identify any set of controllers for these joints. A sensor without one of the parameters of its plugin adds
    nothing to the map of what is around. Looked at are the files in the package of the only SRDF file of it, for ROS 2.
    """

    code = "SRD019"
    name = "refused-planning-entry"
    severity = Severity.WARNING
    remedy = """Write what the message names.

    `action_ns` is `follow_joint_trajectory` for a controller of trajectories, and `gripper_cmd` for a gripper.
    """
    looks_at = (Semantics,)
    scaffold = "{}"
    sources = ("https://github.com/moveit/moveit2",)

    bad = (
        Bad(
            SRDF,
            file=FILE,
            files=files(moveit_controllers=SENT.format("type: FollowJointTrajectory, ")),
            says="`moveit_controllers.yaml` has no `action_ns` for controller `c`",
        ),
        Bad(
            SRDF,
            file=FILE,
            files=files(moveit_controllers=SENT.format(WHOLE).replace("[c]", "[d]")),
            says="lists controller `d`, and has no entry for it",
        ),
        Bad(
            SRDF,
            file=FILE,
            files=files(moveit_controllers=SENT.format("action_ns: a, type: JointTrajectory, ")),
            says="has type `JointTrajectory` for controller `c`, and MoveIt knows FollowJointTrajectory",
        ),
        Bad(
            SRDF,
            file=FILE,
            files=files(sensors_3d=sensor("image_topic: /depth")),
            says="`sensors_3d.yaml` has no `point_cloud_topic` for sensor `depth`",
        ),
        Bad(
            SRDF,
            file=FILE,
            files=files(sensors_3d=f"sensors:\n  - {{sensor_plugin: {PLUGIN}}}\n"),
            says="lists a mapping in `sensors`, and MoveIt reads names there",
        ),
    )
    good = (
        Good(SOUND, file=FILE, files=files(moveit_controllers=SENT.format(WHOLE))),
        Good(SOUND, file=FILE, files=files(sensors_3d=sensor("point_cloud_topic: /points"))),
        Good(
            SOUND,
            file=FILE,
            files=files(sensors_3d="sensors: [depth]\ndepth: {sensor_plugin: my_plugins/Own}\n"),
            why="nothing is known about the plugin",
        ),
    )

    @staticmethod
    def applies(semantics: Semantics) -> bool:
        return bool(semantics.beside) and bool(semantics.parameters.refused)

    def check(self, semantics: Semantics) -> Iterator[Diagnostic]:
        for entry in semantics.parameters.refused:
            message = f"`{entry.span.source.path.name}` {entry.words}"
            yield self.diagnostic(semantics, message, labels={entry.span: "written here"})
