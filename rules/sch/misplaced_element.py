from collections.abc import Iterator

from sdfcheck import (
    IN_JOINT,
    IN_LINK,
    IN_ROBOT,
    SDF,
    Bad,
    Diagnostic,
    Element,
    Fix,
    Good,
    Root,
    Rule,
    Severity,
    named,
    problems,
    rename,
    rewrite,
    used,
)

COLORS = ("ambient", "diffuse")
RECORD = "link_state"
SHOWN = 3
"""Names that a message lists."""


class MisplacedElement(Rule):
    """A standard element is where its parent does not allow it.

    Consumers look for an element in its place only. libsdformat warns and ignores a
    misplaced one, so the mass, the pose or the friction that it gives is the default
    instead. Only an `<include>` is followed wherever it is, and gets a warning.
    """

    code = "SCH003"
    name = "misplaced-element"
    severity = Severity.ERROR
    remedy = """Move what is misplaced into the element that the message names.

    `sdfcheck describe link/inertial` and the like say what an element holds. For an element of your own,
    use a declared prefix.
    """
    explains = (problems.MisplacedElement,)
    scaffold = IN_LINK

    bad = (
        Bad("<«mass»>2</mass>", says="does not belong in link `base`; it goes into `inertial`"),
        Bad("<«static»>true</static>", says="it goes into `model`"),
        Bad(
            "<inertial><mass>1</mass><«ixx»>1</ixx><iyy>1</iyy><izz>1</izz><ixy>0</ixy></inertial>",
            says="`ixx`, `iyy`, `izz` and 1 more do not belong in `inertial`; they go into `inertia`",
        ),
        Bad(
            '<«joint» name="i" type="ball"/><joint name="j" type="ball"/>',
            says="`joint` (used 2 times) does not belong in link `base`; it goes into",
        ),
        Bad(
            '<sensor name="s" type="camera"><camera><noise><«precision»>2</precision></noise></camera></sensor>',
            says="`precision` does not belong in `noise` of `camera`, but in that of other elements",
        ),
        Bad(
            "<axis><«xy»>0 0 1</xy></axis>",
            scaffold=IN_JOINT,
            fixed="<axis><xyz>0 0 1</xyz></axis>",
            unsafe=True,
            says="`xy` does not belong in `axis`; did you mean `xyz`?",
        ),
        Bad("<«wrench»>0 0 0 0 0 0</wrench>", says="it goes into `link_state`"),
        Bad(
            "<«laser_retro»>0</laser_retro><max_contacts>4</max_contacts><geometry/>",
            says="`laser_retro`, `max_contacts` and `geometry` do not belong in link `base`; they go into `collision`",
        ),
        Bad(
            '<sensor name="s" type="imu"><imu><angular_velocity><«noise»/></angular_velocity></imu></sensor>',
            says="it goes into `x`, `y` or `z`",
        ),
        Bad(
            '<world name="w"><model name="m"><link name="l"/></model><state world_name="w"><model name="m">'
            "<«static»>1</static></model></state></world>",
            scaffold=SDF.replace("1.12", "1.6"),
            says="`static` does not belong in the state of model `m`",
        ),
        Bad(
            "<«include»><uri>https://fuel.gazebosim.org/1.0/openrobotics/models/arm</uri></include>",
            scaffold=SDF,
            says="it goes into `model` or `world`",
        ),
        Bad(
            '<visual name="v"><geometry><box><size>1 1 1</size></box></geometry>'
            '<material><«color» rgba="0 0 1 1"/></material></visual>',
            fixed='<visual name="v"><geometry><box><size>1 1 1</size></box></geometry>'
            "<material><ambient>0 0 1 1</ambient><diffuse>0 0 1 1</diffuse></material></visual>",
            unsafe=True,
            says="which has `diffuse` and `ambient` in SDFormat",
        ),
        Bad(
            '<gazebo reference="base"><«mu»>0.2</mu></gazebo>',
            fixed='<gazebo reference="base"><mu1>0.2</mu1></gazebo>',
            unsafe=True,
            scaffold=IN_ROBOT,
            says="`mu` does not belong in `gazebo`; did you mean `mu1`?",
        ),
        Bad(
            '<gazebo reference="base"><«plugin» name="p" filename="f"/></gazebo>',
            scaffold=IN_ROBOT,
            says="becomes a plugin of `base`, which Gazebo does not load",
        ),
        Bad(
            '<sdf version="1.12"><model name="m"><link name="wall"><«name»>wall</name></link></model></sdf>',
            scaffold="{}",
            says="`name` is an attribute of link `wall`, which has this value",
        ),
    )
    good = (
        Good("<inertial><mass>2</mass></inertial>"),
        Good(
            '<p:mass xmlns:p="https://example.org/p">2</p:mass>',
            why="a custom element is free to be anywhere",
        ),
        Good(
            '<sensor name="s" type="custom"><plugin filename="p" name="p"><mass>2</mass></plugin></sensor>',
            why="the content of a plugin is the plugin's",
        ),
        Good(
            '<sdf version="1.12">\n<model name="m">\n  <link name="a">\n  <inertial/>\n  <self_collide/>\n'
            "</model></sdf>",
            scaffold="{}",
            why="syntax-error says that the link is not closed",
        ),
        Good(
            '<sdf version="1.12"><model name="m"><link name="a"/><frame name="f"/></model>'
            '<frame name="g"/><joint name="j" type="fixed"><parent>a</parent><child>world</child></joint>'
            "</model></sdf>",
            scaffold="{}",
            why="syntax-error says that the model ends twice",
        ),
        Good(
            "<type>crate</type>",
            why="unknown-element owns a word that no `type` of the format may be: it is somebody's own",
        ),
        Good("<contact><lateral_friction>1</lateral_friction></contact>", why="PyBullet reads it"),
    )

    def check(self, problem: problems.MisplacedElement) -> Iterator[Diagnostic]:
        element, parent = problem.element, problem.parent
        if element.name == "plugin" and parent.name == "gazebo":
            about = parent.attributes.get("reference", "")
            yield self.diagnostic(
                element,
                f"a plugin in a block about `{about}` becomes a plugin of `{about}`, which Gazebo does not load",
                help="drop `reference` for a plugin of the robot; a plugin of a sensor goes into its `sensor`",
            )
            return
        if (element.name, parent.name) == ("color", "material"):
            message = "`color` does not belong in `material`, which has `diffuse` and `ambient` in SDFormat"
            yield self.diagnostic(element, message, fix=as_colors(element, parent))
        elif not problem.others and element.content and element.name in parent.attributes:
            same = "this value" if parent.attributes[element.name] == element.content else "another value"
            message = f"`{element.name}` is an attribute of {parent.title}, which has {same}"
            yield self.diagnostic(element, message, severity=Severity.WARNING)
        elif problem.ignored:
            # The recorded state of a link, copied into the model, makes no other robot of it; nor does a default.
            is_recorded = (parent.name == "link" and RECORD in problem.places) or in_state(parent)
            severity = Severity.WARNING if is_recorded or problem.is_default else self.severity
            fix = rename(problem.suggestion, element)
            cause = element.document.view(Root).part_of(parent).misnamed("reference")
            yield self.diagnostic(element, misplaced(problem), fix=fix, severity=severity, cause=cause)
        else:
            message = f"{misplaced(problem)}; libsdformat follows it anyway"
            yield self.diagnostic(element, message, severity=Severity.WARNING)


def misplaced(problem: problems.MisplacedElement) -> str:
    """Elements in the wrong place, and where they go."""
    names = list(dict.fromkeys(each.name for each in (problem.element, *problem.others)))
    count = len(problem.others) + 1 if len(names) == 1 else 1
    title = f"the state of {problem.parent.title}" if in_state(problem.parent) else problem.parent.title
    do, they, go = ("does", "it", "goes") if len(names) == 1 else ("do", "they", "go")
    message = f"{named(names, most=SHOWN)}{used(count)} {do} not belong in {title}"
    if problem.suggestion is not None:
        return f"{message}; did you mean `{problem.suggestion}`?"
    around = problem.parent.parent
    if problem.places == (problem.parent.name,) and around is not None:
        return f"{message} of {around.title}, but in that of other elements"
    return f"{message}; {they} {go} into {named(problem.places, 'or', most=SHOWN)}"


def in_state(element: Element) -> bool:
    """Is it recorded, in the state of a world?"""
    return any(around.name == "state" for around in element.around)


def as_colors(color: Element, material: Element) -> Fix | None:
    """The fix that writes the `color` of URDF as SDFormat does, where the material has no color."""
    rgba = color.attributes.get("rgba")
    if rgba is None or color.nodes or any(map(material.has, COLORS)):
        return None
    return rewrite(
        "write `ambient` and `diffuse`", {color: "".join(f"<{name}>{rgba}</{name}>" for name in COLORS)}
    )
