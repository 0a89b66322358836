import re
from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Good, Joint, Rule, Severity

CAMERA = (
    '<link name="camera"/><link name="camera_optical_frame"/>'
    '<joint name="lens" type="fixed"><parent link="base"/><child link="camera"/>{}</joint>'
    '<joint name="optics" type="fixed"><parent link="camera"/><child link="camera_optical_frame"/>{}</joint>'
)
TURN = '<origin rpy="-1.5708 0 -1.5708"/>'

OPTICAL = re.compile(r"(?:^|[_/])optical(?:[_/]|$)")
UPWARDS = 0.99
"""The cosine of the angle between the optical axis and the vertical of a robot, from which on a camera looks up."""


class UnturnedOpticalFrame(Rule):
    """The optical frame of a camera is not turned, so the camera looks up in it.

    Along the z axis of an optical frame a camera looks, x points to the right of the picture and y down, whereas in
    the frame of the camera's body x points forward and z up. Images and clouds of points are placed by the optical
    frame: without the turn they stand on their side. None of 81 such frames in public robots lacks it.
    """

    code = "JNT030"
    name = "unturned-optical-frame"
    severity = Severity.WARNING
    remedy = """Turn the joint: `<origin rpy="-1.5708 0 -1.5708"/>`.

    That is from the frame of the body, as ROS's REP 103 defines both. Where the camera does look up, turn the link of
    its body.
    """
    looks_at = (Joint,)
    selects = ("urdf:robot/joint",)
    needs = ("optical",)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            CAMERA.format("", '<origin xyz="0.1 0 0" rpy="«0 0 0»"/>'),
            says="joint `optics` does not turn optical frame `camera_optical_frame`, in which the camera looks up",
        ),
    )
    good = (
        Good(CAMERA.format("", TURN)),
        Good(CAMERA.format(TURN, ""), why="the camera's body is turned so"),
        Good(
            CAMERA.format('<origin rpy="0 -1.5708 0"/>', TURN),
            why="the camera looks up, and its frame is turned",
        ),
    )

    @staticmethod
    def applies(joint: Joint) -> bool:
        if not joint.is_fixed or not OPTICAL.search(joint.child_name) or OPTICAL.search(joint.parent_name):
            return False
        origin = joint.find("origin")
        words = "" if origin is None else origin.text_of("rpy", "")
        pose = joint.at_rest
        return not words.strip(" 0.-+") and pose is not None and pose.turned((0, 0, 1))[2] > UPWARDS

    def check(self, joint: Joint) -> Iterator[Diagnostic]:
        origin = joint.find("origin")
        value = None if origin is None else origin.attribute("rpy")
        message = (
            f"{joint.title} does not turn optical frame `{joint.child_name}`, in which the camera looks up"
        )
        yield self.diagnostic(value or joint, message)
