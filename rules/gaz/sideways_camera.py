import re
from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, GazeboBlock, Good, Link, Rule, Sensor, Severity

ALIGNED = 0.99
"""The cosine of the angle between two directions that are one."""
OPTICAL = re.compile(r"(?:^|[_/])optical(?:[_/]|$)")
OTHERS = frozenset(("depth", "rgbd", "segmentation", "thermal"))
ROBOT = (
    '<robot name="r"><link name="base"/><link name="camera"/><link name="camera_optical"/>'
    '<joint name="j" type="fixed"><parent link="base"/><child link="camera"/></joint>'
    '<joint name="k" type="fixed"><parent link="camera"/><child link="camera_optical"/>'
    '<origin rpy="-1.5708 0 -1.5708"/></joint>'
    '<gazebo reference="{}"><sensor name="s" type="{}">{}<camera/></sensor></gazebo></robot>'
)


class SidewaysCamera(Rule):
    """A camera of Gazebo is in an optical frame, in which it looks to the right.

    A camera of Gazebo looks along the x axis of its link, and z is up in its picture. In an optical frame z is forward
    and x points to the right of the picture (REP 103): the camera there looks to the side, and its picture is turned by
    a quarter. The optical frame is for the messages, the sensor belongs to the body of the camera.
    """

    code = "GAZ038"
    name = "sideways-camera"
    severity = Severity.WARNING
    remedy = """Put the sensor into the `<gazebo>` block of the camera's body, the parent of the optical frame.

    The frame of its messages stays the optical one: `<gz_frame_id>` or `<optical_frame_id>` in the new Gazebo,
    `<frame_name>` in the plugin of Gazebo Classic. Or turn the sensor back, by `<pose>0 0 0 1.5708 -1.5708 0</pose>`.
    """
    looks_at = (Sensor,)
    needs = ("optical",)

    bad = (
        Bad(
            ROBOT.format("«camera_optical»", "camera", ""),
            says="camera `s` is in optical frame `camera_optical`, where Gazebo lets it look to the right",
        ),
        Bad(ROBOT.format("«camera_optical»", "rgbd_camera", "<pose>0 0 0 0 0 0</pose>")),
    )
    good = (
        Good(ROBOT.format("camera", "camera", "")),
        Good(
            ROBOT.format("camera_optical", "camera", "<pose>0 0 0 1.5708 -1.5708 0</pose>"), why="turned back"
        ),
        Good(
            ROBOT.format("camera_optical", "camera", "").replace(
                "<camera/>", "<camera><pose>0 0 0 0 -1.5708 1.5708</pose></camera>"
            ),
            why="turned back, which Gazebo Classic reads",
        ),
        Good(ROBOT.format("camera_optical", "imu", ""), why="not a camera"),
        Good(
            ROBOT.replace(' rpy="-1.5708 0 -1.5708"', "").format("camera_optical", "camera", ""),
            why="the frame is called so only",
        ),
    )

    @staticmethod
    def applies(sensor: Sensor) -> bool:
        return body(sensor) is not None

    def check(self, sensor: Sensor) -> Iterator[Diagnostic]:
        link, parent, block = sensor.link, body(sensor), sensor.within(GazeboBlock)
        assert link is not None
        assert parent is not None
        message = f"camera `{sensor.name}` is in optical frame `{link.name}`, where Gazebo lets it look to the right"
        place = block.value("reference") if block is not None else None
        advice = f"put it into the block of link `{parent.name}`"
        yield self.diagnostic(place or sensor, message, help=advice)


def body(sensor: Sensor) -> Link | None:
    """The link that carries the optical frame in which a camera looks to the right; None where it does not."""
    link, view = sensor.link, sensor.view
    is_camera = "camera" in sensor.type or sensor.type in OTHERS
    if (
        not is_camera
        or any(each.has("pose") for each in sensor.children("camera"))
        or not sensor.is_extension
        or link is None
        or view is None
        or not OPTICAL.search(link.name)
    ):
        return None
    joint = next(iter(link.parent_joints), None)
    parent = joint.parent_link if joint is not None and joint.is_fixed else None
    if parent is None or parent.at_rest is None or link.at_rest is None:
        return None
    forward = along(link.at_rest.turned((0.0, 0.0, 1.0)), parent.at_rest.turned((1.0, 0.0, 0.0)))
    is_sideways = along(view, link.at_rest.turned((1.0, 0.0, 0.0))) > ALIGNED
    return parent if forward > ALIGNED and is_sideways else None


def along(one: tuple[float, float, float], other: tuple[float, float, float]) -> float:
    """The cosine of the angle between two directions."""
    return sum(a * b for a, b in zip(one, other, strict=True))
