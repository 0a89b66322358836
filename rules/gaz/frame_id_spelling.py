from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Element, Good, Root, Rule, Severity, rename, used

STANDARD = "frame_id"
CURRENT = "gz_frame_id"
IGNITION = "ignition_frame_id"
STANDARD_SINCE = (1, 12)

SENSOR = (
    '<sdf version="1.9"><model name="m"><link name="base"><sensor name="s" type="imu"><imu/>{}</sensor>'
    "</link></model></sdf>"
)
TWELVE = SENSOR.replace("1.9", "1.12")
ROBOT = (
    '<robot name="r"><link name="base"/><gazebo reference="base">'
    '<sensor name="s" type="imu">{}</sensor></gazebo></robot>'
)


class FrameIdSpelling(Rule):
    """The frame id of a sensor has a name of another version.

    The specification has `frame_id` from version 1.12 on. Before, Gazebo Garden and later
    read `gz_frame_id`, of which libsdformat warns and for which Drake refuses the file; Ignition up to Fortress
    read `ignition_frame_id`, and Harmonic reads it no longer. Without it messages carry a scoped name that no
    transform tree knows.
    """

    code = "GAZ007"
    name = "frame-id-spelling"
    severity = Severity.WARNING
    remedy = """Rename it as the version of the file spells it: `gz_frame_id`, and `frame_id` from SDFormat 1.12 on.

    The value is the link of the robot that tf2 knows, such as `laser_link`, without a slash. For Drake,
    which refuses `gz_frame_id`, declare version 1.12 and write `frame_id`. Keep `ignition_frame_id` for Fortress.
    """
    looks_at = (Root,)
    scaffold = SENSOR

    bad = (
        Bad(
            "<«ignition_frame_id»>imu</ignition_frame_id>",
            says="`ignition_frame_id` is now called `gz_frame_id`",
        ),
        Bad(
            "<«gz_frame_id»>imu</gz_frame_id>",
            says="`gz_frame_id` is not in SDFormat 1.9; Gazebo reads it anyway",
        ),
        Bad(
            "<«gz_frame_id»>imu</gz_frame_id>",
            fixed="<frame_id>imu</frame_id>",
            says="`gz_frame_id` is `frame_id` in SDFormat 1.12",
            scaffold=TWELVE,
        ),
        Bad(
            "<«ignition_frame_id»>base</ignition_frame_id>",
            fixed="<gz_frame_id>base</gz_frame_id>",
            unsafe=True,
            scaffold=ROBOT,
        ),
        Bad(
            "<«frame_id»>base</frame_id>",
            fixed="<gz_frame_id>base</gz_frame_id>",
            unsafe=True,
            scaffold=ROBOT,
            says="`frame_id` is read from Gazebo Ionic on, and `gz_frame_id` by older ones, too",
        ),
    )
    good = (
        Good("<frame_id>base</frame_id><gz_frame_id>base</gz_frame_id>", scaffold=ROBOT),
        Good("<frame_id>imu</frame_id>", scaffold=TWELVE),
        Good("<gz_frame_id>base</gz_frame_id>", why="the element that URDF has", scaffold=ROBOT),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return "frame_id" in root.document.source.text and bool(misnamed(root))

    def check(self, root: Root) -> Iterator[Diagnostic]:
        instead, version = fitting(root), root.read_as
        for name, elements in misnamed(root).items():
            times = used(len(elements))
            if name == STANDARD:
                message = f"`{name}`{times} is read from Gazebo Ionic on, and `{instead}` by older ones, too"
                yield self.diagnostic(
                    elements[0], message, severity=Severity.INFO, fix=rename(instead, *elements)
                )
                continue
            if name == instead:
                message = f"`{name}`{times} is not in SDFormat {version}; Gazebo reads it anyway"
                advice = "from version 1.12 on there is `frame_id`"
                yield self.diagnostic(elements[0], message, help=advice, severity=Severity.INFO)
                continue
            message = f"`{name}`{times} is now called `{instead}`"
            if instead == STANDARD:
                message = f"`{name}`{times} is `{instead}` in SDFormat {version}"
            # Fortress reads the old name alone.
            fix = rename(instead, *elements, unsafe=name == IGNITION)
            yield self.diagnostic(elements[0], message, fix=fix)


def fitting(root: Root) -> str:
    """The name for the version of a file."""
    return STANDARD if not root.is_urdf and root.read_as >= STANDARD_SINCE else CURRENT


def misnamed(root: Root) -> dict[str, list[Element]]:
    """Name → the frame ids that have it; in SDF files any other name than the standard one, in URDF also that alone."""
    found: dict[str, list[Element]] = {}
    for sensor in root.each("Sensor"):
        for name in (CURRENT, IGNITION):
            if not root.is_urdf or name != CURRENT:
                for element in sensor.children(name):
                    found.setdefault(name, []).append(element)
        if root.is_urdf and not sensor.has(CURRENT) and not sensor.has(IGNITION) and not sensor.has("plugin"):
            for element in sensor.children(STANDARD):
                found.setdefault(STANDARD, []).append(element)
    return found
