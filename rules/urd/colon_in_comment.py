import re
from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Edit, Good, Root, Rule, Severity, Span, make_fix

QUICK = re.compile(r"<!--(?:(?!-->)[^:])*(?::|\Z)")
OF_ROS = (
    "base_link",
    "base_footprint",
    "package://",
    "$(find ",
    "ros_control",
    "ros2_control",
    "libgazebo_ros",
)
"""Customary names and things that only users of ROS write."""
COLON = re.compile(r":(?=\s)")


class ColonInComment(Rule):
    """A comment holds a colon with a space after it.

    A ROS 2 launch file that passes the description on as a parameter, and does not say
    that it is text, has it read as YAML. There such a colon begins a mapping: the launch
    fails with `mapping values are not allowed here`, and nothing points to the comment.
    The fix on the other side is `ParameterValue(…, value_type=str)`. In a file that describes no robot of its own, and
    in one that shows nothing of ROS, this is a hint.
    """

    code = "URD015"
    name = "colon-in-comment"
    severity = Severity.WARNING
    looks_at = (Root,)
    scaffold = IN_ROBOT

    bad = (
        Bad("<!-- author«:» me -->", fixed="<!-- author - me -->", says="a colon in a comment"),
        Bad("<!-- note«:» -->", fixed="<!-- note - -->"),
        Bad(
            "<!-- author«:» me --><!-- a:b -->\n<!-- to do:\n  a joint -->",
            fixed="<!-- author - me --><!-- a:b -->\n<!-- to do -\n  a joint -->",
            says="2 colons in comments",
        ),
    )
    good = (
        Good("<!-- see https://example.org/a:b -->", why="no space after"),
        Good('<link name="x"/><!-- no -->'),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return root.is_urdf and QUICK.search(root.document.source.text) is not None and bool(colons(root))

    def check(self, root: Root) -> Iterator[Diagnostic]:
        found = colons(root)
        what = "a colon in a comment breaks" if len(found) == 1 else f"{len(found)} colons in comments break"
        message = f"{what} launch files that read the description as YAML"
        fix = make_fix("write a dash", tuple(Edit(colon, " -") for colon in found))
        severity = None if is_description(root) else Severity.INFO
        yield self.diagnostic(found[0], message, fix=fix, severity=severity)


def is_description(root: Root) -> bool:
    """Is it a whole robot, not a part of others, for ROS?"""
    text, children = root.document.source.text, {child.name for child in root.children()}
    has_joints = "joint" in children or any(name.startswith("xacro:") for name in children)
    return bool(root.element.attributes.get("name")) and has_joints and any(mark in text for mark in OF_ROS)


def colons(root: Root) -> list[Span]:
    """All of them: a fix of one has to be a fix of all."""
    source = root.document.source
    return [
        source.span(*match.span())
        for start, end in root.document.scan.comments
        for match in COLON.finditer(source.text, start + 4, end - 3)
    ]
