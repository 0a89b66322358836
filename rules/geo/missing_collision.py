import re
from collections.abc import Iterator
from operator import ne

from sdfcheck import Bad, Diagnostic, Good, Link, Model, Rule, Semantics, Severity

NUMBER = re.compile(r"[0-9]+")
CHAIN = re.compile(r"(?i)(link|body|part|segment|arm|finger|joint|hand|right|left|[\W_])*[a-z]?")
LEAST = 5
"""Links that move and collide, so that the one without is the exception."""
FEW = 3
"""Parts that move with mass in a robot in which nothing collides: a pendulum has two."""
OFF = frozenset(("0", "false", "no"))
MASS = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
BOX = '<{0}><geometry><box size="0.1 0.1 0.1"/></geometry></{0}>'


def robot(*links: str) -> str:
    """A robot whose links hang on the first one by joints that move; each text is the name and the shapes."""
    text = ""
    for link in links:
        name, *kinds = link.split()
        mark = f'«link» name="{name}"' if name.startswith("!") else f'link name="{name}"'
        text += f"<{mark.replace('!', '')}>" + "".join(BOX.format(kind) for kind in kinds) + "</link>"
    first = links[0].split()[0].strip("!")
    for number, link in enumerate(links[1:]):
        child = link.split()[0].strip("!")
        text += f'<joint name="j{number}" type="continuous"><parent link="{first}"/><child link="{child}"/></joint>'
    return f'<robot name="r">{text}</robot>'


WHEEL = (
    '<{0} name="{1}"><pose>0 {2} 0 1.5708 0 0</pose><inertial><mass>1</mass><inertia><ixx>0.0026</ixx>'
    '<iyy>0.0026</iyy><izz>0.005</izz></inertia></inertial><visual name="v"><geometry><cylinder><radius>0.1</radius>'
    '<length>0.04</length></cylinder></geometry></visual></link><joint name="{1}_joint" type="revolute">'
    "<parent>hull</parent><child>{1}</child><axis><xyz>0 0 -1</xyz></axis></joint>"
)
VEHICLE = (
    '<sdf version="1.9"><model name="m"><link name="hull"><collision name="c"><geometry><box><size>1 0.6 0.6</size>'
    f"</box></geometry></collision></link>{WHEEL.format('«link»', 'left', 0.4)}{WHEEL.format('link', 'right', -0.4)}"
    '<plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive">'
    "<left_joint>left_joint</left_joint><right_joint>right_joint</right_joint></plugin></model></sdf>"
)

PAIRS = (
    '<robot name="r"><group name="all"><joint name="j0"/></group>'
    '<{} link1="base" link2="arm" reason="Adjacent"/></robot>'
)


class MissingCollision(Rule):
    """A link that moves has a visual and no collision, and its counterparts have one, or a drive or MoveIt needs one.

    It passes through everything. The counterparts are the links of the same name on the other sides (`left_wheel`
    and `right_wheel`, `FL_hip` and `RR_hip`), or all others of the robot that move, at least five. A drive turns wheels
    without collisions in the air: the robot falls through the floor, or lies on it. MoveIt compares collisions alone:
    a robot without any goes through itself and through everything else, and its setup assistant finds no pairs. A whole
    robot without any, of three links or more that move and have mass, is for information elsewhere.
    """

    code = "GEO008"
    name = "missing-collision"
    severity = Severity.WARNING
    remedy = """Give the link a collision: the shape of its visual, or a simple one around it.

    A cylinder or box of the outer measures is faster than the mesh and mostly better in contact. Where the
    link is meant to touch nothing, say so by a comment that ignores this finding.
    """
    looks_at = (Model, Semantics)
    needs = ("<joint", "<disable_collisions")

    bad = (
        Bad(
            robot("base visual collision", "left_wheel visual collision", "!right_wheel visual"),
            says="link `right_wheel` moves and has no collision, unlike `left_wheel`",
        ),
        Bad(
            robot("base visual", *(f"{name} visual collision" for name in "abcde"), "!tip visual"),
            says="link `tip` moves and has no collision, unlike all other links that move",
        ),
        Bad(
            VEHICLE,
            says="link `left` is a wheel of drive `gz::sim::systems::DiffDrive` and has no collision, nor has any",
        ),
        Bad(
            PAIRS.format("«disable_collisions»"),
            file="r.srdf",
            files={"r.urdf": robot("base visual", "arm visual")},
            says="no link of robot `r` has a collision, so MoveIt lets it go through everything",
        ),
        Bad(
            robot("base", "a visual", "b visual", "c visual")
            .replace('<robot name="r">', '<«robot» name="r">')
            .replace("</link>", f"{MASS}</link>"),
            also=("INR005",),
            says="none of the 3 links that move has a collision, nor has any other of robot `r`",
        ),
    )
    good = (
        Good(
            PAIRS.format("disable_collisions"),
            file="r.srdf",
            files={"r.urdf": robot("base visual collision", "arm visual")},
            why="the other may be meant",
        ),
        Good(
            robot("base visual collision", "left_wheel visual", "right_wheel visual"), why="neither of them"
        ),
        Good(
            robot("base visual", *(f"{name} visual collision" for name in "abcde"), "tip"),
            why="nothing to see",
        ),
        Good(
            robot("base visual", *(f"{name} visual collision" for name in "abcde"), "tip visual").replace(
                'name="tip">', 'name="tip"><!--collision><geometry/></collision-->'
            ),
            why="it is switched off",
        ),
        Good(
            robot("base visual collision", "left_wheel visual collision", "right_wheel visual").replace(
                "</robot>", '<gazebo reference="right_wheel"><gravity>0</gravity></gazebo></robot>'
            ),
            why="without weight it is only there to be seen",
        ),
        Good(
            robot("base visual", *(f"{name} visual collision" for name in "abcde"), "tip visual").replace(
                "</robot>",
                f'<link name="hand">{BOX.format("collision")}</link><joint name="hold" type="fixed">'
                '<parent link="tip"/><child link="hand"/></joint></robot>',
            ),
            why="a link that is fixed to it collides",
        ),
        Good(
            robot("base visual collision", "left_wheel visual collision", "right_wheel visual").replace(
                "</link><link", f"{MASS}</link><link", 2
            ),
            why="massless-moving-link reports that it has no mass either",
        ),
        Good(
            robot(
                "palm",
                *(f"finger_1_{n} visual" for n in "12"),
                *(f"finger_2_{n} visual collision" for n in "12"),
            ),
            why="neither of the first parts of the fingers has one",
        ),
    )

    @staticmethod
    def applies(part: Model | Semantics) -> bool:
        if isinstance(part, Model):
            return bool(lacking(part)) or bool(wheels(part)) or bool(untouched(part))
        return part.element.has("disable_collisions") and part.bare_robot is not None

    def check(self, part: Model | Semantics) -> Iterator[Diagnostic]:
        if isinstance(part, Semantics):
            first, robot = next(part.element.children("disable_collisions")), part.bare_robot
            assert robot is not None
            message = f"no link of {robot.title} has a collision, so MoveIt lets it go through everything"
            yield self.diagnostic(first, message)
            return
        yield from self._of(part)

    def _of(self, model: Model) -> Iterator[Diagnostic]:
        bare = untouched(model)
        if bare and not wheels(model):
            message = (
                f"none of the {len(bare)} links that move has a collision, nor has any other of {model.title}"
            )
            yield self.diagnostic(model, message, severity=Severity.INFO)
        for link, title in wheels(model):
            message = f"{link.title} is a wheel of {title} and has no collision, nor has any of its others"
            yield self.diagnostic(link, message)
        for link, counterpart in lacking(model):
            unlike = "all other links that move" if counterpart is None else f"`{counterpart.name}`"
            labels = {} if counterpart is None else {counterpart: "has one"}
            message = f"{link.title} moves and has no collision, unlike {unlike}"
            yield self.diagnostic(link, message, labels=labels)


def wheels(model: Model) -> list[tuple[Link, str]]:
    """The first wheel of each drive none of whose wheels collides, with the drive."""
    found = []
    for drive in (each for plugin in model.plugins for each in plugin.drives):
        links = [wheel.joint.child_link for wheel in drive.wheels]
        own = [link for link in links if link is not None and link.model is model and not touches(link)]
        if len(own) == len(links) and own[0].has("visual") and own[0].has_mass:
            found.append((own[0], drive.title))
    return found[:1]


def untouched(model: Model) -> list[Link]:
    """The links that move, with mass and a visual, where none of the robot collides."""
    if len(model.joints) < FEW or any(link.has("collision") for link in model.links) or model.may_be_static:
        return []
    moving = [link for link in model.links if link.has("visual") and moves(link) and link.has_mass]
    return moving if len(moving) >= FEW and not any(map(touches, moving)) else []


def touches(link: Link) -> bool:
    """Has a link a collision, or one that is tied to it, or one that is switched off or misspelled?"""
    return any(
        (
            link.has("collision"),
            link.misnamed("collision"),
            link.switches_off("collision"),
            is_covered(link),
        )
    )


def lacking(model: Model) -> list[tuple[Link, Link | None]]:
    """The links without collision, each with a counterpart that has one; None for all others."""
    if not model.joints or all(link.has("collision") or not link.has("visual") for link in model.links):
        return []
    if model.may_be_static:
        return []
    moving = [link for link in model.links if link.has("visual") and moves(link)]
    bare = [link for link in moving if not (link.has("collision") or link.misnamed("collision"))]
    bare = [link for link in bare if not is_weightless(link)]
    if any(link.has_mass for link in moving):
        bare = [link for link in bare if link.has_mass]  # else that is the mistake
    found: list[tuple[Link, Link | None]] = []
    for link in bare:
        alike = [other for other in link.counterparts or numbered(link) if other in moving]
        complete = [other for other in alike if other.has("collision")]
        if len(complete) * 2 > len(alike):
            found.append((link, complete[0]))
        elif not alike and len(bare) == 1 and len(moving) > LEAST and not is_exempt(link, moving):
            found.append((link, None))
    return found


def is_covered(link: Link) -> bool:
    """Does a link collide that is tied to it from below?"""
    tied, waiting = {link}, [link]
    while waiting:
        for joint in waiting.pop().child_joints:
            child = joint.child_link
            if joint.is_fixed and child is not None and child not in tied:
                if child.has("collision"):
                    return True
                tied.add(child)
                waiting.append(child)
    return False


def is_weightless(link: Link) -> bool:
    """Does gravity not pull it?"""
    own = link.find("gravity")
    blocks = link.model.blocks_by_reference.get(link.name, ()) if link.is_urdf else ()
    said = (
        [own.content]
        if own is not None
        else [value.text for each in blocks for value in each.settings("gravity")]
    )
    return any(text.strip().lower() in OFF for text in said)


def numbered(link: Link) -> list[Link]:
    """The other links of its name with another number (`rotor_0`); none where that is just a chain of links."""
    key, own = NUMBER.sub("", link.name), NUMBER.findall(link.name)
    if key == link.name or CHAIN.fullmatch(key):
        return []
    alike = [other for other in link.model.links if NUMBER.sub("", other.name) == key]
    return [
        other
        for other in alike
        if sum(map(ne, own, NUMBER.findall(other.name))) == 1  # of `finger_1_2` not `finger_2_1`
    ]


def is_exempt(link: Link, others: list[Link]) -> bool:
    """Is the collision in a comment or in a link that is tied to it, or is it short, like parts inside of joints?

    A link is short that is less than half as long as most others.
    """
    from statistics import median

    if link.switches_off("collision") or is_covered(link):
        return True
    own = link.visual_box
    lengths = [
        max(box.size) for other in others if other is not link and (box := other.visual_box) is not None
    ]
    return own is not None and bool(lengths) and max(own.size) < median(lengths) / 2


def moves(link: Link) -> bool:
    """Does a joint that is not fixed carry it?"""
    return any(joint.moves for joint in link.parent_joints)
