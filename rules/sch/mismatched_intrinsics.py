from collections.abc import Iterator
from math import pi, tan

from sdfcheck import IN_LINK, Bad, Consumer, Diagnostic, Element, Good, Rule, Sensor, Severity, Value, warns

MOST = 0.1
"""Of the focal length: of 23 cameras in public files that differ by more, 15 were mistakes."""
CAMERA = (
    '<sensor name="s" type="camera"><camera><horizontal_fov>1.0472</horizontal_fov><image><width>640</width>'
    "<height>480</height></image><lens><intrinsics><fx>{0}</fx><fy>{0}</fy><cx>{1}</cx><cy>{2}</cy><s>0</s>"
    "</intrinsics></lens></camera></sensor>"
)


class MismatchedIntrinsics(Rule):
    """The intrinsics of a camera belong to another image or another field of view.

    The focal length in pixels is half of the width by the tangent of half of the horizontal field of view. Gazebo
    renders with the intrinsics where they are given: numbers of another resolution show a cut-out of the scene.
    """

    code = "SCH033"
    name = "mismatched-intrinsics"
    severity = Severity.WARNING
    preview = True
    affects = {Consumer.GAZEBO: warns("renders another field of view")}
    looks_at = (Sensor,)
    needs = ("<intrinsics",)
    scaffold = IN_LINK

    bad = (
        Bad(
            CAMERA.format("1108.5", "640.5", "480.5").replace("<fx>1108.5", "<fx>«1108.5»"),
            says="`fx` is 1108.5, and an image of 640 pixels over 1.0472 rad has 554.3",
        ),
    )
    good = (
        Good(CAMERA.format("554.25", "320.5", "240.5")),
        Good(CAMERA.format("570", "320", "240"), why="calibrated"),
    )

    @staticmethod
    def applies(sensor: Sensor) -> bool:
        return focal(sensor) is not None

    def check(self, sensor: Sensor) -> Iterator[Diagnostic]:
        found = focal(sensor)
        if found is None:
            return
        given, width, view = found
        yield self.diagnostic(
            given,
            f"`fx` is {given.text.strip()}, and an image of {width.text.strip()} pixels over {view.text.strip()} rad"
            f" has {width.number / 2 / tan(view.number / 2):.4g}",
            labels={width: "the width", view: "the field of view"},
        )


def focal(sensor: Sensor) -> tuple[Value, Value, Value] | None:
    """The focal length in pixels, the width and the field of view of a camera where they do not fit."""
    camera = sensor.find("camera")
    if camera is None:
        return None
    view, width = within(camera, "horizontal_fov"), within(camera, "image", "width")
    given = within(camera, "lens", "intrinsics", "fx")
    if view is None or width is None or given is None:
        return None
    if not 0 < view.number < pi or not width.number > 0 or not given.number > 0:
        return None
    right = width.number / 2 / tan(view.number / 2)
    return (given, width, view) if abs(given.number - right) > MOST * right else None


def within(element: Element, *path: str) -> Value | None:
    """The value of an element that is reached by names; None where one is missing."""
    found: Element | None = element
    for name in path:
        found = None if found is None else found.find(name)
    return None if found is None else found.own_value
