from collections.abc import Iterator

from sdfcheck import (
    IN_MODEL,
    REFUSES,
    Bad,
    BuiltLink,
    Consumer,
    Diagnostic,
    Element,
    Good,
    Name,
    Reaction,
    Root,
    Rule,
    Sensor,
    Severity,
    accepts,
    refuses,
)
from sdfcheck_rules.nam.taken import is_free

LEFT_OUT = (
    '<robot name="r"><link name="a"><inertial><mass value="1"/>'
    '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link><link name="b"/>'
    '<joint name="j" type="continuous"><parent link="a"/><child link="b"/></joint>'
    '<gazebo><joint name="j" type="fixed"><parent>world</parent><child>a</child></joint></gazebo></robot>'
)

MERGED = (
    '<link name="a"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
    '</link><link name="b"/><joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>'
    '<gazebo reference="a"><sensor name="s" type="imu"/></gazebo>'
    '<gazebo reference="b"><sensor name="{}" type="imu"/></gazebo>'
)
UNAWARE = (Consumer.DRAKE, Consumer.URDFDOM, Consumer.MUJOCO)
"""The consumers that do not read `<gazebo>` blocks."""


UNNAMED = "default_physics"
IN_LINKS = dict.fromkeys((Consumer.ISAAC, Consumer.PYBULLET), REFUSES)
IN_MATERIALS = {
    Consumer.ISAAC: REFUSES,
    Consumer.MUJOCO: accepts("takes both"),
    Consumer.PYBULLET: accepts("takes both"),
}
IN_JOINTS = {**IN_MATERIALS, Consumer.PYBULLET: refuses("crashes")}


class DuplicateName(Rule):
    """Two siblings of one kind have the same name.

    Nothing can tell them apart: libsdformat refuses the document, and of two joints or
    links only the first would ever be found. Names are unique in their model or world;
    another model may use them again. Sensors of links that libsdformat merges become siblings.
    """

    code = "NAM001"
    name = "duplicate-name"
    severity = Severity.ERROR
    remedy = """Rename one of them and the references that mean it, or remove one of two that are alike.

    Editors with the language server of sdfcheck rename both at once. For two copies of a part use a prefix
    in a macro of xacro, or a nested model for each, which has a scope of its own.
    """
    looks_at = (Root,)
    scaffold = IN_MODEL

    bad = (
        Bad('<link name="«base»"/>', says="there is another link `base` in model `m`"),
        Bad(
            '<world name="w"><include><uri>https://fuel.gazebosim.org/1.0/openrobotics/models/a</uri><name>a</name></include>'
            "<include><uri>https://fuel.gazebosim.org/1.0/openrobotics/models/b</uri><name>«a»</name></include></world>",
            scaffold='<sdf version="1.12">{}</sdf>',
            says="there is another model `a` in world `w`",
        ),
        Bad('<world name="a"/><world name="«a»"/>', scaffold='<sdf version="1.12">{}</sdf>'),
        Bad(
            '<world name="w"><physics type="ode"/><«physics» type="bullet"/></world>',
            scaffold='<sdf version="1.12">{}</sdf>',
            says="there is another `physics` in world `w`, and both are called `default_physics`",
        ),
        Bad(
            MERGED.replace("{}", "«s»"),
            scaffold='<robot name="r">{}</robot>',
            says="there is another sensor `s` in link `a`, with which libsdformat merges this one",
        ),
        Bad(
            MERGED.replace('reference="a"', 'reference="b"').replace("{}", "«s»"),
            scaffold='<robot name="r">{}</robot>',
            says="there is another sensor `s` in link `b`",
        ),
    )
    good = (
        Good(MERGED.replace("{}", "t"), scaffold='<robot name="r">{}</robot>'),
        Good('<model name="n"><link name="base"/></model>', why="another model is another scope"),
        Good(
            '<plugin name="p" filename="a"/><plugin name="p" filename="b"/>',
            why="the names of plugins are free",
        ),
        Good(
            '<link name="arm"/><joint name="j" type="ball"><parent>base</parent><child>arm</child>'
            "<physics/><physics/></joint>",
            why="the settings of a joint have no name",
        ),
        Good(
            LEFT_OUT, why="libsdformat leaves the joint out with its child, which has no mass", scaffold="{}"
        ),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return any(
            first.kind == later.kind and not is_free(first, later, root) for first, later in root.names.shared
        ) or bool(merged_sensors(root) or unnamed_physics(root))

    def check(self, root: Root) -> Iterator[Diagnostic]:
        for first, later in root.names.shared:
            if first.kind != later.kind or is_free(first, later, root):
                continue
            where = "the file" if later.parent.name == "sdf" else later.parent.title
            yield self.diagnostic(
                later.value,
                f"there is another {later.kind} `{later.name}` in {where}",
                labels={first.value: "the first one"},
                affects=_affects(first, later),
            )
        for world, first_physics, physics in unnamed_physics(root):
            yield self.diagnostic(
                physics,
                f"there is another `physics` in {world.title}, and both are called `{UNNAMED}`",
                labels={first_physics: "the first one"},
                help="keep one of them, or give each a name",
            )
        for link, first_sensor, sensor in merged_sensors(root):
            yield self.diagnostic(
                sensor.name_value or sensor,
                f"there is another sensor `{sensor.name}` in {link.origin.title}, with which libsdformat merges"
                " this one",
                labels={first_sensor.name_value or first_sensor: "the first one"},
                affects=dict.fromkeys(UNAWARE, accepts("does not read it")),
            )


def unnamed_physics(root: Root) -> list[tuple[Element, Element, Element]]:
    """The `physics` without a name of which a world has one already, each after the world and the first one."""
    found: list[tuple[Element, Element, Element]] = []
    first: dict[Element, Element] = {}
    for physics in root.elements.get("physics", ()) if not root.is_urdf else ():
        world, name = physics.parent, physics.attributes.get("name")
        if world is not None and world.name == "world" and name in {None, UNNAMED}:
            earlier = first.setdefault(world, physics)
            if earlier is not physics and name is None:
                found.append((world, earlier, physics))
    return found


def merged_sensors(root: Root) -> list[tuple[BuiltLink, Sensor, Sensor]]:
    """In URDF: sensors of one name in links that become one, each with that link and the first sensor."""
    if not root.is_urdf or len(root.elements.get("sensor", ())) < 2 or not root.models:
        return []
    found = []
    for link in root.models[0].as_built_by(Consumer.GAZEBO).links.values():
        first: dict[str, Sensor] = {}
        for sensor in link.sensors if len(link.members) > 1 else ():
            earlier = first.setdefault(sensor.name, sensor)
            if sensor.name and earlier.link is not sensor.link:
                found.append((link, earlier, sensor))
    return found


def _affects(first: Name, later: Name) -> dict[Consumer, Reaction]:
    if later.is_extension:
        return dict.fromkeys(UNAWARE, accepts("does not read it"))
    if later.kind == "link":
        return IN_LINKS
    if later.parent.name == "sensor":
        return {**IN_MATERIALS, Consumer.DRAKE: accepts("does not read it")}
    if later.kind != "joint":
        return IN_MATERIALS
    children = [element.find("child") for element in (first.value.element, later.value.element)]
    moved = {child.text_of("link") for child in children if child is not None}
    return {**IN_JOINTS, Consumer.MUJOCO: REFUSES} if len(moved) == 1 else IN_JOINTS
