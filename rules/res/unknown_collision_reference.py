from collections.abc import Iterator

from sdfcheck import (
    IN_LINK,
    IN_MODEL,
    IN_WORLD,
    Bad,
    BuiltLink,
    Consumer,
    Contact,
    Diagnostic,
    GazeboBlock,
    Good,
    Gripper,
    Rule,
    Severity,
    State,
    Value,
    named,
    suggest_in,
    write_instead,
)

SENSOR = '<sensor name="s" type="contact"><contact><collision>{}</collision></contact></sensor>'
MASS = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
BALL = '<geometry><sphere radius="1"/></geometry>'
ROBOT = (
    f'<robot name="r"><link name="arm">{MASS}<collision name="shell">{BALL}</collision></link>'
    f'<link name="tool">{MASS}<collision>{BALL}</collision></link>'
    '<joint name="j" type="fixed"><parent link="arm"/><child link="tool"/></joint>{}</robot>'
)
DEFAULT = "__default__"
SHELL = '<collision name="shell"><geometry><sphere><radius>1</radius></sphere></geometry></collision>'


class UnknownCollisionReference(Rule):
    """A contact sensor, sound, gripper or state names a collision, link or model that is not there.

    No consumer complains. The sensor never senses, the sound never sounds, the gripper
    never grips, the state is not restored. In URDF the names are those that libsdformat gives:
    `LINK_collision`, `LINK_collision_1` and so on, and longer ones for collisions with a name and for those
    of links that fixed joints tie to the link.
    """

    code = "RES011"
    name = "unknown-collision-reference"
    severity = Severity.WARNING
    remedy = """Name a collision, link or model that is there, as the simulator will call it.

    In SDFormat it is the `name` of the `<collision>`. For a URDF, `gz sdf -p FILE` shows the names that
    libsdformat makes: mostly `LINK_collision`, and `PARENT_fixed_joint_lump__LINK_collision` for links that
    were merged.
    """
    looks_at = (Contact, Gripper, State)
    scaffold = IN_LINK

    bad = (
        Bad(
            SHELL + SENSOR.format("«shel»"),
            fixed=SHELL + SENSOR.format("shell"),
            unsafe=True,
            says="no collision `shel`, did you mean `shell`?",
        ),
        Bad(
            '<gripper name="g"><gripper_link>«finger»</gripper_link><palm_link>base</palm_link></gripper>',
            scaffold=IN_MODEL,
            says="no link `finger`",
        ),
        Bad(
            '<gripper name="g"><gripper_link>base</gripper_link><palm_link>«bass»</palm_link></gripper>',
            fixed='<gripper name="g"><gripper_link>base</gripper_link><palm_link>base</palm_link></gripper>',
            unsafe=True,
            scaffold=IN_MODEL,
            says="did you mean `base`?",
        ),
        Bad(
            '<state world_name="w"><model_state name="«cart»"/></state>',
            scaffold=IN_WORLD,
            says="world `w` has no model `cart`",
        ),
        Bad(
            '<state world_name="w"><model name="«cart»"/></state>',
            scaffold='<sdf version="1.9"><world name="w">{}</world></sdf>',
            says="world `w` has no model `cart`",
        ),
        Bad('<state world_name="«v»"/>', scaffold=IN_WORLD, says="has no world `v`"),
        Bad(
            f'<gazebo reference="arm">{SENSOR.format("«hull»")}</gazebo>',
            scaffold=ROBOT,
            says="no collision of link `arm` will be called `hull` in Gazebo, but "
            "`arm_fixed_joint_lump__shell_collision` and `arm_fixed_joint_lump__tool_collision_1`",
        ),
        Bad(
            f'<gazebo reference="tool">{SENSOR.format("«tool_collision»")}</gazebo>',
            fixed=f'<gazebo reference="tool">{SENSOR.format("arm_fixed_joint_lump__tool_collision_1")}</gazebo>',
            unsafe=True,
            scaffold=ROBOT,
            says="did you mean `arm_fixed_joint_lump__tool_collision_1`?",
        ),
    )
    good = (
        Good(SHELL + SENSOR.format("shell")),
        Good(SHELL + SENSOR.format(" shell "), why="spaces around a name are not part of it"),
        Good(SHELL + SENSOR.format("__default__"), why="the word for nothing in particular"),
        Good(SHELL + SENSOR.format("m::base::shell"), why="consumers differ in how they spell scopes"),
        Good(
            '<gripper name="g"><gripper_link>base</gripper_link><palm_link>base</palm_link></gripper>',
            scaffold=IN_MODEL,
        ),
        Good(
            f'<gazebo reference="tool">{SENSOR.format("arm_fixed_joint_lump__tool_collision_1")}</gazebo>',
            why="as libsdformat calls it",
            scaffold=ROBOT,
        ),
    )

    @staticmethod
    def applies(part: Contact | Gripper | State) -> bool:
        return bool(part.unresolved or (isinstance(part, Contact) and misnamed(part)))

    def check(self, part: Contact | Gripper | State) -> Iterator[Diagnostic]:
        for value, link in misnamed(part) if isinstance(part, Contact) else ():
            called = [collision.name for collision in link.collisions]
            message = f"no collision of {link.origin.title} will be called `{value.text.strip()}` in Gazebo"
            meant = built_name(value.text.strip(), link)
            if meant is None and called:
                message += f", but {named(called, most=3)}"
            yield self.diagnostic(value, message, meant=meant)
        for value, kind, scope, names in part.unresolved:
            message = f"{scope.title} has no {kind} `{value.text}`"
            near = suggest_in(part.document, value.text, names)
            if near is not None:
                message += f", did you mean `{near}`?"
            yield self.diagnostic(value, message, fix=write_instead(near, value))


def misnamed(contact: Contact) -> list[tuple[Value, BuiltLink]]:
    """In URDF: the names that no collision of the link will have which Gazebo has in the end, and that link."""
    block = contact.holder.holder if contact.holder is not None else None
    if not isinstance(block, GazeboBlock) or block.link is None or not block.link.model.is_complete:
        return []
    built = block.model.as_built_by(Consumer.GAZEBO)
    link = built.links.get(built.base(block.link).name)
    if link is None:
        return []
    names = {"", DEFAULT, *(collision.name for collision in link.collisions)}
    return [
        (value, link)
        for value in contact.collision_names
        if value.text.strip() not in names and "::" not in value.text and "$" not in value.text
    ]


def built_name(name: str, link: BuiltLink) -> str | None:
    """The name that the collision gets which the description, or libsdformat without merging, calls so."""
    for collision in link.collisions:
        shape = collision.origin
        own = shape.link.collisions.index(shape)
        alone = f"{shape.link.name}_collision" + (f"_{own}" if own else "")
        if name in {shape.name, alone} - {""}:
            return collision.name
    return None
