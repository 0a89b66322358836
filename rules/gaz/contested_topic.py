from collections.abc import Iterator

from sdfcheck import (
    IN_LINK,
    IN_MODEL,
    Bad,
    Diagnostic,
    Good,
    Model,
    Plugin,
    Root,
    Rule,
    Sensor,
    Severity,
    Value,
)

UNSAID = frozenset(("", "__default__", "__default_topic__"))
"""Topics for which simulators take one of their own."""
SENSOR = '<sensor name="{}" type="imu"><topic>{}</topic></sensor>'
CAMERAS = (
    "boundingbox_camera",
    "camera",
    "depth",
    "depth_camera",
    "segmentation_camera",
    "thermal",
    "thermal_camera",
)
CAMERA = (
    '<sensor name="{}" type="camera"><topic>{}</topic><camera><horizontal_fov>{}</horizontal_fov>'
    "<image><width>640</width><height>480</height></image></camera></sensor>"
)
MOTOR = (
    '<plugin filename="gz-sim-multicopter-motor-model-system" name="gz::sim::systems::MulticopterMotorModel">'
    "<jointName>r</jointName><linkName>base</linkName><commandSubTopic>c</commandSubTopic>"
    "<motorNumber>{}</motorNumber></plugin>"
)
ROTOR = (
    '<link name="k"/><joint name="r" type="revolute"><parent>base</parent><child>k</child>'
    "<axis><xyz>0 0 1</xyz></axis></joint>"
)
PILOT = (
    '<plugin name="ArduPilotPlugin" filename="ArduPilotPlugin"><control channel="{}"><jointName>a</jointName></control>'
    '<control channel="{}"><jointName>b</jointName></control></plugin>'
    '<link name="k"/><joint name="a" type="revolute"><parent>base</parent><child>k</child><axis><xyz>0 0 1</xyz></axis>'
    '</joint><link name="l"/><joint name="b" type="revolute"><parent>base</parent><child>l</child>'
    "<axis><xyz>0 0 1</xyz></axis></joint>"
)
UPRIGHT = 0.9
"""Of the length of an axis: rotors that lift."""
FEWEST = 4
"""Motors of a vehicle of which an autopilot makes a list of speeds."""
MOTORS = "gz-sim-multicopter-motor-model-system"
NUMBERS = ("actuator_number", "motorNumber")


class ContestedTopic(Rule):
    """Two sensors of a robot publish on one topic, or its motors do not have a number each, from 0 on.

    The messages of both sensors come mixed on the topic, of one type or of two. A camera also publishes its
    calibration, on `camera_info` beside its topic: `front` and `back` have one `camera_info`, and `front/image` has its
    own. Motors take their speed from a list, by their number: both turn alike, and the speed that was meant for the
    second goes nowhere. Where no motor has the number 0, the last one asks for a speed beyond the end of the list, as
    autopilots make one for each motor. So it is with two rotors of ArduPilot on one channel.
    """

    code = "GAZ015"
    name = "contested-topic"
    severity = Severity.WARNING
    remedy = """Give each sensor a topic and each motor a number of its own.

    In a macro of xacro, make the topic from the prefix: `<topic>${prefix}imu</topic>`. Without `<topic>`,
    Gazebo makes one from world, model, link and sensor. The numbers of motors are the places in the list of
    speeds, from 0 on.
    """
    looks_at = (Root,)
    scaffold = IN_LINK

    bad = (
        Bad(
            SENSOR.format("front", "imu") + SENSOR.format("back", "«imu»"),
            says="sensor `back` publishes on topic `imu`, as sensor `front` does",
        ),
        Bad(
            CAMERA.format("a", "front", "1") + CAMERA.format("b", "«back»", "1.5"),
            says="sensor `b` publishes its calibration on `camera_info`, as sensor `a` does",
        ),
        Bad(
            ROTOR + MOTOR.format("0") + MOTOR.format("«0»"),
            scaffold=IN_MODEL,
            says="motor number 0 is given before",
        ),
        Bad(
            ROTOR + "".join(MOTOR.format(number) for number in ("«1»", 2, 3, 4)),
            scaffold=IN_MODEL,
            says="the 4 motors have the numbers 1 to 4, and are counted from 0",
        ),
        Bad(
            PILOT.format(0, "«0»"),
            scaffold=IN_MODEL,
            says="channel 0 is given before",
        ),
    )
    good = (
        Good(
            SENSOR.format("front", "__default_topic__") + SENSOR.format("back", "__default_topic__"),
            why="each has a topic of its own by default",
        ),
        Good(SENSOR.format("front", "imu") + SENSOR.format("back", "imu2")),
        Good(CAMERA.format("a", "front/image", "1") + CAMERA.format("b", "back/image", "1.5")),
        Good(
            CAMERA.format("a", "rgb", "1") + CAMERA.format("b", "depth", "1"),
            why="one camera, with one calibration",
        ),
        Good(ROTOR + MOTOR.format("0") + MOTOR.format("1"), scaffold=IN_MODEL),
        Good(PILOT.format(0, 1), scaffold=IN_MODEL),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return next(doubled(root), None) is not None

    def check(self, root: Root) -> Iterator[Diagnostic]:
        for first, again, words in doubled(root):
            yield self.diagnostic(again, words, labels={first: "first here"})


def doubled(root: Root) -> Iterator[tuple[Value, Value, str]]:
    """The first and the further uses of a topic, or of the number of a motor, in one model with all in it."""
    elements = root.elements
    topics: dict[tuple[Model | None, str], tuple[Value, Sensor]] = {}
    infos: dict[tuple[Model | None, str], tuple[Value, Sensor]] = {}
    for sensor in root.each(Sensor) if len(elements.get("sensor", ())) > 1 else ():
        value = sensor.value("topic")
        if value is None or sensor.topic in UNSAID or "$" in sensor.topic or "{" in sensor.topic:
            continue
        first, other = topics.setdefault((outermost(sensor), sensor.topic), (value, sensor))
        if other is not sensor and place(other) == place(sensor):
            continue  # it is there twice, or its link is
        if first is not value and other is not sensor:
            yield first, value, f"{sensor.title} publishes on topic `{sensor.topic}`, as {other.title} does"
        elif sensor.type in CAMERAS and (camera := sensor.find("camera")) is not None:
            given = camera.find("camera_info_topic")
            beside = f"{sensor.topic.strip('/').rpartition('/')[0]}/camera_info".lstrip("/")
            info = beside if given is None else given.content.strip("/ ")
            first, other = infos.setdefault((outermost(sensor), info), (value, sensor))
            if other is not sensor and view(other) != view(sensor):
                yield (
                    first,
                    value,
                    f"{sensor.title} publishes its calibration on `{info}`, as {other.title} does",
                )
    yield from numbered(root)


def place(sensor: Sensor) -> tuple[object, ...]:
    """The part that a sensor is on, by its name, and its own name."""
    holder = sensor.holder
    return (holder.holder, holder.name, sensor.name) if holder is not None else (sensor,)


def numbered(root: Root) -> Iterator[tuple[Value, Value, str]]:
    """The same for numbers of motors, and the first where they are not counted from 0."""
    numbers: dict[tuple[object, ...], Value] = {}
    lists: dict[tuple[object, ...], list[Value]] = {}
    for plugin in root.each(Plugin) if "<control" in root.document.source.text else ():
        yield from channels(plugin)
    for plugin in root.each(Plugin) if MOTORS.removeprefix("gz-sim-") in root.document.source.text else ():
        value = next((found for name in NUMBERS if (found := plugin.value(name)) is not None), None)
        if plugin.known is None or plugin.known.file != MOTORS or value is None or "$" in value.text:
            continue
        key = (plugin.holder, plugin.get("robotNamespace"), plugin.get("commandSubTopic"), value.text.strip())
        first_number = numbers.setdefault(key, value)
        if first_number is not value:
            yield first_number, value, f"motor number {value.text.strip()} is given before"
        lists.setdefault(key[:-1], []).append(value)
    for values in lists.values():
        count = len(values)
        if count >= FEWEST and {each.number for each in values} == set(range(1, count + 1)):
            words = f"the {count} motors have the numbers 1 to {count}, and are counted from 0"
            yield values[-1], min(values, key=lambda each: each.number), words


def channels(plugin: Plugin) -> Iterator[tuple[Value, Value, str]]:
    """The channels of an autopilot that turn two rotors; wheels and servos may share one on purpose."""
    model = plugin.within(Model)
    rotors = {
        joint.name
        for joint in (model.joints if model is not None else ())
        if joint.direction is not None and abs(joint.direction[2]) > UPRIGHT
    }
    given: dict[str, Value] = {}
    for control in plugin.children("control"):
        value, joint = control.attribute("channel"), control.find("jointName")
        if value is None or joint is None or joint.content.rpartition("::")[2] not in rotors:
            continue
        kind = control.find("type")
        first = given.setdefault(value.text.strip(), value)
        if first is not value and (kind is None or kind.content.strip() == "VELOCITY"):
            yield first, value, f"channel {value.text.strip()} is given before"


def view(sensor: Sensor) -> tuple[object, ...]:
    """Where a camera is, and what its calibration says."""
    camera, pose = sensor.find("camera"), sensor.find("pose")
    image = None if camera is None else camera.find("image")
    parts = [(camera, "horizontal_fov"), (image, "width"), (image, "height")]
    found = [parent.find(name) for parent, name in parts if parent is not None]
    values = tuple(each.own_value.number for each in found if each is not None and each.own_value is not None)
    return (sensor.link, None if pose is None else pose.content.split(), values)


def outermost(sensor: Sensor) -> Model | None:
    """The model that is in no other one; the robot in URDF."""
    if sensor.is_extension:
        return None
    model = sensor.within(Model)
    while model is not None and (outer := model.within(Model)) is not None:
        model = outer
    return model
