from collections.abc import Iterator
from math import log10

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Good, Limit, Rule, Severity, TextEdit, make_fix

LEAST, MOST = 20.0, 5000.0
"""Numbers from here to there are usual limits in millimeters. More is a way to write no limit, as are powers of ten."""
TIMES = 100.0
"""Of the length of the two links: a rail is shorter than that, unless it is drawn."""
SLIDE = (
    '<link name="slide"><visual><geometry><box size="0.1 0.1 0.1"/></geometry></visual></link>'
    '<joint name="j" type="prismatic"><parent link="base"/><child link="slide"/><axis xyz="0 0 1"/>{}</joint>'
)


class LimitsInMillimeters(Rule):
    """The limits of a joint that slides are as one would write them in millimeters.

    Both formats measure lengths in meters: a gripper from 0 to 40 opens by forty meters. The way of such a joint is
    more than a hundred times as long as both of its links. Links that nobody sees do not count: they are the way of a
    base in its world.
    """

    code = "JNT029"
    name = "limits-in-millimeters"
    severity = Severity.WARNING
    remedy = """Write the limits in meters: millimeters divided by 1000.

    `velocity` of the same joint is in m/s, too.
    """
    looks_at = (Limit,)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            SLIDE.format('<limit lower="0" upper="«800»" effort="5" velocity="1"/>'),
            fixed=SLIDE.format('<limit lower="0" upper="0.8" effort="5" velocity="1"/>'),
            unsafe=True,
            says="joint `j` slides over 800 m, and its links are 0.1 m long",
        ),
    )
    good = (
        Good(SLIDE.format('<limit lower="0" upper="8" effort="5" velocity="1"/>')),
        Good(
            SLIDE.format('<limit lower="-1000" upper="1000" effort="5" velocity="1"/>'),
            why="written for no limit",
        ),
        Good(
            SLIDE.replace("visual>", "collision>").format(
                '<limit lower="-50" upper="50" effort="5" velocity="1"/>'
            ),
            why="the link of a base that moves in a plane",
        ),
        Good(
            '<link name="y"/><joint name="x" type="prismatic"><parent link="base"/><child link="y"/>'
            '<axis xyz="1 0 0"/><limit lower="-200" upper="200" effort="5" velocity="1"/></joint>'
            + SLIDE.replace('parent link="base"', 'parent link="y"').format(
                '<limit lower="-200" upper="200" effort="5" velocity="1"/>'
            ),
            why="the ways of a body in its world",
        ),
    )

    @staticmethod
    def applies(limit: Limit) -> bool:
        if limit.joint.type != "prismatic" or not limit.upper.is_given or limit.axis.limit is not limit:
            return False
        return is_long(limit) and 0 < TIMES * length(limit) < limit.upper.number - limit.lower.number

    def check(self, limit: Limit) -> Iterator[Diagnostic]:
        given = [end for end in (limit.lower, limit.upper) if end.is_given and end.number]
        edits = tuple(TextEdit(end.span, f"{end / 1000:.8g}") for end in given)
        way = limit.upper.number - limit.lower.number
        yield self.diagnostic(
            max(given, key=abs),
            f"{limit.joint.title} slides over {way:.4g} m, and its links are {length(limit):.2g} m long:"
            " are the limits in millimeters?",
            fix=make_fix("convert them from millimeters", edits, unsafe=True),
        )


def is_long(limit: Limit) -> bool:
    """Are the limits as usual in millimeters, and no powers of ten?"""
    ends = [abs(end.number) for end in (limit.lower, limit.upper) if end.number]
    return bool(ends) and LEAST <= max(ends) <= MOST and any(log10(end) % 1 for end in ends)


def length(limit: Limit) -> float:
    """The greatest length (m) of the two links of its joint that are seen; 0 where it is not known.

    Also where it carries a link that is not seen, or hangs on one that another joint carries: that is a way of a base.
    """
    child, parent = limit.joint.child_link, limit.joint.parent_link
    if child is None or parent is None or not child.visuals or (parent.parent_joints and not parent.visuals):
        return 0.0
    extents = [link.extent for link in (child, parent) if link.visuals]
    return max((max(box.size) for box in extents if box is not None), default=0.0)
