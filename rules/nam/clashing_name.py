from collections.abc import Iterator

from sdfcheck import (
    IN_LINK,
    IN_MODEL,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Name,
    Root,
    Rule,
    Severity,
    accepts,
    named,
    refuses,
)
from sdfcheck_rules.nam.taken import is_free, is_reserved

SHOWN = 3
"""Other names that a message lists, and labels mark."""
BOX = "<geometry><box><size>1 1 1</size></box></geometry>"
ASIDE = {
    Consumer.GAZEBO: refuses("its checker refuses the file; simulators read it"),
    Consumer.DRAKE: accepts("takes both"),
}


class ClashingName(Rule):
    """Siblings of different kinds have the same name.

    Links, joints, frames and nested models are frames to each other and share one name
    space, so a clash is refused; in files up to version 1.6 libsdformat renames the later
    one, and references mean the earlier; `gz sdf --check` complains. In URDF joints and links have names of their own,
    until libsdformat makes SDFormat of it: even a fixed joint, which it merges away, leaves
    a frame of its name. A visual and a collision do no harm by one name, but the
    specification wants siblings to differ and `gz sdf --check` says so.
    """

    code = "NAM002"
    name = "clashing-name"
    severity = Severity.ERROR
    remedy = """Rename the later one, with a suffix that says what it is: `_joint`, `_frame`, `_visual`.

    Links, joints, frames and nested models share one space of names, so `arm` and `arm_joint` live in
    peace. Change the references, too: before 1.7 they meant the first of the two.
    """
    looks_at = (Root,)
    scaffold = IN_MODEL

    bad = (
        Bad('<frame name="«base»"/>', says="frame `base` has the name of a link in model `m`"),
        Bad(
            f'<visual name="v">{BOX}</visual><collision name="«v»">{BOX}</collision>',
            scaffold=IN_LINK,
            says="collision `v` has the name of a visual in link `base`",
        ),
        Bad(
            '<sdf version="1.6"><model name="m"><link name="a"/><link name="b"/>'
            '<joint name="«a»" type="fixed"><parent>a</parent><child>b</child></joint></model></sdf>',
            scaffold="",
            says="so libsdformat renames it",
        ),
        Bad(
            '<robot name="r"><link name="a"/><link name="b"/><joint name="«b»" type="continuous">'
            '<parent link="a"/><child link="b"/></joint></robot>',
            scaffold="",
            says="joint `b` has the name of a link in robot `r`",
        ),
        Bad(
            '<robot name="r"><link name="a"/><link name="b"/><link name="c"/>'
            '<joint name="«b»" type="fixed"><parent link="a"/><child link="b"/></joint>'
            '<joint name="c" type="fixed"><parent link="a"/><child link="c"/></joint></robot>',
            scaffold="",
            says="joint `b` has the name of a link in robot `r`, and so has `c`",
        ),
    )
    good = (
        Good(
            '<link name="arm"><sensor name="arm" type="imu"/></link>', why="parent and child may share a name"
        ),
        Good('<plugin name="base" filename="p"/>', why="the names of plugins are free"),
        Good(
            '<robot name="r"><link name="world"/><link name="a"/><joint name="base" type="floating">'
            '<parent link="world"/><child link="a"/></joint>'
            '<gazebo><frame name="base" attached_to="__model__"/></gazebo></robot>',
            scaffold="",
            why="libsdformat drops a floating joint, so its name is free",
        ),
        Good(
            '<robot name="r"><link name="world"/><link name="a"/><joint name="world" type="fixed">'
            '<parent link="world"/><child link="a"/></joint></robot>',
            scaffold="",
            why="reserved-name owns this one",
        ),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return any(True for _ in clashes(root))

    def check(self, root: Root) -> Iterator[Diagnostic]:
        alike: dict[tuple[object, ...], list[tuple[Name, Name]]] = {}
        for first, later in clashes(root):
            key = first.kind, later.kind, later.parent, first.makes_frame, later.makes_frame, later.is_merged
            alike.setdefault(key, []).append((first, later))
        for (first, later), *others in alike.values():
            is_custom = ":" in first.kind or ":" in later.kind
            makes_frame = (first.makes_frame or later.makes_frame) and not is_custom
            # A merged include comes from a time in which nothing is renamed.
            is_renamed = first.makes_frame and later.makes_frame and not later.is_merged
            is_renamed = is_renamed and root.is_older_than("1.7")
            message = f"{later.kind} `{later.name}` has the name of a {first.kind} in {later.parent.title}"
            if others:
                names = named((later.name for _, later in others), most=SHOWN)
                message += f", and so {'have' if len(others) > 1 else 'has'} {names}"
            affects = {} if makes_frame else ASIDE
            if is_renamed:
                affects = {Consumer.GAZEBO: refuses("its checker refuses the file; simulators rename it")}
                message += ", so libsdformat renames it"
            yield self.diagnostic(
                later.value,
                message,
                labels={first.value: f"the {first.kind}"}
                | {each.value: "the same" for _, each in others[:SHOWN]},
                severity=None if makes_frame and not is_renamed else Severity.WARNING,
                affects=affects,
            )


def clashes(root: Root) -> Iterator[tuple[Name, Name]]:
    """Names of two kinds of things, each with the earlier one that it clashes with."""
    for first, later in root.names.shared:
        if first.kind != later.kind and not is_free(first, later, root) and not is_reserved(later, root):
            yield first, later
