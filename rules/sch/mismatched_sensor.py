from collections.abc import Iterator

from sdfcheck import IN_LINK, Bad, Diagnostic, Element, Good, Rule, Sensor, Severity

NEED_SETTINGS = ("camera", "contact", "lidar", "logical_camera")
"""Settings without which a sensor has nothing sensible to run on."""
SCAN = (
    "<scan><horizontal><samples>9</samples><min_angle>-1</min_angle><max_angle>1</max_angle></horizontal></scan>"
    "<range><min>0.1</min><max>9</max></range>"
)


class MismatchedSensor(Rule):
    """The type of a sensor and the element that configures it do not go together.

    Each type reads one element: a camera `<camera>`, an IMU `<imu>`. Settings of another
    type are ignored, and a camera or lidar without settings runs on the defaults.
    """

    code = "SCH018"
    name = "mismatched-sensor"
    severity = Severity.WARNING
    remedy = """Give the sensor the element of its type, or the type of its element.

    `camera`, `depth_camera` and the like read `<camera>`; `lidar` and `gpu_lidar` `<lidar>` (or `<ray>`);
    `imu` `<imu>`; `navsat` `<navsat>`; `force_torque` `<force_torque>`. If the defaults are meant, write
    the element empty: a camera then has 320 × 240 pixels and 60°.
    """
    looks_at = (Sensor,)
    scaffold = IN_LINK

    bad = (
        Bad(
            '<sensor name="s" type="imu"><«camera»/></sensor>',
            says="sensor `s` of type `imu` does not read `camera`, but `imu`",
        ),
        Bad(
            '<sensor name="s" type="«camera»"><update_rate>30</update_rate></sensor>',
            says="sensor `s` of type `camera` has no `camera`, so it runs on defaults",
        ),
        Bad(
            '<sensor name="s" type="«gpu_ray»"/>',
            says="sensor `s` of type `gpu_ray` has no `ray`, so it runs on defaults",
        ),
    )
    good = (
        Good('<sensor name="s" type="imu"/>', why="an IMU without settings is ideal"),
        Good(
            f'<sensor name="s" type="gpu_lidar"><ray>{SCAN}</ray></sensor>', why="the older name is read too"
        ),
        Good(
            '<sensor name="s" type="ray"><plugin filename="liblivox.so" name="p"><ray/></plugin></sensor>',
            why="the plugin makes the scan",
        ),
        Good(
            '<robot name="r"><link name="l"/><sensor name="s" type="camera"><parent link="l"/></sensor></robot>',
            scaffold="{}",
            why="outside of `<gazebo>` no simulator makes a sensor of it",
        ),
        Good(
            '<sensor name="s" type="custom"><camera/></sensor>', why="nobody knows what a custom sensor reads"
        ),
    )

    @staticmethod
    def applies(sensor: Sensor) -> bool:
        expected = sensor.settings_names if sensor.is_extension or not sensor.is_urdf else ()
        return bool(expected) and (wrong_settings(sensor) is not None or lacks_settings(sensor))

    def check(self, sensor: Sensor) -> Iterator[Diagnostic]:
        kind, names, wrong = sensor.type_value, sensor.settings_names, wrong_settings(sensor)
        if kind is None:
            return
        expected = next((name for name in names if sensor.type.endswith(name)), names[0])
        subject = f"{sensor.title} of type `{sensor.type}`"
        cause = next(filter(None, map(sensor.misnamed, names)), None)
        if wrong is None:
            message = f"{subject} has no `{expected}`, so it runs on defaults"
            yield self.diagnostic(kind, message, cause=cause)
            return
        message = f"{subject} does not read `{wrong.name}`, but `{expected}`"
        yield self.diagnostic(wrong, message, labels={kind: "the type"}, cause=cause)


def wrong_settings(sensor: Sensor) -> Element | None:
    """The first element that configures sensors of another type."""
    names = sensor.settings_names
    return next((given for given in sensor.given_settings if given.name not in names), None)


def lacks_settings(sensor: Sensor) -> bool:
    if sensor.settings_names[0] not in NEED_SETTINGS or sensor.given_settings:
        return False
    return not any(plugin.element.has(name) for plugin in sensor.plugins for name in sensor.settings_names)
