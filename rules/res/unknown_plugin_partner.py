from collections.abc import Iterator

from sdfcheck import (
    IN_MODEL,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Model,
    Plugin,
    Rule,
    Severity,
    Target,
    Value,
    World,
)

DETACHABLE = "gz-sim-detachable-joint-system"
AUTOPILOTS, USUAL = "ArduPilotPlugin", "imu_sensor"
ITSELF = "__model__"
CARRIER = (
    '<sdf version="1.9"><world name="w"><model name="carrier"><link name="body"/><plugin'
    f' filename="{DETACHABLE}" name="gz::sim::systems::DetachableJoint"><parent_link>body</parent_link>'
    "<child_model>{}</child_model><child_link>{}</child_link></plugin></model>"
    '<model name="payload"><link name="cover"/></model>{}</world></sdf>'
)
AUTOPILOT = (
    '<plugin name="ArduPilotPlugin" filename="ArduPilotPlugin"><imuName>{}</imuName></plugin>'
    '<link name="mast"><sensor name="imu" type="imu"/></link>'
)
MASS = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
MERGED = (
    f'<robot name="r"><link name="hull">{MASS}</link><link name="mast"/><joint name="j" type="fixed">'
    '<parent link="hull"/><child link="mast"/></joint><gazebo reference="mast"><sensor name="imu" type="imu"/></gazebo>'
    '<gazebo><plugin name="ArduPilotPlugin" filename="ArduPilotPlugin"><imuName>{}</imuName></plugin></gazebo></robot>'
)


class UnknownPluginPartner(Rule):
    """A plugin names a sensor, or a link of another model, that is not there.

    The detachable joint never attaches, and warns at each step. The plugin of ArduPilot switches itself off without its
    inertial sensor, and the vehicle never answers. A model that is not in the world may come later: its name is
    reported only if it is nearly that of a model which is there.
    """

    code = "RES024"
    name = "unknown-plugin-partner"
    severity = Severity.WARNING
    remedy = """Name what is there: a link of the child model by its plain name, a sensor as `LINK::SENSOR`.

    `gz model -m NAME -l` and `-s` list the links and sensors of a model that runs.
    """
    looks_at = (Plugin,)
    needs = ("<child_link", "<imuName", "ArduPilotPlugin")
    scaffold = "{}"

    bad = (
        Bad(
            CARRIER.format("payload", "«covers»", ""),
            fixed=CARRIER.format("payload", "cover", ""),
            unsafe=True,
            says="model `payload` has no link `covers`; did you mean `cover`?",
        ),
        Bad(
            CARRIER.format("«paylod»", "cover", ""),
            fixed=CARRIER.format("payload", "cover", ""),
            unsafe=True,
            says="world `w` has no model `paylod`; did you mean `payload`?",
        ),
        Bad(
            AUTOPILOT.format("«gyro»"),
            scaffold=IN_MODEL,
            says="model `m` has no sensor `gyro`; there is `mast::imu`",
        ),
        Bad(
            AUTOPILOT.replace("<imuName>{}</imuName>", "").replace("plugin", "«plugin»", 1),
            scaffold=IN_MODEL,
            says="has no `imuName`, and model `m` no sensor `imu_sensor`, which it takes then; there is `mast::imu`",
        ),
        Bad(AUTOPILOT.format("«tail::imu»"), scaffold=IN_MODEL, says="model `m` has no sensor `tail::imu`"),
        Bad(
            MERGED.format("«mast::imu»"),
            says="robot `r` has no sensor `mast::imu` once its links are merged; there is `hull::imu`",
        ),
    )
    good = (
        Good(CARRIER.format("payload", "cover", "")),
        Good(CARRIER.format("parcel", "cover", ""), why="a model that is spawned later"),
        Good(CARRIER.format("hook", "cover", "<include><uri>model://hook</uri></include>"), why="not known"),
        Good(AUTOPILOT.format("mast::imu"), scaffold=IN_MODEL),
        Good(AUTOPILOT.format("imu"), scaffold=IN_MODEL, why="the name is enough"),
        Good(AUTOPILOT.format("m::mast::imu"), scaffold=IN_MODEL, why="as Gazebo Classic writes it"),
        Good(MERGED.format("hull::imu")),
        Good(
            '<link name="craft::body/mast"><sensor name="imu" type="imu"/></link>'
            + AUTOPILOT.format("craft::body/mast::imu").partition("<link")[0],
            scaffold=IN_MODEL,
            why="the link of a world that Gazebo Classic wrote",
        ),
        Good(
            AUTOPILOT.replace("<imuName>{}</imuName>", "").replace('name="imu"', 'name="imu_sensor"'),
            scaffold=IN_MODEL,
        ),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return any(True for _ in unknown(plugin))

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        for value, message, meant in unknown(plugin):
            yield self.diagnostic(value, message, meant=meant)


def unknown(plugin: Plugin) -> Iterator[tuple[Target, str, str | None]]:
    """The names that lead nowhere, what is wrong with them, and the names that were probably meant."""
    model, sensor = plugin.within(Model), plugin.find("imuName")
    if model is None or plugin.known is None or plugin.known.file != DETACHABLE:
        if model is not None and sensor is not None:
            yield from unknown_sensor(sensor.own_value, model)
        elif model is not None and plugin.filename.removeprefix("lib").partition(".")[0] == AUTOPILOTS:
            yield from unnamed_sensor(plugin, model)
        return
    name, link, world = plugin.find("child_model"), plugin.find("child_link"), plugin.within(World)
    if name is None or link is None or "$" in name.content + link.content:
        return
    if name.content == ITSELF:
        yield from unknown_link(link.own_value, model)
    elif world is not None:
        child = world.resolve(name.content)
        if isinstance(child, Model):
            yield from unknown_link(link.own_value, child)
        elif child is None and not world.may_hold(name.content):
            meant = world.guess(name.content, kind="model").meant
            if meant is not None:
                yield name.own_value, f"{world.title} has no model `{name.content}`", meant


def unknown_link(value: Value, model: Model) -> Iterator[tuple[Value, str, str | None]]:
    name = value.text.strip()
    if name and model.resolve(name) is None and not model.may_hold(name):
        yield value, f"{model.title} has no link `{name}`", model.guess(name, kind="link").meant


def unknown_sensor(value: Value, model: Model) -> Iterator[tuple[Value, str, str | None]]:
    """The sensor that a plugin asks for by its name, after those of its link and models or alone."""
    name = value.text.strip()
    if not name or "$" in name or not model.is_complete:
        return
    *path, last = name.split("::")
    found, ends = list(sensors_in(model)), "::".join((*path[-1:], last))
    if not found or any(f"::{each}".endswith(f"::{ends}") for each in found):
        return
    written = {f"{link.name}::{sensor.name}" for link in model.links for sensor in link.sensors}
    merged = " once its links are merged" if model.is_urdf and ends in written else ""
    message = f"{model.title} has no sensor `{name}`{merged}"
    yield value, message + (f"; there is `{found[0]}`" if len(found) == 1 else ""), None


def unnamed_sensor(plugin: Plugin, model: Model) -> Iterator[tuple[Target, str, str | None]]:
    """The plugin of ArduPilot that names no sensor, in a model without the one that it takes then."""
    found = list(sensors_in(model)) if model.is_complete else []
    if found and not any(each.endswith(f"::{USUAL}") for each in found):
        there = f"; there is `{found[0]}`" if len(found) == 1 else ""
        words = f"and {model.title} no sensor `{USUAL}`, which it takes then{there}"
        yield plugin, f"{plugin.title} has no `imuName`, {words}", None


def sensors_in(model: Model) -> Iterator[str]:
    """The sensors in its links and in those of the models in it, after their links; of URDF as Gazebo has them."""
    links = model.as_built_by(Consumer.GAZEBO).links.values() if model.is_urdf else model.links
    yield from (f"{link.name}::{sensor.name}" for link in links for sensor in link.sensors)
    for each in model.models:
        yield from sensors_in(each)
