from collections.abc import Iterator
from math import pi, tan

from sdfcheck import IN_LINK, Bad, Diagnostic, Element, Good, Rule, Sensor, Severity, Value

MOST = 0.01
"""Of the focal length, or of the size of the image: of 383 cameras in public files the right ones were within 0.001."""
CAMERA = (
    '<sensor name="s" type="camera"><camera><horizontal_fov>1.0472</horizontal_fov><image><width>640</width>'
    "<height>480</height></image><lens><intrinsics><fx>{0}</fx><fy>{0}</fy><cx>{1}</cx><cy>{2}</cy><s>0</s>"
    "</intrinsics></lens></camera></sensor>"
)


class MismatchedIntrinsics(Rule):
    """The intrinsics of a camera belong to another image or another field of view.

    The focal length in pixels is half of the width by the tangent of half of the horizontal field of view. Gazebo
    renders with the intrinsics where they are given: numbers of another resolution show a cut-out of the scene.
    The principal point is in the middle of the image. Measured intrinsics, with different focal lengths or a
    principal point between the pixels, are not compared.
    """

    code = "SCH033"
    name = "mismatched-intrinsics"
    severity = Severity.WARNING
    remedy = """Compute the focal length for this image: width / 2 / tan(horizontal_fov / 2), in pixels.

    `cx` and `cy` are half of the width and of the height. Without `<intrinsics>` Gazebo takes exactly
    these. Numbers of a calibration belong to the size of image that it was made at: scale all four with the
    image.
    """
    looks_at = (Sensor,)
    needs = ("<intrinsics",)
    scaffold = IN_LINK

    bad = (
        Bad(
            CAMERA.format("1108.5", "640.5", "480.5").replace("<fx>1108.5", "<fx>«1108.5»"),
            says="`fx` is 1108.5, and an image of 640 pixels over 1.0472 rad has 554.3",
        ),
        Bad(
            CAMERA.format("570", "319.5", "239.5").replace("<fx>570", "<fx>«570»"),
            says="`fx` is 570, and an image of 640 pixels over 1.0472 rad has 554.3",
        ),
        Bad(
            CAMERA.format("554.25", "339.5", "239.5").replace("<cx>339.5", "<cx>«339.5»"),
            says="`cx` is 339.5, and the middle of an image of 640 pixels is at 320",
        ),
    )
    good = (
        Good(CAMERA.format("554.25", "320.5", "240.5")),
        Good(CAMERA.format("552", "320.5", "240.5"), why="rounded"),
        Good(CAMERA.format("612.4", "318.27", "243.91"), why="measured at a real camera"),
    )

    @staticmethod
    def applies(sensor: Sensor) -> bool:
        return bool(mismatches(sensor))

    def check(self, sensor: Sensor) -> Iterator[Diagnostic]:
        for given, right, words, labels in mismatches(sensor):
            message = f"`{given.element.name}` is {given.text.strip()}, and {words} {right:.4g}"
            yield self.diagnostic(given, message, labels=labels)


Mismatch = tuple[Value, float, str, dict[Value, str]]
"""A value, what it should be, the words in front of that, and what it is compared with."""


def mismatches(sensor: Sensor) -> list[Mismatch]:
    """The focal length, in pixels, that does not fit the image; if it fits, what there is of the principal point."""
    camera = sensor.find("camera")
    intrinsics = None if camera is None else within(camera, "lens", "intrinsics")
    if camera is None or intrinsics is None or is_measured(intrinsics):
        return []
    width, height = (value_within(camera, "image", name) for name in ("width", "height"))
    found = focal(camera, intrinsics, width)
    return (
        [found]
        if found is not None
        else [*off_center(intrinsics, "cx", width), *off_center(intrinsics, "cy", height)]
    )


def focal(camera: Element, intrinsics: Element, width: Value | None) -> Mismatch | None:
    view, given = value_within(camera, "horizontal_fov"), value_within(intrinsics, "fx")
    if view is None or width is None or given is None:
        return None
    if not 0 < view.number < pi or not width.number > 0 or not given.number > 0:
        return None
    right = width.number / 2 / tan(view.number / 2)
    if abs(given.number - right) <= MOST * right:
        return None
    words = f"an image of {width.text.strip()} pixels over {view.text.strip()} rad has"
    return given, right, words, {width: "the width", view: "the field of view"}


def off_center(intrinsics: Element, name: str, size: Value | None) -> Iterator[Mismatch]:
    given = value_within(intrinsics, name)
    if given is not None and size is not None and abs(given.number - size.number / 2) > MOST * size.number:
        words = f"the middle of an image of {size.text.strip()} pixels is at"
        yield given, size.number / 2, words, {size: "the size of the image"}


def is_measured(intrinsics: Element) -> bool:
    """Do they come from a real camera? Computed ones have square pixels and their middle in one, or between two."""
    fx, fy, cx, cy = (value_within(intrinsics, name) for name in ("fx", "fy", "cx", "cy"))
    if fx is not None and fy is not None and fx.number != fy.number:
        return True
    return any(middle is not None and 2 * middle.number % 1 for middle in (cx, cy))


def value_within(element: Element, *path: str) -> Value | None:
    """The value of an element that is reached by names; None where one is missing."""
    found = within(element, *path)
    return None if found is None else found.own_value


def within(element: Element, *path: str) -> Element | None:
    """The element that is reached by names; None where one is missing."""
    found: Element | None = element
    for name in path:
        found = None if found is None else found.find(name)
    return found
