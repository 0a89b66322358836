from collections.abc import Iterator

from sdfcheck import (
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Edit,
    Good,
    Rule,
    Severity,
    make_fix,
    problems,
    used,
    warns,
)

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
    read `gz_frame_id`, of which libsdformat warns and for which Drake refuses the file; Ignition
    read `ignition_frame_id`. Without it messages carry a scoped name that no transform tree knows.
    """

    code = "GAZ007"
    name = "frame-id-spelling"
    severity = Severity.WARNING
    affects = {Consumer.GAZEBO: warns("warns, and may ignore it"), Consumer.DRAKE: {"sdf": REFUSES}}
    explains = (problems.FrameIdSpelling,)
    scaffold = SENSOR

    bad = (
        Bad(
            "<«ignition_frame_id»>imu</ignition_frame_id>",
            says="`ignition_frame_id` is now called `gz_frame_id`",
        ),
        Bad(
            "<«gz_frame_id»>imu</gz_frame_id>",
            says="`gz_frame_id` is not in SDFormat 1.9; Gazebo reads it all the same",
        ),
        Bad(
            "<«gz_frame_id»>imu</gz_frame_id>",
            fixed="<frame_id>imu</frame_id>",
            says="`gz_frame_id` is `frame_id` in SDFormat 1.12",
            scaffold=TWELVE,
        ),
        Bad(
            "<«ignition_frame_id»>imu</ignition_frame_id>",
            fixed="<gz_frame_id>imu</gz_frame_id>",
            scaffold=ROBOT,
        ),
    )
    good = (
        Good("<frame_id>imu</frame_id>", scaffold=TWELVE),
        Good("<gz_frame_id>imu</gz_frame_id>", why="what there is for URDF", scaffold=ROBOT),
    )

    def check(self, problem: problems.FrameIdSpelling) -> Iterator[Diagnostic]:
        element, instead = problem.elements[0], problem.instead
        times = used(len(problem.elements))
        if element.name == instead:
            message = f"`{instead}`{times} is not in SDFormat {problem.version}; Gazebo reads it all the same"
            advice = "from version 1.12 on there is `frame_id`"
            yield self.diagnostic(element, message, help=advice, severity=Severity.INFO)
            return
        message = f"`{element.name}`{times} is now called `{instead}`"
        if instead == "frame_id":
            message = f"`{element.name}`{times} is `frame_id` in SDFormat {problem.version}"
        spans = (span for use in problem.elements for span in (use.span, use.document.spans.end_name(use)))
        edits = tuple(Edit(span, instead) for span in spans if span is not None)
        yield self.diagnostic(element, message, fix=make_fix(f"rename it to `{instead}`", edits))
