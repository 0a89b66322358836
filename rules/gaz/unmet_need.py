from collections.abc import Iterator

from sdfcheck import IN_WORLD, Bad, Diagnostic, Good, Plugin, Root, Rule, Sensor, Severity, Target, World

PLACE = "add `<spherical_coordinates>` to the world"
FLUID = "add `gz-sim-buoyancy-system` to the plugins of the world"
BLOWN = "add `<enable_wind>true</enable_wind>` to what the wind is to move"
LOST = {"navsat": "reports nothing", "gps": "reports nothing"}
"""How sensors go on in a world without a place on the earth."""
GROUNDED = "add a static model with a plane, such as that of `model://ground_plane`"
DRIVES = frozenset(f"gz-sim-{name}-system" for name in ("diff-drive", "ackermann-steering", "mecanum-drive"))
GZ_SIM = "gz-sim"
PHYSICS = '<plugin filename="gz-sim-physics-system" name="gz::sim::systems::Physics"/>'
GPS = '<model name="m"><link name="l"><inertial><mass>1</mass></inertial><{} name="s" type="navsat"/></link></model>'
BOAT = (
    '<model name="m"><link name="l"><inertial><mass>1</mass></inertial></link>'
    '<{} filename="gz-sim-hydrodynamics-system" name="gz::sim::systems::Hydrodynamics">'
    "<link_name>l</link_name></plugin></model>"
)
BUOYANCY = '<plugin filename="gz-sim-buoyancy-system" name="gz::sim::systems::Buoyancy"/>'
GROUND = (
    '<model name="g"><static>true</static><link name="l"><collision name="c"><geometry><{}><uri>h.png</uri></heightmap>'
    "</geometry></collision></link></model>"
)
WIND = (
    '<{} filename="gz-sim-wind-effects-system" name="gz::sim::systems::WindEffects"/>'
    '<model name="balloon">{}<link name="l"><inertial><mass>1</mass></inertial></link></model>'
)
ROVER = (
    '<model name="m"><link name="l"><collision name="c"><geometry><sphere><radius>0.1</radius></sphere></geometry>'
    '</collision></link><link name="w"/><link name="v"/><joint name="j" type="revolute"><parent>l</parent>'
    "<child>w</child><axis><xyz>0 1 0</xyz></axis></joint>"
    '<joint name="k" type="revolute"><parent>l</parent><child>v</child><axis><xyz>0 1 0</xyz></axis></joint>'
    '<{} filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive"><left_joint>j</left_joint>'
    "<right_joint>k</right_joint></plugin></model>"
)
FLOOR = GROUND.replace("<{}><uri>h.png</uri></heightmap>", "<plane><normal>0 0 1</normal></plane>")
ROBOT = (
    '<robot name="r"><link name="base"/><link name="a"/><link name="b"/>'
    + "".join(
        f'<joint name="{each}_joint" type="continuous"><parent link="base"/><child link="{each}"/>'
        '<axis xyz="0 1 0"/></joint>'
        for each in "ab"
    )
    + '<gazebo><{} filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive">'
    "<left_joint>a_joint</left_joint><right_joint>b_joint</right_joint></plugin></gazebo></robot>"
)
LAUNCH = (
    'Node(package="ros_gz_sim", executable="create", arguments=["-file", "robot.urdf"])\n'
    'gz = {"gz_args": "-r yard.sdf"}\n'
)
COMMANDS = '<plugin filename="gz-sim-user-commands-system" name="gz::sim::systems::UserCommands"/>'
EYE = (
    '<model name="eye"><static>true</static><link name="l"><{} name="s" type="segmentation"><camera/></sensor></link>'
    "</model>"
    '<model name="box"><link name="l"/>{}</model>'
)
LABEL = '<plugin filename="gz-sim-label-system" name="gz::sim::systems::Label"><label>1</label></plugin>'
LABELED = frozenset(("boundingbox", "boundingbox_camera", "segmentation", "segmentation_camera"))
UNLABELED = "add `gz-sim-label-system` to what the camera is to tell apart"
COMMANDED = "add `gz-sim-user-commands-system` to the plugins of the world"
DETECTOR = '<physics type="ode"><dart><collision_detector>bullet</collision_detector></dart></physics>'


def files(content: str) -> dict[str, str]:
    """A launch file that creates a robot in a world."""
    return {
        "sim.launch.py": LAUNCH,
        "yard.sdf": f'<sdf version="1.9"><world name="yard">{content}</world></sdf>',
    }


class UnmetNeed(Rule):
    """Something in a world of Gazebo needs what the world does not have.

    A navsat sensor needs `spherical_coordinates`, without which it has no position to report; for a magnetometer
    Gazebo works out the field at that place, and warns at each step where it has none. The WindEffects system needs
    a model or link with `enable_wind`, without which it moves nothing, and a robot on wheels something to stand on,
    also one that a launch file creates in a world of the project: before gz-sim 9 this takes the system for user
    commands, if the world lists any. Cameras for segmentation and bounding boxes see nothing but what has a label.
    Hydrodynamics needs the Buoyancy system: without it the vessel sinks. A heightmap to collide with needs the
    collision detector `bullet`: that of the engine by default does not know heightmaps, and everything falls
    through.
    """

    code = "GAZ014"
    name = "unmet-need"
    severity = Severity.WARNING
    remedy = """Choose the collision detector `bullet` in the `<physics>` of the world, or add what it lacks.

    - A navsat sensor or magnetometer: `<spherical_coordinates>` with `surface_model`, `latitude_deg`,
      `longitude_deg`, `elevation` and `heading_deg`.
    - A robot on wheels: a static model with a plane, or an include of one.
    - Wind: `<enable_wind>true</enable_wind>` in the models or links that it is to move.
    - A robot that is created: `gz-sim-user-commands-system` in the world.
    - A camera for segmentation: `gz-sim-label-system` with a `<label>` in models, links or visuals.
    - Hydrodynamics: a plugin `gz-sim-buoyancy-system` with
      `<uniform_fluid_density>1000</uniform_fluid_density>` or graded layers.
    - A heightmap: `<physics><dart><collision_detector>bullet</collision_detector></dart></physics>`.
    """
    looks_at = (World, Root)
    scaffold = IN_WORLD

    bad = (
        Bad(
            PHYSICS + GPS.replace("{}", "«sensor»"),
            says="sensor `s` reports nothing: world `w` has no `spherical_coordinates`",
        ),
        Bad(
            PHYSICS + GPS.replace("{}", "«sensor»").replace("navsat", "magnetometer"),
            says="sensor `s` reports no field of a place: world `w` has no `spherical_coordinates`",
        ),
        Bad(
            PHYSICS + BOAT.replace("{}", "«plugin»"),
            says="the vessel sinks: world `w` has no Buoyancy system",
        ),
        Bad(
            PHYSICS + WIND.format("«plugin»", ""),
            says="moves nothing: no model or link of world `w` has `enable_wind`",
        ),
        Bad(
            PHYSICS + ROVER.replace("{}", "«plugin»"),
            says="model `m` falls: nothing in world `w` is there to stand on",
        ),
        Bad(
            PHYSICS + EYE.format("«sensor»", ""),
            says="sensor `s` sees nothing: nothing in world `w` has a label",
        ),
        Bad(
            ROBOT.format("«plugin»"),
            scaffold="{}",
            file="robot.urdf",
            files=files(PHYSICS + COMMANDS),
            says="robot `r` falls: nothing in world `yard` of `yard.sdf` is there to stand on",
        ),
        Bad(
            ROBOT.format("plugin").replace("robot", "«robot»", 1),
            scaffold="{}",
            file="robot.urdf",
            files=files(PHYSICS + FLOOR),
            says="`sim.launch.py` cannot create the robot: world `yard` in `yard.sdf` lists systems of Gazebo, but not",
        ),
        Bad(
            PHYSICS + GROUND.replace("{}", "«heightmap»"),
            says="collides with nothing: world `w` does not choose the collision detector `bullet`",
        ),
    )
    good = (
        Good(
            PHYSICS
            + "<spherical_coordinates><latitude_deg>1</latitude_deg></spherical_coordinates>"
            + GPS.replace("{}", "sensor")
        ),
        Good(
            PHYSICS
            + "<magnetic_field>5e-6 2e-5 -4e-5</magnetic_field>"
            + GPS.replace("{}", "sensor").replace("navsat", "magnetometer"),
            why="the world has its own field",
        ),
        Good(PHYSICS + BUOYANCY + BOAT.replace("{}", "plugin")),
        Good(PHYSICS + WIND.format("plugin", "<enable_wind>true</enable_wind>")),
        Good(PHYSICS + WIND.format("plugin", "<static>true</static>"), why="the model comes later"),
        Good(PHYSICS + ROVER.replace("{}", "plugin") + FLOOR),
        Good(PHYSICS + EYE.format("sensor", LABEL)),
        Good(
            ROBOT.format("plugin"), scaffold="{}", file="robot.urdf", files=files(PHYSICS + COMMANDS + FLOOR)
        ),
        Good(
            ROBOT.format("plugin"),
            scaffold="{}",
            file="robot.urdf",
            files=files(FLOOR),
            why="Gazebo brings its own systems",
        ),
        Good(PHYSICS + DETECTOR + GROUND.replace("{}", "heightmap")),
        Good(GROUND.replace("{}", "heightmap"), why="nothing says that the world is for the new Gazebo"),
    )

    @staticmethod
    def applies(part: World | Root) -> bool:
        if isinstance(part, Root):
            return next(created(part), None) is not None
        return is_of_gz_sim(part) and next(needs(part), None) is not None

    def check(self, part: World | Root) -> Iterator[Diagnostic]:
        for target, words, advice in created(part) if isinstance(part, Root) else needs(part):
            span = part.launched_world.span if isinstance(part, Root) and part.launched_world else None
            labels = {span: "created here"} if span is not None else None
            yield self.diagnostic(target, words, help=advice, labels=labels)


def created(root: Root) -> Iterator[tuple[Target, str, str | None]]:
    """The things that a robot needs and the world lacks in which a launch file creates it."""
    found = root.launched_world
    if found is None:
        return
    world = f"world `{found.name}`"
    if found.systems and "user-commands" not in found.systems:
        file = found.span.source.path.name
        words = f"{world} in `{found.file}` lists systems of Gazebo, but not user commands"
        yield root.element, f"`{file}` cannot create the robot: {words}", COMMANDED
    if found.is_bare:
        drive = next((each for each in root.each(Plugin) if each.known and each.known.file in DRIVES), None)
        if drive is not None and drive.drive is not None:
            words = f"nothing in {world} of `{found.file}` is there to stand on"
            yield drive, f"robot `{root.models[0].name}` falls: {words}", GROUNDED


def is_of_gz_sim(world: World) -> bool:
    """Does a world list a system of the new Gazebo?"""
    return any(plugin.known is not None and plugin.known.generation == GZ_SIM for plugin in world.plugins)


def needs(world: World) -> Iterator[tuple[Target, str, str | None]]:
    """The first thing of each kind that needs what the world lacks, the words for it, and a help of its own."""
    root = world.root
    if not world.has("spherical_coordinates"):
        kinds = (
            LOST if world.has("magnetic_field") else LOST | {"magnetometer": "reports no field of a place"}
        )
        for sensor in root.each(Sensor):
            if sensor.type in kinds and sensor.within(World) is world:
                words = f"{world.title} has no `spherical_coordinates`"
                yield sensor, f"{sensor.title} {kinds[sensor.type]}: {words}", PLACE
                break
    plugins = [plugin for plugin in root.each(Plugin) if plugin.known is not None]
    names = {plugin.known.file for plugin in plugins if plugin.known is not None}
    if (
        "gz-sim-buoyancy-system" not in names
        and "gz-sim-buoyancy-engine-system" not in names
        and world.is_complete
    ):
        for plugin in plugins:
            is_fluid = plugin.known is not None and plugin.known.file == "gz-sim-hydrodynamics-system"
            if is_fluid and plugin.within(World) is world:
                yield plugin, f"the vessel sinks: {world.title} has no Buoyancy system", FLUID
                break
    yield from unlabeled(world, names)
    yield from windless(world, plugins)
    yield from groundless(world, plugins)
    chosen = {element.content for element in root.elements.get("collision_detector", ())}
    if not chosen and not any(
        "physics" in plugin.filename and "engine" in text(plugin) for plugin in world.plugins
    ):
        for heightmap in root.elements.get("heightmap", ()):
            around = {element.name for element in heightmap.around}
            if "collision" in around and root.scope_of(heightmap) is not None:
                words = (
                    f"collides with nothing: {world.title} does not choose the collision detector `bullet`"
                )
                yield heightmap, f"the heightmap {words}", None
                break


def unlabeled(world: World, names: set[str]) -> Iterator[tuple[Target, str, str]]:
    """The first camera that sees labels alone, in a world where nothing has one."""
    said = world.root.document.source.text
    if "gz-sim-label-system" in names or "label-system" in said or "<include" in said:
        return
    for sensor in world.root.each(Sensor):
        if sensor.type in LABELED and sensor.within(World) is world:
            yield sensor, f"{sensor.title} sees nothing: nothing in {world.title} has a label", UNLABELED
            break


def windless(world: World, plugins: list[Plugin]) -> Iterator[tuple[Target, str, str]]:
    """The plugin for the wind, where no model may feel it; those with plugins may have their own way to."""
    models = [model for model in world.models if not model.may_be_static]
    if not models or not world.is_complete or any(model.plugins for model in models):
        return
    if any(part.has("enable_wind") for model in models for part in (model, *model.links)):
        return
    for plugin in plugins:
        if (
            plugin.known is not None
            and plugin.known.file == "gz-sim-wind-effects-system"
            and plugin.holder is world
        ):
            yield plugin, f"moves nothing: no model or link of {world.title} has `enable_wind`", BLOWN


def groundless(world: World, plugins: list[Plugin]) -> Iterator[tuple[Target, str, str]]:
    """The drive of a robot beside which nothing in the world collides."""
    bodies = [model for model in world.models if any(link.collisions for link in model.links)]
    gravity = world.find("gravity")
    if len(bodies) != 1 or not world.is_complete or gravity is not None:
        return
    for plugin in plugins:
        if plugin.known is not None and plugin.known.file in DRIVES and plugin.holder is bodies[0]:
            yield plugin, f"{bodies[0].title} falls: nothing in {world.title} is there to stand on", GROUNDED


def text(plugin: Plugin) -> str:
    """The names of its parameters."""
    return " ".join(parameter.name for parameter in plugin.parameters)
