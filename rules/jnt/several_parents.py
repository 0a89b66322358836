from collections.abc import Iterator

from sdfcheck import (
    IN_MODEL,
    IN_ROBOT,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Joint,
    Link,
    Root,
    Rule,
    Severity,
    accepts,
    drops,
    named,
    refuses,
    warns,
)

HUNG = {Consumer.PINOCCHIO: warns("hangs the link on the joint whose name comes last")}
HELD = {Consumer.DRAKE: accepts("holds the link, as nothing else joins its parents")}
ONE_WAY = {Consumer.DRAKE: refuses("cannot reverse joints of this type")}
ONE_WAY_TYPES = frozenset(("ball", "screw", "universal"))
LABELS = 10
"""So many places of one link are shown."""
DROPPED = {Consumer.GAZEBO: drops("the link, which has no mass")}


class SeveralParents(Rule):
    """A link is the child of more than one joint.

    A URDF robot is a tree: MuJoCo and libsdformat 17 refuse a link with two parents, and urdfdom
    hangs it on the joint whose name comes last. Pinocchio refuses it where it comes to the link before the parent of
    that joint. SDFormat allows it, and Gazebo closes the loop, but
    it is seldom meant: the solvers of kinematics want a tree. Drake refuses loops, whichever way their joints go, and
    takes two parents that nothing else joins, by joints that it can reverse: not balls, screws and universal ones.
    """

    code = "JNT007"
    name = "several-parents"
    severity = Severity.WARNING
    remedy = """Remove all but one of the joints, or give each a link of its own.

    A copy and paste that kept the old child is the common reason. A real closed chain (a four-bar linkage)
    does not fit a tree: cut it at one joint. In SDFormat Gazebo closes it by a second joint; for MuJoCo use
    an equality constraint, for Drake a `drake:ball_constraint`, and in URDF a `mimic` for a linkage that is
    near to a parallelogram.
    """
    looks_at = (Root,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            '<link name="arm"/><joint name="j" type="fixed"><parent>base</parent><child>arm</child></joint>'
            '<joint name="k" type="fixed"><parent>world</parent><child>«arm»</child></joint>',
            says="link `arm` is child of 2 joints: `j` and `k`",
        ),
        Bad(
            '<link name="arm"/><link name="top"/>'
            '<joint name="j" type="fixed"><parent link="base"/><child link="arm"/></joint>'
            '<joint name="t" type="fixed"><parent link="base"/><child link="top"/></joint>'
            '<joint name="k" type="fixed"><parent link="top"/><child link="«arm»"/></joint>',
            scaffold=IN_ROBOT,
            says="link `arm` is child of 2 joints: `j` and `k`",
        ),
    )
    good = (
        Good(
            '<link name="arm"/><link name="hand"/>'
            '<joint name="j" type="fixed"><parent>base</parent><child>arm</child></joint>'
            '<joint name="k" type="fixed"><parent>arm</parent><child>hand</child></joint>'
        ),
        Good(
            '<link name="arm"/>'
            '<joint name="j" type="revolute"><parent>base</parent><child>arm</child>'
            "<axis><xyz>0 0 1</xyz></axis></joint>"
            '<joint name="g" type="gearbox"><parent>base</parent><child>arm</child>'
            "<gearbox_reference_body>base</gearbox_reference_body><gearbox_ratio>2</gearbox_ratio>"
            "<axis><xyz>0 0 1</xyz></axis><axis2><xyz>0 0 1</xyz></axis2></joint>",
            why="a gearbox couples links that other joints carry",
        ),
        Good(
            '<link name="arm"/><joint name="j" type="fixed"><parent link="base"/><child link="arm"/></joint>',
            scaffold=IN_ROBOT,
        ),
        Good(
            '<link name="arm"/><joint name="j" type="fixed"><parent link="base"/><child link="arm"/></joint>'
            '<link name="arm"/><joint name="k" type="fixed"><parent link="base"/><child link="arm"/></joint>',
            scaffold=IN_ROBOT,
            why="duplicate-name owns this one: with another name for the second link both joints are right",
        ),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return any(True for _ in further_joints(root))

    def check(self, root: Root) -> Iterator[Diagnostic]:
        is_read, closed = is_in_order(root), looped(root)
        for link, joints, further in further_joints(root):
            names = named((each.name for each in joints), most=4)
            message = f"link `{link.name}` is child of {len(joints)} joints: {names}"
            affects = HUNG if link.is_urdf and is_read else {}
            if link.is_urdf and is_dropped(link, joints):
                affects = affects | DROPPED
            if link not in closed:
                affects = affects | (
                    ONE_WAY if any(joint.type in ONE_WAY_TYPES for joint in further) else HELD
                )
            labels = {joints[0].child_value or joints[0]: "first a child here"}
            labels |= {joint.child_value or joint: "and here" for joint in further[1:LABELS]}
            place, severity = further[0].child_value or further[0], Severity.ERROR if link.is_urdf else None
            is_twice = sum(each.name == further[0].name for each in joints) > 1
            name = further[0].element.attribute("name") if is_twice else None
            cause = None if name is None else name.span
            yield self.diagnostic(
                place, message, labels=labels, severity=severity, affects=affects, cause=cause
            )


def further_joints(root: Root) -> Iterator[tuple[Link, list[Joint], list[Joint]]]:
    """A link with all joints that carry it, and those after the first of them; where no name is given again."""
    doubled = {later.name for first, later in root.names.shared if first.kind == later.kind == "link"}
    for link, joints in root.parent_joints.items():
        further = [joint for joint in joints[1:] if not joint.is_urdf or joint.name != joints[0].name]
        if further and link.name not in doubled:
            yield link, joints, further


def looped(root: Root) -> set[Link]:
    """The links that close a loop by one of several joints that carry them, whichever way the others go."""
    groups: dict[object, object] = {}
    found = set()
    for link, joints in sorted(root.parent_joints.items(), key=lambda item: len(item[1])):
        for joint in joints:
            start = first_of(joint.parent_link or joint.parent_name or joint, groups)
            end = first_of(link, groups)
            if start == end:
                found.add(link)
            else:
                groups[end] = start
    return found


def first_of(part: object, groups: dict[object, object]) -> object:
    """The part for all that are joined with one; the way to it is made shorter."""
    while part in groups:
        groups[part] = groups.get(groups[part], groups[part])
        part = groups[part]
    return part


def is_dropped(link: Link, joints: list[Joint]) -> bool:
    """Does libsdformat leave out the link, which has no mass and moves, before it meets the other joint?"""
    last = max(joints, key=lambda joint: joint.name)
    return last.moves and not link.has_mass and not any(joint.is_fixed for joint in link.child_joints)


def is_in_order(root: Root) -> bool:
    """Does Pinocchio meet the parent of each link before it, on its way down by the names of joints?"""
    last: dict[Link, Joint] = {}
    below: dict[Link | None, list[Joint]] = {}
    for link, joints in root.parent_joints.items():
        last[link] = max(joints, key=lambda joint: joint.name)
        for joint in joints:
            below.setdefault(joint.parent_link, []).append(joint)
    waiting: list[Link | None] = [link for link in below if link is not None and link not in last]
    met: set[Link | None] = set()
    while waiting:
        at = waiting.pop()
        if at is None or at in met:
            continue
        if at in last and last[at].parent_link not in met:
            return False
        met.add(at)
        children = sorted(below.get(at, ()), key=lambda joint: joint.name, reverse=True)
        waiting += [joint.child_link for joint in children]
    return True
