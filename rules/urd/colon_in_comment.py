import re
from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Good, Part, Root, Rule, Severity, Span, TextEdit, make_fix

QUICK = re.compile(r"<!--(?:(?!-->)[^:])*(?::|\Z)")
DIRECTIVE = "sdfcheck:"
CUSTOMARY = ("base_link", "base_footprint")
"""Names that users of ROS write; in a project of Python alone others do as well."""
OF_ROS = (
    "package://",
    "$(find ",
    "ros_control",
    "ros2_control",
    "libgazebo_ros",
)
"""Only users of ROS write these."""
COLON = re.compile(r":(?=\s)")


class ColonInComment(Rule):
    """A comment holds a colon with a space after it.

    A ROS 2 launch file that passes the description on as a parameter, and does not say that
    it is text, has it read as YAML. There such a colon begins a mapping: the launch fails
    with `mapping values are not allowed here`, and nothing points to the comment. In a file
    that describes no robot of its own, in one that shows nothing of ROS, in a package of ROS 1, and where the launch
    files of the project say that it is text, this is a hint.
    """

    code = "URD015"
    name = "colon-in-comment"
    severity = Severity.WARNING
    remedy = """Write a dash for the colon, or no space after it.

    In the launch file, `ParameterValue(Command(["xacro ", path]), value_type=str)` keeps ROS from taking
    the text for YAML; then colons are free.
    """
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
        Bad("<!-- sdfcheck«:» ignore[XML] -->", says="a colon in a comment for sdfcheck"),
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
        prose = [colon for colon in found if not is_directive(colon)]
        silencing = [colon for colon in found if is_directive(colon)]
        is_harmless = not is_description(root) or root.is_launched_as_text
        severity = Severity.INFO if is_harmless else None
        if prose:
            fix = make_fix("write a dash", tuple(TextEdit(colon, " -") for colon in prose))
            yield self.diagnostic(prose[0], _message(prose, ""), fix=fix, severity=severity)
        if silencing:
            advice = f"write `{DIRECTIVE}` without a space after it"
            text = _message(silencing, " for sdfcheck")
            yield self.diagnostic(silencing[0], text, help=advice, severity=severity)


def _message(found: list[Span], whose: str) -> str:
    one = len(found) == 1
    what = f"a colon in a comment{whose} breaks" if one else f"{len(found)} colons in comments{whose} break"
    return f"{what} launch files that read the description as YAML"


def is_description(root: Part) -> bool:
    """Is it a whole robot, not a part of others, for ROS?"""
    text, children = root.document.source.text, {child.name for child in root.children()}
    has_joints = "joint" in children or any(name.startswith("xacro:") for name in children)
    if not root.element.attributes.get("name") or not has_joints:
        return False
    if any(mark in text for mark in OF_ROS):
        return True
    return any(name in text for name in CUSTOMARY) and not root.root.is_of_python


def colons(root: Root) -> list[Span]:
    """All of them: a fix of one has to be a fix of all."""
    source = root.document.source
    return [
        source.span(*match.span())
        for start, end in root.document.scan.comments
        for match in COLON.finditer(source.text, start + 4, end - 3)
    ]


def is_directive(colon: Span) -> bool:
    """Is it in a comment that silences something?"""
    text = colon.source.text
    start = text.rfind("<!--", 0, colon.start)
    return DIRECTIVE in text[start : text.find("-->", colon.end)]
