from collections.abc import Iterator

from sdfcheck import IN_MODEL, IN_ROBOT, Bad, Consumer, Diagnostic, Good, Link, Plugin, Rule, Severity, Value

DRIVE = (
    '<plugin name="gz::sim::systems::DiffDrive" filename="gz-sim-diff-drive-system">'
    "<left_joint>{}</left_joint><right_joint>wheel</right_joint></plugin>"
)
WHEEL = (
    '<link name="w"/><joint name="wheel" type="revolute"><parent>base</parent><child>w</child>'
    "<axis><xyz>0 1 0</xyz></axis></joint>"
)
ROS_DRIVE = (
    '<link name="w"><inertial><mass value="1"/>'
    '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>'
    '<joint name="wheel" type="{}"><parent link="base"/><child link="w"/></joint>'
    '<gazebo><plugin name="drive" filename="libgazebo_ros_diff_drive.so">'
    "<leftJoint>{}</leftJoint></plugin></gazebo>"
)
LIFT = '<plugin name="gz::sim::systems::LiftDrag" filename="gz-sim-lift-drag-system"><link_name>{}</link_name></plugin>'
MERGED = (
    '<link name="fin"/><joint name="j" type="fixed"><parent link="base"/><child link="fin"/></joint><gazebo>'
    f"{LIFT}</gazebo>"
)
POSE = (
    '<gazebo><plugin name="p" filename="libgazebo_ros_p3d.so"><bodyName>base</bodyName>'
    "<topicName>pose</topicName><frameName>{}</frameName></plugin></gazebo>"
)


class UnknownPluginReference(Rule):
    """A parameter of a plugin names a joint or link that its model does not have.

    The plugin finds nothing: it reports an error and switches itself off, or waits for ever
    in silence. Systems look among the joints and links of the model that they are in, most by plain names: they
    compare all of `model::joint` with the name of each, and find none. Of a URDF robot libsdformat merges fixed
    joints away with the links that hang on them, so that a plugin does not find those either; only in `bodyName`
    and `frameName` it writes the link that is left.
    """

    code = "RES014"
    name = "unknown-plugin-reference"
    severity = Severity.ERROR
    remedy = """Name a joint or link that the model has, of the kind that the plugin asks for.

    Use the name alone, without that of the model. Where libsdformat merges the link, name the link that is
    left, or keep the joint with
    `<gazebo reference="JOINT"><preserveFixedJoint>true</preserveFixedJoint></gazebo>`. In a macro, the
    prefix of the joint belongs here too.
    """
    looks_at = (Plugin,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            WHEEL + DRIVE.format("«wheal»"),
            fixed=WHEEL + DRIVE.format("wheel"),
            unsafe=True,
            says="`left_joint` of plugin `gz::sim::systems::DiffDrive` names joint `wheal`, which is not in "
            "model `m`; did you mean `wheel`?",
        ),
        Bad(WHEEL + DRIVE.format("«base»"), says="`base` is a link, not a joint"),
        Bad(
            ROS_DRIVE.format("fixed", "«wheel»"),
            scaffold=IN_ROBOT,
            says="joint `wheel` is fixed, and libsdformat merges it away",
        ),
        Bad(
            MERGED.format("«fin»"),
            scaffold=IN_ROBOT,
            says="link `fin` is merged into link `base`, and a plugin does not find it",
        ),
        Bad(
            '<plugin name="p" filename="libmy_thruster.so"><linkName>«bass»</linkName></plugin>',
            fixed='<plugin name="p" filename="libmy_thruster.so"><linkName>base</linkName></plugin>',
            unsafe=True,
            says="`linkName` of plugin `p` names link `bass`, which is not in model `m`; did you mean `base`?",
        ),
        Bad(
            WHEEL + DRIVE.format("«m::wheel»"),
            fixed=WHEEL + DRIVE.format("wheel"),
            unsafe=True,
            says="does not split `left_joint` at `::`, and finds no joint of this name; did you mean `wheel`?",
        ),
        Bad(
            POSE.format("«odom»"),
            scaffold=IN_ROBOT,
            says="`frameName` of plugin `p` names link `odom`, which is not in robot `r`",
        ),
        Bad(
            WHEEL + DRIVE.format("«arm::wheel»") + '<model name="arm"><link name="l"/></model>',
            says="does not split `left_joint` at `::`",
        ),
    )
    good = (
        Good(WHEEL + DRIVE.format("wheel")),
        Good(
            f"{LIFT.format('arm::wing')}<include><uri>model://not_here</uri></include>",
            why="an include that could not be read may have it",
        ),
        Good(ROS_DRIVE.format("continuous", "wheel"), scaffold=IN_ROBOT),
        Good(POSE.format("/map"), scaffold=IN_ROBOT, why="the world of Gazebo"),
        Good(MERGED.format("base"), scaffold=IN_ROBOT),
        Good(
            '<plugin name="mud" filename="libMud.so"><link_name>atlas::foot</link_name></plugin>',
            why="a plugin that is not known may look for it in another model",
        ),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return bool(plugin.unresolved or plugin.scoped or any(merged(plugin)))

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        for value, link, left in merged(plugin):
            message = f"{link.title} is merged into {left.title}, and a plugin does not find it"
            joint = link.parent_joints[0]
            advice = f"write `{left.name}`, or keep joint `{joint.name}` with `<preserveFixedJoint>`"
            yield self.diagnostic(value, message, labels={joint: "merged away"}, help=advice)
        yield from self._scoped(plugin)
        for value, kind, model, node in plugin.unresolved:
            name = value.text.strip()
            parameter = value.attribute or value.element.name
            message = f"`{parameter}` of {plugin.title} names {kind} `{name}`, which is not in {model.title}"
            meant: str | None = None
            instead: str | None = None
            cause = None
            if node is not None and node.kind == kind:
                message = f"{kind} `{name}` is fixed, and libsdformat merges it away"
                instead = "name a joint that moves, or keep this one with `<preserveFixedJoint>`"
            elif node is not None:
                message = f"`{name}` is a {node.kind}, not a {kind}, for `{parameter}` of {plugin.title}"
            else:
                meant, cause = model.guess(name, kind=kind).meant, model.fault_of(name)
            yield self.diagnostic(value, message, meant=meant, help=instead, cause=cause)

    def _scoped(self, plugin: Plugin) -> Iterator[Diagnostic]:
        for value, kind, model, node in plugin.scoped:
            parameter, plain = value.attribute or value.element.name, value.text.strip().rpartition("::")[2]
            message = f"{plugin.title} does not split `{parameter}` at `::`, and finds no {kind} of this name"
            own = node is not None and node.kind == kind and node.holder is model
            advice = None if own else f"put the plugin into the model that has {kind} `{plain}`"
            yield self.diagnostic(
                value, message, meant=plain if own else None, help=advice, severity=Severity.WARNING
            )


def merged(plugin: Plugin) -> Iterator[tuple[Value, Link, Link]]:
    """In URDF: the names of links that libsdformat merges into others, that link, and the link that is left."""
    links = [found for found in plugin.references if found.kind == "link"] if plugin.is_extension else ()
    for value, _, _, node in links:
        if not isinstance(node, Link) or not node.is_urdf:
            continue
        built = node.model.as_built_by(Consumer.GAZEBO)
        left = built.base(node)
        if left is not node and value.element not in built.rewritten(plugin):
            yield value, node, left
