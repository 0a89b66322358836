from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Model, Plugin, Rule, Severity, Value

WHEEL = (
    '<link name="wheel"/><joint name="axle" type="revolute"><parent>base</parent><child>wheel</child>'
    "<axis><xyz>0 1 0</xyz></axis></joint>"
)
IN_SDF = (
    f'<sdf version="1.9"><model name="m">{{}}<link name="base"/>{WHEEL}'
    '<plugin filename="gz-sim-joint-position-controller-system" name="gz::sim::systems::JointPositionController">'
    "<joint_name>axle</joint_name></plugin></model></sdf>"
)
IN_URDF = (
    '<robot name="r"><link name="base"/><link name="arm"/><joint name="axle" type="continuous"><parent link="base"/>'
    '<child link="arm"/><axis xyz="0 1 0"/></joint><gazebo>{}<plugin'
    ' filename="gz-sim-joint-position-controller-system" name="gz::sim::systems::JointPositionController">'
    "<joint_name>axle</joint_name></plugin></gazebo></robot>"
)
MOVERS = frozenset(
    f"gz-sim-{name}-system"
    for name in """
    ackermann-steering diff-drive elevator joint-controller joint-position-controller joint-trajectory-controller
    mecanum-drive multicopter-control multicopter-motor-model thruster tracked-vehicle trajectory-follower
    velocity-control
    """.split()
)
"""The systems that do nothing but move the model that they are in, or its joints."""


class DrivenStaticModel(Rule):
    """A plugin is to move a model that is static.

    A static model stands where it was put: forces, velocities and commands for its joints change nothing, and the
    plugin waits in silence. Often `static` was switched on to look at the model, and stayed.
    """

    code = "GAZ021"
    name = "driven-static-model"
    severity = Severity.WARNING
    remedy = """Remove `<static>true</static>`, or the plugin.

    To hold the base of a robot whose joints move, write a fixed joint from `world` to it.
    """
    looks_at = (Plugin,)
    scaffold = IN_SDF

    bad = (
        Bad(
            "<static>«true»</static>",
            says="model `m` is static, and plugin `gz::sim::systems::JointPositionController` is to move it",
            also=("DRK008",),
        ),
        Bad(
            "<static>«true»</static>",
            scaffold=IN_URDF,
            says="robot `r` is static, and plugin `gz::sim::systems::JointPositionController` is to move it",
        ),
    )
    good = (
        Good(""),
        Good("<static>false</static>"),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        model, facts = plugin.within(Model), plugin.known
        return model is not None and facts is not None and facts.file in MOVERS and model.is_static

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        model = plugin.within(Model)
        assert model is not None
        message = f"{model.title} is static, and {plugin.title} is to move it"
        value = model.value("static") if not model.is_urdf else static_of(model)
        where = plugin if value is None else value
        yield self.diagnostic(where, message, labels={plugin: "moves nothing"} if value is not None else {})


def static_of(robot: Model) -> Value | None:
    """The setting of a robot of URDF."""
    blocks = robot.blocks_by_reference.get("", ())
    return next((static.own_value for block in blocks for static in block.children("static")), None)
